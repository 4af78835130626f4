// SPDX-License-Identifier: MIT
// Tests hatching: nested lines whose width makes the tone.
#include "frame/hatching.h"
#include "support/instruction_sets.h"

namespace hrbfnpr::testing::hatch_test {
namespace {

TEST_F(Hatch, CoverageMatchesTheToneAtAnyZoom) {
    set = nested_plane(runtime.memory);
    cluster();
    double worst = 0.0;
    for (const double dark : {0.16, 0.3, 0.5, 0.65}) {
        darkness = [=](const glm::dvec3&) { return dark; };
        for (const double half : {0.15, 0.4, 0.62, 0.8, 1.0, 1.25, 2.5}) {
            draw(front_camera(size, size, half));
            const double error = plane_ink(half) - coverage(layer, dark);
            EXPECT_NEAR(error, 0.0, 0.003) << dark << " " << half;
            worst = std::max(worst, std::abs(error));
        }
    }
    RecordProperty("worst_error", std::to_string(worst));
}

// The real distances of the lines count, not their intended separation: on the whole surface, and in parts of it.
TEST_F(Hatch, CoverageMatchesTheToneForAnyLineDistance) {
    for (const double stretch : {0.7, 1.0, 1.4}) {
        set = nested_plane(runtime.memory);
        marks::Layer& layer_of_lines = layer_of(set, marks::Kind::own);
        const auto stretched = [=](double y) { return y < 0.0 ? y : stretch * y; };
        for (std::int64_t i = 0; i < layer_of_lines.count(); ++i) {
            float& y = layer_of_lines.position[3 * i + 1];
            y = static_cast<float>(stretched(static_cast<double>(y)));
        }
        cluster();
        darkness = [](const glm::dvec3&) { return 0.5; };
        draw(front_camera(size, size, 1.25)); // 200 pixels per unit
        for (const double side : {-1.0, 1.0}) {
            // The rectangle has five periods of the coarsest lines, and begins between two lines.
            const double period = 200.0 * (side < 0.0 ? 1.0 : stretch) * step;
            const double middle = -side * (30.0 + 0.5) * period;
            EXPECT_NEAR(ink(100.0, 20.0 * period, 0.5 * size, middle), coverage(layer, 0.5), 0.004)
                << stretch << ' ' << side;
        }
    }
}

TEST_F(Hatch, CoverageMatchesTheToneOnASlant) {
    set = nested_plane(runtime.memory);
    cluster();
    darkness = [](const glm::dvec3&) { return 0.5; };
    for (const bool perspective : {false, true}) {
        for (const double turn : {0.0, 0.5 * pi, 1.0}) {
            for (const double tilt : {0.5, 1.0}) {
                frame::Camera camera;
                const glm::dvec3 toward(std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn),
                                        std::cos(tilt));
                camera.view = frame::look_at(4.0 * toward, glm::dvec3(0.0), {-std::sin(turn), std::cos(turn), 0.0});
                camera.projection = perspective ? frame::perspective(0.6, size, size, 1.0, 20.0, camera.depth)
                                                : frame::orthographic(2.4, size, size, 1.0, 20.0, camera.depth);
                camera.viewport = {0.0, 0.0, size, size};
                draw(camera);
                // The rectangle cuts periods, so the tolerance is larger.
                EXPECT_NEAR(ink(80.0, 80.0), coverage(layer, 0.5), 0.03) << turn << " " << tilt << " " << perspective;
            }
        }
    }
}

// The line is of the finest level up to the middle, and of the coarsest from there on, where alone there is room for
// it.
TEST_F(Hatch, ALineChangesItsLevel) {
    set = nested_plane(runtime.memory);
    constexpr std::uint32_t first = 101 * 201; // first mark of the line beside the middle one
    ASSERT_EQ(set.layers[0].level[first], finest);
    for (std::uint32_t i = 100; i <= 200; ++i) set.layers[0].level[first + i] = 0;
    cluster();
    darkness = [](const glm::dvec3&) { return 0.6; };
    draw(front_camera(size, size, 1.25));
    int seen = 0;
    for (const StrokePoint& p : frame.drawing().points) {
        if (p.id - 1 < first || p.id - 1 > first + 200) continue;
        EXPECT_GT(p.x, 0.5F * size - 2.5F);
        ++seen;
    }
    EXPECT_GE(seen, 20);
}

// No level appears suddenly, neither as ink nor as lines that are wide at once.
TEST_F(Hatch, ZoomingCausesNoJumps) {
    set = nested_plane(runtime.memory);
    cluster();
    darkness = [](const glm::dvec3&) { return 0.45; };
    std::vector<double> before;
    for (double half = 1.3; half > 0.3; half *= 0.99) {
        draw(front_camera(size, size, half));
        EXPECT_NEAR(plane_ink(half), coverage(layer, 0.45), 0.01) << half;
        std::vector<double> widths(finest + 1, 0.0); // widths of each level in the picture's middle
        for (const StrokePoint& p : frame.drawing().points) {
            if (std::abs(p.x - 0.5F * size) > 40.0F || std::abs(p.y - 0.5F * size) > 150.0F) continue;
            const std::uint8_t level = set.layers[0].level[p.id - 1];
            widths[level] = std::max(widths[level], 2.0 * static_cast<double>(p.radius));
        }
        for (std::size_t k = 0; !before.empty() && k < widths.size(); ++k)
            EXPECT_NEAR(widths[k], before[k], 0.2) << "level " << k << " at " << half;
        before = widths;
    }
}

TEST_F(Hatch, WhiteGapsAndPensHaveAMinimumWidth) {
    set = nested_plane(runtime.memory);
    cluster();
    layer.hatch_coverage_end = 1.0F;
    for (const double half : {0.5, 0.8, 1.25}) {
        draw(front_camera(size, size, half));
        std::vector<std::pair<float, float>> lines; // place and half width of each line in the middle
        for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s) {
            const auto points = points_of(s);
            const StrokePoint& p = points[points.size() / 2];
            lines.emplace_back(p.y, p.radius);
        }
        std::sort(lines.begin(), lines.end());
        ASSERT_GT(lines.size(), 20U);
        for (std::size_t i = 1; i < lines.size(); ++i) {
            const float white = lines[i].first - lines[i].second - lines[i - 1].first - lines[i - 1].second;
            EXPECT_GT(white, 0.5F * layer.hatch_white - 0.01F) << half; // half the white, while a level fades in
        }
    }
    layer.hatch_pen = 3.0F;
    layer.hatch_white = 0.0F;
    darkness = [](const glm::dvec3&) { return 0.2; };
    draw(front_camera(size, size, 0.5));
    ASSERT_GT(frame.drawing().strokes.size(), 3);
    for (std::int64_t s = 0; s < frame.drawing().strokes.size(); ++s) {
        const StrokePoint& middle = points_of(s)[points_of(s).size() / 2];
        if (set.layers[0].level[middle.id - 1] > 0) continue;
        EXPECT_GT(middle.radius, 0.94F * 1.5F);
    }
}

