// SPDX-License-Identifier: MIT
// Draws marks and lines with any cameras, styles, fields, items and poses, and uses the drawings.
#include "arrays.h"
#include "drawings.h"
#include "fields.h"
#include "limits.h"
#include "painted.h"
#include "scenes.h"
#include "support/preset_names.h"

#include <optional>

namespace {

using namespace fuzz;

constexpr std::initializer_list<hrbfnpr_status> failures = {
    HRBFNPR_STATUS_INVALID_ARGUMENT, HRBFNPR_STATUS_OUT_OF_MEMORY, HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
    HRBFNPR_STATUS_CALLBACK, HRBFNPR_STATUS_CANCELLED};

std::int32_t tone(void* user, std::int64_t count, const float* positions, const float*, float* tau) {
    const float number = *static_cast<const float*>(user);
    for (std::int64_t i = 0; i < count; ++i) tau[i] = positions[3 * i] > 0.0F ? 0.2F : number;
    return 0;
}

// A style and the lists that it refers to.
struct Style {
    explicit Style(Input& input) {
        Call call("style_init_preset");
        call.expect(hrbfnpr_style_init_preset(
            &style, sizeof style, static_cast<std::uint32_t>(input.below(std::size(hrbfnpr::testing::preset_names))),
            call.error()));
        const auto* const own = reinterpret_cast<const unsigned char*>(style.layers);
        for (std::int64_t i = 0; i < style.layer_count; ++i)
            layers.push_back(*reinterpret_cast<const hrbfnpr_layer_style*>(
                own + i * (style.layer_stride != 0 ? style.layer_stride : style.layers->struct_size)));
        const auto* const given = reinterpret_cast<const unsigned char*>(style.lines);
        for (std::int64_t i = 0; i < style.line_count; ++i)
            lines.push_back(*reinterpret_cast<const hrbfnpr_line_style*>(
                given + i * (style.line_stride != 0 ? style.line_stride : style.lines->struct_size)));
        if (layers.empty() || input.once_in(4)) add_layer(input);
        for (std::size_t more = input.once_in(2) ? 1 + input.below(4) : 0; more > 0; --more) add_line(input);
        for (hrbfnpr_layer_style& layer : layers)
            if (input.once_in(2)) change_fields(input, "hrbfnpr_layer_style", &layer);
        for (hrbfnpr_line_style& line : lines)
            if (input.once_in(2)) change_fields(input, "hrbfnpr_line_style", &line);
        number = input.once_in(4) ? odd_float(0.5F, 1.0F, input) : static_cast<float>(input.unit());
        if (input.once_in(4)) style.tone = HRBFNPR_TONE_CALLBACK;
        style.tone_function = input.once_in(8) ? nullptr : tone;
        style.tone_user = &number;
        if (input.once_in(6)) style.visibility = HRBFNPR_VISIBILITY_PUBLISHED;
        for (std::size_t more = input.once_in(3) ? 1 + input.below(9) : 0; more > 0; --more) add_light(input);
        if (input.once_in(3)) style.ambient_sky = static_cast<float>(input.unit());
        change_fields(input, "hrbfnpr_style", &style);
        refer();
    }
    Style(const Style&) = delete;
    Style& operator=(const Style&) = delete;

    // Lets the layers name fields of painted sets.
    void use_fields(Input& input) {
        static constexpr const char* hrbfnpr_layer_style::*numbers[] = {
            &hrbfnpr_layer_style::density_field, &hrbfnpr_layer_style::tone_field, &hrbfnpr_layer_style::width_field,
            &hrbfnpr_layer_style::mask_field};
        for (hrbfnpr_layer_style& layer : layers) {
            for (const auto name : numbers)
                if (input.once_in(2)) layer.*name = field_names[HRBFNPR_FIELD_KIND_SCALAR];
            if (input.once_in(2)) layer.ink_field = field_names[HRBFNPR_FIELD_KIND_COLOUR];
            layer.tone_field_rule = static_cast<std::uint32_t>(input.below(2));
            layer.palette_rule = static_cast<std::uint32_t>(input.below(2));
        }
        for (float& ink : inks) ink = static_cast<float>(input.unit());
        if (input.once_in(16)) inks[input.below(std::size(inks))] = odd_float(0.5F, 1.0F, input);
        style.palette = inks;
        style.palette_count = static_cast<std::int64_t>(input.below(9));
    }

