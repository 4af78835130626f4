// SPDX-License-Identifier: MIT
// The steps of a judgement are:
//
//   compare              measures how alike the given normals and those of least energy are
//   are_inward           tells whether most normals point inward; if so, all are turned
//   have_random_signs    tells whether neighbours agree by chance only; if so, each gets the sign of least energy, or,
//                        if its direction is off, the normal of least energy
//   find_turned_patches  finds patches whose normals are opposite to those of least energy, and which are turned
#include "orient/given_normals.h"

#include "base/assert.h"
#include "orient/outward.h"
#include "orient/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

// The arguments of judge(), which its steps share.
struct JudgementInput {
    const base::Runtime& runtime;
    const geometry::PointTree& tree;
    const NeighbourLists& near;
    const GivenNormals& given;
    const Evidence& evidence;

    [[nodiscard]] double cosine(std::int64_t at) const noexcept {
        return glm::dot(evidence.least_energy_normals[at], given.normal[at]);
    }
    [[nodiscard]] bool known(std::int64_t at) const noexcept { return given.known[at] != 0; }
};

struct Similarity {
    double same_sign = 0.0; // the share of given normals that have the sign of least energy
    double far = 0.0;       // the share of given normals whose lines are more than 60 degrees off
    double median = 0.0;    // the median |cosine| between given lines and lines of least energy
};

[[nodiscard]] Similarity compare(const JudgementInput& c) {
    base::Array<double> cosines(c.runtime.memory);
    Similarity similarity;
    for (std::int64_t at = 0; at < c.tree.size(); ++at) {
        if (!c.known(at)) continue;
        const double cosine = c.cosine(at);
        cosines.push_back(std::abs(cosine));
        similarity.same_sign += cosine > 0.0 ? 1.0 : 0.0;
        similarity.far += std::abs(cosine) < 0.5 ? 1.0 : 0.0;
    }
    similarity.same_sign /= static_cast<double>(cosines.size());
    similarity.far /= static_cast<double>(cosines.size());
    double* const middle = cosines.data() + cosines.size() / 2;
    std::nth_element(cosines.begin(), middle, cosines.end());
    similarity.median = *middle;
    return similarity;
}

// Returns whether most given normals point inward. They are compared with the outward normals of least energy, or, if
// those are doubtful, judged by their own winding numbers.
[[nodiscard]] bool are_inward(const JudgementInput& c, double alike, const base::Progress& progress) {
    if (!c.evidence.doubtful) return alike < 0.5;
    return measure_winding({c.runtime, progress}, c.tree, c.near, c.given.normal).outward() < 0;
}

// Returns whether the signs of the given normals look random: about half of the pairs of neighbours are related as in
// the normals of least energy. If the least energy is doubtful, neighbours with opposite normals must not be the two
// sides of a wall.
[[nodiscard]] bool have_random_signs(const JudgementInput& c) {
    std::int64_t pairs = 0;
    std::int64_t consistent = 0;
    std::int64_t opposite = 0;
    std::int64_t behind = 0; // the number of neighbours at the back of a place, minus the number at its front
    for (std::int64_t at = 0; at < c.tree.size(); ++at) {
        if (!c.known(at)) continue;
        const glm::dvec3 own = c.given.normal[at];
        for (const std::int32_t other : c.near.of(at, tuning.beside)) {
            if (!c.known(other)) continue;
            ++pairs;
            consistent += (c.cosine(at) > 0.0) == (c.cosine(other) > 0.0) ? 1 : 0;
            if (glm::dot(own, c.given.normal[other]) >= 0.0) continue;
            ++opposite;
            behind += glm::dot(c.tree.points()[other] - c.tree.points()[at], own) < 0.0 ? 1 : -1;
        }
    }
    const bool toss = static_cast<double>(consistent) < tuning.tossed * static_cast<double>(pairs);
    const bool are_walls = static_cast<double>(std::abs(behind)) > tuning.walls * static_cast<double>(opposite);
    return toss && !(c.evidence.doubtful && are_walls);
}

// Compares normals across the border of a patch. sum / size is 1 if the normals point the same way on both sides, and
// -1 if they are opposite. Pairs of places on one sheet have the largest weights. With the unit direction d between two
// places, the weight is the product of 1 - (n . d)^2 over both normals n.
struct Border {
    void add(const glm::dvec3& one, const glm::dvec3& two, const glm::dvec3& between) noexcept {
        const double square = glm::dot(between, between);
        if (!(square > 0.0)) return;
        const double a = glm::dot(one, between);
        const double b = glm::dot(two, between);
        const double cosine = (1.0 - a * a / square) * (1.0 - b * b / square) * glm::dot(one, two);
        sum += cosine;
        size += std::abs(cosine);
    }

    double sum = 0.0;
    double size = 0.0;
};

