// SPDX-License-Identifier: MIT
#include "mesh/sample.h"

#include "mesh/face_tree.h"
#include "meshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace sample_test {

namespace mesh = hrbfnpr::mesh;
namespace base = hrbfnpr::base;
using hrbfnpr::test::box;
using hrbfnpr::test::icosphere;
using namespace mesh_test;

namespace {

base::Runtime runtime(int threads) {
    return {nullptr, nullptr, nullptr, base::Parallel(threads, nullptr, nullptr), base::InstructionSet::automatic,
            nullptr, nullptr};
}

TEST(MeshSamples, LieOnTheMeshEvenOverItsArea) {
    const base::Runtime two = runtime(2);
    // A flat box. A seventh of its faces has nearly all of its area.
    const mesh::Mesh plate = made(two, box(1.0, 1.0, 0.01, 5));
    const mesh::MeshSamples samples = mesh::random_samples(two, plate, 20000, 1, 0);
    int on_lid = 0;
    for (std::int64_t i = 0; i < samples.position.size(); ++i) {
        const glm::dvec3 p = samples.position[i];
        const glm::dvec3 n = samples.normal[i];
        ASSERT_NEAR(glm::length(n), 1.0, 1e-12);
        const double off = std::min({p.x, 1.0 - p.x, p.y, 1.0 - p.y, p.z, 0.01 - p.z});
        ASSERT_NEAR(off, 0.0, 1e-12);
        on_lid += n.z > 0.9 ? 1 : 0;
    }
    EXPECT_NEAR(on_lid, 20000.0 / 2.04, 300.0);
}

TEST(MeshSamples, KeepTheirDistanceInEveryPrefix) {
    const base::Runtime two = runtime(2);
    const mesh::Mesh sphere = made(two, icosphere(4));
    const mesh::MeshSamples samples = mesh::even_samples(two, sphere, 1000, 40000, 1);
    for (const std::int64_t count : {100, 1000}) {
        double least = HUGE_VAL;
        for (std::int64_t i = 0; i < count; ++i)
            for (std::int64_t j = 0; j < i; ++j)
                least = std::min(least, glm::distance(samples.position[i], samples.position[j]));
        // The distance in a triangular lattice: sqrt(2 area / (sqrt(3) count)).
        const double lattice = std::sqrt(8.0 * 3.14159265 / (1.7320508 * static_cast<double>(count)));
        EXPECT_GT(least, 0.65 * lattice) << count;
    }
    EXPECT_EQ(mesh::even_samples(two, sphere, 300, 0, 1).position.size(), 300);
}

} // namespace

} // namespace sample_test
