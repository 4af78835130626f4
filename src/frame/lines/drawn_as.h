// SPDX-License-Identifier: MIT
// How the lines of a subject are drawn.
#pragma once

#include "frame/scene/style.h"
#include "visibility/image_lines.h"

#include <algorithm>
#include <cstdint>

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

// How opaque it is, by its strength there.
[[nodiscard]] inline float faded(const DrawnAs& as, const visibility::Piece& piece, float share) noexcept {
    if (as.strength == nullptr || !(as.upper > as.lower)) return 1.0F;
    const float full = std::clamp((strength_at(as, piece, share) - as.lower) / (as.upper - as.lower), 0.0F, 1.0F);
    return 1.0F - as.style->fade * (1.0F - full);
}

} // namespace hrbfnpr::frame
