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
    // The caller wants to keep the faces as they are.
    if (faces == Faces::keep) return false;
    // The walls of a cavity face into the cavity, unless parts inside others are treated as outer parts.
    const bool keeps_cavities = parts == Parts::all || parts == Parts::solids;
    if (keeps_cavities && component.around % 2 == 1) return component.is_cavity() && component.volume > 0.0;
    // A component with a negative volume is inside out. An open component counts only if its holes are small.
    return inside_out(component);
}

Facing plan_facing(const FacingFacts& facts, bool keeps_faces) {
    // The caller wants to keep the faces, or make_mesh() has already turned them.
    if (keeps_faces || facts.closed) return Facing::right;
    // If the mesh is a terrain, it must face up.
    if (const char axis = facts.hangs_along(); axis != 0) return axis == 'z' ? Facing::down_z : Facing::down_y;
    // The faces of other meshes with holes are turned if the normals point inward.
    return facts.inward() ? Facing::inward : Facing::right;
}

// ---- Edges that stand out

namespace {

constexpr double boundless = std::numeric_limits<double>::infinity();

} // namespace

CreaseEvidence judge_edges(const EdgeLengths& lengths, double diagonal) noexcept {
    // No edge bends by more than the crease angle.
    if (!(lengths.all > 0.0)) return {};
    CreaseEvidence found;
    found.length = lengths.all / diagonal;
    found.standing = lengths.standing / lengths.all;
    found.coarse = lengths.coarse / lengths.all;
    // Most of the edges' length stands out.
    const bool stand_out = found.standing >= plan_tuning.enough_standing;
    // If edges do not stand out, the shape is a polyhedron if enough faces are too coarse for a round shape.
    found.polyhedron = !stand_out && found.coarse >= plan_tuning.enough_coarse;
    // Very short edges do not count: a shape with edges that stand out, or a polyhedron, has edges only if they are
    // long enough.
    found.creases = (stand_out || found.polyhedron) && found.length >= plan_tuning.shortest_edges;
    return found;
}

CreaseEvidence judge_all_edges(const EdgeLengths& lengths, double diagonal, double area_with_creases,
                               double area) noexcept {
    CreaseEvidence whole = judge_edges(lengths, diagonal);
    // A mesh has edges if the components with edges have enough of its area.
    whole.creases = area_with_creases > 0.0 && area_with_creases >= plan_tuning.enough_area * area;
    return whole;
}

SharpEdges plan_edges(Edges wish, const CreaseEvidence& whole, const std::function<bool()>& solids_cross) {
    // The caller wants no sharp edges, or wants all edges that bend to be sharp.
    if (wish == Edges::smooth) return SharpEdges::none;
    if (wish == Edges::sharp) return SharpEdges::bending;
    // The shape has edges, so these are kept.
    if (whole.creases) return SharpEdges::meant;
    // One function cannot represent solids that intersect each other. So they are fitted separately, and meet in
    // creases.
    return solids_cross() ? SharpEdges::meant : SharpEdges::none;
}

Sharpness plan_sharpness(double angle, double far) noexcept { return {angle, plan_tuning.too_coarse * far}; }

Sharpness plan_sharpness(const CreaseEvidence& part, const CreaseEvidence& whole, double angle, double far,
                         double tolerance) noexcept {
    // On a polyhedron all faces are flat, so even edges with small angles are sharp.
    if (part.polyhedron) return plan_sharpness(plan_tuning.flat_faces * angle, far);
    if (part.creases) return plan_sharpness(angle, far);
    // A smooth part has no sharp edges. But if other parts have edges, its faces stay flat if they are farther than the
    // tolerance from a round surface.
    return {180.0, whole.standing >= plan_tuning.enough_standing ? tolerance : boundless};
}

bool is_crumbled(const Crumbs& crumbs, double area) noexcept {
    return crumbs.count >= plan_tuning.fewest_crumbs && crumbs.area >= plan_tuning.mostly_crumbs * area;
}

Sharpness plan_crumbled() noexcept { return {180.0, boundless}; }

// ---- Coarse faces

