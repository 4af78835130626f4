// SPDX-License-Identifier: MIT
// Turns a mesh into surfaces, in this order: prepare_mesh() welds it, turns its faces outward, removes lost parts,
// samples it, and divides coarse faces. groups_of_mesh() separates parts that cannot belong to one surface.
// surface_of_group() fits a model, and end_of_mesh() ends the model where the mesh ends.
#include "picture/mesh_surface.h"

#include "api/mesh.h"
#include "base/assert.h"
#include "mesh/pieces/fit_as_planned.h"
#include "mesh/plan.h"
#include "picture/apart.h"
#include "picture/ends.h"
#include "picture/nearness.h"
#include "picture/normals.h"
#include "picture/plan.h"
#include "picture/plate.h"
#include "picture/points.h"
#include "picture/sharp_edges.h"
#include "picture/subdivide.h"
#include "picture/tuning_mesh.h"
#include "picture/up.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::picture {
namespace {

// ---- Options

// Returns the options for a fit to samples. A fit to a mesh uses some of them.
hrbfnpr_fit_desc wanted_fit(const Options& options) {
    auto desc = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
    options.changes.apply("fit", desc);
    return desc;
}

// Returns whether the fit chooses the number of its samples.
bool chooses_samples(const Options& options) {
    const Changes& changes = options.changes;
    mesh::SampleOptions wishes;
    wishes.count = options.desc.samples > 0;
    wishes.flips = options.has(HRBFNPR_PICTURE_FLIP);
    wishes.refines = changes.is_callers("fit.refinement_steps") && changes.number("fit.refinement_steps") != 0.0;
    wishes.judges = changes.is_callers("fit.outliers") || changes.is_callers("fit.flipped_normals");
    wishes.regularizes = wanted_fit(options).regularization_mode == HRBFNPR_REGULARIZATION_AUTO;
    return mesh::chooses_samples(wishes);
}

bool edges_are_as_given(const Options& options) noexcept {
    return options.desc.edges == HRBFNPR_PICTURE_EDGES_AS_GIVEN;
}

bool keeps_faces(const Options& options) noexcept { return options.desc.normals == HRBFNPR_NORMALS_GIVEN; }

// Returns the caller's options for a mesh. `across` is the diagonal of the mesh.
mesh::MeshOptions wishes_of(const Options& options, double across) {
    mesh::MeshOptions wishes;
    wishes.edges_as_given = edges_are_as_given(options);
    static_assert(HRBFNPR_PICTURE_EDGES_SHARP - HRBFNPR_PICTURE_EDGES_AUTO == HRBFNPR_EDGES_SHARP - HRBFNPR_EDGES_AUTO);
    if (!wishes.edges_as_given)
        wishes.edges = static_cast<mesh::Edges>(options.desc.edges - HRBFNPR_PICTURE_EDGES_AUTO);
    wishes.edge_angle = options.desc.edge_angle;
    wishes.rounds = options.desc.subdivide;
    wishes.chooses_samples = chooses_samples(options);
    wishes.tolerance = options.desc.tolerance > 0.0 && across > 0.0 ? options.desc.tolerance / across : 0.0;
    return wishes;
}

double crease_angle_of(const Options& options) noexcept {
    return std::isnan(options.desc.crease_angle) ? mesh_tuning.crease_angle : options.desc.crease_angle;
}

// ---- Meshes of the library

hrbfnpr_mesh_desc mesh_desc_of(const Points& points, const Vector<Triangle>& triangles, double crease_angle) {
    auto desc = defaults<hrbfnpr_mesh_desc>(hrbfnpr_mesh_desc_init);
    desc.vertices = view_of(points);
    desc.triangles = view_of(triangles);
    desc.crease_angle = crease_angle;
    return desc;
}

Mesh create_mesh(const Call& call, const hrbfnpr_mesh_desc& desc, hrbfnpr_operation* operation) {
    return make<Mesh>([&](hrbfnpr_mesh** made, hrbfnpr_error* error) {
        return hrbfnpr_mesh_create(&call.context, &desc, operation, made, error);
    });
}

// Returns whether the picture may show walls inside a solid: as hidden lines, or in a section. A model without a plan
// for a drawing may be used for sections.
bool shows_inside(const Call& call) {
    if (has_section(call.options) || call.options.has(HRBFNPR_PICTURE_SURFACE_ONLY)) return true;
    return draws_hidden(plan_style(call, any_side, any_side, false));
}

// Makes a mesh, and repairs it as the options allow.
Mesh welded_mesh(const Call& call, const Points& points, const Vector<Triangle>& triangles,
                 hrbfnpr_operation* operation) {
    const Options& options = call.options;
    hrbfnpr_mesh_desc desc = mesh_desc_of(points, triangles, crease_angle_of(options));
    desc.parts = options.desc.parts;
    desc.faces = keeps_faces(options) ? HRBFNPR_FACES_KEEP : HRBFNPR_FACES_TURN;
    Mesh mesh = create_mesh(call, desc, operation);
    if (desc.parts != HRBFNPR_PARTS_AUTO || info_of(mesh).left_out_components == 0 || !shows_inside(call)) return mesh;
    desc.parts = HRBFNPR_PARTS_SOLIDS;
    return create_mesh(call, desc, operation);
}

// Makes a mesh from points and faces that are already repaired.
Mesh same_mesh(const Call& call, const Points& points, const Vector<Triangle>& triangles, double crease_angle,
               hrbfnpr_operation* operation) {
    hrbfnpr_mesh_desc desc = mesh_desc_of(points, triangles, crease_angle);
    desc.parts = HRBFNPR_PARTS_ALL;
    desc.faces = HRBFNPR_FACES_KEEP;
    return create_mesh(call, desc, operation);
}

void sample_mesh(const Mesh& mesh, const hrbfnpr_sample_desc& desc, Points& points, Points* normals,
                 hrbfnpr_operation* operation) {
    const hrbfnpr_array_out to_points = room_in(points);
    const hrbfnpr_array_out to_normals = normals != nullptr ? room_in(*normals) : hrbfnpr_array_out{};
    picture::call([&](hrbfnpr_error* error) {
        return hrbfnpr_mesh_sample(mesh.get(), &desc, &to_points, normals != nullptr ? &to_normals : nullptr, operation,
                                   error);
    });
}

// ---- The prepared mesh

// A mesh after prepare_mesh(), with its shape and evenly spread samples.
struct PreparedMesh {
    Mesh mesh;
    Shape shape;
    Points points;
    Points normals;
    bool is_flat = false; // True if all faces are flat.
};

String borders_in_words(const hrbfnpr_mesh_info& info, Pool& pool) {
    String words = count_of(info.components, "part", pool);
    words += ", ";
    if (info.cavities == 1)
        words += "1 cavity, ";
    else if (info.cavities > 1)
        words += formatted(pool, "%d cavities, ", static_cast<int>(info.cavities));
    words += info.closed != 0           ? String("closed", &pool)
             : info.boundary_edges == 0 ? String("not closed", &pool)
                                        : count_of(info.boundary_loops, "border", pool);
    return words;
}

// Notes the repairs, and warns of defects that cannot be repaired.
void tell_mesh_repairs(const Call& call, const hrbfnpr_mesh_info& info) {
    Pool& pool = call.pool;
    Report& report = call.report;
    const auto figure = [](std::int64_t count) { return static_cast<double>(count); };
    if (info.turned_faces > 0)
        report.note(HRBFNPR_NOTE_FACES_TURNED, {figure(info.turned_faces)},
                    count_of(info.turned_faces, "face", pool) += " turned to the side of their neighbours");
    if (info.turned_components > 0) {
        const bool is_one = info.components == 1 || info.turned_components == 1;
        String what("the mesh", &pool);
        if (info.components != 1) what = count_of(info.turned_components, "part", pool) += " of the mesh";
        report.note(HRBFNPR_NOTE_INSIDE_OUT, {figure(info.turned_components)},
                    what +=
                    is_one ? " was inside out: its faces are turned" : " were inside out: their faces are turned");
    }
    const std::int64_t left_out = info.degenerate_faces + info.repeated_faces;
    if (left_out > 0)
        report.note(HRBFNPR_NOTE_FACES_LEFT_OUT, {figure(left_out)},
                    count_of(left_out, "face", pool) += " left out: without area, or repeated");
    if (info.left_out_components > 0)
        report.note(HRBFNPR_NOTE_PARTS_INSIDE, {figure(info.left_out_components), figure(info.left_out_faces)},
                    formatted(pool, "%s inside others left out (%s); {parts=all} keeps them",
                              count_of(info.left_out_components, "part", pool).c_str(),
                              count_of(info.left_out_faces, "face", pool).c_str()));
    if (info.contrary_edges > 0)
        report.warn(HRBFNPR_NOTE_CONTRARY_EDGES, {figure(info.contrary_edges)},
                    count_of(info.contrary_edges, "edge", pool) +=
                    " between faces that face opposite sides: the surface may be wrong there",
                    {.detail =
                         "The mesh has one side only, as a Moebius strip, or it crosses itself, so turning faces does "
                         "not help."});
}

// Removes the faces with the given indices from a mesh, and welds the remaining faces again.
void leave_out_faces(const Call& call, const FaceNumbers& which, Mesh& mesh, Shape& shape,
                     hrbfnpr_operation* operation) {
    const Vector<std::int32_t> given = numbers_of(mesh, HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE, call.pool);
    Vector<std::uint8_t> leaves(shape.triangles.size(), 0, &call.pool);
    for (const std::int64_t face : which) leaves[static_cast<std::size_t>(given[static_cast<std::size_t>(face)])] = 1;
    Vector<Triangle> kept(&call.pool);
    for (std::size_t f = 0; f < leaves.size(); ++f)
        if (leaves[f] == 0) kept.push_back(shape.triangles[f]);
    shape.triangles = std::move(kept);
    mesh = welded_mesh(call, shape.points, shape.triangles, operation);
}

// Counts of removed elements: parts far away, the faces of these parts, and leftover faces.
struct LeftOutParts {
    std::int64_t far_parts = 0, far_faces = 0, flaps = 0;
};

LeftOutParts leave_out_lost(const Call& call, Mesh& mesh, Shape& shape, hrbfnpr_operation* operation) {
    LeftOutParts left_out;
    const std::uint32_t parts = call.options.desc.parts;
    if (parts == HRBFNPR_PARTS_ALL || parts == HRBFNPR_PARTS_LARGEST) return left_out;
    const LostParts lost = find_lost_parts(mesh, call.pool);
    if (lost.parts > 0) {
        left_out.far_parts = lost.parts;
        left_out.far_faces = static_cast<std::int64_t>(lost.faces.size());
        leave_out_faces(call, lost.faces, mesh, shape, operation);
    }
    const FaceNumbers flaps = find_flaps(mesh, call.pool);
    if (!flaps.empty()) {
        left_out.flaps = static_cast<std::int64_t>(flaps.size());
        leave_out_faces(call, flaps, mesh, shape, operation);
    }
    return left_out;
}

void tell_left_out(const Call& call, const LeftOutParts& left_out) {
    Pool& pool = call.pool;
    if (left_out.far_parts > 0)
        call.report.note(HRBFNPR_NOTE_PARTS_FAR,
                         {static_cast<double>(left_out.far_parts), static_cast<double>(left_out.far_faces)},
                         formatted(pool, "%s (%s) far from all others left out; {parts=all} keeps them",
                                   count_of(left_out.far_parts, "part", pool).c_str(),
                                   count_of(left_out.far_faces, "face", pool).c_str()));
    if (left_out.flaps > 0)
        call.report.note(HRBFNPR_NOTE_FLAPS, {static_cast<double>(left_out.flaps)},
                         count_of(left_out.flaps, "face", pool) +=
                         " left out: each hangs on an edge of two others; {parts=all} keeps them");
}

mesh::Facing facing_of(const Call& call, const PreparedMesh& looked) {
    const auto hangs = [&] { return hangs_along(looked.points, looked.normals); };
    const auto inward = [&] { return look_at_normals(looked.points, looked.normals, true, call.pool).inward(); };
    const bool closed = info_of(looked.mesh).closed != 0;
    return mesh::plan_facing({closed, std::ref(hangs), std::ref(inward)},
                             keeps_faces(call.options) || call.options.has(HRBFNPR_PICTURE_FLIP));
}

void tell_facing(const Call& call, mesh::Facing facing) {
    if (facing == mesh::Facing::right) return;
    if (facing == mesh::Facing::inward) {
        call.report.note(HRBFNPR_NOTE_NORMALS_TURNED, {},
                         "all normals pointed inward: they are turned ({normals=keep} leaves them)");
        return;
    }
    const char axis = facing == mesh::Facing::down_z ? 'z' : 'y';
    call.report.note(HRBFNPR_NOTE_TERRAIN_TURNED, {static_cast<double>(axis - 'x')},
                     formatted(call.pool,
                               "the terrain faced down along %c: its normals are turned ({normals=keep} leaves them)",
                               axis));
}

// ---- Coarse meshes

// The result of dividing coarse faces.
struct DivisionResult {
    using Choice = mesh::CoarsePlan::Choice;

