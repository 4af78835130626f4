// SPDX-License-Identifier: MIT
// Draws plates. A separate camera draws the section as an outline, at the scale and the height of the drawing; the area
// inside the outline is hatched. An image finds this area by flood fill from outside, a page by joining outlines.
#include "picture/plate.h"

#include "api/descriptor.h"
#include "base/assert.h"
#include "output/raster/raster.h"
#include "picture/lettering.h"
#include "picture/look.h"
#include "picture/tuning_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>

namespace hrbfnpr::picture {

// ---- Options

bool has_section(const Options& options) noexcept {
    return options.desc.profile == HRBFNPR_PROFILE_AUTO ? options.is_find()
                                                        : options.desc.profile == HRBFNPR_PROFILE_YES;
}

String unit_of_bar(const Options& options, Pool& pool) {
    String unit(options.is_find() ? "units" : "none", &pool);
    if (options.desc.scale_bar != nullptr && *options.desc.scale_bar != '\0') unit = options.desc.scale_bar;
    if (unit == "none") unit.clear();
    return unit;
}

bool is_plate(const Options& options) {
    if (has_section(options)) return true;
    const char* const unit = options.desc.scale_bar;
    const bool is_given = unit != nullptr && *unit != '\0';
    return is_given ? std::string_view(unit) != "none" : options.is_find();
}

namespace {

constexpr const char* section_name = "middle"; // The name of the section in a line set.

struct ViewAxes {
    glm::dvec3 right, up, back; // `back` points towards the eye.
};
ViewAxes axes_of_camera(const hrbfnpr_camera& camera) noexcept {
    const double* const view = camera.view;
    return {{view[0], view[4], view[8]}, {view[1], view[5], view[9]}, {view[2], view[6], view[10]}};
}

glm::dvec3 middle_of_model(const Model& model) {
    const geometry::Bounds bounds = bounds_of(model);
    return (bounds.min + bounds.max) / 2.0;
}

} // namespace

Vector<LinesOnce> section_lines(const Call& call, const Model& model, const hrbfnpr_camera& camera) {
    Vector<LinesOnce> lines(&call.pool);
    if (!has_section(call.options)) return lines;
    LinesOnce& section = lines.emplace_back(std::uint32_t{HRBFNPR_LINE_KIND_SECTION}, call.pool);
    section.name = section_name;
    section.plane = axes_of_camera(camera).right;
    section.levels.push_back(glm::dot(section.plane, middle_of_model(model)));
    return lines;
}

// ---- Lengths

double bar_length(double longest) noexcept {
    if (!(longest > 0.0) || std::isinf(longest)) return 0.0;
    const double power = std::pow(10.0, std::floor(std::log10(longest)));
    constexpr double rounding = 1e-9;
    for (const double step : {5.0, 2.0, 1.0})
        if (step * power <= longest * (1.0 + rounding)) return step * power;
    return 0.0;
}

namespace {

struct PlateScale {
    double pixels; // pixels per unit of the model
    double pen;    // pixels
    glm::ivec2 size;
};

PlateScale scale_of_plate(const Plate& plate) {
    const glm::ivec2 size = size_of_image(plate.camera);
    const double longer = static_cast<double>(std::max(size.x, size.y));
    return {pixels_per_unit(plate.camera, middle_of_model(plate.model)), std::max(1.0, longer / plate_tuning.pens),
            size};
}

double strip_of_plate(const Plate& plate, const PlateScale& scale) noexcept {
    if (plate.unit.empty()) return 0.0;
    return std::max(plate_tuning.strip * static_cast<double>(std::max(scale.size.x, scale.size.y)),
                    plate_tuning.least_strip * scale.pen);
}

struct ScaleBar {
    double length = 0.0; // in units of the model; 0: no bar, because the scale is out of range
    double pixels = 0.0;
    String figure; // such as "20"
    String label;  // such as "20 cm"
};

ScaleBar bar_of_plate(const Plate& plate, const PlateScale& scale, Pool& pool) {
    ScaleBar bar{0.0, 0.0, String(&pool), String(&pool)};
    const double length = bar_length(plate_tuning.longest_bar * static_cast<double>(scale.size.x) / scale.pixels);
    if (!(length > 0.0)) return bar;
    bar.length = length;
    bar.pixels = length * scale.pixels;
    bar.figure = formatted(pool, "%g", length);
    ((bar.label = bar.figure) += ' ') += plate.unit;
    return bar;
}

// ---- The section beside the drawing

constexpr double widest_image = 32768.0; // the largest width in pixels

// Returns the camera that sees the section from its right side, at the scale and the height of the drawing.
hrbfnpr_camera camera_of_section(const Plate& plate, const PlateScale& scale, Pool& pool) {
    const auto [right, up, back] = axes_of_camera(plate.camera);
    const glm::dvec3 middle = middle_of_model(plate.model);
    Points points = positions_of(plate.marks, pool);
    double farthest_across = 0.0;
    double farthest = 0.0;
    for (glm::dvec3& point : points) {
        point -= middle;
        farthest_across = std::max(farthest_across, std::abs(glm::dot(point, right)));
        farthest = std::max(farthest, glm::length(point));
    }
    constexpr double rounding = 1e-12;
    double least = std::numeric_limits<double>::infinity();
    double most = -least;
    for (const bool all : {false, true}) {
        if (least <= most) break;
        for (const glm::dvec3& point : points) {
            if (!all && !(std::abs(glm::dot(point, right)) < plate_tuning.near_plane * farthest_across + rounding))
                continue;
            const double across = glm::dot(point, -back);
            least = std::min(least, across);
            most = std::max(most, across);
        }
    }
    if (!(least <= most)) least = most = 0.0;
    if (!(farthest > 0.0)) farthest = std::max(bounds_of(plate.model).diagonal(), rounding);

    const double margin = plate_tuning.margin * static_cast<double>(scale.size.x);
    const double width = std::max(1.0, std::nearbyint((most - least) * scale.pixels + 2.0 * margin));
    const auto height = static_cast<double>(scale.size.y);
    if (!(width <= widest_image))
        fail(Status::invalid_argument, "the section beside the drawing is %g pixels wide; at most %g are drawn", width,
             widest_image);
    // The middle of the model must be at the same height in the section and in the drawing.
    const auto row = [&](int number) {
        const double* const view = plate.camera.view;
        const double* const projection = plate.camera.projection;
        double sum = 0.0;
        for (int column = 0; column < 4; ++column) {
            double entry = 0.0;
            for (int k = 0; k < 4; ++k) entry += projection[4 * k + number] * view[4 * column + k];
            sum += entry * (column < 3 ? middle[column] : 1.0);
        }
        return sum;
    };
    const glm::dvec3 target =
        middle - row(1) / row(3) * (height / 2.0 / scale.pixels) * up - back * (most + least) / 2.0;
    const double reach = plate_tuning.camera_reach * farthest;
    const glm::dvec3 eye = target + reach * right;
    auto camera = picture::defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    call([&, &up = up](hrbfnpr_error* error) {
        return hrbfnpr_camera_look_at(&camera, &eye[0], &target[0], &up[0], error);
    });
    constexpr double near = 0.01; // the distance of the near plane, as a share of `reach`
    call([&](hrbfnpr_error* error) {
        return hrbfnpr_camera_orthographic(&camera, height / scale.pixels, width, height, near * reach, 2.0 * reach,
                                           error);
    });
    return camera;
}

// Draws the section. Halos and tapers are off: halos of contours, which are not drawn here, would leave gaps, and
// tapers would thin the ends of lines.
Drawing draw_section(hrbfnpr_context& context, const Plate& plate, const hrbfnpr_camera& camera, double pen) {
    auto outline = picture::defaults<hrbfnpr_line_style>(hrbfnpr_line_style_init);
    outline.kind = HRBFNPR_LINE_KIND_SECTION;
    outline.name = section_name;
    outline.width = static_cast<float>(plate_tuning.outline * pen);
    outline.hidden = HRBFNPR_HIDDEN_PARTS_SHOWN;
    outline.taper = 0.0F;
    auto marks = picture::defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
    marks.shown = 0;
    marks.contours = 0;
    auto style = picture::defaults<hrbfnpr_style>(hrbfnpr_style_init);
    for (int i = 0; i < 4; ++i) {
        outline.ink[i] = plate.style.base.silhouette_ink[i];
        style.paper[i] = plate.style.base.paper[i];
    }
    style.halo_width = 0.0F;
    style.layers = &marks;
    style.lines = &outline;
    style.layer_count = style.line_count = 1;
    style.layer_stride = style.line_stride = 0;
    auto item = picture::defaults<hrbfnpr_item>(hrbfnpr_item_init);
    item.point_set = plate.marks.get();
    item.style = &style;
    item.line_set = plate.lines.get();
    const auto renderer = make<Renderer>(
        [&](hrbfnpr_renderer** made, hrbfnpr_error* error) { return hrbfnpr_renderer_create(&context, made, error); });
    return make<Drawing>([&](hrbfnpr_drawing** made, hrbfnpr_error* error) {
        return hrbfnpr_renderer_draw(renderer.get(), &item, 1, 0, &camera, made, error);
    });
}

// ---- Pixels

using Rgba = std::array<std::uint8_t, 4>;

std::uint8_t rounded_byte(double value) noexcept {
    constexpr double largest = 255.0;
    return static_cast<std::uint8_t>(std::clamp(std::nearbyint(value), 0.0, largest));
}
Rgba bytes_of_color(const float (&color)[4]) noexcept {
    Rgba bytes{};
    for (std::size_t i = 0; i < 4; ++i) bytes[i] = rounded_byte(255.0 * static_cast<double>(color[i]));
    return bytes;
}

// A part of a plate: straight RGBA, and the ink coverage of each pixel.
struct PlatePixels {
    PlatePixels(glm::ivec2 pixels, const Rgba& paper, Pool& pool)
        : size(pixels), rgba(static_cast<std::size_t>(pixels.x) * static_cast<std::size_t>(pixels.y), paper, &pool),
          coverage(rgba.size(), std::uint8_t{0}, &pool) {}

