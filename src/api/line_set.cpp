// SPDX-License-Identifier: MIT
#include "api/line_set.h"

#include "api/barrier.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/lists.h"
#include "api/mesh.h"
#include "api/operation.h"
#include "api/views.h"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

using namespace hrbfnpr;

namespace hrbfnpr::api {

template <>
hrbfnpr_line_set_desc defaults() noexcept {
    return {};
}

template <>
hrbfnpr_line_desc defaults() noexcept {
    hrbfnpr_line_desc desc{};
    desc.kind = HRBFNPR_LINE_KIND_RIDGE;
    desc.shortest = 0.01;
    desc.plane[2] = 1.0;
    return desc;
}

template <>
hrbfnpr_line_set_info defaults() noexcept {
    return {};
}

namespace {

// The number of evaluations for which a model is prepared. A model of many sheets is evaluated ten million times: most
// places ask for two sheets or more. Each frame evaluates the model again for its camera.
constexpr double expected_evaluations = 5e6;
constexpr std::int64_t most_lines = 65536;

// Owns the arrays that the requests point to, until the line set is made.
struct Requests {
    explicit Requests(base::Memory& memory) noexcept : memory_(memory) {}

    void add(const hrbfnpr_line_desc& desc, const char* name);
    [[nodiscard]] std::span<const curves::LineRequest> all() const noexcept { return requests_; }

private:
    [[nodiscard]] std::span<const double> numbers(const hrbfnpr_array& array, const char* owner, const char* field,
                                                  ArrayType type);
    void add_own(const hrbfnpr_line_desc& desc, const char* name, curves::LineRequest& request);

    base::Memory& memory_;
    std::vector<curves::LineRequest> requests_;
    std::vector<std::unique_ptr<base::Array<double>>> numbers_;
    std::vector<std::unique_ptr<base::Array<std::int64_t>>> firsts_;
};

std::span<const double> Requests::numbers(const hrbfnpr_array& array, const char* owner, const char* field,
                                          ArrayType type) {
    char name[128];
    std::snprintf(name, sizeof name, "%.90s.%s", owner, field);
    auto kept = std::make_unique<base::Array<double>>(finite_numbers(memory_, array, name, type));
    numbers_.push_back(std::move(kept));
    return std::as_const(*numbers_.back()).span();
}

void Requests::add_own(const hrbfnpr_line_desc& desc, const char* name, curves::LineRequest& request) {
    request.points = numbers(desc.position, name, "position", points_type);
    const std::span<const double> first = numbers(desc.line_first, name, "line_first", {1, uint32_only});
    auto kept = std::make_unique<base::Array<std::int64_t>>(memory_);
    const std::size_t count = request.points.size() / 3;
    const auto points = static_cast<double>(count);
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] > points || (i > 0 && first[i] < first[i - 1]))
            fail(Status::invalid_argument,
                 "%s.line_first[%zu] is %.0f; the numbers must not decrease, nor exceed %.0f, the number of positions",
                 name, i, first[i], points);
        kept->push_back(static_cast<std::int64_t>(first[i]));
    }
    if (first.size() < 2)
        fail(Status::invalid_argument,
             "%s.line_first has %zu elements; it needs one for each line, and one more for the end of the last", name,
             first.size());
    firsts_.push_back(std::move(kept));
    request.first = std::as_const(*firsts_.back()).span();
}

bool is_found_on_request(std::uint32_t kind) noexcept {
    return kind == HRBFNPR_LINE_KIND_RIDGE || kind == HRBFNPR_LINE_KIND_VALLEY || kind == HRBFNPR_LINE_KIND_PARABOLIC ||
           kind == HRBFNPR_LINE_KIND_SECTION || kind == HRBFNPR_LINE_KIND_OWN || kind == HRBFNPR_LINE_KIND_SOFT_EDGE ||
           kind == HRBFNPR_LINE_KIND_TANGENT_EDGE;
}

