// SPDX-License-Identifier: MIT
// Makes strokes of lines. At each point of a curve, the factors of depth and light (point_factors) are multiplied by
// that of curvature (add_curvature), which is smoothed along the image (smooth_along). The outline has a factor of its
// own, which fades out along the line beyond the outline's ends (outline_factor_at). Intervals of a line that look
// alike form a part (parts_of), which includes hidden intervals close beside a visible contour (find_hugging); some
// lines continue as other lines (find_joined). A part has places, which are the points of its polyline (places_of), and
// knots between them where its width or wobble changes along a chord (knots_of). It is drawn whole, as dashes, or where
// it is strong enough (draw), as strokes of points with their widths (add_stroke), which a wobble moves across the line
// (Wobble).
#include "base/assert.h"
#include "base/random.h"
#include "frame/lines/lines.h"
#include "frame/lines/tuning.h"
#include "frame/scene/light.h"
#include "geometry/point_grid.h"
#include "implicit/evaluate_all.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

namespace hrbfnpr::frame {
namespace {

// A part drawn in a style, with places and knots along it.
struct PartPath {
    const DrawnSubject& drawn;
    const LinePart& part;
    base::Array<StrokePlace> place;
    base::Array<double> knot; // further points between the places, as rising distances along the line, in pixels
};

double length_of(const visibility::Interval& i) noexcept { return i.end_at - i.begin_at; }

// ---- Widths

float strength_at(const DrawnSubject& drawn, const visibility::Piece& piece, float share) noexcept {
    return (1.0F - share) * drawn.strength[piece.a] + share * drawn.strength[piece.b];
}

// Returns the opacity of a line at a place, by its strength there.
float opacity_at(const DrawnSubject& drawn, const visibility::Piece& piece, float share) noexcept {
    if (drawn.strength == nullptr || !(drawn.upper > drawn.lower)) return 1.0F;
    const float full =
        std::clamp((strength_at(drawn, piece, share) - drawn.lower) / (drawn.upper - drawn.lower), 0.0F, 1.0F);
    return 1.0F - drawn.style->fade * (1.0F - full);
}

// Returns the factor of the width of a soft edge, which vanishes where a contour is near, since the contour shows the
// edge there.
float beside_contour(const visibility::Subject& subject, const visibility::Piece& piece, double share,
                     const glm::dvec3& place) noexcept {
    const base::Array<curves::CurvePoint>& point = subject.curves->point;
    const glm::dvec3 normal = glm::normalize(
        glm::mix(glm::normalize(point[piece.a].gradient), glm::normalize(point[piece.b].gradient), share));
    const glm::dvec4& eye = subject.view.eye;
    const double facing = std::abs(glm::dot(normal, glm::normalize(glm::dvec3(eye) - eye.w * place)));
    return static_cast<float>(glm::smoothstep(line_tuning.soft_edge_ends, line_tuning.soft_edge_begins, facing));
}

// Returns a factor that changes linearly from 1, for the share 0, to `factor`, for the share 1.
double scaled_factor(float factor, double share) noexcept {
    return glm::mix(1.0, static_cast<double>(factor), std::clamp(share, 0.0, 1.0));
}

bool has_point_law(const LineStyle& style) noexcept {
    return style.far_factor != 1.0F || style.lit_factor != 1.0F || style.curvature_factor != 1.0F;
}

double fade_length(const DrawnSubject& drawn) noexcept {
    return line_tuning.fade_widths * static_cast<double>(drawn.style->width);
}

// Returns whether a style has a different width along the outline.
bool has_outline_factor(const DrawnSubject& drawn) noexcept {
    return drawn.style->outline_factor != 1.0F &&
           (drawn.style->kind == LineKind::contour || drawn.style->kind == LineKind::border);
}

base::Array<float> point_factors(const LineInput& in, const ItemView& item, const DrawnSubject& drawn,
                                 const visibility::Subject& subject, const DepthRange& depths) {
    const glm::dmat4 to_eye = in.scene.camera.view * subject.to_world;
    const base::Array<curves::CurvePoint>& points = subject.curves->point;
    base::Array<float> factors(in.runtime.memory, points.size());
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const double depth = -(to_eye * glm::dvec4(points[i].position, 1.0)).z;
        const glm::vec3 place((points[i].position - item.origin) / item.unit);
        const float n_dot_l = facing(item.lighting, place, glm::vec3(glm::normalize(points[i].gradient)));
        const double facing =
            std::isfinite(n_dot_l) ? static_cast<double>(n_dot_l) : 0.0; // n . l is NaN if f is constant there.
        factors[i] = static_cast<float>(scaled_factor(drawn.style->far_factor, depths.share(depth)) *
                                        scaled_factor(drawn.style->lit_factor, 0.5 + 0.5 * facing));
    }
    return factors;
}

// Sets the radial curvature. On a contour grad g . v = v H v. Since n . v = 0 there, the radial curvature is
// v H v / (|grad f| v^2).
void find_radial_curvature(const visibility::Subject& subject, base::Array<double>& curvature) {
    for (std::int64_t i = 0; i < curvature.size(); ++i) {
        const curves::CurvePoint& p = subject.curves->point[i];
        const glm::dvec3 v = subject.view.sight(p.position);
        curvature[i] = std::abs(glm::dot(p.level_gradient, v)) / (glm::length(p.gradient) * glm::dot(v, v));
    }
}

// Finds the curvature of the surface across the line: b H b / |grad f|, where b is tangent to the surface and
// perpendicular to the line.
void find_curvature_across(const base::Work& work, const implicit::Implicit& surface,
                           const base::Array<curves::CurvePoint>& points, base::Array<double>& curvature) {
    geometry::VecArray place(work.memory, points.size());
    for (std::int64_t i = 0; i < points.size(); ++i) place.set(i, points[i].position);
    base::Array<double> hessian(work.memory, 6 * points.size());
    implicit::FieldBatch fields;
    for (std::size_t c = 0; c < 6; ++c)
        fields.hessian[c] = hessian.data() + static_cast<std::int64_t>(c) * points.size();
    implicit::evaluate_all(work.without_progress(), surface, place, fields);
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 b = glm::normalize(glm::cross(points[i].gradient, points[i].direction()));
        const auto h = [&](std::size_t c) { return fields.hessian[c][i]; };
        const double second = h(0) * b.x * b.x + h(3) * b.y * b.y + h(5) * b.z * b.z +
                              2.0 * (h(1) * b.x * b.y + h(2) * b.x * b.z + h(4) * b.y * b.z);
        curvature[i] = std::abs(second) / glm::length(points[i].gradient);
    }
}

