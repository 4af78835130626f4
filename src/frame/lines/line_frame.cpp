// SPDX-License-Identifier: MIT
#include "frame/lines/line_frame.h"

#include "base/clock.h"
#include "visibility/hidden_by.h"

#include <glm/matrix.hpp>

#include <algorithm>

namespace hrbfnpr::frame {
namespace {

// Shares of the time.
constexpr double traced_end = 0.4;
constexpr double found_end = 0.8;
constexpr double hidden_end = 0.9;

bool draws_lines(const Item& item) noexcept { return item.lines != nullptr && !item.style.lines.empty(); }

void count(const visibility::Invisibility& found, const TracedLines& traced, drawing::LineCounts& counts) noexcept {
    counts.curves = found.report.lines;
    counts.cusps = found.report.cusps;
    counts.crossings = found.crossings.size();
    counts.broken = traced.broken();
    counts.refined = found.report.refined;
    counts.settled = found.report.settled;
    counts.contradictions = found.report.contradictions;
    counts.tangles = found.report.crossings.tangles;
}

base::Array<LineFamily> families(base::Memory& memory, std::span<const visibility::Subject> subjects,
                                 std::span<const visibility::Occluder> occluders) {
    base::Array<LineFamily> found(memory);
    base::Array<std::int64_t> of_item(memory, static_cast<std::int64_t>(occluders.size()));
    for (const visibility::Subject& subject : subjects)
        found.push_back(
            {occluders[static_cast<std::size_t>(subject.item)].sheets, subject.item, of_item[subject.item]++});
    return found;
}

} // namespace

LineFrame::Found LineFrame::find(const Scene& scene, std::span<const Item> items, const base::Progress& progress,
                                 drawing::Drawing& drawing) {
    auto traced =
        std::make_unique<TracedLines>(runtime_, scene, items, contours_, progress.part(0.0, traced_end), drawing);
    visibility::Invisibility seen = visibility::find_invisibility(runtime_, traced->subjects(), traced->occluders(), {},
                                                                  progress.part(traced_end, 1.0).standing());
    return {std::move(traced), std::move(seen)};
}

const LineStrokes& LineFrame::run(const Scene& scene, std::span<const Item> items, const base::Progress& progress,
                                  drawing::Drawing& drawing) {
    strokes_.strokes.clear();
    strokes_.points.clear();
    if (std::none_of(items.begin(), items.end(), draws_lines)) return strokes_;
    const base::Stopwatch watch;
    contours_.begin_frame();
    const std::int64_t layers = drawing.layers.size();
    Found all = find(scene, items, progress.part(0.0, found_end), drawing);
    // Contours that are whole may still be too coarse, or doubled, where they began with those of the last frame.
    if (all.seen.report.settled > 0 && contours_.are_from_last()) {
        contours_.forget();
        drawing.layers.resize(layers);
        all = find(scene, items, progress.part(0.0, found_end), drawing);
    }
    const TracedLines& traced = *all.traced;
    visibility::Invisibility& found = all.seen;
    visibility::find_hidden_by(runtime_, found.subjects.span(), traced.occluders(), found,
                               progress.part(found_end, hidden_end).standing());
    count(found, traced, drawing.line_counts);
    const visibility::Lengths lengths(runtime_.memory, found.lines);
    numbers_.run(families(runtime_.memory, found.subjects.span(), traced.occluders()).span(), found.subjects.span(),
                 found.lines);
    const LineInput input{
        found.subjects.span(), traced.occluders(), traced.items(), traced.styles(), found, lengths, numbers_};
    progress.update(hidden_end);
    const WidthLaws laws(runtime_, scene, drawing, input, progress.part(hidden_end, 1.0));
    StrokeParts(runtime_, scene, input, laws, strokes_).run();
    progress.update(1.0);
    drawing.line_counts.nanoseconds = watch.nanoseconds();
    return strokes_;
}

} // namespace hrbfnpr::frame
