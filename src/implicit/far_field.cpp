#include "implicit/far_field.h"

#include "implicit/cube_loops.h"
#include "implicit/hermite_sums.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::implicit {
namespace {

constexpr std::int64_t chunk = 32; // cubes of a task
// Of a translation's task, which share the elements.
constexpr std::int64_t translate_cubes = 256;
constexpr std::int64_t translate_tasks = 16;

// Vectors that stand side by side for cube_loops, and where the results go.
class Batch {
public:
    explicit Batch(base::Memory& memory, int columns) : in_(memory, std::int64_t{columns} * cube_batch) {}

    void add(const double* in, int columns, double* out) noexcept {
        for (int k = 0; k < columns; ++k) in_[std::int64_t{k} * cube_batch + count_] = in[k];
        out_[static_cast<std::size_t>(count_++)] = out;
    }
    [[nodiscard]] bool full() const noexcept { return count_ == cube_batch; }
    [[nodiscard]] bool empty() const noexcept { return count_ == 0; }
    [[nodiscard]] int count() const noexcept { return count_; }
    [[nodiscard]] const double* in() const noexcept { return in_.data(); }
    // The places beyond count() are written where nobody looks.
    [[nodiscard]] double* const* out(double* nobody) noexcept {
        std::fill(out_.begin() + count_, out_.end(), nobody);
        return out_.data();
    }
    void clear() noexcept { count_ = 0; }

private:
    base::Array<double> in_;
    std::array<double*, cube_batch> out_{};
    int count_ = 0;
};

[[nodiscard]] geometry::VecArray in_parent(const CubeBasis& child, int octant) {
    geometry::VecArray points(child.nodes().memory(), child.size());
    const glm::dvec3 centre(octant & 1 ? 0.5 : -0.5, octant & 2 ? 0.5 : -0.5, octant & 4 ? 0.5 : -0.5);
    for (std::int64_t i = 0; i < child.size(); ++i) points.set(i, centre + 0.5 * child.nodes()[i]);
    return points;
}

// columns of `rows` numbers become rows: `columns` numbers, padded.
[[nodiscard]] base::Array<double> transposed(const base::Array<double>& matrix, int rows, int columns) {
    const std::int64_t from = CubeBasis::padded(rows);
    const std::int64_t to = CubeBasis::padded(columns);
    base::Array<double> result(matrix.memory(), to * rows);
    for (std::int64_t j = 0; j < columns; ++j)
        for (std::int64_t i = 0; i < rows; ++i) result[i * to + j] = matrix[j * from + i];
    return result;
}

} // namespace

FarField::FarField(const base::Runtime& runtime, const geometry::VecArray& centres, const Options& options,
                   const base::Progress& progress)
    : runtime_(runtime), tree_(centres, options.leaf_size, progress), lists_(geometry::octree_interactions(tree_)),
      pairs_(runtime.memory), group_begin_(runtime.memory), outgoing_(runtime.memory), incoming_(runtime.memory),
      alpha_(runtime.memory, centres.size()), beta_(runtime.memory, centres.size()),
      value_(runtime.memory, centres.size()), gradient_(runtime.memory, centres.size()), leaves_(runtime.memory) {
    for (std::int64_t node = 0; node < tree_.nodes().size(); ++node)
        if (tree_.nodes()[node].leaf()) leaves_.push_back(node);
    make_levels(options, progress);
    sort_pairs(progress);
}

// The error of a pair of cubes is about (half width)^3 2.9^-degree, relative to their weights.
//
// Conjugate gradients need it below the smallest eigenvalue, which is as (spacing)^3: so two degrees more for twice the
// width.  That constant was found by trying even samples: three degrees less, fits of 65 000 break down; one less, they
// take half as many iterations again.
//
// A fit's weights are as (spacing)^2, and what its many far pairs are off adds up like noise, to (spacing) times as
// much.  That constant, too, was found by trying: 24 000 to 262 144 even samples.
int FarField::degree_of(std::int32_t level, const Options& options) const noexcept {
    if (!has_expansions(level)) return 0; // there are no far cubes
    const double width = std::max(1.0, tree_.half_width(level) / options.spacing);
    const double all = std::max(1.0, tree_.half_width(0) / options.spacing);
    const double to_converge = 2.0 * std::log2(width) + 6.1;
    const double error = std::pow(width / all, 3.0) / (all * options.tolerance);
    const double to_be_exact = std::log(std::max(1.0, error)) / std::log(2.9) + 7.1;
    const int degree = static_cast<int>(std::ceil(std::max(to_converge, to_be_exact))) + 2 * options.finer;
    return std::clamp(degree, 4, CubeBasis::degree_max);
}

