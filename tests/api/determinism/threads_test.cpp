// SPDX-License-Identifier: MIT
// The same bits for any number of threads, and in any floating-point state of the caller.
#include "fixture.h"

#include <cfenv>
#include <thread>

#if defined(__SSE2__)
#include <xmmintrin.h>
#endif

namespace api_test::threads_test {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Reports carry seconds; everything else of a model or a point set is in its views.
template <class T>
void append(Bytes& bytes, const std::vector<T>& values) {
    const auto* begin = reinterpret_cast<const std::uint8_t*>(values.data());
    bytes.insert(bytes.end(), begin, begin + values.size() * sizeof(T));
}

void append(Bytes& bytes, const PointSet& set) {
    for (std::int64_t layer = 0; layer < info_of(set).layers; ++layer) {
        for (const std::uint32_t which :
             {HRBFNPR_MARK_ATTRIBUTE_POSITION, HRBFNPR_MARK_ATTRIBUTE_NORMAL, HRBFNPR_MARK_ATTRIBUTE_DIRECTION,
              HRBFNPR_MARK_ATTRIBUTE_CURVATURE, HRBFNPR_MARK_ATTRIBUTE_RANK, HRBFNPR_MARK_ATTRIBUTE_WIDTH})
            append(bytes, attribute<float>(set, layer, which));
        append(bytes, attribute<std::uint8_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_LEVEL));
        for (const std::uint32_t which :
             {HRBFNPR_MARK_ATTRIBUTE_STROKE, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST, HRBFNPR_MARK_ATTRIBUTE_STROKE_ORDER})
            append(bytes, attribute<std::uint32_t>(set, layer, which));
    }
}

// Computed once, before any test changes the floating-point state.
struct Inputs {
    scenes::Samples samples = scenes::torus(70);
    std::vector<double> point;
    Inputs() {
        for (int i = 0; i < 3 * 1000; ++i) point.push_back(0.0011 * ((i * 37) % 2500) - 1.3);
    }
};

const Inputs& inputs() {
    static const auto& made_once = *new Inputs;
    return made_once;
}

void append_queries(Bytes& bytes, const Model& model) {
    Error error;
    std::vector<double> point = inputs().point;
    std::vector<double> value(1000);
    std::vector<double> gradient(3000);
    std::vector<double> hessian(6000);
    std::vector<double> k1(1000);
    const hrbfnpr_array points = in(point);
    const hrbfnpr_array_out values = out(value, 1);
    const hrbfnpr_array_out gradients = out(gradient);
    const hrbfnpr_array_out hessians = out(hessian, 6);
    auto curvature = made(hrbfnpr_curvature_init);
    curvature.k1 = out(k1, 1);
    auto projection = made(hrbfnpr_projection_init);
    projection.position = out(point);
    EXPECT_OK(hrbfnpr_model_evaluate(model.get(), &points, &values, &gradients, &hessians, nullptr, error));
    EXPECT_OK(hrbfnpr_model_curvature(model.get(), &points, &curvature, nullptr, error));
    EXPECT_OK(hrbfnpr_model_project(model.get(), &points, nullptr, &projection, nullptr, error));
    std::vector<double> t(3 * 1000);
    std::vector<std::uint8_t> inside(1000);
    const std::vector<double> direction(3 * 1000, 0.7);
    auto desc = made(hrbfnpr_cast_desc_init);
    desc.maximum_hits = 3;
    desc.t_min = -5.0;
    const hrbfnpr_array directions = in(direction);
    auto hits = made(hrbfnpr_ray_hits_init);
    hits.t = out(t, 3);
    const hrbfnpr_array_out insides = out(inside, 1);
    const std::vector<double> origin = inputs().point;
    const hrbfnpr_array origins = in(origin);
    EXPECT_OK(hrbfnpr_model_cast_rays(model.get(), &origins, &directions, &desc, &hits, nullptr, error));
    EXPECT_OK(hrbfnpr_model_contains(model.get(), &origins, &insides, nullptr, nullptr, error));
    append(bytes, t);
    append(bytes, inside);
    append(bytes, value);
    append(bytes, gradient);
    append(bytes, hessian);
    append(bytes, k1);
    append(bytes, point);
}

// Strokes as an image and as triangles.
void append_strokes(Bytes& bytes, const Context& context, const PointSet& set, std::uint32_t shape) {
    Error error;
    auto layer = made(hrbfnpr_layer_style_init);
    layer.shape = shape;
    auto style = made(hrbfnpr_style_init);
    style.layers = &layer;
    style.layer_count = 1;
    const Drawing drawing = draw_item(make_renderer(context), item_of(set, &style), front_camera());
    append(bytes, rasterize(drawing, 64));
    for (const std::uint32_t primitive : {HRBFNPR_PRIMITIVE_POINTS, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS}) {
        Layout layout(primitive);
        layout.add(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, 0);
        std::int64_t vertices = 0;
        std::int64_t indices = 0;
        EXPECT_OK(hrbfnpr_drawing_vertex_bound(drawing.get(), primitive, &vertices, &indices, error));
        EXPECT_GT(vertices, 0);
        std::vector<float> vertex(static_cast<std::size_t>(3 * vertices));
        std::vector<std::uint32_t> index(static_cast<std::size_t>(indices));
        EXPECT_OK(hrbfnpr_drawing_write_vertices(drawing.get(), layout.get(), vertex.data(), vertices, nullptr,
                                                 index.data(), indices, nullptr, error));
        append(bytes, vertex);
        append(bytes, index);
    }
}

