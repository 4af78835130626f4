// SPDX-License-Identifier: MIT
// Candidates of the progressive order: points near the surface, a few for each mark, cell by cell; and that order.
//
// 1. judge_cells() tells where the planes of the cells are the surface: there a cell is flat, elsewhere it is bent.
// 2. draw_on_planes() puts candidates on the planes of flat cells, evenly and without an evaluation.
// 3. draw_in_layer() puts candidates in bent cells: random points in a layer around the surface, taken down to it.
// 4. draw_candidates() does these in rounds until there are enough, and puts both side by side in the order of cells.
#pragma once

#include "marks/site.h"
#include "stipples/order_loops.h"
#include "stipples/surface_cells.h"

#include <cmath>
#include <span>

namespace hrbfnpr::stipples {

// How a cell's plane can be used.
enum class CellKind : std::uint8_t {
    clear, // it passes by
    flat,  // it is the surface
    bent   // the planes of neighbours say otherwise, or it has no plane
};

struct JudgedCell {
    CellKind kind;
    float curvature; // mean; 0 where it is not known
};

struct JudgedCells {
    explicit JudgedCells(const SurfaceCells& of) : cells(of), number(of), cell(of.cell.memory(), of.cell.size()) {}

    [[nodiscard]] CellKind kind(std::int64_t i) const noexcept {
        HRBFNPR_ASSERT(i >= 0 && i < cell.size());
        return cell[i].kind;
    }

    const SurfaceCells& cells;
    CellMap number; // gives the number of a cell by its code
    base::Array<JudgedCell> cell;
};

[[nodiscard]] JudgedCells judge_cells(const marks::Site& site, const SurfaceCells& cells);

// Candidates on planes are kept as numbers of trials only: each is drawn again from its cell's random numbers.
struct PlaneCandidates {
    std::uint32_t stream; // the number of the stream of random numbers that trials are drawn from
    double density;       // trials for each unit of area
    double most_trials_in_cell;
    base::Array<std::int32_t> count; // the number of each cell's candidates
    std::int64_t all = 0;            // the sum of `count`
    // The area of the planes inside flat cells and the region, as the candidates tell.
    [[nodiscard]] double area() const noexcept { return all > 0 ? static_cast<double>(all) / density : 0.0; }
};

// Draws that many for each unit of area, but no more trials than `most_trials` in all cells together.
[[nodiscard]] PlaneCandidates draw_on_planes(const marks::Site& site, const JudgedCells& judged, std::uint32_t stream,
                                             double density, double most_trials);

// A point on the surface, to second order, and its cell.
struct Projection {
    std::int32_t cell; // number in SurfaceCells::cell
    std::uint32_t ticket;
    glm::vec3 position; // relative to the grid's origin
    float normal;       // packed
    bool bent;          // perhaps not yet on the surface
};

// Points are drawn uniformly in the volume of the cells that are not flat and kept within `band` of the surface: a
// layer of constant thickness holds as many points per area everywhere, to second order in band * curvature. One Newton
// step takes them down to the surface.
//
// Beside a crease the layer is cut off on one side, and on the other one it has a wedge more. Points of the wedge,
// whose projection belongs to another sheet, do not count, and those whose mirror image is cut off count twice; a
// candidate put beside a projection and over the crease is thrown back from there.
struct LayerCandidates {
    explicit LayerCandidates(base::Memory& memory) noexcept : trial_cell(memory), projection(memory) {}

    // An estimate before the first are drawn, and a better one after that.
    [[nodiscard]] double area() const noexcept;

    std::uint32_t stream = 0;             // the number of the stream of random numbers that points are drawn from
    std::int64_t each = 1;                // the number of projections of a trial
    base::Array<std::int32_t> trial_cell; // all cells from which a projection may be in a cell that is bent
    double volume = 0.0;                  // the volume of these cells
    double reach = 0.0, band = 0.0;       // as in SurfaceCells
    // These grow with each draw.
    base::Array<Projection> projection;
    std::uint32_t rounds = 0;
    double trials = 0.0;
    std::int64_t near = 0;    // the number of projections of all trials within the band
    std::int64_t strayed = 0; // those of `near` that lie outside the region or its cells
    bool all_bent = false;    // one step was not enough even where cells' planes are right
};

// `wanted`: the number of candidates of the whole surface.
[[nodiscard]] LayerCandidates layer_candidates(const JudgedCells& judged, std::uint32_t stream, std::int64_t wanted);
// Draws more, until there are about that many for each unit of area; each time others.
void draw_in_layer(const marks::Site& site, const JudgedCells& judged, double density, LayerCandidates& layer);

// Candidates cell by cell along a space-filling curve, in single precision: a chosen one comes to rest on the surface
// later.
struct Candidates {
    explicit Candidates(base::Memory& memory) noexcept
        : code(memory), number(memory), first(memory), group(memory), ticket(memory) {}

