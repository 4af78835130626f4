// SPDX-License-Identifier: MIT
// Tests models made of a caller's function.
#include "fixture.h"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <set>
#include <thread>

namespace api_test::custom_test {
namespace {

struct Threads {
    std::mutex mutex;
    std::set<std::thread::id> seen;
    static std::int32_t call(void* user, std::int64_t count, const double* points, double* value, double* gradient,
                             double* /*hessian*/) {
        auto& self = *static_cast<Threads*>(user);
        {
            const std::lock_guard lock(self.mutex);
            self.seen.insert(std::this_thread::get_id());
        }
        Sphere sphere;
        return Sphere::call(&sphere, count, points, value, gradient, nullptr);
    }
};

Model threads_model(const Context& context, Threads& threads, std::uint32_t flags) {
    Error error;
    Sphere sphere;
    hrbfnpr_custom_desc desc = sphere_desc(sphere, flags | HRBFNPR_CUSTOM_HAS_GRADIENT);
    desc.function = Threads::call;
    desc.user = &threads;
    desc.release = nullptr;
    hrbfnpr_model* model = nullptr;
    EXPECT_OK(hrbfnpr_model_create_custom(context.get(), &desc, &model, error));
    return Model(model);
}

// A job runner that uses a thread for each task.
void run_on_threads(void* /*user*/, hrbfnpr_task_fn task, void* task_context, std::int64_t count) {
    std::vector<std::thread> threads;
    for (std::int64_t i = 0; i < count; ++i) threads.emplace_back(task, task_context, i);
    for (std::thread& thread : threads) thread.join();
}

void evaluate_many(const Model& model) {
    Error error;
    std::vector<double> point(3 * 2000, 0.5);
    std::vector<double> value(2000);
    const hrbfnpr_array points = in(point);
    const hrbfnpr_array_out values = out(value, 1);
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &points, &values, nullptr, nullptr, nullptr, error));
    EXPECT_EQ(value[1999], 0.5 * (0.75 - 1.0));
}

void project_many(const Model& model) {
    Error error;
    const std::vector<double> point(3 * 2000, 0.5);
    const hrbfnpr_array points = in(point);
    std::vector<std::uint8_t> inside(2000);
    const hrbfnpr_array_out insides = out(inside, 1);
    EXPECT_OK(hrbfnpr_model_contains(model.get(), &points, &insides, nullptr, nullptr, error));
    EXPECT_EQ(inside[1999], 1);
    std::vector<double> position(point.size());
    auto projection = made(hrbfnpr_projection_init);
    projection.position = out(position);
    EXPECT_OK(hrbfnpr_model_project(model.get(), &points, nullptr, &projection, nullptr, error));
    std::vector<double> t(2000);
    auto hits = made(hrbfnpr_ray_hits_init);
    hits.t = out(t, 1);
    EXPECT_OK(hrbfnpr_model_cast_rays(model.get(), &points, &points, nullptr, &hits, nullptr, error));
}

TEST(Custom, IsCalledOnTheEnteringThreadOnly) {
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = 4;
    for (const bool hook : {false, true}) {
        desc.run_tasks = hook ? run_on_threads : nullptr;
        const Context context = make_context(desc);
        Threads threads;
        const Model model = threads_model(context, threads, 0);
        evaluate_many(model);
        for (const std::uint32_t distribution : {HRBFNPR_DISTRIBUTION_BLUE_NOISE, HRBFNPR_DISTRIBUTION_PUBLISHED})
            generate(context, model, small_desc(distribution));
        project_many(model);
        EXPECT_EQ(threads.seen, (std::set<std::thread::id>{std::this_thread::get_id()})) << "hook " << hook;
    }
}

