// SPDX-License-Identifier: MIT
// Tests that whole clusters are skipped: the ink must equal that of marks tested one by one.
#include "frame/depth_layers/gather.h"
#include "frame/line_of_sight.h"
#include "frame/scene/scene.h"
#include "support/instruction_sets.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <gtest/gtest.h>

#include <cstring>
#include <map>

namespace hrbfnpr::testing::culling_test {
namespace {

using drawing::Counts;
using drawing::MarkClass;

constexpr int size = 300;

struct View {
    const char* name;
    frame::Camera camera;
    glm::dmat4 transform{1.0};
};

glm::dmat4 turn(double a, double b) {
    const glm::dmat4 x(1, 0, 0, 0, 0, std::cos(a), std::sin(a), 0, 0, -std::sin(a), std::cos(a), 0, 0, 0, 0, 1);
    const glm::dmat4 y(std::cos(b), 0, -std::sin(b), 0, 0, 1, 0, 0, std::sin(b), 0, std::cos(b), 0, 0, 0, 0, 1);
    return x * y;
}

glm::dmat4 scaled(double x, double y, double z) {
    glm::dmat4 m(1.0);
    m[0][0] = x;
    m[1][1] = y;
    m[2][2] = z;
    return m;
}

frame::Camera perspective_from(const glm::dvec3& eye, const glm::dvec3& target, double angle) {
    frame::Camera camera = front_camera(size, size);
    camera.view = frame::look_at(eye, target, {0.1, 1.0, 0.2});
    camera.projection = frame::perspective(angle, size, size, 0.01, 50.0, camera.depth);
    return camera;
}

std::vector<View> views() {
    std::vector<View> all;
    for (int i = 0; i < 6; ++i) {
        const auto u = base::uniform4(31, static_cast<std::uint64_t>(i), base::Purpose::candidate);
        const glm::dvec3 toward = spiral_direction(i, 6);
        const glm::dvec3 target(u[0] - 0.5, u[1] - 0.5, u[2] - 0.5);
        all.push_back({"perspective", perspective_from((2.5 + 3.0 * u[3]) * toward, target, 0.6)});
        all.push_back({"zoomed in", perspective_from((2.5 + 3.0 * u[3]) * toward, target, 0.05)});
        all.push_back({"close", perspective_from(1.6 * toward, target, 0.3)});
        all.push_back({"orthographic", camera_from(toward, size, 1.5)});
        all.push_back({"orthographic, zoomed in", camera_from(toward, size, 0.15 + 0.3 * u[0])});
        all.push_back({"turned", perspective_from(4.0 * toward, target, 0.6), turn(u[0], 6.0 * u[1])});
        all.push_back({"mirrored", perspective_from(4.0 * toward, target, 0.6), turn(u[0], u[1]) * scaled(-1, 1, 1)});
        all.push_back({"stretched", perspective_from(6.0 * toward, target, 0.6), scaled(1.0, 2.0, 0.4) * turn(1, 2)});
        all.push_back({"stretched and mirrored", camera_from(toward, size, 2.0), scaled(0.5, -1.5, 0.8)});
        all.push_back({"scaled", perspective_from(40.0 * toward, target, 0.6), scaled(10.0, 10.0, 10.0)});
        // The projection contains a turn and a shift of the eye.
        View off_axis{"off axis", perspective_from(4.0 * toward, target, 0.7)};
        off_axis.camera.projection = off_axis.camera.projection * off_axis.camera.view * turn(0.3, 0.4);
        off_axis.camera.view = glm::inverse(turn(0.3, 0.4));
        all.push_back(off_axis);
    }
    all.push_back({"inside the tube", perspective_from({1.0, 0.0, 0.0}, {0.0, 1.0, 0.1}, 1.2)});
    all.push_back({"in the hole", perspective_from({0.1, 0.0, 0.0}, {1.0, 1.0, 0.1}, 1.2)});
    return all;
}

// The ink that a frame makes of each mark, by its id.
std::map<std::uint32_t, Disc> inks_of(const DrawnFrame& frame) {
    std::map<std::uint32_t, Disc> inks;
    for (const Disc& disc : frame.discs()) EXPECT_TRUE(inks.emplace(disc.id, disc).second) << disc.id;
    return inks;
}

void expect_counts(const Counts& info, const char* name) {
    EXPECT_EQ(info.marks, info.outside + info.front + info.back + info.silhouette + info.culled) << name;
}

std::vector<Style> styles() {
    Style lit;
    lit.kind[0].radius = 1.5F;
    Style binary = lit;
    binary.tone_fade = 0.0F;
    binary.light_space = frame::LightSpace::world;
    Style linear = lit;
    linear.tone_curve = frame::ToneCurve::linear;
    linear.tone_exponent = 2.0;
    linear.kind[0].share = 0.6F;
    Style dark;
    dark.tone = frame::Tone::none;
    dark.depth_min = 2.0;
    dark.depth_max = 9.0;
    Style rule = linear;
    rule.tone_rule = frame::ToneRule::published;
    Style blank = lit;
    blank.kind[0].shown = false;
    std::vector<Style> all{lit, binary, linear, dark, rule, blank};
    for (Style& style : all) style.hidden_lines = frame::HiddenLines::show;
    return all;
}

class Culling : public ::testing::Test {
protected:
    // Compares with a set whose cones and, for a parallel camera, bounds say nothing, so that no cluster can be
    // skipped. Returns how many marks were skipped.
    std::int64_t expect_same_without(const View& view, const Style& style) {
        const bool parallel = view.camera.projection[2][3] == 0.0 && view.camera.projection[0][3] == 0.0;
        base::Array<marks::Cluster>& clusters = open.layers[0].clusters.cluster;
        for (std::int64_t i = 0; i < clusters.size(); ++i) {
            clusters[i].cone.cosine = -1.0F;
            clusters[i].cone.sine = 0.0F;
            clusters[i].radius = parallel ? 100.0F : set.layers[0].clusters.cluster[i].radius;
        }
        const std::array items{layered_item(set, style, view.transform)};
        frame.draw(items, view.camera);
        const std::vector<Disc> discs(frame.discs().begin(), frame.discs().end());
        const std::int64_t culled = frame.info().culled;
        expect_counts(frame.info(), view.name);
        const std::array wide{layered_item(open, style, view.transform)};
        frame.draw(wide, view.camera);
        expect_counts(frame.info(), view.name);
        EXPECT_EQ(frame.discs().size(), discs.size()) << view.name;
        for (std::size_t i = 0; i < std::min(discs.size(), frame.discs().size()); ++i) {
            const Disc& disc = frame.discs()[i];
            if (disc.id == discs[i].id && disc.radius == discs[i].radius && disc.mark_class == discs[i].mark_class)
                continue;
            ADD_FAILURE() << view.name << ": marks " << disc.id << " and " << discs[i].id;
            break;
        }
        return culled;
    }
    marks::PointSet set_of() { return clustered(runtime, torus(runtime.memory, 130)); }

