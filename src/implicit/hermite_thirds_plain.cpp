// SPDX-License-Identifier: MIT
#include "implicit/hermite_thirds.h"

#include "geometry/vec.h"

#include <array>
#include <cmath>

namespace hrbfnpr::implicit {
namespace {

constexpr std::array<std::array<glm::length_t, 2>, 6> second = {{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
constexpr std::array<std::array<glm::length_t, 3>, 10> third = {
    {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 1, 1}, {0, 1, 2}, {0, 2, 2}, {1, 1, 1}, {1, 1, 2}, {1, 2, 2}, {2, 2, 2}}};

struct Source {
    glm::dvec3 beta;
    double alpha;
};

void add_source(const kernel::Radial& k, double e, const glm::dvec3& d, const Source& s, const ThirdTargets& t,
                std::int64_t at) noexcept {
    const double q = glm::dot(d, s.beta);
    const glm::dvec3 v = (k.b * s.alpha - k.c * q) * d - k.b * s.beta;
    const glm::dvec3 w = (k.c * s.alpha - e * q) / 3.0 * d - k.c * s.beta;
    for (std::size_t c = 0; c < 6; ++c) {
        const auto [i, j] = second[c];
        const double iso = i == j ? k.a * s.alpha - k.b * q : 0.0;
        t.hessian[c][at] += iso + v[i] * d[j] - k.b * d[i] * s.beta[j];
    }
    for (std::size_t c = 0; c < 10; ++c) {
        const auto [i, j, l] = third[c];
        const double traces = (i == j ? v[l] : 0.0) + (i == l ? v[j] : 0.0) + (j == l ? v[i] : 0.0);
        t.third[c][at] += traces + w[i] * d[j] * d[l] + w[j] * d[i] * d[l] + w[l] * d[i] * d[j];
    }
}

} // namespace

void add_hermite_thirds_plainly(kernel::Kind kind, double kernel_radius, double smoothing, const Sources& sources,
                                const ThirdTargets& targets) noexcept {
    for (std::int64_t i = 0; i < targets.count; ++i) {
        for (std::int64_t j = 0; j < sources.count; ++j) {
            const glm::dvec3 d(targets.x[i] - sources.x[j], targets.y[i] - sources.y[j], targets.z[i] - sources.z[j]);
            const double r = std::sqrt(glm::dot(d, d) + smoothing);
            add_source(kernel::radial(kind, kernel_radius, r), kernel::radial_fourth(kind, kernel_radius, r), d,
                       {{sources.beta_x[j], sources.beta_y[j], sources.beta_z[j]}, sources.alpha[j]}, targets, i);
        }
    }
}

} // namespace hrbfnpr::implicit
