// SPDX-License-Identifier: MIT
// Even samples along the lines of hatching in the picture, whatever the distance of the marks.
#pragma once

#include "frame/hatch/marks.h"

#include <cstddef>

namespace hrbfnpr::frame {

// A sample has the numbers of a mark at the same places, so that all of them are interpolated at once.
struct HatchSample {
    float x, y, window, depth;
    float side_x, side_y;                    // as in HatchMark
    float width;                             // the line's, pixels: the mean over half a step to either side
    float overshoot;                         // pixels by which a hand goes on beyond the tone that the line ends at
    std::array<float, hatch_margins> margin; // as in HatchMark
    float pixels_per_unit;
    std::array<float, 2> unused;
    std::uint32_t id; // the nearest mark's

    // In the picture, of any length: across a contour that would be here.
    [[nodiscard]] glm::vec2 across_rim() const noexcept { return {side_x, -side_y}; }
};
static_assert(sizeof(HatchSample) == sizeof(HatchMark) &&
              offsetof(HatchSample, margin) == offsetof(HatchMark, margin) &&
              offsetof(HatchSample, side_x) == offsetof(HatchMark, side_x) &&
              offsetof(HatchSample, pixels_per_unit) == offsetof(HatchMark, pixels_per_unit));

// Samples that follow each other at even steps. A stroke has several chains where marks between them were left out.
struct HatchChain {
    std::int64_t first = 0; // its first sample
    std::int64_t count = 0; // 2 and more; the last sample of a ring is its first one
    bool ring = false;
    bool has_begin = false, has_end = false; // the stroke begins at its first sample; ends at its last one
    StrokeEnd begins = StrokeEnd::open, ends = StrokeEnd::open;
};

struct HatchSamples {
    explicit HatchSamples(base::Memory& memory) noexcept
        : chain(memory), sample(memory), length(memory), area(memory), tangent(memory), at(memory), ends(memory) {}

    base::Array<HatchChain> chain;
    base::Array<HatchSample> sample;

    // Scratch: the way to each mark of a chain from its first one, pixels; the area of the line up to there; and the
    // curve's tangent there, of unit length where marks lie evenly.
    base::Array<float> length, area;
    base::Array<glm::vec2> tangent;
    base::Array<float> at;          // lengths at which a chain is sampled
    base::Array<std::uint8_t> ends; // a bit for each margin that is 0 there

    void clear() noexcept {
        chain.clear();
        sample.clear();
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return chain.bytes() + sample.bytes() + length.bytes() + area.bytes() + tangent.bytes() + at.bytes() +
               ends.bytes();
    }
};

// Appends the chains of a stroke of that number.
void sample_stroke(const LayerStyle& style, std::int64_t number, const HatchStroke& stroke, HatchSamples& to);

} // namespace hrbfnpr::frame
