// SPDX-License-Identifier: MIT
// Dabs against their definition: each pulls the value towards its own, one after the other.
#include "paint/dabs.h"

#include "base/runtime.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace hrbfnpr::paint::dabs_test {
namespace {

std::vector<Dab> random_dabs(int count, bool of_many_sizes) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    std::vector<Dab> dabs;
    for (int i = 0; i < count; ++i) {
        const double radius = of_many_sizes ? 0.02 * std::pow(50.0, share(random)) : 0.4;
        dabs.push_back({{number(random), number(random), number(random)},
                        {number(random), number(random), number(random)},
                        radius,
                        share(random),
                        {share(random), number(random), number(random)}});
    }
    return dabs;
}

double plain_weight(const Dab& dab, const Place& place) {
    const double d = glm::distance(place.position, dab.position);
    if (d >= dab.radius || glm::dot(place.normal, dab.normal) <= 0.0) return 0.0;
    return dab.strength * std::pow(1.0 - d * d / (dab.radius * dab.radius), 2.0);
}

std::vector<Place> random_places(int count) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> number(-1.2, 1.2);
    std::vector<Place> places;
    for (int i = 0; i < count; ++i)
        places.push_back({{number(random), number(random), number(random)},
                          glm::normalize(glm::dvec3(number(random), number(random), number(random)))});
    return places;
}

TEST(PaintDabs, PullAnyValueAsOneAfterTheOtherDoes) {
    base::Runtime runtime;
    for (const bool of_many_sizes : {false, true}) {
        const std::vector<Dab> given = random_dabs(300, of_many_sizes);
        const Dabs dabs(runtime.memory, FieldKind::scalar, given);
        int painted = 0;
        for (const Place& place : random_places(2000)) {
            const Sample sample = dabs.at(place);
            for (const double before : {0.0, 0.3, 1.0}) {
                double expected = before;
                for (const Dab& dab : given) expected += plain_weight(dab, place) * (dab.value.x - expected);
                ASSERT_NEAR(before + sample.weight * (sample.value.x - before), expected, 1e-12);
            }
            painted += sample.weight > 0.0 ? 1 : 0;
        }
        EXPECT_GT(painted, 200);
    }
}

TEST(PaintDabs, DirectionsAreTurnedTowardsThoseBefore) {
    base::Runtime runtime;
    std::vector<Dab> given = random_dabs(2, false);
    for (Dab& dab : given) {
        dab.position = {0.0, 0.0, 0.0};
        dab.normal = {0.0, 0.0, 1.0};
        dab.strength = 0.5;
    }
    given[0].value = {1.0, 0.2, 0.0};
    given[1].value = {-1.0, 0.2, 0.0};
    const Dabs dabs(runtime.memory, FieldKind::direction, given);
    const Sample sample = dabs.at({{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}});
    EXPECT_DOUBLE_EQ(sample.weight, 0.75);
    EXPECT_GT(std::abs(sample.value.x), 0.99);
    EXPECT_LT(std::abs(sample.value.y), 0.11);
}

TEST(PaintDabs, NoDabsPaintNothing) {
    base::Runtime runtime;
    const Dabs dabs(runtime.memory, FieldKind::scalar, {});
    EXPECT_EQ(dabs.at({{0.0, 0.0, 0.0}, {0.0, 0.0, 1.0}}).weight, 0.0);
}

} // namespace
} // namespace hrbfnpr::paint::dabs_test
