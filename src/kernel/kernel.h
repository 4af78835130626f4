// SPDX-License-Identifier: MIT
// Radial kernels phi(r), with the derivatives that a Hermite system needs. [NPAR 4.1]
#pragma once

#include <cstdint>

namespace hrbfnpr::kernel {

// The values equal the constants HRBFNPR_KERNEL_*.
enum class Kind : std::uint32_t { triharmonic = 0, gaussian = 1, wendland_c2 = 2 };

// psi(d) = phi(|d|) and its derivatives are combinations of four radial functions:
//   grad psi = a d
//   Hess psi = a I + b d d^T
//   third    = b (delta_ij d_k + delta_ik d_j + delta_jk d_i) + c d_i d_j d_k
// with a = phi'/r, b = a'/r, c = b'/r.
struct Radial {
    double phi;
    double a;
    double b;
    double c;
};

// Returns the radial functions. At r = 0, b and c of the triharmonic and Wendland kernels are singular and set to 0:
// their terms are odd in the direction of d, so 0 is their mean over all directions.
[[nodiscard]] Radial radial(Kind kind, double radius, double r) noexcept;

// Returns c'/r, which the fourth derivatives of psi need:
//   fourth = b (3 terms delta delta) + c (6 terms delta d d) + (c'/r) d d d d
// It requires r > 0. For the triharmonic and Wendland kernels it grows without bound towards r = 0.
[[nodiscard]] double radial_fourth(Kind kind, double radius, double r) noexcept;

// Returns the exponent e of scaling: if points and radius are multiplied by s, phi is multiplied by s^e. It is 3 for
// r^3, else 0.
[[nodiscard]] constexpr int homogeneity(Kind kind) noexcept { return kind == Kind::triharmonic ? 3 : 0; }

// Returns the order of the kernel. The Hermite matrix is positive definite on vectors that are orthogonal to all
// polynomials of a lower degree than this (Duchon 1977). 0 means that it is positive definite on all vectors.
[[nodiscard]] constexpr int order(Kind kind) noexcept { return kind == Kind::triharmonic ? 2 : 0; }

[[nodiscard]] const char* name(Kind kind) noexcept;

} // namespace hrbfnpr::kernel
