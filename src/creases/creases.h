// SPDX-License-Identifier: MIT
// A mesh of an implicit that has sheets, cut where they meet: each triangle stands for one of them, and there are
// vertices on the creases and at their corners. Its smooth parts, which end at creases, are what contours are traced
// on. Creases as curves: where two sheets are both 0 on the surface. They are traced once; their parts in a view are
// cut out for every camera.
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

// A place of a crease where an edge of the mesh crosses it, or a corner.
struct CreaseNode {
    glm::dvec3 position{0.0};
    bool exact = false; // both sheets are 0 there; else they could not be told apart, or more than two meet
};

// Creases as chains of nodes, from corner to corner, from border to border, or closed.
struct CreaseChains : Chains<CreaseNode> {
    explicit CreaseChains(base::Memory& memory) : Chains(memory), left(memory), right(memory) {}

    base::Array<std::int32_t> left, right; // the sheets on both sides of each chain, as seen from outside
};

struct SharpMesh {
    explicit SharpMesh(base::Memory& memory) : mesh(memory), sheet(memory), creases(memory) {}

    // A vertex on a crease stands there once for each sheet, with that sheet's gradient; edges on creases have no
    // neighbour.
    SurfaceMesh mesh;
    base::Array<std::int32_t> sheet; // the sheet of each triangle
    CreaseChains creases;
};

// The vertices of `mesh` stay the first ones. Some edges are halved whose sheets meet beside them, but off the surface,
// since another sheet lies between. The same bits for any thread count.
[[nodiscard]] SharpMesh split_at_creases(const base::Work& work, const implicit::Implicit& implicit, SurfaceMesh mesh);

struct SheetPart {
    SheetPart(base::Memory& memory, const implicit::Implicit& whole, const implicit::Sheets& sheets, std::int32_t of)
        : sheet(of), surface(whole, sheets, of), mesh(memory) {}

    std::int32_t sheet;
    implicit::OneSheet surface;
    SurfaceMesh mesh;                               // the mesh of this sheet alone; it ends at the sheet's creases
    std::unique_ptr<const implicit::Domain> domain; // the mesh's
};

// A part of each sheet that has triangles, in the order of sheets.
[[nodiscard]] base::List<std::unique_ptr<SheetPart>>
sheet_parts(const base::Runtime& runtime, const implicit::Implicit& whole, const SharpMesh& mesh);

// ---- Curves

struct CreasePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 left{0.0}, right{0.0}; // unit normals of the sheets to either side, as seen from outside
    glm::dvec3 tangent{0.0};          // unit, along the crease

    // The angle between the normals in degrees: 0 where the surface is smooth, negative where it is concave.
    [[nodiscard]] double angle() const noexcept;
};

// No two points of a crease are at one place.
struct Creases : Chains<CreasePoint> {
    explicit Creases(base::Memory& memory) : Chains(memory), left(memory), right(memory) {}

    base::Array<std::int32_t> left, right; // the sheets of each crease

    [[nodiscard]] std::int64_t bytes() const noexcept { return Chains::bytes() + left.bytes() + right.bytes(); }
};

// Each point is on both sheets, and there are as many as the crease's turns want. Creases end at corners, or where the
// mesh ends. side: of the mesh's cells.
[[nodiscard]] Creases trace_creases(const base::Work& work, const implicit::Implicit& implicit,
                                    const CreaseChains& chains, double side);

// Tells whether places are on creases whose angle is at least `least` degrees.
class NearCreases {
public:
    // side: of the mesh's cells.
    NearCreases(base::Memory& memory, const Creases& creases, double least, double side);

    // Whether a crease is no farther away than `reach`, or half a side if that is less.
    [[nodiscard]] bool has(const glm::dvec3& place, double reach) const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept { return from_.bytes() + to_.bytes() + grid_->bytes(); }

private:
    double most_;
    geometry::VecArray from_, to_;            // pieces
    std::optional<geometry::PointGrid> grid_; // their middles
};

// The sharpest angles of a whole crease, degrees: concave ones are negative.
struct AngleRange {
    float least = 0.0F, most = 0.0F;
};

// The parts of creases in a view, as lines. Their strength is the angle, degrees, negative where it is concave.
struct CreaseParts {
    explicit CreaseParts(base::Memory& memory)
        : folds(memory), outside(memory), inside(memory), of_outside(memory), of_inside(memory) {}

    SurfaceLines folds;   // parts of the contour: one sheet faces the eye, to their left, and the other one away
    SurfaceLines outside; // both sheets face the eye
    SurfaceLines inside;  // neither does
    base::Array<AngleRange> of_outside, of_inside; // the angles of the crease that each line is a part of
};
[[nodiscard]] CreaseParts parts_in_view(const base::Runtime& runtime, const implicit::Sheets& sheets,
                                        const Creases& creases, const View& view);

enum class CreaseSide : std::uint32_t { both = 0, convex = 1, concave = 2 };
// The angle as a positive one where it bends to that side; the other way of bending is negative.
[[nodiscard]] inline float angle_on(CreaseSide side, float angle) noexcept {
    return side == CreaseSide::both ? std::abs(angle) : side == CreaseSide::convex ? angle : -angle;
}
// The parts of lines of creases where they bend to a side by `lower` degrees or more, if the whole crease does so by
// `upper` somewhere: a crease that goes on from a part of the contour does not end there.
[[nodiscard]] SurfaceLines bent_parts(base::Memory& memory, const SurfaceLines& lines,
                                      const base::Array<AngleRange>& of, CreaseSide side, double lower, double upper);

} // namespace hrbfnpr::curves
