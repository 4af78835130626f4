// SPDX-License-Identifier: MIT
// Tests solids put together from others, through the boundary: values, lifetimes, files, drawings, and every bad
// argument.
#include "fixture.h"
#include "support/csg_nodes.h"
#include "trimmed.h"

#include <cmath>
#include <functional>
#include <limits>

namespace api_test::csg_test {
namespace {

using hrbfnpr::test::csg_part;
using hrbfnpr::test::CsgNodes;

constexpr auto invalid = HRBFNPR_STATUS_INVALID_ARGUMENT;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Model create(const Context& context, const CsgNodes& nodes) {
    Error error;
    const hrbfnpr_csg_desc desc = nodes.desc();
    hrbfnpr_model* model = nullptr;
    EXPECT_OK(hrbfnpr_model_create_csg(context.get(), &desc, &model, error));
    return Model(model);
}

hrbfnpr_csg_info csg_info_of(const Model& model) {
    Error error;
    auto info = made(hrbfnpr_csg_info_init);
    EXPECT_OK(hrbfnpr_model_get_csg_info(model.get(), &info, error));
    return info;
}

hrbfnpr_model_info model_info_of(const Model& model) {
    Error error;
    auto info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(model.get(), &info, error));
    return info;
}

std::vector<double> scattered(int count, double reach) {
    std::vector<double> points;
    for (int i = 0; i < 3 * count; ++i) points.push_back(reach * (0.0008 * ((i * 37) % 2500) - 1.0));
    return points;
}

std::vector<double> values_of(const Model& model, const std::vector<double>& point) {
    Error error;
    std::vector<double> value(point.size() / 3);
    const hrbfnpr_array points = in(point);
    const hrbfnpr_array_out values = out(value, 1);
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &points, &values, nullptr, nullptr, nullptr, error));
    return value;
}

// The value of csg_part() without its blend.
double part_at(const double* p) {
    const auto box = [&](double x, double y, double z, double w, double h, double d) {
        return std::max({std::abs(p[0] - x) - w, std::abs(p[1] - y) - h, std::abs(p[2] - z) - d});
    };
    const double rho = std::hypot(p[0] - 0.7, p[1]);
    const double body = std::min(box(0, 0, 0, 1.5, 1, 0.5), std::max(rho - 0.6, std::abs(p[2] - 0.7) - 0.5));
    return std::max({body, -std::max(rho - 0.3, std::abs(p[2]) - 2.0), -box(-0.9, 0, 0.4, 0.25, 1.5, 0.5)});
}

TEST(CsgModel, HasTheValuesOfItsParts) {
    const Context context = make_context();
    CsgNodes nodes = csg_part();
    nodes.nodes[1].blend = 0.0;
    const Model part = create(context, nodes);
    const std::vector<double> points = scattered(3000, 2.0);
    const std::vector<double> value = values_of(part, points);
    for (std::size_t i = 0; i < value.size(); ++i) ASSERT_NEAR(value[i], part_at(&points[3 * i]), 1e-14) << i;

    const hrbfnpr_model_info info = model_info_of(part);
    EXPECT_EQ(info.kernel, static_cast<std::uint32_t>(HRBFNPR_KERNEL_CSG));
    EXPECT_EQ(info.centres, 0);
    EXPECT_GT(info.bytes, 1000);
    EXPECT_EQ(info.bounds_min[0], -1.5);
    EXPECT_EQ(info.bounds_max[2], 1.2);
    const hrbfnpr_csg_info tree = csg_info_of(part);
    EXPECT_EQ(tree.nodes, 6);
    EXPECT_EQ(tree.depth, 3);
    EXPECT_EQ(tree.models, 0);
    EXPECT_EQ(tree.sheets, 6 + 3 + 3 + 6);
    EXPECT_EQ(tree.lipschitz, 1.0);
    Error error;
    double lipschitz = 0.0;
    EXPECT_OK(hrbfnpr_model_lipschitz(part.get(), &lipschitz, nullptr, error));
    EXPECT_EQ(lipschitz, 1.0);
    EXPECT_EQ(csg_info_of(create(context, csg_part())).sheets, 6 * 3 + 3 + 6);
    Sphere sphere;
    EXPECT_EQ(csg_info_of(custom_sphere(context, sphere)).nodes, 0);
}

