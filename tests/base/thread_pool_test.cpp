// SPDX-License-Identifier: MIT
#include "base/thread_pool.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <ctime>
#include <latch>
#include <memory>
#include <set>
#include <thread>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#endif
#if defined(__unix__)
#include <csignal>
#include <dlfcn.h>
#include <sys/wait.h>
#include <unistd.h>
#endif

namespace hrbfnpr::base::thread_pool_test {
namespace {

// Calls f(i) for each i in [0, count).
template <class F>
void run(ThreadPool& pool, std::int64_t count, F&& f) {
    pool.run(
        count, [](void* context, std::int64_t i) { (*static_cast<std::remove_reference_t<F>*>(context))(i); }, &f);
}

// Runs tasks that end only once all of them have begun, so `threads` threads are needed.
void meet(ThreadPool& pool, std::int64_t threads) {
    std::latch all(threads);
    run(pool, threads, [&](std::int64_t) { all.arrive_and_wait(); });
}

TEST(ThreadPool, RunsEachTaskOnce) {
    for (const int threads : {1, 2, 3, 16}) {
        ThreadPool pool(threads);
        for (const std::int64_t count : {0, 1, 2, 3, 1000}) {
            std::vector<std::atomic<int>> runs(1000);
            run(pool, count, [&](std::int64_t i) { runs[static_cast<std::size_t>(i)].fetch_add(1); });
            for (std::size_t i = 0; i < 1000; ++i) ASSERT_EQ(runs[i], static_cast<std::int64_t>(i) < count ? 1 : 0);
        }
    }
}

TEST(ThreadPool, StartsItsWorkersWithTheFirstJob) {
    ThreadPool pool(4);
    EXPECT_EQ(pool.workers(), 0);
    run(pool, 2, [](std::int64_t) {});
    EXPECT_EQ(pool.workers(), 3);
    meet(pool, 4);
}

TEST(ThreadPool, EndsCleanlyWithTheMostThreads) {
    ThreadPool pool(ThreadPool::most_threads);
    run(pool, 1000, [](std::int64_t) {});
    EXPECT_GT(pool.workers(), 0);
}

// The pool ends whatever place between two jobs a worker is at: a worker does not wait for a notice of the end that
// came before it looked.
TEST(ThreadPool, EndsAtAnyMomentBetweenJobs) {
    for (int i = 0; i < 3000; ++i) {
        ThreadPool pool(2 + i % 3);
        pool.run(
            2 + i % 5, [](void*, std::int64_t) {}, nullptr);
    }
}

// A caller does not wait for a worker that has begun none of its tasks, whatever keeps the worker.
TEST(ThreadPool, CallersDoNotWaitForBusyWorkers) {
    ThreadPool pool(3);
    std::latch begun(3);
    std::latch go_on(1);
    std::thread keeper([&] {
        run(pool, 3, [&](std::int64_t) {
            begun.count_down();
            go_on.wait();
        });
    });
    begun.wait();
    const auto self = std::this_thread::get_id();
    std::set<std::thread::id> seen;
    int runs = 0;
    run(pool, 100, [&](std::int64_t) {
        seen.insert(std::this_thread::get_id());
        ++runs;
    });
    EXPECT_EQ(runs, 100);
    EXPECT_EQ(seen, std::set<std::thread::id>{self});
    go_on.count_down();
    keeper.join();
}

TEST(ThreadPool, CallersWaitForTasksThatWorkersHaveBegun) {
    ThreadPool pool(2);
    for (int round = 0; round < 20; ++round) {
        std::atomic<int> ended{0};
        const auto self = std::this_thread::get_id();
        std::latch both(2);
        run(pool, 2, [&](std::int64_t) {
            both.arrive_and_wait();
            if (std::this_thread::get_id() != self) std::this_thread::sleep_for(std::chrono::milliseconds(2));
            ended.fetch_add(1);
        });
        ASSERT_EQ(ended, 2);
    }
}

// There are more callers than the pool has room for.
TEST(ThreadPool, ServesManyCallersAtOnce) {
    ThreadPool pool(4);
    std::atomic<std::int64_t> sum{0};
    std::vector<std::thread> callers;
    for (int caller = 0; caller < 48; ++caller)
        callers.emplace_back([&] {
            for (std::int64_t job = 0; job < 100; ++job) {
                std::int64_t own[8] = {};
                run(pool, 8, [&](std::int64_t i) { own[i] = job; });
                for (const std::int64_t value : own) sum.fetch_add(value);
            }
        });
    for (std::thread& caller : callers) caller.join();
    EXPECT_EQ(sum, 48 * 8 * (99 * 100 / 2));
}

TEST(ThreadPool, RunsNestedJobsOnTheTasksThread) {
    ThreadPool pool(4);
    std::atomic<int> runs{0};
    std::atomic<int> elsewhere{0};
    run(pool, 16, [&](std::int64_t) {
        const auto outer = std::this_thread::get_id();
        run(pool, 16, [&](std::int64_t) {
            runs.fetch_add(1);
            if (std::this_thread::get_id() != outer) elsewhere.fetch_add(1);
        });
    });
    EXPECT_EQ(runs, 16 * 16);
    EXPECT_EQ(elsewhere, 0);
    meet(pool, 4); // all workers are available again
}

// A host may confine its process: the workers have no other processor to go to.
#if defined(__linux__)
TEST(ThreadPool, WorksOnASingleProcessor) {
    cpu_set_t before, one;
    ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
    CPU_ZERO(&one);
    CPU_SET(static_cast<unsigned>(sched_getcpu()), &one);
    ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
    {
        ThreadPool pool(3);
        for (int round = 0; round < 20; ++round) meet(pool, 3);
    }
    sched_setaffinity(0, sizeof before, &before);
}
#endif

// The pauses are about as long as a worker waits before it sleeps: no sleep may miss a job.
TEST(ThreadPool, WakesWorkersWheneverTheyFellAsleep) {
    ThreadPool pool(2);
    for (int round = 0; round < 3000; ++round) {
        const auto until = std::chrono::steady_clock::now() + std::chrono::microseconds(round % 60);
        while (std::chrono::steady_clock::now() < until) {
        }
        meet(pool, 2); // hangs if the other thread keeps sleeping
    }
}

#if defined(__unix__)
std::int64_t processor_milliseconds() {
    timespec time{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return time.tv_sec * 1000 + time.tv_nsec / 1'000'000;
}

TEST(ThreadPool, TakesNoProcessorWhileItHasNothingToDo) {
    ThreadPool pool(8);
    meet(pool, 8);
    const std::int64_t before = processor_milliseconds();
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    EXPECT_LT(processor_milliseconds() - before, 100);
}

// Pool threads block the host's signals, but not the signals of faults such as SIGSEGV.
TEST(ThreadPool, TakesNoSignals) {
    ThreadPool pool(3);
    std::atomic<int> open{0};
    std::atomic<int> closed{0};
    const auto self = std::this_thread::get_id();
    std::latch all(3);
    run(pool, 3, [&](std::int64_t) {
        all.arrive_and_wait();
        if (std::this_thread::get_id() == self) return;
        sigset_t blocked;
        pthread_sigmask(SIG_SETMASK, nullptr, &blocked);
        for (const int signal : {SIGINT, SIGTERM, SIGCHLD, SIGUSR1, SIGALRM})
            open += sigismember(&blocked, signal) == 0;
        for (const int signal : {SIGSEGV, SIGFPE, SIGPROF}) closed += sigismember(&blocked, signal) == 1;
    });
    EXPECT_EQ(open, 0);
    EXPECT_EQ(closed, 0);
}

template <class Work>
bool works_in_a_child(const Work& work) {
    const pid_t child = fork();
    if (child == 0) {
        alarm(60); // ends the child if it hangs
        work();
        _exit(0);
    }
    int status = -1;
    return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

TEST(ThreadPool, HasNewWorkersInAForkedChild) {
    ThreadPool pool(3);
    meet(pool, 3);
    EXPECT_TRUE(works_in_a_child([&] {
        meet(pool, 3);
        if (!works_in_a_child([&] { meet(pool, 3); })) _exit(1);
        meet(pool, 3);
    }));
    meet(pool, 3);
}

TEST(ThreadPool, CanBeDestroyedInAForkedChild) {
    auto pool = std::make_unique<ThreadPool>(3);
    meet(*pool, 3);
    EXPECT_TRUE(works_in_a_child([&] { pool.reset(); }));
    EXPECT_TRUE(works_in_a_child([&] {
        meet(*pool, 3);
        pool.reset();
    }));
}

// GCC's address sanitizer holds its locks in a child that is forked while another thread allocates. The next allocation
// in the child, which glibc makes for a new thread, waits for ever.
bool may_fork_during_allocations() { return dlsym(RTLD_DEFAULT, "__asan_init") == nullptr; }

// The child is forked while another thread of the parent is in the middle of its jobs.
TEST(ThreadPool, WorksInAChildThatWasForkedDuringJobs) {
    if (!may_fork_during_allocations()) GTEST_SKIP() << "the address sanitizer's own locks are not free after a fork";
    ThreadPool pool(3);
    std::atomic<bool> stops{false};
    std::thread other([&] {
        while (!stops) run(pool, 50, [](std::int64_t) {});
    });
    int good = 0;
    for (int round = 0; round < 20; ++round) good += works_in_a_child([&] { meet(pool, 3); }) ? 1 : 0;
    stops = true;
    other.join();
    EXPECT_EQ(good, 20);
}
#endif

} // namespace
} // namespace hrbfnpr::base::thread_pool_test
