// SPDX-License-Identifier: MIT
// Second and third derivatives of [NPAR equation 1] whose kernel is smoothed: psi(d) = phi(sqrt(d^2 + smoothing)).
//
// As d/d(r^2) = d/d(R^2) for R^2 = r^2 + smoothing, the radial functions a, b, c, e = c'/r of kernel/kernel.h are
// only taken at R in place of r.  With q = d . beta_j,
//   v = (b alpha_j - c q) d - b beta_j,     w = (c alpha_j - e q) d / 3 - c beta_j,
// a source adds
//   hessian: (a alpha_j - b q) I + v d^T - b d beta_j^T
//   third:   sym(delta, v) + sym(w, d, d)
// where sym sums the three places that v and w can stand in.
//
// Without smoothing the Hessian of a triharmonic or Wendland source depends on the direction from which one comes to
// it, and its third derivatives grow like 1/r: then smoothing must be positive.
#pragma once

#include "implicit/hermite_sums.h"

namespace hrbfnpr::implicit {

// The sums are added to what stands in the arrays, which alias nothing.
// Orders: xx xy xz yy yz zz and xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz.
struct ThirdTargets {
    const double* x;
    const double* y;
    const double* z;
    double* hessian[6];
    double* third[10];
    std::int64_t count;
};

// Each target's sum is taken in the order of the sources, whatever stands beside it.
using AddHermiteThirds = void (*)(double kernel_radius, double smoothing, const Sources& sources,
                                  const ThirdTargets& targets);

[[nodiscard]] AddHermiteThirds hermite_thirds(base::InstructionSet set, kernel::Kind kind) noexcept;

// The same in the words of the equations above, for tests.
void add_hermite_thirds_plainly(kernel::Kind kind, double kernel_radius, double smoothing, const Sources& sources,
                                const ThirdTargets& targets) noexcept;

} // namespace hrbfnpr::implicit
