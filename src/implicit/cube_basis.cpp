// SPDX-License-Identifier: MIT
#include "implicit/cube_basis.h"

#include "implicit/cube_loops.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::implicit {
namespace {

using Chebyshev = std::array<double, CubeBasis::degree_max + 1>;

void chebyshev(int degree, double x, Chebyshev& t) noexcept {
    t[0] = 1.0;
    t[1] = x;
    for (std::size_t k = 2; k <= static_cast<std::size_t>(degree); ++k) t[k] = 2.0 * x * t[k - 1] - t[k - 2];
}

// Returns the grid whose coordinates are the n + 1 extrema of T_n along each axis.
[[nodiscard]] geometry::VecArray lobatto_grid(base::Memory& memory, int n) {
    geometry::VecArray grid(memory);
    const auto at = [n](int k) { return -std::cos(3.14159265358979323846 * k / n); };
    for (int k = 0; k <= n; ++k)
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) grid.push_back({at(i), at(j), at(k)});
    return grid;
}

// Returns the matrix of all terms (columns) at the points (rows). It is column-major with `stride` numbers per column.
// Rows from `count` on are 0.
[[nodiscard]] base::Array<double> vandermonde(const geometry::VecArray& points, std::int64_t count, int degree,
                                              std::int64_t stride, const base::Progress& progress) {
    const std::int64_t columns = CubeBasis::terms(degree);
    base::Array<double> matrix(points.memory(), stride * columns);
    base::Array<double> terms(points.memory(), columns);
    for (const std::int64_t i : progress.over(count)) {
        CubeBasis::evaluate(degree, points[i], terms.data());
        for (std::int64_t k = 0; k < columns; ++k) matrix[k * stride + i] = terms[k];
    }
    return matrix;
}

// A column-major matrix with `stride` rows.
struct Matrix {
    const double* data;
    int stride;
    int columns;
};

// Multiplies the matrix with `count` interleaved vectors, and adds the products to consecutive columns of `to`.
void add_product(const base::Runtime& runtime, const Matrix& matrix, const double* in, double* to, int count) {
    base::Array<double> nobody(runtime.memory, matrix.stride);
    double* out[cube_batch];
    for (int v = 0; v < cube_batch; ++v) out[v] = v < count ? to + std::int64_t{v} * matrix.stride : nobody.data();
    cube_loops(runtime.instruction_set)
        .multiply(matrix.data, matrix.stride, matrix.stride, matrix.columns, in, out, cube_batch);
}

// Blocked Gaussian elimination with row pivoting for a matrix with more rows than columns. Rows are exchanged in place.
class Elimination {
public:
    Elimination(const base::Runtime& runtime, double* matrix, std::int64_t rows, std::int64_t stride,
                std::int64_t columns)
        : runtime_(runtime), loops_(cube_loops(runtime.instruction_set)), matrix_(matrix), rows_(rows), stride_(stride),
          columns_(columns), row_(runtime.memory, rows) {
        for (std::int64_t i = 0; i < rows; ++i) row_[i] = i;
    }

    // Returns the original index of each row.
    const base::Array<std::int64_t>& run(const base::Progress& progress) {
        for (std::int64_t begin = 0; begin < columns_; begin += panel) {
            progress.check();
            const std::int64_t end = std::min(columns_, begin + panel);
            factor_panel(begin, end);
            if (end < columns_) update(begin, end);
        }
        return row_;
    }

private:
    static constexpr std::int64_t panel = 32;

    [[nodiscard]] double* column(std::int64_t k) noexcept { return matrix_ + k * stride_; }

    void factor_panel(std::int64_t begin, std::int64_t end) {
        for (std::int64_t k = begin; k < end; ++k) {
            double* const pivots = column(k);
            std::int64_t best = k;
            for (std::int64_t i = k + 1; i < rows_; ++i)
                if (std::abs(pivots[i]) > std::abs(pivots[best])) best = i;
            if (best != k) {
                std::swap(row_[k], row_[best]);
                for (std::int64_t j = 0; j < columns_; ++j) std::swap(column(j)[k], column(j)[best]);
            }
            const double scale = 1.0 / pivots[k];
            for (std::int64_t i = k + 1; i < rows_; ++i) pivots[i] *= scale;
            for (std::int64_t j = k + 1; j < end; ++j) subtract(pivots, column(j)[k], k + 1, rows_, column(j));
        }
    }

