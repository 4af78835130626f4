// SPDX-License-Identifier: MIT
// The steps of fit_sheet_tree(), in order:
//
//   fit_sheets      fits a sheet to each patch, smaller patches first: a Hermite fit by fit_sheet()
//   report_sheets   makes one report of their errors
//   make_whole      makes the cells that join the sheets, and measures how far the surface is from the mesh
//   improves        repeats this with patches divided along edges that bend less, while some place is far off
#include "mesh/pieces/fit_sheet_tree.h"

#include "base/clock.h"
#include "base/groups.h"
#include "fit/adaptive.h"
#include "mesh/fit/outer.h"
#include "mesh/pieces/cells.h"
#include "mesh/pieces/patches.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

namespace hrbfnpr::mesh {
namespace {

// ---- One sheet

struct SheetFit {
    implicit::HrbfData data;
    fit::FitReport report;    // the residuals at the centres, and the distances of all samples
    double squares = 0.0;     // the sum of the squared distances of the samples
    double worst = 0.0;       // the largest ratio of a sample's distance to its tolerance
    std::int64_t outside = 0; // the number of samples beyond their tolerance
    std::int32_t rounds = 0;
    std::int64_t samples = 0;
};

// Returns the centres of a fit with their normals.
fit::Samples centres_of(base::Memory& memory, const implicit::HrbfData& data) {
    fit::Samples centres(memory);
    const double* const p = data.sample_position.data();
    const double* const n = data.sample_normal.data();
    for (std::int64_t i = 0; i < 3 * data.count(); i += 3) {
        centres.position.push_back({p[i], p[i + 1], p[i + 2]});
        centres.normal.push_back({n[i], n[i + 1], n[i + 2]});
    }
    return centres;
}

// Fits a sheet to a patch. Adds samples as centres until the fit is within the tolerance, or has `most` centres.
[[nodiscard]] SheetFit fit_sheet(const base::Work& work, const PatchSamples& patch, const fit::FitInput& given,
                                 std::int64_t most) {
    const fit::Samples& samples = patch.samples;
    HRBFNPR_ASSERT(most > 0 && !patch.tolerance.empty() && patch.tolerance.size() == samples.position.size());
    const double unit = *std::min_element(patch.tolerance.begin(), patch.tolerance.end());
    fit::FitInput options = given;
    options.tolerance = unit; // Accepts residuals that are too small to change a distance.
    const fit::Smoothing smoothing{options.regularization, options.regularization};

    std::optional<geometry::PointTree> tree;
    SheetFit sheet{implicit::HrbfData(work.memory), {}};
    double input_distance_max = 0.0;
    const auto look = [&](const fit::AdaptiveFit& now) {
        fit::NextCentres next(work.memory, smoothing);
        fit::Distances distances = fit::measure_distances(work, now.fit.result.data, samples);
        sheet.worst = sheet.squares = input_distance_max = 0.0;
        sheet.outside = 0;
        for (std::int64_t i = 0; i < distances.distance.size(); ++i) {
            const double distance = std::abs(distances.distance[i]);
            input_distance_max = std::max(input_distance_max, distance);
            sheet.squares += distance * distance;
            distances.distance[i] *= unit / patch.tolerance[i];
            const double off = std::abs(distances.distance[i]) / unit;
            sheet.worst = std::max(sheet.worst, off);
            sheet.outside += off > 1.0 ? 1 : 0;
        }
        const std::int64_t room = most - now.centres.size();
        if (sheet.outside == 0 || room <= 0) return next;
        const auto share = static_cast<std::int64_t>(sheet_tuning.batch * static_cast<double>(now.centres.size()));
        const fit::CandidateOptions wanted{unit, sheet_tuning.apart * unit,
                                           std::min(room, std::max(sheet_tuning.smallest_batch, share))};
        if (!tree) tree.emplace(samples.position, work);
        next.centres = fit::worst_candidates(work, samples, *tree, now.centres, distances, wanted).chosen;
        next.continues = !next.centres.empty();
        return next;
    };
    const std::int64_t first = patch.in_plane ? sheet_tuning.centres_in_plane : sheet_tuning.first_centres;
    fit::AdaptiveFit made = fit::fit_adaptively(work.without_progress(), options, samples,
                                                fit::even_choice(samples, std::min(first, most), work), smoothing,
                                                {sheet_tuning.most_rounds, 0.0, true}, std::ref(look));
    sheet.data = std::move(made.fit.result.data);
    sheet.report = made.fit.result.report;
    sheet.report.input_distance_max = input_distance_max;
    sheet.report.choice_rounds = sheet.rounds = made.rounds;
    sheet.samples = samples.position.size();
    describe_residuals(work, sheet.data, centres_of(work.memory, sheet.data), sheet.report);
    return sheet;
}

// ---- All sheets

struct SheetTreeTask {
    const base::Runtime& runtime;
    const Mesh& mesh;
    const FaceTree& tree;
    const MeshSamples& places; // places on all parts of the mesh
    const FitMeshSettings& settings;
    const fit::FitInput& options;
    const double tolerance;
};

struct SheetFits {
    SheetFits(base::Memory& memory, const Mesh& mesh, const Creases& from)
        : creases(from), faces(memory, from.patches,
                               [&](auto&& put) {
                                   for (std::int32_t face = 0; face < mesh.faces(); ++face) put(from.patch[face], face);
                                   for (const Creases::Shared& shared : from.shared) put(shared.patch, shared.face);
                               }),
          fit(memory), fit_from(memory, from.patches), unsettled(memory), chord(memory) {
        for (std::int32_t p = 0; p < from.patches; ++p) fit.add();
        std::fill(fit_from.begin(), fit_from.end(), -1);
    }

