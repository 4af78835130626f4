// SPDX-License-Identifier: MIT
// The columns of a sparse factor of a Hermite system's inverse, one small dense system per sample.
//
// For sample i, let s be the set of its coarser neighbours followed by i, and Theta the block of A for s. The columns
// that minimise the Kullback-Leibler divergence from A^-1 among all with that sparsity are
//   L_s = Theta^-1 E (E^T Theta^-1 E)^(-1/2),    E: the four columns of i
// (Schaefer, Katzfuss, Owhadi, SIAM J. Sci. Comput. 43, 2021). With Theta = C C^T they are the last four columns of
// C^-T. Where A is definite only on vectors orthogonal to the linear polynomials, the Taylor expansion about the first
// neighbour is subtracted from every functional of s, which makes the columns orthogonal to them.
#pragma once

#include "base/instruction_set.h"
#include "kernel/kernel.h"

#include <cstdint>

namespace hrbfnpr::fit {

struct LocalSystems {
    kernel::Kind kernel;
    double radius;
    double value_diagonal; // the number that regularization adds to the diagonal for values
    double gradient_diagonal;
    bool orthogonal_to_linear; // makes the columns orthogonal to the linear polynomials
    std::int32_t set_size;     // the number of samples in each set, 2 to largest_set
    std::int64_t count;        // the number of sets

    static constexpr std::int32_t largest_set = 49;
};

// Returns the working memory of one call, as a number of doubles.
[[nodiscard]] std::int64_t local_factor_scratch_size(base::InstructionSet set, std::int32_t set_size) noexcept;
// Returns how many sets are factored together. Calls with a multiple of this number are the fastest.
[[nodiscard]] std::int64_t local_factor_batch(base::InstructionSet set) noexcept;

// position: coordinate c of sample m of set k is at [(k * set_size + m) * 3 + c].
// factor:   16 numbers per sample of each set, [k][m][row of the sample][column], rows value, x, y, z.
using FactorLocalSystems = void (*)(const LocalSystems& systems, const double* position, double* scratch,
                                    float* factor);

[[nodiscard]] FactorLocalSystems local_factors(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::fit
