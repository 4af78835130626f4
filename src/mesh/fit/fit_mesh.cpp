// SPDX-License-Identifier: MIT
#include "mesh/fit/fit_mesh.h"

#include "base/clock.h"
#include "base/status.h"
#include "curves/surface_mesh.h"
#include "fit/candidates.h"
#include "fit/fit_centres.h"
#include "geometry/farthest_order.h"
#include "mesh/fit/fit_data.h"
#include "mesh/fit/off_surface.h"
#include "mesh/fit/outer.h"
#include "mesh/sample.h"
#include "surface/project.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hrbfnpr::mesh {
namespace {

constexpr std::int64_t first_centres = 400;
constexpr std::int64_t fewest_candidates = 20000;
constexpr std::int64_t most_candidates = 100000;
constexpr std::int32_t most_rounds = 40;
// A batch is at most this share of the centres; while more of the candidates than `mostly` are outside, twice as many.
constexpr double batch = 0.5;
constexpr double mostly = 0.25;
constexpr std::int64_t smallest_batch = 32;
// Centres are added for candidates beyond this share of the tolerance, and no nearer to each other than ...
constexpr double inner = 0.8;
constexpr double apart = 0.5;
// The share that is asked for is exceeded by so much of what is left of 1: other places are a little worse.
constexpr double margin = 0.3;

constexpr double side_of_rounds = 72.0; // cells a diagonal while it is fitted ...
constexpr double side_of_last = 128.0;  // ... and when that is done
// No end is in sight where so many rounds one after the other do not bring what is outside down to this share.
constexpr double gain = 0.9;
constexpr std::int32_t idle_rounds = 2;
constexpr double wrong_side = 2.0; // tolerances
constexpr double first_look = 0.9;
constexpr std::int64_t verified_places = 10000;
// Of the equations, relative: in tolerances, and at least and at most.
constexpr double residual = 5e-3;
constexpr double finest_residual = 1e-8;
constexpr double roughest_residual = 1e-5;
constexpr double precision = 5e-2;          // of f, and of the surface's vertices, in tolerances
constexpr double finest_precision = 1e-9;   // in diagonals
constexpr std::int64_t places_a_vertex = 3; // that f is asked at, about
constexpr double support_limit = 3.0;       // of what dense samples bear out

class Fitter {
public:
    Fitter(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const FitMeshSettings& settings,
           const fit::FitInput& options, const base::Progress& progress)
        : runtime_(runtime), mesh_(mesh), tree_(tree), outer_(runtime, mesh, tree, progress), settings_(settings),
          options_(options), progress_(progress), candidates_(runtime.memory), centres_(runtime.memory),
          off_(runtime.memory), centres_before_(runtime.memory) {
        const double diagonal = mesh.bounds.diagonal();
        report_.tolerance = settings.tolerance > 0.0 ? settings.tolerance : default_tolerance * diagonal;
        report_.far = settings.far > 0.0 ? settings.far : 5.0 * report_.tolerance;
        report_.supported = mesh.report.boundary_edges > 0;
        share_ = settings.share + margin * (1.0 - settings.share);
        options_.tolerance = report_.tolerance; // residuals that a distance does not show are accepted
        options_.automatic_tolerance =
            std::clamp(residual * report_.tolerance / diagonal, finest_residual, roughest_residual);
        search_.region = search_region(mesh);
        search_.side = diagonal / side_of_rounds;
        search_.precision = std::max(finest_precision, precision * report_.tolerance / diagonal);
        search_.limit = support_limit;
    }

