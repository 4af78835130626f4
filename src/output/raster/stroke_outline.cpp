// SPDX-License-Identifier: MIT
#include "output/raster/stroke_outline.h"

#include "base/assert.h"
#include "output/raster/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <tuple>
#include <utility>

namespace hrbfnpr::output {
namespace {

using drawing::Cap;
using drawing::StrokePoint;

Place operator+(const Place& a, const Place& b) noexcept { return {a.x + b.x, a.y + b.y}; }
Place operator-(const Place& a, const Place& b) noexcept { return {a.x - b.x, a.y - b.y}; }
Place operator*(double s, const Place& a) noexcept { return {s * a.x, s * a.y}; }
double dot(const Place& a, const Place& b) noexcept { return a.x * b.x + a.y * b.y; }
double cross(const Place& a, const Place& b) noexcept { return a.x * b.y - a.y * b.x; }
Place unit(const Place& a) noexcept { return (1.0 / std::sqrt(dot(a, a))) * a; }

// Adds the corners of an arc of at most a right angle between unit vectors, without its ends, which lie on it. The
// others lie outside, so that the area is kept. Square roots and quotients are the same on all processors.
void add_arc(const Place& centre, double radius, const Place& from, const Place& to, double scale, Outline& outline,
             bool left = true) noexcept {
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

// Adds what stands out of an end in the direction `out`, from one corner of the end to the other.
void add_cap(const Place& centre, double radius, const Place& out, Cap cap, double scale, Outline& outline) noexcept {
    const Place from{out.y, -out.x};
    if (cap == Cap::round) {
        add_arc(centre, radius, from, out, scale, outline);
        outline.add(centre + radius * out);
        add_arc(centre, radius, out, -1.0 * from, scale, outline);
    } else if (cap == Cap::pointed) {
        outline.add(centre + 2.0 * static_cast<double>(drawing::point_length) * radius * out);
    }
}

// Finds where two lines cross: at + s * along = other + t * direction.
bool crossing(const Place& at, const Place& along, const Place& other, const Place& direction, double& s,
              double& t) noexcept {
    const double sine = cross(along, direction);
    if (!(std::abs(sine) > 1e-9 * std::abs(dot(along, direction)))) return false;
    s = cross(other - at, direction) / sine;
    t = cross(other - at, along) / sine;
    return true;
}

} // namespace

bool Outline::may_drop(const Place& next, bool left) const noexcept {
    const std::int32_t passed = gentle[left ? 1 : 0];
    if (passed % 4 == 0) return false; // each fourth stays, since what dropped ones are off adds up
    const Place& last = at[left ? count - 1 : back];
    const Place& before = at[left ? count - 2 : back + 1];
    const Place along = next - before;
    const double off = cross(along, last - before);
    return off * off <= raster_tuning.edge_tolerance * raster_tuning.edge_tolerance * dot(along, along);
}

Outliner::Outliner(const SegmentList& list, bool overlap) noexcept
    : list_(list), arcs_(overlap ? raster_tuning.finer : 1.0), first_(list.stroke->first),
      last_(list.stroke->first + list.stroke->count - 2) {}

bool Outliner::find_leg(std::int64_t number, Leg& leg) const noexcept {
    HRBFNPR_ASSERT(number >= first_ && number <= last_);
    const StrokePoint& p = list_.points[number];
    const StrokePoint& q = list_.points[number + 1];
    const Place origin{static_cast<double>(list_.left), static_cast<double>(list_.top)};
    leg.a = Place{static_cast<double>(p.x), static_cast<double>(p.y)} - origin;
    leg.b = Place{static_cast<double>(q.x), static_cast<double>(q.y)} - origin;
    leg.radius_a = static_cast<double>(p.radius);
    leg.radius_b = static_cast<double>(q.radius);
    const Place along = leg.b - leg.a;
    leg.length = std::sqrt(dot(along, along));
    leg.number = -1;
    if (!(leg.length > raster_tuning.nowhere)) return false;
    const double scale = 1.0 / leg.length;
    leg.along = scale * along;
    leg.taper = scale * std::abs(leg.radius_b - leg.radius_a);
    leg.number = number;
    return true;
}

// Finds the next leg with a length from a segment on, or back for a step of -1.
void Outliner::find_next(std::int64_t number, std::int64_t step, Leg& leg) const noexcept {
    HRBFNPR_ASSERT(step == 1 || step == -1);
    leg.number = -1;
    for (std::int64_t i = number + step; i >= first_ && i <= last_; i += step)
        if (find_leg(i, leg)) return;
    if (!list_.stroke->closed) return;
    for (std::int64_t i = step > 0 ? first_ : last_; i != number; i += step)
        if (find_leg(i, leg)) return;
}

// Finds where the inner edges of two legs meet. Where the width changes they may pass each other by: then the wider
// one's end reaches the other's edge. Returns false if they meet beyond the halves that face each other.
bool Outliner::meet(const Leg& a, const Leg& b, double side, Joint& joint) noexcept {
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
        return cross(edge_a, edge_b) * side < 0.0; // else both corners stand out
    }
    const Place end_a = corner_a - b.a;
    if (crossing(b.a, end_a, corner_b, edge_b, back, on) && back >= 0.0 && back <= 1.0 && on >= 0.0 && on <= 0.5) {
        joint.corner_a = true;
        joint.inner = b.a + back * end_a;
        return true;
    }
    const Place end_b = corner_b - b.a;
    if (crossing(b.a, end_b, corner_a, edge_a, back, on) && back >= 0.0 && back <= 1.0 && -on >= 0.0 && -on <= 0.5) {
        joint.corner_b = true;
        joint.inner = b.a + back * end_b;
        return true;
    }
    return false;
}

void Outliner::find_joint(const Leg& a, const Leg& b, Joint& joint) noexcept {
    joint.kind = Kind::cap;
    joint.corner_a = joint.corner_b = false;
    if (a.number < 0 || b.number < 0) return;
    const double cosine = dot(a.along, b.along);
    const double sine = cross(a.along, b.along);
    const double radius = b.radius_a;
    const double scale = 1.0 / std::max(1.0 + cosine, 1e-9);
    const double bend = std::abs(sine) * scale; // the tangent of half the turn
    const bool fits = a.radius_b == radius && radius * bend <= 0.5 * std::min(a.length, b.length);
    joint.left_outside = sine >= 0.0;
    // The corner stands out of the arc over twice this length, of which a pixel has at most its own.
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
    joint.kind = fits && meet(a, b, -side, joint) ? Kind::round : Kind::open;
}

// Adds one side of a leg's beginning or end, in the leg's direction.
void Outliner::add_side(const Leg& leg, bool at_end, bool left, Outline& outline) const noexcept {
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
        add_arc(centre, radius, at_end ? across : joint.middle, at_end ? joint.middle : across, arcs_, outline, left);
        outline.add(at_end ? joint.outer : corner, left);
    } else {
        if (at_end && joint.corner_a) outline.add(corner, left);
        outline.add(joint.inner, left);
        if (!at_end && joint.corner_b) outline.add(corner, left);
    }
}

