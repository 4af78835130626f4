// SPDX-License-Identifier: MIT
// An approximate inverse of a Hermite system beside its polynomials, as a product L L^T of sparse factors.
//
// Samples stand in coarse-to-fine (farthest-first) order.  The coarsest few are one dense block; every later
// one has four columns, whose rows are its own and those of its nearest coarser samples (local_factors.h).
// Schaefer, Katzfuss, Owhadi 2021; for Green's functions Chen, Schaefer, Desbrun, ACM TOG 43, 2024.
#pragma once

#include "fit/system.h"
#include "geometry/point_tree.h"

namespace hrbfnpr::fit {

class Preconditioner {
public:
    // `system` is of the tree's points in the tree's order, and so are all vectors, 4 numbers a sample.
    // neighbours: of each sample, at most LocalSystems::largest_set - 1.  Throws Error{out_of_memory, cancelled,
    // singular_system} (the last if the coarsest block is not definite).
    Preconditioner(const base::Work& work, const HermiteSystem& system, const geometry::PointTree& tree,
                   const base::Array<std::int64_t>& rank, std::int32_t neighbours);

    // z = L L^T r
    void apply(const double* r, double* z, const base::Progress& progress = {});

    // The factor itself: column block i has set_size blocks of 4 x 4, row-major, rows set[i * set_size + k]; -1 first:
    // none, since the sample is one of the dense block's.
    struct Blocks {
        std::int64_t set_size;
        const std::int32_t* set;
        const float* factor;
        const std::int64_t* coarse; // the samples of the dense block
        std::int64_t coarse_count;
        const double* coarse_factor; // 4 coarse_count x coarse_columns, column-major
        std::int64_t coarse_columns;
        const std::int64_t*
            use_begin; // of each sample: where it is in set, use[use_begin[j]] ... use[use_begin[j + 1] - 1]
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
    std::int32_t set_size_; // neighbours, and the sample itself, which is the last
    bool beside_linear_;
    base::Array<std::int64_t> coarse_; // the samples of the dense block
    std::int64_t coarse_columns_ = 0;
    base::Array<double> coarse_factor_;   // 4 coarse_.size() x coarse_columns_, column-major
    base::Array<std::int32_t> set_;       // set_size_ for each sample; -1 first: a coarse one
    base::Array<float> factor_;           // 16 for each element of set_
    base::Array<std::int64_t> use_begin_; // of each sample's uses: where it stands in set_
    base::Array<std::int64_t> use_;
    base::Array<double> t_; // L^T r
};

} // namespace hrbfnpr::fit
