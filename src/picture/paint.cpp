// SPDX-License-Identifier: MIT
#include "picture/paint.h"

#include "base/assert.h"
#include "base/status.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::picture {
namespace {

// Returns the dot product. It adds in a fixed order, so that all machines get the same bits.
double paint_dot(const glm::dvec3& a, const glm::dvec3& b) noexcept { return a.x * b.x + a.y * b.y + a.z * b.z; }

glm::dvec3 paint_vec(const double (&numbers)[3]) noexcept { return {numbers[0], numbers[1], numbers[2]}; }

template <class Number>
glm::dvec3 paint_vec_at(const Number* numbers, std::int64_t i) noexcept {
    return {static_cast<double>(numbers[3 * i]), static_cast<double>(numbers[3 * i + 1]),
            static_cast<double>(numbers[3 * i + 2])};
}

// Returns the weight of a dab at a place. It is the dab's strength in the middle, and falls to 0 at the edge. It is 0
// where the surface faces away from the dab.
double dab_weight(const hrbfnpr_dab& dab, const glm::dvec3& place, const glm::dvec3& normal) noexcept {
    const glm::dvec3 away = place - paint_vec(dab.position);
    const double share = paint_dot(away, away) / (dab.radius * dab.radius);
    // The comparisons are false for NaN, so NaN is never painted.
    if (!(share < 1.0) || !(paint_dot(normal, paint_vec(dab.normal)) > 0.0)) return 0.0;
    return dab.strength * (1.0 - share) * (1.0 - share);
}

// Cell indices are clamped to this magnitude. Places that are farther away share cells, which only costs time.
constexpr double farthest_paint_cell = 1e9;

std::int64_t paint_cell_along(double place, double side) noexcept {
    const double cell = std::floor(place / side);
    if (!(cell > -farthest_paint_cell)) return static_cast<std::int64_t>(-farthest_paint_cell);
    return static_cast<std::int64_t>(std::min(cell, farthest_paint_cell));
}

// Returns a hash of a cell. If two cells have the same hash, this only costs time, because a dab has no weight outside
// its radius.
std::uint64_t paint_cell_number(std::int64_t x, std::int64_t y, std::int64_t z) noexcept {
    return static_cast<std::uint64_t>(x) * 73856093U ^ static_cast<std::uint64_t>(y) * 19349663U ^
           static_cast<std::uint64_t>(z) * 83492791U;
}

// Raises a tone to a power. For exponents that are frequent in styles it avoids std::pow.
double raised_tone(double base, double exponent) noexcept {
    if (exponent == 1.0) return base;
    if (exponent == 2.0) return base * base;
    return exponent == 0.5 ? std::sqrt(base) : std::pow(base, exponent);
}

bool same_dab(const hrbfnpr_dab& a, const hrbfnpr_dab& b) noexcept {
    return paint_vec(a.position) == paint_vec(b.position) && paint_vec(a.normal) == paint_vec(b.normal) &&
           a.radius == b.radius && a.strength == b.strength && a.value == b.value &&
           paint_vec(a.direction) == paint_vec(b.direction);
}

// Returns the direction of the light as a unit vector in world coordinates.
glm::dvec3 painted_light(const hrbfnpr_style& style, const hrbfnpr_camera& camera) {
    glm::dvec3 light = paint_vec(style.light);
    if (style.light_space == HRBFNPR_LIGHT_CAMERA) {
        const double* const view = camera.view; // in column-major order
        light = {paint_dot({view[0], view[1], view[2]}, light), paint_dot({view[4], view[5], view[6]}, light),
                 paint_dot({view[8], view[9], view[10]}, light)};
    }
    const double length = std::sqrt(paint_dot(light, light));
    if (style.tone == HRBFNPR_TONE_LIGHT && !(length > 0.0))
        fail(Status::invalid_argument, "style.light is zero; give it a direction");
    return (1.0 / length) * light;
}

// The painted data for a style or for marks. It has a separate pool, because copies of the style may outlive the
// picture's pool.
struct HeldPaint {
    HeldPaint(std::span<const hrbfnpr_dab> dabs, std::uint32_t map, base::Memory& memory)
        : pool(memory), tone{PaintedMap(dabs, map, pool)} {}

