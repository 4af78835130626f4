// SPDX-License-Identifier: MIT
// Compares the hierarchy with a search of all triangles one by one.
#include "geometry/bvh.h"

#include "geometry/bvh_build.h"
#include "support/instruction_sets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <functional>
#include <memory>
#include <random>
#include <vector>

namespace hrbfnpr::geometry::bvh_test {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

using Triangle = Bvh::Triangle;
using Corners = std::array<glm::dvec3, 3>;

struct Shape {
    std::vector<glm::dvec3> vertex;
    std::vector<Triangle> triangle;

    [[nodiscard]] Corners corners(std::size_t face) const {
        const auto at = [&](std::size_t k) { return vertex[static_cast<std::size_t>(triangle[face][k])]; };
        return {at(0), at(1), at(2)};
    }
    [[nodiscard]] Shape changed(const std::function<glm::dvec3(const glm::dvec3&)>& f) const {
        Shape shape = *this;
        for (glm::dvec3& v : shape.vertex) v = f(v);
        return shape;
    }
};

class Random {
public:
    double in(double from, double to) { return std::uniform_real_distribution<double>(from, to)(engine_); }
    glm::dvec3 in_cube() { return {in(-1.0, 1.0), in(-1.0, 1.0), in(-1.0, 1.0)}; }
    glm::dvec3 direction() {
        for (;;)
            if (const glm::dvec3 v = in_cube(); glm::length(v) > 0.1 && glm::length(v) < 1.0) return glm::normalize(v);
    }
    std::size_t below(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(engine_); }

private:
    std::mt19937_64 engine_{1};
};

// A closed surface: a sphere whose columns meet in one vertex at each pole.
Shape ball(int rows, double bumps = 0.0) {
    const int columns = 2 * rows;
    Shape shape;
    const auto pi = 3.14159265358979323846;
    shape.vertex.emplace_back(0.0, 0.0, 1.0);
    for (int i = 1; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            const double a = pi * i / rows, b = 2.0 * pi * j / columns;
            shape.vertex.push_back((1.0 + bumps * std::sin(5.0 * a) * std::sin(4.0 * b)) *
                                   glm::dvec3(std::sin(a) * std::cos(b), std::sin(a) * std::sin(b), std::cos(a)));
        }
    shape.vertex.emplace_back(0.0, 0.0, -1.0);
    const int last = static_cast<int>(shape.vertex.size()) - 1;
    const auto at = [&](int i, int j) { return i == 0 ? 0 : i == rows ? last : 1 + (i - 1) * columns + j % columns; };
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < columns; ++j) {
            if (i > 0) shape.triangle.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
            if (i < rows - 1) shape.triangle.push_back({at(i, j + 1), at(i + 1, j), at(i + 1, j + 1)});
        }
    return shape;
}

// A box whose sides are grids of squares, each of two triangles. Rays along an axis meet many edges and vertices.
Shape box(int cells, const glm::dvec3& size) {
    Shape shape;
    for (glm::length_t axis = 0; axis < 3; ++axis)
        for (const int side : {-1, 1}) {
            const auto first = static_cast<std::int32_t>(shape.vertex.size());
            for (int i = 0; i <= cells; ++i)
                for (int j = 0; j <= cells; ++j) {
                    glm::dvec3 v(static_cast<double>(side));
                    v[(axis + 1) % 3] = 2.0 * i / cells - 1.0;
                    v[(axis + 2) % 3] = 2.0 * j / cells - 1.0;
                    shape.vertex.push_back(size * v);
                }
            for (int i = 0; i < cells; ++i)
                for (int j = 0; j < cells; ++j) {
                    const std::int32_t a = first + i * (cells + 1) + j, b = a + cells + 1;
                    for (Triangle t : {Triangle{a, b, b + 1}, Triangle{a, b + 1, a + 1}}) {
                        if (side < 0) std::swap(t[1], t[2]);
                        shape.triangle.push_back(t);
                    }
                }
        }
    return shape;
}

