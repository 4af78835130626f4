// SPDX-License-Identifier: MIT
#include "stipples/layer_candidates.h"

#include "base/bits.h"
#include "base/random.h"
#include "geometry/morton.h"
#include "geometry/tangent_frame.h"
#include "stipples/order_loops.h"
#include "surface/creased.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace hrbfnpr::stipples {
namespace {

// Points that are evaluated at a time.
constexpr std::int64_t batch_points = 262144;
constexpr std::int64_t layer_cells_of_task = 512;
constexpr std::int64_t points_of_task = 4096;

// Candidates from each point that is evaluated: its projection, and others beside that in its tangent plane.  Fewer
// where cells are small to the distance of marks: they would be one to the order.
constexpr std::uint32_t most_projections = 5;
// How far beside at most along two axes, in sides of a cell; there a projection is as near to the surface as the first
// one.
constexpr double stride = 0.55;

// Cosine of the angle between a projection's normal and its cell's up to which the cell is flat.
constexpr double straight = 0.97;
// In sides of a cell: how far a cell's plane may be off, and when a projection is near enough to the surface.
constexpr double expected = 0.1;
constexpr double near_enough = 0.02;
constexpr int most_steps = 6;
// Projections that are looked at, to see whether one step is enough for the others.
constexpr std::int64_t every_projection = 67;

// Where fewer projections come of a trial, more trials are no help.
constexpr double least_of_trial = 1.0 / 256.0;

float packed(const glm::dvec3& normal) noexcept {
    return packed_normal({static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)});
}

std::int64_t projections_for(const SurfaceCells& cells, std::int64_t wanted) noexcept {
    const double spacing = std::sqrt(cells.rough_area() * most_projections / static_cast<double>(wanted)); // of marks
    const double projections = 0.5 * most_projections * cells.grid.side / spacing;
    return std::clamp(static_cast<std::int64_t>(std::lround(projections)), std::int64_t{1},
                      std::int64_t{most_projections});
}

} // namespace

LayerCandidates::LayerCandidates(const marks::Site& site, const SurfaceCells& cells, const CellMap& numbers,
                                 const base::Array<CellKind>& kind, std::uint32_t stream, std::int64_t wanted)
    : site_(site), cells_(cells), numbers_(numbers), kind_(kind), stream_(stream),
      projections_of_point_(projections_for(cells, wanted)), trial_cell_(site.memory()), slot_(site.memory()),
      drawn_(site.memory()), drawn_ticket_(site.memory()), trial_(site.memory()), trial_ticket_(site.memory()),
      field_(site.memory()), beside_(site.memory()), times_(site.memory()), kept_(site.memory()),
      near_of_task_(site.memory()), strayed_of_task_(site.memory()), bent_(site.memory()), landed_(site.memory()),
      projections_(site.memory()) {
    find_trial_cells();
}

// A projection is less than a side from its trial point: sqrt(band^2 + 2 stride^2) = 0.93 sides.
void LayerCandidates::find_trial_cells() {
    CellNeighbours around(numbers_);
    base::Array<std::uint8_t> taken(site_.memory(), kind_.size());
    for (std::int64_t i = 0; i < kind_.size(); ++i) {
        if (kind_[i] != CellKind::bent) continue;
        around.go_to(cells_.cell[i].code);
        for (std::size_t step = 0; step < CellNeighbours::count; ++step)
            if (around[step] >= 0) taken[around[step]] = 1;
    }
    for (std::int64_t i = 0; i < taken.size(); ++i)
        if (taken[i] != 0) trial_cell_.push_back(static_cast<std::int32_t>(i));
}

// near_ / trials_ is the part of the volume that is in the layer of thickness 2 band.  Of its area, what is in the
// region and in cells that are not flat is the same part as of the projections.
double LayerCandidates::area() const noexcept {
    const double side = cells_.grid.side;
    const auto volume = static_cast<double>(trial_cell_.size()) * side * side * side;
    if (rounds_ == 0) return volume / (2.0 * cells_.reach());
    if (near_ == 0) return 0.0;
    const double projections = static_cast<double>(projections_of_point_) * trials_;
    return static_cast<double>(projections_.size()) / projections * volume / (2.0 * cells_.band);
}

// Number 0 of a cell and round decides whether the fraction of a trial becomes one.
std::uint32_t LayerCandidates::count_in(const SurfaceCell& cell, double per_cell) const noexcept {
    const double extra = base::uniform4(site_.random_seed, cell.code, base::Purpose::candidate, stream_of_round_)[0];
    return static_cast<std::uint32_t>(std::min(per_cell + extra, 65535.0));
}

