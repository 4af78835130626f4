// SPDX-License-Identifier: MIT
// One stroke: a curve through a field of directions that keeps its distance from the others.
// [Jobard & Lefer 1997, 3]
#pragma once

#include "base/long_array.h"
#include "base/operation.h"
#include "geometry/point_grid.h"
#include "geometry/vec_array.h"
#include "surface/direction_field.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::strokes {

// A point of a stroke while strokes are laid.
struct StrokePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};
    glm::dvec3 direction{0.0}; // unit, tangent, along the stroke
};

// Where strokes run: their points in the buckets of a grid, which can be taken back in reverse order.
class StrokeGrid {
public:
    explicit StrokeGrid(base::Memory& memory) noexcept : head_(memory), node_(memory) {}

    // A point as it is seen by others.
    struct Node {
        StrokePoint point;
        std::int32_t stroke;
        std::int32_t place; // along the stroke, the seed at 0
    };

    // Empty, with cells of this side in this box.  Looks for a cancel where the table grows.
    void reset(const geometry::Bounds& box, double side, const base::Progress& progress = {}) {
        progress_ = progress;
        grid_ = {box.min, std::max(side, 1e-6 * box.diagonal())};
        centre_ = box.centre();
        node_.clear();
        resize_table(std::max<std::int64_t>(head_.size(), 1024));
    }
    // Room for so many points: a copy of what had grown beyond it would take long.
    void reserve(std::int64_t points) { node_.reserve(points); }
    void insert(const StrokePoint& point, std::int32_t stroke, std::int32_t place) {
        if (node_.size() >= head_.size()) resize_table(2 * head_.size());
        const std::uint64_t cell = geometry::CellGrid::pack(grid_.cell_of(point.position));
        std::int64_t& head = head_[bucket(cell)];
        base::push_back_long(node_,
                             {cell, head, glm::vec3(point.position - centre_), glm::vec3(point.normal),
                              glm::vec3(point.direction), stroke, place},
                             progress_);
        head = node_.size() - 1;
    }
    [[nodiscard]] std::int64_t size() const noexcept { return node_.size(); }
    // Back to `size` points: the last ones are taken out.
    void shrink(std::int64_t size) noexcept {
        while (node_.size() > size) {
            head_[bucket(node_.back().cell)] = node_.back().next;
            node_.resize(node_.size() - 1);
        }
    }

    // Calls visit(node) once for every point within `radius` of p, and for some that are farther away, as long as
    // it returns true.
    template <class Visit>
    void around(const glm::dvec3& p, double radius, Visit&& visit) const {
        const geometry::CellGrid::Cell low = grid_.cell_of(p - radius);
        const geometry::CellGrid::Cell high = grid_.cell_of(p + radius);
        for (std::int64_t z = low[2]; z <= high[2]; ++z)
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                for (std::int64_t x = low[0]; x <= high[0]; ++x) {
                    const std::uint64_t cell = geometry::CellGrid::pack({x, y, z});
                    for (std::int64_t i = head_[bucket(cell)]; i >= 0; i = node_[i].next)
                        if (node_[i].cell == cell && !visit(seen(node_[i]))) return;
                }
    }

private:
    // In one line of the cache: a search reads many.
    struct Kept {
        std::uint64_t cell;
        std::int64_t next;  // in the bucket; -1: none
        glm::vec3 position; // from the box's centre
        glm::vec3 normal, direction;
        std::int32_t stroke, place;
    };

    [[nodiscard]] Node seen(const Kept& kept) const noexcept {
        return {{centre_ + glm::dvec3(kept.position), glm::dvec3(kept.normal), glm::dvec3(kept.direction)},
                kept.stroke,
                kept.place};
    }
    [[nodiscard]] std::int64_t bucket(std::uint64_t cell) const noexcept {
        // Cells of a block of 4 x 4 x 4 stand together: a search asks for those around a point.
        const geometry::CellGrid::Cell c = geometry::CellGrid::unpack(cell);
        const std::uint64_t block = geometry::CellGrid::pack({c[0] / 4, c[1] / 4, c[2] / 4});
        const auto inner = static_cast<std::uint64_t>(c[0] % 4 + 4 * (c[1] % 4) + 16 * (c[2] % 4));
        return static_cast<std::int64_t>((geometry::mixed_bits(block) << 6U | inner) &
                                         static_cast<std::uint64_t>(head_.size() - 1));
    }
    // Threads the points anew in their order, so that the newest stands first in its bucket.
    void resize_table(std::int64_t size) {
        base::fill_long(head_, size, std::int64_t{-1}, progress_);
        for (std::int64_t i = 0; i < node_.size(); ++i) {
            if (i % 16384 == 0) progress_.check();
            std::int64_t& head = head_[bucket(node_[i].cell)];
            node_[i].next = head;
            head = i;
        }
    }

