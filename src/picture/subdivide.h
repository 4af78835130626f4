// SPDX-License-Identifier: MIT
// Finer meshes in place of coarse ones: Loop's subdivision through the vertices that are given.
//
// C. Loop, "Smooth Subdivision Surfaces Based on Triangles", 1987; H. Hoppe et al., "Piecewise Smooth Surface
// Reconstruction", SIGGRAPH 1994, for borders, creases and corners; F. Cheng et al., "Loop Subdivision Surface Based
// Progressive Interpolation", JCST 24(1), 2009, for going through the vertices.
//
// In this file a shape is a mesh whose vertices are joined: those at one place that are not joined come apart.  Its
// sharp edges, where it knows any, stay sharp.
#pragma once

#include "base/operation.h"
#include "picture/shape.h"

namespace hrbfnpr::picture {

// Makes four times as many faces in each round, which are round where the given ones are coarse.  The given vertices
// come first, nearly where they were.
// crease_angle: degrees.  Edges between faces that meet at more stay sharp, and so do borders and edges of more than
// two faces.  If the shape knows its sharp edges, bevelled parts stay sharp as well: those of which most other edges
// lie between flat faces and narrow ones. Throws Error{invalid_argument} without faces, and with too many after the
// last round.
[[nodiscard]] Shape subdivide(const Shape& shape, std::int32_t rounds, double crease_angle, Pool& pool,
                              const base::Progress& progress = {});

struct DividedParts {
    Shape shape;
    Vector<std::int64_t> parents; // the given face that each face is a part of
};
// Divides only the coarse parts: those with a smooth edge that bulges by more than a share of the diagonal.
[[nodiscard]] DividedParts subdivide_coarse_parts(const Shape& shape, std::int32_t rounds, double crease_angle,
                                                  double tolerance, Pool& pool, const base::Progress& progress = {});
// The parents of all faces of what subdivide() makes of `faces` faces.
[[nodiscard]] Vector<std::int64_t> parents_of(std::size_t faces, std::size_t finer, Pool& pool);

// How far faces are off something round, as a share of the diagonal: this percentile of the edges is not more.  Edges
// that the shape says are sharp do not count.
// Two faces bulge by the angle between their normals, times an eighth of what they measure across their edge.  Beside a
// flat face that is the width of a bevel, however long it is; an equilateral face measures an edge.
[[nodiscard]] double coarseness(const Shape& shape, double percent, Pool& pool);

// How far each place of a finer mesh lies off the planes of its parents, as a share of the diagonal.
[[nodiscard]] Vector<double> raised(const Shape& shape, const Shape& finer, const Vector<std::int64_t>& parents,
                                    Pool& pool);

// The mean length of an edge as a share of the diagonal.
[[nodiscard]] double mean_edge(const Shape& shape, Pool& pool);

} // namespace hrbfnpr::picture
