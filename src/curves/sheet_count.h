// SPDX-License-Identifier: MIT
// How often the surface lies between two points: the quantitative invisibility of one seen from the other [Appel 1967].
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

// It is made once for a mesh, which must outlive it; const afterwards, for any number of threads.
class SheetCounter {
public:
    SheetCounter(const base::Work& work, const SurfaceMesh& mesh);

    struct Answer {
        std::int32_t sheets = 0;
        double nearest = 0.0; // about the distance from `to` to the nearest crossing, where there are any
        bool certain = true;  // false: the segment grazes the surface, or its two counts do not agree
    };
    // Counts the crossings of f = 0 with the open segments from[i] to to[i], as far as the mesh goes.  `to` may itself
    // lie on the surface: crossings nearer to it than clear[i] are not counted.  answer is resized.
    //
    // Triangles say where to look, and within these spans f and its slope along the segment decide; both are counted.
    // Beside an end of the segment f alone is asked: there the triangles are not near enough to the surface.
    void count(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& from,
               const geometry::VecArray& to, const base::Array<double>& clear, base::Array<Answer>& answer) const;

    [[nodiscard]] const SurfaceMesh& mesh() const noexcept { return mesh_; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return tree_.bytes() + bulge_.bytes(); }

private:
    const SurfaceMesh& mesh_;
    base::Array<double> bulge_; // how far the surface may be from each triangle, by the gradients at its corners
    geometry::BoxTree tree_;    // the boxes around the triangles with their bulges
};

} // namespace hrbfnpr::curves