    static void subtract(const double* from, double factor, std::int64_t begin, std::int64_t end, double* to) noexcept {
        for (std::int64_t i = begin; i < end; ++i) to[i] -= factor * from[i];
    }

    // Updates the columns after a panel of columns: U = L^-1 A in the panel's rows, and A -= L U below them.
    void update(std::int64_t begin, std::int64_t end) {
        runtime_.parallel.for_chunks(columns_ - end, cube_batch, [&](std::int64_t from, std::int64_t to) {
            double in[panel * cube_batch] = {};
            double* out[cube_batch] = {};
            for (std::int64_t v = 0; v < to - from; ++v) {
                double* const at = column(end + from + v);
                for (std::int64_t k = begin; k < end; ++k) {
                    subtract(column(k), at[k], k + 1, end, at);
                    in[(k - begin) * cube_batch + v] = -at[k];
                }
                out[v] = at + end;
            }
            base::Array<double> nobody(runtime_.memory, stride_ - end);
            for (std::int64_t v = to - from; v < cube_batch; ++v) out[v] = nobody.data();
            loops_.multiply(column(begin) + end, stride_, static_cast<int>(stride_ - end), static_cast<int>(panel), in,
                            out, cube_batch);
        });
    }

    const base::Runtime& runtime_;
    CubeLoops loops_;
    double* matrix_;
    std::int64_t rows_;
    std::int64_t stride_;
    std::int64_t columns_;
    base::Array<std::int64_t> row_;
};

// Replaces X by X (L U)^-1. X is column-major. L and U share one square matrix, and the diagonal of L is 1. Each block
// of columns first subtracts the contributions of the finished columns.
class RightSolve {
public:
    struct Factor {
        const double* data;
        std::int64_t stride;
        std::int64_t size;
        [[nodiscard]] double at(std::int64_t i, std::int64_t j) const noexcept { return data[j * stride + i]; }
    };

    RightSolve(base::Memory& memory, const CubeLoops& loops, const Factor& factor, double* x, std::int64_t stride,
               int rows)
        : loops_(loops), factor_(factor), x_(x), stride_(stride), rows_(rows), in_(memory, factor.size * cube_batch),
          unused_column_(memory, rows) {}

    void run(const base::Progress& progress) {
        const std::int64_t n = factor_.size;
        const std::int64_t last = (n - 1) / cube_batch * cube_batch;
        // X U^-1, computed from the left to the right.
        for (std::int64_t begin = 0; begin < n; begin += cube_batch) {
            progress.check();
            const std::int64_t end = std::min<std::int64_t>(n, begin + cube_batch);
            subtract_product(0, begin, begin, end);
            for (std::int64_t j = begin; j < end; ++j) {
                for (std::int64_t k = begin; k < j; ++k) subtract(k, factor_.at(k, j), j);
                const double scale = 1.0 / factor_.at(j, j);
                for (int i = 0; i < rows_; ++i) column(j)[i] *= scale;
            }
        }
        // The product with L^-1, computed from the right to the left.
        for (std::int64_t begin = last; begin >= 0; begin -= cube_batch) {
            progress.check();
            const std::int64_t end = std::min<std::int64_t>(n, begin + cube_batch);
            subtract_product(end, n, begin, end);
            for (std::int64_t j = end - 1; j >= begin; --j)
                for (std::int64_t k = j + 1; k < end; ++k) subtract(k, factor_.at(k, j), j);
        }
    }

private:
    [[nodiscard]] double* column(std::int64_t j) noexcept { return x_ + j * stride_; }

    void subtract(std::int64_t from, double factor, std::int64_t to) noexcept {
        const double* const a = column(from);
        double* const b = column(to);
        for (int i = 0; i < rows_; ++i) b[i] -= factor * a[i];
    }

