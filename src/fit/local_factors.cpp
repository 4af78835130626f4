// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fit/local_factors.cpp"
#include "base/simd.h"

#include "fit/local_factors.h"

#include <hwy/contrib/math/math-inl.h>

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::fit::HWY_NAMESPACE::local_factors {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Each lane solves one system. No step needs another lane, so all instruction sets do the same arithmetic.
using D = hn::ScalableTag<double>;
using V = hn::Vec<D>;

// The number of rows of a 4 x 4 block that are updated together. The registers of the processor limit it.
#if HWY_TARGET == HWY_AVX3 || HWY_TARGET == HWY_NEON
constexpr int rows_at_once = 4;
#else
constexpr int rows_at_once = 2;
#endif

// A pivot is at least this share of its diagonal element. This keeps the factor finite and definite where samples are
// nearly dependent.
constexpr double smallest_pivot = 1e-13;

HWY_INLINE V set(double x) { return hn::Set(D(), x); }

struct Block {
    V v[4][4];
};

struct Radial {
    V phi, a, b;
};

HWY_INLINE Radial radial(const LocalSystems& systems, V r2) {
    const D d;
    const V inverse = hn::IfThenElseZero(hn::Gt(r2, set(1e-60)), hn::Div(set(1.0), hn::Sqrt(r2)));
    const V r = hn::Mul(r2, inverse);
    if (systems.kernel == kernel::Kind::triharmonic)
        return {hn::Mul(r2, r), hn::Mul(set(3.0), r), hn::Mul(set(3.0), inverse)};
    if (systems.kernel == kernel::Kind::gaussian) {
        const V f = set(1.0 / (systems.radius * systems.radius));
        const V phi = hn::Exp(d, hn::Max(hn::Mul(hn::Mul(f, set(-0.5)), r2), set(-700.0)));
        const V a = hn::Neg(hn::Mul(f, phi));
        return {phi, a, hn::Neg(hn::Mul(f, a))};
    }
    const double inverse_radius = 1.0 / systems.radius;
    const double falloff = 20.0 * inverse_radius * inverse_radius;
    const V s = hn::Mul(r, set(inverse_radius));
    const V t = hn::Max(hn::Zero(d), hn::Sub(set(1.0), s));
    const V t2 = hn::Mul(t, t);
    return {hn::Mul(hn::Mul(t2, t2), hn::MulAdd(s, set(4.0), set(1.0))), hn::Mul(set(-falloff), hn::Mul(t2, t)),
            hn::Mul(set(3.0 * falloff * inverse_radius), hn::Mul(t2, inverse))};
}

// [[phi, -a d^T], [a d, -(a I + b d d^T)]]
HWY_INLINE void pair_block(const LocalSystems& systems, const V* p, const V* q, Block& block) {
    const V d[3] = {hn::Sub(p[0], q[0]), hn::Sub(p[1], q[1]), hn::Sub(p[2], q[2])};
    const V r2 = hn::MulAdd(d[2], d[2], hn::MulAdd(d[1], d[1], hn::Mul(d[0], d[0])));
    const Radial k = radial(systems, r2);
    block.v[0][0] = k.phi;
    for (int c = 0; c < 3; ++c) {
        const V ad = hn::Mul(k.a, d[c]);
        const V bd = hn::Mul(k.b, d[c]);
        block.v[1 + c][0] = ad;
        block.v[0][1 + c] = hn::Neg(ad);
        for (int r = 0; r < 3; ++r) block.v[1 + r][1 + c] = hn::Neg(hn::Mul(bd, d[r]));
        block.v[1 + c][1 + c] = hn::Sub(block.v[1 + c][1 + c], k.a);
    }
}

// A sample of the set relative to the reference sample, and the kernel between the two samples.
struct Place {
    V x[3];
    Radial to_reference;
};

// Computes block -= M, or M^T, with M = A_p0 T_q^T and T_q = [[1, q^T], [0, I]]. This subtracts the Taylor expansion of
// q's functionals about the reference, which is at 0.
HWY_INLINE void take_expansion(const Place& p, const Place& q, bool transposed, Block& block) {
    const auto take = [&](int r, int c, V m) HWY_ATTR {
        V& at = transposed ? block.v[c][r] : block.v[r][c];
        at = hn::Sub(at, m);
    };
    const Radial& k = p.to_reference;
    const V s = hn::MulAdd(p.x[2], q.x[2], hn::MulAdd(p.x[1], q.x[1], hn::Mul(p.x[0], q.x[0])));
    const V along = hn::NegMulAdd(k.b, s, k.a); // the coefficient of p in the first column of M
    take(0, 0, hn::NegMulAdd(k.a, s, k.phi));
    for (int r = 0; r < 3; ++r) {
        const V ap = hn::Mul(k.a, p.x[r]);
        const V bp = hn::Mul(k.b, p.x[r]);
        take(0, 1 + r, hn::Neg(ap));
        take(1 + r, 0, hn::NegMulAdd(k.a, q.x[r], hn::Mul(along, p.x[r])));
        for (int c = 0; c < 3; ++c) {
            const V m = hn::NegMulAdd(bp, p.x[c], r == c ? hn::Neg(k.a) : hn::Zero(D()));
            take(1 + r, 1 + c, m);
        }
    }
}

// Computes block += T_p R T_q^T, with R = diag(value, gradient, gradient, gradient).
HWY_INLINE void add_reference_diagonal(const LocalSystems& systems, const V* p, const V* q, Block& block) {
    const V value = set(systems.value_diagonal);
    const V gradient = set(systems.gradient_diagonal);
    V dot = hn::Zero(D());
    for (int c = 0; c < 3; ++c) {
        dot = hn::MulAdd(p[c], q[c], dot);
        block.v[0][1 + c] = hn::MulAdd(gradient, p[c], block.v[0][1 + c]);
        block.v[1 + c][0] = hn::MulAdd(gradient, q[c], block.v[1 + c][0]);
        block.v[1 + c][1 + c] = hn::Add(block.v[1 + c][1 + c], gradient);
    }
    block.v[0][0] = hn::Add(block.v[0][0], hn::MulAdd(gradient, dot, value));
}

// Computes a block of Theta, or of its part orthogonal to the linear polynomials. Positions are relative to the
// reference.
HWY_INLINE void theta_block(const LocalSystems& systems, const Place& p, const Place& q, bool diagonal, Block& block) {
    pair_block(systems, p.x, q.x, block);
    if (systems.orthogonal_to_linear) {
        take_expansion(p, q, false, block);
        take_expansion(q, p, true, block);
        if (systems.value_diagonal > 0.0 || systems.gradient_diagonal > 0.0)
            add_reference_diagonal(systems, p.x, q.x, block);
    }
    if (!diagonal) return;
    block.v[0][0] = hn::Add(block.v[0][0], set(systems.value_diagonal));
    for (int c = 1; c < 4; ++c) block.v[c][c] = hn::Add(block.v[c][c], set(systems.gradient_diagonal));
}

// Strides in memory: from one element of a block to the next, and from block to block.
HWY_INLINE std::int64_t element_stride() { return static_cast<std::int64_t>(hn::Lanes(D())); }
HWY_INLINE std::int64_t block_stride() { return 16 * element_stride(); }

// The lower block triangle, row by row.
struct Triangle {
    double* data;
    HWY_INLINE double* block(int i, int j) const { return data + (i * (i + 1) / 2 + j) * block_stride(); }
};

HWY_INLINE V load(const double* block, int r, int c) { return hn::Load(D(), block + (4 * r + c) * element_stride()); }
HWY_INLINE void store(V v, double* block, int r, int c) { hn::Store(v, D(), block + (4 * r + c) * element_stride()); }

// Computes s -= sum_k<j L_ik L_jk^T.
HWY_INLINE void update(const Triangle& l, int i, int j, Block& s) {
    for (int r0 = 0; r0 < 4; r0 += rows_at_once) {
        V sum[rows_at_once][4];
        for (int r = 0; r < rows_at_once; ++r)
            for (int c = 0; c < 4; ++c) sum[r][c] = s.v[r0 + r][c];
        for (int k = 0; k < j; ++k) {
            const double* a = l.block(i, k);
            const double* b = l.block(j, k);
            for (int m = 0; m < 4; ++m) {
                const V column[4] = {load(b, 0, m), load(b, 1, m), load(b, 2, m), load(b, 3, m)};
                for (int r = 0; r < rows_at_once; ++r) {
                    const V x = load(a, r0 + r, m);
                    for (int c = 0; c < 4; ++c) sum[r][c] = hn::NegMulAdd(x, column[c], sum[r][c]);
                }
            }
        }
        for (int r = 0; r < rows_at_once; ++r)
            for (int c = 0; c < 4; ++c) s.v[r0 + r][c] = sum[r][c];
    }
}

// The diagonal of a diagonal block holds the inverses of the pivots.

// Computes s = s L_jj^-T.
HWY_INLINE void solve_right(const double* diagonal, Block& s) {
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
            V x = s.v[r][c];
            for (int m = 0; m < c; ++m) x = hn::NegMulAdd(s.v[r][m], load(diagonal, c, m), x);
            s.v[r][c] = hn::Mul(x, load(diagonal, c, c));
        }
}

