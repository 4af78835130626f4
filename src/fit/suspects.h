// SPDX-License-Identifier: MIT
// Finds outliers and flipped normals: samples that do not fit their neighbours.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "fit/samples.h"
#include "geometry/neighbours.h"

namespace hrbfnpr::fit {

struct Suspects {
    explicit Suspects(base::Memory& memory) noexcept : outlier(memory), flipped(memory) {}

    base::Array<std::uint8_t> outlier; // 1 if the sample is an outlier
    base::Array<std::uint8_t> flipped; // 1 if the normal is opposite to its neighbours' normals; 0 for outliers
};

// `neighbours` should hold about 16 neighbours per sample.
[[nodiscard]] Suspects find_suspects(const base::Work& work, const Samples& samples,
                                     const geometry::Neighbours& neighbours);

} // namespace hrbfnpr::fit
