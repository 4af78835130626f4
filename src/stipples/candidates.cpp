// SPDX-License-Identifier: MIT
#include "stipples/candidates.h"

#include "base/bits.h"
#include "base/random.h"
#include "geometry/tangent_frame.h"
#include "stipples/tuning.h"
#include "surface/creased.h"

#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace hrbfnpr::stipples {
namespace {

constexpr double unit_of_32_bits = 1.0 / 4294967296.0;

[[nodiscard]] float packed(const glm::dvec3& normal) noexcept {
    return packed_normal({static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)});
}

// ---- 1. Cells whose planes match the surface

// Judges the plane of a cell. The cell is flat if its plane agrees with the planes of the cells beside it: then no
// other sheet is near, and the surface does not bend. The turn of the normals from cell to cell gives their divergence,
// which is twice the mean curvature.
[[nodiscard]] ClassifiedCell classify_cell(const marks::Site& site, const SurfaceCells& cells, const CellMap& numbers,
                                           std::int64_t number, CellMap::BlocksAround& blocks) noexcept {
    constexpr ClassifiedCell bent = {CellKind::bent, 0.0F};
    const SurfaceCell& cell = cells.cell[number];
    const double side = cells.grid.side;
    if (std::isnan(cell.distance)) return bent;
    HRBFNPR_ASSERT(std::abs(glm::length(cell.normal) - 1.0) < 1e-6);
    if (const implicit::Domain* const domain = site.implicit.domain(); domain != nullptr)
        if (domain->may_end_near(cells.centre(number), 0.5 * side)) return bent;
    const glm::dvec3 along = glm::abs(cell.normal);
    if (std::abs(cell.distance) > side * (0.5 * (along.x + along.y + along.z) + stipple_tuning.miss_distance))
        return {CellKind::empty, 0.0F};
    const CellMap::Around around = numbers.around(cell.code, blocks);
    // A crease may cross only an edge or a corner of the cell, so all 26 neighbours are checked.
    for (const std::int32_t next : around)
        if (site.implicit.sheets() != nullptr && next >= 0 &&
            !(glm::dot(cell.normal, cells.cell[next].normal) >= surface::smooth_cosine))
            return bent;
    double divergence = 0.0;
    bool known = true;
    for (int axis = 0; axis < 3; ++axis) {
        double turn = 0.0;
        int beside = 0;
        for (const int way : {-1, 1}) {
            const std::size_t step = CellMap::step_along[axis];
            const std::int32_t next = around[way < 0 ? CellMap::centre_index - step : CellMap::centre_index + step];
            if (next < 0) continue;
            const SurfaceCell& there = cells.cell[next];
            const double distance = cell.distance + way * side * cell.normal[axis];
            if (!(std::abs(distance - there.distance) <= stipple_tuning.plane_error * side) ||
                !(glm::dot(cell.normal, there.normal) >= stipple_tuning.flat_cosine))
                return bent;
            turn += way * (there.normal[axis] - cell.normal[axis]);
            ++beside;
        }
        known = known && beside > 0;
        divergence += beside > 0 ? turn / (side * beside) : 0.0;
    }
    return {CellKind::flat, known ? static_cast<float>(0.5 * divergence) : 0.0F};
}

// ---- 2. Candidates on planes

// The steps 1/x and 1/x^2, in units of 2^-32, with the root x of x^3 = x + 1. Their multiples fill the unit square
// evenly for any number of points (Roberts 2018, "The unreasonable effectiveness of quasirandom sequences").
constexpr std::uint32_t long_step = 3242174889;
constexpr std::uint32_t short_step = 2447445414;

// The trials of a flat cell, spread evenly over one of its faces. A trial is a candidate if its place on the plane is
// inside the cell. Coordinates on the face are in units of 2^-32 sides from the middle, and wrap around.
struct PlaneTrials {
    int up; // the axis perpendicular to the face
    std::int32_t count;
    std::uint32_t u, v; // the coordinates of the first trial on the face
    std::uint32_t step_u, step_v;
    double ticket_offset; // a random number in [0, 1); the ticket of trial k is (k + ticket_offset) / count
    double level, slope_u, slope_v;

