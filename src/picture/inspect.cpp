// SPDX-License-Identifier: MIT
// Inspects points and meshes in the order of the steps that make a picture. Points that mark missing data are removed
// first, then strays (outliers). After that, positions, duplicates, the topology of a mesh, normals and the up
// direction are examined. A note names a repair that a picture would make, and a warning names a risk.
#include "picture/inspect.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/operation.h"
#include "picture/faces.h"
#include "picture/look.h"
#include "picture/make.h"
#include "picture/mesh_facts.h"
#include "picture/nearness.h"
#include "picture/normals.h"
#include "picture/points.h"
#include "picture/strays.h"
#include "picture/tuning_points.h"
#include "picture/up.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hrbfnpr::picture {
namespace {

// The samples that are used to judge the normals and to find the up direction.
struct InspectedSamples {
    Points points;
    Points normals; // one unit vector for each point; all zero if the source has no normals
};

bool has_finite_place(const glm::dvec3& p) noexcept {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

double as_figure(std::int64_t count) noexcept { return static_cast<double>(count); }

void copy_vector(const glm::dvec3& from, double (&to)[3]) noexcept {
    for (glm::length_t axis = 0; axis < 3; ++axis) to[axis] = from[axis];
}

void copy_bounds(const geometry::Bounds& bounds, hrbfnpr_source_info& info) noexcept {
    copy_vector(bounds.min, info.bounds_min);
    copy_vector(bounds.max, info.bounds_max);
    info.diagonal = glm::length(bounds.max - bounds.min);
}

// ---- Places

// Removes points that a picture does not use: values that mark missing data, and strays of a source without faces.
void leave_out_unused(const Call& call, Shape& shape, hrbfnpr_source_info& info) {
    Pool& pool = call.pool;
    const NoData no_data = leave_out_no_data(shape, pool);
    info.no_data = no_data.points;
    if (no_data.points != 0)
        call.report.note(HRBFNPR_NOTE_NO_DATA, {as_figure(no_data.points), no_data.value},
                         count_of(no_data.points, "point", pool) +=
                         formatted(pool, " left out, as the value %g marks missing data", no_data.value));
    if (shape.is_mesh()) return;
    info.strays = leave_out_far(shape, pool);
    if (info.strays != 0)
        call.report.note(HRBFNPR_NOTE_STRAYS, {as_figure(info.strays)},
                         count_of(info.strays, "point", pool) += " far from all others left out");
}

void inspect_places(const Call& call, const Shape& shape, hrbfnpr_source_info& info) {
    Pool& pool = call.pool;
    Report& report = call.report;
    geometry::Bounds bounds;
    for (const glm::dvec3& p : shape.points) {
        if (has_finite_place(p))
            bounds.extend(p);
        else
            ++info.points_not_finite;
    }
    const std::int64_t lost = info.points_not_finite;
    if (bounds.empty()) report.refuse("no point is finite");
    copy_bounds(bounds, info);
    if (lost != 0 && !shape.is_mesh() && !shape.is_photo) {
        report.note(HRBFNPR_NOTE_POINTS_NOT_USABLE, {as_figure(lost)},
                    count_of(lost, "point", pool) += " without a finite position left out");
        report.warn(HRBFNPR_NOTE_POINTS_NOT_USABLE, {as_figure(lost)},
                    formatted(pool, "%s %s a position that is not finite", count_of(lost, "point", pool).c_str(),
                              has_or_have(lost)));
    }
    const glm::dvec3 off = glm::abs(bounds.min + bounds.max) / 2.0;
    if (info.diagonal == 0.0)
        report.warn(HRBFNPR_NOTE_AT_ONE_PLACE, {}, "all points are at one place: there is no surface to draw",
                    {.advice = "check the scale in the program that wrote the file"});
    else if (std::max(std::max(off.x, off.y), off.z) > inspect_tuning.far_from_origin * info.diagonal)
        report.warn(HRBFNPR_NOTE_FAR_FROM_ORIGIN, {},
                    "the model is far from the origin for its size: single precision loses its details",
                    {.advice = "move it to the origin with a program that keeps double precision"});
}

// ---- Normals

// Finds which way normals point, and warns if they do not point outward.
void inspect_orientation(const Call& call, const InspectedSamples& samples, bool of_mesh, hrbfnpr_source_info& info) {
    Report& report = call.report;
    const NormalsLook look = look_at_normals(samples.points, samples.normals, of_mesh, call.pool);
    info.normals_closed = look.closed;
    info.normals_flipped_share = look.flipped;
    info.normals_look = look.inward()                               ? HRBFNPR_NORMALS_LOOK_INWARD
                        : look.mixed()                              ? HRBFNPR_NORMALS_LOOK_MIXED
                        : look.closed <= -normals_tuning.inward_sum ? HRBFNPR_NORMALS_LOOK_OPEN
                                                                    : HRBFNPR_NORMALS_LOOK_OUTWARD;
    if (look.inward()) {
        report.note(HRBFNPR_NOTE_NORMALS_TURNED, {}, "all normals turned, as they point inward");
        report.warn(HRBFNPR_NOTE_NORMALS_TURNED, {}, "all normals point inward",
                    {.advice = "nothing, as the fit turns them; {normals=keep} leaves them"});
    }
    if (const char axis = hangs_along(samples.points, samples.normals); axis != 0) {
        info.looks_down = static_cast<std::uint32_t>(axis - 'x');
        report.note(HRBFNPR_NOTE_TERRAIN_TURNED, {double(info.looks_down)},
                    "all normals turned, as a terrain faces up");
        report.warn(HRBFNPR_NOTE_TERRAIN_TURNED, {double(info.looks_down)},
                    formatted(call.pool, "the surface is a terrain whose normals point down along %c", axis),
                    {.advice = "nothing, as the fit turns them; {normals=keep} leaves them"});
    }
    tell_wrong_normals(call, look, samples.points.size(), of_mesh, true);
}

std::uint32_t look_of_found(std::uint32_t found) noexcept {
    switch (found) {
    case HRBFNPR_NORMALS_GIVEN: return HRBFNPR_NORMALS_LOOK_OUTWARD;
    case HRBFNPR_NORMALS_NONE: return HRBFNPR_NORMALS_LOOK_FOREIGN;
    case HRBFNPR_NORMALS_INWARD: return HRBFNPR_NORMALS_LOOK_INWARD;
    default: return HRBFNPR_NORMALS_LOOK_MIXED;
    }
}

// Finds which way the normals point if the points lie along curves. Neighbours and winding numbers tell nothing there.
void inspect_orientation_on_curves(const Call& call, const InspectedSamples& samples, hrbfnpr_source_info& info) {
    Report& report = call.report;
    std::uint32_t found = HRBFNPR_NORMALS_GIVEN;
    {
        Stage stage(report, HRBFNPR_STAGE_ORIENT);
        found = make_normals(call, stage, samples.points, samples.normals, HRBFNPR_NORMALS_GIVEN, ViewingHints{})
                    .info.found;
    }
    info.normals_look = look_of_found(found);
    if (info.normals_look == HRBFNPR_NORMALS_LOOK_OUTWARD) return;
    const char* const words = found_in_words(found);
    report.note(HRBFNPR_NOTE_NORMALS_REPAIRED, {0.0, 0.0, double(found)},
                formatted(call.pool, "normals repaired, as they %s", words));
    report.warn(HRBFNPR_NOTE_NORMALS_REPAIRED, {0.0, 0.0, double(found)}, formatted(call.pool, "the normals %s", words),
                {.advice = "nothing, as the fit repairs them; {normals=keep} leaves them"});
}

// ---- Points

std::int64_t count_at_place_of_another(Points points) {
    std::sort(points.begin(), points.end(), [](const glm::dvec3& a, const glm::dvec3& b) {
        if (a.x != b.x) return a.x < b.x;
        return a.y != b.y ? a.y < b.y : a.z < b.z;
    });
    return points.end() - std::unique(points.begin(), points.end());
}

// Returns the points that a picture can use, with unit normals. Counts unusable normals.
InspectedSamples usable_points(const Call& call, const Shape& shape, hrbfnpr_source_info& info) {
    HRBFNPR_ASSERT(shape.normals.size() == shape.points.size());
    InspectedSamples usable{Points(&call.pool), Points(&call.pool)};
    std::int64_t unit = 0;
    for (std::size_t i = 0; i < shape.points.size(); ++i) {
        const glm::dvec3& normal = shape.normals[i];
        const double length = glm::length(normal);
        info.normals_not_finite += std::isfinite(length) ? 0 : 1;
        info.normals_zero += length == 0.0 ? 1 : 0;
        if (!has_finite_place(shape.points[i]) || !std::isfinite(length) || !(length > 0.0)) continue;
        unit += std::abs(length - 1.0) < inspect_tuning.unit_length ? 1 : 0;
        usable.points.push_back(shape.points[i]);
        usable.normals.emplace_back(normal.x / length, normal.y / length, normal.z / length);
    }
    if (!usable.points.empty()) info.normals_unit_share = as_figure(unit) / static_cast<double>(usable.points.size());
    return usable;
}

void tell_unusable_normals(const Call& call, const hrbfnpr_source_info& info, std::size_t usable) {
    Pool& pool = call.pool;
    Report& report = call.report;
    const std::int64_t lost = info.normals_zero + info.normals_not_finite;
    if (lost != 0) {
        report.note(HRBFNPR_NOTE_POINTS_NOT_USABLE, {as_figure(lost)},
                    count_of(lost, "point", pool) += " without a usable normal left out");
        report.warn(HRBFNPR_NOTE_POINTS_NOT_USABLE, {as_figure(lost)},
                    formatted(pool, "%lld normals are zero, %lld not finite", static_cast<long long>(info.normals_zero),
                              static_cast<long long>(info.normals_not_finite)));
    }
    if (usable == 0) report.refuse("no point has both a finite position and a normal that is not zero");
    if (info.normals_unit_share < 1.0) {
        const double others = std::nearbyint((1.0 - info.normals_unit_share) * static_cast<double>(usable));
        report.note(HRBFNPR_NOTE_NORMALS_NOT_UNIT, {others},
                    count_of(static_cast<std::int64_t>(others), "normal", pool) += " scaled to length 1");
    }
    if (usable < points_tuning.few_samples)
        report.warn(HRBFNPR_NOTE_FEW_POINTS, {static_cast<double>(usable)},
                    formatted(pool, "there are only %s: the surface between them is a guess",
                              count_of(static_cast<std::int64_t>(usable), "point", pool).c_str()));
}

// Leaves at most one sample at each position. If the normals at a position are opposite, all of its samples are
// removed.
void join_at_places(const Call& call, InspectedSamples& samples) {
    const SharedPlaces places = merge_shared_places(samples.points, samples.normals, call.pool);
    if (places.joined != 0)
        call.report.note(HRBFNPR_NOTE_NORMALS_JOINED, {as_figure(places.joined)},
                         count_of(places.joined, "place", call.pool) += " with several normals: their mean is used");
    if (places.left_out != 0)
        call.report.warn(HRBFNPR_NOTE_NORMALS_OPPOSITE, {as_figure(places.left_out)},
                         count_of(places.left_out, "place", call.pool) += " with opposite normals left out");
    if (samples.points.empty()) call.report.refuse("all points come in pairs with opposite normals");
}

InspectedSamples inspect_points(const Call& call, const Shape& shape, hrbfnpr_source_info& info) {
    Pool& pool = call.pool;
    Report& report = call.report;
    Points finite(&pool);
    for (const glm::dvec3& p : shape.points)
        if (has_finite_place(p)) finite.push_back(p);
    info.along_curves = lie_along_curves(finite, pool) ? 1 : 0;
    info.duplicates = count_at_place_of_another(Points(finite, &pool));
    if (info.duplicates != 0)
        report.note(HRBFNPR_NOTE_SAMPLES_MERGED, {as_figure(info.duplicates)},
                    count_of(info.duplicates, "point", pool) +=
                    " merged with another at the same place, if their normals agree");
    if (info.has_normals == 0) {
        const auto count = static_cast<double>(finite.size());
        report.note(HRBFNPR_NOTE_NORMALS_MADE, {count},
                    shape.normals.empty() ? "normals computed, as there are none"
                                          : "normals computed, as all are zero");
        report.warn(HRBFNPR_NOTE_NORMALS_MADE, {count}, "the points have no normals",
                    {.advice = "nothing, as they are computed; normals from the scanner are more reliable"});
        Points zeros(finite.size(), glm::dvec3(0.0), &pool);
        return {std::move(finite), std::move(zeros)};
    }
    InspectedSamples samples = usable_points(call, shape, info);
    tell_unusable_normals(call, info, samples.points.size());
    join_at_places(call, samples);
    if (info.along_curves != 0)
        inspect_orientation_on_curves(call, samples, info);
    else
        inspect_orientation(call, samples, false, info);
    return samples;
}

// ---- Depth images

InspectedSamples inspect_image(const Call& call, Shape& shape, hrbfnpr_source_info& info) {
    Pool& pool = call.pool;
    hrbfnpr_depth_image_info found;
    {
        Stage stage(call.report, HRBFNPR_STAGE_SMOOTH);
        found = smooth_depth_image(call, stage, shape);
    }
    info.image_seen = found.seen;
    info.image_dropped = found.left_out;
    info.image_depth = found.depth;
    info.image_noise = depth_noise_of(found);
    call.report.note(HRBFNPR_NOTE_DEPTH_NOISE, {info.image_noise, info.image_depth},
                     formatted(pool,
                               "depth image smoothed over %.1f pixels at depth %.3g (noise %.2g); normals computed",
                               found.radius, info.image_depth, info.image_noise));
    if (found.left_out != 0)
        call.report.note(HRBFNPR_NOTE_PIXELS_LEFT_OUT, {as_figure(found.left_out)},
                         count_of(found.left_out, "pixel", pool) += " on no surface left out");
    return {Points(shape.points, &pool), Points(shape.normals, &pool)};
}

// ---- Meshes

void copy_mesh_facts(const MeshFacts& facts, hrbfnpr_source_info& info) noexcept {
    info.duplicates = facts.joined_vertices;
    info.closed = facts.closed ? 1 : 0;
    info.inside_out = facts.inside_out ? 1 : 0;
    info.components = facts.components;
    info.components_inside_out = facts.components_inside_out;
    info.boundary_edges = facts.boundary_edges;
    info.boundary_loops = facts.boundary_loops;
    info.nonmanifold_edges = facts.nonmanifold_edges;
    info.contrary_edges = facts.contrary_edges;
    info.faces_not_finite = facts.faces_not_finite;
    info.degenerate_faces = facts.degenerate_faces;
    info.repeated_faces = facts.repeated_faces;
    info.unused_vertices = facts.unused_vertices;
    info.area = facts.area;
    info.volume = facts.volume;
}

void tell_faces_and_vertices(const Call& call, const MeshFacts& facts) {
    struct Repair {
        std::uint32_t code;
        std::int64_t count;
        const char* noun;
        const char* what;
    };
    const std::array repairs{
        Repair{HRBFNPR_NOTE_VERTICES_JOINED, facts.joined_vertices, "vertex", "joined with another at the same place"},
        Repair{HRBFNPR_NOTE_FACES_LEFT_OUT, facts.degenerate_faces, "triangle", "without area left out"},
        Repair{HRBFNPR_NOTE_VERTICES_UNUSED, facts.unused_vertices, "vertex", "that no face uses left out"}};
    for (const Repair& repair : repairs)
        if (repair.count != 0)
            call.report.note(
                repair.code, {as_figure(repair.count)},
                formatted(call.pool, "%s %s", count_of(repair.count, repair.noun, call.pool).c_str(), repair.what));
    if (facts.faces_not_finite == 0) return;
    const String faces = count_of(facts.faces_not_finite, "face", call.pool);
    call.report.note(HRBFNPR_NOTE_FACES_NOT_FINITE, {as_figure(facts.faces_not_finite)},
                     String(faces, &call.pool) += " left out, as a corner is not finite");
    call.report.warn(
        HRBFNPR_NOTE_FACES_NOT_FINITE, {as_figure(facts.faces_not_finite)},
        formatted(call.pool, "%s %s a corner that is not finite", faces.c_str(), has_or_have(facts.faces_not_finite)));
}

void tell_inside_out(const Call& call, const MeshFacts& facts) {
    Report& report = call.report;
    if (facts.inside_out) {
        report.note(HRBFNPR_NOTE_INSIDE_OUT, {as_figure(facts.components_inside_out)},
                    "all faces turned, as the mesh is inside out");
        report.warn(HRBFNPR_NOTE_INSIDE_OUT, {as_figure(facts.components_inside_out)}, "the mesh is inside out",
                    {.advice = "nothing, as the fit turns its faces"});
    } else if (facts.components_inside_out != 0) {
        report.warn(HRBFNPR_NOTE_INSIDE_OUT, {as_figure(facts.components_inside_out)},
                    formatted(call.pool, "%lld of %lld parts are inside out or are cavities",
                              static_cast<long long>(facts.components_inside_out),
                              static_cast<long long>(facts.components)),
                    {.advice = "unless they are cavities, turn their faces in MeshLab or Blender",
                     .detail = how_to_turn_faces});
    }
}

// Reports how a fit treats edges with more than two faces. `left` is the number of such edges after the mesh was
// mended.
void tell_nonmanifold(const Call& call, std::int64_t found, std::int64_t left, bool has_repeated_faces) {
    if (left < found)
        call.report.note(HRBFNPR_NOTE_NONMANIFOLD_EDGES, {as_figure(found - left)},
                         (count_of(found - left, "edge", call.pool) += " of more than two triangles ") +=
                         has_repeated_faces ? "mended by leaving out repeated faces" : "split where solids touch");
    if (left != 0)
        call.report.warn(HRBFNPR_NOTE_NONMANIFOLD_EDGES, {as_figure(left)},
                         formatted(call.pool, "%s %s more than two triangles",
                                   count_of(left, "edge", call.pool).c_str(), has_or_have(left)),
                         {.advice = "nothing, if the picture looks right"});
}

void tell_open(const Call& call, const MeshFacts& facts) {
    if (facts.boundary_edges == 0) return;
    call.report.warn(HRBFNPR_NOTE_MESH_OPEN, {as_figure(facts.boundary_loops), as_figure(facts.boundary_edges)},
                     formatted(call.pool, "the mesh is open: it has %s of %s",
                               count_of(facts.boundary_loops, "border", call.pool).c_str(),
                               count_of(facts.boundary_edges, "edge", call.pool).c_str()),
                     {.advice = "nothing, as small holes are closed and wide ones stay open; {close!} closes all",
                      .detail = "The border of a hole that stays open is drawn as a line."});
}

void tell_contrary_and_parts(const Call& call, const MeshFacts& facts) {
    if (facts.contrary_edges != 0)
        call.report.warn(HRBFNPR_NOTE_CONTRARY_EDGES, {as_figure(facts.contrary_edges)},
                         count_of(facts.contrary_edges, "edge", call.pool) +=
                         " between triangles that face opposite sides",
                         {.advice = "turn faces in MeshLab or Blender", .detail = how_to_turn_faces});
    if (facts.components > 1)
        call.report.warn(HRBFNPR_NOTE_SEVERAL_PARTS, {as_figure(facts.components)},
                         formatted(call.pool, "the mesh has %lld parts", static_cast<long long>(facts.components)),
                         {.advice = "nothing, as parts inside others are left out; {parts=all} keeps them",
                          .detail = "Open parts that cross or nearly touch are drawn as separate surfaces."});
}

// Returns whether an error was caused by the source, not by the call.
bool is_of_source(const Error& error) noexcept {
    return error.status() == Status::invalid_argument || error.status() == Status::singular_system ||
           error.status() == Status::not_converged;
}

// The repaired mesh, or the error that made the repair fail.
struct RepairedMesh {
    Mesh mesh;
    std::optional<Error> error;
};

// Repairs a mesh in the way that a fit repairs it, but keeps all parts of the mesh.
RepairedMesh repair_mesh(const Call& call, const Shape& shape) {
    Stage stage(call.report, HRBFNPR_STAGE_MESH);
    auto desc = defaults<hrbfnpr_mesh_desc>(hrbfnpr_mesh_desc_init);
    desc.vertices = view_of(shape.points);
    desc.triangles = view_of(shape.triangles);
    desc.parts = HRBFNPR_PARTS_ALL;
    try {
        return {make<Mesh>([&](hrbfnpr_mesh** made, hrbfnpr_error* error) {
                    return hrbfnpr_mesh_create(&call.context, &desc, stage.operation(), made, error);
                }),
                std::nullopt};
    } catch (const Error& error) {
        if (!is_of_source(error)) throw;
        return {Mesh(), error};
    }
}

InspectedSamples samples_of_faces(const Call& call, const Mesh& mesh) {
    Stage stage(call.report, HRBFNPR_STAGE_SAMPLE);
    InspectedSamples samples{Points(inspect_tuning.mesh_samples, glm::dvec3(0.0), &call.pool),
                             Points(inspect_tuning.mesh_samples, glm::dvec3(0.0), &call.pool)};
    const hrbfnpr_array_out to_points = room_in(samples.points);
    const hrbfnpr_array_out to_normals = room_in(samples.normals);
    picture::call([&](hrbfnpr_error* error) {
        return hrbfnpr_mesh_sample(mesh.get(), nullptr, &to_points, &to_normals, stage.operation(), error);
    });
    return samples;
}

InspectedSamples inspect_mesh(const Call& call, Shape& shape, hrbfnpr_source_info& info) {
    const MeshFacts facts = mesh_facts_of(shape, call.pool);
    copy_mesh_facts(facts, info);
    tell_faces_and_vertices(call, facts);
    const auto is_lost = [&](const Triangle& face) {
        return !std::all_of(face.begin(), face.end(), [&](std::int64_t corner) {
            return has_finite_place(shape.points[static_cast<std::size_t>(corner)]);
        });
    };
    shape.triangles.erase(std::remove_if(shape.triangles.begin(), shape.triangles.end(), is_lost),
                          shape.triangles.end());
    if (shape.triangles.empty()) call.report.refuse("every face has a corner that is not finite");
    tell_inside_out(call, facts);
    tell_open(call, facts);
    const RepairedMesh repaired = repair_mesh(call, shape);
    if (facts.nonmanifold_edges != 0) {
        std::optional<hrbfnpr_mesh_info> of_mended;
        if (repaired.mesh) of_mended = info_of(repaired.mesh);
        info.nonmanifold_left = of_mended ? of_mended->nonmanifold_edges : facts.nonmanifold_edges;
        tell_nonmanifold(call, facts.nonmanifold_edges, info.nonmanifold_left,
                         of_mended && of_mended->repeated_faces != 0);
    }
    tell_contrary_and_parts(call, facts);
    if (repaired.error) throw Error(*repaired.error);
    InspectedSamples samples = samples_of_faces(call, repaired.mesh);
    inspect_orientation(call, samples, true, info);
    return samples;
}

// ---- Sources of each kind

void inspect_shape(const Call& call, Shape& shape, hrbfnpr_source_info& info) {
    const bool is_image = shape.columns > 0 && !has_normals(shape);
    info.points = static_cast<std::int64_t>(shape.points.size());
    info.triangles = static_cast<std::int64_t>(shape.triangles.size());
    if (!is_image) leave_out_unused(call, shape, info);
    info.has_normals = has_normals(shape) ? 1 : 0;
    inspect_places(call, shape, info);
    const InspectedSamples samples = is_image          ? inspect_image(call, shape, info)
                                     : shape.is_mesh() ? inspect_mesh(call, shape, info)
                                                       : inspect_points(call, shape, info);
    const FoundUp up = find_up(&shape, samples.points, samples.normals, call.pool);
    copy_vector(up.direction, info.up);
    copy_message(info.up_reason, sizeof info.up_reason, up.reason.c_str());
}

void inspect_made(const Source& source, hrbfnpr_source_info& info) {
    if (source.model) {
        info.kind = HRBFNPR_SOURCE_KIND_MODEL;
        info.points = model_info_of(source.model).centres;
        copy_bounds(bounds_of(source.model), info);
    } else {
        info.kind = HRBFNPR_SOURCE_KIND_POINT_SET;
        info.points = mark_count_of(source.marks);
        copy_bounds(bounds_of(source.marks), info);
    }
}

std::uint32_t worst_of(const Vector<Note>& notes) noexcept {
    std::uint32_t worst = HRBFNPR_SEVERITY_INFO;
    for (const Note& note : notes) worst = std::max(worst, note.severity);
    return worst;
}

} // namespace

hrbfnpr_source_info inspect_source(hrbfnpr_context& context, Source&& source, Report& report) {
    hrbfnpr_source_info info{};
    if (source.shape) {
        const Options options(defaults<hrbfnpr_picture_desc>(hrbfnpr_picture_desc_init), nullptr, report.pool());
        info.kind = source.shape->is_mesh() ? HRBFNPR_SOURCE_KIND_MESH : HRBFNPR_SOURCE_KIND_POINTS;
        try {
            inspect_shape({context, options, report, report.pool()}, *source.shape, info);
        } catch (const Error& error) {
            if (!is_of_source(error)) throw;
            report.failure(HRBFNPR_NOTE_NOT_USABLE, error.what());
        }
    } else {
        inspect_made(source, info);
    }
    info.severity = worst_of(report.notes);
    return info;
}

} // namespace hrbfnpr::picture

using namespace hrbfnpr;

namespace hrbfnpr::api {

template <>
hrbfnpr_source_info defaults() noexcept {
    return {};
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_source_info_init(hrbfnpr_source_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_source_inspect(hrbfnpr_context* context, const hrbfnpr_picture_source* source, uint32_t wording,
                                      hrbfnpr_picture_event_fn on_event, void* event_user, hrbfnpr_operation* operation,
                                      hrbfnpr_source_info* info, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        hrbfnpr_context& handle = api::deref(context, "context");
        api::check_output_struct(info, "info");
        if (wording > HRBFNPR_WORDING_ARGUMENTS)
            fail(Status::invalid_argument, "wording is %u; it must be one of HRBFNPR_WORDING_* (0 to %d)", wording,
                 HRBFNPR_WORDING_ARGUMENTS);
        picture::Pool pool(handle.runtime.memory);
        picture::Source read = picture::read_source(source, pool);
        const api::OperationUse use(operation);
        picture::Report report(pool, wording, on_event, event_user, handle, operation);
        const hrbfnpr_source_info found = picture::inspect_source(handle, std::move(read), report);
        use.finish();
        api::write_struct(info, found);
    });
}

} // extern "C"
