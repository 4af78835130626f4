// SPDX-License-Identifier: MIT
// How the marks of a picture change from one frame to the next: how many pop, and how many vanish.
#pragma once

#include "orbit.h"
#include "painter.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace bench {

struct Changes {
    double frames = 0.0;
    double shown = 0.0;    // marks in at least one of two consecutive frames, summed over pairs of frames
    double pops = 0.0;     // those whose ink changes by more than half of their full ink
    double removals = 0.0; // those whose ink falls from 1 % of the full ink or more to less

    [[nodiscard]] double pop_rate() const { return pops / shown; }
    [[nodiscard]] double removal_rate() const { return removals / shown; }
};

// Follows the marks of one point set from frame to frame.  A mark counts only if in both frames it faces the eye, away
// from the contour, and is in the picture.
class Follower {
public:
    Follower(const hrbfnpr_point_set* set, const Style& style) {
        const hrbfnpr_point_set_info info = info_of(set);
        for (std::int64_t layer = 0; layer < info.layers; ++layer) {
            std::int64_t count = 0;
            std::int64_t widths = 0;
            const float* position = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
            const float* normal = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count);
            const float* width = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_WIDTH, widths);
            const hrbfnpr_layer_style pen = style.of(layer_info(set, layer).kind);
            for (std::int64_t i = 0; i < count; ++i) {
                const glm::dvec3 place = glm::make_vec3(info.origin) + glm::dvec3(glm::make_vec3(position + 3 * i));
                const double radius = double{pen.radius} * (widths > 0 ? double{width[i]} : 1.0);
                marks_.push_back({place, glm::make_vec3(normal + 3 * i), ink_of(radius, double{pen.ink[3]}), radius});
            }
        }
    }

    [[nodiscard]] static double ink_of(double radius, double alpha) {
        return 3.14159265358979323846 * radius * radius * alpha;
    }

    // `original`: the mark of this set that each drawn mark is; empty if the drawing is of this set itself.
    void look(const hrbfnpr_camera& camera, const std::vector<Disc>& discs,
              const std::vector<std::uint32_t>& original = {}) {
        before_.swap(now_);
        now_.assign(marks_.size(), {});
        const Lens lens(camera);
        for (std::size_t i = 0; i < marks_.size(); ++i)
            now_[i].counts = lens.facing(marks_[i].place, marks_[i].normal) < -away &&
                             lens.holds(lens.image_of(marks_[i].place), marks_[i].radius);
        for (const Disc& disc : discs) {
            if (disc.is_paper != 0) continue;
            const std::size_t own = disc.id - 1;
            State& state = now_[original.empty() ? own : original[own]];
            state.ink += ink_of(double{disc.radius}, double{disc.color[3]});
        }
        changes_.frames += 1.0;
        if (before_.empty()) return;
        for (std::size_t i = 0; i < marks_.size(); ++i) compare(marks_[i].full, before_[i], now_[i]);
    }
    [[nodiscard]] const Changes& changes() const { return changes_; }

private:
    // Marks count from this |n . v| on: nearer to the contour, a mark appears and vanishes by the view alone.
    static constexpr double away = 0.25;

    struct Mark {
        glm::dvec3 place, normal;
        double full; // full ink, square pixels
        double radius;
    };
    struct State {
        double ink = 0.0;
        bool counts = false;
    };

    void compare(double full, const State& before, const State& now) {
        const double least = 0.01 * full;
        if (!before.counts || !now.counts || std::max(before.ink, now.ink) < least) return;
        changes_.shown += 1.0;
        if (std::abs(before.ink - now.ink) > 0.5 * full) changes_.pops += 1.0;
        if (before.ink >= least && now.ink < least) changes_.removals += 1.0;
    }

    std::vector<Mark> marks_;
    std::vector<State> before_, now_;
    Changes changes_;
};

// Returns the same marks with new random ranks; `original` gets the old number of each mark.
[[nodiscard]] inline scenes::PointSet rerolled(hrbfnpr_context* context, const hrbfnpr_point_set* set,
                                               std::uint64_t seed, std::vector<std::uint32_t>& original) {
    scenes::Check check;
    const hrbfnpr_point_set_info info = info_of(set);
    std::vector<std::uint32_t> order(static_cast<std::size_t>(info.marks)); // the marks in order of rank
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<std::uint32_t>(i);
    std::shuffle(order.begin(), order.end(), std::mt19937_64(seed));
    const float step = 1.0F / static_cast<float>(std::bit_ceil(order.size())); // each rank is an exact multiple
    std::vector<float> rank(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) rank[order[i]] = step * static_cast<float>(i);
    std::vector<std::vector<double>> places(static_cast<std::size_t>(info.layers));
    std::vector<hrbfnpr_layer_arrays> layers(places.size());
    std::size_t first = 0;
    for (std::size_t layer = 0; layer < layers.size(); ++layer) {
        const auto number = static_cast<std::int64_t>(layer);
        std::int64_t count = 0;
        std::int64_t widths = 0;
        const float* position = attribute<float>(set, number, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
        const float* width = attribute<float>(set, number, HRBFNPR_MARK_ATTRIBUTE_WIDTH, widths);
        const float* normal = attribute<float>(set, number, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count);
        for (std::int64_t i = 0; i < 3 * count; ++i) places[layer].push_back(info.origin[i % 3] + double{position[i]});
        hrbfnpr_layer_arrays& arrays = layers[layer];
        check(hrbfnpr_layer_arrays_init(&arrays, sizeof arrays));
        arrays.kind = layer_info(set, number).kind;
        arrays.position = view(places[layer]);
        arrays.normal = {normal, count, 0, HRBFNPR_SCALAR_FLOAT32, 3};
        arrays.rank = {rank.data() + first, count, 0, HRBFNPR_SCALAR_FLOAT32, 1};
        if (widths > 0) arrays.width = {width, count, 0, HRBFNPR_SCALAR_FLOAT32, 1};
        first += static_cast<std::size_t>(count);
    }
    hrbfnpr_point_set_desc desc;
    check(hrbfnpr_point_set_desc_init(&desc, sizeof desc));
    desc.layers = layers.data();
    desc.layer_count = info.layers;
    hrbfnpr_point_set* raw = nullptr;
    check(hrbfnpr_point_set_create(context, &desc, &raw, check.error()));
    scenes::PointSet made(raw);
    original.clear();
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        std::int64_t count = 0;
        const float* ranks = attribute<float>(raw, layer, HRBFNPR_MARK_ATTRIBUTE_RANK, count);
        for (std::int64_t i = 0; i < count; ++i) original.push_back(order[static_cast<std::size_t>(ranks[i] / step)]);
    }
    return made;
}

struct Way {
    int steps;
    double degrees, zoom; // per step
};

// Measures the changes along a camera path, with the same ranks in all frames or with new ones in each frame.
[[nodiscard]] inline Changes follow(hrbfnpr_context* context, const hrbfnpr_point_set* set, const Style& style,
                                    const Orbit& orbit, const Way& way, bool reroll,
                                    const hrbfnpr_shading* shading = nullptr) {
    Follower follower(set, style);
    Painter painter(context, set, style);
    painter.use(shading);
    for (int step = 0; step <= way.steps; ++step) {
        const hrbfnpr_camera camera = orbit.at(step * way.degrees, std::pow(way.zoom, step));
        scenes::PointSet other;
        std::vector<std::uint32_t> original;
        if (reroll) {
            other = rerolled(context, set, static_cast<std::uint64_t>(step) + 2, original);
            painter.use(other.get());
        }
        follower.look(camera, painter.discs(camera), original);
    }
    return follower.changes();
}

} // namespace bench
