// SPDX-License-Identifier: MIT
// Curvatures of f = 0 and their derivatives, with a mesh. They are measured once and used for every view. The mesh is
// refined where curvatures do not change between two vertices as their derivatives there predict. This happens for
// example around the samples of a rough fit.
//
// Lines on the surface other than contours: suggestive contours, ridges, valleys, apparent ridges, parabolic lines,
// isophotes, plane sections.
//
// A mesh of the surface shows where the lines pass. Each point of a line is then brought onto the true curve, between
// the two vertices of the edge that the line crosses. A line that turns within a triangle is missed, so the mesh should
// be as fine as the lines to be drawn.
#pragma once

#include "curves/curves.h"
#include "curves/surface_mesh.h"
#include "implicit/shape_source.h"

#include <array>
#include <cstdint>
#include <span>

namespace hrbfnpr::curves {

// ---- Shape

// The signs are those of surface/curvature.h: k > 0 where the surface bends towards the normal grad f / |grad f|, so
// that a ball has k < 0. All values are 0 where there is no gradient.
struct ShapePoint {
    glm::dvec3 normal{0.0};
    glm::dvec3 d1{0.0}; // the direction of k1; the direction of k2 is d2()
    double k1 = 0.0;    // k1 >= k2
    double k2 = 0.0;
    std::array<double, 4> c{}; // C111 C112 C122 C222: derivatives of the second fundamental form

    [[nodiscard]] glm::dvec3 d2() const noexcept { return glm::cross(normal, d1); }
    // Convert between vectors in space and tangent vectors in the basis d1, d2.
    [[nodiscard]] glm::dvec2 in_tangent(const glm::dvec3& v) const noexcept {
        return {glm::dot(v, d1), glm::dot(v, d2())};
    }
    [[nodiscard]] glm::dvec3 in_space(const glm::dvec2& t) const noexcept { return t.x * d1 + t.y * d2(); }
    // Returns the second fundamental form applied to one vector.
    [[nodiscard]] glm::dvec2 bend(const glm::dvec2& t) const noexcept { return {k1 * t.x, k2 * t.y}; }
    // Returns the vector C(u, v, .).
    [[nodiscard]] glm::dvec2 change(const glm::dvec2& u, const glm::dvec2& v) const noexcept {
        const double mixed = u.x * v.y + u.y * v.x;
        return {c[0] * u.x * v.x + c[1] * mixed + c[2] * u.y * v.y, c[1] * u.x * v.x + c[2] * mixed + c[3] * u.y * v.y};
    }
};

// Computes the shape at a point. The order of `hessian` is xx xy xz yy yz zz, and that of `third` is xxx xxy xxz xyy
// xyz xzz yyy yyz yzz zzz. If k1 = k2 the directions are arbitrary, and C refers to them.
[[nodiscard]] ShapePoint shape_point(const glm::dvec3& gradient, const std::array<double, 6>& hessian,
                                     const std::array<double, 10>& third) noexcept;

// Computes the shape at all points. `gradient` is grad f there. Resizes `result`. Gives the same bits for any thread
// count.
void measure_shape(const base::Work& work, const implicit::ShapeSource& source, const geometry::VecArray& position,
                   const geometry::VecArray& gradient, base::Array<ShapePoint>& result);

struct ShapedMesh {
    explicit ShapedMesh(base::Memory& memory) noexcept : mesh(memory), shape(memory) {}

