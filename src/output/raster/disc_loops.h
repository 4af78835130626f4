// SPDX-License-Identifier: MIT
// Discs of ink into the planes of a tile, for each instruction set; the same bits from all of them.
#pragma once

#include "base/instruction_set.h"
#include "drawing/dot.h"

#include <cstdint>

namespace hrbfnpr::output {

// Rows of `stride` floats, one for each pixel.
struct DiscTile {
    std::int32_t width, height, stride; // stride >= width + 8
    float* transmittance;               // what is left of the paper
    float* color[3];                    // what the inks add to it, premultiplied; NULL: all inks have one colour
    const float* host;                  // depth of the host's picture, falling towards the eye; or NULL
};

// Inks by their numbers; (left, top) is the tile's first pixel.
struct InkList {
    const drawing::Dot* inks;
    const std::uint32_t* numbers;
    std::int64_t count;
    float left, top;
    const float* colors; // four of each layer: RGB, and an alpha that multiplies the ink's
    float one_alpha;     // of all, if there is one colour
    float toward;        // -1: the host's depth rises towards the eye; 1
};

// Four channels of a row, each alpha * transmittance + beta * (1 - transmittance), as bytes.
struct RowColors {
    float paper[4]; // premultiplied, in the order of the bytes
    float ink[4];
    bool straight; // divide by the last one
};

struct DiscLoops {
    void (*draw)(const DiscTile& tile, const InkList& list);
    void (*store)(const RowColors& colors, const float* transmittance, std::int64_t count, std::uint32_t* pixels);
};

[[nodiscard]] DiscLoops disc_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::output
