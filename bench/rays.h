// SPDX-License-Identifier: MIT
// Rays on a fit: rays per second, against the march over sums of all centres, which a call uses if it gives a bound.
#pragma once

#include "calls.h"
#include "samples.h"
#include "timing.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

namespace bench {

struct RayBundle {
    const char* name;
    std::vector<double> origin, direction;

    void add(const std::array<double, 3>& from, const std::array<double, 3>& along) {
        origin.insert(origin.end(), from.begin(), from.end());
        direction.insert(direction.end(), along.begin(), along.end());
    }
};

// Rays from one eye through the pixels of a square picture.
[[nodiscard]] inline RayBundle picture_rays(int side) {
    RayBundle bundle{"picture", {}, {}};
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            bundle.add({0.0, 0.0, 5.0}, {1.3 * (2.0 * column / side - 1.0), 1.3 * (2.0 * row / side - 1.0), -5.0});
    return bundle;
}

class RandomNumbers {
public:
    [[nodiscard]] double operator()() noexcept {
        state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state_ >> 11U) * 0x1p-53;
    }
    [[nodiscard]] std::array<double, 3> unit_vector() noexcept {
        const double z = 2.0 * (*this)() - 1.0;
        const double turn = 6.283185307179586 * (*this)();
        const double r = std::sqrt(1.0 - z * z);
        return {r * std::cos(turn), r * std::sin(turn), z};
    }

private:
    std::uint64_t state_ = 1;
};

// Rays from all around to places inside the surface.
[[nodiscard]] inline RayBundle random_rays(int count) {
    RayBundle bundle{"random", {}, {}};
    RandomNumbers random;
    for (int i = 0; i < count; ++i) {
        const std::array<double, 3> from = random.unit_vector();
        const std::array<double, 3> to = random.unit_vector();
        bundle.add({3.0 * from[0], 3.0 * from[1], 3.0 * from[2]},
                   {0.8 * to[0] - 3.0 * from[0], 0.8 * to[1] - 3.0 * from[1], 0.8 * to[2] - 3.0 * from[2]});
    }
    return bundle;
}

// Tangents at samples, moved to either side by 1e-6 to 1e-2.
[[nodiscard]] inline RayBundle grazing_rays(const Samples& samples, int count) {
    RayBundle bundle{"grazing", {}, {}};
    RandomNumbers random;
    for (int i = 0; i < count; ++i) {
        const auto at = 3 * static_cast<std::size_t>(random() * static_cast<double>(samples.count()));
        const double* const n = samples.normals.data() + at;
        const std::array<double, 3> u = random.unit_vector();
        std::array<double, 3> along{n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0]};
        const double length = std::hypot(along[0], along[1], along[2]);
        const double lift = std::pow(10.0, -6.0 + 4.0 * random()) * (i % 2 == 0 ? 1.0 : -1.0);
        std::array<double, 3> from{};
        for (std::size_t c = 0; c < 3; ++c) {
            along[c] /= length;
            from[c] = samples.points[at + c] + lift * n[c] - 3.0 * along[c];
        }
        bundle.add(from, along);
    }
    return bundle;
}

// Returns every `step`-th ray.
[[nodiscard]] inline RayBundle some_of(const RayBundle& bundle, std::size_t step) {
    RayBundle some{bundle.name, {}, {}};
    const double* const from = bundle.origin.data();
    const double* const along = bundle.direction.data();
    for (std::size_t i = 0; i < bundle.origin.size(); i += 3 * step)
        some.add({from[i], from[i + 1], from[i + 2]}, {along[i], along[i + 1], along[i + 2]});
    return some;
}

