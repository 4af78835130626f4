// SPDX-License-Identifier: MIT
#include "orient/given_normals.h"

#include "orient/sides.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

// Half of normals that are some have a cosine above it with those of least energy; of colours half are above 0.5.
constexpr double meaningful = 0.75;
// ... and no more than this share, where those of least energy are sure, have one below 0.5.
constexpr double senseless = 0.2;
// Shares of signs that agree: what is between is mixed.
constexpr double all_alike = 0.99;
// Of neighbours, where signs are no more than a toss.
constexpr double tossed = 0.75;
constexpr std::size_t beside = 8; // neighbours
// What is turned has a direction of its own, whichever way it points.
constexpr double distinct = 0.5;
// Around patches that were turned the normals of neighbours on a sheet are opposite: -0.97 and below.  Around walls too
// thin for the noise, where the least energy is wrong and the normals right, they are not: -0.2 to -0.8.
constexpr double torn = -0.9;
// In doubt neighbours that point opposite ways are walls if more of them lie behind than before each other, or the
// other way round, by this share; of random signs half do.
constexpr double walls = 0.3;

// How neighbours' normals go on over a patch's border: 1 the same way, -1 turned round.  Pairs count for as much as
// they lie on one sheet: (1 - (n . d)^2) of both, d the direction from one to the other.
class Border {
public:
    void add(const glm::dvec3& one, const glm::dvec3& two, const glm::dvec3& between) noexcept {
        const double square = glm::dot(between, between);
        if (!(square > 0.0)) return;
        const double a = glm::dot(one, between);
        const double b = glm::dot(two, between);
        const double cosine = (1.0 - a * a / square) * (1.0 - b * b / square) * glm::dot(one, two);
        sum_ += cosine;
        size_ += std::abs(cosine);
    }
    [[nodiscard]] bool is_torn() const noexcept { return sum_ < torn * size_; }

private:
    double sum_ = 0.0;
    double size_ = 0.0;
};

} // namespace

GivenNormals::GivenNormals(const base::Runtime& runtime, const base::InView& normals, const Cloud& cloud,
                           const Near& near, bool used, const base::Progress& progress)
    : runtime_(runtime), given_(normals), tree_(*cloud.tree), near_(near), normal_(runtime.memory),
      known_(runtime.memory) {
    if (!used) return;
    known_.resize(cloud.size());
    normal_ = plane_normals(runtime, *cloud.tree, near, 16, progress);
    for (std::int64_t i = 0; i < normals.count; ++i) {
        const glm::dvec3 n = of(i);
        if (!std::isfinite(n.x + n.y + n.z))
            fail(Status::invalid_argument, "normals[%lld] is NaN or infinite; remove that point, or make it 0 0 0",
                 static_cast<long long>(i));
        const double largest = std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
        const std::int64_t at = cloud.place[i];
        if (largest == 0.0 || known_[at] != 0) continue;
        known_[at] = 1;
        ++known_count_;
        normal_.set(at, glm::normalize(n / largest));
    }
}

glm::dvec3 GivenNormals::of(std::int64_t point) const noexcept {
    return {given_.get(point, 0), given_.get(point, 1), given_.get(point, 2)};
}

// alike: share that agrees with those of least energy.  In doubt the given normals alone tell.
bool GivenNormals::are_inward(double alike, bool doubtful, const base::Progress& progress) const {
    if (!doubtful) return alike < 0.5;
    const base::Array<double> spacing = local_spacing(runtime_, tree_, near_);
    return measure_sides(runtime_, tree_, spacing, normal_, {}, progress).outward() < 0;
}

// Whether neighbours agree with those of least energy, or not, by chance; in doubt also where they lie behind each
// other.
bool GivenNormals::are_tossed(const Evidence& evidence) const {
    const VecArray& least = evidence.least;
    std::int64_t pairs = 0;
    std::int64_t consistent = 0;
    std::int64_t opposite = 0;
    std::int64_t behind = 0; // less those before
    for (std::int64_t at = 0; at < least.size(); ++at) {
        if (known_[at] == 0) continue;
        for (const std::int32_t other : near_.of(at).first(std::min(beside, near_.of(at).size()))) {
            if (known_[other] == 0) continue;
            const bool one = glm::dot(least[at], normal_[at]) > 0.0;
            const bool two = glm::dot(least[other], normal_[other]) > 0.0;
            ++pairs;
            consistent += one == two ? 1 : 0;
            if (glm::dot(normal_[at], normal_[other]) >= 0.0) continue;
            ++opposite;
            behind += glm::dot(tree_.points()[other] - tree_.points()[at], normal_[at]) < 0.0 ? 1 : -1;
        }
    }
    const bool toss = static_cast<double>(consistent) < tossed * static_cast<double>(pairs);
    const bool are_walls = static_cast<double>(std::abs(behind)) > walls * static_cast<double>(opposite);
    return toss && !(evidence.doubtful && are_walls);
}

// With those of least energy, of those that are given.
GivenNormals::Likeness GivenNormals::compare(const VecArray& least) const {
    base::Array<double> cosine(runtime_.memory);
    Likeness likeness;
    for (std::int64_t at = 0; at < least.size(); ++at) {
        if (known_[at] == 0) continue;
        const double c = glm::dot(least[at], normal_[at]);
        cosine.push_back(std::abs(c));
        likeness.same_sign += c > 0.0 ? 1.0 : 0.0;
        likeness.far += std::abs(c) < 0.5 ? 1.0 : 0.0;
    }
    likeness.same_sign /= static_cast<double>(known_count_);
    likeness.far /= static_cast<double>(known_count_);
    double* middle = cosine.data() + cosine.size() / 2;
    std::nth_element(cosine.begin(), middle, cosine.end());
    likeness.median = *middle;
    return likeness;
}

