// SPDX-License-Identifier: MIT
#include "orient/least_energy.h"

#include "orient/descend.h"
#include "orient/patches.h"
#include "orient/spanning_tree.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

// Two results are one if their energies are no further apart than this share.
constexpr double same = 0.03;
// Energies so many times the least say nothing about it.
constexpr double unlikely = 0.15;
constexpr double others = 0.95; // share of equal signs
constexpr std::int64_t patches_from = 100000;
constexpr int rounds = 3; // of signs and directions

void turn(const Signs& signs, VecArray& normal) noexcept {
    for (std::int64_t at = 0; at < normal.size(); ++at)
        if (signs[at] < 0) normal.set(at, -normal[at]);
}

[[nodiscard]] VecArray copy(const VecArray& from) {
    VecArray to(from.memory(), from.size());
    std::copy(from.x.begin(), from.x.end(), to.x.begin());
    std::copy(from.y.begin(), from.y.end(), to.y.begin());
    std::copy(from.z.begin(), from.z.end(), to.z.begin());
    return to;
}

struct Result {
    VecArray normal;
    double energy;
};

class Search {
public:
    Search(const base::Runtime& runtime, const geometry::PointTree& tree, const base::Array<std::int64_t>& rank,
           const Near& near, double ridge, const base::Progress& progress)
        : runtime_(runtime), tree_(tree), rank_(rank), near_(near), progress_(progress),
          energy_(std::make_unique<fit::HermiteEnergy>(runtime, tree, rank,
                                                       fit::HermiteEnergy::Options{ridge, neighbours_for(tree.size())},
                                                       progress.part(0.0, 0.1))),
          stiffness_(energy_->stiffness(progress)) {}

    // Signs by the energy, then directions, and both again while that lowers it.
    Result settle(VecArray normal, bool keep_signs) {
        const int most_rounds = tree_.size() > patches_from ? rounds - 1 : rounds;
        const Energy energy = [this](const VecArray& n, VecArray& beta) { return energy_->sparse(n, beta, progress_); };
        if (!keep_signs) find_signs(normal);
        Result best{std::move(normal), 0.0};
        best.energy = descend(runtime_, energy, stiffness_, {}, best.normal, progress_.part(0.0, 0.0));
        for (int round = 1; round < most_rounds; ++round) {
            VecArray next = copy(best.normal);
            if (!find_signs(next)) break;
            const double reached = descend(runtime_, energy, stiffness_, {}, next, progress_.part(0.0, 0.0));
            const bool lower = reached < best.energy * (1.0 - 1e-4);
            if (reached < best.energy) best = {std::move(next), reached};
            if (!lower) break;
        }
        return best;
    }

    // Planes through the nearest of the first places in the farthest-first order: neighbours on all sides even where
    // places stand along lines.
    [[nodiscard]] VecArray coarse_normals(std::int64_t share, std::int64_t count) const {
        const std::int64_t first =
            std::max<std::int64_t>(tree_.size() / share, std::min<std::int64_t>(tree_.size(), 12));
        const base::Array<std::int64_t> least = tree_.smallest_of_nodes([&](std::int64_t at) { return rank_[at]; });
        VecArray normal(runtime_.memory, tree_.size());
        runtime_.parallel.for_chunks(tree_.size(), 256, [&](std::int64_t begin, std::int64_t end) {
            progress_.check();
            std::array<std::int64_t, 64> found;
            for (std::int64_t at = begin; at < end; ++at) {
                const glm::dvec3 p = tree_.points()[at];
                const std::int64_t there = tree_.nearest(
                    p, count, [&](std::int64_t node) { return least[node] < first; },
                    [&](std::int64_t other) { return rank_[other] < first; }, found.data());
                Moments moments;
                moments.add(glm::dvec3(0.0));
                for (std::int64_t k = 0; k < there; ++k)
                    moments.add(tree_.points()[found[static_cast<std::size_t>(k)]] - p);
                normal.set(at, plane_of(moments).normal);
            }
        });
        return normal;
    }
    [[nodiscard]] VecArray near_normals(std::int64_t count) const {
        return plane_normals(runtime_, tree_, near_, count, progress_);
    }

    [[nodiscard]] VecArray radial_normals() const {
        VecArray normal(runtime_.memory, tree_.size());
        const glm::dvec3 centre = tree_.bounds().centre();
        for (std::int64_t at = 0; at < tree_.size(); ++at) {
            const glm::dvec3 out = tree_.points()[at] - centre;
            const double length = glm::length(out);
            normal.set(at, length > 0.0 ? out / length : glm::dvec3(0.0, 0.0, 1.0));
        }
        return normal;
    }

    [[nodiscard]] VecArray tree_normals() const {
        constexpr std::int64_t count = 16;
        VecArray normal = near_normals(count);
        turn(spread_signs(runtime_, tree_, near_, count, normal, Spreading::parallel, progress_), normal);
        return normal;
    }

    [[nodiscard]] double freedom() const noexcept { return 4.0 * static_cast<double>(tree_.size()) - 4.0; }
    [[nodiscard]] std::unique_ptr<fit::HermiteEnergy> take_form() noexcept { return std::move(energy_); }

private:
    // More neighbours of few places cost little.
    [[nodiscard]] static std::int32_t neighbours_for(std::int64_t count) noexcept {
        return static_cast<std::int32_t>(std::min<std::int64_t>(count < 1000 ? 32 : 16, count - 1));
    }

