// SPDX-License-Identifier: MIT
// Weighted centres in an octree whose cubes act on far places like sources at a few nodes. This is one half of a fast
// multipole method (Greengard, Rokhlin 1987), with polynomials in place of multipoles, as in black-box methods (Fong,
// Darve, J. Comput. Phys. 228, 2009).
//
// Inside a cube, the sum over far sources is a triharmonic polynomial. Sources in a cube act on far places like sources
// at the cube's nodes whose weights give the same integral of every such polynomial.
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
    double spacing = 1.0;         // mean spacing of the centres
    int finer = 0;                // each step raises the polynomial degree by 2, and divides the error by about 10
    std::int64_t leaf_size = 600; // the most centres in a cube that is not divided
    double tolerance = 1e-8;      // error of sums with a fit's weights, relative to the fit's right-hand side
    int separation = 1;           // the fewest cubes between two cubes that act on each other by their nodes; 1 or 2
    double margin = 0.0;          // margin of the whole cube, relative to its width
};

class SourceTree {
public:
    // Throws Error{out_of_memory, cancelled}.
    SourceTree(const base::Work& work, const geometry::VecArray& centres, const SourceTreeOptions& options);

    // Sets the weights of the centres, given in the centres' order.
    void load(const double* alpha, const geometry::VecArray& beta, const base::Progress& progress);
    // Makes the weights at the nodes of each cube, for translate(). For few centres this takes longer than it saves.
    void gather(const base::Progress& progress);

    [[nodiscard]] const geometry::Octree& tree() const noexcept { return tree_; }
    [[nodiscard]] const CubeBasis& basis(std::int32_t level) const noexcept { return *at(level).basis; }
    // Returns the matrix from a level's nodes to the nodes of a child. Call gather() first; the child's level must
    // exist.
    [[nodiscard]] const base::Array<double>& to_child(std::int32_t level, int octant) const noexcept {
        return at(level).transfers->to_child[static_cast<std::size_t>(octant)];
    }
    // Cubes of the first two levels all touch each other.
    [[nodiscard]] static bool has_expansions(std::int32_t level) noexcept { return level >= 2; }
    // The vectors of all nodes, one after the other, padded for reading beyond the last.
    [[nodiscard]] std::int64_t vectors_begin(std::int32_t level) const noexcept { return at(level).begin; }
    [[nodiscard]] std::int64_t vectors_size() const noexcept { return vectors_size_; }
    // Returns centres [begin, end) in the tree's order, with their weights.
    [[nodiscard]] Sources sources(std::int64_t begin, std::int64_t end) const noexcept;

    // A cube that acts on another cube of its level that it does not touch.
    struct Pair {
        std::int32_t direction; // number of the offset, up to five cubes along each axis
        std::int32_t source;
        std::int32_t target;
    };
    [[nodiscard]] static std::int32_t direction(const std::array<std::int32_t, 3>& target,
                                                const std::array<std::int32_t, 3>& source) noexcept {
        return (target[0] - source[0] + 5) + 11 * (target[1] - source[1] + 5) + 121 * (target[2] - source[2] + 5);
    }
    // Returns the offset of the target from the source, in cubes.
    [[nodiscard]] static std::array<std::int32_t, 3> offset(std::int32_t direction) noexcept {
        return {direction % 11 - 5, direction / 11 % 11 - 5, direction / 121 - 5};
    }
    // Adds to nodes [first_row, last_row) of the targets, multiples of 8. Target t's vector is t basis strides after
    // `incoming`. Consecutive pairs of one direction share the work.
    void translate(std::int32_t level, std::span<const Pair> pairs, int first_row, int last_row, double* incoming,
                   const base::Progress& progress) const;

    // Frees the memory that only translate(), to_child() and the matrices of the bases need.
    void forget_expansions() noexcept;

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    // For each octant, the matrix from the nodes of a basis to the nodes of a child.
    struct Transfers {
        std::vector<base::Array<double>> to_child;
        std::vector<base::Array<double>> transposed;
    };
    // Levels of one degree share a basis. Pairs of levels with the same two degrees share transfers.
    struct Level {
        std::shared_ptr<CubeBasis> basis;
        std::shared_ptr<Transfers> transfers; // to the next level; null on the deepest
        std::int64_t begin = 0;               // start of its nodes' vectors
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
    base::Array<double> alpha_;    // in the tree's order
    geometry::VecArray beta_;
};

} // namespace hrbfnpr::implicit