    const Creases& creases;
    base::Groups faces; // for each patch: its faces, then the faces of other patches beyond its smooth cuts
    base::List<std::optional<SheetFit>> fit; // the fit of each patch
    // For each patch: the patch of the other sheets from which its fit was taken, or -1.
    base::Array<std::int32_t> fit_from;
    base::Array<std::uint8_t> unsettled; // for each patch: 1 if too many of its samples are outside their tolerance
    double unsettled_area = 0.0;         // the area of unsettled patches, weighted by the share of samples outside
    base::Array<double> chord;           // chord_errors() of the vertices
};

// Takes over the fits of unchanged patches. Patches are only divided, never joined, so those with the same number of
// faces are unchanged.
void take_unchanged_fits(SheetFits& before, SheetFits& sheets) {
    for (std::int32_t p = 0; p < sheets.creases.patches; ++p) {
        const std::int32_t q = before.creases.patch[sheets.faces[p][0]];
        if (sheets.faces.count(p) != before.faces.count(q)) continue;
        sheets.fit_from[p] = q;
        sheets.fit[p] = std::exchange(before.fit[q], std::nullopt);
    }
}

void return_fits(SheetFits& sheets, SheetFits& before) {
    for (std::int32_t p = 0; p < sheets.creases.patches; ++p)
        if (sheets.fit_from[p] >= 0) before.fit[sheets.fit_from[p]] = std::exchange(sheets.fit[p], std::nullopt);
}

// Returns the patches, sorted by their count of faces. Small patches come first, so that larger patches can use the
// centres that small ones do not need.
[[nodiscard]] base::Array<std::int32_t> small_first(const SheetFits& sheets) {
    base::Array<std::int32_t> order(sheets.fit_from.memory());
    for (std::int32_t p = 0; p < sheets.creases.patches; ++p) order.push_back(p);
    std::sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return sheets.faces.count(a) < sheets.faces.count(b) ||
               (sheets.faces.count(a) == sheets.faces.count(b) && a < b);
    });
    return order;
}

