// SPDX-License-Identifier: MIT
#include "mesh/pieces/fit_pieces.h"

#include "base/clock.h"
#include "mesh/fit/flat.h"
#include "mesh/fit/outer.h"
#include "mesh/fit/touching.h"
#include "mesh/pieces/contacts.h"
#include "mesh/pieces/fit_sheet.h"
#include "mesh/sample.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hrbfnpr::mesh {
namespace {

// Shares of the fit's tolerance: at creases, where an error shows as a wave in a straight line, and far from them.
constexpr double at_crease = 0.025;
constexpr double far_from_crease = 0.25;
constexpr double ramp = 0.05;             // diagonals
constexpr std::int64_t fewest = 8;        // centres that each sheet may have ...
constexpr std::int64_t room_a_sheet = 32; // ... and that there may be for each, at least
constexpr std::int64_t even_places = 2000;
constexpr std::int64_t fewest_on_parts = 4000;
constexpr std::int64_t most_on_parts = 100000;
constexpr double cells_a_diagonal = 72.0; // that the surface is looked for in, when it is measured
constexpr double contact = 1e-4; // diagonals: parts that are no farther from each other, and by how much they grow
constexpr std::int64_t measured_places = 10000;
constexpr double support_limit = 3.0; // of what dense samples bear out

class Fitter {
public:
    Fitter(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const Creases& creases,
           const FitMeshSettings& settings, const fit::FitInput& options, const base::Progress& progress)
        : runtime_(runtime), mesh_(mesh), tree_(tree), creases_(creases), settings_(settings), options_(options),
          progress_(progress), result_{implicit::PiecesData(runtime.memory), {}, {}, {}} {
        const double diagonal = mesh.bounds.diagonal();
        result_.mesh.tolerance = settings.tolerance > 0.0 ? settings.tolerance : default_tolerance * diagonal;
        result_.mesh.far = settings.far > 0.0 ? settings.far : 5.0 * result_.mesh.tolerance;
        unit_ = at_crease * result_.mesh.tolerance;
        result_.mesh.supported = mesh.report.boundary_edges > 0;
    }

    [[nodiscard]] PiecesFit run() {
        base::Stopwatch watch;
        look_at_parts();
        fit_sheets();
        result_.mesh.seconds_fit = watch.seconds();
        watch.restart();
        make_cells();
        result_.pieces.seconds_cells = watch.seconds();
        watch.restart();
        measure();
        result_.mesh.seconds_measure = watch.seconds();
        result_.pieces.sheets = static_cast<std::int32_t>(result_.data.sheet.size());
        result_.pieces.crease_length = creases_.length - creases_.fading;
        result_.pieces.smooth_length = creases_.fading;
        result_.mesh.seconds_total = result_.fit.seconds_total = watch_.seconds();
        progress_.update(1.0);
        return std::move(result_);
    }

private:
    void look_at_parts() {
        const MeshSamples places = places_on_parts();
        const bool solids = !result_.mesh.supported;
        warn_of_touching(runtime_, mesh_, tree_, places, result_.mesh.tolerance, solids, progress_);
        if (solids && has_parts(mesh_))
            in_contact_ = patches_in_contact(runtime_, mesh_, tree_, creases_, places,
                                             contact * mesh_.bounds.diagonal(), progress_);
    }

    // A sheet that lies against another part grows by so much that the two go through each other: where both are 0, or
    // next to it, there would be surface in the midst of the solid.
    void grow(std::int32_t p, fit::Samples& samples) const noexcept {
        if (in_contact_.empty() || in_contact_[p] == 0) return;
        const double by = contact * mesh_.bounds.diagonal();
        for (std::int64_t i = 0; i < samples.position.size(); ++i)
            samples.position.set(i, samples.position[i] + by * samples.normal[i]);
    }

    // So many that no contact of two parts is missed that matters.
    [[nodiscard]] MeshSamples places_on_parts() const {
        const std::int64_t count = std::clamp(mesh_.faces(), fewest_on_parts, most_on_parts);
        return random_samples(runtime_, mesh_, count, settings_.seed, 2, progress_);
    }

    // The faces of each patch, one after the other.
    void group_faces() {
        first_.resize(creases_.patches + 1);
        for (const std::int32_t patch : creases_.patch) ++first_[patch + 1];
        for (const Creases::Shared& shared : creases_.shared) ++first_[shared.patch + 1];
        for (std::int32_t p = 0; p < creases_.patches; ++p) first_[p + 1] += first_[p];
        faces_.resize(mesh_.faces() + creases_.shared.size());
        base::Array<std::int64_t> next(runtime_.memory);
        for (const std::int64_t at : first_) next.push_back(at);
        for (std::int64_t face = 0; face < mesh_.faces(); ++face)
            faces_[next[creases_.patch[face]]++] = static_cast<std::int32_t>(face);
        for (const Creases::Shared& shared : creases_.shared) faces_[next[shared.patch]++] = shared.face;
    }

    // Of many sheets each takes few, and is solved alone.
    [[nodiscard]] std::int64_t most_centres() const noexcept {
        return std::max(settings_.maximum_centres, room_a_sheet * creases_.patches);
    }

