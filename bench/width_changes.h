// SPDX-License-Identifier: MIT
// How the width of lines at each place of the surface changes from one frame to the next: where ink pops or vanishes.
#pragma once

#include "drawn_stroke.h"

#include <algorithm>

namespace bench {

// Of one mark in one frame.
struct MarkInk {
    float width = 0.0F;  // of the line drawn there, pixels; 0: none
    bool counts = false; // it faces the eye, away from contours, and lies in the picture
};

struct WidthChanges {
    double frames = 0.0;
    double shown = 0.0;    // marks with ink in one of two frames, summed over pairs
    double pops = 0.0;     // of these: by more than half of the widest that the mark is on the whole way
    double removals = 0.0; // of these: from a hundredth of it or more to less

    [[nodiscard]] double pop_rate() const { return pops / shown; }
    [[nodiscard]] double removal_rate() const { return removals / shown; }
};

// Frames after each other, of the same marks.
[[nodiscard]] inline WidthChanges width_changes(const std::vector<std::vector<MarkInk>>& frames) {
    std::vector<float> widest(frames.empty() ? 0 : frames[0].size(), 0.0F);
    for (const auto& frame : frames)
        for (std::size_t i = 0; i < frame.size(); ++i)
            if (frame[i].counts) widest[i] = std::max(widest[i], frame[i].width);
    WidthChanges changes;
    changes.frames = static_cast<double>(frames.size());
    for (std::size_t f = 1; f < frames.size(); ++f)
        for (std::size_t i = 0; i < widest.size(); ++i) {
            const MarkInk& before = frames[f - 1][i];
            const MarkInk& now = frames[f][i];
            const float least = 0.01F * widest[i];
            if (!before.counts || !now.counts || !(std::max(before.width, now.width) > least)) continue;
            changes.shown += 1.0;
            if (std::abs(before.width - now.width) > 0.5F * widest[i]) changes.pops += 1.0;
            if (before.width >= least && now.width < least) changes.removals += 1.0;
        }
    return changes;
}

// Where a mark is in its line; of marks one after the other along a line places are too.
struct MarkPlace {
    std::uint32_t line = 0;
    std::uint32_t first = 0; // mark of the line
    std::uint32_t count = 0; // of its marks
};

// Puts the widths of a stroke on all marks that it passes; a mark's number is its id - 1.
inline void add_widths(const DrawnStroke& stroke, const std::vector<MarkPlace>& places, std::vector<MarkInk>& inks) {
    const auto put = [&](std::uint32_t mark, float radius) {
        inks[mark].width = std::max(inks[mark].width, 2.0F * radius);
    };
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
        const std::uint32_t a = stroke[i].id - 1;
        const std::uint32_t b = stroke[i + 1].id - 1;
        const MarkPlace& line = places[a];
        put(a, stroke[i].radius);
        put(b, stroke[i + 1].radius);
        if (line.line != places[b].line || a == b) continue;
        // The shorter way, for closed lines.
        std::int64_t way = std::int64_t{b} - a;
        const std::int64_t around = line.count;
        if (2 * std::abs(way) > around) way += way > 0 ? -around : around;
        const std::int64_t steps = std::abs(way);
        for (std::int64_t k = 1; k < steps; ++k) {
            const std::int64_t at = (a - line.first + (way > 0 ? k : -k) + around) % around;
            const float t = static_cast<float>(k) / static_cast<float>(steps);
            put(line.first + static_cast<std::uint32_t>(at),
                stroke[i].radius + t * (stroke[i + 1].radius - stroke[i].radius));
        }
    }
}

} // namespace bench
