// SPDX-License-Identifier: MIT
// How large what marks are placed on may be.
#pragma once

namespace hrbfnpr::marks {

// Diagonals of what marks, which are floats, can be placed on: their distances and curvatures, in the caller's unit,
// stay within a float's normal range.
inline constexpr double smallest_size = 1e-33;
inline constexpr double largest_size = 1e33;

// Throws Error{invalid_argument} for sizes beyond; `what` has that size, and `remedy` is scaled.
void require_size(const char* what, double size, const char* remedy);

} // namespace hrbfnpr::marks
