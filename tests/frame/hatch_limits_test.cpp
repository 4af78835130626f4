// SPDX-License-Identifier: MIT
// Tests that marks that are certainly not drawn are skipped, and that this changes no result.
#include "frame/hatch/loops.h"
#include "frame/hatching.h"
#include "support/instruction_sets.h"
#include "support/runtime.h"

namespace hrbfnpr::testing::hatch_limits_test {
namespace {

// Nested lines that wind up round a ball, or closed ones around it. If the marks are not in order, limits are not used.
marks::PointSet wound_ball(base::Memory& memory, bool in_order, bool tone_normals, bool closed) {
    constexpr int lines = 60;
    constexpr int count = 301;
    marks::PointSet set(memory);
    marks::Layer& layer = layer_of(set, marks::Kind::own);
    for (int line = 0; line < lines; ++line) {
        for (int k = 0; k < count; ++k) {
            const int i = in_order ? k : (2 * k) % count; // each mark once
            const double around = 0.1 * line + (closed ? 2.0 * pi * i / count : 5.0 * i / (count - 1));
            const double height = -0.9 + 1.8 * (line + (closed ? 0.0 : 0.6 * i / (count - 1))) / lines;
            const double flat = std::sqrt(1.0 - height * height);
            const glm::dvec3 place(flat * std::cos(around), height, flat * std::sin(around));
            add_mark(layer, place, place, {-std::sin(around), 0.0, std::cos(around)}, 2U * static_cast<unsigned>(line),
                     static_cast<std::uint32_t>(i));
            layer.level[layer.count() - 1] = level_of(line - lines / 2);
            const glm::dvec3 tilted = glm::normalize(place + glm::dvec3(0.0, 0.2 * std::sin(9.0 * around), 0.0));
            for (int c = 0; tone_normals && c < 3; ++c) layer.tone_normal.push_back(static_cast<float>(tilted[c]));
            set.bounds.extend(place);
        }
    }
    marks::index_strokes(layer);
    EXPECT_EQ(layer.stroke_order.empty(), in_order);
    set_nesting(set, 1.8 / lines, finest);
    return set;
}

struct Shown {
    std::vector<float> numbers;
    std::int64_t strokes = 0;
    friend bool operator==(const Shown&, const Shown&) = default;
};

class HatchLimits : public Hatch {
protected:
    HatchLimits() {
        style.tone = frame::Tone::light;
        style.fill_light = 0.0F;
    }
    [[nodiscard]] Shown shown(const frame::Camera& camera) {
        draw(camera);
        Shown all;
        all.strokes = frame.drawing().strokes.size();
        for (std::int64_t s = 0; s < all.strokes; ++s)
            for (const StrokePoint& p : points_of(s))
                all.numbers.insert(all.numbers.end(), {p.x, p.y, p.radius, p.opacity, p.depth, p.window, p.length});
        return all;
    }
    [[nodiscard]] static frame::Camera camera(double angle, double distance) {
        frame::Camera camera;
        camera.view = frame::look_at({distance * std::sin(angle), 0.3, distance * std::cos(angle)}, glm::dvec3(0.0),
                                     {0.0, 1.0, 0.0});
        camera.projection = frame::perspective(0.6, size, size, 0.05, 50.0, camera.depth);
        camera.viewport = {0.0, 0.0, size, size};
        return camera;
    }
};

class HatchLimitsOfLines : public HatchLimits, public ::testing::WithParamInterface<bool> {};

TEST_P(HatchLimitsOfLines, DoNotChangeTheDrawing) {
    const bool closed = GetParam();
    for (const bool tone_normals : {false, true}) {
        for (const double exponent : {0.5, 1.0, 3.0}) {
            style.tone_exponent = exponent;
            layer.hatch_fade = exponent == 1.0 ? 0.1F : 0.0F;
            for (int view = 0; view < 12; ++view) {
                const frame::Camera from = view == 11 ? front_camera(size, size) : camera(0.6 * view, 1.3 + 0.5 * view);
                set = wound_ball(runtime.memory, true, tone_normals, closed);
                cluster();
                const Shown limited = shown(from);
                set = wound_ball(runtime.memory, false, tone_normals, closed);
                cluster();
                const Shown plain = shown(from);
                EXPECT_GT(plain.strokes, closed ? 5 : 10);
                EXPECT_TRUE(limited == plain) << tone_normals << ' ' << exponent << ' ' << view;
            }
        }
    }
}
INSTANTIATE_TEST_SUITE_P(OpenAndClosed, HatchLimitsOfLines, ::testing::Bool());

TEST(HatchLoops, FindTheMarksThatMayBeDrawn) {
    constexpr std::int64_t count = 29; // not a multiple of the vector width
    std::vector<float> normals;
    std::vector<float> tone_normals;
    for (int i = 0; i < 3 * int{count}; ++i) {
        normals.push_back(std::sin(1.7F * static_cast<float>(i)));
        tone_normals.push_back(std::cos(2.3F * static_cast<float>(i)));
    }
    const frame::HatchBounds bounds{{0.3F, -0.5F, 0.7F}, 0.2F, {-0.4F, 0.6F, 0.1F}, 0.1F};
    std::uint32_t expected = 0;
    const auto dot = [](const float(&a)[3], const float* v) { return a[0] * v[0] + a[1] * v[1] + a[2] * v[2]; };
    for (std::int64_t i = 0; i < count; ++i)
        if (dot(bounds.sight, normals.data() + 3 * i) <= bounds.away &&
            dot(bounds.light, tone_normals.data() + 3 * i) <= bounds.lightest)
            expected |= 1U << i;
    EXPECT_NE(expected, 0U);
    for (const base::InstructionSet set : test::instruction_sets())
        EXPECT_EQ(frame::hatch_loops(set).may_draw(bounds, normals.data(), tone_normals.data(), count), expected);
}

} // namespace
} // namespace hrbfnpr::testing::hatch_limits_test
