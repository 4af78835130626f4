// SPDX-License-Identifier: MIT
#include "surface/smooth_directions.h"

#include "geometry/neighbours.h"
#include "geometry/tangent_frame.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace hrbfnpr::surface {
namespace {

using geometry::VecArray;

constexpr std::int64_t at_once = 8192; // samples without a look for a cancel
// Neighbours that are looked at, and how many of them at most take part: on a thin sheet half are of the other face.
constexpr std::int64_t looked_at = 16;
constexpr std::int64_t most_links = 8;
// Each level has this part of the samples of the next finer one.
constexpr std::int64_t level_ratio = 4;
constexpr std::int64_t coarsest = 48;
constexpr int coarsest_rounds = 60;
constexpr int rounds = 16;
// Measured directions that are trusted more than this are taken to be right where they agree around.
constexpr double trusted = 0.4;
// Of the old value in a round: without, two halves of the samples could swap theirs for ever.
constexpr double inertia = 0.5;

// exp(i N angle) of a direction in a sample's tangent basis, N = 2 or 4: one number for all signs of a line, or
// for all four arms of a cross.  Plain members: base::Array takes nothing that has a constructor.
struct Turn {
    double x = 0.0, y = 0.0;

    [[nodiscard]] Turn operator*(const Turn& b) const noexcept { return {x * b.x - y * b.y, x * b.y + y * b.x}; }
    [[nodiscard]] Turn operator+(const Turn& b) const noexcept { return {x + b.x, y + b.y}; }
    [[nodiscard]] double length() const noexcept { return std::hypot(x, y); }
};
Turn operator*(double s, const Turn& t) noexcept { return {s * t.x, s * t.y}; }

Turn power(const Turn& unit, Symmetry symmetry) noexcept {
    const Turn twice = unit * unit;
    return symmetry == Symmetry::line ? twice : twice * twice;
}

struct Link {
    std::int32_t to = -1;
    Turn turn; // takes what is said in the neighbour's basis into one's own
};

// On one level the samples of a prefix are linked to their neighbours in it, and their values relaxed.
class Relaxation {
public:
    Relaxation(const base::Runtime& runtime, const FieldSamples& samples, Symmetry symmetry);

    void run(const base::Progress& progress);
    [[nodiscard]] VecArray directions() const;

private:
    [[nodiscard]] geometry::TangentFrame frame(std::int64_t i) const noexcept { return {u_[i], r_[i]}; }
    [[nodiscard]] Turn between(std::int64_t from, std::int64_t to) const noexcept;
    void link(std::int64_t count, const base::Progress& progress);
    void gather(std::int64_t fine, std::int64_t coarse, const base::Progress& progress);
    void spread(std::int64_t coarse, std::int64_t fine, const base::Progress& progress);
    void believe(std::int64_t count);
    void relax(std::int64_t count, int times, const base::Progress& progress);
    [[nodiscard]] Turn relaxed(std::int64_t i) const noexcept;
    [[nodiscard]] std::int64_t coarse_neighbour(std::int64_t i, std::int64_t coarse) const noexcept;

