// SPDX-License-Identifier: MIT
// Groups of minima and maxima give the same bits as operations pair by pair, and evaluate fewer operands.
#include "csg_nodes.h"

#include "implicit/csg.h"
#include "implicit/custom.h"
#include "implicit/evaluate_all.h"

#include <gtest/gtest.h>

#include <cstring>
#include <set>

namespace csg_groups_test {

namespace base = hrbfnpr::base;
namespace geometry = hrbfnpr::geometry;
namespace implicit = hrbfnpr::implicit;
using Groups = implicit::CsgPlan::Groups;
using test::CsgKind;
using test::CsgNode;
using test::node;
using test::Nodes;
using test::scattered;

namespace {

const base::Runtime& shared() {
    static const auto& runtime = *new base::Runtime;
    return runtime;
}

// A wavy ball that reaches beyond its box. It counts the points at which it is evaluated.
struct Lump {
    double radius = 1.0;
    std::int64_t asked = 0;

    static std::int32_t call(void* user, std::int64_t count, const double* p, double* value, double* gradient,
                             double* hessian) {
        auto& self = *static_cast<Lump*>(user);
        self.asked += count;
        for (std::int64_t i = 0; i < count; ++i) {
            const glm::dvec3 at(p[3 * i], p[3 * i + 1], p[3 * i + 2]);
            value[i] =
                glm::length(at) - self.radius + 0.05 * std::sin(9.0 * at.x) - (glm::length(at) > 2.5 ? 9.0 : 0.0);
            for (int c = 0; gradient != nullptr && c < 3; ++c) gradient[3 * i + c] = at[c] + 0.1 * value[i];
            for (int c = 0; hessian != nullptr && c < 6; ++c) hessian[6 * i + c] = at.x + c;
        }
        return 0;
    }
    [[nodiscard]] implicit::CustomFunction function() {
        implicit::CustomFunction made;
        made.function = call;
        made.user = this;
        made.has_gradient = made.has_hessian = true;
        made.bounds = {glm::dvec3(-radius), glm::dvec3(radius)};
        return made;
    }
};

// One tree, with groups and without.
class Both {
public:
    Both(const Nodes& nodes, Groups groups, const std::vector<const implicit::Implicit*>& models = {})
        : quick_(plan(nodes, models, groups)), plain_(plan(nodes, models, Groups::never)), quick(csg(quick_, models)),
          plain(csg(plain_, models)) {}

    [[nodiscard]] std::int32_t nested() const { return quick_.nested; }

private:
    static implicit::CsgPlan plan(const Nodes& nodes, const std::vector<const implicit::Implicit*>& models,
                                  Groups groups) {
        base::Array<implicit::CsgModel> known(shared().memory);
        for (const implicit::Implicit* model : models)
            known.push_back({model->bounds(), model->bounds().grown(0.05 * model->diagonal()), 1, 0.0});
        return {shared().memory, test::tree_of(shared().memory, nodes), known, groups};
    }
    static implicit::Csg csg(const implicit::CsgPlan& plan, const std::vector<const implicit::Implicit*>& models) {
        base::Array<const implicit::Implicit*> leaves(shared().memory);
        for (const implicit::Implicit* model : models) leaves.push_back(model);
        return {shared(), plan, std::move(leaves), {glm::dvec3(-1.0), glm::dvec3(1.0)}};
    }

