// SPDX-License-Identifier: MIT
// EvenOrder::run, step by step:
//
// 1. sort: sorts the marks into tiles, and those of each tile by their order on the surface and into cells
// 2. find_claims: finds for each mark the marks before it that may be too near
// 3. settle_tile: finds the distances of a tile's marks. A distance depends only on the distances of marks before it.
//    So rounds over all tiles end, and the result depends neither on the tiles nor on the number of rounds.
// 4. run: sets radii, and removes the dots that are not shown
#include "frame/depth_layers/even.h"

#include "base/scratch.h"
#include "frame/depth_layers/tuning.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numeric>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// Vectors read and write up to this many elements beyond the last.
constexpr std::int64_t vector_margin = 16;

// For n . v = k / 20: how far marks keep away from each other, in units of the distance of the densest packing with the
// wanted number of marks. With these distances, the ink is that of marks that ignore each other. Measured
// (docs/measurements.md).
constexpr std::array<float, 21> reaches = {0.855F, 0.855F, 0.855F, 0.856F, 0.858F, 0.858F, 0.862F,
                                           0.865F, 0.870F, 0.877F, 0.883F, 0.891F, 0.899F, 0.906F,
                                           0.913F, 0.919F, 0.922F, 0.924F, 0.921F, 0.899F, 0.700F};
// The distance of the densest packing, in units of the square root of the area of a mark.
constexpr float packed = 1.0745699F;

[[nodiscard]] float reach_at(float facing) noexcept {
    const float at = facing * static_cast<float>(reaches.size() - 1);
    const auto cell = static_cast<std::size_t>(std::min(at, static_cast<float>(reaches.size() - 2)));
    return reaches[cell] + (reaches[cell + 1] - reaches[cell]) * (at - static_cast<float>(cell));
}

// Returns the part of a mark's area that is drawn at a place in the order of the picture, as select() does.
[[nodiscard]] float grown(float place, float shown, float fade) noexcept {
    if (!(shown > 0.0F) || place > shown) return 0.0F;
    return fade > 0.0F ? std::min(1.0F, (shown - place) / (fade * shown)) : 1.0F;
}

// Returns the distance that a mark can keep from an earlier one. It rises from `distance` at the weight 1, slowly at
// first, and has no limit at the weight 0.
[[nodiscard]] float kept_distance(float distance, float weight) noexcept {
    const float rise = 1.0F + layer_tuning.claim_rise * (1.0F - weight);
    return distance * rise / std::min(1.0F, weight / layer_tuning.claim_end);
}

} // namespace

EvenOrder::EvenOrder(base::Memory& memory) noexcept
    : range_(memory), in_range_(memory), removed_(memory), tiles_(memory, drawing::tile_size), first_(memory),
      keys_(memory), spots_(memory), cell_first_(memory), order_(memory), cell_x_(memory), cell_y_(memory),
      cell_place_(memory), tile_(memory), distance_(memory), previous_(memory) {}

// Returns the column or the row of the cell at a place. Places outside the picture belong to the nearest cell.
std::int32_t EvenOrder::cell_along(float at, std::int32_t tiles) const noexcept {
    const auto last = static_cast<float>(tiles * cells_ - 1);
    return static_cast<std::int32_t>(std::clamp(at * (static_cast<float>(cells_) / drawing::tile_size), 0.0F, last));
}

