// SPDX-License-Identifier: MIT
// What is on a page, in millimetres from its top-left corner with y down, and what takes it in: a file's writer, or a
// filter that hands on to one.
#pragma once

#include "drawing/dot.h"
#include "geometry/vec.h"

#include <cstdint>
#include <span>
#include <string_view>

namespace hrbfnpr::output {

struct PagePoint {
    double x, y;
    double radius; // half the line's width
};

// A line of one opacity.
struct PagePath {
    std::span<const PagePoint> points; // two and more
    drawing::Cap begin = drawing::Cap::round, end = drawing::Cap::round;
    bool closed = false;  // the last point stands where the first one does
    double opacity = 1.0; // times the group's ink
};

struct PageDot {
    double x, y, radius;
    double opacity; // times the group's ink
    bool is_paper;  // it covers what was drawn before
};

struct PageText {
    double x, y;   // where its first baseline begins
    double height; // of capitals
    const char* text;
};

// Height of capitals in Helvetica and Arial, of the font's size.
inline constexpr double capitals_of_size = 0.716;

struct Frame {
    double left = 0.0, top = 0.0, right = 0.0, bottom = 0.0;
    [[nodiscard]] bool contains(double x, double y) const noexcept {
        return x >= left && x <= right && y >= top && y <= bottom;
    }
};

// A drawing on the page: what stands beyond its frame is not seen.
struct PageView {
    std::string_view name; // may be empty
    Frame frame;
    glm::vec4 paper{0.0F};
    bool with_paper = true; // its frame is filled with it
};

enum class LineType : std::uint32_t;

// Lines, dots or texts of one ink and one pen.
struct PageGroup {
    static constexpr std::size_t most = 96;
    char name[most] = "";
    glm::vec4 ink{0.0F, 0.0F, 0.0F, 1.0F};
    double pen_width = 0.0; // of all lines; 0: as they are
    std::uint32_t pen = 1;  // of a plotter
    LineType line_type{};
};

// Calls are nested: page { view { group { path, dot } } group { path, text } }.
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

// Of the whole page.
struct PageInfo {
    double width = 0.0, height = 0.0;
    const char* title = nullptr;
    const char* description = nullptr;
    const char* metadata = nullptr;
    const char* program = ""; // the version of what writes it
};

// Counted by writers and filters.
struct PageCounts {
    std::int64_t bytes = 0;
    std::int64_t paths = 0, dots = 0, groups = 0;
    std::int64_t joined = 0, dropped_paths = 0, dropped_dots = 0;
    std::int64_t filled_paths = 0;
    std::int64_t segments = 0; // of Bezier curves or lines
    double drawn = 0.0, travelled = 0.0, seconds = 0.0;
};

} // namespace hrbfnpr::output
