// SPDX-License-Identifier: MIT
// Looks at places from the eye, one ray for each place, to prove which lines are visible. The rays use nothing of what
// find_invisibility() uses: no mesh, crossings, cusps or counts. They only evaluate f.
#pragma once

#include "base/memory.h"
#include "base/work.h"
#include "visibility/image_lines.h"

#include <cstdint>
#include <limits>
#include <span>

namespace hrbfnpr::visibility {

enum class Seen : std::uint8_t { visible, hidden, undecided };

// Stands for each occluder whose surface is near a place.
inline constexpr std::int32_t any_item = -1;

// A place on a line, in the world.
struct SightPlace {
    glm::dvec3 place;
    std::int32_t item; // the occluder on whose surface the place lies, or any_item
    // A surface decides only if the ray passes through it, or passes by it, at more than this distance from its
    // outline, in world units.
    double margin;
    // If the place is inside the solid of its own occluder by at most this, it is moved out, in world units.
    double lift = 0.0;
    // The ray ends at this distance from the place, in world units.
    double reach = std::numeric_limits<double>::infinity();
    bool is_cut = false; // whether solids are cut where the ray ends, so that a ray that ends inside one is hidden
};

struct Sighting {
    Seen seen = Seen::visible;
    // True if the ray of a visible place runs inside the solid before it leaves the surface, so shallowly that it may
    // be an error of the place. Such a ray cannot prove that a hidden line is visible.
    bool grazes = false;
    std::int32_t hidden_by = -1; // the index of an occluder that hides the place, or -1
};

// Looks at all places. Each result is the same bits, whatever other places there are. Throws like
// Implicit::evaluate().
[[nodiscard]] base::Array<Sighting> look_at(const base::Work& work, std::span<const Occluder> occluders,
                                            std::span<const SightPlace> places);

} // namespace hrbfnpr::visibility
