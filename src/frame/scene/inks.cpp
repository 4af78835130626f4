// SPDX-License-Identifier: MIT
#include "frame/scene/inks.h"

#include "drawing/color.h"
#include "frame/scene/tuning.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace hrbfnpr::frame {
namespace {

[[nodiscard]] glm::vec3 linear_of(const glm::vec3& encoded) noexcept {
    const glm::vec3 c = glm::clamp(encoded, 0.0F, 1.0F);
    return {drawing::to_linear(c.x), drawing::to_linear(c.y), drawing::to_linear(c.z)};
}

[[nodiscard]] float squared(const glm::vec3& v) noexcept { return glm::dot(v, v); }

// Returns the shares of red, green and blue in a colour. They tell its hue and saturation. Black counts as grey.
[[nodiscard]] glm::vec3 chromaticity_of(const glm::vec3& c) noexcept {
    constexpr float black = 3e-4F; // The smallest step of a colour of 8 bits.
    return (c + black) / (c.x + c.y + c.z + 3.0F * black);
}

// Returns a number from 0 to 1. Those of consecutive indices are spread evenly, however many there are.
// [the golden ratio: Knuth, "The Art of Computer Programming" 3, section 6.4]
[[nodiscard]] float evenly_spread(std::int64_t index) noexcept {
    const std::uint32_t bits = static_cast<std::uint32_t>(index) * 2654435769U;
    return static_cast<float>(bits >> 8U) * 0x1p-24F;
}

} // namespace

InkChoice::InkChoice(const marks::Layer& layer, const marks::MarkField& colors, std::span<const glm::vec4> palette,
                     PaletteRule rule) noexcept
    : layer_(&layer), colors_(&colors), rule_(rule), count_(static_cast<std::int32_t>(palette.size())) {
    HRBFNPR_ASSERT(!palette.empty() && palette.size() <= most_inks && colors.kind == marks::FieldKind::colour);
    for (std::size_t i = 0; i < palette.size(); ++i) {
        linear_[i] = linear_of(glm::vec3(palette[i]));
        lab_[i] = drawing::oklab_of(linear_[i]);
    }
    if (rule == PaletteRule::mixed) add_mixtures();
}

// The foot of the perpendicular from black to the line or plane of the means gives `level`.
void InkChoice::add_mixture(const std::array<std::uint8_t, 3>& ink, const glm::vec3& first,
                            const glm::vec3& second) noexcept {
    const glm::vec3& a = linear_[ink[0]];
    const glm::vec3 foot = a - glm::dot(first, a) * (linear_[ink[1]] - a) - glm::dot(second, a) * (linear_[ink[2]] - a);
    const float square = squared(foot);
    mixture_[static_cast<std::size_t>(mixtures_++)] = {ink, first, second,
                                                       square > 1e-6F ? foot / square : glm::vec3(0.0F)};
}

void InkChoice::add_mixtures() noexcept {
    const auto number = [](std::int32_t ink) { return static_cast<std::uint8_t>(ink); };
    const auto at = [&](std::int32_t ink) { return linear_[static_cast<std::size_t>(ink)]; };
    const glm::vec3 none(0.0F);
    for (std::int32_t a = 0; a < count_; ++a) {
        add_mixture({number(a), 0, 0}, none, none);
        for (std::int32_t b = a + 1; b < count_; ++b) {
            const glm::vec3 side = at(b) - at(a);
            const float square = squared(side);
            if (!(square > 0.0F)) continue;
            add_mixture({number(a), number(b), 0}, side / square, none);
            for (std::int32_t c = b + 1; c < count_; ++c) {
                const glm::vec3 other = at(c) - at(a);
                const float both = glm::dot(side, other);
                const float area = square * squared(other) - both * both;
                if (!(area > 1e-9F)) continue; // The three colours are in a line.
                add_mixture({number(a), number(b), number(c)}, (squared(other) * side - both * other) / area,
                            (square * other - both * side) / area);
            }
        }
    }
}