EdgesInFile plan_edges_of_file(std::int64_t bends, std::int64_t sharp) noexcept {
    // Too few edges bend for the file to say anything.
    if (bends < plan_tuning.fewest_of_file) return EdgesInFile::nothing;
    const double share = static_cast<double>(sharp) / static_cast<double>(bends);
    if (share >= plan_tuning.nearly_all) return EdgesInFile::all_are_sharp;
    return share > 1.0 - plan_tuning.nearly_all ? EdgesInFile::some_are_sharp : EdgesInFile::nothing;
}

CoarsePlan plan_coarse_faces(const CoarseFacts& facts, const MeshOptions& wishes) {
    // The caller gives the number of divisions.
    if (wishes.rounds >= 0)
        return {wishes.rounds > 0 ? CoarsePlan::Choice::divided : CoarsePlan::Choice::nothing, wishes.rounds, false};
    // The caller wants all edges sharp, or takes samples of the mesh without division.
    if (!wishes.edges_as_given && wishes.edges == Edges::sharp) return {};
    if (!wishes.chooses_samples) return {};
    // If the mesh has many faces, or small faces, its edges bend because of noise.
    if (facts.faces > plan_tuning.most_coarse || facts.mean_edge() < plan_tuning.coarse_edge) return {};
    // If all faces are within the tolerance of a round surface, nothing is divided.
    const double tolerance = plan_tolerance(wishes.tolerance, 1.0);
    const double off = facts.coarseness();
    if (!(off > tolerance)) return {};
    // The shape has edges. If the file says which edges are sharp, this is not tested.
    if (facts.said != EdgesInFile::some_are_sharp && facts.has_creases()) return {};
    // Each round reduces the bulge to a quarter. At the end, half of the tolerance may remain.
    const double rounds = std::ceil(std::log(2.0 * off / tolerance) / std::log(4.0));
    CoarsePlan plan;
    plan.rounds = rounds < plan_tuning.most_rounds ? static_cast<std::int32_t>(rounds) : plan_tuning.most_rounds;
    if (plan.rounds == 0) return plan;
    // If all faces are flat by the normals of the file, there is nothing to divide.
    plan.choice = facts.said == EdgesInFile::all_are_sharp ? CoarsePlan::Choice::all_flat : CoarsePlan::Choice::divided;
    // If the file says which edges are sharp, only the parts with coarse faces are divided.
    plan.parts_alone = facts.said == EdgesInFile::some_are_sharp;
    return plan;
}

CoarsePlan::Choice judge_division(const DivisionFacts& facts, EdgesInFile said, const MeshOptions& wishes) {
    using Choice = CoarsePlan::Choice;
    // The caller asked for the division.
    if (wishes.rounds >= 0) return Choice::divided;
    // If the file says which edges are sharp, a division is dropped if it moves vertices too far.
    if (said == EdgesInFile::some_are_sharp)
        return facts.moved > plan_tuning.most_moved * facts.most_coarse() ? Choice::nothing : Choice::divided;
    // The faces of a convex hull are long and unequal, and no round surface goes through their vertices: the divided
    // surface folds. So the faces are flat, unless the caller wants something else.
    const bool folds = facts.moved > plan_tuning.most_moved * facts.coarseness ||
                       facts.raised > plan_tuning.most_raised * facts.coarseness;
    return folds && wishes.edges_as_given ? Choice::coarse_flat : Choice::divided;
}

FittedEdges plan_fitted_edges(const FittedEdges& of_fit, const MeshOptions& wishes, bool all_flat) noexcept {
    // The caller says which edges are sharp.
    if (!wishes.edges_as_given)
        return {wishes.edges, wishes.edges == Edges::sharp ? wishes.edge_angle : default_crease_angle};
    // If faces are flat, all edges between them are sharp.
    if (all_flat) return {Edges::sharp, plan_tuning.flat_bend};
    return of_fit;
}

// ---- Parts

bool is_kept(const Component& component, bool is_largest, Parts parts) noexcept {
    // The caller wants only the largest component, or all components.
    if (parts == Parts::largest) return is_largest;
    if (parts == Parts::all) return true;
    // An open component inside a closed one bounds no cavity.
    if (parts == Parts::solids) return !component.is_nested() || component.closed;
    // By default, components inside other components are left out.
    return !component.is_nested();
}

bool is_crumb(double area, double whole) noexcept { return area < plan_tuning.lost_area * whole; }

