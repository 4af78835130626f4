// SPDX-License-Identifier: MIT
// The marks of a surface that a still picture needs.
//
// StillView: an item without marks, as its camera sees it
// StillNeed: the bounds that marks of one layer must keep to be needed
#pragma once

#include "frame/scene/scene.h"
#include "marks/need.h"

namespace hrbfnpr::frame {

// A drawing of one item by one camera. The item has no marks yet.
struct Still {
    Camera camera;
    Style style; // The caller owns the spans.
    bool both_sides = false;
    glm::dmat4 transform{1.0};
};

// Returns the numbers of a drawing that decide which marks it needs. Inks, lines and paper decide nothing.
[[nodiscard]] base::Array<double> still_key(base::Memory& memory, const Still& still);

// A surface as the camera of a still picture sees it.
struct StillView {
    // `bounds` is the box around the surface, in the caller's unit. `unit` is the unit of the places that are asked
    // about. Throws Error{invalid_argument} if nothing can be drawn with the camera.
    StillView(base::Memory& memory, const Still& still, const geometry::Bounds& bounds, double unit);

    // Returns a ball around a place and a cone of the normals there. `for_tone`: only normals close to the given one.
    [[nodiscard]] marks::Extent extent(const glm::dvec3& place, const glm::dvec3& normal, double reach,
                                       bool for_tone) const noexcept;
    // Returns bounds for a place and the normals around it.
    [[nodiscard]] ClusterView view(const glm::dvec3& place, const glm::dvec3& normal, double reach,
                                   bool for_tone) const noexcept;

    glm::dvec3 origin; // in `unit`
    Lens lens;
    Frustum frustum;
    ItemView item;
    ItemSight sight;
};

// The layer of a still picture that marks are placed for.
struct StillLayer {
    marks::Kind kind = marks::Kind::stipples;
    const LayerStyle* style = nullptr;
    // True if the layer's marks may be the splats that show where the surface hides other ink.
    bool may_be_splats = false;
    // True if no other layer of dots makes the tone of the surface.
    bool makes_tone_alone = false;
};

class StillNeed final : public marks::Need {
public:
    // The view and the layer's style must outlive this object.
    StillNeed(const StillView& view, const StillLayer& layer) noexcept : view_(view), layer_(layer) {}

    [[nodiscard]] bool may_show(const glm::dvec3& place, const glm::dvec3& normal,
                                double reach) const noexcept override;
    [[nodiscard]] double share(const glm::dvec3& place, const glm::dvec3& normal,
                               double spacing) const noexcept override;

private:
    [[nodiscard]] bool needs_other_side() const noexcept;
    [[nodiscard]] float share_of_splats(const ClusterView& at, float spacing) const noexcept;
    [[nodiscard]] float share_of_ink(const marks::Extent& extent, const ClusterView& at, float spacing) const noexcept;

    const StillView& view_;
    StillLayer layer_;
};

} // namespace hrbfnpr::frame
