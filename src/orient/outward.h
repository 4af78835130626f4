// SPDX-License-Identifier: MIT
// Finds which side of a cloud is outside. The winding number of a closed surface is 0 outside and 1 inside.
#pragma once

#include "orient/cloud.h"

namespace hrbfnpr::orient {

struct MeanWinding {
    // The mean |winding number| at places a short way along the normals. It is 0 if the normals point out of a closed
    // surface.
    double along = 0.5;
    double against = 0.5; // the mean |winding number| at places a short way in the opposite direction

    [[nodiscard]] bool closed() const noexcept;
    // Returns whether the surface is closed, with the wider limit that is used for the few hundred first places of a
    // cloud of curves.
    [[nodiscard]] bool nearly_closed() const noexcept;
    // Returns 1 if the normals point outward, -1 if they point inward, and 0 if both sides look the same.
    [[nodiscard]] int outward() const noexcept;
};

// Measures winding numbers. Each place is a dipole whose strength is its area (Barill and others, "Fast winding numbers
// for soups and clouds", 2018).
[[nodiscard]] MeanWinding measure_winding(const base::Work& work, const geometry::PointTree& tree,
                                          const NeighbourLists& near, const geometry::VecArray& normal);

// The values equal the HRBFNPR_OUTWARD_ constants of hrbfnpr.h.
enum class OutwardBy : std::uint32_t { inside = 0, up = 1, viewpoint = 2, as_given = 3 };

struct OutwardRule {
    glm::dvec3 up{0.0, 0.0, 1.0};
    glm::dvec3 viewpoint{0.0}; // in the coordinates of the cloud
    bool has_viewpoint = false;
};

struct OutwardResult {
    bool closed = false;
    OutwardBy decided_by = OutwardBy::inside;
};

// Turns all normals outward by winding numbers. Where winding numbers do not show which side is outside, `rule`
// decides.
[[nodiscard]] OutwardResult turn_outward(const base::Work& work, const Cloud& cloud, const NeighbourLists& near,
                                         const OutwardRule& rule, geometry::VecArray& normal);

} // namespace hrbfnpr::orient
