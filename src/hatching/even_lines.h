// SPDX-License-Identifier: MIT
// Lines that run beside each other are moved to the middle between their neighbours.
#pragma once

#include "hatching/stripe_lines.h"

namespace hrbfnpr::hatching {

// Moves go across the lines, in the planes of their normals, and change slowly along a line, so that none is bent.
// Ends without room between their neighbours are cut off, and so are lines of which little is left.  Points of the
// result are about half a separation apart.  The same bits for any number of threads.
[[nodiscard]] StripeLines evened(const base::Runtime& runtime, const StripeLines& lines, double separation,
                                 const base::Progress& progress);

} // namespace hrbfnpr::hatching