    // Returns the place of a trial on the plane, in sides of the cell, relative to its centre.
    [[nodiscard]] glm::dvec3 offset(std::int32_t k) const noexcept {
        const auto along = [&](std::uint32_t from, std::uint32_t step) {
            return unit_of_32_bits * static_cast<std::int32_t>(from + step * static_cast<std::uint32_t>(k));
        };
        glm::dvec3 offset;
        const double along_u = along(u, step_u);
        const double along_v = along(v, step_v);
        offset[up] = level + slope_u * along_u + slope_v * along_v;
        offset[(up + 1) % 3] = along_u;
        offset[(up + 2) % 3] = along_v;
        return offset;
    }
};

[[nodiscard]] PlaneTrials trials_in(const marks::Site& site, const SurfaceCell& cell, double side,
                                    const PlaneCandidates& planes) noexcept {
    const base::Philox random = base::philox(
        site.random_seed, {static_cast<std::uint32_t>(cell.code), static_cast<std::uint32_t>(cell.code >> 32U),
                           static_cast<std::uint32_t>(base::Purpose::candidate), planes.stream});
    const glm::dvec3 a = glm::abs(cell.normal);
    const int up = a.x >= a.y ? (a.x >= a.z ? 0 : 2) : (a.y >= a.z ? 1 : 2);
    const double trials = planes.density * side * side / std::abs(cell.normal[up]);
    // The points form a lattice. It is rotated and mirrored at random in each cell, so that it is not visible.
    const bool turned = (random[3] & 1U) != 0;
    const bool mirrored = (random[3] & 2U) != 0;
    const std::uint32_t along_v = turned ? long_step : short_step;
    return {up,
            static_cast<std::int32_t>(std::min(trials, planes.most_trials_in_cell) + unit_of_32_bits * random[0]),
            random[1],
            random[2],
            turned ? short_step : long_step,
            mirrored ? 0U - along_v : along_v,
            unit_of_32_bits * random[3],
            -cell.distance / (side * cell.normal[up]),
            -cell.normal[(up + 1) % 3] / cell.normal[up],
            -cell.normal[(up + 2) % 3] / cell.normal[up]};
}

// Calls visit(place, ticket) for the candidates of a flat cell in ascending order of tickets. Tickets are in [0, 1).
template <class Visit>
void for_candidates_on_plane(const marks::Site& site, const SurfaceCells& cells, std::int64_t number,
                             const PlaneCandidates& planes, Visit&& visit) noexcept {
    const double side = cells.grid.side;
    const PlaneTrials trials = trials_in(site, cells.cell[number], side, planes);
    const glm::dvec3 centre = cells.centre(number);
    const bool inside = cells.region.contains(centre - 0.5 * side) && cells.region.contains(centre + 0.5 * side);
    for (std::int32_t k = 0; k < trials.count; ++k) {
        const glm::dvec3 offset = trials.offset(k);
        if (!(offset[trials.up] >= -0.5 && offset[trials.up] < 0.5)) continue;
        const glm::dvec3 place = centre + side * offset;
        if (inside || cells.region.contains(place)) visit(place, (k + trials.ticket_offset) / trials.count);
    }
}

void store_candidate(const glm::vec3& position, float normal, std::uint32_t ticket, std::int64_t place,
                     Candidates& candidates) noexcept {
    HRBFNPR_ASSERT(place >= 0 && place < candidates.ticket.size());
    const OrderBlock all = candidates.places();
    all.at(OrderGroup::x, place) = position.x;
    all.at(OrderGroup::y, place) = position.y;
    all.at(OrderGroup::z, place) = position.z;
    all.at(OrderGroup::normal, place) = normal;
    candidates.ticket[place] = ticket;
}

// Adds the candidates of a flat cell. The plane touches the surface at the point nearest to the cell's centre. At a
// distance t from there, a surface of mean curvature k is k t^2 / 2 below the plane, if its principal curvatures are
// equal. Candidates stay in their cells, because the order searches for them there.
void store_plane_candidates(const marks::Site& site, const ClassifiedCells& classified, std::int64_t number,
                            const PlaneCandidates& planes, std::int64_t to, Candidates& candidates) noexcept {
    const SurfaceCells& cells = classified.cells;
    const SurfaceCell& cell = cells.cell[number];
    const float normal = packed(cell.normal);
    const glm::dvec3 centre = cells.centre(number);
    const double half_curvature = 0.5 * double{classified.cell[number].curvature};
    std::int32_t left = planes.count[number];
    for_candidates_on_plane(site, cells, number, planes, [&](const glm::dvec3& place, double ticket) {
        if (left-- <= 0) return;
        const glm::dvec3 offset = place - centre;
        const double below = half_curvature * (glm::dot(offset, offset) - cell.distance * cell.distance);
        const glm::dvec3 lowered = offset - below * cell.normal;
        const bool inside = glm::all(glm::lessThan(glm::abs(lowered), glm::dvec3(0.5 * cells.grid.side)));
        store_candidate(glm::vec3((inside ? centre + lowered : place) - cells.grid.origin), normal,
                        static_cast<std::uint32_t>(ticket * 4294967296.0), to++, candidates);
    });
}