// A model is const to callers, who may share it. A function that is not thread-safe is still called by one thread at a
// time.
TEST(Custom, WithoutThreadSafetyIsCalledByOneThreadAtATime) {
    // If the function is thread-safe, the first call waits for a second call, however busy the machine is.
    struct Alone {
        bool waits = false;
        std::mutex mutex;
        std::condition_variable entered;
        int inside = 0;
        int most = 0;
        static std::int32_t call(void* user, std::int64_t count, const double* points, double* value, double*,
                                 double*) {
            auto& self = *static_cast<Alone*>(user);
            std::unique_lock lock(self.mutex);
            self.most = std::max(self.most, ++self.inside);
            self.entered.notify_all();
            const bool waited = self.waits;
            if (waited)
                self.waits = self.entered.wait_for(lock, std::chrono::seconds(20), [&] { return self.most > 1; });
            lock.unlock();
            if (!waited) std::this_thread::sleep_for(std::chrono::microseconds(50));
            for (std::int64_t i = 0; i < count; ++i) value[i] = points[3 * i];
            lock.lock();
            --self.inside;
            return 0;
        }
    };
    for (const bool safe : {false, true}) {
        Alone alone;
        alone.waits = safe;
        Error error;
        const Context context = make_context(1);
        auto desc = made(hrbfnpr_custom_desc_init);
        desc.flags = safe ? HRBFNPR_CUSTOM_THREAD_SAFE : 0;
        desc.function = Alone::call;
        desc.user = &alone;
        std::fill_n(desc.bounds_min, 3, -1.0);
        std::fill_n(desc.bounds_max, 3, 1.0);
        hrbfnpr_model* raw = nullptr;
        ASSERT_OK(hrbfnpr_model_create_custom(context.get(), &desc, &raw, error));
        const Model model(raw);
        std::vector<std::thread> threads;
        for (int i = 0; i < 3; ++i)
            threads.emplace_back([&] {
                const std::vector<double> point(3 * 20000, 0.5);
                std::vector<double> value(20000);
                const hrbfnpr_array points = in(point);
                const hrbfnpr_array_out values = out(value, 1);
                EXPECT_EQ(hrbfnpr_model_evaluate(raw, &points, &values, nullptr, nullptr, nullptr, nullptr),
                          HRBFNPR_STATUS_OK);
            });
        for (std::thread& thread : threads) thread.join();
        if (!safe)
            EXPECT_EQ(alone.most, 1);
        else
            EXPECT_GT(alone.most, 1) << "or this test shows nothing";
    }
}

TEST(Custom, IsCalledOnAllThreadsIfItIsThreadSafe) {
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = 4;
    desc.run_tasks = run_on_threads;
    const Context context = make_context(desc);
    Threads threads;
    evaluate_many(threads_model(context, threads, HRBFNPR_CUSTOM_THREAD_SAFE));
    EXPECT_GT(threads.seen.size(), 1U);
    EXPECT_EQ(threads.seen.count(std::this_thread::get_id()), 0U); // this runner leaves the caller idle
}

TEST(Custom, AFailureOfTheFunctionFailsTheCall) {
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    const std::int64_t before = info_of(context).bytes_now;
    std::vector<double> point(3 * 2000, 0.5);
    const hrbfnpr_array points = in(point);
    const char* const words = "function returned 7; it must return 0";
    {
        Error error;
        std::vector<double> value(2000);
        const hrbfnpr_array_out values = out(value, 1);
        sphere.calls = 0;
        sphere.fail_at = 3;
        EXPECT_FAILS(hrbfnpr_model_evaluate(model.get(), &points, &values, nullptr, nullptr, nullptr, error),
                     HRBFNPR_STATUS_CALLBACK, words);
    }
    for (const int at : {1, 2, 5, 20}) {
        SCOPED_TRACE(at);
        Error error;
        sphere.calls = 0;
        sphere.fail_at = at;
        auto projection = made(hrbfnpr_projection_init);
        EXPECT_FAILS(hrbfnpr_model_project(model.get(), &points, nullptr, &projection, nullptr, error),
                     HRBFNPR_STATUS_CALLBACK, words);
        sphere.calls = 0;
        Generation desc = small_desc();
        hrbfnpr_point_set* set = nullptr;
        EXPECT_FAILS(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &set, error),
                     HRBFNPR_STATUS_CALLBACK, words);
        EXPECT_EQ(set, nullptr);
    }
    EXPECT_EQ(info_of(context).bytes_now, before);
}

TEST(Custom, ModelInfoNamesTheCustomKernel) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    auto info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(model.get(), &info, error));
    EXPECT_EQ(info.kernel, static_cast<std::uint32_t>(HRBFNPR_KERNEL_CUSTOM));
    EXPECT_EQ(info.samples, 0);
    EXPECT_EQ(info.bounds_max[2], 1.0);
    hrbfnpr_array view{};
    EXPECT_OK(hrbfnpr_model_view(model.get(), HRBFNPR_MODEL_ATTRIBUTE_POSITION, &view, error));
    EXPECT_EQ(view.count, 0);
}

TEST(Custom, CannotBeSaved) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    std::int64_t size = 5;
    EXPECT_FAILS(hrbfnpr_model_save_memory(model.get(), nullptr, 0, &size, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "model is a custom model");
    EXPECT_EQ(size, 5);
}

TEST(Custom, IsReleasedOnceAndNotAfterAFailure) {
    Error error;
    const Context context = make_context();
    Sphere sphere;
    {
        const Model model = custom_sphere(context, sphere);
        hrbfnpr_model_retain(model.get());
        hrbfnpr_model_release(model.get());
        EXPECT_EQ(sphere.releases, 0);
    }
    EXPECT_EQ(sphere.releases, 1);
    hrbfnpr_custom_desc desc = sphere_desc(sphere, 8);
    hrbfnpr_model* model = nullptr;
    EXPECT_FAILS(hrbfnpr_model_create_custom(context.get(), &desc, &model, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "custom_desc.flags is 0x8");
    EXPECT_EQ(sphere.releases, 1);
}

} // namespace
} // namespace api_test::custom_test
