// SPDX-License-Identifier: MIT
// The error of a drawing's tone. Drawn and wanted tones are both blurred by the same Gaussian, so that windows of a few
// line spacings are compared, not single lines.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace bench {

// One value per pixel, rows from the top.
struct ToneImage {
    int width = 0, height = 0;
    std::vector<float> share; // covered by ink
    std::vector<bool> counts; // whether the pixel shows the surface whose tone is compared
};

[[nodiscard]] inline std::vector<float> gaussian(double sigma) {
    const int reach = static_cast<int>(std::ceil(3.0 * sigma));
    std::vector<float> kernel;
    double sum = 0.0;
    for (int k = -reach; k <= reach; ++k) sum += std::exp(-k * k / (2.0 * sigma * sigma));
    for (int k = -reach; k <= reach; ++k)
        kernel.push_back(static_cast<float>(std::exp(-k * k / (2.0 * sigma * sigma)) / sum));
    return kernel;
}

// Blurs along rows, or along columns.
inline void blur_one_way(std::vector<float>& image, int width, int height, const std::vector<float>& kernel,
                         bool rows) {
    const int reach = static_cast<int>(kernel.size() / 2);
    const int count = rows ? width : height;
    const auto at = [&](int line, int i) {
        return static_cast<std::size_t>(rows ? line * width + i : i * width + line);
    };
    std::vector<float> before(static_cast<std::size_t>(count));
    for (int line = 0; line < (rows ? height : width); ++line) {
        for (int i = 0; i < count; ++i) before[static_cast<std::size_t>(i)] = image[at(line, i)];
        for (int i = 0; i < count; ++i) {
            float sum = 0.0F;
            for (int k = -reach; k <= reach; ++k)
                sum += kernel[static_cast<std::size_t>(k + reach)] *
                       before[static_cast<std::size_t>(std::clamp(i + k, 0, count - 1))];
            image[at(line, i)] = sum;
        }
    }
}

struct ToneSums {
    double squares = 0.0, sum = 0.0, number = 0.0;

    void add(const ToneSums& other) {
        squares += other.squares;
        sum += other.sum;
        number += other.number;
    }
    // White and black are 1 apart.
    [[nodiscard]] double psnr() const { return 10.0 * std::log10(number / squares); }
    [[nodiscard]] double bias() const { return sum / number; } // positive if too dark
};

// Compares the pixels for which all pixels within three sigma count.
[[nodiscard]] inline ToneSums compare_tones(const ToneImage& drawn, const ToneImage& asked, double sigma) {
    const std::vector<float> kernel = gaussian(sigma);
    const int width = asked.width;
    const int height = asked.height;
    std::vector<float> difference(asked.share.size());
    std::vector<float> outside(asked.share.size());
    for (std::size_t i = 0; i < difference.size(); ++i) {
        difference[i] = asked.counts[i] ? drawn.share[i] - asked.share[i] : 0.0F;
        outside[i] = asked.counts[i] ? 0.0F : 1.0F;
    }
    for (std::vector<float>* const image : {&difference, &outside})
        for (const bool rows : {true, false}) blur_one_way(*image, width, height, kernel, rows);
    const int reach = static_cast<int>(kernel.size() / 2);
    ToneSums sums;
    for (int y = reach; y < height - reach; ++y)
        for (int x = reach; x < width - reach; ++x) {
            const auto i = static_cast<std::size_t>(y * width + x);
            if (outside[i] > 0.0F) continue;
            const auto error = static_cast<double>(difference[i]);
            sums.squares += error * error;
            sums.sum += error;
            sums.number += 1.0;
        }
    return sums;
}

} // namespace bench
