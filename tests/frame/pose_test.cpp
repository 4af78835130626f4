// SPDX-License-Identifier: MIT
// Tests marks that have moved since their set was made.
#include "frame/line_of_sight.h"
#include "support/runtime.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <map>

namespace hrbfnpr::testing::pose_test {
namespace {

using frame::Item;
using frame::Pose;
using frame::Visibility;
using ::testing::HasSubstr;

constexpr int size = 400;

// The places of a layer's marks, with room to write them elsewhere.
struct Places {
    std::vector<double> position, normal, direction;

    Places(const marks::PointSet& set, std::int64_t layer, const glm::dmat4& motion = glm::dmat4(1.0)) {
        const marks::Layer& marks = set.layers[layer];
        for (std::int64_t i = 0; i < marks.count(); ++i) {
            const glm::dvec3 p = glm::dvec3(marks::vector_at(marks.position, i)) + set.origin;
            const glm::dmat3 turn(motion);
            const glm::dvec3 moved[] = {glm::dvec3(motion * glm::dvec4(p, 1.0)),
                                        turn * glm::dvec3(marks::vector_at(marks.normal, i)),
                                        turn * glm::dvec3(marks::vector_at(marks.direction, i))};
            for (int k = 0; k < 3; ++k) {
                position.push_back(moved[0][k]);
                normal.push_back(moved[1][k]);
                direction.push_back(moved[2][k]);
            }
        }
    }
    [[nodiscard]] static base::InView view(const std::vector<double>& numbers) {
        return {reinterpret_cast<const std::byte*>(numbers.data()), static_cast<std::int64_t>(numbers.size() / 3), 24,
                base::Scalar::float64, 3};
    }
    [[nodiscard]] Pose pose(std::int64_t layer) const { return {layer, view(position), view(normal), view(direction)}; }
};

class PosedLayers : public ::testing::Test {
protected:
    void draw(const Item& item, Visibility visibility, const frame::Camera& camera) {
        std::array items{item};
        items[0].style.visibility = visibility;
        frame.draw(items, camera);
    }
    [[nodiscard]] std::map<std::uint32_t, Disc> inks() const {
        std::map<std::uint32_t, Disc> by_id;
        for (const Disc& disc : frame.discs())
            if (!disc.is_paper) by_id.emplace(disc.id, disc);
        return by_id;
    }
    // The set has stipples and strokes, so there are two layers.
    marks::PointSet ring() {
        marks::PointSet made = torus(runtime.memory, 90);
        add_torus_strokes(made, marks::Kind::hatch, 200, 15, 0.3);
        return clustered(runtime, std::move(made));
    }

