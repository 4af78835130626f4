// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "implicit/cube_loops.cpp"
#include "base/simd.h"

#include "base/simd_math-inl.h"
#include "implicit/cube_loops.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::implicit::HWY_NAMESPACE::cube_loops {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using base::HWY_NAMESPACE::D;
using base::HWY_NAMESPACE::root;
using base::HWY_NAMESPACE::V;

constexpr int highest_degree = 20;

// The number of vectors whose sums are kept in registers at a time.
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_NEON
constexpr int most_vectors = 16;
#else
constexpr int most_vectors = 8;
#endif

HWY_INLINE int lanes() { return static_cast<int>(hn::Lanes(D())); }

void cubes(const double* const* nodes, int row, int columns, const double* shift, double scale, double* panel) {
    const D d;
    for (int at = 0; at < cube_rows; at += lanes()) {
        V target[3];
        for (int c = 0; c < 3; ++c) target[c] = hn::Add(hn::LoadU(d, nodes[c] + row + at), hn::Set(d, shift[c]));
        for (int k = 0; k < columns; ++k) {
            const V x = hn::Sub(target[0], hn::Set(d, nodes[0][k]));
            const V y = hn::Sub(target[1], hn::Set(d, nodes[1][k]));
            const V z = hn::Sub(target[2], hn::Set(d, nodes[2][k]));
            const V r2 = hn::MulAdd(z, z, hn::MulAdd(y, y, hn::Mul(x, x)));
            const V cube = hn::Mul(hn::Mul(r2, hn::Set(d, scale)), root(r2));
            hn::StoreU(cube, d, panel + k * cube_rows + at);
        }
    }
}

template <int n>
HWY_INLINE void multiply_some(const double* matrix, std::int64_t stride, int rows, int columns, const double* in,
                              double* const* out) {
    const D d;
    for (int row = 0; row < rows; row += lanes()) {
        V sum[static_cast<size_t>(n)];
        for (int v = 0; v < n; ++v) sum[v] = hn::LoadU(d, out[v] + row);
        for (int k = 0; k < columns; ++k) {
            const V element = hn::LoadU(d, matrix + k * stride + row);
            for (int v = 0; v < n; ++v) sum[v] = hn::MulAdd(element, hn::Set(d, in[k * cube_batch + v]), sum[v]);
        }
        for (int v = 0; v < n; ++v) hn::StoreU(sum[v], d, out[v] + row);
    }
}

void multiply(const double* matrix, std::int64_t stride, int rows, int columns, const double* in, double* const* out,
              int vectors) {
    for (; vectors > most_vectors; vectors -= most_vectors, in += most_vectors, out += most_vectors)
        multiply_some<most_vectors>(matrix, stride, rows, columns, in, out);
    if (vectors > 8)
        multiply_some<most_vectors>(matrix, stride, rows, columns, in, out);
    else if (vectors > 4)
        multiply_some<8>(matrix, stride, rows, columns, in, out);
    else if (vectors > 2)
        multiply_some<4>(matrix, stride, rows, columns, in, out);
    else if (vectors > 1)
        multiply_some<2>(matrix, stride, rows, columns, in, out);
    else
        multiply_some<1>(matrix, stride, rows, columns, in, out);
}

// T_0 ... T_degree and their derivatives, one sample in each lane.
struct Chebyshev {
    V t[highest_degree + 1];
    V dt[highest_degree + 1];

    // Sets the polynomials and derivatives. `x` is in the cube's coordinates. Derivatives are with respect to the
    // caller's coordinates; `slope` is the factor from caller's units to cube units.
    HWY_INLINE void set(int degree, V x, V slope) {
        const D d;
        const V x2 = hn::Add(x, x);
        t[0] = hn::Set(d, 1.0);
        dt[0] = hn::Zero(d);
        t[1] = x;
        dt[1] = slope;
        const V slope2 = hn::Add(slope, slope);
        for (int k = 2; k <= degree; ++k) {
            t[k] = hn::MulSub(x2, t[k - 1], t[k - 2]);
            dt[k] = hn::MulAdd(slope2, t[k - 1], hn::MulSub(x2, dt[k - 1], dt[k - 2]));
        }
    }
};

struct Sample {
    Chebyshev x, y, z;

    HWY_INLINE void load(int degree, const CubeSamples& samples, std::int64_t at, hn::Mask<D> mask) {
        const D d;
        const V slope = hn::Set(d, 1.0 / samples.half_width);
        const auto place = [&](const double* coordinate, int c) HWY_ATTR {
            return hn::Mul(hn::Sub(hn::MaskedLoad(mask, d, coordinate + at), hn::Set(d, samples.centre[c])), slope);
        };
        x.set(degree, place(samples.x, 0), slope);
        y.set(degree, place(samples.y, 1), slope);
        z.set(degree, place(samples.z, 2), slope);
    }
};

