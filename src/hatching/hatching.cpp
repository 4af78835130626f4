// SPDX-License-Identifier: MIT
#include "hatching/hatching.h"

#include "creases/creases.h"
#include "curves/tuning.h"
#include "geometry/point_grid.h"
#include "hatching/lines.h"
#include "stipples/blue_noise.h"
#include "surface/creased.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::hatching {
namespace {

// If lines are a separation apart, their total length is area / separation.
double separation_of(const Settings& settings, double area) noexcept {
    if (settings.separation > 0.0) return settings.separation;
    const auto budget = static_cast<double>(std::max<std::int64_t>(settings.budget, 1));
    return settings.step > 0.0 ? area / (settings.step * budget) : std::sqrt(area / (hatching_tuning.step * budget));
}

double step_of(const Settings& settings, double separation) noexcept {
    return settings.step > 0.0 ? settings.step : hatching_tuning.step * separation;
}

void require_room(const marks::Site& site, const Settings& settings, double area) {
    const double separation = separation_of(settings, area);
    const double step = step_of(settings, separation);
    const double marks = area / (separation * step);
    if (marks > static_cast<double>(marks::most_even_marks))
        fail(Status::invalid_argument,
             "layers[%lld]: a separation of %g and a step of %g make about %.2g marks, more than %lld; use larger ones",
             static_cast<long long>(settings.layer), site.unit * separation, site.unit * step, marks,
             static_cast<long long>(marks::most_even_marks));
    // The work depends on the separation of lines, not on the number of marks: with a large step there are few marks,
    // but all lines must still be found.
    const double squares = area / (separation * separation);
    if (squares > static_cast<double>(marks::most_even_marks))
        fail(Status::invalid_argument,
             "layers[%lld]: a step of %g makes too many lines, %g apart; use a larger separation or a smaller step",
             static_cast<long long>(settings.layer), site.unit * step, site.unit * separation);
}

// The part of the surface that is near places of marks that a still picture needs.
class NeededPart final : public implicit::Domain {
public:
    // `reach` is the largest half side of the cubes that are asked about.
    NeededPart(const geometry::VecArray& places, double reach, double spacing, const implicit::Domain* whole,
               const base::Progress& progress)
        : grid_(places, reach + spacing, progress), place_(grid_.in_order(places, progress)), spacing_(spacing),
          whole_(whole) {}

    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& gradient) const override {
        return whole_ != nullptr ? whole_->beyond(place, gradient) : -1.0;
    }
    [[nodiscard]] bool has_no_surface_in(const glm::dvec3& centre, double half) const noexcept override {
        if (whole_ != nullptr && whole_->has_no_surface_in(centre, half)) return true;
        bool found = false;
        grid_.around(centre, [&](std::int64_t at) {
            const glm::dvec3 way = glm::abs(place_[at] - centre);
            found = found || std::max({way.x, way.y, way.z}) <= half + spacing_;
        });
        return !found;
    }

private:
    geometry::PointGrid grid_;
    geometry::VecArray place_;
    double spacing_; // the distance between places
    const implicit::Domain* whole_;
};

// Makes the mesh on which lines are found. If only a part of the lines is needed, it covers only the samples whose
// neighbourhood may be shown.
curves::SurfaceMesh mesh_for_lines(const marks::Site& site, const SampleGraph& samples, double separation,
                                   curves::MeshSettings& settings) {
    settings.tolerance = hatching_tuning.vertex_tolerance * separation / site.implicit.diagonal();
    settings.domain = site.implicit.domain();
    if (site.need == nullptr) return triangulate_of_any_size(site.work, site.implicit, samples.position, settings);
    geometry::VecArray needed(site.memory());
    for (const std::int64_t i : site.work.over(samples.position.size()))
        if (site.need->may_show(samples.position[i], samples.normal[i], hatching_tuning.beyond_shown * separation))
            needed.push_back(samples.position[i]);
    if (needed.empty()) return curves::SurfaceMesh(site.memory());
    settings.block_side = hatching_tuning.needed_block;
    const double reach =
        (0.5 * static_cast<double>(settings.block_side) + curves::curve_tuning.beyond_end) * settings.side;
    const NeededPart part(needed, reach, samples.spacing, settings.domain, site.work);
    settings.domain = &part;
    return triangulate_of_any_size(site.work, site.implicit, needed, settings);
}

