// SPDX-License-Identifier: MIT
// Value, gradient and Hessian of [NPAR equation 1] at once, for the triharmonic kernel and a few scattered targets, as
// curves need. The lanes of a vector are sources, so that one target fills them, and the three sums share intermediate
// results. hermite_sums.h and hermite_hessians.h, whose lanes are targets, give the same but for rounding.
#pragma once

#include "implicit/hermite_sums.h"

namespace hrbfnpr::implicit {

// A range of consecutive sources.
struct SourceRange {
    std::int64_t begin, end;
};

// The sums are added to the arrays (Hessian xx xy xz yy yz zz). No pointers alias.
struct JetTargets {
    const double* x;
    const double* y;
    const double* z;
    double* value;
    double* gradient[3];
    double* hessian[6];
    std::int64_t count;
};

// Each target's sum is taken in the order of the ranges, whatever targets are beside it.
using AddTriharmonicJets = void (*)(const Sources& sources, const SourceRange* ranges, std::int64_t count,
                                    const JetTargets& targets);

[[nodiscard]] AddTriharmonicJets triharmonic_jets_of(base::InstructionSet set) noexcept;

} // namespace hrbfnpr::implicit
