// SPDX-License-Identifier: MIT
// Finds where the line of a stroke is drawn, and its width, from the marks. It uses vectors of the processor, and all
// instruction sets give the same bits.
#pragma once

#include "frame/scene/projection_loops.h"
#include "frame/scene/style.h"

#include <cstdint>

namespace hrbfnpr::frame {

// The rows of numbers for a stroke. Each row has one number for each mark.
enum class HatchRow : std::int64_t {
    x, // position in the space of the point set, in its unit
    y,
    z,
    normal_x,
    normal_y,
    normal_z,
    tone_x, // the normals for tone, if the set has separate ones
    tone_y,
    tone_z,
    level,
    gap,  // the factor by which the distance of lines around the mark is larger than requested
    left, // position in the picture, in pixels
    top,
    window,
    depth,
    pixels_per_unit,
    nu,
    side_x,
    side_y,
    distance,
    darkness, // first n . l, later the darkness
    width,    // line width in pixels
    // distance from the previous mark, in pixels; 0 if one of the two marks has no position in the picture
    distance_before,
    tone_margin, // The line is drawn where none of the four margins is negative.
    level_margin,
    rim_margin,
    picture_margin,  // hatch_nowhere if the mark has no position in the picture
    least_margin,    // the smallest of the four margins
    greatest_nearby, // the largest `least_margin` of the mark and of two marks on either side
    rows
};

inline constexpr float hatch_nowhere = -1e30F;
// A mark counts as having no position if it is farther than this outside the picture, in pixels, or if its line is
// wider than this.
inline constexpr float hatch_farthest = 1e6F;

// Rows of numbers. `slack` elements beyond their ends may be read and written.
struct HatchRows {
    static constexpr std::int64_t slack = 16;

    float* first = nullptr; // the element for the first mark in the first row
    std::int64_t stride = 0;

    [[nodiscard]] float* operator[](HatchRow row) const noexcept {
        return first + static_cast<std::int64_t>(row) * stride;
    }
    [[nodiscard]] HatchRows from(std::int64_t mark) const noexcept { return {first + mark, stride}; }
};

// The numbers of the view that determine how marks look.
struct HatchSight {
    const ViewTransform* view_transform;
    float separation;               // the distance of lines of level 0 on the surface; 0 if not known
    float left, top, right, bottom; // the sides of the picture, in pixels
    float beyond;                   // the width of the strip around the picture that counts as inside, in pixels
};

// The widths of the lines of each level. Together, the lines cover a share of the paper that grows with the darkness.
// [Winkenbach & Salesin 1994, "Computer-generated pen-and-ink illustration"; Praun et al. 2001, "Real-time hatching":
// lines of a lighter tone are also in a darker tone]
struct HatchWidthLaw {
    const LayerStyle* style;
    float levels;
    float per_tone_span, per_fade, per_spacing, per_pen; // reciprocals; per_fade is 0 if there is no fade
};

// A mark may be drawn unless it faces away, where n . sight > away, or is too light, where n . l > lightest.
struct HatchBounds {
    float sight[3], away;
    float light[3], lightest;
};

struct HatchLoops {
    // Tests the normals of at most 32 marks, and their normals for tone. Returns a bit for each mark that may be drawn.
    std::uint32_t (*may_draw)(const HatchBounds& bounds, const float* normals, const float* tone_normals,
                              std::int64_t count);
    // Computes the share of the paper that lines cover, for each darkness.
    void (*coverage)(const HatchWidthLaw& law, const float* darkness, std::int64_t count, float* coverage);
    // Sets the margins of rim and picture for marks whose positions are known.
    void (*project)(const HatchSight& sight, const HatchRows& rows, std::int64_t count);
    // Sets the widths, and the margins of tone and level, for marks that may be drawn and for their neighbours. They
    // follow from the darkness and the results of place(). Rows x, y and z must also hold the positions before the
    // first mark and after the last one.
    void (*set_widths)(const HatchSight& sight, const HatchWidthLaw& law, const HatchRows& rows, std::int64_t count,
                       bool closed);
    // Computes the distances between consecutive marks. Finds the marks near a mark that is drawn.
    void (*measure_distances)(const HatchRows& rows, std::int64_t count, bool closed);
};

[[nodiscard]] HatchLoops hatch_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::frame
