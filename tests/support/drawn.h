// SPDX-License-Identifier: MIT
// Drawings in the form that tests of frames need: discs from far to near, and styles for three kinds of layers.
#pragma once

#include "drawing/drawing.h"
#include "frame/frame.h"

#include <algorithm>
#include <array>
#include <deque>
#include <span>
#include <utility>
#include <vector>

namespace hrbfnpr::testing {

struct KindStyle {
    bool shown = true;
    std::uint32_t sets = 3;
    float share = 1.0F;
    float radius = 1.0F;
    float radius_zoom = 0.0F;
    glm::vec4 ink{0.0F, 0.0F, 0.0F, 1.0F};
};

// Styles for layers of stipples, of hatching and of own marks. Bit (1 << k) of contour_kinds is set if layers of the
// k-th kind have contours.
struct Style : frame::Style {
    std::array<KindStyle, 3> kind;
    std::uint32_t contour_kinds = 7;
};

// Converts the style to layers, which live as long as the program.
inline frame::Style kept(const Style& style) {
    static std::deque<std::array<frame::LayerStyle, 3>> all;
    constexpr std::array kinds{marks::Kind::stipples, marks::Kind::hatch, marks::Kind::own};
    std::array<frame::LayerStyle, 3>& layers = all.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
        const KindStyle& one = style.kind[k];
        frame::LayerStyle& layer = layers[k];
        layer.kind = kinds[k];
        layer.shown = one.shown;
        layer.contours = (style.contour_kinds >> k & 1U) != 0;
        layer.directions = one.sets;
        layer.share = one.share;
        layer.radius = one.radius;
        layer.radius_zoom = one.radius_zoom;
        for (int c = 0; c < 4; ++c) layer.ink[c] = one.ink[c];
    }
    frame::Style result = style;
    result.layers = layers;
    return result;
}

// A dot in the form that a host gets.
struct Disc {
    float x, y, radius;
    float depth; // in the camera's convention
    std::uint32_t id;
    drawing::MarkClass mark_class;
    bool is_paper;
    glm::vec4 color; // straight RGBA
};

// A frame and its last drawing.
class DrawnFrame {
public:
    explicit DrawnFrame(const base::Runtime& runtime) : frame_(runtime), drawing_(runtime.memory) {}

    // After a failure no drawing is available.
    void draw(std::span<const frame::Item> items, const frame::Camera& camera) {
        drawn_ = false;
        listed_ = false;
        frame_.draw(items, camera, base::Progress(), drawing_);
        drawn_ = true;
    }
    [[nodiscard]] bool drawn() const noexcept { return drawn_; }
    [[nodiscard]] const drawing::Drawing& drawing() const noexcept { return drawing_; }
    [[nodiscard]] const drawing::Counts& info() const noexcept { return drawing_.counts; }
    [[nodiscard]] drawing::MarkSource source(const Disc& disc) const noexcept { return drawing_.source(disc.id); }

    // Returns the discs from far to near, the order of painting. Inlined, GCC would warn about arrays that it takes for
    // empty.
    [[nodiscard, gnu::noinline]] std::span<const Disc> discs() const {
        if (!listed_) list();
        listed_ = true;
        return discs_;
    }

private:
    [[gnu::noinline]] void list() const {
        discs_.clear();
        if (!drawn_) return;
        if (drawing_.painting == drawing::Painting::published) {
            for (const drawing::Dot& dot : drawing_.dots) discs_.push_back(disc_of(dot));
            return;
        }
        keys_.clear();
        for (const drawing::IndexRange& piece : drawing_.dot_ranges) {
            for (std::int64_t i = piece.begin; i < piece.end; ++i) {
                const drawing::Dot& dot = drawing_.dots[i];
                if (dot.opacity > 0.0F)
                    keys_.emplace_back(drawing::far_first_key(dot.depth, 0), static_cast<std::uint32_t>(i));
            }
        }
        std::stable_sort(keys_.begin(), keys_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        for (const auto& [key, i] : keys_) discs_.push_back(disc_of(drawing_.dots[i]));
    }

    [[nodiscard, gnu::noinline]] Disc disc_of(const drawing::Dot& dot) const noexcept {
        const bool is_paper = (dot.flags & drawing::dot_is_paper) != 0;
        glm::vec4 color = is_paper ? drawing_.paper : drawing_.layers[dot.layer].ink;
        color.w = is_paper ? dot.opacity : color.w * dot.opacity;
        return {dot.x, dot.y, dot.radius, dot.window, dot.id, dot.mark_class, is_paper, color};
    }

    frame::Frame frame_;
    drawing::Drawing drawing_;
    bool drawn_ = false;
    mutable bool listed_ = false;
    mutable std::vector<Disc> discs_;
    mutable std::vector<std::pair<std::uint64_t, std::uint32_t>> keys_;
};

} // namespace hrbfnpr::testing
