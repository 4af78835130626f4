// SPDX-License-Identifier: MIT
// Tests the mesh, the sheet counter and contours on fitted surfaces.
#include "base/random.h"
#include "curves/sheet_count.h"
#include "dense_count.h"
#include "fit/fit.h"
#include "mesh_checks.h"
#include "traced.h"

namespace hrbfnpr::curves::fitted_test {
namespace {

using namespace test;

base::InView view(const std::vector<double>& packed) {
    return {reinterpret_cast<const std::byte*>(packed.data()), static_cast<std::int64_t>(packed.size() / 3), 24,
            base::Scalar::float64, 3};
}

implicit::Hrbf fitted(const base::Runtime& runtime, const Samples& samples) {
    fit::FitInput input;
    input.points = view(samples.points);
    input.normals = view(samples.normals);
    return {runtime.instruction_set, fit::fit(runtime, input).data};
}

geometry::VecArray points_of(const base::Runtime& runtime, const Samples& samples) {
    geometry::VecArray points(runtime.memory);
    for (std::size_t i = 0; i < samples.points.size(); i += 3)
        points.push_back({samples.points[i], samples.points[i + 1], samples.points[i + 2]});
    return points;
}

glm::dvec3 random(std::int64_t i, std::uint32_t draw) {
    const auto u = base::uniform4(11, static_cast<std::uint64_t>(i), base::Purpose::probe, draw);
    return 2.0 * glm::dvec3(u[0], u[1], u[2]) - 1.0;
}

class FittedSurface : public testing::Test {
protected:
    FittedSurface()
        : samples(bumpy(700, 0.3)), hrbf(fitted(runtime, samples)),
          mesh(triangulate(runtime, hrbf, points_of(runtime, samples), test_shapes::settings(hrbf, 0.06))) {}

    base::Runtime runtime = with_threads(2);
    Samples samples;
    implicit::Hrbf hrbf;
    SurfaceMesh mesh;
};

TEST_F(FittedSurface, MeshIsClosedAndOnTheSurface) {
    const test_checks::Measures found = test_checks::measure(mesh, hrbf);
    EXPECT_EQ(found.euler, 2);
    EXPECT_EQ(found.border + found.bad_edges + found.bad_across + found.turned + found.unused, 0);
    EXPECT_EQ(mesh.unresolved + mesh.missed_seeds + mesh.turned, 0);
    EXPECT_LE(found.off, 1e-9 * hrbf.diagonal());
}

TEST_F(FittedSurface, MeshHardlyDependsOnTheCellSide) {
    const SurfaceMesh fine = triangulate(runtime, hrbf, points_of(runtime, samples), test_shapes::settings(hrbf, 0.03));
    const test_checks::Measures a = test_checks::measure(mesh, hrbf);
    const test_checks::Measures b = test_checks::measure(fine, hrbf);
    EXPECT_NEAR(a.area, b.area, 0.01 * b.area);
    EXPECT_NEAR(a.volume, b.volume, 0.01 * b.volume);
    EXPECT_GT(b.area, a.area); // chords cut corners
}

// Half of the segments end at the surface and are tangent to it.
TEST_F(FittedSurface, SheetCountsMatchTheReference) {
    constexpr std::int64_t count = 600;
    geometry::VecArray from(runtime.memory, count);
    geometry::VecArray to(runtime.memory, count);
    base::Array<double> clear(runtime.memory, count);
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t vertex = i * 7919 % mesh.vertices();
        const glm::dvec3 tangent = glm::normalize(glm::cross(mesh.gradient[vertex], random(i, 0)));
        to.set(i, i % 2 == 0 ? mesh.position[vertex] : 1.2 * random(i, 1));
        from.set(i, i % 2 == 0 ? mesh.position[vertex] + 4.0 * tangent : 4.0 * random(i, 2));
        clear[i] = i % 2 == 0 ? 2e-3 * hrbf.diagonal() : 0.0;
    }
    const SheetCounter counter(runtime, mesh);
    base::Array<SheetCounter::Result> answer(runtime.memory);
    counter.count(runtime, hrbf, from, to, clear, answer);
    std::int64_t certain = 0;
    std::int64_t sheets = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        glm::dvec3 a = from[i];
        glm::dvec3 b = to[i] + glm::normalize(from[i] - to[i]) * clear[i];
        const int reference = test_dense::clip(mesh.region, a, b) ? test_dense::roots({hrbf, a, b}, 1500) : 0;
        if (!answer[i].certain) continue;
        ++certain;
        sheets += reference;
        EXPECT_EQ(answer[i].sheets, reference) << i;
    }
    EXPECT_GT(certain, count * 97 / 100);
    EXPECT_GT(sheets, 200);
}

// The Hessian jumps at each sample, so a contour may turn sharply there.
TEST_F(FittedSurface, ContoursAreClosedAndOnTheCurve) {
    const test_traced::Meshed meshed(runtime, hrbf, points_of(runtime, samples), 0.06);
    std::int64_t cusps = 0;
    for (const Eye& eye : eyes(cube_directions(), 4.0)) {
        const test_traced::Contours found(runtime, meshed, eye.view());
        EXPECT_GT(found.curves.count(), 0);
        EXPECT_EQ(found.closed(), found.curves.count());
        EXPECT_EQ(found.report.broken + found.report.missed, 0);
        EXPECT_LE(test_traced::farthest_off(runtime, found.level, found.curves), 1e-6 * mesh.side);
        EXPECT_EQ(test_traced::run_alike(found.curves, 0.01 * mesh.side), 0);
        cusps += found.cusps();
    }
    EXPECT_GT(cusps, 100);
}

} // namespace
} // namespace hrbfnpr::curves::fitted_test
