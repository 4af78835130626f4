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
    Preconditioner(const base::Runtime& runtime, const HermiteSystem& system, const geometry::PointTree& tree,
                   const base::Array<std::int64_t>& rank, std::int32_t neighbours, const base::Progress& progress);

    // z = L L^T r
    void apply(const double* r, double* z);

    [[nodiscard]] std::int64_t bytes() const noexcept;

private:
    void find_sets(const geometry::PointTree& tree, const base::Array<std::int64_t>& rank,
                   const base::Progress& progress);
    void factor_sets(const HermiteSystem& system, const geometry::PointTree& tree, const base::Progress& progress);
    void factor_coarse(const HermiteSystem& system, const geometry::PointTree& tree);
    void index_uses();
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
