// SPDX-License-Identifier: MIT
// Tests seeds, memory, and callbacks that fail.
#include "support/point_sets.h"

#include <atomic>

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

TEST(Determinism, TheRandomSeedChangesTheMarks) {
    const Torus torus;
    for (generate::Settings settings : {small_published(), small_blue()}) {
        const PointSet one = make(torus, settings);
        settings.random_seed = 2;
        EXPECT_FALSE(same_bits(one, make(torus, settings)));
    }
}

TEST(Memory, BytesMatchTheArrays) {
    const base::Runtime runtime;
    const PointSet set = generate::generate(runtime, Torus(), {}, small_blue());
    EXPECT_EQ(set.bytes(), runtime.memory.bytes_now());
    EXPECT_GT(set.bytes(), 9000 * (3 * 12 + 4 + 1 + 8));
}

// If a callback fails, the call ends with the callback's own error.
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
                         [&] { (void)generate::generate(threads, fails, {}, settings); });
        }
    }
}

} // namespace
} // namespace hrbfnpr::generate::robust_test
