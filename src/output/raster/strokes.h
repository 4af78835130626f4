// SPDX-License-Identifier: MIT
// The area that a stroke covers.
// 1. may_overlap tells whether parts of a stroke may overlap.
// 2. Outliner makes adjacent polygons, one for each segment or for several segments that continue each other.
// 3. StrokeUnion computes the exact area of each pixel that overlapping polygons cover together.
#pragma once

#include "base/assert.h"
#include "base/memory.h"
#include "drawing/dot.h"
#include "output/raster/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <tuple>
#include <utility>

namespace hrbfnpr::output {

// The segments of a stroke that reach a tile, in ascending order. Each is given by the index of its first point.
struct SegmentList {
    const drawing::StrokePoint* points;
    const drawing::Stroke* stroke;
    const std::uint32_t* numbers;
    std::int64_t count;
    float left, top;       // the first pixel of the tile
    const float* color;    // RGB and alpha of the ink; the RGB is not read if the tile has no colour planes
    float host_depth_sign; // -1 if the host's depth rises towards the eye, else 1
};

struct Place {
    double x, y; // in pixels, relative to the tile
};

inline Place operator+(const Place& a, const Place& b) noexcept { return {a.x + b.x, a.y + b.y}; }
inline Place operator-(const Place& a, const Place& b) noexcept { return {a.x - b.x, a.y - b.y}; }
inline Place operator*(double s, const Place& a) noexcept { return {s * a.x, s * a.y}; }
inline double dot(const Place& a, const Place& b) noexcept { return a.x * b.x + a.y * b.y; }
inline double cross(const Place& a, const Place& b) noexcept { return a.x * b.y - a.y * b.x; }
inline Place unit(const Place& a) noexcept { return (1.0 / std::sqrt(dot(a, a))) * a; }

// ---- Whether parts overlap

// Consecutive segments whose directions are within 60 degrees of the first segment's, and their bounding box.
struct SegmentGroup {
    float along_x, along_y, square; // the vector of the first segment, in pixels, and its squared length
    float left, top, right, bottom;
    std::int64_t begin, end; // the range of segments in the list

    [[nodiscard]] bool accepts(float x, float y, std::int64_t number) const noexcept {
        const float cosine = x * along_x + y * along_y;
        return number == end && cosine >= 0.0F && cosine * cosine >= 0.25F * square * (x * x + y * y);
    }
    // Returns whether the first segments of the two groups differ in direction by less than 120 degrees.
    [[nodiscard]] bool continues_in(const SegmentGroup& next) const noexcept {
        const float cosine = along_x * next.along_x + along_y * next.along_y;
        return cosine > 0.0F || cosine * cosine < 0.25F * square * next.square;
    }
    [[nodiscard]] bool is_apart_from(const SegmentGroup& other) const noexcept {
        return right < other.left || other.right < left || bottom < other.top || other.bottom < top;
    }
    void reach(const drawing::StrokePoint& p, float radius) noexcept {
        left = std::min(left, p.x - radius);
        top = std::min(top, p.y - radius);
        right = std::max(right, p.x + radius);
        bottom = std::max(bottom, p.y + radius);
    }
};

inline bool are_consecutive(const SegmentGroup& a, const SegmentGroup& b, const drawing::Stroke& stroke) noexcept {
    const bool around = stroke.closed && a.begin == stroke.first && b.end == stroke.first + stroke.count - 1;
    return a.end == b.begin ? a.continues_in(b) : around && b.continues_in(a);
}

using SegmentGroups = std::array<SegmentGroup, 12>;

// Finds the groups of the list's segments. Returns the number of groups, or size() + 1 if there are more than the array
// can hold.
inline std::size_t find_segment_groups(const SegmentList& list, SegmentGroups& groups) noexcept {
    std::size_t count = 0;
    for (std::int64_t i = 0; i < list.count; ++i) {
        const std::int64_t number = list.numbers[i];
        const drawing::StrokePoint& a = list.points[number];
        const drawing::StrokePoint& b = list.points[number + 1];
        const float x = b.x - a.x;
        const float y = b.y - a.y;
        if (count == 0 || !groups[count - 1].accepts(x, y, number)) {
            if (count == groups.size()) return count + 1;
            groups[count++] = {x, y, x * x + y * y, a.x, a.y, a.x, a.y, number, number};
        }
        SegmentGroup& last = groups[count - 1];
        if (last.square == 0.0F) std::tie(last.along_x, last.along_y, last.square) = std::tuple(x, y, x * x + y * y);
        last.end = number + 1;
    }
    return count;
}

// Returns whether non-adjacent parts of the stroke may overlap in the tile.
[[nodiscard]] inline bool may_overlap(const SegmentList& list) noexcept {
    SegmentGroups groups;
    const std::size_t count = find_segment_groups(list, groups);
    if (count <= 1 || count > groups.size()) return count > 1;
    const bool pointed =
        list.stroke->cap_begin == drawing::Cap::pointed || list.stroke->cap_end == drawing::Cap::pointed;
    // A pointed tip reaches farther than a round end.
    const float widest = pointed ? std::max(1.0F, 2.0F * drawing::point_length) : 1.0F;
    for (SegmentGroup& group : std::span(groups).first(count))
        for (std::int64_t i = group.begin; i <= group.end; ++i)
            // The box is one pixel larger, so that groups whose boxes do not overlap have no pixel in common.
            group.reach(list.points[i], widest * list.points[i].radius + 1.0F);
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
            if (!are_consecutive(groups[i], groups[j], *list.stroke) && !groups[i].is_apart_from(groups[j]))
                return true;
    return false;
}

// ---- Outlines

// A polygon around a line. Its vertices are in such an order that its inside lies to the right, with y pointing down.
// The left side of the line is stored forwards from the start of the array. The right side is stored backwards from the
// end of the array, until close() appends it to the left side.
struct Outline {
    static constexpr std::int32_t most = 416;
    // Room for two quarter circles of 64 chords each, and for corners.
    static constexpr std::int32_t most_of_a_leg = 140;
    std::int32_t count = 0, back = most;
    // On the right side and on the left side: how many of its last vertices belong to gentle turns.
    std::int32_t gentle[2] = {0, 0};
    Place at[most];

