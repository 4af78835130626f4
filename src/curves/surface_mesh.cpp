// SPDX-License-Identifier: MIT
#include "curves/surface_mesh.h"

namespace hrbfnpr::curves {

std::int64_t SurfaceMesh::bytes() const noexcept {
    return position.bytes() + gradient.bytes() + corner.bytes() + neighbour.bytes();
}

} // namespace hrbfnpr::curves
