// SPDX-License-Identifier: MIT
#include "output/raster/raster.h"

#include "base/prefetch.h"
#include "drawing/drawing.h"

#include <array>
#include <atomic>
#include <limits>

namespace hrbfnpr::output {
namespace {

using drawing::Dot;
using drawing::Drawing;
using drawing::Splat;
using drawing::Stroke;
using drawing::StrokePoint;

constexpr std::int32_t side = drawing::tile_size;
constexpr std::int32_t stride = side + 16; // larger than a row, so that vector stores may pass the end of a row
constexpr std::int64_t plane = std::int64_t{stride} * side;
constexpr std::int64_t points_ahead = 10; // how many points of the tile's next stroke are prefetched
enum Plane : std::int64_t { transmittance, red, green, blue, host, cover, ink, planes };
static_assert(side <= StrokeUnion::most_side);

// The data that the tasks of all tiles share.
struct Job {
    const Drawing& drawing;
    const Image& image;
    const DrawSettings& settings;
    const RasterLoops& loops;
    const drawing::Tiles& tiles; // the tiles that list the dots
    glm::ivec2 first_pixel;      // the image's pixel at the top-left corner of the first tile
    Rect drawn;
    const float* colors; // the array for InkList::colors
    bool published;      // discs are painted in the order of the dots, paper over ink
    bool one_color;      // all inks have one colour, so their order does not matter
    glm::vec4 paper;     // premultiplied, in the colour space of blending

    [[nodiscard]] float host_depth_sign() const noexcept {
        return drawing.window.depth == drawing::DepthConvention::reversed ? -1.0F : 1.0F;
    }
    [[nodiscard]] glm::vec4 in_blend_space(const glm::vec4& color) const noexcept {
        return settings.linear_light ? to_linear(color) : color;
    }
    // Returns the colour of all inks as an opaque colour. Their alpha is accounted for in the transmittance plane.
    [[nodiscard]] glm::vec4 one_ink() const noexcept { return in_blend_space({glm::vec3(drawing.ink_color), 1.0F}); }
    [[nodiscard]] std::int64_t element(std::int32_t x, std::int32_t y) const noexcept {
        return std::int64_t{y} * image.width + x;
    }
};

// One tile of the image, and the buffers of its worker.
struct Canvas {
    std::int64_t number;
    glm::ivec2 first; // the image's pixel at the tile's top-left corner
    Rect rect;        // the pixels of the image that the tile draws
    bool is_blank;    // no dot and no segment touches the tile
    float* planes;
    StrokePlanes strokes;
    base::Array<std::uint32_t>& numbers; // working memory

