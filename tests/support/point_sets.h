// SPDX-License-Identifier: MIT
// Makes point sets, and has helpers that the tests of placing marks share.
#pragma once

#include "generate/generate.h"
#include "support/analytic.h"
#include "support/runtime.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace hrbfnpr::test {

using namespace marks;
using generate::LayerSettings;
using generate::SampleHint;

inline base::Runtime& runtime() {
    static base::Runtime instance;
    return instance;
}

inline base::InView view(const std::vector<double>& numbers, std::uint32_t components = 3) {
    return {reinterpret_cast<const std::byte*>(numbers.data()), static_cast<std::int64_t>(numbers.size() / components),
            std::int64_t{8} * components, base::Scalar::float64, components};
}

// Selects a layer: the first one of a kind, or the hatching with this name if hatching differs by its guide.
struct Which {
    Kind kind = Kind::stipples;
    LayerName name{};
    hatching::Guide guide = hatching::Guide::curvature;

    Which(Kind any) noexcept : kind(any) {} // NOLINT(google-explicit-constructor): the first of a kind
    Which(const char* called, hatching::Guide follows) noexcept : kind(Kind::hatch), guide(follows) {
        std::strncpy(name.data(), called, name.size() - 1);
    }
    [[nodiscard]] bool is(Kind other, const LayerName& called) const noexcept {
        return other == kind && (name[0] == '\0' || called == name);
    }
};
inline const Which principal{"principal", hatching::Guide::curvature};
inline const Which combing{"combing", hatching::Guide::combing};

// Returns the settings of a layer, and adds them if they do not exist.
inline LayerSettings& of(generate::Settings& settings, const Which& which) {
    for (LayerSettings& layer : settings.layers)
        if (which.is(layer.kind, layer.name)) return layer;
    LayerSettings& made = settings.layers.emplace_back();
    made.kind = which.kind;
    made.name = which.name;
    made.hatching.field.guide = which.guide;
    return made;
}

// Settings for the published recursion with these layers, without budgets.
inline generate::Settings recursion(std::initializer_list<Which> layers, std::int32_t levels) {
    generate::Settings settings;
    settings.distribution = Distribution::published;
    for (const Which& which : layers) {
        of(settings, which).budget = 0;
        of(settings, which).published.levels = levels;
    }
    return settings;
}

inline generate::Settings blue(std::initializer_list<Which> layers, std::int64_t budget, std::int32_t levels = 3) {
    generate::Settings settings = recursion(layers, levels);
    settings.distribution = Distribution::blue_noise;
    for (LayerSettings& layer : settings.layers) layer.budget = budget;
    return settings;
}

inline std::vector<double> six_seeds() { return {1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1}; }

inline std::vector<double> spiral_seeds(int n) {
    std::vector<double> points;
    for (int i = 0; i < n; ++i)
        for (const double c : spiral_point(i, n)) points.push_back(c);
    return points;
}

inline void use_points(generate::Settings& settings, const std::vector<double>& points) {
    settings.seeds.source = SeedSource::points;
    settings.seeds.points = view(points);
}

inline PointSet make(const implicit::Implicit& implicit, const generate::Settings& settings,
                     const SampleHint& samples = {}) {
    return generate::generate(runtime(), implicit, samples, settings);
}

// Returns the layer, or an empty one if the set does not have it.
inline const Layer& of(const PointSet& set, const Which& which) {
    static const Layer empty(runtime().memory);
    for (const Layer& layer : set.layers)
        if (which.is(layer.kind, layer.name)) return layer;
    return empty;
}

inline glm::dvec3 vec(const base::Array<float>& array, std::int64_t i) {
    return {double{array[3 * i]}, double{array[3 * i + 1]}, double{array[3 * i + 2]}};
}

inline glm::dvec3 position(const PointSet& set, const Layer& layer, std::int64_t i) {
    return set.origin + vec(layer.position, i);
}
inline glm::dvec3 position(const PointSet& set, const Which& which, std::int64_t i) {
    return position(set, of(set, which), i);
}

