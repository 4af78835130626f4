// SPDX-License-Identifier: MIT
// From grown marks to the arrays of a point set.
#pragma once

#include "marks/marks.h"
#include "marks/point_set.h"
#include "marks/tone_part.h"

#include <array>
#include <span>

namespace hrbfnpr::marks {

// The u of [NPAR 6.2], independent for each mark.
[[nodiscard]] float random_rank(std::uint64_t random_seed, std::uint64_t key, Kind kind) noexcept;

// What to do with one layer's marks.
struct AssembleSettings {
    bool strokes = false;
    bool with_curvature = false;
    std::array<TonePart, 2> part; // of the two directions; the first one's for stipples
};

// Fills all of `result` but its kind, name and report.  Positions become relative to `origin`.  Marks without ranks
// have those of their places in the array in a progressive layer, else random ones.
void assemble(const Site& site, const Marks& marks, const AssembleSettings& settings, const glm::dvec3& origin,
              Layer& result, const base::Progress& progress);

// Bounds, origin and spacing of a set from its layers' positions, before they are assembled.
// `area` 0: estimated from the positions of the largest layer.
void measure(const base::Runtime& runtime, std::span<const geometry::VecArray* const> positions, double area,
             PointSet& set, const base::Progress& progress);

} // namespace hrbfnpr::marks
