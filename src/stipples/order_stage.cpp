// SPDX-License-Identifier: MIT
#include "stipples/order_stage_impl.h"

#include "base/long_array.h"
#include "base/prefetch.h"
#include "geometry/morton.h"
#include "geometry/tangent_frame.h"
#include "stipples/cell_neighbours.h"
#include "stipples/order_places.h"
#include "stipples/void_centre.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace hrbfnpr::stipples {
namespace {

constexpr std::int64_t ordered_cells_of_task = 512;
constexpr std::uint64_t most_tickets = 0xffffffff;
constexpr unsigned tile_bits = 3; // of each coordinate
// A candidate whose gap was too small is tried again at this part of the squared radius.
constexpr float again = 0.97F;
// Cosine of the angle between normals of marks between which a surface is flat enough to move on.
constexpr float straight_stage = 0.7F;
// Marks around a candidate that are looked at; a plane has room for about 20 within the distance that counts.
constexpr std::size_t most_around = 64;

std::uint64_t code_of(const geometry::CellGrid& grid, const glm::dvec3& position) noexcept {
    return geometry::morton_code(grid.cell_of(grid.origin + position));
}

glm::dvec3 vector(const float (&v)[3]) noexcept { return {v[0], v[1], v[2]}; }
glm::vec3 place_of(const OrderMark& mark) noexcept { return {mark.position[0], mark.position[1], mark.position[2]}; }

} // namespace

OrderStage::Impl::Impl(const marks::Site& site, Candidates& candidates, const CellMap& home, std::int32_t home_level,
                       const StageSettings& settings, const OrderedMarks& marks, const base::Progress& progress)
    : site_(site),
      grid_(candidates.grid), region_{candidates.region.min - grid_.origin, candidates.region.max - grid_.origin},
      home_(home), home_level_(home_level), settings_(settings), progress_(progress),
      side_(static_cast<float>(std::ldexp(grid_.side, settings.level))), loops_(loops_for(site)), code_(site.memory()),
      number_(site.memory()), cell_(site.memory()), neighbour_(site.memory()), lowest_(site.memory()),
      floor_(site.memory()), group_(site.memory()), extra_(site.memory()), tile_(site.memory()), fresh_(site.memory()),
      fresh_count_(site.memory()), energy_(site.memory()), step_(site.memory()) {
    take_candidates(candidates);
    find_tiles();
    link_all(marks);
    feel_all();
}

glm::vec3 OrderStage::Impl::low_corner(std::uint64_t code) const noexcept {
    const geometry::CellGrid::Cell at = geometry::morton_cell(code);
    return side_ * glm::vec3(static_cast<float>(at[0]), static_cast<float>(at[1]), static_cast<float>(at[2]));
}

void OrderStage::Impl::take_candidates(Candidates& candidates) {
    base::Array<std::int64_t> part(site_.memory()); // of each cell: the candidates' first cell in it
    for (std::int64_t c = 0; c < candidates.cells(); ++c) {
        const std::uint64_t here = candidates.code[c] >> static_cast<unsigned>(3 * settings_.level);
        if (!code_.empty() && code_.back() == here) continue;
        code_.push_back(here);
        part.push_back(c);
    }
    part.push_back(candidates.cells());
    cell_.resize_for_overwrite(code_.size());
    if (settings_.level == 0 && settings_.ticket_limit > most_tickets)
        work_in(candidates);
    else
        copy_taken(candidates, part);
}

// All of them take part, in the same cells.
void OrderStage::Impl::work_in(Candidates& candidates) {
    groups_ = candidates.group.data();
    site_.runtime.parallel.for_chunks(cell_.size(), ordered_cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        progress_.check();
        for (std::int64_t c = begin; c < end; ++c) {
            cell_[c] = empty_cell(candidates.first[c] / OrderGroup::size, groups_for(candidates.number[c]), code_[c]);
            forget_marks(block_of(cell_[c]), candidates.number[c]);
        }
    });
}

