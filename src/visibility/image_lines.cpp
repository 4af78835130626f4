// SPDX-License-Identifier: MIT
#include "visibility/image_lines.h"

#include "base/list.h"

#include <cmath>

namespace hrbfnpr::visibility {
namespace {

constexpr std::int64_t pieces_a_task = 256;
constexpr int deepest = 8;         // halvings of a piece
constexpr double farthest = 1.0e9; // pixels: what is seen beyond is too near to the plane of the eye

class Sampler {
public:
    Sampler(const curves::View& view, const curves::CubicPiece& cubic, std::int32_t piece, double tolerance,
            base::Array<ImagePoint>& points) noexcept
        : view_(view), cubic_(cubic), piece_(piece), tolerance_(tolerance), points_(points) {}

    // Its first point, and those between its ends.  At least one of these: an S may cross its chord in the middle.
    void run() {
        const glm::dvec2 a = at(0.0);
        const glm::dvec2 m = at(0.5);
        const glm::dvec2 b = at(1.0);
        add(0.0, a);
        split(0.0, a, 0.5, m, deepest);
        if (glm::distance(a, b) > 0.5 || !on_chord(a, m, b)) add(0.5, m);
        split(0.5, m, 1.0, b, deepest);
    }

private:
    [[nodiscard]] glm::dvec2 at(double u) const noexcept {
        return glm::clamp(see(view_, cubic_.at(u)).place, -farthest, farthest);
    }
    void add(double u, const glm::dvec2& place) { points_.push_back({place, piece_, u}); }
    void split(double u, const glm::dvec2& a, double v, const glm::dvec2& b, int left) {
        const double middle = 0.5 * (u + v);
        const glm::dvec2 m = at(middle);
        if (left == 0 || on_chord(a, m, b)) return;
        split(u, a, middle, m, left - 1);
        add(middle, m);
        split(middle, m, v, b, left - 1);
    }
    // Whether m lies between the ends, and beside their chord no farther than the tolerance.
    [[nodiscard]] bool on_chord(const glm::dvec2& a, const glm::dvec2& m, const glm::dvec2& b) const noexcept {
        const glm::dvec2 chord = b - a;
        const glm::dvec2 way = m - a;
        const double length = glm::length(chord);
        if (!(length > tolerance_)) return glm::length(way) <= tolerance_;
        const double along = glm::dot(way, chord);
        return along >= 0.0 && along <= length * length &&
               std::abs(chord.x * way.y - chord.y * way.x) <= tolerance_ * length;
    }

    const curves::View& view_;
    const curves::CubicPiece& cubic_;
    std::int32_t piece_;
    double tolerance_;
    base::Array<ImagePoint>& points_;
};

class Drawer {
public:
    Drawer(std::span<const Subject> subjects, double tolerance, ImageLines& lines) noexcept
        : subjects_(subjects), tolerance_(tolerance), lines_(lines) {}

