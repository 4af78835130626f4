// SPDX-License-Identifier: MIT
// Seconds and ratios that are reliable on a busy machine: the two sides of a ratio are measured in turn within one run,
// and the median is reported.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <vector>

namespace bench {

template <class F>
[[nodiscard]] double seconds(F&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

[[nodiscard]] inline double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

struct Comparison {
    double seconds; // median of the second side
    double ratio;   // median of first / second
};

// Times `before` and `after` in turn, `runs` times each, after one run of both to warm up.
template <class Before, class After>
[[nodiscard]] Comparison compare(int runs, Before&& before, After&& after) {
    before();
    after();
    std::vector<double> times;
    std::vector<double> ratios;
    for (int run = 0; run < runs; ++run) {
        const double slow = seconds(before);
        times.push_back(seconds(after));
        ratios.push_back(slow / times.back());
    }
    return {median(times), median(ratios)};
}

inline void report(const char* name, double value) { std::printf("%s %.6g\n", name, value); }

} // namespace bench
