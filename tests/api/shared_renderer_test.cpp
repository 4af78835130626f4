// A prepared renderer may be read on several threads at the same time.
#include "fixture.h"

#include <thread>

namespace api_test {
namespace {

std::vector<float> windows(const Renderer& renderer) {
    Error error;
    std::int64_t count = 0;
    EXPECT_OK(hrbfnpr_renderer_vertex_bound(renderer.get(), &count, error));
    auto layout = made(hrbfnpr_vertex_layout_init);
    layout.attribute_count = 1;
    layout.attributes[0] = {HRBFNPR_VERTEX_WINDOW, HRBFNPR_SCALAR_FLOAT32, 0, 0};
    std::vector<float> vertices(static_cast<std::size_t>(3 * count));
    EXPECT_OK(hrbfnpr_renderer_write_vertices(renderer.get(), &layout, vertices.data(), count, &count, error));
    return vertices;
}

std::int64_t shown(const Renderer& renderer) {
    Error error;
    auto info = made(hrbfnpr_frame_info_init);
    EXPECT_OK(hrbfnpr_renderer_get_info(renderer.get(), &info, error));
    return info.shown;
}

// A job runner whose waiting threads help with other jobs, as those of engines do: here, with a call that reads the
// same renderer.
struct Helper {
    const Renderer* renderer = nullptr;
    bool helping = false;
    std::vector<float> seen;

    static void run(void* user, hrbfnpr_task_fn task, void* task_context, std::int64_t count) {
        auto& self = *static_cast<Helper*>(user);
        if (self.renderer != nullptr && !self.helping) {
            self.helping = true;
            self.seen = windows(*self.renderer);
        }
        for (std::int64_t i = 0; i < count; ++i) task(task_context, i);
    }
};

void prepare(const Renderer& renderer, const PointSet& set, double size = 64.0) {
    Error error;
    const hrbfnpr_item item = item_of(set);
    const hrbfnpr_camera camera = front_camera(size);
    ASSERT_OK(hrbfnpr_renderer_prepare(renderer.get(), &item, 1, 0, &camera, nullptr, error));
}

TEST(SharedRenderer, VerticesAreReadOnManyThreads) {
    const Context context = make_context(1);
    const PointSet set = generate(context, fit(context, scenes::torus(60)), small_desc());
    const Renderer renderer = make_renderer(context);
    prepare(renderer, set);
    const std::vector<float> expected = windows(renderer);
    ASSERT_GT(expected.size(), 300U);
    for (int round = 0; round < 20; ++round) {
        prepare(renderer, set);
        std::vector<std::vector<float>> seen(4);
        std::vector<std::thread> threads;
        for (std::vector<float>& own : seen)
            threads.emplace_back([&] {
                EXPECT_EQ(3 * shown(renderer), static_cast<std::int64_t>(expected.size()));
                own = windows(renderer);
            });
        for (std::thread& thread : threads) thread.join();
        for (const std::vector<float>& own : seen) EXPECT_EQ(own, expected) << round;
    }
}

TEST(SharedRenderer, ARunnerMayReadItInTheMiddleOfReading) {
    Helper helper;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.run_tasks = Helper::run;
    desc.run_tasks_user = &helper;
    const Context context = make_context(desc);
    hrbfnpr_generate_desc many = small_desc();
    many.groups = 1U << HRBFNPR_GROUP_STIPPLE;
    many.group[0].budget = 40000;
    const PointSet set = generate(context, fit(context, scenes::torus(60)), many);
    const Renderer expected = make_renderer(context);
    prepare(expected, set, 1000.0);
    const std::vector<float> alone = windows(expected);
    const Renderer renderer = make_renderer(context);
    prepare(renderer, set, 1000.0);
    helper.renderer = &renderer;
    EXPECT_EQ(windows(renderer), alone);
    EXPECT_TRUE(helper.helping);
    EXPECT_EQ(helper.seen, alone);
}

} // namespace
} // namespace api_test
