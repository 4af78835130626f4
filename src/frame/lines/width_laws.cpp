// SPDX-License-Identifier: MIT
#include "frame/lines/width_laws.h"

#include "implicit/evaluate_all.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace hrbfnpr::frame {
namespace {

// Over so many widths the outline's width goes over to that of the line beyond its ends.
constexpr double fade_widths = 6.0;
constexpr double fade_steps = 8.0;
// Over which curvatures are smoothed along a line.
constexpr double smooth_widths = 8.0;

double mix(double a, double b, double share) noexcept { return a + share * (b - a); }

// Factors at both ends of something, evenly between: `share` 0 is where it is 1.
double by(float factor, double share) noexcept {
    return mix(1.0, static_cast<double>(factor), std::clamp(share, 0.0, 1.0));
}

// From 1 to 0, with no bend at either end.
double smooth(double share) noexcept {
    const double u = std::clamp(1.0 - share, 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

bool has_point_law(const LineStyle& style) noexcept {
    return style.far_factor != 1.0F || style.lit_factor != 1.0F || style.curvature_factor != 1.0F;
}

bool has_outline(const DrawnAs& as) noexcept {
    return as.style->outline_factor != 1.0F &&
           (as.style->kind == LineKind::contour || as.style->kind == LineKind::border);
}

double fade_of(const DrawnAs& as) noexcept { return fade_widths * static_cast<double>(as.style->width); }

// The share of curvature_factor for a curvature in 1 / diagonals.
double bent(const LineStyle& style, double curvature) noexcept {
    return 1.0 - std::min(1.0, 1.0 / (static_cast<double>(style.curvature_radius) * curvature));
}

} // namespace

WidthLaws::WidthLaws(const base::Runtime& runtime, const Scene& scene, const drawing::Drawing& drawing,
                     const LineInput& input, const base::Progress& progress)
    : runtime_(runtime), scene_(scene), drawing_(drawing), input_(input), progress_(progress), styles_(runtime.memory),
      factors_(runtime.memory), outline_(runtime.memory) {
    for (const DrawnAs& as : input.styles) styles_.push_back(as);
    const auto by_depth = [](const DrawnAs& as) { return as.style->far_factor != 1.0F; };
    if (std::any_of(styles_.begin(), styles_.end(), by_depth)) depths_ = depth_range();
    for (std::int64_t s = 0; s < styles_.size(); ++s)
        if (has_point_law(*styles_[s].style)) add_points(s);
    if (std::any_of(styles_.begin(), styles_.end(), has_outline)) find_outline();
}

void WidthLaws::find_outline() {
    base::Array<std::uint8_t> wanted(runtime_.memory, static_cast<std::int64_t>(input_.subjects.size()));
    for (const DrawnAs& as : styles_)
        if (has_outline(as)) wanted[as.subject] = 1;
    outline_ = visibility::find_outline(runtime_, input_.subjects, input_.occluders, input_.found, input_.lengths,
                                        wanted.span(), progress_.standing());
}

// Of the points that are in the window.
WidthLaws::DepthRange WidthLaws::depth_range() const {
    DepthRange range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    const glm::dvec4 window(scene_.lens.viewport);
    base::Array<std::uint8_t> drawn(runtime_.memory, static_cast<std::int64_t>(input_.subjects.size()));
    for (const DrawnAs& as : styles_) drawn[as.subject] = 1;
    for (std::size_t s = 0; s < input_.subjects.size(); ++s) {
        if (drawn[static_cast<std::int64_t>(s)] == 0) continue;
        const visibility::Subject& subject = input_.subjects[s];
        const glm::dmat4 to_eye = scene_.camera.view * subject.to_world;
        for (const curves::CurvePoint& p : subject.curves->point) {
            const visibility::Seen seen = visibility::see(subject.view, p.position);
            const glm::dvec2 in = seen.place - glm::dvec2(window.x, window.y);
            if (!(seen.w > 0.0 && in.x >= 0.0 && in.y >= 0.0 && in.x <= window.z && in.y <= window.w)) continue;
            const double depth = -(to_eye * glm::dvec4(p.position, 1.0)).z;
            range = {std::min(range.nearest, depth), std::max(range.farthest, depth)};
        }
    }
    return range;
}

void WidthLaws::add_points(std::int64_t style) {
    DrawnAs& as = styles_[style];
    const visibility::Subject& subject = subject_of(as);
    const Light& light = scene_.items[drawing_.layers[as.layer].item].light;
    const glm::dmat4 to_eye = scene_.camera.view * subject.to_world;
    const double depths = depths_.farthest - depths_.nearest;
    const base::Array<curves::CurvePoint>& points = subject.curves->point;
    base::Array<float>& factors = factors_.add(base::Array<float>(runtime_.memory, points.size()));
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const double depth = -(to_eye * glm::dvec4(points[i].position, 1.0)).z;
        const float n_dot_l = lit(light, glm::vec3(glm::normalize(points[i].gradient)));
        const double facing = std::isfinite(n_dot_l) ? static_cast<double>(n_dot_l) : 0.0; // where f is constant
        const double far = depths > 0.0 ? (depth - depths_.nearest) / depths : 0.0;
        factors[i] = static_cast<float>(by(as.style->far_factor, far) * by(as.style->lit_factor, 0.5 + 0.5 * facing));
    }
    if (as.style->curvature_factor != 1.0F) add_curvature(as, factors.span());
    as.factor = factors.data();
}

// On a contour grad g . v = v H v: as n . v = 0 there, the radial curvature is that over |grad f| v^2.
void WidthLaws::find_radial_curvature(const visibility::Subject& subject, base::Array<double>& curvature) {
    for (std::int64_t i = 0; i < curvature.size(); ++i) {
        const curves::CurvePoint& p = subject.curves->point[i];
        const glm::dvec3 v = subject.view.sight(p.position);
        curvature[i] = std::abs(glm::dot(p.level_gradient, v)) / (glm::length(p.gradient) * glm::dot(v, v));
    }
}

// b H b / |grad f|, b tangent to the surface and across the line.
void WidthLaws::find_curvature_across(const visibility::Subject& subject, base::Array<double>& curvature) const {
    const base::Array<curves::CurvePoint>& points = subject.curves->point;
    geometry::VecArray place(runtime_.memory, points.size());
    for (std::int64_t i = 0; i < points.size(); ++i) place.set(i, points[i].position);
    base::Array<double> hessian(runtime_.memory, 6 * points.size());
    implicit::FieldBatch fields;
    for (std::size_t c = 0; c < 6; ++c)
        fields.hessian[c] = hessian.data() + static_cast<std::int64_t>(c) * points.size();
    implicit::evaluate_all(runtime_, *input_.occluders[static_cast<std::size_t>(subject.item)].surface, place, fields,
                           progress_.standing());
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 b = glm::normalize(glm::cross(points[i].gradient, points[i].direction()));
        const auto h = [&](std::size_t c) { return fields.hessian[c][i]; };
        const double second = h(0) * b.x * b.x + h(3) * b.y * b.y + h(5) * b.z * b.z +
                              2.0 * (h(1) * b.x * b.y + h(2) * b.x * b.z + h(4) * b.y * b.z);
        curvature[i] = std::abs(second) / glm::length(points[i].gradient);
    }
}

