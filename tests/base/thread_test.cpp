// SPDX-License-Identifier: MIT
#include "base/thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>

#if defined(__linux__)
#include <pthread.h>
#include <sched.h>
#endif

namespace hrbfnpr::base::thread_test {
namespace {

TEST(Thread, RunsItsWorkUntilItIsJoined) {
    Thread thread;
    std::atomic<int> runs{0};
    ASSERT_TRUE(thread.start(
        "worker", [](void* user) { static_cast<std::atomic<int>*>(user)->fetch_add(1); }, &runs));
    thread.join();
    EXPECT_EQ(runs, 1);
}

#if defined(__linux__)
TEST(Thread, HasItsName) {
    Thread thread;
    std::string name;
    const auto ask = [](void* user) {
        char text[16] = {};
        pthread_getname_np(pthread_self(), text, sizeof text);
        *static_cast<std::string*>(user) = text;
    };
    ASSERT_TRUE(thread.start("a name that is too long", ask, &name));
    thread.join();
    EXPECT_EQ(name, "a name that is ");
}

// Sets the affinity of a test's thread, and restores it at the end.
class Affinity {
public:
    Affinity() { sched_getaffinity(0, sizeof before_, &before_); }
    ~Affinity() { sched_setaffinity(0, sizeof before_, &before_); }
    Affinity(const Affinity&) = delete;
    Affinity& operator=(const Affinity&) = delete;
    [[nodiscard]] const cpu_set_t& before() const { return before_; }
    static bool is(const cpu_set_t& wanted) {
        cpu_set_t now;
        return sched_getaffinity(0, sizeof now, &now) == 0 && CPU_EQUAL(&now, &wanted);
    }

private:
    cpu_set_t before_{};
};

TEST(Processors, LeavingOneMovesTheThreadAndKeepsItAllowed) {
    if (processor_count() < 2) GTEST_SKIP() << "one processor";
    const Affinity affinity;
    for (int time = 0; time < 20; ++time) {
        // The system may move the thread between two calls, so the test only asks for nearly always.
        const int here = current_processor();
        ASSERT_GE(here, 0);
        leave_processor(here);
        ASSERT_TRUE(Affinity::is(affinity.before()));
        if (current_processor() != here) return;
    }
    FAIL() << "it stays where it is";
}

TEST(Processors, TheOnlyProcessorIsNotLeft) {
    const Affinity affinity;
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(static_cast<unsigned>(current_processor()), &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    EXPECT_EQ(processor_count(), 1);
    leave_processor(current_processor());
    EXPECT_TRUE(Affinity::is(one));
    leave_processor(-1);
    EXPECT_TRUE(Affinity::is(one));
}
#endif

} // namespace
} // namespace hrbfnpr::base::thread_test
