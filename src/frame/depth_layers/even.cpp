// SPDX-License-Identifier: MIT
// EvenOrder::run, step by step:
//
// 1. sort: sorts the marks into tiles, and those of each tile into cells
// 2. shrink_tile: makes the dots of a tile smaller
// 3. remove_hidden: removes the dots that are not shown
#include "frame/depth_layers/even.h"

#include "base/scratch.h"
#include "frame/depth_layers/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hrbfnpr::frame {
namespace {

// Vectors read and write up to this many elements beyond the last.
constexpr std::int64_t vector_margin = 16;

// For n . v = k / 20: how far marks keep away from each other, in units of the distance of the densest packing with the
// wanted number of marks. With these distances, the ink is that of marks that ignore each other. Measured
// (docs/measurements.md).
constexpr std::array<float, 21> reaches = {0.797F, 0.797F, 0.797F, 0.808F, 0.823F, 0.835F, 0.850F,
                                           0.864F, 0.879F, 0.891F, 0.904F, 0.915F, 0.925F, 0.932F,
                                           0.939F, 0.942F, 0.940F, 0.934F, 0.921F, 0.888F, 0.700F};
// The distance of the densest packing, in units of the square root of the area of a mark.
constexpr float packed = 1.0745699F;

[[nodiscard]] float reach_at(float facing) noexcept {
    const float at = facing * static_cast<float>(reaches.size() - 1);
    const auto cell = static_cast<std::size_t>(std::min(at, static_cast<float>(reaches.size() - 2)));
    return reaches[cell] + (reaches[cell + 1] - reaches[cell]) * (at - static_cast<float>(cell));
}

// Returns the part of the area of a mark that its place lets it have, as select() does for marks that keep their order.
[[nodiscard]] float grown(float place, float shown, float fade) noexcept {
    if (!(shown > 0.0F) || place > shown) return 0.0F;
    return fade > 0.0F ? std::min(1.0F, (shown - place) / (fade * shown)) : 1.0F;
}

} // namespace

EvenOrder::EvenOrder(base::Memory& memory) noexcept
    : range_(memory), in_range_(memory), removed_(memory), tiles_(memory, drawing::tile_size), first_(memory),
      cell_of_(memory), cell_first_(memory), spots_(memory), x_(memory), y_(memory), place_(memory), tile_(memory) {}

// Returns the column or the row of the cell at a place. Places outside the picture belong to the nearest cell.
std::int32_t EvenOrder::cell_along(float at, std::int32_t tiles) const noexcept {
    const auto last = static_cast<float>(tiles * cells_ - 1);
    return static_cast<std::int32_t>(std::clamp(at * (static_cast<float>(cells_) / drawing::tile_size), 0.0F, last));
}

EvenOrder::Spot EvenOrder::spot_of(const EvenMark& mark, const Dot& dot, std::uint32_t index,
                                   const glm::vec2& corner) noexcept {
    const float inside = 2.0F * (1.0F - mark.outside / layer_tuning.even_margin);
    const float share = reach_at(mark.facing) * packed;
    return {dot.x - corner.x,
            dot.y - corner.y,
            dot.depth,
            dot.pixels_per_unit,
            mark.place,
            mark.own,
            share * mark.wanted,
            share,
            mark.normal,
            mark.slope,
            std::clamp(inside, 0.0F, 1.0F),
            dot.layer,
            index};
}