// The way of a call. lipschitz 0: the search that the library chooses.
struct CastWay {
    double lipschitz = 0.0;
    const hrbfnpr_line_set* line_set = nullptr;
    std::uint32_t refine = 1;
};
// Returns the seconds of a call. `found` receives the number of hits of each ray.
[[nodiscard]] inline double cast(const hrbfnpr_model* model, const RayBundle& bundle, const CastWay& way,
                                 std::vector<std::uint32_t>& found) {
    scenes::Check check;
    const auto rays = static_cast<std::int64_t>(bundle.origin.size() / 3);
    const hrbfnpr_array from{bundle.origin.data(), rays, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    const hrbfnpr_array along{bundle.direction.data(), rays, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    hrbfnpr_cast_desc desc;
    check(hrbfnpr_cast_desc_init(&desc, sizeof(desc)));
    desc.lipschitz = way.lipschitz;
    desc.line_set = way.line_set;
    desc.refine = way.refine;
    desc.maximum_hits = 4;
    hrbfnpr_ray_hits hits;
    check(hrbfnpr_ray_hits_init(&hits, sizeof(hits)));
    found.resize(bundle.origin.size() / 3);
    hits.count = {found.data(), rays, 0, HRBFNPR_SCALAR_UINT32, 1};
    return seconds([&] { check(hrbfnpr_model_cast_rays(model, &from, &along, &desc, &hits, nullptr, check.error())); });
}

// Reports the rates of rays that meet a mesh first, against the search without a mesh, and how many of them have
// another number of hits than `wanted`.
inline void report_on_mesh(hrbfnpr_context* context, const hrbfnpr_model* model, const RayBundle& bundle,
                           const std::string& name, const std::vector<std::uint32_t>& wanted) {
    scenes::Check check;
    hrbfnpr_line_set* raw = nullptr;
    check(hrbfnpr_line_set_create(context, model, nullptr, nullptr, &raw, check.error()));
    const hrbfnpr::test::LineSet lines(raw);
    for (const std::uint32_t refine : {1U, 0U}) {
        const CastWay way{0.0, lines.get(), refine};
        std::vector<std::uint32_t> found;
        const Comparison times = compare(
            3, [&] { static_cast<void>(cast(model, bundle, {}, found)); },
            [&] { static_cast<void>(cast(model, bundle, way, found)); });
        std::int64_t different = 0;
        for (std::size_t i = 0; i < wanted.size(); ++i) different += found[i] != wanted[i] ? 1 : 0;
        const std::string row = name + (refine == 1 ? ".refined" : ".mesh");
        report((row + ".per_second").c_str(), static_cast<double>(found.size()) / times.seconds);
        report((row + ".ratio").c_str(), times.ratio);
        report((row + ".different").c_str(), static_cast<double>(different));
    }
}

// Reports the rate of later calls and of the first call, which prepares the fit, the ratio of the former to the rate of
// the march, and the number of rays with another number of hits.
inline void run_rays(hrbfnpr_context* context) {
    constexpr int side = 330;
    constexpr std::size_t step = 40; // every 40th ray is marched
    const Samples samples = bumpy(5000, 0.15);
    for (const RayBundle& bundle : {picture_rays(side), random_rays(side * side), grazing_rays(samples, side * side)}) {
        scenes::Check check;
        const scenes::Model model = fit(context, samples.points, samples.normals);
        double lipschitz = 0.0;
        check(hrbfnpr_model_lipschitz(model.get(), &lipschitz, nullptr, check.error()));
        const RayBundle some = some_of(bundle, step);
        std::vector<std::uint32_t> found;
        std::vector<std::uint32_t> wanted;
        const double first = cast(model.get(), bundle, {}, found);
        const Comparison times = compare(
            3, [&] { static_cast<void>(cast(model.get(), some, {lipschitz}, wanted)); },
            [&] { static_cast<void>(cast(model.get(), bundle, {}, found)); });
        std::int64_t different = 0;
        for (std::size_t i = 0; i < wanted.size(); ++i) different += found[i * step] != wanted[i] ? 1 : 0;
        const double share = static_cast<double>(found.size()) / static_cast<double>(wanted.size());
        const std::string name = std::string("rays.") + bundle.name;
        report((name + ".per_second").c_str(), static_cast<double>(found.size()) / times.seconds);
        report((name + ".per_second_first").c_str(), static_cast<double>(found.size()) / first);
        report((name + ".ratio_march").c_str(), share * times.ratio);
        report((name + ".different").c_str(), static_cast<double>(different));
        report_on_mesh(context, model.get(), bundle, name, found);
        std::fflush(stdout);
    }
}

} // namespace bench
