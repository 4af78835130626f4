// SPDX-License-Identifier: MIT
// Candidates of the progressive order: points near the surface, a few per mark, stored cell by cell; and the order.
//
// 1. classify_cells() finds where the planes of the cells match the surface: these cells are flat, the others bent.
// 2. draw_on_planes() puts candidates on the planes of flat cells, evenly and without an evaluation.
// 3. draw_in_layer() puts candidates in bent cells: it projects random points of a layer around the surface.
// 4. draw_candidates() does these in rounds until there are enough, and merges both in the order of cells.
#pragma once

#include "marks/site.h"
#include "stipples/order_loops.h"
#include "stipples/surface_cells.h"

#include <cmath>
#include <span>

namespace hrbfnpr::stipples {

// How a cell's plane can be used.
enum class CellKind : std::uint8_t {
    empty, // the plane does not pass through the cell
    flat,  // the plane matches the surface
    bent   // the planes of neighbours disagree, or the cell has no plane
};

struct ClassifiedCell {
    CellKind kind;
    float curvature; // mean; 0 if unknown
};

struct ClassifiedCells {
    explicit ClassifiedCells(const SurfaceCells& of) : cells(of), number(of), cell(of.cell.memory(), of.cell.size()) {}

    [[nodiscard]] CellKind kind(std::int64_t i) const noexcept {
        HRBFNPR_ASSERT(i >= 0 && i < cell.size());
        return cell[i].kind;
    }

    const SurfaceCells& cells;
    CellMap number; // gives the number of a cell by its code
    base::Array<ClassifiedCell> cell;
};

[[nodiscard]] ClassifiedCells classify_cells(const marks::Site& site, const SurfaceCells& cells);

// Only the counts are stored: the candidates are drawn again from the cell's random numbers.
struct PlaneCandidates {
    std::uint32_t stream; // the stream of random numbers that trials are drawn from
    double density;       // trials per unit of area
    double most_trials_in_cell;
    base::Array<std::int32_t> count; // the number of candidates in each cell
    std::int64_t all = 0;            // the sum of `count`
    // The area of the planes inside flat cells and the region, estimated from the candidates.
    [[nodiscard]] double area() const noexcept { return all > 0 ? static_cast<double>(all) / density : 0.0; }
};

// Draws `density` candidates per unit of area, but no more than `most_trials` trials in all cells together.
[[nodiscard]] PlaneCandidates draw_on_planes(const marks::Site& site, const ClassifiedCells& classified,
                                             std::uint32_t stream, double density, double most_trials);

// A point on the surface, to second order, with its cell.
struct Projection {
    std::int32_t cell; // number in SurfaceCells::cell
    std::uint32_t ticket;
    glm::vec3 position; // relative to the grid's origin
    float normal;       // packed
    bool bent;          // may need further steps to reach the surface
};

// Points are drawn uniformly in the volume of the cells that are not flat and kept within `band` of the surface: a
// layer of constant thickness holds as many points per area everywhere, to second order in band * curvature. One Newton
// step projects them onto the surface.
//
// Beside a crease the layer is cut off on one side and has an extra wedge on the other. Points of the wedge project
// onto another sheet and do not count; points whose mirror image is cut off count twice. A candidate beside a
// projection that lands beyond the crease is reflected back.
struct LayerCandidates {
    explicit LayerCandidates(base::Memory& memory) noexcept : trial_cell(memory), projection(memory) {}

    // An estimate from the volume before the first draw, and from the projections afterwards.
    [[nodiscard]] double area() const noexcept;

    std::uint32_t stream = 0;               // the stream of random numbers that points are drawn from
    std::int64_t projections_per_trial = 1; // the number of projections per trial
    base::Array<std::int32_t> trial_cell;   // all cells whose trials may have a projection in a bent cell
    double volume = 0.0;                    // the volume of these cells
    double reach = 0.0, band = 0.0;         // as in SurfaceCells
    // These grow with each draw.
    base::Array<Projection> projection;
    std::uint32_t rounds = 0;
    double trials = 0.0;
    std::int64_t near = 0;    // the number of projections of trials within the band
    std::int64_t strayed = 0; // the number of those projections that are outside the region or its cells
    bool all_bent = false;    // one step was not enough even where the planes of cells are right
};

// `wanted`: the number of candidates of the whole surface.
[[nodiscard]] LayerCandidates layer_candidates(const ClassifiedCells& classified, std::uint32_t stream,
                                               std::int64_t wanted);
// Draws further points until there are about `density` candidates per unit of area.
void draw_in_layer(const marks::Site& site, const ClassifiedCells& classified, double density, LayerCandidates& layer);

// Candidates, cell by cell along a space-filling curve, in single precision: the chosen ones are projected later.
struct Candidates {
    explicit Candidates(base::Memory& memory) noexcept
        : code(memory), number(memory), first(memory), group(memory), ticket(memory) {}

