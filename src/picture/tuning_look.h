// SPDX-License-Identifier: MIT
// Constants that decide which way is up, where the camera stands, and when a picture is blank.
#pragma once

#include <cstdint>

namespace hrbfnpr::picture {

struct UpTuning {
    // The relief of a terrain is below this, as a share of its shorter side. Larger: steeper shapes are terrains.
    double terrain_relief_most = 0.3;
    // The relief of a terrain is above this, as a share of its shorter side. Larger: flat plates are no terrains.
    double terrain_relief_least = 0.003;
    // The mean of a terrain's normals has at least this component along its axis. Larger: only flatter ground is a
    // terrain.
    double terrain_upward = 0.7;
    // At least this share of a terrain's samples faces one side along its axis. Larger: fewer overhangs are allowed.
    double terrain_one_side = 0.99;
    // A normal with a z component smaller than this, up or down, is ignored. Larger: more shapes count as seen from all
    // sides.
    double side_told = 0.05;
    // A shape may be a view from one side only if more than this share of its normals has a z component of at least
    // `side_told`.
    double view_share = 0.98;
    // In a view from one side the mean sign of the normals' z components exceeds this in magnitude. Larger: fewer
    // shapes are such views.
    double view_one_sided = 0.95;
    // Samples lower than this, as a share of the height, may belong to a flat end. Larger: thicker ends are flat.
    double end_height = 0.02;
    // The normals of a flat end have at least this component along the axis. Larger: ends must be flatter.
    double end_outward = 0.9;
    // A base holds at least this share of the samples. Larger: only broad bases count.
    double base_share = 0.05;
    // A base has at least this many times the samples of any other flat end. An object stands on its feet if its top
    // has more than this many times their samples. Larger: fewer shapes are clear.
    double base_over_others = 4.0;
    // Eastings and northings are at least this, in units of the source. Larger: only places far from 0 are on a map.
    double map_least = 10000.0;
    // Eastings and northings are also at least this many extents. Larger: only small places are on a map.
    double map_extents = 2.0;
    // The part on which a shape stands has this share of the height. Larger: feet reach higher.
    double foot_height = 0.04;
    // The hull of the feet covers at least this share of the hull of the shadow. Larger: only broad shapes stand.
    double foot_share = 0.3;
    // A shape that stands on z = 0 misses it by at most this share of its height. Larger: more shapes stand there.
    double ground_miss = 0.005;
    // The middle of a shape is at most this share of its sides away from 0. Larger: more shapes stand in the middle.
    double middle_miss = 0.05;
    // Mirrored samples that are nearer to others than this, in spacings, make both sides alike. Larger: more are alike.
    double mirrored_alike = 1.0;
    // Mirrored samples that are farther than this, in spacings, make both sides differ. Larger: fewer differ.
    double mirrored_unlike = 1.2;
    // The differing distance is also at least this many times the other one. Larger: fewer shapes are clear.
    double mirrored_clearly = 1.8;
    // Distances are compared at this percentile. Larger: a few differing samples make sides differ.
    double mirrored_percentile = 90.0;
    // At most this many samples are mirrored. Larger: slower, and no better where samples are even.
    std::int64_t mirrored_most = 1200;
    // A shape thinner than this share of its shorter side lies flat, and its faces are not left and right. Larger: more
    // shapes lie flat.
    double leaf_thickness = 0.1;
    // A hole to stand on has its border within this share of the height. Larger: slanted borders count.
    double hole_height = 0.15;
    // The hole has at least this share of all borders. Larger: other holes matter more.
    double hole_border = 0.5;
    // At the opposite end less than this share of all borders lies. Larger: tubes count as standing.
    double hole_above = 0.05;
    // Seen along its axis, the hole is this many times as large as along others. Larger: only level holes count.
    double hole_over_others = 2.0;
};
inline constexpr UpTuning up_tuning;

struct LookTuning {
    // A picture without a given size has this longer side, in pixels.
    std::int32_t long_side = 1600;
    // The shorter side is at least the longer one divided by this. Larger: slimmer pictures of slim objects.
    std::int32_t slimmest = 4;
    // The angles of a camera if none are given, in degrees. Larger: seen more from the right, and more from above.
    double azimuth = 30.0;
    double elevation = 20.0;
    // The vertical angle of view, in degrees. Larger: the camera stands nearer, and the perspective is stronger.
    double field_of_view = 30.0;
    // This share of a picture stays free on each side. Larger: the object is smaller in the picture.
    double margin = 0.05;
    // An open surface has a front if its mean normal, across the up axis, is longer than this. A half sphere has 0.5, a
    // box without one side 0.17. Larger: fewer open surfaces are turned to the camera.
    double looks_one_way = 0.25;
    // If the cosine between up and z is above this, the front is -y, else +z. Larger: tilted objects keep +z.
    double upright = 0.9;
    // This many marks measure a model's area and extent. Larger: slower, with a more exact frame.
    std::int64_t probe_marks = 2000;
    // The visible extent counts as at least this, in pixels, so that even a point has a frame.
    double least_extent = 1e-6;
    // The whole object must be in the picture at this many steps of an orbit. Larger: slower, with a more exact frame.
    std::int32_t orbit_steps = 24;
};
inline constexpr LookTuning look_tuning;

struct BlankTuning {
    // A pixel has ink if it differs from the paper by this, out of 255. Larger: faint ink does not count.
    double ink_seen = 16.0;
    // A picture is blank if a smaller share of its pixels has ink. Larger: more pictures are refused.
    double least_ink = 1e-4;
    // If a style shows tone by marks, a picture is blank if fewer than this share of the marks that face the eye is
    // shown and many are hidden. Larger: more pictures are refused.
    double least_shown = 0.03;
    // A share of hidden marks above this counts as many. Larger: fewer pictures are refused.
    double most_hidden = 0.4;
    // A surface faces away if the marks that show their back are this many times those that show their front. Larger:
    // the note appears less often.
    std::int64_t back_over_front = 20;
    // A cause counts if it removes one in this many of the marks that face the eye. Larger: more causes are named.
    double cause_divisor = 2.0;
};
inline constexpr BlankTuning blank_tuning;

} // namespace hrbfnpr::picture
