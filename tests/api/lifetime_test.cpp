// SPDX-License-Identifier: MIT
// Tests references, leaks, sharing between threads, and use after a fork.
#include "trimmed.h"

#include <algorithm>
#include <array>
#include <thread>

#if defined(__unix__)
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace api_test::lifetime_test {
namespace {

TEST(Lifetime, HandlesCanBeReleasedInAnyOrder) {
    std::array<int, 6> order{0, 1, 2, 3, 4, 5};
    do {
        Allocator allocator;
        Sphere sphere;
        Context context = make_context(allocator_desc(allocator));
        Operation operation = make_operation(context);
        Model model = custom_sphere(context, sphere);
        Generation desc = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 5);
        static const std::vector<double> seeds{0, 0, 1.1, 1.1, 0, 0};
        desc.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
        desc.layer[0].levels = 0;
        desc.seed_source = HRBFNPR_SEED_POINTS;
        desc.seed_points = in(seeds);
        PointSet set = generate(context, model, desc);
        Renderer renderer = make_renderer(context);
        Drawing drawing = draw_item(renderer, item_of(set), front_camera(8));
        for (const int which : order) {
            if (which == 0) context.reset();
            if (which == 1) operation.reset();
            if (which == 2) model.reset();
            if (which == 3) set.reset();
            if (which == 4) renderer.reset();
            if (which == 5) drawing.reset();
            if (drawing != nullptr) { // whatever else has been released
                ASSERT_EQ(rasterize(drawing, 8).size(), 256U);
            }
        }
        ASSERT_EQ(allocator.bytes, 0);
        ASSERT_EQ(sphere.releases, 1);
    } while (std::next_permutation(order.begin(), order.end()));
}

TEST(Lifetime, NothingLeaks) {
    Allocator allocator;
    {
        const Context context = make_context(allocator_desc(allocator, 2));
        const std::int64_t alone = allocator.bytes;
        EXPECT_EQ(info_of(context).bytes_now, 0);
        const auto work = [&] {
            const Model model = fit(context, scenes::torus(50));
            const PointSet set = generate(context, model, small_desc());
            draw(make_renderer(context), set);
            EXPECT_EQ(info_of(context).bytes_now, allocator.bytes - alone);
            EXPECT_GE(info_of(context).bytes_peak, info_of(context).bytes_now);
            EXPECT_GT(info_of(context).bytes_now, 0);
        };
        work();
        // The scratch memory for reading drawings is kept for the next ones.
        const std::int64_t kept = info_of(context).bytes_now;
        EXPECT_LT(kept, 1 << 20);
        for (int again = 0; again < 3; ++again) work();
        EXPECT_EQ(info_of(context).bytes_now, kept);
        EXPECT_GT(info_of(context).bytes_peak, 0);
    }
    EXPECT_EQ(allocator.bytes, 0);
}

TEST(Lifetime, RetainedHandlesStayValid) {
    Error error;
    Allocator allocator;
    Context context = make_context(allocator_desc(allocator));
    Model model = fit(context, scenes::sphere_6());
    hrbfnpr_context_retain(context.get());
    hrbfnpr_model_retain(model.get());
    hrbfnpr_context* const same_context = context.get();
    const hrbfnpr_model* const same_model = model.get();
    context.reset();
    model.reset();
    auto info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(same_model, &info, error));
    EXPECT_EQ(info.centres, 6);
    auto context_info = made(hrbfnpr_context_info_init);
    EXPECT_OK(hrbfnpr_context_get_info(same_context, &context_info, error));
    Sphere sphere;
    const hrbfnpr_point_set* same_set = nullptr;
    {
        const Context other = make_context(allocator_desc(allocator));
        const PointSet set = generate(other, custom_sphere(other, sphere), small_desc(HRBFNPR_DISTRIBUTION_PUBLISHED));
        same_set = set.get();
        hrbfnpr_point_set_retain(same_set);
    }
    EXPECT_EQ(sphere.releases, 1); // a point set does not keep its model
    auto set_info = made(hrbfnpr_point_set_info_init);
    EXPECT_OK(hrbfnpr_point_set_get_info(same_set, &set_info, error));
    EXPECT_GT(set_info.marks, 0);
    hrbfnpr_point_set_release(same_set);
    hrbfnpr_model_release(same_model);
    hrbfnpr_context_release(same_context);
    EXPECT_EQ(allocator.bytes, 0);
}

TEST(Lifetime, RetainedOperationsAndRenderersStayValid) {
    Error error;
    Allocator allocator;
    hrbfnpr_operation* operation = nullptr;
    hrbfnpr_renderer* renderer = nullptr;
    {
        const Context context = make_context(allocator_desc(allocator));
        ASSERT_OK(hrbfnpr_operation_create(context.get(), &operation, error));
        ASSERT_OK(hrbfnpr_renderer_create(context.get(), &renderer, error));
    }
    hrbfnpr_operation_retain(operation);
    hrbfnpr_operation_release(operation);
    hrbfnpr_operation_cancel(operation);
    EXPECT_EQ(hrbfnpr_operation_is_cancelled(operation), 1);
    hrbfnpr_operation_release(operation);
    hrbfnpr_renderer_retain(renderer);
    hrbfnpr_renderer_release(renderer);
    const hrbfnpr_camera camera = front_camera(8);
    hrbfnpr_drawing* drawing = nullptr;
    ASSERT_OK(hrbfnpr_renderer_draw(renderer, nullptr, 0, 0, &camera, &drawing, error));
    hrbfnpr_renderer_release(renderer);
    hrbfnpr_drawing_retain(drawing);
    hrbfnpr_drawing_release(drawing);
    auto info = made(hrbfnpr_drawing_info_init);
    EXPECT_OK(hrbfnpr_drawing_get_info(drawing, &info, error));
    EXPECT_GT(allocator.bytes, 0);
    hrbfnpr_drawing_release(drawing);
    EXPECT_EQ(allocator.bytes, 0);
}

