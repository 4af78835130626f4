// SPDX-License-Identifier: MIT
#include "picture/up.h"
#include "support/handles.h"
#include "support/samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace hrbfnpr::picture::up_test {
namespace {

constexpr const char* no_sign = "nothing suggests another direction";

struct UpTest : testing::Test {
    UpTest() : points(&pool), normals(&pool) {}

    void add(const glm::dvec3& point, const glm::dvec3& normal) {
        points.push_back(point);
        normals.push_back(normal);
    }
    // Returns number i of a sequence that fills [0, 1) evenly.
    [[nodiscard]] static double even(int i, double step) { return std::fmod(i * step, 1.0); }

    // Adds samples on an ellipsoid.
    void add_ellipsoid(int count, const glm::dvec3& centre, const glm::dvec3& radii) {
        for (int i = 0; i < count; ++i) {
            const auto p = test::spiral_point(i, count);
            const glm::dvec3 unit(p[0], p[1], p[2]);
            add(centre + radii * unit, glm::normalize(unit / radii));
        }
    }
    // Adds a wavy square whose normals point to `side` along z.
    void add_waves(double side) {
        for (int i = 0; i < 400; ++i) {
            const double x = even(i, 0.7548776662);
            const double y = even(i, 0.5698402910);
            add({x, y, 0.05 * std::sin(6.0 * x) * std::cos(5.0 * y)},
                side * glm::normalize(glm::dvec3(-0.3 * std::cos(6.0 * x) * std::cos(5.0 * y),
                                                 0.25 * std::sin(6.0 * x) * std::sin(5.0 * y), 1.0)));
        }
    }
    // Exchanges y and z of all points and normals.
    void swap_y_and_z() {
        for (Points* list : {&points, &normals})
            for (glm::dvec3& v : *list) std::swap(v.y, v.z);
    }
    [[nodiscard]] FoundUp found(const Shape* shape = nullptr) { return find_up(shape, points, normals, pool); }
    void expect_up(char axis, const char* reason, const Shape* shape = nullptr) {
        const FoundUp up = found(shape);
        EXPECT_EQ(up.direction, axis == 'z' ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0));
        EXPECT_STREQ(up.reason.c_str(), reason);
    }

    base::Memory memory;
    Pool pool{memory};
    Points points;
    Points normals;
};

TEST_F(UpTest, ASphereHasNoUp) {
    add_ellipsoid(500, glm::dvec3(0.0), glm::dvec3(1.0));
    expect_up('y', no_sign);
}

TEST_F(UpTest, UnknownNormalsAreNotLevel) {
    add_ellipsoid(500, glm::dvec3(0.0), glm::dvec3(1.0));
    for (glm::dvec3& normal : normals) normal = glm::dvec3(0.0);
    expect_up('y', no_sign);
}

TEST_F(UpTest, TooFewPointsHaveNoUp) {
    expect_up('y', no_sign);
    add({1.0, 2.0, 3.0}, {0.0, 0.0, 1.0});
    expect_up('y', no_sign);
    add({2.0, 3.0, 3.0}, {0.0, 0.0, 1.0});
    expect_up('y', no_sign);
    EXPECT_EQ(hangs_along(points, normals), 0);
}

TEST_F(UpTest, NonFinitePointsHaveNoUp) {
    for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
        points.clear();
        normals.clear();
        add_waves(1.0);
        points[7].x = bad;
        expect_up('y', no_sign);
    }
    points.clear();
    normals.clear();
    add_ellipsoid(100, glm::dvec3(0.0), {1e308, 1e307, 9e307});
    expect_up('y', no_sign);
}

TEST_F(UpTest, TheFormatTellsUp) {
    Shape shape(pool);
    shape.up = glm::dvec3(0, 0, 1);
    shape.up_by = "PLY files";
    expect_up('z', "as in PLY files", &shape);
    shape.is_photo = true;
    expect_up('z', "as in depth images", &shape);
}

