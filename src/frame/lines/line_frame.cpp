// SPDX-License-Identifier: MIT
// A frame of lines: curves are traced for the camera (trace_lines), sheets before them counted (find_invisibility,
// find_hidden_by), lines numbered as in the last frame (LineNumbers), widths found (WidthLaws) and strokes made
// (add_strokes).
#include "frame/lines/line_frame.h"

#include "base/clock.h"
#include "frame/lines/strokes.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// Shares of the time.
constexpr double traced_end = 0.32;
constexpr double found_end = 0.8;
constexpr double hidden_end = 0.9;

bool draws_lines(const Item& item) noexcept { return item.lines != nullptr && !item.style.lines.empty(); }

void count(const visibility::Invisibility& found, const TracedLines& traced, drawing::LineCounts& counts) noexcept {
    counts.curves = found.report.lines;
    counts.cusps = found.report.cusps;
    counts.crossings = found.crossings.size();
    counts.broken = traced.broken;
    counts.refined = found.report.refined;
    counts.settled = found.report.settled;
    counts.contradictions = found.report.contradictions;
    counts.tangles = found.report.crossings.tangles;
}

} // namespace

const LineStrokes& LineFrame::run(const Scene& scene, std::span<const Item> items, const base::Progress& progress,
                                  drawing::Drawing& drawing) {
    strokes_.strokes.clear();
    strokes_.points.clear();
    if (std::none_of(items.begin(), items.end(), draws_lines)) return strokes_;
    const base::Stopwatch watch;
    contours_.begin_frame();
    const std::int64_t layers = drawing.layers.size();
    const auto trace = [&] {
        return trace_lines(runtime_, scene, items, contours_, progress.part(0.0, traced_end), drawing);
    };
    const auto count_sheets = [&](const TracedLines& lines) {
        return visibility::find_invisibility(runtime_, lines.subjects.span(), lines.occluders.span(), {},
                                             progress.part(traced_end, found_end).standing());
    };
    TracedLines traced = trace();
    visibility::Invisibility found = count_sheets(traced);
    // Contours that are whole may still be too coarse, or doubled, where they began with those of the last frame.
    if (found.report.settled > 0 && contours_.are_from_last()) {
        contours_.forget();
        drawing.layers.resize(layers);
        traced = trace();
        found = count_sheets(traced);
    }
    const std::span<const visibility::Subject> subjects = std::as_const(found.subjects).span();
    const std::span<const visibility::Occluder> occluders = std::as_const(traced.occluders).span();
    visibility::find_hidden_by(runtime_, subjects, occluders, found, progress.part(found_end, hidden_end).standing());
    count(found, traced, drawing.line_counts);
    const visibility::Lengths lengths(runtime_.memory, found.lines);
    numbers_.run(subjects, occluders, found.lines);
    const LineInput input{
        subjects, occluders, std::as_const(traced.items).span(), std::as_const(traced.styles).span(), found,
        lengths,  numbers_};
    progress.update(hidden_end);
    const WidthLaws laws(runtime_, scene, drawing, input, progress.part(hidden_end, 1.0));
    add_strokes(runtime_, scene, input, laws, strokes_);
    progress.update(1.0);
    drawing.line_counts.nanoseconds = watch.nanoseconds();
    return strokes_;
}

} // namespace hrbfnpr::frame