// ---- 3. Candidates in the layer

// Returns the cell of a place, or -1 if the place is outside the region or in no cell.
[[nodiscard]] std::int32_t cell_of(const ClassifiedCells& classified, const glm::dvec3& p) noexcept {
    const SurfaceCells& cells = classified.cells;
    return cells.region.contains(p) ? classified.number.find(geometry::morton_code(cells.grid.cell_of(p))) : -1;
}

// A random number below 2^32 times the share of the trials that is drawn in the cell.
struct TrialTicket {
    std::uint32_t number;
    float share;
};

// Makes random trials in cells. Random number 0 of a cell rounds the number of its trials up or down; number k
// gives trial k. A trial is skipped if the cell's plane puts it far outside the band. The error of the plane inside the
// cell is 3/8 side^2 curvature, so skipping is correct if the radii of curvature are above 1.5 sides. On a surface with
// creases, no trial is skipped.
void draw_trials(const marks::Site& site, const SurfaceCells& cells, std::span<const std::int32_t> trial_cells,
                 std::span<const float> trial_shares, std::span<const std::int64_t> slot, std::uint32_t stream,
                 geometry::VecArray& trial, base::Array<TrialTicket>& ticket) {
    HRBFNPR_ASSERT(slot.size() == trial_cells.size() + 1);
    const double side = cells.grid.side;
    const double unlikely = site.implicit.sheets() == nullptr ? cells.band + stipple_tuning.miss_distance * side
                                                              : std::numeric_limits<double>::infinity();
    trial.resize(slot.back()); // At first, there is one slot for each trial. It is NaN if the trial is skipped.
    ticket.resize_for_overwrite(slot.back());
    const auto count = static_cast<std::int64_t>(trial_cells.size());
    site.work.for_chunks(count, cells_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
            const SurfaceCell& cell = cells.cell[trial_cells[i]];
            const glm::dvec3 corner = cells.grid.corner(geometry::morton_cell(cell.code));
            std::uint32_t number = 1;
            for (std::int64_t at = slot[i]; at < slot[i + 1]; ++at, ++number) {
                const auto u = base::uniform4(site.random_seed, cell.code, base::Purpose::candidate, stream | number);
                const glm::dvec3 offset = side * glm::dvec3(u[0], u[1], u[2]);
                const double distance = cell.distance + glm::dot(cell.normal, offset - 0.5 * side);
                const bool worth = !(std::abs(distance) > unlikely); // The comparison is true for NaN, too.
                trial.set(at, worth ? corner + offset : glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
                const float share = trial_shares[i];
                ticket[at] = {static_cast<std::uint32_t>(u[3] * 4294967296.0 * double{share}), share};
            }
        }
    });
    std::int64_t kept = 0;
    for (std::int64_t at = 0; at < slot.back(); ++at) {
        if (std::isnan(trial.x[at])) continue;
        trial.set(kept, trial[at]);
        ticket[kept++] = ticket[at];
    }
    trial.resize(kept);
    ticket.resize(kept);
}