TEST_F(Hatch, WithoutASeparationTheRadiusSetsTheWidth) {
    add_line(set, {0.0, -1.0, 1.0, 2}, 0.02);
    set.spacing = 0.02;
    cluster();
    layer.radius = 3.0F;
    for (const double dark : {0.2, 0.5, 1.0}) {
        darkness = [=](const glm::dvec3&) { return dark; };
        draw(front_camera(size, size, 1.25));
        ASSERT_EQ(frame.drawing().strokes.size(), 1);
        EXPECT_NEAR(radius_at(points_of(0), 250.0), 3.0 * coverage(layer, dark) / coverage(layer, 1.0), 1e-4);
    }
}

TEST_F(Hatch, ScalingThePictureAndItsLengthsScalesTheLines) {
    add_latitudes(set);
    cluster();
    style.tone = frame::Tone::light;
    style.light = {-0.5, 0.6, 0.6};
    const auto camera_of = [](int side) {
        frame::Camera camera = front_camera(side, side, 1.25);
        camera.view = frame::look_at({4.0, -7.0, 5.0}, glm::dvec3(0.0), {0, 0, 1});
        return camera;
    };
    struct Ends {
        std::int64_t stroke;
        float x, y, length;
    };
    const auto ends_of = [&](int side) {
        const drawing::Drawing& drawing = draw(camera_of(side));
        const float scale = static_cast<float>(size) / static_cast<float>(side);
        std::vector<Ends> ends;
        for (std::int64_t s = 0; s < drawing.strokes.size(); ++s) {
            const StrokePoint& p = points_of(s).front();
            ends.push_back(
                {drawing.identify(p.id).stroke, scale * p.x, scale * p.y, scale * points_of(s).back().length});
        }
        std::sort(ends.begin(), ends.end(), [](const Ends& a, const Ends& b) {
            return a.stroke != b.stroke ? a.stroke < b.stroke : a.length < b.length;
        });
        return ends;
    };
    const std::vector<Ends> small = ends_of(size);
    const double ink_before = ink(150.0, 150.0);
    for (float* const length :
         {&layer.hatch_spacing, &layer.hatch_pen, &layer.hatch_white, &layer.hatch_taper, &layer.hatch_shortest})
        *length *= 2.0F;
    const std::vector<Ends> large = ends_of(2 * size);
    ASSERT_EQ(large.size(), small.size());
    for (std::size_t s = 0; s < large.size(); ++s) {
        EXPECT_NEAR(large[s].length, small[s].length, 0.3F) << s;
        EXPECT_NEAR(large[s].x, small[s].x, 0.05F) << s;
        EXPECT_NEAR(large[s].y, small[s].y, 0.05F) << s;
    }
    EXPECT_NEAR(ink(300.0, 300.0, size), ink_before, 0.002);
}

