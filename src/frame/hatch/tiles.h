// SPDX-License-Identifier: MIT
// Which points of hatching lie in each tile of a picture.  They follow each other along lines, so that many of them are
// one entry.
#pragma once

#include "frame/hatch/points.h"

#include <algorithm>

namespace hrbfnpr::frame {

// The row or column of tiles that a place lies in or is nearest to. `count` is the number of rows or columns.
[[nodiscard]] inline std::int64_t tile_of(float at, std::int64_t count) noexcept {
    constexpr float scale = 1.0F / static_cast<float>(drawing::tile_size);
    return static_cast<std::int64_t>(std::clamp(at * scale, 0.0F, static_cast<float>(count - 1)));
}

class HatchTiles {
public:
    explicit HatchTiles(const base::Runtime& runtime) noexcept
        : runtime_(runtime), parts_(runtime.memory), offsets_(runtime.memory), runs_(runtime.memory) {}

    // Each point belongs to one tile, that which Tiles::own_extent() of the drawing's dots says.
    void build(std::span<const HatchPoints::Batch> batches, const drawing::Drawing& drawing);

    // Calls f(number) for the tile's dots, in ascending order.
    template <class F>
    void for_tile(std::int64_t tile, const F& f) const {
        for (std::int64_t i = offsets_[tile]; i < offsets_[tile + 1]; ++i)
            for (std::int64_t dot = runs_[i].begin; dot < runs_[i].end; ++dot) f(dot);
    }

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    // Dots that follow each other.
    struct DotRun {
        std::int64_t tile, begin, end;
    };

    // The runs of one batch. Each thread fills a part of its own.
    struct alignas(base::Memory::alignment) Part {
        explicit Part(base::Memory& memory) noexcept : runs(memory) {}
        base::Array<DotRun> runs;
    };

    static void cut(const HatchPoints::Batch& batch, const drawing::Drawing& drawing, base::Array<DotRun>& runs);

    const base::Runtime& runtime_;
    base::List<Part> parts_;
    base::Array<std::int64_t> offsets_; // of each tile's runs, and the end
    base::Array<DotRun> runs_;
};

} // namespace hrbfnpr::frame
