// SPDX-License-Identifier: MIT
// Tests feature lines of fitted surfaces against a brute search on a dense mesh, and surfaces that have none.
#include "features/feature_lines.h"

#include "feature_shapes.h"
#include "fit/shapes.h"
#include "geometry/tangent_frame.h"
#include "surface/project.h"

#include <gtest/gtest.h>

namespace hrbfnpr::curves::feature_fit_test {
namespace {

using namespace test_features;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

// A fit with its smoothed derivatives.
struct Fitted {
    Fitted(const fit_test::Cloud& cloud, double smoothing)
        : hrbf(runtime().instruction_set, fit::fit(runtime(), fit_test::input(cloud)).data),
          source(runtime().instruction_set, hrbf.data(), smoothing) {}
    [[nodiscard]] Subject meshed(double side) const {
        geometry::VecArray seeds(runtime().memory);
        const base::Array<double>& p = hrbf.data().sample_position;
        for (std::int64_t i = 0; i < p.size(); i += 3) seeds.push_back({p[i], p[i + 1], p[i + 2]});
        return {runtime(), hrbf, seeds, side, &source};
    }

    implicit::Hrbf hrbf;
    implicit::HrbfShape source;
};

// Points on the zero line of the linear g in each triangle, without chains, refinement or ends.
std::vector<glm::dvec3> zero_lines(const Subject& subject, const FeatureRequest& request, double least) {
    std::vector<glm::dvec3> found;
    std::vector<FeatureValue> value;
    const SurfaceMesh& mesh = subject.mesh;
    for (std::int64_t i = 0; i < mesh.vertices(); ++i)
        value.push_back(feature_value(request.kind, subject.shape[i], mesh.position[i], request.towards,
                                      subject.surface.diagonal()));
    for (std::int64_t t = 0; t < mesh.triangles(); ++t) {
        std::vector<glm::dvec3> end;
        for (std::int64_t k = 0; k < 3; ++k) {
            const std::int32_t a = mesh.corner[3 * t + k];
            const std::int32_t b = mesh.corner[3 * t + (k + 1) % 3];
            const FeatureValue& va = value[static_cast<std::size_t>(a)];
            const FeatureValue& vb = value[static_cast<std::size_t>(b)];
            if ((va.g < 0.0) == (vb.g < 0.0)) continue;
            const double share = va.g / (va.g - vb.g);
            if (glm::mix(va.strength, vb.strength, share) < least || glm::mix(va.facing, vb.facing, share) < 0.0)
                continue;
            end.push_back(glm::mix(mesh.position[a], mesh.position[b], share));
        }
        for (int k = 0; k < 8 && end.size() == 2; ++k) found.push_back(glm::mix(end[0], end[1], k / 8.0));
    }
    return found;
}

TEST(FittedFeatures, SuggestiveContoursMatchADenseReference) {
    const Fitted fitted(fit_test::bumpy(1000), implicit::ordinary_smoothing);
    const double side = fitted.hrbf.data().spacing * 0.7;
    const Subject subject = fitted.meshed(side);
    const Subject dense = fitted.meshed(side / 4.0);
    const double pixel = fitted.hrbf.diagonal() / 720.0;
    for (const glm::dvec4& eye : {glm::dvec4(0.5, -0.8, 0.3, 0.0), glm::dvec4(-2.0, 1.0, 3.0, 1.0)}) {
        FeatureRequest request;
        request.kind = FeatureKind::suggestive_contour;
        request.towards = eye;
        request.lower = 3.0;
        request.upper = 3.0;
        for (const std::int32_t rounds : {0, 6}) {
            request.rounds = rounds;
            const FeatureLines lines = subject.find(runtime(), request);
            const std::vector<glm::dvec3> found = along(lines, pixel);
            // Strengths differ a little, so the reference uses a lower limit for the precision and a higher one for the
            // recall.
            const double precision = Places(zero_lines(dense, request, 2.7), pixel).share(found);
            const double recall = Places(found, pixel).share(zero_lines(dense, request, 3.3));
            EXPECT_GT(lines.count(), 1);
            EXPECT_EQ(lines.unresolved, 0);
            EXPECT_GE(precision, 0.99) << rounds;
            EXPECT_GE(recall, 0.99) << rounds;
        }
    }
}

// The mean distance of the parabolic lines of a fitted torus from the torus's circles, in spacings.
double off_circles(const fit_test::Cloud& cloud, double smoothing) {
    const Fitted fitted(cloud, smoothing);
    const double spacing = fitted.hrbf.data().spacing;
    FeatureRequest request;
    request.kind = FeatureKind::parabolic;
    const FeatureLines found = fitted.meshed(0.5 * spacing).find(runtime(), request);
    EXPECT_EQ(found.count(), 2);
    double sum = 0.0;
    for (std::int64_t i = 0; i < found.point.size(); ++i) {
        const glm::dvec3 p = found.point[i].position;
        sum += std::hypot(std::hypot(p.x, p.y) - 1.0, std::abs(p.z) - 0.4);
    }
    return sum / static_cast<double>(found.point.size()) / spacing;
}

// The shift grows with the square of the smoothing: 0.3 spacings move a line by some thousandths of a spacing.
TEST(FittedFeatures, SmoothingHardlyMovesLines) {
    const fit_test::Cloud cloud = fit_test::torus(1000);
    EXPECT_LT(off_circles(cloud, 0.05), 1e-3);
    EXPECT_LT(off_circles(cloud, implicit::ordinary_smoothing), 3e-3);
    EXPECT_GT(off_circles(cloud, 1.0), 1e-2) << "or nothing was smoothed";
}

// The largest difference of C between four points around a sample, a thousandth of a spacing away, over the mean |C|.
double spread_at_samples(const Fitted& fitted) {
    const implicit::HrbfData& data = fitted.hrbf.data();
    surface::Projection around(runtime().memory);
    for (std::int64_t i = 0; i < data.count(); ++i) {
        const glm::dvec3 p(data.sample_position[3 * i], data.sample_position[3 * i + 1],
                           data.sample_position[3 * i + 2]);
        const glm::dvec3 n(data.sample_normal[3 * i], data.sample_normal[3 * i + 1], data.sample_normal[3 * i + 2]);
        const glm::dvec3 u = geometry::any_perpendicular(n);
        const glm::dvec3 v = glm::cross(n, u);
        for (const glm::dvec3& side : {u, v, -u, -v}) around.position.push_back(p + 1e-3 * data.spacing * side);
    }
    surface::project(runtime(), fitted.hrbf, {}, around);
    base::Array<ShapePoint> shape(runtime().memory);
    measure_shape(runtime(), fitted.source, around.position, around.gradient, shape);
    double spread = 0.0;
    double size = 0.0;
    for (std::int64_t i = 0; i < shape.size(); ++i) {
        // The value of C(u, u, u) for one u in space, which does not depend on the principal directions.
        const auto along = [&](const ShapePoint& s) {
            const glm::dvec2 u = glm::normalize(s.in_tangent(geometry::any_perpendicular(shape[i].normal)));
            return glm::dot(s.change(u, u), u);
        };
        spread = std::max(spread, std::abs(along(shape[i]) - along(shape[i - i % 4])));
        size += std::abs(along(shape[i]));
    }
    return spread * static_cast<double>(shape.size()) / size;
}

TEST(FittedFeatures, SmoothingMendsDerivativesAtSamples) {
    const fit_test::Cloud cloud = fit_test::bumpy(1000);
    EXPECT_GT(spread_at_samples(Fitted(cloud, 1e-6)), 10.0);
    EXPECT_LT(spread_at_samples(Fitted(cloud, implicit::ordinary_smoothing)), 0.3);
}

TEST(FittedFeatures, ASphereHasNoFeatureLines) {
    const Fitted fitted(fit_test::sphere(500), implicit::ordinary_smoothing);
    const Subject subject = fitted.meshed(0.1);
    for (const auto kind :
         {FeatureKind::ridge, FeatureKind::valley, FeatureKind::suggestive_contour, FeatureKind::parabolic}) {
        FeatureRequest request;
        request.kind = kind;
        request.towards = {0.5, -0.8, 0.3, 0.0};
        request.lower = 0.3;
        request.upper = 0.5;
        EXPECT_EQ(subject.find(runtime(), request).count(), 0) << static_cast<int>(kind);
    }
}

} // namespace
} // namespace hrbfnpr::curves::feature_fit_test