// Triangles of very different sizes. Some have no area, and some occur twice.
Shape soup(int count) {
    Random random;
    Shape shape;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 at = random.in_cube();
        const double size = std::pow(10.0, random.in(-6.0, -0.5));
        for (int k = 0; k < 3; ++k) shape.vertex.push_back(at + size * random.in_cube());
        const std::int32_t a = 3 * i;
        switch (i % 7) {
        case 0: shape.triangle.push_back({a, a, a}); break;
        case 1: shape.triangle.push_back({a, a + 1, a + 1}); break;
        case 2:
            shape.vertex.back() = glm::mix(shape.vertex[static_cast<std::size_t>(a)],
                                           shape.vertex[static_cast<std::size_t>(a) + 1], random.in(0.0, 2.0));
            shape.triangle.push_back({a, a + 1, a + 2});
            break;
        case 3: shape.triangle.push_back({a, a + 1, a + 2}); [[fallthrough]];
        default: shape.triangle.push_back({a, a + 1, a + 2});
        }
    }
    return shape;
}

// Triangles in one plane: all boxes are flat.
Shape flat() {
    Shape shape = soup(300);
    for (glm::dvec3& v : shape.vertex) v.y = 0.25;
    return shape;
}

base::Runtime runtime_of(base::InstructionSet set = base::InstructionSet::automatic, int threads = 2) {
    return {nullptr, nullptr, nullptr, base::Parallel(threads, nullptr, nullptr), set, nullptr, nullptr};
}

// A hierarchy, with the memory that it needs.
struct Built {
    explicit Built(const Shape& shape, base::InstructionSet set = base::InstructionSet::automatic, int threads = 2)
        : runtime(runtime_of(set, threads)), vertex(array(shape.vertex)), triangle(array(shape.triangle)),
          bvh(runtime, vertex, triangle) {}

    template <class T>
    base::Array<T> array(const std::vector<T>& from) {
        base::Array<T> to(runtime.memory);
        for (const T& one : from) to.push_back(one);
        return to;
    }

    base::Runtime runtime;
    base::Array<glm::dvec3> vertex;
    base::Array<Triangle> triangle;
    Bvh bvh;
};

// A hierarchy of one face answers with the exact test of this face.
std::vector<std::unique_ptr<Built>> single_faces(const Shape& shape) {
    std::vector<std::unique_ptr<Built>> faces;
    for (std::size_t face = 0; face < shape.triangle.size(); ++face) {
        const Corners p = shape.corners(face);
        faces.push_back(std::make_unique<Built>(Shape{{p[0], p[1], p[2]}, {Triangle{0, 1, 2}}},
                                                base::InstructionSet::automatic, 1));
    }
    return faces;
}

