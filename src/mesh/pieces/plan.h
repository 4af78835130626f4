// SPDX-License-Identifier: MIT
// Decides for a fit to a mesh whether its surface has creases and where the surface ends.
#pragma once

#include "mesh/fit/fit_mesh.h"
#include "mesh/pieces/creases.h"
#include "mesh/pieces/has_creases.h"
#include "mesh/sample.h"

#include <optional>

namespace hrbfnpr::mesh {

struct CreasePlan {
    std::optional<Creases> creases; // The creases of the surface; empty if one smooth fit is enough.
    double doubtful = 0.0;          // The length of edges beyond the crease angle that do not stand out, in diagonals.
};

// Chooses the creases of a fit as settings.edges asks. `known` is the evidence at default_crease_angle.
[[nodiscard]] CreasePlan plan_creases(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                                      const CreaseEvidence& known, const FitMeshSettings& settings,
                                      const base::Progress& progress);

enum class End {
    nowhere,    // The surface stays whole.
    at_places,  // The surface ends where end_places() end.
    at_samples, // The surface ends where the samples of the fit end.
};

struct EndPlan {
    End end = End::nowhere;
    double off = 0.0; // Surface farther than this from the mesh does not belong to it, in diagonals.
};

// Chooses the end of a surface from the mesh and from how near the fit came to it. `has_creases` tells that
// fit_pieces() made the fit.
[[nodiscard]] EndPlan plan_end(const Mesh& mesh, const FitMeshReport& report, bool has_creases) noexcept;

// Returns places all over a mesh. A support around them ends where the mesh ends.
[[nodiscard]] MeshSamples end_places(const base::Runtime& runtime, const Mesh& mesh, const FaceTree& tree,
                                     const EndPlan& plan, std::uint64_t seed, const base::Progress& progress);

} // namespace hrbfnpr::mesh
