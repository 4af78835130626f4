// SPDX-License-Identifier: MIT
// Tests that drawings compare their lines with rays, and repair parts that rays contradict.
#include "frame/hand_made.h"
#include "support/runtime.h"
#include "support/sharp_shapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstring>

namespace hrbfnpr::testing::line_verify_test {
namespace {

using drawing::LineCounts;
using drawing::Stroke;
using frame::HiddenParts;
using frame::LineKind;
using frame::LineStyle;

constexpr int size = 500;

LineStyle style_of(LineKind kind) {
    LineStyle style;
    style.kind = kind;
    style.hidden = HiddenParts::shown;
    style.taper = 0.0F;
    style.shortest = 0.0F;
    return style;
}

class LineVerify : public ::testing::Test {
protected:
    void look_at(const test::SharpShape& shape, double side, const glm::dvec3& direction) {
        curves::LineSetSettings settings;
        settings.side = side;
        const std::array<std::int64_t, 2> first{0, static_cast<std::int64_t>(own.size() / 3)};
        curves::LineRequest request;
        request.kind = LineKind::own;
        request.points = own;
        request.first = first;
        if (!own.empty()) settings.lines = {&request, 1};
        lines_ = std::make_unique<curves::LineSet>(runtime, shape, std::make_unique<implicit::DifferencedShape>(shape),
                                                   settings);
        camera_ = frame::fit_bounds(shape.bounds(), direction, {0, 0, 1}, 0.5, size, size, 0.05, {});
    }
    const drawing::Drawing& draw(bool verify) {
        frame::Item item = layered_item(set, frame::Style(), glm::dmat4(1.0));
        item.style.hidden_lines = frame::HiddenLines::show;
        item.style.tone = frame::Tone::none;
        item.style.layers = blank;
        item.style.lines = styles;
        item.style.halo_width = 0.0F;
        item.style.verify_lines = verify;
        item.lines = lines_.get();
        frame.draw(std::span(&item, 1), camera_);
        return frame.drawing();
    }
    // Returns the lengths of visible and of hidden strokes of a kind, in pixels.
    [[nodiscard]] std::array<double, 2> lengths_of(LineKind kind) const {
        std::array<double, 2> lengths{};
        for (const Stroke& stroke : frame.drawing().strokes)
            if (frame.drawing().layers[stroke.layer].line_kind == static_cast<std::uint32_t>(kind))
                lengths[stroke.hidden_layers > 0 ? 1 : 0] +=
                    static_cast<double>(frame.drawing().points[stroke.first + stroke.count - 1].length);
        return lengths;
    }

    base::Runtime runtime = test::with_threads(2);
    std::array<frame::LayerStyle, 1> blank{[] {
        frame::LayerStyle style;
        style.share = 0.0F;
        return style;
    }()};
    marks::PointSet set = clustered(runtime, sphere(runtime.memory, 200));
    std::vector<LineStyle> styles{style_of(LineKind::contour), style_of(LineKind::crease)};
    std::vector<double> own; // the places of an own line
    DrawnFrame frame{runtime};

private:
    std::unique_ptr<curves::LineSet> lines_;
    frame::Camera camera_;
};

TEST_F(LineVerify, RightLinesAgreeAndStayAsTheyAre) {
    const auto cube = test::sharp_cube(glm::dmat3(1.0));
    look_at(*cube, 0.1, {-0.8, 1.0, -0.6});
    const LineCounts plain = draw(false).line_counts;
    EXPECT_EQ(plain.pieces + plain.agreeing + plain.undecided + plain.repaired, 0);
    const std::int64_t strokes = frame.drawing().strokes.size();
    const std::vector<drawing::StrokePoint> points(frame.drawing().points.begin(), frame.drawing().points.end());
    const LineCounts counts = draw(true).line_counts;
    EXPECT_EQ(counts.pieces, 12); // the edges of the cube
    EXPECT_EQ(counts.agreeing, 12);
    EXPECT_EQ(counts.undecided, 0);
    EXPECT_EQ(counts.repaired, 0);
    EXPECT_EQ(frame.drawing().strokes.size(), strokes);
    ASSERT_EQ(frame.drawing().points.size(), static_cast<std::int64_t>(points.size()));
    EXPECT_EQ(std::memcmp(frame.drawing().points.data(), points.data(), points.size() * sizeof(drawing::StrokePoint)),
              0);
}

// A line of the caller may be inside the surface by a cell, so the thin end of a wedge does not hide a line on its far
// side. Rays find that it does.
TEST_F(LineVerify, PartsThatRaysContradictAreRepaired) {
    const geometry::Bounds box{glm::dvec3(-1.2), glm::dvec3(1.2)};
    const test::SharpShape wedge(
        box, test::max_of({test::plane({1, 0, 0}, 1.0), test::plane({-1, 0, 0}, 1.0), test::plane({0, 1, 0}, 1.0),
                           test::plane({0, -1, 0}, 1.0), test::plane({-0.25, 0, 1}, 0.27 / std::hypot(0.25, 1.0)),
                           test::plane({0, 0, -1}, 0.02)}));
    for (int i = 0; i <= 30; ++i)
        for (const double x : {-0.9 + 0.014 * i, 0.1, -0.02}) own.push_back(x);
    styles = {style_of(LineKind::own)};
    look_at(wedge, 0.2, {-0.1, 0.2, -1.0});
    draw(false);
    const std::array<double, 2> before = lengths_of(LineKind::own);
    ASSERT_GT(before[0], 20.0); // wrong: drawn as visible
    const LineCounts counts = draw(true).line_counts;
    const std::array<double, 2> after = lengths_of(LineKind::own);
    EXPECT_EQ(after[0], 0.0);
    EXPECT_NEAR(after[1], before[0] + before[1], 1.0);
    EXPECT_GT(counts.repaired, 0);
    EXPECT_EQ(counts.agreeing + counts.undecided, counts.pieces);
}

} // namespace
} // namespace hrbfnpr::testing::line_verify_test