void LayerCandidates::draw_in(const SurfaceCell& cell, std::int64_t at, std::int64_t end) noexcept {
    const glm::dvec3 corner = cells_.grid.corner(geometry::morton_cell(cell.code));
    const double side = cells_.grid.side;
    // What the cell's plane calls this far off the band is not evaluated: its error within the cell is
    // 3/8 side^2 curvature, so this holds where the surface bends with radii above 1.5 sides, and not at creases.
    const double unlikely =
        site_.implicit.sheets() == nullptr ? cells_.band + 0.25 * side : std::numeric_limits<double>::infinity();
    for (std::uint32_t number = 1; at < end; ++at, ++number) {
        const auto u =
            base::uniform4(site_.random_seed, cell.code, base::Purpose::candidate, stream_of_round_ | number);
        const glm::dvec3 offset = side * glm::dvec3(u[0], u[1], u[2]);
        const double distance = cell.distance + glm::dot(cell.normal, offset - 0.5 * side);
        // A distance that is not a number goes on.
        const bool worth = !(std::abs(distance) > unlikely);
        drawn_.set(at, worth ? corner + offset : glm::dvec3(std::numeric_limits<double>::quiet_NaN()));
        drawn_ticket_[at] = static_cast<std::uint32_t>(u[3] * 4294967296.0);
    }
}

// Each task leaves what is worth evaluating at the front of its slots.
void LayerCandidates::draw_batch(std::int64_t cell_begin, std::int64_t cell_end) {
    const std::int64_t cells = cell_end - cell_begin;
    kept_.resize((cells + layer_cells_of_task - 1) / layer_cells_of_task);
    site_.runtime.parallel.for_chunks(cells, layer_cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) draw_in(trial_cell(cell_begin + i), slot_[i], slot_[i + 1]);
        std::int64_t to = slot_[begin];
        for (std::int64_t i = to; i < slot_[end]; ++i) {
            if (std::isnan(drawn_.x[i])) continue;
            drawn_.set(to, drawn_[i]);
            drawn_ticket_[to++] = drawn_ticket_[i];
        }
        kept_[begin / layer_cells_of_task] = to - slot_[begin];
    });
    const std::int64_t count = std::accumulate(kept_.begin(), kept_.end(), std::int64_t{0});
    trial_.resize(count);
    trial_ticket_.resize(count);
    std::int64_t to = 0;
    for (std::int64_t task = 0; task < kept_.size(); to += kept_[task++]) {
        const std::int64_t from = slot_[task * layer_cells_of_task];
        std::copy_n(drawn_.x.data() + from, kept_[task], trial_.x.data() + to);
        std::copy_n(drawn_.y.data() + from, kept_[task], trial_.y.data() + to);
        std::copy_n(drawn_.z.data() + from, kept_[task], trial_.z.data() + to);
        std::copy_n(drawn_ticket_.data() + from, kept_[task], trial_ticket_.data() + to);
    }
}

// -1: outside the region or the cells.
std::int32_t LayerCandidates::cell_of(const glm::dvec3& p) const noexcept {
    return cells_.region.contains(p) ? numbers_.find(geometry::morton_code(cells_.grid.cell_of(p))) : -1;
}

// Whether a cell's plane is wrong about one of its points.
bool LayerCandidates::surprises(const glm::dvec3& p, double distance) const noexcept {
    const std::int32_t number = cell_of(p);
    if (number < 0) return true;
    const SurfaceCell& cell = cells_.cell[number];
    const glm::dvec3 centre = cells_.grid.centre(geometry::morton_cell(cell.code));
    return !(std::abs(cell.distance + glm::dot(cell.normal, p - centre) - distance) <= expected * cells_.grid.side);
}

// The projections of a trial point; returns the end of those that are in the region and its cells.
Projection* LayerCandidates::land(std::int64_t i, double distance, std::uint32_t count, Projection* to,
                                  std::int64_t& strayed) const noexcept {
    const glm::dvec3 normal = glm::normalize(field_.gradient[i]);
    const geometry::TangentFrame frame = geometry::combing_frame(normal);
    const float bits = packed(normal);
    const glm::dvec3 projection = trial_[i] - distance * normal;
    const bool surprising = site_.implicit.sheets() != nullptr || surprises(trial_[i], distance);
    glm::dvec3 at = projection;
    std::uint32_t ticket = trial_ticket_[i];
    for (std::uint32_t k = 0; k < count; ++k) {
        const std::int32_t cell = cell_of(at);
        if (cell < 0 || !site_.implicit.holds(at, normal))
            ++strayed;
        else if (kind_[cell] != CellKind::flat)
            *to++ = {cell, ticket, glm::vec3(at - cells_.grid.origin), bits,
                     surprising || !(glm::dot(normal, cells_.cell[cell].normal) >= straight)};
        if (k + 1 == count) break;
        const base::Philox random = base::philox(
            site_.random_seed, {trial_ticket_[i], base::bit_cast<std::uint32_t>(static_cast<float>(projection.x)),
                                static_cast<std::uint32_t>(base::Purpose::candidate_order), k});
        constexpr double scale = 2.0 / 4294967296.0;
        const double u = random[1] * scale - 1.0;
        const double r = random[2] * scale - 1.0;
        at = projection + stride * cells_.grid.side * (u * frame.u + r * frame.r);
        ticket = random[0];
    }
    return to;
}