// Smooths values along the image, with weights that fall by a factor of e over `pixels`. Without it, jumps would be
// visible: the curvature of a fit jumps at samples, and the radial curvature of a contour is 0 where the line of sight
// is tangent to it.
base::Array<double> smooth_along(const visibility::Subject& subject, double pixels, const base::Array<double>& values) {
    const curves::Curves& curves = *subject.curves;
    HRBFNPR_ASSERT(values.size() == curves.point.size() && pixels > 0.0);
    // For each value: the weight of the smoothed value before it.
    base::Array<double> kept(values.memory(), values.size());
    base::Array<double> smooth(values.memory(), values.size());
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        const std::int64_t first = curves.first[c];
        const std::int64_t size = curves.size_of(c);
        const bool closed = curves.closed[c] != 0;
        const auto number = [&](std::int64_t k) { return first + k % size; };
        for (std::int64_t k = 0; k < size; ++k) {
            const curves::View::Seen a = subject.view.see(curves.point[number(k + size - 1)].position);
            const curves::View::Seen b = subject.view.see(curves.point[number(k)].position);
            const bool joined = (k > 0 || closed) && a.w > 0.0 && b.w > 0.0;
            kept[number(k)] = joined ? std::exp(-glm::distance(a.place, b.place) / pixels) : 0.0;
        }
        const std::int64_t steps = closed ? 2 * size : size;
        double value = values[first];
        for (std::int64_t k = 0; k < steps; ++k) {
            const std::int64_t i = number(k);
            smooth[i] = value = values[i] + kept[i] * (value - values[i]);
        }
        double back = values[number(size - 1)];
        for (std::int64_t k = steps; k > 0; --k) {
            const std::int64_t i = number(k - 1);
            back = values[i] + kept[number(k)] * (back - values[i]);
            if (k <= size) smooth[i] = 0.5 * (smooth[i] + back);
        }
    }
    return smooth;
}

void add_curvature(const LineInput& in, const DrawnSubject& drawn, base::Array<float>& factors,
                   const base::Progress& progress) {
    const visibility::Subject& subject = in.found.subjects[drawn.subject];
    const implicit::Implicit& surface = *in.traced.occluders[subject.item].surface;
    base::Array<double> curvature(in.runtime.memory, factors.size());
    if (subject.level != nullptr)
        find_radial_curvature(subject, curvature);
    else
        find_curvature_across({in.runtime, progress}, surface, subject.curves->point, curvature);
    for (double& c : curvature)
        if (!std::isfinite(c)) c = 0.0;
    curvature = smooth_along(subject, line_tuning.smooth_widths * static_cast<double>(drawn.style->width), curvature);
    const double bent = static_cast<double>(drawn.style->curvature_radius) * surface.diagonal();
    for (std::int64_t i = 0; i < curvature.size(); ++i)
        factors[i] *= static_cast<float>(
            scaled_factor(drawn.style->curvature_factor, 1.0 - std::min(1.0, 1.0 / (bent * curvature[i]))));
}

// Sets the width factors of the styles at the points of their subjects. Returns the outline if a style needs it.
visibility::Outline find_widths(const LineInput& in, const drawing::Drawing& drawing, const base::Progress& progress) {
    base::Array<DrawnSubject>& styles = in.traced.styles;
    const auto is_by_depth = [](const DrawnSubject& drawn) { return drawn.style->far_factor != 1.0F; };
    const bool by_depth = std::any_of(styles.begin(), styles.end(), is_by_depth);
    const DepthRange depths = by_depth ? find_depth_range(in) : DepthRange();
    base::Array<std::uint8_t> wanted(in.runtime.memory, in.found.subjects.size());
    for (DrawnSubject& drawn : styles) {
        HRBFNPR_ASSERT(drawn.subject >= 0 && drawn.subject < wanted.size());
        if (has_outline_factor(drawn)) wanted[drawn.subject] = 1;
        if (!has_point_law(*drawn.style)) continue;
        const ItemView& item = in.scene.items[drawing.layers[drawn.layer].item];
        base::Array<float>& factors =
            in.traced.numbers.add(point_factors(in, item, drawn, in.found.subjects[drawn.subject], depths));
        if (drawn.style->curvature_factor != 1.0F) add_curvature(in, drawn, factors, progress);
        drawn.factor = factors.data();
    }
    if (std::none_of(wanted.begin(), wanted.end(), [](std::uint8_t w) { return w != 0; }))
        return visibility::Outline(in.runtime.memory);
    return visibility::find_outline({in.runtime, progress.without_progress()}, in.found.subjects.span(),
                                    in.traced.occluders.span(), in.found, in.lengths, wanted.span());
}

// The data that all steps of making strokes read.
struct StrokeInput : LineInput {
    const visibility::Outline& outline;

    // Returns the length of a closed line in pixels, or 0 for an open line.
    [[nodiscard]] double closed_length(std::int32_t l) const noexcept { return line(l).closed ? total(l) : 0.0; }
    // Returns whether a part is a whole closed line.
    [[nodiscard]] bool is_whole(const LinePart& part) const noexcept {
        return line(part.interval.line).closed && !part.free_begin && !part.free_end &&
               length_of(part.interval) >= total(part.interval.line);
    }
};

