// SPDX-License-Identifier: MIT
// Draws a plate of an archaeological find: the drawing, a vertical section through the middle at its right, and a scale
// bar below.
#pragma once

#include "picture/call.h"
#include "picture/lines.h"
#include "picture/page.h"

namespace hrbfnpr::picture {

[[nodiscard]] bool has_section(const Options& options) noexcept;
// Returns the unit of the scale bar, or an empty text if the plate has no bar.
[[nodiscard]] String unit_of_bar(const Options& options, Pool& pool);
// Returns whether the paper shows a section or scale bar besides the drawing.
[[nodiscard]] bool is_plate(const Options& options);

// Returns the section that a plate needs in the line set of its surface. Its plane passes through the middle, and the
// camera sees the plane as a vertical line. The list is empty if the plate has no section.
[[nodiscard]] Vector<LinesOnce> section_lines(const Call& call, const Model& model, const hrbfnpr_camera& camera);

// The inputs of a plate, besides its drawing.
struct Plate {
    const Model& model; // the model for the section and the scale: the largest part
    const PointSet& marks;
    const LineSet& lines;         // a line set with section_lines(); null without a section
    const hrbfnpr_camera& camera; // the camera of the drawing
    const Style& style;           // the style of the drawing; its paper and its contour ink are used
    std::string_view unit;        // the unit of the scale bar; empty without a bar
};

// Returns the size of a plate in pixels.
[[nodiscard]] glm::ivec2 plate_size(const Plate& plate, Pool& pool);

// Draws a plate into an image of any format, from the top-left pixel on. Parts outside the image are cut off, and
// pixels outside the plate are unchanged.
void rasterize_plate(hrbfnpr_context& context, const Plate& plate, const Drawing& drawing, const hrbfnpr_image& image,
                     Pool& pool);

// Draws a plate on a page.
[[nodiscard]] PageContent plate_page(hrbfnpr_context& context, const Plate& plate, const Drawing& drawing, Pool& pool);

// Returns the largest number of the form 1, 2 or 5 times a power of ten that is at most `longest`, or 0 if there is no
// such number.
[[nodiscard]] double bar_length(double longest) noexcept;

} // namespace hrbfnpr::picture
