// SPDX-License-Identifier: MIT
// A drawing on paper: where it stands, which pens draw it, and what the file says of it.
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

// ---- What stands on a page, in pixels; y grows downward

struct PageDrawing {
    Drawing drawing;
    glm::dvec2 corner{0.0};     // the top-left one
    const char* name = nullptr; // of the group around it; nullable
};

// A line or a text beside the drawings.
struct PageNote {
    explicit PageNote(Pool& pool) : points(&pool), text(&pool) {}

    Vector<glm::dvec2> points; // the line, or where the text's baseline begins
    String text;               // empty: it is a line
    const char* group = "annotations";
    double width = 1.0; // of the line, or the height of the text's capitals
    std::array<float, 4> ink{0.0F, 0.0F, 0.0F, 1.0F};
};

struct PageContent {
    explicit PageContent(Pool& pool) : drawings(&pool), notes(&pool) {}

    Vector<PageDrawing> drawings;
    Vector<PageNote> notes;
    glm::dvec2 size{0.0};
};

// Width and height of an image that just holds a camera's viewport.
[[nodiscard]] glm::ivec2 size_of_image(const hrbfnpr_camera& camera);

// A drawing alone; camera: the one that it was drawn with.
[[nodiscard]] PageContent page_of(const Drawing& drawing, const hrbfnpr_camera& camera, Pool& pool);

// ---- Strokes and dots of a drawing

struct DrawnPoint {
    float x, y, depth; // pixels, and window depth
    float radius;      // pixels
    std::uint32_t layer;
};

// The points of all strokes, far to near, one stroke after the other.
struct DrawnStrokes {
    Vector<DrawnPoint> points;
    Vector<std::size_t> first; // of each stroke in `points`, and the end
};
[[nodiscard]] DrawnStrokes drawn_strokes(const hrbfnpr_drawing& drawing, Pool& pool);
[[nodiscard]] Vector<DrawnPoint> drawn_dots(const hrbfnpr_drawing& drawing, Pool& pool);

// ---- Writing

// What a drawing is of, as JSON.  input: the name of the source; style: that of its preset.  models: of all surfaces;
// empty of a point set.
[[nodiscard]] String page_metadata(std::string_view input, std::string_view style, std::span<const Model> models,
                                   std::int64_t marks, const hrbfnpr_camera& camera, Pool& pool);

// Paper, in mm, upright: of "a0" to "a6", "letter", "legal", "tabloid", or of WIDTHxHEIGHT.  Throws
// Error{invalid_argument} that says what would be right.
[[nodiscard]] glm::dvec2 paper_size(std::string_view name, const Report& report);

// As hrbfnpr_page_write: places the content on the paper of a descriptor, which is read in full.  info and operation
// may be NULL.  Notes which pens are chosen, and what a plotter does.
void write_picture_page(hrbfnpr_context& context, Report& report, const PageContent& content,
                        const hrbfnpr_picture_page_desc& desc, const char* title, const char* metadata,
                        hrbfnpr_write_fn write, void* user, hrbfnpr_page_info* info, hrbfnpr_operation* operation);

} // namespace hrbfnpr::picture
