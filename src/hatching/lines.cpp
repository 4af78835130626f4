// SPDX-License-Identifier: MIT
#include "hatching/lines.h"

#include "base/sort.h"
#include "geometry/long_vec_array.h"
#include "geometry/point_grid.h"
#include "hatching/tuning.h"

#include <algorithm>
#include <bit>
#include <numbers>
#include <tuple>

namespace hrbfnpr::hatching {
namespace {

constexpr std::int64_t triangles_a_task = 4096;

// ---- Crests of waves

// A crest over an edge of the mesh, from vertex a to b.
struct Crossing {
    double share;      // the place on the way from a to b, from 0 to 1
    std::int32_t a, b; // vertices
    bool rises;        // whether the phase grows, in the sense of a's line
    std::uint8_t level;
};

// Edge 3 t + k of a mesh runs from corner k of triangle t to the next one. On both sides of an edge stands a triangle;
// the one of the lower number owns it.
std::int32_t end_of(const curves::SurfaceMesh& mesh, std::int64_t edge) noexcept {
    return mesh.corner[edge - edge % 3 + (edge % 3 + 1) % 3];
}
bool is_owned(const curves::SurfaceMesh& mesh, std::int64_t edge) noexcept {
    return mesh.neighbour[edge] < 0 || edge / 3 < mesh.neighbour[edge];
}
// The same edge as the triangle across has it; -1 if no triangle is there.
std::int64_t across(const curves::SurfaceMesh& mesh, std::int64_t edge) noexcept {
    const std::int64_t other = 3 * std::int64_t{mesh.neighbour[edge]};
    for (std::int64_t k = other; k >= 0 && k < other + 3; ++k)
        if (mesh.corner[k] == end_of(mesh, edge) && end_of(mesh, k) == mesh.corner[edge]) return k;
    return -1;
}

// Calls visit(crossing, number of its line) for all crests of the finest wave between two vertices, and for
// 2^halvings - 1 lines between any two crests, in the order of their numbers.
template <class Visit>
void visit_crests(const Waves& waves, int halvings, std::int32_t a, std::int32_t b, const Visit& visit) {
    constexpr double tau = 2.0 * std::numbers::pi;
    if (!waves.has_line(a) || !waves.has_line(b)) return;
    const double scale = std::ldexp(1.0, halvings) / tau;
    const double growth = waves.growth(a, b, waves.period_of(waves.finest()));
    const double begin = std::arg(waves.level[waves.finest()][a]);
    const double end = std::arg(seen(waves.level[waves.finest()][b], waves.turned(a, b)));
    const double change = growth + std::remainder(end - begin - growth, tau);
    const double last = scale * std::max(begin, begin + change);
    for (double k = std::floor(scale * std::min(begin, begin + change)) + 1.0; k <= last; k += 1.0) {
        const double share = std::clamp((k / scale - begin) / change, 0.0, 1.0);
        visit(Crossing{share, a, b, change > 0.0, 0}, static_cast<std::int64_t>(k));
    }
}

// A wave that was halved r times less than the finest lines has every 2^r-th of them. Where the number of a line tells
// no more, the waves say whether they have a crest there.
std::uint8_t level_of(const Waves& waves, int halvings, const Crossing& c, std::int64_t line) noexcept {
    const int twos = std::countr_zero(static_cast<std::uint64_t>(line));
    if (twos < halvings) return static_cast<std::uint8_t>(waves.finest() + halvings - twos);
    for (std::int64_t coarser = waves.finest() - 1; coarser >= 0; --coarser) {
        const double growth = waves.growth(c.a, c.b, waves.period_of(coarser));
        const Complex at_b = seen(waves.level[coarser][c.b], waves.turned(c.a, c.b));
        const Complex from_a = product(waves.level[coarser][c.a], std::polar(1.0 - c.share, c.share * growth));
        const Complex from_b = product(at_b, std::polar(c.share, (c.share - 1.0) * growth));
        if (std::real(from_a + from_b) < 0.0) return static_cast<std::uint8_t>(coarser + 1);
    }
    return 0;
}

struct Crossings {
    explicit Crossings(base::Memory& memory) noexcept : first(memory), crossing(memory), link(memory) {}

