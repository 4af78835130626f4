// SPDX-License-Identifier: MIT
// Makes a smooth fit to a mesh, by fit_adaptively() with the mesh as its centre chooser.
//
//   gather_candidates         takes places on the mesh: places spread evenly over its area, and the middles of faces
//   distances_of_candidates   measures how far the candidates are from the fit
//   look_at_surface           measures how far the surface is from the mesh, and adds centres where it is far
//   look                      chooses the centres of the next round, after each round
//   verify                    measures the result at other places of the mesh
#include "mesh/fit/fit_mesh.h"

#include "base/assert.h"
#include "base/clock.h"
#include "base/status.h"
#include "curves/surface_mesh.h"
#include "fit/adaptive.h"
#include "fit/distance.h"
#include "implicit/prepared.h"
#include "mesh/edges.h"
#include "mesh/fit/outer.h"
#include "mesh/fit/tuning.h"
#include "mesh/sample.h"
#include "surface/project.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <utility>

namespace hrbfnpr::mesh {
namespace {

// ---- The fit at many places

// Times measured on two cores with AVX2, in seconds: for each pair of a place and a centre, for making any far field,
// and for each centre of a far field. The far field has the precision and the number of near centres below. It is made
// only if it saves `worth` times the time that making it takes.
constexpr double seconds_a_pair = 1.1e-9;
constexpr double seconds_a_field = 0.01;
constexpr double seconds_a_centre = 5e-5;
constexpr double worth = 1.2;
constexpr std::int64_t most_near = 1000;
// A far field aims for this share of the allowed error, because its largest error may be twice its aim.
constexpr double aimed_share = 0.25;
constexpr double gradient_precision = 5e-2;

bool pays(std::int64_t centres, std::int64_t places) noexcept {
    const auto count = static_cast<double>(centres);
    return seconds_a_pair * static_cast<double>(places) * count > worth * (seconds_a_field + seconds_a_centre * count);
}

// Evaluates the data of a fit at many places, as exactly as a search for errors needs.
class FitField {
public:
    // `precision` is in diagonals. The data must outlive this object.
    FitField(base::InstructionSet set, const implicit::HrbfData& data, double precision) noexcept
        : data_(data), plain_(set, data), precision_(precision) {}

    // Must be called before evaluations at this many places. Prepares a far field if that saves time.
    void prepare_for(const base::Work& work, std::int64_t places);

