// SPDX-License-Identifier: MIT
// A thread of the library's own.  thread.cpp is the only file that names the system's threads.
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

    // Runs work(user) on a thread of this name (15 characters at most).  False if the system
    // gives no thread; nothing is allocated but by the system.
    //
    // The thread takes none of the host's signals, but for those that a fault of its own raises and
    // a profiler's: a host that waits for signals on threads of its own goes on getting them there.
    [[nodiscard]] bool start(const char* name, Work work, void* user) noexcept;
    // To be called once after a start that was true.
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

// Processors that this process may run on: its affinity, where the system tells.
[[nodiscard]] int processor_count() noexcept;

// The processor that this thread runs on; -1 where the system does not tell.
[[nodiscard]] int current_processor() noexcept;

// Moves this thread to another processor that it may run on, if there is one; later the system may
// move it wherever it could before.
void leave_processor(int processor) noexcept;

// Differs between a process and its forked children.  Always the same where there is no fork().
[[nodiscard]] std::int64_t process_id() noexcept;

} // namespace hrbfnpr::base
