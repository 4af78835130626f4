// SPDX-License-Identifier: MIT
#include "stipples/blue_noise.h"

#include "base/long_array.h"
#include "base/sort.h"
#include "geometry/long_vec_array.h"
#include "geometry/point_grid.h"
#include "stipples/candidates.h"
#include "stipples/tuning.h"
#include "surface/curvature.h"

#include <algorithm>
#include <cmath>
#include <compare>
#include <functional>
#include <optional>
#include <utility>

namespace hrbfnpr::stipples {
namespace {

// Returns the longest side of the box around all cells, in cells.
std::int64_t cells_across(const SurfaceCells& cells) noexcept {
    if (cells.cell.empty()) return 0;
    geometry::CellGrid::Cell low = geometry::morton_cell(cells.cell[0].code);
    geometry::CellGrid::Cell high = low;
    for (const SurfaceCell& cell : cells.cell) {
        const geometry::CellGrid::Cell at = geometry::morton_cell(cell.code);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], at[axis]);
            high[axis] = std::max(high[axis], at[axis]);
        }
    }
    return 1 + std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

// Returns the region for marks: the box of the samples with a margin. The surface is known only close to its samples.
// Farther sheets of the function, and the continuation of an open sheet, stay outside.
geometry::Bounds region_of(const marks::Site& site, const marks::Seeds& seeds, double sample_spacing) {
    const geometry::Bounds& bounds = site.implicit.bounds();
    const double diagonal = site.implicit.diagonal();
    const double margin = bounds.diagonal() > 0.0 ? std::clamp(sample_spacing, stipple_tuning.least_margin * diagonal,
                                                               stipple_tuning.most_margin * diagonal)
                                                  // For a single sample, the region contains a square of the sample's
                                                  // tangent plane.
                                                  : 0.5 * diagonal;
    geometry::Bounds region = bounds.grown(margin);
    const auto inside = [&] {
        for (std::int64_t i = 0; i < seeds.position.size(); ++i)
            if (region.contains(seeds.position[i])) return true;
        return false;
    };
    // If the caller chose seed points, the region is enlarged to contain them. If no seed is inside, it is enlarged to
    // contain all seeds.
    if (seeds.source == marks::SeedSource::points || !inside())
        for (std::int64_t i = 0; i < seeds.position.size(); ++i) region.extend(seeds.position[i]);
    return region;
}

// Removes marks that projection has brought too close to each other, as it may where the surface bends within the
// spacing of marks. The later of the two marks is dropped and counted as strayed. The least distance depends on the
// place of the later mark in the order, so marks are processed in ranges of the order in which the distance is similar.
// `wandered` has, in ascending order, the indices of the marks that projection moved far. If marks.place is not empty,
// it has the number of marks of the whole order up to each mark.
void repair_distances(const marks::Site& site, const base::Array<std::int64_t>& wandered, EvenMarks& marks,
                      marks::LevelReport& report) {
    HRBFNPR_ASSERT(std::is_sorted(wandered.begin(), wandered.end()));
    struct Pair {
        std::int64_t later, earlier;
        [[nodiscard]] auto operator<=>(const Pair& other) const noexcept = default;
    };
    const std::int64_t count = marks.position.size();
    const auto apart = [&](std::int64_t later) {
        return stipple_tuning.least_apart *
               densest_distance(marks.area, marks.place.empty() ? static_cast<double>(later + 1) : marks.place[later]);
    };
    base::Array<Pair> pairs(site.memory());
    geometry::VecArray position(site.memory());
    for (std::int64_t begin = 0, end = 1; begin < count; begin = end, end = std::min(4 * end, count)) {
        while (position.size() < end) position.push_back(marks.position[position.size()]);
        const geometry::PointGrid grid(position, apart(begin));
        for (const std::int64_t i : wandered) {
            if (i >= end) break;
            grid.around(marks.position[i], [&](std::int64_t at) {
                const std::int64_t k = grid.index(at);
                const std::int64_t later = std::max(i, k);
                if (i == k || later < begin) return;
                const glm::dvec3 between = marks.position[i] - marks.position[k];
                if (glm::dot(between, between) >= apart(later) * apart(later)) return;
                if (glm::dot(marks.normal[i], marks.normal[k]) >= 0.0) pairs.push_back({later, std::min(i, k)});
            });
        }
    }
    std::sort(pairs.begin(), pairs.end());
    base::Array<std::uint8_t> dropped(site.memory(), count);
    for (const Pair& pair : pairs)
        if (dropped[pair.earlier] == 0) dropped[pair.later] = 1;
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        if (dropped[i] != 0) continue;
        marks.position.set(kept, marks.position[i]);
        if (!marks.place.empty()) marks.place[kept] = marks.place[i];
        marks.normal.set(kept++, marks.normal[i]);
    }
    report.placed = kept;
    report.dropped_strayed += count - kept;
    marks.position.resize(kept);
    marks.normal.resize(kept);
    if (!marks.place.empty()) marks.place.resize(kept);
}

