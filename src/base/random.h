// SPDX-License-Identifier: MIT
// Counter-based random numbers: the number for (seed, index, purpose) is the same on every thread and in any order of
// calls.
//
// Philox4x32-10: Salmon, Moraes, Dror, Shaw, "Parallel random numbers: as easy as
// 1, 2, 3", SC 2011.
#pragma once

#include <array>
#include <cstdint>

namespace hrbfnpr::base {

// The purpose of a random number. Numbers of different purposes are independent.
enum class Purpose : std::uint32_t {
    box_jitter = 1,
    stipple_jitter = 2,
    rank = 3,
    budget = 4,
    patch = 5,
    candidate = 6,
    candidate_order = 7,
    probe = 8,
    layer = 9,
    wobble = 10,
    stripes = 11,
    hatch_hand = 12,
    mesh_sample = 20
};

using Philox = std::array<std::uint32_t, 4>;

[[nodiscard]] inline Philox philox(std::uint64_t seed, Philox counter) noexcept {
    std::uint32_t key0 = static_cast<std::uint32_t>(seed);
    std::uint32_t key1 = static_cast<std::uint32_t>(seed >> 32U);
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t product0 = std::uint64_t{0xD2511F53U} * counter[0];
        const std::uint64_t product1 = std::uint64_t{0xCD9E8D57U} * counter[2];
        counter = {
            static_cast<std::uint32_t>(product1 >> 32U) ^ counter[1] ^ key0, static_cast<std::uint32_t>(product1),
            static_cast<std::uint32_t>(product0 >> 32U) ^ counter[3] ^ key1, static_cast<std::uint32_t>(product0)};
        key0 += 0x9E3779B9U;
        key1 += 0xBB67AE85U;
    }
    return counter;
}

// Returns four independent uniform numbers in [0,1) with 32 bits each. Other values of `stream` give other numbers.
[[nodiscard]] inline std::array<double, 4> uniform4(std::uint64_t seed, std::uint64_t index, Purpose purpose,
                                                    std::uint32_t stream = 0) noexcept {
    const Philox bits = philox(seed, {static_cast<std::uint32_t>(index), static_cast<std::uint32_t>(index >> 32U),
                                      static_cast<std::uint32_t>(purpose), stream});
    constexpr double scale = 1.0 / 4294967296.0;
    return {bits[0] * scale, bits[1] * scale, bits[2] * scale, bits[3] * scale};
}

} // namespace hrbfnpr::base
