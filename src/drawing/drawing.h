// SPDX-License-Identifier: MIT
// A picture as a value: dots and strokes in window coordinates, in layers, with the identity of the marks that they
// come from.  Producers (src/frame) fill one, readers (src/output) only read it.
#pragma once

#include "base/memory.h"
#include "drawing/dot.h"
#include "drawing/splat.h"
#include "drawing/tiles.h"
#include "drawing/window.h"
#include "geometry/vec.h"
#include "marks/point_set.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::drawing {

enum class Painting : std::uint8_t {
    // Each dot and stroke has been dimmed by what is in front of it: where all have one colour their order does not
    // matter.  Dots stand in pieces, in any order; one that is not drawn has the opacity 0.
    transmittance,
    // Dots of paper and of ink stand in the order in which they are painted.                        [NPAR 6.1]
    published
};

// Ink of one layer of one item's marks, of one class.
struct Layer {
    std::int32_t item = 0;
    std::int32_t layer = 0; // of the item's point set; -1: of lines
    MarkClass mark_class = MarkClass::front;
    bool as_strokes = false;
    glm::vec4 ink{0.0F};          // straight RGBA
    std::uint32_t line_kind = 0;  // HRBFNPR_LINE_KIND_..., where `layer` is -1
    bool as_hatch = false;        // and these strokes are hatching
    marks::LayerName line_name{}; // of lines: their style's; may be empty
};

// Counted while the drawing was made; hrbfnpr_drawing_info says what each is.
struct Counts {
    std::int64_t marks = 0, outside = 0, front = 0, back = 0, silhouette = 0, shown = 0;
    std::int64_t dropped_tone = 0, dropped_depth = 0, dropped_zoom = 0, dropped_hidden = 0, splats = 0, culled = 0;
    std::int64_t nanoseconds_classify = 0, nanoseconds_visibility = 0, nanoseconds_sort = 0;
    std::int64_t scratch_bytes = 0;

    Counts& operator+=(const Counts& other) noexcept; // but for times and bytes
};

// Of lines, counted while the drawing was made; hrbfnpr_drawing_info says what each is.
struct LineCounts {
    std::int64_t curves = 0, cusps = 0, crossings = 0, broken = 0, refined = 0, settled = 0, contradictions = 0;
    std::int64_t tangles = 0;
    std::int64_t nanoseconds = 0;
};

// The marks of one layer of one item: where their ids begin, and where the marks are if they have moved.
struct Run {
    std::int32_t item = 0;
    std::int32_t layer = 0;
    std::int64_t count = 0;
    std::uint32_t first_id = 1;
    std::int64_t posed = -1; // place of the first mark in `posed_position`; -1: as in the set
    bool poses_directions = false;
};

// Where an item's marks are.
struct ItemSource {
    const marks::PointSet* set = nullptr; // kept alive by whoever keeps the drawing
    double unit = 1.0;                    // in which `to_world` takes positions relative to the set's origin
    glm::dmat4 to_world{1.0};
    glm::mat3 normal_to_world{1.0F};
};

// A mark in the world.
struct MarkSource {
    glm::vec3 position;
    glm::vec3 normal;    // unit
    glm::vec3 direction; // unit
};

struct Identity {
    std::int64_t item, layer, mark;
    std::int64_t stroke; // -1: of none
    std::int64_t place;  // along the stroke
};

struct Drawing {
    explicit Drawing(base::Memory& memory) noexcept;

    Window window;
    glm::vec4 paper{1.0F};
    Painting painting = Painting::transmittance;
    Counts counts;
    LineCounts line_counts;

    base::Array<Layer> layers;
    // All inks have one colour: then their order does not matter.
    bool one_color = true;
    glm::vec4 ink_color{0.0F}; // if there is but one

    base::Array<Dot> dots;
    base::Array<Piece> dot_pieces; // where in `dots` there are any
    std::int64_t dot_count = 0;    // of ink that is drawn
    base::Array<Stroke> strokes;   // far to near
    base::Array<StrokePoint> points;
    base::Array<Splat> splats; // what depth layers were found from
    bool has_splats = false;   // else nothing hides anything
    base::Array<Piece> splat_pieces;

    // By place, over the viewport; `first_pixel` is their top-left corner.  Of transmittance only.
    glm::ivec2 first_pixel{0};
    Tiles dot_tiles;
    Tiles splat_tiles;
    Tiles segment_tiles; // a segment's number is that of its first point

    // From (x, y, window depth, 1) to the world, homogeneous.
    glm::dmat4 from_window{1.0};

    base::Array<ItemSource> items;
    base::Array<Run> runs; // of all layers of all items, drawn or not, in the order of their ids
    base::Array<float> posed_position, posed_normal, posed_direction; // 3 of each mark, relative to the set's origin

    void clear() noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;

    // Whether dot a is painted before dot b.
    [[nodiscard]] bool before(std::uint32_t a, std::uint32_t b) const noexcept {
        return dots[a].depth != dots[b].depth ? dots[a].depth > dots[b].depth : a < b;
    }

    // NULL for an id that is no mark's.
    [[nodiscard]] const Run* run_of(std::uint32_t id) const noexcept;
    // Of an id that is a mark's.
    [[nodiscard]] Identity identify(std::uint32_t id) const noexcept;
    [[nodiscard]] MarkSource source(std::uint32_t id) const noexcept;
    // The place of what is seen there.
    [[nodiscard]] glm::vec3 world(const glm::vec3& window) const noexcept;

private:
    // The last run that begins no later than the id.
    [[nodiscard]] std::int64_t place_of(std::uint32_t id) const noexcept;
};

} // namespace hrbfnpr::drawing
