// SPDX-License-Identifier: MIT
// The steps of the search are:
//
//   starts             directions to begin with: planes of near and far neighbours, rays from the middle, given normals
//   find_signs         (signs.h) finds signs by the energy
//   descend            finds directions by the energy: limited-memory BFGS on the product of the normals' spheres
//   agreement          compares the signs of the best result with those of other results of about the same energy
#include "orient/least_energy.h"

#include "base/assert.h"
#include "base/sort.h"
#include "orient/signs.h"
#include "orient/tuning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <tuple>
#include <utility>
#include <vector>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

// ---- Directions

// Limited-memory BFGS (Nocedal 1980) on a product of spheres, scaled by the stiffness of the energy at each normal.
class Descent {
public:
    Descent(const base::Work& work, fit::HermiteEnergy& energy, const base::Array<double>& stiffness, VecArray& normal)
        : runtime_(work), energy_(energy), stiffness_(stiffness), normal_(normal), progress_(work),
          size_(normal.size()), gradient_(work.memory, size_), next_(work.memory, size_),
          next_gradient_(work.memory, size_), direction_(work.memory, size_),
          part_(work.memory, (size_ + places_a_sum - 1) / places_a_sum) {
        HRBFNPR_ASSERT(stiffness.size() == size_ && energy.size() == size_);
        for (int k = 0; k < most_pairs; ++k) {
            step_.emplace_back(work.memory, size_);
            change_.emplace_back(work.memory, size_);
        }
        value_ = evaluate(normal_, gradient_);
    }

    [[nodiscard]] double value() const noexcept { return value_; }

    // Returns false if no step lowers the energy.
    bool step() {
        find_direction();
        double slope = dot(direction_, gradient_);
        if (!(slope < 0.0)) {
            pairs_ = 0;
            find_direction();
            slope = dot(direction_, gradient_);
            if (!(slope < 0.0)) return false;
        }
        double length = std::min(1.0, tuning.longest_turn / largest(direction_));
        for (int halving = 0; halving < tuning.step_halvings; ++halving, length *= 0.5) {
            for_all([&](std::int64_t i) { next_.set(i, glm::normalize(normal_[i] + length * direction_[i])); });
            const double value = evaluate(next_, next_gradient_);
            if (!(value <= value_ + tuning.armijo * length * slope)) continue;
            remember();
            value_ = value;
            return true;
        }
        if (pairs_ == 0) return false;
        pairs_ = 0; // The remembered pairs give a direction that does not lower the energy, so they are forgotten.
        return true;
    }

private:
    static constexpr int most_pairs = tuning.curvature_pairs;
    static constexpr std::int64_t places_a_sum = 4096;

    template <class F>
    void for_all(F&& f) const {
        for_places(base::Work(runtime_, progress_), size_, f);
    }

    // Returns a sum or a maximum. The chunks are fixed, so the result does not depend on the number of threads.
    template <class F, class Join>
    [[nodiscard]] double reduced(F&& f, Join&& join) {
        runtime_.parallel.for_chunks(size_, places_a_sum, [&](std::int64_t begin, std::int64_t end) {
            double all = 0.0;
            for (std::int64_t i = begin; i < end; ++i) all = join(all, f(i));
            part_[begin / places_a_sum] = all;
        });
        double all = 0.0;
        for (const double part : part_) all = join(all, part);
        return all;
    }
    [[nodiscard]] double dot(const VecArray& a, const VecArray& b) {
        return reduced([&](std::int64_t i) { return a.x[i] * b.x[i] + a.y[i] * b.y[i] + a.z[i] * b.z[i]; },
                       std::plus<>());
    }
    [[nodiscard]] double largest(const VecArray& a) {
        return std::max(1e-300, std::sqrt(reduced([&](std::int64_t i) { return glm::dot(a[i], a[i]); },
                                                  [](double x, double y) { return std::max(x, y); })));
    }

    // Returns the energy, and writes its derivative in the tangent planes of the spheres.
    double evaluate(const VecArray& normal, VecArray& gradient) const {
        const double value = energy_.approximate_energy(normal, gradient, progress_);
        for_all([&](std::int64_t i) { gradient.set(i, tangent(2.0 * gradient[i], normal[i])); });
        return value;
    }
    [[nodiscard]] static glm::dvec3 tangent(const glm::dvec3& v, const glm::dvec3& normal) noexcept {
        return v - glm::dot(v, normal) * normal;
    }

