// SPDX-License-Identifier: MIT
#include "light/light.h"

#include "base/assert.h"
#include "geometry/tangent_frame.h"
#include "light/tuning.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::light {
namespace {

constexpr std::int64_t shaded_a_task = 1024;

// A lamp as a place sees it.
struct LampDisc {
    glm::dvec3 origin;
    glm::dvec3 towards; // the middle of the disc is at origin + towards
    glm::dvec3 u, v;    // the radii of the disc
    double begin = 0.0; // where rays begin and end, in lengths of `towards`
    double end = 1.0;

    // Returns the end of a ray at a place of the disc, whose radius is 1.
    [[nodiscard]] glm::dvec3 at(double x, double y) const noexcept { return towards + x * u + y * v; }
};

[[nodiscard]] LampDisc disc_of(const Lamp& lamp, const glm::dvec3& place) noexcept {
    LampDisc disc{place, lamp.is_place ? lamp.place - place : lamp.place, {}, {}};
    if (!lamp.is_place) disc.end = std::numeric_limits<double>::infinity();
    const double length = glm::length(disc.towards);
    if (!(length > 0.0)) return disc;
    const glm::dvec3 middle = disc.towards / length;
    disc.u = length * std::tan(lamp.softness) * geometry::any_perpendicular(middle);
    disc.v = glm::cross(middle, disc.u);
    return disc;
}

// Lets rays begin at `offset` above the surface, on the line through the place, so that borders of shadows stay where
// they are. For flat light, the line itself is raised, too, because it leaves the surface too slowly.
void begin_above(double offset, const glm::dvec3& normal, LampDisc& disc) noexcept {
    const double length = glm::length(disc.towards);
    const double cosine = glm::dot(disc.towards, normal) / length;
    const double skipped = std::min(offset / cosine, light_tuning.longest_start * offset);
    disc.begin = std::min(skipped / length, disc.end);
    disc.origin += (offset - skipped * cosine) * normal;
}

[[nodiscard]] float visible_at(const geometry::Bvh& casters, const Lamp& lamp, const Places& places,
                               std::int64_t place) noexcept {
    LampDisc disc = disc_of(lamp, places.position[place]);
    const glm::dvec3 normal = places.normal[place];
    if (!(glm::dot(disc.towards, normal) > 0.0)) return 0.0F;
    begin_above(places.offset, normal, disc);
    const auto is_hidden = [&](double x, double y) {
        return casters.any_hit(disc.origin, disc.at(x, y), disc.begin, disc.end);
    };
    if (lamp.softness == 0.0) return is_hidden(0.0, 0.0) ? 0.0F : 1.0F;
    // The first rays go to the middle of the disc and near its rim.
    const std::int32_t first = light_tuning.first_rays;
    constexpr double turn = 6.283185307179586;
    std::int32_t hidden = is_hidden(0.0, 0.0) ? 1 : 0;
    for (std::int32_t k = 0; k + 1 < first; ++k) {
        const double angle = turn * k / (first - 1);
        hidden += is_hidden(0.95 * std::cos(angle), 0.95 * std::sin(angle)) ? 1 : 0;
    }
    if (hidden == 0) return 1.0F;
    if (hidden == first) return 0.0F;
    constexpr double golden = 2.399963229728653;
    hidden = 0;
    for (std::int32_t k = 0; k < lamp.rays; ++k) {
        const double r = std::sqrt((k + 0.5) / lamp.rays);
        hidden += is_hidden(r * std::cos(golden * k), r * std::sin(golden * k)) ? 1 : 0;
    }
    return 1.0F - static_cast<float>(hidden) / static_cast<float>(lamp.rays);
}

} // namespace

base::Array<float> find_visible(const base::Work& work, const geometry::Bvh& casters, const Places& places,
                                const Lamp& lamp) {
    HRBFNPR_ASSERT(places.position.size() == places.normal.size() && lamp.rays > 0);
    base::Array<float> visible(work.memory, places.position.size());
    work.for_chunks(visible.size(), shaded_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) visible[i] = visible_at(casters, lamp, places, i);
    });
    return visible;
}

} // namespace hrbfnpr::light
