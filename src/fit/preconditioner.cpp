// SPDX-License-Identifier: MIT
#include "fit/preconditioner.h"

#include "base/long_array.h"
#include "fit/local_factors.h"
#include "fit/sparse_blocks.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>

namespace hrbfnpr::fit {
namespace {

// Returns the number of samples in the dense block. Every later sample must have all its neighbours, and the block
// should take little time.
[[nodiscard]] std::int64_t coarse_count(std::int64_t samples, std::int32_t neighbours) noexcept {
    return std::min<std::int64_t>(samples, std::max<std::int64_t>(32, neighbours));
}

constexpr std::int64_t corrections_a_task = 256; // samples per task

// Returns Z. Its transpose subtracts from the functionals at `at` their Taylor expansions about sample 0. Sample 0 has
// the first rows.
[[nodiscard]] Eigen::MatrixXd orthogonal_to_linear(const geometry::PointTree& tree,
                                                   const base::Array<std::int64_t>& at) {
    const auto count = static_cast<Eigen::Index>(at.size());
    Eigen::MatrixXd z = Eigen::MatrixXd::Zero(4 * count, 4 * (count - 1));
    const glm::dvec3 origin = tree.points()[at[0]];
    for (Eigen::Index k = 1; k < count; ++k) {
        const glm::dvec3 d = tree.points()[at[k]] - origin;
        z.block<4, 4>(4 * k, 4 * (k - 1)).setIdentity();
        z.block<4, 4>(0, 4 * (k - 1)) = -Eigen::Matrix4d::Identity();
        for (int c = 0; c < 3; ++c) z(1 + c, 4 * (k - 1)) = -d[c];
    }
    return z;
}

} // namespace

Preconditioner::Preconditioner(const base::Work& work, const HermiteSystem& system, const geometry::PointTree& tree,
                               const base::Array<std::int64_t>& rank, std::int32_t neighbours)
    : runtime_(work), samples_(system.samples()), set_size_(neighbours + 1),
      orthogonal_to_linear_(kernel::order(system.options().kernel) > 1), coarse_(work.memory),
      coarse_factor_(work.memory), set_(work.memory), factor_(work.memory), use_begin_(work.memory), use_(work.memory),
      t_(work.memory, 4 * samples_) {
    base::resize_long(set_, samples_ * set_size_, work);
    coarse_.resize(coarse_count(samples_, neighbours));
    for (std::int64_t at = 0; at < samples_; ++at)
        if (rank[at] < coarse_.size()) coarse_[rank[at]] = at;
    find_sets(tree, rank, work.part(0.0, 0.3));
    index_uses(work);
    work.check();
    factor_coarse(system, tree);
    factor_sets(system, tree, work.part(0.3, 1.0));
}

void Preconditioner::find_sets(const geometry::PointTree& tree, const base::Array<std::int64_t>& rank,
                               const base::Progress& progress) {
    progress.check();
    const base::Array<std::int64_t> smallest = tree.smallest_of_nodes([&](std::int64_t at) { return rank[at]; });
    runtime_.parallel.for_chunks(samples_, corrections_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        std::int64_t found[LocalSystems::largest_set];
        for (std::int64_t at = begin; at < end; ++at) {
            std::int32_t* set = set_.data() + at * set_size_;
            if (rank[at] < coarse_.size()) {
                set[0] = -1;
                continue;
            }
            tree.nearest(
                tree.points()[at], set_size_ - 1, [&](std::int64_t node) { return smallest[node] < rank[at]; },
                [&](std::int64_t other) { return rank[other] < rank[at]; }, found);
            for (std::int32_t k = 0; k + 1 < set_size_; ++k) set[k] = static_cast<std::int32_t>(found[k]);
            set[set_size_ - 1] = static_cast<std::int32_t>(at);
        }
    });
    progress.update(1.0);
}

void Preconditioner::factor_sets(const HermiteSystem& system, const geometry::PointTree& tree,
                                 const base::Progress& progress) {
    // The factor may take hundreds of megabytes, so each task clears its part.
    factor_.resize_for_overwrite(set_.size() * 16);
    const HermiteSystem::Options& options = system.options();
    const base::InstructionSet isa = runtime_.instruction_set;
    const FactorLocalSystems factor = local_factors(isa);
    const std::int64_t batch = 8 * local_factor_batch(isa);
    runtime_.parallel.for_chunks(samples_, batch, progress, [&](std::int64_t begin, std::int64_t end) {
        std::fill(factor_.begin() + begin * set_size_ * 16, factor_.begin() + end * set_size_ * 16, 0.0F);
        base::Array<double> scratch(runtime_.memory, local_factor_scratch_size(isa, set_size_));
        base::Array<double> position(runtime_.memory, batch * set_size_ * 3);
        for (std::int64_t k = begin * set_size_; k < end * set_size_; ++k) {
            // Coarse samples are in the dense block, and their columns of the sparse factor are not used. So any points
            // may take their places here.
            const std::int64_t first = set_[k - k % set_size_];
            const glm::dvec3 p = first < 0 ? glm::dvec3(static_cast<double>(k % set_size_)) : tree.points()[set_[k]];
            for (glm::length_t c = 0; c < 3; ++c) position[3 * (k - begin * set_size_) + c] = p[c];
        }
        const LocalSystems local{
            options.kernel, options.radius, options.value_diagonal, options.gradient_diagonal, orthogonal_to_linear_,
            set_size_,      end - begin};
        factor(local, position.data(), scratch.data(), factor_.data() + begin * set_size_ * 16);
    });
    progress.update(1.0);
}

