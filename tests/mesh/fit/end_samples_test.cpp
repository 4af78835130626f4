// SPDX-License-Identifier: MIT
#include "mesh/sample.h"

#include "mesh/meshes.h"
#include "support/runtime.h"
#include "surface/support.h"

#include <gtest/gtest.h>

#include <cmath>

namespace end_samples_test {

namespace base = hrbfnpr::base;
namespace mesh = hrbfnpr::mesh;
namespace surface = hrbfnpr::surface;
using hrbfnpr::test::same_bits;
using hrbfnpr::test::with_threads;
using namespace mesh_test;

namespace {

constexpr double limit = 1.5;

// A grid in z = 0, x from 0 to 1, y from 0 to `width`, without the faces whose centre satisfies `leave_out`.
template <class F>
Triangles sheet(double width, int cells, F&& leave_out) {
    Triangles made;
    for (int i = 0; i <= cells; ++i)
        for (int j = 0; j <= cells; ++j)
            static_cast<void>(made.add(static_cast<double>(i) / cells, width * j / cells, 0.0));
    for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
            if (leave_out((i + 0.5) / cells, width * (j + 0.5) / cells)) continue;
            const std::int32_t a = i * (cells + 1) + j, b = a + cells + 1;
            made.face(a, b, b + 1);
            made.face(a, b + 1, a + 1);
        }
    return made;
}

// A sheet's end samples, and the surface that they support.
struct Ended {
    explicit Ended(const Triangles& from, int threads = 2, double off = 0.009)
        : runtime(with_threads(threads)), shape(made(runtime, from)), tree(runtime, shape.vertex, shape.triangle),
          closest(off * shape.bounds.diagonal()), samples(mesh::end_samples(runtime, shape, tree, 20000, closest, 1)),
          support(runtime, samples.position, samples.normal, closest) {}

    // Returns how far beyond a place the surface ends, in units of `closest`.
    [[nodiscard]] double beyond(const glm::dvec3& place, const glm::dvec3& out) const {
        double reach = 0.0;
        while (reach > -2.0 && support.value(place + reach * closest * out, {0.0, 0.0, 1.0}) > limit) reach -= 0.01;
        while (reach < 2.0 && support.value(place + reach * closest * out, {0.0, 0.0, 1.0}) <= limit) reach += 0.01;
        return reach;
    }

    base::Runtime runtime;
    mesh::Mesh shape;
    mesh::FaceTree tree;
    double closest;
    mesh::MeshSamples samples;
    surface::Support support;
};

const auto none = [](double, double) { return false; };

// Faces may have any size. The end is straight, although the even samples behind the border's row are irregular.
TEST(EndSamples, EndASheetAtItsBorder) {
    for (const int cells : {1, 10, 200}) {
        SCOPED_TRACE(cells);
        const Ended ended(sheet(1.0, cells, none));
        for (int i = 5; i <= 95; ++i) {
            EXPECT_NEAR(ended.beyond({0.01 * i, 1.0, 0.0}, {0, 1, 0}), 0.0, 0.025);
            EXPECT_NEAR(ended.beyond({0.0, 0.01 * i, 0.0}, {-1, 0, 0}), 0.0, 0.025);
        }
        for (int i = 0; i < 40000; ++i) { // the inside has no hole; corners are round
            const glm::dvec3 p(0.00498 * (i % 200) + 0.002, 0.00498 * (i / 200) + 0.002, 0.0);
            const bool corner = std::min(p.x, 1.0 - p.x) + std::min(p.y, 1.0 - p.y) < 0.02;
            if (!corner) {
                ASSERT_LE(ended.support.value(p, {0.0, 0.0, 1.0}), limit) << p.x << ' ' << p.y;
            }
        }
    }
}

// The corners of a sheet are as sharp as `closest` is small. Between the dense rows beside the border and the even
// samples there are no holes.
TEST(EndSamples, KeepCornersWhereTheRowsAreDense) {
    for (const double off : {0.004, 0.002, 0.001}) {
        SCOPED_TRACE(off);
        const auto hole = [](double x, double y) { return std::abs(x - 0.5) < 0.2 && std::abs(y - 0.5) < 0.2; };
        const Ended ended(sheet(1.0, 20, hole), 2, off);
        for (int i = 5; i <= 95; ++i) EXPECT_NEAR(ended.beyond({0.01 * i, 1.0, 0.0}, {0, 1, 0}), 0.0, 0.1);
        const double diagonal = std::sqrt(0.5);
        EXPECT_GT(ended.beyond({1.0, 1.0, 0.0}, {diagonal, diagonal, 0.0}), -0.8);
        EXPECT_NEAR(ended.beyond({0.3, 0.5, 0.0}, {1, 0, 0}), 0.0, 0.1);
        EXPECT_LT(ended.beyond({0.3, 0.3, 0.0}, {diagonal, diagonal, 0.0}), 0.8);
        for (int i = 0; i < 400 * 400; ++i) {
            const glm::dvec3 p(0.0025 * (i % 400) + 0.0013, 0.0025 * (i / 400) + 0.0013, 0.0);
            const bool corner = std::min(p.x, 1.0 - p.x) + std::min(p.y, 1.0 - p.y) < 2.0 * ended.closest;
            const double out = 0.2 + 0.1 * ended.closest;
            if (corner || (std::abs(p.x - 0.5) < out && std::abs(p.y - 0.5) < out)) continue;
            ASSERT_LE(ended.support.value(p, {0.0, 0.0, 1.0}), limit) << p.x << ' ' << p.y;
        }
    }
}

// Strips that are too narrow for a row of samples have no holes, and end somewhat beyond the border.
TEST(EndSamples, KeepNarrowStrips) {
    for (const double width : {0.004, 0.01, 0.016, 0.03}) {
        SCOPED_TRACE(width);
        const Ended ended(sheet(width, 40, none));
        for (int i = 5; i <= 95; ++i) {
            for (const double share : {0.1, 0.5, 0.9})
                EXPECT_LE(ended.support.value({0.01 * i, share * width, 0.0}, {0.0, 0.0, 1.0}), limit);
            EXPECT_LT(ended.beyond({0.01 * i, width, 0.0}, {0, 1, 0}), 1.1);
        }
    }
}

// The surface ends at a hole, too, unless the hole is so small that it stays closed anyway.
TEST(EndSamples, EndAtLargeHolesOnly) {
    const auto square = [](double x, double y) { return std::abs(x - 0.5) < 0.1 && std::abs(y - 0.5) < 0.1; };
    const Ended large(sheet(1.0, 200, square));
    EXPECT_NEAR(large.beyond({0.4, 0.53, 0.0}, {1, 0, 0}), 0.0, 0.1);
    const Ended small(sheet(1.0, 200, [](double x, double y) { return std::hypot(x - 0.5, y - 0.5) < 0.008; }));
    for (std::int64_t i = 0; i < small.samples.position.size(); ++i) {
        const glm::dvec3 p = small.samples.position[i];
        const double border = std::min({p.x, p.y, 1.0 - p.x, 1.0 - p.y});
        EXPECT_GT(border, 0.6 * small.closest);
    }
    EXPECT_LT(small.support.nearest_sample({0.5, 0.5, 0.0}).distance, small.closest);
}

} // namespace

} // namespace end_samples_test
