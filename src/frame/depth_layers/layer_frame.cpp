// SPDX-License-Identifier: MIT
#include "frame/depth_layers/layer_frame.h"

#include "base/clock.h"
#include "base/operation.h"
#include "base/scratch.h"
#include "drawing/drawing.h"
#include "frame/depth_layers/layer_loops.h"
#include "frame/depth_layers/tuning.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t strokes_a_task = 256;

// Finds whether all possible ink has one colour, because its order then does not matter. The drawing's layers of runs
// come first, in the order of the runs. The layers of lines follow.
void find_color(const Scene& scene, drawing::Drawing& drawing) {
    drawing.one_color = true;
    bool first = true;
    const auto add = [&](std::int64_t layer) {
        const glm::vec4& ink = drawing.layers[layer].ink;
        if (std::exchange(first, false)) drawing.ink_color = ink;
        drawing.one_color = drawing.one_color && ink == drawing.ink_color;
    };
    std::int64_t end = 0; // the end of the layers of runs
    for (const Run& run : scene.runs) {
        HRBFNPR_ASSERT(run.first_layer == end);
        end += run.layers;
        for (std::int64_t l = run.first_layer; run.draws_front && l < end; ++l) add(l);
    }
    for (std::int64_t l = end; l < drawing.layers.size(); ++l) add(l);
}

// Moves dots from the numbers of their runs to the drawing's layers. They differ only if there are several inks.
void take_layers(const base::Parallel& parallel, const Scene& scene, drawing::Drawing& drawing) {
    if (scene.inks.empty()) return;
    parallel.for_each(drawing.dot_ranges.size(), [&](std::int64_t piece) {
        for (std::int64_t i = drawing.dot_ranges[piece].begin; i < drawing.dot_ranges[piece].end; ++i)
            drawing.dots[i].layer = scene.runs[drawing.dots[i].layer].first_layer + drawing.dots[i].ink;
    });
}

// Puts all dots into tiles, except dots of hatching.
void bin_dots(const base::Parallel& parallel, std::span<const IndexRange> pieces, drawing::Drawing& drawing) {
    const auto left = static_cast<float>(drawing.first_pixel.x);
    const auto top = static_cast<float>(drawing.first_pixel.y);
    const std::int32_t width = drawing.pixels.x;
    const std::int32_t height = drawing.pixels.y;
    drawing.dot_tiles.build(parallel, width, height, pieces, [&](std::int64_t i, drawing::Tiles::Footprint& print) {
        const Dot& ink = drawing.dots[i];
        // A dot that is just outside the picture belongs to the nearest tile.
        print = drawing::Tiles::Footprint::of_disc(std::clamp(ink.x - left, 0.0F, static_cast<float>(width)),
                                                   std::clamp(ink.y - top, 0.0F, static_cast<float>(height)),
                                                   std::max(ink.radius, smallest_radius) + soft_rim);
        return true;
    });
    if (!drawing.one_color)
        drawing.dot_tiles.order(parallel, [&](std::uint32_t a, std::uint32_t b) { return drawing.before(a, b); });
}

// ---- The layers that each dot of ink is seen through                                                      [NPAR 6.1]
//
// A mark that faces the eye is never hidden by its own layer. Another layer of its item that faces the eye hides it
// only if a layer that faces away lies between them. In a solid, the two kinds of layers alternate.

constexpr float no_depth = std::numeric_limits<float>::infinity();

// Planes extend some pixels beyond their tile. Dots just outside the picture need these pixels, as does the test
// whether a surface continues where an item ends.
constexpr std::int32_t tile_size = drawing::tile_size;
constexpr std::int32_t narrow_apron = 4;
constexpr std::int32_t wide_apron = 9;
constexpr std::int32_t side = tile_size + 2 * wide_apron;
constexpr std::int32_t stride = side + 16;
constexpr std::int64_t plane = std::int64_t{stride} * side;
constexpr std::int64_t planes_of_one = 2 * LayerPlanes::layers + 2;

