// SPDX-License-Identifier: MIT
// Makes one picture as the command line does, and measures its stages and marks.
#pragma once

#include "orbit.h"
#include "picture_inputs.h"
#include "timing.h"

#include <sys/resource.h>

namespace bench {

struct PictureSettings {
    std::string style;
    std::int32_t size = 1000;
    std::int32_t threads = 0;
    bool by_processor =
        false; // stages are measured in processor time of all threads, which other programs disturb less
};

// What one picture took and holds, as numbers that can be sent between processes.
struct PictureCost {
    enum Stage { begin, mesh, sample, orient, surface, end, marks, lines, frame, write, stages };
    std::array<double, stages> seconds; // `begin` is the context and a model that the caller makes
    double total;
    double placed;   // marks of all layers
    double shown;    // marks drawn as ink
    double possible; // marks that lie in the picture and face the camera
};

inline constexpr std::array<const char*, PictureCost::stages> stage_names = {
    "begin", "mesh", "sample", "orient", "fit", "end", "marks", "lines", "frame", "write"};

namespace detail {

[[nodiscard]] inline PictureCost::Stage stage_of(std::uint32_t stage) {
    switch (stage) {
    case HRBFNPR_STAGE_MESH: return PictureCost::mesh;
    case HRBFNPR_STAGE_SAMPLE: return PictureCost::sample;
    case HRBFNPR_STAGE_ORIENT:
    case HRBFNPR_STAGE_SMOOTH: return PictureCost::orient;
    case HRBFNPR_STAGE_FIT: return PictureCost::surface;
    case HRBFNPR_STAGE_COMPARE:
    case HRBFNPR_STAGE_END: return PictureCost::end;
    case HRBFNPR_STAGE_MARKS: return PictureCost::marks;
    case HRBFNPR_STAGE_LINES: return PictureCost::lines;
    default: return PictureCost::frame;
    }
}

// Returns the processor time of all threads until now.
[[nodiscard]] inline double processor_seconds() {
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    const auto seconds = [](const timeval& time) {
        return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
    };
    return seconds(use.ru_utime) + seconds(use.ru_stime);
}

// Adds up the time of the stages of a picture from its events.
struct StageClock {
    bool by_processor;
    std::uint32_t running = 0; // the stage that runs
    double begun = 0.0;        // processor time at which it began
    std::array<double, PictureCost::stages> seconds{};

