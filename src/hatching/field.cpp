// SPDX-License-Identifier: MIT
#include "hatching/field.h"

#include "base/random.h"
#include "base/sort.h"
#include "geometry/neighbours.h"
#include "geometry/point_grid.h"
#include "geometry/tangent_frame.h"
#include "hatching/power.h"
#include "hatching/tuning.h"
#include "surface/creased.h"
#include "surface/curvature.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace hrbfnpr::hatching {
namespace {

// Returns the magnitude of a number whose square neither overflows nor underflows. This is faster than std::abs, which
// handles these cases, too.
template <class Real>
[[nodiscard]] Real magnitude(const std::complex<Real>& z) noexcept {
    return std::sqrt(z.real() * z.real() + z.imag() * z.imag());
}
template <class Real>
[[nodiscard]] std::complex<Real> to_unit(const std::complex<Real>& z) noexcept {
    const Real size = magnitude(z);
    return size > Real(0) ? z / size : z;
}

// ---- Transport of numbers along links

struct Link {
    // the factor that transports the number of node `to` to the node where the link begins
    std::complex<float> factor;
    std::int32_t to;
    // 1 or -1. For -1 the number is conjugated first, because the lines of the two nodes point in opposite directions.
    float sense;
};

constexpr std::int64_t nodes_a_task = 2048;

// Calls visit(i) once for each node, in parallel.
template <class Visit>
void for_nodes(const base::Work& work, std::int64_t nodes, const Visit& visit) {
    work.for_chunks(nodes, nodes_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) visit(i);
    });
}

class Links {
public:
    // Makes the links of a graph, which must outlive them. link_between(i, j) returns the link from node i to its
    // neighbour j.
    template <class LinkBetween>
    Links(const base::Work& work, const Graph& graph, const LinkBetween& link_between)
        : graph_(graph), link_(work.memory) {
        link_.resize_for_overwrite(graph.neighbour.size());
        for_nodes(work, nodes(), [&](std::int64_t i) {
            for (std::int64_t k = graph.first[i]; k < graph.first[i + 1]; ++k) {
                HRBFNPR_ASSERT(graph.neighbour[k] >= 0 && graph.neighbour[k] < nodes());
                link_[k] = link_between(i, graph.neighbour[k]);
            }
        });
    }

    [[nodiscard]] std::int64_t nodes() const noexcept { return graph_.nodes(); }
    [[nodiscard]] double count(std::int64_t i) const noexcept {
        return static_cast<double>(graph_.first[i + 1] - graph_.first[i]);
    }
    // Returns the sum of the neighbours' numbers after their transport to node i.
    template <class Real>
    [[nodiscard]] std::complex<Real> neighbour_sum(std::int64_t i,
                                                   const base::Array<std::complex<Real>>& z) const noexcept {
        std::complex<Real> sum(0);
        for (std::int64_t k = graph_.first[i]; k < graph_.first[i + 1]; ++k) {
            const Link& link = link_[k];
            const std::complex<Real> there = z[link.to];
            sum += product(std::complex<Real>(link.factor), {there.real(), Real(link.sense) * there.imag()});
        }
        return sum;
    }
    // Returns the mean of the number of node i and its neighbours' numbers after their transport to node i.
    template <class Real>
    [[nodiscard]] std::complex<Real> mean(std::int64_t i, const base::Array<std::complex<Real>>& z) const noexcept {
        return (neighbour_sum(i, z) + z[i]) / Real(1.0 + count(i));
    }
    // Converts the links for waves of half the period: along each link, the phase grows by twice as much.
    void halve_period(const base::Work& work) {
        for_nodes(work, nodes(), [&](std::int64_t i) {
            for (std::int64_t k = graph_.first[i]; k < graph_.first[i + 1]; ++k)
                link_[k].factor = product(link_[k].factor, link_[k].factor);
        });
    }

private:
    const Graph& graph_;
    base::Array<Link> link_;
};

