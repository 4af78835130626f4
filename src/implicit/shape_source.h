// SPDX-License-Identifier: MIT
// Second and third derivatives of an implicit. They are smooth enough for curves on which curvatures or their
// derivatives vanish. The surface and its normals are still those of the implicit itself.
#pragma once

#include "implicit/hrbf.h"

#include <array>

namespace hrbfnpr::implicit {

// Orders: xx xy xz yy yz zz and xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz. Both are always wanted.
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

    // Runs on the calling thread, for at most batch_size points. The result for a point does not depend on its batch.
    virtual void evaluate(const PointBatch& points, const ThirdBatch& out) const = 0;
    // Whether evaluate() may run on several threads at once.
    [[nodiscard]] virtual bool concurrent() const noexcept = 0;
};

// The smoothing eps, in mean spacings of the samples. A wave of the wave number k is multiplied by x^3 K_3(x) / 8 at x
// = k eps, the ratio of the Fourier transforms of (r^2 + eps^2)^(3/2) and r^3, which is 1 - x^2 / 8 for small x: a wave
// as long as 6 spacings loses 1 %, one as long as 2 loses 10 %. More smoothing leaves out smaller features: 1 spacing
// halves waves that are 2.4 spacings long.
inline constexpr double ordinary_smoothing = 0.3;

// The source for an HRBF: it has the same weights, with r^2 + eps^2 in place of r^2, eps = `smoothing` spacings. The
// triharmonic and Wendland C2 kernels are smoothed because both contain r^3, so that at a sample, which lies on the
// surface, their third derivatives grow like 1/r. A Gaussian needs no smoothing and gets none. At the end of a
// Wendland's reach third derivatives jump.
class HrbfShape final : public ShapeSource {
public:
    // `data` must outlive this.
    HrbfShape(base::InstructionSet set, const HrbfData& data, double smoothing = ordinary_smoothing) noexcept;

    void evaluate(const PointBatch& points, const ThirdBatch& out) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return true; }

private:
    base::InstructionSet set_;
    const HrbfData& data_;
    double smoothing_; // eps^2, in normalised coordinates
};

// The source for any other implicit: its Hessian, and central differences of the Hessian.
class DifferencedShape final : public ShapeSource {
public:
    // `step` is in diagonals. `implicit` must outlive this.
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

// The source for an implicit in another unit of length, as in implicit/scaled.h: g(y) = f(unit y) / unit.
class ScaledShape final : public ShapeSource {
public:
    // `unscaled` must outlive this.
    ScaledShape(const ShapeSource& unscaled, double unit) noexcept : unscaled_(unscaled), unit_(unit) {}

    void evaluate(const PointBatch& points, const ThirdBatch& out) const override;
    [[nodiscard]] bool concurrent() const noexcept override { return unscaled_.concurrent(); }

private:
    const ShapeSource& unscaled_;
    double unit_;
};

} // namespace hrbfnpr::implicit
