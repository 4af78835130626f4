// SPDX-License-Identifier: MIT
#include "output/vector/fill_lines.h"

#include "output/vector/look.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace hrbfnpr::output {
namespace {

using drawing::Cap;
using glm::dvec2;

// In widths of the pen.
constexpr double most_spacing = 0.8;
constexpr double least_spacing = 0.4;
constexpr double left_out = 0.1;      // of each side of a line, that is not worth another pass
constexpr double shortest = 0.5;      // pass
constexpr double longest_gap = 2.0;   // that a pass goes on through
constexpr double longest_link = 12.0; // across the line, which is quicker than to lift the pen
constexpr double longest_step = 3.0;  // and along it

constexpr double most_passes = 10000.0;                         // of one line
constexpr double widest_turn = 20.0 / 180.0 * std::numbers::pi; // that one normal stands for
constexpr int parts_of_cap = 6;

dvec2 left_of_line(const dvec2& direction) noexcept { return {direction.y, -direction.x}; }

dvec2 direction_of(const dvec2& way) noexcept {
    const double length = glm::length(way);
    return length > 0.0 ? way / length : dvec2(1.0, 0.0);
}

} // namespace

FillLines::FillLines(base::Memory& memory) noexcept
    : nodes_(memory), turned_(memory), points_(memory), passes_(memory), filled_(memory) {}

bool FillLines::is_wider(std::span<const PagePoint> points, double pen) noexcept {
    double most = 0.0;
    for (const PagePoint& p : points) most = std::max(most, p.radius);
    return most > (0.5 + left_out) * pen;
}

std::int64_t FillLines::fill(PlotLines& lines, double tolerance, const base::Progress& progress) {
    std::int64_t count = 0;
    filled_.clear();
    for (const PlotLine& line : lines.lines) {
        look(progress);
        const std::span<const PagePoint> points = lines.points_of(line);
        pen_ = line.width;
        if (!is_wider(points, pen_)) {
            PlotLine same = line;
            same.first = filled_.points.size();
            for (const PagePoint& p : points) filled_.points.push_back(p);
            filled_.lines.push_back(same);
            continue;
        }
        // Each pass may stray by the tolerance from its place.
        spacing_ = std::clamp(pen_ - tolerance, least_spacing * pen_, most_spacing * pen_);
        find_nodes(points, line);
        find_passes();
        link_passes(line, filled_);
        ++count;
    }
    if (count > 0) {
        std::swap(lines.points, filled_.points);
        std::swap(lines.lines, filled_.lines);
    }
    return count;
}

void FillLines::add_place(const PagePoint& p) {
    constexpr double nowhere = 1e-6;
    const double reach = p.radius - 0.5 * pen_;
    const dvec2 place = place_of(p);
    double at = 0.0;
    if (!nodes_.empty()) {
        Node& last = nodes_.back();
        const double way = glm::distance(last.place, place);
        if (way <= nowhere) {
            last.reach = std::max(last.reach, reach);
            return;
        }
        at = last.at + way;
    }
    nodes_.push_back({place, dvec2(0.0), reach, at});
}

void FillLines::find_nodes(std::span<const PagePoint> points, const PlotLine& line) {
    nodes_.clear();
    for (const PagePoint& p : points) add_place(p);
    closed_ = line.closed && nodes_.size() > 3;
    if (nodes_.size() == 1) { // a disc, if its ends are round
        Node other = nodes_[0];
        other.place.x += 1e-6;
        other.at += 1e-6;
        nodes_.push_back(other);
    }
    if (closed_)
        begin_where_narrow();
    else
        for (const bool at_end : {false, true}) add_cap(at_end ? line.end : line.begin, at_end);
    double most = 0.0;
    for (Node& node : nodes_) {
        node.reach = std::max(node.reach, 0.0);
        most = std::max(most, node.reach);
    }
    spacing_ = std::max(spacing_, 2.0 * most / most_passes);
    length_ = nodes_.back().at - nodes_[0].at;
    find_normals(closed_);
}

// So that as few passes as can be go on behind the end.
void FillLines::begin_where_narrow() {
    nodes_.back().place = nodes_[0].place;
    const std::int64_t last = nodes_.size() - 1;
    const double length = nodes_[last].at;
    std::int64_t least = 0;
    for (std::int64_t i = 1; i < last; ++i)
        if (nodes_[i].reach < nodes_[least].reach) least = i;
    turned_.clear();
    for (std::int64_t i = 0; i <= last; ++i) {
        Node node = nodes_[(least + i) % last];
        node.at += (least + i >= last ? length : 0.0) - nodes_[least].at;
        turned_.push_back(node);
    }
    std::swap(nodes_, turned_);
}

