// SPDX-License-Identifier: MIT
// The lines that are drawn, as edges of what lies before hatching.
#pragma once

#include "drawing/drawing.h"
#include "frame/scene/scene.h"
#include "geometry/vec.h"

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

    // Whether an edge before the dot is so near to it, or its halo is; one of the dot's own surface, too, where that is
    // slanted.
    [[nodiscard]] bool is_near(const drawing::Dot& dot, float reach, float halo) const noexcept;

    static constexpr float nowhere = std::numeric_limits<float>::infinity();
    // The share of the way from a to b where a line reaches the first edge before it, or its halo, that does not hold
    // a; else `nowhere`.
    [[nodiscard]] float entry(const drawing::Dot& a, const drawing::Dot& b, float halo) const noexcept;

    // How far to both sides a line through the point, which goes along there, may reach, up to that radius, so that it
    // goes over no edge before it, or its halo, nor over a crease of its own surface.
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
    [[nodiscard]] static float before(const Edge& edge, const glm::vec2& at, float depth,
                                      float pixels_per_unit) noexcept;

    [[nodiscard]] static float before(const Edge& edge, const drawing::Dot& a, const drawing::Dot& b) noexcept;

    glm::vec2 corner_{0.0F};
    std::int32_t columns_ = 0, rows_ = 0;
    base::Array<Edge> edges_;
    base::Array<std::int32_t> first_;   // of each cell in `numbers_`, and the end
    base::Array<std::int32_t> numbers_; // of edges
};

} // namespace hrbfnpr::frame
