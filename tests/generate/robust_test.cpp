// SPDX-License-Identifier: MIT
// The same bits for any threads, cancelling, failing allocations, callbacks' threads, far origins.
#include "support/point_sets.h"
#include "support/watched_operation.h"

#include <thread>

namespace hrbfnpr::generate::robust_test {
namespace {

using namespace marks;
using namespace test;

generate::Settings small_published() {
    generate::Settings settings = recursion({Kind::stipples, principal, combing}, 2);
    settings.seeds.box_resolution = 6;
    of(settings, Kind::stipples).with_curvature = true;
    of(settings, principal).budget = 1000;
    of(settings, combing).published.from_stipples = true;
    of(settings, combing).published.start_level = 1;
    return settings;
}

generate::Settings small_blue() { return blue({Kind::stipples, principal, combing}, 3000, 2); }

// Runs the tasks from the last to the first.
void reverse_tasks(void* /*user*/, base::TaskFn task, void* context, std::int64_t count) {
    for (std::int64_t i = count; i-- > 0;) task(context, i);
}

TEST(Determinism, SameBitsForAnyThreadCountAndTaskOrder) {
    const Torus torus;
    for (const generate::Settings& settings : {small_published(), small_blue()}) {
        const base::Runtime serial = test::with_threads(1);
        const PointSet expected = generate::generate(serial, torus, {}, settings, {});
        for (const int threads : {2, 3, 7}) {
            const base::Runtime many = test::with_threads(threads);
            EXPECT_TRUE(same_bits(expected, generate::generate(many, torus, {}, settings, {}))) << threads;
        }
        const base::Runtime hook(nullptr, nullptr, nullptr, base::Parallel(4, reverse_tasks, nullptr),
                                 base::InstructionSet::automatic, nullptr, nullptr);
        EXPECT_TRUE(same_bits(expected, generate::generate(hook, torus, {}, settings, {})));
    }
}

TEST(Determinism, TheRandomSeedChangesTheMarks) {
    const Torus torus;
    for (generate::Settings settings : {small_published(), small_blue()}) {
        const PointSet one = make(torus, settings);
        settings.random_seed = 2;
        EXPECT_FALSE(same_bits(one, make(torus, settings)));
    }
}

TEST(Callbacks, ASerialFunctionRunsOnTheCallersThreadOnly) {
    const base::Runtime threads = test::with_threads(4);
    for (const generate::Settings& settings : {small_published(), small_blue()}) {
        Torus torus;
        torus.is_concurrent = false;
        const PointSet set = generate::generate(threads, torus, {}, settings, {});
        EXPECT_FALSE(torus.strange_thread);
        EXPECT_GT(torus.evaluations, 1000);
    }
    // The test can fail: a concurrent one does run elsewhere, where there are threads at all.
    const Torus torus;
    (void)generate::generate(threads, torus, {}, small_blue(), {});
    if (std::thread::hardware_concurrency() > 1) {
        EXPECT_TRUE(torus.strange_thread);
    }
}

TEST(Cancel, AtEveryReportOfProgress) {
    const Torus torus;
    const base::Runtime serial = with_threads(1);
    for (const generate::Settings& settings : {small_published(), small_blue()}) {
        WatchedOperation watched;
        (void)generate::generate(serial, torus, {}, settings, watched.progress());
        EXPECT_DOUBLE_EQ(watched.watcher.last(), 1.0);
        EXPECT_FALSE(watched.watcher.fell());
        const std::size_t calls = watched.watcher.values.size();
        EXPECT_GT(calls, 50U);
        const std::int64_t bytes = serial.memory.bytes_now();
        for (std::size_t k = 1; k < calls; k += 1 + calls / 30) {
            WatchedOperation cancelled;
            cancelled.watcher.cancel_at_call = k;
            expect_error(Status::cancelled, {},
                         [&] { (void)generate::generate(serial, torus, {}, settings, cancelled.progress()); });
            EXPECT_LE(cancelled.watcher.values.size(), k + 1) << "it went on after the cancel";
            EXPECT_EQ(serial.memory.bytes_now(), bytes) << "memory was lost";
        }
    }
}

TEST(Memory, EveryAllocationMayFail) {
    const Torus torus;
    generate::Settings tiny_published = small_published();
    tiny_published.seeds.box_resolution = 3;
    of(tiny_published, principal).budget = 60;
    for (const generate::Settings& settings : {tiny_published, blue({principal}, 60, 1)}) {
        Allocator allocator;
        {
            const base::Runtime runtime = with_allocator(allocator, 1);
            (void)generate::generate(runtime, torus, {}, settings, {});
            EXPECT_EQ(runtime.memory.bytes_now(), 0) << "all memory is given back with the set";
        }
        const std::int64_t count = allocator.calls;
        EXPECT_GT(count, 100);
        // The default's arrays grow in many steps of one kind: every fifth is enough.
        const std::int64_t stride = settings.distribution == Distribution::published ? 1 : 5;
        for (std::int64_t k = 1; k <= count; k += stride) {
            allocator.calls = 0;
            allocator.refuse_at = k;
            const base::Runtime runtime = with_allocator(allocator, 1);
            expect_error(Status::out_of_memory, {},
                         [&] { (void)generate::generate(runtime, torus, {}, settings, {}); });
            ASSERT_EQ(runtime.memory.bytes_now(), 0) << k;
        }
    }
}

TEST(Memory, BytesAreThoseOfTheArrays) {
    const base::Runtime runtime;
    const PointSet set = generate::generate(runtime, Torus(), {}, small_blue(), {});
    EXPECT_EQ(set.bytes(), runtime.memory.bytes_now());
    EXPECT_GT(set.bytes(), 9000 * (3 * 12 + 4 + 1 + 8));
}

// A function that fails ends the call with its own error.
TEST(Callbacks, AFailureEndsTheCall) {
    const base::Runtime threads = test::with_threads(3);
    for (const generate::Settings& settings : {small_published(), small_blue()}) {
        for (const std::int64_t after : {0, 500, 20000}) {
            std::atomic<std::int64_t> calls{0};
            const AnyField fails(cube(1.0), [&](const glm::dvec3& p) {
                if (calls++ >= after) fail(Status::callback, "the function failed");
                return Sphere().at(p);
            });
            expect_error(Status::callback, {"the function failed"},
                         [&] { (void)generate::generate(threads, fails, {}, settings, {}); });
        }
    }
}

// Float positions are relative to the set's own origin: a model far from 0 keeps its accuracy.
TEST(Accuracy, FarFromTheOriginFloatsAreStillExact) {
    const glm::dvec3 far(1e6, -2e6, 3e6);
    const Sphere sphere(1.0, far);
    for (const generate::Settings& settings : {small_published(), small_blue()}) {
        const PointSet set = make(sphere, settings);
        EXPECT_LT(glm::distance(set.origin, far), 0.1);
        expect_sound(set, sphere, 1e-6);
        EXPECT_NEAR(glm::length(vec(of(set, Kind::stipples).position, 0)), 1.0, 0.1);
    }
}

TEST(Accuracy, AnyUnitWorks) {
    for (const double unit : {1e-6, 1e5, 1e-30, 1e-20, 1e20, 1e30}) {
        const Torus torus(unit, 0.35 * unit);
        for (const generate::Settings& settings : {small_published(), small_blue()}) {
            const PointSet set = make(torus, settings);
            expect_sound(set, torus);
            EXPECT_GT(of(set, Kind::stipples).count(), 1000);
        }
    }
}

} // namespace
} // namespace hrbfnpr::generate::robust_test
