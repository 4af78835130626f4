// SPDX-License-Identifier: MIT
// A thread that the library starts.  thread.cpp is the only file that calls the system's thread functions.
#pragma once

#include <cstdint>

#if __has_include(<pthread.h>)
#include <pthread.h>
#define HRBFNPR_HAS_THREADS 1
#else
#define HRBFNPR_HAS_THREADS 0
#endif

namespace hrbfnpr::base {

class Thread {
public:
    using Work = void (*)(void* user);

    Thread() noexcept = default;
    Thread(const Thread&) = delete;
    Thread& operator=(const Thread&) = delete;

    // Runs work(user) on a new thread with this name (at most 15 characters).  Returns false if the system gives no
    // thread. Only the system allocates memory for it.
    //
    // The thread blocks all signals of the host, except those that its own faults raise and a profiler's. So a host
    // that waits for signals on its own threads still gets them there.
    [[nodiscard]] bool start(const char* name, Work work, void* user) noexcept;
    // Call this once after each start that returned true.
    void join() noexcept;

private:
    static void* main(void* thread) noexcept;

    Work work_ = nullptr;
    void* user_ = nullptr;
    char name_[16] = {};
#if HRBFNPR_HAS_THREADS
    pthread_t handle_{};
#endif
};

// The number of processors that this process may run on: its affinity, where the system tells it.
[[nodiscard]] int processor_count() noexcept;

// The processor that this thread runs on, or -1 where the system does not tell it.
[[nodiscard]] int current_processor() noexcept;

// Moves this thread to another processor that it may run on, if there is one. Afterwards the system may move it to any
// processor that was allowed before.
void leave_processor(int processor) noexcept;

// Differs between a process and its forked children.  It is always the same where there is no fork().
[[nodiscard]] std::int64_t process_id() noexcept;

} // namespace hrbfnpr::base
