// SPDX-License-Identifier: MIT
// Tests the inks that marks take from a palette: against plain formulas in double precision, and where strokes are cut.
#include "frame/field_values.h"
#include "frame/hatching.h"

#include <gtest/gtest.h>

#include <map>

namespace hrbfnpr::testing::inks_test {
namespace {

using frame::LayerStyle;
using frame::PaletteRule;

constexpr std::array palette{glm::vec4(0.85, 0.1, 0.1, 1), glm::vec4(0.1, 0.55, 0.2, 1), glm::vec4(0.1, 0.2, 0.8, 1),
                             glm::vec4(0.95, 0.8, 0.1, 1)};

double decoded(double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); }
double encoded(double c) { return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1.0 / 2.4) - 0.055; }
glm::dvec3 linear(const glm::dvec3& c) { return {decoded(c.x), decoded(c.y), decoded(c.z)}; }

// Oklab by its two matrices, from sRGB.
glm::dvec3 oklab(const glm::dvec3& srgb) {
    const glm::dvec3 c = linear(srgb);
    const glm::dmat3 to_lms(0.4122214708, 0.2119034982, 0.0883024619, 0.5363325363, 0.6806995451, 0.2817188376,
                            0.0514459929, 0.1073969566, 0.6299787005);
    const glm::dmat3 to_lab(0.2104542553, 1.9779984951, 0.0259040371, 0.7936177850, -2.4285922050, 0.7827717662,
                            -0.0040720468, 0.4505937099, -0.8086757660);
    const glm::dvec3 lms = to_lms * c;
    return to_lab * glm::dvec3(std::cbrt(lms.x), std::cbrt(lms.y), std::cbrt(lms.z));
}

int brute_force_nearest(const glm::dvec3& color, double& margin) {
    int best = -1;
    double least = 1e9, second = 1e9;
    for (std::size_t k = 0; k < palette.size(); ++k) {
        const double distance = glm::distance(oklab(color), oklab(glm::dvec3(glm::vec3(palette[k]))));
        if (distance < least) {
            second = least;
            least = distance;
            best = static_cast<int>(k);
        } else {
            second = std::min(second, distance);
        }
    }
    margin = second - least;
    return 1 + best;
}

class Inks : public ::testing::Test {
protected:
    Inks() {
        style.tone_curve = frame::ToneCurve::linear;
        style.tone_fade = 0.0F;
        style.palette = palette;
        layer.ink_field = "color";
    }
    const drawing::Drawing& draw(const frame::Camera& camera) {
        style.layers = std::span(&layer, 1);
        const std::array items{layered_item(set, style)};
        frame.draw(items, camera);
        return frame.drawing();
    }
    std::vector<int> drawn_inks() const { return inks_of_dots(frame.drawing(), frame.drawing().runs[0]); }
    glm::dvec3 color_of(std::int64_t i) const { return glm::dvec3(marks::vector_at(set.layers[0].fields[0].value, i)); }

    base::Runtime runtime;
    marks::PointSet set{runtime.memory};
    LayerStyle layer;
    frame::Style style = plain_style();
    DrawnFrame frame{runtime};
};

TEST_F(Inks, NearestInksAreNearestInOklab) {
    set = clustered(runtime, plane(runtime.memory, 90));
    add_field(
        set.layers[0], "color", marks::FieldKind::colour,
        [](const glm::dvec3& p) {
            return glm::dvec3(0.5 + 0.5 * p.x, 0.5 + 0.5 * p.y, 0.5 + 0.5 * std::sin(9.0 * p.x * p.y));
        },
        [](const glm::dvec3& p) { return p.x > 0.8 ? 0.4 : 0.7; });
    draw(front_camera(300, 300));
    ASSERT_EQ(frame.drawing().layers.size(), 1 + std::ssize(palette));
    const std::vector<int> inks = drawn_inks();
    std::map<int, int> counts;
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
        double margin = 0.0;
        const int expected = set.layers[0].position[3 * i] > 0.8F ? 0 : brute_force_nearest(color_of(i), margin);
        const int ink = inks[static_cast<std::size_t>(i)];
        ++counts[ink];
        if (expected > 0 && margin < 1e-5) continue;
        ASSERT_EQ(ink, expected) << i;
    }
    EXPECT_EQ(counts.size(), 1 + palette.size());
}

