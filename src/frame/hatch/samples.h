// SPDX-License-Identifier: MIT
// Even samples along the lines of hatching in the picture, whatever the distance of the marks.
#pragma once

#include "frame/hatch/hand.h"
#include "frame/hatch/marks.h"

namespace hrbfnpr::frame {

struct HatchSample {
    float x, y, window, depth, pixels_per_unit;
    float width;                             // of the line, pixels: the mean over the steps on either side
    std::array<float, hatch_margins> margin; // of HatchMark
    glm::vec2 across_rim;                    // in the picture, of any length: across a contour that would be here
    float overshoot;                         // pixels by which a hand goes on beyond the tone that the line ends at
    std::uint32_t id;                        // of the nearest mark
};

// Samples that follow each other at even steps. A stroke has several chains where marks between them were left out.
struct HatchChain {
    std::int64_t first = 0; // of its samples
    std::int64_t count = 0; // 2 and more; the last sample of a ring is its first one
    bool ring = false;
    bool has_begin = false, has_end = false; // the stroke begins at its first sample; ends at its last one
    StrokeEnd begins = StrokeEnd::open, ends = StrokeEnd::open;
};

struct HatchSamples {
    explicit HatchSamples(base::Memory& memory) noexcept
        : chain(memory), sample(memory), length(memory), area(memory), at(memory), ends(memory) {}

    base::Array<HatchChain> chain;
    base::Array<HatchSample> sample;

    // Scratch: of each mark of a chain from its first one, pixels, and the area of the line up to there.
    base::Array<float> length, area;
    base::Array<float> at;          // lengths at which a chain is sampled
    base::Array<std::uint8_t> ends; // a bit for each margin that is 0 there

    void clear() noexcept {
        chain.clear();
        sample.clear();
    }
    [[nodiscard]] std::int64_t bytes() const noexcept {
        return chain.bytes() + sample.bytes() + length.bytes() + area.bytes() + at.bytes() + ends.bytes();
    }
};

// Appends the chains of a stroke of that number.
void sample_stroke(const LayerStyle& style, std::int64_t number, const HatchStroke& stroke, HatchSamples& to);

} // namespace hrbfnpr::frame
