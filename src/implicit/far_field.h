// SPDX-License-Identifier: MIT

// Computes the sums of hermite_sums.h for the triharmonic kernel, where many sources are the targets, too. It uses a
// fast multipole method on the octree of source_tree.h, so the time grows with N and not with N^2.
#pragma once

#include "implicit/source_tree.h"

namespace hrbfnpr::implicit {

class FarField {
public:
    // `centres` are both sources and targets. Throws Error{out_of_memory, cancelled}.
    FarField(const base::Work& work, const geometry::VecArray& centres, const SourceTreeOptions& options);

    // Writes the sum of equation 1 and its gradient at all centres, in the centres' order. Not thread-safe.
    void sum(const double* alpha, const geometry::VecArray& beta, double* value, geometry::VecArray& gradient,
             const base::Progress& progress);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void sort_pairs(const base::Progress& progress);
    void translate(std::int32_t level, std::int64_t first_group, const base::Progress& progress);
    void pass_down(std::int32_t level, const base::Progress& progress);
    void evaluate_leaves(const base::Progress& progress);
    void evaluate_leaf(std::int64_t node);
    void add_near(const geometry::Octree::Node& target, std::int64_t node);
    [[nodiscard]] double* incoming(std::int64_t node, std::int32_t level) noexcept;
    [[nodiscard]] double* first_incoming(std::int32_t level) noexcept;

    const base::Runtime& runtime_;
    SourceTree sources_;
    const geometry::Octree& tree_; // the tree of sources_
    geometry::OctreeInteractions lists_;
    base::Array<SourceTree::Pair> pairs_; // sorted by group of targets, then direction, then target
    // For each group of translate_cubes nodes, the index of its first pair in pairs_.
    base::Array<std::int64_t> group_begin_;
    base::Array<double> incoming_; // values at the nodes of each cube
    base::Array<double> value_;    // the results, in the tree's order of centres
    geometry::VecArray gradient_;
    base::Array<std::int64_t> leaves_;
};

} // namespace hrbfnpr::implicit
