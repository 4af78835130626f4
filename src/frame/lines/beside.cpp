// SPDX-License-Identifier: MIT
// Thins lines that run beside weightier lines. Two lines nearer to each other than a pen look like one fat or doubled
// line, so only one of them keeps its width.
//
// 1. sample_strokes places samples along the strokes in the window.
// 2. find_neighbours finds the segments of other strokes beside each sample. The room between the two lines
//    (share_without_room) and their weights (share_outweighed) give the share of its width that the sample would lose.
// 3. find_kept computes the share of its width that each sample keeps. A line that is thinned itself thins others less,
//    so a stack of many lines does not become one line. The shares are averaged along the strokes.
// 4. thin_strokes narrows the strokes, and leaves out parts without width.
//
// Each step changes smoothly with the picture, so lines fade when the camera moves.
#include "base/assert.h"
#include "frame/lines/lines.h"
#include "frame/lines/tuning.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace hrbfnpr::frame {
namespace {

using drawing::Stroke;
using drawing::StrokePoint;

// A place along a stroke.
struct Sample {
    glm::dvec2 place;
    double at; // the distance from the beginning of the stroke, in pixels
    double radius;
    std::int32_t stroke;
};

// A place of another stroke that thins a sample. It lies between two samples.
struct Neighbour {
    std::int64_t other;
    double share; // the share of the way from the sample `other` to the next one
    double lost;  // the share of the sample's width that is lost if the other stroke keeps its own
};

// The samples of all strokes. Those of stroke i have the indices from first[i] to first[i + 1].
struct Samples {
    explicit Samples(base::Memory& memory) noexcept : sample(memory), first(memory) {}
    base::Array<Sample> sample;
    base::Array<std::int64_t> first;

