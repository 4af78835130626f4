// SPDX-License-Identifier: MIT
// Refines coarse meshes by Loop's subdivision, with a surface that goes through the given vertices.
//
// C. Loop, "Smooth Subdivision Surfaces Based on Triangles", 1987; H. Hoppe et al., "Piecewise Smooth Surface
// Reconstruction", SIGGRAPH 1994, for borders, creases and corners; F. Cheng et al., "Loop Subdivision Surface Based
// Progressive Interpolation", JCST 24(1), 2009, for going through the vertices.
//
// Vertices of a shape at the same place must be joined, because separate vertices move apart. If the shape knows its
// sharp edges, they stay sharp.
#pragma once

#include "base/operation.h"
#include "picture/shape.h"

namespace hrbfnpr::picture {

// Subdivides a mesh. Each round makes four times as many faces, which become round where the given faces are coarse.
// The given vertices come first and stay nearly where they were. Edges between faces that meet at more than
// `crease_angle` (degrees) stay sharp, and so do borders and edges of more than two faces. If the shape knows its sharp
// edges, bevelled parts stay sharp as well: most of their other edges lie between flat faces and narrow ones. Throws
// Error{invalid_argument} if there are no faces, or too many after the last round.
[[nodiscard]] Shape subdivide(const Shape& shape, std::int32_t rounds, double crease_angle, Pool& pool,
                              const base::Progress& progress = {});

struct DividedParts {
    Shape shape;
    Vector<std::int64_t> parents; // For each face: the index of the given face from which it was made.
};
// Divides only the coarse parts. A part is coarse if it has a smooth edge that bulges by more than `tolerance`, as a
// share of the diagonal.
[[nodiscard]] DividedParts subdivide_coarse_parts(const Shape& shape, std::int32_t rounds, double crease_angle,
                                                  double tolerance, Pool& pool, const base::Progress& progress = {});
// Returns the parents of the `finer` faces that subdivide() makes from `faces` faces.
[[nodiscard]] Vector<std::int64_t> parents_of(std::size_t faces, std::size_t finer, Pool& pool);

// Returns how far the faces are from a round surface, as a share of the diagonal. The result is the percentile
// `percent` of the bulges of all edges that are not sharp. The bulge of an edge is the angle between the normals of its
// two faces, times an eighth of their extent across the edge. For an equilateral face, the extent is the edge length.
// For a bevel beside a flat face, the extent is the width of the bevel, and does not depend on its length.
[[nodiscard]] double coarseness(const Shape& shape, double percent, Pool& pool);

// Returns for each place of a finer mesh its distance from the planes of its parent faces, as a share of the diagonal.
[[nodiscard]] Vector<double> raised(const Shape& shape, const Shape& finer, const Vector<std::int64_t>& parents,
                                    Pool& pool);

// Returns the mean length of the edges, as a share of the diagonal.
[[nodiscard]] double mean_edge(const Shape& shape, Pool& pool);

} // namespace hrbfnpr::picture
