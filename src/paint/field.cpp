// SPDX-License-Identifier: MIT
#include "paint/field.h"

#include "base/status.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::paint {
namespace {

[[nodiscard]] bool is_finite(const glm::dvec3& v) noexcept {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

} // namespace

Sample Field::at(const Place& place) const noexcept {
    if (const auto* const triangles = std::get_if<TriangleValues>(&source_)) return triangles->at(place.position);
    if (const auto* const points = std::get_if<PointValues>(&source_)) return points->at(place.position);
    if (const auto* const dabs = std::get_if<Dabs>(&source_)) return dabs->at(place);
    return std::get_if<Projection>(&source_)->at(place);
}

Sample Field::finished(Sample sample) const noexcept {
    if (kind_ == FieldKind::colour) sample.value = glm::clamp(sample.value, 0.0, 1.0);
    if (kind_ == FieldKind::scalar && range_[0] != range_[1])
        sample.value.x = std::clamp((sample.value.x - range_[0]) / (range_[1] - range_[0]), 0.0, 1.0);
    // Squares of coordinates and the length of the range may overflow. Then the field says nothing.
    return sample.weight > 0.0 && is_finite(sample.value) ? sample : Sample{};
}

void Field::call_function(const PlaceFunction& function, std::int64_t count, Call& call) const {
    std::fill(call.value.begin(), call.value.end(), 0.0);
    std::fill(call.weight.begin(), call.weight.end(), 1.0);
    const std::int32_t code = function.function(function.user, count, call.position.data(), call.normal.data(),
                                                call.value.data(), call.weight.data());
    if (code != 0)
        fail(Status::callback, "the function of a field returned %d; it must return 0 unless it failed",
             static_cast<int>(code));
    for (std::int64_t i = 0; i < count; ++i) {
        const Sample sample = sample_of(call, i);
        if (!(sample.weight >= 0.0 && sample.weight <= 1.0))
            fail(Status::callback, "the function of a field gave the weight %g; weights must be from 0 to 1",
                 sample.weight);
        if (sample.weight > 0.0 && !is_finite(sample.value))
            fail(Status::callback,
                 "the function of a field gave a value that is not finite; give the weight 0 where there is no value");
    }
}

Sample Field::sample_of(const Call& call, std::int64_t i) const noexcept {
    Sample sample;
    for (int c = 0; c < components(); ++c) sample.value[c] = call.value[components() * i + c];
    sample.weight = call.weight[i];
    return sample;
}

} // namespace hrbfnpr::paint
