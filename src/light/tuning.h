// SPDX-License-Identifier: MIT
// Tuning constants for occlusion and shadows. Tuned with `scripts/bench light`.
#pragma once

#include <cstdint>

namespace hrbfnpr::light {

struct LightTuning {
    // Samples within this distance of a place, in spacings of the samples, count. Larger: less noise, but more blur.
    double kernel = 2.2;
    // Samples count less, the more their normals turn away from that of the place, down to this cosine. Smaller: more
    // blur across edges.
    double least_cosine = 0.8;
    // Samples farther than this from the place's tangent plane, in spacings, do not count. Larger: more blur across
    // steps.
    double off_plane = 0.6;
    // A place has own rays if the standard deviation of its samples is above this. Smaller: more rays.
    double most_spread = 0.07;
    // A place has own rays if the sum of the weights of its samples is below this. Larger: more rays.
    double least_weight = 0.6;
    // The number of rays that decide whether a place is in the penumbra: all of them meet a mesh, or none does. Larger:
    // narrower shadows are found.
    std::int32_t first_rays = 5;
    // Rays to a lamp begin at most this many offsets away from their places. Larger: borders of shadows are more exact
    // in flat light, but light leaks where surfaces meet.
    double longest_start = 3.0;
    // The triangles of a cell with this side, in scales of the curvature, count as one patch. Larger: less time, but
    // curvature is less smooth.
    double patch = 0.6;
    // The mean of curvature reaches at least this many sides of the mesh's cells. Larger: less noise, but more blur.
    double least_reach = 3.0;
    // The contrast of curvature is the hyperbolic tangent of this number times the mean curvature times its scale.
    // Larger: gentle ridges and hollows count more, but sharp ones look alike.
    double bend_gain = 3.0;
};
inline constexpr LightTuning light_tuning;

} // namespace hrbfnpr::light