constexpr std::int64_t rays_at_a_time = 16384;
constexpr std::int32_t most_layers = 8; // The largest number of layers that a ray finds.

// The surfaces and tables that reduce the opacity of dots in a drawing.
struct DimmingInput {
    const Scene& scene;
    const HatchTiles& hatching;
    LayerLoops loops;
    // A bit for each item with a border; the bit's index is given by the lowest bits of the item's number.
    std::uint32_t open_item_bits;
    std::int32_t apron;
};

[[nodiscard]] LayerPlanes planes_of(float* at, std::int32_t apron) noexcept {
    const std::int32_t size = tile_size + 2 * apron;
    LayerPlanes planes{size, size, stride, {}, {}, nullptr, nullptr, 0.0F};
    const auto next = [&] { return std::exchange(at, at + plane); };
    for (float*& depth : planes.depth) depth = next();
    planes.halo = next();
    for (float*& transmittance : planes.transmittance) transmittance = next();
    planes.halo_transmittance = next();
    return planes;
}

// Returns the index of the pixel at a place. Places outside the planes are clamped.
[[nodiscard]] std::int32_t pixel_at(const LayerPlanes& p, const glm::vec2& place) noexcept {
    const auto column = static_cast<std::int32_t>(std::clamp(place.x, 0.0F, static_cast<float>(p.width - 1)));
    const auto row = static_cast<std::int32_t>(std::clamp(place.y, 0.0F, static_cast<float>(p.height - 1)));
    return row * p.stride + column;
}

// Returns whether the layer continues in all directions. In each direction, the layer must be visible, or something
// nearer must cover the place to which the layer's slope leads.
[[nodiscard]] bool continues_around(const LayerPlanes& p, std::int64_t layer, const glm::vec2& place) noexcept {
    const float reach = layer_tuning.border_reach * p.largest_splat;
    const std::int32_t here = pixel_at(p, place);
    const float* const depth = p.depth[layer];
    const auto is_same = [&](std::int32_t at) {
        return depth[at] < no_depth && item_of(p.transmittance[layer][at]) == item_of(p.transmittance[layer][here]);
    };
    for (const glm::vec2& to : {glm::vec2(reach, 0.0F), {-reach, 0.0F}, {0.0F, reach}, {0.0F, -reach}}) {
        const std::int32_t there = pixel_at(p, place + to);
        if (is_same(there)) continue;
        const std::int32_t opposite = pixel_at(p, place - to);
        if (!is_same(opposite) || depth[there] >= 2.0F * depth[here] - depth[opposite]) return false;
    }
    return true;
}

// The layers through which a dot is seen.
struct DimResult {
    float transmittance = 1.0F;
    // Other layers in front of the ink can only be at this depth or farther. `no_depth`: there is no other layer.
    float more_from = no_depth;
};

// Reduces a dot's opacity by the nearest layers and the halo or, if `next` is true, by the next layers. `place` is in
// pixels of the planes.
DimResult dim(const DimmingInput& by, const LayerPlanes& p, const Dot& ink, const glm::vec2& place,
              bool next) noexcept {
    HRBFNPR_ASSERT(ink.layer < by.scene.runs.size() && ink.pixels_per_unit > 0.0F);
    DimResult result;
    const std::int32_t at = pixel_at(p, place);
    if (!next && p.halo[at] + scene_tuning.halo_gap / ink.pixels_per_unit < ink.depth)
        result.transmittance = p.halo_transmittance[at];
    if ((ink.flags & dot_is_exact) != 0) return result;
    const float other = layer_tuning.side_gap / ink.pixels_per_unit;
    const float own = layer_tuning.own_gap * p.largest_splat / ink.pixels_per_unit;
    const float border = layer_tuning.border_gap * p.largest_splat / ink.pixels_per_unit;
    const bool has_items = by.scene.items.size() > 1;
    const std::uint32_t item = bits_of_item(by.scene.runs[ink.layer].item);
    const bool faces_back = (ink.flags & dot_faces_back) != 0;
    const auto hides = [&](std::int64_t layer, bool alike) {
        const float depth = p.depth[layer][at];
        const std::uint32_t its = item_of(p.transmittance[layer][at]);
        // True if the layer belongs to another item than the ink, so it cannot be the ink's own layer.
        const bool is_other = has_items && depth < no_depth && its != item;
        if (alike && !is_other) return depth + own < ink.depth;
        if (!(depth + other < ink.depth)) return false;
        const bool may_end = is_other && alike && (by.open_item_bits >> its & 1U) != 0;
        return !may_end || depth + border < ink.depth || continues_around(p, layer, place);
    };
    const std::int64_t first = next ? std::int64_t{LayerPlanes::next_front} : std::int64_t{LayerPlanes::front};
    const float front = p.depth[first][at];
    const float back = p.depth[first + 1][at];
    const bool after_back = hides(first + 1, faces_back);
    const bool after_front = hides(first, !faces_back) || (after_back && front < back);
    if (after_front) result.transmittance *= p.transmittance[first][at];
    if (after_back) result.transmittance *= p.transmittance[first + 1][at];
    // In a solid, a layer that faces away is between any two layers that face the eye.
    if (after_back || (after_front && back == no_depth)) result.more_from = std::min(front, back);
    return result;
}

