// SPDX-License-Identifier: MIT
// The filters of pages:
// 1. DashFilter cuts lines into dashes [ISO 128-2].
// 2. ClipFilter clips lines and dots, for DXF.
// 3. PlotOrderFilter clips, joins, drops, fills, cuts and sorts the lines and dots of a group for a pen.
#include "geometry/point_tree.h"
#include "output/vector/plot_lines.h"
#include "output/vector/shapes.h"
#include "output/vector/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hrbfnpr::output {
namespace {

// ---- Line types

// Alternating lengths of dashes and gaps, in line widths. The first 0 ends the pattern.
using Pattern = std::array<double, 10>;
constexpr double dot_part = 0.5, gap = 3.0, space = 18.0, short_dash = 6.0, dash = 12.0, long_dash = 24.0;
constexpr std::array<Pattern, 16> patterns{{
    {},
    {},
    {dash, gap},
    {dash, space},
    {long_dash, gap, dot_part, gap},
    {long_dash, gap, dot_part, gap, dot_part, gap},
    {long_dash, gap, dot_part, gap, dot_part, gap, dot_part, gap},
    {dot_part, gap},
    {long_dash, gap, short_dash, gap},
    {long_dash, gap, short_dash, gap, short_dash, gap},
    {dash, gap, dot_part, gap},
    {dash, gap, dash, gap, dot_part, gap},
    {dash, gap, dot_part, gap, dot_part, gap},
    {dash, gap, dash, gap, dot_part, gap, dot_part, gap},
    {dash, gap, dot_part, gap, dot_part, gap, dot_part, gap},
    {dash, gap, dash, gap, dot_part, gap, dot_part, gap, dot_part, gap},
}};
static_assert(patterns.size() == static_cast<std::size_t>(LineType::last) + 1);
const Pattern& pattern_of(LineType type) noexcept {
    return patterns[std::min(static_cast<std::size_t>(type), patterns.size() - 1)];
}
// A line with more periods than this is drawn solid, because the dashes would be invisible and would take too long to
// write.
constexpr double most_periods = 1e5;

class DashFilter final : public PageFilter {
public:
    DashFilter(base::Memory& memory, PageSink& next) noexcept : PageFilter(next), part_(memory) {}

    void begin_group(const PageGroup& group) override {
        group_ = group;
        next_.begin_group(group);
    }
    void path(const PagePath& path) override {
        HRBFNPR_ASSERT(path.points.size() > 1);
        const Pattern& pattern = pattern_of(group_.line_type);
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
        // The pattern is scaled to a whole number of periods; an open line gets a final dash.
        const double open = path.closed ? 0.0 : first;
        const double times = std::max(std::floor((length - open) / period + 0.5), 1.0);
        const double scale = length / (times * period + open);
        PagePath piece = path;
        piece.closed = false;
        piece.begin = piece.end = drawing::Cap::flat;
        std::size_t at = 0; // the index in the pattern
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

private:
    PageGroup group_;
    base::Array<PagePoint> part_;
};

// Narrows the range from..to of a segment, which is 0 to 1 at first, to the part within the frame. Returns false if the
// segment is outside the frame or not finite. [Liang and Barsky 1984, "A new concept and method for line clipping"]
bool find_within(const PagePoint& a, const PagePoint& b, const Frame& frame, double& from, double& to) noexcept {
    if (!std::isfinite(a.x + a.y + b.x + b.y)) return false;
    const double dx = b.x - a.x, dy = b.y - a.y;
    // For each side of the frame, the speed of the segment towards it, and the distance from the segment's start to it.
    const std::array<double, 4> speed{-dx, dx, -dy, dy};
    const std::array<double, 4> room{a.x - frame.left, frame.right - a.x, a.y - frame.top, frame.bottom - a.y};
    for (std::size_t side = 0; side < 4; ++side) {
        if (speed[side] == 0.0 && room[side] < 0.0) return false;
        if (speed[side] < 0.0) from = std::max(from, room[side] / speed[side]);
        if (speed[side] > 0.0) to = std::min(to, room[side] / speed[side]);
    }
    return from < to;
}

// ---- Clipping

// Clips lines and dots to the frame of their view and to the page. The centre of a line or dot decides.
class Clip {
public:
    Clip(base::Memory& memory, const PageSettings& settings)
        : page_{0.0, 0.0, settings.width, settings.height}, frame_(page_), ring_(memory), part_(memory) {}