// Copies the marks of a tile into its cells. Each cell has its marks in their order.
void EvenOrder::fill_tile(std::span<const EvenMark> marks, const drawing::Drawing& drawing, std::int64_t number) {
    const std::int64_t begin = first_[number];
    const std::int64_t count = first_[number + 1] - begin;
    std::uint64_t* const keys = keys_.data() + begin;
    std::int64_t added = 0;
    tiles_.for_tile(number, [&](std::uint32_t dot) {
        keys[added++] = std::uint64_t{std::bit_cast<std::uint32_t>(marks[dot].place)} << 32U | dot;
    });
    HRBFNPR_ASSERT(added == count);
    std::sort(keys, keys + count);
    const glm::vec2 corner(drawing.first_pixel);
    const std::int64_t cells = std::int64_t{cells_} * cells_;
    std::uint32_t* const first = cell_first_.data() + number * cells;
    std::uint32_t* const order = order_.data() + begin;
    std::fill_n(first, cells, 0U);
    for (std::int64_t i = 0; i < count; ++i) {
        const Dot& dot = drawing.dots[static_cast<std::uint32_t>(keys[i])];
        const std::int32_t column = cell_along(dot.x - corner.x, tiles_.columns()) % cells_;
        const std::int32_t row = cell_along(dot.y - corner.y, tiles_.rows()) % cells_;
        order[i] = static_cast<std::uint32_t>(row * cells_ + column);
        ++first[order[i]];
    }
    std::exclusive_scan(first, first + cells, first, static_cast<std::uint32_t>(begin));
    for (std::int64_t i = 0; i < count; ++i) {
        const std::uint32_t at = first[order[i]]++;
        order[i] = at;
        const auto index = static_cast<std::uint32_t>(keys[i]);
        spots_[at] = spot_of(keys[i], marks[index], drawing.dots[index], corner);
        cell_x_[at] = spots_[at].x;
        cell_y_[at] = spots_[at].y;
        cell_place_[at] = marks[index].place;
    }
    // Now each element is the end of its cell. Shifting makes it the begin of the next.
    std::copy_backward(first, first + cells - 1, first + cells);
    first[0] = static_cast<std::uint32_t>(begin);
}

EvenOrder::Spot EvenOrder::spot_of(std::uint64_t order, const EvenMark& mark, const Dot& dot,
                                   const glm::vec2& corner) noexcept {
    const float inside = 2.0F * (1.0F - mark.outside / layer_tuning.even_margin);
    return {order,
            dot.x - corner.x,
            dot.y - corner.y,
            dot.depth,
            dot.pixels_per_unit,
            std::min(mark.own, layer_tuning.even_most * mark.wanted),
            reach_at(mark.facing) * packed * mark.wanted,
            mark.wanted,
            mark.normal,
            mark.slope,
            std::clamp(inside, 0.0F, 1.0F),
            dot.layer};
}

void EvenOrder::sort(const base::Parallel& parallel, std::span<const EvenMark> marks, const drawing::Drawing& drawing) {
    const glm::vec2 first(drawing.first_pixel);
    const glm::vec2 last(drawing.pixels - 1);
    tiles_.build(parallel, drawing.pixels.x, drawing.pixels.y, in_range_.span(),
                 [&](std::int64_t i, drawing::Tiles::Footprint& print) {
                     const glm::vec2 at(drawing.dots[i].x, drawing.dots[i].y);
                     const glm::vec2 inside = glm::clamp(at - first, glm::vec2(0.0F), last);
                     print = {inside.x, inside.y, inside.x, inside.y};
                     return true;
                 });
    const std::int64_t tiles = tiles_.tiles();
    base::resize_scratch(first_, tiles + 1);
    first_[0] = 0;
    std::int64_t used = 0;
    for (std::int64_t i = 0; i < tiles; ++i) {
        const std::int64_t count = tiles_.count(i);
        used += count > 0;
        first_[i + 1] = first_[i] + count;
    }
    const std::int64_t count = first_[tiles];
    // A power of two, so that a cell has a few marks.
    cells_ = 1;
    while (cells_ < layer_tuning.most_even_cells && 4 * used * (cells_ * cells_) < count) cells_ *= 2;
    base::resize_scratch(keys_, count);
    base::resize_scratch(spots_, count);
    base::resize_scratch(order_, count);
    for (base::Array<float>* const row : {&cell_x_, &cell_y_, &cell_place_}) {
        base::resize_scratch(*row, count + vector_margin);
        std::fill(row->end() - vector_margin, row->end(), 0.0F);
    }
    base::resize_scratch(cell_first_, tiles * cells_ * cells_ + 1);
    cell_first_[tiles * cells_ * cells_] = static_cast<std::uint32_t>(count);
    while (tile_.size() < tiles) tile_.add(tile_.memory());
    parallel.for_each(tiles, [&](std::int64_t i) { fill_tile(marks, drawing, i); });
}