// Copies the marks of a tile into its cells.
void EvenOrder::fill_tile(std::span<const EvenMark> marks, const drawing::Drawing& drawing, std::int64_t number) {
    const glm::vec2 corner(drawing.first_pixel);
    const std::int64_t cells = std::int64_t{cells_} * cells_;
    std::uint32_t* const first = cell_first_.data() + number * cells;
    std::uint32_t* cell = cell_of_.data() + first_[number];
    std::fill_n(first, cells, 0U);
    tiles_.for_tile(number, [&](std::uint32_t index) {
        const Dot& dot = drawing.dots[index];
        const std::int32_t column = cell_along(dot.x - corner.x, tiles_.columns()) % cells_;
        const std::int32_t row = cell_along(dot.y - corner.y, tiles_.rows()) % cells_;
        *cell = static_cast<std::uint32_t>(row * cells_ + column);
        ++first[*cell++];
    });
    std::exclusive_scan(first, first + cells, first, static_cast<std::uint32_t>(first_[number]));
    cell = cell_of_.data() + first_[number];
    tiles_.for_tile(number, [&](std::uint32_t index) {
        const std::uint32_t at = first[*cell++]++;
        const Spot& spot = spots_[at] = spot_of(marks[index], drawing.dots[index], index, corner);
        x_[at] = spot.x;
        y_[at] = spot.y;
        place_[at] = spot.place;
    });
    // Now each element is the end of its cell. Shifting makes it the begin of the next.
    std::copy_backward(first, first + cells - 1, first + cells);
    first[0] = static_cast<std::uint32_t>(first_[number]);
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
    base::resize_scratch(cell_of_, count);
    base::resize_scratch(spots_, count);
    for (base::Array<float>* const row : {&x_, &y_, &place_}) {
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

// Returns the part of its area that a mark keeps beside the near marks whose places are at most its own.
float EvenOrder::part_of(const Spot& spot, std::span<const std::uint32_t> near) const noexcept {
    float part = 1.0F;
    for (const std::uint32_t number : near) {
        const Spot& other = spots_[number];
        if (other.run != spot.run) continue;
        if (other.place == spot.place && other.dot >= spot.dot) continue;
        const float pixels =
            std::sqrt((other.x - spot.x) * (other.x - spot.x) + (other.y - spot.y) * (other.y - spot.y));
        // How far the other one is shown where the picture is so large that the two are just not too near.
        const float shown = (other.own * spot.share / std::max(pixels, 1e-6F) - 1.0F) / layer_tuning.even_shown;
        if (!(shown > 0.0F)) continue;
        const float close = std::min(1.0F, (1.0F - pixels / spot.reach) / layer_tuning.even_soft);
        const float weight = std::min(shown, 1.0F) * other.weight * same_sheet(spot, other);
        part *= 1.0F - close * close * (3.0F - 2.0F * close) * weight;
    }
    return std::max(0.0F, (part - layer_tuning.even_least) / (1.0F - layer_tuning.even_least));
}

void EvenOrder::shrink_tile(const NearMarks& near, std::span<const EvenMark> marks, std::int64_t number,
                            drawing::Drawing& drawing) {
    Tile& tile = tile_[number];
    const MarksInCells in_cells = {x_.data(), y_.data(), place_.data()};
    for (std::int32_t cell = 0; cell < cells_ * cells_; ++cell) {
        const std::uint32_t* const first = cell_first_.data() + number * cells_ * cells_ + cell;
        if (first[0] == first[1]) continue;
        float farthest = 0.0F;
        for (std::uint32_t i = first[0]; i < first[1]; ++i) farthest = std::max(farthest, spots_[i].reach);
        base::resize_scratch(tile.found, find_cells(number, cell, farthest, tile.intervals) + vector_margin);
        for (std::uint32_t i = first[0]; i < first[1]; ++i) {
            const Spot& spot = spots_[i];
            const EvenMark& mark = marks[spot.dot];
            const std::int64_t found = near.find(in_cells, tile.intervals.data(), tile.intervals.size(), spot.x, spot.y,
                                                 spot.reach, spot.place, tile.found.data());
            const float part = part_of(spot, {tile.found.data(), static_cast<std::size_t>(found)});
            drawing.dots[spot.dot].radius *= std::sqrt(grown(mark.flat, mark.shown, mark.fade) * part);
        }
    }
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
    const NearMarks near = near_marks(runtime.instruction_set);
    parallel.for_each(tiles_.tiles(), [&](std::int64_t i) { shrink_tile(near, marks, i, drawing); });
    remove_hidden(parallel, marks, drawing);
}

std::int64_t EvenOrder::bytes() const noexcept {
    std::int64_t working = 0;
    for (const Tile& tile : tile_) working += tile.intervals.bytes() + tile.found.bytes();
    return range_.bytes() + in_range_.bytes() + removed_.bytes() + tiles_.bytes() + first_.bytes() + cell_of_.bytes() +
           cell_first_.bytes() + spots_.bytes() + x_.bytes() + y_.bytes() + place_.bytes() + tile_.bytes() + working;
}

} // namespace hrbfnpr::frame
