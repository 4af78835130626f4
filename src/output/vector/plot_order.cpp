// SPDX-License-Identifier: MIT
#include "output/vector/plot_order.h"

#include "output/vector/line_types.h"
#include "output/vector/look.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::output {
namespace {

constexpr std::int64_t ordered_at_a_time = 64;

double mean_width(std::span<const PagePoint> points) noexcept {
    double sum = 0.0;
    for (const PagePoint& p : points) sum += p.radius;
    return 2.0 * sum / static_cast<double>(points.size());
}

Frame common(const Frame& a, const Frame& b) noexcept {
    return {std::max(a.left, b.left), std::max(a.top, b.top), std::min(a.right, b.right), std::min(a.bottom, b.bottom)};
}

} // namespace

PlotOrder::PlotOrder(base::Memory& memory, PageSink& next, const PlotOrderSettings& settings, PageCounts& counts,
                     PenTrack* track, const base::Progress& progress)
    : next_(next), settings_(settings), counts_(counts), track_(track), progress_(progress), frame_(settings.page),
      clip_(memory), lines_(memory), dots_(memory), join_(memory), fill_(memory), within_(memory), tree_(memory),
      tour_(memory), pen_lines_(memory), places_(memory), near_(memory), points_(memory), stops_(memory),
      turned_(memory), pen_(settings.page.left, settings.page.bottom) {}

void PlotOrder::begin_view(const PageView& view) {
    frame_ = common(settings_.page, view.frame);
    next_.begin_view(view);
}

void PlotOrder::end_view() {
    frame_ = settings_.page;
    next_.end_view();
}

void PlotOrder::begin_group(const PageGroup& group) {
    group_ = group;
    if (settings_.for_plotter && !(group_.pen_width > 0.0)) group_.pen_width = plotter_pen;
    lines_.clear();
    dots_.clear();
    taken_ = 0;
    if (track_ != nullptr) track_->raise();
    next_.begin_group(group_);
}

void PlotOrder::check_often() {
    if (++taken_ % ordered_at_a_time == 0) look(progress_);
}

void PlotOrder::path(const PagePath& path) {
    check_often();
    clip_.parts(path, frame_, [&](const PagePath& part) {
        PlotLine line;
        line.first = lines_.points.size();
        line.count = static_cast<std::int64_t>(part.points.size());
        line.width = group_.pen_width > 0.0 ? group_.pen_width : mean_width(part.points);
        line.opacity = part.opacity;
        line.begin = part.begin;
        line.end = part.end;
        line.closed = part.closed;
        for (const PagePoint& p : part.points) lines_.points.push_back(p);
        lines_.lines.push_back(line);
    });
}

void PlotOrder::dot(const PageDot& dot) {
    check_often();
    if (frame_.contains(dot.x, dot.y)) dots_.push_back(dot);
}

void PlotOrder::end_group() {
    const bool dashed = group_.line_type > LineType::continuous;
    if (!dashed) { // the dots of its lines are short, and their gaps are meant
        const JoinSettings join{settings_.join, group_.pen_width > 0.0};
        counts_.joined += join_.join(lines_, join, progress_);
        drop_short();
    }
    if (settings_.shapes.fills && group_.pen_width > 0.0) fill_wide();
    drop_near_dots();
    hand_on();
    next_.end_group();
}

void PlotOrder::drop_short() {
    std::int64_t kept = 0;
    for (const PlotLine& line : lines_.lines) {
        check_often();
        const double least = settings_.shortest > 0.0 ? settings_.shortest : 0.5 * line.width;
        const std::span<const PagePoint> points = lines_.points_of(line);
        const bool is_filled =
            settings_.shapes.fills && group_.pen_width > 0.0 && FillLines::is_wider(points, line.width);
        if (line.goes_on || is_filled || length_of(points) >= least) lines_.lines[kept++] = line;
    }
    counts_.dropped_paths += lines_.lines.size() - kept;
    lines_.lines.resize(kept);
}