    void clear() noexcept {
        count = gentle[0] = gentle[1] = 0;
        back = most;
    }
    // Returns whether the last place may be omitted because it lies on the line between its neighbours.
    [[nodiscard]] bool may_drop(const Place& next, bool left) const noexcept {
        const std::int32_t passed = gentle[left ? 1 : 0];
        if (passed % 4 == 0) return false; // every fourth place is kept, because the errors of omitted places add up
        const Place& last = at[left ? count - 1 : back];
        const Place& before = at[left ? count - 2 : back + 1];
        const Place along = next - before;
        const double off = cross(along, last - before);
        return off * off <= raster_tuning.edge_tolerance * raster_tuning.edge_tolerance * dot(along, along);
    }
    void drop(bool left) noexcept { left ? --count : ++back; }
    void add(const Place& place, bool left = true) noexcept {
        HRBFNPR_ASSERT(count < back);
        at[left ? count++ : --back] = place;
    }
    [[nodiscard]] bool has_room() const noexcept { return back - count > 2 * most_of_a_leg; }
    // Closes the polygon: appends the right side to the left side.
    void close() noexcept {
        for (; back < most; ++back) at[count++] = at[back];
    }
};

// Adds the corners of an arc of at most 90 degrees between two unit vectors. The ends of the arc are not added. They
// lie on the arc, and the added corners lie outside it, so that the area is exact. Only square roots and quotients are
// used, because they give the same bits on all processors.
inline void add_arc(const Place& centre, double radius, const Place& from, const Place& to, double scale,
                    Outline& outline, bool left = true) noexcept {
    double cosine = dot(from, to);
    int halvings = 0;
    double rise = 0.0;
    for (;; ++halvings) {
        const double half = std::sqrt(std::max(0.5 + 0.5 * cosine, 0.0));
        rise = radius * (1.0 - half);
        const double chord = 2.0 * radius * std::sqrt(std::max(0.5 - 0.5 * cosine, 0.0));
        const double most = scale * (halvings == 0 ? raster_tuning.chord_tolerance : raster_tuning.arc_tolerance);
        if (halvings == raster_tuning.most_halvings || rise * std::min(chord, 1.0) <= most) break;
        cosine = half;
    }
    const double sine = std::sqrt(std::max(1.0 - cosine * cosine, 0.0)) * (cross(from, to) < 0.0 ? -1.0 : 1.0);
    const int chords = 1 << halvings;
    const double outer = radius + rise * (2.0 / 3.0) * chords / std::max(chords - 1, 1);
    Place at = from;
    for (int i = 1; i < chords; ++i) {
        at = {at.x * cosine - at.y * sine, at.x * sine + at.y * cosine};
        outline.add(centre + outer * at, left);
    }
}

// Adds the cap at an end of a line, from one corner of the end to the other. `out` is the direction outward along the
// line.
inline void add_cap(const Place& centre, double radius, const Place& out, drawing::Cap cap, double scale,
                    Outline& outline) noexcept {
    const Place from{out.y, -out.x};
    if (cap == drawing::Cap::round) {
        add_arc(centre, radius, from, out, scale, outline);
        outline.add(centre + radius * out);
        add_arc(centre, radius, out, -1.0 * from, scale, outline);
    } else if (cap == drawing::Cap::pointed) {
        outline.add(centre + 2.0 * static_cast<double>(drawing::point_length) * radius * out);
    }
}

// Finds where two lines cross: at + s * along = other + t * direction. Writes s and t.
inline bool crossing(const Place& at, const Place& along, const Place& other, const Place& direction, double& s,
                     double& t) noexcept {
    const double sine = cross(along, direction);
    if (!(std::abs(sine) > 1e-9 * std::abs(dot(along, direction)))) return false;
    s = cross(other - at, direction) / sine;
    t = cross(other - at, along) / sine;
    return true;
}

// Makes the outlines of a stroke's segments. Consecutive segments that turn gently share an edge on the bisector of
// their angle, so that their polygons neither overlap nor leave a gap. Where a turn is too sharp for the lengths of its
// segments, each polygon ends at right angles to its segment, and they overlap.
class Outliner {
public:
    // `overlap` tells whether outlines may overlap each other.
    Outliner(const SegmentList& list, bool overlap) noexcept
        : list_(list), arcs_(overlap ? raster_tuning.overlap_factor : 1.0), first_(list.stroke->first),
          last_(list.stroke->first + list.stroke->count - 2) {}

