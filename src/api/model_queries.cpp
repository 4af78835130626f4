// SPDX-License-Identifier: MIT
// Evaluates many points, projects them, and computes curvatures.
#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/model.h"
#include "api/operation.h"
#include "api/queries.h"
#include "implicit/evaluate_all.h"
#include "surface/curvature.h"
#include "surface/project.h"

using namespace hrbfnpr;

static_assert(static_cast<int>(surface::ProjectionStatus::converged) == HRBFNPR_PROJECTION_CONVERGED);
static_assert(static_cast<int>(surface::ProjectionStatus::not_converged) == HRBFNPR_PROJECTION_NOT_CONVERGED);
static_assert(static_cast<int>(surface::ProjectionStatus::zero_gradient) == HRBFNPR_PROJECTION_ZERO_GRADIENT);
static_assert(static_cast<int>(surface::ProjectionStatus::not_finite) == HRBFNPR_PROJECTION_NOT_FINITE);

namespace hrbfnpr::api {

namespace {

using Project = hrbfnpr_project_desc;
using surface::ProjectionSettings;

constexpr auto project_fields() noexcept {
    return FieldTable{field("evaluation_limit", &Project::evaluation_limit, &ProjectionSettings::evaluation_limit,
                            rule::Between{1.0, 1000.0}),
                      field("tolerance", &Project::tolerance, &ProjectionSettings::tolerance, rule::Positive{}),
                      field("armijo_slope", &Project::armijo_slope, &ProjectionSettings::armijo_slope,
                            rule::StrictlyBetween{0.0, 0.5}),
                      field("armijo_factor", &Project::armijo_factor, &ProjectionSettings::armijo_factor,
                            rule::StrictlyBetween{0.0, 1.0})};
}
static_assert(project_fields().covers<Project>());

} // namespace

template <>
hrbfnpr_project_desc defaults() noexcept {
    hrbfnpr_project_desc desc{};
    project_fields().set_defaults(ProjectionSettings{}, desc);
    return desc;
}

template <>
hrbfnpr_projection defaults() noexcept {
    return {};
}

template <>
hrbfnpr_curvature defaults() noexcept {
    return {};
}

namespace {

// The time for a Hessian and a gradient, relative to the time for a value and a gradient.
constexpr double hessian_cost = 2.5;

constexpr std::int64_t block_size = 262144;
struct FieldOutputs {
    base::OutView value, gradient, hessian;
};

// The results for one block of points, as a structure of arrays.
class FieldBlock {
public:
    FieldBlock(base::Memory& memory, const FieldOutputs& out, std::int64_t size)
        : out_(out), value_(memory, out.value ? size : 0), gradient_(memory, out.gradient ? 3 * size : 0),
          hessian_(memory, out.hessian ? 6 * size : 0) {
        if (out.value) fields_.value = value_.data();
        if (out.gradient)
            for (int c = 0; c < 3; ++c) fields_.gradient[static_cast<std::size_t>(c)] = gradient_.data() + c * size;
        if (out.hessian)
            for (int c = 0; c < 6; ++c) fields_.hessian[static_cast<std::size_t>(c)] = hessian_.data() + c * size;
    }

    [[nodiscard]] const implicit::FieldBatch& fields() const noexcept { return fields_; }

