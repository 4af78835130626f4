// SPDX-License-Identifier: MIT
#include "orient/noisy_clouds.h"
#include "shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace orient_test::means_test {
namespace {

namespace base = hrbfnpr::base;
namespace geometry = hrbfnpr::geometry;
namespace orient = hrbfnpr::orient;

// A flat sheet with noise, and its means with normals that are about 20 degrees off.
struct Sheet {
    base::Runtime runtime;
    orient::Cloud cloud{runtime.memory};
    orient::Cloud means{runtime.memory};
    geometry::VecArray normal{runtime.memory};

    Sheet() {
        Samples flat;
        for (int i = 0; i < 90; ++i)
            for (int j = 0; j < 90; ++j) flat.add({1.0 * i, 1.0 * j, 0.0}, {0.0, 0.0, 1.0});
        const Samples rough = noisy(flat, 1.0);
        cloud = orient::read_cloud(runtime, view(rough.points));
        means = orient::means_of(runtime, cloud, 900);
        normal = geometry::VecArray(runtime.memory, means.size());
        for (std::int64_t k = 0; k < means.size(); ++k) {
            const double turn = 2.4 * static_cast<double>(k);
            normal.set(k, glm::normalize(glm::dvec3(0.36 * std::cos(turn), 0.36 * std::sin(turn), 1.0)));
        }
    }
};

TEST(LocalMeans, AreFewerThanThePointsAndNearerToTheSheet) {
    const Sheet sheet;
    EXPECT_LE(sheet.means.size(), 900);
    EXPECT_GE(sheet.means.size(), 850);
    double off = 0.0;
    for (std::int64_t k = 0; k < sheet.means.size(); ++k) {
        const glm::dvec3 at = sheet.cloud.centre +
                              sheet.cloud.spacing * (sheet.means.centre + sheet.means.spacing * sheet.means.point(k));
        off += at.z * at.z;
    }
    EXPECT_LT(std::sqrt(off / static_cast<double>(sheet.means.size())), 0.97); // for the points: 1
}

TEST(LocalMeans, GiveNormalsToThePointsAroundThem) {
    const Sheet sheet;
    const geometry::VecArray found = orient::normals_by_means(sheet.runtime, sheet.cloud, sheet.means, sheet.normal);
    ASSERT_EQ(found.size(), sheet.cloud.size());
    double angle = 0.0;
    for (std::int64_t at = 0; at < found.size(); ++at) {
        EXPECT_NEAR(glm::length(found[at]), 1.0, 1e-12);
        angle += std::acos(std::min(1.0, found[at].z)) * 57.29577951308232;
    }
    EXPECT_LT(angle / static_cast<double>(found.size()), 4.0); // for the normals of the four nearest means: 10
}

} // namespace
} // namespace orient_test::means_test
