// SPDX-License-Identifier: MIT
// Between which marks of a stroke all of its line lies, by their normals alone: less is looked at.
#pragma once

#include "frame/depth_layers/cluster_view.h"
#include "frame/depth_layers/hatch_loops.h"
#include "frame/scene/scene.h"

#include <span>

namespace hrbfnpr::frame {

// Of the strokes of one run.
class HatchLimits {
public:
    // by_light: darkness is that of the light, or less.
    HatchLimits(const HatchLoops& loops, const Run& run, const ItemView& item, const ItemSight& sight,
                bool by_light) noexcept;

    // Half-open, in the order of the strokes.
    struct Marks {
        std::int64_t begin, end;
    };

    // Whether limits are known.
    [[nodiscard]] bool any() const noexcept { return any_; }
    // The marks of the pieces that may be drawn, from the first to the last one that may be.  Empty: none may.
    [[nodiscard]] Marks of(std::span<const bool> may_draw, const marks::StrokePiece* pieces) const noexcept;

private:
    [[nodiscard]] std::uint32_t may_draw(const marks::StrokePiece& piece) const noexcept;

    const HatchLoops& loops_;
    const ItemSight& sight_;
    const float* normal_;
    const float* tone_normal_; // or the normals
    float lightest_;           // n . l of a mark that may be drawn
    bool any_;
};

} // namespace hrbfnpr::frame
