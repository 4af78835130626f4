// SPDX-License-Identifier: MIT
#include "visibility/probes.h"

#include <glm/matrix.hpp>

namespace hrbfnpr::visibility {
namespace {

// Where a ray to `place` begins: the eye, or for a direction a place before all of the surface.
glm::dvec3 begin_of(const Occluder& occluder, const glm::dvec3& place) noexcept {
    if (occluder.eye.w != 0.0) return glm::dvec3(occluder.eye);
    const geometry::Bounds& bounds = occluder.surface->bounds();
    const double reach = glm::distance(bounds.centre(), place) + 2.0 * occluder.surface->diagonal();
    return place - reach * glm::normalize(glm::dvec3(occluder.eye));
}

} // namespace

void send_rays(const base::Runtime& runtime, std::span<const Subject> subjects, std::span<const Occluder> occluders,
               base::Array<Probe>& probes, const base::Progress& progress) {
    geometry::VecArray from(runtime.memory, probes.size());
    geometry::VecArray to(runtime.memory, probes.size());
    base::Array<double> clear(runtime.memory, probes.size());
    base::Array<curves::SheetCounter::Answer> answers(runtime.memory);
    for (Probe& probe : probes) {
        probe.sheets = 0;
        probe.certain = true;
    }
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
        for (std::int64_t i = 0; i < probes.size(); ++i) {
            probes[i].sheets += answers[i].sheets;
            probes[i].certain = probes[i].certain && answers[i].certain;
        }
    }
}

} // namespace hrbfnpr::visibility
