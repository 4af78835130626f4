// SPDX-License-Identifier: MIT
// The exact area of each pixel that outlines of a stroke cover together where they overlap.
#pragma once

#include "base/memory.h"
#include "output/raster/stroke_outline.h"

#include <cstdint>

namespace hrbfnpr::output {

// The opacity and depth of a segment at the pixels that it covers. They change evenly along it.
struct Shade {
    float from, step_x, step_y; // the place along it: from + step . pixel, in [0, 1]
    float opacity, more_opacity;
    float window, more_window;
};

// Finds it row by row: between the heights where edges begin, end or cross their order does not change, and trapezoids
// lie between them. Inside is where the winding number is not 0. Each worker has one.
class alignas(base::Memory::alignment) StrokeUnion {
public:
    static constexpr std::int32_t most_side = 64; // the largest width and height of a tile, pixels

    explicit StrokeUnion(base::Memory& memory);

    // Begins a tile. A place that several outlines cover belongs to the nearest one if `by_depth` is set, else to the
    // first one.
    void begin(std::int32_t width, std::int32_t height, bool by_depth) noexcept;
    // Throws Error{out_of_memory}.
    void add(const Outline& outline, const Shade& shade);

    [[nodiscard]] std::int32_t top() const noexcept { return top_; }
    [[nodiscard]] std::int32_t bottom() const noexcept { return bottom_; }
    // Finds which pixels of a row are covered, and by which shades; returns the number of shades. Rows must be cut one
    // after the other, from top() to bottom().
    std::int32_t cut(std::int32_t y);
    // Writes how much of each pixel from `left` to `right` belongs to the row's i-th shade.
    const Shade& cover(std::int32_t i, float* pixels, std::int32_t& left, std::int32_t& right) noexcept;

private:
    // An edge goes from its upper to its lower end.
    struct Edge {
        double x, top, bottom, slope;
        std::int32_t winding; // the winding number to the right of the edge less that to the left
        std::int32_t shade;
        std::int32_t next; // the next edge that begins in the same row; -1: none
    };
    // The part of an edge in the row.
    struct Piece {
        double upper, lower, x, slope; // x: at height 0 of the tile
        double low, high;              // the least and the greatest x in the row
        std::int32_t winding, shade;
        double here; // x in the slab at hand
        [[nodiscard]] double at(double y) const noexcept { return x + y * slope; }
    };
    // A trapezoid between two edges, from one height to another.
    struct Span {
        double left_top, left_bottom, right_top, right_bottom, height;
        std::int32_t shade;
    };

    void find_pieces(std::int32_t y);
    void find_breaks(std::int32_t y);
    void add_crossings();
    void find_order(double y);
    void add_slab(double from, double to);
    void turn(std::int32_t shade, std::int32_t by);
    void add_span(const Piece& left, const Piece& right, double from, double to, std::int32_t shade);
    [[nodiscard]] std::int32_t owner(double x, double y) const noexcept;
    [[nodiscard]] bool same_shade(const Shade& a, const Shade& b) const noexcept;
    void add_edge(double x0, double x1, double height) noexcept;

    std::int32_t width_ = 0, height_ = 0, top_ = 0, bottom_ = 0;
    bool by_depth_ = false;
    base::Array<Edge> edges_;
    base::Array<Shade> shades_;
    base::Array<std::int32_t> winding_; // the winding number of each shade's outlines around the place at hand
    std::int32_t first_[most_side];     // the first edge that begins in each row; -1: none
    base::Array<std::int32_t> active_;  // edges that pass the row
    base::Array<Piece> pieces_;
    base::Array<double> breaks_;
    base::Array<std::int32_t> order_;  // the numbers of the pieces in a slab, from left to right
    base::Array<std::int32_t> inside_; // shades whose winding is not 0
    base::Array<Span> spans_;
    base::Array<std::int32_t> found_; // shades of the row
    double steps_[most_side + 2];     // the cover of each pixel less that of the pixel to its left
};

} // namespace hrbfnpr::output
