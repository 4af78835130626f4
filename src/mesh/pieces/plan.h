// SPDX-License-Identifier: MIT
// The decisions of a fit to a mesh: whether its surface has creases, and where it ends.
#pragma once

#include "mesh/end_samples.h"
#include "mesh/fit/fit_mesh.h"
#include "mesh/pieces/creases.h"
#include "mesh/pieces/has_creases.h"

#include <optional>

namespace hrbfnpr::mesh {

struct CreasePlan {
    std::optional<Creases> creases; // that the surface is to have; nothing: one smooth fit will do
    double doubtful = 0.0;          // length of edges beyond the crease angle that do not stand out, in diagonals
};

// Chooses the creases of a fit, as settings.edges asks for.  known: the evidence at default_crease_angle.
[[nodiscard]] CreasePlan plan_creases(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                                      const CreaseEvidence& known, const FitMeshSettings& settings,
                                      const base::Progress& progress);

enum class End {
    nowhere,    // the surface stays whole
    at_places,  // it ends where end_places() do
    at_samples, // it ends where the samples of the fit do
};

struct EndPlan {
    End end = End::nowhere;
    double off = 0.0; // diagonals: surface that is farther than this from the mesh is none of it
};

// Chooses the end of a surface from the mesh and from how near the fit came to it.  has_creases: fit_pieces() made it.
[[nodiscard]] EndPlan plan_end(const Mesh& mesh, const FitMeshReport& report, bool has_creases) noexcept;

// Places all over a mesh: a support of them ends where the mesh does.
[[nodiscard]] MeshSamples end_places(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                                     const EndPlan& plan, std::uint64_t seed, const base::Progress& progress);

} // namespace hrbfnpr::mesh
