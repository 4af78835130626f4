// SPDX-License-Identifier: MIT
// Points or vectors as a structure of arrays.
#pragma once

#include "base/memory.h"
#include "geometry/vec.h"

namespace hrbfnpr::geometry {

class VecArray {
public:
    explicit VecArray(base::Memory& memory) noexcept : x(memory), y(memory), z(memory) {}
    VecArray(base::Memory& memory, std::int64_t size) : x(memory, size), y(memory, size), z(memory, size) {}

    [[nodiscard]] std::int64_t size() const noexcept { return x.size(); }
    [[nodiscard]] bool empty() const noexcept { return x.empty(); }
    [[nodiscard]] std::int64_t bytes() const noexcept { return x.bytes() + y.bytes() + z.bytes(); }
    [[nodiscard]] glm::dvec3 operator[](std::int64_t i) const noexcept { return {x[i], y[i], z[i]}; }
    [[nodiscard]] base::Memory& memory() const noexcept { return x.memory(); }

    void set(std::int64_t i, const glm::dvec3& v) noexcept {
        x[i] = v.x;
        y[i] = v.y;
        z[i] = v.z;
    }
    void push_back(const glm::dvec3& v) {
        x.push_back(v.x);
        y.push_back(v.y);
        z.push_back(v.z);
    }
    void resize(std::int64_t size) {
        x.resize(size);
        y.resize(size);
        z.resize(size);
    }
    void reserve(std::int64_t capacity) {
        x.reserve(capacity);
        y.reserve(capacity);
        z.reserve(capacity);
    }
    void clear() noexcept {
        x.clear();
        y.clear();
        z.clear();
    }

    base::Array<double> x, y, z;
};

} // namespace hrbfnpr::geometry
