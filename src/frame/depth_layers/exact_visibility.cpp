// SPDX-License-Identifier: MIT
#include "frame/depth_layers/exact_visibility.h"

#include "base/operation.h"
#include "frame/scene/splat_law.h"

#include <glm/matrix.hpp>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t rays_at_a_time = 16384;
constexpr std::int32_t most_layers = 8;
// Rays start this many pixels off the mark's own layer, on its outer side.
constexpr double off_layer = 0.5;

} // namespace

// From the mark to the eye, in the model's space.
void ExactVisibility::add_ray(const Scene& scene, const Run& run, const Dot& ink) {
    const ItemView& item = scene.item_of(run);
    const std::int64_t mark = ink.id - run.first_id;
    const glm::dmat3 to_eye(item.to_eye);
    const glm::dmat3 back = glm::inverse(to_eye);
    const double pixel =
        1.0 / (static_cast<double>(ink.pixels_per_unit) * std::cbrt(std::abs(glm::determinant(to_eye))));
    const glm::dvec3 from =
        glm::dvec3(run.place_of(mark, item.unit)) + off_layer * pixel * glm::dvec3(run.normal_of(mark));
    const glm::dvec3 centre(scene.lens.centre);
    const bool parallel = scene.lens.centre.w == 0.0F;
    // The direction's length does not matter where lines of sight are parallel: rays end with the model's bounds.
    const glm::dvec3 to = parallel ? from - back * centre : back * (centre - glm::dvec3(item.eye_offset));
    rays_.origin.push_back(item.unit * from + item.origin);
    rays_.direction.push_back(item.unit * (to - from));
}

void ExactVisibility::ask(const base::Runtime& runtime, const Scene& scene, std::int32_t item, std::span<Dot> inks) {
    if (asked_.empty()) return;
    const ItemView& view = scene.items[item];
    surface::RaySettings settings;
    settings.maximum_hits = most_layers;
    if (scene.lens.centre.w != 0.0F) settings.t_max = 1.0; // at the eye
    surface::cast_rays(runtime, *view.model, settings, rays_, hits_, {});
    for (std::int64_t i = 0; i < asked_.size(); ++i) {
        const glm::dvec3 sight = rays_.direction[i] / -view.unit;
        for (std::int32_t hit = 0; hit < hits_.count[i]; ++hit) {
            const glm::dvec3 n = hits_.normal[i * most_layers + hit];
            const double nu = glm::dot(n, sight) / glm::length(sight);
            inks[asked_[i]].opacity *= layer_transmittance(view.style, static_cast<float>(nu), view.both_sides);
        }
    }
    rays_.origin.clear();
    rays_.direction.clear();
    asked_.clear();
}

std::int64_t ExactVisibility::attenuate(const base::Runtime& runtime, const Scene& scene, std::span<Dot> inks,
                                        std::span<const Piece> pieces) {
    rays_.origin.clear(); // what a failed frame left
    rays_.direction.clear();
    asked_.clear();
    std::int64_t hidden = 0; // of those that are asked for, all but the ones that stay
    std::int32_t item = -1;
    for (const Piece& piece : pieces) {
        for (std::int64_t i = piece.begin; i < piece.end; ++i) {
            const Dot& ink = inks[static_cast<std::size_t>(i)];
            const Run& run = scene.runs[ink.layer / 2];
            if (run.item != item || asked_.size() == rays_at_a_time) ask(runtime, scene, item, inks);
            item = run.item;
            if (scene.item_of(run).model == nullptr || !(ink.opacity > 0.0F)) continue;
            add_ray(scene, run, ink);
            asked_.push_back(static_cast<std::uint32_t>(i));
            ++hidden;
        }
    }
    ask(runtime, scene, item, inks);
    for (const Piece& piece : pieces) {
        for (std::int64_t i = piece.begin; i < piece.end; ++i) {
            Dot& ink = inks[static_cast<std::size_t>(i)];
            if (scene.item_of(scene.runs[ink.layer / 2]).model == nullptr) continue;
            if (ink.opacity >= faintest_ink)
                --hidden;
            else
                ink.opacity = 0.0F;
        }
    }
    return hidden;
}

} // namespace hrbfnpr::frame