void OrderStage::Impl::copy_taken(Candidates& candidates, const base::Array<std::int64_t>& part) {
    // A few large cells have as many candidates as many small ones.
    const std::int64_t grain = std::clamp<std::int64_t>(cell_.size() / 64, 1, 8 * ordered_cells_of_task);
    const auto for_taken = [&](std::int64_t cell, auto&& visit) {
        for (std::int64_t from = part[cell]; from < part[cell + 1]; ++from)
            candidates.for_taken(from, settings_.ticket_limit, visit);
    };
    base::Array<std::int64_t> task_begin(site_.memory(), (cell_.size() + grain - 1) / grain + 1); // in group_
    site_.runtime.parallel.for_chunks(cell_.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        progress_.check();
        std::int64_t groups = 0;
        for (std::int64_t c = begin; c < end; ++c) {
            std::int64_t count = 0;
            for_taken(c, [&](std::int64_t) { ++count; });
            cell_[c] = empty_cell(groups, groups_for(count), code_[c]);
            groups += groups_for(count);
        }
        task_begin[begin / grain + 1] = groups;
    });
    std::partial_sum(task_begin.begin(), task_begin.end(), task_begin.begin());
    group_.resize_for_overwrite(task_begin.back());
    groups_ = group_.data();
    site_.runtime.parallel.for_chunks(cell_.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t c = begin; c < end; ++c) {
            progress_.check();
            cell_[c].group += task_begin[begin / grain];
            const OrderBlock block = block_of(cell_[c]);
            std::int64_t count = 0;
            for_taken(c, [&](std::int64_t place) { copy_place(candidates.places(), place, block, count++); });
            clear_rest(block, count);
            forget_marks(block, count);
        }
    });
}

OrderStage::Impl::Cell OrderStage::Impl::empty_cell(std::int64_t group, std::int64_t groups,
                                                    std::uint64_t code) const noexcept {
    return {group, static_cast<std::int32_t>(groups), -1, 0, -1, 0, low_corner(code), {}};
}

// A tile's turn is the parity of its coordinates, the last bits of its code.
void OrderStage::Impl::find_tiles() {
    const auto tile_of = [&](std::int64_t c) { return code_[c] >> (3 * tile_bits); };
    for (std::size_t turn = 0; turn < 8; ++turn) {
        for (std::int64_t begin = 0, end = 0; begin < code_.size(); begin = end) {
            while (end < code_.size() && tile_of(end) == tile_of(begin)) ++end;
            if ((tile_of(begin) & 7U) == turn)
                tile_.push_back({static_cast<std::int32_t>(begin), static_cast<std::int32_t>(end)});
        }
        turn_[turn + 1] = tile_.size();
    }
    number_ = CellMap(site_.memory(), code_);
    neighbour_.resize_for_overwrite(code_.size());
    lowest_.resize(code_.size());
    floor_.resize(code_.size());
    site_.runtime.parallel.for_chunks(cell_.size(), ordered_cells_of_task, progress_,
                                      [&](std::int64_t begin, std::int64_t end) { find_neighbours(begin, end); });
}

void OrderStage::Impl::find_neighbours(std::int64_t begin, std::int64_t end) noexcept {
    CellNeighbours around(number_);
    for (std::int64_t c = begin; c < end; ++c) {
        around.go_to(code_[c]);
        std::uint32_t found = 0;
        for (std::size_t step = 0; step < CellNeighbours::count; ++step) {
            const std::int32_t number = around[step];
            neighbour_[c][step] = number;
            found |= number >= 0 ? 1U << step : 0U;
        }
        cell_[c].neighbour = found;
    }
}

OrderStage::Impl::Slot OrderStage::Impl::slot_of(const OrderMark& mark) noexcept {
    return {{mark.position[0], mark.position[1], mark.position[2]}, repacked_normal(mark.normal)};
}

