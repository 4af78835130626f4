// SPDX-License-Identifier: MIT
// White flecks in the hatching of a picture. A fleck is a white spot in an evenly dark area where a circle fits that is
// at least 1.5 times as wide as the white between the lines around it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace bench {

// The share of ink in each pixel, from 0 to 1, row by row.
struct InkImage {
    std::int64_t width = 0, height = 0;
    std::vector<float> ink;

    [[nodiscard]] std::size_t at(std::int64_t x, std::int64_t y) const {
        return static_cast<std::size_t>(y * width + x);
    }
    [[nodiscard]] bool is_white(std::size_t i) const { return ink[i] < 0.5F; }
};

struct Fleck {
    double x, y, diameter; // pixels
};

struct Flecks {
    std::vector<Fleck> fleck;
    double dark = 0.0; // the number of pixels in evenly dark areas
};

struct FleckRules {
    double spacing;         // least distance of hatching lines, pixels
    double window = 4.0;    // half the side of the squares in which ink is averaged, in spacings
    double darkest = 0.45;  // least share of ink in the square around a fleck
    double beside = 0.35;   // least share of ink in the four squares beside it
    double wider = 1.75;    // least diameter of a fleck, in mean widths of the white between lines
    double smallest = 0.33; // least diameter of a fleck, in spacings
};

namespace detail {

// Sums over squares of the numbers of an image.
class SquareSums {
public:
    SquareSums(std::int64_t width, std::int64_t height)
        : width_(width), height_(height), sum_(static_cast<std::size_t>((width + 1) * (height + 1))) {}

    template <class Value>
    void fill(const Value& value) {
        for (std::int64_t y = 0; y < height_; ++y) {
            double row = 0.0;
            for (std::int64_t x = 0; x < width_; ++x) {
                row += value(static_cast<std::size_t>(y * width_ + x));
                at(x + 1, y + 1) = at(x + 1, y) + row;
            }
        }
    }
    // Returns the sum over a square. Pixels outside the image count as 0.
    [[nodiscard]] double sum(std::int64_t x, std::int64_t y, std::int64_t reach) const {
        const std::int64_t left = std::clamp<std::int64_t>(x - reach, 0, width_);
        const std::int64_t right = std::clamp<std::int64_t>(x + reach + 1, 0, width_);
        const std::int64_t top = std::clamp<std::int64_t>(y - reach, 0, height_);
        const std::int64_t bottom = std::clamp<std::int64_t>(y + reach + 1, 0, height_);
        return at(right, bottom) - at(left, bottom) - at(right, top) + at(left, top);
    }

private:
    [[nodiscard]] double& at(std::int64_t x, std::int64_t y) {
        return sum_[static_cast<std::size_t>(y * (width_ + 1) + x)];
    }
    [[nodiscard]] double at(std::int64_t x, std::int64_t y) const {
        return sum_[static_cast<std::size_t>(y * (width_ + 1) + x)];
    }