    implicit::CsgPlan quick_, plain_;

public:
    implicit::Csg quick, plain;
};

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
    return std::memcmp(a.data(), b.data(), a.size() * sizeof(double)) == 0;
}

void expect_same(const Both& both, const test::Points& points) {
    test::Fields quick(points.size());
    test::Fields plain(points.size());
    both.quick.evaluate(points.batch(), quick.all());
    both.plain.evaluate(points.batch(), plain.all());
    EXPECT_TRUE(same_bits(quick.value, plain.value));
    for (std::size_t c = 0; c < 3; ++c) EXPECT_TRUE(same_bits(quick.gradient[c], plain.gradient[c])) << c;
    for (std::size_t c = 0; c < 6; ++c) EXPECT_TRUE(same_bits(quick.hessian[c], plain.hessian[c])) << c;
    test::Fields values(points.size());
    both.quick.evaluate(points.batch(), values.batch(true, false, false));
    EXPECT_TRUE(same_bits(values.value, plain.value));
    const implicit::Sheets* const one = both.quick.sheets();
    const implicit::Sheets* const other = both.plain.sheets();
    ASSERT_EQ(one == nullptr, other == nullptr);
    if (one == nullptr || other == nullptr) return;
    std::vector<std::int32_t> active(points.size());
    std::vector<std::int32_t> expected(points.size());
    one->active(points.batch(), active.data());
    other->active(points.batch(), expected.data());
    EXPECT_EQ(active, expected);
    one->evaluate(active[0], points.batch(), quick.all());
    other->evaluate(active[0], points.batch(), plain.all());
    EXPECT_TRUE(same_bits(quick.value, plain.value));
}

TEST(CsgGroups, RandomTreesGiveTheSameBits) {
    int nested = 0;
    for (std::uint32_t seed = 0; seed < 400 && !HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        const Both both(test::RandomTree(seed, 2 + static_cast<int>(seed % 5), seed % 3 == 0).nodes(), Groups::always);
        nested += both.nested() > 1 ? 1 : 0;
        expect_same(both, scattered(300, 2.5));
        expect_same(both, scattered(40, 1e7)); // far away, where rounding is largest
    }
    EXPECT_GT(nested, 60);
}

// The leaves are replaced by models that reach beyond their boxes.
TEST(CsgGroups, TreesOfModelsGiveTheSameBits) {
    std::vector<Lump> lumps(3);
    lumps[1].radius = 0.4;
    lumps[2].radius = 1.6;
    std::vector<std::unique_ptr<implicit::Custom>> own;
    std::vector<const implicit::Implicit*> models;
    for (Lump& lump : lumps) {
        own.push_back(std::make_unique<implicit::Custom>(lump.function()));
        models.push_back(own.back().get());
    }
    for (std::uint32_t seed = 0; seed < 300 && !HasFailure(); ++seed) {
        SCOPED_TRACE(seed);
        Nodes nodes = test::RandomTree(1000 + seed, 2 + static_cast<int>(seed % 4), seed % 2 == 0).nodes();
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (implicit::is_leaf(nodes[i].kind) && i % 3 != 0) {
                nodes[i].kind = CsgKind::model;
                nodes[i].model = static_cast<std::int64_t>((i + seed) % 3);
            }
        for (const Groups groups : {Groups::always, Groups::where_they_pay})
            expect_same(Both(nodes, groups, models), scattered(300, 2.5));
    }
}

// If operands are equal everywhere, the sheets of the first one count. Zeros keep their signs.
TEST(CsgGroups, EqualOperandsKeepTheirOrder) {
    for (const CsgKind kind : {CsgKind::unite, CsgKind::intersect, CsgKind::subtract}) {
        Nodes nodes{node(kind)};
        for (int i = 0; i < 40; ++i) {
            nodes.push_back(node(i % 2 == 0 ? CsgKind::box : CsgKind::cylinder, 0));
            nodes.back().translation.x =
                0.1 * (i / 4); // inexact in binary: a rounded lower bound must not exceed the values
            nodes.back().linear = glm::dmat3(0.7);
        }
        test::Points points = scattered(300, 3.0);
        for (int i = -20; i < 20; ++i) points.add({0.25 * i, 0.35, 0.35});
        const Both both(nodes, Groups::where_they_pay);
        EXPECT_EQ(both.nested(), 1);
        expect_same(both, points);
    }
}

TEST(CsgGroups, AlternatingTreesOfAnyDepthNeedNoMoreStack) {
    Nodes nodes;
    for (std::int64_t i = 0, parent = -1; i < 3000; ++i) {
        const auto here = static_cast<std::int64_t>(nodes.size());
        nodes.push_back(node(i % 2 == 0 ? CsgKind::unite : CsgKind::intersect, parent));
        for (int k = 0; k < 2; ++k) {
            nodes.push_back(node(CsgKind::sphere, here));
            nodes.back().translation = {0.01 * static_cast<double>(i % 100), 0.3 * k, 0.0};
        }
        parent = here;
    }
    const Both both(nodes, Groups::always);
    EXPECT_EQ(both.nested(), 8);
    expect_same(both, scattered(50, 2.0));
}

// In a grid of models, each place near a surface evaluates little more than one model.
TEST(CsgGroups, OnlyModelsThatCanBeTheMinimumAreEvaluated) {
    Lump lump;
    const implicit::Custom model(lump.function());
    for (const CsgKind kind : {CsgKind::unite, CsgKind::subtract})
        for (const int side : {2, 4, 8}) {
            SCOPED_TRACE(side);
            Nodes nodes{node(kind)};
            if (kind == CsgKind::subtract) {
                nodes.push_back(node(CsgKind::box, 0));
                nodes.back().size = glm::dvec3(3.0 * side);
            }
            test::Points points;
            for (int i = 0; i < side * side * side; ++i) {
                nodes.push_back(node(CsgKind::model, 0));
                nodes.back().model = 0;
                const glm::dvec3 centre = 2.2 * glm::dvec3(i % side, i / side % side, i / side / side);
                nodes.back().translation = centre;
                for (int k = 0; k < 4; ++k) {
                    const int n = 3 * (4 * i + k);
                    const glm::dvec3 off(test::scatter(n), test::scatter(n + 1), test::scatter(n + 2));
                    points.add(centre + (1.0 + 0.02 * test::scatter(n + 7)) * glm::normalize(off));
                }
            }
            const Both both(nodes, Groups::where_they_pay, {&model});
            lump.asked = 0;
            std::vector<double> value(points.size());
            implicit::FieldBatch fields;
            fields.value = value.data();
            both.quick.evaluate(points.batch(), fields);
            EXPECT_LE(static_cast<double>(lump.asked), 1.3 * static_cast<double>(points.size()));
            expect_same(both, points);
        }
}

// Complements are never left out, because no bound of their f is known.
TEST(CsgGroups, ComplementsOfModelsAreAlwaysEvaluated) {
    Lump lump;
    const implicit::Custom model(lump.function());
    Nodes nodes{node(CsgKind::unite)};
    for (int i = 0; i < 4; ++i) {
        nodes.push_back(node(CsgKind::complement, 0));
        nodes.back().translation.x = 3.0 * i;
        nodes.push_back(node(CsgKind::model, static_cast<std::int64_t>(nodes.size()) - 1));
        nodes.back().model = 0;
    }
    expect_same(Both(nodes, Groups::where_they_pay, {&model}), scattered(400, 8.0));
}

// Models without cells of their own are cells, so that nearby points are evaluated together.
TEST(CsgGroups, PointsAreOrderedByTheirNearestModel) {
    Lump lump;
    const implicit::Custom model(lump.function());
    Nodes nodes{node(CsgKind::unite)};
    for (int i = 0; i < 200; ++i) {
        nodes.push_back(node(CsgKind::model, 0));
        nodes.back().model = 0;
        nodes.back().translation.x = 3.0 * i;
    }
    const Both both(nodes, Groups::where_they_pay, {&model});
    EXPECT_EQ(both.quick.cells(), 200);
    std::set<std::int32_t> cells;
    for (int i = 0; i < 200; ++i) {
        cells.insert(both.quick.cell_of({3.0 * i, 0.0, 0.0}));
        EXPECT_EQ(both.quick.cell_of({3.0 * i + 0.9, 0.5, -0.5}), both.quick.cell_of({3.0 * i, 0.0, 0.0}));
    }
    EXPECT_EQ(cells.size(), 200U);
    for (const int count : {2, 3000}) { // more cells than points, and fewer cells
        hrbfnpr::geometry::VecArray points(shared().memory);
        for (int i = 0; i < count; ++i) points.push_back({300.0 + 300.0 * test::scatter(i), 0.0, 0.0});
        const base::Array<std::int32_t> order = implicit::order_by_cell(shared(), both.quick, points);
        ASSERT_EQ(order.size(), count);
        for (int i = 1; i < count; ++i) {
            const std::int32_t before = both.quick.cell_of(points[order[i - 1]]);
            const std::int32_t cell = both.quick.cell_of(points[order[i]]);
            EXPECT_TRUE(before < cell || (before == cell && order[i - 1] < order[i]));
        }
    }
}

} // namespace

} // namespace csg_groups_test
