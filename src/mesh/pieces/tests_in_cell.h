// SPDX-License-Identifier: MIT
// What a tree of maxima and minima over the sheets of a cell has to do right there.
#pragma once

#include "implicit/pieces.h"
#include "mesh/pieces/creases.h"
#include "mesh/pieces/read_once.h"
#include "mesh/pieces/sides.h"

namespace hrbfnpr::mesh {

// The cube that a cell has a say in.
struct CellBox {
    glm::dvec3 centre{0.0};
    double half = 0.0;
    [[nodiscard]] bool contains(const glm::dvec3& p) const noexcept {
        const glm::dvec3 off = glm::abs(p - centre);
        return off.x <= half && off.y <= half && off.z <= half;
    }
};

// Which trees are tried, and what they are asked for.
class CellTests {
public:
    // chord: of each vertex, how far faces there are from what they stand for.  near: distance from the surface up to
    // which, besides, signs may be wrong.
    CellTests(const Mesh& mesh, const Sides& sides, const base::Array<std::int32_t>& patch,
              const base::Array<double>& chord, const ReadOnceTrees& trees, double near, std::uint64_t seed) noexcept
        : mesh_(mesh), sides_(sides), patch_(patch), chord_(chord), trees_(trees), near_(near), seed_(seed) {}

    struct Choice {
        std::int64_t tree = -1; // of those over so many sheets
        std::int64_t wrong = 0; // tests that it fails
        double side = 0.0;      // -1 or 1: all of the cell is inside, or outside
        double off = 0.0;       // how far its values are from distances, mean
    };
    // sheets: numbers of patches, ReadOnceTrees::most at most; those of the tests' own are looked up in it.
    // faces: those that meet the box.  cell: a number of its own.
    [[nodiscard]] Choice choose(base::InstructionSet set, base::Memory& memory,
                                const base::List<implicit::HrbfData>& sheet, std::span<const std::int32_t> sheets,
                                std::span<const std::int32_t> faces, const CellBox& box, std::uint64_t cell) const;

private:
    struct Tests;
    void gather(const CellBox& box, std::uint64_t cell, std::span<const std::int32_t> sheets, Tests& tests) const;
    void gather_on_faces(const CellBox& box, std::span<const std::int32_t> faces, std::span<const std::int32_t> sheets,
                         Tests& tests) const;
    void add_on_surface(const CellBox& box, const Beside& beside, double step, std::span<const std::int32_t> sheets,
                        Tests& tests) const;
    void add_beside(const Beside& beside, double step, Tests& tests) const;
    [[nodiscard]] Choice judge(const Tests& tests, const base::Array<double>& value, std::int32_t sheets,
                               std::int64_t tree) const noexcept;

    [[nodiscard]] double slack(std::int64_t face) const noexcept;

    const Mesh& mesh_;
    const Sides& sides_;
    const base::Array<std::int32_t>& patch_;
    const base::Array<double>& chord_;
    const ReadOnceTrees& trees_;
    double near_;
    std::uint64_t seed_;
};

} // namespace hrbfnpr::mesh
