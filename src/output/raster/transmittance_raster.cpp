// SPDX-License-Identifier: MIT
#include "output/raster/transmittance_raster.h"

#include "base/prefetch.h"
#include "drawing/segments.h"
#include "output/raster/pixels.h"
#include "output/raster/rects.h"
#include "output/raster/srgb.h"

#include <atomic>
#include <cmath>
#include <cstring>

namespace hrbfnpr::output {
namespace {

using drawing::Dot;
using drawing::Drawing;
using drawing::Splat;
using drawing::Stroke;
using drawing::StrokePoint;

constexpr std::int32_t side = drawing::tile_size;
constexpr std::int32_t stride = side + 16; // vectors may run over a row's end
constexpr std::int64_t plane = std::int64_t{stride} * side;
constexpr std::int64_t points_ahead = 10; // of the next stroke in a tile
enum Plane : std::int64_t { transmittance, red, green, blue, host, cover, ink, planes };

// What a worker writes to.
struct Scratch {
    float* planes;
    StrokePlanes strokes;
    base::Array<std::uint32_t>& numbers;
};

// Everything that a tile's task reads.
class TransmittancePainter {
public:
    TransmittancePainter(const Drawing& drawing, const Image& image, const DrawSettings& settings,
                         const DiscLoops& loops, const StrokeLoops& stroke_loops, const Scratch& scratch,
                         const float* colors, const Rect& drawn) noexcept
        : drawing_(drawing), convention_(drawing.window.depth), image_(image), settings_(settings), loops_(loops),
          stroke_loops_(stroke_loops), scratch_(scratch.planes), stroke_planes_(scratch.strokes),
          numbers_(scratch.numbers), colors_(colors), drawn_(drawn), coverage_(image.format == Format::coverage8),
          paper_(coverage_ ? glm::vec4(0.0F) : in_light(premultiplied(drawing.paper))),
          outputs_(settings.depth || settings.id || settings.mark_class),
          // One colour, and nothing but the drawing: a pixel is a function of what is left of the paper.
          simple_(drawing.one_color && !settings.over && !settings.linear_light && has_bytes(image.format)) {}

    void operator()(std::int64_t tile) {
        const drawing::Tiles& tiles = drawing_.dot_tiles;
        const glm::ivec2 first = drawing_.first_pixel + glm::ivec2(static_cast<int>(tile % tiles.columns()) * side,
                                                                   static_cast<int>(tile / tiles.columns()) * side);
        const Rect rect = {std::max(first.x, drawn_.left), std::max(first.y, drawn_.top),
                           std::min(first.x + side, drawn_.right), std::min(first.y + side, drawn_.bottom)};
        if (rect.empty()) return;
        const DiscTile target = prepare(rect, first);
        if (drawing_.strokes.empty())
            draw_dots(tile, target, first);
        else
            draw_all(tile, target, first);
        for (std::int32_t y = rect.top; y < rect.bottom; ++y) store_row(rect, first, y);
        if (outputs_) store_outputs(tile, rect);
    }

private:
    [[nodiscard]] float toward() const noexcept {
        return convention_ == drawing::DepthConvention::reversed ? -1.0F : 1.0F;
    }

    // Calls f for consecutive parts of the tile's dots, in the order of painting.
    template <class F>
    void for_dots(std::int64_t tile, const F& f) const {
        const bool one = drawing_.one_color;
        drawing_.dot_tiles.for_spans(
            tile, f, [&](std::uint32_t a, std::uint32_t b) { return one ? a < b : drawing_.before(a, b); });
    }

    void lay_dots(std::span<const std::uint32_t> numbers, const DiscTile& target, const glm::ivec2& first) const {
        loops_.draw(target, {drawing_.dots.data(), numbers.data(), static_cast<std::int64_t>(numbers.size()),
                             static_cast<float>(first.x), static_cast<float>(first.y), colors_, drawing_.ink_color.w,
                             toward()});
    }

    void draw_dots(std::int64_t tile, const DiscTile& target, const glm::ivec2& first) const {
        for_dots(tile, [&](std::span<const std::uint32_t> numbers) { lay_dots(numbers, target, first); });
    }

