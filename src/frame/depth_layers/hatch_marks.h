// SPDX-License-Identifier: MIT
// The marks of a stroke as hatching needs them: where they are in the picture, and how wide their line is there.
#pragma once

#include "frame/depth_layers/gather.h"
#include "frame/depth_layers/hatch_law.h"
#include "frame/depth_layers/hatch_limits.h"
#include "frame/depth_layers/hatch_loops.h"

#include <array>

namespace hrbfnpr::frame {

// Why a line ends.
enum class HatchEnd : std::uint8_t {
    tone = 0,    // it is too light there
    level = 1,   // lines of its level are too close together
    rim = 2,     // the surface turns away
    picture = 3, // far enough outside of the picture
    line = 4,    // its stroke ends ...
    crease = 5   // ... at a crease
};
inline constexpr std::size_t hatch_margins = 4;

// How open the gap is that a mark lies in: 0 where it hardly begins to be one, 1 where margins are so far below 0, by
// the tone and by the level, or any other is.  A gap's length may change from nothing to much from one view to the
// next, where a line's margins are about even; this does not.  Pieces without any room for their level are open.
inline constexpr float openness_of_tone = 50.0F;
inline constexpr float openness_of_level = 2.0F;
[[nodiscard]] inline float hatch_openness(float tone, float level, float others) noexcept {
    if (others < 0.0F) return 1.0F;
    return std::clamp(-std::min(tone * openness_of_tone, level * openness_of_level), 0.0F, 1.0F);
}

// The same of a part that is drawn: 0 where it is about to vanish.
[[nodiscard]] inline float hatch_firmness(float tone, float level) noexcept {
    return std::clamp(std::min(tone * openness_of_tone, level * openness_of_level), 0.0F, 1.0F);
}

// How far an end, or a mark of a gap, is from lacking tone or facing away as well: 0 where another margin than its
// level's runs out, too, 1 where so much of them is left, of the tone and of n . v.
inline constexpr float by_level_alone = 0.1F;
[[nodiscard]] inline float hatch_level_alone(float tone, float rim) noexcept {
    return std::clamp(std::min(tone, rim) / by_level_alone, 0.0F, 1.0F);
}

// A line between others, for which there is hardly room, counts one in so many of its length where that may be too
// short.
inline constexpr float shortest_filling = 3.0F;

// As a PackedMark, and its number.
struct HatchMark {
    float x, y; // pixels
    float window, depth;
    float side_x, side_y; // of the unit normal, eye space
    float width;          // of the line, pixels
    float way;            // from the mark before, pixels, along those that are left out
    // The line is drawn where none is negative; by HatchEnd.
    std::array<float, hatch_margins> margin;
    float pixels_per_unit;
    float passed;       // the most openness() of those that are left out; 0: none is ...
    float passed_alone; // ... and, where that is below 1, the least hatch_level_alone()
    std::uint32_t id;

    // It has a place in the picture's plane.
    [[nodiscard]] bool is_valid() const noexcept { return margin[3] > hatch_nowhere; }
    [[nodiscard]] float openness() const noexcept {
        return is_valid() ? hatch_openness(margin[0], margin[1], std::min(margin[2], margin[3])) : 1.0F;
    }

    [[nodiscard]] bool is_drawn() const noexcept {
        return std::min({margin[0], margin[1], margin[2], margin[3]}) >= 0.0F;
    }
};

// A stroke while its marks are looked at.
struct HatchStroke {
    explicit HatchStroke(base::Memory& memory) noexcept
        : mark(memory), may_draw(memory), range(memory), number(memory), row(memory) {}

    // Half-open, in the order of the strokes.
    struct Range {
        std::int64_t begin, end;
    };

