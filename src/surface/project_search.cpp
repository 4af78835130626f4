// SPDX-License-Identifier: MIT
#include "surface/project_search.h"

#include "surface/region.h"
#include "surface/sheets_meet.h"

#include <array>
#include <cmath>
#include <numbers>

namespace hrbfnpr::surface {
namespace {

constexpr std::size_t directions = 64;
constexpr double growth = 1.25;   // ratio of the radii of consecutive spheres
constexpr double smallest = 2e-3; // radius of the first sphere, in diagonals
constexpr int most_halvings = 80;
constexpr std::int64_t searches_a_task = 8;

// Returns direction i. The directions are spread evenly by the golden angle.
glm::dvec3 direction(std::size_t i) noexcept {
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(directions);
    const double across = std::sqrt(1.0 - z * z);
    const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0)) * static_cast<double>(i);
    return {across * std::cos(turn), across * std::sin(turn), z};
}

class SearchProjector {
public:
    SearchProjector(const implicit::Implicit& implicit, const ProjectionSettings& settings) noexcept
        : implicit_(implicit), region_(search_region(implicit)), tolerance_(settings.tolerance * implicit.diagonal()) {
        for (std::size_t i = 0; i < directions; ++i) directions_[i] = direction(i);
    }

    [[nodiscard]] bool run(const glm::dvec3& from, const base::Progress& progress) {
        const SheetValue here = value(from);
        if (!std::isfinite(here.value)) return false;
        const double farthest = glm::length(glm::max(glm::abs(from - region_.min), glm::abs(region_.max - from)));
        // f has the same sign everywhere within the distance |f| / lipschitz.
        const double bound = implicit_.lipschitz();
        double radius = smallest * implicit_.diagonal();
        if (bound > 0.0) radius = std::max(radius, std::abs(here.value) / bound);
        for (; radius < growth * farthest; radius *= growth) {
            progress.check();
            glm::dvec3 other;
            if (find(from, here.value < 0.0, radius, other)) return bisect(from, other, here.value < 0.0);
        }
        return false;
    }

    glm::dvec3 place{0.0}, gradient{0.0};

private:
    // Finds the first point of the sphere, inside the region, where f has the other sign.
    [[nodiscard]] bool find(const glm::dvec3& from, bool inside, double radius, glm::dvec3& other) {
        std::array<double, directions> x, y, z, f;
        std::size_t count = 0;
        for (const glm::dvec3& way : directions_) {
            const glm::dvec3 p = from + radius * way;
            if (!region_.contains(p)) continue;
            x[count] = p.x;
            y[count] = p.y;
            z[count++] = p.z;
        }
        if (count == 0) return false;
        implicit::FieldBatch fields;
        fields.value = f.data();
        implicit_.evaluate({x.data(), y.data(), z.data(), static_cast<std::int64_t>(count)}, fields);
        for (std::size_t i = 0; i < count; ++i)
            if (std::isfinite(f[i]) && (f[i] < 0.0) != inside) {
                other = {x[i], y[i], z[i]};
                return true;
            }
        return false;
    }
    [[nodiscard]] bool bisect(glm::dvec3 same, glm::dvec3 other, bool inside) {
        for (int k = 0; k < most_halvings; ++k) {
            place = 0.5 * (same + other);
            const SheetValue at = value(place);
            const double slope = glm::length(at.gradient);
            gradient = at.gradient;
            if (!std::isfinite(at.value)) return false;
            if (is_usable_slope(slope) && std::abs(at.value) <= tolerance_ * slope) return true;
            ((at.value < 0.0) == inside ? same : other) = place;
        }
        return false;
    }
    [[nodiscard]] SheetValue value(const glm::dvec3& p) const {
        SheetValue at;
        implicit_.evaluate({&p.x, &p.y, &p.z, 1}, {&at.value, {&at.gradient.x, &at.gradient.y, &at.gradient.z}, {}});
        return at;
    }

    const implicit::Implicit& implicit_;
    geometry::Bounds region_;
    double tolerance_;
    std::array<glm::dvec3, directions> directions_;
};

} // namespace

void project_by_search(const base::Work& work, const implicit::Implicit& implicit, const ProjectionSettings& settings,
                       Projection& points) {
    base::Array<std::int64_t> left(work.memory);
    for (std::int64_t i = 0; i < points.status.size(); ++i)
        if (points.status[i] == ProjectionStatus::not_converged || points.status[i] == ProjectionStatus::zero_gradient)
            left.push_back(i);
    implicit.threads(work).for_chunks(left.size(), searches_a_task, [&](std::int64_t begin, std::int64_t end) {
        SearchProjector projector(implicit, settings);
        for (std::int64_t k = begin; k < end; ++k) {
            const std::int64_t i = left[k];
            if (!projector.run(points.position[i], work)) continue;
            points.position.set(i, projector.place);
            points.gradient.set(i, projector.gradient);
            points.status[i] = ProjectionStatus::converged;
        }
    });
}

} // namespace hrbfnpr::surface
