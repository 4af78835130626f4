// SPDX-License-Identifier: MIT
// From samples along lines of hatching, of which it is known what hides them, to strokes.
//
// 1. Each reason for a line to end has a presence along it (presence.h): its tone, its level, the rim, the picture, and
//    what hides it. Hidden parts begin and end exactly where the edges of what hides them are (cuts.h).
// 2. Short gaps of tone and level, and short hidden ones, are closed.
// 3. The line is present where all of these are; parts with too little ink are left out.
// 4. The line's width is that of its samples times the presence, and narrows towards each end as the reason for it
// asks.
#pragma once

#include "frame/hatch/cuts.h"
#include "frame/hatch/points.h"

namespace hrbfnpr::frame {

// What becomes of one batch of samples. Threads fill parts that lie side by side.
struct alignas(base::Memory::alignment) HatchStrokePart {
    explicit HatchStrokePart(base::Memory& memory) noexcept
        : made(memory), length(memory), cuts(memory), row(memory), near(memory), raw(memory) {}

    LineStrokes made;
    std::int64_t seen = 0;              // dots
    std::int64_t shown = 0, hidden = 0; // marks

    // Scratch.
    base::Array<float> length; // of each sample of a chain from its first one, pixels
    base::Array<HatchCut> cuts;
    base::Array<float> row;         // presences of a chain
    base::Array<std::uint8_t> near; // of each sample, a bit for each reason by which the line ends or fades near it
    base::Array<drawing::StrokePoint> raw; // of a stroke, before its points are chosen

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return made.strokes.bytes() + made.points.bytes() + length.bytes() + cuts.bytes() + row.bytes() + near.bytes() +
               raw.bytes();
    }
};

class HatchStrokes {
public:
    explicit HatchStrokes(const base::Runtime& runtime) noexcept : runtime_(runtime), parts_(runtime.memory) {}

    // Makes the strokes of each batch. Its dots are not drawn any more, and the drawing's counts, where they were taken
    // for marks, are corrected.
    std::span<const HatchStrokePart> run(const Scene& scene, const HatchPoints& points, const Hiding& hiding,
                                         drawing::Drawing& drawing);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    const base::Runtime& runtime_;
    base::List<HatchStrokePart> parts_;
};

} // namespace hrbfnpr::frame
