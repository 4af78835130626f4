// SPDX-License-Identifier: MIT
#include "base/parallel.h"

#include "base/fp_state.h"
#include "base/parallel_openmp.h"
#include "base/status.h"

#include <atomic>
#include <exception>
#include <limits>
#include <mutex>

namespace hrbfnpr::base {
namespace {

// The tasks of one for_each call. It catches the exceptions of the tasks and keeps the exception of the task with the
// lowest index, because an exception that leaves an OpenMP region, a worker thread or a host's job would end the
// process.
class TaskGuard {
public:
    TaskGuard(std::int64_t count, TaskFn task, void* context) noexcept
        : count_(count), task_(task), context_(context) {}

    static void run_task(void* guarded, std::int64_t index) noexcept { static_cast<TaskGuard*>(guarded)->run(index); }
    // Runs a task like run_task(), for a host's job system, and counts the calls.
    static void run_task_of_host(void* guarded, std::int64_t index) noexcept {
        auto& self = *static_cast<TaskGuard*>(guarded);
        if (index < 0 || index >= self.count_) {
            self.bad_indices_.fetch_add(1, std::memory_order_relaxed);
            return;
        }
        self.run(index);
        self.sum_.fetch_add(weight(index), std::memory_order_relaxed);
        self.calls_.fetch_add(1, std::memory_order_release);
    }

    void rethrow() const {
        if (error_) std::rethrow_exception(error_);
    }

    // Checks that the host ran each index exactly once, and that all of them ended before run_tasks returned.
    void check_host() const {
        const std::int64_t calls = calls_.load(std::memory_order_acquire);
        if (bad_indices_.load(std::memory_order_relaxed) != 0)
            fail(Status::callback,
                 "run_tasks called a task with an index outside [0, %lld); call task(task_context, i) once for each i "
                 "in [0, task_count)",
                 static_cast<long long>(count_));
        if (calls != count_)
            fail(Status::callback,
                 "run_tasks returned after %lld of %lld tasks; it must call each task once, and wait for all of them",
                 static_cast<long long>(calls), static_cast<long long>(count_));
        std::uint64_t sum = 0;
        for (std::int64_t i = 0; i < count_; ++i) sum += weight(i);
        if (sum != sum_.load(std::memory_order_relaxed))
            fail(Status::callback,
                 "run_tasks called some of %lld tasks twice and others not at all; it must call each task once",
                 static_cast<long long>(count_));
    }

private:
    void run(std::int64_t index) noexcept {
        if (index > first_failed_.load(std::memory_order_relaxed)) return;
        const FpGuard guard;
        try {
            task_(context_, index);
        } catch (...) {
            const std::lock_guard lock(mutex_);
            if (index >= first_failed_.load(std::memory_order_relaxed)) return;
            error_ = std::current_exception();
            first_failed_.store(index, std::memory_order_relaxed);
        }
    }

    // Returns a pseudorandom weight for an index. If two multisets of indices have equal counts and equal sums of
    // weights, they are equal, except with a probability of 2^-64 (SplitMix64: Steele, Lea, Flood, "Fast splittable
    // pseudorandom number generators", OOPSLA 2014).
    static std::uint64_t weight(std::int64_t index) noexcept {
        std::uint64_t z = (static_cast<std::uint64_t>(index) + 1) * 0x9E3779B97F4A7C15U;
        z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9U;
        z = (z ^ (z >> 27U)) * 0x94D049BB133111EBU;
        return z ^ (z >> 31U);
    }

    std::int64_t count_;
    TaskFn task_;
    void* context_;
    // The lowest index of a failed task. Tasks with lower indices still run after a failure, so the reported failure
    // does not depend on the order of the tasks.
    std::atomic<std::int64_t> first_failed_{std::numeric_limits<std::int64_t>::max()};
    std::mutex mutex_;
    std::exception_ptr error_;
    // The host's calls with a valid index, and with an invalid one.
    std::atomic<std::int64_t> calls_{0}, bad_indices_{0};
    std::atomic<std::uint64_t> sum_{0};
};

int clamped(int threads) noexcept {
    return std::clamp(threads > 0 ? threads : processor_count(), 1, ThreadPool::most_threads);
}

} // namespace

Parallel::Parallel(int threads, ThreadBackend backend) noexcept
    : threads_(clamped(threads)), backend_(threads_ > 1 ? backend : ThreadBackend::serial) {}

Parallel::Parallel(int threads, RunTasksFn run_tasks, void* user)
    : Parallel(threads, run_tasks != nullptr ? ThreadBackend::run_tasks : ThreadBackend::pool) {
    run_tasks_ = run_tasks;
    user_ = user;
    if (backend_ == ThreadBackend::pool) pool_ = std::make_shared<ThreadPool>(threads_);
}

Parallel Parallel::openmp(int threads) noexcept { return {threads, ThreadBackend::openmp}; }

void Parallel::run(std::int64_t count, TaskFn task, void* context) const {
    if (!watch_.is_watched()) return run_unwatched(count, task, context);
    const auto watched = [&](std::int64_t i) {
        watch_.check();
        task(context, i);
    };
    run_unwatched(
        count, [](void* call, std::int64_t i) { (*static_cast<decltype(watched)*>(call))(i); },
        const_cast<void*>(static_cast<const void*>(std::addressof(watched))));
}

void Parallel::run_unwatched(std::int64_t count, TaskFn task, void* context) const {
    if (count <= 1 || backend_ == ThreadBackend::serial) {
        for (std::int64_t i = 0; i < count; ++i) {
            task(context, i);
        }
        return;
    }
    TaskGuard guarded(count, task, context);
    switch (backend_) {
    case ThreadBackend::pool: pool_->run(count, TaskGuard::run_task, &guarded); break;
    case ThreadBackend::openmp: run_openmp(threads_, count, TaskGuard::run_task, &guarded); break;
    default:
        run_tasks_(user_, TaskGuard::run_task_of_host, &guarded, count);
        guarded.rethrow();
        guarded.check_host();
    }
    guarded.rethrow();
}

} // namespace hrbfnpr::base
