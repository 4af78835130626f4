// SPDX-License-Identifier: MIT
// Weighted centres in an octree. On far places, each cube acts like sources at a few nodes. This is half of a fast
// multipole method (Greengard, Rokhlin 1987), with polynomials in place of multipoles, as in black-box methods (Fong,
// Darve, J. Comput. Phys. 228, 2009).
//
// Inside a cube, the sum over far sources is a triharmonic polynomial. So sources in a cube act on far places like
// sources at the cube's nodes, if the weights of both give the same integral of each triharmonic polynomial.
#pragma once

#include "base/operation.h"
#include "base/work.h"
#include "geometry/octree.h"
#include "implicit/cube_basis.h"
#include "implicit/hermite_sums.h"

#include <memory>
#include <span>
#include <vector>

namespace hrbfnpr::implicit {

struct SourceTreeOptions {
    double spacing = 1.0; // mean spacing of the centres
    // The number of times that the polynomial degree is raised by 2. Each time divides the error by about 10.
    int finer = 0;
    // Cubes with at most this many centres are not divided.
    std::int64_t leaf_size = 600;
    // The allowed error of sums with the weights of a fit, relative to the right-hand side of the fit.
    double tolerance = 1e-8;
};

class SourceTree {
public:
    // Throws Error{out_of_memory, cancelled}.
    SourceTree(const base::Work& work, const geometry::VecArray& centres, const SourceTreeOptions& options);

    // Sets the weights of the centres, in the order of the centres.
    void load(const double* alpha, const geometry::VecArray& beta, const base::Progress& progress);
    // Computes the weights at the nodes of each cube, which translate() needs. With few centres this takes more time
    // than it saves.
    void gather(const base::Progress& progress);

    [[nodiscard]] const geometry::Octree& tree() const noexcept { return tree_; }
    [[nodiscard]] const CubeBasis& basis(std::int32_t level) const noexcept { return *at(level).basis; }
    // Returns the matrix that maps values at a level's nodes to values at the nodes of a child. gather() must be called
    // before, and the level of the child must exist.
    [[nodiscard]] const base::Array<double>& to_child(std::int32_t level, int octant) const noexcept {
        return at(level).transfers->to_child[static_cast<std::size_t>(octant)];
    }
    // Returns whether cubes of this level act by their nodes. Cubes of the first two levels do not, because all cubes
    // of one of these levels touch each other.
    [[nodiscard]] static bool has_expansions(std::int32_t level) noexcept { return level >= 2; }
    // The vectors of all nodes are stored one after the other, with padding after the last, so that vector loads may
    // read past it.
    [[nodiscard]] std::int64_t vectors_begin(std::int32_t level) const noexcept { return at(level).begin; }
    [[nodiscard]] std::int64_t vectors_size() const noexcept { return vectors_size_; }
    // Returns the centres [begin, end) in the order of the tree, with their weights.
    [[nodiscard]] Sources sources(std::int64_t begin, std::int64_t end) const noexcept;

    // A pair of cubes of one level that do not touch each other. One acts on the other.
    struct Pair {
        // Index of the offset between the cubes, which is at most five cubes along each axis.
        std::int32_t direction;
        std::int32_t source;
        std::int32_t target;
    };
    [[nodiscard]] static std::int32_t direction(const std::array<std::int32_t, 3>& target,
                                                const std::array<std::int32_t, 3>& source) noexcept {
        return (target[0] - source[0] + 5) + 11 * (target[1] - source[1] + 5) + 121 * (target[2] - source[2] + 5);
    }
    // Returns the offset from the source to the target, in cubes.
    [[nodiscard]] static std::array<std::int32_t, 3> offset(std::int32_t direction) noexcept {
        return {direction % 11 - 5, direction / 11 % 11 - 5, direction / 121 - 5};
    }
    // Adds the effect of the sources to the nodes [first_row, last_row) of the targets. Both bounds are multiples of 8.
    // The vector of target t begins t basis strides after `incoming`. Consecutive pairs with the same direction share
    // work.
    void translate(std::int32_t level, std::span<const Pair> pairs, int first_row, int last_row, double* incoming,
                   const base::Progress& progress) const;

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    // For each octant, the matrix that maps values at the nodes of a basis to values at the nodes of the child there.
    struct Transfers {
        std::vector<base::Array<double>> to_child;
        std::vector<base::Array<double>> transposed;
    };
    // Levels with the same degree share a basis. Pairs of consecutive levels with the same two degrees share transfers.
    struct Level {
        std::shared_ptr<CubeBasis> basis;
        std::shared_ptr<Transfers> transfers; // transfers to the next level; null on the deepest level
        std::int64_t begin = 0;               // index at which the vectors of the level's nodes begin
    };

    [[nodiscard]] const Level& at(std::int32_t level) const noexcept {
        return levels_[static_cast<std::size_t>(level)];
    }
    [[nodiscard]] int degree_of(std::int32_t level, const SourceTreeOptions& options) const noexcept;
    [[nodiscard]] std::shared_ptr<CubeBasis> find_basis(int degree, const base::Progress& progress) const;
    [[nodiscard]] std::shared_ptr<Transfers> find_transfers(std::int32_t level, const base::Progress& progress) const;
    void make_transfers(const base::Progress& progress);
    void gather_moments(std::int32_t level, const base::Progress& progress);
    void add_children(std::int64_t begin, std::int64_t end, std::int32_t level, const base::Progress& progress);
    [[nodiscard]] std::int64_t place(std::int64_t node, std::int32_t level) const noexcept {
        return at(level).begin + (node - tree_.level_begin(level)) * at(level).basis->stride();
    }
    [[nodiscard]] double* outgoing(std::int64_t node, std::int32_t level) noexcept {
        return outgoing_.data() + place(node, level);
    }
    [[nodiscard]] const double* outgoing(std::int64_t node, std::int32_t level) const noexcept {
        return outgoing_.data() + place(node, level);
    }

    const base::Runtime& runtime_;
    geometry::Octree tree_;
    std::vector<Level> levels_;
    std::int64_t vectors_size_ = 0;
    base::Array<double> outgoing_; // weights at the nodes of each cube
    base::Array<double> alpha_;    // weights in the order of the tree
    geometry::VecArray beta_;
};

} // namespace hrbfnpr::implicit