std::span<const visibility::OutlinePart> outline_of(const visibility::Outline& outline, std::int32_t line) noexcept {
    const auto before = [](const visibility::OutlinePart& a, const visibility::OutlinePart& b) {
        return a.line < b.line;
    };
    const auto [first, end] =
        std::equal_range(outline.parts.begin(), outline.parts.end(), visibility::OutlinePart{line, 0.0, 0.0}, before);
    return {first, end};
}

// Returns the longest chord, in pixels, where the width of a line changes.
double longest_chord(const DrawnSubject& drawn) noexcept {
    return has_outline_factor(drawn) ? fade_length(drawn) / line_tuning.fade_steps
                                     : std::numeric_limits<double>::infinity();
}

// Returns the factor by which the outline changes the width at a place along a line. The factors of the line's points
// are not included.
double outline_factor_at(const StrokeInput& in, const DrawnSubject& drawn, std::int32_t line, double at) noexcept {
    if (!has_outline_factor(drawn)) return 1.0;
    const std::span<const visibility::OutlinePart> parts = outline_of(in.outline, line);
    double nearest = std::numeric_limits<double>::infinity();
    for (const double here : {at, at - in.closed_length(line), at + in.closed_length(line)}) {
        const auto begins = [](double place, const visibility::OutlinePart& part) { return place < part.begin_at; };
        const auto next = std::upper_bound(parts.begin(), parts.end(), here, begins);
        if (next != parts.end()) nearest = std::min(nearest, next->begin_at - here);
        if (next != parts.begin()) nearest = std::min(nearest, std::max(0.0, here - std::prev(next)->end_at));
    }
    // This value falls from 1 to 0, with the slope 0 at both ends.
    const double u = std::clamp(1.0 - nearest / fade_length(drawn), 0.0, 1.0);
    return scaled_factor(drawn.style->outline_factor, u * u * (3.0 - 2.0 * u));
}

// Returns whether the factor of the width changes between two places along a line.
bool outline_factor_changes(const StrokeInput& in, const DrawnSubject& drawn, std::int32_t line, double from,
                            double to) noexcept {
    HRBFNPR_ASSERT(!(from > to));
    if (!has_outline_factor(drawn)) return false;
    for (const visibility::OutlinePart& part : outline_of(in.outline, line))
        for (const double turn : {-in.closed_length(line), 0.0, in.closed_length(line)}) {
            const double begin = part.begin_at + turn;
            const double end = part.end_at + turn;
            if (to > begin - fade_length(drawn) && from < end + fade_length(drawn) && !(from >= begin && to <= end))
                return true;
        }
    return false;
}

// ---- An unsteady hand

// Smooth noise along a line: uniform cubic B-splines of random numbers. It has two continuous derivatives, and is
// bounded by the random numbers. Around a closed line it repeats.
class Wobble {
public:
    // `line` is the number of the line, and `whole` is its length in pixels.
    Wobble(const LineStyle& style, std::uint32_t line, double whole, bool closed) noexcept
        : offset_(static_cast<double>(style.wobble) * static_cast<double>(style.width)),
          width_(static_cast<double>(style.wobble_width)),
          knot_distance_(static_cast<double>(style.wobble_length) * static_cast<double>(style.width) /
                         line_tuning.knots_a_swing),
          seed_(style.wobble_seed | std::uint64_t{static_cast<std::uint32_t>(style.kind)} << 32U), line_(line) {
        // A line shorter than a swing strays less, because its ends would be off by more than its form.
        offset_ *= std::min(1.0, whole / (line_tuning.knots_a_swing * knot_distance_));
        if (!closed || !(whole > 0.0)) return;
        const double knots = std::max(line_tuning.fewest_knots, std::round(whole / knot_distance_));
        knot_distance_ = whole / knots;
        knots_ = static_cast<std::int64_t>(knots);
    }
    // Returns how far the line moves to the left at a place along it, in pixels.
    [[nodiscard]] double aside(double at) const noexcept { return offset_ * noise(at, 0); }
    // Returns the factor of the width at a place along the line.
    [[nodiscard]] double factor(double at) const noexcept { return 1.0 + width_ * noise(at, 1); }
    // Returns the longest chord, in pixels, that follows the wobble closely enough.
    [[nodiscard]] double step() const noexcept {
        return std::max(line_tuning.shortest_step, knot_distance_ / line_tuning.steps_a_knot);
    }

private:
    // Returns a random number in [-1, 1].
    [[nodiscard]] double random(std::int64_t knot, std::size_t which) const noexcept {
        if (knots_ > 0) knot = (knot % knots_ + knots_) % knots_;
        const std::uint64_t index = line_ << 32U | static_cast<std::uint32_t>(knot);
        return 2.0 * base::uniform4(seed_, index, base::Purpose::wobble)[which] - 1.0;
    }
    [[nodiscard]] double noise(double at, std::size_t which) const noexcept {
        const double place = std::clamp(at / knot_distance_, -line_tuning.farthest_knot, line_tuning.farthest_knot);
        const double knot = std::floor(place);
        const double u = place - knot;
        const double v = 1.0 - u;
        const auto first = static_cast<std::int64_t>(knot);
        const double weights[4] = {v * v * v, 4.0 - 3.0 * u * u * (1.0 + v), 4.0 - 3.0 * v * v * (1.0 + u), u * u * u};
        double sum = 0.0;
        for (int k = 0; k < 4; ++k) sum += weights[k] * random(first - 1 + k, which);
        return sum / 6.0;
    }

    double offset_, width_;
    double knot_distance_;      // the distance between knots, in pixels
    std::int64_t knots_ = 0;    // the number of knots around a closed line; 0 for an open line
    std::uint64_t seed_, line_; // the seeds for random numbers
};

Wobble wobble_of(const StrokeInput& in, const DrawnSubject& drawn, std::int32_t line) noexcept {
    return {*drawn.style, in.numbers.number[line], in.total(line), in.line(line).closed};
}

// ---- Parts

