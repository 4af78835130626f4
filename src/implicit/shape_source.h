// SPDX-License-Identifier: MIT
// Second and third derivatives of an implicit function, for curves on which curvatures or their derivatives are 0. They
// are smoothed for this purpose. The surface and its normals are those of the original function.
#pragma once

#include "implicit/hrbf.h"

#include <array>

namespace hrbfnpr::implicit {

// Where results are written, in the orders xx xy xz yy yz zz and xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz. Both pointers
// must be set.
struct ThirdBatch {
    std::array<double*, 6> hessian{};
    std::array<double*, 10> third{};
};

class ShapeSource {
public:
    ShapeSource() = default;
    ShapeSource(const ShapeSource&) = delete;
    ShapeSource& operator=(const ShapeSource&) = delete;
    virtual ~ShapeSource() = default;

    // Evaluates at most batch_size points on the calling thread. The result for a point does not depend on the other
    // points of the batch.
    virtual void evaluate(const PointBatch& points, const ThirdBatch& out) const = 0;
    // Returns whether evaluate() may run on several threads at once.
    [[nodiscard]] virtual bool concurrent() const noexcept = 0;
};

// The smoothing eps, in mean spacings of the samples. A wave with wave number k is multiplied by x^3 K_3(x) / 8 with x
// = k eps. This is the ratio of the Fourier transforms of (r^2 + eps^2)^(3/2) and r^3, and is 1 - x^2 / 8 for small x.
// A wave of 6 spacings loses 1 %, and a wave of 2 spacings loses 10 %. More smoothing removes larger features: a value
// of 1 halves waves of 2.4 spacings.
inline constexpr double ordinary_smoothing = 0.3;

// The source for an HRBF. It has the same weights, with r^2 + eps^2 in place of r^2, where eps is `smoothing` spacings.
// The triharmonic and the Wendland C2 kernel need smoothing: both contain r^3, so at a sample, which lies on the
// surface, their third derivatives grow like 1/r. A Gaussian needs no smoothing and gets none. Third derivatives jump
// at the radius where a Wendland kernel ends.
class HrbfShape final : public ShapeSource {
public:
    // The object keeps a reference to `data`.
    HrbfShape(base::InstructionSet set, const HrbfData& data, double smoothing = ordinary_smoothing) noexcept;

    void evaluate(const PointBatch& points, const ThirdBatch& out) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return true; }

private:
    base::InstructionSet set_;
    const HrbfData& data_;
    double smoothing_; // eps^2, in normalised coordinates
};

// The source for any other implicit function: it uses the function's Hessian, and central differences of the Hessian.
class DifferencedShape final : public ShapeSource {
public:
    // `step` is in diagonals. The object keeps a reference to `implicit`.
    explicit DifferencedShape(const Implicit& implicit, double step = 1e-3) noexcept
        : implicit_(implicit), step_(step * implicit.diagonal()) {}

    void evaluate(const PointBatch& points, const ThirdBatch& out) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return implicit_.concurrent(); }

private:
    void evaluate_block(const Implicit& implicit, const PointBatch& points, const ThirdBatch& out) const;
    void evaluate_by_sheet(const Sheets& sheets, const PointBatch& points, const ThirdBatch& out) const;

    const Implicit& implicit_;
    double step_;
};

// The source for an implicit function in another unit of length: g(y) = f(unit y) / unit, as in implicit/scaled.h.
class ScaledShape final : public ShapeSource {
public:
    // The object keeps a reference to `unscaled`.
    ScaledShape(const ShapeSource& unscaled, double unit) noexcept : unscaled_(unscaled), unit_(unit) {}

    void evaluate(const PointBatch& points, const ThirdBatch& out) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return unscaled_.concurrent(); }

private:
    const ShapeSource& unscaled_;
    double unit_;
};

} // namespace hrbfnpr::implicit
