// SPDX-License-Identifier: MIT
// Finds faults in measured samples, and repairs the kinds of faults that the caller chooses.
#pragma once

#include "base/work.h"
#include "fit/fit.h"
#include "fit/samples.h"

namespace hrbfnpr::fit {

struct Cleaning {
    std::int64_t near_duplicates = 0; // the number of samples merged into other samples
    std::int64_t outliers_found = 0;
    std::int64_t outliers_dropped = 0;
    std::int64_t flipped_found = 0;
    std::int64_t flipped_repaired = 0;
};

// Smaller sets of samples are not cleaned, because their statistics mean nothing.
inline constexpr std::int64_t fewest_to_clean = 33;

// Merges near duplicates. Keeps, drops or turns the samples that find_suspects() finds.
[[nodiscard]] Cleaning clean(const base::Work& work, Samples& samples, Repair outliers, Repair flipped_normals);

} // namespace hrbfnpr::fit
