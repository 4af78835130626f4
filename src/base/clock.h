// SPDX-License-Identifier: MIT
// Measures wall-clock time in seconds and nanoseconds, for reports and short waits only.
#pragma once

#include <chrono>
#include <cstdint>

namespace hrbfnpr::base {

class Stopwatch {
public:
    [[nodiscard]] double seconds() const noexcept {
        return std::chrono::duration<double>(Clock::now() - start_).count();
    }
    [[nodiscard]] std::int64_t nanoseconds() const noexcept {
        return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - start_).count();
    }
    void restart() noexcept { start_ = Clock::now(); }

private:
    using Clock = std::chrono::steady_clock;
    Clock::time_point start_ = Clock::now();
};

} // namespace hrbfnpr::base
