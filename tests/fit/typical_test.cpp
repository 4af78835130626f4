// SPDX-License-Identifier: MIT
#include "fit/typical.h"

#include "base/status.h"
#include "fit/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace typical_test {

namespace {

using namespace hrbfnpr;
using namespace fit_test;

bool odd(std::int64_t i) { return i % 29 == 5; }

// A torus with some samples above the surface, and some normals a right angle off.
fit::Samples torus_with_odd_ones(const base::Runtime& runtime) {
    const Cloud even = torus(1500);
    Cloud cloud;
    for (std::int64_t i = 0; i < even.count(); ++i) {
        const glm::dvec3 aside = glm::normalize(glm::cross(even.normal(i), glm::dvec3(0.3, 0.5, 0.7)));
        const bool high = odd(i) && i % 2 == 0;
        const bool turned = odd(i) && i % 2 == 1;
        cloud.add(even.point(i) + (high ? 0.1 : 0.0) * even.normal(i), turned ? aside : even.normal(i));
    }
    return fit::read_samples(runtime, view(cloud.points), view(cloud.normals));
}

TEST(TypicalSample, IsANearbySampleWithoutDefects) {
    const base::Runtime runtime;
    const fit::Samples samples = torus_with_odd_ones(runtime);
    const geometry::Neighbours neighbours(runtime.parallel, samples.position, 16, {});
    const base::Array<std::int64_t> typical = fit::typical_samples(runtime, samples, neighbours);
    ASSERT_EQ(typical.size(), samples.position.size());
    for (std::int64_t i = 0; i < typical.size(); ++i) {
        EXPECT_FALSE(odd(typical[i])) << i;
        const auto near = neighbours.of(i).first(8);
        EXPECT_TRUE(typical[i] == i || std::count(near.begin(), near.end(), typical[i]) == 1) << i;
    }
}

} // namespace

} // namespace typical_test
