// SPDX-License-Identifier: MIT
// The strokes of lines: curves traced for this camera, their visibility, and their widths and parts by style.
#pragma once

#include "base/runtime.h"
#include "frame/lines/line_numbers.h"
#include "frame/lines/traced_lines.h"
#include "frame/scene/scene.h"

#include <span>

namespace hrbfnpr::frame {

class LineFrame {
public:
    explicit LineFrame(const base::Runtime& runtime) noexcept
        : runtime_(runtime), strokes_(runtime.memory), contours_(runtime.memory), numbers_(runtime.memory) {}

    // Draws the lines of the items that have lines and styles for them; adds their layers and counts to the drawing.
    // All items with lines hide each other's.  Throws Error{callback, cancelled, out_of_memory}.
    const LineStrokes& run(const Scene& scene, std::span<const Item> items, const base::Progress& progress,
                           drawing::Drawing& drawing);
    // After a frame that was not finished: the next begins with no contours.
    void forget() noexcept { contours_.forget(); }

private:
    const base::Runtime& runtime_;
    LineStrokes strokes_;
    LastContours contours_;
    LineNumbers numbers_;
};

} // namespace hrbfnpr::frame
