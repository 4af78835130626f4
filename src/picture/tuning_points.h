// SPDX-License-Identifier: MIT
// Constants of the steps that turn points into a surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hrbfnpr::picture {

// The numbers of points that are used.
struct PointsTuning {
    // If the options set no number, this many samples are taken from larger point sets. A direct solver needs time with
    // the third power of the number: minutes and gigabytes above this. Larger: finer surfaces.
    std::size_t most_samples = 4096;
    // At most this many points get normals; the others are removed. 20 000 take ten seconds. Larger: more of a large
    // scan is used.
    std::size_t most_oriented = 20'000;
    // Each sample is chosen from this many random candidates. Larger: more even samples, and more time.
    std::size_t candidates_a_sample = 40;
    // With fewer samples, a warning says that the surface is a guess.
    std::size_t few_samples = 10;
    // Samples lie on a line or in a plane if their other extents are below this share of the longest. Larger: more
    // sample sets are called flat.
    double thin = 1e-4;
    // The distance in pixels from the border of a hole in a depth image to its middle. Larger: larger gaps, which are
    // hidden from the camera by nearer objects, are closed.
    double hole_pixels = 8.0;
};
inline constexpr PointsTuning points_tuning;

// The direction of normals. Tuned on balls, tori, knots, plates and scans with some normals turned.
struct NormalsTuning {
    // At most this many samples represent all. Larger: more reliable, and more time.
    std::size_t most_sources = 2500;
    // The winding number is computed at this many samples. Larger: more reliable, and more time.
    std::size_t most_queries = 300;
    // A normal is compared with this many neighbours. Larger: smoother decisions, but thin parts look wrong.
    std::int64_t neighbours = 8;
    // Fewer samples than this are not examined.
    std::size_t fewest_looked_at = 6;
    // Normals at one place are the same if their cosine is above this, as in the fit. Larger: fewer normals count as
    // the same.
    double agreement = 0.99985;
    // Unit normals contradict each other if their mean is shorter than this, and no sample remains there.
    double opposite = 0.2;
    // This share of a sample's area is added to squared distances. Larger: places right beside a sample count less.
    double soft_area = 0.1;
    // The winding numbers on both sides are computed this many spacings off the surface.
    double off_surface = 0.5;
    // The sum of the two winding numbers tells which side is outside if its magnitude is at least this.
    double telling_sum = 0.4;
    // At least this share of the places must have a sum whose magnitude is at least `telling_sum`.
    double telling_share = 0.3;
    // The sum is 1 on a closed surface, -1 on an inside-out one, and 0 on a flat sheet. Below this all normals are
    // inward. Nearer to 0: open surfaces are turned, too.
    double inward_sum = -0.5;
    // A sum below this gives a warning that most of an open surface is inside out.
    double doubtful_sum = -0.25;
    // Normals are repaired or warned of if more than this share opposes its neighbours. Larger: more wrong normals
    // stay.
    double mixed_share = 0.02;
    // All other normals may be trusted if at most this share is wrong.
    double unsure_share = 0.1;
    // If the share of places that look inside out lies between these two numbers, some parts point inward and others
    // outward.
    double least_outside_in = 0.05;
    double most_outside_in = 0.95;
    // Neighbouring normals are opposed if their cosine is below this.
    double opposed_cosine = -0.25;
    // A neighbour lies beside a sample if its height above the sample's plane is below this share of its distance.
    double beside_height = 0.5;
    // A neighbour is surely on the same sheet if its height above the sample's plane is below this share of its
    // distance.
    double level_height = 0.25;
    // Pairs of neighbours are used only if at least this share is surely on the same sheet.
    double least_level_share = 0.2;
    // A normal is wrong if more than this share of its side neighbours is opposed. At least three side neighbours are
    // needed.
    double against_share = 0.75;
    std::int64_t fewest_beside = 3;
    // Smaller sets of points are not repaired.
    std::size_t fewest_repaired = 10;
    // Normals made by the library give a warning if their confidence is below this.
    double unsure_confidence = 0.5;

    // Larger sets of points are not tested for lying along curves. Larger: more time.
    std::size_t most_along_curves = 24'000;
};
inline constexpr NormalsTuning normals_tuning;

// Points that lie far from all others.
struct StraysTuning {
    // Coordinates that mark missing data in terrain and scanner formats.
    std::array<double, 7> no_data{
        -9999.0, -99999.0, -999999.0, -32767.0, -32768.0, -3.4028234663852886e38, -1.7976931348623157e308};
    // A few points are removed if they are this many times as far from the middle as all others. Larger: fewer are
    // removed.
    double far = 4.0;
    // At most this share of all points may be removed because they are far from the others.
    double few = 0.005;

    // Smaller sets of points are not searched for dust.
    std::size_t fewest = 200;
    // The cell size is chosen so that half of all points share their cell with this many. Larger: coarser cells, fewer
    // strays.
    double crowd = 24.0;
    // A point is a stray if its cell and the cells around it hold at most this many points. For half of all points
    // these cells together hold a hundred points or more.
    std::int64_t alone = 3;
    // If more than this share would be strays, none is removed, because the points are simply uneven.
    double most = 0.1;
    // Each cell size is this many times the one before.
    double coarser = 1.3;
};
inline constexpr StraysTuning strays_tuning;

// The distance between a surface and its samples or mesh.
struct NearnessTuning {
    // A mesh is missed where it is farther off than this share of the diagonal, as in hrbfnpr_model_compare_mesh.
    double far = 0.01;
    // This share of the mesh may be missed without a warning.
    double missed_share = 0.01;
    // The warning proposes this many times the samples.
    std::int64_t more_samples = 4;
    // A warning comes if more than this share of samples, and at least the number below, looks wrong. A few samples on
    // thin parts look wrong but are right.
    double doubted_share = 0.005;
    double least_doubted = 3.0;
    // A surface at most this far from all samples, in diagonals, goes through them.
    double through = 1e-6;
};
inline constexpr NearnessTuning nearness_tuning;

// The end of a surface that is fitted to points.
struct EndsTuning {
    // If more than this share of the surface is removed, the rest is strips along curves, and no surface between them
    // is drawn.
    double mostly_left_out = 0.5;
};
inline constexpr EndsTuning ends_tuning;

// Defects that an inspection finds in a source.
struct InspectTuning {
    // This many samples of a mesh show its normals and its up direction. Larger: more reliable, and more time.
    std::size_t mesh_samples = 1000;
    // A source loses details in single precision, which has seven digits, if its middle is farther from the origin than
    // this, in diagonals.
    double far_from_origin = 1e5;
    // Normals are unit if their length differs from 1 by less than this, because files have few digits. Larger: fewer
    // are reported.
    double unit_length = 1e-3;
};
inline constexpr InspectTuning inspect_tuning;

} // namespace hrbfnpr::picture
