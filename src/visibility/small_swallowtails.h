// SPDX-License-Identifier: MIT
// Groups of cusps too close to each other to be seen.
#pragma once

#include "visibility/events.h"

#include <span>

namespace hrbfnpr::visibility {

class SmallSwallowtails {
public:
    SmallSwallowtails(base::Memory& memory, const Line& line, const Lengths& lengths, double size) noexcept
        : line_(line), lengths_(lengths), size_(size), groups_(memory), cusps_(memory) {}

    // Of a line's events those that count.  Where the changes of a group do not add up, a crossing of its branches was
    // missed or doubled: then no cusp of it counts, or one where they are odd in number, and none of these crossings.
    void keep(std::span<const Event> events, base::Array<Event>& kept);

private:
    // From the first to the last cusp, pixels along the line; `end` may lie beyond the line's end, if it is closed.
    struct Group {
        double begin, end;
        double before, after; // to the cusps of the line beside it
        bool odd;
        std::int64_t last; // cusp, of the events
    };

    [[nodiscard]] double whole() const noexcept { return lengths_.whole(line_); }
    [[nodiscard]] bool within(const Group& group, double at, double beside) const noexcept;
    [[nodiscard]] double from_begin(const Group& group, double at) const noexcept;
    [[nodiscard]] bool is_cusp_of(const Group& group, const Event& e) const noexcept {
        return within(group, e.at, 1e-9 * size_);
    }
    [[nodiscard]] bool crosses_itself(const Group& group, const Event& e) const noexcept;
    [[nodiscard]] bool adds_up(const Group& group, std::span<const Event> events) const noexcept;
    void find_groups(std::span<const Event> events);

    const Line& line_;
    const Lengths& lengths_;
    double size_;
    base::Array<Group> groups_; // of two cusps and more
    base::Array<std::int64_t> cusps_;
};

} // namespace hrbfnpr::visibility