    // The number of the first crossing of each edge, and the end. An edge that another triangle owns has none.
    base::Array<std::int64_t> first;
    base::Array<Crossing> crossing; // in their order along the edge
    // Two for each crossing: the next one in the owner's triangle, and the next one in the triangle across; -1: none.
    base::Array<std::int64_t> link;
};

Crossings cross_edges(const base::Runtime& runtime, const curves::SurfaceMesh& mesh, const Waves& waves, int halvings,
                      const base::Progress& progress) {
    Crossings found(runtime.memory);
    const std::int64_t edges = mesh.corner.size();
    base::resize_long(found.first, edges + 1, progress);
    const auto for_edges = [&](const auto& visit) {
        runtime.parallel.for_chunks(edges, triangles_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t edge = begin; edge < end; ++edge)
                if (is_owned(mesh, edge)) visit(edge, mesh.corner[edge], end_of(mesh, edge));
        });
    };
    for_edges([&](std::int64_t edge, std::int32_t a, std::int32_t b) {
        visit_crests(waves, halvings, a, b, [&](const Crossing&, std::int64_t) { ++found.first[edge + 1]; });
    });
    for (std::int64_t edge = 0; edge < edges; ++edge) {
        if (edge % base::at_once<std::int64_t> == 0) progress.check();
        found.first[edge + 1] += found.first[edge];
    }
    found.crossing.resize_for_overwrite(found.first[edges]);
    base::fill_long(found.link, 2 * found.first[edges], std::int64_t{-1}, progress);
    for_edges([&](std::int64_t edge, std::int32_t a, std::int32_t b) {
        std::int64_t at = found.first[edge];
        visit_crests(waves, halvings, a, b, [&](Crossing c, std::int64_t line) {
            c.level = level_of(waves, halvings, c, line);
            found.crossing[at++] = c;
        });
        HRBFNPR_ASSERT(at == found.first[edge + 1]);
        // On an edge on which the phase falls the lines come in reverse.
        if (at > found.first[edge] && !found.crossing[found.first[edge]].rises)
            std::reverse(found.crossing.data() + found.first[edge], found.crossing.data() + at);
    });
    return found;
}

// Around a triangle a line that comes in goes out where the phase comes back: neighbours of opposite sense belong to
// one line, and the crossings between them are done. Lines that are left over end here, at a fork.
void link_triangle(const curves::SurfaceMesh& mesh, const Waves& waves, std::int64_t triangle, Crossings& found,
                   base::Array<std::int64_t>& open) {
    const std::int32_t corner = mesh.corner[3 * triangle];
    const std::int32_t next = mesh.corner[3 * triangle + 1];
    const std::int32_t last = mesh.corner[3 * triangle + 2];
    const bool next_turned = waves.turned(corner, next);
    const bool last_turned = waves.turned(corner, last);
    if ((next_turned != last_turned) != waves.turned(next, last)) return; // the lines turn by half around here
    open.clear(); // 2 * crossing + 1 where the phase rises, in the sense of the first corner's line
    const auto add = [&](std::int64_t crossing, bool backwards, bool owned) {
        const Crossing& c = found.crossing[crossing];
        const bool turned = c.a == next ? next_turned : c.a == last && last_turned;
        const bool rises = (c.rises != turned) != backwards;
        // The side of each crossing that is in this triangle.
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
        if (is_owned(mesh, edge)) {
            for (std::int64_t c = found.first[edge]; c < found.first[edge + 1]; ++c) add(c, false, true);
        } else if (const std::int64_t other = across(mesh, edge); other >= 0) {
            for (std::int64_t c = found.first[other + 1] - 1; c >= found.first[other]; --c) add(c, true, false);
        }
    }
}

// Lines from their ends first, then closed ones; not those that cross one edge only.
Lines walk(const curves::SurfaceMesh& mesh, const Crossings& found, const base::Progress& progress) {
    Lines lines(mesh.position.memory());
    base::Array<std::uint8_t> taken(mesh.position.memory(), found.crossing.size());
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
            if (next < 0 || taken[next] != 0) return lines.end_line(next == from);
            last = at;
            at = next;
        }
    };
    for (const bool open : {true, false})
        for (std::int64_t c = 0; c < found.crossing.size(); ++c) {
            if (c % triangles_a_task == 0) progress.check();
            const int links = (found.link[2 * c] >= 0 ? 1 : 0) + (found.link[2 * c + 1] >= 0 ? 1 : 0);
            if (taken[c] == 0 && links == (open ? 1 : 2)) follow(c);
        }
    return lines;
}

// ---- Ends of lines

// End 2 l is the begin of line l, 2 l + 1 its end; `way` leads outwards.
struct Ends {
    geometry::VecArray place, way;
};

// Points near an end know their place only to a part of the mesh's cells, so that its direction is told by some more.
Ends ends_of(const Lines& lines, double reach) {
    Ends ends{geometry::VecArray(lines.first.memory()), geometry::VecArray(lines.first.memory())};
    for (std::int64_t l = 0; l < lines.count(); ++l)
        for (const std::int64_t step : {1, -1}) {
            const std::int64_t last = lines.points(l) - 1;
            const std::int64_t end = lines.first[l] + (step > 0 ? 0 : last);
            const auto distance = [&](std::int64_t k) {
                return glm::distance(lines.position[end + k * step], lines.position[end]);
            };
            std::int64_t k = std::min(hatching_tuning.fewest_to_end, last);
            while (k < last && distance(k) < hatching_tuning.end_length * reach) ++k;
            ends.place.push_back(lines.position[end]);
            ends.way.push_back(glm::normalize(lines.position[end] - lines.position[end + k * step]));
        }
    return ends;
}

