// SPDX-License-Identifier: MIT
// Curves as polylines in the image, as fine as the eye and the search for crossings need.
#pragma once

#include "base/runtime.h"
#include "visibility/subject.h"

#include <span>

namespace hrbfnpr::visibility {

// The cubic between two points of a curve.
struct Piece {
    std::int32_t subject;
    std::int32_t line;
    std::int64_t a, b; // points of the subject's curves
};

struct ImagePoint {
    glm::dvec2 place; // pixels, y down
    std::int32_t piece;
    double share; // along it, in [0, 1]
};

// A curve, or a part of one that lies before the eye.
struct Line {
    std::int32_t subject;
    std::int64_t curve;
    std::int64_t first_piece, pieces;
    std::int64_t first_point, points; // of the image
    bool closed;                      // the first point of the image stands again at the end
};

struct ImageLines {
    explicit ImageLines(base::Memory& memory) noexcept : lines(memory), pieces(memory), points(memory) {}

    base::Array<Line> lines;
    base::Array<Piece> pieces;
    base::Array<ImagePoint> points;
};

// Where a cubic is seen.
struct Seen {
    glm::dvec2 place; // pixels
    double w;         // > 0 before the eye
};
[[nodiscard]] Seen see(const curves::View& view, const glm::dvec3& p) noexcept;

// The image is off the curves by `tolerance` pixels, or little more.
[[nodiscard]] ImageLines draw_lines(const base::Runtime& runtime, std::span<const Subject> subjects, double tolerance);

[[nodiscard]] inline curves::CubicPiece cubic(std::span<const Subject> subjects, const Piece& piece) noexcept {
    const base::Array<curves::CurvePoint>& point = subjects[static_cast<std::size_t>(piece.subject)].curves->point;
    return {point[piece.a], point[piece.b]};
}

// Of a border, whether the inside of its surface is seen there.  At a border the surface lies to the left as seen from
// outside; of contours it always does.
[[nodiscard]] inline bool shows_inside(std::span<const Subject> subjects, const Piece& piece) noexcept {
    const Subject& subject = subjects[static_cast<std::size_t>(piece.subject)];
    if (subject.sheets != 1) return false;
    const curves::CurvePoint& p = subject.curves->point[piece.a];
    const curves::CurvePoint& q = subject.curves->point[piece.b];
    return glm::dot(p.gradient + q.gradient, subject.view.sight(p.position)) > 0.0;
}

} // namespace hrbfnpr::visibility
