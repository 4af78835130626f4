// SPDX-License-Identifier: MIT
// Where the marks of lines that are laid on a surface pass over a crease.
#pragma once

#include "marks/site.h"

namespace hrbfnpr::marks {

// 1 of each place that is on another sheet than the one before it, so that a line must end between them; empty where
// the surface is smooth.  A place on the crease itself belongs to its line's sheet and gets its normal.  Places that
// are farther apart than `reach` are of different lines.
[[nodiscard]] base::Array<std::uint8_t> find_crease_ends(const Site& site, const geometry::VecArray& position,
                                                         geometry::VecArray& normal, double reach,
                                                         const base::Progress& progress);

} // namespace hrbfnpr::marks
