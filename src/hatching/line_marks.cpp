// SPDX-License-Identifier: MIT
#include "hatching/line_marks.h"

#include "base/sort.h"

#include "hatching/line_walk.h"
#include "marks/assemble.h"
#include "marks/crease_ends.h"
#include "marks/tone_part.h"
#include "surface/creased.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::hatching {
namespace {

// Rounds of 1/4, 1/2, 1/4 along a line: points on a mesh's edges know their place to a part of its cells.
constexpr int mark_smoothings = 2;
// In separations of the finest level: over so much of a line its points vote for one level, and no line is shorter.
constexpr double votes = 6.0;
constexpr double shortest_line = 2.0;
// Marks next to each other that are farther apart than this, in steps, or nearer, do not belong together.
constexpr double widest_step = 1.6;
constexpr double narrowest_step = 0.5;
constexpr std::int64_t fewest_marks = 3;
// A crease that lies no farther ahead of a line's end, in steps, is where it ends; farther, if there is a mark to
// spare.
constexpr double crease_ahead = 0.6;
constexpr double spare_ahead = 1.1;
// In steps: of a place on a crease.
constexpr double on_crease = 1e-7;

// A line as its marks will be.
struct Path {
    std::int64_t begin = 0, count = 0; // of the points
    bool closed = false;
};

// A part that lies on the surface in one piece.
struct Piece {
    std::int64_t begin = 0, count = 0;
    std::uint8_t level = 0; // the coarsest of its marks
};

class Laying {
public:
    Laying(const marks::Site& site, const StripeLines& lines, const LineMarkSettings& settings, marks::Marks& marks,
           marks::LayerReport& report)
        : site_(site), lines_(lines), settings_(settings), marks_(marks), report_(report), paths_(site.memory()),
          point_(site.memory()), level_(site.memory()), position_(site.memory()), normal_(site.memory()),
          placed_(site.memory()), ends_(site.memory()), spare_(site.memory()), pieces_(site.memory()) {}

    void resample(const base::Progress& progress);
    void project(const base::Progress& progress);
    void cut(const base::Progress& progress);
    void append(const base::Progress& progress);

private:
    void resample(std::int64_t line);
    void smooth(const Path& path);
    void vote(const Path& path);
    void cut(const Path& path);
    [[nodiscard]] bool joined(std::int64_t i) const noexcept;
    void reach_crease(Piece& piece, bool forwards);
    [[nodiscard]] surface::MeetingPlace crease_ahead_of(std::int64_t end, std::int64_t inner, double ahead) const;
    [[nodiscard]] glm::dvec3 direction(const Piece& piece, std::int64_t i) const noexcept;
    void append(const Piece& piece, std::uint32_t number, float rank);

