// SPDX-License-Identifier: MIT
// The tuning constants that all producers of a drawing share.
#pragma once

namespace hrbfnpr::frame {

struct SceneTuning {
    // A camera that is fitted to an object has its near and far planes this share of the object's size before and
    // behind it. The size of a box is half of its diagonal. Larger: fewer distinct depths, but parts that stick out are
    // not cut off.
    double fit_slack = 0.1;

    // Stipples become the splats of an item unless they are fewer than this share of its largest layer. Larger: other
    // layers, which are spread less evenly, do so more often.
    double enough_stipples = 0.25;

    // A transform counts as keeping angles if it changes the scalar product of two unit vectors by no more than this.
    // Larger: cones of normals are used that do not hold all normals.
    float angle_tolerance = 1e-4F;

    // Bounds of lengths are multiplied by this, since they are computed in float. Larger: fewer clusters are skipped.
    float rounding = 1.0001F;

    // A halo cuts ink that is farther than its line by at least this many pixels. Larger: fewer lines are cut that
    // touch the contour, and fewer that lie just behind it.
    float halo_gap = 4.0F;

    // A disc of paper is this many spacings of its marks wide. Larger: no gaps, but wider rims. Tuned on evenly spread
    // marks.
    float splat_spacings = 1.5F;

    // |n . v| counts as at least this where a disc of paper is pushed back. Larger: paper of a layer hides ink of the
    // same layer near its contour.
    float smallest_cosine = 0.05F;
};
inline constexpr SceneTuning scene_tuning;

} // namespace hrbfnpr::frame