    [[nodiscard]] const implicit::Implicit& operator*() const noexcept {
        if (prepared_ != nullptr) return *prepared_;
        return plain_;
    }

private:
    const implicit::HrbfData& data_;
    FitData plain_;
    double precision_;
    bool tried_ = false; // whether a far field was made, even if its errors are too large
    std::unique_ptr<implicit::Implicit> prepared_;
};

void FitField::prepare_for(const base::Work& work, std::int64_t places) {
    if (tried_ || !pays(data_.count(), places)) return;
    tried_ = true;
    implicit::LocalFieldOptions options;
    options.tolerance = aimed_share * precision_;
    options.most_near = most_near;
    std::unique_ptr<implicit::Prepared> prepared = implicit::Prepared::make(work, data_, options);
    if (prepared == nullptr) return;
    const implicit::Prepared::Error error = prepared->error();
    if (error.value <= precision_ && error.gradient <= gradient_precision) prepared_ = std::move(prepared);
}

// Returns the root mean square of distances. `unit` is a length that prevents underflow of squares.
double root_mean_square(const base::Array<double>& distance, double unit) noexcept {
    double sum = 0.0;
    for (const double d : distance) sum += (d / unit) * (d / unit);
    return unit * std::sqrt(sum / static_cast<double>(distance.size()));
}

// Sets the fit's report, except for the distances of the candidates. `chosen` are the centres of the fit.
void describe(const base::Work& work, const fit::Samples& chosen, const FitMeshReport& report, fit::CentreFit& fit) {
    fit::FitReport& to = fit.result.report;
    describe_residuals(work, fit.result.data, chosen, to);
    to.samples = report.candidates;
    to.choice_rounds = report.rounds;
    to.input_distance_max = report.mesh.most;
    to.input_share_within = report.mesh.share;
    to.seconds_choose = report.seconds_sample + report.seconds_measure;
    to.peak_bytes = work.memory.bytes_peak();
}

// ---- The mesh and its candidates

// The data that all steps read.
struct Task {
    const base::Work& work;
    const Mesh& mesh;
    const FaceTree& tree;
    const FitMeshSettings& settings;
    const OuterFaces outer;
};

FitMeshReport first_report(const Mesh& mesh, const FitMeshSettings& settings) noexcept {
    FitMeshReport report;
    report.tolerance = plan_tolerance(settings.tolerance, mesh.bounds.diagonal());
    report.far = plan_far(settings.far, report.tolerance);
    report.supported = mesh.report.boundary_edges > 0;
    return report;
}

// Returns a step with which i * step modulo `count` takes each value once, and few values are already spread out.
std::int64_t step_through(std::int64_t count) noexcept {
    constexpr double golden_ratio = 0.6180339887498949;
    auto step = std::max<std::int64_t>(1, std::llround(golden_ratio * static_cast<double>(count)));
    while (std::gcd(step, count) > 1) ++step;
    return step;
}

// Returns the candidates: places spread evenly over the area, and the middles of faces, which are dense where details
// are. The first few candidates are spread over the whole mesh, too, because rounds with few centres look only at
// these.
fit::Samples gather_candidates(const Task& task, FitMeshReport& report) {
    const auto& [work, mesh, tree, settings, outer] = task;
    const std::int64_t faces = mesh.faces();
    const std::int64_t most_of_faces = fit_mesh_tuning.most_candidates / 2;
    const std::int64_t wanted = settings.candidates > 0
                                    ? settings.candidates
                                    : std::clamp(faces, fit_mesh_tuning.fewest_candidates, most_of_faces);
    MeshSamples even = random_samples(work, mesh, wanted, settings.seed, 1);
    report.contact = warn_of_part_contact(work, mesh, tree, even, report.tolerance, false);
    const std::int64_t middles = settings.candidates > 0 ? 0 : std::min(faces, most_of_faces);
    const std::int64_t step = step_through(middles);
    fit::Samples candidates(work.memory);
    for (std::int64_t i = 0; i < std::max(wanted, middles); ++i) {
        if (i < wanted) {
            candidates.position.push_back(even.position[i]);
            candidates.normal.push_back(even.normal[i]);
        }
        if (i < middles) {
            const std::int64_t face = i * step % middles * faces / middles;
            candidates.position.push_back(middle_of(mesh, face));
            candidates.normal.push_back(normal_at(mesh, face, glm::dvec3(1.0 / 3.0)));
        }
    }
    keep_outer(work, mesh, tree, candidates.position, candidates.normal);
    candidates.bounds = mesh.bounds;
    report.candidates = candidates.position.size();
    return candidates;
}

// Returns the first candidates.
fit::Samples first_of(const fit::Samples& candidates, std::int64_t count) {
    fit::Samples some(candidates.position.memory());
    some.position.reserve(count);
    some.normal.reserve(count);
    for (std::int64_t i = 0; i < count; ++i) {
        some.position.push_back(candidates.position[i]);
        some.normal.push_back(candidates.normal[i]);
    }
    some.bounds = candidates.bounds;
    return some;
}

// Returns the largest number of centres that a round may add. `outside` is the share of the candidates outside the
// tolerance.
std::int64_t batch_of(std::int64_t centres, double outside) noexcept {
    const double share = outside > fit_mesh_tuning.mostly_outside ? fit_mesh_tuning.large_batch : fit_mesh_tuning.batch;
    return static_cast<std::int64_t>(share * static_cast<double>(centres));
}

// ---- Distances from the mesh to the surface

// Returns the distance of each candidate from the surface. Where f grows inward at a candidate, the distance is at
// least `wrong_side` tolerances, because the surface near the candidate is spurious or missing.
base::Array<double> distances_of_candidates(const Task& task, const fit::Samples& candidates,
                                            const fit::Distances& distances, double tolerance) {
    base::Array<double> distance(task.work.memory);
    for (std::int64_t i = 0; i < candidates.position.size(); ++i) {
        const bool against = glm::dot(distances.gradient[i], candidates.normal[i]) < 0.0;
        const double d = std::abs(distances.distance[i]);
        distance.push_back(against ? std::max(d, fit_mesh_tuning.wrong_side * tolerance) : d);
    }
    return distance;
}

// Measures the distances to the surface from places of the mesh that were not candidates. It projects these places. For
// candidates only first-order estimates of the distance are known.
DistanceStatistics verify(const Task& task, const implicit::HrbfData& data, const FitMeshReport& report) {
    const auto& [work, mesh, tree, settings, outer] = task;
    MeshSamples samples = random_samples(work, mesh, fit_mesh_tuning.verified_places, settings.seed, 2);
    keep_outer(work, mesh, tree, samples.position, samples.normal);
    surface::Projection on(work.memory);
    for (std::int64_t i = 0; i < samples.position.size(); ++i) on.position.push_back(samples.position[i]);
    const FitData implicit(work.instruction_set, data);
    surface::ProjectionSettings steps;
    steps.tolerance = 1e-6;
    surface::project(work.without_progress(), implicit, steps, on);
    base::Array<double> distance(work.memory);
    for (std::int64_t i = 0; i < samples.position.size(); ++i) {
        const bool found = on.status[i] == surface::ProjectionStatus::converged;
        distance.push_back(found ? glm::distance(on.position[i], samples.position[i])
                                 : std::numeric_limits<double>::infinity());
    }
    return statistics_of(distance, report.tolerance, report.far);
}

// ---- Distances from the surface to the mesh

// Returns the distance from each place to the mesh. It is 0 for places whose nearest point of the mesh is on a border,
// because drawings trim the surface there.
base::Array<double> distances_to_mesh(const Task& task, const geometry::VecArray& place) {
    base::Array<double> distance(task.work.memory, place.size());
    task.work.for_chunks(distance.size(), 256, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const FaceTree::Nearest nearest = task.outer.tree().nearest(place[i]);
            distance[i] = on_border(task.mesh, nearest.face, nearest.place) ? 0.0 : std::sqrt(nearest.squared);
        }
    });
    return distance;
}

