// SPDX-License-Identifier: MIT
#include "orient/sides.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

constexpr std::size_t spacing_ring = 6; // neighbours that a local spacing is the mean distance of
// Of a hexagonal lattice, area over squared distance.
constexpr double area_share = 0.8660254037844386;
constexpr double sphere = 12.566370614359172; // solid angle
constexpr std::int64_t probes = 192;
// In local spacings: near enough for thin walls not to matter outside, and far enough for dipoles to be a surface.
constexpr double step = 1.5;
constexpr double closed_below = 0.035;
constexpr double nearly_closed_below = 0.12;
constexpr double told_apart = 0.2;
constexpr double least_volume = 3e-4;

struct Dipoles {
    geometry::VecArray position;
    geometry::VecArray moment;
};

[[nodiscard]] double winding_number(const Dipoles& dipoles, const glm::dvec3& at) noexcept {
    double sum = 0.0;
    for (std::int64_t i = 0; i < dipoles.position.size(); ++i) {
        const double x = dipoles.position.x[i] - at.x;
        const double y = dipoles.position.y[i] - at.y;
        const double z = dipoles.position.z[i] - at.z;
        const double r2 = x * x + y * y + z * z + 1e-12;
        sum += (dipoles.moment.x[i] * x + dipoles.moment.y[i] * y + dipoles.moment.z[i] * z) / (r2 * std::sqrt(r2));
    }
    return sum / sphere;
}

} // namespace

bool Sides::closed() const noexcept { return std::min(along, against) < closed_below; }

bool Sides::nearly_closed() const noexcept { return std::min(along, against) < nearly_closed_below; }

int Sides::outward() const noexcept {
    if (std::abs(along - against) > told_apart) return along < against ? 1 : -1;
    // A thin wall: a step inward leads out of it on the other side.
    if (std::min(along, against) < nearly_closed_below && std::abs(volume) > least_volume) return volume > 0.0 ? 1 : -1;
    return 0;
}

base::Array<double> local_spacing(const base::Runtime& runtime, const geometry::PointTree& tree, const Near& near) {
    base::Array<double> spacing(runtime.memory, tree.size());
    const std::size_t used = std::min<std::size_t>(spacing_ring, static_cast<std::size_t>(near.each()));
    runtime.parallel.for_chunks(tree.size(), 4096, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t at = begin; at < end; ++at) {
            double sum = 0.0;
            for (const std::int32_t other : near.of(at).first(used))
                sum += glm::distance(tree.points()[at], tree.points()[other]);
            spacing[at] = sum / static_cast<double>(used);
        }
    });
    return spacing;
}

double winding_number_at(const geometry::PointTree& tree, const base::Array<double>& spacing,
                         const geometry::VecArray& normal, std::span<const std::int32_t> members,
                         const glm::dvec3& at) noexcept {
    double sum = 0.0;
    for (const std::int32_t place : members) {
        const glm::dvec3 d = tree.points()[place] - at;
        const double r2 = glm::dot(d, d) + 1e-12;
        sum += area_share * spacing[place] * spacing[place] * glm::dot(normal[place], d) / (r2 * std::sqrt(r2));
    }
    return sum / sphere;
}

Sides measure_sides(const base::Runtime& runtime, const geometry::PointTree& tree, const base::Array<double>& spacing,
                    const geometry::VecArray& normal, std::span<const std::int32_t> members,
                    const base::Progress& progress) {
    const bool all = members.empty();
    const std::int64_t count = all ? tree.size() : static_cast<std::int64_t>(members.size());
    const auto place = [&](std::int64_t k) -> std::int64_t { return all ? k : members[static_cast<std::size_t>(k)]; };
    Dipoles dipoles{geometry::VecArray(runtime.memory, count), geometry::VecArray(runtime.memory, count)};
    geometry::Bounds bounds;
    double area = 0.0;
    for (std::int64_t k = 0; k < count; ++k) {
        const std::int64_t at = place(k);
        const double own = area_share * spacing[at] * spacing[at];
        dipoles.position.set(k, tree.points()[at]);
        dipoles.moment.set(k, own * normal[at]);
        bounds.extend(tree.points()[at]);
        area += own;
    }
    Sides sides;
    double volume = 0.0;
    for (std::int64_t k = 0; k < count; ++k)
        volume += glm::dot(dipoles.position[k] - bounds.centre(), dipoles.moment[k]) / 3.0;
    sides.volume = volume / std::max(area * bounds.diagonal(), 1e-300);
    const std::int64_t used = std::min(probes, count);
    base::Array<double> number(runtime.memory, 2 * used);
    runtime.parallel.for_each(2 * used, [&](std::int64_t i) {
        progress.check();
        const std::int64_t at = place((i / 2) * count / used);
        const double way = (i % 2 == 0 ? step : -step) * spacing[at];
        number[i] = std::abs(winding_number(dipoles, tree.points()[at] + way * normal[at]));
    });
    sides.along = 0.0;
    sides.against = 0.0;
    for (std::int64_t i = 0; i < used; ++i) {
        sides.along += std::min(number[2 * i], 1.5) / static_cast<double>(used);
        sides.against += std::min(number[2 * i + 1], 1.5) / static_cast<double>(used);
    }
    return sides;
}

} // namespace hrbfnpr::orient
