// SPDX-License-Identifier: MIT
// From grown marks (measure, soften_normals, assemble) or from the caller's arrays (from_arrays) to the arrays of a
// point set.
#pragma once

#include "base/view.h"
#include "marks/site.h"

#include <array>
#include <span>

namespace hrbfnpr::marks {

// The u of [NPAR 6.2], which is independent for each mark.
[[nodiscard]] float random_rank(std::uint64_t random_seed, std::uint64_t key, Kind kind) noexcept;

// How one layer's marks are assembled.
struct AssembleSettings {
    bool strokes = false;
    bool with_curvature = false;
    std::array<TonePart, 2> part; // the part of the tones for each of the two directions; stipples use the first
};

// Fills all of `result` but its kind, name and report. Positions become relative to `origin`. Marks without ranks get
// those of their places in the array in a progressive layer, else random ones.
void assemble(const Site& site, const Marks& marks, const AssembleSettings& settings, const glm::dvec3& origin,
              Layer& result);

// Finds bounds, origin and spacing of a set from its layers' positions, before they are assembled.
// `area` 0: it is estimated from the positions of the largest layer.
void measure(const base::Work& work, std::span<const geometry::VecArray* const> positions, double area, PointSet& set);

// The distances from each point to its nearest other one.
struct NeighbourDistances {
    double mean = 0.0;      // 0 for fewer than two distinct points
    double variation = 0.0; // standard deviation over mean
};
[[nodiscard]] NeighbourDistances neighbour_distances(const base::Work& work, const geometry::VecArray& points);

// sqrt(area per point) of marks on an unknown surface, within about 15 % where the marks cover it.
[[nodiscard]] double covered_spacing(const base::Work& work, const geometry::VecArray& points);

// Normals that tone goes by: of a rough surface, averaged over some of it, so that its grain is no form. Averages over
// marks on the same side of creases whose normals agree, within twice the `length`, in object units; nearer ones count
// for more.  spacing: the root of the area for each mark.  result: 3 for each mark.
void soften_normals(const Site& site, const Marks& marks, double length, double spacing, base::Array<float>& result);

// ---- Ready-made marks

// The arrays of one layer; hrbfnpr_layer_arrays says what empty ones mean.
struct LayerArrays {
    Kind kind = Kind::own;
    LayerName name{};
    base::InView position, normal, stroke_first, stroke_direction, direction, curvature, rank, level, width;
};

// The layers of another set, if there is one, and those of the arrays, without clusters.
// Throws Error{invalid_argument} that names layer, array and index.
[[nodiscard]] PointSet from_arrays(const base::Runtime& runtime, const PointSet* base,
                                   std::span<const LayerArrays> arrays, std::uint64_t random_seed);

} // namespace hrbfnpr::marks
