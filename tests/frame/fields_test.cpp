// SPDX-License-Identifier: MIT
// Tests what fields of scalars do to marks: against the rule for one mark, and against tones from a callback.
#include "frame/field_values.h"
#include "frame/hatching.h"
#include "support/runtime.h"

#include <gtest/gtest.h>

#include <set>

namespace hrbfnpr::testing::fields_test {
namespace {

using frame::FieldRule;
using frame::LayerStyle;

// A style in which a mark of the rank u is shown if 1 - u <= (1 - tau) share.
frame::Style linear_style() {
    frame::Style style = plain_style();
    style.tone_curve = frame::ToneCurve::linear;
    style.tone_fade = 0.0F;
    return style;
}

double ramp(const glm::dvec3& p) { return 0.5 * (p.x + 1.0); }
double waves(const glm::dvec3& p) { return 0.5 + 0.5 * std::sin(3.0 * p.x + 5.0 * p.y) * std::cos(4.0 * p.z); }
double patch(const glm::dvec3& p) { return p.y > 0.2 ? 0.75 : 0.0; }

class Fields : public ::testing::Test {
protected:
    const drawing::Drawing& draw(const marks::PointSet& set, const frame::Camera& camera) {
        style.layers = std::span(&layer, 1);
        const std::array items{layered_item(set, style)};
        frame.draw(items, camera);
        return frame.drawing();
    }
    // Checks which marks are drawn. share(mark) is the share of marks that is shown around the mark.
    void expect_shown(const marks::PointSet& set, const std::function<double(std::int64_t)>& share) {
        const std::vector<int> drawn = inks_of_dots(frame.drawing(), frame.drawing().runs[0]);
        const marks::Layer& own = set.layers[0];
        std::int64_t shown = 0;
        for (std::int64_t i = 0; i < own.count(); ++i) {
            const double rest = share(i) - (1.0 - static_cast<double>(own.rank[i]));
            shown += drawn[static_cast<std::size_t>(i)] >= 0;
            if (std::abs(rest) < 1e-5) continue;
            ASSERT_EQ(drawn[static_cast<std::size_t>(i)] >= 0, rest > 0.0) << i << ' ' << rest;
        }
        EXPECT_GT(shown, own.count() / 20);
        EXPECT_LT(shown, own.count() * 19 / 20);
    }
    [[nodiscard]] static glm::dvec3 place(const marks::PointSet& set, std::int64_t i) {
        return glm::dvec3(marks::vector_at(set.layers[0].position, i));
    }

