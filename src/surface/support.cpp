// SPDX-License-Identifier: MIT
#include "surface/support.h"

#include "geometry/neighbours.h"
#include "surface/surrounded.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace hrbfnpr::surface {
namespace {

// The spacing around a sample is computed from its distance to the sixth neighbour, and from the median of this
// distance over its neighbours.
constexpr std::int64_t sixth = 6;
constexpr std::int64_t around = 17;
constexpr std::int64_t supported_a_task = 64;
// The factor of s, the width of a sample's kernel in spacings, and the least width in units of `closest`. The least
// width makes all nearest samples count where samples are dense.
constexpr double scale = 3.0;
constexpr double width = 0.9;
constexpr double width_of_dense = 0.8;
// The largest value of s in kept cells, as a share of the limit.
constexpr double borne_out = 0.9;

// Returns the distance to the sixth neighbour. If there are fewer neighbours, it uses the middle one, because the last
// may be on the far side of the surface.
double distance_to_sixth(const geometry::VecArray& position, const geometry::Neighbours& neighbours, std::int64_t i) {
    const std::int64_t place = neighbours.each() >= sixth ? sixth - 1 : (neighbours.each() - 1) / 2;
    return glm::distance(position[i], position[neighbours.of(i)[static_cast<std::size_t>(place)]]);
}

// Returns the geometric mean of two distances: the sample's own, and the median of its neighbours'. It suits both
// evenly and unevenly spaced samples.
double own_and_median(const base::Array<double>& distance, std::span<const std::int64_t> neighbours, std::int64_t i) {
    std::array<double, around> of{};
    std::size_t count = 0;
    for (const std::int64_t j : neighbours) of[count++] = distance[j];
    std::nth_element(of.begin(), of.begin() + count / 2, of.begin() + count);
    return std::sqrt(distance[i] * of[count / 2]);
}

} // namespace

// The samples nearest to a point, and -ln of their weights. The smallest of these logarithms is factored out of the
// sums, so that the sums do not become 0 far away.
struct Support::NearSamples {
    std::array<std::int64_t, nearest> at;
    std::array<double, nearest> facing; // (1 + n_j . m) / 2
    std::array<double, nearest> loss;
    std::size_t count = 0;
    double least = std::numeric_limits<double>::infinity();
    double sum = 0.0;       // sum of exp(least - loss) over the samples
    glm::dvec3 middle{0.0}; // the vector c of surface/support.h

    [[nodiscard]] double weight(std::size_t k) const noexcept { return std::exp(least - loss[k]); }
    [[nodiscard]] double s() const noexcept { return scale * (glm::dot(middle, middle) + least - std::log(sum)); }
};

Support::Support(const base::Work& work, const geometry::VecArray& position, const geometry::VecArray& normal,
                 double closest)
    : tree_(position, work), normal_(position.memory(), position.size()), spacing_(position.memory(), position.size()),
      sharpness_(position.memory(), position.size()), surrounded_(position.memory(), position.size()),
      kept_(position.memory()), ends_(position.memory()) {
    for (std::int64_t at = 0; at < tree_.size(); ++at) normal_.set(at, normal[tree_.index(at)]);
    measure_spacing(work, closest);
}

void Support::keep(const geometry::CellGrid& grid, geometry::CellSet kept, geometry::CellSet ends, double limit) {
    grid_ = grid;
    kept_ = std::move(kept);
    ends_ = std::move(ends);
    limit_ = limit;
}

template <class Visit>
bool Support::for_cells(const glm::dvec3& place, double half, Visit&& visit) const {
    constexpr std::int64_t most = 8; // the largest number of cells along an axis
    const geometry::CellGrid::Cell low = grid_.cell_of(place - half);
    const geometry::CellGrid::Cell high = grid_.cell_of(place + half);
    for (std::size_t axis = 0; axis < 3; ++axis)
        if (high[axis] - low[axis] > most) return false;
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
        for (std::int64_t y = low[1]; y <= high[1]; ++y)
            for (std::int64_t x = low[0]; x <= high[0]; ++x)
                if (!visit(geometry::CellGrid::pack({x, y, z}))) return false;
    return true;
}

bool Support::may_end_near(const glm::dvec3& place, double half) const noexcept {
    return !(limit_ > 0.0) || !for_cells(place, half, [&](std::uint64_t cell) { return !ends_.contains(cell); });
}

// The nearest sample has the largest weight, so the sum of weights is at most `nearest` times the largest possible
// weight.
bool Support::has_nothing_near(const glm::dvec3& place, double half, double limit) const noexcept {
    const double left = nearest_sample(place).distance - std::sqrt(3.0) * half;
    const double most = std::log(static_cast<double>(nearest));
    if (!(left > 0.0 && scale * (least_sharpness_ * left * left - most) > limit)) return false;
    return !(limit_ > 0.0) || for_cells(place, half, [&](std::uint64_t cell) { return !kept_.contains(cell); });
}