// Returns whether a place of the image is near a place in a grid. The place with the index `except` is ignored.
bool is_near(const geometry::PointGrid& grid, const geometry::VecArray& places, const glm::dvec2& place, double radius,
             std::int64_t except) {
    bool found = false;
    grid.around({place, 0.0}, [&](std::int64_t at) {
        const std::int64_t i = grid.index(at);
        found = found || (i != except && glm::distance(places[i], glm::dvec3(place, 0.0)) <= radius);
    });
    return found;
}

// Calls f for places of the image along an interval, until f returns false.
template <class F>
void for_places_along(const LineInput& in, const visibility::Interval& interval, double step, const F& f) {
    const visibility::Line& line = in.line(interval.line);
    const double whole = in.lengths.total(line);
    std::int64_t i = line.first_point;
    for (double way = interval.begin_at; way < interval.end_at + step; way += step) {
        double at = std::min(way, interval.end_at);
        if (at > whole) at -= whole; // On a closed line, places continue from the beginning.
        if (in.lengths.at_point(i) > at) i = line.first_point;
        while (i + 2 < line.first_point + line.points && in.lengths.at_point(i + 1) < at) ++i;
        const double begin = in.lengths.at_point(i);
        const double chord = in.lengths.at_point(i + 1) - begin;
        const double share = chord > 0.0 ? std::clamp((at - begin) / chord, 0.0, 1.0) : 0.0;
        if (!f(glm::mix(in.found.lines.points[i].place, in.found.lines.points[i + 1].place, share))) return;
    }
}

// Returns for each interval 1 if it is hidden but belongs to a visible contour, else 0. Such an interval is short, is
// on a contour of a surface with creases, and follows the visible contour closely. `width` is that of the widest lines,
// in pixels.
base::Array<std::uint8_t> find_hugging(base::Memory& memory, const LineInput& in, double width) {
    const base::Array<visibility::Interval>& intervals = in.found.intervals;
    base::Array<std::uint8_t> hugs(memory, intervals.size());
    const auto is_contour = [&](const visibility::Interval& interval) {
        const visibility::Line& line = in.line(interval.line);
        const visibility::Subject& subject = in.found.subjects[line.subject];
        return subject.joined && subject.sheet_change == 2;
    };
    const auto may_hug = [&](const visibility::Interval& interval) {
        return interval.invisibility > 0 && length_of(interval) < line_tuning.longest_hugging * width &&
               is_contour(interval);
    };
    if (!(width > 0.0) || std::none_of(intervals.begin(), intervals.end(), may_hug)) return hugs;
    const double step = line_tuning.hugging_distance * width;
    geometry::VecArray seen(memory);
    for (const visibility::Interval& interval : intervals)
        if (interval.invisibility <= 0 && is_contour(interval))
            for_places_along(in, interval, step, [&](const glm::dvec2& place) {
                seen.push_back({place, 0.0});
                return true;
            });
    const double radius = line_tuning.hugging_distance * width;
    const geometry::PointGrid grid(seen, radius);
    for (std::int64_t i = 0; i < intervals.size(); ++i) {
        bool all = may_hug(intervals[i]);
        if (all)
            for_places_along(in, intervals[i], step,
                             [&](const glm::dvec2& place) { return all = is_near(grid, seen, place, radius, -1); });
        hugs[i] = all ? 1 : 0;
    }
    return hugs;
}

// Returns two flags for each line, for its start and its end. A flag is 0 if a visible contour of a `joined` subject
// begins or ends freely there: no other visible line of these subjects has an end nearby. In all other cases it is 1. A
// line that is too faint to be drawn does not count as visible, so a contour that begins at a faint crease begins
// freely, as at a cusp.
base::Array<std::uint8_t> find_joined(base::Memory& memory, const LineInput& in, const base::Array<std::uint8_t>& hugs,
                                      double width) {
    const base::Array<visibility::Interval>& intervals = in.found.intervals;
    geometry::VecArray seen(memory);
    base::Array<std::int64_t> ends(memory); // for each end of a line: 2 * line for its start, 2 * line + 1 for its end
    for (std::int64_t i = 0; i < intervals.size(); ++i) {
        const std::int32_t number = intervals[i].line;
        const visibility::Line& line = in.line(number);
        if (line.closed || !in.found.subjects[line.subject].joined) continue;
        if (intervals[i].invisibility > 0 && hugs[i] == 0) continue;
        for (const int at_end : {0, 1}) {
            const std::int64_t beside = at_end == 0 ? i - 1 : i + 1;
            if (beside >= 0 && beside < intervals.size() && intervals[beside].line == number) continue;
            const visibility::Piece& piece = in.piece(line.first_piece + at_end * (line.pieces - 1));
            float opacity = 0.0F;
            for (const DrawnSubject& drawn : in.traced.styles)
                if (drawn.subject == line.subject)
                    opacity = std::max(opacity, opacity_at(drawn, piece, static_cast<float>(at_end)));
            const std::int64_t point = line.first_point + at_end * (line.points - 1);
            if (opacity < line_tuning.least_opacity) continue;
            seen.push_back({in.found.lines.points[point].place, 0.0});
            ends.push_back(2 * std::int64_t{number} + at_end);
        }
    }
    // A radius of 0 is avoided, for pens without width.
    const double radius = std::max(1e-6, line_tuning.same_end_distance * width);
    const geometry::PointGrid grid(seen, radius);
    base::Array<std::uint8_t> goes_on(memory, 2 * in.found.lines.lines.size());
    std::fill(goes_on.begin(), goes_on.end(), std::uint8_t{1});
    for (std::int64_t i = 0; i < ends.size(); ++i)
        if (in.subject(in.line(ends[i] / 2)).sheet_change == 2 && !is_near(grid, seen, glm::dvec2(seen[i]), radius, i))
            goes_on[ends[i]] = 0;
    return goes_on;
}

