// SPDX-License-Identifier: MIT
// Tests the parts of the progressive order: its loops, and the moves into a gap.
#include "support/point_sets.h"

#include "geometry/point_tree.h"
#include "stipples/candidates.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>

namespace hrbfnpr::stipples::order_test {
namespace {

using namespace marks;
using namespace test;

constexpr OrderGroup::Column columns[] = {OrderGroup::x,      OrderGroup::y,      OrderGroup::z,
                                          OrderGroup::normal, OrderGroup::energy, OrderGroup::clearance};

struct Block {
    explicit Block(std::int64_t count) : groups(static_cast<std::size_t>(groups_for(count))) {
        std::mt19937 random(7);
        std::uniform_real_distribution<float> number(-1.0F, 1.0F);
        const OrderBlock all = view();
        forget_marks(all, count);
        for (std::int64_t i = 0; i < count; ++i) {
            const glm::vec3 n = glm::normalize(glm::vec3(number(random), number(random), number(random)));
            const float normal[3] = {n.x, n.y, n.z};
            for (const OrderGroup::Column c : {OrderGroup::x, OrderGroup::y, OrderGroup::z})
                all.at(c, i) = number(random);
            all.at(OrderGroup::normal, i) = packed_normal(normal);
            all.at(OrderGroup::energy, i) = 1.0F + number(random);
            all.at(OrderGroup::clearance, i) = 1.0F + number(random);
        }
    }
    [[nodiscard]] OrderBlock view() { return {groups.data(), static_cast<std::int64_t>(groups.size())}; }
    [[nodiscard]] std::array<float, 6> place(std::int64_t i) {
        std::array<float, 6> all{};
        std::transform(std::begin(columns), std::end(columns), all.begin(), [&](auto c) { return view().at(c, i); });
        return all;
    }

