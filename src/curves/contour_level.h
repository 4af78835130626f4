// SPDX-License-Identifier: MIT
// The occluding contour: g = grad f . v, v from the eye to the point.
#pragma once

#include "curves/level.h"
#include "curves/view.h"

namespace hrbfnpr::curves {

class ContourLevel final : public Level {
public:
    ContourLevel(const implicit::Implicit& surface, const View& view) noexcept : surface_(surface), view_(view) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override;
    void at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                     const base::Progress& progress) const override;

private:
    void evaluate_block(const implicit::PointBatch& points, const LevelBatch& out) const;

    const implicit::Implicit& surface_;
    View view_;
};

} // namespace hrbfnpr::curves