TEST(CsgModel, RaysProjectionsAndInsideTestsAreRight) {
    Error error;
    const Context context = make_context();
    CsgNodes nodes = csg_part();
    nodes.nodes[1].blend = 0.0;
    const Model part = create(context, nodes);
    std::vector<double> point = scattered(2000, 1.4);
    const hrbfnpr_array points = in(point);
    std::vector<std::uint8_t> inside(2000);
    const hrbfnpr_array_out insides = out(inside, 1);
    std::int64_t count = 0;
    ASSERT_OK(hrbfnpr_model_contains(part.get(), &points, &insides, &count, nullptr, error));
    EXPECT_GT(count, 300);
    for (std::size_t i = 0; i < inside.size(); ++i) ASSERT_EQ(inside[i], part_at(&point[3 * i]) < 0.0 ? 1 : 0) << i;

    // Rays go straight down, and meet the first change of sign.
    std::vector<double> origin = point;
    for (std::size_t i = 0; i < 2000; ++i) origin[3 * i + 2] = 3.0;
    std::vector<double> direction;
    for (int i = 0; i < 2000; ++i) direction.insert(direction.end(), {0.0, 0.0, -1.0});
    const hrbfnpr_array origins = in(origin);
    const hrbfnpr_array directions = in(direction);
    std::vector<double> t(2000);
    auto hits = made(hrbfnpr_ray_hits_init);
    hits.t = out(t, 1);
    ASSERT_OK(hrbfnpr_model_cast_rays(part.get(), &origins, &directions, nullptr, &hits, nullptr, error));
    int hit = 0;
    for (std::size_t i = 0; i < 2000; ++i) {
        double expected = infinity;
        for (int step = 0; step < 10000 && expected == infinity; ++step) {
            const double p[3] = {origin[3 * i], origin[3 * i + 1], 3.0 - 0.0005 * step};
            if (part_at(p) < 0.0) expected = 0.0005 * step;
        }
        if (expected == infinity) {
            ASSERT_EQ(t[i], infinity) << i;
            continue;
        }
        ++hit;
        ASSERT_NEAR(t[i], expected, 0.00051) << i;
    }
    EXPECT_GT(hit, 700);
}

TEST(CsgModel, CanBeTrimmedByGivenPointsAndSaved) {
    Error error;
    const Context context = make_context();
    CsgNodes nodes;
    nodes.add(HRBFNPR_CSG_SPHERE);
    const Model ball = create(context, nodes);
    hrbfnpr_model* raw = nullptr;
    EXPECT_FAILS(hrbfnpr_model_trim(ball.get(), nullptr, nullptr, &raw, error), invalid, "has no samples");
    const scenes::Samples half = zone(-1.0, 1.0, true);
    auto desc = made(hrbfnpr_trim_desc_init);
    desc.points = in(half.points);
    ASSERT_OK(hrbfnpr_model_trim(ball.get(), &desc, nullptr, &raw, error));
    const Model trimmed(raw);
    EXPECT_EQ(info_of(trimmed).is_trimmed, 1U);
    EXPECT_EQ(csg_info_of(trimmed).nodes, 1);
    const std::vector<std::uint8_t> bytes = saved(trimmed);
    ASSERT_OK(
        hrbfnpr_model_load_memory(context.get(), bytes.data(), static_cast<std::int64_t>(bytes.size()), &raw, error));
    const Model again(raw);
    EXPECT_EQ(info_of(again).is_trimmed, 1U);
    EXPECT_EQ(saved(again), bytes);
}

