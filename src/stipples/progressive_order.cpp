// SPDX-License-Identifier: MIT
#include "stipples/candidates.h"

#include "base/bits.h"
#include "base/long_array.h"
#include "base/prefetch.h"
#include "geometry/tangent_frame.h"
#include "stipples/tuning.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>
#include <span>
#include <utility>

namespace hrbfnpr::stipples {
namespace {

using geometry::CellGrid;

// ---- The data of a stage

struct StageSettings {
    std::int32_t level = 0;         // The side of the stage's cells is that of the candidates' cells times 2^level.
    double reach = 0.0;             // the distance up to which a mark has energy; at most the side of a cell
    std::uint64_t ticket_limit = 0; // Only candidates with a smaller ticket take part.
    // A candidate may move into its gap if its distance from all marks is at least this share of the least distance
    // between marks.
    double move_clearance = 0.8;
    double farthest_move = 0.0; // the longest move of a candidate; less than half a side
};

// The cells of the last stage. All marks must stay inside them, because the last stage looks for marks only there.
struct LastStageCells {
    std::int32_t level;
    CellMap cells;
};

// The marks in the order in which they were placed.
struct PlacementOrder {
    explicit PlacementOrder(base::Memory& memory) noexcept : mark(memory), sweep(memory), step(memory) {}

    struct Sweep {
        std::int64_t first; // the index of its first mark
        double before;      // the number of marks of the whole order before the sweep
    };

    base::Array<OrderMark> mark;
    base::Array<Sweep> sweep;
    base::Array<std::uint8_t> step; // for each mark: the step of its sweep in which it was placed
    // The number of marks that the whole order has. It differs from the number of marks if some are not needed.
    double whole = 0.0;
};

constexpr std::int32_t slots_of_cell = 5;

// The result of a search in a cell without candidates.
constexpr LowestEnergy no_candidate = {-1, std::numeric_limits<float>::infinity(),
                                       std::numeric_limits<float>::infinity()};

// A cell with its marks. A cell takes two cache lines and contains up to five of its marks, so that the marks around a
// place are in few cache lines.
struct alignas(64) StageCell {
    std::int64_t group; // the group in which the cell's candidates begin
    std::int32_t groups;
    std::int32_t best;  // the open candidate with the lowest energy, or -1 if none is open
    std::int32_t marks; // the number of slots in use
    std::int32_t more;  // the first mark without a slot, as an index of Stage::extra; -1 if all marks have slots
    glm::vec3 low;      // the lower corner, relative to the origin of the grid
    std::array<OrderMark, slots_of_cell> slot;
};
struct ExtraMark {
    OrderMark mark;
    std::int32_t next; // the next mark of the same cell, as an index of Stage::extra; -1 for the last
};
struct Tile {
    std::int32_t begin, end; // the range of the tile's cells
};
struct FreshMark {
    OrderMark mark;
    float energy;
    std::int32_t cell; // the cell of the mark; -1 if the gap is too small
    std::uint8_t step;
    bool linked; // true if the mark has one of its cell's slots
};
// The largest number of marks in a tile in one sweep.
constexpr std::int64_t most_fresh = 64;
// The number of low bits by which the coordinates of a cell are shortened to get the coordinates of its tile.
constexpr unsigned tile_bits = 3;

[[nodiscard]] glm::dvec3 vector(const float (&v)[3]) noexcept { return {v[0], v[1], v[2]}; }
[[nodiscard]] glm::vec3 place_of(const OrderMark& mark) noexcept {
    return {mark.position[0], mark.position[1], mark.position[2]};
}
[[nodiscard]] glm::dvec3 unpacked(float packed) noexcept {
    float normal[3];
    unpack_normal(packed, normal);
    return vector(normal);
}

// Returns a bit for each of the 27 cells around a cell. The bit is set if the other cell has a point closer than
// `distance` to the place `in_cell`.
[[nodiscard]] std::uint32_t reached(const glm::vec3& in_cell, float side, float distance) noexcept {
    float squared[3][3];
    for (int axis = 0; axis < 3; ++axis) {
        const float low = std::max(in_cell[axis], 0.0F);
        const float high = std::max(side - in_cell[axis], 0.0F);
        squared[axis][0] = low * low;
        squared[axis][1] = 0.0F;
        squared[axis][2] = high * high;
    }
    std::uint32_t found = 0;
    unsigned step = 0;
    for (const float z : squared[2])
        for (const float y : squared[1])
            for (const float x : squared[0]) found |= (x + y + z < distance * distance ? 1U : 0U) << step++;
    return found;
}

// The cells of a stage with their candidates and marks. Tiles of 8 x 8 x 8 cells are processed in eight turns. No two
// tiles of a turn are neighbours, because a mark affects candidates up to two cells outside its tile. In a turn, each
// tile is filled greedily, mark by mark.
struct Stage {
    Stage(const marks::Site& of, const Candidates& candidates, const LastStageCells& last_stage_cells,
          const StageSettings& its)
        : site(of),
          grid(candidates.grid), region{candidates.region.min - grid.origin, candidates.region.max - grid.origin},
          last_stage(last_stage_cells), settings(its), side(static_cast<float>(std::ldexp(grid.side, its.level))),
          creased(of.implicit.sheets() != nullptr), loops(order_loops(of.work.instruction_set)), number(of.memory()),
          cell(of.memory()), neighbour(of.memory()), lowest(of.memory()), floor(of.memory()), needed(of.memory()),
          needed_around(of.memory()), relative_area(of.memory()), own_group(of.memory()), extra(of.memory()),
          tile(of.memory()), fresh(of.memory()), fresh_count(of.memory()) {}

