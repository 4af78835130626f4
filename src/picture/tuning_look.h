// SPDX-License-Identifier: MIT
// Constants for choosing the up direction and the camera, and for detecting blank pictures.
#pragma once

#include <cstdint>

namespace hrbfnpr::picture {

struct UpTuning {
    // A terrain has a relief below this, as a share of its shorter side. Larger: steeper shapes are terrains.
    double terrain_relief_most = 0.3;
    // A terrain has a relief above this, as a share of its shorter side. Larger: flat plates are no terrains.
    double terrain_relief_least = 0.003;
    // The mean normal of a terrain has at least this component along its axis. Larger: only flatter ground is a
    // terrain.
    double terrain_upward = 0.7;
    // Along its axis, at least this share of a terrain's samples faces the same side. Larger: fewer overhangs are
    // allowed.
    double terrain_one_side = 0.99;
    // On a wall that is seen from one side, a normal whose z component is smaller than this in magnitude is level.
    // Larger: noisier normals are those of walls. Set on normals with a noise of 5 degrees.
    double wall_level = 0.2;
    // More than this share of the normals of such a wall is level; the others are those of sills and lintels. Larger:
    // fewer shapes are walls.
    double wall_share = 0.9;
    // A normal whose z component is smaller than this in magnitude is level, and says nothing of the side from which it
    // was seen. Larger: more shapes count as walls, and as seen from all sides.
    double side_told = 0.05;
    // A shape may be seen from one side only if more than this share of its normals has a z component of at least
    // `side_told`. A shape of which more than this share is level is a wall. Larger: fewer shapes count as seen from
    // one side, and as walls.
    double view_share = 0.98;
    // In a view from one side, the mean sign of the normals' z components is larger than this in magnitude. Larger:
    // fewer shapes count as seen from one side.
    double view_one_sided = 0.95;
    // The samples in this share of the height may belong to a flat end. Larger: thicker ends are flat.
    double end_height = 0.02;
    // The normals of a flat end have at least this component along the axis. Larger: ends must be flatter.
    double end_outward = 0.9;
    // A flat end is a base if it has at least this share of the samples. Larger: only broad bases count.
    double base_share = 0.05;
    // A base has at least this many times as many samples as any other flat end. If the top has more than this many
    // times as many samples as the feet, the object stands on its feet. Larger: fewer shapes are clear.
    double base_over_others = 4.0;
    // On a map, eastings and northings are at least this, in units of the source. Larger: only places far from 0 are on
    // a map.
    double map_least = 10000.0;
    // On a map, eastings and northings are at least this many times the extent of the shape. Larger: only small places
    // are on a map.
    double map_extents = 2.0;
    // The feet of a shape are the points in this share of its height. Larger: feet reach higher.
    double foot_height = 0.04;
    // The convex hull of the feet has at least this share of the area of the shadow's hull. Larger: only broad shapes
    // stand.
    double foot_share = 0.3;
    // A shape stands on z = 0 if its lowest point is at most this share of its height above or below 0. Larger: more
    // shapes stand there.
    double ground_miss = 0.005;
    // A shape is centred if the distance of its middle from 0 is at most this share of the sides of its bounding box.
    // Larger: more shapes are centred.
    double middle_miss = 0.05;
    // Two sides are alike if mirrored samples are nearer to the given samples than this, in spacings. Larger: more
    // sides are alike.
    double mirrored_alike = 1.0;
    // Two sides differ if mirrored samples are farther from the given samples than this, in spacings. Larger: fewer
    // sides differ.
    double mirrored_unlike = 1.2;
    // Mirroring along the axis whose sides differ gives at least this many times the distance between mirrored and
    // given samples that mirroring along the other axis gives. Larger: fewer shapes are clear.
    double mirrored_clearly = 1.8;
    // Two sides are compared by this percentile of the distances of mirrored samples. Larger: a few differing samples
    // make sides differ.
    double mirrored_percentile = 90.0;
    // At most this many samples are mirrored. Larger: slower, and for even samples no better.
    std::int64_t mirrored_most = 1200;
    // A shape thinner than this share of its shorter side lies flat. Its faces are then not its left and right sides.
    // Larger: more shapes lie flat.
    double leaf_thickness = 0.1;
    // A border edge belongs to a hole on which the object stands if the distance of its middle from that end is at most
    // this share of the height. Larger: slanted borders count.
    double hole_height = 0.15;
    // The border of such a hole has at least this share of the length of all borders. Larger: fewer objects stand on
    // holes.
    double hole_border = 0.5;
    // The borders at the opposite end have at most this share of the length of all borders. Larger: tubes count as
    // standing.
    double hole_above = 0.05;
    // The area of the hole, seen along its axis, is more than this many times its area seen along other axes. Larger:
    // only level holes count.
    double hole_over_others = 2.0;
};
inline constexpr UpTuning up_tuning;

struct LookTuning {
    // The longer side of a picture whose size is not given, in pixels.
    std::int32_t long_side = 1600;
    // The longer side is at most this many times the shorter one. Larger: slimmer pictures of slim objects.
    std::int32_t slimmest = 4;
    // The angles of the camera in degrees, if none are given. Larger: seen more from the right, and more from above.
    double azimuth = 30.0;
    double elevation = 20.0;
    // The vertical angle of view, in degrees. Larger: the camera stands nearer, and the perspective is stronger.
    double field_of_view = 30.0;
    // The near plane moves towards the eye for places of the ground, but no nearer than to this share of its distance.
    // Larger: the ground may be cut before the object.
    double nearest_plane = 0.05;
    // This share of a picture is empty on each side. Larger: the object is smaller in the picture.
    double margin = 0.05;
    // An open surface has a front if the component of its mean normal perpendicular to the up axis is longer than this.
    // A half sphere has 0.5, a box without one side 0.17. Larger: fewer open surfaces are turned to the camera.
    double looks_one_way = 0.25;
    // If the cosine between up and z is above this, the front is -y, else +z. Larger: tilted objects keep +z.
    double upright = 0.9;
    // The number of marks that measure a model's area and extent. Larger: slower, with a more exact frame.
    std::int64_t probe_marks = 2000;
    // A smaller visible extent is replaced by this, in pixels, so that even a single point has a frame.
    double least_extent = 1e-6;
    // The number of steps of an orbit at which the frame is fitted to the object. Larger: slower, with a more exact
    // frame.
    std::int32_t orbit_steps = 24;
};
inline constexpr LookTuning look_tuning;

struct BlankTuning {
    // A pixel has ink if it differs from the paper by at least this, of 255. Larger: faint ink does not count.
    double ink_seen = 16.0;
    // A picture is blank if a smaller share of its pixels has ink. Larger: more pictures are refused.
    double least_ink = 1e-4;
    // If a style shows tone by marks, a picture is blank if many marks are hidden, and less than this share of the
    // marks that face the eye is shown. Larger: more pictures are refused.
    double least_shown = 0.03;
    // Many marks are hidden if their share is above this. Larger: fewer pictures are refused.
    double most_hidden = 0.4;
    // A surface faces away if at least this many times as many marks show their back as their front. Larger: the note
    // appears less often.
    std::int64_t back_over_front = 20;
    // A note names a cause if it removes more than 1 / cause_divisor of the marks that face the eye. Larger: more
    // causes are named.
    double cause_divisor = 2.0;
};
inline constexpr BlankTuning blank_tuning;

} // namespace hrbfnpr::picture
