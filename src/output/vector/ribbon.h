// SPDX-License-Identifier: MIT
// Lines of varying width as filled outlines.
#pragma once

#include "output/vector/curve_fit.h"
#include "output/vector/page.h"

namespace hrbfnpr::output {

// What an outline is written to: closed curves, which may overlap, to be filled by the nonzero rule.
class OutlineSink {
public:
    OutlineSink() = default;
    OutlineSink(const OutlineSink&) = delete;
    OutlineSink& operator=(const OutlineSink&) = delete;
    virtual ~OutlineSink() = default;
    virtual void move_to(const glm::dvec2& p) = 0;
    virtual void line_to(const glm::dvec2& p) = 0;
    virtual void curve_to(const Cubic& cubic) = 0;
    virtual void close() = 0;
};

class Ribbon {
public:
    explicit Ribbon(base::Memory& memory) noexcept;

    // The sides of the line are curves within the tolerance of it.  Where it turns by more than 30 degrees, or more
    // sharply than its width allows, it is cut in two with round ends, which overlap.
    void outline(const PagePath& path, double tolerance, OutlineSink& sink);

private:
    struct Side {
        glm::dvec2 left, right;
    };
    void find_points(const PagePath& path);
    void find_cuts(bool closed);
    void find_sides(std::int64_t first, std::int64_t last, bool ring);
    [[nodiscard]] bool turns_sharply(const PagePoint& a, const PagePoint& b, const PagePoint& c) const noexcept;
    void add_ring(double tolerance, OutlineSink& sink);
    void add_piece(std::int64_t first, std::int64_t last, drawing::Cap begin, drawing::Cap end, double tolerance,
                   OutlineSink& sink);
    void add_side(bool left, bool closed, double tolerance, OutlineSink& sink);
    void add_cap(const PagePoint& p, const glm::dvec2& out, drawing::Cap cap, OutlineSink& sink) const;

    CurveFit fit_;
    base::Array<PagePoint> points_;
    base::Array<std::int64_t> cuts_; // points where it is cut, ascending
    base::Array<Side> sides_;
    base::Array<glm::dvec2> line_;
};

} // namespace hrbfnpr::output
