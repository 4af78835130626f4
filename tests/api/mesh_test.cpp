// SPDX-License-Identifier: MIT
// Tests meshes through the C boundary.
#include "fixture.h"
#include "support/meshes.h"

#include <cmath>
#include <limits>
#include <string>

namespace api_test::mesh_test {
namespace {

using hrbfnpr::test::icosphere;
using hrbfnpr::test::torus;
using hrbfnpr::test::Triangles;

hrbfnpr_mesh_desc mesh_desc(const Triangles& from) {
    auto desc = made(hrbfnpr_mesh_desc_init);
    desc.vertices = in(from.vertices);
    desc.triangles = in(from.triangles);
    return desc;
}

Mesh mesh_of(const Context& context, const Triangles& from) {
    Error error;
    const hrbfnpr_mesh_desc desc = mesh_desc(from);
    hrbfnpr_mesh* mesh = nullptr;
    EXPECT_OK(hrbfnpr_mesh_create(context.get(), &desc, nullptr, &mesh, error));
    return Mesh(mesh);
}

hrbfnpr_mesh_info info_of(const Mesh& mesh) {
    Error error;
    auto info = made(hrbfnpr_mesh_info_init);
    EXPECT_OK(hrbfnpr_mesh_get_info(mesh.get(), &info, error));
    return info;
}

TEST(Mesh, InfoDescribesTheMesh) {
    const Context context = make_context();
    const Triangles from = torus(30, 12, 0.4).unwelded().turned();
    const Mesh mesh = mesh_of(context, from);
    const hrbfnpr_mesh_info info = info_of(mesh);
    EXPECT_EQ(info.closed, 1U);
    EXPECT_EQ(info.given_faces, 720);
    EXPECT_EQ(info.given_vertices, 2160);
    EXPECT_EQ(info.vertices, 360);
    EXPECT_EQ(info.welded_vertices, 1800);
    EXPECT_EQ(info.turned_components, 1);
    EXPECT_EQ(info.genus, 1);
    EXPECT_GT(info.volume, 2.5);
    EXPECT_EQ(info.bounds_max[2], 0.4);
    EXPECT_GT(info.bytes, 720 * 100);
    EXPECT_EQ(info.creases, 0U);
}

TEST(Mesh, TakesIndicesOfAllTypes) {
    const Context context = make_context();
    const Triangles from = icosphere(2);
    const std::vector<std::int64_t> wide(from.triangles.begin(), from.triangles.end());
    const std::vector<std::uint32_t> plain(from.triangles.begin(), from.triangles.end());
    for (const hrbfnpr_array& triangles : {in(wide), in(plain), in(from.triangles)}) {
        Error error;
        hrbfnpr_mesh_desc desc = mesh_desc(from);
        desc.triangles = triangles;
        hrbfnpr_mesh* raw = nullptr;
        ASSERT_OK(hrbfnpr_mesh_create(context.get(), &desc, nullptr, &raw, error));
        const Mesh mesh(raw);
        EXPECT_EQ(info_of(mesh).faces, 320);
    }
    const std::vector<float> floats(from.vertices.begin(), from.vertices.end());
    hrbfnpr_mesh_desc desc = mesh_desc(from);
    desc.vertices = in(floats);
    Error error;
    hrbfnpr_mesh* raw = nullptr;
    ASSERT_OK(hrbfnpr_mesh_create(context.get(), &desc, nullptr, &raw, error));
    EXPECT_EQ(info_of(Mesh(raw)).genus, 0);
}

TEST(Mesh, GivesViewsOfItsVerticesAndFaces) {
    const Context context = make_context();
    const Triangles from = icosphere(2).with(icosphere(1).moved(0.5, 0, 0, 0)).with(icosphere(1).moved(1, 5, 0, 0));
    const Mesh mesh = mesh_of(context, from);
    EXPECT_EQ(info_of(mesh).left_out_faces, 80);
    Error error;
    hrbfnpr_array view{};
    EXPECT_OK(hrbfnpr_mesh_view(mesh.get(), HRBFNPR_MESH_ATTRIBUTE_VERTEX, &view, error));
    EXPECT_EQ(view.count, 162 + 42);
    EXPECT_EQ(static_cast<const double*>(view.data)[4], from.vertices[4]);
    EXPECT_OK(hrbfnpr_mesh_view(mesh.get(), HRBFNPR_MESH_ATTRIBUTE_GIVEN_FACE, &view, error));
    EXPECT_EQ(view.scalar, static_cast<std::uint32_t>(HRBFNPR_SCALAR_INT32));
    EXPECT_EQ(static_cast<const std::int32_t*>(view.data)[320], 400);
    EXPECT_OK(hrbfnpr_mesh_view(mesh.get(), HRBFNPR_MESH_ATTRIBUTE_COMPONENT, &view, error));
    EXPECT_EQ(static_cast<const std::int32_t*>(view.data)[399], 1);
    EXPECT_OK(hrbfnpr_mesh_view(mesh.get(), HRBFNPR_MESH_ATTRIBUTE_CORNER_NORMAL, &view, error));
    EXPECT_EQ(view.components, 9U);
    EXPECT_OK(hrbfnpr_mesh_view(mesh.get(), HRBFNPR_MESH_ATTRIBUTE_TRIANGLE, &view, error));
    EXPECT_EQ(view.count, 400);
    EXPECT_FAILS(hrbfnpr_mesh_view(mesh.get(), 5, &view, error), HRBFNPR_STATUS_INVALID_ARGUMENT, "attribute is 5");
}

TEST(Mesh, RefusesInvalidMeshes) {
    const Context context = make_context();
    Error error;
    Triangles from = icosphere(1);
    hrbfnpr_mesh* mesh = nullptr;
    const auto expect = [&](const hrbfnpr_mesh_desc& desc, const char* part) {
        EXPECT_FAILS(hrbfnpr_mesh_create(context.get(), &desc, nullptr, &mesh, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                     part);
        EXPECT_EQ(mesh, nullptr);
    };
    from.triangles[31] = 42;
    expect(mesh_desc(from), "triangles[10] has the index 42; there are 42 vertices, numbered from 0 to 41");
    from = icosphere(1);
    from.vertices[30] = std::numeric_limits<double>::quiet_NaN();
    expect(mesh_desc(from), "vertices[10], a corner of triangles[");
    from.vertices[30] = 1e61;
    expect(mesh_desc(from), "at most 1e60");
    from = icosphere(1);
    hrbfnpr_mesh_desc desc = mesh_desc(from);
    desc.triangles = {};
    expect(desc, "mesh_desc.triangles is empty");
    desc = mesh_desc(from);
    desc.vertices.count = 0;
    expect(desc, "mesh_desc.vertices is empty");
    desc = mesh_desc(from);
    desc.triangles.scalar = HRBFNPR_SCALAR_FLOAT32;
    expect(desc, "mesh_desc.triangles.scalar is 1; it must be HRBFNPR_SCALAR_INT32, _INT64 or _UINT32");
    desc = mesh_desc(from);
    desc.crease_angle = 181.0;
    expect(desc, "mesh_desc.crease_angle is 181");
    desc = mesh_desc(from);
    desc.parts = 5;
    expect(desc, "mesh_desc.parts is 5");
    for (double& number : from.vertices) number *= 1e-70;
    expect(mesh_desc(from), "across; it must be at least 1e-60");
}

TEST(Mesh, SamplesLieOnTheSurface) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, icosphere(4));
    Error error;
    std::vector<double> points(300), normals(300), again(300);
    std::vector<float> floats(300);
    const hrbfnpr_array_out to = out(points), along = out(normals), second = out(again), single = out(floats);
    ASSERT_OK(hrbfnpr_mesh_sample(mesh.get(), nullptr, &to, &along, nullptr, error));
    for (std::size_t i = 0; i < 300; ++i) EXPECT_NEAR(points[i], normals[i], 0.01);
    ASSERT_OK(hrbfnpr_mesh_sample(mesh.get(), nullptr, &second, nullptr, nullptr, error));
    EXPECT_EQ(points, again);
    ASSERT_OK(hrbfnpr_mesh_sample(mesh.get(), nullptr, &single, nullptr, nullptr, error));
    EXPECT_EQ(floats[7], static_cast<float>(points[7]));
    auto desc = made(hrbfnpr_sample_desc_init);
    desc.random_seed = 2;
    ASSERT_OK(hrbfnpr_mesh_sample(mesh.get(), &desc, &second, nullptr, nullptr, error));
    EXPECT_NE(points, again);
    EXPECT_FAILS(hrbfnpr_mesh_sample(mesh.get(), &desc, nullptr, &along, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "points is NULL");
    hrbfnpr_array_out none = to;
    none.count = 0;
    EXPECT_FAILS(hrbfnpr_mesh_sample(mesh.get(), &desc, &none, nullptr, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "points.count is 0; it must be from 1 to 10000000");
    const Operation operation = make_operation(context);
    hrbfnpr_operation_cancel(operation.get());
    EXPECT_FAILS(hrbfnpr_mesh_sample(mesh.get(), &desc, &to, nullptr, operation.get(), error), HRBFNPR_STATUS_CANCELLED,
                 "");
}

TEST(FarthestPoints, AreOrderedByFallingDistance) {
    const Context context = make_context();
    Error error;
    const std::vector<double> points{0, 0, 0, 1, 0, 0, 9, 0, 0, 5, 0, 0};
    const hrbfnpr_array from = in(points);
    std::vector<std::int64_t> wide(4);
    std::vector<std::uint32_t> few(2);
    std::vector<double> distance(4);
    const hrbfnpr_array_out to = out(wide, 1), apart = out(distance, 1), two = out(few, 1);
    ASSERT_OK(hrbfnpr_farthest_points(context.get(), &from, &to, &apart, nullptr, error));
    EXPECT_EQ(wide, (std::vector<std::int64_t>{3, 0, 2, 1}));
    EXPECT_EQ(distance, (std::vector<double>{HUGE_VAL, 5.0, 4.0, 1.0}));
    ASSERT_OK(hrbfnpr_farthest_points(context.get(), &from, &two, nullptr, nullptr, error));
    EXPECT_EQ(few, (std::vector<std::uint32_t>{3, 0}));
    wide.resize(5);
    const hrbfnpr_array_out five = out(wide, 1);
    EXPECT_FAILS(hrbfnpr_farthest_points(context.get(), &from, &five, nullptr, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "indices.count is 5; it must be from 1 to the number of points, 4");
    const std::vector<double> bad{0, 0, 0, 1, std::numeric_limits<double>::infinity(), 0};
    const hrbfnpr_array wrong = in(bad);
    EXPECT_FAILS(hrbfnpr_farthest_points(context.get(), &wrong, &two, nullptr, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "points[1] has the coordinate inf");
}

TEST(FitMesh, ReachesAndReportsItsTolerance) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, torus(100, 40, 0.4));
    Error error;
    auto info = made(hrbfnpr_mesh_fit_info_init);
    hrbfnpr_model* raw = nullptr;
    const Operation operation = make_operation(context);
    ASSERT_OK(hrbfnpr_model_fit_mesh(mesh.get(), nullptr, nullptr, &info, operation.get(), &raw, error));
    const Model model(raw);
    EXPECT_EQ(hrbfnpr_operation_progress(operation.get()), 1.0);
    EXPECT_EQ(info.reached, 1U);
    EXPECT_EQ(info.supported, 0U);
    auto model_info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(model.get(), &model_info, error));
    EXPECT_EQ(model_info.centres, info.centres);
    EXPECT_EQ(model_info.samples, info.candidates);
    auto desc = made(hrbfnpr_compare_desc_init);
    desc.points = 2000;
    auto compared = made(hrbfnpr_comparison_init);
    ASSERT_OK(hrbfnpr_model_compare_mesh(model.get(), mesh.get(), &desc, &compared, nullptr, error));
    EXPECT_EQ(compared.tolerance, info.tolerance);
    EXPECT_GE(compared.mesh_share, 0.99);
    EXPECT_GE(compared.surface_share, 0.99);
    EXPECT_EQ(compared.genus, 1);
    EXPECT_EQ(compared.mesh_points, 2000);
    // A model outlives its mesh, and is saved like any other.
    std::int64_t size = 0;
    EXPECT_EQ(hrbfnpr_model_save_memory(model.get(), nullptr, 0, &size, error), HRBFNPR_STATUS_BUFFER_TOO_SMALL);
    EXPECT_GT(size, 48 * info.centres);
}

// The mesh is half of a torus. The surface ends with it, unless trimming is off.
TEST(FitMesh, EndsWithAnOpenMesh) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, torus(100, 40, 0.4).where([](double x, double, double) { return x > 0.0; }));
    Error error;
    for (const std::uint32_t trim : {HRBFNPR_TRIM_AUTO, HRBFNPR_TRIM_NEVER}) {
        auto desc = made(hrbfnpr_mesh_fit_desc_init);
        desc.tolerance = 0.02;
        auto fit = made(hrbfnpr_fit_desc_init);
        fit.trim = trim;
        hrbfnpr_model* raw = nullptr;
        ASSERT_OK(hrbfnpr_model_fit_mesh(mesh.get(), &desc, &fit, nullptr, nullptr, &raw, error));
        const Model model(raw);
        const PointSet set = generate(context, model, hrbfnpr::test::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 4000));
        hrbfnpr_array view{};
        ASSERT_OK(hrbfnpr_point_set_view(set.get(), 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &view, error));
        auto info = made(hrbfnpr_point_set_info_init);
        ASSERT_OK(hrbfnpr_point_set_get_info(set.get(), &info, error));
        double least = 1.0;
        for (std::int64_t i = 0; i < view.count; ++i)
            least = std::min(least, info.origin[0] + double{static_cast<const float*>(view.data)[3 * i]});
        if (trim == HRBFNPR_TRIM_AUTO) {
            EXPECT_GT(least, -0.05); // 0.009 of 3.9 diagonals, and some
            EXPECT_LT(least, 0.05);
        } else {
            EXPECT_LT(least, -0.1);
        }
    }
}

