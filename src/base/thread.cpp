// SPDX-License-Identifier: MIT
#include "base/thread.h"

#include <algorithm>
#include <cstring>
#include <thread>

#if defined(__linux__)
#include <sched.h>
#endif
#if defined(__unix__) || defined(__APPLE__)
#include <csignal>
#include <unistd.h>
#define HRBFNPR_IS_POSIX 1
#endif

namespace hrbfnpr::base {
namespace {

#if HRBFNPR_HAS_THREADS

// The stack size of threads, in bytes. The fit's dense products need up to 276 KiB, and more with sanitizers. Some
// systems have a smaller default.
constexpr std::size_t stack_size = std::size_t{2} << 20U;

// Blocks all signals of the thread as long as the object exists. New threads inherit the blocked signals.
class SignalBlocker {
public:
#if defined(HRBFNPR_IS_POSIX)
    SignalBlocker() noexcept {
        sigset_t blocked;
        sigfillset(&blocked);
        for (const int own : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS, SIGPROF})
            sigdelset(&blocked, own);
        pthread_sigmask(SIG_SETMASK, &blocked, &old_mask_);
    }
    ~SignalBlocker() { pthread_sigmask(SIG_SETMASK, &old_mask_, nullptr); }
#else
    SignalBlocker() noexcept = default;
    ~SignalBlocker() = default;
#endif
    SignalBlocker(const SignalBlocker&) = delete;
    SignalBlocker& operator=(const SignalBlocker&) = delete;

#if defined(HRBFNPR_IS_POSIX)
private:
    sigset_t old_mask_{};
#endif
};

void name_this_thread([[maybe_unused]] const char* name) noexcept {
#if defined(__APPLE__)
    pthread_setname_np(name);
#elif defined(__linux__)
    pthread_setname_np(pthread_self(), name);
#endif
}

#endif

} // namespace

#if HRBFNPR_HAS_THREADS

bool Thread::start(const char* name, Work work, void* user) noexcept {
    work_ = work;
    user_ = user;
    std::strncpy(name_, name, sizeof name_ - 1);
    const SignalBlocker blocked;
    pthread_attr_t attributes;
    if (pthread_attr_init(&attributes) != 0) return false;
    pthread_attr_setstacksize(&attributes, stack_size);
    const bool started = pthread_create(&handle_, &attributes, main, this) == 0;
    pthread_attr_destroy(&attributes);
    return started;
}

void Thread::join() noexcept { pthread_join(handle_, nullptr); }

void* Thread::main(void* thread) noexcept {
    const Thread& self = *static_cast<const Thread*>(thread);
    name_this_thread(self.name_);
    self.work_(self.user_);
    return nullptr;
}

#else

bool Thread::start(const char* /*name*/, Work /*work*/, void* /*user*/) noexcept { return false; }
void Thread::join() noexcept {}

#endif

int processor_count() noexcept {
#if defined(__linux__)
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) == 0) return std::max(CPU_COUNT(&allowed), 1);
#endif
    return std::max(static_cast<int>(std::thread::hardware_concurrency()), 1);
}

#if defined(__linux__)

int current_processor() noexcept { return sched_getcpu(); }

void leave_processor(int processor) noexcept {
    cpu_set_t allowed;
    if (processor < 0 || sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    cpu_set_t others = allowed;
    CPU_CLR(static_cast<unsigned>(processor), &others);
    if (CPU_COUNT(&others) == 0) return;
    // The first call moves the thread. The second call restores the affinity, but the thread stays where it is.
    if (sched_setaffinity(0, sizeof others, &others) == 0) sched_setaffinity(0, sizeof allowed, &allowed);
}

#else

int current_processor() noexcept { return -1; }
void leave_processor(int /*processor*/) noexcept {}

#endif

std::int64_t process_id() noexcept {
#if defined(HRBFNPR_IS_POSIX)
    return static_cast<std::int64_t>(getpid());
#else
    return 1;
#endif
}

} // namespace hrbfnpr::base