[[nodiscard]] SheetFit fit_patch(const base::Work& work, const SheetTreeTask& task, const SheetFits& sheets,
                                 std::int32_t p, const PatchNormals& normals, bool grows, std::int64_t most) {
    PatchSamples patch =
        sample_patch(work, task.mesh, sheets.creases, normals, sheets.faces[p],
                     {pieces_tuning.at_crease * task.tolerance, pieces_tuning.far_from_crease * task.tolerance,
                      pieces_tuning.ramp * task.mesh.bounds.diagonal()});
    fit::Samples& samples = patch.samples;
    for (std::int64_t i = 0; grows && i < samples.position.size(); ++i)
        samples.position.set(i, samples.position[i] +
                                    pieces_tuning.contact * task.mesh.bounds.diagonal() * samples.normal[i]);
    return fit_sheet(work, patch, task.options, most);
}

// Gives the model places at which searches for its surface may begin.
void gather_samples(const SheetTreeTask& task, const base::Array<glm::dvec3>& normal, implicit::SheetTreeData& data,
                    const base::Progress& progress) {
    MeshSamples even = even_samples({task.runtime, progress}, task.mesh, pieces_tuning.even_places,
                                    4 * pieces_tuning.even_places, task.settings.seed);
    for (std::int64_t i = 0; i < even.position.size(); ++i) {
        const glm::dvec3 shares = shares_of(task.mesh.corners(even.face[i]), even.position[i]);
        const glm::dvec3* const n = normal.data() + 3 * std::int64_t{even.face[i]};
        even.normal.set(i, glm::normalize(shares.x * n[0] + shares.y * n[1] + shares.z * n[2]));
    }
    keep_outer({task.runtime, progress}, task.mesh, task.tree, even.position, even.normal);
    fit::Samples samples(task.runtime.memory);
    samples.position = std::move(even.position);
    fit::measure_extent({task.runtime, progress}, samples);
    data.spacing = samples.spacing;
    for (std::int64_t i = 0; i < samples.position.size(); ++i)
        for (int c = 0; c < 3; ++c) {
            data.sample_position.push_back(samples.position[i][c]);
            data.sample_normal.push_back(even.normal[i][c]);
        }
}

// The numbers of centres and of faces that are left for the sheets that are not fitted yet.
struct RoomLeft {
    std::int64_t centres = 0;
    std::int64_t faces = 0;

    // Returns the largest number of centres of the next sheet: its share of the centres, by its faces.
    [[nodiscard]] std::int64_t most_for(std::int64_t of_faces) const noexcept {
        const double share = static_cast<double>(of_faces) / static_cast<double>(faces);
        return std::max(pieces_tuning.fewest,
                        static_cast<std::int64_t>(share * static_cast<double>(std::max<std::int64_t>(centres, 0))));
    }
    void take(std::int64_t of_faces, std::int64_t used) noexcept {
        faces -= of_faces;
        centres -= used;
    }
};

// Fits the sheets of several patches at the same time. Each may have as many centres as if the others needed none.
void fit_at_once(const SheetTreeTask& task, SheetFits& sheets, std::span<const std::int32_t> patches,
                 const PatchNormals& normals, const base::Array<std::uint8_t>& grows, RoomLeft room,
                 const base::Progress& progress) {
    base::Array<std::int64_t> most(task.runtime.memory);
    for (const std::int32_t p : patches) {
        most.push_back(room.most_for(sheets.faces.count(p)));
        room.take(sheets.faces.count(p), 0);
    }
    if (patches.size() == 1) {
        const base::Work work(task.runtime, progress.without_progress());
        sheets.fit[patches[0]] = fit_patch(work, task, sheets, patches[0], normals, grows[patches[0]] != 0, most[0]);
        return;
    }
    const base::Runtime alone = base::Runtime::for_task(task.runtime);
    const base::Work work(alone, progress.without_progress());
    const auto count = static_cast<std::int64_t>(patches.size());
    task.runtime.parallel.for_each(count, progress, [&](std::int64_t task_index) {
        const std::int64_t i = count - 1 - task_index; // The largest come first, so that threads end at the same time.
        const std::int32_t p = patches[static_cast<std::size_t>(i)];
        sheets.fit[p] = fit_patch(work, task, sheets, p, normals, grows[p] != 0, most[i]);
    });
}

