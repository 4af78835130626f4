// SPDX-License-Identifier: MIT
// Value, gradient and Hessian of [NPAR equation 1] at once, for the triharmonic kernel: for a few targets here and
// there, as curves ask for.  The lanes of a vector are sources, so that one target fills them; and the three sums share
// what they are made of.  hermite_sums.h and hermite_hessians.h, whose lanes are targets, give the same but for
// rounding.
#pragma once

#include "implicit/hermite_sums.h"

namespace hrbfnpr::implicit {

// Of sources that stand side by side.
struct SourceRange {
    std::int64_t begin, end;
};

// The sums are added to what stands in the arrays (Hessian xx xy xz yy yz zz), which alias nothing.
struct JetTargets {
    const double* x;
    const double* y;
    const double* z;
    double* value;
    double* gradient[3];
    double* hessian[6];
    std::int64_t count;
};

// Each target's sum is taken in the order of the ranges, whatever stands beside it.
using AddTriharmonicJets = void (*)(const Sources& sources, const SourceRange* ranges, std::int64_t count,
                                    const JetTargets& targets);

[[nodiscard]] AddTriharmonicJets triharmonic_jets_of(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::implicit
