// SPDX-License-Identifier: MIT
// Tests the finer mesh on which feature lines of rough fits are found.
#include "features/feature_lines.h"

#include "curves/mesh_checks.h"
#include "feature_shapes.h"
#include "fit/shapes.h"

#include <gtest/gtest.h>

namespace hrbfnpr::curves::feature_mesh_test {
namespace {

using namespace test_features;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

// The cloud has few samples with normals that lean back and forth, so the curvature changes from one sample to the
// next.
fit_test::Cloud rough() {
    fit_test::Cloud cloud = fit_test::bumpy(300);
    for (std::size_t i = 0; i + 2 < cloud.normals.size(); i += 3) {
        const auto phase = static_cast<double>(i);
        glm::dvec3 n(cloud.normals[i], cloud.normals[i + 1], cloud.normals[i + 2]);
        n = glm::normalize(n + 0.1 * glm::dvec3(std::sin(1.7 * phase), std::sin(2.3 * phase), std::cos(3.1 * phase)));
        for (std::size_t c = 0; c < 3; ++c) cloud.normals[i + c] = n[static_cast<glm::length_t>(c)];
    }
    return cloud;
}

struct Fitted {
    explicit Fitted(const fit_test::Cloud& cloud)
        : hrbf(runtime().instruction_set, fit::fit(runtime(), fit_test::input(cloud)).data),
          source(runtime().instruction_set, hrbf.data()) {}
    [[nodiscard]] SurfaceMesh meshed(double spacings) const {
        geometry::VecArray seeds(runtime().memory);
        const base::Array<double>& p = hrbf.data().sample_position;
        for (std::int64_t i = 0; i < p.size(); i += 3) seeds.push_back({p[i], p[i + 1], p[i + 2]});
        return triangulate(runtime(), hrbf, seeds, test_shapes::settings(hrbf, spacings * hrbf.data().spacing));
    }

    implicit::Hrbf hrbf;
    implicit::HrbfShape source;
};

TEST(FeatureMesh, StaysClosedAndOnTheSurface) {
    const Fitted fitted(rough());
    const SurfaceMesh mesh = fitted.meshed(0.5);
    const ShapedMesh fine = measured_mesh(runtime(), fitted.hrbf, fitted.source, mesh);
    EXPECT_GT(fine.mesh.triangles(), 3 * mesh.triangles());
    EXPECT_EQ(fine.shape.size(), fine.mesh.vertices());
    EXPECT_EQ(fine.mesh.position[0], mesh.position[0]);
    const test_checks::Measures found = test_checks::measure(fine.mesh, fitted.hrbf);
    EXPECT_EQ(found.euler, test_checks::measure(mesh, fitted.hrbf).euler);
    EXPECT_EQ(found.bad_edges, 0);
    EXPECT_EQ(found.bad_across, 0);
    EXPECT_EQ(found.border, 0);
    EXPECT_EQ(found.unused, 0);
    EXPECT_LT(found.off, 1e-8);
}

TEST(FeatureMesh, IsNotRefinedOnASmoothSurface) {
    const geometry::Bounds box{glm::dvec3(-1.5, -1.5, -0.4), glm::dvec3(1.5, 1.5, 0.4)};
    const AnyField shape(box, [](const glm::dvec3& p) { return elliptic_torus(p, 0.4, 0.3); });
    const implicit::DifferencedShape source(shape);
    const SurfaceMesh mesh = triangulate(runtime(), shape, test_shapes::seeds(runtime(), {{1.4, 0.0, 0.0}}),
                                         test_shapes::settings(shape, 0.03));
    EXPECT_EQ(measured_mesh(runtime(), shape, source, mesh).mesh.triangles(), mesh.triangles());
}

// The reference is a mesh with a side of 0.08 spacings; lines agree within a pixel of 720.
TEST(FeatureMesh, GivesARoughFitTheSuggestiveContoursOfADenseMesh) {
    const Fitted fitted(rough());
    const ShapedMesh fine = measured_mesh(runtime(), fitted.hrbf, fitted.source, fitted.meshed(0.5));
    const SurfaceMesh dense = fitted.meshed(0.08);
    base::Array<ShapePoint> shape(runtime().memory);
    measure_shape(runtime(), fitted.source, dense.position, dense.gradient, shape);
    const double pixel = fitted.hrbf.diagonal() / 720.0;
    FeatureRequest request;
    request.towards = glm::dvec4(0.5, -0.8, 0.3, 0.0);
    request.rounds = 0;
    const auto find = [&](const SurfaceMesh& mesh, const base::Array<ShapePoint>& its, double least) {
        request.lower = request.upper = least;
        return along(find_feature_lines(runtime(), {fitted.hrbf, fitted.source, mesh, its}, request), pixel);
    };
    const std::vector<glm::dvec3> drawn = find(fine.mesh, fine.shape, 10.0);
    EXPECT_GT(drawn.size(), 1000U);
    EXPECT_GE(Places(find(dense, shape, 9.0), pixel).share(drawn), 0.99);
    EXPECT_GE(Places(drawn, pixel).share(find(dense, shape, 11.0)), 0.99);
}

} // namespace
} // namespace hrbfnpr::curves::feature_mesh_test
