// SPDX-License-Identifier: MIT
#include "hatching/field.h"

#include "base/sort.h"
#include "geometry/neighbours.h"
#include "geometry/tangent_frame.h"
#include "hatching/tuning.h"
#include "surface/creased.h"
#include "surface/curvature.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace hrbfnpr::hatching {
namespace {

// ---- The graph

bool are_linked(const SampleGraph& graph, std::int64_t i, std::int64_t j) noexcept {
    const glm::dvec3 a = graph.normal[i];
    const glm::dvec3 b = graph.normal[j];
    const glm::dvec3 way = graph.position[j] - graph.position[i];
    const double length = glm::length(way);
    if (!(length > 0.0 && length <= hatching_tuning.farthest_link * graph.spacing)) return false;
    if (!(glm::dot(a, b) > hatching_tuning.same_sheet_cosine)) return false;
    if (!graph.sheet.empty() && surface::is_creased(graph.sheet[i], graph.sheet[j], a, b)) return false;
    const double steepest = hatching_tuning.steepest_link * length;
    return std::abs(glm::dot(way, a)) <= steepest && std::abs(glm::dot(way, b)) <= steepest;
}

// How a line of sample j, as exp(2 i angle) in its frame, is seen from sample i: by the rotation that takes one normal
// to the other along the shortest way.
Link line_link(const SampleGraph& graph, std::int64_t i, std::int32_t j) noexcept {
    const glm::dvec3 a = graph.normal[i];
    const glm::dvec3 b = graph.normal[j];
    const glm::dvec3 t = graph.u[i];
    const glm::dvec3 axis = glm::cross(a, b);
    const double cosine = glm::dot(a, b);
    const glm::dvec3 carried = t * cosine + glm::cross(axis, t) + axis * (glm::dot(axis, t) / (1.0 + cosine));
    return {std::polar(1.0, -2.0 * graph.angle(j, carried)), j, 1.0F};
}

// ---- What lines are to follow

// Principal curvatures at each sample: their mean, and half their difference as a line.
struct Bends {
    base::Array<double> mean;
    Numbers difference;
};

// Averages with the neighbours: each round spreads by about half a spacing, and the rounds together by some four.
Bends average_bends(const marks::Site& site, const SampleGraph& graph, const Links& links,
                    const base::Progress& progress) {
    base::Array<surface::Curvature> curvature(site.memory());
    surface::principal_curvatures(site.runtime, site.implicit, graph.position, curvature, progress);
    Bends bends{base::Array<double>(site.memory(), graph.nodes()), Numbers(site.memory(), graph.nodes())};
    Numbers means(site.memory(), graph.nodes());
    const double sharpest = 4.0 / graph.spacing; // samples cannot tell sharper bends
    for (std::int64_t i = 0; i < graph.nodes(); ++i) {
        const surface::Curvature& c = curvature[i];
        const double k1 = std::clamp(c.k1, -sharpest, sharpest);
        const double k2 = std::clamp(c.k2, -sharpest, sharpest);
        bends.mean[i] = 0.5 * (k1 + k2);
        bends.difference[i] = 0.5 * (k1 - k2) * std::polar(1.0, 2.0 * graph.angle(i, c.d1));
    }
    base::Array<double> next(site.memory(), graph.nodes());
    for (int round = 0; round < hatching_tuning.bend_averages; ++round) {
        for_nodes(site.runtime, graph.nodes(), progress, [&](std::int64_t i) {
            next[i] = bends.mean[i];
            for (std::int64_t k = graph.first[i]; k < graph.first[i + 1]; ++k)
                next[i] += bends.mean[graph.neighbour[k]];
            next[i] /= 1.0 + links.count(i);
        });
        std::swap(next, bends.mean);
    }
    iterate(site.runtime, hatching_tuning.bend_averages, bends.difference, progress,
            [&](std::int64_t i, const Numbers& z) { return links.mean(i, z); });
    return bends;
}

// A tangent in the frame of sample i.
Complex in_frame(const SampleGraph& graph, std::int64_t i, const glm::dvec3& v) noexcept {
    return {glm::dot(v, graph.u[i]), glm::dot(v, glm::cross(graph.normal[i], graph.u[i]))};
}

// Where the surface faces the eye lines are left to the others; near the silhouette they are conjugate to the tangent
// part of the direction to it: II(view, line) = 0. A silhouette's own tangent is so.  [Hertzmann & Zorin 2000]
Complex silhouette_line(double mean, const Complex& difference, const Complex& view, double diagonal) noexcept {
    const Complex turned = mean * view + difference * std::conj(view); // by the shape operator
    const double size = std::abs(turned);
    if (!(size > 0.0)) return Complex(0.0);
    const double sure = std::min(1.0, hatching_tuning.full_radius * diagonal * size / std::abs(view));
    const Complex line = Complex(0.0, 1.0) * turned / size;
    return sure * std::norm(view) * std::norm(view) * line * line;
}

Complex named_line(const SampleGraph& graph, std::int64_t i, const Bends& bends,
                   const FieldSettings& settings) noexcept {
    const glm::dvec3 n = graph.normal[i];
    Complex line(0.0);
    switch (settings.guide) {
    case Guide::curvature: break;
    case Guide::combing:
        line = in_frame(graph, i, geometry::combing_frame(n).r);
        return geometry::combing_trust(n) * line * line;
    case Guide::sections: line = in_frame(graph, i, glm::cross(settings.axis, n)); break;
    case Guide::light: line = in_frame(graph, i, settings.guide_direction); break;
    case Guide::silhouette:
        return silhouette_line(bends.mean[i], bends.difference[i], in_frame(graph, i, settings.guide_direction),
                               settings.diagonal);
    }
    return line * line;
}

// The line around the axis, as long as that is not along the normal. Between creases a flat face across the axis gets
// nothing from beside it but rounding errors: it has another axis.
Complex axis_line(const SampleGraph& graph, std::int64_t i, const FieldSettings& settings,
                  const Complex& wanted) noexcept {
    const auto around = [&](const glm::dvec3& axis, double weight) {
        const glm::dvec3 line = glm::cross(axis, graph.normal[i]);
        return weight * glm::dot(line, line) * std::polar(1.0, 2.0 * graph.angle(i, line));
    };
    const Complex line = around(settings.axis, settings.axis_weight);
    if (graph.sheet.empty() || std::abs(wanted + line) >= hatching_tuning.unsure) return line;
    const glm::dvec3 size = glm::abs(settings.axis);
    const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1.0, 0.0, 0.0)
                             : size.y <= size.z                   ? glm::dvec3(0.0, 1.0, 0.0)
                                                                  : glm::dvec3(0.0, 0.0, 1.0);
    return line + around(other, hatching_tuning.unsure);
}