TEST(CsgModel, ATreeCanBeALeafOfAnotherTree) {
    const Context context = make_context();
    CsgNodes ball;
    ball.add(HRBFNPR_CSG_OFFSET).distance = 0.25;
    ball.add(HRBFNPR_CSG_SPHERE, 0, 0.5, 0.0, 0.0).radius = 0.5;
    // The ball is moved, doubled and taken from a box, once with its tree as a leaf and once with its nodes written
    // out.
    CsgNodes whole;
    CsgNodes parts;
    for (CsgNodes* nodes : {&whole, &parts}) {
        nodes->add(HRBFNPR_CSG_DIFFERENCE);
        nodes->add(HRBFNPR_CSG_BOX, 0).size[0] = 3.0;
    }
    hrbfnpr_csg_node& offset = whole.add(HRBFNPR_CSG_OFFSET, 0, 0.0, 0.5, 0.0);
    offset.distance = 0.25;
    offset.transform[0] = offset.transform[5] = offset.transform[10] = 2.0;
    whole.add(HRBFNPR_CSG_SPHERE, 2, 0.5, 0.0, 0.0).radius = 0.5;
    Model part;
    {
        const Model leaf = create(context, ball);
        hrbfnpr_csg_node& node = parts.add(HRBFNPR_CSG_MODEL, 0, 0.0, 0.5, 0.0);
        node.transform[0] = node.transform[5] = node.transform[10] = 2.0;
        node.model = leaf.get();
        part = create(context, parts);
    }
    const std::vector<double> points = scattered(1000, 2.0);
    const Model plain = create(context, whole);
    EXPECT_EQ(values_of(part, points), values_of(plain, points));
    EXPECT_EQ(csg_info_of(part).nodes, 4);
    EXPECT_EQ(csg_info_of(part).models, 0);
    EXPECT_EQ(saved(part), saved(plain));
}

TEST(CsgModel, HoldsItsLeavesUntilItIsReleased) {
    Error error;
    const Context context = make_context();
    const std::int64_t before = info_of(context).bytes_now;
    Sphere sphere;
    {
        CsgNodes nodes;
        nodes.add(HRBFNPR_CSG_UNION);
        Model both;
        {
            const Model custom = custom_sphere(context, sphere);
            const Model fitted = fit_whole(context, scenes::torus(60));
            nodes.add(HRBFNPR_CSG_MODEL, 0).model = custom.get();
            nodes.add(HRBFNPR_CSG_MODEL, 0, 0.0, 0.0, 2.0).model = fitted.get();
            nodes.add(HRBFNPR_CSG_MODEL, 0, 3.0, 0.0, 0.0).model = custom.get();
            both = create(context, nodes);
        }
        EXPECT_EQ(csg_info_of(both).models, 2);
        EXPECT_EQ(csg_info_of(both).lipschitz, 0.0);
        EXPECT_EQ(csg_info_of(both).sheets, 3 * 7);
        EXPECT_EQ(sphere.releases, 0);
        EXPECT_LT(values_of(both, {3.0, 0.0, 0.0})[0], 0.0);
        EXPECT_GT(values_of(both, {1.5, 0.0, 1.0})[0], 0.0);
        std::int64_t size = 0;
        EXPECT_FAILS(hrbfnpr_model_save_memory(both.get(), nullptr, 0, &size, error), invalid, "custom");
        // The tree of a tree keeps the leaves alive.
        CsgNodes more;
        more.add(HRBFNPR_CSG_COMPLEMENT);
        more.add(HRBFNPR_CSG_MODEL, 0).model = both.get();
        const Model outside = create(context, more);
        both.reset();
        EXPECT_EQ(sphere.releases, 0);
        EXPECT_GT(values_of(outside, {3.0, 0.0, 0.0})[0], 0.0);
    }
    EXPECT_EQ(sphere.releases, 1);
    EXPECT_EQ(info_of(context).bytes_now, before);
}

struct Part {
    CsgNodes nodes = csg_part();
    hrbfnpr_csg_desc desc = nodes.desc();
};
struct Row {
    std::function<void(Part&)> change;
    const char* message;
};