// Returns for each sample whether the drawing may need marks near it; nothing if it needs all marks.
base::Array<std::uint8_t> needed_samples(const marks::Site& site, const SampleGraph& samples, double separation) {
    base::Array<std::uint8_t> needed(site.memory());
    if (site.need == nullptr) return needed;
    needed.resize(samples.position.size());
    const double reach = hatching_tuning.beyond_shown * separation;
    for (const std::int64_t i : site.work.over(needed.size()))
        needed[i] = site.need->share(samples.position[i], samples.normal[i], reach) > 0.0 ? 1 : 0;
    return needed;
}

} // namespace

bool Settings::shares_field_with(const Settings& other) const noexcept {
    return separation == other.separation && step == other.step && (separation > 0.0 || budget == other.budget) &&
           field == other.field && direction == other.direction;
}

HatchingField::HatchingField(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings)
    : settings_(settings), region_(cells.region), is_whole_(site.need == nullptr), graph_(site.memory()),
      angle_(site.memory()), mesh_(site.memory()), sheet_(site.memory()) {
    require_room(site, settings, cells.rough_area());
    const double spacing = hatching_tuning.sample_spacing * separation_of(settings, cells.rough_area());
    const auto samples = static_cast<std::int64_t>(std::min(cells.rough_area() / (spacing * spacing), 1e9));
    stipples::EvenMarks even = stipples::spread_evenly(
        site.part(0.0, 0.4), cells, std::clamp(samples, hatching_tuning.fewest_samples, hatching_tuning.most_samples),
        marks::Kind::stipples);
    area_ = even.area > 0.0 ? even.area : cells.rough_area();
    graph_.spacing = std::sqrt(area_ / static_cast<double>(even.position.size()));
    graph_.position = std::move(even.position);
    graph_.normal = std::move(even.normal);
    graph_.sheet = surface::sheets_at(site.work, site.implicit, graph_.position);
    link_samples(site.work.part(0.4, 0.46), graph_);
    angle_ = line_angles(site.part(0.46, 0.64), graph_, settings.field, settings.direction);
    curves::MeshSettings mesh;
    mesh.region = region_;
    const double separation = separation_of(settings, area_);
    mesh.side = std::max(hatching_tuning.mesh_side * separation, std::sqrt(area_ / hatching_tuning.most_cells));
    mesh_ = mesh_for_lines(site.part(0.64, 0.94), graph_, separation, mesh);
    if (site.implicit.sheets() == nullptr || mesh_.triangles() == 0) return;
    // The mesh is split at creases, so that lines end there.
    curves::SharpMesh sharp = split_at_creases(site.work.part(0.94, 1.0), site.implicit, std::move(mesh_));
    mesh_ = std::move(sharp.mesh);
    sheet_.resize(mesh_.vertices());
    for (std::int64_t i = 0; i < mesh_.corner.size(); ++i) sheet_[mesh_.corner[i]] = sharp.sheet[i / 3];
}

void HatchingField::place_lines(const marks::Site& site, const Settings& settings, marks::Marks& marks,
                                marks::LayerReport& report) const {
    require_room(site, settings, area_);
    const double separation = separation_of(settings, area_);
    HRBFNPR_ASSERT(separation > 0.0 && graph_.nodes() == angle_.size());
    HRBFNPR_ASSERT(is_whole_ || site.need != nullptr);
    const double octaves = std::log2(std::sqrt(area_) / (hatching_tuning.fewest_lines * separation));
    const int levels = std::max(static_cast<int>(std::floor(octaves)), 0);
    Waves samples(site.memory(), graph_.position, std::ldexp(separation, levels));
    for (std::int64_t i = 0; i < graph_.nodes(); ++i)
        samples.set_line(i, graph_.normal[i], graph_.tangent(i, angle_[i] + settings.angle));
    report.step = separation;
    report.levels = levels;
    const double expected = area_ / (separation * step_of(settings, separation));
    // This is 0 if the separation is too large for the surface.
    if (site.need != nullptr) marks.whole = static_cast<std::int64_t>(expected);
    if (mesh_.triangles() == 0) return;
    add_sample_waves(site.work.part(0.0, 0.4), graph_, site.random_seed, levels, samples);
    const base::Array<std::uint8_t> needed = needed_samples(site, graph_, separation);
    const Waves waves = waves_at_vertices(site.work.part(0.4, 0.56), graph_, samples, needed, mesh_, sheet_, levels);
    const base::Work rest = site.work.part(0.56, 0.6);
    Lines lines = find_crests(rest, mesh_, waves, levels);
    lines = join_ends(lines, hatching_tuning.widest_gap * separation, rest);
    lines = even_out(rest, lines, separation);
    add_line_marks(site.part(0.6, 1.0), lines, separation, step_of(settings, separation), region_, marks, report);
    if (site.need != nullptr) marks.whole = std::max(marks.whole, marks.count());
}

} // namespace hrbfnpr::hatching
