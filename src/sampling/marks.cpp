#include "sampling/marks.h"

#include "base/random.h"

#include <algorithm>

namespace hrbfnpr::sampling {

// Some arrays are empty in some groups.
void Marks::move(std::int64_t from, std::int64_t to) noexcept {
    position.set(to, position[from]);
    normal.set(to, normal[from]);
    if (!direction.empty()) direction.set(to, direction[from]);
    if (!curvature.empty()) curvature[to] = curvature[from];
    if (!bend.empty()) bend[to] = bend[from];
    key[to] = key[from];
    stroke[to] = stroke[from];
    place[to] = place[from];
    level[to] = level[from];
}

void Marks::shrink(std::int64_t count) {
    position.resize(count);
    normal.resize(count);
    if (!direction.empty()) direction.resize(count);
    if (!curvature.empty()) curvature.resize(count);
    if (!bend.empty()) bend.resize(count);
    key.resize(count);
    stroke.resize(count);
    place.resize(count);
    level.resize(count);
}

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

} // namespace hrbfnpr::sampling
