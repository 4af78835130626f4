// SPDX-License-Identifier: MIT
// A plate of finds: a drawing with an upright section through the middle at its right, and a scale bar below.
#pragma once

#include "picture/call.h"
#include "picture/lines.h"
#include "picture/page.h"

namespace hrbfnpr::picture {

[[nodiscard]] bool has_section(const Options& options) noexcept;
// The unit of the scale bar; empty: there is none.
[[nodiscard]] String unit_of_bar(const Options& options, Pool& pool);
// Whether there is more on the paper than the drawing.
[[nodiscard]] bool is_plate(const Options& options);

// The section that a plate needs in the line set of its surface: in the plane through the middle that the camera sees
// as an upright line.  Empty where there is no section.
[[nodiscard]] Vector<LinesOnce> section_lines(const Call& call, const Model& model, const hrbfnpr_camera& camera);

// What a plate is made of, beside its drawing.
struct Plate {
    const Model& model; // of the section and the scale: the largest part
    const PointSet& marks;
    const LineSet& lines;         // with section_lines(); null: there is no section
    const hrbfnpr_camera& camera; // of the drawing
    const Style& style;           // of the drawing: plates have its paper, and the ink of its contours
    std::string_view unit;        // of the scale bar; empty: there is none
};

// Pixels.
[[nodiscard]] glm::ivec2 plate_size(const Plate& plate, Pool& pool);

// Draws a plate into an image, from its top-left pixel on.  What has no room is cut off, and other pixels are not
// touched.  The caller's image may have any format.
void rasterize_plate(hrbfnpr_context& context, const Plate& plate, const Drawing& drawing, const hrbfnpr_image& image,
                     Pool& pool);

// The same for a page.
[[nodiscard]] PageContent plate_page(hrbfnpr_context& context, const Plate& plate, const Drawing& drawing, Pool& pool);

// 1, 2 or 5 times a power of ten, at most as long as this.  0: there is none.
[[nodiscard]] double bar_length(double longest) noexcept;

} // namespace hrbfnpr::picture
