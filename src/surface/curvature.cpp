// SPDX-License-Identifier: MIT
#include "surface/curvature.h"

#include "base/long_array.h"

#include "geometry/tangent_frame.h"
#include "implicit/evaluate_all.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::surface {
namespace {

// If the confidence is below this, principal directions are blended smoothly with the combing field, because they are
// noise at an umbilic.
constexpr double sure = 0.02;

struct Symmetric3 {
    const std::array<double, 6>& h; // in the order xx xy xz yy yz zz

    [[nodiscard]] glm::dvec3 times(const glm::dvec3& v) const noexcept {
        return {h[0] * v.x + h[1] * v.y + h[2] * v.z, h[1] * v.x + h[3] * v.y + h[4] * v.z,
                h[2] * v.x + h[4] * v.y + h[5] * v.z};
    }
};

// Returns the first direction in the combing frame, where the combing field has angle 0. Directions have no sign, so
// the average uses unit vectors of twice their angles.
glm::dvec2 blended(double cosine, double sine, double confidence) noexcept {
    if (confidence >= sure) return {cosine, sine};
    const double weight = glm::smoothstep(0.0, 1.0, confidence / sure);
    const double cosine2 = weight * (cosine * cosine - sine * sine) + (1.0 - weight);
    const double sine2 = weight * 2.0 * sine * cosine;
    const double angle = 0.5 * std::atan2(sine2, cosine2);
    return {std::cos(angle), std::sin(angle)};
}

bool finite(const std::array<double, 6>& numbers) noexcept {
    return std::all_of(numbers.begin(), numbers.end(), [](double number) { return std::isfinite(number); });
}

} // namespace

// Kindlmann et al. 2003: G = -P H P / |g| with P = I - n n^T has the eigenvalue 0 along n and the
// principal curvatures in the tangent plane, k = (T +- sqrt(2 F^2 - T^2)) / 2 with T the trace and
// F the Frobenius norm of G.  In a tangent basis G is [a b; b c], T = a + c and
// 2 F^2 - T^2 = (a - c)^2 + 4 b^2, which does not cancel near umbilics.
Curvature principal_curvature(const glm::dvec3& gradient, const std::array<double, 6>& hessian,
                              double diagonal) noexcept {
    const double slope = glm::length(gradient);
    if (!(slope > 0.0) || !std::isfinite(slope) || !finite(hessian)) return {};
    const glm::dvec3 n = gradient / slope;
    const geometry::TangentFrame frame = geometry::combing_frame(n);
    const Symmetric3 h{hessian};
    const glm::dvec3 hr = h.times(frame.r);
    const glm::dvec3 hu = h.times(frame.u);
    const Eigen2 eigen = symmetric_eigen2(-glm::dot(frame.r, hr) / slope, -glm::dot(frame.u, hr) / slope,
                                          -glm::dot(frame.u, hu) / slope);
    if (!std::isfinite(eigen.high) || !std::isfinite(eigen.low)) return {};
    Curvature result;
    result.k1 = eigen.high;
    result.k2 = eigen.low;
    // The last term makes the confidence 0 where the surface is flat at the scale of the model.
    const double scale = std::abs(eigen.high) + std::abs(eigen.low) + 1e-3 / diagonal;
    result.confidence = std::clamp((eigen.high - eigen.low) / scale, 0.0, 1.0);
    const glm::dvec2 first = blended(eigen.cosine, eigen.sine, result.confidence);
    result.d1 = glm::normalize(first.x * frame.r + first.y * frame.u);
    result.d2 = glm::cross(n, result.d1);
    return result;
}

void principal_curvatures(const base::Work& work, const implicit::Implicit& implicit, const geometry::VecArray& points,
                          base::Array<Curvature>& result) {
    const std::int64_t count = points.size();
    const double diagonal = implicit.diagonal();
    base::Array<double> columns(work.memory);
    // Touch memory now; otherwise each batch would touch new memory in all columns.
    base::resize_long(columns, 9 * count, work);
    implicit::FieldBatch fields;
    for (std::int64_t k = 0; k < 3; ++k) fields.gradient[static_cast<std::size_t>(k)] = columns.data() + k * count;
    for (std::int64_t k = 0; k < 6; ++k) fields.hessian[static_cast<std::size_t>(k)] = columns.data() + (3 + k) * count;
    implicit::evaluate_all(work, implicit, points, fields);
    result.resize_for_overwrite(count);
    work.for_chunks(count, 4096, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            std::array<double, 6> hessian;
            for (std::size_t k = 0; k < 6; ++k) hessian[k] = fields.hessian[k][i];
            const glm::dvec3 gradient(fields.gradient[0][i], fields.gradient[1][i], fields.gradient[2][i]);
            result[i] = principal_curvature(gradient, hessian, diagonal);
        }
    });
}

} // namespace hrbfnpr::surface