    // Strokes among the dots, far to near; where all ink has one colour the order does not matter.
    void draw_all(std::int64_t tile, const DiscTile& target, const glm::ivec2& first) {
        numbers_.clear();
        if (!drawing_.one_color)
            for_dots(tile, [&](std::span<const std::uint32_t> numbers) {
                for (const std::uint32_t number : numbers) numbers_.push_back(number);
            });
        const std::int64_t dots = numbers_.size();
        drawing_.segment_tiles.for_tile(tile, [&](std::uint32_t segment) { numbers_.push_back(segment); });
        std::int64_t laid = 0; // of the dots
        const Stroke* stroke = drawing_.strokes.begin();
        for (std::int64_t i = dots; i < numbers_.size();) {
            stroke = stroke_of(numbers_[i], stroke);
            std::int64_t end = i;
            while (end < numbers_.size() && numbers_[end] < stroke->first + stroke->count) ++end;
            if (end < numbers_.size()) base::prefetch(drawing_.points.data() + numbers_[end], points_ahead);
            std::int64_t before = laid;
            while (before < dots && drawing_.dots[numbers_[before]].depth > stroke->depth) ++before;
            lay_dots(part(laid, before), target, first);
            laid = before;
            stroke_loops_.lay(target,
                              {drawing_.points.data(), stroke, numbers_.data() + i, end - i,
                               static_cast<float>(first.x), static_cast<float>(first.y),
                               colors_ + 4 * std::int64_t{stroke->layer}, toward()},
                              stroke_planes_);
            i = end;
        }
        lay_dots(part(laid, dots), target, first);
        if (drawing_.one_color) draw_dots(tile, target, first);
    }

    [[nodiscard]] std::span<const std::uint32_t> part(std::int64_t begin, std::int64_t end) const noexcept {
        return numbers_.span().subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(end - begin));
    }

    // That of a segment; it is none before `from`.
    [[nodiscard]] const Stroke* stroke_of(std::uint32_t segment, const Stroke* from) const noexcept {
        return std::upper_bound(from, drawing_.strokes.end(), std::int64_t{segment},
                                [](std::int64_t at, const Stroke& s) { return at < s.first; }) -
               1;
    }

    // Where column 0 of the image's row y is, or would be, in a plane of the tile.
    [[nodiscard]] static std::int64_t row_begin(const glm::ivec2& first, std::int32_t y) noexcept {
        return std::int64_t{y - first.y} * stride - first.x;
    }
    [[nodiscard]] glm::vec4 in_light(const glm::vec4& color) const noexcept {
        return settings_.linear_light ? to_linear(color) : color;
    }
    [[nodiscard]] DiscTile prepare(const Rect& rect, const glm::ivec2& first) const noexcept {
        DiscTile tile{side, side, stride, scratch_, {}, nullptr};
        std::fill_n(scratch_ + transmittance * plane, plane, 1.0F);
        if (!drawing_.one_color) {
            for (int c = 0; c < 3; ++c) {
                tile.color[c] = scratch_ + (red + c) * plane;
                std::fill_n(tile.color[c], plane, 0.0F);
            }
        }
        if (settings_.host_depth.empty()) return tile;
        tile.host = scratch_ + host * plane;
        for (std::int32_t y = rect.top; y < rect.bottom; ++y) {
            float* const row = scratch_ + host * plane + row_begin(first, y);
            for (std::int32_t x = rect.left; x < rect.right; ++x)
                row[x] = toward() * static_cast<float>(settings_.host_depth.get(std::int64_t{y} * image_.width + x, 0));
        }
        return tile;
    }

    void store_row(const Rect& rect, const glm::ivec2& first, std::int32_t y) const noexcept {
        const std::int64_t at = row_begin(first, y);
        if (!simple_) {
            for (std::int32_t x = rect.left; x < rect.right; ++x) store_one(image_.pixel(x, y), at + x);
            return;
        }
        std::array<std::uint32_t, stride> pixels;
        loops_.store(row_colors(), scratch_ + at + rect.left, rect.right - rect.left, pixels.data());
        std::memcpy(image_.pixel(rect.left, y), pixels.data(),
                    std::size_t{4} * static_cast<std::size_t>(rect.right - rect.left));
    }

    [[nodiscard]] RowColors row_colors() const noexcept {
        RowColors colors{};
        glm::vec4 ink = one_ink();
        glm::vec4 paper = paper_;
        if (is_bgra(image_.format)) {
            std::swap(ink.x, ink.z);
            std::swap(paper.x, paper.z);
        }
        for (int c = 0; c < 4; ++c) {
            colors.paper[c] = paper[c];
            colors.ink[c] = ink[c];
        }
        colors.straight = !is_premultiplied(image_.format);
        return colors;
    }