    mesh::CoarsePlan plan;
    bool by_file = false; // True if the normals of the file mark some edges as sharp.
    double moved = 0.0;   // the largest distance that a vertex was moved, in diagonals
    // The largest distance of a new vertex from the plane of the given face that it lies on, in diagonals.
    double raised = 0.0;
    // The coarseness before the division. It is negative if it was not measured, because the options ask for division.
    double coarseness = -1.0;
};

// Returns whether a fit keeps some edges of the mesh sharp, as on machine parts and polyhedra. If the mesh itself has
// no creases, a rough fit shows whether some of its parts have creases.
bool has_creases(const Mesh& mesh, const base::Progress& progress) {
    if (info_of(mesh).creases != 0) return true;
    const hrbfnpr_mesh& made = *mesh.get();
    mesh::FitMeshSettings rough;
    rough.tolerance = mesh_tuning.rough_tolerance * made.mesh.bounds.diagonal();
    return mesh::find_planned_creases({made.runtime(), progress}, made.mesh, made.tree, made.creases, rough)
        .creases.has_value();
}

double farthest_moved(const Points& from, const Points& to) noexcept {
    double most = 0.0;
    for (std::size_t i = 0; i < from.size(); ++i) most = std::max(most, glm::length(to[i] - from[i]));
    return most;
}

// Divides the faces of a welded mesh according to `plan`, and checks the result.
DivisionResult divide(const Call& call, const Shape& welded, const mesh::CoarsePlan& plan, mesh::EdgesInFile said,
                      const mesh::MeshOptions& wishes, Shape& finer, const base::Progress& progress) {
    Pool& pool = call.pool;
    const double crease = std::isnan(call.options.desc.crease_angle) ? 180.0 : call.options.desc.crease_angle;
    DivisionResult found{plan};
    found.by_file = welded.has_sharp_edges;
    Vector<std::int64_t> parents(&pool);
    if (plan.parts_alone) {
        DividedParts parts = subdivide_coarse_parts(welded, plan.rounds, crease,
                                                    mesh::plan_tolerance(wishes.tolerance, 1.0), pool, progress);
        finer = std::move(parts.shape);
        parents = std::move(parts.parents);
    } else {
        finer = subdivide(welded, plan.rounds, crease, pool, progress);
        parents = parents_of(welded.triangles.size(), finer.triangles.size(), pool);
    }
    Vector<double> rise = raised(welded, finer, parents, pool);
    found.moved = farthest_moved(welded.points, finer.points) / box_diagonal_of(welded.points);
    found.raised = rise.empty() ? 0.0 : *std::max_element(rise.begin(), rise.end());
    if (wishes.rounds >= 0) return found;
    found.coarseness = coarseness(welded, subdivide_tuning.coarse_percentile, pool);
    const auto most_coarse = [&] { return coarseness(welded, 100.0, pool); };
    found.plan.choice = mesh::judge_division(
        {found.moved, percentile(rise, mesh_tuning.raised_percentile), found.coarseness, std::ref(most_coarse)}, said,
        wishes);
    return found;
}

void tell_divided(const Call& call, const DivisionResult& found) {
    Pool& pool = call.pool;
    Report& report = call.report;
    switch (found.plan.choice) {
    case DivisionResult::Choice::nothing: return;
    case DivisionResult::Choice::all_flat:
        report.note(HRBFNPR_NOTE_ALL_FLAT, {},
                    "all faces are flat, by the normals in the file ({edges=smooth} rounds them)");
        return;
    case DivisionResult::Choice::coarse_flat:
        report.note(HRBFNPR_NOTE_COARSE_FLAT, {},
                    "the faces are coarse and stay flat: no round shape fits them ({edges=smooth} rounds)");
        return;
    case DivisionResult::Choice::divided: break;
    }
    if (found.by_file)
        report.note(HRBFNPR_NOTE_EDGES_BY_NORMALS, {},
                    "edges are sharp or round by the normals in the file ({edges=auto} goes by their angles)");
    const String times = count_of(found.plan.rounds, "time", pool);
    const String moved = formatted(pool, "Vertices moved by up to %s of the diagonal, points between them by up to %s.",
                                   percent_of(found.moved, 2, pool).c_str(), percent_of(found.raised, 2, pool).c_str());
    const double rounds = found.plan.rounds;
    if (found.coarseness < 0.0)
        report.note(HRBFNPR_NOTE_DIVIDED, {rounds, found.moved, found.raised},
                    formatted(pool, "the faces are divided %s", times.c_str()), {.detail = moved});
    else
        report.note(
            HRBFNPR_NOTE_DIVIDED, {rounds, found.moved, found.raised, found.coarseness},
            formatted(pool, "the faces are coarse: divided %s and rounded ({subdivide=0} leaves them)", times.c_str()),
            {.detail = formatted(pool, "They were up to %s of the diagonal off a round shape. %s",
                                 percent_of(found.coarseness, 2, pool).c_str(), moved.c_str())});
}

// Divides the coarse faces of a mesh that approximates a round shape. Sharp edges are kept if they can be distinguished
// from coarse ones.
DivisionResult make_round(const Call& call, PreparedMesh& looked, Stage& stage) {
    Pool& pool = call.pool;
    const Options& options = call.options;
    Shape welded(pool);
    welded.points = vertices_of(looked.mesh, pool);
    welded.triangles = triangles_of(looked.mesh, pool);
    mesh::EdgesInFile said = mesh::EdgesInFile::nothing;
    const mesh::MeshOptions wishes = wishes_of(options, box_diagonal_of(welded.points));
    if (wishes.edges_as_given && wishes.chooses_samples && looked.shape.has_sharp_edges) {
        Vector<Edge> sharp = edges_among(welded.points, looked.shape.sharp_edges, looked.shape.points, pool);
        said = said_of_edges(welded.points, welded.triangles, sharp, pool);
        welded.has_sharp_edges = said == mesh::EdgesInFile::some_are_sharp;
        if (welded.has_sharp_edges) welded.sharp_edges = std::move(sharp);
    }
    const base::Progress progress = base::Progress(&stage.operation()->operation).without_progress();
    const auto mean = [&] { return mean_edge(welded, pool); };
    const auto coarse = [&] { return coarseness(welded, subdivide_tuning.coarse_percentile, pool); };
    const auto creases = [&] { return has_creases(looked.mesh, progress); };
    const auto faces = static_cast<std::int64_t>(welded.triangles.size());
    DivisionResult found{
        mesh::plan_coarse_faces({faces, said, std::ref(mean), std::ref(coarse), std::ref(creases)}, wishes)};
    Shape finer(pool);
    if (found.plan.choice == DivisionResult::Choice::divided)
        found = divide(call, welded, found.plan, said, wishes, finer, progress);
    looked.is_flat = found.plan.is_flat();
    if (found.plan.choice != DivisionResult::Choice::divided) return found;
    looked.mesh = same_mesh(call, finer.points, finer.triangles, crease_angle_of(options), stage.operation());
    looked.shape.points = std::move(finer.points);
    looked.shape.triangles = std::move(finer.triangles);
    looked.shape.normals.clear();
    looked.shape.sharp_edges.clear();
    looked.shape.has_sharp_edges = false;
    return found;
}

// ---- The whole mesh

void weld_and_clean(const Call& call, PreparedMesh& looked) {
    LeftOutParts left_out;
    hrbfnpr_mesh_info info;
    {
        Stage stage(call.report, HRBFNPR_STAGE_MESH);
        looked.mesh = welded_mesh(call, looked.shape.points, looked.shape.triangles, stage.operation());
        left_out = leave_out_lost(call, looked.mesh, looked.shape, stage.operation());
        info = info_of(looked.mesh);
        stage.says(borders_in_words(info, call.pool));
    }
    tell_mesh_repairs(call, info);
    tell_left_out(call, left_out);
}

std::int64_t samples_of_look(const Call& call) {
    if (chooses_samples(call.options)) return mesh_tuning.looked_at;
    const std::int64_t wanted = call.options.desc.samples > 0 ? call.options.desc.samples : mesh_tuning.samples;
    if (wanted > mesh_tuning.most_samples)
        call.report.refuse(formatted(call.pool, "{samples=%lld} is too many for a mesh: give %lld at most",
                                     static_cast<long long>(wanted), static_cast<long long>(mesh_tuning.most_samples)));
    return wanted;
}

// Turns faces that point the wrong way, then divides coarse faces.
void sample_and_divide(const Call& call, PreparedMesh& looked) {
    const Options& options = call.options;
    const std::int64_t count = samples_of_look(call);
    auto desc = defaults<hrbfnpr_sample_desc>(hrbfnpr_sample_desc_init);
    desc.random_seed = options.desc.random_seed;
    mesh::Facing facing = mesh::Facing::right;
    DivisionResult divided;
    {
        Stage stage(call.report, HRBFNPR_STAGE_SAMPLE);
        looked.points.resize(static_cast<std::size_t>(count));
        looked.normals.resize(static_cast<std::size_t>(count));
        sample_mesh(looked.mesh, desc, looked.points, &looked.normals, stage.operation());
        stage.says(formatted(call.pool, "%lld samples%s", static_cast<long long>(count),
                             chooses_samples(options) ? ", to check which way faces look" : ""));
        facing = facing_of(call, looked);
        if (facing != mesh::Facing::right) {
            Vector<Triangle> turned(&call.pool);
            for (const Triangle& face : looked.shape.triangles) turned.push_back({face[2], face[1], face[0]});
            looked.mesh = welded_mesh(call, looked.shape.points, turned, stage.operation());
        }
        divided = make_round(call, looked, stage);
        if (facing != mesh::Facing::right || divided.plan.choice == DivisionResult::Choice::divided)
            sample_mesh(looked.mesh, desc, looked.points, &looked.normals, stage.operation());
    }
    tell_facing(call, facing);
    tell_divided(call, divided);
    if (options.has(HRBFNPR_PICTURE_FLIP))
        for (glm::dvec3& normal : looked.normals) normal = -normal;
}

PreparedMesh prepare_mesh(const Call& call, Shape&& shape) {
    PreparedMesh looked{{}, std::move(shape), Points(&call.pool), Points(&call.pool)};
    weld_and_clean(call, looked);
    sample_and_divide(call, looked);
    return looked;
}

// ---- Groups

struct MeshGroup {
    Mesh mesh;
    std::shared_ptr<const Shape> shape;
};

// Returns whether the mesh may be split into several surfaces. It is not split if the caller asks for one surface, or
// for a plate, which shows one surface.
bool may_be_apart(const Options& options) {
    const bool wants_one = options.has(HRBFNPR_PICTURE_TOGETHER) || options.has(HRBFNPR_PICTURE_CLOSE) ||
                           options.is_find() || options.settings != nullptr ||
                           options.desc.profile == HRBFNPR_PROFILE_YES || options.desc.scale_bar != nullptr ||
                           options.desc.source_count > 1;
    return !wants_one && chooses_samples(options);
}

// Makes a group from some faces of a mesh. `whole` is the shape of all faces.
MeshGroup group_of_faces(const Call& call, const Mesh& mesh, const Shape& whole, const FaceNumbers& faces) {
    Pool& pool = call.pool;
    const Points vertices = vertices_of(mesh, pool);
    const Vector<Triangle> triangles = triangles_of(mesh, pool);
    Vector<std::int64_t> number(vertices.size(), -1, &pool); // for each vertex: its new index, or -1 if no face uses it
    for (const std::int64_t face : faces)
        for (const std::int64_t corner : triangles[static_cast<std::size_t>(face)])
            number[static_cast<std::size_t>(corner)] = 0;
    auto shape = std::make_shared<Shape>(pool);
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        if (number[v] < 0) continue;
        number[v] = static_cast<std::int64_t>(shape->points.size());
        shape->points.push_back(vertices[v]);
    }
    const auto number_of = [&](std::int64_t corner) { return number[static_cast<std::size_t>(corner)]; };
    for (const std::int64_t f : faces) {
        const Triangle& face = triangles[static_cast<std::size_t>(f)];
        shape->triangles.push_back({number_of(face[0]), number_of(face[1]), number_of(face[2])});
    }
    shape->up = whole.up;
    shape->up_by = whole.up_by;
    shape->viewpoint = whole.viewpoint;
    shape->is_photo = whole.is_photo;
    shape->columns = whole.columns;
    shape->rows = whole.rows;
    Mesh made = same_mesh(call, shape->points, shape->triangles, crease_angle_of(call.options), nullptr);
    return {std::move(made), std::move(shape)};
}

