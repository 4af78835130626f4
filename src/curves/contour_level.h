// SPDX-License-Identifier: MIT
// The occluding contour: g = grad f . v, v from the eye to the point.
#pragma once

#include "curves/curves.h"
#include "curves/view.h"

namespace hrbfnpr::curves {

class ContourLevel final : public Level {
public:
    ContourLevel(const implicit::Implicit& surface, const View& view) noexcept : surface_(surface), view_(view) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override;
    void at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                     const base::Progress& progress) const override;
    // Where points of contours of another view come to in this one, by a Newton's step with what is known of f there:
    // grad g changes as little as the view.  Those that move by more than `farthest` are left out.
    [[nodiscard]] Curves moved(base::Memory& memory, const Curves& contours, double farthest) const;

private:
    void evaluate_block(const implicit::PointBatch& points, const LevelBatch& out) const;

    const implicit::Implicit& surface_;
    View view_;
};

} // namespace hrbfnpr::curves
