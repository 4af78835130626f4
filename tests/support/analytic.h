// SPDX-License-Identifier: MIT
// Implicit functions for tests, with exact derivatives.
#pragma once

#include "implicit/implicit.h"
#include "support/samples.h"

#include <array>
#include <atomic>
#include <cmath>
#include <functional>

namespace hrbfnpr::test {

// The order is xx xy xz yy yz zz.
using Hessian = std::array<double, 6>;

struct Field {
    double value = 0.0;
    glm::dvec3 gradient{0.0};
    Hessian hessian{};
};

inline Hessian outer(const glm::dvec3& a, const glm::dvec3& b, double factor) {
    return {factor * a.x * b.x, factor * 0.5 * (a.x * b.y + a.y * b.x), factor * 0.5 * (a.x * b.z + a.z * b.x),
            factor * a.y * b.y, factor * 0.5 * (a.y * b.z + a.z * b.y), factor * a.z * b.z};
}

inline Hessian operator+(const Hessian& a, const Hessian& b) {
    Hessian sum{};
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] = a[i] + b[i];
    return sum;
}

inline Hessian identity(double factor) { return {factor, 0.0, 0.0, factor, 0.0, factor}; }

// Makes an implicit of a field, and counts the evaluated points.
class Analytic : public implicit::Implicit {
public:
    explicit Analytic(const geometry::Bounds& bounds) : bounds_(bounds) {}

    [[nodiscard]] virtual Field at(const glm::dvec3& p) const = 0;

    void evaluate(const implicit::PointBatch& points, const implicit::FieldBatch& fields) const override {
        evaluations += points.count;
        for (std::int64_t i = 0; i < points.count; ++i) {
            const Field field = at({points.x[i], points.y[i], points.z[i]});
            if (fields.value != nullptr) fields.value[i] = field.value;
            if (fields.wants_gradient())
                for (int k = 0; k < 3; ++k) fields.gradient[static_cast<std::size_t>(k)][i] = field.gradient[k];
            if (fields.wants_hessian())
                for (std::size_t k = 0; k < 6; ++k) fields.hessian[k][i] = field.hessian[k];
        }
    }
    [[nodiscard]] bool concurrent() const noexcept override { return true; }
    [[nodiscard]] const geometry::Bounds& bounds() const noexcept override { return bounds_; }

    mutable std::atomic<std::int64_t> evaluations{0};

private:
    geometry::Bounds bounds_;
};

inline geometry::Bounds cube(double half, const glm::dvec3& centre = glm::dvec3(0.0)) {
    return {centre - half, centre + half};
}

// |x - c| - R: an exact distance.
class Sphere : public Analytic {
public:
    explicit Sphere(double radius = 1.0, const glm::dvec3& centre = glm::dvec3(0.0))
        : Analytic(cube(radius, centre)), radius_(radius), centre_(centre) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        const double r = glm::length(p - centre_);
        if (r == 0.0) return {-radius_, glm::dvec3(0.0), {}};
        const glm::dvec3 n = (p - centre_) / r;
        return {r - radius_, n, identity(1.0 / r) + outer(n, n, -1.0 / r)};
    }

private:
    double radius_;
    glm::dvec3 centre_;
};

// |x|^2 - R^2, which is not a distance.
class SquareSphere : public Analytic {
public:
    explicit SquareSphere(double radius = 1.0, double box = 1.0) : Analytic(cube(box * radius)), radius_(radius) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        return {glm::dot(p, p) - radius_ * radius_, 2.0 * p, identity(2.0)};
    }

private:
    double radius_;
};

