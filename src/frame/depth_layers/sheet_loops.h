// The sheets behind each pixel of a tile, for each instruction set; the same bits from all of them.
#pragma once

#include "base/instruction_set.h"
#include "frame/depth_layers/ink.h"

#include <cstdint>

namespace hrbfnpr::frame {

// Rows of `stride` floats, one for each pixel.  Of a line of sight: the nearest sheet that faces the eye, the nearest
// that faces away, and the ones after them; depth and what they let through.
struct SheetPlanes {
    enum Sheet : std::int64_t { front, back, next_front, next_back, sheets };

    std::int32_t width, height, stride; // stride >= width + 16
    float* depth[sheets];
    float* clear[sheets];
    float* halo; // depth of the nearest contour whose halo reaches the pixel
    float* halo_clear;
    float largest_cover; // radius of the covers laid, pixels
};

// Covers by their numbers; (left, top) is the planes' first pixel.
struct CoverList {
    const Cover* covers;
    const std::uint32_t* numbers;
    std::int64_t count;
    float left, top;
    float nearest, farthest; // depths between which lay_next() is asked for sheets
};

struct SheetLoops {
    void (*lay)(const SheetPlanes& planes, const CoverList& list);      // the nearest sheets
    void (*lay_next)(const SheetPlanes& planes, const CoverList& list); // those behind, once the nearest are laid
    void (*lay_halos)(const SheetPlanes& planes, const CoverList& list);
};

// A sheet of the same side lies behind another one if it is so many radii of its discs farther away.
inline constexpr float sheet_gap = 4.0F;
// A sheet of the other side, pixels.
inline constexpr float side_gap = 1.0F;

[[nodiscard]] SheetLoops sheet_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::frame
