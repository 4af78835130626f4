// Work on all threads.  parallel.cpp is the only file that names OpenMP.
//
// The result must not depend on the thread count: cut work by size (for_chunks),
// never by thread, and combine partial results in the order of the chunks.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <type_traits>

namespace hrbfnpr::base {

using TaskFn = void (*)(void* task_context, std::int64_t index);
using RunTasksFn = void (*)(void* user, TaskFn task, void* task_context, std::int64_t task_count);

class Parallel {
public:
    Parallel() noexcept = default; // serial
    // threads: 0 = all processors, 1 = serial.  run_tasks may be NULL: OpenMP.
    Parallel(int threads, RunTasksFn run_tasks, void* user) noexcept;

    [[nodiscard]] int threads() const noexcept { return threads_; }

    // Calls f(i) once for each i in [0, count), concurrently, and returns when all have
    // ended.  If some throw, the exception of the lowest such index is rethrown here and
    // higher indices that had not been started are skipped.
    template <class F>
    void for_each(std::int64_t count, F&& f) const {
        using Function = std::remove_reference_t<F>;
        run(
            count, [](void* context, std::int64_t i) { (*static_cast<Function*>(context))(i); },
            const_cast<void*>(static_cast<const void*>(std::addressof(f))));
    }

    // Calls f(begin, end) on consecutive pieces of [0, count) of at most `grain` elements.
    template <class F>
    void for_chunks(std::int64_t count, std::int64_t grain, F&& f) const {
        for_each((count + grain - 1) / grain,
                 [&](std::int64_t chunk) { f(chunk * grain, std::min(count, (chunk + 1) * grain)); });
    }

private:
    void run(std::int64_t count, TaskFn task, void* context) const;

    int threads_ = 1;
    RunTasksFn run_tasks_ = nullptr;
    void* user_ = nullptr;
};

// The name of the built-in backend, for build_info.
[[nodiscard]] const char* thread_backend_name() noexcept;

} // namespace hrbfnpr::base
