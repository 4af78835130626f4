// SPDX-License-Identifier: MIT
// The first half of a frame by layers: makes ink and splats from clusters of marks.                       [NPAR 6, 6.2]
//
// gather: Scene -> dots, splats and counts of a drawing; it also finds how items are seen, for hatching
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "frame/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::frame {

// ---- How much ink a tone takes

// How the marks of an item lie.
enum class Overlap : unsigned char {
    random,     // anywhere: coverage = 1 - exp(-x)
    blue_noise, // apart from each other, as measured
    lines       // evenly spaced lines in some layers
};

// The ink per area that makes the discs of a blue-noise order cover 0, 1/16, 2/16 and so on to all of the area.
// Measured on a flat patch, over prefixes of 5 to 100 % and radii of 1 to 3 pixels (docs/measurements.md).
inline constexpr std::array<float, 17> blue_noise_ink = {0.0F,    0.0625F, 0.1250F, 0.1875F, 0.2500F, 0.3125F,
                                                         0.3755F, 0.4400F, 0.5068F, 0.5772F, 0.6528F, 0.7362F,
                                                         0.8318F, 0.9479F, 1.1005F, 1.3370F, 3.0000F};

// Returns the ink per area that gives a coverage. Discs that overlap count twice. At a coverage of 1 the result is
// large. `layers` is the number of layers of lines that lie over each other.
[[nodiscard]] inline float ink_for(float coverage, Overlap overlap, float layers) noexcept {
    HRBFNPR_ASSERT(coverage >= 0.0F && coverage <= 1.0F && (overlap != Overlap::lines || layers >= 1.0F));
    const float left = std::max(1.0F - coverage, 1e-4F);
    if (overlap == Overlap::random) return -std::log(left);
    if (overlap == Overlap::lines) {
        if (layers == 1.0F) return coverage;
        const float root = layers == 2.0F   ? std::sqrt(left)
                           : layers == 3.0F ? std::cbrt(left)
                                            : std::pow(left, 1.0F / layers);
        return layers * (1.0F - root);
    }
    const float at = coverage * 16.0F;
    const auto cell = static_cast<std::size_t>(std::min(at, 15.0F));
    return blue_noise_ink[cell] + (blue_noise_ink[cell + 1] - blue_noise_ink[cell]) * (at - static_cast<float>(cell));
}

// The ink per area of an item's image if all marks of the item are shown.
struct ItemInk {
    struct Term {
        const DiscSizes* discs = nullptr;
        float marks_per_area = 0.0F; // marks per square eye unit
        float step = 0.0F;           // distance of marks along a stroke, eye units; 0: the marks form no strokes
    };
    std::int64_t first = 0, end = 0; // the range of its terms in Gathering::terms
    // ink_for() of each coverage k / needed_steps, so that a mark need not take a root
    std::array<float, needed_steps + 1> needed{};
};

// ---- What gather() makes

// The share of the ink behind a layer that the layer lets through, by |nu|.
struct TransmittanceTable {
    static constexpr std::size_t steps = 256;
    std::array<float, steps + 1> front, back;
    float halo;

    [[nodiscard]] float at(float nu) const noexcept {
        const auto step = static_cast<std::size_t>(std::min(std::abs(nu), 1.0F) * steps + 0.5F);
        return nu > 0.0F ? back[step] : front[step];
    }
};

// Consecutive clusters of a run, the work of one task.
struct GatherTask {
    std::int64_t run, begin, end;
};

// The results and scratch of gather(). Arrays are kept from frame to frame.
struct Gathering {
    explicit Gathering(base::Memory& memory) noexcept
        : sights(memory), tau(memory), inks(memory), terms(memory), transmittances(memory), transmittance_of(memory),
          tasks(memory), counts(memory), tone_calls(memory) {}

    Frustum frustum;
    base::Array<ItemSight> sights; // one for each item
    base::Array<float> tau;        // the tones that a callback gives, for each place in clusters' blocks

    // Scratch.
    base::Array<ItemInk> inks;                      // one for each item
    base::Array<ItemInk::Term> terms;               // the terms of all items, item after item
    base::Array<TransmittanceTable> transmittances; // consecutive items that are alike share one
    base::Array<std::int32_t> transmittance_of;     // the number of each item's table in `transmittances`
    base::Array<GatherTask> tasks;
    base::Array<Counts> counts; // one for each task
    ToneCalls tone_calls;

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return sights.bytes() + tau.bytes() + inks.bytes() + terms.bytes() + transmittances.bytes() +
               transmittance_of.bytes() + tasks.bytes() + counts.bytes() + tone_calls.bytes();
    }
};

// Fills the drawing's dots, splats and counts. Throws Error{callback, out_of_memory}.
void gather(const base::Runtime& runtime, const Scene& scene, Gathering& gathering, drawing::Drawing& drawing);

} // namespace hrbfnpr::frame
