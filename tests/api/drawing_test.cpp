// A drawing as a value: what it is made of, and everything that is read of it.
#include "fixture.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace api_test {
namespace {

constexpr std::int32_t side = 128;

struct Vertex {
    float position[3];
    float window[3];
    float radius;
    float color[4];
    std::uint32_t id;
    std::uint32_t mark_class;
    std::uint32_t is_paper;
    std::uint32_t layer;
    float length;
};

struct Vertices {
    std::vector<Vertex> vertex;
    std::vector<std::uint32_t> index;
};

Vertices vertices_of(const Drawing& drawing, std::uint32_t primitive) {
    Error error;
    Layout layout(primitive);
    layout.stride = sizeof(Vertex);
    layout.add(HRBFNPR_VERTEX_ATTRIBUTE_POSITION, HRBFNPR_SCALAR_FLOAT32, offsetof(Vertex, position))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, offsetof(Vertex, window))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_RADIUS, HRBFNPR_SCALAR_FLOAT32, offsetof(Vertex, radius))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_COLOR, HRBFNPR_SCALAR_FLOAT32, offsetof(Vertex, color))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_ID, HRBFNPR_SCALAR_UINT32, offsetof(Vertex, id))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_CLASS, HRBFNPR_SCALAR_UINT32, offsetof(Vertex, mark_class))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_IS_PAPER, HRBFNPR_SCALAR_UINT32, offsetof(Vertex, is_paper))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_LAYER, HRBFNPR_SCALAR_UINT32, offsetof(Vertex, layer))
        .add(HRBFNPR_VERTEX_ATTRIBUTE_LENGTH, HRBFNPR_SCALAR_FLOAT32, offsetof(Vertex, length));
    std::int64_t count = 0;
    std::int64_t indices = 0;
    EXPECT_OK(hrbfnpr_drawing_vertex_bound(drawing.get(), primitive, &count, &indices, error));
    Vertices all{std::vector<Vertex>(static_cast<std::size_t>(count)),
                 std::vector<std::uint32_t>(static_cast<std::size_t>(indices))};
    std::int64_t written = -1;
    std::int64_t written_indices = -1;
    EXPECT_OK(hrbfnpr_drawing_write_vertices(drawing.get(), layout.get(), all.vertex.data(), count, &written,
                                             all.index.data(), indices, &written_indices, error));
    EXPECT_EQ(written, count);
    EXPECT_EQ(written_indices, indices);
    return all;
}

// The strips of an array of indices, each without the restart that ends it.
std::vector<std::vector<std::uint32_t>> strips_of(const std::vector<std::uint32_t>& index) {
    std::vector<std::vector<std::uint32_t>> strips;
    std::vector<std::uint32_t> strip;
    for (const std::uint32_t i : index) {
        if (i != static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART)) {
            strip.push_back(i);
            continue;
        }
        strips.push_back(strip);
        strip.clear();
    }
    EXPECT_TRUE(strip.empty()) << "the last strip is not ended";
    return strips;
}

hrbfnpr_mark_identity identity_of(const Drawing& drawing, std::uint32_t id) {
    Error error;
    auto identity = made(hrbfnpr_mark_identity_init);
    EXPECT_OK(hrbfnpr_drawing_identify(drawing.get(), id, &identity, error));
    return identity;
}

struct Results {
    std::vector<std::uint8_t> shown;
    std::vector<float> radius, opacity;
};

Results results_of(const Drawing& drawing, const PointSet& set, std::int64_t layer) {
    Error error;
    const auto count = static_cast<std::size_t>(layer_info(set, layer).marks);
    Results results{std::vector<std::uint8_t>(count, 77), std::vector<float>(count, -1.0F),
                    std::vector<float>(count, -1.0F)};
    auto wanted = made(hrbfnpr_mark_results_init);
    wanted.shown = out(results.shown, 1);
    wanted.radius = out(results.radius, 1);
    wanted.opacity = out(results.opacity, 1);
    EXPECT_OK(hrbfnpr_drawing_mark_results(drawing.get(), 0, layer, &wanted, error));
    return results;
}

