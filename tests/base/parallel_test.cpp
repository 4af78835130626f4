// SPDX-License-Identifier: MIT
#include "base/parallel.h"
#include "base/status.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

#if defined(__unix__)
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace hrbfnpr::base::parallel_test {
namespace {

// A host's job runner that uses a thread for each task and goes backwards.
struct Host {
    std::atomic<int> calls{0};

    static void run(void* user, TaskFn task, void* context, std::int64_t count) {
        static_cast<Host*>(user)->calls.fetch_add(1);
        std::vector<std::thread> threads;
        for (std::int64_t i = count; i-- > 0;) threads.emplace_back([=] { task(context, i); });
        for (std::thread& thread : threads) thread.join();
    }
};

TEST(Parallel, VisitsEveryIndexOnce) {
    for (const int threads : {0, 1, 2, 3, 7}) {
        const Parallel parallel(threads, nullptr, nullptr);
        std::vector<std::atomic<int>> visits(1000);
        parallel.for_each(1000, [&](std::int64_t i) { visits[static_cast<std::size_t>(i)].fetch_add(1); });
        for (const auto& count : visits) ASSERT_EQ(count.load(), 1) << threads << " threads";
    }
}

TEST(Parallel, DoesNothingForNoElements) {
    const Parallel parallel(4, nullptr, nullptr);
    parallel.for_each(0, [](std::int64_t) { FAIL(); });
    parallel.for_each(-5, [](std::int64_t) { FAIL(); });
    parallel.for_chunks(0, 10, [](std::int64_t, std::int64_t) { FAIL(); });
}

TEST(Parallel, CutsChunksRegardlessOfTheThreadCount) {
    for (const int threads : {1, 3, 7}) {
        const Parallel parallel(threads, nullptr, nullptr);
        std::vector<std::int64_t> ends(4, -1);
        parallel.for_chunks(
            10, 3, [&](std::int64_t begin, std::int64_t end) { ends[static_cast<std::size_t>(begin / 3)] = end; });
        EXPECT_EQ(ends, (std::vector<std::int64_t>{3, 6, 9, 10}));
    }
}

TEST(Parallel, ChecksForACancelBeforeEachTask) {
    for (const int threads : {1, 3}) {
        const Parallel parallel(threads, nullptr, nullptr);
        Operation operation;
        std::atomic<int> after{0};
        const auto task = [&](std::int64_t begin) {
            if (operation.is_cancelled()) after.fetch_add(1);
            if (begin == 20) operation.cancel();
        };
        EXPECT_THROW(parallel.for_each(1000, Progress(&operation), task), Error);
        EXPECT_LT(after.exchange(0), threads); // a task that had checked just before
        Operation other;
        other.cancel();
        const auto chunk = [&](std::int64_t, std::int64_t) { after.fetch_add(1); };
        EXPECT_THROW(parallel.for_chunks(1000, 10, Progress(&other), chunk), Error);
        EXPECT_EQ(after, 0);
    }
}

TEST(Parallel, ClampsTheThreadCount) {
    EXPECT_EQ(Parallel(1000, nullptr, nullptr).threads(), 256);
    EXPECT_EQ(Parallel(3, nullptr, nullptr).threads(), 3);
    EXPECT_GE(Parallel(0, nullptr, nullptr).threads(), 1);
    EXPECT_EQ(Parallel().threads(), 1);
}

TEST(Parallel, SerialStaysOnTheCallingThread) {
    Host host;
    const Parallel parallel(1, Host::run, &host);
    const auto self = std::this_thread::get_id();
    parallel.for_each(100, [&](std::int64_t) { EXPECT_EQ(std::this_thread::get_id(), self); });
    EXPECT_EQ(host.calls.load(), 0);
}

std::string failure_of(const Parallel& parallel, std::int64_t first) {
    try {
        parallel.for_each(200, [&](std::int64_t i) {
            if (i >= first && i % 3 == 0) fail(Status::callback, "index %d", static_cast<int>(i));
        });
    } catch (const Error& error) {
        return error.what();
    }
    return "nothing";
}

TEST(Parallel, RethrowsTheExceptionOfTheLowestIndex) {
    Host host;
    for (int round = 0; round < 20; ++round) {
        EXPECT_EQ(failure_of(Parallel(), 40), "index 42");
        EXPECT_EQ(failure_of(Parallel(4, nullptr, nullptr), 40), "index 42");
    }
    EXPECT_EQ(failure_of(Parallel(4, Host::run, &host), 40), "index 42");
    EXPECT_EQ(failure_of(Parallel(4, nullptr, nullptr), 200), "nothing");
}

TEST(Parallel, CarriesForeignExceptions) {
    const Parallel parallel(4, nullptr, nullptr);
    EXPECT_THROW(parallel.for_each(10, [](std::int64_t) { throw std::runtime_error("x"); }), std::runtime_error);
    EXPECT_THROW(parallel.for_each(10, [](std::int64_t) { throw 42; }), int);
}

TEST(Parallel, UsesTheHostsJobRunner) {
    Host host;
    const Parallel parallel(3, Host::run, &host);
    std::atomic<std::int64_t> sum{0};
    parallel.for_each(50, [&](std::int64_t i) { sum.fetch_add(i); });
    EXPECT_EQ(sum.load(), 50 * 49 / 2);
    EXPECT_EQ(host.calls.load(), 1);
}

TEST(Parallel, CanBeNested) {
    for (const Parallel& parallel : {Parallel(4, nullptr, nullptr), Parallel::openmp(4)}) {
        std::atomic<int> count{0};
        parallel.for_each(8, [&](std::int64_t) { parallel.for_each(8, [&](std::int64_t) { count.fetch_add(1); }); });
        EXPECT_EQ(count.load(), 64);
    }
}

TEST(Parallel, NamesItsBackend) {
    Host host;
    EXPECT_EQ(Parallel().backend(), ThreadBackend::serial);
    EXPECT_EQ(Parallel(1, nullptr, nullptr).backend(), ThreadBackend::serial);
    EXPECT_EQ(Parallel(2, nullptr, nullptr).backend(), ThreadBackend::pool);
    EXPECT_EQ(Parallel(2, Host::run, &host).backend(), ThreadBackend::run_tasks);
    EXPECT_EQ(Parallel::openmp(2).backend(), ThreadBackend::openmp);
}

// ---- Hosts that do not do what they should -----------------------------------------------

// Returns how often the host runs task i, for i in [0, count]; task `count` does not exist.
using Picks = std::function<int(std::int64_t i, std::int64_t count)>;

void run_picked(void* user, TaskFn task, void* context, std::int64_t count) {
    for (std::int64_t i = 0; i <= count; ++i)
        for (int times = (*static_cast<const Picks*>(user))(i, count); times > 0; --times) task(context, i);
}

std::string complaint(Picks picks) {
    try {
        Parallel(2, run_picked, &picks).for_each(10, [](std::int64_t) {});
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::callback);
        return error.what();
    }
    return "nothing";
}

TEST(Parallel, CountsTheTasksThatAHostRan) {
    using testing::HasSubstr;
    EXPECT_EQ(complaint([](auto i, auto n) { return i < n ? 1 : 0; }), "nothing");
    EXPECT_THAT(complaint([](auto i, auto) { return i < 7 ? 1 : 0; }), HasSubstr("returned after 7 of 10 tasks"));
    EXPECT_THAT(complaint([](auto, auto) { return 0; }), HasSubstr("returned after 0 of 10 tasks"));
    EXPECT_THAT(complaint([](auto i, auto n) { return i == 3 || i == n ? 0 : i == 4 ? 2 : 1; }), HasSubstr("twice"));
    EXPECT_THAT(complaint([](auto, auto) { return 1; }), HasSubstr("outside [0, 10)"));
}

TEST(Parallel, PutsTheTasksOwnFailureFirst) {
    Picks some = [](auto i, auto) { return i < 7 ? 1 : 0; };
    const Parallel parallel(2, run_picked, &some);
    EXPECT_THROW(parallel.for_each(10, [](std::int64_t) { throw std::runtime_error("x"); }), std::runtime_error);
}

// ---- OpenMP --------------------------------------------------------------------------------

TEST(ParallelOpenMp, VisitsEachIndexOnceAndReportsTheFirstFailure) {
    for (const int threads : {0, 1, 2, 3, 7}) {
        const Parallel parallel = Parallel::openmp(threads);
        std::vector<std::atomic<int>> visits(1000);
        parallel.for_each(1000, [&](std::int64_t i) { visits[static_cast<std::size_t>(i)].fetch_add(1); });
        for (const auto& count : visits) ASSERT_EQ(count.load(), 1) << threads << " threads";
    }
    EXPECT_EQ(failure_of(Parallel::openmp(4), 40), "index 42");
}

#if defined(__unix__)
TEST(ParallelOpenMp, IsSerialAfterAFork) {
    const Parallel parallel = Parallel::openmp(4);
    std::atomic<int> warm{0};
    parallel.for_each(100, [&](std::int64_t) { warm.fetch_add(1); });
    const pid_t child = fork();
    if (child == 0) {
        alarm(20); // ends the child if it hangs
        std::int64_t sum = 0;
        bool same_thread = true;
        const auto self = std::this_thread::get_id();
        parallel.for_each(100, [&](std::int64_t i) {
            same_thread = same_thread && std::this_thread::get_id() == self;
            sum += i;
        });
        _exit(same_thread && sum == 100 * 99 / 2 ? 0 : 1);
    }
    int status = -1;
    ASSERT_EQ(waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    std::atomic<int> after{0};
    parallel.for_each(100, [&](std::int64_t) { after.fetch_add(1); });
    EXPECT_EQ(after.load(), 100);
}
#endif

} // namespace
} // namespace hrbfnpr::base::parallel_test
