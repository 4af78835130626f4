// SPDX-License-Identifier: MIT
#include "mesh/pieces/plan.h"

#include "base/assert.h"
#include "mesh/fit/outer.h"
#include "mesh/pieces/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::mesh {
namespace {

// With this limit a round mesh has one sheet for each of its parts: no edge is sharp, and no face is too coarse.
constexpr Sharpness no_creases{180.0, std::numeric_limits<double>::infinity()};

// Tells whether solids intersect each other. One function cannot represent them where they do.
bool crosses(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const base::Progress& progress) {
    return mesh.report.boundary_edges == 0 && find_crossing(runtime, mesh, tree, progress).one >= 0;
}

// What a mesh asks of its creases. Coarse faces stay flat in smooth parts of meshes with edges if something round would
// leave them by more than the tolerance.
struct Limits {
    double angle, coarse; // of parts with edges
    double tolerance;
    bool has_edges; // Most edges stand out.
};

Sharpness sharpness_of(const CreaseEvidence& part, const Limits& limits) noexcept {
    if (part.polyhedron) return {plan_tuning.flat_faces * limits.angle, limits.coarse};
    if (part.creases) return {limits.angle, limits.coarse};
    return {no_creases.angle, limits.has_edges ? limits.tolerance : no_creases.coarse};
}

// Finds the creases that are meant in each component, as one may have edges and another none.
Creases creases_that_are_meant(const base::Runtime& runtime, const Mesh& mesh, const Limits& limits,
                               const base::Progress& progress) {
    const CreaseEvidenceOfParts found = look_for_creases_of_parts(runtime, mesh, limits.angle, progress);
    base::Array<Sharpness> sharpness(runtime.memory);
    for (const CreaseEvidence& part : found.part) sharpness.push_back(sharpness_of(part, limits));
    return find_creases(runtime, mesh, sharpness, found.sharp, progress);
}

// Returns the lower bound of how_far_off(), in diagonals. A support with wide spacings cannot end a narrow strip. So
// for a mesh that is met exactly the bound is a share of its mean width, 2 area / border, but no less than the distance
// between its places.
double least_off(const Mesh& mesh, const FitMeshReport& report) noexcept {
    const double diagonal = mesh.bounds.diagonal();
    const double border = border_length(mesh);
    if (border == 0.0 || !(std::max(report.mesh.p99, report.surface.p99) < plan_tuning.exact * diagonal))
        return plan_tuning.least_off;
    const double dense = std::sqrt(mesh.report.area / static_cast<double>(plan_tuning.places));
    const double narrow = plan_tuning.of_width * 2.0 * mesh.report.area / border;
    return std::clamp(std::max(narrow, plan_tuning.of_places * dense) / diagonal, plan_tuning.least_off_exact,
                      plan_tuning.least_off);
}

// Returns the distance, in diagonals, beyond which surface does not belong to the mesh. Where a mesh has coarse faces
// for a round shape, they are far off the round surface everywhere.
double how_far_off(const Mesh& mesh, const FitMeshReport& report) noexcept {
    const double p99 = report.mesh.p99 / mesh.bounds.diagonal();
    const double least = least_off(mesh, report);
    return p99 > 0.0 ? std::clamp(plan_tuning.of_coarse_faces * p99, least, plan_tuning.most_off) : least;
}

} // namespace

CreasePlan plan_creases(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                        const CreaseEvidence& known, const FitMeshSettings& settings, const base::Progress& progress) {
    if (settings.edges == Edges::smooth) return {};
    const double tolerance = settings.tolerance > 0.0 ? settings.tolerance : default_tolerance * mesh.bounds.diagonal();
    Limits limits{settings.crease_angle, plan_tuning.too_coarse * (settings.far > 0.0 ? settings.far : 5.0 * tolerance),
                  tolerance, true};
    CreasePlan plan;
    if (settings.edges == Edges::automatic) {
        const CreaseEvidence found = settings.crease_angle == default_crease_angle
                                         ? known
                                         : look_for_creases(runtime, mesh, settings.crease_angle, progress);
        if (!found.creases) plan.doubtful = found.length;
        if (!found.creases && !crosses(runtime, mesh, tree, progress)) return plan;
        limits.has_edges = found.standing >= has_creases_tuning.enough;
    }
    Creases creases = settings.edges == Edges::automatic
                          ? creases_that_are_meant(runtime, mesh, limits, progress)
                          : find_creases(runtime, mesh, limits.angle, limits.coarse, progress);
    if (creases.patches >= 2) plan.creases = std::move(creases);
    return plan;
}

EndPlan plan_end(const Mesh& mesh, const FitMeshReport& report, bool has_creases) noexcept {
    const double off = how_far_off(mesh, report);
    if (mesh.report.boundary_edges > 0) return {End::at_places, off};
    // A fit with creases takes its inside from the mesh, so it invents no surface unless the mesh crosses itself, where
    // the inside is not defined.
    if (has_creases) return {report.surface.most > off * mesh.bounds.diagonal() ? End::at_places : End::nowhere, off};
    // A smooth fit that reached its tolerance has already checked that its surface is nowhere far from the mesh.
    return {report.reached ? End::nowhere : End::at_samples, off};
}

MeshSamples end_places(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const EndPlan& plan,
                       std::uint64_t seed, const base::Progress& progress) {
    HRBFNPR_ASSERT(plan.off > 0.0);
    return end_samples(runtime, mesh, tree, plan_tuning.places, plan.off * mesh.bounds.diagonal(), seed, progress);
}

} // namespace hrbfnpr::mesh