void Support::measure_spacing(const base::Work& work, double closest) {
    const geometry::VecArray& position = tree_.points();
    const std::int64_t count = position.size();
    const geometry::Neighbours neighbours(work.runtime().parallel, position, around, work);
    base::Array<double> distance(work.memory, count);
    // A sample that is alone, or that coincides with others, gets a small positive spacing.
    const double smallest = std::max(1e-9 * tree_.bounds().diagonal(), 1e-100);
    for (std::int64_t i = 0; i < count; ++i)
        distance[i] = std::max(smallest, neighbours.each() > 0 ? distance_to_sixth(position, neighbours, i) : smallest);
    work.for_chunks(count, supported_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            const double h = neighbours.each() > 0 ? own_and_median(distance, neighbours.of(i), i) : smallest;
            spacing_[i] = std::max(h, closest);
            sharpness_[i] = std::pow(std::max(width * h, width_of_dense * closest), -2.0);
            surrounded_[i] = is_surrounded(position, normal_, neighbours.of(i), i) ? 1 : 0;
        }
    });
    least_sharpness_ = *std::min_element(sharpness_.begin(), sharpness_.end());
}

glm::dvec3 Support::scaled_offset(std::int64_t j, const glm::dvec3& place) const noexcept {
    return std::sqrt(sharpness_[j]) * (place - tree_.points()[j]);
}

Support::NearSamples Support::find_near_samples(const glm::dvec3& place, const glm::dvec3& normal) const noexcept {
    NearSamples near;
    near.count = static_cast<std::size_t>(tree_.nearest(
        place, nearest, [](std::int64_t) { return true; }, [](std::int64_t) { return true; }, near.at.data()));
    for (std::size_t k = 0; k < near.count; ++k) {
        const std::int64_t j = near.at[k];
        const glm::dvec3 way = place - tree_.points()[j];
        near.facing[k] = std::max(0.0, 0.5 * (1.0 + glm::dot(normal_[j], normal)));
        near.loss[k] = sharpness_[j] * glm::dot(way, way) - 2.0 * std::log(near.facing[k]);
        near.least = std::min(near.least, near.loss[k]);
    }
    if (!std::isfinite(near.least)) return near;
    for (std::size_t k = 0; k < near.count; ++k) {
        const double weight = near.weight(k);
        near.sum += weight;
        near.middle += weight * scaled_offset(near.at[k], place);
    }
    near.middle /= near.sum;
    return near;
}

double Support::value(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept {
    const NearSamples near = find_near_samples(place, glm::normalize(gradient));
    const double s = near.sum > 0.0 ? near.s() : std::numeric_limits<double>::infinity();
    return s < limit_ || may_end_at(place) ? s : borne_out * limit_;
}

Support::Nearest Support::nearest_sample(const glm::dvec3& place) const noexcept {
    std::int64_t at = 0;
    const auto any = [](std::int64_t) { return true; };
    if (tree_.nearest(place, 1, any, any, &at) == 0) return {std::numeric_limits<double>::infinity(), 0.0, false};
    return {glm::distance(place, tree_.points()[at]), spacing_[at], surrounded_[at] != 0};
}

double Support::median_spacing() const {
    base::Array<double> all(spacing_.memory());
    for (const double spacing : spacing_) all.push_back(spacing);
    std::nth_element(all.begin(), all.begin() + all.size() / 2, all.end());
    return all[all.size() / 2];
}

geometry::VecArray Support::samples_not_surrounded() const {
    geometry::VecArray some(spacing_.memory());
    for (std::int64_t i = 0; i < samples(); ++i)
        if (surrounded_[i] == 0) some.push_back(tree_.points()[i]);
    return some;
}

Support::ValueAndDerivatives Support::evaluate(const glm::dvec3& place, const glm::dvec3& gradient) const noexcept {
    const glm::dvec3 normal = glm::normalize(gradient);
    const NearSamples near = find_near_samples(place, normal);
    ValueAndDerivatives answer{std::numeric_limits<double>::infinity(), glm::dvec3(0.0), glm::dvec3(0.0)};
    if (!(near.sum > 0.0)) {
        if (!may_end_at(place)) answer.value = borne_out * limit_;
        return answer;
    }
    answer.value = near.s();
    if (answer.value >= limit_ && !may_end_at(place)) {
        answer.value = borne_out * limit_;
        return answer;
    }
    const double middle = glm::dot(near.middle, near.middle);
    for (std::size_t k = 0; k < near.count; ++k) {
        if (!(near.facing[k] > 0.0)) continue;
        const std::int64_t j = near.at[k];
        const glm::dvec3 q = scaled_offset(j, place);
        const double weight = scale * near.weight(k) / near.sum;
        // The change of -s with this sample's weight, relative to the weight.
        const double change = 1.0 + 2.0 * (middle - glm::dot(near.middle, q));
        answer.place_gradient += 2.0 * weight * std::sqrt(sharpness_[j]) * (near.middle + change * q);
        answer.normal_gradient -= weight * change / near.facing[k] * normal_[j];
    }
    answer.normal_gradient -= glm::dot(answer.normal_gradient, normal) * normal;
    return answer;
}

void Support::evaluate_all(const base::Work& work, const geometry::VecArray& place, const geometry::VecArray& gradient,
                           base::Array<double>& value) const {
    value.resize_for_overwrite(place.size());
    work.for_chunks(place.size(), supported_a_task, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) value[i] = this->value(place[i], gradient[i]);
    });
}

std::int64_t Support::bytes() const noexcept {
    return tree_.points().bytes() + normal_.bytes() + spacing_.bytes() + sharpness_.bytes() + surrounded_.bytes() +
           kept_.bytes() + ends_.bytes() +
           tree_.nodes() * static_cast<std::int64_t>(sizeof(geometry::Bounds) + sizeof(std::int64_t));
}

} // namespace hrbfnpr::surface
