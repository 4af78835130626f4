// SPDX-License-Identifier: MIT
// Which way each view of a technical drawing looks, where it stands on the sheet, on which paper, and at which scale.
// Lengths on the sheet are mm, from its upper left corner, y grows downward.
#pragma once

#include "geometry/vec.h"
#include "picture/memory.h"
#include "picture/report.h"
#include "picture/shape.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace hrbfnpr::picture {

// ---- Texts

// The parts of a text between separators.
[[nodiscard]] Vector<std::string_view> split_text(std::string_view text, char separator, Pool& pool);

// ---- What is asked for

enum class Projection : std::uint32_t { first, third }; // angle [ISO 5456-2]

enum class ViewName : std::uint32_t { front, back, left, right, top, bottom, iso, section };

// A plane that cuts, as it is asked for: where `normal` . x is `place`.
struct AskedCut {
    glm::dvec3 normal{0.0};      // not 0, of any length
    std::optional<double> place; // nothing: through the middle of the model
    bool is_signed = false;      // whether the normal says from which side it is seen
};

struct SheetPage {
    String name;
    double width;
    double height;
};

struct SheetScale {
    String text;  // "1:2"
    double value; // 0.5
};

// Each reads a text, and throws Error{invalid_argument} that says what would be right.
[[nodiscard]] Vector<ViewName> parse_views(std::string_view text, const Report& report);         // "front,top"
[[nodiscard]] Vector<AskedCut> parse_sections(std::string_view text, const Report& report);      // "z:20;-x;1:1:0:5"
[[nodiscard]] std::optional<SheetPage> parse_paper(std::string_view text, const Report& report); // nothing: "auto"
[[nodiscard]] std::optional<SheetScale> parse_scale(std::string_view text, const Report& report);

// ---- Directions

// The model as it stands.  Unit vectors.
struct Standing {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 front;
};

// up: of any length but 0.
[[nodiscard]] Standing standing(const glm::dvec3& up) noexcept;

// Where `normal` . x is `place`.
struct CutPlane {
    String name;       // "A"
    glm::dvec3 normal; // unit, towards the eye of the section
    double place;
};

struct SheetView {
    ViewName kind = ViewName::front;
    String name;      // "front", "A-A"
    glm::dvec3 right; // unit vectors
    glm::dvec3 up;
    glm::dvec3 eye;        // towards the eye
    double factor = 1.0;   // how much larger than the scale it is drawn
    std::size_t plane = 0; // number of the plane, of a section

    [[nodiscard]] bool is_section() const noexcept { return kind == ViewName::section; }
    // Where a point is seen, from the middle: to the right and downward, in units of the model.
    [[nodiscard]] glm::dvec2 flat(const glm::dvec3& point, const glm::dvec3& middle) const noexcept {
        const glm::dvec3 away = point - middle;
        return factor * glm::dvec2(glm::dot(away, right), -glm::dot(away, up));
    }
    // Whether a plane is seen as a line.
    [[nodiscard]] bool is_edge_on(const glm::dvec3& normal) const noexcept;
};

// The middle of the box around the points that stands as the model does.  There are points.
[[nodiscard]] glm::dvec3 middle_of(const Points& points, const Standing& axes) noexcept;

// The planes, named A, B, ..., each seen from the front, from above or from the side that is drawn, unless it has a
// sign.
[[nodiscard]] Vector<CutPlane> planes_of(std::span<const AskedCut> cuts, std::span<const ViewName> names,
                                         const Standing& axes, const glm::dvec3& middle, Pool& pool);

// The views of these names, and then a section for each plane.
[[nodiscard]] Vector<SheetView> views_of(std::span<const ViewName> names, const Vector<CutPlane>& planes,
                                         const Standing& axes, Pool& pool);

// ---- Places on the sheet

struct SheetBox {
    double left, top, right, bottom;

    [[nodiscard]] SheetBox moved(const glm::dvec2& by) const noexcept {
        return {left + by.x, top + by.y, right + by.x, bottom + by.y};
    }
    [[nodiscard]] SheetBox grown(double by) const noexcept { return {left - by, top - by, right + by, bottom + by}; }
    [[nodiscard]] bool meets(const SheetBox& other) const noexcept {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

// The frame inside a page [ISO 5457].
[[nodiscard]] SheetBox frame_of(const SheetPage& page) noexcept;
// The title block in its lower right corner [ISO 7200].
[[nodiscard]] SheetBox block_of(const SheetPage& page) noexcept;

// A view with its place in the table of all views.
struct ViewCell {
    SheetView view;
    int column;
    int row;
    glm::dvec2 low; // the box around it from its centre, in units of the model
    glm::dvec2 high;
    bool has_label;
    Vector<glm::dvec3> cut_normals; // of the planes that are drawn in it
    Vector<std::size_t> cuts;       // their numbers

    // The box around the drawing alone, and with what stands around it; from its centre.  scale: mm of a unit.
    [[nodiscard]] SheetBox seen(double scale) const noexcept;
    [[nodiscard]] SheetBox box(double scale) const noexcept;
};

// The cells of the views, in their order.  Sections follow the other views to the right, or below if they are seen from
// above.  Each plane is drawn in the first view that sees it as a line.
[[nodiscard]] Vector<ViewCell> cells_of(Vector<SheetView> views, const Vector<CutPlane>& planes, const Points& points,
                                        const glm::dvec3& middle, Projection projection, const glm::dvec3& up,
                                        bool labels, Pool& pool);

struct SheetLayout {
    SheetPage page;
    SheetScale scale;
    double unit_scale;          // mm on the sheet of a unit of the model
    Vector<glm::dvec2> centres; // of each view
};

// What a layout has to keep to.
struct LayoutRules {
    double unit_mm; // of a unit of the model
    double spacing; // between views
    glm::dvec3 up;  // unit
};

// The layout on the page and at the scale that are given, or that fit.  Throws Error{invalid_argument} that says what
// would fit.
[[nodiscard]] SheetLayout choose_layout(const Vector<ViewCell>& cells, const std::optional<SheetPage>& page,
                                        const std::optional<SheetScale>& scale, const LayoutRules& rules,
                                        const Report& report);

// The scales of ISO 5455: 1, 2 and 5 times powers of ten, the largest first.
[[nodiscard]] Vector<SheetScale> standard_scales(Pool& pool);

} // namespace hrbfnpr::picture
