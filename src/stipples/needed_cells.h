// SPDX-License-Identifier: MIT
// The parts of a surface where a still picture needs marks, and how many.
//
// Each stage of the progressive order places four times as many marks as all stages before it, in cells half as wide.
// Where a picture needs only the first marks of the order, later stages place no marks and draw no candidates.
//
//   needed_shares      marks::Need → for each cell of the surface, the share of the order that is needed there
//   largest_around     the largest share of a cell and its neighbours, so that stages have a margin
//   OrderStages        the number of marks and the side of the cells of each stage
//   candidate_shares   the share of the candidates of each cell that the stages need
#pragma once

#include "stipples/surface_cells.h"

#include <cmath>

namespace hrbfnpr::stipples {

// Returns the distance between neighbours in the densest packing of `marks` marks.
[[nodiscard]] inline double densest_distance(double area, double marks) noexcept {
    return std::sqrt(2.0 / std::sqrt(3.0) * area / marks);
}

// The stages of an order. The cells of a stage have a level: their side is that of the surface's cells times 2^level.
struct OrderStages {
    double area; // the area of the surface
    double side; // the side of the surface's cells
    std::int64_t wanted;

    [[nodiscard]] double side_of(std::int32_t level) const noexcept { return std::ldexp(side, level); }
    // Returns the distance up to which a mark has energy at the end of a stage with this number of marks.
    [[nodiscard]] double reach(double marks) const noexcept;
    [[nodiscard]] std::int32_t last_level() const noexcept;  // the level of the last stage, whose cells are smallest
    [[nodiscard]] std::int32_t first_level() const noexcept; // the level of the first stage
    // Returns the number of marks at the end of a stage.
    [[nodiscard]] std::int64_t marks_at_end(std::int32_t level) const noexcept;
    // Returns the number of candidates that a stage uses, if there are `all` candidates.
    [[nodiscard]] static double candidates_of(std::int64_t marks_at_end, double all) noexcept;
};

// Returns for each cell the share of an order of `wanted` marks that `need` asks for. It is the largest share of the
// cell and the cells around it, whose normals may differ.
[[nodiscard]] base::Array<float> needed_shares(const marks::Site& site, const SurfaceCells& cells,
                                               const marks::Need& need, std::int64_t wanted);

// Returns for each cell the largest of the values of the cell itself and its neighbours. `numbers` has the cells'
// codes.
[[nodiscard]] base::Array<float> largest_around(const base::Work& work, const base::Array<std::uint64_t>& code,
                                                const CellMap& numbers, const base::Array<float>& value);

// Returns for each cell of the surface the share of its candidates that some stage may use. `share` has the result of
// needed_shares(), `candidates` is the number of candidates on the whole surface. No share is below `least_share`.
[[nodiscard]] base::Array<float> candidate_shares(const base::Work& work, const SurfaceCells& cells,
                                                  const base::Array<float>& share, const OrderStages& stages,
                                                  double candidates, double least_share);

} // namespace hrbfnpr::stipples
