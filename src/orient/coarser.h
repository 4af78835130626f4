// SPDX-License-Identifier: MIT
// Normals to begin with, from coarser clouds to finer ones: of points along curves neighbours tell no plane, but the
// first of the farthest-first order stand all over the surface.
#pragma once

#include "orient/cloud.h"
#include "orient/least_energy.h"

#include <vector>

namespace hrbfnpr::orient {

// The first places of a cloud's farthest-first order, as many as asked for, in an order of their own.
struct First {
    First(const base::Runtime& runtime, const Cloud& cloud, std::int64_t count, const base::Progress& progress);

    // Of the whole cloud's, unit or not.
    [[nodiscard]] geometry::VecArray pick(const geometry::VecArray& normal) const;

    std::unique_ptr<geometry::PointTree> tree;
    base::Array<std::int64_t> rank;
    base::Array<std::int64_t> place; // in the whole cloud
};

// As many as stand all over the surface that the cloud's curves lie on: 64 to 127, or all of fewer.
[[nodiscard]] std::int64_t coarsest_of(std::int64_t count) noexcept;

// Whether it is points along curves, and enough of them for that to matter.
[[nodiscard]] bool is_of_curves(const Cloud& cloud);

// The normals of least energy of the coarsest, then of twice as many, each time begun from those before: one for each.
// Of points without noise the energy falls; interpolated noise has the more the nearer points are to each other.
// `most`: points of the finest.
[[nodiscard]] std::vector<Begin> begin_from_coarser(const base::Runtime& runtime, const Cloud& cloud, std::int64_t most,
                                                    const base::Progress& progress);

} // namespace hrbfnpr::orient