bool same_bits(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

struct Ray {
    glm::dvec3 origin, direction;
    double t_min = 0.0;
    double t_max = infinite;
};

struct Named {
    const char* name;
    Shape shape;
    double unit; // the size
    glm::dvec3 centre;
};

std::vector<Named> shapes() {
    const glm::dvec3 middle(0.0);
    std::vector<Named> shapes = {{"ball", ball(12, 0.2), 1.0, middle},
                                 {"box", box(6, {1.0, 0.7, 0.4}), 1.0, middle},
                                 {"plate", box(6, {1.0, 1e-7, 0.4}), 1.0, middle},
                                 {"soup", soup(500), 1.0, middle},
                                 {"flat", flat(), 1.0, middle},
                                 {"one face", {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}, 1.0, middle},
                                 {"one place", {{{1, 1, 1}}, {{0, 0, 0}, {0, 0, 0}}}, 1.0, middle}};
    const Shape bumpy = ball(8, 0.2);
    shapes.push_back({"huge", bumpy.changed([](const glm::dvec3& v) { return 1e50 * v; }), 1e50, middle});
    shapes.push_back({"tiny", bumpy.changed([](const glm::dvec3& v) { return 1e-50 * v; }), 1e-50, middle});
    const glm::dvec3 away(1e6, -2e6, 3e5);
    shapes.push_back({"away", bumpy.changed([&](const glm::dvec3& v) { return v + away; }), 1.0, away});
    return shapes;
}

std::vector<Ray> rays(const Named& of, int count) {
    Random random;
    std::vector<Ray> rays;
    const std::vector<glm::dvec3>& vertex = of.shape.vertex;
    for (int i = 0; i < count; ++i) {
        const glm::dvec3 from = of.centre + (i % 5 == 0 ? 1e3 : 1.5) * of.unit * random.in_cube();
        const glm::dvec3& on = vertex[random.below(vertex.size())];
        glm::dvec3 along = random.direction();
        if (i % 4 == 1) along = (on - from) / of.unit; // through a vertex
        if (i % 4 == 2) along = of.unit * (0.5 * (on + vertex[random.below(vertex.size())]) - from);
        const glm::dvec3 axis = {i % 3 == 0 ? 1.0 : 0.0, i % 3 == 1 ? -1.0 : 0.0, i % 3 == 2 ? 1.0 : 0.0};
        if (i % 8 == 3) // through a vertex along an axis
            rays.push_back({on - 2.0 * of.unit * axis, axis, 0.0, infinite});
        else if (i % 8 == 7) // from a vertex
            rays.push_back({on, along, i % 16 == 7 ? 0.0 : 1e-9 * of.unit, infinite});
        else
            rays.push_back({from, along, 0.0, infinite});
        if (i % 6 == 5) rays.back().t_max = random.in(0.0, 3.0) * of.unit / glm::length(rays.back().direction);
    }
    rays.push_back({of.centre, {0.0, 0.0, 0.0}, 0.0, infinite});
    return rays;
}

Bvh::Hit plain_first_hit(const std::vector<std::unique_ptr<Built>>& faces, const Ray& ray) {
    Bvh::Hit first;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        const Bvh::Hit hit = faces[face]->bvh.first_hit(ray.origin, ray.direction, ray.t_min, ray.t_max);
        if (hit.face >= 0 && hit.t < first.t) first = {hit.t, static_cast<std::int64_t>(face)};
    }
    return first;
}

TEST(Bvh, RaysMeetTheFacesThatASearchOfAllFacesFinds) {
    for (const Named& of : shapes()) {
        const auto faces = single_faces(of.shape);
        for (const base::InstructionSet set : test::instruction_sets()) {
            const Built built(of.shape, set);
            int hits = 0, several = 0;
            for (const Ray& ray : rays(of, 400)) {
                const Bvh::Hit plain = plain_first_hit(faces, ray);
                const Bvh::Hit hit = built.bvh.first_hit(ray.origin, ray.direction, ray.t_min, ray.t_max);
                ASSERT_EQ(hit.face, plain.face) << of.name;
                ASSERT_TRUE(same_bits(hit.t, plain.t)) << of.name;
                ASSERT_EQ(built.bvh.any_hit(ray.origin, ray.direction, ray.t_min, ray.t_max), plain.face >= 0);
                std::vector<std::int64_t> met, plain_met;
                built.bvh.crossings(ray.origin, ray.direction,
                                    [&](std::int64_t face, double, int) { met.push_back(face); });
                for (std::size_t face = 0; face < faces.size(); ++face)
                    faces[face]->bvh.crossings(ray.origin, ray.direction, [&](std::int64_t, double, int) {
                        plain_met.push_back(static_cast<std::int64_t>(face));
                    });
                std::sort(met.begin(), met.end());
                ASSERT_EQ(met, plain_met) << of.name;
                hits += hit.face >= 0 ? 1 : 0;
                several += met.size() > 1 ? 1 : 0;
            }
            EXPECT_TRUE(hits > 20 || of.shape.triangle.size() < 3) << of.name << ": it tells little";
            EXPECT_TRUE(several > 10 || of.shape.triangle.size() < 3) << of.name << ": it tells little";
        }
    }
}

