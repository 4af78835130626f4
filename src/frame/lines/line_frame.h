// SPDX-License-Identifier: MIT
// Makes the strokes of lines: traces curves for this camera, and finds their visibility, widths and parts by the style.
#pragma once

#include "base/list.h"
#include "base/runtime.h"
#include "curves/curves.h"
#include "features/intersections.h"
#include "frame/scene/scene.h"

#include <memory>
#include <span>

namespace hrbfnpr::frame {

// The contours of an item, or of one sheet of an item.
struct Contours {
    explicit Contours(base::Memory& memory) : traced(memory), with_cusps(memory) {}

    std::shared_ptr<const void> set; // the identity of the line set, from LineSet::identity()
    std::int64_t item = 0;
    std::int64_t part = 0;     // the index of the sheet in LineSet::parts(); 0 if the set has no parts
    glm::dvec4 eye{0.0};       // the eye, as in View::eye
    curves::Curves traced;     // the contours as traced, without cusps
    curves::Curves with_cusps; // the contours with cusps; these are drawn
    bool from_last = false;    // true if tracing began with the contours of the last frame
    // The number of contours that end inside the surface, plus the number of places where a contour was missed.
    std::int64_t broken = 0;
};
using ContourList = base::List<std::unique_ptr<Contours>>;

// The curves in which the surfaces of two items cross.
struct ItemIntersections {
    explicit ItemIntersections(base::Memory& memory) noexcept : found(memory) {}

    std::shared_ptr<const void> set, other_set; // the identities of the line sets
    std::int64_t item = 0, other = 0;           // The curves are drawn as lines of `item`.
    glm::dmat4 to_other{1.0};                   // maps the coordinates of `item` to those of `other`
    curves::Intersections found;
};
using IntersectionList = base::List<std::unique_ptr<ItemIntersections>>;

// A line set, an item and a subject. Only lines of the same family can be the same line in two frames.
struct LineFamily {
    const void* set;
    std::int64_t item;
    std::int64_t number; // the index of the subject among the item's subjects

    friend bool operator==(const LineFamily&, const LineFamily&) = default;
};

// The data about a frame's lines that the next frame needs to give lines the same numbers.
struct KnownLines {
    explicit KnownLines(base::Memory& memory) noexcept : line(memory), place(memory), direction(memory) {}

    struct KnownLine {
        LineFamily family;
        std::int64_t first, count; // the range of the line's points
        std::uint32_t number;
        glm::dvec3 origin; // The place where the line's first piece began when the line was new, or a place near it.
    };
    base::Array<KnownLine> line;
    geometry::VecArray place, direction; // some points of each line, and the directions of the line there
    std::uint32_t number = 0;            // the last number used
};

class LineFrame {
public:
    explicit LineFrame(const base::Runtime& runtime) noexcept
        : runtime_(runtime), strokes_(runtime.memory), contours_(runtime.memory), intersections_(runtime.memory),
          known_(runtime.memory) {}

    // Draws the lines of all items that have lines and styles for them. Adds the layers and counts of these lines to
    // the drawing. All items with lines hide each other's lines. Throws Error{callback, cancelled, out_of_memory}.
    const LineStrokes& run(const Scene& scene, std::span<const Item> items, const base::Progress& progress,
                           drawing::Drawing& drawing);
    // Call this after a frame that failed. The next frame then uses no earlier contours.
    void forget() noexcept {
        contours_.clear();
        intersections_.clear();
    }

private:
    const base::Runtime& runtime_;
    LineStrokes strokes_;
    ContourList contours_; // The contours of the last frame. If the camera moves little, tracing begins with them.
    IntersectionList intersections_; // The intersections of the last frame. Items that keep their poses keep them.
    KnownLines known_;
};

} // namespace hrbfnpr::frame