HWY_INLINE hn::Mask<D> lanes_left(std::int64_t left) {
    return hn::FirstN(D(), static_cast<size_t>(left < lanes() ? left : lanes()));
}

// Each lane adds the contributions of its samples to `sums`, which has one SIMD vector for each term.
HWY_INLINE void add_moments(int degree, const Sample& s, V alpha, const V* beta, double* sums) {
    const D d;
    for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b) {
            const V both = hn::Mul(s.x.t[a], s.y.t[b]);
            V flat = hn::Mul(alpha, both);
            flat = hn::MulAdd(beta[0], hn::Mul(s.x.dt[a], s.y.t[b]), flat);
            flat = hn::MulAdd(beta[1], hn::Mul(s.x.t[a], s.y.dt[b]), flat);
            const V steep = hn::Mul(beta[2], both);
            for (int c = 0; a + b + c <= degree; ++c, sums += lanes()) {
                const V sum = hn::MulAdd(steep, s.z.dt[c], hn::Load(d, sums));
                hn::Store(hn::MulAdd(flat, s.z.t[c], sum), d, sums);
            }
        }
}

void moments(int degree, const CubeSamples& samples, const double* alpha, const double* const* beta, double* sums,
             double* terms) {
    static_assert(HWY_LANES(double) <= cube_lanes);
    const D d;
    const int count = (degree + 1) * (degree + 2) * (degree + 3) / 6;
    for (int k = 0; k < count * lanes(); ++k) sums[k] = 0.0;
    Sample sample;
    for (std::int64_t at = 0; at < samples.count; at += lanes()) {
        const auto mask = lanes_left(samples.count - at);
        sample.load(degree, samples, at, mask);
        const V weight[3] = {hn::MaskedLoad(mask, d, beta[0] + at), hn::MaskedLoad(mask, d, beta[1] + at),
                             hn::MaskedLoad(mask, d, beta[2] + at)};
        add_moments(degree, sample, hn::MaskedLoad(mask, d, alpha + at), weight, sums);
    }
    for (int k = 0; k < count; ++k) {
        double sum = 0.0;
        for (int lane = 0; lane < lanes(); ++lane) sum += sums[k * lanes() + lane];
        terms[k] = sum;
    }
}

// A polynomial and its gradient at n vectors of samples.
template <size_t n>
struct Field {
    V value[n], x[n], y[n], z[n];
};

// Sums over c first, then over b, then over a. Several vectors of samples share the terms, and their sums do not wait
// for each other.
template <size_t n>
HWY_INLINE void add_field(int degree, const double* terms, const Sample* s, Field<n>& field) {
    const D d;
    for (int a = 0; a <= degree; ++a) {
        V flat[n], along_y[n], along_z[n];
        for (size_t v = 0; v < n; ++v) flat[v] = along_y[v] = along_z[v] = hn::Zero(d);
        for (int b = 0; a + b <= degree; ++b) {
            V row[n], steep[n];
            for (size_t v = 0; v < n; ++v) row[v] = steep[v] = hn::Zero(d);
            for (int c = 0; a + b + c <= degree; ++c, ++terms) {
                const V term = hn::Set(d, *terms);
                for (size_t v = 0; v < n; ++v) {
                    row[v] = hn::MulAdd(term, s[v].z.t[c], row[v]);
                    steep[v] = hn::MulAdd(term, s[v].z.dt[c], steep[v]);
                }
            }
            for (size_t v = 0; v < n; ++v) {
                flat[v] = hn::MulAdd(s[v].y.t[b], row[v], flat[v]);
                along_y[v] = hn::MulAdd(s[v].y.dt[b], row[v], along_y[v]);
                along_z[v] = hn::MulAdd(s[v].y.t[b], steep[v], along_z[v]);
            }
        }
        for (size_t v = 0; v < n; ++v) {
            field.value[v] = hn::MulAdd(s[v].x.t[a], flat[v], field.value[v]);
            field.x[v] = hn::MulAdd(s[v].x.dt[a], flat[v], field.x[v]);
            field.y[v] = hn::MulAdd(s[v].x.t[a], along_y[v], field.y[v]);
            field.z[v] = hn::MulAdd(s[v].x.t[a], along_z[v], field.z[v]);
        }
    }
}

