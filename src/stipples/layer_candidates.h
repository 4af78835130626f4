// SPDX-License-Identifier: MIT
// Candidates where a surface is not flat to its cells: points of a layer of constant thickness, taken down to it.
#pragma once

#include "stipples/plane_candidates.h"

namespace hrbfnpr::stipples {

// A point on the surface, to second order, and the cell that it is in.
struct Projection {
    std::int32_t cell; // number in SurfaceCells::cell
    std::uint32_t ticket;
    glm::vec3 position; // relative to the grid's origin
    float normal;       // packed
    bool bent;          // perhaps not yet on the surface
};

// Points are drawn uniformly in the volume of the cells and kept within `band` of the surface: a
// layer of constant thickness holds as many points per area everywhere, to second order in
// band * curvature.  One Newton step takes them down to the surface.
//
// Beside a crease the layer is cut off on one side, and on the other one it has a wedge more.  Points of the wedge,
// whose projection belongs to another sheet, do not count, and those whose mirror image is cut off count twice; what
// is put beside a projection and over the crease is thrown back from there.
class LayerCandidates {
public:
    // In all cells that are not `flat`.  `wanted`: of the whole surface.
    LayerCandidates(const marks::Site& site, const SurfaceCells& cells, const CellMap& numbers,
                    const base::Array<CellKind>& kind, std::uint32_t stream, std::int64_t wanted);

    // An estimate before the first are drawn, and a better one after that.
    [[nodiscard]] double area() const noexcept;
    // Draws more, until there are about that many per area; each time others.
    void draw(double density, const base::Progress& progress);

    [[nodiscard]] const base::Array<Projection>& projections() const noexcept { return projections_; }
    // Projections that were not in the region or its cells.
    [[nodiscard]] std::int64_t strayed() const noexcept { return strayed_; }

private:
    void find_trial_cells();
    [[nodiscard]] const SurfaceCell& trial_cell(std::int64_t i) const noexcept { return cells_.cell[trial_cell_[i]]; }
    [[nodiscard]] std::uint32_t count_in(const SurfaceCell& cell, double per_cell) const noexcept;
    void draw_in(const SurfaceCell& cell, std::int64_t at, std::int64_t end) noexcept;
    void draw_batch(std::int64_t cell_begin, std::int64_t cell_end);
    void step_down(const base::Progress& progress);
    bool many_are_off(std::int64_t first, const base::Progress& progress);
    void step_down_again(std::int64_t first, const base::Progress& progress);
    [[nodiscard]] std::int32_t cell_of(const glm::dvec3& p) const noexcept;
    [[nodiscard]] bool surprises(const glm::dvec3& p, double distance) const noexcept;
    Projection* land(std::int64_t i, double distance, std::uint32_t count, Projection* to,
                     std::int64_t& strayed) const noexcept;
    void count_projections(const base::Progress& progress);
    [[nodiscard]] bool turns_back(Projection& projection, const glm::dvec3& place, double distance,
                                  const glm::dvec3& normal, bool first) const noexcept;

    const marks::Site& site_;
    const SurfaceCells& cells_;
    const CellMap& numbers_;
    const base::Array<CellKind>& kind_;
    std::uint32_t stream_;
    std::int64_t projections_of_point_;
    std::uint32_t rounds_ = 0;
    std::uint32_t stream_of_round_ = 0;
    base::Array<std::int32_t> trial_cell_; // all from which a projection may be in a cell that is bent
    base::Array<std::int64_t> slot_;       // of the first trial of each cell of the batch
    geometry::VecArray drawn_;             // a slot for each trial; NaN: not worth evaluating
    base::Array<std::uint32_t> drawn_ticket_;
    geometry::VecArray trial_;
    base::Array<std::uint32_t> trial_ticket_;
    marks::FieldSamples field_, beside_;
    base::Array<std::uint8_t> times_; // how often each trial counts, where there are creases
    base::Array<std::int64_t> kept_, near_of_task_, strayed_of_task_;
    base::Array<std::int64_t> bent_;
    bool all_bent_ = false;
    base::Array<Projection> landed_;
    base::Array<Projection> projections_;
    double trials_ = 0.0;
    std::int64_t near_ = 0; // projections of all trials within the band
    std::int64_t strayed_ = 0;
};

} // namespace hrbfnpr::stipples
