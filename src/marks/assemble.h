// SPDX-License-Identifier: MIT
// Makes the arrays of a point set, from grown marks (measure, average_normals, assemble) or from the caller's arrays
// (from_arrays).
#pragma once

#include "base/view.h"
#include "marks/site.h"

#include <array>
#include <span>

namespace hrbfnpr::marks {

// Returns the random number u of [NPAR 6.2], which is independent for each mark.
[[nodiscard]] float random_rank(std::uint64_t random_seed, std::uint64_t key, Kind kind) noexcept;

// The settings for assembling one layer.
struct AssembleSettings {
    bool strokes = false;
    bool with_curvature = false;
    std::array<TonePart, 2> part; // the tone range of each of the two directions; stipples use the first
};

// Fills all members of `result` except its kind, name and report. Positions become relative to `origin`. Marks without
// ranks get ranks: by their order in the array if the layer is progressive, else at random.
void assemble(const Site& site, const Marks& marks, const AssembleSettings& settings, const glm::dvec3& origin,
              Layer& result);

// Computes the bounds, origin and spacing of a set from its layers' positions before the layers are assembled. If
// `area` is 0, it is estimated from the positions of the largest layer. `whole` is the number of marks that the largest
// layer has on the whole surface.
void measure(const base::Work& work, std::span<const geometry::VecArray* const> positions, double area,
             std::int64_t whole, PointSet& set);

// Statistics of the distances from each point to its nearest other point.
struct NeighbourDistances {
    double mean = 0.0;      // 0 if there are fewer than two distinct points
    double variation = 0.0; // standard deviation divided by the mean
};
[[nodiscard]] NeighbourDistances neighbour_distances(const base::Work& work, const geometry::VecArray& points);

// Returns the square root of the area per point, for marks on an unknown surface. The error is at most about 15 % if
// the marks cover the surface.
[[nodiscard]] double covered_spacing(const base::Work& work, const geometry::VecArray& points);

// Computes averaged normals for tone, so that the grain of a rough surface does not look like form. Marks are included
// if they are within twice the `length` (object units), on the same side of creases, and if their normals agree. Nearer
// marks have more weight. `spacing` is the square root of the area per mark. `result` gets 3 numbers for each mark.
void average_normals(const Site& site, const Marks& marks, double length, double spacing, base::Array<float>& result);

// ---- Ready-made marks

// The arrays of one layer. hrbfnpr_layer_arrays documents the meaning of an empty array.
struct LayerArrays {
    Kind kind = Kind::own;
    LayerName name{};
    base::InView position, normal, stroke_first, stroke_direction, direction, curvature, rank, level, width;
};

// Returns a set with the layers of `base`, if it is not null, followed by layers made from the arrays. The set has no
// clusters. Throws Error{invalid_argument} with a message that names layer, array and index.
[[nodiscard]] PointSet from_arrays(const base::Runtime& runtime, const PointSet* base,
                                   std::span<const LayerArrays> arrays, std::uint64_t random_seed);

} // namespace hrbfnpr::marks
