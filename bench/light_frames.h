// SPDX-License-Identifier: MIT
// Shadings by the C interface: borders of shadows, leaks through thin walls, times, frames and changes in an orbit.
#pragma once

#include "analytic.h"
#include "changes.h"
#include "rays.h"
#include "samples.h"
#include "timing.h"

#include <cmath>
#include <cstdint>
#include <ctime>
#include <random>
#include <string>
#include <vector>

namespace bench {

using hrbfnpr::test::LineSet;
using hrbfnpr::test::made;
using hrbfnpr::test::Occluders;
using hrbfnpr::test::Shading;

[[nodiscard]] inline LineSet lined(hrbfnpr_context* context, const hrbfnpr_model* model, double cell = 0.0) {
    scenes::Check check;
    hrbfnpr_line_set_desc desc = made(hrbfnpr_line_set_desc_init);
    desc.cell_size = cell;
    hrbfnpr_line_set* lines = nullptr;
    check(hrbfnpr_line_set_create(context, model, &desc, nullptr, &lines, check.error()));
    return LineSet(lines);
}

[[nodiscard]] inline Occluders occluders_of(hrbfnpr_context* context, const LineSet& lines) {
    scenes::Check check;
    hrbfnpr_item item = made(hrbfnpr_item_init);
    item.line_set = lines.get();
    hrbfnpr_occluders* occluders = nullptr;
    check(hrbfnpr_occluders_create(context, &item, 1, 0, nullptr, &occluders, check.error()));
    return Occluders(occluders);
}

[[nodiscard]] inline Shading shaded(hrbfnpr_context* context, const Occluders& occluders, const hrbfnpr_item& item,
                                    const hrbfnpr_shading* previous = nullptr, double reach = 0.35) {
    scenes::Check check;
    hrbfnpr_shading_desc desc = made(hrbfnpr_shading_desc_init);
    desc.previous = previous;
    desc.occlusion_reach = reach;
    hrbfnpr_shading* shading = nullptr;
    check(hrbfnpr_shading_create(context, occluders.get(), &item, nullptr, &desc, nullptr, &shading, check.error()));
    return Shading(shading);
}

[[nodiscard]] inline hrbfnpr_light light_from(const glm::dvec3& towards, float shadow, float softness,
                                              float intensity = 1.0F) {
    hrbfnpr_light light = made(hrbfnpr_light_init);
    light.intensity = intensity;
    light.space = HRBFNPR_LIGHT_WORLD;
    for (glm::length_t c = 0; c < 3; ++c) light.place[c] = towards[c];
    light.shadow = shadow;
    light.softness = softness;
    return light;
}

// ---- Borders and leaks -----------------------------------------------------------------------------------------

// Returns for each mark whether it is in the shadow of a line set's mesh. Marks must face the light.
[[nodiscard]] inline std::vector<bool> shadowed(hrbfnpr_context* context, const std::vector<double>& place,
                                                const std::vector<double>& normal, const LineSet& lines,
                                                const glm::dvec3& towards) {
    scenes::Check check;
    const std::vector<float> rank(place.size() / 3, 0.05F);
    hrbfnpr_layer_arrays layer = made(hrbfnpr_layer_arrays_init);
    layer.kind = HRBFNPR_LAYER_KIND_STIPPLES;
    layer.position = view(place);
    layer.normal = view(normal);
    layer.rank = {rank.data(), static_cast<std::int64_t>(rank.size()), 0, HRBFNPR_SCALAR_FLOAT32, 1};
    hrbfnpr_point_set_desc desc = made(hrbfnpr_point_set_desc_init);
    desc.layers = &layer;
    desc.layer_count = 1;
    hrbfnpr_point_set* raw = nullptr;
    check(hrbfnpr_point_set_create(context, &desc, &raw, check.error()));
    const scenes::PointSet set(raw);
    // A mark with the rank 0.05 is shown if its tone is 0, that is, in the shadow.
    hrbfnpr_style style = made(hrbfnpr_style_init);
    const hrbfnpr_light light = light_from(towards, 1.0F, 0.0F);
    style.lights = &light;
    style.light_count = 1;
    style.fill_light = 0.0F;
    style.tone_curve = HRBFNPR_TONE_CURVE_LINEAR;
    style.tone_fade = 0.0F;
    style.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
    hrbfnpr_item item = made(hrbfnpr_item_init);
    item.point_set = set.get();
    item.style = &style;
    const Shading shading = shaded(context, occluders_of(context, lines), item, nullptr, 0.0);
    item.shading = shading.get();
    hrbfnpr_camera camera = made(hrbfnpr_camera_init);
    const hrbfnpr_array points = view(place);
    const glm::dvec3 ahead = -towards;
    const double up[3] = {0.1, 1.0, 0.2};
    check(hrbfnpr_camera_fit_points(&camera, &points, nullptr, &ahead.x, up, 0.5, 1000, 1000, 0.02, check.error()));
    hrbfnpr_renderer* renderer = nullptr;
    check(hrbfnpr_renderer_create(context, &renderer, check.error()));
    const scenes::Renderer own(renderer);
    hrbfnpr_drawing* drawing = nullptr;
    check(hrbfnpr_renderer_draw(renderer, &item, 1, 0, &camera, &drawing, check.error()));
    const scenes::Drawing own_drawing(drawing);
    std::vector<std::uint8_t> shown(rank.size());
    hrbfnpr_mark_results results = made(hrbfnpr_mark_results_init);
    results.shown = {shown.data(), static_cast<std::int64_t>(shown.size()), 0, HRBFNPR_SCALAR_UINT8, 1};
    check(hrbfnpr_drawing_mark_results(drawing, 0, 0, &results, check.error()));
    std::vector<bool> dark;
    for (const std::uint8_t one : shown) dark.push_back(one != HRBFNPR_CLASS_NONE);
    return dark;
}

// The shadow of a unit ball on a floor below it. A picture of 1000 pixels shows 5 units.
inline void report_border(hrbfnpr_context* context) {
    const scenes::Model ball = custom(context, sphere, {1.1, 1.1, 1.1});
    const LineSet lines = lined(context, ball.get());
    const glm::dvec3 towards = glm::normalize(glm::dvec3(0.6, 0.2, 1.0));
    constexpr double pixel = 5.0 / 1000.0;
    RandomNumbers random;
    std::vector<double> place, normal;
    std::vector<double> beyond; // the distance of each place from the border, in pixels
    while (beyond.size() < 100000) {
        const glm::dvec3 p(6.0 * random() - 3.0, 6.0 * random() - 3.0, -1.5);
        const double off = glm::length(glm::cross(p, towards)) - 1.0;
        if (std::abs(off) > 0.05) continue;
        for (const double c : {p.x, p.y, p.z}) place.push_back(c);
        for (const double c : {0.0, 0.0, 1.0}) normal.push_back(c);
        beyond.push_back(off / pixel);
    }
    const std::vector<bool> dark = shadowed(context, place, normal, lines, towards);
    double most = 0.0;
    for (std::size_t i = 0; i < beyond.size(); ++i)
        if (dark[i] != (beyond[i] < 0.0)) most = std::max(most, std::abs(beyond[i]));
    report("light.border.pixels", most);
}

constexpr double wall = 0.06;

// A hollow box from -1 to 1, whose walls are `wall` thick.
inline std::int32_t hollow_box(void*, std::int64_t count, const double* points, double* value, double* gradient,
                               double*) {
    for (std::int64_t i = 0; i < count; ++i) {
        const glm::dvec3 p = glm::make_vec3(points + 3 * i);
        const glm::dvec3 size = glm::abs(p);
        const glm::length_t axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        const double outside = size[axis] - 1.0, inside = 1.0 - wall - size[axis];
        value[i] = std::max(outside, inside);
        if (gradient == nullptr) continue;
        for (glm::length_t c = 0; c < 3; ++c) gradient[3 * i + c] = 0.0;
        gradient[3 * i + axis] = (p[axis] < 0.0 ? -1.0 : 1.0) * (outside > inside ? 1.0 : -1.0);
    }
    return 0;
}

// Marks on the inner sides of a box are in the shadow of its walls, for lights outside.
inline void report_leaks(hrbfnpr_context* context) {
    const scenes::Model box = custom(context, hollow_box, {1.1, 1.1, 1.1});
    const LineSet lines = lined(context, box.get(), wall / 1.5);
    RandomNumbers random;
    std::int64_t leaks = 0, marks = 0;
    for (int k = 0; k < 6; ++k) {
        const auto u = random.unit_vector();
        const glm::dvec3 towards(u[0], u[1], u[2]);
        std::vector<double> place, normal;
        for (int i = 0; i < 20000; ++i) {
            const int axis = i % 3;
            glm::dvec3 p, n(0.0);
            for (int c = 0; c < 3; ++c) p[c] = (1.0 - wall) * (2.0 * random() - 1.0);
            n[axis] = towards[axis] < 0.0 ? -1.0 : 1.0;
            p[axis] = -(1.0 - wall) * n[axis];
            if (std::abs(towards[axis]) < 0.1) continue; // too dark to tell
            for (const double c : {p.x, p.y, p.z}) place.push_back(c);
            for (const double c : {n.x, n.y, n.z}) normal.push_back(c);
        }
        for (const bool dark : shadowed(context, place, normal, lines, towards)) leaks += dark ? 0 : 1;
        marks += static_cast<std::int64_t>(place.size() / 3);
    }
    report("light.leaks.marks", static_cast<double>(marks));
    report("light.leaks.lit", static_cast<double>(leaks));
}

// ---- Times -----------------------------------------------------------------------------------------------------

[[nodiscard]] inline double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

// Reports the seconds of work(), and those of the processor divided by the number of threads, which other work on the
// machine changes less. `work` returns a shading.
template <class Work>
Shading report_time(const std::string& name, int threads, Work&& work) {
    std::vector<double> wall_times, times;
    Shading last;
    for (int run = 0; run < 3; ++run) {
        const double from = processor_seconds();
        wall_times.push_back(seconds([&] { last = work(); }));
        times.push_back((processor_seconds() - from) / threads);
    }
    report((name + ".seconds").c_str(), median(wall_times));
    report((name + ".processor").c_str(), median(times));
    std::fflush(stdout);
    return last;
}

// A fitted surface with stipples, its line set, and a style with a sky and lights with soft shadows.
class LitSurface {
public:
    LitSurface(hrbfnpr_context* context, std::int64_t marks, int threads)
        : context_(context), threads_(threads), marks_(marks) {
        const Samples samples = bumpy(5000, 0.15);
        model_ = fit(context, samples.points, samples.normals);
        lines_ = lined(context, model_.get());
        occluders_ = occluders_of(context, lines_);
        set_ = generate(context, model_.get(), one_layer(HRBFNPR_LAYER_KIND_STIPPLES, marks));
        style_.ambient_sky = 0.3F;
        style_.lights = lights_;
        style_.light_count = 1;
        style_.hidden_lines = HRBFNPR_HIDDEN_LINES_SHOW;
        for (hrbfnpr_layer_style& layer : style_.layer) layer.radius_zoom = 0.0F;
        item_.point_set = set_.get();
        item_.line_set = lines_.get();
        item_.style = style_.get();
    }
    LitSurface(const LitSurface&) = delete;
    LitSurface& operator=(const LitSurface&) = delete;

