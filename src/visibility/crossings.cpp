// SPDX-License-Identifier: MIT
#include "visibility/crossings.h"

#include "base/list.h"
#include "visibility/meeting.h"
#include "visibility/verify_crossings.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::visibility {
namespace {

constexpr double cell_side = 4.0; // pixels, at least
// Crossings for each segment of a cell: where there are more, lines run to and fro over one another within a pixel, as
// contours on a flat face that is seen edge-on do.  Nobody sees these crossings, and there may be millions.
constexpr std::int64_t most_of_segment = 16;
constexpr std::int64_t most_segments = 4096; // of a cell that pairs are looked for in
constexpr double most_cells = 1.0e6;         // of the grid
constexpr double grid_end = 1.0e4;           // pixels from the image's corner: its last cells hold all that lies beyond
constexpr std::int64_t cells_a_task = 4096;
constexpr std::int64_t pairs_a_task = 16;
constexpr int most_steps = 20;      // of Newton's
constexpr double known = 1e-10;     // shares of a piece
constexpr double same_place = 1e-7; // the same
constexpr double slack = 1e-8;      // beyond the ends of a piece before the next one is taken
// In sides: curves that come nearer are the same; and a line does not cross itself nearer to where it turns back.
constexpr double nearest_gap = 1e-5;
constexpr double smallest_loop = 0.02;
constexpr double touching = 0.05;

// Of segments of the image, each from a point to the next.
struct Grid {
    explicit Grid(base::Memory& memory) noexcept : begin(memory), segment(memory) {}

    // Of a place in cells from the origin.
    [[nodiscard]] std::int64_t column(double x) const noexcept { return within(x, columns); }
    [[nodiscard]] std::int64_t row(double y) const noexcept { return within(y, rows); }
    [[nodiscard]] static std::int64_t within(double at, std::int64_t count) noexcept {
        return static_cast<std::int64_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
    }

    glm::dvec2 origin{0.0};
    double side = cell_side;
    std::int64_t columns = 1, rows = 1;
    base::Array<std::int64_t> begin; // of each cell in `segment`, and the end
    base::Array<std::int64_t> segment;
};

bool before(const Crossing& a, const Crossing& b) noexcept {
    if (a.far_piece != b.far_piece) return a.far_piece < b.far_piece;
    if (a.far_share != b.far_share) return a.far_share < b.far_share;
    if (a.near_piece != b.near_piece) return a.near_piece < b.near_piece;
    return a.near_share < b.near_share;
}

class Finder {
public:
    Finder(const base::Runtime& runtime, std::span<const Subject> subjects, const ImageLines& lines)
        : runtime_(runtime), subjects_(subjects), lines_(lines), ends_line_(runtime.memory), grid_(runtime.memory),
          found_(runtime.memory) {
        ends_line_.resize(lines.points.size());
        for (const Line& line : lines.lines) ends_line_[line.first_point + line.points - 1] = 1;
        make_grid();
    }

    void run(CrossingReport& report, const base::Progress& progress);
    [[nodiscard]] base::Array<Crossing> result() && { return std::move(found_); }

private:
    struct Pair {
        std::int64_t a, b;
    };

