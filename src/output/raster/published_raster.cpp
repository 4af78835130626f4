// SPDX-License-Identifier: MIT
#include "output/raster/published_raster.h"

#include "output/raster/pixels.h"
#include "output/raster/rects.h"
#include "output/raster/srgb.h"

#include <array>
#include <cmath>

namespace hrbfnpr::output {
namespace {

using drawing::Dot;

constexpr std::int32_t tile_size = 32; // a tile of float RGBA fits the first-level cache

// One tile while it is painted; small enough for the stack of a host's job thread.
struct Tile {
    static constexpr std::size_t pixels = std::size_t{tile_size} * tile_size;
    Rect rect; // in the image
    std::array<glm::vec4, pixels> color;
    std::array<float, pixels> nearest;     // window depth
    std::array<std::uint32_t, pixels> top; // place of the last disc that covers the pixel's centre, plus 1
};

[[nodiscard]] constexpr std::size_t cell(std::int32_t x, std::int32_t y) noexcept {
    return static_cast<std::size_t>(y) * tile_size + static_cast<std::size_t>(x);
}

// Everything that a tile's task reads.
class Painter {
public:
    Painter(const drawing::Tiles& bins, const drawing::Drawing& drawing, const Image& image,
            const DrawSettings& settings, const Rect& rect) noexcept
        : bins_(bins), drawing_(drawing), convention_(drawing.window.depth),
          coverage_(image.format == Format::coverage8),
          paper_(coverage_ ? glm::vec4(0.0F) : in_light(premultiplied(drawing.paper), settings)), image_(image),
          settings_(settings), rect_(rect), wants_outputs_(settings.depth || settings.id || settings.mark_class) {}

    void operator()(std::int64_t index) const {
        Tile tile;
        tile.rect.left = rect_.left + static_cast<std::int32_t>(index % bins_.columns()) * tile_size;
        tile.rect.top = rect_.top + static_cast<std::int32_t>(index / bins_.columns()) * tile_size;
        tile.rect.right = std::min(tile.rect.left + tile_size, rect_.right);
        tile.rect.bottom = std::min(tile.rect.top + tile_size, rect_.bottom);
        tile.color.fill(paper_);
        if (wants_outputs_) {
            tile.nearest.fill(drawing::far_depth(convention_));
            tile.top.fill(0);
        }
        bins_.for_tile(index, [&](std::uint32_t i) { paint(tile, i); });
        for (std::int32_t y = tile.rect.top; y < tile.rect.bottom; ++y) {
            store_row(tile, y);
            if (wants_outputs_) store_outputs(tile, y);
        }
    }

private:
    [[nodiscard]] static glm::vec4 in_light(const glm::vec4& color, const DrawSettings& settings) noexcept {
        return settings.linear_light ? to_linear(color) : color;
    }

    void paint(Tile& tile, std::uint32_t index) const {
        const Dot& disc = drawing_.dots[index];
        const bool is_paper = (disc.flags & drawing::dot_is_paper) != 0;
        const glm::vec4 ink = is_paper ? glm::vec4(glm::vec3(0.0F), 1.0F) : drawing_.layers[disc.layer].ink;
        // A disc below half a pixel keeps its ink by getting paler instead of smaller.
        const float radius = std::max(disc.radius, drawing::smallest_radius);
        const float dimmed = disc.radius / radius;
        const float alpha = ink.w * disc.opacity * dimmed * dimmed;
        const glm::vec4 source = is_paper ? paper_ : in_light(glm::vec4(glm::vec3(ink), 1.0F), settings_);
        const float outer = radius + 0.5F;
        const float outer_squared = outer * outer;
        const float inner = radius - 0.5F;
        const float inner_squared = inner * inner;
        for (std::int32_t y = tile.rect.top; y < tile.rect.bottom; ++y) {
            const float dy = static_cast<float>(y) + 0.5F - disc.y;
            if (!(dy * dy < outer_squared)) continue;
            const float half = std::sqrt(outer_squared - dy * dy);
            const auto first = static_cast<std::int32_t>(std::clamp(
                std::floor(disc.x - half), static_cast<float>(tile.rect.left), static_cast<float>(tile.rect.right)));
            const auto last = static_cast<std::int32_t>(std::clamp(
                std::ceil(disc.x + half), static_cast<float>(tile.rect.left), static_cast<float>(tile.rect.right)));
            for (std::int32_t x = first; x < last; ++x) {
                const float dx = static_cast<float>(x) + 0.5F - disc.x;
                const float squared = dx * dx + dy * dy;
                if (!(squared < outer_squared) || behind_host(disc, x, y)) continue;
                const float coverage = squared <= inner_squared ? 1.0F : std::min(outer - std::sqrt(squared), 1.0F);
                glm::vec4& color = tile.color[cell(x - tile.rect.left, y - tile.rect.top)];
                color += (source - color) * (alpha * coverage);
                if (wants_outputs_ && squared <= radius * radius)
                    note(tile, cell(x - tile.rect.left, y - tile.rect.top), index, disc.window);
            }
        }
    }

