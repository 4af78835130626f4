// SPDX-License-Identifier: MIT
// The rasteriser draws into the caller's pixels, tile by tile:
// 1. prepare (raster.cpp) initialises a tile's planes: the transmittance of the ink above the paper, first 1, and the
//    colours of the inks.
// 2. draw_tile (raster.cpp; loops.cpp for many pixels at a time) adds dots and strokes from far to near. strokes.h
// makes a polygon of each segment of a stroke, and computes the area of the union of overlapping polygons.
// 3. store (raster.cpp; loops.cpp) writes the planes to the caller's pixels: it replaces these, or draws over them.
// 4. store_outputs (raster.cpp) writes the depth, id and class of the nearest layer or ink at each pixel's centre.
#pragma once

#include "base/assert.h"
#include "base/instruction_set.h"
#include "base/list.h"
#include "base/runtime.h"
#include "base/view.h"
#include "drawing/color.h"
#include "drawing/drawing.h"
#include "geometry/vec.h"
#include "output/raster/strokes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <utility>

namespace hrbfnpr::output {

// ---- The caller's pixels: which are drawn, and how they are converted to and from premultiplied floats

// The values equal those of hrbfnpr_image.format.
enum class Format : std::uint32_t {
    rgba8 = 1,
    bgra8 = 2,
    rgba8_premultiplied = 3,
    bgra8_premultiplied = 4,
    rgba32f = 5,
    rgba32f_premultiplied = 6,
    coverage8 = 7
};

[[nodiscard]] constexpr std::int64_t bytes_of_pixel(Format format) noexcept {
    if (format == Format::coverage8) return 1;
    return format == Format::rgba32f || format == Format::rgba32f_premultiplied ? 16 : 4;
}
[[nodiscard]] constexpr bool has_bytes(Format format) noexcept { return bytes_of_pixel(format) == 4; }
[[nodiscard]] constexpr bool is_premultiplied(Format format) noexcept {
    return format == Format::rgba8_premultiplied || format == Format::bgra8_premultiplied ||
           format == Format::rgba32f_premultiplied;
}
[[nodiscard]] constexpr bool is_bgra(Format format) noexcept {
    return format == Format::bgra8 || format == Format::bgra8_premultiplied;
}

struct Image {
    Format format = Format::rgba8;
    std::int32_t width = 0;
    std::int32_t height = 0;
    std::byte* pixels = nullptr; // the first byte of the top-left pixel
    std::int64_t row_stride = 0; // bytes, never 0

    [[nodiscard]] std::byte* pixel(std::int32_t x, std::int32_t y) const noexcept {
        HRBFNPR_ASSERT(x >= 0 && x < width && y >= 0 && y < height);
        return pixels + y * row_stride + bytes_of_pixel(format) * x;
    }
};

// The views have width * height elements, or are empty.
struct DrawSettings {
    bool over = false;
    bool linear_light = false;
    base::InView host_depth;
    base::OutView depth;
    base::OutView id;
    base::OutView mark_class;
};

// ---- Rectangles

// A half-open range of pixels.
struct Rect {
    std::int32_t left = 0, top = 0, right = 0, bottom = 0;
    [[nodiscard]] bool empty() const noexcept { return left >= right || top >= bottom; }
};

// Returns the pixels of the image whose centres lie in the viewport.
[[nodiscard]] inline Rect drawn_rect(const glm::dvec4& viewport, const Image& image) noexcept {
    const auto edge = [](double at, std::int32_t limit) {
        return static_cast<std::int32_t>(std::clamp(std::ceil(at - 0.5), 0.0, static_cast<double>(limit)));
    };
    return {edge(viewport.x, image.width), edge(viewport.y, image.height), edge(viewport.x + viewport.z, image.width),
            edge(viewport.y + viewport.w, image.height)};
}

// ---- Colours

[[nodiscard]] inline glm::vec4 premultiplied(const glm::vec4& straight) noexcept {
    return {glm::vec3(straight) * straight.w, straight.w};
}

using drawing::from_linear;
using drawing::to_linear;
// Converts a premultiplied colour from sRGB to linear light. Alpha does not change.
[[nodiscard]] inline glm::vec4 to_linear(const glm::vec4& c) noexcept {
    if (!(c.w > 0.0F)) return glm::vec4(0.0F);
    return {to_linear(c.x / c.w) * c.w, to_linear(c.y / c.w) * c.w, to_linear(c.z / c.w) * c.w, c.w};
}
[[nodiscard]] inline glm::vec4 from_linear(const glm::vec4& c) noexcept {
    if (!(c.w > 0.0F)) return glm::vec4(0.0F);
    return {from_linear(c.x / c.w) * c.w, from_linear(c.y / c.w) * c.w, from_linear(c.z / c.w) * c.w, c.w};
}

// ---- Pixels

[[nodiscard]] inline std::byte to_byte(float value) noexcept {
    return static_cast<std::byte>(static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255.0F + 0.5F));
}
[[nodiscard]] inline float from_byte(std::byte value) noexcept {
    constexpr float scale = 1.0F / 255.0F;
    return static_cast<float>(std::to_integer<std::uint8_t>(value)) * scale;
}

