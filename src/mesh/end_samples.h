// SPDX-License-Identifier: MIT
// Samples that tell where an open mesh ends: a support of them ends where the mesh does (surface/support.h).
#pragma once

#include "mesh/face_tree.h"
#include "mesh/sample.h"

namespace hrbfnpr::mesh {

// So many even ones, and in place of those that are nearest to the border a row along it: so far inside that s, whose
// spacings are `closest` at least, is 1.5 on the border.  Random ones would end it like torn paper.  Borders that are
// no longer than that of a hole that stays closed have none.
[[nodiscard]] MeshSamples end_samples(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                                      std::int64_t count, double closest, std::uint64_t seed,
                                      const base::Progress& progress);

// Of all borders.
[[nodiscard]] double border_length(const Mesh& mesh) noexcept;

} // namespace hrbfnpr::mesh
