// SPDX-License-Identifier: MIT
// 1. find_crests: a crest crosses edges of the mesh. Crossings are linked within triangles, and lines follow the links.
// 2. join_ends: ends that face each other over a small gap are joined, the nearest first.
// 3. even_out: lines are moved to the middle between their neighbours, and straightened where they turn too much.
// 4. add_line_marks: lines get a mark at each step, which is projected onto the surface. Lines are cut where they
//    pass over a crease or leave the surface; the ends of pieces are extended to creases.
#include "hatching/lines.h"

#include "base/sort.h"
#include "curves/mesh_edges.h"
#include "geometry/long_vec_array.h"
#include "geometry/point_grid.h"
#include "hatching/forks.h"
#include "hatching/tuning.h"
#include "surface/creased.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <array>
#include <bit>
#include <tuple>

namespace hrbfnpr::hatching {
namespace {

constexpr std::int64_t triangles_a_task = 4096;

// ---- Crests of waves

// The place where a crest crosses an edge of the mesh. The edge goes from vertex a to vertex b.
struct Crossing {
    double share;      // the position on the edge, from 0 at a to 1 at b
    std::int32_t a, b; // indices of the vertices
    bool rises;        // true if the phase grows from a to b, as Waves::growth() computes it
    std::uint8_t level;
};

// Calls visit(crossing, line number) for all crests of the finest wave between two vertices, and for 2^halvings - 1
// lines between any two consecutive crests, in the order of their numbers. `phase` is that of the finest wave.
template <class Visit>
void visit_crests(const Waves& waves, const base::Array<float>& phase, int halvings, std::int32_t a, std::int32_t b,
                  const Visit& visit) {
    if (!waves.has_line(a) || !waves.has_line(b)) return;
    const double scale = std::ldexp(1.0, halvings) / tau;
    const double growth = waves.growth(a, b, waves.period_of(waves.finest()));
    const auto begin = static_cast<double>(phase[a]);
    const auto end = static_cast<double>(waves.turned(a, b) ? -phase[b] : phase[b]);
    const double change = growth + std::remainder(end - begin - growth, tau);
    const double last = scale * std::max(begin, begin + change);
    for (double k = std::floor(scale * std::min(begin, begin + change)) + 1.0; k <= last; k += 1.0) {
        const double share = std::clamp((k / scale - begin) / change, 0.0, 1.0);
        visit(Crossing{share, a, b, change > 0.0, 0}, static_cast<std::int64_t>(k));
    }
}

// Returns the level of a line at a crossing. A line between two crests of the finest wave gets its level from its line
// number: of the numbers, every second belongs to the finest level, every fourth to the level before, and so on. A
// crest of the finest wave gets the level of the coarsest wave that has a crest there, too. To find this level, the
// coarser waves are evaluated at the crossing.
std::uint8_t level_of(const Waves& waves, int halvings, const Crossing& c, std::int64_t line) noexcept {
    const int twos = std::countr_zero(static_cast<std::uint64_t>(line));
    if (twos < halvings) return static_cast<std::uint8_t>(waves.finest() + halvings - twos);
    const bool turned = waves.turned(c.a, c.b);
    for (std::int64_t coarser = waves.finest() - 1; coarser >= 0; --coarser) {
        const double growth = waves.growth(c.a, c.b, waves.period_of(coarser));
        const Complex at_a(waves.level[coarser][c.a]);
        const Complex at_b(conjugated_if(waves.level[coarser][c.b], turned));
        const Complex from_a = product(at_a, std::polar(1.0 - c.share, c.share * growth));
        const Complex from_b = product(at_b, std::polar(c.share, (c.share - 1.0) * growth));
        if (std::real(from_a + from_b) < 0.0) return static_cast<std::uint8_t>(coarser + 1);
    }
    return 0;
}

struct Crossings {
    explicit Crossings(base::Memory& memory) noexcept : first(memory), crossing(memory), link(memory) {}

    // For each edge, the index of its first crossing; the last element is the number of crossings. If two triangles
    // share an edge, crossings are stored only for the triangle that owns the edge.
    base::Array<std::int64_t> first;
    base::Array<Crossing> crossing; // the crossings, in order along each edge
    // Two links per crossing: to the next crossing in the owner's triangle, and to the next crossing in the other
    // triangle. -1: no crossing.
    base::Array<std::int64_t> link;
};

Crossings cross_edges(const base::Work& work, const curves::SurfaceMesh& mesh, const Waves& waves, int halvings) {
    Crossings found(work.memory);
    base::Array<float> phase(work.memory, mesh.vertices());
    work.for_chunks(mesh.vertices(), triangles_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t v = begin; v < end; ++v) phase[v] = std::arg(waves.level[waves.finest()][v]);
    });
    const std::int64_t edges = mesh.corner.size();
    base::resize_long(found.first, edges + 1, work);
    const auto for_edges = [&](const auto& visit) {
        work.for_chunks(edges, triangles_a_task, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t edge = begin; edge < end; ++edge)
                if (is_first(mesh, edge)) visit(edge, mesh.corner[edge], end_of(mesh, edge));
        });
    };
    for_edges([&](std::int64_t edge, std::int32_t a, std::int32_t b) {
        visit_crests(waves, phase, halvings, a, b, [&](const Crossing&, std::int64_t) { ++found.first[edge + 1]; });
    });
    for (const std::int64_t edge : work.over(edges)) {
        found.first[edge + 1] += found.first[edge];
    }
    found.crossing.resize_for_overwrite(found.first[edges]);
    base::fill_long(found.link, 2 * found.first[edges], std::int64_t{-1}, work);
    for_edges([&](std::int64_t edge, std::int32_t a, std::int32_t b) {
        std::int64_t at = found.first[edge];
        visit_crests(waves, phase, halvings, a, b, [&](Crossing c, std::int64_t line) {
            c.level = level_of(waves, halvings, c, line);
            found.crossing[at++] = c;
        });
        HRBFNPR_ASSERT(at == found.first[edge + 1]);
        // If the phase falls along the edge, the crossings were found in reverse order.
        if (at > found.first[edge] && !found.crossing[found.first[edge]].rises)
            std::reverse(found.crossing.data() + found.first[edge], found.crossing.data() + at);
    });
    return found;
}