    glm::ivec2 size;
    Vector<Rgba> rgba;
    Vector<std::uint8_t> coverage;

    [[nodiscard]] std::size_t place(int x, int y) const noexcept {
        HRBFNPR_ASSERT(x >= 0 && x < size.x && y >= 0 && y < size.y);
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
    }
};

// Writes a pixel of a part in the format of the caller's image.
void store_plate_pixel(const output::Image& image, int x, int y, const Rgba& rgba, std::uint8_t coverage) noexcept {
    std::byte* const at = image.pixel(x, y);
    const auto byte = [](std::uint8_t value) { return static_cast<std::byte>(value); };
    if (image.format == output::Format::coverage8) {
        *at = byte(coverage);
    } else if (image.format == output::Format::rgba8) {
        for (std::size_t i = 0; i < 4; ++i) at[i] = byte(rgba[i]);
    } else if (image.format == output::Format::bgra8) {
        for (std::size_t i = 0; i < 4; ++i) at[i] = byte(rgba[i < 3 ? 2 - i : 3]);
    } else {
        std::array<std::byte, 4> straight;
        for (std::size_t i = 0; i < 4; ++i) straight[i] = byte(rgba[i]);
        output::store_pixel(at, output::load_pixel(straight.data(), output::Format::rgba8), image.format);
    }
}

void store_part(const output::Image& image, glm::ivec2 corner, const PlatePixels& part) noexcept {
    const glm::ivec2 end = glm::min(corner + part.size, glm::ivec2(image.width, image.height));
    for (int y = corner.y; y < end.y; ++y)
        for (int x = corner.x; x < end.x; ++x) {
            const std::size_t place = part.place(x - corner.x, y - corner.y);
            store_plate_pixel(image, x, y, part.rgba[place], part.coverage[place]);
        }
}

void rasterize_into(const Drawing& drawing, glm::ivec2 size, std::uint32_t format, void* pixels) {
    auto image = picture::defaults<hrbfnpr_image>(hrbfnpr_image_init);
    image.format = format;
    image.width = size.x;
    image.height = size.y;
    image.pixels = pixels;
    call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, error); });
}