// Returns the number of patches, from the first of `order`, whose sheets are fitted at the same time. If many large
// patches are left, these are fitted like the small ones.
[[nodiscard]] std::size_t count_at_once(const SheetFits& sheets, std::span<const std::int32_t> order) noexcept {
    const std::size_t all = std::min(order.size(), static_cast<std::size_t>(sheet_tuning.at_once));
    const auto is_small = [&](std::int32_t p) { return sheets.faces.count(p) < sheet_tuning.large; };
    const auto small = static_cast<std::size_t>(std::count_if(order.begin(), order.end(), is_small));
    return order.size() - small >= static_cast<std::size_t>(sheet_tuning.many_large)
               ? all
               : std::clamp(small, std::size_t{1}, all);
}

void log_sheet(const SheetTreeTask& task, const SheetFits& sheets, std::int32_t p) {
    const SheetFit& made = *sheets.fit[p];
    task.runtime.log(
        base::LogLevel::debug,
        "pieces: sheet %d: %lld faces, %lld samples, %lld centres in %d rounds; %lld outside, worst by %.2f",
        static_cast<int>(p), static_cast<long long>(sheets.faces.count(p)), static_cast<long long>(made.samples),
        static_cast<long long>(made.data.count()), static_cast<int>(made.rounds), static_cast<long long>(made.outside),
        made.worst);
}

// Fits the sheets of `order`, smaller patches first, and returns the patches that need more centres than their share.
// The result is that of fitting one sheet after the other.
[[nodiscard]] base::Array<std::int32_t> fit_in_order(const SheetTreeTask& task, SheetFits& sheets,
                                                     std::span<const std::int32_t> order, const PatchNormals& normals,
                                                     const base::Array<std::uint8_t>& grows, RoomLeft& room,
                                                     const base::Progress& progress) {
    base::Array<std::int32_t> starved(task.runtime.memory);
    const base::Work work(task.runtime, progress.without_progress());
    const auto all_faces = static_cast<double>(room.faces);
    while (!order.empty()) {
        const std::span<const std::int32_t> patches = order.first(count_at_once(sheets, order));
        fit_at_once(task, sheets, patches, normals, grows, room, progress);
        for (const std::int32_t p : patches) {
            const std::int64_t most = room.most_for(sheets.faces.count(p));
            // The sheets before this one needed centres, so it may have too many now.
            if (sheets.fit[p]->data.count() > most)
                sheets.fit[p] = fit_patch(work, task, sheets, p, normals, grows[p] != 0, most);
            const SheetFit& made = *sheets.fit[p];
            room.take(sheets.faces.count(p), made.data.count());
            if (made.report.input_distance_max > task.tolerance && made.data.count() >= most) starved.push_back(p);
            log_sheet(task, sheets, p);
        }
        order = order.subspan(patches.size());
        progress.update(0.5 * (1.0 - static_cast<double>(room.faces) / all_faces));
    }
    return starved;
}