// Makes parts: consecutive intervals of a line that look the same are one part. On a closed line, the last and first
// intervals are consecutive, too.
void parts_of(const StrokeInput& in, std::int64_t first, std::int64_t end, const base::Array<std::uint8_t>& hugs,
              const base::Array<std::uint8_t>& goes_on, base::Array<LinePart>& parts) {
    HRBFNPR_ASSERT(first < end && end <= in.found.intervals.size() && hugs.size() >= end);
    parts.clear();
    const std::int32_t number = in.found.intervals[first].line;
    const visibility::Line& line = in.line(number);
    const auto are_alike = [](const LinePart& a, const LinePart& b) {
        return a.layers == b.layers && a.interval.hidden_by == b.interval.hidden_by;
    };
    const auto extend = [](LinePart& part, const LinePart& next, double beyond) {
        part.interval.end_piece = next.interval.end_piece;
        part.interval.end_share = next.interval.end_share;
        part.interval.end_at = next.interval.end_at + beyond;
        part.interval.end_sine = next.interval.end_sine;
        part.free_end = next.free_end;
    };
    for (std::int64_t i = first; i < end; ++i) {
        visibility::Interval its = in.found.intervals[i];
        if (hugs[i] != 0) its.hidden_by = -1;
        const std::int32_t layers = hugs[i] != 0 ? 0 : std::max(0, (its.invisibility + 1) / 2);
        const LinePart next{its, layers, its.begins_at_cusp, its.ends_at_cusp};
        if (!parts.empty() && (are_alike(parts.back(), next) || length_of(its) < line_tuning.shortest_part))
            extend(parts.back(), next, 0.0);
        else
            parts.push_back(next);
    }
    if (!line.closed) {
        const bool joined = in.subject(line).joined;
        parts[0].free_begin = !joined || goes_on[2 * std::int64_t{number}] == 0;
        parts.back().free_end = parts.back().free_end || !joined || goes_on[2 * std::int64_t{number} + 1] == 0;
    } else if (parts.size() > 1 && are_alike(parts.back(), parts[0])) {
        extend(parts.back(), parts[0], in.total(number));
        std::copy(parts.begin() + 1, parts.end(), parts.begin());
        parts.resize(parts.size() - 1);
    }
}

// Finds the points of the image along a part, including its ends.
void places_of(const StrokeInput& in, const LinePart& part, base::Array<StrokePlace>& places) {
    const visibility::Interval& its = part.interval;
    const visibility::Line& line = in.line(its.line);
    const double whole = in.total(its.line);
    const auto at = [&](std::int64_t i) { return in.lengths.at_point(i); };
    places.clear();
    places.push_back({its.begin_at, its.begin_piece, its.begin_share});
    std::int64_t p = line.first_point;
    while (p + 1 < line.first_point + line.points && at(p) <= its.begin_at) ++p;
    double beyond = 0.0;
    for (std::int64_t step = 0; step < 2 * line.points; ++step, ++p) {
        if (p + 1 >= line.first_point + line.points) { // The last point of a closed line is also its first.
            if (!line.closed) break;
            p = line.first_point;
            beyond += whole;
        }
        if (!(at(p) + beyond < its.end_at) || beyond > whole) break;
        places.push_back({at(p) + beyond, in.found.lines.points[p].piece, in.found.lines.points[p].share});
    }
    places.push_back({its.end_at, its.end_piece, its.end_share});
}

// ---- Points

glm::dvec2 seen_at(const StrokeInput& in, const StrokePlace& place) {
    const visibility::Piece& piece = in.piece(place.piece);
    return in.found.subjects[piece.subject]
        .view.see(visibility::cubic(in.found.subjects.span(), piece).at(place.share))
        .place;
}

// Returns the factor of a style's width at a place, interpolated between the points of the curve on either side.
float factor_at(const DrawnSubject& drawn, const visibility::Piece& piece, float share) noexcept {
    return drawn.factor == nullptr ? 1.0F : (1.0F - share) * drawn.factor[piece.a] + share * drawn.factor[piece.b];
}

// Makes a point at a place. Its radius is only a factor of the style's width yet.
drawing::StrokePoint point_at(const StrokeInput& in, const DrawnSubject& drawn, const StrokePlace& place) {
    const visibility::Piece& piece = in.piece(place.piece);
    const visibility::Subject& subject = in.found.subjects[piece.subject];
    const glm::dvec3 p = visibility::cubic(in.found.subjects.span(), piece).at(place.share);
    const glm::dvec4 q = subject.view.to_window * glm::dvec4(p, 1.0);
    const glm::dvec4 eye = in.scene.camera.view * (subject.to_world * glm::dvec4(p, 1.0));
    drawing::StrokePoint point{};
    point.x = static_cast<float>(q.x / q.w);
    point.y = static_cast<float>(q.y / q.w);
    point.window = static_cast<float>(q.z / q.w);
    point.depth = static_cast<float>(-eye.z);
    point.pixels_per_unit = in.scene.lens.pixels / static_cast<float>(q.w);
    point.opacity = opacity_at(drawn, piece, static_cast<float>(place.share));
    point.radius = factor_at(drawn, piece, static_cast<float>(place.share));
    // A soft edge fades by getting narrower, as a pen draws it.
    if (drawn.style->kind == LineKind::soft_edge)
        point.radius *= std::exchange(point.opacity, 1.0F) * beside_contour(subject, piece, place.share, p);
    return point;
}

// Makes a point on the chord between two consecutive places. It computes in double, because a chord may begin far
// outside the window.
drawing::StrokePoint point_between(const StrokeInput& in, const PartPath& path, std::int64_t i, double at) {
    HRBFNPR_ASSERT(i >= 0 && i + 1 < path.place.size());
    const double span = path.place[i + 1].at - path.place[i].at;
    const double share = span > 0.0 ? (at - path.place[i].at) / span : 0.0;
    const drawing::StrokePoint b = point_at(in, path.drawn, path.place[i + 1]);
    const glm::dvec2 seen = glm::mix(seen_at(in, path.place[i]), seen_at(in, path.place[i + 1]), share);
    const auto u = static_cast<float>(share);
    drawing::StrokePoint point = point_at(in, path.drawn, path.place[i]);
    point.x = static_cast<float>(seen.x);
    point.y = static_cast<float>(seen.y);
    point.window += u * (b.window - point.window);
    point.depth += u * (b.depth - point.depth);
    point.opacity += u * (b.opacity - point.opacity);
    point.radius += u * (b.radius - point.radius);
    return point;
}