TEST(Bvh, FindsTheNearestFaceThatASearchOfAllFacesFinds) {
    for (const Named& of : shapes()) {
        const auto faces = single_faces(of.shape);
        for (const base::InstructionSet set : test::instruction_sets()) {
            const Built built(of.shape, set);
            Random random;
            for (int i = 0; i < 300; ++i) {
                const glm::dvec3& on = of.shape.vertex[random.below(of.shape.vertex.size())];
                const std::array<double, 4> reach = {0.0, 1e-5, 1.0, 1e5};
                const glm::dvec3 p =
                    (i % 8 < 4 ? on : of.centre) + of.unit * reach[static_cast<std::size_t>(i % 4)] * random.in_cube();
                Bvh::Nearest plain;
                for (std::size_t face = 0; face < faces.size(); ++face) {
                    const Bvh::Nearest one = faces[face]->bvh.nearest(p);
                    if (plain.face < 0 || one.squared < plain.squared)
                        plain = {one.squared, static_cast<std::int64_t>(face), one.place};
                }
                const Bvh::Nearest found = built.bvh.nearest(p);
                ASSERT_EQ(found.face, plain.face) << of.name;
                ASSERT_TRUE(same_bits(found.squared, plain.squared)) << of.name;
                ASSERT_EQ(found.place, plain.place) << of.name;
                ASSERT_EQ(built.bvh.nearest(p, found.squared).face, found.face) << of.name;
                if (found.squared > 0.0) {
                    ASSERT_EQ(built.bvh.nearest(p, 0.999 * found.squared).face, -1) << of.name;
                }
            }
        }
    }
}

// Checks the exact test of one face, with which the tests above compare.
TEST(Bvh, MeetsAFaceWhereItsPlaneIsMetInsideAllSides) {
    Random random;
    int hits = 0;
    for (int i = 0; i < 8000; ++i) {
        const Corners p = {random.in_cube(), random.in_cube(), random.in_cube()};
        const Built built({{p[0], p[1], p[2]}, {Triangle{0, 1, 2}}}, base::InstructionSet::automatic, 1);
        const Ray ray = {2.0 * random.in_cube(), random.direction()};
        const glm::dvec3 n = glm::cross(p[1] - p[0], p[2] - p[0]);
        const double t = glm::dot(p[0] - ray.origin, n) / glm::dot(ray.direction, n);
        const glm::dvec3 x = ray.origin + t * ray.direction;
        bool in = t > 0.0;
        double closest = infinite; // the distance from the sides
        for (std::size_t k = 0; k < 3; ++k) {
            const double side = glm::dot(glm::cross(p[(k + 1) % 3] - p[k], x - p[k]), n);
            in = in && side >= 0.0;
            closest = std::min(closest, std::abs(side));
        }
        if (closest < 1e-9) continue;
        const Bvh::Hit hit = built.bvh.first_hit(ray.origin, ray.direction, 0.0, infinite);
        ASSERT_EQ(hit.face, in ? 0 : -1);
        if (!in) continue;
        ++hits;
        ASSERT_NEAR(hit.t, t, 1e-9 * (1.0 + t));
        const int sign = glm::dot(n, ray.direction) > 0.0 ? 1 : -1;
        built.bvh.crossings(ray.origin, ray.direction,
                            [&](std::int64_t, double, int found) { EXPECT_EQ(found, sign); });
        EXPECT_EQ(built.bvh.winding_beyond(ray.origin, ray.origin + 1.001 * t * ray.direction), sign);
        EXPECT_EQ(built.bvh.winding_beyond(ray.origin, ray.origin + 0.999 * t * ray.direction), 0);
        EXPECT_FALSE(built.bvh.any_hit(ray.origin, ray.direction, 0.0, 0.999 * t));
        EXPECT_FALSE(built.bvh.any_hit(ray.origin, ray.direction, 1.001 * t, infinite));
    }
    EXPECT_GT(hits, 50) << "it tells little";
}

// Returns the least distance over a fine grid of points on the face.
double plain_distance(const Corners& p, const glm::dvec3& from) {
    double best = infinite;
    constexpr int cells = 12;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; i + j <= cells; ++j) {
            const double u = static_cast<double>(i) / cells, v = static_cast<double>(j) / cells;
            best = std::min(best, glm::distance(from, p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0])));
        }
    return best;
}

