// SPDX-License-Identifier: MIT
// A page of drawings, as bytes of one of several formats.
#pragma once

#include "base/runtime.h"
#include "io/stream.h"
#include "output/vector/lay_out.h"

namespace hrbfnpr::output {

struct PlotSettings {
    double join = 0.0, shortest = 0.0, dot_distance = 0.0; // mm; 0: by the pen's width
    double draw_speed = 30.0, travel_speed = 80.0;         // mm/s
    double pen_seconds = 0.15;
    const char* pen_down = nullptr;
    const char* pen_up = nullptr;
};

struct PageSettings {
    PageFormat format = PageFormat::svg;
    bool in_plot_order = false;
    bool without_paper = false;
    double width = 0.0, height = 0.0; // 0: to where the drawings reach
    ShapeSettings shapes;
    PlotSettings plot;
};

// A line or a text beside the drawings.
struct Annotation {
    std::string_view group;
    const char* text = nullptr;     // NULL: a line
    std::span<const double> points; // x, y ...
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