// Returns the whole mesh as one group, or groups of parts that cannot belong to one surface, the largest first.
Vector<MeshGroup> groups_of_mesh(const Call& call, Mesh&& mesh, Shape&& shape) {
    Vector<MeshGroup> groups(&call.pool);
    std::optional<FaceGroups> found;
    if (may_be_apart(call.options)) found = find_groups(mesh, call.pool);
    if (!found) {
        groups.push_back({std::move(mesh), std::make_shared<Shape>(std::move(shape))});
        return groups;
    }
    call.report.note(HRBFNPR_NOTE_GROUPS,
                     {static_cast<double>(found->parts), static_cast<double>(found->groups.size())},
                     formatted(call.pool, "%s cross or nearly touch: drawn as %zu surfaces ({together!} joins them)",
                               count_of(found->parts, "part", call.pool).c_str(), found->groups.size()),
                     {.detail = "Some of these parts are open, so one surface through all of them would be wrong."});
    for (const FaceNumbers& faces : found->groups) groups.push_back(group_of_faces(call, mesh, shape, faces));
    return groups;
}

// ---- The fit

// Sets up the fit of a group. `across` is the diagonal of all groups together, or 0 for a single group.
hrbfnpr_mesh_fit_desc fit_of_mesh(const Options& options, const Shape& shape, bool is_flat, double across) {
    auto desc = defaults<hrbfnpr_mesh_fit_desc>(hrbfnpr_mesh_fit_desc_init);
    desc.random_seed = options.desc.random_seed;
    options.changes.apply("mesh_fit", desc);
    const bool gives_tolerance = options.desc.tolerance > 0.0 || options.changes.has("mesh_fit.tolerance");
    if (options.desc.tolerance > 0.0) desc.tolerance = options.desc.tolerance;
    if (options.desc.maximum_centres > 0) desc.maximum_centres = options.desc.maximum_centres;
    const mesh::FittedEdges edges = mesh::plan_fitted_edges({static_cast<mesh::Edges>(desc.edges), desc.crease_angle},
                                                            wishes_of(options, 0.0), is_flat);
    desc.edges = static_cast<std::uint32_t>(edges.edges);
    desc.crease_angle = edges.angle;
    if (across > 0.0 && !gives_tolerance)
        desc.tolerance = mesh::plan_tolerance_of_group(box_diagonal_of(shape.points), across);
    return desc;
}

