// SPDX-License-Identifier: MIT
#include "fit/suspects.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::fit {
namespace {

// The limits below were set on clean sets (tori, knot, hearts, lamp, gargoyle, head, bunny, dragon; nothing is found),
// and on a raw scan.

// A sample is an outlier if its mean distance to its neighbours is this many times the usual one [Rusu et al., "Towards
// 3D point cloud based object maps for household environments", 2008]. The usual distance is a median, which outliers
// do not move. It is taken from the samples around, because the spacing may vary.
constexpr double isolated = 3.0;
// A sample is also an outlier if it lies too far from the tangent planes of its neighbours. The median of these
// distances must exceed `stray` mean distances between samples, and `stray_of_neighbours` times the same median of its
// neighbours.
constexpr double stray = 1.0;
constexpr double stray_of_neighbours = 4.0;
// A sample with at least `companions` companions is no outlier by its distance from tangent planes: it lies on another,
// sparser sheet. Companions are neighbours with a similar normal whose tangent planes pass close to the sample.
constexpr double companion_height = 0.25; // in units of LocalStatistics::height
constexpr double companion_cosine = 0.5;
constexpr int companions = 3;

// A normal is flipped if its cosine with at least this share of its neighbours' normals is below `against`.
constexpr double share_against = 0.875;
constexpr double against = -0.3;
// The mean cosine of a flipped normal with its neighbours' normals is at most -`opposite`. It is also at most minus
// this share of the mean cosine among the neighbours.
constexpr double opposite_of_neighbours = 0.6;
constexpr double opposite = 0.5;
// A normal counts as flipped only if its sample lies amid its neighbours: their mean offset from it is small, and its
// distance from their tangent planes is not much larger than is usual among them. Otherwise the sample may be on the
// other side of a thin wall, where normals are opposite, too.
constexpr double height_of_neighbours = 2.0;
constexpr double height = 0.02; // the least height, in mean distances to a neighbour
constexpr double off_centre = 0.5;
// Turning some normals may show that normals beside them are wrong, too. A few passes find small groups of wrong
// normals.
constexpr int passes = 4;

constexpr std::int64_t suspects_a_task = 512;

// Statistics of a sample and its neighbours.
struct LocalStatistics {
    double distance;  // mean distance to the neighbours
    double height;    // the median distance from the tangent planes of the neighbours
    double agreement; // the mean absolute cosine with the normals of the neighbours
};

using Buffer = std::array<double, geometry::Neighbours::most>;

[[nodiscard]] double median(Buffer& values, std::size_t count) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(count / 2);
    std::nth_element(values.begin(), middle, values.begin() + static_cast<std::ptrdiff_t>(count));
    return *middle;
}

class SuspectFinder {
public:
    SuspectFinder(const base::Work& work, const Samples& samples, const geometry::Neighbours& neighbours)
        : runtime_(work), samples_(samples), neighbours_(neighbours), progress_(work),
          statistics_(work.memory, samples.position.size()), found_(work.memory) {
        for_each([&](std::int64_t i) { statistics_[i] = measure(i); });
        base::Array<double> distance(work.memory, statistics_.size());
        for (std::int64_t i = 0; i < statistics_.size(); ++i) distance[i] = statistics_[i].distance;
        double* middle = distance.data() + distance.size() / 2;
        std::nth_element(distance.begin(), middle, distance.end());
        typical_distance_ = *middle;
        found_.outlier.resize(statistics_.size());
        found_.flipped.resize(statistics_.size());
    }

    [[nodiscard]] Suspects run() {
        for_each([&](std::int64_t i) { found_.outlier[i] = is_outlier(i) ? 1 : 0; });
        for (int pass = 0; pass < passes; ++pass)
            if (!flip_contrary()) break;
        return std::move(found_);
    }

private:
    template <class Visit>
    void for_each(Visit&& visit) const {
        runtime_.parallel.for_chunks(samples_.position.size(), suspects_a_task,
                                     [&](std::int64_t begin, std::int64_t end) {
                                         progress_.check();
                                         for (std::int64_t i = begin; i < end; ++i) visit(i);
                                     });
    }

    // Returns the distance of sample i from the tangent plane of j.
    [[nodiscard]] double height_above(std::int64_t i, std::int64_t j) const noexcept {
        return std::abs(glm::dot(samples_.position[i] - samples_.position[j], samples_.normal[j]));
    }

