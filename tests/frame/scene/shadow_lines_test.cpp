// SPDX-License-Identifier: MIT
// Tests borders of shadows against analytic scenes and against plain rays.
#include "frame/scene/shadow_lines.h"

#include "geometry/tangent_frame.h"
#include "support/contour_shapes.h"
#include "support/runtime.h"
#include "support/sharp_shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace hrbfnpr::testing::shadow_lines_test {
namespace {

using curves::LineKind;

constexpr double pi = std::numbers::pi;
// Borders must be this exact, in units of the scenes, which are about 5 units large.
constexpr double exact = 2e-4;

// The plane z = 0.
class Ground : public test::Analytic {
public:
    Ground() : Analytic({{-5.0, -5.0, -0.2}, {5.0, 5.0, 0.2}}) {}
    [[nodiscard]] test::Field at(const glm::dvec3& p) const override { return {p.z, {0.0, 0.0, 1.0}, {}}; }
};

frame::LightStyle light_of(frame::LightKind kind, const glm::dvec3& place) {
    frame::LightStyle light;
    light.kind = kind;
    light.space = frame::LightSpace::world;
    light.place = place;
    light.shadow = 1.0F;
    return light;
}

class ShadowLines : public ::testing::Test {
protected:
    const curves::LineSet& add(const implicit::Implicit& shape, const glm::dmat4& to_world = glm::dmat4(1.0),
                               double side = 0.1) {
        curves::LineSetSettings settings;
        settings.side = side;
        sets_.push_back(std::make_unique<curves::LineSet>(
            runtime, shape, std::make_unique<implicit::DifferencedShape>(shape), settings));
        casters_.push_back({&sets_.back()->mesh(), to_world, sets_.back().get()});
        return *sets_.back();
    }
    // Finds the lines on the item with this number. The first `casting` items cast shadows.
    void find(std::size_t number, std::size_t casting = SIZE_MAX, const base::Runtime* with = nullptr) {
        const base::Runtime& run = with != nullptr ? *with : runtime;
        const frame::Casters casters = frame::casters_of(run, {casters_.data(), std::min(casting, casters_.size())});
        const frame::ShadedItem item{
            nullptr, casters_[number].to_world, {&light, 1}, glm::dmat4(1.0), casters_[number].lines};
        lines = frame::find_shadow_lines(run, casters, item);
    }
    [[nodiscard]] const curves::Curves& of(LineKind kind) const {
        for (const curves::FoundLines& found : lines)
            if (found.kind == kind) return found.lines.curves;
        throw std::runtime_error("no lines of this kind");
    }
    // Returns places along lines: all points, and three places between two points.
    [[nodiscard]] static std::vector<glm::dvec3> places_on(const curves::Curves& curves) {
        std::vector<glm::dvec3> places;
        curves::for_pieces(curves, [&](std::int64_t i, std::int64_t j) {
            const curves::CubicPiece piece(curves.point[i], curves.point[j]);
            for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) places.push_back(piece.at(u));
        });
        return places;
    }
    [[nodiscard]] static double length_of(const curves::Curves& curves) {
        double length = 0.0;
        curves::for_pieces(curves, [&](std::int64_t i, std::int64_t j) {
            const curves::CubicPiece piece(curves.point[i], curves.point[j]);
            for (int k = 0; k < 8; ++k) length += glm::distance(piece.at(k / 8.0), piece.at((k + 1) / 8.0));
        });
        return length;
    }
    [[nodiscard]] static std::vector<glm::dvec3> ends_of(const curves::Curves& curves) {
        std::vector<glm::dvec3> ends;
        for (std::int64_t c = 0; c < curves.count(); ++c) {
            if (curves.closed[c] != 0) continue;
            ends.push_back(curves.point[curves.first[c]].position);
            ends.push_back(curves.point[curves.first[c + 1] - 1].position);
        }
        return ends;
    }
    [[nodiscard]] static double distance_to(const std::vector<glm::dvec3>& places, const glm::dvec3& place) {
        double least = HUGE_VAL;
        for (const glm::dvec3& p : places) least = std::min(least, glm::distance(p, place));
        return least;
    }

