// SPDX-License-Identifier: MIT
// All lines of a drawing's items, traced for its camera, and the styles that they are drawn in.
#pragma once

#include "base/list.h"
#include "curves/level.h"
#include "features/line_set.h"
#include "frame/lines/width_laws.h"

#include <memory>
#include <span>

namespace hrbfnpr::frame {

// The contours of one item, or of one sheet of it.
struct Contours {
    explicit Contours(base::Memory& memory) noexcept : traced(memory), with_cusps(memory) {}

    std::shared_ptr<const void> set; // LineSet::identity()
    std::int64_t item = 0;
    std::int64_t part = 0;     // the number of the part in LineSet::parts(); 0 if the set has no parts
    glm::dvec4 eye{0.0};       // as View::eye
    curves::Curves traced;     // as traced, before cusps are added
    curves::Curves with_cusps; // these are drawn
    bool from_last = false;    // tracing began with the contours of the frame before
    std::int64_t broken = 0;   // contours that end inside the surface, and places where one was missed
};

// The contours of the last frame: those of the next begin there where the camera moved little.
class LastContours {
public:
    explicit LastContours(base::Memory& memory) noexcept : last_(memory), now_(memory) {}

    // The contours found since the last call become those of the last frame.
    void begin_frame() noexcept;
    // Finds those of an item in this view, which stay until the frame after the next. Seen from where the last frame
    // saw them, they are the same.
    const Contours& find(const base::Runtime& runtime, const curves::LineSet& lines, std::int64_t item,
                         std::int64_t part, const curves::ContourLevel& level, const curves::View& view,
                         const base::Progress& progress);
    // Whether any of this frame were begun with those of the last.
    [[nodiscard]] bool are_from_last() const noexcept;
    // The frame is drawn once more, from nothing.
    void forget() noexcept {
        last_.clear();
        now_.clear();
    }

private:
    base::List<std::unique_ptr<Contours>> last_, now_;
};

struct TracedLines {
    explicit TracedLines(base::Memory& memory) noexcept
        : subjects(memory), occluders(memory), items(memory), styles(memory), levels(memory), lines(memory),
          creases(memory), strengths(memory) {}

    base::Array<visibility::Subject> subjects;
    base::Array<visibility::Occluder> occluders;
    base::Array<std::int32_t> items; // the drawing's item of each occluder
    base::Array<DrawnAs> styles;
    std::int64_t broken = 0; // contours that end inside the surface, and places where one was missed
    // Subjects and styles refer to these.
    base::List<std::unique_ptr<curves::ContourLevel>> levels;
    base::List<std::unique_ptr<curves::SurfaceLines>> lines;
    base::List<std::unique_ptr<curves::CreaseParts>> creases;
    base::List<base::Array<float>> strengths;
};

// Adds a layer to the drawing for each style of lines. The contours stay in `last`.
[[nodiscard]] TracedLines trace_lines(const base::Runtime& runtime, const Scene& scene, std::span<const Item> items,
                                      LastContours& last, const base::Progress& progress, drawing::Drawing& drawing);

} // namespace hrbfnpr::frame