std::vector<std::uint32_t> indices_of(const Drawing& drawing, std::int64_t layer, std::uint32_t mark_class,
                                      std::uint32_t primitive) {
    Error error;
    std::int64_t count = 0;
    const hrbfnpr_status status =
        hrbfnpr_drawing_write_mark_indices(drawing.get(), 0, layer, mark_class, primitive, nullptr, 0, &count, error);
    EXPECT_EQ(status, count == 0 ? HRBFNPR_STATUS_OK : HRBFNPR_STATUS_BUFFER_TOO_SMALL);
    std::vector<std::uint32_t> indices(static_cast<std::size_t>(count));
    EXPECT_OK(hrbfnpr_drawing_write_mark_indices(drawing.get(), 0, layer, mark_class, primitive, indices.data(), count,
                                                 &count, error));
    return indices;
}

// Three layers on a sphere, and a fourth of two own strokes: an arc along the equator and one towards the pole.
class DrawingTest : public testing::Test {
protected:
    static constexpr std::int64_t own = 3;
    static constexpr int arc = 40; // marks of a stroke

    DrawingTest() {
        for (int s = 0; s < 2; ++s)
            for (int i = 0; i < arc; ++i) {
                const double a = -0.6 + 1.2 * i / (arc - 1);
                place.insert(place.end(), {s == 0 ? std::sin(a) : 0.0, s == 0 ? 0.0 : std::sin(a), std::cos(a)});
            }
        auto arrays = made(hrbfnpr_layer_arrays_init);
        arrays.name = "arcs";
        arrays.position = arrays.normal = in(place);
        arrays.stroke_first = in(first, 1);
        arrays.rank = in(rank, 1);
        auto desc = made(hrbfnpr_point_set_desc_init);
        const PointSet base = generate(context, custom_sphere(context, sphere), small_desc());
        desc.base = base.get();
        desc.layers = &arrays;
        desc.layer_count = 1;
        hrbfnpr_point_set* made_set = nullptr;
        EXPECT_OK(hrbfnpr_point_set_create(context.get(), &desc, &made_set, error));
        set.reset(made_set);
        // Own strokes in red, wide, whatever the light is; all strokes as strokes.
        layers[0].name = "arcs";
        layers[0].ink[0] = 1.0F;
        layers[0].radius = 2.0F;
        layers[0].contours = 0;
        layers[0].shape = layers[1].shape = HRBFNPR_SHAPE_STROKES;
        style.layers = layers;
        style.layer_count = 2;
        style.tone = HRBFNPR_TONE_NONE;
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    }

    Drawing drawn() { return draw_item(renderer, item_of(set, &style), front_camera(side)); }
    // Where a world point is in the picture.
    std::array<double, 2> pixel(const double* p) {
        const hrbfnpr_camera camera = front_camera(side);
        double eye[3] = {0, 0, 0};
        for (int row = 0; row < 3; ++row)
            for (int column = 0; column < 4; ++column)
                eye[row] += camera.view[4 * column + row] * (column < 3 ? p[column] : 1.0);
        return {side * (0.5 - 0.5 * camera.projection[0] * eye[0] / eye[2]),
                side * (0.5 + 0.5 * camera.projection[5] * eye[1] / eye[2])};
    }

    Error error;
    Context context = make_context();
    Sphere sphere;
    std::vector<double> place;
    std::vector<std::uint32_t> first{0, arc, 2 * arc};
    std::vector<float> rank = std::vector<float>(2 * arc, 0.99F);
    PointSet set;
    Renderer renderer = make_renderer(context);
    hrbfnpr_layer_style layers[2] = {made(hrbfnpr_layer_style_init), made(hrbfnpr_layer_style_init)};
    hrbfnpr_style style = made(hrbfnpr_style_init);
};

TEST_F(DrawingTest, OwnStrokesAreWhereTheyShouldBe) {
    layers[1].shown = layers[1].contours = 0; // nothing else
    const Drawing drawing = drawn();
    const hrbfnpr_drawing_info info = info_of(drawing);
    EXPECT_EQ(info.strokes, 2);
    EXPECT_EQ(info.stroke_points, 2 * arc);
    const std::vector<std::uint8_t> pixels = rasterize(drawing, side);
    std::vector<bool> near(static_cast<std::size_t>(side * side));
    for (std::size_t i = 0; i < place.size(); i += 3) {
        const auto at = pixel(&place[i]);
        const std::size_t centre = static_cast<std::size_t>(at[1]) * side + static_cast<std::size_t>(at[0]);
        EXPECT_EQ(pixels[4 * centre], 255);
        EXPECT_LT(pixels[4 * centre + 1], 60) << "mark " << i / 3;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                if (std::hypot(x + 0.5 - at[0], y + 0.5 - at[1]) < 4.0)
                    near[static_cast<std::size_t>(side * y + x)] = true;
    }
    for (std::size_t i = 0; i < near.size(); ++i) ASSERT_TRUE(near[i] || pixels[4 * i + 1] == 255) << i;
}

