// SPDX-License-Identifier: MIT
// How the width of lines at each place of the surface changes from one frame to the next: where ink pops or vanishes.
#pragma once

#include "drawn_stroke.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <optional>

namespace bench {

// One mark in one frame.
struct MarkInk {
    float width = 0.0F;  // width of the line drawn there, pixels; 0: no line
    bool counts = false; // it faces the eye, away from contours, and is in the picture
};

struct WidthChanges {
    double frames = 0.0;
    double shown = 0.0;    // marks with ink in at least one of two consecutive frames, summed over pairs of frames
    double pops = 0.0;     // those whose width changes by more than half of their full width
    double removals = 0.0; // those whose width falls from a hundredth of the full width or more to less

    [[nodiscard]] double pop_rate() const { return pops / shown; }
    [[nodiscard]] double removal_rate() const { return removals / shown; }
};

// Compares consecutive frames of the same marks.  A mark's full width is its greatest width in all frames, but at least
// the pen, because at a line's tip it may never be more than a hair.
[[nodiscard]] inline WidthChanges width_changes(const std::vector<std::vector<MarkInk>>& frames, float pen = 0.0F) {
    std::vector<float> widest(frames.empty() ? 0 : frames[0].size(), pen);
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

// The place of a mark in its line; consecutive marks along a line have consecutive numbers.
struct MarkPlace {
    std::uint32_t line = 0;
    std::uint32_t first = 0; // the number of the line's first mark
    std::uint32_t count = 0; // the number of marks
    bool closed = false;     // the line's last mark is beside its first one
};

// The place of a stroke nearest to a mark's image.
struct NearestPlace {
    std::size_t mark = 0;
    float distance = 0.0F; // pixels
    float width = 0.0F;
};

[[nodiscard]] inline NearestPlace nearest_place(std::size_t mark, const glm::vec2& image, const StrokePoint& a,
                                                const StrokePoint& b) {
    const glm::vec2 from(a.x, a.y);
    const glm::vec2 way = glm::vec2(b.x, b.y) - from;
    const float square = glm::dot(way, way);
    const float t = square > 0.0F ? std::clamp(glm::dot(image - from, way) / square, 0.0F, 1.0F) : 0.0F;
    return {mark, glm::distance(from + t * way, image), 2.0F * (a.radius + t * (b.radius - a.radius))};
}

// Returns the number of marks along the line from the mark of a stroke's point to that of the next point; nothing if
// they are on two lines.
[[nodiscard]] inline std::optional<std::int64_t> way_after(const DrawnStroke& stroke, std::size_t point,
                                                           const std::vector<MarkPlace>& places) {
    if (point + 1 >= stroke.size()) return std::nullopt;
    const std::uint32_t a = stroke[point].id - 1;
    const std::uint32_t b = stroke[point + 1].id - 1;
    const MarkPlace& line = places[a];
    if (line.line != places[b].line) return std::nullopt;
    std::int64_t way = std::int64_t{b} - std::int64_t{a};
    const std::int64_t around = line.count;
    if (line.closed && 2 * std::abs(way) > around) way += way > 0 ? -around : around; // the shorter way
    return way;
}

// Sets the widths at all marks that a stroke passes. Each is the stroke's width where it is nearest to the mark's
// image, in pixels, if that is within a pixel.  A mark's number is its id - 1.
inline void add_widths(const DrawnStroke& stroke, const std::vector<MarkPlace>& places,
                       const std::vector<glm::vec2>& images, std::vector<MarkInk>& inks) {
    std::vector<NearestPlace> found;
    for (std::size_t i = 0; i + 1 < stroke.size(); ++i) {
        const std::optional<std::int64_t> way = way_after(stroke, i, places);
        if (!way) continue;
        const std::uint32_t own = stroke[i].id - 1;
        const MarkPlace& line = places[own];
        const std::int64_t around = line.count;
        // Also test the marks on both sides: points near a tip may carry a mark as far away as the next one.
        const std::int64_t before = i > 0 ? std::abs(way_after(stroke, i - 1, places).value_or(0)) : 0;
        const std::int64_t beside = 1 + std::max(before, std::abs(way_after(stroke, i + 1, places).value_or(0)));
        const std::int64_t first = std::int64_t{own} - line.first;
        const std::int64_t low = first + std::min<std::int64_t>(*way, 0) - beside;
        const std::int64_t high = first + std::max<std::int64_t>(*way, 0) + beside;
        for (std::int64_t k = low; k <= high; ++k) {
            if (!line.closed && (k < 0 || k >= around)) continue;
            const auto mark = static_cast<std::size_t>(line.first + (k % around + around) % around);
            found.push_back(nearest_place(mark, images[mark], stroke[i], stroke[i + 1]));
        }
    }
    std::sort(found.begin(), found.end(), [](const NearestPlace& a, const NearestPlace& b) {
        return a.mark != b.mark ? a.mark < b.mark : a.distance < b.distance;
    });
    for (std::size_t i = 0; i < found.size(); ++i)
        if ((i == 0 || found[i - 1].mark != found[i].mark) && found[i].distance <= 1.0F)
            inks[found[i].mark].width = std::max(inks[found[i].mark].width, found[i].width);
}

} // namespace bench
