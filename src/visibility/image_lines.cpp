// SPDX-License-Identifier: MIT
// Draws curves in the image. The parts of curves before the eye become lines of cubics (add_curve). Each cubic is
// halved until its chords are within the tolerance (draw_cubic). Lengths are measured along the polylines
// (LineLengths).
//
// Finds crossings. Segments of polylines go into the cells of a grid (make_grid). Pairs of segments that cross are
// found cell by cell (find_pairs). Newton's method moves each pair onto its cubics (refine). The depths and directions
// of the two curves at a crossing say which curve is nearer, and on which side of the nearer curve its surface lies
// (set_crossing). Crossings of curves that are near in space, too, are verified on the curves themselves
// (verify_crossings). Lines that pass through another item's surface are found by halving the lines' cubics
// (find_piercings).
#include "visibility/image_lines.h"

#include "base/list.h"
#include "implicit/evaluate_all.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace hrbfnpr::visibility {
namespace {

// Returns whether the point m lies beside the chord from a to b, at most `tolerance` away from the chord.
bool on_chord(const glm::dvec2& a, const glm::dvec2& m, const glm::dvec2& b, double tolerance) noexcept {
    const glm::dvec2 chord = b - a;
    const glm::dvec2 way = m - a;
    const double length = glm::length(chord);
    if (!(length > tolerance)) return glm::length(way) <= tolerance;
    const double along = glm::dot(way, chord);
    return along >= 0.0 && along <= length * length &&
           std::abs(chord.x * way.y - chord.y * way.x) <= tolerance * length;
}

// Adds the first point of a cubic, and points between its ends. Both halves are tested, because an S-shaped cubic may
// cross its chord in the middle.
void draw_cubic(const curves::View& view, const curves::CubicPiece& cubic, std::int32_t piece, double tolerance,
                base::Array<ImagePoint>& points) {
    const auto at = [&](double u) {
        return glm::clamp(view.see(cubic.at(u)).place, -visibility_tuning.farthest_place,
                          visibility_tuning.farthest_place);
    };
    const auto split = [&](const auto& self, double u, const glm::dvec2& a, double v, const glm::dvec2& b,
                           int left) -> void {
        const double middle = 0.5 * (u + v);
        const glm::dvec2 m = at(middle);
        if (left == 0 || on_chord(a, m, b, tolerance)) return;
        self(self, u, a, middle, m, left - 1);
        points.push_back({m, piece, middle});
        self(self, middle, m, v, b, left - 1);
    };
    const glm::dvec2 a = at(0.0);
    const glm::dvec2 m = at(0.5);
    const glm::dvec2 b = at(1.0);
    points.push_back({a, piece, 0.0});
    split(split, 0.0, a, 0.5, m, visibility_tuning.most_halvings);
    if (glm::distance(a, b) > 0.5 || !on_chord(a, m, b, tolerance)) points.push_back({m, piece, 0.5});
    split(split, 0.5, m, 1.0, b, visibility_tuning.most_halvings);
}

// Adds a line made of the pieces `from` to `to` - 1 of a curve. If the curve is closed, `to` may be larger than the
// number of its pieces.
void add_line(const curves::Curves& curves, std::int32_t subject, std::int64_t curve, std::int64_t from,
              std::int64_t to, bool closed, ImageLines& lines) {
    HRBFNPR_ASSERT(from < to && from >= 0);
    const auto number = static_cast<std::int32_t>(lines.lines.size());
    lines.lines.push_back({subject, curve, lines.pieces.size(), to - from, 0, 0, closed});
    for (std::int64_t k = from; k < to; ++k) {
        const std::int64_t at = curves.first[curve] + k % curves.pieces_of(curve);
        lines.pieces.push_back({subject, number, at, curves.next(curve, at)});
    }
}

// Adds the parts of a curve that are before the eye. A curve of one point has no pieces and is left out.
void add_curve(const Subject& s, std::int32_t subject, std::int64_t curve, ImageLines& lines) {
    const curves::Curves& curves = *s.curves;
    const std::int64_t pieces = curves.pieces_of(curve);
    const auto before_eye = [&](std::int64_t point) {
        const curves::View::Seen at = s.view.see(curves.point[point].position);
        return at.w > 0.0 && std::abs(at.place.x) < visibility_tuning.farthest_place &&
               std::abs(at.place.y) < visibility_tuning.farthest_place;
    };
    const auto seen = [&](std::int64_t k) {
        const std::int64_t at = curves.first[curve] + k % pieces;
        return before_eye(at) && before_eye(curves.next(curve, at));
    };
    if (pieces == 0) return;
    curves::for_parts(pieces, curves.closed[curve] != 0, seen, [&](std::int64_t begin, std::int64_t end, bool whole) {
        add_line(curves, subject, curve, begin, end, whole, lines);
    });
}

// ---- Crossings

constexpr std::int64_t cells_a_task = 4096;
constexpr std::int64_t pairs_a_task = 16;

double cross2(const glm::dvec2& a, const glm::dvec2& b) noexcept { return a.x * b.y - a.y * b.x; }

// A point of a curve, its place in the image, and the velocity of the place along the curve.
struct MovingPlace {
    glm::dvec3 point;
    glm::dvec2 place, velocity; // in pixels
};

// A place on a line, given by a piece and a share of the piece.
struct LinePlace {
    std::int32_t piece;
    double share;
};

struct SegmentPair {
    std::int64_t a, b;
};

// The segments of the image, sorted into the cells that their bounding boxes touch. A segment goes from a point to the
// next one.
struct Grid {
    explicit Grid(base::Memory& memory) noexcept : ends_line(memory), begin(memory), segment(memory) {}

