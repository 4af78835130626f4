// SPDX-License-Identifier: MIT
// From dots along lines of hatching, which are dimmed now, to strokes that narrow where they end.
#pragma once

#include "frame/depth_layers/hatch_cuts.h"
#include "frame/depth_layers/hatch_points.h"
#include "frame/scene/line_strokes.h"

namespace hrbfnpr::frame {

// What becomes of one batch of points.  Threads fill parts that lie side by side.
struct alignas(base::Memory::alignment) HatchStrokePart {
    explicit HatchStrokePart(base::Memory& memory) noexcept : made(memory), length(memory), cuts(memory) {}

    LineStrokes made;
    base::Array<float> length;          // of each point of a span from its first one, pixels
    base::Array<HatchCut> cuts;         // of a span
    std::int64_t seen = 0;              // dots
    std::int64_t shown = 0, hidden = 0; // marks

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return made.strokes.bytes() + made.points.bytes() + length.bytes() + cuts.bytes();
    }
};

class HatchStrokes {
public:
    explicit HatchStrokes(const base::Runtime& runtime) noexcept : runtime_(runtime), parts_(runtime.memory) {}

    // Strokes of each batch.  The dots are not drawn any more.  Corrects the drawing's counts, where they were taken
    // for marks.
    std::span<const HatchStrokePart> run(const Scene& scene, const HatchPoints& points, const Hiding& hiding,
                                         drawing::Drawing& drawing);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    const base::Runtime& runtime_;
    base::List<HatchStrokePart> parts_;
};

} // namespace hrbfnpr::frame
