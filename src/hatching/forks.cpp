// SPDX-License-Identifier: MIT
#include "hatching/forks.h"

#include "base/long_array.h"
#include "geometry/point_grid.h"
#include "hatching/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::hatching {
namespace {

// A place on a line.
struct Place {
    std::int64_t from = -1; // the point before it
    glm::dvec3 position{0.0}, normal{0.0};
};

// Continues ends of lines.
class Continuation {
public:
    Continuation(const base::Work& work, const Lines& lines, const LineNeighbours& neighbours, double separation)
        : lines_(lines), neighbours_(neighbours), separation_(separation), next_(work.memory), end_(work.memory),
          grid_(ends(work), 2.0 * reach(), work) {}

    struct Points {
        geometry::VecArray position, normal;
    };
    // Sets `added` to the points beyond an end of line l: its first point, or its last one.
    void operator()(std::int64_t l, bool at_begin, Points& added) const {
        added.position.clear();
        added.normal.clear();
        const std::int64_t end = at_begin ? lines_.first[l] : lines_.first[l + 1] - 1;
        const std::int64_t inner = at_begin ? end + 1 : end - 1;
        std::array<std::int64_t, 2> beside = {neighbours_[end][0].from, neighbours_[end][1].from};
        if (beside[0] < 0 || beside[1] < 0) return;
        glm::dvec3 last = lines_.position[end];
        glm::dvec3 way = glm::normalize(last - lines_.position[inner]);
        const double step = hatching_tuning.even_step * separation_;
        for (double length = step; length <= reach(); length += step) {
            std::array<Place, 2> place;
            for (const std::size_t side : {0U, 1U}) {
                place[side] = crossing(beside[side], last + step * way, way);
                beside[side] = place[side].from;
                if (beside[side] < 0) return;
            }
            const double room = glm::distance(place[0].position, place[1].position) / separation_;
            const glm::dvec3 here = 0.5 * (place[0].position + place[1].position);
            const glm::dvec3 normal = glm::normalize(place[0].normal + place[1].normal);
            if (!(room > hatching_tuning.least_room && room < hatching_tuning.most_room) ||
                faces_an_end(end, here, way, length))
                return;
            const glm::dvec3 leg = here - last;
            if (!(glm::dot(leg, way) > hatching_tuning.parallel_cosine * glm::length(leg))) return;
            way = glm::normalize(leg);
            last = here;
            added.position.push_back(here);
            added.normal.push_back(normal);
        }
    }

private:
    [[nodiscard]] double reach() const noexcept { return hatching_tuning.longest_fork * separation_; }

    // Returns the places of all open ends, and fills next_ and end_.
    [[nodiscard]] geometry::VecArray ends(const base::Work& work) {
        geometry::VecArray places(work.memory);
        base::resize_long(next_, lines_.position.size(), work);
        for (std::int64_t l = 0; l < lines_.count(); ++l) {
            const std::int64_t first = lines_.first[l];
            const std::int64_t last = lines_.first[l + 1] - 1;
            for (std::int64_t i = first; i < last; ++i) next_[i] = i + 1;
            next_[last] = lines_.closed[l] != 0 ? first : -1;
            if (lines_.closed[l] != 0) continue;
            for (const std::int64_t end : {first, last}) {
                places.push_back(lines_.position[end]);
                end_.push_back(end);
            }
        }
        return places;
    }
    // Returns the place near point `from` where its line crosses the plane at p across `way`.
    [[nodiscard]] Place crossing(std::int64_t from, const glm::dvec3& p, const glm::dvec3& way) const {
        const auto ahead = [&](std::int64_t i) { return glm::dot(lines_.position[i] - p, way); };
        for (const std::int64_t turn : {1, -1}) {
            std::int64_t i = from;
            for (int k = 0; k < hatching_tuning.followed_points && i >= 0 && next_[i] >= 0; ++k) {
                const double here = ahead(i);
                const double there = ahead(next_[i]);
                if ((here > 0.0) != (there > 0.0)) {
                    const double share = here / (here - there);
                    return {i, glm::mix(lines_.position[i], lines_.position[next_[i]], share),
                            glm::mix(lines_.normal[i], lines_.normal[next_[i]], share)};
                }
                i = turn > 0 ? next_[i] : (i > 0 && next_[i - 1] == i ? i - 1 : -1);
            }
        }
        return {};
    }
    // Returns whether another end is ahead of a place, so near that both lines would meet if both were continued.
    [[nodiscard]] bool faces_an_end(std::int64_t own, const glm::dvec3& place, const glm::dvec3& way,
                                    double length) const {
        bool faces = false;
        grid_.around(place, [&](std::int64_t at) {
            const std::int64_t end = end_[grid_.index(at)];
            const glm::dvec3 to = lines_.position[end] - place;
            const double distance = glm::length(to);
            faces = faces || (end != own && distance < length + hatching_tuning.least_room * separation_ &&
                              glm::dot(to, way) > hatching_tuning.parallel_cosine * distance);
        });
        return faces;
    }