    void report_times() {
        const std::string name = "light.marks_" + std::to_string(marks_ / 1000) + "k";
        const Shading first =
            report_time(name + ".all", threads_, [&] { return shaded(context_, occluders_, item_, nullptr); });
        lights_[0] = light_from({0.5, 0.9, 0.6}, 1.0F, 0.0F);
        static_cast<void>(report_time(name + ".moved_hard", threads_,
                                      [&] { return shaded(context_, occluders_, item_, first.get()); }));
        lights_[0] = light_from({0.5, 0.9, 0.6}, 1.0F, 0.05F);
        static_cast<void>(report_time(name + ".moved_soft", threads_,
                                      [&] { return shaded(context_, occluders_, item_, first.get()); }));
        style_.curvature_contrast = 0.5F;
        static_cast<void>(report_time(name + ".moved_and_curvature", threads_,
                                      [&] { return shaded(context_, occluders_, item_, first.get()); }));
        style_.curvature_contrast = 0.0F;
    }

    // Reports the time of frames, as ratios to frames with one light and no shading.
    void report_frames() {
        const Orbit orbit(set_.get(), 1280, 720);
        Painter plain(context_, set_.get(), plain_style(), 1280, 720);
        const auto ratio = [&](const char* name, const hrbfnpr_shading* shading) {
            Painter lit(context_, set_.get(), style_, 1280, 720);
            lit.use(shading);
            // The same frames are drawn in turn. Ratios of the processor's time do not depend on other work.
            std::vector<double> ratios;
            for (int frame = 0; frame < 40; ++frame) {
                const double begin = processor_seconds();
                lit.make_drawing(orbit.at(0.7 * frame));
                const double middle = processor_seconds();
                plain.make_drawing(orbit.at(0.7 * frame));
                const double end = processor_seconds();
                ratios.push_back((middle - begin) / (end - middle));
            }
            report(name, median(ratios));
            std::fflush(stdout);
        };
        // All terms are weak, so that the tones and the marks are those of the plain frames.
        lights_[0] = light_from({-0.4, 0.6, 0.7}, 0.001F, 0.05F);
        style_.curvature_contrast = style_.ambient_sky = 0.001F;
        const Shading baked = shaded(context_, occluders_, item_);
        ratio("light.frame.baked.ratio", baked.get());
        style_.curvature_contrast = style_.ambient_sky = 0.0F;
        lights_[0] = light_from({-0.4, 0.6, 0.7}, 0.0F, 0.0F, 0.8F);
        lights_[1] = light_from({0.8, 0.2, 0.3}, 0.0F, 0.0F, 0.1F);
        lights_[2] = light_from({0.1, -0.8, 0.5}, 0.0F, 0.0F, 0.1F);
        style_.light_count = 3;
        ratio("light.frame.three.ratio", nullptr);
        style_.light_count = 1;
        style_.ambient_sky = 0.3F;
    }

