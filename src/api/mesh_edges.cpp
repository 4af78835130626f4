// SPDX-License-Identifier: MIT
#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/mesh.h"
#include "api/operation.h"
#include "api/queries.h"
#include "base/clock.h"
#include "mesh/pieces/fit_as_planned.h"
#include "mesh/pieces/tangent_edges.h"

#include <optional>

using namespace hrbfnpr;

static_assert(static_cast<std::uint32_t>(mesh::Edges::sharp) == HRBFNPR_EDGES_SHARP);

namespace hrbfnpr::api {
namespace {

using MeshEdgesDesc = hrbfnpr_mesh_edges_desc;

constexpr auto mesh_edges_fields() noexcept {
    using mesh::FitMeshSettings;
    return FieldTable{
        field("edges", &MeshEdgesDesc::edges, &FitMeshSettings::edges,
              rule::OneOf{HRBFNPR_EDGES_SHARP, "HRBFNPR_EDGES_*"}),
        field("crease_angle", &MeshEdgesDesc::crease_angle, &FitMeshSettings::crease_angle, rule::Between{1.0, 179.0}),
        field("far", &MeshEdgesDesc::far, &FitMeshSettings::far, rule::not_negative),
        field("tangent", &MeshEdgesDesc::tangent, rule::OneOf{1, "0 or 1"}),
        reserved("reserved", &MeshEdgesDesc::reserved)};
}
static_assert(mesh_edges_fields().covers<MeshEdgesDesc>());

} // namespace

template <>
hrbfnpr_mesh_edges_desc defaults() noexcept {
    hrbfnpr_mesh_edges_desc desc{};
    mesh_edges_fields().set_defaults(mesh::FitMeshSettings{}, desc);
    return desc;
}

template <>
hrbfnpr_mesh_edges_info defaults() noexcept {
    return {};
}

namespace {

void write_sharp(const mesh::Mesh& mesh, const mesh::Creases& creases, const base::OutView& out) {
    for (const mesh::Crease& edge : creases.edge)
        for (const std::int32_t face : {edge.left, edge.right}) {
            const mesh::Triangle& t = mesh.triangle[face];
            const std::int32_t from = face == edge.left ? edge.from : edge.to;
            out.set(face, t[0] == from ? 0U : t[1] == from ? 1U : 2U, 1.0);
        }
}

void write_tangent(const base::Work& work, const mesh::Mesh& mesh, const std::optional<mesh::Creases>& creases,
                   const base::OutView& out) {
    const base::Array<std::uint8_t> none(work.memory);
    for (const std::int64_t side : mesh::find_tangent_edges(work, mesh, creases ? creases->cut : none))
        out.set(side / 3, static_cast<std::uint32_t>(side % 3), 2.0);
}

void find_edges(const hrbfnpr_mesh& handle, const MeshEdgesDesc& desc, const hrbfnpr_array_out* patch,
                const hrbfnpr_array_out* sharp, hrbfnpr_mesh_edges_info* info, hrbfnpr_operation* operation) {
    const base::Stopwatch watch;
    if (info != nullptr) check_output_struct(info, "mesh_edges_info");
    mesh_edges_fields().check("mesh_edges_desc", desc);
    const mesh::Mesh& mesh = handle.mesh;
    const base::OutView patches = out_view(patch, "patch", {1, index_types}, mesh.faces());
    const base::OutView sides = out_view(sharp, "sharp", {3, index_types}, mesh.faces());
    mesh::FitMeshSettings settings;
    mesh_edges_fields().copy(desc, settings);
    // The ratio of `far` to the tolerance is the same as in a fit with the default `far`.
    settings.tolerance = settings.far / 5.0;
    const OperationUse use(operation);
    const base::Work work(handle.runtime(), use.progress());
    const mesh::PlannedCreases plan = mesh::find_planned_creases(work, mesh, handle.tree, handle.creases, settings);
    for (std::int64_t face = 0; face < mesh.faces(); ++face) {
        if (patches) patches.set(face, 0, plan.creases ? static_cast<double>(plan.creases->patch[face]) : 0.0);
        for (std::uint32_t k = 0; k < 3 && sides; ++k) sides.set(face, k, 0.0);
    }
    if (sides && desc.tangent != 0) write_tangent(work, mesh, plan.creases, sides);
    if (sides && plan.creases) write_sharp(mesh, *plan.creases, sides);
    use.finish();
    if (info == nullptr) return;
    hrbfnpr_mesh_edges_info to{};
    to.patches = 1;
    to.doubtful = plan.doubtful * mesh.bounds.diagonal();
    if (plan.creases) {
        to.edges = plan.creases->edge.size();
        to.patches = plan.creases->patches;
        to.length = plan.creases->length;
        to.fading = plan.creases->fading;
    }
    to.seconds = watch.seconds();
    write_struct(info, to);
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_mesh_edges_desc_init(hrbfnpr_mesh_edges_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_mesh_edges_info_init(hrbfnpr_mesh_edges_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_mesh_edges(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_edges_desc* desc,
                                  const hrbfnpr_array_out* patch, const hrbfnpr_array_out* sharp,
                                  hrbfnpr_mesh_edges_info* info, hrbfnpr_operation* operation, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::find_edges(api::deref(mesh, "mesh"), api::read_optional_struct(desc, "mesh_edges_desc"), patch, sharp,
                        info, operation);
    });
}

} // extern "C"
