// SPDX-License-Identifier: MIT
// Memory for the results of a batch, and a plain HRBF to compare with.
#pragma once

#include "implicit/hrbf.h"

#include <vector>

namespace test {

struct Points {
    std::vector<double> x, y, z;

    void add(const glm::dvec3& p) {
        x.push_back(p.x);
        y.push_back(p.y);
        z.push_back(p.z);
    }
    [[nodiscard]] hrbfnpr::implicit::PointBatch batch() const {
        return {x.data(), y.data(), z.data(), static_cast<std::int64_t>(x.size())};
    }
    [[nodiscard]] glm::dvec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
    [[nodiscard]] std::size_t size() const { return x.size(); }
};

struct Fields {
    explicit Fields(std::size_t count) : value(count, -7.0) {
        for (auto& component : gradient) component.assign(count, -7.0);
        for (auto& component : hessian) component.assign(count, -7.0);
    }
    hrbfnpr::implicit::FieldBatch batch(bool with_value, bool with_gradient, bool with_hessian) {
        hrbfnpr::implicit::FieldBatch batch;
        if (with_value) batch.value = value.data();
        for (std::size_t c = 0; c < 3 && with_gradient; ++c) batch.gradient[c] = gradient[c].data();
        for (std::size_t c = 0; c < 6 && with_hessian; ++c) batch.hessian[c] = hessian[c].data();
        return batch;
    }
    hrbfnpr::implicit::FieldBatch all() { return batch(true, true, true); }

    std::vector<double> value;
    std::array<std::vector<double>, 3> gradient;
    std::array<std::vector<double>, 6> hessian;
};

constexpr std::size_t hessian_index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};

// A number in [-1, 1) that looks random and is the same on every machine.
inline double scatter(int i) {
    const double product = 0.6180339887498949 * (i + 1) * (1.0 + 0.37 * (i % 11));
    return 2.0 * (product - static_cast<double>(static_cast<long long>(product))) - 1.0;
}

} // namespace test
