// SPDX-License-Identifier: MIT
// Even samples of a surface, each with a tangent frame, and links to its neighbours on the same sheet.
#pragma once

#include "base/operation.h"
#include "base/runtime.h"
#include "geometry/vec_array.h"

#include <cmath>
#include <complex>
#include <cstdint>
#include <span>

namespace hrbfnpr::hatching {

using Complex = std::complex<double>;

// What finite factors make.  The operator of std::complex looks for NaN after each product, which costs more than the
// product itself.
[[nodiscard]] inline Complex product(const Complex& a, const Complex& b) noexcept {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
// Of a number whose square neither overflows nor matters where it is nothing: std::abs takes care of both.
[[nodiscard]] inline double quick_size(const Complex& z) noexcept {
    return std::sqrt(z.real() * z.real() + z.imag() * z.imag());
}

struct SampleGraph {
    // Samples a `spacing` apart: the root of the area for each.  sheets: of surface/creased.h, or empty.
    SampleGraph(const base::Runtime& runtime, geometry::VecArray positions, geometry::VecArray normals,
                base::Array<std::int32_t> sheets, double spacing, const base::Progress& progress);

    struct Link {
        std::int32_t to;
        float turn;   // what an angle in a sample's frame grows by when it is carried to that of `to`, the shortest way
        Complex back; // exp(-2 i turn): a line of `to`, doubled, as seen from here
    };

    [[nodiscard]] std::int64_t size() const noexcept { return position.size(); }
    [[nodiscard]] std::span<const Link> links(std::int64_t i) const noexcept {
        return link.span().subspan(static_cast<std::size_t>(first[i]),
                                   static_cast<std::size_t>(first[i + 1] - first[i]));
    }
    // A unit tangent at this angle in the frame of sample i.
    [[nodiscard]] glm::dvec3 tangent(std::int64_t i, double angle) const noexcept;
    // The angle of a tangent there.
    [[nodiscard]] double angle(std::int64_t i, const glm::dvec3& tangent) const noexcept;

    geometry::VecArray position, normal;
    base::Array<std::int32_t> sheet; // of each sample; links lead over no crease.  Empty: there are none
    geometry::VecArray u;            // the frame's first axis; the second is normal x u
    double spacing;
    base::Array<std::int64_t> first; // of each sample's links, and the end
    base::Array<Link> link;          // both ways

private:
    [[nodiscard]] bool is_linked(std::int64_t i, std::int64_t j) const noexcept;
    [[nodiscard]] double turn(std::int64_t i, std::int64_t j) const noexcept;
};

} // namespace hrbfnpr::hatching
