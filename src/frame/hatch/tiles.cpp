// SPDX-License-Identifier: MIT
#include "frame/hatch/tiles.h"

#include "base/scratch.h"

#include <algorithm>

namespace hrbfnpr::frame {
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
    // Counted one place farther on, where filling moves them back from.
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
