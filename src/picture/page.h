// SPDX-License-Identifier: MIT
// Puts a drawing on a page: its position, its pens, and the metadata of the file.
#pragma once

#include "geometry/vec.h"
#include "picture/handles.h"
#include "picture/memory.h"
#include "picture/report.h"

#include <hrbfnpr.h>

#include <array>
#include <span>
#include <string_view>

namespace hrbfnpr::picture {

// ---- Content of a page, in pixels; y grows downward

struct PageDrawing {
    Drawing drawing;
    glm::dvec2 corner{0.0};     // The top-left corner of the drawing on the page.
    const char* name = nullptr; // The name of the drawing's group, or null.
};

// A line or a text beside the drawings.
struct PageNote {
    explicit PageNote(Pool& pool) : points(&pool), text(&pool) {}

    Vector<glm::dvec2> points; // the points of the line, or the start of the text's baseline
    String text;               // The text. If it is empty, the note is a line.
    const char* group = "annotations";
    double width = 1.0; // the width of the line, or the height of the text's capitals
    std::array<float, 4> ink{0.0F, 0.0F, 0.0F, 1.0F};
};

struct PageContent {
    explicit PageContent(Pool& pool) : drawings(&pool), notes(&pool) {}

    Vector<PageDrawing> drawings;
    Vector<PageNote> notes;
    glm::dvec2 size{0.0};
};

// Returns the smallest size of an image that holds the camera's viewport.
[[nodiscard]] glm::ivec2 size_of_image(const hrbfnpr_camera& camera);

// Returns a page that contains only a drawing. `camera` is the camera of the drawing.
[[nodiscard]] PageContent page_of(const Drawing& drawing, const hrbfnpr_camera& camera, Pool& pool);

// ---- Strokes and dots of a drawing

struct DrawnPoint {
    float x, y, depth; // position in pixels, and window depth
    float radius;      // in pixels
    std::uint32_t layer;
};

// The points of all strokes, stroke by stroke, from the farthest to the nearest.
struct DrawnStrokes {
    Vector<DrawnPoint> points;
    // For each stroke, the index of its first point in `points`. One more element has the number of points.
    Vector<std::size_t> first;
};
[[nodiscard]] DrawnStrokes drawn_strokes(const hrbfnpr_drawing& drawing, Pool& pool);
[[nodiscard]] Vector<DrawnPoint> drawn_dots(const hrbfnpr_drawing& drawing, Pool& pool);

// ---- Writing

// Describes the contents of a drawing as JSON. `input` is the name of the source, and `style` is the name of the
// preset. `models` has the models of all surfaces; it is empty for a point set.
[[nodiscard]] String page_metadata(std::string_view input, std::string_view style, std::span<const Model> models,
                                   std::int64_t marks, const hrbfnpr_camera& camera, Pool& pool);

// Returns the size of a paper in portrait format, in mm. `name` is "a0" to "a6", "letter", "legal", "tabloid", or
// WIDTHxHEIGHT. Throws Error{invalid_argument} that lists the valid names.
[[nodiscard]] glm::dvec2 paper_size(std::string_view name, const Report& report);

// Writes `content` as a page by hrbfnpr_page_write, with all fields of the descriptor. `info` and `operation` may be
// NULL. Reports the chosen pens and the work of a plotter in notes.
void write_picture_page(hrbfnpr_context& context, Report& report, const PageContent& content,
                        const hrbfnpr_picture_page_desc& desc, const char* title, const char* metadata,
                        hrbfnpr_write_fn write, void* user, hrbfnpr_page_info* info, hrbfnpr_operation* operation);

} // namespace hrbfnpr::picture
