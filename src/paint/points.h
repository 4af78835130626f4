// SPDX-License-Identifier: MIT
// Values at points, or at the corners of triangles.
#pragma once

#include "base/memory.h"
#include "base/work.h"
#include "geometry/bvh.h"
#include "geometry/point_tree.h"
#include "paint/kind.h"
#include "paint/sample.h"

namespace hrbfnpr::paint {

// A place has the value of the nearest point. If several points are equally near, the same one is taken for any number
// of threads.
class PointValues {
public:
    // `values` has components_of(kind) numbers for each point; there must be at least one point. A place that is
    // farther away than `reach` has no value.
    PointValues(const base::Work& work, const geometry::VecArray& points, FieldKind kind, base::Array<double>&& values,
                double reach);

    [[nodiscard]] Sample at(const glm::dvec3& place) const noexcept;

private:
    geometry::PointTree tree_;
    base::Array<double> values_;
    int components_;
    double reach_;
};

// A place has the value of the nearest place of the triangles, which is interpolated between the corners of its
// triangle. If several triangles are equally near, the one with the lowest index counts.
class TriangleValues {
public:
    using Triangle = geometry::Bvh::Triangle;
    // The indices of triangles must be valid. The other arguments are those of PointValues.
    TriangleValues(const base::Work& work, base::Array<glm::dvec3>&& points, base::Array<Triangle>&& triangles,
                   FieldKind kind, base::Array<double>&& values, double reach);

    [[nodiscard]] Sample at(const glm::dvec3& place) const noexcept;

private:
    base::Array<glm::dvec3> points_;
    base::Array<Triangle> triangles_;
    geometry::Bvh tree_;
    base::Array<double> values_;
    FieldKind kind_;
    double squared_reach_;
};

} // namespace hrbfnpr::paint
