// SPDX-License-Identifier: MIT
// Tests that lines of hatching end at the edges that are drawn in front of them.
#include "frame/hatching.h"
#include "support/sharp_shapes.h"

#include <algorithm>
#include <memory>

namespace hrbfnpr::testing::hatch_cuts_test {
namespace {

constexpr double pixels = 200.0; // per unit
constexpr double half = 0.4;     // half side of the box, whose front is half a unit thick

// A box in front of lines in the plane z = 0. Only the edges of the box are drawn.
class HatchCuts : public Hatch {
protected:
    HatchCuts() {
        curves::LineSetSettings settings;
        settings.side = 0.1;
        lines_ = std::make_unique<curves::LineSet>(runtime, box_, std::make_unique<implicit::DifferencedShape>(box_),
                                                   settings);
        constexpr int side = 24; // splats are 6 pixels apart
        for (int i = 0; i < side; ++i) {
            for (int j = 0; j < side; ++j) {
                const auto u = base::uniform4(3, static_cast<std::uint64_t>(side * i + j), base::Purpose::candidate);
                const glm::dvec2 at =
                    half * (2.0 * (glm::dvec2(i, j) + 0.25 + 0.5 * glm::dvec2(u[0], u[1])) / double{side} - 1.0);
                add_stipple(front_, {at.x, at.y, 0.25}, {0.0, 0.0, 1.0});
                add_stipple(front_, {at.x, at.y, 0.24},
                            {0.0, 0.0, -1.0}); // so that it hides points just behind the front
            }
        }
        front_.spacing = 2.0 * half / side;
        front_ = clustered(runtime, std::move(front_));
        layer.radius = 0.5F;
        layer.hatch_shortest = 0.0F;
    }
    // Adds lines along x, a tenth of a unit apart.
    void add_lines(double apart) {
        for (int i = -9; i <= 9; ++i) add_line(set, {0.1 * i + 0.0171, -1.0, 1.0, 0}, apart);
        set_nesting(set, 0.1, 0);
        cluster();
    }
    void draw_box(double turn, double z, float halo) {
        frame::LayerStyle unseen;
        unseen.share = 0.0F;
        unseen.contours = false;
        std::array<frame::LineStyle, 2> both;
        both[0].kind = frame::LineKind::contour;
        both[1].kind = frame::LineKind::crease;
        style.hidden_lines = frame::HiddenLines::hide;
        style.halo_width = halo;
        frame::Style box = style;
        box.tone = frame::Tone::none;
        box.layers = std::span(&unseen, 1);
        box.lines = both;
        style.layers = std::span(&layer, 1);
        glm::dmat4 to_world(1.0);
        to_world[0] = {std::cos(turn), std::sin(turn), 0.0, 0.0};
        to_world[1] = {-std::sin(turn), std::cos(turn), 0.0, 0.0};
        to_world[3] = {0.0, 0.0, z, 1.0};
        std::array items{layered_item(set, style), layered_item(front_, box, to_world)};
        items[1].lines = lines_.get();
        frame.draw(items, front_camera(size, size, 1.25));
    }
    // The ends of lines inside the plane, in units from the picture's middle.
    [[nodiscard]] std::vector<glm::dvec2> inner_ends() const {
        std::vector<glm::dvec2> ends;
        for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s) {
            if (frame.drawing().strokes[s].layer != 0) continue;
            for (const StrokePoint& p : {points_of(s).front(), points_of(s).back()}) {
                const glm::dvec2 at(p.x - 250.0F, 250.0F - p.y);
                if (std::abs(at.x) < 195.0) ends.push_back(at / pixels);
            }
        }
        return ends;
    }
    // The distance from the square's outline, positive outside.
    [[nodiscard]] static double off_square(const glm::dvec2& p, double turn) {
        const glm::dvec2 own(std::cos(turn) * p.x + std::sin(turn) * p.y, std::cos(turn) * p.y - std::sin(turn) * p.x);
        const glm::dvec2 off = glm::abs(own) - half;
        return std::min(off.x, off.y) > 0.0 ? glm::length(off) : std::max(off.x, off.y);
    }

