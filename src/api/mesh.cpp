// SPDX-License-Identifier: MIT
#include "api/mesh.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/operation.h"
#include "api/queries.h"
#include "api/views.h"
#include "geometry/farthest_order.h"
#include "mesh/sample.h"

#include <cmath>

using namespace hrbfnpr;

static_assert(static_cast<std::uint32_t>(mesh::Parts::largest) == HRBFNPR_PARTS_LARGEST);
static_assert(static_cast<std::uint32_t>(mesh::Faces::keep) == HRBFNPR_FACES_KEEP);

namespace hrbfnpr::api {
namespace {

using MeshDesc = hrbfnpr_mesh_desc;

constexpr std::int64_t candidates_a_sample = 40;
constexpr std::int64_t most_candidates = 1'000'000;
constexpr double most_samples = 1e7;
constexpr double largest_point = 1e100;
constexpr std::int64_t grain = 4096;

constexpr auto mesh_fields() noexcept {
    using mesh::MeshInput;
    return FieldTable{
        field("parts", &MeshDesc::parts, &MeshInput::parts, rule::OneOf{HRBFNPR_PARTS_AUTO, "HRBFNPR_PARTS_*"}),
        field("vertices", &MeshDesc::vertices, rule::Any{}),
        field("triangles", &MeshDesc::triangles, rule::Any{}),
        field("crease_angle", &MeshDesc::crease_angle, &MeshInput::crease_angle, rule::Between{0.0, 180.0}),
        field("faces", &MeshDesc::faces, &MeshInput::faces, rule::OneOf{HRBFNPR_FACES_KEEP, "HRBFNPR_FACES_*"}),
        reserved("reserved", &MeshDesc::reserved)};
}
static_assert(mesh_fields().covers<MeshDesc>());

struct SampleSettings {
    std::int64_t candidates = 0;
    std::uint64_t seed = 1;
};

constexpr auto sample_fields() noexcept {
    return FieldTable{reserved("reserved", &hrbfnpr_sample_desc::reserved),
                      field("candidates", &hrbfnpr_sample_desc::candidates, &SampleSettings::candidates,
                            rule::Between{0.0, static_cast<double>(most_candidates)}),
                      field("random_seed", &hrbfnpr_sample_desc::random_seed, &SampleSettings::seed, rule::Any{})};
}
static_assert(sample_fields().covers<hrbfnpr_sample_desc>());

} // namespace

template <>
hrbfnpr_mesh_desc defaults() noexcept {
    hrbfnpr_mesh_desc desc{};
    mesh_fields().set_defaults(mesh::MeshInput{}, desc);
    return desc;
}

template <>
hrbfnpr_mesh_info defaults() noexcept {
    return {};
}

template <>
hrbfnpr_sample_desc defaults() noexcept {
    hrbfnpr_sample_desc desc{};
    sample_fields().set_defaults(SampleSettings{}, desc);
    return desc;
}

namespace {

void check_number(const char* name, std::int64_t count, std::int64_t limit) {
    if (count == 0) fail(Status::invalid_argument, "mesh_desc.%s is empty; give at least one face", name);
    if (count >= limit)
        fail(Status::invalid_argument, "mesh_desc.%s has %lld elements; there must be fewer than %lld", name,
             static_cast<long long>(count), static_cast<long long>(limit));
}

void log_mesh(const base::Runtime& runtime, const mesh::MeshReport& report) {
    const auto say = [&](std::int64_t count, const char* what) {
        if (count > 0) runtime.log(base::LogLevel::warning, "mesh: %lld %s", static_cast<long long>(count), what);
    };
    say(report.degenerate_faces, "faces have no area and were left out");
    say(report.repeated_faces, "faces repeat others and were left out");
    say(report.turned_faces, "faces were turned to agree with their neighbours");
    say(report.turned_components, "components were inside out and were turned");
    say(report.left_out_components, "components were left out, because they lie inside others or were not asked for");
    say(report.nonmanifold_edges, "edges have more than two faces");
    say(report.contrary_edges, "edges have two faces of opposite orientation");
}

hrbfnpr_mesh* create(hrbfnpr_context& context, const hrbfnpr_mesh_desc& desc, hrbfnpr_operation* operation) {
    mesh::MeshInput input;
    input.vertices = in_view(desc.vertices, "mesh_desc.vertices", points_type);
    check_number("vertices", input.vertices.count, mesh::most_vertices);
    input.triangles = in_view(desc.triangles, "mesh_desc.triangles", {3, index_types});
    check_number("triangles", input.triangles.count, mesh::most_faces);
    mesh_fields().check("mesh_desc", desc);
    mesh_fields().copy(desc, input);
    const OperationUse use(operation);
    mesh::Mesh made = mesh::make_mesh({context.runtime, use.progress().part(0.0, 0.9)}, input);
    log_mesh(context.runtime, made.report);
    return use.finish_with(make_handle<hrbfnpr_mesh>(context, std::move(made), use.progress().part(0.9, 1.0)));
}

hrbfnpr_mesh_info describe(const hrbfnpr_mesh& handle) noexcept {
    const mesh::MeshReport& report = handle.mesh.report;
    hrbfnpr_mesh_info info{};
    info.closed = report.closed ? 1 : 0;
    info.given_vertices = report.given_vertices;
    info.given_faces = report.given_faces;
    info.vertices = handle.mesh.vertex.size();
    info.faces = handle.mesh.faces();
    info.welded_vertices = report.welded_vertices;
    info.degenerate_faces = report.degenerate_faces;
    info.repeated_faces = report.repeated_faces;
    info.turned_faces = report.turned_faces;
    info.components = report.components;
    info.turned_components = report.turned_components;
    info.nested_components = report.nested_components;
    info.left_out_components = report.left_out_components;
    info.cavities = static_cast<std::uint32_t>(report.cavities);
    info.left_out_faces = report.left_out_faces;
    info.boundary_edges = report.boundary_edges;
    info.boundary_loops = report.boundary_loops;
    info.nonmanifold_edges = report.nonmanifold_edges;
    info.contrary_edges = report.contrary_edges;
    info.euler_characteristic = report.euler_characteristic;
    info.genus = report.genus;
    info.area = report.area;
    info.volume = report.volume;
    for (int axis = 0; axis < 3; ++axis) {
        info.bounds_min[axis] = handle.mesh.bounds.min[axis];
        info.bounds_max[axis] = handle.mesh.bounds.max[axis];
    }
    info.seconds = report.seconds;
    info.bytes = static_cast<std::int64_t>(sizeof(hrbfnpr_mesh)) + handle.mesh.bytes() + handle.tree.bytes();
    info.crease_length = handle.creases.length;
    info.creases = handle.creases.creases ? 1 : 0;
    return info;
}

hrbfnpr_array view_of(const mesh::Mesh& mesh, std::uint32_t attribute) {
    const std::int64_t faces = mesh.faces();
    switch (attribute) {
    case HRBFNPR_MESH_ATTRIBUTE_VERTEX:
        return {mesh.vertex.data(), mesh.vertex.size(), sizeof(glm::dvec3), HRBFNPR_SCALAR_FLOAT64, 3};
    case HRBFNPR_MESH_ATTRIBUTE_TRIANGLE:
        return {mesh.triangle.data(), faces, sizeof(mesh::Triangle), HRBFNPR_SCALAR_INT32, 3};
    case HRBFNPR_MESH_ATTRIBUTE_COMPONENT:
        return {mesh.component.data(), faces, sizeof(std::int32_t), HRBFNPR_SCALAR_INT32, 1};
    case HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE:
        return {mesh.given_face.data(), faces, sizeof(std::int32_t), HRBFNPR_SCALAR_INT32, 1};
    case HRBFNPR_MESH_ATTRIBUTE_CORNER_NORMAL:
        return {mesh.corner_normal.data(), faces, 3 * sizeof(glm::dvec3), HRBFNPR_SCALAR_FLOAT64, 9};
    default:
        fail(Status::invalid_argument, "attribute is %u; it must be one of HRBFNPR_MESH_ATTRIBUTE_* (0 to 4)",
             attribute);
    }
}

void sample(const hrbfnpr_mesh& handle, const hrbfnpr_sample_desc& desc, const hrbfnpr_array_out* points,
            const hrbfnpr_array_out* normals, hrbfnpr_operation* operation) {
    require_pointer(points, "points");
    sample_fields().check("sample_desc", desc);
    SampleSettings settings;
    sample_fields().copy(desc, settings);
    const std::int64_t count = points->count;
    if (count < 1 || static_cast<double>(count) > most_samples)
        fail(Status::invalid_argument, "points.count is %lld; it must be from 1 to 10000000",
             static_cast<long long>(count));
    const base::OutView position = out_view(points, "points", points_type, count);
    const base::OutView normal = out_view(normals, "normals", points_type, count);
    const std::int64_t candidates =
        settings.candidates > 0 ? settings.candidates : std::min(candidates_a_sample * count, most_candidates);
    const OperationUse use(operation);
    const base::Runtime& runtime = handle.runtime();
    const mesh::MeshSamples samples =
        mesh::even_samples({runtime, use.progress()}, handle.mesh, count, candidates, settings.seed);
    use.finish();
    check_fits(samples.position, position, "points");
    write_vectors(runtime, samples.position, position);
    write_vectors(runtime, samples.normal, normal);
}

geometry::VecArray read_points(const base::Runtime& runtime, const base::InView& view) {
    geometry::VecArray points(runtime.memory);
    points.x.resize_for_overwrite(view.count);
    points.y.resize_for_overwrite(view.count);
    points.z.resize_for_overwrite(view.count);
    runtime.parallel.for_chunks(view.count, grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const glm::dvec3 p{view.get(i, 0), view.get(i, 1), view.get(i, 2)};
            for (glm::length_t c = 0; c < 3; ++c)
                if (!(std::abs(p[c]) <= largest_point))
                    fail(Status::invalid_argument,
                         "points[%lld] has the coordinate %g; coordinates must be finite and at most 1e100; remove the "
                         "point or use a larger unit",
                         static_cast<long long>(i), p[c]);
            points.set(i, p);
        }
    });
    return points;
}

