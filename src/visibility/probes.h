// SPDX-License-Identifier: MIT
// Places of lines that rays are sent to: how many sheets lie before them.
#pragma once

#include "visibility/image_lines.h"

namespace hrbfnpr::visibility {

struct Probe {
    std::int32_t subject;
    glm::dvec3 place;    // in the subject's coordinates, on its surface
    double clear;        // of what is nearer to it is not counted, in its coordinates
    std::int32_t sheets; // out
    bool certain;        // out
};

// Which occluder's surface is the nearest before each; -1: none.  nearest: resized.
void find_nearest(const base::Runtime& runtime, std::span<const Subject> subjects, std::span<const Occluder> occluders,
                  const base::Array<Probe>& probes, base::Array<std::int32_t>& nearest, const base::Progress& progress);

// Counts the sheets of all occluders before each.
void send_rays(const base::Runtime& runtime, std::span<const Subject> subjects, std::span<const Occluder> occluders,
               base::Array<Probe>& probes, const base::Progress& progress);

} // namespace hrbfnpr::visibility