    test::SharpShape box_{geometry::Bounds{glm::dvec3(-0.5), glm::dvec3(0.5)},
                          test::max_of(test::sides({half, half, 0.25}))};
    std::unique_ptr<curves::LineSet> lines_;
    marks::PointSet front_{runtime.memory};
};

TEST_F(HatchCuts, LinesEndAtTheEdgesOfTheHidingShape) {
    add_lines(0.02);
    for (const double turn : {0.1, 0.35, 0.7}) {
        for (const float halo : {0.0F, 2.0F, 3.5F}) {
            draw_box(turn, 1.0, halo);
            const std::vector<glm::dvec2> ends = inner_ends();
            EXPECT_GE(ends.size(), 14);
            for (const glm::dvec2& end : ends)
                EXPECT_NEAR(pixels * off_square(end, turn), halo, 0.15) << turn << ' ' << end.x << ' ' << end.y;
        }
    }
}

// Splats extend farther than the surface that they represent.
TEST_F(HatchCuts, LinesThatPassACornerAreNotCut) {
    const double turn = 0.35;
    const double corner = half * (std::cos(turn) + std::sin(turn));
    for (const double beyond : {0.5, 2.0, 5.0}) // pixels
        add_line(set, {corner + beyond / pixels, -1.0, 1.0, 0}, 0.02);
    set_nesting(set, 0.1, 0);
    cluster();
    draw_box(turn, 1.0, 0.0F);
    EXPECT_EQ(inner_ends().size(), 0);
}

// Wide lines become narrower beside an edge that they run along, and end bluntly at an edge that they meet.
TEST_F(HatchCuts, WideLinesDoNotCrossTheEdgesThatTheyFollow) {
    layer.hatch_coverage_begin = layer.hatch_coverage_end = 0.6F;
    layer.hatch_spacing = 10.0F;
    add_lines(0.02);
    for (const double turn : {0.06, 0.2, -0.13}) {
        for (const float halo : {0.0F, 2.0F}) {
            draw_box(turn, 1.0, halo);
            double widest = 0.0;
            for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s) {
                if (frame.drawing().strokes[s].layer != 0) continue;
                for (const StrokePoint& p : points_of(s)) {
                    const glm::dvec2 at = glm::dvec2(p.x - 250.0F, 250.0F - p.y) / pixels;
                    const auto radius = static_cast<double>(p.radius);
                    widest = std::max(widest, radius);
                    // The place is beside the top or the bottom edge.
                    const double aside = std::abs(std::cos(turn) * at.y - std::sin(turn) * at.x) - half;
                    const double along = std::abs(std::cos(turn) * at.x + std::sin(turn) * at.y);
                    if (aside <= 0.0 || along >= half - 0.05) continue;
                    EXPECT_LE(radius + static_cast<double>(halo), pixels * aside / std::cos(turn) + 0.3)
                        << turn << ' ' << halo << ' ' << at.x << ' ' << at.y;
                }
            }
            EXPECT_NEAR(widest, 6.0, 0.1);
        }
    }
}

// Lines just behind an edge have no halo, as with contours.
TEST_F(HatchCuts, HalosWidenWithDepthBehindTheHidingShape) {
    add_lines(0.02);
    double before = 0.0;
    for (const double gap : {5.0, 6.0, 8.0, 12.0, 20.0}) { // pixels from the plane to the front of the box
        draw_box(0.35, gap / pixels - 0.25, 3.0F);
        double sum = 0.0;
        const std::vector<glm::dvec2> ends = inner_ends();
        ASSERT_GE(ends.size(), 14) << gap;
        for (const glm::dvec2& end : ends) sum += pixels * off_square(end, 0.35) / static_cast<double>(ends.size());
        EXPECT_GE(sum, before - 0.01) << gap;
        EXPECT_NEAR(sum, 3.0 * std::clamp((gap - 4.0) / 8.0, 0.0, 1.0), 0.15) << gap;
        before = sum;
    }
}

} // namespace
} // namespace hrbfnpr::testing::hatch_cuts_test
