// SPDX-License-Identifier: MIT
// A page of drawings, as bytes of one of several formats.
#pragma once

#include "base/runtime.h"
#include "io/stream.h"
#include "output/vector/page.h"

namespace hrbfnpr::output {

struct Placement {
    const drawing::Drawing* drawing = nullptr;
    std::string_view name;
    double x = 0.0, y = 0.0;    // where the viewport's top-left corner is on the page, mm
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

// A line or a text beside the drawings.
struct Annotation {
    std::string_view group;
    const char* text = nullptr;     // NULL: a line
    std::span<const double> points; // x and y of each, mm; for a text, where its baseline begins
    double width = 0.35;
    glm::vec4 ink{0.0F, 0.0F, 0.0F, 1.0F};
    LineType line_type = LineType::continuous;
};

struct Page {
    PageInfo info; // its size is found
    std::span<const Placement> placements;
    std::span<const Pen> pens;
    std::span<const Annotation> annotations;
};

// The page's size, mm.
[[nodiscard]] glm::dvec2 page_size(const Page& page, const PageSettings& settings) noexcept;

PageCounts write_page(const base::Runtime& runtime, const Page& page, const PageSettings& settings, io::Writer& writer,
                      const base::Progress& progress);

} // namespace hrbfnpr::output
