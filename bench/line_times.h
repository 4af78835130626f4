// SPDX-License-Identifier: MIT
// Times of lines against those of marks, with more samples, and from frame to frame.
#pragma once

#include "line_views.h"
#include "line_visibility.h"
#include "painter.h"

#include <vector>

namespace bench {

// A camera path around a surface.
class LineOrbit {
public:
    explicit LineOrbit(const hrbfnpr_model* model) {
        const hrbfnpr_model_info info = info_of(model);
        const glm::dvec3 low = glm::make_vec3(info.bounds_min);
        const glm::dvec3 high = glm::make_vec3(info.bounds_max);
        middle_ = 0.5 * (low + high);
        // The box is grown so that the whole surface stays in the picture and between the planes at any angle.
        const glm::dvec3 half(0.5 * glm::length(high - low) / std::sqrt(3.0));
        const glm::dvec3 lower = middle_ - half;
        const glm::dvec3 upper = middle_ + half;
        start_ =
            camera_of(glm::value_ptr(lower), glm::value_ptr(upper), glm::normalize(glm::dvec3(-0.3, -0.2, -1.0)), 0.5);
    }
    [[nodiscard]] hrbfnpr_camera at(double degrees) const {
        const glm::dmat4 turn = glm::translate(glm::dmat4(1.0), middle_) *
                                glm::rotate(glm::dmat4(1.0), glm::radians(degrees), glm::dvec3(0.0, 1.0, 0.0)) *
                                glm::translate(glm::dmat4(1.0), -middle_);
        hrbfnpr_camera camera = start_;
        const glm::dmat4 view = glm::make_mat4(start_.view) * turn;
        for (std::size_t i = 0; i < 16; ++i) camera.view[i] = glm::value_ptr(view)[i];
        return camera;
    }

private:
    glm::dvec3 middle_{0.0};
    hrbfnpr_camera start_{};
};

// Returns the time of lines over that of 40 000 stipples, from the same directions.
[[nodiscard]] inline double lines_over_marks(hrbfnpr_context* context, const LineModel& model) {
    constexpr std::int64_t marks = 40'000;
    constexpr int runs = 15;
    const scenes::PointSet set = generate(context, model.model.get(), one_layer(HRBFNPR_LAYER_KIND_STIPPLES, marks));
    Painter dots(context, set.get(), Style(HRBFNPR_PRESET_STIPPLE));
    LinePainter lines(context, model.marks.get(), model.lines.get());
    const LineOrbit orbit(model.model.get());
    double first = 0.0;
    double second = 0.0;
    const Comparison times = compare(
        runs, [&] { lines.draw(orbit.at(7.0 * first++)); }, [&] { dots.make_drawing(orbit.at(7.0 * second++)); });
    std::printf("a drawing of 40 000 stipples: %.2f ms; of contours: %.2f times that\n", 1e3 * times.seconds,
                times.ratio);
    return times.ratio;
}

// Returns the time of a view by a new renderer over that of f, its gradient and its Hessian at as many places of the
// surface as its mesh has vertices.
[[nodiscard]] inline double lines_over_cells(hrbfnpr_context* context, const LineModel& model) {
    constexpr int runs = 9;
    const std::int64_t vertices = info_of(model.lines.get()).triangles / 2;
    const scenes::PointSet set = generate(context, model.model.get(), one_layer(HRBFNPR_LAYER_KIND_STIPPLES, vertices));
    std::int64_t count = 0;
    const float* position = attribute<float>(set.get(), 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
    std::vector<glm::dvec3> places;
    for (std::int64_t i = 0; i < count; ++i) places.emplace_back(glm::make_vec3(position + 3 * i));
    LinePainter lines(context, model.marks.get(), model.lines.get());
    const LineOrbit orbit(model.model.get());
    double view = 0.0;
    const auto draw = [&] {
        lines.begin_anew();
        lines.draw(orbit.at(7.0 * view++));
    };
    const Comparison times = compare(runs, draw, [&] { const Fields all(model.model.get(), places); });
    std::printf("f and its derivatives at %lld places: %.2f ms; contours of a view from nothing: %.3f times that\n",
                static_cast<long long>(count), 1e3 * times.seconds, times.ratio);
    return times.ratio;
}

// Returns the median time of some views.
[[nodiscard]] inline double median_ms(hrbfnpr_context* context, std::int64_t samples) {
    const LineModel model = line_model(context, "bumpy", fit_centres(context, bumpy(samples), samples));
    const Views views = draw_views(context, model, [](LinePainter&, const hrbfnpr_camera&) {});
    print(numbered("bumpy", samples), samples, info_of(model.lines.get()).triangles, views);
    return quantile(views.ms, 0.5);
}

} // namespace bench