HWY_INLINE void factor_diagonal(const V* full, Block& s) {
    for (int c = 0; c < 4; ++c) {
        V pivot = s.v[c][c];
        for (int m = 0; m < c; ++m) pivot = hn::NegMulAdd(s.v[c][m], s.v[c][m], pivot);
        const V floor = hn::Max(hn::Mul(full[c], set(smallest_pivot)), set(1e-200));
        const V inverse = hn::Div(set(1.0), hn::Sqrt(hn::Max(pivot, floor)));
        for (int r = c + 1; r < 4; ++r) {
            V x = s.v[r][c];
            for (int m = 0; m < c; ++m) x = hn::NegMulAdd(s.v[r][m], s.v[c][m], x);
            s.v[r][c] = hn::Mul(x, inverse);
        }
        s.v[c][c] = inverse;
    }
}

// Computes x = L_jj^-T x.
HWY_INLINE void solve_transposed(const double* diagonal, Block& x) {
    for (int c = 0; c < 4; ++c)
        for (int r = 3; r >= 0; --r) {
            V y = x.v[r][c];
            for (int m = r + 1; m < 4; ++m) y = hn::NegMulAdd(load(diagonal, m, r), x.v[m][c], y);
            x.v[r][c] = hn::Mul(y, load(diagonal, r, r));
        }
}

