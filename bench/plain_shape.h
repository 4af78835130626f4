// SPDX-License-Identifier: MIT
// Second and third derivatives of a fitted surface, summed directly from the weights in its file.
#pragma once

#include "calls.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace bench {

// A saved model, in the format of docs/file-format.md.
class ModelFile {
public:
    explicit ModelFile(const hrbfnpr_model* model) {
        scenes::Check check;
        std::int64_t size = 0;
        (void)hrbfnpr_model_save_memory(model, nullptr, 0, &size, nullptr); // sets the size
        bytes_.resize(static_cast<std::size_t>(size));
        check(hrbfnpr_model_save_memory(model, bytes_.data(), size, &size, check.error()));
    }
    template <class T>
    [[nodiscard]] std::vector<T> section(const char* tag) const {
        for (std::size_t at = header; at + 16 <= bytes_.size();) {
            std::uint32_t type = 0;
            std::uint64_t count = 0;
            std::memcpy(&type, &bytes_[at + 4], sizeof type);
            std::memcpy(&count, &bytes_[at + 8], sizeof count);
            constexpr std::array<std::size_t, 6> width{0, 4, 8, 1, 4, 8};
            if (std::memcmp(&bytes_[at], tag, 4) == 0) {
                std::vector<T> values(static_cast<std::size_t>(count));
                std::memcpy(values.data(), &bytes_[at + 16], values.size() * sizeof(T));
                return values;
            }
            at += 16 + width.at(type) * static_cast<std::size_t>(count);
        }
        throw std::runtime_error(std::string("a model's file has no section ").append(tag));
    }

private:
    static constexpr std::size_t header = 40;
    std::vector<char> bytes_;
};

// Second derivatives xx xy xz yy yz zz and third ones xxx xxy xxz xyy xyz xzz yyy yyz yzz zzz.
struct Derivatives {
    std::array<double, 6> second{};
    std::array<double, 10> third{};
};

// Replaces the kernel r^3 by (r^2 + eps^2)^(3/2), eps = 0.3 spacings, as the library does for the shape of a surface
// whose own derivatives jump at its samples.  The kernel is differentiated with the unit weights of
//   f(x) = sum_j alpha_j phi(d_j) - beta_j . grad phi(d_j), d_j = x - c_j.
class PlainShape {
public:
    explicit PlainShape(const hrbfnpr_model* model) {
        const ModelFile file(model);
        const std::vector<std::uint32_t> kind = file.section<std::uint32_t>("KIND");
        if (kind.at(0) != HRBFNPR_KERNEL_TRIHARMONIC || kind.at(1) > 2)
            throw std::runtime_error("plain shapes are of r^3 with a linear polynomial");
        const std::vector<double> numbers = file.section<double>("NUMB");
        centre_ = {numbers.at(1), numbers.at(2), numbers.at(3)};
        scale_ = numbers.at(4);
        const double eps = 0.3 * numbers.at(11) / scale_;
        smoothing_ = eps * eps;
        const std::array<const char*, 7> tags{"CENX", "CENY", "CENZ", "ALPH", "BETX", "BETY", "BETZ"};
        for (std::size_t i = 0; i < tags.size(); ++i) source_[i] = file.section<double>(tags[i]);
    }

    [[nodiscard]] std::vector<Derivatives> at(const std::vector<glm::dvec3>& places) const {
        std::vector<Derivatives> result(places.size());
        const std::size_t workers = std::max(1U, std::thread::hardware_concurrency());
        std::vector<std::thread> threads;
        for (std::size_t w = 0; w < workers; ++w)
            threads.emplace_back([&, w] {
                for (std::size_t i = w * lanes; i < places.size(); i += workers * lanes)
                    sum_block(&places[i], std::min(lanes, places.size() - i), &result[i]);
            });
        for (std::thread& thread : threads) thread.join();
        return result;
    }

private:
    static constexpr std::size_t lanes = 32;
    struct Block {
        std::array<std::array<double, lanes>, 3> x;
        std::array<std::array<double, lanes>, 16> sum;
    };