TEST_F(DrawingTest, ItsLayersSayWhatTheyAre) {
    const Drawing drawing = drawn();
    const hrbfnpr_drawing_info info = info_of(drawing);
    std::int64_t dots = 0;
    std::int64_t strokes = 0;
    bool arcs = false;
    for (std::int64_t number = 0; number < info.layers; ++number) {
        auto layer = made(hrbfnpr_drawing_layer_info_init);
        ASSERT_OK(hrbfnpr_drawing_get_layer_info(drawing.get(), number, &layer, error));
        dots += layer.dots;
        strokes += layer.strokes;
        EXPECT_TRUE(layer.mark_class != HRBFNPR_CLASS_SILHOUETTE || layer.strokes == 0);
        if (std::string(layer.name) != "arcs") continue;
        if (layer.mark_class == HRBFNPR_CLASS_SILHOUETTE) {
            EXPECT_EQ(layer.dots, 0) << "contours are not asked for";
            continue;
        }
        arcs = true;
        EXPECT_EQ(layer.layer, own);
        EXPECT_EQ(layer.kind, static_cast<std::uint32_t>(HRBFNPR_LAYER_KIND_OWN));
        EXPECT_EQ(layer.mark_class, static_cast<std::uint32_t>(HRBFNPR_CLASS_FRONT));
        EXPECT_EQ(layer.shape, static_cast<std::uint32_t>(HRBFNPR_SHAPE_STROKES));
        EXPECT_EQ(layer.strokes, 2);
        EXPECT_EQ(layer.ink[0], 1.0F);
    }
    EXPECT_TRUE(arcs);
    EXPECT_EQ(dots, info.dots);
    EXPECT_EQ(strokes, info.strokes);
}

// ---- memory --------------------------------------------------------------------------------

TEST(DrawingMemory, IsRecycledWhenNobodyHoldsIt) {
    Allocator allocator;
    const Context context = make_context(allocator_desc(allocator));
    Sphere sphere;
    const PointSet set = generate(context, custom_sphere(context, sphere), small_desc());
    const Renderer renderer = make_renderer(context);
    const auto frame = [&] { return draw_item(renderer, item_of(set), front_camera(64)); };
    for (int warm = 0; warm < 4; ++warm) rasterize(frame(), 64);
    std::int64_t before = allocator.calls;
    for (int loop = 0; loop < 10; ++loop) rasterize(frame(), 64);
    EXPECT_EQ(allocator.calls, before) << "released before the next";
    // One is shown while the next is made.
    Drawing shown = frame();
    for (int warm = 0; warm < 4; ++warm) shown = frame();
    before = allocator.calls;
    for (int loop = 0; loop < 10; ++loop) {
        Drawing next = frame();
        rasterize(shown, 64);
        shown = std::move(next);
    }
    EXPECT_EQ(allocator.calls, before) << "released before the next but one";
}

TEST(DrawingMemory, IsLeftAloneWhileItIsHeld) {
    const Context context = make_context(1);
    Sphere sphere;
    const PointSet set = generate(context, custom_sphere(context, sphere), small_desc());
    const Renderer renderer = make_renderer(context);
    std::vector<Drawing> held;
    std::vector<std::vector<std::uint8_t>> pictures;
    for (int i = 0; i < 8; ++i) { // more than a renderer keeps
        auto item = item_of(set);
        item.transform[12] = 0.1 * i;
        held.push_back(draw_item(renderer, item, front_camera(64)));
        pictures.push_back(rasterize(held.back(), 64));
        for (int other = 0; other < i; ++other)
            EXPECT_NE(held.back().get(), held[static_cast<std::size_t>(other)].get());
    }
    for (std::size_t i = 0; i < held.size(); ++i) {
        EXPECT_EQ(rasterize(held[i], 64), pictures[i]);
        EXPECT_TRUE(i == 0 || pictures[i] != pictures[0]);
    }
}

