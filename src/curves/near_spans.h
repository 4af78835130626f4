// SPDX-License-Identifier: MIT
// Where along a segment the surface may be, by the triangles that stand for it.
#pragma once

#include "base/memory.h"
#include "curves/triangle_tree.h"
#include "geometry/vec_array.h"

#include <cstdint>

namespace hrbfnpr::curves {

// The part of a segment that lies in the mesh's region: origin + s direction, low <= s <= high.  It begins at the
// segment's end `to`, so that places near that are exact however far away the other end is.
struct Line {
    geometry::Bounds region;
    glm::dvec3 origin{0.0};
    glm::dvec3 direction{0.0};      // unit
    glm::dvec3 right{0.0}, up{0.0}; // these three are orthonormal
    double low = 0.0, high = -1.0;
    bool low_is_end = false, high_is_end = false; // of the segment; else of the region

    Line() = default;
    // What is nearer to `to` than `clear` does not belong to it.
    Line(const geometry::Bounds& within, const glm::dvec3& from, const glm::dvec3& to, double clear) noexcept;

    // A point relative to the origin, as seen along the line.
    [[nodiscard]] glm::dvec2 seen(const glm::dvec3& p) const noexcept { return {glm::dot(p, right), glm::dot(p, up)}; }
    [[nodiscard]] bool empty() const noexcept { return !(low < high); }
    [[nodiscard]] glm::dvec3 at(double s) const noexcept {
        return glm::clamp(origin + s * direction, region.min, region.max); // whatever was rounded
    }
};

// A part of a line in which f has to be looked at.
struct Span {
    double begin, end;
    std::int64_t line;
    std::int64_t places;    // how many, in order from begin to end, f is to be asked at first
    std::int32_t crossings; // of the line with triangles there
    bool line_begins, line_ends;
};

// The spans of some lines, and the places in all of them.
struct Spans {
    explicit Spans(base::Memory& memory) noexcept : span(memory), place(memory) {}

    base::Array<Span> span;
    base::Array<double> place;
};

// Finds spans line after line: working memory that is used again.
class SpanFinder {
public:
    SpanFinder(const SurfaceMesh& mesh, const TriangleTree& tree, base::Memory& memory) noexcept
        : mesh_(mesh), tree_(tree), near_(memory), crossing_(memory) {}

    // Adds those of a line.
    void find(const Line& line, std::int64_t number, Spans& found);

private:
    struct Range {
        double low, high;
        // Leaves what has at_zero + slope s <= 0.
        void keep(double at_zero, double slope) noexcept;
    };
    struct Crossing {
        double at;
        bool rising; // through the triangle, to where f > 0
    };

    void look_at(const Line& line, std::int64_t triangle);
    void merge_ranges() noexcept;
    void merge_crossings() noexcept;
    void add(const Line& line, const Range& range, std::int64_t number, Spans& found) const;

    const SurfaceMesh& mesh_;
    const TriangleTree& tree_;
    base::Array<Range> near_;
    base::Array<Crossing> crossing_;
};

} // namespace hrbfnpr::curves
