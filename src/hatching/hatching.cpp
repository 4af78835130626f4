// SPDX-License-Identifier: MIT
#include "hatching/hatching.h"

#include "creases/crease_mesh.h"
#include "hatching/even_lines.h"
#include "hatching/join_lines.h"
#include "hatching/line_guides.h"
#include "hatching/line_marks.h"
#include "stipples/blue_noise.h"
#include "surface/creased.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::hatching {
namespace {

// Marks along a line, in separations.
constexpr double automatic_step = 0.4;
// Of samples: their spacing in separations, and how many there are at least.
constexpr double sample_spacing = 1.5;
constexpr std::int64_t fewest_samples = 4096;
// Lines of the coarsest level in the root of the area, and the most levels below it.
constexpr double fewest_lines = 6.0;
constexpr int most_levels = 10;
// The finest wave that samples know, in their spacings; between its crests there are others.
constexpr double finest_period = 1.5;
// ... and the finest that vertices of a mesh know, in its cells.
constexpr double finest_period_of_cells = 1.0;
// The mesh: triangles are about so many times the area over the square of a cell.
constexpr double triangles_a_cell = 12.0;
constexpr double most_triangles = 1.2e6;
// In separations: ends of lines that face each other over a gap that is no wider are joined.
constexpr double widest_gap = 2.0;

// Lines a separation apart have area / separation of length together.
double separation_of(const Settings& settings, double area) noexcept {
    if (settings.separation > 0.0) return settings.separation;
    const auto budget = static_cast<double>(std::max<std::int64_t>(settings.budget, 1));
    return settings.step > 0.0 ? area / (settings.step * budget) : std::sqrt(area / (automatic_step * budget));
}

double step_of(const Settings& settings, double separation) noexcept {
    return settings.step > 0.0 ? settings.step : automatic_step * separation;
}

void require_room(const marks::Site& site, const Settings& settings, double area) {
    const double separation = separation_of(settings, area);
    const double step = step_of(settings, separation);
    const double marks = area / (separation * step);
    if (marks > static_cast<double>(marks::most_even_marks))
        fail(Status::invalid_argument,
             "layers[%lld]: a separation of %g and a step of %g make about %g marks, and %lld are the most: raise them",
             static_cast<long long>(settings.layer), site.unit * separation, site.unit * step, marks,
             static_cast<long long>(marks::most_even_marks));
    // Marks far apart make few marks of many lines, which are found all the same.
    const double squares = area / (separation * separation);
    if (squares > static_cast<double>(marks::most_even_marks))
        fail(Status::invalid_argument,
             "layers[%lld]: with a step of %g, lines are %g apart, and so too many: set a larger separation or a "
             "smaller step",
             static_cast<long long>(settings.layer), site.unit * step, site.unit * separation);
}

base::Array<Complex> guide(const marks::Site& site, const SampleGraph& graph, const Settings& settings,
                           const base::Progress& progress) {
    base::Array<Complex> guide(site.memory(), graph.size());
    if (settings.direction.function != nullptr) {
        geometry::VecArray direction(site.memory(), graph.size());
        marks::directions_at(site, settings.direction, graph.position, graph.normal, direction, progress);
        for (std::int64_t i = 0; i < graph.size(); ++i) {
            const glm::dvec3 d = direction[i];
            if (glm::dot(d, d) > 0.5) guide[i] = std::polar(1.0, 2.0 * graph.angle(i, d));
        }
        return guide;
    }
    base::Array<surface::Curvature> curvature(site.memory());
    surface::principal_curvatures(site.runtime, site.implicit, graph.position, curvature, progress);
    const base::Array<Bend> bend = average_bends(site.runtime, graph, curvature, progress);
    guide = guide_by_curvature(site.runtime, graph, bend, settings.field);
    if (settings.field.guide != Guide::curvature) mix_named_guide(graph, bend, settings.field, guide);
    add_axis(graph, settings.field, guide);
    return guide;
}

curves::SurfaceMesh mesh_of(const marks::Site& site, const geometry::Bounds& region, const SampleGraph& graph,
                            double separation, double area, const base::Progress& progress) {
    curves::MeshSettings settings;
    settings.region = region;
    settings.side = std::max(separation, std::sqrt(triangles_a_cell * area / most_triangles));
    settings.extent = site.implicit.extent();
    return triangulate_of_any_size(site.runtime, site.implicit, graph.position, settings, progress);
}

// Coarse waves first; as fine as the samples know.
SampleWaves waves_of(const marks::Site& site, const LineSamples& samples, double coarsest, int levels,
                     const base::Progress& progress) {
    SampleWaves waves(site.memory());
    waves.period = coarsest;
    WaveLinks links = link_waves(site.runtime, samples, coarsest, progress);
    waves.phases.add(first_phases(site.runtime, links, site.random_seed, progress.part(0.0, 0.8)));
    for (int level = 0; level < levels && waves.period_of(level + 1) >= finest_period * samples.graph.spacing;
         ++level) {
        links.halve(site.runtime, progress);
        waves.phases.add(doubled(site.runtime, links, waves.phases[level], progress));
    }
    return waves;
}

StripeLines stripes_of(const marks::Site& site, const LineSamples& samples, const SampleWaves& waves,
                       const curves::SurfaceMesh& mesh, const base::Array<std::int32_t>& sheets, int levels,
                       const base::Progress& progress) {
    StripeVertices vertices(site.runtime, samples, waves, mesh, sheets, progress.part(0.0, 0.4));
    const double finest = waves.period_of(waves.levels() - 1);
    const int halvings = levels - static_cast<int>(waves.levels() - 1);
    int finer = 0;
    while (finer < halvings && std::ldexp(finest, -finer - 1) >= finest_period_of_cells * mesh.side) ++finer;
    vertices.refine(site.runtime, mesh, finest, finer, progress.part(0.4, 0.8));
    const StripeLines lines = find_stripes(site.runtime, mesh, vertices, std::ldexp(finest, -finer), halvings - finer,
                                           progress.part(0.8, 1.0));
    const double separation = std::ldexp(finest, -halvings);
    return evened(site.runtime, joined(site.memory(), lines, widest_gap * separation, progress), separation, progress);
}

} // namespace