// ---- vertices ------------------------------------------------------------------------------

// "Source over" of round anti-aliased points, as a host does it.
std::vector<double> painted(const std::vector<Vertex>& points) {
    std::vector<double> value(static_cast<std::size_t>(side * side), 1.0);
    for (const Vertex& v : points)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) {
                const double distance = std::hypot(x + 0.5 - double{v.window[0]}, y + 0.5 - double{v.window[1]});
                // Dots of less than half a pixel are not drawn smaller, but paler.
                const double radius = std::max(double{v.radius}, 0.5);
                const double coverage = std::clamp(radius + 0.5 - distance, 0.0, 1.0) * std::pow(std::min(double{v.radius} / radius, 1.0), 2.0);
                double& at = value[static_cast<std::size_t>(side * y + x)];
                at += coverage * double{v.color[3]} * (double{v.color[0]} - at);
            }
    return value;
}

TEST_F(DrawingTest, PointsPaintedFarToNearAreTheImage) {
    for (const std::uint32_t visibility : {HRBFNPR_VISIBILITY_DEPTH_LAYERS, HRBFNPR_VISIBILITY_PUBLISHED}) {
        SCOPED_TRACE(visibility);
        layers[0].shape = layers[1].shape = HRBFNPR_SHAPE_DOTS;
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_ATTENUATE;
        style.visibility = visibility;
        const Drawing drawing = drawn();
        const Vertices points = vertices_of(drawing, HRBFNPR_PRIMITIVE_POINTS);
        ASSERT_GT(points.vertex.size(), 100U);
        for (std::size_t i = 0; i < points.index.size(); ++i) ASSERT_EQ(points.index[i], i);
        float last = 1.0F; // a contour's depth is its own, not its mark's
        for (const Vertex& v : points.vertex)
            if (visibility == HRBFNPR_VISIBILITY_DEPTH_LAYERS && v.mark_class == HRBFNPR_CLASS_FRONT) {
                ASSERT_GE(last + 1e-5F, v.window[2]);
                last = v.window[2];
            }
        const std::vector<double> mine = painted(points.vertex);
        const std::vector<std::uint8_t> theirs = rasterize(drawing, side);
        double worst = 0.0;
        double sum = 0.0;
        for (std::size_t i = 0; i < mine.size(); ++i) {
            const double difference = std::abs(255.0 * mine[i] - theirs[4 * i]);
            worst = std::max(worst, difference);
            sum += difference;
        }
        EXPECT_LT(worst, 3.0);
        EXPECT_LT(sum / static_cast<double>(mine.size()), 0.5);
    }
}

TEST_F(DrawingTest, LineStripsStayWithinTheirStroke) {
    const Drawing drawing = drawn();
    const hrbfnpr_drawing_info info = info_of(drawing);
    const Vertices lines = vertices_of(drawing, HRBFNPR_PRIMITIVE_LINE_STRIPS);
    EXPECT_EQ(static_cast<std::int64_t>(lines.vertex.size()), info.stroke_points);
    const auto strips = strips_of(lines.index);
    EXPECT_EQ(static_cast<std::int64_t>(strips.size()), info.strokes);
    ASSERT_GT(strips.size(), 4U);
    std::vector<bool> used(lines.vertex.size());
    for (const auto& strip : strips) {
        ASSERT_GE(strip.size(), 2U);
        const hrbfnpr_mark_identity begin = identity_of(drawing, lines.vertex[strip[0]].id);
        EXPECT_GE(begin.stroke, 0);
        EXPECT_EQ(lines.vertex[strip[0]].length, 0.0F);
        for (std::size_t i = 0; i < strip.size(); ++i) {
            const Vertex& v = lines.vertex[strip[i]];
            EXPECT_FALSE(used[strip[i]]);
            used[strip[i]] = true;
            const hrbfnpr_mark_identity identity = identity_of(drawing, v.id);
            EXPECT_EQ(identity.layer, begin.layer);
            EXPECT_EQ(identity.stroke, begin.stroke);
            EXPECT_EQ(identity.place, begin.place + static_cast<std::int64_t>(i));
            EXPECT_EQ(v.layer, lines.vertex[strip[0]].layer);
            EXPECT_EQ(v.is_paper, 0U);
            if (i == 0) continue;
            const Vertex& last = lines.vertex[strip[i - 1]];
            EXPECT_NEAR(v.length - last.length, std::hypot(v.window[0] - last.window[0], v.window[1] - last.window[1]),
                        1e-3);
        }
    }
    EXPECT_TRUE(std::all_of(used.begin(), used.end(), [](bool one) { return one; }));
}