bool OrderStage::Impl::link(const OrderMark& mark, std::int32_t cell) noexcept {
    Cell& c = cell_[cell];
    if (c.marks == slots_of_cell) return false;
    c.slot[static_cast<std::size_t>(c.marks++)] = slot_of(mark);
    return true;
}

void OrderStage::Impl::link_more(const OrderMark& mark, std::int32_t cell) {
    extra_.push_back({slot_of(mark), cell_[cell].more});
    cell_[cell].more = static_cast<std::int32_t>(extra_.size() - 1);
}

// A mark outside all cells of the stage is felt by none: home cells see to it that there are none.
void OrderStage::Impl::link_all(const OrderedMarks& marks) {
    base::Array<std::int32_t> cell(site_.memory(), marks.size());
    site_.runtime.parallel.for_chunks(marks.size(), 8 * ordered_cells_of_task, progress_,
                                      [&](std::int64_t begin, std::int64_t end) {
                                          for (std::int64_t i = begin; i < end; ++i)
                                              cell[i] = cell_at(vector(marks[i].position));
                                      });
    constexpr std::int64_t ahead = 16;
    for (std::int64_t i = 0; i < marks.size(); ++i) {
        if (i % 16384 == 0) progress_.check();
        if (i + ahead < marks.size() && cell[i + ahead] >= 0) base::prefetch(&cell_[cell[i + ahead]], 1);
        if (cell[i] >= 0 && !link(marks[i], cell[i])) link_more(marks[i], cell[i]);
    }
}

template <class Visit>
void OrderStage::Impl::for_marks(const Cell& cell, Visit&& visit) const {
    for (std::int32_t k = 0; k < cell.marks; ++k) visit(cell.slot[static_cast<std::size_t>(k)]);
    for (std::int32_t at = cell.more; at >= 0; at = extra_[at].next) visit(extra_[at].mark);
}

std::int32_t OrderStage::Impl::cell_at(const glm::dvec3& position) const noexcept {
    return number_.find(code_of(grid_, position) >> static_cast<unsigned>(3 * settings_.level));
}

// The cell of a place near `cell`; -1 if that is no home.
std::int32_t OrderStage::Impl::home_cell_at(const glm::dvec3& position, std::int32_t cell) const noexcept {
    const std::uint64_t code = code_of(grid_, position);
    const std::uint64_t here = code >> static_cast<unsigned>(3 * settings_.level);
    if (settings_.level == home_level_) return here == code_[cell] ? cell : number_.find(here);
    return home_.find(code >> static_cast<unsigned>(3 * home_level_)) < 0 ? -1 : number_.find(here);
}

// Calls visit on the cells that have a point nearer than that to one in `cell`.
template <class Visit>
void OrderStage::Impl::for_reached(const glm::vec3& position, double distance, std::int32_t cell, Visit&& visit) const {
    const Cell& c = cell_[cell];
    std::uint32_t left = c.neighbour & reached(position - c.low, side_, static_cast<float>(distance));
    for (; left != 0; left &= left - 1) visit(neighbour_[cell][static_cast<std::size_t>(std::countr_zero(left))]);
}

void OrderStage::Impl::feel_all() {
    site_.runtime.parallel.for_chunks(cell_.size(), ordered_cells_of_task, [&](std::int64_t begin, std::int64_t end) {
        progress_.check();
        std::array<OrderMark, 64> near; // more are felt in parts
        for (std::int64_t c = begin; c < end; ++c) {
            std::size_t count = 0;
            const auto feel = [&] {
                loops_.feel(block_of(cell_[c]), near.data(), static_cast<std::int64_t>(count), inverse_squared_reach());
                count = 0;
            };
            for (const std::int32_t there : neighbour_[c]) {
                if (there < 0) continue;
                for_marks(cell_[there], [&](const Slot& slot) {
                    if (count == near.size()) feel();
                    std::copy_n(slot.position, 3, near[count].position);
                    unpack_normal(slot.normal, near[count++].normal);
                });
            }
            feel();
        }
    });
}

