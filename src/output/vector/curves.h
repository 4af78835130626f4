// SPDX-License-Identifier: MIT
// Fits lines, arcs of circles and Bezier cubics to polylines. Writers choose what their format has: SVG and DXF have
// all three, PDF has lines and cubics, and G-code has lines and arcs or lines and cubics.
#pragma once

#include "output/vector/page.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::output {

// A part of a line that begins where the part before it ends.
struct CurvePiece {
    enum class Kind : std::uint8_t { line, arc, cubic };
    Kind kind = Kind::line;
    glm::dvec2 end{0.0};
    glm::dvec2 control_1{0.0}, control_2{0.0}; // the handles of a cubic
    glm::dvec2 centre{0.0};                    // the centre of an arc
    double sweep = 0.0; // the angle of an arc in radians, positive from the x axis to the y axis; up to a full circle
};

struct CurveLine {
    glm::dvec2 start{0.0};
    std::span<const CurvePiece> pieces; // empty if all points of the line coincide
};

// Calls visit(part) for equal parts of an arc, whose sweeps are at most `most`.
template <class Visit>
void for_parts(const CurvePiece& arc, double most, const Visit& visit) {
    HRBFNPR_ASSERT(arc.kind == CurvePiece::Kind::arc && most > 0.0);
    const double parts = std::max(std::ceil(std::abs(arc.sweep) / most - 1e-9), 1.0);
    CurvePiece part = arc;
    part.sweep = arc.sweep / parts;
    const glm::dvec2 to = arc.end - arc.centre;
    for (double left = parts - 1.0; left >= 0.0; left -= 1.0) {
        const double c = std::cos(left * part.sweep), s = std::sin(left * part.sweep);
        part.end = arc.centre + glm::dvec2(c * to.x + s * to.y, c * to.y - s * to.x);
        visit(part);
    }
}

// Fits pieces to a polyline. Every point of the polyline is within the tolerance of the pieces. The last point of a
// closed line equals its first. The object holds working memory, and a result is valid until the next call.
class CurvePieces {
public:
    explicit CurvePieces(base::Memory& memory) noexcept
        : fit_(memory), points_(memory), parts_(memory), pieces_(memory), keeps_(memory) {}

    // `lines` gives straight lines, and `splines` gives cubics. `arcs` gives cubics, too, but arcs and lines where the
    // line consists of them: between two corners they meet smoothly, and they are not more than the cubics would be.
    CurveLine fit(std::span<const glm::dvec2> points, double tolerance, bool closed, Curves curves);
    // Returns lines and arcs only. They need not meet smoothly. The line begins where the polyline begins, but a circle
    // begins at its point nearest to that place.
    CurveLine fit_arcs(std::span<const glm::dvec2> points, double tolerance, bool closed);

private:
    // A line or an arc between two of the points.
    struct Part {
        CurvePiece::Kind kind = CurvePiece::Kind::line;
        std::int64_t first = 0, last = 0;
    };
    void take(std::span<const glm::dvec2> points);
    bool split(std::int64_t first, std::int64_t last, double tolerance, std::int64_t most);
    void move_breaks(double tolerance) noexcept;
    [[nodiscard]] bool are_the_curve(bool goes_round) const noexcept;
    [[nodiscard]] bool find_parts(std::int64_t first, std::int64_t last, double tolerance, std::int64_t most,
                                  bool goes_round);
    void add_parts();
    CurveLine result(const glm::dvec2& start) const noexcept { return {start, pieces_.span()}; }

    geometry::CurveFit fit_;
    base::Array<glm::dvec2> points_; // the points without repetitions; those of a ring are rotated
    base::Array<Part> parts_;
    base::Array<CurvePiece> pieces_;
    base::Array<std::uint8_t> keeps_;
};

} // namespace hrbfnpr::output