TEST_F(DrawingTest, TriangleStripsAreAsWideAsTheirStroke) {
    const Drawing drawing = drawn();
    const Vertices lines = vertices_of(drawing, HRBFNPR_PRIMITIVE_LINE_STRIPS);
    const Vertices triangles = vertices_of(drawing, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS);
    ASSERT_EQ(triangles.vertex.size(), 2 * lines.vertex.size());
    EXPECT_EQ(strips_of(triangles.index).size(), strips_of(lines.index).size());
    for (const auto& strip : strips_of(lines.index))
        for (std::size_t i = 0; i < strip.size(); ++i) {
            const Vertex& centre = lines.vertex[strip[i]];
            const Vertex& left = triangles.vertex[2 * strip[i]];
            const Vertex& right = triangles.vertex[2 * strip[i] + 1];
            EXPECT_EQ(left.id, centre.id);
            EXPECT_EQ(right.id, centre.id);
            for (int axis = 0; axis < 2; ++axis)
                EXPECT_NEAR(0.5F * (left.window[axis] + right.window[axis]), centre.window[axis], 1e-3F);
            const double width = std::hypot(left.window[0] - right.window[0], left.window[1] - right.window[1]);
            // At a corner wider, so that both sides of it keep their width.
            EXPECT_GE(width, 2.0 * double{centre.radius} - 1e-3);
            EXPECT_LE(width, 4.0 * double{centre.radius} + 1e-3);
            if (identity_of(drawing, centre.id).layer != own) continue;
            EXPECT_NEAR(width, 2.0 * double{centre.radius}, 0.02); // an arc without corners
            EXPECT_NEAR(centre.radius, 2.0F, 1e-3F);
        }
    // The first vertex is on the left, as one goes along the stroke and y grows downward.
    for (const auto& strip : strips_of(lines.index)) {
        const Vertex& from = lines.vertex[strip[0]];
        const Vertex& to = lines.vertex[strip[1]];
        const Vertex& left = triangles.vertex[2 * strip[0]];
        const float cross = (to.window[0] - from.window[0]) * (left.window[1] - from.window[1]) -
                            (to.window[1] - from.window[1]) * (left.window[0] - from.window[0]);
        EXPECT_LT(cross, 0.0F);
    }
}

TEST_F(DrawingTest, StrokesFilledAsTrianglesAreTheImage) {
    layers[1].shown = layers[1].contours = 0;
    const Drawing drawing = drawn();
    const std::vector<std::uint8_t> pixels = rasterize(drawing, side);
    const Vertices triangles = vertices_of(drawing, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS);
    double area = 0.0;
    for (const auto& strip : strips_of(triangles.index))
        for (std::size_t i = 2; i < strip.size(); ++i) {
            const float* a = triangles.vertex[strip[i - 2]].window;
            const float* b = triangles.vertex[strip[i - 1]].window;
            const float* c = triangles.vertex[strip[i]].window;
            area += 0.5 * std::abs(double{(b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])});
        }
    double ink = 0.0;
    for (std::size_t i = 0; i < pixels.size(); i += 4) ink += 1.0 - pixels[i + 1] / 255.0;
    EXPECT_NEAR(ink / area, 1.0, 0.15); // round ends, and where the arcs cross
}

// ---- marks ---------------------------------------------------------------------------------

