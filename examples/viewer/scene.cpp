// SPDX-License-Identifier: MIT
#include "scene.h"

#include "files.h"

#include <algorithm>

namespace viewer {

namespace {

constexpr std::int64_t patch_count = 48;
constexpr char saved_magic[] = "\x89HRB\r\n\x1a\n";

void load_saved(Source& source, const std::string& path, const std::string& data, Work& work) {
    const auto size = static_cast<std::int64_t>(data.size());
    try {
        source.model = make<hrbfnpr_model>(hrbfnpr_model_release, [&](auto** out, auto* error) {
            return hrbfnpr_model_load_memory(work.context.get(), data.data(), size, out, error);
        });
    } catch (const Failure& failure) {
        hrbfnpr_point_set* marks = nullptr;
        Error error;
        if (hrbfnpr_point_set_load_memory(work.context.get(), data.data(), size, &marks, error) != HRBFNPR_STATUS_OK)
            throw Failure(path + ": " + failure.what());
        source.marks = PointSet(marks, hrbfnpr_point_set_release);
    }
}

hrbfnpr_picture_source described(const Source& source) {
    auto result = defaults<hrbfnpr_picture_source>(hrbfnpr_picture_source_init);
    result.name = source.name.c_str();
    result.model = source.model.get();
    result.point_set = source.marks.get();
    result.points = view_of(source.shape.points);
    if (!source.shape.normals.empty()) result.normals = view_of(source.shape.normals);
    if (!source.shape.triangles.empty())
        result.triangles = {source.shape.triangles.data(), static_cast<std::int64_t>(source.shape.triangles.size()), 0,
                            HRBFNPR_SCALAR_INT32, 3};
    if (source.shape.format == "STL") { // STL files of workshops have z up
        result.up[2] = 1;
        result.up_by = "STL files";
    }
    return result;
}

template <class Element>
std::vector<Element> elements(const Element* first, std::int64_t count, std::int64_t stride) {
    std::vector<Element> result;
    const std::int64_t step = stride == 0 ? static_cast<std::int64_t>(sizeof(Element)) : stride;
    for (std::int64_t i = 0; i < count; ++i)
        result.push_back(*reinterpret_cast<const Element*>(reinterpret_cast<const char*>(first) + i * step));
    return result;
}

Sheet sheet_of(const Picture& picture) {
    Sheet sheet;
    const hrbfnpr_style* style = nullptr;
    const hrbfnpr_generate_desc* marks = nullptr;
    checked([&](auto* error) { return hrbfnpr_picture_get_style(picture.get(), &style, error); });
    checked([&](auto* error) { return hrbfnpr_picture_get_marks(picture.get(), &marks, error); });
    sheet.style = *style;
    sheet.layers = elements(style->layers, style->layer_count, style->layer_stride);
    sheet.lines = elements(style->lines, style->line_count, style->line_stride);
    sheet.marks = defaults<hrbfnpr_generate_desc>(hrbfnpr_generate_desc_init);
    if (marks == nullptr) return sheet;
    sheet.marks = *marks;
    sheet.mark_layers = elements(marks->layers, marks->layer_count, marks->layer_stride);
    return sheet;
}

// Tells whether a note is about a picture and not about its surfaces.
bool is_of_picture(std::uint32_t code) { return code >= HRBFNPR_NOTE_MARKS_LIMITED && code <= HRBFNPR_NOTE_BLANK; }

// Copies into the scene what the library reports about the picture.
void look_at(Scene& scene) {
    hrbfnpr_picture* const picture = scene.picture.get();
    scene.info = defaults<hrbfnpr_picture_info>(hrbfnpr_picture_info_init);
    checked([&](auto* error) { return hrbfnpr_picture_get_info(picture, &scene.info, error); });
    scene.size = {scene.info.width, scene.info.height};
    scene.camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    checked([&](auto* error) { return hrbfnpr_picture_get_camera(picture, &scene.camera, error); });
    scene.sheet = sheet_of(scene.picture);
    for (std::int64_t i = 0; i < scene.info.parts; ++i) {
        scene.parts.push_back(defaults<hrbfnpr_picture_part>(hrbfnpr_picture_part_init));
        checked([&](auto* error) { return hrbfnpr_picture_get_part(picture, i, &scene.parts.back(), error); });
    }
    for (std::int64_t i = 0; i < scene.info.stages; ++i) {
        auto stage = defaults<hrbfnpr_picture_event>(hrbfnpr_picture_event_init);
        checked([&](auto* error) { return hrbfnpr_picture_get_stage(picture, i, &stage, error); });
        scene.timings.push_back({stage.name, 1e3 * stage.seconds});
    }
    for (std::int64_t i = 0; i < scene.info.notes; ++i) {
        auto note = defaults<hrbfnpr_note>(hrbfnpr_note_init);
        checked([&](auto* error) { return hrbfnpr_picture_get_note(picture, i, &note, error); });
        if (note.severity == HRBFNPR_SEVERITY_INFO) continue;
        (is_of_picture(note.code) ? scene.notes : scene.surface_notes).emplace_back(note.text);
    }
}

Patches patches_of(const Scene& scene, Work& work) {
    Patches patches;
    if (!scene.has_model() || scene.sheet.mark_layers.empty()) return patches;
    hrbfnpr_generate_desc desc = scene.sheet.marks;
    std::vector<std::array<Vec, 4>> corners(static_cast<std::size_t>(patch_count));
    const hrbfnpr_array_out room = {corners.data(), patch_count, 0, HRBFNPR_SCALAR_FLOAT64, 12};
    desc.initial_step = 0;
    checked([&](auto* error) {
        return hrbfnpr_point_set_step_patches(work.context.get(), scene.parts.front().model, &desc, &room,
                                              &patches.estimate, work.operation.get(), error);
    });
    patches.corners = std::move(corners);
    return patches;
}

Picture restyled_by(const Picture& picture, Descriptor& descriptor, Work& work) {
    work.listen(descriptor.desc);
    return make<hrbfnpr_picture>(hrbfnpr_picture_release, [&](auto** out, auto* error) {
        return hrbfnpr_picture_restyle(picture.get(), &descriptor.desc, work.operation.get(), out, error);
    });
}

Picture restyled_at_once(const Picture& picture, const Choices& choices, Size size, const View* view, Work& work) {
    hrbfnpr_camera camera;
    if (view != nullptr) camera = camera_of(*view, size);
    Descriptor descriptor(choices, size, view != nullptr ? &camera : nullptr);
    return restyled_by(picture, descriptor, work);
}

} // namespace

Source source_of_file(const std::string& path, Work& work) {
    Source source;
    source.name = path.substr(path.find_last_of('/') + 1);
    const std::string data = read_file(path);
    if (data.compare(0, sizeof saved_magic - 1, saved_magic) == 0)
        load_saved(source, path, data, work);
    else
        source.shape = read_shape(path, data);
    return source;
}

Scene scene_of(const Source& source, const Choices& choices, Size size, Work& work) {
    const hrbfnpr_picture_source described_source = described(source);
    Descriptor descriptor(choices, size, nullptr);
    descriptor.desc.sources = &described_source;
    descriptor.desc.source_count = 1;
    std::copy(source.up.begin(), source.up.end(), descriptor.desc.up);
    if (source.has_right_normals) descriptor.desc.normals = HRBFNPR_NORMALS_GIVEN;
    work.listen(descriptor.desc);
    Scene scene;
    scene.name = source.name;
    try {
        scene.picture = make<hrbfnpr_picture>(hrbfnpr_picture_release, [&](auto** out, auto* error) {
            return hrbfnpr_picture_create(work.context.get(), &descriptor.desc, work.operation.get(), out, error);
        });
    } catch (const Failure& failure) {
        if (failure.status == HRBFNPR_STATUS_CANCELLED) throw;
        throw Failure(source.name + ": " + failure.what(), failure.status);
    }
    look_at(scene);
    for (const hrbfnpr_picture_part& part : scene.parts) {
        scene.lipschitz.push_back(0);
        if (part.model == nullptr) continue;
        checked([&](auto* error) {
            return hrbfnpr_model_lipschitz(part.model, &scene.lipschitz.back(), work.operation.get(), error);
        });
    }
    return scene;
}

Picture restyled_picture(const Picture& picture, const Choices& choices, Size size, const View* view, Work& work) {
    const bool is_other_size = size.width != choices.drawn.width || size.height != choices.drawn.height;
    if (!choices.has_lengths() || !is_other_size) return restyled_at_once(picture, choices, size, view, work);
    // The lengths were chosen for a picture of another size. The settings of that picture look the same here if the pen
    // is scaled with the size.
    const Size drawn = choices.drawn;
    const Picture before = restyled_at_once(picture, choices, drawn, view, work);
    Choices scaled;
    scaled.settings = settings_of_text(work.context, settings_of(before));
    scaled.dabs = choices.dabs;
    scaled.pen = static_cast<double>(std::max(size.width, size.height)) / std::max(drawn.width, drawn.height);
    return restyled_at_once(picture, scaled, size, view, work);
}

Scene restyled(const Scene& scene, const Choices& choices, Size size, const View* view, bool wants_patches,
               Work& work) {
    Scene result;
    result.name = scene.name;
    result.picture = restyled_picture(scene.picture, choices, size, view, work);
    result.lipschitz = scene.lipschitz;
    result.surface_notes = scene.surface_notes;
    look_at(result);
    if (wants_patches) result.patches = patches_of(result, work);
    return result;
}

std::string settings_of(const Picture& picture) {
    std::string text;
    checked([&](auto* error) { return hrbfnpr_picture_write_settings(picture.get(), write_to_text, &text, error); });
    return text;
}

Vec Scene::centre() const {
    const double *low = info.bounds_min, *high = info.bounds_max;
    return {0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]), 0.5 * (low[2] + high[2])};
}

double Scene::diagonal() const {
    const double *low = info.bounds_min, *high = info.bounds_max;
    return length({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

bool Scene::has_edges() const {
    for (const hrbfnpr_picture_part& part : parts) {
        if (part.mesh != nullptr) return true;
        if (part.line_set == nullptr) continue;
        auto line_set = defaults<hrbfnpr_line_set_info>(hrbfnpr_line_set_info_init);
        checked([&](auto* error) { return hrbfnpr_line_set_get_info(part.line_set, &line_set, error); });
        if (line_set.creases > 0) return true;
    }
    return false;
}

std::vector<hrbfnpr_layer_info> Scene::layers() const {
    std::vector<hrbfnpr_layer_info> infos;
    for (const hrbfnpr_picture_part& part : parts) {
        auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
        checked([&](auto* error) { return hrbfnpr_point_set_get_info(part.point_set, &info, error); });
        for (std::int64_t layer = 0; layer < info.layers; ++layer) {
            infos.push_back(defaults<hrbfnpr_layer_info>(hrbfnpr_layer_info_init));
            checked([&](auto* error) {
                return hrbfnpr_point_set_get_layer_info(part.point_set, layer, &infos.back(), error);
            });
        }
    }
    return infos;
}

} // namespace viewer