std::uint8_t InkChoice::nearest(const glm::vec3& color) const noexcept {
    const glm::vec3 lab = drawing::oklab_of(linear_of(color));
    std::int32_t best = 0;
    float least = std::numeric_limits<float>::infinity();
    for (std::int32_t i = 0; i < count_; ++i) {
        const float distance = squared(lab_[static_cast<std::size_t>(i)] - lab);
        if (!(distance < least)) continue;
        least = distance;
        best = i;
    }
    return static_cast<std::uint8_t>(1 + best);
}

std::uint8_t InkChoice::mixed(const glm::vec3& color, float threshold) const noexcept {
    HRBFNPR_ASSERT(mixtures_ > 0 && threshold >= 0.0F && threshold < 1.0F);
    const glm::vec3 wanted = linear_of(color);
    const glm::vec3 chromaticity = chromaticity_of(wanted);
    const Mixture* best = nullptr;
    float least = std::numeric_limits<float>::infinity();
    float of_second = 0.0F, of_third = 0.0F;
    for (std::int32_t k = 0; k < mixtures_; ++k) {
        const Mixture& mixture = mixture_[static_cast<std::size_t>(k)];
        const glm::vec3& a = linear_[mixture.ink[0]];
        const glm::vec3& b = linear_[mixture.ink[1]];
        const glm::vec3& c = linear_[mixture.ink[2]];
        // The colour becomes as light as the inks. The tone of the marks makes it lighter or darker.
        const float along = glm::dot(mixture.level, wanted);
        const glm::vec3 off = (along > 0.0F ? wanted / along : wanted) - a;
        const float second = glm::dot(mixture.first, off);
        const float third = glm::dot(mixture.second, off);
        if (!(second >= 0.0F && third >= 0.0F && second + third <= 1.0F)) continue;
        const float first = 1.0F - second - third;
        const glm::vec3 mean = first * a + second * b + third * c;
        // If several mixtures have nearly the same mean, the one of similar inks has the least grain.
        const float grain = first * squared(a - mean) + second * squared(b - mean) + third * squared(c - mean);
        const float cost = squared(chromaticity_of(mean) - chromaticity) +
                           scene_tuning.lightness_cost * squared(mean - wanted) + scene_tuning.grain_cost * grain;
        if (!(cost < least)) continue;
        least = cost;
        best = &mixture;
        of_second = second;
        of_third = third;
    }
    HRBFNPR_ASSERT(best != nullptr);
    const std::size_t which = threshold < of_third ? 2U : threshold < of_third + of_second ? 1U : 0U;
    return static_cast<std::uint8_t>(1 + best->ink[which]);
}

std::uint8_t InkChoice::of_mark(std::int64_t mark, std::int64_t place) const noexcept {
    if (!colors_->weight.empty() && colors_->weight[mark] < 0.5F) return 0;
    const glm::vec3 color = marks::vector_at(colors_->value, mark);
    if (rule_ == PaletteRule::nearest) return nearest(color);
    const bool has_strokes = layer_->has_strokes();
    return mixed(color, evenly_spread(has_strokes ? std::int64_t{layer_->stroke[2 * mark] >> 1U} : place));
}

void settle_inks(std::span<const drawing::StrokePoint> points, std::span<std::uint8_t> inks) noexcept {
    HRBFNPR_ASSERT(points.size() == inks.size());
    const std::size_t count = points.size();
    for (std::size_t begin = 0; begin < count;) {
        std::size_t end = begin + 1;
        while (end < count && inks[end] == inks[begin]) ++end;
        float widest = 0.0F;
        for (std::size_t i = begin; i < end; ++i) widest = std::max(widest, 2.0F * points[i].radius);
        const float length = points[std::min(end, count - 1)].length - points[begin].length;
        const bool is_whole = begin == 0 && end == count;
        if (!is_whole && (begin + 1 == count || length < scene_tuning.shortest_in_ink * widest)) {
            std::fill(inks.begin() + static_cast<std::ptrdiff_t>(begin),
                      inks.begin() + static_cast<std::ptrdiff_t>(end), begin > 0 ? inks[begin - 1] : inks[end]);
            if (begin == 0) continue; // The part has grown, and may still be too short.
        }
        begin = end;
    }
}

} // namespace hrbfnpr::frame