    // Makes the outline of the list's segment i, with its share of the joins and its caps. If `single` is false, the
    // following segments are included as long as their direction is about the same. Returns the number of included
    // segments. The outline is empty if it covers nothing.
    std::int64_t outline(std::int64_t i, bool single, Outline& outline) noexcept {
        HRBFNPR_ASSERT(i >= 0 && i < list_.count);
        const drawing::Stroke& stroke = *list_.stroke;
        const std::int64_t number = list_.numbers[i];
        outline.clear();
        if (!start(number)) {
            if (number == first_) find_next(number, 1, next_);
            if (number == first_ && next_.number < 0) add_disc(outline);
            return 1;
        }
        const Leg first = leg_;
        const Joint begin = begin_;
        if (begin_.kind == Kind::cap)
            add_cap(leg_.a, leg_.radius_a, -1.0 * leg_.along, stroke.cap_begin, arcs_, outline);
        for (const bool left : {false, true}) add_side(leg_, false, left, outline);
        std::int64_t end = i + 1;
        for (;; ++end) {
            for (const bool left : {false, true}) add_side(leg_, true, left, outline);
            if (single || begin.kind == Kind::open || !outline.has_room() || !continues_outline(end, first)) break;
            advance();
            for (const bool left : {false, true})
                if (begin_.kind == Kind::round) add_side(leg_, false, left, outline);
        }
        if (end_.kind == Kind::cap) add_cap(leg_.b, leg_.radius_b, leg_.along, stroke.cap_end, arcs_, outline);
        outline.close();
        begin_ = begin;
        return end - i;
    }
    // Makes a round join at the beginning of the current segment if it overlaps the previous segment. Call it after
    // outline().
    bool join(Outline& outline) const noexcept {
        outline.clear();
        if (leg_.number < 0 || begin_.kind != Kind::open) return false;
        const double radius = std::max(previous_.radius_b, leg_.radius_a);
        const double side = begin_.left_outside ? 1.0 : -1.0;
        Place from = side * previous_.left();
        Place to = side * leg_.left();
        if (!begin_.left_outside) std::swap(from, to);
        outline.add(leg_.a);
        outline.add(leg_.a + radius * from);
        add_arc(leg_.a, radius, from, begin_.middle, arcs_, outline);
        outline.add(leg_.a + radius * begin_.middle);
        add_arc(leg_.a, radius, begin_.middle, to, arcs_, outline);
        outline.add(leg_.a + radius * to);
        return true;
    }
    // Returns whether the current outline overlaps that of an adjacent segment.
    [[nodiscard]] bool overlaps() const noexcept { return begin_.kind == Kind::open || end_.kind == Kind::open; }

private:
    enum class Kind : std::uint8_t { cap, shared, round, open };
    // A segment of positive length, with its unit direction.
    struct Leg {
        std::int64_t number = -1; // index of the segment in the list; -1: no segment
        Place a{}, b{};
        double radius_a = 0.0, radius_b = 0.0, length = 0.0, taper = 0.0;
        Place along{}; // unit vector from the first to the last point
        [[nodiscard]] Place left() const noexcept { return {along.y, -along.x}; }
    };
    // The place where two adjacent segments meet.
    struct Joint {
        Kind kind = Kind::cap;
        bool left_outside = false;
        // Whether the inner corner of the first segment lies outside the second segment, and whether that of the second
        // segment lies outside the first.
        bool corner_a = false, corner_b = false;
        // The ends of the edge that both segments' polygons share. For Kind::shared, `outer` is its left end.
        Place inner{}, outer{};
        Place middle{}; // unit vector from the centre to the middle of the outer arc
    };

