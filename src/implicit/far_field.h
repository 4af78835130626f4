// The sums of hermite_sums.h for the triharmonic kernel and many sources, whose time grows with N, not N^2: a fast
// multipole method (Greengard, Rokhlin 1987) on an adaptive octree, with polynomials in place of multipoles, as
// black-box methods have them (Fong, Darve, J. Comput. Phys. 228, 2009).
//
// Inside a cube, what far sources sum up to is a polynomial of a total degree in place; and sources in a cube act on
// far targets like sources at the cube's nodes, with weights such that all such polynomials are integrated alike.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/octree.h"
#include "implicit/cube_basis.h"

#include <vector>

namespace hrbfnpr::implicit {

class FarField {
public:
    struct Options {
        double spacing = 1.0;         // of the centres, mean
        int finer = 0;                // steps of two degrees: each divides the error by about 10
        std::int64_t leaf_size = 600; // centres in a cube that is not divided
        double tolerance = 1e-8;      // of sums with a fit's weights, relative to its right-hand side
    };

    // Of these centres, which are targets too.  Throws Error{out_of_memory, cancelled}.
    FarField(const base::Runtime& runtime, const geometry::VecArray& centres, const Options& options,
             const base::Progress& progress);

    // value = sum of equation 1 and gradient at all centres, in their order.  Not thread-safe.
    void sum(const double* alpha, const geometry::VecArray& beta, double* value, geometry::VecArray& gradient,
             const base::Progress& progress);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    // What cubes of one level share.
    struct Level {
        CubeBasis basis;
        // From this level's nodes to those of a child, for each octant; empty on the deepest level.
        std::vector<base::Array<double>> to_child;
        std::vector<base::Array<double>> to_child_transposed;
        std::int64_t begin = 0; // of its nodes' vectors, in outgoing_ and incoming_
    };
    struct FarPair {
        std::int32_t direction; // which of the 343 offsets
        std::int32_t source;
        std::int32_t target;
    };
    struct TranslateTask {
        std::int64_t begin; // in pairs_
        std::int64_t end;
        int first_row; // nodes of each target
        int last_row;
        std::int32_t level;
    };

    [[nodiscard]] int degree_of(std::int32_t level, const Options& options) const noexcept;
    void make_levels(const Options& options, const base::Progress& progress);
    void make_transfers(std::int32_t level);
    void sort_pairs(const base::Progress& progress);
    void load(const double* alpha, const geometry::VecArray& beta);
    void gather_moments(std::int32_t level, const base::Progress& progress);
    void add_children(std::int64_t begin, std::int64_t end, std::int32_t level);
    void translate(std::int32_t level, std::int64_t first_group, const base::Progress& progress);
    void translate_group(const TranslateTask& task);
    void pass_down(std::int32_t level, const base::Progress& progress);
    void evaluate_leaves(const base::Progress& progress);
    void evaluate_leaf(std::int64_t node);
    void add_near(const geometry::Octree::Node& target, std::int64_t node);
    [[nodiscard]] bool has_expansions(std::int32_t level) const noexcept { return level >= 2; }
    [[nodiscard]] double* outgoing(std::int64_t node, std::int32_t level) noexcept;
    [[nodiscard]] double* incoming(std::int64_t node, std::int32_t level) noexcept;

    const base::Runtime& runtime_;
    geometry::Octree tree_;
    geometry::OctreeInteractions lists_;
    std::vector<Level> levels_;
    base::Array<FarPair> pairs_;            // by groups of targets, then direction, then target
    base::Array<std::int64_t> group_begin_; // of each group of translate_cubes nodes, in pairs_
    base::Array<double> outgoing_;          // weights at the nodes of each cube
    base::Array<double> incoming_;          // values at them
    base::Array<double> alpha_;             // in the tree's order
    geometry::VecArray beta_;
    base::Array<double> value_;
    geometry::VecArray gradient_;
    base::Array<std::int64_t> leaves_;
};

} // namespace hrbfnpr::implicit
