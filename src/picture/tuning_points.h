// SPDX-License-Identifier: MIT
// Constants of the steps that turn points into a surface.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace hrbfnpr::picture {

// How many points are used.
struct PointsTuning {
    // Samples that are taken from more points, if the options set no number. Larger: finer surfaces; a direct solver
    // needs time with the third power of it. Minutes and gigabytes above this.
    std::size_t most_samples = 4096;
    // Points that get normals; others are left out. Larger: more of a large scan is used; 20 000 take ten seconds.
    std::size_t most_oriented = 20'000;
    // Random candidates for each sample that is chosen. Larger: more even samples, and more time.
    std::size_t candidates_a_sample = 40;
    // Fewer samples than this make a warning that the surface is a guess.
    std::size_t few_samples = 10;
    // A share of the longest extent: samples whose other extents are below it lie on a line or in a plane. Larger: more
    // samples are called flat.
    double thin = 1e-4;
    // Pixels from the border of a hole in the image of a depth camera to its middle. Larger: larger gaps, which the
    // camera did not see behind something, are closed.
    double hole_pixels = 8.0;
};
inline constexpr PointsTuning points_tuning;

// Which way normals look. Set on balls, tori, knots, plates and scans with some normals turned.
struct NormalsTuning {
    // Samples that stand for all. Larger: surer, and more time.
    std::size_t most_sources = 2500;
    // Samples at which the winding number is computed. Larger: surer, and more time.
    std::size_t most_queries = 300;
    // Neighbours that a normal is compared with. Larger: smoother decisions, but thin parts look wrong.
    std::int64_t neighbours = 8;
    // Fewer samples than this tell nothing.
    std::size_t fewest_looked_at = 6;
    // A cosine: normals at one place that differ less are the same, as the fit has it. Larger: more places are joined.
    double agreement = 0.99985;
    // The length of a mean of unit normals: if it is less, they contradict each other, and no sample is left there.
    double opposite = 0.2;
    // A share of a sample's area that is added to squared distances. Larger: what lies right beside a sample counts
    // less.
    double soft_area = 0.1;
    // Winding numbers on both sides are asked this many spacings off the surface.
    double off_surface = 0.5;
    // The least |sum| of the two winding numbers that tells which side is outside.
    double telling_sum = 0.4;
    // The least share of places with such a sum.
    double telling_share = 0.3;
    // The sum is 1 on a closed surface, -1 on one that is inside out, 0 on a flat sheet. Below this all normals are
    // inward. Nearer to 0: open surfaces are turned, too.
    double inward_sum = -0.5;
    // Below this most of an open surface is warned of.
    double doubtful_sum = -0.25;
    // The share of normals against their neighbours that is repaired or warned of. Larger: more wrong ones are let be.
    double mixed_share = 0.02;
    // The share of wrong normals up to which all others may be trusted.
    double unsure_share = 0.1;
    // If the share of places that look inside out lies between these, some parts look inward and others outward.
    double least_outside_in = 0.05;
    double most_outside_in = 0.95;
    // A cosine: neighbouring normals below it are opposed.
    double opposed_cosine = -0.25;
    // A neighbour lies beside a sample if its height above the sample's plane is less than this share of its distance.
    double beside_height = 0.5;
    // The same for a neighbour that is surely on the same sheet.
    double level_height = 0.25;
    // The least share of neighbours that are surely on the same sheet, for pairs of them to tell anything.
    double least_level_share = 0.2;
    // A normal is against those beside it if more than this share of them, of three at least, is opposed.
    double against_share = 0.75;
    std::int64_t fewest_beside = 3;
    // Normals of fewer points are not repaired.
    std::size_t fewest_repaired = 10;
    // Confidence of normals that the library made, below which it is warned of.
    double unsure_confidence = 0.5;

    // More points are not asked whether they lie along curves. Larger: more time.
    std::size_t most_along_curves = 24'000;
};
inline constexpr NormalsTuning normals_tuning;

// Points that lie far from all others.
struct StraysTuning {
    // Coordinates that stand for no data in formats of terrain and of scanners.
    std::array<double, 7> no_data{
        -9999.0, -99999.0, -999999.0, -32767.0, -32768.0, -3.4028234663852886e38, -1.7976931348623157e308};
    // A few points are left out if they are this many times as far from the middle as all others. Larger: fewer are.
    double far = 4.0;
    // They may be this share of all at most.
    double few = 0.005;

    // Fewer points than this are not searched for dust.
    std::size_t fewest = 200;
    // Cells are made so large that half of all points share theirs with this many. Larger: coarser cells, fewer strays.
    double crowd = 24.0;
    // A point is a stray if its cell and those around it hold no more points; half of all points see a hundred and
    // more.
    std::int64_t alone = 3;
    // If more than this share of points would be strays, none is: points lie as unevenly as that.
    double most = 0.1;
    // The factor between one size of cells and the next.
    double coarser = 1.3;
};
inline constexpr StraysTuning strays_tuning;

// How near a surface is to what it was fitted to.
struct NearnessTuning {
    // A share of the diagonal, as hrbfnpr_model_compare_mesh has it: a mesh is missed where it is farther off.
    double far = 0.01;
    // The share of the mesh that may be missed without a warning.
    double missed_share = 0.01;
    // Samples times this are proposed instead.
    std::int64_t more_samples = 4;
    // The share of samples that look wrong and is warned of; at least the number below, since a few at thin parts look
    // so and are right.
    double doubted_share = 0.005;
    double least_doubted = 3.0;
    // In diagonals: a surface that is this near to all samples goes through them.
    double through = 1e-6;
};
inline constexpr NearnessTuning nearness_tuning;

// Where the surface of points ends.
struct EndsTuning {
    // If the share of the surface that is left out is above this, the rest is strips along curves, and nothing between
    // these is drawn.
    double mostly_left_out = 0.5;
};
inline constexpr EndsTuning ends_tuning;

// What is found wrong with a source that is inspected.
struct InspectTuning {
    // Samples of a mesh, by which its normals and its up are looked at. Larger: surer, and more time.
    std::size_t mesh_samples = 1000;
    // In diagonals of the bounds: a source whose middle is farther from the origin loses its details in single
    // precision, which has seven digits.
    double far_from_origin = 1e5;
    // Normals whose length is off 1 by less are unit: files have few digits. Larger: fewer are reported.
    double unit_length = 1e-3;
};
inline constexpr InspectTuning inspect_tuning;

} // namespace hrbfnpr::picture