// Returns how many times each trial counts: 0 times outside the band, once inside it, but 0, 1 or 2 times inside it
// near creases.
[[nodiscard]] base::Array<std::uint8_t> trial_weights(const marks::Site& site, const SurfaceCells& cells,
                                                      const geometry::VecArray& trial,
                                                      const marks::FieldSamples& field) {
    base::Array<std::uint8_t> times(site.memory(), trial.size());
    const bool creased = site.implicit.sheets() != nullptr;
    base::Array<std::int64_t> near(site.memory());
    geometry::VecArray places(site.memory()); // the projections, and then mirror images
    for (std::int64_t i = 0; i < trial.size(); ++i) {
        const double distance = field.distance(i);
        if (!(std::abs(distance) <= cells.band)) continue;
        times[i] = creased ? 0 : 1;
        if (!creased) continue;
        const glm::dvec3 down = distance * glm::normalize(field.gradient[i]);
        near.push_back(i);
        places.push_back(trial[i] - down);
        places.push_back(trial[i] - 2.0 * down);
    }
    if (!creased) return times;
    marks::FieldSamples beside(site.memory());
    evaluate(site, places, beside);
    for (std::int64_t k = 0; k < near.size(); ++k) {
        const glm::dvec3 normal = glm::normalize(field.gradient[near[k]]);
        const auto is_alike = [&](std::int64_t place) {
            const glm::dvec3 other = beside.gradient[place];
            return glm::dot(normal, other) >= surface::smooth_cosine * glm::length(other);
        };
        if (is_alike(2 * k)) times[near[k]] = is_alike(2 * k + 1) ? 1 : 2;
    }
    return times;
}

// For one trial: the number of its projections in cells that are not flat, and the number outside all cells or off the
// surface.
struct ProjectionCounts {
    std::uint8_t kept = 0, strayed = 0;
};

// Makes the projections of a trial: its own projection, then further ones around it in the tangent plane.
[[nodiscard]] ProjectionCounts project_trial(const marks::Site& site, const ClassifiedCells& classified,
                                             const glm::dvec3& trial, const TrialTicket& first, double distance,
                                             const glm::dvec3& gradient, std::uint32_t count, Projection* to) noexcept {
    const SurfaceCells& cells = classified.cells;
    const double side = cells.grid.side;
    const glm::dvec3 normal = glm::normalize(gradient);
    const geometry::TangentFrame frame = geometry::combing_frame(normal);
    const float bits = packed(normal);
    const glm::dvec3 projection = trial - distance * normal;
    // Where the plane of the cell is wrong at the trial, one Newton step is not enough.
    const std::int32_t own = cell_of(classified, trial);
    const bool bent =
        site.implicit.sheets() != nullptr || own < 0 ||
        !(std::abs(cells.cell[own].distance + glm::dot(cells.cell[own].normal, trial - cells.centre(own)) - distance) <=
          stipple_tuning.plane_error * side);
    ProjectionCounts counts;
    glm::dvec3 at = projection;
    std::uint32_t ticket = first.number;
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::int32_t cell = cell_of(classified, at);
        if (cell < 0 || !site.implicit.contains(at, normal))
            ++counts.strayed;
        else if (classified.kind(cell) != CellKind::flat)
            to[counts.kept++] = {cell, ticket, glm::vec3(at - cells.grid.origin), bits,
                                 bent || !(glm::dot(normal, cells.cell[cell].normal) >= stipple_tuning.flat_cosine)};
        if (k + 1 == count) break;
        const base::Philox random = base::philox(
            site.random_seed, {first.number, base::bit_cast<std::uint32_t>(static_cast<float>(projection.x)),
                               static_cast<std::uint32_t>(base::Purpose::candidate_order), k});
        const double u = random[1] * (2.0 * unit_of_32_bits) - 1.0;
        const double r = random[2] * (2.0 * unit_of_32_bits) - 1.0;
        at = projection + stipple_tuning.projection_stride * side * (u * frame.u + r * frame.r);
        ticket = static_cast<std::uint32_t>(random[0] * double{first.share});
    }
    return counts;
}

// Appends the projections of all trials to `layer`. `projection` is memory that is used again for each batch of trials.
void project_trials(const marks::Site& site, const ClassifiedCells& classified, const geometry::VecArray& trial,
                    const base::Array<TrialTicket>& ticket, base::Array<Projection>& projection,
                    LayerCandidates& layer) {
    HRBFNPR_ASSERT(trial.size() == ticket.size());
    marks::FieldSamples field(site.memory());
    evaluate(site, trial, field);
    const base::Array<std::uint8_t> times = trial_weights(site, classified.cells, trial, field);
    const std::int64_t most = (site.implicit.sheets() != nullptr ? 2 : 1) * layer.projections_per_trial;
    base::Array<ProjectionCounts> counts(site.memory(), trial.size());
    projection.resize_for_overwrite(most * trial.size()); // up to `most` projections for each trial
    site.work.for_chunks(trial.size(), points_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            if (times[i] > 0)
                counts[i] = project_trial(site, classified, trial[i], ticket[i], field.distance(i), field.gradient[i],
                                          static_cast<std::uint32_t>(times[i] * layer.projections_per_trial),
                                          projection.data() + most * i);
    });
    for (std::int64_t i = 0; i < trial.size(); ++i) {
        layer.near += times[i] * layer.projections_per_trial;
        layer.strayed += counts[i].strayed;
        for (std::int64_t k = 0; k < counts[i].kept; ++k) layer.projection.push_back(projection[most * i + k]);
    }
}