// The pen, which is round, ends where the line does.
void FillLines::add_cap(Cap cap, bool at_end) {
    if (at_end) std::reverse(nodes_.begin(), nodes_.end());
    const double reach = nodes_[0].reach, least = 1e-3 * pen_;
    if (reach > least && cap == Cap::flat) {
        shorten(at_end);
    } else if (reach > least) {
        const dvec2 out = direction_of(nodes_[0].place - nodes_[1].place);
        const Node end = nodes_[0];
        turned_.clear();
        const auto add = [&](double way, double left) {
            turned_.push_back({end.place + way * out, dvec2(0.0), left, end.at + (at_end ? way : -way)});
        };
        if (cap == Cap::pointed) {
            add(2.0 * static_cast<double>(drawing::point_length) * reach, 0.0);
        } else {
            for (int i = parts_of_cap; i > 0; --i) {
                const double angle = 0.5 * std::numbers::pi * i / parts_of_cap;
                add(reach * std::sin(angle), i < parts_of_cap ? reach * std::cos(angle) : 0.0);
            }
        }
        for (const Node& node : nodes_) turned_.push_back(node);
        std::swap(nodes_, turned_);
    }
    if (at_end) std::reverse(nodes_.begin(), nodes_.end());
}

// By half of the pen from the first node on.
void FillLines::shorten(bool at_end) {
    const double length = std::abs(nodes_.back().at - nodes_[0].at), cut = 0.5 * pen_;
    if (length <= 2.0 * cut) return;
    const double sign = at_end ? -1.0 : 1.0;
    const double begin = nodes_[0].at;
    const auto way = [&](const Node& node) { return sign * (node.at - begin); };
    std::int64_t i = 1;
    while (way(nodes_[i]) <= cut) ++i;
    const double t = (cut - way(nodes_[i - 1])) / (way(nodes_[i]) - way(nodes_[i - 1]));
    nodes_[i - 1] = between(nodes_[i - 1], nodes_[i], t);
    std::copy(nodes_.begin() + (i - 1), nodes_.end(), nodes_.begin());
    nodes_.resize(nodes_.size() - (i - 1));
}

// Where the line turns much, several nodes stand in one place.
void FillLines::find_normals(bool closed) {
    turned_.clear();
    const std::int64_t last = nodes_.size() - 1;
    const auto along = [&](std::int64_t i) { return direction_of(nodes_[i + 1].place - nodes_[i].place); };
    for (std::int64_t i = 0; i <= last; ++i) {
        const dvec2 before = along(i > 0 ? i - 1 : closed ? last - 1 : 0);
        const dvec2 after = along(i < last ? i : closed ? 0 : last - 1);
        const double turn = std::atan2(before.x * after.y - before.y * after.x, glm::dot(before, after));
        const auto parts = static_cast<int>(std::abs(turn) / widest_turn);
        for (int part = 0; part <= parts; ++part) {
            const double angle = parts > 0 ? turn * part / parts : 0.5 * turn;
            const dvec2 direction{before.x * std::cos(angle) - before.y * std::sin(angle),
                                  before.x * std::sin(angle) + before.y * std::cos(angle)};
            Node node = nodes_[i];
            node.normal = left_of_line(direction);
            turned_.push_back(node);
        }
    }
    std::swap(nodes_, turned_);
}

// Whether passes on either side of the centre, half a spacing from it, are shorter than one along it and those beside.
bool FillLines::goes_in_pairs() const noexcept {
    const double least = left_out * pen_;
    const auto steps = [&](double reach) { return reach > least ? std::ceil((reach - least) / spacing_) : 0.0; };
    double single = 0.0, pairs = 0.0;
    for (std::int64_t i = 1; i < nodes_.size(); ++i) {
        const double way = nodes_[i].at - nodes_[i - 1].at;
        const double reach = 0.5 * (nodes_[i].reach + nodes_[i - 1].reach);
        single += way * (1.0 + 2.0 * steps(reach));
        pairs += way * (reach > least ? 2.0 + 2.0 * steps(reach - 0.5 * spacing_) : 1.0);
    }
    return pairs < single;
}

// From one side to the other.
void FillLines::find_passes() {
    points_.clear();
    passes_.clear();
    double most = 0.0;
    for (const Node& node : nodes_) most = std::max(most, node.reach);
    const double least = left_out * pen_;
    const double first = goes_in_pairs() ? 0.5 * spacing_ : spacing_; // level beside the centre
    const auto levels = static_cast<int>(std::max(0.0, std::ceil((most - least - first) / spacing_))) + 1;
    const auto level = [&](int i) { return first + spacing_ * (i - 1); };
    const auto inside = [&](int i) { return (i > 1 ? level(i - 1) : 0.0) + least; };
    for (int i = levels; i > 0; --i) add_track({-1.0, level(i), inside(i)});
    if (first == spacing_) add_track({1.0, 0.0, -1.0});
    for (int i = 1; i <= levels; ++i) add_track({1.0, level(i), first < spacing_ && i == 1 ? -1.0 : inside(i)});
}

