// SPDX-License-Identifier: MIT
// OpenMP as a thread backend.  parallel_openmp.cpp is the only file that uses OpenMP.
#pragma once

#include "base/thread_pool.h"

#include <cstdint>

namespace hrbfnpr::base {

[[nodiscard]] bool openmp_is_built_in() noexcept;

// Calls task(context, i) once for each i in [0, count) on at most `threads` threads. In a forked child, and in a build
// without OpenMP, it uses only the calling thread. Tasks must not throw.
void run_openmp(int threads, std::int64_t count, TaskFn task, void* context) noexcept;

} // namespace hrbfnpr::base