// Reduces the opacity of the dots whose centres are in a tile: by the nearest layers and, if ink is still visible
// through these, by the next layers. Returns the number of dots that are drawn. Sets `largest` to the radius of the
// largest splat.
std::int64_t dim_tile(const DimmingInput& by, LayerPlanes& planes, drawing::Drawing& drawing, std::int64_t tile,
                      float& largest) noexcept {
    const drawing::Tiles& tiles = drawing.dot_tiles;
    HRBFNPR_ASSERT(tile >= 0 && tile < tiles.tiles());
    const glm::vec2 origin(drawing.first_pixel);
    const glm::vec2 corner = origin + glm::vec2(static_cast<float>(tile % tiles.columns() * tile_size - by.apron),
                                                static_cast<float>(tile / tiles.columns() * tile_size - by.apron));
    const drawing::Tiles::Extent own = tiles.own_extent(tile);
    const auto for_own = [&](auto&& f) {
        tiles.for_tile(tile, [&](std::uint32_t i) {
            Dot& ink = drawing.dots[i];
            if (own.holds(ink.x - origin.x, ink.y - origin.y)) f(ink);
        });
        by.hatching.for_tile(tile, [&](std::int64_t i) { f(drawing.dots[i]); });
    };
    const auto dimmed_by = [&](const Dot& ink, bool next) {
        return dim(by, planes, ink, glm::vec2(ink.x, ink.y) - corner, next);
    };
    const auto clear = [](std::initializer_list<float*> depths) {
        for (float* const depth : depths) std::fill_n(depth, plane, no_depth);
    };
    const std::span<const Splat> splats = drawing.splats.span();
    const auto list_of = [&](std::span<const std::uint32_t> numbers, float nearest, float farthest) {
        return SplatList{splats.data(), numbers.data(), static_cast<std::int64_t>(numbers.size()), corner.x, corner.y,
                         nearest,       farthest};
    };
    const auto draw_nearest = [&] {
        clear({planes.depth[LayerPlanes::front], planes.depth[LayerPlanes::back], planes.halo});
        planes.largest_splat = 0.0F;
        drawing.splat_tiles.for_spans(tile, [&](std::span<const std::uint32_t> numbers) {
            for (const std::uint32_t number : numbers)
                planes.largest_splat = std::max(planes.largest_splat, splats[number].radius);
            const SplatList list = list_of(numbers, -no_depth, no_depth);
            by.loops.draw_nearest(planes, list);
            by.loops.draw_halos(planes, list);
        });
        largest = planes.largest_splat;
    };
    std::int64_t seen = 0;
    bool laid = false;
    float nearest = no_depth;
    float farthest = -no_depth;
    largest = 0.0F;
    for_own([&](Dot& ink) {
        if (!std::exchange(laid, true)) draw_nearest();
        const DimResult dimmed = dimmed_by(ink, false);
        ink.opacity = dimmed.transmittance < faintest_ink ? 0.0F : dimmed.transmittance;
        seen += ink.opacity > 0.0F;
        if (!(ink.opacity > 0.0F) || dimmed.more_from == no_depth) return;
        nearest = std::min(nearest, dimmed.more_from);
        farthest = std::max(farthest, ink.depth);
    });
    if (nearest == no_depth) return seen;
    clear({planes.depth[LayerPlanes::next_front], planes.depth[LayerPlanes::next_back]});
    drawing.splat_tiles.for_spans(tile, [&](std::span<const std::uint32_t> numbers) {
        by.loops.draw_next(planes, list_of(numbers, nearest, farthest));
    });
    seen = 0;
    for_own([&](Dot& ink) {
        if (ink.opacity > 0.0F) ink.opacity *= dimmed_by(ink, true).transmittance;
        if (ink.opacity < faintest_ink) ink.opacity = 0.0F;
        seen += ink.opacity > 0.0F;
    });
    return seen;
}