void farthest_points(hrbfnpr_context& context, const hrbfnpr_array& points, const hrbfnpr_array_out* indices,
                     const hrbfnpr_array_out* distance, hrbfnpr_operation* operation) {
    require_pointer(indices, "indices");
    const base::InView view = in_view(points, "points", points_type);
    const std::int64_t count = indices->count;
    if (count < 1 || count > view.count)
        fail(Status::invalid_argument, "indices.count is %lld; it must be from 1 to the number of points, %lld",
             static_cast<long long>(count), static_cast<long long>(view.count));
    const base::OutView index = out_view(indices, "indices", {1, index_types}, count);
    if (index.scalar != base::Scalar::int64 && view.count > std::int64_t{1} << 31U)
        fail(Status::invalid_argument, "indices.scalar must be HRBFNPR_SCALAR_INT64, because there are %lld points",
             static_cast<long long>(view.count));
    const base::OutView apart = out_view(distance, "distance", number_type, count);
    const OperationUse use(operation);
    const geometry::VecArray places = read_points(context.runtime, view);
    const geometry::FarthestOrder order = geometry::farthest_order(places, count, use.progress());
    use.finish();
    for (std::int64_t k = 0; k < count && apart; ++k) check_fits(order.distance[k], k, apart, "distance");
    for (std::int64_t k = 0; k < count; ++k) {
        index.set(k, 0, static_cast<double>(order.order[k]));
        if (apart) apart.set(k, 0, order.distance[k]);
    }
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_mesh_desc_init(hrbfnpr_mesh_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_mesh_create(hrbfnpr_context* context, const hrbfnpr_mesh_desc* desc,
                                   hrbfnpr_operation* operation, hrbfnpr_mesh** out_mesh, hrbfnpr_error* error) {
    return api::guarded_create(out_mesh, "out_mesh", error, [&] {
        return api::create(api::deref(context, "context"), api::read_struct(desc, "mesh_desc"), operation);
    });
}

void hrbfnpr_mesh_retain(const hrbfnpr_mesh* mesh) {
    if (mesh != nullptr) mesh->add_reference();
}

void hrbfnpr_mesh_release(const hrbfnpr_mesh* mesh) { api::release_handle(mesh); }

hrbfnpr_status hrbfnpr_mesh_info_init(hrbfnpr_mesh_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_mesh_get_info(const hrbfnpr_mesh* mesh, hrbfnpr_mesh_info* info, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(mesh, "mesh");
        api::check_output_struct(info, "mesh_info");
        api::write_struct(info, api::describe(handle));
    });
}

hrbfnpr_status hrbfnpr_mesh_view(const hrbfnpr_mesh* mesh, uint32_t attribute, hrbfnpr_array* out_view,
                                 hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(mesh, "mesh");
        api::require_pointer(out_view, "out_view");
        *out_view = api::view_of(handle.mesh, attribute);
    });
}

hrbfnpr_status hrbfnpr_sample_desc_init(hrbfnpr_sample_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_mesh_sample(const hrbfnpr_mesh* mesh, const hrbfnpr_sample_desc* desc,
                                   const hrbfnpr_array_out* points, const hrbfnpr_array_out* normals,
                                   hrbfnpr_operation* operation, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::sample(api::deref(mesh, "mesh"), api::read_optional_struct(desc, "sample_desc"), points, normals,
                    operation);
    });
}

hrbfnpr_status hrbfnpr_farthest_points(hrbfnpr_context* context, const hrbfnpr_array* points,
                                       const hrbfnpr_array_out* indices, const hrbfnpr_array_out* distance,
                                       hrbfnpr_operation* operation, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::farthest_points(api::deref(context, "context"), api::deref(points, "points"), indices, distance,
                             operation);
    });
}

} // extern "C"