    [[nodiscard]] MeshFit run() {
        gather_candidates();
        choose_first();
        while (fit_round() && add_centres()) {
        }
        finish();
        return {std::move(fit_->result), report_};
    }

private:
    // Even over the area, and the middles of faces, which are small where there are details.
    void gather_candidates() {
        const base::Stopwatch watch;
        const std::int64_t faces = mesh_.faces();
        const std::int64_t wanted =
            settings_.candidates > 0 ? settings_.candidates : std::clamp(faces, fewest_candidates, most_candidates / 2);
        MeshSamples even = random_samples(runtime_, mesh_, wanted, settings_.seed, 1, progress_);
        report_.touching = warn_of_touching(runtime_, mesh_, tree_, even, report_.tolerance, false, progress_);
        candidates_.position = std::move(even.position);
        candidates_.normal = std::move(even.normal);
        const std::int64_t step = (faces + most_candidates / 2 - 1) / (most_candidates / 2);
        for (std::int64_t face = 0; face < faces && settings_.candidates == 0; face += step) {
            const auto p = mesh_.corners(face);
            candidates_.position.push_back((p[0] + p[1] + p[2]) / 3.0);
            candidates_.normal.push_back(normal_at(mesh_, face, glm::dvec3(1.0 / 3.0)));
        }
        keep_outer(runtime_, mesh_, tree_, candidates_.position, candidates_.normal, progress_);
        candidates_.bounds = mesh_.bounds;
        report_.candidates = candidates_.position.size();
        if (report_.supported) {
            support_.emplace(runtime_, candidates_.position, candidates_.normal, 0.0, progress_);
            search_.support = &*support_;
        }
        report_.seconds_sample = watch.seconds();
    }

    void choose_first() {
        const std::int64_t count = std::min(first_centres, settings_.maximum_centres);
        const geometry::FarthestOrder first =
            geometry::farthest_order(candidates_.position, count, progress_.part(0, 0));
        for (const std::int64_t i : first.order) centres_.push_back(i);
        std::sort(centres_.begin(), centres_.end());
    }

    // False where more centres do not make a better fit.
    [[nodiscard]] bool fit_round() {
        const base::Stopwatch watch;
        const double from = 1.0 - std::pow(0.8, report_.rounds);
        const double to = 1.0 - std::pow(0.8, report_.rounds + 1);
        const fit::Samples chosen = chosen_samples(runtime_, candidates_, centres_, off_, progress_);
        field_.reset();
        try {
            fit_.emplace(fit::fit_centres(runtime_, options_, chosen,
                                          {options_.regularization, options_.regularization},
                                          progress_.part(from, to)));
        } catch (const Error& error) {
            const bool too_near = error.status() == Status::not_converged || error.status() == Status::singular_system;
            if (!too_near || report_.rounds == 0) throw;
            runtime_.log(base::LogLevel::warning, "mesh fit: with %lld centres: %s",
                         static_cast<long long>(chosen.position.size()), error.what());
            std::swap(centres_, centres_before_);
            off_.shorten(off_before_);
            return false;
        }
        ++report_.rounds;
        report_.seconds_fit += watch.seconds();
        return true;
    }

    [[nodiscard]] std::int64_t room() const noexcept {
        return settings_.maximum_centres - centres_.size() - off_.count();
    }

    // False if there is nothing to add, or no room.
    [[nodiscard]] bool add_centres() {
        const base::Stopwatch watch;
        const bool goes_on = measure_and_add();
        report_.seconds_measure += watch.seconds();
        return goes_on;
    }

    [[nodiscard]] bool measure_and_add() {
        const base::Progress silent = progress_.part(0, 0);
        field_.emplace(runtime_.instruction_set, fit_->result.data, search_.precision);
        field_->expect(runtime_, candidates_.position.size() + surface_places_, silent);
        const fit::Distances distances = fit::measure_distances(runtime_, **field_, candidates_, silent);
        fit_->result.report.input_distance_rms = root_mean_square(distances.distance, fit_->result.data.scale);
        base::Array<double> distance(runtime_.memory);
        for (std::int64_t i = 0; i < candidates_.position.size(); ++i) {
            // Where f grows inward the surface is another one, or none.
            const bool against = glm::dot(distances.gradient[i], candidates_.normal[i]) < 0.0;
            const double d = std::abs(distances.distance[i]);
            distance.push_back(against ? std::max(d, wrong_side * report_.tolerance) : d);
        }
        report_.mesh = spread_of(distance, report_.tolerance, report_.far);
        keep_lists();
        const bool mesh_good = good(report_.mesh, share_);
        bool grown = false;
        // What the surface does elsewhere is worth a look once it is where the mesh is, as most of it goes by itself;
        // and again while it is far, and in the end.
        const bool far = !(report_.surface.most <= report_.far);
        const bool looked = mesh_good || (report_.mesh.share > first_look && far);
        if (looked) grown = look_at_surface();
        if (room() > 0 && !mesh_good) grown = add_from_mesh(distances) || grown;
        if (!looked && !grown) grown = look_at_surface();
        report_.reached = good(report_.mesh, settings_.share) && good(report_.surface, settings_.share);
        log_round();
        if (mesh_good && good(report_.surface, share_)) return look_closer();
        return grown && (!looked || gains()) && report_.rounds < most_rounds;
    }

