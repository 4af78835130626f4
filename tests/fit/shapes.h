// SPDX-License-Identifier: MIT
// Samples in the form that fit() takes, and shorthands to call it.
#pragma once

#include "fit/fit.h"
#include "support/samples.h"

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace fit_test {

// Samples with access to points and normals as vectors.
struct Cloud : hrbfnpr::test::Samples {
    Cloud() = default;
    Cloud(hrbfnpr::test::Samples samples) : Samples(std::move(samples)) {} // NOLINT: they are the same

    void add(const glm::dvec3& p, const glm::dvec3& n) { Samples::add({p.x, p.y, p.z}, {n.x, n.y, n.z}); }
    [[nodiscard]] glm::dvec3 point(std::int64_t i) const { return vector(points, i); }
    [[nodiscard]] glm::dvec3 normal(std::int64_t i) const { return vector(normals, i); }
    // Maps every point p to scale * p + shift.
    [[nodiscard]] Cloud moved(double scale, const glm::dvec3& shift) const {
        Cloud result;
        for (std::int64_t i = 0; i < count(); ++i) result.add(scale * point(i) + shift, normal(i));
        return result;
    }

private:
    [[nodiscard]] static glm::dvec3 vector(const std::vector<double>& packed, std::int64_t i) {
        const auto at = static_cast<std::size_t>(3 * i);
        return {packed[at], packed[at + 1], packed[at + 2]};
    }
};

inline Cloud sphere(int count) { return hrbfnpr::test::sphere(count); }
inline Cloud torus(int count) { return hrbfnpr::test::even_torus(count); }
inline Cloud bumpy(int count) { return hrbfnpr::test::bumpy(count); }

inline hrbfnpr::base::InView view(const std::vector<double>& packed) {
    return {reinterpret_cast<const std::byte*>(packed.data()), static_cast<std::int64_t>(packed.size() / 3), 24,
            hrbfnpr::base::Scalar::float64, 3};
}

inline hrbfnpr::fit::FitInput input(const Cloud& cloud) {
    hrbfnpr::fit::FitInput result;
    result.points = view(cloud.points);
    result.normals = view(cloud.normals);
    return result;
}

inline hrbfnpr::fit::FitInput input(const Cloud& cloud, hrbfnpr::kernel::Kind kernel, std::int32_t degree) {
    hrbfnpr::fit::FitInput result = input(cloud);
    result.kernel = kernel;
    result.polynomial_degree = degree;
    return result;
}

struct Sampled {
    double value = 0.0;
    glm::dvec3 gradient{0.0};
};

inline Sampled at(const hrbfnpr::implicit::HrbfData& data, const glm::dvec3& p) {
    Sampled s;
    hrbfnpr::implicit::evaluate(data, {&p.x, &p.y, &p.z, 1},
                                {&s.value, {&s.gradient.x, &s.gradient.y, &s.gradient.z}, {}});
    return s;
}

// The first-order distance of p from the surface f = 0.
inline double distance(const hrbfnpr::implicit::HrbfData& data, const glm::dvec3& p) {
    const Sampled s = at(data, p);
    return s.value / glm::length(s.gradient);
}

} // namespace fit_test