// Everything that the library computes, as bytes.
Bytes everything(const Context& context) {
    Error error;
    Bytes bytes;
    const Model model = fit(context, inputs().samples);
    append_queries(bytes, model);
    for (const std::uint32_t distribution : {HRBFNPR_DISTRIBUTION_BLUE_NOISE, HRBFNPR_DISTRIBUTION_PUBLISHED}) {
        const PointSet set = generate(context, model, small_desc(distribution));
        append(bytes, set);
        append(bytes, draw(make_renderer(context), set));
        append_strokes(bytes, context, set, HRBFNPR_SHAPE_STROKES);
        append_strokes(bytes, context, set, HRBFNPR_SHAPE_HATCH);
    }
    return bytes;
}

// A job runner that runs the tasks backwards, on two threads.
void run_backwards(void* user, hrbfnpr_task_fn task, void* task_context, std::int64_t count) {
    static_cast<std::atomic<int>*>(user)->fetch_add(1);
    std::thread odd([=] {
        for (std::int64_t i = count; i-- > 0;)
            if (i % 2 == 1) task(task_context, i);
    });
    for (std::int64_t i = count; i-- > 0;)
        if (i % 2 == 0) task(task_context, i);
    odd.join();
}

TEST(Determinism, TheSameBitsForAnyNumberOfThreads) {
    const Bytes serial = everything(make_context(1));
    ASSERT_GT(serial.size(), 100000U);
    for (const std::int32_t threads : {2, 3, 7}) EXPECT_TRUE(everything(make_context(threads)) == serial) << threads;
}

TEST(Determinism, TheSameBitsByOpenMp) {
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = 3;
    desc.thread_backend = HRBFNPR_THREAD_BACKEND_OPENMP;
    hrbfnpr_context* probe = nullptr;
    if (hrbfnpr_context_create(&desc, &probe, nullptr) != HRBFNPR_STATUS_OK) GTEST_SKIP() << "a build without OpenMP";
    hrbfnpr_context_release(probe);
    EXPECT_TRUE(everything(make_context(desc)) == everything(make_context(1)));
}

TEST(Determinism, TheSameBitsWithAHostsJobRunner) {
    std::atomic<int> runs{0};
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = 3;
    desc.run_tasks = run_backwards;
    desc.run_tasks_user = &runs;
    EXPECT_TRUE(everything(make_context(desc)) == everything(make_context(1)));
    EXPECT_GT(runs, 10);
}

// What the tasks would have made is missing, so the call fails, and says how much.
TEST(RunTasks, ThatLeaveTasksOutFailTheCall) {
    Error error;
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = 3;
    desc.run_tasks = [](void*, hrbfnpr_task_fn task, void* task_context, std::int64_t count) {
        for (std::int64_t i = 1; i < count; ++i) task(task_context, i);
    };
    const Context context = make_context(desc);
    const hrbfnpr_fit_desc fit = fit_desc(inputs().samples);
    hrbfnpr_model* model = nullptr;
    EXPECT_FAILS(hrbfnpr_model_fit(context.get(), &fit, nullptr, &model, error), HRBFNPR_STATUS_CALLBACK,
                 "run_tasks returned after ");
    EXPECT_EQ(model, nullptr);
}

TEST(Determinism, TheSameBitsTwiceInARow) {
    const Context context = make_context(2);
    EXPECT_TRUE(everything(context) == everything(context));
}

#if defined(__SSE2__)
TEST(FloatingPoint, TheCallersStateChangesNothingAndIsPreserved) {
    const Bytes normal = everything(make_context(2));
    const unsigned before = _mm_getcsr();
    // Round up, flush to zero, subnormals are zero.
    const unsigned strange = (before & ~0x6000U) | 0x4000U | 0x8040U;
    _mm_setcsr(strange);
    const Bytes result = everything(make_context(2));
    const unsigned after = _mm_getcsr();
    _mm_setcsr(before);
    // The sticky exception flags may be the test's own.
    EXPECT_EQ(after & ~0x3FU, strange & ~0x3FU);
    EXPECT_TRUE(result == normal);
}

TEST(FloatingPoint, TrapsOfTheCallerAreNotSprung) {
    const unsigned before = _mm_getcsr();
    _mm_setcsr(before & ~0x0E80U & ~0x3FU); // division by zero, overflow, underflow and invalid would trap
    const Context context = make_context(2);
    const Model model = fit(context, scenes::sphere_6());
    const PointSet set = generate(context, model, small_desc());
    const auto pixels = draw(make_renderer(context), set);
    _mm_setcsr(before);
    EXPECT_FALSE(pixels.empty());
}
#endif

} // namespace
} // namespace api_test::threads_test