// Returns 1 for each pixel that no path from outside reaches without crossing a line. A path moves to any of the four
// neighbours.
Vector<std::uint8_t> inside_of_lines(const PlatePixels& part, const Rgba& paper, Pool& pool) {
    enum : std::uint8_t { open = 0, line = 1, outside = 2 };
    const std::int64_t width = part.size.x + 2; // One more pixel on each side.
    const std::int64_t height = part.size.y + 2;
    Vector<std::uint8_t> cells(static_cast<std::size_t>(width * height), open, &pool);
    const auto cell = [&](std::int64_t place) -> std::uint8_t& { return cells[static_cast<std::size_t>(place)]; };
    for (int y = 0; y < part.size.y; ++y)
        for (int x = 0; x < part.size.x; ++x) {
            const Rgba& pixel = part.rgba[part.place(x, y)];
            double difference = 0.0; // the largest difference between the pixel and opaque paper
            for (std::size_t i = 0; i < 3; ++i)
                difference = std::max(difference, std::abs(static_cast<double>(pixel[i] - paper[i])));
            difference *= static_cast<double>(pixel[3]) / 255.0;
            if (difference > plate_tuning.line_contrast) cell((y + 1) * width + x + 1) = line;
        }
    Vector<std::int64_t> front(&pool); // visited pixels outside whose neighbours have not been visited
    const auto reach = [&](std::int64_t place) {
        if (cell(place) != open) return;
        cell(place) = outside;
        front.push_back(place);
    };
    reach(0);
    while (!front.empty()) {
        const std::int64_t place = front.back();
        front.pop_back();
        const std::int64_t column = place % width;
        if (column > 0) reach(place - 1);
        if (column < width - 1) reach(place + 1);
        if (place >= width) reach(place - width);
        if (place < width * (height - 1)) reach(place + width);
    }
    Vector<std::uint8_t> inside(part.rgba.size(), &pool);
    for (int y = 0; y < part.size.y; ++y)
        for (int x = 0; x < part.size.x; ++x) inside[part.place(x, y)] = cell((y + 1) * width + x + 1) == open ? 1 : 0;
    return inside;
}

