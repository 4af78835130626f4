// SPDX-License-Identifier: MIT
// Finds the discs that touch each square tile of a picture. Each tile lists its discs in ascending order.
#pragma once

#include "base/assert.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "base/scratch.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>

namespace hrbfnpr::drawing {

// A range of consecutive elements, in an array with gaps.
struct IndexRange {
    std::int64_t begin = 0, end = 0;
};

// The side of a tile, in pixels.
inline constexpr std::int32_t tile_size = 64;

// Sorts discs into tiles. The discs are divided into fixed parts that are counted and stored separately, so the result
// does not depend on the number of threads. Discs that touch very many tiles are in one list that is searched for every
// tile. This bounds memory.
class Tiles {
public:
    // A rectangle in pixels of the picture. A rectangle with NaN touches no tile.
    struct Footprint {
        float left, top, right, bottom;
        [[nodiscard]] static Footprint of_disc(float x, float y, float radius) noexcept {
            return {x - radius, y - radius, x + radius, y + radius};
        }
    };

    Tiles(base::Memory& memory, std::int32_t tile_size) noexcept
        : tile_size_(tile_size), rects_(memory), counts_(memory), offsets_(memory), entries_(memory), large_(memory),
          ranges_(memory), starts_(memory) {}

    // Fills the tiles with the elements i of the ranges, which must be in ascending order. footprint(i, out) is called
    // once for each element. It returns false to omit the element.
    template <class F>
    void build(const base::Parallel& parallel, std::int32_t width, std::int32_t height,
               std::span<const IndexRange> ranges, const F& footprint) {
        columns_ = (width + tile_size_ - 1) / tile_size_;
        rows_ = (height + tile_size_ - 1) / tile_size_;
        HRBFNPR_ASSERT(width >= 0 && height >= 0);
        ranges_.clear();
        starts_.clear();
        total_ = 0;
        for (const IndexRange& range : ranges) {
            HRBFNPR_ASSERT(range.begin <= range.end && (ranges_.empty() || range.begin >= ranges_.back().end));
            ranges_.push_back(range);
            starts_.push_back(total_);
            total_ += range.end - range.begin;
        }
        starts_.push_back(total_);
        base::resize_scratch(rects_, total_);
        grain_ = std::max(least_grain, (total_ + most_parts - 1) / most_parts);
        base::resize_scratch(counts_, (total_ + grain_ - 1) / grain_ * tiles());
        std::atomic<bool> any_large{false};
        parallel.for_chunks(total_, grain_, [&](std::int64_t begin, std::int64_t end) {
            std::uint32_t* const counts = counts_.data() + begin / grain_ * tiles();
            std::fill_n(counts, tiles(), 0U);
            for_each_disc(begin, end, [&](std::int64_t number, std::int64_t i) {
                Footprint print{};
                rects_[number] = footprint(i, print) ? rect_of(print) : Rect{};
                if (rects_[number].tiles() > most_tiles_of_one) any_large.store(true, std::memory_order_relaxed);
                for_tiles(rects_[number], [counts](std::int64_t tile) { ++counts[tile]; });
            });
        });
        distribute(parallel);
        large_.clear();
        if (!any_large) return;
        for_each_disc(0, total_, [&](std::int64_t number, std::int64_t disc) {
            if (rects_[number].tiles() > most_tiles_of_one)
                large_.push_back({static_cast<std::uint32_t>(disc), rects_[number]});
        });
    }

    [[nodiscard]] std::int32_t tile_size() const noexcept { return tile_size_; }
    [[nodiscard]] std::int32_t columns() const noexcept { return columns_; }
    [[nodiscard]] std::int32_t rows() const noexcept { return rows_; }
    [[nodiscard]] std::int64_t tiles() const noexcept { return std::int64_t{columns_} * rows_; }
    // Returns an upper bound for the number of discs in a tile. It is exact if no disc touches very many tiles.
    [[nodiscard]] std::int64_t count(std::int64_t tile) const noexcept {
        return offsets_[tile + 1] - offsets_[tile] + large_.size();
    }
    // Returns whether certainly no disc touches a tile.
    [[nodiscard]] bool is_empty(std::int64_t tile) const noexcept {
        return large_.empty() && offsets_[tile] == offsets_[tile + 1];
    }
    // Returns an upper bound for the number of discs in a tile.
    [[nodiscard]] std::int64_t largest_tile_count() const noexcept {
        std::int64_t most = 0;
        for (std::int64_t tile = 0; tile < tiles(); ++tile)
            most = std::max<std::int64_t>(most, offsets_[tile + 1] - offsets_[tile]);
        return most + large_.size();
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return rects_.bytes() + counts_.bytes() + offsets_.bytes() + entries_.bytes() + large_.bytes() +
               ranges_.bytes() + starts_.bytes();
    }

    // Sorts the discs of each tile by `before` instead of by their indices.
    template <class Before>
    void order(const base::Parallel& parallel, const Before& before) {
        parallel.for_each(tiles(), [&](std::int64_t tile) {
            std::sort(entries_.data() + offsets_[tile], entries_.data() + offsets_[tile + 1], before);
        });
        std::sort(large_.begin(), large_.end(),
                  [&](const LargeDisc& a, const LargeDisc& b) { return before(a.disc, b.disc); });
    }
    // The places that belong to a tile: all places in the tile. A tile at the border of the picture also has the places
    // outside the picture on that side.
    struct Extent {
        float left, top, right, bottom;
        [[nodiscard]] bool holds(float x, float y) const noexcept {
            return x >= left && x < right && y >= top && y < bottom;
        }
    };
    [[nodiscard]] Extent own_extent(std::int64_t tile) const noexcept {
        constexpr float far = std::numeric_limits<float>::infinity();
        const std::int64_t column = tile % columns_;
        const std::int64_t row = tile / columns_;
        const auto edge = [&](std::int64_t at, std::int64_t count) {
            return at <= 0 ? -far : at >= count ? far : static_cast<float>(at * tile_size_);
        };
        return {edge(column, columns_), edge(row, rows_), edge(column + 1, columns_), edge(row + 1, rows_)};
    }

