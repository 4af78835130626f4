// SPDX-License-Identifier: MIT
// Spreads stipples evenly in the picture.
//
// The order of stipples is even on the surface. In the picture, a surface that turns away has its marks closer together
// in one direction, so they form rows. Therefore each mark gets a place in an order of the picture, by a rule like that
// of dart throwing with a falling radius [McCool & Fiume 1992]: the place stands for the largest distance that the mark
// keeps from the marks before it. A tone shows the marks whose distance is large enough.
//
// The distances depend on the camera, but not on tones. All of them grow with the zoom, so zooming in removes no mark.
// They are continuous in the places of the marks in the picture, so marks grow and shrink smoothly.
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

// Finds the places in the order of the picture. The arrays are kept from frame to frame.
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
        std::uint64_t order; // the place, then the index of the dot
        float x, y;          // pixels
        float depth, pixels_per_unit;
        float most;   // the largest distance that matters
        float reach;  // marks nearer than this make it smaller
        float wanted; // the square root of the area of a mark of its tone
        glm::vec2 normal, slope;
        float weight; // 0 for marks far outside the window
        std::uint32_t run;
    };
    // An earlier mark that may be too near.
    struct Claim {
        std::uint32_t spot; // the index of the earlier mark
        float pixels;       // the distance of the two marks
        float weight;
    };
    struct Tile {
        explicit Tile(base::Memory& memory) noexcept
            : first(memory), claims(memory), open(memory), intervals(memory), found(memory) {}
        base::Array<std::uint32_t> first; // for each mark and one more: its first claim
        base::Array<Claim> claims;
        base::Array<std::uint32_t> open; // the marks whose distances are not final
        // Working memory.
        base::Array<MarkInterval> intervals;
        base::Array<std::uint32_t> found;
    };

    struct Removed {
        std::int64_t by_tone = 0, outside = 0;
    };

    void sort(const base::Parallel& parallel, std::span<const EvenMark> marks, const drawing::Drawing& drawing);
    void fill_tile(std::span<const EvenMark> marks, const drawing::Drawing& drawing, std::int64_t number);
    [[nodiscard]] std::int64_t find_cells(std::int64_t number, std::int32_t cell, float reach,
                                          base::Array<MarkInterval>& intervals) const;
    [[nodiscard]] static Spot spot_of(std::uint64_t order, const EvenMark& mark, const drawing::Dot& dot,
                                      const glm::vec2& corner) noexcept;
    [[nodiscard]] static float same_sheet(const Spot& a, const Spot& b) noexcept;
    void add_claim(const Spot& spot, std::uint32_t number, base::Array<Claim>& claims) const;
    void find_claims(const NearMarks& near, std::int64_t number);
    void settle_tile(std::int64_t number);
    [[nodiscard]] float part_of(const Spot& spot, std::span<const Claim> claims) const noexcept;
    void shrink(const base::Parallel& parallel, std::span<const EvenMark> marks, drawing::Drawing& drawing) const;
    void remove_hidden(const base::Parallel& parallel, std::span<const EvenMark> marks, drawing::Drawing& drawing);
    [[nodiscard]] std::int32_t cell_along(float at, std::int32_t tiles) const noexcept;

    base::Array<std::int64_t> range_;           // the indices of the ranges of dots that are even in the picture
    base::Array<drawing::IndexRange> in_range_; // these ranges
    base::Array<Removed> removed_;              // what each of these ranges lost
    drawing::Tiles tiles_;
    std::int32_t cells_ = 1;          // the cells along a side of a tile
    base::Array<std::int64_t> first_; // for each tile and one more: its first spot
    base::Array<std::uint64_t> keys_; // the orders of the spots
    base::Array<Spot> spots_;         // tile by tile, cell by cell, and in the order on the surface
    // For each cell, tile by tile, and one more: its first spot.
    base::Array<std::uint32_t> cell_first_;
    base::Array<std::uint32_t> order_;                // for each tile: its spots in the order on the surface
    base::Array<float> cell_x_, cell_y_, cell_place_; // an element for each spot
    base::List<Tile> tile_;
    base::Array<float> distance_, previous_; // the distance of each spot, after this round and the one before
};

} // namespace hrbfnpr::frame
