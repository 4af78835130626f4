// SPDX-License-Identifier: MIT
// Which marks lie behind a nearer layer: a map of the nearest surface's depth.
#pragma once

#include "base/runtime.h"
#include "drawing/tiles.h"
#include "frame/scene/scene.h"

namespace hrbfnpr::published {

using namespace frame; // the scene that this room classifies and paints

// Takes the discs of front and back marks of the items that hide what is behind them.  They lie
// behind their own layer as discs of paper do, so that it does not hide its own ink.
class VisibilityMap {
public:
    explicit VisibilityMap(base::Memory& memory) noexcept
        : bins_(memory, tile_size), depth_(memory), occluders_(memory) {}

    void build(const base::Parallel& parallel, const Scene& scene);

    // x, y in pixels of the image; depth in eye units along the view.  False outside the viewport.
    [[nodiscard]] bool hides(float x, float y, float depth) const noexcept;

    [[nodiscard]] std::int64_t bytes() const noexcept { return bins_.bytes() + depth_.bytes() + occluders_.bytes(); }

private:
    static constexpr std::int32_t tile_size = 32;

    struct Occluder {
        float x, y, radius, depth; // in texels of the map; eye units
    };
    void collect(const base::Parallel& parallel, const Scene& scene);
    void fill_tile(std::int64_t tile) noexcept;
    void draw(const Occluder& disc, std::int32_t left, std::int32_t top) noexcept;

    float left_ = 0.0F, top_ = 0.0F; // of the viewport
    float texels_per_pixel_ = 1.0F;
    std::int32_t width_ = 0, height_ = 0;
    drawing::Tiles bins_;
    base::Array<float> depth_;
    base::Array<Occluder> occluders_; // one for each mark; radius < 0 = none
};

} // namespace hrbfnpr::published