    Pool pool;
    PaintedTone tone; // Maps of density and direction use only the member `map`.
};

std::shared_ptr<HeldPaint> held_paint(std::span<const hrbfnpr_dab> dabs, std::uint32_t map, const Pool& pool) {
    const auto is_of_map = [&](const hrbfnpr_dab& dab) { return dab.map == map; };
    if (std::none_of(dabs.begin(), dabs.end(), is_of_map)) return nullptr;
    return std::make_shared<HeldPaint>(dabs, map, pool.memory());
}

} // namespace

PaintedMap::PaintedMap(std::span<const hrbfnpr_dab> dabs, std::uint32_t map, Pool& pool) : dabs_(&pool), cells_(&pool) {
    double largest = 0.0;
    for (const hrbfnpr_dab& dab : dabs) {
        if (dab.map != map) continue;
        dabs_.push_back(dab);
        largest = std::max(largest, dab.radius);
    }
    if (largest > 0.0) cell_side_ = 2.0 * largest;
    for (std::size_t i = 0; i < dabs_.size(); ++i) {
        const hrbfnpr_dab& dab = dabs_[i];
        // A cell is as wide as the largest dab, so a dab is in at most two cells along each axis, or three after
        // rounding.
        std::array<std::int64_t, 3> low{}, high{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = paint_cell_along(dab.position[axis] - dab.radius, cell_side_);
            high[axis] = std::min(paint_cell_along(dab.position[axis] + dab.radius, cell_side_), low[axis] + 2);
        }
        for (std::int64_t x = low[0]; x <= high[0]; ++x)
            for (std::int64_t y = low[1]; y <= high[1]; ++y)
                for (std::int64_t z = low[2]; z <= high[2]; ++z)
                    cells_.push_back({paint_cell_number(x, y, z), static_cast<std::uint32_t>(i)});
    }
    const auto order = [](const CellDab& a, const CellDab& b) {
        return a.cell != b.cell ? a.cell < b.cell : a.dab < b.dab;
    };
    std::sort(cells_.begin(), cells_.end(), order);
    // Two cells that a dab overlaps may have the same hash. The dab must be listed only once for this hash.
    const auto same = [](const CellDab& a, const CellDab& b) { return a.cell == b.cell && a.dab == b.dab; };
    cells_.erase(std::unique(cells_.begin(), cells_.end(), same), cells_.end());
}

std::span<const PaintedMap::CellDab> PaintedMap::near(const glm::dvec3& place) const noexcept {
    const std::uint64_t cell =
        paint_cell_number(paint_cell_along(place.x, cell_side_), paint_cell_along(place.y, cell_side_),
                          paint_cell_along(place.z, cell_side_));
    const auto first = std::lower_bound(cells_.begin(), cells_.end(), cell,
                                        [](const CellDab& one, std::uint64_t number) { return one.cell < number; });
    const auto last = std::find_if(first, cells_.end(), [&](const CellDab& one) { return one.cell != cell; });
    return {cells_.data() + (first - cells_.begin()), static_cast<std::size_t>(last - first)};
}

double PaintedMap::pulled(double value, const glm::dvec3& place, const glm::dvec3& normal) const noexcept {
    for (const CellDab& one : near(place)) {
        const hrbfnpr_dab& dab = dabs_[one.dab];
        value += dab_weight(dab, place, normal) * (dab.value - value);
    }
    return value;
}