    base::Runtime runtime;
    DrawnFrame frame{runtime};
};

constexpr Visibility both[] = {Visibility::depth_layers, Visibility::published};

frame::Camera oblique() { return camera_from({0.2, -0.9, 0.6}, size, 1.7); }

// Normals along an axis are already unit vectors, so nothing is rounded.
TEST_F(PosedLayers, MarksAtTheirOwnPlacesGiveTheSameDots) {
    for (const glm::dvec3 origin : {glm::dvec3(0.0), glm::dvec3(0.25, -0.5, 1.0)}) {
        marks::PointSet flat = plane(runtime.memory, 120);
        flat.origin = origin;
        flat.bounds.min += origin;
        flat.bounds.max += origin;
        flat = clustered(runtime, std::move(flat));
        const Places places(flat, 0);
        const std::array poses{places.pose(0)};
        for (const Visibility visibility : both) {
            Style style;
            style.kind[0].radius = 1.5F;
            Item item = layered_item(flat, style);
            draw(item, visibility, oblique());
            const std::vector<Disc> expected(frame.discs().begin(), frame.discs().end());
            const drawing::MarkSource source = frame.drawing().source(7);
            ASSERT_GT(expected.size(), 500U);
            item.poses = poses;
            draw(item, visibility, oblique());
            ASSERT_EQ(frame.discs().size(), expected.size());
            for (std::size_t i = 0; i < expected.size(); ++i) {
                const Disc& disc = frame.discs()[i];
                ASSERT_EQ(disc.id, expected[i].id) << i;
                ASSERT_EQ(glm::vec4(disc.x, disc.y, disc.radius, disc.depth),
                          glm::vec4(expected[i].x, expected[i].y, expected[i].radius, expected[i].depth));
                ASSERT_EQ(disc.color, expected[i].color);
            }
            EXPECT_EQ(frame.drawing().source(7).position, source.position);
            EXPECT_EQ(frame.drawing().source(7).normal, source.normal);
            EXPECT_EQ(frame.drawing().source(7).direction, source.direction);
        }
    }
}

glm::dmat4 turned(double angle, const glm::dvec3& by) {
    glm::dmat4 m(1.0);
    m[0] = {std::cos(angle), 0.0, -std::sin(angle), 0.0};
    m[2] = {std::sin(angle), 0.0, std::cos(angle), 0.0};
    m[3] = glm::dvec4(by, 1.0);
    return m;
}

TEST_F(PosedLayers, ARigidMotionEqualsAnItemTransform) {
    const marks::PointSet set = ring();
    for (const glm::dmat4& motion : {turned(0.7, {0.3, -0.2, 0.4}), turned(2.5, {-0.2, 0.0, 0.1})}) {
        const Places stipples(set, 0, motion);
        const Places strokes(set, 1, motion);
        const std::array poses{strokes.pose(1), stipples.pose(0)}; // in any order
        for (const Visibility visibility : both) {
            Style style;
            style.tone_fade = 0.0F;
            style.tone_curve = frame::ToneCurve::linear;
            draw(layered_item(set, style, motion), visibility, oblique());
            const std::map<std::uint32_t, Disc> expected = inks();
            ASSERT_GT(expected.size(), 2000U);
            std::vector<drawing::MarkSource> sources;
            for (const auto& [id, disc] : expected) sources.push_back(frame.source(disc));
            Item item = layered_item(set, style);
            item.poses = poses;
            draw(item, visibility, oblique());
            const std::map<std::uint32_t, Disc> found = inks();
            // Rounding decides about a few marks.
            EXPECT_NEAR(static_cast<double>(found.size()), static_cast<double>(expected.size()),
                        0.01 * static_cast<double>(expected.size()));
            std::size_t missing = 0;
            std::size_t dimmed = 0;
            std::size_t at = 0;
            for (const auto& [id, disc] : expected) {
                const drawing::MarkSource& source = sources[at++];
                const auto other = found.find(id);
                if (other == found.end()) {
                    ++missing;
                    continue;
                }
                ASSERT_NEAR(other->second.x, disc.x, 1e-2F) << id;
                ASSERT_NEAR(other->second.y, disc.y, 1e-2F) << id;
                ASSERT_NEAR(other->second.depth, disc.depth, 1e-5F) << id;
                dimmed += std::abs(other->second.color.w - disc.color.w) > 0.02F;
                const drawing::MarkSource moved = frame.source(other->second);
                ASSERT_LT(glm::distance(moved.position, source.position), 1e-5F);
                ASSERT_LT(glm::distance(moved.normal, source.normal), 1e-5F);
                ASSERT_LT(glm::distance(moved.direction, source.direction), 1e-5F);
            }
            EXPECT_LE(missing, expected.size() / 100);
            EXPECT_LE(dimmed, expected.size() / 100);
        }
    }
}

TEST_F(PosedLayers, MissingDirectionsAreTakenFromTheSet) {
    const marks::PointSet set = clustered(runtime, plane(runtime.memory, 10));
    const Places places(set, 0, turned(0.4, {0.0, 0.0, 0.0}));
    std::array poses{places.pose(0)};
    poses[0].direction = {};
    Item item = layered_item(set, Style{});
    item.poses = poses;
    draw(item, Visibility::depth_layers, front_camera(size, size));
    EXPECT_EQ(frame.drawing().source(3).direction, marks::vector_at(set.layers[0].direction, 2));
    EXPECT_NEAR(frame.drawing().source(3).normal.x, std::sin(0.4F), 1e-6F);
}

// A pose holds for one drawing; in the next the layer is at its old place.
TEST_F(PosedLayers, APoseLastsForOneDrawing) {
    const marks::PointSet set = ring();
    const Places stipples(set, 0, turned(0.7, {0.3, -0.2, 0.4}));
    const std::array poses{stipples.pose(0)};
    Item item = layered_item(set, Style{});
    draw(item, Visibility::depth_layers, oblique());
    const std::size_t before = frame.discs().size();
    const Disc first = frame.discs()[0];
    item.poses = poses;
    draw(item, Visibility::depth_layers, oblique());
    EXPECT_NE(glm::vec2(frame.discs()[0].x, frame.discs()[0].y), glm::vec2(first.x, first.y));
    item.poses = {};
    draw(item, Visibility::depth_layers, oblique());
    ASSERT_EQ(frame.discs().size(), before);
    EXPECT_EQ(glm::vec2(frame.discs()[0].x, frame.discs()[0].y), glm::vec2(first.x, first.y));
}

// Marks that are far from their old places are still inside of the view.
TEST_F(PosedLayers, MarksMayBeFarFromTheirSet) {
    const marks::PointSet set = clustered(runtime, plane(runtime.memory, 60));
    const glm::dmat4 away = turned(0.0, {500.0, 0.0, 0.0});
    const Places places(set, 0, away);
    const std::array poses{places.pose(0)};
    Item item = layered_item(set, all_front(frame::HiddenLines::hide));
    item.poses = poses;
    frame::Camera camera = front_camera(size, size);
    camera.view = camera.view * glm::inverse(away);
    draw(item, Visibility::depth_layers, camera);
    EXPECT_EQ(frame.info().shown, 3600);
    EXPECT_EQ(frame.info().outside + frame.info().culled, 0);
    draw(item, Visibility::depth_layers, front_camera(size, size));
    EXPECT_EQ(frame.info().shown, 0);
}

TEST_F(PosedLayers, AllocatesNothingOnceWarm) {
    test::Allocator counter;
    const base::Runtime counted = test::with_allocator(counter);
    marks::PointSet made = torus(counted.memory, 90);
    const marks::PointSet set = clustered(counted, std::move(made));
    DrawnFrame own(counted);
    const auto round = [&] {
        for (int step = 0; step < 8; ++step) {
            const Places places(set, 0, turned(0.8 * step, {0.0, 0.1 * step, 0.0}));
            const std::array poses{places.pose(0)};
            std::array items{layered_item(set, Style{})};
            items[0].poses = poses;
            own.draw(items, oblique());
            ASSERT_FALSE(own.discs().empty());
        }
    };
    round();
    const std::int64_t warm = counter.calls;
    round();
    EXPECT_EQ(counter.calls, warm);
}

// Each of many items is drawn as it is alone: data that is kept for one item does not move when others follow.
class ManyItems : public PosedLayers {
protected:
    static constexpr int many = 11;

