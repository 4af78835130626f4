// SPDX-License-Identifier: MIT
// Lines whose ends face each other over a small gap become one: a mesh does not always see them through a fork.
#pragma once

#include "hatching/stripe_lines.h"

namespace hrbfnpr::hatching {

// Ends no farther apart than `reach`, that run towards each other.
[[nodiscard]] StripeLines joined(base::Memory& memory, const StripeLines& lines, double reach,
                                 const base::Progress& progress);

} // namespace hrbfnpr::hatching