    const base::Runtime& runtime_;
    const FieldSamples& samples_;
    Symmetry symmetry_;
    VecArray u_, r_;                      // tangent bases
    base::Array<Turn> measured_;          // times its trust; coarse samples speak for the finer ones around them
    base::Array<double> voices_;          // of how many samples
    base::Array<Turn> value_, next_;      // unit
    base::Array<Link> link_;              // most_links each
    base::Array<std::int64_t> level_end_; // of the prefixes, fine to coarse
};

Relaxation::Relaxation(const base::Runtime& runtime, const FieldSamples& samples, Symmetry symmetry)
    : runtime_(runtime), samples_(samples), symmetry_(symmetry), u_(runtime.memory, samples.position.size()),
      r_(runtime.memory, samples.position.size()), measured_(runtime.memory, samples.position.size()),
      voices_(runtime.memory, samples.position.size()), value_(runtime.memory, samples.position.size()),
      next_(runtime.memory, samples.position.size()), link_(runtime.memory, most_links * samples.position.size()),
      level_end_(runtime.memory) {
    for (std::int64_t i = 0; i < samples.position.size(); ++i) {
        const geometry::TangentFrame basis = geometry::combing_frame(samples.normal[i]);
        u_.set(i, basis.u);
        r_.set(i, basis.r);
        const glm::dvec3 d = samples.direction[i];
        const Turn turn{glm::dot(d, basis.u), glm::dot(d, basis.r)};
        const double length = turn.length();
        const Turn unit = length > 0.5 ? power((1.0 / length) * turn, symmetry) : Turn{1.0, 0.0};
        value_[i] = unit;
        measured_[i] = (length > 0.5 ? samples.trust[i] : 0.0) * unit;
        voices_[i] = 1.0;
    }
    for (std::int64_t count = samples.position.size();; count /= level_ratio) {
        level_end_.push_back(count);
        if (count <= coarsest) break;
    }
}

// The turn of the least rotation of one tangent plane into the other, in their bases: the rotation nearest to
// the 2 x 2 matrix of the bases' products.
Turn Relaxation::between(std::int64_t from, std::int64_t to) const noexcept {
    const glm::dvec3 u = u_[from];
    const glm::dvec3 r = r_[from];
    const Turn turn{glm::dot(u, u_[to]) + glm::dot(r, r_[to]), glm::dot(u, r_[to]) - glm::dot(r, u_[to])};
    const double length = turn.length();
    return length > 1e-9 ? power((1.0 / length) * turn, symmetry_) : Turn{1.0, 0.0};
}

void Relaxation::link(std::int64_t count, const base::Progress& progress) {
    VecArray points(runtime_.memory, count);
    for (std::int64_t i = 0; i < count; ++i) points.set(i, samples_.position[i]);
    const geometry::Neighbours neighbours(runtime_.parallel, points, looked_at, progress);
    runtime_.parallel.for_chunks(count, 1024, progress, [&](std::int64_t begin, std::int64_t end) {
        for (std::int64_t i = begin; i < end; ++i) {
            Link* out = link_.data() + most_links * i;
            std::int64_t found = 0;
            for (const std::int64_t j : neighbours.of(i)) {
                if (found == most_links) break;
                if (glm::dot(samples_.normal[i], samples_.normal[j]) <= 0.0 || samples_.are_creased(i, j)) continue;
                out[found++] = {static_cast<std::int32_t>(j), between(j, i)};
            }
            for (; found < most_links; ++found) out[found] = {};
        }
    });
}

// The nearest linked sample of the coarser level; itself if there is none.
std::int64_t Relaxation::coarse_neighbour(std::int64_t i, std::int64_t coarse) const noexcept {
    for (std::int64_t k = 0; k < most_links; ++k) {
        const std::int64_t to = link_[most_links * i + k].to;
        if (to >= 0 && to < coarse) return to;
    }
    return i;
}

// What was measured at the finer samples counts at their coarse neighbours too.
void Relaxation::gather(std::int64_t fine, std::int64_t coarse, const base::Progress& progress) {
    for (std::int64_t i = coarse; i < fine; ++i) {
        if (i % at_once == 0) progress.check();
        const std::int64_t to = coarse_neighbour(i, coarse);
        if (to == i) continue;
        measured_[to] = measured_[to] + between(i, to) * measured_[i];
        voices_[to] += voices_[i];
    }
}

void Relaxation::spread(std::int64_t coarse, std::int64_t fine, const base::Progress& progress) {
    for (std::int64_t i = coarse; i < fine; ++i) {
        if (i % at_once == 0) progress.check();
        const std::int64_t from = coarse_neighbour(i, coarse);
        if (from != i) value_[i] = between(from, i) * value_[from];
    }
}

// A region that a coarser level left a half turn away from what was measured all over it would stay so: its inside
// has no reason to change, and its border no way to move.  Not on the finest level, where it is single bumps that
// disagree with what is around them.
void Relaxation::believe(std::int64_t count) {
    for (std::int64_t i = 0; i < count; ++i) {
        const Turn m = measured_[i];
        const double length = m.length();
        if (length > trusted * voices_[i] && m.x * value_[i].x + m.y * value_[i].y < 0.0)
            value_[i] = (1.0 / length) * m;
    }
}

Turn Relaxation::relaxed(std::int64_t i) const noexcept {
    Turn sum;
    double links = 0.0;
    for (std::int64_t k = 0; k < most_links; ++k) {
        const Link& link = link_[most_links * i + k];
        if (link.to < 0) break;
        sum = sum + link.turn * value_[link.to];
        links += 1.0;
    }
    if (links > 0.0) sum = (1.0 / links) * sum;
    sum = sum + inertia * value_[i] + (samples_.fidelity / voices_[i]) * measured_[i];
    const double length = sum.length();
    return length > 1e-9 ? (1.0 / length) * sum : value_[i];
}

// Jacobi's method: a round reads the last one only, so that the bits do not depend on threads.
void Relaxation::relax(std::int64_t count, int times, const base::Progress& progress) {
    for (int round = 0; round < times; ++round) {
        progress.check();
        runtime_.parallel.for_chunks(count, 2048, progress, [&](std::int64_t begin, std::int64_t end) {
            for (std::int64_t i = begin; i < end; ++i) next_[i] = relaxed(i);
        });
        std::swap(value_, next_);
        for (std::int64_t i = count; i < value_.size() && round == 0; ++i) value_[i] = next_[i];
    }
}

// Up to the coarsest level what was measured is gathered, and down again values are spread and relaxed: where
// nothing is trusted a field that is relaxed on the finest level only keeps all the whirls it began with.
void Relaxation::run(const base::Progress& progress) {
    const std::int64_t levels = level_end_.size();
    base::Array<Turn> measured(runtime_.memory, measured_.size());
    base::Array<double> voices(runtime_.memory, voices_.size());
    std::copy(measured_.begin(), measured_.end(), measured.begin());
    for (std::int64_t level = 0; level + 1 < levels; ++level) {
        link(level_end_[level], progress);
        gather(level_end_[level], level_end_[level + 1], progress);
        progress.update(0.3 * static_cast<double>(level + 1) / static_cast<double>(levels));
    }
    for (std::int64_t level = levels - 1; level >= 0; --level) {
        const std::int64_t count = level_end_[level];
        link(count, progress);
        if (level + 1 < levels) spread(level_end_[level + 1], count, progress);
        if (level == 0) { // here everybody speaks for himself again
            std::copy(measured.begin(), measured.end(), measured_.begin());
            for (double& voice : voices_) voice = 1.0;
        }
        if (level > 0 && level + 1 < levels) believe(count);
        relax(count, level + 1 == levels ? coarsest_rounds : rounds, progress);
        progress.update(1.0 - 0.7 * static_cast<double>(level) / static_cast<double>(levels));
    }
}

VecArray Relaxation::directions() const {
    VecArray result(runtime_.memory, value_.size());
    for (std::int64_t i = 0; i < value_.size(); ++i) {
        const double angle = std::atan2(value_[i].y, value_[i].x) / static_cast<double>(symmetry_);
        result.set(i, glm::normalize(std::cos(angle) * u_[i] + std::sin(angle) * r_[i]));
    }
    return result;
}

} // namespace

VecArray smooth_directions(const base::Runtime& runtime, const FieldSamples& samples, Symmetry symmetry,
                           const base::Progress& progress) {
    Relaxation relaxation(runtime, samples, symmetry);
    relaxation.run(progress);
    return relaxation.directions();
}

} // namespace hrbfnpr::surface
