// SPDX-License-Identifier: MIT
// Tests unusual inputs: units of 1e-30 and 1e30, a handful of samples, cameras inside the surface or as wide as the
// world, images of one pixel. Each call, from a fit to a page, succeeds or is refused with a message.
#include "fixture.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace api_test::edges_test {
namespace {

constexpr double pi = std::numbers::pi;

scenes::Samples times(scenes::Samples samples, double by) {
    for (double& coordinate : samples.points) coordinate *= by;
    return samples;
}

// Returns whether the call succeeded; otherwise expects a message.
bool is_served(hrbfnpr_status status, const Error& error) {
    if (status == HRBFNPR_STATUS_OK) return true;
    EXPECT_STRNE(error.record.message, "") << hrbfnpr_status_name(status);
    return false;
}

Model fitted(const Context& context, const scenes::Samples& samples) {
    Error error;
    const hrbfnpr_fit_desc desc = fit_desc(samples);
    hrbfnpr_model* model = nullptr;
    const hrbfnpr_status status = hrbfnpr_model_fit(context.get(), &desc, nullptr, &model, error);
    EXPECT_EQ(is_served(status, error), model != nullptr);
    return Model(model);
}

PointSet marked(const Context& context, const Model& model) {
    Error error;
    Generation desc = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 300);
    desc.add(HRBFNPR_LAYER_KIND_HATCH, 300);
    hrbfnpr_point_set* set = nullptr;
    const hrbfnpr_status status =
        hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &set, error);
    EXPECT_EQ(is_served(status, error), set != nullptr);
    return PointSet(set);
}

hrbfnpr::test::LineSet lined(const Context& context, const Model& model) {
    Error error;
    hrbfnpr_line_set* lines = nullptr;
    const hrbfnpr_status status = hrbfnpr_line_set_create(context.get(), model.get(), nullptr, nullptr, &lines, error);
    EXPECT_EQ(is_served(status, error), lines != nullptr);
    return hrbfnpr::test::LineSet(lines);
}

hrbfnpr_camera camera_of(const PointSet& set, double size = 96.0) {
    Error error;
    const hrbfnpr_point_set_info info = info_of(set);
    auto camera = made(hrbfnpr_camera_init);
    const double direction[3] = {0.2, -0.6, -0.7};
    const double up[3] = {0.0, 1.0, 0.0};
    EXPECT_OK(hrbfnpr_camera_fit_bounds(&camera, info.bounds_min, info.bounds_max, direction, up, 0.6, size, size, 0.05,
                                        error));
    return camera;
}

std::int32_t append(void* user, const void* data, std::uint64_t size) {
    static_cast<std::string*>(user)->append(static_cast<const char*>(data), size);
    return 0;
}

std::string page_of(const Context& context, const Drawing& drawing) {
    Error error;
    auto item = made(hrbfnpr_page_item_init);
    item.drawing = drawing.get();
    auto desc = made(hrbfnpr_page_desc_init);
    desc.items = &item;
    desc.item_count = 1;
    std::string text;
    EXPECT_OK(hrbfnpr_page_write(context.get(), &desc, append, &text, nullptr, nullptr, error));
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf\""), std::string::npos);
    return text;
}

std::vector<std::uint8_t> rasterize(const Drawing& drawing, std::int32_t width, std::int32_t height) {
    Error error;
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(4) * static_cast<std::size_t>(width) *
                                     static_cast<std::size_t>(height));
    auto image = made(hrbfnpr_image_init);
    image.width = width;
    image.height = height;
    image.pixels = pixels.data();
    EXPECT_OK(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, error));
    return pixels;
}

hrbfnpr_style preset(std::uint32_t which) {
    Error error;
    hrbfnpr_style style;
    EXPECT_OK(hrbfnpr_style_init_preset(&style, sizeof style, which, error));
    return style;
}

// Everything that a style needs of one model.
struct Scene {
    Scene(const Context& from, const scenes::Samples& samples) : context(from), model(fitted(from, samples)) {
        if (model == nullptr) return;
        marks = marked(context, model);
        lines = lined(context, model);
    }
    [[nodiscard]] Drawing draw(const hrbfnpr_camera& camera, const hrbfnpr_style& style) const {
        hrbfnpr_item item = item_of(marks, &style);
        item.model = model.get();
        item.line_set = lines.get();
        return draw_item(make_renderer(context), item, camera);
    }

    const Context& context;
    Model model;
    PointSet marks;
    hrbfnpr::test::LineSet lines;
};

double mean_difference(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(int{a[i]} - int{b[i]});
    return sum / static_cast<double>(a.size());
}