// Replaces z by next(i, z) at all nodes simultaneously. Repeats this `rounds` times.
template <class Number, class Next>
void iterate(const base::Work& work, int rounds, base::Array<Number>& z, const Next& next) {
    base::Array<Number> after(work.memory, z.size());
    for (int round = 0; round < rounds; ++round) {
        for_nodes(work, z.size(), [&](std::int64_t i) { after[i] = next(i, z); });
        std::swap(after, z);
    }
}

// Averages waves with their neighbours, and scales them to unit magnitude.
void average_units(const base::Work& work, const Links& links, int rounds, Wave& z) {
    iterate(work, rounds, z,
            [&](std::int64_t i, const Wave& now) { return to_unit(links.neighbour_sum(i, now) + now[i]); });
}

// Sets the numbers of all nodes except the first `known` ones to means of their neighbours, scaled to unit magnitude.
template <class Real>
void fill_in(const base::Work& work, const Links& links, std::int64_t known, base::Array<std::complex<Real>>& z) {
    if (known == z.size()) return;
    iterate(work, hatching_tuning.fill_rounds, z, [&](std::int64_t i, const base::Array<std::complex<Real>>& now) {
        return i < known ? now[i] : to_unit(links.neighbour_sum(i, now) + now[i]);
    });
}

// Returns the sum of value(i) over all nodes. It is summed within each task, then over the tasks in order, so the
// result does not depend on the number of threads.
template <class Value>
double sum_over(const base::Work& work, std::int64_t nodes, const Value& value) {
    base::Array<double> part(work.memory, (nodes + nodes_a_task - 1) / nodes_a_task);
    work.for_chunks(nodes, nodes_a_task, [&](std::int64_t begin, std::int64_t end) {
        double sum = 0.0;
        for (std::int64_t i = begin; i < end; ++i) sum += value(i);
        part[begin / nodes_a_task] = sum;
    });
    double all = 0.0;
    for (const double sum : part) all += sum;
    return all;
}

// Returns the real part of conj(a) b.
double inner_product(const Complex& a, const Complex& b) noexcept { return a.real() * b.real() + a.imag() * b.imag(); }

// Solves the system diagonal_i x_i - coupling * links.around(i, x) = right_i by conjugate gradients. The system must be
// positive definite over the reals. x is the start and becomes the solution. The iteration ends when the norm of the
// residual is at most `tolerance` times that of the right side.
void solve(const base::Work& work, double tolerance, int most_steps, const Links& links,
           const base::Array<double>& diagonal, double coupling, const Numbers& right, Numbers& x) {
    const std::int64_t n = right.size();
    HRBFNPR_ASSERT(links.nodes() == n && diagonal.size() == n && x.size() == n);
    HRBFNPR_ASSERT(coupling >= 0.0 && tolerance > 0.0);
    const auto row = [&](std::int64_t i, const Numbers& z) {
        return diagonal[i] * z[i] - coupling * links.neighbour_sum(i, z);
    };
    const auto sum = [&](const auto& value) { return sum_over(work, n, value); };
    Numbers residual(work.memory, n);
    Numbers way(work.memory, n);
    Numbers image(work.memory, n);
    double squared = sum([&](std::int64_t i) {
        way[i] = residual[i] = right[i] - row(i, x);
        return inner_product(residual[i], residual[i]);
    });
    const double limit = tolerance * tolerance * sum([&](std::int64_t i) { return inner_product(right[i], right[i]); });
    for (int step = 0; step < most_steps && squared > limit; ++step) {
        const double bend = sum([&](std::int64_t i) {
            image[i] = row(i, way);
            return inner_product(way[i], image[i]);
        });
        const double share = squared / bend;
        const double next = sum([&](std::int64_t i) {
            x[i] += share * way[i];
            residual[i] -= share * image[i];
            return inner_product(residual[i], residual[i]);
        });
        const double kept = next / squared;
        for_nodes(work, n, [&](std::int64_t i) { way[i] = residual[i] + kept * way[i]; });
        squared = next;
    }
}

// ---- The graph

