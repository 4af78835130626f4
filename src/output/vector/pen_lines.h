// SPDX-License-Identifier: MIT
// What a pen does: straight lines within the tolerance of a line, and the way that it goes for a dot.
#pragma once

#include "output/vector/page.h"
#include "output/vector/shapes.h"

namespace hrbfnpr::output {

// Of a plotter where no pen says it, mm.
inline constexpr double plotter_pen = 0.3;

class PenLines {
public:
    explicit PenLines(base::Memory& memory) noexcept : line_(memory), keeps_(memory), waits_(memory) {}

    // The fewest points that Douglas and Peucker's way finds; no straight part is farther than the tolerance from what
    // it stands for.  Valid until the next call.
    std::span<const glm::dvec2> line(const PagePath& path, double tolerance);
    // A circle within the dot's rim that begins nearest to `from`, a spiral, or a point: what is no wider than the pen
    // is touched.
    std::span<const glm::dvec2> line(const PageDot& dot, double pen, const ShapeSettings& settings,
                                     const glm::dvec2& from);

private:
    struct Range {
        std::int64_t first, last;
    };
    base::Array<glm::dvec2> line_;
    base::Array<std::uint8_t> keeps_;
    base::Array<Range> waits_;
};

struct PenSpeeds {
    double draw = 30.0, travel = 80.0; // mm/s
    double seconds = 0.15;             // to lower or to raise it
};

// Adds up what a pen does, which begins raised in a corner.
class PenTrack {
public:
    PenTrack(PageCounts& counts, const PenSpeeds& speeds, const glm::dvec2& from) noexcept
        : counts_(counts), speeds_(speeds), place_(from) {}

    [[nodiscard]] const glm::dvec2& place() const noexcept { return place_; }
    // Raised, if it is not there.
    void travel(const glm::dvec2& to) noexcept;
    void raise() noexcept { is_down_ = false; }
    // Lowered, be it to where it is.
    void draw(const glm::dvec2& to) noexcept;
    void draw(std::span<const glm::dvec2> line) noexcept;

private:
    PageCounts& counts_;
    PenSpeeds speeds_;
    glm::dvec2 place_;
    bool is_down_ = false;
};

} // namespace hrbfnpr::output
