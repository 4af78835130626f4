// SPDX-License-Identifier: MIT
// Tests orders without the marks that a still picture does not need.
#include "support/point_sets.h"
#include "support/runtime.h"

#include "geometry/point_tree.h"
#include "stipples/blue_noise.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace hrbfnpr::stipples::need_test {
namespace {

using namespace marks;
using namespace test;

// Needs all marks for x > 0.3, a part of them for x > -0.3, and none beyond.
class ByBands final : public Need {
public:
    explicit ByBands(double middle) noexcept : middle_(middle) {}

    [[nodiscard]] bool may_show(const glm::dvec3& place, const glm::dvec3&, double reach) const noexcept override {
        return place.x + reach > -0.3;
    }
    [[nodiscard]] double share(const glm::dvec3& place, const glm::dvec3&, double) const noexcept override {
        return place.x > 0.3 ? 1.0 : place.x > -0.3 ? middle_ : 0.0;
    }

private:
    double middle_;
};

class All final : public Need {
public:
    [[nodiscard]] bool may_show(const glm::dvec3&, const glm::dvec3&, double) const noexcept override { return true; }
    [[nodiscard]] double share(const glm::dvec3&, const glm::dvec3&, double) const noexcept override { return 1.0; }
};

EvenMarks spread(base::Runtime& with, const implicit::Implicit& surface, const glm::dvec3& seed, std::int64_t wanted,
                 const Need* need) {
    const Site site{with, surface, 1e-6, 1};
    Seeds seeds(with.memory);
    seeds.position.push_back(seed);
    return spread_evenly(site, cover_surface(site, seeds, 0.1, wanted), wanted, Kind::stipples, need);
}

double place_of(const EvenMarks& marks, std::int64_t i) {
    return marks.place.empty() ? (static_cast<double>(i) + 0.5) / static_cast<double>(marks.position.size())
                               : marks.place[i];
}

// Returns the marks among the first `share` of the order with x from low to high.
geometry::VecArray marks_in(const EvenMarks& marks, double share, double low, double high) {
    geometry::VecArray found(runtime().memory);
    for (std::int64_t i = 0; i < marks.position.size(); ++i)
        if (place_of(marks, i) <= share && marks.position[i].x > low && marks.position[i].x < high)
            found.push_back(marks.position[i]);
    return found;
}

struct Distances {
    double least, mean;
};
Distances nearest_distances(const geometry::VecArray& points) {
    const geometry::PointTree tree(points, {});
    Distances distances{1e9, 0.0};
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const double nearest = tree.nearest_other(i);
        distances.least = std::min(distances.least, nearest);
        distances.mean += nearest / static_cast<double>(points.size());
    }
    return distances;
}

constexpr std::int64_t wanted = 40000;

TEST(Need, KeepsTheDensityOfNeededMarks) {
    const Sphere sphere;
    for (const double middle : {0.05, 0.2, 0.6}) {
        const ByBands need(middle);
        const EvenMarks some = spread(runtime(), sphere, {1.0, 0.0, 0.0}, wanted, &need);
        EXPECT_NEAR(static_cast<double>(some.whole), 1.0 * wanted, 0.01 * wanted);
        EXPECT_LT(some.position.size(), static_cast<std::int64_t>((0.35 + 0.3 * middle + 0.1) * wanted)) << middle;
        EXPECT_TRUE(std::is_sorted(some.place.begin(), some.place.end()));
        // A band of the sphere has a share of the area that is half its length along x.
        for (const double share : {0.02, 0.1, 0.3, 0.7, 1.0}) {
            const auto full = static_cast<double>(marks_in(some, share, 0.3, 1.0).size());
            EXPECT_NEAR(full, 0.35 * share * wanted, 0.02 * 0.35 * share * wanted + 8.0) << middle << " to " << share;
            if (share > middle) continue;
            const auto part = static_cast<double>(marks_in(some, share, -0.3, 0.3).size());
            EXPECT_NEAR(part, 0.3 * share * wanted, 0.02 * 0.3 * share * wanted + 8.0) << middle << " to " << share;
        }
    }
}

TEST(Need, KeepsNeededMarksAsEvenAsTheWholeOrder) {
    const Torus torus;
    const ByBands need(0.2);
    const EvenMarks whole = spread(runtime(), torus, {1.35, 0.0, 0.0}, wanted, nullptr);
    const EvenMarks some = spread(runtime(), torus, {1.35, 0.0, 0.0}, wanted, &need);
    EXPECT_TRUE(whole.place.empty());
    EXPECT_LT(some.position.size(), whole.position.size() * 6 / 10);
    const auto compare = [&](double share, double low, double high) {
        const Distances a = nearest_distances(marks_in(whole, share, low, high));
        const Distances b = nearest_distances(marks_in(some, share, low, high));
        const std::string where = "the first " + std::to_string(share) + ", x from " + std::to_string(low);
        EXPECT_NEAR(b.mean, a.mean, 0.02 * a.mean) << where;
        EXPECT_GT(b.least, 0.95 * a.least) << where;
    };
    for (const double share : {0.05, 0.15}) compare(share, -0.3, 2.0);
    for (const double share : {0.4, 1.0}) compare(share, 0.3, 2.0);
}

TEST(Need, PlacesTheWholeOrderIfAllIsNeeded) {
    const Sphere sphere;
    const All need;
    const EvenMarks whole = spread(runtime(), sphere, {1.0, 0.0, 0.0}, wanted, nullptr);
    const EvenMarks all = spread(runtime(), sphere, {1.0, 0.0, 0.0}, wanted, &need);
    ASSERT_EQ(all.position.size(), whole.position.size());
    EXPECT_EQ(all.whole, whole.position.size());
    double farthest = 0.0;
    for (std::int64_t i = 0; i < all.position.size(); ++i) {
        EXPECT_EQ(all.position[i], whole.position[i]) << i;
        farthest = std::max(farthest, std::abs(place_of(all, i) - place_of(whole, i)));
    }
    EXPECT_LT(farthest, 1e-9);
}

TEST(Need, GivesTheSameBitsForAnyNumberOfThreads) {
    const ThinSlab slab(0.004);
    const ByBands need(0.1);
    base::Runtime one = with_threads(1);
    base::Runtime three = with_threads(3);
    const EvenMarks a = spread(one, slab, {0.0, 0.0, 0.002}, 8000, &need);
    const EvenMarks b = spread(three, slab, {0.0, 0.0, 0.002}, 8000, &need);
    EXPECT_TRUE(same_bits(a.place, b.place));
    EXPECT_TRUE(same_bits(a.position.x, b.position.x));
}

} // namespace
} // namespace hrbfnpr::stipples::need_test
