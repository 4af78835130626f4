// SPDX-License-Identifier: MIT
// The contours of the last frame: those of the next begin there where the camera moved little.
#pragma once

#include "base/list.h"
#include "curves/level.h"
#include "features/line_set.h"

#include <cstdint>
#include <memory>

namespace hrbfnpr::frame {

// Of one item.
struct Contours {
    explicit Contours(base::Memory& memory) noexcept : traced(memory), with_cusps(memory) {}

    std::shared_ptr<const void> set; // LineSet::identity()
    std::int64_t item = 0;
    std::int64_t part = 0;     // of LineSet::parts(); 0 where there are none
    glm::dvec4 eye{0.0};       // as of a View
    curves::Curves traced;     // no points added
    curves::Curves with_cusps; // those to be drawn
    bool from_last = false;    // begun with those of the frame before
    std::int64_t broken = 0;   // that end inside the surface, and places where one was missed
};

class LastContours {
public:
    explicit LastContours(base::Memory& memory) noexcept : last_(memory), now_(memory) {}

    // What find() found since the last call is the last frame.
    void begin_frame() noexcept;
    // Those of an item in this view, which stay until the frame after the next.  Seen from where the last frame saw
    // them, they are the same.
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
    [[nodiscard]] std::unique_ptr<Contours> take(const curves::LineSet& lines, std::int64_t item,
                                                 std::int64_t part) noexcept;

    base::List<std::unique_ptr<Contours>> last_, now_;
};

} // namespace hrbfnpr::frame
