// SPDX-License-Identifier: MIT
// Lines of hatching as dots, so that what hides them is found like for all other ink.
#pragma once

#include "base/list.h"
#include "frame/hatch/samples.h"

namespace hrbfnpr::frame {

class HatchPoints {
public:
    // Strokes that follow each other: the unit of work.  Threads fill batches that lie side by side.
    struct alignas(base::Memory::alignment) Batch {
        explicit Batch(base::Memory& memory) noexcept : samples(memory), stroke(memory) {}

        std::int32_t run = 0;
        std::int64_t begin = 0, end = 0; // strokes
        std::int64_t piece = 0;          // the first of them
        std::int64_t first_dot = 0;      // of its samples in the drawing
        HatchSamples samples;
        HatchStroke stroke; // one of them
    };

    explicit HatchPoints(const base::Runtime& runtime) noexcept
        : runtime_(runtime), see_(see_loops(runtime.instruction_set)), loops_(hatch_loops(runtime.instruction_set)),
          batches_(runtime.memory), taus_(runtime.memory) {}

    // What the other marks of the frame are seen by.
    struct Seen {
        const Scene& scene;
        std::span<const ItemSight> sights; // of each item
        const Frustum& frustum;
        std::span<const float> taus; // of the marks whose tone is a callback's, by place
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
    base::Array<float> taus_; // of each mark of the scene, where callbacks give tones
};

} // namespace hrbfnpr::frame