// Adds ink to a pixel. `cover` is the share of the pixel that the ink covers. `ink` has values from 0 to 255.
void lay_ink(PlatePixels& part, std::size_t place, double cover, const glm::dvec3& ink) noexcept {
    Rgba& pixel = part.rgba[place];
    const double before = static_cast<double>(pixel[3]) / 255.0;
    const double after = cover + before * (1.0 - cover);
    if (!(after > 0.0)) return;
    const double share = pixel[3] == 255 ? cover : cover / after; // the weight of the ink in the new colour
    for (std::size_t i = 0; i < 3; ++i) {
        const double color = pixel[i];
        pixel[i] = rounded_byte(color + share * (ink[static_cast<int>(i)] - color));
    }
    pixel[3] = rounded_byte(255.0 * after);
    const double covered = part.coverage[place];
    part.coverage[place] = rounded_byte(covered + cover * (255.0 - covered));
}

glm::dvec3 ink_of_plate(const Style& style) noexcept {
    const float(&ink)[4] = style.base.silhouette_ink;
    return 255.0 * glm::dvec3(ink[0], ink[1], ink[2]);
}

// Draws thin lines at 45 degrees inside closed outlines.
void hatch_section(PlatePixels& part, const Style& style, double pen, Pool& pool) {
    const Vector<std::uint8_t> inside = inside_of_lines(part, bytes_of_color(style.base.paper), pool);
    const double period = plate_tuning.hatch_period * pen;
    const double half_width = plate_tuning.hatch_line * pen / 2.0;
    for (int y = 0; y < part.size.y; ++y)
        for (int x = 0; x < part.size.x; ++x) {
            const std::size_t place = part.place(x, y);
            if (inside[place] == 0) continue;
            const double across = std::fmod(static_cast<double>(x + y) / std::numbers::sqrt2, period);
            const double cover = std::clamp(half_width + 0.5 - std::abs(across - period / 2.0), 0.0, 1.0);
            lay_ink(part, place, cover, ink_of_plate(style));
        }
}

