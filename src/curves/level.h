// SPDX-License-Identifier: MIT
// A function g in space: its zero lines on the surface f = 0 are curves to be drawn.
#pragma once

#include "base/memory.h"
#include "base/operation.h"
#include "base/runtime.h"
#include "curves/surface_mesh.h"
#include "implicit/implicit.h"

#include <array>

namespace hrbfnpr::curves {

// Where the values of f and g and their gradients go: all of them are wanted.
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
    // On the calling thread; at most implicit::batch_size points.  g and its gradient need only be right near f = 0.
    virtual void evaluate(const implicit::PointBatch& points, const LevelBatch& out) const = 0;
    // g at the vertices of a mesh of the surface, by what the mesh holds; resized.
    virtual void at_vertices(const base::Runtime& runtime, const SurfaceMesh& mesh, base::Array<double>& level,
                             const base::Progress& progress) const = 0;
};

} // namespace hrbfnpr::curves