    // Returns the index, in a plane, of column 0 of the image's row y. The index may lie outside the plane.
    [[nodiscard]] std::int64_t row_begin(std::int32_t y) const noexcept {
        HRBFNPR_ASSERT(y >= rect.top && y < rect.bottom);
        return std::int64_t{y - first.y} * stride - first.x;
    }
};

DiscTile prepare(const Job& job, const Canvas& canvas) noexcept {
    DiscTile tile{side, side, stride, canvas.planes, {}, nullptr};
    std::fill_n(canvas.planes + transmittance * plane, plane, 1.0F);
    for (int c = 0; c < 3 && !job.one_color; ++c) {
        tile.color[c] = canvas.planes + (red + c) * plane;
        std::fill_n(tile.color[c], plane, 0.0F);
    }
    if (job.settings.host_depth.empty()) return tile;
    tile.host = canvas.planes + host * plane;
    for (std::int32_t y = canvas.rect.top; y < canvas.rect.bottom; ++y) {
        float* const row = canvas.planes + host * plane + canvas.row_begin(y);
        for (std::int32_t x = canvas.rect.left; x < canvas.rect.right; ++x)
            row[x] = job.host_depth_sign() * static_cast<float>(job.settings.host_depth.get(job.element(x, y), 0));
    }
    return tile;
}

// ---- Ink

// Draws dots and strokes from far to near. If all inks have one colour, the order does not matter, and all strokes are
// drawn before all dots.
void draw_tile(const Job& job, const Canvas& canvas, const DiscTile& target) {
    const Drawing& drawing = job.drawing;
    const auto left = static_cast<float>(canvas.first.x), top = static_cast<float>(canvas.first.y);
    const auto draw_dots = [&](std::span<const std::uint32_t> numbers) {
        job.loops.discs(target, {drawing.dots.data(), numbers.data(), static_cast<std::int64_t>(numbers.size()), left,
                                 top, job.colors, drawing.ink_color.w, job.host_depth_sign()});
    };
    const bool in_order = job.published || job.one_color;
    const auto for_dots = [&](const auto& f) {
        job.tiles.for_spans(canvas.number, f,
                            [&](std::uint32_t a, std::uint32_t b) { return in_order ? a < b : drawing.before(a, b); });
    };
    if (job.published || drawing.strokes.empty()) {
        for_dots(draw_dots);
        return;
    }
    base::Array<std::uint32_t>& numbers = canvas.numbers; // numbers of dots, followed by numbers of segments
    numbers.clear();
    if (!job.one_color)
        for_dots([&](std::span<const std::uint32_t> some) {
            for (const std::uint32_t number : some) numbers.push_back(number);
        });
    const std::int64_t dots = numbers.size();
    drawing.segment_tiles.for_tile(canvas.number, [&](std::uint32_t segment) { numbers.push_back(segment); });
    std::int64_t drawn_dots = 0; // the number of dots that were drawn
    const auto draw_dots_to = [&](std::int64_t end) {
        draw_dots(
            numbers.span().subspan(static_cast<std::size_t>(drawn_dots), static_cast<std::size_t>(end - drawn_dots)));
        drawn_dots = end;
    };
    const Stroke* stroke = drawing.strokes.begin();
    for (std::int64_t i = dots, end = 0; i < numbers.size(); i = end) {
        stroke = stroke_of(drawing, numbers[i], stroke);
        HRBFNPR_ASSERT(numbers[i] >= stroke->first && numbers[i] + 1 < stroke->first + stroke->count);
        end = i;
        while (end < numbers.size() && numbers[end] < stroke->first + stroke->count) ++end;
        if (end < numbers.size()) base::prefetch(drawing.points.data() + numbers[end], points_ahead);
        std::int64_t before = drawn_dots;
        while (before < dots && drawing.dots[numbers[before]].depth > stroke->depth) ++before;
        draw_dots_to(before);
        job.loops.stroke(target,
                         {drawing.points.data(), stroke, numbers.data() + i, end - i, left, top,
                          job.colors + 4 * std::int64_t{stroke->layer}, job.host_depth_sign()},
                         canvas.strokes);
    }
    draw_dots_to(dots);
    if (job.one_color) for_dots(draw_dots);
}

// ---- Pixels

void store(const Job& job, const Canvas& canvas) noexcept {
    const Image& image = job.image;
    const Rect& rect = canvas.rect;
    // With ink of one colour and no blending over the image, a pixel depends only on the transmittance.
    if (job.one_color && !job.settings.over && !job.settings.linear_light && has_bytes(image.format)) {
        std::array<std::uint32_t, stride> pixels;
        glm::vec4 ink = job.one_ink(), paper = job.paper;
        if (is_bgra(image.format)) {
            std::swap(ink.x, ink.z);
            std::swap(paper.x, paper.z);
        }
        const RowColors colors{
            {paper.x, paper.y, paper.z, paper.w}, {ink.x, ink.y, ink.z, ink.w}, !is_premultiplied(image.format)};
        for (std::int32_t y = rect.top; y < rect.bottom; ++y) {
            // The rows of a tile without ink are alike.
            if (y == rect.top || !canvas.is_blank)
                job.loops.store(colors, canvas.planes + canvas.row_begin(y) + rect.left, rect.right - rect.left,
                                pixels.data());
            std::memcpy(image.pixel(rect.left, y), pixels.data(),
                        std::size_t{4} * static_cast<std::size_t>(rect.right - rect.left));
        }
        return;
    }
    const glm::vec4 one_ink = job.one_ink();
    for (std::int32_t y = rect.top; y < rect.bottom; ++y)
        for (std::int32_t x = rect.left; x < rect.right; ++x) {
            const float* const at = canvas.planes + canvas.row_begin(y) + x;
            const float left = at[transmittance * plane];
            glm::vec4 color = job.paper * left;
            if (job.one_color)
                color += one_ink * (1.0F - left);
            else
                color += glm::vec4(at[red * plane], at[green * plane], at[blue * plane], 1.0F - left);
            std::byte* const pixel = image.pixel(x, y);
            if (job.settings.over) color += job.in_blend_space(load_pixel(pixel, image.format)) * (1.0F - color.w);
            store_pixel(pixel, job.settings.linear_light ? from_linear(color) : color, image.format);
        }
}

// ---- Depth, id and class

// The nearest object at a pixel's centre: a depth layer, or ink. Ink counts as slightly nearer than the depth layer of
// its own surface.
struct Nearest {
    float depth; // in eye units
    float window;
    std::uint32_t id;
    drawing::MarkClass mark_class;
};

// Calls note(x, y, radius, nearest, reaches) for every object that may cover pixels of the tile. reaches(dx, dy,
// nearest) tells whether the object covers the place at that offset from (x, y), and may update `nearest` for it.
template <class Note>
void for_all_of_tile(const Job& job, std::int64_t tile, const Note& note) {
    const Drawing& drawing = job.drawing;
    if (drawing.has_splats)
        drawing.splat_tiles.for_tile(tile, [&](std::uint32_t i) {
            const Splat& c = drawing.splats[i];
            const drawing::MarkClass side_of = c.faces_back ? drawing::MarkClass::back : drawing::MarkClass::front;
            note(c.x, c.y, c.radius, Nearest{c.depth, c.window, c.id, side_of}, [&](float dx, float dy, Nearest&) {
                const float fall = (dx * c.slope_x + dy * c.slope_y) * c.pixels_per_unit;
                return dx * dx + dy * dy + fall * fall <= c.radius * c.radius;
            });
        });
    job.tiles.for_tile(tile, [&](std::uint32_t i) {
        const Dot& dot = drawing.dots[i];
        if (!(dot.opacity > 0.0F)) return;
        const float radius = std::max(dot.radius, drawing::smallest_radius);
        note(dot.x, dot.y, radius,
             Nearest{dot.depth - 2.0F * radius / dot.pixels_per_unit, dot.window, dot.id, dot.mark_class},
             [&](float dx, float dy, Nearest&) { return dx * dx + dy * dy <= radius * radius; });
    });
    if (job.published || drawing.strokes.empty()) return;
    // A segment has its own depth at each pixel, and the id of the end that is closer to the pixel.
    drawing.segment_tiles.for_tile(tile, [&](std::uint32_t i) {
        const Stroke& stroke = *stroke_of(drawing, i, drawing.strokes.begin());
        const StrokePoint& a = drawing.points[i];
        const StrokePoint& b = drawing.points[std::int64_t{i} + 1];
        const drawing::SegmentEnds ends = drawing::ends_of(stroke, i);
        const glm::vec2 middle(0.5F * (a.x + b.x), 0.5F * (a.y + b.y));
        const float half = 0.5F * std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
        const drawing::MarkClass mark_class = drawing.layers[stroke.layer].mark_class;
        note(middle.x, middle.y, half + reach(ends, a, b), Nearest{0.0F, 0.0F, 0, mark_class},
             [&](float dx, float dy, Nearest& what) {
                 float at = 0.0F;
                 if (!drawing::covers(ends, a, b, middle.x + dx, middle.y + dy, at)) return false;
                 const float radius = std::max(glm::mix(a.radius, b.radius, at), drawing::smallest_radius);
                 what.id = at > 0.5F ? b.id : a.id;
                 what.window = glm::mix(a.window, b.window, at);
                 what.depth = glm::mix(a.depth, b.depth, at) -
                              2.0F * radius / glm::mix(a.pixels_per_unit, b.pixels_per_unit, at);
                 return true;
             });
    });
}

// In published mode the id and class come from the disc painted last, and the depth from the nearest disc.
void store_outputs(const Job& job, const Canvas& canvas) {
    const DrawSettings& settings = job.settings;
    const Rect& rect = canvas.rect;
    const drawing::DepthConvention convention = job.drawing.window.depth;
    const auto is_behind_host = [&](float window, std::int32_t x, std::int32_t y) {
        return !settings.host_depth.empty() &&
               drawing::nearer(static_cast<float>(settings.host_depth.get(job.element(x, y), 0)), window, convention);
    };
    std::array<Nearest, side> row;
    for (std::int32_t y = rect.top; y < rect.bottom; ++y) {
        row.fill({std::numeric_limits<float>::infinity(), drawing::far_depth(convention), 0, drawing::MarkClass::none});
        const auto note = [&](float cx, float cy, float radius, Nearest what, const auto& reaches) {
            const float dy = static_cast<float>(y) + 0.5F - cy;
            if (!(dy * dy <= radius * radius)) return;
            const auto first = static_cast<float>(rect.left), last = static_cast<float>(rect.right - 1);
            const auto from = static_cast<std::int32_t>(std::clamp(cx - radius, first, last));
            const auto to = static_cast<std::int32_t>(std::clamp(cx + radius, first, last));
            for (std::int32_t x = from; x <= to; ++x) {
                Nearest& nearest = row[static_cast<std::size_t>(x - rect.left)];
                if (!reaches(static_cast<float>(x) + 0.5F - cx, dy, what)) continue;
                if (!job.published && !(what.depth < nearest.depth)) continue;
                if (is_behind_host(what.window, x, y)) continue;
                const float before = nearest.window;
                nearest = what;
                if (job.published && !drawing::nearer(what.window, before, convention)) nearest.window = before;
            }
        };
        for_all_of_tile(job, canvas.number, note);
        for (std::int32_t x = rect.left; x < rect.right; ++x) {
            const Nearest& nearest = row[static_cast<std::size_t>(x - rect.left)];
            const std::int64_t element = job.element(x, y);
            if (settings.depth) settings.depth.set(element, 0, static_cast<double>(nearest.window));
            if (settings.id) settings.id.set(element, 0, static_cast<double>(nearest.id));
            if (settings.mark_class) settings.mark_class.set(element, 0, static_cast<double>(nearest.mark_class));
        }
    }
}

} // namespace

void Raster::draw(const Drawing& drawing, const Image& image, const DrawSettings& settings) {
    const Rect drawn = drawn_rect(drawing.window.viewport, image);
    if (drawn.empty()) return;
    colors_.clear();
    for (const drawing::Layer& layer : drawing.layers) {
        const glm::vec4 opaque(glm::vec3(layer.ink), 1.0F);
        const glm::vec4 light = settings.linear_light ? to_linear(opaque) : opaque;
        for (const float value : {light.x, light.y, light.z, layer.ink.w}) colors_.push_back(value);
    }
    const bool published = drawing.painting == drawing::Painting::published;
    if (published)
        published_tiles_.build(runtime_.parallel, drawn.right - drawn.left, drawn.bottom - drawn.top,
                               drawing.dot_ranges.span(), [&](std::int64_t i, drawing::Tiles::Footprint& print) {
                                   const Dot& dot = drawing.dots[i];
                                   print = drawing::Tiles::Footprint::of_disc(
                                       dot.x - static_cast<float>(drawn.left), dot.y - static_cast<float>(drawn.top),
                                       std::max(dot.radius, drawing::smallest_radius) + drawing::soft_rim);
                                   return true;
                               });
    const std::int64_t workers = std::max(1, runtime_.parallel.threads());
    base::resize_scratch(planes_, workers * planes * plane);
    while (numbers_.size() < workers) numbers_.add(runtime_.memory);
    if (!drawing.strokes.empty()) {
        while (unions_.size() < workers) unions_.add(runtime_.memory);
        // Any worker may get the tile with the most ink, so all workers reserve room for it.
        const std::int64_t most = drawing.dot_tiles.largest_tile_count() + drawing.segment_tiles.largest_tile_count();
        for (std::int64_t worker = 0; worker < workers; ++worker) numbers_[worker].of_tile.reserve(most);
    }
    const glm::vec4 paper = image.format == Format::coverage8 ? glm::vec4(0.0F) : premultiplied(drawing.paper);
    const Job job{drawing,
                  image,
                  settings,
                  loops_,
                  published ? published_tiles_ : drawing.dot_tiles,
                  published ? glm::ivec2(drawn.left, drawn.top) : drawing.first_pixel,
                  drawn,
                  colors_.data(),
                  published,
                  drawing.one_color && !published,
                  settings.linear_light ? to_linear(paper) : paper};
    std::atomic<std::int64_t> next{0};
    runtime_.parallel.for_each(workers, [&](std::int64_t worker) {
        float* const own = planes_.data() + worker * planes * plane;
        Canvas canvas{
            0, {}, {}, true, own, {own + cover * plane, own + ink * plane, nullptr}, numbers_[worker].of_tile};
        if (!drawing.strokes.empty()) {
            canvas.strokes.overlaps = &unions_[worker];
            std::fill_n(canvas.strokes.cover, plane, 0.0F);
            std::fill_n(canvas.strokes.ink, plane, 0.0F);
        }
        while ((canvas.number = next++) < job.tiles.tiles()) {
            canvas.first = job.first_pixel + side * glm::ivec2(static_cast<int>(canvas.number % job.tiles.columns()),
                                                               static_cast<int>(canvas.number / job.tiles.columns()));
            canvas.rect = {std::max(canvas.first.x, job.drawn.left), std::max(canvas.first.y, job.drawn.top),
                           std::min(canvas.first.x + side, job.drawn.right),
                           std::min(canvas.first.y + side, job.drawn.bottom)};
            if (canvas.rect.empty()) continue;
            canvas.is_blank = job.tiles.is_empty(canvas.number) &&
                              (published || drawing.strokes.empty() || drawing.segment_tiles.is_empty(canvas.number));
            draw_tile(job, canvas, prepare(job, canvas));
            store(job, canvas);
            if (job.settings.depth || job.settings.id || job.settings.mark_class) store_outputs(job, canvas);
        }
    });
}

} // namespace hrbfnpr::output
