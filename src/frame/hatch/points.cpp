// SPDX-License-Identifier: MIT
#include "frame/hatch/points.h"

#include "base/scratch.h"

#include <algorithm>

namespace hrbfnpr::frame {
namespace {

constexpr std::int64_t marks_of_batch = 4096;

[[nodiscard]] std::int64_t pieces_of(const marks::Layer& layer, std::int64_t stroke) noexcept {
    return marks::pieces_of(std::int64_t{layer.stroke_first[stroke + 1]} - layer.stroke_first[stroke]);
}

[[nodiscard]] bool asks(const Scene& scene, const Run& run) noexcept {
    return run.shape == Shape::hatch && scene.item_of(run).style.tone == Tone::callback;
}

} // namespace

void HatchPoints::add_batch(std::int32_t run, std::int64_t begin, std::int64_t end, std::int64_t piece) {
    if (count_ == batches_.size()) batches_.add(runtime_.memory);
    Batch& batch = batches_[count_++];
    batch.run = run;
    batch.begin = begin;
    batch.end = end;
    batch.piece = piece;
    batch.samples.clear();
}

void HatchPoints::add_batches(const Scene& scene) {
    count_ = 0;
    for (std::int64_t r = 0; r < scene.runs.size(); ++r) {
        if (scene.runs[r].shape != Shape::hatch) continue;
        const marks::Layer& layer = *scene.runs[r].marks;
        std::int64_t begin = 0;
        std::int64_t piece = 0;
        std::int64_t next_piece = 0;
        for (std::int64_t s = 1; s <= layer.strokes(); ++s) {
            next_piece += pieces_of(layer, s - 1);
            if (s < layer.strokes() && layer.stroke_first[s] - layer.stroke_first[begin] < marks_of_batch) continue;
            add_batch(static_cast<std::int32_t>(r), begin, s, piece);
            begin = s;
            piece = next_piece;
        }
    }
}

// Sorts tones by mark: clusters have marks in another order.
void HatchPoints::take_taus(const Seen& seen) {
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

void HatchPoints::find(const Seen& seen, Batch& batch) const {
    const Run& run = seen.scene.runs[batch.run];
    const HatchView view{see_, loops_, seen.scene, seen.frustum};
    const HatchMarks marks(view, run, seen.sights[static_cast<std::size_t>(run.item)],
                           asks(seen.scene, run) ? taus_.data() + run.first : nullptr);
    std::int64_t piece = batch.piece;
    for (std::int64_t s = batch.begin; s < batch.end; ++s) {
        if (marks.see(s, piece, batch.stroke)) sample_stroke(*run.style, s, batch.stroke, batch.samples);
        piece += pieces_of(*run.marks, s);
    }
}

void HatchPoints::put(const Scene& scene, const Batch& batch, drawing::Drawing& drawing) const noexcept {
    const auto layer = static_cast<std::uint32_t>(batch.run);
    const Run& run = scene.runs[batch.run];
    const auto flags = static_cast<std::uint8_t>((run.turned ? dot_faces_back : 0) |
                                                 (scene.item_of(run).model != nullptr ? dot_is_exact : 0));
    Dot* to = drawing.dots.data() + batch.first_dot;
    for (const HatchSample& p : batch.samples.sample)
        *to++ = {p.x,  p.y,   0.5F * p.width,   1.0F, p.depth, p.window, p.pixels_per_unit,
                 p.id, layer, MarkClass::front, flags};
}

void HatchPoints::run(const Seen& seen, drawing::Drawing& drawing) {
    add_batches(seen.scene);
    take_taus(seen);
    runtime_.parallel.for_each(count_, [&](std::int64_t i) { find(seen, batches_[i]); });
    std::int64_t dots = drawing.dots.size();
    for (Batch& batch : std::span(batches_.begin(), static_cast<std::size_t>(count_))) {
        batch.first_dot = dots;
        dots += batch.samples.sample.size();
        if (dots > batch.first_dot) drawing.dot_pieces.push_back({batch.first_dot, dots});
    }
    drawing.dots.resize_for_overwrite(dots);
    runtime_.parallel.for_each(count_, [&](std::int64_t i) { put(seen.scene, batches_[i], drawing); });
}

std::int64_t HatchPoints::bytes() const noexcept {
    std::int64_t sum = batches_.bytes() + taus_.bytes();
    for (const Batch& batch : batches_) sum += batch.samples.bytes() + batch.stroke.bytes();
    return sum;
}

void HatchTiles::cut(const HatchPoints::Batch& batch, const drawing::Drawing& drawing, base::Array<DotRun>& runs) {
    const drawing::Tiles& tiles = drawing.dot_tiles;
    const glm::vec2 origin(drawing.first_pixel);
    const std::int64_t end = batch.first_dot + batch.samples.sample.size();
    runs.clear();
    for (std::int64_t i = batch.first_dot; i < end; ++i) {
        const Dot& dot = drawing.dots[i];
        const std::int64_t tile =
            tile_of(dot.y - origin.y, tiles.rows()) * tiles.columns() + tile_of(dot.x - origin.x, tiles.columns());
        if (runs.empty() || runs.back().tile != tile) runs.push_back({tile, i, i});
        runs.back().end = i + 1;
    }
}

void HatchTiles::build(std::span<const HatchPoints::Batch> batches, const drawing::Drawing& drawing) {
    const auto count = static_cast<std::int64_t>(batches.size());
    while (parts_.size() < count) parts_.add(runtime_.memory);
    runtime_.parallel.for_each(
        count, [&](std::int64_t i) { cut(batches[static_cast<std::size_t>(i)], drawing, parts_[i].runs); });
    // Counts stand one place farther on, so that filling moves them back to where each tile begins.
    const std::int64_t tiles = drawing.dot_tiles.tiles();
    base::resize_scratch(offsets_, tiles + 2);
    std::fill(offsets_.begin(), offsets_.end(), 0);
    const std::span<const Part> parts(parts_.begin(), batches.size());
    for (const Part& part : parts)
        for (const DotRun& run : part.runs) ++offsets_[run.tile + 2];
    for (std::int64_t tile = 0; tile < tiles; ++tile) offsets_[tile + 2] += offsets_[tile + 1];
    base::resize_scratch(runs_, offsets_[tiles + 1]);
    for (const Part& part : parts)
        for (const DotRun& run : part.runs) runs_[offsets_[run.tile + 1]++] = run;
}

std::int64_t HatchTiles::bytes() const noexcept {
    std::int64_t sum = parts_.bytes() + offsets_.bytes() + runs_.bytes();
    for (const Part& part : parts_) sum += part.runs.bytes();
    return sum;
}

} // namespace hrbfnpr::frame