// Links the crossings on the edges of a triangle. On a walk around the triangle, the phase passes the value of a line
// twice: once rising and once falling. So two consecutive crossings of opposite sense belong to one line, once all
// crossings between them are linked. At a crossing without a partner, a line ends in a fork.
void link_triangle(const curves::SurfaceMesh& mesh, const Waves& waves, std::int64_t triangle, Crossings& found,
                   base::Array<std::int64_t>& open) {
    const std::int32_t corner = mesh.corner[3 * triangle];
    const std::int32_t next = mesh.corner[3 * triangle + 1];
    const std::int32_t last = mesh.corner[3 * triangle + 2];
    const bool next_turned = waves.turned(corner, next);
    const bool last_turned = waves.turned(corner, last);
    // The line field reverses its direction here, so nothing is linked.
    if ((next_turned != last_turned) != waves.turned(next, last)) return;
    // The crossings that still have no partner: 2 * slot, plus 1 if the phase rises on the walk. The sign of the phase
    // is that for the line at the first corner.
    open.clear();
    const auto add = [&](std::int64_t crossing, bool backwards, bool owned) {
        const Crossing& c = found.crossing[crossing];
        const bool turned = c.a == next ? next_turned : c.a == last && last_turned;
        const bool rises = (c.rises != turned) != backwards;
        // the link of this crossing that belongs to this triangle
        const std::int64_t slot = 2 * crossing + (owned ? 0 : 1);
        if (!open.empty() && (open.back() % 2 != 0) != rises) {
            const std::int64_t other = open.back() / 2;
            found.link[other] = crossing;
            found.link[slot] = other / 2;
            open.resize(open.size() - 1);
            return;
        }
        open.push_back(2 * slot + (rises ? 1 : 0));
    };
    for (std::int64_t edge = 3 * triangle; edge < 3 * triangle + 3; ++edge) {
        if (is_first(mesh, edge)) {
            for (std::int64_t c = found.first[edge]; c < found.first[edge + 1]; ++c) add(c, false, true);
        } else if (const std::int64_t other = opposite_of(mesh, edge); other >= 0) {
            for (std::int64_t c = found.first[other + 1] - 1; c >= found.first[other]; --c) add(c, true, false);
        }
    }
}

// Returns the bits of Lines::border.
std::uint8_t border_bits(bool begins, bool ends) noexcept {
    return static_cast<std::uint8_t>((begins ? Lines::begins_at_border : 0U) | (ends ? Lines::ends_at_border : 0U));
}

// Follows the links, first of open lines, from one end, then of closed lines. Lines that cross only one edge are left
// out.
Lines follow_crests(const curves::SurfaceMesh& mesh, const Crossings& found, const base::Progress& progress) {
    Lines lines(mesh.position.memory());
    base::Array<std::uint8_t> taken(mesh.position.memory(), found.crossing.size());
    const auto is_at_border = [&](std::int64_t crossing) {
        const std::int64_t* const next = std::upper_bound(found.first.begin(), found.first.end(), crossing);
        return opposite_of(mesh, next - found.first.begin() - 1) < 0;
    };
    const auto follow = [&](std::int64_t from) {
        std::int64_t last = -1;
        std::int64_t at = from;
        while (true) {
            const Crossing& c = found.crossing[at];
            const glm::dvec3 normal =
                glm::mix(glm::normalize(mesh.gradient[c.a]), glm::normalize(mesh.gradient[c.b]), c.share);
            lines.add_point(glm::mix(mesh.position[c.a], mesh.position[c.b], c.share), glm::normalize(normal), c.level,
                            progress);
            taken[at] = 1;
            const std::int64_t next = found.link[2 * at] != last ? found.link[2 * at] : found.link[2 * at + 1];
            if (next < 0 || taken[next] != 0)
                return lines.end_line(next == from, border_bits(is_at_border(from), is_at_border(at)));
            last = at;
            at = next;
        }
    };
    for (const bool open : {true, false})
        for (const std::int64_t c : progress.over(found.crossing.size())) {
            const int links = (found.link[2 * c] >= 0 ? 1 : 0) + (found.link[2 * c + 1] >= 0 ? 1 : 0);
            if (taken[c] == 0 && links == (open ? 1 : 2)) follow(c);
        }
    return lines;
}

// ---- Ends of lines

// The ends of lines. End 2 l is the first point of line l, and end 2 l + 1 is the last. `direction` points out of the
// line.
struct LineEnds {
    geometry::VecArray place, direction;
};

