// SPDX-License-Identifier: MIT
// A function of Hermite samples, and points at which to evaluate it.
#pragma once

#include "fields.h"
#include "implicit/hrbf.h"

namespace test {

inline hrbfnpr::implicit::HrbfData hermite_data(hrbfnpr::base::Memory& memory, hrbfnpr::kernel::Kind kind,
                                                int centres) {
    hrbfnpr::implicit::HrbfData data(memory);
    data.kernel = kind;
    data.kernel_radius = kind == hrbfnpr::kernel::Kind::gaussian ? 0.8 : 1.5;
    data.polynomial_degree = -1;
    for (int j = 0; j < centres; ++j) {
        data.centre_position.push_back({scatter(7 * j), scatter(7 * j + 1), scatter(7 * j + 2)});
        data.beta.push_back({scatter(7 * j + 3), scatter(7 * j + 4), scatter(7 * j + 5)});
        data.alpha.push_back(scatter(7 * j + 6));
    }
    return data;
}

// The first target and every fifth one are centres.
inline Points targets(const hrbfnpr::implicit::HrbfData& data, int count) {
    Points points;
    for (int i = 0; i < count; ++i)
        points.add(i % 5 == 0 ? data.centre_position[i % data.count()]
                              : glm::dvec3(scatter(5000 + 3 * i), scatter(5001 + 3 * i), scatter(5002 + 3 * i)));
    return points;
}

} // namespace test
