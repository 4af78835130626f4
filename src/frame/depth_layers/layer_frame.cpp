// SPDX-License-Identifier: MIT
#include "frame/depth_layers/layer_frame.h"

#include "base/clock.h"
#include "drawing/segments.h"
#include "frame/depth_layers/tuning.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t strokes_a_task = 256;

// Whether all ink that there can be has one colour: then its order does not matter. Layers of marks have the numbers of
// their runs, and those of lines follow.
void find_color(const Scene& scene, drawing::Drawing& drawing) {
    HRBFNPR_ASSERT(scene.runs.size() <= drawing.layers.size());
    drawing.one_color = true;
    bool first = true;
    for (std::int64_t l = 0; l < drawing.layers.size(); ++l) {
        if (l < scene.runs.size() && !scene.runs[l].draws_front) continue;
        const glm::vec4& ink = drawing.layers[l].ink;
        if (std::exchange(first, false)) drawing.ink_color = ink;
        drawing.one_color = drawing.one_color && ink == drawing.ink_color;
    }
}

// Puts all dots into tiles but those of hatching.
void bin_dots(const base::Parallel& parallel, const Scene& scene, std::span<const Piece> pieces,
              drawing::Drawing& drawing) {
    const glm::vec4& v = scene.lens.viewport;
    drawing.first_pixel = glm::ivec2(std::floor(v.x), std::floor(v.y));
    const auto left = static_cast<float>(drawing.first_pixel.x);
    const auto top = static_cast<float>(drawing.first_pixel.y);
    const auto width = static_cast<std::int32_t>(std::ceil(v.x + v.z - left));
    const auto height = static_cast<std::int32_t>(std::ceil(v.y + v.w - top));
    drawing.dot_tiles.build(parallel, width, height, pieces, [&](std::int64_t i, drawing::Tiles::Footprint& print) {
        const Dot& ink = drawing.dots[i];
        // A dot that just misses the picture belongs to the nearest tile, too.
        print = {std::clamp(ink.x - left, 0.0F, static_cast<float>(width)),
                 std::clamp(ink.y - top, 0.0F, static_cast<float>(height)),
                 std::max(ink.radius, smallest_radius) + soft_rim};
        return true;
    });
    if (!drawing.one_color)
        drawing.dot_tiles.order(parallel, [&](std::uint32_t a, std::uint32_t b) { return drawing.before(a, b); });
}

} // namespace

LayerFrame::LayerFrame(const base::Runtime& runtime) noexcept
    : runtime_(runtime), gathering_(runtime.memory), hatch_points_(runtime), hatch_tiles_(runtime),
      edges_(runtime.memory), hatch_strokes_(runtime), layers_(runtime.memory), dot_of_(runtime.memory),
      joined_(runtime.memory), ready_(runtime.memory), keys_(runtime.memory), order_(runtime.memory) {}

void LayerFrame::run(const Scene& scene, const LineStrokes& lines, const base::Progress& progress,
                     drawing::Drawing& drawing) {
    drawing.painting = drawing::Painting::transmittance;
    find_color(scene, drawing);
    base::Stopwatch watch;
    gather(runtime_, scene, gathering_, drawing);
    const std::int64_t gathered = drawing.dot_pieces.size();
    hatch_points_.run({scene, gathering_.sights.span(), gathering_.frustum, gathering_.tau.span()}, drawing);
    drawing.counts.nanoseconds_classify = watch.nanoseconds();

    progress.update(layer_tuning.gathered);
    watch.restart();
    bin_dots(runtime_.parallel, scene, drawing.dot_pieces.span().first(static_cast<std::size_t>(gathered)), drawing);
    hatch_tiles_.build(hatch_points_.batches(), drawing);
    drawing.counts.nanoseconds_sort = watch.nanoseconds();

    watch.restart();
    dim(scene, drawing);
    drawing.counts.nanoseconds_visibility = watch.nanoseconds();

    progress.update(layer_tuning.dimmed);
    watch.restart();
    edges_.clear();
    if (!hatch_points_.batches().empty() && !lines.strokes.empty())
        edges_.build(lines, drawing.layers.span(), scene.lens.viewport);
    const std::span<const float> largest = drawing.has_splats ? layers_.largest.span() : std::span<const float>();
    const std::span<const HatchStrokePart> hatching =
        hatch_strokes_.run(scene, hatch_points_, {edges_, drawing, largest}, drawing);
    join_dots(scene, drawing);
    put_strokes(lines, hatching, drawing);
    drawing.counts.nanoseconds_sort += watch.nanoseconds();
}