// Weights fall by e over so many pixels of the image.  At samples a fit's curvature jumps, and where the line of sight
// is tangent to a contour its radial curvature is 0: neither is to be seen.
void WidthLaws::smooth_along(const visibility::Subject& subject, double pixels, base::Array<double>& values) const {
    const curves::Curves& curves = *subject.curves;
    base::Array<double> kept(runtime_.memory, values.size()); // share of the value before that goes on
    base::Array<double> forth(runtime_.memory, values.size());
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        const std::int64_t first = curves.first[c];
        const std::int64_t size = curves.size_of(c);
        const bool closed = curves.closed[c] != 0;
        const auto number = [&](std::int64_t k) { return first + k % size; };
        for (std::int64_t k = 0; k < size; ++k) {
            const visibility::Seen a = visibility::see(subject.view, curves.point[number(k + size - 1)].position);
            const visibility::Seen b = visibility::see(subject.view, curves.point[number(k)].position);
            const bool joined = (k > 0 || closed) && a.w > 0.0 && b.w > 0.0;
            kept[number(k)] = joined ? std::exp(-glm::distance(a.place, b.place) / pixels) : 0.0;
        }
        const std::int64_t steps = closed ? 2 * size : size;
        double value = values[first];
        for (std::int64_t k = 0; k < steps; ++k) {
            const std::int64_t i = number(k);
            forth[i] = value = mix(values[i], value, kept[i]);
        }
        double back = values[number(size - 1)];
        for (std::int64_t k = steps; k > 0; --k) {
            const std::int64_t i = number(k - 1);
            back = mix(values[i], back, kept[number(k)]);
            if (k <= size) forth[i] = 0.5 * (forth[i] + back);
        }
    }
    values = std::move(forth);
}

