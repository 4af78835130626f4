// SPDX-License-Identifier: MIT
// The steps of sorting a group's lines:
// 1. join_lines pairs ends in the order of the cost of joining them, and makes one line of each chain of pairs.
// 2. fill_lines, for each line wider than its pen:
//    a. find_nodes computes places along the centre line, and how far to either side the pen may go at each.
//    b. find_passes makes evenly spaced tracks parallel to the centre line, each where the line is wide enough.
//    c. link_passes joins passes whose ends are near each other into one line.
#include "output/vector/plot_lines.h"

#include "geometry/point_tree.h"
#include "output/vector/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace hrbfnpr::output {
namespace {

using drawing::Cap;
using glm::dvec2;

// ---- Joining

struct LineEnd {
    dvec2 place, outward; // `outward` is the direction out of the line
};

// Returns the direction out of the line at an end. It is measured over at least one width of the line, because nearer
// points are unreliable.
dvec2 outward_of(std::span<const PagePoint> points, bool at_end, double width) noexcept {
    const std::size_t count = points.size();
    const dvec2 end = place_of(at_end ? points[count - 1] : points[0]);
    dvec2 way(0.0);
    for (std::size_t i = 1; i < count; ++i) {
        way = end - place_of(at_end ? points[count - 1 - i] : points[i]);
        if (glm::dot(way, way) >= width * width) break;
    }
    const double length = glm::length(way);
    return length > 0.0 ? way / length : dvec2(0.0);
}

// Returns the ends of all lines: ends 2 i and 2 i + 1 are the beginning and the end of line i.
base::Array<LineEnd> ends_of(const PlotLines& lines, const base::Progress& progress) {
    base::Array<LineEnd> ends(lines.points.memory());
    ends.reserve(2 * lines.lines.size());
    CancelChecks checks(progress, steps_per_check);
    for (const PlotLine& line : lines.lines) {
        checks.count();
        const std::span<const PagePoint> points = lines.points_of(line);
        ends.push_back({place_of(points.front()), outward_of(points, false, line.width)});
        ends.push_back({place_of(points.back()), outward_of(points, true, line.width)});
    }
    return ends;
}

struct EndPair {
    double cost;
    std::int32_t a, b; // indices of the ends, in ascending order
};

// Returns the cost of joining end a of one line to end b of another line; -1 if they must not be joined.
double cost_of(const PlotLine& line, const PlotLine& other, const LineEnd& a, const LineEnd& b, double most) noexcept {
    const double distance = glm::distance(a.place, b.place);
    if (distance > most) return -1.0;
    const double turn = std::acos(std::clamp(-glm::dot(a.outward, b.outward), -1.0, 1.0));
    if (turn > plot_tuning.sharpest_join) return -1.0;
    if (distance > plot_tuning.longest_free_link * std::min(line.width, other.width)) {
        const dvec2 link = (b.place - a.place) / distance;
        const double least = std::cos(plot_tuning.sharpest_join);
        if (glm::dot(a.outward, link) < least || glm::dot(b.outward, -link) < least) return -1.0;
    }
    return distance / most + turn / plot_tuning.sharpest_join;
}

// Returns the pairs of ends that may be joined, cheapest first. Sets goes_on for lines that continue as a line of
// another opacity.
base::Array<EndPair> find_pairs(PlotLines& lines, double given, bool any_opacity, const base::Progress& progress) {
    const base::Array<LineEnd> ends = ends_of(lines, progress);
    base::Memory& memory = lines.points.memory();
    geometry::VecArray places(memory);
    base::Array<std::int32_t> free(memory); // the ends that may be joined: those of open lines
    CancelChecks checks(progress, steps_per_check);
    for (std::int32_t end = 0; end < ends.size(); ++end) {
        checks.count();
        if (lines.lines[end / 2].closed) continue;
        places.push_back({ends[end].place, 0.0});
        free.push_back(end);
    }
    const geometry::PointTree tree(places, progress);
    const auto any = [](std::int64_t) { return true; };
    base::Array<EndPair> pairs(memory);
    for (std::int64_t at = 0; at < tree.size(); ++at) {
        checks.count();
        const std::int32_t a = free[tree.index(at)];
        PlotLine& line = lines.lines[a / 2];
        const double reach = given > 0.0 ? given : line.width;
        // The array has room for one more neighbour, because the tree also returns the end itself.
        std::array<std::int64_t, plot_tuning.most_neighbours + 1> near;
        const std::int64_t count =
            tree.nearest(tree.points()[at], plot_tuning.most_neighbours + 1, any, any, near.data(), reach);
        for (std::int64_t i = 0; i < count; ++i) {
            const std::int32_t b = free[tree.index(near[static_cast<std::size_t>(i)])];
            if (!(glm::distance(ends[a].place, ends[b].place) < reach)) break;
            if (b == a || (a / 2 == b / 2 && line.count < 3)) continue;
            const PlotLine& other = lines.lines[b / 2];
            // A pair is found from both of its ends, or only from one end if the other has many neighbours.
            const double cost =
                cost_of(line, other, ends[a], ends[b], given > 0.0 ? given : std::min(line.width, other.width));
            if (cost < 0.0) continue;
            if (any_opacity || std::abs(line.opacity - other.opacity) <= static_cast<double>(drawing::faintest_ink))
                pairs.push_back({cost, std::min(a, b), std::max(a, b)});
            else
                line.goes_on = true;
        }
    }
    CancelChecks comparisons(progress, comparisons_per_check);
    std::sort(pairs.begin(), pairs.end(), [&](const EndPair& p, const EndPair& q) {
        comparisons.count();
        if (p.cost != q.cost) return p.cost < q.cost;
        return p.a != q.a ? p.a < q.a : p.b < q.b;
    });
    return pairs;
}

struct EndPairing {
    base::Array<std::int32_t> partner; // the end that each end is joined to; -1: none
    std::int64_t joins = 0;
};

// Accepts each pair whose ends are both unpaired. Pairs that would close a short ring are rejected.
EndPairing choose_pairs(const PlotLines& lines, const base::Array<EndPair>& pairs, const base::Progress& progress) {
    base::Memory& memory = lines.points.memory();
    const auto count = static_cast<std::int32_t>(lines.lines.size());
    EndPairing result{base::Array<std::int32_t>(memory, 2 * std::int64_t{count})};
    std::fill(result.partner.begin(), result.partner.end(), -1);
    // For each line, its parent in a union-find structure: another line of its chain, or the line itself.
    base::Array<std::int32_t> chain(memory, count);
    base::Array<double> length(memory, count); // the length of each chain, mm, stored at the chain's root
    CancelChecks checks(progress, steps_per_check);
    for (std::int32_t i = 0; i < count; ++i) {
        checks.count();
        chain[i] = i;
        length[i] = length_of(lines.points_of(lines.lines[i]));
    }
    const auto chain_of = [&](std::int32_t line) {
        while (chain[line] != line) line = chain[line] = chain[chain[line]];
        return line;
    };
    for (const EndPair& pair : pairs) {
        checks.count();
        HRBFNPR_ASSERT(pair.a < pair.b && pair.b < 2 * count);
        if (result.partner[pair.a] >= 0 || result.partner[pair.b] >= 0) continue;
        const std::int32_t a = chain_of(pair.a / 2), b = chain_of(pair.b / 2);
        if (a == b && length[a] < plot_tuning.shortest_ring * lines.lines[pair.a / 2].width) continue;
        if (a != b) {
            chain[b] = a;
            length[a] += length[b];
        }
        result.partner[pair.a] = pair.b;
        result.partner[pair.b] = pair.a;
        ++result.joins;
    }
    return result;
}

// ---- Filling: nodes

struct Node {
    dvec2 place, normal; // the place on the centre line, and the unit normal to the left
    double reach;        // how far the pen's centre may go to either side of the line
    double at;           // the distance along the line
};

// One pass: a range along the line, on one side of it.
struct Pass {
    std::int64_t first, count; // the points of the pass
    double begin, end;         // distances along the line
    bool used;
};

// A track for passes, parallel to the centre line at the distance `level` on one side. The track exists only where the
// reach of the line exceeds `least`. Up to this reach, the tracks closer to the centre line fill the line.
struct Track {
    double side, level, least;
};

// A line that is being filled, and working memory.
struct Filling {
    explicit Filling(base::Memory& memory) noexcept : nodes(memory), turned(memory), points(memory), passes(memory) {}

