// SPDX-License-Identifier: MIT
#include "api/line_set.h"

#include "api/barrier.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/operation.h"
#include "api/views.h"

#include <cmath>

using namespace hrbfnpr;

namespace hrbfnpr::api {

template <>
hrbfnpr_line_set_desc defaults() noexcept {
    return {};
}

template <>
hrbfnpr_line_set_info defaults() noexcept {
    return {};
}

namespace {

// Frames trace curves again and again: worth preparing for.
constexpr double expected_evaluations = 1e6;

base::Array<double> seeds_of(base::Memory& memory, const hrbfnpr_array& array) {
    base::Array<double> seeds(memory);
    const base::InView view = in_view(array, "line_set_desc.seed_points", points_type);
    for (std::int64_t i = 0; i < view.count; ++i) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            const double number = view.get(i, c);
            if (!std::isfinite(number))
                fail(Status::invalid_argument, "line_set_desc.seed_points[%lld][%u] is %g; it must be finite",
                     static_cast<long long>(i), c, number);
            seeds.push_back(number);
        }
    }
    return seeds;
}

hrbfnpr_line_set* create(hrbfnpr_context& context, const hrbfnpr_model& model, const hrbfnpr_line_set_desc& desc,
                         hrbfnpr_operation* operation) {
    const Checks checks("line_set_desc");
    checks.zero("reserved", desc.reserved);
    checks.at_least("cell_size", desc.cell_size, 0.0);
    const base::Array<double> seeds = seeds_of(context.runtime.memory, desc.seed_points);
    const generate::SampleHint samples = model.samples();
    const OperationUse use(operation);
    curves::LineSetSettings settings;
    settings.side = desc.cell_size;
    settings.spacing = samples.spacing;
    settings.seeds = seeds.empty() ? samples.position : seeds.span();
    auto* const set = make_handle<hrbfnpr_line_set>(context, model, settings, use.progress());
    use.finish();
    return set;
}

hrbfnpr_line_set_info describe(const hrbfnpr_line_set& set) noexcept {
    const curves::SurfaceMesh& mesh = set.lines.mesh();
    hrbfnpr_line_set_info info{};
    info.triangles = mesh.triangles();
    info.turned = mesh.turned;
    info.missed_seeds = mesh.missed_seeds;
    info.cell_size = mesh.side;
    info.seconds = set.lines.seconds();
    info.bytes = set.lines.bytes();
    return info;
}

} // namespace
} // namespace hrbfnpr::api

hrbfnpr_line_set::hrbfnpr_line_set(hrbfnpr_context& context, const hrbfnpr_model& of,
                                   const curves::LineSetSettings& settings, const base::Progress& progress)
    : Child(context), model(of),
      lines(context.runtime, of.implicit_for(api::expected_evaluations, progress), settings, progress) {
    model.add_reference();
}

hrbfnpr_line_set::~hrbfnpr_line_set() { api::release_handle(&model); }

extern "C" {

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