    // X[begin, end) -= X[first, last) F[first, last; begin, end)
    void subtract_product(std::int64_t first, std::int64_t last, std::int64_t begin, std::int64_t end) noexcept {
        if (first == last) return;
        double* out[cube_batch];
        for (std::int64_t v = 0; v < cube_batch; ++v) {
            out[v] = begin + v < end ? column(begin + v) : unused_column_.data();
            for (std::int64_t k = first; k < last; ++k)
                in_[(k - first) * cube_batch + v] = begin + v < end ? -factor_.at(k, begin + v) : 0.0;
        }
        loops_.multiply(column(first), stride_, rows_, static_cast<int>(last - first), in_.data(), out, cube_batch);
    }

    const CubeLoops& loops_;
    Factor factor_;
    double* x_;
    std::int64_t stride_;
    int rows_;
    base::Array<double> in_;
    base::Array<double> unused_column_;
};

constexpr std::int64_t rows_at_a_time = 128;

} // namespace

CubeBasis::CubeBasis(const base::Work& work, int degree)
    : degree_(degree), nodes_(work.memory, stride()), to_coefficients_(work.memory), transposed_(work.memory) {
    const geometry::VecArray grid = lobatto_grid(work.memory, std::max(degree_, 1));
    const std::int64_t rows = padded(static_cast<int>(grid.size()));
    base::Array<double> matrix = triharmonic_values(grid, grid.size(), degree_, rows, work);
    Elimination elimination(work, matrix.data(), grid.size(), rows, size());
    const base::Array<std::int64_t>& row = elimination.run(work);
    for (std::int64_t k = 0; k < size(); ++k) nodes_.set(k, grid[row[k]]);
    work.check();
    invert(work, matrix.data(), rows);
    transpose(work);
}

void CubeBasis::evaluate(int degree, const glm::dvec3& p, double* terms) noexcept {
    std::array<Chebyshev, 3> t{};
    for (glm::length_t c = 0; c < 3; ++c) chebyshev(std::max(degree, 1), p[c], t[static_cast<std::size_t>(c)]);
    for (std::size_t a = 0; a <= static_cast<std::size_t>(degree); ++a)
        for (std::size_t b = 0; a + b <= static_cast<std::size_t>(degree); ++b)
            for (std::size_t c = 0; a + b + c <= static_cast<std::size_t>(degree); ++c)
                *terms++ = t[0][a] * t[1][b] * t[2][c];
}

// Sets to_coefficients_ to the coefficients of the basis times (L U)^-1.
void CubeBasis::invert(const base::Work& work, const double* factor, std::int64_t factor_stride) {
    to_coefficients_ = triharmonic_coefficients(work.memory, degree_, term_stride(), work);
    // Rows are independent of each other. A task solves rows_at_a_time rows, which fill several SIMD vectors.
    work.for_chunks(term_stride(), rows_at_a_time, [&](std::int64_t begin, std::int64_t end) {
        RightSolve(work.memory, cube_loops(work.instruction_set), {factor, factor_stride, size()},
                   to_coefficients_.data() + begin, term_stride(), static_cast<int>(end - begin))
            .run(work);
    });
}

void CubeBasis::transpose(const base::Progress& progress) {
    transposed_.resize(std::int64_t{terms()} * stride());
    for (const std::int64_t j : progress.over(size())) {
        for (std::int64_t k = 0; k < terms(); ++k)
            transposed_[k * stride() + j] = to_coefficients_[j * term_stride() + k];
    }
}

base::Array<double> CubeBasis::interpolation(const base::Work& work, const geometry::VecArray& points,
                                             int count) const {
    const int n = size();
    const int rows = padded(count);
    const base::Array<double> values = vandermonde(points, count, degree_, rows, work);
    base::Array<double> result(work.memory, std::int64_t{rows} * n);
    work.for_chunks(n, cube_batch, [&](std::int64_t begin, std::int64_t end) {
        base::Array<double> in(work.memory, std::int64_t{terms()} * cube_batch);
        for (std::int64_t v = 0; begin + v < end; ++v)
            for (std::int64_t k = 0; k < terms(); ++k)
                in[k * cube_batch + v] = to_coefficients_[(begin + v) * term_stride() + k];
        add_product(work, {values.data(), rows, terms()}, in.data(), result.data() + begin * rows,
                    static_cast<int>(end - begin));
    });
    return result;
}

} // namespace hrbfnpr::implicit
