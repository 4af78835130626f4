// Loads a point set, and uses what loads: drawn twice, written as vertices, saved and loaded again.
#include "fuzz.h"

#include <cmath>

namespace {

using namespace fuzz;

constexpr int side = 32; // of the picture, in pixels

// The set's own box fills the picture; where that has no size, the box of a unit ball does.
hrbfnpr_camera camera_for(const hrbfnpr_point_set* set) {
    hrbfnpr_point_set_info info;
    hrbfnpr_point_set_info_init(&info, sizeof info);
    Call call("point_set_get_info");
    call.expect(hrbfnpr_point_set_get_info(set, &info, call.error()));
    const double direction[3] = {0.3, 0.2, -1};
    const double up[3] = {0, 1, 0};
    hrbfnpr_camera camera;
    hrbfnpr_camera_init(&camera, sizeof camera);
    Call fit("camera_fit_bounds");
    if (fit.expect(hrbfnpr_camera_fit_bounds(&camera, info.bounds_min, info.bounds_max, direction, up, 0.5, side, side,
                                             0.1, fit.error()),
                   {HRBFNPR_STATUS_INVALID_ARGUMENT}))
        return camera;
    const double low[3] = {-1, -1, -1};
    const double high[3] = {1, 1, 1};
    Call unit("camera_fit_bounds");
    unit.expect(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.5, side, side, 0.1, unit.error()));
    return camera;
}

void draw_image(hrbfnpr_renderer* renderer) {
    std::array<std::uint8_t, 4 * side * side> pixels{};
    std::array<float, side * side> depth{};
    hrbfnpr_image image;
    hrbfnpr_image_init(&image, sizeof image);
    image.width = image.height = side;
    image.pixels = pixels.data();
    hrbfnpr_draw_desc desc;
    hrbfnpr_draw_desc_init(&desc, sizeof desc);
    desc.depth = {depth.data(), static_cast<std::int64_t>(depth.size()), 0, HRBFNPR_SCALAR_FLOAT32, 1};
    Call call("renderer_draw_image");
    call.expect(hrbfnpr_renderer_draw_image(renderer, &image, &desc, call.error()));
    for (const float distance : depth) require(std::isfinite(distance), "the depth of a picture is finite");
}

// The vertices of a frame: position, radius, normal and direction.
void write_vertices(const hrbfnpr_renderer* renderer, std::int64_t shown) {
    constexpr std::uint32_t floats = 10;
    hrbfnpr_vertex_layout layout;
    hrbfnpr_vertex_layout_init(&layout, sizeof layout);
    layout.attribute_count = 4;
    layout.attributes[0] = {HRBFNPR_VERTEX_POSITION, HRBFNPR_SCALAR_FLOAT32, 0, 0};
    layout.attributes[1] = {HRBFNPR_VERTEX_NORMAL, HRBFNPR_SCALAR_FLOAT32, 12, 0};
    layout.attributes[2] = {HRBFNPR_VERTEX_DIRECTION, HRBFNPR_SCALAR_FLOAT32, 24, 0};
    layout.attributes[3] = {HRBFNPR_VERTEX_RADIUS, HRBFNPR_SCALAR_FLOAT32, 36, 0};
    std::int64_t bound = 0;
    Call ask("renderer_vertex_bound");
    ask.expect(hrbfnpr_renderer_vertex_bound(renderer, &bound, ask.error()));
    require(bound >= shown, "every mark of ink is a vertex");
    std::vector<float> vertices(floats * static_cast<std::size_t>(bound) + 1);
    std::int64_t written = 0;
    Call call("renderer_write_vertices");
    call.expect(hrbfnpr_renderer_write_vertices(renderer, &layout, vertices.data(), bound, &written, call.error()));
    require(written == bound, "the bound of vertices is their number");
    for (std::int64_t i = 0; i < written; ++i) {
        const float* const vertex = &vertices[floats * static_cast<std::size_t>(i)];
        require(std::isfinite(vertex[9]) && vertex[9] >= 0.0F, "the radius of a vertex is finite");
    }
}

// Whatever loads can be drawn, in every one of a few ways.
void draw(Context& context, const hrbfnpr_point_set* set, std::uint32_t choice) {
    hrbfnpr_renderer* renderer = nullptr;
    Call create("renderer_create");
    create.expect(hrbfnpr_renderer_create(context.handle, &renderer, create.error()));
    hrbfnpr_style style;
    Call preset("style_init_preset");
    preset.expect(
        hrbfnpr_style_init_preset(&style, sizeof style, choice % HRBFNPR_STYLE_COUNT, nullptr, preset.error()));
    if (choice / 8 % 2 != 0) style.visibility = HRBFNPR_VISIBILITY_PAINTED;
    hrbfnpr_item item;
    hrbfnpr_item_init(&item, sizeof item);
    item.point_set = set;
    item.style = &style;
    const hrbfnpr_camera camera = camera_for(set);
    hrbfnpr_frame_info info;
    hrbfnpr_frame_info_init(&info, sizeof info);
    Call prepare("renderer_prepare");
    prepare.expect(hrbfnpr_renderer_prepare(renderer, &item, 1, 0, &camera, &info, prepare.error()));
    require(info.marks == info.outside + info.front + info.back + info.silhouette + info.culled,
            "every mark of a frame has a class");
    draw_image(renderer);
    write_vertices(renderer, info.shown);
    hrbfnpr_renderer_release(renderer);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes file = signed_file(data, size);
    Context context;
    auto* const set = load<hrbfnpr_point_set>(context, file, hrbfnpr_point_set_load_memory);
    if (set == nullptr) return 0;
    require_sound_marks(set);
    require_same_set(context, set);
    draw(context, set, choice_of(file));
    hrbfnpr_point_set_release(set);
    return 0;
}
