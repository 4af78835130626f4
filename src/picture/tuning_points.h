// SPDX-License-Identifier: MIT
// Constants for turning points into a surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hrbfnpr::picture {

// The numbers of points to use.
struct PointsTuning {
    // The number of samples that are taken from larger point sets, if the options give no number. The time of a direct
    // solver grows with the cube of the number: above this it takes minutes and gigabytes. Larger: finer surfaces.
    std::size_t most_samples = 4096;
    // Normals are found for at most this many points, and other points are removed. 20 000 take ten seconds. Larger:
    // more of a large scan is used.
    std::size_t most_oriented = 20'000;
    // For each sample, this many random candidates are compared. Larger: more even samples, and more time.
    std::size_t candidates_a_sample = 40;
    // If there are fewer samples, a warning says that the surface is a guess.
    std::size_t few_samples = 10;
    // Samples lie on a line or in a plane if their other extents are below this share of the longest extent. Larger:
    // more sets of samples count as flat.
    double thin = 1e-4;
    // Holes in a depth image are closed if their middle is within this distance of their border, in pixels. Larger:
    // wider gaps that nearer objects hide from the camera are closed.
    double hole_pixels = 8.0;
};
inline constexpr PointsTuning points_tuning;

// Finding which way normals point. Tuned on balls, tori, knots, plates and scans with some normals turned.
struct NormalsTuning {
    // At most this many samples are used to represent all samples. Larger: more reliable, and more time.
    std::size_t most_sources = 2500;
    // The winding number is computed at this many samples. Larger: more reliable, and more time.
    std::size_t most_queries = 300;
    // A normal is compared with this many neighbours. Larger: smoother decisions, but thin parts look wrong.
    std::int64_t neighbours = 8;
    // With fewer samples than this, normals are not examined.
    std::size_t fewest_looked_at = 6;
    // Two normals at one place are the same if their cosine is above this, as in the fit. Larger: fewer normals count
    // as the same.
    double agreement = 0.99985;
    // The normals at one place contradict each other if their mean is shorter than this. All samples there are then
    // removed.
    double opposite = 0.2;
    // This share of a sample's area is added to the squared distance from the sample. Larger: places close to a sample
    // count less.
    double soft_area = 0.1;
    // The distance from the surface at which winding numbers on both sides are computed, in spacings.
    double off_surface = 0.5;
    // The sum of the winding numbers on both sides shows which side is outside if its magnitude is at least this.
    double telling_sum = 0.4;
    // For a decision, at least this share of the places must have a sum with a magnitude of at least `telling_sum`.
    double telling_share = 0.3;
    // All normals are inward if the median sum is below this. It is 1 on a closed surface, -1 if the surface is inside
    // out, and 0 on a flat sheet. Nearer to 0: open surfaces are turned, too.
    double inward_sum = -0.5;
    // If the median sum is below this, a warning says that most of an open surface is inside out.
    double doubtful_sum = -0.25;
    // If more than this share of normals is opposite to its neighbours, normals are repaired, or a warning comes.
    // Larger: more wrong normals stay.
    double mixed_share = 0.02;
    // If at most this share of normals is wrong, the others are trusted.
    double unsure_share = 0.1;
    // Some parts point inward and others outward if the share of places that look inside out is between these two
    // numbers.
    double least_outside_in = 0.05;
    double most_outside_in = 0.95;
    // Neighbouring normals are opposite if their cosine is below this.
    double opposed_cosine = -0.25;
    // A neighbour is a side neighbour of a sample if its height above the sample's plane is below this share of its
    // distance.
    double beside_height = 0.5;
    // A neighbour is certainly on the same sheet if its height above the sample's plane is below this share of its
    // distance.
    double level_height = 0.25;
    // Pairs of neighbours are used only if at least this share of them is certainly on the same sheet.
    double least_level_share = 0.2;
    // A normal is wrong if it is opposite to more than this share of its side neighbours, of which there must be at
    // least three.
    double against_share = 0.75;
    std::int64_t fewest_beside = 3;
    // Smaller sets of points are not repaired.
    std::size_t fewest_repaired = 10;
    // A warning comes if the confidence of normals made by the library is below this.
    double unsure_confidence = 0.5;

