// SPDX-License-Identifier: MIT
// The layers of surface at each pixel of a tile, for each instruction set; the same bits from all of them.
#pragma once

#include "base/instruction_set.h"
#include "drawing/dot.h"

#include <cstdint>

namespace hrbfnpr::frame {

using drawing::Splat;

// Rows of `stride` floats, one for each pixel. Along a line of sight these are the nearest layer that faces the eye,
// the nearest that faces away, and the ones after them: their depths and transmittances.
struct LayerPlanes {
    enum Layer : std::int64_t { front, back, next_front, next_back, layers };

    std::int32_t width, height, stride; // stride >= width + 16
    float* depth[layers];
    float* transmittance[layers];
    float* halo; // depth of the nearest contour whose halo reaches the pixel
    float* halo_transmittance;
    float largest_splat; // radius of the splats laid, pixels
};

// Splats by their numbers. (left, top) is the planes' first pixel.
struct SplatList {
    const Splat* splats;
    const std::uint32_t* numbers;
    std::int64_t count;
    float left, top;
    float nearest, farthest; // depths between which lay_next() is asked for layers
};

struct LayerLoops {
    void (*lay)(const LayerPlanes& planes, const SplatList& list);      // the nearest layers
    void (*lay_next)(const LayerPlanes& planes, const SplatList& list); // the next ones, once the nearest are laid
    void (*lay_halos)(const LayerPlanes& planes, const SplatList& list);
};

[[nodiscard]] LayerLoops layer_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::frame