    // Returns the column of a place. `x` is measured in cells from the origin.
    [[nodiscard]] std::int64_t column(double x) const noexcept { return within(x, columns); }
    [[nodiscard]] std::int64_t row(double y) const noexcept { return within(y, rows); }
    [[nodiscard]] static std::int64_t within(double at, std::int64_t count) noexcept {
        return static_cast<std::int64_t>(std::clamp(at, 0.0, static_cast<double>(count - 1)));
    }

    glm::dvec2 origin{0.0};
    double side = visibility_tuning.cell_side;
    std::int64_t columns = 1, rows = 1;
    base::Array<std::uint8_t> ends_line; // 1 for a point at which no segment begins
    base::Array<std::int64_t> begin; // for each cell: where its list in `segment` begins; and the end of the last list
    base::Array<std::int64_t> segment;
};

// Calls f for each segment and each cell that its bounding box touches.
template <class F>
void for_cells(const ImageLines& lines, const Grid& grid, const F& f) {
    for (std::int64_t s = 0; s < lines.points.size(); ++s) {
        if (grid.ends_line[s] != 0) continue;
        const glm::dvec2 p = (lines.points[s].place - grid.origin) / grid.side;
        const glm::dvec2 q = (lines.points[s + 1].place - grid.origin) / grid.side;
        for (std::int64_t r = grid.row(std::min(p.y, q.y)); r <= grid.row(std::max(p.y, q.y)); ++r)
            for (std::int64_t c = grid.column(std::min(p.x, q.x)); c <= grid.column(std::max(p.x, q.x)); ++c)
                f(s, r * grid.columns + c);
    }
}

Grid make_grid(base::Memory& memory, const ImageLines& lines) {
    Grid grid(memory);
    grid.ends_line.resize(lines.points.size());
    for (const Line& line : lines.lines) grid.ends_line[line.first_point + line.points - 1] = 1;
    glm::dvec2 low(lines.points.empty() ? 0.0 : std::numeric_limits<double>::infinity());
    glm::dvec2 high = -low;
    for (const ImagePoint& p : lines.points) {
        low = glm::min(low, p.place);
        high = glm::max(high, p.place);
    }
    low = glm::clamp(low, -visibility_tuning.grid_end, visibility_tuning.grid_end);
    high = glm::clamp(high, -visibility_tuning.grid_end, visibility_tuning.grid_end);
    const glm::dvec2 size = high - low;
    grid.origin = low;
    grid.side = std::max(grid.side, std::sqrt(size.x * size.y / visibility_tuning.most_cells));
    grid.columns = static_cast<std::int64_t>(size.x / grid.side) + 1;
    grid.rows = static_cast<std::int64_t>(size.y / grid.side) + 1;
    // Counting sort. begin[i] first holds the number of segments in cell i - 2, and then the start of cell i - 1. In
    // the end it holds the end of cell i - 1, which is the start of cell i.
    grid.begin.resize(grid.columns * grid.rows + 2);
    for_cells(lines, grid, [&](std::int64_t, std::int64_t cell) { ++grid.begin[cell + 2]; });
    for (std::int64_t cell = 2; cell < grid.begin.size(); ++cell) grid.begin[cell] += grid.begin[cell - 1];
    grid.segment.resize(grid.begin.back());
    for_cells(lines, grid, [&](std::int64_t s, std::int64_t cell) { grid.segment[grid.begin[cell + 1]++] = s; });
    grid.begin.resize(grid.columns * grid.rows + 1);
    return grid;
}

// The data that all steps of finding crossings read.
struct CrossingInput {
    std::span<const Subject> subjects;
    const ImageLines& lines;