    const base::Runtime runtime = test::with_threads(2);
    frame::LightStyle light;
    base::List<curves::FoundLines> lines{runtime.memory};

private:
    std::vector<std::unique_ptr<curves::LineSet>> sets_;
    std::vector<frame::Caster> casters_;
};

TEST_F(ShadowLines, ADirectionalLightCastsAnEllipse) {
    const test::Sphere ball(1.0, {0.2, -0.3, 1.6});
    const Ground ground;
    add(ball);
    add(ground, glm::dmat4(1.0), 0.25);
    light = light_of(frame::LightKind::directional, {1.0, 0.5, 2.0});
    const glm::dvec3 towards = glm::normalize(light.place);
    for (const std::size_t casting : {std::size_t{1}, std::size_t{2}}) { // The ground may be among the casters, or not.
        find(1, casting);
        const curves::Curves& border = of(LineKind::shadow);
        ASSERT_EQ(border.count(), 1);
        EXPECT_EQ(border.closed[0], 1);
        for (const glm::dvec3& p : places_on(border)) {
            EXPECT_NEAR(p.z, 0.0, exact);
            EXPECT_NEAR(glm::length(glm::cross(p - glm::dvec3(0.2, -0.3, 1.6), towards)), 1.0, exact);
        }
        // Ramanujan's second formula for the length of an ellipse.
        const double a = 1.0 / towards.z;
        const double h = (a - 1.0) * (a - 1.0) / ((a + 1.0) * (a + 1.0));
        const double length = pi * (a + 1.0) * (1.0 + 3.0 * h / (10.0 + std::sqrt(4.0 - 3.0 * h)));
        EXPECT_NEAR(length_of(border), length, 1e-3);
        EXPECT_EQ(of(LineKind::terminator).count(), 0) << "light meets the whole ground from above";
    }
    find(0);
    EXPECT_EQ(of(LineKind::shadow).count(), 0) << "nothing shades the ball";
    const curves::Curves& terminator = of(LineKind::terminator);
    ASSERT_EQ(terminator.count(), 1);
    for (const glm::dvec3& p : places_on(terminator)) {
        EXPECT_NEAR(glm::dot(p - glm::dvec3(0.2, -0.3, 1.6), towards), 0.0, exact);
        EXPECT_NEAR(glm::distance(p, {0.2, -0.3, 1.6}), 1.0, exact);
    }
    EXPECT_NEAR(length_of(terminator), 2.0 * pi, 1e-3);
}

TEST_F(ShadowLines, ALightAtAPlaceCastsAConic) {
    const test::Sphere ball; // at the origin of its item
    const Ground ground;
    glm::dmat4 lifted(0.5); // The item is scaled, and its second axis is mirrored.
    lifted[1][1] = -0.5;
    lifted[3] = {0.4, 0.2, 1.2, 1.0};
    add(ball, lifted);
    add(ground, glm::dmat4(1.0), 0.25);
    light = light_of(frame::LightKind::place, {-0.8, 0.3, 3.5});
    const glm::dvec3 axis = glm::dvec3(lifted[3]) - light.place;
    find(1);
    const curves::Curves& border = of(LineKind::shadow);
    ASSERT_EQ(border.count(), 1);
    EXPECT_EQ(border.closed[0], 1);
    for (const glm::dvec3& p : places_on(border)) {
        const glm::dvec3 ray = glm::normalize(p - light.place);
        EXPECT_NEAR(p.z, 0.0, exact);
        EXPECT_NEAR(glm::length(glm::cross(ray, axis)), 0.5, exact) << "the ray touches the ball";
    }
    find(0);
    const curves::Curves& terminator = of(LineKind::terminator);
    ASSERT_EQ(terminator.count(), 1);
    const double distance = glm::length(axis) / 0.5; // in the coordinates of the item
    for (const glm::dvec3& p : places_on(terminator)) {
        const glm::dvec3 to_light = (light.place - glm::dvec3(lifted[3])) / glm::dvec3(0.5, -0.5, 0.5);
        EXPECT_NEAR(glm::dot(p, to_light), 1.0, 1e-3);
        EXPECT_NEAR(glm::length(p), 1.0, exact);
    }
    EXPECT_NEAR(length_of(terminator), 2.0 * pi * std::sqrt(1.0 - 1.0 / (distance * distance)), 1e-3);
}

