// SPDX-License-Identifier: MIT
// Runs work in a child process, so that its peak memory is its own, and ends it after a limit of time.
#pragma once

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <exception>
#include <stdexcept>

namespace bench {

struct ProcessUse {
    bool is_finished;      // false: the limit was reached, or the work failed
    double peak_megabytes; // largest resident memory
    double cpu_seconds;    // the time of all threads, in the program and in the kernel
};

// Runs `work` in a child process and fills `result`, which is copied as bytes, with what it returns. The caller must
// not have used the library yet, because threads do not survive a fork.
template <class Result, class Work>
[[nodiscard]] ProcessUse run_in_process(Work&& work, double limit_seconds, Result& result) {
    static_assert(std::is_trivially_copyable_v<Result>);
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child < 0) throw std::runtime_error("no process");
    if (child == 0) {
        int status = 1;
        try {
            const Result made = work();
            if (write(ends[1], &made, sizeof made) == static_cast<ssize_t>(sizeof made)) status = 0;
        } catch (const std::exception& error) {
            std::fprintf(stderr, "%s\n", error.what());
        }
        _exit(status);
    }
    close(ends[1]);
    pollfd waited = {ends[0], POLLIN, 0};
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(limit_seconds);
    int news = 0;
    do {
        const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(end - std::chrono::steady_clock::now());
        news = poll(&waited, 1, static_cast<int>(left.count() > 0 ? left.count() : 0));
    } while (news < 0 && errno == EINTR);
    if (news == 0) kill(child, SIGKILL);
    const bool is_read = news > 0 && read(ends[0], &result, sizeof result) == static_cast<ssize_t>(sizeof result);
    close(ends[0]);
    int status = 0;
    rusage use{};
    wait4(child, &status, 0, &use);
    const auto seconds = [](const timeval& t) {
        return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
#if defined(__APPLE__)
    const double megabytes = static_cast<double>(use.ru_maxrss) / (1024.0 * 1024.0);
#else
    const double megabytes = static_cast<double>(use.ru_maxrss) / 1024.0;
#endif
    return {is_read && status == 0, megabytes, seconds(use.ru_utime) + seconds(use.ru_stime)};
}

} // namespace bench