    void find_direction() {
        for_all([&](std::int64_t i) { direction_.set(i, -gradient_[i]); });
        std::array<double, most_pairs> along{};
        const int kept = std::min(pairs_, most_pairs);
        for (int k = 0; k < kept; ++k) {
            const std::size_t at = pair(k);
            along[at] = dot(step_[at], direction_) * inverse_[at];
            for_all([&](std::int64_t i) { direction_.set(i, direction_[i] - along[at] * change_[at][i]); });
        }
        for_all([&](std::int64_t i) { direction_.set(i, direction_[i] * (scale_ / stiffness_[i])); });
        for (int k = kept - 1; k >= 0; --k) {
            const std::size_t at = pair(k);
            const double back = dot(change_[at], direction_) * inverse_[at];
            for_all([&](std::int64_t i) { direction_.set(i, direction_[i] + (along[at] - back) * step_[at][i]); });
        }
        for_all([&](std::int64_t i) { direction_.set(i, tangent(direction_[i], normal_[i])); });
    }

    // Returns the index of the k-th newest pair.
    [[nodiscard]] std::size_t pair(int k) const noexcept {
        return static_cast<std::size_t>((pairs_ - 1 - k) % most_pairs);
    }

    void remember() {
        const auto at = static_cast<std::size_t>(pairs_ % most_pairs);
        for_all([&](std::int64_t i) {
            const glm::dvec3 n = next_[i];
            step_[at].set(i, tangent(n - normal_[i], n));
            change_[at].set(i, tangent(next_gradient_[i] - gradient_[i], n));
            normal_.set(i, n);
        });
        std::swap(gradient_, next_gradient_);
        const double curvature = dot(step_[at], change_[at]);
        if (!(curvature > 0.0)) return;
        inverse_[at] = 1.0 / curvature;
        for_all([&](std::int64_t i) { next_.set(i, change_[at][i] / stiffness_[i]); });
        scale_ = curvature / std::max(dot(change_[at], next_), 1e-300);
        ++pairs_;
    }

    const base::Runtime& runtime_;
    fit::HermiteEnergy& energy_;
    const base::Array<double>& stiffness_;
    VecArray& normal_;
    const base::Progress& progress_;
    std::int64_t size_;
    VecArray gradient_, next_, next_gradient_, direction_;
    base::Array<double> part_;
    std::vector<VecArray> step_, change_; // the remembered pairs
    std::array<double, most_pairs> inverse_{};
    int pairs_ = 0; // the number of pairs added; only the newest are kept
    double scale_ = 0.5;
    double value_ = 0.0;
};

// Turns the normals to a local minimum of the energy, and returns its value.
double descend(const base::Work& work, fit::HermiteEnergy& energy, const base::Array<double>& stiffness,
               VecArray& normal) {
    Descent descent(work, energy, stiffness, normal);
    double before = descent.value();
    for (int step = 1; step <= tuning.most_steps; ++step) {
        work.check();
        if (!descent.step()) break;
        if (step % tuning.looked_back != 0) continue;
        if (before - descent.value() < tuning.enough_gain * before) break;
        before = descent.value();
    }
    return descent.value();
}

// ---- Signs that spread from neighbour to neighbour

struct Edge {
    float doubt;
    std::int32_t a;
    std::int32_t b;
    std::int32_t turned; // 1 if the signs of the two places differ
};

// Sets of places, joined by union-find (Tarjan 1975). Each place has a sign relative to the first place of its set.
class SignedSets {
public:
    SignedSets(base::Memory& memory, std::int64_t size) : parent_(memory, size), turned_(memory, size) {
        for (std::int64_t i = 0; i < size; ++i) parent_[i] = static_cast<std::int32_t>(i);
    }

    // Returns the first place of the set that `at` is in, and whether `at` has the other sign.
    std::pair<std::int32_t, bool> find(std::int32_t at) noexcept {
        bool turned = false;
        for (; parent_[at] != at; at = parent_[at]) {
            const std::int32_t above = parent_[at];
            turned_[at] ^= turned_[above]; // Path halving: `at` skips its parent.
            parent_[at] = parent_[above];
            turned ^= turned_[at] != 0;
        }
        return {at, turned};
    }
    void join(const Edge& edge) noexcept {
        const auto [a, a_turned] = find(edge.a);
        const auto [b, b_turned] = find(edge.b);
        if (a == b) return;
        const std::int32_t high = std::max(a, b);
        parent_[high] = std::min(a, b);
        turned_[high] = (a_turned ^ b_turned ^ (edge.turned != 0)) ? 1 : 0;
    }

private:
    base::Array<std::int32_t> parent_;
    base::Array<std::uint8_t> turned_; // 1 if the sign differs from that of the parent; 0 at a root
};