    [[nodiscard]] LocalStatistics measure(std::int64_t i) const {
        const auto near = neighbours_.of(i);
        Buffer heights{};
        LocalStatistics local{};
        for (std::size_t k = 0; k < near.size(); ++k) {
            local.distance += glm::distance(samples_.position[i], samples_.position[near[k]]);
            heights[k] = height_above(i, near[k]);
            local.agreement += std::abs(glm::dot(samples_.normal[i], samples_.normal[near[k]]));
        }
        const auto count = static_cast<double>(near.size());
        return {local.distance / count, median(heights, near.size()), local.agreement / count};
    }

    [[nodiscard]] double median_of_neighbours(std::int64_t i, double LocalStatistics::*field) const {
        const auto near = neighbours_.of(i);
        Buffer values{};
        for (std::size_t k = 0; k < near.size(); ++k) values[k] = statistics_[near[k]].*field;
        return median(values, near.size());
    }

    // Returns the usual distance between samples around sample i. Where samples are crowded, it is the usual distance
    // over all samples.
    [[nodiscard]] double typical_distance_near(std::int64_t i) const {
        return std::max(typical_distance_, median_of_neighbours(i, &LocalStatistics::distance));
    }

    [[nodiscard]] bool is_outlier(std::int64_t i) const {
        const double usual = typical_distance_near(i);
        if (statistics_[i].distance > isolated * usual) return true;
        return statistics_[i].height > stray * usual &&
               statistics_[i].height > stray_of_neighbours * median_of_neighbours(i, &LocalStatistics::height) &&
               companions_of(i) < companions;
    }

    [[nodiscard]] std::int64_t companions_of(std::int64_t i) const {
        const auto near = neighbours_.of(i);
        return std::count_if(near.begin(), near.end(), [&](std::int64_t j) {
            return height_above(i, j) < companion_height * statistics_[i].height &&
                   glm::dot(samples_.normal[i], samples_.normal[j]) > companion_cosine;
        });
    }

    // Returns whether a normal is flipped. Neighbours that were found to be flipped count with the opposite normal.
    [[nodiscard]] bool is_flipped(std::int64_t i) const {
        const auto near = neighbours_.of(i);
        std::size_t count = 0;
        double sum = 0.0;
        glm::dvec3 offset(0.0);
        Buffer heights{};
        for (const std::int64_t j : near) {
            const double cosine = glm::dot(samples_.normal[i], samples_.normal[j]) *
                                  (found_.flipped[i] == found_.flipped[j] ? 1.0 : -1.0);
            sum += cosine;
            if (cosine >= against) continue;
            heights[count++] = height_above(i, j);
            offset += samples_.position[j] - samples_.position[i];
        }
        const auto all = static_cast<double>(near.size());
        if (static_cast<double>(count) < share_against * all) return false;
        if (-sum / all <
            std::max(opposite, opposite_of_neighbours * median_of_neighbours(i, &LocalStatistics::agreement)))
            return false;
        if (median(heights, count) > height_of_neighbours * median_of_neighbours(i, &LocalStatistics::height) +
                                         height * typical_distance_near(i))
            return false;
        return glm::length(offset) < off_centre * statistics_[i].distance * static_cast<double>(count);
    }

    // Turns the normals that are opposite to their neighbours'. Returns false if it finds none.
    bool flip_contrary() {
        base::Array<std::uint8_t> turned(runtime_.memory, statistics_.size());
        for_each([&](std::int64_t i) { turned[i] = found_.outlier[i] == 0 && is_flipped(i) ? 1 : 0; });
        bool any = false;
        for (std::int64_t i = 0; i < turned.size(); ++i) {
            any = any || turned[i] != 0;
            found_.flipped[i] ^= turned[i];
        }
        return any;
    }

    const base::Runtime& runtime_;
    const Samples& samples_;
    const geometry::Neighbours& neighbours_;
    const base::Progress& progress_;
    base::Array<LocalStatistics> statistics_;
    double typical_distance_ = 0.0;
    Suspects found_;
};

} // namespace

Suspects find_suspects(const base::Work& work, const Samples& samples, const geometry::Neighbours& neighbours) {
    return SuspectFinder(work, samples, neighbours).run();
}

} // namespace hrbfnpr::fit
