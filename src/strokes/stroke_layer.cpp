// SPDX-License-Identifier: MIT
#include "strokes/stroke_layer.h"

#include "base/long_array.h"

#include <cmath>

namespace hrbfnpr::strokes {
namespace {

// All in separations of the pass.  A gap is split where both halves are wide enough for `seed_room`, and the new
// stroke goes on until a half is narrower than `test_room`: gaps end between these and twice these, and are a
// separation wide on average.  Measured for the smallest variation that still leaves strokes long.
constexpr double seed_room = 0.75;
constexpr double test_room = 0.70;
// A point this near to a stroke is not moved into the gap beside it: others stand better.
constexpr double least_room = 0.6;
// How far beside a stroke neighbours are looked for ...
constexpr double sight = 1.6;
// ... within this much along it.
constexpr double abreast = 0.3;
// Wider gaps are not split in halves: the new stroke keeps one separation from the nearer side.
constexpr double widest_split = 2.4;
// Places along a stroke from which its sides are looked at.
constexpr double side_places = 0.8;
// Points of strokes stand this densely in the grid.
constexpr double grid_points = 0.2;
// The shortest stroke: in separations of the last pass, and of its own.
constexpr double shortest = 2.5;
constexpr double shortest_of_pass = 0.75;

// The tightest circle that a stroke follows, in separations of the last pass: tighter ones belong to a singular
// point of the field.  And the sharpest turn from point to point, in radians.
constexpr double tightest = 0.55;
constexpr double sharpest = 0.5;

constexpr double buckets_per_separation = 8.0;
constexpr std::int64_t most_reserved = 4000000; // points

// One at least, and no more than numbers of steps can be.
std::int64_t whole_steps(double steps) noexcept {
    return static_cast<std::int64_t>(std::clamp(std::floor(steps), 1.0, 1e9));
}

class Layering {
public:
    Layering(base::Memory& memory, const surface::DirectionField& field, const LayerSettings& settings)
        : field_(field), settings_(settings), grid_(memory), tracer_(memory, field, grid_), seed_(memory),
          heap_(memory), layer_(memory) {
        for (std::int64_t i = 0; i < field.size(); ++i) box_.extend(field.position(i));
        // Growing step by step would ask the system for three times as much.
        layer_.point.reserve(std::min(settings.most_points, most_reserved));
    }

    void pass(int number, const base::Progress& progress);
    [[nodiscard]] Layer result() { return std::move(layer_); }
    [[nodiscard]] bool full() const noexcept { return layer_.point.size() >= settings_.most_points; }

private:
    struct Entry {
        std::int32_t bucket; // the widest gap first,
        std::int32_t sample; // then by the field's progressive order, so that each prefix is spread
        std::int64_t seed;

        [[nodiscard]] bool operator<(const Entry& other) const noexcept {
            if (bucket != other.bucket) return bucket < other.bucket;
            return sample != other.sample ? sample > other.sample : seed > other.seed;
        }
    };
    // To the nearest strokes that run alike; infinite where none is in sight.
    struct Room {
        double left, right;
    };

    void prepare(int number);
    void seed_from_samples(const base::Progress& progress);
    void seed_beside(std::int64_t number);
    [[nodiscard]] bool crowded(const StrokePoint& point, double room) const noexcept;
    [[nodiscard]] Room room_at(const StrokePoint& point) const noexcept;
    [[nodiscard]] std::int32_t move_to_middle(StrokePoint& point) const noexcept;
    void offer(StrokePoint point);
    void push(std::int32_t bucket, std::int64_t seed);
    bool lay(const StrokePoint& seed);

