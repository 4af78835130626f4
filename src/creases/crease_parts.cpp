// SPDX-License-Identifier: MIT
#include "creases/creases.h"
#include "surface/sheets_meet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace hrbfnpr::curves {
namespace {

constexpr int part_steps = 60;
constexpr double known_part = 1e-10; // of a piece
constexpr double at_point = 1e-7;    // of a piece: a part that begins so near to a point begins there

enum class Facing : std::uint8_t { outside, left_front, right_front, inside };

Facing facing_of(bool left, bool right) noexcept {
    if (left) return right ? Facing::outside : Facing::left_front;
    return right ? Facing::right_front : Facing::inside;
}

CurvePoint as_curve_point(const CreasePoint& p, double sense) noexcept {
    CurvePoint point;
    point.position = p.position;
    point.gradient = glm::normalize(p.left - glm::dot(p.left, p.tangent) * p.tangent);
    point.level_gradient = sense * glm::cross(p.tangent, point.gradient);
    return point;
}

// Cuts creases where one of their sheets turns away from the eye.
class Cutter {
public:
    Cutter(base::Memory& memory, const implicit::Sheets& sheets, const Creases& creases, const View& view)
        : sheets_(sheets), creases_(creases), view_(view), parts_(memory), path_(memory) {}

    void add(std::int64_t crease);
    [[nodiscard]] CreaseParts result() && { return std::move(parts_); }

private:
    [[nodiscard]] bool shows(const glm::dvec3& normal, const glm::dvec3& place) const noexcept {
        return glm::dot(normal, view_.sight(place)) < 0.0;
    }
    [[nodiscard]] CreasePoint point_on(std::int64_t crease, const CreasePoint& a, const CreasePoint& b,
                                       double share) const;
    [[nodiscard]] double turn_of(std::int32_t sheet, const CubicPiece& piece, double from, double to) const;
    void add_turns(std::int64_t crease, std::int64_t a, std::int64_t b);
    void put(std::int64_t begin, std::int64_t end, bool closed);
    [[nodiscard]] Facing facing_between(std::int64_t k) const noexcept;

    const implicit::Sheets& sheets_;
    const Creases& creases_;
    const View& view_;
    CreaseParts parts_;
    base::Array<CreasePoint> path_; // of a crease, with the places where it turns
    AngleRange angles_;             // of all of it
    bool closed_ = false;
};

CreasePoint Cutter::point_on(std::int64_t crease, const CreasePoint& a, const CreasePoint& b, double share) const {
    const CubicPiece piece(as_curve_point(a, 1.0), as_curve_point(b, 1.0));
    CreasePoint p;
    p.position = piece.at(share);
    p.tangent = glm::normalize(piece.derivative(share));
    p.left = glm::normalize(surface::sheet_at(sheets_, creases_.left[crease], p.position).gradient);
    p.right = glm::normalize(surface::sheet_at(sheets_, creases_.right[crease], p.position).gradient);
    return p;
}

// Where n . v of a sheet vanishes along a piece, by its values at both ends: the Illinois method.
// [Dowell & Jarratt 1971]
double Cutter::turn_of(std::int32_t sheet, const CubicPiece& piece, double from, double to) const {
    double low = 0.0;
    double high = 1.0;
    double share = from / (from - to);
    int kept = 0;
    for (int step = 0; step < part_steps && high - low > known_part && from != 0.0 && to != 0.0; ++step) {
        const glm::dvec3 place = piece.at(share);
        const glm::dvec3 gradient = surface::sheet_at(sheets_, sheet, place).gradient;
        const double value = glm::dot(gradient, view_.sight(place)) / glm::length(gradient);
        const bool same = (value < 0.0) == (from < 0.0);
        (same ? low : high) = share;
        (same ? from : to) = value;
        kept = same ? std::max(1, kept + 1) : std::min(-1, kept - 1);
        if (kept > 1) to *= 0.5;
        if (kept < -1) from *= 0.5;
        share = low + (high - low) * from / (from - to);
    }
    return std::clamp(share, low, high);
}

void Cutter::add_turns(std::int64_t crease, std::int64_t a, std::int64_t b) {
    const CreasePoint& p = creases_.point[a];
    const CreasePoint& q = creases_.point[b];
    const CubicPiece piece(as_curve_point(p, 1.0), as_curve_point(q, 1.0));
    std::array<double, 2> share{};
    std::size_t count = 0;
    for (const bool left : {true, false}) {
        const double from = glm::dot(left ? p.left : p.right, view_.sight(p.position));
        const double to = glm::dot(left ? q.left : q.right, view_.sight(q.position));
        if ((from < 0.0) == (to < 0.0)) continue;
        const double at = turn_of(left ? creases_.left[crease] : creases_.right[crease], piece, from, to);
        if (at > at_point && at < 1.0 - at_point) share[count++] = at;
    }
    if (count == 2 && share[1] < share[0]) std::swap(share[0], share[1]);
    for (std::size_t k = 0; k < count; ++k) path_.push_back(point_on(crease, p, q, share[k]));
}

// Of the piece from point k of the path to the next: by the middle, as at the ends one of them may be turning.
Facing Cutter::facing_between(std::int64_t k) const noexcept {
    const CreasePoint& a = path_[k];
    const CreasePoint& b = path_[(k + 1) % path_.size()];
    const glm::dvec3 place = 0.5 * (a.position + b.position);
    return facing_of(shows(a.left + b.left, place), shows(a.right + b.right, place));
}

// Points of the path from `begin` on, up to and with `end`, which may go round.
void Cutter::put(std::int64_t begin, std::int64_t end, bool closed) {
    const Facing facing = facing_between(begin % path_.size());
    const bool backwards = facing == Facing::right_front;
    SurfaceLines& to = facing == Facing::outside  ? parts_.outside
                       : facing == Facing::inside ? parts_.inside
                                                  : parts_.folds;
    LineBuilder builder(to, true);
    const std::int64_t last = closed ? end - 1 : end;
    for (std::int64_t k = begin; k <= last; ++k) {
        const CreasePoint& p = path_[(backwards ? last - (k - begin) : k) % path_.size()];
        const glm::dvec3 normal = facing == Facing::left_front    ? p.left
                                  : facing == Facing::right_front ? p.right
                                                                  : p.left + p.right;
        builder.add(p.position, normal, p.angle(), backwards ? -p.tangent : p.tangent);
    }
    builder.end(closed);
    base::Array<AngleRange>* const of = facing == Facing::outside  ? &parts_.of_outside
                                        : facing == Facing::inside ? &parts_.of_inside
                                                                   : nullptr;
    if (of != nullptr && of->size() < to.curves.count()) of->push_back(angles_);
}

void Cutter::add(std::int64_t crease) {
    const std::int64_t first = creases_.first[crease];
    const std::int64_t count = creases_.first[crease + 1] - first;
    closed_ = creases_.closed[crease] != 0;
    path_.clear();
    angles_ = {};
    for (std::int64_t i = 0; i < count; ++i) {
        const auto angle = static_cast<float>(creases_.point[first + i].angle());
        angles_ = {std::min(angles_.least, angle), std::max(angles_.most, angle)};
        path_.push_back(creases_.point[first + i]);
        if (i + 1 < count || closed_) add_turns(crease, first + i, first + (i + 1) % count);
    }
    const std::int64_t size = path_.size();
    const std::int64_t pieces = closed_ ? size : size - 1;
    std::int64_t begin = 0; // of a closed crease a piece before which it changes, if there is one
    while (closed_ && begin < size && facing_between(begin) == facing_between((begin + size - 1) % size)) ++begin;
    if (closed_ && begin == size) return put(0, size, true);
    for (std::int64_t k = begin; k < begin + pieces;) {
        std::int64_t end = k + 1;
        while (end < begin + pieces && facing_between(end % size) == facing_between(k % size)) ++end;
        put(k, end, false);
        k = end;
    }
}

// Of an angle that is linear along a piece, where it is `lower`.
double share_of(double from, double to, double lower) noexcept {
    return std::clamp((lower - from) / (to - from), 0.0, 1.0);
}

} // namespace

