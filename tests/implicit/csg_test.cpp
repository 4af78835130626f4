// SPDX-License-Identifier: MIT
// Compares CSG trees with a plain recursion, with finite differences and with known results.
#include "csg_nodes.h"

#include "implicit/csg.h"
#include "implicit/custom.h"

#include <gtest/gtest.h>

namespace csg_test {

namespace base = hrbfnpr::base;
namespace geometry = hrbfnpr::geometry;
namespace implicit = hrbfnpr::implicit;
using test::CsgKind;
using test::CsgNode;
using test::node;
using test::Nodes;
using test::scattered;

namespace {

const geometry::Bounds unit_box{glm::dvec3(-1.0), glm::dvec3(1.0)};

// A tree with its plan; the models are spheres.
class Solid {
public:
    explicit Solid(const Nodes& nodes, const std::vector<const implicit::Implicit*>& models = {},
                   const base::Runtime& runtime = shared())
        : reference{nodes, models, {}}, plan_(make_plan(runtime, nodes, models, reference.regions)),
          csg(runtime, plan_, leaves(runtime, models), unit_box) {}

    [[nodiscard]] static const base::Runtime& shared() {
        static const auto& runtime = *new base::Runtime;
        return runtime;
    }
    [[nodiscard]] const implicit::CsgPlan& plan() const { return plan_; }