    double pen = 0.0, spacing = 0.0, length = 0.0;
    bool closed = false;
    base::Array<Node> nodes, turned;
    base::Array<dvec2> points; // the points of all passes, pass by pass
    base::Array<Pass> passes;
};

dvec2 unit_or_right(const dvec2& way) noexcept {
    const double length = glm::length(way);
    return length > 0.0 ? way / length : dvec2(1.0, 0.0);
}

Node between(const Node& a, const Node& b, double t) noexcept {
    return {a.place + t * (b.place - a.place), a.normal + t * (b.normal - a.normal), a.reach + t * (b.reach - a.reach),
            a.at + t * (b.at - a.at)};
}

// Makes a closed line start where it is narrow, so that few passes cross the start.
void begin_where_narrow(Filling& f) {
    f.nodes.back().place = f.nodes[0].place;
    const std::int64_t last = f.nodes.size() - 1;
    const double length = f.nodes[last].at;
    const std::int64_t least = std::min_element(f.nodes.begin(), f.nodes.begin() + last,
                                                [](const Node& a, const Node& b) { return a.reach < b.reach; }) -
                               f.nodes.begin();
    f.turned.clear();
    for (std::int64_t i = 0; i <= last; ++i) {
        Node node = f.nodes[(least + i) % last];
        node.at += (least + i >= last ? length : 0.0) - f.nodes[least].at;
        f.turned.push_back(node);
    }
    std::swap(f.nodes, f.turned);
}

// Shortens the line by half of the pen's width at its beginning.
void shorten(Filling& f) {
    const double begin = f.nodes[0].at, cut = 0.5 * f.pen;
    const auto way = [&](const Node& node) { return std::abs(node.at - begin); };
    if (way(f.nodes.back()) <= 2.0 * cut) return;
    std::int64_t i = 1;
    while (way(f.nodes[i]) <= cut) ++i;
    const double t = (cut - way(f.nodes[i - 1])) / (way(f.nodes[i]) - way(f.nodes[i - 1]));
    f.nodes[i - 1] = between(f.nodes[i - 1], f.nodes[i], t);
    std::copy(f.nodes.begin() + (i - 1), f.nodes.end(), f.nodes.begin());
    f.nodes.resize(f.nodes.size() - (i - 1));
}

// Extends or shortens an end of the line, so that the round pen stops where the line's cap ends.
void add_cap(Filling& f, Cap cap, bool at_end) {
    if (at_end) std::reverse(f.nodes.begin(), f.nodes.end());
    const double reach = f.nodes[0].reach, least = 1e-3 * f.pen;
    if (reach > least && cap == Cap::flat) {
        shorten(f);
    } else if (reach > least) {
        const dvec2 out = unit_or_right(f.nodes[0].place - f.nodes[1].place);
        const Node end = f.nodes[0];
        f.turned.clear();
        const auto add = [&](double way, double left) {
            f.turned.push_back({end.place + way * out, dvec2(0.0), left, end.at + (at_end ? way : -way)});
        };
        if (cap == Cap::pointed) {
            add(2.0 * static_cast<double>(drawing::point_length) * reach, 0.0);
        } else {
            const int parts = plot_tuning.parts_of_cap;
            for (int i = parts; i > 0; --i) {
                const double angle = 0.5 * std::numbers::pi * i / parts;
                add(reach * std::sin(angle), i < parts ? reach * std::cos(angle) : 0.0);
            }
        }
        for (const Node& node : f.nodes) f.turned.push_back(node);
        std::swap(f.nodes, f.turned);
    }
    if (at_end) std::reverse(f.nodes.begin(), f.nodes.end());
}

// Computes the normals. A sharp turn gets several nodes at the same place.
void find_normals(Filling& f) {
    f.turned.clear();
    const std::int64_t last = f.nodes.size() - 1;
    const auto along = [&](std::int64_t i) { return unit_or_right(f.nodes[i + 1].place - f.nodes[i].place); };
    for (std::int64_t i = 0; i <= last; ++i) {
        const dvec2 before = along(i > 0 ? i - 1 : f.closed ? last - 1 : 0);
        const dvec2 after = along(i < last ? i : f.closed ? 0 : last - 1);
        const double turn = std::atan2(before.x * after.y - before.y * after.x, glm::dot(before, after));
        const auto parts = static_cast<int>(std::abs(turn) / plot_tuning.widest_turn);
        for (int part = 0; part <= parts; ++part) {
            const double angle = parts > 0 ? turn * part / parts : 0.5 * turn;
            const dvec2 direction{before.x * std::cos(angle) - before.y * std::sin(angle),
                                  before.x * std::sin(angle) + before.y * std::cos(angle)};
            Node node = f.nodes[i];
            node.normal = {direction.y, -direction.x};
            f.turned.push_back(node);
        }
    }
    std::swap(f.nodes, f.turned);
}

void find_nodes(Filling& f, std::span<const PagePoint> points, const PlotLine& line) {
    HRBFNPR_ASSERT(!points.empty() && f.pen > 0.0);
    f.nodes.clear();
    for (const PagePoint& p : points) {
        const double reach = p.radius - 0.5 * f.pen;
        const double way = f.nodes.empty() ? 1.0 : glm::distance(f.nodes.back().place, place_of(p));
        if (way <= plot_tuning.same_point)
            f.nodes.back().reach = std::max(f.nodes.back().reach, reach);
        else
            f.nodes.push_back({place_of(p), dvec2(0.0), reach, f.nodes.empty() ? 0.0 : f.nodes.back().at + way});
    }
    f.closed = line.closed && f.nodes.size() > 3;
    if (f.nodes.size() == 1) { // the line is a disc, if its ends are round
        Node other = f.nodes[0];
        other.place.x += plot_tuning.same_point;
        other.at += plot_tuning.same_point;
        f.nodes.push_back(other);
    }
    if (f.closed)
        begin_where_narrow(f);
    else
        for (const bool at_end : {false, true}) add_cap(f, at_end ? line.end : line.begin, at_end);
    for (Node& node : f.nodes) node.reach = std::max(node.reach, 0.0);
    f.length = f.nodes.back().at - f.nodes[0].at;
    find_normals(f);
}

// ---- Filling: passes

void add_pass(Filling& f, const Track& track, double begin, double end) {
    HRBFNPR_ASSERT(begin <= end);
    Pass pass{f.points.size(), 0, begin, end, false};
    const auto put = [&](const Node& node) {
        f.points.push_back(node.place + track.side * std::min(track.level, node.reach) * node.normal);
    };
    for (std::int64_t i = 1; i < f.nodes.size(); ++i) {
        const Node &a = f.nodes[i - 1], &b = f.nodes[i];
        if (b.at < begin || a.at > end) continue;
        const double way = b.at - a.at;
        const auto share = [&](double place) { return way > 0.0 ? (place - a.at) / way : 0.0; };
        if (f.points.size() == pass.first) put(between(a, b, std::max(share(begin), 0.0)));
        // The pass has a corner where the side of the line crosses the track's level.
        const double kink = a.reach != b.reach ? (track.level - a.reach) / (b.reach - a.reach) : -1.0;
        if (kink > 0.0 && kink < 1.0 && a.at + kink * way > begin && a.at + kink * way < end) put(between(a, b, kink));
        put(between(a, b, b.at > end ? share(end) : 1.0));
    }
    pass.count = f.points.size() - pass.first;
    if (pass.count > 1) f.passes.push_back(pass);
}

// Adds a pass for each sequence of nodes where the line is wide enough. Passes with short gaps between them are merged.
void add_track(Filling& f, const Track& track) {
    double begin = 0.0, end = -1.0; // the range of the current pass along the line, in mm
    bool open = false;
    const auto close = [&] {
        if (open && (end - begin >= plot_tuning.shortest_pass * f.pen || track.least < 0.0))
            add_pass(f, track, begin, end);
        open = false;
    };
    for (std::int64_t i = 1; i < f.nodes.size(); ++i) {
        const Node &a = f.nodes[i - 1], &b = f.nodes[i];
        const double over_a = a.reach - track.least, over_b = b.reach - track.least;
        if (over_a <= 0.0 && over_b <= 0.0) continue;
        const double way = b.at - a.at;
        const double from = over_a > 0.0 ? a.at : a.at + way * over_a / (over_a - over_b);
        const double to = over_b > 0.0 ? b.at : a.at + way * over_a / (over_a - over_b);
        if (!open || from - end > plot_tuning.longest_gap * f.pen) {
            close();
            begin = from;
            open = true;
        }
        end = to;
    }
    close();
}

// Adds the passes from one side to the other. In the middle there is either one pass on the centre line, or a pair of
// passes at half a spacing on either side of the centre line, whichever makes the total length of the passes shorter.
void find_passes(Filling& f) {
    f.points.clear();
    f.passes.clear();
    double most = 0.0;
    for (const Node& node : f.nodes) most = std::max(most, node.reach);
    const double least = plot_tuning.unfilled_strip * f.pen, spacing = f.spacing;
    const auto steps = [&](double reach) { return reach > least ? std::ceil((reach - least) / spacing) : 0.0; };
    double single = 0.0, pairs = 0.0;
    for (std::int64_t i = 1; i < f.nodes.size(); ++i) {
        const double way = f.nodes[i].at - f.nodes[i - 1].at;
        const double reach = 0.5 * (f.nodes[i].reach + f.nodes[i - 1].reach);
        single += way * (1.0 + 2.0 * steps(reach));
        pairs += way * (reach > least ? 2.0 + 2.0 * steps(reach - 0.5 * spacing) : 1.0);
    }
    const bool in_pairs = pairs < single;
    const double first = in_pairs ? 0.5 * spacing : spacing; // the level of the pair that is nearest to the centre
    const auto levels = static_cast<int>(std::max(0.0, std::ceil((most - least - first) / spacing))) + 1;
    const auto level = [&](int i) { return first + spacing * (i - 1); };
    const auto inside = [&](int i) { return (i > 1 ? level(i - 1) : 0.0) + least; };
    for (int i = levels; i > 0; --i) add_track(f, {-1.0, level(i), inside(i)});
    if (!in_pairs) add_track(f, {1.0, 0.0, -1.0});
    for (int i = 1; i <= levels; ++i) add_track(f, {1.0, level(i), in_pairs && i == 1 ? -1.0 : inside(i)});
}

// Returns the nearest pass to which the pen can move without leaving the line; -1 if there is no such pass.
std::int64_t nearest_pass(const Filling& f, const dvec2& from, double at, bool& reversed) noexcept {
    double least = plot_tuning.longest_link * f.pen;
    std::int64_t found = -1;
    for (std::int64_t i = 0; i < f.passes.size(); ++i) {
        const Pass& pass = f.passes[i];
        if (pass.used) continue;
        for (const bool at_end : {false, true}) {
            const double way = glm::distance(from, f.points[pass.first + (at_end ? pass.count - 1 : 0)]);
            double step = std::abs(at - (at_end ? pass.end : pass.begin));
            if (f.closed) step = std::min(step, f.length - step);
            if (way >= least || step > plot_tuning.longest_step * f.pen) continue;
            least = way;
            found = i;
            reversed = at_end;
        }
    }
    return found;
}

void link_passes(Filling& f, const PlotLine& line, PlotLines& out) {
    for (std::int64_t start = 0; start < f.passes.size(); ++start) {
        if (f.passes[start].used) continue;
        PlotLine chain;
        chain.first = out.points.size();
        chain.width = line.width;
        chain.opacity = line.opacity;
        const bool is_ring = f.closed && f.passes[start].end - f.passes[start].begin >= f.length;
        bool reversed = false;
        std::int64_t parts = 0;
        for (std::int64_t next = start; next >= 0; ++parts) {
            Pass& pass = f.passes[next];
            pass.used = true;
            for (std::int64_t i = 0; i < pass.count; ++i) {
                const dvec2& p = f.points[pass.first + (reversed ? pass.count - 1 - i : i)];
                out.points.push_back({p.x, p.y, 0.5 * f.pen});
            }
            const double at = reversed ? pass.begin : pass.end;
            next = nearest_pass(f, place_of(out.points.back()), at, reversed);
        }
        chain.count = out.points.size() - chain.first;
        chain.closed = is_ring && parts == 1;
        if (chain.closed) out.points.back() = out.points[chain.first];
        out.lines.push_back(chain);
    }
}

} // namespace

