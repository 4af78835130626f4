// SPDX-License-Identifier: MIT
#include "curves/surface_lines.h"
#include "implicit/evaluate_all.h"

#include <cmath>

namespace hrbfnpr::curves {
namespace {

constexpr int turn_steps = 60;
constexpr double known_turn = 1e-10; // of a piece

// A piece at whose ends n . v has different signs.
struct Turn {
    std::int64_t a, b; // points
    double low = 0.0, high = 1.0;
    double at_low, at_high; // n . v
    double share = 0.5;
    glm::dvec3 gradient{0.0};
    int kept = 0; // how often the same end was kept

    // The Illinois method. [Dowell & Jarratt 1971]
    void take(double value) noexcept {
        const bool same = (value < 0.0) == (at_low < 0.0);
        (same ? low : high) = share;
        (same ? at_low : at_high) = value;
        kept = same ? std::max(1, kept + 1) : std::min(-1, kept - 1);
        if (kept > 1) at_high *= 0.5;
        if (kept < -1) at_low *= 0.5;
        share = low + (high - low) * at_low / (at_low - at_high);
    }
    [[nodiscard]] bool done() const noexcept { return !(high - low > known_turn) || at_low == 0.0 || at_high == 0.0; }
};

double facing(const glm::dvec3& gradient, const glm::dvec3& place, const View& view) noexcept {
    return glm::dot(gradient, view.sight(place)) / glm::length(gradient);
}

base::Array<Turn> turns_of(base::Memory& memory, const Curves& curves, const View& view) {
    base::Array<Turn> turns(memory);
    for (std::int64_t c = 0; c < curves.count(); ++c)
        for (std::int64_t k = 0; k < curves.pieces_of(c); ++k) {
            const std::int64_t a = curves.first[c] + k;
            const std::int64_t b = curves.next(c, a);
            const double from = facing(curves.point[a].gradient, curves.point[a].position, view);
            const double to = facing(curves.point[b].gradient, curves.point[b].position, view);
            if ((from < 0.0) == (to < 0.0)) continue;
            Turn turn{a, b, 0.0, 1.0, from, to, from / (from - to), glm::dvec3(0.0), 0};
            turns.push_back(turn);
        }
    return turns;
}

void refine(const base::Runtime& runtime, const Curves& curves, const implicit::Implicit& surface, const View& view,
            base::Array<Turn>& turns) {
    geometry::VecArray place(runtime.memory, turns.size());
    geometry::VecArray gradient(runtime.memory, turns.size());
    bool left = !turns.empty();
    for (int step = 0; step < turn_steps && left; ++step) {
        for (std::int64_t i = 0; i < turns.size(); ++i)
            place.set(i, CubicPiece(curves.point[turns[i].a], curves.point[turns[i].b]).at(turns[i].share));
        implicit::evaluate_all(runtime, surface, place,
                               {nullptr, {gradient.x.data(), gradient.y.data(), gradient.z.data()}, {}},
                               base::Progress());
        left = false;
        for (std::int64_t i = 0; i < turns.size(); ++i) {
            turns[i].gradient = gradient[i];
            if (!turns[i].done()) turns[i].take(facing(gradient[i], place[i], view));
            left = left || !turns[i].done();
        }
    }
}

} // namespace

SurfaceLines with_turns(const base::Runtime& runtime, const SurfaceLines& lines, const implicit::Implicit& surface,
                        const View& view) {
    const Curves& curves = lines.curves;
    base::Array<Turn> turns = turns_of(runtime.memory, curves, view);
    refine(runtime, curves, surface, view, turns);
    SurfaceLines finer(runtime.memory);
    LineBuilder builder(finer);
    std::int64_t next = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        for (std::int64_t i = curves.first[c]; i < curves.first[c + 1]; ++i) {
            const CurvePoint& p = curves.point[i];
            const auto strength = static_cast<double>(lines.strength[i]);
            builder.add(p.position, p.gradient, strength, p.direction());
            if (next >= turns.size() || turns[next].a != i) continue;
            const Turn& turn = turns[next++];
            const CubicPiece piece(p, curves.point[turn.b]);
            builder.add(piece.at(turn.share), turn.gradient, strength, piece.derivative(turn.share));
        }
        builder.end(curves.closed[c] != 0);
    }
    return finer;
}

} // namespace hrbfnpr::curves
