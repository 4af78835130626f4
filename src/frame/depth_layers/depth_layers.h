// SPDX-License-Identifier: MIT
// The second half of a frame by layers: what each dot of ink is seen through.                                [NPAR 6.1]
//
// dim_by_layers: splats -> the two nearest layers on either side at each pixel of a tile -> opacity of dots
// dim_by_rays: opacity of the dots of items that have a model, by rays from them to the eye
//
// A mark that faces the eye is never hidden by its own layer, nor by one of its item that faces the eye like it unless
// one that faces away lies between: solids have both, in turn.
#pragma once

#include "base/runtime.h"
#include "drawing/drawing.h"
#include "frame/depth_layers/layer_loops.h"
#include "frame/hatch/points.h"
#include "surface/cast_rays.h"

namespace hrbfnpr::frame {

// Arrays that are kept from frame to frame.
struct DepthLayers {
    explicit DepthLayers(base::Memory& memory) noexcept
        : largest(memory), planes(memory), seen(memory), rays(memory), hits(memory), asked(memory) {}

    // The radius of the largest splat in each tile of the drawing's dots, pixels: splats hide ink up to
    // this far beyond their surface.
    base::Array<float> largest;

    // Scratch.
    base::Array<float> planes;      // the pixel planes of all workers, one worker after the other
    base::Array<std::int64_t> seen; // how many dots of each tile are drawn
    surface::Rays rays;
    surface::RayHits hits;
    base::Array<std::uint32_t> asked; // dots that the rays begin at

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return largest.bytes() + planes.bytes() + seen.bytes() + rays.origin.bytes() + rays.direction.bytes() +
               hits.t.bytes() + hits.position.bytes() + hits.normal.bytes() + asked.bytes();
    }
};

// Bins the drawing's splats, and sets the opacity of each of its dots by the transmittance of the depth layers that
// the splats stand for. The dots stand in tiles already, and those of hatching in tiles of their own. Returns how many
// are drawn.
[[nodiscard]] std::int64_t dim_by_layers(const base::Runtime& runtime, const Scene& scene, const HatchTiles& hatching,
                                         DepthLayers& scratch, drawing::Drawing& drawing);

// Multiplies the opacity of the dots of items that have a model. Returns how many are no longer drawn.
// Throws Error{callback, out_of_memory}.
[[nodiscard]] std::int64_t dim_by_rays(const base::Runtime& runtime, const Scene& scene, DepthLayers& scratch,
                                       drawing::Drawing& drawing);

} // namespace hrbfnpr::frame
