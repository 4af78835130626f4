// SPDX-License-Identifier: MIT
#include "surface/direction_field.h"

#include "surface/smooth_directions.h"

#include <cmath>
#include <limits>

namespace hrbfnpr::surface {
namespace {

// In sample spacings: about twelve samples have a say at a point.
constexpr double influence = 2.0;
// Cosine: samples whose normals differ by more belong to another side, or lie around an edge.
constexpr double same_side = 0.1;

} // namespace

DirectionField::DirectionField(const base::Runtime& runtime, const FieldSamples& samples, Symmetry symmetry,
                               const base::Progress& progress)
    : symmetry_(symmetry), spacing_(samples.spacing), radius_(influence * samples.spacing),
      grid_(samples.position, radius_), sample_(runtime.memory, samples.position.size()),
      place_(runtime.memory, samples.position.size()), creased_(samples.sheet != nullptr && !samples.sheet->empty()) {
    const geometry::VecArray smooth = smooth_directions(runtime, samples, symmetry, progress);
    for (std::int64_t at = 0; at < grid_.size(); ++at) {
        const std::int64_t i = grid_.index(at);
        const glm::dvec3 n = samples.normal[i];
        sample_[at] = {samples.position[i],      n, smooth[i],
                       glm::cross(n, smooth[i]), i, creased_ ? (*samples.sheet)[i] : 0};
        place_[i] = at;
    }
}

// Of the two or four directions of a sample the nearest one.
glm::dvec3 DirectionField::aligned(const Sample& sample, const glm::dvec3& along, bool turned) const noexcept {
    const double first = glm::dot(sample.first, along);
    const double second = glm::dot(sample.second, along);
    const bool take_second = symmetry_ == Symmetry::cross ? std::abs(second) > std::abs(first) : turned;
    if (take_second) return second < 0.0 ? -sample.second : sample.second;
    return first < 0.0 ? -sample.first : sample.first;
}

// The nearest sample on the side of the normal; null where there is none, or where p is beyond the crease to the
// nearest of another sheet: on another side of its plane than that sample.
const DirectionField::Sample* DirectionField::sheet_at(const glm::dvec3& p, const glm::dvec3& normal) const noexcept {
    const auto nearest = [&](auto&& counts) {
        const Sample* found = nullptr;
        double least = radius_ * radius_;
        grid_.around(p, [&](std::int64_t at) {
            const Sample& sample = sample_[at];
            const glm::dvec3 offset = p - sample.position;
            const double squared = glm::dot(offset, offset);
            if (!(squared < least) || !counts(sample)) return;
            least = squared;
            found = &sample;
        });
        return found;
    };
    const Sample* const own = nearest([&](const Sample& s) { return glm::dot(s.normal, normal) >= smooth_cosine; });
    if (own == nullptr) return nullptr;
    const Sample* const other =
        nearest([&](const Sample& s) { return is_creased(s.sheet, own->sheet, s.normal, own->normal); });
    if (other == nullptr || glm::dot(other->normal, own->normal) < -same_side) return own; // a thin wall has no crease
    const double there = glm::dot(own->position - other->position, other->normal);
    const double here = glm::dot(p - other->position, other->normal);
    return (there < 0.0) == (here < 0.0) ? own : nullptr;
}

// The height is what (n_j + n) . (p - p_j) / 2 is on average: on a circle, of which n_j is the normal at p_j
// and n that at the foot of p, that is exact where the tangent plane of p_j is off by half the bend.
DirectionField::Local DirectionField::at(const glm::dvec3& p, const glm::dvec3& normal, const glm::dvec3& along,
                                         bool turned) const noexcept {
    Local local;
    double nearest = radius_ * radius_;
    double weights = 0.0;
    double heights = 0.0;
    glm::dvec3 normals(0.0);
    glm::dvec3 directions(0.0);
    glm::dvec3 offsets(0.0);
    const Sample* const own = creased_ ? sheet_at(p, normal) : nullptr;
    if (creased_ && own == nullptr) return {};
    grid_.around(p, [&](std::int64_t at) {
        const Sample& sample = sample_[at];
        const glm::dvec3 offset = p - sample.position;
        const double squared = glm::dot(offset, offset);
        if (!(squared < radius_ * radius_) || glm::dot(sample.normal, normal) < same_side) return;
        if (creased_ && is_creased(sample.sheet, own->sheet, sample.normal, own->normal)) return;
        if (squared < nearest) {
            nearest = squared;
            local.sample = sample.index;
        }
        const double rest = 1.0 - squared / (radius_ * radius_);
        const double weight = rest * rest;
        weights += weight;
        heights += weight * glm::dot(sample.normal, offset);
        normals += weight * sample.normal;
        offsets += weight * offset;
        directions += weight * aligned(sample, along, turned);
    });
    if (!(weights > 0.0)) return {};
    local.normal = glm::normalize(normals); // within 90 degrees of `normal`, all of them
    local.height = 0.5 * (heights + glm::dot(local.normal, offsets)) / weights;
    local.agreement = glm::length(directions) / weights;
    local.distance = std::sqrt(nearest);
    const glm::dvec3 flat = directions - glm::dot(directions, local.normal) * local.normal;
    const double length = glm::length(flat);
    if (!(length > 1e-3 * weights)) return {}; // a singular point
    local.direction = flat / length;
    return local;
}

} // namespace hrbfnpr::surface
