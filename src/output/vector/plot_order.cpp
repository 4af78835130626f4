// SPDX-License-Identifier: MIT
#include "output/vector/plot_order.h"

#include "output/vector/near_tree.h"
#include "output/vector/tuning.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace hrbfnpr::output {
namespace {

constexpr std::int64_t lines_a_look = 64;

} // namespace

PlotOrder::PlotOrder(base::Memory& memory, PageSink& next, const PlotOrderSettings& settings, PageCounts& counts,
                     PenTrack* track, const base::Progress& progress)
    : PageFilter(next), memory_(memory), settings_(settings), counts_(counts), track_(track), progress_(progress),
      looks_(progress, lines_a_look), frame_(settings.page), lines_(memory), dots_(memory), clip_(memory),
      pen_lines_(memory), turned_(memory), pen_(settings.page.left, settings.page.bottom) {}

void PlotOrder::begin_view(const PageView& view) {
    const Frame &page = settings_.page, &own = view.frame;
    frame_ = {std::max(page.left, own.left), std::max(page.top, own.top), std::min(page.right, own.right),
              std::min(page.bottom, own.bottom)};
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
        counts_.joined += join_lines(lines_, settings_.join, group_.pen_width > 0.0, progress_);
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
        const double least = settings_.shortest > 0.0 ? settings_.shortest : plot_tuning.shortest_line * line.width;
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
    base::Array<glm::dvec2> places(memory_);
    for (const PageDot& dot : dots_) places.push_back({dot.x, dot.y});
    NearTree tree(memory_);
    tree.build(places.span(), progress_);
    base::Array<std::int32_t> near(memory_);
    std::int64_t kept = 0;
    for (std::int32_t i = 0; i < dots_.size(); ++i) {
        looks_.count();
        if (!tree.holds(i)) continue;
        tree.remove(i);
        const PageDot dot = dots_[i];
        const double least =
            settings_.dot_distance > 0.0 ? settings_.dot_distance : plot_tuning.shortest_line * pen_of(dot);
        double square = least * least;
        near.clear();
        tree.search(places[i], square, [&](std::int32_t other, double) { near.push_back(other); });
        for (const std::int32_t other : near) tree.remove(other);
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
