// SPDX-License-Identifier: MIT
// A function g in space: its zero lines on the surface f = 0 are curves to be drawn. The contour of a view and the
// border of a surface's support are such lines.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/runtime.h"
#include "curves/surface_mesh.h"
#include "geometry/vec.h"
#include "implicit/implicit.h"
#include "surface/support.h"

#include <array>

namespace hrbfnpr::curves {

// The camera as curves see it: in the surface's own coordinates.
struct View {
    glm::dvec4 eye{0.0, 0.0, 0.0, 1.0}; // w = 1: where the eye is; w = 0: the direction in which it looks
    glm::dmat4 to_window{1.0};          // to (x w, y w, depth w, w), pixels

    // From the eye to a point, not normalised.
    [[nodiscard]] glm::dvec3 sight(const glm::dvec3& p) const noexcept {
        return eye.w == 0.0 ? glm::dvec3(eye) : p - glm::dvec3(eye);
    }
};

// Where the values of f and g and their gradients are written. No pointer is null.
struct LevelBatch {
    double* value = nullptr;
    std::array<double*, 3> gradient{};
    double* level = nullptr;
    std::array<double*, 3> level_gradient{};
};

class Level {
public:
    Level() = default;
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;
    virtual ~Level() = default;

    [[nodiscard]] virtual const implicit::Implicit& surface() const noexcept = 0;
    // Evaluates at most implicit::batch_size points on the calling thread. g and its gradient need to be right near
    // f = 0 only.
    virtual void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const = 0;
    // g at the vertices of a mesh of the surface, by the gradients that the mesh holds. `level` is resized.
    virtual void at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                             const base::Progress& progress) const = 0;
};

// The occluding contour: g = grad f . v, where v leads from the eye to the point.
class ContourLevel final : public Level {
public:
    ContourLevel(const implicit::Implicit& surface, const View& view) noexcept : surface_(surface), view_(view) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    [[nodiscard]] const View& view() const noexcept { return view_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override;
    void at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                     const base::Progress& progress) const override;

private:
    const implicit::Implicit& surface_;
    View view_;
};

// The border of the support: g = s - limit, s of surface/support.h. The surface lies to the left of the border.
class SupportLevel final : public Level {
public:
    SupportLevel(const implicit::Implicit& surface, const surface::Support& support, double limit) noexcept
        : surface_(surface), support_(support), limit_(limit) {}

    [[nodiscard]] const implicit::Implicit& surface() const noexcept override { return surface_; }
    void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const override;
    void at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                     const base::Progress& progress) const override;

private:
    const implicit::Implicit& surface_;
    const surface::Support& support_;
    double limit_;
};

} // namespace hrbfnpr::curves