PlatePixels section_pixels(hrbfnpr_context& context, const Plate& plate, const PlateScale& scale, Pool& pool) {
    const hrbfnpr_camera camera = camera_of_section(plate, scale, pool);
    const Drawing drawing = draw_section(context, plate, camera, scale.pen);
    PlatePixels part(size_of_image(camera), {}, pool);
    rasterize_into(drawing, part.size, HRBFNPR_FORMAT_RGBA8, part.rgba.data());
    rasterize_into(drawing, part.size, HRBFNPR_FORMAT_COVERAGE8, part.coverage.data());
    hatch_section(part, plate.style, scale.pen, pool);
    return part;
}

// ---- The strip with the scale bar

// Fills a box of pixels with one colour. The pixels of both corners are included.
void fill_box(PlatePixels& part, glm::i64vec2 from, glm::i64vec2 to, const Rgba& ink) noexcept {
    const glm::i64vec2 begin = glm::max(from, glm::i64vec2(0));
    const glm::i64vec2 end = glm::min(to, glm::i64vec2(part.size) - std::int64_t{1});
    for (std::int64_t y = begin.y; y <= end.y; ++y)
        for (std::int64_t x = begin.x; x <= end.x; ++x) {
            const std::size_t place = part.place(static_cast<int>(x), static_cast<int>(y));
            part.rgba[place] = ink;
            part.coverage[place] = 255;
        }
}

void outline_box(PlatePixels& part, glm::i64vec2 from, glm::i64vec2 to, std::int64_t width, const Rgba& ink) noexcept {
    const std::int64_t line = width - 1;
    fill_box(part, from, {to.x, from.y + line}, ink);
    fill_box(part, {from.x, to.y - line}, to, ink);
    fill_box(part, from, {from.x + line, to.y}, ink);
    fill_box(part, {to.x - line, from.y}, to, ink);
}

double distance_from_segment(const glm::dvec2& place, const Segment& segment) noexcept {
    const glm::dvec2 along = segment[1] - segment[0];
    const double square = glm::dot(along, along);
    const double at = square > 0.0 ? std::clamp(glm::dot(place - segment[0], along) / square, 0.0, 1.0) : 0.0;
    return glm::length(place - segment[0] - at * along);
}

