// SPDX-License-Identifier: MIT
// Tests a host's threads: each with a context, all with one model, and one that draws while another fits.
#include "host/session.h"

#include <gtest/gtest.h>

#include <atomic>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace host_test::threads_test {
namespace {

// Runs `work` on `count` threads at a time, and fails with the first message that is thrown.
void on_threads(int count, const std::function<void(int)>& work) {
    std::vector<std::thread> threads;
    std::mutex mutex;
    std::string message;
    for (int i = 0; i < count; ++i)
        threads.emplace_back([&, i] {
            try {
                work(i);
            } catch (const std::exception& exception) {
                const std::lock_guard lock(mutex);
                if (message.empty()) message = exception.what();
            }
        });
    for (std::thread& thread : threads) thread.join();
    EXPECT_EQ(message, "");
}

// Runs some of each kind of call that takes time.
Bytes session(const Context& context, const Model& model) {
    const PointSet marks = generate(context, model);
    Bytes bytes = draw(context, marks);
    const Bytes by_rays = draw(context, marks, model.get());
    bytes.insert(bytes.end(), by_rays.begin(), by_rays.end());
    return bytes;
}

TEST(Threads, EightEachWithAContext) {
    const auto all = [](std::int32_t thread_count) {
        const Context context = make_context(thread_count);
        return session(context, fit(context));
    };
    const Bytes serial = all(1);
    std::atomic<int> same{0};
    on_threads(8, [&](int i) {
        for (int round = 0; round < 3; ++round)
            if (all(i % 4) == serial) ++same; // on all processors, 1, 2 and 3 threads
    });
    EXPECT_EQ(same, 24);
}

TEST(Threads, EightShareOneContext) {
    const Context context = make_context(2);
    const Bytes serial = session(make_context(1), fit(make_context(1)));
    std::atomic<int> same{0};
    on_threads(8, [&](int) {
        for (int round = 0; round < 3; ++round)
            if (session(context, fit(context)) == serial) ++same;
    });
    EXPECT_EQ(same, 24);
}

TEST(Threads, EightShareOneModel) {
    const Context owner = make_context(2);
    const Model model = fit(owner);
    const Bytes serial = session(make_context(1), model);
    std::atomic<int> same{0};
    on_threads(8, [&](int i) {
        const Context context = make_context(i % 4);
        for (int round = 0; round < 3; ++round)
            if (session(context, model) == serial) ++same;
    });
    EXPECT_EQ(same, 24);
}

TEST(Threads, OneDrawsWhileAnotherFits) {
    const scenes::Samples samples = scenes::torus(1200);
    const Scene scene(make_context(2));
    const Bytes picture = draw(scene.context, scene.marks);
    const Bytes wanted = session(make_context(1), fit(make_context(1), fit_desc(samples)));
    std::atomic<bool> fitting{true};
    Bytes got;
    std::thread fitter([&] {
        try {
            for (int round = 0; round < 2; ++round) got = session(scene.context, fit(scene.context, fit_desc(samples)));
        } catch (const std::exception& exception) {
            ADD_FAILURE() << exception.what();
        }
        fitting = false;
    });
    int frames = 0;
    int same = 0;
    for (; fitting; ++frames)
        if (draw(scene.context, scene.marks) == picture) ++same;
    fitter.join();
    EXPECT_EQ(same, frames);
    EXPECT_GT(frames, 10);
    EXPECT_TRUE(got == wanted);
}

} // namespace
} // namespace host_test::threads_test
