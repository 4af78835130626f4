// SPDX-License-Identifier: MIT
#include "implicit/triharmonic_basis.h"

#include "base/long_array.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hrbfnpr::implicit {
namespace {

// A polynomial is stored as a column of numbers. Recurrences multiply it by coordinates.

// Columns that hold values of polynomials at points.
class BasisValues {
public:
    BasisValues(const geometry::VecArray& points, std::int64_t count) noexcept : points_(points), count_(count) {}

    [[nodiscard]] base::Memory& memory() const noexcept { return points_.memory(); }
    [[nodiscard]] std::int64_t size() const noexcept { return count_; }
    void set_one(double* column) const noexcept { std::fill_n(column, count_, 1.0); }
    // out += factor x_axis in
    void add_times(int axis, double factor, const double* in, double* out) const noexcept {
        const std::array<const double*, 3> axes{points_.x.data(), points_.y.data(), points_.z.data()};
        const double* const x = axes[static_cast<std::size_t>(axis)];
        for (std::int64_t i = 0; i < count_; ++i) out[i] += factor * x[i] * in[i];
    }

private:
    const geometry::VecArray& points_;
    std::int64_t count_;
};

// Columns that hold coefficients of Chebyshev products, multiplied with x T_a = (T_(a+1) + T_|a-1|) / 2. Terms above
// the degree are omitted; no resulting polynomial has such terms.
class Coefficients {
public:
    Coefficients(base::Memory& memory, int degree) : memory_(memory), degree_(degree), index_(memory) {
        const int side = degree + 1;
        index_.resize(std::int64_t{side} * side * side);
        for (int a = 0; a <= degree; ++a)
            for (int b = 0; a + b <= degree; ++b)
                for (int c = 0; a + b + c <= degree; ++c) index_[place({a, b, c})] = size_++;
    }

    [[nodiscard]] base::Memory& memory() const noexcept { return memory_; }
    [[nodiscard]] std::int64_t size() const noexcept { return size_; }
    void set_one(double* column) const noexcept {
        std::fill_n(column, size_, 0.0);
        column[0] = 1.0;
    }
    void add_times(int axis, double factor, const double* in, double* out) const noexcept {
        for (int a = 0; a <= degree_; ++a)
            for (int b = 0; a + b <= degree_; ++b)
                for (int c = 0; a + b + c <= degree_; ++c) {
                    const double half = 0.5 * factor * *in++;
                    if (half == 0.0) continue; // seven of eight terms are 0, because a polynomial has a parity
                    std::array<int, 3> up{a, b, c};
                    std::array<int, 3> down = up;
                    ++up[static_cast<std::size_t>(axis)];
                    int& order = down[static_cast<std::size_t>(axis)];
                    order = order > 0 ? order - 1 : 1;
                    if (a + b + c < degree_) out[index_[place(up)]] += half;
                    if (down[0] + down[1] + down[2] <= degree_) out[index_[place(down)]] += half;
                }
    }

private:
    [[nodiscard]] std::int64_t place(const std::array<int, 3>& order) const noexcept {
        return (std::int64_t{order[0]} * (degree_ + 1) + order[1]) * (degree_ + 1) + order[2];
    }

    base::Memory& memory_;
    int degree_;
    std::int64_t size_ = 0;
    base::Array<std::int64_t> index_;
};

// Returns the column of the function h T_k, where h is the solid harmonic of degree l with the index `number`. The
// function has the degree l + 2 k. Columns are sorted by degree, then by k.
[[nodiscard]] int column_of(int l, int k, int number) noexcept {
    const int degree = l + 2 * k;
    int column = degree > 0 ? triharmonic_size(degree - 1) : 0;
    for (int before = 0; before < k; ++before) column += 2 * (degree - 2 * before) + 1;
    return column + number;
}

template <class Columns>
class Recurrence {
public:
    Recurrence(const Columns& columns, int degree, std::int64_t stride)
        : columns_(columns), degree_(degree), stride_(stride), result_(columns.memory()),
          spare_(columns.memory(), columns.size()) {}