TEST_F(UpTest, MapCoordinatesTellUp) {
    add_ellipsoid(200, {4.0e5, 5.0e6, 100.0}, {300.0, 200.0, 80.0});
    expect_up('z', "x and y are map coordinates");
}

TEST_F(UpTest, TerrainsTellUp) {
    add_waves(1.0);
    expect_up('z', "the surface is a terrain");
    EXPECT_EQ(hangs_along(points, normals), 0);
}

TEST_F(UpTest, TerrainsThatLookDownAreDetected) {
    add_waves(-1.0);
    EXPECT_EQ(hangs_along(points, normals), 'z');
    swap_y_and_z();
    EXPECT_EQ(hangs_along(points, normals), 'y');
}

TEST_F(UpTest, WallsTellUp) {
    for (const double noise : {0.0, 0.1}) {
        for (const double turn : {0.0, 0.6, 1.5707963267948966, 4.71238898038469, 3.141592653589793}) {
            if (noise > 0.0 && turn > 3.0 && turn < 4.0) continue; // Such a wall might be ground with y up.
            points.clear();
            normals.clear();
            const glm::dvec3 along(std::cos(turn), std::sin(turn), 0.0);
            const glm::dvec3 out(along.y, -along.x, 0.0);
            for (int i = 0; i < 500; ++i) { // A wall of 12 x 8 whose piers stand out by a little, with a few sills.
                const double right = 12.0 * even(i, 0.7548776662);
                const double depth = std::fmod(right, 3.0) < 1.0 ? 0.05 : 0.0;
                const glm::dvec3 place = right * along + depth * out + glm::dvec3(0, 0, 8.0 * even(i, 0.5698402910));
                const glm::dvec3 off =
                    noise * (even(i, 0.618) - 0.5) * along + glm::dvec3(0, 0, noise * 2.0 * (even(i, 0.3247) - 0.5));
                add(place, noise > 0.0 && i % 20 == 0 ? glm::dvec3(0, 0, 1) : glm::normalize(out + off));
            }
            expect_up('z', "the surface is an upright wall");
            EXPECT_EQ(hangs_along(points, normals), 0) << turn;
        }
    }
}

TEST_F(UpTest, AFlatBaseTellsUp) {
    for (int i = 0; i < 600; ++i) { // A cone has a quarter of its samples on its base.
        const double angle = 2.399963229728653 * i;
        const double radius = std::sqrt(even(i, 0.618033988749895));
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0);
        if (i % 4 == 0)
            add(radius * out, {0, 0, -1});
        else
            add(radius * out + glm::dvec3(0, 0, 2.0 * (1.0 - radius)), glm::normalize(out + glm::dvec3(0, 0, 0.5)));
    }
    expect_up('z', "its lower end along z is a flat base");
    swap_y_and_z();
    expect_up('y', no_sign);
}

TEST_F(UpTest, SymmetryTellsUp) {
    add_ellipsoid(500, glm::dvec3(0.0), {1.0, 0.5, 0.6}); // A body, a head and two legs are symmetric in y.
    add_ellipsoid(200, {1.2, 0.0, 0.7}, {0.3, 0.25, 0.4});
    for (const double side : {-0.3, 0.3}) add_ellipsoid(150, {0.6, side, -0.8}, {0.15, 0.15, 0.6});
    expect_up('z', "left and right are alike along y");
    swap_y_and_z();
    expect_up('y', no_sign);
}

TEST_F(UpTest, StandingOnZeroTellsUp) {
    add_ellipsoid(300, {0.02, -0.03, 1.0}, {0.7, 0.9, 1.0});
    add_ellipsoid(100, {0.3, 0.45, 1.7}, {0.2, 0.3, 0.3});
    expect_up('z', "it stands on z = 0");
    for (glm::dvec3& p : points) p.z += 0.3;
    EXPECT_EQ(found().direction.y, 1.0);
}

