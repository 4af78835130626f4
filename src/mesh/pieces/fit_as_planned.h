// SPDX-License-Identifier: MIT
// Fits a surface to a mesh as mesh/plan.h decides: as one smooth function or as sheets that meet in creases. It also
// decides where the surface ends.
#pragma once

#include "mesh/pieces/creases.h"
#include "mesh/pieces/fit_sheet_tree.h"
#include "mesh/pieces/has_creases.h"

#include <optional>

namespace hrbfnpr::mesh {

struct PlannedCreases {
    std::optional<Creases> creases; // The creases of the surface; empty if one smooth fit is enough.
    // The total length, in diagonals, of doubtful edges, which bend by more than the crease angle but do not stand out.
    double doubtful = 0.0;
};

// Finds the creases that settings.edges asks for. `known` is the evidence for the angle default_crease_angle.
[[nodiscard]] PlannedCreases find_planned_creases(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                                  const CreaseEvidence& known, const FitMeshSettings& settings);

// Measures the facts that plan_end() needs. `has_creases` is true if fit_pieces() made the fit.
[[nodiscard]] EndFacts end_facts(const Mesh& mesh, const FitMeshReport& report, bool has_creases) noexcept;

// Returns places spread over a mesh. Their support ends where the mesh ends.
[[nodiscard]] MeshSamples end_places(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                     const EndPlan& plan, std::uint64_t seed);

struct PlannedFit {
    explicit PlannedFit(base::Memory& memory) noexcept : end_place(memory), end_normal(memory) {}

    std::optional<fit::FitResult> smooth; // the smooth fit, without its samples
    std::optional<SheetTreeFit> pieces;   // set if there is no smooth fit
    FitMeshReport report;
    std::int64_t centres = 0;
    EndPlan end;
    geometry::VecArray end_place; // The surface ends where the support of these places ends, unless `end` is nowhere.
    geometry::VecArray end_normal;
};

// Fits a surface, and logs the result. If `may_end` is false, the surface does not end.
[[nodiscard]] PlannedFit fit_as_planned(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                                        const CreaseEvidence& known, const FitMeshSettings& settings,
                                        const fit::FitInput& options, bool may_end);

} // namespace hrbfnpr::mesh
