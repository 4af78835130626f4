// SPDX-License-Identifier: MIT
// Feature lines of fitted surfaces: against a brute search on a mesh three times as fine, and of what has none.
#include "curves/feature_lines.h"

#include "feature_shapes.h"
#include "fit/shapes.h"

#include <gtest/gtest.h>

namespace hrbfnpr::curves {
namespace {

using namespace test_features;

base::Runtime& runtime() {
    static base::Runtime instance = test::with_threads(2);
    return instance;
}

// A fit with its smoothed derivatives.
struct Fitted {
    Fitted(const fit_test::Cloud& cloud, double smoothing)
        : hrbf(runtime().instruction_set, fit::fit(runtime(), fit_test::input(cloud), {}).data),
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

// The zero line of the linear g in each triangle, in pieces: no chains, no refinement, no ends.
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

TEST(FittedFeatures, SuggestiveContoursAreThoseOfADenseReference) {
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
            // Strengths differ a little: the reference is asked for less, or for more.
            const double precision = Places(zero_lines(dense, request, 2.7), pixel).share(found);
            const double recall = Places(found, pixel).share(zero_lines(dense, request, 3.3));
            EXPECT_GT(lines.lines(), 1);
            EXPECT_EQ(lines.unresolved, 0);
            EXPECT_GE(precision, 0.99) << rounds;
            EXPECT_GE(recall, 0.99) << rounds;
        }
    }
}

TEST(FittedFeatures, ASphereHasNone) {
    const Fitted fitted(fit_test::sphere(500), implicit::ordinary_smoothing);
    const Subject subject = fitted.meshed(0.1);
    for (const auto kind :
         {FeatureKind::ridge, FeatureKind::valley, FeatureKind::suggestive_contour, FeatureKind::parabolic}) {
        FeatureRequest request;
        request.kind = kind;
        request.towards = {0.5, -0.8, 0.3, 0.0};
        request.lower = 0.3;
        request.upper = 0.5;
        EXPECT_EQ(subject.find(runtime(), request).lines(), 0) << static_cast<int>(kind);
    }
}

} // namespace
} // namespace hrbfnpr::curves