// ---- Rays

// Casts rays from the dots in `asked`. Multiplies the opacity of each by the transmittance of the layers that its ray
// meets. Returns the number of dots that are no longer drawn.
std::int64_t cast_dot_rays(const base::Runtime& runtime, const Scene& scene, const ItemView& item, DepthLayers& scratch,
                           drawing::Drawing& drawing) {
    HRBFNPR_ASSERT(scratch.rays.origin.size() == scratch.ray_dots.size());
    surface::RaySettings settings;
    settings.maximum_hits = most_layers;
    if (scene.lens.centre.w != 0.0F) settings.t_max = 1.0; // Rays end at the eye.
    surface::cast_rays(runtime, *item.model, settings, scratch.rays, scratch.hits);
    std::int64_t hidden = 0;
    for (std::int64_t i = 0; i < scratch.ray_dots.size(); ++i) {
        Dot& ink = drawing.dots[scratch.ray_dots[i]];
        const glm::dvec3 sight = scratch.rays.direction[i] / -item.unit;
        for (std::int32_t hit = 0; hit < scratch.hits.count[i]; ++hit) {
            const glm::dvec3 n = scratch.hits.normal[i * most_layers + hit];
            const double nu = glm::dot(n, sight) / glm::length(sight);
            ink.opacity *= layer_transmittance(item.style, static_cast<float>(nu), item.both_sides);
        }
        if (ink.opacity >= faintest_ink) continue;
        ink.opacity = 0.0F;
        ++hidden;
    }
    scratch.rays.origin.clear();
    scratch.rays.direction.clear();
    scratch.ray_dots.clear();
    return hidden;
}

// Puts the drawing's splats into tiles. Sets the opacity of each dot to the transmittance of the depth layers that the
// splats represent. All dots must already be in tiles. The dots of hatching are in separate tiles. Returns the number
// of dots that are drawn.
[[nodiscard]] std::int64_t dim_by_layers(const base::Runtime& runtime, const Scene& scene, const HatchTiles& hatching,
                                         DepthLayers& scratch, drawing::Drawing& drawing) {
    const drawing::Tiles& tiles = drawing.dot_tiles;
    const glm::vec2 origin(drawing.first_pixel);
    DimmingInput by{scene, hatching, layer_loops(runtime.instruction_set), 0, narrow_apron};
    for (std::int64_t i = 0; scene.items.size() > 1 && i < scene.items.size(); ++i)
        if (scene.items[i].both_sides) by.open_item_bits |= 1U << bits_of_item(static_cast<std::int32_t>(i));
    if (by.open_item_bits != 0) by.apron = wide_apron;
    drawing.splat_tiles.build(runtime.parallel, tiles.columns() * tile_size, tiles.rows() * tile_size,
                              drawing.splat_ranges.span(), [&](std::int64_t i, drawing::Tiles::Footprint& print) {
                                  const Splat& c = drawing.splats[i];
                                  const float reach = std::max(c.radius, c.halo) + static_cast<float>(by.apron) + 1.0F;
                                  print = drawing::Tiles::Footprint::of_disc(c.x - origin.x, c.y - origin.y, reach);
                                  return true;
                              });
    const std::int64_t workers = std::max(1, runtime.parallel.threads());
    base::resize_scratch(scratch.planes, workers * planes_of_one * plane);
    base::resize_scratch(scratch.seen, tiles.tiles());
    base::resize_scratch(scratch.largest, tiles.tiles());
    std::atomic<std::int64_t> next{0};
    runtime.parallel.for_each(workers, [&](std::int64_t worker) {
        LayerPlanes planes = planes_of(scratch.planes.data() + worker * planes_of_one * plane, by.apron);
        for (std::int64_t tile = next++; tile < tiles.tiles(); tile = next++)
            scratch.seen[tile] = dim_tile(by, planes, drawing, tile, scratch.largest[tile]);
    });
    return std::accumulate(scratch.seen.begin(), scratch.seen.end(), std::int64_t{0});
}