    [[nodiscard]] OrderBlock block_of(std::int64_t c) noexcept {
        HRBFNPR_ASSERT(c >= 0 && c < cell.size());
        return {group + cell[c].group, cell[c].groups};
    }
    [[nodiscard]] float inverse_squared_reach() const noexcept {
        return static_cast<float>(1.0 / (settings.reach * settings.reach));
    }
    // Returns the code of the candidates' cell that contains a position, which is relative to the origin of the grid.
    [[nodiscard]] std::uint64_t code_at(const glm::dvec3& position) const noexcept {
        return geometry::morton_code(grid.cell_of(grid.origin + position));
    }
    [[nodiscard]] std::int32_t cell_at(std::uint64_t code) const noexcept {
        return number.find(code >> static_cast<unsigned>(3 * settings.level));
    }

    // Returns whether a cell has candidates: the cell or a cell beside it needs more than is placed.
    [[nodiscard]] bool is_open(std::int64_t c) const noexcept {
        return needed_around.empty() || needed_around[c] > placed_share;
    }
    // Returns whether the marks of a cell are counted: the cell itself needs more than is placed.
    [[nodiscard]] bool is_counted(std::int64_t c) const noexcept { return needed.empty() || needed[c] > placed_share; }

    // Stores which candidate of a cell is the best among those far enough from all marks.
    void store_lowest(std::int32_t c, const LowestEnergy& found) noexcept {
        cell[c].best = static_cast<std::int32_t>(found.at);
        lowest[c] = found.energy;
        floor[c] = found.at_any_clearance;
    }
    void update_lowest(std::int32_t c, float clearance) noexcept {
        store_lowest(c, loops.lowest(block_of(c), clearance));
    }

    // Calls visit(c) for all cells c, on all threads.
    template <class Visit>
    void for_cells(Visit&& visit) const {
        site.work.for_chunks(cell.size(), cells_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t c = begin; c < end; ++c) visit(c);
        });
    }
    // Calls visit for each cell that has a point closer than `distance` to a place in cell c.
    template <class Visit>
    void for_reached(const glm::vec3& position, double distance, std::int32_t c, Visit&& visit) const {
        std::uint32_t left = reached(position - cell[c].low, side, static_cast<float>(distance));
        for (; left != 0; left &= left - 1)
            if (const std::int32_t there = neighbour[c][static_cast<std::size_t>(std::countr_zero(left))]; there >= 0)
                visit(there);
    }
    template <class Visit>
    void for_marks(std::int32_t c, Visit&& visit) const {
        for (std::int32_t k = 0; k < cell[c].marks; ++k) visit(cell[c].slot[static_cast<std::size_t>(k)]);
        for (std::int32_t at = cell[c].more; at >= 0; at = extra[at].next) visit(extra[at].mark);
    }
    // Adds a mark to a slot of cell c. Returns false if no slot is free.
    bool link(const OrderMark& mark, std::int32_t c) noexcept {
        HRBFNPR_ASSERT(c >= 0 && c < cell.size());
        if (cell[c].marks == slots_of_cell) return false;
        cell[c].slot[static_cast<std::size_t>(cell[c].marks++)] = mark;
        return true;
    }
    void link_more(const OrderMark& mark, std::int32_t c) {
        extra.push_back({mark, cell[c].more});
        cell[c].more = static_cast<std::int32_t>(extra.size() - 1);
    }

    const marks::Site& site;
    CellGrid grid;           // the grid of the candidates, whose cells are those of level 0
    geometry::Bounds region; // relative to the origin of the grid
    const LastStageCells& last_stage;
    StageSettings settings;
    float side;          // the side of a cell of the stage, in units of the object
    std::size_t creased; // The index of the loops to use: 1 if the surface has creases, else 0.
    OrderLoops loops;

    CellMap number; // finds the index of a cell by its code
    base::Array<StageCell> cell;
    base::Array<CellMap::Around> neighbour;
    base::Array<float> lowest; // for each cell: the energy of its best candidate; infinite if none is open
    base::Array<float> floor;  // for each cell: a lower bound for the energy of its candidates
    // For each cell: the share of the order that is needed, the largest such share of the cell and its neighbours, and
    // the area of the surface in the cell, in some unit. Empty if the whole order is needed everywhere.
    base::Array<float> needed, needed_around, relative_area;
    double whole_area = 0.0;    // the sum of `relative_area`
    float placed_share = 0.0F;  // the share of the order that is placed before the present sweep
    double counted_share = 1.0; // the share of the area in which more of the order is needed
    // A candidate is open if its squared distance from all marks is at least this. Set for the last step of a sweep.
    float least_clearance = 0.0F;
    OrderGroup* group = nullptr; // points to `own_group`, or to the groups of the candidates
    base::Array<OrderGroup> own_group;
    base::Array<ExtraMark> extra;

    base::Array<Tile> tile; // the tiles of the first turn, then the tiles of the second, and so on
    std::array<std::int64_t, 9> turn{};
    base::Array<FreshMark> fresh;          // for each tile of the turn: room for most_fresh marks
    base::Array<std::int32_t> fresh_count; // for each tile of the turn: the number of its fresh marks
};

// ---- Making a stage

// The cells of a stage that contain cells of the candidates.
struct CellsOfStage {
    explicit CellsOfStage(base::Memory& memory) noexcept : code(memory), part(memory) {}

