// SPDX-License-Identifier: MIT
// Mends lines at forks, where one of three lines beside each other ends. Otherwise a fork leaves a white spot.
#pragma once

#include "hatching/lines.h"

#include <array>

namespace hrbfnpr::hatching {

// A place on a neighbouring line, between two of its points.
struct Neighbour {
    std::int32_t from = -1, to = -1; // -1 if there is no neighbouring line
    float share = 0.0F;              // the position between the two points: 0 at `from`, 1 at `to`
    float gap = 0.0F;                // the distance to the neighbouring line, in separations
    float sense = 0.0F;              // 1 if the neighbouring line's `across` points to the same side, else -1
};

// The neighbours of each point: first on the side opposite to its `across` direction, then on the side of this
// direction.
using LineNeighbours = base::Array<std::array<Neighbour, 2>>;

// Returns for each line whether it is a stray: a line shorter than `shortest`, from border to border, that is not a
// separation away from the lines beside it. Strays occur at cracks of the mesh.
[[nodiscard]] base::Array<std::uint8_t> find_strays(const base::Work& work, const Lines& lines,
                                                    const LineNeighbours& neighbours, double shortest);

// Returns the lines, except strays, with their open ends continued in the middle between the neighbouring lines, up to
// the place where these have come closer together. Two ends that face each other are continued by less than half of the
// way between them. `neighbours` are those of the points of `lines`. Points are `even_step` separations apart.
[[nodiscard]] Lines continue_into_forks(const base::Work& work, const Lines& lines, const LineNeighbours& neighbours,
                                        const base::Array<std::uint8_t>& stray, double separation);

} // namespace hrbfnpr::hatching
