// SPDX-License-Identifier: MIT
// Tests models with sharp edges through the C boundary.
#include "fixture.h"
#include "support/sharp_meshes.h"

#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace api_test::mesh_edges_test {
namespace {

using hrbfnpr::test::Triangles;

Mesh mesh_of(const Context& context, const Triangles& from) {
    Error error;
    auto desc = made(hrbfnpr_mesh_desc_init);
    desc.vertices = in(from.vertices);
    desc.triangles = in(from.triangles);
    hrbfnpr_mesh* mesh = nullptr;
    EXPECT_OK(hrbfnpr_mesh_create(context.get(), &desc, nullptr, &mesh, error));
    return Mesh(mesh);
}

Model fitted(const Mesh& mesh, std::uint32_t edges, hrbfnpr_mesh_fit_info& info, double angle = 30.0) {
    Error error;
    auto desc = made(hrbfnpr_mesh_fit_desc_init);
    desc.edges = edges;
    desc.crease_angle = angle;
    info = made(hrbfnpr_mesh_fit_info_init);
    hrbfnpr_model* model = nullptr;
    EXPECT_OK(hrbfnpr_model_fit_mesh(mesh.get(), &desc, nullptr, &info, nullptr, &model, error));
    return Model(model);
}

std::vector<double> values(const Model& model, const std::vector<double>& points) {
    Error error;
    std::vector<double> result(points.size() / 3);
    const hrbfnpr_array at = in(points);
    const hrbfnpr_array_out to{result.data(), static_cast<std::int64_t>(result.size()), 0, HRBFNPR_SCALAR_FLOAT64, 1};
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &at, &to, nullptr, nullptr, nullptr, error));
    return result;
}

std::vector<std::uint8_t> saved(const Model& model) {
    Error error;
    std::int64_t size = 0;
    EXPECT_EQ(hrbfnpr_model_save_memory(model.get(), nullptr, 0, &size, error), HRBFNPR_STATUS_BUFFER_TOO_SMALL);
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(size));
    EXPECT_OK(hrbfnpr_model_save_memory(model.get(), bytes.data(), size, &size, error));
    return bytes;
}

struct FoundEdges {
    explicit FoundEdges(const Mesh& mesh, std::uint32_t edges = HRBFNPR_EDGES_AUTO, double angle = 30.0,
                        double far = 0.0) {
        Error error;
        hrbfnpr_array faces{};
        EXPECT_OK(hrbfnpr_mesh_view(mesh.get(), HRBFNPR_MESH_ATTRIBUTE_TRIANGLE, &faces, error));
        corner.assign(static_cast<const std::int32_t*>(faces.data),
                      static_cast<const std::int32_t*>(faces.data) + 3 * faces.count);
        patch.resize(static_cast<std::size_t>(faces.count), -1);
        sharp.resize(corner.size(), -1);
        const hrbfnpr_array_out patches{patch.data(), faces.count, 0, HRBFNPR_SCALAR_INT32, 1};
        const hrbfnpr_array_out sides{sharp.data(), faces.count, 0, HRBFNPR_SCALAR_INT32, 3};
        auto desc = made(hrbfnpr_mesh_edges_desc_init);
        desc.edges = edges;
        desc.crease_angle = angle;
        desc.far = far;
        EXPECT_OK(hrbfnpr_mesh_edges(mesh.get(), &desc, &patches, &sides, &info, nullptr, error));
    }

    // The number of sharp edges; each edge has two sides.
    [[nodiscard]] std::int64_t sharp_edges() const {
        std::int64_t sides = 0;
        for (const std::int32_t is : sharp) sides += is;
        return sides / 2;
    }

    std::vector<std::int32_t> corner, patch, sharp;
    hrbfnpr_mesh_edges_info info = made(hrbfnpr_mesh_edges_info_init);
};

