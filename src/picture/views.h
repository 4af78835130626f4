// SPDX-License-Identifier: MIT
// A technical drawing: orthographic views and sections of a model on a sheet, to scale.  How one comes about, in order:
//
//   views.cpp        the descriptor is checked, its texts are read
//   view_layout.cpp  which way each view looks; page, scale, and the place of each view
//   view_lines.cpp   lines of each view, and which parts of them are hidden
//   view_order.cpp   lines that coincide: one of them is drawn
//   cut_faces.cpp    hatching of what is cut
//   view_marks.cpp   frame, title block, names, cutting planes, centre lines, scale bar
//   views.cpp        all of it is written as a page
#pragma once

#include "picture/call.h"
#include "picture/view_layout.h"

#include <hrbfnpr.h>

#include <optional>

namespace hrbfnpr::picture {

enum class HiddenLines : std::uint32_t { dashed, none, shown };

// hrbfnpr_views_desc, read.
struct ViewsOptions {
    explicit ViewsOptions(Pool& pool) : views(&pool), cuts(&pool), smooth(&pool), title(&pool), model(&pool) {}

    Vector<ViewName> views; // one and more, each once
    Vector<AskedCut> cuts;
    Projection projection = Projection::first;
    HiddenLines hidden = HiddenLines::dashed;
    bool centre_lines = false;
    bool labels = false;
    bool unit_is_metre = false;      // of the source, where unit_mm says nothing
    std::optional<SheetPage> paper;  // nothing: the one that fits
    std::optional<SheetScale> scale; // nothing: the largest that fits
    std::optional<double> unit_mm;   // mm of a unit of the model
    Vector<std::uint32_t> smooth;    // HRBFNPR_LINE_KIND_... of lines that are not sharp
    double crease_angle = 0.0;       // degrees
    double line_width = 0.0;         // mm
    double hatch_spacing = 0.0;      // mm
    double spacing = 0.0;            // mm
    String title;                    // empty: the model's name without its ending
    String model;                    // its file's name
    hrbfnpr_page_desc page{};        // format, tolerance, speeds
};

// Reads and checks.  Throws Error{invalid_argument} that names the field and says what would be right.
[[nodiscard]] ViewsOptions read_views(const hrbfnpr_views_desc& desc, const Report& report);

// Draws the surface's views and writes the sheet, as the stages LINES and VIEWS.  up: of any length but 0.
void write_views(const Call& call, const Surface& surface, const glm::dvec3& up, const ViewsOptions& options,
                 hrbfnpr_write_fn write, void* user, hrbfnpr_views_info& info);

} // namespace hrbfnpr::picture
