// SPDX-License-Identifier: MIT
// Trees of solids as plain data, and their parts: primitives, blends of two functions, and bounding boxes. A primitive
// is the intersection of one to six smooth sheets, and its f is the largest of their signed distances. Inside the
// primitive f is the distance to the surface. Outside the primitive, the nearest place of the surface may be within a
// sheet: then f is the distance to this place. If the nearest place is on an edge or a corner, f is less than the
// distance.
#pragma once

#include "base/memory.h"
#include "implicit/lanes.h"

#include <glm/mat3x3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace hrbfnpr::implicit {

// The values equal the HRBFNPR_CSG_ constants in hrbfnpr.h. They are stored in files of models.
enum class CsgKind : std::uint32_t {
    unite,
    intersect,
    subtract, // subtracts all other children from the first
    complement,
    offset, // f - distance
    shell,  // max(f, -f - distance)
    model,
    half_space, // z <= 0
    box,
    sphere,
    cylinder, // a cylinder whose axis is the z axis and whose middle is at 0
    cone,     // like a cylinder, with `second_radius` at the top
    torus     // about the z axis, its tube of `second_radius`
};
inline constexpr auto last_csg_kind = static_cast<std::uint32_t>(CsgKind::torus);

[[nodiscard]] constexpr bool is_leaf(CsgKind kind) noexcept { return kind >= CsgKind::model; }
// Returns the largest number of children of a node; -1: any number of at least 1.
[[nodiscard]] constexpr std::int64_t children_of(CsgKind kind) noexcept {
    if (is_leaf(kind)) return 0;
    return kind <= CsgKind::subtract ? -1 : 1;
}

inline constexpr std::int64_t most_csg_nodes = 65536;

struct CsgNode {
    CsgKind kind = CsgKind::unite;
    std::int64_t parent = -1; // index of an earlier node; children keep the order of the nodes
    std::int64_t model = -1;  // index of a leaf's model
    // The affine map x = linear y + translation moves the node and all nodes below it.
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0};
    glm::dvec3 size{1.0};
    double radius = 1.0;
    double second_radius = 0.5;
    double height = 1.0;
    double distance = 0.0;
    double blend = 0.0;    // radius of the blend; 0: a sharp crease
    double exponent = 0.0; // 0: the polynomial blend; else the exponent of the super-elliptic blend
};

// A tree of solids. The first node is the root.
using CsgTree = base::Array<CsgNode>;

// The smallest and the largest factor by which a linear map stretches a vector.
struct StretchFactors {
    double least = 1.0, most = 1.0;
};
[[nodiscard]] StretchFactors stretch_factors(const glm::dmat3& linear) noexcept;

// A function of two numbers a and b, with its derivatives.
struct BlendJet {
    double value = 0.0;
    double by_a = 0.0, by_b = 0.0;
    double by_aa = 0.0, by_ab = 0.0, by_bb = 0.0;
};

// The rule that combines two functions.
struct Blend {
    double radius = 0.0;   // 0: the plain minimum or maximum
    double exponent = 0.0; // 0: the polynomial blend; else the exponent of the super-elliptic blend

    [[nodiscard]] BlendJet minimum(double a, double b) const noexcept;
    [[nodiscard]] BlendJet maximum(double a, double b) const noexcept {
        const BlendJet m = minimum(-a, -b);
        return {-m.value, m.by_a, m.by_b, -m.by_aa, -m.by_ab, -m.by_bb};
    }
    // Returns the largest amount by which a blend is below the lower of its two operands.
    [[nodiscard]] double depth() const noexcept {
        return radius * (exponent == 0.0 ? 1.0 / 6.0 : 1.0 - std::pow(0.5, 1.0 / exponent));
    }
    // Returns the largest factor by which a blend lengthens gradients.
    [[nodiscard]] double steepness() const noexcept {
        return exponent == 0.0 || radius == 0.0 ? 1.0 : std::pow(2.0, 1.0 / exponent);
    }
};

// A box, given by its lower and upper corner. Faces are infinite where a solid is unbounded. low > high means that the
// solid is empty.
struct CsgBox {
    glm::dvec3 low{-std::numeric_limits<double>::infinity()};
    glm::dvec3 high{std::numeric_limits<double>::infinity()};

    [[nodiscard]] CsgBox grown(double by) const noexcept { return {low - by, high + by}; }
    [[nodiscard]] bool empty() const noexcept { return !glm::all(glm::lessThanEqual(low, high)); }
};

// Bounds of a solid and of its complement.
struct CsgReach {
    CsgBox inside;  // contains {f <= 0}
    CsgBox outside; // contains {f >= 0}
    // For each level above 0: `inside`, grown by slope * level, contains {f <= level}, and `outside`, grown by the same
    // amount, contains {f >= -level}.
    double slope = 1.0;

    [[nodiscard]] CsgReach complement() const noexcept { return {outside, inside, slope}; }
    // Returns the bounds after `add` is added to f.
    [[nodiscard]] CsgReach shifted(double add) const noexcept {
        CsgReach reach = *this;
        (add < 0.0 ? reach.inside : reach.outside) = (add < 0.0 ? inside : outside).grown(slope * std::abs(add));
        return reach;
    }
    // Returns the bounds of {f = 0}.
    [[nodiscard]] CsgBox surface() const noexcept {
        return {glm::max(inside.low, outside.low), glm::min(inside.high, outside.high)};
    }
};
[[nodiscard]] CsgReach reach_of_minimum(const CsgReach& a, const CsgReach& b, const Blend& blend) noexcept;
[[nodiscard]] CsgReach reach_of_maximum(const CsgReach& a, const CsgReach& b, const Blend& blend) noexcept;

// A primitive in its own coordinates.
class CsgShape {
public:
    CsgShape() = default;
    explicit CsgShape(const CsgNode& node) noexcept;
    // Makes a box of the given size with its centre at 0.
    explicit CsgShape(const glm::dvec3& size) noexcept : kind_(CsgKind::box), half_(0.5 * size) {}

    [[nodiscard]] std::int32_t sheets() const noexcept;
    // Returns f, and writes the index of the sheet that equals f.
    [[nodiscard]] double value(const glm::dvec3& p, std::int32_t& sheet) const noexcept;
    // Returns the value and derivatives of one sheet at any place. Where the sheet has no gradient, for example at the
    // centre of a sphere, gradient and Hessian are 0.
    [[nodiscard]] Jet jet(std::int32_t sheet, const glm::dvec3& p) const noexcept;
    // Returns the bounds after the solid is moved by x -> linear x + translation and f is multiplied by `scale`.
    [[nodiscard]] CsgReach reach(const glm::dmat3& linear, const glm::dvec3& translation, double scale) const noexcept;

private:
    [[nodiscard]] double side(double rho, double z) const noexcept {
        return slant_.x * (rho - radius_) + slant_.y * (z + half_.z);
    }
    [[nodiscard]] CsgBox box(const glm::dmat3& linear, const glm::dvec3& translation, double level) const noexcept;

    CsgKind kind_ = CsgKind::sphere;
    glm::dvec3 half_{0.0}; // half the size of a box; for a cylinder or cone, z is half the height
    double radius_ = 1.0;
    double second_radius_ = 0.0;
    glm::dvec2 slant_{1.0, 0.0}; // the normal of a cylinder's or cone's side: radial and axial component
};

} // namespace hrbfnpr::implicit