void OrderStage::Impl::note(std::int32_t cell, const OrderLowest& found) noexcept {
    cell_[cell].best = static_cast<std::int32_t>(found.at);
    lowest_[cell] = found.energy;
    floor_[cell] = found.of_all;
}

void OrderStage::Impl::drop_nearer(double distance) {
    const auto enough = static_cast<float>(distance * distance);
    site_.runtime.parallel.for_chunks(
        cell_.size(), 8 * ordered_cells_of_task, [&](std::int64_t begin, std::int64_t end) {
            progress_.check();
            for (std::int64_t c = begin; c < end; ++c) {
                cell_[c].groups = static_cast<std::int32_t>(groups_for(keep(block_of(cell_[c]), enough)));
                floor_[c] = 0.0F; // so that the best one is found again
            }
        });
}

float OrderStage::Impl::lowest() {
    site_.runtime.parallel.for_chunks(cell_.size(), 8 * ordered_cells_of_task,
                                      [&](std::int64_t begin, std::int64_t end) {
                                          progress_.check();
                                          for (std::int64_t c = begin; c < end; ++c)
                                              refresh(static_cast<std::int32_t>(c), enough_);
                                      });
    return *std::min_element(lowest_.begin(), lowest_.end());
}

// A tile's turn.
class OrderStage::Impl::Turn {
public:
    Turn(OrderStage::Impl& stage, Fresh* fresh) noexcept : stage_(stage), fresh_(fresh) {}

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

    // Asks for all that a mark near the cell will change, so that it comes in one go.
    void bring(std::int32_t cell) const noexcept {
        const std::array<std::int32_t, 27>& neighbour = stage_.neighbour_[cell];
        const std::uint32_t there = stage_.cell_[cell].neighbour;
        for (std::uint32_t left = there; left != 0; left &= left - 1)
            base::prefetch(&stage_.cell_[neighbour[static_cast<std::size_t>(std::countr_zero(left))]], 1);
        for (std::uint32_t left = there; left != 0; left &= left - 1) {
            const Cell& near = stage_.cell_[neighbour[static_cast<std::size_t>(std::countr_zero(left))]];
            base::prefetch(stage_.groups_ + near.group, near.groups);
        }
    }

    void take(std::int32_t cell) {
        bring(cell);
        const Fresh fresh = place(cell);
        if (fresh.cell < 0) {
            float& clearance = stage_.block_of(stage_.cell_[cell]).at(OrderGroup::clearance, stage_.cell_[cell].best);
            clearance = std::min(clearance, again * enough_);
            stage_.refresh(cell, enough_);
            return;
        }
        fresh_[count_] = fresh;
        fresh_[count_].linked = stage_.link(fresh.mark, fresh.cell);
        if (!fresh_[count_].linked) unlinked_[unlinked_count_++] = count_;
        ++count_;
        stage_.for_reached(place_of(fresh.mark), stage_.settings_.reach, fresh.cell, [&](std::int32_t there) {
            stage_.note(there, stage_.loops_.feel_and_find(stage_.block_of(stage_.cell_[there]), fresh.mark,
                                                           stage_.inverse_squared_reach(), enough_));
        });
    }

    // From a candidate.
    struct View {
        glm::vec3 start, normal;
        float farthest; // squared
        geometry::TangentFrame frame;
    };

    // The cell's best candidate itself if it keeps the distance, else a place in its gap that does.
    [[nodiscard]] Fresh place(std::int32_t cell) {
        const std::int64_t i = stage_.cell_[cell].best;
        const OrderBlock block = stage_.block_of(stage_.cell_[cell]);
        Fresh fresh{};
        fresh.mark.position[0] = block.at(OrderGroup::x, i);
        fresh.mark.position[1] = block.at(OrderGroup::y, i);
        fresh.mark.position[2] = block.at(OrderGroup::z, i);
        fresh.energy = block.at(OrderGroup::energy, i);
        fresh.cell = cell;
        fresh.step = step_;
        unpack_normal(block.at(OrderGroup::normal, i), fresh.mark.normal);
        if (block.at(OrderGroup::clearance, i) < static_cast<float>(radius_ * radius_)) move(fresh);
        return fresh;
    }

