// SPDX-License-Identifier: MIT
// The image of curves: curves as polylines in the image, and the places where the number of sheets before a line may
// change. These are the crossings of two curves in the image, of which one is nearer, and the places where a line of
// one item passes through the surface of another item.
#pragma once

#include "base/assert.h"
#include "base/work.h"
#include "curves/curves.h"
#include "curves/sheet_count.h"
#include "visibility/tuning.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::visibility {

// A surface that may hide lines.
struct Occluder {
    const curves::SheetCounter* sheet_counter = nullptr;
    const implicit::Implicit* surface = nullptr;
    glm::dmat4 to_world{1.0}; // an affine transform
    glm::dvec4 eye{0.0};      // the eye in the coordinates of the surface, as in curves::View::eye
};

// Curves on one surface. Their visibility is to be found.
struct Subject {
    const curves::Curves* curves = nullptr;
    // The function that is 0 on the curves; null: the curves are just polylines.
    const curves::Level* level = nullptr;
    curves::View view;
    double side = 0.0; // the side of the surface mesh's cells, which is the unit of length for the subject
    // A surface that is less than this before a curve does not hide the curve. In mesh sides.
    double clearance = visibility_tuning.clearance;
    glm::dmat4 to_world{1.0}; // an affine transform
    std::int32_t item = 0;    // the index of the surface's item among the occluders
    // The index of a second item on whose surface the curves lie, too, or -1.
    std::int32_t other_item = -1;
    // The number of sheets that begin or end at these curves: 2 for a contour or for a crease that is a contour, 1 for
    // a border, 0 for other lines.
    std::int32_t sheet_change = 2;
    bool mirrored = false; // true if the image shows the surface mirrored
    bool joined = false;   // true if open curves end at other curves, for example at the corners of a crease

    // Returns whether the curves lie on the surface of an item.
    [[nodiscard]] bool is_on(std::int32_t surface) const noexcept { return surface == item || surface == other_item; }
};

// The cubic between two points of a curve.
struct Piece {
    std::int32_t subject;
    std::int32_t line;
    std::int64_t a, b; // the indices of two consecutive points in the subject's curves
};

struct ImagePoint {
    glm::dvec2 place; // in pixels; y downward
    std::int32_t piece;
    double share; // the position on the piece, in [0, 1]
};

// A curve, or a part of a curve that is before the eye.
struct Line {
    std::int32_t subject;
    std::int64_t curve;
    std::int64_t first_piece, pieces;
    std::int64_t first_point, points; // the range of the line's points in ImageLines::points
    bool closed;                      // true if the line is closed; its last image point then repeats the first
};

struct ImageLines {
    explicit ImageLines(base::Memory& memory) noexcept : lines(memory), pieces(memory), points(memory) {}

    base::Array<Line> lines;
    base::Array<Piece> pieces;
    base::Array<ImagePoint> points;
};

// Makes polylines of the images of the curves. A polyline is at most `tolerance` pixels, or only a little more, from
// the image of its curve.
[[nodiscard]] ImageLines draw_lines(const base::Runtime& runtime, std::span<const Subject> subjects, double tolerance);

[[nodiscard]] inline const Subject& subject_of(std::span<const Subject> subjects, const Piece& piece) noexcept {
    HRBFNPR_ASSERT(piece.subject >= 0 && static_cast<std::size_t>(piece.subject) < subjects.size());
    return subjects[static_cast<std::size_t>(piece.subject)];
}

[[nodiscard]] inline curves::CubicPiece cubic(std::span<const Subject> subjects, const Piece& piece) noexcept {
    const base::Array<curves::CurvePoint>& point = subject_of(subjects, piece).curves->point;
    return {point[piece.a], point[piece.b]};
}

// Returns whether a border shows the inside of the surface. As seen from outside, the surface is to the left of a
// border. As seen from the eye, the surface is always to the left of a contour.
[[nodiscard]] bool shows_inside(std::span<const Subject> subjects, const Piece& piece) noexcept;

// Measures lengths along the images of lines. `lines` must outlive this object.
class LineLengths {
public:
    LineLengths(base::Memory& memory, const ImageLines& lines);

    // Returns the length from the start of the line to a place, in pixels. It is measured along the polyline, because
    // the position on the image of a cubic does not change at constant speed, least of all at a cusp.
    [[nodiscard]] double at(const Line& line, std::int64_t piece, double share) const noexcept;
    // Returns the length from the start of the line to a point of the image, in pixels.
    [[nodiscard]] double at_point(std::int64_t point) const noexcept { return length_[point]; }
    [[nodiscard]] double total(const Line& line) const noexcept { return length_[line.first_point + line.points - 1]; }
    // Returns the last piece of the line that begins at or before the length `at`.
    [[nodiscard]] std::int64_t piece_at(const Line& line, double at) const noexcept;

private:
    const ImageLines& lines_;
    base::Array<double> length_;      // for each image point: the length of its line up to there, in pixels
    base::Array<std::int64_t> first_; // for each piece: its first image point
};

// ---- Where the number of sheets before a line may change

struct Crossing {
    std::int32_t far_piece, near_piece;
    double far_share, near_share; // positions on the pieces, in [0, 1]
    std::int32_t change; // the change of the number of sheets before the farther line, in the direction of that line
    glm::dvec2 place;    // in pixels
    double gap;          // the distance between the curves in space, in sides of the mesh
    double sine;         // the sine of the angle between the images of the curves
};

struct CrossingReport {
    std::int64_t of_polylines = 0; // the number of crossings of segments
    std::int64_t rejected = 0;     // the number of crossings of segments that are no crossings of curves
    std::int64_t tangles = 0;      // the number of cells whose crossings are ignored, because there are too many
};

// Finds the crossings of all lines with those lines that begin or end sheets (Subject::sheet_change > 0). The result is
// sorted by the farther piece and the position on it.
[[nodiscard]] base::Array<Crossing> find_crossings(const base::Work& work, std::span<const Subject> subjects,
                                                   const ImageLines& lines, CrossingReport& report);

// Removes crossings that the curves do not have: beside a cusp, cubics may cross where the curve does not. Only
// crossings of curves that are near each other in space are tested. Returns the number of crossings removed.
std::int64_t verify_crossings(const base::Work& work, std::span<const Subject> subjects, const ImageLines& lines,
                              base::Array<Crossing>& crossings);

struct Piercing {
    std::int32_t piece;  // the piece of the line
    double share;        // the position on the piece, in [0, 1]
    std::int32_t item;   // the index of the surface's item among the occluders
    std::int32_t change; // the change of the number of sheets before the line, in the direction of the line: 1 or -1
};

// Finds where lines pass through the surfaces of items on which they do not lie. Between two places where f and its
// slope along the line are known, f is approximated by a cubic. If this cubic may have a root, the part is halved. The
// result is sorted by piece and share.
[[nodiscard]] base::Array<Piercing> find_piercings(const base::Work& work, std::span<const Subject> subjects,
                                                   std::span<const Occluder> occluders, const ImageLines& lines);

} // namespace hrbfnpr::visibility