    [[nodiscard]] const glm::dvec2& place(std::int64_t point) const noexcept { return lines.points[point].place; }
    [[nodiscard]] const Subject& subject(std::int32_t piece) const noexcept {
        return subject_of(subjects, lines.pieces[piece]);
    }
};

// Returns whether the ends of each segment are on different sides of the other segment. An end that lies on the other
// segment's line counts as left of that line. So a line through a vertex crosses exactly one of the two segments that
// meet there.
bool segments_cross(const CrossingInput& in, std::int64_t a, std::int64_t b) noexcept {
    const auto left = [](const glm::dvec2& from, const glm::dvec2& to, const glm::dvec2& at) {
        return cross2(to - from, at - from) >= 0.0;
    };
    const glm::dvec2 &p = in.place(a), &q = in.place(a + 1), &r = in.place(b), &s = in.place(b + 1);
    return left(p, q, r) != left(p, q, s) && left(r, s, p) != left(r, s, q);
}

// Returns the crossing of two segments, as a share of each segment.
glm::dvec2 crossing_of(const CrossingInput& in, std::int64_t a, std::int64_t b) noexcept {
    const glm::dvec2 d = in.place(a + 1) - in.place(a);
    const glm::dvec2 e = in.place(b + 1) - in.place(b);
    const glm::dvec2 way = in.place(b) - in.place(a);
    const double area = cross2(d, e);
    if (area == 0.0) return glm::dvec2(0.5);
    return {cross2(way, e) / area, cross2(way, d) / area};
}

// Returns whether a crossing of two segments counts. One of them must begin or end sheets, and they must not belong to
// the same piece or to consecutive pieces of a line.
bool may_cross(const CrossingInput& in, std::int64_t a, std::int64_t b) noexcept {
    const std::int32_t p = in.lines.points[a].piece;
    const std::int32_t q = in.lines.points[b].piece;
    if (p == q || (in.subject(p).sheet_change <= 0 && in.subject(q).sheet_change <= 0)) return false;
    const bool touch = in.place(a + 1) == in.place(b) || in.place(b + 1) == in.place(a);
    return !(touch && in.lines.pieces[p].line == in.lines.pieces[q].line);
}

// Adds the pairs of a cell's segments that cross in this cell. If a pair shares several cells, it is added only in the
// cell that contains the crossing. If the cell is a tangle, returns false and adds nothing.
bool find_pairs_in_cell(const CrossingInput& in, const Grid& grid, std::int64_t cell, base::Array<SegmentPair>& pairs) {
    HRBFNPR_ASSERT(cell >= 0 && cell + 1 < grid.begin.size());
    const std::int64_t segments = grid.begin[cell + 1] - grid.begin[cell];
    if (segments > visibility_tuning.most_segments) return false;
    const std::int64_t first = pairs.size();
    for (std::int64_t i = grid.begin[cell]; i < grid.begin[cell + 1]; ++i) {
        if (pairs.size() > first + visibility_tuning.most_crossings_per_segment * segments) {
            pairs.resize(first);
            return false;
        }
        for (std::int64_t j = i + 1; j < grid.begin[cell + 1]; ++j) {
            const std::int64_t a = grid.segment[i];
            const std::int64_t b = grid.segment[j];
            if (!may_cross(in, a, b) || !segments_cross(in, a, b)) continue;
            const double share = std::clamp(crossing_of(in, a, b).x, 0.0, 1.0);
            const glm::dvec2 at = (glm::mix(in.place(a), in.place(a + 1), share) - grid.origin) / grid.side;
            if (grid.row(at.y) * grid.columns + grid.column(at.x) == cell) pairs.push_back({a, b});
        }
    }
    return true;
}

// Returns the pairs of segments that cross. The pairs are in the order of the cells, for any number of threads.
base::Array<SegmentPair> find_pairs(const base::Work& work, const CrossingInput& in, CrossingReport& report) {
    const Grid grid = make_grid(work.memory, in.lines);
    const std::int64_t cells = grid.begin.size() - 1;
    base::List<base::Array<SegmentPair>> found(work.memory);
    for (std::int64_t begin = 0; begin < cells; begin += cells_a_task) found.add(work.memory);
    base::Array<std::int64_t> tangles(work.memory, found.size());
    work.for_chunks(cells, cells_a_task, [&](std::int64_t begin, std::int64_t end) {
        const std::int64_t task = begin / cells_a_task;
        for (std::int64_t cell = begin; cell < end; ++cell)
            if (!find_pairs_in_cell(in, grid, cell, found[task])) ++tangles[task];
    });
    base::Array<SegmentPair> pairs(work.memory);
    for (const base::Array<SegmentPair>& some : found)
        for (const SegmentPair& pair : some) pairs.push_back(pair);
    for (const std::int64_t some : tangles) report.tangles += some;
    report.of_polylines = pairs.size();
    return pairs;
}

LinePlace place_on_segment(const CrossingInput& in, std::int64_t segment, double t) noexcept {
    const ImagePoint& from = in.lines.points[segment];
    const ImagePoint& to = in.lines.points[segment + 1];
    const double end = to.piece == from.piece ? to.share : 1.0;
    return {from.piece, from.share + std::clamp(t, 0.0, 1.0) * (end - from.share)};
}

MovingPlace moving_place(const curves::View& view, const glm::dvec3& point, const glm::dvec3& derivative) noexcept {
    const glm::dvec4 q = view.to_window * glm::dvec4(point, 1.0);
    const glm::dvec4 d = view.to_window * glm::dvec4(derivative, 0.0);
    const glm::dvec2 place(q.x / q.w, q.y / q.w);
    return {point, place, {(d.x - place.x * d.w) / q.w, (d.y - place.y * d.w) / q.w}};
}

MovingPlace moving_place_at(const CrossingInput& in, const LinePlace& at) noexcept {
    const curves::CubicPiece its = cubic(in.subjects, in.lines.pieces[at.piece]);
    return moving_place(in.subject(at.piece).view, its.at(at.share), its.derivative(at.share));
}

// Returns how far each of two places must move along its direction until they meet. If the directions are parallel, the
// results are not finite.
std::pair<double, double> steps_to_meeting(const MovingPlace& p, const MovingPlace& q) noexcept {
    const double area = cross2(p.velocity, q.velocity);
    const glm::dvec2 way = q.place - p.place;
    return {cross2(way, q.velocity) / area, cross2(way, p.velocity) / area};
}

// Moves a place along its line, into the next piece if necessary, but not beyond the end of the line.
void move_along(const CrossingInput& in, LinePlace& at, double by) noexcept {
    at.share += by;
    if (at.share >= -visibility_tuning.end_slack && at.share <= 1.0 + visibility_tuning.end_slack) return;
    const Line& line = in.lines.lines[in.lines.pieces[at.piece].line];
    const bool back = at.share < 0.0;
    const std::int64_t k = at.piece - line.first_piece + (back ? -1 : 1);
    const bool ends = !line.closed && (k < 0 || k >= line.pieces);
    const std::int64_t next = ends ? at.piece - line.first_piece : (k + line.pieces) % line.pieces;
    at = {static_cast<std::int32_t>(line.first_piece + next), back != ends ? 1.0 : 0.0};
}

// Moves two places along their cubics by Newton's method until they meet in the image. Returns false if they do not.
bool refine(const CrossingInput& in, LinePlace& a, LinePlace& b) noexcept {
    HRBFNPR_ASSERT(a.share >= 0.0 && a.share <= 1.0 && b.share >= 0.0 && b.share <= 1.0);
    for (int step = 0;; ++step) {
        const auto [da, db] = steps_to_meeting(moving_place_at(in, a), moving_place_at(in, b));
        if (!(std::abs(da) <= 1.0 && std::abs(db) <= 1.0) || step == visibility_tuning.newton_steps) return false;
        if (std::abs(da) <= visibility_tuning.newton_tolerance && std::abs(db) <= visibility_tuning.newton_tolerance)
            return true;
        move_along(in, a, da);
        move_along(in, b, db);
    }
}

// Returns the distance in space, in mesh sides, below which two curves at a crossing count as the same curve.
double least_gap_of(const CrossingInput& in, const LinePlace& a, const LinePlace& b) noexcept {
    if (in.lines.pieces[a.piece].line == in.lines.pieces[b.piece].line) return visibility_tuning.least_loop;
    const Subject& sa = in.subject(a.piece);
    const Subject& sb = in.subject(b.piece);
    const bool on_one_surface = sa.is_on(sb.item) || sb.is_on(sa.item);
    return on_one_surface && (sa.level == nullptr || sb.level == nullptr) ? visibility_tuning.touching_gap
                                                                          : visibility_tuning.least_gap;
}

// Sets all members of `crossing`. If `turn` > 0, the second direction in the image is clockwise from the first. Returns
// false if the curves are the same, as happens beside a cusp, so that they do not cross.
bool set_crossing(const CrossingInput& in, const LinePlace& a, const LinePlace& b, double turn,
                  Crossing& crossing) noexcept {
    const MovingPlace p = moving_place_at(in, a);
    const MovingPlace q = moving_place_at(in, b);
    const Subject& sa = in.subject(a.piece);
    const Subject& sb = in.subject(b.piece);
    const glm::dvec3 world_p(sa.to_world * glm::dvec4(p.point, 1.0));
    const glm::dvec3 world_q(sb.to_world * glm::dvec4(q.point, 1.0));
    // Both curves have the same line of sight at the crossing.
    const glm::dvec3 sight = glm::dmat3(sa.to_world) * sa.view.sight(p.point);
    const bool second_far = glm::dot(world_q - world_p, sight) > 0.0;
    const double side = sa.side * glm::length(sight) / glm::length(sa.view.sight(p.point));
    crossing.gap = glm::distance(world_p, world_q) / side;
    if (!(crossing.gap > least_gap_of(in, a, b))) return false;
    const LinePlace& far = second_far ? b : a;
    const LinePlace& near = second_far ? a : b;
    const Subject& near_one = second_far ? sa : sb;
    // With y upward, the nearer surface is to the left of its contour.
    const bool to_left = second_far ? turn < 0.0 : turn > 0.0;
    const bool left = to_left != (near_one.mirrored != shows_inside(in.subjects, in.lines.pieces[near.piece]));
    crossing.far_piece = far.piece;
    crossing.near_piece = near.piece;
    crossing.far_share = std::clamp(far.share, 0.0, 1.0);
    crossing.near_share = std::clamp(near.share, 0.0, 1.0);
    crossing.change = left ? near_one.sheet_change : -near_one.sheet_change;
    crossing.place = p.place;
    crossing.sine = std::abs(cross2(p.velocity, q.velocity)) / (glm::length(p.velocity) * glm::length(q.velocity));
    return true;
}

// Sets `crossing` from the cubics, or from the segments if Newton's method fails. Returns false if the curves do not
// cross.
bool solve_crossing(const CrossingInput& in, const SegmentPair& pair, Crossing& crossing) noexcept {
    const glm::dvec2 start = crossing_of(in, pair.a, pair.b);
    LinePlace a = place_on_segment(in, pair.a, start.x);
    LinePlace b = place_on_segment(in, pair.b, start.y);
    const double turn = cross2(in.place(pair.a + 1) - in.place(pair.a), in.place(pair.b + 1) - in.place(pair.b));
    LinePlace exact_a = a;
    LinePlace exact_b = b;
    if (!refine(in, exact_a, exact_b)) return set_crossing(in, a, b, turn, crossing);
    const double exact_turn = cross2(moving_place_at(in, exact_a).velocity, moving_place_at(in, exact_b).velocity);
    return set_crossing(in, exact_a, exact_b, exact_turn, crossing);
}

// ---- Verification

// A crossing whose curves are near each other in space, with a place on each curve, the farther curve first.
struct Suspect {
    std::int64_t crossing;
    std::int32_t subject[2];
    glm::dvec3 begin[2];
    curves::CurvePoint point[2];
    double gap; // the distance between the two places before the search
    bool is_done, is_confirmed;
};

// Returns whether a crossing must be verified on the curves themselves. Near a cusp, cubics may have a single crossing
// that the curve does not have. Elsewhere false crossings come in pairs whose changes add up to 0. At their ends,
// contours touch the image of the border, which is another doubtful case.
bool is_suspect(const CrossingInput& in, const Crossing& c) noexcept {
    const Subject& far = in.subject(c.far_piece);
    const Subject& near = in.subject(c.near_piece);
    if (!(c.gap < visibility_tuning.suspicious_gap) || far.level == nullptr || near.level == nullptr) return false;
    const bool one_line = in.lines.pieces[c.far_piece].line == in.lines.pieces[c.near_piece].line;
    return far.item == near.item && (far.level != near.level || one_line);
}

// Moves the places of all suspects onto their curves by two Newton steps.
void correct_suspects(const base::Work& work, std::span<const Subject> subjects, base::Array<Suspect>& suspects) {
    for (std::size_t s = 0; s < subjects.size(); ++s) {
        base::Array<curves::CurvePoint*> which(work.memory);
        for (Suspect& suspect : suspects)
            for (const int k : {0, 1})
                if (!suspect.is_done && static_cast<std::size_t>(suspect.subject[k]) == s)
                    which.push_back(&suspect.point[k]);
        if (which.empty()) continue;
        base::Array<curves::CurvePoint> points(work.memory);
        for (const curves::CurvePoint* p : which) points.push_back(*p);
        std::int64_t evaluations = 0;
        // The limit is 0 for each point, so each point takes a second step.
        const base::Array<double> always(work.memory, points.size());
        curves::bring_closer(work, *subjects[s].level, always, points, evaluations);
        for (std::int64_t i = 0; i < points.size(); ++i) *which[i] = points[i];
    }
}

// Moves both places of a suspect towards the point where the curves meet. The search fails if they move farther than a
// share of the gap between the curves, or if the gap vanishes, as at a cusp, where a curve meets itself.
void advance_suspect(std::span<const Subject> subjects, Suspect& suspect) noexcept {
    const auto view = [&](int k) { return subjects[static_cast<std::size_t>(suspect.subject[k])].view; };
    curves::CurvePoint& a = suspect.point[0];
    curves::CurvePoint& b = suspect.point[1];
    const glm::dvec3 along_a = glm::normalize(a.direction());
    const glm::dvec3 along_b = glm::normalize(b.direction());
    const auto [da, db] =
        steps_to_meeting(moving_place(view(0), a.position, along_a), moving_place(view(1), b.position, along_b));
    const double most = visibility_tuning.farthest_crossing * suspect.gap;
    const bool strayed = !(glm::distance(a.position, suspect.begin[0]) <= most) ||
                         !(glm::distance(b.position, suspect.begin[1]) <= most);
    const bool met = glm::distance(a.position, b.position) < visibility_tuning.smallest_gap * suspect.gap;
    const bool lost = strayed || met || !(std::abs(da) <= suspect.gap && std::abs(db) <= suspect.gap);
    const double short_step = visibility_tuning.settled_step * suspect.gap;
    suspect.is_confirmed = !lost && std::abs(da) <= short_step && std::abs(db) <= short_step;
    suspect.is_done = lost || suspect.is_confirmed;
    if (suspect.is_done) return;
    a.position += da * along_a;
    b.position += db * along_b;
}

// ---- Piercing

// A place on a piece, with three values of the other surface there: f, the slope of f along the piece, and the gradient
// of f.
struct PiercingPlace {
    double share;
    double value, slope;
    glm::dvec3 point, gradient; // in the coordinates of the other item
    bool inside;                // true if the place is in the region where f is evaluated
};

// A part of a piece between two places.
struct PiercingPart {
    std::int32_t piece;
    int depth; // the number of halvings
    PiercingPlace low, high;
};

// The data for finding where the lines of all other items pass through one surface.
struct PiercingScene {
    const base::Runtime& runtime;
    std::span<const Subject> subjects;
    const ImageLines& lines;
    const Occluder& occluder;
    std::int32_t item;
    geometry::Bounds region;
    glm::dmat4 from_world;
};

// Evaluates f at places on pieces.
base::Array<PiercingPlace> evaluate_places(const PiercingScene& in, const base::Array<LinePlace>& wanted,
                                           const base::Progress& progress) {
    base::Memory& memory = in.runtime.memory;
    base::Array<PiercingPlace> places(memory, wanted.size());
    geometry::VecArray point(memory);
    base::Array<glm::dvec3> way(memory);
    for (std::int64_t i = 0; i < wanted.size(); ++i) {
        const Piece& its = in.lines.pieces[wanted[i].piece];
        const glm::dmat4 to_other = in.from_world * subject_of(in.subjects, its).to_world;
        const curves::CubicPiece piece = cubic(in.subjects, its);
        PiercingPlace& place = places[i];
        place.share = wanted[i].share;
        place.point = glm::dvec3(to_other * glm::dvec4(piece.at(place.share), 1.0));
        place.inside = in.region.contains(place.point);
        if (!place.inside) continue;
        point.push_back(place.point);
        way.push_back(glm::dmat3(to_other) * piece.derivative(place.share));
    }
    geometry::VecArray gradient(memory, point.size());
    base::Array<double> value(memory, point.size());
    implicit::evaluate_all({in.runtime, progress.part(0.0, 0.0)}, *in.occluder.surface, point,
                           {value.data(), {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}});
    std::int64_t next = 0;
    for (PiercingPlace& place : places) {
        if (!place.inside) continue;
        place.value = value[next];
        place.gradient = gradient[next];
        place.slope = glm::dot(place.gradient, way[next]);
        place.inside = std::isfinite(place.value) && std::isfinite(place.slope);
        ++next;
    }
    return places;
}

// Returns whether f may be 0 between two places where it has the same sign. It is not 0 if the cubic through the values
// and slopes keeps its sign. If f stays within `in_surface` of 0, the line lies in the surface, and the result is
// false.
bool may_pierce(const PiercingPlace& a, const PiercingPlace& b, double in_surface) noexcept {
    const double length = b.share - a.share;
    const double sign = a.value < 0.0 ? -1.0 : 1.0;
    if (sign * (a.value + length * a.slope / 3.0) > 0.0 && sign * (b.value - length * b.slope / 3.0) > 0.0)
        return false;
    const auto near = [&](const PiercingPlace& place) {
        const double most = in_surface * glm::length(place.gradient);
        return std::abs(place.value) <= most && std::abs(length * place.slope) <= most;
    };
    return !(near(a) && near(b));
}

// Returns whether a part of a line may reach the region. A cubic leaves the bounding box of its ends by at most half of
// the distance between them.
bool is_near_region(const PiercingPart& part, const geometry::Bounds& region) noexcept {
    geometry::Bounds box;
    box.extend(part.low.point);
    box.extend(part.high.point);
    box = box.grown(0.5 * glm::distance(part.low.point, part.high.point));
    return glm::all(glm::lessThanEqual(box.min, region.max)) && glm::all(glm::lessThanEqual(region.min, box.max));
}

// Adds the place where a short part passes through the surface. If the way back to the eye leads through the sheet, the
// sheet is before the line.
void add_piercing(const PiercingScene& in, const PiercingPart& part, base::Array<Piercing>& found) {
    const double rise = part.high.value - part.low.value;
    const double share = part.low.share - (part.high.share - part.low.share) * part.low.value / rise;
    const PiercingPlace& at = part.low;
    const implicit::Domain* const domain = in.occluder.sheet_counter->mesh().domain;
    if (domain != nullptr && !domain->contains(at.point, at.gradient)) return;
    const glm::dvec4& eye = in.occluder.eye;
    const glm::dvec3 sight = eye.w == 0.0 ? glm::dvec3(eye) : at.point - glm::dvec3(eye);
    const bool faces_away = glm::dot(at.gradient, sight) > 0.0;
    found.push_back({part.piece, share, in.item, faces_away != (at.value < 0.0) ? -1 : 1});
}

// Adds the place where a short part passes through the surface. A longer part that may pass through the surface is
// added to `halved`.
void add_or_halve(const PiercingScene& in, const PiercingPart& part, base::Array<PiercingPart>& halved,
                  base::Array<Piercing>& found) {
    const PiercingPlace& a = part.low;
    const PiercingPlace& b = part.high;
    HRBFNPR_ASSERT(a.share < b.share);
    if (!a.inside && !b.inside &&
        (part.depth >= visibility_tuning.most_halvings_outside || !is_near_region(part, in.region)))
        return;
    const bool last = b.share - a.share <= visibility_tuning.newton_tolerance;
    if (a.inside && b.inside) {
        const bool changes = (a.value < 0.0) != (b.value < 0.0);
        if (changes && last) return add_piercing(in, part, found);
        if (!changes && !may_pierce(a, b, visibility_tuning.in_surface_distance * in.region.diagonal())) return;
    }
    if (!last) halved.push_back(part);
}

void find_piercings_of(const PiercingScene& in, base::Array<Piercing>& found, const base::Progress& progress) {
    base::Memory& memory = in.runtime.memory;
    base::Array<LinePlace> wanted(memory);
    base::Array<PiercingPart> halved(memory);
    for (std::int32_t p = 0; p < in.lines.pieces.size(); ++p) {
        if (subject_of(in.subjects, in.lines.pieces[p]).is_on(in.item)) continue;
        wanted.push_back({p, 0.0});
        wanted.push_back({p, 1.0});
    }
    const base::Array<PiercingPlace> ends = evaluate_places(in, wanted, progress);
    for (std::int64_t i = 0; i < ends.size(); i += 2)
        add_or_halve(in, {wanted[i].piece, 0, ends[i], ends[i + 1]}, halved, found);
    while (!halved.empty()) {
        progress.check();
        wanted.clear();
        for (const PiercingPart& part : halved)
            wanted.push_back({part.piece, 0.5 * (part.low.share + part.high.share)});
        const base::Array<PiercingPlace> middle = evaluate_places(in, wanted, progress);
        const base::Array<PiercingPart> parts = std::exchange(halved, base::Array<PiercingPart>(memory));
        for (std::int64_t i = 0; i < parts.size(); ++i) {
            add_or_halve(in, {parts[i].piece, parts[i].depth + 1, parts[i].low, middle[i]}, halved, found);
            add_or_halve(in, {parts[i].piece, parts[i].depth + 1, middle[i], parts[i].high}, halved, found);
        }
    }
}

} // namespace

