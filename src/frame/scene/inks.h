// SPDX-License-Identifier: MIT
// The inks that marks take from the palette of a style, by a field of colours.
//
// InkChoice      a palette, the colours of marks → the number of each mark's ink
// settle_inks    the inks of the points of a stroke → the same without parts too short to draw
// add_in_inks    a stroke, the inks of its points → a stroke for each part of one ink
#pragma once

#include "base/assert.h"
#include "drawing/drawing.h"
#include "frame/scene/style.h"
#include "marks/point_set.h"

#include <array>
#include <cstdint>
#include <span>

namespace hrbfnpr::frame {

// Chooses the inks of a layer's marks. The number 0 is the layer's own ink, and 1 + k is ink k of the palette.
class InkChoice {
public:
    // The layer must outlive this object.
    InkChoice(const marks::Layer& layer, const marks::MarkField& colors, std::span<const glm::vec4> palette,
              PaletteRule rule) noexcept;

    // Returns the number of a mark's ink. `place` is that of the mark in the order of the clusters' blocks. It is not
    // used for marks of strokes, because a stroke has one threshold.
    [[nodiscard]] std::uint8_t of_mark(std::int64_t mark, std::int64_t place) const noexcept;

    // Returns the ink nearest to a colour in Oklab. Colours are sRGB-encoded.
    [[nodiscard]] std::uint8_t nearest(const glm::vec3& color) const noexcept;
    // Returns one of at most three inks. Their mean in linear light has nearly the hue and saturation of the colour,
    // and is as light as the inks allow. Thresholds that are evenly spread from 0 to 1 give each ink its share.
    [[nodiscard]] std::uint8_t mixed(const glm::vec3& color, float threshold) const noexcept;

private:
    // One, two or three inks, which mix to a point, a segment or a triangle of linear colours.
    struct Mixture {
        std::array<std::uint8_t, 3> ink; // numbers in the palette
        glm::vec3 first, second;         // dot products with these give the shares of the second and the third ink
        glm::vec3 level;                 // the dot product with this is 1 for all means; 0: there is no such vector
    };
    static constexpr std::size_t most_mixtures = 8 + 28 + 56;

    void add_mixture(const std::array<std::uint8_t, 3>& ink, const glm::vec3& first, const glm::vec3& second) noexcept;
    void add_mixtures() noexcept;

    const marks::Layer* layer_;
    const marks::MarkField* colors_;
    PaletteRule rule_;
    std::int32_t count_ = 0;
    std::array<glm::vec3, most_inks> linear_{}, lab_{};
    std::int32_t mixtures_ = 0;
    std::array<Mixture, most_mixtures> mixture_{};
};

// Gives parts of a stroke that are too short to be drawn the ink of the part before, or else of the part after.
void settle_inks(std::span<const drawing::StrokePoint> points, std::span<std::uint8_t> inks) noexcept;

// Adds a stroke, cut where its ink changes. The layers of the parts follow `first_layer`. Each part but the last ends
// at the first point of the next part. `inks` must be settled. add(stroke, points) adds a part, whose `first` and
// `count` are not set.
template <class Add>
void add_in_inks(drawing::Stroke stroke, std::uint32_t first_layer, std::span<const drawing::StrokePoint> points,
                 std::span<const std::uint8_t> inks, const Add& add) {
    HRBFNPR_ASSERT(points.size() == inks.size() && points.size() >= 2);
    const drawing::Stroke whole = stroke;
    std::size_t end = 0;
    for (std::size_t begin = 0; begin < points.size(); begin = end) {
        end = begin + 1;
        while (end < points.size() && inks[end] == inks[begin]) ++end;
        const bool is_last = end == points.size();
        stroke.closed = whole.closed && begin == 0 && is_last;
        stroke.cap_begin = begin == 0 ? whole.cap_begin : drawing::Cap::round;
        stroke.cap_end = is_last ? whole.cap_end : drawing::Cap::round;
        stroke.layer = first_layer + inks[begin];
        add(stroke, points.subspan(begin, end - begin + (is_last ? 0 : 1)));
    }
}

} // namespace hrbfnpr::frame
