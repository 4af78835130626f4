// SPDX-License-Identifier: MIT
#include "drawing/far_to_near.h"

#include "base/assert.h"
#include "base/scratch.h"

#include <utility>

namespace hrbfnpr::drawing {
namespace {

constexpr std::int64_t keys_a_task = 16384;
constexpr unsigned digit_bits = 8;
constexpr std::int64_t digits = std::int64_t{1} << digit_bits;

[[nodiscard]] std::int64_t digit_of(std::uint64_t key, unsigned shift) noexcept {
    return static_cast<std::int64_t>(key >> shift & std::uint64_t{digits - 1});
}

} // namespace

void FarToNear::sort(const base::Parallel& parallel, base::Array<std::uint64_t>& keys) {
    base::resize_scratch(other_, keys.size());
    for (unsigned shift = 32; shift < 64; shift += digit_bits) {
        if (pass(parallel, keys, other_, shift)) std::swap(keys, other_);
    }
}

// Sorts by one digit. Returns false, with `to` untouched, if all keys share it.
bool FarToNear::pass(const base::Parallel& parallel, const base::Array<std::uint64_t>& from,
                     base::Array<std::uint64_t>& to, unsigned shift) {
    HRBFNPR_ASSERT(to.size() == from.size());
    const std::int64_t count = from.size();
    const std::int64_t chunks = (count + keys_a_task - 1) / keys_a_task;
    base::resize_scratch(histogram_, chunks * digits);
    parallel.for_chunks(count, keys_a_task, [&](std::int64_t begin, std::int64_t end) {
        std::int64_t* const own = histogram_.data() + begin / keys_a_task * digits;
        std::fill(own, own + digits, std::int64_t{0});
        for (std::int64_t i = begin; i < end; ++i) ++own[digit_of(from[i], shift)];
    });
    std::int64_t total = 0;
    for (std::int64_t digit = 0; digit < digits; ++digit) {
        const std::int64_t before = total;
        for (std::int64_t chunk = 0; chunk < chunks; ++chunk)
            total += std::exchange(histogram_[chunk * digits + digit], total);
        if (total - before == count) return false;
    }
    parallel.for_chunks(count, keys_a_task, [&](std::int64_t begin, std::int64_t end) {
        std::int64_t* const own = histogram_.data() + begin / keys_a_task * digits;
        for (std::int64_t i = begin; i < end; ++i) to[own[digit_of(from[i], shift)]++] = from[i];
    });
    return true;
}

} // namespace hrbfnpr::drawing
