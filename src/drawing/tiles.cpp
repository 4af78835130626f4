// SPDX-License-Identifier: MIT
#include "drawing/tiles.h"

namespace hrbfnpr::drawing {

void Tiles::number(std::span<const Piece> pieces) {
    base::resize_scratch(pieces_, static_cast<std::int64_t>(pieces.size()));
    base::resize_scratch(starts_, static_cast<std::int64_t>(pieces.size()) + 1);
    total_ = 0;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        pieces_[static_cast<std::int64_t>(p)] = pieces[p];
        starts_[static_cast<std::int64_t>(p)] = total_;
        total_ += pieces[p].end - pieces[p].begin;
    }
    starts_[pieces_.size()] = total_;
}

void Tiles::distribute(const base::Parallel& parallel) {
    // From counts to the place of each part's first entry, relative to its tile's.
    const std::int64_t parts = (total_ + grain_ - 1) / grain_;
    base::resize_scratch(offsets_, tiles() + 1);
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
    base::resize_scratch(entries_, total);
    parallel.for_chunks(total_, grain_, [&](std::int64_t begin, std::int64_t end) {
        std::uint32_t* const counts = counts_.data() + begin / grain_ * tiles();
        for_each_disc(begin, end, [&](std::int64_t number, std::int64_t disc) {
            for_tiles(rects_[number], [&](std::int64_t tile) {
                entries_[offsets_[tile] + counts[tile]++] = static_cast<std::uint32_t>(disc);
            });
        });
    });
}

void Tiles::list_large() {
    for_each_disc(0, total_, [&](std::int64_t number, std::int64_t disc) {
        if (rects_[number].tiles() > most_tiles_of_one)
            large_.push_back({static_cast<std::uint32_t>(disc), rects_[number]});
    });
}

} // namespace hrbfnpr::drawing