// Drops the distances of places that samples do not support, if there is a support. Only places farther from the mesh
// than the tolerance are examined, because the others are within it anyway.
void drop_unsupported_beyond(const base::Work& work, const SurfaceSearch& search, const SurfacePlaces& places,
                             double tolerance, base::Array<double>& distance) {
    if (search.support == nullptr) return;
    SurfacePlaces far(work.memory);
    base::Array<double> far_distance(work.memory);
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < distance.size(); ++i) {
        if (distance[i] <= tolerance) {
            distance[kept++] = distance[i];
            continue;
        }
        far.position.push_back(places.position[i]);
        far.gradient.push_back(places.gradient[i]);
        far_distance.push_back(distance[i]);
    }
    base::Array<double> beyond(work.memory);
    search.support->evaluate_all(work, far.position, far.gradient, beyond);
    for (std::int64_t i = 0; i < beyond.size(); ++i)
        if (beyond[i] <= search.limit) distance[kept++] = far_distance[i];
    distance.resize(kept);
}

// Adds centres at places of the surface that are far from the mesh, the farthest first. The distance between two of
// these centres is about their distance from the mesh. The value of f at a centre is the signed distance from the mesh.
// Places of which the side of the mesh is uncertain are left out. `held` are the existing centres off the mesh; new
// ones are appended to `added`.
void add_off_surface_centres(const Task& task, const geometry::VecArray& place, const base::Array<double>& distance,
                             double tolerance, std::int64_t room, const fit::Samples& held, fit::Samples& added) {
    HRBFNPR_ASSERT(distance.size() == place.size());
    base::Array<std::int64_t> order(task.work.memory);
    for (std::int64_t i = 0; i < place.size(); ++i)
        if (distance[i] > fit_mesh_tuning.held_beyond * tolerance) order.push_back(i);
    std::sort(order.begin(), order.end(), [&](std::int64_t a, std::int64_t b) {
        return distance[a] > distance[b] || (distance[a] == distance[b] && a < b);
    });
    const std::int64_t before = added.position.size();
    for (const std::int64_t i : order) {
        if (added.position.size() - before >= std::min(room, fit_mesh_tuning.most_held)) return;
        const auto covers = [&](const geometry::VecArray& others) {
            for (std::int64_t j = 0; j < others.size(); ++j)
                if (glm::distance(others[j], place[i]) < fit_mesh_tuning.held_apart * distance[i]) return true;
            return false;
        };
        if (covers(held.position) || covers(added.position)) continue;
        const MeshSide side = side_of_mesh(task.outer.all(), place[i]);
        if (side == MeshSide::unsure) continue;
        const FaceTree::Nearest nearest = task.outer.tree().nearest(place[i]);
        const double sign = side == MeshSide::inside ? -1.0 : 1.0;
        const double length = std::sqrt(nearest.squared);
        added.position.push_back(place[i]);
        added.normal.push_back(sign / length * (place[i] - nearest.place));
        added.value.push_back(sign * length);
    }
}

} // namespace

