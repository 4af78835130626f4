// SPDX-License-Identifier: MIT
// Spreads stipples evenly in the picture.
//
// The order of stipples is even on the surface. In the picture, a surface that turns away has its marks closer together
// in one direction, so they form rows. Therefore more marks may be shown there, and each gets smaller as far as marks
// before it in the order are too near in the picture. This is dart throwing in the order of the surface [McCool & Fiume
// 1992] with soft borders: a mark that is refused fills a gap as far as it can.
//
// A mark sees an earlier one as far as the place of that in the order stands for a larger distance than the one between
// them. So a zoom in, which makes all distances larger, makes no mark smaller. Everything is continuous in the places
// of the marks in the picture, so marks grow and shrink smoothly.
#pragma once

#include "base/list.h"
#include "base/runtime.h"
#include "drawing/drawing.h"
#include "frame/depth_layers/near_marks.h"
#include "frame/scene/even_places.h"
#include "frame/scene/scene.h"

#include <span>

namespace hrbfnpr::frame {

// A mark that its tone may show. It has the index of its dot.
struct EvenMark {
    float place;      // in the order on the surface: 1 - rank
    float own;        // the distance in pixels that this place stands for
    float wanted;     // the distance in pixels that the tone wants
    float flat;       // its place among the marks that may be shown
    float shown;      // it may be shown up to this place
    float facing;     // |n . v|
    glm::vec2 normal; // x and y of the unit normal in eye space
    glm::vec2 slope;  // the change of depth per pixel to the right and down, both in pixels
    float outside;    // the distance of its centre from the window, in pixels
    float fade;       // the share of `shown` over which its area grows
};

// Makes marks smaller where they are too near. The arrays are kept from frame to frame.
class EvenOrder {
public:
    explicit EvenOrder(base::Memory& memory) noexcept;

    // Makes the dots of the runs that are even in the picture smaller, and removes those that are not shown from the
    // drawing's ranges and counts. Before, these dots are whole. marks[i] belongs to the dot i.
    void run(const base::Runtime& runtime, const Scene& scene, std::span<const EvenMark> marks,
             drawing::Drawing& drawing);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    struct Spot {
        float x, y; // pixels
        float depth, pixels_per_unit;
        float place, own;
        float reach; // earlier marks nearer than this make it smaller
        float share; // `reach` as a share of the distance that its tone wants
        glm::vec2 normal, slope;
        float weight; // 0 for marks far outside the window
        std::uint32_t run, dot;
    };
    // The working memory of a tile.
    struct Tile {
        explicit Tile(base::Memory& memory) noexcept : intervals(memory), found(memory) {}
        base::Array<MarkInterval> intervals;
        base::Array<std::uint32_t> found;
    };
    struct Removed {
        std::int64_t by_tone = 0, outside = 0;
    };

    void sort(const base::Parallel& parallel, std::span<const EvenMark> marks, const drawing::Drawing& drawing);
    void fill_tile(std::span<const EvenMark> marks, const drawing::Drawing& drawing, std::int64_t number);
    [[nodiscard]] static Spot spot_of(const EvenMark& mark, const drawing::Dot& dot, std::uint32_t index,
                                      const glm::vec2& corner) noexcept;
    [[nodiscard]] std::int32_t cell_along(float at, std::int32_t tiles) const noexcept;
    [[nodiscard]] std::int64_t find_cells(std::int64_t number, std::int32_t cell, float reach,
                                          base::Array<MarkInterval>& intervals) const;
    [[nodiscard]] static float same_sheet(const Spot& a, const Spot& b) noexcept;
    [[nodiscard]] float part_of(const Spot& spot, std::span<const std::uint32_t> near) const noexcept;
    void shrink_tile(const NearMarks& near, std::span<const EvenMark> marks, std::int64_t number,
                     drawing::Drawing& drawing);
    void remove_hidden(const base::Parallel& parallel, std::span<const EvenMark> marks, drawing::Drawing& drawing);

    base::Array<std::int64_t> range_;           // the indices of the ranges of dots that are even in the picture
    base::Array<drawing::IndexRange> in_range_; // these ranges
    base::Array<Removed> removed_;              // what each of these ranges lost
    drawing::Tiles tiles_;
    std::int32_t cells_ = 1;                // the cells along a side of a tile
    base::Array<std::int64_t> first_;       // for each tile and one more: its first spot
    base::Array<std::uint32_t> cell_of_;    // the cell of each dot of a tile, tile by tile
    base::Array<std::uint32_t> cell_first_; // for each cell, tile by tile, and one more: its first spot
    base::Array<Spot> spots_;               // tile by tile and cell by cell
    base::Array<float> x_, y_, place_;      // those of the spots
    base::List<Tile> tile_;
};

} // namespace hrbfnpr::frame
