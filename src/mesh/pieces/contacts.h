// SPDX-License-Identifier: MIT
// Patches of solids that lie against another: boxes that stand on each other, say.
#pragma once

#include "mesh/face_tree.h"
#include "mesh/pieces/creases.h"
#include "mesh/sample.h"

namespace hrbfnpr::mesh {

// 1 for each patch that has a place, of those given, at which a face of another component looks the other way and is no
// farther than `near`; and for the patch of that face.
[[nodiscard]] base::Array<std::uint8_t> patches_in_contact(const base::Runtime& runtime, const Mesh& mesh,
                                                           const FaceTree& tree, const Creases& creases,
                                                           const MeshSamples& places, double near,
                                                           const base::Progress& progress);

} // namespace hrbfnpr::mesh