CreaseParts parts_in_view(const base::Runtime& runtime, const implicit::Sheets& sheets, const Creases& creases,
                          const View& view) {
    Cutter cutter(runtime.memory, sheets, creases, view);
    for (std::int64_t c = 0; c < creases.count(); ++c) cutter.add(c);
    return std::move(cutter).result();
}

SurfaceLines bent_parts(base::Memory& memory, const SurfaceLines& lines, const base::Array<AngleRange>& of,
                        CreaseSide side, double lower, double upper) {
    SurfaceLines parts(memory);
    LineBuilder builder(parts, true);
    const Curves& curves = lines.curves;
    const auto angle = [&](std::int64_t i) { return static_cast<double>(angle_on(side, lines.strength[i])); };
    const auto put = [&](std::int64_t i) {
        builder.add(curves.point[i].position, curves.point[i].gradient, angle(i), curves.point[i].direction());
    };
    const auto put_between = [&](std::int64_t a, std::int64_t b) {
        const double u = share_of(angle(a), angle(b), lower);
        const CubicPiece piece(curves.point[a], curves.point[b]);
        builder.add(piece.at(u), glm::mix(curves.point[a].gradient, curves.point[b].gradient, u), lower,
                    piece.derivative(u));
    };
    for (std::int64_t c = 0; c < curves.count(); ++c) {
        const std::int64_t first = curves.first[c];
        const std::int64_t count = curves.size_of(c);
        const bool closed = curves.closed[c] != 0;
        if (static_cast<double>(std::max(angle_on(side, of[c].least), angle_on(side, of[c].most))) < upper) continue;
        const auto wanted = [&](std::int64_t k) { return angle(first + k % count) >= lower; };
        std::int64_t begin = 0; // of a closed one a point that is too weak, if there is one
        while (closed && begin < count && wanted(begin)) ++begin;
        const bool whole = closed && begin == count;
        const std::int64_t stop = (whole || !closed ? 0 : begin) + count + (closed && !whole ? 1 : 0);
        for (std::int64_t k = whole ? 0 : closed ? begin : 0; k < stop;) {
            if (!wanted(k)) {
                ++k;
                continue;
            }
            std::int64_t end = k;
            while (end < stop && wanted(end)) ++end;
            if (k > 0 && !whole && !wanted(k - 1)) put_between(first + (k - 1) % count, first + k % count);
            for (std::int64_t i = k; i < end; ++i) put(first + i % count);
            if (end < stop) put_between(first + (end - 1) % count, first + end % count);
            builder.end(whole);
            k = end;
        }
    }
    return parts;
}

} // namespace hrbfnpr::curves