HWY_INLINE void put(const Block& block, double* at) {
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) store(block.v[r][c], at, r, c);
}

HWY_INLINE void factor_triangle(const LocalSystems& systems, const Place* p, int blocks, const Triangle& l) {
    for (int i = 0; i < blocks; ++i)
        for (int j = 0; j <= i; ++j) {
            Block s;
            theta_block(systems, p[i], p[j], i == j, s);
            const V full[4] = {s.v[0][0], s.v[1][1], s.v[2][2], s.v[3][3]};
            update(l, i, j, s);
            if (i == j)
                factor_diagonal(full, s);
            else
                solve_right(l.block(j, j), s);
            put(s, l.block(i, j));
        }
}

// Computes the last block column X of C^-T, from its last block upwards: X_j = -C_jj^-T sum_k>j C_kj^T X_k.
HWY_INLINE void last_columns(const Triangle& l, int blocks, double* columns) {
    for (int j = blocks - 1; j >= 0; --j) {
        Block x;
        for (int r = 0; r < 4; ++r)
            for (int c = 0; c < 4; ++c) x.v[r][c] = set(j == blocks - 1 && r == c ? 1.0 : 0.0);
        for (int k = j + 1; k < blocks; ++k) {
            const double* a = l.block(k, j);
            const double* b = columns + k * block_stride();
            for (int m = 0; m < 4; ++m)
                for (int r = 0; r < 4; ++r) {
                    const V y = load(a, m, r);
                    for (int c = 0; c < 4; ++c) x.v[r][c] = hn::NegMulAdd(y, load(b, m, c), x.v[r][c]);
                }
        }
        solve_transposed(l.block(j, j), x);
        put(x, columns + j * block_stride());
    }
}

