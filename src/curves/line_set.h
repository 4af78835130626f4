// SPDX-License-Identifier: MIT
// What the lines of a surface are drawn from, whatever the camera: made once for a model.
#pragma once

#include "curves/sheet_count.h"
#include "curves/surface_mesh.h"

#include <optional>
#include <span>

namespace hrbfnpr::curves {

struct LineSetSettings {
    double side = 0.0;             // of the mesh's cells; 0: half a spacing, and finer where walls are thinner
    std::span<const double> seeds; // 3n packed positions near the surface; empty: found from a lattice of the bounds
    double spacing = 0.0;          // mean, of the seeds; 0: not known
};

class LineSet {
public:
    // The implicit must outlive it.  Throws as triangulate() does, and Error{not_converged} where no surface is found.
    LineSet(const base::Runtime& runtime, const implicit::Implicit& surface, const LineSetSettings& settings,
            const base::Progress& progress);
    LineSet(const LineSet&) = delete;
    LineSet& operator=(const LineSet&) = delete;

    [[nodiscard]] const implicit::Implicit& surface() const noexcept { return surface_; }
    [[nodiscard]] const SurfaceMesh& mesh() const noexcept { return *mesh_; }
    [[nodiscard]] const SheetCounter& sheets() const noexcept { return *sheets_; }
    [[nodiscard]] double seconds() const noexcept { return seconds_; }
    [[nodiscard]] std::int64_t bytes() const noexcept { return mesh_->bytes() + sheets_->bytes(); }

private:
    const implicit::Implicit& surface_;
    std::optional<SurfaceMesh> mesh_;
    std::optional<SheetCounter> sheets_;
    double seconds_ = 0.0;
};

} // namespace hrbfnpr::curves