TEST_F(DrawingTest, MarkResultsAgreeWithTheVertices) {
    for (const std::uint32_t shape : {HRBFNPR_SHAPE_DOTS, HRBFNPR_SHAPE_STROKES}) {
        SCOPED_TRACE(shape);
        style.hidden_lines = HRBFNPR_HIDDEN_LINES_ATTENUATE;
        style.tone = HRBFNPR_TONE_LIGHT;
        layers[0].shape = layers[1].shape = shape;
        const Drawing drawing = drawn();
        std::map<std::uint32_t, std::vector<const Vertex*>> by_id;
        const Vertices points = vertices_of(drawing, HRBFNPR_PRIMITIVE_POINTS);
        const Vertices lines = vertices_of(drawing, HRBFNPR_PRIMITIVE_LINE_STRIPS);
        for (const Vertex& v : points.vertex) by_id[v.id].push_back(&v);
        for (const Vertex& v : lines.vertex) by_id[v.id].push_back(&v);
        EXPECT_EQ(lines.vertex.empty(), shape == HRBFNPR_SHAPE_DOTS);
        std::uint32_t id = 0;
        std::int64_t shown = 0;
        for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer) {
            const Results results = results_of(drawing, set, layer);
            for (std::size_t i = 0; i < results.shown.size(); ++i) {
                ++id;
                const auto found = by_id.find(id);
                if (found == by_id.end()) {
                    ASSERT_EQ(results.shown[i], HRBFNPR_CLASS_NONE) << id;
                    ASSERT_EQ(results.radius[i], 0.0F);
                    ASSERT_EQ(results.opacity[i], 0.0F);
                    continue;
                }
                ASSERT_EQ(found->second.size(), 1U) << "mark " << id << " is drawn more than once";
                const Vertex& v = *found->second[0];
                ASSERT_EQ(results.shown[i], v.mark_class) << id;
                ASSERT_EQ(results.radius[i], v.radius) << id;
                ASSERT_FLOAT_EQ(results.opacity[i], v.color[3]) << id;
                ++shown;
            }
        }
        EXPECT_EQ(shown, static_cast<std::int64_t>(by_id.size()));
    }
}

TEST_F(DrawingTest, MarkIndicesAreThoseThatAreShown) {
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_ATTENUATE;
    style.tone = HRBFNPR_TONE_LIGHT;
    const Drawing drawing = drawn();
    for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer)
        for (const std::uint32_t mark_class : {HRBFNPR_CLASS_FRONT, HRBFNPR_CLASS_SILHOUETTE}) {
            SCOPED_TRACE(testing::Message() << layer << ", class " << mark_class);
            const Results results = results_of(drawing, set, layer);
            std::vector<std::uint32_t> points = indices_of(drawing, layer, mark_class, HRBFNPR_PRIMITIVE_POINTS);
            const auto lines = strips_of(indices_of(drawing, layer, mark_class, HRBFNPR_PRIMITIVE_LINE_STRIPS));
            const auto triangles = indices_of(drawing, layer, mark_class, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS);
            std::sort(points.begin(), points.end());
            std::vector<std::uint32_t> wanted;
            for (std::size_t i = 0; i < results.shown.size(); ++i)
                if (results.shown[i] == mark_class) wanted.push_back(static_cast<std::uint32_t>(i));
            EXPECT_EQ(points, wanted);
            const auto first_of = attribute<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST);
            std::vector<std::uint32_t> doubled;
            for (const auto& strip : lines) {
                EXPECT_GE(strip.size(), 2U);
                for (std::size_t i = 0; i < strip.size(); ++i) {
                    EXPECT_EQ(results.shown[strip[i]], mark_class);
                    EXPECT_EQ(strip[i], strip[0] + i);
                    doubled.insert(doubled.end(), {2 * strip[i], 2 * strip[i] + 1});
                }
                const auto stroke = std::upper_bound(first_of.begin(), first_of.end(), strip[0]);
                ASSERT_NE(stroke, first_of.end());
                EXPECT_LT(strip.back(), *stroke) << "a strip goes over the end of its stroke";
                doubled.push_back(static_cast<std::uint32_t>(HRBFNPR_INDEX_RESTART));
            }
            EXPECT_EQ(triangles, doubled);
            EXPECT_TRUE(layer != stipples || lines.empty());
        }
}

