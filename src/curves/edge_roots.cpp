// SPDX-License-Identifier: MIT
#include "curves/edge_roots.h"

#include "geometry/long_vec_array.h"
#include "implicit/evaluate_all.h"
#include "surface/project.h"

#include <array>
#include <atomic>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

constexpr auto lanes = static_cast<std::size_t>(implicit::batch_size);
using RootColumn = std::array<double, lanes>;

constexpr int evaluation_limit = 60;
constexpr int trusted_root_steps = 6;        // after these every other step halves the bracket
constexpr std::int64_t edges_a_look = 65536; // without a look for a cancel

// An edge in its own coordinate, from 0 to 1, and the bracket of its root.
struct RootSearch {
    glm::dvec3 from{0.0}, along{0.0};
    double low = 0.0, high = 1.0;
    double low_value = 0.0, high_value = 0.0;
    double at = 0.0;
    std::int64_t index = 0;
    int evaluations = 0;
};

// The root of the cubic that has the bracket's values and, at the last place, f and its slope: by Newton from there.
double root_of_cubic(const RootSearch& search, double value, double slope) noexcept {
    const double x = search.low - search.at;
    const double y = search.high - search.at;
    const double at_x = (search.low_value - value - slope * x) / (x * x);
    const double at_y = (search.high_value - value - slope * y) / (y * y);
    const double third = (at_y - at_x) / (y - x);
    const double second = at_x - third * x;
    double t = -value / slope;
    for (int step = 0; step < 3; ++step) {
        const double p = value + t * (slope + t * (second + t * third));
        const double dp = slope + t * (2.0 * second + t * 3.0 * third);
        t -= p / dp;
    }
    return search.at + t;
}

class Batch {
public:
    Batch(const implicit::Implicit& implicit, double tolerance, geometry::VecArray& position,
          geometry::VecArray& gradient) noexcept
        : implicit_(implicit), tolerance_(tolerance), position_(position), gradient_(gradient) {}

    // order: of the edges, or null for their own.  Returns how many have no root found.
    std::int64_t run(const CrossedEdges& edges, const std::int32_t* order, std::int64_t begin, std::int64_t end,
                     const base::Progress& progress);

private:
    void evaluate() noexcept(false);
    [[nodiscard]] bool goes_on(RootSearch& search, double value, const glm::dvec3& gradient) noexcept;
    void end_with(const RootSearch& search, const glm::dvec3& gradient) noexcept;

    const implicit::Implicit& implicit_;
    double tolerance_;
    geometry::VecArray& position_;
    geometry::VecArray& gradient_;
    std::int64_t unresolved_ = 0;
    std::size_t count_ = 0; // of the edges that are still searched, packed
    std::array<RootSearch, lanes> search_;
    RootColumn x_, y_, z_, f_, gx_, gy_, gz_;
};

RootSearch start(const CrossedEdges& edges, std::int64_t index) noexcept {
    const CrossedEdges::Edge edge = edges.edge[index];
    RootSearch search;
    search.from = edges.position[edge.from];
    search.along = edges.position[edge.to] - search.from;
    search.low_value = edges.value[edge.from];
    search.high_value = edges.value[edge.to];
    search.at = search.low_value / (search.low_value - search.high_value);
    if (!(search.at > 0.0 && search.at < 1.0)) search.at = 0.5;
    search.index = index;
    return search;
}

void Batch::evaluate() noexcept(false) {
    for (std::size_t i = 0; i < count_; ++i) {
        const glm::dvec3 p = search_[i].from + search_[i].at * search_[i].along;
        x_[i] = p.x;
        y_[i] = p.y;
        z_[i] = p.z;
    }
    implicit_.evaluate({x_.data(), y_.data(), z_.data(), static_cast<std::int64_t>(count_)},
                       {f_.data(), {gx_.data(), gy_.data(), gz_.data()}, {}});
}

void Batch::end_with(const RootSearch& search, const glm::dvec3& gradient) noexcept {
    position_.set(search.index, search.from + search.at * search.along);
    gradient_.set(search.index, surface::is_slope(glm::length(gradient)) ? gradient : glm::dvec3(0.0));
}

bool Batch::goes_on(RootSearch& search, double value, const glm::dvec3& gradient) noexcept {
    const double slope = glm::length(gradient);
    const bool usable = std::isfinite(value) && std::isfinite(slope);
    const bool there = usable && surface::is_slope(slope) && std::abs(value) <= tolerance_ * slope;
    if (there || !usable || ++search.evaluations == evaluation_limit) {
        if (!there) ++unresolved_;
        end_with(search, gradient);
        return false;
    }
    const double next = root_of_cubic(search, value, glm::dot(gradient, search.along));
    const bool low_side = (value < 0.0) == (search.low_value < 0.0);
    (low_side ? search.low : search.high) = search.at;
    (low_side ? search.low_value : search.high_value) = value;
    const bool halve = search.evaluations > trusted_root_steps && search.evaluations % 2 == 0;
    const bool within = next > search.low && next < search.high;
    search.at = within && !halve ? next : 0.5 * (search.low + search.high);
    return true;
}

std::int64_t Batch::run(const CrossedEdges& edges, const std::int32_t* order, std::int64_t begin, std::int64_t end,
                        const base::Progress& progress) {
    count_ = static_cast<std::size_t>(end - begin);
    for (std::size_t i = 0; i < count_; ++i) {
        const std::int64_t at = begin + static_cast<std::int64_t>(i);
        search_[i] = start(edges, order != nullptr ? order[at] : at);
    }
    while (count_ > 0) {
        progress.check();
        evaluate();
        std::size_t kept = 0;
        for (std::size_t i = 0; i < count_; ++i)
            if (goes_on(search_[i], f_[i], {gx_[i], gy_[i], gz_[i]})) search_[kept++] = search_[i];
        count_ = kept;
    }
    return unresolved_;
}

} // namespace

std::int64_t find_edge_roots(const base::Runtime& runtime, const implicit::Implicit& implicit,
                             const CrossedEdges& edges, double tolerance, geometry::VecArray& position,
                             geometry::VecArray& gradient, const base::Progress& progress) {
    const std::int64_t count = edges.edge.size();
    resize_long(position, count, progress);
    resize_long(gradient, count, progress);
    for (std::int64_t i = 0; i < count; ++i) {
        if (i % edges_a_look == 0) progress.check();
        position.set(i, 0.5 * (edges.position[edges.edge[i].from] + edges.position[edges.edge[i].to]));
    }
    const base::Array<std::int32_t> order = implicit::order_by_cell(runtime, implicit, position, progress);
    std::atomic<std::int64_t> unresolved{0};
    std::atomic<std::int64_t> done{0};
    const auto run = [&](std::int64_t begin, std::int64_t end) {
        base::Boxed<Batch> batch(runtime.memory, implicit, tolerance, position, gradient);
        unresolved += batch->run(edges, order.data(), begin, end, progress);
        progress.update(static_cast<double>(done += end - begin) / static_cast<double>(count));
    };
    implicit.threads(runtime.parallel).for_chunks(count, implicit::batch_size, run);
    return unresolved;
}

} // namespace hrbfnpr::curves