// Fits all sheets that are missing. Most take few centres.
void fit_sheets(const SheetTreeTask& task, SheetFits& sheets, SheetTreeFit& result, const base::Progress& progress) {
    const base::Runtime& runtime = task.runtime;
    const std::int32_t patches = sheets.creases.patches;
    // For each patch: 1 if it lies against another part. Its sheet is then moved outward a little, so that the two
    // parts cross. Otherwise both sheets would be nearly 0 at the contact, and surface would appear inside the solid.
    base::Array<std::uint8_t> grows(runtime.memory, patches);
    if (!result.mesh.supported && has_parts(task.mesh))
        grows = patches_in_contact({runtime, progress}, task.mesh, task.tree, sheets.creases, task.places,
                                   pieces_tuning.contact * task.mesh.bounds.diagonal());
    const PatchNormals normals = patch_normals(runtime, task.mesh, sheets.creases, task.tolerance);
    sheets.chord = chord_errors(task.mesh, normals.normal);
    RoomLeft room{std::max(task.settings.maximum_centres, pieces_tuning.room_a_sheet * patches), 0};
    base::Array<std::int32_t> missing(runtime.memory);
    for (const std::int32_t p : small_first(sheets)) {
        if (sheets.fit[p]) {
            room.take(0, sheets.fit[p]->data.count());
            continue;
        }
        missing.push_back(p);
        room.faces += sheets.faces.count(p);
    }
    const base::Array<std::int32_t> starved =
        fit_in_order(task, sheets, missing.span(), normals, grows, room, progress);
    // A patch of a few coarse faces, such as those of a cone, may need many centres.
    const base::Work work(runtime, progress.without_progress());
    for (std::int64_t left = starved.size(); const std::int32_t p : starved) {
        const std::int64_t before = sheets.fit[p]->data.count();
        const std::int64_t more = std::max<std::int64_t>(room.centres, 0) / left--;
        if (more < before / 4) continue;
        sheets.fit[p] = fit_patch(work, task, sheets, p, normals, grows[p] != 0, before + more);
        room.centres += before - sheets.fit[p]->data.count();
        log_sheet(task, sheets, p);
    }
    progress.update(0.6);
    gather_samples(task, normals.normal, result.data, progress);
}

// Reports the worst values of all sheets and means over all, and notes which patches are unsettled.
void report_sheets(const SheetTreeTask& task, SheetFits& sheets, SheetTreeFit& result) {
    fit::FitReport& all = result.fit;
    const double unit = pieces_tuning.at_crease * task.tolerance; // the least tolerance that a sample has
    double values = 0.0, gradients = 0.0, squares = 0.0, centres = 0.0;
    const auto raise = [](auto& to, auto value) { to = std::max(to, value); };
    for (std::int32_t p = 0; p < sheets.creases.patches; ++p) {
        const SheetFit& made = *sheets.fit[p];
        const fit::FitReport& one = made.report;
        const auto count = static_cast<double>(made.data.count());
        raise(all.kernel_radius, one.kernel_radius);
        raise(all.regularization, one.regularization);
        raise(all.solver_residual, one.solver_residual);
        raise(all.condition_estimate, one.condition_estimate);
        raise(all.iterations, one.iterations);
        raise(all.choice_rounds, one.choice_rounds);
        raise(all.value_residual_max, one.value_residual_max);
        raise(all.gradient_residual_max, one.gradient_residual_max);
        raise(all.input_distance_max, one.input_distance_max);
        raise(result.mesh.rounds, made.rounds);
        all.fallback = all.fallback || one.fallback;
        if (one.solver == fit::SolverKind::iterative) all.solver = one.solver;
        values += count * (one.value_residual_rms / unit) * (one.value_residual_rms / unit);
        gradients += count * one.gradient_residual_rms * one.gradient_residual_rms;
        squares += made.squares;
        centres += count;
        all.samples += made.samples;
        all.seconds_assemble += one.seconds_assemble;
        all.seconds_precondition += one.seconds_precondition;
        all.seconds_solve += one.seconds_solve;
        const double outside = static_cast<double>(made.outside) / static_cast<double>(made.samples);
        sheets.unsettled.push_back(outside > pieces_tuning.settled ? 1 : 0);
        if (sheets.unsettled[p] == 0) continue;
        double doubled = 0.0;
        for (const std::int32_t face : sheets.faces[p]) doubled += glm::length(doubled_area(task.mesh.corners(face)));
        sheets.unsettled_area += outside * (0.5 * doubled);
    }
    result.mesh.candidates = all.samples;
    all.value_residual_rms = unit * std::sqrt(values / centres);
    all.gradient_residual_rms = std::sqrt(gradients / centres);
    all.input_distance_rms = std::sqrt(squares / static_cast<double>(all.samples));
}