    base::Array<std::uint64_t> code;
    // for each cell of the stage: the index of the first of the candidates' cells that it contains; at the end, the
    // number of the candidates' cells
    base::Array<std::int64_t> part;
};

[[nodiscard]] CellsOfStage find_cells(const Candidates& candidates, const Stage& stage) {
    CellsOfStage found(stage.site.memory());
    for (std::int64_t c = 0; c < candidates.cells(); ++c) {
        const std::uint64_t here = candidates.code[c] >> static_cast<unsigned>(3 * stage.settings.level);
        if (!found.code.empty() && found.code.back() == here) continue;
        found.code.push_back(here);
        found.part.push_back(c);
    }
    found.part.push_back(candidates.cells());
    return found;
}

// Sets the shares of the cells, if some of the order is not needed everywhere.
void find_shares(const Candidates& candidates, const CellsOfStage& cells, Stage& stage) {
    if (candidates.share.empty()) return;
    stage.needed.resize(cells.code.size());
    stage.relative_area.resize(cells.code.size());
    for (std::int64_t c = 0; c < cells.code.size(); ++c)
        for (std::int64_t from = cells.part[c]; from < cells.part[c + 1]; ++from) {
            stage.needed[c] = std::max(stage.needed[c], candidates.share[from]);
            stage.relative_area[c] += candidates.relative_area[from];
        }
    stage.whole_area = std::accumulate(stage.relative_area.begin(), stage.relative_area.end(), 0.0);
    stage.needed_around = largest_around(stage.site.work, cells.code, stage.number, stage.needed);
}

// Puts the candidates into the cells of the stage, but not into closed cells. The candidates are not copied if all of
// them take part, and if the cells of the stage are those of the candidates.
void take_candidates(Candidates& candidates, const CellsOfStage& cells, Stage& stage) {
    const StageSettings& settings = stage.settings;
    const base::Array<std::uint64_t>& code = cells.code;
    stage.cell.resize_for_overwrite(code.size());
    const auto empty_cell = [&](std::int64_t c, std::int64_t group, std::int64_t count) {
        const CellGrid::Cell at = geometry::morton_cell(code[c]);
        const glm::vec3 low(static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2]));
        return StageCell{group, static_cast<std::int32_t>(groups_for(count)), -1, 0, -1, stage.side * low, {}};
    };
    if (settings.level == 0 && settings.ticket_limit > 0xffffffffU) {
        stage.group = candidates.group.data();
        stage.for_cells([&](std::int64_t c) {
            const std::int64_t count = stage.is_open(c) ? candidates.number[c] : 0;
            stage.cell[c] = empty_cell(c, candidates.first[c] / OrderGroup::size, count);
            forget_marks(stage.block_of(c), count);
        });
        return;
    }
    const auto for_taken = [&](std::int64_t c, auto&& visit) {
        if (!stage.is_open(c)) return;
        for (std::int64_t from = cells.part[c]; from < cells.part[c + 1]; ++from)
            candidates.for_taken(from, settings.ticket_limit, visit);
    };
    // A large cell has as many candidates as many small cells, so the number of cells in a chunk depends on the cell
    // size.
    const std::int64_t grain = std::clamp<std::int64_t>(code.size() / 64, 1, cells_a_task);
    stage.site.work.for_chunks(code.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t c = begin; c < end; ++c) {
            std::int64_t count = 0;
            for_taken(c, [&](std::int64_t) { ++count; });
            stage.cell[c] = empty_cell(c, 0, count);
        }
    });
    std::int64_t groups = 0;
    for (StageCell& cell : stage.cell) cell.group = std::exchange(groups, groups + cell.groups);
    stage.own_group.resize_for_overwrite(groups);
    stage.group = stage.own_group.data();
    stage.site.work.for_chunks(code.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t c = begin; c < end; ++c) {
            stage.site.work.check();
            const OrderBlock block = stage.block_of(c);
            std::int64_t count = 0;
            for_taken(c, [&](std::int64_t place) { copy_place(candidates.places(), place, block, count++); });
            forget_marks(block, count);
        }
    });
}

// Removes the candidates of cells that do not need more than the share of the order that is placed. Sets the share of
// the area in which more is needed.
void close_cells(double placed_share, Stage& stage) {
    if (stage.needed.empty()) return;
    stage.placed_share = static_cast<float>(placed_share);
    double counted_area = 0.0;
    for (std::int64_t c = 0; c < stage.cell.size(); ++c) {
        if (stage.is_counted(c)) counted_area += double{stage.relative_area[c]};
        if (stage.is_open(c)) continue;
        stage.cell[c].groups = 0;
        stage.store_lowest(static_cast<std::int32_t>(c), no_candidate);
    }
    stage.counted_share = counted_area / stage.whole_area;
}

// Sorts the cells into tiles. The turn of a tile is given by the parities of its coordinates, which are the last bits
// of its code.
void find_tiles(const base::Array<std::uint64_t>& code, Stage& stage) {
    HRBFNPR_ASSERT(std::is_sorted(code.begin(), code.end()));
    const auto tile_of = [&](std::int64_t c) { return code[c] >> (3 * tile_bits); };
    for (std::size_t turn = 0; turn < 8; ++turn) {
        for (std::int64_t begin = 0, end = 0; begin < code.size(); begin = end) {
            while (end < code.size() && tile_of(end) == tile_of(begin)) ++end;
            if ((tile_of(begin) & 7U) == turn)
                stage.tile.push_back({static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end)});
        }
        stage.turn[turn + 1] = stage.tile.size();
    }
    stage.number = CellMap(stage.site.memory(), code);
    stage.neighbour.resize_for_overwrite(code.size());
    stage.lowest.resize(code.size());
    stage.floor.resize(code.size());
    const std::int64_t count = code.size();
    stage.site.work.for_chunks(count, cells_a_task, [&](auto begin, auto end) {
        CellMap::BlocksAround blocks;
        for (std::int64_t c = begin; c < end; ++c) stage.neighbour[c] = stage.number.around(code[c], blocks);
    });
}

