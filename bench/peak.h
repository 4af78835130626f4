// SPDX-License-Identifier: MIT
// The peak of this machine in floating-point operations per second, in double precision.
#pragma once

#include "timing.h"

#include <cstdint>
#include <thread>
#include <vector>

namespace bench {

namespace detail {

constexpr std::int64_t steps = 40'000'000;
constexpr int chains = 12; // concurrent multiply-adds: more than latency times ports

// 8 doubles per vector; the compiler splits it if the processor's vectors are shorter.
using Vector = double __attribute__((vector_size(64)));

#if defined(__x86_64__)
#define HRBFNPR_BENCH_CLONES __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define HRBFNPR_BENCH_CLONES
#endif

HRBFNPR_BENCH_CLONES inline double multiply_add() {
    Vector sum[chains];
    for (int k = 0; k < chains; ++k) sum[k] = Vector{} + static_cast<double>(k);
    const Vector factor = Vector{} + 0.999999;
    for (std::int64_t step = 0; step < steps / chains; ++step)
        for (auto& s : sum) s = s * factor + factor;
    double total = 0.0;
    for (const auto& s : sum) total += s[0];
    return total;
}

} // namespace detail

// Returns the flops per second of `threads` threads together; the best of three tries.
[[nodiscard]] inline double peak_flops(int threads) {
    double best = 0.0;
    for (int attempt = 0; attempt < 3; ++attempt) {
        std::vector<double> sums(static_cast<std::size_t>(threads));
        const double time = seconds([&] {
            std::vector<std::thread> team;
            for (auto& sum : sums) team.emplace_back([&sum] { sum = detail::multiply_add(); });
            for (auto& member : team) member.join();
        });
        const double flops = 16.0 * static_cast<double>(detail::steps) * threads / time;
        if (sums[0] != 0.0 && flops > best) best = flops;
    }
    return best;
}

} // namespace bench