// Turns directions so that neighbours agree. The signs spread along the minimum spanning forest of the pairs of
// neighbours. The weight of a pair is smaller the more alike its directions are (Hoppe and others, "Surface
// reconstruction from unorganized points", 1992).
void spread_signs(const base::Work& work, const NeighbourLists& near, std::int64_t neighbours, VecArray& normal) {
    const std::int64_t each = std::min(neighbours, near.each());
    base::Array<Edge> edges(work.memory);
    edges.resize_for_overwrite(normal.size() * each);
    for_places(work, normal.size(), [&](std::int64_t at) {
        Edge* edge = edges.data() + at * each;
        for (const std::int32_t other : near.of(at, each)) {
            const double cosine = glm::dot(normal[at], normal[other]);
            const auto own = static_cast<std::int32_t>(at);
            *edge++ = {static_cast<float>(1.0 - std::min(1.0, std::abs(cosine))), std::min(own, other),
                       std::max(own, other), cosine < 0.0 ? 1 : 0};
        }
    });
    // Two places that are neighbours of each other give the same edge twice. The two edges are equal, so their order
    // does not matter.
    base::sort_long(
        edges.begin(), edges.end(),
        [](const Edge& x, const Edge& y) {
            return std::tie(x.doubt, x.a, x.b, x.turned) < std::tie(y.doubt, y.a, y.b, y.turned);
        },
        work);
    SignedSets sets(work.memory, normal.size());
    for (const std::int64_t k : work.over(edges.size())) {
        sets.join(edges[k]);
    }
    for (std::int64_t at = 0; at < normal.size(); ++at)
        if (sets.find(static_cast<std::int32_t>(at)).second) normal.set(at, -normal[at]);
}

// ---- Starts

[[nodiscard]] VecArray copy(const VecArray& from) {
    VecArray to(from.memory(), from.size());
    for (std::int64_t i = 0; i < from.size(); ++i) to.set(i, from[i]);
    return to;
}

// Returns, for each place, the normal of a plane through the place and its `count` nearest leading places. The leading
// places are the first places of the farthest-first order; their number is the number of all places divided by `share`.
// They surround a place on all sides, even if the places lie along lines.
[[nodiscard]] VecArray coarse_normals(const base::Work& work, const OrderedPoints& places, std::int64_t share,
                                      std::int64_t count) {
    const geometry::PointTree& tree = *places.tree;
    const std::int64_t first = std::max<std::int64_t>(tree.size() / share, std::min<std::int64_t>(tree.size(), 12));
    const base::Array<std::int64_t> least = tree.smallest_of_nodes([&](std::int64_t at) { return places.rank[at]; });
    VecArray normal(work.memory, tree.size());
    for_places(work, tree.size(), [&](std::int64_t at) {
        std::array<std::int64_t, 64> found;
        const glm::dvec3 p = tree.points()[at];
        const std::int64_t there = tree.nearest(
            p, count, [&](std::int64_t node) { return least[node] < first; },
            [&](std::int64_t other) { return places.rank[other] < first; }, found.data());
        Moments moments;
        moments.add(glm::dvec3(0.0));
        for (std::int64_t k = 0; k < there; ++k) moments.add(tree.points()[found[static_cast<std::size_t>(k)]] - p);
        normal.set(at, plane_of(moments).normal);
    });
    return normal;
}

[[nodiscard]] VecArray radial_normals(const geometry::PointTree& tree) {
    VecArray normal(tree.points().memory(), tree.size());
    const glm::dvec3 centre = tree.bounds().centre();
    for (std::int64_t at = 0; at < tree.size(); ++at) {
        const glm::dvec3 out = tree.points()[at] - centre;
        const double length = glm::length(out);
        normal.set(at, length > 0.0 ? out / length : glm::dvec3(0.0, 0.0, 1.0));
    }
    return normal;
}

struct Result {
    VecArray normal;
    double energy;
};