// Puts the marks of earlier stages into cells. A mark outside all cells would have no effect, but `LastStageCells`
// prevents this.
void link_all(const base::Array<OrderMark>& marks, Stage& stage) {
    base::Array<std::int32_t> cell(stage.site.memory(), marks.size());
    stage.site.work.for_chunks(marks.size(), points_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) cell[i] = stage.cell_at(stage.code_at(vector(marks[i].position)));
    });
    for (const std::int64_t i : stage.site.work.over(marks.size())) {
        if (cell[i] >= 0 && !stage.link(marks[i], cell[i])) stage.link_more(marks[i], cell[i]);
    }
}

void add_energy_of_marks(Stage& stage) {
    stage.for_cells([&](std::int64_t c) {
        std::array<OrderMark, 64> near; // More marks than this are processed in several parts.
        std::size_t count = 0;
        const auto add_energy = [&] {
            stage.loops.add_energy[stage.creased](stage.block_of(c), near.data(), static_cast<std::int64_t>(count),
                                                  stage.inverse_squared_reach());
            count = 0;
        };
        for (const std::int32_t there : stage.neighbour[c]) {
            if (there < 0) continue;
            stage.for_marks(there, [&](const OrderMark& mark) {
                if (count == near.size()) add_energy();
                near[count++] = mark;
            });
        }
        add_energy();
    });
}

// ---- The way into a gap

constexpr int most_vertices = 6;
constexpr std::size_t none = static_cast<std::size_t>(-1);

double squared(const glm::dvec2& v) noexcept { return glm::dot(v, v); }

double signed_area(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) noexcept {
    const glm::dvec2 u = b - a;
    const glm::dvec2 v = c - a;
    return u.x * v.y - u.y * v.x;
}

// Returns the unit direction at p in which the distances to the nearest points a and b grow and stay equal. Without b,
// it is the direction away from a.
glm::dvec2 ascent_direction(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2* b) noexcept {
    if (b == nullptr) {
        const double length = glm::length(p - a);
        return length > 0.0 ? (p - a) / length : glm::dvec2(1.0, 0.0);
    }
    const glm::dvec2 across = glm::normalize(glm::dvec2(a.y - b->y, b->x - a.x));
    return glm::dot(across, p - 0.5 * (a + *b)) < 0.0 ? -across : across;
}

// The largest number of marks that are examined around a candidate. In a plane, about 20 marks fit within the relevant
// distance.
constexpr std::size_t most_around = 64;

// The marks around a candidate, relative to it.
struct NearbyMarks {
    glm::vec3 start, normal; // the position of the candidate, relative to the origin of the grid, and its unit normal
    float farthest;          // the squared distance beyond which marks are ignored
    geometry::TangentFrame frame;
    bool creased;      // true if the surface has creases
    bool bent = false; // true if a mark has a very different normal, but is not across a crease
    std::size_t count = 0;
    // The marks, turned into the tangent plane of the candidate. Their distances from the candidate are those in space
    // or, across a crease, those along both tangent planes.
    std::array<glm::dvec2, most_around> tangent_offset;
    std::array<glm::dvec3, most_around> offset;
    std::array<glm::dvec3, most_around>
        normal_beyond_crease; // for each mark: its normal if it is across a crease, else 0
};

// Returns the squared length of the path between two places with the unit normals n and m. o is the offset of the
// second place from the first. The path goes through both tangent planes and crosses the crease between the places.
[[nodiscard]] double squared_path(const glm::dvec3& o, const glm::dvec3& n, const glm::dvec3& m) noexcept {
    const double detour = -2.0 * glm::dot(o, n) * glm::dot(o, m) / std::max(1.0 + glm::dot(n, m), 0.1);
    return glm::dot(o, o) + std::max(detour, 0.0);
}

void add_nearby(const OrderMark& mark, NearbyMarks& around) noexcept {
    const glm::vec3 between = glm::vec3(mark.position[0], mark.position[1], mark.position[2]) - around.start;
    if (glm::dot(between, between) > around.farthest || around.count == most_around) return;
    float normal[3];
    unpack_normal(mark.normal, normal);
    const float turn =
        (around.normal.x * normal[0] + around.normal.y * normal[1] + around.normal.z * normal[2]) / unpacked_length;
    if (turn < least_side_cosine) return;
    const bool beyond = turn < stipple_tuning.bent_cosine && around.creased;
    around.bent = around.bent || (turn < stipple_tuning.bent_cosine && !beyond);
    const glm::dvec3 precise(between);
    const glm::dvec2 tangent(glm::dot(precise, around.frame.u), glm::dot(precise, around.frame.r));
    const double length = glm::length(tangent);
    const glm::dvec3 other = beyond ? glm::normalize(vector(normal)) : glm::dvec3(0.0);
    const double way =
        beyond ? std::sqrt(squared_path(precise, glm::dvec3(around.normal), other)) : glm::length(precise);
    around.tangent_offset[around.count] = length > 0.0 ? way / length * tangent : tangent;
    around.normal_beyond_crease[around.count] = other;
    around.offset[around.count++] = precise;
}

