// SPDX-License-Identifier: MIT
#include "mesh/pieces/fit_sheet_tree.h"

#include "base/random.h"
#include "base/status.h"
#include "mesh/meshes.h"
#include "mesh/sample.h"
#include "support/rounded_meshes.h"
#include "support/runtime.h"
#include "support/sharp_meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fit_pieces_test {

namespace geometry = hrbfnpr::geometry;
namespace implicit = hrbfnpr::implicit;
namespace mesh = hrbfnpr::mesh;
namespace test = hrbfnpr::test;
using hrbfnpr::test::Triangles;

namespace {

struct Fitted {
    explicit Fitted(const Triangles& from, int threads = 2, std::int64_t most = 8000)
        : runtime(test::with_threads(threads)), shape(mesh_test::made(runtime, from, mesh::Parts::all)),
          tree(runtime, shape.vertex, shape.triangle),
          creases(mesh::find_creases(runtime, shape, {30.0, 0.008 * shape.bounds.diagonal()})),
          result(mesh::fit_sheet_tree(runtime, shape, tree, creases, settings(most), {})),
          f(runtime.instruction_set, std::move(result.data)) {}

    [[nodiscard]] static mesh::FitMeshSettings settings(std::int64_t most) {
        mesh::FitMeshSettings result;
        result.maximum_centres = most;
        return result;
    }
    [[nodiscard]] double value(const glm::dvec3& p) const {
        double value = 0.0;
        f.evaluate({&p.x, &p.y, &p.z, 1}, {&value, {}, {}});
        return value;
    }
    // Returns how far the surface is from a place on a true edge, along the direction midway between both normals.
    [[nodiscard]] double edge_offset(const glm::dvec3& p, const glm::dvec3& out) const {
        const double diagonal = shape.bounds.diagonal();
        for (double reach = 1e-5; reach < 0.02; reach *= 1.3)
            if ((value(p + reach * diagonal * out) > 0.0) != (value(p - reach * diagonal * out) > 0.0)) return reach;
        return 1.0;
    }
    // Counts the wrong signs at random places in the box and beside the mesh. Only places farther from the mesh than
    // 0.1 % of the diagonal count.
    template <class Inside>
    [[nodiscard]] int wrong_signs(Inside&& inside) const {
        const double diagonal = shape.bounds.diagonal();
        const mesh::MeshSamples on = mesh::random_samples(runtime, shape, 3000, 5, 3);
        int wrong = 0;
        for (std::int64_t i = 0; i < 6000; ++i) {
            const auto random =
                hrbfnpr::base::uniform4(9, static_cast<std::uint64_t>(i), hrbfnpr::base::Purpose::probe);
            const glm::dvec3 unit(random[0], random[1], random[2]);
            const glm::dvec3 p = i % 2 == 0
                                     ? shape.bounds.min - 0.1 * diagonal + unit * (shape.bounds.size() + 0.2 * diagonal)
                                     : on.position[i / 2] + 0.02 * diagonal * (2.0 * unit - 1.0);
            if (tree.distance(p) < 0.001 * diagonal) continue;
            wrong += (value(p) < 0.0) != inside(p) ? 1 : 0;
        }
        return wrong;
    }

