// SPDX-License-Identifier: MIT
// Sorts groups for a pen that draws them.
#pragma once

#include "output/vector/line_types.h"
#include "output/vector/pen.h"
#include "output/vector/plot_lines.h"

namespace hrbfnpr::output {

struct PlotOrderSettings {
    double join = 0.0, shortest = 0.0, dot_distance = 0.0; // mm; 0: by the pen's width
    bool for_plotter = false;                              // its pen has a width and no opacity
    Frame page;                                            // nothing is drawn beyond it
    ShapeSettings shapes;
};

// Keeps a group until it ends; then, in this order: lines are clipped, joined, dropped if they are short, and filled if
// they are wider than the pen; dots are dropped near to others; and all is handed on in the order of a tour. Texts are
// handed on before.
class PlotOrder final : public PageFilter {
public:
    // track: counts what is handed on; NULL: the next sink does.
    PlotOrder(base::Memory& memory, PageSink& next, const PlotOrderSettings& settings, PageCounts& counts,
              PenTrack* track, const base::Progress& progress);

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
    PlotOrderSettings settings_;
    PageCounts& counts_;
    PenTrack* track_;
    const base::Progress& progress_;
    Looks looks_;
    Frame frame_; // of the view on the page
    PageGroup group_;
    PlotLines lines_;
    base::Array<PageDot> dots_;
    Clip clip_;
    PenLines pen_lines_;
    base::Array<PagePoint> turned_;
    glm::dvec2 pen_; // where it stands
};

} // namespace hrbfnpr::output