// Returns whether a place is at least the radius away from all marks, and on the candidate's side of all creases.
[[nodiscard]] bool is_free(const NearbyMarks& around, const glm::dvec2& way, const glm::dvec3& moved,
                           double radius) noexcept {
    for (std::size_t i = 0; i < around.count; ++i) {
        const glm::dvec3 between = around.offset[i];
        const glm::dvec3 other = around.normal_beyond_crease[i];
        const bool free = other == glm::dvec3(0.0)
                              ? glm::distance(between, moved) >= radius
                              : glm::distance(around.tangent_offset[i], way) >= radius &&
                                    (glm::dot(-between, other) < 0.0) == (glm::dot(moved - between, other) < 0.0);
        if (!free) return false;
    }
    return true;
}

// Moves a candidate into the middle of its gap, where it is at least `radius` away from all marks. If the gap is too
// small, sets `fresh.cell` to -1. `unlinked` has the marks without a slot in a cell.
void move_into_gap(const Stage& stage, const FreshMark* all, std::span<const std::int32_t> unlinked, double radius,
                   FreshMark& fresh) noexcept {
    const double farthest_move = stage.settings.farthest_move;
    const glm::dvec3 normal = glm::normalize(unpacked(fresh.mark.normal));
    const double far = radius + 2.0 * farthest_move;
    NearbyMarks around; // The arrays are filled only up to `count`.
    around.start = place_of(fresh.mark);
    around.normal = glm::vec3(normal);
    around.farthest = static_cast<float>(far * far);
    around.frame = geometry::combing_frame(normal);
    around.creased = stage.creased != 0;
    for (const std::int32_t k : unlinked) add_nearby(all[k].mark, around);
    stage.for_reached(around.start, far, fresh.cell, [&](std::int32_t there) {
        stage.for_marks(there, [&](const OrderMark& mark) { add_nearby(mark, around); });
    });
    fresh.cell = -1;
    if (around.bent) return; // The surface bends too much for the tangent plane.
    const glm::dvec2 way =
        toward_void({around.tangent_offset.data(), around.count}, stipple_tuning.gap_aim * radius, farthest_move);
    const glm::dvec3 moved = way.x * around.frame.u + way.y * around.frame.r;
    const glm::dvec3 end = glm::dvec3(around.start) + moved;
    if (!is_free(around, way, moved, radius) || !stage.region.contains(end)) return;
    const glm::vec3 p(end);
    for (int c = 0; c < 3; ++c) fresh.mark.position[c] = p[c];
    const std::uint64_t code = stage.code_at(end);
    if (stage.last_stage.cells.find(code >> static_cast<unsigned>(3 * stage.last_stage.level)) >= 0)
        fresh.cell = stage.cell_at(code);
}

// ---- A sweep over the tiles

// The least distance between marks in a step (the radius), and the energy below which candidates become marks.
struct SweepStep {
    double radius;
    float threshold;
};

// The largest number of steps in a sweep. Sweeps of large orders have this many.
constexpr std::size_t steps_of_sweep = 12;

// Prefetches everything that a mark in or near the cell will change, so that the loads overlap.
void prefetch_around(const Stage& stage, std::int32_t cell) noexcept {
    const CellMap::Around& neighbour = stage.neighbour[cell];
    for (const std::int32_t there : neighbour)
        if (there >= 0) base::prefetch(&stage.cell[there], 1);
    for (const std::int32_t there : neighbour)
        if (there >= 0) base::prefetch(stage.group + stage.cell[there].group, stage.cell[there].groups);
}

// Returns the cell's best candidate if it is at least `radius` away from all marks. Otherwise, returns a place in the
// candidate's gap that is.
[[nodiscard]] FreshMark place_best(Stage& stage, std::int32_t cell, const FreshMark* all,
                                   std::span<const std::int32_t> unlinked, double radius) noexcept {
    const std::int64_t i = stage.cell[cell].best;
    const OrderBlock block = stage.block_of(cell);
    HRBFNPR_ASSERT(i >= 0 && i < block.groups * OrderGroup::size);
    FreshMark fresh{};
    fresh.mark.position[0] = block.at(OrderGroup::x, i);
    fresh.mark.position[1] = block.at(OrderGroup::y, i);
    fresh.mark.position[2] = block.at(OrderGroup::z, i);
    fresh.energy = block.at(OrderGroup::energy, i);
    fresh.cell = cell;
    fresh.mark.normal = block.at(OrderGroup::normal, i);
    if (block.at(OrderGroup::clearance, i) < static_cast<float>(radius * radius))
        move_into_gap(stage, all, unlinked, radius, fresh);
    return fresh;
}

