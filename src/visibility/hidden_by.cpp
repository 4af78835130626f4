// SPDX-License-Identifier: MIT
#include "visibility/hidden_by.h"

#include "visibility/probes.h"

#include <glm/matrix.hpp>

#include <cmath>

namespace hrbfnpr::visibility {
namespace {

// The piece that a place of a line is on; `at` along the line, pixels.
glm::dvec3 place_at(std::span<const Subject> subjects, const ImageLines& lines, const Lengths& lengths,
                    const Line& line, double at) noexcept {
    std::int64_t low = line.first_piece;
    std::int64_t high = line.first_piece + line.pieces; // begins beyond `at`
    while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (lengths.at(line, middle, 0.0) <= at ? low : high) = middle;
    }
    const double begin = lengths.at(line, low, 0.0);
    const double length = lengths.at(line, low, 1.0) - begin;
    return cubic(subjects, lines.pieces[low]).at(length > 0.0 ? glm::clamp((at - begin) / length, 0.0, 1.0) : 0.5);
}

} // namespace

void find_hidden_by(const base::Runtime& runtime, std::span<const Subject> subjects,
                    std::span<const Occluder> occluders, Invisibility& found, const base::Progress& progress) {
    const Lengths lengths(runtime.memory, found.lines);
    base::Array<Probe> probes(runtime.memory);
    base::Array<std::int64_t> of(runtime.memory);
    for (std::int64_t i = 0; i < found.intervals.size(); ++i) {
        Interval& part = found.intervals[i];
        const Line& line = found.lines.lines[part.line];
        const Subject& subject = subjects[static_cast<std::size_t>(line.subject)];
        part.hidden_by = part.sheets > 0 ? subject.item : -1;
        if (part.sheets <= 0 || occluders.size() < 2) continue;
        const double middle = std::fmod(0.5 * (part.begin_at + part.end_at), std::max(lengths.whole(line), 1e-300));
        probes.push_back({line.subject, place_at(subjects, found.lines, lengths, line, middle),
                          subject.clear * subject.side, 0, true});
        of.push_back(i);
    }
    base::Array<std::int32_t> nearest(runtime.memory);
    find_nearest(runtime, subjects, occluders, probes, nearest, progress);
    for (std::int64_t k = 0; k < of.size(); ++k)
        if (nearest[k] >= 0) found.intervals[of[k]].hidden_by = nearest[k];
}

} // namespace hrbfnpr::visibility