TEST(CsgModel, BadInputIsNamed) {
    const Context context = make_context();
    const std::int64_t before = info_of(context).bytes_now;
    const auto all_space = [](Part& p) { p.nodes.nodes[2].kind = HRBFNPR_CSG_HALF_SPACE; };
    const std::vector<Row> rows{
        {[](Part& p) { p.desc.nodes = nullptr; }, "csg_desc.nodes is NULL"},
        {[](Part& p) { p.desc.node_count = 0; }, "csg_desc.node_count is 0"},
        {[](Part& p) { p.desc.node_count = 65537; }, "csg_desc.node_count is 65537; it must be from 0 to 65536"},
        {[](Part& p) { p.desc.node_stride = 4; }, "csg_desc.node_stride is 4"},
        {[](Part& p) { p.desc.reserved = 1; }, "csg_desc.reserved is 1"},
        {[](Part& p) { p.desc.bounds_min[0] = nan; }, "csg_desc.bounds_min is nan"},
        {[](Part& p) { p.desc.bounds_min[0] = 1.0; },
         "csg_desc.bounds_min[0] is 1, above bounds_max[0], which is 0; swap them"},
        {[](Part& p) { p.desc.bounds_max[2] = 1e200; }, "the bounding box has the diagonal"},
        {[](Part& p) { p.nodes.nodes[0].parent = 0; }, "csg_desc.nodes[0].parent is 0; the first node is the root"},
        {[](Part& p) { p.nodes.nodes[3].parent = 3; },
         "csg_desc.nodes[3].parent is 3; it must be the index of an earlier"},
        {[](Part& p) { p.nodes.nodes[3].parent = -1; }, "csg_desc.nodes[3].parent is -1"},
        {[](Part& p) { p.nodes.nodes[3].parent = 2; },
         "csg_desc.nodes[3].parent is 2, but a node of kind 8 takes no more children than 0"},
        {[](Part& p) { p.nodes.nodes[1].kind = HRBFNPR_CSG_COMPLEMENT; }, "takes no more children than 1"},
        {[](Part& p) { p.nodes.nodes[5].kind = HRBFNPR_CSG_UNION; },
         "csg_desc.nodes[5] is of kind 0 and has no children"},
        {[](Part& p) { p.nodes.nodes[5].kind = 13; }, "csg_desc.nodes[5].kind is 13"},
        {[](Part& p) { p.nodes.nodes[5].kind = HRBFNPR_CSG_MODEL; }, "csg_desc.nodes[5].model is NULL"},
        {[](Part& p) { p.nodes.nodes[2].transform[3] = 1.0; }, "csg_desc.nodes[2].transform has the last row 1 0 0 1"},
        {[](Part& p) { p.nodes.nodes[2].transform[0] = nan; }, "csg_desc.nodes[2].transform is nan"},
        {[](Part& p) { p.nodes.nodes[2].transform[0] = 0.0; }, "csg_desc.nodes[2].transform stretches lengths 0 to"},
        {[](Part& p) { p.nodes.nodes[2].transform[0] = 1e5; }, "csg_desc.nodes[2].transform stretches lengths 1 to"},
        {[](Part& p) { p.nodes.nodes[2].size[1] = 0.0; }, "csg_desc.nodes[2].size is 0"},
        {[](Part& p) { p.nodes.nodes[3].radius = -1.0; }, "csg_desc.nodes[3].radius is -1"},
        {[](Part& p) { p.nodes.nodes[3].height = infinity; }, "csg_desc.nodes[3].height is inf"},
        {[](Part& p) {
             p.nodes.nodes[3].kind = HRBFNPR_CSG_CONE;
             p.nodes.nodes[3].radius = p.nodes.nodes[3].second_radius = 0.0;
         },
         "csg_desc.nodes[3].radius and second_radius are both 0"},
        {[](Part& p) { p.nodes.nodes[3].kind = HRBFNPR_CSG_TORUS, p.nodes.nodes[3].second_radius = 0.6; },
         "csg_desc.nodes[3].second_radius is 0.6; it must be above 0 and below 0.6"},
        {[](Part& p) { p.nodes.nodes[1].blend = -1.0; }, "csg_desc.nodes[1].blend is -1"},
        {[](Part& p) { p.nodes.nodes[1].exponent = 1.5; },
         "csg_desc.nodes[1].exponent is 1.5; it must be 0, or from 2"},
        {[](Part& p) { p.nodes.nodes[0].kind = HRBFNPR_CSG_SHELL, p.desc.node_count = 2; }, "nodes[0].distance is 0"},
        {[](Part& p) { p.nodes.nodes[0].kind = HRBFNPR_CSG_OFFSET, p.nodes.nodes[0].distance = nan; },
         "csg_desc.nodes[0].distance is nan"},
        {all_space, "the surface may be unbounded along x"},
        {[](Part& p) { p.nodes.nodes[4].kind = HRBFNPR_CSG_HALF_SPACE, p.nodes.nodes[4].transform[14] = 9.0; },
         "the solid is empty"},
    };
    for (const Row& row : rows) {
        Error error;
        Part part;
        row.change(part);
        auto* model = reinterpret_cast<hrbfnpr_model*>(&part);
        EXPECT_FAILS(hrbfnpr_model_create_csg(context.get(), &part.desc, &model, error), invalid, row.message);
        EXPECT_EQ(model, nullptr) << row.message;
    }
    // With bounds any tree is accepted.
    Error error;
    Part part;
    all_space(part);
    for (int axis = 0; axis < 3; ++axis) part.desc.bounds_min[axis] = -(part.desc.bounds_max[axis] = 2.0);
    hrbfnpr_model* model = nullptr;
    EXPECT_OK(hrbfnpr_model_create_csg(context.get(), &part.desc, &model, error));
    hrbfnpr_model_release(model);
    EXPECT_FAILS(hrbfnpr_model_create_csg(nullptr, &part.desc, &model, error), invalid, "context is NULL");
    EXPECT_FAILS(hrbfnpr_model_create_csg(context.get(), nullptr, &model, error), invalid, "csg_desc is NULL");
    EXPECT_FAILS(hrbfnpr_model_create_csg(context.get(), &part.desc, nullptr, error), invalid, "out_model is NULL");
    EXPECT_FAILS(hrbfnpr_model_get_csg_info(nullptr, nullptr, error), invalid, "model is NULL");
    EXPECT_EQ(info_of(context).bytes_now, before);
}

