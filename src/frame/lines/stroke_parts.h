// SPDX-License-Identifier: MIT
// From lines and their visibility to strokes: which parts are drawn, how wide, and how they end.
#pragma once

#include "base/runtime.h"
#include "frame/lines/joined_ends.h"
#include "frame/lines/width_laws.h"
#include "frame/lines/wobble.h"
#include "frame/scene/scene.h"

#include <span>

namespace hrbfnpr::frame {

class StrokeParts {
public:
    StrokeParts(const base::Runtime& runtime, const Scene& scene, const LineInput& input, const WidthLaws& laws,
                LineStrokes& strokes)
        : scene_(scene), subjects_(input.subjects), items_(input.items), found_(input.found), lengths_(input.lengths),
          numbers_(input.numbers), laws_(laws), hugging_(runtime.memory, input), ends_(runtime.memory, input, hugging_),
          strokes_(strokes), parts_(runtime.memory), place_(runtime.memory), knot_(runtime.memory),
          at_(runtime.memory) {}

    void run();

private:
    // A part of a line that is hidden by as many layers of surface everywhere.
    struct Part {
        visibility::Interval interval; // its `sheets` of no account
        std::int32_t layers;           // of surface before it: two sheets each
        bool free_begin, free_end;     // ends that are no ends of another part: at cusps, and of open lines
    };
    // A place along a part.
    struct Place {
        double at; // along the line, pixels
        std::int32_t piece;
        double share;
    };
    // Of a line: where a part begins or ends.
    struct End {
        std::int32_t line, piece;
        double share, at;
        float sine;
    };
    // What a style makes of a part.
    struct Pen {
        double width, opacity, taper;
        bool tapers_begin, tapers_end;
    };
    // Of the way from one place to the next; low > high: nothing.
    struct Shares {
        double low, high;
    };

    [[nodiscard]] static bool alike(const Part& part, std::int32_t layers, std::int32_t hidden_by) noexcept {
        return part.layers == layers && part.interval.hidden_by == hidden_by;
    }
    void collect(std::int64_t first, std::int64_t end);
    void find_places(const Part& part);
    // Of a closed line, all of it.
    [[nodiscard]] bool is_whole(const Part& part) const noexcept;
    [[nodiscard]] bool is_dot(const LineStyle& style, const Part& part) const noexcept;
    void draw(const DrawnAs& as, const Part& part);
    void add_dashes(const DrawnAs& as, const Part& part);
    [[nodiscard]] Shares in_window(const DrawnAs& as, std::int64_t place, double beside) const;
    [[nodiscard]] drawing::Stroke begun(const DrawnAs& as, const Part& part, double length) const;
    [[nodiscard]] Pen pen_of(const DrawnAs& as, const Part& part) const noexcept;
    [[nodiscard]] Wobble wobble_of(const DrawnAs& as, std::int32_t line) const noexcept;
    [[nodiscard]] double from_origin(std::int32_t line, double at) const noexcept;
    void add_strong(const DrawnAs& as, const Part& part, double from, double to);
    void add(const DrawnAs& as, const Part& part, double from, double to);
    void put(const DrawnAs& as, const Part& part, const Pen& pen, drawing::StrokePoint point, double at);
    void wobble(const DrawnAs& as, const Part& part, const drawing::Stroke& stroke);
    void find_knots(const DrawnAs& as, const Part& part);
    [[nodiscard]] float width_at(const DrawnAs& as, const End& end) const noexcept;
    [[nodiscard]] double gap_at(const DrawnAs& as, const End& end) const noexcept;
    [[nodiscard]] drawing::StrokePoint point_at(const DrawnAs& as, const Place& place) const;
    [[nodiscard]] drawing::StrokePoint point_between(const DrawnAs& as, std::int64_t place, double share) const;
    [[nodiscard]] glm::dvec2 seen_at(const visibility::Subject& subject, const Place& place) const;

    const Scene& scene_;
    std::span<const visibility::Subject> subjects_;
    std::span<const std::int32_t> items_;
    const visibility::Invisibility& found_;
    const visibility::Lengths& lengths_;
    const LineNumbers& numbers_;
    const WidthLaws& laws_;
    HuggingParts hugging_;
    JoinedEnds ends_;
    LineStrokes& strokes_;
    base::Array<Part> parts_;
    base::Array<Place> place_;
    base::Array<double> knot_; // where a part has points between its places, in order
    base::Array<double> at_;   // of the stroke at hand: where along the line its points are
};

} // namespace hrbfnpr::frame
