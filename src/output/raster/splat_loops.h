// Discs of ink into the planes of a tile, for each instruction set; the same bits from all of them.
#pragma once

#include "base/instruction_set.h"

#include <cstdint>

namespace hrbfnpr::output {

// Rows of `stride` floats, one for each pixel.
struct SplatTile {
    std::int32_t width, height, stride; // stride >= width + 8
    float* clear;                       // what is left of the paper
    float* color[3];                    // what the inks add to it, premultiplied; NULL: all inks have one colour
    const float* host;                  // depth of the host's picture, falling towards the eye; or NULL
};

// In pixels of the tile.
struct SplatDisc {
    float x, y, radius, alpha;
    float color[3];
    float depth; // as the host's
};

// Four channels of a row, each alpha * clear + beta * (1 - clear), as bytes.
struct RowColors {
    float paper[4]; // premultiplied, in the order of the bytes
    float ink[4];
    bool straight; // divide by the last one
};

struct SplatLoops {
    void (*splat)(const SplatTile& tile, const SplatDisc& disc);
    void (*store)(const RowColors& colors, const float* clear, std::int64_t count, std::uint32_t* pixels);
};

// Smaller discs are not drawn smaller, but paler.
inline constexpr float smallest_radius = 0.5F;

[[nodiscard]] SplatLoops splat_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::output