// Whether a ray from a place towards a light meets a ball.
bool is_hidden(const glm::dvec3& place, const glm::dvec3& towards, const glm::dvec3& centre, double radius) {
    const glm::dvec3 way = centre - place;
    const double along = glm::dot(way, towards);
    return along > 0.0 && glm::dot(way, way) - along * along < radius * radius;
}

TEST_F(ShadowLines, ABallCastsItsShadowOnAnother) {
    const test::Sphere lower;
    const glm::dvec3 centre(0.9, 0.2, 1.8);
    const test::Sphere upper(0.7, centre);
    add(lower);
    add(upper);
    light = light_of(frame::LightKind::directional, {0.25, 0.1, 1.0});
    const glm::dvec3 towards = glm::normalize(light.place);
    find(0);
    const std::vector<glm::dvec3> border = places_on(of(LineKind::shadow));
    ASSERT_FALSE(border.empty());
    for (const glm::dvec3& p : border) {
        EXPECT_NEAR(glm::length(p), 1.0, exact);
        EXPECT_NEAR(glm::length(glm::cross(p - centre, towards)), 0.7, exact);
        EXPECT_GT(glm::dot(p, towards), -1e-3);
    }
    const std::vector<glm::dvec3> terminator = places_on(of(LineKind::terminator));
    for (const glm::dvec3& p : terminator) {
        EXPECT_NEAR(glm::dot(p, towards), 0.0, exact);
        EXPECT_GT(glm::length(glm::cross(p - centre, towards)), 0.7 - 0.02) << "not inside of the cast shadow";
    }
    // Along meridians, light and shade change only at the lines, and they do change there.
    int changes = 0;
    const glm::dvec3 u = geometry::any_perpendicular(towards);
    const glm::dvec3 v = glm::cross(towards, u);
    for (int meridian = 0; meridian < 90; ++meridian) {
        bool was_lit = false;
        for (int k = 0; k <= 720; ++k) {
            const double angle = pi * k / 720.0;
            const glm::dvec3 out = std::cos(pi * meridian / 45.0) * u + std::sin(pi * meridian / 45.0) * v;
            const glm::dvec3 p = std::cos(angle) * towards + std::sin(angle) * out;
            const bool lit = angle < 0.5 * pi && !is_hidden(p, towards, centre, 0.7);
            if (k > 0 && lit != was_lit) {
                ++changes;
                EXPECT_LT(std::min(distance_to(border, p), distance_to(terminator, p)), 0.03);
            }
            was_lit = lit;
        }
    }
    EXPECT_GT(changes, 90);
}

TEST_F(ShadowLines, NoBorderLiesInAnotherShadow) {
    const test::Sphere large(1.2, {0.0, 0.0, 4.0});
    const test::Sphere small(0.5, {0.1, 0.2, 1.5});
    const Ground ground;
    add(large);
    add(small, glm::dmat4(1.0), 0.05);
    add(ground, glm::dmat4(1.0), 0.25);
    light = light_of(frame::LightKind::directional, {0.0, 0.0, 1.0});
    find(1);
    EXPECT_EQ(of(LineKind::terminator).count(), 0) << "the small ball is dark";
    EXPECT_EQ(of(LineKind::shadow).count(), 0);
    find(2);
    const curves::Curves& border = of(LineKind::shadow);
    ASSERT_EQ(border.count(), 1);
    EXPECT_NEAR(length_of(border), 2.0 * pi * 1.2, 1e-3);
    // A shift lets half of the small ball look out of the large ball's shadow. Both borders end where they meet.
    light = light_of(frame::LightKind::directional, {0.55, 0.0, 1.0});
    find(2);
    const glm::dvec3 towards = glm::normalize(light.place);
    const std::vector<glm::dvec3> places = places_on(of(LineKind::shadow));
    for (const glm::dvec3& p : places) {
        const double from_large = glm::length(glm::cross(p - glm::dvec3(0.0, 0.0, 4.0), towards)) / 1.2;
        const double from_small = glm::length(glm::cross(p - glm::dvec3(0.1, 0.2, 1.5), towards)) / 0.5;
        EXPECT_NEAR(std::min(from_large, from_small), 1.0, 0.01);
        EXPECT_GT(std::max(from_large, from_small), 1.0 - 0.01);
    }
    EXPECT_GT(ends_of(of(LineKind::shadow)).size(), 3U);
    for (const glm::dvec3& end : ends_of(of(LineKind::shadow))) {
        const double from_large = glm::length(glm::cross(end - glm::dvec3(0.0, 0.0, 4.0), towards)) / 1.2;
        const double from_small = glm::length(glm::cross(end - glm::dvec3(0.1, 0.2, 1.5), towards)) / 0.5;
        EXPECT_NEAR(from_large, 1.0, 0.02);
        EXPECT_NEAR(from_small, 1.0, 0.02);
    }
}