TEST(MeshEdges, SeparateTheSixFacesOfABox) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, hrbfnpr::test::box(1.0, 1.0, 1.0, 3));
    const FoundEdges found(mesh);
    EXPECT_EQ(found.info.patches, 6);
    EXPECT_EQ(found.info.edges, 12 * 3);
    EXPECT_EQ(found.sharp_edges(), found.info.edges);
    EXPECT_NEAR(found.info.length, 12.0, 1e-12);
    EXPECT_EQ(found.info.fading, 0.0);
    EXPECT_EQ(found.info.doubtful, 0.0);
    // Patches are separated at sharp edges, and nowhere else.
    std::map<std::array<std::int32_t, 2>, std::int32_t> patch_of_side;
    for (std::size_t side = 0; side < found.corner.size(); ++side) {
        const std::int32_t from = found.corner[side], to = found.corner[side % 3 == 2 ? side - 2 : side + 1];
        patch_of_side[{from, to}] = found.patch[side / 3];
    }
    for (std::size_t side = 0; side < found.corner.size(); ++side) {
        const std::int32_t from = found.corner[side], to = found.corner[side % 3 == 2 ? side - 2 : side + 1];
        EXPECT_EQ((patch_of_side[{to, from}] != found.patch[side / 3]), found.sharp[side] == 1) << side;
    }
    EXPECT_EQ(FoundEdges(mesh, HRBFNPR_EDGES_SMOOTH).info.patches, 1);
    EXPECT_EQ(FoundEdges(mesh, HRBFNPR_EDGES_SMOOTH).sharp_edges(), 0);
    EXPECT_EQ(FoundEdges(mesh, HRBFNPR_EDGES_SHARP, 95.0, 2.0).info.edges, 0);
}

TEST(MeshEdges, AreAbsentOnABall) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, hrbfnpr::test::icosphere(2));
    EXPECT_EQ(FoundEdges(mesh).info.edges, 0);
    EXPECT_EQ(FoundEdges(mesh).info.patches, 1);
    // At a small angle all edges are sharp, and each face is a patch.
    const FoundEdges all(mesh, HRBFNPR_EDGES_SHARP, 5.0, 2.0);
    EXPECT_EQ(all.info.patches, static_cast<std::int64_t>(all.patch.size()));
    EXPECT_GT(FoundEdges(mesh, HRBFNPR_EDGES_AUTO, 5.0).info.doubtful, 0.0);
}

TEST(MeshEdges, AreReportedInTheMeshInfo) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, hrbfnpr::test::box(1.0, 1.0, 1.0, 3));
    auto info = made(hrbfnpr_mesh_info_init);
    Error error;
    EXPECT_OK(hrbfnpr_mesh_get_info(mesh.get(), &info, error));
    EXPECT_EQ(info.creases, 1U);
    EXPECT_NEAR(info.crease_length, 12.0 / std::sqrt(3.0), 1e-9);
}

TEST(MeshEdges, AreKeptSharpInAFit) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, hrbfnpr::test::drilled_cube(0.5, 48));
    hrbfnpr_mesh_fit_info info{};
    const Model model = fitted(mesh, HRBFNPR_EDGES_AUTO, info);
    EXPECT_EQ(info.reached, 1U);
    EXPECT_EQ(info.sheets, 7);
    EXPECT_EQ(info.smooth_length, 0.0);
    EXPECT_NEAR(info.crease_length, 24.0 + 2.0 * 3.14159, 0.01);
    EXPECT_GT(info.cells, 100);
    EXPECT_EQ(info.poor_cells, 0);
    EXPECT_LT(info.centres, 400);
    for (const double t : {0.0, 0.3, 0.9}) // points on edges
        for (const double v : values(model, {1.0, 1.0, t, t, -1.0, 1.0, 0.5 * std::cos(t), 0.5 * std::sin(t), 1.0}))
            EXPECT_LT(std::abs(v), 2e-3);
    hrbfnpr_mesh_fit_info smooth{};
    (void)fitted(mesh, HRBFNPR_EDGES_SMOOTH, smooth);
    EXPECT_EQ(smooth.sheets, 1);
    EXPECT_EQ(smooth.crease_length, 0.0);
    EXPECT_GT(smooth.centres, info.centres);
}