    [[nodiscard]] bool is_segment(std::int64_t point) const noexcept { return ends_line_[point] == 0; }
    [[nodiscard]] const glm::dvec2& place(std::int64_t point) const noexcept { return lines_.points[point].place; }
    [[nodiscard]] const Subject& subject_of(std::int32_t piece) const noexcept {
        return subjects_[static_cast<std::size_t>(lines_.pieces[piece].subject)];
    }
    [[nodiscard]] bool hides(std::int64_t segment) const noexcept {
        return subject_of(lines_.points[segment].piece).sheets > 0;
    }
    void make_grid();
    [[nodiscard]] base::Array<Pair> find_pairs(CrossingReport& report, const base::Progress& progress) const;
    template <class F>
    void for_cells(std::int64_t segment, const F& f) const;
    [[nodiscard]] bool in_cell(std::int64_t cell, base::Array<Pair>& pairs) const;
    // Whether one begins where the other ends, on one line.
    [[nodiscard]] bool follow(std::int64_t a, std::int64_t b) const noexcept {
        if (place(a + 1) != place(b) && place(b + 1) != place(a)) return false;
        return lines_.pieces[lines_.points[a].piece].line == lines_.pieces[lines_.points[b].piece].line;
    }
    [[nodiscard]] bool crosses(std::int64_t a, std::int64_t b) const noexcept;
    [[nodiscard]] glm::dvec2 crossing_of(std::int64_t a, std::int64_t b) const noexcept;
    struct OnLine {
        std::int32_t piece;
        double share;
    };
    // A crossing of segments, and what it stands for.
    struct Found {
        Crossing exact, rough; // of the cubics, by Newton's steps, and of the segments
        bool converged, same;  // the exact one crosses the same way as the segments do
    };
    [[nodiscard]] bool refine(OnLine& a, OnLine& b) const noexcept;
    [[nodiscard]] bool describe(const OnLine& a, const OnLine& b, double turn, Crossing& crossing) const noexcept;
    [[nodiscard]] bool look_at(const Pair& pair, Found& found) const noexcept;
    void take(base::Array<Found>& all, CrossingReport& report);
    void take_group(std::span<const Found> group, CrossingReport& report);
    [[nodiscard]] double nearest_allowed(const OnLine& a, const OnLine& b) const noexcept;
    [[nodiscard]] OnLine place_on(std::int64_t segment, double t) const noexcept;
    [[nodiscard]] Moving at(const OnLine& place) const noexcept;
    void go(OnLine& place, double by) const noexcept;

