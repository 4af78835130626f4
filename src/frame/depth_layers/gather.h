// SPDX-License-Identifier: MIT
// The first half of a drawing by depth layers: makes ink and splats from clusters of marks.              [NPAR 6, 6.2]
//
// gather: Scene -> dots, splats and counts of a drawing. Hatching also uses the resulting views of items.
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "frame/depth_layers/even.h"
#include "frame/hatch/strokes.h"
#include "frame/scene/ink.h"
#include "frame/scene/scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::frame {

// ---- The ink of an item

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
          tasks(memory), counts(memory), tone_calls(memory), even(memory) {}

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
    // For each dot, if runs are even in the picture. Only elements of such runs have values.
    base::Array<EvenMark> even;
    std::array<float, needed_steps + 1> flat_places{}; // flat_place() of each |n . v| = k / needed_steps

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return sights.bytes() + tau.bytes() + inks.bytes() + terms.bytes() + transmittances.bytes() +
               transmittance_of.bytes() + tasks.bytes() + counts.bytes() + tone_calls.bytes() + even.bytes();
    }
};

// Makes the drawing's dots, splats and counts. `edges` are those of the drawn lines. If contours of an item are drawn
// as lines, only these lines have halos. Throws Error{callback, out_of_memory}.
void gather(const base::Runtime& runtime, const Scene& scene, const NearerEdges& edges, Gathering& gathering,
            drawing::Drawing& drawing);

} // namespace hrbfnpr::frame
