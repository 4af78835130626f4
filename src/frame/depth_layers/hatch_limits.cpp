// SPDX-License-Identifier: MIT
#include "frame/depth_layers/hatch_limits.h"

#include "frame/scene/tone.h"

#include <cmath>
#include <limits>

namespace hrbfnpr::frame {
namespace {

// What is known of a mark beforehand holds up to rounding.
constexpr float smallest_darkness = 1e-4F;
constexpr float most_length = 1.01F; // of a unit normal

// Where n . l is larger than this, a place is less dark.  There is no fill light there.
[[nodiscard]] float lightest_of(float darkness, float exponent) noexcept {
    constexpr float any = std::numeric_limits<float>::infinity();
    const float tau = 1.0F - darkness + 2.0F * smallest_darkness;
    if (!(tau < 1.0F)) return any;
    const float lightest = tau > 0.0F ? std::pow(tau, 1.0F / exponent) : 0.0F;
    return 1.0F - light_tone(lightest, exponent) < darkness - smallest_darkness ? lightest : any;
}

} // namespace

HatchLimits::HatchLimits(const HatchLoops& loops, const Run& run, const ItemView& item, const ItemSight& sight,
                         bool by_light, float darkness) noexcept
    : loops_(loops), sight_(sight), normal_(run.normal), tone_normal_(run.normal),
      lightest_(std::numeric_limits<float>::infinity()), any_(sight.rigid && run.marks->stroke_order.empty()) {
    const bool posed = run.normal != run.marks->normal.data();
    if (!by_light || (posed && run.has_tone_normals())) return;
    if (run.has_tone_normals()) tone_normal_ = run.marks->tone_normal.data();
    lightest_ = lightest_of(darkness, static_cast<float>(item.style.tone_exponent));
}

// At a place p of the ball around c, e the eye, n . (p - e) >= n . (c - e) - |n| r:
// where that is positive it faces away.
std::uint32_t HatchLimits::may_draw(const marks::StrokePiece& piece) const noexcept {
    HatchBounds bounds{};
    const Seer& seer = sight_.seer;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto i = static_cast<int>(k);
        bounds.sight[k] = seer.parallel ? sight_.eye[i] : piece.centre[k] - sight_.eye[i];
        bounds.light[k] = sight_.seer.light[k];
    }
    bounds.away = seer.parallel ? 0.0F : most_length * piece.radius;
    bounds.lightest = lightest_;
    const std::int64_t first = 3 * std::int64_t{piece.first};
    return loops_.may_draw(bounds, normal_ + first, tone_normal_ + first, piece.count);
}

} // namespace hrbfnpr::frame
