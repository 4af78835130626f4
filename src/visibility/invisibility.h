// SPDX-License-Identifier: MIT
// How many sheets of surface lie before each part of each line: its quantitative invisibility.
// [Appel 1967; Benard & Hertzmann 2019, 4]
#pragma once

#include "base/list.h"
#include "visibility/image_lines.h"

#include <limits>
#include <memory>

namespace hrbfnpr::visibility {

// The value of Event::near_piece where the line passes through a surface. No piece has this number.
inline constexpr std::int32_t no_line = std::numeric_limits<std::int32_t>::max();

// A place where the number of sheets before a line changes.
struct Event {
    std::int32_t piece;
    double share;
    std::int32_t change;
    // The piece that crosses in front of the line; -1: a cusp; no_line: the line passes through a surface.
    std::int32_t near_piece;
    double at;               // along the event's line, pixels
    float sine = 0.0F;       // the sine of the angle between the images of both lines; 0 where no line crosses
    double near_share = 0.5; // along the nearer piece
};

// The events of all lines, line by line, and in order along each line.
struct Events {
    explicit Events(base::Memory& memory) noexcept : first(memory), event(memory) {}

    [[nodiscard]] std::span<const Event> of(std::int64_t line) const noexcept {
        return event.span().subspan(static_cast<std::size_t>(first[line]),
                                    static_cast<std::size_t>(first[line + 1] - first[line]));
    }

    base::Array<std::int64_t> first; // the first event of each line, then the number of events
    base::Array<Event> event;
    std::int64_t cusps = 0;
};

// Crossings and piercings must be sorted in the order in which find_crossings() and find_piercings() return them.
[[nodiscard]] Events collect_events(base::Memory& memory, std::span<const Subject> subjects, const ImageLines& lines,
                                    const base::Array<Crossing>& crossings, std::span<const Piercing> pierced,
                                    const LineLengths& lengths);

// Returns the events of a line without torn groups of cusps. A group is cusps at most `size` pixels apart, and it is
// torn if its changes do not add up, because a crossing of its branches was missed or doubled. A torn group loses its
// crossings and its cusps, but keeps one cusp if their number is odd.
[[nodiscard]] base::Array<Event> without_torn_swallowtails(base::Memory& memory, const Line& line,
                                                           const LineLengths& lengths, double size,
                                                           std::span<const Event> events);

// A part of a line between two events, or all of it.
struct Interval {
    std::int32_t line;
    std::int32_t begin_piece, end_piece;
    double begin_share, end_share;
    double begin_at, end_at;   // along the line, pixels; an interval that goes round a closed line may end beyond the
                               // line's end
    std::int32_t invisibility; // the number of sheets before it
    bool begins_at_cusp, ends_at_cusp;
    float begin_sine, end_sine; // the sine of the angle to the nearer line that crosses there; 0: no line does
    // The occluder of the nearest surface before the part; find_hidden_by() sets it. -1: none.
    std::int32_t hidden_by = -1;
};

struct InvisibilityReport {
    CrossingReport crossings;
    std::int64_t lines = 0, closed = 0, cusps = 0, rays = 0;
    std::int64_t rounds = 0;  // rounds in which the curves were made finer
    std::int64_t refined = 0; // lines that contradicted themselves at first
    // Lines that contradict themselves at the end: each of their parts gets the number that a ray to the part finds.
    std::int64_t settled = 0;
    std::int64_t contradictions = 0; // settled lines with a part whose ray is not certain
};

struct InvisibilitySettings {
    double tolerance = 0.05; // the largest distance of the first round's image from the curves, pixels
    int rounds = 3;          // the image is made at most this often, each time ten times finer
    int probes = 3;          // rays for each line
};

struct Invisibility {
    explicit Invisibility(base::Memory& memory) noexcept
        : subjects(memory), finer(memory), lines(memory), intervals(memory), crossings(memory), piercings(memory) {}

    base::Array<Subject> subjects;                     // as given, except for curves that had to be made finer
    base::List<std::unique_ptr<curves::Curves>> finer; // the finer curves; a subject refers to its last ones
    ImageLines lines;
    base::Array<Interval> intervals; // line by line, along it
    base::Array<Crossing> crossings;
    base::Array<Piercing> piercings;
    InvisibilityReport report;
};

// Counts the sheets before all lines. Gives the same bits for any number of threads, as do the functions below.
[[nodiscard]] Invisibility find_invisibility(const base::Work& work, std::span<const Subject> subjects,
                                             std::span<const Occluder> occluders, const InvisibilitySettings& settings);

// Sets Interval::hidden_by. Each hidden part gets a ray, unless there is only one occluder.
void find_hidden_by(const base::Work& work, std::span<const Subject> subjects, std::span<const Occluder> occluders,
                    Invisibility& found);

// A part of a line from one place along it to another, pixels.
struct OutlinePart {
    std::int32_t line;
    double begin_at, end_at; // a part that goes round a closed line may end beyond the line's end
};

struct Outline {
    explicit Outline(base::Memory& memory) noexcept : parts(memory) {}

    // Line by line, along each line; the parts of a closed line start where its intervals do.
    base::Array<OutlinePart> parts;
    std::int64_t rays = 0;
    // Lines whose counts contradict themselves: each of their parts gets the number that a ray to the part finds.
    std::int64_t settled = 0;
};

// Finds the parts of contours and borders that are the outline of the drawing, its silhouette in the strict sense: the
// image has nothing beside them on the side where their surface ends. The number of sheets beside a line changes only
// where it crosses another line that begins or ends sheets, whichever of the two is nearer; it does not change at the
// line's own cusps. [Benard & Hertzmann 2019, 4] `wanted` is 1 for subjects whose lines are asked for.
[[nodiscard]] Outline find_outline(const base::Work& work, std::span<const Subject> subjects,
                                   std::span<const Occluder> occluders, const Invisibility& found,
                                   const LineLengths& lengths, std::span<const std::uint8_t> wanted);

} // namespace hrbfnpr::visibility