    base::Runtime runtime;
    LayerStyle layer;
    frame::Style style = linear_style();
    DrawnFrame frame{runtime};
};

TEST_F(Fields, DensityMultipliesTheShareOfMarks) {
    marks::PointSet set = clustered(runtime, plane(runtime.memory, 150));
    add_scalar(set.layers[0], "density", ramp, patch);
    layer.density_field = "density";
    layer.share = 0.9F;
    draw(set, front_camera(400, 400));
    expect_shown(set, [&](std::int64_t i) {
        const glm::dvec3 p = place(set, i);
        return 0.9 * (1.0 + patch(p) * (ramp(p) - 1.0));
    });
}

TEST_F(Fields, DensityIsClamped) {
    marks::PointSet set = clustered(runtime, plane(runtime.memory, 100));
    add_scalar(set.layers[0], "density", [](const glm::dvec3& p) { return 4.0 * p.x; });
    layer.density_field = "density";
    layer.share = 0.5F;
    draw(set, front_camera(400, 400));
    expect_shown(set, [&](std::int64_t i) { return 0.5 * std::clamp(4.0 * place(set, i).x, 0.0, 1.0); });
}

TEST_F(Fields, MasksLeaveMarksOut) {
    marks::PointSet set = clustered(runtime, plane(runtime.memory, 150));
    add_scalar(set.layers[0], "mask", ramp, patch);
    layer.mask_field = "mask";
    draw(set, front_camera(400, 400));
    expect_shown(set, [&](std::int64_t i) {
        const glm::dvec3 p = place(set, i);
        return 1.0 + patch(p) * (ramp(p) - 1.0) < 0.5 ? 0.0 : 1.1;
    });
}

TEST_F(Fields, WidthsMultiplyRadii) {
    marks::PointSet set = clustered(runtime, plane(runtime.memory, 80));
    add_scalar(
        set.layers[0], "width", [](const glm::dvec3& p) { return std::max(0.0, 3.0 * p.x); }, patch);
    layer.width_field = "width";
    layer.radius = 1.5F;
    draw(set, front_camera(400, 400));
    std::set<std::uint32_t> seen;
    for (const Disc& disc : frame.discs()) {
        const glm::dvec3 p = place(set, disc.id - 1);
        const double factor = 1.0 + patch(p) * (std::max(0.0, 3.0 * p.x) - 1.0);
        EXPECT_NEAR(static_cast<double>(disc.radius), 1.5 * factor, 1e-4);
        seen.insert(disc.id);
    }
    EXPECT_EQ(std::ssize(seen), set.layers[0].count()) << "weights below 1 leave some width";
}

TEST_F(Fields, MarksWithoutWidthAreLeftOut) {
    marks::PointSet set = clustered(runtime, plane(runtime.memory, 40));
    add_scalar(set.layers[0], "width", [](const glm::dvec3& p) { return p.x > 0.0 ? 1.0 : -1.0; });
    layer.width_field = "width";
    draw(set, front_camera(400, 400));
    EXPECT_EQ(frame.discs().size(), 800U);
}

TEST_F(Fields, WideMarksReachIntoThePicture) {
    marks::PointSet set = clustered(runtime, plane(runtime.memory, 80));
    add_scalar(set.layers[0], "width", [](const glm::dvec3&) { return 9.0; });
    layer.width_field = "width";
    frame::Camera camera = front_camera(400, 400);
    camera.viewport = {0.0, 0.0, 100.0, 100.0};
    camera.projection = frame::orthographic(0.5, 100, 100, 1.0, 20.0, camera.depth);
    draw(set, camera);
    std::size_t expected = 0;
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
        const glm::dvec3 p = place(set, i);
        const double beyond = std::max(std::abs(p.x), std::abs(p.y)) * 200.0 - 50.0;
        expected += beyond < 9.0 + 0.5;
    }
    EXPECT_EQ(frame.discs().size(), expected);
}

// Compares a field that replaces the tone with a callback that gives the same tones.
struct FieldTone {
    static std::int32_t give(void*, std::int64_t count, const float* positions, const float*, float* tau) {
        for (std::int64_t i = 0; i < count; ++i)
            tau[i] = static_cast<float>(waves({positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]}));
        return 0;
    }
};

template <class T>
std::vector<T> copy_of(const base::Array<T>& array) {
    return {array.begin(), array.end()};
}

TEST_F(Fields, ReplacedTonesEqualThoseOfACallback) {
    marks::PointSet set = clustered(runtime, torus(runtime.memory, 40));
    add_scalar(set.layers[0], "tone", waves);
    style.tone_curve = frame::ToneCurve::coverage;
    style.tone_fade = 0.25F;
    style.tone = frame::Tone::callback;
    style.tone_function = FieldTone::give;
    draw(set, front_camera(500, 500, 1.6));
    const std::vector<Disc> expected(frame.discs().begin(), frame.discs().end());
    layer.tone_field = "tone";
    style.tone = frame::Tone::light;
    draw(set, front_camera(500, 500, 1.6));
    const auto discs = frame.discs();
    ASSERT_EQ(discs.size(), expected.size());
    EXPECT_GT(discs.size(), 1000U);
    for (std::size_t i = 0; i < discs.size(); ++i) {
        EXPECT_EQ(discs[i].id, expected[i].id);
        EXPECT_EQ(discs[i].radius, expected[i].radius);
    }
}

// The marks of clusters that are skipped would not have been drawn.
TEST_F(Fields, ScaledTonesAreThoseOfTheLightTimesTheField) {
    marks::PointSet set = clustered(runtime, sphere(runtime.memory, 30000));
    add_scalar(
        set.layers[0], "tone", [](const glm::dvec3& p) { return 1.5 * waves(p); },
        [](const glm::dvec3& p) { return p.x > 0.0 ? 1.0 : 0.6; });
    layer.tone_field = "tone";
    layer.tone_field_rule = FieldRule::scale;
    style.tone = frame::Tone::light;
    style.light = {0.0, 0.0, 1.0};
    style.light_space = frame::LightSpace::world;
    style.fill_light = 0.0F;
    draw(set, front_camera(400, 400));
    expect_shown(set, [&](std::int64_t i) {
        const glm::dvec3 p = place(set, i);
        const double weight = p.x > 0.0 ? 1.0 : 0.6;
        const double tau = std::min(1.0, std::max(0.0, p.z) * (1.0 + weight * (1.5 * waves(p) - 1.0)));
        return p.z > 0.0 ? 1.0 - tau : 0.0;
    });
}

