// SPDX-License-Identifier: MIT
// The steps are, in this order:
//
//   read_cloud         (cloud.h) merges the points, scales them to 1 apart, and puts them in a tree's order
//   read_given         (given_normals.h) reads the given normals, which are one of the starts
//   normals_of_cloud   (normals_of_cloud.h) finds the normals of least energy
//   turn_outward       (outward.h) turns all normals together, so that they point outward
//   judge              (given_normals.h) judges the given normals
//   write_normals      writes a normal for each point: the one found, or the given one, which is turned if necessary
#include "orient/orient.h"

#include "base/clock.h"
#include "orient/normals_of_cloud.h"
#include "orient/tuning.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

// Writes a normal for each point. Given normals that stay keep their length; at most their sign changes.
void write_normals(const OrientInput& input, const Cloud& cloud, const VecArray& least, const GivenNormals& given,
                   const Judgement& judgement, Orientation& result) {
    OrientReport& report = result.report;
    double angles = 0.0;
    std::int64_t lines = 0;
    for (std::int64_t i = 0; i < input.points.count; ++i) {
        const std::int64_t at = cloud.place[i];
        const glm::dvec3 own = given_normal(input.normals, i);
        const double length = glm::length(own);
        if (length > 0.0) {
            const double cosine = std::abs(glm::dot(own / length, least[at]));
            if (judgement.found == NormalMode::none) angles += std::acos(std::min(1.0, cosine));
            ++lines;
        }
        const bool replaced = !judgement.replaced.empty() && judgement.replaced[at] != 0;
        if (!(length > 0.0) || judgement.found == NormalMode::none || replaced) {
            const bool look_only = input.mode == NormalMode::given;
            result.normal.set(i, look_only ? own : judgement.made_sign * least[at]);
            report.made += look_only ? 0 : 1;
            continue;
        }
        // Points at one place may have different given normals. `against` is true if this one is opposite to the first
        // one.
        const bool against = glm::dot(own, given.normal[at]) < 0.0;
        const bool turned = (judgement.signs[at] < 0) != (against && judgement.by_place);
        result.normal.set(i, turned ? -own : own);
        report.turned += turned ? 1 : 0;
    }
    if (lines > 0) report.direction_change = angles / static_cast<double>(lines) * 57.29577951308232;
}

void log_report(const base::Runtime& runtime, const OrientReport& report, std::int64_t count) {
    runtime.log(base::LogLevel::info, "orient: %lld points in %.2f s, %s, confidence %.2f",
                static_cast<long long>(count), report.seconds, report.closed ? "closed" : "open", report.confidence);
    if (report.turned > 0)
        runtime.log(base::LogLevel::warning, "orient: %lld of %lld normals were flipped",
                    static_cast<long long>(report.turned), static_cast<long long>(count));
    if (report.confidence < tuning.doubtful)
        runtime.log(base::LogLevel::warning,
                    "orient: low confidence, %.2f: noise of %.2g spacings, or thin walls; give more points, or the "
                    "scanner's normals",
                    report.confidence, report.noise / report.spacing);
}

} // namespace

Orientation orient(const base::Work& work, const OrientInput& input) {
    const base::Stopwatch watch;
    const Cloud cloud = read_cloud(work.part(0.0, 0.1), input.points);
    const NeighbourLists near(work, *cloud.tree, tuning.most_neighbours);
    const bool use_given = !input.normals.empty() && input.mode != NormalMode::none;
    const GivenNormals given = use_given ? read_given(work, input.normals, cloud, near) : GivenNormals(work.memory);
    CloudNormals found = normals_of_cloud(work.part(0.1, 0.9), cloud, near, use_given ? &given.normal : nullptr);
    VecArray& least = found.fitted.normal;
    const OutwardRule rule{input.up, (input.viewpoint - cloud.centre) / cloud.spacing, input.has_viewpoint};
    const OutwardResult outward = turn_outward(work.part(0.9, 0.95), cloud, near, rule, least);
    Orientation result(work.memory);
    result.normal.resize(input.points.count);
    OrientReport& report = result.report;
    report.merged = cloud.merged;
    report.noise = found.noise * cloud.spacing;
    report.spacing = cloud.spacing;
    report.energy = found.fitted.energy;
    report.confidence = found.confidence;
    report.closed = outward.closed;
    report.outward_by = outward.decided_by;
    report.components = count_components(work, *cloud.tree, near);
    report.found = NormalMode::none;
    if (use_given) {
        const Evidence evidence{least, outward.decided_by != OutwardBy::inside, found.confidence < tuning.doubtful};
        const Judgement judgement = judge(work, cloud, near, given, evidence, input.mode);
        if (judgement.follows_given) report.outward_by = OutwardBy::as_given;
        report.found = judgement.found;
        write_normals(input, cloud, least, given, judgement, result);
    } else {
        for (std::int64_t i = 0; i < input.points.count; ++i) result.normal.set(i, least[cloud.place[i]]);
        report.made = input.points.count;
    }
    report.seconds = watch.seconds();
    log_report(work, report, input.points.count);
    work.update(1.0);
    return result;
}

bool plainly_inward(const base::Work& work, const base::InView& points, const base::InView& normals) {
    constexpr std::int64_t fewest = 16;
    if (points.count < fewest || normals.count != points.count) return false;
    const std::int64_t step = (points.count + tuning.most_compared - 1) / tuning.most_compared;
    VecArray position(work.memory);
    VecArray given(work.memory);
    for (std::int64_t i = 0; i < points.count; i += step) {
        const glm::dvec3 n = given_normal(normals, i);
        const double length = glm::length(n);
        if (!(length > 0.0)) return false;
        position.push_back({points.get(i, 0), points.get(i, 1), points.get(i, 2)});
        given.push_back(n / length);
    }
    const geometry::PointTree tree(position, work);
    VecArray normal(work.memory, tree.size());
    for (std::int64_t at = 0; at < tree.size(); ++at) normal.set(at, given[tree.index(at)]);
    const NeighbourLists near(work, tree, NeighbourLists::of_spacing);
    const MeanWinding sides = measure_winding(work, tree, near, normal);
    return sides.closed() && sides.against < 0.5 * sides.along && sides.outward() < 0;
}

} // namespace hrbfnpr::orient
