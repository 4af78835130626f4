// SPDX-License-Identifier: MIT
// A frame of lines: curves are traced for the camera (trace_lines), sheets before them counted (find_invisibility,
// find_hidden_by), lines numbered as in the last frame (number_lines) and strokes made (add_strokes). For its number,
// points of each line vote for the line of the last frame that has the nearest point of the same direction
// (count_votes); lines with most points in common are one.
#include "frame/lines/line_frame.h"

#include "base/assert.h"
#include "base/clock.h"
#include "frame/lines/lines.h"
#include "frame/lines/tuning.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <tuple>
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

// ---- Numbers

// About how many points of a line of this frame are near a line of the last frame.
struct Vote {
    std::int64_t line;
    std::int64_t known;
    std::int64_t points;
};

const curves::CurvePoint& point_of(const base::Array<visibility::Subject>& subjects,
                                   const visibility::ImageLines& lines, std::int64_t piece) noexcept {
    const visibility::Piece& its = lines.pieces[piece];
    return subjects[its.subject].curves->point[its.a];
}

base::Array<Vote> count_votes(const KnownLines& last, const base::Array<LineFamily>& families,
                              const base::Array<visibility::Subject>& subjects, const visibility::ImageLines& lines) {
    base::Memory& memory = families.memory();
    base::Array<Vote> votes(memory);
    base::Array<std::int64_t> of_line(memory, last.line.size());
    for (std::int64_t subject = 0; subject < subjects.size(); ++subject) {
        geometry::VecArray place(memory);
        geometry::VecArray direction(memory);
        base::Array<std::int64_t> owner(memory);
        for (std::int64_t k = 0; k < last.line.size(); ++k) {
            const KnownLines::Known& known = last.line[k];
            if (!(known.family == families[subject])) continue;
            for (std::int64_t i = known.first; i < known.first + known.count; ++i) {
                place.push_back(last.place[i]);
                direction.push_back(last.direction[i]);
                owner.push_back(k);
            }
        }
        if (place.empty()) continue;
        const double radius = line_tuning.farthest_number * subjects[subject].side;
        const geometry::PointGrid grid(place, radius);
        for (std::int64_t l = 0; l < lines.lines.size(); ++l) {
            const visibility::Line& line = lines.lines[l];
            if (line.subject != subject) continue;
            const std::int64_t step = std::max<std::int64_t>(1, line.pieces / line_tuning.most_points);
            for (std::int64_t p = 0; p < line.pieces; p += step) {
                const curves::CurvePoint& point = point_of(subjects, lines, line.first_piece + p);
                double least = radius;
                std::int64_t nearest = -1;
                grid.around(point.position, [&](std::int64_t at) {
                    const std::int64_t i = grid.index(at);
                    const double distance = glm::distance(place[i], point.position);
                    if (distance > least || !(glm::dot(direction[i], point.direction()) > 0.0)) return;
                    least = distance;
                    nearest = i;
                });
                if (nearest >= 0) ++of_line[owner[nearest]];
            }
            for (std::int64_t k = 0; k < last.line.size(); ++k)
                if (const std::int64_t points = std::exchange(of_line[k], 0); points > 0)
                    votes.push_back({l, k, points * step});
        }
    }
    return votes;
}

// Lines that go on from the last frame keep their numbers; others get new ones.
LineNumbers number_lines(base::Memory& memory, const base::Array<visibility::Subject>& subjects,
                         const base::Array<visibility::Occluder>& occluders, const visibility::ImageLines& lines,
                         KnownLines& last) {
    base::Array<LineFamily> families(memory);
    base::Array<std::int64_t> of_item(memory, occluders.size());
    for (const visibility::Subject& subject : subjects) {
        HRBFNPR_ASSERT(subject.item >= 0 && subject.item < of_item.size());
        families.push_back({occluders[subject.item].sheets, subject.item, of_item[subject.item]++});
    }
    const auto position = [&](std::int64_t piece) { return point_of(subjects, lines, piece).position; };
    LineNumbers out(memory);
    out.number.resize(lines.lines.size());
    for (const visibility::Line& line : lines.lines) out.origin.push_back(line.first_piece);
    base::Array<Vote> votes = count_votes(last, families, subjects, lines);
    std::sort(votes.begin(), votes.end(), [](const Vote& a, const Vote& b) {
        return std::tie(b.points, a.line, a.known) < std::tie(a.points, b.line, b.known);
    });
    base::Array<std::uint8_t> taken(memory, last.line.size());
    for (const Vote& vote : votes) {
        if (out.number[vote.line] != 0 || taken[vote.known] != 0) continue;
        const KnownLines::Known& known = last.line[vote.known];
        out.number[vote.line] = known.number;
        taken[vote.known] = 1;
        std::int64_t& origin = out.origin[vote.line];
        const visibility::Line& line = lines.lines[vote.line];
        double least = glm::distance(position(origin), known.origin);
        for (std::int64_t p = line.first_piece + 1; p < line.first_piece + line.pieces; ++p)
            if (const double distance = glm::distance(position(p), known.origin); distance < least) {
                least = distance;
                origin = p;
            }
    }
    KnownLines next(memory);
    next.number = last.number;
    for (std::int64_t l = 0; l < lines.lines.size(); ++l) {
        const visibility::Line& line = lines.lines[l];
        if (out.number[l] == 0) out.number[l] = ++next.number;
        const std::int64_t first = next.place.size();
        for (std::int64_t p = line.first_piece; p < line.first_piece + line.pieces; p += line_tuning.kept_each) {
            next.place.push_back(position(p));
            next.direction.push_back(point_of(subjects, lines, p).direction());
        }
        next.line.push_back(
            {families[line.subject], first, next.place.size() - first, out.number[l], position(out.origin[l])});
    }
    last = std::move(next);
    return out;
}

} // namespace

const LineStrokes& LineFrame::run(const Scene& scene, std::span<const Item> items, const base::Progress& progress,
                                  drawing::Drawing& drawing) {
    strokes_.strokes.clear();
    strokes_.points.clear();
    if (std::none_of(items.begin(), items.end(), draws_lines)) return strokes_;
    const base::Stopwatch watch;
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
    const auto is_from_last = [](const auto& contours) { return contours->from_last; };
    if (found.report.settled > 0 && std::any_of(traced.contours.begin(), traced.contours.end(), is_from_last)) {
        contours_.clear();
        drawing.layers.resize(layers);
        traced = trace();
        found = count_sheets(traced);
    }
    visibility::find_hidden_by(runtime_, std::as_const(found.subjects).span(), traced.occluders.span(), found,
                               progress.part(found_end, hidden_end).standing());
    count(found, traced, drawing.line_counts);
    const visibility::Lengths lengths(runtime_.memory, found.lines);
    const LineNumbers numbers = number_lines(runtime_.memory, found.subjects, traced.occluders, found.lines, known_);
    progress.update(hidden_end);
    add_strokes({runtime_, scene, traced, found, lengths, numbers}, drawing, progress.part(hidden_end, 1.0), strokes_);
    contours_ = std::move(traced.contours);
    progress.update(1.0);
    drawing.line_counts.nanoseconds = watch.nanoseconds();
    return strokes_;
}

} // namespace hrbfnpr::frame
