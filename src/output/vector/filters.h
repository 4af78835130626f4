// SPDX-License-Identifier: MIT
// The filters between lay_out() and a writer: dashes of lines [ISO 128-2], and the order of a pen.
#pragma once

#include "output/vector/pen.h"
#include "output/vector/plot_lines.h"

#include <algorithm>
#include <utility>

namespace hrbfnpr::output {

// Cuts the lines of groups that have a line type into its dashes.
class LineTypes final : public PageFilter {
public:
    LineTypes(base::Memory& memory, PageSink& next) noexcept : PageFilter(next), part_(memory) {}

    void begin_group(const PageGroup& group) override {
        group_ = group;
        next_.begin_group(group);
    }
    void path(const PagePath& path) override;

private:
    PageGroup group_;
    base::Array<PagePoint> part_;
};

// Parts of lines within a frame. It holds working memory.
class Clip {
public:
    explicit Clip(base::Memory& memory) noexcept : ring_(memory), part_(memory) {}

    // Calls take(path) for each part of the path's centre within the frame, in its order. An end where it is cut is
    // flat. A closed path becomes open if anything is cut off.
    template <class Take>
    void parts(const PagePath& path, const Frame& frame, Take&& take);

private:
    // Narrows the part of a segment, from 0 to 1, to the part within the frame; false if all of it is outside, or if
    // the segment is not finite.
    [[nodiscard]] static bool within(const PagePoint& a, const PagePoint& b, const Frame& frame, double& from,
                                     double& to) noexcept;

    base::Array<PagePoint> ring_;
    base::Array<PagePoint> part_;
};

template <class Take>
void Clip::parts(const PagePath& path, const Frame& frame, Take&& take) {
    HRBFNPR_ASSERT(path.points.size() > 1);
    const auto inside = [&](const PagePoint& p) { return frame.contains(p.x, p.y); };
    if (std::all_of(path.points.begin(), path.points.end(), inside)) {
        take(path);
        return;
    }
    std::span<const PagePoint> points = path.points;
    if (path.closed) { // it begins beyond the frame
        const std::span<const PagePoint> once = points.first(points.size() - 1);
        const auto first = std::find_if_not(once.begin(), once.end(), inside) - once.begin();
        ring_.clear();
        for (std::size_t i = 0; i <= once.size(); ++i)
            ring_.push_back(once[(static_cast<std::size_t>(first) + i) % once.size()]);
        points = ring_.span();
    }
    PagePath part = path;
    part.closed = false;
    const auto emit = [&](drawing::Cap end) {
        part.points = part_.span();
        part.end = end;
        if (part_.size() > 1) take(std::as_const(part));
        part_.clear();
    };
    part_.clear();
    for (std::size_t i = 1; i < points.size(); ++i) {
        const PagePoint& a = points[i - 1];
        const PagePoint& b = points[i];
        double from = 0.0, to = 1.0;
        const bool any = within(a, b, frame, from, to);
        if (!any || part_.empty() || from > 0.0) emit(drawing::Cap::flat);
        if (!any) continue;
        if (part_.empty()) {
            part.begin = i == 1 && from <= 0.0 && !path.closed ? path.begin : drawing::Cap::flat;
            part_.push_back(from > 0.0 ? between(a, b, from) : a);
        }
        part_.push_back(to < 1.0 ? between(a, b, to) : b);
        if (to < 1.0) emit(drawing::Cap::flat);
    }
    emit(path.closed ? drawing::Cap::flat : path.end);
}

// Keeps a group until it ends; then, in this order: lines are clipped, joined, dropped if they are short, and filled if
// they are wider than the pen; dots are dropped near to others; and all is handed on in the order of a tour. Texts are
// handed on before.
class PlotOrder final : public PageFilter {
public:
    // settings: their size is the page's, and nothing is drawn beyond it. `track` counts the lines that are handed on;
    // NULL: the next sink counts them.
    PlotOrder(base::Memory& memory, PageSink& next, const PageSettings& settings, PageCounts& counts, PenTrack* track,
              const base::Progress& progress);

    void begin_view(const PageView& view) override;
    void begin_group(const PageGroup& group) override;
    void path(const PagePath& path) override;
    void dot(const PageDot& dot) override;
    void end_group() override;
    void end_view() override;

private:
    [[nodiscard]] bool fills(std::span<const PagePoint> points, double pen) const noexcept;
    [[nodiscard]] double pen_of(const PageDot& dot) const noexcept;
    void clip(const PagePath& path, const PlotLine& like, PlotLines& to);
    void drop_short();
    void drop_near_dots();
    void hand_on();
    void put(PagePath path, const Leg& leg);

    base::Memory& memory_;
    PageSettings settings_;
    PageCounts& counts_;
    PenTrack* track_;
    const base::Progress& progress_;
    Looks looks_;
    Frame frame_; // the part of the page that can be drawn on, mm: within a view, the part inside the view's frame
    PageGroup group_;
    PlotLines lines_;
    base::Array<PageDot> dots_;
    Clip clip_;
    PenLines pen_lines_;
    base::Array<PagePoint> turned_;
    glm::dvec2 pen_; // where the pen stands, mm
};

} // namespace hrbfnpr::output