Numbers wanted_lines(const marks::Site& site, const SampleGraph& graph, const Links& links,
                     const FieldSettings& settings, const marks::DirectionFunction& function,
                     const base::Progress& progress) {
    Numbers wanted(site.memory(), graph.nodes());
    if (function.function != nullptr) {
        geometry::VecArray direction(site.memory(), graph.nodes());
        marks::directions_at(site, function, graph.position, graph.normal, direction, progress);
        for (std::int64_t i = 0; i < graph.nodes(); ++i)
            if (const glm::dvec3 d = direction[i]; glm::dot(d, d) > 0.5)
                wanted[i] = std::polar(1.0, 2.0 * graph.angle(i, d));
        return wanted;
    }
    const Bends bends = average_bends(site, graph, links, progress);
    const double weight = settings.guide == Guide::curvature ? 0.0 : settings.guide_weight;
    for (std::int64_t i = 0; i < graph.nodes(); ++i) {
        wanted[i] = curvature_line(bends.mean[i], bends.difference[i], settings.diagonal);
        if (weight > 0.0)
            wanted[i] = (1.0 - weight) * wanted[i] +
                        weight * hatching_tuning.guide_strength * named_line(graph, i, bends, settings);
        wanted[i] += axis_line(graph, i, settings, wanted[i]);
    }
    return wanted;
}

} // namespace

