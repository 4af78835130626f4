// SPDX-License-Identifier: MIT
// Strokes of lines, before they stand among the others of a drawing.
#pragma once

#include "base/memory.h"
#include "drawing/dot.h"

namespace hrbfnpr::frame {

struct LineStrokes {
    explicit LineStrokes(base::Memory& memory) noexcept : strokes(memory), points(memory) {}

    base::Array<drawing::Stroke> strokes; // in any order
    base::Array<drawing::StrokePoint> points;
};

} // namespace hrbfnpr::frame
