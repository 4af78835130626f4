// SPDX-License-Identifier: MIT
// Counts how often the surface lies between two points. This is the quantitative invisibility of one point as seen from
// the other [Appel 1967].
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/work.h"
#include "curves/surface_mesh.h"
#include "geometry/box_tree.h"
#include "geometry/vec_array.h"
#include "implicit/implicit.h"

#include <cstdint>

namespace hrbfnpr::curves {

// The data for counting on a mesh. The mesh must outlive this object. The object never changes, so it is thread-safe.
class SheetCounter {
public:
    SheetCounter(const base::Work& work, const SurfaceMesh& mesh);

    struct Result {
        std::int32_t sheets = 0;
        double nearest = 0.0; // the approximate distance from `to` to the nearest crossing, if there is one
        bool certain = true;  // false if the segment grazes the surface, or if the two ways of counting disagree
    };
    // Counts the crossings of the open segments from[i] to to[i] with f = 0 inside the mesh. `to` may lie on the
    // surface: crossings closer to it than clear[i] are not counted. Resizes `answer`.
    //
    // Triangles give the spans of a segment in which crossings may lie. Crossings in the spans are counted in two ways:
    // by f and its slope along the segment, and by triangles. Near an end of the segment only f is used, because
    // triangles are not close enough to the surface there.
    void count(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& from,
               const geometry::VecArray& to, const base::Array<double>& clear, base::Array<Result>& answer) const;

    [[nodiscard]] const SurfaceMesh& mesh() const noexcept { return mesh_; }
    // Returns a box that contains the mesh and the surface near it.
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept { return tree_.bounds(); }
    [[nodiscard]] std::int64_t bytes() const noexcept { return tree_.bytes() + bulge_.bytes(); }

private:
    const SurfaceMesh& mesh_;
    // For each triangle: a bound for the distance of the surface, from the gradients at its corners.
    base::Array<double> bulge_;
    geometry::BoxTree tree_; // the boxes of the triangles, enlarged by their bulges
};

} // namespace hrbfnpr::curves