void FarField::make_levels(const Options& options, const base::Progress& progress) {
    std::int64_t size = 0;
    for (std::int32_t level = 0; level < tree_.levels(); ++level) {
        const int degree = degree_of(level, options);
        levels_.push_back({CubeBasis(runtime_, degree, progress), {}, {}, size});
        size += levels_.back().basis.stride() * (tree_.level_end(level) - tree_.level_begin(level));
    }
    for (std::int32_t level = 2; level + 1 < tree_.levels(); ++level) make_transfers(level);
    outgoing_.resize(size + CubeBasis::padded(CubeBasis::terms(CubeBasis::degree_max)));
    incoming_.resize(outgoing_.size());
}

void FarField::make_transfers(std::int32_t level) {
    Level& here = levels_[static_cast<std::size_t>(level)];
    const CubeBasis& child = levels_[static_cast<std::size_t>(level) + 1].basis;
    for (int octant = 0; octant < 8; ++octant) {
        here.to_child.push_back(here.basis.interpolation(runtime_, in_parent(child, octant), child.size()));
        here.to_child_transposed.push_back(transposed(here.to_child.back(), child.size(), here.basis.size()));
    }
}

double* FarField::outgoing(std::int64_t node, std::int32_t level) noexcept {
    const Level& here = levels_[static_cast<std::size_t>(level)];
    return outgoing_.data() + here.begin + (node - tree_.level_begin(level)) * here.basis.stride();
}

double* FarField::incoming(std::int64_t node, std::int32_t level) noexcept {
    return incoming_.data() + (outgoing(node, level) - outgoing_.data());
}

void FarField::load(const double* alpha, const geometry::VecArray& beta) {
    for (std::int64_t at = 0; at < tree_.points().size(); ++at) {
        alpha_[at] = alpha[tree_.index(at)];
        beta_.set(at, beta[tree_.index(at)]);
    }
}

void FarField::sum(const double* alpha, const geometry::VecArray& beta, double* value, geometry::VecArray& gradient,
                   const base::Progress& progress) {
    load(alpha, beta);
    std::fill(outgoing_.begin(), outgoing_.end(), 0.0);
    std::fill(incoming_.begin(), incoming_.end(), 0.0);
    for (std::int32_t level = tree_.levels() - 1; level >= 2; --level) gather_moments(level, progress);
    std::int64_t group = 0;
    for (std::int32_t level = 0; level < tree_.levels(); ++level) {
        const std::int64_t cubes = tree_.level_end(level) - tree_.level_begin(level);
        if (has_expansions(level)) {
            translate(level, group, progress);
            pass_down(level, progress);
        }
        group += (cubes + translate_cubes - 1) / translate_cubes;
    }
    evaluate_leaves(progress);
    for (std::int64_t at = 0; at < tree_.points().size(); ++at) {
        value[tree_.index(at)] = value_[at];
        gradient.set(tree_.index(at), gradient_[at]);
    }
}