    [[nodiscard]] std::int64_t cells() const noexcept { return code.size(); }
    [[nodiscard]] OrderBlock places() noexcept { return {group.data(), group.size()}; }
    // Calls visit(place) for the candidates of a cell whose ticket is below the limit.
    template <class Visit>
    void for_taken(std::int64_t cell, std::uint64_t ticket_limit, Visit&& visit) const {
        HRBFNPR_ASSERT(cell >= 0 && cell < cells());
        for (std::int64_t place = first[cell]; place < first[cell] + number[cell]; ++place)
            if (ticket[place] < ticket_limit) visit(place);
    }

    geometry::CellGrid grid;
    geometry::Bounds region;
    std::int64_t count = 0;
    base::Array<std::uint64_t> code;  // the codes of the cells that hold candidates (geometry/morton.h), ascending
    base::Array<std::int32_t> number; // the number of candidates in each cell
    base::Array<std::int64_t> first;  // the place of each cell's first candidate, which begins a group
    // x, y, z are relative to grid.origin, within about curvature * (side / 4)^2 of the surface. The order sets
    // energies and clearances.
    base::Array<OrderGroup> group;
    base::Array<std::uint32_t> ticket; // a random number for each place in the groups
    marks::LevelReport report;         // `attempted` counts all points that were near the surface
    double area = 0.0;                 // an estimate of the area of the surface inside the region
};

// Draws about `wanted` candidates.
[[nodiscard]] Candidates draw_candidates(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                         marks::Kind kind);

// ---- The progressive order
//
// This is the order in which candidates become marks. Every prefix of it is as even as possible.
//
// Each next mark fills the largest gap: among the candidates that keep 0.70 of the densest packing's distance from all
// earlier marks, it has one of the lowest energies. The energy is a sum over the marks within about two such distances
// (void and cluster, Ulichney 1993; elimination by weight, Yuksel 2015, is similar but backwards). The distance alone
// (dart throwing) fills some parts of the surface before others; the energy alone lets marks touch. A candidate that is
// nearly far enough moves to the middle of its gap. Neighbours whose normals point to opposite sides ignore each other,
// so both faces of a thin sheet get their own order.
//
// 1. The cells of a stage are twice as wide as those of the next one, and it fills a quarter as many marks. A stage
//    puts its candidates and the marks of earlier stages into its cells.
// 2. Sweeps over tiles of cells fill the stage, at rising energy thresholds. In a tile, the cell with the lowest
//    energy gives its best candidate, or the middle of the gap beside it; the cells around add the new mark's energy.
// 3. The marks of one step of a sweep are shuffled, so that each prefix is spread like the whole.

// The distance between neighbours in the densest packing of `marks` marks.
[[nodiscard]] inline double densest_distance(double area, double marks) noexcept {
    return std::sqrt(2.0 / std::sqrt(3.0) * area / marks);
}

// Returns the way from 0 to the middle of the gap between the points around it, in a plane. It climbs the distance to
// the nearest point: first away from that point, then between the two nearest, from one Voronoi vertex to the next. It
// ends where that distance is `wanted` or at a maximum; the way is 0 if it would lead beyond `farthest`.
[[nodiscard]] glm::dvec2 toward_void(std::span<const glm::dvec2> around, double wanted, double farthest) noexcept;

// Positions are relative to the candidates' grid.origin, and near the surface.
using OrderedMarks = base::Array<OrderMark>;

// Orders `wanted` marks, or as many as have distinct places. Works in place and reorders the candidates.
[[nodiscard]] OrderedMarks progressive_order(const marks::Site& site, Candidates& candidates, std::int64_t wanted);

} // namespace hrbfnpr::stipples
