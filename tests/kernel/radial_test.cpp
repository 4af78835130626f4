// SPDX-License-Identifier: MIT
#include "kernel/kernel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

namespace radial_test {

using hrbfnpr::kernel::Kind;
using hrbfnpr::kernel::Radial;
using hrbfnpr::kernel::radial;

namespace {

struct Case {
    Kind kind;
    double radius;
};

constexpr std::array<Case, 6> cases = {{{Kind::triharmonic, 1.0},
                                        {Kind::gaussian, 1.0},
                                        {Kind::gaussian, 0.7},
                                        {Kind::gaussian, 3.0},
                                        {Kind::wendland_c2, 2.0},
                                        {Kind::wendland_c2, 9.0}}};

// The definitions of section 4.1 of the article, written out.
double plain(const Case& c, double r) {
    const double s = r / c.radius;
    switch (c.kind) {
    case Kind::triharmonic: return std::pow(r, 3);
    case Kind::gaussian: return std::exp(-std::pow(r, 2) / (2 * std::pow(c.radius, 2)));
    case Kind::wendland_c2: return s >= 1 ? 0 : std::pow(1 - s, 4) * (4 * s + 1);
    }
    return 0;
}

template <class F>
double difference(F&& f, double r) {
    const double h = 1e-4;
    return (8 * (f(r + h) - f(r - h)) - (f(r + 2 * h) - f(r - 2 * h))) / (12 * h);
}

std::string describe(const Case& c, double r) {
    return std::string(hrbfnpr::kernel::name(c.kind)) + " radius " + std::to_string(c.radius) + " r " +
           std::to_string(r);
}

TEST(Radial, ValueMatchesTheDefinition) {
    for (const Case& c : cases)
        for (const double r : {0.0, 1e-3, 0.3, 1.0, 1.9, 2.5, 8.0, 20.0})
            EXPECT_NEAR(radial(c.kind, c.radius, r).phi, plain(c, r), 1e-14 * (1 + plain(c, r))) << describe(c, r);
}

TEST(Radial, EachTermIsTheDerivativeOfThePreviousOverR) {
    for (const Case& c : cases) {
        for (const double r : {0.1, 0.3, 1.0, 1.7, 2.5, 8.0, 20.0}) {
            const auto field = [&](double Radial::*member) {
                return [&c, member](double at) { return radial(c.kind, c.radius, at).*member; };
            };
            const Radial k = radial(c.kind, c.radius, r);
            EXPECT_NEAR(k.a, difference(field(&Radial::phi), r) / r, 1e-8 * (1 + std::abs(k.a))) << describe(c, r);
            EXPECT_NEAR(k.b, difference(field(&Radial::a), r) / r, 1e-8 * (1 + std::abs(k.b))) << describe(c, r);
            EXPECT_NEAR(k.c, difference(field(&Radial::b), r) / r, 1e-6 * (1 + std::abs(k.c))) << describe(c, r);
        }
    }
}

TEST(Radial, IsFiniteAndDefinedAtTheCentre) {
    for (const Case& c : cases) {
        for (const double r : {0.0, 1e-300, 1e-160, 1e-100, 1e-31, 1e-29}) {
            const Radial k = radial(c.kind, c.radius, r);
            EXPECT_TRUE(std::isfinite(k.phi) && std::isfinite(k.a) && std::isfinite(k.b) && std::isfinite(k.c))
                << describe(c, r);
        }
    }
    const Radial cube = radial(Kind::triharmonic, 0.0, 0.0);
    EXPECT_EQ(cube.phi, 0.0);
    EXPECT_EQ(cube.a, 0.0);
    EXPECT_EQ(cube.b, 0.0);
    EXPECT_EQ(cube.c, 0.0);
    const Radial wendland = radial(Kind::wendland_c2, 2.0, 0.0);
    EXPECT_EQ(wendland.phi, 1.0);
    EXPECT_DOUBLE_EQ(wendland.a, -20.0 / 4.0);
    EXPECT_EQ(wendland.b, 0.0);
    EXPECT_EQ(wendland.c, 0.0);
    const Radial gaussian = radial(Kind::gaussian, 2.0, 0.0); // smooth: no term is dropped
    EXPECT_DOUBLE_EQ(gaussian.a, -1.0 / 4.0);
    EXPECT_DOUBLE_EQ(gaussian.b, 1.0 / 16.0);
    EXPECT_DOUBLE_EQ(gaussian.c, -1.0 / 64.0);
}

TEST(Radial, WendlandVanishesBeyondItsRadius) {
    for (const double r : {2.0, 2.0001, 1e3, 1e100}) {
        const Radial k = radial(Kind::wendland_c2, 2.0, r);
        EXPECT_EQ(k.phi, 0.0) << r;
        EXPECT_EQ(k.a, 0.0) << r;
        EXPECT_EQ(k.b, 0.0) << r;
        EXPECT_EQ(k.c, 0.0) << r;
    }
}

TEST(Radial, FourthIsTheDerivativeOfCOverR) {
    for (const Case& c : cases) {
        for (const double r : {0.3, 0.9, 1.7, 2.5}) {
            const double h = 1e-5;
            const double slope = (radial(c.kind, c.radius, r + h).c - radial(c.kind, c.radius, r - h).c) / (2.0 * h);
            const double fourth = hrbfnpr::kernel::radial_fourth(c.kind, c.radius, r);
            EXPECT_NEAR(fourth, slope / r, 1e-7 * (1.0 + std::abs(fourth))) << describe(c, r);
        }
    }
}

TEST(Radial, ScalesWithItsHomogeneity) {
    for (const Case& c : cases) {
        const double s = 3.5;
        const double factor = std::pow(s, hrbfnpr::kernel::homogeneity(c.kind));
        const double expected = factor * radial(c.kind, c.radius, 1.3).phi;
        EXPECT_NEAR(radial(c.kind, s * c.radius, s * 1.3).phi, expected, 1e-13 * (1 + expected)) << describe(c, 1.3);
    }
}

} // namespace

} // namespace radial_test
