// SPDX-License-Identifier: MIT
// Makes the strokes of lines: curves traced for this camera, with their visibility, widths and parts by style.
#pragma once

#include "base/list.h"
#include "base/runtime.h"
#include "curves/curves.h"
#include "frame/scene/scene.h"

#include <memory>
#include <span>

namespace hrbfnpr::frame {

// The contours of one item, or of one sheet of it.
struct Contours {
    explicit Contours(base::Memory& memory) : traced(memory), with_cusps(memory) {}

    std::shared_ptr<const void> set; // LineSet::identity()
    std::int64_t item = 0;
    std::int64_t part = 0;     // the number of the part in LineSet::parts(); 0 if the set has no parts
    glm::dvec4 eye{0.0};       // as View::eye
    curves::Curves traced;     // as traced, before cusps are added
    curves::Curves with_cusps; // the contours with cusps, which are drawn
    bool from_last = false;    // tracing began with the contours of the last frame
    // The number of contours that end inside the surface, and of places where a contour was missed.
    std::int64_t broken = 0;
};
using ContourList = base::List<std::unique_ptr<Contours>>;

// Two frames may have the same line only within a family, which is a line set, an item and a subject.
struct LineFamily {
    const void* set;
    std::int64_t item;
    std::int64_t number; // the number of its subject among the subjects of the item

    friend bool operator==(const LineFamily&, const LineFamily&) = default;
};

// The data about a frame's lines from which the next frame numbers its own lines.
struct KnownLines {
    explicit KnownLines(base::Memory& memory) noexcept : line(memory), place(memory), direction(memory) {}

    struct KnownLine {
        LineFamily family;
        std::int64_t first, count; // the range of its points
        std::uint32_t number;
        glm::dvec3 origin; // the place where the line's first piece began when the line was new, or a place near it
    };
    base::Array<KnownLine> line;
    geometry::VecArray place, direction; // some points of the lines, and the directions there
    std::uint32_t number = 0;            // the last number that was given
};

class LineFrame {
public:
    explicit LineFrame(const base::Runtime& runtime) noexcept
        : runtime_(runtime), strokes_(runtime.memory), contours_(runtime.memory), known_(runtime.memory) {}

    // Draws the lines of the items that have lines and styles for them, and adds their layers and counts to the
    // drawing. All items with lines hide each other's lines. Throws Error{callback, cancelled, out_of_memory}.
    const LineStrokes& run(const Scene& scene, std::span<const Item> items, const base::Progress& progress,
                           drawing::Drawing& drawing);
    // Called after a frame that was not finished. The next frame then uses no contours of the last frame.
    void forget() noexcept { contours_.clear(); }

private:
    const base::Runtime& runtime_;
    LineStrokes strokes_;
    ContourList contours_; // contours of the last frame; tracing begins with them where the camera moved little
    KnownLines known_;
};

} // namespace hrbfnpr::frame