// Returns the range of shares of the chord between two consecutive places that is in the window, or at most `beside`
// pixels outside.
ShareRange in_window(const StrokeInput& in, const StrokePlace& from, const StrokePlace& to, double beside) {
    return chord_in_window(seen_at(in, from), seen_at(in, to), glm::dvec4(in.scene.lens.viewport), beside);
}

// Finds knots between the places of a part. Between knots, widths and opacities change linearly. Chords outside the
// window need no knots.
void knots_of(const StrokeInput& in, PartPath& path) {
    path.knot.clear();
    const DrawnSubject& drawn = path.drawn;
    const bool wobbles = drawn.style->wobbles();
    if (!wobbles && !has_outline_factor(drawn)) return;
    const std::int32_t line = path.part.interval.line;
    const double step =
        wobbles ? std::min(wobble_of(in, drawn, line).step(), longest_chord(drawn)) : longest_chord(drawn);
    for (std::int64_t i = 0; i + 1 < path.place.size(); ++i) {
        const double begin = path.place[i].at;
        const double span = path.place[i + 1].at - begin;
        const ShareRange seen = in_window(in, path.place[i], path.place[i + 1], line_tuning.steps_beside * step);
        if (!(seen.low < seen.high)) continue;
        double low = begin + seen.low * span;
        double high = begin + seen.high * span;
        if (!wobbles && !outline_factor_changes(in, drawn, line, low, high)) continue;
        if (low < begin + step) low = begin;
        if (high > begin + span - step) high = begin + span;
        const double count = std::ceil((high - low) / step);
        for (double k = low > begin ? 0.0 : 1.0; k < count || (k == count && high < begin + span); k += 1.0)
            path.knot.push_back(low + k / count * (high - low));
    }
}

// ---- Strokes

// Moves the points of a stroke sideways by noise. The direction of the line at a point is the mean of the two adjacent
// chords. From frame to frame, the noise stays in place on the line, wherever the line begins. `at` has the distances
// of the points along the line, in pixels.
void wobble(const StrokeInput& in, const PartPath& path, bool closed, const base::Array<double>& at,
            std::span<drawing::StrokePoint> points) {
    HRBFNPR_ASSERT(points.size() > 1 && static_cast<std::size_t>(at.size()) == points.size());
    const std::int32_t number = path.part.interval.line;
    const Wobble hand = wobble_of(in, path.drawn, number);
    const visibility::Line& line = in.line(number);
    const double origin = in.lengths.at(line, in.numbers.origin[number], 0.0);
    const auto place = [&](std::size_t i) { return glm::dvec2(points[i].x, points[i].y); };
    const std::size_t last = points.size() - 1;
    const glm::dvec2 second = place(1);
    glm::dvec2 before = closed ? place(last - 1) : place(0);
    for (std::size_t i = 0; i <= last; ++i) {
        const glm::dvec2 here = place(i);
        const glm::dvec2 along = (i < last ? place(i + 1) : closed ? second : here) - before;
        double where = at[static_cast<std::int64_t>(i)] - origin;
        if (line.closed && where < 0.0) where += in.total(number);
        const double length = glm::length(along);
        const double aside = length > 0.0 ? hand.aside(where) / length : 0.0;
        points[i].x = static_cast<float>(here.x + aside * along.y);
        points[i].y = static_cast<float>(here.y - aside * along.x);
        points[i].radius *= static_cast<float>(hand.factor(where));
        before = here;
    }
}