// Projects the chosen marks. If a mark does not converge, it is left out and counted.
void project(const marks::Site& site, const SurfaceCells& cells, const OrderedMarks& chosen, EvenMarks& marks) {
    const std::int64_t all = chosen.size();
    const bool is_whole = chosen.place.empty();
    const auto share = [&](std::int64_t i) { return static_cast<double>(i) / static_cast<double>(all); };
    marks.position.reserve(all);
    marks.normal.reserve(all);
    marks::MarkProjector projector(site);
    marks::LevelReport report;
    base::Array<std::int64_t> wandered(site.memory());
    for (std::int64_t begin = 0; begin < all; begin += points_a_batch) {
        const std::int64_t count = std::min(all - begin, points_a_batch);
        projector.start.clear();
        for (std::int64_t i = begin; i < begin + count; ++i) {
            const float(&p)[3] = chosen.mark[i].position;
            projector.start.push_back(cells.grid.origin + glm::dvec3(p[0], p[1], p[2]));
        }
        // A mark that moves farther than a cell's side has reached another sheet.
        projector.project(cells.grid.side, report, site.work.part(share(begin), share(begin + count)));
        for (const std::int64_t i : site.work.over(count)) {
            if (!projector.placed(i)) continue;
            if (!cells.region.contains(projector.position(i))) {
                projector.drop(i, report.dropped_strayed, report);
                continue;
            }
            const glm::dvec3 normal = projector.normal(i);
            float n[3];
            unpack_normal(chosen.mark[begin + i].normal, n);
            const double packing = densest_distance(marks.area, chosen.place_of(begin + i));
            if (glm::distance(projector.position(i), projector.start[i]) > stipple_tuning.wandered_distance * packing ||
                glm::dot(normal, glm::dvec3(n[0], n[1], n[2])) <
                    stipple_tuning.wandered_cosine * double{unpacked_length})
                wandered.push_back(marks.position.size());
            geometry::push_back_long(marks.position, projector.position(i), site.work);
            geometry::push_back_long(marks.normal, normal, site.work);
            if (!is_whole) base::push_back_long(marks.place, chosen.place[begin + i], site.work);
        }
    }
    if (!wandered.empty()) repair_distances(site, wandered, marks, report);
    if (!is_whole && all > 0) {
        for (double& place : marks.place) place /= chosen.whole;
        marks.whole = std::llround(chosen.whole * static_cast<double>(report.placed) / static_cast<double>(all));
    }
    marks.report.dropped_budget = marks.report.placed - all;
    marks.report.placed = report.placed;
    marks.report.dropped_not_converged += report.dropped_not_converged;
    marks.report.dropped_strayed += report.dropped_strayed;
    marks.report.dropped_degenerate += report.dropped_degenerate;
}

// ---- Densities