    geometry::CellGrid grid_;
    base::Progress progress_;
    glm::dvec3 centre_{0.0};
    base::Array<std::int64_t> head_; // of each bucket; a power of two
    base::Array<Kept> node_;
};

// Distances in object units.
struct TraceSettings {
    double step = 0.0;         // from point to point
    double test = 0.0;         // a stroke ends where it comes nearer than this to a parallel one
    double longest = 0.0;      // 0 = no limit
    double least_cosine = 0.9; // of the turn from point to point; sharper ones end the stroke
    std::int32_t thin = 1;     // every thin-th point stands in the grid
    bool turned = false;       // the second set of a line field
    geometry::Bounds region;   // strokes stay inside
    base::Progress progress;   // only looked at for a cancel
};

// Whether two points see each other as neighbours: on the same side, with strokes that run alike.
[[nodiscard]] inline bool run_alike(const StrokePoint& a, const StrokePoint& b) noexcept {
    constexpr double cosine = 0.7071067811865476; // 45 degrees: each stroke of a cross has its own
    return glm::dot(a.normal, b.normal) > 0.0 && std::abs(glm::dot(a.direction, b.direction)) > cosine;
}

// Squared distance by which strokes are kept apart: how near another one is ahead counts more than it is, so that
// strokes end nearer to the tip of one that they go on from than to one beside them, and leave no bald spots.
[[nodiscard]] inline double squared_clearance(const StrokePoint& from, const glm::dvec3& offset) noexcept {
    constexpr double stretch = 1.7;
    const double along = glm::dot(offset, from.direction);
    return glm::dot(offset, offset) + (stretch * stretch - 1.0) * along * along;
}

class Tracer {
public:
    Tracer(base::Memory& memory, const surface::DirectionField& field, StrokeGrid& grid) noexcept
        : field_(field), grid_(grid), ahead_(memory), behind_(memory) {}

    // The point of the field nearest to p, on the side of `normal`, with the direction nearest to `along`.
    // False where there is none.
    bool settle(const glm::dvec3& p, const glm::dvec3& normal, const glm::dvec3& along, bool turned,
                StrokePoint& point) const noexcept;
    // Both ways from `seed`.  The points stand in the grid as those of `stroke` afterwards.
    void trace(const StrokePoint& seed, std::int32_t stroke, const TraceSettings& settings);

    // Of the last stroke, from end to end.
    [[nodiscard]] std::int64_t count() const noexcept { return ahead_.size() + behind_.size(); }
    [[nodiscard]] const StrokePoint& point(std::int64_t i) const noexcept {
        return i < behind_.size() ? behind_[behind_.size() - 1 - i] : ahead_[i - behind_.size()];
    }
    // Its ends meet.
    [[nodiscard]] bool closed() const noexcept { return closed_; }

private:
    enum class Verdict { free, blocked, closes };

    bool advance(const StrokePoint& from, const TraceSettings& settings, StrokePoint& to) const noexcept;
    [[nodiscard]] Verdict look(const StrokePoint& point, std::int32_t stroke, std::int32_t place,
                               const TraceSettings& settings) const noexcept;
    void run(const StrokePoint& from, int side, std::int32_t stroke, std::int64_t most, const TraceSettings& settings);
    void close_up(const StrokePoint& end, std::int32_t stroke, std::int32_t place, const TraceSettings& settings);

    const surface::DirectionField& field_;
    StrokeGrid& grid_;
    base::Array<StrokePoint> ahead_;  // from the seed on
    base::Array<StrokePoint> behind_; // the other way, without the seed
    bool closed_ = false;
};

} // namespace hrbfnpr::strokes