bool are_linked(const SampleGraph& graph, double spacing, std::int64_t i, std::int64_t j) noexcept {
    const glm::dvec3 a = graph.normal[i];
    const glm::dvec3 b = graph.normal[j];
    const glm::dvec3 way = graph.position[j] - graph.position[i];
    const double length = glm::length(way);
    if (!(length > 0.0 && length <= hatching_tuning.farthest_link * spacing)) return false;
    if (!(glm::dot(a, b) > hatching_tuning.same_sheet_cosine)) return false;
    if (!graph.sheet.empty() && surface::is_creased(graph.sheet[i], graph.sheet[j], a, b)) return false;
    const double steepest = hatching_tuning.steepest_link * length;
    return std::abs(glm::dot(way, a)) <= steepest && std::abs(glm::dot(way, b)) <= steepest;
}

// Returns the number of samples whose spacing is at most `spacing`.
std::int64_t samples_with_spacing(const SampleGraph& graph, double spacing) noexcept {
    const std::int64_t all = graph.position.size();
    const double share = std::pow(graph.spacing / spacing, 2.0);
    const auto count = static_cast<std::int64_t>(std::ceil(std::min(share, 1.0) * static_cast<double>(all)));
    return std::clamp(count, std::min(all, hatching_tuning.fewest_coarse), all);
}

// Links the first `count` samples with each other.
Graph link_first(const base::Work& work, const SampleGraph& samples, std::int64_t count) {
    const double spacing =
        samples.spacing * std::sqrt(static_cast<double>(samples.position.size()) / static_cast<double>(count));
    geometry::VecArray position(work.memory, count);
    for (std::int64_t i = 0; i < count; ++i) position.set(i, samples.position[i]);
    const geometry::Neighbours near(work.runtime().parallel, position, hatching_tuning.neighbours, work);
    // Each number has the index of a start node in its upper 32 bits, and of an end node in its lower 32 bits.
    base::Array<std::uint64_t> links(work.memory);
    for (const std::int64_t i : work.over(count)) {
        for (const std::int64_t j : near.of(i)) {
            if (!are_linked(samples, spacing, i, j)) continue;
            links.push_back(static_cast<std::uint64_t>(i) << 32U | static_cast<std::uint64_t>(j));
            links.push_back(static_cast<std::uint64_t>(j) << 32U | static_cast<std::uint64_t>(i));
        }
    }
    base::sort_long(links.begin(), links.end(), std::less<>(), work); // Equal numbers are the same link, found twice.
    links.resize(std::unique(links.begin(), links.end()) - links.begin());
    Graph graph(work.memory);
    graph.first.resize(count + 1);
    for (const std::uint64_t link : links) {
        graph.neighbour.push_back(static_cast<std::int32_t>(link & 0xffffffffU));
        ++graph.first[static_cast<std::int64_t>(link >> 32U) + 1];
    }
    std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
    return graph;
}

// Returns the link that transports the line of sample j, exp(2 i angle) in its frame, to sample i. It uses the smallest
// rotation that turns one normal into the other.
Link line_link(const SampleGraph& graph, std::int64_t i, std::int32_t j) noexcept {
    const glm::dvec3 a = graph.normal[i];
    const glm::dvec3 b = graph.normal[j];
    const glm::dvec3 t = graph.u[i];
    const glm::dvec3 axis = glm::cross(a, b);
    const double cosine = glm::dot(a, b);
    const glm::dvec3 carried = t * cosine + glm::cross(axis, t) + axis * (glm::dot(axis, t) / (1.0 + cosine));
    return {std::complex<float>(std::polar(1.0, -2.0 * graph.angle(j, carried))), j, 1.0F};
}

// ---- The lines that the field should follow

// The principal curvatures at each sample: their mean, and half of their difference as a line.
struct AveragedCurvatures {
    base::Array<double> mean;
    Numbers difference;
};