// Returns the warnings of a fit.
std::vector<std::string> warnings_of(const Triangles& parts, std::uint32_t edges, double tolerance) {
    std::vector<std::string> messages;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.log_level = HRBFNPR_LOG_WARNING;
    desc.log_user = &messages;
    desc.log = [](void* user, std::int32_t, const char* message) {
        static_cast<std::vector<std::string>*>(user)->emplace_back(message);
    };
    Error error;
    hrbfnpr_context* raw_context = nullptr;
    EXPECT_OK(hrbfnpr_context_create(&desc, &raw_context, error));
    const Context context(raw_context);
    const Mesh mesh = mesh_of(context, parts);
    auto fit = made(hrbfnpr_mesh_fit_desc_init);
    fit.tolerance = tolerance;
    fit.edges = edges;
    auto info = made(hrbfnpr_mesh_fit_info_init);
    hrbfnpr_model* raw = nullptr;
    EXPECT_OK(hrbfnpr_model_fit_mesh(mesh.get(), &fit, nullptr, &info, nullptr, &raw, error));
    EXPECT_EQ(info.sheets > 1, edges == HRBFNPR_EDGES_SHARP);
    Model(raw).reset();
    // The info reports the same as the warning.
    const bool is_told = !messages.empty() && messages[0].find("mesh fit: parts ") == 0;
    EXPECT_EQ(info.touching_parts[0] + info.touching_parts[1], is_told ? 0 + 1 : -1 - 1);
    EXPECT_EQ(info.parts_may_cross != 0, is_told && messages[0].find("cross or are nearer") != std::string::npos);
    return messages;
}

