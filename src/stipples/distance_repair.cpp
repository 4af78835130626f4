// SPDX-License-Identifier: MIT
#include "stipples/distance_repair.h"

#include "geometry/point_grid.h"
#include "stipples/progressive_order.h"

#include <algorithm>
#include <bit>

namespace hrbfnpr::stipples {
namespace {

// Of the densest packing's distance; the order keeps 0.70.
constexpr double least_apart = 0.66;

// Which places may be near one of a few points: a bit for each cell that is within the distance of one, or has the
// same number as such a cell.
class NearCells {
public:
    NearCells(const geometry::VecArray& points, double distance) : bits_(points.memory()) {
        geometry::Bounds box;
        for (std::int64_t i = 0; i < points.size(); ++i) box.extend(points[i]);
        box = box.grown(distance);
        box_ = box;
        grid_ = {box.min, std::max(2.0 * distance, 1e-6 * box.diagonal())};
        cells_of_length_ = 1.0 / grid_.side;
        bits_.resize(static_cast<std::int64_t>(std::bit_ceil(static_cast<std::uint64_t>(2 * points.size() + 64))));
        for (std::int64_t i = 0; i < points.size(); ++i) mark(points[i], distance);
    }

    [[nodiscard]] bool maybe(const glm::dvec3& p) const noexcept {
        if (!box_.contains(p)) return false;
        const glm::dvec3 at = cells_of_length_ * (p - grid_.origin);
        constexpr std::int64_t last = geometry::CellGrid::most - 1;
        const std::uint64_t bit =
            bit_of({geometry::whole(at.x, last), geometry::whole(at.y, last), geometry::whole(at.z, last)});
        return (bits_[static_cast<std::int64_t>(bit / 64)] >> bit % 64 & 1U) != 0;
    }

private:
    [[nodiscard]] std::uint64_t bit_of(const geometry::CellGrid::Cell& cell) const noexcept {
        return geometry::mixed_bits(geometry::CellGrid::pack(cell)) & static_cast<std::uint64_t>(64 * bits_.size() - 1);
    }

    void mark(const glm::dvec3& p, double distance) {
        // A little more, so that rounding does not matter.
        const geometry::CellGrid::Cell low = grid_.cell_of(p - 1.001 * distance);
        const geometry::CellGrid::Cell high = grid_.cell_of(p + 1.001 * distance);
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                for (std::int64_t x = low[0]; x <= high[0]; ++x) {
                    const std::uint64_t bit = bit_of({x, y, z});
                    bits_[static_cast<std::int64_t>(bit / 64)] |= std::uint64_t{1} << bit % 64;
                }
    }

    geometry::CellGrid grid_; // of cells two distances wide
    geometry::Bounds box_;
    double cells_of_length_;
    base::Array<std::uint64_t> bits_; // a power of two
};

// Two marks that are nearer than all others.
struct TooNear {
    std::int64_t later, earlier;
    [[nodiscard]] bool operator<(const TooNear& other) const noexcept {
        return later != other.later ? later < other.later : earlier < other.earlier;
    }
};

// Finds the pairs that came too near because a mark has wandered.  The later of two says how far they must be apart,
// so marks are looked at in parts, in each of which that is much the same distance.
class DistanceRepair {
public:
    DistanceRepair(const marks::Site& site, const EvenMarks& marks, const base::Array<std::int64_t>& wandered)
        : site_(site), marks_(marks), wandered_(wandered), near_(site.memory()), found_(site.memory()) {}

    // In ascending order.
    base::Array<TooNear> find() {
        const std::int64_t count = marks_.position.size();
        for (std::int64_t begin = 0, end = 1; begin < count; begin = end, end = std::min(4 * end, count))
            look_through(begin, end);
        std::sort(found_.begin(), found_.end());
        return std::move(found_);
    }

private:
    [[nodiscard]] double apart(std::int64_t later) const noexcept {
        return least_apart * densest_distance(marks_.area, static_cast<double>(later + 1));
    }

    void look_through(std::int64_t begin, std::int64_t end) {
        geometry::VecArray position(site_.memory());
        for (const std::int64_t i : wandered_)
            if (i < end) position.push_back(marks_.position[i]);
        if (position.empty()) return;
        const geometry::PointGrid grid(position, apart(begin));
        const NearCells near(position, apart(begin));
        near_.resize(end);
        site_.runtime.parallel.for_chunks(end, 8192, [&](std::int64_t from, std::int64_t to) {
            for (std::int64_t j = from; j < to; ++j) {
                near_[j] = 0;
                if (!near.maybe(marks_.position[j])) continue;
                visit(grid, begin, j, [&](const TooNear&) { near_[j] = 1; });
            }
        });
        for (std::int64_t j = 0; j < end; ++j)
            if (near_[j] != 0) visit(grid, begin, j, [&](const TooNear& pair) { found_.push_back(pair); });
    }

    // The pairs of mark j and one that wandered that are too near, of which the later one is not before `begin`.
    template <class Visit>
    void visit(const geometry::PointGrid& grid, std::int64_t begin, std::int64_t j, Visit&& visit) const {
        grid.around(marks_.position[j], [&](std::int64_t at) {
            const std::int64_t i = wandered_[grid.index(at)];
            const std::int64_t later = std::max(i, j);
            if (i == j || later < begin) return;
            const glm::dvec3 between = marks_.position[i] - marks_.position[j];
            if (glm::dot(between, between) >= apart(later) * apart(later)) return;
            if (glm::dot(marks_.normal[i], marks_.normal[j]) >= 0.0) visit(TooNear{later, std::min(i, j)});
        });
    }

    const marks::Site& site_;
    const EvenMarks& marks_;
    const base::Array<std::int64_t>& wandered_;
    base::Array<std::uint8_t> near_;
    base::Array<TooNear> found_;
};

} // namespace

void repair_distances(const marks::Site& site, const base::Array<std::int64_t>& wandered, EvenMarks& marks,
                      marks::LevelReport& report) {
    base::Array<std::uint8_t> dropped(site.memory(), marks.position.size());
    for (const TooNear& pair : DistanceRepair(site, marks, wandered).find())
        if (dropped[pair.earlier] == 0) dropped[pair.later] = 1;
    std::int64_t kept = std::find(dropped.begin(), dropped.end(), std::uint8_t{1}) - dropped.begin();
    for (std::int64_t i = kept; i < dropped.size(); ++i) {
        if (dropped[i] != 0) continue;
        marks.position.set(kept, marks.position[i]);
        marks.normal.set(kept++, marks.normal[i]);
    }
    report.placed = kept;
    report.dropped_strayed += dropped.size() - kept;
    marks.position.resize(kept);
    marks.normal.resize(kept);
}

} // namespace hrbfnpr::stipples