bool shows_inside(std::span<const Subject> subjects, const Piece& piece) noexcept {
    const Subject& subject = subject_of(subjects, piece);
    if (subject.sheet_change != 1) return false;
    const curves::CurvePoint& p = subject.curves->point[piece.a];
    const curves::CurvePoint& q = subject.curves->point[piece.b];
    return glm::dot(p.gradient + q.gradient, subject.view.sight(p.position)) > 0.0;
}

ImageLines draw_lines(const base::Runtime& runtime, std::span<const Subject> subjects, double tolerance) {
    HRBFNPR_ASSERT(tolerance > 0.0);
    ImageLines image(runtime.memory);
    for (std::size_t s = 0; s < subjects.size(); ++s)
        for (std::int64_t c = 0; c < subjects[s].curves->count(); ++c)
            add_curve(subjects[s], static_cast<std::int32_t>(s), c, image);
    base::List<base::Array<ImagePoint>> points(runtime.memory); // for each line: the points of its image
    for (std::int64_t l = 0; l < image.lines.size(); ++l) points.add(runtime.memory);
    runtime.parallel.for_each(image.lines.size(), [&](std::int64_t l) {
        const Line& line = image.lines[l];
        const Subject& subject = subjects[static_cast<std::size_t>(line.subject)];
        const std::int64_t last = line.first_piece + line.pieces - 1;
        for (std::int64_t p = line.first_piece; p <= last; ++p)
            draw_cubic(subject.view, cubic(subjects, image.pieces[p]), static_cast<std::int32_t>(p), tolerance,
                       points[l]);
        points[l].push_back({subject.view.see(subject.curves->point[image.pieces[last].b].position).place,
                             static_cast<std::int32_t>(last), 1.0});
    });
    std::int64_t count = 0;
    for (const base::Array<ImagePoint>& of_line : points) count += of_line.size();
    image.points.reserve(count);
    for (std::int64_t l = 0; l < image.lines.size(); ++l) {
        image.lines[l].first_point = image.points.size();
        image.lines[l].points = points[l].size();
        for (const ImagePoint& p : points[l]) image.points.push_back(p);
    }
    return image;
}

