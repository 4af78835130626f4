// SPDX-License-Identifier: MIT
// Which parts of contours and borders are the outline of the drawing, its silhouette in the strict sense: nothing lies
// beside them on the side where their surface ends, neither before nor behind it.
#pragma once

#include "visibility/invisibility.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::visibility {

// From one place along a line to another, pixels.
struct OutlinePart {
    std::int32_t line;
    double begin_at, end_at; // the end of one round a closed line may be beyond the line's
};

struct Outline {
    explicit Outline(base::Memory& memory) noexcept : parts(memory) {}

    base::Array<OutlinePart> parts; // line by line, along it; of a closed line as its intervals are
    std::int64_t rays = 0;
    std::int64_t settled = 0; // lines whose counts contradict themselves: each of their parts is as its own ray says
};

// Of the lines of those subjects whose place in `wanted` is 1.  How many sheets the image has beside a line, in all,
// changes where another line that begins or ends sheets crosses it, before or behind it, and nowhere else: not at its
// own cusps.  [Benard & Hertzmann 2019, 4]  The same bits for any thread count.
[[nodiscard]] Outline find_outline(const base::Runtime& runtime, std::span<const Subject> subjects,
                                   std::span<const Occluder> occluders, const Invisibility& found,
                                   const Lengths& lengths, std::span<const std::uint8_t> wanted,
                                   const base::Progress& progress);

} // namespace hrbfnpr::visibility
