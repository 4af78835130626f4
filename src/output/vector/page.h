// SPDX-License-Identifier: MIT
// The pipeline from drawings to a file, which write_page.cpp puts together: lay_out turns a drawing into groups of
// lines and dots on the page; filters take them in and hand them on, LineTypes cuts lines into dashes and PlotOrder
// clips, joins, fills and sorts them for a pen (write_page.cpp, plot_lines.cpp, tour.cpp); a writer (writers.cpp) ends
// it, which makes curves of lines for SVG and PDF or straight strokes of a pen for plotters (shapes.h).
//
// This file has what goes along the pipeline, in millimetres from the page's top-left corner with y down.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/work.h"
#include "drawing/drawing.h"
#include "geometry/polylines.h"
#include "io/stream.h"

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace hrbfnpr::output {

// ---- Data of formats

// The numbers are those that the fields format, widths and dots of hrbfnpr_page_desc take.
enum class PageFormat : std::uint32_t { svg = 0, pdf = 1, hpgl = 2, gcode = 3 };
enum class Widths : std::uint32_t { outlines = 0, classes = 1 };
enum class DotShapes : std::uint32_t { circles = 0, lines = 1, spirals = 2 };
// The numbers are those that hrbfnpr_pen.line_type takes; from 1 on they are those of ISO 128-2.
enum class LineType : std::uint32_t { as_drawn = 0, continuous = 1, last = 15 };

// Helvetica and Arial have capitals of this height, in sizes of the font.
inline constexpr double capitals_of_size = 0.716;
// A plotter's pen is this wide where no pen says it, mm.
inline constexpr double plotter_pen = 0.3;

// ---- What goes along

struct PagePoint {
    double x, y;
    double radius; // half the line's width
};
[[nodiscard]] inline glm::dvec2 place_of(const PagePoint& p) noexcept { return {p.x, p.y}; }
// The point at a share of the way from one point to another.
[[nodiscard]] inline PagePoint between(const PagePoint& a, const PagePoint& b, double t) noexcept {
    return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y), a.radius + t * (b.radius - a.radius)};
}
[[nodiscard]] inline double length_of(std::span<const PagePoint> points) noexcept {
    return geometry::length_along(points, place_of);
}
[[nodiscard]] inline double mean_width(std::span<const PagePoint> points) noexcept {
    double sum = 0.0;
    for (const PagePoint& p : points) sum += p.radius;
    return 2.0 * sum / static_cast<double>(points.size());
}

// A line of one opacity.
struct PagePath {
    std::span<const PagePoint> points; // two or more
    drawing::Cap begin = drawing::Cap::round, end = drawing::Cap::round;
    bool closed = false;  // the last point stands where the first one does
    double opacity = 1.0; // times the group's ink
};

struct PageDot {
    double x, y, radius;
    double opacity; // times the group's ink
    bool is_paper;  // it covers all that was drawn before
};

struct PageText {
    double x, y;   // where its first baseline begins
    double height; // the height of its capitals
    const char* text;
};

struct Frame {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    [[nodiscard]] bool contains(double x, double y) const noexcept {
        return x >= left && x <= right && y >= top && y <= bottom;
    }
};

// A drawing on the page. Nothing beyond its frame is seen.
struct PageView {
    std::string_view name; // may be empty
    Frame frame;
    glm::vec4 paper{0.0F};
    bool with_paper = true; // the frame is filled with it
};

// Lines, dots or texts of one ink and one pen.
struct PageGroup {
    static constexpr std::size_t most = 96;
    char name[most] = "";
    glm::vec4 ink{0.0F, 0.0F, 0.0F, 1.0F};
    double pen_width = 0.0; // the width of all its lines, mm; 0: each line has its own
    std::uint32_t pen = 1;  // a plotter's
    LineType line_type{};
};

// Takes in a page. Calls are nested: page { view { group { path, dot } } group { path, text } }.
class PageSink {
public:
    PageSink() = default;
    PageSink(const PageSink&) = delete;
    PageSink& operator=(const PageSink&) = delete;
    virtual ~PageSink() = default;

    virtual void begin_view(const PageView& view) = 0;
    virtual void begin_group(const PageGroup& group) = 0;
    virtual void path(const PagePath& path) = 0;
    virtual void dot(const PageDot& dot) = 0;
    virtual void text(const PageText& text) = 0;
    virtual void end_group() = 0;
    virtual void end_view() = 0;
    virtual void finish() = 0;
};

// Hands all on to the next sink; filters override the calls that they change.
class PageFilter : public PageSink {
public:
    explicit PageFilter(PageSink& next) noexcept : next_(next) {}
    void begin_view(const PageView& view) override { next_.begin_view(view); }
    void begin_group(const PageGroup& group) override { next_.begin_group(group); }
    void path(const PagePath& path) override { next_.path(path); }
    void dot(const PageDot& dot) override { next_.dot(dot); }
    void text(const PageText& text) override { next_.text(text); }
    void end_group() override { next_.end_group(); }
    void end_view() override { next_.end_view(); }
    void finish() override { next_.finish(); }

protected:
    PageSink& next_;
};

struct PageInfo {
    double width = 0.0, height = 0.0;
    const char* title = nullptr;
    const char* description = nullptr;
    const char* metadata = nullptr;
    const char* program = ""; // the version of what writes it
};