// ---- units -----------------------------------------------------------------------------------

TEST(Edges, TheUnitOfLengthDoesNotChangeTheDrawing) {
    const Context context = make_context();
    const Scene unit(context, scenes::torus(100));
    for (const std::uint32_t which : {HRBFNPR_PRESET_FULL, HRBFNPR_PRESET_ETCHING, HRBFNPR_PRESET_XRAY}) {
        const hrbfnpr_style style = preset(which);
        const std::vector<std::uint8_t> expected = rasterize(unit.draw(camera_of(unit.marks), style), 96, 96);
        ASSERT_GT(mean_difference(expected, std::vector<std::uint8_t>(expected.size(), 255)), 2.0) << "no ink";
        for (const int power : {-100, 100}) { // 8e-31 and 1e30
            const Scene scene(context, times(scenes::torus(100), std::ldexp(1.0, power)));
            ASSERT_TRUE(scene.marks != nullptr && scene.lines != nullptr);
            const Drawing drawing = scene.draw(camera_of(scene.marks), style);
            EXPECT_LT(mean_difference(rasterize(drawing, 96, 96), expected), 0.01)
                << "preset " << which << " 2^" << power;
            EXPECT_GT(page_of(context, drawing).size(), 1000U);
        }
    }
}

// ---- samples ---------------------------------------------------------------------------------

struct Few {
    const char* name;
    scenes::Samples samples;
};

scenes::Samples grid(int columns, int rows, int times) {
    scenes::Samples samples;
    for (int i = 0; i < columns * rows * times; ++i) {
        const int place = i % (columns * rows);
        samples.points.insert(samples.points.end(), {0.1 * (place % columns), 0.1 * (place / columns), 0.0});
        samples.normals.insert(samples.normals.end(), {0.0, 0.0, 1.0});
    }
    return samples;
}

scenes::Samples repeated(const scenes::Samples& samples, int count) {
    scenes::Samples all;
    for (int i = 0; i < count; ++i) {
        all.points.insert(all.points.end(), samples.points.begin(), samples.points.end());
        all.normals.insert(all.normals.end(), samples.normals.begin(), samples.normals.end());
    }
    return all;
}

scenes::Samples contradiction() {
    scenes::Samples samples = grid(1, 1, 2);
    samples.normals.back() = -1.0;
    return samples;
}

std::vector<Few> few_samples() {
    return {{"one", grid(1, 1, 1)},
            {"two", grid(2, 1, 1)},
            {"three", grid(3, 1, 1)},
            {"a line", grid(20, 1, 1)},
            {"a plane", grid(8, 8, 1)},
            {"one, a hundred times", grid(1, 1, 100)},
            {"a sphere, a hundred times", repeated(scenes::sphere_6(), 100)},
            {"a plane, a hundred times", grid(5, 5, 100)},
            {"a contradiction", contradiction()}};
}

TEST(Edges, FewSamplesAreDrawnOrRefusedWithAReason) {
    const Context context = make_context();
    for (const Few& few : few_samples()) {
        SCOPED_TRACE(few.name);
        const Scene scene(context, few.samples);
        if (scene.marks == nullptr) continue;
        for (const float number : attribute<float>(scene.marks, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION))
            ASSERT_TRUE(std::isfinite(number));
        for (const std::uint32_t which : {HRBFNPR_PRESET_FULL, HRBFNPR_PRESET_ETCHING, HRBFNPR_PRESET_XRAY}) {
            const Drawing drawing = scene.draw(camera_of(scene.marks), preset(which));
            rasterize(drawing, 96, 96);
            page_of(context, drawing);
        }
    }
}

TEST(Edges, AHundredCopiesOfASampleCountAsOne) {
    const Context context = make_context();
    Error error;
    const Model model = fitted(context, repeated(scenes::sphere_6(), 100));
    ASSERT_TRUE(model);
    auto info = made(hrbfnpr_model_info_init);
    ASSERT_OK(hrbfnpr_model_get_info(model.get(), &info, error));
    EXPECT_EQ(info.centres, 6);
}

// ---- cameras ---------------------------------------------------------------------------------

hrbfnpr_camera looking(const double (&eye)[3], const double (&target)[3], double degrees) {
    Error error;
    auto camera = made(hrbfnpr_camera_init);
    const double up[3] = {0.0, 1.0, 0.3};
    EXPECT_OK(hrbfnpr_camera_look_at(&camera, eye, target, up, error));
    const double distance = std::hypot(eye[0] - target[0], eye[1] - target[1], eye[2] - target[2]);
    EXPECT_OK(hrbfnpr_camera_perspective(&camera, degrees * pi / 180.0, 96, 96, 1e-3 * distance, 3.0 * distance + 10.0,
                                         error));
    return camera;
}

