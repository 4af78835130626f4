// SPDX-License-Identifier: MIT
#include "curves/sheet_count.h"

#include "base/random.h"
#include "dense_count.h"
#include "shapes.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

namespace hrbfnpr::curves::sheet_count_test {
namespace {

using namespace test;
using namespace test_shapes;

struct Segments {
    explicit Segments(base::Memory& memory) : from(memory), to(memory), clear(memory) {}
    void add(const glm::dvec3& a, const glm::dvec3& b, double c = 0.0) {
        from.push_back(a);
        to.push_back(b);
        clear.push_back(c);
    }
    [[nodiscard]] std::int64_t size() const { return from.size(); }

    geometry::VecArray from, to;
    base::Array<double> clear;
};

glm::dvec3 random(std::int64_t i, std::uint32_t draw) {
    const auto u = base::uniform4(7, static_cast<std::uint64_t>(i), base::Purpose::probe, draw);
    return 2.0 * glm::dvec3(u[0], u[1], u[2]) - 1.0;
}

struct Counted {
    std::int64_t wrong = 0;     // wrong, but reported as certain
    std::int64_t uncertain = 0; // uncertain answers, right or wrong
    std::int64_t sheets = 0;
};

// Compares all segments with a reference of many samples.
Counted compare(const base::Runtime& runtime, const implicit::Implicit& implicit, const SurfaceMesh& mesh,
                const Segments& segments, int samples) {
    const SheetCounter counter(runtime, mesh);
    base::Array<SheetCounter::Result> answer(runtime.memory);
    counter.count(runtime, implicit, segments.from, segments.to, segments.clear, answer);
    Counted counted;
    for (std::int64_t i = 0; i < segments.size(); ++i) {
        glm::dvec3 from = segments.from[i];
        glm::dvec3 to = segments.to[i];
        to += glm::normalize(from - to) * segments.clear[i];
        const bool meets = test_dense::clip(mesh.region, from, to);
        const int reference = meets ? test_dense::roots({implicit, from, to}, samples) : 0;
        counted.sheets += reference;
        if (!answer[i].certain) ++counted.uncertain;
        if (answer[i].certain && answer[i].sheets != reference) ++counted.wrong;
    }
    return counted;
}

struct Shape {
    const char* name;
    std::function<std::unique_ptr<implicit::Implicit>()> make;
    std::vector<glm::dvec3> seed;
    double side;
};

void PrintTo(const Shape& shape, std::ostream* out) { *out << shape.name; }

std::unique_ptr<implicit::Implicit> any(const geometry::Bounds& bounds, std::function<Field(const glm::dvec3&)> f) {
    return std::make_unique<AnyField>(bounds, std::move(f));
}

class Sheets : public testing::TestWithParam<Shape> {
protected:
    Sheets() : implicit(GetParam().make()), mesh(runtime.memory) {
        geometry::VecArray seed(runtime.memory);
        for (const glm::dvec3& place : GetParam().seed) seed.push_back(place);
        mesh = triangulate(runtime, *implicit, seed, settings(*implicit, GetParam().side));
    }

