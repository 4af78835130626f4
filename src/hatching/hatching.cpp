// SPDX-License-Identifier: MIT
#include "hatching/hatching.h"

#include "hatching/line_marks.h"
#include "stipples/blue_noise.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::hatching {
namespace {

// Marks along a line, in separations.
constexpr double automatic_step = 0.4;
// Of samples: their spacing in separations, and how many there are.
constexpr double sample_spacing = 1.5;
constexpr std::int64_t fewest_samples = 4096;
constexpr std::int64_t most_samples = 32768;
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

class Hatching {
public:
    Hatching(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings,
             marks::LayerReport& report)
        : site_(site), cells_(cells), settings_(settings), report_(report) {}

    double run(marks::Marks& marks, const base::Progress& progress);

private:
    void measure(double area);
    [[nodiscard]] base::Array<Complex> guide(const SampleGraph& graph, const base::Progress& progress) const;
    [[nodiscard]] LineSamples lines(const SampleGraph& graph, const base::Progress& progress) const;
    [[nodiscard]] SampleWaves waves(const LineSamples& samples, double area, const base::Progress& progress);
    [[nodiscard]] curves::SurfaceMesh mesh(const SampleGraph& graph, double area, const base::Progress& progress) const;

    const marks::Site& site_;
    const stipples::SurfaceCells& cells_;
    const Settings& settings_;
    marks::LayerReport& report_;
    double separation_ = 0.0;
    double step_ = 0.0;
    int levels_ = 0;   // the finest
    int halvings_ = 0; // of the finest wave
};

// Lines a separation apart have area / separation of length together.
void Hatching::measure(double area) {
    separation_ = settings_.separation;
    const double budget = static_cast<double>(std::max<std::int64_t>(settings_.budget, 1));
    if (!(separation_ > 0.0))
        separation_ =
            settings_.step > 0.0 ? area / (settings_.step * budget) : std::sqrt(area / (automatic_step * budget));
    step_ = settings_.step > 0.0 ? settings_.step : automatic_step * separation_;
    const double marks = area / (separation_ * step_);
    if (marks > static_cast<double>(marks::most_even_marks))
        fail(Status::invalid_argument,
             "layers[%lld]: a separation of %g and a step of %g make about %g marks, and %lld are the most: raise them",
             static_cast<long long>(settings_.layer), site_.unit * separation_, site_.unit * step_, marks,
             static_cast<long long>(marks::most_even_marks));
    levels_ = std::clamp(static_cast<int>(std::floor(std::log2(std::sqrt(area) / (fewest_lines * separation_)))), 0,
                         most_levels);
}

base::Array<Complex> Hatching::guide(const SampleGraph& graph, const base::Progress& progress) const {
    FieldSettings field = settings_.field;
    base::Array<Complex> guide(site_.memory(), graph.size());
    if (settings_.direction.function != nullptr) {
        geometry::VecArray direction(site_.memory(), graph.size());
        marks::directions_at(site_, settings_.direction, graph.position, graph.normal, direction, progress);
        for (std::int64_t i = 0; i < graph.size(); ++i) {
            const glm::dvec3 d = direction[i];
            if (glm::dot(d, d) > 0.5) guide[i] = std::polar(1.0, 2.0 * graph.angle(i, d));
        }
        return guide;
    }
    base::Array<surface::Curvature> curvature(site_.memory());
    surface::principal_curvatures(site_.runtime, site_.implicit, graph.position, curvature, progress);
    guide = guide_by_curvature(site_.runtime, graph, curvature, field);
    add_axis(graph, field, guide);
    return guide;
}

LineSamples Hatching::lines(const SampleGraph& graph, const base::Progress& progress) const {
    const base::Array<double> angle =
        smooth_lines(site_.runtime, graph, guide(graph, progress), settings_.field, progress);
    LineSamples samples{graph, geometry::VecArray(site_.memory(), graph.size())};
    for (std::int64_t i = 0; i < graph.size(); ++i) samples.along.set(i, graph.tangent(i, angle[i] + settings_.angle));
    return samples;
}

SampleWaves Hatching::waves(const LineSamples& samples, double area, const base::Progress& progress) {
    SampleWaves waves(site_.memory());
    waves.period = std::ldexp(separation_, levels_);
    int level = 0;
    waves.phases.add(first_phases(site_.runtime, samples, waves.period, site_.random_seed, progress.part(0.0, 0.8)));
    for (; level < levels_ && waves.period_of(level + 1) >= finest_period * samples.graph.spacing; ++level)
        waves.phases.add(doubled(site_.runtime, samples, waves.phases[level], waves.period_of(level), progress));
    halvings_ = levels_ - level;
    static_cast<void>(area);
    return waves;
}

curves::SurfaceMesh Hatching::mesh(const SampleGraph& graph, double area, const base::Progress& progress) const {
    curves::MeshSettings settings;
    settings.region = cells_.region;
    settings.side = std::max(separation_, std::sqrt(triangles_a_cell * area / most_triangles));
    return triangulate(site_.runtime, site_.implicit, graph.position, settings, progress);
}

double Hatching::run(marks::Marks& marks, const base::Progress& progress) {
    measure(cells_.rough_area());
    stipples::EvenMarks even = stipples::spread_evenly(site_, cells_, samples_for(settings_, cells_.rough_area()),
                                                       marks::Kind::stipples, progress.part(0.0, 0.2));
    const double area = even.area > 0.0 ? even.area : cells_.rough_area();
    measure(area);
    const double spacing = std::sqrt(area / static_cast<double>(even.position.size()));
    const SampleGraph graph(site_.runtime, std::move(even.position), std::move(even.normal), spacing,
                            progress.part(0.2, 0.25));
    const LineSamples samples = lines(graph, progress.part(0.25, 0.4));
    const SampleWaves waves = this->waves(samples, area, progress.part(0.4, 0.6));
    const curves::SurfaceMesh mesh = this->mesh(graph, area, progress.part(0.6, 0.7));
    StripeVertices vertices(site_.runtime, samples, waves, mesh, progress.part(0.7, 0.75));
    const double finest = waves.period_of(waves.levels() - 1);
    int finer = 0;
    while (finer < halvings_ && std::ldexp(finest, -finer - 1) >= finest_period_of_cells * mesh.side) ++finer;
    vertices.refine(site_.runtime, mesh, finest, finer, progress.part(0.75, 0.8));
    const StripeLines stripes = find_stripes(site_.runtime, mesh, vertices, std::ldexp(finest, -finer),
                                             halvings_ - finer, progress.part(0.8, 0.8));
    add_line_marks(site_, stripes, {separation_, step_, levels_, cells_.region}, marks, report_,
                   progress.part(0.8, 1.0));
    report_.step = separation_;
    report_.levels = levels_;
    return area;
}

} // namespace

std::int64_t samples_for(const Settings& settings, double area) noexcept {
    const double separation =
        settings.separation > 0.0
            ? settings.separation
            : std::sqrt(area / (automatic_step * static_cast<double>(std::max<std::int64_t>(settings.budget, 1))));
    const double wanted = area / (sample_spacing * sample_spacing * separation * separation);
    return std::clamp(static_cast<std::int64_t>(std::min(wanted, 1e9)), fewest_samples, most_samples);
}

double lay_lines(const marks::Site& site, const stipples::SurfaceCells& cells, const Settings& settings,
                 marks::Marks& marks, marks::LayerReport& report, const base::Progress& progress) {
    return Hatching(site, cells, settings, report).run(marks, progress);
}

} // namespace hrbfnpr::hatching