    bool find_leg(std::int64_t number, Leg& leg) const noexcept {
        HRBFNPR_ASSERT(number >= first_ && number <= last_);
        const drawing::StrokePoint& p = list_.points[number];
        const drawing::StrokePoint& q = list_.points[number + 1];
        const Place origin{static_cast<double>(list_.left), static_cast<double>(list_.top)};
        leg.a = Place{static_cast<double>(p.x), static_cast<double>(p.y)} - origin;
        leg.b = Place{static_cast<double>(q.x), static_cast<double>(q.y)} - origin;
        leg.radius_a = static_cast<double>(p.radius);
        leg.radius_b = static_cast<double>(q.radius);
        const Place along = leg.b - leg.a;
        leg.length = std::sqrt(dot(along, along));
        leg.number = -1;
        if (!(leg.length > raster_tuning.same_point)) return false;
        const double scale = 1.0 / leg.length;
        leg.along = scale * along;
        leg.taper = scale * std::abs(leg.radius_b - leg.radius_a);
        leg.number = number;
        return true;
    }
    // Finds the next segment of positive length. It searches forwards if `step` is 1, and backwards if it is -1.
    void find_next(std::int64_t number, std::int64_t step, Leg& leg) const noexcept {
        HRBFNPR_ASSERT(step == 1 || step == -1);
        leg.number = -1;
        for (std::int64_t i = number + step; i >= first_ && i <= last_; i += step)
            if (find_leg(i, leg)) return;
        if (!list_.stroke->closed) return;
        for (std::int64_t i = step > 0 ? first_ : last_; i != number; i += step)
            if (find_leg(i, leg)) return;
    }
    // Finds where the inner edges of two legs meet. If the legs have different widths, the edges may miss each other;
    // then the function finds where the end of the wider leg meets the edge of the other leg. Returns false if they do
    // not meet within the halves of the legs near the joint.
    static bool find_inner_corner(const Leg& a, const Leg& b, double side, Joint& joint) noexcept {
        const Place from = a.a + side * a.radius_a * a.left();
        const Place corner_a = a.b + side * a.radius_b * a.left();
        const Place corner_b = b.a + side * b.radius_a * b.left();
        const Place edge_a = corner_a - from;
        const Place edge_b = b.b + side * b.radius_b * b.left() - corner_b;
        double back = 0.0;
        double on = 0.0;
        if (crossing(corner_a, edge_a, corner_b, edge_b, back, on) && -back <= 0.5 && -back >= -1e-9 && on <= 0.5 &&
            on >= -1e-9) {
            joint.inner = corner_a + back * edge_a;
            return cross(edge_a, edge_b) * side < 0.0; // false: both corners lie outside the other leg
        }
        const Place end_a = corner_a - b.a;
        if (crossing(b.a, end_a, corner_b, edge_b, back, on) && back >= 0.0 && back <= 1.0 && on >= 0.0 && on <= 0.5) {
            joint.corner_a = true;
            joint.inner = b.a + back * end_a;
            return true;
        }
        const Place end_b = corner_b - b.a;
        if (crossing(b.a, end_b, corner_a, edge_a, back, on) && back >= 0.0 && back <= 1.0 && -on >= 0.0 &&
            -on <= 0.5) {
            joint.corner_b = true;
            joint.inner = b.a + back * end_b;
            return true;
        }
        return false;
    }
    static void find_joint(const Leg& a, const Leg& b, Joint& joint) noexcept {
        joint.kind = Kind::cap;
        joint.corner_a = joint.corner_b = false;
        if (a.number < 0 || b.number < 0) return;
        const double cosine = dot(a.along, b.along);
        const double sine = cross(a.along, b.along);
        const double radius = b.radius_a;
        const double scale = 1.0 / std::max(1.0 + cosine, 1e-9);
        const double bend = std::abs(sine) * scale; // the tangent of half of the turning angle
        const bool fits = a.radius_b == radius && radius * bend <= 0.5 * std::min(a.length, b.length);
        joint.left_outside = sine >= 0.0;
        // The corner lies outside the arc over a length of 2 * reach. A pixel contains at most one pixel width of this
        // length.
        const double reach = radius * bend;
        const double taper = std::max(a.taper, b.taper);
        bool gentle = fits && reach * (0.5 * bend + taper) < raster_tuning.edge_tolerance;
        if (fits && !gentle) {
            const double part = std::min(reach / std::min({a.length, b.length, 1.0}), 1.0);
            gentle = reach * (0.5 * bend * part + taper) < raster_tuning.edge_tolerance;
        }
        if (gentle) {
            const Place miter = radius * scale * (a.left() + b.left());
            joint.kind = Kind::shared;
            joint.outer = b.a + miter;
            joint.inner = b.a - miter;
            return;
        }
        const double side = joint.left_outside ? 1.0 : -1.0;
        joint.middle = cosine > 0.0 ? unit(side * (a.left() + b.left())) : unit(a.along - b.along);
        joint.outer = b.a + radius * joint.middle;
        joint.kind = fits && find_inner_corner(a, b, -side, joint) ? Kind::round : Kind::open;
    }
    // Returns false if the segment has length 0.
    bool start(std::int64_t number) noexcept {
        if (leg_.number >= 0 && next_.number == number) {
            advance();
            return true;
        }
        begin_.kind = end_.kind = Kind::cap;
        if (!find_leg(number, leg_)) return false;
        find_next(number, -1, previous_);
        find_joint(previous_, leg_, begin_);
        find_next(number, 1, next_);
        find_joint(leg_, next_, end_);
        return true;
    }
    void advance() noexcept {
        previous_ = leg_;
        leg_ = next_;
        begin_ = end_;
        find_next(leg_.number, 1, next_);
        find_joint(leg_, next_, end_);
    }
    // Returns whether segment i of the list may continue the outline that began with `from`. Their opacities must be
    // equal up to same_opacity, and their directions must be within 60 degrees.
    bool continues_outline(std::int64_t i, const Leg& from) const noexcept {
        if (i == list_.count || std::int64_t{list_.numbers[i]} != next_.number || end_.kind == Kind::open) return false;
        const float opacity = list_.points[from.number].opacity;
        return std::abs(list_.points[next_.number].opacity - opacity) <= raster_tuning.same_opacity &&
               std::abs(list_.points[next_.number + 1].opacity - opacity) <= raster_tuning.same_opacity &&
               dot(from.along, next_.along) > 0.5;
    }
    // Adds the left or the right corner of a leg at its beginning or end.
    void add_side(const Leg& leg, bool at_end, bool left, Outline& outline) const noexcept {
        const Joint& joint = at_end ? end_ : begin_;
        const Place across = (left ? 1.0 : -1.0) * leg.left();
        const Place& centre = at_end ? leg.b : leg.a;
        const double radius = at_end ? leg.radius_b : leg.radius_a;
        const Place corner = centre + radius * across;
        if (joint.kind == Kind::shared) {
            const Place& edge = left ? joint.outer : joint.inner;
            if (at_end && outline.may_drop(edge, left)) outline.drop(left);
            outline.add(edge, left);
            if (at_end) ++outline.gentle[left ? 1 : 0];
            return;
        }
        if (at_end) outline.gentle[left ? 1 : 0] = 0;
        if (joint.kind != Kind::round) {
            outline.add(corner, left);
        } else if (left == joint.left_outside) {
            outline.add(at_end ? corner : joint.outer, left);
            add_arc(centre, radius, at_end ? across : joint.middle, at_end ? joint.middle : across, arcs_, outline,
                    left);
            outline.add(at_end ? joint.outer : corner, left);
        } else {
            if (at_end && joint.corner_a) outline.add(corner, left);
            outline.add(joint.inner, left);
            if (!at_end && joint.corner_b) outline.add(corner, left);
        }
    }
    // Adds a disc if all points of the stroke coincide and its ends are round.
    void add_disc(Outline& outline) const noexcept {
        const drawing::Stroke& stroke = *list_.stroke;
        if (!stroke.closed && stroke.cap_begin != drawing::Cap::round && stroke.cap_end != drawing::Cap::round) return;
        double radius = 0.0;
        for (std::int64_t i = first_; i <= last_ + 1; ++i)
            radius = std::max(radius, static_cast<double>(list_.points[i].radius));
        constexpr std::array<Place, 5> around{{{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}, {1.0, 0.0}}};
        for (std::size_t i = 0; i < 4; ++i) {
            outline.add(leg_.a + radius * around[i]);
            add_arc(leg_.a, radius, around[i], around[i + 1], arcs_, outline);
        }
    }

