// SPDX-License-Identifier: MIT
#include "host/session.h"

#include <algorithm>

namespace host_test {
namespace {

constexpr std::int64_t point_count = 2000;
constexpr std::int32_t picture_size = 160;

// Output arrays whose bytes stay where they are.
class Output {
public:
    hrbfnpr_array_out add(std::int64_t count, std::uint32_t components, std::uint32_t scalar = HRBFNPR_SCALAR_FLOAT64) {
        const std::size_t size = scalar == HRBFNPR_SCALAR_FLOAT64 ? 8 : scalar == HRBFNPR_SCALAR_UINT8 ? 1 : 4;
        parts_.emplace_back(static_cast<std::size_t>(count) * components * size);
        return {parts_.back().data(), count, 0, scalar, components};
    }
    void add(const Bytes& bytes) { parts_.push_back(bytes); }
    [[nodiscard]] Bytes bytes() const {
        Bytes all;
        for (const Bytes& part : parts_) all.insert(all.end(), part.begin(), part.end());
        return all;
    }

private:
    std::vector<Bytes> parts_;
};

// Points around the torus, and directions of rays through it.
struct Places {
    Places() {
        for (int i = 0; i < 3 * point_count; ++i) {
            point.push_back(0.0011 * ((i * 37) % 2500) - 1.3);
            direction.push_back(i % 3 == 2 ? -1.0 : 0.3);
        }
        points = {point.data(), point_count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        directions = {direction.data(), point_count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    }
    std::vector<double> point, direction;
    hrbfnpr_array points, directions;
};

Bytes evaluate(const Scene& scene) {
    scenes::Check check;
    const Places places;
    Output output;
    const hrbfnpr_array_out value = output.add(point_count, 1);
    const hrbfnpr_array_out gradient = output.add(point_count, 3);
    const hrbfnpr_array_out hessian = output.add(point_count, 6);
    check(
        hrbfnpr_model_evaluate(scene.model.get(), &places.points, &value, &gradient, &hessian, nullptr, check.error()));
    return output.bytes();
}

Bytes project(const Scene& scene) {
    scenes::Check check;
    const Places places;
    Output output;
    auto projection = made(hrbfnpr_projection_init);
    projection.position = output.add(point_count, 3);
    projection.normal = output.add(point_count, 3);
    projection.status = output.add(point_count, 1, HRBFNPR_SCALAR_UINT8);
    check(hrbfnpr_model_project(scene.model.get(), &places.points, nullptr, &projection, nullptr, check.error()));
    return output.bytes();
}

Bytes curvature(const Scene& scene) {
    scenes::Check check;
    const Places places;
    Output output;
    auto result = made(hrbfnpr_curvature_init);
    result.k1 = output.add(point_count, 1);
    result.k2 = output.add(point_count, 1);
    result.d1 = output.add(point_count, 3);
    result.d2 = output.add(point_count, 3);
    result.confidence = output.add(point_count, 1);
    check(hrbfnpr_model_curvature(scene.model.get(), &places.points, &result, nullptr, check.error()));
    return output.bytes();
}

Bytes cast_rays(const Scene& scene) {
    scenes::Check check;
    const Places places;
    Output output;
    auto desc = made(hrbfnpr_cast_desc_init);
    desc.maximum_hits = 3;
    desc.t_min = -5.0;
    check(hrbfnpr_model_lipschitz(scene.model.get(), &desc.lipschitz, nullptr, check.error()));
    auto hits = made(hrbfnpr_ray_hits_init);
    hits.count = output.add(point_count, 1, HRBFNPR_SCALAR_UINT32);
    hits.t = output.add(point_count, 3);
    hits.position = output.add(point_count, 9);
    hits.normal = output.add(point_count, 9);
    hits.entering = output.add(point_count, 3, HRBFNPR_SCALAR_UINT8);
    hits.status = output.add(point_count, 1, HRBFNPR_SCALAR_UINT8);
    check(hrbfnpr_model_cast_rays(scene.model.get(), &places.points, &places.directions, &desc, &hits, nullptr,
                                  check.error()));
    return output.bytes();
}

Bytes contains(const Scene& scene) {
    scenes::Check check;
    const Places places;
    Output output;
    const hrbfnpr_array_out inside = output.add(point_count, 1, HRBFNPR_SCALAR_UINT8);
    check(hrbfnpr_model_contains(scene.model.get(), &places.points, &inside, nullptr, nullptr, check.error()));
    return output.bytes();
}

// Positions and ranks: a saved set would also tell how long it took.
Bytes bytes_of(const PointSet& marks) {
    scenes::Check check;
    Bytes bytes;
    auto info = made(hrbfnpr_point_set_info_init);
    check(hrbfnpr_point_set_get_info(marks.get(), &info, check.error()));
    for (std::int64_t layer = 0; layer < info.layers; ++layer)
        for (const std::uint32_t attribute : {HRBFNPR_MARK_ATTRIBUTE_POSITION, HRBFNPR_MARK_ATTRIBUTE_RANK}) {
            hrbfnpr_array view{};
            check(hrbfnpr_point_set_view(marks.get(), layer, attribute, &view, check.error()));
            const auto* data = static_cast<const std::uint8_t*>(view.data);
            if (view.count > 0) bytes.insert(bytes.end(), data, data + view.count * view.components * 4);
        }
    return bytes;
}

std::int32_t half_density(void* /*user*/, std::int64_t count, const double* positions, const double* /*normals*/,
                          double* density) {
    for (std::int64_t i = 0; i < count; ++i) density[i] = positions[3 * i] > 0.0 ? 1.0 : 0.5;
    return 0;
}

std::int32_t along_x(void* /*user*/, std::int64_t count, const double* /*positions*/, const double* /*normals*/,
                     double* directions) {
    for (std::int64_t i = 0; i < 3 * count; ++i) directions[i] = i % 3 == 0 ? 1.0 : 0.0;
    return 0;
}

Bytes generate_blue_noise(const Scene& scene) {
    Generation desc = three_layers(0);
    desc.shared_budget = 6000;
    desc.tone_ranges = HRBFNPR_TONE_RANGES_IN_TURN;
    for (hrbfnpr_layer_desc& layer : desc.layer) layer.flags = HRBFNPR_LAYER_WITH_CURVATURE;
    desc.layer[0].density = HRBFNPR_DENSITY_CALLBACK;
    desc.layer[0].density_function = half_density;
    desc.add(HRBFNPR_LAYER_KIND_HATCH, 40000).direction_function = along_x;
    Bytes bytes = bytes_of(generate(scene.context, scene.model, desc));
    desc.layer[1].guide = HRBFNPR_HATCH_GUIDE_SECTIONS;
    desc.layer[2].guide = HRBFNPR_HATCH_GUIDE_SILHOUETTE;
    desc.seed_source = HRBFNPR_SEED_BOX;
    desc.layer[0].density = HRBFNPR_DENSITY_CURVATURE;
    const Bytes more = bytes_of(generate(scene.context, scene.model, desc));
    bytes.insert(bytes.end(), more.begin(), more.end());
    return bytes;
}

Bytes generate_published(const Scene& scene) {
    Generation desc = three_layers(40000);
    desc.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
    for (hrbfnpr_layer_desc& layer : desc.layer) layer.levels = 2;
    desc.layer[2].start = HRBFNPR_STROKE_START_STIPPLES;
    hrbfnpr_layer_desc& along = desc.add(HRBFNPR_LAYER_KIND_HATCH, 40000);
    along.levels = 2;
    along.direction_function = along_x;
    return bytes_of(generate(scene.context, scene.model, desc));
}

Bytes step_patches(const Scene& scene) {
    scenes::Check check;
    Output output;
    const hrbfnpr_array_out corners = output.add(20, 12);
    check(hrbfnpr_point_set_step_patches(scene.context.get(), scene.model.get(), nullptr, &corners, nullptr, nullptr,
                                         check.error()));
    return output.bytes();
}

Bytes marks_from_arrays(const Scene& scene) {
    scenes::Check check;
    auto arrays = made(hrbfnpr_layer_arrays_init);
    check(hrbfnpr_model_view(scene.model.get(), HRBFNPR_MODEL_ATTRIBUTE_POSITION, &arrays.position, check.error()));
    check(hrbfnpr_model_view(scene.model.get(), HRBFNPR_MODEL_ATTRIBUTE_NORMAL, &arrays.normal, check.error()));
    const std::vector<std::uint32_t> first{0, 2, static_cast<std::uint32_t>(arrays.position.count)};
    arrays.stroke_first = {first.data(), 3, 0, HRBFNPR_SCALAR_UINT32, 1};
    auto desc = made(hrbfnpr_point_set_desc_init);
    desc.base = scene.marks.get();
    desc.layers = &arrays;
    desc.layer_count = 1;
    hrbfnpr_point_set* marks = nullptr;
    check(hrbfnpr_point_set_create(scene.context.get(), &desc, &marks, check.error()));
    return bytes_of(PointSet(marks));
}

hrbfnpr_camera front_camera() {
    scenes::Check check;
    auto camera = made(hrbfnpr_camera_init);
    const double low[3] = {-1.5, -1.5, -0.5};
    const double high[3] = {1.5, 1.5, 0.5};
    const double direction[3] = {0.0, 1.0, -1.0};
    const double up[3] = {0.0, 0.0, 1.0};
    check(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.5, picture_size, picture_size, 0.02,
                                    check.error()));
    return camera;
}

Drawing drawing_of(const Context& context, const PointSet& marks, const hrbfnpr_style* style, const hrbfnpr_model* rays,
                   const hrbfnpr_layer_pose* pose = nullptr, const hrbfnpr_line_set* lines = nullptr) {
    scenes::Check check;
    hrbfnpr_renderer* renderer = nullptr;
    check(hrbfnpr_renderer_create(context.get(), &renderer, check.error()));
    const Renderer owner(renderer);
    auto item = made(hrbfnpr_item_init);
    item.point_set = marks.get();
    item.style = style;
    item.model = rays;
    item.poses = pose;
    item.pose_count = pose != nullptr ? 1 : 0;
    item.line_set = lines;
    const hrbfnpr_camera camera = front_camera();
    hrbfnpr_drawing* drawing = nullptr;
    check(hrbfnpr_renderer_draw(renderer, &item, 1, 0, &camera, &drawing, check.error()));
    return Drawing(drawing);
}

Bytes drawn(const Drawing& drawing, const hrbfnpr_raster_desc* desc = nullptr) {
    scenes::Check check;
    Bytes pixels(std::size_t{4} * picture_size * picture_size);
    auto image = made(hrbfnpr_image_init);
    image.width = image.height = picture_size;
    image.pixels = pixels.data();
    check(hrbfnpr_drawing_rasterize(drawing.get(), &image, desc, check.error()));
    return pixels;
}

hrbfnpr_style preset_style(std::uint32_t preset) {
    scenes::Check check;
    hrbfnpr_style style;
    check(hrbfnpr_style_init_preset(&style, sizeof style, preset, check.error()));
    return style;
}

Bytes draw_presets(const Scene& scene) {
    Output output;
    for (std::uint32_t preset = 0; hrbfnpr_preset_name(preset) != nullptr; ++preset) {
        const hrbfnpr_style style = preset_style(preset);
        output.add(draw(scene.context, scene.marks, &style));
    }
    return output.bytes();
}

// Of every kind, hidden parts dashed.
Bytes draw_lines(const Scene& scene) {
    scenes::Check check;
    auto ridges = made(hrbfnpr_line_desc_init);
    auto desc = made(hrbfnpr_line_set_desc_init);
    desc.flags = HRBFNPR_LINE_SET_WITH_CURVATURE;
    desc.lines = &ridges;
    desc.line_count = 1;
    hrbfnpr_line_set* raw = nullptr;
    check(hrbfnpr_line_set_create(scene.context.get(), scene.model.get(), &desc, nullptr, &raw, check.error()));
    const LineSet lines(raw);
    std::vector<hrbfnpr_line_style> styles;
    double level = 0.5;
    for (std::uint32_t kind = HRBFNPR_LINE_KIND_CONTOUR; kind <= HRBFNPR_LINE_KIND_OWN; ++kind) {
        styles.push_back(made(hrbfnpr_line_style_init));
        styles.back().kind = kind;
        styles.back().hidden = HRBFNPR_HIDDEN_PARTS_DASHED;
        styles.back().levels = {&level, 1, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    }
    auto style = preset_style(HRBFNPR_PRESET_SILHOUETTE);
    style.lines = styles.data();
    style.line_count = static_cast<std::int64_t>(styles.size());
    return drawn(drawing_of(scene.context, scene.marks, &style, nullptr, nullptr, lines.get()));
}

Bytes draw_published(const Scene& scene) {
    hrbfnpr_style style = preset_style(HRBFNPR_PRESET_FULL);
    style.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
    return draw(scene.context, scene.marks, &style);
}

Bytes draw_with_rays(const Scene& scene) { return draw(scene.context, scene.marks, nullptr, scene.model.get()); }

Bytes draw_into_buffers(const Scene& scene) {
    static constexpr std::int64_t pixels = std::int64_t{picture_size} * picture_size;
    Output output;
    auto desc = made(hrbfnpr_raster_desc_init);
    const std::vector<float> host_depth(static_cast<std::size_t>(pixels), 1.0F);
    desc.flags = HRBFNPR_RASTER_LINEAR_LIGHT;
    desc.host_depth = {host_depth.data(), pixels, 0, HRBFNPR_SCALAR_FLOAT32, 1};
    desc.depth = output.add(pixels, 1, HRBFNPR_SCALAR_FLOAT32);
    desc.id = output.add(pixels, 1, HRBFNPR_SCALAR_UINT32);
    desc.mark_class = output.add(pixels, 1, HRBFNPR_SCALAR_UINT8);
    output.add(drawn(drawing_of(scene.context, scene.marks, nullptr, nullptr), &desc));
    return output.bytes();
}

Bytes write_vertices(const Scene& scene) {
    scenes::Check check;
    auto layer = made(hrbfnpr_layer_style_init);
    layer.shape = HRBFNPR_SHAPE_STROKES;
    auto style = made(hrbfnpr_style_init);
    style.layers = &layer;
    style.layer_count = 1;
    const Drawing drawing = drawing_of(scene.context, scene.marks, &style, nullptr);
    const std::uint32_t wanted[3][3] = {{HRBFNPR_VERTEX_ATTRIBUTE_POSITION, HRBFNPR_SCALAR_FLOAT32, 0},
                                        {HRBFNPR_VERTEX_ATTRIBUTE_RADIUS, HRBFNPR_SCALAR_FLOAT32, 12},
                                        {HRBFNPR_VERTEX_ATTRIBUTE_COLOR, HRBFNPR_SCALAR_UINT8, 16}};
    hrbfnpr_vertex_attribute attributes[3];
    for (int i = 0; i < 3; ++i) {
        attributes[i] = made(hrbfnpr_vertex_attribute_init);
        attributes[i].attribute = wanted[i][0];
        attributes[i].scalar = wanted[i][1];
        attributes[i].offset = wanted[i][2];
    }
    auto layout = made(hrbfnpr_vertex_layout_init);
    layout.attributes = attributes;
    layout.attribute_count = 3;
    Output output;
    for (layout.primitive = HRBFNPR_PRIMITIVE_POINTS; layout.primitive <= HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS;
         ++layout.primitive) {
        std::int64_t count = 0;
        std::int64_t indices = 0;
        check(hrbfnpr_drawing_vertex_bound(drawing.get(), layout.primitive, &count, &indices, check.error()));
        Bytes vertices(static_cast<std::size_t>(20 * count));
        std::vector<std::uint32_t> index(static_cast<std::size_t>(indices));
        check(hrbfnpr_drawing_write_vertices(drawing.get(), &layout, vertices.data(), count, &count, index.data(),
                                             indices, &indices, check.error()));
        output.add(vertices);
    }
    return output.bytes();
}

// Of the stipples.
Bytes mark_results(const Scene& scene) {
    scenes::Check check;
    const Drawing drawing = drawing_of(scene.context, scene.marks, nullptr, nullptr);
    auto layer = made(hrbfnpr_layer_info_init);
    check(hrbfnpr_point_set_get_layer_info(scene.marks.get(), 0, &layer, check.error()));
    Output output;
    auto results = made(hrbfnpr_mark_results_init);
    results.shown = output.add(layer.marks, 1, HRBFNPR_SCALAR_UINT8);
    results.radius = output.add(layer.marks, 1, HRBFNPR_SCALAR_FLOAT32);
    results.opacity = output.add(layer.marks, 1, HRBFNPR_SCALAR_FLOAT32);
    check(hrbfnpr_drawing_mark_results(drawing.get(), 0, 0, &results, check.error()));
    std::vector<std::uint32_t> indices(static_cast<std::size_t>(layer.marks));
    std::int64_t count = 0;
    check(hrbfnpr_drawing_write_mark_indices(drawing.get(), 0, 0, HRBFNPR_CLASS_FRONT, HRBFNPR_PRIMITIVE_POINTS,
                                             indices.data(), layer.marks, &count, check.error()));
    const auto* first = reinterpret_cast<const std::uint8_t*>(indices.data());
    output.add(Bytes(first, first + 4 * count));
    return output.bytes();
}

// Stipples that have moved up by a tenth.
Bytes draw_poses(const Scene& scene) {
    scenes::Check check;
    auto info = made(hrbfnpr_point_set_info_init);
    check(hrbfnpr_point_set_get_info(scene.marks.get(), &info, check.error()));
    auto pose = made(hrbfnpr_layer_pose_init);
    hrbfnpr_array view{};
    check(hrbfnpr_point_set_view(scene.marks.get(), 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &view, check.error()));
    check(hrbfnpr_point_set_view(scene.marks.get(), 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL, &pose.normal, check.error()));
    std::vector<double> moved;
    const auto* position = static_cast<const float*>(view.data);
    for (std::int64_t i = 0; i < 3 * view.count; ++i)
        moved.push_back(static_cast<double>(position[i]) + info.origin[i % 3] + (i % 3 == 2 ? 0.1 : 0.0));
    pose.position = {moved.data(), view.count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    return drawn(drawing_of(scene.context, scene.marks, nullptr, nullptr, &pose));
}

std::int32_t append(void* user, const void* data, std::uint64_t size) {
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    auto& all = *static_cast<Bytes*>(user);
    all.insert(all.end(), bytes, bytes + size);
    return 0;
}

// What is left to read of a saved file.
struct Source {
    Bytes bytes;
    std::size_t next = 0;
};

std::int64_t take(void* user, void* data, std::uint64_t size) {
    auto& source = *static_cast<Source*>(user);
    const std::size_t count = std::min<std::size_t>(size, source.bytes.size() - source.next);
    std::copy_n(source.bytes.begin() + static_cast<std::ptrdiff_t>(source.next), count,
                static_cast<std::uint8_t*>(data));
    source.next += count;
    return static_cast<std::int64_t>(count);
}

Bytes save_and_load(const Scene& scene) {
    scenes::Check check;
    Source model_file;
    Source marks_file;
    check(hrbfnpr_model_save(scene.model.get(), append, &model_file.bytes, check.error()));
    check(hrbfnpr_point_set_save(scene.marks.get(), append, &marks_file.bytes, check.error()));
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_load(scene.context.get(), take, &model_file, &model, check.error()));
    const Model loaded_model(model);
    hrbfnpr_point_set* marks = nullptr;
    check(hrbfnpr_point_set_load(scene.context.get(), take, &marks_file, &marks, check.error()));
    return bytes_of(PointSet(marks));
}

std::int32_t sphere(void* /*user*/, std::int64_t count, const double* points, double* value, double* /*gradient*/,
                    double* /*hessian*/) {
    for (std::int64_t i = 0; i < count; ++i) {
        const double* p = points + 3 * i;
        value[i] = 0.5 * (p[0] * p[0] + p[1] * p[1] + p[2] * p[2] - 1.0);
    }
    return 0;
}

// Differenced twice: a host's function is the most that a query calls.
Bytes custom_model(const Scene& scene) {
    scenes::Check check;
    auto desc = made(hrbfnpr_custom_desc_init);
    desc.function = sphere;
    for (int axis = 0; axis < 3; ++axis) {
        desc.bounds_min[axis] = -1.0;
        desc.bounds_max[axis] = 1.0;
    }
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_create_custom(scene.context.get(), &desc, &model, check.error()));
    hrbfnpr_context_retain(scene.context.get());
    const Scene custom(Context(scene.context.get()), Model(model));
    Output output;
    for (const auto run :
         {evaluate, project, curvature, cast_rays, contains, generate_blue_noise, draw_with_rays, draw_lines})
        output.add(run(custom));
    return output.bytes();
}

// Everything small: infos, cameras, operations, and calls that fail.
Bytes small_calls(const Scene& scene) {
    scenes::Check check;
    auto model_info = made(hrbfnpr_model_info_init);
    check(hrbfnpr_model_get_info(scene.model.get(), &model_info, check.error()));
    auto marks_info = made(hrbfnpr_point_set_info_init);
    check(hrbfnpr_point_set_get_info(scene.marks.get(), &marks_info, check.error()));
    auto context_info = made(hrbfnpr_context_info_init);
    check(hrbfnpr_context_get_info(scene.context.get(), &context_info, check.error()));
    const Context another = make_context(1);
    hrbfnpr_operation* operation = nullptr;
    check(hrbfnpr_operation_create(another.get(), &operation, check.error()));
    hrbfnpr_operation_cancel(operation);
    hrbfnpr_operation_release(operation);
    hrbfnpr_array centres{};
    check(hrbfnpr_model_view(scene.model.get(), HRBFNPR_MODEL_ATTRIBUTE_POSITION, &centres, check.error()));
    auto camera = front_camera();
    const double direction[3] = {0.0, 1.0, -1.0};
    const double up[3] = {0.0, 0.0, 1.0};
    check(hrbfnpr_camera_fit_points(&camera, &centres, nullptr, direction, up, 0.5, 100.0, 100.0, 0.02, check.error()));
    auto error = made(hrbfnpr_error_init);
    hrbfnpr_camera_perspective(&camera, 1.5, 100.5, 100.0, 2.5, 1.5, &error); // far before near
    Bytes statuses{static_cast<std::uint8_t>(error.status)};
    auto bad = made(hrbfnpr_generate_desc_init);
    bad.box_jitter = 0.75;
    hrbfnpr_point_set* none = nullptr;
    hrbfnpr_point_set_generate(scene.context.get(), scene.model.get(), &bad, nullptr, &none, &error);
    statuses.push_back(static_cast<std::uint8_t>(error.status));
    return statuses;
}

constexpr Step all_steps[] = {
    {"evaluate", evaluate},
    {"project", project},
    {"curvature", curvature},
    {"cast_rays", cast_rays},
    {"contains", contains},
    {"generate BLUE_NOISE", generate_blue_noise},
    {"generate PUBLISHED", generate_published},
    {"step_patches", step_patches},
    {"point_set_create", marks_from_arrays},
    {"custom model, all of these", custom_model},
    {"draw presets", draw_presets},
    {"draw lines", draw_lines},
    {"draw PUBLISHED", draw_published},
    {"draw, a model hides", draw_with_rays},
    {"draw into buffers", draw_into_buffers},
    {"write_vertices", write_vertices},
    {"mark_results", mark_results},
    {"draw poses", draw_poses},
    {"save and load", save_and_load},
    {"small calls", small_calls},
};

} // namespace

Bytes draw(const Context& context, const PointSet& marks, const hrbfnpr_style* style, const hrbfnpr_model* rays) {
    return drawn(drawing_of(context, marks, style, rays));
}

std::span<const Step> steps() { return all_steps; }

} // namespace host_test
