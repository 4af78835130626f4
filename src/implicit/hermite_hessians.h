// SPDX-License-Identifier: MIT
// The Hessians of [NPAR equation 1], many sources at many targets, in the widest vectors that the processor has:
//   hessian(x) += sum_j (a alpha_j - b q) I + (b alpha_j - c q) d d^T - b (beta_j d^T + d beta_j^T)
// with d = x - x_j, q = d . beta_j and a, b, c of kernel/kernel.h.
//
// If a target coincides with a source, b and c of the pair are 0 as in kernel/radial.h. The contribution of a source
// begins to fade at a distance of 3e-19. This has no effect, because in units of the mean sample spacing, the only
// double so close to a sample is the sample itself.
#pragma once

#include "implicit/hermite_sums.h"

namespace hrbfnpr::implicit {

// The Hessians (xx xy xz yy yz zz), to which the sums are added. Pointers must not alias.
struct HessianTargets {
    const double* x;
    const double* y;
    const double* z;
    double* hessian[6];
    std::int64_t count;
};

// The sum of a target is always taken in the order of the sources. So the bits of a result do not depend on the other
// targets of the call.
using AddHermiteHessians = void (*)(double kernel_radius, const Sources& sources, const HessianTargets& targets);

[[nodiscard]] AddHermiteHessians hermite_hessians(base::InstructionSet set, kernel::Kind kind) noexcept;

} // namespace hrbfnpr::implicit