// For items with a model, multiplies the opacity of dots by the result of rays. Returns the number of dots that are no
// longer drawn. Throws Error{callback, out_of_memory}.
[[nodiscard]] std::int64_t dim_by_rays(const base::Runtime& runtime, const Scene& scene, DepthLayers& scratch,
                                       drawing::Drawing& drawing) {
    scratch.rays.origin.clear(); // If the last frame failed, its rays may still be in the list.
    scratch.rays.direction.clear();
    scratch.ray_dots.clear();
    const glm::dvec3 centre(scene.lens.centre);
    const bool parallel = scene.lens.centre.w == 0.0F;
    std::int64_t hidden = 0;
    const ItemView* item = nullptr; // the item whose rays are collected
    glm::dmat3 back(1.0);           // from eye space to the item's space
    double scale = 1.0;
    const auto flush = [&] {
        if (!scratch.ray_dots.empty()) hidden += cast_dot_rays(runtime, scene, *item, scratch, drawing);
    };
    for (const IndexRange& piece : drawing.dot_ranges) {
        for (std::int64_t i = piece.begin; i < piece.end; ++i) {
            const Dot& ink = drawing.dots[i];
            const Run& run = scene.runs[ink.layer];
            if (&scene.item_of(run) != item || scratch.ray_dots.size() == rays_at_a_time) {
                flush();
                item = &scene.item_of(run);
                back = glm::inverse(glm::dmat3(item->to_eye));
                scale = std::cbrt(std::abs(glm::determinant(glm::dmat3(item->to_eye))));
            }
            if (item->model == nullptr || !(ink.opacity > 0.0F)) continue;
            const std::int64_t mark = ink.id - run.first_id;
            HRBFNPR_ASSERT(mark >= 0 && mark < run.count);
            const double pixel = 1.0 / (static_cast<double>(ink.pixels_per_unit) * scale);
            const glm::dvec3 from = glm::dvec3(run.place_of(mark, item->unit)) +
                                    layer_tuning.ray_offset * pixel * glm::dvec3(run.normal_of(mark));
            // If lines of sight are parallel, the length does not matter, because rays end at the model's bounds.
            const glm::dvec3 to = parallel ? from - back * centre : back * (centre - glm::dvec3(item->eye_offset));
            scratch.rays.origin.push_back(item->unit * from + item->origin);
            scratch.rays.direction.push_back(item->unit * (to - from));
            scratch.ray_dots.push_back(static_cast<std::uint32_t>(i));
        }
    }
    flush();
    return hidden;
}

} // namespace

LayerFrame::LayerFrame(const base::Runtime& runtime) noexcept
    : runtime_(runtime), gathering_(runtime.memory), even_order_(runtime.memory), hatch_points_(runtime),
      hatch_tiles_(runtime), edges_(runtime.memory), layers_(runtime.memory), dot_of_(runtime.memory),
      joined_(runtime.memory), line_(runtime.memory), line_inks_(runtime.memory), ready_(runtime.memory),
      keys_(runtime.memory), order_(runtime.memory) {}

