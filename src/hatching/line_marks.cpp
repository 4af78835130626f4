// SPDX-License-Identifier: MIT
// Lines get a mark at each step, which is settled on the surface. They are cut into pieces where they pass over a
// crease or leave the surface; the ends of pieces are drawn up to creases, and the pieces' marks are appended.
#include "hatching/line_marks.h"

#include "base/sort.h"
#include "hatching/tuning.h"
#include "marks/tone_part.h"
#include "surface/creased.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <tuple>

namespace hrbfnpr::hatching {
namespace {

// The marks of all lines; the last mark of a closed line is its first one once more.
struct Laid {
    explicit Laid(base::Memory& memory) noexcept : position(memory), normal(memory), level(memory), starts(memory) {}

    geometry::VecArray position;
    geometry::VecArray normal; // unit; 0: the mark did not settle
    base::Array<std::uint8_t> level;
    base::Array<std::uint8_t>
        starts; // 1: does not go on from the mark before, since a line begins or a crease is between
};

// A part of a line that lies on the surface, and the ends that it is given on creases.
struct Piece {
    std::int64_t begin = 0, end = 0;
    std::uint8_t level = 0; // the coarsest of its marks
    surface::MeetingPlace head, tail;
    bool own_head = true, own_tail = true; // whether the marks there stay beside those on creases
};

// Around a fork of a coarse wave a line changes its level often, and is to change it only for long: each mark gets the
// median level of those up to `reach` away along the line.
void add_levels(const Lines& lines, std::int64_t line, std::int64_t reach, base::Array<std::uint8_t>& levels) {
    const std::uint8_t* const own = lines.level.data() + lines.first[line];
    const std::int64_t closing = lines.closed[line] != 0 ? 1 : 0;
    const std::int64_t count = lines.points(line) + closing;
    const auto level = [&](std::int64_t i) { return own[i < lines.points(line) ? i : 0]; };
    base::Array<std::uint8_t> near(lines.first.memory());
    for (std::int64_t i = 0; i < count; ++i) {
        near.clear();
        for (std::int64_t k = std::max<std::int64_t>(0, i - reach); k <= std::min(count - 1, i + reach); ++k)
            near.push_back(level(k));
        std::uint8_t* const median = near.begin() + (near.size() - 1) / 2;
        std::nth_element(near.begin(), median, near.end());
        levels.push_back(*median);
    }
}

Laid lay(const marks::Site& site, const Lines& lines, const LineMarkSettings& settings, marks::LevelReport& report,
         const base::Progress& progress) {
    Laid laid(site.memory());
    geometry::VecArray wanted(site.memory());
    const auto reach =
        static_cast<std::int64_t>(std::ceil(0.5 * hatching_tuning.level_length * settings.separation / settings.step));
    for (std::int64_t l = 0; l < lines.count(); ++l) {
        progress.check();
        const std::int64_t begin = wanted.size();
        for (std::int64_t i = lines.first[l]; i < lines.first[l + 1]; ++i) wanted.push_back(lines.position[i]);
        if (lines.closed[l] != 0) wanted.push_back(lines.position[lines.first[l]]);
        laid.starts.resize(wanted.size());
        laid.starts[begin] = 1;
        add_levels(lines, l, reach, laid.level);
    }
    marks::Settler settler(site);
    for (std::int64_t from = 0; from < wanted.size(); from += marks::chunk_size) {
        settler.start.clear();
        const std::int64_t end = std::min(wanted.size(), from + marks::chunk_size);
        for (std::int64_t i = from; i < end; ++i) settler.start.push_back(wanted[i]);
        settler.settle(settings.separation, report, base::Progress(progress).part(0.0, 0.0));
        for (std::int64_t i = 0; i < end - from; ++i) {
            if (settler.placed(i) && !settings.region.contains(settler.position(i)))
                settler.drop(i, report.dropped_strayed, report);
            laid.position.push_back(settler.position(i));
            laid.normal.push_back(settler.placed(i) ? settler.normal(i) : glm::dvec3(0.0));
        }
        progress.update(static_cast<double>(end) / static_cast<double>(wanted.size()));
    }
    return laid;
}

// Marks whose line passes over a crease before them start anew. A mark on the crease itself belongs to the sheet of the
// marks that it goes on from, or else leads to, and gets its normal.
void start_at_creases(const marks::Site& site, Laid& laid, const base::Progress& progress) {
    const implicit::Sheets* const sheets = site.implicit.sheets();
    if (sheets == nullptr) return;
    base::Array<std::int32_t> sheet = surface::sheets_at(site.runtime, site.implicit, laid.position, progress);
    const double on_sheet = hatching_tuning.on_sheet * site.implicit.diagonal();
    const auto joins = [&](std::int64_t i, std::int32_t other) {
        const surface::SheetValue at = surface::sheet_at(*sheets, other, laid.position[i]);
        const double slope = glm::length(at.gradient);
        if (!(std::abs(at.value) <= on_sheet * slope)) return false;
        laid.normal.set(i, at.gradient / slope);
        sheet[i] = other;
        return true;
    };
    const auto has_settled = [&](std::int64_t i) { return laid.normal[i] != glm::dvec3(0.0); };
    bool goes_on = false; // the mark before does, from the one before that
    for (std::int64_t i = 1; i < laid.position.size(); ++i) {
        if (i % marks::chunk_size == 0) progress.check();
        const bool beside = laid.starts[i] == 0 && has_settled(i - 1) && has_settled(i);
        const bool creased = beside && surface::is_creased(sheet[i - 1], sheet[i], laid.normal[i - 1], laid.normal[i]);
        if (creased && !joins(i, sheet[i - 1]) && (goes_on || !joins(i - 1, sheet[i]))) laid.starts[i] = 1;
        goes_on = beside && laid.starts[i] == 0;
    }
}

base::Array<Piece> cut(const marks::Site& site, const Laid& laid, double step) {
    base::Array<Piece> pieces(site.memory());
    const auto goes_on = [&](std::int64_t i) {
        const double distance = glm::distance(laid.position[i], laid.position[i - 1]) / step;
        return laid.starts[i] == 0 && distance > hatching_tuning.least_step && distance < hatching_tuning.most_step &&
               glm::dot(laid.normal[i], laid.normal[i - 1]) > 0.0;
    };
    for (std::int64_t i = 0; i < laid.position.size();) {
        Piece piece;
        piece.begin = i;
        piece.level = laid.level[i];
        for (++i; i < laid.position.size() && goes_on(i); ++i) piece.level = std::min(piece.level, laid.level[i]);
        piece.end = i;
        if (piece.end - piece.begin >= hatching_tuning.fewest_marks) pieces.push_back(piece);
    }
    return pieces;
}

// Where the sheet of the marks meets the one that their line comes to a step beyond its end; not found if there is
// none.
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

// A line ends where its face of the mesh does, but once it has been moved to the middle between others, its last mark
// may lie beyond the crease, on the next sheet, or somewhat before it. So an end beside a crease gets a mark on that,
// beside its own or in the place of its own.
void reach_crease(const implicit::Sheets& sheets, const Laid& laid, double step, std::int64_t inner, std::int64_t end,
                  surface::MeetingPlace& mark, bool& keeps_own) {
    const surface::MeetingPlace crease = crease_beyond(sheets, laid.position[inner], laid.position[end], step);
    if (!crease.found) return;
    const auto steps_from = [&](std::int64_t i) { return glm::distance(crease.position, laid.position[i]) / step; };
    keeps_own = steps_from(end) > hatching_tuning.least_step;
    const double last = steps_from(keeps_own ? end : inner);
    if (last > hatching_tuning.least_step && last < hatching_tuning.most_step)
        mark = crease;
    else
        keeps_own = true;
}

// The marks of a piece, in order.
void collect(const Laid& laid, const Piece& piece, Laid& marks) {
    marks.position.clear();
    marks.normal.clear();
    marks.level.clear();
    const auto add = [&](const glm::dvec3& position, const glm::dvec3& normal, std::int64_t level_of) {
        marks.position.push_back(position);
        marks.normal.push_back(normal);
        marks.level.push_back(laid.level[level_of]);
    };
    if (piece.head.found) add(piece.head.position, glm::normalize(piece.head.gradient[0]), piece.begin);
    for (std::int64_t i = piece.begin + (piece.own_head ? 0 : 1); i < piece.end - (piece.own_tail ? 0 : 1); ++i)
        add(laid.position[i], laid.normal[i], i);
    if (piece.tail.found) add(piece.tail.position, glm::normalize(piece.tail.gradient[0]), piece.end - 1);
}

[[nodiscard]] std::int64_t size_of(const Piece& piece) noexcept {
    const auto added = [](const surface::MeetingPlace& end, bool own) { return end.found && own ? 1 : 0; };
    return piece.end - piece.begin + added(piece.head, piece.own_head) + added(piece.tail, piece.own_tail);
}

void append(const Laid& piece, std::uint32_t number, float rank, marks::Marks& marks) {
    const std::int64_t count = piece.position.size();
    for (std::int64_t i = 0; i < count; ++i) {
        const glm::dvec3 n = piece.normal[i];
        const glm::dvec3 way =
            piece.position[std::min(count - 1, i + 1)] - piece.position[std::max<std::int64_t>(0, i - 1)];
        marks.position.push_back(piece.position[i]);
        marks.normal.push_back(n);
        marks.direction.push_back(glm::normalize(way - glm::dot(way, n) * n));
        marks.key.push_back(static_cast<std::uint64_t>(marks.count() - 1));
        marks.stroke.push_back(2 * number);
        marks.place.push_back(static_cast<std::int32_t>(i));
        marks.level.push_back(piece.level[i]);
        marks.rank.push_back(rank);
    }
}

} // namespace

void add_line_marks(const marks::Site& site, const Lines& lines, const LineMarkSettings& settings, marks::Marks& marks,
                    marks::LayerReport& report, const base::Progress& progress) {
    HRBFNPR_ASSERT(settings.separation > 0.0 && settings.step > 0.0);
    marks::LevelReport& level = report.of(0);
    Laid laid = lay(site, resampled(lines, settings.step, 0.0, progress), settings, level, progress);
    start_at_creases(site, laid, progress);
    base::Array<Piece> pieces = cut(site, laid, settings.step);
    std::int64_t all = 0;
    std::int64_t kept = 0;
    for (Piece& piece : pieces) {
        progress.check();
        if (const implicit::Sheets* const sheets = site.implicit.sheets()) {
            reach_crease(*sheets, laid, settings.step, piece.begin + 1, piece.begin, piece.head, piece.own_head);
            reach_crease(*sheets, laid, settings.step, piece.end - 2, piece.end - 1, piece.tail, piece.own_tail);
        }
        all += size_of(piece);
        kept += piece.end - piece.begin;
    }
    // Marks that no line is made of were placed for nothing; those that ends got on creases come on top.
    level.dropped_strayed += level.placed - kept;
    level.attempted += all - kept;
    level.placed = all;
    base::sort_long(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) {
        return std::tie(a.level, a.begin) < std::tie(b.level, b.begin);
    });
    Laid own(site.memory());
    std::uint32_t number = 0;
    for (const Piece& piece : pieces) {
        progress.check();
        const double middle = static_cast<double>(marks.count()) + 0.5 * static_cast<double>(size_of(piece));
        collect(laid, piece, own);
        append(own, number++, marks::rank_of(1.0 - middle / static_cast<double>(all)), marks);
    }
    HRBFNPR_ASSERT(marks.count() == all);
    report.full_count = all;
}

} // namespace hrbfnpr::hatching
