// SPDX-License-Identifier: MIT
// Checks the visibility of lines by rays from the eye to places on them.
#pragma once

#include "line_calls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace bench {

// A place on a line, and the number of layers that the drawing says hide it.
struct LinePlace {
    glm::dvec2 pixel{0.0};
    glm::dvec3 world{0.0};
    double from_end = 0.0; // pixels to the nearer end of its part, along the part
    double part = 0.0;     // length of its part, pixels
    int layers = 0;
};

// Returns `count` places, evenly along all lines, except places so near to an end of a part that the answer is
// uncertain.
[[nodiscard]] inline std::vector<LinePlace> places_of(const std::vector<Polyline>& lines, const Lens& lens,
                                                      std::int64_t count) {
    constexpr double end = 0.05;
    const auto length_of = [](const Polyline& line) {
        double sum = 0.0;
        for (std::size_t i = 1; i < line.window.size(); ++i)
            sum += glm::distance(glm::dvec2(line.window[i - 1]), glm::dvec2(line.window[i]));
        return sum;
    };
    double whole = 0.0;
    for (const Polyline& line : lines) whole += length_of(line);
    const glm::dmat4 to_world = glm::inverse(lens.to_clip);
    const double step = whole / static_cast<double>(count);
    std::vector<LinePlace> places;
    double next = 0.5 * step; // along the line
    for (const Polyline& line : lines) {
        const double length = length_of(line);
        double at = 0.0;
        for (std::size_t i = 1; i < line.window.size(); ++i) {
            const double piece = glm::distance(glm::dvec2(line.window[i - 1]), glm::dvec2(line.window[i]));
            for (; next < at + piece; next += step) {
                const double from_end = std::min(next, length - next);
                if (from_end < end) continue;
                const glm::dvec3 w = glm::mix(line.window[i - 1], line.window[i], (next - at) / piece);
                const glm::dvec4 p =
                    to_world * glm::dvec4(2.0 * (w.x - lens.viewport.x) / lens.viewport.z - 1.0,
                                          1.0 - 2.0 * (w.y - lens.viewport.y) / lens.viewport.w, 2.0 * w.z - 1.0, 1.0);
                places.push_back({glm::dvec2(w), glm::dvec3(p) / p.w, from_end, length, line.layers});
            }
            at += piece;
        }
        next -= length;
    }
    return places;
}

