// SPDX-License-Identifier: MIT
// The first half of a drawing by depth layers: makes ink and splats from clusters of marks.              [NPAR 6, 6.2]
//
// gather: Scene -> dots, splats and counts of a drawing. Hatching also uses the resulting views of items.
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "frame/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::frame {

// ---- The ink that a tone needs

// How the marks of an item overlap.
enum class Overlap : unsigned char {
    random,     // at random: coverage = 1 - exp(-x)
    blue_noise, // apart from each other: coverage as in blue_noise_ink
    lines       // evenly spaced lines in some layers
};

// The ink per area at which the discs of a blue-noise order cover 0, 1/16, 2/16 and so on of the area. Measured on a
// flat patch, for the first 5 to 100 % of the marks and radii of 1 to 3 pixels (docs/measurements.md).
inline constexpr std::array<float, 17> blue_noise_ink = {0.0F,    0.0625F, 0.1250F, 0.1875F, 0.2500F, 0.3125F,
                                                         0.3755F, 0.4400F, 0.5068F, 0.5772F, 0.6528F, 0.7362F,
                                                         0.8318F, 0.9479F, 1.1005F, 1.3370F, 3.0000F};

// Returns the ink per area that gives a coverage. Where discs overlap, the ink counts twice. For a coverage of 1 the
// result is large. `layers` is the number of layers of lines on top of each other.
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
        float marks_per_area = 0.0F; // the number of marks per square eye unit
        float step = 0.0F; // the distance of marks along a stroke, in eye units; 0 if the marks form no strokes
    };
    std::int64_t first = 0, end = 0; // The range of the item's terms in Gathering::terms.
    // ink_for() of each coverage k / needed_steps, so that no root is needed for each mark
    std::array<float, needed_steps + 1> needed{};
};

// ---- The results of gather()

// The transmittance of a layer for each |nu|: the share of the ink behind the layer that is still seen.
struct TransmittanceTable {
    static constexpr std::size_t steps = 256;
    std::array<float, steps + 1> front, back;
    float halo;

    [[nodiscard]] float at(float nu) const noexcept {
        const auto step = static_cast<std::size_t>(std::min(std::abs(nu), 1.0F) * steps + 0.5F);
        return nu > 0.0F ? back[step] : front[step];
    }
};

// Consecutive clusters of a run, which one task processes.
struct GatherTask {
    std::int64_t run, begin, end;
};

// The results and the working memory of gather(). The arrays are kept from frame to frame.
struct Gathering {
    explicit Gathering(base::Memory& memory) noexcept
        : sights(memory), tau(memory), inks(memory), terms(memory), transmittances(memory), transmittance_of(memory),
          tasks(memory), counts(memory), tone_calls(memory) {}

    Frustum frustum;
    base::Array<ItemSight> sights; // one element for each item
    base::Array<float> tau;        // the tones from callbacks, in the order of the places in the clusters' blocks

    // Working memory of gather().
    base::Array<ItemInk> inks;        // one element for each item
    base::Array<ItemInk::Term> terms; // the terms of all items, one item after the other
    // The tables of transmittance. Consecutive items of the same kind share a table.
    base::Array<TransmittanceTable> transmittances;
    base::Array<std::int32_t> transmittance_of; // for each item: the index of its table in `transmittances`
    base::Array<GatherTask> tasks;
    base::Array<Counts> counts; // one element for each task
    ToneCalls tone_calls;

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return sights.bytes() + tau.bytes() + inks.bytes() + terms.bytes() + transmittances.bytes() +
               transmittance_of.bytes() + tasks.bytes() + counts.bytes() + tone_calls.bytes();
    }
};

// Makes the drawing's dots, splats and counts. Throws Error{callback, out_of_memory}.
void gather(const base::Runtime& runtime, const Scene& scene, Gathering& gathering, drawing::Drawing& drawing);

} // namespace hrbfnpr::frame