// Returns whether many projections are off the surface although the planes of their cells agree with them. This happens
// if f is not like a distance, for example the square of a distance. All planes are then wrong in the same way.
[[nodiscard]] bool many_are_off_surface(const marks::Site& site, const SurfaceCells& cells,
                                        std::span<const Projection> projections) {
    geometry::VecArray place(site.memory());
    for (std::size_t i = 0; i < projections.size(); i += static_cast<std::size_t>(stipple_tuning.every_projection))
        if (!projections[i].bent) place.push_back(cells.grid.origin + glm::dvec3(projections[i].position));
    marks::FieldSamples field(site.memory());
    evaluate(site, place, field);
    std::int64_t off = 0;
    for (std::int64_t k = 0; k < place.size(); ++k)
        if (!(std::abs(field.distance(k)) <= stipple_tuning.plane_error * cells.grid.side)) ++off;
    return static_cast<double>(off) > stipple_tuning.most_off_surface * static_cast<double>(place.size());
}

// The fate of a projection after a step.
enum class AfterStep : std::uint8_t { done, goes_on, strayed };

// Moves a projection by one more step. Sets the cell of the projection to -1 if the projection is not a candidate.
[[nodiscard]] AfterStep refine_projection(const marks::Site& site, const ClassifiedCells& classified, double distance,
                                          const glm::dvec3& gradient, bool first, Projection& projection) noexcept {
    const SurfaceCells& cells = classified.cells;
    const glm::dvec3 place = cells.grid.origin + glm::dvec3(projection.position);
    const bool near = std::abs(distance) <= cells.band;
    const glm::dvec3 normal = near ? glm::normalize(gradient) : glm::dvec3(0.0);
    if (near && site.implicit.sheets() != nullptr) {
        float unpacked[3];
        unpack_normal(projection.normal, unpacked);
        const glm::dvec3 own = glm::normalize(glm::dvec3(unpacked[0], unpacked[1], unpacked[2]));
        const double agree = glm::dot(own, normal);
        if (!(agree >= surface::smooth_cosine)) {
            // The place is beyond the crease, in the tangent plane of another sheet, so it is mirrored back across the
            // crease.
            const glm::dvec3 across = normal - agree * own;
            const double square = glm::dot(across, across);
            const glm::dvec3 at = place - 2.0 * distance / square * across;
            projection.cell = first && square > 0.01 ? cell_of(classified, at) : -1;
            projection.position = glm::vec3(at - cells.grid.origin);
            if (projection.cell >= 0 && classified.kind(projection.cell) != CellKind::flat) return AfterStep::goes_on;
            projection.cell = -1;
            return AfterStep::done;
        }
    }
    const glm::dvec3 at = near ? place - distance * normal : place;
    const std::int32_t cell = near && site.implicit.contains(at, normal) ? cell_of(classified, at) : -1;
    if (cell < 0 || classified.kind(cell) == CellKind::flat) {
        projection.cell = -1;
        return cell < 0 ? AfterStep::strayed : AfterStep::done;
    }
    projection = {cell, projection.ticket, glm::vec3(at - cells.grid.origin), packed(normal), true};
    const bool is_far = std::abs(distance) > stipple_tuning.surface_tolerance * cells.grid.side;
    return is_far ? AfterStep::goes_on : AfterStep::done;
}

