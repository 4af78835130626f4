// SPDX-License-Identifier: MIT
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fit/sparse_blocks.cpp"
#include "base/simd.h"

#include "fit/sparse_blocks.h"

HWY_BEFORE_NAMESPACE();
namespace hrbfnpr::fit::HWY_NAMESPACE::sparse_blocks {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// A row of a block has four numbers, in one vector or in several vectors.
using D = hn::CappedTag<double, 4>;
using F = hn::Rebind<float, D>;
using V = hn::Vec<D>;
constexpr int parts = 4 / static_cast<int>(HWY_MIN(4, HWY_LANES(double)));

struct Row {
    V v[parts];
};

HWY_INLINE std::int64_t lanes() { return static_cast<std::int64_t>(hn::Lanes(D())); }

HWY_INLINE Row zero() {
    Row row;
    for (int p = 0; p < parts; ++p) row.v[p] = hn::Zero(D());
    return row;
}

HWY_INLINE Row load(const float* from) {
    Row row;
    for (int p = 0; p < parts; ++p) row.v[p] = hn::PromoteTo(D(), hn::LoadU(F(), from + p * lanes()));
    return row;
}

HWY_INLINE Row load(const double* from) {
    Row row;
    for (int p = 0; p < parts; ++p) row.v[p] = hn::LoadU(D(), from + p * lanes());
    return row;
}

HWY_INLINE void add_product(const Row& a, const Row& b, Row& sum) {
    for (int p = 0; p < parts; ++p) sum.v[p] = hn::MulAdd(a.v[p], b.v[p], sum.v[p]);
}

HWY_INLINE void add_product(const Row& a, double b, Row& sum) {
    for (int p = 0; p < parts; ++p) sum.v[p] = hn::MulAdd(a.v[p], hn::Set(D(), b), sum.v[p]);
}

HWY_INLINE double total(const Row& row) {
    double number[4];
    for (int p = 0; p < parts; ++p) hn::StoreU(row.v[p], D(), number + p * lanes());
    return (number[0] + number[1]) + (number[2] + number[3]);
}

void multiply_transposed(const SparseFactor& factor, std::int64_t begin, std::int64_t end, const double* r, double* t) {
    for (std::int64_t i = begin; i < end; ++i) {
        Row sum = zero();
        const std::int32_t* set = factor.set + i * factor.set_size;
        const float* block = factor.factor + i * factor.set_size * 16;
        for (std::int64_t k = 0; k < factor.set_size && set[0] >= 0; ++k, block += 16) {
            const double* x = r + 4 * static_cast<std::int64_t>(set[k]);
            for (std::int64_t row = 0; row < 4; ++row) add_product(load(block + 4 * row), x[row], sum);
        }
        for (int p = 0; p < parts; ++p) hn::StoreU(sum.v[p], D(), t + 4 * i + p * lanes());
    }
}

void multiply(const SparseFactor& factor, std::int64_t begin, std::int64_t end, const double* t, double* z) {
    for (std::int64_t j = begin; j < end; ++j) {
        Row sum[4] = {zero(), zero(), zero(), zero()};
        for (std::int64_t use = factor.use_begin[j]; use < factor.use_begin[j + 1]; ++use) {
            const std::int64_t element = factor.use[use];
            const float* block = factor.factor + element * 16;
            const Row x = load(t + 4 * (element / factor.set_size));
            for (std::int64_t row = 0; row < 4; ++row) add_product(load(block + 4 * row), x, sum[row]);
        }
        for (int row = 0; row < 4; ++row) z[4 * j + row] = total(sum[row]);
    }
}

} // namespace

SparseBlocks pick() noexcept { return {multiply_transposed, multiply}; }

} // namespace hrbfnpr::fit::HWY_NAMESPACE::sparse_blocks
HWY_AFTER_NAMESPACE();

HRBFNPR_CHOOSE(hrbfnpr::fit, SparseBlocks, sparse_blocks, sparse_blocks::pick)
