// SPDX-License-Identifier: MIT
#include "orient/depth_image.h"
#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/handles.h"
#include "api/operation.h"
#include "api/queries.h"
#include "api/views.h"

using namespace hrbfnpr;

namespace hrbfnpr::api {

namespace {

using Depth = hrbfnpr_depth_image_desc;
using orient::DepthImageInput;

constexpr double least_side = 8.0;
constexpr double most_side = 65535.0;
constexpr double most_smoothing = 100.0;

constexpr auto depth_image_fields() noexcept {
    return FieldTable{
        field("columns", &Depth::columns, &DepthImageInput::columns, rule::Between{least_side, most_side}),
        field("rows", &Depth::rows, &DepthImageInput::rows, rule::Between{least_side, most_side}),
        field("keep_points", &Depth::keep_points, rule::ZeroOrOne{}),
        field("points", &Depth::points, rule::Any{}),
        field("noise", &Depth::noise, &DepthImageInput::noise, rule::not_negative),
        field("smoothing", &Depth::smoothing, &DepthImageInput::smoothing, rule::PositiveUpTo{most_smoothing})};
}
static_assert(depth_image_fields().covers<Depth>());

} // namespace

template <>
hrbfnpr_depth_image_desc defaults() noexcept {
    hrbfnpr_depth_image_desc desc{};
    depth_image_fields().set_defaults(DepthImageInput{}, desc);
    return desc;
}

template <>
hrbfnpr_depth_image_info defaults() noexcept {
    return {};
}

namespace {

DepthImageInput checked(const hrbfnpr_depth_image_desc& desc) {
    DepthImageInput input;
    depth_image_fields().check("depth_image_desc", desc);
    depth_image_fields().copy(desc, input);
    input.keep_points = desc.keep_points != 0;
    input.points = in_view(desc.points, "depth_image_desc.points", points_type);
    const std::int64_t pixels = std::int64_t{desc.columns} * desc.rows;
    if (input.points.count != pixels)
        fail(Status::invalid_argument,
             "depth_image_desc.points has %lld elements, but %d columns x %d rows are %lld pixels; give one for each, "
             "NaN where nothing was seen",
             static_cast<long long>(input.points.count), desc.columns, desc.rows, static_cast<long long>(pixels));
    return input;
}

hrbfnpr_depth_image_info describe(const orient::DepthImageReport& report) noexcept {
    hrbfnpr_depth_image_info info{};
    info.seen = report.seen;
    info.left_out = report.left_out;
    info.noise = report.noise;
    info.focal_length = report.focal_length;
    info.depth = report.depth;
    info.radius = report.radius;
    info.seconds = report.seconds;
    return info;
}

void smooth_depth_image(hrbfnpr_context& context, const hrbfnpr_depth_image_desc& desc, hrbfnpr_operation* operation,
                        const hrbfnpr_array_out* out_points, const hrbfnpr_array_out* out_normals,
                        hrbfnpr_depth_image_info* info) {
    const DepthImageInput input = checked(desc);
    const base::OutView points = out_view(out_points, "out_points", points_type, input.points.count);
    const base::OutView normals = out_view(out_normals, "out_normals", points_type, input.points.count);
    if (info != nullptr) check_output_struct(info, "info");
    const OperationUse use(operation);
    const orient::DepthImage image = orient::smooth_depth_image({context.runtime, use.progress()}, input);
    use.finish();
    check_fits(image.point, points, "out_points");
    write_vectors(context.runtime, image.point, points);
    write_vectors(context.runtime, image.normal, normals);
    if (info != nullptr) write_struct(info, describe(image.report));
}

} // namespace

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_depth_image_desc_init(hrbfnpr_depth_image_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_depth_image_info_init(hrbfnpr_depth_image_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_smooth_depth_image(hrbfnpr_context* context, const hrbfnpr_depth_image_desc* desc,
                                          hrbfnpr_operation* operation, const hrbfnpr_array_out* out_points,
                                          const hrbfnpr_array_out* out_normals, hrbfnpr_depth_image_info* info,
                                          hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::smooth_depth_image(api::deref(context, "context"), api::read_struct(desc, "depth_image_desc"), operation,
                                out_points, out_normals, info);
    });
}

} // extern "C"
