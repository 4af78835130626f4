// SPDX-License-Identifier: MIT
// Where along its stroke a line of hatching is drawn, and its points there.
#pragma once

#include "frame/depth_layers/hatch_hand.h"
#include "frame/depth_layers/hatch_marks.h"

namespace hrbfnpr::frame {

inline constexpr float hatch_point_step = 2.75F; // from one point of a line to the next, pixels

// A part of a line that is drawn, before it is asked what hides it.  Its points follow each other at about even steps.
struct HatchSpan {
    std::int64_t first = 0; // of its points
    std::int32_t count = 0;
    float taper_begin = 0.0F, taper_end = 0.0F; // pixels
    float fade = 1.0F;                          // of its width: short ones are thin
    bool closed = false;                        // its last point is its first one
};

// Points of lines before they are dots.
struct HatchPoint {
    float x, y, window, depth, pixels_per_unit;
    float width;
    std::uint32_t id; // of the nearest mark
};

struct HatchPart {
    explicit HatchPart(base::Memory& memory) noexcept : spans(memory), points(memory) {}

    base::Array<HatchSpan> spans;
    base::Array<HatchPoint> points;

    [[nodiscard]] std::int64_t bytes() const noexcept { return spans.bytes() + points.bytes(); }
};

// Of one stroke after the other.
class HatchSpans {
public:
    explicit HatchSpans(base::Memory& memory) noexcept : length_(memory), drawn_(memory), dips_(memory) {}

    // Adds what is drawn of the stroke of that number; one that is closed ends with its first mark, and may be turned.
    void add(const LayerStyle& style, std::int64_t number, HatchStroke& stroke, HatchPart& part);

    [[nodiscard]] std::int64_t bytes() const noexcept { return length_.bytes() + drawn_.bytes() + dips_.bytes(); }

private:
    // A place between a mark and the next one.
    struct Place {
        std::int64_t mark;
        float share;
    };
    // How much an end is one of a level.
    struct ByLevel {
        float alone = 0.0F;             // 1: its level's alone, 0: another margin runs out, too
        HatchEnd other = HatchEnd::rim; // which
        float near = 0.0F;              // 1: its level ends it, 0: this is far from doing so where the stroke ends
    };
    // A gap between two parts that the line goes on over.
    struct Dip {
        float begin, end;             // lengths
        float taper_end, taper_begin; // of the part before it and of the one behind it
        float link;

        [[nodiscard]] float middle() const noexcept { return 0.5F * (begin + end); }
    };
    struct Drawn {
        Place begin, end;
        HatchEnd begins = HatchEnd::line, ends = HatchEnd::line;
        ByLevel begins_by, ends_by;
        bool closed = false;
        float firm = 0.0F;       // the most firmness of its marks
        float area = 0.0F;       // of its ink, as far as its length may be too short, ...
        float widest = 0.0F;     // ... and how wide that is at most
        float open = 1.0F;       // of the gap before it: the most openness() of its marks, ...
        float level_gap = 0.0F;  // ... how far they are from being without tone or facing away, too, ...
        float closes = 0.0F;     // ... up to which length, pixels, the line goes on over it ...
        float link = 0.0F;       // ... and whether it does: 0 open, 1 closed
        float near = 0.0F;       // the same of wider gaps
        float fade = 1.0F;       // of its width
        std::int64_t joined = 1; // it and those that the line goes on with
    };

    void find(const HatchStroke& stroke, bool closed);
    void weigh(const LayerStyle& style, std::span<const HatchMark> marks, Drawn& drawn) const noexcept;
    // What lies beside a part: as much of what is behind the next one as that is about to vanish, since then the gap
    // is one with the next.
    struct Gap {
        float length, open;
    };

    void measure(std::span<const HatchMark> marks);
    void join(const LayerStyle& style, std::span<const HatchMark> marks);
    [[nodiscard]] float fade_of(std::int64_t number, float shortest) const noexcept;
    void overshoot(std::span<const HatchMark> marks);
    [[nodiscard]] Place place_at(float length) const noexcept;
    [[nodiscard]] Place run_on(std::span<const HatchMark> marks, const Place& from, int way,
                               HatchEnd& end) const noexcept;
    void stray(std::span<const HatchMark> marks, HatchPoint& point, const Place& place) const noexcept;
    [[nodiscard]] glm::vec2 tangent(std::span<const HatchMark> marks, std::int64_t i) const noexcept;
    [[nodiscard]] float at(const Place& place) const noexcept;
    // From the mark before where a part begins.
    [[nodiscard]] float within(const Place& begin, const Place& place) const noexcept {
        const std::int64_t next = std::min(place.mark + 1, length_.size() - 1);
        return length_[place.mark] - length_[begin.mark] + place.share * (length_[next] - length_[place.mark]);
    }
    [[nodiscard]] float area(std::span<const HatchMark> marks, const Place& from, const Place& to) const noexcept;
    [[nodiscard]] float width_at_begin(std::span<const HatchMark> marks, const Drawn& drawn) const noexcept;
    [[nodiscard]] float width_at_end(std::span<const HatchMark> marks, const Drawn& drawn) const noexcept;
    void put(const LayerStyle& style, std::span<const HatchMark> marks, std::int64_t number, HatchPart& part);
    void advance(Place& place, const Place& begin, float wanted) const noexcept;
    void add_points(std::span<const HatchMark> marks, std::int64_t number, std::int32_t count,
                    base::Array<HatchPoint>& points) const;
    void fade_joined(std::span<const HatchMark> marks, std::int64_t number, std::int64_t first,
                     base::Array<HatchPoint>& points) const;
    void find_dips(const LayerStyle& style, std::span<const HatchMark> marks, std::int64_t first);
    [[nodiscard]] float joined_fade(std::int64_t first, std::int64_t dip, float length) const noexcept;
    [[nodiscard]] static ByLevel by_level(const HatchMark& drawn, const HatchMark& other, HatchEnd end,
                                          float share) noexcept;
    [[nodiscard]] static ByLevel by_level(const HatchMark& last) noexcept;
    template <class As>
    [[nodiscard]] static float mixed_taper(HatchEnd end, const ByLevel& by, const As& as) noexcept;
    [[nodiscard]] float taper_begin(const LayerStyle& style, std::span<const HatchMark> marks,
                                    std::int64_t number) const noexcept;
    [[nodiscard]] float taper_end(const LayerStyle& style, std::span<const HatchMark> marks,
                                  std::int64_t number) const noexcept;
    [[nodiscard]] float taper(const LayerStyle& style, HatchEnd end, std::int64_t next, const Gap& gap) const noexcept;
    [[nodiscard]] Gap gap_before(std::int64_t number) const noexcept;
    [[nodiscard]] Gap gap_after(std::int64_t number) const noexcept;
    [[nodiscard]] float along_rim(const LayerStyle& style, std::span<const HatchMark> marks, const Place& place,
                                  std::int64_t inward) const noexcept;
    [[nodiscard]] HatchPoint point(std::span<const HatchMark> marks, const Place& place) const noexcept;

    base::Array<float> length_; // of each mark from the first one, pixels
    base::Array<Drawn> drawn_;
    base::Array<Dip> dips_;   // of those that are joined
    HatchHand hand_;          // of the stroke at hand
    std::int64_t turned_ = 0; // by so many marks, if it is closed
    bool goes_round_ = false; // its last mark is its first one
};

} // namespace hrbfnpr::frame