    // Larger sets of points are not tested for lying along curves. Larger: more sets are tested, in more time.
    std::size_t most_along_curves = 24'000;
};
inline constexpr NormalsTuning normals_tuning;

// Points that lie far from all others.
struct StraysTuning {
    // Coordinates that mark missing data in terrain and scanner formats.
    std::array<double, 7> no_data{
        -9999.0, -99999.0, -999999.0, -32767.0, -32768.0, -3.4028234663852886e38, -1.7976931348623157e308};
    // A few far points are removed if they are at least this many times as far from the middle as all others. Larger:
    // fewer are removed.
    double far = 4.0;
    // At most this share of all points is removed as far points.
    double few = 0.005;

    // Smaller sets of points are not searched for dust. The rest was set on balls, tori, knots and scans of 500 to
    // 35 000 points with 1 to 8 % of strays in their boxes.
    std::size_t fewest = 200;
    // A point is compared with this many neighbours. Larger: more time, and dust near a surface is found less often.
    static constexpr std::size_t neighbours = 8;
    // A stray is this many times as far from its last neighbour as usual, and as its neighbours are from theirs.
    // Larger: dust near a surface stays.
    double sparse = 1.5;
    // A point this many times as far from its last neighbour as usual may be a stray beside other strays. Larger: more
    // dust stays; smaller: coarse parts of a surface are left out.
    double very_sparse = 3.0;
    // A stray is farther from the plane of its neighbours than this many standard deviations of their places along the
    // plane, or they are thicker than `thick` such deviations across it. Larger: more dust stays; smaller: places where
    // a coarse surface bends are left out.
    double off_plane = 0.4;
    double thick = 0.25;
    // Strays are looked for in at most this many rounds, because strays hide each other. Larger: more time.
    int rounds = 8;
    // If more than this share of the points is sparse, no point is removed, because the points are merely uneven.
    double most = 0.1;
};
inline constexpr StraysTuning strays_tuning;

// The distance between a surface and its samples or its mesh.
struct NearnessTuning {
    // A place of a mesh is missed if the surface is farther away than this share of the diagonal, as in
    // hrbfnpr_model_compare_mesh.
    double far = 0.01;
    // No warning comes if at most this share of the mesh is missed.
    double missed_share = 0.01;
    // The warning proposes this many times the present number of samples.
    std::int64_t more_samples = 4;
    // A warning comes if more than this share of the samples looks wrong, and these are at least `least_doubted`
    // samples. On thin parts, a few correct samples may look wrong.
    double doubted_share = 0.005;
    double least_doubted = 3.0;
    // If all samples are at most this far from a surface, in diagonals, the surface counts as passing through them.
    double through = 1e-6;
};
inline constexpr NearnessTuning nearness_tuning;

// Ending a surface that is fitted to points.
struct EndsTuning {
    // If more than this share of the surface is removed, only strips along curves remain, and the surface between them
    // is not drawn.
    double mostly_left_out = 0.5;
};
inline constexpr EndsTuning ends_tuning;

// Defects that an inspection finds in a source.
struct InspectTuning {
    // The number of samples of a mesh that show its normals and its up direction. Larger: more reliable, and more time.
    std::size_t mesh_samples = 1000;
    // A source loses details in single precision, which has seven digits, if its middle is farther from the origin than
    // this, in diagonals.
    double far_from_origin = 1e5;
    // Normals have unit length if their length differs from 1 by less than this, because files have few digits. Larger:
    // fewer are reported.
    double unit_length = 1e-3;
};
inline constexpr InspectTuning inspect_tuning;

} // namespace hrbfnpr::picture