// Fills a tile, step by step. Returns the number of fresh marks.
[[nodiscard]] std::int32_t fill_tile(Stage& stage, const Tile& tile, std::span<const SweepStep> steps,
                                     FreshMark* fresh) {
    HRBFNPR_ASSERT(tile.begin >= 0 && tile.begin < tile.end && tile.end <= stage.cell.size());
    std::int32_t count = 0;
    std::size_t unlinked_count = 0;
    std::array<std::int32_t, most_fresh> unlinked; // the indices of fresh marks that have no slot in their cell
    for (std::size_t step = 0; step < steps.size(); ++step) {
        const auto [radius, threshold] = steps[step];
        const double nearness = stage.settings.move_clearance;
        const auto enough = static_cast<float>(nearness * nearness * radius * radius);
        // A smaller radius opens more candidates. A candidate that only a later step opens is found the next time that
        // its cell gets a mark.
        for (std::int32_t cell = tile.begin; step == 0 && cell < tile.end; ++cell)
            if (stage.floor[cell] < steps.back().threshold) stage.update_lowest(cell, enough);
        while (count < most_fresh) {
            const float* const lowest = stage.lowest.data() + tile.begin;
            const std::int64_t least = stage.loops.index_of_smallest(lowest, tile.end - tile.begin);
            if (least < 0 || !(lowest[least] < threshold)) break;
            const std::int32_t cell = tile.begin + static_cast<std::int32_t>(least);
            prefetch_around(stage, cell);
            FreshMark next = place_best(stage, cell, fresh, {unlinked.data(), unlinked_count}, radius);
            if (next.cell < 0) {
                float& clearance = stage.block_of(cell).at(OrderGroup::clearance, stage.cell[cell].best);
                clearance = std::min(clearance, stipple_tuning.retry_clearance * enough);
                stage.update_lowest(cell, enough);
                continue;
            }
            next.step = static_cast<std::uint8_t>(step);
            next.linked = stage.link(next.mark, next.cell);
            if (!next.linked) unlinked[unlinked_count++] = count;
            fresh[count++] = next;
            stage.for_reached(place_of(next.mark), stage.settings.reach, next.cell, [&](std::int32_t there) {
                stage.store_lowest(there, stage.loops.add_energy_and_find[stage.creased](
                                              stage.block_of(there), next.mark, stage.inverse_squared_reach(), enough));
            });
        }
    }
    return count;
}

// The marks of a sweep.
struct SweptMarks {
    explicit SweptMarks(base::Memory& memory) noexcept : energy(memory), is_counted(memory) {}

    base::Array<float> energy; // for each mark: its energy when it was placed
    base::Array<std::uint8_t> is_counted;
    std::int64_t counted = 0; // the number of marks that are counted
};

// Keeps only the `room` counted marks of the last sweep with the lowest energies, and the other marks with energies up
// to theirs.
void keep_lowest(const SweptMarks& swept, std::int64_t room, PlacementOrder& order) {
    const base::Array<float>& energy = swept.energy;
    HRBFNPR_ASSERT(room >= 0 && room < swept.counted && energy.size() <= order.mark.size());
    const std::int64_t first = order.mark.size() - energy.size();
    base::Array<float> sorted(energy.memory());
    for (std::int64_t i = 0; i < energy.size(); ++i)
        if (swept.is_counted[i] != 0) sorted.push_back(energy[i]);
    std::nth_element(sorted.begin(), sorted.begin() + room, sorted.end());
    const float limit = sorted[room];
    std::int64_t equal = room - std::count_if(sorted.begin(), sorted.end(), [&](float e) { return e < limit; });
    std::int64_t kept = first;
    for (std::int64_t i = 0; i < energy.size(); ++i)
        if (energy[i] < limit || (energy[i] == limit && swept.is_counted[i] != 0 && equal-- > 0)) {
            order.step[kept] = order.step[first + i];
            order.mark[kept++] = order.mark[first + i];
        }
    order.mark.resize(kept);
    order.step.resize(kept);
}

// Places marks that are at least the radius of a step away from all other marks, and have an energy below the threshold
// of the step. In each tile, marks with lower energies are placed first, and at most `most_fresh` marks are placed.
// Appends the marks tile by tile. If there are more than `room` counted marks, only those with the lowest energies are
// kept, and the stage ends. Returns the number of counted marks.
[[nodiscard]] std::int64_t sweep(std::span<const SweepStep> steps, std::int64_t room, Stage& stage,
                                 PlacementOrder& order) {
    HRBFNPR_ASSERT(!steps.empty() && room > 0 && order.mark.size() == order.step.size());
    order.sweep.push_back({order.mark.size(), order.whole});
    SweptMarks swept(stage.site.memory());
    const double nearest = stage.settings.move_clearance * steps.back().radius;
    stage.least_clearance = static_cast<float>(nearest * nearest);
    for (std::size_t turn = 0; turn < 8; ++turn) {
        const std::int64_t first = stage.turn[turn];
        const std::int64_t tiles = stage.turn[turn + 1] - first;
        stage.fresh.resize_for_overwrite(most_fresh * tiles);
        stage.fresh_count.resize_for_overwrite(tiles);
        stage.site.work.for_chunks(
            tiles, std::clamp<std::int64_t>(tiles / 32, 1, 16), [&](std::int64_t begin, std::int64_t end) {
                for (std::int64_t t = begin; t < end; ++t) {
                    stage.site.work.check();
                    stage.fresh_count[t] =
                        fill_tile(stage, stage.tile[first + t], steps, stage.fresh.data() + most_fresh * t);
                }
            });
        for (const std::int64_t t : stage.site.work.over(tiles)) {
            for (std::int32_t k = 0; k < stage.fresh_count[t]; ++k) {
                const FreshMark& fresh = stage.fresh[most_fresh * t + k];
                base::push_back_long(order.mark, fresh.mark, stage.site.work);
                base::push_back_long(order.step, fresh.step, stage.site.work);
                base::push_back_long(swept.energy, fresh.energy, stage.site.work);
                const bool counted = stage.is_counted(fresh.cell);
                swept.is_counted.push_back(counted ? 1 : 0);
                swept.counted += counted ? 1 : 0;
                if (!fresh.linked) stage.link_more(fresh.mark, fresh.cell);
            }
        }
    }
    if (swept.counted <= room) return swept.counted;
    keep_lowest(swept, room, order);
    return room;
}