// Finds the cells within `reach` of a cell of a tile, as intervals of consecutive marks. Returns how many marks they
// have.
std::int64_t EvenOrder::find_cells(std::int64_t number, std::int32_t cell, float reach,
                                   base::Array<MarkInterval>& intervals) const {
    const auto column = static_cast<std::int32_t>(number % tiles_.columns()) * cells_ + cell % cells_;
    const auto row = static_cast<std::int32_t>(number / tiles_.columns()) * cells_ + cell / cells_;
    const auto far =
        static_cast<std::int32_t>(std::min(std::ceil(reach * (static_cast<float>(cells_) / drawing::tile_size)), 1e6F));
    const std::int32_t left = std::max(column - far, 0);
    const std::int32_t right = std::min(column + far, tiles_.columns() * cells_ - 1);
    const std::int32_t bottom = std::min(row + far, tiles_.rows() * cells_ - 1);
    intervals.clear();
    std::int64_t marks = 0;
    for (std::int32_t y = std::max(row - far, 0); y <= bottom; ++y) {
        for (std::int32_t x = left; x <= right;) {
            const std::int32_t last = std::min(right, x | (cells_ - 1)); // the last cell in this tile
            const std::int64_t tile = std::int64_t{y / cells_} * tiles_.columns() + x / cells_;
            const std::uint32_t* const cells = cell_first_.data() + (tile * cells_ + y % cells_) * cells_;
            const MarkInterval interval = {cells[x % cells_], cells[last % cells_ + 1]};
            if (interval.begin < interval.end) intervals.push_back(interval);
            marks += interval.end - interval.begin;
            x = last + 1;
        }
    }
    return marks;
}

// Returns 1 for two marks on one sheet of the surface, and 0 for marks on different sheets.
float EvenOrder::same_sheet(const Spot& a, const Spot& b) noexcept {
    const glm::vec2 apart(b.x - a.x, b.y - a.y);
    const auto along = [](const glm::vec2& n) { return std::sqrt(std::max(0.0F, 1.0F - glm::dot(n, n))); };
    const float turn = glm::dot(a.normal, b.normal) + along(a.normal) * along(b.normal);
    // The depth of a curved sheet changes by the mean slope, up to a part of the change of the slope.
    const float depth = (b.depth - a.depth) * a.pixels_per_unit - 0.5F * glm::dot(a.slope + b.slope, apart);
    const glm::vec2 change = b.slope - a.slope;
    const float bend = std::sqrt(glm::dot(change, change) * glm::dot(apart, apart));
    const float most = layer_tuning.sheet_bend * bend + layer_tuning.sheet_gap;
    return std::clamp(std::min(2.0F - std::abs(depth) / most, (turn - 0.5F) * 4.0F), 0.0F, 1.0F);
}

// Adds the claim of an earlier mark if both are on the same sheet of the surface.
void EvenOrder::add_claim(const Spot& spot, std::uint32_t number, base::Array<Claim>& claims) const {
    const Spot& other = spots_[number];
    if (other.run != spot.run || other.order >= spot.order) return;
    const float weight = other.weight * same_sheet(spot, other);
    const float x = other.x - spot.x;
    const float y = other.y - spot.y;
    const float pixels = std::sqrt(x * x + y * y);
    if (weight > 0.0F) claims.push_back({number, std::max(pixels, 1e-6F), weight});
}