// Finds the ends of lines. The direction of an end is averaged over several points, because points on mesh edges are
// exact only to a fraction of a cell.
LineEnds ends_of(const Lines& lines, double reach) {
    LineEnds ends{geometry::VecArray(lines.first.memory()), geometry::VecArray(lines.first.memory())};
    for (std::int64_t l = 0; l < lines.count(); ++l)
        for (const std::int64_t step : {1, -1}) {
            const std::int64_t last = lines.points(l) - 1;
            const std::int64_t end = lines.first[l] + (step > 0 ? 0 : last);
            const auto distance = [&](std::int64_t k) {
                return glm::distance(lines.position[end + k * step], lines.position[end]);
            };
            std::int64_t k = std::min<std::int64_t>(1, last);
            while (k < last && distance(k) < hatching_tuning.end_length * reach) ++k;
            ends.place.push_back(lines.position[end]);
            ends.direction.push_back(glm::normalize(lines.position[end] - lines.position[end + k * step]));
        }
    return ends;
}

// Returns whether two ends face each other: their directions are opposite, and the gap between them leads less to the
// side than the next line is away.
bool face_each_other(const LineEnds& ends, std::int64_t a, std::int64_t b, double reach) noexcept {
    const glm::dvec3 gap = ends.place[b] - ends.place[a];
    if (!(glm::dot(ends.direction[a], ends.direction[b]) < -hatching_tuning.facing_cosine)) return false;
    for (const std::int64_t end : {a, b}) {
        const double ahead = glm::dot(ends.direction[end], gap);
        if (!(glm::length(gap - ahead * ends.direction[end]) <= hatching_tuning.farthest_aside * reach)) return false;
    }
    return glm::length(gap) <= reach;
}

// Returns for each end the end that it is joined to, or -1. The nearest pairs are joined first.
base::Array<std::int64_t> pair_ends(const Lines& lines, const LineEnds& ends, double reach,
                                    const base::Progress& progress) {
    struct Pair {
        double distance;
        std::int64_t a, b;
    };
    const geometry::PointGrid grid(ends.place, reach, progress);
    base::Array<Pair> pairs(lines.first.memory());
    for (const std::int64_t a : progress.over(ends.place.size())) {
        if (lines.closed[a / 2] != 0) continue;
        grid.around(ends.place[a], [&](std::int64_t at) {
            const std::int64_t b = grid.index(at);
            if (b > a && b / 2 != a / 2 && lines.closed[b / 2] == 0 && face_each_other(ends, a, b, reach))
                pairs.push_back({glm::distance(ends.place[a], ends.place[b]), a, b});
        });
    }
    const auto before = [](const Pair& x, const Pair& y) {
        return std::tie(x.distance, x.a, x.b) < std::tie(y.distance, y.a, y.b);
    };
    base::sort_long(pairs.begin(), pairs.end(), before, progress);
    base::Array<std::int64_t> partner(lines.first.memory());
    base::fill_long(partner, ends.place.size(), std::int64_t{-1}, progress);
    for (const Pair& pair : pairs) {
        if (partner[pair.a] >= 0 || partner[pair.b] >= 0) continue;
        partner[pair.a] = pair.b;
        partner[pair.b] = pair.a;
    }
    return partner;
}

// Appends the points of a line, beginning at one of its ends. If this end overlaps the points that `result` already
// has, its first points are left out, so that the joined line does not turn back.
void add_line_from_end(const Lines& lines, const LineEnds& ends, std::int64_t end, Lines& result,
                       const base::Progress& progress) {
    const std::int64_t line = end / 2;
    const std::int64_t last = lines.points(line) - 1;
    const auto point = [&](std::int64_t k) { return lines.first[line] + (end % 2 != 0 ? last - k : k); };
    std::int64_t begin = 0;
    if (const std::int64_t size = result.position.size(); size > result.first[result.count()]) {
        const glm::dvec3 before = result.position[size - 1];
        while (begin + 1 < last && glm::dot(lines.position[point(begin)] - before, ends.direction[end]) >= 0.0) ++begin;
    }
    for (std::int64_t k = begin; k <= last; ++k)
        result.add_point(lines.position[point(k)], lines.normal[point(k)], lines.level[point(k)], progress);
}

// ---- Lines and their points

constexpr std::int64_t lines_a_task = 16;

// The range of points of one line.
struct LineRange {
    std::int64_t begin, end;
    bool closed;

    // These return the next and the previous point along the line, or -1 beyond an end.
    [[nodiscard]] std::int64_t after(std::int64_t i) const noexcept {
        return i + 1 < end ? i + 1 : closed ? begin : -1;
    }
    [[nodiscard]] std::int64_t before(std::int64_t i) const noexcept {
        return i > begin ? i - 1 : closed ? end - 1 : -1;
    }
};

template <class Visit>
void for_lines(const base::Work& work, const Lines& lines, const Visit& visit) {
    work.for_chunks(lines.count(), lines_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t l = begin; l < end; ++l) {
            work.check();
            visit(LineRange{lines.first[l], lines.first[l + 1], lines.closed[l] != 0});
        }
    });
}

// Replaces each point of a line by moved(i, point before, point, point after). The arguments are the old positions.
// Open ends stay.
template <class Moved>
void move_between(geometry::VecArray& position, const LineRange& line, const Moved& moved) {
    const glm::dvec3 first = position[line.begin];
    glm::dvec3 before = line.closed ? position[line.end - 1] : first;
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        const glm::dvec3 here = position[i];
        const glm::dvec3 after = i + 1 < line.end ? position[i + 1] : first;
        if (line.before(i) >= 0 && line.after(i) >= 0) position.set(i, moved(i, before, here, after));
        before = here;
    }
}

