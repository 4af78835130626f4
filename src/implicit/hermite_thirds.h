// SPDX-License-Identifier: MIT
// Second and third derivatives of [NPAR equation 1] with a smoothed kernel: psi(d) = phi(sqrt(d^2 + smoothing)).
//
// Because d/d(r^2) = d/d(R^2) for R^2 = r^2 + smoothing, the radial functions a, b, c, e = c'/r of kernel/kernel.h are
// taken at R in place of r. With q = d . beta_j,
//   v = (b alpha_j - c q) d - b beta_j,     w = (c alpha_j - e q) d / 3 - c beta_j,
// a source adds
//   hessian: (a alpha_j - b q) I + v d^T - b d beta_j^T
//   third:   sym(delta, v) + sym(w, d, d)
// where sym sums over the three index positions of v and w.
//
// Without smoothing, the Hessian of a triharmonic or Wendland source depends on the direction from which it is
// approached, and the third derivatives grow like 1/r. So for these kernels smoothing must be positive.
#pragma once

#include "implicit/hermite_sums.h"

namespace hrbfnpr::implicit {

// The arrays to which the sums are added, in the orders xx xy xz yy yz zz and xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz.
// Pointers must not alias.
struct ThirdTargets {
    const double* x;
    const double* y;
    const double* z;
    double* hessian[6];
    double* third[10];
    std::int64_t count;
};

// The sum of a target is always taken in the order of the sources, whichever other targets the call has.
using AddHermiteThirds = void (*)(double kernel_radius, double smoothing, const Sources& sources,
                                  const ThirdTargets& targets);

[[nodiscard]] AddHermiteThirds hermite_thirds(base::InstructionSet set, kernel::Kind kind) noexcept;

// Computes the same sums as AddHermiteThirds with plain code that follows the equations. Tests compare the two.
void add_hermite_thirds_plainly(kernel::Kind kind, double kernel_radius, double smoothing, const Sources& sources,
                                const ThirdTargets& targets) noexcept;

} // namespace hrbfnpr::implicit