TEST(Bvh, FindsTheNearestPlaceOfAFace) {
    Random random;
    for (int i = 0; i < 500; ++i) {
        const Corners p = {random.in_cube(), random.in_cube(), random.in_cube()};
        const Built built({{p[0], p[1], p[2]}, {Triangle{0, 1, 2}}});
        const glm::dvec3 from = 1.5 * random.in_cube();
        const Bvh::Nearest nearest = built.bvh.nearest(from);
        ASSERT_LE(std::sqrt(nearest.squared), plain_distance(p, from) + 1e-12);
        ASSERT_GE(std::sqrt(nearest.squared), plain_distance(p, from) - 0.12);
        ASSERT_NEAR(glm::distance(from, nearest.place), std::sqrt(nearest.squared), 1e-12);
        ASSERT_LT(plain_distance(p, nearest.place), 0.2);
    }
}

// Rays from inside of a closed surface cannot leave it without a hit. They are aimed at vertices and at places of
// edges, where the tests of two or more faces are within rounding errors of a border.
TEST(Bvh, RaysDoNotPassBetweenFaces) {
    for (const double unit : {1.0, 1e-3, 7e8}) {
        const glm::dvec3 away = unit == 1.0 ? glm::dvec3(0.0) : unit * glm::dvec3(3.1, -2.3, 0.7);
        for (const Shape& plain : {ball(40, 0.05), box(16, {1.0, 0.7, 0.4})}) {
            const Shape shape = plain.changed([&](const glm::dvec3& v) { return unit * v + away; });
            const Built built(shape);
            Random random;
            for (int i = 0; i < 40000; ++i) {
                const glm::dvec3 from = away + unit * (i % 5 == 0 ? glm::dvec3(0.0) : 0.2 * random.in_cube());
                const Corners p = shape.corners(random.below(shape.triangle.size()));
                const std::array<double, 4> shares = {0.0, 0.5, random.in(0.0, 1.0), random.in(0.0, 1e-12)};
                const glm::dvec3 to = glm::mix(p[0], p[1], shares[static_cast<std::size_t>(i % 4)]);
                ASSERT_TRUE(built.bvh.any_hit(from, to - from, 0.0, infinite)) << i;
                ASSERT_GE(built.bvh.first_hit(from, to - from, 0.0, infinite).face, 0) << i;
            }
        }
    }
}

// The winding number of a place is that of another place, plus the faces between the two.
TEST(Bvh, WindingNumbersOfTwoPlacesDifferByTheFacesBetween) {
    Shape shape = ball(10);
    const auto first = static_cast<std::int32_t>(shape.vertex.size());
    const Shape other = ball(10).changed([](const glm::dvec3& v) { return v + glm::dvec3(0.5, 0.2, 0.1); });
    shape.vertex.insert(shape.vertex.end(), other.vertex.begin(), other.vertex.end());
    for (const Triangle& t : other.triangle) shape.triangle.push_back({t[0] + first, t[1] + first, t[2] + first});
    const Built built(shape);
    Random random;
    const auto winding = [&](const glm::dvec3& from) {
        int sum = 0;
        built.bvh.crossings(from, {0.5773, 0.2161, 0.7874}, [&](std::int64_t, double, int sign) { sum += sign; });
        return sum;
    };
    int changes[5] = {};
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 one = 1.5 * random.in_cube(), two = 1.5 * random.in_cube();
        const int there = winding(one), here = winding(two);
        ASSERT_EQ(there, here + built.bvh.winding_beyond(one, two)) << i;
        ++changes[there - here + 2];
    }
    for (const int count : changes) EXPECT_GT(count, 5) << "it tells little";
}