// Sets `across` to unit tangents of the surface that are perpendicular to a line, or to 0 where the line has no
// direction.
void set_across(const Lines& lines, const LineRange& line, geometry::VecArray& across) {
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        const std::int64_t last = line.before(i);
        const std::int64_t next = line.after(i);
        const glm::dvec3 along = lines.position[next < 0 ? i : next] - lines.position[last < 0 ? i : last];
        const glm::dvec3 way = glm::cross(lines.normal[i], along);
        const double length = glm::length(way);
        across.set(i, length > 0.0 ? way / length : glm::dvec3(0.0));
    }
}

// ---- Neighbours

// Finds the neighbours of points: on each side, the nearest place where the plane perpendicular to the line meets
// another line, or a distant part of the same line.
class NeighbourSearch {
public:
    NeighbourSearch(const base::Work& work, const Lines& lines, const geometry::VecArray& across, double separation)
        : lines_(lines), across_(across), separation_(separation), next_(work.memory), last_(work.memory) {
        base::resize_long(next_, lines.position.size(), work);
        base::resize_long(last_, lines.position.size(), work);
        for_lines(work, lines, [&](const LineRange& line) {
            for (std::int64_t i = line.begin; i < line.end; ++i) {
                next_[i] = static_cast<std::int32_t>(line.after(i));
                last_[i] = static_cast<std::int32_t>(line.before(i));
            }
        });
    }

    // Finds all neighbours. Searches at every `searched_points`-th point of a line and at its end, and follows the
    // neighbouring lines from there to both sides.
    void find(const base::Work& work, LineNeighbours& neighbours) const {
        const geometry::PointGrid grid(lines_.position, reach(), work);
        const geometry::VecArray places = grid.in_order(lines_.position, work);
        for_lines(work, lines_, [&](const LineRange& line) {
            const auto is_searched = [&](std::int64_t i) {
                return (i - line.begin) % hatching_tuning.searched_points == 0 || i + 1 == line.end;
            };
            for (std::int64_t i = line.begin; i < line.end; ++i) {
                work.check();
                if (is_searched(i)) neighbours[i] = search(line, i, grid, places);
            }
            for (std::int64_t i = line.begin; i < line.end; ++i)
                if (!is_searched(i)) neighbours[i] = follow(line, i, neighbours[i - 1], no_neighbours());
            for (std::int64_t i = line.end - 1; i >= line.begin; --i)
                if (!is_searched(i)) neighbours[i] = follow(line, i, neighbours[i + 1], neighbours[i]);
        });
    }
    // Finds the neighbours again, after points have moved a little.
    void find_again(const base::Work& work, LineNeighbours& neighbours) const {
        for_lines(work, lines_, [&](const LineRange& line) {
            for (std::int64_t i = line.begin; i < line.end; ++i)
                neighbours[i] = follow(line, i, neighbours[i], no_neighbours());
        });
    }

private:
    using Pair = std::array<Neighbour, 2>;

    [[nodiscard]] double reach() const noexcept {
        return (hatching_tuning.neighbour_reach + hatching_tuning.even_step) * separation_;
    }
    [[nodiscard]] static Pair no_neighbours() noexcept {
        Pair none{};
        for (Neighbour& side : none) side.gap = static_cast<float>(hatching_tuning.neighbour_reach);
        return none;
    }
    // Two points of the same line are neighbours only where the line winds around.
    [[nodiscard]] static bool is_apart(const LineRange& line, std::int64_t i, std::int64_t j) noexcept {
        if (j < line.begin || j >= line.end) return true;
        const std::int64_t way = std::abs(i - j);
        const std::int64_t shortest = line.closed ? std::min(way, line.end - line.begin - way) : way;
        return static_cast<double>(shortest) * hatching_tuning.even_step >= hatching_tuning.least_way_around;
    }
    [[nodiscard]] glm::dvec3 along(std::int64_t i) const noexcept { return glm::cross(across_[i], lines_.normal[i]); }
    // Sets a neighbour of point i if the leg from point j to the next point is a nearer one. The two points must be on
    // different sides of the plane at point i; `from` and `to` are their distances from this plane.
    void look_at(const LineRange& line, std::int64_t i, std::int64_t j, double from, double to, Pair& found) const {
        if (!is_apart(line, i, j)) return;
        const glm::dvec3 p = lines_.position[i];
        const glm::dvec3 n = lines_.normal[i];
        const glm::dvec3 aside = across_[i];
        const double turned = glm::dot(across_[j], aside);
        if (!(glm::dot(n, lines_.normal[j]) > hatching_tuning.same_sheet_cosine) ||
            !(std::abs(turned) > hatching_tuning.parallel_cosine))
            return;
        const double share = from / (from - to);
        const glm::dvec3 there = glm::mix(lines_.position[j] - p, lines_.position[next_[j]] - p, share);
        const double offset = glm::dot(there, aside);
        const double height = glm::dot(there, n);
        if (std::abs(height) >
            hatching_tuning.steepest_offset * std::abs(offset) + hatching_tuning.thickness * separation_)
            return;
        Neighbour& best = found[offset > 0.0 ? 1 : 0];
        const auto gap = static_cast<float>(std::abs(offset) / separation_);
        if (gap < best.gap)
            best = {static_cast<std::int32_t>(j), next_[j], static_cast<float>(share), gap,
                    turned > 0.0 ? 1.0F : -1.0F};
    }
    [[nodiscard]] Pair search(const LineRange& line, std::int64_t i, const geometry::PointGrid& grid,
                              const geometry::VecArray& places) const {
        const glm::dvec3 p = lines_.position[i];
        const glm::dvec3 way = along(i);
        const double farthest = 2.0 * hatching_tuning.even_step * separation_;
        Pair found = no_neighbours();
        grid.around(p, [&](std::int64_t at) {
            const double from = glm::dot(places[at] - p, way);
            if (std::abs(from) > farthest) return;
            const std::int64_t j = grid.index(at);
            if (next_[j] < 0) return;
            const double to = glm::dot(lines_.position[next_[j]] - p, way);
            if ((from > 0.0) != (to > 0.0)) look_at(line, i, j, from, to, found);
        });
        return found;
    }
    // Returns the neighbours of point i: the nearest of those given in `found`, and of those on the lines that are
    // `known` as neighbours of a place near point i.
    [[nodiscard]] Pair follow(const LineRange& line, std::int64_t i, const Pair& known, Pair found) const {
        const glm::dvec3 p = lines_.position[i];
        const glm::dvec3 way = along(i);
        for (const Neighbour& side : known) {
            if (side.from < 0) continue;
            std::int64_t j = side.from;
            for (int step = 0; step < hatching_tuning.followed_points && j >= 0 && next_[j] >= 0; ++step) {
                const double from = glm::dot(lines_.position[j] - p, way);
                const double to = glm::dot(lines_.position[next_[j]] - p, way);
                if ((from > 0.0) != (to > 0.0)) {
                    look_at(line, i, j, from, to, found);
                    break;
                }
                // Both points are before the plane, or both are beyond it.
                j = (from > 0.0) == (from < to) ? last_[j] : next_[j];
            }
        }
        return found;
    }

