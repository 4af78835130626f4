// SPDX-License-Identifier: MIT
// The inner loops of the far field, for each instruction set.
#pragma once

#include "base/instruction_set.h"

#include <cstdint>

namespace hrbfnpr::implicit {

// The number of vectors that a matrix multiplies at a time. The vectors are interleaved: element k of vector v is at [k
// * cube_batch + v].
inline constexpr int cube_batch = 16;
// The largest number of samples that are summed side by side in a SIMD vector.
inline constexpr int cube_lanes = 8;
// The number of rows of a matrix of cubed distances that are made at a time.
inline constexpr int cube_rows = 8;

struct CubeSamples {
    const double* x;
    const double* y;
    const double* z;
    std::int64_t count;
    double centre[3];  // centre of the cube, whose local coordinates are [-1, 1]^3
    double half_width; // half the width of the cube
};

struct CubeLoops {
    // panel[k * cube_rows + i] = scale |x_{row + i} - x_k + shift|^3 for i < cube_rows and k < columns.
    void (*cubes)(const double* const* nodes, int row, int columns, const double* shift, double scale, double* panel);
    // out[v][i] += sum_k matrix[k * stride + i] in[k][v] for i < rows.
    void (*multiply)(const double* matrix, std::int64_t stride, int rows, int columns, const double* in,
                     double* const* out, int vectors);
    // terms[abc] = sum_j (alpha_j + beta_j . grad) T_a T_b T_c over the samples j. The gradient is with respect to the
    // caller's coordinates, not the cube's. `sums` is working memory with cube_lanes numbers for each term, aligned to
    // 64 bytes.
    void (*moments)(int degree, const CubeSamples& samples, const double* alpha, const double* const* beta,
                    double* sums, double* terms);
    // Adds the value and gradient of sum_abc terms[abc] T_a T_b T_c at the samples.
    void (*evaluate)(int degree, const double* terms, const CubeSamples& samples, double* value,
                     double* const* gradient);
    // Adds the Hessian of sum_abc terms[abc] T_a T_b T_c, in the order xx xy xz yy yz zz.
    void (*hessian)(int degree, const double* terms, const CubeSamples& samples, double* const* hessian);
};

[[nodiscard]] CubeLoops cube_loops(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::implicit
