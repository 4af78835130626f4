// SPDX-License-Identifier: MIT
#include "frame/lines/stroke_parts.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::frame {
namespace {

// Parts shorter than this belong to the one before, pixels: nobody sees them, and gaps would be seen.
constexpr double unseen = 0.35;

std::int32_t layers_before(std::int32_t sheets) noexcept { return std::max(0, (sheets + 1) / 2); }

double length_of(const visibility::Interval& i) noexcept { return i.end_at - i.begin_at; }

// The share of its width that a line has so far from a free end: half an ellipse.
double tapered(double from_end, double taper) noexcept {
    if (!(from_end < taper)) return 1.0;
    const double left = 1.0 - std::max(0.0, from_end) / taper;
    return std::sqrt(std::max(0.0, 1.0 - left * left));
}

// The share of its width that a part with a free end has by its length: a short one, as between a cusp and a line
// beside it, would be a bead.
double thinned(double length, double taper) noexcept { return length < 2.0 * taper ? length / (2.0 * taper) : 1.0; }

// Of the width there, by the points around it.
float factor_at(const DrawnAs& as, const visibility::Piece& piece, float share) noexcept {
    return as.factor == nullptr ? 1.0F : (1.0F - share) * as.factor[piece.a] + share * as.factor[piece.b];
}

// A line that runs into another one joins it: gaps are for those that cross at more than some 20 degrees.
double halo_share(float sine) noexcept { return std::clamp((static_cast<double>(sine) - 0.35) / 0.25, 0.0, 1.0); }

} // namespace

void StrokeParts::run() {
    for (std::int64_t first = 0; first < found_.intervals.size();) {
        std::int64_t end = first;
        const std::int32_t line = found_.intervals[first].line;
        while (end < found_.intervals.size() && found_.intervals[end].line == line) ++end;
        collect(first, end);
        for (const DrawnAs& as : laws_.styles())
            if (as.subject == found_.lines.lines[line].subject)
                for (const Part& part : parts_) draw(as, part);
        first = end;
    }
}

// The intervals of a line that look alike are one part; so are the last and the first of a closed line.
void StrokeParts::collect(std::int64_t first, std::int64_t end) {
    parts_.clear();
    const visibility::Line& line = found_.lines.lines[found_.intervals[first].line];
    for (std::int64_t i = first; i < end; ++i) {
        visibility::Interval next = found_.intervals[i];
        if (hugging_.has(i)) next.hidden_by = -1;
        const std::int32_t layers = hugging_.has(i) ? 0 : layers_before(next.sheets);
        const bool joins =
            !parts_.empty() && (alike(parts_[parts_.size() - 1], layers, next.hidden_by) || length_of(next) < unseen);
        if (!joins) {
            parts_.push_back({next, layers, next.begins_at_cusp, next.ends_at_cusp});
            continue;
        }
        Part& last = parts_[parts_.size() - 1];
        last.interval.end_piece = next.end_piece;
        last.interval.end_share = next.end_share;
        last.interval.end_at = next.end_at;
        last.interval.end_sine = next.end_sine;
        last.free_end = next.ends_at_cusp;
    }
    if (!line.closed) {
        const bool joined = subjects_[static_cast<std::size_t>(line.subject)].joined;
        const std::int32_t number = found_.intervals[first].line;
        Part& last = parts_[parts_.size() - 1];
        parts_[0].free_begin = !joined || !ends_.goes_on(number, false);
        last.free_end = last.free_end || !joined || !ends_.goes_on(number, true);
    } else if (parts_.size() > 1 && alike(parts_[parts_.size() - 1], parts_[0].layers, parts_[0].interval.hidden_by)) {
        Part& last = parts_[parts_.size() - 1];
        const Part& begin = parts_[0];
        last.interval.end_piece = begin.interval.end_piece;
        last.interval.end_share = begin.interval.end_share;
        last.interval.end_at = begin.interval.end_at + lengths_.whole(line);
        last.free_end = begin.free_end;
        last.interval.end_sine = begin.interval.end_sine;
        for (std::int64_t i = 0; i + 1 < parts_.size(); ++i) parts_[i] = parts_[i + 1];
        parts_.resize(parts_.size() - 1);
    }
}

