// SPDX-License-Identifier: MIT
// Implements the C functions that return the results of a picture: images, pages, drawing sheets and settings.
#include "api/barrier.h"
#include "api/camera.h"
#include "api/descriptor.h"
#include "api/drawing.h"
#include "api/streams.h"
#include "picture/lines.h"
#include "picture/make.h"
#include "picture/page.h"
#include "picture/picture.h"
#include "picture/plate.h"
#include "picture/views.h"
#include "picture/wanted_lines.h"

using namespace hrbfnpr;

namespace hrbfnpr::api {

template <>
hrbfnpr_picture_page_desc defaults() noexcept {
    hrbfnpr_picture_page_desc desc{};
    desc.paper_margin = 10.0;
    return desc;
}

} // namespace hrbfnpr::api

namespace hrbfnpr::picture {
namespace {

// Returns whether the picture has a scale bar or a section beside the drawing. A point set without a model has neither.
bool has_plate(const hrbfnpr_picture& picture) { return !picture.surfaces().list.empty() && is_plate(picture.options); }

// Returns the plate for a drawing. It refers to the camera, the unit and the section, which must outlive it.
Plate plate_of(const hrbfnpr_picture& picture, const hrbfnpr_camera& camera, std::string_view unit,
               const LineSet& section) {
    return {picture.surfaces().list.front().model, picture.parts.front().marks, section, camera, *picture.style, unit};
}

LineSet section_of(const hrbfnpr_picture& picture) {
    return has_section(picture.options) ? picture.parts.front().lines : LineSet();
}

hrbfnpr_camera camera_of(const hrbfnpr_picture& picture, const hrbfnpr_camera* camera) {
    require_planned(picture);
    return camera != nullptr ? api::read_struct(camera, "camera") : picture.camera;
}

glm::ivec2 size_of_plate(const hrbfnpr_picture& picture, const hrbfnpr_camera* given) {
    const hrbfnpr_camera camera = camera_of(picture, given);
    if (!has_plate(picture)) return size_of_image(camera);
    const String unit = unit_of_bar(picture.options, picture.pool);
    return plate_size(plate_of(picture, camera, unit, section_of(picture)), picture.pool);
}

void rasterize(const hrbfnpr_picture& picture, const hrbfnpr_drawing* drawing, const hrbfnpr_camera* given,
               const hrbfnpr_image* image) {
    const hrbfnpr_camera camera = camera_of(picture, given);
    api::require_pointer(drawing, "drawing");
    const hrbfnpr_image full = api::read_struct(image, "image");
    if (!has_plate(picture)) {
        call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_rasterize(drawing, &full, nullptr, error); });
        return;
    }
    const glm::ivec2 least = size_of_plate(picture, given);
    if (full.width < least.x || full.height < least.y)
        fail(Status::invalid_argument,
             "image has %d x %d pixels; the picture takes %d x %d: see hrbfnpr_picture_plate_size", full.width,
             full.height, least.x, least.y);
    const String unit = unit_of_bar(picture.options, picture.pool);
    rasterize_plate(picture.context(), plate_of(picture, camera, unit, section_of(picture)), Drawing::shared(drawing),
                    full, picture.pool);
}

String metadata_of(hrbfnpr_picture& picture, const hrbfnpr_camera& camera) {
    Vector<Model> models(&picture.pool);
    for (const Surface& surface : picture.surfaces().list) models.push_back(surface.model);
    const char* const style = hrbfnpr_preset_name(picture.options.desc.preset);
    return page_metadata(picture.surfaces().name, style != nullptr ? style : "", models, picture.mark_count(), camera,
                         picture.pool);
}

void write_page(hrbfnpr_picture& picture, const hrbfnpr_drawing* drawing, const hrbfnpr_camera* given,
                const hrbfnpr_picture_page_desc* desc, hrbfnpr_write_fn write, void* user, hrbfnpr_page_info* info,
                hrbfnpr_operation* operation) {
    const hrbfnpr_camera camera = camera_of(picture, given);
    api::require_pointer(drawing, "drawing");
    const Drawing held = Drawing::shared(drawing);
    const String unit = unit_of_bar(picture.options, picture.pool);
    const PageContent content =
        has_plate(picture)
            ? plate_page(picture.context(), plate_of(picture, camera, unit, section_of(picture)), held, picture.pool)
            : page_of(held, camera, picture.pool);
    const String& name = picture.surfaces().name;
    const hrbfnpr_picture_page_desc full = api::read_optional_struct(desc, "picture_page_desc");
    write_picture_page(picture.context(), picture.report, content, full, name.empty() ? nullptr : name.c_str(),
                       metadata_of(picture, camera).c_str(), write, user, info, operation);
}