    void look_at(const Slot& mark, const View& from) noexcept {
        const glm::vec3 between = glm::vec3(mark.position[0], mark.position[1], mark.position[2]) - from.start;
        if (glm::dot(between, between) > from.farthest || around_ == most_around) return;
        float unpacked[3];
        unpack_normal(mark.normal, unpacked);
        const float turn =
            (from.normal.x * unpacked[0] + from.normal.y * unpacked[1] + from.normal.z * unpacked[2]) / unpacked_length;
        if (turn < opposite) return;
        const bool beyond = turn < straight_stage && stage_.site_.implicit.sheets() != nullptr;
        bent_ = bent_ || (turn < straight_stage && !beyond);
        const glm::dvec3 precise(between);
        const glm::dvec2 tangent(glm::dot(precise, from.frame.u), glm::dot(precise, from.frame.r));
        const double length = glm::length(tangent);
        const glm::dvec3 other = beyond ? glm::normalize(vector(unpacked)) : glm::dvec3(0.0);
        const double way =
            beyond ? std::sqrt(squared_way(precise, glm::dvec3(from.normal), other)) : glm::length(precise);
        flat_[around_] = length > 0.0 ? way / length * tangent : tangent;
        beyond_[around_] = other;
        between_[around_++] = precise;
    }

    // In the tangent plane, where the distances from the candidate are taken as long as those in space.
    void move(Fresh& fresh) noexcept {
        const glm::dvec3 normal = glm::normalize(vector(fresh.mark.normal));
        const double far = radius_ + 2.0 * stage_.settings_.farthest_move;
        const View view{place_of(fresh.mark), glm::vec3(normal), static_cast<float>(far * far),
                        geometry::combing_frame(normal)};
        around_ = 0;
        bent_ = false;
        for (std::size_t k = 0; k < unlinked_count_; ++k) look_at(slot_of(fresh_[unlinked_[k]].mark), view);
        stage_.for_reached(view.start, far, fresh.cell, [&](std::int32_t there) {
            stage_.for_marks(stage_.cell_[there], [&](const Slot& mark) { look_at(mark, view); });
        });
        const glm::dvec2 way = toward_void({flat_.data(), around_}, 1.02 * radius_, stage_.settings_.farthest_move);
        settle(fresh, glm::dvec3(view.start), way, way.x * view.frame.u + way.y * view.frame.r);
    }

    // Not nearer to a mark than the radius, nor over the crease that it is behind.
    [[nodiscard]] bool is_free(std::size_t i, const glm::dvec2& way, const glm::dvec3& moved) const noexcept {
        const glm::dvec3 other = beyond_[i];
        if (other == glm::dvec3(0.0)) return glm::distance(between_[i], moved) >= radius_;
        return glm::distance(flat_[i], way) >= radius_ &&
               (glm::dot(-between_[i], other) < 0.0) == (glm::dot(moved - between_[i], other) < 0.0);
    }

    void settle(Fresh& fresh, const glm::dvec3& start, const glm::dvec2& way, const glm::dvec3& moved) noexcept {
        const std::int32_t cell = std::exchange(fresh.cell, -1);
        if (bent_) return; // a tangent plane is no way along it
        for (std::size_t i = 0; i < around_; ++i)
            if (!is_free(i, way, moved)) return;
        const glm::dvec3 end = start + moved;
        if (!stage_.region_.contains(end)) return;
        const glm::vec3 p(end);
        for (int c = 0; c < 3; ++c) fresh.mark.position[c] = p[c];
        fresh.cell = stage_.home_cell_at(end, cell);
    }

