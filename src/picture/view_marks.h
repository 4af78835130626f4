// SPDX-License-Identifier: MIT
// Draws the marks of a sheet. Each kind of line has its own layer. Beside the views there are the frame, the title
// block, symbols, names, cutting planes, centre lines and a scale bar.
#pragma once

#include "picture/handles.h"
#include "picture/lines.h"
#include "picture/view_layout.h"
#include "picture/view_polylines.h"

#include <hrbfnpr.h>

#include <array>
#include <span>
#include <string_view>

namespace hrbfnpr::picture {

// The kinds of lines, in the order in which a page draws them.
enum class SheetKind : std::uint32_t {
    hatching,
    centre_lines,
    smooth,
    tangent,
    hidden,
    cutting_planes,
    outlines,
    cutting_ends,
    frame,
    title_block,
    projection,
    projection_axes,
    scale_bar,
    scale_fields,
    texts
};

// The lines and texts of one kind in one view. They form a layer of the page.
struct SheetLayer {
    SheetKind kind;
    String view;             // the name of the view, or empty
    Vector<PaperLine> lines; // The lines. In a layer of texts, each has one point: the start of the baseline.
    Vector<String> texts;    // In a layer of texts, one text for each element of `lines`; else empty.
    Vector<double> capitals; // the height of each text in mm
};

// All marks on a sheet.
struct SheetContent {
    SheetContent(double width, bool hidden_as_shown, Pool& pool)
        : line_width(width), hidden_is_continuous(hidden_as_shown), layers(&pool) {}

    double line_width;         // the width of outlines in mm
    bool hidden_is_continuous; // If false, hidden lines are dashed.
    LineProof proof;           // the results of verifying the lines of all views
    Vector<SheetLayer> layers; // in the order in which they were first used

    void add(SheetKind kind, std::span<const glm::dvec2> line, std::string_view view = {});
    void add(SheetKind kind, std::initializer_list<glm::dvec2> line, std::string_view view = {}) {
        add(kind, std::span(line.begin(), line.size()), view);
    }
    // Adds a text whose baseline starts at a place, or is centred there.
    void add_text(const glm::dvec2& at, std::string_view text, double capitals, bool is_centred = false);

private:
    [[nodiscard]] SheetLayer& layer_of(SheetKind kind, std::string_view view);
};

// The content in the form that a page takes, with the pens for plotters: pen 1 is wide, pen 2 is fine.
struct SheetAnnotations {
    explicit SheetAnnotations(Pool& pool) : groups(&pool), list(&pool), pens(&pool) {}

    Vector<String> groups; // the names to which the lists point
    Vector<hrbfnpr_annotation> list;
    Vector<hrbfnpr_pen> pens;
};
// Converts the content into annotations. These point to the content, which must outlive them.
[[nodiscard]] SheetAnnotations annotations_of(const SheetContent& content, Pool& pool);

// ---- Beside the views

struct SheetFacts {
    std::string_view title;
    std::string_view model; // the name of the model's file
    std::string_view scale;
    std::string_view page;
};

// Draws the frame around the sheet [ISO 5457].
void add_frame(SheetContent& content, const SheetPage& page);
// Draws the title block in the lower right corner [ISO 7200], with the symbol of the projection [ISO 5456-2].
void add_title_block(SheetContent& content, const SheetPage& page, const SheetFacts& facts, Projection projection,
                     Pool& pool);
// Draws a scale bar of five fields in the lower left corner. `scale` is in mm on the paper per mm of the model.
void add_scale_bar(SheetContent& content, const SheetPage& page, double scale, Pool& pool);

// ---- In a view

// A view on the sheet.
struct PlacedView {
    const SheetView& view;
    double scale;      // mm per unit of the model
    glm::dvec2 centre; // on the sheet
    SheetBox seen;     // the box around the view's drawing
    SheetBox box;      // the bounding box of the drawing and its annotations
};

// Adds the name above the view.
void add_view_name(SheetContent& content, const PlacedView& placed);
// Marks the position of a section by a line. Its thick ends have letters, and arrows in the direction of sight [ISO
// 128-3].
void add_cutting_plane(SheetContent& content, const PlacedView& placed, const CutPlane& plane,
                       const glm::dvec3& middle);
// Draws the line of a plane of symmetry through the middle, if the view sees the plane as a line.
void add_centre_line(SheetContent& content, const PlacedView& placed, const glm::dvec3& normal);

// Returns the width of a text in Helvetica whose capitals have this height.
[[nodiscard]] double width_of_sheet_text(std::string_view text, double capitals) noexcept;
// Returns the largest number of the form 1, 2 or 5 times a power of ten that is at most `longest`, which must be above
// 0 and finite.
[[nodiscard]] double length_of_bar(double longest) noexcept;

} // namespace hrbfnpr::picture
