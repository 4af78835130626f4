// SPDX-License-Identifier: MIT
// The pipeline from drawings to a file, which write_page.cpp puts together. lay_out() turns a drawing into groups of
// lines and dots on the page. Filters receive them and pass them on: line_types() cuts lines into dashes, and
// plot_order() clips, joins, fills and sorts them for a pen (filters.cpp, plot_lines.cpp, tour.cpp). A writer
// (writers.cpp, dxf.cpp) is the last stage. It writes lines as curves, or as straight strokes (shapes.h, curves.h).
//
// This file declares the data that the stages exchange, in millimetres from the page's top-left corner with y down.
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

// The values equal those of the fields format, widths, dots and curves of hrbfnpr_page_desc.
enum class PageFormat : std::uint32_t { svg = 0, pdf = 1, hpgl = 2, gcode = 3, dxf = 4 };
enum class Widths : std::uint32_t { outlines = 0, classes = 1 };
enum class DotShapes : std::uint32_t { circles = 0, lines = 1, spirals = 2 };
enum class Curves : std::uint32_t { arcs = 0, splines = 1, lines = 2 };
// The values equal those of hrbfnpr_pen.line_type; from 1 on they are the line type numbers of ISO 128-2.
enum class LineType : std::uint32_t { as_drawn = 0, continuous = 1, last = 15 };

// The height of capitals in Helvetica and Arial, as a share of the font size.
inline constexpr double capitals_of_size = 0.716;
// The width of a plotter's pen if no pen gives one, mm.
inline constexpr double plotter_pen = 0.3;

// ---- Data that the stages exchange

struct PagePoint {
    double x, y;
    double radius; // half the line's width
};
[[nodiscard]] inline glm::dvec2 place_of(const PagePoint& p) noexcept { return {p.x, p.y}; }
// Returns the point at the fraction t of the way from a to b.
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
    std::span<const PagePoint> points; // at least two points
    drawing::Cap begin = drawing::Cap::round, end = drawing::Cap::round;
    bool closed = false;  // the last point repeats the first
    double opacity = 1.0; // multiplies the alpha of the group's ink
};

struct PageDot {
    double x, y, radius;
    double opacity; // multiplies the alpha of the group's ink
    bool is_paper;  // the dot has the paper's colour and hides all marks drawn before it
};

struct PageText {
    double x, y;   // the start of the first baseline
    double height; // height of its capitals
    const char* text;
};

struct Frame {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    [[nodiscard]] bool contains(double x, double y) const noexcept {
        return x >= left && x <= right && y >= top && y <= bottom;
    }
};

// A drawing on the page, clipped to its frame.
struct PageView {
    std::string_view name; // may be empty
    Frame frame;
    glm::vec4 paper{0.0F};
    bool with_paper = true; // fill the frame with the paper's colour
};

// The attributes that lines, dots or texts share: one ink and one pen.
struct PageGroup {
    static constexpr std::size_t most = 96;
    char name[most] = "";
    glm::vec4 ink{0.0F, 0.0F, 0.0F, 1.0F};
    double pen_width = 0.0;       // the width of all lines, in mm; 0: each line has its own width
    std::uint32_t pen = 1;        // the number of a plotter's pen
    std::int32_t ink_number = -1; // the number of the ink in a style's palette; -1: the ink is in none
    LineType line_type{};
};

// A stage of the pipeline that receives a page. Calls are nested: page { view { group { path, dot } } group { path,
// text } }.
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

// Passes every call on to the next sink; filters override the calls that they change.
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
    const char* program = ""; // the version of the program that writes the file
    // For DXF, the groups of the page. Groups with equal names may be repeated.
    std::span<const PageGroup> groups;
};

// The counts that writers and filters make.
struct PageCounts {
    std::int64_t bytes = 0;
    std::int64_t paths = 0, dots = 0, groups = 0;
    std::int64_t joined = 0, dropped_paths = 0, dropped_dots = 0;
    std::int64_t filled_paths = 0, cut_paths = 0;
    std::int64_t segments = 0; // Bezier curves or straight lines
    double drawn = 0.0, travelled = 0.0, seconds = 0.0;
};

// How lines and dots are shaped.
struct ShapeSettings {
    Widths widths = Widths::outlines;
    DotShapes dots = DotShapes::circles;
    Curves curves = Curves::arcs;
    double tolerance = 0.05;  // mm
    double width_step = 1.25; // ratio of the widths of two consecutive classes
    bool fills = false;       // lines and dots wider than their pen are filled by several passes

    // Returns how dots are drawn: as spirals instead of circles if a pen must fill them.
    [[nodiscard]] DotShapes dots_of(double pen_width) const noexcept {
        return fills && dots == DotShapes::circles && pen_width > 0.0 ? DotShapes::spirals : dots;
    }
};

struct PenSpeeds {
    double draw = 30.0, travel = 80.0; // the speeds of the lowered and of the raised pen, mm/s
    double seconds = 0.15;             // the time to lower the pen, and the time to raise it
};

struct PlotSettings {
    double join = 0.0, shortest = 0.0, dot_distance = 0.0; // in mm; 0: computed from the pen's width
    double longest = 0.0; // the pen is raised after at most this length, in mm; 0: no limit
    PenSpeeds speeds;
    const char* pen_down = nullptr; // lines of G-code; NULL: the default lines
    const char* pen_up = nullptr;
};

