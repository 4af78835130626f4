#include "output/raster/layer_raster.h"

#include "output/raster/pixels.h"
#include "output/raster/rects.h"
#include "output/raster/srgb.h"

#include <atomic>
#include <cmath>
#include <cstring>

namespace hrbfnpr::output {
namespace {

using frame::Ink;
using frame::LayerFrame;
using frame::Splat;

constexpr std::int32_t side = frame::DepthLayers::tile_size;
constexpr std::int32_t stride = side + 16; // vectors may run over a row's end
constexpr std::int64_t plane = std::int64_t{stride} * side;
enum Plane : std::int64_t { transmittance, red, green, blue, host, planes };

// Everything that a tile's task reads.
class Painter {
public:
    Painter(const frame::Frame& frame, const LayerFrame& layers, const Image& image, const DrawSettings& settings,
            const DiscLoops& loops, float* scratch, const float* colors, const Rect& drawn) noexcept
        : layers_(layers), convention_(frame.camera().depth), image_(image), settings_(settings), loops_(loops),
          scratch_(scratch), colors_(colors), drawn_(drawn), paper_(in_light(premultiplied(frame.paper()))),
          outputs_(settings.depth || settings.id || settings.mark_class),
          // One colour, and nothing but the drawing: a pixel is a function of what is left of the paper.
          simple_(layers.one_color() && !settings.over && !settings.linear_light) {}

    void operator()(std::int64_t tile) const {
        const drawing::Tiles& bins = layers_.ink_bins();
        const glm::ivec2 first = layers_.first_pixel() + glm::ivec2(static_cast<int>(tile % bins.columns()) * side,
                                                                    static_cast<int>(tile / bins.columns()) * side);
        const Rect rect = {std::max(first.x, drawn_.left), std::max(first.y, drawn_.top),
                           std::min(first.x + side, drawn_.right), std::min(first.y + side, drawn_.bottom)};
        if (rect.empty()) return;
        const DiscTile target = prepare(rect, first);
        const bool one = layers_.one_color();
        const float toward = convention_ == frame::DepthConvention::reversed ? -1.0F : 1.0F;
        bins.for_spans(
            tile,
            [&](std::span<const std::uint32_t> numbers) {
                loops_.draw(target, {layers_.inks().data(), numbers.data(), static_cast<std::int64_t>(numbers.size()),
                                     static_cast<float>(first.x), static_cast<float>(first.y), colors_,
                                     layers_.ink_color().w, toward});
            },
            [&](std::uint32_t a, std::uint32_t b) { return one ? a < b : layers_.before(a, b); });
        for (std::int32_t y = rect.top; y < rect.bottom; ++y) store_row(rect, first, y);
        if (outputs_) store_outputs(tile, rect);
    }

private:
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
        if (!layers_.one_color()) {
            for (int c = 0; c < 3; ++c) {
                tile.color[c] = scratch_ + (red + c) * plane;
                std::fill_n(tile.color[c], plane, 0.0F);
            }
        }
        if (settings_.host_depth.empty()) return tile;
        tile.host = scratch_ + host * plane;
        const float toward = convention_ == frame::DepthConvention::reversed ? -1.0F : 1.0F;
        for (std::int32_t y = rect.top; y < rect.bottom; ++y) {
            float* const row = scratch_ + host * plane + row_begin(first, y);
            for (std::int32_t x = rect.left; x < rect.right; ++x)
                row[x] = toward * static_cast<float>(settings_.host_depth.get(std::int64_t{y} * image_.width + x, 0));
        }
        return tile;
    }