    const marks::Site& site_;
    const StripeLines& lines_;
    const LineMarkSettings& settings_;
    marks::Marks& marks_;
    marks::LayerReport& report_;
    base::Array<Path> paths_;
    geometry::VecArray point_; // of all paths
    base::Array<std::uint8_t> level_;
    geometry::VecArray position_, normal_; // on the surface
    base::Array<std::uint8_t> placed_;
    base::Array<std::uint8_t> ends_;  // of marks/crease_ends.h
    base::Array<std::uint8_t> spare_; // marks that no piece has
    base::Array<Piece> pieces_;
};

// A closed line ends where it begins: once more.
void Laying::resample(std::int64_t line) {
    const LineWalk walk(lines_, line);
    if (!(walk.length() >= shortest_line * settings_.separation)) return;
    const auto steps = static_cast<std::int64_t>(std::max(2.0, std::round(walk.length() / settings_.step)));
    const Path path{point_.size(), steps + 1, lines_.closed[line] != 0};
    walk.visit(steps, [&](const LinePlace& place) {
        point_.push_back(place.of(lines_.position));
        level_.push_back(place.level(lines_));
    });
    smooth(path);
    vote(path);
    paths_.push_back(path);
}

void Laying::smooth(const Path& path) {
    const std::int64_t last = path.begin + path.count - 1;
    for (int round = 0; round < mark_smoothings; ++round) {
        glm::dvec3 before = path.closed ? point_[last - 1] : point_[path.begin];
        const glm::dvec3 second = point_[path.begin + 1];
        for (std::int64_t i = path.begin; i <= last; ++i) {
            const glm::dvec3 here = point_[i];
            const bool end = !path.closed && (i == path.begin || i == last);
            const glm::dvec3 after = i < last ? point_[i + 1] : second;
            if (!end) point_.set(i, 0.25 * before + 0.5 * here + 0.25 * after);
            before = here;
        }
        if (path.closed) point_.set(last, point_[path.begin]);
    }
}

// The median level of each point's neighbours along the line.
void Laying::vote(const Path& path) {
    const auto reach = static_cast<std::int64_t>(std::ceil(0.5 * votes * settings_.separation / settings_.step));
    std::array<std::int64_t, 256> counts{};
    base::Array<std::uint8_t> median(site_.memory(), path.count);
    const std::int64_t end = path.begin + path.count;
    for (std::int64_t i = path.begin; i < std::min(end, path.begin + reach); ++i) ++counts[level_[i]];
    for (std::int64_t i = path.begin; i < end; ++i) {
        if (i + reach < end) ++counts[level_[i + reach]];
        if (i - reach - 1 >= path.begin) --counts[level_[i - reach - 1]];
        const std::int64_t all = std::min(end - 1, i + reach) - std::max(path.begin, i - reach) + 1;
        std::int64_t sum = 0;
        std::size_t level = 0;
        while (2 * (sum += counts[level]) < all) ++level;
        median[i - path.begin] = static_cast<std::uint8_t>(level);
    }
    std::copy(median.begin(), median.end(), level_.data() + path.begin);
}

void Laying::resample(const base::Progress& progress) {
    for (std::int64_t line = 0; line < lines_.count(); ++line) {
        progress.check();
        resample(line);
    }
}

void Laying::project(const base::Progress& progress) {
    marks::Settler settler(site_);
    marks::LevelReport& level = report_.of(0);
    for (std::int64_t from = 0; from < point_.size(); from += marks::chunk_size) {
        settler.start.clear();
        const std::int64_t end = std::min(point_.size(), from + marks::chunk_size);
        for (std::int64_t i = from; i < end; ++i) settler.start.push_back(point_[i]);
        settler.settle(settings_.separation, level, base::Progress(progress).part(0.0, 0.0));
        for (std::int64_t i = 0; i < settler.start.size(); ++i) {
            if (settler.placed(i) && !settings_.region.contains(settler.position(i)))
                settler.drop(i, level.dropped_strayed, level);
            position_.push_back(settler.position(i));
            normal_.push_back(settler.placed(i) ? settler.normal(i) : glm::dvec3(0.0));
            placed_.push_back(settler.placed(i) ? 1 : 0);
        }
        progress.update(static_cast<double>(end) / static_cast<double>(point_.size()));
    }
    ends_ = marks::find_crease_ends(site_, position_, normal_, widest_step * settings_.step, progress);
}

// Whether point i goes on where point i - 1 ended.
bool Laying::joined(std::int64_t i) const noexcept {
    if (placed_[i - 1] == 0 || placed_[i] == 0 || (!ends_.empty() && ends_[i] != 0)) return false;
    const double distance = glm::distance(position_[i], position_[i - 1]) / settings_.step;
    return distance > narrowest_step && distance < widest_step && glm::dot(normal_[i], normal_[i - 1]) > 0.0;
}

// Where the piece's sheet meets the one that the line comes to so many steps ahead; not found if it comes to none.
surface::MeetingPlace Laying::crease_ahead_of(std::int64_t end, std::int64_t inner, double ahead) const {
    const implicit::Sheets& sheets = *site_.implicit.sheets();
    const glm::dvec3 way = position_[end] - position_[inner];
    const glm::dvec3 beyond = position_[end] + ahead * settings_.step / glm::length(way) * way;
    const std::int32_t own = surface::active_at(sheets, position_[inner]);
    const std::int32_t other = surface::active_at(sheets, beyond);
    if (own == other) return {};
    surface::Meeting meeting;
    meeting.add(own);
    meeting.add(other);
    const surface::MeetingPlace place = surface::find_meeting(sheets, meeting, position_[end],
                                                              on_crease * settings_.step, spare_ahead * settings_.step);
    const bool creased = place.found && surface::is_creased(own, other, glm::normalize(place.gradient[0]),
                                                            glm::normalize(place.gradient[1]));
    return creased ? place : surface::MeetingPlace{};
}

// A line ends where the mesh's face does, but when it is moved to the middle between others, its last mark may come to
// lie beyond the crease, on the next sheet, or somewhat before it.
void Laying::reach_crease(Piece& piece, bool forwards) {
    const std::int64_t way = forwards ? 1 : -1;
    const std::int64_t end = forwards ? piece.begin + piece.count - 1 : piece.begin;
    const std::int64_t next = end + way;
    const bool spare = next >= 0 && next < spare_.size() && spare_[next] != 0 && ends_[std::max(end, next)] != 0;
    const surface::MeetingPlace crease = crease_ahead_of(end, end - way, spare ? spare_ahead : crease_ahead);
    if (!crease.found) return;
    const auto steps_from = [&](std::int64_t i) {
        return glm::distance(crease.position, position_[i]) / settings_.step;
    };
    const bool takes_next = spare && steps_from(end) > narrowest_step;
    const double last_step = steps_from(takes_next ? end : end - way);
    if (!(last_step > narrowest_step && last_step < widest_step)) return;
    const std::int64_t at = takes_next ? next : end;
    position_.set(at, crease.position);
    normal_.set(at, glm::normalize(crease.gradient[0]));
    if (!takes_next) return;
    spare_[next] = 0;
    level_[next] = level_[end];
    ++piece.count;
    if (!forwards) --piece.begin;
}

void Laying::cut(const Path& path) {
    const std::int64_t end = path.begin + path.count;
    for (std::int64_t begin = path.begin; begin < end;) {
        Piece piece{begin, 1, level_[begin]};
        for (; begin + piece.count < end && joined(begin + piece.count); ++piece.count)
            piece.level = std::min(piece.level, level_[begin + piece.count]);
        begin += piece.count;
        if (placed_[piece.begin] == 0) continue;
        if (piece.count >= fewest_marks)
            pieces_.push_back(piece);
        else if (!spare_.empty())
            std::fill_n(spare_.begin() + piece.begin, piece.count, std::uint8_t{1});
    }
}

void Laying::cut(const base::Progress& progress) {
    spare_.resize(ends_.size());
    for (const Path& path : paths_) {
        progress.check();
        cut(path);
    }
    for (Piece& piece : pieces_) {
        if (ends_.empty()) break;
        progress.check();
        for (const bool forwards : {false, true}) reach_crease(piece, forwards);
    }
    // Of equal levels as they stand, along the paths; std::stable_sort would take memory that is not the caller's.
    base::sort_long(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
        return a.level != b.level ? a.level < b.level : a.begin < b.begin;
    });
}

