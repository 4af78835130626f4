// SPDX-License-Identifier: MIT
#include "orient/whole.h"

#include "orient/coarser.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;
using Piece = std::span<const std::int32_t>;

constexpr std::size_t linked = 8; // neighbours
// Neighbours farther apart than so many times their spacings are not of one piece.
constexpr double apart = 3.0;
constexpr std::size_t fewest_of_piece = 16;
constexpr std::int64_t most_pieces = 64;
// Turning a piece that is far from the others changes the energy by less than this share of its own.
constexpr double indifferent = 0.05;
constexpr std::int64_t inside_probes = 8;
constexpr std::int64_t spacing_neighbours = 16;

std::int32_t root_of(base::Array<std::int32_t>& parent, std::int32_t at) noexcept {
    while (parent[at] != at) {
        parent[at] = parent[parent[at]];
        at = parent[at];
    }
    return at;
}

void turn_all(Piece members, VecArray& normal) noexcept {
    for (const std::int32_t at : members) normal.set(at, -normal[at]);
}

// Whether most of the piece lies inside the others.
[[nodiscard]] bool inside_others(const Cloud& cloud, const base::Array<double>& spacing, const VecArray& normal,
                                 const Groups& pieces, std::int64_t own) {
    const Piece piece = pieces.of(own);
    std::int64_t inside = 0;
    for (std::int64_t k = 0; k < inside_probes; ++k) {
        const std::size_t at = static_cast<std::size_t>(k) * piece.size() / inside_probes;
        double number = 0.0;
        for (std::int64_t other = 0; other < pieces.size(); ++other)
            if (other != own)
                number += winding_number_at(*cloud.tree, spacing, normal, pieces.of(other), cloud.point(piece[at]));
        inside += std::abs(number) > 0.5 ? 1 : 0;
    }
    return 2 * inside > inside_probes;
}

void turn_pieces(const base::Runtime& runtime, const Cloud& cloud, const base::Array<double>& spacing,
                 const Groups& pieces, const fit::HermiteEnergy& form, VecArray& normal,
                 const base::Progress& progress) {
    Groups inward(runtime.memory);
    for (std::int64_t k = 0; k < std::min(pieces.size(), most_pieces); ++k) {
        const Piece piece = pieces.of(k);
        if (piece.size() < fewest_of_piece) continue;
        const Sides sides = measure_sides(runtime, *cloud.tree, spacing, normal, piece, progress);
        if (!sides.closed() || sides.outward() >= 0 || inside_others(cloud, spacing, normal, pieces, k)) continue;
        for (const std::int32_t at : piece) inward.member.push_back(at);
        inward.close();
    }
    if (inward.size() == 0) return;
    const SignEnergy energy(runtime, form, normal);
    Signs signs(runtime.memory, cloud.size());
    std::fill(signs.begin(), signs.end(), std::int8_t{1});
    const base::Array<std::uint8_t> turned = energy.turn(inward, indifferent, signs);
    for (std::int64_t k = 0; k < inward.size(); ++k)
        if (turned[k] != 0) turn_all(inward.of(k), normal);
}

// 1 if the most area faces up, or the viewpoint; of walls across it, that along y, or x.
[[nodiscard]] int side_by_rule(const Cloud& cloud, const base::Array<double>& spacing, const Outward& outward,
                               const VecArray& normal) {
    glm::dvec3 area{0.0};
    double seen = 0.0;
    double all = 0.0;
    for (std::int64_t at = 0; at < cloud.size(); ++at) {
        const double own = spacing[at] * spacing[at];
        area += own * normal[at];
        all += own;
        seen += glm::dot(normal[at], outward.viewpoint - cloud.point(at)) > 0.0 ? own : -own;
    }
    if (outward.has_viewpoint) return seen >= 0.0 ? 1 : -1;
    constexpr double across = 1e-3;
    for (const glm::dvec3& axis :
         {outward.up, glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(1.0, 0.0, 0.0)})
        if (std::abs(glm::dot(area, axis)) > across * all) return glm::dot(area, axis) > 0.0 ? 1 : -1;
    return 1;
}