    void note(Tile& tile, std::size_t at, std::uint32_t index, float depth) const noexcept {
        tile.top[at] = index + 1;
        if (drawing::nearer(depth, tile.nearest[at], convention_)) tile.nearest[at] = depth;
    }

    [[nodiscard]] bool behind_host(const Dot& disc, std::int32_t x, std::int32_t y) const noexcept {
        if (settings_.host_depth.empty()) return false;
        const auto host = static_cast<float>(settings_.host_depth.get(std::int64_t{y} * image_.width + x, 0));
        return drawing::nearer(host, disc.window, convention_);
    }

    void store_row(const Tile& tile, std::int32_t y) const noexcept {
        for (std::int32_t x = tile.rect.left; x < tile.rect.right; ++x) {
            std::byte* const pixel = image_.pixel(x, y);
            glm::vec4 color = tile.color[cell(x - tile.rect.left, y - tile.rect.top)];
            if (settings_.over) color += in_light(load_pixel(pixel, image_.format), settings_) * (1.0F - color.w);
            store_pixel(pixel, settings_.linear_light && !coverage_ ? from_linear(color) : color, image_.format);
        }
    }

    void store_outputs(const Tile& tile, std::int32_t y) const noexcept {
        for (std::int32_t x = tile.rect.left; x < tile.rect.right; ++x) {
            const std::size_t at = cell(x - tile.rect.left, y - tile.rect.top);
            const std::int64_t element = std::int64_t{y} * image_.width + x;
            const std::uint32_t top = tile.top[at];
            const Dot nothing{};
            const Dot& disc = top == 0 ? nothing : drawing_.dots[top - 1];
            if (settings_.depth) settings_.depth.set(element, 0, static_cast<double>(tile.nearest[at]));
            if (settings_.id) settings_.id.set(element, 0, static_cast<double>(disc.id));
            if (settings_.mark_class) settings_.mark_class.set(element, 0, static_cast<double>(disc.mark_class));
        }
    }

    const drawing::Tiles& bins_;
    const drawing::Drawing& drawing_;
    drawing::DepthConvention convention_;
    bool coverage_;   // only how much ink there is counts
    glm::vec4 paper_; // premultiplied
    const Image& image_;
    const DrawSettings& settings_;
    Rect rect_;
    bool wants_outputs_;
};

} // namespace

PublishedRaster::PublishedRaster(const base::Runtime& runtime) noexcept
    : runtime_(runtime), tiles_(runtime.memory, tile_size) {}

void PublishedRaster::draw(const drawing::Drawing& drawing, const Image& image, const DrawSettings& settings) {
    const Rect rect = drawn_rect(drawing.window.viewport, image);
    if (rect.empty()) return;
    tiles_.build(runtime_.parallel, rect.right - rect.left, rect.bottom - rect.top, drawing.dot_pieces.span(),
                 [&](std::int64_t i, drawing::Tiles::Footprint& print) {
                     const Dot& disc = drawing.dots[i];
                     print = {disc.x - static_cast<float>(rect.left), disc.y - static_cast<float>(rect.top),
                              std::max(disc.radius, drawing::smallest_radius) + 0.5F};
                     return true;
                 });
    runtime_.parallel.for_each(tiles_.tiles(), Painter(tiles_, drawing, image, settings, rect));
}

} // namespace hrbfnpr::output