// Passes beside the centre may lie beyond the frame where that does not.
void PlotOrder::fill_wide() {
    counts_.filled_paths += fill_.fill(lines_, settings_.shapes.tolerance, progress_);
    within_.clear();
    for (const PlotLine& line : lines_.lines) {
        check_often();
        PagePath path;
        path.points = lines_.points_of(line);
        path.closed = line.closed;
        path.begin = line.begin;
        path.end = line.end;
        clip_.parts(path, frame_, [&](const PagePath& part) {
            PlotLine cut = line;
            cut.first = within_.points.size();
            cut.count = static_cast<std::int64_t>(part.points.size());
            cut.closed = part.closed;
            cut.begin = part.begin;
            cut.end = part.end;
            for (const PagePoint& p : part.points) within_.points.push_back(p);
            within_.lines.push_back(cut);
        });
    }
    std::swap(lines_.points, within_.points);
    std::swap(lines_.lines, within_.lines);
}

double PlotOrder::pen_of(const PageDot& dot) const noexcept {
    return group_.pen_width > 0.0 ? group_.pen_width : 2.0 * dot.radius;
}

// In their order: each takes away those after it that are too near.
void PlotOrder::drop_near_dots() {
    places_.clear();
    for (const PageDot& dot : dots_) places_.push_back({dot.x, dot.y});
    tree_.build(places_.span(), progress_);
    std::int64_t kept = 0;
    for (std::int32_t i = 0; i < dots_.size(); ++i) {
        check_often();
        if (!tree_.holds(i)) continue;
        tree_.remove(i);
        const PageDot dot = dots_[i];
        const double least = settings_.dot_distance > 0.0 ? settings_.dot_distance : 0.5 * pen_of(dot);
        double square = least * least;
        near_.clear();
        tree_.search(places_[i], square, [&](std::int32_t other, double) { near_.push_back(other); });
        for (const std::int32_t other : near_) tree_.remove(other);
        dots_[kept++] = dot;
    }
    counts_.dropped_dots += dots_.size() - kept;
    dots_.resize(kept);
}

void PlotOrder::hand_on() {
    look(progress_);
    points_.clear();
    for (const PageDot& dot : dots_) points_.push_back({dot.x, dot.y, dot.radius});
    stops_.clear();
    for (const PlotLine& line : lines_.lines) stops_.push_back({lines_.points_of(line), line.closed});
    for (std::int64_t i = 0; i < points_.size(); ++i)
        stops_.push_back({points_.span().subspan(static_cast<std::size_t>(i), 1), false});
    for (const Leg& leg : tour_.find(stops_.span(), pen_, progress_)) {
        check_often();
        if (leg.stop < lines_.lines.size())
            hand_on(lines_.lines[leg.stop], leg);
        else
            put(dots_[leg.stop - lines_.lines.size()]);
    }
}

void PlotOrder::hand_on(const PlotLine& line, const Leg& leg) {
    PagePath path;
    path.points = lines_.points_of(line);
    path.begin = line.begin;
    path.end = line.end;
    path.closed = line.closed;
    path.opacity = line.opacity;
    const std::size_t count = path.points.size();
    turned_.clear();
    if (line.closed) {
        for (std::size_t i = 0; i < count; ++i)
            turned_.push_back(path.points[(static_cast<std::size_t>(leg.start) + i) % (count - 1)]);
    } else if (leg.reversed) {
        std::swap(path.begin, path.end);
        for (std::size_t i = count; i > 0; --i) turned_.push_back(path.points[i - 1]);
    }
    if (!turned_.empty()) path.points = turned_.span();
    put(path);
}

void PlotOrder::put(const PagePath& path) {
    pen_ = place_of(path.points.back());
    if (track_ != nullptr) track_->draw(pen_lines_.line(path, settings_.shapes.tolerance));
    next_.path(path);
}

void PlotOrder::put(const PageDot& dot) {
    pen_ = {dot.x, dot.y};
    if (track_ != nullptr) track_->draw(pen_lines_.line(dot, pen_of(dot), settings_.shapes, track_->place()));
    next_.dot(dot);
}

} // namespace hrbfnpr::output