// Expects each mark in exactly one stroke, and the marks of a stroke in order.
inline void expect_strokes(const Layer& layer) {
    ASSERT_EQ(layer.stroke_first[0], 0U);
    ASSERT_EQ(layer.stroke_first[layer.strokes()], layer.count());
    std::vector<int> met(static_cast<std::size_t>(layer.count()), 0);
    for (std::int64_t s = 0; s < layer.strokes(); ++s) {
        ASSERT_LT(layer.stroke_first[s], layer.stroke_first[s + 1]);
        for (std::int64_t place = layer.stroke_first[s]; place < layer.stroke_first[s + 1]; ++place) {
            const std::int64_t mark = layer.mark_of(place);
            ++met[static_cast<std::size_t>(mark)];
            ASSERT_EQ(layer.stroke_of(mark), s);
            if (place == layer.stroke_first[s]) continue;
            const std::int64_t before = layer.mark_of(place - 1);
            ASSERT_EQ(layer.stroke[2 * mark], layer.stroke[2 * before]);
            ASSERT_GT(layer.stroke[2 * mark + 1], layer.stroke[2 * before + 1]);
        }
    }
    for (const int times : met) ASSERT_EQ(times, 1);
}

// Expects every mark on the surface and inside the set's bounds, and arrays of the right sizes and values.
inline void expect_sound(const PointSet& set, const Analytic& surface, double tolerance = 1e-6) {
    const double diagonal = surface.diagonal();
    for (const Layer& marks : set.layers) {
        ASSERT_EQ(marks.position.size(), 3 * marks.count());
        ASSERT_EQ(marks.stroke.size(), 2 * marks.count());
        ASSERT_EQ(marks.level.size(), marks.count());
        for (std::int64_t i = 0; i < marks.count(); ++i) {
            const glm::dvec3 p = position(set, marks, i);
            const Field field = surface.at(p);
            const glm::dvec3 n = vec(marks.normal, i);
            const glm::dvec3 d = vec(marks.direction, i);
            ASSERT_LE(std::abs(field.value), tolerance * diagonal) << i;
            ASSERT_NEAR(glm::distance(n, glm::normalize(field.gradient)), 0.0, 1e-5) << i;
            ASSERT_NEAR(glm::length(d), 1.0, 1e-6) << i;
            ASSERT_NEAR(glm::dot(d, n), 0.0, 1e-6) << i;
            ASSERT_TRUE(set.bounds.grown(1e-6 * diagonal).contains(p)) << i;
            ASSERT_GE(marks.rank[i], 0.0F);
            ASSERT_LT(marks.rank[i], 1.0F);
        }
        ASSERT_EQ(marks.has_strokes(), marks.kind != Kind::stipples && marks.count() > 0);
        if (marks.has_strokes()) expect_strokes(marks);
        for (const LevelReport& l : marks.report.level)
            EXPECT_EQ(l.attempted,
                      l.placed + l.dropped_not_converged + l.dropped_strayed + l.dropped_degenerate + l.dropped_budget);
    }
    const LevelReport& seeds = set.seeds;
    EXPECT_EQ(seeds.attempted,
              seeds.placed + seeds.dropped_not_converged + seeds.dropped_strayed + seeds.dropped_degenerate);
}

inline bool same_bits(const PointSet& a, const PointSet& b) {
    if (a.origin != b.origin || a.bounds.min != b.bounds.min || a.bounds.max != b.bounds.max || a.spacing != b.spacing)
        return false;
    if (a.layers.size() != b.layers.size()) return false;
    for (std::int64_t l = 0; l < a.layers.size(); ++l) {
        const Layer& x = a.layers[l];
        const Layer& y = b.layers[l];
        if (!same_bits(x.position, y.position) || !same_bits(x.normal, y.normal) ||
            !same_bits(x.direction, y.direction) || !same_bits(x.curvature, y.curvature) ||
            !same_bits(x.rank, y.rank) || !same_bits(x.level, y.level) || !same_bits(x.stroke, y.stroke) ||
            !same_bits(x.width, y.width) || !same_bits(x.tone_normal, y.tone_normal) ||
            !same_bits(x.stroke_first, y.stroke_first) || !same_bits(x.stroke_order, y.stroke_order))
            return false;
    }
    return true;
}

// Runs f and expects an Error with this status whose message has all of `words` in it.
template <class F>
void expect_error(Status status, std::initializer_list<const char*> words, F&& f) {
    try {
        f();
        FAIL() << "no error";
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), status) << error.what();
        for (const char* word : words) EXPECT_THAT(error.what(), ::testing::HasSubstr(word));
        EXPECT_LT(std::strlen(error.what()), 247U) << "cut off: " << error.what();
    }
}

} // namespace hrbfnpr::test
