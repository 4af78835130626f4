// SPDX-License-Identifier: MIT
// The sign of the whole, and of its pieces.
#pragma once

#include "orient/least_energy.h"
#include "orient/sides.h"

namespace hrbfnpr::orient {

// Same numbers as HRBFNPR_OUTWARD_...
enum class OutwardBy : std::uint32_t { inside = 0, up = 1, viewpoint = 2, as_given = 3 };

struct Outward {
    glm::dvec3 up{0.0, 0.0, 1.0};
    glm::dvec3 viewpoint{0.0}; // in the cloud's coordinates
    bool has_viewpoint = false;
};

struct Whole {
    bool closed = false;
    OutwardBy by = OutwardBy::inside;
};

// Places that neighbours lead from one to the other, largest pieces first.
[[nodiscard]] Groups find_pieces(const base::Runtime& runtime, const geometry::PointTree& tree, const Near& near);

// Turns closed pieces that the energy is indifferent to, and then everything, outward.
[[nodiscard]] Whole turn_outward(const base::Runtime& runtime, const Cloud& cloud, const Near& near,
                                 const Groups& pieces, const Outward& outward, const fit::HermiteEnergy* form,
                                 geometry::VecArray& normal, const base::Progress& progress);

} // namespace hrbfnpr::orient
