// SPDX-License-Identifier: MIT
// Where lines of hatching end at what hides them.  Their points tell that to a step, and depth layers to a splat's
// radius; the edges that are drawn there tell it exactly.
#pragma once

#include "drawing/drawing.h"
#include "frame/hatch/edges.h"
#include "frame/hatch/tiles.h"

#include <algorithm>
#include <span>

namespace hrbfnpr::frame {

using drawing::Dot;

// What hides lines of hatching: the edges of surfaces in front of them, and depth layers, which are made of splats.
struct Hiding {
    const NearerEdges& edges;
    const drawing::Drawing& drawing;
    std::span<const float> largest_splat; // of each tile of the drawing's dots, pixels; empty if there are no splats

    [[nodiscard]] float largest_splat_at(const drawing::Dot& dot) const noexcept {
        if (largest_splat.empty()) return 0.0F;
        const drawing::Tiles& tiles = drawing.dot_tiles;
        const glm::vec2 at = glm::vec2(dot.x, dot.y) - glm::vec2(drawing.first_pixel);
        return largest_splat[static_cast<std::size_t>(tile_of(at.y, tiles.rows()) * tiles.columns() +
                                                      tile_of(at.x, tiles.columns()))];
    }
};

// Edges are looked for within this distance of each point, in pixels. A wider halo is left as the depth layers made it.
inline constexpr float widest_halo = 32.0F;

// A line is seen on one side of a place between two of its points, and hidden on the other.
struct HatchCut {
    std::int64_t before = -1; // the first of the two points; -1: there is no such place
    float at = 0.0F;          // along the line, pixels

    [[nodiscard]] bool any() const noexcept { return before >= 0; }
};

// Finds the cuts of one line, which is given as dots that are seen or hidden, and their places along it.
class HatchCuts {
public:
    // cuts: what is found, in their order.
    HatchCuts(const Hiding& hiding, float halo, std::span<Dot> dots, const base::Array<float>& length,
              base::Array<HatchCut>& cuts) noexcept
        : hiding_(hiding), halo_(std::min(halo, widest_halo)), dots_(dots), length_(length), cuts_(cuts) {}

    // Dots between where they said that it ends and where it does are seen, or hidden, from then on.
    void find();

private:
    // Points from `first` to `end`, half-open, are hidden, those from `seen` to `first` and from `end` to `next` seen.
    struct Gap {
        std::int64_t seen, first, end, next;
    };

    [[nodiscard]] std::int64_t size() const noexcept { return static_cast<std::int64_t>(dots_.size()); }
    [[nodiscard]] Dot& dot(std::int64_t i) const noexcept { return dots_[static_cast<std::size_t>(i)]; }
    [[nodiscard]] bool seen(std::int64_t i) const noexcept { return dot(i).opacity > 0.0F; }
    [[nodiscard]] bool is_near(std::int64_t i, float reach) const noexcept;
    [[nodiscard]] float reach_of_splats(std::int64_t i) const noexcept;
    [[nodiscard]] bool may_be_seen(std::int64_t i) const noexcept;
    [[nodiscard]] std::int64_t begin_of_search(std::int64_t last, std::int64_t way, std::int64_t limit) const noexcept;
    [[nodiscard]] HatchCut search(std::int64_t last, std::int64_t way, std::int64_t first_seen,
                                  std::int64_t last_hidden) const noexcept;
    [[nodiscard]] bool by_nothing(const Gap& gap) const noexcept;
    void show(std::int64_t first, std::int64_t end) noexcept;
    std::int64_t mend(const Gap& gap);
    void apply(const HatchCut& cut, std::int64_t last, std::int64_t way) noexcept;

    const Hiding& hiding_;
    float halo_;
    std::span<Dot> dots_;
    const base::Array<float>& length_;
    base::Array<HatchCut>& cuts_;
};

} // namespace hrbfnpr::frame