    base::Runtime runtime = with_threads(2);
    std::unique_ptr<implicit::Implicit> implicit;
    SurfaceMesh mesh;
};

// The segments begin near and far, in all directions, and end anywhere in the box.
TEST_P(Sheets, CountsMatchTheReferenceForRandomSegments) {
    Segments segments(runtime.memory);
    const geometry::Bounds& box = implicit->bounds();
    for (std::int64_t i = 0; i < 3000; ++i) {
        const double distance = i % 3 == 0 ? 1.0 : (i % 3 == 1 ? 3.0 : 1000.0);
        segments.add(box.centre() + distance * random(i, 0) * box.size(),
                     box.centre() + 0.5 * random(i, 1) * box.size());
    }
    const Counted counted = compare(runtime, *implicit, mesh, segments, 3000);
    EXPECT_EQ(counted.wrong, 0);
    EXPECT_LE(counted.uncertain, 40);
    EXPECT_GT(counted.sheets, 500);
}

// At their end the segments are tangent to the surface, as the lines of sight to a contour are.
TEST_P(Sheets, CountsMatchTheReferenceForContours) {
    Segments segments(runtime.memory);
    const double clear = 2e-3 * implicit->diagonal();
    for (std::int64_t i = 0; i < 2000; ++i) {
        const std::int64_t vertex = i * 7919 % mesh.vertices();
        const glm::dvec3 along = glm::normalize(glm::cross(mesh.gradient[vertex], random(i, 2)));
        const double distance = (i % 2 == 0 ? 2.0 : 0.3) * implicit->diagonal();
        segments.add(mesh.position[vertex] + distance * along, mesh.position[vertex], clear);
    }
    const Counted counted = compare(runtime, *implicit, mesh, segments, 6000);
    EXPECT_EQ(counted.wrong, 0);
    EXPECT_LE(counted.uncertain, 40);
}

// The segments end on the surface and cross it there, and nothing is left out at the end: this tells whether the end is
// visible.
TEST_P(Sheets, AreNotCountedAtTheEndItself) {
    Segments open(runtime.memory);
    Segments clear(runtime.memory);
    for (std::int64_t i = 0; i < 1000; ++i) {
        const std::int64_t vertex = i * 7919 % mesh.vertices();
        const glm::dvec3 way = random(i, 3);
        if (std::abs(glm::dot(glm::normalize(way), glm::normalize(mesh.gradient[vertex]))) < 0.2) continue;
        const glm::dvec3 from = mesh.position[vertex] + 3.0 * implicit->diagonal() * way;
        open.add(from, mesh.position[vertex]);
        clear.add(from, mesh.position[vertex], 1e-6 * implicit->diagonal());
    }
    const SheetCounter counter(runtime, mesh);
    base::Array<SheetCounter::Result> a(runtime.memory);
    base::Array<SheetCounter::Result> b(runtime.memory);
    counter.count(runtime, *implicit, open.from, open.to, open.clear, a);
    counter.count(runtime, *implicit, clear.from, clear.to, clear.clear, b);
    for (std::int64_t i = 0; i < a.size(); ++i) {
        if (!a[i].certain || !b[i].certain) continue;
        ASSERT_EQ(a[i].sheets, b[i].sheets) << i;
    }
    const Counted counted = compare(runtime, *implicit, mesh, clear, 3000);
    EXPECT_EQ(counted.wrong, 0);
    EXPECT_LE(counted.uncertain, 20);
}

INSTANTIATE_TEST_SUITE_P(
    Shapes, Sheets,
    testing::Values(Shape{"sphere", [] { return std::make_unique<Sphere>(); }, {{0, 0, 1}}, 0.1},
                    Shape{"ellipsoid",
                          [] {
                              return any({{-1, -.6, -.35}, {1, .6, .35}}, ellipsoid);
                          },
                          {{1, 0, 0}},
                          0.05},
                    Shape{"torus", [] { return std::make_unique<Torus>(); }, {{1.35, 0, 0}}, 0.08},
                    Shape{"two_holes", [] { return any(cube(1.2), two_holes); }, {{0, 0, 0.2}}, 0.04},
                    Shape{
                        "two_spheres", [] { return any(cube(1.2), two_spheres); }, {{-.6, .6, 0}, {.6, .1, .1}}, 0.06},
                    Shape{"shell", [] { return any(cube(1.1), Shell{0.09}); }, {{0, 0, 1}, {0, .91, 0}}, 0.05}),
    [](const testing::TestParamInfo<Shape>& shape) { return std::string(shape.param.name); });

class SheetCount : public testing::Test {
protected:
    void make(const implicit::Implicit& implicit, const glm::dvec3& seed, double side) {
        mesh = triangulate(runtime, implicit, seeds(runtime, {seed}), settings(implicit, side));
    }
    [[nodiscard]] SheetCounter::Result count(const implicit::Implicit& implicit, const glm::dvec3& from,
                                             const glm::dvec3& to, double clear = 0.0) {
        Segments one(runtime.memory);
        one.add(from, to, clear);
        SheetCounter(runtime, mesh).count(runtime, implicit, one.from, one.to, one.clear, answer);
        return answer[0];
    }