TEST_F(Fields, DarkerTonesThanTheLightsAreNotCulled) {
    marks::PointSet set = clustered(runtime, sphere(runtime.memory, 30000));
    add_scalar(
        set.layers[0], "tone", [](const glm::dvec3&) { return 0.3; },
        [](const glm::dvec3& p) { return p.y > 0.0 ? 0.8 : 0.0; });
    layer.tone_field = "tone";
    style.tone = frame::Tone::light;
    style.light = {0.0, 0.0, 1.0};
    style.light_space = frame::LightSpace::world;
    style.fill_light = 0.0F;
    draw(set, front_camera(400, 400));
    expect_shown(set, [&](std::int64_t i) {
        const glm::dvec3 p = place(set, i);
        const double weight = p.y > 0.0 ? 0.8 : 0.0;
        return p.z > 0.0 ? 1.0 - (p.z + weight * (0.3 - p.z)) : 0.0;
    });
}

TEST_F(Fields, ThePublishedToneRuleUsesThem) {
    marks::PointSet set = clustered(runtime, plane(runtime.memory, 100));
    add_scalar(set.layers[0], "density", ramp);
    layer.density_field = "density";
    style.tone_rule = frame::ToneRule::published;
    draw(set, front_camera(400, 400));
    const std::vector<int> drawn = inks_of_dots(frame.drawing(), frame.drawing().runs[0]);
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
        const double rest = ramp(place(set, i)) - static_cast<double>(set.layers[0].rank[i]);
        if (std::abs(rest) < 1e-5) continue;
        ASSERT_EQ(drawn[static_cast<std::size_t>(i)] >= 0, rest > 0.0);
    }
}

// ---- Names

std::string message_of(const std::function<void()>& call) {
    try {
        call();
    } catch (const Error& error) {
        EXPECT_EQ(error.status(), Status::invalid_argument);
        return error.what();
    }
    return "";
}

TEST_F(Fields, AMissingFieldIsRefused) {
    const marks::PointSet set = clustered(runtime, plane(runtime.memory, 10));
    layer.density_field = "quality";
    EXPECT_EQ(message_of([&] { draw(set, front_camera(100, 100)); }),
              "items[0].style: density_field of the layer \"stipples\" is \"quality\", which is no field of "
              "items[0].point_set; add it by hrbfnpr_point_set_with_fields");
}

TEST_F(Fields, AFieldOfAnotherKindIsRefused) {
    marks::PointSet set = clustered(runtime, plane(runtime.memory, 10));
    add_field(set.layers[0], "color", marks::FieldKind::colour, [](const glm::dvec3& p) { return p; });
    layer.mask_field = "color";
    EXPECT_EQ(message_of([&] { draw(set, front_camera(100, 100)); }),
              "items[0].style: mask_field of the layer \"stipples\" is \"color\", a field of kind COLOUR; it must be a "
              "field of kind SCALAR");
}

TEST_F(Fields, LayersWithoutAFieldThatOthersHaveAreDrawnUnchanged) {
    marks::PointSet set = plane(runtime.memory, 20);
    add_stroke(set, marks::Kind::own, {{-0.5, 0, 0}, {0, 0, 0}, {0.5, 0, 0}}, {0, 0, 1});
    set = clustered(runtime, std::move(set));
    add_scalar(set.layers[0], "mask", [](const glm::dvec3&) { return 0.0; });
    layer.mask_field = "mask";
    draw(set, front_camera(200, 200));
    EXPECT_EQ(frame.discs().size(), 3U);
}

TEST_F(Fields, PublishedDrawingsHaveNone) {
    const marks::PointSet set = clustered(runtime, plane(runtime.memory, 10));
    layer.mask_field = "unknown";
    style.visibility = frame::Visibility::published;
    draw(set, front_camera(100, 100));
    EXPECT_FALSE(frame.discs().empty());
}

// ---- Hatching

class FieldsOfHatch : public Hatch {
protected:
    FieldsOfHatch() { set = nested_plane(runtime.memory); }

    void cluster_with(const char* name, const std::function<double(const glm::dvec3&)>& value) {
        cluster();
        add_scalar(set.layers[0], name, value);
    }
};

bool same_points(const std::vector<StrokePoint>& a, const std::vector<StrokePoint>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(StrokePoint)) == 0;
}