    // The colour of all inks, opaque: their alpha is in what they leave of the paper.
    [[nodiscard]] glm::vec4 one_ink() const noexcept { return in_light({glm::vec3(drawing_.ink_color), 1.0F}); }

    void store_one(std::byte* pixel, std::int64_t at) const noexcept {
        const float left = scratch_[at];
        glm::vec4 color = paper_ * left;
        if (drawing_.one_color)
            color += one_ink() * (1.0F - left);
        else
            color += glm::vec4(scratch_[red * plane + at], scratch_[green * plane + at], scratch_[blue * plane + at],
                               1.0F - left);
        if (settings_.over) color += in_light(load_pixel(pixel, image_.format)) * (1.0F - color.w);
        store_pixel(pixel, settings_.linear_light ? from_linear(color) : color, image_.format);
    }

    // What is nearest at a pixel's centre: a layer, or ink, which lies a little nearer than its layer.
    struct Nearest {
        float depth; // eye units
        float window;
        std::uint32_t id;
        drawing::MarkClass mark_class;
    };

    void store_outputs(std::int64_t tile, const Rect& rect) const {
        std::array<Nearest, side> row;
        for (std::int32_t y = rect.top; y < rect.bottom; ++y) {
            row.fill(
                {std::numeric_limits<float>::infinity(), drawing::far_depth(convention_), 0, drawing::MarkClass::none});
            // reaches(dx, dy, what) may tell what is at that place.
            const auto note = [&](float cx, float cy, float radius, Nearest what, auto&& reaches) {
                const float dy = static_cast<float>(y) + 0.5F - cy;
                if (!(dy * dy <= radius * radius)) return;
                const auto last = static_cast<float>(rect.right - 1);
                const auto from =
                    static_cast<std::int32_t>(std::clamp(cx - radius, static_cast<float>(rect.left), last));
                const auto to = static_cast<std::int32_t>(std::clamp(cx + radius, static_cast<float>(rect.left), last));
                for (std::int32_t x = from; x <= to; ++x) {
                    const float dx = static_cast<float>(x) + 0.5F - cx;
                    Nearest& nearest = row[static_cast<std::size_t>(x - rect.left)];
                    if (reaches(dx, dy, what) && what.depth < nearest.depth && !behind_host(what.window, x, y))
                        nearest = what;
                }
            };
            note_splats(tile, note);
            note_inks(tile, note);
            note_strokes(tile, note);
            store_output_row(rect, y, row);
        }
    }

    template <class Note>
    void note_splats(std::int64_t tile, const Note& note) const {
        if (!drawing_.has_splats) return;
        drawing_.splat_tiles.for_tile(tile, [&](std::uint32_t i) {
            const Splat& c = drawing_.splats[i];
            const drawing::MarkClass side_of = c.faces_back ? drawing::MarkClass::back : drawing::MarkClass::front;
            note(c.x, c.y, c.radius, {c.depth, c.window, c.id, side_of}, [&](float dx, float dy, Nearest&) {
                const float fall = (dx * c.slope_x + dy * c.slope_y) * c.pixels_per_unit;
                return dx * dx + dy * dy + fall * fall <= c.radius * c.radius;
            });
        });
    }

    template <class Note>
    void note_inks(std::int64_t tile, const Note& note) const {
        drawing_.dot_tiles.for_tile(tile, [&](std::uint32_t i) {
            const Dot& ink = drawing_.dots[i];
            if (!(ink.opacity > 0.0F)) return;
            const float radius = std::max(ink.radius, drawing::smallest_radius);
            note(ink.x, ink.y, radius,
                 {ink.depth - 2.0F * radius / ink.pixels_per_unit, ink.window, ink.id, ink.mark_class},
                 [&](float dx, float dy, Nearest&) { return dx * dx + dy * dy <= radius * radius; });
        });
    }