void LayerFrame::run(const Scene& scene, const LineStrokes& lines, const base::Progress& progress,
                     drawing::Drawing& drawing) {
    drawing.painting = drawing::Painting::transmittance;
    find_color(scene, drawing);
    const glm::vec4& v = scene.lens.viewport;
    drawing.first_pixel = glm::ivec2(std::floor(v.x), std::floor(v.y));
    drawing.pixels = glm::ivec2(std::ceil(v.x + v.z), std::ceil(v.y + v.w)) - drawing.first_pixel;
    base::Stopwatch watch;
    edges_.clear();
    if (!lines.strokes.empty()) edges_.build(lines, drawing.layers.span(), scene.lens.viewport);
    gather(runtime_, scene, edges_, gathering_, drawing);
    even_order_.run(runtime_, scene, gathering_.even.span(), drawing);
    const std::int64_t gathered = drawing.dot_ranges.size();
    hatch_points_.run({scene, gathering_.sights.span(), gathering_.frustum, gathering_.tau.span()}, drawing);
    drawing.counts.nanoseconds_classify = watch.nanoseconds();

    progress.update(layer_tuning.gathered_share);
    watch.restart();
    bin_dots(runtime_.parallel, drawing.dot_ranges.span().first(static_cast<std::size_t>(gathered)), drawing);
    hatch_tiles_.build(hatch_points_.batches(), drawing);
    drawing.counts.nanoseconds_sort = watch.nanoseconds();

    watch.restart();
    dim(scene, drawing);
    drawing.counts.nanoseconds_visibility = watch.nanoseconds();

    progress.update(layer_tuning.dimmed_share);
    watch.restart();
    const std::span<const float> largest = drawing.has_splats ? layers_.largest.span() : std::span<const float>();
    make_strokes(runtime_, scene, {edges_, drawing, largest}, hatch_points_.batches(), drawing);
    join_dots(scene, drawing);
    take_layers(runtime_.parallel, scene, drawing);
    add_strokes(lines, drawing);
    drawing.counts.nanoseconds_sort += watch.nanoseconds();
}

void LayerFrame::dim(const Scene& scene, drawing::Drawing& drawing) {
    std::int64_t dots = 0;
    for (const IndexRange& piece : drawing.dot_ranges) dots += piece.end - piece.begin;
    drawing.has_splats = std::any_of(scene.runs.begin(), scene.runs.end(), [](const Run& run) { return run.splats; });
    drawing.dot_count = drawing.has_splats ? dim_by_layers(runtime_, scene, hatch_tiles_, layers_, drawing) : dots;
    if (std::any_of(scene.items.begin(), scene.items.end(), [](const ItemView& i) { return i.model != nullptr; }))
        drawing.dot_count -= dim_by_rays(runtime_, scene, layers_, drawing);
    drawing.counts.shown = drawing.dot_count;
    drawing.counts.dropped_hidden = dots - drawing.dot_count;
}

// Makes a line through the dots of consecutive marks of a stroke. The line is cut where the ink changes. The dots are
// no longer drawn. dot_at(k) is the dot of the k-th mark.
template <class DotAt>
void LayerFrame::join(const Run& run, std::int64_t count, const DotAt& dot_at) {
    HRBFNPR_ASSERT(count >= 2);
    line_.clear();
    line_inks_.clear();
    float length = 0.0F;
    for (std::int64_t k = 0; k < count; ++k) {
        Dot& dot = dot_at(k);
        if (k > 0) length += std::hypot(dot.x - line_.back().x, dot.y - line_.back().y);
        line_.push_back(
            {dot.x, dot.y, dot.radius, dot.opacity, dot.depth, dot.window, dot.pixels_per_unit, length, dot.id});
        line_inks_.push_back(dot.ink);
        dot.opacity = 0.0F;
    }
    drawing::Stroke stroke;
    stroke.depth = line_[count / 2].depth;
    if (run.inks >= 0) settle_inks(line_.span(), line_inks_.span());
    add_in_inks(stroke, run.first_layer, line_.span(), line_inks_.span(),
                [&](drawing::Stroke part, std::span<const drawing::StrokePoint> points) {
                    joined_.add_points(part, points);
                    joined_.strokes.push_back(part);
                });
}

