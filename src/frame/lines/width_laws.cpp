// SPDX-License-Identifier: MIT
// At each point of a curve the factors of depth and light (point_factors) are multiplied by that of curvature
// (add_curvature), which is smoothed along the image of the curve (smooth_along). Along a line the outline, found by
// counting, has a factor of its own, which fades out beyond its ends (along).
#include "frame/lines/width_laws.h"

#include "base/assert.h"
#include "frame/lines/tuning.h"
#include "frame/scene/light.h"
#include "implicit/evaluate_all.h"

#include <glm/matrix.hpp>

#include <cmath>
#include <iterator>
#include <limits>

namespace hrbfnpr::frame {
namespace {

struct DepthRange {
    double nearest = std::numeric_limits<double>::infinity();
    double farthest = -std::numeric_limits<double>::infinity();
};

// A factor that goes evenly from 1, where share is 0.
double by(float factor, double share) noexcept {
    return glm::mix(1.0, static_cast<double>(factor), std::clamp(share, 0.0, 1.0));
}

bool has_point_law(const LineStyle& style) noexcept {
    return style.far_factor != 1.0F || style.lit_factor != 1.0F || style.curvature_factor != 1.0F;
}

double fade_of(const DrawnAs& as) noexcept { return line_tuning.fade_widths * static_cast<double>(as.style->width); }

// The depths of the points of drawn lines that are in the window.
DepthRange depth_range(const Scene& scene, const LineInput& in) {
    DepthRange range;
    const glm::dvec4 window(scene.lens.viewport);
    for (std::size_t s = 0; s < in.subjects.size(); ++s) {
        const visibility::Subject& subject = in.subjects[s];
        if (std::none_of(in.styles.begin(), in.styles.end(),
                         [&](const DrawnAs& as) { return static_cast<std::size_t>(as.subject) == s; }))
            continue;
        const glm::dmat4 to_eye = scene.camera.view * subject.to_world;
        for (const curves::CurvePoint& p : subject.curves->point) {
            const visibility::Seen seen = visibility::see(subject.view, p.position);
            const glm::dvec2 at = seen.place - glm::dvec2(window.x, window.y);
            if (!(seen.w > 0.0 && at.x >= 0.0 && at.y >= 0.0 && at.x <= window.z && at.y <= window.w)) continue;
            const double depth = -(to_eye * glm::dvec4(p.position, 1.0)).z;
            range = {std::min(range.nearest, depth), std::max(range.farthest, depth)};
        }
    }
    return range;
}

base::Array<float> point_factors(base::Memory& memory, const Scene& scene, const Light& light, const DrawnAs& as,
                                 const visibility::Subject& subject, const DepthRange& depths) {
    const glm::dmat4 to_eye = scene.camera.view * subject.to_world;
    const double range = depths.farthest - depths.nearest;
    const base::Array<curves::CurvePoint>& points = subject.curves->point;
    base::Array<float> factors(memory, points.size());
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const double depth = -(to_eye * glm::dvec4(points[i].position, 1.0)).z;
        const float n_dot_l = lit(light, glm::vec3(glm::normalize(points[i].gradient)));
        const double facing = std::isfinite(n_dot_l) ? static_cast<double>(n_dot_l) : 0.0; // where f is constant
        const double far = range > 0.0 ? (depth - depths.nearest) / range : 0.0;
        factors[i] = static_cast<float>(by(as.style->far_factor, far) * by(as.style->lit_factor, 0.5 + 0.5 * facing));
    }
    return factors;
}

// On a contour grad g . v = v H v: as n . v = 0 there, the radial curvature is that over |grad f| v^2.
void find_radial_curvature(const visibility::Subject& subject, base::Array<double>& curvature) {
    for (std::int64_t i = 0; i < curvature.size(); ++i) {
        const curves::CurvePoint& p = subject.curves->point[i];
        const glm::dvec3 v = subject.view.sight(p.position);
        curvature[i] = std::abs(glm::dot(p.level_gradient, v)) / (glm::length(p.gradient) * glm::dot(v, v));
    }
}

// b H b / |grad f|, b tangent to the surface and across the line.
void find_curvature_across(const base::Runtime& runtime, const implicit::Implicit& surface,
                           const base::Array<curves::CurvePoint>& points, base::Array<double>& curvature,
                           const base::Progress& progress) {
    geometry::VecArray place(runtime.memory, points.size());
    for (std::int64_t i = 0; i < points.size(); ++i) place.set(i, points[i].position);
    base::Array<double> hessian(runtime.memory, 6 * points.size());
    implicit::FieldBatch fields;
    for (std::size_t c = 0; c < 6; ++c)
        fields.hessian[c] = hessian.data() + static_cast<std::int64_t>(c) * points.size();
    implicit::evaluate_all(runtime, surface, place, fields, progress.standing());
    for (std::int64_t i = 0; i < points.size(); ++i) {
        const glm::dvec3 b = glm::normalize(glm::cross(points[i].gradient, points[i].direction()));
        const auto h = [&](std::size_t c) { return fields.hessian[c][i]; };
        const double second = h(0) * b.x * b.x + h(3) * b.y * b.y + h(5) * b.z * b.z +
                              2.0 * (h(1) * b.x * b.y + h(2) * b.x * b.z + h(4) * b.y * b.z);
        curvature[i] = std::abs(second) / glm::length(points[i].gradient);
    }
}

// Weights fall by e over some pixels of the image. At samples a fit's curvature jumps, and where the line of sight is
// tangent to a contour its radial curvature is 0: neither is to be seen.
base::Array<double> smooth_along(const visibility::Subject& subject, double pixels, const base::Array<double>& values) {
    const curves::Curves& curves = *subject.curves;
    HRBFNPR_ASSERT(values.size() == curves.point.size() && pixels > 0.0);
    base::Array<double> kept(values.memory(), values.size()); // share of the value before that goes on
    base::Array<double> smooth(values.memory(), values.size());
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

void add_curvature(const base::Runtime& runtime, const LineInput& in, const DrawnAs& as, base::Array<float>& factors,
                   const base::Progress& progress) {
    const visibility::Subject& subject = in.subjects[static_cast<std::size_t>(as.subject)];
    const implicit::Implicit& surface = *in.occluders[static_cast<std::size_t>(subject.item)].surface;
    base::Array<double> curvature(runtime.memory, factors.size());
    if (subject.level != nullptr)
        find_radial_curvature(subject, curvature);
    else
        find_curvature_across(runtime, surface, subject.curves->point, curvature, progress);
    for (double& c : curvature)
        if (!std::isfinite(c)) c = 0.0;
    curvature = smooth_along(subject, line_tuning.smooth_widths * static_cast<double>(as.style->width), curvature);
    const double bent = static_cast<double>(as.style->curvature_radius) * surface.diagonal();
    for (std::int64_t i = 0; i < curvature.size(); ++i)
        factors[i] *=
            static_cast<float>(by(as.style->curvature_factor, 1.0 - std::min(1.0, 1.0 / (bent * curvature[i]))));
}

} // namespace

WidthLaws::WidthLaws(const base::Runtime& runtime, const Scene& scene, const drawing::Drawing& drawing,
                     const LineInput& input, const base::Progress& progress)
    : input_(input), styles_(runtime.memory), factors_(runtime.memory), outline_(runtime.memory) {
    DepthRange depths;
    const auto is_by_depth = [](const DrawnAs& as) { return as.style->far_factor != 1.0F; };
    if (std::any_of(input.styles.begin(), input.styles.end(), is_by_depth)) depths = depth_range(scene, input);
    base::Array<std::uint8_t> wanted(runtime.memory, static_cast<std::int64_t>(input.subjects.size()));
    for (DrawnAs as : input.styles) {
        HRBFNPR_ASSERT(as.subject >= 0 && as.subject < wanted.size());
        if (changes_along(as)) wanted[as.subject] = 1;
        if (has_point_law(*as.style)) {
            const Light& light = scene.items[drawing.layers[as.layer].item].light;
            base::Array<float>& factors = factors_.add(point_factors(
                runtime.memory, scene, light, as, input.subjects[static_cast<std::size_t>(as.subject)], depths));
            if (as.style->curvature_factor != 1.0F) add_curvature(runtime, input, as, factors, progress);
            as.factor = factors.data();
        }
        styles_.push_back(as);
    }
    if (std::any_of(wanted.begin(), wanted.end(), [](std::uint8_t w) { return w != 0; }))
        outline_ = visibility::find_outline(runtime, input.subjects, input.occluders, input.found, input.lengths,
                                            wanted.span(), progress.standing());
}

std::span<const visibility::OutlinePart> WidthLaws::outline_of(std::int32_t line) const noexcept {
    const auto before = [](const visibility::OutlinePart& a, const visibility::OutlinePart& b) {
        return a.line < b.line;
    };
    const auto [first, end] =
        std::equal_range(outline_.parts.begin(), outline_.parts.end(), visibility::OutlinePart{line, 0.0, 0.0}, before);
    return {first, end};
}

bool WidthLaws::changes_along(const DrawnAs& as) noexcept {
    return as.style->outline_factor != 1.0F &&
           (as.style->kind == LineKind::contour || as.style->kind == LineKind::border);
}

double WidthLaws::step(const DrawnAs& as) noexcept {
    return changes_along(as) ? fade_of(as) / line_tuning.fade_steps : std::numeric_limits<double>::infinity();
}

double WidthLaws::along(const DrawnAs& as, std::int32_t line, double at) const noexcept {
    if (!changes_along(as)) return 1.0;
    const std::span<const visibility::OutlinePart> parts = outline_of(line);
    double nearest = std::numeric_limits<double>::infinity();
    for (const double here : {at, at - round(line), at + round(line)}) {
        const auto begins = [](double place, const visibility::OutlinePart& part) { return place < part.begin_at; };
        const auto next = std::upper_bound(parts.begin(), parts.end(), here, begins);
        if (next != parts.end()) nearest = std::min(nearest, next->begin_at - here);
        if (next != parts.begin()) nearest = std::min(nearest, std::max(0.0, here - std::prev(next)->end_at));
    }
    // From 1 to 0, with no bend at either end.
    const double u = std::clamp(1.0 - nearest / fade_of(as), 0.0, 1.0);
    return by(as.style->outline_factor, u * u * (3.0 - 2.0 * u));
}

bool WidthLaws::changes(const DrawnAs& as, std::int32_t line, double from, double to) const noexcept {
    HRBFNPR_ASSERT(!(from > to));
    if (!changes_along(as)) return false;
    for (const visibility::OutlinePart& part : outline_of(line))
        for (const double turn : {-round(line), 0.0, round(line)}) {
            const double begin = part.begin_at + turn;
            const double end = part.end_at + turn;
            if (to > begin - fade_of(as) && from < end + fade_of(as) && !(from >= begin && to <= end)) return true;
        }
    return false;
}

} // namespace hrbfnpr::frame
