// SPDX-License-Identifier: MIT
// Candidates of the progressive order: points near the surface, a few per mark, stored cell by cell; and the order.
//
// 1. classify_cells() finds where the planes of the cells match the surface: these cells are flat, the others bent.
// 2. draw_on_planes() puts candidates on the planes of flat cells, evenly and without an evaluation.
// 3. draw_in_layer() puts candidates in bent cells: it projects random points of a layer around the surface.
// 4. draw_candidates() repeats steps 2 and 3 in rounds until there are enough candidates, and merges them cell by cell.
#pragma once

#include "marks/site.h"
#include "stipples/needed_cells.h"
#include "stipples/order_loops.h"
#include "stipples/surface_cells.h"

#include <span>

namespace hrbfnpr::stipples {

// How a cell's plane can be used.
enum class CellKind : std::uint8_t {
    empty, // The plane does not pass through the cell.
    flat,  // The plane matches the surface.
    bent   // the planes of neighbours disagree, or the cell has no plane
};

struct ClassifiedCell {
    CellKind kind;
    float curvature; // the mean curvature; 0 if unknown
};

struct ClassifiedCells {
    explicit ClassifiedCells(const SurfaceCells& of) : cells(of), number(of), cell(of.cell.memory(), of.cell.size()) {}

    [[nodiscard]] CellKind kind(std::int64_t i) const noexcept {
        HRBFNPR_ASSERT(i >= 0 && i < cell.size());
        return cell[i].kind;
    }

    const SurfaceCells& cells;
    CellMap number; // finds the index of a cell by its code
    base::Array<ClassifiedCell> cell;
};

[[nodiscard]] ClassifiedCells classify_cells(const marks::Site& site, const SurfaceCells& cells);

// The cells of a surface that a still picture needs.
struct NeededCells {
    base::Array<float> share;           // for each cell, the share of the order that is needed
    base::Array<float> candidate_share; // for each cell, the share of its candidates that some stage may use
    double least_share;                 // no candidate share is below this
};

// Finds what `need` asks for, for an order of `wanted` marks that is chosen from `candidates` candidates.
[[nodiscard]] NeededCells find_needed_cells(const marks::Site& site, const SurfaceCells& cells, const marks::Need& need,
                                            std::int64_t wanted, std::int64_t candidates);

// The candidates on the planes of flat cells. Only the number of candidates in each cell is stored: the candidates are
// generated again from the random numbers of the cells.
struct PlaneCandidates {
    std::uint32_t stream; // the stream of random numbers for the trials
    double density;       // the number of trials per unit of area
    double most_trials_in_cell;
    base::Array<std::int32_t> count; // the number of candidates in each cell, without those that are not needed
    std::int64_t all = 0;            // the number of candidates in all cells, needed or not
    // Returns the area of the planes inside flat cells and the region, estimated from the candidates.
    [[nodiscard]] double area() const noexcept { return all > 0 ? static_cast<double>(all) / density : 0.0; }
};

// Generates `density` candidates per unit of area, with at most `most_trials` trials in all cells together. `needed`
// may be null: then all candidates are needed.
[[nodiscard]] PlaneCandidates draw_on_planes(const marks::Site& site, const ClassifiedCells& classified,
                                             std::uint32_t stream, double density, double most_trials,
                                             const NeededCells* needed = nullptr);

// A point on the surface, to second order, with its cell.
struct Projection {
    std::int32_t cell; // the index of its cell in SurfaceCells::cell
    std::uint32_t ticket;
    glm::vec3 position; // relative to the origin of the grid
    float normal;       // packed by packed_normal()
    bool bent;          // True if the projection may need further steps to reach the surface.
};

// Points are drawn uniformly in the volume of the cells that are not flat, and kept if they are within `band` of the
// surface. The kept points fill a layer of constant thickness, so their number per area of the surface is the same
// everywhere, to second order in band * curvature. One Newton step projects them onto the surface.
//
// Beside a crease the layer is cut off on one side and has an extra wedge on the other. Points of the wedge project
// onto another sheet and do not count; points whose mirror image is cut off count twice. A candidate that is placed
// beside a projection, and lands across the crease, is mirrored back.
struct LayerCandidates {
    explicit LayerCandidates(base::Memory& memory) noexcept
        : trial_cell(memory), trial_share(memory), projection(memory) {}

    // Returns an estimate of the area: from the volume before the first draw, and from the projections afterwards.
    [[nodiscard]] double area() const noexcept;

    std::uint32_t stream = 0;               // the stream of random numbers for the points
    std::int64_t projections_per_trial = 1; // the number of projections for each trial
    base::Array<std::int32_t> trial_cell;   // all cells in which a trial may have a projection into a bent cell
    base::Array<float> trial_share;         // for each of these cells: the share of its trials that is drawn
    double least_share = 1.0;               // Each cell has at least this share of its projections.
    double volume = 0.0;                    // the volume of these cells
    double reach = 0.0, band = 0.0;         // the same as in SurfaceCells
    // The members below change with each draw.
    base::Array<Projection> projection;
    std::uint32_t rounds = 0;
    double trials = 0.0;   // the number of trials, as if all trials were drawn
    double whole = 0.0;    // the number of projections, as if all trials were drawn
    std::int64_t near = 0; // the number of projections whose trials are inside the band
    // The number of projections counted in `near` that are outside the region or in none of its cells.
    std::int64_t strayed = 0;
    bool all_bent = false; // True if one step is not enough even where the planes of cells are correct.
};

// Makes an empty layer. `wanted` is the number of candidates for the whole surface.
[[nodiscard]] LayerCandidates layer_candidates(const ClassifiedCells& classified, std::uint32_t stream,
                                               std::int64_t wanted, const NeededCells* needed = nullptr);
// Draws more points, until there are about `density` candidates per unit of area.
void draw_in_layer(const marks::Site& site, const ClassifiedCells& classified, double density, LayerCandidates& layer);

// The candidates, cell by cell along a space-filling curve. They are in single precision, because the chosen candidates
// are projected later.
struct Candidates {
    explicit Candidates(base::Memory& memory) noexcept
        : code(memory), number(memory), first(memory), share(memory), relative_area(memory), group(memory),
          ticket(memory) {}