    test::CsgReference reference;

private:
    static base::Array<const implicit::Implicit*> leaves(const base::Runtime& runtime,
                                                         const std::vector<const implicit::Implicit*>& models) {
        base::Array<const implicit::Implicit*> array(runtime.memory);
        for (const implicit::Implicit* model : models) array.push_back(model);
        return array;
    }
    static implicit::CsgPlan make_plan(const base::Runtime& runtime, const Nodes& nodes,
                                       const std::vector<const implicit::Implicit*>& models,
                                       std::vector<geometry::Bounds>& regions) {
        base::Array<implicit::CsgModel> known(runtime.memory);
        for (const implicit::Implicit* model : models) {
            regions.push_back(model->bounds().grown(0.05 * model->diagonal()));
            known.push_back({model->bounds(), regions.back(), 1, 0.0});
        }
        return {runtime.memory, test::tree_of(runtime.memory, nodes), known};
    }
    implicit::CsgPlan plan_;

public:
    implicit::Csg csg;
};

// The values at a single point.
struct One {
    double value = 0.0;
    glm::dvec3 gradient{0.0};
    std::array<double, 6> hessian{};
};

template <class F>
One evaluate_one(const glm::dvec3& p, F&& evaluate) {
    test::Points points;
    points.add(p);
    test::Fields fields(1);
    evaluate(points.batch(), fields.all());
    One one{fields.value[0], {fields.gradient[0][0], fields.gradient[1][0], fields.gradient[2][0]}, {}};
    for (std::size_t c = 0; c < 6; ++c) one.hessian[c] = fields.hessian[c][0];
    return one;
}
One at(const implicit::Implicit& csg, const glm::dvec3& p) {
    return evaluate_one(p, [&](const auto& points, const auto& fields) { csg.evaluate(points, fields); });
}
One at(const implicit::Sheets& sheets, std::int32_t sheet, const glm::dvec3& p) {
    return evaluate_one(p, [&](const auto& points, const auto& fields) { sheets.evaluate(sheet, points, fields); });
}
std::int32_t active(const implicit::Sheets& sheets, const glm::dvec3& p) {
    std::int32_t sheet = -1;
    sheets.active({&p.x, &p.y, &p.z, 1}, &sheet);
    return sheet;
}

CsgNode ball(std::int64_t parent, const glm::dvec3& centre, double radius) {
    CsgNode made = node(CsgKind::sphere, parent);
    made.translation = centre;
    made.radius = radius;
    return made;
}
// x <= `at`, or the same for another axis.
CsgNode half_space(std::int64_t parent, int axis, double at) {
    CsgNode made = node(CsgKind::half_space, parent);
    glm::dmat3 turn(0.0);
    for (int c = 0; c < 3; ++c) turn[c][(c + axis + 1) % 3] = 1.0; // z becomes `axis`
    made.linear = turn;
    made.translation[axis] = at;
    return made;
}

TEST(Csg, AnyTreeMatchesARecursiveEvaluation) {
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        const test::RandomTree tree(seed, 1 + static_cast<int>(seed % 5), true);
        const Solid solid(tree.nodes());
        const test::Points points = scattered(300, 2.5); // more than one block
        test::Fields fields(points.size());
        solid.csg.evaluate(points.batch(), fields.all());
        test::Fields values(points.size());
        solid.csg.evaluate(points.batch(), values.batch(true, false, false));
        ASSERT_EQ(fields.value, values.value);
        for (std::size_t i = 0; i < points.size(); ++i)
            ASSERT_NEAR(fields.value[i], solid.reference.at(points[i]), 1e-12) << i;
    }
}

// Differences are compared where one sheet is f all around the point.
TEST(Csg, GradientsAndHessiansMatchDifferences) {
    int compared = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        const test::RandomTree tree(seed, 2 + static_cast<int>(seed % 4), true);
        const Solid solid(tree.nodes());
        const test::Points points = scattered(20, 1.5);
        for (std::size_t k = 0; k < points.size(); ++k) {
            const One f = at(solid.csg, points[k]);
            constexpr double h = 1e-5;
            const implicit::Sheets* const sheets = solid.csg.sheets();
            const std::int32_t here = sheets != nullptr ? active(*sheets, points[k]) : 0;
            bool one_sheet = true;
            glm::dvec3 gradient;
            std::array<double, 6> hessian{};
            for (int i = 0; i < 3; ++i) {
                glm::dvec3 step(0.0);
                step[i] = h;
                const One more = at(solid.csg, points[k] + step);
                const One less = at(solid.csg, points[k] - step);
                if (sheets != nullptr)
                    one_sheet = one_sheet && active(*sheets, points[k] + step) == here &&
                                active(*sheets, points[k] - step) == here;
                gradient[i] = (more.value - less.value) / (2.0 * h);
                for (int j = 0; j < 3; ++j)
                    hessian[test::hessian_index[i][j]] +=
                        (i == j ? 1.0 : 0.5) * (more.gradient[j] - less.gradient[j]) / (2.0 * h);
            }
            if (!one_sheet) continue;
            ++compared;
            // The tolerance grows with the second derivatives: they are large near an axis or a centre, and third
            // derivatives of blends jump.
            double size = 1.0;
            for (const double second : f.hessian) size = std::max(size, second * second);
            for (int i = 0; i < 3; ++i) ASSERT_NEAR(f.gradient[i], gradient[i], 1e-8 * size) << k;
            for (std::size_t i = 0; i < 6; ++i) ASSERT_NEAR(f.hessian[i], hessian[i], 2e-3 * size) << k;
        }
    }
    EXPECT_GT(compared, 3000);
}

TEST(Csg, AnActiveSheetEqualsFAndIsSmooth) {
    int crossings = 0;
    for (std::uint32_t seed = 0; seed < 120; ++seed) {
        SCOPED_TRACE(seed);
        Nodes nodes = test::RandomTree(seed, 2 + static_cast<int>(seed % 4), true).nodes();
        for (CsgNode& one : nodes)
            one.exponent = 0.0; // super-ellipses have a crease where both operands are beyond the blend
        const Solid solid(nodes);
        const implicit::Sheets* const sheets = solid.csg.sheets();
        if (sheets == nullptr) continue;
        const test::Points points = scattered(60, 1.5);
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            const std::int32_t sheet = active(*sheets, points[k]);
            ASSERT_GE(sheet, 0);
            ASSERT_LT(sheet, sheets->count());
            const One f = at(solid.csg, points[k]);
            const One own = at(*sheets, sheet, points[k]);
            ASSERT_EQ(f.value, own.value) << k;
            ASSERT_EQ(f.gradient, own.gradient) << k;
            ASSERT_EQ(f.hessian, own.hessian) << k;
            // Beyond the crease the sheet is the same function: along a line its differences agree with its gradients.
            const glm::dvec3 step = 0.003 * (points[k + 1] - points[k]);
            for (int i = 0; i < 60; ++i) {
                const glm::dvec3 from = points[k] + static_cast<double>(i) * step;
                crossings += active(*sheets, from + step) != sheet ? 1 : 0;
                const One a = at(*sheets, sheet, from);
                const One b = at(*sheets, sheet, from + step);
                double bend = 1.0;
                for (const double second : a.hessian) bend = std::max(bend, std::abs(second));
                for (const double second : b.hessian) bend = std::max(bend, std::abs(second));
                if (bend * glm::length(step) > 0.3) continue; // an axis is near
                const double mean = 0.5 * glm::dot(a.gradient + b.gradient, step);
                ASSERT_NEAR(b.value - a.value, mean, 2.0 * bend * glm::dot(step, step)) << k << ' ' << i;
                ASSERT_LT(glm::length(b.gradient - a.gradient), 4.0 * bend * glm::length(step) + 1e-9) << k << ' ' << i;
            }
        }
    }
    EXPECT_GT(crossings, 2000) << "or this test shows little";
}

