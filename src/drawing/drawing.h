// SPDX-License-Identifier: MIT
// Defines a drawing as a value: dots and strokes in window coordinates, in layers, with the ids of their marks.
// src/frame makes drawings, and src/output only reads them.
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
    // Each dot and stroke is already dimmed by the surfaces in front of it, so the order does not matter if all inks
    // have one colour. Dots are in ranges, in any order. Dots that are not drawn have opacity 0.
    transmittance,
    // Dots of paper and ink are in the order in which they are painted [NPAR 6.1].
    published
};

// The ink for the marks of one class in one layer of an item.
struct Layer {
    std::int32_t item = 0;
    std::int32_t layer = 0; // index of the layer in the item's point set; -1: the layer consists of lines
    MarkClass mark_class = MarkClass::front;
    bool as_strokes = false;
    glm::vec4 ink{0.0F};          // RGBA with straight alpha
    std::uint32_t line_kind = 0;  // HRBFNPR_LINE_KIND_*; used if `layer` is -1
    bool as_hatch = false;        // whether the strokes are hatching
    std::int32_t ink_number = -1; // number of the ink in the style's palette; -1: the layer's own ink
    bool other_side = false;      // whether the marks are seen from the inside of the surface
    marks::LayerName line_name{}; // the name that the style gives to the lines; may be empty
};

// Counts of marks and times, taken while the drawing was made. hrbfnpr_drawing_info documents each member.
struct Counts {
    std::int64_t marks = 0, outside = 0, front = 0, back = 0, silhouette = 0, shown = 0;
    std::int64_t dropped_tone = 0, dropped_depth = 0, dropped_zoom = 0, dropped_hidden = 0, splats = 0, culled = 0;
    std::int64_t nanoseconds_classify = 0, nanoseconds_visibility = 0, nanoseconds_sort = 0;
    std::int64_t scratch_bytes = 0;

    Counts& operator+=(const Counts& other) noexcept; // adds all members except times and bytes
};

// Counts of lines, and the time that was spent on them.
struct LineCounts {
    std::int64_t curves = 0, cusps = 0, crossings = 0, broken = 0, refined = 0, settled = 0, contradictions = 0;
    std::int64_t tangles = 0;
    std::int64_t pieces = 0, agreeing = 0, undecided = 0, repaired = 0; // results of verifying lines
    std::int64_t nanoseconds = 0;
};

// The marks of one layer of one item. Their ids are consecutive and begin at `first_id`. If the marks have moved, they
// are posed: the posed_* arrays of the drawing hold them.
struct Run {
    std::int32_t item = 0;
    std::int32_t layer = 0;
    std::int64_t count = 0;
    std::uint32_t first_id = 1;
    // Index of the run's first mark in `posed_position`; -1: the marks have the positions of the point set.
    std::int64_t posed = -1;
    bool poses_directions = false;
};

// The marks of an item, and their transforms to the world.
struct ItemSource {
    const marks::PointSet* set = nullptr; // kept alive by the owner of the drawing
    // The unit of length of the positions that `to_world` transforms. These positions are relative to the set's origin.
    double unit = 1.0;
    glm::dmat4 to_world{1.0};
    glm::mat3 normal_to_world{1.0F};
};

// A mark in the world.
struct MarkSource {
    glm::vec3 position;
    glm::vec3 normal;    // unit vector
    glm::vec3 direction; // unit vector
};

struct Identity {
    std::int64_t item, layer, mark;
    std::int64_t stroke; // -1: the mark is in no stroke
    std::int64_t place;  // the mark's index along the stroke
};

struct Drawing {
    explicit Drawing(base::Memory& memory) noexcept;

    Window window;
    glm::vec4 paper{1.0F};
    Painting painting = Painting::transmittance;
    Counts counts;
    LineCounts line_counts;

    base::Array<Layer> layers;
    bool one_color = true;     // whether all inks have one colour, so that their order does not matter
    glm::vec4 ink_color{0.0F}; // the colour of all inks, if one_color

    base::Array<Dot> dots;
    base::Array<IndexRange> dot_ranges; // the ranges of `dots` that are in use
    std::int64_t dot_count = 0;         // the number of dots of ink that are drawn
    base::Array<Stroke> strokes;        // sorted from far to near
    base::Array<StrokePoint> points;
    base::Array<Splat> splats; // the splats from which depth layers were computed
    bool has_splats = false;   // if false, no surface hides ink
    base::Array<IndexRange> splat_ranges;

    // Spatial indexes over the viewport. Its top-left pixel is `first_pixel`. They exist only with
    // Painting::transmittance.
    glm::ivec2 first_pixel{0};
    glm::ivec2 pixels{0}; // the size of the viewport, in whole pixels
    Tiles dot_tiles;
    Tiles splat_tiles;
    Tiles segment_tiles; // a segment's index is that of its first point

    // Maps (x, y, window depth, 1) to homogeneous coordinates in the world.
    glm::dmat4 from_window{1.0};

