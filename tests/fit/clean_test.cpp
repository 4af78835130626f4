// SPDX-License-Identifier: MIT
#include "fit/clean.h"

#include "base/status.h"
#include "fit/shapes.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <set>

namespace clean_test {

namespace {

using namespace hrbfnpr;
using namespace fit_test;
using fit::Repair;

fit::Samples samples_of(const base::Runtime& runtime, const Cloud& cloud) {
    return fit::read_samples(runtime, view(cloud.points), view(cloud.normals));
}

struct Cleaned {
    explicit Cleaned(const Cloud& cloud, Repair outliers = Repair::keep, Repair flipped = Repair::keep, int threads = 1)
        : runtime(hrbfnpr::test::with_threads(threads)), samples(samples_of(runtime, cloud)),
          report(fit::clean(runtime, samples, outliers, flipped)) {}

    base::Runtime runtime;
    fit::Samples samples;
    fit::Cleaning report;
};

void expect_nothing_found(const Cloud& cloud, const char* what) {
    const Cleaned cleaned(cloud, Repair::drop, Repair::drop);
    EXPECT_EQ(cleaned.report.near_duplicates, 0) << what;
    EXPECT_EQ(cleaned.report.outliers_found, 0) << what;
    EXPECT_EQ(cleaned.report.flipped_found, 0) << what;
    EXPECT_EQ(cleaned.samples.position.size(), cloud.count()) << what;
}

constexpr int every = 37;

bool planted(std::int64_t i) { return i % every == every / 2; }

// A torus with some samples that are off the surface by two spacings or more, on either side.
Cloud torus_with_outliers(int count) {
    const Cloud even = torus(count);
    const double spacing = Cleaned(even).samples.spacing;
    Cloud cloud;
    for (std::int64_t i = 0; i < count; ++i) {
        const double off = planted(i) ? spacing * (2.0 + 0.1 * static_cast<double>(i % 30)) : 0.0;
        cloud.add(even.point(i) + (i % 2 == 0 ? off : -off) * even.normal(i), even.normal(i));
    }
    return cloud;
}

// A torus with some normals that point inward, of single samples or of two or three neighbours.
Cloud torus_with_flips(int count) {
    const Cloud even = torus(count);
    Cloud cloud;
    for (std::int64_t i = 0; i < count; ++i) cloud.add(even.point(i), planted(i) ? -even.normal(i) : even.normal(i));
    return cloud;
}

std::int64_t planted_count(std::int64_t count) {
    std::int64_t result = 0;
    for (std::int64_t i = 0; i < count; ++i) result += planted(i) ? 1 : 0;
    return result;
}

TEST(CleanSamples, FindsNothingOnCleanShapes) {
    expect_nothing_found(sphere(40), "sphere of 40");
    expect_nothing_found(sphere(3000), "sphere");
    expect_nothing_found(torus(256), "torus of 256");
    expect_nothing_found(torus(5000), "torus");
    expect_nothing_found(bumpy(800), "bumpy");
    expect_nothing_found(torus(1000).moved(1e-6, {1e3, 0, 0}), "small and far away");
}

TEST(CleanSamples, FindsAllOutliersAndNothingElse) {
    const Cloud cloud = torus_with_outliers(2000);
    const Cleaned kept(cloud);
    EXPECT_EQ(kept.report.outliers_found, planted_count(2000));
    EXPECT_EQ(kept.report.outliers_dropped, 0);
    EXPECT_EQ(kept.report.flipped_found, 0);
    EXPECT_EQ(kept.samples.position.size(), 2000);
    const Cleaned dropped(cloud, Repair::drop);
    EXPECT_EQ(dropped.report.outliers_found, planted_count(2000));
    EXPECT_EQ(dropped.report.outliers_dropped, planted_count(2000));
    ASSERT_EQ(dropped.samples.position.size(), 2000 - planted_count(2000));
    std::int64_t at = 0;
    for (std::int64_t i = 0; i < 2000; ++i) {
        if (planted(i)) continue;
        ASSERT_EQ(dropped.samples.position[at++], cloud.point(i)) << i;
    }
}

TEST(CleanSamples, MeasuresAgainAfterDroppingOutliers) {
    Cloud cloud = torus(1000);
    const Cleaned without(cloud);
    cloud.add({9.0, 0.0, 0.0}, {0.0, 0.0, 1.0});
    EXPECT_EQ(Cleaned(cloud).samples.bounds.max.x, 9.0);
    const Cleaned dropped(cloud, Repair::drop);
    EXPECT_EQ(dropped.report.outliers_dropped, 1);
    EXPECT_EQ(dropped.samples.bounds.max, without.samples.bounds.max);
    EXPECT_EQ(dropped.samples.spacing, without.samples.spacing);
}

TEST(CleanSamples, FindsAllFlippedNormalsAndNothingElse) {
    const Cloud cloud = torus_with_flips(2000);
    const Cloud even = torus(2000);
    const Cleaned kept(cloud);
    EXPECT_EQ(kept.report.flipped_found, planted_count(2000));
    EXPECT_EQ(kept.report.flipped_repaired, 0);
    EXPECT_EQ(kept.report.outliers_found, 0);
    for (std::int64_t i = 0; i < 2000; ++i) ASSERT_LT(glm::distance(kept.samples.normal[i], cloud.normal(i)), 1e-12);
    const Cleaned turned(cloud, Repair::keep, Repair::reorient);
    EXPECT_EQ(turned.report.flipped_repaired, planted_count(2000));
    for (std::int64_t i = 0; i < 2000; ++i)
        ASSERT_LT(glm::distance(turned.samples.normal[i], even.normal(i)), 1e-12) << i;
    const Cleaned dropped(cloud, Repair::keep, Repair::drop);
    EXPECT_EQ(dropped.report.flipped_repaired, planted_count(2000));
    EXPECT_EQ(dropped.samples.position.size(), 2000 - planted_count(2000));
}

TEST(CleanSamples, FindsFlippedNormalsInGroups) {
    Cloud cloud = sphere(1500);
    Cloud flipped;
    std::int64_t count = 0;
    for (std::int64_t i = 0; i < 1500; ++i) {
        const bool in_group = glm::distance(cloud.point(i), glm::dvec3(1, 0, 0)) < 0.1;
        flipped.add(cloud.point(i), in_group ? -cloud.normal(i) : cloud.normal(i));
        count += in_group ? 1 : 0;
    }
    ASSERT_GE(count, 3);
    EXPECT_EQ(Cleaned(flipped).report.flipped_found, count);
}

// Two sheets, `gap` apart, with opposite normals: they point out of the wall between the sheets, or into the gap.
Cloud sheets(double gap, double outward, std::int64_t upper_share) {
    Cloud cloud;
    for (int i = 0; i < 1600; ++i) {
        const double u = (i + 0.5) / 1600.0;
        const double v = std::fmod(0.6180339887498949 * i, 1.0);
        const bool upper = i % upper_share == 0;
        const double height = 0.05 * std::sin(4.0 * u) * std::cos(3.0 * v);
        const glm::dvec3 up = glm::normalize(glm::dvec3(-0.2 * std::cos(4.0 * u) * std::cos(3.0 * v),
                                                        0.15 * std::sin(4.0 * u) * std::sin(3.0 * v), 1.0));
        cloud.add({u, v, height + (upper ? gap : 0.0)}, (upper ? outward : -outward) * up);
    }
    return cloud;
}

TEST(CleanSamples, LeavesCloseOppositeSheetsAlone) {
    for (const double gap : {0.003, 0.01, 0.03, 0.1})
        for (const double outward : {1.0, -1.0}) {
            expect_nothing_found(sheets(gap, outward, 2), "as dense as each other");
            expect_nothing_found(sheets(gap, outward, 3), "half as dense");
        }
}

TEST(CleanSamples, MergesNearDuplicatesThatAgree) {
    const Cloud even = torus(1000);
    const double spacing = Cleaned(even).samples.spacing;
    Cloud cloud = even;
    for (int i = 0; i < 1000; i += 100) {
        const glm::dvec3 aside = glm::normalize(glm::cross(even.normal(i), glm::dvec3(0.3, 0.5, 0.7)));
        cloud.add(even.point(i) + 5e-4 * spacing * aside, glm::normalize(even.normal(i) + 0.17 * aside)); // 10 degrees
    }
    const Cleaned cleaned(cloud);
    EXPECT_EQ(cleaned.report.near_duplicates, 10);
    EXPECT_EQ(cleaned.report.outliers_found, 0);
    ASSERT_EQ(cleaned.samples.position.size(), 1000);
    for (int i = 0; i < 1000; ++i) {
        ASSERT_LT(glm::distance(cleaned.samples.position[i], even.point(i)), 3e-4 * spacing) << i;
        ASSERT_NEAR(glm::length(cleaned.samples.normal[i]), 1.0, 1e-12) << i;
    }
}

TEST(CleanSamples, TreatsADisagreeingNearDuplicateAsAnOutlier) {
    const Cloud even = torus(1000);
    const double spacing = Cleaned(even).samples.spacing;
    Cloud cloud = even;
    const glm::dvec3 aside = glm::normalize(glm::cross(even.normal(500), glm::dvec3(0.3, 0.5, 0.7)));
    cloud.add(even.point(500) + 5e-4 * spacing * aside, aside);
    const Cleaned kept(cloud);
    EXPECT_EQ(kept.report.near_duplicates, 0);
    EXPECT_EQ(kept.report.outliers_found, 1);
    EXPECT_EQ(kept.samples.position.size(), 1001);
    const Cleaned dropped(cloud, Repair::drop);
    ASSERT_EQ(dropped.samples.position.size(), 1000);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(dropped.samples.position[i], even.point(i)) << i;
}

TEST(CleanSamples, LeavesSetsThatAreTooSmallAlone) {
    Cloud cloud = sphere(31);
    cloud.add(100.0 * cloud.point(3), -cloud.normal(3));
    EXPECT_EQ(Cleaned(cloud, Repair::drop, Repair::drop).samples.position.size(), 32);
}

} // namespace

} // namespace clean_test
