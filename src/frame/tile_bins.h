// Which discs touch which square tile of a picture, each tile's in the order of the discs.
#pragma once

#include "base/memory.h"
#include "base/parallel.h"
#include "frame/scratch.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hrbfnpr::frame {

// The same bins for any thread count: counted and filled in chunks of the discs.  Discs over
// very many tiles stand in one list that every tile looks through, so that memory is bounded.
class TileBins {
public:
    static constexpr std::int32_t tile_size = 32; // pixels: a tile of float RGBA fits the first-level cache

    // A round footprint in pixels of the binned picture.
    struct Footprint {
        float x, y, radius;
    };

    explicit TileBins(base::Memory& memory) noexcept
        : rects_(memory), counts_(memory), offsets_(memory), entries_(memory), large_(memory) {}

    // footprint(i, out) returns false for what is not to be binned; it is asked once for each i < count.
    template <class F>
    void build(const base::Parallel& parallel, std::int32_t width, std::int32_t height, std::int64_t count,
               const F& footprint) {
        columns_ = (width + tile_size - 1) / tile_size;
        rows_ = (height + tile_size - 1) / tile_size;
        resize_scratch(rects_, count);
        parallel.for_chunks(count, measure_grain, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) {
                Footprint print{};
                rects_[i] = footprint(i, print) ? rect_of(print) : Rect{};
            }
        });
        distribute(parallel);
    }

    [[nodiscard]] std::int32_t columns() const noexcept { return columns_; }
    [[nodiscard]] std::int32_t rows() const noexcept { return rows_; }
    [[nodiscard]] std::int64_t tiles() const noexcept { return std::int64_t{columns_} * rows_; }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return rects_.bytes() + counts_.bytes() + offsets_.bytes() + entries_.bytes() + large_.bytes();
    }

    // Calls f(disc) for the discs that touch the tile, in ascending order.
    template <class F>
    void for_tile(std::int64_t tile, F&& f) const {
        const auto column = static_cast<std::uint16_t>(tile % columns_);
        const auto row = static_cast<std::uint16_t>(tile / columns_);
        const std::uint32_t* own = entries_.data() + offsets_[tile];
        const std::uint32_t* const own_end = entries_.data() + offsets_[tile + 1];
        for (const std::uint32_t large : large_) {
            const Rect& rect = rects_[large];
            if (column < rect.left || column >= rect.right || row < rect.top || row >= rect.bottom) continue;
            while (own != own_end && *own < large) f(*own++);
            f(large);
        }
        while (own != own_end) f(*own++);
    }

private:
    static constexpr std::int64_t measure_grain = 8192;
    static constexpr std::int64_t most_tiles_of_one = 64;

    // Half-open, in tiles; empty by default.
    struct Rect {
        std::uint16_t left = 0, top = 0, right = 0, bottom = 0;
        [[nodiscard]] std::int64_t tiles() const noexcept {
            return std::int64_t{right - left} * std::int64_t{bottom - top};
        }
    };

    [[nodiscard]] Rect rect_of(const Footprint& print) const noexcept {
        // Clamped as floats: radii may be larger than any integer, or not numbers at all.
        const auto cell = [](float at, std::int32_t limit) {
            const float t = std::floor(at / static_cast<float>(tile_size));
            return static_cast<std::int32_t>(std::clamp(t, -1.0F, static_cast<float>(limit)));
        };
        if (!(print.radius >= 0.0F) || !std::isfinite(print.x) || !std::isfinite(print.y)) return {};
        const std::int32_t left = std::max(cell(print.x - print.radius, columns_), 0);
        const std::int32_t right = std::min(cell(print.x + print.radius, columns_), columns_ - 1) + 1;
        const std::int32_t top = std::max(cell(print.y - print.radius, rows_), 0);
        const std::int32_t bottom = std::min(cell(print.y + print.radius, rows_), rows_ - 1) + 1;
        if (left >= right || top >= bottom) return {};
        return {static_cast<std::uint16_t>(left), static_cast<std::uint16_t>(top), static_cast<std::uint16_t>(right),
                static_cast<std::uint16_t>(bottom)};
    }

    void distribute(const base::Parallel& parallel);

    std::int32_t columns_ = 0;
    std::int32_t rows_ = 0;
    base::Array<Rect> rects_;            // of each disc
    base::Array<std::uint32_t> counts_;  // chunk by chunk, for each tile
    base::Array<std::int64_t> offsets_;  // of each tile's entries, and the end
    base::Array<std::uint32_t> entries_; // discs
    base::Array<std::uint32_t> large_;   // discs that are in no tile's entries
};

} // namespace hrbfnpr::frame
