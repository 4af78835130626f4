// SPDX-License-Identifier: MIT
// Tests hatching of surfaces with creases: lines end at creases, and none steps over.
#include "generate/generate.h"
#include "support/runtime.h"
#include "support/sharp_shapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace hrbfnpr::hatching::creases_test {
namespace {

using namespace test;

base::Runtime& runtime() {
    static base::Runtime instance = with_threads(2);
    return instance;
}

struct Found {
    int marks = 0, strokes = 0;
    int off = 0;           // marks that are not on the surface
    int askew = 0;         // marks whose normal or direction is not that of their sheet
    int over = 0;          // steps from one sheet to another, except onto a crease
    int turned = 0;        // first and last marks whose normal is of another sheet than their neighbour's
    double farthest = 0.0; // the longest step, in mean steps
    int shy = 0;           // ends that are nearer to a crease than half a step, and not on it
    int at_crease = 0;     // ends on a crease
};

Found look_at(const SharpShape& shape) {
    generate::Settings settings;
    settings.layers.resize(1);
    settings.layers[0].kind = marks::Kind::hatch;
    settings.layers[0].budget = 8000;
    const marks::PointSet set = generate::generate(runtime(), shape, {}, settings);
    const marks::Layer& layer = set.layers[0];
    const auto at = [&](const base::Array<float>& numbers, std::int64_t i) {
        return glm::dvec3(static_cast<double>(numbers[3 * i]), static_cast<double>(numbers[3 * i + 1]),
                          static_cast<double>(numbers[3 * i + 2]));
    };
    Found found;
    found.marks = static_cast<int>(layer.count());
    double sum = 0.0;
    for (std::int64_t s = 0; s < layer.strokes(); ++s) {
        ++found.strokes;
        for (std::int64_t k = layer.stroke_first[s]; k < layer.stroke_first[s + 1]; ++k) {
            const std::int64_t i = layer.mark_of(k);
            const glm::dvec3 p = set.origin + at(layer.position, i);
            const Field field = shape.at(p);
            const glm::dvec3 normal = at(layer.normal, i);
            found.off += std::abs(field.value) > 1e-5 ? 1 : 0;
            double best = -1.0; // beside a crease the normal may be that of either sheet
            for (std::int32_t sheet = 0; sheet < shape.count(); ++sheet) {
                const Field own = shape.sheet_at(sheet, p);
                if (std::abs(own.value) < 1e-5) best = std::max(best, glm::dot(glm::normalize(own.gradient), normal));
            }
            found.askew += best < 0.999 || std::abs(glm::dot(at(layer.direction, i), normal)) > 1e-3 ? 1 : 0;
            if (k == layer.stroke_first[s]) continue;
            const std::int64_t before = layer.mark_of(k - 1);
            const glm::dvec3 way = p - (set.origin + at(layer.position, before));
            sum += glm::length(way);
            found.farthest = std::max(found.farthest, glm::length(way));
            bool on_one = false;
            for (std::int32_t sheet = 0; sheet < shape.count(); ++sheet)
                on_one = on_one || (std::abs(shape.sheet_at(sheet, p).value) < 1e-5 &&
                                    std::abs(shape.sheet_at(sheet, p - way).value) < 1e-5);
            found.over += on_one ? 0 : 1;
            const bool ends = k == layer.stroke_first[s] + 1 || k + 1 == layer.stroke_first[s + 1];
            found.turned += ends && glm::dot(normal, at(layer.normal, before)) < 0.9 ? 1 : 0;
        }
    }
    const double step = sum / std::max(1, found.marks - found.strokes);
    found.farthest /= step;
    for (std::int64_t s = 0; s < layer.strokes(); ++s)
        for (const std::int64_t k : {layer.stroke_first[s], layer.stroke_first[s + 1] - 1}) {
            const std::int64_t i = layer.mark_of(k);
            const glm::dvec3 p = set.origin + at(layer.position, i);
            double nearest = 1e9; // distance from the sheets that face another way
            for (std::int32_t sheet = 0; sheet < shape.count(); ++sheet)
                if (const Field own = shape.sheet_at(sheet, p); glm::dot(own.gradient, at(layer.normal, i)) < 0.9)
                    nearest = std::min(nearest, std::abs(own.value));
            found.at_crease += nearest < 1e-5 ? 1 : 0;
            found.shy += nearest > 1e-5 && nearest < 0.5 * step ? 1 : 0;
        }
    return found;
}

void expect_clean(const SharpShape& shape, const char* name) {
    SCOPED_TRACE(name);
    const Found found = look_at(shape);
    EXPECT_GT(found.marks, 6000);
    EXPECT_EQ(found.off, 0);
    EXPECT_EQ(found.askew, 0);
    EXPECT_EQ(found.over, 0);
    EXPECT_EQ(found.turned, 0);
    EXPECT_LE(found.farthest, 2.0);
    // Lines end on creases, except for a few that barely meet a crease.
    EXPECT_LE(found.shy, 2 * found.strokes / 16);
    EXPECT_GE(found.at_crease, found.strokes);
}

TEST(LinesAtCreases, DoNotCrossTheCreases) {
    expect_clean(*sharp_cube(), "cube");
    expect_clean(*bored_cube(), "bored cube");
    expect_clean(*stepped_shaft(), "shaft");
    expect_clean(*two_balls(true), "joined balls");
    expect_clean(*two_balls(false), "balls in common");
    expect_clean(*capped_cone(), "cone");
}

} // namespace
} // namespace hrbfnpr::hatching::creases_test
