// SPDX-License-Identifier: MIT
// Fits a few points with any descriptor, orients them, trims the fit, smooths depths, and uses the results.
#include "arrays.h"
#include "fields.h"
#include "limits.h"
#include "odd.h"
#include "samples.h"
#include "support/depth_image.h"

namespace {

using namespace fuzz;

constexpr std::initializer_list<hrbfnpr_status> failures = {
    HRBFNPR_STATUS_INVALID_ARGUMENT, HRBFNPR_STATUS_OUT_OF_MEMORY,      HRBFNPR_STATUS_SINGULAR_SYSTEM,
    HRBFNPR_STATUS_NOT_CONVERGED,    HRBFNPR_STATUS_UNSUPPORTED_STRUCT, HRBFNPR_STATUS_CANCELLED};

// Checks values and gradients at the centres and at the corners of the bounds.
void require_finite_field(const hrbfnpr_model* model, const hrbfnpr_model_info& info) {
    Call see("model_view");
    hrbfnpr_array centres;
    see.expect(hrbfnpr_model_view(model, HRBFNPR_MODEL_ATTRIBUTE_POSITION, &centres, see.error()));
    require(centres.count == info.centres, "the centres can be seen");
    std::vector<double> places(static_cast<std::size_t>(3 * centres.count));
    std::memcpy(places.data(), centres.data, sizeof(double) * places.size());
    places.insert(places.end(), info.bounds_min, info.bounds_min + 3);
    places.insert(places.end(), info.bounds_max, info.bounds_max + 3);
    const Array at(places, 3);
    Room value(at.view.count, 1, HRBFNPR_SCALAR_FLOAT64);
    Room gradient(at.view.count, 3, HRBFNPR_SCALAR_FLOAT64);
    Call call("model_evaluate");
    call.expect(hrbfnpr_model_evaluate(model, &at.view, &value.out, &gradient.out, nullptr, nullptr, call.error()));
    require(value.is_finite(), "a fitted function has values");
    require(gradient.is_finite(), "a fitted function has gradients");
}

void require_sound_model(Context& context, const hrbfnpr_model* model, std::int64_t samples) {
    hrbfnpr_model_info info;
    hrbfnpr_model_info_init(&info, sizeof info);
    Call call("model_get_info");
    call.expect(hrbfnpr_model_get_info(model, &info, call.error()));
    require(info.samples == samples && info.centres >= 1 && info.centres <= samples, "samples and centres are counted");
    for (int axis = 0; axis < 3; ++axis)
        require(info.bounds_min[axis] <= info.bounds_max[axis], "the bounds are a box");
    const double residuals[] = {info.value_residual_max, info.gradient_residual_max,
                                info.input_distance_rms, info.spacing,
                                info.regularization,     info.seconds_total};
    for (const double number : residuals) require(std::isfinite(number) && number >= 0.0, "a fit tells its residuals");
    require_finite_field(model, info);
    const Bytes file = save(model, hrbfnpr_model_save_memory);
    auto* const again = load<hrbfnpr_model>(context, file, hrbfnpr_model_load_memory);
    require(again != nullptr, "a fitted model loads");
    require(save(again, hrbfnpr_model_save_memory) == file, "a loaded model saves to the same bytes");
    hrbfnpr_model_release(again);
}

void trim(Context& context, const hrbfnpr_model* model, const Samples& samples, Input& input) {
    hrbfnpr_trim_desc desc;
    hrbfnpr_trim_desc_init(&desc, sizeof desc);
    const Array points(samples.points, 3, input);
    const Array normals(samples.normals, 3, input);
    if (input.once_in(2)) desc.points = points.view;
    if (input.once_in(2)) desc.normals = normals.view;
    change_fields(input, "hrbfnpr_trim_desc", &desc);
    const Operation operation(context, input);
    hrbfnpr_model* trimmed = nullptr;
    Call call("model_trim");
    const hrbfnpr_status status = hrbfnpr_model_trim(model, &desc, operation.handle, &trimmed, call.error());
    operation.check(status);
    require(call.expect(status, failures) == (trimmed != nullptr), "a handle comes with success only");
    if (trimmed == nullptr) return;
    hrbfnpr_trim_info info;
    hrbfnpr_trim_info_init(&info, sizeof info);
    Call ask("model_get_trim_info");
    ask.expect(hrbfnpr_model_get_trim_info(trimmed, &info, ask.error()));
    require(info.share >= 0.0 && info.share <= 1.0, "the share of a surface that is left out is one");
    require(std::isfinite(info.farthest) && std::isfinite(info.spacing), "a trim tells lengths");
    hrbfnpr_model_release(trimmed);
}

void fit(Context& context, const Samples& samples, Input& input) {
    const Array points(samples.points, 3, input);
    const Array normals(samples.normals, 3, input);
    hrbfnpr_fit_desc desc;
    hrbfnpr_fit_desc_init(&desc, sizeof desc);
    desc.points = points.view;
    desc.normals = normals.view;
    change_fields(input, "hrbfnpr_fit_desc", &desc);
    hrbfnpr_model* model = nullptr;
    {
        const Operation operation(context, input);
        const ShortMemory memory(context, input);
        Call call("model_fit");
        const hrbfnpr_status status = hrbfnpr_model_fit(context.handle, &desc, operation.handle, &model, call.error());
        operation.check(status);
        require(call.expect(status, failures) == (model != nullptr), "a handle comes with success only");
    }
    if (model == nullptr) return;
    require_sound_model(context, model, desc.points.count);
    if (input.once_in(4)) trim(context, model, samples, input);
    hrbfnpr_model_release(model);
}

void orient(Context& context, const Samples& samples, Input& input) {
    const Array points(samples.points, 3, input);
    const Array normals(samples.normals, 3, input);
    hrbfnpr_orient_desc desc;
    hrbfnpr_orient_desc_init(&desc, sizeof desc);
    desc.points = points.view;
    if (input.once_in(2)) desc.normals = normals.view;
    change_fields(input, "hrbfnpr_orient_desc", &desc);
    Room made(points.view.count, 3, input.once_in(2) ? HRBFNPR_SCALAR_FLOAT32 : HRBFNPR_SCALAR_FLOAT64);
    hrbfnpr_orient_info info;
    hrbfnpr_orient_info_init(&info, sizeof info);
    const Operation operation(context, input);
    const ShortMemory memory(context, input);
    Call call("orient");
    const hrbfnpr_status status =
        hrbfnpr_orient(context.handle, &desc, operation.handle, &made.out, &info, call.error());
    operation.check(status);
    if (!call.expect(status, failures)) {
        require(made.is_untouched(), "a failed call leaves normals untouched");
        return;
    }
    require(made.is_finite(), "normals that are made are finite");
    require(info.confidence >= 0.0 && info.confidence <= 1.0, "a confidence is from 0 to 1");
    require(info.turned >= 0 && info.made >= 0 && info.turned + info.made <= points.view.count, "normals are counted");
}

// Smooths the depths that a depth camera sees, with odd numbers among them.
void smooth_depths(Context& context, Input& input) {
    const auto side = [&] { return static_cast<std::int32_t>(8 + input.below(16)); };
    const std::int32_t columns = side();
    const double steps[] = {0.0, 0.001, 0.1};
    hrbfnpr::test::SeenDepths image =
        hrbfnpr::test::seen_depths(columns, side(), {0.1 * input.unit() * input.unit(), input.one_of(steps), 1.0});
    for (std::size_t odd = input.below(8); odd > 0; --odd) {
        double& number = image.points[input.below(image.points.size())];
        number = odd_float(number, 1.0, input);
    }
    const Array points(image.points, 3, input);
    hrbfnpr_depth_image_desc desc;
    hrbfnpr_depth_image_desc_init(&desc, sizeof desc);
    desc.columns = image.columns;
    desc.rows = image.rows;
    desc.points = points.view;
    change_fields(input, "hrbfnpr_depth_image_desc", &desc);
    const std::uint32_t scalar = input.once_in(2) ? HRBFNPR_SCALAR_FLOAT32 : HRBFNPR_SCALAR_FLOAT64;
    Room moved(points.view.count, 3, scalar);
    Room normals(points.view.count, 3, scalar);
    hrbfnpr_depth_image_info info;
    hrbfnpr_depth_image_info_init(&info, sizeof info);
    const Operation operation(context, input);
    const ShortMemory memory(context, input);
    Call call("smooth_depth_image");
    const hrbfnpr_status status = hrbfnpr_smooth_depth_image(context.handle, &desc, operation.handle, &moved.out,
                                                             &normals.out, &info, call.error());
    operation.check(status);
    if (!call.expect(status, failures)) {
        require(moved.is_untouched() && normals.is_untouched(), "a failed call leaves points untouched");
        return;
    }
    require(normals.is_finite(), "normals of images are finite");
    require(info.seen >= 0 && info.left_out >= 0 && info.left_out <= info.seen && info.seen <= points.view.count,
            "pixels are counted");
    require(info.radius >= 2.0 && info.radius <= 48.0, "a radius is in its range");
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input input(data, size);
    Context context;
    const bool oriented = input.once_in(4);
    const Samples samples = some_samples(input, oriented || input.once_in(8) ? 160 : 48);
    if (oriented)
        orient(context, samples, input);
    else
        fit(context, samples, input);
    if (input.once_in(3)) smooth_depths(context, input);
    return 0;
}
