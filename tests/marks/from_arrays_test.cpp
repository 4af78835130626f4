// SPDX-License-Identifier: MIT
// Tests ready-made marks: the data that are copied, filled in, or refused.
#include "support/point_sets.h"

#include "geometry/tangent_frame.h"
#include "marks/assemble.h"

namespace hrbfnpr::marks::from_arrays_test {
namespace {

using namespace test;

struct Arrays {
    std::vector<double> position = {1, 0, 0, 0, 2, 0, 0, 0, 3, 1, 1, 1};
    std::vector<double> normal = {1, 0, 0, 0, 2, 0, 0, 0, 1, 1, 1, 1};
    std::vector<double> direction = {0, 1, 0, 0, 0.5, 2, 1, 0, 0, 1, -1, 0};
    std::vector<double> curvature = {1, 2, 0.5, 3, 4, 0.25, 0, 0, 0, -1, -2, 1};
    std::vector<double> rank = {0.0, 0.25, 0.5, 1.0};
    std::vector<double> level = {0, 1, 1, 2};
    std::vector<std::uint32_t> stroke_first = {0, 2, 4};
    std::vector<std::uint8_t> stroke_direction = {0, 1};
    std::vector<double> width = {0.5, 1.0, 1.0, 0.25};

    [[nodiscard]] LayerArrays views(Kind kind = Kind::hatch) const {
        LayerArrays arrays;
        arrays.kind = kind;
        arrays.position = view(position);
        arrays.normal = view(normal);
        arrays.direction = view(direction);
        arrays.curvature = view(curvature);
        arrays.rank = view(rank, 1);
        arrays.level = view(level, 1);
        arrays.width = view(width, 1);
        arrays.stroke_first = {reinterpret_cast<const std::byte*>(stroke_first.data()),
                               static_cast<std::int64_t>(stroke_first.size()), 4, base::Scalar::uint32, 1};
        arrays.stroke_direction = {reinterpret_cast<const std::byte*>(stroke_direction.data()),
                                   static_cast<std::int64_t>(stroke_direction.size()), 1, base::Scalar::uint8, 1};
        return arrays;
    }
    // Only the arrays that are required.
    [[nodiscard]] LayerArrays bare(Kind kind = Kind::own) const {
        LayerArrays arrays;
        arrays.kind = kind;
        arrays.position = view(position);
        arrays.normal = view(normal);
        return arrays;
    }
};

PointSet import(const LayerArrays& arrays, std::uint64_t seed = 1, const PointSet* base = nullptr) {
    return from_arrays(runtime(), base, {&arrays, 1}, seed);
}

TEST(FromArrays, CopiesAndNormalises) {
    const PointSet set = import(Arrays().views());
    const Layer& marks = of(set, Kind::hatch);
    ASSERT_EQ(marks.count(), 4);
    EXPECT_EQ(set.origin, glm::dvec3(0.5, 1.0, 1.5));
    EXPECT_EQ(set.bounds.max, glm::dvec3(1.0, 2.0, 3.0));
    EXPECT_EQ(position(set, Kind::hatch, 1), glm::dvec3(0, 2, 0));
    EXPECT_EQ(vec(marks.normal, 1), glm::dvec3(0, 1, 0)) << "normalised";
    EXPECT_EQ(vec(marks.direction, 1), glm::dvec3(0, 0, 1)) << "made tangent and unit";
    EXPECT_EQ(vec(marks.curvature, 3), glm::dvec3(-1, -2, 1));
    EXPECT_EQ(marks.rank[1], 0.25F);
    EXPECT_LT(marks.rank[3], 1.0F) << "1 becomes the largest number below it";
    EXPECT_EQ(marks.level[3], 2);
    EXPECT_EQ(marks.stroke[6], 3U) << "the second stroke, of the second direction";
    EXPECT_EQ(marks.stroke[7], 1U);
    expect_strokes(marks);
    EXPECT_EQ(marks.width[3], 0.25F);
    EXPECT_EQ(marks.strokes(), 2);
    EXPECT_EQ(marks.report.levels, 2);
    EXPECT_EQ(marks.report.level[1].placed, 2);
    EXPECT_GT(set.spacing, 0.0);
    EXPECT_EQ(of(set, Kind::stipples).count(), 0);
}

TEST(FromArrays, FillsInMissingArrays) {
    const Arrays keep;
    const LayerArrays arrays = keep.bare(Kind::stipples);
    const PointSet set = import(arrays);
    const Layer& marks = of(set, Kind::stipples);
    ASSERT_EQ(marks.count(), 4);
    EXPECT_TRUE(marks.curvature.empty());
    EXPECT_TRUE(marks.width.empty());
    for (std::int64_t i = 0; i < 4; ++i) {
        EXPECT_NEAR(glm::distance(vec(marks.direction, i), geometry::stipple_frame(vec(marks.normal, i)).u), 0.0, 1e-6);
        EXPECT_EQ(marks.level[i], 0);
        EXPECT_EQ(marks.stroke[2 * i], 2 * i);
        EXPECT_EQ(marks.stroke[2 * i + 1], 0U);
    }
    EXPECT_TRUE(same_bits(set, import(arrays)));
    EXPECT_FALSE(same_bits(set, import(arrays, 2))) << "random ranks depend on the seed";
}

TEST(FromArrays, ReadsOtherScalarsAndStrides) {
    const Arrays keep;
    LayerArrays arrays = keep.views(Kind::hatch);
    std::vector<float> floats(16, -1.0F);
    for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t k = 0; k < 3; ++k) floats[4 * i + k] = static_cast<float>(keep.position[3 * i + k]);
    arrays.position = {reinterpret_cast<const std::byte*>(floats.data() + 12), 4, -16, base::Scalar::float32, 3};
    const PointSet set = import(arrays);
    EXPECT_EQ(position(set, Kind::hatch, 0), glm::dvec3(1, 1, 1)) << "a negative stride reads backwards";
    EXPECT_EQ(position(set, Kind::hatch, 3), glm::dvec3(1, 0, 0));
}

TEST(FromArrays, RefusesAndNamesInvalidValues) {
    const auto refuse = [](std::initializer_list<const char*> words, auto&& change) {
        Arrays arrays;
        change(arrays);
        expect_error(Status::invalid_argument, words, [&] { (void)import(arrays.views()); });
    };
    const double nan = std::nan("");
    refuse({"point_set_desc.layers[0].position[2]", "finite"}, [&](Arrays& a) { a.position[7] = nan; });
    refuse({"point_set_desc.layers[0].position[0]", "too large for a float"},
           [&](Arrays& a) { a.position[0] = 1e300; });
    refuse({"point_set_desc.layers[0].normal[1]", "finite"}, [&](Arrays& a) { a.normal[4] = INFINITY; });
    refuse({"point_set_desc.layers[0].normal[1]", "zero"}, [&](Arrays& a) { a.normal[4] = 0.0; });
    refuse({"point_set_desc.layers[0].direction[3]", "finite"}, [&](Arrays& a) { a.direction[9] = nan; });
    refuse({"point_set_desc.layers[0].direction[0]", "tangent"}, [&](Arrays& a) { a.direction[1] = 0.0; });
    refuse({"point_set_desc.layers[0].direction[2]", "tangent"}, [&](Arrays& a) {
        a.direction[6] = 0.0;
        a.direction[8] = 5.0;
    });
    refuse({"point_set_desc.layers[0].curvature[1]", "finite"}, [&](Arrays& a) { a.curvature[5] = nan; });
    refuse({"point_set_desc.layers[0].rank[2]", "[0,1)"}, [&](Arrays& a) { a.rank[2] = -0.1; });
    refuse({"point_set_desc.layers[0].rank[0]", "[0,1)"}, [&](Arrays& a) { a.rank[0] = nan; });
    refuse({"point_set_desc.layers[0].rank[3]", "[0,1)"}, [&](Arrays& a) { a.rank[3] = 1.5; });
    refuse({"point_set_desc.layers[0].normal has 3", "but position has 4"}, [&](Arrays& a) { a.normal.resize(9); });
    refuse({"point_set_desc.layers[0].normal has 0", "give one for each mark"}, [&](Arrays& a) { a.normal.clear(); });
    refuse({"point_set_desc.layers[0].rank has 3", "or none"}, [&](Arrays& a) { a.rank.pop_back(); });
    refuse(
        {"point_set_desc.layers[0].stroke_first[0] is 1; the numbers must increase from 0 to the number of marks, 4"},
        [&](Arrays& a) { a.stroke_first[0] = 1; });
    refuse(
        {"point_set_desc.layers[0].stroke_first[2] is 5; the numbers must increase from 0 to the number of marks, 4"},
        [&](Arrays& a) { a.stroke_first[2] = 5; });
    refuse({"stroke_first[2] is 3"}, [&](Arrays& a) { a.stroke_first[2] = 3; });
    refuse({"stroke_first[1] is 4"}, [&](Arrays& a) { a.stroke_first[1] = 4; });
    refuse({"stroke_first[2] is 2"}, [&](Arrays& a) { a.stroke_first = {0, 2, 2, 4}; });
    refuse({"stroke_first[0] is 0"}, [&](Arrays& a) { a.stroke_first = {0}; });
    refuse({"stroke_direction[1] is 2", "0 or 1"}, [&](Arrays& a) { a.stroke_direction[1] = 2; });
    refuse({"stroke_direction has 1", "2 strokes"}, [&](Arrays& a) { a.stroke_direction.pop_back(); });
    refuse({"stroke_direction has 2", "0 strokes"}, [&](Arrays& a) { a.stroke_first.clear(); });
    refuse({"point_set_desc.layers[0].normal has 4", "but position has 0"}, [&](Arrays& a) { a.position.clear(); });
    expect_error(Status::invalid_argument, {"no layer has a mark", "layers[0].position"}, [] { (void)import({}); });
}

// Strokes get their directions from their course, and appear as a whole.
TEST(FromArrays, StrokesGetDirectionsAndOneRankEach) {
    Arrays arrays;
    arrays.position.clear();
    arrays.normal.clear();
    arrays.stroke_first = {0};
    for (int s = 0; s < 8; ++s) { // the strokes are meridians
        for (int i = 0; i < 20; ++i) {
            const glm::dvec3 p(std::sin(0.3 + 0.1 * i) * std::cos(s), std::sin(0.3 + 0.1 * i) * std::sin(s),
                               std::cos(0.3 + 0.1 * i));
            for (int k = 0; k < 3; ++k) arrays.position.push_back(p[k]);
        }
        arrays.stroke_first.push_back(static_cast<std::uint32_t>(20 * s + 20));
    }
    arrays.normal = arrays.position;
    LayerArrays own = arrays.bare();
    own.stroke_first = arrays.views().stroke_first;
    const PointSet set = import(own);
    const Layer& marks = set.layers[0];
    expect_strokes(marks);
    EXPECT_EQ(marks.kind, Kind::own);
    EXPECT_STREQ(marks.name.data(), "own");
    EXPECT_FALSE(marks.progressive);
    std::vector<float> ranks;
    for (std::int64_t i = 0; i < marks.count(); ++i) {
        const glm::dvec3 p = position(set, marks, i);
        const glm::dvec3 down = glm::normalize(glm::dvec3(p.x * p.z, p.y * p.z, -p.x * p.x - p.y * p.y));
        EXPECT_GT(glm::dot(vec(marks.direction, i), down), 0.9999) << i;
        const std::int64_t first = marks.stroke_first[marks.stroke_of(i)];
        EXPECT_EQ(marks.rank[i], marks.rank[first]) << i;
        EXPECT_EQ(marks.stroke[2 * i], 2 * marks.stroke_of(i));
        if (i == first) ranks.push_back(marks.rank[i]);
    }
    std::sort(ranks.begin(), ranks.end());
    EXPECT_EQ(std::unique(ranks.begin(), ranks.end()), ranks.end());
}

TEST(FromArrays, AddsLayersToAnExistingSet) {
    const PointSet base = make(Torus(), blue({Kind::stipples, Kind::hatch}, 2000));
    const Arrays arrays;
    LayerArrays own = arrays.views(Kind::own);
    own.name = {'h', 'a', 'n', 'd'};
    const PointSet set = import(own, 1, &base);
    ASSERT_EQ(set.layers.size(), 3);
    EXPECT_EQ(set.origin, base.origin);
    EXPECT_EQ(set.spacing, base.spacing);
    EXPECT_EQ(set.distribution, base.distribution);
    for (std::int64_t l = 0; l < 2; ++l) {
        EXPECT_TRUE(same_bits(set.layers[l].position, base.layers[l].position));
        EXPECT_TRUE(same_bits(set.layers[l].stroke_first, base.layers[l].stroke_first));
        EXPECT_EQ(set.layers[l].report.full_count, base.layers[l].report.full_count);
        EXPECT_TRUE(set.layers[l].progressive);
    }
    EXPECT_STREQ(set.layers[2].name.data(), "hand");
    EXPECT_FALSE(set.layers[2].progressive);
    EXPECT_NEAR(glm::distance(position(set, set.layers[2], 1), {0, 2, 0}), 0.0, 1e-6);
    EXPECT_TRUE(set.bounds.contains({0, 0, 3})) << "the bounds hold the new marks too";
    // With more marks than before, each represents less of the area.
    Arrays many;
    many.position = spiral_seeds(8000);
    many.normal = many.position;
    EXPECT_NEAR(import(many.bare(), 1, &base).spacing, 0.5 * base.spacing, 0.01 * base.spacing);
    const PointSet only = from_arrays(runtime(), &base, {}, 1);
    EXPECT_TRUE(same_bits(only, base));
}

// The spacing is estimated from positions alone, here for marks of a known area.
TEST(FromArrays, SpacingIsEstimatedFromThePositions) {
    for (const int n : {100, 600, 3000, 20000}) {
        Arrays arrays;
        arrays.position = spiral_seeds(n);
        arrays.normal = arrays.position;
        const double expected = std::sqrt(4.0 * 3.14159265 / n);
        EXPECT_NEAR(import(arrays.bare()).spacing, expected, 0.15 * expected) << n;
    }
}

} // namespace
} // namespace hrbfnpr::marks::from_arrays_test
