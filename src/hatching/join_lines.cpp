// SPDX-License-Identifier: MIT
#include "hatching/join_lines.h"

#include "base/sort.h"
#include "geometry/point_grid.h"

#include <algorithm>

namespace hrbfnpr::hatching {
namespace {

// Cosine of the angle between a line's end, and that of the other, and the way from one to the other.
constexpr double straight = 0.95;
// Over so small a part of the widest gap the way across says nothing, and the ends' directions not all.
constexpr double touching = 0.2;
constexpr double straight_enough = 0.8;
// An end's direction is told by points of the line up to this part of the widest gap away, three at least: nearer ones
// know their place to a part of the mesh's cells.
constexpr double back = 0.5;
constexpr std::int64_t fewest_back = 3;
constexpr std::int64_t ends_a_check = 256;

// End 2 l is the begin of line l, 2 l + 1 its end.
class Joiner {
public:
    Joiner(base::Memory& memory, const StripeLines& lines, double reach)
        : memory_(memory), lines_(lines), place_(memory), way_(memory), partner_(memory, 2 * lines.count()),
          taken_(memory, lines.count()) {
        std::fill(partner_.begin(), partner_.end(), -1);
        for (std::int64_t l = 0; l < lines.count(); ++l)
            for (const bool end : {false, true}) {
                const std::int64_t at = end ? lines.first[l + 1] - 1 : lines.first[l];
                const std::int64_t last = end ? lines.first[l] : lines.first[l + 1] - 1; // the other one
                const std::int64_t step = end ? -1 : 1;
                std::int64_t from = at;
                while (from != last && ((from - at) * step < fewest_back ||
                                        glm::distance(lines.position[from], lines.position[at]) < back * reach))
                    from += step;
                place_.push_back(lines.position[at]);
                way_.push_back(glm::normalize(lines.position[at] - lines.position[from]));
            }
    }

    void find(double reach, const base::Progress& progress);
    [[nodiscard]] StripeLines join(const base::Progress& progress);

private:
    struct Pair {
        double distance;
        std::int64_t a, b;
    };

    [[nodiscard]] bool faces(std::int64_t a, std::int64_t b, double reach) const noexcept;
    void add(std::int64_t line, bool reversed, StripeLines& result) const;
    void follow(std::int64_t from, StripeLines& result, const base::Progress& progress);

    base::Memory& memory_;
    const StripeLines& lines_;
    geometry::VecArray place_, way_; // of each end, and outwards
    base::Array<std::int64_t> partner_;
    base::Array<std::uint8_t> taken_;
};

bool Joiner::faces(std::int64_t a, std::int64_t b, double reach) const noexcept {
    const glm::dvec3 gap = place_[b] - place_[a];
    const double length = glm::length(gap);
    if (length < touching * reach) return glm::dot(way_[a], way_[b]) < -straight_enough;
    return length <= reach && glm::dot(way_[a], gap) > straight * length && glm::dot(way_[b], gap) < -straight * length;
}

// The nearest first.
void Joiner::find(double reach, const base::Progress& progress) {
    const geometry::PointGrid grid(place_, reach, progress);
    base::Array<Pair> pairs(memory_);
    for (std::int64_t a = 0; a < place_.size(); ++a) {
        if (a % ends_a_check == 0) progress.check();
        if (lines_.closed[a / 2] != 0) continue;
        grid.around(place_[a], [&](std::int64_t at) {
            const std::int64_t b = grid.index(at);
            if (b <= a || b / 2 == a / 2 || lines_.closed[b / 2] != 0 || !faces(a, b, reach)) return;
            pairs.push_back({glm::distance(place_[a], place_[b]), a, b});
        });
    }
    base::sort_long(
        pairs.begin(), pairs.end(),
        [](const Pair& x, const Pair& y) {
            if (x.distance != y.distance) return x.distance < y.distance;
            return x.a != y.a ? x.a < y.a : x.b < y.b;
        },
        progress);
    for (const Pair& pair : pairs) {
        if (partner_[pair.a] >= 0 || partner_[pair.b] >= 0) continue;
        partner_[pair.a] = pair.b;
        partner_[pair.b] = pair.a;
    }
}

void Joiner::add(std::int64_t line, bool reversed, StripeLines& result) const {
    const std::int64_t begin = lines_.first[line];
    const std::int64_t count = lines_.first[line + 1] - begin;
    const auto place_of = [&](std::int64_t i) { return begin + (reversed ? count - 1 - i : i); };
    std::int64_t before = 0;
    // Where ends lie beside each other, or one beyond the other, nothing goes back.
    if (const std::int64_t size = result.position.size(); size > result.first[result.first.size() - 1]) {
        const glm::dvec3 last = result.position[size - 1];
        const glm::dvec3 onwards = -way_[2 * line + (reversed ? 1 : 0)];
        while (before + 2 < count && glm::dot(lines_.position[place_of(before)] - last, onwards) <= 0.0) ++before;
    }
    for (std::int64_t i = before; i < count; ++i) {
        const std::int64_t at = place_of(i);
        result.position.push_back(lines_.position[at]);
        result.normal.push_back(lines_.normal[at]);
        result.level.push_back(lines_.level[at]);
    }
}

// From this end into its line, and on.
void Joiner::follow(std::int64_t from, StripeLines& result, const base::Progress& progress) {
    std::int64_t entry = from;
    bool closed = lines_.closed[from / 2] != 0;
    while (true) {
        progress.check();
        taken_[entry / 2] = 1;
        add(entry / 2, entry % 2 != 0, result);
        const std::int64_t next = partner_[entry ^ 1];
        closed = closed || next == from;
        if (next < 0 || taken_[next / 2] != 0) break;
        entry = next;
    }
    result.first.push_back(result.position.size());
    result.closed.push_back(closed ? 1 : 0);
}

StripeLines Joiner::join(const base::Progress& progress) {
    StripeLines result(memory_);
    for (const bool free : {true, false})
        for (std::int64_t end = 0; end < place_.size(); ++end) {
            if (end % ends_a_check == 0) progress.check();
            if (taken_[end / 2] == 0 && (!free || (partner_[end] < 0 && lines_.closed[end / 2] == 0)))
                follow(end, result, progress);
        }
    return result;
}

} // namespace

StripeLines joined(base::Memory& memory, const StripeLines& lines, double reach, const base::Progress& progress) {
    Joiner joiner(memory, lines, reach);
    joiner.find(reach, progress);
    return joiner.join(progress);
}

} // namespace hrbfnpr::hatching