// Averages curvatures with those of neighbours. Each round spreads them by about half a spacing, and all rounds
// together by about four spacings.
AveragedCurvatures average_curvatures(const marks::Site& site, const SampleGraph& graph, const Links& links) {
    base::Array<surface::Curvature> curvature(site.memory());
    surface::principal_curvatures(site.work, site.implicit, graph.position, curvature);
    AveragedCurvatures averaged{base::Array<double>(site.memory(), graph.nodes()),
                                Numbers(site.memory(), graph.nodes())};
    Numbers means(site.memory(), graph.nodes());
    const double sharpest = 4.0 / graph.spacing; // Samples cannot represent larger curvatures.
    for (std::int64_t i = 0; i < graph.nodes(); ++i) {
        const surface::Curvature& c = curvature[i];
        const double k1 = std::clamp(c.k1, -sharpest, sharpest);
        const double k2 = std::clamp(c.k2, -sharpest, sharpest);
        averaged.mean[i] = 0.5 * (k1 + k2);
        averaged.difference[i] = 0.5 * (k1 - k2) * std::polar(1.0, 2.0 * graph.angle(i, c.d1));
    }
    base::Array<double> next(site.memory(), graph.nodes());
    for (int round = 0; round < hatching_tuning.curvature_averages; ++round) {
        for_nodes(site.work, graph.nodes(), [&](std::int64_t i) {
            next[i] = averaged.mean[i];
            for (std::int64_t k = graph.first[i]; k < graph.first[i + 1]; ++k)
                next[i] += averaged.mean[graph.neighbour[k]];
            next[i] /= 1.0 + links.count(i);
        });
        std::swap(next, averaged.mean);
    }
    iterate(site.work, hatching_tuning.curvature_averages, averaged.difference,
            [&](std::int64_t i, const Numbers& z) { return links.mean(i, z); });
    return averaged;
}

// Returns a tangent as a complex number in the frame of sample i.
Complex in_frame(const SampleGraph& graph, std::int64_t i, const glm::dvec3& v) noexcept {
    return {glm::dot(v, graph.u[i]), glm::dot(v, glm::cross(graph.normal[i], graph.u[i]))};
}

// Returns the line for Guide::silhouette. The line is conjugate to the tangent part of the direction to the eye:
// II(view, line) = 0. The tangent of a contour has this property, too. Where the surface faces the eye, the weight of
// the line is small. [Hertzmann & Zorin 2000]
Complex silhouette_line(double mean, const Complex& difference, const Complex& view, double diagonal) noexcept {
    // The direction to the eye, transformed by the shape operator.
    const Complex turned = mean * view + difference * std::conj(view);
    const double size = std::abs(turned);
    if (!(size > 0.0)) return Complex(0.0);
    const double sure = std::min(1.0, hatching_tuning.full_radius * diagonal * size / std::abs(view));
    const Complex line = Complex(0.0, 1.0) * turned / size;
    return sure * std::norm(view) * std::norm(view) * line * line;
}

Complex guide_line(const SampleGraph& graph, std::int64_t i, const AveragedCurvatures& averaged,
                   const FieldSettings& settings) noexcept {
    const glm::dvec3 n = graph.normal[i];
    Complex line(0.0);
    switch (settings.guide) {
    case Guide::curvature: break;
    case Guide::combing:
        line = in_frame(graph, i, geometry::combing_frame(n).r);
        return geometry::combing_confidence(n) * line * line;
    case Guide::sections: line = in_frame(graph, i, glm::cross(settings.axis, n)); break;
    case Guide::light: line = in_frame(graph, i, settings.guide_direction); break;
    case Guide::silhouette:
        return silhouette_line(averaged.mean[i], averaged.difference[i], in_frame(graph, i, settings.guide_direction),
                               settings.diagonal);
    }
    return line * line;
}

