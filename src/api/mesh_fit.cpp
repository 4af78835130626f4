// SPDX-License-Identifier: MIT
#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/fit_options.h"
#include "api/mesh.h"
#include "api/model_trim.h"
#include "api/operation.h"
#include "mesh/pieces/fit_as_planned.h"

#include <memory>
#include <utility>

using namespace hrbfnpr;

static_assert(static_cast<std::uint32_t>(mesh::Edges::sharp) == HRBFNPR_EDGES_SHARP);

namespace hrbfnpr::api {
namespace {

using Compare = hrbfnpr_compare_desc;
using MeshFitDesc = hrbfnpr_mesh_fit_desc;

constexpr auto compare_fields() noexcept {
    using mesh::CompareSettings;
    return FieldTable{reserved("reserved", &Compare::reserved),
                      field("tolerance", &Compare::tolerance, &CompareSettings::tolerance, rule::not_negative),
                      field("far", &Compare::far, &CompareSettings::far, rule::not_negative),
                      field("support", &Compare::support, &CompareSettings::support, rule::not_negative),
                      field("points", &Compare::points, &CompareSettings::points, rule::Between{0.0, 1e7}),
                      field("cell_size", &Compare::cell_size, &CompareSettings::cell_size, rule::not_negative),
                      field("random_seed", &Compare::random_seed, &CompareSettings::seed, rule::Any{})};
}
static_assert(compare_fields().covers<Compare>());

constexpr auto mesh_fit_fields() noexcept {
    using mesh::FitMeshSettings;
    return FieldTable{
        reserved("reserved", &MeshFitDesc::reserved),
        field("tolerance", &MeshFitDesc::tolerance, &FitMeshSettings::tolerance, rule::not_negative),
        field("share", &MeshFitDesc::share, &FitMeshSettings::share, rule::PositiveUpTo{1.0}),
        field("far", &MeshFitDesc::far, &FitMeshSettings::far, rule::not_negative),
        field("maximum_centres", &MeshFitDesc::maximum_centres, &FitMeshSettings::maximum_centres,
              rule::Between{16.0, 1e6}),
        field("candidates", &MeshFitDesc::candidates, &FitMeshSettings::candidates, rule::Between{0.0, 1e7}),
        field("random_seed", &MeshFitDesc::random_seed, &FitMeshSettings::seed, rule::Any{}),
        field("crease_angle", &MeshFitDesc::crease_angle, &FitMeshSettings::crease_angle, rule::Between{5.0, 175.0}),
        field("edges", &MeshFitDesc::edges, &FitMeshSettings::edges,
              rule::OneOf{HRBFNPR_EDGES_SHARP, "HRBFNPR_EDGES_*"}),
        reserved("reserved2", &MeshFitDesc::reserved2)};
}
static_assert(mesh_fit_fields().covers<MeshFitDesc>());

} // namespace

template <>
hrbfnpr_compare_desc defaults() noexcept {
    hrbfnpr_compare_desc desc{};
    compare_fields().set_defaults(mesh::CompareSettings{}, desc);
    return desc;
}

template <>
hrbfnpr_comparison defaults() noexcept {
    return {};
}

template <>
hrbfnpr_mesh_fit_desc defaults() noexcept {
    hrbfnpr_mesh_fit_desc desc{};
    mesh_fit_fields().set_defaults(mesh::FitMeshSettings{}, desc);
    return desc;
}

template <>
hrbfnpr_mesh_fit_info defaults() noexcept {
    return {};
}

namespace {

constexpr double evaluations_of_a_comparison = 5e5;
constexpr double smallest_tolerance = 1e-6; // The smallest tolerance, in diagonals.
constexpr double smallest_cell = 1e-3;
constexpr double end_of_mesh_fit = 0.95; // The share of the progress at which the fit ends and the trim begins.
constexpr std::int64_t fewest_points = 100;
constexpr std::int64_t fewest_candidates = 1000;

void check_fewest(const char* owner, const char* name, std::int64_t value, std::int64_t fewest) {
    if (value != 0 && value < fewest)
        fail(Status::invalid_argument, "%s.%s is %lld; it must be 0 (automatic) or at least %lld", owner, name,
             static_cast<long long>(value), static_cast<long long>(fewest));
}

void check_smallest(const char* owner, const char* name, double value, double smallest) {
    if (value != 0.0 && value < smallest)
        fail(Status::invalid_argument, "%s.%s is %g; it must be 0 (automatic) or at least %g", owner, name, value,
             smallest);
}

// Returns the support of the model's samples, or null if `limit` is 0.
std::unique_ptr<surface::Support> support_of(const hrbfnpr_model& model, double limit, const base::Progress& progress) {
    if (!(limit > 0.0)) return nullptr;
    const std::span<const double> p = model.samples().position;
    const std::span<const double> n = model.sample_normals();
    if (p.empty())
        fail(Status::invalid_argument, "compare_desc.support is %g, but a custom model has no samples; set it to 0",
             limit);
    geometry::VecArray position(model.runtime().memory);
    geometry::VecArray normal(model.runtime().memory);
    for (std::size_t i = 0; i < p.size(); i += 3) {
        position.push_back({p[i], p[i + 1], p[i + 2]});
        normal.push_back({n[i], n[i + 1], n[i + 2]});
    }
    return std::make_unique<surface::Support>(base::Work(model.runtime(), progress), position, normal, 0.0);
}

hrbfnpr_comparison described(const mesh::Comparison& result) noexcept {
    hrbfnpr_comparison to{};
    to.surface_points = result.surface.points;
    to.surface_mean = result.surface.mean;
    to.surface_p99 = result.surface.p99;
    to.surface_max = result.surface.most;
    to.surface_share = result.surface.share;
    to.invented_share = result.surface.beyond;
    to.left_out_share = result.left_out;
    to.mesh_points = result.mesh.points;
    to.mesh_mean = result.mesh.mean;
    to.mesh_p99 = result.mesh.p99;
    to.mesh_max = result.mesh.most;
    to.mesh_share = result.mesh.share;
    to.missed_share = result.mesh.beyond;
    to.normal_mean = result.normal_mean;
    to.normal_p99 = result.normal_p99;
    to.components = result.components;
    to.genus = result.genus;
    to.tolerance = result.tolerance;
    to.diagonal = result.diagonal;
    to.seconds = result.seconds;
    return to;
}

void compare(const hrbfnpr_model& model, const hrbfnpr_mesh& mesh, const Compare& desc, hrbfnpr_comparison* out,
             hrbfnpr_operation* operation) {
    check_output_struct(out, "comparison");
    compare_fields().check("compare_desc", desc);
    check_fewest("compare_desc", "points", desc.points, fewest_points);
    check_smallest("compare_desc", "cell_size", desc.cell_size, smallest_cell * mesh.mesh.bounds.diagonal());
    mesh::CompareSettings settings;
    compare_fields().copy(desc, settings);
    const OperationUse use(operation);
    const std::unique_ptr<surface::Support> support = support_of(model, desc.support, use.progress());
    const implicit::Implicit& implicit = model.implicit_for(evaluations_of_a_comparison, use.progress());
    const mesh::Comparison result =
        mesh::compare({model.runtime(), use.progress()}, implicit, mesh.mesh, mesh.tree, support.get(), settings);
    use.finish();
    write_struct(out, described(result));
}

hrbfnpr_mesh_fit_info described(const mesh::PlannedFit& made) noexcept {
    const mesh::FitMeshReport& report = made.report;
    hrbfnpr_mesh_fit_info to{};
    to.sheets = 1;
    if (made.pieces) {
        const mesh::SheetTreeReport& pieces = made.pieces->pieces;
        to.sheets = pieces.sheets;
        to.crease_length = pieces.crease_length;
        to.smooth_length = pieces.smooth_length;
        to.cells = pieces.cells;
        to.poor_cells = pieces.poor_cells;
    }
    to.reached = report.reached ? 1 : 0;
    to.tolerance = report.tolerance;
    to.far = report.far;
    to.candidates = report.candidates;
    to.centres = made.centres;
    to.off_surface_centres = report.off_surface;
    to.rounds = report.rounds;
    to.supported = report.supported ? 1 : 0;
    to.surface_share = report.surface.share;
    to.surface_p99 = report.surface.p99;
    to.surface_max = report.surface.most;
    to.mesh_share = report.mesh.share;
    to.mesh_p99 = report.mesh.p99;
    to.mesh_max = report.mesh.most;
    to.seconds_sample = report.seconds_sample;
    to.seconds_fit = report.seconds_fit;
    to.seconds_measure = report.seconds_measure;
    to.seconds_total = report.seconds_total;
    to.touching_parts[0] = report.contact.one;
    to.touching_parts[1] = report.contact.other;
    for (int axis = 0; axis < 3; ++axis) to.touching_place[axis] = report.contact.place[axis];
    to.parts_may_cross = report.contact.may_cross ? 1 : 0;
    return to;
}

mesh::FitMeshSettings checked_settings(const MeshFitDesc& desc, const mesh::Mesh& mesh) {
    mesh_fit_fields().check("mesh_fit_desc", desc);
    check_fewest("mesh_fit_desc", "candidates", desc.candidates, fewest_candidates);
    check_smallest("mesh_fit_desc", "tolerance", desc.tolerance, smallest_tolerance * mesh.bounds.diagonal());
    if (desc.far != 0.0 && desc.far < desc.tolerance)
        fail(Status::invalid_argument,
             "mesh_fit_desc.far is %g; it must be 0 (automatic) or at least the tolerance, %g", desc.far,
             desc.tolerance);
    mesh::FitMeshSettings settings;
    mesh_fit_fields().copy(desc, settings);
    return settings;
}

hrbfnpr_model* fit_mesh(const hrbfnpr_mesh& mesh, const MeshFitDesc& desc, const hrbfnpr_fit_desc& fit,
                        hrbfnpr_mesh_fit_info* info, hrbfnpr_operation* operation) {
    if (info != nullptr) check_output_struct(info, "mesh_fit_info");
    const mesh::FitMeshSettings settings = checked_settings(desc, mesh.mesh);
    const fit::FitInput options = checked_options(fit);
    const OperationUse use(operation);
    mesh::PlannedFit made =
        mesh::fit_as_planned({mesh.runtime(), use.progress().part(0.0, end_of_mesh_fit)}, mesh.mesh, mesh.tree,
                             mesh.creases, settings, options, fit.trim != HRBFNPR_TRIM_NEVER);
    const hrbfnpr_mesh_fit_info to = described(made);
    const bool ends = made.end.end != mesh::End::nowhere;
    const base::Progress rest = use.progress().part(end_of_mesh_fit, 1.0);
    if (!ends) rest.update(1.0);
    hrbfnpr_model* model =
        made.smooth ? make_handle<hrbfnpr_model>(mesh.context(), std::move(*made.smooth))
                    : make_handle<hrbfnpr_model>(mesh.context(), std::move(made.pieces->data), made.pieces->fit);
    if (ends) {
        generate::TrimSettings end;
        end.hole = end.closest = made.end.off;
        model = ended_model(model, made.end_place, made.end_normal, end, rest);
    }
    if (info != nullptr) write_struct(info, to);
    return model;
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_compare_desc_init(hrbfnpr_compare_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_comparison_init(hrbfnpr_comparison* comparison, uint32_t struct_size) {
    return api::init_struct(comparison, struct_size);
}

hrbfnpr_status hrbfnpr_model_compare_mesh(const hrbfnpr_model* model, const hrbfnpr_mesh* mesh,
                                          const hrbfnpr_compare_desc* desc, hrbfnpr_comparison* comparison,
                                          hrbfnpr_operation* operation, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::compare(api::deref(model, "model"), api::deref(mesh, "mesh"),
                     api::read_optional_struct(desc, "compare_desc"), comparison, operation);
    });
}

hrbfnpr_status hrbfnpr_mesh_fit_desc_init(hrbfnpr_mesh_fit_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_mesh_fit_info_init(hrbfnpr_mesh_fit_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_model_fit_mesh(const hrbfnpr_mesh* mesh, const hrbfnpr_mesh_fit_desc* desc,
                                      const hrbfnpr_fit_desc* fit, hrbfnpr_mesh_fit_info* info,
                                      hrbfnpr_operation* operation, hrbfnpr_model** out_model, hrbfnpr_error* error) {
    return api::guarded_create(out_model, "out_model", error, [&] {
        return api::fit_mesh(api::deref(mesh, "mesh"), api::read_optional_struct(desc, "mesh_fit_desc"),
                             api::read_optional_struct(fit, "fit_desc"), info, operation);
    });
}

} // extern "C"
