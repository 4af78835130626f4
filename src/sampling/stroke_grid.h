// Where strokes run: their points in the buckets of a grid, which can be taken back in reverse order.
#pragma once

#include "geometry/point_grid.h"
#include "geometry/vec_array.h"

#include <algorithm>

namespace hrbfnpr::sampling {

// A point of a stroke while strokes are laid.
struct StrokePoint {
    glm::dvec3 position{0.0};
    glm::dvec3 normal{0.0};
    glm::dvec3 direction{0.0}; // unit, tangent, along the stroke
};

class StrokeGrid {
public:
    explicit StrokeGrid(base::Memory& memory) noexcept : head_(memory), node_(memory) {}

    // A point as it is seen by others.
    struct Node {
        StrokePoint point;
        std::int32_t stroke;
        std::int32_t place; // along the stroke, the seed at 0
    };

    // Empty, with cells of this side in this box.
    void reset(const geometry::Bounds& box, double side) {
        grid_ = {box.min, std::max(side, 1e-6 * box.diagonal())};
        centre_ = box.centre();
        node_.clear();
        resize_table(std::max<std::int64_t>(head_.size(), 1024));
    }
    void insert(const StrokePoint& point, std::int32_t stroke, std::int32_t place) {
        if (node_.size() >= head_.size()) resize_table(2 * head_.size());
        const std::uint64_t cell = geometry::CellGrid::pack(grid_.cell_of(point.position));
        std::int64_t& head = head_[bucket(cell)];
        node_.push_back({cell, head, glm::vec3(point.position - centre_), glm::vec3(point.normal),
                         glm::vec3(point.direction), stroke, place});
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
        head_.resize(size);
        for (std::int64_t& head : head_) head = -1;
        for (std::int64_t i = 0; i < node_.size(); ++i) {
            std::int64_t& head = head_[bucket(node_[i].cell)];
            node_[i].next = head;
            head = i;
        }
    }

    geometry::CellGrid grid_;
    glm::dvec3 centre_{0.0};
    base::Array<std::int64_t> head_; // of each bucket; a power of two
    base::Array<Kept> node_;
};

} // namespace hrbfnpr::sampling
