// SPDX-License-Identifier: MIT
// Counts roots of f along a segment by brute force: many samples, and a search for the least |f| between them.
#pragma once

#include "support/analytic.h"

namespace hrbfnpr::curves::test_dense {

struct Along {
    const implicit::Implicit& implicit;
    glm::dvec3 from, to;

    [[nodiscard]] double operator()(double t) const {
        const glm::dvec3 p = from + t * (to - from);
        double f = 0.0;
        implicit.evaluate({&p.x, &p.y, &p.z, 1}, {&f, {}, {}});
        return f;
    }
};

// The least |f| in [a, b], where f has the sign of `sign` at the ends, by golden-section search.
inline double least(const Along& f, double a, double b, double sign) {
    constexpr double golden = 0.6180339887498949;
    double c = b - golden * (b - a), d = a + golden * (b - a);
    double fc = sign * f(c), fd = sign * f(d);
    for (int k = 0; k < 60; ++k) {
        if (fc < fd) {
            b = d;
            d = c;
            fd = fc;
            fc = sign * f(c = b - golden * (b - a));
        } else {
            a = c;
            c = d;
            fc = fd;
            fd = sign * f(d = a + golden * (b - a));
        }
    }
    return std::min(fc, fd);
}

// The number of roots in the open segment from 0 to 1.
inline int roots(const Along& f, int samples) {
    int count = 0;
    double before = f(0.0), now = f(1.0 / samples);
    if ((before < 0.0) != (now < 0.0)) ++count;
    for (int k = 2; k <= samples; ++k) {
        const double next = f(static_cast<double>(k) / samples);
        const double sign = now < 0.0 ? -1.0 : 1.0;
        if ((now < 0.0) != (next < 0.0))
            ++count;
        else if (sign * before > 0.0 && std::abs(now) <= std::abs(before) && std::abs(now) <= std::abs(next) &&
                 least(f, static_cast<double>(k - 2) / samples, static_cast<double>(k) / samples, sign) < 0.0)
            count += 2;
        before = now;
        now = next;
    }
    return count;
}

// Clips a segment to the region. Returns false if nothing is left.
inline bool clip(const geometry::Bounds& region, glm::dvec3& from, glm::dvec3& to) {
    double low = 0.0, high = 1.0;
    const glm::dvec3 way = to - from;
    for (int axis = 0; axis < 3; ++axis) {
        const double a = (region.min[axis] - from[axis]) / way[axis];
        const double b = (region.max[axis] - from[axis]) / way[axis];
        low = std::max(low, std::min(a, b));
        high = std::min(high, std::max(a, b));
    }
    const glm::dvec3 start = from;
    from = start + low * way;
    to = start + high * way;
    return low < high;
}

} // namespace hrbfnpr::curves::test_dense