    // Small patches first: what they need not is left to the larger ones.
    [[nodiscard]] base::Array<std::int32_t> small_first() const {
        base::Array<std::int32_t> order(runtime_.memory);
        for (std::int32_t p = 0; p < creases_.patches; ++p) order.push_back(p);
        std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
            const std::int64_t of_a = first_[a + 1] - first_[a];
            const std::int64_t of_b = first_[b + 1] - first_[b];
            return of_a < of_b || (of_a == of_b && a < b);
        });
        return order;
    }

    void fit_sheets() {
        group_faces();
        const PatchNormals normal = patch_normals(runtime_, mesh_, creases_, result_.mesh.tolerance);
        chord_ = chord_errors(mesh_, normal.normal);
        const PatchTolerance tolerance{at_crease * result_.mesh.tolerance, far_from_crease * result_.mesh.tolerance,
                                       ramp * mesh_.bounds.diagonal()};
        std::int64_t faces_left = faces_.size();
        std::int64_t centres = 0;
        base::List<SheetFit> made(runtime_.memory);
        base::Array<std::int64_t> at(runtime_.memory, creases_.patches);
        base::Array<std::int32_t> starved(runtime_.memory); // for which their share was too little
        for (const std::int32_t p : small_first()) {
            at[p] = made.size();
            const std::int64_t faces = first_[p + 1] - first_[p];
            const double share = static_cast<double>(faces) / static_cast<double>(faces_left);
            const std::int64_t room = std::max<std::int64_t>(most_centres() - centres, 0);
            const std::int64_t most = std::max(fewest, static_cast<std::int64_t>(share * static_cast<double>(room)));
            made.add(fit_patch(p, normal, tolerance, most));
            faces_left -= faces;
            centres += made.back().data.count();
            const bool far = made.back().report.input_distance_max > result_.mesh.tolerance;
            if (far && made.back().data.count() >= most) starved.push_back(p);
            progress_.update(0.5 * (1.0 - static_cast<double>(faces_left) / static_cast<double>(faces_.size())));
        }
        // A few coarse faces may stand for what takes many centres, as cones do.
        for (std::int64_t left = starved.size(); const std::int32_t p : starved) {
            SheetFit& one = made[at[p]];
            const std::int64_t more = std::max<std::int64_t>(most_centres() - centres, 0) / left--;
            if (more < one.data.count() / 4) continue;
            centres -= one.data.count();
            one = fit_patch(p, normal, tolerance, one.data.count() + more);
            centres += one.data.count();
        }
        progress_.update(0.6);
        for (const std::int64_t i : at) add_to_report(made[i]);
        for (std::int32_t p = 0; p < creases_.patches; ++p) result_.data.sheet.add(std::move(made[at[p]].data));
        finish_report();
        gather_samples(normal.normal);
    }

    // Places that whoever looks for the surface may begin at.
    void gather_samples(const base::Array<glm::dvec3>& normal) {
        MeshSamples even = even_samples(runtime_, mesh_, even_places, 4 * even_places, settings_.seed, progress_);
        for (std::int64_t i = 0; i < even.position.size(); ++i) {
            const glm::dvec3 shares = shares_of(mesh_.corners(even.face[i]), even.position[i]);
            const glm::dvec3* const n = normal.data() + 3 * std::int64_t{even.face[i]};
            even.normal.set(i, glm::normalize(shares.x * n[0] + shares.y * n[1] + shares.z * n[2]));
        }
        keep_outer(runtime_, mesh_, tree_, even.position, even.normal, progress_);
        fit::Samples samples(runtime_.memory);
        samples.position = std::move(even.position);
        fit::measure_extent(runtime_, samples, progress_);
        result_.data.spacing = samples.spacing;
        for (std::int64_t i = 0; i < samples.position.size(); ++i)
            for (int c = 0; c < 3; ++c) {
                result_.data.sample_position.push_back(samples.position[i][c]);
                result_.data.sample_normal.push_back(even.normal[i][c]);
            }
    }

    [[nodiscard]] SheetFit fit_patch(std::int32_t p, const PatchNormals& normal, const PatchTolerance& tolerance,
                                     std::int64_t most) {
        const std::span<const std::int32_t> faces = faces_.span().subspan(
            static_cast<std::size_t>(first_[p]), static_cast<std::size_t>(first_[p + 1] - first_[p]));
        PatchSamples patch = sample_patch(runtime_, mesh_, creases_, normal, faces, tolerance, progress_);
        grow(p, patch.samples);
        SheetFit made = fit_sheet(runtime_, patch, options_, most, progress_.part(0.0, 0.0));
        runtime_.log(base::LogLevel::debug,
                     "pieces: sheet %d: %lld faces, %lld samples, %lld centres in %d rounds, %lld outside, the worst "
                     "by %.2f",
                     static_cast<int>(p), static_cast<long long>(faces.size()),
                     static_cast<long long>(patch.samples.position.size()), static_cast<long long>(made.data.count()),
                     static_cast<int>(made.rounds), static_cast<long long>(made.outside), made.worst);
        return made;
    }

    // The worst of all sheets; means over all.
    void add_to_report(const SheetFit& made) noexcept {
        fit::FitReport& all = result_.fit;
        const fit::FitReport& one = made.report;
        const auto count = static_cast<double>(made.data.count());
        all.kernel_radius = std::max(all.kernel_radius, one.kernel_radius);
        all.regularization = std::max(all.regularization, one.regularization);
        all.solver_residual = std::max(all.solver_residual, one.solver_residual);
        all.condition_estimate = std::max(all.condition_estimate, one.condition_estimate);
        all.iterations = std::max(all.iterations, one.iterations);
        result_.mesh.rounds = std::max(result_.mesh.rounds, made.rounds);
        result_.mesh.candidates += made.samples;
        all.choice_rounds = std::max(all.choice_rounds, one.choice_rounds);
        all.fallback = all.fallback || one.fallback;
        if (one.solver == fit::SolverKind::iterative) all.solver = one.solver;
        all.value_residual_max = std::max(all.value_residual_max, one.value_residual_max);
        all.gradient_residual_max = std::max(all.gradient_residual_max, one.gradient_residual_max);
        values_ += count * (one.value_residual_rms / unit_) * (one.value_residual_rms / unit_);
        gradients_ += count * one.gradient_residual_rms * one.gradient_residual_rms;
        squares_ += made.squares;
        centres_ += count;
        all.input_distance_max = std::max(all.input_distance_max, one.input_distance_max);
        all.seconds_assemble += one.seconds_assemble;
        all.seconds_precondition += one.seconds_precondition;
        all.seconds_solve += one.seconds_solve;
    }

    void finish_report() noexcept {
        fit::FitReport& all = result_.fit;
        all.samples = result_.mesh.candidates;
        all.value_residual_rms = unit_ * std::sqrt(values_ / centres_);
        all.gradient_residual_rms = std::sqrt(gradients_ / centres_);
        all.input_distance_rms = std::sqrt(squares_ / static_cast<double>(all.samples));
    }

    void make_cells() {
        const Sides sides(runtime_, mesh_, tree_, progress_);
        const CellsReport report = mesh::make_cells(runtime_, mesh_, creases_, sides, chord_, settings_.seed,
                                                    result_.data, progress_.part(0.6, 0.85));
        result_.pieces.cells = report.cells;
        result_.pieces.poor_cells = report.poor_cells;
        runtime_.log(base::LogLevel::debug, "pieces: %lld cells, %lld with surface, %lld of them poor",
                     static_cast<long long>(report.cells), static_cast<long long>(report.surface_cells),
                     static_cast<long long>(report.poor_cells));
    }

    // What sheets of an open mesh do beyond its borders is no error: a drawing trims it.
    [[nodiscard]] std::optional<surface::Support> support_of_open() const {
        if (!result_.mesh.supported) return std::nullopt;
        const MeshSamples places = places_on_parts();
        return std::make_optional<surface::Support>(runtime_, places.position, places.normal, 0.0, progress_);
    }

    // Both ways, at places of their own.
    void measure() {
        implicit::Pieces made(runtime_.instruction_set, std::move(result_.data));
        CompareSettings settings;
        settings.tolerance = result_.mesh.tolerance;
        settings.far = result_.mesh.far;
        settings.points = measured_places;
        settings.cell_size = mesh_.bounds.diagonal() / cells_a_diagonal;
        settings.seed = settings_.seed;
        const std::optional<surface::Support> support = support_of_open();
        settings.support = support ? support_limit : 0.0;
        const Comparison found =
            compare(runtime_, made, mesh_, tree_, support ? &*support : nullptr, settings, progress_.part(0.85, 1.0));
        result_.mesh.surface = found.surface;
        result_.mesh.mesh = found.mesh;
        const auto good = [&](const Spread& spread) {
            return spread.points > 0 && spread.share >= settings_.share && spread.most <= result_.mesh.far;
        };
        result_.mesh.reached = good(found.surface) && good(found.mesh);
        result_.data = std::move(made).take();
    }

    const base::Runtime& runtime_;
    const Mesh& mesh_;
    const FaceTree& tree_;
    const Creases& creases_;
    const FitMeshSettings& settings_;
    const fit::FitInput& options_;
    const base::Progress& progress_;
    const base::Stopwatch watch_;
    base::Array<std::int64_t> first_{runtime_.memory};
    base::Array<std::int32_t> faces_{runtime_.memory};
    base::Array<std::uint8_t> in_contact_{runtime_.memory}; // patches
    double unit_ = 0.0;                                     // the least tolerance of a sample
    double values_ = 0.0, gradients_ = 0.0, squares_ = 0.0, centres_ = 0.0;
    base::Array<double> chord_{runtime_.memory};
    PiecesFit result_;
};

} // namespace

PiecesFit fit_pieces(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const Creases& creases,
                     const FitMeshSettings& settings, const fit::FitInput& options, const base::Progress& progress) {
    refuse_flat_solid(mesh);
    return Fitter(runtime, mesh, tree, creases, settings, options, progress).run();
}

} // namespace hrbfnpr::mesh
