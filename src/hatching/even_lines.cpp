// SPDX-License-Identifier: MIT
#include "hatching/even_lines.h"

#include "geometry/long_vec_array.h"
#include "geometry/point_grid.h"
#include "hatching/line_walk.h"

#include <array>
#include <cmath>
#include <cstdlib>

namespace hrbfnpr::hatching {
namespace {

// Lengths are in separations.  Points along a line:
constexpr double step = 0.5;
// Neighbours are looked for so far across, and on the same line so far along it.
constexpr double reach = 1.75;
constexpr double apart = 5.0;
// They run beside a line: cosines of the angles between normals, and between the ways across; and they are no farther
// off its tangent plane than this part of the way across, and a little.
constexpr double least_normal = 0.3;
constexpr double least_across = 0.7;
constexpr double steepest = 0.75;
constexpr double thickness = 0.1;
// Rounds of moves, neighbours being looked for before each, and in each of them steps of this share of the way to the
// middle; and how far a line moves in a round.
constexpr int rounds = 2;
constexpr int moves = 12;
constexpr double share_of_way = 0.8;
constexpr double farthest = 0.7;
// Moves of a line are averaged by exponential weights, twice to and fro: over some 2.7 separations.
constexpr float newest = 0.3F;
constexpr std::int64_t run_up = 16; // of such an average around a closed line
// An end is cut off where its neighbours are nearer to each other, or one of them to it; and a line that is shorter.
constexpr double narrowest = 1.3;
constexpr double nearest = 0.35;
constexpr double shortest = 3.0;
constexpr int smoothings = 2;
// No line turns within its surface by more than this in two separations, but by more than the second where its field
// does, around a singular point; in radians.  Rounds of moving points halfway to the middle of those beside them.
constexpr double most_turn = 0.40;
constexpr double singular_turn = 1.2;
constexpr std::int64_t turns_of_kink = 5; // at points, on two separations
constexpr int straightenings = 40;
constexpr std::int64_t lines_a_task = 16;
constexpr std::int64_t points_a_check = 512; // one look for a cancel

// Between two points of a line beside another.
struct Neighbour {
    std::int32_t from = -1, to = -1;
    float share = 0.0F; // of the way from one to the other
    float gap = 0.0F;   // separations
    float sense = 0.0F; // of its way across, against the other's: 1 or -1
};

struct Line {
    std::int64_t begin, end; // of its points; a closed one's first point follows its last one
    bool closed;
};

// Where points of lines that are left stand, for one round.
struct Places {
    Places(const geometry::VecArray& points, double radius, const base::Progress& progress)
        : grid(points, radius, progress), position(grid.in_order(points, progress)), next(points.memory()) {}

    geometry::PointGrid grid;
    geometry::VecArray position;    // in the grid's order
    base::Array<std::int32_t> next; // of each point: the one behind it, or -1
};

class Evener {
public:
    Evener(const base::Runtime& runtime, double separation, const base::Progress& progress)
        : runtime_(runtime), progress_(progress), separation_(separation), position_(runtime.memory),
          normal_(runtime.memory), across_(runtime.memory), level_(runtime.memory), line_of_(runtime.memory),
          line_(runtime.memory), neighbour_(runtime.memory), move_(runtime.memory), wanted_(runtime.memory) {}

    void sample(const StripeLines& lines);
    void find_neighbours();
    void cut_ends();
    void move();
    void straighten();
    [[nodiscard]] StripeLines result() const;

private:
    template <class Visit>
    void for_lines(Visit&& visit) const {
        runtime_.parallel.for_chunks(line_.size(), lines_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t l = begin; l < end; ++l) {
                progress_.check();
                if (line_[l].begin < line_[l].end) visit(line_[l]); // not what has been cut off
            }
        });
    }
    [[nodiscard]] bool is_left(std::int64_t i) const noexcept {
        return i >= line_[line_of_[i]].begin && i < line_[line_of_[i]].end;
    }
    // The next point, and the one before; -1 beyond an end.
    [[nodiscard]] std::int64_t after(const Line& line, std::int64_t i) const noexcept {
        return i + 1 < line.end ? i + 1 : line.closed ? line.begin : -1;
    }
    [[nodiscard]] std::int64_t before(const Line& line, std::int64_t i) const noexcept {
        return i > line.begin ? i - 1 : line.closed ? line.end - 1 : -1;
    }
    void smooth(const Line& line);
    void set_across(const Line& line);
    void look_around(const Places& places, std::int64_t i);
    [[nodiscard]] bool is_neighbour(std::int64_t i, std::int64_t j) const noexcept;
    [[nodiscard]] const Neighbour* beside(std::int64_t i, int side) const noexcept;
    [[nodiscard]] double gap(std::int64_t i, int side, const Neighbour& neighbour) const noexcept;
    [[nodiscard]] double way_to_middle(std::int64_t i) const noexcept;
    [[nodiscard]] bool is_crowded(std::int64_t i) const noexcept;
    void average(const Line& line);
    [[nodiscard]] double turn_at(const Line& line, std::int64_t i) const noexcept;
    bool mark_kinks(const Line& line);
    void straighten_kinks(const Line& line);

