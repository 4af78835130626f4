// SPDX-License-Identifier: MIT
#include "curves/level_roots.h"

namespace hrbfnpr::curves {

std::int64_t halve(const base::Runtime& runtime, const Level& level, const base::Array<Straddle>& places, int halvings,
                   base::Array<CurvePoint>& points, const base::Progress& progress) {
    base::Array<Straddle> between(runtime.memory);
    for (const Straddle& place : places) between.push_back(place);
    points.resize(places.size());
    for (int step = 0; step < halvings; ++step) {
        for (std::int64_t i = 0; i < places.size(); ++i)
            points[i].position = 0.5 * (between[i].negative + between[i].positive);
        // The middle of a chord is off the surface by the square of its length: one step leaves the fourth power.  One
        // that is longer than half of the chord leads elsewhere, as where f hardly rises, or has a crease.
        evaluate(runtime, level, points, progress);
        for (std::int64_t i = 0; i < places.size(); ++i) {
            const glm::dvec3 middle = points[i].position;
            step_to_surface(points[i]);
            const double most = 0.5 * glm::distance(between[i].negative, between[i].positive);
            if (!(glm::distance(points[i].position, middle) <= most)) points[i].position = middle;
        }
        evaluate(runtime, level, points, progress);
        for (std::int64_t i = 0; i < places.size(); ++i)
            (points[i].level < 0.0 ? between[i].negative : between[i].positive) = points[i].position;
    }
    return std::int64_t{2} * halvings * places.size();
}

} // namespace hrbfnpr::curves
