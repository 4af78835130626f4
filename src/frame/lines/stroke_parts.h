// SPDX-License-Identifier: MIT
// From lines and their visibility to strokes: which parts are drawn, how wide, and how they end.
#pragma once

#include "base/runtime.h"
#include "frame/scene/line_strokes.h"
#include "frame/scene/scene.h"
#include "visibility/invisibility.h"

#include <span>

namespace hrbfnpr::frame {

// Lines of a subject that are drawn in a layer of the drawing.
struct DrawnAs {
    const LineStyle* style;
    std::int32_t subject;
    std::uint32_t layer;
    const float* strength = nullptr;  // of the points of the subject's curves; null: lines of one strength
    float lower = 0.0F, upper = 0.0F; // strengths between which a line fades
    float halo = 0.0F;                // of its item's style: pixels between a nearer line and where this one ends
};

class StrokeParts {
public:
    StrokeParts(const base::Runtime& runtime, const Scene& scene, std::span<const visibility::Subject> subjects,
                const visibility::Invisibility& found, LineStrokes& strokes)
        : scene_(scene), subjects_(subjects), found_(found), strokes_(strokes), parts_(runtime.memory),
          place_(runtime.memory), lengths_(runtime.memory, found.lines) {}

    void run(std::span<const DrawnAs> styles);

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
    // Of the way from one place to the next; low > high: nothing.
    struct Shares {
        double low, high;
    };

    void collect(std::int64_t first, std::int64_t end);
    void find_places(const Part& part);
    // Of a closed line, all of it.
    [[nodiscard]] bool is_whole(const Part& part) const noexcept;
    void draw(const DrawnAs& as, const Part& part);
    void add_dashes(const DrawnAs& as, const Part& part);
    [[nodiscard]] Shares in_window(const DrawnAs& as, std::int64_t place, double beside) const;
    [[nodiscard]] drawing::Stroke begun(const DrawnAs& as, const Part& part, double length) const;
    void add(const DrawnAs& as, const Part& part, double from, double to);
    [[nodiscard]] drawing::StrokePoint point_at(const DrawnAs& as, const Place& place) const;
    [[nodiscard]] drawing::StrokePoint point_between(const DrawnAs& as, std::int64_t place, double share) const;
    [[nodiscard]] glm::dvec2 seen_at(const visibility::Subject& subject, const Place& place) const;

    const Scene& scene_;
    std::span<const visibility::Subject> subjects_;
    const visibility::Invisibility& found_;
    LineStrokes& strokes_;
    base::Array<Part> parts_;
    base::Array<Place> place_;
    visibility::Lengths lengths_;
};

} // namespace hrbfnpr::frame