    hrbfnpr::base::Runtime runtime;
    mesh::Mesh shape;
    mesh::FaceTree tree;
    mesh::Creases creases;
    mesh::SheetTreeFit result;
    implicit::SheetTree f;
};

bool in_box(const glm::dvec3& p, const glm::dvec3& low, const glm::dvec3& high) {
    return glm::all(glm::lessThan(low, p)) && glm::all(glm::lessThan(p, high));
}

TEST(FitPieces, ReproduceACube) {
    const Fitted cube(test::box(1.0, 1.0, 1.0, 5));
    EXPECT_EQ(cube.result.pieces.sheets, 6);
    EXPECT_EQ(cube.result.pieces.poor_cells, 0);
    EXPECT_NEAR(cube.result.pieces.crease_length, 12.0, 1e-9);
    EXPECT_TRUE(cube.result.mesh.reached);
    EXPECT_LT(cube.result.mesh.mesh.most, 1e-6);
    EXPECT_LT(cube.f.data().centres(), 120);
    EXPECT_LT(cube.result.fit.value_residual_max, 1e-9);
    EXPECT_LT(cube.result.fit.gradient_residual_max, 1e-9);
    EXPECT_EQ(cube.result.fit.samples, cube.result.mesh.candidates);
    const double r = std::sqrt(0.5);
    for (int i = 1; i < 100; ++i) { // without the corners, where three sides meet
        EXPECT_LT(cube.edge_offset({0.01 * i, 0.0, 1.0}, {0.0, -r, r}), 1.1e-5);
        EXPECT_LT(cube.edge_offset({1.0, 1.0, 0.01 * i}, {r, r, 0.0}), 1.1e-5);
    }
    EXPECT_EQ(cube.wrong_signs([](const glm::dvec3& p) { return in_box(p, glm::dvec3(0.0), glm::dvec3(1.0)); }), 0);
}

// The cube has concave edges and round ones, and a sheet that closes around the hole.
TEST(FitPieces, KeepADrilledCubeSharpAroundTheHole) {
    const Fitted drilled(test::drilled_cube(0.5, 96));
    EXPECT_EQ(drilled.result.pieces.sheets, 7);
    EXPECT_EQ(drilled.result.pieces.poor_cells, 0);
    for (int i = 0; i < 300; ++i) {
        const double c = std::cos(0.0209 * i);
        const double s = std::sin(0.0209 * i);
        EXPECT_LT(drilled.edge_offset({0.5 * c, 0.5 * s, 1.0}, std::sqrt(0.5) * glm::dvec3(-c, -s, 1.0)), 1e-4) << i;
    }
    EXPECT_EQ(drilled.wrong_signs([](const glm::dvec3& p) {
        return in_box(p, glm::dvec3(-1.0), glm::dvec3(1.0)) && std::hypot(p.x, p.y) > 0.5;
    }),
              0);
}

TEST(FitPieces, KeepTheStepsOfAShaft) {
    const Fitted shaft(test::stepped_shaft(96));
    EXPECT_EQ(shaft.result.pieces.poor_cells, 0);
    EXPECT_TRUE(shaft.result.mesh.reached);
    const double r = std::sqrt(0.5);
    struct Step {
        double radius, z, out, up;
    };
    for (const Step& step : {Step{1.0, 0.8, r, r}, Step{0.6, 0.8, r, r}, Step{0.5, 1.4, r, -r}, Step{0.35, 3.0, r, r}})
        for (int i = 0; i < 200; ++i) {
            const double c = std::cos(0.0314 * i);
            const double s = std::sin(0.0314 * i);
            EXPECT_LT(
                shaft.edge_offset({step.radius * c, step.radius * s, step.z}, {step.out * c, step.out * s, step.up}),
                1e-4)
                << step.z << ' ' << i;
        }
    EXPECT_EQ(shaft.wrong_signs([](const glm::dvec3& p) {
        const double radius = p.z < 0.8 ? 1.0 : p.z < 1.2 ? 0.6 : p.z < 1.4 ? 0.5 : p.z < 2.2 ? 0.6 : 0.35;
        return p.z > 0.0 && p.z < 3.0 && std::hypot(p.x, p.y) < radius;
    }),
              0);
}

TEST(FitPieces, KeepBothSidesOfAThinPlate) {
    const double thick = 0.0042; // 0.3 % of the diagonal
    const Fitted plate(test::box(1.0, 1.0, thick, 6));
    EXPECT_EQ(plate.result.pieces.sheets, 6);
    EXPECT_EQ(plate.result.pieces.poor_cells, 0);
    EXPECT_EQ(
        plate.wrong_signs([&](const glm::dvec3& p) { return in_box(p, glm::dvec3(0.0), glm::dvec3(1.0, 1.0, thick)); }),
        0);
    EXPECT_LT(plate.value({0.5, 0.5, 0.5 * thick}), 0.0);
}

// The parts are 0.6 % of the diagonal apart or less, one inside the other's hull.
TEST(FitPieces, KeepPartsApart) {
    const Fitted two(test::box(1.0, 1.0, 1.0, 4).with(test::box(1.0, 1.0, 1.0, 4).moved(1.0, 1.015, 0.2, 0.0)));
    EXPECT_EQ(two.wrong_signs([](const glm::dvec3& p) {
        return in_box(p, glm::dvec3(0.0), glm::dvec3(1.0)) ||
               in_box(p, glm::dvec3(1.015, 0.2, 0.0), glm::dvec3(2.015, 1.2, 1.0));
    }),
              0);
    EXPECT_GT(two.value({1.0075, 0.5, 0.5}), 0.0);
}

TEST(FitPieces, UniteOverlappingParts) {
    const Fitted two(test::box(1.0, 1.0, 1.0, 4).with(test::box(1.0, 1.0, 1.0, 4).moved(0.9, 0.5, 0.5, 0.5)));
    EXPECT_LT(two.result.pieces.cells, 5000);
    EXPECT_EQ(two.wrong_signs([](const glm::dvec3& p) {
        return in_box(p, glm::dvec3(0.0), glm::dvec3(1.0)) || in_box(p, glm::dvec3(0.5), glm::dvec3(1.4));
    }),
              0);
}

TEST(FitPieces, KeepTheCavityOfAShell) {
    const Fitted shell(
        test::box(1.0, 1.0, 1.0, 4).with(test::box(1.0, 1.0, 1.0, 4).moved(0.9, 0.05, 0.05, 0.05).turned()));
    EXPECT_EQ(shell.result.pieces.sheets, 12);
    EXPECT_EQ(shell.wrong_signs([](const glm::dvec3& p) {
        return in_box(p, glm::dvec3(0.0), glm::dvec3(1.0)) && !in_box(p, glm::dvec3(0.05), glm::dvec3(0.95));
    }),
              0);
}

// On a roof the sheets go on beyond its border.
TEST(FitPieces, ContinueBeyondTheBorderOfAnOpenSheet) {
    const Fitted roof(test::height_field(20, [](double, double y) { return -std::abs(y); }));
    EXPECT_EQ(roof.result.pieces.sheets, 2);
    for (const double x : {-1.2, -0.7, 0.0, 0.9, 1.2})
        for (const double y : {-1.1, -0.5, 0.3, 1.1})
            for (const double off : {-0.6, -0.02, 0.02, 0.6})
                EXPECT_EQ(roof.value({x, y, off - std::abs(y)}) > 0.0, off > 0.0) << x << ' ' << y << ' ' << off;
    for (int i = -50; i <= 50; ++i) EXPECT_LT(roof.edge_offset({0.02 * i, 0.0, 0.0}, {0.0, 0.0, 1.0}), 1.1e-5);
}

TEST(FitPieces, FollowACreaseThatFades) {
    const auto ridge = [](double x, double y) { return x < 0.0 ? -x * x * std::abs(y) : 0.0; };
    const Fitted fading(test::height_field(60, ridge));
    EXPECT_EQ(fading.result.pieces.smooth_length, 0.0);
    EXPECT_TRUE(fading.result.mesh.reached);
    for (int i = 0; i <= 100; ++i) EXPECT_LT(fading.edge_offset({-0.01 * i, 0.0, 0.0}, {0.0, 0.0, 1.0}), 4e-4) << i;
    // From the crease's end on, both sheets agree.
    for (int i = 0; i <= 50; ++i) EXPECT_LT(fading.edge_offset({0.018 * i, 0.0, 0.0}, {0.0, 0.0, 1.0}), 4e-4) << i;
}

// The flat faces of the chamfer stay flat up to the tips of the cones between them.
TEST(FitPieces, KeepChamfersFlatNextToConeTips) {
    const Fitted plate(test::chamfered_plate(20));
    EXPECT_TRUE(plate.result.mesh.reached);
    EXPECT_EQ(plate.result.mesh.mesh.share, 1.0);
    EXPECT_LT(plate.result.mesh.mesh.most, 1e-3 * plate.shape.bounds.diagonal());
    EXPECT_LT(plate.result.mesh.surface.most, 1e-3 * plate.shape.bounds.diagonal());
    for (int i = 0; i <= 60; ++i) { // along the middle of a side
        const double x = 1.0 + 13.0 * i / 60.0;
        const double off = plate.value({x, 0.5, 3.1});
        EXPECT_LT(std::abs(off), 1e-3 * plate.shape.bounds.diagonal()) << x;
    }
}

// Tips of cones are points, also if rings of faces lead to them, and nothing sticks out beyond them.
TEST(FitPieces, MakeTheTipsOfConesSharp) {
    for (const double height : {0.6, 2.5})
        for (const int rings : {1, 20})
            for (const int around : {32, 64}) {
                SCOPED_TRACE(testing::Message() << height << ' ' << rings << ' ' << around);
                std::vector<test::ProfilePoint> profile{{0.0, 0.0}};
                for (int i = 0; i <= rings; ++i) {
                    const double share = static_cast<double>(i) / rings;
                    profile.push_back({i == rings ? 0.0 : 1.0 - share, height * share});
                }
                const Fitted cone(test::turned_part(profile, around));
                const double diagonal = cone.shape.bounds.diagonal();
                for (double below = 8e-4; below < 0.05; below *= 1.2)
                    EXPECT_LT(cone.value({0.0, 0.0, height - below * diagonal}), 0.0) << below;
                for (double above = 1e-4; above < 0.05; above *= 1.2)
                    EXPECT_GT(cone.value({0.0, 0.0, height + above * diagonal}), 0.0) << above;
            }
}

// A ball of few faces beside a box of many. Each part gets as many centres as it needs.
TEST(FitPieces, GiveEnoughCentresToPartsWithFewFaces) {
    const Triangles ball = test::icosphere(3).moved(1.0, 3.0, 0.0, 0.0);
    const Fitted both(test::box(1.0, 1.0, 1.0, 60).with(ball), 2, 400);
    EXPECT_EQ(both.result.pieces.sheets, 7);
    EXPECT_TRUE(both.result.mesh.reached);
}

// The fit meets both edges of the wall up to the tip, where they are 0.03 % of the diagonal apart.
TEST(FitPieces, FollowAStepThatFades) {
    const Fitted step(test::fading_step(40));
    EXPECT_TRUE(step.result.mesh.reached);
    const double r = std::sqrt(0.5);
    for (int i = 6; i <= 100; ++i) {
        const double x = 0.01 * i;
        EXPECT_LT(step.edge_offset({x, 0.0, 0.25 * x * x}, {0.0, -r, r}), 1e-4) << i;
        EXPECT_LT(step.edge_offset({x, 0.0, 0.0}, {0.0, -r, r}), 1e-4) << i;
    }
}

TEST(FitPieces, AreRightWhereFourFacesShareAnEdge) {
    const Fitted two(test::box(1.0, 1.0, 1.0, 3).with(test::box(1.0, 1.0, 1.0, 3).moved(1.0, 1.0, 1.0, 0.0)));
    EXPECT_LE(two.wrong_signs([](const glm::dvec3& p) {
        return in_box(p, glm::dvec3(0.0), glm::dvec3(1.0)) ||
               in_box(p, glm::dvec3(1.0, 1.0, 0.0), glm::dvec3(2.0, 2.0, 1.0));
    }),
              0);
}

// Boxes on each other that share one vertex become two parts, so no wall is needed where one stands on the other.
TEST(FitPieces, NeedNoWallWherePartsShareAVertex) {
    const Fitted two(test::box(1.0, 1.0, 1.0, 2).with(test::box(0.7, 0.6, 1.0, 3).moved(1.0, 0.0, 0.0, 1.0)));
    EXPECT_EQ(two.shape.report.components, 2);
    EXPECT_LE(two.wrong_signs([](const glm::dvec3& p) {
        return in_box(p, glm::dvec3(0.0), glm::dvec3(1.0)) ||
               in_box(p, glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.7, 0.6, 2.0));
    }),
              0);
}

