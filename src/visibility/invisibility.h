// SPDX-License-Identifier: MIT
// Finds how many sheets of surface are before each part of each line: its quantitative invisibility. [Appel 1967;
// Benard & Hertzmann 2019, 4]
#pragma once

#include "base/list.h"
#include "visibility/image_lines.h"

#include <limits>
#include <memory>

namespace hrbfnpr::visibility {

// The value of Event::near_piece at a place where the line passes through a surface. It is no valid index of a piece.
inline constexpr std::int32_t no_line = std::numeric_limits<std::int32_t>::max();

// A place where the number of sheets before a line changes.
struct Event {
    std::int32_t piece;
    double share;
    std::int32_t change;
    // The piece that crosses in front of the line. -1: the event is a cusp. no_line: the line passes through a surface.
    std::int32_t near_piece;
    double at;               // position along the line, in pixels
    float sine = 0.0F;       // the sine of the angle between the images of the two lines; 0 if no line crosses
    double near_share = 0.5; // the position on the nearer piece
};

// The events of all lines, line by line, in order along each line.
struct Events {
    explicit Events(base::Memory& memory) noexcept : first(memory), event(memory) {}

    [[nodiscard]] std::span<const Event> of(std::int64_t line) const noexcept {
        return event.span().subspan(static_cast<std::size_t>(first[line]),
                                    static_cast<std::size_t>(first[line + 1] - first[line]));
    }

    base::Array<std::int64_t> first; // for each line: the index of its first event; at the end, the number of events
    base::Array<Event> event;
    std::int64_t cusps = 0;
};

// Collects the events of all lines. Crossings and piercings must have the order of the results of find_crossings() and
// find_piercings().
[[nodiscard]] Events collect_events(base::Memory& memory, std::span<const Subject> subjects, const ImageLines& lines,
                                    const base::Array<Crossing>& crossings, std::span<const Piercing> pierced,
                                    const LineLengths& lengths);

// Returns the events of a line without torn groups of cusps. The cusps of a group are at most `size` pixels apart. A
// group is torn if its changes do not add up, because a crossing of its branches was missed or found twice. From a torn
// group, all crossings and cusps are removed, except one cusp if their number is odd.
[[nodiscard]] base::Array<Event> without_torn_swallowtails(base::Memory& memory, const Line& line,
                                                           const LineLengths& lengths, double size,
                                                           std::span<const Event> events);

// A part of a line between two events, or a whole line.
struct Interval {
    std::int32_t line;
    std::int32_t begin_piece, end_piece;
    double begin_share, end_share;
    // Positions along the line, in pixels. On a closed line, an interval may end beyond the end of the line.
    double begin_at, end_at;
    std::int32_t invisibility; // the number of sheets before the interval
    bool begins_at_cusp, ends_at_cusp;
    // The sine of the angle to the nearer line that crosses at this end of the interval; 0 if no line crosses.
    float begin_sine, end_sine;
    // The index of the occluder whose surface is nearest before the interval, or -1. find_hidden_by() sets it.
    std::int32_t hidden_by = -1;
};

struct InvisibilityReport {
    CrossingReport crossings;
    std::int64_t lines = 0, closed = 0, cusps = 0, rays = 0;
    std::int64_t rounds = 0;  // the number of rounds in which curves were made finer
    std::int64_t refined = 0; // the number of lines whose counts were contradictory at first
    // The number of lines whose counts are still contradictory in the last round. On these lines, a ray to each part
    // counts the sheets before the part.
    std::int64_t settled = 0;
    std::int64_t contradictions = 0; // the number of settled lines that have a part with an uncertain ray
};

struct InvisibilitySettings {
    double tolerance = 0.05; // the largest distance between the image and the curves in the first round, in pixels
    int rounds = 3;          // the largest number of rounds; each round is ten times finer
    int probes = 3;          // the number of rays for each line
};

struct Invisibility {
    explicit Invisibility(base::Memory& memory) noexcept
        : subjects(memory), finer(memory), lines(memory), intervals(memory), crossings(memory), piercings(memory) {}

    base::Array<Subject> subjects;                     // the given subjects, except that some curves were made finer
    base::List<std::unique_ptr<curves::Curves>> finer; // the finer curves; a subject refers to its finest ones
    ImageLines lines;
    base::Array<Interval> intervals; // the intervals of all lines, line by line and in order along each line
    base::Array<Crossing> crossings;
    base::Array<Piercing> piercings;
    InvisibilityReport report;
};

// Counts the sheets before all lines. The result has the same bits for any number of threads. The results of the
// functions below have the same property.
[[nodiscard]] Invisibility find_invisibility(const base::Work& work, std::span<const Subject> subjects,
                                             std::span<const Occluder> occluders, const InvisibilitySettings& settings);

// Sets Interval::hidden_by. If there are several occluders, it casts a ray to each hidden part.
void find_hidden_by(const base::Work& work, std::span<const Subject> subjects, std::span<const Occluder> occluders,
                    Invisibility& found);

// A part of a line between two positions along it, in pixels.
struct OutlinePart {
    std::int32_t line;
    double begin_at, end_at; // On a closed line, a part may end beyond the end of the line.
};

struct Outline {
    explicit Outline(base::Memory& memory) noexcept : parts(memory) {}

    // The parts, line by line and in order along each line. On a closed line, the first part starts where the line's
    // first interval starts.
    base::Array<OutlinePart> parts;
    std::int64_t rays = 0;
    // The number of lines whose counts are contradictory. On these lines, a ray to each part finds the number of
    // sheets.
    std::int64_t settled = 0;
};

// Finds the parts of contours and borders that are the outline of the drawing, its silhouette in the strict sense:
// beside these parts, on the side where their surface ends, the image shows only background. The number of sheets
// beside a line changes only where it crosses another line that begins or ends sheets, whichever of the two is nearer;
// it does not change at the line's own cusps. [Benard & Hertzmann 2019, 4] `wanted` is 1 for each subject to examine.
[[nodiscard]] Outline find_outline(const base::Work& work, std::span<const Subject> subjects,
                                   std::span<const Occluder> occluders, const Invisibility& found,
                                   const LineLengths& lengths, std::span<const std::uint8_t> wanted);

} // namespace hrbfnpr::visibility