    const SegmentList& list_;
    double arcs_;               // factor that multiplies the tolerance of arcs
    std::int64_t first_, last_; // the stroke's first and last segment
    Leg previous_, leg_, next_;
    Joint begin_, end_;
};

// ---- Unions of outlines

// The opacity and depth of a segment over the pixels that it covers. They change linearly along the segment.
struct Shade {
    // Position along the segment, in [0, 1], at a pixel: from + step_x * x + step_y * y.
    float from, step_x, step_y;
    float opacity, more_opacity;
    float window, more_window;
};

// Computes exactly the area of each pixel that overlapping outlines of a stroke cover together, row by row. A row is
// cut into slabs at the heights where edges begin, end or cross. Within a slab the order of the edges does not change,
// and the areas are trapezoids. A place is inside if its winding number is not 0. Each worker has its own object.
class alignas(base::Memory::alignment) StrokeUnion {
public:
    static constexpr std::int32_t most_side = 64; // the largest width and height of a tile, in pixels

    explicit StrokeUnion(base::Memory& memory)
        : edges_(memory), shades_(memory), winding_(memory), active_(memory), pieces_(memory), breaks_(memory),
          order_(memory), inside_(memory), spans_(memory), row_shades_(memory) {
        // Room for the edges of a usual tile.
        edges_.reserve(2048);
        spans_.reserve(1024);
        for (base::Array<std::int32_t>* const numbers : {&winding_, &active_, &order_, &inside_, &row_shades_})
            numbers->reserve(512);
        shades_.reserve(512);
        pieces_.reserve(512);
        breaks_.reserve(raster_tuning.most_breaks + 1);
    }
    // Starts a tile. If several outlines cover a place, it belongs to the nearest outline if `by_depth` is set, else to
    // the first one.
    void begin(std::int32_t width, std::int32_t height, bool by_depth) noexcept {
        HRBFNPR_ASSERT(width > 0 && width <= most_side && height > 0 && height <= most_side);
        width_ = width;
        height_ = height;
        by_depth_ = by_depth;
        top_ = height;
        bottom_ = 0;
        edges_.clear();
        shades_.clear();
        winding_.clear();
        active_.clear();
        std::fill_n(first_, height, -1);
    }
    // Adds the edges of an outline. Edges to the right of the tile are dropped, and edges to the left are moved to its
    // left side. Throws Error{out_of_memory}.
    void add(const Outline& outline, const Shade& shade) {
        if (outline.count == 0) return;
        if (shades_.empty() || !same_shade(shades_.back(), shade)) {
            shades_.push_back(shade);
            winding_.push_back(0);
        }
        const double height = static_cast<double>(height_);
        const auto number = static_cast<std::int32_t>(shades_.size() - 1);
        Place from = outline.at[outline.count - 1];
        for (std::int32_t i = 0; i < outline.count; ++i) {
            const Place to = outline.at[i];
            const bool down = from.y < to.y;
            const Place upper = down ? from : to;
            const Place lower = down ? to : from;
            from = to;
            const double top = std::max(upper.y, 0.0);
            const double bottom = std::min(lower.y, height);
            if (!(top < bottom)) continue;
            double slope = (lower.x - upper.x) / (lower.y - upper.y);
            double x = upper.x + (top - upper.y) * slope;
            const double end = x + (bottom - top) * slope;
            if (std::min(x, end) >= static_cast<double>(width_)) continue;
            if (std::max(x, end) <= 0.0) x = slope = 0.0;
            const std::int32_t row = row_of(top, height_ - 1);
            edges_.push_back({x, top, bottom, slope, down ? -1 : 1, number, first_[row]});
            first_[row] = static_cast<std::int32_t>(edges_.size() - 1);
            top_ = std::min(top_, row);
            bottom_ = std::max(bottom_, row_of(std::ceil(bottom), height_));
        }
    }
    [[nodiscard]] std::int32_t top() const noexcept { return top_; }
    [[nodiscard]] std::int32_t bottom() const noexcept { return bottom_; }
    // Finds the shades in a row, and the pixels that each covers. Returns the number of shades. Call it for all rows in
    // order, from top() to bottom().
    std::int32_t cut(std::int32_t y) {
        HRBFNPR_ASSERT(y >= 0 && y < height_);
        spans_.clear();
        row_shades_.clear();
        find_pieces(y);
        find_breaks(y);
        for (std::int64_t i = 0; i + 1 < breaks_.size(); ++i)
            if (breaks_[i + 1] - breaks_[i] > raster_tuning.least_slab_height) add_slab(breaks_[i], breaks_[i + 1]);
        std::sort(row_shades_.begin(), row_shades_.end());
        return static_cast<std::int32_t>(row_shades_.size());
    }
    // Writes, for each pixel from `left` to `right`, the share that belongs to the row's i-th shade.
    const Shade& cover(std::int32_t i, float* pixels, std::int32_t& left, std::int32_t& right) noexcept {
        HRBFNPR_ASSERT(i >= 0 && i < row_shades_.size());
        const std::int32_t shade = row_shades_[i];
        std::fill_n(steps_, width_ + 2, 0.0);
        double low = static_cast<double>(width_);
        double high = 0.0;
        for (const Span& s : spans_) {
            if (s.shade != shade) continue;
            add_edge(s.left_top, s.left_bottom, s.height);
            add_edge(s.right_top, s.right_bottom, -s.height);
            low = std::min({low, s.left_top, s.left_bottom});
            high = std::max({high, s.right_top, s.right_bottom});
        }
        left = row_of(low, width_);
        right = row_of(std::ceil(high), width_);
        double sum = 0.0;
        for (std::int32_t x = 0; x < left; ++x) sum += steps_[x];
        for (std::int32_t x = left; x < right; ++x) {
            sum += steps_[x];
            pixels[x - left] = static_cast<float>(std::clamp(sum, 0.0, 1.0));
        }
        return shades_[shade];
    }

private:
    // An edge, stored from its upper end to its lower end.
    struct Edge {
        double x, top, bottom, slope;
        std::int32_t winding; // the winding number to the right of the edge minus the one to its left
        std::int32_t shade;
        std::int32_t next; // the next edge that begins in the same row; -1: none
    };
    // The part of an edge in the current row.
    struct Piece {
        // The y of the upper end and of the lower end; the x of the edge's line at y = 0 in the tile; and the change of
        // x per unit of y.
        double upper, lower, x, slope;
        double low, high; // the range of x in the row
        std::int32_t winding, shade;
        double slab_x; // x in the middle of the current slab
        [[nodiscard]] double at(double y) const noexcept { return x + y * slope; }
    };
    // A trapezoid between two edges, from one height to another.
    struct Span {
        double left_top, left_bottom, right_top, right_bottom, height;
        std::int32_t shade;
    };

