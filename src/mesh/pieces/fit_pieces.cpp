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
#include <array>
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
// Of a sheet's samples those that may be outside its tolerance.  Where more are, and something is far off, its patch is
// parted along edges that bend by so many degrees.  That is kept if all is so much nearer, or so much less of it is
// outside: what is curved at random does not become better by it.
constexpr double settled = 0.02;
constexpr double smaller_angles[] = {20.0, 10.0};
constexpr double promised = 0.8; // of what is outside, before all is made and measured
constexpr double nearer = 0.8;
constexpr double no_worse = 1.1;     // of what is far off for another reason
constexpr double end_of_first = 0.7; // of the progress

[[nodiscard]] double tolerance_of(const Mesh& mesh, const FitMeshSettings& settings) noexcept {
    return settings.tolerance > 0.0 ? settings.tolerance : default_tolerance * mesh.bounds.diagonal();
}

class Fitter {
public:
    // places: on all parts.
    Fitter(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const MeshSamples& places,
           const Creases& creases, const FitMeshSettings& settings, const fit::FitInput& options,
           const base::Progress& progress)
        : runtime_(runtime), mesh_(mesh), tree_(tree), places_(places), creases_(creases), settings_(settings),
          options_(options), progress_(progress), result_{implicit::PiecesData(runtime.memory), {}, {}, {}} {
        result_.mesh.tolerance = tolerance_of(mesh, settings);
        result_.mesh.far = settings.far > 0.0 ? settings.far : 5.0 * result_.mesh.tolerance;
        unit_ = at_crease * result_.mesh.tolerance;
        result_.mesh.supported = mesh.report.boundary_edges > 0;
    }

    // before: of the same mesh with fewer creases, which lends the sheets of patches that are the same.
    void fit_sheets(Fitter* before) {
        look_at_parts();
        group_faces();
        fit_patches(before);
        result_.mesh.seconds_fit = watch_.seconds();
    }

    // From its sheets.
    void make_whole() {
        for (std::int32_t p = 0; p < creases_.patches; ++p) result_.data.sheet.add(std::move(made_[at_[p]].data));
        base::Stopwatch watch;
        make_cells();
        result_.pieces.seconds_cells = watch.seconds();
        watch.restart();
        measure();
        result_.mesh.seconds_measure = watch.seconds();
        result_.pieces.sheets = static_cast<std::int32_t>(result_.data.sheet.size());
        result_.pieces.crease_length = creases_.length - creases_.fading;
        result_.pieces.smooth_length = creases_.fading;
    }

    // The sheets that it was lent.
    void give_back(Fitter& before) {
        for (std::int32_t p = 0; p < creases_.patches; ++p) {
            if (!is_lent(p)) continue;
            implicit::HrbfData& data = result_.data.sheet.empty() ? made_[at_[p]].data : result_.data.sheet[p];
            before.result_.data.sheet[lent_[p]] = std::move(data);
        }
    }

    [[nodiscard]] const PiecesFit& result() const noexcept { return result_; }
    [[nodiscard]] PiecesFit take() { return std::move(result_); }