// Returns options of a fit to samples, but only those that also apply to a fit to a mesh.
hrbfnpr_fit_desc solver_of_mesh(const Options& options, bool ends) {
    const hrbfnpr_fit_desc wanted = wanted_fit(options);
    auto desc = defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init);
    desc.kernel = wanted.kernel;
    desc.kernel_radius = wanted.kernel_radius;
    desc.polynomial_degree = wanted.polynomial_degree;
    desc.regularization = wanted.regularization;
    desc.solver = wanted.solver;
    desc.trim = ends ? HRBFNPR_TRIM_AUTO : HRBFNPR_TRIM_NEVER;
    return desc;
}

// The advice for a fit that did not reach its tolerance.
struct Remedy {
    String text;
    const char* detail = "";
};

// Returns the advice for a fit that did not reach its tolerance.
Remedy remedy_of_shortfall(const Call& call, const hrbfnpr_mesh_fit_info& done) {
    const Options& options = call.options;
    std::int64_t most = options.desc.maximum_centres > 0 ? options.desc.maximum_centres : mesh_tuning.most_centres;
    if (done.sheets > 1) most = std::max(most, mesh_tuning.centres_a_sheet * done.sheets);
    if (static_cast<double>(done.centres) >= mesh_tuning.nearly_all_centres * static_cast<double>(most))
        return {formatted(call.pool, "{max_centres=%lld} helps", static_cast<long long>(2 * most))};
    if (done.sheets > 1 && done.mesh_share < mesh_tuning.mostly_reached && edges_are_as_given(options))
        return {{"{edges=5} keeps faces flat", &call.pool},
                "The faces are coarse, and the round surface bulges over them. "};
    return {{done.sheets == 1 ? "sharp edges are rounded" : "some edges are rounded", &call.pool},
            "Very thin parts are rounded too. "};
}

