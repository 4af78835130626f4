// SPDX-License-Identifier: MIT
// From dots along lines of hatching, which are dimmed now, to strokes that narrow where they end.
#pragma once

#include "frame/depth_layers/hatch_points.h"
#include "frame/scene/line_strokes.h"

namespace hrbfnpr::frame {

// What becomes of one batch of points.
struct HatchStrokePart {
    explicit HatchStrokePart(base::Memory& memory) noexcept : made(memory), length(memory) {}

    LineStrokes made;
    base::Array<float> length;          // of each point of a span from its first one, pixels
    std::int64_t first_point = 0;       // among those of all batches
    std::int64_t seen = 0;              // dots
    std::int64_t shown = 0, hidden = 0; // marks

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return made.strokes.bytes() + made.points.bytes() + length.bytes();
    }
};

class HatchStrokes {
public:
    explicit HatchStrokes(const base::Runtime& runtime) noexcept
        : runtime_(runtime), parts_(runtime.memory), strokes_(runtime.memory) {}

    // The dots are not drawn any more.  Corrects the drawing's counts, where they were taken for marks.
    const LineStrokes& run(const Scene& scene, const HatchPoints& points, drawing::Drawing& drawing);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void append(std::int64_t parts);

    const base::Runtime& runtime_;
    base::List<HatchStrokePart> parts_;
    LineStrokes strokes_; // of all batches
};

} // namespace hrbfnpr::frame
