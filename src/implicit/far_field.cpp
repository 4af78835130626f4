// SPDX-License-Identifier: MIT
#include "implicit/far_field.h"

#include "implicit/cube_loops.h"
#include "implicit/cube_vectors.h"
#include "implicit/hermite_sums.h"

#include <algorithm>
#include <span>

namespace hrbfnpr::implicit {
namespace {

constexpr std::int64_t chunk = 32; // number of cubes in a task
// The number of target cubes in a task of a translation. These cubes share the elements of the translation's matrix.
constexpr std::int64_t translate_cubes = 256;
constexpr std::int64_t translate_tasks = 16;

} // namespace

FarField::FarField(const base::Work& work, const geometry::VecArray& centres, const SourceTreeOptions& options)
    : runtime_(work), sources_(work, centres, options), tree_(sources_.tree()),
      lists_(geometry::octree_interactions(tree_, work)), pairs_(work.memory), group_begin_(work.memory),
      incoming_(work.memory, sources_.vectors_size()), value_(work.memory, centres.size()),
      gradient_(work.memory, centres.size()), leaves_(work.memory) {
    for (std::int64_t node = 0; node < tree_.nodes().size(); ++node)
        if (tree_.nodes()[node].leaf()) leaves_.push_back(node);
    sort_pairs(work);
}

double* FarField::incoming(std::int64_t node, std::int32_t level) noexcept {
    return first_incoming(level) + node * sources_.basis(level).stride();
}

// Returns where the vector of node 0 would be if all nodes were on this level, so that the vector of a node can be
// found by its index.
double* FarField::first_incoming(std::int32_t level) noexcept {
    return incoming_.data() + sources_.vectors_begin(level) - tree_.level_begin(level) * sources_.basis(level).stride();
}

void FarField::sum(const double* alpha, const geometry::VecArray& beta, double* value, geometry::VecArray& gradient,
                   const base::Progress& progress) {
    sources_.load(alpha, beta, progress);
    sources_.gather(progress);
    progress.check();
    std::fill(incoming_.begin(), incoming_.end(), 0.0);
    std::int64_t group = 0;
    for (std::int32_t level = 0; level < tree_.levels(); ++level) {
        const std::int64_t cubes = tree_.level_end(level) - tree_.level_begin(level);
        if (SourceTree::has_expansions(level)) {
            translate(level, group, progress);
            pass_down(level, progress);
        }
        group += (cubes + translate_cubes - 1) / translate_cubes;
    }
    evaluate_leaves(progress);
    for (const std::int64_t at : progress.over(tree_.points().size())) {
        value[tree_.index(at)] = value_[at];
        gradient.set(tree_.index(at), gradient_[at]);
    }
}

// Sorts pairs by groups of neighbouring targets. Within a group, pairs with the same offset are consecutive.
void FarField::sort_pairs(const base::Progress& progress) {
    pairs_.resize(lists_.far.size());
    group_begin_.push_back(0);
    for (std::int32_t level = 0; level < tree_.levels(); ++level)
        for (std::int64_t begin = tree_.level_begin(level); begin < tree_.level_end(level); begin += translate_cubes) {
            progress.check();
            const std::int64_t end = std::min(tree_.level_end(level), begin + translate_cubes);
            for (std::int64_t target = begin; target < end; ++target)
                for (std::int64_t k = lists_.far_begin[target]; k < lists_.far_begin[target + 1]; ++k) {
                    const auto& t = tree_.nodes()[target].cell;
                    const auto& s = tree_.nodes()[lists_.far[k]].cell;
                    pairs_[k] = {SourceTree::direction(t, s), static_cast<std::int32_t>(lists_.far[k]),
                                 static_cast<std::int32_t>(target)};
                }
            std::sort(pairs_.begin() + lists_.far_begin[begin], pairs_.begin() + lists_.far_begin[end],
                      [](const SourceTree::Pair& a, const SourceTree::Pair& b) {
                          return a.direction != b.direction ? a.direction < b.direction : a.target < b.target;
                      });
            group_begin_.push_back(lists_.far_begin[end]);
        }
    lists_.far.release();
}

// A task handles a group of targets and a part of their cubes' nodes. So there are enough tasks even on levels with few
// cubes.
void FarField::translate(std::int32_t level, std::int64_t first_group, const base::Progress& progress) {
    const std::int64_t cubes = tree_.level_end(level) - tree_.level_begin(level);
    const std::int64_t groups = (cubes + translate_cubes - 1) / translate_cubes;
    const std::int64_t rows = sources_.basis(level).stride();
    const std::int64_t parts = std::clamp<std::int64_t>(translate_tasks / groups, 1, rows / 8);
    runtime_.parallel.for_each(groups * parts, progress, [&](std::int64_t task) {
        const std::int64_t group = first_group + task / parts;
        const std::int64_t part = task % parts;
        const std::span<const SourceTree::Pair> pairs(pairs_.data() + group_begin_[group],
                                                      pairs_.data() + group_begin_[group + 1]);
        sources_.translate(level, pairs, static_cast<int>(part * (rows / 8) / parts * 8),
                           static_cast<int>((part + 1) * (rows / 8) / parts * 8), first_incoming(level), progress);
    });
}

void FarField::pass_down(std::int32_t level, const base::Progress& progress) {
    if (level + 1 == tree_.levels()) return;
    const CubeBasis& basis = sources_.basis(level);
    const CubeBasis& child_basis = sources_.basis(level + 1);
    const CubeLoops loops = cube_loops(runtime_.instruction_set);
    const std::int64_t first = tree_.level_begin(level);
    runtime_.parallel.for_chunks(
        tree_.level_end(level) - first, chunk, progress, [&](std::int64_t begin, std::int64_t end) {
            base::Array<double> nobody(runtime_.memory, child_basis.stride());
            CubeVectors batch(runtime_.memory, basis.size());
            for (int octant = 0; octant < 8; ++octant) {
                const auto flush = [&] {
                    if (batch.empty()) return;
                    progress.check();
                    loops.multiply(sources_.to_child(level, octant).data(), child_basis.stride(), child_basis.stride(),
                                   basis.size(), batch.in(), batch.out(nobody.data()), batch.count());
                    batch.clear();
                };
                for (std::int64_t node = first + begin; node < first + end; ++node) {
                    const geometry::Octree::Node& cube = tree_.nodes()[node];
                    for (std::int64_t child = cube.first_child; child < cube.first_child + cube.children; ++child)
                        if (geometry::Octree::octant(tree_.nodes()[child]) == octant)
                            batch.add(incoming(node, level), basis.size(), incoming(child, level + 1));
                    if (batch.full()) flush();
                }
                flush();
            }
        });
}

void FarField::evaluate_leaves(const base::Progress& progress) {
    runtime_.parallel.for_chunks(leaves_.size(), 4, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t k = begin; k < end; ++k) {
            progress.check();
            evaluate_leaf(leaves_[k]);
        }
    });
}

