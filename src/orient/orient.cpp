// SPDX-License-Identifier: MIT
#include "orient/orient.h"

#include "base/clock.h"
#include "orient/given_normals.h"
#include "orient/normals_of_cloud.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::orient {
namespace {

using geometry::VecArray;

constexpr std::int64_t typical_neighbours = 32;

// What becomes of each given point.
enum class Fate : std::uint8_t { keep, turn, make };

class Orienting {
public:
    Orienting(const base::Runtime& runtime, const OrientInput& input, const base::Progress& progress)
        : runtime_(runtime), input_(input), cloud_(read_cloud(runtime, input.points, progress.part(0.0, 0.1))),
          near_(runtime, *cloud_.tree, typical_neighbours, progress), normal_(runtime.memory) {}

    Orientation run(const base::Progress& progress) {
        const bool use_given = !input_.normals.empty() && input_.mode != NormalMode::none;
        GivenNormals given(runtime_, input_.normals, cloud_, near_, use_given, progress);
        CloudNormals found =
            normals_of_cloud(runtime_, cloud_, near_, use_given ? &given.normal() : nullptr, progress.part(0.1, 0.9));
        normal_ = std::move(found.fitted.normal);
        const Groups pieces = find_pieces(runtime_, *cloud_.tree, near_);
        const Outward outward{input_.up, (input_.viewpoint - cloud_.centre) / cloud_.spacing, input_.has_viewpoint};
        const Whole whole = turn_outward(runtime_, cloud_, near_, pieces, outward, found.fitted.form.get(), normal_,
                                         progress.part(0.9, 0.95));
        Orientation result(runtime_.memory);
        OrientReport& report = result.report;
        report.merged = cloud_.merged;
        report.noise = found.noise * cloud_.spacing;
        report.spacing = cloud_.spacing;
        report.energy = found.fitted.energy;
        report.confidence = found.confidence;
        report.closed = whole.closed;
        report.outward_by = whole.by;
        report.components = pieces.size();
        report.found = NormalMode::none;
        if (use_given) {
            const Evidence evidence{normal_, found.fitted.form.get(), whole.by != OutwardBy::inside,
                                    found.confidence < doubtful};
            const Judgement judgement = given.judge(evidence, input_.mode, progress);
            if (judgement.follows_given) report.outward_by = OutwardBy::as_given;
            report.found = judgement.found;
            write(given, judgement, result);
        } else {
            write(result);
        }
        return result;
    }

private:
    void write(Orientation& result) const {
        result.normal.resize(input_.points.count);
        for (std::int64_t i = 0; i < input_.points.count; ++i) result.normal.set(i, normal_[cloud_.place[i]]);
        result.report.made = input_.points.count;
    }

    // Given ones stay what they are but for the sign.
    void write(const GivenNormals& given, const Judgement& judgement, Orientation& result) const {
        OrientReport& report = result.report;
        result.normal.resize(input_.points.count);
        double angles = 0.0;
        std::int64_t lines = 0;
        for (std::int64_t i = 0; i < input_.points.count; ++i) {
            const std::int64_t at = cloud_.place[i];
            const glm::dvec3 own = given.of(i);
            const double length = glm::length(own);
            const bool known = length > 0.0;
            if (known) {
                const double cosine = std::abs(glm::dot(own / length, normal_[at]));
                if (judgement.found == NormalMode::none) angles += std::acos(std::min(1.0, cosine));
                ++lines;
            }
            if (!known || judgement.found == NormalMode::none) {
                const bool look_only = input_.mode == NormalMode::given;
                result.normal.set(i, look_only ? own : judgement.made_sign * normal_[at]);
                report.made += look_only ? 0 : 1;
                continue;
            }
            // Of points that coincide each has its own.
            const bool against = glm::dot(own, given.normal()[at]) < 0.0;
            const bool turned = (judgement.signs[at] < 0) != (against && judgement.by_place);
            result.normal.set(i, turned ? -own : own);
            report.turned += turned ? 1 : 0;
        }
        if (lines > 0) report.direction_change = angles / static_cast<double>(lines) * 57.29577951308232;
    }

    const base::Runtime& runtime_;
    const OrientInput& input_;
    Cloud cloud_;
    Near near_;
    VecArray normal_; // of each place, outward
};

} // namespace

Orientation orient(const base::Runtime& runtime, const OrientInput& input, const base::Progress& progress) {
    const base::Stopwatch watch;
    Orientation result = Orienting(runtime, input, progress).run(progress);
    result.report.seconds = watch.seconds();
    const OrientReport& report = result.report;
    runtime.log(base::LogLevel::info, "orient: %lld points in %.2f s, %s, confidence %.2f",
                static_cast<long long>(input.points.count), report.seconds, report.closed ? "closed" : "open",
                report.confidence);
    if (report.turned > 0)
        runtime.log(base::LogLevel::warning, "orient: %lld of %lld normals were turned round",
                    static_cast<long long>(report.turned), static_cast<long long>(input.points.count));
    if (report.confidence < doubtful)
        runtime.log(base::LogLevel::warning,
                    "orient: confidence %.2f only: noise of %.2g spacings, or walls thinner than the spacing; more "
                    "points, or normals of the scanner's, would help",
                    report.confidence, report.noise / report.spacing);
    progress.update(1.0);
    return result;
}

} // namespace hrbfnpr::orient