TEST(Csg, BlendsAreSmoothAndEndAtTheirRadius) {
    for (const double exponent : {0.0, 2.0, 3.5}) {
        SCOPED_TRACE(exponent);
        // Two half-spaces at a right angle.
        Nodes nodes{node(CsgKind::unite), half_space(0, 0, 0.0), half_space(0, 1, 0.0)};
        nodes[0].blend = 0.5;
        nodes[0].exponent = exponent;
        const Solid solid(nodes);
        nodes[0].blend = 0.0;
        const Solid sharp(nodes);
        double lowest = 0.0;
        One before = at(solid.csg, {-1.0, 1.0, 0.0});
        constexpr int steps = 4000;
        for (int i = 1; i <= steps; ++i) { // goes across the blend and beyond both ends
            const double s = 2.0 * i / steps;
            const One f = at(solid.csg, {-1.0 + s, 1.0 - s, 0.0});
            EXPECT_LT(glm::length(f.gradient - before.gradient), 5.0 / 0.5 * std::sqrt(8.0) / steps) << s;
            before = f;
            lowest = std::min(lowest, f.value - std::min(-1.0 + s, 1.0 - s));
        }
        if (exponent == 0.0) {
            EXPECT_NEAR(lowest, -0.5 / 6.0, 1e-6);
        }
        // From the radius on, the blended surface is the sharp one, and only from there.
        for (const double along : {0.51, 0.8}) {
            EXPECT_EQ(at(solid.csg, {0.0, along, 0.3}).value, 0.0);
            EXPECT_EQ(at(solid.csg, {along, 0.0, 0.3}).value, at(sharp.csg, {along, 0.0, 0.3}).value);
        }
        EXPECT_LT(at(solid.csg, {0.0, 0.48, 0.3}).value, 0.0);
        // With exponent 2 the fillet is an arc of the radius.
        for (const double angle : {0.1, 0.7, 1.4})
            if (exponent == 2.0) {
                EXPECT_NEAR(at(solid.csg, {0.5 - 0.5 * std::cos(angle), 0.5 - 0.5 * std::sin(angle), 0.0}).value, 0.0,
                            1e-15);
            }
    }
}

TEST(Csg, TheSurfaceIsInItsBox) {
    int looked_at = 0;
    int finite = 0;
    for (std::uint32_t seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE(seed);
        const test::RandomTree tree(seed, 1 + static_cast<int>(seed % 5), true);
        const Solid solid(tree.nodes());
        const implicit::CsgBox box = solid.plan().whole;
        finite += std::isfinite(glm::length(box.high - box.low)) ? 1 : 0;
        const test::Points points = scattered(150, 3.0);
        for (std::size_t k = 0; k + 1 < points.size(); ++k) {
            glm::dvec3 from = points[k];
            glm::dvec3 to = points[k + 1];
            const bool inside = at(solid.csg, from).value < 0.0;
            if (inside == (at(solid.csg, to).value < 0.0)) continue;
            for (int i = 0; i < 30; ++i) {
                const glm::dvec3 middle = 0.5 * (from + to);
                ((at(solid.csg, middle).value < 0.0) == inside ? from : to) = middle;
            }
            ++looked_at;
            for (int i = 0; i < 3; ++i) {
                ASSERT_GE(from[i], box.low[i] - 1e-7) << k;
                ASSERT_LE(from[i], box.high[i] + 1e-7) << k;
            }
        }
    }
    EXPECT_GT(looked_at, 1000);
    EXPECT_GT(finite, 60);
}