// What most of them say, and then the patches that are against it.
void GivenNormals::follow_most(const Evidence& evidence, bool inward, bool may_differ, Judgement& judgement) const {
    if (inward) std::fill(judgement.signs.begin(), judgement.signs.end(), std::int8_t{-1});
    judgement.found = inward ? NormalMode::inward : NormalMode::given;
    if (!may_differ) return;
    std::int64_t before = 0;
    for (const std::int8_t s : judgement.signs) before += s;
    repair(evidence, judgement.signs);
    std::int64_t after = 0;
    for (const std::int8_t s : judgement.signs) after += s;
    if (after != before) judgement.found = NormalMode::mixed;
}

Judgement GivenNormals::judge(const Evidence& evidence, NormalMode mode, const base::Progress& progress) const {
    const VecArray& least = evidence.least;
    const bool open = evidence.open;
    Judgement judgement(runtime_.memory);
    judgement.found = NormalMode::none;
    if (known_count_ == 0) return judgement;
    const Likeness likeness = compare(least);
    progress.check();
    const double alike = likeness.same_sign;
    const bool looks = mode == NormalMode::automatic || mode == NormalMode::given;
    const bool strange = !evidence.doubtful && likeness.far > senseless;
    if (looks && (likeness.median < meaningful || strange)) return judgement;

    judgement.signs.resize(least.size());
    std::fill(judgement.signs.begin(), judgement.signs.end(), std::int8_t{1});
    if (mode == NormalMode::inward) {
        std::fill(judgement.signs.begin(), judgement.signs.end(), std::int8_t{-1});
        judgement.found = NormalMode::inward;
        return judgement;
    }
    // Of open surfaces most given normals say which side is meant.
    if (open && alike < 0.5 && mode != NormalMode::unoriented) judgement.made_sign = -1.0;
    judgement.follows_given = open && mode != NormalMode::unoriented;
    const double side = judgement.made_sign;
    const bool inward = side > 0.0 && are_inward(alike, evidence.doubtful, progress);
    const bool toss = looks && are_tossed(evidence);
    if (mode == NormalMode::unoriented || toss) {
        judgement.found = NormalMode::unoriented;
        judgement.by_place = true;
        for (std::int64_t at = 0; at < least.size(); ++at)
            if (side * glm::dot(least[at], normal_[at]) < 0.0) judgement.signs[at] = -1;
    } else {
        follow_most(evidence, inward, std::max(alike, 1.0 - alike) < all_alike || mode == NormalMode::mixed, judgement);
        if (mode == NormalMode::mixed) judgement.found = NormalMode::mixed;
    }
    if (mode == NormalMode::given) std::fill(judgement.signs.begin(), judgement.signs.end(), std::int8_t{1});
    return judgement;
}

// Places whose normals are against those of least energy, neighbour by neighbour, where their directions agree; in
// doubt only those that the given normals themselves show to be turned, by how they go on around them.
Groups GivenNormals::patches_against(const Evidence& evidence, const Signs& signs) const {
    const VecArray& least = evidence.least;
    double side = 0.0;
    for (std::int64_t at = 0; at < least.size(); ++at)
        side += signs[at] * glm::dot(least[at], normal_[at]) > 0.0 ? 1.0 : -1.0;
    const auto against = [&](std::int64_t at) {
        return (side >= 0.0 ? 1.0 : -1.0) * signs[at] * glm::dot(least[at], normal_[at]) < 0.0;
    };
    Groups patches(runtime_.memory);
    base::Array<std::int32_t>& patch = patches.member; // the last one's are still being found
    base::Array<std::uint8_t> seen(runtime_.memory, least.size());
    for (std::int64_t start = 0; start < least.size(); ++start) {
        if (seen[start] != 0 || !against(start)) continue;
        const std::int64_t begin = patch.size();
        patch.push_back(static_cast<std::int32_t>(start));
        seen[start] = 1;
        double cosines = 0.0;
        Border border;
        for (std::int64_t k = begin; k < patch.size(); ++k) {
            const std::int32_t at = patch[k];
            cosines += std::abs(glm::dot(least[at], normal_[at]));
            for (const std::int32_t other : near_.of(at).first(std::min(beside, near_.of(at).size()))) {
                if (!against(other) && known_[at] != 0 && known_[other] != 0)
                    border.add(normal_[at], normal_[other], tree_.points()[other] - tree_.points()[at]);
                if (seen[other] != 0 || !against(other)) continue;
                seen[other] = 1;
                patch.push_back(other);
            }
        }
        if (cosines > distinct * static_cast<double>(patch.size() - begin) && (!evidence.doubtful || border.is_torn()))
            patches.close();
        else
            patch.resize(begin);
    }
    return patches;
}

// Turns those patches where the given directions, too, have less energy then.
void GivenNormals::repair(const Evidence& evidence, Signs& signs) const {
    const Groups patches = patches_against(evidence, signs);
    if (evidence.form == nullptr) {
        for (const std::int32_t at : patches.member) signs[at] = static_cast<std::int8_t>(-signs[at]);
        return;
    }
    (void)SignEnergy(runtime_, *evidence.form, normal_).turn(patches, 0.0, signs);
}

} // namespace hrbfnpr::orient
