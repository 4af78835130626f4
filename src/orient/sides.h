// SPDX-License-Identifier: MIT
// Which side of a cloud is outside, by winding numbers: those of a closed surface are 0 outside and 1 inside.
#pragma once

#include "orient/directions.h"

namespace hrbfnpr::orient {

struct Sides {
    double along = 0.5; // mean |winding number| a little way along the normals: 0 if they point out of a closed surface
    double against = 0.5; // ... against them
    double volume = 0.0;  // signed, over area times the extent

    [[nodiscard]] bool closed() const noexcept;
    // As far as some hundred places tell.
    [[nodiscard]] bool nearly_closed() const noexcept;
    // 1: the normals point outward, -1: inward, 0: there is no telling.
    [[nodiscard]] int outward() const noexcept;
};

// Mean distance to some nearest neighbours: the square is what area a place stands for, but for a factor.
[[nodiscard]] base::Array<double> local_spacing(const base::Runtime& runtime, const geometry::PointTree& tree,
                                                const Near& near);

// Each place is a dipole as large as its area (Barill and others, "Fast winding numbers for soups and clouds", 2018).
// members: places that make up the surface; all if empty.
[[nodiscard]] Sides measure_sides(const base::Runtime& runtime, const geometry::PointTree& tree,
                                  const base::Array<double>& spacing, const geometry::VecArray& normal,
                                  std::span<const std::int32_t> members, const base::Progress& progress);

// Of the surface of these members, at a place.
[[nodiscard]] double winding_number_at(const geometry::PointTree& tree, const base::Array<double>& spacing,
                                       const geometry::VecArray& normal, std::span<const std::int32_t> members,
                                       const glm::dvec3& at) noexcept;

} // namespace hrbfnpr::orient