// A vertex of the top is beyond the edge, as in a mesh that was edited. This makes a fold that sticks out, with faces
// that look up and faces that look down.
TEST(FitPieces, KnowTheOutsideOfFoldedFaces) {
    Triangles shape = test::box(1.0, 1.0, 1.0, 5);
    int moved = 0;
    for (std::size_t i = 0; i < shape.vertices.size(); i += 3)
        if (std::abs(shape.vertices[i] - 0.8) + std::abs(shape.vertices[i + 1] - 0.4) < 1e-9 &&
            shape.vertices[i + 2] > 0.999) {
            shape.vertices[i] = 1.15;
            ++moved;
        }
    ASSERT_EQ(moved, 1);
    const Fitted folded(shape);
    EXPECT_EQ(folded.wrong_signs([](const glm::dvec3& p) { return in_box(p, glm::dvec3(0.0), glm::dvec3(1.0)); }), 0);
}

// The top of the box is divided differently from its sides, and its halves differently from each other. They share no
// edges.
TEST(FitPieces, BridgeTJunctions) {
    Triangles shape = test::box(1.0, 1.0, 1.0, 4).where([](double, double, double z) { return z < 0.999; });
    const auto half = [&](double low, double high, int cuts) {
        for (int i = 0; i < cuts; ++i) {
            const double a = static_cast<double>(i) / cuts;
            const double b = static_cast<double>(i + 1) / cuts;
            const std::int32_t p = shape.add(a, low, 1.0);
            const std::int32_t q = shape.add(b, low, 1.0);
            const std::int32_t r = shape.add(b, high, 1.0);
            shape.face(p, q, r);
            shape.face(p, r, shape.add(a, high, 1.0));
        }
    };
    half(0.0, 0.5, 3);
    half(0.5, 1.0, 7);
    const Fitted tee(shape);
    EXPECT_GT(tee.shape.report.boundary_edges, 10);
    EXPECT_EQ(tee.result.pieces.sheets, 7);
    EXPECT_EQ(tee.result.pieces.poor_cells, 0);
    EXPECT_EQ(tee.wrong_signs([](const glm::dvec3& p) { return in_box(p, glm::dvec3(0.0), glm::dvec3(1.0)); }), 0);
    for (int i = 1; i < 100; ++i)
        EXPECT_LT(tee.edge_offset({0.01 * i, 0.0, 1.0}, std::sqrt(0.5) * glm::dvec3(0.0, -1.0, 1.0)), 1.1e-5);
}