TEST(Csg, BoxesAreTight) {
    const auto box_of = [](const Nodes& nodes) { return Solid(nodes).plan().whole; };
    // A cut ball, offset outwards by 0.5.
    Nodes cut{node(CsgKind::offset), node(CsgKind::subtract, 0), ball(1, {1, 0, 0}, 2.0), half_space(1, 0, 0.0)};
    cut[0].distance = 0.5;
    implicit::CsgBox box = box_of(cut);
    EXPECT_NEAR(box.low.x, -0.5, 1e-15);
    EXPECT_NEAR(box.high.x, 3.5, 1e-15);
    EXPECT_NEAR(box.low.z, -2.5, 1e-15);
    // A shell is inside the ball, and the complement of a ball has the ball's surface.
    Nodes shell{node(CsgKind::complement), node(CsgKind::shell, 0), ball(1, {0, 0, 0}, 1.0)};
    shell[1].distance = 0.1;
    EXPECT_NEAR(box_of(shell).high.y, 1.0, 1e-15);
    // Where two surfaces coincide, a blend raises both.
    Nodes twice{node(CsgKind::unite), node(CsgKind::box, 0), node(CsgKind::box, 0)};
    twice[0].blend = 0.3;
    EXPECT_NEAR(at(Solid(twice).csg, {0.0, 0.0, 0.5 + 0.05}).value, 0.0, 1e-15);
    EXPECT_NEAR(box_of(twice).high.z, 0.5 + 0.05, 1e-15);
    twice[0].exponent = 2.0;
    EXPECT_NEAR(box_of(twice).high.z, 0.5 + 0.3 * (1.0 - std::sqrt(0.5)), 1e-15);
    // An intersection may be empty, and a union infinite.
    EXPECT_TRUE(box_of({node(CsgKind::intersect), ball(0, {-2, 0, 0}, 1.0), ball(0, {2, 0, 0}, 1.0)}).empty());
    EXPECT_FALSE(std::isfinite(box_of({node(CsgKind::unite), ball(0, {0, 0, 0}, 1.0), half_space(0, 0, 0.0)}).low.y));
    EXPECT_EQ(box_of({node(CsgKind::unite), ball(0, {0, 0, 0}, 1.0), half_space(0, 0, 0.0)}).high.x, 1.0);
}

// Chains of 10 000 nodes to the left and to the right, sharp and blended, and chains of nodes with one child.
TEST(Csg, DeepTreesNeedFewRegistersAndNoStack) {
    for (const bool right : {false, true})
        for (const double blend : {0.0, 0.01}) {
            constexpr std::int64_t levels = 5000;
            Nodes nodes;
            std::int64_t parent = -1;
            for (std::int64_t i = 0; i < levels; ++i) {
                const auto here = static_cast<std::int64_t>(nodes.size());
                nodes.push_back(node(CsgKind::unite, parent));
                nodes.back().blend = blend;
                if (!right || i + 1 == levels) nodes.push_back(ball(here, {0.001 * static_cast<double>(i), 0, 0}, 1.0));
                if (right) nodes.push_back(ball(here, {0.001 * static_cast<double>(i), 0, 0}, 1.0));
                parent = here;
            }
            const Solid solid(nodes);
            EXPECT_LE(solid.plan().root().registers, 2);
            EXPECT_LE(at(solid.csg, {2.5, 1.0, 0.0}).value, 1e-9);
            if (solid.csg.sheets() != nullptr) {
                EXPECT_GE(active(*solid.csg.sheets(), {2.5, 1.0, 0.0}), 0);
            }
        }
    Nodes nodes;
    for (std::int64_t i = 0; i < 10000; ++i) nodes.push_back(node(CsgKind::complement, i - 1));
    nodes.push_back(ball(9999, {0, 0, 0}, 1.0));
    EXPECT_EQ(at(Solid(nodes).csg, {3.0, 0.0, 0.0}).value, 2.0);
}