TEST(Bvh, OfNoFacesFindsNothing) {
    const Built built(Shape{});
    EXPECT_EQ(built.bvh.nearest({1.0, 2.0, 3.0}).face, -1);
    EXPECT_EQ(built.bvh.first_hit({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.0, infinite).face, -1);
    EXPECT_FALSE(built.bvh.any_hit({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}, 0.0, infinite));
    EXPECT_EQ(built.bvh.winding_beyond({0.0, 0.0, 0.0}, {1.0, 0.0, 0.0}), 0);
}

// The boxes of the triangles of a shape in the cube from -1 to 1.
std::vector<BvhItem> items_of(const Shape& shape) {
    std::vector<BvhItem> items;
    for (std::size_t face = 0; face < shape.triangle.size(); ++face) {
        const Corners p = shape.corners(face);
        const glm::vec3 low = glm::min(glm::min(p[0], p[1]), p[2]), high = glm::max(glm::max(p[0], p[1]), p[2]);
        items.push_back({{low.x, low.y, low.z, 0.0F}, {high.x, high.y, high.z, 0.0F}, static_cast<std::int32_t>(face)});
    }
    return items;
}

struct Boxes {
    explicit Boxes(const std::vector<BvhItem>& items, int threads)
        : runtime(runtime_of(base::InstructionSet::automatic, threads)), item(runtime.memory), boxes(runtime.memory) {
        for (const BvhItem& one : items) item.push_back(one);
        boxes = build_bvh(runtime, item);
    }

    base::Runtime runtime;
    base::Array<BvhItem> item;
    BvhBoxes boxes;
};

// Checks that all boxes hold their items, and counts the items. Returns the number of levels.
int check(const Boxes& built, std::uint32_t child, const glm::vec3& low, const glm::vec3& high, std::int64_t& items) {
    if ((child & bvh_leaf) != 0) {
        const BvhLeaf& leaf = built.boxes.leaf[child & ~bvh_leaf];
        for (std::int32_t i = leaf.first; i < leaf.first + leaf.count; ++i)
            for (int k = 0; k < 3; ++k) {
                EXPECT_LT(low[k], built.item[i].low[k]);
                EXPECT_GT(high[k], built.item[i].high[k]);
            }
        items += leaf.count;
        return 0;
    }
    const BvhNode& node = built.boxes.node[child];
    int levels = 0;
    for (std::size_t i = 0; i < bvh_width; ++i) {
        const auto corner = [&](std::size_t row) {
            return glm::vec3(node.side[row][i], node.side[row + 1][i], node.side[row + 2][i]);
        };
        if (corner(0).x == bvh_nowhere) continue;
        EXPECT_TRUE(glm::all(glm::lessThanEqual(low, corner(0))) && glm::all(glm::greaterThanEqual(high, corner(3))));
        levels = std::max(levels, 1 + check(built, node.child[i], corner(0), corner(3), items));
    }
    return levels;
}

TEST(Bvh, HasBoxesAroundAllItemsForAnyNumberOfThreads) {
    // Sizes that fall quickly: most planes divide off only a few items.
    Shape falling = soup(20);
    for (int i = 0; i < 60000; ++i) {
        const double size = std::pow(0.97, i % 3000);
        const auto a = static_cast<std::int32_t>(falling.vertex.size());
        for (int k = 0; k < 3; ++k)
            falling.vertex.push_back(size * glm::dvec3(1.0, k == 1 ? 0.9 : 1.0, k == 2 ? 0.9 : 1.0));
        falling.triangle.push_back({a, a + 1, a + 2});
    }
    for (const Shape& shape : {ball(140, 0.1), falling, ball(30), soup(9)}) {
        const std::vector<BvhItem> items = items_of(shape);
        const Boxes one(items, 1);
        std::int64_t found = 0;
        EXPECT_LE(check(one, one.boxes.root, glm::vec3(-2.0F), glm::vec3(2.0F), found), bvh_levels);
        EXPECT_EQ(found, static_cast<std::int64_t>(items.size()));
        for (const int threads : {2, 3, 8}) {
            const Boxes several(items, threads);
            ASSERT_EQ(several.boxes.root, one.boxes.root);
            ASSERT_EQ(several.boxes.node.size(), one.boxes.node.size());
            ASSERT_EQ(several.boxes.leaf.size(), one.boxes.leaf.size());
            for (std::int64_t i = 0; i < one.boxes.node.size(); ++i) {
                const BvhNode &a = one.boxes.node[i], &b = several.boxes.node[i];
                ASSERT_EQ(std::memcmp(a.side, b.side, sizeof a.side), 0);
                ASSERT_EQ(std::memcmp(a.child, b.child, sizeof a.child), 0);
            }
            for (std::int64_t i = 0; i < one.item.size(); ++i) ASSERT_EQ(several.item[i].face, one.item[i].face);
        }
    }
}

} // namespace
} // namespace hrbfnpr::geometry::bvh_test