// ---- Stage by stage

// Places marks until the whole order has `last` marks. Returns false if marks would have to be closer than `closest`,
// in distances of the densest packing.
bool place_until(Stage& stage, double area, std::int64_t last, std::int64_t wanted, double closest,
                 PlacementOrder& order, const base::Progress& progress) {
    double distance = stipple_tuning.kept_distance;
    float threshold = stipple_tuning.least_threshold;
    // True if the sweep may have missed candidates that only its later steps open, far from its new marks.
    bool missed = false;
    while (order.whole < static_cast<double>(last)) {
        progress.check();
        const double before = order.whole;
        close_cells(before / static_cast<double>(wanted), stage);
        if (!(stage.counted_share > 0.0)) {
            order.whole = static_cast<double>(last);
            break;
        }
        const bool nearly_full = before > stipple_tuning.nearly_full * static_cast<double>(last);
        const bool many = before >= stipple_tuning.marks_for_many_steps && !nearly_full;
        std::array<SweepStep, steps_of_sweep> steps;
        std::size_t count = many ? steps.size() : 1;
        double expected = before;
        for (std::size_t k = 0; k < count; ++k) {
            expected = std::min(static_cast<double>(last), stipple_tuning.step_growth * expected + (many ? 0.0 : 1.0));
            if (many) threshold *= stipple_tuning.threshold_growth;
            steps[k] = {distance * densest_distance(area, expected), threshold};
        }
        if (std::exchange(missed, false)) {
            steps[0] = steps[count - 1];
            count = 1;
        }
        const double room = std::ceil((static_cast<double>(last) - before) * stage.counted_share);
        const std::int64_t placed = sweep({steps.data(), count}, static_cast<std::int64_t>(room), stage, order);
        order.whole = std::min(before + static_cast<double>(placed) / stage.counted_share, static_cast<double>(last));
        const double after = order.whole;
        progress.update(after / static_cast<double>(wanted));
        if (after - before > stipple_tuning.poor_sweep * (expected - before)) {
            if (many) threshold *= static_cast<float>(std::pow(expected / after, stipple_tuning.threshold_power));
            continue;
        }
        // After this, the lowest energy of each cell is that of its candidates that keep the radius of the last step;
        // it is infinite without such candidates.
        stage.for_cells(
            [&](std::int64_t c) { stage.update_lowest(static_cast<std::int32_t>(c), stage.least_clearance); });
        const float lowest = *std::min_element(stage.lowest.begin(), stage.lowest.end());
        missed = after == before && lowest < threshold;
        if (std::isfinite(lowest))
            threshold = (nearly_full ? stipple_tuning.last_threshold_rise : stipple_tuning.threshold_rise) *
                        std::max(threshold, lowest);
        else if (after == before && (distance *= stipple_tuning.distance_factor) < closest)
            return false;
    }
    return true;
}

// Places marks in cells of the level `level`, until there are `last` marks. Returns false if no place is left.
bool run_stage(const marks::Site& site, Candidates& candidates, const LastStageCells& last_stage, std::int32_t level,
               std::int64_t last, std::int64_t wanted, PlacementOrder& order) {
    HRBFNPR_ASSERT(level >= last_stage.level);
    const double end = densest_distance(candidates.area, static_cast<double>(last));
    const double side = std::ldexp(candidates.grid.side, level);
    const double taken = OrderStages::candidates_of(last, candidates.whole);
    StageSettings settings;
    settings.level = level;
    settings.reach = std::min(side, stipple_tuning.energy_reach * end);
    settings.ticket_limit = static_cast<std::uint64_t>(taken / candidates.whole * 4294967296.0);
    settings.move_clearance = std::max(stipple_tuning.move_clearance, 1.0 - static_cast<double>(last) / taken);
    // A candidate moves at most into an adjacent cell, and at most as far as its tangent plane follows the surface.
    // While a stage has many candidates for each mark, gaps contain many candidates, so only those with a large
    // clearance are moved.
    settings.farthest_move = std::min(0.5 * (1.0 - stipple_tuning.kept_distance) * side,
                                      stipple_tuning.farthest_move * candidates.grid.side);
    for (const double least : {stipple_tuning.least_distance, 0.0}) {
        Stage stage(site, candidates, last_stage, settings);
        const CellsOfStage cells = find_cells(candidates, stage);
        find_tiles(cells.code, stage);
        find_shares(candidates, cells, stage);
        stage.placed_share = static_cast<float>(order.whole / static_cast<double>(wanted));
        take_candidates(candidates, cells, stage);
        link_all(order.mark, stage);
        add_energy_of_marks(stage);
        // As float positions, points closer than 1e-7 diagonals are equal.
        const double closest = std::max(least, 1e-7 * candidates.region.diagonal() / end);
        if (place_until(stage, candidates.area, last, wanted, closest, order, site.work)) return true;
    }
    return false;
}