    base::Runtime runtime = with_threads(2);
    SurfaceMesh mesh{runtime.memory};
    base::Array<SheetCounter::Result> answer{runtime.memory};
};

TEST_F(SheetCount, IsRightForSimpleSegments) {
    const Sphere sphere;
    make(sphere, {0, 0, 1}, 0.1);
    EXPECT_EQ(count(sphere, {3, 0.1, 0.2}, {-3, 0.2, 0.1}).sheets, 2);
    EXPECT_EQ(count(sphere, {3, 0.1, 0.2}, {0.2, 0.2, 0.1}).sheets, 1);
    EXPECT_EQ(count(sphere, {0.2, 0.2, 0.1}, {3, 0.1, 0.2}).sheets, 1);
    EXPECT_EQ(count(sphere, {0.2, 0.2, 0.1}, {-0.3, 0.1, 0.2}).sheets, 0);
    EXPECT_EQ(count(sphere, {3, 3, 3}, {3, 3, -3}).sheets, 0);
    EXPECT_EQ(count(sphere, {3, 0.1, 0.2}, {-3, 0.2, 0.1}, 2.5).sheets, 1); // the farther one is left out
    EXPECT_EQ(count(sphere, {3, 0.1, 0.2}, {-3, 0.2, 0.1}, 9.0).sheets, 0);
    for (const SheetCounter::Result& each : answer) EXPECT_TRUE(each.certain);
}

// The segments go through corners of triangles.
TEST_F(SheetCount, IsRightThroughCornersOfTriangles) {
    const Sphere sphere;
    make(sphere, {0, 0, 1}, 0.1);
    Segments segments(runtime.memory);
    for (std::int64_t i = 0; i < mesh.vertices(); ++i)
        segments.add(3.0 * mesh.position[i], -3.0 * mesh.position[i] + glm::dvec3(1e-13 * static_cast<double>(i % 3)));
    SheetCounter(runtime, mesh).count(runtime, sphere, segments.from, segments.to, segments.clear, answer);
    for (const SheetCounter::Result& each : answer) {
        ASSERT_EQ(each.sheets, 2);
        ASSERT_TRUE(each.certain);
    }
}

TEST_F(SheetCount, IsZeroForEmptyOrInvalidInput) {
    const Sphere sphere;
    EXPECT_EQ(count(sphere, {3, 0, 0}, {-3, 0, 0}).sheets, 0); // an empty mesh
    make(sphere, {0, 0, 1}, 0.1);
    EXPECT_EQ(count(sphere, {1, 0, 0}, {1, 0, 0}).sheets, 0); // no length
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(count(sphere, {nan, 0, 0}, {-3, 0, 0}).sheets, 0);
    geometry::VecArray none(runtime.memory);
    SheetCounter(runtime, mesh).count(runtime, sphere, none, none, base::Array<double>(runtime.memory), answer);
    EXPECT_TRUE(answer.empty());
}

// The lines pass a sphere ever more closely. A line outside meets no sheet, a line through it two, and in between the
// answer is uncertain.
TEST_F(SheetCount, ATangentSegmentIsUncertain) {
    const Sphere sphere;
    make(sphere, {0, 0, 1}, 0.1);
    const glm::dvec3 out = glm::normalize(glm::dvec3(0.3, 0.5, 0.7));
    const glm::dvec3 along = glm::normalize(glm::cross(out, {1, 0, 0}));
    const auto beside = [&](double height) {
        return count(sphere, height * out + 2.0 * along, height * out - 2.0 * along);
    };
    EXPECT_FALSE(beside(1.0 + 1e-10).certain);
    EXPECT_FALSE(beside(1.0 - 1e-10).certain);
    for (const double off : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
        EXPECT_EQ(beside(1.0 + off).sheets, 0) << off;
        EXPECT_TRUE(beside(1.0 + off).certain) << off;
        EXPECT_EQ(beside(1.0 - off).sheets, 2) << off; // certain only where triangles are met as well
    }
    EXPECT_TRUE(beside(1.0 - 1e-2).certain);
}

TEST_F(SheetCount, NaNIsUncertain) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Sphere sphere;
    make(sphere, {0, 0, 1}, 0.1);
    const AnyField half(cube(1.0), [&](const glm::dvec3& p) {
        const double r = glm::length(p);
        return p.x < 0.0 ? Field{nan, glm::dvec3(nan), {}} : Field{r - 1.0, p / r, {}};
    });
    EXPECT_FALSE(count(half, {3, 0.1, 0.2}, {-3, 0.2, 0.1}).certain);
    EXPECT_TRUE(count(half, {0.2, 0.1, 3}, {0.2, 0.2, -3}).certain);
}

// Three roots lie between two of the first sample points, where f has different signs. The mesh does not show them.
TEST_F(SheetCount, FindsSeveralRootsNearEachOther) {
    const AnyField wave(cube(0.5), [](const glm::dvec3& p) {
        constexpr double root = 0.012;
        return Field{
            p.z - 1000.0 * p.x * (p.x * p.x - root * root), {-1000.0 * (3.0 * p.x * p.x - root * root), 0.0, 1.0}, {}};
    });
    make(Plane({0, 0, 1}, -0.001, cube(0.5)), {0, 0, -0.001}, 0.1);
    for (int k = 0; k < 20; ++k) {
        const double y = 0.02 * k;
        EXPECT_EQ(count(wave, {-0.3 + 0.001 * k, y, 0}, {0.2, y, 0}).sheets, 3) << k;
    }
}

// The mesh of one function is used with the values of others.
TEST_F(SheetCount, IsCertainOnlyIfMeshAndFunctionAgree) {
    const Sphere sphere;
    make(sphere, {0, 0, 1}, 0.1);
    const auto shifted = [](double by) {
        return AnyField(cube(1.0), [by](const glm::dvec3& p) {
            const double off = glm::length(p) - 1.0;
            return Field{off * off + by, 2.0 * off * p / glm::length(p), {}};
        });
    };
    EXPECT_TRUE(count(sphere, {3, 0.1, 0.2}, {-3, 0.2, 0.1}).certain);
    EXPECT_EQ(count(shifted(1e-6), {3, 0.1, 0.2}, {-3, 0.2, 0.1}).sheets, 0);
    EXPECT_FALSE(count(shifted(1e-6), {3, 0.1, 0.2}, {-3, 0.2, 0.1}).certain);
    EXPECT_EQ(count(shifted(-1e-6), {3, 0.1, 0.2}, {-3, 0.2, 0.1}).sheets, 4);
    EXPECT_FALSE(count(shifted(-1e-6), {3, 0.1, 0.2}, {-3, 0.2, 0.1}).certain);
}

// A part without a seed is not counted, but is noticed where it lies between two sheets.
TEST_F(SheetCount, LeavesOutPartsWithoutMesh) {
    const AnyField both(cube(1.2), two_spheres);
    make(both, {-.6, .6, 0}, 0.06);
    EXPECT_EQ(count(both, {-.6, .1, 3}, {-.6, .1, -3}).sheets, 2);
    EXPECT_EQ(count(both, {.6, -.2, 3}, {.6, -.2, -3}).sheets, 0);
}

// The answer for a segment does not depend on the other segments, and all answers together need few evaluations.
TEST_F(SheetCount, NeedsFewEvaluations) {
    const Sphere sphere;
    make(sphere, {0, 0, 1}, 0.05);
    Segments segments(runtime.memory);
    for (std::int64_t i = 0; i < 1000; ++i) segments.add(3.0 * random(i, 0), random(i, 1));
    const SheetCounter counter(runtime, mesh);
    const std::int64_t before = sphere.evaluations;
    counter.count(runtime, sphere, segments.from, segments.to, segments.clear, answer);
    std::int64_t sheets = 0;
    for (const SheetCounter::Result& each : answer) sheets += each.sheets;
    EXPECT_LT(sphere.evaluations - before, 3 * sheets);
    const SheetCounter::Result some = answer[123];
    EXPECT_EQ(count(sphere, segments.from[123], segments.to[123]).sheets, some.sheets);
}

} // namespace
} // namespace hrbfnpr::curves::sheet_count_test