// Over a gap that is hardly one the way across says nothing, and the ends' directions say less.
bool face_each_other(const Ends& ends, std::int64_t a, std::int64_t b, double reach) noexcept {
    const glm::dvec3 gap = ends.place[b] - ends.place[a];
    const double length = glm::length(gap);
    if (length < hatching_tuning.touching * reach)
        return glm::dot(ends.way[a], ends.way[b]) < -hatching_tuning.touching_cosine;
    const double least = hatching_tuning.facing_cosine * length;
    return length <= reach && glm::dot(ends.way[a], gap) > least && glm::dot(ends.way[b], gap) < -least;
}

// For each end the one that it is joined to; -1: none. The nearest are joined first.
base::Array<std::int64_t> partners(const Lines& lines, const Ends& ends, double reach, const base::Progress& progress) {
    struct Pair {
        double distance;
        std::int64_t a, b;
    };
    const geometry::PointGrid grid(ends.place, reach, progress);
    base::Array<Pair> pairs(lines.first.memory());
    for (std::int64_t a = 0; a < ends.place.size(); ++a) {
        if (a % 256 == 0) progress.check();
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

// Adds the points of a line from one of its ends on. Where ends lie beside each other, or one beyond the other, points
// that would lead back are left out.
void add_from(const Lines& lines, const Ends& ends, std::int64_t end, Lines& result, const base::Progress& progress) {
    const std::int64_t line = end / 2;
    const std::int64_t last = lines.points(line) - 1;
    const auto point = [&](std::int64_t k) { return lines.first[line] + (end % 2 != 0 ? last - k : k); };
    std::int64_t begin = 0;
    if (const std::int64_t size = result.position.size(); size > result.first[result.count()]) {
        const glm::dvec3 before = result.position[size - 1];
        while (begin + 1 < last && glm::dot(lines.position[point(begin)] - before, ends.way[end]) >= 0.0) ++begin;
    }
    for (std::int64_t k = begin; k <= last; ++k)
        result.add_point(lines.position[point(k)], lines.normal[point(k)], lines.level[point(k)], progress);
}

} // namespace

void Lines::add_point(const glm::dvec3& at, const glm::dvec3& its_normal, std::uint8_t its_level,
                      const base::Progress& progress) {
    HRBFNPR_ASSERT(!(std::abs(glm::dot(its_normal, its_normal) - 1.0) > 1e-6));
    geometry::push_back_long(position, at, progress);
    geometry::push_back_long(normal, its_normal, progress);
    base::push_back_long(level, its_level, progress);
    if (position.size() % 512 == 0) progress.check();
}

void Lines::end_line(bool is_closed) {
    HRBFNPR_ASSERT(position.size() > first[count()]);
    first.push_back(position.size());
    closed.push_back(is_closed ? 1 : 0);
}

Lines find_crests(const base::Runtime& runtime, const curves::SurfaceMesh& mesh, const Waves& waves, int levels,
                  const base::Progress& progress) {
    HRBFNPR_ASSERT(waves.along.size() == mesh.vertices() && mesh.neighbour.size() == mesh.corner.size());
    const int halvings = std::max(0, levels - static_cast<int>(waves.finest()));
    Crossings found = cross_edges(runtime, mesh, waves, halvings, progress);
    runtime.parallel.for_chunks(mesh.triangles(), triangles_a_task, progress,
                                [&](std::int64_t begin, std::int64_t end) {
                                    base::Array<std::int64_t> open(runtime.memory);
                                    for (std::int64_t t = begin; t < end; ++t)
                                        link_triangle(mesh, waves, t, found, open);
                                });
    return walk(mesh, found, progress);
}

Lines join_ends(const Lines& lines, double reach, const base::Progress& progress) {
    HRBFNPR_ASSERT(reach > 0.0);
    const Ends ends = ends_of(lines, reach);
    const base::Array<std::int64_t> partner = partners(lines, ends, reach, progress);
    Lines result(lines.first.memory());
    base::Array<std::uint8_t> taken(lines.first.memory(), lines.count());
    // From this end into its line, and on.
    const auto follow = [&](std::int64_t from) {
        std::int64_t end = from;
        bool closed = lines.closed[from / 2] != 0;
        while (end >= 0 && taken[end / 2] == 0) {
            taken[end / 2] = 1;
            add_from(lines, ends, end, result, progress);
            end = partner[end ^ 1];
            closed = closed || end == from;
        }
        result.end_line(closed);
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
        if (!(length >= shortest)) continue;
        const auto steps = static_cast<std::int64_t>(std::max(2.0, std::round(length / step)));
        std::int64_t k = 0;
        double before = 0.0; // the length up to point k
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
        result.end_line(lines.closed[l] != 0);
    }
    return result;
}

} // namespace hrbfnpr::hatching
