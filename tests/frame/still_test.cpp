// SPDX-License-Identifier: MIT
// Tests that a still picture needs every mark that a drawing of the whole set shows, and few others.
#include "frame/line_of_sight.h"
#include "frame/scene/still.h"

#include <gtest/gtest.h>

namespace hrbfnpr::testing::still_test {
namespace {

constexpr int size = 300;

frame::Camera perspective_from(const glm::dvec3& eye, const glm::dvec3& target, double angle) {
    frame::Camera camera = front_camera(size, size);
    camera.view = frame::look_at(eye, target, {0.1, 1.0, 0.2});
    camera.projection = frame::perspective(angle, size, size, 0.01, 50.0, camera.depth);
    return camera;
}

std::vector<frame::Camera> cameras() {
    return {perspective_from({0.5, 1.0, 3.0}, {}, 0.9), perspective_from({2.0, 0.3, 1.5}, {0.3, 0.2, 0.1}, 0.2),
            camera_from({0.3, 0.5, 0.8}, size, 1.6), camera_from({-0.8, 0.1, 0.3}, size, 0.5)};
}

std::vector<Style> styles() {
    Style lit;
    lit.kind[0].radius = 1.5F;
    Style hide = lit;
    hide.hidden_lines = frame::HiddenLines::hide;
    Style world = lit;
    world.tone_fade = 0.0F;
    world.light_space = frame::LightSpace::world;
    world.kind[0].share = 0.6F;
    Style linear = lit;
    linear.tone_curve = frame::ToneCurve::linear;
    linear.tone_exponent = 2.0;
    Style dark;
    dark.tone = frame::Tone::none;
    Style blank = hide;
    blank.kind[0].shown = false;
    return {lit, hide, world, linear, dark, blank};
}

// A set of marks and what a drawing needs of it.
class Stills : public ::testing::Test {
protected:
    frame::StillView view_of(const Style& style, const frame::Camera& camera, bool both_sides = false) {
        const frame::Still still{camera, kept(style), both_sides};
        return {runtime.memory, still, set.bounds, 1.0};
    }
    double share(const frame::StillView& view, std::uint32_t mark) const {
        const frame::StillNeed need(view, {marks::Kind::stipples, &view.item.style.layers[0], true, true});
        const glm::dvec3 place = set.origin + glm::dvec3(marks::vector_at(layer().position, mark));
        const glm::dvec3 normal(marks::vector_at(layer().normal, mark));
        const double wanted = need.share(place, normal, set.spacing);
        EXPECT_TRUE(need.may_show(place, normal, set.spacing) || !(wanted > 0.0));
        return wanted;
    }
    [[nodiscard]] const marks::Layer& layer() const { return set.layers[0]; }

    marks::PointSet make_set() {
        marks::PointSet made = torus(runtime.memory, 130);
        made.layers[0].progressive = true;
        return clustered(runtime, std::move(made));
    }

    base::Runtime runtime;
    DrawnFrame frame{runtime};
    marks::PointSet set = make_set();
};

TEST_F(Stills, NeedEveryMarkThatIsShown) {
    for (const Style& style : styles()) {
        for (const frame::Camera& camera : cameras()) {
            const std::array items{layered_item(set, style)};
            frame.draw(items, camera);
            const frame::StillView view = view_of(style, camera);
            for (const Disc& disc : frame.discs()) {
                const auto mark = static_cast<std::uint32_t>(frame.drawing().identify(disc.id).mark);
                EXPECT_GE(share(view, mark), 1.0 - static_cast<double>(layer().rank[mark]));
            }
        }
    }
}

TEST_F(Stills, LeaveOutTheOtherSideAndLightTones) {
    const Style style = styles()[1];
    const frame::StillView view = view_of(style, cameras()[0]);
    const std::array items{layered_item(set, style)};
    frame.draw(items, cameras()[0]);
    std::int64_t needed = 0;
    for (std::int64_t mark = 0; mark < layer().count(); ++mark)
        needed +=
            share(view, static_cast<std::uint32_t>(mark)) >= 1.0 - static_cast<double>(layer().rank[mark]) ? 1 : 0;
    EXPECT_GT(frame.info().shown, 500);
    EXPECT_GE(needed, frame.info().shown);
    EXPECT_LT(needed, layer().count() / 2);
}

TEST_F(Stills, NeedTheOtherSideOnlyWhereItIsDrawnOrDimsInk) {
    const glm::dvec3 place(0.0, 0.0, -0.4);
    const glm::dvec3 away(0.0, 0.0, -1.0);
    const frame::Camera camera = camera_from({0.0, 0.0, 1.0}, size, 1.6);
    const auto may_show = [&](const Style& style, bool both_sides, bool may_be_splats) {
        const frame::StillView view = view_of(style, camera, both_sides);
        const frame::StillNeed need(view, {marks::Kind::hatch, &view.item.style.layers[1], may_be_splats, false});
        return need.may_show(place, away, 0.01);
    };
    const Style attenuate = styles()[0];
    const Style hide = styles()[1];
    EXPECT_FALSE(may_show(hide, false, true));
    EXPECT_TRUE(may_show(hide, true, false));
    EXPECT_TRUE(may_show(attenuate, false, true));
    EXPECT_FALSE(may_show(attenuate, false, false));
}

} // namespace
} // namespace hrbfnpr::testing::still_test
