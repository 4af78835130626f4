// SPDX-License-Identifier: MIT
#include "implicit/source_tree.h"

#include "base/long_array.h"

#include "implicit/cube_loops.h"
#include "implicit/cube_vectors.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::implicit {
namespace {

constexpr std::int64_t cubes_a_task = 32; // number of cubes in a task

[[nodiscard]] geometry::VecArray in_parent(const CubeBasis& child, int octant) {
    geometry::VecArray points(child.nodes().memory(), child.size());
    const glm::dvec3 centre(octant & 1 ? 0.5 : -0.5, octant & 2 ? 0.5 : -0.5, octant & 4 ? 0.5 : -0.5);
    for (std::int64_t i = 0; i < child.size(); ++i) points.set(i, centre + 0.5 * child.nodes()[i]);
    return points;
}

// Returns the transposed matrix: columns of `rows` numbers become padded rows of `columns` numbers.
[[nodiscard]] base::Array<double> transposed(const base::Array<double>& matrix, int rows, int columns) {
    const std::int64_t from = CubeBasis::padded(rows);
    const std::int64_t to = CubeBasis::padded(columns);
    base::Array<double> result(matrix.memory(), to * rows);
    for (std::int64_t j = 0; j < columns; ++j) {
        for (std::int64_t i = 0; i < rows; ++i) result[i * to + j] = matrix[j * from + i];
    }
    return result;
}

// Writes the numbers of up to cube_batch vectors of `length` numbers, a multiple of 8, in turn. Eight numbers at a time
// are read and written, so that both stay in the fastest cache.
void interleave(std::span<const double* const> vectors, std::int64_t length, double* to) noexcept {
    for (std::int64_t begin = 0; begin < length; begin += 8)
        for (std::size_t v = 0; v < vectors.size(); ++v)
            for (std::int64_t k = begin; k < begin + 8; ++k)
                to[k * cube_batch + static_cast<std::int64_t>(v)] = vectors[v][k];
}

// Vectors that are multiplied by the same matrix of cubed distances.
class TranslatedVectors {
public:
    TranslatedVectors(const base::Runtime& runtime, const CubeBasis& basis, double half)
        : basis_(basis), loops_(cube_loops(runtime.instruction_set)), scale_(half * half * half),
          interleaved_(runtime.memory, most * basis.stride()),
          panel_(runtime.memory, std::int64_t{basis.size()} * cube_rows), unused_(runtime.memory, basis.stride()) {}

    [[nodiscard]] bool full() const noexcept { return count_ == most; }
    void add(const double* in, double* out) noexcept {
        in_[count_] = in;
        out_[count_++] = out;
    }
    // Adds the products to the rows [first_row, last_row) of the results.
    void flush(const std::array<std::int32_t, 3>& by, int first_row, int last_row) noexcept {
        const double* const nodes[3] = {basis_.nodes().x.data(), basis_.nodes().y.data(), basis_.nodes().z.data()};
        const double shift[3] = {2.0 * by[0], 2.0 * by[1], 2.0 * by[2]};
        for (std::size_t v = 0; v < count_; v += cube_batch)
            interleave({in_.data() + v, std::min<std::size_t>(cube_batch, count_ - v)}, basis_.stride(), batch(v));
        for (int row = first_row; row < last_row; row += cube_rows) {
            loops_.cubes(nodes, row, basis_.size(), shift, scale_, panel_.data());
            for (std::size_t v = 0; v < count_; v += cube_batch) {
                double* out[cube_batch];
                for (std::size_t k = 0; k < cube_batch; ++k)
                    out[k] = (v + k < count_ ? out_[v + k] : unused_.data()) + row;
                loops_.multiply(panel_.data(), cube_rows, cube_rows, basis_.size(), batch(v), out,
                                static_cast<int>(std::min<std::size_t>(cube_batch, count_ - v)));
            }
        }
        count_ = 0;
    }

private:
    // With this number of vectors, computing a row of the matrix takes a tenth of the time of the products, and the
    // vectors stay in the second-level cache.
    static constexpr std::int64_t most = 6 * cube_batch;