    [[nodiscard]] base::Array<double> run(const base::Progress& progress) {
        base::resize_long(result_, stride_ * triharmonic_size(degree_), progress);
        columns_.set_one(harmonic(0, 0));
        for (int m = 0; m <= degree_; ++m) {
            for (int side = 0; side < (m > 0 ? 2 : 1); ++side) climb(m, side, progress);
            if (m < degree_) turn(m);
        }
        for (int l = 0; l <= degree_; ++l) {
            for (int number = 0; number <= 2 * l; ++number) {
                progress.check();
                add_radial(l, number);
            }
        }
        return std::move(result_);
    }

private:
    // Returns the index of a solid harmonic of order m. `side` is 0 for the harmonic with the cosine, 1 for the
    // harmonic with the sine.
    [[nodiscard]] static int number_of(int m, int side) noexcept { return m == 0 ? 0 : 2 * m - 1 + side; }
    [[nodiscard]] double* at(int l, int k, int number) noexcept {
        return result_.data() + stride_ * column_of(l, k, number);
    }
    [[nodiscard]] double* harmonic(int l, int number) noexcept { return at(l, 0, number); }

    void add_times_squared(double factor, const double* in, double* out) {
        for (int axis = 0; axis < 3; ++axis) {
            std::fill(spare_.begin(), spare_.end(), 0.0);
            columns_.add_times(axis, 1.0, in, spare_.data());
            columns_.add_times(axis, factor, spare_.data(), out);
        }
    }

    // Computes the solid harmonics of order m and degrees above m by (l - m + 1) R_(l+1) = (2 l + 1) z R_l - (l + m)
    // |x|^2 R_(l-1).
    void climb(int m, int side, const base::Progress& progress) {
        const int number = number_of(m, side);
        for (int l = m; l < degree_; ++l) {
            progress.check();
            double* const next = harmonic(l + 1, number);
            columns_.add_times(2, (2.0 * l + 1.0) / (l - m + 1.0), harmonic(l, number), next);
            if (l > m) add_times_squared(-(l + m) / (l - m + 1.0), harmonic(l - 1, number), next);
        }
    }

    // Computes the harmonics of degree and order m + 1 by C_(m+1) + i S_(m+1) = (x + i y) (C_m + i S_m).
    void turn(int m) {
        const double* const cosine = harmonic(m, number_of(m, 0));
        double* const next_cosine = harmonic(m + 1, number_of(m + 1, 0));
        double* const next_sine = harmonic(m + 1, number_of(m + 1, 1));
        columns_.add_times(0, 1.0, cosine, next_cosine);
        columns_.add_times(1, 1.0, cosine, next_sine);
        if (m == 0) return;
        const double* const sine = harmonic(m, number_of(m, 1));
        columns_.add_times(1, -1.0, sine, next_cosine);
        columns_.add_times(0, 1.0, sine, next_sine);
    }

    // Adds the harmonic times T_1 = 2 |x|^2 / 3 - 1, and times T_2 = 2 T_1 T_1 - 1.
    void add_radial(int l, int number) {
        const double* const h = harmonic(l, number);
        if (l + 2 > degree_) return;
        double* const first = at(l, 1, number);
        add_times_squared(2.0 / 3.0, h, first);
        for (std::int64_t i = 0; i < columns_.size(); ++i) first[i] -= h[i];
        if (l + 4 > degree_) return;
        double* const second = at(l, 2, number);
        add_times_squared(4.0 / 3.0, first, second);
        for (std::int64_t i = 0; i < columns_.size(); ++i) second[i] -= 2.0 * first[i] + h[i];
    }

    const Columns& columns_;
    int degree_;
    std::int64_t stride_;
    base::Array<double> result_;
    base::Array<double> spare_;
};

} // namespace

base::Array<double> triharmonic_values(const geometry::VecArray& points, std::int64_t count, int degree,
                                       std::int64_t stride, const base::Progress& progress) {
    const BasisValues values(points, count);
    return Recurrence(values, degree, stride).run(progress);
}

base::Array<double> triharmonic_coefficients(base::Memory& memory, int degree, std::int64_t stride,
                                             const base::Progress& progress) {
    const Coefficients coefficients(memory, degree);
    return Recurrence(coefficients, degree, stride).run(progress);
}

} // namespace hrbfnpr::implicit