    // Pixels whose centre a segment covers: its depth there, and the id of the nearer end.
    template <class Note>
    void note_strokes(std::int64_t tile, const Note& note) const {
        if (drawing_.strokes.empty()) return;
        drawing_.segment_tiles.for_tile(tile, [&](std::uint32_t i) {
            const Stroke& stroke = *stroke_of(i, drawing_.strokes.begin());
            const StrokePoint& a = drawing_.points[i];
            const StrokePoint& b = drawing_.points[std::int64_t{i} + 1];
            const drawing::SegmentEnds ends = drawing::ends_of(stroke, i);
            const drawing::Footprint print = drawing::footprint(ends, a, b);
            const drawing::MarkClass mark_class = drawing_.layers[stroke.layer].mark_class;
            note(print.x, print.y, print.radius, {0.0F, 0.0F, 0, mark_class}, [&](float dx, float dy, Nearest& what) {
                float at = 0.0F;
                if (!drawing::covers(ends, a, b, print.x + dx, print.y + dy, at)) return false;
                const float radius = std::max(glm::mix(a.radius, b.radius, at), drawing::smallest_radius);
                what.id = at > 0.5F ? b.id : a.id;
                what.window = glm::mix(a.window, b.window, at);
                what.depth =
                    glm::mix(a.depth, b.depth, at) - 2.0F * radius / glm::mix(a.pixels_per_unit, b.pixels_per_unit, at);
                return true;
            });
        });
    }

    void store_output_row(const Rect& rect, std::int32_t y, const std::array<Nearest, side>& row) const noexcept {
        for (std::int32_t x = rect.left; x < rect.right; ++x) {
            const Nearest& nearest = row[static_cast<std::size_t>(x - rect.left)];
            const std::int64_t element = std::int64_t{y} * image_.width + x;
            if (settings_.depth) settings_.depth.set(element, 0, static_cast<double>(nearest.window));
            if (settings_.id) settings_.id.set(element, 0, static_cast<double>(nearest.id));
            if (settings_.mark_class) settings_.mark_class.set(element, 0, static_cast<double>(nearest.mark_class));
        }
    }

    [[nodiscard]] bool behind_host(float window, std::int32_t x, std::int32_t y) const noexcept {
        if (settings_.host_depth.empty()) return false;
        const auto own = static_cast<float>(settings_.host_depth.get(std::int64_t{y} * image_.width + x, 0));
        return drawing::nearer(own, window, convention_);
    }

    const Drawing& drawing_;
    drawing::DepthConvention convention_;
    const Image& image_;
    const DrawSettings& settings_;
    const DiscLoops& loops_;
    const StrokeLoops& stroke_loops_;
    float* scratch_;
    StrokePlanes stroke_planes_;
    base::Array<std::uint32_t>& numbers_; // a tile's dots, then its segments
    const float* colors_;                 // as in InkList
    Rect drawn_;
    bool coverage_;   // only how much ink there is counts
    glm::vec4 paper_; // premultiplied, in the light that is blended in
    bool outputs_, simple_;
};

} // namespace

void TransmittanceRaster::draw(const Drawing& drawing, const Image& image, const DrawSettings& settings) {
    const Rect drawn = drawn_rect(drawing.window.viewport, image);
    if (drawn.empty()) return;
    colors_.clear();
    for (const drawing::Layer& layer : drawing.layers) {
        const glm::vec4 opaque(glm::vec3(layer.ink), 1.0F);
        const glm::vec4 light = settings.linear_light ? to_linear(opaque) : opaque;
        for (const float value : {light.x, light.y, light.z, layer.ink.w}) colors_.push_back(value);
    }
    const std::int64_t workers = std::max(1, runtime_.parallel.threads());
    base::resize_scratch(planes_, workers * planes * plane);
    while (numbers_.size() < workers) numbers_.add(runtime_.memory);
    while (!drawing.strokes.empty() && unions_.size() < workers) unions_.add(runtime_.memory);
    if (!drawing.strokes.empty()) { // for all of them: which of them draws the fullest tile is by chance
        const std::int64_t most = drawing.dot_tiles.most_of_a_tile() + drawing.segment_tiles.most_of_a_tile();
        for (std::int64_t worker = 0; worker < workers; ++worker) numbers_[worker].of_tile.reserve(most);
    }
    std::atomic<std::int64_t> next{0};
    runtime_.parallel.for_each(workers, [&](std::int64_t worker) {
        float* const own = planes_.data() + worker * planes * plane;
        StrokePlanes strokes{own + cover * plane, own + ink * plane, nullptr};
        if (!drawing.strokes.empty()) {
            strokes.overlaps = &unions_[worker];
            std::fill_n(strokes.cover, plane, 0.0F);
            std::fill_n(strokes.ink, plane, 0.0F);
        }
        TransmittancePainter paint(drawing, image, settings, loops_, stroke_loops_,
                                   {own, strokes, numbers_[worker].of_tile}, colors_.data(), drawn);
        for (std::int64_t tile = next++; tile < drawing.dot_tiles.tiles(); tile = next++) paint(tile);
    });
}

} // namespace hrbfnpr::output
