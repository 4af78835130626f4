// SPDX-License-Identifier: MIT
// Compares the tree with a search of all faces one by one.
#include "mesh/face_tree.h"

#include "meshes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace face_tree_test {

namespace mesh = hrbfnpr::mesh;
using hrbfnpr::test::icosphere;
using hrbfnpr::test::torus;
using namespace mesh_test;

namespace {

const hrbfnpr::base::Runtime& runtime() {
    static const hrbfnpr::base::Runtime instance;
    return instance;
}

glm::dvec3 place(int i) {
    return 1.4 * glm::dvec3{std::sin(12.9898 * i), std::sin(78.233 * i + 1.0), std::sin(37.719 * i + 2.0)};
}

// Returns the least distance over a fine grid of points on the face.
double plain_distance(const std::array<glm::dvec3, 3>& p, const glm::dvec3& from) {
    double best = HUGE_VAL;
    constexpr int cells = 12;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; i + j <= cells; ++j) {
            const double u = static_cast<double>(i) / cells, v = static_cast<double>(j) / cells;
            best = std::min(best, glm::distance(from, p[0] + u * (p[1] - p[0]) + v * (p[2] - p[0])));
        }
    return best;
}

TEST(FaceTree, FindsTheNearestPlace) {
    const mesh::Mesh ring = made(runtime(), torus(24, 10, 0.3));
    const mesh::FaceTree tree(runtime(), ring.vertex, ring.triangle);
    for (int i = 0; i < 200; ++i) {
        const glm::dvec3 p = place(i);
        const auto nearest = tree.nearest(p);
        double plain = HUGE_VAL;
        for (std::int64_t face = 0; face < ring.faces(); ++face)
            plain = std::min(plain, plain_distance(ring.corners(face), p));
        const double found = std::sqrt(nearest.squared);
        ASSERT_LE(found, plain + 1e-12) << i;
        ASSERT_GE(found, plain - 0.03) << i;
        ASSERT_NEAR(glm::distance(p, nearest.place), found, 1e-12);
        const glm::dvec3 shares = mesh::shares_of(ring.corners(nearest.face), nearest.place);
        ASSERT_GE(std::min({shares.x, shares.y, shares.z}), -1e-9);
        const auto c = ring.corners(nearest.face);
        ASSERT_NEAR(glm::distance(shares.x * c[0] + shares.y * c[1] + shares.z * c[2], nearest.place), 0.0, 1e-12);
        EXPECT_EQ(tree.nearest(p, 0.5 * nearest.squared).face, -1);
    }
}

TEST(FaceTree, KnowsTheDistanceFromASphere) {
    const mesh::Mesh sphere = made(runtime(), icosphere(5));
    const mesh::FaceTree tree(runtime(), sphere.vertex, sphere.triangle);
    for (int i = 0; i < 500; ++i)
        ASSERT_NEAR(tree.distance(place(i)), std::abs(glm::length(place(i)) - 1.0), 1.5e-3) << i;
}

TEST(FaceTree, RayHitsMatchABruteForceSearch) {
    const mesh::Mesh ring = made(runtime(), torus(24, 10, 0.3));
    const mesh::FaceTree tree(runtime(), ring.vertex, ring.triangle);
    int several = 0;
    for (int i = 0; i < 1000; ++i) {
        const glm::dvec3 from = place(i);
        const glm::dvec3 along = place(i + 1000);
        double first = HUGE_VAL;
        int met = 0, sum = 0;
        for (std::int64_t face = 0; face < ring.faces(); ++face) {
            // The ray has to meet the face's plane ahead, inside all three sides.
            const auto p = ring.corners(face);
            const glm::dvec3 n = mesh::doubled_area(p);
            const double t = glm::dot(p[0] - from, n) / glm::dot(along, n);
            const glm::dvec3 x = from + t * along;
            bool in = t > 0.0;
            for (std::size_t k = 0; k < 3; ++k)
                in = in && glm::dot(glm::cross(p[(k + 1) % 3] - p[k], x - p[k]), n) >= 0.0;
            if (!in) continue;
            ++met;
            sum += glm::dot(n, along) > 0.0 ? 1 : -1;
            first = std::min(first, t);
        }
        const auto hit = tree.first_hit(from, along, 0.0, HUGE_VAL);
        ASSERT_EQ(hit.face >= 0, met > 0) << i;
        if (met > 0) {
            ASSERT_NEAR(hit.t, first, 1e-9);
        }
        int visited = 0, signs = 0;
        tree.crossings(from, along, [&](std::int64_t, double, int sign) {
            ++visited;
            signs += sign;
        });
        ASSERT_EQ(visited, met) << i;
        ASSERT_EQ(signs, sum) << i;
        several += met > 1 ? 1 : 0;
    }
    EXPECT_GT(several, 30) << "it tells little";
}

// The winding number of a place is that of another place, plus the faces between the two.
TEST(FaceTree, WindingNumbersOfTwoPlacesDifferByTheFacesBetween) {
    const mesh::Mesh ring =
        made(runtime(), torus(24, 10, 0.3).with(torus(24, 10, 0.3).moved(1.0, 0.5, 0.2, 0.1)), mesh::Parts::all);
    const mesh::FaceTree tree(runtime(), ring.vertex, ring.triangle);
    const auto winding = [&](const glm::dvec3& from) {
        int sum = 0;
        tree.crossings(from, mesh::ray_directions[0], [&](std::int64_t, double, int sign) { sum += sign; });
        return sum;
    };
    int changes[5] = {};
    for (int i = 0; i < 2000; ++i) {
        const glm::dvec3 one = place(i), other = place(i + 5000);
        const int there = winding(one), here = winding(other);
        ASSERT_EQ(there, here + tree.winding_beyond(one, other)) << i;
        ++changes[there - here + 2];
    }
    for (const int count : changes) EXPECT_GT(count, 5) << "it tells little";
}

} // namespace

} // namespace face_tree_test