    void expect_sum(const std::vector<Item>& items, const frame::Camera& camera) {
        for (const Visibility visibility : both) {
            std::int64_t expected = 0;
            std::vector<Item> all = items;
            for (Item& item : all) {
                item.style.visibility = visibility;
                DrawnFrame alone(runtime);
                alone.draw(std::array{item}, camera);
                expected += alone.info().shown;
                ASSERT_GT(alone.info().shown, 0);
            }
            DrawnFrame together(runtime);
            together.draw(all, camera);
            EXPECT_EQ(together.info().shown, expected);
        }
    }

    marks::PointSet set = clustered(runtime, plane(runtime.memory, 30));
    // Places the items beside each other, none in front of another.
    [[nodiscard]] static glm::dmat4 place(int i) { return turned(0.0, {2.5 * (i - many / 2), 0.0, 0.0}); }
    [[nodiscard]] static frame::Camera wide(bool from_behind) {
        return camera_from({0.0, 0.0, from_behind ? -1.0 : 1.0}, size, 40.0);
    }
};

TEST_F(ManyItems, AreDrawnFromBothSides) {
    std::vector<Item> items;
    for (int i = 0; i < many; ++i) {
        items.push_back(layered_item(set, all_front(frame::HiddenLines::hide), place(i)));
        items.back().both_sides = true;
    }
    for (const bool from_behind : {false, true}) expect_sum(items, wide(from_behind));
}

TEST_F(ManyItems, AreDrawnWithPoses) {
    std::vector<Places> places;
    for (int i = 0; i < many; ++i) places.emplace_back(set, 0, place(i));
    std::vector<Pose> poses;
    for (const Places& one : places) poses.push_back(one.pose(0));
    std::vector<Item> items;
    for (const Pose& pose : poses) {
        items.push_back(layered_item(set, all_front(frame::HiddenLines::hide)));
        items.back().poses = std::span(&pose, 1);
        items.back().both_sides = true;
    }
    for (const bool from_behind : {false, true}) expect_sum(items, wide(from_behind));
}

class BadPose : public PosedLayers {
protected:
    void expect_error(std::span<const Pose> poses, const char* text) {
        std::array items{layered_item(set, Style{}), layered_item(set, Style{})};
        items[1].poses = poses;
        try {
            frame.draw(items, front_camera(size, size));
            ADD_FAILURE() << "no error: " << text;
        } catch (const Error& error) {
            EXPECT_EQ(error.status(), Status::invalid_argument);
            EXPECT_THAT(error.what(), HasSubstr(text));
        }
    }

    marks::PointSet set = clustered(runtime, plane(runtime.memory, 5));
    Places places{set, 0};
};

TEST_F(BadPose, DoesNotAffectTheNextDrawing) {
    places.normal[2] = 3.0;
    expect_error(std::array{places.pose(0)}, "normal[0]");
    const std::array items{layered_item(set, all_front(frame::HiddenLines::hide))};
    frame.draw(items, front_camera(size, size));
    EXPECT_EQ(frame.info().shown, 25);
}

} // namespace
} // namespace hrbfnpr::testing::pose_test