    static void take(void* user, const hrbfnpr_picture_event* event) {
        StageClock& clock = *static_cast<StageClock*>(user);
        if (event->stage == 0 || event->note != nullptr) return;
        if (event->stage != clock.running) clock.begun = processor_seconds();
        clock.running = event->stage;
        if (event->says == nullptr) return; // the stage has not ended
        clock.seconds[static_cast<std::size_t>(stage_of(event->stage))] +=
            clock.by_processor ? processor_seconds() - clock.begun : event->seconds;
        clock.running = 0;
    }
};

// Counts the marks of one layer that the camera could show: they lie in the picture, and face the camera unless both
// sides are drawn. Other surface may still hide them.
[[nodiscard]] inline std::int64_t possible_marks(const hrbfnpr_picture_part& part, std::int64_t layer, const Lens& lens,
                                                 const glm::dvec3& origin) {
    std::int64_t count = 0;
    const auto* place = attribute<float>(part.point_set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
    const auto* normal = attribute<float>(part.point_set, layer, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count);
    std::int64_t possible = 0;
    for (std::int64_t i = 0; i < count; ++i) {
        const glm::dvec3 p = origin + glm::dvec3(place[3 * i], place[3 * i + 1], place[3 * i + 2]);
        const glm::dvec3 n(normal[3 * i], normal[3 * i + 1], normal[3 * i + 2]);
        const bool faces = part.sides == HRBFNPR_SIDES_BOTH || lens.facing(p, n) < 0.0;
        possible += faces && lens.holds(lens.image_of(p), 0.0) ? 1 : 0;
    }
    return possible;
}

[[nodiscard]] inline double possible_marks(const hrbfnpr_picture* picture, std::int64_t parts) {
    scenes::Check check;
    hrbfnpr_camera camera = scenes::made(hrbfnpr_camera_init);
    check(hrbfnpr_picture_get_camera(picture, &camera, check.error()));
    const Lens lens(camera);
    std::int64_t possible = 0;
    for (std::int64_t i = 0; i < parts; ++i) {
        hrbfnpr_picture_part part = scenes::made(hrbfnpr_picture_part_init);
        check(hrbfnpr_picture_get_part(picture, i, &part, check.error()));
        if (part.point_set == nullptr) continue;
        const hrbfnpr_point_set_info info = info_of(part.point_set);
        for (std::int64_t layer = 0; layer < info.layers; ++layer)
            possible += possible_marks(part, layer, lens, glm::make_vec3(info.origin));
    }
    return static_cast<double>(possible);
}

[[nodiscard]] inline hrbfnpr_picture_source source_of(const PictureMesh& mesh, const hrbfnpr_model* model) {
    hrbfnpr_picture_source source = scenes::made(hrbfnpr_picture_source_init);
    source.model = model;
    if (model != nullptr) return source;
    source.points = {mesh.points.data(), static_cast<std::int64_t>(mesh.points.size()), 0, HRBFNPR_SCALAR_FLOAT64, 3};
    if (!mesh.faces.empty())
        source.triangles = {mesh.faces.data(), static_cast<std::int64_t>(mesh.faces.size()), 0, HRBFNPR_SCALAR_INT32,
                            3};
    return source;
}

// Turns the drawing into pixels, as the command line does before it packs them into a PNG file.
inline void rasterize(const hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing) {
    scenes::Check check;
    hrbfnpr_image image = scenes::made(hrbfnpr_image_init);
    image.format = HRBFNPR_FORMAT_RGBA8;
    check(hrbfnpr_picture_plate_size(picture, nullptr, &image.width, &image.height, check.error()));
    std::vector<std::uint8_t> pixels(std::size_t{4} * static_cast<std::size_t>(image.width) *
                                     static_cast<std::size_t>(image.height));
    image.pixels = pixels.data();
    check(hrbfnpr_picture_rasterize(picture, drawing, nullptr, &image, check.error()));
}

} // namespace detail

// Makes, draws and paints a picture of an input with the defaults of the command line.
[[nodiscard]] inline PictureCost make_picture(const PictureInput& input, const PictureMesh& mesh,
                                              const PictureSettings& settings) {
    PictureCost cost{};
    scenes::Check check;
    scenes::Context context;
    scenes::Model model;
    hrbfnpr::test::Picture picture;
    scenes::Drawing drawing;
    detail::StageClock clock{settings.by_processor};
    cost.total = seconds([&] {
        cost.seconds[PictureCost::begin] = seconds([&] {
            context = make_context(settings.threads);
            if (input.model != nullptr) model = input.model(context.get());
        });
        hrbfnpr_picture_source source = detail::source_of(mesh, model.get());
        if (input.is_height_map) source.up[2] = 1.0;
        hrbfnpr_picture_desc desc = scenes::made(hrbfnpr_picture_desc_init);
        desc.sources = &source;
        desc.source_count = 1;
        desc.style_name = settings.style.c_str();
        desc.size = settings.size;
        desc.on_event = &detail::StageClock::take;
        desc.event_user = &clock;
        hrbfnpr_picture* made = nullptr;
        check(hrbfnpr_picture_create(context.get(), &desc, nullptr, &made, check.error()));
        picture.reset(made);
        hrbfnpr_drawing* drawn = nullptr;
        check(hrbfnpr_picture_draw(picture.get(), nullptr, nullptr, &drawn, check.error()));
        drawing.reset(drawn);
        cost.seconds[PictureCost::write] = seconds([&] { detail::rasterize(picture.get(), drawing.get()); });
    });
    hrbfnpr_picture_info info = scenes::made(hrbfnpr_picture_info_init);
    check(hrbfnpr_picture_get_info(picture.get(), &info, check.error()));
    for (std::size_t i = 0; i < PictureCost::stages; ++i) cost.seconds[i] += clock.seconds[i];
    hrbfnpr_drawing_info drawn = scenes::made(hrbfnpr_drawing_info_init);
    check(hrbfnpr_drawing_get_info(drawing.get(), &drawn, check.error()));
    cost.placed = static_cast<double>(info.marks);
    cost.shown = static_cast<double>(drawn.shown);
    cost.possible = detail::possible_marks(picture.get(), info.parts);
    return cost;
}

} // namespace bench