// The points of the image along a part, and its ends.
void StrokeParts::find_places(const Part& part) {
    const visibility::Interval& in = part.interval;
    const visibility::Line& line = found_.lines.lines[in.line];
    const double whole = lengths_.whole(line);
    place_.clear();
    place_.push_back({in.begin_at, in.begin_piece, in.begin_share});
    std::int64_t p = line.first_point;
    const auto at = [&](std::int64_t i) { return lengths_.at_point(i); };
    while (p + 1 < line.first_point + line.points && at(p) <= in.begin_at) ++p;
    double beyond = 0.0;
    for (std::int64_t step = 0; step < 2 * line.points; ++step, ++p) {
        if (p + 1 >= line.first_point + line.points) { // the last point of a closed line is its first
            if (!line.closed) break;
            p = line.first_point;
            beyond += whole;
        }
        if (!(at(p) + beyond < in.end_at) || beyond > whole) break;
        place_.push_back({at(p) + beyond, found_.lines.points[p].piece, found_.lines.points[p].share});
    }
    place_.push_back({in.end_at, in.end_piece, in.end_share});
}

drawing::StrokePoint StrokeParts::point_at(const DrawnAs& as, const Place& place) const {
    const visibility::Subject& subject = subjects_[static_cast<std::size_t>(as.subject)];
    const glm::dvec3 p = visibility::cubic(subjects_, found_.lines.pieces[place.piece]).at(place.share);
    const glm::dvec4 q = subject.view.to_window * glm::dvec4(p, 1.0);
    const glm::dvec4 eye = scene_.camera.view * (subject.to_world * glm::dvec4(p, 1.0));
    drawing::StrokePoint point{};
    point.x = static_cast<float>(q.x / q.w);
    point.y = static_cast<float>(q.y / q.w);
    point.window = static_cast<float>(q.z / q.w);
    point.depth = static_cast<float>(-eye.z);
    point.pixels_per_unit = scene_.lens.pixels / static_cast<float>(q.w);
    point.opacity = faded(as, found_.lines.pieces[place.piece], static_cast<float>(place.share));
    point.radius = factor_at(as, found_.lines.pieces[place.piece], static_cast<float>(place.share));
    return point;
}

bool StrokeParts::is_whole(const Part& part) const noexcept {
    const visibility::Line& line = found_.lines.lines[part.interval.line];
    return line.closed && !part.free_begin && !part.free_end && length_of(part.interval) >= lengths_.whole(line);
}

// What is seen of a line for less than half its width, and hidden before or behind that: where a line comes out from
// behind another in its last pixel it says nothing.
bool StrokeParts::is_dot(const LineStyle& style, const Part& part) const noexcept {
    const visibility::Line& line = found_.lines.lines[part.interval.line];
    return part.layers == 0 && length_of(part.interval) < 0.5 * static_cast<double>(style.width) &&
           length_of(part.interval) < lengths_.whole(line);
}

glm::dvec2 StrokeParts::seen_at(const visibility::Subject& subject, const Place& place) const {
    return visibility::see(subject.view, visibility::cubic(subjects_, found_.lines.pieces[place.piece]).at(place.share))
        .place;
}

// On the chord from a place to the next.  In double: a chord may begin far outside the window.
drawing::StrokePoint StrokeParts::point_between(const DrawnAs& as, std::int64_t place, double share) const {
    const visibility::Subject& subject = subjects_[static_cast<std::size_t>(as.subject)];
    const drawing::StrokePoint a = point_at(as, place_[place]);
    const drawing::StrokePoint b = point_at(as, place_[place + 1]);
    const glm::dvec2 seen = glm::mix(seen_at(subject, place_[place]), seen_at(subject, place_[place + 1]), share);
    const auto u = static_cast<float>(share);
    drawing::StrokePoint point = a;
    point.x = static_cast<float>(seen.x);
    point.y = static_cast<float>(seen.y);
    point.window += u * (b.window - a.window);
    point.depth += u * (b.depth - a.depth);
    point.opacity += u * (b.opacity - a.opacity);
    point.radius += u * (b.radius - a.radius);
    return point;
}

