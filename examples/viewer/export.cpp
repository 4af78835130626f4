// SPDX-License-Identifier: MIT
#include "export.h"

#include <cstdio>
#include <png.h>

namespace viewer {

namespace {

// A file that has its name only once it is whole.
class Target {
public:
    explicit Target(const std::string& path)
        : path_(path), part_(path + ".part"), file_(std::fopen(part_.c_str(), "wb")) {
        if (file_ == nullptr) throw Failure(path + ": cannot be written; is there such a folder?");
    }
    Target(const Target&) = delete;
    Target& operator=(const Target&) = delete;
    ~Target() {
        if (file_ == nullptr) return;
        std::fclose(file_);
        std::remove(part_.c_str());
    }
    std::FILE* file() const { return file_; }
    void finish() {
        const bool whole = std::fclose(file_) == 0;
        file_ = nullptr;
        if (whole && std::rename(part_.c_str(), path_.c_str()) == 0) return;
        std::remove(part_.c_str());
        throw Failure(path_ + ": cannot be written; is there room for it?");
    }

private:
    std::string path_, part_;
    std::FILE* file_;
};

std::int32_t write_bytes(void* file, const void* data, std::uint64_t size) {
    return std::fwrite(data, 1, size, static_cast<std::FILE*>(file)) == size ? 0 : 1;
}

bool ends_with(const std::string& path, const std::string& ending) {
    return path.size() >= ending.size() && path.compare(path.size() - ending.size(), ending.size(), ending) == 0;
}

int page_format(const std::string& path) {
    static const char* const endings[] = {".svg", ".pdf", ".hpgl", ".gcode"}; // as HRBFNPR_PAGE_FORMAT_...
    for (int format = 0; format < 4; ++format)
        if (ends_with(path, endings[format])) return format;
    return -1;
}

void write_page(const Export& what, const Frame& frame, const std::string& path) {
    auto item = defaults<hrbfnpr_page_item>(hrbfnpr_page_item_init);
    item.drawing = frame.drawing.get();
    auto page = defaults<hrbfnpr_page_desc>(hrbfnpr_page_desc_init);
    page.format = static_cast<std::uint32_t>(page_format(path));
    page.items = &item;
    page.item_count = 1;
    page.width = frame.size.width * item.scale;
    page.height = frame.size.height * item.scale;
    const std::string title = what.surface.name;
    page.title = title.c_str();
    const std::string metadata = settings_text(what.settings);
    page.metadata = metadata.c_str();
    Target target(path);
    checked([&](auto* error) {
        return hrbfnpr_page_write(what.context.get(), &page, write_bytes, target.file(), nullptr, nullptr, error);
    });
    target.finish();
}

void write_picture(const Export& what, const std::string& path) {
    Frame frame;
    draw_frame(frame, what.renderer, what.surface, what.ink, what.settings, what.tone, what.size);
    if (page_format(path) >= 0)
        write_page(what, frame, path);
    else
        write_png(path, frame.pixels, frame.size);
}

void write_model(const Export& what, const std::string& path) {
    if (what.surface.model == nullptr) throw Failure(path + ": there is no model, but saved marks alone");
    Target target(path);
    checked(
        [&](auto* error) { return hrbfnpr_model_save(what.surface.model.get(), write_bytes, target.file(), error); });
    target.finish();
}

void write_marks(const Export& what, const std::string& path) {
    Target target(path);
    checked(
        [&](auto* error) { return hrbfnpr_point_set_save(what.ink.marks.get(), write_bytes, target.file(), error); });
    target.finish();
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

void write_export(const Export& what, const std::string& path) {
    if (ends_with(path, ".png") || page_format(path) >= 0) return write_picture(what, path);
    if (ends_with(path, ".hrbf")) return write_model(what, path);
    if (ends_with(path, ".hrbm")) return write_marks(what, path);
    if (ends_with(path, ".json")) return write_settings(what.settings, path);
    throw Failure(path + ": the name must end in .png, .svg, .pdf, .hpgl or .gcode for a picture, .hrbf for the model, "
                         ".hrbm for the marks, or .json for settings");
}

std::string numbered(const std::string& pattern, int number) {
    const std::size_t percent = pattern.find('%'), letter = pattern.find('d', percent);
    if (percent == std::string::npos) {
        const std::size_t dot = pattern.rfind(".png");
        if (dot == std::string::npos) throw Failure(pattern + ": frames are .png files");
        return numbered(pattern.substr(0, dot) + "-%03d.png", number);
    }
    const std::string digits = letter == std::string::npos ? "x" : pattern.substr(percent + 1, letter - percent - 1);
    if (digits.find_first_not_of("0123456789") != std::string::npos || digits.size() > 3 || !ends_with(pattern, ".png"))
        throw Failure(pattern + ": a name with a number, such as frame-%03d.png, is needed");
    std::string text = std::to_string(number);
    const std::size_t width = digits.empty() ? 0 : std::stoul(digits);
    if (text.size() < width && width <= 9) text.insert(0, width - text.size(), '0');
    return pattern.substr(0, percent) + text + pattern.substr(letter + 1);
}

} // namespace viewer
