// SPDX-License-Identifier: MIT
// Rays and nearest places on the triangles of a mesh, per second.
#pragma once

#include "geometry/bvh.h"
#include "rays.h"
#include "support/meshes.h"
#include "timing.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace bench {

namespace lib = hrbfnpr;
using hrbfnpr::test::Triangles;

// A sphere with bumps, of 4 rows^2 faces.
[[nodiscard]] inline Triangles bumpy_ball(int rows) {
    constexpr double pi = 3.14159265358979323846;
    Triangles mesh;
    for (int i = 0; i <= rows; ++i)
        for (int j = 0; j < 2 * rows; ++j) {
            const double a = pi * i / rows, b = pi * j / rows;
            const double r =
                1.0 + 0.08 * std::sin(9.0 * a) * std::sin(7.0 * b) + 0.02 * std::sin(40.0 * a) * std::sin(31.0 * b);
            static_cast<void>(mesh.add(r * std::sin(a) * std::cos(b), r * std::sin(a) * std::sin(b), r * std::cos(a)));
        }
    const auto at = [&](int i, int j) { return i * 2 * rows + j % (2 * rows); };
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < 2 * rows; ++j) {
            if (i > 0) mesh.face(at(i, j), at(i + 1, j), at(i, j + 1));
            if (i < rows - 1) mesh.face(at(i, j + 1), at(i + 1, j), at(i + 1, j + 1));
        }
    return mesh;
}

// Divides each face into four.
[[nodiscard]] inline Triangles divided(const Triangles& mesh) {
    Triangles result;
    result.vertices = mesh.vertices;
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> known;
    const auto middle = [&](std::int32_t a, std::int32_t b) {
        const auto [found, added] = known.insert({{std::min(a, b), std::max(a, b)}, 0});
        const auto at = [&](std::int32_t v, std::size_t k) {
            return mesh.vertices[3 * static_cast<std::size_t>(v) + k];
        };
        if (added)
            found->second =
                result.add(0.5 * (at(a, 0) + at(b, 0)), 0.5 * (at(a, 1) + at(b, 1)), 0.5 * (at(a, 2) + at(b, 2)));
        return found->second;
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const std::int32_t a = mesh.triangles[i], b = mesh.triangles[i + 1], c = mesh.triangles[i + 2];
        const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        result.face(a, ab, ca);
        result.face(ab, b, bc);
        result.face(ca, bc, c);
        result.face(ab, bc, ca);
    }
    return result;
}

struct MeshRay {
    glm::dvec3 origin, direction;
    double t_max;
};