TEST(CsgModel, ATrimmedLeafIsRefused) {
    Error error;
    const Context context = make_context();
    const Model open = fit(context, zone(-1.0, 1.0, true));
    ASSERT_EQ(info_of(open).is_trimmed, 1U);
    CsgNodes nodes;
    nodes.add(HRBFNPR_CSG_MODEL).model = open.get();
    const hrbfnpr_csg_desc desc = nodes.desc();
    hrbfnpr_model* model = nullptr;
    EXPECT_FAILS(hrbfnpr_model_create_csg(context.get(), &desc, &model, error), invalid,
                 "csg_desc.nodes[0].model is trimmed");
    const Model closed = fit(context, scenes::torus(200)); // tested for an end, and left whole
    nodes.nodes[0].model = closed.get();
    create(context, nodes);
}

TEST(CsgModel, TooManyNodesAreRefused) {
    const Context context = make_context();
    CsgNodes nodes;
    nodes.add(HRBFNPR_CSG_SPHERE);
    Model model = create(context, nodes);
    std::string message;
    for (int i = 0; i < 20 && message.empty(); ++i) {
        CsgNodes twice;
        twice.add(HRBFNPR_CSG_UNION);
        twice.add(HRBFNPR_CSG_MODEL, 0).model = model.get();
        twice.add(HRBFNPR_CSG_MODEL, 0, 0.1 * i, 0.0, 0.0).model = model.get();
        const hrbfnpr_csg_desc desc = twice.desc();
        hrbfnpr_model* next = nullptr;
        Error error;
        if (hrbfnpr_model_create_csg(context.get(), &desc, &next, error) != HRBFNPR_STATUS_OK)
            message = error.record.message;
        model.reset(next);
    }
    EXPECT_NE(message.find("more than 65536 nodes"), std::string::npos) << message;
}