    std::vector<OrderGroup> groups;
};

void expect_equal(Block& a, Block& b, std::int64_t count) {
    for (std::int64_t i = 0; i < OrderGroup::size * static_cast<std::int64_t>(a.groups.size()); ++i)
        EXPECT_EQ(a.place(i), b.place(i)) << i << " of " << count;
}

// Computes the sums by their definition, one candidate at a time.
void feel_plainly(const OrderBlock& block, std::int64_t count, const OrderMark& mark, float inverse) {
    for (std::int64_t i = 0; i < count; ++i) {
        float squared = 0.0F;
        float turn = 0.0F;
        float normal[3];
        float normal_of_mark[3];
        unpack_normal(block.at(OrderGroup::normal, i), normal);
        unpack_normal(mark.normal, normal_of_mark);
        for (int c = 0; c < 3; ++c) {
            const float offset = block.at(columns[c], i) - mark.position[c];
            squared += offset * offset;
            turn += normal[c] * normal_of_mark[c];
        }
        if (turn < least_side_cosine * unpacked_length * unpacked_length) continue;
        const float rest = std::max(0.0F, 1.0F - squared * inverse);
        block.at(OrderGroup::energy, i) += rest * rest * (rest * rest);
        block.at(OrderGroup::clearance, i) = std::min(block.at(OrderGroup::clearance, i), squared);
    }
}

OrderMark mark_at(const glm::vec3& p) {
    const float up[3] = {0.0F, 0.6F, 0.8F};
    return {{p.x, p.y, p.z}, packed_normal(up)};
}

TEST(OrderLoops, GiveTheBitsOfThePlainSumsOnEveryInstructionSet) {
    const OrderMark mark = mark_at({0.1F, -0.2F, 0.3F});
    for (const auto set : {base::InstructionSet::baseline, base::InstructionSet::avx2, base::InstructionSet::avx512})
        for (const std::int64_t count : {1, 3, 4, 15, 16, 17, 100}) {
            const OrderLoops loops = order_loops(base::choose_instruction_set(set));
            Block plain(count);
            Block fast(count);
            const OrderBlock block = plain.view();
            feel_plainly(block, count, mark, 0.4F);
            loops.add_energy[0](fast.view(), &mark, 1, 0.4F);
            expect_equal(plain, fast, count);
            std::int64_t best = -1;
            float at_any_clearance = std::numeric_limits<float>::infinity();
            for (std::int64_t i = 0; i < count; ++i) {
                const float energy = block.at(OrderGroup::energy, i);
                at_any_clearance = std::min(at_any_clearance, energy);
                if (block.at(OrderGroup::clearance, i) >= 0.5F &&
                    (best < 0 || energy < block.at(OrderGroup::energy, best)))
                    best = i;
            }
            EXPECT_EQ(loops.lowest(fast.view(), 0.5F).at, best) << count;
            EXPECT_EQ(loops.lowest(fast.view(), 9.0F).at, -1);
            Block both(count);
            const LowestEnergy found = loops.add_energy_and_find[0](both.view(), mark, 0.4F, 0.5F);
            expect_equal(plain, both, count);
            EXPECT_EQ(found.at, best) << count;
            EXPECT_EQ(found.energy,
                      best < 0 ? std::numeric_limits<float>::infinity() : block.at(OrderGroup::energy, best));
            EXPECT_EQ(found.at_any_clearance, at_any_clearance);
        }
}

TEST(OrderLoops, SeveralMarksActLikeOneAfterAnother) {
    const OrderMark marks[] = {mark_at({0.1F, -0.2F, 0.3F}), mark_at({-0.4F, 0.2F, 0.1F}), mark_at({0.0F, 0.5F, 0.2F})};
    for (const auto set : {base::InstructionSet::baseline, base::InstructionSet::avx2, base::InstructionSet::avx512}) {
        Block plain(37);
        Block fast(37);
        for (const OrderMark& mark : marks) feel_plainly(plain.view(), 37, mark, 0.4F);
        order_loops(base::choose_instruction_set(set)).add_energy[0](fast.view(), marks, 3, 0.4F);
        expect_equal(plain, fast, 37);
    }
}

// Two planes with normals along x and y meet in the z axis. The way between them is measured along the planes, as if
// they were unfolded.
TEST(OrderLoops, DistancesAreMeasuredAlongTheSurface) {
    const float along_x[3] = {1.0F, 0.0F, 0.0F};
    const float along_y[3] = {0.0F, 1.0F, 0.0F};
    const OrderMark mark{{0.0F, -0.3F, 0.1F}, packed_normal(along_x)};
    for (const auto set : {base::InstructionSet::baseline, base::InstructionSet::avx2, base::InstructionSet::avx512}) {
        Block block(20);
        for (std::int64_t i = 0; i < 20; ++i) {
            const float x = -0.02F * static_cast<float>(i);
            block.view().at(OrderGroup::x, i) = x;
            block.view().at(OrderGroup::y, i) = 0.0F;
            block.view().at(OrderGroup::z, i) = 0.1F;
            block.view().at(OrderGroup::normal, i) = packed_normal(along_y);
        }
        forget_marks(block.view(), 20);
        const OrderLoops loops = order_loops(base::choose_instruction_set(set));
        loops.add_energy[1](block.view(), &mark, 1, 0.4F);
        for (std::int64_t i = 0; i < 20; ++i) {
            const float way = 0.3F + 0.02F * static_cast<float>(i);
            EXPECT_NEAR(block.view().at(OrderGroup::clearance, i), way * way, 0.01F * way * way) << i;
            EXPECT_NEAR(block.view().at(OrderGroup::energy, i), std::pow(1.0F - 0.4F * way * way, 4.0F), 0.01F) << i;
        }
        Block other(20);
        const LowestEnergy found = loops.add_energy_and_find[1](other.view(), mark, 0.4F, 0.0F);
        EXPECT_GE(found.at, 0);
    }
}

TEST(OrderLoops, TheFirstOfEqualMinimaIsFound) {
    constexpr float none = std::numeric_limits<float>::infinity();
    std::vector<float> numbers(100, none);
    for (const auto set : {base::InstructionSet::baseline, base::InstructionSet::avx2, base::InstructionSet::avx512}) {
        const OrderLoops loops = order_loops(base::choose_instruction_set(set));
        std::fill(numbers.begin(), numbers.end(), none);
        EXPECT_EQ(loops.index_of_smallest(numbers.data(), 100), -1);
        numbers[95] = numbers[83] = numbers[67] = 0.5F;
        EXPECT_EQ(loops.index_of_smallest(numbers.data(), 100), 67);
        EXPECT_EQ(loops.index_of_smallest(numbers.data(), 67), -1);
        numbers[3] = 0.25F;
        EXPECT_EQ(loops.index_of_smallest(numbers.data(), 5), 3);
    }
}

// The former content of memory must not matter: a NaN there would get into the energies.
TEST(OrderLoops, FreePlacesAreNotNaN) {
    Block block(16);
    for (std::int64_t i = 0; i < 16; ++i)
        for (const OrderGroup::Column c : columns) block.view().at(c, i) = std::numeric_limits<float>::quiet_NaN();
    forget_marks(block.view(), 5);
    for (std::int64_t i = 5; i < 16; ++i)
        for (const OrderGroup::Column c : columns) EXPECT_FALSE(std::isnan(block.view().at(c, i))) << i;
    EXPECT_TRUE(std::isnan(block.place(0)[0])) << "only after the last one";
}

TEST(OrderLoops, TheFirstOfEqualEnergiesIsTheLowest) {
    Block block(40);
    for (std::int64_t i = 0; i < 40; ++i) {
        block.view().at(OrderGroup::energy, i) = i % 7 == 5 ? 0.25F : 0.5F;
        block.view().at(OrderGroup::clearance, i) = i < 10 ? 0.0F : 1.0F;
    }
    for (const auto set : {base::InstructionSet::baseline, base::InstructionSet::automatic})
        EXPECT_EQ(order_loops(base::choose_instruction_set(set)).lowest(block.view(), 0.5F).at, 12);
}

TEST(PackedNormals, AreExactToATenthOfADegree) {
    std::mt19937 random(3);
    std::normal_distribution<float> number;
    for (int i = 0; i < 1000; ++i) {
        const glm::vec3 n = glm::normalize(glm::vec3(number(random), number(random), number(random)));
        const float normal[3] = {n.x, n.y, n.z};
        float back[3];
        unpack_normal(packed_normal(normal), back);
        EXPECT_GT(glm::dot(n, glm::normalize(glm::vec3(back[0], back[1], back[2]))), std::cos(0.0035F));
    }
    const float ends[3] = {1.0F, -1.0F, 1.0F + 1e-6F};
    float back[3];
    unpack_normal(packed_normal(ends), back);
    EXPECT_NEAR(back[0], unpacked_length, 1.0F);
    EXPECT_NEAR(back[1], -unpacked_length, 1.0F);
    EXPECT_NEAR(back[2], unpacked_length, 1.0F);
}

double nearest(const std::vector<glm::dvec2>& points, const glm::dvec2& p) {
    double least = 1e300;
    for (const glm::dvec2& q : points) least = std::min(least, glm::distance(p, q));
    return least;
}

TEST(VoidCentre, IsTheMiddleOfATriangle) {
    const std::vector<glm::dvec2> corners = {{0.3, 0.0}, {-0.8, 0.9}, {-0.8, -0.9}};
    const glm::dvec2 way = toward_void(corners, 10.0, 5.0);
    const double radius = nearest(corners, way);
    for (const glm::dvec2& corner : corners) EXPECT_NEAR(glm::distance(corner, way), radius, 1e-9);
}

TEST(VoidCentre, StopsWhereThereIsEnoughRoom) {
    const std::vector<glm::dvec2> corners = {{0.3, 0.0}, {-0.8, 0.9}, {-0.8, -0.9}};
    const glm::dvec2 way = toward_void(corners, 0.5, 5.0);
    EXPECT_NEAR(nearest(corners, way), 0.5, 1e-9);
    EXPECT_NEAR(way.x, -0.2, 1e-9) << "straight away from the nearest";
    EXPECT_EQ(toward_void(corners, 0.5, 0.1), glm::dvec2(0.0)) << "too far";
    EXPECT_EQ(toward_void({}, 0.5, 1.0), glm::dvec2(0.0));
}

TEST(VoidCentre, NeverMovesNearerToThePoints) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(-2.0, 2.0);
    for (int trial = 0; trial < 500; ++trial) {
        std::vector<glm::dvec2> points;
        for (int i = 0; i < 12; ++i) points.emplace_back(number(random), number(random));
        const glm::dvec2 way = toward_void(points, 0.8, 1.5);
        EXPECT_GE(nearest(points, way), nearest(points, {0.0, 0.0}) - 1e-9);
        EXPECT_LE(glm::length(way), 1.5 + 1e-12);
    }
}

// The variance of a smooth count of marks, over that of independent marks: bench/evenness.h, docs/quality.md.
double low_frequencies(const PointSet& set, std::int64_t count, double area) {
    geometry::VecArray points(runtime().memory);
    for (std::int64_t i = 0; i < count; ++i) points.push_back(position(set, Kind::stipples, i));
    const geometry::PointTree tree(points, {});
    const double density = static_cast<double>(count) / area;
    const double sigma = 2.0 / (3.14159265 * std::sqrt(density));
    double sum = 0.0;
    double squares = 0.0;
    constexpr int places = 4000;
    for (int k = 0; k < places; ++k) {
        const std::array<double, 3> p = spiral_point(k, places);
        double energy = 0.0;
        tree.within({p[0], p[1], p[2]}, 3.5 * sigma,
                    [&](std::int64_t, double squared) { energy += std::exp(-squared / (2.0 * sigma * sigma)); });
        sum += energy / places;
        squares += energy * energy / places;
    }
    return (squares - sum * sum) / (density * 3.14159265 * sigma * sigma);
}

TEST(ProgressiveOrder, EveryPrefixHasNoLowFrequencies) {
    const Sphere sphere;
    const double area = 4.0 * 3.14159265358979;
    const PointSet set = make(sphere, blue({Kind::stipples}, 12000));
    for (const double share : {0.05, 0.15, 0.25, 0.4, 0.6, 0.8, 1.0})
        EXPECT_LT(low_frequencies(set, std::lround(share * 12000), area), 0.10) << share;
    generate::Settings random = recursion({Kind::stipples}, 3);
    of(random, Kind::stipples).budget = 12000;
    EXPECT_GT(low_frequencies(make(sphere, random), 12000, area), 0.5) << "the measure tells others apart";
}

} // namespace
} // namespace hrbfnpr::stipples::order_test