// A stroke all of whose points stand in one place is a disc if it ends round.
void Outliner::disc(Outline& outline) const noexcept {
    const drawing::Stroke& stroke = *list_.stroke;
    if (!stroke.closed && stroke.cap_begin != Cap::round && stroke.cap_end != Cap::round) return;
    double radius = 0.0;
    for (std::int64_t i = first_; i <= last_ + 1; ++i)
        radius = std::max(radius, static_cast<double>(list_.points[i].radius));
    constexpr std::array<Place, 5> around{{{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}, {1.0, 0.0}}};
    for (std::size_t i = 0; i < 4; ++i) {
        outline.add(leg_.a + radius * around[i]);
        add_arc(leg_.a, radius, around[i], around[i + 1], arcs_, outline);
    }
}

// Returns false if the segment has no length.
bool Outliner::start(std::int64_t number) noexcept {
    if (leg_.number >= 0 && next_.number == number) {
        go_on();
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

void Outliner::go_on() noexcept {
    previous_ = leg_;
    leg_ = next_;
    begin_ = end_;
    find_next(leg_.number, 1, next_);
    find_joint(leg_, next_, end_);
}

// Whether the list's segment i continues an outline that began with `from`: it has the same opacity, but for less than
// can be seen, and about the same direction.
bool Outliner::goes_on(std::int64_t i, const Leg& from) const noexcept {
    if (i == list_.count || std::int64_t{list_.numbers[i]} != next_.number || end_.kind == Kind::open) return false;
    const float opacity = list_.points[from.number].opacity;
    return std::abs(list_.points[next_.number].opacity - opacity) <= raster_tuning.same_opacity &&
           std::abs(list_.points[next_.number + 1].opacity - opacity) <= raster_tuning.same_opacity &&
           dot(from.along, next_.along) > 0.5;
}

std::int64_t Outliner::outline(std::int64_t i, bool single, Outline& outline) noexcept {
    HRBFNPR_ASSERT(i >= 0 && i < list_.count);
    const drawing::Stroke& stroke = *list_.stroke;
    const std::int64_t number = list_.numbers[i];
    outline.clear();
    if (!start(number)) {
        if (number == first_) find_next(number, 1, next_);
        if (number == first_ && next_.number < 0) disc(outline);
        return 1;
    }
    const Leg first = leg_;
    const Joint begin = begin_;
    if (begin_.kind == Kind::cap) add_cap(leg_.a, leg_.radius_a, -1.0 * leg_.along, stroke.cap_begin, arcs_, outline);
    for (const bool left : {false, true}) add_side(leg_, false, left, outline);
    std::int64_t end = i + 1;
    for (;; ++end) {
        for (const bool left : {false, true}) add_side(leg_, true, left, outline);
        if (single || begin.kind == Kind::open || !outline.has_room() || !goes_on(end, first)) break;
        go_on();
        for (const bool left : {false, true})
            if (begin_.kind == Kind::round) add_side(leg_, false, left, outline);
    }
    if (end_.kind == Kind::cap) add_cap(leg_.b, leg_.radius_b, leg_.along, stroke.cap_end, arcs_, outline);
    outline.close();
    begin_ = begin;
    return end - i;
}

bool Outliner::join(Outline& outline) const noexcept {
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

namespace {

// Consecutive segments whose directions lie within 60 degrees of the first one's, and their extent.
struct Stretch {
    float along_x, along_y, square; // the first segment's vector, pixels, and the square of its length
    float left, top, right, bottom;
    std::int64_t begin, end; // segments

    [[nodiscard]] bool takes(float x, float y, std::int64_t number) const noexcept {
        const float cosine = x * along_x + y * along_y;
        return number == end && cosine >= 0.0F && cosine * cosine >= 0.25F * square * (x * x + y * y);
    }
    // Whether a turn from the one to the other is less than 120 degrees.
    [[nodiscard]] bool goes_on_in(const Stretch& next) const noexcept {
        const float cosine = along_x * next.along_x + along_y * next.along_y;
        return cosine > 0.0F || cosine * cosine < 0.25F * square * next.square;
    }
    [[nodiscard]] bool is_apart_from(const Stretch& other) const noexcept {
        return right < other.left || other.right < left || bottom < other.top || other.bottom < top;
    }
    void reach(const StrokePoint& p, float radius) noexcept {
        left = std::min(left, p.x - radius);
        top = std::min(top, p.y - radius);
        right = std::max(right, p.x + radius);
        bottom = std::max(bottom, p.y + radius);
    }
};

bool follow(const Stretch& a, const Stretch& b, const drawing::Stroke& stroke) noexcept {
    const bool around = stroke.closed && a.begin == stroke.first && b.end == stroke.first + stroke.count - 1;
    return a.end == b.begin ? a.goes_on_in(b) : around && b.goes_on_in(a);
}

using Stretches = std::array<Stretch, 12>;

// Returns the number of the list's stretches, which is size() + 1 if there is no room for all.
std::size_t find_stretches(const SegmentList& list, Stretches& stretches) noexcept {
    std::size_t count = 0;
    for (std::int64_t i = 0; i < list.count; ++i) {
        const std::int64_t number = list.numbers[i];
        const StrokePoint& a = list.points[number];
        const StrokePoint& b = list.points[number + 1];
        const float x = b.x - a.x;
        const float y = b.y - a.y;
        if (count == 0 || !stretches[count - 1].takes(x, y, number)) {
            if (count == stretches.size()) return count + 1;
            stretches[count++] = {x, y, x * x + y * y, a.x, a.y, a.x, a.y, number, number};
        }
        Stretch& last = stretches[count - 1];
        if (last.square == 0.0F) std::tie(last.along_x, last.along_y, last.square) = std::tuple(x, y, x * x + y * y);
        last.end = number + 1;
    }
    return count;
}

} // namespace

bool may_overlap(const SegmentList& list) noexcept {
    Stretches stretches;
    const std::size_t count = find_stretches(list, stretches);
    if (count <= 1 || count > stretches.size()) return count > 1;
    const bool pointed = list.stroke->cap_begin == Cap::pointed || list.stroke->cap_end == Cap::pointed;
    const float widest = pointed ? std::max(1.0F, 2.0F * drawing::point_length) : 1.0F; // a tip reaches farther
    for (Stretch& stretch : std::span(stretches).first(count))
        for (std::int64_t i = stretch.begin; i <= stretch.end; ++i)
            stretch.reach(list.points[i], widest * list.points[i].radius + 1.0F); // no pixel has a part of two
    for (std::size_t i = 0; i < count; ++i)
        for (std::size_t j = i + 1; j < count; ++j)
            if (!follow(stretches[i], stretches[j], *list.stroke) && !stretches[i].is_apart_from(stretches[j]))
                return true;
    return false;
}

} // namespace hrbfnpr::output
