// SPDX-License-Identifier: MIT
// A picture as a value: dots and strokes in window coordinates, in layers, with the identity of the marks that they
// come from.  Producers (src/frame) fill one, readers (src/output) only read it.
#pragma once

#include "base/assert.h"
#include "base/bits.h"
#include "base/memory.h"
#include "base/parallel.h"
#include "drawing/dot.h"
#include "drawing/tiles.h"
#include "geometry/vec.h"
#include "marks/point_set.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace hrbfnpr::drawing {

enum class Painting : std::uint8_t {
    // Each dot and stroke has been dimmed by the surface in front of it, so that their order does not matter where all
    // have one colour. Dots stand in pieces, in any order; one that is not drawn has the opacity 0.
    transmittance,
    // Dots of paper and of ink stand in the order in which they are painted. [NPAR 6.1]
    published
};

// The ink of one class of one layer of an item's marks.
struct Layer {
    std::int32_t item = 0;
    std::int32_t layer = 0; // number of the layer in the item's point set; -1: lines
    MarkClass mark_class = MarkClass::front;
    bool as_strokes = false;
    glm::vec4 ink{0.0F};          // straight RGBA
    std::uint32_t line_kind = 0;  // a constant HRBFNPR_LINE_KIND where `layer` is -1
    bool as_hatch = false;        // whether the strokes are hatching
    marks::LayerName line_name{}; // the name of the lines in their style; may be empty
};

// Counted while the drawing was made; hrbfnpr_drawing_info documents each member.
struct Counts {
    std::int64_t marks = 0, outside = 0, front = 0, back = 0, silhouette = 0, shown = 0;
    std::int64_t dropped_tone = 0, dropped_depth = 0, dropped_zoom = 0, dropped_hidden = 0, splats = 0, culled = 0;
    std::int64_t nanoseconds_classify = 0, nanoseconds_visibility = 0, nanoseconds_sort = 0;
    std::int64_t scratch_bytes = 0;

    Counts& operator+=(const Counts& other) noexcept; // adds all members but times and bytes
};

// The same for lines.
struct LineCounts {
    std::int64_t curves = 0, cusps = 0, crossings = 0, broken = 0, refined = 0, settled = 0, contradictions = 0;
    std::int64_t tangles = 0;
    std::int64_t nanoseconds = 0;
};

// The marks of one layer of one item: where their ids begin, and where the marks are if they have moved.
struct Run {
    std::int32_t item = 0;
    std::int32_t layer = 0;
    std::int64_t count = 0;
    std::uint32_t first_id = 1;
    std::int64_t posed = -1; // place of the first mark in `posed_position`; -1: marks stand as in the set
    bool poses_directions = false;
};

// An item's marks in the world.
struct ItemSource {
    const marks::PointSet* set = nullptr; // the drawing's owner keeps it alive
    double unit = 1.0; // unit of the positions that `to_world` takes, which are relative to the set's origin
    glm::dmat4 to_world{1.0};
    glm::mat3 normal_to_world{1.0F};
};

// A mark in the world.
struct MarkSource {
    glm::vec3 position;
    glm::vec3 normal;    // unit
    glm::vec3 direction; // unit
};

struct Identity {
    std::int64_t item, layer, mark;
    std::int64_t stroke; // -1: the mark has none
    std::int64_t place;  // along the stroke
};

struct Drawing {
    explicit Drawing(base::Memory& memory) noexcept;

    Window window;
    glm::vec4 paper{1.0F};
    Painting painting = Painting::transmittance;
    Counts counts;
    LineCounts line_counts;

    base::Array<Layer> layers;
    bool one_color = true;     // all inks have one colour, so their order does not matter
    glm::vec4 ink_color{0.0F}; // that colour

    base::Array<Dot> dots;
    base::Array<Piece> dot_pieces; // the parts of `dots` that hold dots
    std::int64_t dot_count = 0;    // number of dots of ink that are drawn
    base::Array<Stroke> strokes;   // far to near
    base::Array<StrokePoint> points;
    base::Array<Splat> splats; // depth layers were found from them
    bool has_splats = false;   // false: nothing hides anything
    base::Array<Piece> splat_pieces;

    // Indexes by place over the viewport, whose top-left corner is `first_pixel`; only Painting::transmittance has
    // them.
    glm::ivec2 first_pixel{0};
    Tiles dot_tiles;
    Tiles splat_tiles;
    Tiles segment_tiles; // a segment's number is that of its first point

    // From (x, y, window depth, 1) to the world, homogeneous.
    glm::dmat4 from_window{1.0};

    base::Array<ItemSource> items;
    base::Array<Run> runs; // one for each layer of each item, drawn or not, in the order of the ids
    // Three numbers for each mark of a posed run; positions are relative to the set's origin.
    base::Array<float> posed_position, posed_normal, posed_direction;

    void clear() noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;

    // Whether dot a is painted before dot b.
    [[nodiscard]] bool before(std::uint32_t a, std::uint32_t b) const noexcept {
        return dots[a].depth != dots[b].depth ? dots[a].depth > dots[b].depth : a < b;
    }

