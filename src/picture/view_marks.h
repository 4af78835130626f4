// SPDX-License-Identifier: MIT
// What stands on a sheet: lines of each kind in a layer of its own, and beside the views the frame, the title block,
// symbols, names, cutting planes, centre lines and a scale bar.
#pragma once

#include "picture/handles.h"
#include "picture/view_layout.h"
#include "picture/view_polylines.h"

#include <hrbfnpr.h>

#include <array>
#include <span>
#include <string_view>

namespace hrbfnpr::picture {

// Kinds of lines, in the order of the page.
enum class SheetKind : std::uint32_t {
    hatching,
    centre_lines,
    smooth,
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

// Lines and texts of one kind and one view: a layer of the page.
struct SheetLayer {
    SheetKind kind;
    String view;             // its name; empty: of none
    Vector<PaperLine> lines; // of texts: where their baselines begin
    Vector<String> texts;    // as many as lines; none of lines
    Vector<double> capitals; // mm, of each text
};

// All that stands on a sheet.
struct SheetContent {
    SheetContent(double width, bool hidden_as_shown, Pool& pool)
        : line_width(width), hidden_is_continuous(hidden_as_shown), layers(&pool) {}

    double line_width;         // mm, of outlines
    bool hidden_is_continuous; // else dashed
    Vector<SheetLayer> layers; // in the order in which they began

    void add(SheetKind kind, std::span<const glm::dvec2> line, std::string_view view = {});
    void add(SheetKind kind, std::initializer_list<glm::dvec2> line, std::string_view view = {}) {
        add(kind, std::span(line.begin(), line.size()), view);
    }
    // From a place on the baseline, or around it.
    void add_text(const glm::dvec2& at, std::string_view text, double capitals, bool is_centred = false);

private:
    [[nodiscard]] SheetLayer& layer_of(SheetKind kind, std::string_view view);
};

// The content as what a page takes, and the pens for plotters: the wide pen is 1, the fine one 2.
struct SheetAnnotations {
    explicit SheetAnnotations(Pool& pool) : groups(&pool), list(&pool), pens(&pool) {}

    Vector<String> groups; // names that the lists refer to
    Vector<hrbfnpr_annotation> list;
    Vector<hrbfnpr_pen> pens;
};
// Refers to the content while it lives.
[[nodiscard]] SheetAnnotations annotations_of(const SheetContent& content, Pool& pool);

// ---- Beside the views

struct SheetFacts {
    std::string_view title;
    std::string_view model; // the file
    std::string_view scale;
    std::string_view page;
};

// Around all of the sheet [ISO 5457].
void add_frame(SheetContent& content, const SheetPage& page);
// In the lower right corner [ISO 7200], with the symbol of the projection [ISO 5456-2].
void add_title_block(SheetContent& content, const SheetPage& page, const SheetFacts& facts, Projection projection,
                     Pool& pool);
// Five fields in the lower left corner.  scale: mm on the paper of one mm of the model.
void add_scale_bar(SheetContent& content, const SheetPage& page, double scale, Pool& pool);

// ---- In a view

// A view on the sheet.
struct PlacedView {
    const SheetView& view;
    double scale;      // mm of a unit of the model
    glm::dvec2 centre; // on the sheet
    SheetBox seen;     // around its drawing
    SheetBox box;      // and around what stands beside that
};

// The name above the view.
void add_view_name(SheetContent& content, const PlacedView& placed);
// Where a section is: a line whose thick ends have arrows in the direction of sight, and letters [ISO 128-3].
void add_cutting_plane(SheetContent& content, const PlacedView& placed, const CutPlane& plane,
                       const glm::dvec3& middle);
// A plane of symmetry through the middle, where it is seen as a line.
void add_centre_line(SheetContent& content, const PlacedView& placed, const glm::dvec3& normal);

// The width of a text in Helvetica, whose capitals have this height.
[[nodiscard]] double width_of_sheet_text(std::string_view text, double capitals) noexcept;
// 1, 2 or 5 times a power of ten, at most as long as this, which is above 0 and finite.
[[nodiscard]] double length_of_bar(double longest) noexcept;

} // namespace hrbfnpr::picture