    [[nodiscard]] static std::int32_t row_of(double y, std::int32_t rows) noexcept {
        return static_cast<std::int32_t>(std::clamp(y, 0.0, static_cast<double>(rows)));
    }
    // Returns whether two outlines can share a shade, because they have the same constant opacity.
    bool same_shade(const Shade& a, const Shade& b) const noexcept {
        return !by_depth_ && a.more_opacity == 0.0F && b.more_opacity == 0.0F && a.opacity == b.opacity;
    }
    // Finds the parts of edges in a row. active_ keeps edges that continue into the next row.
    void find_pieces(std::int32_t y) {
        const double top = static_cast<double>(y);
        for (std::int32_t e = first_[y]; e >= 0; e = edges_[e].next) active_.push_back(e);
        pieces_.clear();
        std::int64_t kept = 0;
        for (const std::int32_t number : active_) {
            const Edge& e = edges_[number];
            const double upper = std::max(e.top, top);
            const double lower = std::min(e.bottom, top + 1.0);
            const double a = e.x + (upper - e.top) * e.slope;
            const double b = e.x + (lower - e.top) * e.slope;
            pieces_.push_back({upper, lower, e.x - e.top * e.slope, e.slope, std::min(a, b), std::max(a, b), e.winding,
                               e.shade, 0.0});
            if (e.bottom > top + 1.0) active_[kept++] = number;
        }
        active_.resize(kept);
        std::sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
            if (a.low != b.low) return a.low < b.low;
            return a.upper != b.upper ? a.upper < b.upper : a.slope < b.slope;
        });
    }
    void add_crossings() {
        for (std::int64_t i = 0; i < pieces_.size(); ++i) {
            const Piece& a = pieces_[i];
            for (std::int64_t k = i + 1; k < pieces_.size() && pieces_[k].low < a.high; ++k) {
                const Piece& b = pieces_[k];
                const double from = std::max(a.upper, b.upper);
                const double to = std::min(a.lower, b.lower);
                if (!(from < to)) continue;
                const double before = a.at(from) - b.at(from);
                const double after = a.at(to) - b.at(to);
                if (before * after < 0.0) breaks_.push_back(from + (to - from) * (before / (before - after)));
                if (breaks_.size() > raster_tuning.most_breaks) return;
            }
        }
    }
    // Finds the heights of the row at which edges begin, end or cross, in ascending order.
    void find_breaks(std::int32_t y) {
        breaks_.clear();
        for (const Piece& p : pieces_) {
            breaks_.push_back(p.upper);
            breaks_.push_back(p.lower);
        }
        if (breaks_.size() <= raster_tuning.most_breaks) add_crossings();
        if (breaks_.size() > raster_tuning.most_breaks) {
            breaks_.clear();
            for (int k = 0; k <= raster_tuning.most_breaks; ++k)
                breaks_.push_back(static_cast<double>(y) + k / double{raster_tuning.most_breaks});
        }
        std::sort(breaks_.begin(), breaks_.end());
    }
    // Returns the shade that owns a place, among all shades that cover it.
    std::int32_t owning_shade(double x, double y) const noexcept {
        std::int32_t best = inside_[0];
        float nearest = 0.0F;
        for (std::int64_t i = 0; i < inside_.size(); ++i) {
            if (!by_depth_) {
                best = std::min(best, inside_[i]);
                continue;
            }
            const Shade& s = shades_[inside_[i]];
            const float along =
                std::clamp(s.from + static_cast<float>(x) * s.step_x + static_cast<float>(y) * s.step_y, 0.0F, 1.0F);
            const float window = s.window + along * s.more_window;
            if (i > 0 && !(window < nearest || (window == nearest && inside_[i] < best))) continue;
            best = inside_[i];
            nearest = window;
        }
        return best;
    }
    void add_span(const Piece& left, const Piece& right, double from, double to, std::int32_t shade) {
        spans_.push_back({left.at(from), left.at(to), right.at(from), right.at(to), to - from, shade});
        if (std::find(row_shades_.begin(), row_shades_.end(), shade) == row_shades_.end()) row_shades_.push_back(shade);
    }
    // Sorts the pieces of a slab from left to right by insertion. The pieces are already sorted by their leftmost
    // places, so few of them move.
    void find_order(double y) {
        order_.clear();
        for (std::int32_t number = 0; number < pieces_.size(); ++number) {
            Piece& piece = pieces_[number];
            if (!(piece.upper <= y && y < piece.lower)) continue;
            piece.slab_x = piece.at(y);
            order_.push_back(number);
            std::int64_t k = order_.size() - 1;
            for (; k > 0 && pieces_[order_[k - 1]].slab_x > piece.slab_x; --k) order_[k] = order_[k - 1];
            order_[k] = number;
        }
    }
    // Updates the winding number of a shade when the sweep crosses an edge of its outline.
    void update_winding(std::int32_t shade, std::int32_t by) {
        const bool was_inside = winding_[shade] != 0;
        winding_[shade] += by;
        const bool is_inside = winding_[shade] != 0;
        if (was_inside == is_inside) return;
        if (is_inside) {
            inside_.push_back(shade);
            return;
        }
        *std::find(inside_.begin(), inside_.end(), shade) = inside_.back();
        inside_.resize(inside_.size() - 1);
    }
    // Adds the trapezoids of the slab between two consecutive breaks.
    void add_slab(double from, double to) {
        const double middle = 0.5 * (from + to);
        find_order(middle);
        inside_.clear();
        const Piece* left = nullptr;
        std::int32_t whose = -1;
        for (const std::int32_t number : order_) {
            const Piece& piece = pieces_[number];
            update_winding(piece.shade, piece.winding);
            const std::int32_t now = inside_.empty() ? -1 : owning_shade(piece.slab_x, middle);
            if (now == whose) continue;
            if (whose >= 0) add_span(*left, piece, from, to, whose);
            left = &piece;
            whose = now;
        }
        // A sentinel edge to the right of the tile. It ends the last trapezoid, because add() drops edges to the right
        // of the tile.
        constexpr Piece beyond{0.0, 0.0, 1e9, 0.0, 1e9, 1e9, 0, 0, 1e9};
        if (whose >= 0) add_span(*left, beyond, from, to, whose);
        for (const std::int32_t shade : inside_) winding_[shade] = 0;
    }
    // Adds the area to the right of an edge that goes from x0 to x1 over `height`. steps_ stores differences between
    // adjacent pixels.
    void add_edge(double x0, double x1, double height) noexcept {
        double low = std::min(x0, x1);
        double high = std::max(x0, x1);
        const double wide = static_cast<double>(width_);
        if (low >= wide) return;
        const double scale = high > low ? height / (high - low) : 0.0; // height per pixel of width
        if (high <= 0.0) {
            steps_[0] += height;
            return;
        }
        if (low < 0.0) {
            steps_[0] -= low * scale;
            height += low * scale;
            low = 0.0;
        }
        if (high > wide) {
            height -= (high - wide) * scale;
            high = wide;
        }
        const auto first = static_cast<std::int32_t>(low);
        const auto last = static_cast<std::int32_t>(high);
        // The edge lies within one column of pixels. Adds the mean area to the right of the edge.
        if (first == last || first + 1 >= width_ + 1) {
            const double beyond = 0.5 * (low + high) - first;
            steps_[first] += height * (1.0 - beyond);
            steps_[first + 1] += height * beyond;
            return;
        }
        for (std::int32_t c = first; c <= last && static_cast<double>(c) < high; ++c) {
            const double from = std::max(low, static_cast<double>(c));
            const double to = std::min(high, static_cast<double>(c) + 1.0);
            const double beyond = 0.5 * (from + to) - c;
            steps_[c] += (to - from) * scale * (1.0 - beyond);
            steps_[c + 1] += (to - from) * scale * beyond;
        }
    }

    std::int32_t width_ = 0, height_ = 0, top_ = 0, bottom_ = 0;
    bool by_depth_ = false;
    base::Array<Edge> edges_;
    base::Array<Shade> shades_;
    base::Array<std::int32_t> winding_; // for each shade, the winding number of its outlines at the current place
    std::int32_t first_[most_side];     // the first edge that begins in each row; -1: none
    base::Array<std::int32_t> active_;  // edges that cross the row
    base::Array<Piece> pieces_;
    base::Array<double> breaks_;
    base::Array<std::int32_t> order_;  // the indices of the pieces in a slab, from left to right
    base::Array<std::int32_t> inside_; // shades whose winding number is not 0
    base::Array<Span> spans_;
    base::Array<std::int32_t> row_shades_; // the shades of the row
    double steps_[most_side + 2];          // the coverage of each pixel minus that of its left neighbour
};

} // namespace hrbfnpr::output