    const surface::DirectionField& field_;
    const LayerSettings& settings_;
    geometry::Bounds box_;
    StrokeGrid grid_;
    Tracer tracer_;
    base::Array<StrokePoint> seed_;
    base::Array<Entry> heap_;
    Layer layer_;
    double apart_ = 0.0; // of this pass
    TraceSettings trace_;
    int number_ = 0;
};

void Layering::prepare(int number) {
    number_ = number;
    apart_ = std::ldexp(settings_.separation, settings_.passes - 1 - number);
    trace_.step = settings_.step;
    trace_.test = test_room * apart_;
    trace_.longest = settings_.longest;
    trace_.thin = static_cast<std::int32_t>(whole_steps(grid_points * apart_ / settings_.step + 1e-9));
    trace_.least_cosine = std::cos(std::min(settings_.step / (tightest * settings_.separation), sharpest));
    trace_.turned = settings_.turned;
    trace_.region = settings_.region;
    grid_.reset(box_.grown(apart_), sight * apart_, trace_.progress);
    grid_.reserve(std::min(settings_.most_points, most_reserved) / trace_.thin);
    seed_.clear();
    heap_.clear();
    for (std::int64_t s = 0; s < layer_.stroke.size(); ++s) {
        trace_.progress.check();
        const Layer::Stroke& stroke = layer_.stroke[s];
        for (std::int64_t i = 0; i < stroke.count; i += trace_.thin)
            grid_.insert(layer_.point[stroke.begin + i], static_cast<std::int32_t>(s), static_cast<std::int32_t>(i));
    }
}

bool Layering::crowded(const StrokePoint& point, double room) const noexcept {
    bool found = false;
    grid_.around(point.position, room, [&](const StrokeGrid::Node& node) {
        const glm::dvec3 offset = node.point.position - point.position;
        found = squared_clearance(point, offset) < room * room && run_alike(node.point, point);
        return !found;
    });
    return found;
}

Layering::Room Layering::room_at(const StrokePoint& point) const noexcept {
    constexpr double far = 1e300;
    Room room{far, far};
    const double radius = sight * apart_;
    const glm::dvec3 side = glm::cross(point.normal, point.direction);
    grid_.around(point.position, radius, [&](const StrokeGrid::Node& node) {
        const glm::dvec3 offset = node.point.position - point.position;
        if (std::abs(glm::dot(offset, point.direction)) > abreast * apart_) return true;
        const double squared = glm::dot(offset, offset);
        if (!(squared < radius * radius) || !run_alike(node.point, point)) return true;
        double& beside = glm::dot(offset, side) > 0.0 ? room.left : room.right;
        beside = std::min(beside, squared);
        return true;
    });
    return {std::sqrt(room.left), std::sqrt(room.right)};
}

// Returns how wide the gap is that the point stands in, in buckets; -1 if it is too narrow.
std::int32_t Layering::move_to_middle(StrokePoint& point) const noexcept {
    if (crowded(point, least_room * apart_)) return -1; // most are, and few points tell
    const Room room = room_at(point);
    const double gap = room.left + room.right;
    if (gap < 2.0 * seed_room * apart_) return -1;
    double shift = 0.0; // to the left
    if (gap < widest_split * apart_)
        shift = 0.5 * (room.left - room.right);
    else if (std::min(room.left, room.right) < apart_)
        shift = room.left < room.right ? room.left - apart_ : apart_ - room.right;
    if (std::abs(shift) > 0.05 * apart_) {
        const glm::dvec3 side = glm::cross(point.normal, point.direction);
        if (!tracer_.settle(point.position + shift * side, point.normal, point.direction, settings_.turned, point))
            return -1;
    }
    if (crowded(point, 0.97 * seed_room * apart_)) return -1;
    return static_cast<std::int32_t>(std::min(gap / apart_, 2.0 * sight) * buckets_per_separation);
}

void Layering::push(std::int32_t bucket, std::int64_t seed) {
    const StrokePoint& point = seed_[seed];
    const std::int64_t sample = field_.at(point.position, point.normal, point.direction, settings_.turned).sample;
    heap_.push_back({bucket, static_cast<std::int32_t>(sample), seed});
    std::push_heap(heap_.begin(), heap_.end());
}

void Layering::offer(StrokePoint point) {
    const std::int32_t bucket = move_to_middle(point);
    if (bucket < 0) return;
    base::push_back_long(seed_, point, trace_.progress);
    push(bucket, seed_.size() - 1);
}

// A prefix of the samples that is dense enough for the pass; a cross gives a seed for each of its lines.
void Layering::seed_from_samples(const base::Progress& progress) {
    const double spacings = field_.spacing() / apart_;
    const double wanted = 8.0 * static_cast<double>(field_.size()) * spacings * spacings;
    const auto count = static_cast<std::int64_t>(std::clamp(wanted, 64.0, 1e15));
    for (std::int64_t i = 0; i < std::min(count, field_.size()); ++i) {
        if (i % 64 == 0) progress.check();
        const glm::dvec3 n = field_.normal(i);
        glm::dvec3 d = field_.direction(i);
        if (settings_.turned) d = glm::cross(n, d);
        StrokePoint point;
        if (tracer_.settle(field_.position(i), n, d, settings_.turned, point)) offer(point);
        if (field_.symmetry() == surface::Symmetry::line) continue;
        if (tracer_.settle(field_.position(i), n, glm::cross(n, d), settings_.turned, point)) offer(point);
    }
}

void Layering::seed_beside(std::int64_t number) {
    const Layer::Stroke& stroke = layer_.stroke[number];
    const std::int64_t every = whole_steps(side_places * apart_ / settings_.step);
    for (std::int64_t i = every / 2; i < stroke.count; i += every) {
        trace_.progress.check();
        const StrokePoint from = layer_.point[stroke.begin + i];
        const glm::dvec3 side = glm::cross(from.normal, from.direction);
        for (const double offset : {-apart_, apart_}) {
            StrokePoint point;
            if (tracer_.settle(from.position + 0.75 * offset * side, from.normal, from.direction, settings_.turned,
                               point))
                offer(point);
        }
    }
}

bool Layering::lay(const StrokePoint& seed) {
    const std::int64_t before = grid_.size();
    const std::int64_t number = layer_.stroke.size();
    tracer_.trace(seed, static_cast<std::int32_t>(number), trace_);
    const double length = static_cast<double>(tracer_.count() - 1) * settings_.step;
    double least = std::max(shortest * settings_.separation, shortest_of_pass * apart_);
    if (settings_.longest > 0.0) least = std::min(least, 0.6 * settings_.longest);
    if (length < least && !tracer_.closed()) {
        grid_.shrink(before);
        return false;
    }
    const std::int64_t begin = layer_.point.size();
    for (std::int64_t i = 0; i < tracer_.count(); ++i)
        base::push_back_long(layer_.point, tracer_.point(i), trace_.progress);
    layer_.stroke.push_back({begin, tracer_.count(), static_cast<std::uint8_t>(number_), tracer_.closed()});
    return true;
}

void Layering::pass(int number, const base::Progress& progress) {
    trace_.progress = progress;
    prepare(number);
    for (std::int64_t s = 0; s < layer_.stroke.size(); ++s) seed_beside(s);
    seed_from_samples(progress);
    while (!heap_.empty() && !full()) {
        progress.check();
        const Entry entry = heap_[0];
        std::pop_heap(heap_.begin(), heap_.end());
        heap_.resize(heap_.size() - 1);
        // What was laid since may have narrowed the gap.
        const std::int32_t bucket = move_to_middle(seed_[entry.seed]);
        if (bucket < 0) continue;
        if (bucket < entry.bucket)
            push(bucket, entry.seed);
        else if (lay(seed_[entry.seed]))
            seed_beside(layer_.stroke.size() - 1);
    }
}

} // namespace

Layer lay_strokes(base::Memory& memory, const surface::DirectionField& field, const LayerSettings& settings,
                  const base::Progress& progress) {
    Layering layering(memory, field, settings);
    for (int number = 0; number < settings.passes && !layering.full(); ++number) {
        layering.pass(number, progress);
        // Each pass lays about as much as all before it.
        progress.update(std::ldexp(1.0, number + 1 - settings.passes));
    }
    return layering.result();
}

} // namespace hrbfnpr::strokes