    std::int64_t width_, height_;
    std::vector<double> sum_; // sums over all pixels above and to the left
};

// Replaces squared distances along one line of pixels by those to the lower envelope of parabolas.
// [Felzenszwalb & Huttenlocher 2012, "Distance transforms of sampled functions"]
inline void squared_distances(std::vector<double>& f, std::vector<double>& out, std::vector<std::int64_t>& vertex,
                              std::vector<double>& border) {
    const auto n = static_cast<std::int64_t>(f.size());
    const auto value = [&](std::int64_t i) {
        return f[static_cast<std::size_t>(i)] + static_cast<double>(i) * static_cast<double>(i);
    };
    std::size_t k = 0;
    vertex[0] = 0;
    border[0] = -1e18;
    for (std::int64_t q = 1; q < n; ++q) {
        const auto meet = [&] { return (value(q) - value(vertex[k])) / static_cast<double>(2 * (q - vertex[k])); };
        while (k > 0 && meet() <= border[k]) --k;
        const double from = meet();
        vertex[++k] = q;
        border[k] = from;
    }
    const std::size_t last = k;
    k = 0;
    for (std::int64_t q = 0; q < n; ++q) {
        while (k < last && border[k + 1] < static_cast<double>(q)) ++k;
        const auto way = static_cast<double>(q - vertex[k]);
        out[static_cast<std::size_t>(q)] = way * way + f[static_cast<std::size_t>(vertex[k])];
    }
    f = out;
}

// Returns for each pixel the distance to the nearest pixel with ink.
[[nodiscard]] inline std::vector<float> distances_to_ink(const InkImage& image) {
    constexpr double far = 1e12;
    const auto width = static_cast<std::size_t>(image.width);
    const auto height = static_cast<std::size_t>(image.height);
    const std::size_t longest = std::max(width, height) + 1;
    std::vector<float> distance(width * height);
    std::vector<double> line(width), out(width), border(longest);
    std::vector<std::int64_t> vertex(longest);
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) line[x] = image.is_white(y * width + x) ? far : 0.0;
        squared_distances(line, out, vertex, border);
        for (std::size_t x = 0; x < width; ++x) distance[y * width + x] = static_cast<float>(line[x]);
    }
    line.resize(height);
    out.resize(height);
    for (std::size_t x = 0; x < width; ++x) {
        for (std::size_t y = 0; y < height; ++y) line[y] = static_cast<double>(distance[y * width + x]);
        squared_distances(line, out, vertex, border);
        for (std::size_t y = 0; y < height; ++y) distance[y * width + x] = static_cast<float>(std::sqrt(line[y]));
    }
    return distance;
}

} // namespace detail

[[nodiscard]] inline Flecks find_flecks(const InkImage& image, const FleckRules& rules) {
    const std::vector<float> to_ink = detail::distances_to_ink(image);
    detail::SquareSums ink(image.width, image.height);
    detail::SquareSums white(image.width, image.height);
    detail::SquareSums ways(image.width, image.height);
    ink.fill([&](std::size_t i) { return static_cast<double>(image.ink[i]); });
    white.fill([&](std::size_t i) { return image.is_white(i) ? 1.0 : 0.0; });
    ways.fill([&](std::size_t i) { return static_cast<double>(to_ink[i]); });
    const auto reach = static_cast<std::int64_t>(std::lround(rules.window * rules.spacing));
    const auto area = static_cast<double>((2 * reach + 1) * (2 * reach + 1));
    const auto is_dark = [&](std::int64_t x, std::int64_t y) {
        const auto share = [&](std::int64_t right, std::int64_t down) {
            return ink.sum(x + right * reach, y + down * reach, reach) / area;
        };
        return share(0, 0) >= rules.darkest && share(1, 0) >= rules.beside && share(-1, 0) >= rules.beside &&
               share(0, 1) >= rules.beside && share(0, -1) >= rules.beside;
    };
    Flecks found;
    std::vector<Fleck> candidate;
    for (std::int64_t y = 0; y < image.height; ++y)
        for (std::int64_t x = 0; x < image.width; ++x) {
            if (!is_dark(x, y)) continue;
            found.dark += 1.0;
            const double diameter = 2.0 * static_cast<double>(to_ink[image.at(x, y)]) - 1.0;
            if (diameter < rules.smallest * rules.spacing) continue;
            // A strip of white of n pixels has distances from 1 to (n + 1) / 2, so their mean is about (n + 2) / 4.
            const double even = 4.0 * ways.sum(x, y, reach) / std::max(white.sum(x, y, reach), 1.0) - 2.0;
            if (diameter >= rules.wider * even)
                candidate.push_back({static_cast<double>(x), static_cast<double>(y), diameter});
        }
    std::stable_sort(candidate.begin(), candidate.end(),
                     [](const Fleck& a, const Fleck& b) { return a.diameter > b.diameter; });
    for (const Fleck& c : candidate)
        if (std::none_of(found.fleck.begin(), found.fleck.end(),
                         [&](const Fleck& f) { return std::hypot(f.x - c.x, f.y - c.y) < 2.0 * rules.spacing; }))
            found.fleck.push_back(c);
    return found;
}

} // namespace bench