    hrbfnpr_style style;

private:
    void add_layer(Input& input) {
        hrbfnpr_layer_style layer;
        hrbfnpr_layer_style_init(&layer, sizeof layer);
        layer.shape = static_cast<std::uint32_t>(input.below(3));
        layers.push_back(layer);
    }
    void add_line(Input& input) {
        hrbfnpr_line_style line;
        hrbfnpr_line_style_init(&line, sizeof line);
        line.kind = 1 + static_cast<std::uint32_t>(input.below(10));
        line.hidden = static_cast<std::uint32_t>(input.below(4));
        line.cap = static_cast<std::uint32_t>(input.below(3));
        if (line.kind == HRBFNPR_LINE_KIND_ISOPHOTE) line.levels = {levels, 2, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        if (line.kind == HRBFNPR_LINE_KIND_SUGGESTIVE_CONTOUR || line.kind == HRBFNPR_LINE_KIND_APPARENT_RIDGE) {
            line.lower = 0.5;
            line.upper = 1.0;
        }
        lines.push_back(line);
    }
    void add_light(Input& input) {
        hrbfnpr_light light;
        hrbfnpr_light_init(&light, sizeof light);
        light.kind = static_cast<std::uint32_t>(input.below(2));
        light.space = static_cast<std::uint32_t>(input.below(3));
        light.shadow = static_cast<float>(input.unit());
        light.softness = input.once_in(2) ? 0.1F : 0.0F;
        if (input.once_in(2)) change_fields(input, "hrbfnpr_light", &light);
        lights.push_back(light);
    }
    void refer() {
        style.lights = lights.data();
        style.light_count = static_cast<std::int64_t>(lights.size());
        style.light_stride = sizeof(hrbfnpr_light);
        style.layers = layers.data();
        style.layer_count = static_cast<std::int64_t>(layers.size());
        style.layer_stride = sizeof(hrbfnpr_layer_style);
        style.lines = lines.data();
        style.line_count = static_cast<std::int64_t>(lines.size());
        style.line_stride = sizeof(hrbfnpr_line_style);
    }

    static constexpr double levels[] = {0.1, 0.6};
    float inks[4 * 8]{};
    std::vector<hrbfnpr_layer_style> layers;
    std::vector<hrbfnpr_line_style> lines;
    std::vector<hrbfnpr_light> lights;
    float number = 0.5F;
};

// Moves the marks of one layer to a ball, sometimes with one odd number.
struct Pose {
    Pose(const hrbfnpr_point_set* set, Input& input) : numbers(numbers_of(set, input)), array(numbers, 3, input) {
        hrbfnpr_layer_pose_init(&pose, sizeof pose);
        pose.position = array.view;
        pose.normal = array.view;
        if (input.once_in(3)) pose.direction = array.view;
        change_fields(input, "hrbfnpr_layer_pose", &pose);
    }

    static std::vector<double> numbers_of(const hrbfnpr_point_set* set, Input& input) {
        Call call("point_set_view");
        hrbfnpr_array normal;
        call.expect(hrbfnpr_point_set_view(set, 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL, &normal, call.error()));
        const std::span from(static_cast<const float*>(normal.data), static_cast<std::size_t>(3 * normal.count));
        std::vector<double> numbers(from.begin(), from.end());
        if (!numbers.empty() && input.once_in(4)) {
            double& number = numbers[input.below(numbers.size())];
            number = odd_float(number, 0.0, input);
        }
        return numbers;
    }