    const base::Runtime& runtime_;
    const base::Progress& progress_;
    double separation_;
    geometry::VecArray position_, normal_;
    geometry::VecArray across_; // unit, tangent
    base::Array<std::uint8_t> level_;
    base::Array<std::int32_t> line_of_;
    base::Array<Line> line_;
    base::Array<Neighbour> neighbour_; // two of each point: against the way across, and along it
    base::Array<float> move_, wanted_; // across, in separations; then whether a point is in a kink, and turns
};

void Evener::sample(const StripeLines& lines) {
    for (std::int64_t l = 0; l < lines.count(); ++l) {
        progress_.check();
        const LineWalk walk(lines, l);
        if (!(walk.length() >= shortest * separation_)) continue;
        const auto steps = static_cast<std::int64_t>(std::round(walk.length() / (step * separation_)));
        Line line{position_.size(), 0, lines.closed[l] != 0};
        line.end = line.begin + steps + (line.closed ? 0 : 1);
        walk.visit(steps, [&](const LinePlace& place) {
            if (position_.size() == line.end) return;
            geometry::push_back_long(position_, place.of(lines.position), progress_);
            geometry::push_back_long(normal_, glm::normalize(place.of(lines.normal)), progress_);
            level_.push_back(place.level(lines));
            line_of_.push_back(static_cast<std::int32_t>(line_.size()));
        });
        line_.push_back(line);
    }
    geometry::resize_long(across_, position_.size(), progress_);
    base::resize_long(neighbour_, 2 * position_.size(), progress_);
    base::resize_long(move_, position_.size(), progress_);
    base::resize_long(wanted_, position_.size(), progress_);
    for_lines([&](const Line& line) { smooth(line); });
}

// Points on a mesh's edges know their place to a part of its cells.
void Evener::smooth(const Line& line) {
    for (int round = 0; round < smoothings; ++round) {
        const glm::dvec3 first = position_[line.begin];
        glm::dvec3 last = line.closed ? position_[line.end - 1] : first;
        for (std::int64_t i = line.begin; i < line.end; ++i) {
            const glm::dvec3 here = position_[i];
            const glm::dvec3 next = i + 1 < line.end ? position_[i + 1] : first;
            if (before(line, i) >= 0 && after(line, i) >= 0) position_.set(i, 0.25 * last + 0.5 * here + 0.25 * next);
            last = here;
        }
    }
}

void Evener::set_across(const Line& line) {
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        const std::int64_t last = before(line, i);
        const std::int64_t next = after(line, i);
        const glm::dvec3 along = position_[next < 0 ? i : next] - position_[last < 0 ? i : last];
        const glm::dvec3 across = glm::cross(normal_[i], along);
        const double length = glm::length(across);
        across_.set(i, length > 0.0 ? across / length : glm::dvec3(0.0));
    }
}

void Evener::find_neighbours() {
    for_lines([&](const Line& line) { set_across(line); });
    Places places(position_, (reach + step) * separation_, progress_);
    base::fill_long(places.next, position_.size(), std::int32_t{-1}, progress_);
    for_lines([&](const Line& line) {
        for (std::int64_t i = line.begin; i < line.end; ++i) places.next[i] = static_cast<std::int32_t>(after(line, i));
    });
    for_lines([&](const Line& line) {
        for (std::int64_t i = line.begin; i < line.end; ++i) {
            if ((i - line.begin) % points_a_check == 0) progress_.check();
            look_around(places, i);
        }
    });
}

