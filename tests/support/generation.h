// SPDX-License-Identifier: MIT
// Settings of point sets that own their layers, for tests and benchmarks.
#pragma once

#include "support/handles.h"

#include <cstdint>
#include <vector>

namespace hrbfnpr::test {

struct Generation : hrbfnpr_generate_desc {
    std::vector<hrbfnpr_layer_desc> layer;

    Generation() : hrbfnpr_generate_desc(made(hrbfnpr_generate_desc_init)) {}
    hrbfnpr_layer_desc& add(std::uint32_t kind, std::int64_t budget) {
        layer.push_back(made(hrbfnpr_layer_desc_init));
        layer.back().kind = kind;
        layer.back().budget = budget;
        return layer.back();
    }
    // Returns the descriptor for a call.
    const hrbfnpr_generate_desc* get() {
        layers = layer.data();
        layer_count = static_cast<std::int64_t>(layer.size());
        return this;
    }
};

// Settings with a single layer.
[[nodiscard]] inline Generation one_layer(std::uint32_t kind, std::int64_t budget) {
    Generation desc;
    desc.add(kind, budget);
    return desc;
}

// Settings with stipples, hatching by curvature and hatching by combing, each with this budget.
[[nodiscard]] inline Generation three_layers(std::int64_t budget) {
    Generation desc;
    desc.add(HRBFNPR_LAYER_KIND_STIPPLES, budget);
    desc.add(HRBFNPR_LAYER_KIND_HATCH, budget);
    desc.add(HRBFNPR_LAYER_KIND_HATCH, budget).guide = HRBFNPR_HATCH_GUIDE_COMBING;
    return desc;
}

} // namespace hrbfnpr::test