    // Once: whether smaller cells find what has to be mended.
    [[nodiscard]] bool look_closer() {
        const double side = mesh_.bounds.diagonal() / side_of_last;
        if (search_.side <= side) return false;
        const double ratio = search_.side / side;
        search_.side = side;
        field_->expect(runtime_, static_cast<std::int64_t>(ratio * ratio * static_cast<double>(surface_places_)),
                       progress_.part(0, 0));
        const bool added = look_at_surface();
        report_.reached = good(report_.mesh, settings_.share) && good(report_.surface, settings_.share);
        return added && !good(report_.surface, share_);
    }

    // Whether the last rounds brought what is outside down.
    [[nodiscard]] bool gains() noexcept {
        const double outside = 2.0 - report_.mesh.share - report_.surface.share;
        const double far = std::max(report_.mesh.most, report_.surface.most);
        const bool better = outside < gain * outside_ || (far > report_.far && far < gain * far_);
        outside_ = std::min(outside_, outside);
        far_ = std::min(far_, far);
        idle_ = better ? 0 : idle_ + 1;
        return idle_ < idle_rounds;
    }

    void keep_lists() {
        off_before_ = off_.count();
        centres_before_.clear();
        for (const std::int64_t i : centres_) centres_before_.push_back(i);
    }

    void log_round() const {
        runtime_.log(
            base::LogLevel::debug,
            "mesh fit: round %d, %lld centres: of the mesh %.4f within, the farthest %.3g; of the surface %.4f "
            "and %.3g; to %lld centres, %lld of them off the surface",
            static_cast<int>(report_.rounds), static_cast<long long>(fit_->result.data.count()), report_.mesh.share,
            report_.mesh.most, report_.surface.share, report_.surface.most,
            static_cast<long long>(centres_.size() + off_.count()), static_cast<long long>(off_.count()));
    }

    [[nodiscard]] bool good(const Spread& spread, double share) const noexcept {
        return spread.points > 0 && spread.share >= share && spread.most <= report_.far;
    }

    [[nodiscard]] bool add_from_mesh(const fit::Distances& distances) {
        const auto count = static_cast<double>(centres_.size());
        const double share = report_.mesh.share < 1.0 - mostly ? 2.0 * batch : batch;
        const std::int64_t most = std::max(smallest_batch, static_cast<std::int64_t>(share * count));
        const fit::CandidateOptions options{inner * report_.tolerance, apart * report_.tolerance,
                                            std::min(most, room()), nullptr, nullptr};
        if (!candidate_tree_) candidate_tree_.emplace(candidates_.position, progress_);
        const fit::Candidates added =
            fit::find_candidates(runtime_, candidates_, *candidate_tree_, centres_, distances, options, progress_);
        for (const std::int64_t i : added.chosen) centres_.push_back(i);
        std::sort(centres_.begin(), centres_.end());
        return !added.chosen.empty();
    }

    // Holds f off the surface where that is far from the mesh, and it is sure which side that is; whether there is such
    // a place.
    [[nodiscard]] bool look_at_surface() {
        curves::SurfaceMesh surface = find_surface(runtime_, **field_, positions(), search_, progress_.part(0, 0));
        surface_places_ = places_a_vertex * surface.position.size();
        // Its vertices, which lie on f = 0: a part that is small has some, too.
        SurfacePlaces places(runtime_.memory);
        places.position = std::move(surface.position);
        places.gradient = std::move(surface.gradient);
        base::Array<double> distance = distances_to_mesh(places.position);
        const std::int64_t added = off_.add_from(places.position, distance, report_.tolerance, room(), outer_);
        if (report_.supported) {
            leave_out(runtime_, search_, places, progress_);
            distance = distances_to_mesh(places.position);
        }
        report_.surface = spread_of(distance, report_.tolerance, report_.far);
        return added > 0;
    }