TEST_F(FieldsOfHatch, ReplacedTonesEqualThoseOfACallback) {
    cluster_with("tone", waves);
    style.tone_function = FieldTone::give;
    const std::vector<StrokePoint> expected = copy_of(draw(front_camera(size, size)).points);
    style.tone = frame::Tone::light; // Without the field, the plane would be white.
    style.light = {0.0, 0.0, 1.0};
    layer.tone_field = "tone";
    EXPECT_TRUE(same_points(copy_of(draw(front_camera(size, size)).points), expected));
    EXPECT_GT(expected.size(), 1000U);
}

TEST_F(FieldsOfHatch, DensityMultipliesTheDarkness) {
    cluster_with("density", [](const glm::dvec3& p) { return p.y > 0.3 ? 0.0 : 1.0 - waves(p); });
    darkness = [](const glm::dvec3& p) {
        return p.y > 0.3 ? 0.0 : static_cast<double>(static_cast<float>(1.0 - waves(p)));
    };
    const std::vector<StrokePoint> expected = copy_of(draw(front_camera(size, size)).points);
    style.tone = frame::Tone::none;
    layer.density_field = "density";
    const std::vector<StrokePoint> points = copy_of(draw(front_camera(size, size)).points);
    ASSERT_EQ(points.size(), expected.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        EXPECT_NEAR(static_cast<double>(points[i].radius), static_cast<double>(expected[i].radius), 1e-3);
}

TEST_F(FieldsOfHatch, LinesEndAtAMask) {
    cluster_with("mask", [](const glm::dvec3& p) { return p.x > 0.1 ? 1.0 : 0.0; });
    layer.mask_field = "mask";
    draw(front_camera(size, size));
    const double border = 0.5 * size + 0.1 * size / 2.5;
    const double apart = step * size / 2.5;
    double least = 1e9;
    for (const StrokePoint& point : frame.drawing().points) least = std::min(least, static_cast<double>(point.x));
    EXPECT_NEAR(least, border, apart);
    EXPECT_GT(frame.drawing().strokes.size(), 20);
}

TEST_F(FieldsOfHatch, WidthsAreMultiplied) {
    cluster_with("width", [](const glm::dvec3&) { return 0.5; });
    darkness = [](const glm::dvec3&) { return 0.7; };
    const std::vector<StrokePoint> expected = copy_of(draw(front_camera(size, size)).points);
    layer.width_field = "width";
    const double all = plane_ink(1.25);
    draw(front_camera(size, size));
    EXPECT_NEAR(plane_ink(1.25), 0.5 * all, 0.02 * all);
    EXPECT_FALSE(expected.empty());
}

TEST_F(FieldsOfHatch, JoinedStrokesEndAtAMask) {
    cluster_with("mask", [](const glm::dvec3& p) { return std::abs(p.x) > 0.1 ? 1.0 : 0.0; });
    layer.mask_field = "mask";
    layer.shape = frame::Shape::strokes;
    style.tone = frame::Tone::none;
    style.tone_curve = frame::ToneCurve::linear;
    style.tone_fade = 0.0F;
    draw(front_camera(size, size));
    EXPECT_EQ(frame.drawing().strokes.size(), 2 * 201);
    for (const StrokePoint& point : frame.drawing().points)
        EXPECT_GT(std::abs(static_cast<double>(point.x) - 0.5 * size), 0.0999 * size / 2.5);
}

TEST_F(FieldsOfHatch, ThreadsChangeNothing) {
    cluster_with("tone", waves);
    add_scalar(set.layers[0], "width", [](const glm::dvec3& p) { return 1.0 + p.x; });
    add_field(set.layers[0], "color", marks::FieldKind::colour, [](const glm::dvec3& p) { return p; });
    const std::array palette{glm::vec4(1, 0, 0, 1), glm::vec4(0, 0, 1, 1)};
    style.palette = palette;
    layer.tone_field = "tone";
    layer.width_field = "width";
    layer.ink_field = "color";
    const std::vector<StrokePoint> expected = copy_of(draw(front_camera(size, size)).points);
    base::Runtime other = test::with_threads(4);
    DrawnFrame again(other);
    const std::array items{layered_item(set, style)};
    again.draw(items, front_camera(size, size));
    EXPECT_TRUE(same_points(copy_of(again.drawing().points), expected));
}

} // namespace
} // namespace hrbfnpr::testing::fields_test