// The colour of a place is a mixture of three inks of the palette, whose shares change across the plane.
TEST_F(Inks, MixedInksHaveTheMeanOfTheColor) {
    set = clustered(runtime, plane(runtime.memory, 200));
    const auto shares = [](const glm::dvec3& p) {
        const double a = 0.5 + 0.45 * p.x, b = (1.0 - a) * (0.5 + 0.45 * p.y);
        return glm::dvec3(a, b, 1.0 - a - b);
    };
    const auto ink = [](std::size_t k) { return linear(glm::dvec3(glm::vec3(palette[k]))); };
    const auto mean = [&](const glm::dvec3& p) {
        return shares(p).x * ink(0) + shares(p).y * ink(1) + shares(p).z * ink(2);
    };
    add_field(set.layers[0], "color", marks::FieldKind::colour, [&](const glm::dvec3& p) {
        const glm::dvec3 c = mean(p);
        return glm::dvec3(encoded(c.x), encoded(c.y), encoded(c.z));
    });
    layer.palette_rule = PaletteRule::mixed;
    for (const float share : {1.0F, 0.3F}) {
        layer.share = share;
        draw(front_camera(300, 300));
        const std::vector<int> inks = drawn_inks();
        struct Sum {
            glm::dvec3 wanted{0.0}, got{0.0};
            double count = 0.0;
        };
        std::map<std::pair<int, int>, Sum> parts; // the plane in 4 x 4 parts
        for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
            if (inks[static_cast<std::size_t>(i)] < 0) continue;
            const glm::dvec3 p(marks::vector_at(set.layers[0].position, i));
            Sum& sum = parts[{static_cast<int>(2.0 * (p.x + 1.0)), static_cast<int>(2.0 * (p.y + 1.0))}];
            sum.wanted += mean(p);
            sum.got += ink(static_cast<std::size_t>(inks[static_cast<std::size_t>(i)] - 1));
            sum.count += 1.0;
        }
        EXPECT_EQ(parts.size(), 16U);
        for (const auto& [part, sum] : parts)
            EXPECT_LT(glm::length((sum.got - sum.wanted) / sum.count), 0.02) << part.first << ' ' << part.second;
    }
}

// The shares of red, green and blue tell hue and saturation. Inks that are lighter or darker than a colour keep them.
TEST_F(Inks, MixedInksHaveTheHueOfDarkerAndLighterColors) {
    set = clustered(runtime, plane(runtime.memory, 4));
    add_field(set.layers[0], "color", marks::FieldKind::colour, [](const glm::dvec3&) { return glm::dvec3(0.5); });
    const frame::InkChoice choice(set.layers[0], set.layers[0].fields[0], palette, PaletteRule::mixed);
    const auto ink = [](std::size_t k) { return linear(glm::dvec3(glm::vec3(palette[k]))); };
    const auto chromaticity = [](const glm::dvec3& c) { return c / (c.x + c.y + c.z); };
    for (std::size_t a = 0; a < palette.size(); ++a)
        for (std::size_t b = 0; b < palette.size(); ++b)
            for (const double share : {0.0, 0.3, 0.6})
                for (const double light : {0.1, 0.3, 0.6, 1.1}) {
                    const glm::dvec3 wanted = light * ((1.0 - share) * ink(a) + share * ink(b));
                    const glm::vec3 color(encoded(wanted.x), encoded(wanted.y), encoded(wanted.z));
                    glm::dvec3 sum(0.0);
                    constexpr int thresholds = 200;
                    for (int k = 0; k < thresholds; ++k)
                        sum += ink(choice.mixed(color, (static_cast<float>(k) + 0.5F) / thresholds) - 1U);
                    EXPECT_LT(glm::distance(chromaticity(sum), chromaticity(wanted)), 0.035)
                        << a << ' ' << b << ' ' << share << ' ' << light;
                }
}