bool Evener::is_neighbour(std::int64_t i, std::int64_t j) const noexcept {
    if (line_of_[i] == line_of_[j]) {
        const Line& line = line_[line_of_[i]];
        std::int64_t way = std::abs(i - j);
        if (line.closed) way = std::min(way, line.end - line.begin - way);
        if (static_cast<double>(way) < apart / step) return false;
    }
    return glm::dot(normal_[i], normal_[j]) > least_normal && std::abs(glm::dot(across_[i], across_[j])) > least_across;
}

// Where the plane across the line at point i meets other lines, the nearest on either side.
void Evener::look_around(const Places& places, std::int64_t i) {
    const glm::dvec3 p = position_[i];
    const glm::dvec3 n = normal_[i];
    const glm::dvec3 across = across_[i];
    const glm::dvec3 along = glm::cross(across, n);
    std::array<Neighbour, 2> found{};
    for (Neighbour& none : found) none.gap = static_cast<float>(reach);
    places.grid.around(p, [&](std::int64_t at) {
        const glm::dvec3 way = places.position[at] - p;
        const double from = glm::dot(way, along);
        if (std::abs(from) > 2.0 * step * separation_) return;
        const std::int64_t j = places.grid.index(at);
        const std::int64_t next = places.next[j];
        if (next < 0) return;
        const glm::dvec3 next_way = position_[next] - p;
        const double to = glm::dot(next_way, along);
        if ((from > 0.0) == (to > 0.0) || !is_neighbour(i, j)) return;
        const double share = from / (from - to);
        const glm::dvec3 there = glm::mix(way, next_way, share);
        const double aside = glm::dot(there, across);
        const double height = glm::dot(there, n);
        const double slack = thickness * separation_;
        if (height * height > steepest * steepest * aside * aside + slack * slack) return;
        const auto size = static_cast<float>(std::abs(aside) / separation_);
        Neighbour& best = found[aside > 0.0 ? 1 : 0];
        if (size >= best.gap) return;
        best = {static_cast<std::int32_t>(j), static_cast<std::int32_t>(next), static_cast<float>(share), size,
                glm::dot(across_[j], across) > 0.0 ? 1.0F : -1.0F};
    });
    neighbour_[2 * i] = found[0];
    neighbour_[2 * i + 1] = found[1];
}

// None where there is none, or it has been cut off.
const Neighbour* Evener::beside(std::int64_t i, int side) const noexcept {
    const Neighbour& neighbour = neighbour_[2 * i + side];
    return neighbour.from >= 0 && is_left(neighbour.from) && is_left(neighbour.to) ? &neighbour : nullptr;
}

// After both lines' moves.
double Evener::gap(std::int64_t i, int side, const Neighbour& neighbour) const noexcept {
    const float there =
        neighbour.sense * ((1.0F - neighbour.share) * move_[neighbour.from] + neighbour.share * move_[neighbour.to]);
    const float wider = there - move_[i];
    return static_cast<double>(neighbour.gap + (side == 1 ? wider : -wider));
}

double Evener::way_to_middle(std::int64_t i) const noexcept {
    const Neighbour* const left = beside(i, 0);
    const Neighbour* const right = beside(i, 1);
    if (left == nullptr || right == nullptr) return 0.0;
    return 0.5 * (gap(i, 1, *right) - gap(i, 0, *left));
}

void Evener::average(const Line& line) {
    const std::int64_t count = line.end - line.begin;
    const std::int64_t before = line.closed ? std::min(run_up, count) : 0;
    float* const values = wanted_.data() + line.begin;
    const auto run = [&](auto&& at) {
        float mean = at(before == 0 ? 0 : count - before);
        for (std::int64_t i = count - before; i < count; ++i) mean += newest * (at(i) - mean);
        for (std::int64_t i = 0; i < count; ++i) at(i) = mean += newest * (at(i) - mean);
    };
    for (int twice = 0; twice < 2; ++twice) {
        run([&](std::int64_t i) -> float& { return values[i]; });
        run([&](std::int64_t i) -> float& { return values[count - 1 - i]; });
    }
}

void Evener::move() {
    std::fill(move_.begin(), move_.end(), 0.0F);
    for (int k = 0; k < moves; ++k) {
        for_lines([&](const Line& line) {
            for (std::int64_t i = line.begin; i < line.end; ++i)
                wanted_[i] = static_cast<float>(share_of_way * std::clamp(way_to_middle(i), -0.5, 0.5));
            average(line);
        });
        for_lines([&](const Line& line) {
            for (std::int64_t i = line.begin; i < line.end; ++i) move_[i] += wanted_[i];
        });
    }
    for_lines([&](const Line& line) {
        for (std::int64_t i = line.begin; i < line.end; ++i)
            position_.set(i, position_[i] + std::clamp(static_cast<double>(move_[i]), -farthest, farthest) *
                                                separation_ * across_[i]);
    });
}