// The distance to a torus about the z axis with ring radius R and tube radius r.
class Torus : public Analytic {
public:
    explicit Torus(double ring = 1.0, double tube = 0.35, const glm::dvec3& centre = glm::dvec3(0.0))
        : Torus(ring, tube, centre,
                {centre - glm::dvec3(ring + tube, ring + tube, tube),
                 centre + glm::dvec3(ring + tube, ring + tube, tube)}) {}
    Torus(double ring, double tube, const glm::dvec3& centre, const geometry::Bounds& bounds)
        : Analytic(bounds), ring_(ring), tube_(tube), centre_(centre) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        const glm::dvec3 q = p - centre_;
        const double rho = std::hypot(q.x, q.y);
        const glm::dvec3 out = rho > 0.0 ? glm::dvec3(q.x / rho, q.y / rho, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
        const glm::dvec3 around(-out.y, out.x, 0.0);
        const double s = std::hypot(rho - ring_, q.z);
        if (s == 0.0 || rho == 0.0) return {s - tube_, glm::dvec3(0.0), {}};
        const glm::dvec3 n = ((rho - ring_) * out + glm::dvec3(0.0, 0.0, q.z)) / s;
        const glm::dvec3 along = glm::cross(n, around); // the meridian
        return {s - tube_, n, outer(along, along, 1.0 / s) + outer(around, around, (rho - ring_) / (s * rho))};
    }
    [[nodiscard]] double area() const { return 4.0 * 9.869604401089358 * ring_ * tube_; }

private:
    double ring_;
    double tube_;
    glm::dvec3 centre_;
};

// The plane a . x - b inside a box.
class Plane : public Analytic {
public:
    Plane(const glm::dvec3& normal, double offset, const geometry::Bounds& bounds)
        : Analytic(bounds), normal_(normal), offset_(offset) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        return {glm::dot(normal_, p) - offset_, normal_, Hessian{}};
    }

private:
    glm::dvec3 normal_;
    double offset_;
};

// The distance to a cylinder about the z axis.
class Cylinder : public Analytic {
public:
    explicit Cylinder(double radius, double half_height = 1.0)
        : Analytic({{-radius, -radius, -half_height}, {radius, radius, half_height}}), radius_(radius) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        const double r = std::hypot(p.x, p.y);
        const glm::dvec3 n(p.x / r, p.y / r, 0.0);
        const glm::dvec3 around(-n.y, n.x, 0.0);
        return {r - radius_, n, outer(around, around, 1.0 / r)};
    }

private:
    double radius_;
};

// The distance to the nearer of two linked tori.
class TwoTori : public Analytic {
public:
    TwoTori() : Analytic({{-1.3, -1.3, -1.3}, {2.3, 1.3, 1.3}}), flat_(1.0, 0.3), upright_(1.0, 0.3) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        const Field a = flat_.at(p);
        // The second torus has the axis y and the centre (1, 0, 0): turn (x, y, z) into (x - 1, z, y).
        Field b = upright_.at({p.x - 1.0, p.z, p.y});
        if (std::abs(a.value) <= std::abs(b.value)) return a;
        b.gradient = {b.gradient.x, b.gradient.z, b.gradient.y};
        const Hessian h = b.hessian;
        b.hessian = {h[0], h[2], h[1], h[5], h[4], h[3]};
        return b;
    }

private:
    Torus flat_;
    Torus upright_;
};

// Two faces, a thickness apart: (z^2 - t^2) / 2t, whose gradient is 1 on both faces.
class ThinSlab : public Analytic {
public:
    explicit ThinSlab(double half_thickness)
        : Analytic({{-1.0, -1.0, -half_thickness}, {1.0, 1.0, half_thickness}}), half_(half_thickness) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override {
        return {(p.z * p.z - half_ * half_) / (2.0 * half_), {0.0, 0.0, p.z / half_}, {0, 0, 0, 0, 0, 1.0 / half_}};
    }

private:
    double half_;
};

// Any function that a test needs.
class AnyField : public Analytic {
public:
    AnyField(const geometry::Bounds& bounds, std::function<Field(const glm::dvec3&)> field)
        : Analytic(bounds), field_(std::move(field)) {}

    [[nodiscard]] Field at(const glm::dvec3& p) const override { return field_(p); }

private:
    std::function<Field(const glm::dvec3&)> field_;
};

} // namespace hrbfnpr::test
