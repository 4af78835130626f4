#include "marks/marks.h"

#include "base/random.h"

#include <algorithm>

namespace hrbfnpr::marks {

std::int64_t grown_count(std::int64_t base, std::int64_t factor, std::int32_t levels) noexcept {
    for (std::int32_t level = 0; level < levels; ++level) base *= factor;
    return base;
}

void require_room(int group, std::int64_t full_count, std::int32_t levels, std::int64_t budget) {
    if (full_count <= most_marks || (budget > 0 && budget <= most_marks)) return;
    fail(Status::invalid_argument,
         "group[%d].levels = %d would grow to %lld marks, and %lld are the most: lower levels or set group[%d].budget",
         group, levels, static_cast<long long>(full_count), static_cast<long long>(most_marks), group);
}

std::uint64_t Thinning::ticket(std::uint64_t key) const noexcept {
    const base::Philox bits =
        base::philox(seed_, {static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32U),
                             static_cast<std::uint32_t>(base::Purpose::budget), lane_});
    return static_cast<std::uint64_t>(bits[0]) << 32U | bits[1];
}

void Thinning::choose(base::Array<std::uint64_t>& tickets, std::int64_t kept) {
    std::nth_element(tickets.begin(), tickets.begin() + kept, tickets.end());
    limit_ = tickets[kept];
}

} // namespace hrbfnpr::marks