// In the tangent plane, from the leg before the point to the one behind it.
double Evener::turn_at(const Line& line, std::int64_t i) const noexcept {
    const std::int64_t last = before(line, i);
    const std::int64_t next = after(line, i);
    if (last < 0 || next < 0) return 0.0;
    const glm::dvec3 n = normal_[i];
    const glm::dvec3 from = position_[i] - position_[last];
    const glm::dvec3 to = position_[next] - position_[i];
    return std::atan2(glm::dot(glm::cross(from, to), n), glm::dot(from, to) - glm::dot(from, n) * glm::dot(to, n));
}

// Wherever a part of two separations turns too much, for all parts that begin at a point.
bool Evener::mark_kinks(const Line& line) {
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        wanted_[i] = static_cast<float>(turn_at(line, i));
        move_[i] = 0.0F;
    }
    bool any = false;
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        double turn = 0.0;
        double most = 0.0;
        std::int64_t j = i;
        for (std::int64_t k = 0; k < turns_of_kink && j >= 0; ++k, j = after(line, j)) {
            turn += static_cast<double>(wanted_[j]);
            most = std::max(most, std::abs(turn));
        }
        if (most <= most_turn || most > singular_turn) continue;
        any = true;
        j = i;
        for (std::int64_t k = 0; k < turns_of_kink && j >= 0; ++k, j = after(line, j)) move_[j] = 1.0F;
    }
    return any;
}

void Evener::straighten_kinks(const Line& line) {
    for (int round = 0; round < straightenings && mark_kinks(line); ++round) {
        set_across(line);
        const glm::dvec3 first = position_[line.begin];
        glm::dvec3 last = line.closed ? position_[line.end - 1] : first;
        for (std::int64_t i = line.begin; i < line.end; ++i) {
            const glm::dvec3 here = position_[i];
            const glm::dvec3 next = i + 1 < line.end ? position_[i + 1] : first;
            if (move_[i] > 0.0F && before(line, i) >= 0 && after(line, i) >= 0)
                position_.set(i, here + 0.5 * glm::dot(0.5 * (last + next) - here, across_[i]) * across_[i]);
            last = here;
        }
    }
}

void Evener::straighten() {
    for_lines([&](const Line& line) { straighten_kinks(line); });
}

bool Evener::is_crowded(std::int64_t i) const noexcept {
    const Neighbour* const left = beside(i, 0);
    const Neighbour* const right = beside(i, 1);
    const auto is_near = [](const Neighbour* n) { return n != nullptr && static_cast<double>(n->gap) < nearest; };
    return is_near(left) || is_near(right) ||
           (left != nullptr && right != nullptr && static_cast<double>(left->gap + right->gap) < narrowest);
}

// One line after the other: what has been cut off crowds no other line.
void Evener::cut_ends() {
    for (Line& line : line_) {
        progress_.check();
        if (line.closed) continue;
        while (line.begin < line.end && is_crowded(line.begin)) ++line.begin;
        while (line.begin < line.end && is_crowded(line.end - 1)) --line.end;
        if (static_cast<double>(line.end - 1 - line.begin) * step < shortest) line.end = line.begin;
    }
}

StripeLines Evener::result() const {
    StripeLines lines(runtime_.memory);
    for (const Line& line : line_) {
        progress_.check();
        if (line.begin == line.end) continue;
        for (std::int64_t i = line.begin; i < line.end; ++i) {
            geometry::push_back_long(lines.position, position_[i], progress_);
            geometry::push_back_long(lines.normal, normal_[i], progress_);
            base::push_back_long(lines.level, level_[i], progress_);
        }
        lines.first.push_back(lines.position.size());
        lines.closed.push_back(line.closed ? 1 : 0);
    }
    return lines;
}

} // namespace

StripeLines evened(const base::Runtime& runtime, const StripeLines& lines, double separation,
                   const base::Progress& progress) {
    Evener evener(runtime, separation, progress);
    evener.sample(lines);
    for (int round = 0; round < rounds; ++round) {
        evener.find_neighbours();
        if (round > 0) evener.cut_ends();
        evener.move();
    }
    evener.straighten();
    return evener.result();
}

} // namespace hrbfnpr::hatching