// The box with half sides of 1, 0.7 and 0.5, and its middle at `centre`.
test::SharpShape box_at(const glm::dvec3& centre) {
    std::vector<test::Sharp> sides;
    const glm::dvec3 half(1.0, 0.7, 0.5);
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0}) {
            glm::dvec3 n(0.0);
            n[axis] = sign;
            sides.emplace_back(test::plane(n, half[axis] + glm::dot(n, centre)));
        }
    return {{centre - half - 0.3, centre + half + 0.3}, test::max_of(std::move(sides))};
}

TEST_F(ShadowLines, ABoxCastsAPolygon) {
    const glm::dvec3 centre(0.0, 0.0, 1.5);
    const test::SharpShape box = box_at(centre);
    const Ground ground;
    add(box);
    add(ground, glm::dmat4(1.0), 0.25);
    const std::array<glm::dvec3, 2> ways{glm::dvec3(0.6, 0.4, 1.0), glm::dvec3(0.0, 0.0, 1.0)};
    for (const glm::dvec3& way : ways) {
        light = light_of(frame::LightKind::directional, way);
        find(1);
        // The shadow is the sum of the projections of the box's sides: a zonogon.
        std::array<glm::dvec2, 3> side;
        for (int axis = 0; axis < 3; ++axis) {
            glm::dvec3 half(0.0);
            half[axis] = glm::dvec3(1.0, 0.7, 0.5)[axis];
            side[static_cast<std::size_t>(axis)] = glm::dvec2(half) - half.z / way.z * glm::dvec2(way);
        }
        const glm::dvec2 middle = glm::dvec2(centre) - centre.z / way.z * glm::dvec2(way);
        // Returns how far a place is from the border of the zonogon, negative inside.
        const auto off = [&](const glm::dvec3& p) {
            double most = -HUGE_VAL;
            for (const glm::dvec2& s : side) {
                if (glm::length(s) < 1e-9) continue;
                const glm::dvec2 n = glm::normalize(glm::dvec2(-s.y, s.x));
                double width = 0.0;
                for (const glm::dvec2& t : side) width += std::abs(glm::dot(t, n));
                most = std::max(most, std::abs(glm::dot(glm::dvec2(p) - middle, n)) - width);
            }
            return most;
        };
        double length = 0.0;
        for (const glm::dvec2& s : side) length += 4.0 * glm::length(s);
        const curves::Curves& border = of(LineKind::shadow);
        for (const glm::dvec3& p : places_on(border)) EXPECT_NEAR(off(p), 0.0, exact);
        EXPECT_NEAR(length_of(border), length, 0.02) << "light from " << way.x;
        find(0);
        EXPECT_EQ(of(LineKind::shadow).count(), 0);
        // Terminators are the edges between lit faces and faces that turn away.
        for (const glm::dvec3& p : places_on(of(LineKind::terminator))) {
            const glm::dvec3 q = (p - centre) / glm::dvec3(1.0, 0.7, 0.5);
            int on_faces = 0;
            for (int axis = 0; axis < 3; ++axis) on_faces += std::abs(std::abs(q[axis]) - 1.0) < 1e-3 ? 1 : 0;
            EXPECT_GE(on_faces, 2);
        }
        // The light from above is moved a little aside, so that two of the upright faces count as lit.
        EXPECT_NEAR(length_of(of(LineKind::terminator)), 4.0 * (1.0 + 0.7 + 0.5), 0.02);
    }
}

