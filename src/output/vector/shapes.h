// SPDX-License-Identifier: MIT
// What becomes of a line in SVG and PDF: a filled outline, or one or more lines of an even width, made of Bezier
// curves.
#pragma once

#include "output/vector/page.h"

namespace hrbfnpr::output {

// What shapes are written to: between begin and end come curves. Filled ones are closed; they may overlap, and the
// nonzero rule fills them. Joins of lines are round.
class ShapeSink {
public:
    ShapeSink() = default;
    ShapeSink(const ShapeSink&) = delete;
    ShapeSink& operator=(const ShapeSink&) = delete;
    virtual ~ShapeSink() = default;
    virtual void begin_fill(double opacity) = 0;
    virtual void begin_line(double width, drawing::Cap cap, double opacity) = 0; // round or flat at both ends
    virtual void move_to(const glm::dvec2& p) = 0;
    virtual void line_to(const glm::dvec2& p) = 0;
    virtual void curve_to(const geometry::Cubic& cubic) = 0;
    virtual void close() = 0;
    virtual void end_shape() = 0;
};

// It holds working memory.
class Shapes {
public:
    Shapes(base::Memory& memory, const ShapeSettings& settings) noexcept
        : settings_(settings), fit_(memory), line_(memory), part_(memory), sides_(memory) {}

    void shape(const PagePath& path, const PageGroup& group, ShapeSink& sink);
    // The dot is a line of zero length with round ends, or a spiral of a pen's lines; circles are the writers' own.
    void shape(const PageDot& dot, const PageGroup& group, ShapeSink& sink);
    // The line as a filled outline whose sides are curves within the tolerance of it. Where it turns by more than 30
    // degrees, or more sharply than its width allows, it is cut in two with round ends, which overlap.
    void outline(const PagePath& path, ShapeSink& sink);

private:
    struct Side {
        glm::dvec2 left, right;
    };
    void add_line(std::span<const PagePoint> points, double width, drawing::Cap cap, const PagePath& path,
                  ShapeSink& sink);
    void add_classes(const PagePath& path, ShapeSink& sink);
    void find_sides(std::span<const PagePoint> points, bool ring);
    void add_side(bool left, bool closed, ShapeSink& sink);
    void add_piece(std::span<const PagePoint> points, drawing::Cap begin, drawing::Cap end, ShapeSink& sink);

    ShapeSettings settings_;
    geometry::CurveFit fit_;
    base::Array<glm::dvec2> line_;
    base::Array<PagePoint> part_;
    base::Array<Side> sides_;
};

} // namespace hrbfnpr::output