    // Writes the elements `from` to `to` - 1 of the block. Element i of the block is element first + i of the outputs.
    void write(std::int64_t from, std::int64_t to, std::int64_t first) const {
        const CheckedOutput value("value");
        const CheckedOutput gradient("gradient");
        const CheckedOutput hessian("hessian");
        for (std::int64_t i = from; i < to; ++i) {
            if (out_.value) value.set(out_.value, first + i, 0, fields_.value[i]);
            for (std::uint32_t c = 0; out_.gradient && c < 3; ++c)
                gradient.set(out_.gradient, first + i, c, fields_.gradient[c][i]);
            for (std::uint32_t c = 0; out_.hessian && c < 6; ++c)
                hessian.set(out_.hessian, first + i, c, fields_.hessian[c][i]);
        }
    }

private:
    FieldOutputs out_;
    base::Array<double> value_, gradient_, hessian_;
    implicit::FieldBatch fields_;
};

void evaluate(const hrbfnpr_model& model, const Queries& queries, const FieldOutputs& out,
              const base::Progress& progress) {
    const base::Runtime& runtime = model.runtime();
    const double cost = out.hessian ? hessian_cost : 1.0;
    const implicit::Implicit& implicit = model.implicit_for(cost * static_cast<double>(queries.count()), progress);
    geometry::VecArray points(runtime.memory);
    FieldBlock block(runtime.memory, out, std::min(queries.count(), block_size));
    for_blocks(
        queries.count(), block_size, progress, [&](std::int64_t begin, std::int64_t end, const base::Progress& part) {
            queries.read(begin, end, points);
            implicit::evaluate_all({runtime, part}, implicit, points, block.fields());
            runtime.parallel.for_chunks(end - begin, 4096, part,
                                        [&](std::int64_t from, std::int64_t to) { block.write(from, to, begin); });
        });
}

ProjectionSettings checked(const hrbfnpr_project_desc& desc) {
    project_fields().check("project_desc", desc);
    ProjectionSettings settings;
    project_fields().copy(desc, settings);
    return settings;
}

struct ProjectionOutputs {
    ProjectionOutputs(const hrbfnpr_projection& given, std::int64_t count)
        : position(out_view(&given.position, "projection.position", points_type, count)),
          normal(out_view(&given.normal, "projection.normal", points_type, count)),
          status(out_view(&given.status, "projection.status", {1, uint8_or_uint32}, count)) {
        Checks("projection").zero("reserved", given.reserved);
    }
    base::OutView position, normal, status;
};

// Writes the projections of a block. Returns the number of points that converged.
std::int64_t write(const surface::Projection& block, const ProjectionOutputs& out, std::int64_t first,
                   const base::Progress& progress) {
    std::int64_t converged = 0;
    for (const std::int64_t i : progress.over(block.status.size())) {
        const glm::dvec3 gradient = block.gradient[i];
        const double length = glm::length(gradient);
        const bool has_normal = std::isfinite(length) && length > 0.0;
        if (out.position) CheckedOutput("projection.position").set(out.position, first + i, block.position[i]);
        if (out.normal) set_vector(out.normal, first + i, has_normal ? gradient / length : glm::dvec3(0.0));
        if (out.status) out.status.set(first + i, 0, static_cast<double>(block.status[i]));
        converged += block.status[i] == surface::ProjectionStatus::converged ? 1 : 0;
    }
    return converged;
}

std::int64_t project(const hrbfnpr_model& model, const Queries& queries, const surface::ProjectionSettings& settings,
                     const ProjectionOutputs& out, const base::Progress& progress) {
    constexpr double evaluations_each = 3.0;
    const implicit::Implicit& implicit =
        model.implicit_for(evaluations_each * static_cast<double>(queries.count()), progress);
    surface::Projection block(model.runtime().memory);
    std::int64_t converged = 0;
    for_blocks(queries.count(), block_size, progress,
               [&](std::int64_t begin, std::int64_t end, const base::Progress& part) {
                   queries.read(begin, end, block.position);
                   surface::project({model.runtime(), part}, implicit, settings, block);
                   converged += write(block, out, begin, part);
               });
    return converged;
}

struct CurvatureOutputs {
    CurvatureOutputs(const hrbfnpr_curvature& given, std::int64_t count)
        : k1(out_view(&given.k1, "curvature.k1", number_type, count)),
          k2(out_view(&given.k2, "curvature.k2", number_type, count)),
          d1(out_view(&given.d1, "curvature.d1", points_type, count)),
          d2(out_view(&given.d2, "curvature.d2", points_type, count)),
          confidence(out_view(&given.confidence, "curvature.confidence", number_type, count)) {
        Checks("curvature").zero("reserved", given.reserved);
    }
    base::OutView k1, k2, d1, d2, confidence;
};

void write(const base::Array<surface::Curvature>& block, const CurvatureOutputs& out, std::int64_t first,
           const base::Progress& progress) {
    for (const std::int64_t i : progress.over(block.size())) {
        const surface::Curvature& c = block[i];
        if (out.k1) CheckedOutput("curvature.k1").set(out.k1, first + i, 0, c.k1);
        if (out.k2) CheckedOutput("curvature.k2").set(out.k2, first + i, 0, c.k2);
        if (out.d1) set_vector(out.d1, first + i, c.d1);
        if (out.d2) set_vector(out.d2, first + i, c.d2);
        if (out.confidence) out.confidence.set(first + i, 0, c.confidence);
    }
}

void curvature(const hrbfnpr_model& model, const Queries& queries, const CurvatureOutputs& out,
               const base::Progress& progress) {
    const implicit::Implicit& implicit =
        model.implicit_for(hessian_cost * static_cast<double>(queries.count()), progress);
    geometry::VecArray points(model.runtime().memory);
    base::Array<surface::Curvature> block(model.runtime().memory);
    for_blocks(queries.count(), block_size, progress,
               [&](std::int64_t begin, std::int64_t end, const base::Progress& part) {
                   queries.read(begin, end, points);
                   surface::principal_curvatures({model.runtime(), part}, implicit, points, block);
                   write(block, out, begin, part);
               });
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_model_evaluate(const hrbfnpr_model* model, const hrbfnpr_array* points,
                                      const hrbfnpr_array_out* value, const hrbfnpr_array_out* gradient,
                                      const hrbfnpr_array_out* hessian, hrbfnpr_operation* operation,
                                      hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        const api::Queries queries(handle.runtime(), points, "points");
        const std::int64_t count = queries.count();
        const api::FieldOutputs out{api::out_view(value, "value", api::number_type, count),
                                    api::out_view(gradient, "gradient", api::points_type, count),
                                    api::out_view(hessian, "hessian", {6, api::float_types}, count)};
        queries.check_near(handle.implicit());
        const api::OperationUse use(operation);
        api::evaluate(handle, queries, out, use.progress());
        use.finish();
    });
}

hrbfnpr_status hrbfnpr_project_desc_init(hrbfnpr_project_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_projection_init(hrbfnpr_projection* projection, uint32_t struct_size) {
    return api::init_struct(projection, struct_size);
}

hrbfnpr_status hrbfnpr_model_project(const hrbfnpr_model* model, const hrbfnpr_array* points,
                                     const hrbfnpr_project_desc* desc, hrbfnpr_projection* projection,
                                     hrbfnpr_operation* operation, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        const surface::ProjectionSettings settings = api::checked(api::read_optional_struct(desc, "project_desc"));
        const api::Queries queries(handle.runtime(), points, "points");
        const api::ProjectionOutputs out(api::read_struct(projection, "projection"), queries.count());
        queries.check_near(handle.implicit());
        const api::OperationUse use(operation);
        const std::int64_t converged = api::project(handle, queries, settings, out, use.progress());
        use.finish();
        api::write_number(projection, &hrbfnpr_projection::converged, converged);
    });
}

hrbfnpr_status hrbfnpr_curvature_init(hrbfnpr_curvature* curvature, uint32_t struct_size) {
    return api::init_struct(curvature, struct_size);
}

hrbfnpr_status hrbfnpr_model_curvature(const hrbfnpr_model* model, const hrbfnpr_array* points,
                                       hrbfnpr_curvature* curvature, hrbfnpr_operation* operation,
                                       hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        const api::Queries queries(handle.runtime(), points, "points");
        const api::CurvatureOutputs out(api::read_struct(curvature, "curvature"), queries.count());
        queries.check_near(handle.implicit());
        const api::OperationUse use(operation);
        api::curvature(handle, queries, out, use.progress());
        use.finish();
    });
}

} // extern "C"
