// SPDX-License-Identifier: MIT
// The cells of a grid that the surface passes through, each with a plane that approximates the function there.
//
//   find_surface_cells   seeds on the surface → SurfaceCells, by a flood from cell to neighbour
//   CellMap              codes of cells → the number of the cell with a code
//   CellMap::around      a code → the numbers of the 27 cells around that cell
#pragma once

#include "base/assert.h"
#include "geometry/cell_block.h"
#include "geometry/cell_grid.h"
#include "marks/site.h"

#include <array>
#include <cmath>

namespace hrbfnpr::stipples {

// A cell with the linear approximation of f at its centre: f(x) /
// grad f
// ~ distance + normal . (x - centre).
struct SurfaceCell {
    std::uint64_t code; // geometry/morton.h
    double distance;    // NaN if there is no such plane
    glm::dvec3 normal;  // unit; 0 if there is no plane
};

struct SurfaceCells {
    explicit SurfaceCells(base::Memory& memory) noexcept : cell(memory) {}

    geometry::CellGrid grid;
    geometry::Bounds region;       // marks stay inside
    double band = 0.0;             // the cells contain every point of the region within this distance of the surface
    base::Array<SurfaceCell> cell; // by ascending code

    [[nodiscard]] double volume() const noexcept {
        return static_cast<double>(cell.size()) * grid.side * grid.side * grid.side;
    }
    [[nodiscard]] double half_diagonal() const noexcept { return 0.5 * std::sqrt(3.0) * grid.side; }
    // Half the thickness of the layer that the cells fill, to first order.
    [[nodiscard]] double reach() const noexcept { return half_diagonal() + band; }
    // The area of the surface within about 10 %: the volume of the layer over its thickness.
    [[nodiscard]] double rough_area() const noexcept { return volume() / (2.0 * reach()); }
    [[nodiscard]] glm::dvec3 centre(std::int64_t number) const noexcept {
        HRBFNPR_ASSERT(number >= 0 && number < cell.size());
        return grid.centre(geometry::morton_cell(cell[number].code));
    }
};

// Finds the cells of side `side`; the band is half a side.
[[nodiscard]] SurfaceCells find_surface_cells(const marks::Site& site, const geometry::VecArray& seeds,
                                              const geometry::Bounds& region, double side);

// The numbers of cells by their codes: a hash table of blocks of 4 x 4 x 4 cells.
class CellMap {
public:
    // Numbers of the 27 cells around a cell, the first coordinate running fastest; -1 where there is no such cell.
    using Around = std::array<std::int32_t, geometry::neighbour_count>;
    static constexpr std::size_t centre_index = 13;
    static constexpr std::size_t step_along[3] = {1, 3, 9};

    explicit CellMap(base::Memory& memory) noexcept : slots_(memory), number_(memory) {}
    // The number of codes[i] is i. Codes are distinct and below 2^63, and codes of one block are consecutive.
    CellMap(base::Memory& memory, const base::Array<std::uint64_t>& codes);
    explicit CellMap(const SurfaceCells& cells);

    // Returns -1 if no cell has that code.
    [[nodiscard]] std::int32_t find(std::uint64_t code) const noexcept {
        const std::int32_t* const numbers = find_block(code / geometry::cells_of_block);
        return numbers == nullptr ? -1 : numbers[code % geometry::cells_of_block];
    }
    // Cells of one block share their BlocksAround, so callers should ask in the order of codes.
    struct BlocksAround {
        std::uint64_t block = ~std::uint64_t{0};
        std::array<const std::int32_t*, geometry::neighbour_count> numbers{};
    };
    [[nodiscard]] Around around(std::uint64_t code, BlocksAround& blocks) const noexcept;

private:
    // The numbers of all cells of a block, in the order of their codes; null if the block has no cell.
    [[nodiscard]] const std::int32_t* find_block(std::uint64_t block) const noexcept {
        if (slots_.empty()) return nullptr;
        const Slot& place = slots_[slot_of(block)];
        return place.key == 0 ? nullptr : number_[place.numbers].data();
    }
    struct Slot {
        std::uint64_t key; // block + 1; 0 for a free place
        std::int64_t numbers;
    };
    [[nodiscard]] std::int64_t slot_of(std::uint64_t block) const noexcept;

    base::Array<Slot> slots_; // open addressing; the size is a power of two, at most half full
    base::Array<std::array<std::int32_t, geometry::cells_of_block>> number_;
};

} // namespace hrbfnpr::stipples
