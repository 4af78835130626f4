// SPDX-License-Identifier: MIT
#include "base/parallel_openmp.h"

#include "base/shared_object.h"
#include "base/thread.h"

#include <algorithm>
#include <atomic>

#if defined(_OPENMP)
#include <omp.h>
#endif

namespace hrbfnpr::base {

#if defined(_OPENMP)

namespace {

// Returns whether this process may use OpenMP's threads. libgomp's pool does not survive fork(): the first region in a
// child process hangs for ever. So the process of the first parallel region is remembered, and all other processes run
// serially.
bool team_is_ours() noexcept {
    static std::atomic<std::int64_t> team_process{0};
    const std::int64_t self = process_id();
    std::int64_t owner = 0;
    if (!team_process.compare_exchange_strong(owner, self)) return owner == self;
    // The runtime's idle threads never end, so its code must stay loaded when this library is unloaded.
    keep_shared_object(reinterpret_cast<const void*>(&omp_get_num_procs));
    return true;
}

} // namespace

bool openmp_is_built_in() noexcept { return true; }

void run_openmp(int threads, std::int64_t count, TaskFn task, void* context) noexcept {
    const int team = team_is_ours() ? static_cast<int>(std::min<std::int64_t>(threads, count)) : 1;
    if (team > 1) {
#pragma omp parallel for schedule(dynamic, 1) num_threads(team)
        for (std::int64_t i = 0; i < count; ++i) task(context, i);
    } else {
        for (std::int64_t i = 0; i < count; ++i) task(context, i);
    }
}

#else

bool openmp_is_built_in() noexcept { return false; }

void run_openmp(int /*threads*/, std::int64_t count, TaskFn task, void* context) noexcept {
    for (std::int64_t i = 0; i < count; ++i) task(context, i);
}

#endif

} // namespace hrbfnpr::base
