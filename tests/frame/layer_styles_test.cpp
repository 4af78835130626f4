// SPDX-License-Identifier: MIT
// Tests sets of any number of layers; each layer uses the first style for its kind and name.
#include "frame/line_of_sight.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace hrbfnpr::testing::layer_styles_test {
namespace {

using frame::LayerStyle;
using marks::Kind;
using ::testing::ElementsAre;

// Adds one mark that faces the eye, in a separate layer.
marks::Layer& add_named(marks::PointSet& set, Kind kind, const char* name, double z) {
    marks::Layer& layer = set.layers.add(set.layers.memory(), kind);
    layer.name = {};
    std::memcpy(layer.name.data(), name, std::strlen(name));
    add_mark(layer, {0, 0, z}, {0, 0, 1}, {1, 0, 0}, 0, 0);
    if (kind != Kind::stipples) marks::index_strokes(layer);
    set.bounds.extend({0, 0, z});
    return layer;
}

LayerStyle named(Kind kind, const char* name, float radius) {
    LayerStyle style;
    style.kind = kind;
    style.name = name;
    style.radius = radius;
    style.ink[0] = radius / 10.0F;
    return style;
}

class LayerStyles : public ::testing::Test {
protected:
    void draw(std::span<const LayerStyle> styles, bool published = false) {
        frame::Style style;
        style.hidden_lines = frame::HiddenLines::show;
        style.tone = frame::Tone::none;
        style.tone_curve = frame::ToneCurve::linear;
        style.tone_fade = 0.0F;
        style.layers = styles;
        const std::array items{published ? item_of(set, style) : layered_item(set, style)};
        frame.draw(items, front_camera(100, 100));
    }
    // The radius of each mark, far to near.
    [[nodiscard]] std::vector<float> radii() const {
        std::vector<float> found;
        for (const Disc& disc : frame.discs()) found.push_back(disc.radius);
        return found;
    }
    void add_layers() {
        set.spacing = 0.1;
        add_named(set, Kind::stipples, "a", 0.0);
        add_named(set, Kind::stipples, "b", 0.1);
        add_named(set, Kind::stipples, "c", 0.2);
        add_named(set, Kind::stipples, "d", 0.3);
        add_named(set, Kind::stipples, "stipples", 0.4);
        add_named(set, Kind::hatch, "a", 0.5);
        add_named(set, Kind::own, "b", 0.6);
        set = clustered(runtime, std::move(set));
    }