void EvenOrder::find_claims(const NearMarks& near, std::int64_t number) {
    Tile& tile = tile_[number];
    tile.first.clear();
    tile.claims.clear();
    const MarksInCells marks = {cell_x_.data(), cell_y_.data(), cell_place_.data()};
    const auto reach_of = [&](std::uint32_t i) {
        return std::max(spots_[i].reach, layer_tuning.even_distance * spots_[i].most);
    };
    for (std::int32_t cell = 0; cell < cells_ * cells_; ++cell) {
        const std::uint32_t* const first = cell_first_.data() + number * cells_ * cells_ + cell;
        if (first[0] == first[1]) continue;
        float farthest = 0.0F;
        for (std::uint32_t i = first[0]; i < first[1]; ++i) farthest = std::max(farthest, reach_of(i));
        base::resize_scratch(tile.found, find_cells(number, cell, farthest, tile.intervals) + vector_margin);
        for (std::uint32_t i = first[0]; i < first[1]; ++i) {
            const Spot& spot = spots_[i];
            tile.first.push_back(static_cast<std::uint32_t>(tile.claims.size()));
            const std::int64_t before = tile.claims.size();
            const std::int64_t found = near.find(marks, tile.intervals.data(), tile.intervals.size(), spot.x, spot.y,
                                                 reach_of(i), cell_place_[i], tile.found.data());
            for (std::int64_t k = 0; k < found; ++k) add_claim(spot, tile.found[k], tile.claims);
            const bool is_free = tile.claims.size() == before;
            distance_[i] = previous_[i] = is_free ? spot.most : -spot.most;
        }
    }
    tile.first.push_back(static_cast<std::uint32_t>(tile.claims.size()));
    tile.open.clear();
    for (std::int64_t i = first_[number]; i < first_[number + 1]; ++i)
        if (previous_[order_[i]] < 0.0F) tile.open.push_back(order_[i]);
}

// Finds the distances of a tile's open marks from the distances of the marks before them. Those of other tiles are from
// the round before. A distance that may still change is stored with a minus sign. A mark stays open until both arrays
// have its last distance.
void EvenOrder::settle_tile(std::int64_t number) {
    Tile& tile = tile_[number];
    const std::int64_t begin = first_[number];
    const std::int64_t end = first_[number + 1];
    constexpr float per_range = 1.0F / (layer_tuning.claim_whole - layer_tuning.claim_begins);
    std::int64_t open = 0;
    for (const std::uint32_t i : tile.open) {
        float distance = spots_[i].most;
        bool is_last = true;
        for (std::uint32_t k = tile.first[i - begin]; k < tile.first[i - begin + 1]; ++k) {
            const Claim& claim = tile.claims[k];
            const float apart = claim.pixels * (1.0F / layer_tuning.even_distance);
            if (distance <= apart) continue;
            const bool own = claim.spot >= begin && claim.spot < end;
            const float other = own ? distance_[claim.spot] : previous_[claim.spot];
            is_last = is_last && other > 0.0F;
            if (std::abs(other) <= layer_tuning.claim_begins * apart) continue;
            const float part = (std::abs(other) / apart - layer_tuning.claim_begins) * per_range;
            distance = std::min(distance, kept_distance(apart, std::min(part, 1.0F) * claim.weight));
        }
        const bool was_last = previous_[i] > 0.0F;
        distance_[i] = is_last ? distance : -distance;
        if (!is_last || !was_last) tile.open[open++] = i;
    }
    tile.open.resize(open);
}

// Returns the part of its area that a mark keeps beside the marks before it.
float EvenOrder::part_of(const Spot& spot, std::span<const Claim> claims) const noexcept {
    const float share = spot.reach / spot.wanted;
    float part = 1.0F;
    for (const Claim& claim : claims) {
        if (claim.pixels >= spot.reach) continue;
        // How far the other one is shown where the picture is so large that the two are just not too near.
        const float shown = (previous_[claim.spot] * share / claim.pixels - 1.0F) / layer_tuning.even_shown;
        const float near = (1.0F - claim.pixels / spot.reach) / layer_tuning.even_soft;
        const float t = std::min(near, 1.0F);
        part *= 1.0F - t * t * (3.0F - 2.0F * t) * std::clamp(shown, 0.0F, 1.0F) * claim.weight;
    }
    return std::max(0.0F, (part - layer_tuning.even_least) / (1.0F - layer_tuning.even_least));
}