// Two parts side by side are judged by the gap between them. Crossing parts do not matter if they are fitted apart.
TEST(FitMesh, WarnsOfPartsThatItMayJoin) {
    const auto says = [](const std::vector<std::string>& messages) {
        return !messages.empty() && messages[0].find("mesh fit: parts ") == 0 &&
               messages[0].find("are nearer than the tolerance") != std::string::npos;
    };
    const Triangles ring = torus(60, 24, 0.4);
    const Triangles cube = hrbfnpr::test::box(1.0, 1.0, 1.0, 2);
    for (const double gap : {0.005, 0.2}) {
        EXPECT_EQ(says(warnings_of(ring.with(ring.moved(1.0, 0.0, 0.0, 0.8 + gap)), HRBFNPR_EDGES_AUTO, 0.02)),
                  gap < 0.02);
        EXPECT_EQ(says(warnings_of(cube.with(cube.moved(1.0, 1.0 + gap, 0.3, 0.2)), HRBFNPR_EDGES_SHARP, 0.02)),
                  gap < 0.02);
    }
    const Triangles crossing = cube.with(cube.moved(1.0, 0.99, 0.99, 0.99));
    EXPECT_TRUE(warnings_of(crossing, HRBFNPR_EDGES_SHARP, 0.001).empty());
    EXPECT_TRUE(says(warnings_of(crossing, HRBFNPR_EDGES_SMOOTH, 0.01)));
}