// A mesh, and the rays that are cast at it.
class MeshRays {
public:
    MeshRays(const Triangles& mesh, int threads)
        : runtime_(nullptr, nullptr, nullptr, lib::base::Parallel(threads, nullptr, nullptr),
                   lib::base::InstructionSet::automatic, nullptr, nullptr),
          vertex_(runtime_.memory), triangle_(runtime_.memory) {
        for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) {
            vertex_.push_back({mesh.vertices[i], mesh.vertices[i + 1], mesh.vertices[i + 2]});
            bounds_.extend(vertex_.back());
        }
        for (std::size_t i = 0; i < mesh.triangles.size(); i += 3)
            triangle_.push_back({mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]});
    }
    [[nodiscard]] lib::geometry::Bvh build() const { return {runtime_, vertex_, triangle_}; }

    // Rays from one eye through the pixels of a square picture.
    [[nodiscard]] std::vector<MeshRay> picture(int side) const {
        const glm::dvec3 eye = bounds_.centre() + 1.2 * bounds_.diagonal() * glm::dvec3(0.6, 0.5, 0.62);
        const glm::dvec3 ahead = glm::normalize(bounds_.centre() - eye);
        const glm::dvec3 right = glm::normalize(glm::cross(ahead, glm::dvec3(0.0, 1.0, 0.0)));
        const glm::dvec3 up = glm::cross(right, ahead);
        std::vector<MeshRay> rays;
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column)
                rays.push_back({eye,
                                ahead + 0.42 * ((2.0 * column + 1.0) / side - 1.0) * right +
                                    0.42 * ((2.0 * row + 1.0) / side - 1.0) * up,
                                std::numeric_limits<double>::infinity()});
        return rays;
    }
    // Places on evenly chosen faces, with 16 rays each whose density is the cosine to the normal. They reach as far as
    // ambient occlusion does.
    [[nodiscard]] std::vector<MeshRay> occlusion(int places) const {
        RandomNumbers random;
        std::vector<MeshRay> rays;
        for (std::int64_t i = 0; i < places; ++i) {
            const auto& t = triangle_[i * triangle_.size() / places];
            const glm::dvec3 a = vertex_[t[0]], b = vertex_[t[1]], c = vertex_[t[2]];
            const glm::dvec3 area = glm::cross(b - a, c - a);
            if (!(glm::dot(area, area) > 0.0)) continue;
            const glm::dvec3 normal = glm::normalize(area);
            const glm::dvec3 place = (a + b + c) / 3.0 + 1e-5 * bounds_.diagonal() * normal;
            for (int k = 0; k < 16; ++k)
                rays.push_back(
                    {place, glm::normalize(normal + 0.9999 * unit_vector(random)), 0.35 * bounds_.diagonal()});
        }
        return rays;
    }
    // Rays from anywhere in the ball around the mesh, in any direction.
    [[nodiscard]] std::vector<MeshRay> random(int count) const {
        RandomNumbers numbers;
        std::vector<MeshRay> rays;
        for (int i = 0; i < count; ++i) {
            const double off = 0.5 * bounds_.diagonal() * std::cbrt(numbers());
            const glm::dvec3 from = bounds_.centre() + off * unit_vector(numbers);
            rays.push_back({from, unit_vector(numbers), std::numeric_limits<double>::infinity()});
        }
        return rays;
    }

    // Returns how many millions of calls a second test(i) makes on all threads, for i below `count`.
    template <class Test>
    [[nodiscard]] double rate(std::size_t count, Test&& test) const {
        std::vector<double> times;
        for (int run = 0; run < 3; ++run)
            times.push_back(seconds([&] {
                runtime_.parallel.for_chunks(static_cast<std::int64_t>(count), 1024,
                                             [&](std::int64_t begin, std::int64_t end) {
                                                 for (; begin < end; ++begin) test(static_cast<std::size_t>(begin));
                                             });
            }));
        return 1e-6 * static_cast<double>(count) / median(times);
    }

    [[nodiscard]] const lib::base::Runtime& runtime() const noexcept { return runtime_; }

private:
    [[nodiscard]] static glm::dvec3 unit_vector(RandomNumbers& random) {
        const auto u = random.unit_vector();
        return {u[0], u[1], u[2]};
    }

    lib::base::Runtime runtime_;
    lib::base::Array<glm::dvec3> vertex_;
    lib::base::Array<lib::geometry::Bvh::Triangle> triangle_;
    lib::geometry::Bounds bounds_;
};

inline void report_mesh_rays(const std::string& name, const Triangles& mesh, int threads) {
    const MeshRays rays(mesh, threads);
    const auto row = [&](const std::string& what, double value) {
        report(("rays_" + name + "_" + what).c_str(), value);
    };
    row("faces", static_cast<double>(mesh.faces()));
    row("build_seconds", seconds([&] { static_cast<void>(rays.build()); }));
    const lib::geometry::Bvh bvh = rays.build();
    row("megabytes", 1e-6 * static_cast<double>(bvh.bytes()));
    const auto both = [&](const std::string& kind, const std::vector<MeshRay>& all) {
        row(kind + "_first", rays.rate(all.size(), [&](std::size_t i) {
            static_cast<void>(bvh.first_hit(all[i].origin, all[i].direction, 0.0, all[i].t_max));
        }));
        row(kind + "_any", rays.rate(all.size(), [&](std::size_t i) {
            static_cast<void>(bvh.any_hit(all[i].origin, all[i].direction, 0.0, all[i].t_max));
        }));
    };
    both("picture", rays.picture(1000));
    const std::vector<MeshRay> occlusion = rays.occlusion(60000);
    both("occlusion", occlusion);
    const std::vector<MeshRay> random = rays.random(500000);
    both("random", random);
    row("nearest_beside", rays.rate(occlusion.size() / 16, [&](std::size_t i) {
        static_cast<void>(bvh.nearest(occlusion[16 * i].origin + 0.02 * occlusion[16 * i].direction));
    }));
    row("nearest_random", rays.rate(50000, [&](std::size_t i) { static_cast<void>(bvh.nearest(random[i].origin)); }));
}

} // namespace bench
