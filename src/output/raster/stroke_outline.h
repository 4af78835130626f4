// SPDX-License-Identifier: MIT
// The area that a stroke covers, as polygons side by side: one for each segment.
#pragma once

#include "base/assert.h"
#include "drawing/dot.h"

#include <cstdint>

namespace hrbfnpr::output {

// One stroke's segments that reach a tile, by the numbers of their first points, which ascend.
struct SegmentList {
    const drawing::StrokePoint* points;
    const drawing::Stroke* stroke;
    const std::uint32_t* numbers;
    std::int64_t count;
    float left, top;    // the tile's first pixel
    const float* color; // RGB of the ink, and its alpha; the RGB is not read where the tile has no colour
    float toward;       // as in InkList
};

struct Place {
    double x, y; // pixels of the tile
};

// A polygon that goes round so that with y down its inside lies to the right: up along the left side of a line, and
// back along its right side, which is filled from the other end of the array.
struct Outline {
    static constexpr std::int32_t most = 416;
    static constexpr std::int32_t most_of_a_leg = 140; // two quarters of 64 chords each, and corners
    std::int32_t count = 0, back = most;
    std::int32_t gentle[2] = {0, 0}; // the numbers of last places, right and left, that belong to gentle turns
    Place at[most];

    void clear() noexcept {
        count = gentle[0] = gentle[1] = 0;
        back = most;
    }
    // Whether the last place lies on the line from the place before it to the next one.
    [[nodiscard]] bool may_drop(const Place& next, bool left) const noexcept;
    void drop(bool left) noexcept { left ? --count : ++back; }
    void add(const Place& place, bool left = true) noexcept {
        HRBFNPR_ASSERT(count < back);
        at[left ? count++ : --back] = place;
    }
    [[nodiscard]] bool has_room() const noexcept { return back - count > 2 * most_of_a_leg; }
    // Brings both sides together once all is there.
    void close() noexcept {
        for (; back < most; ++back) at[count++] = at[back];
    }
};

// Makes the outlines of a stroke's segments. Consecutive segments that turn gently share the edge that halves their
// angle, so that their polygons neither overlap nor leave a gap. Where a turn is too sharp for its segments' lengths
// they end across the line instead, and overlap.
class Outliner {
public:
    // overlap: whether outlines may lie upon each other.
    Outliner(const SegmentList& list, bool overlap) noexcept;

    // Makes the outline of the list's segment i, with its part of joins and caps, and unless it is to be a single one
    // with the segments after it that go on alike. Returns the number of these segments. An empty outline covers
    // nothing.
    std::int64_t outline(std::int64_t i, bool single, Outline& outline) noexcept;
    // After outline(): makes what rounds the beginning off, if it overlaps the segment before.
    bool join(Outline& outline) const noexcept;
    // Whether the outline overlaps a neighbour's.
    [[nodiscard]] bool overlaps() const noexcept { return begin_.kind == Kind::open || end_.kind == Kind::open; }

private:
    enum class Kind : std::uint8_t { cap, shared, round, open };
    // A segment with a length.
    struct Leg {
        std::int64_t number = -1; // -1: no such segment
        Place a{}, b{};
        double radius_a = 0.0, radius_b = 0.0, length = 0.0, taper = 0.0;
        Place along{}; // unit
        [[nodiscard]] Place left() const noexcept { return {along.y, -along.x}; }
    };
    // Where two legs meet.
    struct Joint {
        Kind kind = Kind::cap;
        bool left_outside = false;
        bool corner_a = false, corner_b = false; // whether the inner corner of one stands out from the other
        Place inner{}, outer{};                  // the edge that both share; of Kind::shared, its left end is `outer`
        Place middle{};                          // the unit vector from the centre to the middle of the outer arc
    };

    bool find_leg(std::int64_t number, Leg& leg) const noexcept;
    void find_next(std::int64_t number, std::int64_t step, Leg& leg) const noexcept;
    static void find_joint(const Leg& a, const Leg& b, Joint& joint) noexcept;
    [[nodiscard]] static bool meet(const Leg& a, const Leg& b, double side, Joint& joint) noexcept;
    bool start(std::int64_t number) noexcept;
    void go_on() noexcept;
    [[nodiscard]] bool goes_on(std::int64_t i, const Leg& from) const noexcept;
    void add_side(const Leg& leg, bool at_end, bool left, Outline& outline) const noexcept;
    void disc(Outline& outline) const noexcept;

    const SegmentList& list_;
    double arcs_;               // the tolerance of arcs, in parts of the usual one
    std::int64_t first_, last_; // the stroke's first and last segment
    Leg previous_, leg_, next_;
    Joint begin_, end_;
};

// Whether parts of the stroke that do not follow each other may overlap in the tile.
[[nodiscard]] bool may_overlap(const SegmentList& list) noexcept;

} // namespace hrbfnpr::output