    OrderStage::Impl& stage_;
    Fresh* fresh_;
    std::int32_t count_ = 0;
    std::size_t unlinked_count_ = 0;
    std::array<std::int32_t, most_fresh> unlinked_; // of the fresh, those that found no slot
    double radius_ = 0.0;
    float enough_ = 0.0F; // squared distance from marks that makes a candidate open
    std::uint8_t step_ = 0;
    // Marks around a candidate, as seen from it.
    std::size_t around_ = 0;
    bool bent_ = false; // some have another normal
    std::array<glm::dvec2, most_around> flat_;
    std::array<glm::dvec3, most_around> between_;
    std::array<glm::dvec3, most_around> beyond_; // the normals of those over a crease, and 0
};

void OrderStage::Impl::bring_cells(const Tile& tile) const noexcept {
    base::prefetch(&cell_[tile.begin], tile.end - tile.begin);
    base::prefetch(&neighbour_[tile.begin], tile.end - tile.begin);
}

void OrderStage::Impl::bring_candidates(const Tile& tile) const noexcept {
    for (std::int32_t c = tile.begin; c < tile.end; ++c) base::prefetch(groups_ + cell_[c].group, cell_[c].groups);
}

void OrderStage::Impl::sweep(std::span<const SweepStep> steps, std::int64_t room, OrderedMarks& marks) {
    step_.clear();
    energy_.clear();
    const double nearest = settings_.nearness * steps.back().radius;
    enough_ = static_cast<float>(nearest * nearest);
    for (std::size_t turn = 0; turn < 8; ++turn) {
        const std::int64_t first = turn_[turn];
        const std::int64_t tiles = turn_[turn + 1] - first;
        fresh_.resize_for_overwrite(most_fresh * tiles);
        fresh_count_.resize_for_overwrite(tiles);
        site_.runtime.parallel.for_chunks(
            tiles, std::clamp<std::int64_t>(tiles / 32, 1, 16), [&](std::int64_t begin, std::int64_t end) {
                for (std::int64_t t = begin; t < end; ++t) {
                    progress_.check();
                    if (t + 2 < end) bring_cells(tile_[first + t + 2]);
                    if (t + 1 < end) bring_candidates(tile_[first + t + 1]);
                    fresh_count_[t] = Turn(*this, fresh_.data() + most_fresh * t).run(tile_[first + t], steps);
                }
            });
        for (std::int64_t t = 0; t < tiles; ++t) {
            if (t % 256 == 0) progress_.check();
            for (std::int32_t k = 0; k < fresh_count_[t]; ++k) append(fresh_[most_fresh * t + k], marks);
        }
    }
    if (energy_.size() > room) keep_lowest(room, marks);
}

void OrderStage::Impl::append(const Fresh& fresh, OrderedMarks& marks) {
    base::push_back_long(marks, fresh.mark, progress_);
    if (!fresh.linked) link_more(fresh.mark, fresh.cell);
    base::push_back_long(energy_, fresh.energy, progress_);
    base::push_back_long(step_, fresh.step, progress_);
}

void OrderStage::Impl::keep_lowest(std::int64_t room, OrderedMarks& marks) {
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

OrderStage::OrderStage(const marks::Site& site, Candidates& candidates, const CellMap& home, std::int32_t home_level,
                       const StageSettings& settings, const OrderedMarks& marks, const base::Progress& progress)
    : impl_(std::make_unique<Impl>(site, candidates, home, home_level, settings, marks, progress)) {}
OrderStage::~OrderStage() = default;

void OrderStage::sweep(std::span<const SweepStep> steps, std::int64_t room, OrderedMarks& marks) {
    impl_->sweep(steps, room, marks);
}
const base::Array<std::uint8_t>& OrderStage::steps() const noexcept { return impl_->steps(); }
float OrderStage::lowest() { return impl_->lowest(); }
void OrderStage::drop_nearer(double distance) { impl_->drop_nearer(distance); }

} // namespace hrbfnpr::stipples