    base::Runtime runtime;
    marks::PointSet set{runtime.memory};
    DrawnFrame frame{runtime};
};

TEST_F(LayerStyles, WithoutStylesAllLayersAreDrawn) {
    add_layers();
    for (const bool published : {false, true}) {
        draw({}, published);
        EXPECT_THAT(radii(), ElementsAre(1, 1, 1, 1, 1, 1, 1));
        EXPECT_EQ(frame.info().marks, 7);
        const std::int64_t each =
            published ? 2 : 1; // a layer of front marks, and with the published visibility one of contours
        ASSERT_EQ(frame.drawing().layers.size(), 7 * each);
        for (std::int64_t l = 0; l < 7 * each; ++l) {
            const drawing::Layer& layer = frame.drawing().layers[l];
            EXPECT_EQ(layer.item, 0);
            EXPECT_EQ(layer.layer, l / each);
            EXPECT_EQ(layer.mark_class, l % each == 0 ? drawing::MarkClass::front : drawing::MarkClass::silhouette);
            EXPECT_FALSE(layer.as_strokes);
        }
    }
}

TEST_F(LayerStyles, TheFirstMatchOfKindAndNameWins) {
    add_layers();
    for (const bool published : {false, true}) {
        const std::array styles{named(Kind::any, "b", 3.0F), named(Kind::stipples, "a", 4.0F),
                                named(Kind::stipples, nullptr, 2.0F), named(Kind::stipples, "c", 7.0F),
                                named(Kind::own, "b", 8.0F)};
        draw(styles, published);
        EXPECT_THAT(radii(), ElementsAre(4, 3, 2, 2, 2, 1, 3)) << published;
        for (const Disc& disc : frame.discs()) {
            EXPECT_EQ(disc.color.x, disc.radius == 1.0F ? 0.0F : disc.radius / 10.0F);
            EXPECT_EQ(frame.drawing().identify(disc.id).layer, disc.id - 1);
        }
    }
}

TEST_F(LayerStyles, NamesMustMatchCompletely) {
    add_layers();
    const std::array styles{named(Kind::any, "stipple", 5.0F), named(Kind::any, "stippless", 6.0F),
                            named(Kind::any, "", 7.0F), named(Kind::any, "stipples", 2.0F)};
    draw(styles);
    EXPECT_THAT(radii(), ElementsAre(1, 1, 1, 1, 2, 1, 1));
}

TEST_F(LayerStyles, CanHideAllLayersOfAKindExceptOne) {
    add_layers();
    LayerStyle hidden;
    hidden.kind = Kind::stipples;
    hidden.shown = hidden.contours = false;
    const std::array styles{named(Kind::stipples, "d", 2.0F), hidden};
    draw(styles);
    EXPECT_THAT(radii(), ElementsAre(2, 1, 1));
    ASSERT_EQ(frame.discs().size(), 3U);
    EXPECT_EQ(frame.discs()[0].id, 4U) << "ids count what is not drawn, too";
    EXPECT_EQ(frame.info().marks, 3);
}

TEST_F(LayerStyles, EveryLayerOfAKindHasItsOwnDirections) {
    for (int l = 0; l < 4; ++l) {
        marks::Layer& layer = set.layers.add(runtime.memory, Kind::hatch);
        layer.name = {};
        layer.name[0] = static_cast<char>('a' + l);
        for (std::uint32_t d = 0; d < 2; ++d) add_mark(layer, {0.1 * l, 0.1 * d, 0.0}, {0, 0, 1}, {1, 0, 0}, d, 0);
        marks::index_strokes(layer);
    }
    set.bounds.extend({0, 0, 0});
    set.bounds.extend({0.3, 0.1, 0});
    set.spacing = 0.1;
    set = clustered(runtime, std::move(set));
    std::array<LayerStyle, 4> styles;
    const char* const names[] = {"a", "b", "c", "d"};
    for (std::uint32_t l = 0; l < 4; ++l) {
        styles[l] = named(Kind::hatch, names[l], 1.0F);
        styles[l].directions = l;
    }
    draw(styles);
    std::vector<std::uint32_t> ids;
    for (const Disc& disc : frame.discs()) ids.push_back(disc.id);
    EXPECT_THAT(ids, ::testing::UnorderedElementsAre(3U, 6U, 7U, 8U));
}

// The layers whose marks made the splats.
std::vector<std::int32_t> splat_layers(const drawing::Drawing& drawing) {
    std::vector<std::int32_t> found;
    for (const drawing::IndexRange& piece : drawing.splat_ranges) {
        for (std::int64_t i = piece.begin; i < piece.end; ++i) {
            const drawing::Run* const run = drawing.run_of(drawing.splats[i].id);
            if (run == nullptr) {
                found.push_back(-1);
                break;
            }
            if (found.empty() || found.back() != run->layer) found.push_back(run->layer);
        }
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

class SplatLayer : public ::testing::Test {
protected:
    // Layer 0: very many own strokes; 1: few stipples; 2: own marks without strokes, a few more.
    explicit SplatLayer(bool own_marks = true) {
        marks::Layer& lines = set.layers.add(runtime.memory, Kind::own);
        for (std::uint32_t i = 0; i < 40000; ++i) {
            const glm::dvec3 n = spiral_direction(static_cast<int>(i), 40000);
            add_mark(lines, n, n, geometry::any_perpendicular(n), 2 * (i / 10), i % 10);
        }
        marks::index_strokes(lines);
        for (const Kind kind : {Kind::stipples, Kind::own}) {
            if (kind == Kind::own && !own_marks) break;
            marks::Layer& layer = set.layers.add(runtime.memory, kind);
            const int count = kind == Kind::own ? 2000 : 1500;
            for (int i = 0; i < count; ++i) {
                const glm::dvec3 n = spiral_direction(i, count);
                add_mark(layer, n, n, geometry::any_perpendicular(n), 0, 0);
            }
        }
        set.bounds.extend(glm::dvec3(-1.0));
        set.bounds.extend(glm::dvec3(1.0));
        set.spacing = std::sqrt(4.0 * pi / 40000.0);
        set = clustered(runtime, std::move(set));
    }
    std::vector<std::int32_t> with(std::span<const LayerStyle> styles) {
        frame::Style style;
        style.layers = styles;
        const std::array items{layered_item(set, style)};
        frame.draw(items, front_camera(300, 300));
        return splat_layers(frame.drawing());
    }
    static LayerStyle unused(Kind kind) {
        LayerStyle style;
        style.kind = kind;
        style.shown = style.contours = false;
        return style;
    }

    base::Runtime runtime;
    marks::PointSet set{runtime.memory};
    DrawnFrame frame{runtime};
};

TEST_F(SplatLayer, UsesOwnStrokesOnlyIfTheyAreAlone) {
    EXPECT_THAT(with({}), ElementsAre(1)) << "stipples, though there are a few more own marks";
    // Own marks have the same kind as own strokes here. All layers are used except the stipples.
    EXPECT_THAT(with(std::array{unused(Kind::stipples)}), ElementsAre(2));
    set.layers[2].rank.clear();
    set.layers[2].position.clear();
    set.layers[2].normal.clear();
    set.layers[2].direction.clear();
    set.layers[2].level.clear();
    set.layers[2].stroke.clear();
    set = clustered(runtime, std::move(set));
    EXPECT_THAT(with({}), ElementsAre(1));
    EXPECT_THAT(with(std::array{unused(Kind::stipples)}), ElementsAre(0)) << "alone";
    EXPECT_THAT(with(std::array{unused(Kind::own)}), ElementsAre(1));
    EXPECT_TRUE(with(std::array{unused(Kind::own), unused(Kind::stipples)}).empty());
    EXPECT_FALSE(frame.drawing().has_splats);
}

TEST_F(SplatLayer, IsUsedEvenIfItsInkIsHidden) {
    LayerStyle contours_only;
    contours_only.kind = Kind::stipples;
    contours_only.shown = false;
    EXPECT_THAT(with(std::array{contours_only}), ElementsAre(1));
}

// The dots of one layer, in the order of their ids.
std::vector<drawing::Dot> dots_of(const drawing::Drawing& drawing, std::int32_t layer) {
    std::vector<drawing::Dot> dots;
    for (const drawing::IndexRange& piece : drawing.dot_ranges)
        for (std::int64_t i = piece.begin; i < piece.end; ++i)
            if (const drawing::Dot& dot = drawing.dots[i];
                dot.opacity > 0.0F && drawing.layers[dot.layer].layer == layer)
                dots.push_back(dot);
    std::sort(dots.begin(), dots.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
    return dots;
}

// A line that a caller adds does not change the tone of the other layers.
TEST(OwnStrokes, DoNotChangeOtherLayers) {
    const base::Runtime runtime;
    const auto draw = [&](bool line, DrawnFrame& frame) {
        marks::PointSet set = sphere(runtime.memory, 20000);
        if (line) {
            marks::Layer& layer = set.layers.add(runtime.memory, Kind::own);
            for (std::uint32_t i = 0; i < 3000; ++i) {
                const double angle = 2.0 * pi * i / 3000.0;
                const glm::dvec3 n(std::cos(angle), std::sin(angle), 0.0); // all marks are on the contour
                add_mark(layer, n, n, {-n.y, n.x, 0.0}, 0, i);
            }
            marks::index_strokes(layer);
        }
        set = clustered(runtime, std::move(set));
        const std::array items{layered_item(set, frame::Style{})};
        frame.draw(items, front_camera(300, 300));
    };
    DrawnFrame plain(runtime);
    DrawnFrame with_line(runtime);
    draw(false, plain);
    draw(true, with_line);
    const std::vector<drawing::Dot> expected = dots_of(plain.drawing(), 0);
    const std::vector<drawing::Dot> got = dots_of(with_line.drawing(), 0);
    ASSERT_GT(expected.size(), 1000U);
    ASSERT_EQ(got.size(), expected.size());
    for (std::size_t i = 0; i < got.size(); ++i) {
        ASSERT_EQ(got[i].id, expected[i].id);
        ASSERT_EQ(got[i].radius, expected[i].radius);
        ASSERT_EQ(got[i].opacity, expected[i].opacity);
    }
    for (const drawing::Dot& dot : dots_of(with_line.drawing(), 1))
        EXPECT_EQ(dot.mark_class, drawing::MarkClass::front);
}

} // namespace
} // namespace hrbfnpr::testing::layer_styles_test
