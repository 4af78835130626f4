// SPDX-License-Identifier: MIT
// Constants of which way is up, where the camera stands, and when a picture is blank.
#pragma once

#include <cstdint>

namespace hrbfnpr::picture {

struct UpTuning {
    // A terrain has a relief of less than this, as a share of its shorter side. Larger: steeper things are terrains.
    double terrain_relief_most = 0.3;
    // A terrain has a relief of more than this, as a share of its shorter side. Larger: flat plates are no terrains.
    double terrain_relief_least = 0.003;
    // The mean of a terrain's normals has at least this part along its axis. Larger: only flatter ground is a terrain.
    double terrain_upward = 0.7;
    // The share of a terrain's samples that look to one side along its axis. Larger: fewer overhangs are allowed.
    double terrain_one_side = 0.99;
    // Normals with a smaller part along z than this tell no side. Larger: more shapes are seen from all sides.
    double side_told = 0.05;
    // A share of samples whose normals tell a side along z, above which a shape may be a view from one side only.
    double view_share = 0.98;
    // How one-sided these normals are, from 0 to 1, for a view from one side. Larger: fewer shapes are such views.
    double view_one_sided = 0.95;
    // Samples lower than this, as a share of the height, may belong to a flat end. Larger: thicker ends are flat.
    double end_height = 0.02;
    // The least part of a flat end's normals along the axis. Larger: ends must be flatter.
    double end_outward = 0.9;
    // A base holds at least this share of the samples. Larger: only broad bases count.
    double base_share = 0.05;
    // A base is this many times as large as any other flat end, and a top as the feet. Larger: fewer shapes are clear.
    double base_over_others = 4.0;
    // Eastings and northings are at least this, in units of the source. Larger: only places far from 0 are on a map.
    double map_least = 10000.0;
    // They are also at least this many extents. Larger: only small places are on a map.
    double map_extents = 2.0;
    // The part that a thing stands on has this share of the height. Larger: feet reach higher.
    double foot_height = 0.04;
    // The feet's hull covers at least this share of the shadow's. Larger: only broad things stand.
    double foot_share = 0.3;
    // A thing that stands on z = 0 misses it by at most this share of its height. Larger: more things stand there.
    double ground_miss = 0.005;
    // Its middle is at most this share of its sides away from 0. Larger: more things stand in the middle.
    double middle_miss = 0.05;
    // Mirrored samples that are nearer to others than this, in spacings, make both sides alike. Larger: more are alike.
    double mirrored_alike = 1.0;
    // Mirrored samples that are farther than this, in spacings, make both sides differ. Larger: fewer differ.
    double mirrored_unlike = 1.2;
    // Those that differ are also this many times as far as those that are alike. Larger: fewer shapes are clear.
    double mirrored_clearly = 1.8;
    // Distances are compared at this percentile. Larger: a few samples that differ make sides differ.
    double mirrored_percentile = 90.0;
    // The most samples that are mirrored. Larger: slower, and no better where samples are even.
    std::int64_t mirrored_most = 1200;
    // A shape thinner than this share of its shorter side lies, and its faces are not left and right. Larger: more lie.
    double leaf_thickness = 0.1;
    // A hole to stand on has its border in this share of the height. Larger: slanted borders count.
    double hole_height = 0.15;
    // This share of all borders belongs to it. Larger: other holes matter more.
    double hole_border = 0.5;
    // Less than this share of all borders lies as high above. Larger: tubes count as standing.
    double hole_above = 0.05;
    // Seen along its axis the hole is this many times as large as along others. Larger: only level holes count.
    double hole_over_others = 2.0;
};
inline constexpr UpTuning up_tuning;

struct LookTuning {
    // Pixels of the longer side of a picture whose size is not given.
    std::int32_t long_side = 1600;
    // The shorter side has at least this part of the longer one, as a divisor. Larger: slimmer pictures of slim things.
    std::int32_t slimmest = 4;
    // Degrees of a camera that nothing is said of. Larger: seen more from the right, and more from above.
    double azimuth = 30.0;
    double elevation = 20.0;
    // Degrees, the vertical angle of view. Larger: nearer, with a stronger perspective.
    double field_of_view = 30.0;
    // The share of a picture that is free on each side. Larger: the object is smaller in it.
    double margin = 0.05;
    // An open surface has a front if its mean normal, across the up axis, is longer than this: half of a sphere has
    // 0.5, a box without one side 0.17. Larger: fewer open surfaces are turned to the camera.
    double looks_one_way = 0.25;
    // Where up is nearer to z than this cosine, the front is -y, else +z. Larger: tilted things keep +z.
    double upright = 0.9;
    // Marks that are placed to learn a model's area and where it is. Larger: slower, with a more exact frame.
    std::int64_t probe_marks = 2000;
    // Pixels: what is seen is taken to be at least this large, so that a point has a frame.
    double least_extent = 1e-6;
    // Steps of an orbit at which the picture must hold all. Larger: slower, with a more exact frame.
    std::int32_t orbit_steps = 24;
};
inline constexpr LookTuning look_tuning;

struct BlankTuning {
    // Of 255: a pixel that differs from the paper by this has ink. Larger: fainter ink is none.
    double ink_seen = 16.0;
    // A picture with a smaller share of such pixels is blank. Larger: more pictures are refused.
    double least_ink = 1e-4;
    // A picture is blank if fewer than this share of the marks that face the eye are shown, in a style that shows tone
    // by marks, and many are hidden. Larger: more pictures are refused.
    double least_shown = 0.03;
    // The share of hidden marks that counts as many. Larger: fewer pictures are refused.
    double most_hidden = 0.4;
    // A surface looks away if this many times as many marks show their back as their front. Larger: said less often.
    std::int64_t back_over_front = 20;
    // A cause counts if it removes one in this many of the marks that face the eye. Larger: more causes are named.
    double cause_divisor = 2.0;
};
inline constexpr BlankTuning blank_tuning;

} // namespace hrbfnpr::picture
