// SPDX-License-Identifier: MIT
// Lines of hatching as dots, so that what hides them is found like for all other ink.
#pragma once

#include "base/list.h"
#include "frame/depth_layers/hatch_spans.h"

namespace hrbfnpr::frame {

class HatchPoints {
public:
    // Strokes that follow each other: the unit of work.  Threads fill batches that lie side by side.
    struct alignas(base::Memory::alignment) Batch {
        explicit Batch(base::Memory& memory) noexcept : part(memory), stroke(memory), spans(memory) {}

        std::int32_t run = 0;
        std::int64_t begin = 0, end = 0; // strokes
        std::int64_t piece = 0;          // the first of them
        std::int64_t first_dot = 0;      // of its points in the drawing
        HatchPart part;
        HatchStroke stroke; // one of them
        HatchSpans spans;
    };

    explicit HatchPoints(const base::Runtime& runtime) noexcept
        : runtime_(runtime), loops_(hatch_loops(runtime.instruction_set)), batches_(runtime.memory),
          taus_(runtime.memory) {}

    // Adds the points of all hatching to the drawing's dots, behind all others.  The drawing has been gathered.
    void run(const Scene& scene, const Gather& gather, drawing::Drawing& drawing);

    // Of the last run, in the order of the strokes.
    [[nodiscard]] std::span<const Batch> batches() const noexcept {
        return {batches_.begin(), static_cast<std::size_t>(count_)};
    }
    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void add_batches(const Scene& scene);
    void add_batch(std::int32_t run, std::int64_t begin, std::int64_t end, std::int64_t piece);
    void take_taus(const Scene& scene, const Gather& gather);
    void find(const Scene& scene, const Gather& gather, Batch& batch) const;
    void put(const Scene& scene, const Batch& batch, drawing::Drawing& drawing) const noexcept;

    const base::Runtime& runtime_;
    HatchLoops loops_;
    base::List<Batch> batches_; // more than `count_` where an earlier frame had more
    std::int64_t count_ = 0;
    base::Array<float> taus_; // of each mark of the scene, where callbacks give tones
};

} // namespace hrbfnpr::frame
