// SPDX-License-Identifier: MIT
// The second half of a frame by layers: what each mark of ink is seen through.        [NPAR 6.1]
//
// Splats give, for each pixel of a tile, the two nearest layers on either side.  A mark
// that faces the eye is never hidden by its own layer, nor by one of its item that faces the eye like
// it unless one that faces away lies between: solids have both, in turn.
#pragma once

#include "base/runtime.h"
#include "frame/depth_layers/gather.h"
#include "frame/depth_layers/layer_loops.h"
#include "frame/hatch/points.h"

namespace hrbfnpr::frame {

class DepthLayers {
public:
    explicit DepthLayers(const base::Runtime& runtime) noexcept
        : runtime_(runtime), loops_(layer_loops(runtime.instruction_set)), planes_(runtime.memory),
          seen_(runtime.memory), largest_(runtime.memory) {}

    // Bins the drawing's splats, and sets the opacity of each of its dots by what the depth layers that they stand for
    // let through.  The dots stand in tiles already, and those of hatching in tiles of their own.  Returns how many are
    // drawn.
    std::int64_t attenuate(const Scene& scene, const HatchTiles& hatching, drawing::Drawing& drawing);

    // The radius of the largest splat in a tile, pixels: what a splat hides ends up to that beyond its surface.
    // One number for each tile of the drawing's dots, of the last drawing that had splats.
    [[nodiscard]] std::span<const float> largest_splats() const noexcept { return largest_.span(); }

    [[nodiscard]] std::int64_t bytes() const noexcept { return planes_.bytes() + seen_.bytes() + largest_.bytes(); }

private:
    static constexpr std::int32_t tile_size = drawing::tile_size;
    // Pixels around a tile, for probes; and to see there how far surfaces go on.
    static constexpr std::int32_t narrow_apron = 4;
    static constexpr std::int32_t wide_apron = 9;
    static constexpr std::int32_t side = tile_size + 2 * wide_apron;
    static constexpr std::int32_t stride = side + 16;
    static constexpr std::int64_t plane = std::int64_t{stride} * side;
    static constexpr std::int64_t planes_of_one = 2 * LayerPlanes::layers + 2;

    [[nodiscard]] LayerPlanes planes_of(std::int64_t worker) noexcept;
    void lay_tile(LayerPlanes& planes, const drawing::Drawing& drawing, std::int64_t tile,
                  const glm::vec2& corner) const noexcept;
    [[nodiscard]] std::int64_t dim_tile(LayerPlanes& planes, const Scene& scene, const HatchTiles& hatching,
                                        drawing::Drawing& drawing, std::int64_t tile) noexcept;

    const base::Runtime& runtime_;
    LayerLoops loops_;
    base::Array<float> planes_; // of each worker
    base::Array<std::int64_t> seen_;
    base::Array<float> largest_; // splat of each tile
    std::uint32_t ends_ = 0;     // items that end, a bit for each
    std::int32_t apron_ = narrow_apron;
};

} // namespace hrbfnpr::frame
