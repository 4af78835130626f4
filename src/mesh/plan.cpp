// SPDX-License-Identifier: MIT
#include "mesh/plan.h"

#include "base/assert.h"
#include "mesh/edges.h"
#include "mesh/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::mesh {

// ---- Faces that look the wrong way

bool is_turned(const Component& component, Parts parts, Faces faces) noexcept {
    // The caller keeps the faces as they are.
    if (faces == Faces::keep) return false;
    // If all parts are kept, a part inside another is a cavity, whose faces point into it.
    if (parts == Parts::all && component.nested) return false;
    // A component with a negative volume is inside out. An open component has an inside only if its holes are small.
    return inside_out(component);
}

Facing plan_facing(const FacingFacts& facts, bool keeps_faces) {
    // The caller keeps the faces, or make_mesh() has already turned them.
    if (keeps_faces || facts.closed) return Facing::right;
    // A terrain faces up.
    if (const char axis = facts.hangs_along(); axis != 0) return axis == 'z' ? Facing::down_z : Facing::down_y;
    // A mesh with holes faces outward.
    return facts.inward() ? Facing::inward : Facing::right;
}

// ---- Edges that stand out

CreaseEvidence judge_edges(const EdgeLengths& lengths, double diagonal) noexcept {
    // No edge bends by more than the angle.
    if (!(lengths.all > 0.0)) return {};
    CreaseEvidence found;
    found.length = lengths.all / diagonal;
    found.standing = lengths.standing / lengths.all;
    found.coarse = lengths.coarse / lengths.all;
    // Most edges stand out.
    const bool stand_out = found.standing >= plan_tuning.enough_standing;
    // Otherwise enough of the faces are too coarse for a round shape.
    found.polyhedron = !stand_out && found.coarse >= plan_tuning.enough_coarse;
    // A shape whose edges stand out, or a polyhedron, has edges, unless they are very short.
    found.creases = (stand_out || found.polyhedron) && found.length >= plan_tuning.shortest_edges;
    return found;
}

CreaseEvidence judge_all_edges(const EdgeLengths& lengths, double diagonal, double area_with_creases,
                               double area) noexcept {
    CreaseEvidence whole = judge_edges(lengths, diagonal);
    // A mesh has edges if its components with edges hold enough of its area.
    whole.creases = area_with_creases > 0.0 && area_with_creases >= plan_tuning.enough_area * area;
    return whole;
}

SharpEdges plan_edges(Edges wish, const CreaseEvidence& whole, const std::function<bool()>& solids_cross) {
    // The caller wants no sharp edges, or all that bend.
    if (wish == Edges::smooth) return SharpEdges::none;
    if (wish == Edges::sharp) return SharpEdges::bending;
    // The shape has edges.
    if (whole.creases) return SharpEdges::meant;
    // One function cannot represent solids that intersect each other. They are fitted separately, and meet in creases.
    return solids_cross() ? SharpEdges::meant : SharpEdges::none;
}

Sharpness plan_sharpness(double angle, double far) noexcept { return {angle, plan_tuning.too_coarse * far}; }

Sharpness plan_sharpness(const CreaseEvidence& part, const CreaseEvidence& whole, double angle, double far,
                         double tolerance) noexcept {
    constexpr double boundless = std::numeric_limits<double>::infinity();
    // All faces of a polyhedron are flat, even where they hardly bend.
    if (part.polyhedron) return plan_sharpness(plan_tuning.flat_faces * angle, far);
    if (part.creases) return plan_sharpness(angle, far);
    // No edge of a smooth part is sharp. But beside parts with edges its coarse faces stay flat, if they are farther
    // than the tolerance from a round surface.
    return {180.0, whole.standing >= plan_tuning.enough_standing ? tolerance : boundless};
}

// ---- Coarse faces

EdgesInFile plan_edges_of_file(std::int64_t bends, std::int64_t sharp) noexcept {
    // A few edges say nothing.
    if (bends < plan_tuning.fewest_of_file) return EdgesInFile::nothing;
    const double share = static_cast<double>(sharp) / static_cast<double>(bends);
    if (share >= plan_tuning.nearly_all) return EdgesInFile::all_are_sharp;
    return share > 1.0 - plan_tuning.nearly_all ? EdgesInFile::some_are_sharp : EdgesInFile::nothing;
}

