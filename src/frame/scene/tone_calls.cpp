// SPDX-License-Identifier: MIT
#include "frame/scene/tone_calls.h"

#include <cmath>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t call_size = 4096;

} // namespace

void ToneCalls::begin(const ItemView& item, base::Array<float>& out) noexcept {
    forget(); // what a failed frame left
    item_ = &item;
    out_ = &out;
}

void ToneCalls::add(const glm::vec3& own_position, const glm::vec3& own_normal, std::int64_t place) {
    const glm::vec3 position(item_->to_world * glm::dvec4(own_position, 1.0));
    const glm::vec3 normal = glm::normalize(item_->normal_to_world * own_normal);
    places_.push_back(place);
    for (int k = 0; k < 3; ++k) {
        positions_.push_back(position[k]);
        normals_.push_back(normal[k]);
    }
    if (places_.size() == call_size) call();
}

void ToneCalls::call() {
    const std::int64_t count = places_.size();
    if (count == 0) return;
    tau_.clear();
    tau_.resize(count);
    const std::int32_t result =
        item_->style.tone_function(item_->style.tone_user, count, positions_.data(), normals_.data(), tau_.data());
    if (result != 0)
        fail(Status::callback, "tone_function returned %d; it must return 0 unless it failed",
             static_cast<int>(result));
    for (std::int64_t i = 0; i < count; ++i) {
        if (std::isnan(tau_[i]))
            fail(Status::callback, "tone_function gave NaN as tau[%lld]; it must fill every element with a number",
                 static_cast<long long>(i));
        (*out_)[places_[i]] = std::clamp(tau_[i], 0.0F, 1.0F);
    }
    forget();
}

void ToneCalls::forget() noexcept {
    places_.clear();
    positions_.clear();
    normals_.clear();
}

} // namespace hrbfnpr::frame