LineLengths::LineLengths(base::Memory& memory, const ImageLines& lines)
    : lines_(lines), length_(memory, lines.points.size()), first_(memory, lines.pieces.size()) {
    for (const Line& line : lines.lines) {
        HRBFNPR_ASSERT(line.points > 1 && line.first_point + line.points <= lines.points.size());
        double all = 0.0;
        const std::int64_t end = line.first_point + line.points;
        for (std::int64_t p = line.first_point; p < end; ++p) {
            if (p > line.first_point) all += glm::distance(lines.points[p - 1].place, lines.points[p].place);
            length_[p] = all;
        }
        for (std::int64_t p = end - 2; p >= line.first_point; --p) first_[lines.points[p].piece] = p;
    }
}

double LineLengths::at(const Line& line, std::int64_t piece, double share) const noexcept {
    HRBFNPR_ASSERT(piece >= line.first_piece && piece < line.first_piece + line.pieces);
    const bool last = piece + 1 == line.first_piece + line.pieces;
    const std::int64_t end = last ? line.first_point + line.points - 1 : first_[piece + 1];
    const ImagePoint* const begin = lines_.points.data() + first_[piece];
    const ImagePoint* const next = std::upper_bound(begin + 1, lines_.points.data() + end, share,
                                                    [](double s, const ImagePoint& p) { return s < p.share; });
    const std::int64_t p = next - 1 - lines_.points.data();
    const double from = lines_.points[p].share;
    const double to = p + 1 == end ? 1.0 : lines_.points[p + 1].share;
    const double on_chord = to > from ? std::clamp((share - from) / (to - from), 0.0, 1.0) : 0.0;
    return length_[p] + on_chord * (length_[p + 1] - length_[p]);
}

