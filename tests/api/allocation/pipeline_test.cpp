// SPDX-License-Identifier: MIT
// The k-th allocation fails, for every k: each time a clean OUT_OF_MEMORY and no leak.
#include "fixture.h"

namespace api_test::pipeline_test {
namespace {

// From samples to pictures in steps, each of which may fail; whatever was made is released.
class Pipeline {
public:
    explicit Pipeline(const hrbfnpr_context_desc& desc) : desc_(desc) {}
    Pipeline(const Pipeline&) = delete;
    Pipeline& operator=(const Pipeline&) = delete;
    ~Pipeline() {
        hrbfnpr_drawing_release(drawing_);
        hrbfnpr_renderer_release(renderer_);
        hrbfnpr_point_set_release(own_);
        hrbfnpr_point_set_release(set_);
        hrbfnpr_model_release(loaded_);
        hrbfnpr_model_release(model_);
        hrbfnpr_operation_release(operation_);
        hrbfnpr_context_release(context_);
    }

    // The first failure, or OK.
    hrbfnpr_status run(hrbfnpr_error* error) {
        using Step = hrbfnpr_status (Pipeline::*)(hrbfnpr_error*);
        for (const Step step :
             {&Pipeline::create, &Pipeline::fit, &Pipeline::query, &Pipeline::reload, &Pipeline::published,
              &Pipeline::own, &Pipeline::patches, &Pipeline::attenuated, &Pipeline::hidden, &Pipeline::hatched})
            if (const hrbfnpr_status status = (this->*step)(error); status != HRBFNPR_STATUS_OK) return status;
        return HRBFNPR_STATUS_OK;
    }

private:
    hrbfnpr_status create(hrbfnpr_error* error) {
        const hrbfnpr_status status = hrbfnpr_context_create(&desc_, &context_, error);
        return status != HRBFNPR_STATUS_OK ? status : hrbfnpr_operation_create(context_, &operation_, error);
    }
    hrbfnpr_status fit(hrbfnpr_error* error) {
        const hrbfnpr_fit_desc desc = fit_desc(samples_);
        return hrbfnpr_model_fit(context_, &desc, operation_, &model_, error);
    }
    hrbfnpr_status query(hrbfnpr_error* error) {
        const hrbfnpr_array points = in(samples_.points);
        const hrbfnpr_array_out numbers = out(number_, 1);
        const hrbfnpr_array_out vectors = out(vector_);
        hrbfnpr_status status = hrbfnpr_model_evaluate(model_, &points, &numbers, &vectors, nullptr, operation_, error);
        auto projection = made(hrbfnpr_projection_init);
        projection.position = vectors;
        auto curvature = made(hrbfnpr_curvature_init);
        curvature.k1 = numbers;
        if (status == HRBFNPR_STATUS_OK)
            status = hrbfnpr_model_project(model_, &points, nullptr, &projection, nullptr, error);
        if (status == HRBFNPR_STATUS_OK) status = hrbfnpr_model_curvature(model_, &points, &curvature, nullptr, error);
        return status;
    }
    hrbfnpr_status reload(hrbfnpr_error* error) {
        std::vector<std::uint8_t> bytes(65536);
        std::int64_t size = 0;
        const hrbfnpr_status status = hrbfnpr_model_save_memory(model_, bytes.data(), 65536, &size, error);
        return status != HRBFNPR_STATUS_OK ? status
                                           : hrbfnpr_model_load_memory(context_, bytes.data(), size, &loaded_, error);
    }
    hrbfnpr_status published(hrbfnpr_error* error) {
        Generation desc = small_desc(HRBFNPR_DISTRIBUTION_PUBLISHED);
        for (hrbfnpr_layer_desc& layer : desc.layer) {
            layer.levels = 1;
            layer.budget = 12;
        }
        return hrbfnpr_point_set_generate(context_, loaded_, desc.get(), nullptr, &set_, error);
    }
    // The layers of the set, and one of own strokes.
    hrbfnpr_status own(hrbfnpr_error* error) {
        const std::vector<std::uint32_t> first{0, 3, 6};
        auto arrays = made(hrbfnpr_layer_arrays_init);
        arrays.position = arrays.normal = in(samples_.points);
        arrays.stroke_first = in(first, 1);
        auto desc = made(hrbfnpr_point_set_desc_init);
        desc.base = set_;
        desc.layers = &arrays;
        desc.layer_count = 1;
        return hrbfnpr_point_set_create(context_, &desc, &own_, error);
    }
    hrbfnpr_status patches(hrbfnpr_error* error) {
        std::vector<double> corner(24);
        const hrbfnpr_array_out corners = out(corner, 12);
        return hrbfnpr_point_set_step_patches(context_, loaded_, nullptr, &corners, nullptr, nullptr, error);
    }
    hrbfnpr_status frame(std::uint32_t hidden_lines, std::uint32_t shape, hrbfnpr_error* error) {
        if (renderer_ == nullptr) {
            const hrbfnpr_status status = hrbfnpr_renderer_create(context_, &renderer_, error);
            if (status != HRBFNPR_STATUS_OK) return status;
        }
        auto style = made(hrbfnpr_style_init);
        style.hidden_lines = hidden_lines;
        auto layer = made(hrbfnpr_layer_style_init);
        layer.shape = shape;
        style.layers = &layer;
        style.layer_count = 1;
        auto item = made(hrbfnpr_item_init);
        item.point_set = own_;
        item.style = &style;
        const hrbfnpr_camera camera = front_camera(16);
        hrbfnpr_drawing_release(drawing_);
        hrbfnpr_status status = hrbfnpr_renderer_draw(renderer_, &item, 1, 0, &camera, &drawing_, error);
        return status != HRBFNPR_STATUS_OK ? status : read(error);
    }
    // All that a drawing gives.
    hrbfnpr_status read(hrbfnpr_error* error) {
        std::vector<std::uint8_t> pixels;
        const hrbfnpr_image image = image_of(pixels, 16);
        if (const auto status = hrbfnpr_drawing_rasterize(drawing_, &image, nullptr, error);
            status != HRBFNPR_STATUS_OK)
            return status;
        Layout layout;
        layout.add(HRBFNPR_VERTEX_ATTRIBUTE_WINDOW, HRBFNPR_SCALAR_FLOAT32, 0);
        std::vector<float> vertices(30000);
        std::vector<std::uint32_t> indices(10000);
        for (const std::uint32_t primitive : {HRBFNPR_PRIMITIVE_POINTS, HRBFNPR_PRIMITIVE_TRIANGLE_STRIPS}) {
            layout.primitive = primitive;
            hrbfnpr_status status = hrbfnpr_drawing_write_vertices(drawing_, layout.get(), vertices.data(), 10000,
                                                                   nullptr, nullptr, 0, nullptr, error);
            std::int64_t count = 0;
            if (status == HRBFNPR_STATUS_OK)
                status = hrbfnpr_drawing_write_mark_indices(drawing_, 0, 1, HRBFNPR_CLASS_FRONT, primitive,
                                                            indices.data(), 10000, &count, error);
            if (status != HRBFNPR_STATUS_OK) return status;
        }
        return HRBFNPR_STATUS_OK;
    }
    hrbfnpr_status attenuated(hrbfnpr_error* error) {
        return frame(HRBFNPR_HIDDEN_LINES_ATTENUATE, HRBFNPR_SHAPE_STROKES, error);
    }
    hrbfnpr_status hidden(hrbfnpr_error* error) {
        return frame(HRBFNPR_HIDDEN_LINES_HIDE, HRBFNPR_SHAPE_STROKES, error);
    }
    hrbfnpr_status hatched(hrbfnpr_error* error) {
        return frame(HRBFNPR_HIDDEN_LINES_HIDE, HRBFNPR_SHAPE_HATCH, error);
    }

