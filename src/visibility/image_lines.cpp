// SPDX-License-Identifier: MIT
// Draws curves in the image: the parts of curves before the eye become lines of cubics (add_curve), and each cubic is
// halved until its chords are near enough (draw_cubic). Lengths are measured along the polylines (Lengths).
#include "visibility/image_lines.h"

#include "base/list.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::visibility {
namespace {

// Whether m lies between the ends of a chord, and beside it by no more than the tolerance.
bool on_chord(const glm::dvec2& a, const glm::dvec2& m, const glm::dvec2& b, double tolerance) noexcept {
    const glm::dvec2 chord = b - a;
    const glm::dvec2 way = m - a;
    const double length = glm::length(chord);
    if (!(length > tolerance)) return glm::length(way) <= tolerance;
    const double along = glm::dot(way, chord);
    return along >= 0.0 && along <= length * length &&
           std::abs(chord.x * way.y - chord.y * way.x) <= tolerance * length;
}

// Adds the first point of a cubic and those between its ends; at least one of these, as an S may cross its chord in the
// middle.
void draw_cubic(const curves::View& view, const curves::CubicPiece& cubic, std::int32_t piece, double tolerance,
                base::Array<ImagePoint>& points) {
    const auto at = [&](double u) {
        return glm::clamp(see(view, cubic.at(u)).place, -visibility_tuning.farthest, visibility_tuning.farthest);
    };
    const auto split = [&](const auto& self, double u, const glm::dvec2& a, double v, const glm::dvec2& b,
                           int left) -> void {
        const double middle = 0.5 * (u + v);
        const glm::dvec2 m = at(middle);
        if (left == 0 || on_chord(a, m, b, tolerance)) return;
        self(self, u, a, middle, m, left - 1);
        points.push_back({m, piece, middle});
        self(self, middle, m, v, b, left - 1);
    };
    const glm::dvec2 a = at(0.0);
    const glm::dvec2 m = at(0.5);
    const glm::dvec2 b = at(1.0);
    points.push_back({a, piece, 0.0});
    split(split, 0.0, a, 0.5, m, visibility_tuning.deepest);
    if (glm::distance(a, b) > 0.5 || !on_chord(a, m, b, tolerance)) points.push_back({m, piece, 0.5});
    split(split, 0.5, m, 1.0, b, visibility_tuning.deepest);
}

// Adds a line of the pieces from one of a curve to another, which may lie beyond the end of a closed curve.
void add_line(const curves::Curves& curves, std::int32_t subject, std::int64_t curve, std::int64_t from,
              std::int64_t to, bool closed, ImageLines& lines) {
    HRBFNPR_ASSERT(from < to && from >= 0);
    const auto number = static_cast<std::int32_t>(lines.lines.size());
    lines.lines.push_back({subject, curve, lines.pieces.size(), to - from, 0, 0, closed});
    for (std::int64_t k = from; k < to; ++k) {
        const std::int64_t at = curves.first[curve] + k % curves.pieces_of(curve);
        lines.pieces.push_back({subject, number, at, curves.next(curve, at)});
    }
}

// Adds the parts of a curve that are before the eye. A curve of one point could not be followed, and has none.
void add_curve(const Subject& s, std::int32_t subject, std::int64_t curve, ImageLines& lines) {
    const curves::Curves& curves = *s.curves;
    const std::int64_t pieces = curves.pieces_of(curve);
    const auto before_eye = [&](std::int64_t point) {
        const Seen at = see(s.view, curves.point[point].position);
        return at.w > 0.0 && std::abs(at.place.x) < visibility_tuning.farthest &&
               std::abs(at.place.y) < visibility_tuning.farthest;
    };
    const auto seen = [&](std::int64_t k) {
        const std::int64_t at = curves.first[curve] + k % pieces;
        return before_eye(at) && before_eye(curves.next(curve, at));
    };
    if (pieces == 0) return;
    const bool closed = curves.closed[curve] != 0;
    std::int64_t begin = 0;
    while (begin < pieces && seen(begin)) ++begin;
    if (begin == pieces) return add_line(curves, subject, curve, 0, pieces, closed, lines);
    if (!closed) begin = 0;
    std::int64_t from = begin;
    for (std::int64_t k = begin; k <= begin + pieces; ++k) {
        if (k < begin + pieces && seen(k)) continue;
        if (k > from) add_line(curves, subject, curve, from, k, false, lines);
        from = k + 1;
    }
}

} // namespace

