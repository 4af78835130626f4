// SPDX-License-Identifier: MIT
// Which side of a cloud is outside, by winding numbers: those of a closed surface are 0 outside and 1 inside.
#pragma once

#include "orient/cloud.h"

namespace hrbfnpr::orient {

struct Sides {
    // Mean |winding number| a little way along the normals: 0 if they point out of a closed surface.
    double along = 0.5;
    double against = 0.5; // the same against the normals

    [[nodiscard]] bool closed() const noexcept;
    // The same as far as some hundred places tell.
    [[nodiscard]] bool nearly_closed() const noexcept;
    // 1: the normals point outward, -1: inward, 0: both sides look the same.
    [[nodiscard]] int outward() const noexcept;
};

// Takes each place as a dipole as large as its area (Barill and others, "Fast winding numbers for soups and clouds",
// 2018).
[[nodiscard]] Sides measure_sides(const base::Work& work, const geometry::PointTree& tree, const Near& near,
                                  const geometry::VecArray& normal);

// The values equal those of the constants HRBFNPR_OUTWARD_ of hrbfnpr.h.
enum class OutwardBy : std::uint32_t { inside = 0, up = 1, viewpoint = 2, as_given = 3 };

struct OutwardRule {
    glm::dvec3 up{0.0, 0.0, 1.0};
    glm::dvec3 viewpoint{0.0}; // in the cloud's coordinates
    bool has_viewpoint = false;
};

struct Whole {
    bool closed = false;
    OutwardBy by = OutwardBy::inside;
};

// Turns all normals outward, as winding numbers tell, or else by the rule.
[[nodiscard]] Whole turn_outward(const base::Work& work, const Cloud& cloud, const Near& near, const OutwardRule& rule,
                                 geometry::VecArray& normal);

} // namespace hrbfnpr::orient