// Weights at the nodes, of sources in leaves and of what children have at theirs.
void FarField::gather_moments(std::int32_t level, const base::Progress& progress) {
    const CubeBasis& basis = levels_[static_cast<std::size_t>(level)].basis;
    const CubeLoops loops = cube_loops(runtime_.instruction_set);
    const std::int64_t first = tree_.level_begin(level);
    runtime_.parallel.for_chunks(tree_.level_end(level) - first, chunk, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        base::Array<double> terms(runtime_.memory, basis.terms());
        base::Array<double> nobody(runtime_.memory, basis.stride());
        Batch batch(runtime_.memory, basis.terms());
        const auto flush = [&] {
            if (batch.empty()) return;
            loops.multiply(basis.to_coefficients_transposed().data(), basis.stride(), basis.stride(), basis.terms(),
                           batch.in(), batch.out(nobody.data()), batch.count());
            batch.clear();
        };
        for (std::int64_t node = first + begin; node < first + end; ++node) {
            const geometry::Octree::Node& cube = tree_.nodes()[node];
            if (!cube.leaf()) continue;
            const glm::dvec3 centre = tree_.centre(cube);
            const double* const beta[3] = {beta_.x.data() + cube.begin, beta_.y.data() + cube.begin,
                                           beta_.z.data() + cube.begin};
            const geometry::VecArray& p = tree_.points();
            loops.moments(basis.degree(),
                          {p.x.data() + cube.begin,
                           p.y.data() + cube.begin,
                           p.z.data() + cube.begin,
                           cube.count(),
                           {centre.x, centre.y, centre.z},
                           tree_.half_width(level)},
                          alpha_.data() + cube.begin, beta, terms.data());
            batch.add(terms.data(), basis.terms(), outgoing(node, level));
            if (batch.full()) flush();
        }
        flush();
        add_children(first + begin, first + end, level);
    });
}

void FarField::add_children(std::int64_t begin, std::int64_t end, std::int32_t level) {
    if (level + 1 == tree_.levels()) return;
    const Level& here = levels_[static_cast<std::size_t>(level)];
    const CubeBasis& child_basis = levels_[static_cast<std::size_t>(level) + 1].basis;
    const CubeLoops loops = cube_loops(runtime_.instruction_set);
    base::Array<double> nobody(runtime_.memory, here.basis.stride());
    Batch batch(runtime_.memory, child_basis.size());
    for (int octant = 0; octant < 8; ++octant) {
        const auto flush = [&] {
            if (batch.empty()) return;
            loops.multiply(here.to_child_transposed[static_cast<std::size_t>(octant)].data(), here.basis.stride(),
                           here.basis.stride(), child_basis.size(), batch.in(), batch.out(nobody.data()),
                           batch.count());
            batch.clear();
        };
        for (std::int64_t node = begin; node < end; ++node) {
            const geometry::Octree::Node& cube = tree_.nodes()[node];
            for (std::int64_t child = cube.first_child; child < cube.first_child + cube.children; ++child)
                if (geometry::Octree::octant(tree_.nodes()[child]) == octant)
                    batch.add(outgoing(child, level + 1), child_basis.size(), outgoing(node, level));
            if (batch.full()) flush();
        }
        flush();
    }
}

// Groups of neighbouring targets, in which those at the same offset from their source stand together.
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
                    pairs_[k] = {(t[0] - s[0] + 3) + 7 * (t[1] - s[1] + 3) + 49 * (t[2] - s[2] + 3),
                                 static_cast<std::int32_t>(lists_.far[k]), static_cast<std::int32_t>(target)};
                }
            std::sort(pairs_.begin() + lists_.far_begin[begin], pairs_.begin() + lists_.far_begin[end],
                      [](const FarPair& a, const FarPair& b) {
                          return a.direction != b.direction ? a.direction < b.direction : a.target < b.target;
                      });
            group_begin_.push_back(lists_.far_begin[end]);
        }
    lists_.far.release();
}

// A task has a group of targets and some of their nodes, so that there are enough tasks on levels of few cubes.
void FarField::translate(std::int32_t level, std::int64_t first_group, const base::Progress& progress) {
    const std::int64_t cubes = tree_.level_end(level) - tree_.level_begin(level);
    const std::int64_t groups = (cubes + translate_cubes - 1) / translate_cubes;
    const std::int64_t rows = levels_[static_cast<std::size_t>(level)].basis.stride();
    const std::int64_t parts = std::clamp<std::int64_t>(translate_tasks / groups, 1, rows / 8);
    runtime_.parallel.for_each(groups * parts, [&](std::int64_t task) {
        progress.check();
        const std::int64_t group = first_group + task / parts;
        const std::int64_t part = task % parts;
        translate_group({group_begin_[group], group_begin_[group + 1], static_cast<int>(part * (rows / 8) / parts * 8),
                         static_cast<int>((part + 1) * (rows / 8) / parts * 8), level});
    });
}

