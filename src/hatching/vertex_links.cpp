// SPDX-License-Identifier: MIT
#include "hatching/vertex_links.h"

namespace hrbfnpr::hatching {

// An edge between two triangles runs once each way.
VertexLinks::VertexLinks(base::Memory& memory, const curves::SurfaceMesh& mesh)
    : first(memory, mesh.vertices() + 1), to(memory, mesh.corner.size()) {
    for (const std::int32_t v : mesh.corner) ++first[v + 1];
    for (std::int64_t v = 0; v < mesh.vertices(); ++v) first[v + 1] += first[v];
    base::Array<std::int64_t> at(memory, mesh.vertices());
    for (std::int64_t v = 0; v < mesh.vertices(); ++v) at[v] = first[v];
    for (std::int64_t edge = 0; edge < mesh.corner.size(); ++edge) {
        to[at[mesh.corner[edge]]++] = mesh.corner[edge - edge % 3 + (edge % 3 + 1) % 3];
    }
}

} // namespace hrbfnpr::hatching
