// SPDX-License-Identifier: MIT
// How lines are drawn, and what the laws of a style say of their width: by depth, light and curvature at the points of
// curves, and by what lies beside a line along it.
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
    const float* strength = nullptr;  // of the points of the subject's curves; null: lines of one strength
    float lower = 0.0F, upper = 0.0F; // strengths between which a line fades
    float halo = 0.0F;                // of its item's style: pixels between a nearer line and where this one ends
    bool cut = false;                 // what is weaker than `lower` is not drawn
    const float* factor = nullptr;    // of the width at the points of the subject's curves; null: 1
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
    std::span<const std::int32_t> items; // of the occluders
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
    // The length of a closed line; 0 of an open one.
    [[nodiscard]] double round(std::int32_t line) const noexcept {
        const visibility::Line& its = input_.found.lines.lines[line];
        return its.closed ? input_.lengths.whole(its) : 0.0;
    }

    LineInput input_;
    base::Array<DrawnAs> styles_;
    base::List<base::Array<float>> factors_; // of the points of the subjects of styles that have them
    visibility::Outline outline_;
};

} // namespace hrbfnpr::frame