// Computes L_0 = Z C^-T with C C^T = Z^T A Z.
void Preconditioner::factor_coarse(const HermiteSystem& system, const geometry::PointTree& tree) {
    const std::int64_t count = coarse_.size();
    geometry::VecArray position(runtime_.memory, count);
    for (std::int64_t k = 0; k < count; ++k) position.set(k, tree.points()[coarse_[k]]);
    const HermiteSystem coarse(position, system.options());
    Eigen::MatrixXd a(4 * count, 4 * count);
    coarse.block(0, count, 0, count, a.data(), 4 * count);
    Eigen::MatrixXd z;
    if (orthogonal_to_linear_) {
        z = orthogonal_to_linear(tree, coarse_);
        a = (z.transpose() * a * z).eval();
    } else {
        z = Eigen::MatrixXd::Identity(4 * count, 4 * count);
    }
    const Eigen::LLT<Eigen::MatrixXd> cholesky(a);
    if (cholesky.info() != Eigen::Success)
        fail(Status::singular_system,
             "the system of the coarsest samples is not positive definite; use regularization > 0");
    coarse_columns_ = a.rows();
    coarse_factor_.resize(4 * count * coarse_columns_);
    Eigen::Map<Eigen::MatrixXd>(coarse_factor_.data(), 4 * count, coarse_columns_) =
        cholesky.matrixU().solve<Eigen::OnTheRight>(z);
}

// Lists for each sample its occurrences in all sets, in ascending order.
void Preconditioner::index_uses(const base::Progress& progress) {
    use_begin_.resize(samples_ + 1);
    for (const std::int64_t at : progress.over(samples_)) {
        if (set_[at * set_size_] < 0) continue;
        for (std::int32_t k = 0; k < set_size_; ++k) ++use_begin_[set_[at * set_size_ + k] + 1];
    }
    for (std::int64_t at = 0; at < samples_; ++at) use_begin_[at + 1] += use_begin_[at];
    progress.check();
    base::resize_long(use_, use_begin_[samples_], progress);
    base::Array<std::int64_t> next(runtime_.memory, samples_);
    std::copy_n(use_begin_.begin(), samples_, next.begin());
    for (const std::int64_t at : progress.over(samples_)) {
        if (set_[at * set_size_] < 0) continue;
        for (std::int32_t k = 0; k < set_size_; ++k) {
            const std::int64_t element = at * set_size_ + k;
            use_[next[set_[element]]++] = element;
        }
    }
}

void Preconditioner::apply(const double* r, double* z, const base::Progress& progress) {
    const SparseBlocks blocks = sparse_blocks(runtime_.instruction_set);
    const SparseFactor factor{set_size_, set_.data(), factor_.data(), use_begin_.data(), use_.data()};
    runtime_.parallel.for_chunks(samples_, 4 * corrections_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        blocks.multiply_transposed(factor, begin, end, r, t_.data());
    });
    runtime_.parallel.for_chunks(samples_, 4 * corrections_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        blocks.multiply(factor, begin, end, t_.data(), z);
    });
    apply_coarse(r, z);
}

void Preconditioner::apply_coarse(const double* r, double* z) const {
    const std::int64_t count = coarse_.size();
    const Eigen::Map<const Eigen::MatrixXd> factor(coarse_factor_.data(), 4 * count, coarse_columns_);
    Eigen::VectorXd part(4 * count);
    for (std::int64_t k = 0; k < count; ++k)
        for (std::int64_t c = 0; c < 4; ++c) part[4 * k + c] = r[4 * coarse_[k] + c];
    const Eigen::VectorXd t = factor.transpose() * part;
    part.noalias() = factor * t;
    for (std::int64_t k = 0; k < count; ++k)
        for (std::int64_t c = 0; c < 4; ++c) z[4 * coarse_[k] + c] += part[4 * k + c];
}

std::int64_t Preconditioner::bytes() const noexcept {
    return coarse_.bytes() + coarse_factor_.bytes() + set_.bytes() + factor_.bytes() + use_begin_.bytes() +
           use_.bytes() + t_.bytes();
}

} // namespace hrbfnpr::fit