void WidthLaws::add_curvature(const DrawnAs& as, std::span<float> factors) const {
    const visibility::Subject& subject = subject_of(as);
    base::Array<double> curvature(runtime_.memory, static_cast<std::int64_t>(factors.size()));
    subject.level != nullptr ? find_radial_curvature(subject, curvature) : find_curvature_across(subject, curvature);
    for (double& c : curvature)
        if (!std::isfinite(c)) c = 0.0;
    smooth_along(subject, smooth_widths * static_cast<double>(as.style->width), curvature);
    const double diagonal = input_.occluders[static_cast<std::size_t>(subject.item)].surface->diagonal();
    for (std::int64_t i = 0; i < curvature.size(); ++i)
        factors[static_cast<std::size_t>(i)] *=
            static_cast<float>(by(as.style->curvature_factor, bent(*as.style, curvature[i] * diagonal)));
}

std::span<const visibility::OutlinePart> WidthLaws::outline_of(std::int32_t line) const noexcept {
    const auto before = [](const visibility::OutlinePart& part, std::int32_t l) { return part.line < l; };
    const visibility::OutlinePart* const first =
        std::lower_bound(outline_.parts.begin(), outline_.parts.end(), line, before);
    const visibility::OutlinePart* end = first;
    while (end != outline_.parts.end() && end->line == line) ++end;
    return {first, end};
}

bool WidthLaws::changes_along(const DrawnAs& as) const noexcept { return has_outline(as); }

double WidthLaws::step(const DrawnAs& as) const noexcept {
    return has_outline(as) ? fade_of(as) / fade_steps : std::numeric_limits<double>::infinity();
}

// From the nearest of the parts, which are in order.
double WidthLaws::away(std::span<const visibility::OutlinePart> parts, double at) noexcept {
    const auto begins = [](double place, const visibility::OutlinePart& part) { return place < part.begin_at; };
    const auto next = std::upper_bound(parts.begin(), parts.end(), at, begins);
    double away = std::numeric_limits<double>::infinity();
    if (next != parts.end()) away = next->begin_at - at;
    if (next != parts.begin()) away = std::min(away, std::max(0.0, at - std::prev(next)->end_at));
    return away;
}

double WidthLaws::along(const DrawnAs& as, std::int32_t line, double at) const noexcept {
    if (!has_outline(as)) return 1.0;
    const visibility::Line& its = input_.found.lines.lines[line];
    const double whole = its.closed ? input_.lengths.whole(its) : 0.0;
    const std::span<const visibility::OutlinePart> parts = outline_of(line);
    const double nearest = std::min({away(parts, at), away(parts, at - whole), away(parts, at + whole)});
    return by(as.style->outline_factor, smooth(nearest / fade_of(as)));
}

bool WidthLaws::changes(const DrawnAs& as, std::int32_t line, double from, double to) const noexcept {
    if (!has_outline(as)) return false;
    const visibility::Line& its = input_.found.lines.lines[line];
    const double whole = its.closed ? input_.lengths.whole(its) : 0.0;
    for (const visibility::OutlinePart& part : outline_of(line))
        for (const double turn : {-whole, 0.0, whole}) {
            const double begin = part.begin_at + turn;
            const double end = part.end_at + turn;
            if (to > begin - fade_of(as) && from < end + fade_of(as) && !(from >= begin && to <= end)) return true;
        }
    return false;
}

} // namespace hrbfnpr::frame
