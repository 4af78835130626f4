#include "sampling/order_stage.h"

#include "base/prefetch.h"
#include "geometry/morton.h"
#include "geometry/tangent_frame.h"
#include "sampling/void_centre.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <utility>

namespace hrbfnpr::sampling {
namespace {

constexpr float infinite = std::numeric_limits<float>::infinity();
constexpr std::int64_t cells_of_task = 512;
constexpr unsigned tile_bits = 3; // of each coordinate
// A candidate whose gap was too small is tried again at this part of the squared radius.
constexpr float again = 0.97F;
// Cosine of the angle between normals of marks between which a surface is flat enough to move on.
constexpr double straight = 0.7;
// Marks around a candidate that are looked at; a plane has room for about 20 within the distance that counts.
constexpr std::size_t most_around = 64;

std::uint64_t code_of(const geometry::CellGrid& grid, const glm::dvec3& position) noexcept {
    return geometry::morton_code(grid.cell_of(grid.origin + position));
}

glm::dvec3 vector(const float (&v)[3]) noexcept { return {v[0], v[1], v[2]}; }
glm::vec3 place_of(const OrderMark& mark) noexcept { return {mark.position[0], mark.position[1], mark.position[2]}; }

// One of the 27 around and including a cell.
geometry::CellGrid::Cell stepped(const geometry::CellGrid::Cell& cell, std::int64_t step) noexcept {
    return {cell[0] + step % 3 - 1, cell[1] + step / 3 % 3 - 1, cell[2] + step / 9 - 1};
}

// Which of the 27 around a cell have a point that is nearer than that to one of the cell's.
std::uint32_t reached(const glm::vec3& in_cell, float side, float distance) noexcept {
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

} // namespace

OrderStage::OrderStage(const Site& site, const Candidates& candidates, const geometry::CellMap& home,
                       std::int32_t home_level, const StageSettings& settings, const OrderedMarks& marks)
    : site_(site),
      grid_(candidates.grid), region_{candidates.region.min - grid_.origin, candidates.region.max - grid_.origin},
      home_(home), home_level_(home_level), settings_(settings),
      side_(static_cast<float>(std::ldexp(grid_.side, settings.level))),
      loops_(order_loops(site.runtime.instruction_set)), code_(site.memory()), number_(site.memory()),
      cell_(site.memory()), neighbour_(site.memory()), lowest_(site.memory()), floor_(site.memory()),
      block_(site.memory()), extra_(site.memory()), tile_(site.memory()), fresh_(site.memory()),
      fresh_count_(site.memory()), energy_(site.memory()), step_(site.memory()) {
    take_candidates(candidates);
    find_tiles();
    for (const OrderMark& mark : marks) link(mark, cell_at(vector(mark.position)));
    feel_all();
}

glm::vec3 OrderStage::low_corner(std::uint64_t code) const noexcept {
    const geometry::CellGrid::Cell at = geometry::morton_cell(code);
    return side_ * glm::vec3(static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2]));
}

void OrderStage::take_candidates(const Candidates& candidates) {
    base::Array<std::int64_t> part(site_.memory()); // of each cell: the candidates' first cell in it
    for (std::int64_t c = 0; c < candidates.cells(); ++c) {
        const std::uint64_t here = candidates.code[c] >> static_cast<unsigned>(3 * settings_.level);
        if (!code_.empty() && code_.back() == here) continue;
        code_.push_back(here);
        cell_.push_back({0, 0, 0, -1, 0, -1, 0, low_corner(here), {}});
        part.push_back(c);
    }
    part.push_back(candidates.cells());
    const auto begin_of = [&](std::int64_t c) { return candidates.first[part[c]]; };
    const auto taken = [&](std::int64_t i) { return candidates.ticket[i] < settings_.ticket_limit; };
    const auto for_cells = [&](auto&& visit) {
        site_.runtime.parallel.for_chunks(cell_.size(), 8 * cells_of_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t c = begin; c < end; ++c) visit(c);
        });
    };
    for_cells([&](std::int64_t c) {
        for (std::int64_t i = begin_of(c); i < begin_of(c + 1); ++i) cell_[c].count += taken(i) ? 1 : 0;
    });
    std::int64_t numbers = 0;
    for (Cell& cell : cell_) {
        cell.block = numbers;
        cell.stride = cell.count;
        numbers += OrderBlock::columns * cell.count;
    }
    block_.resize(numbers);
    for_cells([&](std::int64_t c) {
        const OrderBlock block = block_of(cell_[c]);
        std::int64_t k = 0;
        for (std::int64_t i = begin_of(c); i < begin_of(c + 1); ++i) {
            if (!taken(i)) continue;
            block.column(OrderBlock::x)[k] = candidates.x[i];
            block.column(OrderBlock::y)[k] = candidates.y[i];
            block.column(OrderBlock::z)[k] = candidates.z[i];
            block.column(OrderBlock::normal)[k] = candidates.normal[i];
            block.column(OrderBlock::clearance)[k++] = infinite;
        }
    });
}