TEST(Lifetime, NullIsIgnored) {
    hrbfnpr_operation_retain(nullptr);
    hrbfnpr_operation_release(nullptr);
    hrbfnpr_renderer_retain(nullptr);
    hrbfnpr_context_retain(nullptr);
    hrbfnpr_context_release(nullptr);
    hrbfnpr_model_retain(nullptr);
    hrbfnpr_model_release(nullptr);
    hrbfnpr_point_set_retain(nullptr);
    hrbfnpr_point_set_release(nullptr);
    hrbfnpr_renderer_release(nullptr);
    hrbfnpr_drawing_retain(nullptr);
    hrbfnpr_drawing_release(nullptr);
}

TEST(Sharing, OneContextServesSeveralFitsAtOnce) {
    const Context context = make_context(2);
    std::vector<std::thread> threads;
    std::atomic<int> right{0};
    for (int i = 0; i < 4; ++i)
        threads.emplace_back([&, i] {
            const Model model = fit(context, scenes::torus(30 + i));
            auto info = made(hrbfnpr_model_info_init);
            if (hrbfnpr_model_get_info(model.get(), &info, nullptr) == HRBFNPR_STATUS_OK && info.centres == 30 + i)
                right.fetch_add(1);
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(right, 4);
}

namespace {
struct Messages {
    std::vector<std::string> text;
    std::int32_t highest = 0;
    static void call(void* user, std::int32_t level, const char* message) {
        auto& self = *static_cast<Messages*>(user);
        self.text.emplace_back(message);
        self.highest = std::max(self.highest, level);
    }
};
} // namespace

TEST(Log, ReportsRepairs) {
    Messages messages;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.log = Messages::call;
    desc.log_user = &messages;
    const Context context = make_context(desc);
    scenes::Samples samples = scenes::sphere_6();
    fit_whole(context, samples);
    ASSERT_EQ(messages.text.size(), 1U);
    EXPECT_EQ(messages.text[0].find("fit: 6 samples in "), 0U);
    EXPECT_EQ(messages.highest, HRBFNPR_LOG_INFO);
    for (double& component : samples.normals) component *= 2.0;
    fit_whole(context, samples);
    ASSERT_EQ(messages.text.size(), 3U);
    EXPECT_NE(messages.text[2].find("6 normals were not of unit length"), std::string::npos);
    EXPECT_EQ(messages.highest, HRBFNPR_LOG_WARNING);
}

TEST(Log, ReportsASurfaceThatIsNotTrimmed) {
    Messages messages;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.log = Messages::call;
    desc.log_user = &messages;
    fit(make_context(desc), scenes::sphere_6());
    ASSERT_EQ(messages.text.size(), 2U);
    EXPECT_EQ(messages.text[1], "trim: the surface is left whole: there are too few samples to find where it ends");
    EXPECT_EQ(messages.highest, HRBFNPR_LOG_INFO);
}

TEST(Log, OmitsMessagesBelowItsLevel) {
    scenes::Samples samples = scenes::sphere_6();
    for (double& component : samples.normals) component *= 2.0;
    const std::size_t wanted[] = {2, 2, 1}; // an INFO and a WARNING
    for (const std::int32_t level : {HRBFNPR_LOG_DEBUG, HRBFNPR_LOG_INFO, HRBFNPR_LOG_WARNING}) {
        Messages messages;
        auto desc = made(hrbfnpr_context_desc_init);
        EXPECT_EQ(desc.log_level, HRBFNPR_LOG_DEBUG);
        desc.log = Messages::call;
        desc.log_user = &messages;
        desc.log_level = level;
        fit_whole(make_context(desc), samples);
        EXPECT_EQ(messages.text.size(), wanted[level]) << level;
        EXPECT_EQ(messages.highest, HRBFNPR_LOG_WARNING);
    }
}

#if defined(__unix__)
TEST(Fork, AChildContinuesSerially) {
    const Context context = make_context(4);
    const Model model = fit(context, scenes::torus(40)); // the threads have started
    const auto before = saved(generate(context, model, small_desc())).size();
    const pid_t child = fork();
    if (child == 0) {
        alarm(60); // ends the child if it hangs
        Error error;
        hrbfnpr_model* again = nullptr;
        const scenes::Samples samples = scenes::torus(40);
        const hrbfnpr_fit_desc desc = fit_desc(samples);
        if (hrbfnpr_model_fit(context.get(), &desc, nullptr, &again, error) != HRBFNPR_STATUS_OK) _exit(1);
        const bool same = saved(generate(context, Model(again), small_desc())).size() == before;
        _exit(same ? 0 : 2);
    }
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    EXPECT_EQ(saved(generate(context, model, small_desc())).size(), before);
}
#endif

} // namespace
} // namespace api_test::lifetime_test