void StrokeParts::draw(const DrawnAs& as, const Part& part) {
    const LineStyle& style = *as.style;
    const bool hidden = part.layers > 0;
    if (hidden && style.hidden == HiddenParts::none) return;
    // Where a nearer line crosses, a visible one ends before it; not behind it, where its end would be seen.
    const bool ends_at_line = !hidden && as.halo > 0.0F && !is_whole(part);
    const visibility::Interval& in = part.interval;
    double begin = in.begin_at;
    double end = in.end_at;
    if (ends_at_line) {
        begin += gap_at(as, {in.line, in.begin_piece, in.begin_share, in.begin_at, in.begin_sine});
        end -= gap_at(as, {in.line, in.end_piece, in.end_share, in.end_at, in.end_sine});
    }
    if (!(end > begin) || is_dot(style, part)) return;
    if (end - begin < static_cast<double>(style.shortest) && (part.free_begin || part.free_end || hidden)) return;
    find_places(part);
    find_knots(as, part);
    if (hidden && style.hidden == HiddenParts::dashed)
        add_dashes(as, part);
    else
        add_strong(as, part, begin, end);
}

// From one place along a part to another, but for what is too weak.
void StrokeParts::add_strong(const DrawnAs& as, const Part& part, double from, double to) {
    if (!as.cut) return add(as, part, from, to);
    const auto strength = [&](std::int64_t i) {
        return static_cast<double>(
            strength_at(as, found_.lines.pieces[place_[i].piece], static_cast<float>(place_[i].share)) - as.lower);
    };
    double begin = from; // of what is strong enough, as far as the last place
    bool strong = strength(0) >= 0.0;
    for (std::int64_t i = 1; i < place_.size() && place_[i - 1].at < to; ++i) {
        const double a = strength(i - 1);
        const double b = strength(i);
        if (strong == (b >= 0.0)) continue;
        const double at = std::clamp(glm::mix(place_[i - 1].at, place_[i].at, a / (a - b)), from, to);
        if (strong && at > begin) add(as, part, begin, at);
        begin = at;
        strong = !strong;
    }
    if (strong && to > begin) add(as, part, begin, to);
}

// Those that are seen: a line that passes beside the eye is as long as numbers go.
void StrokeParts::add_dashes(const DrawnAs& as, const Part& part) {
    const double begin = part.interval.begin_at;
    const double whole = length_of(part.interval);
    // The more layers lie before it, the shorter its dashes.
    const double width = static_cast<double>(as.style->hidden_width);
    const double dash = std::max(1.0, width * static_cast<double>(as.style->dash) / part.layers);
    const double period = dash + std::max(1.0, width * static_cast<double>(as.style->gap));
    const double dashes = std::max(1.0, std::round(whole / period));
    const double step = whole / dashes;
    double next = 0.0;
    for (std::int64_t i = 0; i + 1 < place_.size(); ++i) {
        const Shares seen = in_window(as, i, dash + width);
        if (!(seen.low <= seen.high)) continue;
        const double span = place_[i + 1].at - place_[i].at;
        const double last = std::floor((place_[i].at + seen.high * span - begin) / step);
        next = std::max(next, std::floor((place_[i].at + seen.low * span - begin) / step));
        for (; next <= std::min(last, dashes - 1.0); next += 1.0) {
            const double middle = begin + (next + 0.5) * step;
            add_strong(as, part, middle - 0.5 * dash * step / period, middle + 0.5 * dash * step / period);
        }
    }
}

// Of the chord from a place to the next, what lies in the window or so near to it.
StrokeParts::Shares StrokeParts::in_window(const DrawnAs& as, std::int64_t place, double beside) const {
    const visibility::Subject& subject = subjects_[static_cast<std::size_t>(as.subject)];
    const glm::dvec2 a = seen_at(subject, place_[place]);
    const glm::dvec2 b = seen_at(subject, place_[place + 1]);
    const glm::dvec4 window(scene_.lens.viewport);
    Shares shares{0.0, 1.0};
    const auto keep = [&](double from, double to, double low, double high) {
        const double way = to - from;
        const double enters = ((way < 0.0 ? high : low) - from) / way;
        const double leaves = ((way < 0.0 ? low : high) - from) / way;
        if (way != 0.0) {
            shares.low = std::max(shares.low, enters);
            shares.high = std::min(shares.high, leaves);
        } else if (from < low || from > high) {
            shares.high = -1.0;
        }
    };
    keep(a.x, b.x, window.x - beside, window.x + window.z + beside);
    keep(a.y, b.y, window.y - beside, window.y + window.w + beside);
    return shares;
}