void warn_of_shortfall(const Call& call, const hrbfnpr_mesh_fit_info& done, double diagonal) {
    Pool& pool = call.pool;
    const double farthest = std::fmax(done.mesh_max, done.surface_max) / diagonal;
    const String mesh = percent_of(1.0 - done.mesh_share, 1, pool);
    String farther =
        formatted(pool, "%s of the mesh is farther off; no surface was found to measure from.", mesh.c_str());
    if (!std::isnan(done.surface_share)) {
        farther = formatted(pool, "%s of the mesh and %s of the surface are farther off, ", mesh.c_str(),
                            percent_of(1.0 - done.surface_share, 1, pool).c_str());
        farther += std::isfinite(farthest)
                       ? formatted(pool, "by at most %s of the diagonal.", percent_of(farthest, 1, pool).c_str())
                       : String("and parts of the mesh have no surface near them.", &pool);
    }
    const Remedy remedy = remedy_of_shortfall(call, done);
    call.report.warn(HRBFNPR_NOTE_NOT_REACHED,
                     {done.tolerance / diagonal, done.mesh_share, done.surface_share, farthest},
                     formatted(pool, "the surface is over %s of the diagonal off the mesh in places: %s",
                               percent_of(done.tolerance / diagonal, 2, pool).c_str(), remedy.text.c_str()),
                     {.detail = formatted(pool, "%s%s", remedy.detail, farther.c_str())});
}