// Returns the line that runs around the axis. Its weight is proportional to the squared sine of the angle between the
// axis and the normal, so it is 0 on a flat face perpendicular to the axis. If such a face ends at creases, its
// neighbours cannot give it a direction either, so another axis is added.
Complex axis_line(const SampleGraph& graph, std::int64_t i, const FieldSettings& settings,
                  const Complex& wanted) noexcept {
    const auto around = [&](const glm::dvec3& axis, double weight) {
        const glm::dvec3 line = glm::cross(axis, graph.normal[i]);
        return weight * glm::dot(line, line) * std::polar(1.0, 2.0 * graph.angle(i, line));
    };
    const Complex line = around(settings.axis, settings.axis_weight);
    if (graph.sheet.empty() || std::abs(wanted + line) >= hatching_tuning.least_confidence) return line;
    const glm::dvec3 size = glm::abs(settings.axis);
    const glm::dvec3 other = size.x <= size.y && size.x <= size.z ? glm::dvec3(1.0, 0.0, 0.0)
                             : size.y <= size.z                   ? glm::dvec3(0.0, 1.0, 0.0)
                                                                  : glm::dvec3(0.0, 0.0, 1.0);
    return line + around(other, hatching_tuning.least_confidence);
}

Numbers target_lines(const marks::Site& site, const SampleGraph& graph, const Links& links,
                     const FieldSettings& settings, const marks::DirectionFunction& function) {
    Numbers wanted(site.memory(), graph.nodes());
    if (function.function != nullptr) {
        geometry::VecArray direction(site.memory(), graph.nodes());
        marks::directions_at(site, function, graph.position, graph.normal, direction);
        for (std::int64_t i = 0; i < graph.nodes(); ++i)
            if (const glm::dvec3 d = direction[i]; glm::dot(d, d) > 0.5)
                wanted[i] = std::polar(1.0, 2.0 * graph.angle(i, d));
        return wanted;
    }
    const AveragedCurvatures averaged = average_curvatures(site, graph, links);
    const double weight = settings.guide == Guide::curvature ? 0.0 : settings.guide_weight;
    for (std::int64_t i = 0; i < graph.nodes(); ++i) {
        wanted[i] = curvature_line(averaged.mean[i], averaged.difference[i], settings.diagonal);
        if (weight > 0.0)
            wanted[i] = (1.0 - weight) * wanted[i] +
                        weight * hatching_tuning.guide_strength * guide_line(graph, i, averaged, settings);
        wanted[i] += axis_line(graph, i, settings, wanted[i]);
    }
    return wanted;
}

// ---- Waves

Links wave_links(const base::Work& work, const Graph& graph, const Waves& waves, double period) {
    return {work, graph, [&](std::int64_t i, std::int32_t j) -> Link {
                return {std::polar(1.0F, static_cast<float>(-waves.growth(i, j, period))), j,
                        waves.turned(i, j) ? -1.0F : 1.0F};
            }};
}

// Returns the wave on which neighbours agree most: the eigenvector of the smallest eigenvalue, by inverse iteration.
// The eigenvector is large only in a few places, but its phase is correct elsewhere, too. Each step enlarges the vector
// by at most the factor 1 / eigen_shift, so it cannot overflow.
Numbers first_wave(const base::Work& work, const Links& links, std::uint64_t seed) {
    const std::int64_t n = links.nodes();
    base::Array<double> diagonal(work.memory, n);
    Numbers x(work.memory, n);
    for (std::int64_t i = 0; i < n; ++i) {
        diagonal[i] = links.count(i) + hatching_tuning.eigen_shift;
        x[i] = std::polar(1.0, tau * base::uniform4(seed, static_cast<std::uint64_t>(i), base::Purpose::stripes)[0]);
    }
    Numbers next(work.memory, n);
    for (int step = 0; step < hatching_tuning.eigen_steps; ++step) {
        for_nodes(work, n, [&](std::int64_t i) { next[i] = x[i] / hatching_tuning.eigen_shift; });
        solve(work, 1e-3, 200, links, diagonal, 1.0, x, next);
        std::swap(x, next);
    }
    return x;
}

// Returns a wave of half the period: its phase is twice as large. Plain means make the wave small where it is squeezed
// or stretched. Waves of the correct length then grow into these places from their surroundings, and a fork of two
// lines becomes two forks. Waves of unit height could not do this, and lines would stay too dense or too sparse.
Wave halved(const base::Work& work, const Links& links, const Wave& wave, int means, int unit_means) {
    HRBFNPR_ASSERT(links.nodes() == wave.size());
    Wave z(work.memory, wave.size());
    for_nodes(work, z.size(), [&](std::int64_t i) { z[i] = to_unit(product(wave[i], wave[i])); });
    apply_power(work, means, hatching_tuning.walk_deviations, z,
                [&](std::int64_t i, const Wave& now) { return links.mean(i, now); });
    average_units(work, links, unit_means, z);
    return z;
}

