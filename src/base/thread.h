// SPDX-License-Identifier: MIT
// A thread that the library starts. Only thread.cpp calls the system's thread functions.
#pragma once

#include <cstdint>

#if defined(_WIN32)
#define HRBFNPR_HAS_THREADS 1
#elif __has_include(<pthread.h>)
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

    // Runs work(user) on a new thread with this name (at most 15 characters). Returns false if the system cannot start
    // a thread. The library itself allocates no memory for the thread.
    //
    // The thread blocks all signals, except the signals of its own faults and of profilers. So a host that waits for
    // signals on its own threads still receives them there.
    [[nodiscard]] bool start(const char* name, Work work, void* user) noexcept;
    // Call this once after each start that returned true.
    void join() noexcept;

private:
#if defined(_WIN32)
    static unsigned __stdcall main(void* thread) noexcept;
#else
    static void* main(void* thread) noexcept;
#endif

    Work work_ = nullptr;
    void* user_ = nullptr;
    char name_[16] = {};
#if defined(_WIN32)
    void* handle_ = nullptr;
#elif HRBFNPR_HAS_THREADS
    pthread_t handle_{};
#endif
};

// Returns the number of processors that this process may run on. It uses the affinity if the system reports it.
[[nodiscard]] int processor_count() noexcept;

// Returns the processor that this thread runs on, or -1 if the system does not report it.
[[nodiscard]] int current_processor() noexcept;

// Moves this thread away from `processor`, if the thread may run on another processor. Afterwards the system may move
// it to any processor that was allowed before.
void leave_processor(int processor) noexcept;

// Returns a number that differs between a process and its forked children. It is constant on systems without fork().
[[nodiscard]] std::int64_t process_id() noexcept;

} // namespace hrbfnpr::base
