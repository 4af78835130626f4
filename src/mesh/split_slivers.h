// SPDX-License-Identifier: MIT
// Faces without an area that hold others together.
#pragma once

#include "mesh/weld.h"

namespace hrbfnpr::mesh {

// A face whose corners lie on a line, but for rounding, has a corner within its longest side.  Left out, it would leave
// a slit, and a solid would be open: the face across that side is cut in two there, and takes its place.  How many
// were.
[[nodiscard]] std::int64_t split_slivers(Welded& welded, const base::Progress& progress);

} // namespace hrbfnpr::mesh