// Values and derivatives of a surface at places.
class Fields {
public:
    Fields(const hrbfnpr_model* model, const std::vector<glm::dvec3>& places)
        : value_(places.size()), gradient_(places.size()), hessian_(6 * places.size()) {
        scenes::Check check;
        const auto n = static_cast<std::int64_t>(places.size());
        const hrbfnpr_array points{places.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array_out value{value_.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        const hrbfnpr_array_out gradient{gradient_.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array_out hessian{hessian_.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 6};
        check(hrbfnpr_model_evaluate(model, &points, &value, &gradient, &hessian, nullptr, check.error()));
    }
    [[nodiscard]] double value(std::size_t i) const { return value_[i]; }
    [[nodiscard]] const glm::dvec3& gradient(std::size_t i) const { return gradient_[i]; }
    [[nodiscard]] glm::dmat3 hessian(std::size_t i) const {
        const double* h = hessian_.data() + 6 * i;
        return {h[0], h[1], h[2], h[1], h[3], h[4], h[2], h[4], h[5]};
    }

private:
    std::vector<double> value_;
    std::vector<glm::dvec3> gradient_;
    std::vector<double> hessian_;
};

// Takes Newton steps of least length to f = 0 and n . sight = 0, as seen from the eye.
inline void settle_on_contour(const hrbfnpr_model* model, const glm::dvec3& eye, double longest,
                              std::vector<glm::dvec3>& places) {
    for (int step = 0; step < 6; ++step) {
        const Fields f(model, places);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const glm::dvec3 v = places[i] - eye;
            const glm::dvec3 a = f.gradient(i);
            const glm::dvec3 b = f.hessian(i) * v + a;
            const double g = glm::dot(a, v);
            const double aa = glm::dot(a, a);
            const double ab = glm::dot(a, b);
            const double bb = glm::dot(b, b);
            const double det = aa * bb - ab * ab;
            if (!(det > 1e-16 * aa * bb)) continue;
            glm::dvec3 move = ((f.value(i) * bb - g * ab) * a + (g * aa - f.value(i) * ab) * b) / det;
            if (glm::length(move) > longest) move *= longest / glm::length(move);
            places[i] -= move;
        }
    }
}

struct VisibilityCount {
    std::int64_t places = 0, visible = 0, right = 0;
    std::int64_t layers_right = 0;      // the number of layers is right, too
    std::int64_t hidden_by_mistake = 0; // visible places that are drawn as hidden
    std::int64_t astray = 0;            // farther than half a pixel from any contour: not counted in `places`
    std::int64_t unsure = 0;            // no ray gives an answer: not counted either
    std::vector<std::string> wrong;     // descriptions

    void add(const VisibilityCount& other) {
        places += other.places;
        visible += other.visible;
        right += other.right;
        layers_right += other.layers_right;
        hidden_by_mistake += other.hidden_by_mistake;
        astray += other.astray;
        unsure += other.unsure;
        wrong.insert(wrong.end(), other.wrong.begin(), other.wrong.end());
    }
    void count(const LinePlace& place, std::uint32_t hits) {
        const auto layers = static_cast<int>((hits + 1) / 2);
        const bool is_right = (hits == 0) == (place.layers == 0);
        ++places;
        if (hits == 0) ++visible;
        if (is_right) ++right;
        if (place.layers == layers) ++layers_right;
        if (is_right) return;
        if (hits == 0) ++hidden_by_mistake;
        char text[160];
        std::snprintf(text, sizeof text,
                      "pixel (%.2f %.2f), %.2f px from an end of a part of %.2f px: %d layers, not %d", place.pixel.x,
                      place.pixel.y, place.from_end, place.part, place.layers, layers);
        wrong.emplace_back(text);
    }
};

// Casts rays at the contours of one surface.
class VisibilityCheck {
public:
    explicit VisibilityCheck(const hrbfnpr_model* model) : model_(model) {
        scenes::Check check;
        const hrbfnpr_model_info info = info_of(model);
        diagonal_ = glm::distance(glm::make_vec3(info.bounds_min), glm::make_vec3(info.bounds_max));
        check(hrbfnpr_model_lipschitz(model, &lipschitz_, nullptr, check.error()));
    }

    [[nodiscard]] VisibilityCount operator()(const hrbfnpr_camera& camera, const std::vector<Polyline>& lines,
                                             std::int64_t count) const {
        const Lens lens(camera);
        const std::vector<LinePlace> drawn = places_of(lines, lens, count);
        std::vector<glm::dvec3> places;
        for (const LinePlace& p : drawn) places.push_back(p.world);
        VisibilityCount found;
        if (places.empty()) return found;
        settle_on_contour(model_, lens.eye, 0.01 * diagonal_, places);
        const std::vector<double> little = gaps(lens.eye, places);
        const std::vector<std::uint32_t> hits = hits_before(lens.eye, places, little);
        for (std::size_t i = 0; i < drawn.size(); ++i) {
            if (glm::distance(lens.image_of(places[i]), drawn[i].pixel) > 0.5)
                ++found.astray;
            else if (little[i] < smallest * diagonal_)
                ++found.unsure;
            else
                found.count(drawn[i], hits[i]);
        }
        return found;
    }

private:
    static constexpr double smallest = 1e-4; // diagonals
    static constexpr double largest = 1e-3;

    // Returns how far before each place its ray must end: half the way to where the ray meets the same piece of surface
    // again.  With f = a s^2 / 2 + b s^3 / 6 along the ray, that is at s = -3 a / b.
    [[nodiscard]] std::vector<double> gaps(const glm::dvec3& eye, const std::vector<glm::dvec3>& places) const {
        const double step = 1e-4 * diagonal_;
        std::vector<glm::dvec3> before;
        for (const glm::dvec3& p : places) before.push_back(p - step * glm::normalize(p - eye));
        const Fields here(model_, places);
        const Fields there(model_, before);
        std::vector<double> little;
        for (std::size_t i = 0; i < places.size(); ++i) {
            const glm::dvec3 w = glm::normalize(places[i] - eye);
            const double a = glm::dot(w, here.hessian(i) * w);
            const double b = (a - glm::dot(w, there.hessian(i) * w)) / step;
            little.push_back(std::min(0.5 * std::abs(3.0 * a / b), largest * diagonal_));
        }
        return little;
    }

    [[nodiscard]] std::vector<std::uint32_t> hits_before(const glm::dvec3& eye, const std::vector<glm::dvec3>& places,
                                                         const std::vector<double>& little) const {
        const auto n = static_cast<std::int64_t>(places.size());
        std::vector<glm::dvec3> direction;
        std::vector<glm::dvec3> origin(places.size(), eye);
        for (std::size_t i = 0; i < places.size(); ++i) {
            const glm::dvec3 d = places[i] - eye;
            direction.push_back((1.0 - little[i] / glm::length(d)) * d);
        }
        scenes::Check check;
        auto desc = scenes::made(hrbfnpr_cast_desc_init);
        desc.maximum_hits = 64;
        desc.t_max = 1.0;
        desc.lipschitz = lipschitz_;
        std::vector<std::uint32_t> count(places.size());
        auto hits = scenes::made(hrbfnpr_ray_hits_init);
        hits.count = {count.data(), n, 0, HRBFNPR_SCALAR_UINT32, 1};
        const hrbfnpr_array origins{origin.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        const hrbfnpr_array directions{direction.data(), n, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        check(hrbfnpr_model_cast_rays(model_, &origins, &directions, &desc, &hits, nullptr, check.error()));
        return count;
    }

    const hrbfnpr_model* model_;
    double diagonal_ = 0.0;
    double lipschitz_ = 0.0;
};

} // namespace bench
