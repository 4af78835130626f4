// SPDX-License-Identifier: MIT
#include "scenes/shapes.h"

#include <cmath>
#include <numbers>

namespace scenes {
namespace {

using Vec = std::array<double, 3>;

constexpr double tau = 2.0 * std::numbers::pi;

Vec scaled(const Vec& v, double s) { return {v[0] * s, v[1] * s, v[2] * s}; }
Vec sum(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec cross(const Vec& a, const Vec& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec unit(const Vec& v) { return scaled(v, 1.0 / std::hypot(v[0], v[1], v[2])); }

Vec trefoil_at(double t) {
    return {std::sin(t) + 2.0 * std::sin(2.0 * t), std::cos(t) - 2.0 * std::cos(2.0 * t), -std::sin(3.0 * t)};
}

Vec trefoil_tangent(double t) {
    return unit(
        {std::cos(t) + 4.0 * std::cos(2.0 * t), -std::sin(t) + 4.0 * std::sin(2.0 * t), -3.0 * std::cos(3.0 * t)});
}

} // namespace

Samples linked_tori(int count) {
    Samples samples;
    hrbfnpr::test::add_torus(samples, count, 0.32, {-0.5, 0, 0}, {1, 0, 0}, {0, 1, 0});
    hrbfnpr::test::add_torus(samples, count, 0.32, {0.5, 0, 0}, {0, 0, 1}, {1, 0, 0});
    return samples;
}

Samples trefoil(int count) {
    constexpr double radius = 0.35;
    constexpr int around = 8;
    Samples samples;
    const int rings = count / around;
    for (int ring = 0; ring < rings; ++ring) {
        const double t = tau * ring / rings;
        const Vec tangent = trefoil_tangent(t);
        const Vec e1 = unit(cross(tangent, {0.3, 0.2, 1.0}));
        const Vec e2 = cross(tangent, e1);
        for (int k = 0; k < around; ++k) {
            const double angle = tau * (k + 0.5 * (ring % 2)) / around; // staggered rings
            const Vec normal = sum(scaled(e1, std::cos(angle)), scaled(e2, std::sin(angle)));
            samples.add(sum(trefoil_at(t), scaled(normal, radius)), normal);
        }
    }
    return samples;
}

// (x^2 + 9/4 y^2 + z^2 - 1)^3 - x^2 z^3 - 9/80 y^2 z^3, in the equivalent form with cube roots. Its gradient is regular
// away from the z axis.
int taubin_heart(void* /*user*/, long long count, const double* points, double* value, double* gradient,
                 double* /*hessian*/) {
    for (long long i = 0; i < count; ++i) {
        const double x = points[3 * i];
        const double y = points[3 * i + 1];
        const double z = points[3 * i + 2];
        const double q = x * x + 9.0 / 80.0 * y * y + 1e-6; // softens the dimple on the z axis
        const double root = std::cbrt(q);
        value[i] = 0.5 * (x * x + 2.25 * y * y + z * z - 1.0 - z * root);
        if (gradient != nullptr) {
            const double slope = z / (3.0 * root * root);
            gradient[3 * i] = 0.5 * (2.0 * x - 2.0 * x * slope);
            gradient[3 * i + 1] = 0.5 * (4.5 * y - 9.0 / 40.0 * y * slope);
            gradient[3 * i + 2] = 0.5 * (2.0 * z - root);
        }
    }
    return 0;
}

} // namespace scenes