// Values, gradients and Hessians at places beside the surface and all over the box.
struct Asked {
    std::vector<double> x, y, z;
    std::vector<std::vector<double>> field;
    std::vector<std::int32_t> sheet;

    Asked(const Fitted& fitted, const implicit::SheetTreeBase& f) : field(10) {
        const geometry::Bounds& box = fitted.shape.bounds;
        for (std::uint64_t i = 0; i < 6000; ++i) {
            const auto u = hrbfnpr::base::uniform4(5, i, hrbfnpr::base::Purpose::probe);
            const auto corners = fitted.shape.corners(
                static_cast<std::int64_t>(u[3] * 0.9999 * static_cast<double>(fitted.shape.faces())));
            const glm::dvec3 off = glm::dvec3(u[0], u[1], u[2]) - 0.5;
            const glm::dvec3 p = i % 3 == 0
                                     ? box.centre() + 1.4 * off * (box.max - box.min)
                                     : (corners[0] + u[0] * (corners[1] - corners[0]) +
                                        (1.0 - u[0]) * u[1] * (corners[2] - corners[0]) + 0.01 * box.diagonal() * off);
            x.push_back(p.x);
            y.push_back(p.y);
            z.push_back(p.z);
        }
        for (std::vector<double>& one : field) one.resize(x.size());
        sheet.resize(x.size());
        const auto at = [&](std::size_t k) { return field[k].data(); };
        const implicit::PointBatch points{x.data(), y.data(), z.data(), static_cast<std::int64_t>(x.size())};
        f.evaluate(points, {at(0), {at(1), at(2), at(3)}, {at(4), at(5), at(6), at(7), at(8), at(9)}});
        f.active(points, sheet.data());
    }
};