// Moves the projections from index `first` on by further steps, if one step is not enough for them.
void refine_projections(const marks::Site& site, const ClassifiedCells& classified, std::int64_t first,
                        LayerCandidates& layer) {
    base::Array<Projection>& all = layer.projection;
    HRBFNPR_ASSERT(first >= 0 && first <= all.size());
    if (!layer.all_bent)
        layer.all_bent =
            many_are_off_surface(site, classified.cells, all.span().subspan(static_cast<std::size_t>(first)));
    base::Array<std::int64_t> bent(site.memory());
    for (std::int64_t i = first; i < all.size(); ++i)
        if (layer.all_bent || all[i].bent) bent.push_back(i);
    geometry::VecArray place(site.memory());
    marks::FieldSamples field(site.memory());
    base::Array<AfterStep> after(site.memory());
    for (int step = 0; step < stipple_tuning.most_steps && !bent.empty(); ++step) {
        place.clear();
        for (const std::int64_t i : bent) place.push_back(classified.cells.grid.origin + glm::dvec3(all[i].position));
        evaluate(site, place, field);
        after.resize_for_overwrite(bent.size());
        site.work.for_chunks(bent.size(), points_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t k = begin; k < end; ++k)
                after[k] =
                    refine_projection(site, classified, field.distance(k), field.gradient[k], step == 0, all[bent[k]]);
        });
        layer.strayed += std::count(after.begin(), after.end(), AfterStep::strayed);
        std::int64_t left = 0;
        for (std::int64_t k = 0; k < bent.size(); ++k)
            if (after[k] == AfterStep::goes_on) bent[left++] = bent[k];
        bent.resize(left);
    }
    all.resize(std::remove_if(all.begin() + first, all.end(), [](const Projection& p) { return p.cell < 0; }) -
               all.begin());
}

// Returns how many projections there would be instead of those from index `first` on, if all trials were drawn. Tickets
// below the least share are drawn in all cells, so these are counted.
[[nodiscard]] double whole_count(const LayerCandidates& layer, std::int64_t first) noexcept {
    const double limit = layer.least_share * 4294967296.0;
    const auto counted = std::count_if(layer.projection.begin() + first, layer.projection.end(),
                                       [&](const Projection& p) { return static_cast<double>(p.ticket) < limit; });
    return static_cast<double>(counted) / layer.least_share;
}

// ---- 4. Both kinds together

// Stores the candidates of both kinds cell by cell. Each cell has separate groups. Cells without candidates are left
// out.
void merge(const marks::Site& site, const ClassifiedCells& classified, const PlaneCandidates& planes,
           const LayerCandidates& layer, Candidates& candidates, const NeededCells* needed) {
    const std::int64_t count = classified.cells.cell.size();
    // For each cell: the place of its next candidate; at first, the number of candidates.
    base::Array<std::int64_t> next(site.memory(), count);
    const auto is_needed = [&](const Projection& p) {
        return needed == nullptr ||
               double{needed->candidate_share[p.cell]} * 4294967296.0 > static_cast<double>(p.ticket);
    };
    for (const Projection& projection : layer.projection) next[projection.cell] += is_needed(projection) ? 1 : 0;
    std::int64_t groups = 0;
    for (std::int64_t cell = 0; cell < count; ++cell) {
        const std::int64_t number = next[cell] + planes.count[cell];
        next[cell] = OrderGroup::size * groups;
        if (number == 0) continue;
        candidates.code.push_back(classified.cells.cell[cell].code);
        candidates.number.push_back(static_cast<std::int32_t>(number));
        candidates.first.push_back(next[cell]);
        candidates.count += number;
        groups += groups_for(number);
        if (needed == nullptr) continue;
        candidates.share.push_back(needed->share[cell]);
        const double density = classified.kind(cell) == CellKind::flat ? 1.0 : stipple_tuning.layer_density;
        const double all = static_cast<double>(number) / double{needed->candidate_share[cell]};
        candidates.relative_area.push_back(static_cast<float>(all / density));
    }
    candidates.group.resize_for_overwrite(groups);
    candidates.ticket.resize_for_overwrite(OrderGroup::size * groups);
    site.work.for_chunks(count, cells_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t cell = begin; cell < end; ++cell)
            if (planes.count[cell] > 0) store_plane_candidates(site, classified, cell, planes, next[cell], candidates);
    });
    for (const Projection& projection : layer.projection)
        if (is_needed(projection))
            store_candidate(projection.position, projection.normal, projection.ticket, next[projection.cell]++,
                            candidates);
}

} // namespace

ClassifiedCells classify_cells(const marks::Site& site, const SurfaceCells& cells) {
    ClassifiedCells classified(cells);
    const std::int64_t count = cells.cell.size();
    site.work.for_chunks(count, cells_a_task, [&](std::int64_t begin, std::int64_t end) {
        CellMap::BlocksAround blocks;
        for (std::int64_t i = begin; i < end; ++i)
            classified.cell[i] = classify_cell(site, cells, classified.number, i, blocks);
    });
    return classified;
}