    [[nodiscard]] std::int64_t count(std::int64_t stroke) const noexcept { return first[stroke + 1] - first[stroke]; }
};

// Returns a number that rises smoothly from 0 at `low` to 1 at `high`.
double smooth_step(double low, double high, double x) noexcept {
    const double u = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

// Returns the rank of a kind of lines. Lines of a smaller rank are weightier. Kinds of rank -1 show data, such as
// heights or levels of light; they neither thin other lines nor are they thinned.
int rank_of(std::uint32_t kind) noexcept {
    switch (static_cast<LineKind>(kind)) {
    case LineKind::contour: return 0;
    case LineKind::border: return 1;
    case LineKind::crease: return 2;
    case LineKind::intersection: return 3;
    case LineKind::ridge:
    case LineKind::valley:
    case LineKind::apparent_ridge:
    case LineKind::suggestive_contour:
    case LineKind::tangent_edge: return 4;
    default: return -1;
    }
}

// Returns whether a stroke may be thinned beside another one. Hidden strokes thin nothing, because they may be dashed.
// Strokes of different inks, and those of several styles for the same lines, are drawn over each other on purpose.
bool may_be_thinned(const Stroke& stroke, const Stroke& other, std::span<const drawing::Layer> layers) noexcept {
    const drawing::Layer& its = layers[stroke.layer];
    const drawing::Layer& others = layers[other.layer];
    if (other.hidden_layers > 0 || its.ink != others.ink) return false;
    return stroke.layer == other.layer || its.item != others.item || its.line_kind != others.line_kind;
}

// ---- Samples

Sample sample_at(const StrokePoint& a, const StrokePoint& b, std::int32_t stroke, double share) noexcept {
    const auto mixed = [&](float from, float to) {
        return glm::mix(static_cast<double>(from), static_cast<double>(to), share);
    };
    return {{mixed(a.x, b.x), mixed(a.y, b.y)}, mixed(a.length, b.length), mixed(a.radius, b.radius), stroke};
}

// Returns for each layer 1 if its strokes thin others or are thinned: they have a rank and a halo. An item without
// halos keeps all its lines.
base::Array<std::uint8_t> layers_with_room(const LineInput& in, std::span<const drawing::Layer> layers) {
    base::Array<std::uint8_t> with_room(in.runtime.memory, static_cast<std::int64_t>(layers.size()));
    for (const DrawnSubject& drawn : in.traced.styles)
        if (drawn.halo > 0.0F && rank_of(layers[drawn.layer].line_kind) >= 0) with_room[drawn.layer] = 1;
    return with_room;
}

// Places samples along the strokes of layers with room, a step apart and at the end. Chords outside of the window have
// none, because a line that passes beside the eye may be immensely long.
Samples sample_strokes(const LineInput& in, const LineStrokes& strokes, std::span<const drawing::Layer> layers,
                       double step) {
    const base::Array<std::uint8_t> with_room = layers_with_room(in, layers);
    const glm::dvec4 window(in.scene.lens.viewport);
    Samples samples(in.runtime.memory);
    for (std::int64_t s = 0; s < strokes.strokes.size(); ++s) {
        const Stroke& stroke = strokes.strokes[s];
        samples.first.push_back(samples.sample.size());
        if (with_room[stroke.layer] == 0) continue;
        const StrokePoint* const point = strokes.points.data() + stroke.first;
        double next = 0.0; // the number of steps from the beginning to the next sample
        for (std::int32_t i = 0; i + 1 < stroke.count; ++i) {
            const StrokePoint& a = point[i];
            const StrokePoint& b = point[i + 1];
            const double begin = a.length;
            const double span = static_cast<double>(b.length) - begin;
            const ShareRange seen = chord_in_window({a.x, a.y}, {b.x, b.y}, window, 2.0 * step);
            if (!(seen.low < seen.high) || !(span > 0.0)) continue;
            next = std::max(next, std::ceil((begin + seen.low * span) / step));
            for (; next * step < begin + seen.high * span; next += 1.0)
                samples.sample.push_back(sample_at(a, b, static_cast<std::int32_t>(s), (next * step - begin) / span));
            if (i + 2 == stroke.count && !stroke.closed && seen.high >= 1.0)
                samples.sample.push_back(sample_at(a, b, static_cast<std::int32_t>(s), 1.0));
        }
    }
    samples.first.push_back(samples.sample.size());
    return samples;
}

// ---- Neighbours

// Returns the share of its width that a line loses for lack of room beside another line. `distance` is that between
// their middles. The room is measured from the edge of the other line, in radii of the line.
double share_without_room(double distance, double radius, double others_radius) noexcept {
    if (!(radius > 0.0)) return 0.0;
    const double room = (distance - others_radius) / radius;
    return std::clamp((line_tuning.full_room - room) / (line_tuning.full_room - line_tuning.least_room), 0.0, 1.0);
}

// Returns 1 if the other one of two lines is weightier, 0 if it is lighter, and a number between if both are nearly
// alike. Wider and longer lines are weightier. So are lines with a smaller number, which are older: they stay if a new
// line appears beside them. Of two parts of one line, the one to the right or below, away from the usual light, is
// weightier.
double share_outweighed(const Sample& line, const Stroke& stroke, double length, const Sample& other,
                        const Stroke& others_stroke, double others_length) noexcept {
    const double wider = std::log(std::max(1e-6, other.radius) / std::max(1e-6, line.radius));
    const double longer = std::log(std::max(1.0, others_length) / std::max(1.0, length));
    const glm::dvec2 way = other.place - line.place;
    const double distance = glm::length(way);
    const double side = distance > 0.0 ? (0.6 * way.x + 0.8 * way.y) / distance : 0.0;
    const double older = stroke.line == others_stroke.line ? side : stroke.line > others_stroke.line ? 1.0 : -1.0;
    return smooth_step(-1.0, 1.0,
                       line_tuning.weight_of_width * wider + line_tuning.weight_of_length * longer +
                           line_tuning.weight_of_age * older);
}

// What find_neighbours reads.
struct BesideInput {
    const LineStrokes& strokes;
    std::span<const drawing::Layer> layers;
    const Samples& samples;
    double reach; // the largest distance at which a line thins another one, in pixels

    [[nodiscard]] const Stroke& stroke_of(const Sample& sample) const noexcept {
        return strokes.strokes[sample.stroke];
    }
    [[nodiscard]] double length_of(const Stroke& stroke) const noexcept {
        return strokes.points[stroke.first + stroke.count - 1].length;
    }
    // Returns the direction of a stroke between a sample and the next one, or the one before at the end.
    [[nodiscard]] glm::dvec2 direction_at(std::int64_t sample) const noexcept {
        const std::int32_t stroke = samples.sample[sample].stroke;
        const std::int64_t last = samples.first[stroke + 1] - 1;
        const std::int64_t from = std::min(sample, last - 1);
        if (from < samples.first[stroke]) return glm::dvec2(0.0);
        const glm::dvec2 way = samples.sample[from + 1].place - samples.sample[from].place;
        const double length = glm::length(way);
        return length > 0.0 ? way / length : glm::dvec2(0.0);
    }
};

// Returns a weight that is 0 for two places of one stroke that follow each other closely, and 1 for other places.
double apart_along(const BesideInput& in, const Sample& a, const Sample& b) noexcept {
    if (a.stroke != b.stroke) return 1.0;
    const double least = line_tuning.least_apart * in.reach;
    double apart = std::abs(a.at - b.at);
    if (apart <= least) return 0.0;
    if (const Stroke& stroke = in.stroke_of(a); stroke.closed) apart = std::min(apart, in.length_of(stroke) - apart);
    return smooth_step(least, 2.0 * least, apart);
}

// Returns a weight that falls to 0 at the ends of an open stroke.
double inside_of_ends(const BesideInput& in, const Sample& place) noexcept {
    const Stroke& stroke = in.stroke_of(place);
    if (stroke.closed) return 1.0;
    return smooth_step(0.0, in.reach, std::min(place.at, in.length_of(stroke) - place.at));
}

// Returns the neighbour of a sample between the sample `other` and the next one. `lost` is 0 if it does not thin the
// sample.
Neighbour neighbour_at(const BesideInput& in, std::int64_t number, std::int64_t other) {
    Neighbour found{other, 0.0, 0.0};
    const Sample& line = in.samples.sample[number];
    const Sample& from = in.samples.sample[other];
    if (other + 1 >= in.samples.first[from.stroke + 1]) return found;
    const Sample& to = in.samples.sample[other + 1];
    const glm::dvec2 way = to.place - from.place;
    const double square = glm::dot(way, way);
    if (!(square > 0.0)) return found;
    found.share = std::clamp(glm::dot(line.place - from.place, way) / square, 0.0, 1.0);
    const auto mixed = [&](double a, double b) { return glm::mix(a, b, found.share); };
    const Sample beside{glm::mix(from.place, to.place, found.share), mixed(from.at, to.at),
                        mixed(from.radius, to.radius), from.stroke};
    const glm::dvec2 offset = beside.place - line.place;
    const double distance = glm::length(offset);
    if (!(distance < in.reach)) return found;
    // Only a line beside another one counts, not one that crosses it, or continues it beyond its end.
    const glm::dvec2 along = in.direction_at(number);
    const double sine = std::abs(along.x * way.y - along.y * way.x) / std::sqrt(square);
    const double ahead = distance > 0.0 ? std::abs(glm::dot(offset, way)) / (distance * std::sqrt(square)) : 0.0;
    const double parallel =
        1.0 - smooth_step(line_tuning.beside_sine, line_tuning.crossing_sine, std::max(sine, ahead));
    const Stroke& its = in.stroke_of(line);
    const Stroke& others = in.stroke_of(from);
    const int rank = rank_of(in.layers[its.layer].line_kind) - rank_of(in.layers[others.layer].line_kind);
    const double outweighed =
        its.hidden_layers > 0 || rank > 0 ? 1.0
        : rank < 0                        ? 0.0
                   : share_outweighed(line, its, in.length_of(its), beside, others, in.length_of(others));
    found.lost = share_without_room(distance, line.radius, beside.radius) * parallel * outweighed *
                 apart_along(in, line, beside) * inside_of_ends(in, beside);
    return found;
}

// The neighbours of sample i have the indices from first[i] to first[i + 1].
struct Neighbours {
    explicit Neighbours(base::Memory& memory) noexcept : neighbour(memory), first(memory) {}
    base::Array<Neighbour> neighbour;
    base::Array<std::int64_t> first;
};

Neighbours find_neighbours(base::Memory& memory, const BesideInput& in, double step) {
    const base::Array<Sample>& samples = in.samples.sample;
    // A segment may be nearer than the two samples at its ends.
    const double reach = in.reach + step;
    geometry::VecArray place(memory);
    for (const Sample& sample : samples) place.push_back({sample.place, 0.0});
    const geometry::PointGrid grid(place, reach);
    Neighbours found(memory);
    for (std::int64_t i = 0; i < samples.size(); ++i) {
        const Sample& sample = samples[i];
        const Stroke& stroke = in.stroke_of(sample);
        found.first.push_back(found.neighbour.size());
        grid.around(place[i], [&](std::int64_t at) {
            const std::int64_t number = grid.index(at);
            const Sample& other = samples[number];
            const glm::dvec2 way = other.place - sample.place;
            if (glm::dot(way, way) > reach * reach || !(apart_along(in, sample, other) > 0.0)) return;
            if (!may_be_thinned(stroke, in.stroke_of(other), in.layers)) return;
            const Neighbour neighbour = neighbour_at(in, i, number);
            if (neighbour.lost > 0.0) found.neighbour.push_back(neighbour);
        });
    }
    found.first.push_back(found.neighbour.size());
    return found;
}

// ---- Widths

// Averages the values of a stroke over `half` values to each side. A closed stroke continues at its beginning.
void average(std::span<double> values, std::int64_t half, bool closed, base::Array<double>& sums) {
    const auto count = static_cast<std::int64_t>(values.size());
    half = std::min(half, (count - 1) / 2);
    if (half < 1) return;
    sums.clear();
    sums.push_back(0.0);
    const auto value = [&](std::int64_t i) { return values[static_cast<std::size_t>((i + count) % count)]; };
    for (std::int64_t i = closed ? -half : 0; i < count + (closed ? half : 0); ++i)
        sums.push_back(sums[sums.size() - 1] + value(i));
    for (std::int64_t i = 0; i < count; ++i) {
        const std::int64_t low = closed ? i : std::max<std::int64_t>(0, i - half);
        const std::int64_t high = closed ? i + 2 * half + 1 : std::min(count, i + half + 1);
        values[static_cast<std::size_t>(i)] = (sums[high] - sums[low]) / static_cast<double>(high - low);
    }
}

// Returns for each sample the share of its width that it keeps.
base::Array<double> find_kept(const BesideInput& in, const Neighbours& neighbours, std::int64_t half) {
    const Samples& samples = in.samples;
    base::Array<double> kept(samples.sample.memory(), samples.sample.size());
    std::fill(kept.begin(), kept.end(), 1.0);
    base::Array<double> last(kept.memory(), kept.size());
    for (int round = 0; round < line_tuning.beside_rounds; ++round) {
        std::copy(kept.begin(), kept.end(), last.begin());
        for (std::int64_t i = 0; i < kept.size(); ++i) {
            double lost = 0.0;
            for (std::int64_t k = neighbours.first[i]; k < neighbours.first[i + 1]; ++k) {
                const Neighbour& other = neighbours.neighbour[k];
                lost = std::max(lost, other.lost * glm::mix(last[other.other], last[other.other + 1], other.share));
            }
            kept[i] = 1.0 - lost;
        }
    }
    base::Array<double> sums(kept.memory());
    for (std::int64_t s = 0; s < in.strokes.strokes.size(); ++s) {
        const std::span<double> its(kept.data() + samples.first[s], static_cast<std::size_t>(samples.count(s)));
        if (std::all_of(its.begin(), its.end(), [](double k) { return k == 1.0; })) continue;
        for (int pass = 0; pass < 2; ++pass) average(its, half, in.strokes.strokes[s].closed, sums);
    }
    return kept;
}

// ---- Strokes

// Writes the parts of a stroke that have width.
class PartWriter {
public:
    PartWriter(const Stroke& whole, LineStrokes& out) noexcept : whole_(whole), stroke_(whole), out_(out) {
        stroke_.first = out.points.size();
    }
    // Adds a point, whose width is already narrowed by the share `kept`.
    void put(const StrokePoint& point, double kept) {
        const bool has_width = kept > line_tuning.least_kept;
        if (!has_width) cut_ = true;
        if (has_width && !had_width_ && out_.points.size() == stroke_.first && before_) out_.points.push_back(*before_);
        if (has_width || had_width_) out_.points.push_back(point);
        if (!has_width && had_width_) end(drawing::Cap::round);
        had_width_ = has_width;
        before_ = point;
    }
    void finish() { end(whole_.cap_end); }

private:
    void end(drawing::Cap cap) {
        Stroke stroke = stroke_;
        stroke.count = static_cast<std::int32_t>(out_.points.size() - stroke.first);
        stroke.cap_end = cap;
        stroke.closed = whole_.closed && !cut_;
        if (stroke.count < 2) {
            out_.points.resize(stroke.first);
        } else {
            const float begin = out_.points[stroke.first].length;
            for (std::int64_t i = stroke.first; i < out_.points.size(); ++i) out_.points[i].length -= begin;
            stroke.depth = out_.points[stroke.first + stroke.count / 2].depth;
            out_.strokes.push_back(stroke);
        }
        stroke_.first = out_.points.size();
        stroke_.cap_begin = drawing::Cap::round;
    }

    const Stroke& whole_;
    Stroke stroke_; // the part that is being written
    LineStrokes& out_;
    std::optional<StrokePoint> before_;
    bool had_width_ = false;
    bool cut_ = false; // True if a part of the stroke has no width.
};

StrokePoint point_between(const StrokePoint& a, const StrokePoint& b, float share) noexcept {
    StrokePoint point = a;
    for (float StrokePoint::*const member :
         {&StrokePoint::x, &StrokePoint::y, &StrokePoint::radius, &StrokePoint::opacity, &StrokePoint::depth,
          &StrokePoint::window, &StrokePoint::pixels_per_unit, &StrokePoint::length})
        point.*member = glm::mix(a.*member, b.*member, share);
    return point;
}

// Narrows a stroke by the shares that its samples keep. Points are added where the share changes.
void thin_stroke(const Stroke& stroke, std::span<const StrokePoint> points, std::span<const Sample> samples,
                 std::span<const double> kept, LineStrokes& out) {
    HRBFNPR_ASSERT(!samples.empty() && samples.size() == kept.size() && points.size() > 1);
    PartWriter writer(stroke, out);
    std::size_t next = 0; // the first sample that is not before the current place
    const auto put = [&](StrokePoint point) {
        const auto at = static_cast<double>(point.length);
        while (next < samples.size() && samples[next].at < at) ++next;
        const std::size_t b = std::min(next, samples.size() - 1);
        const std::size_t a = next == 0 ? 0 : next - 1;
        const double span = samples[b].at - samples[a].at;
        const double share = span > 0.0 ? std::clamp((at - samples[a].at) / span, 0.0, 1.0) : 0.0;
        const double keeps = glm::mix(kept[a], kept[b], share);
        point.radius *= static_cast<float>(keeps);
        writer.put(point, keeps);
    };
    put(points.front());
    std::size_t sample = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const auto begin = static_cast<double>(points[i].length);
        const auto end = static_cast<double>(points[i + 1].length);
        while (sample < samples.size() && samples[sample].at <= begin) ++sample;
        for (; sample < samples.size() && samples[sample].at < end; ++sample) {
            const bool changes = (sample > 0 && kept[sample - 1] != kept[sample]) ||
                                 (sample + 1 < samples.size() && kept[sample + 1] != kept[sample]);
            if (!changes) continue;
            put(point_between(points[i], points[i + 1],
                              static_cast<float>((samples[sample].at - begin) / (end - begin))));
        }
        put(points[i + 1]);
    }
    writer.finish();
}

void thin_strokes(const BesideInput& in, const base::Array<double>& kept, LineStrokes& out) {
    for (std::int64_t s = 0; s < in.strokes.strokes.size(); ++s) {
        Stroke stroke = in.strokes.strokes[s];
        const std::span<const StrokePoint> points(in.strokes.points.data() + stroke.first,
                                                  static_cast<std::size_t>(stroke.count));
        const auto count = static_cast<std::size_t>(in.samples.count(s));
        const std::span<const double> its(kept.data() + in.samples.first[s], count);
        if (std::all_of(its.begin(), its.end(), [](double k) { return k == 1.0; })) {
            out.add_points(stroke, points);
            out.strokes.push_back(stroke);
        } else {
            thin_stroke(stroke, points, {in.samples.sample.data() + in.samples.first[s], count}, its, out);
        }
    }
}

} // namespace

void thin_lines_beside_others(const LineInput& in, std::span<const drawing::Layer> layers, LineStrokes& strokes) {
    double widest = 0.0; // pixels
    for (const StrokePoint& point : strokes.points) widest = std::max(widest, 2.0 * static_cast<double>(point.radius));
    if (!(widest > 0.0)) return;
    const double step = std::max(line_tuning.shortest_step, line_tuning.steps_beside_others * widest);
    const Samples samples = sample_strokes(in, strokes, layers, step);
    const double reach = 0.5 * (1.0 + line_tuning.full_room) * widest;
    const BesideInput beside{strokes, layers, samples, reach};
    const Neighbours neighbours = find_neighbours(in.runtime.memory, beside, step);
    if (neighbours.neighbour.empty()) return;
    const auto half = static_cast<std::int64_t>(std::round(line_tuning.beside_fade * widest / step));
    const base::Array<double> kept = find_kept(beside, neighbours, half);
    LineStrokes thinned(in.runtime.memory);
    thin_strokes(beside, kept, thinned);
    strokes = std::move(thinned);
}

} // namespace hrbfnpr::frame