// Pairs of cubes at the same offset share the elements |x_i - x_k + offset|^3, which are made on the fly.
void FarField::translate_group(const TranslateTask& task) {
    const CubeBasis& basis = levels_[static_cast<std::size_t>(task.level)].basis;
    const CubeLoops loops = cube_loops(runtime_.instruction_set);
    const double half = tree_.half_width(task.level);
    const double* const nodes[3] = {basis.nodes().x.data(), basis.nodes().y.data(), basis.nodes().z.data()};
    base::Array<double> nobody(runtime_.memory, basis.stride());
    Batch batch(runtime_.memory, basis.size());
    for (std::int64_t k = task.begin; k < task.end; ++k) {
        const FarPair& pair = pairs_[k];
        batch.add(outgoing(pair.source, task.level), basis.size(), incoming(pair.target, task.level));
        if (!batch.full() && k + 1 < task.end && pairs_[k + 1].direction == pair.direction) continue;
        const double shift[3] = {2.0 * (pair.direction % 7 - 3), 2.0 * (pair.direction / 7 % 7 - 3),
                                 2.0 * (pair.direction / 49 - 3)};
        loops.translate(nodes, task.first_row, task.last_row, basis.size(), shift, half * half * half, batch.in(),
                        batch.out(nobody.data()), batch.count());
        batch.clear();
    }
}

void FarField::pass_down(std::int32_t level, const base::Progress& progress) {
    if (level + 1 == tree_.levels()) return;
    const Level& here = levels_[static_cast<std::size_t>(level)];
    const CubeBasis& child_basis = levels_[static_cast<std::size_t>(level) + 1].basis;
    const CubeLoops loops = cube_loops(runtime_.instruction_set);
    const std::int64_t first = tree_.level_begin(level);
    runtime_.parallel.for_chunks(tree_.level_end(level) - first, chunk, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        base::Array<double> nobody(runtime_.memory, child_basis.stride());
        Batch batch(runtime_.memory, here.basis.size());
        for (int octant = 0; octant < 8; ++octant) {
            const auto flush = [&] {
                if (batch.empty()) return;
                loops.multiply(here.to_child[static_cast<std::size_t>(octant)].data(), child_basis.stride(),
                               child_basis.stride(), here.basis.size(), batch.in(), batch.out(nobody.data()),
                               batch.count());
                batch.clear();
            };
            for (std::int64_t node = first + begin; node < first + end; ++node) {
                const geometry::Octree::Node& cube = tree_.nodes()[node];
                for (std::int64_t child = cube.first_child; child < cube.first_child + cube.children; ++child)
                    if (geometry::Octree::octant(tree_.nodes()[child]) == octant)
                        batch.add(incoming(node, level), here.basis.size(), incoming(child, level + 1));
                if (batch.full()) flush();
            }
            flush();
        }
    });
}

void FarField::evaluate_leaves(const base::Progress& progress) {
    runtime_.parallel.for_chunks(leaves_.size(), 4, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t k = begin; k < end; ++k) evaluate_leaf(leaves_[k]);
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
    if (!has_expansions(leaf.level)) return;
    const CubeBasis& basis = levels_[static_cast<std::size_t>(leaf.level)].basis;
    const CubeLoops loops = cube_loops(runtime_.instruction_set);
    base::Array<double> terms(runtime_.memory, basis.term_stride());
    Batch batch(runtime_.memory, basis.size());
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
        const std::int64_t s = source.begin;
        const std::int64_t t = target.begin;
        add(0.0,
            {p.x.data() + s, p.y.data() + s, p.z.data() + s, alpha_.data() + s, beta_.x.data() + s, beta_.y.data() + s,
             beta_.z.data() + s, source.count()},
            {p.x.data() + t, p.y.data() + t, p.z.data() + t, value_.data() + t, gradient_.x.data() + t,
             gradient_.y.data() + t, gradient_.z.data() + t, target.count()});
    }
}

std::int64_t FarField::bytes() const noexcept {
    return outgoing_.bytes() + incoming_.bytes() + alpha_.bytes() + beta_.bytes() + value_.bytes() + gradient_.bytes() +
           pairs_.bytes();
}

} // namespace hrbfnpr::implicit
