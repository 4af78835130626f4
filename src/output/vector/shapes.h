// SPDX-License-Identifier: MIT
// What becomes of a line: a filled outline, or one or more lines of an even width, made of Bezier curves.
#pragma once

#include "output/vector/ribbon.h"

namespace hrbfnpr::output {

// Same numbers as HRBFNPR_WIDTHS_... and HRBFNPR_DOT_SHAPE_...
enum class Widths : std::uint32_t { outlines = 0, classes = 1 };
enum class DotShapes : std::uint32_t { circles = 0, lines = 1, spirals = 2 };

struct ShapeSettings {
    Widths widths = Widths::outlines;
    DotShapes dots = DotShapes::circles;
    double tolerance = 0.05;  // mm
    double width_step = 1.25; // from one class of widths to the next
    bool fills = false;       // what is wider than its pen, by several passes

    // Circles that a pen fills are spirals.
    [[nodiscard]] DotShapes dots_of(double pen_width) const noexcept {
        return fills && dots == DotShapes::circles && pen_width > 0.0 ? DotShapes::spirals : dots;
    }
};

// Between begin and end: the curves.  Joins of lines are round.
class ShapeSink : public OutlineSink {
public:
    virtual void begin_fill(double opacity) = 0;
    virtual void begin_line(double width, drawing::Cap cap, double opacity) = 0; // round or flat at both ends
    virtual void end_shape() = 0;
};

class Shapes {
public:
    Shapes(base::Memory& memory, const ShapeSettings& settings) noexcept;

    void shape(const PagePath& path, const PageGroup& group, ShapeSink& sink);
    // Of zero length with round ends, or a spiral of a pen's lines; circles are the writers' own.
    void shape(const PageDot& dot, const PageGroup& group, ShapeSink& sink);

private:
    void add_line(std::span<const PagePoint> points, double width, drawing::Cap cap, const PagePath& path,
                  ShapeSink& sink);
    void add_classes(const PagePath& path, ShapeSink& sink);
    [[nodiscard]] int class_of(double radius) const noexcept;
    [[nodiscard]] double radius_of(double number) const noexcept;

    ShapeSettings settings_;
    CurveFit fit_;
    Ribbon ribbon_;
    base::Array<glm::dvec2> line_;
    base::Array<PagePoint> part_;
};

// Points of a spiral that a pen so wide fills a disc with, from its middle outward.
void spiral(const PageDot& dot, double pen_width, double tolerance, base::Array<glm::dvec2>& points);

} // namespace hrbfnpr::output
