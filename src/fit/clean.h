// SPDX-License-Identifier: MIT
// Finds what is wrong with measured samples, and repairs what the caller wants repaired.
#pragma once

#include "fit/fit.h"
#include "fit/samples.h"

namespace hrbfnpr::fit {

struct Cleaning {
    std::int64_t near_duplicates = 0; // merged into others
    std::int64_t outliers_found = 0;
    std::int64_t outliers_dropped = 0;
    std::int64_t flipped_found = 0;
    std::int64_t flipped_repaired = 0;
};

// Sets of fewer samples are left alone: there are no statistics of a few.
inline constexpr std::int64_t fewest_to_clean = 33;

// Merges near duplicates, and keeps, drops or turns what find_suspects() finds.
[[nodiscard]] Cleaning clean(const base::Work& work, Samples& samples, Repair outliers, Repair flipped_normals);

} // namespace hrbfnpr::fit