// Greys have no hue, so they are mixed from black and white by their lightness.
TEST_F(Inks, MixedInksShowGreysByTheirLightness) {
    constexpr std::array greys{glm::vec4(0, 0, 0, 1), glm::vec4(1, 1, 1, 1), glm::vec4(0.8, 0.1, 0.1, 1)};
    set = clustered(runtime, plane(runtime.memory, 4));
    add_field(set.layers[0], "color", marks::FieldKind::colour, [](const glm::dvec3&) { return glm::dvec3(0.5); });
    const frame::InkChoice choice(set.layers[0], set.layers[0].fields[0], greys, PaletteRule::mixed);
    for (const double light : {0.0, 0.05, 0.2, 0.5, 0.9}) {
        const glm::vec3 color(static_cast<float>(encoded(light)));
        int white = 0;
        for (int k = 0; k < 200; ++k) {
            const int chosen = choice.mixed(color, (static_cast<float>(k) + 0.5F) / 200.0F);
            ASSERT_LE(chosen, 2);
            white += chosen == 2 ? 1 : 0;
        }
        EXPECT_NEAR(white / 200.0, light, 0.01);
    }
}

TEST_F(Inks, AColorOfThePaletteIsNotMixed) {
    set = clustered(runtime, plane(runtime.memory, 40));
    add_field(set.layers[0], "color", marks::FieldKind::colour,
              [](const glm::dvec3& p) { return glm::dvec3(glm::vec3(palette[p.x > 0.0 ? 3 : 1])); });
    layer.palette_rule = PaletteRule::mixed;
    draw(front_camera(300, 300));
    const std::vector<int> inks = drawn_inks();
    for (std::int64_t i = 0; i < set.layers[0].count(); ++i)
        EXPECT_EQ(inks[static_cast<std::size_t>(i)], set.layers[0].position[3 * i] > 0.0F ? 4 : 2);
}

TEST_F(Inks, MarksKeepTheirInksFromFrameToFrame) {
    set = clustered(runtime, sphere(runtime.memory, 5000));
    add_field(set.layers[0], "color", marks::FieldKind::colour, [](const glm::dvec3& p) { return 0.5 + 0.5 * p; });
    layer.palette_rule = PaletteRule::mixed;
    draw(front_camera(300, 300));
    const std::vector<int> first = drawn_inks();
    frame::Camera camera = front_camera(200, 200, 0.7);
    camera.view = frame::look_at({5.0, 2.0, 9.0}, glm::dvec3(0.0), {0.0, 1.0, 0.0});
    draw(camera);
    const std::vector<int> second = drawn_inks();
    int both = 0;
    for (std::size_t i = 0; i < first.size(); ++i) {
        if (first[i] < 0 || second[i] < 0) continue;
        ++both;
        EXPECT_EQ(first[i], second[i]);
    }
    EXPECT_GT(both, 200);
}

TEST_F(Inks, OtherLayersKeepTheirInks) {
    set = plane(runtime.memory, 20);
    add_stroke(set, marks::Kind::own, {{-0.5, 0, 0}, {0, 0, 0}, {0.5, 0, 0}}, {0, 0, 1});
    set = clustered(runtime, std::move(set));
    add_field(set.layers[0], "color", marks::FieldKind::colour,
              [](const glm::dvec3&) { return glm::dvec3(glm::vec3(palette[2])); });
    layer.ink[0] = 0.5F;
    draw(front_camera(200, 200));
    const drawing::Drawing& drawing = frame.drawing();
    ASSERT_EQ(drawing.layers.size(), 2 + std::ssize(palette));
    for (const Disc& disc : frame.discs())
        EXPECT_EQ(disc.color, disc.id <= 400 ? palette[2] : glm::vec4(0.5, 0, 0, 1)) << disc.id;
    EXPECT_FALSE(drawing.one_color);
}

// ---- Strokes