    // Returns the interleaved vectors from v on.
    [[nodiscard]] double* batch(std::size_t v) noexcept {
        return interleaved_.data() + static_cast<std::int64_t>(v) * basis_.stride();
    }

    const CubeBasis& basis_;
    CubeLoops loops_;
    double scale_;
    std::size_t count_ = 0;
    std::array<const double*, most> in_{};
    std::array<double*, most> out_{};
    base::Array<double> interleaved_;
    base::Array<double> panel_;
    base::Array<double> unused_;
};

} // namespace

SourceTree::SourceTree(const base::Work& work, const geometry::VecArray& centres, const SourceTreeOptions& options)
    : runtime_(work), tree_(centres, options.leaf_size, 0.0, work), outgoing_(work.memory),
      alpha_(work.memory, centres.size()), beta_(work.memory, centres.size()) {
    std::int64_t size = 0;
    for (std::int32_t level = 0; level < tree_.levels(); ++level) {
        const int degree = degree_of(level, options);
        levels_.push_back({find_basis(degree, work), nullptr, size});
        size += levels_.back().basis->stride() * (tree_.level_end(level) - tree_.level_begin(level));
    }
    vectors_size_ = size + CubeBasis::padded(CubeBasis::terms(CubeBasis::degree_max));
}

// Returns the degree for a fit. The error of a pair of cubes is about (half width)^3 2.9^-degree, relative to their
// weights.
//
// Conjugate gradients need an error below the smallest eigenvalue, which is proportional to (spacing)^3. So a cube of
// twice the width needs a degree that is higher by 2. The constant 6.1 was found by experiments with evenly spaced
// samples: if the degree is lower by 3, fits of 65 000 samples fail; if it is lower by 1, they need 1.5 times as many
// iterations.
//
// The weights of a fit are proportional to (spacing)^2, and the number of samples to 1 / (spacing)^2. The errors of far
// pairs add up like noise, so the total error is proportional to (spacing) times the error of one pair with weight 1.
// The constant 7.1 was found by experiments with 24 000 to 262 144 evenly spaced samples.
[[nodiscard]] double degree_for_fits(double width, double all, double tolerance) noexcept {
    const double to_converge = 2.0 * std::log2(width) + 6.1;
    const double error = std::pow(width / all, 3.0) / (all * tolerance);
    const double to_be_exact = std::log(std::max(1.0, error)) / std::log(2.9) + 7.1;
    return std::max(to_converge, to_be_exact);
}

int SourceTree::degree_of(std::int32_t level, const SourceTreeOptions& options) const noexcept {
    if (!has_expansions(level)) return 0; // nodes are not used on this level, because all its cubes touch each other
    const double width = std::max(1.0, tree_.half_width(level) / options.spacing);
    const double all = std::max(1.0, tree_.half_width(0) / options.spacing);
    const double degree = std::ceil(degree_for_fits(width, all, options.tolerance));
    return std::clamp(static_cast<int>(degree) + 2 * options.finer, 4, CubeBasis::degree_max);
}

std::shared_ptr<CubeBasis> SourceTree::find_basis(int degree, const base::Progress& progress) const {
    for (const Level& level : levels_)
        if (level.basis->degree() == degree) return level.basis;
    return std::make_shared<CubeBasis>(base::Work(runtime_, progress), degree);
}

std::shared_ptr<SourceTree::Transfers> SourceTree::find_transfers(std::int32_t level,
                                                                  const base::Progress& progress) const {
    const CubeBasis& here = basis(level);
    const CubeBasis& child = basis(level + 1);
    for (std::int32_t other = 2; other < level; ++other)
        if (&basis(other) == &here && &basis(other + 1) == &child) return at(other).transfers;
    auto transfers = std::make_shared<Transfers>();
    for (int octant = 0; octant < 8; ++octant) {
        progress.check();
        transfers->to_child.push_back(here.interpolation({runtime_, progress}, in_parent(child, octant), child.size()));
        transfers->transposed.push_back(transposed(transfers->to_child.back(), child.size(), here.size()));
    }
    return transfers;
}

