// SPDX-License-Identifier: MIT
// From a drawing in pixels to groups on a page: one for each layer of ink, and for each number of layers that hide it.
#pragma once

#include "output/vector/page.h"

namespace hrbfnpr::output {

struct Placement {
    const drawing::Drawing* drawing = nullptr;
    std::string_view name;
    double x = 0.0, y = 0.0;    // of the viewport's top-left corner, mm
    double scale = 25.4 / 96.0; // mm per pixel
    bool with_paper = true;     // else the page has the same
    bool far_to_near = true;    // where inks of several colours lie upon each other; else groups are whole
};

// A pen for the groups whose name it has.
struct Pen {
    std::string_view groups; // a name, the beginning of one before a '*', or nothing: all
    double width = 0.0;      // mm; 0: as drawn
    glm::vec4 ink{0.0F};     // alpha 0: as drawn
    std::uint32_t number = 1;
    LineType line_type{};
};

// The placement's viewport on the page.
[[nodiscard]] Frame frame_of(const Placement& placement) noexcept;

// The group with its pen: the last one that fits its name.
[[nodiscard]] PageGroup with_pen(PageGroup group, std::span<const Pen> pens) noexcept;

// Hands a drawing's ink on, group by group, strokes far to near; groups begin anew where far to near must be kept.
// Strokes whose opacity changes are cut into parts of an even one.
void lay_out(base::Memory& memory, const Placement& placement, std::span<const Pen> pens, PageSink& sink,
             const base::Progress& progress);

} // namespace hrbfnpr::output