std::int64_t join_lines(PlotLines& lines, double distance, bool any_opacity, const base::Progress& progress) {
    const EndPairing pairing = choose_pairs(lines, find_pairs(lines, distance, any_opacity, progress), progress);
    PlotLines joined(lines.points.memory());
    joined.points.reserve(lines.points.size());
    PlotLine chain; // the joined line that is being built
    double length = 0.0, ink = 0.0;
    CancelChecks checks(progress, steps_per_check);
    const auto enter = [&](std::int32_t end) {
        checks.count();
        const PlotLine& line = lines.lines[end / 2];
        const bool reversed = end % 2 != 0;
        const std::int64_t before = joined.points.size();
        if (chain.count == 0) { // the chain starts
            chain = line;
            chain.first = before;
            chain.begin = reversed ? line.end : line.begin;
        }
        const std::span<const PagePoint> points = lines.points_of(line);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const PagePoint& p = points[reversed ? points.size() - 1 - i : i];
            const bool stands_there = i == 0 && before > chain.first && place_of(joined.points.back()) == place_of(p);
            if (!stands_there) joined.points.push_back(p);
        }
        const double part = length_of(points);
        length += part;
        ink += part * line.opacity;
        chain.width = std::min(chain.width, line.width);
        chain.goes_on = chain.goes_on || line.goes_on;
        chain.end = reversed ? line.begin : line.end;
    };
    const auto leave = [&](bool ring) {
        if (length > 0.0) chain.opacity = ink / length; // the mean opacity, weighted by length
        if (ring) {
            const PagePoint first = joined.points[chain.first];
            if (place_of(joined.points.back()) != place_of(first)) joined.points.push_back(first);
            chain.closed = true;
        }
        chain.count = joined.points.size() - chain.first;
        joined.lines.push_back(chain);
        chain = PlotLine{};
        length = ink = 0.0;
    };
    geometry::follow_chains(pairing.partner, enter, leave);
    std::swap(lines, joined);
    return pairing.joins;
}