// Adds a stroke along a part, between two distances along its line. Free ends taper by half an ellipse. A short part
// with a free end, for example between a cusp and a nearby line, is made thinner, because at full width it would look
// like a dot.
void add_stroke(const StrokeInput& in, const PartPath& path, double from, double to, LineStrokes& out) {
    const DrawnSubject& drawn = path.drawn;
    const LinePart& part = path.part;
    const base::Array<StrokePlace>& place = path.place;
    const LineStyle& style = *drawn.style;
    const bool hidden = part.layers > 0;
    const bool dashed = hidden && style.hidden == HiddenParts::dashed;
    const double opacity = hidden && style.hidden == HiddenParts::attenuated
                               ? std::pow(static_cast<double>(style.hidden_opacity), part.layers)
                               : 1.0;
    const double length = length_of(part.interval);
    const auto full_taper = static_cast<double>(style.taper);
    const double taper = std::min(full_taper, 0.5 * length);
    auto width = static_cast<double>(hidden && style.hidden != HiddenParts::shown ? style.hidden_width : style.width);
    if ((part.free_begin || part.free_end) && !dashed && length < 2.0 * full_taper)
        width *= length / (2.0 * full_taper);
    const auto tapered = [&](bool is_free, double from_end) {
        if (!is_free || dashed || !(from_end < taper)) return 1.0;
        const double left = 1.0 - std::max(0.0, from_end) / taper;
        return std::sqrt(std::max(0.0, 1.0 - left * left));
    };
    drawing::Stroke stroke;
    stroke.first = out.points.size();
    stroke.layer = drawn.layer;
    stroke.line = in.numbers.number[part.interval.line];
    stroke.hidden_layers = part.layers;
    stroke.hidden_by = part.interval.hidden_by < 0 ? -1 : in.traced.items[part.interval.hidden_by];
    stroke.closed = in.is_whole(part) && to - from >= length;
    stroke.cap_begin = part.free_begin && !hidden ? style.cap : drawing::Cap::round;
    stroke.cap_end = part.free_end && !hidden ? style.cap : drawing::Cap::round;

    base::Array<double> at(in.runtime.memory); // the distances of the stroke's points along the line
    const auto put = [&](drawing::StrokePoint point, double here) {
        const double narrow = std::min(tapered(part.free_begin, here - part.interval.begin_at),
                                       tapered(part.free_end, part.interval.end_at - here));
        const double factor =
            static_cast<double>(point.radius) * outline_factor_at(in, drawn, part.interval.line, here);
        point.radius = static_cast<float>(0.5 * width * narrow * factor);
        point.opacity *= static_cast<float>(opacity);
        out.points.push_back(point);
        at.push_back(here);
    };
    const auto put_between = [&](std::int64_t i, double here) { put(point_between(in, path, i, here), here); };
    const auto before = [](const StrokePlace& p, double here) { return p.at < here; };
    const double* knot = std::upper_bound(path.knot.begin(), path.knot.end(), from);
    for (std::int64_t i = std::lower_bound(place.begin(), place.end(), from, before) - place.begin(); i < place.size();
         ++i) {
        const double here = place[i].at;
        if (i > 0 && place[i - 1].at < from && here > from) put_between(i - 1, from);
        for (; knot != path.knot.end() && *knot < std::min(here, to); ++knot) put_between(i - 1, *knot);
        if (here <= to) put(point_at(in, drawn, place[i]), here);
        if (i > 0 && place[i - 1].at < to && here > to) put_between(i - 1, to);
        if (here > to) break;
    }
    stroke.count = static_cast<std::int32_t>(out.points.size() - stroke.first);
    if (stroke.count < 2) {
        out.points.resize(stroke.first);
        return;
    }
    if (style.wobbles())
        wobble(in, path, stroke.closed, at, out.points.span().subspan(static_cast<std::size_t>(stroke.first)));
    for (std::int64_t i = stroke.first + 1; i < out.points.size(); ++i) {
        drawing::StrokePoint& point = out.points[i];
        const drawing::StrokePoint& last = out.points[i - 1];
        point.length = last.length + std::hypot(point.x - last.x, point.y - last.y);
    }
    stroke.depth = out.points[stroke.first + stroke.count / 2].depth;
    out.strokes.push_back(stroke);
}

// Adds strokes between two distances along a part, except where the line is too weak.
void add_strong_parts(const StrokeInput& in, const PartPath& path, double from, double to, LineStrokes& out) {
    if (!path.drawn.cut) return add_stroke(in, path, from, to, out);
    const base::Array<StrokePlace>& place = path.place;
    const auto strength = [&](std::int64_t i) {
        return static_cast<double>(
            strength_at(path.drawn, in.piece(place[i].piece), static_cast<float>(place[i].share)) - path.drawn.lower);
    };
    double begin = from; // the distance at which the current strong or weak stretch begins, in pixels
    HRBFNPR_ASSERT(path.drawn.strength != nullptr);
    bool strong = strength(0) >= 0.0;
    for (std::int64_t i = 1; i < place.size() && place[i - 1].at < to; ++i) {
        const double a = strength(i - 1);
        const double b = strength(i);
        if (strong == (b >= 0.0)) continue;
        const double at = std::clamp(glm::mix(place[i - 1].at, place[i].at, a / (a - b)), from, to);
        if (strong && at > begin) add_stroke(in, path, begin, at, out);
        begin = at;
        strong = !strong;
    }
    if (strong && to > begin) add_stroke(in, path, begin, to, out);
}

// Adds dashes. Dashes outside the window are skipped, because a line that passes beside the eye may be immensely long.
// The more layers hide the line, the shorter are its dashes.
void add_dashes(const StrokeInput& in, const PartPath& path, LineStrokes& out) {
    const double begin = path.part.interval.begin_at;
    const double whole = length_of(path.part.interval);
    const LineStyle& style = *path.drawn.style;
    const auto width = static_cast<double>(style.hidden_width);
    const double dash = std::max(1.0, width * static_cast<double>(style.dash) / path.part.layers);
    const double period = dash + std::max(1.0, width * static_cast<double>(style.gap));
    const double dashes = std::max(1.0, std::round(whole / period));
    const double step = whole / dashes;
    double next = 0.0;
    for (std::int64_t i = 0; i + 1 < path.place.size(); ++i) {
        const ShareRange seen = in_window(in, path.place[i], path.place[i + 1], dash + width);
        if (!(seen.low <= seen.high)) continue;
        const double at = path.place[i].at - begin;
        const double span = path.place[i + 1].at - path.place[i].at;
        const double last = std::min(std::floor((at + seen.high * span) / step), dashes - 1.0);
        next = std::max(next, std::floor((at + seen.low * span) / step));
        for (; next <= last; next += 1.0) {
            const double middle = begin + (next + 0.5) * step;
            add_strong_parts(in, path, middle - 0.5 * dash * step / period, middle + 0.5 * dash * step / period, out);
        }
    }
}

// Returns the distance between the end of a part and the middle of the nearer line that crosses there: the halo plus
// half of both line widths.
double gap_at(const StrokeInput& in, const DrawnSubject& drawn, std::int32_t line, const StrokePlace& end,
              float sine) noexcept {
    HRBFNPR_ASSERT(end.share >= 0.0 && end.share <= 1.0);
    const double joins = line_tuning.joining_sine;
    const double share =
        std::clamp((static_cast<double>(sine) - joins) / (line_tuning.full_gap_sine - joins), 0.0, 1.0);
    if (!(share > 0.0)) return 0.0;
    const auto width_at = [&](const DrawnSubject& style, std::int32_t l, const StrokePlace& p) {
        const float factor = factor_at(style, in.piece(p.piece), static_cast<float>(p.share));
        return style.style->width * factor * static_cast<float>(outline_factor_at(in, style, l, p.at));
    };
    const auto before = [](const visibility::Crossing& c, const StrokePlace& p) {
        return c.far_piece != p.piece ? c.far_piece < p.piece : c.far_share < p.share;
    };
    const base::Array<visibility::Crossing>& crossings = in.found.crossings;
    const visibility::Crossing* const c = std::lower_bound(crossings.begin(), crossings.end(), end, before);
    float near_width = 0.0F;
    if (c != crossings.end() && c->far_piece == end.piece && c->far_share == end.share) {
        const visibility::Piece& piece = in.piece(c->near_piece);
        const StrokePlace near{in.lengths.at(in.line(piece.line), c->near_piece, c->near_share), c->near_piece,
                               c->near_share};
        for (const DrawnSubject& other : in.traced.styles)
            if (other.subject == piece.subject) near_width = std::max(near_width, width_at(other, piece.line, near));
    }
    return static_cast<double>(drawn.halo + 0.5F * (width_at(drawn, line, end) + near_width)) * share;
}

