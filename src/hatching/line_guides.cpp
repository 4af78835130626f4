// SPDX-License-Identifier: MIT
#include "hatching/line_guides.h"

#include "geometry/tangent_frame.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::hatching {
namespace {

// Against sure curvature: what is asked for by name is smoothed less, and hardly turned by the axis.
constexpr double strength = 4.0;

// A tangent in the frame of sample i.
Complex in_frame(const SampleGraph& graph, std::int64_t i, const glm::dvec3& v) noexcept {
    return {glm::dot(v, graph.u[i]), glm::dot(v, glm::cross(graph.normal[i], graph.u[i]))};
}

// Where the surface faces the eye lines are left to the others; near the silhouette they are conjugate to the tangent
// part of the direction to it: II(view, line) = 0.  A silhouette's own tangent is that.  [Hertzmann & Zorin 2000]
Complex along_silhouette(const Bend& bend, const Complex& view, const FieldSettings& settings) noexcept {
    const Complex turned = bend.mean * view + bend.difference * std::conj(view); // the shape operator's
    const double size = std::abs(turned);
    if (!(size > 0.0)) return Complex(0.0);
    const double sure = std::min(1.0, full_radius * settings.diagonal * size / std::abs(view));
    const Complex line = Complex(0.0, 1.0) * turned / size;
    return sure * std::norm(view) * std::norm(view) * line * line;
}

Complex named(const SampleGraph& graph, std::int64_t i, const Bend& bend, const FieldSettings& settings) noexcept {
    const glm::dvec3 n = graph.normal[i];
    Complex line(0.0);
    switch (settings.guide) {
    case Guide::curvature: break;
    case Guide::combing:
        line = in_frame(graph, i, geometry::combing_frame(n).r);
        return geometry::combing_trust(n) * line * line;
    case Guide::sections: line = in_frame(graph, i, glm::cross(settings.axis, n)); break;
    case Guide::light: line = in_frame(graph, i, settings.guide_direction); break;
    case Guide::silhouette: return along_silhouette(bend, in_frame(graph, i, settings.guide_direction), settings);
    }
    return line * line;
}

} // namespace

void mix_named_guide(const SampleGraph& graph, const base::Array<Bend>& bend, const FieldSettings& settings,
                     base::Array<Complex>& guide) {
    const double weight = settings.guide_weight;
    for (std::int64_t i = 0; i < graph.size(); ++i)
        guide[i] = (1.0 - weight) * guide[i] + weight * strength * named(graph, i, bend[i], settings);
}

} // namespace hrbfnpr::hatching
