// SPDX-License-Identifier: MIT
// The marks of one stroke of hatching in the picture: where they are, how wide their line is there, and how far each is
// from where the line ends.
//
// Most of a frame's strokes are not drawn. So first whole pieces of a stroke are passed over by what bounds them, then
// marks by their normals alone; the rest is projected and given its width on vectors of the processor (loops.h).
#pragma once

#include "frame/hatch/loops.h"
#include "frame/scene/cluster_view.h"
#include "frame/scene/scene.h"

#include <array>
#include <span>

namespace hrbfnpr::frame {

// The margins of a mark. The line is drawn where none is negative.
enum HatchMargin : std::size_t {
    margin_tone = 0,    // how much darker it is than where lines begin
    margin_level = 1,   // how much room there is for lines of the mark's level
    margin_rim = 2,     // how far it faces the eye
    margin_picture = 3, // how far it lies inside the picture and a strip around it, pixels
    hatch_margins = 4
};

// A mark in the picture. It is a PackedMark and the mark's id.
struct HatchMark {
    float x, y; // pixels
    float window, depth;
    float side_x, side_y; // the unit normal's, eye space
    float width;          // the line's, pixels
    float way;            // from the mark before, pixels
    std::array<float, hatch_margins> margin;
    float pixels_per_unit;
    float begins_chain; // 1: marks before this one were left out, and the line does not go on over them; else 0
    float unused;
    std::uint32_t id;

    // Whether it has a place in the picture's plane.
    [[nodiscard]] bool is_valid() const noexcept { return margin[margin_picture] > hatch_nowhere; }
};

// How a line ends where its stroke does.
enum class StrokeEnd : std::uint8_t { open, crease };

// The marks of a stroke that its line needs.
struct HatchStroke {
    explicit HatchStroke(base::Memory& memory) noexcept
        : mark(memory), may_draw(memory), range(memory), number(memory), row(memory) {}

    // Half-open, places in the order of the strokes.
    struct Range {
        std::int64_t begin, end;
    };

    base::Array<HatchMark> mark; // those near places that are drawn; a ring ends with its first mark
    bool ring = false;           // the stroke is closed, and none of its marks was left out
    std::int64_t first_kept = 0; // the row of mark[0]; its number along the stroke, where no marks were left out
    StrokeEnd begins = StrokeEnd::open, ends = StrokeEnd::open;
    bool has_begin = false, has_end = false; // mark[0] is the stroke's first mark; the last one its last

    // Scratch of HatchMarks.
    base::Array<std::uint32_t> may_draw; // a bit for each mark of a piece, for each piece
    base::Array<Range> range;            // the places that are looked at, rising
    base::Array<std::uint32_t> number;   // in the layer, of those marks
    base::Array<float> row;              // memory of HatchRows
    std::int64_t first = 0, count = 0;   // places; of a closed one without a last mark that lies where the first does
    bool closed = false;

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return mark.bytes() + may_draw.bytes() + range.bytes() + number.bytes() + row.bytes();
    }
};

// How marks are seen; the same for all strokes of a frame.
struct HatchView {
    const SeeLoops& see;
    const HatchLoops& loops;
    const Scene& scene;
    const Frustum& frustum;
};

// Looks at the strokes of one run.
class HatchMarks {
public:
    // `taus` are the tones of the run's marks, if a callback gives them; else NULL.
    HatchMarks(const HatchView& view, const Run& run, const ItemSight& sight, const float* taus) noexcept;

    // Fills `seen` with the marks of a stroke, whose first piece has the number `piece`. Returns whether anything may
    // be drawn of it.
    bool see(std::int64_t stroke, std::int64_t piece, HatchStroke& seen) const;

private:
    void set_most_coverage() noexcept;
    [[nodiscard]] std::int32_t most_level() const noexcept;
    [[nodiscard]] bool has_room(std::int32_t level, float nearest, float darkness) const noexcept;
    [[nodiscard]] bool may_draw(const marks::StrokePiece& piece) const noexcept;
    [[nodiscard]] std::uint32_t marks_that_may(const marks::StrokePiece& piece) const noexcept;
    [[nodiscard]] float most_darkness(const marks::StrokePiece& piece) const noexcept;
    void set_extent(std::int64_t stroke, HatchStroke& seen) const noexcept;
    bool find_pieces(std::int64_t piece, std::int64_t count, HatchStroke& seen) const;
    bool find_marks(std::int64_t piece, HatchStroke& seen) const noexcept;
    void find_ranges(HatchStroke& seen) const;
    [[nodiscard]] HatchRows load(HatchStroke& seen) const;
    void load(std::int64_t begin, std::int64_t count, std::uint32_t* numbers, const HatchRows& rows) const noexcept;
    void see_rows(std::span<const std::uint32_t> numbers, const HatchRows& rows, bool closed) const noexcept;
    void set_darkness(std::span<const std::uint32_t> numbers, const HatchRows& rows) const noexcept;
    void borrow_darkness(std::int64_t count, float* darkness, const HatchRows& rows) const noexcept;
    void set_widths_alone(std::span<const std::uint32_t> numbers, const HatchRows& rows) const noexcept;
    // Whether it is closed and its first and last marks, which are neighbours, were looked at.
    [[nodiscard]] static bool has_seam(const HatchStroke& seen) noexcept {
        return seen.closed && seen.range.span().front().begin == seen.first &&
               seen.range.span().back().end == seen.first + seen.count;
    }
    void keep_short_gaps(const HatchRows& rows, const HatchStroke& seen) const noexcept;
    void keep(const HatchRows& rows, HatchStroke& seen) const;
    void set_ends(HatchStroke& seen) const noexcept;
    [[nodiscard]] StrokeEnd end_at(std::int64_t last, std::int64_t before) const noexcept;
    [[nodiscard]] bool is_unsteady() const noexcept {
        return style_.hatch_wobble > 0.0F || style_.hatch_overshoot > 0.0F;
    }
    [[nodiscard]] glm::vec3 place(std::int64_t at) const noexcept {
        return glm::vec3(glm::dvec3(run_.position_of(run_.marks->mark_of(at))) * per_unit_);
    }

    HatchView view_;
    const Run& run_;
    const ItemView& item_;
    const ItemSight& sight_;
    const LayerStyle& style_;
    const float* taus_;
    HatchLaw law_;
    std::int32_t levels_;      // the finest one
    double per_unit_;          // 1 / the item's unit, a power of two
    float separation_ = 0.0F;  // between lines of level 0 alone, in the item's unit; 0: not known
    const float* tone_normal_; // the normals that light is bounded by: the marks' own, or those for tone
    float lightest_;           // n . l above which a mark is too light
    bool has_bounds_;          // whether marks can be passed over by their normals
    float beyond_;             // the strip around the picture in which lines may end unseen, pixels
    float stretch_ = 0.0F;     // the longest image of a length of 1 at the distance 1, pixels
    std::int32_t shown_ = 255; // finer levels cannot be seen from here
    static constexpr std::size_t steps = 16;
    std::array<float, steps + 1> most_coverage_{}; // the most of all darknesses up to k / steps
};

} // namespace hrbfnpr::frame