    void sum_block(const glm::dvec3* places, std::size_t count, Derivatives* result) const {
        Block block{};
        for (std::size_t k = 0; k < lanes; ++k) {
            const glm::dvec3 y = (places[std::min(k, count - 1)] - centre_) / scale_;
            for (glm::length_t c = 0; c < 3; ++c) block.x[static_cast<std::size_t>(c)][k] = y[c];
        }
        std::array<const double*, 7> source{};
        for (std::size_t i = 0; i < source.size(); ++i) source[i] = source_[i].data();
        add_all(source, source_[0].size(), smoothing_, block);
        for (std::size_t k = 0; k < count; ++k) {
            for (std::size_t c = 0; c < 6; ++c) result[k].second[c] = block.sum[c][k] / scale_;
            for (std::size_t c = 0; c < 10; ++c) result[k].third[c] = block.sum[6 + c][k] / (scale_ * scale_);
        }
    }
    // D2 phi = 3 R I + 3 dd / R,  D3 phi = 3 / R sym(I d) - 3 / R^3 ddd,
    // D4 phi = 3 / R sym(I I) - 3 / R^3 sym(I dd) + 9 / R^5 dddd;  q = d . beta.
    __attribute__((target_clones("default", "arch=x86-64-v3", "arch=x86-64-v4"))) static void
    add_all(const std::array<const double*, 7>& source, std::size_t count, double smoothing, Block& b) {
        for (std::size_t j = 0; j < count; ++j) {
            const double cx = source[0][j], cy = source[1][j], cz = source[2][j];
            const double a = source[3][j], bx = source[4][j], by = source[5][j], bz = source[6][j];
            for (std::size_t k = 0; k < lanes; ++k) {
                const double x = b.x[0][k] - cx, y = b.x[1][k] - cy, z = b.x[2][k] - cz;
                const double r2 = x * x + y * y + z * z + smoothing;
                const double r = std::sqrt(r2);
                const double q = x * bx + y * by + z * bz;
                const double u = 3.0 / r;
                const double w = u / r2;
                const double iso = 3.0 * a * r - u * q;
                const double dd = a * u + w * q;
                b.sum[0][k] += iso + dd * x * x - 2.0 * u * x * bx;
                b.sum[1][k] += dd * x * y - u * (x * by + y * bx);
                b.sum[2][k] += dd * x * z - u * (x * bz + z * bx);
                b.sum[3][k] += iso + dd * y * y - 2.0 * u * y * by;
                b.sum[4][k] += dd * y * z - u * (y * bz + z * by);
                b.sum[5][k] += iso + dd * z * z - 2.0 * u * z * bz;
                // sym(I v) + sym(m dd)
                const double vx = dd * x - u * bx, vy = dd * y - u * by, vz = dd * z - u * bz;
                const double ddd = -w * (a + 3.0 * q / r2) / 3.0;
                const double mx = ddd * x + w * bx, my = ddd * y + w * by, mz = ddd * z + w * bz;
                b.sum[6][k] += 3.0 * (vx + mx * x * x);
                b.sum[7][k] += vy + x * (2.0 * mx * y + my * x);
                b.sum[8][k] += vz + x * (2.0 * mx * z + mz * x);
                b.sum[9][k] += vx + y * (2.0 * my * x + mx * y);
                b.sum[10][k] += mx * y * z + my * x * z + mz * x * y;
                b.sum[11][k] += vx + z * (2.0 * mz * x + mx * z);
                b.sum[12][k] += 3.0 * (vy + my * y * y);
                b.sum[13][k] += vz + y * (2.0 * my * z + mz * y);
                b.sum[14][k] += vy + z * (2.0 * mz * y + my * z);
                b.sum[15][k] += 3.0 * (vz + mz * z * z);
            }
        }
    }

    glm::dvec3 centre_{0.0};
    double scale_ = 1.0;
    double smoothing_ = 0.0;
    std::array<std::vector<double>, 7> source_;
};

} // namespace bench