glm::dvec3 Laying::direction(const Piece& piece, std::int64_t i) const noexcept {
    const std::int64_t before = std::max(piece.begin, i - 1);
    const std::int64_t after = std::min(piece.begin + piece.count - 1, i + 1);
    const glm::dvec3 way = position_[after] - position_[before];
    return glm::normalize(way - glm::dot(way, normal_[i]) * normal_[i]);
}

void Laying::append(const Piece& piece, std::uint32_t number, float rank) {
    for (std::int64_t place = 0; place < piece.count; ++place) {
        const std::int64_t i = piece.begin + place;
        marks_.position.push_back(position_[i]);
        marks_.normal.push_back(normal_[i]);
        marks_.direction.push_back(direction(piece, i));
        marks_.key.push_back(static_cast<std::uint64_t>(marks_.count() - 1));
        marks_.stroke.push_back(2 * number);
        marks_.place.push_back(static_cast<std::int32_t>(place));
        marks_.level.push_back(level_[i]);
        marks_.rank.push_back(rank);
    }
}

// Marks that no line is made of were placed for nothing.
void Laying::append(const base::Progress& progress) {
    std::int64_t all = 0;
    for (const Piece& piece : pieces_) all += piece.count;
    std::int64_t before = 0;
    std::uint32_t number = 0;
    for (const Piece& piece : pieces_) {
        progress.check();
        const double middle = static_cast<double>(before) + 0.5 * static_cast<double>(piece.count);
        append(piece, number++, marks::rank_of(1.0 - middle / static_cast<double>(all)));
        before += piece.count;
    }
    marks::LevelReport& level = report_.of(0);
    level.dropped_strayed += level.placed - all;
    level.placed = all;
}

} // namespace

void add_line_marks(const marks::Site& site, const StripeLines& lines, const LineMarkSettings& settings,
                    marks::Marks& marks, marks::LayerReport& report, const base::Progress& progress) {
    Laying laying(site, lines, settings, marks, report);
    laying.resample(progress);
    laying.project(progress);
    laying.cut(progress);
    laying.append(progress);
    report.full_count = marks.count();
}

} // namespace hrbfnpr::hatching