bool is_lost(double distance) noexcept { return distance > plan_tuning.lost_distance - 1.0; }

bool is_flap(std::int64_t faces, double area, double whole) noexcept {
    return faces <= plan_tuning.flap_faces && area < plan_tuning.flap_area * whole;
}

bool may_be_grouped(const MeshReport& mesh, std::int64_t faces) noexcept {
    // Closed parts that cross are solids, which the library joins.
    if (mesh.boundary_edges == 0) return false;
    // Very large meshes are not grouped, because the search would take too long.
    return faces <= (mesh.components == 1 ? plan_tuning.most_faces_of_one : plan_tuning.most_faces);
}

// ---- The samples and the tolerance of a fit

bool chooses_samples(const SampleOptions& wishes) noexcept {
    // A fit to a mesh chooses the number of its samples, unless the caller wants an option that only a fit to samples
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

// Returns the least value of EndPlan::off, in diagonals. The corners of an open mesh are rounded by about this much,
// and strips narrower than this end beyond their border. The value allows for the distance between mesh and surface,
// and for the number of places along a long border.
double least_off(const EndFacts& facts) noexcept {
    const double farthest = std::max(facts.mesh_p99, facts.surface_p99);
    if (facts.border == 0.0 || !(farthest < plan_tuning.least_off * facts.diagonal)) return plan_tuning.least_off;
    const double dense = facts.border * mesh_tuning.row_step / static_cast<double>(plan_tuning.places);
    const double narrow = plan_tuning.of_width * 2.0 * facts.area / facts.border;
    return std::clamp(std::max(plan_tuning.of_error * farthest, std::min(dense, narrow)) / facts.diagonal,
                      plan_tuning.least_off_exact, plan_tuning.least_off);
}

// Returns EndPlan::off for a fit. The mesh's distances from the surface are large where coarse faces approximate a
// round shape, although all of the surface belongs to the mesh there. So the result is larger than most of these
// distances.
double off_of_fit(const EndFacts& facts, double least) noexcept {
    const double p99 = facts.mesh_p99 / facts.diagonal;
    return p99 > 0.0 ? std::clamp(plan_tuning.of_coarse_faces * p99, least, plan_tuning.most_off) : least;
}

} // namespace

EndPlan plan_end(const EndFacts& facts, bool may_end) noexcept {
    HRBFNPR_ASSERT(facts.diagonal > 0.0);
    // The caller wants to keep the whole surface.
    if (!may_end) return {};
    const double off = off_of_fit(facts, least_off(facts));
    // The mesh is open, so the surface ends where the mesh ends.
    if (facts.has_border) return {End::at_places, off};
    // A fit with creases takes its inside from the mesh, so it makes no spurious surface. The exception is a mesh that
    // crosses itself, whose inside is not defined.
    if (facts.has_creases) return {facts.surface_most > off * facts.diagonal ? End::at_places : End::nowhere, off};
    // If a smooth fit has reached its tolerance, its surface has already been tested for distance from the mesh.
    return {facts.reached ? End::nowhere : End::at_samples, off};
}

EndPlan plan_end_of_picture(const EndFacts& facts, bool may_end) noexcept {
    HRBFNPR_ASSERT(facts.diagonal > 0.0);
    if (!may_end) return {};
    const double off = off_of_fit(facts, plan_tuning.least_off);
    // The fit has already ended the surface at the border.
    if (facts.has_border) return {End::as_fitted, off};
    // Without a border, only spurious surface can lie beyond the mesh, and the fit has found none that is far from it.
    // The sheets of a mesh that is not closed do not bound each other.
    const bool bounded = facts.closed || !facts.has_creases;
    if (bounded && facts.surface_most <= off * facts.diagonal) return {End::nowhere, off};
    // Surface far from the mesh is spurious, so the surface ends where the mesh ends.
    return {End::at_places, off};
}

EndPlan plan_end_of_samples(double spacing, double diagonal, bool may_end) noexcept {
    HRBFNPR_ASSERT(diagonal > 0.0);
    if (!may_end) return {};
    // A fit to few samples rounds edges, so its surface may be farther from the mesh.
    return {End::at_places, std::max(plan_tuning.least_off, plan_tuning.of_coarse_faces * spacing / diagonal)};
}

} // namespace hrbfnpr::mesh
