// SPDX-License-Identifier: MIT
#include "surface/project_creases.h"

#include "surface/sheets_meet.h"

#include <cmath>

namespace hrbfnpr::surface {
namespace {

constexpr int most_steps = 30;
constexpr std::int64_t grain = 64;

class CreaseProjector {
public:
    CreaseProjector(const implicit::Implicit& implicit, const ProjectionSettings& settings) noexcept
        : implicit_(implicit), sheets_(*implicit.sheets()), tolerance_(settings.tolerance * implicit.diagonal()) {}

    // Returns whether the surface was reached. It first searches where sheets meet. If this fails, it moves from one
    // sheet to the next, which helps if the first sheets are parallel.
    [[nodiscard]] bool run(const glm::dvec3& from) { return run(from, true) || run(from, false); }

    glm::dvec3 place{0.0}, gradient{0.0};

private:
    [[nodiscard]] bool run(const glm::dvec3& from, bool together) {
        const double longest = implicit_.diagonal() + glm::distance(from, implicit_.bounds().centre());
        place = from;
        Meeting meeting;
        meeting.add(active_at(sheets_, place));
        for (int step = 0; step < most_steps; ++step) {
            std::array<SheetValue, 3> at;
            for (std::size_t k = 0; k < meeting.count; ++k) at[k] = sheet_at(sheets_, meeting.sheet[k], place);
            const glm::dvec3 way = step_to_zero(std::span<const SheetValue>(at).first(meeting.count));
            if (!(glm::distance(place + way, from) <= longest)) return false;
            place += way;
            const SheetValue now = value();
            const double slope = glm::length(now.gradient);
            gradient = now.gradient;
            if (std::isfinite(now.value) && is_usable_slope(slope) && std::abs(now.value) <= tolerance_ * slope)
                return true;
            if (const std::int32_t sheet = active_at(sheets_, place); !meeting.has(sheet)) {
                if (!together) meeting.count = 0;
                meeting.add(sheet);
            }
        }
        return false;
    }
    [[nodiscard]] SheetValue value() const {
        SheetValue at;
        implicit_.evaluate({&place.x, &place.y, &place.z, 1},
                           {&at.value, {&at.gradient.x, &at.gradient.y, &at.gradient.z}, {}});
        return at;
    }

    const implicit::Implicit& implicit_;
    const implicit::Sheets& sheets_;
    double tolerance_;
};

} // namespace

void project_onto_creases(const base::Work& work, const implicit::Implicit& implicit,
                          const ProjectionSettings& settings, Projection& points) {
    base::Array<std::int64_t> left(work.memory);
    for (std::int64_t i = 0; i < points.status.size(); ++i)
        if (points.status[i] == ProjectionStatus::not_converged) left.push_back(i);
    implicit.threads(work).for_chunks(left.size(), grain, [&](std::int64_t begin, std::int64_t end) {
        CreaseProjector projector(implicit, settings);
        for (std::int64_t k = begin; k < end; ++k) {
            const std::int64_t i = left[k];
            if (!projector.run(points.position[i])) continue;
            points.position.set(i, projector.place);
            points.gradient.set(i, projector.gradient);
            points.status[i] = ProjectionStatus::converged;
        }
    });
}

} // namespace hrbfnpr::surface
