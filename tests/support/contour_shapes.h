// SPDX-License-Identifier: MIT
// Smooth surfaces with their Hessians, for tests of contours.
#pragma once

#include "support/analytic.h"

namespace hrbfnpr::test {

// x^2/a^2 + y^2/b^2 + z^2/c^2 - 1
class Ellipsoid : public Analytic {
public:
    explicit Ellipsoid(const glm::dvec3& axes) : Analytic({-axes, axes}), weight_(1.0 / (axes * axes)) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        const glm::dvec3 w = 2.0 * weight_;
        return {glm::dot(weight_, p * p) - 1.0, w * p, {w.x, 0.0, 0.0, w.y, 0.0, w.z}};
    }
    // Returns A v, where the surface is x^T A x = 1.
    [[nodiscard]] glm::dvec3 times(const glm::dvec3& v) const noexcept { return weight_ * v; }
    // Returns the Gaussian curvature.
    [[nodiscard]] double curvature(const glm::dvec3& p) const noexcept {
        const glm::dvec3 q = weight_ * p;
        return weight_.x * weight_.y * weight_.z / std::pow(glm::dot(q, q), 2.0);
    }

private:
    glm::dvec3 weight_;
};

// A thickened eight of genus 2: (x^2 (1 - x^2) - y^2)^2 + z^2 / 2 = 1/40
class TwoHoles : public Analytic {
public:
    TwoHoles() : Analytic({{-1.1, -0.65, -0.25}, {1.1, 0.65, 0.25}}) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        const double x2 = p.x * p.x;
        const double flat = x2 * (1.0 - x2) - p.y * p.y;
        const glm::dvec3 slope(2.0 * p.x - 4.0 * p.x * x2, -2.0 * p.y, 0.0);
        const Hessian bend{2.0 * flat * (2.0 - 12.0 * x2), 0.0, 0.0, -4.0 * flat, 0.0, 1.0};
        return {flat * flat + 0.5 * p.z * p.z - 0.025, 2.0 * flat * slope + glm::dvec3(0.0, 0.0, p.z),
                outer(slope, slope, 2.0) + bend};
    }
};

// The distance to a trefoil knot, minus the tube's radius.
class Knot : public Analytic {
public:
    static constexpr double tube = 0.13;

    Knot() : Analytic({glm::dvec3(-1.2, -1.2, -0.55), glm::dvec3(1.2, 1.2, 0.55)}) {
        for (std::size_t i = 0; i < coarse_.size(); ++i) coarse_[i] = curve(angle_of(i)).place;
    }

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        const Curve on = nearest(p);
        const glm::dvec3 away = p - on.place;
        const double distance = glm::length(away);
        const glm::dvec3 n = away / distance;
        const double speed2 = glm::dot(on.first, on.first);
        const glm::dvec3 along = on.first / std::sqrt(speed2);
        const glm::dvec3 bend = (on.second - glm::dot(on.second, along) * along) / speed2;
        const double bent = glm::dot(bend, n); // curvature of the centre line towards p
        return {distance - tube, n,
                outer(n, n, -1.0 / distance) + outer(along, along, -1.0 / distance - bent / (1.0 - distance * bent)) +
                    identity(1.0 / distance)};
    }

private:
    struct Curve {
        glm::dvec3 place, first, second;
    };

    static double angle_of(std::size_t i) noexcept { return 6.283185307179586 * static_cast<double>(i) / 96.0; }
    // The curve ((2 + cos 3t) (cos 2t, sin 2t), 1.2 sin 3t), scaled by a third.
    static Curve curve(double t) noexcept {
        const double c2 = std::cos(2.0 * t), s2 = std::sin(2.0 * t), c3 = std::cos(3.0 * t), s3 = std::sin(3.0 * t);
        const double r = 2.0 + c3;
        constexpr double scale = 1.0 / 3.0;
        return {scale * glm::dvec3(r * c2, r * s2, 1.2 * s3),
                scale * glm::dvec3(-3.0 * s3 * c2 - 2.0 * r * s2, -3.0 * s3 * s2 + 2.0 * r * c2, 3.6 * c3),
                scale * glm::dvec3(-9.0 * c3 * c2 + 12.0 * s3 * s2 - 4.0 * r * c2,
                                   -9.0 * c3 * s2 - 12.0 * s3 * c2 - 4.0 * r * s2, -10.8 * s3)};
    }
    [[nodiscard]] Curve nearest(const glm::dvec3& p) const noexcept {
        std::size_t best = 0;
        for (std::size_t i = 1; i < coarse_.size(); ++i)
            if (glm::dot(coarse_[i] - p, coarse_[i] - p) < glm::dot(coarse_[best] - p, coarse_[best] - p)) best = i;
        double t = angle_of(best);
        Curve on = curve(t);
        for (int step = 0; step < 8; ++step) {
            const double slope = glm::dot(on.place - p, on.first);
            const double rise = glm::dot(on.first, on.first) + glm::dot(on.place - p, on.second);
            const double by = slope / std::max(rise, 0.2 * glm::dot(on.first, on.first));
            t -= by;
            on = curve(t);
            if (std::abs(by) < 1e-9) break;
        }
        return on;
    }

    std::array<glm::dvec3, 96> coarse_;
};

} // namespace hrbfnpr::test