// The torus about z has the radii 1 and 0.4.
std::vector<hrbfnpr_camera> odd_cameras() {
    return {looking({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 60.0),     // inside the tube
            looking({1.4, 0.0, 0.0}, {0.0, 0.0, 0.0}, 60.0),     // on the surface, inward
            looking({1.4, 0.0, 0.0}, {5.0, 0.0, 0.0}, 60.0),     // on the surface, outward
            looking({1.4, 0.0, 0.0}, {1.4, 1.0, 0.0}, 60.0),     // on the surface, along it
            looking({0.0, 0.0, 4.0}, {0.0, 0.0, 0.0}, 40.0),     // along the axis
            looking({0.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, 60.0),    // in the middle of the hole
            looking({4.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 40.0),     // in a plane of symmetry
            looking({0.0, 0.0, 17000.0}, {0.0, 0.0, 0.0}, 0.01), // narrow
            looking({0.0, -0.3, 2.0}, {0.0, 0.0, 0.0}, 179.0),   // wide
            looking({1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 179.0),    // wide, from the inside
            looking({0.0, 0.0, 1e9}, {0.0, 0.0, 0.0}, 40.0),     // all in less than a pixel
            looking({0.0, 0.0, 4.0}, {0.0, 0.0, 9.0}, 40.0)};    // all behind the camera
}

TEST(Edges, UnusualCamerasGiveAPicture) {
    const Context context = make_context();
    const Scene scene(context, scenes::torus(100));
    const std::vector<hrbfnpr_camera> cameras = odd_cameras();
    for (std::size_t i = 0; i < cameras.size(); ++i) {
        SCOPED_TRACE(i);
        for (std::uint32_t which = 0; hrbfnpr_preset_name(which) != nullptr; ++which) {
            const Drawing drawing = scene.draw(cameras[i], preset(which));
            rasterize(drawing, 96, 96);
            page_of(context, drawing);
        }
    }
}

TEST(Edges, AVeryNarrowCameraMatchesAnOrthographicOne) {
    const Context context = make_context();
    const Scene scene(context, scenes::torus(100));
    Error error;
    hrbfnpr_camera narrow = looking({0.0, -12000.0, 12000.0}, {0.0, 0.0, 0.0}, 0.01);
    hrbfnpr_camera flat = narrow;
    const double height = 2.0 * std::hypot(12000.0, 12000.0) * std::tan(0.005 * pi / 180.0);
    ASSERT_OK(hrbfnpr_camera_orthographic(&flat, height, 96, 96, 10.0, 50000.0, error));
    for (const std::uint32_t which : {HRBFNPR_PRESET_FULL, HRBFNPR_PRESET_ETCHING, HRBFNPR_PRESET_XRAY}) {
        const std::vector<std::uint8_t> expected = rasterize(scene.draw(flat, preset(which)), 96, 96);
        EXPECT_GT(mean_difference(expected, std::vector<std::uint8_t>(expected.size(), 255)), 2.0) << "no ink";
        EXPECT_LT(mean_difference(rasterize(scene.draw(narrow, preset(which)), 96, 96), expected), 1.0) << which;
    }
}

TEST(Edges, NothingBehindTheEyeIsDrawn) {
    const Context context = make_context();
    const Scene scene(context, scenes::torus(100));
    const hrbfnpr_drawing_info info = info_of(scene.draw(odd_cameras().back(), preset(HRBFNPR_PRESET_FULL)));
    EXPECT_EQ(info.dots, 0);
    EXPECT_EQ(info.strokes, 0);
}

// ---- images ----------------------------------------------------------------------------------

TEST(Edges, ImagesOfOnePixelOrOneRowAreDrawn) {
    const Context context = make_context();
    const Scene scene(context, scenes::torus(100));
    constexpr std::int32_t sizes[][2] = {{1, 1}, {32768, 1}, {1, 32768}, {2, 3}};
    for (const auto& size : sizes) {
        SCOPED_TRACE(size[0]);
        hrbfnpr_camera camera = camera_of(scene.marks, 96.0);
        camera.viewport[2] = size[0];
        camera.viewport[3] = size[1];
        for (const std::uint32_t which : {HRBFNPR_PRESET_FULL, HRBFNPR_PRESET_ETCHING, HRBFNPR_PRESET_XRAY}) {
            const Drawing drawing = scene.draw(camera, preset(which));
            rasterize(drawing, size[0], size[1]);
            page_of(context, drawing);
        }
    }
}

} // namespace
} // namespace api_test::edges_test