// A tile's turn is the parity of its coordinates, the last bits of its code.
void OrderStage::find_tiles() {
    const auto tile_of = [&](std::int64_t c) { return code_[c] >> (3 * tile_bits); };
    for (std::size_t turn = 0; turn < 8; ++turn) {
        for (std::int64_t begin = 0, end = 0; begin < code_.size(); begin = end) {
            while (end < code_.size() && tile_of(end) == tile_of(begin)) ++end;
            if ((tile_of(begin) & 7U) == turn)
                tile_.push_back({static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end)});
        }
        turn_[turn + 1] = tile_.size();
    }
    number_ = geometry::CellMap(site_.memory(), code_);
    neighbour_.resize(code_.size());
    lowest_.resize(code_.size());
    floor_.resize(code_.size());
    site_.runtime.parallel.for_chunks(tile_.size(), 16, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t t = begin; t < end; ++t) find_neighbours(tile_[t]);
    });
}

// The neighbours of a block's cells are in the 27 blocks of the map around it.
void OrderStage::find_neighbours(const Tile& tile) noexcept {
    constexpr std::uint64_t cells_of_block = geometry::CellMap::cells_of_block;
    std::array<const std::int32_t*, 27> block{};
    for (std::int32_t c = tile.begin; c < tile.end; ++c) {
        if (c == tile.begin || code_[c] / cells_of_block != code_[c - 1] / cells_of_block) {
            const geometry::CellGrid::Cell place = geometry::morton_cell(code_[c] / cells_of_block);
            for (std::int64_t step = 0; step < 27; ++step) {
                const geometry::CellGrid::Cell there = stepped(place, step);
                block[static_cast<std::size_t>(step)] =
                    geometry::CellGrid::inside(there) ? number_.find_block(geometry::morton_code(there)) : nullptr;
            }
        }
        const geometry::CellGrid::Cell at = geometry::morton_cell(code_[c] % cells_of_block);
        for (std::int64_t step = 0; step < 27; ++step) {
            const geometry::CellGrid::Cell there = stepped({at[0] + 4, at[1] + 4, at[2] + 4}, step);
            const std::int32_t* const numbers =
                block[static_cast<std::size_t>(there[0] / 4 + 3 * (there[1] / 4) + 9 * (there[2] / 4))];
            const std::int32_t number =
                numbers == nullptr ? -1 : numbers[geometry::morton_code({there[0] % 4, there[1] % 4, there[2] % 4})];
            neighbour_[c][static_cast<std::size_t>(step)] = number;
            if (number >= 0) cell_[c].neighbour |= 1U << static_cast<unsigned>(step);
        }
    }
}

OrderStage::Slot OrderStage::slot_of(const OrderMark& mark) noexcept {
    return {{mark.position[0], mark.position[1], mark.position[2]}, repacked_normal(mark.normal)};
}

// A mark outside all cells of the stage is felt by none: home cells see to it that there are none.
void OrderStage::link(const OrderMark& mark, std::int32_t cell) {
    if (cell < 0) return;
    Cell& c = cell_[cell];
    const Slot slot = slot_of(mark);
    if (c.marks < slots_of_cell) {
        c.slot[static_cast<std::size_t>(c.marks++)] = slot;
        return;
    }
    extra_.push_back({slot, c.more});
    c.more = static_cast<std::int32_t>(extra_.size() - 1);
}