// Where there are creases: not at all, or twice.
void LayerCandidates::count_projections(const base::Progress& progress) {
    times_.resize(trial_.size());
    std::fill(times_.begin(), times_.end(), std::uint8_t{0});
    base::Array<std::int64_t> near(site_.memory());
    geometry::VecArray places(site_.memory()); // projections, and mirror images
    for (std::int64_t i = 0; i < trial_.size(); ++i) {
        const double distance = field_.distance(i);
        if (!(std::abs(distance) <= cells_.band)) continue;
        const glm::dvec3 down = distance * glm::normalize(field_.gradient[i]);
        near.push_back(i);
        places.push_back(trial_[i] - down);
        places.push_back(trial_[i] - 2.0 * down);
    }
    evaluate(site_, places, beside_, progress);
    for (std::int64_t k = 0; k < near.size(); ++k) {
        const glm::dvec3 normal = glm::normalize(field_.gradient[near[k]]);
        const auto is_alike = [&](std::int64_t place) {
            const glm::dvec3 other = beside_.gradient[place];
            return glm::dot(normal, other) >= surface::smooth_cosine * glm::length(other);
        };
        if (is_alike(2 * k)) times_[near[k]] = is_alike(2 * k + 1) ? 1 : 2;
    }
}

// Each task leaves its projections at the front of its part of landed_.
void LayerCandidates::step_down(const base::Progress& progress) {
    evaluate(site_, trial_, field_, progress);
    const bool creased = site_.implicit.sheets() != nullptr;
    if (creased) count_projections(progress);
    const std::int64_t most = (creased ? 2 : 1) * projections_of_point_;
    landed_.resize_for_overwrite(most * trial_.size());
    const std::int64_t tasks = (trial_.size() + points_of_task - 1) / points_of_task;
    kept_.resize(tasks);
    near_of_task_.resize(tasks);
    strayed_of_task_.resize(tasks);
    site_.runtime.parallel.for_chunks(trial_.size(), points_of_task, [&](std::int64_t begin, std::int64_t end) {
        Projection* const first = landed_.data() + most * begin;
        Projection* to = first;
        std::int64_t near = 0;
        std::int64_t strayed = 0;
        for (std::int64_t i = begin; i < end; ++i) {
            const double distance = field_.distance(i);
            if (!(std::abs(distance) <= cells_.band)) continue;
            const std::int64_t times = creased ? times_[i] : 1;
            if (times == 0) continue;
            near += times;
            to = land(i, distance, static_cast<std::uint32_t>(times * projections_of_point_), to, strayed);
        }
        kept_[begin / points_of_task] = to - first;
        near_of_task_[begin / points_of_task] = projections_of_point_ * near;
        strayed_of_task_[begin / points_of_task] = strayed;
    });
    const std::int64_t first = projections_.size();
    for (std::int64_t task = 0; task < tasks; ++task) {
        const std::int64_t before = projections_.size();
        near_ += near_of_task_[task];
        strayed_ += strayed_of_task_[task];
        projections_.resize_for_overwrite(before + kept_[task]);
        std::copy_n(landed_.data() + most * points_of_task * task, kept_[task], projections_.data() + before);
    }
    step_down_again(first, progress);
}

// Of a function that is no distance, of a square for one, planes tell the wrong distance alike at all points.
bool LayerCandidates::many_are_off(std::int64_t first, const base::Progress& progress) {
    trial_.clear();
    for (std::int64_t i = first; i < projections_.size(); i += every_projection)
        if (!projections_[i].bent) trial_.push_back(cells_.grid.origin + glm::dvec3(projections_[i].position));
    evaluate(site_, trial_, field_, progress);
    std::int64_t off = 0;
    for (std::int64_t k = 0; k < trial_.size(); ++k)
        if (!(std::abs(field_.distance(k)) <= expected * cells_.grid.side)) ++off;
    return 50 * off > trial_.size();
}

