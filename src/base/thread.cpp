// SPDX-License-Identifier: MIT
#include "base/thread.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <thread>

#if defined(_WIN32)
#include "base/windows.h"
#include <process.h>
#endif
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
#elif defined(_WIN32)
    // Systems older than Windows 10, version 1607, lack this function.
    using Describe = HRESULT(WINAPI*)(HANDLE, PCWSTR);
    const HMODULE kernel = GetModuleHandleW(L"kernel32.dll");
    if (kernel == nullptr) return;
    const FARPROC found = GetProcAddress(kernel, "SetThreadDescription");
    if (found == nullptr) return;
    wchar_t wide[16] = {};
    std::copy_n(name, std::min(std::strlen(name), std::size_t{15}), wide); // the names are ASCII
    reinterpret_cast<Describe>(reinterpret_cast<void (*)()>(found))(GetCurrentThread(), wide);
#endif
}

#endif

} // namespace

#if defined(_WIN32)

bool Thread::start(const char* name, Work work, void* user) noexcept {
    work_ = work;
    user_ = user;
    std::copy_n(name, std::min(std::strlen(name), sizeof name_ - 1), name_);
    const auto size = static_cast<unsigned>(stack_size);
    const std::uintptr_t started =
        _beginthreadex(nullptr, size, main, this, STACK_SIZE_PARAM_IS_A_RESERVATION, nullptr);
    handle_ = reinterpret_cast<void*>(started);
    return started != 0;
}

void Thread::join() noexcept {
    WaitForSingleObject(handle_, INFINITE);
    CloseHandle(handle_);
}

unsigned __stdcall Thread::main(void* thread) noexcept {
    const Thread& self = *static_cast<const Thread*>(thread);
    name_this_thread(self.name_);
    self.work_(self.user_);
    return 0;
}

#elif HRBFNPR_HAS_THREADS

bool Thread::start(const char* name, Work work, void* user) noexcept {
    work_ = work;
    user_ = user;
    std::copy_n(name, std::min(std::strlen(name), sizeof name_ - 1), name_);
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
#if defined(_WIN32)
    // Both masks are 0 if the process uses processors of several groups, each of which has at most 64.
    DWORD_PTR allowed = 0;
    DWORD_PTR present = 0;
    if (GetProcessAffinityMask(GetCurrentProcess(), &allowed, &present) != 0 && allowed != 0)
        return std::popcount(std::uint64_t{allowed});
#elif defined(__linux__)
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