    const Lines& lines_;
    const LineNeighbours& neighbours_;
    double separation_;
    base::Array<std::int64_t> next_; // for each point: the next point of its line, or -1
    base::Array<std::int64_t> end_;  // the points that are open ends
    geometry::PointGrid grid_;       // The grid contains the ends.
};

} // namespace

base::Array<std::uint8_t> find_strays(const base::Work& work, const Lines& lines, const LineNeighbours& neighbours,
                                      double shortest) {
    HRBFNPR_ASSERT(neighbours.size() == lines.position.size());
    base::Array<std::uint8_t> stray(work.memory, lines.count());
    for (std::int64_t l = 0; l < lines.count(); ++l) {
        const std::int64_t first = lines.first[l];
        const std::int64_t last = lines.first[l + 1] - 1;
        if (lines.border[l] != (Lines::begins_at_border | Lines::ends_at_border)) continue;
        double length = 0.0;
        for (std::int64_t i = first; i < last; ++i) length += glm::distance(lines.position[i], lines.position[i + 1]);
        if (length >= shortest) continue;
        for (std::int64_t i = first; i <= last; ++i)
            for (const Neighbour& side : neighbours[i])
                if (side.from >= 0 && side.gap < hatching_tuning.nearest_across_face) stray[l] = 1;
    }
    return stray;
}

Lines continue_into_forks(const base::Work& work, const Lines& lines, const LineNeighbours& neighbours,
                          const base::Array<std::uint8_t>& stray, double separation) {
    HRBFNPR_ASSERT(neighbours.size() == lines.position.size() && separation > 0.0);
    const Continuation beyond(work, lines, neighbours, separation);
    Lines result(work.memory);
    Continuation::Points added{geometry::VecArray(work.memory), geometry::VecArray(work.memory)};
    for (std::int64_t l = 0; l < lines.count(); ++l) {
        const std::int64_t first = lines.first[l];
        const std::int64_t last = lines.first[l + 1] - 1;
        const bool open = lines.closed[l] == 0 && last > first;
        if (stray[l] != 0) continue;
        if (open && (lines.border[l] & Lines::begins_at_border) == 0) {
            beyond(l, true, added);
            for (std::int64_t k = added.position.size(); k-- > 0;)
                result.add_point(added.position[k], added.normal[k], lines.level[first], work);
        }
        for (std::int64_t i = first; i <= last; ++i)
            result.add_point(lines.position[i], lines.normal[i], lines.level[i], work);
        if (open && (lines.border[l] & Lines::ends_at_border) == 0) {
            beyond(l, false, added);
            for (std::int64_t k = 0; k < added.position.size(); ++k)
                result.add_point(added.position[k], added.normal[k], lines.level[last], work);
        }
        result.end_line(lines.closed[l] != 0, lines.border[l]);
    }
    return result;
}

} // namespace hrbfnpr::hatching
