// SPDX-License-Identifier: MIT
// The steps of fit_as_planned(), in order:
//
//   find_planned_creases      finds the edges that stay sharp
//   fit_mesh, fit_sheet_tree   fit one smooth surface, or sheets
//   find_end                  decides where the surface ends
#include "mesh/pieces/fit_as_planned.h"

#include "base/assert.h"
#include "mesh/tuning.h"

#include <utility>

namespace hrbfnpr::mesh {
namespace {

// Finds the creases of each component by the evidence for that component: one component may have edges while another
// has none.
Creases creases_that_are_meant(const base::Work& work, const Mesh& mesh, const CreaseEvidence& whole,
                               const FitMeshSettings& settings, double far, double tolerance) {
    const CreaseEvidenceOfParts found = look_for_creases_of_parts(work, mesh, settings.crease_angle);
    base::Array<Sharpness> sharpness(work.memory);
    for (const CreaseEvidence& part : found.part)
        sharpness.push_back(plan_sharpness(part, whole, settings.crease_angle, far, tolerance));
    Creases creases = find_creases(work, mesh, sharpness, found.sharp);
    const base::Array<Crumbs> crumbs = find_crumbs(work, mesh, creases);
    const base::Array<double> area = areas_of_components(work, mesh);
    bool crumbled = false;
    for (std::int64_t i = 0; i < crumbs.size(); ++i) {
        if (!is_crumbled(crumbs[i], area[i])) continue;
        crumbled = true;
        sharpness[i] = plan_crumbled();
    }
    return crumbled ? find_creases(work, mesh, sharpness, found.sharp) : std::move(creases);
}

void log_doubt(const base::Runtime& runtime, const PlannedCreases& found, double crease_angle) {
    if (found.doubtful > 0.0)
        runtime.log(
            base::LogLevel::info,
            "mesh fit: bends of over %g degrees, %.3g diagonals long, are fitted smooth; edges SHARP makes them sharp",
            crease_angle, found.doubtful);
}

void log_fit(const base::Runtime& runtime, const FitMeshReport& report, std::int64_t centres) {
    runtime.log(base::LogLevel::info,
                "mesh fit: %lld centres in %d rounds, %.3f s; within %.3g: %.2f %% of the mesh, %.2f %% of the surface",
                static_cast<long long>(centres), static_cast<int>(report.rounds), report.seconds_total,
                report.tolerance, 100.0 * report.mesh.share, 100.0 * report.surface.share);
    if (!report.reached)
        runtime.log(base::LogLevel::warning,
                    "mesh fit: tolerance not reached: mesh off by up to %.3g, surface by %.3g; raise maximum_centres "
                    "or tolerance",
                    report.mesh.most, report.surface.most);
}

void log_pieces(const base::Runtime& runtime, const SheetTreeReport& report) {
    runtime.log(base::LogLevel::info, "mesh fit: %d sheets in %lld cells meet in creases %.4g long",
                static_cast<int>(report.sheets), static_cast<long long>(report.cells), report.crease_length);
    if (report.smooth_length > 0.0 || report.poor_cells > 0)
        runtime.log(
            base::LogLevel::warning,
            "mesh fit: edges %.4g long are smoothed; in %lld cells the sheets do not combine to the mesh exactly",
            report.smooth_length, static_cast<long long>(report.poor_cells));
}

// Decides where the surface ends, and stores the result in `made`. If it ends with the support of some places, these
// are stored, too. `samples` are the samples of a smooth fit.
void find_end(const base::Work& work, const Mesh& mesh, const FaceTree& tree, std::uint64_t seed, bool may_end,
              std::optional<fit::Samples>&& samples, PlannedFit& made) {
    made.end = plan_end(end_facts(mesh, made.report, made.pieces.has_value()), may_end);
    if (made.end.end == End::at_samples) {
        HRBFNPR_ASSERT(samples.has_value());
        made.end_place = std::move(samples->position);
        made.end_normal = std::move(samples->normal);
    }
    if (made.end.end != End::at_places) return;
    MeshSamples places = end_places(work, mesh, tree, made.end, seed);
    made.end_place = std::move(places.position);
    made.end_normal = std::move(places.normal);
}

} // namespace

PlannedCreases find_planned_creases(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                    const CreaseEvidence& known, const FitMeshSettings& settings) {
    const double angle = settings.crease_angle;
    const double tolerance = plan_tolerance(settings.tolerance, mesh.bounds.diagonal());
    const double far = plan_far(settings.far, tolerance);
    CreaseEvidence whole = known;
    if (settings.edges == Edges::automatic && angle != default_crease_angle)
        whole = look_for_creases(work, mesh, angle);
    const auto solids_cross = [&] {
        return mesh.report.boundary_edges == 0 && find_crossing(work, mesh, tree).one >= 0;
    };
    PlannedCreases planned;
    if (settings.edges == Edges::automatic && !whole.creases) planned.doubtful = whole.length;
    const SharpEdges sharp = plan_edges(settings.edges, whole, std::ref(solids_cross));
    if (sharp == SharpEdges::none) return planned;
    Creases creases = sharp == SharpEdges::meant ? creases_that_are_meant(work, mesh, whole, settings, far, tolerance)
                                                 : find_creases(work, mesh, plan_sharpness(angle, far));
    if (creases.patches >= 2)
        planned.creases = std::move(creases);
    else if (settings.edges == Edges::automatic)
        planned.doubtful = whole.length;
    return planned;
}

EndFacts end_facts(const Mesh& mesh, const FitMeshReport& report, bool has_creases) noexcept {
    EndFacts facts;
    facts.diagonal = mesh.bounds.diagonal();
    facts.area = mesh.report.area;
    facts.border = border_length(mesh);
    facts.has_border = mesh.report.boundary_edges > 0;
    facts.closed = mesh.report.closed;
    facts.has_creases = has_creases;
    facts.reached = report.reached;
    facts.mesh_p99 = report.mesh.p99;
    facts.surface_p99 = report.surface.p99;
    facts.surface_most = report.surface.most;
    return facts;
}

MeshSamples end_places(const base::Work& work, const Mesh& mesh, const FaceTree& tree, const EndPlan& plan,
                       std::uint64_t seed) {
    HRBFNPR_ASSERT(plan.off > 0.0);
    return end_samples(work, mesh, tree, plan_tuning.places, plan.off * mesh.bounds.diagonal(), seed);
}

PlannedFit fit_as_planned(const base::Work& work, const Mesh& mesh, const FaceTree& tree, const CreaseEvidence& known,
                          const FitMeshSettings& settings, const fit::FitInput& options, bool may_end) {
    constexpr double end_of_fit = 0.95; // the share of the progress at the end of the fit
    const base::Work of_fit = work.part(0.0, end_of_fit);
    const PlannedCreases planned = find_planned_creases(work, mesh, tree, known, settings);
    log_doubt(work, planned, settings.crease_angle);
    PlannedFit made(work.memory);
    std::optional<fit::Samples> samples;
    if (planned.creases) {
        made.pieces = fit_sheet_tree(of_fit, mesh, tree, *planned.creases, settings, options);
        made.report = made.pieces->mesh;
        made.centres = made.pieces->data.centres();
    } else {
        MeshFit smooth = fit_mesh(of_fit, mesh, tree, settings, options);
        made.report = smooth.report;
        made.centres = smooth.fit.data.count();
        samples = std::exchange(smooth.fit.samples, std::nullopt);
        made.smooth = std::move(smooth.fit);
    }
    log_fit(work, made.report, made.centres);
    if (made.pieces) log_pieces(work, made.pieces->pieces);
    find_end(work.part(end_of_fit, 1.0), mesh, tree, settings.seed, may_end, std::move(samples), made);
    work.update(1.0);
    return made;
}

} // namespace hrbfnpr::mesh
