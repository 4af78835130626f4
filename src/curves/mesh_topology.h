// SPDX-License-Identifier: MIT
// Which triangle lies across each edge.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/runtime.h"

#include <cstdint>

namespace hrbfnpr::curves {

// For oriented triangles, no two of which have an edge in the same direction, as SurfaceMesh::neighbour.
[[nodiscard]] base::Array<std::int32_t> find_neighbours(const base::Runtime& runtime,
                                                        const base::Array<std::int32_t>& corner, std::int64_t vertices,
                                                        const base::Progress& progress = {});

} // namespace hrbfnpr::curves
