// SPDX-License-Identifier: MIT
// Value, gradient and Hessian of [NPAR equation 1] together, for the triharmonic kernel and a few scattered targets, as
// tracing curves needs them. The lanes of a SIMD vector are sources, so a single target fills the vector, and the three
// sums share intermediate results. hermite_sums.h and hermite_hessians.h, whose lanes are targets, give the same
// results up to rounding.
#pragma once

#include "implicit/hermite_sums.h"

namespace hrbfnpr::implicit {

// A range of consecutive sources.
struct SourceRange {
    std::int64_t begin, end;
};

// The arrays to which the sums are added (Hessian xx xy xz yy yz zz). Pointers must not alias.
struct JetTargets {
    const double* x;
    const double* y;
    const double* z;
    double* value;
    double* gradient[3];
    double* hessian[6];
    std::int64_t count;
};

// The sum of a target is always taken in the order of the ranges, whichever other targets the call has.
using AddTriharmonicJets = void (*)(const Sources& sources, const SourceRange* ranges, std::int64_t count,
                                    const JetTargets& targets);

[[nodiscard]] AddTriharmonicJets triharmonic_jets_of(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::implicit
