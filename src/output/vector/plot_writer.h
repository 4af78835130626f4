// SPDX-License-Identifier: MIT
// What the languages of plotters share: a grid of whole units with y up from the page's lower left corner, and a pen
// that is raised, moved and lowered no more often than it must be.
#pragma once

#include "output/vector/pen_lines.h"
#include "output/vector/text_out.h"

namespace hrbfnpr::output {

struct PlotFormat {
    ShapeSettings shapes;
    PenSpeeds speeds;
    const char* pen_down = nullptr; // lines of G-code; NULL: its own
    const char* pen_up = nullptr;
};

class PlotWriter : public PageSink {
public:
    void begin_view(const PageView&) override {}
    void begin_group(const PageGroup& group) override;
    void path(const PagePath& path) override;
    void dot(const PageDot& dot) override;
    void end_group() override {}
    void end_view() override {}
    void finish() override;

protected:
    struct Place {
        std::int64_t x, y; // units
    };
    PlotWriter(base::Memory& memory, io::Writer& writer, const PageInfo& page, double per_mm, const PlotFormat& format,
               PageCounts& counts);

    virtual void write_pen(const PageGroup& group, bool is_first, bool is_other) = 0; // the pen is raised
    virtual void write_raise() = 0;                                                   // it is lowered
    virtual void write_travel(const Place& to, bool is_down) = 0;                     // raises it first
    virtual void write_lower() = 0;
    virtual void write_draw(const Place& to) = 0;
    virtual void write_end() = 0; // it is raised
    // Raises the pen and takes it to where it then goes elsewhere, for a label.
    void go_to(double x, double y);
    // Rounded to thousandths, with a zero before the point, which old plotters want.
    void number(double value) { thousandths(in_thousandths(value)); }
    void thousandths(std::int64_t value);
    // For each character that is not ASCII, or a control, '?'.
    void ascii(std::string_view text, bool in_parentheses);

    TextOut out_;

private:
    [[nodiscard]] Place on_grid(const glm::dvec2& p) const noexcept;
    [[nodiscard]] glm::dvec2 on_page(const Place& p) const noexcept;
    void raise();
    void travel(const Place& to);
    void draw(std::span<const glm::dvec2> line);

    double per_mm_, height_;
    PlotFormat format_;
    PageCounts& counts_;
    PenLines lines_;
    PenTrack track_;
    PageGroup group_;
    std::uint32_t pen_ = 0; // the number; 0: none yet
    Place place_{0, 0};     // of the pen
    bool is_known_ = false; // else it may stand elsewhere
    bool is_down_ = false;
};

} // namespace hrbfnpr::output