    void begin_view(const Frame& own) noexcept {
        frame_ = {std::max(page_.left, own.left), std::max(page_.top, own.top), std::min(page_.right, own.right),
                  std::min(page_.bottom, own.bottom)};
    }
    void end_view() noexcept { frame_ = page_; }
    [[nodiscard]] bool contains(const PageDot& dot) const noexcept { return frame_.contains(dot.x, dot.y); }

    // Calls take(part) for the parts of the path within the frame, in order. Cut ends are flat. A closed path becomes
    // open if any part of it is cut off.
    template <class Take>
    void clip(const PagePath& path, const Take& take) {
        HRBFNPR_ASSERT(path.points.size() > 1);
        const auto inside = [&](const PagePoint& p) { return frame_.contains(p.x, p.y); };
        if (std::all_of(path.points.begin(), path.points.end(), inside)) {
            take(path);
            return;
        }
        std::span<const PagePoint> points = path.points;
        if (path.closed) { // rotate the path, so that it starts outside the frame
            const std::span<const PagePoint> once = points.first(points.size() - 1);
            const auto first = std::find_if_not(once.begin(), once.end(), inside) - once.begin();
            ring_.clear();
            for (std::size_t i = 0; i <= once.size(); ++i)
                ring_.push_back(once[(static_cast<std::size_t>(first) + i) % once.size()]);
            points = ring_.span();
        }
        PagePath part = path;
        part.closed = false;
        const auto emit = [&](drawing::Cap end) {
            part.points = part_.span();
            part.end = end;
            if (part_.size() > 1) take(part);
            part_.clear();
        };
        part_.clear();
        for (std::size_t i = 1; i < points.size(); ++i) {
            const PagePoint& a = points[i - 1];
            const PagePoint& b = points[i];
            double from = 0.0, to = 1.0;
            const bool any = find_within(a, b, frame_, from, to);
            if (!any || part_.empty() || from > 0.0) emit(drawing::Cap::flat);
            if (!any) continue;
            if (part_.empty()) {
                part.begin = i == 1 && from <= 0.0 && !path.closed ? path.begin : drawing::Cap::flat;
                part_.push_back(from > 0.0 ? between(a, b, from) : a);
            }
            part_.push_back(to < 1.0 ? between(a, b, to) : b);
            if (to < 1.0) emit(drawing::Cap::flat);
        }
        emit(path.closed ? drawing::Cap::flat : path.end);
    }

private:
    Frame page_;
    Frame frame_; // the drawable part of the page in mm; within a view, clipped to the view's frame
    // A closed path rotated to start outside the frame, and the part of a path within the frame.
    base::Array<PagePoint> ring_, part_;
};

// Clips the ink of pages for formats that have no clip paths.
class ClipFilter final : public PageFilter {
public:
    ClipFilter(base::Memory& memory, PageSink& next, const PageSettings& settings)
        : PageFilter(next), clip_(memory, settings) {}
    void begin_view(const PageView& view) override {
        clip_.begin_view(view.frame);
        next_.begin_view(view);
    }
    void path(const PagePath& path) override {
        clip_.clip(path, [&](const PagePath& part) { next_.path(part); });
    }
    void dot(const PageDot& dot) override {
        if (clip_.contains(dot)) next_.dot(dot);
    }
    void end_view() override {
        clip_.end_view();
        next_.end_view();
    }

private:
    Clip clip_;
};

// ---- The order of a pen

constexpr std::int64_t lines_per_check = 64;

class PlotOrderFilter final : public PageFilter {
public:
    PlotOrderFilter(base::Memory& memory, PageSink& next, const PageSettings& settings, PageCounts& counts,
                    PenTrack* track, const base::Progress& progress)
        : PageFilter(next), memory_(memory), settings_(settings), counts_(counts), track_(track), progress_(progress),
          checks_(progress, lines_per_check), clip_(memory, settings), lines_(memory), dots_(memory),
          pen_lines_(memory), turned_(memory), pen_(0.0, settings.height) {}
    void begin_view(const PageView& view) override {
        clip_.begin_view(view.frame);
        next_.begin_view(view);
    }
    void begin_group(const PageGroup& group) override {
        group_ = group;
        if (settings_.for_plotter() && !(group_.pen_width > 0.0)) group_.pen_width = plotter_pen;
        lines_.clear();
        dots_.clear();
        if (track_ != nullptr) track_->raise();
        next_.begin_group(group_);
    }
    void path(const PagePath& path) override {
        PlotLine like;
        like.width = group_.pen_width;
        clip(path, like, lines_);
    }
    void dot(const PageDot& dot) override {
        checks_.count();
        if (clip_.contains(dot)) dots_.push_back(dot);
    }
    void end_group() override {
        const bool dashed = group_.line_type > LineType::continuous;
        if (!dashed) { // in dashed lines, short dashes and gaps are intended
            counts_.joined += join_lines(lines_, settings_.plot.join, group_.pen_width > 0.0, progress_);
            drop_short();
        }
        if (settings_.shapes.fills && group_.pen_width > 0.0) {
            counts_.filled_paths += fill_lines(lines_, settings_.shapes.tolerance, progress_);
            // Clip passes again, because they may leave the frame where the centre line does not.
            PlotLines within(memory_);
            for (const PlotLine& line : lines_.lines) clip(lines_.path_of(line), line, within);
            std::swap(lines_, within);
        }
        drop_near_dots();
        if (settings_.plot.longest > 0.0) {
            add_long_dots();
            cut_lines();
        }
        forward_lines();
        next_.end_group();
    }
    void end_view() override {
        clip_.end_view();
        next_.end_view();
    }

private:
    void clip(const PagePath& path, const PlotLine& like, PlotLines& out) {
        checks_.count();
        clip_.clip(path, [&](const PagePath& part) {
            PlotLine line = like;
            line.width = like.width > 0.0 ? like.width : mean_width(part.points);
            line.opacity = part.opacity;
            line.begin = part.begin;
            line.end = part.end;
            line.closed = part.closed;
            out.add(line, part.points);
        });
    }
    [[nodiscard]] bool fills(std::span<const PagePoint> points, double pen) const noexcept {
        return settings_.shapes.fills && group_.pen_width > 0.0 && is_wider_than(pen, points);
    }
    [[nodiscard]] double pen_of(const PageDot& dot) const noexcept {
        return group_.pen_width > 0.0 ? group_.pen_width : 2.0 * dot.radius;
    }
    void drop_short() {
        const auto is_short = [&](const PlotLine& line) {
            checks_.count();
            const double least =
                settings_.plot.shortest > 0.0 ? settings_.plot.shortest : plot_tuning.shortest_line * line.width;
            const std::span<const PagePoint> points = lines_.points_of(line);
            return !line.goes_on && !fills(points, line.width) && !(length_of(points) >= least);
        };
        const std::int64_t kept =
            std::remove_if(lines_.lines.begin(), lines_.lines.end(), is_short) - lines_.lines.begin();
        counts_.dropped_paths += lines_.lines.size() - kept;
        lines_.lines.resize(kept);
    }
    // Goes through the dots in order. Each dot removes later dots that are too near.
    void drop_near_dots() {
        geometry::VecArray places(memory_);
        for (const PageDot& dot : dots_) places.push_back({dot.x, dot.y, 0.0});
        const geometry::PointTree tree(places, progress_);
        base::Array<std::uint8_t> taken(memory_, dots_.size());
        std::int64_t kept = 0;
        for (std::int64_t i = 0; i < dots_.size(); ++i) {
            checks_.count();
            if (taken[i] != 0) continue;
            const PageDot dot = dots_[i];
            const double least = settings_.plot.dot_distance > 0.0 ? settings_.plot.dot_distance
                                                                   : plot_tuning.shortest_line * pen_of(dot);
            tree.within(places[i], least, [&](std::int64_t at, double square) {
                if (square < least * least) taken[tree.index(at)] = 1;
            });
            dots_[kept++] = dot;
        }
        counts_.dropped_dots += dots_.size() - kept;
        dots_.resize(kept);
    }
    // Makes lines of the dots whose spirals or circles are longer than the pen may draw.
    void add_long_dots() {
        base::Array<PagePoint> points(memory_);
        std::int64_t kept = 0;
        for (const PageDot& dot : dots_) {
            const double pen = pen_of(dot);
            points.clear();
            if (settings_.for_plotter() || settings_.shapes.dots_of(group_.pen_width) == DotShapes::spirals)
                for (const glm::dvec2& place : pen_lines_.line(dot, pen, settings_.shapes, {dot.x, dot.y}))
                    points.push_back({place.x, place.y, 0.5 * pen});
            checks_.count(1 + points.size());
            PlotLine line;
            line.width = pen;
            line.opacity = dot.opacity;
            if (points.size() > 1 && length_of(points.span()) > settings_.plot.longest)
                lines_.add(line, points.span());
            else
                dots_[kept++] = dot;
        }
        dots_.resize(kept);
    }
    // Cuts lines that are longer than the pen may draw into equal parts.
    void cut_lines() {
        PlotLines parts(memory_);
        base::Array<PagePoint> points(memory_);
        for (const PlotLine& line : lines_.lines) {
            const std::span<const PagePoint> all = lines_.points_of(line);
            checks_.count(line.count);
            const double length = length_of(all), count = std::ceil(length / settings_.plot.longest);
            if (!(count > 1.0)) {
                parts.add(line, all);
                continue;
            }
            ++counts_.cut_paths;
            PlotLine part = line;
            part.closed = false;
            part.end = line.begin == line.end && line.begin != drawing::Cap::pointed ? line.begin : drawing::Cap::flat;
            points.clear();
            points.push_back(all[0]);
            double done = 0.0, cut = 1.0; // the length up to the current point, and the number of the next cut
            for (std::size_t i = 1; i < all.size(); ++i) {
                const double way = glm::distance(place_of(all[i - 1]), place_of(all[i]));
                for (; cut < count && cut / count * length < done + way; cut += 1.0) {
                    checks_.count();
                    points.push_back(between(all[i - 1], all[i], (cut / count * length - done) / way));
                    parts.add(part, points.span());
                    part.begin = part.end;
                    const PagePoint last = points.back();
                    points.clear();
                    points.push_back(last);
                }
                points.push_back(all[i]);
                done += way;
            }
            part.end = line.end;
            parts.add(part, points.span());
        }
        std::swap(lines_, parts);
    }
    void forward_lines() {
        check_cancel(progress_);
        base::Array<PagePoint> places(memory_);
        for (const PageDot& dot : dots_) places.push_back({dot.x, dot.y, dot.radius});
        base::Array<Stop> stops(memory_); // a stop for each line, then one for each dot
        for (const PlotLine& line : lines_.lines) stops.push_back({lines_.points_of(line), line.closed});
        for (std::int64_t i = 0; i < places.size(); ++i)
            stops.push_back({places.span().subspan(static_cast<std::size_t>(i), 1), false});
        for (const Leg& leg : find_tour(memory_, stops.span(), pen_, progress_)) {
            checks_.count();
            if (leg.stop < lines_.lines.size()) {
                forward_line(lines_.path_of(lines_.lines[leg.stop]), leg);
                continue;
            }
            const PageDot& dot = dots_[leg.stop - lines_.lines.size()];
            pen_ = {dot.x, dot.y};
            if (track_ != nullptr) track_->draw(pen_lines_.line(dot, pen_of(dot), settings_.shapes, track_->place()));
            next_.dot(dot);
        }
    }
    void forward_line(PagePath path, const Leg& leg) {
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

    base::Memory& memory_;
    PageSettings settings_;
    PageCounts& counts_;
    PenTrack* track_;
    const base::Progress& progress_;
    CancelChecks checks_;
    Clip clip_;
    PageGroup group_;
    PlotLines lines_;
    base::Array<PageDot> dots_;
    PenLines pen_lines_;
    base::Array<PagePoint> turned_;
    glm::dvec2 pen_; // the pen's position, mm
};

} // namespace

std::span<const double> dashes_of(LineType type) noexcept {
    const Pattern& pattern = pattern_of(type);
    return {pattern.data(), static_cast<std::size_t>(std::find(pattern.begin(), pattern.end(), 0.0) - pattern.begin())};
}

std::unique_ptr<PageSink> line_types(base::Memory& memory, PageSink& next) {
    return std::make_unique<DashFilter>(memory, next);
}

std::unique_ptr<PageSink> clip_to_frames(base::Memory& memory, PageSink& next, const PageSettings& settings) {
    return std::make_unique<ClipFilter>(memory, next, settings);
}

std::unique_ptr<PageSink> plot_order(base::Memory& memory, PageSink& next, const PageSettings& settings,
                                     PageCounts& counts, PenTrack* track, const base::Progress& progress) {
    return std::make_unique<PlotOrderFilter>(memory, next, settings, counts, track, progress);
}

} // namespace hrbfnpr::output
