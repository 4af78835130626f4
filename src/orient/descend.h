// SPDX-License-Identifier: MIT
// The least energy over unit normals, from given ones.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"

#include <functional>

namespace hrbfnpr::orient {

// The energy of normals; writes half its derivative.
using Energy = std::function<double(const geometry::VecArray& normal, geometry::VecArray& beta)>;

struct DescentOptions {
    int steps = 60;
    double enough = 1e-5; // ends when five steps gained less than this share of the energy
};

// Limited-memory BFGS (Nocedal 1980) on a product of spheres, scaled by the energy's stiffness at each normal.
// Returns the energy reached.
double descend(const base::Runtime& runtime, const Energy& energy, const base::Array<double>& stiffness,
               const DescentOptions& options, geometry::VecArray& normal, const base::Progress& progress);

} // namespace hrbfnpr::orient
