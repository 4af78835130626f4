// SPDX-License-Identifier: MIT
// Groups sorted for a pen that draws them.
#pragma once

#include "output/vector/clip.h"
#include "output/vector/fill_lines.h"
#include "output/vector/join_lines.h"
#include "output/vector/pen_lines.h"
#include "output/vector/tour.h"

namespace hrbfnpr::output {

struct PlotOrderSettings {
    double join = 0.0, shortest = 0.0, dot_distance = 0.0; // mm; 0: by the pen's width
    bool for_plotter = false;                              // whose pen has a width and no opacity
    Frame page;                                            // nothing is drawn beyond it
    ShapeSettings shapes;
};

// Keeps a group until it ends; then, in this order: lines are clipped, joined, dropped if they are short, and filled if
// they are wider than the pen; dots are dropped near to others; and all is handed on in the order of a tour.  Texts are
// handed on before.
class PlotOrder final : public PageSink {
public:
    // track: counts what is handed on; NULL: whoever comes next does.
    PlotOrder(base::Memory& memory, PageSink& next, const PlotOrderSettings& settings, PageCounts& counts,
              PenTrack* track, const base::Progress& progress);

    void begin_view(const PageView& view) override;
    void begin_group(const PageGroup& group) override;
    void path(const PagePath& path) override;
    void dot(const PageDot& dot) override;
    void text(const PageText& text) override { next_.text(text); }
    void end_group() override;
    void end_view() override;
    void finish() override { next_.finish(); }

private:
    void check_often();
    void drop_short();
    void fill_wide();
    void drop_near_dots();
    [[nodiscard]] double pen_of(const PageDot& dot) const noexcept;
    void hand_on();
    void hand_on(const PlotLine& line, const Leg& leg);
    void put(const PagePath& path);
    void put(const PageDot& dot);

    PageSink& next_;
    PlotOrderSettings settings_;
    PageCounts& counts_;
    PenTrack* track_;
    const base::Progress& progress_;
    Frame frame_; // of the view on the page
    PageGroup group_;
    std::int64_t taken_ = 0; // of the group, since its beginning
    Clip clip_;
    PlotLines lines_;
    base::Array<PageDot> dots_;
    JoinLines join_;
    FillLines fill_;
    PlotLines within_; // of lines that are filled, on the page
    NearTree tree_;
    Tour tour_;
    PenLines pen_lines_;
    base::Array<glm::dvec2> places_; // of dots
    base::Array<std::int32_t> near_; // dots to one
    base::Array<PagePoint> points_;  // of dots, as stops
    base::Array<Stop> stops_;        // lines, then dots
    base::Array<PagePoint> turned_;
    glm::dvec2 pen_; // where it stands
};

} // namespace hrbfnpr::output
