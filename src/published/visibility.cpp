// SPDX-License-Identifier: MIT
#include "published/visibility.h"

#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::published {
namespace {

constexpr double most_texels = 16777216.0; // 64 MiB of depth; larger viewports get a coarser map

} // namespace

void VisibilityMap::build(const base::Parallel& parallel, const Scene& scene) {
    const glm::vec4& viewport = scene.lens.viewport;
    left_ = viewport.x;
    top_ = viewport.y;
    double scale = 1.0;
    while (std::ceil(static_cast<double>(viewport.z) * scale) * std::ceil(static_cast<double>(viewport.w) * scale) >
           most_texels)
        scale *= 0.5;
    texels_per_pixel_ = static_cast<float>(scale);
    width_ = static_cast<std::int32_t>(std::ceil(viewport.z * texels_per_pixel_));
    height_ = static_cast<std::int32_t>(std::ceil(viewport.w * texels_per_pixel_));
    collect(parallel, scene);
    const std::array all = {Piece{0, occluders_.size()}};
    bins_.build(parallel, width_, height_, all, [this](std::int64_t i, drawing::Tiles::Footprint& print) {
        const Occluder& disc = occluders_[i];
        print = {disc.x, disc.y, disc.radius};
        return disc.radius >= 0.0F;
    });
    base::resize_scratch(depth_, std::int64_t{width_} * height_);
    parallel.for_each(bins_.tiles(), [this](std::int64_t tile) { fill_tile(tile); });
}

void VisibilityMap::collect(const base::Parallel& parallel, const Scene& scene) {
    base::resize_scratch(occluders_, scene.marks.x.size());
    parallel.for_each(scene.chunks.size(), [&](std::int64_t c) {
        const Chunk& chunk = scene.chunks[c];
        const Run& run = scene.runs[chunk.run];
        for (std::int64_t i = chunk.begin; i < chunk.end; ++i) {
            const MarkClass mark_class = scene.marks.mark_class[i];
            occluders_[i].radius = -1.0F;
            if (!run.occludes || (mark_class != MarkClass::front && mark_class != MarkClass::back)) continue;
            const float pixels_per_unit = scene.marks.pixels_per_unit[i];
            const float radius = run.pen.front_splat(pixels_per_unit);
            occluders_[i] = {(scene.marks.x[i] - left_) * texels_per_pixel_,
                             (scene.marks.y[i] - top_) * texels_per_pixel_, radius * texels_per_pixel_,
                             paper_depth(scene.marks, i, radius)};
        }
    });
}

void VisibilityMap::fill_tile(std::int64_t tile) noexcept {
    const auto left = static_cast<std::int32_t>(tile % bins_.columns()) * tile_size;
    const auto top = static_cast<std::int32_t>(tile / bins_.columns()) * tile_size;
    const std::int32_t right = std::min(left + tile_size, width_);
    const std::int32_t bottom = std::min(top + tile_size, height_);
    for (std::int32_t y = top; y < bottom; ++y) {
        float* row = depth_.data() + std::int64_t{y} * width_;
        std::fill(row + left, row + right, std::numeric_limits<float>::infinity());
    }
    bins_.for_tile(tile, [&](std::uint32_t i) { draw(occluders_[i], left, top); });
}

void VisibilityMap::draw(const Occluder& disc, std::int32_t left, std::int32_t top) noexcept {
    const std::int32_t right = std::min(left + tile_size, width_);
    const std::int32_t bottom = std::min(top + tile_size, height_);
    for (std::int32_t y = top; y < bottom; ++y) {
        const float dy = static_cast<float>(y) + 0.5F - disc.y;
        const float half_squared = disc.radius * disc.radius - dy * dy;
        if (!(half_squared >= 0.0F)) continue;
        const float half = std::sqrt(half_squared);
        // Texels whose centres lie within.
        const float first = std::max(std::ceil(disc.x - half - 0.5F), static_cast<float>(left));
        const float last = std::min(std::floor(disc.x + half - 0.5F), static_cast<float>(right - 1));
        if (!(first <= last)) continue;
        float* row = depth_.data() + std::int64_t{y} * width_;
        for (auto x = static_cast<std::int32_t>(first); x <= static_cast<std::int32_t>(last); ++x)
            row[x] = std::min(row[x], disc.depth);
    }
}

bool VisibilityMap::hides(float x, float y, float depth) const noexcept {
    const float u = std::floor((x - left_) * texels_per_pixel_);
    const float v = std::floor((y - top_) * texels_per_pixel_);
    if (!(u >= 0.0F && v >= 0.0F && u < static_cast<float>(width_) && v < static_cast<float>(height_))) return false;
    return depth > depth_[static_cast<std::int64_t>(v) * width_ + static_cast<std::int64_t>(u)];
}

} // namespace hrbfnpr::published
