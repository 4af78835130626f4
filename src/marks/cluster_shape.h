// SPDX-License-Identifier: MIT
// What a cluster is known to be: where its marks lie, how they face, how the surface bends there.
#pragma once

#include "geometry/vec.h"
#include "marks/point_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace hrbfnpr::marks {

// How the normals turn along the surface, dn/dp; bend < 0: not known.
struct Turn {
    glm::dmat3 shape{0.0};
    double bend = -1.0;
};

// Fewer marks do not tell how their normals turn.
inline constexpr std::int64_t fewest_to_fit = 12;

// Sums over marks that the turn of their normals follows from.
class TurnFit {
public:
    TurnFit(const glm::dvec3& middle, const glm::dvec3& normal) noexcept : middle_(middle), normal_(normal) {}

    void add(const glm::dvec3& place, const glm::dvec3& normal) noexcept {
        const glm::dvec3 p = place - middle_;
        const glm::dvec3 n = normal - normal_;
        spread_ += glm::outerProduct(p, p);
        mixed_ += glm::outerProduct(n, p);
    }
    // The linear map that takes the marks' offsets from their mean to the normals', in the sense of least squares.
    [[nodiscard]] Turn turn() const noexcept;

private:
    glm::dvec3 middle_, normal_; // means
    glm::dmat3 spread_{0.0}, mixed_{0.0};
};

// place(i), normal(i) of marks begin .. end - 1.
template <class Place, class Normal>
[[nodiscard]] Turn fit_turn(std::int64_t begin, std::int64_t end, const Place& place, const Normal& normal) {
    glm::dvec3 middle(0.0);
    glm::dvec3 mean(0.0);
    for (std::int64_t i = begin; i < end; ++i) {
        middle += place(i);
        mean += normal(i);
    }
    const auto count = static_cast<double>(end - begin);
    TurnFit fit(middle / count, mean / count);
    for (std::int64_t i = begin; i < end; ++i) fit.add(place(i), normal(i));
    return fit.turn();
}

void set_turn(Cluster& cluster, const Turn& turn) noexcept;

struct Cone {
    std::array<float, 3> axis{};
    float cosine = 1.0F, sine = 0.0F; // of its half angle
};

// Around normal(begin) .. normal(end - 1), and a little larger than the truth, so that floats hold it.
template <class Normal>
[[nodiscard]] Cone cone_around(std::int64_t begin, std::int64_t end, const Normal& normal) {
    glm::dvec3 sum(0.0);
    for (std::int64_t i = begin; i < end; ++i) sum += normal(i);
    const glm::dvec3 axis = glm::normalize(sum);
    double cosine = 1.0;
    for (std::int64_t i = begin; i < end; ++i) cosine = std::min(cosine, glm::dot(axis, normal(i)));
    const double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) + 1e-3;
    Cone cone;
    for (int k = 0; k < 3; ++k) cone.axis[static_cast<std::size_t>(k)] = static_cast<float>(axis[k]);
    cone.cosine = static_cast<float>(std::cos(angle));
    cone.sine = static_cast<float>(std::sin(angle));
    return cone;
}

// Ball and cone around marks begin .. end - 1; both are a little larger than the truth.
template <class Place, class Normal>
void set_extent(Extent& extent, std::int64_t begin, std::int64_t end, const Place& place, const Normal& normal) {
    geometry::Bounds bounds;
    for (std::int64_t i = begin; i < end; ++i) bounds.extend(place(i));
    const glm::dvec3 centre = bounds.centre();
    double radius = 0.0;
    for (std::int64_t i = begin; i < end; ++i) radius = std::max(radius, glm::length(place(i) - centre));
    for (int k = 0; k < 3; ++k) extent.centre[static_cast<std::size_t>(k)] = static_cast<float>(centre[k]);
    extent.radius = static_cast<float>(radius * 1.00001);
    const Cone cone = cone_around(begin, end, normal);
    extent.axis = cone.axis;
    extent.cone_cosine = cone.cosine;
    extent.cone_sine = cone.sine;
}

// Three floats of each mark of a layer, relative to the set's origin.
struct MarkPlaces {
    const float* position;
    const float* normal;
    const float* tone_normal; // NULL: they are not known
};

// Of the piece's marks.
inline void set_extent(StrokePiece& piece, const Layer& layer, const MarkPlaces& places, double unit) {
    const auto vector = [&](const float* from, std::int64_t at) {
        const float* const v = from + 3 * layer.mark_of(at);
        return glm::dvec3(v[0], v[1], v[2]);
    };
    const std::int64_t begin = piece.first;
    const std::int64_t end = begin + piece.count;
    set_extent(
        piece, begin, end, [&](std::int64_t at) { return vector(places.position, at) / unit; },
        [&](std::int64_t at) { return vector(places.normal, at); });
    Cone tone{{}, -1.0F, 0.0F}; // all there are
    if (places.tone_normal == places.normal)
        tone = {piece.axis, piece.cone_cosine, piece.cone_sine};
    else if (places.tone_normal != nullptr)
        tone = cone_around(begin, end, [&](std::int64_t at) { return vector(places.tone_normal, at); });
    piece.tone_axis = tone.axis;
    piece.tone_cosine = tone.cosine;
    piece.tone_sine = tone.sine;
}

} // namespace hrbfnpr::marks
