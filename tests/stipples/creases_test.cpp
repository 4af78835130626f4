// SPDX-License-Identifier: MIT
// Tests that stipples are as even beside creases as elsewhere.
#include "generate/generate.h"
#include "marks/assemble.h"
#include "support/runtime.h"
#include "support/sharp_shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace hrbfnpr::stipples::creases_test {
namespace {

using namespace test;

constexpr std::size_t strips = 8; // number of strips beside a crease, each half a spacing wide

base::Runtime& runtime() {
    static base::Runtime instance = with_threads(2);
    return instance;
}

marks::PointSet stippled(const implicit::Implicit& shape, std::int64_t budget) {
    generate::Settings settings;
    settings.layers.resize(1);
    settings.layers[0].budget = budget;
    return generate::generate(runtime(), shape, {}, settings);
}

glm::dvec3 vector_at(const base::Array<float>& numbers, std::int64_t i) {
    return {static_cast<double>(numbers[3 * i]), static_cast<double>(numbers[3 * i + 1]),
            static_cast<double>(numbers[3 * i + 2])};
}

geometry::VecArray places_of(const marks::PointSet& set) {
    geometry::VecArray places(runtime().memory);
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i)
        places.push_back(set.origin + vector_at(set.layers[0].position, i));
    return places;
}

// Returns the distances to the nearest neighbours, in spacings.
marks::NeighbourDistances distances_of(const geometry::VecArray& places, double area) {
    marks::NeighbourDistances near = marks::neighbour_distances(runtime(), places);
    near.mean /= std::sqrt(area / static_cast<double>(places.size()));
    return near;
}

// Counts marks of a cube in strips along its edges, and compares with the numbers expected from the strips' area.
TEST(StipplesAtCreases, AreNeitherSparseNorDenseAlongEdges) {
    const auto shape = sharp_cube();
    const Sphere ball;
    const geometry::VecArray even = places_of(stippled(ball, 20000));
    const marks::NeighbourDistances smooth = distances_of(even, 4.0 * std::acos(-1.0));
    for (const std::int64_t budget : {3000, 20000}) {
        const marks::PointSet set = stippled(*shape, budget);
        const geometry::VecArray places = places_of(set);
        const double spacing = std::sqrt(24.0 / static_cast<double>(places.size()));
        std::array<double, strips> found{};
        int off_normals = 0;
        for (std::int64_t i = 0; i < places.size(); ++i) {
            const glm::dvec3 a = glm::abs(odd_turn() * places[i]);
            const double most = std::max({a.x, a.y, a.z});
            const double least = std::min({a.x, a.y, a.z});
            EXPECT_NEAR(most, 1.0, 1e-5);
            const double edge = 1.0 - (a.x + a.y + a.z - most - least); // distance from the nearest edge
            const auto strip = static_cast<std::size_t>(std::max(0.0, edge) / (0.5 * spacing));
            if (strip < strips) ++found[strip];
            const glm::dvec3 normal = glm::abs(odd_turn() * vector_at(set.layers[0].normal, i));
            double along = 0.0;
            for (int axis = 0; axis < 3; ++axis)
                if (a[axis] > 1.0 - 1e-5) along = std::max(along, normal[axis]);
            off_normals += along < 0.999 ? 1 : 0;
        }
        EXPECT_EQ(off_normals, 0);
        for (std::size_t k = 0; k < strips; ++k) {
            const double inner = 1.0 - 0.5 * spacing * static_cast<double>(k);
            const double outer = inner - 0.5 * spacing;
            const double expected = 24.0 * (inner * inner - outer * outer) / (spacing * spacing);
            EXPECT_NEAR(found[k] / expected, 1.0, budget > 10000 ? 0.08 : 0.15) << budget << ", strip " << k;
        }
        const marks::NeighbourDistances near = distances_of(places, 24.0);
        EXPECT_NEAR(near.mean, smooth.mean, 0.035 * smooth.mean) << budget;
        EXPECT_LE(near.variation, 0.11) << budget;
    }
}

// Counts strips on both sides of a rim and of a groove.
TEST(StipplesAtCreases, AreEvenAtCurvedAndConcaveCreases) {
    const auto shape = stepped_shaft();
    const geometry::VecArray places = places_of(stippled(*shape, 20000));
    const double pi = std::acos(-1.0);
    const double spacing = std::sqrt(pi * (2.0 + 2.0 + 1.2) / static_cast<double>(places.size()));
    for (const double radius : {0.5, 1.0}) {
        double on_ring = 0.0;
        double on_side = 0.0;
        for (std::int64_t i = 0; i < places.size(); ++i) {
            const double r = std::hypot(places[i].x, places[i].y);
            const double z = places[i].z;
            const double from = radius < 0.75 ? r - radius : radius - r; // distance from the crease, on the ring z = 0
            if (std::abs(z) < 1e-5 && from >= 0.0 && from < spacing) ++on_ring;
            if (std::abs(r - radius) < 1e-5 && std::abs(z) < spacing && std::abs(z) >= 1e-5) ++on_side;
        }
        const double expected = 2.0 * pi * radius / spacing;
        EXPECT_NEAR(on_ring / expected, 1.0, 0.12) << radius;
        EXPECT_NEAR(on_side / expected, 1.0, 0.12) << radius;
    }
}

} // namespace
} // namespace hrbfnpr::stipples::creases_test