TEST(FitMesh, TakesTheOptionsOfAFit) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, torus(60, 24, 0.4));
    Error error;
    auto desc = made(hrbfnpr_mesh_fit_desc_init);
    desc.tolerance = 0.02;
    auto fit = made(hrbfnpr_fit_desc_init);
    fit.kernel = HRBFNPR_KERNEL_WENDLAND_C2;
    hrbfnpr_model* raw = nullptr;
    ASSERT_OK(hrbfnpr_model_fit_mesh(mesh.get(), &desc, &fit, nullptr, nullptr, &raw, error));
    auto info = made(hrbfnpr_model_info_init);
    EXPECT_OK(hrbfnpr_model_get_info(Model(raw).get(), &info, error));
    EXPECT_EQ(info.kernel, static_cast<std::uint32_t>(HRBFNPR_KERNEL_WENDLAND_C2));
    const auto expect = [&](const char* part) {
        raw = nullptr;
        EXPECT_FAILS(hrbfnpr_model_fit_mesh(mesh.get(), &desc, &fit, nullptr, nullptr, &raw, error),
                     HRBFNPR_STATUS_INVALID_ARGUMENT, part);
        EXPECT_EQ(raw, nullptr);
    };
    fit.maximum_centres = 100;
    expect("set those of mesh_fit_desc");
    fit = made(hrbfnpr_fit_desc_init);
    desc.share = 0.0;
    expect("mesh_fit_desc.share is 0");
    desc = made(hrbfnpr_mesh_fit_desc_init);
    desc.maximum_centres = 3;
    expect("mesh_fit_desc.maximum_centres is 3");
    desc = made(hrbfnpr_mesh_fit_desc_init);
    desc.tolerance = 1e-9;
    expect("mesh_fit_desc.tolerance is 1e-09; it must be 0 (automatic) or at least");
    desc.tolerance = 0.1;
    desc.far = 0.01;
    expect("mesh_fit_desc.far is 0.01; it must be 0 (automatic) or at least the tolerance");
}