    base::Array<ItemSource> items;
    base::Array<Run> runs; // one for each layer of each item, in the order of ids, even if the layer is not drawn
    // Three numbers for each mark of a run that was posed. Positions are relative to the set's origin.
    base::Array<float> posed_position, posed_normal, posed_direction;

    void clear() noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;

    // Returns whether dot a is painted before dot b.
    [[nodiscard]] bool before(std::uint32_t a, std::uint32_t b) const noexcept {
        return dots[a].depth != dots[b].depth ? dots[a].depth > dots[b].depth : a < b;
    }

    // Returns the run that contains the mark with this id, or nullptr if no mark has it.
    [[nodiscard]] const Run* run_of(std::uint32_t id) const noexcept;
    // identify() and source() require the id of a mark.
    [[nodiscard]] Identity identify(std::uint32_t id) const noexcept;
    [[nodiscard]] MarkSource source(std::uint32_t id) const noexcept;
    // Returns the place in the world for a place in window coordinates.
    [[nodiscard]] glm::vec3 world(const glm::vec3& window) const noexcept;

private:
    // Calls f for each array of the drawing, but not for the tiles.
    template <class Self, class F>
    static void for_arrays(Self& d, const F& f) {
        f(d.layers), f(d.dots), f(d.dot_ranges), f(d.strokes), f(d.points), f(d.splats), f(d.splat_ranges), f(d.items);
        f(d.runs), f(d.posed_position), f(d.posed_normal), f(d.posed_direction);
    }
    // Returns the index of the last run that begins at or before this id.
    [[nodiscard]] std::int64_t place_of(std::uint32_t id) const noexcept;
};

// ---- Segments of strokes: each goes from one point of a stroke to the next

// Returns the stroke that contains a segment. `segment` is the index of the segment's first point. The segment's stroke
// must not come before `from`.
[[nodiscard]] inline const Stroke* stroke_of(const Drawing& drawing, std::int64_t segment,
                                             const Stroke* from) noexcept {
    const Stroke* const next = std::upper_bound(from, drawing.strokes.end(), segment,
                                                [](std::int64_t at, const Stroke& s) { return at < s.first; });
    HRBFNPR_ASSERT(next > drawing.strokes.begin());
    return next - 1;
}

// The caps of a segment. An end counts as round if another segment follows there.
struct SegmentEnds {
    Cap begin = Cap::round, end = Cap::round;
};
[[nodiscard]] inline SegmentEnds ends_of(const Stroke& stroke, std::int64_t segment) noexcept {
    if (stroke.closed) return {};
    return {segment == stroke.first ? stroke.cap_begin : Cap::round,
            segment + 2 == stroke.first + stroke.count ? stroke.cap_end : Cap::round};
}

// Returns an upper bound for how far, in pixels, the ink of a segment is from the line between its points.
[[nodiscard]] inline float reach(const SegmentEnds& ends, const StrokePoint& a, const StrokePoint& b) noexcept {
    const bool pointed = ends.begin == Cap::pointed || ends.end == Cap::pointed;
    const float widest = std::max({a.radius, b.radius, smallest_radius});
    return widest * (pointed ? std::max(1.0F, 2.0F * point_length) : 1.0F) + soft_rim;
}

// Returns whether a segment covers a place, and sets `at` to the position along the segment, from 0 to 1. Thin segments
// count as one pixel wide.
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

// Assigns the segments of strokes to tiles, in the same way as dots. A tile may get a segment that only touches the
// tile with its bounding box.
void bin_segments(const base::Parallel& parallel, Drawing& drawing);

// ---- Far-to-near order

// Returns a 64-bit sort key. Its upper half sorts depths from far to near. Its lower half is `what`.
[[nodiscard]] inline std::uint64_t far_first_key(float depth, std::uint32_t what) noexcept {
    const auto bits = base::bit_cast<std::uint32_t>(depth);
    // Maps floats to integers of the same order. The key has the inverted integer, so that far depths come first.
    const std::uint32_t ascending = (bits >> 31U) != 0 ? ~bits : bits | 0x80000000U;
    return std::uint64_t{~ascending} << 32U | what;
}

// Sorts keys by their upper halves. The sort is stable, and its result does not depend on the number of threads.
class DepthSort {
public:
    explicit DepthSort(base::Memory& memory) noexcept : other_(memory), histogram_(memory) {}
    void sort(const base::Parallel& parallel, base::Array<std::uint64_t>& keys);
    [[nodiscard]] std::int64_t bytes() const noexcept { return other_.bytes() + histogram_.bytes(); }

private:
    bool sort_by_digit(const base::Parallel& parallel, const base::Array<std::uint64_t>& from,
                       base::Array<std::uint64_t>& to, unsigned shift);

    base::Array<std::uint64_t> other_;
    // For each chunk of keys, the number of keys with each value of the digit.
    base::Array<std::int64_t> histogram_;
};

} // namespace hrbfnpr::drawing
