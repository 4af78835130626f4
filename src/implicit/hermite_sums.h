// SPDX-License-Identifier: MIT
// The sums of [NPAR equation 1] and of its gradient, many sources at many targets, in the widest vectors that the
// processor has:
//   value(x)    += sum_j alpha_j phi(d) - a (d . beta_j)                         d = x - x_j
//   gradient(x) += sum_j (a alpha_j - b (d . beta_j)) d - a beta_j
// with phi, a = phi'/r, b = a'/r of kernel/kernel.h. They are the rows of the Hermite system, too: its product with
// (alpha, beta) is this sum at its own centres.
#pragma once

#include "base/instruction_set.h"
#include "kernel/kernel.h"

#include <cstdint>

namespace hrbfnpr::implicit {

struct Sources {
    const double* x;
    const double* y;
    const double* z;
    const double* alpha;
    const double* beta_x;
    const double* beta_y;
    const double* beta_z;
    std::int64_t count;
};

// The arrays to which the sums are added. Pointers must not alias.
struct Targets {
    const double* x;
    const double* y;
    const double* z;
    double* value;
    double* gradient_x;
    double* gradient_y;
    double* gradient_z;
    std::int64_t count;
};

// The sum of a target is always taken in the order of the sources. So the bits of a result do not depend on the other
// targets of the call.
using AddHermiteSums = void (*)(double kernel_radius, const Sources& sources, const Targets& targets);

[[nodiscard]] AddHermiteSums hermite_sums(base::InstructionSet set, kernel::Kind kind) noexcept;

} // namespace hrbfnpr::implicit
