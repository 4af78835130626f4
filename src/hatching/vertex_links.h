// SPDX-License-Identifier: MIT
// The neighbours of each vertex of a mesh.
#pragma once

#include "base/memory.h"
#include "curves/surface_mesh.h"

#include <span>

namespace hrbfnpr::hatching {

struct VertexLinks {
    VertexLinks(base::Memory& memory, const curves::SurfaceMesh& mesh);

    [[nodiscard]] std::span<const std::int32_t> of(std::int64_t vertex) const noexcept {
        return to.span().subspan(static_cast<std::size_t>(first[vertex]),
                                 static_cast<std::size_t>(first[vertex + 1] - first[vertex]));
    }

    base::Array<std::int64_t> first; // of each vertex, and the end
    base::Array<std::int32_t> to;    // one of an edge at a border is missing on one side
};

} // namespace hrbfnpr::hatching