// Draws a text with round strokes. At the edge of a stroke, the ink fades from half a pixel inside to half a pixel
// outside.
void draw_text(PlatePixels& part, std::string_view text, const glm::dvec2& begin, double capitals,
               const glm::dvec3& ink, Pool& pool) {
    const Vector<Segment> strokes = strokes_of_text(text, begin, capitals, pool);
    if (strokes.empty()) return;
    const double radius = text_stroke_radius(capitals);
    glm::dvec2 least = strokes[0][0];
    glm::dvec2 most = least;
    for (const Segment& stroke : strokes)
        for (const glm::dvec2& point : stroke) {
            least = glm::min(least, point);
            most = glm::max(most, point);
        }
    const glm::dvec2 size(part.size);
    const glm::ivec2 from(glm::clamp(glm::floor(least - radius - 1.0), glm::dvec2(0.0), size));
    const glm::ivec2 to(glm::clamp(glm::ceil(most + radius + 1.0), glm::dvec2(0.0), size));
    for (int y = from.y; y < to.y; ++y)
        for (int x = from.x; x < to.x; ++x) {
            const glm::dvec2 centre(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
            double distance = std::numeric_limits<double>::infinity();
            for (const Segment& stroke : strokes) distance = std::min(distance, distance_from_segment(centre, stroke));
            const double cover = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
            if (!(cover > 0.0)) continue;
            lay_ink(part, part.place(x, y), cover, ink);
        }
}

std::int64_t rounded_pixel(double value) noexcept { return static_cast<std::int64_t>(std::nearbyint(value)); }

// Draws the scale bar: five fields, alternately black and white, below the middle of the drawing, and a label with
// their total length.
void draw_bar(PlatePixels& strip, const Plate& plate, const PlateScale& scale, Pool& pool) {
    const ScaleBar bar = bar_of_plate(plate, scale, pool);
    if (!(bar.length > 0.0)) return;
    Rgba ink = bytes_of_color(plate.style.base.silhouette_ink);
    ink[3] = 255;
    const double thick = plate_tuning.bar_thickness * scale.pen;
    const std::int64_t line = std::max<std::int64_t>(1, rounded_pixel(plate_tuning.bar_line * scale.pen));
    const double left = static_cast<double>(scale.size.x / 2) - bar.pixels / 2.0;
    const std::int64_t top = strip.size.y / 3;
    // This height is added before rounding, so that rows are rounded as in the whole image.
    const std::int64_t above = scale.size.y;
    const std::int64_t bottom = rounded_pixel(static_cast<double>(above + top) + thick) - above;
    for (int i = 0; i < 5; ++i) {
        const double x = left + static_cast<double>(i) * bar.length * scale.pixels / 5.0;
        const glm::i64vec2 from(rounded_pixel(x), top);
        const glm::i64vec2 to(rounded_pixel(x + bar.pixels / 5.0), bottom);
        if (i % 2 == 0)
            fill_box(strip, from, to, ink);
        else
            outline_box(strip, from, to, line, ink);
    }
    const double capitals = plate_tuning.image_capitals * scale.pen;
    const double baseline = static_cast<double>(top) + plate_tuning.image_baseline * scale.pen;
    const auto draw_centred = [&](double at, std::string_view figure, std::string_view text) {
        draw_text(strip, text, {at - width_of_text(figure, capitals) / 2.0, baseline}, capitals,
                  glm::dvec3(ink[0], ink[1], ink[2]), pool);
    };
    draw_centred(left, "0", "0");
    draw_centred(left + bar.pixels, bar.figure, bar.label);
}

} // namespace

// ---- As an image

glm::ivec2 plate_size(const Plate& plate, Pool& pool) {
    const PlateScale scale = scale_of_plate(plate);
    glm::ivec2 size = scale.size;
    if (plate.lines) size.x += size_of_image(camera_of_section(plate, scale, pool)).x;
    size.y += static_cast<int>(std::nearbyint(strip_of_plate(plate, scale)));
    return size;
}

void rasterize_plate(hrbfnpr_context& context, const Plate& plate, const Drawing& drawing, const hrbfnpr_image& image,
                     Pool& pool) {
    const hrbfnpr_image given = api::read_struct(&image, "image");
    call([&](hrbfnpr_error* error) { return hrbfnpr_drawing_rasterize(drawing.get(), &given, nullptr, error); });
    const auto format = static_cast<output::Format>(given.format);
    const output::Image target{format, given.width, given.height, static_cast<std::byte*>(given.pixels),
                               given.row_stride != 0 ? given.row_stride : output::bytes_of_pixel(format) * given.width};
    const PlateScale scale = scale_of_plate(plate);
    int width = scale.size.x;
    if (plate.lines) {
        const PlatePixels section = section_pixels(context, plate, scale, pool);
        store_part(target, {width, 0}, section);
        width += section.size.x;
    }
    const int height = static_cast<int>(std::nearbyint(strip_of_plate(plate, scale)));
    if (height == 0) return;
    PlatePixels strip({width, height}, bytes_of_color(plate.style.base.paper), pool);
    draw_bar(strip, plate, scale, pool);
    store_part(target, {0, scale.size.y}, strip);
}

// ---- As a page