std::int64_t LineLengths::piece_at(const Line& line, double at) const noexcept {
    std::int64_t low = line.first_piece;
    std::int64_t high = line.first_piece + line.pieces;
    while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (length_[first_[middle]] <= at ? low : high) = middle;
    }
    return low;
}

std::int64_t verify_crossings(const base::Work& work, std::span<const Subject> subjects, const ImageLines& lines,
                              base::Array<Crossing>& crossings) {
    const CrossingInput in{subjects, lines};
    base::Array<Suspect> suspects(work.memory);
    for (std::int64_t i = 0; i < crossings.size(); ++i) {
        const Crossing& c = crossings[i];
        if (!is_suspect(in, c)) continue;
        const Piece& far = lines.pieces[c.far_piece];
        const Piece& near = lines.pieces[c.near_piece];
        Suspect suspect{i, {far.subject, near.subject}, {}, {}, 0.0, false, false};
        suspect.begin[0] = suspect.point[0].position = cubic(subjects, far).at(c.far_share);
        suspect.begin[1] = suspect.point[1].position = cubic(subjects, near).at(c.near_share);
        suspect.gap = glm::distance(suspect.begin[0], suspect.begin[1]);
        suspects.push_back(suspect);
    }
    for (int round = 0; round < visibility_tuning.verifying_rounds; ++round) {
        correct_suspects(work, subjects, suspects);
        for (Suspect& suspect : suspects)
            if (!suspect.is_done) advance_suspect(subjects, suspect);
    }
    std::int64_t kept = 0;
    const Suspect* next = suspects.begin();
    for (std::int64_t i = 0; i < crossings.size(); ++i) {
        const bool is_wrong = next != suspects.end() && next->crossing == i && !next->is_confirmed;
        if (next != suspects.end() && next->crossing == i) ++next;
        if (!is_wrong) crossings[kept++] = crossings[i];
    }
    const std::int64_t removed = crossings.size() - kept;
    crossings.resize(kept);
    return removed;
}