void Requests::add(const hrbfnpr_line_desc& desc, const char* name) {
    const Checks checks(name);
    curves::LineRequest request;
    request.kind = static_cast<curves::LineKind>(desc.kind);
    if (!is_found_on_request(desc.kind))
        fail(Status::invalid_argument,
             "%s.kind is %u; it must be HRBFNPR_LINE_KIND_RIDGE, _VALLEY, _PARABOLIC, _SECTION, _OWN, _SOFT_EDGE or "
             "_TANGENT_EDGE; other lines are found without a request",
             name, desc.kind);
    if (desc.name != nullptr) {
        if (std::strlen(desc.name) >= request.name.size())
            fail(Status::invalid_argument, "%s.name is longer than 63 bytes; shorten it", name);
        std::strcpy(request.name.data(), desc.name);
    }
    checks.at_least("lower", desc.lower, 0.0);
    if (!(std::isfinite(desc.upper) && desc.upper >= desc.lower))
        fail(Status::invalid_argument, "%s.upper is %g; it must be finite and at least lower, which is %g", name,
             desc.upper, desc.lower);
    checks.at_least("shortest", desc.shortest, 0.0);
    request.thresholds = {desc.lower, desc.upper};
    request.shortest = desc.shortest;
    request.plane = {desc.plane[0], desc.plane[1], desc.plane[2]};
    if (!(glm::length(request.plane) > 0.0 && std::isfinite(glm::length(request.plane))))
        fail(Status::invalid_argument, "%s.plane is %g %g %g; it must be a finite vector other than zero", name,
             desc.plane[0], desc.plane[1], desc.plane[2]);
    if (request.kind == curves::LineKind::section) {
        request.levels = numbers(desc.levels, name, "levels", {1, float_types});
        if (request.levels.empty())
            fail(Status::invalid_argument, "%s.levels is empty; give the position of each plane", name);
    }
    if (curves::is_given(request.kind)) add_own(desc, name, request);
    requests_.push_back(request);
}

// Owns the samples by which the end of the surface is found, until the line set is made.
struct SupportArrays {
    SupportArrays(base::Memory& memory, const hrbfnpr_line_set_desc& desc)
        : points(finite_numbers(memory, desc.support_points, "line_set_desc.support_points", points_type)),
          normals(finite_numbers(memory, desc.support_normals, "line_set_desc.support_normals", points_type)) {
        if (!normals.empty() && normals.size() != points.size())
            fail(Status::invalid_argument,
                 "line_set_desc.support_normals has %lld elements, but support_points has %lld; give one normal for "
                 "each point",
                 static_cast<long long>(normals.size() / 3), static_cast<long long>(points.size() / 3));
        for (std::int64_t i = 0; i < normals.size(); i += 3)
            if (normals[i] == 0.0 && normals[i + 1] == 0.0 && normals[i + 2] == 0.0)
                fail(Status::invalid_argument, "line_set_desc.support_normals[%lld] is zero; give it a direction",
                     static_cast<long long>(i / 3));
    }

    [[nodiscard]] curves::SupportSettings settings(double limit, const hrbfnpr_model& model) const {
        curves::SupportSettings settings{limit, points.span(), normals.span(), nullptr};
        settings.domain = limit > 0.0 ? nullptr : model.trim().trim.get();
        if (settings.domain != nullptr) return settings;
        if (points.empty()) {
            settings.points = model.samples().position;
            settings.normals = model.sample_normals();
        }
        if (limit > 0.0 && settings.points.empty())
            fail(Status::invalid_argument,
                 "line_set_desc.support is %g, but a custom model has no samples; give support_points, or set support "
                 "to 0",
                 limit);
        return settings;
    }

    base::Array<double> points, normals;
};

// Returns the triangles of a mesh on which lines can be found.
curves::GivenTriangles triangles_of(const mesh::Mesh& mesh) noexcept {
    if (mesh.report.nonmanifold_edges > 0 || mesh.report.contrary_edges > 0) return {};
    return {mesh.vertex.span(), mesh.triangle.span()};
}

hrbfnpr_line_set* create(hrbfnpr_context& context, const hrbfnpr_model& model, const hrbfnpr_line_set_desc& desc,
                         hrbfnpr_operation* operation) {
    const Checks checks("line_set_desc");
    checks.flags("flags", desc.flags, HRBFNPR_LINE_SET_WITH_CURVATURE);
    checks.at_least("cell_size", desc.cell_size, 0.0);
    checks.at_least("support", desc.support, 0.0);
    const SupportArrays support(context.runtime.memory, desc);
    const base::Array<double> seeds =
        finite_numbers(context.runtime.memory, desc.seed_points, "line_set_desc.seed_points", points_type);
    const List<hrbfnpr_line_desc> list(desc.lines, desc.line_count, desc.line_stride, most_lines,
                                       "line_set_desc.lines");
    Requests requests(context.runtime.memory);
    for (std::int64_t i = 0; i < list.count(); ++i) requests.add(list[i], list.name(i).text);
    const generate::SampleHint samples = model.samples();
    const OperationUse use(operation);
    curves::LineSetSettings settings;
    settings.side = desc.cell_size;
    settings.spacing = samples.spacing;
    settings.seeds = seeds.empty() ? samples.position : seeds.span();
    settings.with_shape = (desc.flags & HRBFNPR_LINE_SET_WITH_CURVATURE) != 0;
    settings.lines = requests.all();
    settings.support = support.settings(desc.support, model);
    if (desc.mesh != nullptr && desc.cell_size == 0.0) settings.triangles = triangles_of(desc.mesh->mesh);
    return use.finish_with(make_handle<hrbfnpr_line_set>(context, model, settings, use.progress()));
}