    base::Array<HatchMark> mark; // those that are drawn and the two beside them; of a closed stroke the first one again
    base::Array<std::uint32_t> may_draw; // of each piece, a bit for each of its marks
    base::Array<Range> range;            // of places that are looked at, rising
    base::Array<std::uint32_t> number;   // in the layer, of those marks
    base::Array<float> row;              // of HatchRows
    std::int64_t first = 0,
                 count = 0; // places; of a closed one without the last mark, if that lies where the first does
    bool closed = false;
    HatchEnd begins = HatchEnd::line, ends = HatchEnd::line; // of find_crease_ends()

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return mark.bytes() + may_draw.bytes() + range.bytes() + number.bytes() + row.bytes();
    }
};

// Looks at the strokes of one run.
class HatchMarks {
public:
    // taus: of each mark of the run, if they are a callback's; else NULL.
    HatchMarks(const Gather& gather, const HatchLoops& loops, const Scene& scene, const Run& run,
               const float* taus) noexcept;

    // The marks of a stroke in their order that its line needs.  piece: the stroke's first one.  Returns whether
    // anything is drawn of it.
    bool see(std::int64_t stroke, std::int64_t piece, HatchStroke& seen) const;

private:
    [[nodiscard]] std::int32_t most_level() const noexcept;
    [[nodiscard]] bool has_room(std::int32_t level, float nearest, float darkness) const noexcept;
    void set_most_coverage() noexcept;
    [[nodiscard]] HatchSight sight() const noexcept;
    [[nodiscard]] HatchLaw law() const noexcept;
    [[nodiscard]] bool may_draw(const marks::StrokePiece& piece) const noexcept;
    [[nodiscard]] float most_darkness(const marks::StrokePiece& piece) const noexcept;
    void set_ends(std::int64_t stroke, HatchStroke& seen) const noexcept;
    bool find_pieces(std::int64_t piece, std::int64_t count, HatchStroke& seen) const;
    bool find_marks(std::int64_t piece, HatchStroke& seen) const noexcept;
    void find_ranges(HatchStroke& seen) const;
    void expect_normals(const marks::StrokePiece& piece) const noexcept;
    void expect_places(const marks::StrokePiece& piece) const noexcept;
    [[nodiscard]] HatchRows load(HatchStroke& seen) const;
    void load(std::int64_t begin, std::int64_t count, std::uint32_t* numbers, const HatchRows& rows) const noexcept;
    void see_rows(std::span<const std::uint32_t> numbers, const HatchRows& rows, bool closed) const noexcept;
    void set_darkness(std::span<const std::uint32_t> numbers, const HatchRows& rows) const noexcept;
    void borrow_darkness(std::int64_t count, float* darkness, const HatchRows& rows) const noexcept;
    void set_widths_alone(std::span<const std::uint32_t> numbers, const HatchRows& rows) const noexcept;
    void keep(const HatchRows& rows, HatchStroke& seen) const;
    void put_marks(const HatchRows& rows, const std::uint32_t* numbers, std::int64_t count,
                   HatchMark* to) const noexcept;
    [[nodiscard]] bool has_hand() const noexcept { return style_.hatch_wobble > 0.0F || style_.hatch_overshoot > 0.0F; }
    [[nodiscard]] glm::vec3 place(std::int64_t at) const noexcept {
        return glm::vec3(glm::dvec3(run_.position_of(run_.marks->mark_of(at))) * per_unit_);
    }

    const Gather& gather_;
    const HatchLoops& loops_;
    const Scene& scene_;
    const Run& run_;
    const ItemView& item_;
    const ItemSight& sight_;
    const Seer& seer_;
    const LayerStyle& style_;
    const float* taus_;
    std::int32_t levels_; // the finest one
    double per_unit_;     // of the item: a power of two, as that
    float separation_;    // of the lines of level 0 alone, in the item's unit; 0: not known
    HatchLimits limits_;
    float beyond_;       // the picture, pixels: there lines may end unseen
    float stretch_;      // of a length of 1 at the distance 1, pixels, at most
    std::int32_t shown_; // no finer level can be seen from here
    // No darkness of so many steps or less has a larger coverage.
    static constexpr std::size_t steps = 16;
    std::array<float, steps + 1> most_coverage_;
};

} // namespace hrbfnpr::frame