// ---- The whole

void move_sheets(SheetFits& from, implicit::SheetTreeData& to) {
    for (std::optional<SheetFit>& one : from.fit) to.sheet.add(std::move(one->data));
}

// Makes the cells, and measures the distances of surface and mesh in both directions, at new places. While it runs,
// `result` holds the sheets.
void make_whole(const SheetTreeTask& task, SheetFits& sheets, SheetTreeFit& result, const base::Progress& progress) {
    const base::Runtime& runtime = task.runtime;
    move_sheets(sheets, result.data);
    const CellsReport cells = make_cells({runtime, progress.part(0.6, 0.85)}, task.mesh, task.tree, sheets.creases,
                                         sheets.chord, task.settings.seed, result.data);
    runtime.log(base::LogLevel::debug, "pieces: %lld cells, %lld with surface, %lld of them poor",
                static_cast<long long>(cells.cells), static_cast<long long>(cells.surface_cells),
                static_cast<long long>(cells.poor_cells));
    result.pieces = {sheets.creases.patches, sheets.creases.length - sheets.creases.fading, sheets.creases.fading,
                     cells.cells, cells.poor_cells};
    const base::Stopwatch watch;
    implicit::SheetTree made(runtime.instruction_set, std::move(result.data));
    CompareSettings settings;
    settings.tolerance = result.mesh.tolerance;
    settings.far = result.mesh.far;
    settings.points = pieces_tuning.measured_places;
    settings.cell_size = task.mesh.bounds.diagonal() / pieces_tuning.cells_a_diagonal;
    settings.seed = task.settings.seed;
    // For an open mesh, errors of the sheets beyond the borders are ignored, because a drawing trims them.
    std::optional<surface::Support> support;
    if (result.mesh.supported)
        support.emplace(base::Work(runtime, progress), task.places.position, task.places.normal, 0.0);
    settings.support = support ? pieces_tuning.support_limit : 0.0;
    const Comparison found = compare({runtime, progress.part(0.85, 1.0)}, made, task.mesh, task.tree,
                                     support ? &*support : nullptr, settings);
    result.mesh.surface = found.surface;
    result.mesh.mesh = found.mesh;
    result.mesh.reached = found.surface.is_within(task.settings.share, result.mesh.far) &&
                          found.mesh.is_within(task.settings.share, result.mesh.far);
    result.data = std::move(made).take();
    for (std::int32_t p = 0; p < sheets.creases.patches; ++p) sheets.fit[p]->data = std::move(result.data.sheet[p]);
    result.data.sheet = base::List<implicit::HrbfData>(runtime.memory);
    result.mesh.seconds_measure = watch.seconds();
}

[[nodiscard]] double farthest(const FitMeshReport& report) noexcept {
    return std::max(report.mesh.most, report.surface.most);
}

[[nodiscard]] bool is_better(const FitMeshReport& one, const FitMeshReport& other) noexcept {
    const auto outside = [](const FitMeshReport& of) { return 1.0 - std::min(of.mesh.share, of.surface.share); };
    const double less_outside = outside(one) / outside(other);
    const double less_far = farthest(one) / farthest(other);
    return one.reached || (std::max(less_outside, less_far) <= pieces_tuning.no_worse &&
                           std::min(less_outside, less_far) < pieces_tuning.nearer);
}

[[nodiscard]] SheetTreeFit empty_result(const SheetTreeTask& task) {
    SheetTreeFit result{implicit::SheetTreeData(task.runtime.memory), {}, {}, {}};
    result.mesh.tolerance = task.tolerance;
    result.mesh.far = plan_far(task.settings.far, task.tolerance);
    result.mesh.supported = task.mesh.report.boundary_edges > 0;
    return result;
}

