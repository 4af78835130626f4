// SPDX-License-Identifier: MIT
// Tests reading one drawing on several threads at the same time.
#include "fixture.h"

#include <thread>

namespace api_test::shared_drawing_test {
namespace {

std::vector<float> windows(const Drawing& drawing) {
    Error error;
    std::int64_t count = 0;
    EXPECT_OK(hrbfnpr_drawing_vertex_bound(drawing.get(), HRBFNPR_PRIMITIVE_POINTS, &count, nullptr, error));
    Layout layout;
    layout.add(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, 0);
    std::vector<float> vertices(static_cast<std::size_t>(3 * count));
    EXPECT_OK(hrbfnpr_drawing_write_vertices(drawing.get(), layout.get(), vertices.data(), count, &count, nullptr, 0,
                                             nullptr, error));
    return vertices;
}

std::vector<std::uint32_t> mark_indices(const Drawing& drawing) {
    Error error;
    std::vector<std::uint32_t> indices(100000);
    std::int64_t count = 0;
    EXPECT_OK(hrbfnpr_drawing_write_mark_indices(drawing.get(), 0, 0, HRBFNPR_CLASS_FRONT, HRBFNPR_PRIMITIVE_POINTS,
                                                 indices.data(), 100000, &count, error));
    indices.resize(static_cast<std::size_t>(count));
    return indices;
}

// Everything that can be read of a drawing.
struct Seen {
    std::vector<float> vertices;
    std::vector<std::uint8_t> pixels;
    std::vector<std::uint32_t> indices;
    std::int64_t shown = 0;

    explicit Seen(const Drawing& drawing)
        : vertices(windows(drawing)), pixels(rasterize(drawing, 64)), indices(mark_indices(drawing)),
          shown(info_of(drawing).shown) {}
    bool operator==(const Seen&) const = default;
};

// A job runner whose waiting threads help with other jobs, as those of engines do. Here they make calls that read the
// same drawing.
struct Helper {
    const Drawing* drawing = nullptr;
    bool helping = false;
    std::vector<float> vertices;
    std::vector<std::uint8_t> pixels;

    static void run(void* user, hrbfnpr_task_fn task, void* task_context, std::int64_t count) {
        auto& self = *static_cast<Helper*>(user);
        if (self.drawing != nullptr && !self.helping) {
            self.helping = true;
            self.vertices = windows(*self.drawing);
            self.pixels = rasterize(*self.drawing, 1000);
        }
        for (std::int64_t i = 0; i < count; ++i) task(task_context, i);
    }
};

// The next drawing is made while others are read, and each is released by the thread that reads it.
TEST(SharedDrawing, CanBeReadWhileTheNextIsMade) {
    const Context context = make_context(1);
    const PointSet set = generate(context, fit(context, scenes::torus(60)), small_desc());
    const Renderer renderer = make_renderer(context);
    const Seen expected(draw_item(renderer, item_of(set), front_camera()));
    std::vector<std::thread> threads;
    std::atomic<int> same{0};
    for (int round = 0; round < 20; ++round)
        threads.emplace_back([&, own = draw_item(renderer, item_of(set), front_camera())]() mutable {
            same.fetch_add(Seen(own) == expected ? 1 : 0);
            own.reset();
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(same, 20);
}

TEST(SharedDrawing, CanBeReadByAJobRunnerDuringAnotherRead) {
    Helper helper;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.run_tasks = Helper::run;
    desc.run_tasks_user = &helper;
    const Context context = make_context(desc);
    const PointSet set =
        generate(context, fit(context, scenes::torus(60)), one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 40000));
    const Drawing drawing = draw_item(make_renderer(context), item_of(set), front_camera(1000.0));
    const std::vector<float> alone = windows(drawing);
    const std::vector<std::uint8_t> picture = rasterize(drawing, 1000);
    helper.drawing = &drawing;
    EXPECT_EQ(windows(drawing), alone);
    EXPECT_TRUE(helper.helping);
    EXPECT_EQ(helper.vertices, alone);
    EXPECT_EQ(helper.pixels, picture);
    helper.helping = false;
    EXPECT_EQ(rasterize(drawing, 1000), picture);
    EXPECT_EQ(helper.vertices, alone);
    EXPECT_EQ(helper.pixels, picture);
}

} // namespace
} // namespace api_test::shared_drawing_test