void FarField::evaluate_leaf(std::int64_t node) {
    const geometry::Octree::Node& leaf = tree_.nodes()[node];
    double* const sums[4] = {value_.data() + leaf.begin, gradient_.x.data() + leaf.begin,
                             gradient_.y.data() + leaf.begin, gradient_.z.data() + leaf.begin};
    for (double* const sum : sums) std::fill_n(sum, leaf.count(), 0.0);
    for (std::int64_t at = node;; at = tree_.nodes()[at].parent) {
        add_near(leaf, at);
        if (at == 0) break;
    }
    if (!SourceTree::has_expansions(leaf.level)) return;
    const CubeBasis& basis = sources_.basis(leaf.level);
    const CubeLoops loops = cube_loops(runtime_.instruction_set);
    base::Array<double> terms(runtime_.memory, basis.term_stride());
    CubeVectors batch(runtime_.memory, basis.size());
    batch.add(incoming(node, leaf.level), basis.size(), terms.data());
    loops.multiply(basis.to_coefficients().data(), basis.term_stride(), basis.term_stride(), basis.size(), batch.in(),
                   batch.out(terms.data()), 1);
    const glm::dvec3 centre = tree_.centre(leaf);
    const geometry::VecArray& p = tree_.points();
    loops.evaluate(basis.degree(), terms.data(),
                   {p.x.data() + leaf.begin,
                    p.y.data() + leaf.begin,
                    p.z.data() + leaf.begin,
                    leaf.count(),
                    {centre.x, centre.y, centre.z},
                    tree_.half_width(leaf.level)},
                   sums[0], sums + 1);
}

void FarField::add_near(const geometry::Octree::Node& target, std::int64_t node) {
    const AddHermiteSums add = hermite_sums(runtime_.instruction_set, kernel::Kind::triharmonic);
    const geometry::VecArray& p = tree_.points();
    for (std::int64_t k = lists_.near_begin[node]; k < lists_.near_begin[node + 1]; ++k) {
        const geometry::Octree::Node& source = tree_.nodes()[lists_.near[k]];
        const std::int64_t t = target.begin;
        add(0.0, sources_.sources(source.begin, source.end),
            {p.x.data() + t, p.y.data() + t, p.z.data() + t, value_.data() + t, gradient_.x.data() + t,
             gradient_.y.data() + t, gradient_.z.data() + t, target.count()});
    }
}

std::int64_t FarField::bytes() const noexcept {
    return sources_.bytes() + incoming_.bytes() + value_.bytes() + gradient_.bytes() + pairs_.bytes();
}

} // namespace hrbfnpr::implicit
