// SPDX-License-Identifier: MIT
// A mesh of an implicit with sheets, cut where the sheets meet: each triangle belongs to one sheet, and vertices lie on
// creases and their corners. The smooth parts of the mesh end at creases; contours are traced on them. Creases are
// curves where two sheets are both 0 on the surface. They are traced once; their visible parts are computed for each
// camera.
#pragma once

#include "base/list.h"
#include "curves/curves.h"
#include "geometry/point_grid.h"
#include "implicit/sheets.h"

#include <cmath>
#include <memory>
#include <optional>

namespace hrbfnpr::curves {

// ---- The mesh

// A place where an edge of the mesh crosses a crease, or a corner of creases.
struct CreaseNode {
    glm::dvec3 position{0.0};
    bool exact = false; // both sheets are 0 here; false: the sheets nearly coincide, or more than two meet
};

// Creases as chains of nodes, either closed, or open between corners or borders.
struct CreaseChains : Chains<CreaseNode> {
    explicit CreaseChains(base::Memory& memory) : Chains(memory), left(memory), right(memory) {}

    base::Array<std::int32_t> left, right; // the sheets on the two sides of each chain, as seen from outside
};

struct SharpMesh {
    explicit SharpMesh(base::Memory& memory) : mesh(memory), sheet(memory), creases(memory) {}

    // A crease has a separate vertex for each of its sheets, with that sheet's gradient; edges on creases have no
    // neighbour.
    SurfaceMesh mesh;
    base::Array<std::int32_t> sheet; // the sheet of each triangle
    CreaseChains creases;
};

// The first vertices are those of `mesh`. Edges are also halved where their sheets meet near them but off the surface,
// since another sheet lies between. Gives the same bits for any thread count.
[[nodiscard]] SharpMesh split_at_creases(const base::Work& work, const implicit::Implicit& implicit, SurfaceMesh mesh);

struct SheetSurface {
    SheetSurface(base::Memory& memory, const implicit::Implicit& whole, const implicit::Sheets& sheets, std::int32_t of)
        : sheet(of), surface(whole, sheets, of), mesh(memory) {}

    std::int32_t sheet;
    implicit::OneSheet surface;
    SurfaceMesh mesh;                               // the triangles of this sheet; the mesh ends at the sheet's creases
    std::unique_ptr<const implicit::Domain> domain; // the domain of `mesh`
};

// Makes a part of each sheet that has triangles, in the order of sheets.
[[nodiscard]] base::List<std::unique_ptr<SheetSurface>>
sheet_surfaces(const base::Runtime& runtime, const implicit::Implicit& whole, const SharpMesh& mesh);

// ---- Curves

struct CreasePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 left{0.0}, right{0.0}; // unit normals of the sheets on the two sides, as seen from outside
    glm::dvec3 tangent{0.0};          // unit, along the crease

    // The angle between the normals in degrees: 0 where the surface is smooth, negative where it is concave.
    [[nodiscard]] double angle() const noexcept;
};

// No two points of a crease coincide.
struct Creases : Chains<CreasePoint> {
    explicit Creases(base::Memory& memory) : Chains(memory), left(memory), right(memory) {}

    base::Array<std::int32_t> left, right; // the two sheets of each crease

    [[nodiscard]] std::int64_t bytes() const noexcept { return Chains::bytes() + left.bytes() + right.bytes(); }
};

// Each point is on both sheets; there are more points where a crease turns. Creases end at corners, or where the mesh
// ends. side: side of the mesh's cells.
[[nodiscard]] Creases trace_creases(const base::Work& work, const implicit::Implicit& implicit,
                                    const CreaseChains& chains, double side);

// Tells whether places are on creases whose angle is at least `least` degrees.
class NearCreases {
public:
    // side: side of the mesh's cells.
    NearCreases(base::Memory& memory, const Creases& creases, double least, double side);

    // Whether a crease is within `reach`, or within half a side if that is less.
    [[nodiscard]] bool has(const glm::dvec3& place, double reach) const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept { return from_.bytes() + to_.bytes() + grid_->bytes(); }

private:
    double most_;
    geometry::VecArray from_, to_;            // the ends of all pieces
    std::optional<geometry::PointGrid> grid_; // the middles of the pieces
};

// The least and the greatest angle of a crease in degrees; concave ones are negative.
struct AngleRange {
    float least = 0.0F, most = 0.0F;
};

// The parts of creases in a view, as lines. Their strength is the angle in degrees, negative where it is concave.
struct CreaseParts {
    explicit CreaseParts(base::Memory& memory)
        : folds(memory), outside(memory), inside(memory), of_outside(memory), of_inside(memory) {}

    SurfaceLines folds;   // parts of the contour: the sheet to the left faces the eye, and the other one faces away
    SurfaceLines outside; // both sheets face the eye
    SurfaceLines inside;  // no sheet faces the eye
    base::Array<AngleRange> of_outside, of_inside; // the angles of each line's whole crease
};
[[nodiscard]] CreaseParts parts_in_view(const base::Runtime& runtime, const implicit::Sheets& sheets,
                                        const Creases& creases, const View& view);

enum class CreaseSide : std::uint32_t { both = 0, convex = 1, concave = 2 };
// Returns the angle, positive where the crease bends to this side, and negative where it bends to the other.
[[nodiscard]] inline float angle_on(CreaseSide side, float angle) noexcept {
    return side == CreaseSide::both ? std::abs(angle) : side == CreaseSide::convex ? angle : -angle;
}
// The parts of lines where creases bend to a side by at least `lower` degrees, provided that the whole crease bends by
// `upper` somewhere. The whole crease counts so that a crease which continues a part of the contour does not end there.
[[nodiscard]] SurfaceLines bent_parts(base::Memory& memory, const SurfaceLines& lines,
                                      const base::Array<AngleRange>& of, CreaseSide side, double lower, double upper);

} // namespace hrbfnpr::curves