Seen see(const curves::View& view, const glm::dvec3& p) noexcept {
    const glm::dvec4 q = view.to_window * glm::dvec4(p, 1.0);
    return {{q.x / q.w, q.y / q.w}, q.w};
}

bool shows_inside(std::span<const Subject> subjects, const Piece& piece) noexcept {
    const Subject& subject = subject_of(subjects, piece);
    if (subject.sheets != 1) return false;
    const curves::CurvePoint& p = subject.curves->point[piece.a];
    const curves::CurvePoint& q = subject.curves->point[piece.b];
    return glm::dot(p.gradient + q.gradient, subject.view.sight(p.position)) > 0.0;
}

ImageLines draw_lines(const base::Runtime& runtime, std::span<const Subject> subjects, double tolerance) {
    HRBFNPR_ASSERT(tolerance > 0.0);
    ImageLines image(runtime.memory);
    for (std::size_t s = 0; s < subjects.size(); ++s)
        for (std::int64_t c = 0; c < subjects[s].curves->count(); ++c)
            add_curve(subjects[s], static_cast<std::int32_t>(s), c, image);
    base::List<base::Array<ImagePoint>> points(runtime.memory); // the points of each line's image
    for (std::int64_t l = 0; l < image.lines.size(); ++l) points.add(runtime.memory);
    runtime.parallel.for_each(image.lines.size(), [&](std::int64_t l) {
        const Line& line = image.lines[l];
        const Subject& subject = subjects[static_cast<std::size_t>(line.subject)];
        const std::int64_t last = line.first_piece + line.pieces - 1;
        for (std::int64_t p = line.first_piece; p <= last; ++p)
            draw_cubic(subject.view, cubic(subjects, image.pieces[p]), static_cast<std::int32_t>(p), tolerance,
                       points[l]);
        points[l].push_back({see(subject.view, subject.curves->point[image.pieces[last].b].position).place,
                             static_cast<std::int32_t>(last), 1.0});
    });
    std::int64_t count = 0;
    for (const base::Array<ImagePoint>& of_line : points) count += of_line.size();
    image.points.reserve(count);
    for (std::int64_t l = 0; l < image.lines.size(); ++l) {
        image.lines[l].first_point = image.points.size();
        image.lines[l].points = points[l].size();
        for (const ImagePoint& p : points[l]) image.points.push_back(p);
    }
    return image;
}

Lengths::Lengths(base::Memory& memory, const ImageLines& lines)
    : lines_(lines), length_(memory, lines.points.size()), first_(memory, lines.pieces.size()) {
    for (const Line& line : lines.lines) {
        HRBFNPR_ASSERT(line.points > 1 && line.first_point + line.points <= lines.points.size());
        double all = 0.0;
        const std::int64_t end = line.first_point + line.points;
        for (std::int64_t p = line.first_point; p < end; ++p) {
            if (p > line.first_point) all += glm::distance(lines.points[p - 1].place, lines.points[p].place);
            length_[p] = all;
        }
        for (std::int64_t p = end - 2; p >= line.first_point; --p) first_[lines.points[p].piece] = p;
    }
}

double Lengths::at(const Line& line, std::int64_t piece, double share) const noexcept {
    HRBFNPR_ASSERT(piece >= line.first_piece && piece < line.first_piece + line.pieces);
    const bool last = piece + 1 == line.first_piece + line.pieces;
    const std::int64_t end = last ? line.first_point + line.points - 1 : first_[piece + 1];
    const ImagePoint* const begin = lines_.points.data() + first_[piece];
    const ImagePoint* const next = std::upper_bound(begin + 1, lines_.points.data() + end, share,
                                                    [](double s, const ImagePoint& p) { return s < p.share; });
    const std::int64_t p = next - 1 - lines_.points.data();
    const double from = lines_.points[p].share;
    const double to = p + 1 == end ? 1.0 : lines_.points[p + 1].share;
    const double on_chord = to > from ? std::clamp((share - from) / (to - from), 0.0, 1.0) : 0.0;
    return length_[p] + on_chord * (length_[p + 1] - length_[p]);
}

std::int64_t Lengths::piece_at(const Line& line, double at) const noexcept {
    std::int64_t low = line.first_piece;
    std::int64_t high = line.first_piece + line.pieces;
    while (high - low > 1) {
        const std::int64_t middle = low + (high - low) / 2;
        (length_[first_[middle]] <= at ? low : high) = middle;
    }
    return low;
}

} // namespace hrbfnpr::visibility
