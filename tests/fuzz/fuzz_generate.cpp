// SPDX-License-Identifier: MIT
// Makes marks and line sets with any descriptors, of a few fitted models and of awkward functions; also rays and
// curvatures.
#include "arrays.h"
#include "fields.h"
#include "limits.h"
#include "scenes.h"

#include <memory>

namespace {

using namespace fuzz;

constexpr std::initializer_list<hrbfnpr_status> failures = {
    HRBFNPR_STATUS_INVALID_ARGUMENT,   HRBFNPR_STATUS_OUT_OF_MEMORY, HRBFNPR_STATUS_NOT_CONVERGED,
    HRBFNPR_STATUS_UNSUPPORTED_STRUCT, HRBFNPR_STATUS_CANCELLED,     HRBFNPR_STATUS_CALLBACK};

// The values that the callbacks of layers return.
struct Answers {
    double number = 0.5;
    std::int32_t status = 0;

    static std::int32_t density(void* user, std::int64_t count, const double* positions, const double*, double* out) {
        const auto& self = *static_cast<const Answers*>(user);
        for (std::int64_t i = 0; i < count; ++i) out[i] = positions[3 * i] > 0.3 ? 0.1 : self.number;
        return self.status;
    }
    static std::int32_t direction(void* user, std::int64_t count, const double* positions, const double*, double* out) {
        const auto& self = *static_cast<const Answers*>(user);
        for (std::int64_t i = 0; i < count; ++i) {
            out[3 * i] = self.number;
            out[3 * i + 1] = positions[3 * i + 1];
            out[3 * i + 2] = 0.0;
        }
        return self.status;
    }
};

hrbfnpr_layer_desc some_layer(Answers& answers, Input& input) {
    hrbfnpr_layer_desc layer;
    hrbfnpr_layer_desc_init(&layer, sizeof layer);
    layer.kind = input.once_in(2) ? HRBFNPR_LAYER_KIND_HATCH : HRBFNPR_LAYER_KIND_STIPPLES;
    layer.budget = 1 + static_cast<std::int64_t>(input.below(300));
    layer.levels = static_cast<std::int32_t>(input.below(3));
    layer.density = static_cast<std::uint32_t>(input.below(3));
    if (input.once_in(4)) layer.direction_function = Answers::direction;
    if (layer.density == HRBFNPR_DENSITY_CALLBACK) layer.density_function = Answers::density;
    layer.direction_user = layer.density_user = &answers;
    layer.guide = input.once_in(2) ? static_cast<std::uint32_t>(input.below(5)) : 0U;
    static constexpr double separations[] = {0, 0, 0, 0.2, 0.05, 1.0, 1e-3};
    if (layer.kind != HRBFNPR_LAYER_KIND_STIPPLES) layer.separation = input.one_of(separations);
    change_fields(input, "hrbfnpr_layer_desc", &layer);
    return layer;
}

// A list of layers, and everything that they refer to.
struct Marks {
    explicit Marks(Input& input) : seeds(std::span(places), 3, input) {
        answers.number = input.once_in(4) ? odd_float(0.5, input.unit(), input) : input.unit();
        answers.status = input.once_in(16) ? 1 : 0;
        for (std::size_t count = 1 + input.below(3); count > 0; --count) layers.push_back(some_layer(answers, input));
        hrbfnpr_generate_desc_init(&desc, sizeof desc);
        desc.distribution = input.once_in(3) ? 1U : 0U;
        desc.layers = layers.data();
        desc.layer_count = static_cast<std::int64_t>(layers.size());
        desc.layer_stride = sizeof layers[0];
        desc.seed_source = input.once_in(4) ? static_cast<std::uint32_t>(input.below(4)) : 0U;
        if (desc.seed_source == HRBFNPR_SEED_POINTS) desc.seed_points = seeds.view;
        change_fields(input, "hrbfnpr_generate_desc", &desc);
    }

    static constexpr double places[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, -1, 0.2, 0.3};
    Answers answers;
    Array seeds;
    std::vector<hrbfnpr_layer_desc> layers;
    hrbfnpr_generate_desc desc;
};

void require_counted(const hrbfnpr_placement_info& info) {
    require(info.attempted == info.placed + info.dropped_not_converged + info.dropped_strayed +
                                  info.dropped_degenerate + info.dropped_budget,
            "candidates are placed or dropped");
}

void require_placements(const hrbfnpr_point_set* set) {
    hrbfnpr_point_set_info info;
    hrbfnpr_point_set_info_init(&info, sizeof info);
    Call ask("point_set_get_info");
    ask.expect(hrbfnpr_point_set_get_info(set, &info, ask.error()));
    hrbfnpr_placement_info placement;
    hrbfnpr_placement_info_init(&placement, sizeof placement);
    Call seeds("point_set_get_seed_placement");
    seeds.expect(hrbfnpr_point_set_get_seed_placement(set, &placement, seeds.error()));
    require_counted(placement);
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        hrbfnpr_layer_info layer_info;
        hrbfnpr_layer_info_init(&layer_info, sizeof layer_info);
        Call call("point_set_get_layer_info");
        call.expect(hrbfnpr_point_set_get_layer_info(set, layer, &layer_info, call.error()));
        for (std::int32_t level = 0; level <= layer_info.levels; ++level) {
            Call place("point_set_get_placement");
            place.expect(hrbfnpr_point_set_get_placement(set, layer, level, &placement, place.error()));
            require_counted(placement);
        }
    }
}

