// SPDX-License-Identifier: MIT
// The tuning constants of what all producers of a drawing share.
#pragma once

namespace hrbfnpr::frame {

struct SceneTuning {
    // A camera that is fitted to something has its planes this part of its size (of half a box's diagonal) before and
    // after it. Larger: fewer distinct depths, but nothing is cut off that sticks out.
    double fit_slack = 0.1;

    // Stipples tell where an item's surface is unless they are fewer than this part of its largest layer. Larger: other
    // layers, which are spread less evenly, do so more often.
    double enough_stipples = 0.25;

    // A transform keeps cones of normals if it changes no product of unit vectors by more than this. Larger: cones are
    // trusted that do not hold all normals.
    float angle_tolerance = 1e-4F;

    // A bound of lengths is taken as larger by this factor, since it is computed in float. Larger: fewer clusters are
    // passed over.
    float rounding = 1.0001F;

    // A halo and its line are nearer than the ink that the halo cuts by at least this many pixels. Larger: fewer
    // lines are cut that touch the contour, and fewer that lie just after it.
    float halo_gap = 4.0F;

    // A disc of paper is this many spacings of its marks wide. Larger: no gaps, but wider rims. Set on evenly spread
    // marks.
    float splat_spacings = 1.5F;

    // A disc of paper is pushed back as if its |n . v| were no less than this. Larger: ink of a layer near its contour
    // is hidden by paper of that layer.
    float smallest_cosine = 0.05F;
};
inline constexpr SceneTuning scene_tuning;

} // namespace hrbfnpr::frame
