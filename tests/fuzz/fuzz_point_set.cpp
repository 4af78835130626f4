#include "fuzz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace {

// Whatever loads can be drawn.
void draw(hrbfnpr_context* context, const hrbfnpr_point_set* set) {
    hrbfnpr_renderer* renderer = nullptr;
    if (hrbfnpr_renderer_create(context, &renderer, nullptr) != HRBFNPR_STATUS_OK) return;
    hrbfnpr_item item;
    hrbfnpr_item_init(&item, sizeof item);
    item.point_set = set;
    hrbfnpr_camera camera;
    hrbfnpr_camera_init(&camera, sizeof camera);
    const double low[3] = {-1, -1, -1};
    const double high[3] = {1, 1, 1};
    const double direction[3] = {0, 0, -1};
    const double up[3] = {0, 1, 0};
    hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.5, 32, 32, 0.1, nullptr);
    std::uint8_t pixels[4 * 32 * 32];
    hrbfnpr_image image;
    hrbfnpr_image_init(&image, sizeof image);
    image.width = image.height = 32;
    image.pixels = pixels;
    if (hrbfnpr_renderer_prepare(renderer, &item, 1, 0, &camera, nullptr, nullptr) == HRBFNPR_STATUS_OK)
        hrbfnpr_renderer_draw_image(renderer, &image, nullptr, nullptr);
    hrbfnpr_renderer_release(renderer);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::vector<std::uint8_t> file = fuzz::signed_file(data, size);
    hrbfnpr_context* context = fuzz::context();
    hrbfnpr_point_set* set = nullptr;
    const auto length = static_cast<std::int64_t>(file.size());
    fuzz::expect_clean(hrbfnpr_point_set_load_memory(context, file.data(), length, &set, nullptr));
    if (set != nullptr) draw(context, set);
    hrbfnpr_point_set_release(set);
    hrbfnpr_context_release(context);
    return 0;
}