// A sample that influences a vertex of the mesh.
struct WeightedSample {
    std::int64_t sample;
    float weight;
    bool turned = false;
    std::complex<float> factor{1.0F}; // the factor that transports the wave of the sample to the vertex
};

// Returns the unit line of a vertex as a mean of the lines of nearby samples, or 0 if the vertex has no line. Angles
// are doubled before they are added, because lines have no sign.
glm::dvec3 mean_line(const Waves& samples, const base::Array<WeightedSample>& nearby,
                     const glm::dvec3& normal) noexcept {
    const glm::dvec3 u = geometry::any_perpendicular(normal);
    const glm::dvec3 v = glm::cross(normal, u);
    Complex sum(0.0);
    double weights = 0.0;
    for (const WeightedSample& h : nearby) {
        const glm::dvec3 t = samples.along[h.sample];
        const Complex z(glm::dot(t, u), glm::dot(t, v));
        const auto weight = static_cast<double>(h.weight);
        sum += weight * product(z, z);
        weights += weight;
    }
    if (!(magnitude(sum) > 1e-3 * weights)) return glm::dvec3(0.0);
    const double angle = 0.5 * std::arg(sum);
    return std::cos(angle) * u + std::sin(angle) * v;
}

// Interpolates the line of a vertex, and its waves, from the samples around it.
void interpolate(const Waves& samples, base::Array<WeightedSample>& nearby, const glm::dvec3& normal,
                 std::int64_t vertex, Waves& result) noexcept {
    const glm::dvec3 line = mean_line(samples, nearby, normal);
    if (glm::dot(line, line) == 0.0) return;
    result.set_line(vertex, normal, line);
    float weights = 0.0F;
    for (WeightedSample& h : nearby) {
        const glm::dvec3 there = samples.across[h.sample];
        h.turned = glm::dot(line, samples.along[h.sample]) < 0.0;
        const glm::dvec3 mean = 0.5 * (result.across[vertex] + (h.turned ? -there : there));
        const glm::dvec3 way = result.position[vertex] - samples.position[h.sample];
        h.factor = std::polar(1.0F, static_cast<float>(tau / samples.period * glm::dot(way, mean)));
        weights += h.weight;
    }
    for (std::int64_t level = 0; level < samples.level.size(); ++level) {
        std::complex<float> sum(0.0F);
        for (WeightedSample& h : nearby) {
            // Each level has half the period of the previous level.
            if (level > 0) h.factor = product(h.factor, h.factor);
            sum += h.weight * product(h.factor, conjugated_if(samples.level[level][h.sample], h.turned));
        }
        result.level[level][vertex] = sum / weights;
    }
}

Waves interpolated(const base::Work& work, const SampleGraph& graph, const Waves& samples,
                   const base::Array<std::uint8_t>& needed, const curves::SurfaceMesh& mesh,
                   const base::Array<std::int32_t>& sheets) {
    Waves result(work.memory, mesh.position, samples.period);
    for (std::int64_t level = 0; level < samples.level.size(); ++level) result.level.add(work.memory, mesh.vertices());
    const double radius = hatching_tuning.sample_reach * graph.spacing;
    const geometry::PointGrid grid(graph.position, radius, work);
    const geometry::VecArray places = grid.in_order(graph.position, work);
    work.for_chunks(mesh.vertices(), nodes_a_task, [&](std::int64_t begin, std::int64_t end) {
        base::Array<WeightedSample> nearby(work.memory);
        for (const std::int64_t v : work.over(begin, end)) {
            const glm::dvec3 p = mesh.position[v];
            const glm::dvec3 n = glm::normalize(mesh.gradient[v]);
            nearby.clear();
            bool is_needed = needed.empty();
            grid.around(p, [&](std::int64_t at) {
                const glm::dvec3 way = p - places[at];
                const double squared = glm::dot(way, way);
                if (!(squared < radius * radius)) return;
                const std::int64_t i = grid.index(at);
                const glm::dvec3 there = graph.normal[i];
                if (!(glm::dot(there, n) > hatching_tuning.same_sheet_cosine)) return;
                if (!sheets.empty() && surface::is_creased(sheets[v], graph.sheet[i], n, there)) return;
                const double height = glm::dot(way, n);
                if (height * height > hatching_tuning.steepest_offset * hatching_tuning.steepest_offset * squared)
                    return;
                is_needed = is_needed || needed[i] != 0;
                const double rest = 1.0 - squared / (radius * radius);
                nearby.push_back({i, static_cast<float>(rest * rest)});
            });
            if (is_needed) interpolate(samples, nearby, n, v, result);
        }
    });
    return result;
}

