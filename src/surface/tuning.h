// SPDX-License-Identifier: MIT
// Tuning constants for casting many rays. Tuned with `scripts/bench points`, rows rays.*.
#pragma once

#include <cstdint>

namespace hrbfnpr::surface {

struct RayTuning {
    // The number of the largest cells along the longest side of the region. Larger: longer preparation, but rays find
    // bounds that are tighter.
    int cells_across = 16;
    // Cells that the surface may cross are divided if they are wider than this, in spacings of the centres. Smaller:
    // longer preparation, but fewer evaluations for each ray.
    double widest = 3.0;
    // The largest number of times that a cell is halved.
    int halvings = 6;
    // The bound on the second derivatives of a cell, as a multiple of the largest that was found in it. Larger: shorter
    // steps, but fewer rays that contradict the bound, and fewer missed roots.
    double safety = 1.5;
    // The errors of prepared values and gradients are at most this multiple of the largest error that was measured.
    // Larger: contradictions are noticed later.
    double error = 16.0;
    // A call prepares the fit for its rays where it would prepare it for this number of evaluations a ray. A marched
    // ray takes about 90 evaluations to its first hit, and making cells takes about as long as preparing. Larger: fewer
    // rays suffice.
    double evaluations = 50.0;
    // The number of rays of a task. Larger: more places of a cell are evaluated together, which is faster, but progress
    // and cancelling are slower.
    static constexpr std::int64_t batch = 2048;
};
inline constexpr RayTuning ray_tuning;

} // namespace hrbfnpr::surface