    // Whether any was turned relative to the others.
    bool find_signs(VecArray& normal) {
        const SignEnergy signs(runtime_, *energy_, normal, progress_);
        if (tree_.size() > patches_from && !levels_.cluster.empty()) return improve_signs(signs, normal);
        Signs as_it_is(runtime_.memory, tree_.size());
        std::fill(as_it_is.begin(), as_it_is.end(), std::int8_t{1});
        Patches patches =
            tree_.size() > patches_from ? find_patches(runtime_, tree_, near_, normal) : Patches(runtime_.memory);
        const bool has_patches = patches.cluster.size() == tree_.size();
        Levels& levels = levels_;
        levels.cluster.clear();
        if (has_patches) levels.cluster.push_back(copy_of(patches.cluster));
        Signs best = signs.agglomerate(has_patches ? &patches.cluster : nullptr, has_patches ? &patches.signs : nullptr,
                                       levels, progress_);
        signs.improve(levels, best, progress_);
        if (!(signs.of(best, progress_) < signs.of(as_it_is, progress_) * (1.0 - 1e-9))) return false;
        turn(best, normal);
        return true;
    }
    // The clusters of the first time will do.
    bool improve_signs(const SignEnergy& energy, VecArray& normal) {
        Signs signs(runtime_.memory, tree_.size());
        std::fill(signs.begin(), signs.end(), std::int8_t{1});
        if (energy.improve(levels_, signs, progress_) == 0) return false;
        turn(signs, normal);
        return true;
    }
    [[nodiscard]] base::Array<std::int32_t> copy_of(const base::Array<std::int32_t>& from) const {
        base::Array<std::int32_t> to(runtime_.memory, from.size());
        std::copy(from.begin(), from.end(), to.begin());
        return to;
    }

    const base::Runtime& runtime_;
    const geometry::PointTree& tree_;
    const base::Array<std::int64_t>& rank_;
    const Near& near_;
    base::Progress progress_;
    std::unique_ptr<fit::HermiteEnergy> energy_;
    base::Array<double> stiffness_;
    Levels levels_; // of the signs found last
};

// How far the others agree with the chosen one: of energies near its, weighted by how near, and of the coarser cloud
// that was begun from.  rival: see LeastEnergy.
double agreement(const std::vector<Result>& results, const Result& chosen, const Begin* begin, double& rival) noexcept {
    // A sum of squares, but by its rounding it may lie below 0.
    const auto over_chosen = [&](const Result& r) {
        return std::max(r.energy, 1e-300) / std::max(chosen.energy, 1e-300);
    };
    double weights = 1e-9;
    double alike = 1e-9;
    for (const Result& r : results) {
        if (&r == &chosen) continue;
        const double share = share_alike(r.normal, chosen.normal);
        if (share < others) rival = std::min(rival, over_chosen(r));
        const double weight = std::exp(-(over_chosen(r) - 1.0) / unlikely);
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

double share_alike(const VecArray& a, const VecArray& b) noexcept {
    std::int64_t alike = 0;
    for (std::int64_t at = 0; at < a.size(); ++at) alike += glm::dot(a[at], b[at]) > 0.0 ? 1 : 0;
    const double share = static_cast<double>(alike) / static_cast<double>(a.size());
    return std::max(share, 1.0 - share);
}

LeastEnergy least_energy(const base::Runtime& runtime, const geometry::PointTree& tree,
                         const base::Array<std::int64_t>& rank, const Near& near, double ridge, const VecArray* given,
                         const Effort& effort, const base::Progress& progress) {
    Search search(runtime, tree, rank, near, ridge, progress);
    std::vector<Result> results;
    const std::vector<std::function<VecArray()>> starts{
        [&] { return search.near_normals(8); },       [&] { return search.near_normals(16); },
        [&] { return search.coarse_normals(4, 8); },  [&] { return search.near_normals(32); },
        [&] { return search.coarse_normals(16, 8); }, [&] { return search.radial_normals(); }};
    if (given != nullptr) {
        results.push_back(search.settle(copy(*given), true));
        results.push_back(search.settle(copy(*given), false));
    }
    if (effort.begin != nullptr) results.push_back(search.settle(copy(effort.begin->normal), true));
    if (effort.tree) results.push_back(search.settle(search.tree_normals(), true));
    const auto best = [&] {
        return std::min_element(results.begin(), results.end(),
                                [](const Result& a, const Result& b) { return a.energy < b.energy; });
    };
    for (std::size_t k = 0; k < starts.size() && static_cast<int>(k) < effort.starts; ++k) {
        progress.update(0.1 + 0.9 * static_cast<double>(k) / static_cast<double>(starts.size()));
        results.push_back(search.settle(starts[k](), false));
        if (effort.all || results.size() < 2) continue;
        const Result& last = results.back();
        const bool found = std::any_of(results.begin(), results.end() - 1, [&](const Result& r) {
            return std::abs(r.energy - last.energy) < 1e-3 * last.energy && share_alike(r.normal, last.normal) > 0.999;
        });
        if (found && best()->energy > (1.0 - same) * last.energy) break;
    }
    const auto chosen = best();
    LeastEnergy result(runtime.memory);
    result.agreement = agreement(results, *chosen, effort.begin, result.rival);
    result.energy = std::max(chosen->energy, 0.0) / search.freedom();
    result.normal = std::move(chosen->normal);
    result.form = search.take_form();
    progress.update(1.0);
    return result;
}

} // namespace hrbfnpr::orient
