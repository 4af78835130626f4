// SPDX-License-Identifier: MIT
// A picture as a value: dots and strokes in window coordinates, in layers, with the identity of the marks that they
// come from.  Producers (src/frame) fill one, readers (src/output) only read it.
#pragma once

#include "base/memory.h"
#include "drawing/dot.h"
#include "drawing/tiles.h"
#include "drawing/window.h"
#include "geometry/vec.h"
#include "marks/point_set.h"

#include <cstdint>
#include <span>

namespace hrbfnpr::drawing {

enum class Painting : std::uint8_t {
    // Each dot and stroke has been dimmed by the surface in front of it, so that their order does not matter where all
    // have one colour. Dots stand in pieces, in any order; one that is not drawn has the opacity 0.
    transmittance,
    // Dots of paper and of ink stand in the order in which they are painted. [NPAR 6.1]
    published
};

// The ink of one class of one layer of an item's marks.
struct Layer {
    std::int32_t item = 0;
    std::int32_t layer = 0; // number of the layer in the item's point set; -1: lines
    MarkClass mark_class = MarkClass::front;
    bool as_strokes = false;
    glm::vec4 ink{0.0F};          // straight RGBA
    std::uint32_t line_kind = 0;  // a constant HRBFNPR_LINE_KIND where `layer` is -1
    bool as_hatch = false;        // whether the strokes are hatching
    marks::LayerName line_name{}; // the name of the lines in their style; may be empty
};

// Counted while the drawing was made; hrbfnpr_drawing_info documents each member.
struct Counts {
    std::int64_t marks = 0, outside = 0, front = 0, back = 0, silhouette = 0, shown = 0;
    std::int64_t dropped_tone = 0, dropped_depth = 0, dropped_zoom = 0, dropped_hidden = 0, splats = 0, culled = 0;
    std::int64_t nanoseconds_classify = 0, nanoseconds_visibility = 0, nanoseconds_sort = 0;
    std::int64_t scratch_bytes = 0;

    Counts& operator+=(const Counts& other) noexcept; // adds all members but times and bytes
};

// The same for lines.
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
    std::int64_t posed = -1; // place of the first mark in `posed_position`; -1: marks stand as in the set
    bool poses_directions = false;
};

// An item's marks in the world.
struct ItemSource {
    const marks::PointSet* set = nullptr; // the drawing's owner keeps it alive
    double unit = 1.0; // unit of the positions that `to_world` takes, which are relative to the set's origin
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
    std::int64_t stroke; // -1: the mark has none
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
    bool one_color = true;     // all inks have one colour, so their order does not matter
    glm::vec4 ink_color{0.0F}; // that colour

    base::Array<Dot> dots;
    base::Array<Piece> dot_pieces; // the parts of `dots` that hold dots
    std::int64_t dot_count = 0;    // number of dots of ink that are drawn
    base::Array<Stroke> strokes;   // far to near
    base::Array<StrokePoint> points;
    base::Array<Splat> splats; // depth layers were found from them
    bool has_splats = false;   // false: nothing hides anything
    base::Array<Piece> splat_pieces;

    // Indexes by place over the viewport, whose top-left corner is `first_pixel`; only Painting::transmittance has
    // them.
    glm::ivec2 first_pixel{0};
    Tiles dot_tiles;
    Tiles splat_tiles;
    Tiles segment_tiles; // a segment's number is that of its first point

    // From (x, y, window depth, 1) to the world, homogeneous.
    glm::dmat4 from_window{1.0};

    base::Array<ItemSource> items;
    base::Array<Run> runs; // one for each layer of each item, drawn or not, in the order of the ids
    // Three numbers for each mark of a posed run; positions are relative to the set's origin.
    base::Array<float> posed_position, posed_normal, posed_direction;

    void clear() noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept;

    // Whether dot a is painted before dot b.
    [[nodiscard]] bool before(std::uint32_t a, std::uint32_t b) const noexcept {
        return dots[a].depth != dots[b].depth ? dots[a].depth > dots[b].depth : a < b;
    }

    // The run that has a mark; NULL if no mark has this id.
    [[nodiscard]] const Run* run_of(std::uint32_t id) const noexcept;
    // The id must be a mark's.
    [[nodiscard]] Identity identify(std::uint32_t id) const noexcept;
    [[nodiscard]] MarkSource source(std::uint32_t id) const noexcept;
    // The place in the world of a place in the window.
    [[nodiscard]] glm::vec3 world(const glm::vec3& window) const noexcept;

private:
    // Calls f for each array of the drawing; its tiles are no arrays.
    template <class Self, class F>
    static void for_arrays(Self& d, const F& f) {
        f(d.layers), f(d.dots), f(d.dot_pieces), f(d.strokes), f(d.points), f(d.splats), f(d.splat_pieces), f(d.items);
        f(d.runs), f(d.posed_position), f(d.posed_normal), f(d.posed_direction);
    }
    // The last run that begins no later than the id.
    [[nodiscard]] std::int64_t place_of(std::uint32_t id) const noexcept;
};

} // namespace hrbfnpr::drawing