    const Lines& lines_;
    const geometry::VecArray& across_;
    double separation_;
    base::Array<std::int32_t> next_, last_; // for each point: the next and the previous point of its line, or -1
};

// ---- Moves

// Averages the values along a line by an exponential mean, which runs forwards and backwards twice.
void average_along(const LineRange& line, float* values) {
    const std::int64_t count = line.end - line.begin;
    const std::int64_t run_up = line.closed ? std::min<std::int64_t>(hatching_tuning.run_up_points, count) : 0;
    const auto run = [&](const auto& at) {
        float mean = at(run_up == 0 ? 0 : count - run_up);
        for (std::int64_t i = count - run_up; i < count; ++i) mean += hatching_tuning.newest_share * (at(i) - mean);
        for (std::int64_t i = 0; i < count; ++i) at(i) = mean += hatching_tuning.newest_share * (at(i) - mean);
    };
    for (int twice = 0; twice < 2; ++twice) {
        run([&](std::int64_t i) -> float& { return values[line.begin + i]; });
        run([&](std::int64_t i) -> float& { return values[line.end - 1 - i]; });
    }
}

// Returns the distance of a point from the middle between its two neighbours after the moves of all three, in
// separations.
float offset_to_middle(const LineNeighbours& neighbours, const base::Array<float>& move, std::int64_t i) noexcept {
    std::array<float, 2> gap{};
    for (const std::size_t side : {0U, 1U}) {
        const Neighbour& n = neighbours[i][side];
        if (n.from < 0) return 0.0F;
        const float wider = n.sense * std::lerp(move[n.from], move[n.to], n.share) - move[i];
        gap[side] = n.gap + (side == 1 ? wider : -wider);
    }
    return 0.5F * (gap[1] - gap[0]);
}

// Returns for each point how far it should move across its line, in separations.
base::Array<float> even_moves(const base::Work& work, const Lines& lines, const LineNeighbours& neighbours) {
    base::Array<float> move(work.memory, neighbours.size());
    base::Array<float> wanted(work.memory, neighbours.size());
    for (int round = 0; round < hatching_tuning.moves; ++round) {
        for_lines(work, lines, [&](const LineRange& line) {
            for (std::int64_t i = line.begin; i < line.end; ++i)
                wanted[i] = hatching_tuning.move_share * std::clamp(offset_to_middle(neighbours, move, i), -0.5F, 0.5F);
            average_along(line, wanted.data());
        });
        for_lines(work, lines, [&](const LineRange& line) {
            for (std::int64_t i = line.begin; i < line.end; ++i) move[i] += wanted[i];
        });
    }
    return move;
}

// ---- Kinks

// Marks the points of kinks. A kink is a part of a line, two separations long, that turns too much within the surface.
// Returns whether the line has kinks. A part that turns by more than `singular_turn` is not marked, because the field
// itself turns there, around a singular point. Sets `turn` to the turn of the line at each point, in radians.
bool mark_kinks(const Lines& lines, const LineRange& line, base::Array<float>& turn, base::Array<std::uint8_t>& kink) {
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        kink[i] = 0;
        turn[i] = 0.0F;
        if (line.before(i) < 0 || line.after(i) < 0) continue;
        const glm::dvec3 n = lines.normal[i];
        const glm::dvec3 from = lines.position[i] - lines.position[line.before(i)];
        const glm::dvec3 to = lines.position[line.after(i)] - lines.position[i];
        const double cosine = glm::dot(from, to) - glm::dot(from, n) * glm::dot(to, n);
        turn[i] = static_cast<float>(std::atan2(glm::dot(glm::cross(from, to), n), cosine));
    }
    const auto for_part = [&](std::int64_t i, const auto& visit) {
        for (int k = 0; k < hatching_tuning.points_of_kink && i >= 0; ++k, i = line.after(i)) visit(i);
    };
    bool any = false;
    for (std::int64_t i = line.begin; i < line.end; ++i) {
        float sum = 0.0F;
        float most = 0.0F;
        for_part(i, [&](std::int64_t k) { most = std::max(most, std::abs(sum += turn[k])); });
        if (most <= hatching_tuning.most_turn || most > hatching_tuning.singular_turn) continue;
        for_part(i, [&](std::int64_t k) { kink[k] = 1; });
        any = true;
    }
    return any;
}