void tell_mesh_fit(const Call& call, const hrbfnpr_mesh_fit_info& done, double diagonal) {
    if (done.touching_parts[0] >= 0)
        call.report.warn(
            HRBFNPR_NOTE_PARTS_TOO_THIN,
            {static_cast<double>(done.touching_parts[0]), static_cast<double>(done.touching_parts[1]),
             done.touching_place[0], done.touching_place[1], done.touching_place[2]},
            formatted(call.pool, "parts %d and %d %snearly touch, and may be joined: try a smaller {tolerance}",
                      static_cast<int>(done.touching_parts[0]), static_cast<int>(done.touching_parts[1]),
                      done.parts_may_cross != 0 ? "cross or " : ""),
            {.detail = formatted(call.pool,
                                 "They come closer than the tolerance near %.4g %.4g %.4g, and other parts "
                                 "may do so too. Parts that cross are joined with any tolerance.",
                                 done.touching_place[0], done.touching_place[1], done.touching_place[2])});
    if (done.reached == 0) warn_of_shortfall(call, done, diagonal);
    if (done.smooth_length > mesh_tuning.told_smooth_length * diagonal)
        call.report.note(HRBFNPR_NOTE_EDGES_STAY_SMOOTH, {done.smooth_length / diagonal},
                         formatted(call.pool, "some sharp edges are rounded, %.2g diagonals long in all",
                                   done.smooth_length / diagonal));
}