TEST(MeshEdges, AreChosenByTheirAngle) {
    const Context context = make_context();
    const std::vector<hrbfnpr::test::Ring> rings{{0.0, 0.0}, {1.0, 0.0}, {1.0, 0.5}, {0.0, 0.5}};
    const Mesh disc = mesh_of(context, hrbfnpr::test::ringed(rings, 30, 0.5)); // its faces meet at 12 degrees
    hrbfnpr_mesh_fit_info info{};
    (void)fitted(disc, HRBFNPR_EDGES_SHARP, info, 30.0);
    EXPECT_EQ(info.sheets, 3);
    (void)fitted(disc, HRBFNPR_EDGES_SHARP, info, 10.0);
    EXPECT_EQ(info.sheets, 2 + 30);
    // The faces meet at 42 degrees, and the mesh is too coarse to be round.
    (void)fitted(mesh_of(context, hrbfnpr::test::icosphere(0)), HRBFNPR_EDGES_SHARP, info, 45.0);
    EXPECT_EQ(info.sheets, 20);
    (void)fitted(mesh_of(context, hrbfnpr::test::icosphere(2)), HRBFNPR_EDGES_SHARP, info, 30.0);
    EXPECT_EQ(info.sheets, 1);
}

// The fit of a mesh without edges is the same, bit for bit, as with edges off.
TEST(MeshEdges, DoNotChangeTheFitOfASmoothMesh) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, hrbfnpr::test::torus(60, 24, 0.4));
    hrbfnpr_mesh_fit_info one{};
    hrbfnpr_mesh_fit_info other{};
    const Model a = fitted(mesh, HRBFNPR_EDGES_AUTO, one);
    const Model b = fitted(mesh, HRBFNPR_EDGES_SMOOTH, other);
    EXPECT_EQ(one.sheets, 1);
    ASSERT_EQ(one.centres, other.centres);
    const std::vector<double> places{1.0, 0.1, 0.2, -0.4, 0.9, 0.1, 0.0, 0.0, 0.0, 3.0, 2.0, 1.0};
    EXPECT_EQ(values(a, places), values(b, places));
}

TEST(MeshEdges, AreSavedWithTheModel) {
    const Context context = make_context();
    const Mesh mesh = mesh_of(context, hrbfnpr::test::stepped_shaft(48));
    hrbfnpr_mesh_fit_info info{};
    const Model model = fitted(mesh, HRBFNPR_EDGES_AUTO, info);
    const std::vector<std::uint8_t> bytes = saved(model);
    Error error;
    hrbfnpr_model* raw = nullptr;
    ASSERT_OK(
        hrbfnpr_model_load_memory(context.get(), bytes.data(), static_cast<std::int64_t>(bytes.size()), &raw, error));
    const Model loaded(raw);
    EXPECT_EQ(saved(loaded), bytes);
    std::vector<double> places;
    for (int i = 0; i < 300; ++i) places.push_back(std::sin(1.7 * i) * 1.5 + (i % 3 == 2 ? 1.5 : 0.0));
    EXPECT_EQ(values(model, places), values(loaded, places));
    auto model_info = made(hrbfnpr_model_info_init);
    ASSERT_OK(hrbfnpr_model_get_info(loaded.get(), &model_info, error));
    EXPECT_EQ(model_info.centres, info.centres);
    EXPECT_EQ(model_info.samples, info.candidates);
    EXPECT_EQ(model_info.kernel, static_cast<std::uint32_t>(HRBFNPR_KERNEL_TRIHARMONIC));
    EXPECT_GT(model_info.bytes, 60 * info.centres);
    hrbfnpr_array view{};
    ASSERT_OK(hrbfnpr_model_view(loaded.get(), HRBFNPR_MODEL_ATTRIBUTE_NORMAL, &view, error));
    EXPECT_GT(view.count, 1000);
    // The loaded model can be compared (also with a limit of support), trimmed and drawn like any other.
    auto desc = made(hrbfnpr_compare_desc_init);
    desc.points = 2000;
    desc.support = 3.0;
    auto compared = made(hrbfnpr_comparison_init);
    ASSERT_OK(hrbfnpr_model_compare_mesh(loaded.get(), mesh.get(), &desc, &compared, nullptr, error));
    EXPECT_EQ(compared.mesh_share, 1.0);
    EXPECT_EQ(compared.components, 1);
    EXPECT_EQ(compared.genus, 0);
    hrbfnpr_model* trimmed = nullptr;
    ASSERT_OK(hrbfnpr_model_trim(loaded.get(), nullptr, nullptr, &trimmed, error));
    EXPECT_FALSE(saved(Model(trimmed)).empty());
    const PointSet set = generate(context, loaded, hrbfnpr::test::one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 2000));
    ASSERT_OK(hrbfnpr_point_set_view(set.get(), 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &view, error));
    EXPECT_GT(view.count, 1000);
}

