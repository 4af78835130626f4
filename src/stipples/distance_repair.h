// SPDX-License-Identifier: MIT
// Marks that came to rest nearer to each other than their order says.
#pragma once

#include "stipples/blue_noise.h"

namespace hrbfnpr::stipples {

// Where the surface bends within the spacing of marks, they may come to rest beside each other.  Of two that are nearer
// than all others the later one is dropped, and counted as strayed.  `wandered`: marks, in ascending order, that are
// not where they were chosen.
void repair_distances(const marks::Site& site, const base::Array<std::int64_t>& wandered, EvenMarks& marks,
                      marks::LevelReport& report);

} // namespace hrbfnpr::stipples
