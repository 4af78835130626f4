// SPDX-License-Identifier: MIT
// A surface fitted to a mesh, with as many samples as that takes.
#pragma once

#include "fit/fit.h"
#include "mesh/edges.h"
#include "mesh/fit/compare.h"
#include "mesh/fit/outer.h"
#include "mesh/plan.h"

namespace hrbfnpr::mesh {

struct FitMeshSettings {
    double tolerance = 0.0; // 0: 0.002 diagonals
    double share = 0.99;
    double far = 0.0; // 0: five tolerances
    std::int64_t maximum_centres = 8000;
    std::int64_t candidates = 0; // 0: automatic
    std::uint64_t seed = 1;
    double crease_angle = default_crease_angle;
    Edges edges = Edges::automatic; // fit_mesh itself makes a smooth one
};

struct FitMeshReport {
    bool reached = false;
    bool supported = false; // the surface beyond the mesh's border does not count
    double tolerance = 0.0;
    double far = 0.0;
    std::int64_t candidates = 0;
    std::int64_t off_surface = 0; // centres
    std::int32_t rounds = 0;
    Spread surface;
    Spread mesh;
    Touching touching; // parts that are nearer to each other than the tolerance, so that the surface may join them
    double seconds_sample = 0.0;
    double seconds_fit = 0.0;
    double seconds_measure = 0.0;
    double seconds_total = 0.0;
};

struct MeshFit {
    fit::FitResult fit; // its samples: places all over the mesh
    FitMeshReport report;
};

// A fit that is under way, as an implicit. The data must outlive it.
class FitData final : public implicit::Implicit {
public:
    FitData(base::InstructionSet set, const implicit::HrbfData& data) noexcept : set_(set), data_(data) {}

    void evaluate(const implicit::PointBatch& points, const implicit::FieldBatch& fields) const override {
        implicit::evaluate(set_, data_, points, fields);
    }
    [[nodiscard]] bool concurrent() const noexcept override { return true; }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return data_.bounds; }

private:
    base::InstructionSet set_;
    const implicit::HrbfData& data_;
};

// Fills in the residuals at the centres, where the data is to have a normal, and a value or 0.
void describe_residuals(const base::Work& work, const implicit::HrbfData& data, const fit::Samples& centres,
                        fit::FitReport& to);

// options: kernel, solver and regularization; its views are empty, its tolerance and maximum_centres 0.
[[nodiscard]] MeshFit fit_mesh(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                               const FitMeshSettings& settings, const fit::FitInput& options);

} // namespace hrbfnpr::mesh