// Returns 1 for each subject that is drawn in a style whose lines are to be verified, else 0.
base::Array<std::uint8_t> verified_subjects(const LineInput& in, const drawing::Drawing& drawing) {
    base::Array<std::uint8_t> wanted(in.runtime.memory, in.found.subjects.size());
    for (const DrawnSubject& drawn : in.traced.styles)
        if (in.scene.items[drawing.layers[drawn.layer].item].style.verify_lines) wanted[drawn.subject] = 1;
    return wanted;
}

// Draws a part in a style.
void draw(const StrokeInput& in, PartPath& path, LineStrokes& out) {
    const DrawnSubject& drawn = path.drawn;
    const LinePart& part = path.part;
    const LineStyle& style = *drawn.style;
    const visibility::Interval& its = part.interval;
    const bool hidden = part.layers > 0;
    if (hidden && style.hidden == HiddenParts::none) return;
    double begin = its.begin_at;
    double end = its.end_at;
    // A visible line ends before a nearer line that crosses it. If it ended under that line, its end would show.
    if (!hidden && drawn.halo > 0.0F && !in.is_whole(part)) {
        begin += gap_at(in, drawn, its.line, {its.begin_at, its.begin_piece, its.begin_share}, its.begin_sine);
        end -= gap_at(in, drawn, its.line, {its.end_at, its.end_piece, its.end_share}, its.end_sine);
    }
    // A short visible part between hidden parts is left out, because it would be a dot.
    const bool is_dot = !hidden && length_of(its) < line_tuning.shortest_dot * static_cast<double>(style.width) &&
                        length_of(its) < in.total(its.line);
    if (!(end > begin) || is_dot) return;
    if (end - begin < static_cast<double>(style.shortest) && (part.free_begin || part.free_end || hidden)) return;
    places_of(in, part, path.place);
    knots_of(in, path);
    if (hidden && style.hidden == HiddenParts::dashed)
        add_dashes(in, path, out);
    else
        add_strong_parts(in, path, begin, end, out);
}

} // namespace

ShareRange chord_in_window(const glm::dvec2& from, const glm::dvec2& to, const glm::dvec4& window,
                           double beside) noexcept {
    ShareRange shares{0.0, 1.0};
    for (const int axis : {0, 1}) {
        const double way = to[axis] - from[axis];
        const double low = window[axis] - beside;
        const double high = window[axis] + window[axis + 2] + beside;
        if (way != 0.0) {
            shares.low = std::max(shares.low, ((way < 0.0 ? high : low) - from[axis]) / way);
            shares.high = std::min(shares.high, ((way < 0.0 ? low : high) - from[axis]) / way);
        } else if (from[axis] < low || from[axis] > high) {
            shares.high = -1.0;
        }
    }
    return shares;
}

void add_strokes(const LineInput& input, drawing::Drawing& drawing, const base::Progress& progress,
                 LineStrokes& strokes) {
    HRBFNPR_ASSERT(input.traced.items.size() == input.traced.occluders.size());
    base::Memory& memory = input.runtime.memory;
    double widest = 0.0;
    for (const DrawnSubject& drawn : input.traced.styles)
        widest = std::max(widest, static_cast<double>(drawn.style->width));
    const visibility::Outline outline = find_widths(input, drawing, progress);
    const base::Array<std::uint8_t> hugs = find_hugging(memory, input, widest);
    const base::Array<std::uint8_t> goes_on = find_joined(memory, input, hugs, widest);
    const StrokeInput in{input, outline};
    const base::Array<visibility::Interval>& intervals = in.found.intervals;
    base::Array<LinePart> parts(memory);
    base::Array<LinePart> of_line(memory);
    for (std::int64_t first = 0; first < intervals.size();) {
        std::int64_t end = first;
        while (end < intervals.size() && intervals[end].line == intervals[first].line) ++end;
        parts_of(in, first, end, hugs, goes_on, of_line);
        for (const LinePart& part : of_line) parts.push_back(part);
        first = end;
    }
    const base::Array<std::uint8_t> verified = verified_subjects(in, drawing);
    if (std::any_of(verified.begin(), verified.end(), [](std::uint8_t v) { return v != 0; }))
        parts = verify_parts({input.runtime, progress.without_progress()}, input, std::move(parts), verified.span(),
                             drawing.line_counts);
    base::Array<StrokePlace> places(memory);
    base::Array<double> knots(memory);
    for (std::int64_t first = 0; first < parts.size();) {
        const std::int32_t line = parts[first].interval.line;
        std::int64_t end = first;
        while (end < parts.size() && parts[end].interval.line == line) ++end;
        for (const DrawnSubject& drawn : in.traced.styles) {
            if (drawn.subject != in.line(line).subject) continue;
            for (std::int64_t i = first; i < end; ++i) {
                PartPath path{drawn, parts[i], std::move(places), std::move(knots)};
                draw(in, path, strokes);
                places = std::move(path.place);
                knots = std::move(path.knot);
            }
        }
        first = end;
    }
}

} // namespace hrbfnpr::frame
