// SPDX-License-Identifier: MIT
#include "visibility/probes.h"

#include <glm/matrix.hpp>

#include <algorithm>

namespace hrbfnpr::visibility {
namespace {

// Where a ray to `place` begins: the eye, or for a direction a place before all of the surface.
glm::dvec3 begin_of(const Occluder& occluder, const glm::dvec3& place) noexcept {
    if (occluder.eye.w != 0.0) return glm::dvec3(occluder.eye);
    const geometry::Bounds& bounds = occluder.surface->bounds();
    const double reach = glm::distance(bounds.centre(), place) + 2.0 * occluder.surface->diagonal();
    return place - reach * glm::normalize(glm::dvec3(occluder.eye));
}

// What each occluder says of rays to the probes, one after the other: visit(occluder, answers, ray's directions).
template <class Visit>
void ask_all(const base::Runtime& runtime, std::span<const Subject> subjects, std::span<const Occluder> occluders,
             const base::Array<Probe>& probes, const base::Progress& progress, Visit&& visit) {
    geometry::VecArray from(runtime.memory, probes.size());
    geometry::VecArray to(runtime.memory, probes.size());
    base::Array<double> clear(runtime.memory, probes.size());
    base::Array<curves::SheetCounter::Answer> answers(runtime.memory);
    for (std::size_t o = 0; o < occluders.size(); ++o) {
        const Occluder& occluder = occluders[o];
        const glm::dmat4 from_world = glm::inverse(occluder.to_world);
        for (std::int64_t i = 0; i < probes.size(); ++i) {
            const Subject& subject = subjects[static_cast<std::size_t>(probes[i].subject)];
            const bool own = static_cast<std::size_t>(subject.item) == o;
            const glm::dvec3 place =
                own ? probes[i].place : glm::dvec3(from_world * (subject.to_world * glm::dvec4(probes[i].place, 1.0)));
            from.set(i, begin_of(occluder, place));
            to.set(i, place);
            clear[i] = own ? probes[i].clear : 0.0;
        }
        occluder.sheets->count(runtime, *occluder.surface, from, to, clear, answers, progress);
        for (std::int64_t i = 0; i < probes.size(); ++i) visit(o, i, answers[i], from[i] - to[i]);
    }
}

} // namespace

void find_nearest(const base::Runtime& runtime, std::span<const Subject> subjects, std::span<const Occluder> occluders,
                  const base::Array<Probe>& probes, base::Array<std::int32_t>& nearest,
                  const base::Progress& progress) {
    nearest.resize(probes.size());
    std::fill(nearest.begin(), nearest.end(), -1);
    base::Array<double> least(runtime.memory, probes.size()); // in the world
    ask_all(runtime, subjects, occluders, probes, progress,
            [&](std::size_t o, std::int64_t i, const curves::SheetCounter::Answer& answer, const glm::dvec3& way) {
                if (answer.sheets <= 0) return;
                const double unit = glm::length(glm::dmat3(occluders[o].to_world) * glm::normalize(way));
                if (nearest[i] >= 0 && answer.nearest * unit >= least[i]) return;
                nearest[i] = static_cast<std::int32_t>(o);
                least[i] = answer.nearest * unit;
            });
}

void send_rays(const base::Runtime& runtime, std::span<const Subject> subjects, std::span<const Occluder> occluders,
               base::Array<Probe>& probes, const base::Progress& progress) {
    for (Probe& probe : probes) {
        probe.sheets = 0;
        probe.certain = true;
    }
    ask_all(runtime, subjects, occluders, probes, progress,
            [&](std::size_t, std::int64_t i, const curves::SheetCounter::Answer& answer, const glm::dvec3&) {
                probes[i].sheets += answer.sheets;
                probes[i].certain = probes[i].certain && answer.certain;
            });
}

} // namespace hrbfnpr::visibility
