#include "base/parallel.h"

#include "base/fp_state.h"

#include <atomic>
#include <exception>
#include <limits>
#include <mutex>
#include <thread>

#if defined(_OPENMP)
#include <omp.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <pthread.h>
#include <unistd.h>
#define HRBFNPR_HAS_FORK 1
#endif

namespace hrbfnpr::base {
namespace {

constexpr int most_threads = 256;

#if defined(HRBFNPR_HAS_FORK)
// libgomp's pool does not survive fork(): its first region in the child hangs for ever.
// The pid at the first parallel region is remembered; another pid means "go serial".
bool pool_is_ours() noexcept {
    static std::atomic<long> pool_pid{0};
    const long self = static_cast<long>(getpid());
    long owner = 0;
    return pool_pid.compare_exchange_strong(owner, self) || owner == self;
}
#else
bool pool_is_ours() noexcept { return true; }
#endif

// One for_each: hands out tasks and keeps the exception of the lowest index, since
// one that leaves an OpenMP region, or a host's job, would abort the process.
class Job {
public:
    Job(TaskFn task, void* context) noexcept : task_(task), context_(context) {}

    void operator()(std::int64_t index) noexcept {
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

    void rethrow() {
        if (error_) std::rethrow_exception(error_);
    }

private:
    TaskFn task_;
    void* context_;
    // Lower indices go on after a failure, so that the same one is reported whatever the order.
    std::atomic<std::int64_t> first_failed_{std::numeric_limits<std::int64_t>::max()};
    std::mutex mutex_;
    std::exception_ptr error_;
};

void run_job(void* job, std::int64_t index) { (*static_cast<Job*>(job))(index); }

int processor_count() noexcept {
#if defined(_OPENMP)
    return omp_get_num_procs(); // honours the process's affinity mask
#else
    return 1;
#endif
}

} // namespace

Parallel::Parallel(int threads, RunTasksFn run_tasks, void* user) noexcept
    : threads_(std::clamp(threads > 0 ? threads : processor_count(), 1, most_threads)), run_tasks_(run_tasks),
      user_(user) {}

void Parallel::run(std::int64_t count, TaskFn task, void* context) const {
    if (count <= 0) return;
    if (count == 1 || threads_ == 1 || (run_tasks_ == nullptr && !pool_is_ours())) {
        for (std::int64_t i = 0; i < count; ++i) task(context, i);
        return;
    }
    Job job(task, context);
    if (run_tasks_ != nullptr) {
        run_tasks_(user_, run_job, &job, count);
    } else {
#if defined(_OPENMP)
        const int team = static_cast<int>(std::min<std::int64_t>(threads_, count));
#pragma omp parallel for schedule(dynamic, 1) num_threads(team)
        for (std::int64_t i = 0; i < count; ++i) job(i);
#else
        for (std::int64_t i = 0; i < count; ++i) job(i);
#endif
    }
    job.rethrow();
}

const char* thread_backend_name() noexcept {
#if defined(_OPENMP)
    return "OpenMP";
#else
    return "none";
#endif
}

} // namespace hrbfnpr::base