// If a layer is drawn as strokes, joins its consecutive marks that are shown into lines. A mark without shown
// neighbours stays a dot.
void LayerFrame::join_dots(const Scene& scene, drawing::Drawing& drawing) {
    joined_.strokes.clear();
    joined_.points.clear();
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        const Run& run = scene.runs[r];
        if (run.shape != Shape::strokes) continue;
        const marks::Layer& layer = *run.marks;
        base::resize_scratch(dot_of_, run.count);
        std::fill(dot_of_.begin(), dot_of_.end(), -1);
        for (const IndexRange& piece : drawing.dot_ranges) {
            if (piece.begin < run.first_place || piece.begin >= run.first_place + run.places()) continue;
            for (std::int64_t i = piece.begin; i < piece.end; ++i)
                if (drawing.dots[i].opacity > 0.0F) dot_of_[drawing.dots[i].id - run.first_id] = i;
        }
        const auto dot_at = [&](std::int64_t at) { return dot_of_[layer.mark_of(at)]; };
        for (std::int64_t s = 0; s < layer.strokes(); ++s) {
            const std::int64_t end = layer.stroke_first[s + 1];
            for (std::int64_t i = layer.stroke_first[s]; i < end; ++i) {
                const std::int64_t begin = i;
                while (i < end && dot_at(i) >= 0) ++i;
                if (i - begin < 2) continue;
                join(run, i - begin, [&](std::int64_t k) -> Dot& { return drawing.dots[dot_at(begin + k)]; });
                drawing.dot_count -= i - begin;
                HRBFNPR_ASSERT(drawing.dot_count >= 0);
            }
        }
    }
}

// Puts the strokes of all lists into the drawing, from far to near.
void LayerFrame::add_strokes(const LineStrokes& lines, drawing::Drawing& drawing) {
    ready_.clear();
    keys_.clear();
    std::int64_t points = 0;
    const auto add = [&](const LineStrokes& list) {
        for (std::int64_t i = 0; i < list.strokes.size(); ++i) {
            HRBFNPR_ASSERT(list.strokes[i].first + list.strokes[i].count <= list.points.size());
            keys_.push_back(drawing::far_first_key(list.strokes[i].depth, static_cast<std::uint32_t>(ready_.size())));
            ready_.push_back({&list, i});
            points += list.strokes[i].count;
        }
    };
    add(joined_);
    add(lines);
    for (const HatchPoints::Batch& batch : hatch_points_.batches()) add(batch.part.made);
    if (ready_.empty()) return;
    order_.sort(runtime_.parallel, keys_);
    base::resize_scratch(drawing.points, points);
    points = 0;
    for (const std::uint64_t key : keys_) {
        const ReadyStroke& ready = ready_[static_cast<std::uint32_t>(key)];
        drawing::Stroke stroke = ready.list->strokes[ready.number];
        stroke.first = std::exchange(points, points + stroke.count);
        drawing.strokes.push_back(stroke);
    }
    runtime_.parallel.for_chunks(keys_.size(), strokes_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const ReadyStroke& ready = ready_[static_cast<std::uint32_t>(keys_[i])];
            const drawing::Stroke& stroke = drawing.strokes[i];
            std::copy_n(ready.list->points.data() + ready.list->strokes[ready.number].first, stroke.count,
                        drawing.points.data() + stroke.first);
        }
    });
    drawing::bin_segments(runtime_.parallel, drawing);
}

std::int64_t LayerFrame::bytes() const noexcept {
    return gathering_.bytes() + even_order_.bytes() + hatch_points_.bytes() + hatch_tiles_.bytes() + edges_.bytes() +
           layers_.bytes() + dot_of_.bytes() + joined_.strokes.bytes() + joined_.points.bytes() + line_.bytes() +
           line_inks_.bytes() + ready_.bytes() + keys_.bytes() + order_.bytes();
}

} // namespace hrbfnpr::frame
