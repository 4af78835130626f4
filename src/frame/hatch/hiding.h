// SPDX-License-Identifier: MIT
// What hides lines of hatching, and where exactly the lines end at it.
//
// 1. Depth layers say of each sample whether it is seen. They are made of splats, so they are right to a splat's
// radius.
// 2. `NearerEdges` holds the lines of the picture that nothing hides: the contours and creases of surfaces before the
//    hatching.
// 3. `find_cuts` moves each place where a line begins or ends to the edge, or to the border of the edge's halo.
#pragma once

#include "frame/hatch/points.h"
#include "frame/scene/scene.h"

#include <limits>
#include <span>

namespace hrbfnpr::frame {

class NearerEdges {
public:
    explicit NearerEdges(base::Memory& memory) noexcept : edges_(memory), first_(memory), numbers_(memory) {}

    // Takes the edges of all strokes that nothing hides. `picture` is left, top, width and height, in pixels.
    void build(const LineStrokes& lines, std::span<const drawing::Layer> layers, const glm::vec4& picture);
    void clear() noexcept { edges_.clear(); }
    [[nodiscard]] bool empty() const noexcept { return edges_.empty(); }

    // Whether an edge that lies before the dot is within `reach` of it, or its halo holds the dot. Edges of the dot's
    // own surface count, too, where that is slanted.
    [[nodiscard]] bool is_near(const drawing::Dot& dot, float reach, float halo) const noexcept;

    static constexpr float nowhere = std::numeric_limits<float>::infinity();
    // The share of the way from a to b at which a line reaches the first edge before it, or that edge's halo, that does
    // not hold a; else `nowhere`.
    [[nodiscard]] float entry(const drawing::Dot& a, const drawing::Dot& b, float halo) const noexcept;

    // The largest radius, up to `radius`, that a line through the point in the direction `along` may have so that it
    // covers no edge before it, nor that edge's halo, nor a crease of its own surface.
    [[nodiscard]] float room(const drawing::StrokePoint& point, const glm::vec2& along, float radius,
                             float halo) const noexcept;

    [[nodiscard]] std::int64_t bytes() const noexcept { return edges_.bytes() + first_.bytes() + numbers_.bytes(); }

private:
    struct Edge {
        glm::vec2 a, b;
        float depth_a, depth_b;
        bool is_crease;
    };
    // A half-open rectangle of cells.
    struct Cells {
        std::int32_t left, top, right, bottom;
    };

    template <class F>
    void for_cells_of(const Edge& edge, const F& f) const;
    template <class F>
    void for_near(const glm::vec2& low, const glm::vec2& high, const F& f) const;
    void bin();
    [[nodiscard]] Cells cells(const glm::vec2& low, const glm::vec2& high) const noexcept;
    [[nodiscard]] static float nearer_at(const Edge& edge, const glm::vec2& at, float depth,
                                         float pixels_per_unit) noexcept;
    [[nodiscard]] static float nearer_on(const Edge& edge, const drawing::Dot& a, const drawing::Dot& b) noexcept;

    glm::vec2 corner_{0.0F};
    std::int32_t columns_ = 0, rows_ = 0;
    base::Array<Edge> edges_;
    base::Array<std::int32_t> first_;   // the first place in `numbers_` for each cell, and the end
    base::Array<std::int32_t> numbers_; // the edges in each cell, cell by cell
};

struct Hiding {
    const NearerEdges& edges;
    const drawing::Drawing& drawing;
    std::span<const float> largest_splat; // in each tile of the drawing's dots, pixels; empty if there are no splats

    [[nodiscard]] float largest_splat_at(const drawing::Dot& dot) const noexcept;
};

// A line is seen on one side of a place between two of its samples, and hidden on the other.
struct HatchCut {
    std::int64_t before = -1; // the first of the two samples; -1: there is no such place
    float at = 0.0F;          // along the line, pixels

    [[nodiscard]] bool any() const noexcept { return before >= 0; }
};

// Finds the cuts of a line, in its order, whose samples are given as dots that are seen or hidden. `length` is the way
// to each sample, in pixels. Samples between where the dots said that the line ends and where it does become seen or
// hidden.
void find_cuts(const Hiding& hiding, float halo, std::span<drawing::Dot> dots, const base::Array<float>& length,
               base::Array<HatchCut>& cuts);

} // namespace hrbfnpr::frame
