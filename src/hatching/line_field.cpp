// SPDX-License-Identifier: MIT
#include "hatching/line_field.h"

#include "hatching/graph_solver.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::hatching {
namespace {

// Averages of curvature with the neighbours: each spreads by about half a spacing, so many by some four.
constexpr int averages = 48;
// How strongly lines are pulled to unit length, and how often.
constexpr double to_unit = 0.2;
constexpr int pulls = 2;
// Curvatures over the diagonal that are smaller are those of a flat face, as a fit within its tolerance has it; from
// twice as much on they count.
constexpr double flat_bend = 0.1;
// What is less sure says nothing on a sheet of its own, as a flat face across the axis is.
constexpr double unsure = 1e-3;

void average(const base::Runtime& runtime, const SampleGraph& graph, const base::Array<Bend>& from,
             base::Array<Bend>& to, const base::Progress& progress) {
    runtime.parallel.for_chunks(graph.size(), samples_a_task, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        for (std::int64_t i = begin; i < end; ++i) {
            Bend sum = from[i];
            double count = 1.0;
            for (const SampleGraph::Link& link : graph.links(i)) {
                sum.mean += from[link.to].mean;
                sum.difference += product(link.back, from[link.to].difference);
                count += 1.0;
            }
            to[i] = {sum.mean / count, sum.difference / count};
        }
    });
}

} // namespace

base::Array<Bend> average_bends(const base::Runtime& runtime, const SampleGraph& graph,
                                const base::Array<surface::Curvature>& curvature, const base::Progress& progress) {
    base::Array<Bend> bend(runtime.memory, graph.size());
    base::Array<Bend> next(runtime.memory, graph.size());
    const double largest = 1.0 / (0.25 * graph.spacing); // what is sharper the samples do not know
    for (std::int64_t i = 0; i < graph.size(); ++i) {
        const surface::Curvature& c = curvature[i];
        const double k1 = std::clamp(c.k1, -largest, largest);
        const double k2 = std::clamp(c.k2, -largest, largest);
        bend[i] = {0.5 * (k1 + k2), 0.5 * (k1 - k2) * std::polar(1.0, 2.0 * graph.angle(i, c.d1))};
    }
    for (int k = 0; k < averages; ++k) {
        average(runtime, graph, bend, next, progress);
        std::swap(bend, next);
    }
    return bend;
}

base::Array<Complex> guide_by_curvature(const base::Runtime& runtime, const SampleGraph& graph,
                                        const base::Array<Bend>& bend, const FieldSettings& settings) {
    base::Array<Complex> guide(runtime.memory, graph.size());
    for (std::int64_t i = 0; i < graph.size(); ++i) {
        const double apart = std::abs(bend[i].difference);
        const double k1 = std::abs(bend[i].mean + apart);
        const double k2 = std::abs(bend[i].mean - apart);
        if (!(apart > 0.0)) continue;
        const double bends = settings.diagonal * std::max(k1, k2);
        const double sure = std::pow((k1 - k2) / (k1 + k2), 2.0) * std::min(1.0, full_radius * bends) *
                            std::clamp((bends - flat_bend) / flat_bend, 0.0, 1.0);
        guide[i] = (k1 >= k2 ? sure : -sure) / apart * bend[i].difference;
    }
    return guide;
}

// As long as it is not along the normal.  Between creases nothing from beside a flat face says more of it than rounding
// errors do: it has another axis.
void add_axis(const SampleGraph& graph, const FieldSettings& settings, base::Array<Complex>& guide) {
    const glm::dvec3 size = glm::abs(settings.axis);
    const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1.0, 0.0, 0.0)
                             : size.y <= size.z                   ? glm::dvec3(0.0, 1.0, 0.0)
                                                                  : glm::dvec3(0.0, 0.0, 1.0);
    for (std::int64_t i = 0; i < graph.size(); ++i) {
        const glm::dvec3 around = glm::cross(settings.axis, graph.normal[i]);
        guide[i] += settings.axis_weight * glm::dot(around, around) * std::polar(1.0, 2.0 * graph.angle(i, around));
        if (graph.sheet.empty() || std::abs(guide[i]) >= unsure) continue;
        const glm::dvec3 across = glm::cross(other, graph.normal[i]);
        guide[i] += unsure * glm::dot(across, across) * std::polar(1.0, 2.0 * graph.angle(i, across));
    }
}

// (L (l / h)^2 / 6 + a) z = a q, then twice with a term that pulls z to unit length.
base::Array<double> smooth_lines(const base::Runtime& runtime, const SampleGraph& graph,
                                 const base::Array<Complex>& guide, const FieldSettings& settings,
                                 const base::Progress& progress) {
    const double length = settings.smoothing * settings.diagonal / graph.spacing;
    const double stiffness = length * length / 6.0;
    base::Array<Complex> z(runtime.memory, graph.size());
    base::Array<Complex> right(runtime.memory, graph.size());
    base::Array<double> held(runtime.memory, graph.size()); // a and the pull
    for (int pull = 0; pull <= pulls; ++pull) {
        const double unit = pull > 0 ? to_unit : 0.0;
        for_samples(runtime, graph.size(), [&](std::int64_t i) {
            const double size = std::abs(z[i]);
            right[i] = guide[i] + (size > 0.0 ? unit / size * z[i] : Complex(0.0));
            held[i] = std::abs(guide[i]) + unit + 1e-6;
        });
        solve(runtime, {}, right, z, progress, [&](std::int64_t i, const base::Array<Complex>& from) {
            Complex sum = held[i] * from[i];
            for (const SampleGraph::Link& link : graph.links(i))
                sum += stiffness * (from[i] - product(link.back, from[link.to]));
            return sum;
        });
    }
    base::Array<double> angle(runtime.memory, graph.size());
    for (std::int64_t i = 0; i < graph.size(); ++i) angle[i] = 0.5 * std::arg(z[i]);
    return angle;
}

} // namespace hrbfnpr::hatching
