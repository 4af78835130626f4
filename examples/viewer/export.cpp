// SPDX-License-Identifier: MIT
#include "export.h"

#include "files.h"

#include <png.h>

namespace viewer {

namespace {

bool ends_with(const std::string& path, const std::string& ending) {
    return path.size() >= ending.size() && path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

int page_format(const std::string& path) {
    static const char* const endings[] = {".svg", ".pdf", ".hpgl", ".gcode",
                                          ".dxf"}; // in the order of HRBFNPR_PAGE_FORMAT_*
    for (int format = 0; format < 5; ++format)
        if (ends_with(path, endings[format])) return format;
    return -1;
}

// camera: null means the planned one.
Drawing drawn(const Picture& picture, const hrbfnpr_camera* camera) {
    return make<hrbfnpr_drawing>(hrbfnpr_drawing_release, [&](auto** out, auto* error) {
        return hrbfnpr_picture_draw(picture.get(), camera, nullptr, out, error);
    });
}

void write_pixels(const Picture& picture, const hrbfnpr_camera* camera, const std::string& path) {
    const Drawing drawing = drawn(picture, camera);
    Size size;
    checked([&](auto* error) {
        return hrbfnpr_picture_plate_size(picture.get(), camera, &size.width, &size.height, error);
    });
    std::vector<std::uint8_t> pixels(std::size_t{4} * static_cast<std::size_t>(size.width) *
                                     static_cast<std::size_t>(size.height));
    auto image = defaults<hrbfnpr_image>(hrbfnpr_image_init);
    image.format = HRBFNPR_FORMAT_RGBA8;
    image.width = size.width;
    image.height = size.height;
    image.pixels = pixels.data();
    checked(
        [&](auto* error) { return hrbfnpr_picture_rasterize(picture.get(), drawing.get(), camera, &image, error); });
    write_png(path, pixels, size);
}

void write_page(const Picture& picture, const std::string& path) {
    const Drawing drawing = drawn(picture, nullptr);
    auto page = defaults<hrbfnpr_page_desc>(hrbfnpr_page_desc_init);
    page.format = static_cast<std::uint32_t>(page_format(path));
    auto desc = defaults<hrbfnpr_picture_page_desc>(hrbfnpr_picture_page_desc_init);
    desc.page = &page;
    Target target(path);
    checked([&](auto* error) {
        return hrbfnpr_picture_write(picture.get(), drawing.get(), nullptr, &desc, write_to_file, target.file(),
                                     nullptr, nullptr, error);
    });
    target.finish();
}

void write_model(const hrbfnpr_model* model, const std::string& path) {
    if (model == nullptr) throw Failure(path + ": saved marks have no model to write; write .hrbm, or open a model");
    Target target(path);
    checked([&](auto* error) { return hrbfnpr_model_save(model, write_to_file, target.file(), error); });
    target.finish();
}

void write_marks(const Picture& picture, const std::string& path) {
    auto part = defaults<hrbfnpr_picture_part>(hrbfnpr_picture_part_init);
    checked([&](auto* error) { return hrbfnpr_picture_get_part(picture.get(), 0, &part, error); });
    Target target(path);
    checked([&](auto* error) { return hrbfnpr_point_set_save(part.point_set, write_to_file, target.file(), error); });
    target.finish();
}

void write_text(const std::string& text, const std::string& path) {
    Target target(path);
    if (write_to_file(target.file(), text.data(), text.size()) != 0)
        throw Failure(path + ": cannot be written; is the disk full?");
    target.finish();
}

Picture picture_of(const Export& what, Work& work) {
    return restyled_picture(what.scene.picture, what.choices, what.size, what.view ? &*what.view : nullptr, work);
}

} // namespace

void write_png(const std::string& path, const std::vector<std::uint8_t>& rgba, Size size) {
    Target target(path);
    png_image image = {};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(size.width);
    image.height = static_cast<png_uint_32>(size.height);
    image.format = PNG_FORMAT_RGBA;
    if (png_image_write_to_stdio(&image, target.file(), 0, rgba.data(), 0, nullptr) == 0)
        throw Failure(path + ": " + image.message);
    target.finish();
}

void check_ending(const std::string& path) {
    for (const char* const ending : {".png", ".hrbf", ".hrbm", ".json"})
        if (ends_with(path, ending)) return;
    if (page_format(path) >= 0) return;
    throw Failure(path + ": the name must end in .png, .svg, .pdf, .hpgl, .gcode or .dxf for a picture, .hrbf for the "
                         "model, .hrbm for the marks, or .json for settings");
}

void write_export(const Export& what, const std::string& path, Work& work) {
    check_ending(path);
    if (ends_with(path, ".hrbf")) return write_model(what.scene.parts.front().model, path);
    const Picture picture = picture_of(what, work);
    if (ends_with(path, ".hrbm")) return write_marks(picture, path);
    if (ends_with(path, ".json")) return write_text(settings_of(picture), path);
    if (page_format(path) >= 0) return write_page(picture, path);
    write_pixels(picture, nullptr, path);
}

void write_turntable(const Export& what, const std::string& pattern, int frames, Work& work) {
    const Picture picture = picture_of(what, work);
    for (int frame = 0; frame < frames; ++frame) {
        work.step("frame " + std::to_string(frame), static_cast<double>(frame) / frames);
        auto camera = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
        checked(
            [&](auto* error) { return hrbfnpr_picture_orbit(picture.get(), 360.0 * frame / frames, &camera, error); });
        write_pixels(picture, &camera, numbered(pattern, frame));
    }
}

std::string numbered(const std::string& pattern, int number) {
    const std::size_t percent = pattern.find('%'), letter = pattern.find('d', percent);
    if (percent == std::string::npos) {
        const std::size_t dot = pattern.rfind(".png");
        if (dot == std::string::npos) throw Failure(pattern + ": the name of the frames must end in .png");
        return numbered(pattern.substr(0, dot) + "-%03d.png", number);
    }
    const std::string digits = letter == std::string::npos ? "x" : pattern.substr(percent + 1, letter - percent - 1);
    if (digits.find_first_not_of("0123456789") != std::string::npos || digits.size() > 3 || !ends_with(pattern, ".png"))
        throw Failure(pattern + ": the name needs a place for the number, as in frame-%03d.png");
    std::string text = std::to_string(number);
    const std::size_t width = digits.empty() ? 0 : std::stoul(digits);
    if (text.size() < width && width <= 9) text.insert(0, width - text.size(), '0');
    return pattern.substr(0, percent) + text + pattern.substr(letter + 1);
}

} // namespace viewer
