// SPDX-License-Identifier: MIT
// Where edges of a mesh cross creases, and triangles their corners.
#pragma once

#include "creases/crease_mesh.h"

#include <array>
#include <cstdint>

namespace hrbfnpr::curves {

// Of an edge whose ends belong to different sheets.
struct EdgeNode {
    std::int64_t edge;                 // the first of its two
    std::array<std::int32_t, 2> ends;  // its start and end
    std::array<std::int32_t, 2> sheet; // of these
    CreaseNode at;
    std::array<glm::dvec3, 2> gradient; // of the sheets of the edge's start and end
    std::array<bool, 2> equal;          // the start may belong to the end's sheet, the end to the start's
    bool alike;                         // both, nearly
    bool meet;                          // both do somewhere beside the edge, on the surface or off it
    bool near;                          // both meet beside the surface, at an angle

    // Another sheet lies between both, where they meet.
    [[nodiscard]] bool passes_another() const noexcept { return !at.exact && !alike && meet; }
};

// Of a triangle whose corners belong to three sheets.
struct CornerNode {
    std::int64_t triangle;
    CreaseNode at;
    std::array<glm::dvec3, 3> gradient; // of its corners' sheets
};

// In sides: as far apart, and as parallel, sheets are nearly one, and what is between them is not looked for.
constexpr double alike_sheets = 0.02;

class CreaseNodes {
public:
    // sheet: of each vertex.
    CreaseNodes(const implicit::Implicit& implicit, const SurfaceMesh& mesh,
                const base::Array<std::int32_t>& sheet) noexcept
        : implicit_(implicit), sheets_(*implicit.sheets()), mesh_(mesh), sheet_(sheet) {}

    void look_at(EdgeNode& node) const;
    // middle: of the nodes on the triangle's edges.
    void look_at(CornerNode& node, const glm::dvec3& middle) const;
    // Of a corner without a place, by one of its triangle's edges that has one.
    [[nodiscard]] bool place_at_seam(CornerNode& node, const EdgeNode& beside) const;

private:
    [[nodiscard]] double off_surface(const glm::dvec3& place) const;
    [[nodiscard]] bool folds(const CreaseNode& at, const std::array<glm::dvec3, 2>& gradient, double far) const;
    [[nodiscard]] bool folds_beside(const EdgeNode& node) const;

    const implicit::Implicit& implicit_;
    const implicit::Sheets& sheets_;
    const SurfaceMesh& mesh_;
    const base::Array<std::int32_t>& sheet_;
};

} // namespace hrbfnpr::curves