// Moves the points of kinks sideways, half of the way to the middle between the points before and after.
void straighten(const base::Work& work, Lines& lines, geometry::VecArray& across) {
    base::Array<float> turn(work.memory, lines.position.size());
    base::Array<std::uint8_t> kink(work.memory, lines.position.size());
    for_lines(work, lines, [&](const LineRange& line) {
        for (int round = 0; round < hatching_tuning.straightenings && mark_kinks(lines, line, turn, kink); ++round) {
            set_across(lines, line, across);
            move_between(lines.position, line,
                         [&](std::int64_t i, const glm::dvec3& before, const glm::dvec3& p, const glm::dvec3& after) {
                             const glm::dvec3 way = 0.5 * (before + after) - p;
                             return kink[i] != 0 ? p + 0.5 * glm::dot(way, across[i]) * across[i] : p;
                         });
        }
    });
}

// ---- Marks along lines

// Smooths the levels of marks. Where a crest of a coarse wave forks, the level of a line changes often, but only
// lasting changes should remain. So each mark gets the median level of the marks within `reach` along the line.
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

// Projects marks onto the surface. A mark that fails gets the normal 0.
void project_lines(const marks::Site& site, double separation, const geometry::Bounds& region, Lines& lines,
                   marks::LevelReport& report) {
    marks::MarkProjector projector(site);
    const std::int64_t count = lines.position.size();
    for (std::int64_t from = 0; from < count; from += marks::chunk_size) {
        projector.start.clear();
        const std::int64_t end = std::min(count, from + marks::chunk_size);
        for (std::int64_t i = from; i < end; ++i) projector.start.push_back(lines.position[i]);
        projector.project(separation, report, site.work.without_progress());
        for (std::int64_t i = from; i < end; ++i) {
            if (projector.placed(i - from) && !region.contains(projector.position(i - from)))
                projector.drop(i - from, report.dropped_strayed, report);
            lines.position.set(i, projector.position(i - from));
            lines.normal.set(i, projector.placed(i - from) ? projector.normal(i - from) : glm::dvec3(0.0));
        }
        site.work.update(static_cast<double>(end) / static_cast<double>(count));
    }
}