    const base::Runtime& runtime_;
    std::span<const Subject> subjects_;
    const ImageLines& lines_;
    base::Array<std::uint8_t> ends_line_; // 1: no segment begins at the point
    Grid grid_;
    base::Array<Crossing> found_;
};

template <class F>
void Finder::for_cells(std::int64_t segment, const F& f) const {
    const glm::dvec2 low = (glm::min(place(segment), place(segment + 1)) - grid_.origin) / grid_.side;
    const glm::dvec2 high = (glm::max(place(segment), place(segment + 1)) - grid_.origin) / grid_.side;
    for (std::int64_t r = grid_.row(low.y); r <= grid_.row(high.y); ++r)
        for (std::int64_t c = grid_.column(low.x); c <= grid_.column(high.x); ++c) f(r * grid_.columns + c);
}

void Finder::make_grid() {
    glm::dvec2 low(std::numeric_limits<double>::infinity());
    glm::dvec2 high(-std::numeric_limits<double>::infinity());
    for (const ImagePoint& p : lines_.points) {
        low = glm::min(low, p.place);
        high = glm::max(high, p.place);
    }
    if (lines_.points.empty()) low = high = glm::dvec2(0.0);
    low = glm::clamp(low, -grid_end, grid_end);
    high = glm::clamp(high, -grid_end, grid_end);
    const glm::dvec2 size = high - low;
    grid_.origin = low;
    grid_.side = std::max(cell_side, std::sqrt(size.x * size.y / most_cells));
    grid_.columns = static_cast<std::int64_t>(size.x / grid_.side) + 1;
    grid_.rows = static_cast<std::int64_t>(size.y / grid_.side) + 1;
    grid_.begin.resize(grid_.columns * grid_.rows + 1);
    const std::int64_t segments = lines_.points.size();
    for (std::int64_t s = 0; s < segments; ++s)
        if (is_segment(s)) for_cells(s, [&](std::int64_t cell) { ++grid_.begin[cell + 1]; });
    for (std::int64_t cell = 0; cell + 1 < grid_.begin.size(); ++cell) grid_.begin[cell + 1] += grid_.begin[cell];
    grid_.segment.resize(grid_.begin[grid_.begin.size() - 1]);
    base::Array<std::int64_t> at(runtime_.memory);
    for (const std::int64_t begin : grid_.begin) at.push_back(begin);
    for (std::int64_t s = 0; s < segments; ++s)
        if (is_segment(s)) for_cells(s, [&](std::int64_t cell) { grid_.segment[at[cell]++] = s; });
}

// Each end of one is on another side of the other; on the line counts as left of it, so that of two segments with a
// common end a third one crosses one.
bool Finder::crosses(std::int64_t a, std::int64_t b) const noexcept {
    const glm::dvec2 p = place(a);
    const glm::dvec2 q = place(a + 1);
    const glm::dvec2 r = place(b);
    const glm::dvec2 s = place(b + 1);
    const auto left = [](const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& at) {
        return cross2(to - from, at - from) >= 0.0;
    };
    return left(p, q, r) != left(p, q, s) && left(r, s, p) != left(r, s, q);
}

// As shares of both.
glm::dvec2 Finder::crossing_of(std::int64_t a, std::int64_t b) const noexcept {
    const glm::dvec2 d = place(a + 1) - place(a);
    const glm::dvec2 e = place(b + 1) - place(b);
    const glm::dvec2 way = place(b) - place(a);
    const double area = cross2(d, e);
    if (area == 0.0) return glm::dvec2(0.5);
    return {cross2(way, e) / area, cross2(way, d) / area};
}

// A pair that meets in several cells is found in that of its crossing only.  Returns false, and adds none, where there
// is a tangle.
bool Finder::in_cell(std::int64_t cell, base::Array<Pair>& pairs) const {
    const std::int64_t segments = grid_.begin[cell + 1] - grid_.begin[cell];
    if (segments > most_segments) return false;
    const std::int64_t first = pairs.size();
    const std::int64_t most = first + most_of_segment * segments;
    for (std::int64_t i = grid_.begin[cell]; i < grid_.begin[cell + 1]; ++i) {
        if (pairs.size() > most) {
            pairs.resize(first);
            return false;
        }
        for (std::int64_t j = i + 1; j < grid_.begin[cell + 1]; ++j) {
            const std::int64_t a = grid_.segment[i];
            const std::int64_t b = grid_.segment[j];
            if (lines_.points[a].piece == lines_.points[b].piece || follow(a, b) || (!hides(a) && !hides(b)) ||
                !crosses(a, b))
                continue;
            const glm::dvec2 at = place(a) + std::clamp(crossing_of(a, b).x, 0.0, 1.0) * (place(a + 1) - place(a));
            const glm::dvec2 in = (at - grid_.origin) / grid_.side;
            if (grid_.row(in.y) * grid_.columns + grid_.column(in.x) == cell) pairs.push_back({a, b});
        }
    }
    return true;
}

// Newton's steps on the cubics themselves.
bool Finder::refine(OnLine& a, OnLine& b) const noexcept {
    for (int step = 0;; ++step) {
        const auto [da, db] = meeting(at(a), at(b));
        if (!(std::abs(da) <= 1.0 && std::abs(db) <= 1.0) || step == most_steps) return false;
        if (std::abs(da) <= known && std::abs(db) <= known) return true;
        go(a, da);
        go(b, db);
    }
}

// turn: of the image directions from the first to the second; > 0 clockwise, as seen.  Where the curves are one, as
// beside a cusp, they do not cross.
bool Finder::describe(const OnLine& a, const OnLine& b, double turn, Crossing& crossing) const noexcept {
    const Moving p = at(a);
    const Moving q = at(b);
    const Subject& sa = subject_of(a.piece);
    const Subject& sb = subject_of(b.piece);
    // Along the common line of sight.
    const glm::dvec3 world_p(sa.to_world * glm::dvec4(p.point, 1.0));
    const glm::dvec3 world_q(sb.to_world * glm::dvec4(q.point, 1.0));
    const glm::dvec3 sight = glm::dmat3(sa.to_world) * sa.view.sight(p.point);
    const bool second_far = glm::dot(world_q - world_p, sight) > 0.0;
    const double side = sa.side * glm::length(sight) / glm::length(sa.view.sight(p.point));
    crossing.gap = glm::distance(world_p, world_q) / side;
    if (!(crossing.gap > nearest_allowed(a, b))) return false;
    const OnLine& far = second_far ? b : a;
    const OnLine& near = second_far ? a : b;
    const Subject& near_one = second_far ? sa : sb;
    // With y up the nearer surface lies to the left of its contour.
    const bool to_left = second_far ? turn < 0.0 : turn > 0.0;
    const bool left = to_left != (near_one.mirrored != shows_inside(subjects_, lines_.pieces[near.piece]));
    const std::int32_t sign = left ? 1 : -1;
    crossing.far_piece = far.piece;
    crossing.near_piece = near.piece;
    crossing.far_share = std::clamp(far.share, 0.0, 1.0);
    crossing.near_share = std::clamp(near.share, 0.0, 1.0);
    crossing.change = sign * near_one.sheets;
    crossing.place = p.place;
    crossing.sine = std::abs(cross2(p.velocity, q.velocity)) / (glm::length(p.velocity) * glm::length(q.velocity));
    return true;
}

// Returns whether there is a crossing at all.
bool Finder::look_at(const Pair& pair, Found& found) const noexcept {
    const glm::dvec2 start = crossing_of(pair.a, pair.b);
    OnLine a = place_on(pair.a, start.x);
    OnLine b = place_on(pair.b, start.y);
    const double turn = cross2(place(pair.a + 1) - place(pair.a), place(pair.b + 1) - place(pair.b));
    const bool apart = describe(a, b, turn, found.rough);
    found.converged = refine(a, b);
    if (!found.converged) return apart;
    const double exact_turn = cross2(at(a).velocity, at(b).velocity);
    found.same = (exact_turn > 0.0) == (turn > 0.0);
    return describe(a, b, exact_turn, found.exact);
}

// A line does not cross itself nearer to where it turns back, and where it meets a contour of its own surface it
// touches its image.
double Finder::nearest_allowed(const OnLine& a, const OnLine& b) const noexcept {
    if (lines_.pieces[a.piece].line == lines_.pieces[b.piece].line) return smallest_loop;
    const Subject& sa = subject_of(a.piece);
    const Subject& sb = subject_of(b.piece);
    return sa.item == sb.item && (sa.level == nullptr || sb.level == nullptr) ? touching : nearest_gap;
}

Finder::OnLine Finder::place_on(std::int64_t segment, double t) const noexcept {
    const ImagePoint& from = lines_.points[segment];
    const ImagePoint& to = lines_.points[segment + 1];
    const double end = to.piece == from.piece ? to.share : 1.0;
    return {from.piece, from.share + std::clamp(t, 0.0, 1.0) * (end - from.share)};
}

Moving Finder::at(const OnLine& place) const noexcept {
    const curves::CubicPiece its = cubic(subjects_, lines_.pieces[place.piece]);
    return moving(subject_of(place.piece).view, its.at(place.share), its.derivative(place.share));
}

// Over the ends of pieces, where the line goes on; no farther than the line's end.
void Finder::go(OnLine& place, double by) const noexcept {
    place.share += by;
    const Line& line = lines_.lines[lines_.pieces[place.piece].line];
    const auto first = static_cast<std::int32_t>(line.first_piece);
    const auto last = static_cast<std::int32_t>(line.first_piece + line.pieces - 1);
    if (place.share < -slack)
        place = place.piece != first ? OnLine{place.piece - 1, 1.0}
                : line.closed        ? OnLine{last, 1.0}
                                     : OnLine{first, 0.0};
    else if (place.share > 1.0 + slack)
        place = place.piece != last ? OnLine{place.piece + 1, 0.0}
                : line.closed       ? OnLine{first, 0.0}
                                    : OnLine{last, 1.0};
}

// In the order of the cells, for any number of threads.
base::Array<Finder::Pair> Finder::find_pairs(CrossingReport& report, const base::Progress& progress) const {
    const std::int64_t cells = grid_.begin.size() - 1;
    base::List<base::Array<Pair>> found(runtime_.memory);
    for (std::int64_t begin = 0; begin < cells; begin += cells_a_task) found.add(base::Array<Pair>(runtime_.memory));
    base::Array<std::int64_t> tangles(runtime_.memory, found.size());
    runtime_.parallel.for_chunks(cells, cells_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        const std::int64_t task = begin / cells_a_task;
        for (std::int64_t cell = begin; cell < end; ++cell)
            if (!in_cell(cell, found[task])) ++tangles[task];
    });
    base::Array<Pair> pairs(runtime_.memory);
    for (const base::Array<Pair>& some : found)
        for (const Pair& pair : some) pairs.push_back(pair);
    for (const std::int64_t some : tangles) report.tangles += some;
    return pairs;
}