// Fits a model to the group, within a tolerance measured in both directions. Warns where the fit exceeds it.
Model fit_group(const Call& call, const MeshGroup& group, bool is_flat, double across, hrbfnpr_mesh_fit_info& done) {
    Pool& pool = call.pool;
    const bool ends = info_of(group.mesh).boundary_edges > 0 && !call.options.has(HRBFNPR_PICTURE_CLOSE);
    const hrbfnpr_mesh_fit_desc desc = fit_of_mesh(call.options, *group.shape, is_flat, across);
    const hrbfnpr_fit_desc solver = solver_of_mesh(call.options, ends);
    done = defaults<hrbfnpr_mesh_fit_info>(hrbfnpr_mesh_fit_info_init);
    Model model;
    double diagonal = 1.0;
    {
        Stage stage(call.report, HRBFNPR_STAGE_FIT);
        model = make<Model>([&](hrbfnpr_model** made, hrbfnpr_error* error) {
            return hrbfnpr_model_fit_mesh(group.mesh.get(), &desc, &solver, &done, stage.operation(), made, error);
        });
        diagonal = diagonal_of(model);
        const String how = done.sheets == 1 ? count_of(done.rounds, "round", pool)
                                            : formatted(pool, "%d sheets", static_cast<int>(done.sheets));
        stage.says(formatted(pool, "%lld centres in %s; %s", static_cast<long long>(done.centres), how.c_str(),
                             distances_in_words(done, diagonal, pool).c_str()));
    }
    tell_mesh_fit(call, done, diagonal);
    return model;
}

