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

} // namespace

// The border is where the two smallest components of n are alike in magnitude.
Combing combing_at(const glm::dvec3& n) noexcept {
    const geometry::TangentFrame frame = geometry::combing_frame(n);
    double a = std::abs(n.x);
    double b = std::abs(n.y);
    double c = std::abs(n.z);
    if (a > b) std::swap(a, b);
    if (b > c) std::swap(b, c);
    if (a > b) std::swap(a, b);
    return {frame.r, frame.u, glm::smoothstep(0.05, 0.35, b - a)};
}

StrokeFieldResult make_stroke_field(const marks::Site& site, const stipples::SurfaceCells& cells, marks::Group group,
                                    marks::StrokeField kind, std::int64_t samples, const base::Progress& progress) {
    const stipples::EvenMarks even = stipples::spread_evenly(site, cells, samples, group, progress.part(0.0, 0.7));
    const Measured measured = group == marks::Group::curvature
                                  ? measure_curvature(site, even.position, progress.part(0.7, 0.9))
                                  : measure_combing(site, even.normal);
    // A surface whose area is not known (none of its cells' volume is near) has samples apart at least.
    const auto count = static_cast<double>(even.position.size());
    const double area = even.area > 0.0 ? even.area : cells.rough_area();
    surface::FieldSamples field{even.position,           even.normal,   measured.direction, measured.trust,
                                std::sqrt(area / count), field_fidelity};
    if (kind == marks::StrokeField::line)
        return {surface::DirectionField(site.runtime, field, surface::Symmetry::line, progress.part(0.9, 1.0)),
                std::nullopt, area};
    surface::DirectionField crosses(site.runtime, field, surface::Symmetry::cross, progress.part(0.9, 0.95));
    field.fidelity = set_fidelity;
    return {std::move(crosses),
            surface::DirectionField(site.runtime, field, surface::Symmetry::line, progress.part(0.95, 1.0)), area};
}

} // namespace hrbfnpr::strokes
