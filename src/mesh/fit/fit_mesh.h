// SPDX-License-Identifier: MIT
// Fits a smooth surface to a mesh. The fit itself chooses places of the mesh as samples, and how many.
#pragma once

#include "fit/fit.h"
#include "mesh/edges.h"
#include "mesh/fit/compare.h"
#include "mesh/fit/outer.h"
#include "mesh/plan.h"

namespace hrbfnpr::mesh {

struct FitMeshSettings {
    double tolerance = 0.0; // 0 means 0.002 diagonals.
    double share = 0.99;
    double far = 0.0; // 0 means five tolerances.
    std::int64_t maximum_centres = 8000;
    std::int64_t candidates = 0; // 0 means automatic.
    std::uint64_t seed = 1;
    double crease_angle = default_crease_angle;
    Edges edges = Edges::automatic; // fit_mesh() ignores this, because it always makes a smooth fit.
};

struct FitMeshReport {
    bool reached = false;
    bool supported = false; // True if the mesh has a border. Surface beyond the border is then ignored.
    double tolerance = 0.0;
    double far = 0.0;
    std::int64_t candidates = 0;
    std::int64_t off_surface = 0; // the number of centres off the surface
    std::int32_t rounds = 0;
    DistanceStatistics surface;
    DistanceStatistics mesh;
    PartContact contact; // parts closer to each other than the tolerance, which the fit may have joined
    double seconds_sample = 0.0;
    double seconds_fit = 0.0;
    double seconds_measure = 0.0;
    double seconds_total = 0.0;
};

struct MeshFit {
    fit::FitResult fit; // The fit. Its samples are places all over the mesh.
    FitMeshReport report;
};

// An unfinished fit as an implicit. The data must outlive this object.
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

// Reports the residuals at the centres. The gradient should be the centre's normal, and f the centre's value, which is
// 0 on the surface.
void describe_residuals(const base::Work& work, const implicit::HrbfData& data, const fit::Samples& centres,
                        fit::FitReport& to);

// Fits a surface. `options` gives the kernel, the solver and the regularization; its views must be empty, and its
// tolerance and maximum_centres 0.
[[nodiscard]] MeshFit fit_mesh(const base::Work& work, const Mesh& mesh, const FaceTree& tree,
                               const FitMeshSettings& settings, const fit::FitInput& options);

} // namespace hrbfnpr::mesh
