// SPDX-License-Identifier: MIT
// How lines are drawn, and how a style's laws set their width: by depth, light and curvature at the points of
// curves, and along a line by whether it is part of the outline.
#pragma once

#include "base/list.h"
#include "base/runtime.h"
#include "frame/lines/line_numbers.h"
#include "frame/scene/scene.h"
#include "visibility/invisibility.h"

#include <algorithm>
#include <cstdint>
#include <span>

namespace hrbfnpr::frame {

// Lines of a subject that are drawn in a layer of the drawing.
struct DrawnAs {
    const LineStyle* style;
    std::int32_t subject;
    std::uint32_t layer;
    const float* strength = nullptr;  // the strength at each point of the subject's curves; null: all have the same
    float lower = 0.0F, upper = 0.0F; // strengths between which a line fades
    float halo = 0.0F; // pixels left free between a nearer line and the end of this one, by the item's style
    bool cut = false;  // parts weaker than `lower` are not drawn
    const float* factor = nullptr; // the factor of the width at each point of the subject's curves; null: 1
};

[[nodiscard]] inline float strength_at(const DrawnAs& as, const visibility::Piece& piece, float share) noexcept {
    return (1.0F - share) * as.strength[piece.a] + share * as.strength[piece.b];
}

// The opacity of a line by its strength at a place.
[[nodiscard]] inline float faded(const DrawnAs& as, const visibility::Piece& piece, float share) noexcept {
    if (as.strength == nullptr || !(as.upper > as.lower)) return 1.0F;
    const float full = std::clamp((strength_at(as, piece, share) - as.lower) / (as.upper - as.lower), 0.0F, 1.0F);
    return 1.0F - as.style->fade * (1.0F - full);
}

// The lines of all items, and how they are drawn.
struct LineInput {
    std::span<const visibility::Subject> subjects;
    std::span<const visibility::Occluder> occluders;
    std::span<const std::int32_t> items; // the drawing's item of each occluder
    std::span<const DrawnAs> styles;
    const visibility::Invisibility& found;
    const visibility::Lengths& lengths;
    const LineNumbers& numbers;
};

class WidthLaws {
public:
    // Throws Error{callback, out_of_memory}.
    WidthLaws(const base::Runtime& runtime, const Scene& scene, const drawing::Drawing& drawing, const LineInput& input,
              const base::Progress& progress);

    // The styles of the input, with the factors of points.
    [[nodiscard]] std::span<const DrawnAs> styles() const noexcept { return styles_.span(); }

    // A factor of the width at a place along a line, besides that of the points around it.
    [[nodiscard]] double along(const DrawnAs& as, std::int32_t line, double at) const noexcept;
    // Whether that is not 1 everywhere, and whether it changes between two places along a line.
    [[nodiscard]] static bool changes_along(const DrawnAs& as) noexcept;
    [[nodiscard]] bool changes(const DrawnAs& as, std::int32_t line, double from, double to) const noexcept;
    // The longest chord of the line where it does, pixels.
    [[nodiscard]] static double step(const DrawnAs& as) noexcept;

private:
    [[nodiscard]] std::span<const visibility::OutlinePart> outline_of(std::int32_t line) const noexcept;
    // The length of a closed line, pixels; 0 for an open one.
    [[nodiscard]] double round(std::int32_t line) const noexcept {
        const visibility::Line& its = input_.found.lines.lines[line];
        return its.closed ? input_.lengths.whole(its) : 0.0;
    }

    LineInput input_;
    base::Array<DrawnAs> styles_;
    // For each style whose width varies by point, a factor for each point of its subject.
    base::List<base::Array<float>> factors_;
    visibility::Outline outline_;
};

} // namespace hrbfnpr::frame
