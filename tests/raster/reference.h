// SPDX-License-Identifier: MIT
// Draws as a host draws the vertices, in the plainest way: every disc over every pixel that it may touch, in order.
#pragma once

#include "raster/picture.h"

namespace hrbfnpr::testing {

struct ReferenceDisc {
    float x, y, radius;
    glm::vec4 color; // straight
    bool is_paper;
};

// Returns straight RGBA, row by row. The paper is straight, too.
inline std::vector<glm::dvec4> draw_plainly(const std::vector<ReferenceDisc>& discs, int width, int height,
                                            const glm::vec4& paper) {
    const glm::dvec4 clear(glm::dvec3(paper) * static_cast<double>(paper.w), static_cast<double>(paper.w));
    std::vector<glm::dvec4> pixels(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), clear);
    for (const ReferenceDisc& s : discs) {
        const double radius = std::max(0.5, static_cast<double>(s.radius));
        const double dimmed = static_cast<double>(s.radius) / radius;
        const auto edge = [](double at, int limit) {
            return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(limit)));
        };
        const auto sx = static_cast<double>(s.x);
        const auto sy = static_cast<double>(s.y);
        for (int y = edge(sy - radius - 1.0, height); y < edge(sy + radius + 2.0, height); ++y) {
            for (int x = edge(sx - radius - 1.0, width); x < edge(sx + radius + 2.0, width); ++x) {
                const double distance = std::hypot(x + 0.5 - sx, y + 0.5 - sy);
                const double coverage = std::clamp(radius + 0.5 - distance, 0.0, 1.0);
                const double alpha = static_cast<double>(s.color.w) * coverage * dimmed * dimmed;
                glm::dvec4& pixel =
                    pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
                // Over opaque paper both cases are the same "source over".
                const glm::dvec4 source = s.is_paper ? clear : glm::dvec4(glm::dvec3(s.color), 1.0);
                pixel = pixel * (1.0 - alpha) + source * alpha;
            }
        }
    }
    for (glm::dvec4& pixel : pixels) {
        pixel = pixel.w > 0.0 ? glm::dvec4(glm::dvec3(pixel) / pixel.w, pixel.w) : glm::dvec4(0.0);
    }
    return pixels;
}

// Returns the largest difference in any channel of a straight RGBA picture, in steps of 1/255. Colours are weighted by
// their alpha.
inline double largest_difference(const Picture& picture, const std::vector<glm::dvec4>& expected) {
    double largest = 0.0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            const glm::dvec4& e = expected[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                           static_cast<std::size_t>(x)];
            for (int c = 0; c < 4; ++c) {
                const double weight = c < 3 ? e.w : 1.0;
                largest = std::max(largest, weight * std::abs(picture.at(x, y, c) - 255.0 * e[c]));
            }
        }
    }
    return largest;
}

inline std::vector<ReferenceDisc> reference_discs(std::span<const Disc> discs) {
    std::vector<ReferenceDisc> result;
    for (const Disc& disc : discs) result.push_back({disc.x, disc.y, disc.radius, disc.color, disc.is_paper});
    return result;
}

// World units are pixels: (x, y) from the top-left corner of an image of width * height.
inline frame::Camera pixel_camera(int width, int height) {
    frame::Camera camera = front_camera(width, height, 0.5 * height);
    camera.view = frame::look_at({0.5 * width, -0.5 * height, 10.0}, {0.5 * width, -0.5 * height, 0.0}, {0, 1, 0});
    return camera;
}

inline void add_pixel_mark(marks::PointSet& set, double x, double y, double depth = 0.0) {
    add_stipple(set, {x, -y, -depth}, {0.0, 0.0, 1.0});
}

} // namespace hrbfnpr::testing
