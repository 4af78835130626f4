#include "frame/tile_bins.h"

namespace hrbfnpr::frame {

void TileBins::distribute(const base::Parallel& parallel) {
    // At most 16 chunks: each keeps a count for each tile.
    const std::int64_t count = rects_.size();
    const std::int64_t grain = std::max(measure_grain, (count + 15) / 16);
    const std::int64_t chunks = (count + grain - 1) / grain;
    counts_.clear();
    counts_.resize(chunks * tiles());
    const auto each_tile = [&](std::int64_t begin, std::int64_t end, auto&& f) {
        for (std::int64_t i = begin; i < end; ++i) {
            const Rect& rect = rects_[i];
            if (rect.tiles() > most_tiles_of_one) continue;
            for (std::int64_t row = rect.top; row < rect.bottom; ++row) {
                for (std::int64_t column = rect.left; column < rect.right; ++column)
                    f(begin / grain * tiles() + row * columns_ + column, i);
            }
        }
    };
    parallel.for_chunks(count, grain, [&](std::int64_t begin, std::int64_t end) {
        each_tile(begin, end, [&](std::int64_t cell, std::int64_t) { ++counts_[cell]; });
    });

    // From counts to the place of each chunk's first entry, relative to its tile's.
    resize_scratch(offsets_, tiles() + 1);
    std::int64_t total = 0;
    for (std::int64_t tile = 0; tile < tiles(); ++tile) {
        offsets_[tile] = total;
        std::uint32_t in_tile = 0;
        for (std::int64_t chunk = 0; chunk < chunks; ++chunk) {
            const std::uint32_t here = counts_[chunk * tiles() + tile];
            counts_[chunk * tiles() + tile] = in_tile;
            in_tile += here;
        }
        total += in_tile;
    }
    offsets_[tiles()] = total;
    resize_scratch(entries_, total);
    parallel.for_chunks(count, grain, [&](std::int64_t begin, std::int64_t end) {
        each_tile(begin, end, [&](std::int64_t cell, std::int64_t i) {
            entries_[offsets_[cell % tiles()] + counts_[cell]++] = static_cast<std::uint32_t>(i);
        });
    });
    large_.clear();
    for (std::int64_t i = 0; i < count; ++i) {
        if (rects_[i].tiles() > most_tiles_of_one) large_.push_back(static_cast<std::uint32_t>(i));
    }
}

} // namespace hrbfnpr::frame
