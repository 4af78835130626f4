// SPDX-License-Identifier: MIT
// Complex numbers at the nodes of a graph, each seen from its neighbours through the links between them: lines of a
// field (as exp(2 i angle)) and waves (as exp(i phase)), at samples of the surface or at the vertices of a mesh.
// Sums are added up in one order, so that the bits do not depend on the number of threads.
#pragma once

#include "base/assert.h"
#include "base/memory.h"
#include "base/operation.h"
#include "base/runtime.h"

#include <cmath>
#include <complex>
#include <cstdint>

namespace hrbfnpr::hatching {

using Complex = std::complex<double>;
using Numbers = base::Array<Complex>; // one at each node

// The product of finite numbers. The operator of std::complex looks for NaN, which costs more than the product itself.
[[nodiscard]] inline Complex product(const Complex& a, const Complex& b) noexcept {
    return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}
// The magnitude of a number whose square can neither overflow nor underflow; std::abs takes care of both.
[[nodiscard]] inline double magnitude(const Complex& z) noexcept {
    return std::sqrt(z.real() * z.real() + z.imag() * z.imag());
}
[[nodiscard]] inline Complex to_unit(const Complex& z) noexcept {
    const double size = magnitude(z);
    return size > 0.0 ? z / size : z;
}

// Which nodes are linked: those from first[i] up to first[i + 1] are the neighbours of node i.
struct Graph {
    explicit Graph(base::Memory& memory) noexcept : first(memory), neighbour(memory) {}

    [[nodiscard]] std::int64_t nodes() const noexcept { return first.size() - 1; }

    base::Array<std::int64_t> first; // one more than there are nodes
    base::Array<std::int32_t> neighbour;
};

struct Link {
    Complex factor; // the number at the link's end, times this, is that number as seen from its begin
    std::int32_t to;
    float sense; // -1: the number is conjugated first, since the lines at both ends point to opposite ways; else 1
};

inline constexpr std::int64_t nodes_a_task = 2048;

// Calls visit(i) once for each node, concurrently.
template <class Visit>
void for_nodes(const base::Runtime& runtime, std::int64_t nodes, const base::Progress& progress, const Visit& visit) {
    runtime.parallel.for_chunks(nodes, nodes_a_task, progress, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) visit(i);
    });
}

class Links {
public:
    // The graph must outlive these. link_between(i, j): the link from node i to its neighbour j.
    template <class LinkBetween>
    Links(const base::Runtime& runtime, const Graph& graph, const base::Progress& progress,
          const LinkBetween& link_between)
        : graph_(graph), link_(runtime.memory) {
        link_.resize_for_overwrite(graph.neighbour.size());
        for_nodes(runtime, nodes(), progress, [&](std::int64_t i) {
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
    // The sum of the neighbours' numbers as seen from node i.
    [[nodiscard]] Complex around(std::int64_t i, const Numbers& z) const noexcept {
        Complex sum(0.0);
        for (std::int64_t k = graph_.first[i]; k < graph_.first[i + 1]; ++k) {
            const Link& link = link_[k];
            const Complex& there = z[link.to];
            sum += product(link.factor, {there.real(), static_cast<double>(link.sense) * there.imag()});
        }
        return sum;
    }
    // The mean over node i and its neighbours.
    [[nodiscard]] Complex mean(std::int64_t i, const Numbers& z) const noexcept {
        return (around(i, z) + z[i]) / (1.0 + count(i));
    }
    // Makes these the links of waves of half the period: along each link the phase grows by twice as much.
    void halve_period(const base::Runtime& runtime, const base::Progress& progress) {
        for_nodes(runtime, nodes(), progress, [&](std::int64_t i) {
            for (std::int64_t k = graph_.first[i]; k < graph_.first[i + 1]; ++k)
                link_[k].factor = product(link_[k].factor, link_[k].factor);
        });
    }

private:
    const Graph& graph_;
    base::Array<Link> link_;
};

// Replaces z by next(i, z) at all nodes at once, as many times as there are rounds.
template <class Next>
void iterate(const base::Runtime& runtime, int rounds, Numbers& z, const base::Progress& progress, const Next& next) {
    Numbers after(runtime.memory, z.size());
    for (int round = 0; round < rounds; ++round) {
        for_nodes(runtime, z.size(), progress, [&](std::int64_t i) { after[i] = next(i, z); });
        std::swap(after, z);
    }
}

struct SolverSettings {
    double tolerance = 0.0; // the norm of the residual that is small enough, as a share of the norm of the right side
    int most_steps = 0;
};

// Conjugate gradients for the system diagonal_i x_i - coupling * links.around(i, x) = right_i, which must be positive
// definite over the reals. x: the start, and the solution.
void solve(const base::Runtime& runtime, const SolverSettings& settings, const Links& links,
           const base::Array<double>& diagonal, double coupling, const Numbers& right, Numbers& x,
           const base::Progress& progress);

} // namespace hrbfnpr::hatching