template <class Visit>
void OrderStage::for_marks(const Cell& cell, Visit&& visit) const {
    for (std::int32_t k = 0; k < cell.marks; ++k) visit(cell.slot[static_cast<std::size_t>(k)]);
    for (std::int32_t at = cell.more; at >= 0; at = extra_[at].next) visit(extra_[at].mark);
}

std::int32_t OrderStage::cell_at(const glm::dvec3& position) const noexcept {
    return number_.find(code_of(grid_, position) >> static_cast<unsigned>(3 * settings_.level));
}

// The cell of a place near `cell`; -1 if that is no home.
std::int32_t OrderStage::home_cell_at(const glm::dvec3& position, std::int32_t cell) const noexcept {
    const std::uint64_t code = code_of(grid_, position);
    const std::uint64_t here = code >> static_cast<unsigned>(3 * settings_.level);
    if (settings_.level == home_level_) return here == code_[cell] ? cell : number_.find(here);
    return home_.find(code >> static_cast<unsigned>(3 * home_level_)) < 0 ? -1 : number_.find(here);
}

// Calls visit on the cells that have a point nearer than that to one in `cell`.
template <class Visit>
void OrderStage::for_reached(const glm::vec3& position, double distance, std::int32_t cell, Visit&& visit) const {
    const Cell& c = cell_[cell];
    std::uint32_t left = c.neighbour & reached(position - c.low, side_, static_cast<float>(distance));
    for (; left != 0; left &= left - 1) visit(neighbour_[cell][static_cast<std::size_t>(std::countr_zero(left))]);
}

void OrderStage::feel_all() {
    site_.runtime.parallel.for_chunks(cell_.size(), cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t c = begin; c < end; ++c)
            for (const std::int32_t there : neighbour_[c]) {
                if (there < 0) continue;
                for_marks(cell_[there], [&](const Slot& slot) {
                    OrderMark mark{{slot.position[0], slot.position[1], slot.position[2]}, {}};
                    unpack_normal(slot.normal, mark.normal);
                    loops_.feel(block_of(cell_[c]), mark, inverse_squared_reach());
                });
            }
    });
}

void OrderStage::note(std::int32_t cell, const OrderLowest& found) noexcept {
    cell_[cell].best = static_cast<std::int32_t>(found.at);
    lowest_[cell] = found.energy;
    floor_[cell] = found.of_all;
}

void OrderStage::drop_nearer(double distance) {
    const auto enough = static_cast<float>(distance * distance);
    site_.runtime.parallel.for_chunks(cell_.size(), 8 * cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t c = begin; c < end; ++c) {
            cell_[c].count = cell_[c].stride = static_cast<std::int32_t>(loops_.keep(block_of(cell_[c]), enough));
            floor_[c] = 0.0F; // so that the best one is found again
        }
    });
}

float OrderStage::lowest() noexcept {
    site_.runtime.parallel.for_chunks(cell_.size(), 8 * cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t c = begin; c < end; ++c) refresh(static_cast<std::int32_t>(c), enough_);
    });
    return *std::min_element(lowest_.begin(), lowest_.end());
}

// A tile's turn.
class OrderStage::Turn {
public:
    Turn(OrderStage& stage, Fresh* fresh) noexcept : stage_(stage), fresh_(fresh) {}

    // Before a tile's turn comes, what its first marks will change is brought from memory, in three steps: each needs
    // what the one before asked for.
    static constexpr std::int64_t steps_ahead = 3;
    static void bring(const OrderStage& stage, const Tile& tile, std::int64_t ahead, float threshold) noexcept {
        for (std::int32_t cell = tile.begin; cell < tile.end; ++cell) {
            if (!(stage.lowest_[cell] < threshold)) continue;
            const Cell& c = stage.cell_[cell];
            if (ahead == 3) {
                base::prefetch(&c, 1);
                base::prefetch(&stage.neighbour_[cell], 1);
                continue;
            }
            for (std::uint32_t left = c.neighbour; left != 0; left &= left - 1) {
                const Cell& near =
                    stage.cell_[stage.neighbour_[cell][static_cast<std::size_t>(std::countr_zero(left))]];
                if (ahead == 2)
                    base::prefetch(&near, 1);
                else
                    base::prefetch(stage.block_.data() + near.block, OrderBlock::columns * near.stride);
            }
        }
    }

