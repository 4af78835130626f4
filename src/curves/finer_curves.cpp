// SPDX-License-Identifier: MIT
#include "curves/finer_curves.h"

#include "curves/cusps.h"

#include <algorithm>

namespace hrbfnpr::curves {
namespace {

constexpr int deepest = 12;              // halvings of a piece
constexpr std::int64_t most_points = 16; // in the mean, of a piece: more only where an eye is on the surface
constexpr double astray_middle =
    0.3; // of a part's length: a middle that is farther off the cubic belongs to another curve
constexpr double smallest_part = 1e-9; // of the distance from the eye, or of the coordinates: a part's length

// Of a piece, between two points on its curve.
struct Part {
    std::int64_t piece; // its first point
    double low, high;   // shares of the piece
    CurvePoint a, b;
};

struct Added {
    std::int64_t piece;
    double share;
    CurvePoint point;
};

glm::dvec2 seen(const View& view, const glm::dvec3& p) noexcept {
    const glm::dvec4 q = view.to_window * glm::dvec4(p, 1.0);
    return glm::dvec2(q) / q.w;
}

class Halving {
public:
    Halving(const base::Runtime& runtime, const Level& contour, const View& view, double tolerance)
        : runtime_(runtime), contour_(contour), view_(view), tolerance_(tolerance), parts_(runtime.memory),
          added_(runtime.memory) {}

    void add(const Part& part) { parts_.push_back(part); }
    void run(std::int64_t& evaluations, const base::Progress& progress);
    // Along the curves.
    [[nodiscard]] base::Array<Added> result() &&;

private:
    void take(const Part& part, const CurvePoint& middle, base::Array<Part>& next);

    const base::Runtime& runtime_;
    const Level& contour_;
    const View& view_;
    double tolerance_;
    base::Array<Part> parts_;
    base::Array<Added> added_;
};

void Halving::take(const Part& part, const CurvePoint& middle, base::Array<Part>& next) {
    const CubicPiece cubic(part.a, part.b);
    const glm::dvec3 expected = cubic.at(0.5);
    if (!(glm::distance(middle.position, expected) <= astray_middle * cubic.length())) return;
    const double share = 0.5 * (part.low + part.high);
    added_.push_back({part.piece, share, middle});
    const bool near = !(glm::distance(seen(view_, middle.position), seen(view_, expected)) > tolerance_);
    if (near || cubic.length() <= smallest_part * glm::length(view_.sight(middle.position))) return;
    next.push_back({part.piece, part.low, share, part.a, middle});
    next.push_back({part.piece, share, part.high, middle, part.b});
}

void Halving::run(std::int64_t& evaluations, const base::Progress& progress) {
    base::Array<CurvePoint> middle(runtime_.memory);
    const std::int64_t limit = most_points * parts_.size();
    for (int depth = 0; depth < deepest && !parts_.empty() && added_.size() < limit; ++depth) {
        middle.resize(parts_.size());
        for (std::int64_t i = 0; i < parts_.size(); ++i)
            middle[i].position = CubicPiece(parts_[i].a, parts_[i].b).at(0.5);
        bring_close(runtime_, contour_, 2, middle, evaluations, progress);
        base::Array<Part> next(runtime_.memory);
        for (std::int64_t i = 0; i < parts_.size(); ++i) take(parts_[i], middle[i], next);
        std::swap(parts_, next);
    }
}

base::Array<Added> Halving::result() && {
    std::sort(added_.begin(), added_.end(), [](const Added& a, const Added& b) {
        return a.piece != b.piece ? a.piece < b.piece : a.share < b.share;
    });
    return std::move(added_);
}

void append(Curves& to, const Curves& from, std::int64_t curve) {
    for (std::int64_t at = from.first[curve]; at < from.first[curve + 1]; ++at) {
        to.point.push_back(from.point[at]);
        to.cusp.push_back(from.cusp.empty() ? std::uint8_t{0} : from.cusp[at]);
    }
    to.first.push_back(to.point.size());
    to.closed.push_back(from.closed[curve]);
}

} // namespace

Curves finer_curves(const base::Runtime& runtime, const Level& contour, const View& view, const Curves& curves,
                    std::span<const std::uint8_t> marked, double tolerance, std::int64_t& evaluations,
                    const base::Progress& progress) {
    base::Array<std::uint8_t> changes(runtime.memory, curves.count());
    Halving halving(runtime, contour, view, tolerance);
    for (std::int64_t c = 0; c < curves.count(); ++c)
        for (std::int64_t at = curves.first[c]; at < curves.first[c] + curves.pieces_of(c); ++at) {
            if (marked[static_cast<std::size_t>(at)] == 0) continue;
            changes[c] = 1;
            halving.add({at, 0.0, 1.0, curves.point[at], curves.point[curves.next(c, at)]});
        }
    halving.run(evaluations, progress);
    const base::Array<Added> added = std::move(halving).result();
    Curves changed(runtime.memory); // those that change, with the points that were added
    changed.first.push_back(0);
    const Added* next = added.begin();
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        if (changes[c] == 0) continue;
        for (std::int64_t at = curves.first[c]; at < curves.first[c + 1]; ++at) {
            changed.point.push_back(curves.point[at]);
            for (; next != added.end() && next->piece == at; ++next) changed.point.push_back(next->point);
        }
        changed.first.push_back(changed.point.size());
        changed.closed.push_back(curves.closed[c]);
    }
    const Curves with = with_cusps(runtime, contour, view, changed, evaluations, progress);
    Curves result(runtime.memory);
    result.first.push_back(0);
    std::int64_t of = 0;
    for (std::int64_t c = 0; c < curves.count(); ++c)
        if (changes[c] != 0)
            append(result, with, of++);
        else
            append(result, curves, c);
    return result;
}

} // namespace hrbfnpr::curves
