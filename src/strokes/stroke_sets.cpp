// SPDX-License-Identifier: MIT
#include "strokes/stroke_sets.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::strokes {
namespace {

// In separations: over this length a stroke's marks vote together, and no piece is shorter.
constexpr double shortest_piece = 4.0;

// For set 0 above 0, for set 1 below.
double vote(const StrokePoint& point, const surface::DirectionField& lines) noexcept {
    const glm::dvec3 line = lines.at(point.position, point.normal, point.direction, false).direction;
    if (glm::dot(line, line) < 0.5) return 0.0;
    const double cosine = glm::dot(line, point.direction);
    return cosine * cosine - 0.5;
}

class Splitting {
public:
    Splitting(base::Memory& memory, std::int64_t shortest) noexcept : shortest_(shortest), sums_(memory) {}

    // Writes the set of each mark.
    void tell(const OrderedStroke& stroke, const surface::DirectionField& lines, std::uint8_t* set);

private:
    std::int64_t shortest_;
    base::Array<double> sums_; // of the votes before each mark
};

void Splitting::tell(const OrderedStroke& stroke, const surface::DirectionField& lines, std::uint8_t* set) {
    const std::int64_t count = stroke.count;
    sums_.resize(count + 1);
    sums_[0] = 0.0;
    for (std::int64_t i = 0; i < count; ++i) sums_[i + 1] = sums_[i] + vote(stroke.point[i * stroke.every], lines);
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t low = std::max<std::int64_t>(0, i - shortest_ / 2);
        const std::int64_t high = std::min(count, i + shortest_ / 2 + 1);
        set[i] = sums_[high] < sums_[low] ? 1 : 0;
    }
    // A piece that is too short goes to the one before it; the first one to all of the stroke.
    const std::uint8_t whole = sums_[count] < 0.0 ? 1 : 0;
    for (std::int64_t begin = 0; begin < count;) {
        std::int64_t end = begin;
        while (end < count && set[end] == set[begin]) ++end;
        if (end - begin < shortest_) std::fill(set + begin, set + end, begin > 0 ? set[begin - 1] : whole);
        begin = end;
    }
}

} // namespace

base::Array<OrderedStroke> split_by_set(const base::Runtime& runtime, const base::Array<OrderedStroke>& strokes,
                                        const surface::DirectionField& lines, double marks,
                                        const base::Progress& progress) {
    const auto shortest = static_cast<std::int64_t>(std::ceil(shortest_piece * marks));
    base::Array<std::int64_t> first(runtime.memory, strokes.size() + 1);
    for (std::int64_t s = 0; s < strokes.size(); ++s) first[s + 1] = first[s] + strokes[s].count;
    base::Array<std::uint8_t> set(runtime.memory, first.back());
    runtime.parallel.for_chunks(strokes.size(), 64, [&](std::int64_t begin, std::int64_t end) {
        progress.check();
        Splitting splitting(runtime.memory, shortest);
        for (std::int64_t s = begin; s < end; ++s) splitting.tell(strokes[s], lines, set.data() + first[s]);
    });
    base::Array<OrderedStroke> result(runtime.memory);
    for (std::int64_t s = 0; s < strokes.size(); ++s) {
        for (std::int64_t begin = 0; begin < strokes[s].count;) {
            const std::uint8_t* of = set.data() + first[s];
            std::int64_t end = begin;
            while (end < strokes[s].count && of[end] == of[begin]) ++end;
            OrderedStroke piece = strokes[s];
            piece.point += begin * piece.every;
            piece.count = end - begin;
            piece.set = of[begin];
            piece.closed = piece.closed && piece.count == strokes[s].count;
            piece.goes_on_before = begin > 0 || (strokes[s].closed && !piece.closed);
            piece.goes_on_after = end < strokes[s].count || (strokes[s].closed && !piece.closed);
            result.push_back(piece);
            begin = end;
        }
    }
    return result;
}

} // namespace hrbfnpr::strokes