// ---- The end

mesh::EndPlan end_plan_of(const Model& model, const hrbfnpr_mesh_info& mesh,
                          const std::optional<hrbfnpr_mesh_fit_info>& fit, bool may_end) {
    const hrbfnpr_model_info info = model_info_of(model);
    if (!fit) return mesh::plan_end_of_samples(info.spacing, diagonal_of(info), may_end);
    mesh::EndFacts facts;
    facts.diagonal = diagonal_of(info);
    facts.has_border = mesh.boundary_edges > 0;
    facts.closed = mesh.closed != 0;
    facts.has_creases = fit->sheets > 1;
    facts.mesh_p99 = fit->mesh_p99;
    facts.surface_most = fit->surface_max;
    return mesh::plan_end_of_picture(facts, may_end);
}

// Warns if the fit of a closed mesh made surface where the mesh has none. This surface is removed.
void tell_made_by_fit(const Call& call, const Model& ended, bool of_sheets) {
    const hrbfnpr_trim_info info = trim_info_of(ended);
    if (!(info.share > mesh_tuning.doubted_share)) return;
    String remedy("mend faces that cross or fold there", &call.pool);
    if (!of_sheets)
        remedy = formatted(call.pool, "try {samples=%lld}",
                           static_cast<long long>(mesh_tuning.more_samples) *
                               static_cast<long long>(model_info_of(ended).centres));
    call.report.warn(HRBFNPR_NOTE_MADE_BY_FIT, {static_cast<double>(info.parts)},
                     formatted(call.pool, "%s of the surface left out, as the mesh has none there: %s",
                               count_of(info.parts, "part", call.pool).c_str(), remedy.c_str()));
}

// Returns the model without the surface that lies beyond the mesh, unless the caller wants a closed surface. If the
// mesh is closed, only the fit can have made surface beyond it.
Model end_of_mesh(const Call& call, const Model& model, const Mesh& mesh,
                  const std::optional<hrbfnpr_mesh_fit_info>& fit) {
    const hrbfnpr_mesh_info info = info_of(mesh);
    const mesh::EndPlan plan = end_plan_of(model, info, fit, !call.options.has(HRBFNPR_PICTURE_CLOSE));
    if (plan.end == mesh::End::nowhere) return model;
    if (plan.end == mesh::End::as_fitted) {
        Stage stage(call.report, HRBFNPR_STAGE_END);
        stage.says(trim_in_words(call, model, "mesh"));
        return model;
    }
    Points places(static_cast<std::size_t>(mesh_tuning.end_places), glm::dvec3(0.0), &call.pool);
    auto dense = defaults<hrbfnpr_sample_desc>(hrbfnpr_sample_desc_init);
    dense.candidates = mesh_tuning.end_candidates;
    sample_mesh(mesh, dense, places, nullptr, nullptr);
    auto desc = defaults<hrbfnpr_trim_desc>(hrbfnpr_trim_desc_init);
    desc.hole = desc.closest = plan.off;
    Model ended = ended_by(call, model, places, "mesh", desc);
    if (info.closed != 0) tell_made_by_fit(call, ended, fit && fit->sheets > 1);
    return ended;
}

// Makes the surface of a group. If the fit does not choose its samples, it uses the samples of `looked`, which are
// spread over the whole mesh.
Surface surface_of_group(const Call& call, MeshGroup&& group, const PreparedMesh& looked, double across) {
    Surface surface;
    if (chooses_samples(call.options)) {
        surface.fit.emplace();
        surface.model = fit_group(call, group, looked.is_flat, across, *surface.fit);
    } else {
        surface.model = fit_samples(call, looked.points, looked.normals, false, false);
        tell_nearness(call, group.mesh, surface.model);
    }
    surface.model = end_of_mesh(call, surface.model, group.mesh, surface.fit);
    surface.mesh = std::move(group.mesh);
    surface.shape = std::move(group.shape);
    return surface;
}

} // namespace

Vector<Surface> fit_mesh(const Call& call, Shape&& shape, glm::dvec3& up) {
    HRBFNPR_ASSERT(shape.is_mesh());
    PreparedMesh looked = prepare_mesh(call, std::move(shape));
    tell_thin_evidence(call, looked.points);
    up = choose_up(call, &looked.shape, looked.points, looked.normals);
    const double diagonal = box_diagonal_of(looked.shape.points);
    Vector<MeshGroup> groups = groups_of_mesh(call, std::move(looked.mesh), std::move(looked.shape));
    const double across = groups.size() == 1 ? 0.0 : diagonal;
    Vector<Surface> surfaces(&call.pool);
    surfaces.reserve(groups.size());
    for (MeshGroup& group : groups) surfaces.push_back(surface_of_group(call, std::move(group), looked, across));
    return surfaces;
}

} // namespace hrbfnpr::picture