void generate(Context& context, const hrbfnpr_model* model, Input& input) {
    const Marks marks(input);
    hrbfnpr_point_set* set = nullptr;
    {
        const Operation operation(context, input);
        const ShortMemory memory(context, input);
        Call call("point_set_generate");
        const hrbfnpr_status status =
            hrbfnpr_point_set_generate(context.handle, model, &marks.desc, operation.handle, &set, call.error());
        operation.check(status);
        require(call.expect(status, failures) == (set != nullptr), "a handle comes with success only");
    }
    if (set == nullptr) return;
    require_sound_marks(set);
    require_same_set(context, set);
    require_placements(set);
    hrbfnpr_point_set_release(set);
}

void patches(Context& context, const hrbfnpr_model* model, Input& input) {
    const Marks marks(input);
    Room corners(1 + static_cast<std::int64_t>(input.below(6)), 12,
                 input.once_in(2) ? HRBFNPR_SCALAR_FLOAT32 : HRBFNPR_SCALAR_FLOAT64);
    double step = -1.0;
    const Operation operation(context, input);
    Call call("point_set_step_patches");
    const hrbfnpr_status status = hrbfnpr_point_set_step_patches(context.handle, model, &marks.desc, &corners.out,
                                                                 &step, operation.handle, call.error());
    operation.check(status);
    if (call.expect(status, failures))
        require(corners.is_finite() && step > 0.0 && std::isfinite(step), "squares have corners and a step");
    else
        require(corners.is_untouched() && step == -1.0, "a failed call leaves squares untouched");
}

