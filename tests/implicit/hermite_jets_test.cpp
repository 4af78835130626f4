// SPDX-License-Identifier: MIT
#include "implicit/hermite_jets.h"

#include "implicit/hermite_hessians.h"

#include "fields.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace hermite_jets_test {

namespace base = hrbfnpr::base;
namespace implicit = hrbfnpr::implicit;
namespace kernel = hrbfnpr::kernel;
using hrbfnpr::test::instruction_sets;
using test::Points;
using test::scatter;

namespace {

constexpr std::size_t fields = 10;                                   // value, gradient, Hessian
constexpr double before = 0.5;                                       // initial value of the sums
constexpr double infinite = std::numeric_limits<double>::infinity(); // stands after the sources in use

using Jets = std::array<std::vector<double>, fields>;

// The columns are x y z alpha beta.
struct Weighted {
    explicit Weighted(int count) {
        for (std::size_t c = 0; c < column.size(); ++c)
            for (int j = 0; j < count; ++j) column[c].push_back(scatter(7 * j + static_cast<int>(c)));
    }
    [[nodiscard]] implicit::Sources part(std::int64_t begin, std::int64_t end) const {
        return {column[0].data() + begin, column[1].data() + begin, column[2].data() + begin, column[3].data() + begin,
                column[4].data() + begin, column[5].data() + begin, column[6].data() + begin, end - begin};
    }
    std::array<std::vector<double>, 7> column;
};

// Points away from sources, and one at a source.
Points places(const Weighted& sources, int count) {
    Points points;
    for (int i = 0; i < count; ++i) points.add({scatter(900 + 3 * i), scatter(901 + 3 * i), scatter(902 + 3 * i)});
    points.add({sources.column[0][1], sources.column[1][1], sources.column[2][1]});
    return points;
}

Jets empty(const Points& points) {
    Jets jets;
    for (std::vector<double>& field : jets) field.assign(points.size(), before);
    return jets;
}

implicit::JetTargets targets(const Points& points, Jets& jets, std::size_t begin, std::size_t end) {
    const auto at = [&](std::size_t c) { return jets[c].data() + begin; };
    return {points.x.data() + begin,
            points.y.data() + begin,
            points.z.data() + begin,
            at(0),
            {at(1), at(2), at(3)},
            {at(4), at(5), at(6), at(7), at(8), at(9)},
            static_cast<std::int64_t>(end - begin)};
}

// Sums jets with the function whose lanes are targets.
Jets by_targets(base::InstructionSet set, const Weighted& sources, const std::vector<implicit::SourceRange>& ranges,
                const Points& points) {
    Jets jets = empty(points);
    const implicit::JetTargets t = targets(points, jets, 0, points.size());
    for (const implicit::SourceRange& range : ranges) {
        const implicit::Sources some = sources.part(range.begin, range.end);
        implicit::hermite_sums(set, kernel::Kind::triharmonic)(
            0.0, some, {t.x, t.y, t.z, t.value, t.gradient[0], t.gradient[1], t.gradient[2], t.count});
        implicit::hermite_hessians(set, kernel::Kind::triharmonic)(
            0.0, some,
            {t.x,
             t.y,
             t.z,
             {t.hessian[0], t.hessian[1], t.hessian[2], t.hessian[3], t.hessian[4], t.hessian[5]},
             t.count});
    }
    return jets;
}

TEST(HermiteJets, MatchTheSumsAndTheirHessians) {
    const Weighted sources(61);
    const Points points = places(sources, 7);
    // Ranges of whole vectors, of parts of one, an empty range, and a single source.
    const std::vector<implicit::SourceRange> ranges{{0, 16}, {17, 17}, {20, 33}, {40, 41}, {50, 61}};
    for (const base::InstructionSet set : instruction_sets()) {
        Jets jets = empty(points);
        implicit::triharmonic_jets_of(set)(sources.part(0, 61), ranges.data(), static_cast<std::int64_t>(ranges.size()),
                                           targets(points, jets, 0, points.size()));
        const Jets expected = by_targets(set, sources, ranges, points);
        for (std::size_t c = 0; c < fields; ++c)
            for (std::size_t i = 0; i < points.size(); ++i)
                EXPECT_NEAR(jets[c][i], expected[c][i], 1e-12) << "field " << c << ", place " << i;
    }
}

TEST(HermiteJets, DoNotDependOnOtherPoints) {
    const Weighted sources(29);
    const Points points = places(sources, 6);
    const implicit::SourceRange all{0, 29};
    for (const base::InstructionSet set : instruction_sets()) {
        Jets together = empty(points);
        Jets apart = empty(points);
        const implicit::AddTriharmonicJets add = implicit::triharmonic_jets_of(set);
        add(sources.part(0, 29), &all, 1, targets(points, together, 0, points.size()));
        for (std::size_t i = 0; i < points.size(); ++i)
            add(sources.part(0, 29), &all, 1, targets(points, apart, i, i + 1));
        EXPECT_EQ(together, apart);
    }
}

TEST(HermiteJets, ReadNoSourcesOutsideTheRange) {
    Weighted sources(16);
    for (std::vector<double>& column : sources.column)
        for (std::size_t j = 11; j < 16; ++j) column[j] = infinite;
    const Points points = places(sources, 2);
    const implicit::SourceRange some{0, 11};
    for (const base::InstructionSet set : instruction_sets()) {
        Jets jets = empty(points);
        implicit::triharmonic_jets_of(set)(sources.part(0, 16), &some, 1, targets(points, jets, 0, points.size()));
        for (const std::vector<double>& field : jets)
            for (const double value : field) EXPECT_TRUE(std::isfinite(value));
    }
}

} // namespace

} // namespace hermite_jets_test
