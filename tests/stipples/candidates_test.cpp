// SPDX-License-Identifier: MIT
// Tests the candidates of the blue-noise order: on the planes of cells, in layers, and both side by side.
#include "support/point_sets.h"

#include "geometry/morton.h"
#include "stipples/candidates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace hrbfnpr::stipples::candidates_test {
namespace {

using namespace marks;
using namespace test;

constexpr double sphere_area = 4.0 * 3.14159265358979323846;

struct Cover {
    Cover(const implicit::Implicit& surface, const glm::dvec3& seed, double side)
        : site{runtime(), surface, 1e-6, 1}, cells(found(site, seed, side)), classified(classify_cells(site, cells)) {}

    static SurfaceCells found(const Site& site, const glm::dvec3& seed, double side) {
        geometry::VecArray seeds(runtime().memory);
        seeds.push_back(seed);
        return find_surface_cells(site, seeds, site.implicit.bounds().grown(0.1), side);
    }
    [[nodiscard]] std::array<std::int64_t, 3> kinds() const {
        std::array<std::int64_t, 3> count{};
        for (const ClassifiedCell& cell : classified.cell) ++count[static_cast<std::size_t>(cell.kind)];
        return count;
    }

    Site site;
    SurfaceCells cells;
    ClassifiedCells classified;
};

glm::dvec3 place_of(Candidates& candidates, std::int64_t place) {
    const OrderBlock all = candidates.places();
    return candidates.grid.origin +
           glm::dvec3(all.at(OrderGroup::x, place), all.at(OrderGroup::y, place), all.at(OrderGroup::z, place));
}

TEST(PlaneCandidates, AreUsedWhereTheSurfaceIsFlatWithinCells) {
    const auto fine = Cover(Sphere(), {1.0, 0.0, 0.0}, 0.05).kinds();
    EXPECT_GT(fine[1], 2000);
    EXPECT_EQ(fine[2], 0) << "a sphere of twenty sides' radius";
    const auto coarse = Cover(Sphere(), {1.0, 0.0, 0.0}, 0.4).kinds();
    EXPECT_EQ(coarse[1], 0) << "a sphere of two and a half";
    EXPECT_GT(coarse[2], 50);
    const auto thin = Cover(ThinSlab(0.004), {0.0, 0.0, 0.002}, 0.05).kinds();
    EXPECT_EQ(thin[1], 0) << "the other face is in the same cells";
    EXPECT_GT(thin[2], 1000);
}

TEST(PlaneCandidates, LieEvenlyInTheirCellsNearTheSurface) {
    const Sphere sphere;
    Cover cover(sphere, {1.0, 0.0, 0.0}, 0.05);
    Candidates candidates = draw_candidates(cover.site, cover.cells, 40000, Kind::stipples);
    EXPECT_NEAR(static_cast<double>(candidates.count), 40000.0, 6000.0);
    EXPECT_NEAR(candidates.area, sphere_area, 0.01 * sphere_area);
    EXPECT_EQ(candidates.report.placed, candidates.count);
    // For random points on the sphere the number in a cap of 40 would vary by 6.3.
    constexpr int caps = 400;
    std::array<double, caps> in_cap{};
    const double cosine = 1.0 - 2.0 * 40.0 / static_cast<double>(candidates.count);
    for (std::int64_t cell = 0; cell < candidates.cells(); ++cell)
        for (std::int64_t at = candidates.first[cell]; at < candidates.first[cell] + candidates.number[cell]; ++at) {
            const glm::dvec3 p = place_of(candidates, at);
            EXPECT_NEAR(glm::length(p), 1.0, 0.001);
            const glm::dvec3 corner = candidates.grid.corner(geometry::morton_cell(candidates.code[cell]));
            for (int c = 0; c < 3; ++c) {
                EXPECT_GE(p[c], corner[c] - 1e-6);
                EXPECT_LE(p[c], corner[c] + candidates.grid.side + 1e-6);
            }
            for (int k = 0; k < caps; ++k) {
                const std::array<double, 3> q = spiral_point(k, caps);
                if (glm::dot(glm::normalize(p), glm::dvec3(q[0], q[1], q[2])) > cosine)
                    in_cap[static_cast<std::size_t>(k)] += 1.0;
            }
        }
    const double mean = std::accumulate(in_cap.begin(), in_cap.end(), 0.0) / caps;
    double squares = 0.0;
    for (const double n : in_cap) squares += (n - mean) * (n - mean) / caps;
    EXPECT_NEAR(mean, 40.0, 0.6);
    EXPECT_LT(std::sqrt(squares), 4.0);
}

// Memory that is not zeroed may have any content, here NaN.
TEST(Candidates, DoNotDependOnUninitializedMemory) {
    const auto filled = [](void*, std::uint64_t size, std::uint64_t alignment) {
        void* const memory = ::operator new (size, std::align_val_t{alignment});
        return std::memset(memory, 0xff, size);
    };
    const auto give_back = [](void*, void* memory, std::uint64_t, std::uint64_t alignment) {
        ::operator delete (memory, std::align_val_t{alignment});
    };
    const Torus torus;
    const PointSet plain = make(torus, blue({Kind::stipples}, 3000));
    const base::Runtime poisoned(filled, give_back, nullptr, base::Parallel(0, nullptr, nullptr),
                                 base::InstructionSet::automatic, nullptr, nullptr);
    const PointSet set = generate::generate(poisoned, torus, {}, blue({Kind::stipples}, 3000));
    ASSERT_EQ(of(set, Kind::stipples).count(), of(plain, Kind::stipples).count());
    for (std::int64_t i = 0; i < 3 * of(set, Kind::stipples).count(); ++i)
        ASSERT_EQ(of(set, Kind::stipples).position[i], of(plain, Kind::stipples).position[i]);
}

// A part of the candidates, chosen by tickets, has the same spread as all.
TEST(PlaneCandidates, ARandomPartIsSpreadLikeAll) {
    const Sphere sphere;
    Cover cover(sphere, {1.0, 0.0, 0.0}, 0.05);
    Candidates candidates = draw_candidates(cover.site, cover.cells, 40000, Kind::stipples);
    for (const double share : {0.5, 0.1, 0.01}) {
        const auto limit = static_cast<std::uint64_t>(share * 4294967296.0);
        const double expected = share * static_cast<double>(candidates.count);
        std::int64_t upper = 0;
        std::int64_t taken = 0;
        for (std::int64_t cell = 0; cell < candidates.cells(); ++cell) {
            candidates.for_taken(cell, limit, [&](std::int64_t place) {
                EXPECT_GE(place, candidates.first[cell]);
                EXPECT_LT(place, candidates.first[cell] + candidates.number[cell]);
                EXPECT_LT(candidates.ticket[place], limit);
                upper += place_of(candidates, place).z > 0.0 ? 1 : 0;
                ++taken;
            });
        }
        EXPECT_NEAR(static_cast<double>(taken), expected, 4.0 * std::sqrt(expected));
        EXPECT_NEAR(static_cast<double>(upper), 0.5 * expected, 4.0 * std::sqrt(expected));
    }
}

// The distance to a cube of half the side 0.5, with edges rounded by 0.08.
Field rounded_cube(const glm::dvec3& p) {
    const glm::dvec3 beyond = glm::abs(p) - 0.5;
    const glm::dvec3 outside = glm::max(beyond, 0.0);
    const glm::dvec3 sign = glm::sign(p);
    if (const double far = glm::length(outside); far > 0.0) return {far - 0.08, sign * outside / far, {}};
    const int axis = beyond.x > beyond.y ? (beyond.x > beyond.z ? 0 : 2) : (beyond.y > beyond.z ? 1 : 2);
    glm::dvec3 gradient(0.0);
    gradient[axis] = sign[axis];
    return {beyond[axis] - 0.08, gradient, {}};
}

TEST(PlaneCandidates, AreDrawnWithinTheTrialLimit) {
    const Sphere sphere;
    const Cover cover(sphere, {1.0, 0.0, 0.0}, 0.05);
    const auto draw = [&](double most_trials, const base::Progress& progress) {
        return draw_on_planes(cover.site.with(progress), cover.classified, stream_of(Kind::stipples), 1e30, most_trials)
            .all;
    };
    const std::int64_t flat = cover.kinds()[1];
    ASSERT_GT(flat, 2000);
    const std::int64_t drawn = draw(100.0 * static_cast<double>(flat), {});
    EXPECT_LE(drawn, 101 * flat);
    EXPECT_GT(drawn, 20 * flat);
    base::Operation operation;
    operation.begin();
    operation.cancel();
    expect_error(Status::cancelled, {}, [&] { draw(1e30, base::Progress(&operation)); });
}

// The cube is flat except for its edges. Candidates on planes and in layers meet without a seam.
TEST(Candidates, OnPlanesAndInLayersHaveTheSameDensity) {
    const AnyField cube({glm::dvec3(-0.58), glm::dvec3(0.58)}, rounded_cube);
    constexpr double pi = 3.14159265358979323846;
    constexpr double area = 6.0 + 12.0 * (0.5 * pi * 0.08) + 4.0 * pi * 0.08 * 0.08;
    Cover cover(cube, {0.0, 0.0, 0.58}, 0.04);
    const auto kinds = cover.kinds();
    EXPECT_GT(kinds[1], 2000);
    EXPECT_GT(kinds[2], 500);
    constexpr double density = 10000.0;
    constexpr std::uint32_t stream = stream_of(Kind::stipples);
    const PlaneCandidates planes = draw_on_planes(cover.site, cover.classified, stream, density, 1e300);
    LayerCandidates layer = layer_candidates(cover.classified, stream, 60000);
    draw_in_layer(cover.site, cover.classified, density, layer);
    EXPECT_GT(layer.projection.size(), 5000);
    for (const Projection& projection : layer.projection)
        EXPECT_NE(cover.classified.kind(projection.cell), CellKind::flat);
    EXPECT_NEAR(planes.area() + layer.area(), area, 0.02 * area);
    // Counts strips along a face and across its rounded ends. Each should have the same number for its area.
    std::array<double, 12> strip{};
    const auto count = [&](const glm::dvec3& p) {
        if (p.z > 0.5 && std::abs(p.y) < 0.45 && std::abs(p.x) < 0.5)
            strip[static_cast<std::size_t>(12.0 * (p.x + 0.5))] += 1.0;
    };
    Candidates candidates = draw_candidates(cover.site, cover.cells, 70000, Kind::stipples);
    for (std::int64_t cell = 0; cell < candidates.cells(); ++cell)
        for (std::int64_t at = candidates.first[cell]; at < candidates.first[cell] + candidates.number[cell]; ++at)
            count(place_of(candidates, at));
    const double mean = std::accumulate(strip.begin() + 2, strip.end() - 2, 0.0) / 8.0;
    for (std::size_t k = 0; k < strip.size(); ++k) {
        const bool end = k < 2 || k >= 10; // layers may have more candidates
        EXPECT_NEAR(strip[k], mean, (end ? 0.45 : 0.08) * mean) << k;
        EXPECT_GT(strip[k], 0.9 * mean) << k;
    }
}

// The distance that f suggests is half of the true one.
TEST(Candidates, SufficeForAFunctionThatIsNoDistance) {
    const AnyField signed_square({glm::dvec3(-1.0), glm::dvec3(1.0)}, [](const glm::dvec3& p) {
        const double far = glm::length(p) - 1.0;
        return Field{far * std::abs(far), 2.0 * std::abs(far) * glm::normalize(p), {}};
    });
    Cover cover(signed_square, {1.0, 0.0, 0.0}, 0.05);
    EXPECT_EQ(cover.kinds()[1], 0) << "its cells' planes contradict each other";
    Candidates candidates = draw_candidates(cover.site, cover.cells, 20000, Kind::stipples);
    EXPECT_GT(candidates.count, 16000);
    for (std::int64_t cell = 0; cell < candidates.cells(); ++cell)
        for (std::int64_t at = candidates.first[cell]; at < candidates.first[cell] + candidates.number[cell]; ++at)
            EXPECT_NEAR(glm::length(place_of(candidates, at)), 1.0, 0.01);
}

} // namespace
} // namespace hrbfnpr::stipples::candidates_test
