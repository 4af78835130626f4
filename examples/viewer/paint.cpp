// SPDX-License-Identifier: MIT
#include "paint.h"

#include <algorithm>

namespace viewer {

namespace {

// 1 in the middle of a dab, 0 at its edge and on what faces away from it.  _settings.py has the same formula.
double weight(const Dab& dab, const Vec& place, const Vec& normal) {
    const Vec away = place - dab.position;
    const double share = dot(away, away) / (dab.radius * dab.radius);
    if (share >= 1 || dot(normal, dab.normal) <= 0) return 0;
    return dab.strength * (1 - share) * (1 - share);
}

std::int64_t floor_of(double x) { return static_cast<std::int64_t>(std::floor(std::clamp(x, -1e9, 1e9))); }

template <class Number>
Vec vec_at(const Number* numbers, std::int64_t i) {
    return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]};
}

} // namespace

PaintedMap::PaintedMap(const std::vector<Dab>& dabs, Map map) {
    std::copy_if(dabs.begin(), dabs.end(), std::back_inserter(dabs_), [&](const Dab& dab) { return dab.map == map; });
    double largest = 0;
    for (const Dab& dab : dabs_) largest = std::max(largest, dab.radius);
    if (largest > 0) cell_ = 2 * largest;
    for (std::uint32_t i = 0; i < dabs_.size(); ++i) {
        const Dab& dab = dabs_[i];
        std::array<std::int64_t, 3> low, high;
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = floor_of((dab.position[k] - dab.radius) / cell_);
            high[k] = floor_of((dab.position[k] + dab.radius) / cell_);
        }
        for (auto x = low[0]; x <= high[0]; ++x)
            for (auto y = low[1]; y <= high[1]; ++y)
                for (auto z = low[2]; z <= high[2]; ++z)
                    if (auto& numbers = cells_[cell_of(x, y, z)]; numbers.empty() || numbers.back() != i)
                        numbers.push_back(i); // once, though two cells of it may share a number
    }
}

// Cells that share a number only cost time: a dab beyond its radius has no weight.
std::uint64_t PaintedMap::cell_of(std::int64_t x, std::int64_t y, std::int64_t z) const {
    return static_cast<std::uint64_t>(x) * 73856093U ^ static_cast<std::uint64_t>(y) * 19349663U ^
           static_cast<std::uint64_t>(z) * 83492791U;
}

const std::vector<std::uint32_t>* PaintedMap::near(const Vec& place) const {
    const auto found =
        cells_.find(cell_of(floor_of(place[0] / cell_), floor_of(place[1] / cell_), floor_of(place[2] / cell_)));
    return found == cells_.end() ? nullptr : &found->second;
}

double PaintedMap::pulled(double value, const Vec& place, const Vec& normal) const {
    if (const auto* const numbers = near(place))
        for (const std::uint32_t i : *numbers) value += weight(dabs_[i], place, normal) * (dabs_[i].value - value);
    return value;
}

Vec PaintedMap::direction(const Vec& place, const Vec& normal) const {
    Vec sum{};
    if (const auto* const numbers = near(place))
        for (const std::uint32_t i : *numbers) {
            const double sign = dot(dabs_[i].direction, sum) < 0 ? -1 : 1; // lines have no sign
            const double w = weight(dabs_[i], place, normal);
            sum = (1 - w) * sum + (w * sign) * dabs_[i].direction;
        }
    return sum;
}

std::int32_t painted_tone(void* user, std::int64_t count, const float* positions, const float* normals, float* tau) {
    const auto& tone = *static_cast<const PaintedTone*>(user);
    for (std::int64_t i = 0; i < count; ++i) {
        const Vec normal = vec_at(normals, i);
        const double facing = dot(normal, tone.light);
        double value = 0;
        if (tone.lit)
            value = facing >= 0 ? (tone.exponent == 1 ? facing : std::pow(facing, tone.exponent))
                                : tone.fill * facing * facing;
        tau[i] = static_cast<float>(tone.map->pulled(value, vec_at(positions, i), normal));
    }
    return 0;
}

std::int32_t painted_density(void* user, std::int64_t count, const double* positions, const double* normals,
                             double* density) {
    const auto& map = *static_cast<const PaintedMap*>(user);
    for (std::int64_t i = 0; i < count; ++i)
        density[i] = std::clamp(map.pulled(1, vec_at(positions, i), vec_at(normals, i)), 0.0, 1.0);
    return 0;
}

std::int32_t painted_direction(void* user, std::int64_t count, const double* positions, const double* normals,
                               double* directions) {
    const auto& map = *static_cast<const PaintedMap*>(user);
    for (std::int64_t i = 0; i < count; ++i) {
        const Vec direction = map.direction(vec_at(positions, i), vec_at(normals, i));
        std::copy(direction.begin(), direction.end(), directions + 3 * i);
    }
    return 0;
}

} // namespace viewer
