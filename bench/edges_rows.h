// SPDX-License-Identifier: MIT
// Unions of many fits: the time of an evaluation, relative to that of a single fit.
#pragma once

#include "calls.h"
#include "scenes/shapes.h"
#include "support/csg_nodes.h"
#include "timing.h"

#include <cstdio>
#include <random>

namespace bench::rows {

inline constexpr int runs = 9;
inline constexpr int places = 20000;

// Places fits in rows of 8, the rows in layers of 8.
inline Vec3 centre(int i) { return {3.0 * (i % 8), 3.0 * (i / 8 % 8), 1.2 * (i / 64)}; }

inline scenes::Model unite(hrbfnpr_context* context, const hrbfnpr_model* fit, int count) {
    scenes::Check check;
    hrbfnpr::test::CsgNodes nodes;
    nodes.add(HRBFNPR_CSG_UNION);
    for (int i = 0; i < count; ++i) {
        const Vec3 at = centre(i);
        nodes.add(HRBFNPR_CSG_MODEL, 0, at[0], at[1], at[2]).model = fit;
    }
    const hrbfnpr_csg_desc desc = nodes.desc();
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_create_csg(context, &desc, &model, check.error()));
    return scenes::Model(model);
}

inline void evaluate(const hrbfnpr_model* model, const std::vector<double>& at) {
    scenes::Check check;
    std::vector<double> value(at.size() / 3);
    std::vector<double> gradient(at.size());
    const hrbfnpr_array points = view(at);
    const hrbfnpr_array_out values{value.data(), static_cast<std::int64_t>(value.size()), 0, HRBFNPR_SCALAR_FLOAT64, 1};
    const hrbfnpr_array_out gradients{gradient.data(), values.count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    check(hrbfnpr_model_evaluate(model, &points, &values, &gradients, nullptr, nullptr, check.error()));
}

// Random places near the surfaces of `count` fits.
inline std::vector<double> near_surfaces(const std::vector<double>& samples, int count) {
    std::mt19937 random(7);
    const auto number = [&] { return static_cast<double>(random()) / 4294967296.0; };
    std::vector<double> at;
    for (int i = 0; i < places; ++i) {
        const Vec3 middle = centre(static_cast<int>(number() * count));
        const std::size_t sample = static_cast<std::size_t>(number() * static_cast<double>(samples.size() / 3));
        for (std::size_t c = 0; c < 3; ++c) at.push_back(middle[c] + samples[3 * sample + c] + 0.04 * (number() - 0.5));
    }
    return at;
}

inline void measure_rows(hrbfnpr_context* context) {
    const hrbfnpr::test::Samples torus = scenes::torus(1000);
    const scenes::Model one = fit(context, torus.points, torus.normals, HRBFNPR_TRIM_NEVER);
    for (const int count : {8, 64, 512}) {
        const scenes::Model row = unite(context, one.get(), count);
        const std::vector<double> of_one = near_surfaces(torus.points, 1);
        const std::vector<double> of_all = near_surfaces(torus.points, count);
        const Comparison times = compare(
            runs, [&] { evaluate(row.get(), of_all); }, [&] { evaluate(one.get(), of_one); });
        std::printf("edges.union_of_%d_beside_one_fit %.2f\n", count, times.ratio);
    }
}

} // namespace bench::rows