TEST(Csg, TooManyPairsOfSheetsBecomeOneSheet) {
    Nodes nodes{node(CsgKind::unite)};
    nodes[0].blend = 0.1;
    for (int i = 0; i < 14; ++i) {
        nodes.push_back(node(CsgKind::box, 0));
        nodes.back().translation.x = i;
    }
    EXPECT_EQ(Solid(nodes).csg.sheets()->count(), 36); // 6^12 would be too many
    nodes.resize(1 + 11);
    EXPECT_EQ(Solid(nodes).csg.sheets()->count(), 362797056);
}

struct Ball {
    glm::dvec3 centre;
    double radius;
    int calls = 0;
    std::int64_t points = 0;
    bool lies = false; // it reaches beyond its box
    static std::int32_t call(void* user, std::int64_t count, const double* p, double* value, double* gradient,
                             double* hessian) {
        auto& self = *static_cast<Ball*>(user);
        ++self.calls;
        self.points += count;
        for (std::int64_t i = 0; i < count; ++i) {
            const glm::dvec3 to = glm::dvec3(p[3 * i], p[3 * i + 1], p[3 * i + 2]) - self.centre;
            value[i] = self.lies && glm::length(to) > 2.5 * self.radius ? -1.0 : glm::length(to) - self.radius;
            for (int c = 0; gradient != nullptr && c < 3; ++c) gradient[3 * i + c] = to[c] / glm::length(to);
            for (int c = 0; hessian != nullptr && c < 6; ++c) hessian[6 * i + c] = 0.0;
        }
        return 0;
    }
    [[nodiscard]] implicit::CustomFunction function() {
        implicit::CustomFunction made;
        made.function = call;
        made.user = this;
        made.has_gradient = made.has_hessian = true;
        made.bounds = {centre - radius, centre + radius};
        return made;
    }
};

TEST(Csg, ModelsEndAtTheirBoxesAndAreSkippedElsewhere) {
    std::vector<Ball> balls;
    for (int i = 0; i < 6; ++i) balls.push_back({{3.0 * i, 0.1 * i, 0.0}, 1.0, 0, 0, true});
    std::vector<std::unique_ptr<implicit::Custom>> own;
    std::vector<const implicit::Implicit*> models;
    Nodes nodes{node(CsgKind::unite)};
    for (Ball& one : balls) {
        own.push_back(std::make_unique<implicit::Custom>(one.function()));
        models.push_back(own.back().get());
        nodes.push_back(node(CsgKind::model, 0));
        nodes.back().model = static_cast<std::int64_t>(models.size() - 1);
        nodes.back().linear = glm::dmat3(0.5);
    }
    for (const auto& [kind, blend, exponent] :
         {std::tuple(CsgKind::unite, 0.0, 0.0), std::tuple(CsgKind::unite, 0.3, 0.0),
          std::tuple(CsgKind::unite, 0.3, 2.0), std::tuple(CsgKind::subtract, 0.0, 0.0),
          std::tuple(CsgKind::subtract, 0.3, 3.0), std::tuple(CsgKind::intersect, 0.0, 0.0)}) {
        nodes[0].kind = kind;
        nodes[0].blend = blend;
        nodes[0].exponent = exponent;
        const Solid solid(nodes, models);
        EXPECT_FALSE(solid.csg.concurrent());
        EXPECT_EQ(solid.csg.lipschitz(), 0.0);
        test::Points points = scattered(500, 10.0);
        for (double& y : points.y) y *= 0.1;
        test::Fields fields(points.size());
        for (Ball& one : balls) one.points = 0;
        solid.csg.evaluate(points.batch(), fields.all());
        std::int64_t asked = 0;
        for (const Ball& one : balls) asked += one.points;
        EXPECT_LT(asked, kind == CsgKind::unite ? 2000 : 3001) << "of 3000";
        for (std::size_t i = 0; i < points.size(); ++i)
            ASSERT_NEAR(fields.value[i], solid.reference.at(points[i]), 1e-12) << i;
    }
}

} // namespace

} // namespace csg_test
