// SPDX-License-Identifier: MIT
#include "mesh/pieces/plan.h"

#include "base/assert.h"
#include "mesh/fit/touching.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::mesh {
namespace {

struct PlanTuning {
    // Share of `far`: faces that are farther from something round as their normals are stay flat.  Larger: fewer do.
    double too_coarse = 0.8;
    // Share of the crease angle from which on a polyhedron of coarse faces has edges.  Larger: fewer of its edges are.
    double flat_faces = 0.5;
    // Diagonals: the least and the most of EndPlan::off.  Larger: more of the surface beyond a mesh stays.
    double least_off = 0.009;
    double most_off = 0.015;
    // Diagonals: the least of EndPlan::off where the fit is exact.  Larger: narrow strips end later.
    double least_off_exact = 0.001;
    // Diagonals: a fit is exact that is this near to the mesh, as those of planes and the like are.
    double exact = 2e-4;
    // Share of the width of a strip: there is room for a row of places on either side, and for something between.
    double of_width = 0.2;
    // Mean distances of the places.  Larger: the surface ends farther beyond the last ones.
    double of_places = 1.5;
    // Distances of 99 % of the mesh from the surface, as coarse faces have them everywhere.
    double of_coarse_faces = 1.5;
    // How many places show where a mesh ends.  Larger: the end is more exact, and is found later.
    std::int64_t places = 40000;
};
constexpr PlanTuning plan_tuning;

// Where a mesh is round, each of its parts is one sheet: no edge bends by this much, and no face is too coarse.
constexpr Sharpness no_creases{180.0, std::numeric_limits<double>::infinity()};

// Whether solids go through each other: one function would have to be two where they do.
bool crosses(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const base::Progress& progress) {
    return mesh.report.boundary_edges == 0 && find_crossing(runtime, mesh, tree, progress).one >= 0;
}

Sharpness sharpness_of(const CreaseEvidence& found, const FitMeshSettings& settings, double coarse) noexcept {
    if (!found.creases) return no_creases;
    return {found.polyhedron ? plan_tuning.flat_faces * settings.crease_angle : settings.crease_angle, coarse};
}

// Solids that go through each other are surfaces of their own: each has edges, or none.
Creases creases_of_solids(const base::Runtime& runtime, const Mesh& mesh, const FitMeshSettings& settings,
                          double coarse, const base::Progress& progress) {
    base::Array<Sharpness> sharpness(runtime.memory);
    for (const CreaseEvidence& found : look_for_creases_of_parts(runtime, mesh, settings.crease_angle, progress))
        sharpness.push_back(sharpness_of(found, settings, coarse));
    return find_creases(runtime, mesh, sharpness, progress);
}

// Diagonals: the least of how_far_off().  A support of wide spacings cannot end a narrow strip, so for a mesh that is
// met exactly they are a share of its mean width, 2 area / border, but no less than its places are apart.
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

// Diagonals: how far from a mesh a surface lies that is none of it.  Faces too coarse for what they stand for are far
// off a surface that is round, everywhere.
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
    Sharpness sharpness{settings.crease_angle,
                        plan_tuning.too_coarse * (settings.far > 0.0 ? settings.far : 5.0 * tolerance)};
    CreasePlan plan;
    if (settings.edges == Edges::automatic) {
        const CreaseEvidence found = settings.crease_angle == default_crease_angle
                                         ? known
                                         : look_for_creases(runtime, mesh, settings.crease_angle, progress);
        if (!found.creases) {
            plan.doubtful = found.length;
            if (crosses(runtime, mesh, tree, progress))
                plan.creases = creases_of_solids(runtime, mesh, settings, sharpness.coarse, progress);
            return plan;
        }
        sharpness = sharpness_of(found, settings, sharpness.coarse);
    }
    Creases creases = find_creases(runtime, mesh, sharpness.angle, sharpness.coarse, progress);
    if (creases.patches >= 2) plan.creases = std::move(creases);
    return plan;
}

EndPlan plan_end(const Mesh& mesh, const FitMeshReport& report, bool has_creases) noexcept {
    const double off = how_far_off(mesh, report);
    if (mesh.report.boundary_edges > 0) return {End::at_places, off};
    // A fit with creases takes its inside from the mesh, so it invents nothing unless the mesh crosses itself, where
    // nobody knows the inside.
    if (has_creases) return {report.surface.most > off * mesh.bounds.diagonal() ? End::at_places : End::nowhere, off};
    // A smooth fit that reached its tolerance has looked by itself, and found nothing far from the mesh.
    return {report.reached ? End::nowhere : End::at_samples, off};
}

MeshSamples end_places(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree, const EndPlan& plan,
                       std::uint64_t seed, const base::Progress& progress) {
    HRBFNPR_ASSERT(plan.off > 0.0);
    return end_samples(runtime, mesh, tree, plan_tuning.places, plan.off * mesh.bounds.diagonal(), seed, progress);
}

} // namespace hrbfnpr::mesh
