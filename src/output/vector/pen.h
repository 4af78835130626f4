// SPDX-License-Identifier: MIT
// The way of a pen: straight lines within the tolerance of a line, the way that it goes for a dot, and the time it
// takes.
#pragma once

#include "output/vector/page.h"

namespace hrbfnpr::output {

// Adds the points of a spiral by which a pen of this width fills a disc, from its middle outward.
void add_spiral(const PageDot& dot, double pen_width, double tolerance, base::Array<glm::dvec2>& points);

// The lines that a pen goes along. It holds working memory; its result is valid until the next call.
class PenLines {
public:
    explicit PenLines(base::Memory& memory) noexcept : places_(memory), line_(memory), keeps_(memory) {}

    // The fewest of the path's points from which no part of it is farther than the tolerance.
    std::span<const glm::dvec2> line(const PagePath& path, double tolerance);
    // A circle within the dot's rim that begins nearest to `from`, a spiral, or a point where the dot is no wider than
    // the pen.
    std::span<const glm::dvec2> line(const PageDot& dot, double pen, const ShapeSettings& settings,
                                     const glm::dvec2& from);

private:
    base::Array<glm::dvec2> places_, line_;
    base::Array<std::uint8_t> keeps_;
};

// Adds up the way of a pen, which begins raised in a corner.
class PenTrack {
public:
    PenTrack(PageCounts& counts, const PenSpeeds& speeds, const glm::dvec2& from) noexcept
        : counts_(counts), speeds_(speeds), place_(from) {}

    [[nodiscard]] const glm::dvec2& place() const noexcept { return place_; }
    // Goes there raised, unless it is there.
    void travel(const glm::dvec2& to) noexcept;
    void raise() noexcept { is_down_ = false; }
    // Goes there lowered, also to where it is.
    void draw(const glm::dvec2& to) noexcept;
    void draw(std::span<const glm::dvec2> line) noexcept;

private:
    PageCounts& counts_;
    PenSpeeds speeds_;
    glm::dvec2 place_;
    bool is_down_ = false;
};

} // namespace hrbfnpr::output