TEST_F(UpTest, FeetTellUp) {
    for (int i = 0; i < 1200; ++i) { // A top on three legs leans to one side.
        const double u = even(i, 0.7548776662);
        const double v = even(i, 0.5698402910);
        const glm::dvec3 any = glm::normalize(glm::dvec3(u - 0.5, v - 0.5, even(i, 0.4301597090) - 0.5));
        if (i % 3 != 0) {
            add({5.0 + 1.3 * u, 0.9 * v, 1.0 + 0.4 * u * v}, any);
        } else {
            const int leg = i / 3 % 3;
            add({leg == 0 ? 5.1 : 6.1, leg == 1 ? 0.1 : 0.8, even(i / 3, 0.618033988749895)}, any);
        }
    }
    EXPECT_EQ(found().direction.z, 1.0);
}

// The dome has no floor. Its hole is below along y.
TEST_F(UpTest, AHoleToStandOnKeepsYUp) {
    constexpr int around = 24;
    constexpr int rows = 6;
    Shape shape(pool);
    for (int row = 0; row <= rows; ++row) {
        for (int i = 0; i < around; ++i) {
            const double angle = 6.283185307179586 * i / around;
            const double height = 1.5 * row / rows;
            const glm::dvec3 out(std::cos(angle) * std::cos(height), std::sin(height),
                                 std::sin(angle) * std::cos(height));
            // A bump at one side of z makes the dome asymmetric along z.
            add(out * glm::dvec3(1.0, 1.5, out.z > 0.3 ? 1.2 : 1.0) + glm::dvec3(0.1, 3.0, 2.0), out);
        }
    }
    shape.points = points;
    for (int row = 0; row < rows; ++row) {
        for (int i = 0; i < around; ++i) {
            const std::int64_t a = row * around + i;
            const std::int64_t b = row * around + (i + 1) % around;
            shape.triangles.push_back({a, a + around, b});
            shape.triangles.push_back({b, a + around, b + around});
        }
    }
    expect_up('y', no_sign, &shape);
}

TEST_F(UpTest, ChoosingUpGivesANote) {
    const test::Context context = [] {
        hrbfnpr_context* made = nullptr;
        test::Check check;
        check(hrbfnpr_context_create(nullptr, &made, check.error()));
        return test::Context(made);
    }();
    add_waves(1.0);
    String told(&pool);
    const auto choose = [&](std::uint32_t flags, double up_x) {
        auto desc = defaults<hrbfnpr_picture_desc>(hrbfnpr_picture_desc_init);
        desc.flags = flags;
        desc.up[0] = up_x;
        const Options options(desc, nullptr, pool);
        Report report(pool, HRBFNPR_WORDING_OPTIONS, nullptr, nullptr, *context, nullptr);
        const glm::dvec3 up = choose_up({*context, options, report, pool}, nullptr, points, normals);
        for (const Note& note : report.notes) {
            EXPECT_EQ(note.code, HRBFNPR_NOTE_UP);
            EXPECT_EQ(note.figures[2], up.z);
            told = note.text;
        }
        return std::pair(up, report.notes.size());
    };
    EXPECT_EQ(choose(0, 0.0), std::pair(glm::dvec3(0, 0, 1), std::size_t{1}));
    EXPECT_STREQ(told.c_str(), "up is z: the surface is a terrain (--up y changes it)");
    EXPECT_EQ(choose(0, 2.0), std::pair(glm::dvec3(2, 0, 0), std::size_t{0}));
    EXPECT_EQ(choose(HRBFNPR_PICTURE_IS_SOLID, 0.0), std::pair(glm::dvec3(0, 1, 0), std::size_t{0}));
    EXPECT_EQ(choose(HRBFNPR_PICTURE_SURFACE_ONLY, 0.0), std::pair(glm::dvec3(0, 0, 1), std::size_t{0}));
}

TEST_F(UpTest, NamesDirections) {
    EXPECT_STREQ(name_of_direction({0, 0, 2}, pool).c_str(), "z");
    EXPECT_STREQ(name_of_direction({-1, 0, 0}, pool).c_str(), "-x");
    EXPECT_STREQ(name_of_direction({0.5, 0, -0.25}, pool).c_str(), "0.5,0,-0.25");
}

} // namespace
} // namespace hrbfnpr::picture::up_test