// Returns the marks of each step in random order. They are stored tile by tile, but any part of a step should be spread
// like the whole step. The marks of a sweep stay consecutive.
[[nodiscard]] OrderedMarks shuffled(const marks::Site& site, const PlacementOrder& order, bool is_whole) {
    struct KeyedMark {
        std::uint64_t bits; // The top eight bits are the step. The others are random.
        std::int64_t mark;
        [[nodiscard]] bool operator<(const KeyedMark& other) const noexcept { return bits < other.bits; }
    };
    const std::int64_t count = order.mark.size();
    HRBFNPR_ASSERT(order.step.size() == count);
    base::Array<KeyedMark> keyed(site.memory());
    OrderedMarks sorted(site.memory());
    keyed.resize_for_overwrite(count);
    sorted.mark.resize_for_overwrite(count);
    sorted.whole = order.whole;
    if (!is_whole) sorted.place.resize_for_overwrite(count);
    site.work.for_each(order.sweep.size(), [&](std::int64_t sweep) {
        const std::int64_t begin = order.sweep[sweep].first;
        const bool is_last = sweep + 1 == order.sweep.size();
        const std::int64_t end = is_last ? count : order.sweep[sweep + 1].first;
        for (std::int64_t i = begin; i < end; ++i) {
            std::uint64_t bits = 0;
            for (const float c : order.mark[i].position)
                bits = geometry::hash_bits(bits ^ base::bit_cast<std::uint32_t>(c));
            keyed[i] = {std::uint64_t{order.step[i]} << 56U | bits >> 8U, i};
        }
        std::sort(keyed.data() + begin, keyed.data() + end);
        for (std::int64_t i = begin; i < end; ++i) sorted.mark[i] = order.mark[keyed[i].mark];
        if (is_whole) return;
        const double before = order.sweep[sweep].before;
        const double after = is_last ? order.whole : order.sweep[sweep + 1].before;
        for (std::int64_t i = begin; i < end; ++i)
            sorted.place[i] =
                std::lerp(before, after, (static_cast<double>(i - begin) + 0.5) / static_cast<double>(end - begin));
    });
    return sorted;
}

} // namespace

glm::dvec2 toward_void(std::span<const glm::dvec2> around, double wanted, double farthest) noexcept {
    HRBFNPR_ASSERT(wanted > 0.0 && farthest >= 0.0);
    if (around.empty()) return glm::dvec2(0.0);
    glm::dvec2 at{0.0};
    const auto nearest = std::min_element(
        around.begin(), around.end(), [](const glm::dvec2& a, const glm::dvec2& b) { return squared(a) < squared(b); });
    std::array<std::size_t, 2> edge{static_cast<std::size_t>(nearest - around.begin()), none};
    for (int vertex = 0; vertex < most_vertices; ++vertex) {
        const glm::dvec2 a = around[edge[0]];
        const glm::dvec2 direction = ascent_direction(at, a, edge[1] == none ? nullptr : &around[edge[1]]);
        // The length t of the move after which the nearest point a is `wanted` away: |at + t d - a| = wanted.
        const double along = glm::dot(at - a, direction);
        const double own = squared(at - a);
        const double missing = wanted * wanted - own;
        const double enough = missing > 0.0 ? std::sqrt(along * along + missing) - along : 0.0;
        // The length t of the move after which another point q is as near as a: |at + t d - q| = |at + t d - a|.
        double distance = 2.0 * farthest;
        std::size_t third = none;
        for (std::size_t i = 0; i < around.size(); ++i) {
            if (i == edge[0] || i == edge[1]) continue;
            const double approach = 2.0 * glm::dot(direction, around[i] - a);
            if (!(approach > 1e-12 * wanted)) continue;
            const double there = std::max(0.0, (squared(at - around[i]) - own) / approach);
            if (there < distance) {
                distance = there;
                third = i;
            }
        }
        at += std::min(enough, distance) * direction;
        if (enough <= distance || third == none) break;
        if (edge[1] == none) {
            edge[1] = third;
            continue;
        }
        // Three points are equally near. If they surround the place, this is a maximum. Otherwise, the move continues
        // across the edge of their triangle that separates the place from the triangle.
        const glm::dvec2 b = around[edge[1]];
        const glm::dvec2 c = around[third];
        const double all = signed_area(a, b, c);
        if (signed_area(b, c, at) * all < 0.0)
            edge = {edge[1], third};
        else if (signed_area(c, a, at) * all < 0.0)
            edge[1] = third;
        else
            break;
    }
    return squared(at) <= farthest * farthest ? at : glm::dvec2(0.0);
}

OrderedMarks progressive_order(const marks::Site& site, Candidates& candidates, std::int64_t wanted) {
    if (candidates.count == 0 || wanted <= 0) return OrderedMarks(site.memory());
    PlacementOrder order(site.memory());
    const OrderStages stages{candidates.area, candidates.grid.side, wanted};
    LastStageCells last_stage{stages.last_level(), CellMap(site.memory())};
    base::Array<std::uint64_t> codes(site.memory());
    for (const std::uint64_t code : candidates.code) {
        const std::uint64_t here = code >> static_cast<unsigned>(3 * last_stage.level);
        if (codes.empty() || codes.back() != here) codes.push_back(here);
    }
    last_stage.cells = CellMap(site.memory(), codes);
    bool has_room = true;
    for (std::int32_t level = stages.first_level(); has_room && level > last_stage.level; --level) {
        const std::int64_t last = stages.marks_at_end(level);
        if (static_cast<double>(last) > order.whole)
            has_room = run_stage(site, candidates, last_stage, level, last, wanted, order);
    }
    run_stage(site, candidates, last_stage, last_stage.level, wanted, wanted, order);
    OrderedMarks sorted = shuffled(site, order, candidates.share.empty());
    // Cells that are partly needed may have got a few marks more than the whole order has there.
    const std::int64_t kept = std::min(sorted.size(), wanted);
    sorted.mark.resize(kept);
    if (!sorted.place.empty()) sorted.place.resize(kept);
    return sorted;
}

} // namespace hrbfnpr::stipples
