// SPDX-License-Identifier: MIT
#include "orient/outward.h"

#include "base/assert.h"
#include "orient/signs.h"
#include "orient/tuning.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;
using Members = std::span<const std::int32_t>;

constexpr double area_share = 0.8660254037844386; // of a hexagonal lattice: area over squared distance
constexpr double sphere = 12.566370614359172;     // solid angle

// The places of a surface that have an area, and its normal times that.
struct Dipoles {
    Dipoles(const geometry::PointTree& tree, const base::Array<double>& spacing, const VecArray& normal,
            Members members)
        : position(normal.memory()), moment(normal.memory()) {
        const auto add = [&](std::int64_t at) {
            position.push_back(tree.points()[at]);
            moment.push_back(area_share * spacing[at] * spacing[at] * normal[at]);
        };
        for (const std::int32_t at : members) add(at);
        for (std::int64_t at = 0; members.empty() && at < tree.size(); ++at) add(at);
    }

    [[nodiscard]] double winding_number(const glm::dvec3& p) const noexcept {
        double sum = 0.0;
        for (std::int64_t i = 0; i < position.size(); ++i) {
            const glm::dvec3 d = position[i] - p;
            const double r2 = glm::dot(d, d) + 1e-12;
            sum += glm::dot(moment[i], d) / (r2 * std::sqrt(r2));
        }
        return sum / sphere;
    }

    VecArray position;
    VecArray moment;
};

void turn_all(VecArray& normal) noexcept {
    for (base::Array<double>* component : {&normal.x, &normal.y, &normal.z})
        for (double& x : *component) x = -x;
}

// Returns whether most of the k-th piece lies inside the others.
[[nodiscard]] bool inside_others(const Cloud& cloud, const base::Array<double>& spacing, const VecArray& normal,
                                 const Groups& pieces, std::int64_t k) {
    const Members piece = pieces.of(k);
    base::Array<std::int32_t> others(normal.memory());
    for (std::int64_t i = 0; i < pieces.member.size(); ++i)
        if (i < pieces.begin[k] || i >= pieces.begin[k + 1]) others.push_back(pieces.member[i]);
    const Dipoles dipoles(*cloud.tree, spacing, normal, others.span());
    std::int64_t inside = 0;
    for (std::int64_t i = 0; i < tuning.inside_probes; ++i) {
        const std::size_t at = static_cast<std::size_t>(i) * piece.size() / std::size_t{tuning.inside_probes};
        inside += std::abs(dipoles.winding_number(cloud.point(piece[at]))) > 0.5 ? 1 : 0;
    }
    return 2 * inside > tuning.inside_probes;
}

void turn_pieces(const base::Runtime& runtime, const Cloud& cloud, const base::Array<double>& spacing,
                 const Groups& pieces, const fit::HermiteEnergy& form, VecArray& normal,
                 const base::Progress& progress) {
    Groups inward(runtime.memory);
    for (std::int64_t k = 0; k < std::min(pieces.size(), tuning.most_pieces); ++k) {
        const Members piece = pieces.of(k);
        if (std::ssize(piece) < tuning.fewest_of_piece) break;
        const Sides sides = measure_sides(runtime, *cloud.tree, spacing, normal, piece, progress);
        if (!sides.closed() || sides.outward() >= 0 || inside_others(cloud, spacing, normal, pieces, k)) continue;
        for (const std::int32_t at : piece) inward.member.push_back(at);
        inward.close();
    }
    if (inward.size() == 0) return;
    Signs signs = all_positive(runtime.memory, cloud.size());
    (void)SignEnergy(runtime, form, normal).turn(inward, tuning.indifferent, signs);
    turn(signs, normal);
}

// Returns 1 if most area faces up, or the viewpoint; of walls that stand across up, faces along y, or x.
[[nodiscard]] int side_by_rule(const Cloud& cloud, const base::Array<double>& spacing, const OutwardRule& rule,
                               const VecArray& normal) {
    glm::dvec3 area{0.0};
    double seen = 0.0;
    double all = 0.0;
    for (std::int64_t at = 0; at < cloud.size(); ++at) {
        const double own = spacing[at] * spacing[at];
        area += own * normal[at];
        all += own;
        seen += glm::dot(normal[at], rule.viewpoint - cloud.point(at)) > 0.0 ? own : -own;
    }
    if (rule.has_viewpoint) return seen >= 0.0 ? 1 : -1;
    constexpr double across = 1e-3; // more than rounding
    for (const glm::dvec3& axis :
         {rule.up, glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(1.0, 0.0, 0.0)})
        if (std::abs(glm::dot(area, axis)) > across * all) return glm::dot(area, axis) > 0.0 ? 1 : -1;
    return 1;
}

} // namespace

