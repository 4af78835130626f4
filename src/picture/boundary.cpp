// SPDX-License-Identifier: MIT
// The C interface of pictures. It checks and converts arguments, and calls the other files of this folder.
#include "api/barrier.h"
#include "api/camera.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/streams.h"
#include "picture/make.h"
#include "picture/page.h"
#include "picture/picture.h"
#include "picture/settings.h"

using namespace hrbfnpr;

namespace hrbfnpr::api {

template <>
hrbfnpr_note defaults() noexcept {
    return {};
}

template <>
hrbfnpr_picture_info defaults() noexcept {
    return {};
}

template <>
hrbfnpr_picture_part defaults() noexcept {
    return {};
}

template <>
hrbfnpr_picture_event defaults() noexcept {
    return {};
}

namespace {

// Returns the element with a given index from a list of the picture. Fails if the index is out of range.
template <class List>
const auto& element(const List& list, std::int64_t number, const char* what) {
    if (number < 0 || number >= static_cast<std::int64_t>(list.size()))
        fail(Status::invalid_argument, "number is %lld; the picture has %zu %s", static_cast<long long>(number),
             list.size(), what);
    return list[static_cast<std::size_t>(number)];
}

void copy(const glm::dvec3& from, double (&to)[3]) noexcept {
    for (int axis = 0; axis < 3; ++axis) to[axis] = from[axis];
}

hrbfnpr_picture_info described(const hrbfnpr_picture& picture) {
    hrbfnpr_picture_info info{};
    info.preset = picture.options.desc.preset;
    info.parts = static_cast<std::int64_t>(std::max(picture.surfaces().list.size(), picture.parts.size())) +
                 (picture.ground ? 1 : 0);
    info.marks = picture.mark_count();
    info.notes = static_cast<std::int64_t>(picture.report.notes.size());
    info.stages = static_cast<std::int64_t>(picture.report.stages.size());
    if (picture.style) {
        const glm::ivec2 size = picture::size_of_image(picture.camera);
        info.width = size.x;
        info.height = size.y;
    }
    const geometry::Bounds bounds = picture.bounds();
    copy(bounds.min, info.bounds_min);
    copy(bounds.max, info.bounds_max);
    copy(picture.surfaces().up, info.up);
    info.pen = picture.pen;
    info.seconds = picture.seconds;
    return info;
}

hrbfnpr_picture_part part_of(const hrbfnpr_picture& picture, std::int64_t number) {
    hrbfnpr_picture_part to{};
    const picture::Surfaces& surfaces = picture.surfaces();
    if (picture.ground && number == static_cast<std::int64_t>(picture.parts.size())) {
        to.model = picture.ground->model.get();
        to.point_set = picture.ground->marks.get();
        return to;
    }
    if (!surfaces.list.empty()) {
        const picture::Surface& surface = element(surfaces.list, number, "parts");
        to.model = surface.model.get();
        to.mesh = surface.mesh.get();
    }
    if (picture.parts.empty() && !surfaces.list.empty()) return to;
    const picture::Part& part = element(picture.parts, number, "parts");
    to.sides = part.sides;
    to.point_set = part.marks.get();
    to.line_set = part.lines.get();
    return to;
}

hrbfnpr_camera look(const hrbfnpr_picture& picture, const double* direction, double azimuth, double elevation) {
    picture::require_planned(picture);
    picture::View view = picture.view;
    if (direction != nullptr || !std::isnan(azimuth) || !std::isnan(elevation)) {
        view.camera.reset();
        view.eye.reset();
        view.direction.reset();
        if (direction != nullptr) {
            const Checks checks("direction");
            for (int axis = 0; axis < 3; ++axis) checks.finite("component", direction[axis]);
            view.direction = glm::dvec3(direction[0], direction[1], direction[2]);
        }
        if (!std::isnan(azimuth)) view.azimuth = azimuth;
        if (!std::isnan(elevation)) view.elevation = elevation;
    }
    return picture::camera_of_view(picture, view, false);
}

hrbfnpr_camera orbit(const hrbfnpr_picture& picture, double degrees) {
    picture::require_planned(picture);
    Checks("orbit").finite("degrees", degrees);
    return picture::turned(picture.camera, picture.surfaces().up, picture::orbit_centre(picture.view, picture.bounds()),
                           degrees);
}

void copy_camera(const hrbfnpr_camera& made, hrbfnpr_camera* to) {
    check_output_struct(to, "camera");
    write_struct(to, made);
}

constexpr std::uint64_t most_bytes = std::uint64_t{16} << 20U; // A larger settings file is refused.

picture::String read_text(hrbfnpr_read_fn read, void* user, picture::Pool& pool) {
    CallbackReader reader(read, user);
    picture::String text(&pool);
    std::array<char, 4096> block;
    for (;;) {
        const std::uint64_t size = reader.read(block.data(), block.size());
        if (size == 0) return text;
        text.append(block.data(), static_cast<std::size_t>(size));
        if (text.size() > most_bytes)
            fail(Status::invalid_argument, "the settings have more than %llu bytes, which is too many",
                 static_cast<unsigned long long>(most_bytes));
    }
}

hrbfnpr_settings* load_settings(hrbfnpr_context& context, hrbfnpr_read_fn read, void* user) {
    if (read == nullptr) fail(Status::invalid_argument, "read is NULL");
    auto* const handle = make_handle<hrbfnpr_settings>(context);
    try {
        handle->settings = picture::read_settings(read_text(read, user, handle->pool), handle->pool);
    } catch (...) {
        release_handle(handle);
        throw;
    }
    return handle;
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_picture_create(hrbfnpr_context* context, const hrbfnpr_picture_desc* desc,
                                      hrbfnpr_operation* operation, hrbfnpr_picture** out_picture,
                                      hrbfnpr_error* error) {
    return api::guarded_create(out_picture, "out_picture", error, [&] {
        return picture::create_picture(api::deref(context, "context"), api::read_struct(desc, "picture_desc"),
                                       operation);
    });
}

hrbfnpr_status hrbfnpr_picture_restyle(const hrbfnpr_picture* picture, const hrbfnpr_picture_desc* desc,
                                       hrbfnpr_operation* operation, hrbfnpr_picture** out_picture,
                                       hrbfnpr_error* error) {
    return api::guarded_create(out_picture, "out_picture", error, [&] {
        return picture::restyle_picture(api::deref(picture, "picture"), api::read_struct(desc, "picture_desc"),
                                        operation);
    });
}

void hrbfnpr_picture_retain(hrbfnpr_picture* picture) {
    if (picture != nullptr) picture->add_reference();
}

void hrbfnpr_picture_release(hrbfnpr_picture* picture) { api::release_handle(picture); }

hrbfnpr_status hrbfnpr_picture_draw(hrbfnpr_picture* picture, const hrbfnpr_camera* camera,
                                    hrbfnpr_operation* operation, hrbfnpr_drawing** out_drawing, hrbfnpr_error* error) {
    return api::guarded_create(out_drawing, "out_drawing", error, [&] {
        hrbfnpr_picture& handle = api::deref(picture, "picture");
        if (camera == nullptr) return picture::draw_picture(handle, nullptr, operation);
        const hrbfnpr_camera full = api::read_struct(camera, "camera");
        return picture::draw_picture(handle, &full, operation);
    });
}

hrbfnpr_status hrbfnpr_picture_info_init(hrbfnpr_picture_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_picture_get_info(const hrbfnpr_picture* picture, hrbfnpr_picture_info* info,
                                        hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const hrbfnpr_picture& handle = api::deref(picture, "picture");
        api::check_output_struct(info, "picture_info");
        api::write_struct(info, api::described(handle));
    });
}

hrbfnpr_status hrbfnpr_picture_part_init(hrbfnpr_picture_part* part, uint32_t struct_size) {
    return api::init_struct(part, struct_size);
}

hrbfnpr_status hrbfnpr_picture_get_part(const hrbfnpr_picture* picture, int64_t number, hrbfnpr_picture_part* part,
                                        hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const hrbfnpr_picture& handle = api::deref(picture, "picture");
        api::check_output_struct(part, "picture_part");
        api::write_struct(part, api::part_of(handle, number));
    });
}