    // Returns the number of fresh marks.
    std::int32_t run(const Tile& tile, std::span<const SweepStep> steps) {
        for (std::size_t step = 0; step < steps.size(); ++step) {
            radius_ = steps[step].radius;
            enough_ = static_cast<float>(stage_.settings_.nearness * stage_.settings_.nearness * radius_ * radius_);
            step_ = static_cast<std::uint8_t>(step);
            // Smaller radii open more candidates.  Those of later steps are found when their cells are next felt.
            for (std::int32_t cell = tile.begin; step == 0 && cell < tile.end; ++cell)
                if (stage_.floor_[cell] < steps.back().threshold) stage_.refresh(cell, enough_);
            fill(tile, steps[step].threshold);
        }
        return count_;
    }

private:
    void fill(const Tile& tile, float threshold) {
        const float* const lowest = stage_.lowest_.data() + tile.begin;
        while (count_ < most_fresh) {
            const std::int64_t least = stage_.loops_.smallest(lowest, tile.end - tile.begin);
            if (least < 0 || !(lowest[least] < threshold)) break;
            take(tile.begin + static_cast<std::int32_t>(least));
        }
    }

    void take(std::int32_t cell) {
        const Fresh fresh = place(cell);
        if (fresh.cell < 0) {
            float& clearance =
                stage_.block_of(stage_.cell_[cell]).column(OrderBlock::clearance)[stage_.cell_[cell].best];
            clearance = std::min(clearance, again * enough_);
            stage_.refresh(cell, enough_);
            return;
        }
        fresh_[count_++] = fresh;
        stage_.for_reached(place_of(fresh.mark), stage_.settings_.reach, fresh.cell, [&](std::int32_t there) {
            stage_.note(there, stage_.loops_.feel_and_find(stage_.block_of(stage_.cell_[there]), fresh.mark,
                                                           stage_.inverse_squared_reach(), enough_));
        });
    }

    // The cell's best candidate itself if it keeps the distance, else a place in its gap that does.
    [[nodiscard]] Fresh place(std::int32_t cell) {
        const std::int64_t i = stage_.cell_[cell].best;
        const OrderBlock block = stage_.block_of(stage_.cell_[cell]);
        Fresh fresh{};
        fresh.mark.position[0] = block.column(OrderBlock::x)[i];
        fresh.mark.position[1] = block.column(OrderBlock::y)[i];
        fresh.mark.position[2] = block.column(OrderBlock::z)[i];
        fresh.energy = block.column(OrderBlock::energy)[i];
        fresh.cell = cell;
        fresh.step = step_;
        unpack_normal(block.column(OrderBlock::normal)[i], fresh.mark.normal);
        if (block.column(OrderBlock::clearance)[i] < static_cast<float>(radius_ * radius_)) move(fresh);
        return fresh;
    }

    void look_at(const Slot& mark, const glm::dvec3& start, const geometry::TangentFrame& frame,
                 const glm::dvec3& normal, double far) noexcept {
        const glm::dvec3 between = vector(mark.position) - start;
        if (around_ == most_around || glm::dot(between, between) > far * far) return;
        float unpacked[3];
        unpack_normal(mark.normal, unpacked);
        const double turn = glm::dot(normal, vector(unpacked)) / double{unpacked_length};
        if (turn < double{opposite}) return;
        bent_ = bent_ || turn < straight;
        const glm::dvec2 tangent(glm::dot(between, frame.u), glm::dot(between, frame.r));
        const double length = glm::length(tangent);
        flat_[around_] = length > 0.0 ? glm::length(between) / length * tangent : tangent;
        between_[around_++] = between;
    }