// Returns the density at each mark. The bend of a mark is the root mean square of its principal curvatures. The first
// call sets `mean_bend` to the mean over its marks; later calls use this mean.
[[nodiscard]] base::Array<double> densities_by_curvature(const marks::Site& site, const EvenMarks& marks,
                                                         double strength, std::optional<double>& mean_bend) {
    HRBFNPR_ASSERT(strength >= 0.0 && strength <= 1.0);
    base::Array<surface::Curvature> curvature(site.memory());
    surface::principal_curvatures(site.work, site.implicit, marks.position, curvature);
    base::Array<double> density(site.memory(), marks.position.size());
    for (std::int64_t i = 0; i < density.size(); ++i) {
        const double bend = std::sqrt(0.5 * (curvature[i].k1 * curvature[i].k1 + curvature[i].k2 * curvature[i].k2));
        density[i] = std::isfinite(bend) ? bend : 0.0;
    }
    if (!mean_bend) {
        mean_bend = 0.0;
        for (const double bend : density) *mean_bend += bend / static_cast<double>(density.size());
    }
    for (const std::int64_t i : site.work.over(density.size())) {
        const double relative = *mean_bend > 0.0 ? density[i] / (density[i] + *mean_bend) : 0.5;
        density[i] = 1.0 - strength + strength * relative;
    }
    return density;
}

[[nodiscard]] base::Array<double> densities_by_function(const marks::Site& site, const EvenMarks& marks,
                                                        const DensitySettings& settings) {
    base::Array<double> density = marks::call_at_points(site, settings.function, settings.user, "density_function",
                                                        marks.position, marks.normal, 1);
    for (double& number : density) {
        if (!(number >= 0.0))
            fail(Status::callback, "density_function gave %g; a density must be a number from 0 to 1", number);
        number = std::min(number, 1.0);
    }
    return density;
}

} // namespace

SurfaceCells cover_surface(const marks::Site& site, const marks::Seeds& seeds, double sample_spacing,
                           std::int64_t marks) {
    const geometry::Bounds region = region_of(site, seeds, sample_spacing);
    const double diagonal = region.diagonal();
    SurfaceCells cells(site.memory());
    // If a small surface is in a large box, its estimated area is correct only if cells are small, too. So cells are
    // found again until the estimate asks for no smaller cells.
    const double finest = diagonal / stipple_tuning.most_in_diagonal;
    double side = diagonal / stipple_tuning.fewest_in_diagonal;
    for (int round = 0; round < stipple_tuning.cover_rounds; ++round) {
        // Only small surfaces in large boxes need more than one round.
        const base::Work part = site.work.part(1.0 - std::exp2(-round), 1.0 - std::exp2(-round - 1));
        cells = find_surface_cells(site.with(part), seeds.position, region, side);
        const double spacing = std::sqrt(cells.rough_area() / static_cast<double>(marks));
        // If there are too few cells, the area is unknown.
        const bool known = cells_across(cells) >= stipple_tuning.fewest_across;
        const double wanted = known ? std::max(stipple_tuning.cell_spacings * spacing, finest)
                                    : std::max(stipple_tuning.missed_surface_step * side, finest);
        if (wanted > stipple_tuning.fine_side_share * side) break;
        side = wanted;
    }
    if (cells_across(cells) < stipple_tuning.fewest_across)
        fail(Status::invalid_argument,
             "the surface is at most %.2g across, but its bounding box is %.2g; give bounds_min and bounds_max that "
             "fit it (at most %g times as wide)",
             site.unit * side * static_cast<double>(cells_across(cells)), site.unit * diagonal,
             stipple_tuning.most_in_diagonal / static_cast<double>(stipple_tuning.fewest_across));
    return cells;
}