drawing::Stroke StrokeParts::begun(const DrawnAs& as, const Part& part, double length) const {
    const bool hidden = part.layers > 0;
    drawing::Stroke stroke;
    stroke.first = strokes_.points.size();
    stroke.layer = as.layer;
    stroke.line = numbers_.number(part.interval.line);
    stroke.hidden_layers = part.layers;
    stroke.hidden_by = part.interval.hidden_by < 0 ? -1 : items_[static_cast<std::size_t>(part.interval.hidden_by)];
    stroke.closed = is_whole(part) && length >= length_of(part.interval);
    stroke.cap_begin = part.free_begin && !hidden ? as.style->cap : drawing::Cap::round;
    stroke.cap_end = part.free_end && !hidden ? as.style->cap : drawing::Cap::round;
    return stroke;
}

StrokeParts::Pen StrokeParts::pen_of(const DrawnAs& as, const Part& part) const noexcept {
    const LineStyle& style = *as.style;
    const bool hidden = part.layers > 0;
    const bool dashed = hidden && style.hidden == HiddenParts::dashed;
    const double opacity = hidden && style.hidden == HiddenParts::attenuated
                               ? std::pow(static_cast<double>(style.hidden_opacity), part.layers)
                               : 1.0;
    const double whole =
        static_cast<double>(hidden && style.hidden != HiddenParts::shown ? style.hidden_width : style.width);
    const double length = length_of(part.interval);
    const double taper = static_cast<double>(style.taper);
    const bool has_free_end = part.free_begin || part.free_end;
    return {whole * (has_free_end && !dashed ? thinned(length, taper) : 1.0), opacity, std::min(taper, 0.5 * length),
            part.free_begin && !dashed, part.free_end && !dashed};
}

Wobble StrokeParts::wobble_of(const DrawnAs& as, std::int32_t line) const noexcept {
    const visibility::Line& its = found_.lines.lines[line];
    return {*as.style, numbers_.number(line), lengths_.whole(its), its.closed};
}

// Noise stands still on a line from frame to frame, wherever that begins.
double StrokeParts::from_origin(std::int32_t line, double at) const noexcept {
    const visibility::Line& its = found_.lines.lines[line];
    const double way = at - lengths_.at(its, numbers_.origin(line), 0.0);
    return its.closed && way < 0.0 ? way + lengths_.whole(its) : way;
}

// A point whose radius is still a factor of its style's width.
void StrokeParts::put(const DrawnAs& as, const Part& part, const Pen& pen, drawing::StrokePoint point, double at) {
    const double begin = pen.tapers_begin ? tapered(at - part.interval.begin_at, pen.taper) : 1.0;
    const double end = pen.tapers_end ? tapered(part.interval.end_at - at, pen.taper) : 1.0;
    const double factor = static_cast<double>(point.radius) * laws_.along(as, part.interval.line, at);
    point.radius = static_cast<float>(0.5 * pen.width * std::min(begin, end) * factor);
    point.opacity *= static_cast<float>(pen.opacity);
    strokes_.points.push_back(point);
    at_.push_back(at);
}

// A stroke along a part, from one place along its line to another.
void StrokeParts::add(const DrawnAs& as, const Part& part, double from, double to) {
    const Pen pen = pen_of(as, part);
    drawing::Stroke stroke = begun(as, part, to - from);
    // Between two places on one chord of the image, along it.
    const auto between = [&](std::int64_t i, double at) {
        const double span = place_[i + 1].at - place_[i].at;
        put(as, part, pen, point_between(as, i, span > 0.0 ? (at - place_[i].at) / span : 0.0), at);
    };
    const auto before = [](const Place& place, double at) { return place.at < at; };
    const Place* const first = std::lower_bound(place_.begin(), place_.end(), from, before);
    const double* knot = std::upper_bound(knot_.begin(), knot_.end(), from);
    at_.clear();
    for (std::int64_t i = first - place_.begin(); i < place_.size(); ++i) {
        const double here = place_[i].at;
        if (i > 0 && place_[i - 1].at < from && here > from) between(i - 1, from);
        for (; knot != knot_.end() && *knot < std::min(here, to); ++knot) between(i - 1, *knot);
        if (here <= to) put(as, part, pen, point_at(as, place_[i]), here);
        if (i > 0 && place_[i - 1].at < to && here > to) between(i - 1, to);
        if (here > to) break;
    }
    stroke.count = static_cast<std::int32_t>(strokes_.points.size() - stroke.first);
    if (stroke.count < 2) {
        strokes_.points.resize(stroke.first);
        return;
    }
    if (as.style->wobbles()) wobble(as, part, stroke);
    for (std::int64_t i = stroke.first + 1; i < strokes_.points.size(); ++i) {
        drawing::StrokePoint& point = strokes_.points[i];
        const drawing::StrokePoint& last = strokes_.points[i - 1];
        point.length = last.length + std::hypot(point.x - last.x, point.y - last.y);
    }
    stroke.depth = strokes_.points[stroke.first + stroke.count / 2].depth;
    strokes_.strokes.push_back(stroke);
}