    hrbfnpr_context_desc desc_;
    scenes::Samples samples_ = scenes::sphere_6();
    std::vector<double> number_ = std::vector<double>(6);
    std::vector<double> vector_ = std::vector<double>(18);
    hrbfnpr_context* context_ = nullptr;
    hrbfnpr_operation* operation_ = nullptr;
    hrbfnpr_model* model_ = nullptr;
    hrbfnpr_model* loaded_ = nullptr;
    hrbfnpr_point_set* set_ = nullptr;
    hrbfnpr_point_set* own_ = nullptr;
    hrbfnpr_renderer* renderer_ = nullptr;
    hrbfnpr_drawing* drawing_ = nullptr;
};

std::int64_t allocations_of_a_whole_run() {
    Error error;
    Allocator allocator;
    EXPECT_OK(Pipeline(allocator_desc(allocator)).run(error));
    EXPECT_EQ(allocator.bytes, 0);
    return allocator.calls;
}

TEST(Allocation, EveryFailureIsCleanAndLeaksNothing) {
    const std::int64_t all = allocations_of_a_whole_run();
    ASSERT_GT(all, 50);
    for (std::int64_t k = 1; k <= all; ++k) {
        Error error;
        Allocator allocator;
        allocator.refuse_at = k;
        ASSERT_EQ(Pipeline(allocator_desc(allocator)).run(error), HRBFNPR_STATUS_OUT_OF_MEMORY)
            << k << " of " << all << ": " << error.record.message;
        ASSERT_NE(std::string(error.record.message).find("bytes"), std::string::npos) << error.record.message;
        ASSERT_EQ(allocator.bytes, 0) << k << " of " << all;
    }
    RecordProperty("allocations", static_cast<int>(all));
}

// Blue noise repeats the same few allocations hundreds of times, and a run of it is long: the first
// ones and a sample of the others are refused.
TEST(Allocation, EveryFailureOfBlueNoiseIsCleanToo) {
    Allocator allocator;
    const Context context = make_context(allocator_desc(allocator));
    Sphere sphere;
    const Model model = custom_sphere(context, sphere);
    Generation desc = small_desc();
    desc.layer.pop_back();
    const std::int64_t before = allocator.calls;
    generate(context, model, desc);
    const std::int64_t all = allocator.calls - before;
    const std::int64_t bytes = allocator.bytes;
    for (std::int64_t k = 1; k <= all; k += k < 30 || k > all - 20 ? 1 : 29) {
        Error error;
        hrbfnpr_point_set* set = nullptr;
        allocator.refuse_at = allocator.calls + k;
        ASSERT_EQ(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &set, error),
                  HRBFNPR_STATUS_OUT_OF_MEMORY)
            << k << " of " << all << ": " << error.record.message;
        ASSERT_EQ(set, nullptr);
        ASSERT_EQ(allocator.bytes, bytes) << k << " of " << all;
    }
}

TEST(Allocation, ARendererGoesOnAfterAFailure) {
    Error error;
    Allocator allocator;
    const Context context = make_context(allocator_desc(allocator));
    Sphere sphere;
    const PointSet set = generate(context, custom_sphere(context, sphere), small_desc());
    const auto wanted = draw(make_renderer(context), set);
    const hrbfnpr_item item = item_of(set);
    const hrbfnpr_camera camera = front_camera();
    const Renderer renderer = make_renderer(context);
    for (int after = 1; after < 40; ++after) {
        allocator.refuse_at = allocator.calls + after;
        hrbfnpr_drawing* drawing = nullptr;
        const hrbfnpr_status status = hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &camera, &drawing, error);
        hrbfnpr_drawing_release(drawing);
        allocator.refuse_at = 0;
        if (status == HRBFNPR_STATUS_OK) break;
        EXPECT_EQ(status, HRBFNPR_STATUS_OUT_OF_MEMORY);
    }
    EXPECT_EQ(draw(renderer, set), wanted);
}

} // namespace
} // namespace api_test::pipeline_test
