// SPDX-License-Identifier: MIT
#include "host/session.h"

namespace host_test {

Context make_context(const hrbfnpr_context_desc& desc) {
    scenes::Check check;
    hrbfnpr_context* context = nullptr;
    check(hrbfnpr_context_create(&desc, &context, check.error()));
    return Context(context);
}

Context make_context(std::int32_t threads) {
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = threads;
    desc.thread_backend = hrbfnpr::test::test_backend();
    return make_context(desc);
}

hrbfnpr_fit_desc fit_desc(const scenes::Samples& samples) {
    auto desc = made(hrbfnpr_fit_desc_init);
    desc.points = {samples.points.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
    desc.normals = {samples.normals.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
    return desc;
}

Model fit(const Context& context, const hrbfnpr_fit_desc& desc) {
    scenes::Check check;
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_fit(context.get(), &desc, nullptr, &model, check.error()));
    return Model(model);
}

Model fit(const Context& context, int samples) {
    const scenes::Samples torus = scenes::torus(samples);
    return fit(context, fit_desc(torus));
}

PointSet generate(const Context& context, const Model& model, Generation desc) {
    scenes::Check check;
    hrbfnpr_point_set* marks = nullptr;
    check(hrbfnpr_point_set_generate(context.get(), model.get(), desc.get(), nullptr, &marks, check.error()));
    return PointSet(marks);
}

PointSet generate(const Context& context, const Model& model) { return generate(context, model, three_layers(1000)); }

Bytes draw(const Context& context, const PointSet& marks, const hrbfnpr_model* rays) {
    constexpr std::int32_t side = 160;
    scenes::Check check;
    hrbfnpr_renderer* made_renderer = nullptr;
    check(hrbfnpr_renderer_create(context.get(), &made_renderer, check.error()));
    const Renderer renderer(made_renderer);
    auto item = made(hrbfnpr_item_init);
    item.point_set = marks.get();
    item.model = rays;
    auto camera = made(hrbfnpr_camera_init);
    const double low[3] = {-1.5, -1.5, -0.5}, high[3] = {1.5, 1.5, 0.5}, direction[3] = {0.0, 1.0, -1.0};
    const double up[3] = {0.0, 0.0, 1.0};
    check(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.5, side, side, 0.02, check.error()));
    hrbfnpr_drawing* made_drawing = nullptr;
    check(hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &camera, &made_drawing, check.error()));
    const Drawing drawing(made_drawing);
    Bytes pixels(std::size_t{4} * side * side);
    auto image = made(hrbfnpr_image_init);
    image.width = image.height = side;
    image.pixels = pixels.data();
    check(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, check.error()));
    return pixels;
}

} // namespace host_test
