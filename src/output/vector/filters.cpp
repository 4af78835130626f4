// SPDX-License-Identifier: MIT
#include "output/vector/filters.h"

#include "geometry/point_tree.h"
#include "output/vector/tuning.h"

#include <array>
#include <cmath>

namespace hrbfnpr::output {
namespace {

constexpr std::int64_t lines_a_look = 64;

// Dashes and gaps by turns, in line widths; the first 0 ends the pattern.
using Pattern = std::array<double, 10>;
constexpr double dot = 0.5, gap = 3.0, space = 18.0, short_dash = 6.0, dash = 12.0, long_dash = 24.0;
constexpr std::array<Pattern, 16> patterns{{
    {},
    {},
    {dash, gap},
    {dash, space},
    {long_dash, gap, dot, gap},
    {long_dash, gap, dot, gap, dot, gap},
    {long_dash, gap, dot, gap, dot, gap, dot, gap},
    {dot, gap},
    {long_dash, gap, short_dash, gap},
    {long_dash, gap, short_dash, gap, short_dash, gap},
    {dash, gap, dot, gap},
    {dash, gap, dash, gap, dot, gap},
    {dash, gap, dot, gap, dot, gap},
    {dash, gap, dash, gap, dot, gap, dot, gap},
    {dash, gap, dot, gap, dot, gap, dot, gap},
    {dash, gap, dash, gap, dot, gap, dot, gap, dot, gap},
}};
static_assert(patterns.size() == static_cast<std::size_t>(LineType::last) + 1);
// A line with more periods is drawn whole: they are too small to be told apart, and writing them would never end.
constexpr double most_periods = 1e5;

} // namespace

void LineTypes::path(const PagePath& path) {
    HRBFNPR_ASSERT(path.points.size() > 1);
    const Pattern& pattern = patterns[std::min(static_cast<std::size_t>(group_.line_type), patterns.size() - 1)];
    double width = group_.pen_width;
    if (!(width > 0.0)) {
        width = 0.0;
        for (const PagePoint& p : path.points) width = std::max(width, 2.0 * p.radius);
    }
    const double length = length_of(path.points);
    double period = 0.0;
    for (const double part : pattern) period += width * part;
    const double first = width * pattern[0];
    if (!(first > 0.0) || length <= first || !(length <= most_periods * period)) {
        next_.path(path);
        return;
    }
    // The pattern is scaled so that a whole number of periods fit, and a dash after the last one of an open line.
    const double open = path.closed ? 0.0 : first;
    const double times = std::max(std::floor((length - open) / period + 0.5), 1.0);
    const double scale = length / (times * period + open);
    PagePath piece = path;
    piece.closed = false;
    piece.begin = piece.end = drawing::Cap::flat;
    std::size_t at = 0; // in the pattern
    double left = scale * first;
    part_.clear();
    part_.push_back(path.points[0]);
    const auto emit = [&] {
        piece.points = part_.span();
        if (at % 2 == 0 && part_.size() > 1) next_.path(piece);
    };
    for (std::size_t i = 1; i < path.points.size(); ++i) {
        PagePoint a = path.points[i - 1];
        const PagePoint& b = path.points[i];
        double rest = glm::distance(place_of(a), place_of(b));
        while (rest > left) {
            a = between(a, b, left / rest);
            rest -= left;
            part_.push_back(a);
            emit();
            part_.clear();
            part_.push_back(a);
            at = at + 1 < pattern.size() && pattern[at + 1] > 0.0 ? at + 1 : 0;
            left = scale * width * pattern[at];
        }
        left -= rest;
        part_.push_back(b);
    }
    if (left < scale * width * pattern[at] * (1.0 - 1e-9)) emit();
}

// [Liang and Barsky 1984, "A new concept and method for line clipping"]
bool Clip::within(const PagePoint& a, const PagePoint& b, const Frame& frame, double& from, double& to) noexcept {
    if (!std::isfinite(a.x + a.y + b.x + b.y)) return false;
    const double dx = b.x - a.x, dy = b.y - a.y;
    // For each side: how fast the segment leaves through it, and how far from it the segment begins.
    const std::array<double, 4> speed{-dx, dx, -dy, dy};
    const std::array<double, 4> room{a.x - frame.left, frame.right - a.x, a.y - frame.top, frame.bottom - a.y};
    for (std::size_t side = 0; side < 4; ++side) {
        if (speed[side] == 0.0 && room[side] < 0.0) return false;
        if (speed[side] < 0.0) from = std::max(from, room[side] / speed[side]);
        if (speed[side] > 0.0) to = std::min(to, room[side] / speed[side]);
    }
    return from < to;
}

PlotOrder::PlotOrder(base::Memory& memory, PageSink& next, const PageSettings& settings, PageCounts& counts,
                     PenTrack* track, const base::Progress& progress)
    : PageFilter(next), memory_(memory), settings_(settings), counts_(counts), track_(track), progress_(progress),
      looks_(progress, lines_a_look), frame_{0.0, 0.0, settings.width, settings.height}, lines_(memory), dots_(memory),
      clip_(memory), pen_lines_(memory), turned_(memory), pen_(0.0, settings.height) {}

void PlotOrder::begin_view(const PageView& view) {
    const Frame& own = view.frame;
    frame_ = {std::max(0.0, own.left), std::max(0.0, own.top), std::min(settings_.width, own.right),
              std::min(settings_.height, own.bottom)};
    next_.begin_view(view);
}

void PlotOrder::end_view() {
    frame_ = {0.0, 0.0, settings_.width, settings_.height};
    next_.end_view();
}

void PlotOrder::begin_group(const PageGroup& group) {
    group_ = group;
    if (settings_.for_plotter() && !(group_.pen_width > 0.0)) group_.pen_width = plotter_pen;
    lines_.clear();
    dots_.clear();
    if (track_ != nullptr) track_->raise();
    next_.begin_group(group_);
}

void PlotOrder::clip(const PagePath& path, const PlotLine& like, PlotLines& to) {
    looks_.count();
    clip_.parts(path, frame_, [&](const PagePath& part) {
        PlotLine line = like;
        line.width = like.width > 0.0 ? like.width : mean_width(part.points);
        line.opacity = part.opacity;
        line.begin = part.begin;
        line.end = part.end;
        line.closed = part.closed;
        to.add(line, part.points);
    });
}

void PlotOrder::path(const PagePath& path) {
    PlotLine like;
    like.width = group_.pen_width;
    clip(path, like, lines_);
}

void PlotOrder::dot(const PageDot& dot) {
    looks_.count();
    if (frame_.contains(dot.x, dot.y)) dots_.push_back(dot);
}

void PlotOrder::end_group() {
    const bool dashed = group_.line_type > LineType::continuous;
    if (!dashed) { // dots of dashed lines are short, and their gaps are meant
        counts_.joined += join_lines(lines_, settings_.plot.join, group_.pen_width > 0.0, progress_);
        drop_short();
    }
    if (settings_.shapes.fills && group_.pen_width > 0.0) {
        counts_.filled_paths += fill_lines(lines_, settings_.shapes.tolerance, progress_);
        PlotLines within(memory_); // passes beside the centre may lie beyond the frame where that does not
        for (const PlotLine& line : lines_.lines) clip(lines_.path_of(line), line, within);
        std::swap(lines_, within);
    }
    drop_near_dots();
    hand_on();
    next_.end_group();
}

bool PlotOrder::fills(std::span<const PagePoint> points, double pen) const noexcept {
    return settings_.shapes.fills && group_.pen_width > 0.0 && is_wider_than(pen, points);
}

void PlotOrder::drop_short() {
    const auto is_short = [&](const PlotLine& line) {
        looks_.count();
        const double least =
            settings_.plot.shortest > 0.0 ? settings_.plot.shortest : plot_tuning.shortest_line * line.width;
        const std::span<const PagePoint> points = lines_.points_of(line);
        return !line.goes_on && !fills(points, line.width) && !(length_of(points) >= least);
    };
    const std::int64_t kept = std::remove_if(lines_.lines.begin(), lines_.lines.end(), is_short) - lines_.lines.begin();
    counts_.dropped_paths += lines_.lines.size() - kept;
    lines_.lines.resize(kept);
}

double PlotOrder::pen_of(const PageDot& dot) const noexcept {
    return group_.pen_width > 0.0 ? group_.pen_width : 2.0 * dot.radius;
}

// Each dot in its order takes away those after it that are too near.
void PlotOrder::drop_near_dots() {
    geometry::VecArray places(memory_);
    for (const PageDot& dot : dots_) places.push_back({dot.x, dot.y, 0.0});
    const geometry::PointTree tree(places, progress_);
    base::Array<std::uint8_t> taken(memory_, dots_.size());
    std::int64_t kept = 0;
    for (std::int64_t i = 0; i < dots_.size(); ++i) {
        looks_.count();
        if (taken[i] != 0) continue;
        const PageDot dot = dots_[i];
        const double least =
            settings_.plot.dot_distance > 0.0 ? settings_.plot.dot_distance : plot_tuning.shortest_line * pen_of(dot);
        tree.within(places[i], least, [&](std::int64_t at, double square) {
            if (square < least * least) taken[tree.index(at)] = 1;
        });
        dots_[kept++] = dot;
    }
    counts_.dropped_dots += dots_.size() - kept;
    dots_.resize(kept);
}

void PlotOrder::hand_on() {
    look(progress_);
    base::Array<PagePoint> places(memory_);
    for (const PageDot& dot : dots_) places.push_back({dot.x, dot.y, dot.radius});
    base::Array<Stop> stops(memory_); // lines, then dots
    for (const PlotLine& line : lines_.lines) stops.push_back({lines_.points_of(line), line.closed});
    for (std::int64_t i = 0; i < places.size(); ++i)
        stops.push_back({places.span().subspan(static_cast<std::size_t>(i), 1), false});
    for (const Leg& leg : find_tour(memory_, stops.span(), pen_, progress_)) {
        looks_.count();
        if (leg.stop < lines_.lines.size()) {
            put(lines_.path_of(lines_.lines[leg.stop]), leg);
            continue;
        }
        const PageDot& dot = dots_[leg.stop - lines_.lines.size()];
        pen_ = {dot.x, dot.y};
        if (track_ != nullptr) track_->draw(pen_lines_.line(dot, pen_of(dot), settings_.shapes, track_->place()));
        next_.dot(dot);
    }
}

void PlotOrder::put(PagePath path, const Leg& leg) {
    const std::size_t count = path.points.size();
    turned_.clear();
    if (path.closed) {
        for (std::size_t i = 0; i < count; ++i)
            turned_.push_back(path.points[(static_cast<std::size_t>(leg.start) + i) % (count - 1)]);
        path.points = turned_.span();
    } else if (leg.reversed) {
        std::swap(path.begin, path.end);
        for (std::size_t i = count; i > 0; --i) turned_.push_back(path.points[i - 1]);
        path.points = turned_.span();
    }
    pen_ = place_of(path.points.back());
    if (track_ != nullptr) track_->draw(pen_lines_.line(path, settings_.shapes.tolerance));
    next_.path(path);
}

} // namespace hrbfnpr::output