struct PageSettings {
    PageFormat format = PageFormat::svg;
    bool in_plot_order = false;
    bool without_paper = false;
    double width = 0.0, height = 0.0; // in mm; 0: large enough for all drawings
    ShapeSettings shapes;
    PlotSettings plot;

    // Returns whether a plotter draws the page. A plotter's pens have a width and no opacity.
    [[nodiscard]] bool for_plotter() const noexcept {
        return format == PageFormat::hpgl || format == PageFormat::gcode;
    }
};

// ---- Filters and writers: a filter passes its output to the next sink; filters and writers count lines and dots

// Returns the lengths of the dashes and gaps of a line type, in line widths; none for a continuous line.
[[nodiscard]] std::span<const double> dashes_of(LineType type) noexcept;
// Cuts the lines of groups that have a line type into the dashes of that type.
[[nodiscard]] std::unique_ptr<PageSink> line_types(base::Memory& memory, PageSink& next);
// Clips lines and dots to the frames of their views and to the page size in `settings`.
[[nodiscard]] std::unique_ptr<PageSink> clip_to_frames(base::Memory& memory, PageSink& next,
                                                       const PageSettings& settings);

class PenTrack;
// Clips the lines of a group, and keeps them until the group ends. Then the filter joins lines, drops short lines,
// fills lines that are wider than the pen, and drops dots that are too close to other dots. It passes on what remains
// in the order of a tour. Texts are passed on immediately. Lines are clipped to the page size in `settings`. If `track`
// is not NULL, it counts the lines that are passed on; otherwise the next sink counts them.
[[nodiscard]] std::unique_ptr<PageSink> plot_order(base::Memory& memory, PageSink& next, const PageSettings& settings,
                                                   PageCounts& counts, PenTrack* track, const base::Progress& progress);

// Makes the writer for settings.format: SVG 1.1 with Inkscape's layers, PDF 1.5 whose groups are optional content, HPGL
// for HP's 7400 series of plotters, G-code [ISO 6983-1], or DXF. It keeps references to all its arguments.
[[nodiscard]] std::unique_ptr<PageSink> make_writer(base::Memory& memory, io::Writer& writer, const PageInfo& page,
                                                    const PageSettings& settings, PageCounts& counts);

// ---- Cancellation

// Checks for cancellation. It calls the caller's callback but reports no more progress.
inline void check_cancel(const base::Progress& progress) { progress.update(0.0); }

// Checks for cancellation once every `steps` steps.
class CancelChecks {
public:
    CancelChecks(const base::Progress& progress, std::int64_t steps) noexcept : progress_(progress), steps_(steps) {
        HRBFNPR_ASSERT(steps > 0);
    }
    void count(std::int64_t steps = 1) {
        if ((counted_ += steps) < steps_) return;
        counted_ = 0;
        check_cancel(progress_);
    }

private:
    const base::Progress& progress_;
    std::int64_t steps_, counted_ = 0;
};

// ---- A page of drawings, as bytes of one of several formats

struct Placement {
    const drawing::Drawing* drawing = nullptr;
    std::string_view name;
    double x = 0.0, y = 0.0;    // the position of the viewport's top-left corner on the page, mm
    double scale = 25.4 / 96.0; // mm per pixel
    // Whether the view's frame is filled with the drawing's paper. If not, the drawing lies on the paper of the page.
    bool with_paper = true;
    // Whether inks of different colours are painted from far to near where they overlap. If not, all ink of one colour
    // is in one group.
    bool far_to_near = true;
};

// A pen for the groups whose names match.
struct Pen {
    std::string_view groups; // a group's name, a prefix followed by '*', or empty for all groups
    double width = 0.0;      // in mm; 0: lines keep their width
    glm::vec4 ink{0.0F};     // alpha 0: lines keep their ink
    std::uint32_t number = 1;
    LineType line_type{};
};

// ---- Drawings to groups

// Passes on the ink of a drawing group by group, with strokes from far to near. It begins a new run of groups where the
// order from far to near would be violated otherwise. It cuts strokes whose opacity changes into parts of constant
// opacity.
void lay_out(base::Memory& memory, const Placement& placement, std::span<const Pen> pens, PageSink& sink,
             const base::Progress& progress);

// A line or a text in addition to the drawings.
struct Annotation {
    std::string_view group;
    const char* text = nullptr;     // NULL: the annotation is a line
    std::span<const double> points; // x and y of each point in mm; a text has one point, the start of its baseline
    double width = 0.35;
    glm::vec4 ink{0.0F, 0.0F, 0.0F, 1.0F};
    LineType line_type = LineType::continuous;
};

struct Page {
    PageInfo info; // write_page() computes its width and height
    std::span<const Placement> placements;
    std::span<const Pen> pens;
    std::span<const Annotation> annotations;
};

// Returns the page's size in mm, with computed values where the settings have 0.
[[nodiscard]] glm::dvec2 page_size(const Page& page, const PageSettings& settings) noexcept;

PageCounts write_page(const base::Work& work, const Page& page, const PageSettings& settings, io::Writer& writer);

} // namespace hrbfnpr::output
