// SPDX-License-Identifier: MIT
// Which marks of a stroke may be drawn, by their normals alone: less is looked at.
#pragma once

#include "frame/depth_layers/cluster_view.h"
#include "frame/depth_layers/hatch_loops.h"
#include "frame/scene/scene.h"

namespace hrbfnpr::frame {

// Of the strokes of one run.
class HatchLimits {
public:
    // by_light: darkness is that of the light, or less.  darkness: of open gaps, at most.
    HatchLimits(const HatchLoops& loops, const Run& run, const ItemView& item, const ItemSight& sight, bool by_light,
                float darkness) noexcept;

    // Whether limits are known.
    [[nodiscard]] bool any() const noexcept { return any_; }
    // A bit for each mark of a piece: where it is 0 the mark lies in an open gap.
    [[nodiscard]] std::uint32_t may_draw(const marks::StrokePiece& piece) const noexcept;

private:
    const HatchLoops& loops_;
    const ItemSight& sight_;
    const float* normal_;
    const float* tone_normal_; // or the normals
    float lightest_;           // n . l of a mark that may be drawn or lie in a gap that is hardly open
    bool any_;
};

} // namespace hrbfnpr::frame
