// SPDX-License-Identifier: MIT
// Samples of open surfaces, and stipples of models that end where the samples end.
#pragma once

#include "fixture.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace api_test {

inline constexpr int whole = 1000;
inline const double sphere_spacing = std::sqrt(4.0 * 3.141592653589793 / whole);

// Even samples of the unit sphere with low < z < high, and, if `tilted`, with x + z > 0.
inline scenes::Samples zone(double low, double high, bool tilted = false) {
    scenes::Samples samples;
    for (int i = 0; i < whole; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / whole;
        const double turn = 2.399963229728653 * i;
        const double r = std::sqrt(1.0 - z * z);
        if (!(z > low && z < high) || (tilted && !(r * std::cos(turn) + z > 0.0))) continue;
        samples.add({r * std::cos(turn), r * std::sin(turn), z}, {r * std::cos(turn), r * std::sin(turn), z});
    }
    return samples;
}

// A square in the plane z = 0 with a hundred samples.
inline scenes::Samples square() {
    scenes::Samples samples;
    for (int row = 0; row < 10; ++row)
        for (int column = 0; column < 10; ++column) samples.add({0.1 * column, 0.1 * row, 0.0}, {0.0, 0.0, 1.0});
    return samples;
}

// A fit whose surface continues beyond the samples.
inline Model fit_whole(const Context& context, const scenes::Samples& samples) {
    Error error;
    hrbfnpr_fit_desc desc = fit_desc(samples);
    desc.trim = HRBFNPR_TRIM_NEVER;
    hrbfnpr_model* model = nullptr;
    EXPECT_OK(hrbfnpr_model_fit(context.get(), &desc, nullptr, &model, error));
    return Model(model);
}

inline hrbfnpr_trim_info info_of(const Model& model) {
    Error error;
    auto info = made(hrbfnpr_trim_info_init);
    EXPECT_OK(hrbfnpr_model_get_trim_info(model.get(), &info, error));
    return info;
}

inline std::vector<float> stipples_of(const Context& context, const Model& model, std::int64_t budget = 4000) {
    Error error;
    const PointSet set = generate(context, model, one_layer(HRBFNPR_LAYER_KIND_STIPPLES, budget));
    hrbfnpr_array view{};
    EXPECT_OK(hrbfnpr_point_set_view(set.get(), 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &view, error));
    auto info = made(hrbfnpr_point_set_info_init);
    EXPECT_OK(hrbfnpr_point_set_get_info(set.get(), &info, error));
    std::vector<float> positions(3 * static_cast<std::size_t>(view.count));
    const auto* const from = static_cast<const float*>(view.data);
    for (std::size_t i = 0; i < positions.size(); ++i) positions[i] = from[i] + static_cast<float>(info.origin[i % 3]);
    return positions;
}

// The smallest coordinate along (1, 0, 1).
inline float lowest(const std::vector<float>& positions) {
    float least = std::numeric_limits<float>::infinity();
    for (std::size_t i = 0; i < positions.size(); i += 3)
        least = std::min(least, std::sqrt(0.5F) * (positions[i] + positions[i + 2]));
    return least;
}

} // namespace api_test