// Writers and filters count these.
struct PageCounts {
    std::int64_t bytes = 0;
    std::int64_t paths = 0, dots = 0, groups = 0;
    std::int64_t joined = 0, dropped_paths = 0, dropped_dots = 0;
    std::int64_t filled_paths = 0;
    std::int64_t segments = 0; // Bezier curves or straight lines
    double drawn = 0.0, travelled = 0.0, seconds = 0.0;
};

// How lines and dots are shaped.
struct ShapeSettings {
    Widths widths = Widths::outlines;
    DotShapes dots = DotShapes::circles;
    double tolerance = 0.05;  // mm
    double width_step = 1.25; // from one class of widths to the next
    bool fills = false;       // lines and dots wider than their pen are filled by several passes

    // Circles that a pen fills are spirals.
    [[nodiscard]] DotShapes dots_of(double pen_width) const noexcept {
        return fills && dots == DotShapes::circles && pen_width > 0.0 ? DotShapes::spirals : dots;
    }
};

struct PenSpeeds {
    double draw = 30.0, travel = 80.0; // mm/s
    double seconds = 0.15;             // to lower or to raise it
};

struct PlotSettings {
    double join = 0.0, shortest = 0.0, dot_distance = 0.0; // mm; 0: by the pen's width
    PenSpeeds speeds;
    const char* pen_down = nullptr; // lines of G-code; NULL: its own
    const char* pen_up = nullptr;
};

struct PageSettings {
    PageFormat format = PageFormat::svg;
    bool in_plot_order = false;
    bool without_paper = false;
    double width = 0.0, height = 0.0; // mm; 0: to where the drawings reach
    ShapeSettings shapes;
    PlotSettings plot;

    // A plotter's pen has a width and no opacity.
    [[nodiscard]] bool for_plotter() const noexcept {
        return format == PageFormat::hpgl || format == PageFormat::gcode;
    }
};

// ---- Filters and writers; a filter hands on to the next sink, and both count their lines and dots

// Cuts the lines of groups that have a line type into its dashes.
[[nodiscard]] std::unique_ptr<PageSink> line_types(base::Memory& memory, PageSink& next);

class PenTrack;
// Keeps a group until it ends; then, in this order: lines are clipped, joined, dropped if they are short, and filled if
// they are wider than the pen; dots are dropped near to others; and all is handed on in the order of a tour. Texts are
// handed on before.
// settings: their size is the page's, and nothing is drawn beyond it. `track` counts the lines that are handed on;
// NULL: the next sink counts them.
[[nodiscard]] std::unique_ptr<PageSink> plot_order(base::Memory& memory, PageSink& next, const PageSettings& settings,
                                                   PageCounts& counts, PenTrack* track, const base::Progress& progress);

// The writers: SVG 1.1 with Inkscape's layers; PDF 1.5 whose groups are optional content; HPGL as HP's 7400 series of
// plotters reads it, or G-code [ISO 6983-1], by settings.format.
// A writer refers to all that it is given.
[[nodiscard]] std::unique_ptr<PageSink> make_writer(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                                    const PageSettings& settings, PageCounts& counts);

// ---- Looks for a cancel

// Looks for a cancel, and calls the caller's callback without more progress.
inline void look(const base::Progress& progress) { progress.update(0.0); }

// Looks each time that a number of steps were counted.
class Looks {
public:
    Looks(const base::Progress& progress, std::int64_t steps) noexcept : progress_(progress), steps_(steps) {
        HRBFNPR_ASSERT(steps > 0);
    }
    void count(std::int64_t steps = 1) {
        if ((counted_ += steps) < steps_) return;
        counted_ = 0;
        look(progress_);
    }

private:
    const base::Progress& progress_;
    std::int64_t steps_, counted_ = 0;
};

// ---- A page of drawings, as bytes of one of several formats

struct Placement {
    const drawing::Drawing* drawing = nullptr;
    std::string_view name;
    double x = 0.0, y = 0.0;    // where the viewport's top-left corner is on the page, mm
    double scale = 25.4 / 96.0; // mm per pixel
    bool with_paper = true;     // else the page has the same
    bool far_to_near = true;    // where inks of several colours lie upon each other; else groups are whole
};

// A pen for the groups whose name it has.
struct Pen {
    std::string_view groups; // a name, the beginning of one before a '*', or nothing: all
    double width = 0.0;      // mm; 0: as drawn
    glm::vec4 ink{0.0F};     // alpha 0: as drawn
    std::uint32_t number = 1;
    LineType line_type{};
};

// ---- Drawings to groups

// Hands a drawing's ink on, group by group, strokes far to near; groups begin anew where far to near must be kept.
// Strokes whose opacity changes are cut into parts of an even one.
void lay_out(base::Memory& memory, const Placement& placement, std::span<const Pen> pens, PageSink& sink,
             const base::Progress& progress);

// A line or a text beside the drawings.
struct Annotation {
    std::string_view group;
    const char* text = nullptr;     // NULL: a line
    std::span<const double> points; // x and y of each, mm; for a text, where its baseline begins
    double width = 0.35;
    glm::vec4 ink{0.0F, 0.0F, 0.0F, 1.0F};
    LineType line_type = LineType::continuous;
};

struct Page {
    PageInfo info; // its size is found
    std::span<const Placement> placements;
    std::span<const Pen> pens;
    std::span<const Annotation> annotations;
};

// The page's size, mm.
[[nodiscard]] glm::dvec2 page_size(const Page& page, const PageSettings& settings) noexcept;

PageCounts write_page(const base::Work& work, const Page& page, const PageSettings& settings, io::Writer& writer);

} // namespace hrbfnpr::output
