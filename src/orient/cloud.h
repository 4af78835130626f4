// SPDX-License-Identifier: MIT
// Points that are to get normals, their neighbours, and planes through these.
#pragma once

#include "base/operation.h"
#include "base/view.h"
#include "base/work.h"
#include "geometry/point_tree.h"

#include <array>
#include <memory>
#include <span>

namespace hrbfnpr::orient {

// Points in a tree's order, about 1 apart, and the rank of each in their farthest-first order. A place is an index into
// the tree's order.
struct Places {
    explicit Places(base::Memory& memory) noexcept : rank(memory) {}

    [[nodiscard]] std::int64_t size() const noexcept { return tree->size(); }
    [[nodiscard]] glm::dvec3 point(std::int64_t at) const noexcept { return tree->points()[at]; }

    std::unique_ptr<geometry::PointTree> tree;
    base::Array<std::int64_t> rank;
};

// All points of a caller: centred, scaled to spacing 1, and merged where they coincide.
struct Cloud : Places {
    explicit Cloud(base::Memory& memory) noexcept : Places(memory), place(memory), apart(memory) {}

    [[nodiscard]] bool is_of_curves() const noexcept { return all_over > 0; }

    base::Array<std::int64_t> place; // of each given point
    base::Array<double> apart;       // of each rank, the distance from those before
    glm::dvec3 centre{0.0};
    double spacing = 1.0; // median distance to the nearest other point, in the caller's unit
    std::int64_t merged = 0;
    // If points lie along curves, whose neighbours tell no plane: the number of first places of the farthest-first
    // order that stand all over the surface that the curves lie on. Else 0.
    std::int64_t all_over = 0;
};

// Throws Error{invalid_argument} naming "points" if a number is not finite, if fewer than 4 points differ, or if all
// lie on one line.
[[nodiscard]] Cloud read_cloud(const base::Work& work, const base::InView& points);

// The first places of a cloud's farthest-first order, in an order of their own.
struct FirstPlaces : Places {
    FirstPlaces(const base::Work& work, const Cloud& cloud, std::int64_t count);

    // Returns the elements of the whole cloud's array that belong to these places.
    [[nodiscard]] geometry::VecArray pick(const geometry::VecArray& normal) const;

    base::Array<std::int64_t> place; // in the whole cloud
};

// Calls f(place) for all places, on all threads.
template <class F>
void for_places(const base::Work& work, std::int64_t count, F&& f) {
    work.for_chunks(count, 512, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t at = begin; at < end; ++at) f(at);
    });
}

// The nearest neighbours of every place, nearest first, without itself.
class Near {
public:
    static constexpr std::int64_t most = 63;      // the tree finds no more
    static constexpr std::int64_t of_spacing = 6; // neighbours whose mean distance is a local spacing

    Near(const base::Work& work, const geometry::PointTree& tree, std::int64_t each);

    [[nodiscard]] std::int64_t each() const noexcept { return each_; }
    // The `count` nearest ones, or all if there are fewer.
    [[nodiscard]] std::span<const std::int32_t> of(std::int64_t at, std::int64_t count = most) const noexcept {
        return index_.span().subspan(static_cast<std::size_t>(at * each_),
                                     static_cast<std::size_t>(count < each_ ? count : each_));
    }

private:
    std::int64_t each_;
    base::Array<std::int32_t> index_;
};

// Returns the mean distance to the nearest neighbours of each place: a place stands for an area that is proportional to
// its square.
[[nodiscard]] base::Array<double> local_spacing(const base::Runtime& runtime, const geometry::PointTree& tree,
                                                const Near& near);

// Returns the number of sets of places that neighbours connect.
[[nodiscard]] std::int64_t count_pieces(const base::Runtime& runtime, const geometry::PointTree& tree,
                                        const Near& near);

struct Moments {
    double count = 0.0;
    glm::dvec3 sum{0.0};
    std::array<double, 6> square{}; // xx xy xz yy yz zz

    void add(const glm::dvec3& p, double weight = 1.0) noexcept;
};

struct Plane {
    glm::dvec3 centre{0.0};
    glm::dvec3 normal{0.0, 0.0, 1.0};
    std::array<double, 3> variance{}; // ascending
};
[[nodiscard]] Plane plane_of(const Moments& moments) noexcept;

// Returns unit normals, of any sign, of the planes through each place and its nearest `count` neighbours.
[[nodiscard]] geometry::VecArray plane_normals(const base::Work& work, const geometry::PointTree& tree,
                                               const Near& near, std::int64_t count);

// Returns the share of places whose signs are the same, or of those whose signs differ if these are more: 0.5 .. 1.
[[nodiscard]] double share_alike(const geometry::VecArray& a, const geometry::VecArray& b) noexcept;

} // namespace hrbfnpr::orient
