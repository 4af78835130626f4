// SPDX-License-Identifier: MIT
// How many sheets of surface lie before each part of each line: its quantitative invisibility.
// [Appel 1967; Benard & Hertzmann 2019, 4]
#pragma once

#include "base/list.h"
#include "visibility/events.h"

#include <memory>

namespace hrbfnpr::visibility {

// A part of a line between two events, or all of it.
struct Interval {
    std::int32_t line;
    std::int32_t begin_piece, end_piece;
    double begin_share, end_share;
    double begin_at, end_at; // along the line, pixels; the end of one round a closed line may be beyond the line's
    std::int32_t sheets;     // before it
    bool begins_at_cusp, ends_at_cusp;
    float begin_sine, end_sine; // of the angle to the nearer line that crosses there; 0: none does
    std::int32_t hidden_by =
        -1; // occluder of the nearest surface before it, once find_hidden_by() has looked; -1: none
};

struct InvisibilityReport {
    CrossingReport crossings;
    std::int64_t lines = 0, closed = 0, cusps = 0, rays = 0;
    std::int64_t rounds = 0;         // in which the image was made finer
    std::int64_t refined = 0;        // lines that contradicted themselves at first
    std::int64_t settled = 0;        // ... and did at last: each of their parts is as its own ray says
    std::int64_t contradictions = 0; // of these, lines that have a part whose ray is not certain
};

struct InvisibilitySettings {
    double tolerance = 0.05; // of the image that crossings are first looked for in, pixels
    int rounds = 3;          // each ten times finer
    int probes = 3;          // rays a line
};

struct Invisibility {
    explicit Invisibility(base::Memory& memory) noexcept
        : subjects(memory), finer(memory), lines(memory), intervals(memory), crossings(memory), pierced(memory) {}

    base::Array<Subject> subjects;                     // as given, but for curves that had to be finer
    base::List<std::unique_ptr<curves::Curves>> finer; // ... which are these; the last ones count
    ImageLines lines;
    base::Array<Interval> intervals; // line by line, along it
    base::Array<Crossing> crossings;
    base::Array<Pierced> pierced;
    InvisibilityReport report;
};

// The same bits for any thread count.
[[nodiscard]] Invisibility find_invisibility(const base::Runtime& runtime, std::span<const Subject> subjects,
                                             std::span<const Occluder> occluders, const InvisibilitySettings& settings,
                                             const base::Progress& progress);

} // namespace hrbfnpr::visibility
