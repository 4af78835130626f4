// SPDX-License-Identifier: MIT
#include "implicit/mirrored_sums.h"

#include "fields.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace mirrored_sums_test {

namespace base = hrbfnpr::base;
namespace implicit = hrbfnpr::implicit;
using hrbfnpr::test::instruction_sets;
using implicit::MirroredSources;
using test::scatter;

namespace {

using Numbers = std::vector<double>;

constexpr std::int64_t groups = 24;
constexpr double middle[3] = {3.0, -1.0, 0.5};
constexpr double half = 0.25;

// Centres at least five half widths from the middle, with weights.
struct Centres {
    explicit Centres(int count) {
        for (int j = 0; j < count; ++j) {
            const glm::dvec3 to(scatter(7 * j), scatter(7 * j + 1), scatter(7 * j + 2));
            const glm::dvec3 away = (5.0 + 4.0 * std::abs(scatter(9 * j))) /
                                    std::max({std::abs(to.x), std::abs(to.y), std::abs(to.z)}) * to;
            x.push_back(middle[0] + half * away.x);
            y.push_back(middle[1] + half * away.y);
            z.push_back(middle[2] + half * away.z);
            alpha.push_back(scatter(7 * j + 3));
            beta_x.push_back(scatter(7 * j + 4));
            beta_y.push_back(scatter(7 * j + 5));
            beta_z.push_back(scatter(7 * j + 6));
        }
    }
    [[nodiscard]] implicit::Sources all() const {
        return {x.data(),      y.data(),      z.data(),      alpha.data(),
                beta_x.data(), beta_y.data(), beta_z.data(), static_cast<std::int64_t>(x.size())};
    }
    [[nodiscard]] double sum(const glm::dvec3& p) const {
        double sum = 0.0;
        for (std::size_t j = 0; j < x.size(); ++j) {
            const glm::dvec3 d = p - glm::dvec3(x[j], y[j], z[j]);
            const double r = glm::length(d);
            sum += alpha[j] * r * r * r - 3.0 * r * glm::dot(glm::dvec3(beta_x[j], beta_y[j], beta_z[j]), d);
        }
        return sum;
    }
    Numbers x, y, z, alpha, beta_x, beta_y, beta_z;
};

TEST(MirroredSums, AddTheSumsOverAllSources) {
    Numbers node[3];
    for (int c = 0; c < 3; ++c)
        for (int g = 0; g < groups; ++g) node[c].push_back(std::abs(scatter(3 * g + c)));
    for (const int count : {0, 1, 7, static_cast<int>(MirroredSources::most)}) {
        const Centres centres(count);
        const auto sources = std::make_unique<MirroredSources>();
        for (int j = 0; j < count; ++j) sources->add(centres.all(), j, middle, half);
        for (const base::InstructionSet set : instruction_sets()) {
            Numbers values(8 * groups, 1.0);
            implicit::mirrored_sums(set)({node[0].data(), node[1].data(), node[2].data(), groups}, *sources,
                                         values.data());
            for (std::size_t i = 0; i < values.size(); ++i) {
                const std::size_t sign = i / groups;
                glm::dvec3 p;
                for (std::size_t c = 0; c < 3; ++c) {
                    const double coordinate = node[c][i % groups];
                    p[static_cast<glm::length_t>(c)] =
                        middle[c] + half * ((sign >> c & 1) != 0 ? -coordinate : coordinate);
                }
                EXPECT_NEAR((values[i] - 1.0) * half * half * half, centres.sum(p), 3e-14 * (1 + count))
                    << base::name(set) << " " << count << " " << i;
            }
        }
    }
}

} // namespace

} // namespace mirrored_sums_test