TEST_F(DrawingTest, IdsAreNumberedOverItemsAndLayers) {
    const hrbfnpr_item items[2] = {item_of(set, &style), item_of(set, &style)};
    const hrbfnpr_camera camera = front_camera(side);
    hrbfnpr_drawing* raw = nullptr;
    ASSERT_OK(hrbfnpr_renderer_draw(renderer.get(), items, 2, 0, &camera, &raw, error));
    const Drawing drawing(raw);
    std::uint32_t id = 0;
    for (std::int64_t item = 0; item < 2; ++item)
        for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer) {
            const auto stroke = attribute<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE);
            const hrbfnpr_layer_info info = layer_info(set, layer);
            for (std::int64_t mark = 0; mark < info.marks; ++mark) {
                const hrbfnpr_mark_identity identity = identity_of(drawing, ++id);
                ASSERT_EQ(identity.id, id);
                ASSERT_EQ(identity.item, item);
                ASSERT_EQ(identity.layer, layer);
                ASSERT_EQ(identity.mark, mark);
                if (info.strokes == 0) {
                    ASSERT_EQ(identity.stroke, -1);
                    continue;
                }
                ASSERT_GE(identity.stroke, 0);
                ASSERT_LT(identity.stroke, info.strokes);
                ASSERT_EQ(identity.place, stroke[static_cast<std::size_t>(2 * mark + 1)]);
            }
        }
    auto identity = made(hrbfnpr_mark_identity_init);
    for (const std::uint32_t none : {0U, id + 1, 0xFFFFFFFFU})
        EXPECT_FAILS(hrbfnpr_drawing_identify(raw, none, &identity, error), HRBFNPR_STATUS_INVALID_ARGUMENT, "id is ");
}

// ---- formats -------------------------------------------------------------------------------

template <class T>
std::vector<T> image_as(const Drawing& drawing, std::uint32_t format, std::size_t channels) {
    Error error;
    std::vector<T> pixels(static_cast<std::size_t>(side * side) * channels);
    auto image = made(hrbfnpr_image_init);
    image.format = format;
    image.width = image.height = side;
    image.pixels = pixels.data();
    EXPECT_OK(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, error));
    return pixels;
}

TEST_F(DrawingTest, FormatsShowTheSamePicture) {
    layers[0].ink[0] = 0.0F; // black alone
    const Drawing drawing = drawn();
    const auto rgba = image_as<std::uint8_t>(drawing, HRBFNPR_FORMAT_RGBA8, 4);
    const auto coverage = image_as<std::uint8_t>(drawing, HRBFNPR_FORMAT_COVERAGE8, 1);
    const auto floats = image_as<float>(drawing, HRBFNPR_FORMAT_RGBA32F, 4);
    const auto premultiplied = image_as<float>(drawing, HRBFNPR_FORMAT_RGBA32F_PREMULTIPLIED, 4);
    int ink = 0;
    for (std::size_t i = 0; i < coverage.size(); ++i) {
        ASSERT_NEAR(coverage[i], 255 - rgba[4 * i], 1) << i;
        ink += coverage[i] > 128 ? 1 : 0;
        for (std::size_t c = 4 * i; c < 4 * i + 4; ++c) {
            ASSERT_EQ(std::lround(255.0F * floats[c]), rgba[c]) << c;
            ASSERT_NEAR(premultiplied[c], floats[c], 1e-6F) << c; // paper is opaque
        }
    }
    EXPECT_GT(ink, 200);
}

TEST_F(DrawingTest, TransparentPaperHasTheCoverageAsAlpha) {
    style.paper[3] = 0.0F;
    layers[0].ink[0] = 0.0F;
    const Drawing drawing = drawn();
    const auto rgba = image_as<std::uint8_t>(drawing, HRBFNPR_FORMAT_RGBA8_PREMULTIPLIED, 4);
    const auto coverage = image_as<std::uint8_t>(drawing, HRBFNPR_FORMAT_COVERAGE8, 1);
    for (std::size_t i = 0; i < coverage.size(); ++i) ASSERT_NEAR(coverage[i], rgba[4 * i + 3], 1) << i;
}

TEST_F(DrawingTest, CoverageCountsInkOfAnyColour) {
    const auto black = [&](float value) {
        for (hrbfnpr_layer_style& layer : layers) std::fill_n(layer.ink, 3, value);
        std::fill_n(style.silhouette_ink, 3, value);
        return image_as<std::uint8_t>(drawn(), HRBFNPR_FORMAT_COVERAGE8, 1);
    };
    EXPECT_EQ(black(0.0F), black(0.9F));
}

// ---- poses ---------------------------------------------------------------------------------

// Poses of all layers of a set, shifted.
struct Poses {
    std::vector<std::vector<double>> position;
    std::vector<std::vector<float>> normal, direction;
    std::vector<hrbfnpr_layer_pose> pose;

