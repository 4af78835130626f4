// SPDX-License-Identifier: MIT
#include "orient/directions.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::orient {
namespace {

constexpr std::int64_t planes_a_task = 512;

struct Symmetric {
    double a[3][3];
    double v[3][3]; // columns: eigenvectors
};

// Jacobi's rotation that zeroes a[p][q].
void rotate(Symmetric& m, int p, int q) noexcept {
    if (m.a[p][q] == 0.0) return;
    const double theta = (m.a[q][q] - m.a[p][p]) / (2.0 * m.a[p][q]);
    const double t = (theta >= 0.0 ? 1.0 : -1.0) / (std::abs(theta) + std::hypot(theta, 1.0));
    const double c = 1.0 / std::sqrt(t * t + 1.0);
    const double s = t * c;
    for (auto& row : m.a) {
        const double kp = row[p];
        row[p] = c * kp - s * row[q];
        row[q] = s * kp + c * row[q];
    }
    for (int k = 0; k < 3; ++k) {
        const double pk = m.a[p][k];
        m.a[p][k] = c * pk - s * m.a[q][k];
        m.a[q][k] = s * pk + c * m.a[q][k];
    }
    for (auto& row : m.v) {
        const double kp = row[p];
        row[p] = c * kp - s * row[q];
        row[q] = s * kp + c * row[q];
    }
}

} // namespace

void Moments::add(const glm::dvec3& p, double weight) noexcept {
    count += weight;
    sum += weight * p;
    const glm::dvec3 w = weight * p;
    square[0] += w.x * p.x;
    square[1] += w.x * p.y;
    square[2] += w.x * p.z;
    square[3] += w.y * p.y;
    square[4] += w.y * p.z;
    square[5] += w.z * p.z;
}

Plane plane_of(const Moments& moments) noexcept {
    constexpr int sweeps = 8; // quadratic convergence: four are enough
    Plane plane;
    if (!(moments.count > 0.0)) return plane;
    const glm::dvec3 c = plane.centre = moments.sum / moments.count;
    const auto& s = moments.square;
    const double k = 1.0 / moments.count;
    Symmetric m{{{s[0] * k - c.x * c.x, s[1] * k - c.x * c.y, s[2] * k - c.x * c.z},
                 {s[1] * k - c.x * c.y, s[3] * k - c.y * c.y, s[4] * k - c.y * c.z},
                 {s[2] * k - c.x * c.z, s[4] * k - c.y * c.z, s[5] * k - c.z * c.z}},
                {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (int sweep = 0; sweep < sweeps; ++sweep) {
        rotate(m, 0, 1);
        rotate(m, 0, 2);
        rotate(m, 1, 2);
    }
    std::array<int, 3> order{0, 1, 2};
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return m.a[a][a] < m.a[b][b] || (m.a[a][a] == m.a[b][b] && a < b); });
    for (std::size_t i = 0; i < 3; ++i) plane.variance[i] = std::max(0.0, m.a[order[i]][order[i]]);
    plane.normal = glm::normalize(glm::dvec3(m.v[0][order[0]], m.v[1][order[0]], m.v[2][order[0]]));
    plane.along = glm::normalize(glm::dvec3(m.v[0][order[2]], m.v[1][order[2]], m.v[2][order[2]]));
    return plane;
}

Near::Near(const base::Runtime& runtime, const geometry::PointTree& tree, std::int64_t each,
           const base::Progress& progress)
    : size_(tree.size()), each_(std::clamp<std::int64_t>(each, 0, std::min(most, tree.size() - 1))),
      index_(runtime.memory) {
    index_.resize_for_overwrite(size_ * each_);
    runtime.parallel.for_chunks(size_, planes_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        std::array<std::int64_t, most> found;
        for (std::int64_t at = begin; at < end; ++at) {
            tree.nearest(
                tree.points()[at], each_, [](std::int64_t) { return true; },
                [&](std::int64_t other) { return other != at; }, found.data());
            for (std::int64_t k = 0; k < each_; ++k)
                index_[at * each_ + k] = static_cast<std::int32_t>(found[static_cast<std::size_t>(k)]);
        }
    });
}

geometry::VecArray plane_normals(const base::Runtime& runtime, const geometry::PointTree& tree, const Near& near,
                                 std::int64_t count, const base::Progress& progress) {
    geometry::VecArray normal(runtime.memory, tree.size());
    const auto used = static_cast<std::size_t>(std::min(count, near.each()));
    runtime.parallel.for_chunks(tree.size(), planes_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t at = begin; at < end; ++at) {
            const glm::dvec3 p = tree.points()[at];
            Moments moments;
            moments.add(glm::dvec3(0.0));
            for (const std::int32_t other : near.of(at).first(used)) moments.add(tree.points()[other] - p);
            normal.set(at, plane_of(moments).normal);
        }
    });
    return normal;
}

} // namespace hrbfnpr::orient
