// SPDX-License-Identifier: MIT
// Processes that compete with the benchmark for the processors.
#pragma once

#include <csignal>
#include <cstdint>
#include <stdexcept>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#if defined(__linux__)
#include <sched.h>
#include <sys/prctl.h>
#endif

namespace bench {

// Runs busy loops in child processes until this object or the process ends.
class Busy {
public:
    static constexpr int anywhere = -1;

    Busy() = default;
    Busy(const Busy&) = delete;
    Busy& operator=(const Busy&) = delete;
    ~Busy() {
        for (const pid_t child : children_) {
            kill(child, SIGKILL);
            waitpid(child, nullptr, 0);
        }
    }

    // processor: the only one that the child may use.  lower: the child's priority is lower than ours by this, 0 to 19.
    void add(int processor = anywhere, int lower = 0) {
        const pid_t child = fork();
        if (child < 0) throw std::runtime_error("cannot fork");
        if (child == 0) work(processor, lower);
        children_.push_back(child);
    }

private:
    [[noreturn]] static void work(int processor, int lower) {
#if defined(__linux__)
        prctl(PR_SET_PDEATHSIG, SIGKILL);
        if (processor != anywhere) {
            cpu_set_t one;
            CPU_ZERO(&one);
            CPU_SET(static_cast<unsigned>(processor), &one);
            sched_setaffinity(0, sizeof one, &one);
        }
#endif
        [[maybe_unused]] const int now = ::nice(lower);
        for (volatile std::uint64_t count = 0;;) count = count + 1;
    }

    std::vector<pid_t> children_;
};

} // namespace bench
