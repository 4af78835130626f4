// SPDX-License-Identifier: MIT
// Vectors of doubles for WebAssembly, because Highway before version 1.1 has only floats there. Names, arguments and
// results are as in Highway for other processors.
#pragma once

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace hwy::HWY_NAMESPACE {

template <std::size_t N>
HWY_API Vec128<double, N> Set(Simd<double, N, 0> /*tag*/, double x) {
    return {wasm_f64x2_splat(x)};
}

template <std::size_t N>
HWY_API double GetLane(Vec128<double, N> a) {
    return wasm_f64x2_extract_lane(a.raw, 0);
}

template <std::size_t N>
HWY_API Vec128<double, N> operator+(Vec128<double, N> a, Vec128<double, N> b) {
    return {wasm_f64x2_add(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Vec128<double, N> operator-(Vec128<double, N> a, Vec128<double, N> b) {
    return {wasm_f64x2_sub(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Vec128<double, N> operator*(Vec128<double, N> a, Vec128<double, N> b) {
    return {wasm_f64x2_mul(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Vec128<double, N> operator/(Vec128<double, N> a, Vec128<double, N> b) {
    return {wasm_f64x2_div(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Vec128<double, N> MulAdd(Vec128<double, N> a, Vec128<double, N> b, Vec128<double, N> c) {
    return a * b + c;
}
template <std::size_t N>
HWY_API Vec128<double, N> NegMulAdd(Vec128<double, N> a, Vec128<double, N> b, Vec128<double, N> c) {
    return c - a * b;
}
template <std::size_t N>
HWY_API Vec128<double, N> MulSub(Vec128<double, N> a, Vec128<double, N> b, Vec128<double, N> c) {
    return a * b - c;
}

template <std::size_t N>
HWY_API Vec128<double, N> Sqrt(Vec128<double, N> a) {
    return {wasm_f64x2_sqrt(a.raw)};
}
template <std::size_t N>
HWY_API Vec128<double, N> Min(Vec128<double, N> a, Vec128<double, N> b) {
    return {wasm_f64x2_pmin(b.raw, a.raw)};
}
template <std::size_t N>
HWY_API Vec128<double, N> Max(Vec128<double, N> a, Vec128<double, N> b) {
    return {wasm_f64x2_pmax(b.raw, a.raw)};
}
template <std::size_t N>
HWY_API Mask128<double, N> operator==(Vec128<double, N> a, Vec128<double, N> b) {
    return {wasm_f64x2_eq(a.raw, b.raw)};
}
template <std::size_t N>
HWY_API Mask128<double, N> operator>(Vec128<double, N> a, Vec128<double, N> b) {
    return {wasm_f64x2_gt(a.raw, b.raw)};
}

template <std::size_t N>
HWY_API Vec128<double, N> PromoteTo(Simd<double, N, 0> /*tag*/, Vec128<float, N> a) {
    return {wasm_f64x2_promote_low_f32x4(a.raw)};
}

template <std::size_t N>
HWY_API Vec128<double, N> Exp(Simd<double, N, 0> /*tag*/, Vec128<double, N> a) {
    return {wasm_f64x2_make(__builtin_exp(wasm_f64x2_extract_lane(a.raw, 0)),
                            __builtin_exp(wasm_f64x2_extract_lane(a.raw, 1)))};
}

} // namespace hwy::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
