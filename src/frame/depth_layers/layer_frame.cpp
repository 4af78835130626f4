// SPDX-License-Identifier: MIT
#include "frame/depth_layers/layer_frame.h"

#include "base/clock.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// Shares of the time, as of many marks.
constexpr double gathered_end = 0.4;
constexpr double sorted_end = 0.5;
constexpr double dimmed_end = 0.8;

// Whether all ink that there can be has one colour: then its order does not matter.
void find_color(const Scene& scene, drawing::Drawing& drawing) {
    drawing.one_color = true;
    bool first = true;
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        if (!scene.runs[r].draws_front) continue;
        const glm::vec4& ink = drawing.layers[2 * r].ink;
        if (std::exchange(first, false)) drawing.ink_color = ink;
        drawing.one_color = drawing.one_color && ink == drawing.ink_color;
    }
    for (std::int64_t l = 2 * scene.runs.size(); l < drawing.layers.size(); ++l) { // of lines
        const glm::vec4& ink = drawing.layers[l].ink;
        if (std::exchange(first, false)) drawing.ink_color = ink;
        drawing.one_color = drawing.one_color && ink == drawing.ink_color;
    }
}

} // namespace

LayerFrame::LayerFrame(const base::Runtime& runtime) noexcept
    : runtime_(runtime), gather_(runtime), hatch_points_(runtime), hatch_tiles_(runtime), edges_(runtime.memory),
      hatch_strokes_(runtime), layers_(runtime), exact_(runtime.memory), joiner_(runtime) {}

void LayerFrame::run(Scene& scene, const LineStrokes& lines, const base::Progress& progress,
                     drawing::Drawing& drawing) {
    drawing.painting = drawing::Painting::transmittance;
    find_color(scene, drawing);
    base::Stopwatch watch;
    gather_.run(scene, drawing);
    drawing.counts = gather_.info();
    const std::int64_t gathered = drawing.dot_pieces.size();
    hatch_points_.run({scene, gather_.sights(), gather_.frustum(), gather_.taus().span()}, drawing);
    drawing.counts.nanoseconds_classify = watch.nanoseconds();

    progress.update(gathered_end);
    watch.restart();
    bin_dots(scene, drawing.dot_pieces.span().first(static_cast<std::size_t>(gathered)), drawing);
    hatch_tiles_.build(hatch_points_.batches(), drawing);
    drawing.counts.nanoseconds_sort = watch.nanoseconds();

    progress.update(sorted_end);
    watch.restart();
    dim(scene, drawing);
    drawing.counts.nanoseconds_visibility = watch.nanoseconds();

    progress.update(dimmed_end);
    watch.restart();
    edges_.clear();
    if (!hatch_points_.batches().empty() && !lines.strokes.empty())
        edges_.build(lines, drawing.layers.span(), scene.lens.viewport);
    const std::span<const float> largest = drawing.has_splats ? layers_.largest_splats() : std::span<const float>();
    const std::span<const HatchStrokePart> hatching =
        hatch_strokes_.run(scene, hatch_points_, {edges_, drawing, largest}, drawing);
    joiner_.run(scene, {lines, hatching}, drawing);
    drawing.counts.nanoseconds_sort += watch.nanoseconds();
}

void LayerFrame::bin_dots(const Scene& scene, std::span<const Piece> pieces, drawing::Drawing& drawing) const {
    const glm::vec4& v = scene.lens.viewport;
    drawing.first_pixel = glm::ivec2(std::floor(v.x), std::floor(v.y));
    const auto left = static_cast<float>(drawing.first_pixel.x);
    const auto top = static_cast<float>(drawing.first_pixel.y);
    const auto width = static_cast<std::int32_t>(std::ceil(v.x + v.z - left));
    const auto height = static_cast<std::int32_t>(std::ceil(v.y + v.w - top));
    drawing.dot_tiles.build(runtime_.parallel, width, height, pieces,
                            [&](std::int64_t i, drawing::Tiles::Footprint& print) {
                                const Dot& ink = drawing.dots[i];
                                // One that just misses the picture belongs to the nearest tile, too.
                                print = {std::clamp(ink.x - left, 0.0F, static_cast<float>(width)),
                                         std::clamp(ink.y - top, 0.0F, static_cast<float>(height)),
                                         std::max(ink.radius, smallest_radius) + soft_rim};
                                return true;
                            });
    if (!drawing.one_color)
        drawing.dot_tiles.order(runtime_.parallel,
                                [&](std::uint32_t a, std::uint32_t b) { return drawing.before(a, b); });
}

void LayerFrame::dim(const Scene& scene, drawing::Drawing& drawing) {
    std::int64_t inks = 0;
    for (const Piece& piece : drawing.dot_pieces) inks += piece.end - piece.begin;
    drawing.has_splats = std::any_of(scene.runs.begin(), scene.runs.end(), [](const Run& run) { return run.splats; });
    drawing.dot_count = drawing.has_splats ? layers_.attenuate(scene, hatch_tiles_, drawing) : inks;
    if (std::any_of(scene.items.begin(), scene.items.end(), [](const ItemView& i) { return i.model != nullptr; }))
        drawing.dot_count -= exact_.attenuate(runtime_, scene, drawing.dots.span(), drawing.dot_pieces.span());
    drawing.counts.shown = drawing.dot_count;
    drawing.counts.dropped_hidden = inks - drawing.dot_count;
}

std::int64_t LayerFrame::bytes() const noexcept {
    return gather_.bytes() + hatch_points_.bytes() + hatch_tiles_.bytes() + edges_.bytes() + hatch_strokes_.bytes() +
           layers_.bytes() + exact_.bytes() + joiner_.bytes();
}

} // namespace hrbfnpr::frame
