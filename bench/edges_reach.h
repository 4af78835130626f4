// SPDX-License-Identifier: MIT
// The surface of a solid by a dense search: sign changes on the edges of a lattice.
#pragma once

#include "calls.h"

#include <glm/glm.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace bench {

class DenseSurface {
public:
    static constexpr int cells = 48; // along each axis of the box

    DenseSurface(const hrbfnpr_model* model, const glm::dvec3& low, const glm::dvec3& high)
        : low_(low), step_((high - low) / static_cast<double>(cells)) {
        const std::vector<double> value = values(model);
        for (int z = 0; z <= cells; ++z)
            for (int y = 0; y <= cells; ++y)
                for (int x = 0; x <= cells; ++x)
                    for (int axis = 0; axis < 3; ++axis) add(value, {x, y, z}, axis);
    }

    // May also be true if all walls are thinner than a cell.
    [[nodiscard]] bool empty() const { return places_.empty(); }
    // The distance to the nearest place found. The places are on lattice edges, so the surface may be up to half a cell
    // nearer.
    [[nodiscard]] double distance(const glm::dvec3& from) const {
        double least = std::numeric_limits<double>::infinity();
        for (const glm::dvec3& place : places_) {
            const glm::dvec3 way = place - from;
            least = std::min(least, glm::dot(way, way));
        }
        return std::sqrt(least);
    }

private:
    [[nodiscard]] static std::size_t at(const glm::ivec3& i) {
        constexpr std::size_t row = cells + 1;
        return (static_cast<std::size_t>(i.z) * row + static_cast<std::size_t>(i.y)) * row +
               static_cast<std::size_t>(i.x);
    }
    [[nodiscard]] glm::dvec3 place(const glm::ivec3& i) const { return low_ + glm::dvec3(i) * step_; }
    [[nodiscard]] std::vector<double> values(const hrbfnpr_model* model) const {
        std::vector<double> points;
        for (int z = 0; z <= cells; ++z)
            for (int y = 0; y <= cells; ++y)
                for (int x = 0; x <= cells; ++x) {
                    const glm::dvec3 p = place({x, y, z});
                    points.insert(points.end(), {p.x, p.y, p.z});
                }
        std::vector<double> value(points.size() / 3);
        const hrbfnpr_array in = view(points);
        const hrbfnpr_array_out to{value.data(), static_cast<std::int64_t>(value.size()), 0, HRBFNPR_SCALAR_FLOAT64, 1};
        scenes::Check check;
        check(hrbfnpr_model_evaluate(model, &in, &to, nullptr, nullptr, nullptr, check.error()));
        return value;
    }
    void add(const std::vector<double>& value, const glm::ivec3& from, int axis) {
        if (from[axis] == cells) return;
        glm::ivec3 to = from;
        ++to[axis];
        const double a = value[at(from)];
        const double b = value[at(to)];
        if ((a < 0.0) != (b < 0.0)) places_.push_back(glm::mix(place(from), place(to), a / (a - b)));
    }

    glm::dvec3 low_, step_;
    std::vector<glm::dvec3> places_;
};

} // namespace bench
