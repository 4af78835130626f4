// SPDX-License-Identifier: MIT
#include "visibility/verify_crossings.h"

#include "visibility/meeting.h"

#include <cmath>

namespace hrbfnpr::visibility {
namespace {

constexpr double suspicious_gap = 0.5; // in sides
constexpr int most_rounds = 8;
// In gaps between the curves: steps that are shorter end the search, and longer ways in all make it fail.  So does a
// gap that vanishes: at a cusp a curve meets itself.
constexpr double settled = 0.01;
constexpr double farthest_crossing = 0.5;
constexpr double smallest = 0.1;

// A crossing, and a place on either curve.
struct Suspect {
    std::int64_t crossing;
    glm::dvec3 begin[2];
    double gap; // in the farther curve's coordinates
    bool done, right;
};

class Verifier {
public:
    Verifier(const base::Runtime& runtime, std::span<const Subject> subjects, const ImageLines& lines,
             base::Array<Crossing>& crossings)
        : runtime_(runtime), subjects_(subjects), lines_(lines), crossings_(crossings), suspects_(runtime.memory),
          points_(runtime.memory) {
        for (std::int64_t i = 0; i < crossings.size(); ++i) add(i);
    }

    void run(const base::Progress& progress);
    [[nodiscard]] std::int64_t remove_wrong();

private:
    [[nodiscard]] const Subject& subject(std::int32_t piece) const noexcept {
        return subjects_[static_cast<std::size_t>(lines_.pieces[piece].subject)];
    }
    void add(std::int64_t number);
    void correct(const base::Progress& progress);
    void advance(std::int64_t i) noexcept;

    const base::Runtime& runtime_;
    std::span<const Subject> subjects_;
    const ImageLines& lines_;
    base::Array<Crossing>& crossings_;
    base::Array<Suspect> suspects_;
    base::Array<curves::CurvePoint> points_; // two of each: on the farther curve, and on the nearer
};

// Of contours only beside a cusp of its line is a crossing that the curves do not have alone: elsewhere there are two,
// whose changes add up to zero.  Contours touch the image of the border where they end.
void Verifier::add(std::int64_t number) {
    const Crossing& c = crossings_[number];
    const Subject& far = subject(c.far_piece);
    const Subject& near = subject(c.near_piece);
    if (!(c.gap < suspicious_gap) || far.level == nullptr || near.level == nullptr || far.item != near.item) return;
    if (far.level == near.level && lines_.pieces[c.far_piece].line != lines_.pieces[c.near_piece].line) return;
    Suspect suspect{number,
                    {cubic(subjects_, lines_.pieces[c.far_piece]).at(c.far_share),
                     cubic(subjects_, lines_.pieces[c.near_piece]).at(c.near_share)},
                    0.0,
                    false,
                    false};
    suspect.gap = glm::distance(suspect.begin[0], suspect.begin[1]);
    suspects_.push_back(suspect);
    for (const glm::dvec3& place : suspect.begin) {
        curves::CurvePoint p;
        p.position = place;
        points_.push_back(p);
    }
}

// All points onto their curves, by two of Newton's steps.
void Verifier::correct(const base::Progress& progress) {
    base::Array<curves::CurvePoint> some(runtime_.memory);
    for (const Subject& s : subjects_) {
        if (s.level == nullptr) continue;
        base::Array<std::int64_t> which(runtime_.memory);
        for (std::int64_t i = 0; i < points_.size(); ++i) {
            const Crossing& c = crossings_[suspects_[i / 2].crossing];
            if (!suspects_[i / 2].done && &subject(i % 2 == 0 ? c.far_piece : c.near_piece) == &s) which.push_back(i);
        }
        some.resize(which.size());
        for (std::int64_t i = 0; i < which.size(); ++i) some[i] = points_[which[i]];
        for (int step = 0; step < 2; ++step) {
            curves::evaluate(runtime_, *s.level, some, progress);
            for (curves::CurvePoint& p : some) p.position += p.newton_step();
        }
        for (std::int64_t i = 0; i < which.size(); ++i) points_[which[i]] = some[i];
    }
}

void Verifier::advance(std::int64_t i) noexcept {
    Suspect& suspect = suspects_[i];
    if (suspect.done) return;
    const Crossing& c = crossings_[suspect.crossing];
    curves::CurvePoint* const point = points_.data() + 2 * i;
    const Moving p = moving(subject(c.far_piece).view, point[0].position, glm::normalize(point[0].direction()));
    const Moving q = moving(subject(c.near_piece).view, point[1].position, glm::normalize(point[1].direction()));
    const auto [dp, dq] = meeting(p, q);
    const auto strayed = [&](int k) {
        return !(glm::distance(point[k].position, suspect.begin[k]) <= farthest_crossing * suspect.gap);
    };
    const bool met = glm::distance(point[0].position, point[1].position) < smallest * suspect.gap;
    const bool lost = !(std::abs(dp) <= suspect.gap && std::abs(dq) <= suspect.gap) || met || strayed(0) || strayed(1);
    suspect.right = !lost && std::abs(dp) <= settled * suspect.gap && std::abs(dq) <= settled * suspect.gap;
    suspect.done = lost || suspect.right;
    if (suspect.done) return;
    point[0].position += dp * glm::normalize(point[0].direction());
    point[1].position += dq * glm::normalize(point[1].direction());
}

void Verifier::run(const base::Progress& progress) {
    for (int round = 0; round < most_rounds; ++round) {
        correct(progress);
        bool all = true;
        for (std::int64_t i = 0; i < suspects_.size(); ++i) {
            advance(i);
            all = all && suspects_[i].done;
        }
        if (all) break;
    }
}

std::int64_t Verifier::remove_wrong() {
    std::int64_t kept = 0;
    std::int64_t s = 0;
    for (std::int64_t i = 0; i < crossings_.size(); ++i) {
        const bool suspect = s < suspects_.size() && suspects_[s].crossing == i;
        if (!suspect || suspects_[s].right) crossings_[kept++] = crossings_[i];
        s += suspect ? 1 : 0;
    }
    const std::int64_t removed = crossings_.size() - kept;
    crossings_.resize(kept);
    return removed;
}

} // namespace

std::int64_t verify_crossings(const base::Runtime& runtime, std::span<const Subject> subjects, const ImageLines& lines,
                              base::Array<Crossing>& crossings, const base::Progress& progress) {
    Verifier verifier(runtime, subjects, lines, crossings);
    verifier.run(progress);
    return verifier.remove_wrong();
}

} // namespace hrbfnpr::visibility
