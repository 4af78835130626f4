// SPDX-License-Identifier: MIT
// Lines get a mark at each step, which is settled on the surface. They are cut into pieces where they pass over a
// crease or leave the surface; the ends of pieces are drawn up to creases, and the pieces' marks are appended.
#include "base/sort.h"
#include "hatching/lines.h"
#include "hatching/tuning.h"
#include "surface/creased.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <tuple>

namespace hrbfnpr::hatching {
namespace {

// Around a fork of a coarse wave a line changes its level often, and is to change it only for long: each mark gets the
// median level of those up to `reach` away along the line.
void smooth_levels(Lines& lines, std::int64_t reach) {
    base::Array<std::uint8_t> median(lines.first.memory());
    base::Array<std::uint8_t> near(lines.first.memory());
    for (std::int64_t l = 0; l < lines.count(); ++l)
        for (std::int64_t i = lines.first[l]; i < lines.first[l + 1]; ++i) {
            near.clear();
            const std::int64_t last = std::min(lines.first[l + 1] - 1, i + reach);
            for (std::int64_t k = std::max(lines.first[l], i - reach); k <= last; ++k) near.push_back(lines.level[k]);
            std::uint8_t* const middle = near.begin() + (near.size() - 1) / 2;
            std::nth_element(near.begin(), middle, near.end());
            median.push_back(*middle);
        }
    std::swap(lines.level, median);
}

// Brings marks onto the surface; the normal of one that did not settle is 0.
void settle(const marks::Site& site, const LineMarkSettings& settings, Lines& lines, marks::LevelReport& report,
            const base::Progress& progress) {
    marks::Settler settler(site);
    const std::int64_t count = lines.position.size();
    for (std::int64_t from = 0; from < count; from += marks::chunk_size) {
        settler.start.clear();
        const std::int64_t end = std::min(count, from + marks::chunk_size);
        for (std::int64_t i = from; i < end; ++i) settler.start.push_back(lines.position[i]);
        settler.settle(settings.separation, report, base::Progress(progress).part(0.0, 0.0));
        for (std::int64_t i = from; i < end; ++i) {
            if (settler.placed(i - from) && !settings.region.contains(settler.position(i - from)))
                settler.drop(i - from, report.dropped_strayed, report);
            lines.position.set(i, settler.position(i - from));
            lines.normal.set(i, settler.placed(i - from) ? settler.normal(i - from) : glm::dvec3(0.0));
        }
        progress.update(static_cast<double>(end) / static_cast<double>(count));
    }
}

// 1 for marks on another sheet than the mark before them, which is the last one for the first of a line; empty where
// the surface is smooth. A mark on the crease itself belongs to the sheet of the marks that it goes on from, or else
// leads to, and gets its normal.
base::Array<std::uint8_t> starts_at_creases(const marks::Site& site, Lines& lines, const base::Progress& progress) {
    base::Array<std::int32_t> sheet = surface::sheets_at(site.runtime, site.implicit, lines.position, progress);
    base::Array<std::uint8_t> starts(site.memory(), sheet.size());
    const implicit::Sheets* const sheets = site.implicit.sheets();
    if (sheets == nullptr) return starts;
    const auto joins = [&](std::int64_t i, std::int32_t other) {
        const surface::SheetValue at = surface::sheet_at(*sheets, other, lines.position[i]);
        const double slope = glm::length(at.gradient);
        if (!(std::abs(at.value) <= hatching_tuning.on_sheet * site.implicit.diagonal() * slope)) return false;
        lines.normal.set(i, at.gradient / slope);
        sheet[i] = other;
        return true;
    };
    const auto has_settled = [&](std::int64_t i) { return lines.normal[i] != glm::dvec3(0.0); };
    for (std::int64_t l = 0; l < lines.count(); ++l) {
        progress.check();
        bool goes_on = false; // the mark before does, from the one before that
        for (std::int64_t i = lines.first[l], last = lines.first[l + 1] - 1; i < lines.first[l + 1]; last = i++) {
            if (i == lines.first[l] && lines.closed[l] == 0) continue;
            const bool both = has_settled(last) && has_settled(i);
            const bool creased =
                both && surface::is_creased(sheet[last], sheet[i], lines.normal[last], lines.normal[i]);
            if (creased && !joins(i, sheet[last]) && (goes_on || !joins(last, sheet[i]))) starts[i] = 1;
            goes_on = both && starts[i] == 0;
        }
    }
    return starts;
}

// Where the sheet of the marks meets the sheet that their line comes to a step beyond its end. Not found if it comes to
// no other sheet.
surface::MeetingPlace crease_beyond(const implicit::Sheets& sheets, const glm::dvec3& inner, const glm::dvec3& end,
                                    double step) {
    const double ahead = hatching_tuning.crease_ahead * step;
    const std::int32_t own = surface::active_at(sheets, inner);
    const std::int32_t other = surface::active_at(sheets, end + ahead * glm::normalize(end - inner));
    if (own == other) return {};
    surface::Meeting meeting;
    meeting.add(own);
    meeting.add(other);
    const surface::MeetingPlace place = surface::find_meeting(sheets, meeting, end, 1e-7 * step, ahead);
    const bool creased = place.found && surface::is_creased(own, other, glm::normalize(place.gradient[0]),
                                                            glm::normalize(place.gradient[1]));
    return creased ? place : surface::MeetingPlace{};
}

bool is_a_step(const glm::dvec3& a, const glm::dvec3& b, double step) noexcept {
    const double distance = glm::distance(a, b) / step;
    return distance > hatching_tuning.least_step && distance < hatching_tuning.most_step;
}

// A line ends where its face of the mesh does, but once it has been moved to the middle between others, its last mark
// may lie beyond the crease, on the next sheet, or somewhat before it. So an end beside a crease gets a mark on that.
struct CreaseEnd {
    surface::MeetingPlace place;
    bool replaces = false; // the mark that the line ended with, which is too near
};

CreaseEnd crease_end(const implicit::Sheets* sheets, const glm::dvec3& inner, const glm::dvec3& end, double step) {
    if (sheets == nullptr) return {};
    CreaseEnd crease{crease_beyond(*sheets, inner, end, step)};
    if (!crease.place.found) return {};
    crease.replaces = glm::distance(crease.place.position, end) <= hatching_tuning.least_step * step;
    return is_a_step(crease.place.position, crease.replaces ? inner : end, step) ? crease : CreaseEnd{};
}

// Lines in pieces each of which lies on the surface and on one side of all creases.
Lines cut(const marks::Site& site, const Lines& lines, const base::Array<std::uint8_t>& starts, double step,
          const base::Progress& progress) {
    Lines pieces(site.memory());
    const auto add = [&](std::int64_t l, std::int64_t begin, std::int64_t end) {
        const auto at = [&](std::int64_t k) { return lines.first[l] + k % lines.points(l); };
        const auto place = [&](std::int64_t k) { return lines.position[at(k)]; };
        if (end - begin < hatching_tuning.fewest_marks) return;
        const CreaseEnd head = crease_end(site.implicit.sheets(), place(begin + 1), place(begin), step);
        const CreaseEnd tail = crease_end(site.implicit.sheets(), place(end - 2), place(end - 1), step);
        const auto add_crease = [&](const surface::MeetingPlace& crease, std::int64_t k) {
            if (crease.found)
                pieces.add_point(crease.position, glm::normalize(crease.gradient[0]), lines.level[at(k)], progress);
        };
        add_crease(head.place, begin);
        for (std::int64_t k = begin + (head.replaces ? 1 : 0); k < end - (tail.replaces ? 1 : 0); ++k)
            pieces.add_point(place(k), lines.normal[at(k)], lines.level[at(k)], progress);
        add_crease(tail.place, end - 1);
        pieces.end_line(false);
    };
    for (std::int64_t l = 0; l < lines.count(); ++l) {
        // The last mark of a closed line is its first one once more.
        const std::int64_t count = lines.points(l) + (lines.closed[l] != 0 ? 1 : 0);
        std::int64_t begin = 0;
        for (std::int64_t k = 1; k <= count; ++k) {
            const std::int64_t last = lines.first[l] + k - 1;
            const std::int64_t next = lines.first[l] + k % lines.points(l);
            const bool goes_on = k < count && (starts.empty() || starts[next] == 0) &&
                                 is_a_step(lines.position[last], lines.position[next], step) &&
                                 glm::dot(lines.normal[last], lines.normal[next]) > 0.0;
            if (goes_on) continue;
            add(l, begin, k);
            begin = k;
        }
    }
    return pieces;
}

void append(const Lines& pieces, std::int64_t piece, std::uint32_t number, float rank, marks::Marks& marks) {
    const std::int64_t first = pieces.first[piece];
    const std::int64_t last = pieces.first[piece + 1] - 1;
    for (std::int64_t i = first; i <= last; ++i) {
        const glm::dvec3 n = pieces.normal[i];
        const glm::dvec3 way = pieces.position[std::min(last, i + 1)] - pieces.position[std::max(first, i - 1)];
        marks.position.push_back(pieces.position[i]);
        marks.normal.push_back(n);
        marks.direction.push_back(glm::normalize(way - glm::dot(way, n) * n));
        marks.key.push_back(static_cast<std::uint64_t>(marks.count() - 1));
        marks.stroke.push_back(2 * number);
        marks.place.push_back(static_cast<std::int32_t>(i - first));
        marks.level.push_back(pieces.level[i]);
        marks.rank.push_back(rank);
    }
}

} // namespace

void add_line_marks(const marks::Site& site, const Lines& given, const LineMarkSettings& settings, marks::Marks& marks,
                    marks::LayerReport& report, const base::Progress& progress) {
    HRBFNPR_ASSERT(settings.separation > 0.0 && settings.step > 0.0 && marks.count() == 0);
    Lines lines = resampled(given, settings.step, 0.0, progress);
    const double reach = std::ceil(0.5 * hatching_tuning.level_length * settings.separation / settings.step);
    smooth_levels(lines, static_cast<std::int64_t>(reach));
    marks::LevelReport& level = report.of(0);
    settle(site, settings, lines, level, progress);
    const base::Array<std::uint8_t> starts = starts_at_creases(site, lines, progress);
    const Lines pieces = cut(site, lines, starts, settings.step, progress);
    // Marks that no piece is made of were placed for nothing; those on creases, and ends of rings, come on top.
    const std::int64_t all = pieces.position.size();
    const std::int64_t added = std::max<std::int64_t>(0, all - level.placed);
    level.attempted += added;
    level.dropped_strayed += level.placed + added - all;
    level.placed = all;
    struct Order {
        std::uint8_t level; // the coarsest of the piece's marks
        std::int64_t piece;
    };
    base::Array<Order> order(site.memory());
    for (std::int64_t p = 0; p < pieces.count(); ++p)
        order.push_back(
            {*std::min_element(pieces.level.begin() + pieces.first[p], pieces.level.begin() + pieces.first[p + 1]), p});
    base::sort_long(order.begin(), order.end(), [](const Order& a, const Order& b) {
        return std::tie(a.level, a.piece) < std::tie(b.level, b.piece);
    });
    std::uint32_t number = 0;
    for (const Order& next : order) {
        progress.check();
        const double middle = static_cast<double>(marks.count()) + 0.5 * static_cast<double>(pieces.points(next.piece));
        append(pieces, next.piece, number++, marks::rank_of(1.0 - middle / static_cast<double>(all)), marks);
    }
    report.full_count = all;
}

} // namespace hrbfnpr::hatching
