// SPDX-License-Identifier: MIT
#include "orient/noisy_normals.h"

#include "orient/ridge_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

// Neighbours that are asked: of a mean direction, and of a mean place.
constexpr std::int64_t of_direction = 60;
constexpr std::size_t of_place = 40;
// Of a plane of even samples, in spacings.
constexpr std::size_t sixth = 5;
constexpr double distance_to_sixth = 1.38;
// Spacings; of a mean, where its weights have fallen by e.
constexpr std::array<double, 5> means_over{1.0, 1.5, 2.0, 2.5, 3.0};
constexpr double places_over = 1.5;
constexpr double chords_from = 2.0;
constexpr double chords_to = 4.0;
constexpr double faces_over = 1.5;
constexpr double smooth_enough = 2.0; // for points of walls to be settled by their faces
constexpr double faces_within = 3.0;
// Cosines between normals of one face.
constexpr double same_face = 0.5;
constexpr double along_face = 0.3;
constexpr double least_other_face = 0.5; // sum of weights
// Means of a smooth surface have 0.43 to 0.93 of the misfit; a little less have edges and tips, which they round, too.
constexpr double plainly_better = 0.95;
constexpr int rounds_of_faces = 3;
constexpr std::int64_t refined_a_task = 256;

class Refinement {
public:
    Refinement(const base::Runtime& runtime, const geometry::PointTree& tree, const VecArray& normal,
               const base::Progress& progress)
        : runtime_(runtime), tree_(tree), normal_(normal), near_(runtime, tree, of_direction, progress),
          progress_(progress), spacing_(median_spacing()), place_(runtime.memory, tree.size()),
          part_(runtime.memory, tree.size()) {
        for_all([&](std::int64_t at) { place_.set(at, mean_place(at)); });
    }

    struct Means {
        VecArray normal; // empty if they are best as they are
        double over = 0.0;
    };
    [[nodiscard]] Means best_means() {
        Means best{VecArray(runtime_.memory)};
        double least = plainly_better * misfit(normal_);
        for (const double over : means_over) {
            progress_.check();
            VecArray means = smooth_directions(runtime_, tree_, near_, normal_, over * spacing_ / std::sqrt(2.0));
            const double now = misfit(means);
            if (!(now < least)) continue;
            least = now;
            best = {std::move(means), over};
        }
        return best;
    }

    // Points that lie nearer to the other face of a wall look its way.
    void settle_faces(VecArray& normal) {
        for (int round = 0; round < rounds_of_faces; ++round) {
            for_all([&](std::int64_t at) { part_[at] = is_of_other_face(normal, at) ? -1.0 : 1.0; });
            for_all([&](std::int64_t at) { normal.set(at, part_[at] * normal[at]); });
        }
    }

private:
    template <class F>
    void for_all(F&& work) const {
        runtime_.parallel.for_chunks(tree_.size(), refined_a_task, [&](std::int64_t begin, std::int64_t end) {
            progress_.check();
            for (std::int64_t at = begin; at < end; ++at) work(at);
        });
    }

    [[nodiscard]] std::span<const std::int32_t> nearest(std::int64_t at, std::size_t count) const noexcept {
        const std::span<const std::int32_t> all = near_.of(at);
        return all.first(std::min(count, all.size()));
    }

    [[nodiscard]] double median_spacing() const {
        base::Array<double> all(runtime_.memory);
        for (std::int64_t at = 0; at < tree_.size(); ++at) {
            const std::span<const std::int32_t> near = nearest(at, sixth + 1);
            all.push_back(glm::distance(tree_.points()[at], tree_.points()[near.back()]));
        }
        std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
        return all[all.size() / 2] / distance_to_sixth;
    }

    [[nodiscard]] static double falling(double square, double over) noexcept {
        return std::exp(-square / (over * over));
    }
    [[nodiscard]] double weight(std::int64_t at, std::int32_t other, double over) const noexcept {
        const glm::dvec3 between = tree_.points()[other] - tree_.points()[at];
        return falling(glm::dot(between, between), over);
    }

    // visit(other, squared distance) for the points within so many spacings.
    template <class Visit>
    void around(std::int64_t at, double within, Visit&& visit) const {
        tree_.within(tree_.points()[at], within * spacing_, visit);
    }

    [[nodiscard]] glm::dvec3 mean_place(std::int64_t at) const noexcept {
        glm::dvec3 sum = tree_.points()[at];
        double all = 1.0;
        for (const std::int32_t other : nearest(at, of_place)) {
            const double alike = glm::dot(normal_[at], normal_[other]);
            if (!(alike > 0.0)) continue;
            const double share = alike * weight(at, other, places_over * spacing_);
            sum += share * tree_.points()[other];
            all += share;
        }
        return (1.0 / all) * sum;
    }

    // Squares of twice the sines between chords and planes.
    [[nodiscard]] double misfit(const VecArray& normal) {
        const double from = chords_from * spacing_;
        for_all([&](std::int64_t at) {
            double sum = 0.0;
            around(at, chords_to, [&](std::int64_t other, double square) {
                if (!(square > from * from) || !(glm::dot(normal_[at], normal_[other]) > same_face)) return;
                const double off = glm::dot(normal[at] + normal[other], place_[other] - place_[at]);
                sum += off * off / square;
            });
            part_[at] = sum;
        });
        double all = 0.0;
        for (const double sum : part_) all += sum;
        return all;
    }

    // How far the places of a face are from here, along the mean of both normals, so that it may be curved.
    [[nodiscard]] bool is_of_other_face(const VecArray& normal, std::int64_t at) const noexcept {
        const glm::dvec3 own = normal[at];
        double here = 0.0, here_all = 0.0, there = 0.0, there_all = 0.0;
        around(at, faces_within, [&](std::int64_t other, double square) {
            const double alike = glm::dot(own, normal[other]);
            if (other == at || !(std::abs(alike) > along_face)) return;
            const double share = std::abs(alike) * falling(square, faces_over * spacing_);
            const glm::dvec3 across = 0.5 * (own + (alike > 0.0 ? 1.0 : -1.0) * normal[other]);
            const double off = share * glm::dot(across, tree_.points()[other] - tree_.points()[at]);
            (alike > 0.0 ? here : there) += off;
            (alike > 0.0 ? here_all : there_all) += share;
        });
        if (!(there_all > least_other_face) || !(here_all > 0.0)) return false;
        here /= here_all;
        there /= there_all;
        return std::abs(there) < std::abs(here) && there < here;
    }

    const base::Runtime& runtime_;
    const geometry::PointTree& tree_;
    const VecArray& normal_;
    Near near_;
    const base::Progress& progress_;
    double spacing_;
    VecArray place_;           // means of those around
    base::Array<double> part_; // of each place, of what is summed or settled
};

} // namespace

void refine_noisy(const base::Runtime& runtime, const geometry::PointTree& tree, VecArray& normal,
                  const base::Progress& progress) {
    Refinement refinement(runtime, tree, normal, progress);
    Refinement::Means means = refinement.best_means();
    if (means.normal.size() == 0) return;
    runtime.log(base::LogLevel::debug, "orient: directions are means over %.1f spacings", means.over);
    if (means.over >= smooth_enough) refinement.settle_faces(means.normal);
    normal = std::move(means.normal);
}

} // namespace hrbfnpr::orient
