// SPDX-License-Identifier: MIT
// How right the normals of noisy points can be at best: those of an estimator that knows the surface and the noise, and
// of each point its position only.
//
// For marks that are even on the true surface, exp(-d^2 / 2 sigma^2) is the likelihood that a point at the distance d
// came from a mark.  The mean normal by these weights is nearly the direction that is most often on the right side, and
// the first axis of their second moments is the direction with the largest squared cosine.  No method that must find
// the surface first can do better.
#pragma once

#include "calls.h"
#include "near_points.h"
#include "orient_shapes.h"

#include <algorithm>
#include <cmath>

namespace bench {

struct Bound {
    double right = 0.0;
    double angle = 0.0; // mean, in degrees
};

// Returns marks on the surface that the clean samples define.
inline Samples even_marks(hrbfnpr_context* context, const Samples& clean) {
    const scenes::Model model = fit(context, clean.points, clean.normals, HRBFNPR_TRIM_NEVER);
    const scenes::PointSet set = generate(context, model.get(), one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 200000));
    const hrbfnpr_point_set_info info = info_of(set.get());
    std::int64_t count = 0;
    const float* const position = attribute<float>(set.get(), 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
    const float* const normal = attribute<float>(set.get(), 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count);
    Samples marks;
    const auto vec = [](const float* at) { return Vec3{double{at[0]}, double{at[1]}, double{at[2]}}; };
    for (std::int64_t i = 0; i < 3 * count; i += 3) {
        const Vec3 p = vec(position + i);
        marks.add({info.origin[0] + p[0], info.origin[1] + p[1], info.origin[2] + p[2]}, vec(normal + i));
    }
    return marks;
}

class Likely {
public:
    void add(const double* normal, double weight) {
        for (std::size_t r = 0; r < 3; ++r) {
            mean_[r] += weight * normal[r];
            for (std::size_t c = 0; c < 3; ++c) moment_[r][c] += weight * normal[r] * normal[c];
        }
    }
    [[nodiscard]] const Vec3& mean() const { return mean_; }
    // Returns the first axis, by powers of the matrix.
    [[nodiscard]] Vec3 axis() const {
        Vec3 axis{0.48, 0.6, 0.64};
        for (int round = 0; round < 60; ++round) {
            const Vec3 next{dot(moment_[0], axis), dot(moment_[1], axis), dot(moment_[2], axis)};
            const double size = length(next);
            if (!(size > 0.0)) break;
            for (std::size_t c = 0; c < 3; ++c) axis[c] = next[c] / size;
        }
        return axis;
    }

private:
    Vec3 mean_{};
    std::array<Vec3, 3> moment_{};
};

// noisy: the clean samples, displaced by sigma.
inline Bound bound_of(hrbfnpr_context* context, const Samples& clean, const Samples& noisy, double sigma) {
    const Samples marks = even_marks(context, clean);
    const NearPoints near(marks.points, sigma);
    Bound bound;
    const auto count = static_cast<std::size_t>(noisy.count());
    for (std::size_t i = 0; i < count; ++i) {
        Likely likely;
        near.visit(noisy.points.data() + 3 * i, 5.0 * sigma, [&](std::size_t mark, double distance) {
            likely.add(marks.normals.data() + 3 * mark, std::exp(-0.5 * distance * distance / (sigma * sigma)));
            return true;
        });
        const Vec3 truth{noisy.normals[3 * i], noisy.normals[3 * i + 1], noisy.normals[3 * i + 2]};
        bound.right += dot(likely.mean(), truth) > 0.0 ? 1.0 : 0.0;
        bound.angle += std::acos(std::min(1.0, std::abs(dot(likely.axis(), truth)))) * 360.0 / tau;
    }
    bound.right /= static_cast<double>(count);
    bound.angle /= static_cast<double>(count);
    return bound;
}

} // namespace bench