void describe_residuals(const base::Work& work, const implicit::HrbfData& data, const fit::Samples& centres,
                        fit::FitReport& to) {
    const fit::Distances at = fit::measure_distances(work, data, centres);
    const double unit = data.scale; // The unit prevents underflow if lengths are tiny.
    double values = 0.0;
    double gradients = 0.0;
    const std::int64_t count = centres.position.size();
    for (std::int64_t i = 0; i < count; ++i) {
        const double value = std::abs(at.value[i] - (centres.value.empty() ? 0.0 : centres.value[i]));
        const double gradient = glm::distance(at.gradient[i], centres.normal[i]);
        to.value_residual_max = std::max(to.value_residual_max, value);
        to.gradient_residual_max = std::max(to.gradient_residual_max, gradient);
        values += (value / unit) * (value / unit);
        gradients += gradient * gradient;
    }
    to.value_residual_rms = unit * std::sqrt(values / static_cast<double>(count));
    to.gradient_residual_rms = std::sqrt(gradients / static_cast<double>(count));
}

MeshFit fit_mesh(const base::Work& work, const Mesh& mesh, const FaceTree& tree, const FitMeshSettings& settings,
                 const fit::FitInput& given) {
    refuse_flat_solid(mesh);
    const base::Stopwatch watch;
    const Task task{work, mesh, tree, settings, OuterFaces(work, mesh, tree)};
    const double diagonal = mesh.bounds.diagonal();
    FitMeshReport report = first_report(mesh, settings);
    const double share = settings.share + fit_mesh_tuning.margin * (1.0 - settings.share);
    fit::FitInput options = given;
    // With a tolerance, the solver accepts residuals that are too small to change a distance.
    options.tolerance = report.tolerance;
    options.automatic_tolerance = std::clamp(fit_mesh_tuning.residual * report.tolerance / diagonal,
                                             fit_mesh_tuning.finest_residual, fit_mesh_tuning.roughest_residual);

    fit::Samples candidates = gather_candidates(task, report);
    // The candidates that the rounds have looked at. All centres are among them.
    fit::Samples some = first_of(candidates, std::min(candidates.position.size(), fit_mesh_tuning.candidates_a_centre *
                                                                                      fit_mesh_tuning.first_centres));
    std::optional<geometry::PointTree> some_tree;
    std::optional<surface::Support> support;
    if (report.supported) support.emplace(work, candidates.position, candidates.normal, 0.0);
    report.seconds_sample = watch.seconds();

    SurfaceSearch search;
    search.region = search_region(mesh);
    search.side = diagonal / fit_mesh_tuning.cells_of_rounds;
    search.precision =
        std::max(fit_mesh_tuning.finest_precision, fit_mesh_tuning.precision * report.tolerance / diagonal);
    search.limit = fit_mesh_tuning.support_limit;
    search.support = support ? &*support : nullptr;

    // The vertices of the surface that was found last, and the side of its cells.
    std::int64_t surface_vertices = fit_mesh_tuning.first_vertices;
    double surface_side = search.side;
    // Returns the expected number of places at which the next search for the surface evaluates f.
    const auto surface_places = [&] {
        const double finer = surface_side / search.side;
        return static_cast<std::int64_t>(static_cast<double>(fit_mesh_tuning.places_a_vertex * surface_vertices) *
                                         finer * finer);
    };
    double least_outside = 2.0;
    double least_far = std::numeric_limits<double>::infinity();
    std::int32_t idle = 0; // the number of consecutive rounds without a gain
    double input_distance_rms = 0.0;

    // Measures the whole surface. Adds centres off the mesh to `next` where the surface is far from the mesh. Returns
    // whether it added any.
    const auto look_at_surface = [&](FitField& field, const fit::AdaptiveFit& now, fit::NextCentres& next) {
        geometry::VecArray seeds(work.memory);
        for (const std::int64_t i : now.centres) seeds.push_back(candidates.position[i]);
        field.prepare_for(work, surface_places());
        curves::SurfaceMesh surface = find_surface(work.without_progress(), *field, seeds, search);
        surface_vertices = surface.position.size();
        surface_side = search.side;
        // The places are the vertices of the surface, which lie on f = 0. Even a small part of the surface has
        // vertices.
        SurfacePlaces places(work.memory);
        places.position = std::move(surface.position);
        places.gradient = std::move(surface.gradient);
        base::Array<double> distance = distances_to_mesh(task, places.position);
        const std::int64_t before = next.off_surface.position.size();
        const std::int64_t room =
            settings.maximum_centres - now.centres.size() - now.off_surface.position.size() - before;
        add_off_surface_centres(task, places.position, distance, report.tolerance, room, now.off_surface,
                                next.off_surface);
        drop_unsupported_beyond(work, search, places, report.tolerance, distance);
        report.surface = statistics_of(distance, report.tolerance, report.far);
        return next.off_surface.position.size() > before;
    };
    // Returns whether the last rounds reduced the share outside the tolerance, or the farthest distance.
    const auto gains = [&] {
        const double outside = 2.0 - report.mesh.share - report.surface.share;
        const double far = std::max(report.mesh.most, report.surface.most);
        const bool better = outside < fit_mesh_tuning.gain * least_outside ||
                            (far > report.far && far < fit_mesh_tuning.gain * least_far);
        least_outside = std::min(least_outside, outside);
        least_far = std::min(least_far, far);
        idle = better ? 0 : idle + 1;
        return idle < fit_mesh_tuning.idle_rounds;
    };
    const auto look = [&](const fit::AdaptiveFit& now) {
        const base::Stopwatch of_look;
        fit::NextCentres next(work.memory, {options.regularization, options.regularization});
        FitField field(work.instruction_set, now.fit.result.data, search.precision);
        fit::Distances distances(work.memory);
        // If the last round was nearly good, all candidates and the surface are probably measured in this round.
        const bool nearly_good = report.mesh.share > 1.0 - fit_mesh_tuning.mostly_outside;
        const std::int64_t all = candidates.position.size();
        const auto measure_mesh = [&](std::int64_t count) {
            if (count > some.position.size()) {
                some = first_of(candidates, count);
                some_tree.reset();
            }
            field.prepare_for(work, count + (nearly_good ? all + surface_places() : 0));
            distances = fit::measure_distances(work.without_progress(), *field, some);
            input_distance_rms = root_mean_square(distances.distance, now.fit.result.data.scale);
            base::Array<double> distance = distances_of_candidates(task, some, distances, report.tolerance);
            report.mesh = statistics_of(distance, report.tolerance, report.far);
            return report.mesh.is_within(share, report.far);
        };
        bool mesh_good = measure_mesh(
            std::clamp(fit_mesh_tuning.candidates_a_centre * now.centres.size(), some.position.size(), all));
        if (mesh_good && some.position.size() < all) mesh_good = measure_mesh(all);
        // The whole surface is examined for the first time when most of the mesh is within the tolerance, because most
        // spurious parts have disappeared by then. It is examined again while some part of it is far from the mesh, and
        // at the end, in smaller cells.
        const bool far = !(report.surface.most <= report.far);
        const bool looked = mesh_good || (report.mesh.share > fit_mesh_tuning.first_look && far);
        if (mesh_good) search.side = std::min(search.side, diagonal / fit_mesh_tuning.cells_of_last);
        bool grown = looked && look_at_surface(field, now, next);
        const std::int64_t room = settings.maximum_centres - now.centres.size() - now.off_surface.position.size() -
                                  next.off_surface.position.size();
        if (room > 0 && !mesh_good) {
            const std::int64_t batch = batch_of(now.centres.size(), 1.0 - report.mesh.share);
            const fit::CandidateOptions wanted{fit_mesh_tuning.inner * report.tolerance,
                                               fit_mesh_tuning.apart * report.tolerance, std::min(batch, room)};
            if (!some_tree) some_tree.emplace(some.position, work);
            next.centres = fit::worst_candidates(work, some, *some_tree, now.centres, distances, wanted).chosen;
            grown = !next.centres.empty() || grown;
        }
        if (!looked && !grown) grown = look_at_surface(field, now, next);
        const bool all_good = mesh_good && report.surface.is_within(share, report.far);
        next.continues = !all_good && grown && (!looked || gains());
        work.runtime().log(base::LogLevel::debug,
                           "mesh fit: round %d, %lld centres: share within: mesh %.4f (farthest %.3g), surface %.4f "
                           "(%.3g); %lld to add, %lld off it",
                           static_cast<int>(now.rounds), static_cast<long long>(now.fit.result.data.count()),
                           report.mesh.share, report.mesh.most, report.surface.share, report.surface.most,
                           static_cast<long long>(next.centres.size()),
                           static_cast<long long>(next.off_surface.position.size()));
        report.seconds_measure += of_look.seconds();
        return next;
    };

    fit::AdaptiveFit made = fit::fit_adaptively(
        work, options, candidates,
        fit::even_choice(some, std::min(fit_mesh_tuning.first_centres, settings.maximum_centres), work),
        {options.regularization, options.regularization},
        {fit_mesh_tuning.most_rounds, fit_mesh_tuning.residual_of_rounds, true}, std::ref(look));
    report.rounds = made.rounds;
    report.seconds_fit = made.seconds_fit;
    report.off_surface = made.off_surface.position.size();
    report.mesh = verify(task, made.fit.result.data, report);
    report.reached =
        report.mesh.is_within(settings.share, report.far) && report.surface.is_within(settings.share, report.far);
    describe(work, fit::centres_of(work, candidates, made.centres, made.off_surface), report, made.fit);
    report.seconds_total = watch.seconds();
    fit::FitResult result = std::move(made.fit.result);
    result.report.input_distance_rms = input_distance_rms;
    result.report.seconds_total = report.seconds_total;
    result.samples = std::move(candidates);
    work.update(1.0);
    return {std::move(result), report};
}

} // namespace hrbfnpr::mesh