    // The parts of a curve that are before the eye.
    void add_curve(std::int32_t subject, std::int64_t curve) {
        const Subject& s = subjects_[static_cast<std::size_t>(subject)];
        const curves::Curves& curves = *s.curves;
        const std::int64_t pieces = curves.pieces_of(curve);
        const auto before_eye = [&](std::int64_t point) {
            const Seen at = see(s.view, curves.point[point].position);
            return at.w > 0.0 && std::abs(at.place.x) < farthest && std::abs(at.place.y) < farthest;
        };
        const auto seen = [&](std::int64_t k) {
            const std::int64_t at = curves.first[curve] + k;
            return before_eye(at) && before_eye(curves.next(curve, at));
        };
        std::int64_t hidden = -1; // a piece that is not seen
        for (std::int64_t k = 0; k < pieces && hidden < 0; ++k)
            if (!seen(k)) hidden = k;
        if (pieces == 0) return; // a point: its curve could not be followed
        if (hidden < 0) {
            add_line(subject, curve, 0, pieces, curves.closed[curve] != 0);
            return;
        }
        const bool closed = curves.closed[curve] != 0;
        const std::int64_t begin = closed ? hidden : 0;
        std::int64_t from = begin;
        for (std::int64_t k = begin; k < begin + pieces; ++k) {
            if (seen(k % pieces)) continue;
            if (k > from) add_line(subject, curve, from, k, false);
            from = k + 1;
        }
        if (begin + pieces > from) add_line(subject, curve, from, begin + pieces, false);
    }

private:
    void add_line(std::int32_t subject, std::int64_t curve, std::int64_t from, std::int64_t to, bool closed) {
        const Subject& s = subjects_[static_cast<std::size_t>(subject)];
        const curves::Curves& curves = *s.curves;
        Line line{subject, curve, lines_.pieces.size(), to - from, lines_.points.size(), 0, closed};
        const auto number = static_cast<std::int32_t>(lines_.lines.size());
        for (std::int64_t k = from; k < to; ++k) {
            const std::int64_t at = curves.first[curve] + k % curves.pieces_of(curve);
            const auto piece = static_cast<std::int32_t>(lines_.pieces.size());
            lines_.pieces.push_back({subject, number, at, curves.next(curve, at)});
            const curves::CubicPiece cubic(curves.point[at], curves.point[curves.next(curve, at)]);
            Sampler(s.view, cubic, piece, tolerance_, lines_.points).run();
        }
        const Piece& last = lines_.pieces[lines_.pieces.size() - 1];
        lines_.points.push_back({see(s.view, curves.point[last.b].position).place,
                                 static_cast<std::int32_t>(lines_.pieces.size() - 1), 1.0});
        line.points = lines_.points.size() - line.first_point;
        lines_.lines.push_back(line);
    }

    std::span<const Subject> subjects_;
    double tolerance_;
    ImageLines& lines_;
};

// Curves that one task draws.
struct Part {
    std::int32_t subject;
    std::int64_t begin, end;
};

// Of some pieces each, or one longer curve.
base::Array<Part> parts_of(base::Memory& memory, std::span<const Subject> subjects) {
    base::Array<Part> parts(memory);
    for (std::size_t s = 0; s < subjects.size(); ++s) {
        const curves::Curves& curves = *subjects[s].curves;
        std::int64_t pieces = pieces_a_task;
        for (std::int64_t c = 0; c < curves.count(); ++c) {
            if (pieces >= pieces_a_task) {
                parts.push_back({static_cast<std::int32_t>(s), c, c});
                pieces = 0;
            }
            pieces += curves.pieces_of(c);
            parts[parts.size() - 1].end = c + 1;
        }
    }
    return parts;
}

// The same numbers as if all had been drawn in turn.
void append(const ImageLines& some, ImageLines& all) {
    const std::int64_t lines = all.lines.size();
    const std::int64_t pieces = all.pieces.size();
    const std::int64_t points = all.points.size();
    for (Line line : some.lines) {
        line.first_piece += pieces;
        line.first_point += points;
        all.lines.push_back(line);
    }
    for (Piece piece : some.pieces) {
        piece.line += static_cast<std::int32_t>(lines);
        all.pieces.push_back(piece);
    }
    for (ImagePoint point : some.points) {
        point.piece += static_cast<std::int32_t>(pieces);
        all.points.push_back(point);
    }
}

} // namespace

Seen see(const curves::View& view, const glm::dvec3& p) noexcept {
    const glm::dvec4 q = view.to_window * glm::dvec4(p, 1.0);
    return {{q.x / q.w, q.y / q.w}, q.w};
}

ImageLines draw_lines(const base::Runtime& runtime, std::span<const Subject> subjects, double tolerance) {
    base::Array<Part> parts = parts_of(runtime.memory, subjects);
    base::List<ImageLines> drawn(runtime.memory);
    for (std::int64_t i = 0; i < parts.size(); ++i) drawn.add(runtime.memory);
    runtime.parallel.for_each(parts.size(), [&](std::int64_t i) {
        Drawer drawer(subjects, tolerance, drawn[i]);
        for (std::int64_t c = parts[i].begin; c < parts[i].end; ++c) drawer.add_curve(parts[i].subject, c);
    });
    ImageLines lines(runtime.memory);
    std::int64_t pieces = 0;
    std::int64_t points = 0;
    for (const ImageLines& some : drawn) {
        pieces += some.pieces.size();
        points += some.points.size();
    }
    lines.pieces.reserve(pieces);
    lines.points.reserve(points);
    for (const ImageLines& some : drawn) append(some, lines);
    return lines;
}

} // namespace hrbfnpr::visibility
