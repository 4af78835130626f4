// From grown marks to the arrays of a point set.
#pragma once

#include "marks/marks.h"
#include "marks/point_set.h"
#include "marks/tone_part.h"

#include <array>
#include <span>

namespace hrbfnpr::marks {

// The u of [NPAR 6.2], independent for each mark.
[[nodiscard]] float random_rank(std::uint64_t random_seed, std::uint64_t key, Group group) noexcept;

// What to do with one group's marks.
struct AssembleSettings {
    Group group = Group::stipple;
    bool with_curvature = false;
    // In the order of their ranks: a stipple's is its place in the array, a stroke's its number.
    bool progressive = false;
    std::int64_t strokes = 0;     // of the group, if progressive
    std::array<TonePart, 2> part; // of the two sets; the first one's for stipples
};

// Fills all of `result` but its report.  Positions become relative to `origin`.
void assemble(const Site& site, const Marks& marks, const AssembleSettings& settings, const glm::dvec3& origin,
              MarkGroup& result, const base::Progress& progress);

// Bounds, origin and spacing of a set from its groups' positions, before they are assembled.
// `area` 0: estimated from the positions of the largest group.
void measure(const base::Runtime& runtime, std::span<const geometry::VecArray* const> positions, double area,
             PointSet& set, const base::Progress& progress);

} // namespace hrbfnpr::marks