bool Settings::is_on_ground_of(const Settings& other) const noexcept {
    return separation == other.separation && step == other.step && (separation > 0.0 || budget == other.budget) &&
           field.smoothing == other.field.smoothing && field.axis == other.field.axis &&
           field.axis_weight == other.field.axis_weight && field.guide == other.field.guide &&
           field.guide_direction == other.field.guide_direction && field.guide_weight == other.field.guide_weight &&
           direction.function == other.direction.function && direction.user == other.direction.user;
}

// Even samples, whose arrays go into the graph.
struct Ground::Spread {
    Spread(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings,
           const base::Progress& progress)
        : even(site.memory()), sheet(site.memory()) {
        require_room(site, settings, cells.rough_area());
        even = stipples::spread_evenly(site, cells, samples_for(settings, cells.rough_area()), marks::Kind::stipples,
                                       progress);
        area = even.area > 0.0 ? even.area : cells.rough_area();
        spacing = std::sqrt(area / static_cast<double>(even.position.size()));
        sheet = surface::sheets_at(site.runtime, site.implicit, even.position, progress.part(1.0, 1.0));
    }
    stipples::EvenMarks even;
    base::Array<std::int32_t> sheet;
    double area, spacing;
};

Ground::Ground(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings,
               const base::Progress& progress)
    : Ground(site, cells, settings, Spread(site, cells, settings, progress.part(0.0, 0.4)), progress.part(0.4, 1.0)) {}

Ground::Ground(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings, Spread spread,
               const base::Progress& progress)
    : settings_(settings), region_(cells.region), area_(spread.area),
      graph_(site.runtime, std::move(spread.even.position), std::move(spread.even.normal), std::move(spread.sheet),
             spread.spacing, progress.part(0.0, 0.1)),
      angle_(smooth_lines(site.runtime, graph_, guide(site, graph_, settings, progress.part(0.1, 0.2)), settings.field,
                          progress.part(0.2, 0.4))),
      mesh_(mesh_of(site, region_, graph_, separation_of(settings, area_), area_, progress.part(0.4, 0.9))),
      sheet_(site.memory()) {
    if (site.implicit.sheets() != nullptr) end_at_creases(site, progress.part(0.9, 1.0));
}

// Lines end where the mesh does.
void Ground::end_at_creases(const marks::Site& site, const base::Progress& progress) {
    curves::SharpMesh sharp = split_at_creases(site.runtime, site.implicit, std::move(mesh_), progress);
    mesh_ = std::move(sharp.mesh);
    sheet_.resize(mesh_.vertices());
    for (std::int64_t i = 0; i < mesh_.corner.size(); ++i) sheet_[mesh_.corner[i]] = sharp.sheet[i / 3];
}

void Ground::lay_lines(const marks::Site& site, const Settings& settings, marks::Marks& marks,
                       marks::LayerReport& report, const base::Progress& progress) const {
    require_room(site, settings, area_);
    const double separation = separation_of(settings, area_);
    const int levels = std::clamp(
        static_cast<int>(std::floor(std::log2(std::sqrt(area_) / (fewest_lines * separation)))), 0, most_levels);
    LineSamples samples{graph_, geometry::VecArray(site.memory(), graph_.size())};
    for (std::int64_t i = 0; i < graph_.size(); ++i)
        samples.along.set(i, graph_.tangent(i, angle_[i] + settings.angle));
    const SampleWaves waves = waves_of(site, samples, std::ldexp(separation, levels), levels, progress.part(0.0, 0.4));
    const StripeLines lines = stripes_of(site, samples, waves, mesh_, sheet_, levels, progress.part(0.4, 0.6));
    add_line_marks(site, lines, {separation, step_of(settings, separation), levels, region_}, marks, report,
                   progress.part(0.6, 1.0));
    report.step = separation;
    report.levels = levels;
}

std::int64_t samples_for(const Settings& settings, double area) noexcept {
    const double separation = separation_of(settings, area);
    const double wanted = area / (sample_spacing * sample_spacing * separation * separation);
    return std::clamp(static_cast<std::int64_t>(std::min(wanted, 1e9)), fewest_samples, most_samples);
}

} // namespace hrbfnpr::hatching
