// SPDX-License-Identifier: MIT
#include "marks/cluster_shape.h"

#include <glm/matrix.hpp>

namespace hrbfnpr::marks {
namespace {

// Curvatures beyond it, as of marks at one place with different normals, are none.
constexpr double most_bend = 1e30;

} // namespace

Turn TurnFit::turn() const noexcept {
    // Marks lie near a plane: what is across it is left out.
    const glm::dvec3 axis = glm::normalize(normal_);
    const double trace = spread_[0][0] + spread_[1][1] + spread_[2][2];
    const glm::dmat3 map = mixed_ * glm::inverse(spread_ + trace * glm::outerProduct(axis, axis));
    Turn turn;
    turn.shape = 0.5 * (map + glm::transpose(map));
    double squares = 0.0;
    for (int c = 0; c < 3; ++c) squares += glm::dot(turn.shape[c], turn.shape[c]);
    // Of a symmetric map of a plane, from its trace and its Frobenius norm.  [Kindlmann et al. 2003]
    const double t = turn.shape[0][0] + turn.shape[1][1] + turn.shape[2][2];
    turn.bend = 0.5 * (std::abs(t) + std::sqrt(std::max(0.0, 2.0 * squares - t * t)));
    return turn.bend <= most_bend ? turn : Turn{};
}

void set_turn(Cluster& cluster, const Turn& turn) noexcept {
    cluster.bend = static_cast<float>(turn.bend);
    const glm::dmat3& s = turn.shape;
    const std::array<double, 6> shape = {s[0][0], s[1][0], s[2][0], s[1][1], s[2][1], s[2][2]};
    for (std::size_t k = 0; k < shape.size(); ++k) cluster.shape[k] = static_cast<float>(shape[k]);
}

} // namespace hrbfnpr::marks
