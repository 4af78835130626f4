// SPDX-License-Identifier: MIT
#include "stipples/candidates.h"

#include "stipples/layer_candidates.h"
#include "stipples/plane_candidates.h"

#include <algorithm>

namespace hrbfnpr::stipples {
namespace {

constexpr int candidate_rounds = 4;
// Less than this part of the wanted calls for another round.
constexpr double enough = 0.85;
// Trials for each of the wanted, where planes and the surface do not agree.
constexpr double most_trials = 256.0;
// Candidates at random leave gaps: to serve as well as evenly spread ones there must be more of them.
constexpr double layer_density = 1.4;
constexpr std::int64_t cells_of_task = 2048;

base::Array<std::uint64_t> codes_of(const marks::Site& site, const SurfaceCells& cells) {
    base::Array<std::uint64_t> codes(site.memory(), cells.cell.size());
    for (std::int64_t i = 0; i < codes.size(); ++i) codes[i] = cells.cell[i].code;
    return codes;
}

// Where the function is no distance, the area is not what the cells say, and the first round gives too few.
void draw(const SurfaceCells& cells, PlaneCandidates& planes, LayerCandidates& layer, std::int64_t wanted,
          const base::Progress& progress) {
    double density = static_cast<double>(wanted) / cells.rough_area();
    for (int round = 0; round < candidate_rounds; ++round) {
        planes.draw(density, most_trials * static_cast<double>(wanted), progress);
        layer.draw(layer_density * density, progress.part(round == 0 ? 0.0 : 0.7, round == 0 ? 0.7 : 0.8));
        const double placed =
            static_cast<double>(planes.count()) + static_cast<double>(layer.projections().size()) / layer_density;
        if (placed >= enough * static_cast<double>(wanted) || !(placed > 0.0)) return;
        density *= static_cast<double>(wanted) / placed;
    }
}

void make_room(Candidates& candidates, std::int64_t groups) {
    candidates.group.resize_for_overwrite(groups);
    candidates.ticket.resize_for_overwrite(OrderGroup::size * groups);
}

void put(const Projection& projection, std::int64_t place, Candidates& candidates) noexcept {
    const OrderBlock all = candidates.places();
    all.at(OrderGroup::x, place) = projection.position.x;
    all.at(OrderGroup::y, place) = projection.position.y;
    all.at(OrderGroup::z, place) = projection.position.z;
    all.at(OrderGroup::normal, place) = projection.normal;
    candidates.ticket[place] = projection.ticket;
}

// Both cell by cell, each with groups of its own; cells without any are left out.
void merge(const marks::Site& site, const SurfaceCells& cells, const PlaneCandidates& planes,
           const base::Array<Projection>& projections, Candidates& candidates, const base::Progress& progress) {
    const std::int64_t count = cells.cell.size();
    base::Array<std::int64_t> next(site.memory(), count); // place of each cell's next candidate; at first, their number
    for (const Projection& projection : projections) ++next[projection.cell];
    std::int64_t groups = 0;
    for (std::int64_t cell = 0; cell < count; ++cell) {
        const std::int64_t number = next[cell] + planes.count_in(cell);
        next[cell] = OrderGroup::size * groups;
        if (number == 0) continue;
        candidates.code.push_back(cells.cell[cell].code);
        candidates.number.push_back(static_cast<std::int32_t>(number));
        candidates.first.push_back(next[cell]);
        candidates.count += number;
        groups += groups_for(number);
    }
    make_room(candidates, groups);
    site.runtime.parallel.for_chunks(count, cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t cell = begin; cell < end; ++cell)
            if (planes.count_in(cell) > 0) planes.put(cell, next[cell], candidates);
    });
    for (std::int64_t i = 0; i < projections.size(); ++i) {
        put(projections[i], next[projections[i].cell]++, candidates);
    }
    site.runtime.parallel.for_chunks(candidates.cells(), cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t cell = begin; cell < end; ++cell)
            clear_rest(candidates.places(), candidates.first[cell] + candidates.number[cell]);
    });
}

} // namespace

Candidates draw_candidates(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted, marks::Kind kind,
                           const base::Progress& progress) {
    Candidates candidates(site.memory());
    candidates.grid = cells.grid;
    candidates.region = cells.region;
    if (cells.cell.empty()) return candidates;
    const CellMap numbers(site.memory(), codes_of(site, cells));
    PlaneCandidates planes(site, cells, numbers, marks::stream_of(kind), progress);
    LayerCandidates layer(site, cells, numbers, planes.kind(), marks::stream_of(kind), wanted);
    draw(cells, planes, layer, wanted, progress);
    merge(site, cells, planes, layer.projections(), candidates, progress);
    candidates.report.placed = candidates.count;
    candidates.report.dropped_strayed = layer.strayed();
    candidates.report.attempted = candidates.report.placed + candidates.report.dropped_strayed;
    candidates.area = planes.area() + layer.area();
    progress.update(1.0);
    return candidates;
}

Candidates thinned(const marks::Site& site, Candidates& candidates, std::uint64_t ticket_limit,
                   const base::Progress& progress) {
    Candidates some(site.memory());
    some.grid = candidates.grid;
    some.region = candidates.region;
    some.area = candidates.area;
    const std::int64_t cells = candidates.cells();
    some.code.resize_for_overwrite(cells);
    some.number.resize(cells);
    some.first.resize_for_overwrite(cells);
    site.runtime.parallel.for_chunks(cells, cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t cell = begin; cell < end; ++cell) {
            some.code[cell] = candidates.code[cell];
            candidates.for_taken(cell, ticket_limit, [&](std::int64_t) { ++some.number[cell]; });
        }
    });
    for (std::int64_t cell = 0; cell < cells; ++cell) {
        some.first[cell] = some.count;
        some.count += some.number[cell];
    }
    make_room(some, groups_for(some.count));
    site.runtime.parallel.for_chunks(cells, cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t cell = begin; cell < end; ++cell) {
            std::int64_t to = some.first[cell];
            candidates.for_taken(cell, ticket_limit, [&](std::int64_t place) {
                some.ticket[to] = candidates.ticket[place];
                copy_place(candidates.places(), place, some.places(), to++);
            });
        }
    });
    return some;
}

} // namespace hrbfnpr::stipples