// Makes the graph of those edges of a mesh whose ends have lines. The two ends of an inner edge are neighbours of each
// other. A border edge is listed once in the mesh, so only its start has its end as a neighbour.
Graph graph_of(base::Memory& memory, const curves::SurfaceMesh& mesh, const Waves& waves) {
    base::Array<std::uint8_t> has_line(memory, mesh.vertices());
    for (std::int64_t v = 0; v < mesh.vertices(); ++v) has_line[v] = waves.has_line(v) ? 1 : 0;
    const auto end_of = [&](std::int64_t edge) { return mesh.corner[edge - edge % 3 + (edge % 3 + 1) % 3]; };
    const auto is_link = [&](std::int64_t edge) {
        return has_line[mesh.corner[edge]] != 0 && has_line[end_of(edge)] != 0;
    };
    Graph graph(memory);
    graph.first.resize(mesh.vertices() + 1);
    for (std::int64_t edge = 0; edge < mesh.corner.size(); ++edge)
        if (is_link(edge)) ++graph.first[mesh.corner[edge]];
    std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
    graph.neighbour.resize(graph.first[mesh.vertices()]);
    for (std::int64_t edge = mesh.corner.size() - 1; edge >= 0; --edge)
        if (is_link(edge)) graph.neighbour[--graph.first[mesh.corner[edge]]] = end_of(edge);
    return graph;
}

} // namespace

Complex curvature_line(double mean, const Complex& difference, double diagonal) noexcept {
    const double apart = std::abs(difference);
    if (!(apart > 0.0)) return Complex(0.0);
    const double k1 = std::abs(mean + apart);
    const double k2 = std::abs(mean - apart);
    const double bend = diagonal * std::max(k1, k2);
    const double sure = std::pow((k1 - k2) / (k1 + k2), 2.0) * std::min(1.0, hatching_tuning.full_radius * bend) *
                        std::clamp(bend / hatching_tuning.flat_curvature - 1.0, 0.0, 1.0);
    return (k1 >= k2 ? sure : -sure) / apart * difference;
}

void link_samples(const base::Work& work, SampleGraph& graph) {
    const std::int64_t n = graph.position.size();
    HRBFNPR_ASSERT(graph.normal.size() == n && (graph.sheet.empty() || graph.sheet.size() == n));
    HRBFNPR_ASSERT(graph.spacing > 0.0 || n == 0);
    graph.u.resize(n);
    for (std::int64_t i = 0; i < n; ++i) graph.u.set(i, geometry::any_perpendicular(graph.normal[i]));
    static_cast<Graph&>(graph) = link_first(work, graph, n);
}