    // Reports the marks that pop in an orbit, with and without a shading.
    void report_pops() {
        constexpr Way around{90, 0.5, 1.0};
        const Orbit orbit(set_.get(), 1280, 720);
        lights_[0] = light_from({-0.4, 0.6, 0.7}, 1.0F, 0.05F);
        style_.curvature_contrast = 0.5F;
        const Shading baked = shaded(context_, occluders_, item_);
        report("light.pop_rate.baked",
               follow(context_, set_.get(), style_, orbit, around, false, baked.get()).pop_rate());
        report("light.pop_rate.unshaded", follow(context_, set_.get(), style_, orbit, around, false).pop_rate());
        style_.curvature_contrast = 0.0F;
    }

private:
    [[nodiscard]] Style plain_style() const {
        Style style = style_;
        style.ambient_sky = style.curvature_contrast = 0.0F;
        style.lights = nullptr;
        style.light_count = 0;
        style.light_space = HRBFNPR_LIGHT_WORLD;
        return style;
    }

    hrbfnpr_context* context_;
    int threads_;
    std::int64_t marks_;
    scenes::Model model_;
    LineSet lines_;
    Occluders occluders_;
    scenes::PointSet set_;
    hrbfnpr_light lights_[3] = {light_from({-0.4, 0.6, 0.7}, 1.0F, 0.05F), made(hrbfnpr_light_init),
                                made(hrbfnpr_light_init)};
    Style style_{HRBFNPR_PRESET_STIPPLE};
    hrbfnpr_item item_ = made(hrbfnpr_item_init);
};

} // namespace bench
