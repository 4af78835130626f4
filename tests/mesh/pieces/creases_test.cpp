// SPDX-License-Identifier: MIT
#include "mesh/pieces/creases.h"

#include "mesh/meshes.h"
#include "mesh/pieces/has_creases.h"
#include "support/runtime.h"
#include "support/sharp_meshes.h"
#include "support/verdict_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace creases_test {

namespace mesh = hrbfnpr::mesh;
namespace test = hrbfnpr::test;
namespace verdict = hrbfnpr::test::verdict;
using hrbfnpr::test::Triangles;

namespace {

struct Found {
    explicit Found(const Triangles& from, double angle = 30.0, mesh::Parts parts = mesh::Parts::all)
        : runtime(test::with_threads(2)), shape(mesh_test::made(runtime, from, parts)),
          creases(mesh::find_creases(runtime, shape, {angle, 0.008 * shape.bounds.diagonal()})),
          evidence(mesh::look_for_creases(runtime, shape, angle)) {}

    hrbfnpr::base::Runtime runtime;
    mesh::Mesh shape;
    mesh::Creases creases;
    mesh::CreaseEvidence evidence;
};

TEST(Creases, CutABoxIntoItsSides) {
    const Found box(test::box(1.0, 2.0, 3.0, 4));
    EXPECT_EQ(box.creases.patches, 6);
    EXPECT_NEAR(box.creases.length, 4.0 * (1.0 + 2.0 + 3.0), 1e-9);
    EXPECT_EQ(box.creases.fading, 0.0);
    EXPECT_EQ(box.creases.edge.size(), 48);
    EXPECT_TRUE(box.evidence.creases);
    for (std::int64_t face = 0; face < box.shape.faces(); ++face) {
        const glm::dvec3 n = glm::normalize(mesh::doubled_area(box.shape.corners(face)));
        for (std::int64_t other = 0; other < box.shape.faces(); ++other) {
            const bool alike = glm::dot(n, glm::normalize(mesh::doubled_area(box.shape.corners(other)))) > 0.5;
            EXPECT_EQ(box.creases.patch[face] == box.creases.patch[other], alike);
        }
    }
}

TEST(Creases, AreDetectedPerPart) {
    const Found both(test::icosphere(1).with(test::box(1.0, 1.0, 1.0, 2).moved(1.0, 0.4, -0.5, -0.5)), 15.0);
    EXPECT_TRUE(both.evidence.creases);
    const mesh::CreaseEvidenceOfParts found = mesh::look_for_creases_of_parts(both.runtime, both.shape, 15.0);
    ASSERT_EQ(found.part.size(), 2);
    EXPECT_FALSE(found.part[0].creases);
    EXPECT_TRUE(found.part[1].creases);
    EXPECT_NEAR(found.part[1].length, 12.0 / std::sqrt(3.0), 1e-9);
    hrbfnpr::base::Array<mesh::Sharpness> sharpness(both.runtime.memory);
    sharpness.push_back({180.0, 1.0});
    sharpness.push_back({15.0, 1.0});
    EXPECT_EQ(mesh::find_creases(both.runtime, both.shape, sharpness, found.sharp).patches, 7);
}

TEST(Creases, MatchTheStepsOfTurnedShapes) {
    EXPECT_EQ(Found(test::stepped_shaft(96)).creases.patches, 11);
    EXPECT_EQ(Found(test::drilled_cube(0.5, 96)).creases.patches, 7);
    EXPECT_EQ(Found(test::gear(16, 2)).creases.patches, 16 * 4 + 3);
    EXPECT_EQ(Found(test::box(1.0, 1.0, 0.004, 3).with(test::box(1.0, 1.0, 1.0, 3).moved(1.0, 3.0, 0.0, 0.0)))
                  .creases.patches,
              12);
}

// A prism of twelve sides in single precision. Its sides meet at 30 degrees, give or take the rounding.
Triangles twelve_sides(double height, double turn) {
    constexpr std::int32_t sides = 12;
    Triangles prism;
    for (const double z : {0.0, height})
        for (std::int32_t i = 0; i < sides; ++i) {
            const double around = turn + 2.0 * std::numbers::pi * i / sides;
            static_cast<void>(prism.add(static_cast<float>(std::cos(around)), static_cast<float>(std::sin(around)), z));
        }
    const std::int32_t low = prism.add(0.0, 0.0, 0.0), high = prism.add(0.0, 0.0, height);
    for (std::int32_t a = 0; a < sides; ++a) {
        const std::int32_t b = (a + 1) % sides;
        prism.face(a, b, sides + b);
        prism.face(a, sides + b, sides + a);
        prism.face(b, a, low);
        prism.face(sides + a, sides + b, high);
    }
    return prism;
}

TEST(Creases, TreatAllSidesOfAPrismAlike) {
    for (const double turn : {0.0, 0.1, 0.3, 0.7}) {
        EXPECT_EQ(Found(twelve_sides(8.0, turn)).creases.patches, 3) << turn;
        EXPECT_EQ(Found(twelve_sides(2.0, turn)).creases.patches, 14)
            << turn; // so coarse that its edges count as creases
    }
}

// Moves every coordinate by up to `off`.
Triangles roughened(Triangles shape, double off) {
    for (std::size_t i = 0; i < shape.vertices.size(); ++i)
        shape.vertices[i] += off * std::sin(1e4 * static_cast<double>(i));
    return shape;
}

TEST(Creases, AreAbsentOnRoundOrRoughMeshes) {
    for (const Triangles& round : {test::icosphere(2), test::torus(60, 30, 0.4), test::wound_ring(200, 40)}) {
        const Found found(round);
        EXPECT_FALSE(found.evidence.creases);
        EXPECT_EQ(found.creases.patches, 1);
    }
    const Found found(roughened(test::icosphere(4), 0.025));
    EXPECT_GT(found.evidence.length, 1.0);
    EXPECT_FALSE(found.evidence.creases);
    // A coarse ball: 80 faces that meet at 20 to 40 degrees.
    EXPECT_FALSE(Found(test::icosphere(1), 20.0).evidence.creases);
}

// A cage has no creases at any level of subdivision and for any choice of the quads' diagonals. On the last one, single
// edges bend by more than the angle.
TEST(Creases, AreAbsentOnSubdividedCages) {
    const std::vector<verdict::Quads> cages{verdict::cage(verdict::solid_of(verdict::animal()), 15, 2, 0.08, 1),
                                            verdict::cage(verdict::solid_of(verdict::person()), 14, 2, 0.05, 4),
                                            verdict::blob(10)};
    for (const verdict::Quads& cage : cages)
        for (int rounds = 0; rounds < (cage.face.size() > 1000 ? 3 : 4); ++rounds) {
            const verdict::Quads shape = verdict::subdivided(cage, rounds);
            for (const verdict::Cut how : {verdict::Cut::first, verdict::Cut::second, verdict::Cut::random}) {
                hrbfnpr::base::Runtime runtime = test::with_threads(2);
                const mesh::Mesh made = mesh_test::made(runtime, verdict::cut(shape, how));
                const mesh::CreaseEvidence found = mesh::look_for_creases(runtime, made, 30.0);
                EXPECT_FALSE(found.creases) << rounds << ' ' << found.standing << ' ' << found.coarse;
            }
        }
}

// The edges of folds bend by any angle, but the mesh turns beside them, too.
TEST(Creases, AreAbsentInFolds) {
    for (const Triangles& folded : {verdict::folded(5, 0.25, 0.25, 7.0), verdict::folded(5, 0.15, 0.8, 4.0),
                                    verdict::folded(5, 0.25, 0.8, 3.0)}) {
        const Found found(folded);
        EXPECT_GT(found.evidence.length, 1.0);
        EXPECT_LT(found.evidence.standing, 0.3);
        EXPECT_FALSE(found.evidence.creases);
    }
}

// Flat faces stand out beside narrow fillets, which stay round.
TEST(Creases, StandOutNextToNarrowFillets) {
    for (const int segments : {2, 3, 5, 8})
        for (const int finer : {0, 2}) {
            const Triangles prism = verdict::prism(verdict::rounded(verdict::rectangle(1.0, 0.7), 0.12, segments), 0.6);
            const Found found(verdict::finer(prism, finer, finer > 0));
            EXPECT_TRUE(found.evidence.creases) << segments << ' ' << finer << ' ' << found.evidence.standing;
            EXPECT_GT(found.evidence.standing, 0.8);
        }
}

// Edges between narrow walls do not stand out, but are sharp where others do. They are round where the mesh goes on
// turning the same way. Here: a groove of one row of bent quads, and a capsule of ten sides.
TEST(Creases, AreSharpUnlessTheMeshIsRoundThere) {
    const auto groove = [](double x, double y) {
        return 1.4 * std::clamp(std::abs(x) - 0.1, 0.0, 0.1) + 0.1 * x * y + 0.01 * y * y;
    };
    const Triangles grooved = test::height_field(20, groove);
    const Triangles capsule = verdict::cut(verdict::capsule(10, 20), verdict::Cut::first);
    for (const bool is_round : {false, true}) {
        const Found found(is_round ? capsule : grooved);
        const mesh::CreaseEvidenceOfParts parts = mesh::look_for_creases_of_parts(found.runtime, found.shape, 30.0);
        EXPECT_LT(parts.whole.standing, 0.5);
        std::int64_t sharp = 0;
        for (const std::uint8_t is : parts.sharp) sharp += is;
        EXPECT_EQ(sharp, is_round ? 0 : 2 * 4 * 20);
    }
}

// A box, and a pyramid. The creases of the pyramid do not count if its faces are too small to be seen.
TEST(Creases, AreIgnoredOnTinyFaces) {
    Triangles shape = test::box(1.0, 1.0, 1.0, 4);
    for (const double size : {1e-3, 1e-1}) {
        Triangles pyramid;
        const std::int32_t tip = pyramid.add(0.0, 0.0, size);
        for (const double y : {-1.0, 1.0})
            for (const double x : {-1.0, 1.0}) static_cast<void>(pyramid.add(size * x, size * y, 0.0));
        pyramid.face(tip, 1, 2);
        pyramid.face(tip, 2, 4);
        pyramid.face(tip, 4, 3);
        pyramid.face(tip, 3, 1);
        const Found found(shape.with(pyramid.moved(1.0, 3.0, 0.0, 0.0)));
        EXPECT_EQ(found.creases.patches, size < 1e-2 ? 7 : 10) << size;
    }
}

// A ball whose faces are roughened has a small patch of one or few faces nearly everywhere. Those of a box are flat.
TEST(Creases, CutARoughBallIntoCrumbs) {
    const Found both(test::box(1.0, 1.0, 1.0, 4).with(roughened(test::icosphere(4), 0.1).moved(1.0, 4.0, 0.0, 0.0)));
    const auto crumbs = mesh::find_crumbs(both.runtime, both.shape, both.creases);
    const auto area = mesh::areas_of_components(both.runtime, both.shape);
    ASSERT_EQ(crumbs.size(), 2);
    EXPECT_EQ(crumbs[0].count, 0);
    EXPECT_NEAR(area[0], 6.0, 1e-9);
    EXPECT_NEAR(area[0] + area[1], both.shape.report.area, 1e-9);
    std::int64_t small = 0; // patches of at most ten faces
    for (std::int32_t patch = 6; patch < both.creases.patches; ++patch)
        small += std::count(both.creases.patch.begin(), both.creases.patch.end(), patch) <= 10 ? 1 : 0;
    EXPECT_GT(small, 100);
    EXPECT_GE(crumbs[1].count, small / 2);
    EXPECT_LE(crumbs[1].count, small);
    EXPECT_GT(crumbs[1].area, 0.0);
    EXPECT_LT(crumbs[1].area, area[1]);
}

// A box and a rough ball: the box has creases.
TEST(Creases, ExistIfOnePartHasEnoughOfThem) {
    const Triangles rough = roughened(test::icosphere(4), 0.025);
    const Found both(test::box(1.0, 1.0, 1.0, 12).with(rough.moved(0.2, 0.5, 0.5, 1.5)));
    EXPECT_LT(both.evidence.standing, 0.9);
    EXPECT_TRUE(both.evidence.creases);
    const Found crumb(test::box(0.1, 0.1, 0.1, 1).with(rough.moved(1.0, 0.0, 0.0, 2.0)));
    EXPECT_FALSE(crumb.evidence.creases);
}

// An octahedron, and the same with its edges halved: each flat face has four triangles.
TEST(Creases, MatchThePolyhedronsEdges) {
    for (const bool halved : {false, true}) {
        Triangles shape;
        for (int axis = 0; axis < 3; ++axis)
            for (const double end : {1.0, -1.0})
                static_cast<void>(shape.add(axis == 0 ? end : 0.0, axis == 1 ? end : 0.0, axis == 2 ? end : 0.0));
        const auto at = [&](std::int32_t v, int k) { return shape.vertices[static_cast<std::size_t>(3 * v + k)]; };
        const auto middle = [&](std::int32_t a, std::int32_t b) {
            return shape.add(0.5 * (at(a, 0) + at(b, 0)), 0.5 * (at(a, 1) + at(b, 1)), 0.5 * (at(a, 2) + at(b, 2)));
        };
        for (std::int32_t i = 0; i < 8; ++i) {
            std::int32_t a = i & 1, b = 2 + (i >> 1 & 1), c = 4 + (i >> 2 & 1);
            if (((i & 1) + (i >> 1 & 1) + (i >> 2 & 1)) % 2 == 1) std::swap(b, c);
            if (!halved) {
                shape.face(a, b, c);
                continue;
            }
            const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            shape.face(a, ab, ca);
            shape.face(b, bc, ab);
            shape.face(c, ca, bc);
            shape.face(ab, bc, ca);
        }
        const Found found(shape);
        EXPECT_TRUE(found.evidence.creases) << found.evidence.coarse;
        EXPECT_EQ(found.creases.patches, 8);
    }
    EXPECT_TRUE(Found(test::icosphere(0)).evidence.creases);
}

// A rock: 80 faces whose corners are 0.6 to 1.4 from its centre.
TEST(Creases, ExistOnARockOfFlatFaces) {
    Triangles rock = test::icosphere(1);
    for (std::size_t i = 0; i < rock.vertices.size(); ++i)
        rock.vertices[i] *= 1.0 + 0.4 * std::sin(1e4 * static_cast<double>(i / 3));
    const Found found(rock);
    EXPECT_TRUE(found.evidence.creases) << found.evidence.coarse;
    EXPECT_TRUE(found.evidence.polyhedron);
    EXPECT_GT(found.creases.patches, 40);
}

// The outline of the plate is round except for one corner. The edge there has the same patch on both sides, and is one
// mesh edge long.
TEST(Creases, ExistAtTheOnlyCornerOfAPlate) {
    for (const double thickness : {0.5, 0.02}) {
        Triangles plate;
        constexpr int around = 48;
        std::vector<glm::dvec2> outline{{1.0, 1.0}};
        for (int i = 0; i <= around; ++i) { // touches the straight sides that lead to the corner
            const double a = (0.5 + 1.5 * i / around) * 3.14159265358979;
            outline.emplace_back(std::cos(a), std::sin(a));
        }
        const auto count = static_cast<std::int32_t>(outline.size());
        for (const double z : {0.0, thickness})
            for (const glm::dvec2& p : outline) static_cast<void>(plate.add(p.x, p.y, z));
        double length = 0.0;
        for (std::int32_t i = 0; i < count; ++i) {
            const std::int32_t next = (i + 1) % count;
            length +=
                2.0 * glm::distance(outline[static_cast<std::size_t>(i)], outline[static_cast<std::size_t>(next)]);
            plate.face(i, next, count + next);
            plate.face(i, count + next, count + i);
            if (i == 0 || next == 0) continue;
            plate.face(0, next, i);
            plate.face(count, count + i, count + next);
        }
        const Found found(plate);
        EXPECT_EQ(found.creases.patches, 4); // the round outline is cut once more
        EXPECT_NEAR(found.creases.length, length + thickness, 1e-9);
    }
}

// The slopes of an eight-sided roof meet at 18 degrees, but its outline has corners of 45: they are facets, like those
// of a lamp's ring. A roof of 32 sides is round. Beside a large box the roof is small enough for either.
TEST(Creases, ConnectCornersOfOtherCreases) {
    const auto roof = [](int sides) {
        return test::ringed({{0.0, 0.0}, {1.0, 0.0}, {0.5, 0.22}, {0.5, 0.6}, {0.0, 0.6}}, sides, 10.0)
            .with(test::box(10.0, 10.0, 10.0, 1).moved(1.0, 5.0, 0.0, 0.0));
    };
    EXPECT_EQ(Found(roof(8)).creases.patches, 1 + 8 + 8 + 1 + 6);
    EXPECT_EQ(Found(roof(32)).creases.patches, 4 + 6);
}

// A ridge that fades towards positive x. Its crease grows to the last edges that bend by 8 degrees. The patch is cut
// further from there as a smooth border, which both sheets share.
TEST(Creases, ContinueAsASmoothBorderWhereTheyFade) {
    const auto ridge = [](double x, double y) { return x < 0.0 ? -x * x * std::abs(y) : 0.0; };
    const Found found(test::height_field(40, ridge));
    EXPECT_EQ(found.creases.patches, 2);
    EXPECT_EQ(found.creases.fading, 0.0);
    EXPECT_NEAR(found.creases.length, 0.75, 0.1); // up to where the slope is 0.07
    std::int64_t smooth = 0;
    for (std::int64_t side = 0; side < found.creases.cut.size(); ++side) {
        if (found.creases.cut[side] != 2) continue;
        ++smooth;
        EXPECT_GT(found.shape.corners(side / 3)[0].x, -0.3);
    }
    EXPECT_GT(smooth, 10);
    EXPECT_GT(found.creases.shared.size(), 40);
    for (const mesh::Creases::Shared& shared : found.creases.shared)
        EXPECT_NE(shared.patch, found.creases.patch[shared.face]);
}

// The wall of a fading step ends in a tip. The parts above and below it are two patches, and the cut between them goes
// on from the tip.
TEST(Creases, SeparateTheSidesBeyondATip) {
    const Found found(test::fading_step(40));
    EXPECT_EQ(found.creases.patches, 3);
    std::int64_t cut = 0;
    for (std::int64_t face = 0; face < found.shape.faces(); ++face) {
        const auto p = found.shape.corners(face);
        const glm::dvec3 middle = (p[0] + p[1] + p[2]) / 3.0;
        for (std::int64_t other = 0; other < face; ++other) {
            const auto q = found.shape.corners(other);
            const glm::dvec3 its = (q[0] + q[1] + q[2]) / 3.0;
            if (std::abs(middle.y) < 1e-9 || std::abs(its.y) < 1e-9) continue; // skips faces of the wall
            const bool apart = std::min(middle.x, its.x) > 0.0 && (middle.y < 0.0) != (its.y < 0.0);
            EXPECT_FALSE(apart && found.creases.patch[face] == found.creases.patch[other]);
        }
        for (std::int64_t side = 3 * face; side < 3 * face + 3; ++side) {
            if (found.creases.cut[side] != 2) continue;
            ++cut;
            EXPECT_LT(middle.x, 0.1);
        }
    }
    EXPECT_GT(cut, 10);
    EXPECT_GT(found.creases.shared.size(), 20);
}

// A tube with one crease along it. There the patch meets only itself.
TEST(Creases, CutATubeAlongItsLength) {
    Triangles tube;
    constexpr int around = 48;
    constexpr int along = 20;
    for (int j = 0; j <= along; ++j)
        for (int i = 0; i < around; ++i) {
            const double t = 6.283185307179586 * i / around;
            const double drop = 0.5 * (1.0 - std::cos(t)); // 0 at the crease
            static_cast<void>(tube.add(1.0 - drop * 2.0, std::sin(t) * std::sin(0.5 * t), 0.1 * j));
        }
    for (int j = 0; j < along; ++j)
        for (int i = 0; i < around; ++i) {
            const int a = j * around + i;
            const int b = j * around + (i + 1) % around;
            tube.face(a, b, b + around);
            tube.face(a, b + around, a + around);
        }
    const Found found(tube);
    EXPECT_NEAR(found.creases.length, 2.0, 1e-9);
    EXPECT_EQ(found.creases.patches, 2);
    EXPECT_EQ(found.creases.fading, 0.0);
}

// A box with a fin at an edge, so that this edge has three faces.
TEST(Creases, EndAtEdgesOfMoreThanTwoFaces) {
    const Triangles box = test::box(1.0, 1.0, 1.0, 3);
    const Triangles fin = box.where([](double x, double, double) { return x < 1e-3; });
    const Found found(box.with(fin.moved(1.0, 1.0, 1.0, 0.0)));
    EXPECT_GT(found.shape.report.nonmanifold_edges, 0);
    EXPECT_EQ(found.creases.patches, 7);
}

// Bends of 12 degrees make a cylinder, and bends of 28 degrees a prism.
TEST(Creases, KeepCoarseFacesFlat) {
    const std::vector<test::Ring> rings{{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.5}, {0.0, 0.5}};
    EXPECT_EQ(Found(test::ringed(rings, 30, 0.5)).creases.patches, 3);
    EXPECT_EQ(Found(test::ringed(rings, 13, 0.5)).creases.patches, 2 + 13);
}

} // namespace

} // namespace creases_test