EvenMarks spread_evenly(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted, marks::Kind kind,
                        const marks::Need* need) {
    const auto of_marks = static_cast<std::int64_t>(stipple_tuning.candidates_per_mark * static_cast<double>(wanted));
    const std::int64_t many = std::max(of_marks, stipple_tuning.fewest_candidates);
    std::optional<NeededCells> needed;
    if (need != nullptr && !cells.cell.empty()) needed = find_needed_cells(site, cells, *need, wanted, many);
    Candidates candidates =
        draw_candidates(site.part(0.0, 0.5), cells, many, kind, needed.has_value() ? &*needed : nullptr);
    const OrderedMarks chosen = progressive_order(site.part(0.5, 0.9), candidates, wanted);
    EvenMarks marks(site.memory());
    marks.report = candidates.report;
    marks.area = candidates.area;
    project(site.part(0.9, 1.0), cells, chosen, marks);
    if (marks.position.empty())
        fail(Status::not_converged,
             "no mark could be placed in %lld cells: of %lld points, %lld did not converge, %lld strayed, %lld were "
             "degenerate; raise projection_tolerance, or use distribution PUBLISHED",
             static_cast<long long>(cells.cell.size()), static_cast<long long>(marks.report.attempted),
             static_cast<long long>(marks.report.dropped_not_converged),
             static_cast<long long>(marks.report.dropped_strayed),
             static_cast<long long>(marks.report.dropped_degenerate));
    return marks;
}

EvenMarks spread_by_density(const marks::Site& site, const SurfaceCells& cells, std::int64_t wanted,
                            const DensitySettings& density) {
    if (density.kind == Density::uniform) return spread_evenly(site, cells, wanted, marks::Kind::stipples, site.need);
    std::optional<double> mean_bend;
    const auto densities = [&](const EvenMarks& marks, const base::Progress& part) {
        return density.kind == Density::curvature
                   ? densities_by_curvature(site.with(part), marks, density.strength, mean_bend)
                   : densities_by_function(site.with(part), marks, density);
    };
    const EvenMarks probe = spread_evenly(site.part(0.0, 0.1), cells, stipple_tuning.probes, marks::Kind::stipples);
    double mean = 0.0;
    for (const double number : densities(probe, site.work.part(0.1, 0.15))) mean += number;
    mean /= static_cast<double>(probe.position.size());
    if (!(mean > 0.0))
        fail(Status::invalid_argument,
             "the density is 0 at all %lld places tried on the surface, so no mark can be made; let it be 1 where "
             "marks are densest",
             static_cast<long long>(probe.position.size()));
    // The largest number of marks of the even order, before marks are left out.
    const double most = stipple_tuning.most_excess * static_cast<double>(wanted);
    if (std::min(static_cast<double>(wanted), most * mean) < 0.5)
        fail(Status::invalid_argument,
             "the density is %.3g on average, which leaves none of %lld marks; let it be 1 where marks are densest",
             mean, static_cast<long long>(wanted));
    const double all = std::min(stipple_tuning.mean_error * static_cast<double>(wanted) /
                                    std::max(mean, 1.0 / stipple_tuning.most_excess),
                                static_cast<double>(marks::most_even_marks));
    const EvenMarks even =
        spread_evenly(site.part(0.15, 0.9), cells, static_cast<std::int64_t>(all), marks::Kind::stipples);
    const base::Array<double> at = densities(even, site.work.part(0.9, 1.0));
    struct Place {
        double key; // the place in the even order divided by the density
        std::int64_t mark;
        [[nodiscard]] bool operator<(const Place& other) const noexcept {
            return key != other.key ? key < other.key : mark < other.mark;
        }
    };
    base::Array<Place> places(site.memory());
    for (const std::int64_t i : site.work.over(at.size())) {
        const double key = (static_cast<double>(i) + 0.5) / at[i]; // infinite where the density is 0
        if (key < static_cast<double>(at.size())) places.push_back({key, i});
    }
    base::sort_long(places.begin(), places.end(), std::less<>(), site.work);
    const std::int64_t kept = std::min(wanted, places.size());
    if (kept == 0)
        fail(Status::invalid_argument, "the density leaves none of %lld marks; let it be 1 where marks are densest",
             static_cast<long long>(at.size()));
    EvenMarks marks(site.memory());
    marks.area = even.area;
    marks.report = even.report;
    for (const std::int64_t i : site.work.over(kept)) {
        marks.position.push_back(even.position[places[i].mark]);
        marks.normal.push_back(even.normal[places[i].mark]);
    }
    marks.report.placed = kept;
    marks.report.dropped_budget += even.position.size() - kept;
    return marks;
}

} // namespace hrbfnpr::stipples