namespace {

PageNote note_of_plate(const char* group, double width, const Style& style, Pool& pool) {
    PageNote note(pool);
    note.group = group;
    note.width = width;
    std::copy_n(style.base.silhouette_ink, 4, note.ink.begin());
    return note;
}

Vector<Outline> outlines_of_drawing(const Drawing& drawing, Pool& pool) {
    const DrawnStrokes strokes = drawn_strokes(*drawing.get(), pool);
    Vector<Outline> outlines(&pool);
    for (std::size_t s = 0; s + 1 < strokes.first.size(); ++s) {
        Outline& outline = outlines.emplace_back();
        for (std::size_t i = strokes.first[s]; i < strokes.first[s + 1]; ++i)
            outline.emplace_back(static_cast<double>(strokes.points[i].x), static_cast<double>(strokes.points[i].y));
    }
    return outlines;
}

// Adds hatching to a page. `corner` is the corner of the section's drawing.
void add_hatching(PageContent& page, const Drawing& section, const glm::dvec2& corner, double pen, const Style& style,
                  Pool& pool) {
    const Vector<Outline> outlines = closed_outlines(outlines_of_drawing(section, pool), pool);
    for (const Segment& line : hatched(outlines, plate_tuning.hatch_period * pen, pool)) {
        PageNote note = note_of_plate("section hatching", plate_tuning.hatch_line * pen, style, pool);
        for (const glm::dvec2& point : line) note.points.push_back(point + corner);
        page.notes.push_back(std::move(note));
    }
}

// Adds the scale bar to a page. `middle` is the middle of its upper edge.
void add_bar(PageContent& page, const ScaleBar& bar, const glm::dvec2& middle, double pen, const Style& style,
             Pool& pool) {
    const double whole = bar.pixels;
    const double thick = plate_tuning.bar_thickness * pen;
    const glm::dvec2 corner(middle.x - whole / 2.0, middle.y);
    PageNote outline = note_of_plate("scale bar", plate_tuning.bar_line * pen, style, pool);
    for (const glm::dvec2& point : {glm::dvec2(0.0, 0.0), glm::dvec2(whole, 0.0), glm::dvec2(whole, thick),
                                    glm::dvec2(0.0, thick), glm::dvec2(0.0, 0.0)})
        outline.points.push_back(point + corner);
    page.notes.push_back(std::move(outline));
    for (const int i : {0, 2, 4}) {
        PageNote field = note_of_plate("scale bar", thick, style, pool);
        field.points.push_back(glm::dvec2(static_cast<double>(i) * whole / 5.0, thick / 2.0) + corner);
        field.points.push_back(glm::dvec2(static_cast<double>(i + 1) * whole / 5.0, thick / 2.0) + corner);
        page.notes.push_back(std::move(field));
    }
    const double height = plate_tuning.page_capitals * pen;
    const auto add_text = [&](double at, std::string_view figure, std::string_view text) {
        PageNote label = note_of_plate("scale", height, style, pool);
        const double half = plate_tuning.digit_width * height * static_cast<double>(figure.size()) / 2.0;
        label.points.emplace_back(at - half, corner.y + 2.0 * thick + height);
        label.text = text;
        page.notes.push_back(std::move(label));
    };
    add_text(corner.x, "0", "0");
    add_text(corner.x + whole, bar.figure, bar.label);
}

} // namespace

PageContent plate_page(hrbfnpr_context& context, const Plate& plate, const Drawing& drawing, Pool& pool) {
    const PlateScale scale = scale_of_plate(plate);
    const glm::dvec2 size(scale.size);
    PageContent page(pool);
    page.drawings.push_back({drawing, glm::dvec2(0.0), "view"});
    double width = size.x;
    if (plate.lines) {
        const hrbfnpr_camera camera = camera_of_section(plate, scale, pool);
        const Drawing section = draw_section(context, plate, camera, scale.pen);
        page.drawings.push_back({section, {width, 0.0}, "profile"});
        add_hatching(page, section, {width, 0.0}, scale.pen, plate.style, pool);
        width += static_cast<double>(size_of_image(camera).x);
    }
    const double strip = strip_of_plate(plate, scale);
    if (const ScaleBar bar = bar_of_plate(plate, scale, pool); strip > 0.0 && bar.length > 0.0)
        add_bar(page, bar, {size.x / 2.0, size.y + strip / 3.0}, scale.pen, plate.style, pool);
    page.size = {width, size.y + strip};
    return page;
}

} // namespace hrbfnpr::picture