// Makes a model with more patches than the best model. It takes the sheets of unchanged patches from the best model.
// Returns whether the new model is better. If not, gives these sheets back.
[[nodiscard]] bool improves(const SheetTreeTask& task, SheetFits& sheets, SheetTreeFit& result, SheetFits& best_sheets,
                            const SheetTreeFit& best, const base::Progress& progress) {
    try {
        const base::Stopwatch watch;
        take_unchanged_fits(best_sheets, sheets);
        fit_sheets(task, sheets, result, progress);
        report_sheets(task, sheets, result);
        result.mesh.seconds_fit = watch.seconds();
        if (sheets.unsettled_area < pieces_tuning.promised * best_sheets.unsettled_area) {
            make_whole(task, sheets, result, progress);
            if (is_better(result.mesh, best.mesh)) return true;
        }
    } catch (const Error& error) {
        if (error.status() != Status::not_converged && error.status() != Status::singular_system) throw;
    }
    return_fits(sheets, best_sheets);
    return false;
}

} // namespace

SheetTreeFit fit_sheet_tree(const base::Work& work, const Mesh& mesh, const FaceTree& tree, const Creases& creases,
                            const FitMeshSettings& settings, const fit::FitInput& options) {
    constexpr double end_of_first = 0.7; // the share of the progress at the end of the first model
    HRBFNPR_ASSERT(creases.patches >= 1 && creases.patch.size() == mesh.faces());
    refuse_flat_solid(mesh);
    const base::Stopwatch watch;
    // The number of places is large enough to find all contacts of parts that matter.
    const MeshSamples places =
        random_samples(work, mesh, std::clamp(mesh.faces(), pieces_tuning.fewest_on_parts, pieces_tuning.most_on_parts),
                       settings.seed, 2);
    const SheetTreeTask task{
        work, mesh, tree, places, settings, options, plan_tolerance(settings.tolerance, mesh.bounds.diagonal())};
    const PartContact contact =
        warn_of_part_contact(work, mesh, tree, places, task.tolerance, mesh.report.boundary_edges == 0);
    SheetTreeFit best = empty_result(task);
    std::optional<SheetFits> sheets(std::in_place, work.memory, mesh, creases);
    const base::Work first = work.part(0.0, end_of_first);
    const base::Stopwatch first_watch;
    fit_sheets(task, *sheets, best, first);
    report_sheets(task, *sheets, best);
    best.mesh.seconds_fit = first_watch.seconds();
    make_whole(task, *sheets, best, first);
    double done = end_of_first;
    std::array<std::optional<Creases>, std::size(pieces_tuning.smaller_angles)> more;
    for (std::size_t i = 0; i < more.size() && settings.edges == Edges::automatic; ++i) {
        const double angle = pieces_tuning.smaller_angles[i];
        if (!(farthest(best.mesh) > best.mesh.far)) break; // Stop if no place is farther away than `far`.
        more[i].emplace(find_more_creases(work.part(done, done), mesh, sheets->creases, sheets->unsettled, angle));
        if (more[i]->patches == sheets->creases.patches) continue;
        const double next = 0.5 * (done + 1.0);
        SheetFits other_sheets(work.memory, mesh, *more[i]);
        SheetTreeFit other = empty_result(task);
        if (!improves(task, other_sheets, other, *sheets, best, work.part(done, next))) break;
        sheets.emplace(std::move(other_sheets));
        best = std::move(other);
        work.runtime().log(base::LogLevel::debug, "pieces: %d sheets, split along edges of %g degrees",
                           static_cast<int>(sheets->creases.patches), angle);
        done = next;
    }
    move_sheets(*sheets, best.data);
    best.mesh.contact = contact;
    best.mesh.seconds_total = best.fit.seconds_total = watch.seconds();
    work.update(1.0);
    return best;
}

} // namespace hrbfnpr::mesh