hrbfnpr_status hrbfnpr_picture_get_style(const hrbfnpr_picture* picture, const hrbfnpr_style** style,
                                         hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const hrbfnpr_picture& handle = api::deref(picture, "picture");
        picture::require_planned(handle);
        api::deref(style, "style") = &handle.style_view;
    });
}

hrbfnpr_status hrbfnpr_picture_get_marks(const hrbfnpr_picture* picture, const hrbfnpr_generate_desc** desc,
                                         hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const hrbfnpr_picture& handle = api::deref(picture, "picture");
        picture::require_planned(handle);
        api::deref(desc, "desc") = handle.marks ? &handle.marks_view : nullptr;
    });
}

hrbfnpr_status hrbfnpr_note_init(hrbfnpr_note* note, uint32_t struct_size) {
    return api::init_struct(note, struct_size);
}

hrbfnpr_status hrbfnpr_picture_get_note(const hrbfnpr_picture* picture, int64_t number, hrbfnpr_note* note,
                                        hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const hrbfnpr_picture& handle = api::deref(picture, "picture");
        api::check_output_struct(note, "note");
        api::write_struct(note, picture::described(api::element(handle.report.notes, number, "notes")));
    });
}

hrbfnpr_status hrbfnpr_picture_event_init(hrbfnpr_picture_event* event, uint32_t struct_size) {
    return api::init_struct(event, struct_size);
}

hrbfnpr_status hrbfnpr_picture_get_stage(const hrbfnpr_picture* picture, int64_t number, hrbfnpr_picture_event* stage,
                                         hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const hrbfnpr_picture& handle = api::deref(picture, "picture");
        api::check_output_struct(stage, "stage");
        api::write_struct(stage, picture::described(api::element(handle.report.stages, number, "stages")));
    });
}

hrbfnpr_status hrbfnpr_picture_get_camera(const hrbfnpr_picture* picture, hrbfnpr_camera* camera,
                                          hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const hrbfnpr_picture& handle = api::deref(picture, "picture");
        picture::require_planned(handle);
        api::copy_camera(handle.camera, camera);
    });
}

hrbfnpr_status hrbfnpr_picture_look(const hrbfnpr_picture* picture, const double* direction, double azimuth,
                                    double elevation, hrbfnpr_camera* camera, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::copy_camera(api::look(api::deref(picture, "picture"), direction, azimuth, elevation), camera);
    });
}

hrbfnpr_status hrbfnpr_picture_orbit(const hrbfnpr_picture* picture, double degrees, hrbfnpr_camera* camera,
                                     hrbfnpr_error* error) {
    return api::guarded(error, [&] { api::copy_camera(api::orbit(api::deref(picture, "picture"), degrees), camera); });
}

hrbfnpr_status hrbfnpr_settings_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
                                     hrbfnpr_settings** out_settings, hrbfnpr_error* error) {
    return api::guarded_create(out_settings, "out_settings", error,
                               [&] { return api::load_settings(api::deref(context, "context"), read, user); });
}

void hrbfnpr_settings_retain(const hrbfnpr_settings* settings) {
    if (settings != nullptr) settings->add_reference();
}

void hrbfnpr_settings_release(const hrbfnpr_settings* settings) { api::release_handle(settings); }

} // extern "C"