CoarsePlan plan_coarse_faces(const CoarseFacts& facts, const MeshOptions& wishes) {
    // The caller says how often faces are divided.
    if (wishes.rounds >= 0)
        return {wishes.rounds > 0 ? CoarsePlan::Choice::divided : CoarsePlan::Choice::nothing, wishes.rounds, false};
    // The caller wants all edges sharp, or takes samples of the mesh as it is.
    if (!wishes.edges_as_given && wishes.edges == Edges::sharp) return {};
    if (!wishes.chooses_samples) return {};
    // A mesh of many or small faces bends by noise.
    if (facts.faces > plan_tuning.most_coarse || facts.mean_edge() < plan_tuning.coarse_edge) return {};
    // Faces bulge by no more than the tolerance.
    const double tolerance = plan_tolerance(wishes.tolerance, 1.0);
    const double off = facts.coarseness();
    if (!(off > tolerance)) return {};
    // Edges stand out, unless the file says which ones are sharp.
    if (facts.said != EdgesInFile::some_are_sharp && facts.has_creases()) return {};
    // A round leaves a quarter of the bulge. At the end half of the tolerance may be left.
    const double rounds = std::ceil(std::log(2.0 * off / tolerance) / std::log(4.0));
    CoarsePlan plan;
    plan.rounds = rounds < plan_tuning.most_rounds ? static_cast<std::int32_t>(rounds) : plan_tuning.most_rounds;
    if (plan.rounds == 0) return plan;
    // By the normals of the file all faces are flat.
    plan.choice = facts.said == EdgesInFile::all_are_sharp ? CoarsePlan::Choice::all_flat : CoarsePlan::Choice::divided;
    // If the file says which edges are sharp, parts without coarse faces stay undivided.
    plan.parts_alone = facts.said == EdgesInFile::some_are_sharp;
    return plan;
}

CoarsePlan::Choice judge_division(const DivisionFacts& facts, EdgesInFile said, const MeshOptions& wishes) {
    using Choice = CoarsePlan::Choice;
    // The caller wants the division.
    if (wishes.rounds >= 0) return Choice::divided;
    // If the file says which edges are sharp, a division that moves vertices too far is dropped.
    if (said == EdgesInFile::some_are_sharp)
        return facts.moved > plan_tuning.most_moved * facts.most_coarse() ? Choice::nothing : Choice::divided;
    // The long and unequal faces of a convex hull fold: no round surface goes through their vertices. They are flat,
    // unless the caller wants something else.
    const bool folds = facts.moved > plan_tuning.most_moved * facts.coarseness ||
                       facts.raised > plan_tuning.most_raised * facts.coarseness;
    return folds && wishes.edges_as_given ? Choice::coarse_flat : Choice::divided;
}

FittedEdges plan_fitted_edges(const FittedEdges& of_fit, const MeshOptions& wishes, bool all_flat) noexcept {
    // The caller says which edges are sharp.
    if (!wishes.edges_as_given)
        return {wishes.edges, wishes.edges == Edges::sharp ? wishes.edge_angle : default_crease_angle};
    // All edges of flat faces are sharp.
    if (all_flat) return {Edges::sharp, plan_tuning.flat_bend};
    return of_fit;
}

// ---- Parts

bool is_kept(const Component& component, bool is_largest, Parts parts) noexcept {
    // The caller wants the largest component, or all.
    if (parts == Parts::largest) return is_largest;
    if (parts == Parts::all) return true;
    // Components inside others are left out.
    return !component.nested;
}

bool is_crumb(double area, double whole) noexcept { return area < plan_tuning.lost_area * whole; }

bool is_lost(double distance) noexcept { return distance > plan_tuning.lost_distance - 1.0; }

bool is_flap(std::int64_t faces, double area, double whole) noexcept {
    return faces <= plan_tuning.flap_faces && area < plan_tuning.flap_area * whole;
}

bool may_be_grouped(const MeshReport& mesh, std::int64_t faces) noexcept {
    // Closed parts that cross are solids, which the library joins.
    if (mesh.boundary_edges == 0) return false;
    // Very large meshes are one surface, because the search takes too long.
    return faces <= (mesh.components == 1 ? plan_tuning.most_faces_of_one : plan_tuning.most_faces);
}

