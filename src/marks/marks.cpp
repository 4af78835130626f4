// SPDX-License-Identifier: MIT
#include "marks/marks.h"

#include "base/random.h"

#include <algorithm>
#include <array>

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

// The first layer of stipples and the first of hatching have the set's own seed.
std::uint64_t layer_seed(std::uint64_t random_seed, Kind kind, std::int64_t number) noexcept {
    if (number == 0 && kind != Kind::own) return random_seed;
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

// The limit is the ticket of place `kept`.  Tickets are uniform: of those that share their first bits with it there are
// few, and the others are only counted.
void Thinning::choose(base::Array<std::uint64_t>& tickets, std::int64_t kept, const base::Progress& progress) {
    HRBFNPR_ASSERT(kept >= 0 && kept < tickets.size());
    constexpr unsigned first_bits = 52; // tickets have 64 bits, and each value of the upper 12 has a counter
    constexpr std::int64_t at_once = 262144;
    std::array<std::int64_t, std::size_t{1} << (64U - first_bits)> counted{};
    for (std::int64_t i = 0; i < tickets.size(); ++i) {
        if (i % at_once == 0) progress.check();
        ++counted[static_cast<std::size_t>(tickets[i] >> first_bits)];
    }
    std::uint64_t first = 0;
    for (; kept >= counted[static_cast<std::size_t>(first)]; ++first) kept -= counted[static_cast<std::size_t>(first)];
    std::int64_t alike = 0;
    for (std::int64_t i = 0; i < tickets.size(); ++i) {
        if (i % at_once == 0) progress.check();
        if (tickets[i] >> first_bits == first) tickets[alike++] = tickets[i];
    }
    std::nth_element(tickets.begin(), tickets.begin() + kept, tickets.begin() + alike);
    limit_ = tickets[kept];
}

} // namespace hrbfnpr::marks
