// SPDX-License-Identifier: MIT
// Makes technical drawings: orthographic views and sections of a model on a sheet, to scale. The steps are, in order:
//
//   views.cpp        checks the descriptor and reads its texts
//   view_layout.cpp  finds the direction of each view, and chooses page, scale and the place of each view
//   view_lines.cpp   traces the lines of each view, and finds their hidden parts
//   view_order.cpp   draws coinciding lines once
//   cut_faces.cpp    hatches the cut faces
//   view_marks.cpp   adds frame, title block, names, cutting planes, centre lines and scale bar
//   views.cpp        writes the whole sheet as a page
#pragma once

#include "picture/call.h"
#include "picture/view_layout.h"

#include <hrbfnpr.h>

#include <optional>
#include <span>

namespace hrbfnpr::picture {

enum class HiddenLines : std::uint32_t { dashed, none, shown };
enum class TangentLines : std::uint32_t { cut_short, thin, none };

// The content of an hrbfnpr_views_desc.
struct ViewsOptions {
    explicit ViewsOptions(Pool& pool) : views(&pool), cuts(&pool), smooth(&pool), title(&pool), model(&pool) {}

    Vector<ViewName> views; // at least one, each once
    Vector<AskedCut> cuts;
    Projection projection = Projection::first;
    HiddenLines hidden = HiddenLines::dashed;
    TangentLines tangent = TangentLines::cut_short;
    bool centre_lines = false;
    bool labels = false;
    bool verify = false;
    bool unit_is_metre = false;      // True if a unit of the source is a metre. It is ignored if unit_mm is given.
    std::optional<SheetPage> paper;  // If empty, a paper that fits is chosen.
    std::optional<SheetScale> scale; // If empty, the largest scale that fits is chosen.
    std::optional<double> unit_mm;   // the length of a unit of the model in mm
    Vector<std::uint32_t> smooth;    // the kinds (HRBFNPR_LINE_KIND_*) of lines that are not sharp edges
    double crease_angle = 0.0;       // in degrees
    double line_width = 0.0;         // in mm
    double hatch_spacing = 0.0;      // in mm
    double spacing = 0.0;            // in mm
    String title;                    // If empty, the title is the model's name without its extension.
    String model;                    // the file name of the model
    hrbfnpr_page_desc page{};        // the format, tolerance and speeds of the output
};

// Reads and checks a descriptor. Throws Error{invalid_argument} that names the field and the values it may have.
[[nodiscard]] ViewsOptions read_views(const hrbfnpr_views_desc& desc, const Report& report);

// Draws the views of an object and writes the sheet, in the stages LINES and VIEWS. The object consists of the given
// surfaces. `up` may have any length except 0.
void write_views(const Call& call, std::span<const Surface> surfaces, const glm::dvec3& up, const ViewsOptions& options,
                 hrbfnpr_write_fn write, void* user, hrbfnpr_views_info& info);

} // namespace hrbfnpr::picture