// ---- How near the surface is to come

bool chooses_samples(const SampleOptions& wishes) noexcept {
    // A fit to a mesh takes as many samples as it needs, unless the caller wants an option that only a fit to samples
    // has.
    return !wishes.count && !wishes.flips && !wishes.refines && !wishes.judges && !wishes.regularizes;
}

double plan_tolerance(double wish, double diagonal) noexcept {
    return wish > 0.0 ? wish : default_tolerance * diagonal;
}

double plan_far(double wish, double tolerance) noexcept { return wish > 0.0 ? wish : plan_tuning.far * tolerance; }

double plan_tolerance_of_group(double diagonal, double across) noexcept {
    return default_tolerance * std::sqrt(diagonal * across);
}

// ---- Where the surface ends

namespace {

// Returns the least distance, in diagonals, beyond which surface does not belong to the mesh. A support with wide
// spacings cannot end a narrow strip. So if the fit is exact, the distance is a share of the mean width, 2 area /
// border, but no less than the distance between places.
double least_off(const EndFacts& facts) noexcept {
    const double farthest = std::max(facts.mesh_p99, facts.surface_p99);
    if (facts.border == 0.0 || !(farthest < plan_tuning.exact * facts.diagonal)) return plan_tuning.least_off;
    const double dense = std::sqrt(facts.area / static_cast<double>(plan_tuning.places));
    const double narrow = plan_tuning.of_width * 2.0 * facts.area / facts.border;
    return std::clamp(std::max(narrow, plan_tuning.of_places * dense) / facts.diagonal, plan_tuning.least_off_exact,
                      plan_tuning.least_off);
}

// Returns EndPlan::off of a fit. Coarse faces of a round shape are far from the round surface everywhere. So most
// distances of the mesh from the surface do not show that some surface does not belong to the mesh.
double off_of_fit(const EndFacts& facts, double least) noexcept {
    const double p99 = facts.mesh_p99 / facts.diagonal;
    return p99 > 0.0 ? std::clamp(plan_tuning.of_coarse_faces * p99, least, plan_tuning.most_off) : least;
}

} // namespace

EndPlan plan_end(const EndFacts& facts, bool may_end) noexcept {
    HRBFNPR_ASSERT(facts.diagonal > 0.0);
    // The caller keeps all of the surface.
    if (!may_end) return {};
    const double off = off_of_fit(facts, least_off(facts));
    // The surface of an open mesh ends where the mesh ends.
    if (facts.has_border) return {End::at_places, off};
    // A fit with creases takes its inside from the mesh. So it makes up no surface, unless the mesh crosses itself,
    // where the inside is not defined.
    if (facts.has_creases) return {facts.surface_most > off * facts.diagonal ? End::at_places : End::nowhere, off};
    // A smooth fit that reached its tolerance has checked that its surface is nowhere far from the mesh.
    return {facts.reached ? End::nowhere : End::at_samples, off};
}

EndPlan plan_end_of_picture(const EndFacts& facts, bool may_end) noexcept {
    HRBFNPR_ASSERT(facts.diagonal > 0.0);
    if (!may_end) return {};
    const double off = off_of_fit(facts, plan_tuning.least_off);
    // The fit has ended the surface along the border.
    if (facts.has_border) return {End::as_fitted, off};
    // The sheets of a closed mesh bound each other, unless some surface is far off.
    if (facts.has_creases && facts.closed && facts.surface_most <= off * facts.diagonal) return {End::nowhere, off};
    // Surface far from a closed mesh was invented by the fit.
    return {End::at_places, off};
}

EndPlan plan_end_of_samples(double spacing, double diagonal, bool may_end) noexcept {
    HRBFNPR_ASSERT(diagonal > 0.0);
    if (!may_end) return {};
    // A fit to few samples rounds sharp edges off, so its surface may be farther from the mesh.
    return {End::at_places, std::max(plan_tuning.least_off, plan_tuning.of_coarse_faces * spacing / diagonal)};
}

} // namespace hrbfnpr::mesh
