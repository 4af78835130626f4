// SPDX-License-Identifier: MIT
// The tuning constants that all kinds of drawings share.
#pragma once

#include <cstdint>

namespace hrbfnpr::frame {

struct SceneTuning {
    // The distance of the near and far planes from a fitted object, as a share of its size. The size of a box is half
    // of its diagonal. Larger: fewer distinct depths, but parts that stick out are not cut off.
    double fit_slack = 0.1;

    // Stipples are the splats of an item if their number is at least this share of its largest layer. Larger: other
    // layers, which are spread less evenly, are used more often.
    double enough_stipples = 0.25;

    // A transform counts as keeping angles if it changes the scalar product of two unit vectors by at most this.
    // Larger: cones of normals are used that do not contain all normals.
    float angle_tolerance = 1e-4F;

    // The bounds of lengths are multiplied by this, because they are computed in float. Larger: fewer clusters are
    // skipped.
    float rounding = 1.0001F;

    // A halo hides ink that is farther from the eye than the halo's line by at least this many pixels. Larger: fewer
    // lines that touch the contour are cut, and fewer lines that are just behind it.
    float halo_gap = 4.0F;

    // The width of a disc of paper, in spacings of its marks. Larger: no gaps, but wider rims. Tuned on evenly spread
    // marks.
    float splat_spacings = 1.5F;

    // If all marks together cover less than this share of the paper, they are shown as if they covered this share. Dark
    // tones then still differ. Larger: paler pictures where there are few marks.
    float darkest = 0.6F;

    // Stipples that are even in the picture: where |n . v| is at least `even_turn` below 1, more may be shown than the
    // tone wants, by the share `even_surplus`. Larger `even_turn` and smaller `even_surplus`: less time, and rows where
    // the surface turns away.
    float even_turn = 0.4F;
    float even_surplus = 0.6F;

    // How far above the surface the rays of occlusion and shadows begin, in sides of the cells of the meshes that cast
    // shadows. Larger: no spots where a mesh lies above the surface, but light leaks where surfaces touch.
    double shading_offset = 0.25;

    // If a scene has creases, the eye or a light is moved to one side by about this share of its distance, so that it
    // grazes no face. Larger: lines move visibly.
    double off_planes = 2e-5;
    // The direction of that move, an angle in radians that is unlikely to be in a plane of symmetry.
    double off_planes_angle = 0.9;

    // ---- Borders of shadows. A cell is the side of a cell of the mesh on which lines are found.

    // Rays that touch an outline begin this far beside it, in cells. Larger: fewer rays meet the mesh of their own
    // surface, but borders end farther from the things that hide them.
    double shadow_offset = 0.05;
    // Where a ray meets the mesh of its own surface within the distance `shadow_near`, in cells, the exact surface is
    // evaluated at `near_places` places up to this distance. The ray is inside the surface if a place is deeper than
    // `least_depth` cells. The exact place of a shadow is at most `shadow_near` from the mesh along the ray. Larger
    // distances and more places: more time. Larger depths: shadows begin later.
    double shadow_near = 4.0;
    std::int64_t near_places = 16;
    double least_depth = 1e-4;
    // A ray meets its own surface only beyond this distance, in cells. If it meets the mesh but not the surface, it
    // goes on after this distance. Larger: gaps where a cast shadow begins, and thin things right behind the mesh are
    // missed.
    double shadow_start = 1e-3;
    // Two points of a border are linked if they are at most `longest_border` cells apart and if the line turns by less
    // than 0.15 radians at either, given as a cosine. Larger: corners are cut, and borders jump between parts.
    double longest_border = 1.5;
    double straight_border = 0.9888;
    // Points closer than this, in cells, are linked in any case. If the line turns there by more than 25 degrees, given
    // as a cosine, it has a corner. Larger: borders jump across small steps.
    double shortest_border = 0.02;
    double border_corner = 0.906;
    // Points are added until the parts of outlines between them are shorter than this share of a traced piece. Smaller:
    // ends are more exact, more rays.
    double least_share = 1e-3;
    // Ends of borders within this distance, in cells, are joined.
    double border_gap = 0.1;
    // Borders are left out if they and those that they are joined with are shorter than this, in diagonals of all
    // casters. Larger: less noise on rough surfaces, but small shadows are lost.
    double shortest_shadow = 0.01;

    // The distance between splats in pixels, if a layer has enough marks. The second constant is for splats near the
    // contour. Larger: less time, but small features are missed.
    float splat_spacing = 6.0F;
    float contour_splat_spacing = 4.0F;

    // A still picture needs marks outside of it up to this share of its diagonal. Larger: more marks are placed, and
    // strokes that leave the picture end farther outside.
    float still_margin = 0.02F;
    // The largest angles, in radians, between a given normal and the normals around it: those within the reach of a
    // place (20 degrees), and those that decide the tone of the marks at a place (8 degrees). Larger: more marks are
    // placed.
    float still_surface_cone = 0.34906585F;
    float still_tone_cone = 0.13962634F;
    // Marks whose |n . v| is larger than this are not near a contour of a still picture. Larger: more splats are
    // placed.
    float still_rim_nu = 0.2F;
    // A still picture gets this many times the marks that its tone is expected to show, because normals for tone are
    // averaged. Larger: more marks are placed.
    float still_surplus = 1.1F;

    // A part of a stroke in one ink is at least this many times as long as it is wide. Shorter parts take the ink of a
    // neighbour. Larger: fewer and longer parts, and colours with borders that are less exact.
    float shortest_in_ink = 2.0F;
    // Mixtures of inks are compared by their chromaticities; the square of a difference has the cost 1.
    // `lightness_cost` is the cost of the square of the distance in linear light. Larger: colours that are darker or
    // lighter than all inks change their hue. `grain_cost` is the cost of the variance of the inks' colours. Larger:
    // less grain and less exact colours.
    float lightness_cost = 2e-3F;
    float grain_cost = 2e-7F;

    // The least |n . v| that is used where a disc of paper is pushed back. Larger: the paper of a layer hides ink of
    // the same layer near its contour.
    float smallest_cosine = 0.05F;
};
inline constexpr SceneTuning scene_tuning;

} // namespace hrbfnpr::frame
