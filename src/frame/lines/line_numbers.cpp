// SPDX-License-Identifier: MIT
#include "frame/lines/line_numbers.h"

#include "geometry/point_grid.h"

#include <algorithm>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// A line's points that are looked at; of how many points one is kept; and how far a contour may move on its surface
// between frames, in sides.
constexpr std::int64_t most_points = 16;
constexpr std::int64_t kept_each = 4;
constexpr double farthest_number = 3.0;

const curves::CurvePoint& point_of(std::span<const visibility::Subject> subjects, const visibility::ImageLines& lines,
                                   std::int64_t piece) noexcept {
    const visibility::Piece& its = lines.pieces[piece];
    return subjects[static_cast<std::size_t>(its.subject)].curves->point[its.a];
}

std::int64_t nearest_piece(std::span<const visibility::Subject> subjects, const visibility::ImageLines& lines,
                           const visibility::Line& line, const glm::dvec3& place) noexcept {
    std::int64_t nearest = line.first_piece;
    double least = glm::distance(point_of(subjects, lines, nearest).position, place);
    for (std::int64_t p = nearest + 1; p < line.first_piece + line.pieces; ++p) {
        const double distance = glm::distance(point_of(subjects, lines, p).position, place);
        if (!(distance < least)) continue;
        least = distance;
        nearest = p;
    }
    return nearest;
}

// The points of the last frame's lines of one family.
class Finder {
public:
    Finder(const geometry::VecArray& place, const geometry::VecArray& direction, double radius)
        : place_(place), direction_(direction), radius_(radius), grid_(place, radius) {}

    // -1: none.
    [[nodiscard]] std::int64_t nearest(const curves::CurvePoint& p) const {
        const glm::dvec3 along = p.direction();
        double least = radius_;
        std::int64_t found = -1;
        grid_.around(p.position, [&](std::int64_t at) {
            const std::int64_t i = grid_.index(at);
            const double distance = glm::distance(place_[i], p.position);
            if (distance > least || !(glm::dot(direction_[i], along) > 0.0)) return;
            least = distance;
            found = i;
        });
        return found;
    }

private:
    const geometry::VecArray& place_;
    const geometry::VecArray& direction_;
    double radius_;
    geometry::PointGrid grid_;
};

} // namespace

base::Array<LineNumbers::Vote> LineNumbers::count_votes(std::span<const LineFamily> families,
                                                        std::span<const visibility::Subject> subjects,
                                                        const visibility::ImageLines& lines) const {
    base::Memory& memory = last_.known.memory();
    base::Array<Vote> votes(memory);
    base::Array<std::int64_t> of_line(memory, last_.known.size());
    for (std::size_t subject = 0; subject < subjects.size(); ++subject) {
        geometry::VecArray place(memory);
        geometry::VecArray direction(memory);
        base::Array<std::int64_t> owner(memory);
        for (std::int64_t k = 0; k < last_.known.size(); ++k) {
            if (!(last_.families[last_.known[k].family] == families[subject])) continue;
            for (std::int64_t i = last_.known[k].first; i < last_.known[k].first + last_.known[k].count; ++i) {
                place.push_back(last_.place[i]);
                direction.push_back(last_.direction[i]);
                owner.push_back(k);
            }
        }
        if (place.empty()) continue;
        const Finder finder(place, direction, farthest_number * subjects[subject].side);
        for (std::int64_t l = 0; l < lines.lines.size(); ++l) {
            const visibility::Line& line = lines.lines[l];
            if (static_cast<std::size_t>(line.subject) != subject) continue;
            const std::int64_t step = std::max<std::int64_t>(1, line.pieces / most_points);
            for (std::int64_t p = 0; p < line.pieces; p += step)
                if (const std::int64_t i = finder.nearest(point_of(subjects, lines, line.first_piece + p)); i >= 0)
                    ++of_line[owner[i]];
            for (std::int64_t k = 0; k < last_.known.size(); ++k) {
                if (of_line[k] > 0) votes.push_back({l, k, of_line[k] * step});
                of_line[k] = 0;
            }
        }
    }
    return votes;
}

// Those with most points in common first.
void LineNumbers::give(base::Array<Vote>& votes, std::span<const visibility::Subject> subjects,
                       const visibility::ImageLines& lines) {
    std::sort(votes.begin(), votes.end(), [](const Vote& a, const Vote& b) {
        if (a.points != b.points) return a.points > b.points;
        return a.line != b.line ? a.line < b.line : a.known < b.known;
    });
    next_.number = last_.number;
    base::Array<std::uint8_t> taken(votes.memory(), last_.known.size());
    for (const Vote& vote : votes) {
        if (number_[vote.line] != 0 || taken[vote.known] != 0) continue;
        number_[vote.line] = last_.known[vote.known].number;
        origin_[vote.line] = nearest_piece(subjects, lines, lines.lines[vote.line], last_.known[vote.known].origin);
        taken[vote.known] = 1;
    }
    for (std::uint32_t& number : number_)
        if (number == 0) number = ++next_.number;
}

void LineNumbers::keep(std::span<const LineFamily> families, std::span<const visibility::Subject> subjects,
                       const visibility::ImageLines& lines) {
    next_.families.clear();
    for (const LineFamily& family : families) next_.families.push_back(family);
    next_.known.clear();
    next_.place.resize(0);
    next_.direction.resize(0);
    for (std::int64_t l = 0; l < lines.lines.size(); ++l) {
        const visibility::Line& line = lines.lines[l];
        next_.known.push_back({line.subject, next_.place.size(), (line.pieces + kept_each - 1) / kept_each, number_[l],
                               point_of(subjects, lines, origin_[l]).position});
        for (std::int64_t p = line.first_piece; p < line.first_piece + line.pieces; p += kept_each) {
            next_.place.push_back(point_of(subjects, lines, p).position);
            next_.direction.push_back(point_of(subjects, lines, p).direction());
        }
    }
    std::swap(last_, next_);
}

void LineNumbers::run(std::span<const LineFamily> families, std::span<const visibility::Subject> subjects,
                      const visibility::ImageLines& lines) {
    number_.resize(lines.lines.size());
    origin_.resize(lines.lines.size());
    for (std::int64_t l = 0; l < lines.lines.size(); ++l) {
        number_[l] = 0;
        origin_[l] = lines.lines[l].first_piece;
    }
    base::Array<Vote> votes = count_votes(families, subjects, lines);
    give(votes, subjects, lines);
    keep(families, subjects, lines);
}

} // namespace hrbfnpr::frame
