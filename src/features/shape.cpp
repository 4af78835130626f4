// SPDX-License-Identifier: MIT
#include "features/shape.h"

#include "geometry/tangent_frame.h"
#include "surface/curvature.h"

#include <algorithm>
#include <atomic>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

// Third derivatives by sums over 100 000 centres take half a millisecond a point.
constexpr std::int64_t points_a_look = 32;
constexpr auto shape_batch = static_cast<std::size_t>(points_a_look);

glm::dvec3 times(const std::array<double, 6>& h, const glm::dvec3& v) noexcept {
    return {h[0] * v.x + h[1] * v.y + h[2] * v.z, h[1] * v.x + h[3] * v.y + h[4] * v.z,
            h[2] * v.x + h[4] * v.y + h[5] * v.z};
}

// T(v, ., .) as a symmetric matrix.
std::array<double, 6> contracted(const std::array<double, 10>& t, const glm::dvec3& v) noexcept {
    return {t[0] * v.x + t[1] * v.y + t[2] * v.z, t[1] * v.x + t[3] * v.y + t[4] * v.z,
            t[2] * v.x + t[4] * v.y + t[5] * v.z, t[3] * v.x + t[6] * v.y + t[7] * v.z,
            t[4] * v.x + t[7] * v.y + t[8] * v.z, t[5] * v.x + t[8] * v.y + t[9] * v.z};
}

struct ShapeBatch {
    std::array<std::array<double, shape_batch>, 6> hessian;
    std::array<std::array<double, shape_batch>, 10> third;

    [[nodiscard]] implicit::ThirdBatch out() noexcept {
        implicit::ThirdBatch to;
        for (std::size_t c = 0; c < hessian.size(); ++c) to.hessian[c] = hessian[c].data();
        for (std::size_t c = 0; c < third.size(); ++c) to.third[c] = third[c].data();
        return to;
    }
    [[nodiscard]] ShapePoint at(std::size_t i, const glm::dvec3& gradient) const noexcept {
        std::array<double, 6> h;
        std::array<double, 10> t;
        for (std::size_t c = 0; c < h.size(); ++c) h[c] = hessian[c][i];
        for (std::size_t c = 0; c < t.size(); ++c) t[c] = third[c][i];
        return shape_point(gradient, h, t);
    }
};

// Derivatives of II(u, v) = -H(u, v) / |g| along w, for tangent vectors that keep to the surface.  With
// D_w n = P H w / |g| and D_w |g| = H(n, w), the projections onto the tangent plane in -P H P / |g| add
//   C(u, v, w) = -T(u, v, w) / |g| + (H(u, w) H(n, v) + H(v, w) H(n, u) + H(u, v) H(n, w)) / |g|^2,
// which is symmetric, as Codazzi's equations demand.  [Rusinkiewicz 2004 has the case of a mesh.]
std::array<double, 4> change_of_curvature(const std::array<glm::dvec3, 2>& d, const glm::dvec2& bend,
                                          const glm::dvec2& normal_part, const std::array<double, 10>& third,
                                          double slope) noexcept {
    const std::array<double, 6> first = contracted(third, d[0]);
    const std::array<double, 6> other = contracted(third, d[1]);
    const glm::dvec3 first1 = times(first, d[0]);
    const glm::dvec3 other2 = times(other, d[1]);
    // In principal directions H(d_i, d_j) / |g| = -k_i or 0; normal_part is H(n, d_i) / |g|.
    return {-glm::dot(first1, d[0]) / slope - 3.0 * bend.x * normal_part.x,
            -glm::dot(first1, d[1]) / slope - bend.x * normal_part.y,
            -glm::dot(other2, d[0]) / slope - bend.y * normal_part.x,
            -glm::dot(other2, d[1]) / slope - 3.0 * bend.y * normal_part.y};
}

bool finite(const ShapePoint& s) noexcept {
    return std::isfinite(s.k1) && std::isfinite(s.k2) &&
           std::all_of(s.c.begin(), s.c.end(), [](double c) { return std::isfinite(c); });
}

} // namespace

ShapePoint shape_point(const glm::dvec3& gradient, const std::array<double, 6>& hessian,
                       const std::array<double, 10>& third) noexcept {
    const double slope = glm::length(gradient);
    if (!(slope > 0.0) || !std::isfinite(slope)) return {};
    ShapePoint result;
    result.normal = gradient / slope;
    const geometry::TangentFrame frame = geometry::combing_frame(result.normal);
    const glm::dvec3 hr = times(hessian, frame.r);
    const glm::dvec3 hu = times(hessian, frame.u);
    const surface::Eigen2 eigen = surface::symmetric_eigen2(
        -glm::dot(frame.r, hr) / slope, -glm::dot(frame.u, hr) / slope, -glm::dot(frame.u, hu) / slope);
    result.k1 = eigen.high;
    result.k2 = eigen.low;
    result.d1 = glm::normalize(eigen.cosine * frame.r + eigen.sine * frame.u);
    const glm::dvec3 hn = times(hessian, result.normal) / slope;
    result.c =
        change_of_curvature({result.d1, result.d2()}, {result.k1, result.k2}, result.in_tangent(hn), third, slope);
    if (!finite(result)) return {};
    return result;
}

void measure_shape(const base::Runtime& runtime, const implicit::ShapeSource& source,
                   const geometry::VecArray& position, const geometry::VecArray& gradient,
                   base::Array<ShapePoint>& result, const base::Progress& progress) {
    const std::int64_t count = position.size();
    result.resize_for_overwrite(count);
    std::atomic<std::int64_t> done{0};
    const base::Parallel threads = source.concurrent() ? runtime.parallel : base::Parallel();
    threads.for_chunks(count, points_a_look, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        base::Boxed<ShapeBatch> at(runtime.memory);
        source.evaluate({position.x.data() + begin, position.y.data() + begin, position.z.data() + begin, end - begin},
                        at->out());
        for (std::int64_t i = begin; i < end; ++i) result[i] = at->at(static_cast<std::size_t>(i - begin), gradient[i]);
        const std::int64_t now = done.fetch_add(end - begin, std::memory_order_relaxed) + end - begin;
        progress.update(static_cast<double>(now) / static_cast<double>(count));
    });
}

} // namespace hrbfnpr::curves
