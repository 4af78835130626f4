// SPDX-License-Identifier: MIT
// Where the number of sheets before a line changes, and the parts of the line between.
#pragma once

#include "visibility/crossings.h"
#include "visibility/pierced.h"

#include <span>

namespace hrbfnpr::visibility {

struct Event {
    std::int32_t piece;
    double share;
    std::int32_t change;
    std::int32_t near_piece; // of the line that crosses before it; -1: a cusp; no_line: it passes a surface
    double at;               // along its line, pixels
    float sine = 0.0F;       // of the angle to the line that crosses; 0 of a cusp
    double near_share = 0.5; // along the piece of the line that crosses
};

// Lengths along the images of lines, which must outlive it.
class Lengths {
public:
    Lengths(base::Memory& memory, const ImageLines& lines);

    // From the line's begin, pixels.
    [[nodiscard]] double at(const Line& line, std::int64_t piece, double share) const noexcept;
    // The same of a point of the image.
    [[nodiscard]] double at_point(std::int64_t point) const noexcept { return length_[point]; }
    [[nodiscard]] double whole(const Line& line) const noexcept { return length_[line.first_point + line.points - 1]; }

private:
    const ImageLines& lines_;
    base::Array<double> length_;      // of its line, up to each point of the image
    base::Array<std::int64_t> first_; // point of each piece
};

// Of all lines, line by line, along each.
struct Events {
    explicit Events(base::Memory& memory) noexcept : first(memory), event(memory) {}

    [[nodiscard]] std::span<const Event> of(std::int64_t line) const noexcept {
        return event.span().subspan(static_cast<std::size_t>(first[line]),
                                    static_cast<std::size_t>(first[line + 1] - first[line]));
    }

    base::Array<std::int64_t> first; // of each line, and the end
    base::Array<Event> event;
    std::int64_t cusps = 0;
};

// crossings, pierced: sorted as find_crossings() and find_pierced() leave them.
[[nodiscard]] Events collect_events(base::Memory& memory, std::span<const Subject> subjects, const ImageLines& lines,
                                    const base::Array<Crossing>& crossings, std::span<const Pierced> pierced,
                                    const Lengths& lengths);

} // namespace hrbfnpr::visibility