bool Sides::closed() const noexcept { return std::min(along, against) < tuning.closed_below; }

bool Sides::nearly_closed() const noexcept { return std::min(along, against) < tuning.nearly_closed_below; }

int Sides::outward() const noexcept {
    if (std::abs(along - against) > tuning.told_apart) return along < against ? 1 : -1;
    // On a thin wall a step inward leads out of it on the other side.
    if (nearly_closed() && std::abs(volume) > tuning.least_volume) return volume > 0.0 ? 1 : -1;
    return 0;
}

Sides measure_sides(const base::Runtime& runtime, const geometry::PointTree& tree, const base::Array<double>& spacing,
                    const VecArray& normal, Members members, const base::Progress& progress) {
    HRBFNPR_ASSERT(spacing.size() == tree.size() && normal.size() == tree.size());
    const Dipoles dipoles(tree, spacing, normal, members);
    const std::int64_t count = dipoles.position.size();
    geometry::Bounds bounds;
    double area = 0.0;
    for (std::int64_t k = 0; k < count; ++k) {
        bounds.extend(dipoles.position[k]);
        area += glm::length(dipoles.moment[k]);
    }
    Sides sides;
    double volume = 0.0;
    for (std::int64_t k = 0; k < count; ++k)
        volume += glm::dot(dipoles.position[k] - bounds.centre(), dipoles.moment[k]) / 3.0;
    sides.volume = volume / std::max(area * bounds.diagonal(), 1e-300);
    const std::int64_t probes = std::min(tuning.probes, count);
    base::Array<double> number(runtime.memory, 2 * probes);
    runtime.parallel.for_each(2 * probes, progress, [&](std::int64_t i) {
        const std::int64_t k = (i / 2) * count / probes;
        const std::int64_t at = members.empty() ? k : members[static_cast<std::size_t>(k)];
        const double way = (i % 2 == 0 ? 1.0 : -1.0) * tuning.probe_step * spacing[at];
        number[i] = std::min(1.5, std::abs(dipoles.winding_number(tree.points()[at] + way * normal[at])));
    });
    sides.along = 0.0;
    sides.against = 0.0;
    for (std::int64_t i = 0; i < 2 * probes; ++i)
        (i % 2 == 0 ? sides.along : sides.against) += number[i] / static_cast<double>(probes);
    return sides;
}

Whole turn_outward(const base::Runtime& runtime, const Cloud& cloud, const Near& near, const Groups& pieces,
                   const OutwardRule& rule, const fit::HermiteEnergy* form, VecArray& normal,
                   const base::Progress& progress) {
    HRBFNPR_ASSERT(normal.size() == cloud.size() && pieces.size() > 0);
    const base::Array<double> spacing = local_spacing(runtime, *cloud.tree, near);
    // Places along curves stand for no area: the first of them do.
    std::optional<FirstPlaces> first;
    if (cloud.is_of_curves()) first.emplace(runtime, cloud, cloud.all_over, progress);
    const auto measure = [&] {
        if (!first) return measure_sides(runtime, *cloud.tree, spacing, normal, {}, progress);
        const Near around(runtime, *first->tree, Near::of_spacing, progress);
        return measure_sides(runtime, *first->tree, local_spacing(runtime, *first->tree, around), first->pick(normal),
                             {}, progress);
    };
    Sides sides = measure();
    if (sides.outward() < 0) turn_all(normal);
    if (form != nullptr && pieces.size() > 1 && std::ssize(pieces.of(1)) >= tuning.fewest_of_piece)
        turn_pieces(runtime, cloud, spacing, pieces, *form, normal, progress);
    sides = measure();
    Whole whole;
    whole.closed = first ? sides.nearly_closed() : sides.closed();
    int side = sides.outward();
    // An open surface that was seen from somewhere has no other outside.
    if (side == 0 || (!whole.closed && rule.has_viewpoint)) {
        whole.by = rule.has_viewpoint ? OutwardBy::viewpoint : OutwardBy::up;
        side = side_by_rule(cloud, spacing, rule, normal);
    }
    if (side < 0) turn_all(normal);
    return whole;
}

} // namespace hrbfnpr::orient