// A lying torus shades itself. Every border begins in a cusp of the light's contours or ends at another border.
TEST_F(ShadowLines, ATorusShadesItself) {
    const test::Torus torus;
    add(torus, glm::dmat4(1.0), 0.05);
    light = light_of(frame::LightKind::directional, {1.0, 0.2, 0.45});
    const glm::dvec3 towards = glm::normalize(light.place);
    find(0);
    const curves::Curves& border = of(LineKind::shadow);
    const curves::Curves& terminator = of(LineKind::terminator);
    ASSERT_GT(border.count(), 0);
    // A plain ray: whether the light reaches a place on the torus.
    const auto is_lit = [&](const glm::dvec3& place) {
        const test::Field field = torus.at(place);
        if (!(glm::dot(field.gradient, towards) > 0.0)) return false;
        for (double t = 0.02; t < 3.0; t += 1e-3)
            if (torus.at(place + t * towards).value < 0.0) return false;
        return true;
    };
    const auto onto = [&](glm::dvec3 place) {
        for (int k = 0; k < 4; ++k) {
            const test::Field field = torus.at(place);
            place -= field.value * field.gradient;
        }
        return place;
    };
    for (const curves::Curves* const some : {&border, &terminator}) {
        int differ = 0;
        int all = 0;
        for (std::int64_t i = 0; i < some->point.size(); i += 5) {
            const curves::CurvePoint& p = some->point[i];
            EXPECT_NEAR(torus.at(p.position).value, 0.0, exact);
            const glm::dvec3 aside = 0.03 * glm::normalize(glm::cross(p.gradient, p.direction()));
            differ += is_lit(onto(p.position + aside)) != is_lit(onto(p.position - aside)) ? 1 : 0;
            ++all;
        }
        EXPECT_GE(differ, all - all / 20) << "light and shade are on the two sides of " << all << " places";
    }
    const std::vector<glm::dvec3> on_border = places_on(border);
    const std::vector<glm::dvec3> on_terminator = places_on(terminator);
    for (const glm::dvec3& end : ends_of(terminator)) EXPECT_LT(distance_to(on_border, end), 0.01);
    for (const glm::dvec3& end : ends_of(border)) EXPECT_LT(distance_to(on_terminator, end), 0.01);
}

TEST_F(ShadowLines, AreTheSameForAnyNumberOfThreads) {
    const test::Torus torus;
    const Ground ground;
    glm::dmat4 lifted(1.0);
    lifted[3] = {0.0, 0.0, 1.0, 1.0};
    add(torus, lifted);
    add(ground, glm::dmat4(1.0), 0.25);
    light = light_of(frame::LightKind::place, {4.0, 1.0, 2.5});
    find(0);
    const base::List<curves::FoundLines> some = std::move(lines);
    lines = base::List<curves::FoundLines>(runtime.memory);
    const base::Runtime one = test::with_threads(1);
    find(0, 2, &one);
    ASSERT_EQ(some.size(), lines.size());
    for (std::int64_t i = 0; i < some.size(); ++i) {
        EXPECT_GT(some[i].lines.curves.count(), 0);
        EXPECT_TRUE(test::same_bits(some[i].lines.strength, lines[i].lines.strength));
        EXPECT_TRUE(test::same_bits(some[i].lines.curves.first, lines[i].lines.curves.first));
        ASSERT_EQ(some[i].lines.curves.point.size(), lines[i].lines.curves.point.size());
        for (std::int64_t p = 0; p < lines[i].lines.curves.point.size(); ++p)
            ASSERT_EQ(some[i].lines.curves.point[p].position, lines[i].lines.curves.point[p].position);
    }
}

TEST_F(ShadowLines, BelongToLightsThatCastShadows) {
    const test::Sphere ball;
    add(ball);
    light = light_of(frame::LightKind::directional, {0.0, 0.0, 1.0});
    light.shadow = 0.0F;
    find(0);
    EXPECT_EQ(of(LineKind::terminator).count(), 0);
    light.shadow = 0.25F;
    find(0);
    ASSERT_EQ(of(LineKind::terminator).count(), 1);
    EXPECT_EQ(lines[1].lines.strength[0], 0.25F);
}

} // namespace
} // namespace hrbfnpr::testing::shadow_lines_test