// Returns one number for each mark: 1 if the mark is on another sheet than the mark before it, else 0. In a closed
// line, the last mark is before the first. On a smooth surface, all numbers are 0. A mark on a crease gets the sheet
// and the normal of the mark before it or, if the line cannot continue so, of the mark after it.
base::Array<std::uint8_t> starts_at_creases(const marks::Site& site, Lines& lines) {
    base::Array<std::int32_t> sheet = surface::sheets_at(site.work, site.implicit, lines.position);
    base::Array<std::uint8_t> starts(site.memory(), sheet.size());
    const implicit::Sheets* const sheets = site.implicit.sheets();
    if (sheets == nullptr) return starts;
    const auto joins = [&](std::int64_t i, std::int32_t other) {
        const surface::SheetValue at = surface::sheet_at(*sheets, other, lines.position[i]);
        const double slope = glm::length(at.gradient);
        if (!(std::abs(at.value) <= hatching_tuning.sheet_tolerance * site.implicit.diagonal() * slope)) return false;
        lines.normal.set(i, at.gradient / slope);
        sheet[i] = other;
        return true;
    };
    const auto has_settled = [&](std::int64_t i) { return lines.normal[i] != glm::dvec3(0.0); };
    for (std::int64_t l = 0; l < lines.count(); ++l) {
        site.work.check();
        bool goes_on = false; // true if the two marks before mark i are on the same sheet
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

bool is_a_step(const glm::dvec3& a, const glm::dvec3& b, double step) noexcept {
    const double distance = glm::distance(a, b) / step;
    return distance > hatching_tuning.least_step && distance < hatching_tuning.most_step;
}

// A mark on a crease, which is added at the end of a line. A line ends where the mesh is split at a crease, but its
// last mark may have moved across the crease, to another sheet, or may lie at some distance before the crease.
struct CreaseEnd {
    surface::MeetingPlace place;
    bool replaces = false; // true if it replaces the last mark of the line, which is too close
};

CreaseEnd crease_end(const implicit::Sheets* sheets, const glm::dvec3& inner, const glm::dvec3& end, double step) {
    if (sheets == nullptr) return {};
    const double ahead = hatching_tuning.farthest_crease * step;
    const std::int32_t own = surface::active_at(*sheets, inner);
    const std::int32_t other = surface::active_at(*sheets, end + ahead * glm::normalize(end - inner));
    if (own == other) return {};
    surface::Meeting meeting;
    meeting.add(own);
    meeting.add(other);
    const surface::MeetingPlace place = surface::find_meeting(*sheets, {meeting, end, ahead}, 1e-7 * step);
    if (!place.found ||
        !surface::is_creased(own, other, glm::normalize(place.gradient[0]), glm::normalize(place.gradient[1])))
        return {};
    const bool replaces = glm::distance(place.position, end) <= hatching_tuning.least_step * step;
    return is_a_step(place.position, replaces ? inner : end, step) ? CreaseEnd{place, replaces} : CreaseEnd{};
}

// Divides lines into pieces. Each piece stays on the surface and crosses no crease.
Lines cut_lines(const marks::Site& site, const Lines& lines, const base::Array<std::uint8_t>& starts, double step) {
    Lines pieces(site.memory());
    const auto add = [&](std::int64_t l, std::int64_t begin, std::int64_t end) {
        const auto at = [&](std::int64_t k) { return lines.first[l] + k % lines.points(l); };
        const auto place = [&](std::int64_t k) { return lines.position[at(k)]; };
        if (end - begin < hatching_tuning.fewest_marks) return;
        const CreaseEnd head = crease_end(site.implicit.sheets(), place(begin + 1), place(begin), step);
        const CreaseEnd tail = crease_end(site.implicit.sheets(), place(end - 2), place(end - 1), step);
        const auto add_crease = [&](const surface::MeetingPlace& crease, std::int64_t k) {
            if (crease.found)
                pieces.add_point(crease.position, glm::normalize(crease.gradient[0]), lines.level[at(k)], site.work);
        };
        add_crease(head.place, begin);
        for (std::int64_t k = begin + (head.replaces ? 1 : 0); k < end - (tail.replaces ? 1 : 0); ++k)
            pieces.add_point(place(k), lines.normal[at(k)], lines.level[at(k)], site.work);
        add_crease(tail.place, end - 1);
        pieces.end_line(false);
    };
    for (std::int64_t l = 0; l < lines.count(); ++l) {
        // In a closed line, the first mark is repeated at the end.
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

} // namespace

void Lines::add_point(const glm::dvec3& at, const glm::dvec3& its_normal, std::uint8_t its_level,
                      const base::Progress& progress) {
    HRBFNPR_ASSERT(!(std::abs(glm::dot(its_normal, its_normal) - 1.0) > 1e-6));
    geometry::push_back_long(position, at, progress);
    geometry::push_back_long(normal, its_normal, progress);
    base::push_back_long(level, its_level, progress);
    progress.check();
}

void Lines::end_line(bool is_closed, std::uint8_t its_border) {
    HRBFNPR_ASSERT(position.size() > first[count()]);
    first.push_back(position.size());
    closed.push_back(is_closed ? 1 : 0);
    border.push_back(its_border);
}

Lines find_crests(const base::Work& work, const curves::SurfaceMesh& mesh, const Waves& waves, int levels) {
    HRBFNPR_ASSERT(waves.along.size() == mesh.vertices() && mesh.neighbour.size() == mesh.corner.size());
    const int halvings = std::max(0, levels - static_cast<int>(waves.finest()));
    Crossings found = cross_edges(work, mesh, waves, halvings);
    work.for_chunks(mesh.triangles(), triangles_a_task, [&](std::int64_t begin, std::int64_t end) {
        base::Array<std::int64_t> open(work.memory);
        for (std::int64_t t = begin; t < end; ++t) link_triangle(mesh, waves, t, found, open);
    });
    return follow_crests(mesh, found, work);
}

Lines join_ends(const Lines& lines, double reach, const base::Progress& progress) {
    HRBFNPR_ASSERT(reach > 0.0);
    const LineEnds ends = ends_of(lines, reach);
    const base::Array<std::int64_t> partner = pair_ends(lines, ends, reach, progress);
    Lines result(lines.first.memory());
    base::Array<std::uint8_t> taken(lines.first.memory(), lines.count());
    // Follows the line that has this end, then the line that is joined to its other end, and so on.
    const auto is_at_border = [&](std::int64_t end) {
        return (lines.border[end / 2] & (end % 2 == 0 ? Lines::begins_at_border : Lines::ends_at_border)) != 0;
    };
    const auto follow = [&](std::int64_t from) {
        std::int64_t end = from;
        std::int64_t other = from; // the other end of the line added last
        bool closed = lines.closed[from / 2] != 0;
        while (end >= 0 && taken[end / 2] == 0) {
            taken[end / 2] = 1;
            add_line_from_end(lines, ends, end, result, progress);
            other = end ^ 1;
            end = partner[other];
            closed = closed || end == from;
        }
        result.end_line(closed, border_bits(is_at_border(from), is_at_border(other)));
    };
    for (const bool open : {true, false})
        for (std::int64_t end = 0; end < ends.place.size(); ++end)
            if (taken[end / 2] == 0 && (!open || (partner[end] < 0 && lines.closed[end / 2] == 0))) follow(end);
    return result;
}

Lines resampled(const Lines& lines, double step, double shortest, const base::Progress& progress) {
    HRBFNPR_ASSERT(step > 0.0);
    Lines result(lines.first.memory());
    for (std::int64_t l = 0; l < lines.count(); ++l) {
        const std::int64_t count = lines.points(l);
        const std::int64_t legs = lines.closed[l] != 0 ? count : count - 1;
        const auto point = [&](std::int64_t k) { return lines.first[l] + k % count; };
        const auto leg = [&](std::int64_t k) {
            return glm::distance(lines.position[point(k)], lines.position[point(k + 1)]);
        };
        double length = 0.0;
        for (std::int64_t k = 0; k < legs; ++k) length += leg(k);
        const bool crosses_face = lines.border[l] == (Lines::begins_at_border | Lines::ends_at_border);
        if (!(length >= shortest) && !(crosses_face && length > hatching_tuning.least_step * step)) continue;
        const auto steps = static_cast<std::int64_t>(std::max(2.0, std::round(length / step)));
        std::int64_t k = 0;
        double before = 0.0; // the length of the line up to point k
        for (std::int64_t i = 0; i < (lines.closed[l] != 0 ? steps : steps + 1); ++i) {
            const double wanted = length * static_cast<double>(i) / static_cast<double>(steps);
            for (; k + 1 < legs && before + leg(k) < wanted; ++k) before += leg(k);
            const double share = leg(k) > 0.0 ? std::clamp((wanted - before) / leg(k), 0.0, 1.0) : 0.0;
            const std::int64_t from = point(k);
            const std::int64_t to = point(k + 1);
            result.add_point(glm::mix(lines.position[from], lines.position[to], share),
                             glm::normalize(glm::mix(lines.normal[from], lines.normal[to], share)),
                             lines.level[share < 0.5 ? from : to], progress);
        }
        result.end_line(lines.closed[l] != 0, lines.border[l]);
    }
    return result;
}

Lines even_out(const base::Work& work, const Lines& given, double separation) {
    HRBFNPR_ASSERT(separation > 0.0);
    Lines lines =
        resampled(given, hatching_tuning.even_step * separation, hatching_tuning.shortest_line * separation, work);
    // Points are smoothed, because points on mesh edges are exact only to a fraction of a cell.
    for_lines(work, lines, [&](const LineRange& line) {
        for (int round = 0; round < hatching_tuning.smoothings; ++round)
            move_between(lines.position, line,
                         [](std::int64_t, const glm::dvec3& before, const glm::dvec3& p, const glm::dvec3& after) {
                             return 0.25 * before + 0.5 * p + 0.25 * after;
                         });
    });
    geometry::VecArray across(work.memory);
    geometry::resize_long(across, lines.position.size(), work);
    LineNeighbours neighbours(work.memory);
    base::resize_long(neighbours, lines.position.size(), work);
    const NeighbourSearch search(work, lines, across, separation);
    const auto find = [&](bool again) {
        for_lines(work, lines, [&](const LineRange& line) { set_across(lines, line, across); });
        if (again)
            search.find_again(work, neighbours);
        else
            search.find(work, neighbours);
    };
    base::Array<std::uint8_t> stray(work.memory);
    for (int round = 0; round < hatching_tuning.rounds; ++round) {
        find(round > 0);
        if (round == 0) stray = find_strays(work, lines, neighbours, hatching_tuning.shortest_line * separation);
        const base::Array<float> move = even_moves(work, lines, neighbours);
        for_lines(work, lines, [&](const LineRange& line) {
            for (std::int64_t i = line.begin; i < line.end; ++i)
                lines.position.set(i, lines.position[i] + static_cast<double>(move[i]) * separation * across[i]);
        });
    }
    straighten(work, lines, across);
    find(true);
    return continue_into_forks(work, lines, neighbours, stray, separation);
}

void add_line_marks(const marks::Site& site, const Lines& given, double separation, double step,
                    const geometry::Bounds& region, marks::Marks& marks, marks::LayerReport& report) {
    HRBFNPR_ASSERT(separation > 0.0 && step > 0.0 && marks.count() == 0);
    Lines lines = resampled(given, step, 0.0, site.work);
    const double reach = std::ceil(0.5 * hatching_tuning.level_length * separation / step);
    smooth_levels(lines, static_cast<std::int64_t>(reach));
    marks::LevelReport& level = report.of(0);
    project_lines(site, separation, region, lines, level);
    const base::Array<std::uint8_t> starts = starts_at_creases(site, lines);
    const Lines pieces = cut_lines(site, lines, starts, step);
    // A mark that converged but is in no piece counts as strayed. The marks that were added on creases, and the
    // repeated first marks of closed lines, count as attempted and placed, too.
    const std::int64_t all = pieces.position.size();
    const std::int64_t added = std::max<std::int64_t>(0, all - level.placed);
    level.attempted += added;
    level.dropped_strayed += level.placed + added - all;
    level.placed = all;
    struct PieceOrder {
        std::uint8_t level; // the coarsest level of the marks in the piece
        std::int64_t piece;
    };
    base::Array<PieceOrder> order(site.memory());
    for (std::int64_t p = 0; p < pieces.count(); ++p)
        order.push_back(
            {*std::min_element(pieces.level.begin() + pieces.first[p], pieces.level.begin() + pieces.first[p + 1]), p});
    base::sort_long(order.begin(), order.end(), [](const PieceOrder& a, const PieceOrder& b) {
        return std::tie(a.level, a.piece) < std::tie(b.level, b.piece);
    });
    std::uint32_t number = 0;
    for (const PieceOrder& next : order) {
        site.work.check();
        const double middle = static_cast<double>(marks.count()) + 0.5 * static_cast<double>(pieces.points(next.piece));
        const std::int64_t first = pieces.first[next.piece];
        const std::int64_t last = pieces.first[next.piece + 1] - 1;
        for (std::int64_t i = first; i <= last; ++i) {
            const glm::dvec3 n = pieces.normal[i];
            glm::dvec3 way = pieces.position[std::min(last, i + 1)] - pieces.position[std::max(first, i - 1)];
            // A closed line of two points comes back to the first.
            if (way == glm::dvec3(0.0)) way = pieces.position[i] - pieces.position[std::max(first, i - 1)];
            marks.position.push_back(pieces.position[i]);
            marks.normal.push_back(n);
            marks.direction.push_back(glm::normalize(way - glm::dot(way, n) * n));
            marks.key.push_back(static_cast<std::uint64_t>(marks.count() - 1));
            marks.stroke.push_back(2 * number);
            marks.place.push_back(static_cast<std::int32_t>(i - first));
            marks.level.push_back(pieces.level[i]);
            marks.rank.push_back(marks::rank_of(1.0 - middle / static_cast<double>(all)));
        }
        ++number;
    }
    report.full_count = all;
}

} // namespace hrbfnpr::hatching