// Round solids that cross get one sheet each and meet in creases. The surface is that of the union, where one function
// would deviate from both.
TEST(MeshEdges, SolidsThatCrossAreFittedApart) {
    const Context context = make_context();
    const Triangles ball = hrbfnpr::test::icosphere(4);
    const Mesh mesh = mesh_of(context, ball.with(ball.moved(0.7, 1.1, 0.1, 0.2)));
    hrbfnpr_mesh_fit_info info{};
    const Model model = fitted(mesh, HRBFNPR_EDGES_AUTO, info);
    EXPECT_EQ(info.sheets, 2);
    EXPECT_EQ(info.reached, 1U);
    // Both balls are round in all directions, also beside the circle in which they meet.
    const double tolerance = 2.0 * info.tolerance;
    const std::array<double, 3> middle{1.1, 0.1, 0.2};
    std::vector<double> points;
    for (int i = 0; i < 2000; ++i) {
        const auto way = hrbfnpr::test::spiral_point(i, 2000);
        std::array<double, 3> other{};
        double squared = 0.0, squared_other = 0.0;
        for (std::size_t k = 0; k < 3; ++k) {
            other[k] = middle[k] + 0.7 * way[k];
            squared += (way[k] - middle[k]) * (way[k] - middle[k]);
            squared_other += other[k] * other[k];
        }
        // The part of a ball that is not within the other ball is on the surface, and f changes its sign there.
        for (const double side : {-tolerance, tolerance}) {
            if (squared > 0.5)
                for (std::size_t k = 0; k < 3; ++k) points.push_back((1.0 + side) * way[k]);
            if (squared_other > 1.01)
                for (std::size_t k = 0; k < 3; ++k) points.push_back(other[k] + side * way[k]);
        }
    }
    const std::vector<double> f = values(model, points);
    for (std::size_t i = 0; i < f.size(); ++i) {
        const double *p = points.data() + 3 * i, x = p[0] - middle[0], y = p[1] - middle[1], z = p[2] - middle[2];
        const bool inside = p[0] * p[0] + p[1] * p[1] + p[2] * p[2] < 1.0 || x * x + y * y + z * z < 0.49;
        EXPECT_EQ(f[i] < 0.0, inside) << p[0] << " " << p[1] << " " << p[2];
    }
    // Solids that do not touch need no separate sheets.
    const Mesh apart = mesh_of(context, ball.with(ball.moved(0.7, 2.0, 0.1, 0.2)));
    fitted(apart, HRBFNPR_EDGES_AUTO, info);
    EXPECT_EQ(info.sheets, 1);
}