    // In the tangent plane, where the distances from the candidate are taken as long as those in space.
    void move(Fresh& fresh) noexcept {
        const glm::dvec3 start = vector(fresh.mark.position);
        const glm::dvec3 normal = glm::normalize(vector(fresh.mark.normal));
        const geometry::TangentFrame frame = geometry::combing_frame(normal);
        const double far = radius_ + 2.0 * stage_.settings_.farthest_move;
        around_ = 0;
        bent_ = false;
        for (std::int32_t k = 0; k < count_; ++k) look_at(slot_of(fresh_[k].mark), start, frame, normal, far);
        stage_.for_reached(place_of(fresh.mark), far, fresh.cell, [&](std::int32_t there) {
            stage_.for_marks(stage_.cell_[there], [&](const Slot& mark) { look_at(mark, start, frame, normal, far); });
        });
        const glm::dvec2 way = toward_void({flat_.data(), around_}, 1.02 * radius_, stage_.settings_.farthest_move);
        settle(fresh, start, way.x * frame.u + way.y * frame.r);
    }

    void settle(Fresh& fresh, const glm::dvec3& start, const glm::dvec3& moved) noexcept {
        const std::int32_t cell = std::exchange(fresh.cell, -1);
        if (bent_) return; // a tangent plane is no way along it
        for (std::size_t i = 0; i < around_; ++i)
            if (glm::distance(between_[i], moved) < radius_) return;
        const glm::dvec3 end = start + moved;
        if (!stage_.region_.contains(end)) return;
        const glm::vec3 p(end);
        for (int c = 0; c < 3; ++c) fresh.mark.position[c] = p[c];
        fresh.cell = stage_.home_cell_at(end, cell);
    }

    OrderStage& stage_;
    Fresh* fresh_;
    std::int32_t count_ = 0;
    double radius_ = 0.0;
    float enough_ = 0.0F; // squared distance from marks that makes a candidate open
    std::uint8_t step_ = 0;
    // Marks around a candidate, as seen from it.
    std::size_t around_ = 0;
    bool bent_ = false; // some have another normal
    std::array<glm::dvec2, most_around> flat_;
    std::array<glm::dvec3, most_around> between_;
};

void OrderStage::sweep(std::span<const SweepStep> steps, std::int64_t room, OrderedMarks& marks) {
    step_.clear();
    energy_.clear();
    const double nearest = settings_.nearness * steps.back().radius;
    enough_ = static_cast<float>(nearest * nearest);
    for (std::size_t turn = 0; turn < 8; ++turn) {
        const std::int64_t first = turn_[turn];
        const std::int64_t tiles = turn_[turn + 1] - first;
        fresh_.resize(most_fresh * tiles);
        fresh_count_.resize(tiles);
        site_.runtime.parallel.for_chunks(tiles, 16, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t t = begin; t < end; ++t) {
                for (std::int64_t ahead = 1; ahead <= Turn::steps_ahead && t + ahead < end; ++ahead)
                    Turn::bring(*this, tile_[first + t + ahead], ahead, steps.back().threshold);
                fresh_count_[t] = Turn(*this, fresh_.data() + most_fresh * t).run(tile_[first + t], steps);
            }
        });
        for (std::int64_t t = 0; t < tiles; ++t)
            for (std::int32_t k = 0; k < fresh_count_[t]; ++k) append(fresh_[most_fresh * t + k], marks);
    }
    if (energy_.size() > room) keep_lowest(room, marks);
}

void OrderStage::append(const Fresh& fresh, OrderedMarks& marks) {
    marks.push_back(fresh.mark);
    link(fresh.mark, fresh.cell);
    energy_.push_back(fresh.energy);
    step_.push_back(fresh.step);
}

void OrderStage::keep_lowest(std::int64_t room, OrderedMarks& marks) {
    const std::int64_t first = marks.size() - energy_.size();
    base::Array<float> sorted(site_.memory(), energy_.size());
    std::copy(energy_.begin(), energy_.end(), sorted.begin());
    std::nth_element(sorted.begin(), sorted.begin() + room, sorted.end());
    const float limit = sorted[room];
    const auto below = std::count_if(energy_.begin(), energy_.end(), [&](float e) { return e < limit; });
    std::int64_t equal = room - below;
    std::int64_t kept = first;
    for (std::int64_t i = 0; i < energy_.size(); ++i)
        if (energy_[i] < limit || (energy_[i] == limit && equal-- > 0)) {
            step_[kept - first] = step_[i];
            marks[kept++] = marks[first + i];
        }
    marks.resize(kept);
    step_.resize(kept - first);
}

} // namespace hrbfnpr::sampling
