// SPDX-License-Identifier: MIT
// The values of these enumerators equal those of HRBFNPR_SOLVER_* and HRBFNPR_SOLVER_REASON_*.
#pragma once

#include <cstdint>

namespace hrbfnpr::fit {

enum class SolverKind : std::uint32_t { automatic = 0, direct = 1, iterative = 2 };
enum class SolverReason : std::uint32_t { requested = 0, small = 1, large = 2, not_converged = 3, not_definite = 4 };

} // namespace hrbfnpr::fit
