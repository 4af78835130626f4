// SPDX-License-Identifier: MIT
#include "marks/marks.h"

#include "base/random.h"

#include <algorithm>

namespace hrbfnpr::marks {

std::int64_t grown_count(std::int64_t base, std::int64_t factor, std::int32_t levels) noexcept {
    for (std::int32_t level = 0; level < levels; ++level) base *= factor;
    return base;
}

void require_room(std::int64_t layer, std::int64_t full_count, std::int32_t levels, std::int64_t budget) {
    if (full_count <= most_marks || (budget > 0 && budget <= most_marks)) return;
    if (layer < 0)
        fail(Status::invalid_argument, "start_level = %d would grow to %lld stipples, and %lld are the most: lower it",
             levels, static_cast<long long>(full_count), static_cast<long long>(most_marks));
    fail(
        Status::invalid_argument,
        "layers[%lld].levels = %d would grow to %lld marks, and %lld are the most: lower it or set layers[%lld].budget",
        static_cast<long long>(layer), levels, static_cast<long long>(full_count), static_cast<long long>(most_marks),
        static_cast<long long>(layer));
}

// Those of one layer of stipples, principal and combing strokes have the set's own seed.
std::uint64_t layer_seed(std::uint64_t random_seed, Kind kind, std::int64_t number) noexcept {
    const bool own = kind == Kind::field || kind == Kind::own;
    if (number == 0 && !own) return random_seed;
    const auto n = static_cast<std::uint64_t>(number);
    const base::Philox bits =
        base::philox(random_seed, {static_cast<std::uint32_t>(n), static_cast<std::uint32_t>(n >> 32U),
                                   static_cast<std::uint32_t>(base::Purpose::layer), static_cast<std::uint32_t>(kind)});
    return static_cast<std::uint64_t>(bits[0]) << 32U | bits[1];
}

std::uint64_t Thinning::ticket(std::uint64_t key) const noexcept {
    const base::Philox bits =
        base::philox(seed_, {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32U),
                             static_cast<std::uint32_t>(base::Purpose::budget), stream_});
    return static_cast<std::uint64_t>(bits[0]) << 32U | bits[1];
}

void Thinning::choose(base::Array<std::uint64_t>& tickets, std::int64_t kept) {
    std::nth_element(tickets.begin(), tickets.begin() + kept, tickets.end());
    limit_ = tickets[kept];
}

} // namespace hrbfnpr::marks