    [[nodiscard]] std::int64_t cells() const noexcept { return code.size(); }
    [[nodiscard]] OrderBlock places() noexcept { return {group.data(), group.size()}; }
    // Calls visit(place) for those candidates of a cell whose ticket is below the limit.
    template <class Visit>
    void for_taken(std::int64_t cell, std::uint64_t ticket_limit, Visit&& visit) const {
        HRBFNPR_ASSERT(cell >= 0 && cell < cells());
        for (std::int64_t place = first[cell]; place < first[cell] + number[cell]; ++place)
            if (ticket[place] < ticket_limit) visit(place);
    }

    geometry::CellGrid grid;
    geometry::Bounds region;
    std::int64_t count = 0;
    double whole = 0.0; // the number of candidates on the whole surface, with those that a still picture does not need
    base::Array<std::uint64_t> code;  // the codes of the cells with candidates (geometry/morton.h), in ascending order
    base::Array<std::int32_t> number; // the number of candidates in each cell
    base::Array<std::int64_t> first;  // for each cell: the place of its first candidate, which begins a group
    // For each cell: the share of the order that is needed there, and the area of the surface in the cell, in some
    // unit. Empty if the whole order is needed everywhere.
    base::Array<float> share, relative_area;
    // The candidates. x, y, z are relative to grid.origin, and at most about curvature * (side / 4)^2 off the surface.
    // The order sets their energies and clearances.
    base::Array<OrderGroup> group;
    base::Array<std::uint32_t> ticket; // for each place in the groups: a random number
    marks::LevelReport report;         // In the report, `attempted` counts all points that were near the surface.
    double area = 0.0;                 // the estimated area of the surface inside the region
};

// Generates about `wanted` candidates. `needed` may be null: then all of them are needed.
[[nodiscard]] Candidates draw_candidates(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                                         marks::Kind kind, const NeededCells* needed = nullptr);

// ---- The progressive order
//
// This is the order in which candidates become marks. Every prefix of it is as even as possible.
//
// Each next mark fills the largest gap: among the candidates that keep 0.70 of the densest packing's distance from all
// earlier marks, it has one of the lowest energies. The energy of a candidate is a sum over the marks within about
// twice the distance of the densest packing (void and cluster, Ulichney 1993; elimination by weight, Yuksel 2015, is
// similar but backwards). A rule for the distance alone (dart throwing) fills some parts of the surface before others;
// a rule for the energy alone lets marks touch. A candidate that is nearly far enough from all marks moves to the
// middle of its gap. Neighbours whose normals point to opposite sides ignore each other, so both faces of a thin sheet
// get their own order.
//
// 1. Marks are placed in stages. The cells of a stage are twice as wide as the cells of the next stage, and a stage
//    ends with a quarter of the marks of the next stage. At its beginning, a stage puts its candidates and the marks of
//    earlier stages into its cells.
// 2. Sweeps over tiles of cells fill the stage, at rising energy thresholds. In a tile, the cell with the lowest
//    energy gives its best candidate, or the middle of the gap beside this candidate. The energy of the new mark is
//    added to the candidates of the cells around it.
// 3. The marks of one step of a sweep are shuffled, so that each prefix is spread like the whole.
//
// If a still picture needs only parts of the order, each cell is closed when the order has as many marks as the cell
// needs. Marks are counted as if they were placed everywhere: the marks in the cells that need more, divided by the
// share of these cells in the area. Cells beside these cells stay open, too, but their marks are not counted, because
// they have fewer neighbours than in the whole order.

// Returns a move from the origin of a plane into the middle of the gap between the points around the origin. The move
// increases the distance to the nearest point: first away from that point, then between the two nearest points, from
// one Voronoi vertex to the next. It ends where the distance is `wanted`, or at a maximum. If the move would be longer
// than `farthest`, it returns 0.
[[nodiscard]] glm::dvec2 toward_void(std::span<const glm::dvec2> around, double wanted, double farthest) noexcept;

// The marks in order. Positions are relative to the grid.origin of the candidates, and near the surface.
struct OrderedMarks {
    explicit OrderedMarks(base::Memory& memory) noexcept : mark(memory), place(memory) {}

    [[nodiscard]] std::int64_t size() const noexcept { return mark.size(); }
    // Returns the number of marks of the whole order up to the mark.
    [[nodiscard]] double place_of(std::int64_t i) const noexcept {
        return place.empty() ? static_cast<double>(i + 1) : place[i];
    }

    base::Array<OrderMark> mark;
    base::Array<double> place; // for each mark: its place in the whole order; empty if this is the whole order
    double whole = 0.0;        // the number of marks of the whole order
};

// Orders `wanted` marks, or fewer if there are not enough distinct places. It works in place and changes the order of
// the candidates.
[[nodiscard]] OrderedMarks progressive_order(const marks::Site& site, Candidates& candidates, std::int64_t wanted);

} // namespace hrbfnpr::stipples
