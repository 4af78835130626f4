// SPDX-License-Identifier: MIT
#include "curves/sheet_count.h"

#include "base/list.h"
#include "curves/near_spans.h"
#include "curves/supported_roots.h"

#include <algorithm>

namespace hrbfnpr::curves {
namespace {

constexpr std::int64_t segments_a_task = 16; // segments of a task

void append(Spans& all, const Spans& some) {
    for (const Span& span : some.span) all.span.push_back(span);
    for (const double place : some.place) all.place.push_back(place);
}

// Between two spans of a line there is no surface; nor a root of f, unless the surface ends before f does.
void compare(const Spans& spans, const base::Array<RootCount>& count, bool ends,
             base::Array<SheetCounter::Answer>& answer) {
    for (std::int64_t i = 0; i < spans.span.size(); ++i) {
        const Span& span = spans.span[i];
        SheetCounter::Answer& of = answer[span.line];
        of.sheets += count[i].roots;
        const bool beside_end = span.line_begins || span.line_ends;
        const bool jumps = !ends && i > 0 && spans.span[i - 1].line == span.line &&
                           count[i - 1].negative_at_end != count[i].negative_at_begin;
        if (!count[i].certain || jumps || (!beside_end && count[i].roots != span.crossings)) of.certain = false;
    }
}

} // namespace

void SheetCounter::count(const base::Runtime& runtime, const implicit::Implicit& implicit,
                         const geometry::VecArray& from, const geometry::VecArray& to, const base::Array<double>& clear,
                         base::Array<Answer>& answer, const base::Progress& progress) const {
    const std::int64_t segments = from.size();
    base::Array<Line> lines(runtime.memory, segments);
    base::List<Spans> found(runtime.memory);
    found.reserve((segments + segments_a_task - 1) / segments_a_task);
    for (std::int64_t k = 0; k < segments; k += segments_a_task) found.add(runtime.memory);
    runtime.parallel.for_chunks(segments, segments_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        SpanFinder finder(mesh_, tree_, runtime.memory);
        for (std::int64_t i = begin; i < end; ++i) {
            lines[i] = Line(mesh_.region, from[i], to[i], clear[i]);
            finder.find(lines[i], i, found[begin / segments_a_task]);
        }
    });
    Spans spans(runtime.memory);
    for (const Spans& some : found) append(spans, some);
    base::Array<RootCount> counts(runtime.memory);
    base::Array<Root> roots(runtime.memory);
    const SurfaceEnd* const end = mesh_.end;
    count_roots(runtime, implicit, lines, spans, counts, &roots, progress);
    if (end != nullptr) drop_unsupported(runtime, implicit, *end, lines, spans, roots, counts, progress);
    answer.resize(segments);
    std::fill(answer.begin(), answer.end(), Answer{});
    compare(spans, counts, end != nullptr, answer);
    base::Array<std::uint8_t> known(runtime.memory, segments);
    for (const Root& root : roots) {
        const std::int64_t line = spans.span[root.span].line;
        Answer& of = answer[line];
        of.nearest = known[line] != 0 ? std::min(of.nearest, root.at) : root.at;
        known[line] = 1;
    }
    progress.update(1.0);
}

} // namespace hrbfnpr::curves
