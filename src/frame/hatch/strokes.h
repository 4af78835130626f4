// SPDX-License-Identifier: MIT
// Makes strokes of the samples of hatching, which are already marked as seen or hidden.
//
// 1. Each reason for a line to end has a presence along the line (presence.h): its tone, its level, the rim, the
//    picture, and surfaces that hide it. Hidden parts begin and end exactly at the edges that hide them (hiding.cpp).
// 2. Short gaps of tone and short hidden gaps are closed.
// 3. The line is present where all of these presences are above 0. Parts with too little ink are left out.
// 4. The width of the line is the width of its samples times its presence. The reason for an end determines how the
//    line narrows towards it.
#pragma once

#include "frame/hatch/points.h"
#include "frame/scene/scene.h"

#include <limits>
#include <span>

namespace hrbfnpr::frame {

// ---- Edges that hide lines of hatching, and where exactly the lines end at them
//
// 1. Depth layers say of each sample whether it is seen. They are made of splats, so they are right to the radius of
//    a splat.
// 2. `NearerEdges` holds the lines of the picture that nothing hides: the contours and creases of surfaces in front
//    of the hatching.
// 3. `find_cuts` moves each place where a line begins or ends to the edge, or to the border of the edge's halo.

// A segment of a visible line, which may hide hatching behind it.
struct NearerEdge {
    glm::vec2 a, b;
    float depth_a, depth_b;
    bool is_crease;
    float radius; // half the width of the line there, in pixels
};

class NearerEdges {
public:
    explicit NearerEdges(base::Memory& memory) noexcept : edges_(memory), first_(memory), numbers_(memory) {}

    // Takes the edges of all strokes that are visible. `picture` is left, top, width and height in pixels.
    void build(const LineStrokes& lines, std::span<const drawing::Layer> layers, const glm::vec4& picture);
    void clear() noexcept { edges_.clear(); }
    [[nodiscard]] bool empty() const noexcept { return edges_.empty(); }

    // Returns whether an edge in front of the dot is within `reach` of it, or has a halo that contains the dot. If the
    // surface at the dot is slanted, the edges of this surface count, too.
    [[nodiscard]] bool is_near(const drawing::Dot& dot, float reach, float halo) const noexcept;

    static constexpr float nowhere = std::numeric_limits<float>::infinity();
    // Returns the share of the way from a to b at which the line first reaches an edge in front of it, or the halo of
    // such an edge. Returns `nowhere` if it reaches none. Edges whose halo contains a are ignored.
    [[nodiscard]] float entry(const drawing::Dot& a, const drawing::Dot& b, float halo) const noexcept;

    // Returns the largest width of the edges within `reach` of a place in the picture, in pixels; 0 if there are none.
    [[nodiscard]] float width_near(const glm::vec2& at, float reach) const noexcept;

    // Returns the largest radius, up to `radius`, of a line through the point in the direction `along`. The line must
    // cover no edge in front of it, no halo of such an edge, and no crease of the point's surface.
    [[nodiscard]] float clear_width(const drawing::StrokePoint& point, const glm::vec2& along, float radius,
                                    float halo) const noexcept;

    [[nodiscard]] std::int64_t bytes() const noexcept { return edges_.bytes() + first_.bytes() + numbers_.bytes(); }

private:
    // Returns the half-open rectangle of cells around a box: left, top, right, bottom.
    [[nodiscard]] glm::ivec4 cells(const glm::vec2& low, const glm::vec2& high) const noexcept;
    template <class F>
    void for_cells_of(const NearerEdge& edge, const F& f) const;
    template <class F>
    void for_near(const glm::vec2& low, const glm::vec2& high, const F& f) const;

    glm::vec2 corner_{0.0F};
    std::int32_t columns_ = 0, rows_ = 0;
    base::Array<NearerEdge> edges_;
    base::Array<std::int32_t> first_;   // for each cell: the index in `numbers_` where its edges begin; and the end
    base::Array<std::int32_t> numbers_; // the indices of the edges in each cell, cell by cell
};

struct Hiding {
    const NearerEdges& edges;
    const drawing::Drawing& drawing;
    // The radius of the largest splat in each tile of the drawing's dots, in pixels. Empty if there are no splats.
    std::span<const float> largest_splat;
};

// Finds the exact cuts of a line, in order along the line. `dots` are the line's samples, seen or hidden, and `length`
// is the distance along the line to each, in pixels. The visibility of samples near a cut is corrected.
void find_cuts(const Hiding& hiding, float halo, std::span<drawing::Dot> dots, const base::Array<float>& length,
               base::Array<HatchCut>& cuts);

// ---- Strokes

// Makes the strokes of each batch. The dots of the batch are then no longer drawn. The drawing's counts, which counted
// dots as marks, are corrected.
void make_strokes(const base::Runtime& runtime, const Scene& scene, const Hiding& hiding,
                  std::span<HatchPoints::Batch> batches, drawing::Drawing& drawing);

} // namespace hrbfnpr::frame
