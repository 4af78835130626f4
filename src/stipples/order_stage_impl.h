// SPDX-License-Identifier: MIT
// What a stage of the progressive order works on: its cells, their candidates and marks, tile by tile.
#pragma once

#include "geometry/cell_grid.h"
#include "stipples/order_loops.h"
#include "stipples/order_stage.h"

#include <array>

namespace hrbfnpr::stipples {

// Tiles of 8 x 8 x 8 cells are worked on in eight turns, in each of which no two are neighbours: what a mark changes
// is less than two cells outside its tile.  Within its turn a tile is filled greedily, one mark after the other.
class OrderStage::Impl {
public:
    // These are those of OrderStage.
    Impl(const marks::Site& site, Candidates& candidates, const CellMap& home, std::int32_t home_level,
         const StageSettings& settings, const OrderedMarks& marks, const base::Progress& progress);
    void sweep(std::span<const SweepStep> steps, std::int64_t room, OrderedMarks& marks);
    [[nodiscard]] const base::Array<std::uint8_t>& steps() const noexcept { return step_; }
    [[nodiscard]] float lowest();
    void drop_nearer(double distance);

private:
    // A mark in 16 bytes: its normal in the bits that it came from.
    struct Slot {
        float position[3];
        float normal;
    };
    static constexpr std::int32_t slots_of_cell = 5;
    // Marks stand with their cells, so that what is around a mark is in few cache lines: two for each cell.
    struct alignas(64) Cell {
        std::int64_t group; // where its candidates begin
        std::int32_t groups;
        std::int32_t best;       // open candidate of the lowest energy; -1: none
        std::int32_t marks;      // in its slots
        std::int32_t more;       // list of those that found no slot; -1: none
        std::uint32_t neighbour; // which of the 27 around it there are, itself among them
        glm::vec3 low;           // corner, relative to the grid's origin
        std::array<Slot, slots_of_cell> slot;
    };
    struct Extra {
        Slot mark;
        std::int32_t next;
    };
    struct Tile {
        std::int32_t begin, end; // cells
    };
    struct Fresh {
        OrderMark mark;
        float energy;
        std::int32_t cell; // -1: the gap is too small
        std::uint8_t step;
        bool linked; // in its cell's slots
    };
    static constexpr std::int64_t most_fresh = 64; // of a tile in a sweep

    class Turn;

    void take_candidates(Candidates& candidates);
    void work_in(Candidates& candidates);
    void copy_taken(Candidates& candidates, const base::Array<std::int64_t>& part);
    [[nodiscard]] Cell empty_cell(std::int64_t group, std::int64_t groups, std::uint64_t code) const noexcept;
    void find_tiles();
    void find_neighbours(std::int64_t begin, std::int64_t end) noexcept;
    [[nodiscard]] OrderBlock block_of(const Cell& cell) noexcept { return {groups_ + cell.group, cell.groups}; }
    template <class Visit>
    void for_reached(const glm::vec3& position, double distance, std::int32_t cell, Visit&& visit) const;
    [[nodiscard]] static Slot slot_of(const OrderMark& mark) noexcept;
    // Whether there was a slot.
    bool link(const OrderMark& mark, std::int32_t cell) noexcept;
    void link_all(const OrderedMarks& marks);
    void link_more(const OrderMark& mark, std::int32_t cell);
    template <class Visit>
    void for_marks(const Cell& cell, Visit&& visit) const;
    void feel_all();
    [[nodiscard]] float inverse_squared_reach() const noexcept {
        return static_cast<float>(1.0 / (settings_.reach * settings_.reach));
    }
    // Takes note of what was found of the candidates whose squared distance from marks is enough.
    void note(std::int32_t cell, const OrderLowest& found) noexcept;
    void refresh(std::int32_t cell, float enough) noexcept { note(cell, loops_.lowest(block_of(cell_[cell]), enough)); }
    [[nodiscard]] glm::vec3 low_corner(std::uint64_t code) const noexcept;
    [[nodiscard]] std::int32_t home_cell_at(const glm::dvec3& position, std::int32_t cell) const noexcept;
    [[nodiscard]] std::int32_t cell_at(const glm::dvec3& position) const noexcept;
    // Before a tile's turn comes, what it works on is brought from memory: where it is first.
    void bring_cells(const Tile& tile) const noexcept;
    void bring_candidates(const Tile& tile) const noexcept;
    void append(const Fresh& fresh, OrderedMarks& marks);
    void keep_lowest(std::int64_t room, OrderedMarks& marks);

    const marks::Site& site_;
    geometry::CellGrid grid_;
    geometry::Bounds region_; // relative to the grid's origin
    const CellMap& home_;
    std::int32_t home_level_;
    StageSettings settings_;
    base::Progress progress_; // only looked at for a cancel
    float side_;              // of a cell
    OrderLoops loops_;

    base::Array<std::uint64_t> code_; // of each cell
    CellMap number_;
    base::Array<Cell> cell_;
    base::Array<std::array<std::int32_t, 27>> neighbour_; // -1: not there
    base::Array<float> lowest_; // energy of the best candidate of each cell; infinite: there is none
    base::Array<float> floor_;  // no candidate of the cell has a lower energy
    float enough_ = 0.0F;       // squared distance from marks that made a candidate open in the last step
    base::Array<OrderGroup> group_;
    OrderGroup* groups_ = nullptr; // of this stage alone, or the candidates' own
    base::Array<Extra> extra_;

    base::Array<Tile> tile_; // turn by turn
    std::array<std::int64_t, 9> turn_{};
    base::Array<Fresh> fresh_;              // most_fresh for each tile of the turn
    base::Array<std::int32_t> fresh_count_; // of each tile of the turn
    base::Array<float> energy_;             // of all marks of the sweep, when they were placed
    base::Array<std::uint8_t> step_;
};

} // namespace hrbfnpr::stipples