std::unique_ptr<const implicit::ShapeSource> shape_of(const hrbfnpr_context& context, const hrbfnpr_model& model) {
    if (const implicit::HrbfData* const data = model.data())
        return std::make_unique<implicit::HrbfShape>(context.runtime.instruction_set, *data);
    return std::make_unique<implicit::DifferencedShape>(model.implicit());
}

hrbfnpr_line_set_info describe(const hrbfnpr_line_set& set) noexcept {
    const curves::SurfaceMesh& mesh = set.lines.mesh();
    hrbfnpr_line_set_info info{};
    info.triangles = mesh.triangles();
    info.turned = mesh.turned;
    info.missed_seeds = mesh.missed_seeds;
    for (const curves::FoundLines& found : set.lines.found()) info.lines += found.lines.curves.count();
    info.borders = set.lines.border().curves.count();
    info.cell_size = mesh.side;
    info.seconds = set.lines.seconds();
    info.left_out = set.lines.left_out();
    info.creases = set.lines.creases().count();
    info.bytes = set.bytes();
    return info;
}

} // namespace
} // namespace hrbfnpr::api

hrbfnpr_line_set::hrbfnpr_line_set(hrbfnpr_context& context, const hrbfnpr_model& of,
                                   const curves::LineSetSettings& settings, const base::Progress& progress)
    : Child(context), model(of),
      lines({context.runtime, progress}, of.implicit_for(api::expected_evaluations, progress),
            api::shape_of(context, of), settings) {
    model.add_reference();
}

hrbfnpr_line_set::~hrbfnpr_line_set() { api::release_handle(&model); }

const curves::RayMesh& hrbfnpr_line_set::ray_mesh(const base::Progress& progress) const {
    {
        const std::scoped_lock lock(preparing_);
        if (ray_mesh_ != nullptr) return *ray_mesh_;
    }
    // No lock is held, because the caller's callbacks run here. If two threads make it, their results are equal.
    auto made = std::make_unique<curves::RayMesh>(base::Work(runtime(), progress.part(0.0, 0.0)), lines.mesh());
    const std::scoped_lock lock(preparing_);
    if (ray_mesh_ == nullptr) ray_mesh_ = std::move(made);
    return *ray_mesh_;
}

std::int64_t hrbfnpr_line_set::bytes() const noexcept {
    const std::scoped_lock lock(preparing_);
    return lines.bytes() + (ray_mesh_ != nullptr ? ray_mesh_->tree.bytes() : 0);
}

extern "C" {

hrbfnpr_status hrbfnpr_line_desc_init(hrbfnpr_line_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_line_set_desc_init(hrbfnpr_line_set_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_line_set_create(hrbfnpr_context* context, const hrbfnpr_model* model,
                                       const hrbfnpr_line_set_desc* desc, hrbfnpr_operation* operation,
                                       hrbfnpr_line_set** out_line_set, hrbfnpr_error* error) {
    return api::guarded_create(out_line_set, "out_line_set", error, [&] {
        return api::create(api::deref(context, "context"), api::deref(model, "model"),
                           api::read_optional_struct(desc, "line_set_desc"), operation);
    });
}

void hrbfnpr_line_set_retain(const hrbfnpr_line_set* line_set) {
    if (line_set != nullptr) line_set->add_reference();
}

void hrbfnpr_line_set_release(const hrbfnpr_line_set* line_set) { api::release_handle(line_set); }

hrbfnpr_status hrbfnpr_line_set_info_init(hrbfnpr_line_set_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_line_set_get_info(const hrbfnpr_line_set* line_set, hrbfnpr_line_set_info* info,
                                         hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(line_set, "line_set");
        api::check_output_struct(info, "line_set_info");
        api::write_struct(info, api::describe(handle));
    });
}

} // extern "C"
