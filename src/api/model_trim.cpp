// SPDX-License-Identifier: MIT
#include "api/model_trim.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/lists.h"
#include "api/operation.h"
#include "api/views.h"
#include "implicit/evaluate_all.h"

using namespace hrbfnpr;

namespace hrbfnpr::api {
namespace {

using Trim = hrbfnpr_trim_desc;

constexpr auto trim_fields() noexcept {
    using generate::TrimSettings;
    return FieldTable{field("reserved", &Trim::reserved, rule::OneOf{0, "0"}),
                      field("limit", &Trim::limit, &TrimSettings::limit, rule::Between{1e-3, 1e3}),
                      field("hole", &Trim::hole, &TrimSettings::hole, rule::not_negative),
                      field("closest", &Trim::closest, &TrimSettings::closest, rule::Between{0.0, 1.0}),
                      field("points", &Trim::points, rule::Any{}),
                      field("normals", &Trim::normals, rule::Any{})};
}
static_assert(trim_fields().covers<Trim>());

} // namespace

template <>
hrbfnpr_trim_desc defaults() noexcept {
    hrbfnpr_trim_desc desc{};
    trim_fields().set_defaults(generate::TrimSettings{}, desc);
    return desc;
}

template <>
hrbfnpr_trim_info defaults() noexcept {
    return {};
}

namespace {

geometry::VecArray vectors(base::Memory& memory, std::span<const double> numbers) {
    geometry::VecArray all(memory);
    for (std::size_t i = 0; i + 2 < numbers.size(); i += 3) all.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    return all;
}

geometry::VecArray points_of(const hrbfnpr_model& model, const hrbfnpr_trim_desc& desc) {
    base::Memory& memory = model.runtime().memory;
    const base::Array<double> given = finite_numbers(memory, desc.points, "trim_desc.points", points_type);
    if (!given.empty()) return vectors(memory, given.span());
    const std::span<const double> samples = model.samples().position;
    if (samples.empty())
        fail(Status::invalid_argument,
             "trim_desc.points is empty, and the model has no samples because it is not a fit; give points");
    return vectors(memory, samples);
}

[[noreturn]] void refuse_normal(std::int64_t i, bool given) {
    if (given)
        fail(Status::invalid_argument, "trim_desc.normals[%lld] is zero; give it a direction",
             static_cast<long long>(i));
    fail(Status::invalid_argument,
         "the surface has no normal at trim_desc.points[%lld], where its gradient is 0 or not finite; give "
         "trim_desc.normals",
         static_cast<long long>(i));
}

// Returns the caller's normals for the points. If the caller gives neither normals nor points, returns the normals of
// the model's samples. Otherwise, or if the samples have no normals, returns the normals of the surface at the points.
geometry::VecArray normals_of(const hrbfnpr_model& model, const hrbfnpr_trim_desc& desc,
                              const geometry::VecArray& points, const base::Progress& progress) {
    base::Memory& memory = model.runtime().memory;
    const base::Array<double> given = finite_numbers(memory, desc.normals, "trim_desc.normals", points_type);
    geometry::VecArray normals = vectors(memory, given.span());
    if (!given.empty() && normals.size() != points.size())
        fail(Status::invalid_argument,
             "trim_desc.normals has %lld elements, but points has %lld; give one normal for each point",
             static_cast<long long>(normals.size()), static_cast<long long>(points.size()));
    if (normals.empty() && desc.points.count == 0) normals = vectors(memory, model.sample_normals());
    if (normals.empty()) {
        normals.resize(points.size());
        implicit::evaluate_all({model.runtime(), progress},
                               model.implicit_for(static_cast<double>(points.size()), progress), points,
                               {nullptr, {normals.x.data(), normals.y.data(), normals.z.data()}, {}});
    }
    for (std::int64_t i = 0; i < normals.size(); ++i) {
        if (!(glm::length(normals[i]) > 0.0)) refuse_normal(i, !given.empty());
        normals.set(i, glm::normalize(normals[i]));
    }
    return normals;
}

void log_trim(const base::Runtime& runtime, const generate::TrimReport& report) {
    if (report.parts == 0) return;
    runtime.log(base::LogLevel::info,
                "trim: %lld parts, %.1f %% of the surface, are far from the samples and left out; %lld reach the end "
                "of the search box",
                static_cast<long long>(report.parts), 100.0 * report.share,
                static_cast<long long>(report.parts_to_end));
}

generate::ImplicitFor implicit_of(const hrbfnpr_model& model) {
    return [&model](double evaluations, const base::Progress& progress) -> const implicit::Implicit& {
        return model.implicit_for(evaluations, progress);
    };
}

hrbfnpr_model* trim(const hrbfnpr_model& given, const hrbfnpr_trim_desc& desc, hrbfnpr_operation* operation) {
    trim_fields().check("trim_desc", desc);
    generate::TrimSettings settings;
    trim_fields().copy(desc, settings);
    const hrbfnpr_model& whole = given.untrimmed();
    const OperationUse use(operation);
    const geometry::VecArray points = points_of(whole, desc);
    const geometry::VecArray normals = normals_of(whole, desc, points, use.progress().part(0.0, 0.1));
    const base::Runtime& runtime = whole.runtime();
    generate::FoundTrim found =
        generate::find_trim({runtime, use.progress().part(0.1, 1.0)}, implicit_of(whole), points, normals, settings);
    use.finish();
    log_trim(runtime, found.report);
    return make_handle<hrbfnpr_model>(whole.context(), whole, std::move(found));
}

hrbfnpr_trim_info describe_trim(const hrbfnpr_model& model) noexcept {
    const generate::FoundTrim& found = model.trim();
    hrbfnpr_trim_info info{};
    info.is_trimmed = found.trim != nullptr ? 1 : 0;
    info.samples = found.report.samples;
    info.parts = found.report.parts;
    info.parts_to_end = found.report.parts_to_end;
    info.share = found.report.share;
    info.farthest = found.report.farthest;
    info.spacing = found.report.spacing;
    return info;
}

// With fewer samples than this, the spacing is unknown.
constexpr std::int64_t fewest = 10;

// Finds where to trim a fit. Returns an empty result if the end of the surface cannot be found.
generate::FoundTrim trim_of_fit(const hrbfnpr_model& fitted, const geometry::VecArray& position,
                                const geometry::VecArray& normal, const generate::TrimSettings& settings,
                                const base::Progress& progress) {
    const base::Runtime& runtime = fitted.runtime();
    try {
        if (position.size() < fewest) fail(Status::not_converged, "there are too few samples to find where it ends");
        return generate::find_trim({runtime, progress}, implicit_of(fitted), position, normal, settings);
    } catch (const Error& error) {
        if (error.status() != Status::not_converged) throw;
        runtime.log(base::LogLevel::info, "trim: the surface is left whole: %s", error.what());
        return {};
    }
}

} // namespace

hrbfnpr_model* ended_model(hrbfnpr_model* fitted, const geometry::VecArray& position, const geometry::VecArray& normal,
                           const generate::TrimSettings& settings, const base::Progress& progress) {
    const HandleHold<hrbfnpr_model> whole(fitted); // This object now owns the model.
    release_handle(fitted);
    generate::FoundTrim found = trim_of_fit(*fitted, position, normal, settings, progress);
    progress.update(1.0);
    log_trim(fitted->runtime(), found.report);
    if (found.trim != nullptr) return make_handle<hrbfnpr_model>(fitted->context(), *fitted, std::move(found));
    fitted->set_trim_report(found.report);
    fitted->add_reference();
    return fitted;
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_trim_desc_init(hrbfnpr_trim_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_model_trim(const hrbfnpr_model* model, const hrbfnpr_trim_desc* desc,
                                  hrbfnpr_operation* operation, hrbfnpr_model** out_model, hrbfnpr_error* error) {
    return api::guarded_create(out_model, "out_model", error, [&] {
        return api::trim(api::deref(model, "model"), api::read_optional_struct(desc, "trim_desc"), operation);
    });
}

hrbfnpr_status hrbfnpr_trim_info_init(hrbfnpr_trim_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_model_get_trim_info(const hrbfnpr_model* model, hrbfnpr_trim_info* info, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(model, "model");
        api::check_output_struct(info, "trim_info");
        api::write_struct(info, api::describe_trim(handle));
    });
}

} // extern "C"
