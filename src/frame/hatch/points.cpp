// SPDX-License-Identifier: MIT
#include "frame/hatch/points.h"

#include "base/scratch.h"

#include <algorithm>
#include <limits>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t marks_of_batch = 4096;

[[nodiscard]] bool asks(const Scene& scene, const Run& run) noexcept {
    return run.shape == Shape::hatch && scene.item_of(run).style.tone == Tone::callback;
}

} // namespace

void HatchPoints::add_batches(const Scene& scene) {
    count_ = 0;
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        if (scene.runs[r].shape != Shape::hatch) continue;
        const marks::Layer& layer = *scene.runs[r].marks;
        HatchRange range;
        std::int64_t next_piece = 0;
        for (range.end = 1; range.end <= layer.strokes(); ++range.end) {
            const std::int64_t last = layer.stroke_first[range.end - 1];
            next_piece += marks::pieces_of(layer.stroke_first[range.end] - last);
            const bool is_full = layer.stroke_first[range.end] - layer.stroke_first[range.begin] >= marks_of_batch;
            if (range.end < layer.strokes() && !is_full) continue;
            if (count_ == batches_.size()) batches_.add(runtime_.memory);
            Batch& batch = batches_[count_++];
            batch.run = static_cast<std::int32_t>(r);
            batch.strokes = range;
            batch.samples.clear();
            range.begin = range.end;
            range.piece = next_piece;
        }
    }
}

// Sorts the tones by mark, because clusters store marks in a different order.
void HatchPoints::take_taus(const Input& seen) {
    const Scene& scene = seen.scene;
    if (std::none_of(scene.runs.begin(), scene.runs.end(), [&](const Run& run) { return asks(scene, run); })) return;
    base::resize_scratch(taus_, scene.mark_count());
    for (const Run& run : scene.runs) {
        if (!asks(scene, run)) continue;
        for (const marks::Cluster& cluster : run.clusters->cluster) {
            const std::int64_t place = cluster.block * marks::MarkBlock::size;
            for (std::int64_t i = 0; i < cluster.count; ++i) {
                const marks::MarkBlock& block = run.clusters->block[cluster.block + i / marks::MarkBlock::size];
                taus_[run.first + block.mark[i % marks::MarkBlock::size]] =
                    seen.taus[static_cast<std::size_t>(run.first_place + place + i)];
            }
        }
    }
}

void HatchPoints::run(const Input& seen, drawing::Drawing& drawing) {
    const Scene& scene = seen.scene;
    const HatchView view{see_, loops_, scene, seen.frustum};
    add_batches(scene);
    take_taus(seen);
    runtime_.parallel.for_each(count_, [&](std::int64_t i) {
        Batch& batch = batches_[i];
        const Run& run = scene.runs[batch.run];
        sample_strokes(view, run, seen.sights[static_cast<std::size_t>(run.item)],
                       asks(scene, run) ? taus_.data() + run.first : nullptr, batch.strokes, batch.stroke,
                       batch.samples);
    });
    std::int64_t dots = drawing.dots.size();
    for (Batch& batch : batches()) {
        batch.first_dot = dots;
        dots += batch.samples.sample.size();
        if (dots > batch.first_dot) drawing.dot_ranges.push_back({batch.first_dot, dots});
    }
    drawing.dots.resize_for_overwrite(dots);
    runtime_.parallel.for_each(count_, [&](std::int64_t i) {
        const Batch& batch = batches_[i];
        const auto layer = static_cast<std::uint32_t>(batch.run);
        const Run& run = scene.runs[batch.run];
        const auto flags = static_cast<std::uint8_t>((run.turned ? dot_faces_back : 0) |
                                                     (scene.item_of(run).model != nullptr ? dot_is_exact : 0));
        Dot* to = drawing.dots.data() + batch.first_dot;
        // Between two marks whose scales differ by many orders of magnitude, interpolation may give a scale below 0.
        constexpr float least = std::numeric_limits<float>::min();
        for (const HatchSample& p : batch.samples.sample)
            *to++ = {p.x,  p.y,   0.5F * p.width,   1.0F, p.depth, p.window, std::max(least, p.pixels_per_unit),
                     p.id, layer, MarkClass::front, flags};
    });
}

std::int64_t HatchPoints::bytes() const noexcept {
    std::int64_t sum = batches_.bytes() + taus_.bytes();
    for (const Batch& batch : batches_)
        sum += batch.samples.bytes() + batch.stroke.bytes() + batch.tile_runs.bytes() + batch.part.bytes();
    return sum;
}

void HatchTiles::build(std::span<HatchPoints::Batch> batches, const drawing::Drawing& drawing) {
    const drawing::Tiles& tiles = drawing.dot_tiles;
    const glm::vec2 origin(drawing.first_pixel);
    runtime_.parallel.for_each(static_cast<std::int64_t>(batches.size()), [&](std::int64_t number) {
        HatchPoints::Batch& batch = batches[static_cast<std::size_t>(number)];
        base::Array<HatchDotRun>& runs = batch.tile_runs;
        runs.clear();
        for (std::int64_t i = batch.first_dot; i < batch.first_dot + batch.samples.sample.size(); ++i) {
            const Dot& dot = drawing.dots[i];
            const std::int64_t tile =
                tile_of(dot.y - origin.y, tiles.rows()) * tiles.columns() + tile_of(dot.x - origin.x, tiles.columns());
            if (runs.empty() || runs.back().tile != tile) runs.push_back({tile, i, i});
            runs.back().end = i + 1;
        }
    });
    // The count of a tile is stored in offsets_[tile + 2], and becomes a sum. The loop that fills `runs_` advances
    // offsets_[tile + 1]. So in the end, offsets_[tile] is the beginning of the tile.
    base::resize_scratch(offsets_, tiles.tiles() + 2);
    std::fill(offsets_.begin(), offsets_.end(), 0);
    for (const HatchPoints::Batch& batch : batches)
        for (const HatchDotRun& run : batch.tile_runs) ++offsets_[run.tile + 2];
    for (std::int64_t tile = 0; tile < tiles.tiles(); ++tile) offsets_[tile + 2] += offsets_[tile + 1];
    base::resize_scratch(runs_, offsets_[tiles.tiles() + 1]);
    for (const HatchPoints::Batch& batch : batches)
        for (const HatchDotRun& run : batch.tile_runs) runs_[offsets_[run.tile + 1]++] = run;
}

} // namespace hrbfnpr::frame