void LayerFrame::dim(const Scene& scene, drawing::Drawing& drawing) {
    std::int64_t dots = 0;
    for (const Piece& piece : drawing.dot_pieces) dots += piece.end - piece.begin;
    drawing.has_splats = std::any_of(scene.runs.begin(), scene.runs.end(), [](const Run& run) { return run.splats; });
    drawing.dot_count = drawing.has_splats ? dim_by_layers(runtime_, scene, hatch_tiles_, layers_, drawing) : dots;
    if (std::any_of(scene.items.begin(), scene.items.end(), [](const ItemView& i) { return i.model != nullptr; }))
        drawing.dot_count -= dim_by_rays(runtime_, scene, layers_, drawing);
    drawing.counts.shown = drawing.dot_count;
    drawing.counts.dropped_hidden = dots - drawing.dot_count;
}

// Marks that follow each other along a stroke of a layer that is drawn as strokes, and are shown, become one line;
// their dots are not drawn any more. A single one stays a dot.
void LayerFrame::join_dots(const Scene& scene, drawing::Drawing& drawing) {
    joined_.strokes.clear();
    joined_.points.clear();
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        const Run& run = scene.runs[r];
        if (run.shape != Shape::strokes) continue;
        const marks::Layer& layer = *run.marks;
        base::resize_scratch(dot_of_, run.count);
        std::fill(dot_of_.begin(), dot_of_.end(), -1);
        for (const Piece& piece : drawing.dot_pieces) {
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
                drawing::Stroke stroke;
                stroke.first = joined_.points.size();
                stroke.count = static_cast<std::int32_t>(i - begin);
                stroke.layer = static_cast<std::uint32_t>(r);
                stroke.depth = drawing.dots[dot_at((begin + i) / 2)].depth;
                joined_.strokes.push_back(stroke);
                float length = 0.0F;
                for (std::int64_t k = begin; k < i; ++k) {
                    Dot& dot = drawing.dots[dot_at(k)];
                    if (k > begin)
                        length += std::hypot(dot.x - joined_.points.back().x, dot.y - joined_.points.back().y);
                    joined_.points.push_back({dot.x, dot.y, dot.radius, dot.opacity, dot.depth, dot.window,
                                              dot.pixels_per_unit, length, dot.id});
                    dot.opacity = 0.0F;
                }
                drawing.dot_count -= stroke.count;
                HRBFNPR_ASSERT(drawing.dot_count >= 0);
            }
        }
    }
}

// Puts the strokes of all lists into the drawing, far to near.
void LayerFrame::put_strokes(const LineStrokes& lines, std::span<const HatchStrokePart> hatching,
                             drawing::Drawing& drawing) {
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
    for (const HatchStrokePart& part : hatching) add(part.made);
    if (ready_.empty()) return;
    order_.sort(runtime_.parallel, keys_);
    base::resize_scratch(drawing.points, points);
    points = 0;
    for (const std::uint64_t key : keys_) {
        const Ready& ready = ready_[static_cast<std::uint32_t>(key)];
        drawing::Stroke stroke = ready.list->strokes[ready.number];
        stroke.first = std::exchange(points, points + stroke.count);
        drawing.strokes.push_back(stroke);
    }
    runtime_.parallel.for_chunks(keys_.size(), strokes_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const Ready& ready = ready_[static_cast<std::uint32_t>(keys_[i])];
            const drawing::Stroke& stroke = drawing.strokes[i];
            std::copy_n(ready.list->points.data() + ready.list->strokes[ready.number].first, stroke.count,
                        drawing.points.data() + stroke.first);
        }
    });
    drawing::bin_segments(runtime_.parallel, drawing);
}

std::int64_t LayerFrame::bytes() const noexcept {
    return gathering_.bytes() + hatch_points_.bytes() + hatch_tiles_.bytes() + edges_.bytes() + hatch_strokes_.bytes() +
           layers_.bytes() + dot_of_.bytes() + joined_.strokes.bytes() + joined_.points.bytes() + ready_.bytes() +
           keys_.bytes() + order_.bytes();
}

} // namespace hrbfnpr::frame