template <size_t n>
HWY_INLINE void evaluate_some(int degree, const double* terms, const CubeSamples& samples, std::int64_t at,
                              double* value, double* const* gradient) {
    const D d;
    Sample sample[n];
    Field<n> field;
    for (size_t v = 0; v < n; ++v, at += lanes()) {
        const auto mask = lanes_left(samples.count - at);
        sample[v].load(degree, samples, at, mask);
        field.value[v] = hn::MaskedLoad(mask, d, value + at);
        field.x[v] = hn::MaskedLoad(mask, d, gradient[0] + at);
        field.y[v] = hn::MaskedLoad(mask, d, gradient[1] + at);
        field.z[v] = hn::MaskedLoad(mask, d, gradient[2] + at);
    }
    add_field<n>(degree, terms, sample, field);
    for (size_t v = n; v-- > 0;) {
        at -= lanes();
        const auto mask = lanes_left(samples.count - at);
        hn::BlendedStore(field.value[v], mask, d, value + at);
        hn::BlendedStore(field.x[v], mask, d, gradient[0] + at);
        hn::BlendedStore(field.y[v], mask, d, gradient[1] + at);
        hn::BlendedStore(field.z[v], mask, d, gradient[2] + at);
    }
}

void evaluate(int degree, const double* terms, const CubeSamples& samples, double* value, double* const* gradient) {
    std::int64_t at = 0;
    for (; at + lanes() < samples.count; at += 2 * lanes())
        evaluate_some<2>(degree, terms, samples, at, value, gradient);
    if (at < samples.count) evaluate_some<1>(degree, terms, samples, at, value, gradient);
}

// The second derivatives of the T_k in a Chebyshev.
struct SecondDerivatives {
    V d2t[highest_degree + 1];

    HWY_INLINE void set(int degree, V x, V slope, const Chebyshev& c) {
        const D d;
        const V x2 = hn::Add(x, x);
        const V slope4 = hn::Mul(slope, hn::Set(d, 4.0));
        d2t[0] = hn::Zero(d);
        d2t[1] = hn::Zero(d);
        for (int k = 2; k <= degree; ++k)
            d2t[k] = hn::MulAdd(slope4, c.dt[k - 1], hn::MulSub(x2, d2t[k - 1], d2t[k - 2]));
    }
};

HWY_INLINE void add_hessian(int degree, const double* terms, const Sample& s, const SecondDerivatives* second,
                            V* field) {
    const D d;
    for (int a = 0; a <= degree; ++a)
        for (int b = 0; a + b <= degree; ++b) {
            V flat = hn::Zero(d);
            V steep = hn::Zero(d);
            V bent = hn::Zero(d);
            for (int c = 0; a + b + c <= degree; ++c, ++terms) {
                const V term = hn::Set(d, *terms);
                flat = hn::MulAdd(term, s.z.t[c], flat);
                steep = hn::MulAdd(term, s.z.dt[c], steep);
                bent = hn::MulAdd(term, second[2].d2t[c], bent);
            }
            field[0] = hn::MulAdd(hn::Mul(second[0].d2t[a], s.y.t[b]), flat, field[0]);
            field[1] = hn::MulAdd(hn::Mul(s.x.dt[a], s.y.dt[b]), flat, field[1]);
            field[2] = hn::MulAdd(hn::Mul(s.x.dt[a], s.y.t[b]), steep, field[2]);
            field[3] = hn::MulAdd(hn::Mul(s.x.t[a], second[1].d2t[b]), flat, field[3]);
            field[4] = hn::MulAdd(hn::Mul(s.x.t[a], s.y.dt[b]), steep, field[4]);
            field[5] = hn::MulAdd(hn::Mul(s.x.t[a], s.y.t[b]), bent, field[5]);
        }
}

void hessian(int degree, const double* terms, const CubeSamples& samples, double* const* result) {
    const D d;
    Sample sample;
    SecondDerivatives second[3];
    const V slope = hn::Set(d, 1.0 / samples.half_width);
    for (std::int64_t at = 0; at < samples.count; at += lanes()) {
        const auto mask = lanes_left(samples.count - at);
        sample.load(degree, samples, at, mask);
        second[0].set(degree, sample.x.t[1], slope, sample.x); // T_1(x) = x
        second[1].set(degree, sample.y.t[1], slope, sample.y);
        second[2].set(degree, sample.z.t[1], slope, sample.z);
        V field[6];
        for (int k = 0; k < 6; ++k) field[k] = hn::MaskedLoad(mask, d, result[k] + at);
        add_hessian(degree, terms, sample, second, field);
        for (int k = 0; k < 6; ++k) hn::BlendedStore(field[k], mask, d, result[k] + at);
    }
}

} // namespace

CubeLoops pick() noexcept { return {cubes, multiply, moments, evaluate, hessian}; }

} // namespace hrbfnpr::implicit::HWY_NAMESPACE::cube_loops
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::implicit, CubeLoops, cube_loops, cube_loops::pick)
