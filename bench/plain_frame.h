// SPDX-License-Identifier: MIT
// A frame in the simplest way: one thread, double precision, a sort and a loop over pixels.
#pragma once

#include "orbit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace bench {

class PlainFrame {
public:
    // `with_paper`: marks also paint paper, which attenuates the marks that they hide [NPAR 6.1]; otherwise only ink.
    PlainFrame(const hrbfnpr_point_set* set, const Style& style, int width, int height, bool with_paper)
        : style_(style), with_paper_(with_paper), width_(width), height_(height),
          pixels_(std::size_t{4} * static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
        const hrbfnpr_point_set_info info = info_of(set);
        spacing_ = info.spacing;
        for (std::int64_t layer = 0; layer < info.layers; ++layer) {
            std::int64_t count = 0;
            std::int64_t widths = 0;
            const float* position = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
            const float* normal = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count);
            const float* rank = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_RANK, count);
            if (count == 0) continue;
            pens_.push_back(style.of(layer_info(set, layer).kind));
            const float* wide = attribute<float>(set, layer, HRBFNPR_MARK_ATTRIBUTE_WIDTH, widths);
            for (std::int64_t i = 0; i < count; ++i) {
                const glm::dvec3 place = glm::make_vec3(info.origin) + glm::dvec3(glm::make_vec3(position + 3 * i));
                marks_.push_back({place, glm::make_vec3(normal + 3 * i), double{rank[i]},
                                  widths > 0 ? double{wide[i]} : 1.0, pens_.size() - 1});
            }
        }
    }

    void draw(const hrbfnpr_camera& camera) {
        discs_.clear();
        const Lens lens(camera);
        const double pixels_per_unit = camera.projection[5] * camera.viewport[3] / 2.0; // at distance 1
        for (const Mark& mark : marks_) add(mark, lens, pixels_per_unit);
        std::sort(discs_.begin(), discs_.end(), [](const Disc& a, const Disc& b) { return a.depth > b.depth; });
        std::fill(pixels_.begin(), pixels_.end(), std::uint8_t{255});
        for (const Disc& disc : discs_) splat(disc);
    }
    [[nodiscard]] const std::vector<std::uint8_t>& pixels() const { return pixels_; }
    [[nodiscard]] std::size_t discs() const { return discs_.size(); }

private:
    struct Mark {
        glm::dvec3 place, normal;
        double rank, width;
        std::size_t pen;
    };
    struct Disc {
        double depth, x, y, radius, alpha;
        float value; // 0 or 255: ink is black and paper white
    };

    void add(const Mark& mark, const Lens& lens, double pixels_per_unit) {
        const glm::dvec3 eye(lens.view * glm::dvec4(mark.place, 1.0));
        const glm::dvec2 at = lens.image_of(mark.place);
        if (eye.z >= 0.0 || !lens.holds(at, -4.0)) return;
        const glm::dvec3 normal = glm::dmat3(lens.view) * mark.normal;
        const double nu = glm::dot(normal, glm::normalize(eye));
        const double scale = pixels_per_unit / -eye.z; // pixels per unit
        const double cover = std::max(1.0, 1.5 * spacing_ * scale);
        const hrbfnpr_layer_style& pen = pens_[mark.pen];
        if (nu >= 0.0) {
            const double alpha = nu > 0.05 ? 0.2 * (std::log(nu - 0.05) + 5.0) * style_.attenuation_back : 0.0;
            paper(eye, at, cover + double{style_.halo_width}, alpha, scale);
        } else {
            paper(eye, at, cover, nu * nu * style_.attenuation_front, scale);
            const double lit = glm::dot(normal, light_);
            const double tau = lit > 0.0 ? std::pow(lit, style_.tone_exponent) : double{style_.fill_light} * lit * lit;
            if (pen.shown != 0 && mark.rank >= 1.0 - (1.0 - tau) * double{pen.share})
                discs_.push_back({-eye.z, at.x, at.y, double{pen.radius} * mark.width, 1.0, 0.0F});
        }
    }
    // The paper is placed behind the ink of the same surface.
    void paper(const glm::dvec3& eye, const glm::dvec2& at, double radius, double alpha, double scale) {
        if (with_paper_)
            discs_.push_back({-eye.z + radius / scale, at.x, at.y, radius, std::clamp(alpha, 0.0, 1.0), 255.0F});
    }

    void splat(const Disc& disc) {
        const double reach = disc.radius + 0.5;
        const int left = std::max(0, static_cast<int>(std::ceil(disc.x - reach - 0.5)));
        const int right = std::min(width_ - 1, static_cast<int>(std::floor(disc.x + reach - 0.5)));
        const int top = std::max(0, static_cast<int>(std::ceil(disc.y - reach - 0.5)));
        const int bottom = std::min(height_ - 1, static_cast<int>(std::floor(disc.y + reach - 0.5)));
        for (int y = top; y <= bottom; ++y)
            for (int x = left; x <= right; ++x) {
                const double distance = std::hypot(x + 0.5 - disc.x, y + 0.5 - disc.y);
                const double alpha = disc.alpha * std::clamp(reach - distance, 0.0, 1.0);
                std::uint8_t* pixel =
                    pixels_.data() +
                    4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x));
                for (int c = 0; c < 3; ++c)
                    pixel[c] = static_cast<std::uint8_t>(pixel[c] + (double{disc.value} - pixel[c]) * alpha + 0.5);
            }
    }

    hrbfnpr_style style_;
    std::vector<hrbfnpr_layer_style> pens_; // for the layers that have marks
    bool with_paper_;
    int width_, height_;
    double spacing_ = 0.0;
    glm::dvec3 light_ = glm::normalize(glm::make_vec3(style_.light)); // fixed to the camera
    std::vector<Mark> marks_;
    std::vector<Disc> discs_;
    std::vector<std::uint8_t> pixels_;
};

} // namespace bench