    [[nodiscard]] std::int64_t cells() const noexcept { return code.size(); }
    [[nodiscard]] OrderBlock places() noexcept { return {group.data(), group.size()}; }
    // Calls visit(place) for the candidates of a cell with smaller tickets.
    template <class Visit>
    void for_taken(std::int64_t cell, std::uint64_t ticket_limit, Visit&& visit) const {
        HRBFNPR_ASSERT(cell >= 0 && cell < cells());
        for (std::int64_t place = first[cell]; place < first[cell] + number[cell]; ++place)
            if (ticket[place] < ticket_limit) visit(place);
    }

    geometry::CellGrid grid;
    geometry::Bounds region;
    std::int64_t count = 0;
    base::Array<std::uint64_t> code;   // the codes of the cells that hold candidates (geometry/morton.h), rising
    base::Array<std::int32_t> number;  // the number of each cell's candidates
    base::Array<std::int64_t> first;   // the place of each cell's first candidate, which begins a group
    base::Array<OrderGroup> group;     // x, y, z: relative to grid.origin, within about curvature * (side / 4)^2 of the
                                       // surface; energies and clearances are for the order to set
    base::Array<std::uint32_t> ticket; // a random number for each place in the groups
    marks::LevelReport report;         // attempted: all that were near the surface
    double area = 0.0;                 // an estimate of the area of the surface inside the region
};

// Draws about `wanted` candidates.
[[nodiscard]] Candidates draw_candidates(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                         marks::Kind kind);

// ---- The progressive order
//
// Candidates in the order in which they become marks: every prefix of it is as even as can be.
//
// Each next mark is where there is most room: among the candidates that keep 0.70 of the densest packing's distance
// from all before, one at the lowest energy, which is a sum over the marks within about two such distances (void and
// cluster, Ulichney 1993; elimination by weight, Yuksel 2015, does the like backwards). The distance alone (dart
// throwing) fills some parts of the surface before others; the energy alone lets marks touch. A candidate that is
// nearly far enough moves to the middle of its gap. Neighbours whose normals point to opposite sides do not see each
// other: on a thin sheet both faces get their own order.
//
// 1. Stages have cells of twice the width of the next one's, and fill four times fewer marks. A stage takes its
//    candidates and the marks of the stages before it into its cells.
// 2. It is filled in sweeps over tiles of cells, at rising thresholds of energy. In a tile the cell with the lowest
//    energy gives its best candidate, or the middle of the gap beside it; the cells around feel the new mark.
// 3. The marks of a sweep's step are shuffled, so that each prefix is spread like the whole.

// Distance of neighbours in the densest packing of that many marks.
[[nodiscard]] inline double densest_distance(double area, double marks) noexcept {
    return std::sqrt(2.0 / std::sqrt(3.0) * area / marks);
}

// The way from 0 to the middle of the gap between the points around it, in a plane: uphill on the distance to the
// nearest of them, first away from the nearest point, then between the two nearest, from one Voronoi vertex to the
// next. It ends where that distance is `wanted`, or at a maximum of it; it is 0 if it would lead beyond `farthest`.
[[nodiscard]] glm::dvec2 toward_void(std::span<const glm::dvec2> around, double wanted, double farthest) noexcept;

// Relative to the candidates' grid.origin; near the surface.
using OrderedMarks = base::Array<OrderMark>;

// Orders `wanted` marks, or as many as differ. Works in the candidates themselves, which come to stand in another
// order.
[[nodiscard]] OrderedMarks progressive_order(const marks::Site& site, Candidates& candidates, std::int64_t wanted);

} // namespace hrbfnpr::stipples
