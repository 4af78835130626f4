#include "frame/tile_bins.h"

namespace hrbfnpr::frame {

void TileBins::number(std::span<const Piece> pieces) {
    resize_scratch(pieces_, static_cast<std::int64_t>(pieces.size()));
    resize_scratch(starts_, static_cast<std::int64_t>(pieces.size()) + 1);
    total_ = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        pieces_[static_cast<std::int64_t>(p)] = pieces[p];
        starts_[static_cast<std::int64_t>(p)] = total_;
        total_ += pieces[p].end - pieces[p].begin;
    }
    starts_[pieces_.size()] = total_;
}

void TileBins::distribute(const base::Parallel& parallel) {
    // At most 16 parts: each keeps a count for each tile.
    const std::int64_t grain = std::max(measure_grain, (total_ + 15) / 16);
    const std::int64_t parts = (total_ + grain - 1) / grain;
    counts_.clear();
    counts_.resize(parts * tiles());
    const auto each_tile = [&](std::int64_t begin, std::int64_t end, auto&& f) {
        for_each_disc(begin, end, [&](std::int64_t number, std::int64_t disc) {
            const Rect& rect = rects_[number];
            if (rect.tiles() > most_tiles_of_one) return;
            for (std::int64_t row = rect.top; row < rect.bottom; ++row) {
                for (std::int64_t column = rect.left; column < rect.right; ++column)
                    f(begin / grain * tiles() + row * columns_ + column, disc);
            }
        });
    };
    parallel.for_chunks(total_, grain, [&](std::int64_t begin, std::int64_t end) {
        each_tile(begin, end, [&](std::int64_t cell, std::int64_t) { ++counts_[cell]; });
    });

    // From counts to the place of each part's first entry, relative to its tile's.
    resize_scratch(offsets_, tiles() + 1);
    std::int64_t total = 0;
    for (std::int64_t tile = 0; tile < tiles(); ++tile) {
        offsets_[tile] = total;
        for (std::int64_t part = 0; part < parts; ++part) {
            const std::uint32_t here = counts_[part * tiles() + tile];
            counts_[part * tiles() + tile] = static_cast<std::uint32_t>(total - offsets_[tile]);
            total += here;
        }
    }
    offsets_[tiles()] = total;
    resize_scratch(entries_, total);
    parallel.for_chunks(total_, grain, [&](std::int64_t begin, std::int64_t end) {
        const std::int64_t part = begin / grain * tiles();
        each_tile(begin, end, [&](std::int64_t cell, std::int64_t disc) {
            entries_[offsets_[cell - part] + counts_[cell]++] = static_cast<std::uint32_t>(disc);
        });
    });
    large_.clear();
    for_each_disc(0, total_, [&](std::int64_t number, std::int64_t disc) {
        if (rects_[number].tiles() > most_tiles_of_one)
            large_.push_back({static_cast<std::uint32_t>(disc), rects_[number]});
    });
}

} // namespace hrbfnpr::frame
