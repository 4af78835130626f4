// SPDX-License-Identifier: MIT
#include "scenes.h"

#include "arrays.h"
#include "fields.h"
#include "samples.h"

#include <algorithm>
#include <cmath>

namespace fuzz {
namespace {

hrbfnpr_model* fit(const Samples& samples) {
    const Array points(samples.points, 3);
    const Array normals(samples.normals, 3);
    hrbfnpr_fit_desc desc;
    hrbfnpr_fit_desc_init(&desc, sizeof desc);
    desc.points = points.view;
    desc.normals = normals.view;
    Call call("model_fit");
    hrbfnpr_model* model = nullptr;
    call.expect(hrbfnpr_model_fit(scene_context().handle, &desc, nullptr, &model, call.error()));
    return model;
}

const hrbfnpr_model* make_model(std::size_t which) {
    if (which == 0) return fit(samples_of(Surface::sphere, 30));
    if (which == 1) return fit(samples_of(Surface::torus, 60));
    if (which == 3) return fit(samples_of(Surface::two_spheres, 48));
    if (which == 4) return fit(samples_of(Surface::one_place, 1));
    hrbfnpr_model* const whole = fit(samples_of(Surface::sheet, 49));
    hrbfnpr_model* trimmed = nullptr;
    Call call("model_trim");
    call.expect(hrbfnpr_model_trim(whole, nullptr, nullptr, &trimmed, call.error()));
    hrbfnpr_model_release(whole);
    return trimmed;
}

hrbfnpr_layer_desc layer_of(std::uint32_t kind, std::uint32_t guide = HRBFNPR_HATCH_GUIDE_CURVATURE) {
    hrbfnpr_layer_desc layer;
    hrbfnpr_layer_desc_init(&layer, sizeof layer);
    layer.kind = kind;
    layer.guide = guide;
    layer.budget = 150;
    layer.levels = 1;
    return layer;
}

const hrbfnpr_point_set* generate(std::size_t model, std::uint32_t distribution,
                                  const std::vector<hrbfnpr_layer_desc>& layers) {
    hrbfnpr_generate_desc desc;
    hrbfnpr_generate_desc_init(&desc, sizeof desc);
    desc.distribution = distribution;
    desc.layers = layers.data();
    desc.layer_count = static_cast<std::int64_t>(layers.size());
    hrbfnpr_point_set* set = nullptr;
    Call call("point_set_generate");
    call.expect(
        hrbfnpr_point_set_generate(scene_context().handle, scene_model(model), &desc, nullptr, &set, call.error()));
    return set;
}

// Makes two strokes of three marks, or a single mark.
const hrbfnpr_point_set* own_marks(bool strokes) {
    const double places[] = {-1, 0, 0, 0, 0.1, 0, 1, 0, 0, -1, 0, 1, 0, 0.1, 1, 1, 0, 1};
    const double normals[] = {0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0};
    const std::uint32_t first[] = {0, 3, 6};
    const Array position{std::span(places).first(strokes ? 18 : 3), 3};
    const Array normal{std::span(normals).first(strokes ? 18 : 3), 3};
    hrbfnpr_layer_arrays layer;
    hrbfnpr_layer_arrays_init(&layer, sizeof layer);
    layer.position = position.view;
    layer.normal = normal.view;
    if (strokes) layer.stroke_first = {first, 3, 0, HRBFNPR_SCALAR_UINT32, 1};
    hrbfnpr_point_set_desc desc;
    hrbfnpr_point_set_desc_init(&desc, sizeof desc);
    desc.layers = &layer;
    desc.layer_count = 1;
    hrbfnpr_point_set* set = nullptr;
    Call call("point_set_create");
    call.expect(hrbfnpr_point_set_create(scene_context().handle, &desc, &set, call.error()));
    return set;
}

const hrbfnpr_point_set* make_set(std::size_t which) {
    switch (which) {
    case 0:
        return generate(1, HRBFNPR_DISTRIBUTION_BLUE_NOISE,
                        {layer_of(HRBFNPR_LAYER_KIND_STIPPLES), layer_of(HRBFNPR_LAYER_KIND_HATCH)});
    case 1:
        return generate(3, HRBFNPR_DISTRIBUTION_BLUE_NOISE,
                        {layer_of(HRBFNPR_LAYER_KIND_HATCH, HRBFNPR_HATCH_GUIDE_SECTIONS),
                         layer_of(HRBFNPR_LAYER_KIND_HATCH, HRBFNPR_HATCH_GUIDE_COMBING)});
    case 2:
        return generate(0, HRBFNPR_DISTRIBUTION_PUBLISHED,
                        {layer_of(HRBFNPR_LAYER_KIND_STIPPLES), layer_of(HRBFNPR_LAYER_KIND_HATCH)});
    default: return own_marks(which == 3);
    }
}

hrbfnpr_line_desc line_of(std::uint32_t kind) {
    hrbfnpr_line_desc line;
    hrbfnpr_line_desc_init(&line, sizeof line);
    line.kind = kind;
    if (kind == HRBFNPR_LINE_KIND_RIDGE || kind == HRBFNPR_LINE_KIND_VALLEY) line.lower = line.upper = 0.5;
    return line;
}

const hrbfnpr_line_set* make_lines(std::size_t which) {
    static constexpr double levels[] = {-0.1, 0.05, 0.2};
    static constexpr double own[] = {1.4, 0, 0, 0, 1.4, 0, -1.4, 0, 0};
    static constexpr std::uint32_t first[] = {0, 3};
    std::vector<hrbfnpr_line_desc> list;
    for (const std::uint32_t kind : {HRBFNPR_LINE_KIND_RIDGE, HRBFNPR_LINE_KIND_VALLEY, HRBFNPR_LINE_KIND_PARABOLIC,
                                     HRBFNPR_LINE_KIND_SECTION, HRBFNPR_LINE_KIND_OWN})
        list.push_back(line_of(kind));
    list[3].levels = {levels, 3, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    list[4].position = {own, 3, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    list[4].line_first = {first, 2, 0, HRBFNPR_SCALAR_UINT32, 1};
    hrbfnpr_line_set_desc desc;
    hrbfnpr_line_set_desc_init(&desc, sizeof desc);
    desc.cell_size = 0.3;
    desc.flags = which == 0 ? HRBFNPR_LINE_SET_WITH_CURVATURE : 0;
    desc.support = which == 1 ? 1.5 : 0.0;
    if (which == 1) desc.cell_size = 0.15;
    desc.lines = list.data();
    desc.line_count = which == 0 ? static_cast<std::int64_t>(list.size()) : 0;
    hrbfnpr_line_set* set = nullptr;
    Call call("line_set_create");
    call.expect(
        hrbfnpr_line_set_create(scene_context().handle, scene_model(1 + which), &desc, nullptr, &set, call.error()));
    return set;
}

} // namespace

Context& scene_context() {
    static auto* const context = new Context;
    return *context;
}

const hrbfnpr_model* scene_model(std::size_t which) {
    static Once<model_count, hrbfnpr_model> made;
    return made(which, make_model);
}

const hrbfnpr_point_set* scene_set(std::size_t which) {
    static Once<set_count, hrbfnpr_point_set> made;
    return made(which, make_set);
}

const hrbfnpr_line_set* scene_lines(std::size_t which) {
    static Once<line_set_count, hrbfnpr_line_set> made;
    return made(which, make_lines);
}

Custom::Custom(Input& input) {
    static constexpr double scales[] = {1, 1, 1, 1, 1e-3, 1e3, 1e-20, 1e20, 1e-60, 1e60, 1e-99};
    static constexpr double sizes[] = {0.9, 0.5, 0.1, 0.01, 2.0, 0.0};
    shape_ = static_cast<Shape>(input.below(static_cast<std::size_t>(Shape::count)));
    scale_ = input.one_of(scales);
    size_ = input.one_of(sizes);
    left_ = input.once_in(4) ? static_cast<std::int64_t>(input.below(3000)) : 400000;
}

double Custom::value(const double* point) const {
    const double x = point[0] / scale_;
    const double y = point[1] / scale_;
    const double z = point[2] / scale_;
    const double r = std::sqrt(x * x + y * y + z * z);
    switch (shape_) {
    case Shape::sphere:
    case Shape::count: return scale_ * (r - size_);
    case Shape::torus: return scale_ * (std::hypot(std::hypot(x, y) - 0.7 * size_, z) - 0.25 * size_);
    case Shape::plane: return scale_ * (z - 0.1 * x);
    case Shape::waves: return scale_ * (z - 0.2 * std::sin(9.0 * x) * std::cos(7.0 * y));
    case Shape::crease: return scale_ * (std::max({std::abs(x), std::abs(y), std::abs(z)}) - size_);
    case Shape::step: return r < size_ ? -scale_ : scale_;
    case Shape::constant: return 0.0;
    case Shape::flat_top: return scale_ * std::max(r - size_, -0.2 * size_) * (z > 0.0 ? 1.0 : 1e-3);
    case Shape::not_finite_beyond: return x > 0.5 * size_ ? std::nan("") : scale_ * (r - size_);
    }
    return 0.0;
}

std::int32_t Custom::evaluate(void* user, std::int64_t count, const double* points, double* value, double* gradient,
                              double*) {
    auto& self = *static_cast<Custom*>(user);
    if ((self.left_ -= count) < 0) return 1;
    const double step = 1e-5 * self.scale_;
    for (std::int64_t i = 0; i < count; ++i) {
        const double* const at = points + 3 * i;
        value[i] = self.value(at);
        for (std::size_t k = 0; k < 3 && gradient != nullptr; ++k) {
            double place[3] = {at[0], at[1], at[2]};
            place[k] += step;
            gradient[3 * i + static_cast<std::int64_t>(k)] = (self.value(place) - value[i]) / step;
        }
    }
    return 0;
}

hrbfnpr_model* Custom::create(Context& context, Input& input) {
    hrbfnpr_custom_desc desc;
    hrbfnpr_custom_desc_init(&desc, sizeof desc);
    desc.function = evaluate;
    desc.user = this;
    desc.flags = input.once_in(2) ? HRBFNPR_CUSTOM_HAS_GRADIENT : 0;
    for (int axis = 0; axis < 3; ++axis) {
        desc.bounds_min[axis] = -scale_;
        desc.bounds_max[axis] = scale_;
    }
    change_fields(input, "hrbfnpr_custom_desc", &desc, {"flags"});
    hrbfnpr_model* model = nullptr;
    Call call("model_create_custom");
    const bool made =
        call.expect(hrbfnpr_model_create_custom(context.handle, &desc, &model, call.error()),
                    {HRBFNPR_STATUS_INVALID_ARGUMENT, HRBFNPR_STATUS_UNSUPPORTED_STRUCT, HRBFNPR_STATUS_OUT_OF_MEMORY});
    require(made == (model != nullptr), "a handle comes with success only");
    return model;
}

hrbfnpr_model* create_csg(Context& context, Input& input) {
    std::vector<hrbfnpr_csg_node> nodes(1 + input.below(7));
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        hrbfnpr_csg_node& node = nodes[i];
        hrbfnpr_csg_node_init(&node, sizeof node);
        const bool leaf = i > nodes.size() / 2;
        node.kind = static_cast<std::uint32_t>(leaf ? HRBFNPR_CSG_MODEL + input.below(7) : input.below(6));
        node.parent = i == 0 ? -1 : static_cast<std::int64_t>(input.below(std::min(i, nodes.size() / 2 + 1)));
        node.distance = 0.1;
        node.blend = input.once_in(2) ? input.unit() : 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) node.transform[12 + axis] = input.between(-1.0, 1.0);
        change_fields(input, "hrbfnpr_csg_node", &node);
        if (input.once_in(4)) node.model = scene_model(input.below(model_count));
    }
    hrbfnpr_csg_desc desc;
    hrbfnpr_csg_desc_init(&desc, sizeof desc);
    desc.nodes = nodes.data();
    desc.node_count = static_cast<std::int64_t>(nodes.size());
    for (std::size_t axis = 0; axis < 3 && input.once_in(2); ++axis)
        desc.bounds_min[axis] = -(desc.bounds_max[axis] = 2.0);
    change_fields(input, "hrbfnpr_csg_desc", &desc);
    hrbfnpr_model* model = nullptr;
    Call call("model_create_csg");
    const bool made =
        call.expect(hrbfnpr_model_create_csg(context.handle, &desc, &model, call.error()),
                    {HRBFNPR_STATUS_INVALID_ARGUMENT, HRBFNPR_STATUS_UNSUPPORTED_STRUCT, HRBFNPR_STATUS_OUT_OF_MEMORY});
    require(made == (model != nullptr), "a handle comes with success only");
    return model;
}

} // namespace fuzz