TEST(CompareMesh, MeasuresAnyModel) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, icosphere(4));
    Error error;
    auto custom = made(hrbfnpr_custom_desc_init);
    custom.function = [](void*, std::int64_t count, const double* p, double* value, double*, double*) -> std::int32_t {
        for (std::int64_t i = 0; i < count; ++i)
            value[i] =
                std::sqrt(p[3 * i] * p[3 * i] + p[3 * i + 1] * p[3 * i + 1] + p[3 * i + 2] * p[3 * i + 2]) - 1.05;
        return 0;
    };
    for (int axis = 0; axis < 3; ++axis) {
        custom.bounds_min[axis] = -1.05;
        custom.bounds_max[axis] = 1.05;
    }
    hrbfnpr_model* raw = nullptr;
    ASSERT_OK(hrbfnpr_model_create_custom(context.get(), &custom, &raw, error));
    const Model model(raw);
    auto desc = made(hrbfnpr_compare_desc_init);
    desc.points = 1000;
    auto compared = made(hrbfnpr_comparison_init);
    ASSERT_OK(hrbfnpr_model_compare_mesh(model.get(), mesh.get(), &desc, &compared, nullptr, error));
    EXPECT_NEAR(compared.surface_mean, 0.05, 0.003);
    EXPECT_NEAR(compared.mesh_max, 0.05, 0.005);
    EXPECT_EQ(compared.invented_share, 1.0);
    desc.support = 1.5;
    EXPECT_FAILS(hrbfnpr_model_compare_mesh(model.get(), mesh.get(), &desc, &compared, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "a custom model has no samples");
    desc = made(hrbfnpr_compare_desc_init);
    desc.points = 5;
    EXPECT_FAILS(hrbfnpr_model_compare_mesh(model.get(), mesh.get(), &desc, &compared, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "compare_desc.points is 5");
    EXPECT_FAILS(hrbfnpr_model_compare_mesh(model.get(), nullptr, nullptr, &compared, nullptr, error),
                 HRBFNPR_STATUS_INVALID_ARGUMENT, "mesh is NULL");
}

TEST(Mesh, OutlivesItsContext) {
    Mesh mesh;
    {
        const Context context = make_context();
        mesh = mesh_of(context, icosphere(2));
    }
    hrbfnpr_mesh_retain(mesh.get());
    hrbfnpr_mesh_release(mesh.get());
    EXPECT_EQ(info_of(mesh).faces, 320);
    hrbfnpr_mesh_retain(nullptr);
    hrbfnpr_mesh_release(nullptr);
}

} // namespace
} // namespace api_test::mesh_test
