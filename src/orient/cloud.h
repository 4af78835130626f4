// SPDX-License-Identifier: MIT
// The points for which normals are found, their neighbours, and planes through the neighbours.
#pragma once

#include "base/operation.h"
#include "base/view.h"
#include "base/work.h"
#include "geometry/point_tree.h"

#include <array>
#include <memory>
#include <span>

namespace hrbfnpr::orient {

// Points in the order of a tree. Their spacing is about 1, and each has its rank in a farthest-first order. A "place"
// is the index of a point in the order of the tree.
struct OrderedPoints {
    explicit OrderedPoints(base::Memory& memory) noexcept : rank(memory) {}

    [[nodiscard]] std::int64_t size() const noexcept { return tree->size(); }
    [[nodiscard]] glm::dvec3 point(std::int64_t at) const noexcept { return tree->points()[at]; }

    std::unique_ptr<geometry::PointTree> tree;
    base::Array<std::int64_t> rank;
};

// All points of a caller: centred, scaled to spacing 1, and merged where they coincide.
struct Cloud : OrderedPoints {
    explicit Cloud(base::Memory& memory) noexcept : OrderedPoints(memory), place(memory), rank_spacing(memory) {}

    [[nodiscard]] bool is_of_curves() const noexcept { return spread_count > 0; }

    base::Array<std::int64_t> place;  // the place of each given point
    base::Array<double> rank_spacing; // for each rank, the distance to the nearest point of a lower rank
    glm::dvec3 centre{0.0};
    double spacing = 1.0; // median distance to the nearest other point, in the caller's unit
    std::int64_t merged = 0;
    // If the points lie along curves, neighbours define no plane. This is then the number of points at the beginning of
    // the farthest-first order that spread evenly over the whole surface on which the curves lie. Otherwise it is 0.
    std::int64_t spread_count = 0;
};

// Throws Error{invalid_argument} naming "points" if a number is not finite, if fewer than 4 points differ, or if all
// lie on one line.
[[nodiscard]] Cloud read_cloud(const base::Work& work, const base::InView& points);

// The first places of a cloud's farthest-first order, in the order of a separate tree.
struct CoarsePoints : OrderedPoints {
    CoarsePoints(const base::Work& work, const Cloud& cloud, std::int64_t count);

    // Returns those elements of an array for the whole cloud that belong to the first places.
    [[nodiscard]] geometry::VecArray pick(const geometry::VecArray& normal) const;

    base::Array<std::int64_t> place; // for each first place: its place in the whole cloud
};

// Calls f(place) for all places, on all threads.
template <class F>
void for_places(const base::Work& work, std::int64_t count, F&& f) {
    work.for_chunks(count, 512, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t at = begin; at < end; ++at) f(at);
    });
}

// The nearest neighbours of every place, nearest first, without the place itself.
class NeighbourLists {
public:
    static constexpr std::int64_t most = 63;      // the largest number of neighbours that the tree finds
    static constexpr std::int64_t of_spacing = 6; // The local spacing is the mean distance to this many neighbours.

    NeighbourLists(const base::Work& work, const geometry::PointTree& tree, std::int64_t each);

    [[nodiscard]] std::int64_t each() const noexcept { return each_; }
    // Returns the `count` nearest neighbours, or all if there are fewer.
    [[nodiscard]] std::span<const std::int32_t> of(std::int64_t at, std::int64_t count = most) const noexcept {
        return index_.span().subspan(static_cast<std::size_t>(at * each_),
                                     static_cast<std::size_t>(count < each_ ? count : each_));
    }

private:
    std::int64_t each_;
    base::Array<std::int32_t> index_;
};

// Returns the mean distance from each place to its NeighbourLists::of_spacing nearest neighbours. The area that a place
// stands for is proportional to the square of this distance.
[[nodiscard]] base::Array<double> local_spacing(const base::Runtime& runtime, const geometry::PointTree& tree,
                                                const NeighbourLists& near);

// Returns the number of components that places form when near neighbours are connected.
[[nodiscard]] std::int64_t count_components(const base::Runtime& runtime, const geometry::PointTree& tree,
                                            const NeighbourLists& near);

struct Moments {
    double count = 0.0;
    glm::dvec3 sum{0.0};
    std::array<double, 6> square{}; // The second moments: xx xy xz yy yz zz.

    void add(const glm::dvec3& p, double weight = 1.0) noexcept;
};

struct Plane {
    glm::dvec3 centre{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};
    std::array<double, 3> variance{}; // in ascending order
};
[[nodiscard]] Plane plane_of(const Moments& moments) noexcept;

// Returns unit normals of the planes through each place and its nearest `count` neighbours. Their signs are arbitrary.
[[nodiscard]] geometry::VecArray plane_normals(const base::Work& work, const geometry::PointTree& tree,
                                               const NeighbourLists& near, std::int64_t count);

// Returns the share of places whose normals point the same way in both arrays. If less than half do, returns the share
// whose normals are opposite.
[[nodiscard]] double share_alike(const geometry::VecArray& a, const geometry::VecArray& b) noexcept;

} // namespace hrbfnpr::orient