TEST(CsgModel, IsDrawnWithItsContours) {
    Error error;
    const Context context = make_context();
    const Model part = create(context, csg_part());
    Generation desc = small_desc();
    const PointSet set = generate(context, part, desc);
    EXPECT_GT(layer_info(set, 0).marks, 50);
    for (const float z : attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION)) EXPECT_LT(std::abs(z), 1.51F);
    hrbfnpr_line_set* made_set = nullptr;
    ASSERT_OK(hrbfnpr_line_set_create(context.get(), part.get(), nullptr, nullptr, &made_set, error));
    const hrbfnpr::test::LineSet lines(made_set);
    const Renderer renderer = make_renderer(context);
    hrbfnpr_item item = item_of(set);
    item.model = part.get();
    item.line_set = lines.get();
    const Drawing drawing = draw_item(renderer, item, front_camera(128.0));
    const std::vector<std::uint8_t> pixels = rasterize(drawing, 128);
    int dark = 0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) dark += pixels[i] < 128 ? 1 : 0;
    EXPECT_GT(dark, 100);
    EXPECT_LT(dark, 128 * 64);
}

// The sides of both cylinders are one function, and the gap between them is so small that a step of a contour could
// cross it.
TEST(CsgModel, ContoursDoNotCrossTheGapBetweenCoaxialCylinders) {
    Error error;
    const Context context = make_context();
    CsgNodes bars;
    bars.add(HRBFNPR_CSG_UNION);
    for (const double z : {0.0, 3.4}) bars.add(HRBFNPR_CSG_CYLINDER, 0, 0.0, 0.0, z).height = 3.0;
    for (std::size_t i = 1; i < 3; ++i) bars.nodes[i].radius = 0.5;
    const Model model = create(context, bars);
    hrbfnpr_line_set* made_set = nullptr;
    ASSERT_OK(hrbfnpr_line_set_create(context.get(), model.get(), nullptr, nullptr, &made_set, error));
    const hrbfnpr::test::LineSet lines(made_set);
    Generation desc = small_desc();
    const PointSet set = generate(context, model, desc);
    hrbfnpr_style style;
    ASSERT_OK(hrbfnpr_style_init_preset(&style, sizeof style, HRBFNPR_PRESET_SILHOUETTE, error));
    hrbfnpr_item item = item_of(set, &style);
    item.model = model.get();
    item.line_set = lines.get();
    auto camera = made(hrbfnpr_camera_init);
    const double eye[3] = {0.0, -10.0, 1.7};
    const double target[3] = {0.0, 0.0, 1.7};
    const double up[3] = {0.0, 0.0, 1.0};
    constexpr int side = 256; // 25.6 pixels per unit
    ASSERT_OK(hrbfnpr_camera_look_at(&camera, eye, target, up, error));
    ASSERT_OK(hrbfnpr_camera_orthographic(&camera, 10.0, side, side, 1.0, 20.0, error));
    const Renderer renderer = make_renderer(context);
    const std::vector<std::uint8_t> pixels = rasterize(draw_item(renderer, item, camera), side);
    const auto dark_rows = [&](int begin, int end) {
        int dark = 0;
        for (int i = 4 * side * begin; i < 4 * side * end; i += 4) dark += pixels[static_cast<std::size_t>(i)] < 128;
        return dark;
    };
    EXPECT_GT(dark_rows(44, 212), 500); // from z = 5 down to -1.6
    EXPECT_EQ(dark_rows(0, 43), 0);     // above 4.9
    EXPECT_EQ(dark_rows(214, side), 0); // below -1.5
}

} // namespace
} // namespace api_test::csg_test