FillLines::Node FillLines::between(const Node& a, const Node& b, double t) noexcept {
    return {a.place + t * (b.place - a.place), a.normal + t * (b.normal - a.normal), a.reach + t * (b.reach - a.reach),
            a.at + t * (b.at - a.at)};
}

// Runs of nodes that reach far enough; those near to each other are one.
void FillLines::add_track(const Track& track) {
    double begin = 0.0, end = -1.0; // of the pass that is open, along the line
    bool open = false;
    const auto close = [&] {
        if (open && (end - begin >= shortest * pen_ || track.least < 0.0)) add_pass(track, begin, end);
        open = false;
    };
    for (std::int64_t i = 1; i < nodes_.size(); ++i) {
        const Node &a = nodes_[i - 1], &b = nodes_[i];
        const double over_a = a.reach - track.least, over_b = b.reach - track.least;
        if (over_a <= 0.0 && over_b <= 0.0) continue;
        const double way = b.at - a.at;
        const double from = over_a > 0.0 ? a.at : a.at + way * over_a / (over_a - over_b);
        const double to = over_b > 0.0 ? b.at : a.at + way * over_a / (over_a - over_b);
        if (!open || from - end > longest_gap * pen_) {
            close();
            begin = from;
            open = true;
        }
        end = to;
    }
    close();
}

void FillLines::put(const Track& track, const Node& node) {
    const dvec2 p = node.place + track.side * std::min(track.level, node.reach) * node.normal;
    points_.push_back(p);
}

void FillLines::add_pass(const Track& track, double begin, double end) {
    Pass pass{points_.size(), 0, begin, end, false};
    for (std::int64_t i = 1; i < nodes_.size(); ++i) {
        const Node &a = nodes_[i - 1], &b = nodes_[i];
        if (b.at < begin || a.at > end) continue;
        const double way = b.at - a.at;
        const auto at = [&](double place) { return way > 0.0 ? (place - a.at) / way : 0.0; };
        if (points_.size() == pass.first) put(track, between(a, b, std::max(at(begin), 0.0)));
        // Where the side of the line comes nearer than the level, or leaves it behind.
        const double kink = a.reach != b.reach ? (track.level - a.reach) / (b.reach - a.reach) : -1.0;
        if (kink > 0.0 && kink < 1.0 && a.at + kink * way > begin && a.at + kink * way < end)
            put(track, between(a, b, kink));
        put(track, between(a, b, b.at > end ? at(end) : 1.0));
    }
    pass.count = points_.size() - pass.first;
    if (pass.count > 1) passes_.push_back(pass);
}

// Of two places along the line.
double FillLines::apart(double a, double b) const noexcept {
    const double way = std::abs(a - b);
    return closed_ ? std::min(way, length_ - way) : way;
}

// Whose end the pen can go on to without leaving the line; -1: none.
std::int64_t FillLines::nearest_pass(const dvec2& from, double at, bool& reversed) const noexcept {
    double least = longest_link * pen_;
    std::int64_t found = -1;
    for (std::int64_t i = 0; i < passes_.size(); ++i) {
        const Pass& pass = passes_[i];
        if (pass.used) continue;
        for (const bool at_end : {false, true}) {
            const double way = glm::distance(from, points_[pass.first + (at_end ? pass.count - 1 : 0)]);
            if (way >= least || apart(at, at_end ? pass.end : pass.begin) > longest_step * pen_) continue;
            least = way;
            found = i;
            reversed = at_end;
        }
    }
    return found;
}

void FillLines::link_passes(const PlotLine& line, PlotLines& out) {
    for (std::int64_t start = 0; start < passes_.size(); ++start) {
        if (passes_[start].used) continue;
        PlotLine chain;
        chain.first = out.points.size();
        chain.width = line.width;
        chain.opacity = line.opacity;
        const bool is_ring = closed_ && passes_[start].end - passes_[start].begin >= length_;
        bool reversed = false;
        std::int64_t parts = 0;
        for (std::int64_t next = start; next >= 0; ++parts) {
            Pass& pass = passes_[next];
            pass.used = true;
            for (std::int64_t i = 0; i < pass.count; ++i) {
                const dvec2& p = points_[pass.first + (reversed ? pass.count - 1 - i : i)];
                out.points.push_back({p.x, p.y, 0.5 * pen_});
            }
            const dvec2 end = place_of(out.points.back());
            const double at = reversed ? pass.begin : pass.end;
            next = nearest_pass(end, at, reversed);
        }
        chain.count = out.points.size() - chain.first;
        chain.closed = is_ring && parts == 1;
        if (chain.closed) out.points.back() = out.points[chain.first];
        out.lines.push_back(chain);
    }
}

} // namespace hrbfnpr::output
