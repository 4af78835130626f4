// SPDX-License-Identifier: MIT
// Points of each line vote for the line of the last frame that has the nearest point of the same direction
// (count_votes); lines with most points in common are one, and the points by which all are known again are kept (run).
#include "frame/lines/line_numbers.h"

#include "base/assert.h"
#include "frame/lines/tuning.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace hrbfnpr::frame {
namespace {

const curves::CurvePoint& point_of(std::span<const visibility::Subject> subjects, const visibility::ImageLines& lines,
                                   std::int64_t piece) noexcept {
    const visibility::Piece& its = lines.pieces[piece];
    return visibility::subject_of(subjects, its).curves->point[its.a];
}

} // namespace

base::Array<LineNumbers::Vote> LineNumbers::count_votes(const base::Array<Family>& families,
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
            const Known& known = last_.known[k];
            if (!(known.family == families[static_cast<std::int64_t>(subject)])) continue;
            for (std::int64_t i = known.first; i < known.first + known.count; ++i) {
                place.push_back(last_.place[i]);
                direction.push_back(last_.direction[i]);
                owner.push_back(k);
            }
        }
        if (place.empty()) continue;
        const double radius = line_tuning.farthest_number * subjects[subject].side;
        const geometry::PointGrid grid(place, radius);
        for (std::int64_t l = 0; l < lines.lines.size(); ++l) {
            const visibility::Line& line = lines.lines[l];
            if (static_cast<std::size_t>(line.subject) != subject) continue;
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
            for (std::int64_t k = 0; k < last_.known.size(); ++k)
                if (const std::int64_t points = std::exchange(of_line[k], 0); points > 0)
                    votes.push_back({l, k, points * step});
        }
    }
    return votes;
}

void LineNumbers::run(std::span<const visibility::Subject> subjects, std::span<const visibility::Occluder> occluders,
                      const visibility::ImageLines& lines) {
    base::Memory& memory = last_.known.memory();
    base::Array<Family> families(memory);
    base::Array<std::int64_t> of_item(memory, static_cast<std::int64_t>(occluders.size()));
    for (const visibility::Subject& subject : subjects) {
        HRBFNPR_ASSERT(subject.item >= 0 && subject.item < of_item.size());
        families.push_back(
            {occluders[static_cast<std::size_t>(subject.item)].sheets, subject.item, of_item[subject.item]++});
    }
    const auto position = [&](std::int64_t piece) { return point_of(subjects, lines, piece).position; };
    number_.clear();
    number_.resize(lines.lines.size());
    origin_.clear();
    for (const visibility::Line& line : lines.lines) origin_.push_back(line.first_piece);
    base::Array<Vote> votes = count_votes(families, subjects, lines);
    std::sort(votes.begin(), votes.end(), [](const Vote& a, const Vote& b) {
        return std::tie(b.points, a.line, a.known) < std::tie(a.points, b.line, b.known);
    });
    base::Array<std::uint8_t> taken(memory, last_.known.size());
    for (const Vote& vote : votes) {
        if (number_[vote.line] != 0 || taken[vote.known] != 0) continue;
        const Known& known = last_.known[vote.known];
        number_[vote.line] = known.number;
        taken[vote.known] = 1;
        std::int64_t& origin = origin_[vote.line];
        const visibility::Line& line = lines.lines[vote.line];
        double least = glm::distance(position(origin), known.origin);
        for (std::int64_t p = line.first_piece + 1; p < line.first_piece + line.pieces; ++p)
            if (const double distance = glm::distance(position(p), known.origin); distance < least) {
                least = distance;
                origin = p;
            }
    }
    next_.number = last_.number;
    next_.known.clear();
    next_.place.resize(0);
    next_.direction.resize(0);
    for (std::int64_t l = 0; l < lines.lines.size(); ++l) {
        const visibility::Line& line = lines.lines[l];
        if (number_[l] == 0) number_[l] = ++next_.number;
        const std::int64_t first = next_.place.size();
        for (std::int64_t p = line.first_piece; p < line.first_piece + line.pieces; p += line_tuning.kept_each) {
            next_.place.push_back(position(p));
            next_.direction.push_back(point_of(subjects, lines, p).direction());
        }
        next_.known.push_back(
            {families[line.subject], first, next_.place.size() - first, number_[l], position(origin_[l])});
    }
    std::swap(last_, next_);
}

} // namespace hrbfnpr::frame