base::Array<Crossing> find_crossings(const base::Work& work, std::span<const Subject> subjects, const ImageLines& lines,
                                     CrossingReport& report) {
    const CrossingInput in{subjects, lines};
    const base::Array<SegmentPair> pairs = find_pairs(work, in, report);
    base::Array<Crossing> looked(work.memory, pairs.size());
    work.for_chunks(pairs.size(), pairs_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i)
            if (!solve_crossing(in, pairs[i], looked[i])) looked[i].far_piece = -1;
    });
    const auto is_none = [](const Crossing& c) { return c.far_piece < 0; };
    looked.resize(std::remove_if(looked.begin(), looked.end(), is_none) - looked.begin());
    std::sort(looked.begin(), looked.end(), [](const Crossing& a, const Crossing& b) {
        return std::tie(a.far_piece, a.far_share, a.near_piece, a.near_share) <
               std::tie(b.far_piece, b.far_share, b.near_piece, b.near_share);
    });
    // Where curves touch, Newton's method may move several crossings of segments to the same place.
    const auto same = [](const Crossing& a, const Crossing& b) {
        return a.far_piece == b.far_piece && a.near_piece == b.near_piece &&
               b.far_share - a.far_share <= visibility_tuning.same_place &&
               std::abs(a.near_share - b.near_share) <= visibility_tuning.same_place;
    };
    looked.resize(std::unique(looked.begin(), looked.end(), same) - looked.begin());
    verify_crossings(work, subjects, lines, looked);
    report.rejected = pairs.size() - looked.size();
    return looked;
}

base::Array<Piercing> find_piercings(const base::Work& work, std::span<const Subject> subjects,
                                     std::span<const Occluder> occluders, const ImageLines& lines) {
    base::Array<Piercing> found(work.memory);
    for (std::size_t o = 0; o < occluders.size() && occluders.size() > 1; ++o)
        find_piercings_of({work, subjects, lines, occluders[o], static_cast<std::int32_t>(o),
                           occluders[o].sheet_counter->mesh().region, glm::inverse(occluders[o].to_world)},
                          found, work);
    std::sort(found.begin(), found.end(), [](const Piercing& a, const Piercing& b) {
        return std::tie(a.piece, a.share, a.item) < std::tie(b.piece, b.share, b.item);
    });
    return found;
}

} // namespace hrbfnpr::visibility
