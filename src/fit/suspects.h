// SPDX-License-Identifier: MIT
// Samples that do not fit to those around them.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "fit/samples.h"
#include "geometry/neighbours.h"

namespace hrbfnpr::fit {

struct Suspects {
    explicit Suspects(base::Memory& memory) noexcept : outlier(memory), flipped(memory) {}

    base::Array<std::uint8_t> outlier; // of each sample, 1 if it is one
    base::Array<std::uint8_t> flipped; // ... whose normal is against its neighbours'; not of outliers
};

// neighbours: some 16 of each sample.
[[nodiscard]] Suspects find_suspects(const base::Work& work, const Samples& samples,
                                     const geometry::Neighbours& neighbours);

} // namespace hrbfnpr::fit
