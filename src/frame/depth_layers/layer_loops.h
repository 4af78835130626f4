// SPDX-License-Identifier: MIT
// Finds the layers of surface at each pixel of a tile. All instruction sets give the same bits.
#pragma once

#include "base/instruction_set.h"
#include "drawing/dot.h"

#include <cstdint>

namespace hrbfnpr::frame {

using drawing::Splat;

// Planes with a float for each pixel, in rows of `stride` floats. For each pixel they hold the depths and
// transmittances of four layers on the line of sight: the nearest layer that faces the eye, the nearest that faces
// away, and the next layer of each kind.
struct LayerPlanes {
    enum Layer : std::int64_t { front, back, next_front, next_back, layers };

    std::int32_t width, height, stride; // stride >= width + 16
    float* depth[layers];
    float* transmittance[layers];
    float* halo; // the depth of the nearest contour whose halo covers the pixel
    float* halo_transmittance;
    float largest_splat; // the radius of the largest splat in the planes, in pixels
};

// A list of splats, given by their indices. (left, top) is the first pixel of the planes.
struct SplatList {
    const Splat* splats;
    const std::uint32_t* numbers;
    std::int64_t count;
    float left, top;
    float nearest, farthest; // The range of depths that draw_next() considers.
};

struct LayerLoops {
    void (*draw_nearest)(const LayerPlanes& planes, const SplatList& list); // Finds the nearest layers.
    // Finds the next layers, after draw_nearest() was called for all splats.
    void (*draw_next)(const LayerPlanes& planes, const SplatList& list);
    void (*draw_halos)(const LayerPlanes& planes, const SplatList& list);
};

[[nodiscard]] LayerLoops layer_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::frame