// Loads a pixel. In the coverage format the colour is black, and the alpha is the coverage.
[[nodiscard]] inline glm::vec4 load_pixel(const std::byte* at, Format format) noexcept {
    if (format == Format::coverage8) return {0.0F, 0.0F, 0.0F, from_byte(*at)};
    glm::vec4 color;
    if (has_bytes(format)) {
        for (int i = 0; i < 4; ++i) color[i] = from_byte(at[i]);
    } else {
        std::memcpy(&color[0], at, sizeof(float) * 4);
    }
    if (is_bgra(format)) std::swap(color.x, color.z);
    return is_premultiplied(format) ? color : premultiplied(color);
}

inline void store_pixel(std::byte* at, const glm::vec4& given, Format format) noexcept {
    if (format == Format::coverage8) {
        *at = to_byte(given.w);
        return;
    }
    glm::vec4 color = given; // premultiplied
    // Formats with straight alpha store transparent pixels as all zeros.
    if (!is_premultiplied(format))
        color = color.w > 0.0F ? glm::vec4(glm::vec3(color) / color.w, color.w) : glm::vec4(0.0F);
    if (is_bgra(format)) std::swap(color.x, color.z);
    if (has_bytes(format)) {
        for (int i = 0; i < 4; ++i) at[i] = to_byte(color[i]);
        return;
    }
    color = glm::clamp(color, 0.0F, 1.0F);
    std::memcpy(at, &color[0], sizeof(float) * 4);
}

// ---- Loops for each instruction set, all with identical results: discs and strokes into planes, planes to bytes

// Planes with rows of `stride` floats, one float for each pixel.
struct DiscTile {
    std::int32_t width, height, stride; // stride >= width + 8
    float* transmittance;               // the share of the paper that still shows, from 0 to 1
    float* color[3];                    // the premultiplied colour that inks add; NULL: all inks have one colour
    const float* host;                  // depth of the host's picture, decreasing towards the eye; NULL: no picture
};

// A list of inks: inks[numbers[i]] for each i. (left, top) is the tile's first pixel.
struct InkList {
    const drawing::Dot* inks;
    const std::uint32_t* numbers;
    std::int64_t count;
    float left, top;
    const float* colors;   // four numbers for each layer: RGB, and an alpha that multiplies the alpha of the ink
    float one_alpha;       // used in place of the alphas in `colors` if all inks have one colour
    float host_depth_sign; // -1 if the host's depth rises towards the eye, else 1
};

// Working planes with the tile's stride. They are zero before and after each call.
struct StrokePlanes {
    float* cover;          // the covered share of each pixel
    float* ink;            // the cover times the opacity
    StrokeUnion* overlaps; // working memory, for strokes that may overlap themselves
};

// The colours of a row of bytes: each of four channels is paper * transmittance + ink * (1 - transmittance).
struct RowColors {
    float paper[4]; // premultiplied, in the order of the bytes
    float ink[4];
    bool straight; // if true, the other channels are divided by the last one, alpha
};

struct RasterLoops {
    // Draws discs in the given order. Discs of paper need the colour planes, and restore the paper's colour.
    void (*discs)(const DiscTile& tile, const InkList& list);
    // Draws the union of a stroke's segments: the stroke gets no darker where they overlap. The cover of a pixel is the
    // exact area. Throws Error{out_of_memory}.
    void (*stroke)(const DiscTile& tile, const SegmentList& list, const StrokePlanes& planes);
    void (*store)(const RowColors& colors, const float* transmittance, std::int64_t count, std::uint32_t* pixels);
};

[[nodiscard]] RasterLoops raster_loops(base::InstructionSet set) noexcept;

// ---- The rasteriser

// Draws images. The object holds the working memory of one call at a time, and keeps it, so later calls of the same
// size allocate nothing.
class Raster {
public:
    explicit Raster(const base::Runtime& runtime) noexcept
        : runtime_(runtime), loops_(raster_loops(runtime.instruction_set)),
          published_tiles_(runtime.memory, drawing::tile_size), planes_(runtime.memory), colors_(runtime.memory),
          numbers_(runtime.memory), unions_(runtime.memory) {}

    void draw(const drawing::Drawing& drawing, const Image& image, const DrawSettings& settings);

private:
    // The numbers of a tile's ink. Each worker has its own object, on a separate cache line.
    struct alignas(base::Memory::alignment) Numbers {
        explicit Numbers(base::Memory& memory) noexcept : of_tile(memory) {}
        base::Array<std::uint32_t> of_tile; // the dots of the tile, then its segments
    };

    const base::Runtime& runtime_;
    RasterLoops loops_;
    // Lists the discs of each tile, for drawings in published mode, which have no tile lists for dots.
    drawing::Tiles published_tiles_;
    base::Array<float> planes_;      // the planes of a tile, for each worker
    base::Array<float> colors_;      // the array for InkList::colors
    base::List<Numbers> numbers_;    // one for each worker
    base::List<StrokeUnion> unions_; // one for each worker, if there are strokes
};

} // namespace hrbfnpr::output