class InksOfHatch : public Hatch {
protected:
    InksOfHatch() {
        set = nested_plane(runtime.memory);
        cluster();
        style.palette = palette;
        darkness = [](const glm::dvec3&) { return 0.7; };
    }
    void color_by(const std::function<int(const glm::dvec3&)>& ink) {
        add_field(set.layers[0], "color", marks::FieldKind::colour, [&](const glm::dvec3& p) {
            return glm::dvec3(glm::vec3(palette[static_cast<std::size_t>(ink(p))]));
        });
        layer.ink_field = "color";
    }
    // Returns the sum of the lengths of the strokes of each ink, in pixels.
    std::map<int, double> lengths() const {
        std::map<int, double> sums;
        for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s)
            sums[frame.drawing().layers[frame.drawing().strokes[s].layer].ink_number] +=
                static_cast<double>(points_of(s).back().length);
        return sums;
    }
    void expect_cut_at_the_middle() {
        const double whole = static_cast<double>(size) * 2.0 / 2.5;
        const double apart = std::max(step * size / 2.5, 3.0);
        std::map<int, int> counts;
        for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s) {
            const auto points = points_of(s);
            const int ink = frame.drawing().layers[frame.drawing().strokes[s].layer].ink_number;
            ++counts[ink];
            EXPECT_EQ(points.front().length, 0.0F);
            double length = 0.0;
            for (std::size_t i = 1; i < points.size(); ++i) {
                length += static_cast<double>(std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y));
                EXPECT_NEAR(static_cast<double>(points[i].length), length, 1e-2);
            }
            EXPECT_NEAR(length, 0.5 * whole, 2.0 * apart);
            const double middle = 0.5 * size;
            const auto x = [](const StrokePoint& point) { return static_cast<double>(point.x); };
            EXPECT_NEAR(ink == 0 ? x(points.back()) : x(points.front()), middle, apart);
            for (const StrokePoint& point : points) EXPECT_GT((x(point) - middle) * (ink == 0 ? -1 : 1), -apart);
        }
        ASSERT_EQ(counts.size(), 2U);
        EXPECT_EQ(counts[0], counts[2]);
        EXPECT_GT(counts[0], 20);
    }
};

TEST_F(InksOfHatch, LinesAreCutWhereTheInkChanges) {
    color_by([](const glm::dvec3& p) { return p.x > 0.0 ? 2 : 0; });
    draw(front_camera(size, size));
    expect_cut_at_the_middle();
}

TEST_F(InksOfHatch, JoinedStrokesAreCutWhereTheInkChanges) {
    color_by([](const glm::dvec3& p) { return p.x > 0.0 ? 2 : 0; });
    layer.shape = frame::Shape::strokes;
    style.tone = frame::Tone::none;
    style.tone_curve = frame::ToneCurve::linear;
    style.tone_fade = 0.0F;
    draw(front_camera(size, size));
    expect_cut_at_the_middle();
}

TEST_F(InksOfHatch, TheInkIsThatOfTheUncutLines) {
    draw(front_camera(size, size));
    const double expected = plane_ink(1.25);
    color_by([](const glm::dvec3& p) { return (static_cast<int>(std::floor(7.0 * p.x)) & 1) != 0 ? 2 : 0; });
    draw(front_camera(size, size));
    EXPECT_NEAR(plane_ink(1.25), expected, 0.002 * expected);
}

TEST_F(InksOfHatch, PartsTooShortToDrawTakeTheInkOfTheirNeighbours) {
    color_by([](const glm::dvec3& p) { return std::abs(p.x) < 0.004 ? 2 : 0; });
    darkness = [](const glm::dvec3&) { return 1.0; };
    layer.hatch_spacing = 12.0F;
    draw(front_camera(size, size));
    const std::map<int, double> sums = lengths();
    ASSERT_EQ(sums.size(), 1U);
    EXPECT_EQ(sums.begin()->first, 0);
}

TEST_F(InksOfHatch, MixedLinesKeepOneInkWhereTheColorStays) {
    add_field(set.layers[0], "color", marks::FieldKind::colour, [](const glm::dvec3&) {
        const glm::dvec3 mean =
            0.5 * (linear(glm::dvec3(glm::vec3(palette[0]))) + linear(glm::dvec3(glm::vec3(palette[2]))));
        return glm::dvec3(encoded(mean.x), encoded(mean.y), encoded(mean.z));
    });
    draw(front_camera(size, size));
    const std::int64_t whole = frame.drawing().strokes.size();
    layer.ink_field = "color";
    layer.palette_rule = PaletteRule::mixed;
    draw(front_camera(size, size));
    EXPECT_EQ(frame.drawing().strokes.size(), whole);
    std::map<int, double> sums = lengths();
    EXPECT_NEAR(sums[0] / sums[2], 1.0, 0.2);
    EXPECT_EQ(sums.size(), 2U);
}

} // namespace
} // namespace hrbfnpr::testing::inks_test
