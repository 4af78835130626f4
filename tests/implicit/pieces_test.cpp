// SPDX-License-Identifier: MIT
// Tests maxima and minima of sheets, cell by cell, and smooth transitions between cells.
#include "implicit/sheet_tree.h"

#include "base/random.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace pieces_test {

namespace implicit = hrbfnpr::implicit;
using hrbfnpr::base::InstructionSet;
using implicit::SheetTreeData;

namespace {

constexpr std::int32_t larger = SheetTreeData::maximum;
constexpr std::int32_t smaller = SheetTreeData::minimum;

// A fit without centres: d + n . p + a x^2 + b y z.
implicit::HrbfData sheet(hrbfnpr::base::Memory& memory, double d, const glm::dvec3& n, double a = 0.0, double b = 0.0) {
    implicit::HrbfData data(memory);
    data.polynomial_degree = 2;
    for (const double c : {d, n.x, n.y, n.z, a, 0.0, 0.0, 0.0, b, 0.0}) data.polynomial.push_back(c);
    data.bounds = {glm::dvec3(-1.0), glm::dvec3(1.0)};
    return data;
}

// The box [-1, 1]^3 and four sheets, in eight cells with these programs. A cell whose program is empty is plain.
SheetTreeData eight(hrbfnpr::base::Memory& memory, const std::vector<std::vector<std::int32_t>>& programs) {
    SheetTreeData data(memory);
    data.sheet.add(sheet(memory, -0.2, {1.0, 0.1, 0.0}, 0.3, 0.1));
    data.sheet.add(sheet(memory, 0.1, {0.0, 1.0, 0.2}, 0.0, 0.4));
    data.sheet.add(sheet(memory, 0.3, {0.3, 0.0, 1.0}, -0.2, 0.0));
    data.sheet.add(sheet(memory, -0.1, {-0.5, 0.5, 0.5}, 0.1, 0.2));
    data.bounds = {glm::dvec3(-1.0), glm::dvec3(1.0)};
    data.side = 1.02 * SheetTreeData::reach * data.bounds.diagonal();
    data.corner = glm::dvec3(-0.5 * data.side);
    data.child.push_back(1);
    for (std::int32_t leaf = 0; leaf < 8; ++leaf) {
        data.child.push_back(-1 - leaf);
        data.program_begin.push_back(static_cast<std::int32_t>(data.program.size()));
        for (const std::int32_t code : programs[static_cast<std::size_t>(leaf) % programs.size()])
            data.program.push_back(code);
        for (const double number : {0.7, 0.1, -0.2, 0.05}) data.plain.push_back(number);
    }
    data.program_begin.push_back(static_cast<std::int32_t>(data.program.size()));
    return data;
}

const std::vector<std::vector<std::int32_t>> mixed{{0, 1, larger},  {0, 1, 2, smaller, larger}, {3}, {},
                                                   {0, 3, smaller}, {1, 2, larger, 0, smaller}, {2}, {0}};

struct At {
    double value;
    glm::dvec3 gradient;
    double hessian[6];
};

At at(const implicit::Implicit& f, const glm::dvec3& p) {
    At result{};
    f.evaluate({&p.x, &p.y, &p.z, 1}, {&result.value,
                                       {&result.gradient.x, &result.gradient.y, &result.gradient.z},
                                       {&result.hessian[0], &result.hessian[1], &result.hessian[2], &result.hessian[3],
                                        &result.hessian[4], &result.hessian[5]}});
    return result;
}

double value_of(const implicit::HrbfData& data, const glm::dvec3& p) {
    double value = 0.0;
    implicit::evaluate(data, {&p.x, &p.y, &p.z, 1}, {&value, {}, {}});
    return value;
}

glm::dvec3 place(std::uint64_t i, double half) {
    const auto random = hrbfnpr::base::uniform4(7, i, hrbfnpr::base::Purpose::probe);
    return half * (2.0 * glm::dvec3(random[0], random[1], random[2]) - 1.0);
}

std::int32_t active_at(const implicit::Sheets& sheets, const glm::dvec3& p) {
    std::int32_t sheet = -1;
    sheets.active({&p.x, &p.y, &p.z, 1}, &sheet);
    return sheet;
}

TEST(Pieces, EqualTheTreeThatAllCellsContain) {
    const auto runtime = hrbfnpr::test::with_threads(1);
    const implicit::SheetTree f(InstructionSet::automatic,
                                eight(runtime.memory, {{0, 1, larger, 2, 3, smaller, smaller}}));
    ASSERT_TRUE(implicit::is_sound(f.data()));
    const implicit::Sheets& sheets = *f.sheets();
    ASSERT_EQ(sheets.count(), 5);
    for (std::uint64_t i = 0; i < 500; ++i) {
        const glm::dvec3 p = place(i, 1.0);
        double v[4];
        for (int k = 0; k < 4; ++k) v[k] = value_of(f.data().sheet[k], p);
        const double expected = std::min(std::max(v[0], v[1]), std::min(v[2], v[3]));
        const At got = at(f, p);
        EXPECT_NEAR(got.value, expected, 1e-14);
        const std::int32_t active = active_at(sheets, p);
        ASSERT_LT(active, 4);
        EXPECT_EQ(v[active], expected);
        double alone = 0.0;
        sheets.evaluate(active, {&p.x, &p.y, &p.z, 1}, {&alone, {}, {}});
        EXPECT_EQ(alone, got.value);
    }
}

// Places are in [-1, 1]^3, where the outer sphere begins, and where it is the only sheet.
TEST(Pieces, DerivativesMatchDifferences) {
    const auto runtime = hrbfnpr::test::with_threads(1);
    const implicit::SheetTree f(InstructionSet::automatic, eight(runtime.memory, mixed));
    ASSERT_TRUE(implicit::is_sound(f.data()));
    const double h = 1e-5;
    int compared = 0;
    for (std::uint64_t i = 0; i < 600; ++i) {
        const glm::dvec3 p = place(i, i % 3 == 0 ? 0.3 : i % 3 == 1 ? 1.5 : 3.0);
        const At here = at(f, p);
        std::vector<At> beside;
        for (int axis = 0; axis < 3; ++axis)
            for (const double sign : {-1.0, 1.0}) {
                glm::dvec3 q = p;
                q[axis] += sign * h;
                beside.push_back(at(f, q));
            }
        // Skips creases, where the gradient jumps.
        bool smooth = true;
        for (const At& one : beside) smooth = smooth && glm::distance(one.gradient, here.gradient) < 100.0 * h;
        if (!smooth) continue;
        ++compared;
        constexpr int index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
        for (int axis = 0; axis < 3; ++axis) {
            const At& low = beside[static_cast<std::size_t>(2 * axis)];
            const At& high = beside[static_cast<std::size_t>(2 * axis) + 1];
            EXPECT_NEAR(here.gradient[axis], (high.value - low.value) / (2.0 * h), 1e-6);
            for (int c = 0; c < 3; ++c)
                EXPECT_NEAR(here.hessian[index[axis][c]], (high.gradient[c] - low.gradient[c]) / (2.0 * h), 2e-5)
                    << "at " << p.x << ' ' << p.y << ' ' << p.z;
        }
    }
    EXPECT_GT(compared, 500);
}

TEST(Pieces, APointsResultDoesNotDependOnOtherPoints) {
    const auto runtime = hrbfnpr::test::with_threads(1);
    const implicit::SheetTree f(InstructionSet::automatic, eight(runtime.memory, mixed));
    constexpr std::int64_t count = 300;
    std::vector<double> x, y, z, value(count), gx(count), gy(count), gz(count), only(count);
    std::vector<std::vector<double>> h(6, std::vector<double>(count));
    std::vector<std::int32_t> active(count);
    for (std::uint64_t i = 0; i < count; ++i) {
        const glm::dvec3 p = place(i, 2.0);
        x.push_back(p.x);
        y.push_back(p.y);
        z.push_back(p.z);
    }
    const implicit::PointBatch points{x.data(), y.data(), z.data(), count};
    f.evaluate(points, {value.data(),
                        {gx.data(), gy.data(), gz.data()},
                        {h[0].data(), h[1].data(), h[2].data(), h[3].data(), h[4].data(), h[5].data()}});
    f.evaluate(points, {only.data(), {}, {}});
    f.active(points, active.data());
    EXPECT_EQ(only, value);
    for (std::size_t i = 0; i < count; ++i) {
        const glm::dvec3 p{x[i], y[i], z[i]};
        const At one = at(f, p);
        EXPECT_EQ(one.value, value[i]);
        EXPECT_EQ(one.gradient, glm::dvec3(gx[i], gy[i], gz[i]));
        for (std::size_t c = 0; c < 6; ++c) EXPECT_EQ(one.hessian[c], h[c][i]);
        EXPECT_EQ(active_at(f, p), active[i]);
    }
}

TEST(Pieces, FarAwayEqualTheDistanceFromASphere) {
    const auto runtime = hrbfnpr::test::with_threads(1);
    const implicit::SheetTree f(InstructionSet::automatic, eight(runtime.memory, mixed));
    for (const glm::dvec3& p : {glm::dvec3(30.0, 0.0, 0.0), glm::dvec3(-1e6, 2e6, 5.0)})
        EXPECT_NEAR(at(f, p).value, glm::length(p) - std::sqrt(3.0), 1e-9 * glm::length(p));
    EXPECT_TRUE(std::isnan(at(f, glm::dvec3(std::nan(""))).value));
    EXPECT_EQ(active_at(f, {30.0, 0.0, 0.0}), 4);
}

// A file may have a program that names its only sheet twice. The cells here are small enough for zones.
TEST(Pieces, ZonesAcceptASheetThatIsNamedTwice) {
    const auto runtime = hrbfnpr::test::with_threads(1);
    SheetTreeData data = eight(runtime.memory, {{}});
    data.child.clear();
    data.program_begin.clear();
    for (std::int32_t node = 0; node < 1 + 8 + 64; ++node) data.child.push_back(1 + 8 * node);
    for (std::int32_t leaf = 0; leaf < 512; ++leaf) {
        data.child.push_back(-1 - leaf);
        data.program_begin.push_back(static_cast<std::int32_t>(data.program.size()));
        for (const std::int32_t code : {0, 0, larger}) data.program.push_back(code);
    }
    data.program_begin.push_back(static_cast<std::int32_t>(data.program.size()));
    data.plain.resize(4 * 512);
    const implicit::SheetTree f(InstructionSet::automatic, std::move(data));
    ASSERT_TRUE(implicit::is_sound(f.data()));
    const implicit::PreparedSheetTree prepared(runtime, f, implicit::PreparedSheetTree::Scope::zones);
    EXPECT_FALSE(prepared.zones()->candidates_at(glm::dvec3(0.1)).parts.empty());
    for (std::uint64_t i = 0; i < 100; ++i) {
        const glm::dvec3 p = place(i, 1.0);
        EXPECT_EQ(at(prepared, p).value, value_of(f.data().sheet[0], p));
    }
}

TEST(Pieces, WithADamagedProgramOrTreeAreNotSound) {
    const auto runtime = hrbfnpr::test::with_threads(1);
    const auto damaged = [&](auto&& damage) {
        SheetTreeData data = eight(runtime.memory, mixed);
        damage(data);
        return !implicit::is_sound(data);
    };
    EXPECT_FALSE(damaged([](SheetTreeData&) {}));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.program[0] = 4; }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.program[0] = -3; }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.program[0] = larger; }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.program[2] = 0; }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { std::swap(data.program_begin[1], data.program_begin[2]); }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.program_begin[8] -= 1; }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.child[0] = 0; }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.child[0] = 2; }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.child[3] = 9; }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.child[3] = -9; }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.plain.resize(31); }));
    EXPECT_TRUE(damaged([](SheetTreeData& data) { data.sheet.clear(); }));
}

} // namespace

} // namespace pieces_test