// Each of the crossing solids keeps its edges or has none, though the box has few edges beside a ball of 80 faces.
TEST(MeshEdges, SolidsThatCrossKeepTheirEdges) {
    const Context context = make_context();
    const Triangles ball = hrbfnpr::test::icosphere(1);
    const Triangles box = hrbfnpr::test::box(1.0, 1.0, 1.0, 2).moved(1.0, 0.4, -0.5, -0.5);
    hrbfnpr_mesh_fit_info info{};
    fitted(mesh_of(context, ball), HRBFNPR_EDGES_AUTO, info, 15.0);
    EXPECT_EQ(info.sheets, 1);
    const Model model = fitted(mesh_of(context, ball.with(box)), HRBFNPR_EDGES_AUTO, info, 15.0);
    EXPECT_EQ(info.sheets, 7);
    std::vector<double> points; // on both sides of the box's far edges
    for (int i = 1; i < 20; ++i)
        for (const double off : {-1e-3, 1e-3}) points.insert(points.end(), {1.4 + off, 0.5 + off, -0.5 + 0.05 * i});
    const std::vector<double> f = values(model, points);
    for (std::size_t i = 0; i < f.size(); ++i) EXPECT_EQ(f[i] < 0.0, i % 2 == 0) << i;
}

// Boxes stand on each other, and a pin is in a wall: no wall remains where they touch.
TEST(MeshEdges, TouchingSolidsBecomeOne) {
    const Context context = make_context();
    const Triangles box = hrbfnpr::test::box(1.0, 1.0, 1.0, 1);
    const Triangles small = hrbfnpr::test::box(0.5, 0.4, 0.3, 2);
    const Mesh mesh = mesh_of(context, box.with(box.moved(1.0, 1.0, 0.0, 0.0)).with(small.moved(1.0, 0.7, 0.2, 1.0)));
    hrbfnpr_mesh_fit_info info{};
    const Model model = fitted(mesh, HRBFNPR_EDGES_AUTO, info);
    EXPECT_EQ(info.reached, 1U);
    std::vector<double> points;
    for (int i = 1; i < 20; ++i)
        for (int j = 1; j < 20; ++j) {
            for (const double off : {-1e-4, 0.0, 1e-4}) {
                points.insert(points.end(), {1.0 + off, 0.05 * i, 0.05 * j});
                points.insert(points.end(), {0.7 + 0.025 * i, 0.2 + 0.02 * j, 1.0 + off});
            }
        }
    for (const double f : values(model, points)) EXPECT_LT(f, -1e-5);
}

// The top of the box has a vertex far below the bottom, so the inside is not defined. Parts of the fit that are far
// from the mesh are left out.
TEST(MeshEdges, AFitOfASelfCrossingMeshEndsNearTheMesh) {
    const Context context = make_context();
    Triangles crossed = hrbfnpr::test::box(1.0, 1.0, 1.0, 5);
    for (std::size_t i = 0; i < crossed.vertices.size(); i += 3)
        if (std::abs(crossed.vertices[i] - 0.4) + std::abs(crossed.vertices[i + 1] - 0.4) < 1e-9 &&
            crossed.vertices[i + 2] > 0.9)
            crossed.vertices[i + 2] = -0.6;
    const Mesh mesh = mesh_of(context, crossed);
    hrbfnpr_mesh_fit_info info{};
    const Model model = fitted(mesh, HRBFNPR_EDGES_AUTO, info);
    EXPECT_GT(info.sheets, 1);
    Error error;
    auto trim = made(hrbfnpr_trim_info_init);
    ASSERT_OK(hrbfnpr_model_get_trim_info(model.get(), &trim, error));
    EXPECT_EQ(trim.is_trimmed, 1);
    EXPECT_GT(trim.share, 0.1);
}

} // namespace
} // namespace api_test::mesh_edges_test
