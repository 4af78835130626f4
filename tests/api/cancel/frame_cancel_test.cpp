// SPDX-License-Identifier: MIT
// Tests cancelled frames: no drawing is made, and renderer and earlier drawings stay as if the call had not been made.
#include "stages/stage.h"
#include "support/handles.h"

#include <cmath>
#include <set>

namespace api_test::frame_cancel_test {
namespace {

using hrbfnpr::test::LineSet;

constexpr std::int32_t side = 64;

// A torus with hatching, dots and lines that need rays.
struct Scene {
    explicit Scene(std::int32_t threads) : context(make_context(threads)), model(fit(context, scenes::torus(80))) {
        Error error;
        Generation desc = small_desc(HRBFNPR_DISTRIBUTION_BLUE_NOISE);
        hrbfnpr_point_set* generated = nullptr;
        EXPECT_OK(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &generated, error));
        set.reset(generated);
        auto lines_desc = made(hrbfnpr_line_set_desc_init);
        hrbfnpr_line_set* traced = nullptr;
        EXPECT_OK(hrbfnpr_line_set_create(context.get(), model.get(), &lines_desc, nullptr, &traced, error));
        lines.reset(traced);
        line = made(hrbfnpr_line_style_init);
        line.kind = HRBFNPR_LINE_KIND_CONTOUR;
        line.hidden = HRBFNPR_HIDDEN_PARTS_DASHED;
        style = made(hrbfnpr_style_init);
        style.lines = &line;
        style.line_count = 1;
        item = item_of(set, &style);
        item.line_set = lines.get();
        item.model = model.get();
        renderer = make_renderer(context);
    }

    hrbfnpr_status draw(double turned, hrbfnpr_operation* operation, Drawing& drawing, hrbfnpr_error* error) {
        auto camera = front_camera(side);
        const double cosine = std::cos(turned), sine = std::sin(turned);
        auto posed = item;
        posed.transform[0] = posed.transform[10] = cosine;
        posed.transform[2] = -sine;
        posed.transform[8] = sine;
        hrbfnpr_drawing* out = nullptr;
        const hrbfnpr_status status =
            hrbfnpr_renderer_draw_with_operation(renderer.get(), &posed, 1, 0, &camera, operation, &out, error);
        EXPECT_EQ(out != nullptr, status == HRBFNPR_STATUS_OK);
        drawing.reset(out);
        return status;
    }

    // The pixels, and the exact points of the lines.
    std::vector<std::uint8_t> bytes_of(const Drawing& drawing) const {
        std::vector<std::uint8_t> bytes(static_cast<std::size_t>(4 * side * side));
        auto image = made(hrbfnpr_image_init);
        image.format = HRBFNPR_FORMAT_RGBA8;
        image.width = image.height = side;
        image.pixels = bytes.data();
        Error error;
        EXPECT_OK(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, error));
        Layout layout(HRBFNPR_PRIMITIVE_LINE_STRIPS);
        layout.add(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, 0);
        std::int64_t count = 0, indices = 0;
        EXPECT_OK(hrbfnpr_drawing_vertex_bound(drawing.get(), HRBFNPR_PRIMITIVE_LINE_STRIPS, &count, &indices, error));
        std::vector<float> vertex(static_cast<std::size_t>(3 * count));
        std::vector<std::uint32_t> index(static_cast<std::size_t>(indices));
        EXPECT_OK(hrbfnpr_drawing_write_vertices(drawing.get(), layout.get(), vertex.data(), count, nullptr,
                                                 index.data(), indices, nullptr, error));
        append(bytes, vertex);
        return bytes;
    }

    Context context;
    Model model;
    PointSet set;
    LineSet lines;
    hrbfnpr_line_style line{};
    hrbfnpr_style style{};
    hrbfnpr_item item{};
    Renderer renderer;
};

TEST(FrameCancel, LeavesNoTraceInTheRenderer) {
    constexpr double little = 0.005; // small, so contours start from those of the last frame
    Scene scene(1);
    Error error;
    Drawing first, none, again;
    ASSERT_OK(scene.draw(0.0, nullptr, first, error));
    const std::vector<std::uint8_t> wanted = scene.bytes_of(first);
    Watcher counted;
    const Operation whole = make_operation(scene.context);
    hrbfnpr_operation_set_callback(whole.get(), Watcher::call, &counted, nullptr);
    ASSERT_OK(scene.draw(little, whole.get(), again, error));
    const std::set<double> moments(counted.values.begin(), counted.values.end());
    EXPECT_GE(moments.size(), 6U);
    EXPECT_EQ(*moments.rbegin(), 1.0);
    for (const double moment : moments) {
        const Operation operation = make_operation(scene.context);
        Watcher watcher;
        watcher.cancel_at = moment;
        hrbfnpr_operation_set_callback(operation.get(), Watcher::call, &watcher, nullptr);
        EXPECT_FAILS(scene.draw(little, operation.get(), none, error), HRBFNPR_STATUS_CANCELLED, "cancelled");
        EXPECT_TRUE(scene.bytes_of(first) == wanted) << moment; // a drawing that is held is not changed
        ASSERT_OK(scene.draw(0.0, nullptr, again, error));
        EXPECT_TRUE(scene.bytes_of(again) == wanted) << moment;
    }
}

// An operation of an earlier call does not watch a later call without an operation.
TEST(FrameCancel, DoesNotAffectLaterCallsWithoutTheOperation) {
    Scene scene(2);
    Error error;
    Drawing drawing;
    const Operation operation = make_operation(scene.context);
    ASSERT_OK(scene.draw(0.0, operation.get(), drawing, error));
    EXPECT_EQ(hrbfnpr_operation_progress(operation.get()), 1.0);
    hrbfnpr_operation_cancel(operation.get());
    ASSERT_OK(scene.draw(0.1, nullptr, drawing, error));
    EXPECT_FAILS(scene.draw(0.2, operation.get(), drawing, error), HRBFNPR_STATUS_CANCELLED, "before the call");
}

} // namespace
} // namespace api_test::frame_cancel_test
