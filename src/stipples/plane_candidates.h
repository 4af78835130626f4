// SPDX-License-Identifier: MIT
// Candidates where a surface is flat to its cells: on the cells' planes, without a look at the function.
#pragma once

#include "stipples/candidates.h"
#include "stipples/cell_neighbours.h"

namespace hrbfnpr::stipples {

// What a cell's plane is good for.
enum class CellKind : std::uint8_t {
    clear, // it passes by
    flat,  // it is the surface
    bent   // its neighbours' planes say otherwise, or there is none
};

class PlaneCandidates {
public:
    PlaneCandidates(const marks::Site& site, const SurfaceCells& cells, const CellMap& numbers, std::uint32_t stream,
                    const base::Progress& progress = {});

    [[nodiscard]] const base::Array<CellKind>& kind() const noexcept { return kind_; }
    // Draws that many per area, in place of those drawn before, but no more trials than that for all cells together.
    void draw(double density, double most_trials = 1e300, const base::Progress& progress = {});
    [[nodiscard]] std::int64_t count() const noexcept { return all_; }
    // Of the planes inside flat cells and the region, as the candidates tell.
    [[nodiscard]] double area() const noexcept { return all_ > 0 ? static_cast<double>(all_) / density_ : 0.0; }
    [[nodiscard]] std::int64_t count_in(std::int64_t cell) const noexcept { return count_[cell]; }
    // Those of a cell, from that place on.
    void put(std::int64_t cell, std::int64_t to, Candidates& candidates) const noexcept;

private:
    struct Judged {
        CellKind kind;
        float curvature;
    };
    [[nodiscard]] Judged judge(const SurfaceCell& cell, CellNeighbours& around) const noexcept;
    [[nodiscard]] bool is_at_crease(const SurfaceCell& cell, const CellNeighbours& around) const noexcept;
    struct Trials;
    [[nodiscard]] Trials trials_in(const SurfaceCell& cell) const noexcept;
    template <class Visit>
    void for_points(const SurfaceCell& cell, Visit&& visit) const noexcept;

    const marks::Site& site_;
    const SurfaceCells& cells_;
    std::uint32_t stream_;
    base::Array<CellKind> kind_;
    base::Array<float> curvature_; // mean
    base::Array<std::int32_t> count_;
    double density_ = 0.0;
    double most_in_cell_ = 0.0; // trials
    std::int64_t all_ = 0;
};

} // namespace hrbfnpr::stipples
