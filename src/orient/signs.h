// SPDX-License-Identifier: MIT
// Solves for signs: it chooses for each direction one of its two senses, so that the total energy is low.
//
// It joins places into clusters along the strongest couplings of the energy. Then it turns whole clusters, from coarse
// to fine, and single places, if that lowers the energy.
#pragma once

#include "base/work.h"
#include "fit/hermite_energy.h"
#include "orient/cloud.h"

namespace hrbfnpr::orient {

using Signs = base::Array<std::int8_t>; // 1 or -1 for each place

[[nodiscard]] Signs all_positive(base::Memory& memory, std::int64_t size);

// Gives directions the signs of least energy. For a large cloud, the search starts from patches of neighbours.
void find_signs(const base::Work& work, const OrderedPoints& places, const NeighbourLists& near,
                const fit::HermiteEnergy& energy, geometry::VecArray& normal);

} // namespace hrbfnpr::orient
