// SPDX-License-Identifier: MIT
// Divides space into cells. In each cell, a tree of maxima and minima joins a few sheets, so that they represent the
// surface of the mesh.
#pragma once

#include "implicit/sheet_tree.h"
#include "mesh/face_tree.h"
#include "mesh/pieces/creases.h"

#include <span>

namespace hrbfnpr::mesh {

// Lists all ways to combine a few functions by maxima and minima, each way once. Each way is a program of
// implicit::SheetTreeData: a sequence of function indices, `maximum` and `minimum`. For 1 to `most` functions there are
// 1, 2, 8, 52 and 472 programs (series-parallel networks: MacMahon 1890).
class ReadOnceTrees {
public:
    static constexpr std::int32_t most = 5;

    explicit ReadOnceTrees(base::Memory& memory);

    [[nodiscard]] std::int64_t count(std::int32_t functions) const noexcept {
        HRBFNPR_ASSERT(functions >= 1 && functions <= most);
        return first_[functions + 1] - first_[functions];
    }
    [[nodiscard]] std::span<const std::int32_t> program(std::int32_t functions, std::int64_t tree) const noexcept {
        HRBFNPR_ASSERT(tree >= 0 && tree < count(functions));
        const std::int64_t at = first_[functions] + tree;
        return code_.span().subspan(static_cast<std::size_t>(begin_[at]),
                                    static_cast<std::size_t>(begin_[at + 1] - begin_[at]));
    }

private:
    base::Array<std::int64_t> first_; // for each number of functions: the index of its first tree
    base::Array<std::int64_t> begin_; // the start of each tree in code_, and the end of the last
    base::Array<std::int32_t> code_;
};

struct CellsReport {
    std::int64_t cells = 0;
    std::int64_t surface_cells = 0;
    std::int64_t poor_cells = 0; // the number of cells in which no tree passes all tests
};

// Sets the cells of `data`, which has a sheet for each patch, in the order of the patches. `chord` has, for each
// vertex, the distance of its faces from the smooth surface that they approximate.
[[nodiscard]] CellsReport make_cells(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                     const Creases& creases, const base::Array<double>& chord, std::uint64_t seed,
                                     implicit::SheetTreeData& data);

} // namespace hrbfnpr::mesh