TEST_F(Hatch, AFillLightThinsLinesOnTheDarkSide) {
    set = nested_plane(runtime.memory);
    cluster();
    style.tone = frame::Tone::light;
    style.light = {0.6, 0.0, -0.8};
    for (const float fill : {0.25F, 1.0F}) {
        style.fill_light = fill;
        draw(front_camera(size, size, 1.25));
        EXPECT_NEAR(plane_ink(1.25), coverage(layer, 1.0 - double{fill} * 0.64), 0.01) << fill;
    }
}

// Sets all normals for tone of a layer, turned by an angle about the x axis.
void tilt_tone_normals(marks::Layer& marks, double angle) {
    for (std::int64_t i = 0; i < marks.count(); ++i)
        for (const double x : {0.0, std::sin(angle), std::cos(angle)})
            marks.tone_normal.push_back(static_cast<float>(x));
}

TEST_F(Hatch, ToneUsesTheToneNormals) {
    set = nested_plane(runtime.memory);
    tilt_tone_normals(set.layers[0], 1.0);
    cluster();
    style.tone = frame::Tone::light;
    style.light = {0.0, 0.0, 1.0}; // along the normals themselves
    draw(front_camera(size, size, 1.25));
    EXPECT_NEAR(plane_ink(1.25), coverage(layer, 1.0 - std::cos(1.0)), 0.01);
    // In full light there are no strokes.
    style.light = {0.0, std::sin(1.0), std::cos(1.0)};
    draw(front_camera(size, size, 1.25));
    EXPECT_EQ(frame.drawing().strokes.size(), 0);
    style.tone = frame::Tone::callback;
    style.tone_user = nullptr;
    style.tone_function = [](void*, std::int64_t count, const float*, const float* normals, float* tau) {
        for (std::int64_t i = 0; i < count; ++i) tau[i] = normals[3 * i + 1] > 0.5F ? 0.5F : 0.0F;
        return std::int32_t{0};
    };
    draw(front_camera(size, size, 1.25));
    EXPECT_NEAR(plane_ink(1.25), coverage(layer, 0.5), 0.01);
}

// Marks stay at their places, but turn by a quarter about their normals.
TEST_F(Hatch, ToneNormalsTurnWithTheirMarks) {
    set = nested_plane(runtime.memory);
    tilt_tone_normals(set.layers[0], 1.0);
    cluster();
    const marks::Layer& marks = set.layers[0];
    std::vector<float> direction;
    for (std::int64_t i = 0; i < marks.count(); ++i)
        for (const float x : {0.0F, 1.0F, 0.0F}) direction.push_back(x); // before, they were along x
    const auto view = [&](const float* data) {
        return base::InView{reinterpret_cast<const std::byte*>(data), marks.count(), 12, base::Scalar::float32, 3};
    };
    style.tone = frame::Tone::light;
    style.light = {-std::sin(1.0), 0.0, std::cos(1.0)}; // the direction of the turned normals for tone
    style.layers = std::span(&layer, 1);
    frame::Pose pose;
    pose.position = view(marks.position.data());
    pose.normal = view(marks.normal.data());
    frame::Item item = layered_item(set, style);
    item.poses = std::span(&pose, 1);
    for (const bool directed : {true, false}) {
        if (directed) pose.direction = view(direction.data());
        if (!directed) pose.direction = {};
        frame.draw({&item, 1}, front_camera(size, size, 1.25));
        if (directed)
            EXPECT_EQ(frame.drawing().strokes.size(), 0) << "in full light";
        else
            EXPECT_NEAR(plane_ink(1.25), coverage(layer, 1.0 - std::cos(1.0)), 0.01) << "by the normals";
    }
}

