// SPDX-License-Identifier: MIT
// Which components lie inside others.
#pragma once

#include "mesh/orient.h"

namespace hrbfnpr::mesh {

// Sets `nested` of components that lie wholly inside a closed one, as rays from some of their faces tell.
void find_nested(const base::Runtime& runtime, const base::Array<glm::dvec3>& vertex,
                 const base::Array<Triangle>& triangle, const base::Array<std::int32_t>& component,
                 base::Array<Component>& measured, const base::Progress& progress);

} // namespace hrbfnpr::mesh