    // Calls f(disc) for each disc that touches the tile, in ascending order. After a call of order(), `before` must be
    // the same as in that call.
    template <class F, class Before = std::less<>>
    void for_tile(std::int64_t tile, F&& f, const Before& before = {}) const {
        for_spans(
            tile,
            [&](std::span<const std::uint32_t> discs) {
                for (const std::uint32_t disc : discs) f(disc);
            },
            before);
    }

    // Calls f(discs) with several spans, which together contain the discs of for_tile() in the same order.
    template <class F, class Before = std::less<>>
    void for_spans(std::int64_t tile, F&& f, const Before& before = {}) const {
        const auto column = static_cast<std::uint16_t>(tile % columns_);
        const auto row = static_cast<std::uint16_t>(tile / columns_);
        const std::uint32_t* own = entries_.data() + offsets_[tile];
        const std::uint32_t* const own_end = entries_.data() + offsets_[tile + 1];
        for (const LargeDisc& large : large_) {
            const Rect& rect = large.rect;
            if (column < rect.left || column >= rect.right || row < rect.top || row >= rect.bottom) continue;
            const std::uint32_t* const stop =
                std::partition_point(own, own_end, [&](std::uint32_t disc) { return before(disc, large.disc); });
            if (stop != own) f(std::span(own, stop));
            own = stop;
            f(std::span(&large.disc, 1));
        }
        if (own != own_end) f(std::span(own, own_end));
    }

private:
    static constexpr std::int64_t least_grain = 8192; // the smallest number of discs in a part
    // The largest number of parts. It is small, because each part has a counter for each tile.
    static constexpr std::int64_t most_parts = 16;
    static constexpr std::int64_t most_tiles_of_one = 64;

    // A half-open range of columns and rows of tiles. By default it is empty.
    struct Rect {
        std::uint16_t left = 0, top = 0, right = 0, bottom = 0;
        [[nodiscard]] std::int64_t tiles() const noexcept {
            return std::int64_t{right - left} * std::int64_t{bottom - top};
        }
    };
    struct LargeDisc {
        std::uint32_t disc;
        Rect rect;
    };

    [[nodiscard]] Rect rect_of(const Footprint& print) const noexcept {
        if (!(print.left <= print.right && print.top <= print.bottom)) return {};
        // Coordinates are clamped as floats, because they may exceed the range of every integer type.
        const float scale = 1.0F / static_cast<float>(tile_size_);
        const auto cell = [scale](float at, std::int32_t limit) {
            return static_cast<std::int32_t>(std::clamp(at * scale + 1.0F, 0.0F, static_cast<float>(limit + 1))) - 1;
        };
        const std::int32_t left = std::max(cell(print.left, columns_), 0);
        const std::int32_t right = std::min(cell(print.right, columns_), columns_ - 1) + 1;
        const std::int32_t top = std::max(cell(print.top, rows_), 0);
        const std::int32_t bottom = std::min(cell(print.bottom, rows_), rows_ - 1) + 1;
        if (left >= right || top >= bottom) return {};
        return {static_cast<std::uint16_t>(left), static_cast<std::uint16_t>(top), static_cast<std::uint16_t>(right),
                static_cast<std::uint16_t>(bottom)};
    }

    // Calls f(number, disc) for the discs with the numbers `begin` to end - 1. `number` counts the discs of all ranges
    // from 0; `disc` is the index of the disc.
    template <class F>
    void for_each_disc(std::int64_t begin, std::int64_t end, F&& f) const {
        const std::int64_t* const after = std::upper_bound(starts_.begin(), starts_.end(), begin);
        for (std::int64_t p = after - starts_.begin() - 1; begin < end; ++p) {
            const std::int64_t stop = std::min(end, starts_[p + 1]);
            const std::int64_t shift = ranges_[p].begin - starts_[p];
            for (; begin < stop; ++begin) f(begin, begin + shift);
        }
    }

    // Calls f(tile) for each tile that a disc touches, if the disc is not in the list of large discs.
    template <class F>
    void for_tiles(const Rect& rect, F&& f) const {
        if (rect.tiles() > most_tiles_of_one) return;
        for (std::int64_t row = rect.top; row < rect.bottom; ++row) {
            for (std::int64_t column = rect.left; column < rect.right; ++column) f(row * columns_ + column);
        }
    }

    // Stores the discs in the tiles. The parts must have been counted.
    void distribute(const base::Parallel& parallel) {
        // Replaces each count by the index where the part's first entry is stored, relative to the tile's first entry.
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

    std::int32_t tile_size_;
    std::int32_t columns_ = 0;
    std::int32_t rows_ = 0;
    std::int64_t total_ = 0;
    std::int64_t grain_ = 1;            // number of discs in each part
    base::Array<Rect> rects_;           // for each disc, the range of tiles that it touches
    base::Array<std::uint32_t> counts_; // for each part, the number of its discs in each tile
    // For each tile, the index of its first entry; the last element is the number of entries.
    base::Array<std::int64_t> offsets_;
    base::Array<std::uint32_t> entries_; // the discs of all tiles, tile by tile
    base::Array<LargeDisc> large_;       // discs that touch too many tiles; they are not in `entries_`
    base::Array<IndexRange> ranges_;
    // For each range, the number of discs in earlier ranges; the last element is the number of all discs.
    base::Array<std::int64_t> starts_;
};

} // namespace hrbfnpr::drawing