glm::dvec3 PaintedMap::direction(const glm::dvec3& place, const glm::dvec3& normal) const noexcept {
    glm::dvec3 total(0.0);
    for (const CellDab& one : near(place)) {
        const hrbfnpr_dab& dab = dabs_[one.dab];
        const glm::dvec3 way = paint_vec(dab.direction);
        // Line directions have no sign. So a direction that is opposite to the sum is reversed before it is added.
        const double sign = paint_dot(total, way) < 0.0 ? -1.0 : 1.0;
        const double weight = dab_weight(dab, place, normal);
        total = (1.0 - weight) * total + (weight * sign) * way;
    }
    return total;
}

bool PaintedMap::operator==(const PaintedMap& other) const noexcept {
    return std::equal(dabs_.begin(), dabs_.end(), other.dabs_.begin(), other.dabs_.end(), same_dab);
}

std::int32_t painted_tone(void* user, std::int64_t count, const float* positions, const float* normals,
                          float* tau) noexcept {
    HRBFNPR_ASSERT(user != nullptr && count >= 0);
    const auto& tone = *static_cast<const PaintedTone*>(user);
    for (std::int64_t i = 0; i < count; ++i) {
        const glm::dvec3 normal = paint_vec_at(normals, i);
        const double facing = paint_dot(normal, tone.light);
        double value = 0.0;
        if (tone.is_lit) value = facing >= 0.0 ? raised_tone(facing, tone.exponent) : tone.fill * facing * facing;
        tau[i] = static_cast<float>(tone.map.pulled(value, paint_vec_at(positions, i), normal));
    }
    return 0;
}

std::int32_t painted_density(void* user, std::int64_t count, const double* positions, const double* normals,
                             double* density) noexcept {
    HRBFNPR_ASSERT(user != nullptr && count >= 0);
    const auto& map = *static_cast<const PaintedMap*>(user);
    for (std::int64_t i = 0; i < count; ++i)
        density[i] = std::clamp(map.pulled(1.0, paint_vec_at(positions, i), paint_vec_at(normals, i)), 0.0, 1.0);
    return 0;
}

std::int32_t painted_direction(void* user, std::int64_t count, const double* positions, const double* normals,
                               double* directions) noexcept {
    HRBFNPR_ASSERT(user != nullptr && count >= 0);
    const auto& map = *static_cast<const PaintedMap*>(user);
    for (std::int64_t i = 0; i < count; ++i) {
        const glm::dvec3 direction = map.direction(paint_vec_at(positions, i), paint_vec_at(normals, i));
        for (int axis = 0; axis < 3; ++axis) directions[3 * i + axis] = direction[axis];
    }
    return 0;
}

void set_paint(std::span<const hrbfnpr_dab> dabs, const hrbfnpr_camera& camera, Style& style, Marks& marks,
               Pool& pool) {
    if (const auto held = held_paint(dabs, HRBFNPR_DAB_TONE, pool)) {
        hrbfnpr_style& base = style.base;
        held->tone.light = painted_light(base, camera);
        held->tone.exponent = base.tone_exponent;
        held->tone.fill = static_cast<double>(base.fill_light);
        held->tone.is_lit = base.tone == HRBFNPR_TONE_LIGHT;
        style.hold(held);
        base.tone = HRBFNPR_TONE_CALLBACK;
        base.tone_function = painted_tone;
        base.tone_user = &held->tone;
    }
    if (const auto held = held_paint(dabs, HRBFNPR_DAB_DENSITY, pool)) {
        marks.hold(held);
        for (hrbfnpr_layer_desc& layer : marks.layers) {
            if (layer.kind != HRBFNPR_LAYER_KIND_STIPPLES) continue;
            layer.density = HRBFNPR_DENSITY_CALLBACK;
            layer.density_function = painted_density;
            layer.density_user = &held->tone.map;
        }
    }
    if (const auto held = held_paint(dabs, HRBFNPR_DAB_DIRECTION, pool)) {
        marks.hold(held);
        for (hrbfnpr_layer_desc& layer : marks.layers) {
            if (layer.kind != HRBFNPR_LAYER_KIND_HATCH) continue;
            layer.direction_function = painted_direction;
            layer.direction_user = &held->tone.map;
        }
    }
}

} // namespace hrbfnpr::picture