    std::vector<double> numbers;
    Array array;
    hrbfnpr_layer_pose pose;
};

void change_transform(hrbfnpr_item& item, Input& input) {
    if (input.once_in(3)) item.transform[12] = input.between(-2.0, 2.0);
    if (input.once_in(4)) item.transform[0] *= input.between(-2.0, 2.0);
    if (input.once_in(4)) item.transform[5] *= input.between(0.0, 3.0);
    if (input.once_in(8)) item.transform[4] = input.between(-1.0, 1.0);
}

hrbfnpr_item some_item(const hrbfnpr_point_set* set, const Style& style, const Pose& pose, Input& input) {
    hrbfnpr_item item;
    hrbfnpr_item_init(&item, sizeof item);
    item.point_set = input.once_in(16) ? nullptr : set;
    item.style = input.once_in(8) ? nullptr : &style.style;
    const std::size_t lines = input.below(2 * line_set_count);
    if (lines < line_set_count) item.line_set = scene_lines(lines);
    if (input.once_in(6)) item.model = scene_model(input.below(model_count));
    if (input.once_in(6)) {
        item.poses = &pose.pose;
        item.pose_count = 1;
        item.pose_stride = sizeof pose.pose;
    }
    change_transform(item, input);
    if (input.once_in(3)) item.sides = static_cast<std::uint32_t>(input.below(3));
    if (input.once_in(4)) change_fields(input, "hrbfnpr_item", &item);
    return item;
}

// Returns one item, a few, or enough to make the renderer's lists grow on the way.
std::size_t count_of_items(Input& input) {
    if (!input.once_in(4)) return 1;
    const std::size_t count = input.below(16);
    return 1 + (count < 12 ? count % 3 : count);
}

hrbfnpr_camera some_camera(Input& input) {
    const double low[3] = {-1.4, -1.4, -1.0};
    const double high[3] = {1.4, 1.4, 1.0};
    const double direction[3] = {input.between(-1.0, 1.0), input.between(-1.0, 1.0), input.between(-1.0, 1.0)};
    const double up[3] = {0.1, 1.0, 0.2};
    hrbfnpr_camera camera;
    hrbfnpr_camera_init(&camera, sizeof camera);
    camera.depth_convention = static_cast<std::uint32_t>(input.below(3));
    Call call("camera_fit_bounds");
    call.expect(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, input.once_in(3) ? 0.0 : 0.6,
                                          static_cast<double>(1 + input.below(64)),
                                          static_cast<double>(1 + input.below(64)), 0.05, call.error()),
                failures);
    if (input.once_in(4)) change_fields(input, "hrbfnpr_camera", &camera);
    return camera;
}

hrbfnpr_drawing* draw(hrbfnpr_renderer* renderer, std::span<const hrbfnpr_item> items, const hrbfnpr_camera& camera,
                      Input& input, Input& ending) {
    const Operation operation(scene_context(), ending);
    const ShortMemory memory(scene_context(), input);
    hrbfnpr_drawing* drawing = nullptr;
    Call call("renderer_draw_with_operation");
    const hrbfnpr_status status =
        hrbfnpr_renderer_draw_with_operation(renderer, items.data(), static_cast<std::int64_t>(items.size()),
                                             sizeof(hrbfnpr_item), &camera, operation.handle, &drawing, call.error());
    operation.check(status);
    const bool drawn = call.expect(status, failures);
    require(drawn == (drawing != nullptr), "a handle comes with success only");
    return drawing;
}

// Returns how much light reaches the marks of the first item, or null.
hrbfnpr_shading* some_shading(std::span<const hrbfnpr_item> items, const hrbfnpr_camera& camera, Input& input) {
    hrbfnpr_occluders* occluders = nullptr;
    Call gather("occluders_create");
    const bool gathered = gather.expect(
        hrbfnpr_occluders_create(scene_context().handle, items.data(), static_cast<std::int64_t>(items.size()),
                                 sizeof(hrbfnpr_item), nullptr, &occluders, gather.error()),
        failures);
    if (!gathered) return nullptr;
    hrbfnpr_shading_desc desc;
    hrbfnpr_shading_desc_init(&desc, sizeof desc);
    desc.sky_rays = desc.shadow_rays = 4;
    if (input.once_in(3)) change_fields(input, "hrbfnpr_shading_desc", &desc);
    desc.sky_rays = std::min(desc.sky_rays, 64); // The fuzzer would spend its time on rays.
    desc.shadow_rays = std::min(desc.shadow_rays, 64);
    hrbfnpr_shading* shading = nullptr;
    Call call("shading_create");
    call.expect(hrbfnpr_shading_create(scene_context().handle, occluders, items.data(),
                                       input.once_in(8) ? nullptr : &camera, &desc, nullptr, &shading, call.error()),
                failures);
    hrbfnpr_occluders_release(occluders);
    return shading;
}

void use(const hrbfnpr_drawing* drawing, const hrbfnpr_camera& camera, Input& input) {
    if (drawing == nullptr) return;
    require_sound_drawing(drawing);
    rasterize(drawing, camera, input);
    write_vertices(drawing, input);
    ask_for_marks(drawing, input);
    if (input.once_in(3)) write_page(drawing, input);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Input input(data, size);
    Input ending(size > 0 ? data + size - 1 : data,
                 size > 0 ? 1 : 0); // the end of the first drawing depends on the last byte
    Style style(input);
    const std::size_t count = count_of_items(input);
    const hrbfnpr_point_set* const set = scene_set(input.below(set_count));
    const Pose pose(set, input);
    std::vector<hrbfnpr_item> items;
    for (std::size_t i = 0; i < count; ++i)
        items.push_back(some_item(i == 0 ? set : scene_set(input.below(set_count)), style, pose, input));
    hrbfnpr_camera camera = some_camera(input);
    hrbfnpr_renderer* renderer = nullptr;
    Call create("renderer_create");
    create.expect(hrbfnpr_renderer_create(scene_context().handle, &renderer, create.error()));
    hrbfnpr_shading* const shading = input.once_in(4) ? some_shading(items, camera, input) : nullptr;
    if (shading != nullptr) items[input.below(items.size())].shading = shading;
    std::optional<Paint> paint;
    if (input.once_in(2)) {
        paint.emplace(input);
        for (hrbfnpr_item& item : items)
            if (item.point_set != nullptr) item.point_set = paint->on(item.point_set, input);
        style.use_fields(input);
    }
    hrbfnpr_drawing* const first = draw(renderer, items, camera, input, ending);
    use(first, camera, input);
    if (input.once_in(3)) { // the lines start from those of the first drawing
        camera.view[12] += input.between(-0.1, 0.1);
        camera.view[0] *= input.between(0.99, 1.01);
        hrbfnpr_drawing* const second = draw(renderer, items, camera, input, ending);
        use(second, camera, input);
        hrbfnpr_drawing_release(second);
    }
    hrbfnpr_drawing_release(first);
    hrbfnpr_shading_release(shading);
    hrbfnpr_renderer_release(renderer);
    return 0;
}