PlaneCandidates draw_on_planes(const marks::Site& site, const ClassifiedCells& classified, std::uint32_t stream,
                               double density, double most_trials, const NeededCells* needed) {
    HRBFNPR_ASSERT(density > 0.0);
    constexpr double most_of_cell = 1e6; // Limits the trials of a cell, so that their numbers fit into 32 bits.
    const auto flat =
        static_cast<double>(std::count_if(classified.cell.begin(), classified.cell.end(),
                                          [](const ClassifiedCell& c) { return c.kind == CellKind::flat; }));
    PlaneCandidates planes{stream | 0xffff0000U, density, std::min(most_trials / std::max(flat, 1.0), most_of_cell),
                           base::Array<std::int32_t>(site.memory(), classified.cell.size())};
    base::Array<std::int32_t> all(site.memory(), classified.cell.size()); // the number in each cell, needed or not
    site.work.for_chunks(classified.cell.size(), cells_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            site.work.check(); // A cell may have many trials, so this checks for cancellation.
            if (classified.kind(i) != CellKind::flat) continue;
            const double share = needed != nullptr ? double{needed->candidate_share[i]} : 1.0;
            for_candidates_on_plane(site, classified.cells, i, planes, [&](const glm::dvec3&, double ticket) {
                ++all[i];
                if (ticket < share) ++planes.count[i];
            });
        }
    });
    planes.all = std::accumulate(all.begin(), all.end(), std::int64_t{0});
    return planes;
}

// Estimates the area of the surface: the volume of the cells, times the share of the projections that were kept,
// divided by the thickness of the layer, 2 band. Only projections in the region and in cells that are not flat are
// kept. Before the first draw, the estimate is the volume divided by the thickness of the layer that the cells fill, 2
// reach.
double LayerCandidates::area() const noexcept {
    if (rounds == 0) return volume / (2.0 * reach);
    if (near == 0) return 0.0;
    return whole / (static_cast<double>(projections_per_trial) * trials) * volume / (2.0 * band);
}

NeededCells find_needed_cells(const marks::Site& site, const SurfaceCells& cells, const marks::Need& need,
                              std::int64_t wanted, std::int64_t candidates) {
    const auto many = static_cast<double>(candidates);
    const double least =
        std::min(1.0, std::max(stipple_tuning.least_candidate_share, stipple_tuning.fewest_for_area / many));
    base::Array<float> share = needed_shares(site, cells, need, wanted);
    base::Array<float> of_candidates =
        candidate_shares(site.work, cells, share, {cells.rough_area(), cells.grid.side, wanted}, many, least);
    return {std::move(share), std::move(of_candidates), least};
}

LayerCandidates layer_candidates(const ClassifiedCells& classified, std::uint32_t stream, std::int64_t wanted,
                                 const NeededCells* needed) {
    HRBFNPR_ASSERT(wanted > 0);
    const SurfaceCells& cells = classified.cells;
    const double side = cells.grid.side;
    LayerCandidates layer(cells.cell.memory());
    layer.stream = stream;
    layer.reach = cells.reach();
    layer.band = cells.band;
    // The number of projections for each trial. Small cells get fewer, because the order cannot distinguish candidates
    // so close to each other.
    constexpr std::int64_t most = stipple_tuning.most_projections;
    // The mean distance between marks. Each mark needs about `most` candidates.
    const double spacing = std::sqrt(cells.rough_area() * most / static_cast<double>(wanted));
    layer.projections_per_trial = std::clamp<std::int64_t>(std::lround(0.5 * most * side / spacing), 1, most);
    // A projection is less than a side away from its trial: sqrt(band^2 + 2 stride^2) = 0.93 sides.
    // A bent cell needs as many trials in the cells around it.
    if (needed != nullptr) layer.least_share = needed->least_share;
    CellMap::BlocksAround blocks;
    base::Array<float> taken(cells.cell.memory(), classified.cell.size());
    for (std::int64_t i = 0; i < classified.cell.size(); ++i) {
        if (classified.kind(i) != CellKind::bent) continue;
        const float share = needed != nullptr ? needed->candidate_share[i] : 1.0F;
        for (const std::int32_t next : classified.number.around(cells.cell[i].code, blocks))
            if (next >= 0) taken[next] = std::max(taken[next], share);
    }
    for (std::int64_t i = 0; i < taken.size(); ++i) {
        if (!(taken[i] > 0.0F)) continue;
        layer.trial_cell.push_back(static_cast<std::int32_t>(i));
        layer.trial_share.push_back(taken[i]);
    }
    layer.volume = static_cast<double>(layer.trial_cell.size()) * side * side * side;
    return layer;
}

