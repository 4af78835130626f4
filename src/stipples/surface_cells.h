// SPDX-License-Identifier: MIT
// The cells of a grid that the surface passes through, each with a plane that approximates the function there.
//
//   find_surface_cells   seeds on the surface → SurfaceCells, by a flood from cell to neighbour
//   CellMap              codes of cells → the index of the cell with a code
//   CellMap::around      a code → the indices of the 27 cells around the cell with this code
#pragma once

#include "base/assert.h"
#include "geometry/cell_block.h"
#include "geometry/cell_grid.h"
#include "marks/site.h"

#include <array>
#include <cmath>

namespace hrbfnpr::stipples {

// A cell with the linear approximation of f at its centre: f(x) / |grad f| is about distance + normal . (x - centre).
struct SurfaceCell {
    std::uint64_t code; // a Morton code, see geometry/morton.h
    double distance;    // NaN if no plane approximates the function
    glm::dvec3 normal;  // unit vector; 0 if there is no plane
};

struct SurfaceCells {
    explicit SurfaceCells(base::Memory& memory) noexcept : cell(memory) {}

    geometry::CellGrid grid;
    geometry::Bounds region; // Marks stay inside this box.
    double band = 0.0; // The cells contain each point of the region whose distance from the surface is at most this.
    base::Array<SurfaceCell> cell; // sorted by code

    [[nodiscard]] double volume() const noexcept {
        return static_cast<double>(cell.size()) * grid.side * grid.side * grid.side;
    }
    [[nodiscard]] double half_diagonal() const noexcept { return 0.5 * std::sqrt(3.0) * grid.side; }
    // Returns half the thickness of the layer that the cells fill, to first order.
    [[nodiscard]] double reach() const noexcept { return half_diagonal() + band; }
    // Returns the area of the surface with an error of about 10 %: the volume of the cells divided by the thickness of
    // their layer.
    [[nodiscard]] double rough_area() const noexcept { return volume() / (2.0 * reach()); }
    [[nodiscard]] glm::dvec3 centre(std::int64_t number) const noexcept {
        HRBFNPR_ASSERT(number >= 0 && number < cell.size());
        return grid.centre(geometry::morton_cell(cell[number].code));
    }
};

// Finds the cells with the side length `side`. The band is half a side.
[[nodiscard]] SurfaceCells find_surface_cells(const marks::Site& site, const geometry::VecArray& seeds,
                                              const geometry::Bounds& region, double side);

// Finds the index of a cell by its code: a hash table of blocks of 4 x 4 x 4 cells.
class CellMap {
public:
    // The indices of the 27 cells around a cell (with the cell itself), or -1 where there is no cell. The first
    // coordinate changes fastest.
    using Around = std::array<std::int32_t, geometry::neighbour_count>;
    static constexpr std::size_t centre_index = 13;
    static constexpr std::size_t step_along[3] = {1, 3, 9};

    explicit CellMap(base::Memory& memory) noexcept : slots_(memory), number_(memory) {}
    // Cell i has the code codes[i]. Codes must be distinct and below 2^63, and codes of one block must be consecutive.
    CellMap(base::Memory& memory, const base::Array<std::uint64_t>& codes);
    explicit CellMap(const SurfaceCells& cells);

    // Returns the index of the cell with this code, or -1 if there is no such cell.
    [[nodiscard]] std::int32_t find(std::uint64_t code) const noexcept {
        const std::int32_t* const numbers = find_block(code / geometry::cells_of_block);
        return numbers == nullptr ? -1 : numbers[code % geometry::cells_of_block];
    }
    // The blocks that around() found for the last cell. They are used again for cells of the same block, so callers
    // should call around() in the order of codes.
    struct BlocksAround {
        std::uint64_t block = ~std::uint64_t{0};
        std::array<const std::int32_t*, geometry::neighbour_count> numbers{};
    };
    [[nodiscard]] Around around(std::uint64_t code, BlocksAround& blocks) const noexcept;

private:
    // Returns the indices of all cells of a block, in the order of their codes, or null if the block has no cell.
    [[nodiscard]] const std::int32_t* find_block(std::uint64_t block) const noexcept {
        if (slots_.empty()) return nullptr;
        const Slot& place = slots_[slot_of(block)];
        return place.key == 0 ? nullptr : number_[place.numbers].data();
    }
    struct Slot {
        std::uint64_t key; // block + 1, or 0 if the slot is free
        std::int64_t numbers;
    };
    [[nodiscard]] std::int64_t slot_of(std::uint64_t block) const noexcept;

    // A hash table with open addressing. Its size is a power of two, and at most half of it is used.
    base::Array<Slot> slots_;
    base::Array<std::array<std::int32_t, geometry::cells_of_block>> number_;
};

} // namespace hrbfnpr::stipples