Complex curvature_line(double mean, const Complex& difference, double diagonal) noexcept {
    const double apart = std::abs(difference);
    if (!(apart > 0.0)) return Complex(0.0);
    const double k1 = std::abs(mean + apart);
    const double k2 = std::abs(mean - apart);
    const double bend = diagonal * std::max(k1, k2);
    const double sure = std::pow((k1 - k2) / (k1 + k2), 2.0) * std::min(1.0, hatching_tuning.full_radius * bend) *
                        std::clamp(bend / hatching_tuning.flat_bend - 1.0, 0.0, 1.0);
    return (k1 >= k2 ? sure : -sure) / apart * difference;
}

void link_samples(const base::Runtime& runtime, SampleGraph& graph, const base::Progress& progress) {
    const std::int64_t n = graph.position.size();
    HRBFNPR_ASSERT(graph.normal.size() == n && (graph.sheet.empty() || graph.sheet.size() == n));
    HRBFNPR_ASSERT(graph.spacing > 0.0 || n == 0);
    graph.u.resize(n);
    for (std::int64_t i = 0; i < n; ++i) graph.u.set(i, geometry::any_perpendicular(graph.normal[i]));
    const geometry::Neighbours near(runtime.parallel, graph.position, hatching_tuning.neighbours, progress);
    base::Array<std::uint64_t> links(runtime.memory); // the begin in the upper half, the end in the lower one
    for (std::int64_t i = 0; i < n; ++i) {
        if (i % nodes_a_task == 0) progress.check();
        for (const std::int64_t j : near.of(i)) {
            if (!are_linked(graph, i, j)) continue;
            links.push_back(static_cast<std::uint64_t>(i) << 32U | static_cast<std::uint64_t>(j));
            links.push_back(static_cast<std::uint64_t>(j) << 32U | static_cast<std::uint64_t>(i));
        }
    }
    base::sort_long(links.begin(), links.end(), std::less<>(), progress); // equal ones are the same link
    links.resize(std::unique(links.begin(), links.end()) - links.begin());
    graph.first.resize(n + 1);
    for (const std::uint64_t link : links) {
        graph.neighbour.push_back(static_cast<std::int32_t>(link & 0xffffffffU));
        ++graph.first[static_cast<std::int64_t>(link >> 32U) + 1];
    }
    std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
}

// With L the links' Laplacian, a how sure the wanted lines q are, l the smoothing and h the spacing, this solves
// (L (l / h)^2 / 6 + a) z = a q, and then again with a term that pulls z to unit length.
base::Array<double> line_angles(const marks::Site& site, const SampleGraph& graph, const FieldSettings& settings,
                                const marks::DirectionFunction& function, const base::Progress& progress) {
    const base::Runtime& runtime = site.runtime;
    const Links links(runtime, graph, progress, [&](std::int64_t i, std::int32_t j) { return line_link(graph, i, j); });
    const Numbers wanted = wanted_lines(site, graph, links, settings, function, progress);
    const double length = settings.smoothing * settings.diagonal / graph.spacing;
    const double stiffness = length * length / 6.0;
    Numbers z(runtime.memory, graph.nodes());
    Numbers right(runtime.memory, graph.nodes());
    base::Array<double> diagonal(runtime.memory, graph.nodes());
    for (const double pull : {0.0, hatching_tuning.pull_to_unit, hatching_tuning.pull_to_unit}) {
        for_nodes(runtime, graph.nodes(), progress, [&](std::int64_t i) {
            const double size = std::abs(z[i]);
            right[i] = wanted[i] + (size > 0.0 ? pull / size * z[i] : Complex(0.0));
            diagonal[i] = std::abs(wanted[i]) + pull + 1e-6 + stiffness * links.count(i);
        });
        solve(runtime, {1e-4, 400}, links, diagonal, stiffness, right, z, progress);
    }
    base::Array<double> angle(runtime.memory, graph.nodes());
    for (std::int64_t i = 0; i < graph.nodes(); ++i) angle[i] = 0.5 * std::arg(z[i]);
    return angle;
}

} // namespace hrbfnpr::hatching