// Of a place in the tangent plane of another sheet than the one that is there: back over the crease, by as much as it
// was beyond.  Returns whether that was the case; the cell is -1 where it is of no use.
bool LayerCandidates::turns_back(Projection& projection, const glm::dvec3& place, double distance,
                                 const glm::dvec3& normal, bool first) const noexcept {
    float unpacked[3];
    unpack_normal(projection.normal, unpacked);
    const glm::dvec3 own = glm::normalize(glm::dvec3(unpacked[0], unpacked[1], unpacked[2]));
    const double agree = glm::dot(own, normal);
    if (agree >= surface::smooth_cosine) return false;
    const glm::dvec3 across = normal - agree * own;
    const double square = glm::dot(across, across);
    const glm::dvec3 at = place - 2.0 * distance / square * across;
    projection.cell = first && square > 0.01 ? cell_of(at) : -1;
    projection.position = glm::vec3(at - cells_.grid.origin);
    return true;
}

// Where a cell's plane does not tell how far its points are, one step is not enough.
void LayerCandidates::step_down_again(std::int64_t first, const base::Progress& progress) {
    if (!all_bent_) all_bent_ = many_are_off(first, progress);
    bent_.clear();
    for (std::int64_t i = first; i < projections_.size(); ++i)
        if (all_bent_ || projections_[i].bent) bent_.push_back(i);
    for (int step = 0; step < most_steps && !bent_.empty(); ++step) {
        trial_.clear();
        for (const std::int64_t i : bent_) trial_.push_back(cells_.grid.origin + glm::dvec3(projections_[i].position));
        evaluate(site_, trial_, field_, progress);
        std::int64_t left = 0;
        for (std::int64_t k = 0; k < bent_.size(); ++k) {
            Projection& projection = projections_[bent_[k]];
            const double distance = field_.distance(k);
            const bool near = std::abs(distance) <= cells_.band;
            const glm::dvec3 normal = near ? glm::normalize(field_.gradient[k]) : glm::dvec3(0.0);
            if (near && site_.implicit.sheets() != nullptr &&
                turns_back(projection, trial_[k], distance, normal, step == 0)) {
                if (projection.cell >= 0 && kind_[projection.cell] != CellKind::flat)
                    bent_[left++] = bent_[k];
                else
                    projection.cell = -1;
                continue;
            }
            const glm::dvec3 at = near ? trial_[k] - distance * normal : trial_[k];
            const std::int32_t cell = near && site_.implicit.holds(at, normal) ? cell_of(at) : -1;
            if (cell < 0 || kind_[cell] == CellKind::flat) {
                strayed_ += cell < 0 ? 1 : 0;
                projection.cell = -1; // it is no candidate after all
                continue;
            }
            projection = {cell, projection.ticket, glm::vec3(at - cells_.grid.origin), packed(normal), true};
            if (std::abs(distance) > near_enough * cells_.grid.side) bent_[left++] = bent_[k];
        }
        bent_.resize(left);
    }
    std::int64_t kept = first;
    for (std::int64_t i = first; i < projections_.size(); ++i)
        if (projections_[i].cell >= 0) projections_[kept++] = projections_[i];
    projections_.resize(kept);
}

void LayerCandidates::draw(double density, const base::Progress& progress) {
    const std::int64_t cells = trial_cell_.size();
    const double missing = density * area() - static_cast<double>(projections_.size());
    if (cells == 0 || !(missing > 0.0)) return;
    const double side = cells_.grid.side;
    const double volume = static_cast<double>(cells) * side * side * side;
    double of_trial = static_cast<double>(projections_.size()) / trials_; // projections
    if (rounds_ == 0) of_trial = static_cast<double>(projections_of_point_) * 2.0 * cells_.band * area() / volume;
    of_trial = std::max(of_trial, least_of_trial);
    const double per_cell = missing / of_trial / static_cast<double>(cells);
    stream_of_round_ = (stream_ + marks::stream_count * rounds_++) << 16U;
    for (std::int64_t begin = 0, end = 0; begin < cells; begin = end) {
        slot_.clear();
        std::int64_t slots = 0;
        for (; end < cells && slots < batch_points; ++end) {
            slot_.push_back(slots);
            slots += count_in(trial_cell(end), per_cell);
        }
        slot_.push_back(slots);
        trials_ += static_cast<double>(slots);
        drawn_.resize(slots);
        drawn_ticket_.resize(slots);
        draw_batch(begin, end);
        step_down(base::Progress(progress).part(0.0, 0.0));
        progress.update(static_cast<double>(end) / static_cast<double>(cells));
    }
}

} // namespace hrbfnpr::stipples
