// SPDX-License-Identifier: MIT
// Many rounds of means at once.
#pragma once

#include "base/assert.h"
#include "base/memory.h"
#include "base/work.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::hatching {

// Replaces z by M^rounds z. mean(i, z) returns element i of M z. The eigenvalues of M must be real and between -1 and
// 1. The power is a sum of the Chebyshev polynomials T_k of M, whose weights are the probabilities of the places k of a
// random walk after `rounds` steps. Places beyond `deviations` standard deviations are left out, so only about
// deviations * sqrt(rounds) products with M are needed. With 3 deviations, 0.3 % of the weights are left out.
template <class Number, class Mean>
void apply_power(const base::Work& work, int rounds, double deviations, base::Array<Number>& z, const Mean& mean) {
    HRBFNPR_ASSERT(rounds >= 0 && deviations > 0.0);
    constexpr std::int64_t elements_a_task = 2048;
    base::Array<float> walk(work.memory, rounds + 2); // the probability of each place from 0 on
    walk[0] = 1.0F;
    for (int step = 0; step < rounds; ++step) {
        float before = walk[1];
        for (int place = 0; place <= rounds; ++place) {
            const float next = 0.5F * (before + walk[place + 1]);
            before = walk[place];
            walk[place] = next;
        }
    }
    const auto for_elements = [&](const auto& visit) {
        work.for_chunks(z.size(), elements_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) visit(i);
        });
    };
    base::Array<Number> now(work.memory, z.size());  // T_k z
    base::Array<Number> last(work.memory, z.size()); // T_(k - 1) z
    for_elements([&](std::int64_t i) {
        now[i] = z[i];
        z[i] = walk[0] * now[i];
    });
    const auto places = static_cast<int>(std::ceil(deviations * std::sqrt(rounds)));
    for (int place = 1; place <= std::min(places, rounds); ++place) {
        const float scale = place == 1 ? 1.0F : 2.0F;
        const float weight = 2.0F * walk[place]; // the walk may end on either side
        for_elements([&](std::int64_t i) {
            last[i] = scale * mean(i, now) - last[i];
            z[i] += weight * last[i];
        });
        std::swap(last, now);
    }
}

} // namespace hrbfnpr::hatching