    // The same creases, and what bends by more than an angle within patches that no function goes through.
    [[nodiscard]] Creases more_creases(double angle) const {
        return find_more_creases(runtime_, mesh_, creases_, unsettled_, angle, progress_);
    }
    [[nodiscard]] std::int32_t patches() const noexcept { return creases_.patches; }
    // Area of patches that no function goes through, each by the share of its samples that are outside.
    [[nodiscard]] double unsettled_area() const noexcept { return unsettled_area_; }

private:
    void look_at_parts() {
        const bool solids = !result_.mesh.supported;
        if (solids && has_parts(mesh_))
            in_contact_ = patches_in_contact(runtime_, mesh_, tree_, creases_, places_,
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

    void fit_patches(Fitter* before) {
        const PatchNormals normal = patch_normals(runtime_, mesh_, creases_, result_.mesh.tolerance);
        chord_ = chord_errors(mesh_, normal.normal);
        const PatchTolerance tolerance{at_crease * result_.mesh.tolerance, far_from_crease * result_.mesh.tolerance,
                                       ramp * mesh_.bounds.diagonal()};
        at_.resize(creases_.patches);
        if (before != nullptr) borrow(*before);
        std::int64_t faces_left = 0;
        for (std::int32_t p = 0; p < creases_.patches; ++p) faces_left += is_lent(p) ? 0 : first_[p + 1] - first_[p];
        const auto all_faces = static_cast<double>(faces_left);
        std::int64_t centres = 0;
        for (const SheetFit& lent : made_) centres += lent.data.count();
        base::Array<std::int32_t> starved(runtime_.memory); // for which their share was too little
        for (const std::int32_t p : small_first()) {
            if (is_lent(p)) continue;
            const std::int64_t faces = first_[p + 1] - first_[p];
            const double share = static_cast<double>(faces) / static_cast<double>(faces_left);
            const std::int64_t room = std::max<std::int64_t>(most_centres() - centres, 0);
            const std::int64_t most = std::max(fewest, static_cast<std::int64_t>(share * static_cast<double>(room)));
            at_[p] = made_.size();
            made_.add(fit_patch(p, normal, tolerance, most));
            faces_left -= faces;
            centres += made_.back().data.count();
            const bool far = made_.back().report.input_distance_max > result_.mesh.tolerance;
            if (far && made_.back().data.count() >= most) starved.push_back(p);
            progress_.update(0.5 * (1.0 - static_cast<double>(faces_left) / all_faces));
        }
        // A few coarse faces may stand for what takes many centres, as cones do.
        for (std::int64_t left = starved.size(); const std::int32_t p : starved) {
            SheetFit& one = made_[at_[p]];
            const std::int64_t more = std::max<std::int64_t>(most_centres() - centres, 0) / left--;
            if (more < one.data.count() / 4) continue;
            centres -= one.data.count();
            one = fit_patch(p, normal, tolerance, one.data.count() + more);
            centres += one.data.count();
        }
        progress_.update(0.6);
        for (std::int32_t p = 0; p < creases_.patches; ++p) add_to_report(p, made_[at_[p]]);
        finish_report();
        gather_samples(normal.normal);
    }

    [[nodiscard]] bool is_lent(std::int32_t p) const noexcept { return !lent_.empty() && lent_[p] >= 0; }

    // Patches are parted, but not joined: those with as many faces are the same.
    void borrow(Fitter& before) {
        for (std::int32_t p = 0; p < creases_.patches; ++p) {
            const std::int32_t q = before.creases_.patch[faces_[first_[p]]];
            const bool same = first_[p + 1] - first_[p] == before.first_[q + 1] - before.first_[q];
            lent_.push_back(same ? q : -1);
            if (!same) continue;
            const SheetFit& of = before.made_[before.at_[q]];
            at_[p] = made_.size();
            made_.add(SheetFit{std::move(before.result_.data.sheet[q]), of.report, of.squares, of.worst, of.outside,
                               of.rounds, of.samples});
        }
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
    void add_to_report(std::int32_t p, const SheetFit& made) {
        fit::FitReport& all = result_.fit;
        const fit::FitReport& one = made.report;
        const auto count = static_cast<double>(made.data.count());
        all.kernel_radius = std::max(all.kernel_radius, one.kernel_radius);
        all.regularization = std::max(all.regularization, one.regularization);
        all.solver_residual = std::max(all.solver_residual, one.solver_residual);
        all.condition_estimate = std::max(all.condition_estimate, one.condition_estimate);
        all.iterations = std::max(all.iterations, one.iterations);
        const double outside = static_cast<double>(made.outside) / static_cast<double>(made.samples);
        unsettled_.push_back(outside > settled ? 1 : 0);
        if (outside > settled) unsettled_area_ += outside * area_of(p);
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

    [[nodiscard]] double area_of(std::int32_t p) const noexcept {
        double doubled = 0.0;
        for (std::int64_t i = first_[p]; i < first_[p + 1]; ++i)
            doubled += glm::length(doubled_area(mesh_.corners(faces_[i])));
        return 0.5 * doubled;
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
        return std::make_optional<surface::Support>(runtime_, places_.position, places_.normal, 0.0, progress_);
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
    const MeshSamples& places_;
    const Creases& creases_;
    const FitMeshSettings& settings_;
    const fit::FitInput& options_;
    const base::Progress progress_;
    const base::Stopwatch watch_;
    base::Array<std::int64_t> first_{runtime_.memory};
    base::Array<std::int32_t> faces_{runtime_.memory};
    base::Array<std::uint8_t> in_contact_{runtime_.memory}; // patches
    base::Array<std::uint8_t> unsettled_{runtime_.memory};  // patches
    double unsettled_area_ = 0.0;
    base::List<SheetFit> made_{runtime_.memory};
    base::Array<std::int64_t> at_{runtime_.memory};   // of each patch, in them
    base::Array<std::int32_t> lent_{runtime_.memory}; // of each patch, another fitter's that its sheet is of, or -1
    double unit_ = 0.0;                               // the least tolerance of a sample
    double values_ = 0.0, gradients_ = 0.0, squares_ = 0.0, centres_ = 0.0;
    base::Array<double> chord_{runtime_.memory};
    PiecesFit result_;
};

// So many that no contact of two parts is missed that matters.
[[nodiscard]] MeshSamples places_on_parts(const base::Runtime& runtime, const Mesh& mesh, std::uint64_t seed,
                                          const base::Progress& progress) {
    const std::int64_t count = std::clamp(mesh.faces(), fewest_on_parts, most_on_parts);
    return random_samples(runtime, mesh, count, seed, 2, progress);
}

[[nodiscard]] double farthest(const FitMeshReport& report) noexcept {
    return std::max(report.mesh.most, report.surface.most);
}

// Farther than coarse faces are off what is round.
[[nodiscard]] bool is_far_off(const FitMeshReport& report) noexcept { return farthest(report) > report.far; }

[[nodiscard]] bool is_better(const FitMeshReport& one, const FitMeshReport& other) noexcept {
    const auto outside = [](const FitMeshReport& of) { return 1.0 - std::min(of.mesh.share, of.surface.share); };
    const double less_outside = outside(one) / outside(other);
    const double less_far = farthest(one) / farthest(other);
    return one.reached || (std::max(less_outside, less_far) <= no_worse && std::min(less_outside, less_far) < nearer);
}

// With its sheets only, unless these are better.
[[nodiscard]] bool improves(Fitter& other, Fitter& best) {
    try {
        other.fit_sheets(&best);
        if (other.unsettled_area() < promised * best.unsettled_area()) {
            other.make_whole();
            if (is_better(other.result().mesh, best.result().mesh)) return true;
        }
    } catch (const Error& error) {
        if (error.status() != Status::not_converged && error.status() != Status::singular_system) throw;
    }
    other.give_back(best);
    return false;
}

} // namespace

PiecesFit fit_pieces(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const Creases& creases,
                     const FitMeshSettings& settings, const fit::FitInput& options, const base::Progress& progress) {
    refuse_flat_solid(mesh);
    const base::Stopwatch watch;
    const bool closed = mesh.report.boundary_edges == 0;
    const MeshSamples places = places_on_parts(runtime, mesh, settings.seed, progress);
    const Touching touching =
        warn_of_touching(runtime, mesh, tree, places, tolerance_of(mesh, settings), closed, progress);
    std::optional<Fitter> best(std::in_place, runtime, mesh, tree, places, creases, settings, options,
                               progress.part(0.0, end_of_first));
    best->fit_sheets(nullptr);
    best->make_whole();
    double done = end_of_first;
    std::array<std::optional<Creases>, std::size(smaller_angles)> more;
    for (std::size_t i = 0; i < more.size() && settings.edges == Edges::automatic; ++i) {
        if (!is_far_off(best->result().mesh)) break;
        more[i].emplace(best->more_creases(smaller_angles[i]));
        if (more[i]->patches == best->patches()) continue;
        const double next = 0.5 * (done + 1.0);
        Fitter other(runtime, mesh, tree, places, *more[i], settings, options, progress.part(done, next));
        if (!improves(other, *best)) break;
        best.emplace(std::move(other));
        runtime.log(base::LogLevel::debug, "pieces: %d sheets, parted along edges of %g degrees",
                    static_cast<int>(best->patches()), smaller_angles[i]);
        done = next;
    }
    PiecesFit result = best->take();
    result.mesh.touching = touching;
    result.mesh.seconds_total = result.fit.seconds_total = watch.seconds();
    progress.update(1.0);
    return result;
}

} // namespace hrbfnpr::mesh
