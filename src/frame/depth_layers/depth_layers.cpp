// SPDX-License-Identifier: MIT
#include "frame/depth_layers/depth_layers.h"

#include "frame/scene/splat_law.h"

#include <algorithm>
#include <atomic>
#include <limits>

namespace hrbfnpr::frame {
namespace {

constexpr float nothing = std::numeric_limits<float>::infinity();
// Ink lies behind another layer of its item that faces like its own by so many radii of the splats.
constexpr float own_gap = 5.0F;
// Discs reach beyond the border of a surface that ends, and would hide a strip of another one that begins there: in so
// many radii behind such a layer ink is hidden only if the layer goes on, as far as so many radii, on all sides.
constexpr float border_gap = 2.0F;
constexpr float border_reach = 1.5F;

[[nodiscard]] SplatList list_of(std::span<const Splat> splats, std::span<const std::uint32_t> numbers,
                                const glm::vec2& corner) noexcept {
    return {splats.data(), numbers.data(), static_cast<std::int64_t>(numbers.size()), corner.x, corner.y,
            -nothing,      nothing};
}

// What a mark is seen through.
struct Dimmed {
    float transmittance = 1.0F;
    // Other layers may lie between the ink and here; nothing: none can.
    float more_behind = nothing;
};

// Which items there are, by their numbers' lowest bits.
struct Items {
    std::int32_t ink;   // the ink's; -1: all is of one item
    std::uint32_t ends; // a bit for each that ends in the open: it is drawn on both sides
};

// Clamped to the planes.
[[nodiscard]] std::int32_t pixel_at(const LayerPlanes& p, const glm::vec2& place) noexcept {
    const auto column = static_cast<std::int32_t>(std::clamp(place.x, 0.0F, static_cast<float>(p.width - 1)));
    const auto row = static_cast<std::int32_t>(std::clamp(place.y, 0.0F, static_cast<float>(p.height - 1)));
    return row * p.stride + column;
}

// Whether the layer there goes on in all directions: it is seen there, or something before where its slope leads.
[[nodiscard]] bool goes_on(const LayerPlanes& p, std::int64_t layer, const glm::vec2& place) noexcept {
    const float reach = border_reach * p.largest_splat;
    const std::int32_t here = pixel_at(p, place);
    const float* const depth = p.depth[layer];
    const auto is_same = [&](std::int32_t at) {
        return depth[at] < nothing && item_of(p.transmittance[layer][at]) == item_of(p.transmittance[layer][here]);
    };
    for (const glm::vec2& to : {glm::vec2(reach, 0.0F), {-reach, 0.0F}, {0.0F, reach}, {0.0F, -reach}}) {
        const std::int32_t there = pixel_at(p, place + to);
        if (is_same(there)) continue;
        const std::int32_t opposite = pixel_at(p, place - to);
        if (!is_same(opposite) || depth[there] >= 2.0F * depth[here] - depth[opposite]) return false;
    }
    return true;
}

// By the nearest layers and the halo, or by the next ones, at a place in pixels of the planes.
Dimmed dim(const LayerPlanes& p, const Dot& ink, const Items& items, const glm::vec2& place, bool next) noexcept {
    Dimmed result;
    const std::int32_t at = pixel_at(p, place);
    if (!next && p.halo[at] + halo_gap / ink.pixels_per_unit < ink.depth)
        result.transmittance = p.halo_transmittance[at];
    if ((ink.flags & dot_is_exact) != 0) return result;
    const float other = side_gap / ink.pixels_per_unit;
    const float own = own_gap * p.largest_splat / ink.pixels_per_unit;
    const float border = border_gap * p.largest_splat / ink.pixels_per_unit;
    const bool faces_back = (ink.flags & dot_faces_back) != 0;
    const auto hides = [&](std::int64_t layer, bool alike) {
        const float depth = p.depth[layer][at];
        // Of another item it is nowhere the ink's own layer.
        const bool is_other = items.ink >= 0 && depth < nothing && !is_of_item(p.transmittance[layer][at], items.ink);
        if (alike && !is_other) return depth + own < ink.depth;
        if (!(depth + other < ink.depth)) return false;
        const bool may_end = is_other && alike && (items.ends >> item_of(p.transmittance[layer][at]) & 1U) != 0;
        return !may_end || depth + border < ink.depth || goes_on(p, layer, place);
    };
    const std::int64_t first = next ? std::int64_t{LayerPlanes::next_front} : std::int64_t{LayerPlanes::front};
    const float front = p.depth[first][at];
    const float back = p.depth[first + 1][at];
    const bool behind_back = hides(first + 1, faces_back);
    const bool behind_front = hides(first, !faces_back) || (behind_back && front < back);
    if (behind_front) result.transmittance *= p.transmittance[first][at];
    if (behind_back) result.transmittance *= p.transmittance[first + 1][at];
    // In solids, a layer that faces away lies between two that face the eye.
    if (behind_back || (behind_front && back == nothing)) result.more_behind = std::min(front, back);
    return result;
}

[[nodiscard]] std::uint32_t items_that_end(const Scene& scene) noexcept {
    std::uint32_t ends = 0;
    for (std::int64_t i = 0; i < scene.items.size(); ++i)
        if (scene.items[i].both_sides) ends |= 1U << (static_cast<std::uint32_t>(i) & item_bits);
    return ends;
}

} // namespace

LayerPlanes DepthLayers::planes_of(std::int64_t worker) noexcept {
    float* at = planes_.data() + worker * planes_of_one * plane;
    const std::int32_t size = tile_size + 2 * apron_;
    LayerPlanes planes{size, size, stride, {}, {}, nullptr, nullptr, 0.0F};
    const auto next = [&] { return std::exchange(at, at + plane); };
    for (float*& depth : planes.depth) depth = next();
    planes.halo = next();
    for (float*& transmittance : planes.transmittance) transmittance = next();
    planes.halo_transmittance = next();
    return planes;
}

void DepthLayers::lay_tile(LayerPlanes& planes, const drawing::Drawing& drawing, std::int64_t tile,
                           const glm::vec2& corner) const noexcept {
    for (float* const depth : {planes.depth[LayerPlanes::front], planes.depth[LayerPlanes::back], planes.halo})
        std::fill_n(depth, plane, nothing);
    planes.largest_splat = 0.0F;
    const std::span<const Splat> splats = drawing.splats.span();
    drawing.splat_tiles.for_spans(tile, [&](std::span<const std::uint32_t> numbers) {
        for (const std::uint32_t number : numbers)
            planes.largest_splat = std::max(planes.largest_splat, splats[number].radius);
        const SplatList list = list_of(splats, numbers, corner);
        loops_.lay(planes, list);
        loops_.lay_halos(planes, list);
    });
}

std::int64_t DepthLayers::attenuate(const Scene& scene, const HatchTiles& hatching, drawing::Drawing& drawing) {
    const drawing::Tiles& tiles = drawing.dot_tiles;
    const glm::vec2 origin(drawing.first_pixel);
    ends_ = scene.items.size() > 1 ? items_that_end(scene) : 0;
    apron_ = ends_ != 0 ? wide_apron : narrow_apron;
    drawing.splat_tiles.build(
        runtime_.parallel, tiles.columns() * tile_size, tiles.rows() * tile_size, drawing.splat_pieces.span(),
        [&](std::int64_t i, drawing::Tiles::Footprint& print) {
            const Splat& c = drawing.splats[i];
            print = {c.x - origin.x, c.y - origin.y, std::max(c.radius, c.halo) + static_cast<float>(apron_) + 1.0F};
            return true;
        });
    const std::int64_t workers = std::max(1, runtime_.parallel.threads());
    base::resize_scratch(planes_, workers * planes_of_one * plane);
    base::resize_scratch(seen_, tiles.tiles());
    base::resize_scratch(largest_, tiles.tiles());
    std::atomic<std::int64_t> next{0};
    runtime_.parallel.for_each(workers, [&](std::int64_t worker) {
        LayerPlanes planes = planes_of(worker);
        for (std::int64_t tile = next++; tile < tiles.tiles(); tile = next++)
            seen_[tile] = dim_tile(planes, scene, hatching, drawing, tile);
    });
    std::int64_t seen = 0;
    for (const std::int64_t count : seen_) seen += count;
    return seen;
}

// The inks whose centres lie in the tile: first through the nearest layers, then, if any ink is still seen behind
// those, through the next.
std::int64_t DepthLayers::dim_tile(LayerPlanes& planes, const Scene& scene, const HatchTiles& hatching,
                                   drawing::Drawing& drawing, std::int64_t tile) noexcept {
    const drawing::Tiles& tiles = drawing.dot_tiles;
    const glm::vec2 origin(drawing.first_pixel);
    const std::int64_t column = tile % tiles.columns();
    const std::int64_t row = tile / tiles.columns();
    const glm::vec2 corner = origin + glm::vec2(static_cast<float>(column * tile_size - apron_),
                                                static_cast<float>(row * tile_size - apron_));
    const drawing::Tiles::Extent own = tiles.own_extent(tile);
    const auto for_own = [&](auto&& f) {
        tiles.for_tile(tile, [&](std::uint32_t i) {
            Dot& ink = drawing.dots[i];
            if (own.holds(ink.x - origin.x, ink.y - origin.y)) f(ink);
        });
        hatching.for_tile(tile, [&](std::int64_t i) { f(drawing.dots[i]); });
    };
    const auto dimmed_by = [&](const Dot& ink, bool next) {
        const Items items{scene.items.size() > 1 ? scene.runs[ink.layer / 2].item : -1, ends_};
        return dim(planes, ink, items, glm::vec2(ink.x, ink.y) - corner, next);
    };
    std::int64_t seen = 0;
    bool laid = false;
    largest_[tile] = 0.0F;
    float nearest = nothing;
    float farthest = -nothing;
    for_own([&](Dot& ink) {
        if (!laid) lay_tile(planes, drawing, tile, corner);
        laid = true;
        largest_[tile] = planes.largest_splat;
        const Dimmed dimmed = dimmed_by(ink, false);
        ink.opacity = dimmed.transmittance < faintest_ink ? 0.0F : dimmed.transmittance;
        seen += ink.opacity > 0.0F;
        if (!(ink.opacity > 0.0F) || dimmed.more_behind == nothing) return;
        nearest = std::min(nearest, dimmed.more_behind);
        farthest = std::max(farthest, ink.depth);
    });
    if (nearest == nothing) return seen;
    for (float* const depth : {planes.depth[LayerPlanes::next_front], planes.depth[LayerPlanes::next_back]})
        std::fill_n(depth, plane, nothing);
    drawing.splat_tiles.for_spans(tile, [&](std::span<const std::uint32_t> numbers) {
        SplatList list = list_of(drawing.splats.span(), numbers, corner);
        list.nearest = nearest;
        list.farthest = farthest;
        loops_.lay_next(planes, list);
    });
    seen = 0;
    for_own([&](Dot& ink) {
        if (ink.opacity > 0.0F) ink.opacity *= dimmed_by(ink, true).transmittance;
        if (ink.opacity < faintest_ink) ink.opacity = 0.0F;
        seen += ink.opacity > 0.0F;
    });
    return seen;
}

} // namespace hrbfnpr::frame