// Pieces that cannot be skipped are processed, and turn out not to be drawn.
class HatchPieces : public Hatch, public ::testing::WithParamInterface<bool> {
protected:
    // Normals for tone lean to one side, out of the cones of the normals.
    static void add_ball(marks::PointSet& to) {
        add_latitudes(to);
        if (!GetParam()) return;
        marks::Layer& ball = to.layers[0];
        for (std::int64_t i = 0; i < ball.count(); ++i) {
            const glm::dvec3 soft = glm::normalize(glm::dvec3(marks::vector_at(ball.normal, i)) + lean);
            for (int k = 0; k < 3; ++k) ball.tone_normal.push_back(static_cast<float>(soft[k]));
        }
    }
    static void open_pieces(marks::Layer& ball) {
        for (marks::StrokePiece& piece : ball.clusters.piece) {
            piece.cone.cosine = piece.tone.cosine = -1.0F;
            piece.cone.sine = piece.tone.sine = 0.0F;
            piece.level = 0;
        }
    }
    static constexpr glm::dvec3 lean{0.3, -0.5, 0.4};
};
INSTANTIATE_TEST_SUITE_P(WithAndWithoutNormalsForTone, HatchPieces, ::testing::Bool());

TEST_P(HatchPieces, SkippedPiecesWouldNotBeDrawn) {
    add_ball(set);
    cluster();
    style.tone = frame::Tone::light;
    marks::PointSet open(runtime.memory);
    add_ball(open);
    open = clustered(runtime, std::move(open));
    open_pieces(open.layers[0]);
    style.layers = std::span(&layer, 1);
    DrawnFrame other(runtime);
    for (const double half : {0.4, 1.25, 4.0}) {
        for (int turn = 0; turn < 6; ++turn) {
            frame::Camera camera = front_camera(size, size, half);
            camera.view = frame::look_at({7.0 * std::cos(turn), 7.0 * std::sin(turn), 5.0}, glm::dvec3(0.0), {0, 0, 1});
            const std::array items{layered_item(set, style)};
            frame.draw(items, camera);
            const std::array open_items{layered_item(open, style)};
            other.draw(open_items, camera);
            const base::Array<Stroke>& expected = other.drawing().strokes;
            const base::Array<Stroke>& found = frame.drawing().strokes;
            ASSERT_EQ(found.size(), expected.size()) << half << " " << turn;
            for (std::int64_t i = 0; i < found.size(); ++i) {
                for (const bool last : {false, true}) {
                    const StrokePoint& a = frame.drawing().points[found[i].first + (last ? found[i].count - 1 : 0)];
                    const StrokePoint& b =
                        other.drawing().points[expected[i].first + (last ? expected[i].count - 1 : 0)];
                    ASSERT_NEAR(a.x, b.x, 0.05) << half << " " << turn;
                    ASSERT_NEAR(a.y, b.y, 0.05);
                    ASSERT_NEAR(a.length, b.length, 0.1);
                }
            }
        }
    }
}

TEST_F(Hatch, CountsAndLayersDescribeTheDrawing) {
    set = nested_plane(runtime.memory);
    cluster();
    darkness = [](const glm::dvec3& p) { return p.x > 0.0 ? 0.6 : 0.0; };
    const drawing::Drawing& drawing = draw(front_camera(size, size, 1.25));
    EXPECT_EQ(drawing.dot_count, 0);
    EXPECT_EQ(drawing.counts.dropped_hidden, 0);
    EXPECT_EQ(drawing.counts.marks, set.layers[0].count());
    EXPECT_GT(drawing.counts.shown, 0);
    EXPECT_LE(drawing.counts.shown, set.layers[0].count() / 2 + 201);
    EXPECT_TRUE(drawing.layers[0].as_strokes);
    EXPECT_TRUE(drawing.layers[0].as_hatch);
    EXPECT_EQ(drawing.layers.size(), 1) << "contours of marks are drawn as published only";
    for (std::int64_t s = 0; s < drawing.strokes.size(); ++s) {
        EXPECT_EQ(drawing.strokes[s].layer, 0U);
        std::int64_t stroke = drawing.identify(points_of(s).front().id).stroke;
        for (const StrokePoint& p : points_of(s)) EXPECT_EQ(drawing.identify(p.id).stroke, stroke);
    }
    // The published visibility draws dots.
    style.tone = frame::Tone::none;
    style.layers = std::span(&layer, 1);
    const std::array items{item_of(set, style)};
    frame.draw(items, front_camera(size, size));
    EXPECT_TRUE(frame.drawing().strokes.empty());
    EXPECT_GT(frame.discs().size(), 10000U);
}

} // namespace
} // namespace hrbfnpr::testing::hatch_test