    // What lies beyond a border is 0 from the mesh: a drawing trims it.
    [[nodiscard]] base::Array<double> distances_to_mesh(const geometry::VecArray& place) const {
        base::Array<double> distance(runtime_.memory, place.size());
        runtime_.parallel.for_chunks(distance.size(), 256, [&](std::int64_t begin, std::int64_t end) {
            progress_.check();
            for (std::int64_t i = begin; i < end; ++i) {
                const FaceTree::Nearest nearest = outer_.tree().nearest(place[i]);
                distance[i] = on_border(mesh_, nearest.face, nearest.place) ? 0.0 : std::sqrt(nearest.squared);
            }
        });
        return distance;
    }

    [[nodiscard]] geometry::VecArray positions() const {
        geometry::VecArray result(runtime_.memory);
        for (const std::int64_t i : centres_) result.push_back(candidates_.position[i]);
        return result;
    }

    // The mesh's distance at other places, and to the surface itself: at the candidates it is of first order.
    void verify() {
        MeshSamples samples = random_samples(runtime_, mesh_, verified_places, settings_.seed, 2, progress_.part(0, 0));
        keep_outer(runtime_, mesh_, tree_, samples.position, samples.normal, progress_);
        surface::Projection on(runtime_.memory);
        for (std::int64_t i = 0; i < samples.position.size(); ++i) on.position.push_back(samples.position[i]);
        const FitData implicit(runtime_.instruction_set, fit_->result.data);
        surface::ProjectionSettings steps;
        steps.tolerance = 1e-6;
        surface::project(runtime_, implicit, steps, on, progress_.part(0, 0));
        base::Array<double> distance(runtime_.memory);
        for (std::int64_t i = 0; i < samples.position.size(); ++i) {
            const bool found = on.status[i] == surface::ProjectionStatus::converged;
            distance.push_back(found ? glm::distance(on.position[i], samples.position[i])
                                     : std::numeric_limits<double>::infinity());
        }
        report_.mesh = spread_of(distance, report_.tolerance, report_.far);
        report_.reached = good(report_.mesh, settings_.share) && good(report_.surface, settings_.share);
    }

    void finish() {
        // What was added last is in no fit.
        if (fit_->result.data.count() != centres_.size() + off_.count()) {
            std::swap(centres_, centres_before_);
            off_.shorten(off_before_);
        }
        report_.off_surface = off_.count();
        verify();
        describe(runtime_, candidates_, centres_, off_, report_, *fit_, progress_);
        report_.seconds_total = watch_.seconds();
        fit_->result.report.seconds_total = report_.seconds_total;
        fit_->result.samples = std::move(candidates_);
        progress_.update(1.0);
    }

    const base::Runtime& runtime_;
    const Mesh& mesh_;
    const FaceTree& tree_;
    const OuterFaces outer_;
    const FitMeshSettings& settings_;
    fit::FitInput options_;
    const base::Progress& progress_;
    const base::Stopwatch watch_;
    fit::Samples candidates_;
    std::optional<geometry::PointTree> candidate_tree_;
    base::Array<std::int64_t> centres_; // candidates
    OffSurface off_;
    base::Array<std::int64_t> centres_before_; // of the last fit
    std::int64_t off_before_ = 0;
    double outside_ = 2.0; // the least so far
    double far_ = std::numeric_limits<double>::infinity();
    std::int32_t idle_ = 0; // rounds without a gain
    std::optional<surface::Support> support_;
    SurfaceSearch search_;
    double share_ = 0.99;
    std::optional<fit::CentreFit> fit_;
    std::optional<FitField> field_;         // of the last fit
    std::int64_t surface_places_ = 100'000; // that f is asked at to find the surface, about
    FitMeshReport report_;
};

} // namespace

MeshFit fit_mesh(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const FitMeshSettings& settings,
                 const fit::FitInput& options, const base::Progress& progress) {
    refuse_flat_solid(mesh);
    return Fitter(runtime, mesh, tree, settings, options, progress).run();
}

} // namespace hrbfnpr::mesh
