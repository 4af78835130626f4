// SPDX-License-Identifier: MIT
#include "api/orient.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/handles.h"
#include "api/operation.h"
#include "api/queries.h"
#include "api/views.h"

using namespace hrbfnpr;

static_assert(static_cast<std::uint32_t>(orient::NormalMode::given) == HRBFNPR_NORMALS_GIVEN);
static_assert(static_cast<std::uint32_t>(orient::NormalMode::none) == HRBFNPR_NORMALS_NONE);
static_assert(static_cast<std::uint32_t>(orient::NormalMode::unoriented) == HRBFNPR_NORMALS_UNORIENTED);
static_assert(static_cast<std::uint32_t>(orient::NormalMode::mixed) == HRBFNPR_NORMALS_MIXED);
static_assert(static_cast<std::uint32_t>(orient::NormalMode::inward) == HRBFNPR_NORMALS_INWARD);
static_assert(static_cast<std::uint32_t>(orient::NormalMode::automatic) == HRBFNPR_NORMALS_AUTO);
static_assert(static_cast<std::uint32_t>(orient::OutwardBy::inside) == HRBFNPR_OUTWARD_INSIDE);
static_assert(static_cast<std::uint32_t>(orient::OutwardBy::up) == HRBFNPR_OUTWARD_UP);
static_assert(static_cast<std::uint32_t>(orient::OutwardBy::viewpoint) == HRBFNPR_OUTWARD_VIEWPOINT);
static_assert(static_cast<std::uint32_t>(orient::OutwardBy::as_given) == HRBFNPR_OUTWARD_AS_GIVEN);