// Returns how far the other results agree with the chosen one: 1 if all signs are equal, and 0 if they are random. It
// is a weighted mean. A result has a larger weight the closer its energy is to the energy of the chosen one. The result
// of the coarser cloud counts, too. Writes LeastEnergy::rival to `rival`.
double agreement(const std::vector<Result>& results, const Result& chosen, const CoarseStart* begin,
                 double& rival) noexcept {
    // Rounding may make a sum of squares negative.
    const auto over_chosen = [&](const Result& r) {
        return std::max(r.energy, 1e-300) / std::max(chosen.energy, 1e-300);
    };
    double weights = 1e-9;
    double alike = 1e-9;
    for (const Result& r : results) {
        if (&r == &chosen) continue;
        const double share = share_alike(r.normal, chosen.normal);
        if (share < tuning.other_signs) rival = std::min(rival, over_chosen(r));
        const double weight = std::exp(-(over_chosen(r) - 1.0) / tuning.unlikely_energy);
        weights += weight;
        alike += weight * (2.0 * share - 1.0);
    }
    if (begin != nullptr) {
        weights += 1.0;
        alike += begin->agreement * (2.0 * share_alike(begin->normal, chosen.normal) - 1.0);
    }
    return results.size() > 1 ? alike / weights : 0.5;
}

} // namespace

LeastEnergy least_energy(const base::Work& work, const OrderedPoints& places, const NeighbourLists& near, double ridge,
                         const VecArray* given, const StartOptions& options) {
    HRBFNPR_ASSERT(given == nullptr || given->size() == places.size());
    HRBFNPR_ASSERT(places.rank.size() == places.size() && ridge >= 0.0 && options.starts >= 0);
    const std::int64_t size = places.size();
    const base::Work standing = work.without_progress();
    // A small number of places is fitted with more neighbours, because they cost little time.
    const auto neighbours = static_cast<std::int32_t>(
        std::min<std::int64_t>(size < tuning.few_places ? tuning.neighbours_of_few : tuning.neighbours, size - 1));
    fit::HermiteEnergy energy(work.part(0.0, 0.1), *places.tree, places.rank, {ridge, neighbours});
    const base::Array<double> stiffness = energy.stiffness(work);
    std::vector<Result> results;
    const auto settle = [&](VecArray normal, bool keep_signs) {
        if (!keep_signs) find_signs(standing, places, near, energy, normal);
        const double reached = descend(standing, energy, stiffness, normal);
        results.push_back({std::move(normal), reached});
    };
    const auto planes = [&](std::int64_t count) { return plane_normals(work, *places.tree, near, count); };
    const std::array<std::function<VecArray()>, 6> starts{[&] { return planes(8); },
                                                          [&] { return planes(16); },
                                                          [&] { return coarse_normals(work, places, 4, 8); },
                                                          [&] { return planes(32); },
                                                          [&] { return coarse_normals(work, places, 16, 8); },
                                                          [&] { return radial_normals(*places.tree); }};
    if (given != nullptr) {
        settle(copy(*given), true);
        settle(copy(*given), false);
    }
    if (options.begin != nullptr) settle(copy(options.begin->normal), true);
    if (options.tree) {
        constexpr std::int64_t of_tree = 16;
        VecArray normal = planes(of_tree);
        spread_signs(work, near, of_tree, normal);
        settle(std::move(normal), true);
    }
    const auto best = [&] {
        return std::min_element(results.begin(), results.end(),
                                [](const Result& a, const Result& b) { return a.energy < b.energy; });
    };
    for (std::size_t k = 0; k < starts.size() && static_cast<int>(k) < options.starts; ++k) {
        work.update(0.1 + 0.9 * static_cast<double>(k) / static_cast<double>(starts.size()));
        settle(starts[k](), false);
        if (options.run_all || results.size() < 2) continue;
        const Result& last = results.back();
        const bool found = std::any_of(results.begin(), results.end() - 1, [&](const Result& r) {
            return std::abs(r.energy - last.energy) < 1e-3 * last.energy && share_alike(r.normal, last.normal) > 0.999;
        });
        if (found && best()->energy > (1.0 - tuning.same_energy) * last.energy) break;
    }
    const auto chosen = best();
    LeastEnergy result(work.memory);
    result.agreement = agreement(results, *chosen, options.begin, result.rival);
    result.energy = std::max(chosen->energy, 0.0) / (4.0 * static_cast<double>(size) - 4.0);
    result.normal = std::move(chosen->normal);
    work.update(1.0);
    return result;
}

} // namespace hrbfnpr::orient