    Poses(const PointSet& set, const std::array<double, 3>& shift) {
        const hrbfnpr_point_set_info info = info_of(set);
        for (std::int64_t layer = 0; layer < info.layers; ++layer) {
            position.emplace_back();
            for (const float coordinate : attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION)) {
                const std::size_t axis = position.back().size() % 3;
                position.back().push_back(double{coordinate} + info.origin[axis] + shift[axis]);
            }
            normal.push_back(attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_NORMAL));
            direction.push_back(attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_DIRECTION));
            pose.push_back(made(hrbfnpr_layer_pose_init));
            pose.back().layer = layer;
            pose.back().position = in(position.back());
            pose.back().normal = in(normal.back());
        }
    }
    void use(hrbfnpr_item& item) const {
        item.poses = pose.data();
        item.pose_count = static_cast<std::int64_t>(pose.size());
    }
};

int most_different(const std::vector<std::uint8_t>& a, const std::vector<std::uint8_t>& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(int{a[i]} - int{b[i]}));
    return most;
}

TEST_F(DrawingTest, APoseOfTheSetsOwnPlacesIsTheSamePicture) {
    const std::vector<std::uint8_t> expected = rasterize(drawn(), side);
    Poses poses(set, {0, 0, 0});
    for (const bool with_directions : {false, true}) {
        for (std::size_t layer = 0; with_directions && layer < poses.pose.size(); ++layer)
            poses.pose[layer].direction = in(poses.direction[layer]);
        hrbfnpr_item item = item_of(set, &style);
        poses.use(item);
        const Drawing drawing = draw_item(renderer, item, front_camera(side));
        EXPECT_LE(most_different(rasterize(drawing, side), expected), 2) << with_directions;
        EXPECT_EQ(info_of(drawing).strokes, info_of(drawn()).strokes);
    }
}

TEST_F(DrawingTest, MovedMarksAreThoseOfAMovedItem) {
    const std::array<double, 3> shift{0.3, -0.2, 0.1};
    const Poses poses(set, shift);
    hrbfnpr_item posed = item_of(set, &style);
    poses.use(posed);
    hrbfnpr_item moved = item_of(set, &style);
    for (std::size_t axis = 0; axis < 3; ++axis) moved.transform[12 + axis] = shift[axis];
    const Drawing expected = draw_item(renderer, moved, front_camera(side));
    const Drawing drawing = draw_item(renderer, posed, front_camera(side));
    EXPECT_NEAR(static_cast<double>(info_of(drawing).shown), static_cast<double>(info_of(expected).shown), 3.0);
    EXPECT_LE(most_different(rasterize(drawing, side), rasterize(expected, side)), 8);
    // What a host reads of it tells where the marks are now.
    for (const Vertex& v : vertices_of(drawing, HRBFNPR_PRIMITIVE_POINTS).vertex) {
        double square = 0.0;
        for (std::size_t axis = 0; axis < 3; ++axis) square += std::pow(double{v.position[axis]} - shift[axis], 2);
        ASSERT_NEAR(square, 1.0, 1e-3);
    }
}

// Only one layer moves; it is where a set made there has it.
TEST_F(DrawingTest, OneLayerMovesAlone) {
    layers[1].shown = layers[1].contours = 0;
    const std::array<double, 3> shift{0.2, 0.1, 0.0};
    Poses poses(set, shift);
    hrbfnpr_item item = item_of(set, &style);
    item.poses = &poses.pose[own];
    item.pose_count = 1;
    const Drawing drawing = draw_item(renderer, item, front_camera(side));
    auto arrays = made(hrbfnpr_layer_arrays_init);
    arrays.name = "arcs";
    arrays.position = in(poses.position[own]);
    arrays.normal = in(poses.normal[own]);
    arrays.stroke_first = in(first, 1);
    arrays.rank = in(rank, 1);
    auto desc = made(hrbfnpr_point_set_desc_init);
    desc.layers = &arrays;
    desc.layer_count = 1;
    hrbfnpr_point_set* raw = nullptr;
    ASSERT_OK(hrbfnpr_point_set_create(context.get(), &desc, &raw, error));
    const PointSet there(raw);
    const Drawing expected = draw_item(renderer, item_of(there, &style), front_camera(side));
    EXPECT_EQ(info_of(drawing).strokes, 2);
    EXPECT_LE(most_different(rasterize(drawing, side), rasterize(expected, side)), 8);
    const std::vector<std::uint8_t> unmoved = rasterize(drawn(), side);
    EXPECT_GT(most_different(rasterize(drawing, side), unmoved), 100);
}

} // namespace
} // namespace api_test
