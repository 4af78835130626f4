// SPDX-License-Identifier: MIT
// A ramp of tones, and the error of a drawing of it.
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace bench {

inline constexpr int ramp_width = 640;
inline constexpr int ramp_height = 320;

// The coverage at a column.
inline double asked(double x) { return 0.05 + 0.5 * x / ramp_width; }

// Blurs by a Gaussian of 4 pixels.
inline std::vector<double> blurred(const std::vector<double>& image) {
    constexpr double sigma = 4.0;
    constexpr int reach = 16;
    std::vector<double> kernel;
    for (int k = -reach; k <= reach; ++k) kernel.push_back(std::exp(-k * k / (2.0 * sigma * sigma)));
    const double sum = std::accumulate(kernel.begin(), kernel.end(), 0.0);
    const auto pass = [&](const std::vector<double>& from, int dx, int dy) {
        std::vector<double> to(from.size());
        for (int y = 0; y < ramp_height; ++y)
            for (int x = 0; x < ramp_width; ++x) {
                double value = 0.0;
                for (int k = -reach; k <= reach; ++k) {
                    const int u = std::clamp(x + k * dx, 0, ramp_width - 1);
                    const int v = std::clamp(y + k * dy, 0, ramp_height - 1);
                    value += kernel[static_cast<std::size_t>(k + reach)] *
                             from[static_cast<std::size_t>(v * ramp_width + u)];
                }
                to[static_cast<std::size_t>(y * ramp_width + x)] = value / sum;
            }
        return to;
    };
    return pass(pass(image, 1, 0), 0, 1);
}

struct ToneError {
    double psnr, bias;
};

inline ToneError tone_error(const std::vector<double>& ink) {
    std::vector<double> wanted(ink.size());
    for (std::size_t i = 0; i < wanted.size(); ++i) wanted[i] = asked(static_cast<double>(i % ramp_width) + 0.5);
    const std::vector<double> a = blurred(ink);
    const std::vector<double> b = blurred(wanted);
    double squares = 0.0;
    double sum = 0.0;
    double number = 0.0;
    for (int y = 16; y < ramp_height - 16; ++y)
        for (int x = 16; x < ramp_width - 16; ++x) {
            const double error =
                a[static_cast<std::size_t>(y * ramp_width + x)] - b[static_cast<std::size_t>(y * ramp_width + x)];
            squares += error * error;
            sum += error;
            number += 1.0;
        }
    return {10.0 * std::log10(number / squares), sum / number};
}

} // namespace bench