// L is the Laplacian of the links, q the wanted lines, a their confidence, l the smoothing length and h the spacing.
// This solves (L (l / h)^2 / 6 + a) z = a q, and then twice more, with a term that pulls z to unit length. The lines do
// not change much within the smoothing length, so the system has only the first samples, and the others are filled in.
base::Array<double> line_angles(const marks::Site& site, const SampleGraph& graph, const FieldSettings& settings,
                                const marks::DirectionFunction& function) {
    const base::Work& work = site.work;
    const auto line_between = [&](std::int64_t i, std::int32_t j) { return line_link(graph, i, j); };
    const Links all_links(work, graph, line_between);
    const Numbers wanted = target_lines(site, graph, all_links, settings, function);
    const double smoothing = settings.smoothing * settings.diagonal;
    const std::int64_t count = samples_with_spacing(graph, hatching_tuning.field_spacing * smoothing);
    const Graph coarse = link_first(work, graph, count);
    const Links links(work, coarse, line_between);
    const double stiffness = std::pow(smoothing / graph.spacing, 2.0) / 6.0 * static_cast<double>(count) /
                             static_cast<double>(graph.nodes());
    Numbers z(work.memory, count);
    Numbers right(work.memory, count);
    base::Array<double> diagonal(work.memory, count);
    for (const double pull : {0.0, hatching_tuning.pull_to_unit, hatching_tuning.pull_to_unit}) {
        for_nodes(work, count, [&](std::int64_t i) {
            const double size = std::abs(z[i]);
            right[i] = wanted[i] + (size > 0.0 ? pull / size * z[i] : Complex(0.0));
            diagonal[i] = std::abs(wanted[i]) + pull + 1e-6 + stiffness * links.count(i);
        });
        solve(work, 1e-4, 400, links, diagonal, stiffness, right, z);
    }
    z.resize(graph.nodes());
    fill_in(work, all_links, count, z);
    base::Array<double> angle(work.memory, graph.nodes());
    for (std::int64_t i = 0; i < graph.nodes(); ++i) angle[i] = 0.5 * std::arg(z[i]);
    return angle;
}

void add_sample_waves(const base::Work& work, const SampleGraph& graph, std::uint64_t seed, int levels,
                      Waves& samples) {
    HRBFNPR_ASSERT(samples.along.size() == graph.nodes() && samples.level.empty() && samples.period > 0.0);
    const std::int64_t count = samples_with_spacing(graph, hatching_tuning.first_spacing * samples.period);
    const Graph coarse = link_first(work, graph, count);
    const Numbers first = first_wave(work, wave_links(work, coarse, samples, samples.period), seed);
    Links links = wave_links(work, graph, samples, samples.period);
    Wave wave(work.memory, graph.nodes());
    for (std::int64_t i = 0; i < count; ++i) wave[i] = std::complex<float>(to_unit(first[i]));
    fill_in(work, links, count, wave);
    average_units(work, links, hatching_tuning.unit_averages, wave);
    samples.level.add(std::move(wave));
    const double finest = hatching_tuning.finest_period * graph.spacing;
    while (samples.finest() < levels && samples.period_of(samples.finest() + 1) >= finest) {
        links.halve_period(work);
        samples.level.add(
            halved(work, links, samples.level.back(), hatching_tuning.sample_means, hatching_tuning.unit_averages));
    }
}

Waves waves_at_vertices(const base::Work& work, const SampleGraph& graph, const Waves& samples,
                        const base::Array<std::uint8_t>& needed, const curves::SurfaceMesh& mesh,
                        const base::Array<std::int32_t>& sheets, int levels) {
    HRBFNPR_ASSERT(!samples.level.empty());
    HRBFNPR_ASSERT(sheets.empty() || (sheets.size() == mesh.vertices() && graph.sheet.size() == graph.nodes()));
    Waves waves = interpolated(work.part(0.0, 0.5), graph, samples, needed, mesh, sheets);
    const auto is_next_known = [&] {
        return waves.period_of(waves.finest() + 1) >= hatching_tuning.finest_on_mesh * mesh.side;
    };
    if (waves.finest() >= levels || !is_next_known()) return waves;
    const Graph edges = graph_of(work.memory, mesh, waves);
    Links links = wave_links(work, edges, waves, waves.period_of(waves.finest()));
    while (waves.finest() < levels && is_next_known()) {
        links.halve_period(work);
        waves.level.add(
            halved(work, links, waves.level.back(), hatching_tuning.vertex_means, hatching_tuning.vertex_averages));
    }
    return waves;
}

} // namespace hrbfnpr::hatching