// Makes dots smaller.
void EvenOrder::shrink(const base::Parallel& parallel, std::span<const EvenMark> marks,
                       drawing::Drawing& drawing) const {
    parallel.for_each(tiles_.tiles(), [&](std::int64_t number) {
        const Tile& tile = tile_[number];
        for (std::int64_t i = first_[number]; i < first_[number + 1]; ++i) {
            const auto index = static_cast<std::uint32_t>(spots_[i].order);
            const EvenMark& mark = marks[index];
            const std::int64_t k = i - first_[number];
            const std::span claims(tile.claims.data() + tile.first[k], tile.claims.data() + tile.first[k + 1]);
            drawing.dots[index].radius *=
                std::sqrt(grown(mark.flat, mark.shown, mark.fade) * part_of(spots_[i], claims));
        }
    });
}

void EvenOrder::remove_hidden(const base::Parallel& parallel, std::span<const EvenMark> marks,
                              drawing::Drawing& drawing) {
    base::resize_scratch(removed_, range_.size());
    parallel.for_each(range_.size(), [&](std::int64_t r) {
        Removed removed;
        IndexRange& range = drawing.dot_ranges[range_[r]];
        std::int64_t end = range.begin;
        for (std::int64_t i = range.begin; i < range.end; ++i) {
            const Dot& dot = drawing.dots[i];
            if (marks[static_cast<std::size_t>(i)].outside > dot.radius + soft_rim) {
                ++removed.outside;
            } else if (!(dot.radius > 0.0F)) {
                ++removed.by_tone;
            } else {
                drawing.dots[end++] = dot;
            }
        }
        range.end = end;
        removed_[r] = removed;
    });
    for (const Removed& removed : removed_) {
        drawing.counts.dropped_tone += removed.by_tone;
        drawing.counts.outside += removed.outside;
        drawing.counts.front -= removed.outside;
    }
}

void EvenOrder::run(const base::Runtime& runtime, const Scene& scene, std::span<const EvenMark> marks,
                    drawing::Drawing& drawing) {
    const base::Parallel& parallel = runtime.parallel;
    range_.clear();
    in_range_.clear();
    for (std::int64_t r = 0; r < drawing.dot_ranges.size(); ++r) {
        const IndexRange& range = drawing.dot_ranges[r];
        if (range.begin == range.end || !scene.runs[drawing.dots[range.begin].layer].even_in_picture) continue;
        range_.push_back(r);
        in_range_.push_back(range);
    }
    if (range_.empty()) return;
    sort(parallel, marks, drawing);
    base::resize_scratch(distance_, spots_.size());
    base::resize_scratch(previous_, spots_.size());
    const NearMarks near = near_marks(runtime.instruction_set);
    parallel.for_each(tiles_.tiles(), [&](std::int64_t i) { find_claims(near, i); });
    const auto is_open = [](const Tile& tile) { return !tile.open.empty(); };
    while (std::any_of(tile_.begin(), tile_.begin() + tiles_.tiles(), is_open)) {
        parallel.for_each(tiles_.tiles(), [&](std::int64_t i) { settle_tile(i); });
        std::swap(distance_, previous_);
    }
    shrink(parallel, marks, drawing);
    remove_hidden(parallel, marks, drawing);
}

std::int64_t EvenOrder::bytes() const noexcept {
    std::int64_t claims = 0;
    for (const Tile& tile : tile_)
        claims +=
            tile.first.bytes() + tile.claims.bytes() + tile.open.bytes() + tile.intervals.bytes() + tile.found.bytes();
    return range_.bytes() + in_range_.bytes() + removed_.bytes() + tiles_.bytes() + first_.bytes() + keys_.bytes() +
           spots_.bytes() + cell_first_.bytes() + order_.bytes() + cell_x_.bytes() + cell_y_.bytes() +
           cell_place_.bytes() + tile_.bytes() + claims + distance_.bytes() + previous_.bytes();
}

} // namespace hrbfnpr::frame
