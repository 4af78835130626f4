// SPDX-License-Identifier: MIT
// A picture to draw into, and functions that measure it.
#pragma once

#include "frame/hand_made.h"
#include "output/raster/raster.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

namespace hrbfnpr::testing {

struct Picture {
    Picture(int width_, int height_, output::Format format_ = output::Format::rgba8)
        : width(width_), height(height_), format(format_),
          bytes(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_) *
                static_cast<std::size_t>(output::bytes_of_pixel(format_))) {}

    [[nodiscard]] output::Image image() {
        return {format, width, height, bytes.data(), output::bytes_of_pixel(format) * width};
    }
    // Returns a channel of a format with four bytes per pixel.
    [[nodiscard]] int at(int x, int y, int channel) const {
        return std::to_integer<int>(
            bytes[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 4 +
                  static_cast<std::size_t>(channel)]);
    }
    // Returns a channel as a number; 1 is white or opaque.
    [[nodiscard]] float value(int x, int y, int channel) const {
        const std::int64_t size = output::bytes_of_pixel(format);
        const std::byte* const pixel = bytes.data() + size * (std::int64_t{y} * width + x);
        if (size < 16) return static_cast<float>(std::to_integer<int>(pixel[channel])) / 255.0F;
        float number;
        std::memcpy(&number, pixel + 4 * channel, sizeof number);
        return number;
    }
    // Returns the mean of 1 - red over a rectangle: the share that black ink covers on white paper.
    [[nodiscard]] double darkness(int left, int top, int right, int bottom) const {
        double sum = 0.0;
        for (int y = top; y < bottom; ++y) {
            for (int x = left; x < right; ++x) sum += 1.0 - at(x, y, 0) / 255.0;
        }
        return sum / ((right - left) * (bottom - top));
    }
    [[nodiscard]] double darkness() const { return darkness(0, 0, width, height); }

    // Writes <folder>/<name>.ppm if the variable HRBFNPR_TEST_PICTURES names a folder.
    void keep(const std::string& name) const {
        const char* folder = std::getenv("HRBFNPR_TEST_PICTURES");
        if (folder == nullptr) return;
        std::FILE* file = std::fopen((std::string(folder) + "/" + name + ".ppm").c_str(), "wb");
        if (file == nullptr) return;
        std::fprintf(file, "P6\n%d %d\n255\n", width, height);
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                for (int c = 0; c < 3; ++c) std::fputc(at(x, y, c), file);
            }
        }
        std::fclose(file);
    }

    int width, height;
    output::Format format;
    std::vector<std::byte> bytes;
};

// Makes one draw with new scratch memory.
inline Picture picture_of(const base::Runtime& runtime, std::span<const frame::Item> items, const frame::Camera& camera,
                          int width, int height, drawing::Counts* info = nullptr) {
    DrawnFrame frame(runtime);
    frame.draw(items, camera);
    Picture picture(width, height);
    output::Raster raster(runtime);
    raster.draw(frame.drawing(), picture.image(), {});
    if (info != nullptr) *info = frame.info();
    return picture;
}

} // namespace hrbfnpr::testing