hrbfnpr_line_desc some_line(Input& input) {
    static constexpr double levels[] = {-0.3, 0.0, 0.4};
    static constexpr double own[] = {1.4, 0, 0, 0, 1.4, 0, -1.4, 0, 0, 0, 0, 0.4};
    static constexpr std::uint32_t first[] = {0, 3, 4};
    static constexpr std::uint32_t kinds[] = {HRBFNPR_LINE_KIND_RIDGE, HRBFNPR_LINE_KIND_VALLEY,
                                              HRBFNPR_LINE_KIND_PARABOLIC, HRBFNPR_LINE_KIND_SECTION,
                                              HRBFNPR_LINE_KIND_OWN};
    hrbfnpr_line_desc line;
    hrbfnpr_line_desc_init(&line, sizeof line);
    line.kind = input.one_of(kinds);
    if (line.kind == HRBFNPR_LINE_KIND_SECTION) line.levels = {levels, 3, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    if (line.kind == HRBFNPR_LINE_KIND_OWN) {
        line.position = {own, 4, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        line.line_first = {first, 3, 0, HRBFNPR_SCALAR_UINT32, 1};
    }
    if (input.once_in(2)) line.lower = line.upper = input.between(0.0, 10.0);
    change_fields(input, "hrbfnpr_line_desc", &line);
    return line;
}

void make_lines(Context& context, const hrbfnpr_model* model, Input& input) {
    std::vector<hrbfnpr_line_desc> lines;
    for (std::size_t count = input.below(3); count > 0; --count) lines.push_back(some_line(input));
    const Array seeds(Marks::places, 3, input);
    hrbfnpr_line_set_desc desc;
    hrbfnpr_line_set_desc_init(&desc, sizeof desc);
    desc.cell_size = input.between(0.1, 0.6);
    desc.flags = input.once_in(3) ? HRBFNPR_LINE_SET_WITH_CURVATURE : 0;
    desc.support = input.once_in(3) ? 1.5 : 0.0;
    if (input.once_in(3)) desc.seed_points = seeds.view;
    if (input.once_in(3)) desc.support_points = seeds.view;
    if (input.once_in(3)) desc.support_normals = seeds.view;
    desc.lines = lines.data();
    desc.line_count = static_cast<std::int64_t>(lines.size());
    desc.line_stride = sizeof(hrbfnpr_line_desc);
    change_fields(input, "hrbfnpr_line_set_desc", &desc);
    hrbfnpr_line_set* set = nullptr;
    const Operation operation(context, input);
    const ShortMemory memory(context, input);
    Call call("line_set_create");
    const hrbfnpr_status status =
        hrbfnpr_line_set_create(context.handle, model, &desc, operation.handle, &set, call.error());
    operation.check(status);
    require(call.expect(status, failures) == (set != nullptr), "a handle comes with success only");
    if (set == nullptr) return;
    hrbfnpr_line_set_info info;
    hrbfnpr_line_set_info_init(&info, sizeof info);
    Call ask("line_set_get_info");
    ask.expect(hrbfnpr_line_set_get_info(set, &info, ask.error()));
    require(info.triangles > 0 && info.turned <= info.triangles, "a line set has a mesh");
    require(info.cell_size > 0.0 && std::isfinite(info.cell_size), "cells have a size");
    require(info.left_out >= 0.0 && info.left_out <= 1.0, "what is left out is a share");
    hrbfnpr_line_set_release(set);
}

void cast(Context& context, const hrbfnpr_model* model, Input& input) {
    double numbers[18];
    for (double& number : numbers) number = input.once_in(8) ? odd_float(0.5, 1.0, input) : input.between(-2.0, 2.0);
    const Array from{std::span(numbers).first(9), 3, input};
    const Array along{std::span(numbers).last(9), 3, input};
    hrbfnpr_cast_desc desc;
    hrbfnpr_cast_desc_init(&desc, sizeof desc);
    desc.maximum_hits = 3;
    if (!input.once_in(8)) desc.lipschitz = 2.0;
    change_fields(input, "hrbfnpr_cast_desc", &desc);
    const auto hits = static_cast<std::uint32_t>(std::clamp(desc.maximum_hits, 1, 256));
    Room count(3, 1, HRBFNPR_SCALAR_UINT32);
    Room t(3, hits, HRBFNPR_SCALAR_FLOAT64);
    Room position(3, 3 * hits, HRBFNPR_SCALAR_FLOAT64);
    hrbfnpr_ray_hits result;
    hrbfnpr_ray_hits_init(&result, sizeof result);
    result.count = count.out;
    result.t = t.out;
    result.position = position.out;
    const Operation operation(context, input);
    Call call("model_cast_rays");
    const hrbfnpr_status status =
        hrbfnpr_model_cast_rays(model, &from.view, &along.view, &desc, &result, operation.handle, call.error());
    operation.check(status);
    if (!call.expect(status, failures)) return;
    require(position.is_finite(), "a hit has a position");
    for (const std::uint32_t found : count.numbers<std::uint32_t>()) require(found <= hits, "hits are counted");
}

void query(Context& context, const hrbfnpr_model* model, Input& input) {
    double numbers[9];
    for (double& number : numbers) number = input.once_in(8) ? odd_float(0.5, 1.0, input) : input.between(-2.0, 2.0);
    const Array at(numbers, 3, input);
    hrbfnpr_project_desc desc;
    hrbfnpr_project_desc_init(&desc, sizeof desc);
    change_fields(input, "hrbfnpr_project_desc", &desc);
    Room position(3, 3, HRBFNPR_SCALAR_FLOAT64);
    Room status(3, 1, HRBFNPR_SCALAR_UINT8);
    hrbfnpr_projection projection;
    hrbfnpr_projection_init(&projection, sizeof projection);
    projection.position = position.out;
    projection.status = status.out;
    const Operation operation(context, input);
    Call call("model_project");
    const hrbfnpr_status result =
        hrbfnpr_model_project(model, &at.view, &desc, &projection, operation.handle, call.error());
    operation.check(result);
    if (call.expect(result, failures)) {
        const std::vector<double> places = position.numbers<double>();
        const std::vector<std::uint8_t> ends = status.numbers<std::uint8_t>();
        for (std::size_t i = 0; i < 9; ++i)
            require(ends[i / 3] != HRBFNPR_PROJECTION_CONVERGED || std::isfinite(places[i]), "a projection is finite");
    }
    Room k1(3, 1, HRBFNPR_SCALAR_FLOAT32);
    Room d1(3, 3, HRBFNPR_SCALAR_FLOAT32);
    hrbfnpr_curvature curvature;
    hrbfnpr_curvature_init(&curvature, sizeof curvature);
    curvature.k1 = k1.out;
    curvature.d1 = d1.out;
    Call bend("model_curvature");
    bend.expect(hrbfnpr_model_curvature(model, &at.view, &curvature, nullptr, bend.error()), failures);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input input(data, size);
    Context context;
    Custom custom(input);
    const std::size_t which = input.below(2 * model_count);
    const bool tree = which >= model_count && input.once_in(2);
    hrbfnpr_model* const made = which < model_count ? nullptr
                                : tree              ? create_csg(context, input)
                                                    : custom.create(context, input);
    if (which >= model_count && made == nullptr) return 0;
    const hrbfnpr_model* const model = made != nullptr ? made : scene_model(which);
    switch (input.below(8)) {
    case 5: patches(context, model, input); break;
    case 6:
        cast(context, model, input);
        query(context, model, input);
        break;
    case 3:
    case 4: make_lines(context, model, input); break;
    default: generate(context, model, input);
    }
    hrbfnpr_model_release(made);
    return 0;
}
