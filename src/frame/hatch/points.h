// SPDX-License-Identifier: MIT
// Samples of hatching as dots, so that depth layers hide them as they hide all other ink.
#pragma once

#include "base/list.h"
#include "drawing/drawing.h"
#include "frame/hatch/samples.h"

#include <algorithm>

namespace hrbfnpr::frame {

class HatchPoints {
public:
    // Strokes that follow each other: the unit of work.  Threads fill batches that lie side by side.
    struct alignas(base::Memory::alignment) Batch {
        explicit Batch(base::Memory& memory) noexcept : samples(memory), stroke(memory) {}

        std::int32_t run = 0;
        std::int64_t begin = 0, end = 0; // strokes
        std::int64_t piece = 0;          // the first of them
        std::int64_t first_dot = 0;      // its first sample in the drawing
        HatchSamples samples;
        HatchStroke stroke; // one of them
    };

    explicit HatchPoints(const base::Runtime& runtime) noexcept
        : runtime_(runtime), see_(see_loops(runtime.instruction_set)), loops_(hatch_loops(runtime.instruction_set)),
          batches_(runtime.memory), taus_(runtime.memory) {}

    // How the other marks of the frame are seen.
    struct Seen {
        const Scene& scene;
        std::span<const ItemSight> sights; // one for each item
        const Frustum& frustum;
        std::span<const float> taus; // tones that a callback gave, by the place of the mark
    };

    // Adds the samples of all hatching to the drawing's dots, after all others. The drawing has been gathered.
    void run(const Seen& seen, drawing::Drawing& drawing);

    // The batches of the last run, in the order of the strokes.
    [[nodiscard]] std::span<const Batch> batches() const noexcept {
        return {batches_.begin(), static_cast<std::size_t>(count_)};
    }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void add_batches(const Scene& scene);
    void add_batch(std::int32_t run, std::int64_t begin, std::int64_t end, std::int64_t piece);
    void take_taus(const Seen& seen);
    void find(const Seen& seen, Batch& batch) const;
    void put(const Scene& scene, const Batch& batch, drawing::Drawing& drawing) const noexcept;

    const base::Runtime& runtime_;
    SeeLoops see_;
    HatchLoops loops_;
    base::List<Batch> batches_; // more than `count_` where an earlier frame had more
    std::int64_t count_ = 0;
    base::Array<float> taus_; // the tone of each mark of the scene, where callbacks give tones
};

// The row or column of tiles that a place lies in or is nearest to. `count` is the number of rows or columns.
[[nodiscard]] inline std::int64_t tile_of(float at, std::int64_t count) noexcept {
    constexpr float scale = 1.0F / static_cast<float>(drawing::tile_size);
    return static_cast<std::int64_t>(std::clamp(at * scale, 0.0F, static_cast<float>(count - 1)));
}

// The points in each tile of a picture. Points follow each other along lines, so that many of them are one entry.
class HatchTiles {
public:
    explicit HatchTiles(const base::Runtime& runtime) noexcept
        : runtime_(runtime), parts_(runtime.memory), offsets_(runtime.memory), runs_(runtime.memory) {}

    // Each point belongs to one tile, which Tiles::own_extent() of the drawing's dots gives.
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
    base::Array<std::int64_t> offsets_; // the first run of each tile, and the end
    base::Array<DotRun> runs_;
};

} // namespace hrbfnpr::frame
