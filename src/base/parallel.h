// SPDX-License-Identifier: MIT
// Runs work on all threads. The threads belong to the library's pool, to OpenMP, or to the host's job system.
//
// Results must not depend on the number of threads. So work must be divided by size (for_chunks), never by thread, and
// partial results must be combined in the order of the chunks.
#pragma once

#include "base/operation.h"
#include "base/thread_pool.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace hrbfnpr::base {

using RunTasksFn = void (*)(void* user, TaskFn task, void* task_context, std::int64_t task_count);

enum class ThreadBackend : std::uint32_t { automatic = 0, pool = 1, openmp = 2, run_tasks = 3, serial = 4 };

// Copies share their thread pool, which ends with the last copy.
class Parallel {
public:
    Parallel() noexcept = default; // runs everything on the calling thread
    // `threads` is 0 for all processors, or 1 for the calling thread alone. If run_tasks is NULL, the library's pool is
    // used.
    Parallel(int threads, RunTasksFn run_tasks, void* user);
    // Uses the pool of the OpenMP runtime. In a build without OpenMP (openmp_is_built_in) it runs everything on the
    // calling thread.
    [[nodiscard]] static Parallel openmp(int threads) noexcept;

    // From now on, each loop ends before its next task if the operation of `progress` is cancelled. watch(Progress())
    // stops this. Do not call it while a loop runs. It does not affect copies of this object.
    void watch(const Progress& progress) noexcept { watch_ = progress; }

    [[nodiscard]] int threads() const noexcept { return threads_; }
    [[nodiscard]] ThreadBackend backend() const noexcept { return backend_; }

    // Calls f(i) once for each i in [0, count), concurrently, and returns when all calls have ended. If calls throw,
    // the exception of the lowest index is rethrown here; calls with higher indices that have not started are skipped.
    template <class F>
    void for_each(std::int64_t count, F&& f) const {
        using Function = std::remove_reference_t<F>;
        run(
            count, [](void* context, std::int64_t i) { (*static_cast<Function*>(context))(i); },
            const_cast<void*>(static_cast<const void*>(std::addressof(f))));
    }

    // Calls f(begin, end) on consecutive chunks of [0, count) of at most `grain` elements.
    template <class F>
    void for_chunks(std::int64_t count, std::int64_t grain, F&& f) const {
        for_each((count + grain - 1) / grain,
                 [&](std::int64_t chunk) { f(chunk * grain, std::min(count, (chunk + 1) * grain)); });
    }

    // The next two functions work like for_each and for_chunks, but check for cancellation before each call.
    template <class F>
    void for_each(std::int64_t count, const Progress& progress, F&& f) const {
        for_each(count, [&](std::int64_t i) {
            progress.check();
            f(i);
        });
    }
    template <class F>
    void for_chunks(std::int64_t count, std::int64_t grain, const Progress& progress, F&& f) const {
        for_chunks(count, grain, [&](std::int64_t begin, std::int64_t end) {
            progress.check();
            f(begin, end);
        });
    }

private:
    Parallel(int threads, ThreadBackend backend) noexcept;

    void run(std::int64_t count, TaskFn task, void* context) const;
    void run_unwatched(std::int64_t count, TaskFn task, void* context) const;

    int threads_ = 1;
    ThreadBackend backend_ = ThreadBackend::serial;
    RunTasksFn run_tasks_ = nullptr;
    void* user_ = nullptr;
    std::shared_ptr<ThreadPool> pool_;
    Progress watch_;
};

} // namespace hrbfnpr::base
