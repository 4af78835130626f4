// SPDX-License-Identifier: MIT
#include "strokes/stroke_field.h"

#include "geometry/tangent_frame.h"
#include "stipples/blue_noise.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace hrbfnpr::strokes {
namespace {

using geometry::VecArray;

// A principal direction counts nothing below the first confidence, and in full above the second.
constexpr double unsure = 0.05;
constexpr double sure = 0.35;
// ... and half where the principal curvatures are this part of their mean difference apart: what is nearly flat
// has directions, but they are those of its noise.
constexpr double flat_part = 0.6;

// What measured directions count against smoothness, for the strokes and for telling their sets.
constexpr double field_fidelity = 0.35;
constexpr double set_fidelity = 0.06;
// The caller's directions are no measurements: they count nearly in full.
constexpr double given_fidelity = 8.0;

struct Measured {
    explicit Measured(base::Memory& memory, std::int64_t count) : direction(memory, count), trust(memory, count) {}

    VecArray direction;
    base::Array<double> trust;
};

Measured measure_curvature(const marks::Site& site, const VecArray& position, const base::Progress& progress) {
    Measured measured(site.memory(), position.size());
    base::Array<surface::Curvature> curvature(site.memory());
    surface::principal_curvatures(site.runtime, site.implicit, position, curvature, progress);
    double sum = 0.0;
    for (const surface::Curvature& c : curvature) sum += c.k1 - c.k2;
    const double typical = sum / static_cast<double>(position.size());
    for (std::int64_t i = 0; i < position.size(); ++i) {
        const surface::Curvature& c = curvature[i];
        const double difference = c.k1 - c.k2;
        const double strength = difference > 0.0 ? difference / (difference + flat_part * typical) : 0.0;
        measured.direction.set(i, c.d1);
        measured.trust[i] = strength * glm::smoothstep(unsure, sure, c.confidence);
    }
    return measured;
}

Measured measure_combing(const marks::Site& site, const VecArray& normal) {
    Measured measured(site.memory(), normal.size());
    for (std::int64_t i = 0; i < normal.size(); ++i) {
        const Combing combing = combing_at(normal[i]);
        measured.direction.set(i, combing.r);
        measured.trust[i] = combing.trust;
    }
    return measured;
}

// Where the field has no direction the basis of a stipple stands for it, and counts nothing.
Measured measure_function(const marks::Site& site, const marks::DirectionFunction& function,
                          const stipples::EvenMarks& even, const base::Progress& progress) {
    Measured measured(site.memory(), even.position.size());
    marks::directions_at(site, function, even.position, even.normal, measured.direction, progress);
    for (std::int64_t i = 0; i < even.position.size(); ++i) {
        const glm::dvec3 d = measured.direction[i];
        measured.trust[i] = glm::dot(d, d) > 0.5 ? 1.0 : 0.0;
        if (measured.trust[i] == 0.0) measured.direction.set(i, geometry::stipple_frame(even.normal[i]).u);
    }
    return measured;
}

Measured measure(const marks::Site& site, marks::Kind kind, const Settings& settings, const stipples::EvenMarks& even,
                 const base::Progress& progress) {
    if (kind == marks::Kind::principal) return measure_curvature(site, even.position, progress);
    if (kind == marks::Kind::field) return measure_function(site, settings.direction, even, progress);
    return measure_combing(site, even.normal);
}

} // namespace

Combing combing_at(const glm::dvec3& n) noexcept {
    const geometry::TangentFrame frame = geometry::combing_frame(n);
    return {frame.r, frame.u, geometry::combing_trust(n)};
}

StrokeFieldResult make_stroke_field(const marks::Site& site, const stipples::SurfaceCells& cells, marks::Kind kind,
                                    const Settings& settings, std::int64_t samples, const base::Progress& progress) {
    const stipples::EvenMarks even = stipples::spread_evenly(site, cells, samples, kind, progress.part(0.0, 0.7));
    const Measured measured = measure(site, kind, settings, even, progress.part(0.7, 0.9));
    const bool given = kind == marks::Kind::field;
    // A surface whose area is not known (none of its cells' volume is near) has samples apart at least.
    const auto count = static_cast<double>(even.position.size());
    const double area = even.area > 0.0 ? even.area : cells.rough_area();
    surface::FieldSamples field{even.position,           even.normal,
                                measured.direction,      measured.trust,
                                std::sqrt(area / count), given ? given_fidelity : field_fidelity};
    const base::Array<std::int32_t> sheet =
        surface::sheets_at(site.runtime, site.implicit, even.position, progress.part(0.9, 0.9));
    field.sheet = &sheet;
    if (settings.symmetry == marks::Symmetry::line)
        return {surface::DirectionField(site.runtime, field, surface::Symmetry::line, progress.part(0.9, 1.0)),
                std::nullopt, area};
    surface::DirectionField crosses(site.runtime, field, surface::Symmetry::cross, progress.part(0.9, 0.95));
    field.fidelity = given ? given_fidelity : set_fidelity;
    return {std::move(crosses),
            surface::DirectionField(site.runtime, field, surface::Symmetry::line, progress.part(0.95, 1.0)), area};
}

} // namespace hrbfnpr::strokes
