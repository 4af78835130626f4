// SPDX-License-Identifier: MIT
// Primitive solids, each the intersection of one to six smooth sheets: the largest of their signed distances.  Inside
// that is the distance to the surface, outside it is where a sheet is nearest, and less beside edges and corners.
#pragma once

#include "implicit/csg_jet.h"
#include "implicit/csg_tree.h"

namespace hrbfnpr::implicit {

// Where a solid may be, face by face; infinite where it has no end, and a face beyond its opposite where it is empty.
struct CsgBox {
    glm::dvec3 low{-std::numeric_limits<double>::infinity()};
    glm::dvec3 high{std::numeric_limits<double>::infinity()};

    [[nodiscard]] CsgBox grown(double by) const noexcept { return {low - by, high + by}; }
    [[nodiscard]] bool empty() const noexcept { return !glm::all(glm::lessThanEqual(low, high)); }
};
// Of an empty one all between its faces: it may have room once it has grown.
[[nodiscard]] inline CsgBox hull(const CsgBox& a, const CsgBox& b) noexcept {
    return {glm::min(glm::min(a.low, a.high), glm::min(b.low, b.high)),
            glm::max(glm::max(a.low, a.high), glm::max(b.low, b.high))};
}
[[nodiscard]] inline CsgBox common(const CsgBox& a, const CsgBox& b) noexcept {
    return {glm::max(a.low, b.low), glm::min(a.high, b.high)};
}

// A primitive in its own coordinates.
class CsgShape {
public:
    CsgShape() = default;
    explicit CsgShape(const CsgNode& node) noexcept;

    [[nodiscard]] std::int32_t sheets() const noexcept;
    // f, and the sheet that it is.
    [[nodiscard]] double value(const glm::dvec3& p, std::int32_t& sheet) const noexcept;
    // One sheet, everywhere.  Where it has no gradient, such as at the centre of a sphere, that and the Hessian are 0.
    [[nodiscard]] CsgJet jet(std::int32_t sheet, const glm::dvec3& p) const noexcept;
    // Of what is left of all space, if the solid is moved by x -> linear x + translation: {f <= level}, level >= 0.
    [[nodiscard]] CsgBox box(const glm::dmat3& linear, const glm::dvec3& translation, double level) const noexcept;
    // ... and {f >= -level}.
    [[nodiscard]] CsgBox box_outside(const glm::dmat3& linear, const glm::dvec3& translation,
                                     double level) const noexcept;

private:
    [[nodiscard]] double side(double rho, double z) const noexcept {
        return slant_.x * (rho - radius_) + slant_.y * (z + half_.z);
    }

    CsgKind kind_ = CsgKind::sphere;
    glm::dvec3 half_{0.0}; // of a box; z: of a cylinder or cone
    double radius_ = 1.0;
    double second_radius_ = 0.0;
    glm::dvec2 slant_{1.0, 0.0}; // the normal of a cylinder's or cone's side: outward, up
};

} // namespace hrbfnpr::implicit