    void store_row(const Rect& rect, const glm::ivec2& first, std::int32_t y) const noexcept {
        std::byte* const row = image_.pixels + y * image_.row_stride;
        const std::int64_t at = row_begin(first, y);
        if (!simple_) {
            for (std::int32_t x = rect.left; x < rect.right; ++x) store_one(row + std::int64_t{4} * x, at + x);
            return;
        }
        std::array<std::uint32_t, stride> pixels;
        loops_.store(row_colors(), scratch_ + at + rect.left, rect.right - rect.left, pixels.data());
        std::memcpy(row + std::int64_t{4} * rect.left, pixels.data(),
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
    [[nodiscard]] glm::vec4 one_ink() const noexcept { return in_light({glm::vec3(layers_.ink_color()), 1.0F}); }

    void store_one(std::byte* pixel, std::int64_t at) const noexcept {
        const float left = scratch_[at];
        glm::vec4 color = paper_ * left;
        if (layers_.one_color())
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
        frame::MarkClass mark_class;
    };

    void store_outputs(std::int64_t tile, const Rect& rect) const {
        std::array<Nearest, side> row;
        for (std::int32_t y = rect.top; y < rect.bottom; ++y) {
            row.fill(
                {std::numeric_limits<float>::infinity(), frame::far_depth(convention_), 0, frame::MarkClass::none});
            const auto note = [&](float cx, float cy, float radius, const Nearest& what, auto&& reaches) {
                const float dy = static_cast<float>(y) + 0.5F - cy;
                if (!(dy * dy <= radius * radius)) return;
                const auto last = static_cast<float>(rect.right - 1);
                const auto from =
                    static_cast<std::int32_t>(std::clamp(cx - radius, static_cast<float>(rect.left), last));
                const auto to = static_cast<std::int32_t>(std::clamp(cx + radius, static_cast<float>(rect.left), last));
                for (std::int32_t x = from; x <= to; ++x) {
                    const float dx = static_cast<float>(x) + 0.5F - cx;
                    Nearest& nearest = row[static_cast<std::size_t>(x - rect.left)];
                    if (what.depth < nearest.depth && reaches(dx, dy) && !behind_host(what.window, x, y))
                        nearest = what;
                }
            };
            note_splats(tile, note);
            note_inks(tile, note);
            store_output_row(rect, y, row);
        }
    }

    template <class Note>
    void note_splats(std::int64_t tile, const Note& note) const {
        if (!layers_.has_layers()) return;
        const Splat* const splats = layers_.splats().data();
        layers_.splat_bins().for_tile(tile, [&](std::uint32_t i) {
            const Splat& c = splats[i];
            const frame::MarkClass side_of = c.faces_back ? frame::MarkClass::back : frame::MarkClass::front;
            note(c.x, c.y, c.radius, {c.depth, c.window, c.id, side_of}, [&](float dx, float dy) {
                const float fall = (dx * c.slope_x + dy * c.slope_y) * c.pixels_per_unit;
                return dx * dx + dy * dy + fall * fall <= c.radius * c.radius;
            });
        });
    }

    template <class Note>
    void note_inks(std::int64_t tile, const Note& note) const {
        const Ink* const inks = layers_.inks().data();
        layers_.ink_bins().for_tile(tile, [&](std::uint32_t i) {
            const Ink& ink = inks[i];
            if (!(ink.alpha > 0.0F)) return;
            const float radius = std::max(ink.radius, frame::smallest_radius);
            note(ink.x, ink.y, radius,
                 {ink.depth - 2.0F * radius / ink.pixels_per_unit, ink.window, ink.id, ink.mark_class},
                 [&](float dx, float dy) { return dx * dx + dy * dy <= radius * radius; });
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
        return frame::nearer(own, window, convention_);
    }

    const LayerFrame& layers_;
    frame::DepthConvention convention_;
    const Image& image_;
    const DrawSettings& settings_;
    const DiscLoops& loops_;
    float* scratch_;
    const float* colors_; // as in InkList
    Rect drawn_;
    glm::vec4 paper_; // premultiplied, in the light that is blended in
    bool outputs_, simple_;
};

} // namespace

void LayerRaster::draw(const frame::Frame& frame, const Image& image, const DrawSettings& settings) {
    const LayerFrame& layers = *frame.layer_frame();
    const Rect drawn = drawn_rect(frame.camera().viewport, image);
    if (drawn.empty()) return;
    colors_.clear();
    for (std::uint32_t color = 0; color < layers.colors(); ++color) {
        const glm::vec4 ink = layers.color(color);
        const glm::vec4 opaque(glm::vec3(ink), 1.0F);
        const glm::vec4 light = settings.linear_light ? to_linear(opaque) : opaque;
        for (const float value : {light.x, light.y, light.z, ink.w}) colors_.push_back(value);
    }
    const std::int64_t lanes = std::max(1, runtime_.parallel.threads());
    base::resize_scratch(planes_, lanes * planes * plane);
    std::atomic<std::int64_t> next{0};
    runtime_.parallel.for_each(lanes, [&](std::int64_t lane) {
        const Painter paint(frame, layers, image, settings, loops_, planes_.data() + lane * planes * plane,
                            colors_.data(), drawn);
        for (std::int64_t tile = next++; tile < layers.ink_bins().tiles(); tile = next++) paint(tile);
    });
}

} // namespace hrbfnpr::output
