// SPDX-License-Identifier: MIT
// An approximate inverse of a Hermite system on vectors orthogonal to its polynomials, as a product L L^T of sparse
// factors.
//
// Samples are in coarse-to-fine (farthest-first) order. The coarsest few form one dense block. Every later sample has
// four columns, with rows for itself and for its nearest coarser samples (local_factors.h). Schaefer, Katzfuss, Owhadi
// 2021; for Green's functions Chen, Schaefer, Desbrun, ACM TOG 43, 2024.
#pragma once

#include "base/work.h"
#include "fit/system.h"
#include "geometry/point_tree.h"

namespace hrbfnpr::fit {

class Preconditioner {
public:
    // `system` has the tree's points in the tree's order, and all vectors have this order and 4 numbers per sample.
    // `neighbours` is the number of neighbours per sample, at most LocalSystems::largest_set - 1. Throws
    // Error{out_of_memory, cancelled, singular_system}; singular_system if the coarsest block is not definite.
    Preconditioner(const base::Work& work, const HermiteSystem& system, const geometry::PointTree& tree,
                   const base::Array<std::int64_t>& rank, std::int32_t neighbours);

    // z = L L^T r
    void apply(const double* r, double* z, const base::Progress& progress = {});

    // The sparse factor. Column block i has set_size blocks of 4 x 4, row-major, with rows set[i * set_size + k]. If
    // the first of these rows is -1, the sample is in the dense block and the column block is empty.
    struct Blocks {
        std::int64_t set_size;
        const std::int32_t* set;
        const float* factor;
        const std::int64_t* coarse; // the samples of the dense block
        std::int64_t coarse_count;
        const double* coarse_factor; // 4 coarse_count rows, coarse_columns columns, column-major
        std::int64_t coarse_columns;
        // The occurrences of sample j in `set` are use[use_begin[j]] to use[use_begin[j + 1] - 1].
        const std::int64_t* use_begin;
        const std::int64_t* use;
    };
    [[nodiscard]] Blocks blocks() const noexcept {
        return {set_size_,       set_.data(),       factor_.data(),
                coarse_.data(),  coarse_.size(),    coarse_factor_.data(),
                coarse_columns_, use_begin_.data(), use_.data()};
    }

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void find_sets(const geometry::PointTree& tree, const base::Array<std::int64_t>& rank,
                   const base::Progress& progress);
    void factor_sets(const HermiteSystem& system, const geometry::PointTree& tree, const base::Progress& progress);
    void factor_coarse(const HermiteSystem& system, const geometry::PointTree& tree);
    void index_uses(const base::Progress& progress);
    void apply_coarse(const double* r, double* z) const;

    const base::Runtime& runtime_;
    std::int64_t samples_;
    std::int32_t set_size_; // the number of neighbours, plus 1 for the sample itself
    bool orthogonal_to_linear_;
    base::Array<std::int64_t> coarse_; // the samples of the dense block
    std::int64_t coarse_columns_ = 0;
    base::Array<double> coarse_factor_; // 4 coarse_.size() rows, coarse_columns_ columns, column-major
    base::Array<std::int32_t> set_;     // set_size_ per sample; if the first is -1, the sample is coarse
    base::Array<float> factor_;         // 16 numbers for each element of set_
    // use_ lists, for each sample, the elements of set_ that refer to it. The list of sample i begins at use_begin_[i].
    base::Array<std::int64_t> use_begin_;
    base::Array<std::int64_t> use_;
    base::Array<double> t_; // L^T r
};

} // namespace hrbfnpr::fit
