// SPDX-License-Identifier: MIT
// A stage of the progressive order: the number of marks grows fourfold, the reach of their energies stays.
#pragma once

#include "stipples/cell_map.h"
#include "stipples/progressive_order.h"

#include <memory>
#include <span>

namespace hrbfnpr::stipples {

struct StageSettings {
    std::int32_t level = 0;         // cells have the candidates' cells' side times 2^level ...
    double reach = 0.0;             // ... which is at least this: how far a mark's energy reaches
    std::uint64_t ticket_limit = 0; // candidates with smaller tickets take part
    double nearness = 0.8;          // part of the radius from which on a candidate may move into its gap
    double farthest_move = 0.0;     // less than half a side
};

struct SweepStep {
    double radius;
    float threshold;
};

class OrderStage {
public:
    // `home`: cells of `home_level` that marks must stay in.  `marks`: all so far.
    OrderStage(const marks::Site& site, Candidates& candidates, const CellMap& home, std::int32_t home_level,
               const StageSettings& settings, const OrderedMarks& marks, const base::Progress& progress);
    ~OrderStage();

    // One after the other, tile by tile: places marks that keep the radius from all others at energies below the
    // threshold, lowest first in each tile, and at most a few in each tile.  They are appended tile by tile; of more
    // than `room` the lowest remain, and then the stage is over.
    void sweep(std::span<const SweepStep> steps, std::int64_t room, OrderedMarks& marks);
    // Of the marks of the last sweep: in which of its steps they were placed.
    [[nodiscard]] const base::Array<std::uint8_t>& steps() const noexcept;
    // The lowest energy of a candidate that keeps the distance of the last step; infinite: there is none.
    [[nodiscard]] float lowest();
    // Forgets the candidates that are nearer than that to a mark: radii will be larger.
    void drop_nearer(double distance);

private:
    class Impl;
    std::unique_ptr<Impl> impl_;
};

} // namespace hrbfnpr::stipples