    // The run that has a mark; NULL if no mark has this id.
    [[nodiscard]] const Run* run_of(std::uint32_t id) const noexcept;
    // The id must be a mark's.
    [[nodiscard]] Identity identify(std::uint32_t id) const noexcept;
    [[nodiscard]] MarkSource source(std::uint32_t id) const noexcept;
    // The place in the world of a place in the window.
    [[nodiscard]] glm::vec3 world(const glm::vec3& window) const noexcept;

private:
    // Calls f for each array of the drawing; its tiles are no arrays.
    template <class Self, class F>
    static void for_arrays(Self& d, const F& f) {
        f(d.layers), f(d.dots), f(d.dot_pieces), f(d.strokes), f(d.points), f(d.splats), f(d.splat_pieces), f(d.items);
        f(d.runs), f(d.posed_position), f(d.posed_normal), f(d.posed_direction);
    }
    // The last run that begins no later than the id.
    [[nodiscard]] std::int64_t place_of(std::uint32_t id) const noexcept;
};

// ---- Segments of strokes, which go from one point of a stroke to the next: where one is and how it ends

// The stroke of a segment, whose number is that of its first point. No stroke before `from` has it.
[[nodiscard]] inline const Stroke* stroke_of(const Drawing& drawing, std::int64_t segment,
                                             const Stroke* from) noexcept {
    const Stroke* const next = std::upper_bound(from, drawing.strokes.end(), segment,
                                                [](std::int64_t at, const Stroke& s) { return at < s.first; });
    HRBFNPR_ASSERT(next > drawing.strokes.begin());
    return next - 1;
}

// The ends of a segment are round where another one follows.
struct SegmentEnds {
    Cap begin = Cap::round, end = Cap::round;
};
[[nodiscard]] inline SegmentEnds ends_of(const Stroke& stroke, std::int64_t segment) noexcept {
    if (stroke.closed) return {};
    return {segment == stroke.first ? stroke.cap_begin : Cap::round,
            segment + 2 == stroke.first + stroke.count ? stroke.cap_end : Cap::round};
}

// A segment may reach this far around the line between its points.
[[nodiscard]] inline float reach(const SegmentEnds& ends, const StrokePoint& a, const StrokePoint& b) noexcept {
    const bool pointed = ends.begin == Cap::pointed || ends.end == Cap::pointed;
    const float widest = std::max({a.radius, b.radius, smallest_radius});
    return widest * (pointed ? std::max(1.0F, 2.0F * point_length) : 1.0F) + soft_rim;
}

// Whether a segment covers a place, and then its share of the way along it. Thin ones count as a pixel wide.
[[nodiscard]] inline bool covers(const SegmentEnds& ends, const StrokePoint& a, const StrokePoint& b, float x, float y,
                                 float& at) noexcept {
    const float ux = b.x - a.x;
    const float uy = b.y - a.y;
    const float length = std::hypot(ux, uy);
    const float along = length > 0.0F ? ((x - a.x) * ux + (y - a.y) * uy) / length : 0.0F;
    at = length > 0.0F ? std::clamp(along / length, 0.0F, 1.0F) : 0.0F;
    const float radius = std::max(a.radius + (b.radius - a.radius) * at, smallest_radius);
    const float beyond = std::max(-along, along - length);
    const float dx = x - a.x - at * ux;
    const float dy = y - a.y - at * uy;
    const float square = dx * dx + dy * dy;
    const Cap cap = along < 0.0F ? ends.begin : ends.end;
    if (!(beyond > 0.0F) || cap == Cap::round) return square <= radius * radius;
    const float left = cap == Cap::pointed ? radius - beyond / (2.0F * point_length) : -1.0F; // half the tip's width
    return left > 0.0F && square - beyond * beyond <= left * left;
}

// Puts the segments of a drawing's strokes into tiles like the tiles of its dots, and some that only lie near.
void bin_segments(const base::Parallel& parallel, Drawing& drawing);

// ---- Far-to-near order

// A 64-bit key: in the upper half the depth, ascending from far to near; in the lower half the number of the thing.
[[nodiscard]] inline std::uint64_t far_first_key(float depth, std::uint32_t what) noexcept {
    const auto bits = base::bit_cast<std::uint32_t>(depth);
    // The usual map of floats to integers of the same order, then turned round.
    const std::uint32_t ascending = (bits >> 31U) != 0 ? ~bits : bits | 0x80000000U;
    return std::uint64_t{~ascending} << 32U | what;
}

// Sorts by the upper halves; equal ones stay in their order.  The same for any thread count.
class FarToNear {
public:
    explicit FarToNear(base::Memory& memory) noexcept : other_(memory), histogram_(memory) {}
    void sort(const base::Parallel& parallel, base::Array<std::uint64_t>& keys);
    [[nodiscard]] std::int64_t bytes() const noexcept { return other_.bytes() + histogram_.bytes(); }

private:
    bool pass(const base::Parallel& parallel, const base::Array<std::uint64_t>& from, base::Array<std::uint64_t>& to,
              unsigned shift);

    base::Array<std::uint64_t> other_;
    base::Array<std::int64_t> histogram_; // chunk by chunk, for each digit
};

} // namespace hrbfnpr::drawing