// Places along curves stand for no area: the first of them do.
[[nodiscard]] Sides sides_of(const base::Runtime& runtime, const Cloud& cloud, const base::Array<double>& spacing,
                             const VecArray& normal, const First* first, const base::Progress& progress) {
    if (first == nullptr) return measure_sides(runtime, *cloud.tree, spacing, normal, {}, progress);
    const Near near(runtime, *first->tree, std::min<std::int64_t>(spacing_neighbours, first->tree->size() - 1),
                    progress);
    return measure_sides(runtime, *first->tree, local_spacing(runtime, *first->tree, near), first->pick(normal), {},
                         progress);
}

} // namespace

Groups find_pieces(const base::Runtime& runtime, const geometry::PointTree& tree, const Near& near) {
    const base::Array<double> spacing = local_spacing(runtime, tree, near);
    base::Array<std::int32_t> parent(runtime.memory, tree.size());
    for (std::int64_t at = 0; at < tree.size(); ++at) parent[at] = static_cast<std::int32_t>(at);
    const std::size_t used = std::min(linked, static_cast<std::size_t>(near.each()));
    for (std::int64_t at = 0; at < tree.size(); ++at)
        for (const std::int32_t other : near.of(at).first(used)) {
            const double limit = apart * std::max(spacing[at], spacing[other]);
            if (glm::distance(tree.points()[at], tree.points()[other]) > limit) continue;
            const std::int32_t a = root_of(parent, static_cast<std::int32_t>(at));
            const std::int32_t b = root_of(parent, other);
            parent[std::max(a, b)] = std::min(a, b);
        }
    base::Array<std::int32_t> count(runtime.memory, tree.size()); // by root
    for (std::int64_t at = 0; at < tree.size(); ++at) ++count[root_of(parent, static_cast<std::int32_t>(at))];
    Groups pieces(runtime.memory);
    pieces.member.resize(tree.size());
    for (std::int64_t at = 0; at < tree.size(); ++at) pieces.member[at] = static_cast<std::int32_t>(at);
    std::sort(pieces.member.begin(), pieces.member.end(), [&](std::int32_t a, std::int32_t b) {
        const std::int32_t x = root_of(parent, a);
        const std::int32_t y = root_of(parent, b);
        if (count[x] != count[y]) return count[x] > count[y];
        return x < y || (x == y && a < b);
    });
    for (std::int64_t at = 1; at <= tree.size(); ++at)
        if (at == tree.size() || root_of(parent, pieces.member[at]) != root_of(parent, pieces.member[at - 1]))
            pieces.begin.push_back(at);
    return pieces;
}

Whole turn_outward(const base::Runtime& runtime, const Cloud& cloud, const Near& near, const Groups& pieces,
                   const Outward& outward, const fit::HermiteEnergy* form, VecArray& normal,
                   const base::Progress& progress) {
    const base::Array<double> spacing = local_spacing(runtime, *cloud.tree, near);
    std::optional<First> first;
    if (is_of_curves(cloud)) first.emplace(runtime, cloud, coarsest_of(cloud.size()), progress);
    const auto measure = [&] { return sides_of(runtime, cloud, spacing, normal, first ? &*first : nullptr, progress); };
    Sides sides = measure();
    const auto turn_whole = [&] {
        for (std::int64_t at = 0; at < normal.size(); ++at) normal.set(at, -normal[at]);
    };
    if (sides.outward() < 0) turn_whole();
    if (form != nullptr && pieces.size() > 1 && pieces.of(1).size() >= fewest_of_piece)
        turn_pieces(runtime, cloud, spacing, pieces, *form, normal, progress);
    sides = measure();
    Whole whole;
    whole.closed = first ? sides.nearly_closed() : sides.closed();
    int side = sides.outward();
    // An open surface that was seen from somewhere has no other outside.
    if (side == 0 || (!whole.closed && outward.has_viewpoint)) {
        whole.by = outward.has_viewpoint ? OutwardBy::viewpoint : OutwardBy::up;
        side = side_by_rule(cloud, spacing, outward, normal);
    }
    if (side < 0) turn_whole();
    return whole;
}

} // namespace hrbfnpr::orient