void draw_in_layer(const marks::Site& site, const ClassifiedCells& classified, double density, LayerCandidates& layer) {
    const std::int64_t cells = layer.trial_cell.size();
    const double missing = density * layer.area() - layer.whole;
    if (cells == 0 || !(missing > 0.0)) return;
    // The mean number of projections for each trial.
    double of_trial = layer.whole / layer.trials;
    if (layer.rounds == 0)
        of_trial = static_cast<double>(layer.projections_per_trial) * 2.0 * layer.band * layer.area() / layer.volume;
    const double per_cell =
        missing / std::max(of_trial, stipple_tuning.least_projections_per_trial) / static_cast<double>(cells);
    const std::uint32_t stream = (layer.stream + marks::stream_count * layer.rounds++) << 16U;
    base::Array<std::int64_t> slot(site.memory()); // for each cell: where its trials begin in the batch; and the end
    geometry::VecArray trial(site.memory());
    base::Array<TrialTicket> ticket(site.memory());
    base::Array<Projection> projection(site.memory());
    const marks::Site standing = site.without_progress();
    for (std::int64_t begin = 0, end = 0; begin < cells; begin = end) {
        slot.clear();
        slot.push_back(0);
        for (; end < cells && slot.back() < points_a_batch; ++end) {
            const std::uint64_t code = classified.cells.cell[layer.trial_cell[end]].code;
            const double extra = base::uniform4(site.random_seed, code, base::Purpose::candidate, stream)[0];
            const double share{layer.trial_share[end]};
            const auto count = static_cast<std::int64_t>(std::min(per_cell * share + extra, 65535.0));
            slot.push_back(slot.back() + count);
            layer.trials += static_cast<double>(count) / share;
        }
        const auto batch = static_cast<std::size_t>(begin);
        const std::size_t cells_of_batch = slot.span().size() - 1;
        draw_trials(site, classified.cells, layer.trial_cell.span().subspan(batch, cells_of_batch),
                    layer.trial_share.span().subspan(batch, cells_of_batch), slot.span(), stream, trial, ticket);
        const std::int64_t first = layer.projection.size();
        project_trials(standing, classified, trial, ticket, projection, layer);
        refine_projections(standing, classified, first, layer);
        layer.whole += whole_count(layer, first);
        site.work.update(static_cast<double>(end) / static_cast<double>(cells));
    }
}

Candidates draw_candidates(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted, marks::Kind kind,
                           const NeededCells* needed) {
    Candidates candidates(site.memory());
    candidates.grid = cells.grid;
    candidates.region = cells.region;
    if (cells.cell.empty()) return candidates;
    const std::uint32_t stream = marks::stream_of(kind);
    const ClassifiedCells classified = classify_cells(site, cells);
    LayerCandidates layer = layer_candidates(classified, stream, wanted, needed);
    // If f is not like a distance, the area computed from cells is wrong, and the first round gives too few candidates.
    const auto many = static_cast<double>(wanted);
    double density = many / cells.rough_area();
    PlaneCandidates planes{stream, density, 0.0, base::Array<std::int32_t>(site.memory())};
    for (int round = 0; round < stipple_tuning.candidate_rounds; ++round) {
        planes = draw_on_planes(site, classified, stream, density, stipple_tuning.most_trials * many, needed);
        draw_in_layer(site.part(round == 0 ? 0.0 : 0.7, round == 0 ? 0.7 : 0.8), classified,
                      stipple_tuning.layer_density * density, layer);
        const double placed = static_cast<double>(planes.all) + layer.whole / stipple_tuning.layer_density;
        if (placed >= stipple_tuning.candidates_share * many || !(placed > 0.0)) break;
        density *= many / placed;
    }
    candidates.area = planes.area() + layer.area();
    candidates.whole = static_cast<double>(planes.all) + layer.whole;
    merge(site, classified, planes, layer, candidates, needed);
    candidates.report.placed = candidates.count;
    candidates.report.dropped_strayed = layer.strayed;
    candidates.report.attempted = candidates.report.placed + candidates.report.dropped_strayed;
    site.work.update(1.0);
    return candidates;
}

} // namespace hrbfnpr::stipples
