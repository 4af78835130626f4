// SPDX-License-Identifier: MIT
// The data that the steps of a frame of lines share: all lines of its items, traced for its camera; their numbers; and
// their strokes.
#pragma once

#include "features/line_set.h"
#include "frame/lines/line_frame.h"
#include "visibility/invisibility.h"

namespace hrbfnpr::frame {

// The lines of a subject that one layer of the drawing shows.
struct DrawnSubject {
    const LineStyle* style;
    std::int32_t subject;
    std::uint32_t layer;
    const float* strength = nullptr;  // the strength at each point of the subject's curves; null: all are equal
    float lower = 0.0F, upper = 0.0F; // A line fades between these two strengths.
    float halo = 0.0F; // the gap in pixels between a nearer line and the end of this line, by the item's style
    bool cut = false;  // True if parts weaker than `lower` are not drawn.
    const float* factor = nullptr; // the factor of the width at each point of the subject's curves; null: all are 1
};

struct TracedLines {
    explicit TracedLines(base::Memory& memory) noexcept
        : subjects(memory), occluders(memory), items(memory), styles(memory), contours(memory), levels(memory),
          lines(memory), creases(memory), parts(memory), intersections(memory), numbers(memory) {}

    base::Array<visibility::Subject> subjects;
    base::Array<visibility::Occluder> occluders;
    base::Array<std::int32_t> items; // for each occluder: the index of its item in the drawing
    base::Array<DrawnSubject> styles;
    // The number of contours that end inside the surface, plus the number of places where a contour was missed.
    std::int64_t broken = 0;
    // The contours, to which subjects and styles refer.
    ContourList contours;
    base::List<std::unique_ptr<curves::ContourLevel>> levels;
    base::List<std::unique_ptr<curves::SurfaceLines>> lines;
    base::List<std::unique_ptr<curves::CreaseParts>> creases;
    base::List<std::unique_ptr<curves::Curves>> parts; // the parts of intersections that face the eye alike
    IntersectionList intersections;
    base::List<base::Array<float>> numbers; // the arrays of strengths and factors
};

// The numbers of lines. A line keeps its number from frame to frame. It is recognized by its place on the surface.
struct LineNumbers {
    explicit LineNumbers(base::Memory& memory) noexcept : number(memory), origin(memory) {}

    base::Array<std::uint32_t> number; // for each line: its number, from 1 on
    // for each line: the piece that contains the place where the line's first piece began when the line was new
    base::Array<std::int64_t> origin;
};

struct LineInput {
    const base::Runtime& runtime;
    const Scene& scene;
    TracedLines& traced; // the traced lines, whose styles receive the factors of the widths
    const visibility::Invisibility& found;
    const visibility::LineLengths& lengths;
    const LineNumbers& numbers;

    [[nodiscard]] const visibility::Line& line(std::int64_t l) const noexcept { return found.lines.lines[l]; }
    [[nodiscard]] const visibility::Piece& piece(std::int64_t p) const noexcept { return found.lines.pieces[p]; }
    [[nodiscard]] const visibility::Subject& subject(const visibility::Line& l) const noexcept {
        return found.subjects[l.subject];
    }
    [[nodiscard]] double total(std::int64_t l) const noexcept { return lengths.total(line(l)); }
};

// A part of a line that is hidden by the same number of surface layers everywhere.
struct LinePart {
    visibility::Interval interval; // The interval of the line. Its member `sheets` is not used.
    std::int32_t layers;           // The number of surface layers that hide it. Each layer is two sheets.
    // True if no other part continues at the end, as at cusps and at the ends of open lines.
    bool free_begin, free_end;
};

// A place along a line.
struct StrokePlace {
    double at; // distance along the line, in pixels
    std::int32_t piece;
    double share;
};

// Returns a place along a line. On a closed line, `at` may be beyond the end of the line.
[[nodiscard]] StrokePlace place_along(const LineInput& in, std::int32_t line, double at) noexcept;

// Compares all parts of the wanted subjects with rays from the eye, and returns the parts as the rays show them. Adds
// the numbers of parts that agree, are undecided and were repaired to the counts. `wanted` is 1 for each subject to
// verify. The parts must have the order of their lines, and of their places along them.
[[nodiscard]] base::Array<LinePart> verify_parts(const base::Work& work, const LineInput& in,
                                                 base::Array<LinePart> parts, std::span<const std::uint8_t> wanted,
                                                 drawing::LineCounts& counts);

// The depths between which `far_factor` changes the widths of lines.
struct DepthRange {
    double nearest = 0.0;
    double length = 0.0; // 0: widths do not change

    // Returns 0 at the nearest depth, 1 at the farthest, and a number between them elsewhere.
    [[nodiscard]] double share(double depth) const noexcept;
};

// Returns the range of depths of the surfaces in the window. It changes smoothly with the camera. It is longer than
// that of surfaces that are flat and seen from above, so that small differences of depth do not look large.
[[nodiscard]] DepthRange find_depth_range(const LineInput& in);

// A range on the way from one place to the next, as shares of the way. It is empty if low > high.
struct ShareRange {
    double low, high;
};

// Returns the range of a chord that is in the window, or at most `beside` pixels outside. The window has the corner x,
// y and the size z, w.
[[nodiscard]] ShareRange chord_in_window(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec4& window,
                                         double beside) noexcept;

// Thins lines that run beside weightier lines, nearer than about a pen, and removes the parts of them without width.
// `layers` are those of the drawing.
void thin_lines_beside_others(const LineInput& in, std::span<const drawing::Layer> layers, LineStrokes& strokes);

// Adds the strokes of all lines. Verifies the lines whose styles want it, and adds their counts to the drawing. Throws
// Error{callback, out_of_memory}.
void add_strokes(const LineInput& in, drawing::Drawing& drawing, const base::Progress& progress, LineStrokes& strokes);

} // namespace hrbfnpr::frame