namespace hrbfnpr::api {

namespace {

using Orient = hrbfnpr_orient_desc;
using orient::OrientInput;

constexpr auto orient_fields() noexcept {
    return FieldTable{
        field("mode", &Orient::mode, &OrientInput::mode, rule::OneOf{HRBFNPR_NORMALS_AUTO, "HRBFNPR_NORMALS_*"}),
        field("points", &Orient::points, rule::Any{}),
        field("normals", &Orient::normals, rule::Any{}),
        field("up", &Orient::up, rule::AllNumbers{rule::Finite{}}),
        field("viewpoint", &Orient::viewpoint, rule::AllNumbers{rule::Finite{}}),
        field("has_viewpoint", &Orient::has_viewpoint, rule::OneOf{1, "0 and 1"}),
        reserved("reserved", &Orient::reserved)};
}
static_assert(orient_fields().covers<Orient>());

} // namespace

template <>
hrbfnpr_orient_desc defaults() noexcept {
    hrbfnpr_orient_desc desc{};
    desc.mode = HRBFNPR_NORMALS_AUTO;
    desc.up[2] = 1.0;
    return desc;
}

template <>
hrbfnpr_orient_info defaults() noexcept {
    return {};
}

namespace {

OrientInput checked(const hrbfnpr_orient_desc& desc) {
    OrientInput input;
    input.points = in_view(desc.points, "orient_desc.points", points_type);
    if (input.points.empty()) fail(Status::invalid_argument, "orient_desc.points is empty; give at least 4 points");
    input.normals = in_view(desc.normals, "orient_desc.normals", points_type);
    orient_fields().check("orient_desc", desc);
    const bool none = input.normals.empty() && may_lack_normals(desc.mode);
    if (!none && input.normals.count != input.points.count)
        fail(Status::invalid_argument,
             "orient_desc.normals has %lld elements, but points has %lld; give one normal for each point, or none with "
             "mode HRBFNPR_NORMALS_NONE or _AUTO",
             static_cast<long long>(input.normals.count), static_cast<long long>(input.points.count));
    orient_fields().copy(desc, input);
    const glm::dvec3 up{desc.up[0], desc.up[1], desc.up[2]};
    const double largest = std::max({std::abs(up.x), std::abs(up.y), std::abs(up.z)});
    if (largest == 0.0) fail(Status::invalid_argument, "orient_desc.up is 0 0 0; give it a direction");
    input.up = glm::normalize(up / largest);
    input.viewpoint = {desc.viewpoint[0], desc.viewpoint[1], desc.viewpoint[2]};
    input.has_viewpoint = desc.has_viewpoint != 0;
    return input;
}

hrbfnpr_orient_info describe(const orient::OrientReport& report) noexcept {
    hrbfnpr_orient_info info{};
    info.found = static_cast<std::uint32_t>(report.found);
    info.turned = report.turned;
    info.made = report.made;
    info.merged = report.merged;
    info.direction_change = report.direction_change;
    info.noise = report.noise;
    info.spacing = report.spacing;
    info.energy = report.energy;
    info.confidence = report.confidence;
    info.closed = report.closed ? 1 : 0;
    info.outward_by = static_cast<std::uint32_t>(report.outward_by);
    info.components = report.components;
    info.seconds = report.seconds;
    return info;
}

void orient_points(hrbfnpr_context& context, const hrbfnpr_orient_desc& desc, hrbfnpr_operation* operation,
                   const hrbfnpr_array_out* out_normals, hrbfnpr_orient_info* info) {
    const OrientInput input = checked(desc);
    const base::OutView out = out_view(out_normals, "out_normals", points_type, input.points.count);
    if (!out) fail(Status::invalid_argument, "out_normals is empty; it must have room for one normal for each point");
    if (info != nullptr) check_output_struct(info, "info");
    const OperationUse use(operation);
    const orient::Orientation result = orient::orient({context.runtime, use.progress()}, input);
    use.finish();
    for (std::int64_t i = 0; i < input.points.count; ++i) set_vector(out, i, result.normal[i]);
    if (info != nullptr) write_struct(info, describe(result.report));
}

} // namespace

bool may_lack_normals(std::uint32_t mode) noexcept {
    return mode == HRBFNPR_NORMALS_NONE || mode == HRBFNPR_NORMALS_AUTO;
}

NormalsOfFit::NormalsOfFit(const base::Work& work, std::uint32_t mode, fit::FitInput& input)
    : made_(mode != HRBFNPR_NORMALS_GIVEN), packed_(work.memory) {
    if (!made_) {
        inward_ = orient::plainly_inward(work.part(0.0, 0.0), input.points, input.normals);
        if (inward_)
            work.runtime().log(base::LogLevel::warning, "fit: all normals point inward, so the surface will not be "
                                                        "seen; set normal_mode to HRBFNPR_NORMALS_AUTO");
        return;
    }
    orient::OrientInput wanted;
    wanted.points = input.points;
    wanted.normals = input.normals;
    wanted.mode = static_cast<orient::NormalMode>(mode);
    orient::Orientation result = orient::orient(work.part(0.0, share), wanted);
    found_ = result.report;
    packed_.resize_for_overwrite(3 * result.normal.size());
    for (std::int64_t i = 0; i < result.normal.size(); ++i) {
        packed_[3 * i] = result.normal.x[i];
        packed_[3 * i + 1] = result.normal.y[i];
        packed_[3 * i + 2] = result.normal.z[i];
    }
    input.normals = {reinterpret_cast<const std::byte*>(packed_.data()), result.normal.size(), 3 * sizeof(double),
                     base::Scalar::float64, 3};
}

base::Progress NormalsOfFit::rest(const base::Progress& progress) const noexcept {
    return made_ ? progress.part(share, 1.0) : progress;
}

void NormalsOfFit::report(fit::FitReport& report) const noexcept {
    report.normals_inward = inward_;
    if (!made_) return;
    report.normals_found = static_cast<std::uint32_t>(found_.found);
    report.normals_turned = found_.turned;
    report.normals_confidence = found_.confidence;
    report.seconds_orient = found_.seconds;
    report.seconds_total += found_.seconds;
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_orient_desc_init(hrbfnpr_orient_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_orient_info_init(hrbfnpr_orient_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_orient(hrbfnpr_context* context, const hrbfnpr_orient_desc* desc, hrbfnpr_operation* operation,
                              const hrbfnpr_array_out* out_normals, hrbfnpr_orient_info* info, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::orient_points(api::deref(context, "context"), api::read_struct(desc, "orient_desc"), operation,
                           out_normals, info);
    });
}

} // extern "C"
