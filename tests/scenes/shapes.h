// Point-normal samples of analytic shapes, well spread and the same everywhere.
#pragma once

#include <array>
#include <vector>

namespace scenes {

struct Samples {
    std::vector<double> points;  // packed x y z
    std::vector<double> normals; // unit, outward

    void add(const std::array<double, 3>& point, const std::array<double, 3>& normal);
    [[nodiscard]] long long count() const { return static_cast<long long>(points.size() / 3); }
};

// The six axis points of the unit sphere.
[[nodiscard]] Samples sphere_6();
// A torus about z: centre circle of radius 1, tube of radius 0.4.
[[nodiscard]] Samples torus(int count);
// Two linked tori, count samples each.
[[nodiscard]] Samples linked_tori(int count);
// A tube of radius 0.35 about the trefoil (sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t).
[[nodiscard]] Samples trefoil(int count);

// Taubin's heart as a function for hrbfnpr_model_create_custom, with its gradient.
int taubin_heart(void* user, long long count, const double* points, double* value, double* gradient, double* hessian);

} // namespace scenes