// Across the line: at a point halfway between the directions of the chords beside it.
void StrokeParts::wobble(const DrawnAs& as, const Part& part, const drawing::Stroke& stroke) {
    const Wobble hand = wobble_of(as, part.interval.line);
    const std::span<drawing::StrokePoint> points =
        strokes_.points.span().subspan(static_cast<std::size_t>(stroke.first));
    const std::size_t last = points.size() - 1;
    const auto at = [&](std::size_t i) { return glm::dvec2(points[i].x, points[i].y); };
    const glm::dvec2 round[2] = {at(last - 1), at(1)}; // of a closed stroke: before its first point, behind its last
    glm::dvec2 before = stroke.closed ? round[0] : at(0);
    for (std::size_t i = 0; i <= last; ++i) {
        const glm::dvec2 here = at(i);
        const glm::dvec2 next = i < last ? at(i + 1) : stroke.closed ? round[1] : here;
        const glm::dvec2 along = next - before;
        const double where = from_origin(part.interval.line, at_[static_cast<std::int64_t>(i)]);
        const double length = glm::length(along);
        const double aside = length > 0.0 ? hand.aside(where) / length : 0.0;
        points[i].x = static_cast<float>(here.x + aside * along.y);
        points[i].y = static_cast<float>(here.y - aside * along.x);
        points[i].radius *= static_cast<float>(hand.factor(where));
        before = here;
    }
}

// So many that what changes along chords changes evenly between points.  What is not seen has none.
void StrokeParts::find_knots(const DrawnAs& as, const Part& part) {
    knot_.clear();
    if (!as.style->wobbles() && !laws_.changes_along(as)) return;
    const std::int32_t line = part.interval.line;
    const double step = as.style->wobbles() ? std::min(wobble_of(as, line).step(), laws_.step(as)) : laws_.step(as);
    for (std::int64_t i = 0; i + 1 < place_.size(); ++i) {
        const double begin = place_[i].at;
        const double span = place_[i + 1].at - begin;
        const Shares seen = in_window(as, i, 16.0 * step);
        if (!(seen.low < seen.high)) continue;
        double low = begin + seen.low * span;
        double high = begin + seen.high * span;
        if (!as.style->wobbles() && !laws_.changes(as, line, low, high)) continue;
        if (low < begin + step) low = begin;
        if (high > begin + span - step) high = begin + span;
        const double count = std::ceil((high - low) / step);
        for (double k = low > begin ? 0.0 : 1.0; k < count || (k == count && high < begin + span); k += 1.0)
            knot_.push_back(low + k / count * (high - low));
    }
}

// At an end of a part.
float StrokeParts::width_at(const DrawnAs& as, const End& end) const noexcept {
    const float factor = factor_at(as, found_.lines.pieces[end.piece], static_cast<float>(end.share));
    return as.style->width * factor * static_cast<float>(laws_.along(as, end.line, end.at));
}

// Between the end of a part and the middle of the nearer line that crosses there: its halo, and half of either width.
double StrokeParts::gap_at(const DrawnAs& as, const End& end) const noexcept {
    const double share = halo_share(end.sine);
    if (!(share > 0.0)) return 0.0;
    const auto before = [](const visibility::Crossing& c, const End& e) {
        return c.far_piece != e.piece ? c.far_piece < e.piece : c.far_share < e.share;
    };
    const visibility::Crossing* const c =
        std::lower_bound(found_.crossings.begin(), found_.crossings.end(), end, before);
    float near_width = 0.0F;
    if (c != found_.crossings.end() && c->far_piece == end.piece && c->far_share == end.share) {
        const visibility::Piece& piece = found_.lines.pieces[c->near_piece];
        const double at = lengths_.at(found_.lines.lines[piece.line], c->near_piece, c->near_share);
        for (const DrawnAs& near : laws_.styles())
            if (near.subject == piece.subject)
                near_width = std::max(near_width, width_at(near, {piece.line, c->near_piece, c->near_share, at, 0.0F}));
    }
    return static_cast<double>(as.halo + 0.5F * (width_at(as, end) + near_width)) * share;
}

} // namespace hrbfnpr::frame