    SurfaceMesh mesh;              // `side` is the cell side of the given mesh
    base::Array<ShapePoint> shape; // the shape at the vertices of `mesh`
    [[nodiscard]] std::int64_t bytes() const noexcept { return mesh.bytes() + shape.bytes(); }
};

// Makes a refined copy of a mesh with its shape. It halves edges in up to three rounds, and moves their middles onto
// the surface. A triangle with halved edges is cut into two, three or four, so triangles still meet only in edges and
// corners. The vertices of `mesh` come first. Gives the same bits for any thread count. Throws Error{out_of_memory,
// cancelled, callback}.
[[nodiscard]] ShapedMesh measured_mesh(const base::Work& work, const implicit::Implicit& implicit,
                                       const implicit::ShapeSource& source, const SurfaceMesh& mesh);

enum class FeatureKind : std::uint8_t {
    suggestive_contour, // [DeCarlo et al. 2003]
    ridge,              // convex crests [Ohtake, Belyaev & Seidel 2004]
    valley,
    apparent_ridge, // [Judd, Durand & Adelson 2007]
    parabolic,      // where the Gaussian curvature K is 0
    isophote,       // where n . l = level, for the direction l to the light
    section         // plane . p = level
};

// Returns whether the sign of g changes with the sign of a principal direction.
[[nodiscard]] constexpr bool is_directed(FeatureKind kind) noexcept {
    return kind == FeatureKind::ridge || kind == FeatureKind::valley || kind == FeatureKind::apparent_ridge;
}
// Returns whether g is computed from curvatures.
[[nodiscard]] constexpr bool needs_shape(FeatureKind kind) noexcept { return kind != FeatureKind::section; }

struct FeatureValue {
    double g = 1.0;
    double strength = -1.0; // dimensionless; if not positive, no line passes here, whatever g is
    double facing = 1.0;    // view-dependent kinds: n . v, where v is the direction to the eye or light; other kinds: 1
    // Directed kinds: the unit direction along which g is a derivative. If the direction is reversed, g changes its
    // sign.
    glm::dvec3 along{0.0};
    glm::dvec3 gradient{0.0}; // the gradient of g along the surface, if third derivatives of f suffice for it; else 0
};

// `towards`: the eye or the light, as a place (w = 1) or as the direction to it (w = 0). `unit`: the length that makes
// strengths dimensionless, the model's diagonal. Not for sections.
//
//   kind                 g                                      strength
//   suggestive_contour   radial curvature times sin^2           its derivative towards the eye, times sin, unit^2
//   ridge, valley        C(d, d, d) of the larger curvature     (|k| - |k'|) unit; of a ridge k < 0
//   apparent_ridge       derivative of q1^2 along t1            q1 unit
//   parabolic            k1 k2 unit^2                           |grad K| unit^3
//   isophote             n . l                                  |grad (n . l)| unit
//
// sin: the sine of the angle between the normal and the view. Without it the first strength would grow without bound
// where the surface faces the eye. The strength does not depend on whether `towards` sees the outside or the inside.
// The caller must check whether a ridge is a line of greatest curvature rather than of least.
[[nodiscard]] FeatureValue feature_value(FeatureKind kind, const ShapePoint& shape, const glm::dvec3& position,
                                         const glm::dvec4& towards, double unit) noexcept;

// ---- Lines

struct FeatureRequest {
    FeatureKind kind = FeatureKind::suggestive_contour;
    // View-dependent lines: the position of the eye or light (w = 1), or the direction to it (w = 0).
    glm::dvec4 towards{0.0, 0.0, 1.0, 0.0};
    glm::dvec3 plane{0.0, 0.0, 1.0}; // sections: the unit normal of the planes
    std::span<const double> levels;  // isophotes, sections: one or several levels
    // A line continues while its strength is at least `lower`, and is drawn if its strength reaches `upper` somewhere
    // (hysteresis). To fade a line, multiply its ink by (strength - lower) / (upper - lower).
    double lower = 0.0;
    double upper = 0.0;
    double shortest = 0.0; // lines shorter than this are dropped, in diagonals
    // The greatest number of evaluations of g for each point. If it is 0, points are found by interpolation.
    // Interpolation is cubic for suggestive contours, parabolic lines and isophotes, which is enough for drawing; it is
    // linear for other kinds.
    std::int32_t rounds = 6;
};

// A place where a line crosses an edge of the mesh.
struct FeatureCrossing {
    std::int64_t edge; // one of the two half-edges
    std::int32_t a, b; // indices of the vertices, a < b
    double share;      // the interpolated root on the edge from a to b, in [0, 1]
    double g_a, g_b;   // g at a and b, relative to the direction at a; the signs differ
    double strength;   // linearly interpolated along the edge
    bool counts;       // whether the strength is large enough and the point faces the eye
    // For directed kinds: the slope of g along the direction, as an area-weighted sum over the triangles on both sides.
    double slope;
};

// Returns the chains of crossings on a mesh that may become lines. `value` has the values at the vertices. Adds the
// number of parts that are too weak to `weak`.
[[nodiscard]] Chains<FeatureCrossing> find_candidates(const base::Work& work, const SurfaceMesh& mesh,
                                                      const base::Array<FeatureValue>& value,
                                                      const FeatureRequest& request, std::int64_t& weak);

// The surface on which lines are found. The members must outlive every call that gets it.
struct FeatureSurface {
    const implicit::Implicit& implicit;
    const implicit::ShapeSource& source;
    const SurfaceMesh& mesh;
    const base::Array<ShapePoint>& shape; // the shape at the vertices of the mesh; may be empty for sections
};

struct FeaturePoint {
    glm::dvec3 position{0.0}; // on the surface
    glm::dvec3 normal{0.0};   // unit
    double strength = 0.0;    // see feature_value(); for sections the sine of the angle between plane and surface
    double facing = 1.0;      // see feature_value()
    bool resolved = false;    // true if a root was found
};

struct FeatureLines : Chains<FeaturePoint> {
    explicit FeatureLines(base::Memory& memory) : Chains(memory), level(memory) {}

    base::Array<std::int32_t> level; // the index of each line's level in the request
    std::int64_t weak = 0;           // the number of lines whose strength stays below `upper`
    std::int64_t too_short = 0;
    std::int64_t unresolved = 0; // the number of crossings of the mesh without a root; lines end there
};

// Gives the same bits for any thread count. Throws Error{out_of_memory, cancelled, callback}.
[[nodiscard]] FeatureLines find_feature_lines(const base::Work& work, const FeatureSurface& surface,
                                              const FeatureRequest& request);

[[nodiscard]] SurfaceLines as_lines(base::Memory& memory, const FeatureLines& features);

} // namespace hrbfnpr::curves