bool is_wider_than(double pen, std::span<const PagePoint> points) noexcept {
    const double widest = (0.5 + plot_tuning.unfilled_strip) * pen;
    return std::any_of(points.begin(), points.end(), [&](const PagePoint& p) { return p.radius > widest; });
}

std::int64_t fill_lines(PlotLines& lines, double tolerance, const base::Progress& progress) {
    std::int64_t count = 0;
    PlotLines filled(lines.points.memory());
    Filling f(lines.points.memory());
    for (const PlotLine& line : lines.lines) {
        check_cancel(progress);
        const std::span<const PagePoint> points = lines.points_of(line);
        if (!is_wider_than(line.width, points)) {
            filled.add(line, points);
            continue;
        }
        f.pen = line.width;
        find_nodes(f, points, line);
        double most = 0.0;
        for (const Node& node : f.nodes) most = std::max(most, node.reach);
        // Passes are closer together than the pen's width, because the error of a pass may be as large as the
        // tolerance.
        f.spacing =
            std::max(std::clamp(f.pen - tolerance, plot_tuning.least_spacing * f.pen, plot_tuning.most_spacing * f.pen),
                     2.0 * most / plot_tuning.most_passes);
        find_passes(f);
        link_passes(f, line, filled);
        ++count;
    }
    if (count > 0) std::swap(lines, filled);
    return count;
}

} // namespace hrbfnpr::output
