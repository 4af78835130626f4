// SPDX-License-Identifier: MIT
// Chooses the direction of each view of a technical drawing, its place on the sheet, the paper, and the scale. Lengths
// on the sheet are in mm from its upper left corner; y grows downward.
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

// Splits a text at separators.
[[nodiscard]] Vector<std::string_view> split_text(std::string_view text, char separator, Pool& pool);

// ---- Requests

enum class Projection : std::uint32_t { first, third }; // the first-angle or third-angle projection [ISO 5456-2]

enum class ViewName : std::uint32_t { front, back, left, right, top, bottom, iso, section };

// A requested cutting plane: all x with `normal` . x = `place`.
struct AskedCut {
    glm::dvec3 normal{0.0};      // a vector with any length except 0
    std::optional<double> place; // If empty, the plane passes through the middle of the model.
    // True if the caller gives the sign of the normal. The normal then points towards the viewer of the section.
    bool is_signed = false;
};

struct SheetPage {
    String name;
    double width;
    double height;
};

struct SheetScale {
    String text;  // the scale as text, such as "1:2"
    double value; // the scale as a number, such as 0.5
};

// These functions parse texts. They throw Error{invalid_argument} with the valid texts.
[[nodiscard]] Vector<ViewName> parse_views(std::string_view text, const Report& report); // for example "front,top"
// For example "z:20;-x;1:1:0:5".
[[nodiscard]] Vector<AskedCut> parse_sections(std::string_view text, const Report& report);
// For "auto" the result is nullopt.
[[nodiscard]] std::optional<SheetPage> parse_paper(std::string_view text, const Report& report);
[[nodiscard]] std::optional<SheetScale> parse_scale(std::string_view text, const Report& report);

// ---- Directions

// The unit vectors of the model's directions: right, up and front.
struct Standing {
    glm::dvec3 right;
    glm::dvec3 up;
    glm::dvec3 front;
};

// Returns the directions for an up vector of any length except 0.
[[nodiscard]] Standing standing(const glm::dvec3& up) noexcept;

// A cutting plane: all x with `normal` . x = `place`.
struct CutPlane {
    String name;       // a letter, such as "A"
    glm::dvec3 normal; // a unit vector towards the viewer of the section
    double place;
};

struct SheetView {
    ViewName kind = ViewName::front;
    String name;      // such as "front" or "A-A"
    glm::dvec3 right; // The unit vectors to the right and up in the view.
    glm::dvec3 up;
    glm::dvec3 eye;        // a unit vector towards the eye
    double factor = 1.0;   // The view is drawn at the scale times this factor.
    std::size_t plane = 0; // for a section: the index of its plane

    [[nodiscard]] bool is_section() const noexcept { return kind == ViewName::section; }
    // Returns the position of a point in the view relative to the middle, to the right and downward, in units of the
    // model.
    [[nodiscard]] glm::dvec2 flat(const glm::dvec3& point, const glm::dvec3& middle) const noexcept {
        const glm::dvec3 away = point - middle;
        return factor * glm::dvec2(glm::dot(away, right), -glm::dot(away, up));
    }
    // Tells whether the view sees a plane as a line.
    [[nodiscard]] bool is_edge_on(const glm::dvec3& normal) const noexcept;
};

// Returns the middle of the bounding box of the points along the model's directions. There must be at least one point.
[[nodiscard]] glm::dvec3 middle_of(const Points& points, const Standing& axes) noexcept;

// Returns the planes, named A, B and so on. A plane whose normal has no sign is seen from the front, from above or from
// the drawn side.
[[nodiscard]] Vector<CutPlane> planes_of(std::span<const AskedCut> cuts, std::span<const ViewName> names,
                                         const Standing& axes, const glm::dvec3& middle, Pool& pool);

// Returns the views with the given names, followed by a section for each plane.
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

// Returns the frame inside a page [ISO 5457].
[[nodiscard]] SheetBox frame_of(const SheetPage& page) noexcept;
// Returns the title block in the lower right corner of a page [ISO 7200].
[[nodiscard]] SheetBox block_of(const SheetPage& page) noexcept;

// A view with its column and row in the table of all views.
struct ViewCell {
    SheetView view;
    int column;
    int row;
    glm::dvec2 low; // the bounding box of the view relative to its centre, in units of the model
    glm::dvec2 high;
    bool has_label;
    Vector<glm::dvec3> cut_normals; // normals of the cutting planes that the view shows as lines
    Vector<std::size_t> cuts;       // for each of cut_normals: the index of its plane

    // Return the bounding box of the drawing, and that of the drawing with its annotations, relative to the centre.
    // `scale` is in mm per unit.
    [[nodiscard]] SheetBox seen(double scale) const noexcept;
    [[nodiscard]] SheetBox box(double scale) const noexcept;
};

// Returns the cells of the views, in their order. Sections are placed to the right of the other views, or below them if
// they are seen from above. Each plane is drawn in the first view that sees it as a line.
[[nodiscard]] Vector<ViewCell> cells_of(Vector<SheetView> views, const Vector<CutPlane>& planes, const Points& points,
                                        const glm::dvec3& middle, Projection projection, const glm::dvec3& up,
                                        bool labels, Pool& pool);

struct SheetLayout {
    SheetPage page;
    SheetScale scale;
    double unit_scale;          // mm on the sheet per unit of the model
    Vector<glm::dvec2> centres; // the centre of each view
};

// The constraints of a layout.
struct LayoutRules {
    double unit_mm; // mm per unit of the model
    double spacing; // mm between views
    glm::dvec3 up;  // unit vector
};

// Returns a layout for the given page and scale. If the page or the scale is not given, it is chosen so that the views
// fit. Throws Error{invalid_argument} that names pages and scales that would fit.
[[nodiscard]] SheetLayout choose_layout(const Vector<ViewCell>& cells, const std::optional<SheetPage>& page,
                                        const std::optional<SheetScale>& scale, const LayoutRules& rules,
                                        const Report& report);

// Returns the scales of ISO 5455: 1, 2 and 5 times powers of ten, the largest first.
[[nodiscard]] Vector<SheetScale> standard_scales(Pool& pool);

} // namespace hrbfnpr::picture
