// SPDX-License-Identifier: MIT
// A mesh of an implicit function with sheets, cut where the sheets meet. Each triangle belongs to one sheet, and
// vertices lie on creases and their corners. The smooth parts of the mesh end at creases, and contours are traced on
// these parts. Creases are curves on the surface where two sheets are both 0. They are traced once; their visible parts
// are computed for each camera.
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
    bool exact = false; // whether both sheets are 0 here; false if the sheets nearly coincide, or if more than two meet
};

// Creases as chains of nodes. A chain is closed, or it is open and ends at corners or borders.
struct CreaseChains : Chains<CreaseNode> {
    explicit CreaseChains(base::Memory& memory) : Chains(memory), left(memory), right(memory) {}

    // For each chain, the sheets on its left and right side, as seen from outside.
    base::Array<std::int32_t> left, right;
};

struct SharpMesh {
    explicit SharpMesh(base::Memory& memory) : mesh(memory), sheet(memory), creases(memory) {}

    // Each node of a crease has a separate vertex for each of its sheets, with that sheet's gradient. Edges on creases
    // have no neighbour.
    SurfaceMesh mesh;
    base::Array<std::int32_t> sheet; // the sheet of each triangle
    CreaseChains creases;
};

// Cuts a mesh at its creases. The vertices of `mesh` come first. Edges are also halved where their sheets meet near the
// edge but off the surface, because another sheet lies between them. Gives the same bits for any thread count.
[[nodiscard]] SharpMesh split_at_creases(const base::Work& work, const implicit::Implicit& implicit, SurfaceMesh mesh);

struct SheetSurface {
    SheetSurface(base::Memory& memory, const implicit::Implicit& whole, const implicit::Sheets& sheets, std::int32_t of)
        : sheet(of), surface(whole, sheets, of), mesh(memory) {}

    std::int32_t sheet;
    implicit::OneSheet surface;
    SurfaceMesh mesh;                               // the triangles of this sheet; the mesh ends at the sheet's creases
    std::unique_ptr<const implicit::Domain> domain; // the domain of `mesh`
};

// Makes a mesh for each sheet that has triangles, in the order of the sheets.
[[nodiscard]] base::List<std::unique_ptr<SheetSurface>>
sheet_surfaces(const base::Runtime& runtime, const implicit::Implicit& whole, const SharpMesh& mesh);

// ---- Curves

struct CreasePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 left{0.0}, right{0.0}; // unit normals of the sheets on the left and right side, as seen from outside
    glm::dvec3 tangent{0.0};          // unit vector along the crease

    // Returns the angle between the normals in degrees: 0 where the surface is smooth, negative where it is concave.
    [[nodiscard]] double angle() const noexcept;
};

// Traced creases. No two points of a crease coincide.
struct Creases : Chains<CreasePoint> {
    explicit Creases(base::Memory& memory) : Chains(memory), left(memory), right(memory) {}

    base::Array<std::int32_t> left, right; // for each crease, the sheets on its left and right side

    [[nodiscard]] std::int64_t bytes() const noexcept { return Chains::bytes() + left.bytes() + right.bytes(); }
};

// Traces the creases. Each point is on both sheets, and points are closer where a crease turns. Creases end at corners
// or at the border of the mesh. `side` is the side of the mesh's cells.
[[nodiscard]] Creases trace_creases(const base::Work& work, const implicit::Implicit& implicit,
                                    const CreaseChains& chains, double side);

// Tells whether places are on creases whose angle is at least `least` degrees.
class NearCreases {
public:
    // `least` is the least angle in degrees. `side` is the side of the mesh's cells.
    NearCreases(base::Memory& memory, const Creases& creases, double least, double side);

    // Returns whether a crease is within the distance `reach` of the place. `reach` is limited to half the side of a
    // mesh cell.
    [[nodiscard]] bool has(const glm::dvec3& place, double reach) const noexcept;
    [[nodiscard]] std::int64_t bytes() const noexcept { return from_.bytes() + to_.bytes() + grid_->bytes(); }

private:
    double most_;
    geometry::VecArray from_, to_;            // the ends of all pieces
    std::optional<geometry::PointGrid> grid_; // the middles of the pieces
};

// The smallest and the largest angle of a crease in degrees. Concave angles are negative.
struct AngleRange {
    float least = 0.0F, most = 0.0F;
};

// The parts of creases in a view, as lines. The strength of a line is the angle in degrees, negative where the crease
// is concave.
struct CreaseParts {
    explicit CreaseParts(base::Memory& memory)
        : folds(memory), outside(memory), inside(memory), of_outside(memory), of_inside(memory) {}

    // Parts of the contour: the sheet on the left faces the eye, and the sheet on the right faces away.
    SurfaceLines folds;
    SurfaceLines outside;                          // both sheets face the eye
    SurfaceLines inside;                           // no sheet faces the eye
    base::Array<AngleRange> of_outside, of_inside; // for each line, the range of angles of its whole crease
};
[[nodiscard]] CreaseParts parts_in_view(const base::Runtime& runtime, const implicit::Sheets& sheets,
                                        const Creases& creases, const View& view);

enum class CreaseSide : std::uint32_t { both = 0, convex = 1, concave = 2 };
// Returns the angle of a crease with a sign for a side of the surface: positive if the crease bends to this side,
// negative if it bends to the other side.
[[nodiscard]] inline float angle_on(CreaseSide side, float angle) noexcept {
    return side == CreaseSide::both ? std::abs(angle) : side == CreaseSide::convex ? angle : -angle;
}
// Returns the parts of lines whose creases bend to a side by at least `lower` degrees, if the whole crease bends by at
// least `upper` degrees somewhere. The whole crease is considered so that a crease does not end where a part of the
// contour continues it.
[[nodiscard]] SurfaceLines bent_parts(base::Memory& memory, const SurfaceLines& lines,
                                      const base::Array<AngleRange>& of, CreaseSide side, double lower, double upper);

} // namespace hrbfnpr::curves