void write_sheet(hrbfnpr_picture& picture, const hrbfnpr_views_desc* desc, hrbfnpr_write_fn write, void* user,
                 hrbfnpr_views_info* info, hrbfnpr_operation* operation) {
    const Surfaces& surfaces = picture.surfaces();
    if (surfaces.list.empty())
        fail(Status::invalid_argument, "picture shows a point set; views need samples, a mesh or a model");
    if (info != nullptr) api::check_output_struct(info, "views_info");
    if (write == nullptr) fail(Status::invalid_argument, "write is NULL");
    const hrbfnpr_views_desc full =
        desc != nullptr ? api::read_struct(desc, "views_desc") : defaults<hrbfnpr_views_desc>(hrbfnpr_views_desc_init);
    ViewsOptions options = read_views(full, picture.report);
    if (options.model.empty()) options.model = surfaces.name;
    const api::OperationUse use(operation);
    const Serving serving(picture.report, operation);
    auto written = defaults<hrbfnpr_views_info>(hrbfnpr_views_info_init);
    write_views(picture.call(), surfaces.list, surfaces.up, options, write, user, written);
    use.finish();
    if (info != nullptr) api::write_struct(info, written);
}

void write_settings_of(hrbfnpr_picture& picture, hrbfnpr_write_fn write, void* user) {
    require_planned(picture);
    if (write == nullptr) fail(Status::invalid_argument, "write is NULL");
    const Surfaces& surfaces = picture.surfaces();
    Vector<LinesOnce> once(&picture.pool);
    if (!surfaces.list.empty()) {
        const Surface& surface = surfaces.list.front();
        const bool is_mesh = surface.shape != nullptr && surface.shape->is_mesh();
        const Call call = picture.call();
        once = lines_found_once(call, *surface.model.get(), wanted_lines(call, *picture.style, is_mesh));
    }
    Vector<hrbfnpr_line_desc> lines(&picture.pool);
    for (const LinesOnce& one : once) lines.push_back(one.view());
    const PictureParts parts{picture.options.desc.preset,
                             picture.camera,
                             *picture.style,
                             picture.marks ? &*picture.marks : nullptr,
                             lines,
                             picture.ground ? &picture.ground->style.layers.front() : nullptr};
    const WrittenSettings written = write_settings(picture.options, parts, picture.pool);
    api::CallbackWriter(write, user).write(written.json.data(), written.json.size());
    if (written.not_held.empty()) return;
    String text("settings do not hold ", &picture.pool);
    (text += written.not_held) += ": give them again";
    String detail("They do not hold ", &picture.pool);
    (detail += written.not_held) += ". Give these together with {settings}.";
    if (!picture.report.is_short(text)) text = "settings do not hold all options of the surface: give them again";
    picture.report.note(HRBFNPR_NOTE_NOT_IN_SETTINGS, {}, text, {.detail = detail});
}

} // namespace
} // namespace hrbfnpr::picture

extern "C" {

hrbfnpr_status hrbfnpr_picture_plate_size(const hrbfnpr_picture* picture, const hrbfnpr_camera* camera, int32_t* width,
                                          int32_t* height, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::require_pointer(width, "width");
        api::require_pointer(height, "height");
        const glm::ivec2 size = picture::size_of_plate(api::deref(picture, "picture"), camera);
        *width = size.x;
        *height = size.y;
    });
}

hrbfnpr_status hrbfnpr_picture_rasterize(const hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing,
                                         const hrbfnpr_camera* camera, const hrbfnpr_image* image,
                                         hrbfnpr_error* error) {
    return api::guarded(error, [&] { picture::rasterize(api::deref(picture, "picture"), drawing, camera, image); });
}

hrbfnpr_status hrbfnpr_picture_page_desc_init(hrbfnpr_picture_page_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_picture_write(hrbfnpr_picture* picture, const hrbfnpr_drawing* drawing,
                                     const hrbfnpr_camera* camera, const hrbfnpr_picture_page_desc* desc,
                                     hrbfnpr_write_fn write, void* user, hrbfnpr_page_info* info,
                                     hrbfnpr_operation* operation, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        picture::write_page(api::deref(picture, "picture"), drawing, camera, desc, write, user, info, operation);
    });
}

hrbfnpr_status hrbfnpr_picture_write_settings(hrbfnpr_picture* picture, hrbfnpr_write_fn write, void* user,
                                              hrbfnpr_error* error) {
    return api::guarded(error, [&] { picture::write_settings_of(api::deref(picture, "picture"), write, user); });
}

hrbfnpr_status hrbfnpr_picture_write_views(hrbfnpr_picture* picture, const hrbfnpr_views_desc* desc,
                                           hrbfnpr_write_fn write, void* user, hrbfnpr_views_info* info,
                                           hrbfnpr_operation* operation, hrbfnpr_error* error) {
    return api::guarded(
        error, [&] { picture::write_sheet(api::deref(picture, "picture"), desc, write, user, info, operation); });
}

} // extern "C"