void Finder::run(CrossingReport& report, const base::Progress& progress) {
    const base::Array<Pair> pairs = find_pairs(report, progress);
    report.of_polylines = pairs.size();
    base::Array<Found> looked(runtime_.memory, pairs.size());
    base::Array<std::uint8_t> is_one(runtime_.memory, pairs.size());
    runtime_.parallel.for_chunks(pairs.size(), pairs_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) is_one[i] = look_at(pairs[i], looked[i]) ? 1 : 0;
    });
    base::Array<Found> all(runtime_.memory);
    for (std::int64_t i = 0; i < pairs.size(); ++i) {
        if (is_one[i] == 0)
            ++report.rejected;
        else
            all.push_back(looked[i]);
    }
    take(all, report);
    report.rejected += verify_crossings(runtime_, subjects_, lines_, found_, progress);
    std::sort(found_.begin(), found_.end(), before);
}

// Where curves touch, Newton's steps from several crossings of segments may come to the same one.
void Finder::take(base::Array<Found>& all, CrossingReport& report) {
    for (Found& found : all)
        if (!found.converged) found.exact = found.rough;
    std::sort(all.begin(), all.end(), [](const Found& a, const Found& b) {
        if (before(a.exact, b.exact)) return true;
        return !before(b.exact, a.exact) && before(a.rough, b.rough);
    });
    const auto same = [](const Found& a, const Found& b) {
        return a.converged && b.converged && a.exact.far_piece == b.exact.far_piece &&
               a.exact.near_piece == b.exact.near_piece && b.exact.far_share - a.exact.far_share <= same_place &&
               std::abs(a.exact.near_share - b.exact.near_share) <= same_place;
    };
    for (std::int64_t i = 0; i < all.size();) {
        std::int64_t end = i + 1;
        while (end < all.size() && same(all[i], all[end])) ++end;
        take_group(std::as_const(all).span().subspan(static_cast<std::size_t>(i), static_cast<std::size_t>(end - i)),
                   report);
        i = end;
    }
}

// Those that came to one place.  Of closed lines the segments cross as often in each way as the curves do: what is
// left when those one way are set off against those the other way must stay.
void Finder::take_group(std::span<const Found> group, CrossingReport& report) {
    const std::int64_t first = found_.size();
    std::int64_t left = 0;
    for (const Found& found : group) left += found.same || !found.converged ? 1 : -1;
    if (left >= 0) found_.push_back(group[0].exact);
    std::int64_t more = left > 0 ? left - 1 : left == 0 ? 1 : -left;
    for (const Found& found : group) {
        const bool wanted = found.same == (left > 0) && (left <= 0 || &found != group.data());
        if (wanted && more-- > 0) found_.push_back(found.rough);
    }
    report.rejected += static_cast<std::int64_t>(group.size()) - (found_.size() - first);
}

} // namespace

base::Array<Crossing> find_crossings(const base::Runtime& runtime, std::span<const Subject> subjects,
                                     const ImageLines& lines, CrossingReport& report, const base::Progress& progress) {
    Finder finder(runtime, subjects, lines);
    finder.run(report, progress);
    return std::move(finder).result();
}

} // namespace hrbfnpr::visibility