// Computes the contribution of the expansions at the reference: -sum_j T_j^T X_j.
HWY_INLINE void reference_columns(const Place* p, int blocks, const double* columns, double* reference) {
    Block sum;
    for (int r = 0; r < 4; ++r)
        for (int c = 0; c < 4; ++c) sum.v[r][c] = hn::Zero(D());
    for (int j = 0; j < blocks; ++j)
        for (int c = 0; c < 4; ++c) {
            const V value = load(columns + j * block_stride(), 0, c);
            sum.v[0][c] = hn::Sub(sum.v[0][c], value);
            for (int r = 0; r < 3; ++r) {
                const V gradient = load(columns + j * block_stride(), 1 + r, c);
                sum.v[1 + r][c] = hn::Sub(sum.v[1 + r][c], hn::MulAdd(p[j].x[r], value, gradient));
            }
        }
    put(sum, reference);
}

// Loads the positions of systems [first, first + count), count <= lanes. The remaining lanes repeat the last system.
HWY_INLINE void load_positions(const LocalSystems& systems, const double* position, std::int64_t first, int count,
                               Place* p) {
    const D d;
    const int lanes = static_cast<int>(hn::Lanes(d));
    HWY_ALIGN double gathered[HWY_MAX_BYTES / sizeof(double)];
    for (int m = 0; m < systems.set_size; ++m)
        for (int c = 0; c < 3; ++c) {
            for (int lane = 0; lane < lanes; ++lane) {
                const std::int64_t k = first + (lane < count ? lane : count - 1);
                gathered[lane] = position[(k * systems.set_size + m) * 3 + c];
            }
            p[m].x[c] = hn::Load(d, gathered);
        }
    // Positions are relative to the reference, which is at 0. This keeps numbers small, and each difference is computed
    // only once.
    for (int m = systems.set_size - 1; m >= 0; --m) {
        for (int c = 0; c < 3; ++c) p[m].x[c] = hn::Sub(p[m].x[c], p[0].x[c]);
        const V r2 = hn::MulAdd(p[m].x[2], p[m].x[2], hn::MulAdd(p[m].x[1], p[m].x[1], hn::Mul(p[m].x[0], p[m].x[0])));
        p[m].to_reference = radial(systems, r2);
    }
}

HWY_INLINE void store_factor(const LocalSystems& systems, const double* columns, std::int64_t first, int count,
                             float* factor) {
    const std::int64_t lanes = element_stride();
    const int numbers = 16 * systems.set_size;
    for (int lane = 0; lane < count; ++lane) {
        float* to = factor + (first + lane) * numbers;
        for (int k = 0; k < numbers; ++k) to[k] = static_cast<float>(columns[k * lanes + lane]);
    }
}

void factor_systems(const LocalSystems& systems, const double* position, double* scratch, float* factor) {
    const std::int64_t lanes = element_stride();
    const int skipped = systems.orthogonal_to_linear ? 1 : 0;
    const int blocks = systems.set_size - skipped;
    Place p[LocalSystems::largest_set];
    double* columns = scratch;
    const Triangle triangle{scratch + block_stride() * systems.set_size};
    for (std::int64_t first = 0; first < systems.count; first += lanes) {
        const int count = static_cast<int>(HWY_MIN(lanes, systems.count - first));
        load_positions(systems, position, first, count, p);
        factor_triangle(systems, p + skipped, blocks, triangle);
        last_columns(triangle, blocks, columns + block_stride() * skipped);
        if (systems.orthogonal_to_linear) reference_columns(p + 1, blocks, columns + block_stride(), columns);
        store_factor(systems, columns, first, count, factor);
    }
}

} // namespace

FactorLocalSystems pick() noexcept { return factor_systems; }
std::int64_t lanes() noexcept { return static_cast<std::int64_t>(hn::Lanes(D())); }

} // namespace hrbfnpr::fit::HWY_NAMESPACE::local_factors
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::fit, FactorLocalSystems, local_factors, local_factors::pick)

#if HWY_ONCE
namespace hrbfnpr::fit {

std::int64_t local_factor_batch(base::InstructionSet set) noexcept { return HRBFNPR_PICK(set, local_factors::lanes)(); }

std::int64_t local_factor_scratch_size(base::InstructionSet set, std::int32_t set_size) noexcept {
    const std::int64_t blocks = std::int64_t{set_size} * (set_size + 1) / 2 + set_size;
    return 16 * local_factor_batch(set) * blocks;
}

} // namespace hrbfnpr::fit
#endif