    base::Runtime runtime;
    DrawnFrame frame{runtime};
    marks::PointSet set = set_of();
    marks::PointSet open = set_of();
};

TEST_F(Culling, DoesNotChangeTheInk) {
    std::int64_t culled = 0;
    for (const View& view : views()) {
        for (const Style& style : styles()) culled += expect_same_without(view, style);
    }
    EXPECT_GT(culled, 100000);
}

TEST_F(Culling, DoesNotChangeTheInkOfThePublishedToneRule) {
    Style style = styles()[0];
    style.tone_rule = frame::ToneRule::published;
    for (const View& view : views()) expect_same_without(view, style);
}

// Marks are beyond the picture's border, but their discs reach into it.
TEST_F(Culling, DiscsThatGrowWithTheZoomReachIntoThePicture) {
    const marks::PointSet flat = clustered(runtime, plane(runtime.memory, 100));
    Style style = styles()[2];
    style.tone = frame::Tone::none;
    style.kind[0].share = 1.0F;
    style.zoom_reference = 1.0;
    style.kind[0].radius = 0.2F;
    style.kind[0].radius_zoom = 1.0F; // 120 pixels
    frame::Camera camera = front_camera(size, size, 0.25);
    const std::array published{item_of(flat, style)};
    frame.draw(published, camera);
    const std::int64_t expected = frame.info().shown;
    EXPECT_EQ(frame.discs()[0].radius, 120.0F);
    const std::array layers{layered_item(flat, style)};
    frame.draw(layers, camera);
    EXPECT_EQ(frame.info().shown, expected);
}

TEST_F(Culling, EveryMarkCountsOnceWhileTonesFade) {
    for (const View& view : views()) {
        const std::array items{layered_item(set, styles()[0], view.transform)};
        frame.draw(items, view.camera);
        const Counts& info = frame.info();
        EXPECT_EQ(info.shown + info.dropped_tone + info.dropped_depth + info.dropped_zoom + info.dropped_hidden,
                  info.front)
            << view.name;
        EXPECT_EQ(info.silhouette, 0) << view.name;
    }
}

// The values of one mark, computed in doubles.
struct Plain {
    double x = 0.0, y = 0.0, nu = 0.0, tau = 0.0, pixels_per_unit = 1.0;
    bool inside = false;
    bool near_edge = false; // rounding decides whether the mark is inside
};

struct Sight {
    glm::dmat4 to_eye, clip;
    glm::dmat3 normal_to_eye;
    glm::dvec3 centre;
    bool parallel;
};

Sight sight_of(const View& view) {
    Sight s{};
    s.to_eye = view.camera.view * view.transform;
    s.clip = view.camera.projection * s.to_eye;
    s.normal_to_eye = glm::inverseTranspose(glm::dmat3(s.to_eye));
    // The point where all lines of sight meet: the projection takes it to (0, 0, c, 0).
    const glm::dvec4 c = glm::inverse(view.camera.projection) * glm::dvec4(0.0, 0.0, 1.0, 0.0);
    s.parallel = std::abs(c.w) < 1e-9 * glm::length(glm::dvec3(c));
    s.centre = s.parallel ? glm::dvec3(0.0, 0.0, -1.0) : glm::dvec3(c) / c.w;
    return s;
}

Plain plain_of(const Mark& mark, const Sight& s, const Style& style, double radius) {
    Plain p;
    const glm::dvec4 clip = s.clip * glm::dvec4(mark.position, 1.0);
    p.x = size * (0.5 + 0.5 * clip.x / clip.w);
    p.y = size * (0.5 - 0.5 * clip.y / clip.w);
    const double z = clip.z / clip.w;
    const double out = std::max({-p.x, p.x - size, -p.y, p.y - size}) - radius;
    p.inside = clip.w > 0.0 && out < 0.0 && z >= -1.0 && z <= 1.0;
    p.near_edge = std::abs(out) < 1e-2 || std::abs(std::abs(z) - 1.0) < 1e-5;
    const glm::dvec3 eye(s.to_eye * glm::dvec4(mark.position, 1.0));
    const glm::dvec3 n = glm::normalize(s.normal_to_eye * mark.normal);
    p.nu = glm::dot(n, glm::normalize(s.parallel ? s.centre : eye - s.centre));
    const double lit = glm::dot(n, glm::normalize(style.light));
    p.tau = lit > 0.0 ? lit : double{style.fill_light} * lit * lit;
    return p;
}

// With LINEAR tone every law is known without the clusters.
TEST_F(Culling, KeepsTheMarksThatTheLawsShow) {
    Style style;
    style.hidden_lines = frame::HiddenLines::show;
    style.tone_curve = frame::ToneCurve::linear;
    style.tone_fade = 0.0F;
    style.kind[0].share = 0.7F;
    style.kind[0].radius = 2.0F;
    std::int64_t selected = 0;
    for (const View& view : views()) {
        const Sight sight = sight_of(view);
        const std::array items{layered_item(set, style, view.transform)};
        frame.draw(items, view.camera);
        const std::map<std::uint32_t, Disc> inks = inks_of(frame);
        for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
            const Plain p = plain_of(mark_of(set, i), sight, style, 2.5);
            const double shown = 0.7 * (1.0 - p.tau);
            const double place = 1.0 - static_cast<double>(set.layers[0].rank[i]);
            if (p.near_edge || std::abs(p.nu) < 1e-4 || std::abs(place - shown) < 1e-4) continue;
            ++selected;
            const bool wanted = p.inside && p.nu < 0.0 && place < shown;
            const auto found = inks.find(static_cast<std::uint32_t>(i) + 1);
            ASSERT_EQ(found != inks.end(), wanted) << view.name << " mark " << i << " nu " << p.nu << " at " << p.x
                                                   << ", " << p.y << " place " << place << " of " << shown;
            if (!wanted) continue;
            ASSERT_NEAR(static_cast<double>(found->second.x), p.x, 2e-2) << view.name;
            ASSERT_NEAR(static_cast<double>(found->second.y), p.y, 2e-2) << view.name;
            ASSERT_EQ(found->second.mark_class, MarkClass::front);
            ASSERT_EQ(found->second.radius, 2.0F);
        }
    }
    EXPECT_GT(selected, 1000000);
}

// The set is evenly lit, and each mark takes the share of coverage for its turn away from the eye.
TEST_F(Culling, KeepsTheShareThatCoverageNeeds) {
    set = clustered(runtime, torus(runtime.memory, 200));
    Style style;
    style.hidden_lines = frame::HiddenLines::show;
    style.tone_fade = 0.0F;
    style.kind[0].radius = 1.5F;
    for (const View& view : views()) {
        if (std::string(view.name).find("orthographic") == std::string::npos) continue; // one scale for all clusters
        const Sight sight = sight_of(view);
        const double pixels_per_unit = 0.5 * size * view.camera.projection[1][1];
        const double full = pi * (1.5 * 1.5 + 1.0 / 12.0) / std::pow(set.spacing * pixels_per_unit, 2.0);
        // If all marks cover less than 0.6 (in the table's steps of 1 / 64), they are shown as if they covered that
        // much.
        const double enough = std::max(full, -std::log(1.0 - 38.0 / 64.0));
        const std::array items{layered_item(set, style, view.transform)};
        frame.draw(items, view.camera);
        const std::map<std::uint32_t, Disc> inks = inks_of(frame);
        for (std::int64_t i = 0; i < set.layers[0].count(); ++i) {
            const Plain p = plain_of(mark_of(set, i), sight, style, 2.0);
            // Random marks have coverage = 1 - exp(-ink). The test leaves out tones near white and black, where the
            // table is coarse.
            if (p.near_edge || p.nu > -0.25 || p.tau < 0.05) continue;
            const double shown = std::min(1.0, -std::log(p.tau) * -p.nu / enough);
            const double place = 1.0 - static_cast<double>(set.layers[0].rank[i]);
            if (std::abs(place - shown) < 0.01 * shown + 1e-3) continue;
            ASSERT_EQ(inks.contains(static_cast<std::uint32_t>(i) + 1), p.inside && place < shown)
                << view.name << " " << i << " place " << place << " of " << shown;
        }
    }
}

TEST_F(Culling, FrontMarksAreShownDroppedOrNotDrawn) {
    for (const View& view : views()) {
        for (Style style : styles()) {
            style.tone_fade = 0.0F;
            style.hidden_lines = frame::HiddenLines::hide;
            const std::array items{layered_item(set, style, view.transform)};
            frame.draw(items, view.camera);
            const Counts& info = frame.info();
            expect_counts(info, view.name);
            const std::int64_t dropped =
                info.dropped_tone + info.dropped_depth + info.dropped_zoom + info.dropped_hidden;
            EXPECT_EQ(info.shown + dropped, style.kind[0].shown ? info.front : 0) << view.name;
        }
    }
}

} // namespace
} // namespace hrbfnpr::testing::culling_test