// Returns the patches: connected places whose normals are opposite to those of least energy, but have about the same
// directions. If the least energy is doubtful, it returns only patches whose given normals are opposite to those just
// outside their border.
[[nodiscard]] base::Array<std::int32_t> find_turned_patches(const JudgementInput& c, const Signs& signs) {
    double side = 0.0;
    for (std::int64_t at = 0; at < c.tree.size(); ++at) side += signs[at] * c.cosine(at) > 0.0 ? 1.0 : -1.0;
    const auto against = [&](std::int64_t at) { return (side >= 0.0 ? 1.0 : -1.0) * signs[at] * c.cosine(at) < 0.0; };
    base::Array<std::int32_t> patch(c.runtime.memory); // the places of all patches, patch by patch
    base::Array<std::uint8_t> seen(c.runtime.memory, c.tree.size());
    const auto add = [&](std::int64_t at) {
        if (seen[at] != 0) return;
        seen[at] = 1;
        patch.push_back(static_cast<std::int32_t>(at));
    };
    for (std::int64_t start = 0; start < c.tree.size(); ++start) {
        const std::int64_t begin = patch.size();
        if (against(start)) add(start);
        double cosines = 0.0;
        Border border;
        for (std::int64_t k = begin; k < patch.size(); ++k) {
            const std::int32_t at = patch[k];
            cosines += std::abs(c.cosine(at));
            for (const std::int32_t other : c.near.of(at, tuning.beside)) {
                if (against(other))
                    add(other);
                else if (c.known(at) && c.known(other))
                    border.add(c.given.normal[at], c.given.normal[other], c.tree.points()[other] - c.tree.points()[at]);
            }
        }
        if (patch.size() == begin) continue;
        const bool distinct = cosines > tuning.distinct * static_cast<double>(patch.size() - begin);
        if (!distinct || (c.evidence.doubtful && border.sum >= tuning.torn * border.size)) patch.resize(begin);
    }
    return patch;
}

// Returns the places whose given normals are off the normals of least energy, and nearer to those of planes through
// neighbours.
[[nodiscard]] base::Array<std::uint8_t> find_plane_normals(const JudgementInput& c, const base::Work& work) {
    constexpr double degrees = 57.29577951308232;
    const double least = std::cos(tuning.off_least_energy / degrees);
    const VecArray plane = plane_normals(work, c.tree, c.near, tuning.plane_neighbours);
    base::Array<std::uint8_t> found(work.memory, c.tree.size());
    for (std::int64_t at = 0; at < c.tree.size(); ++at) {
        if (!c.known(at)) continue;
        const double cosine = std::abs(c.cosine(at));
        if (cosine < least && std::abs(glm::dot(plane[at], c.given.normal[at])) > cosine) found[at] = 1;
    }
    return found;
}

} // namespace

glm::dvec3 given_normal(const base::InView& normals, std::int64_t point) noexcept {
    return {normals.get(point, 0), normals.get(point, 1), normals.get(point, 2)};
}

GivenNormals read_given(const base::Work& work, const base::InView& normals, const Cloud& cloud,
                        const NeighbourLists& near) {
    HRBFNPR_ASSERT(normals.count == cloud.place.size());
    GivenNormals given(work.memory);
    given.known.resize(cloud.size());
    given.normal = plane_normals(work, *cloud.tree, near, tuning.plane_neighbours);
    for (std::int64_t i = 0; i < normals.count; ++i) {
        const glm::dvec3 n = given_normal(normals, i);
        if (!std::isfinite(n.x + n.y + n.z))
            fail(Status::invalid_argument,
                 "normals[%lld] is NaN or infinite; remove that point, or set its normal to 0 0 0",
                 static_cast<long long>(i));
        const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
        const std::int64_t at = cloud.place[i];
        if (largest == 0.0 || given.known[at] != 0) continue;
        given.known[at] = 1;
        ++given.known_count;
        given.normal.set(at, glm::normalize(n / largest));
    }
    return given;
}

Judgement judge(const base::Work& work, const Cloud& cloud, const NeighbourLists& near, const GivenNormals& given,
                const Evidence& evidence, NormalMode mode) {
    HRBFNPR_ASSERT(evidence.least_energy_normals.size() == cloud.size() && given.normal.size() == cloud.size());
    Judgement judgement(work.memory);
    if (given.known_count == 0) return judgement;
    const JudgementInput c{work, *cloud.tree, near, given, evidence};
    const Similarity similarity = compare(c);
    work.check();
    const double alike = similarity.same_sign;
    const bool looks = mode == NormalMode::automatic || mode == NormalMode::given;
    const bool strange = !evidence.doubtful && similarity.far > tuning.senseless;
    if (looks && (similarity.median < tuning.meaningful || strange)) return judgement;

    judgement.signs = all_positive(work.memory, cloud.size());
    const auto turn_everything = [&] {
        std::fill(judgement.signs.begin(), judgement.signs.end(), std::int8_t{-1});
        judgement.found = NormalMode::inward;
    };
    judgement.found = NormalMode::given;
    if (mode == NormalMode::inward) {
        turn_everything();
        return judgement;
    }
    // On an open surface, the majority of the given normals decides which side is outward.
    judgement.follows_given = evidence.open && mode != NormalMode::unoriented;
    if (judgement.follows_given && alike < 0.5) judgement.made_sign = -1.0;
    if (mode == NormalMode::unoriented || (looks && have_random_signs(c))) {
        judgement.found = NormalMode::unoriented;
        judgement.by_place = true;
        if (mode == NormalMode::automatic && !evidence.doubtful) judgement.replaced = find_plane_normals(c, work);
        for (std::int64_t at = 0; at < cloud.size(); ++at)
            if (judgement.made_sign * c.cosine(at) < 0.0) judgement.signs[at] = -1;
    } else {
        if (judgement.made_sign > 0.0 && are_inward(c, alike, work)) turn_everything();
        const bool may_differ = std::max(alike, 1.0 - alike) < tuning.all_alike || mode == NormalMode::mixed;
        if (may_differ)
            for (const std::int32_t at : find_turned_patches(c, judgement.signs)) {
                judgement.signs[at] = static_cast<std::int8_t>(-judgement.signs[at]);
                judgement.found = NormalMode::mixed;
            }
        if (mode == NormalMode::mixed) judgement.found = mode;
    }
    if (mode == NormalMode::given) std::fill(judgement.signs.begin(), judgement.signs.end(), std::int8_t{1});
    return judgement;
}

} // namespace hrbfnpr::orient