void SourceTree::load(const double* alpha, const geometry::VecArray& beta, const base::Progress& progress) {
    for (const std::int64_t at : progress.over(tree_.points().size())) {
        alpha_[at] = alpha[tree_.index(at)];
        beta_.set(at, beta[tree_.index(at)]);
    }
}

void SourceTree::make_transfers(const base::Progress& progress) {
    for (std::int32_t level = 2; level + 1 < tree_.levels(); ++level)
        if (at(level).transfers == nullptr)
            levels_[static_cast<std::size_t>(level)].transfers = find_transfers(level, progress);
}

void SourceTree::gather(const base::Progress& progress) {
    make_transfers(progress);
    outgoing_.clear();
    base::resize_long(outgoing_, vectors_size_, progress); // new elements are 0
    for (std::int32_t level = tree_.levels() - 1; level >= 2; --level) gather_moments(level, progress);
}

Sources SourceTree::sources(std::int64_t begin, std::int64_t end) const noexcept {
    const geometry::VecArray& p = tree_.points();
    return {p.x.data() + begin,     p.y.data() + begin,     p.z.data() + begin,     alpha_.data() + begin,
            beta_.x.data() + begin, beta_.y.data() + begin, beta_.z.data() + begin, end - begin};
}

// Computes the weights at the nodes of cubes: from the sources for leaves, else from the weights at the children's
// nodes.
void SourceTree::gather_moments(std::int32_t level, const base::Progress& progress) {
    const CubeBasis& basis = *at(level).basis;
    const CubeLoops loops = cube_loops(runtime_.instruction_set);
    const std::int64_t first = tree_.level_begin(level);
    runtime_.parallel.for_chunks(
        tree_.level_end(level) - first, cubes_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
            base::Array<double> terms(runtime_.memory, basis.terms());
            base::Array<double> sums(runtime_.memory, std::int64_t{basis.terms()} * cube_lanes);
            base::Array<double> nobody(runtime_.memory, basis.stride());
            CubeVectors batch(runtime_.memory, basis.terms());
            const auto flush = [&] {
                if (batch.empty()) return;
                progress.check();
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
                              alpha_.data() + cube.begin, beta, sums.data(), terms.data());
                batch.add(terms.data(), basis.terms(), outgoing(node, level));
                if (batch.full()) flush();
            }
            flush();
            add_children(first + begin, first + end, level, progress);
        });
}

void SourceTree::add_children(std::int64_t begin, std::int64_t end, std::int32_t level,
                              const base::Progress& progress) {
    if (level + 1 == tree_.levels()) return;
    const CubeBasis& here = basis(level);
    const CubeBasis& child_basis = basis(level + 1);
    const CubeLoops loops = cube_loops(runtime_.instruction_set);
    base::Array<double> nobody(runtime_.memory, here.stride());
    CubeVectors batch(runtime_.memory, child_basis.size());
    for (int octant = 0; octant < 8; ++octant) {
        const auto flush = [&] {
            if (batch.empty()) return;
            progress.check();
            loops.multiply(at(level).transfers->transposed[static_cast<std::size_t>(octant)].data(), here.stride(),
                           here.stride(), child_basis.size(), batch.in(), batch.out(nobody.data()), batch.count());
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

// Pairs of cubes with the same offset share the matrix with the elements |x_i - x_k + offset|^3. It is not stored:
// eight rows at a time are computed when they are needed.
void SourceTree::translate(std::int32_t level, std::span<const Pair> pairs, int first_row, int last_row,
                           double* incoming, const base::Progress& progress) const {
    const CubeBasis& basis = *at(level).basis;
    TranslatedVectors vectors(runtime_, basis, tree_.half_width(level));
    for (std::size_t k = 0; k < pairs.size(); ++k) {
        const Pair& pair = pairs[k];
        vectors.add(outgoing(pair.source, level), incoming + std::int64_t{pair.target} * basis.stride());
        if (!vectors.full() && k + 1 < pairs.size() && pairs[k + 1].direction == pair.direction) continue;
        progress.check();
        vectors.flush(offset(pair.direction), first_row, last_row);
    }
}

std::int64_t SourceTree::bytes() const noexcept { return outgoing_.bytes() + alpha_.bytes() + beta_.bytes(); }

} // namespace hrbfnpr::implicit