// Zones know where one sheet is f, and leave out sheets that cannot be f. The results may differ by rounding only.
TEST(PreparedPieces, EqualTheUnpreparedFunction) {
    for (const Triangles& shape : {test::box(1.0, 1.0, 1.0, 8), test::gear(16, 3), test::drilled_cube(0.5, 48)}) {
        const Fitted fitted(shape);
        const implicit::PreparedSheetTree prepared(fitted.runtime, fitted.f, implicit::PreparedSheetTree::Scope::zones);
        const Asked plain(fitted, fitted.f);
        const Asked ready(fitted, prepared);
        int same = 0;
        for (std::size_t i = 0; i < plain.x.size(); ++i) {
            for (std::size_t k = 0; k < 10; ++k)
                EXPECT_NEAR(ready.field[k][i], plain.field[k][i], 1e-11 * (1.0 + std::abs(plain.field[k][i])))
                    << "field " << k << " at " << plain.x[i] << ' ' << plain.y[i] << ' ' << plain.z[i];
            same += ready.sheet[i] == plain.sheet[i] ? 1 : 0;
        }
        EXPECT_EQ(same, static_cast<int>(plain.x.size()));
    }
}

// The result does not depend on the other points in the batch.
TEST(PreparedPieces, APointsResultDoesNotDependOnOtherPoints) {
    const Fitted fitted(test::drilled_cube(0.5, 48));
    const implicit::PreparedSheetTree prepared(fitted.runtime, fitted.f, implicit::PreparedSheetTree::Scope::sheets);
    const Asked all(fitted, prepared);
    for (std::size_t i = 0; i < all.x.size(); i += 7) {
        double value = 0.0, gradient[3];
        const glm::dvec3 p(all.x[i], all.y[i], all.z[i]);
        prepared.evaluate({&p.x, &p.y, &p.z, 1}, {&value, {&gradient[0], &gradient[1], &gradient[2]}, {}});
        EXPECT_EQ(value, all.field[0][i]);
        for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(gradient[c], all.field[1 + c][i]);
    }
}

// Far from creases only one sheet is evaluated, so most places cost one evaluation.
TEST(PreparedPieces, NeedOnlyOneSheetAtMostPlaces) {
    const Fitted fitted(test::drilled_cube(0.5, 48));
    const implicit::SheetTreeZones zones(fitted.runtime, fitted.f.data());
    const Asked asked(fitted, fitted.f);
    int one = 0;
    int known = 0;
    int beside = 0;
    for (std::size_t i = 0; i < asked.x.size(); ++i) {
        if (i % 3 == 0) continue;
        ++beside;
        const glm::dvec3 p(asked.x[i], asked.y[i], asked.z[i]);
        const implicit::SheetTreeZones::Candidates at = zones.candidates_at(p);
        known += at.sheet >= 0 || !at.parts.empty() ? 1 : 0;
        if (at.sheet < 0) continue;
        EXPECT_EQ(at.sheet, asked.sheet[i]);
        ++one;
    }
    EXPECT_EQ(known, beside);
    EXPECT_GT(one, beside / 2);
}

} // namespace

} // namespace fit_pieces_test
