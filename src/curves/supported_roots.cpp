// SPDX-License-Identifier: MIT
#include "curves/supported_roots.h"

#include "implicit/evaluate_all.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::curves {
namespace {

constexpr int support_steps = 40;
constexpr double known_support = 1e-9; // of a root, in diagonals
constexpr double on_border = 1e-6;     // of s

// A root that may lie beyond the border.
struct Doubtful {
    std::int64_t number;
    Root root;
    double at;
    bool done;
};

class Judge {
public:
    Judge(const base::Runtime& runtime, const implicit::Implicit& implicit, const SurfaceEnd& end,
          const base::Array<Line>& lines, const Spans& spans)
        : runtime_(runtime), implicit_(implicit), end_(end), lines_(lines), spans_(spans), doubtful_(runtime.memory),
          place_(runtime.memory), gradient_(runtime.memory) {}

    void find(const base::Array<Root>& roots);
    void refine(const base::Progress& progress);
    void judge(base::Array<Root>& roots, base::Array<RootCount>& count) const;

private:
    [[nodiscard]] const Line& line(const Doubtful& d) const noexcept { return lines_[spans_.span[d.root.span].line]; }
    void step(Doubtful& d, double value, const glm::dvec3& gradient) const noexcept;

    const base::Runtime& runtime_;
    const implicit::Implicit& implicit_;
    const SurfaceEnd& end_;
    const base::Array<Line>& lines_;
    const Spans& spans_;
    base::Array<Doubtful> doubtful_;
    geometry::VecArray place_, gradient_; // where each was looked at last
};

void Judge::find(const base::Array<Root>& roots) {
    for (std::int64_t i = 0; i < roots.size(); ++i) {
        const Doubtful d{i, roots[i], 0.5 * (roots[i].low + roots[i].high), false};
        if (end_.near_border(line(d).at(d.at))) doubtful_.push_back(d);
    }
}

// Newton's step, or halving where that leaves the root's bounds.
void Judge::step(Doubtful& d, double value, const glm::dvec3& gradient) const noexcept {
    Root& root = d.root;
    ((value < 0.0) == root.negative_at_low ? root.low : root.high) = d.at;
    const double way = -value / glm::dot(gradient, line(d).direction);
    double next = d.at + way;
    if (!(next > root.low && next < root.high)) next = 0.5 * (root.low + root.high);
    d.done = std::abs(next - d.at) <= known_support * implicit_.diagonal();
    if (!d.done) d.at = next;
}

// A few take all steps, where f is not smooth: the others are not asked again.
void Judge::refine(const base::Progress& progress) {
    place_.resize(doubtful_.size());
    gradient_.resize(doubtful_.size());
    base::Array<std::int64_t> left(runtime_.memory);
    for (std::int64_t i = 0; i < doubtful_.size(); ++i) left.push_back(i);
    geometry::VecArray place(runtime_.memory);
    geometry::VecArray gradient(runtime_.memory);
    base::Array<double> value(runtime_.memory);
    for (int k = 0; k < support_steps && !left.empty(); ++k) {
        place.resize(left.size());
        gradient.resize(left.size());
        value.resize(left.size());
        for (std::int64_t i = 0; i < left.size(); ++i) place.set(i, line(doubtful_[left[i]]).at(doubtful_[left[i]].at));
        implicit::evaluate_all(runtime_, implicit_, place,
                               {value.data(), {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}},
                               progress.part(0.0, 0.0));
        std::int64_t kept = 0;
        for (std::int64_t i = 0; i < left.size(); ++i) {
            const std::int64_t number = left[i];
            place_.set(number, place[i]);
            gradient_.set(number, gradient[i]);
            step(doubtful_[number], value[i], gradient[i]);
            if (!doubtful_[number].done) left[kept++] = number;
        }
        left.resize(kept);
    }
}

void Judge::judge(base::Array<Root>& roots, base::Array<RootCount>& count) const {
    std::int64_t kept = 0;
    std::int64_t next = 0;
    for (std::int64_t i = 0; i < roots.size(); ++i) {
        const bool doubted = next < doubtful_.size() && doubtful_[next].number == i;
        const double beyond = doubted ? end_.beyond(place_[next], gradient_[next]) : -1.0;
        RootCount& of = count[roots[i].span];
        if (doubted && (!doubtful_[next].done || std::abs(beyond) < on_border)) of.certain = false;
        next += doubted ? 1 : 0;
        if (beyond > 0.0)
            --of.roots;
        else
            roots[kept++] = roots[i];
    }
    roots.resize(kept);
}

} // namespace

void drop_unsupported(const base::Runtime& runtime, const implicit::Implicit& implicit, const SurfaceEnd& end,
                      const base::Array<Line>& lines, const Spans& spans, base::Array<Root>& roots,
                      base::Array<RootCount>& count, const base::Progress& progress) {
    Judge judge(runtime, implicit, end, lines, spans);
    judge.find(roots);
    judge.refine(progress);
    judge.judge(roots, count);
}

} // namespace hrbfnpr::curves
