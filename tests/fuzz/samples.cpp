// SPDX-License-Identifier: MIT
#include "samples.h"

#include "support/samples.h"

#include <algorithm>
#include <cmath>

namespace fuzz {
namespace {

void add_sphere(Samples& samples, int count, double radius, double x, double outward) {
    for (int i = 0; i < count; ++i) {
        const std::array<double, 3> n = hrbfnpr::test::spiral_point(i, count);
        samples.add({x + radius * n[0], radius * n[1], radius * n[2]},
                    {outward * n[0], outward * n[1], outward * n[2]});
    }
}

void add_torus(Samples& samples, int count) {
    for (int i = 0; i < count; ++i) {
        const double a = 2.399963 * i;
        const double b = 6.283185 * i / count;
        const double n[3] = {std::cos(a) * std::cos(b), std::cos(a) * std::sin(b), std::sin(a)};
        samples.add({std::cos(b) + 0.4 * n[0], std::sin(b) + 0.4 * n[1], 0.4 * n[2]}, n);
    }
}

// Adds waves over a square.
void add_sheet(Samples& samples, int count) {
    const int side = std::max(1, static_cast<int>(std::sqrt(count)));
    for (int i = 0; i < count; ++i) {
        const double x = static_cast<double>(i % side) / side;
        const double y = static_cast<double>(i) / side / side;
        const double slope = -0.6 * std::cos(6.0 * x);
        const double length = std::sqrt(1.0 + slope * slope);
        samples.add({x, y, 0.1 * std::sin(6.0 * x)}, {slope / length, 0.0, 1.0 / length});
    }
}

void add_box(Samples& samples, int count) {
    for (int i = 0; i < count; ++i) {
        double point[3] = {i / 6 % 3 - 1.0, i / 18 % 3 - 1.0, 0.3 * (i / 54)};
        double normal[3] = {0.0, 0.0, 0.0};
        normal[i % 3] = i / 3 % 2 == 0 ? 1.0 : -1.0;
        std::swap(point[i % 3], point[2]);
        point[i % 3] = normal[i % 3];
        samples.add(point, normal);
    }
}

void make_odd(std::vector<double>& numbers, Input& input) {
    if (numbers.empty()) return;
    double& number = numbers[input.below(numbers.size())];
    number = odd_float(number, numbers[input.below(numbers.size())], input);
}

double scale_of(Input& input) {
    static constexpr double scales[] = {1, 1, 1, 1, 1e-3, 1e3, 1e-30, 1e30, 1e-90, 1e90, 1e-160, 1e160, 0};
    return input.one_of(scales);
}

} // namespace

Samples samples_of(Surface surface, int count) {
    Samples samples;
    switch (surface) {
    case Surface::sphere: add_sphere(samples, count, 1.0, 0.0, 1.0); break;
    case Surface::torus: add_torus(samples, count); break;
    case Surface::sheet: add_sheet(samples, count); break;
    case Surface::two_spheres:
        add_sphere(samples, count / 2, 1.0, 0.0, 1.0);
        add_sphere(samples, count - count / 2, 0.7, 2.1, 1.0);
        break;
    case Surface::nested_spheres:
        add_sphere(samples, count / 2, 1.0, 0.0, 1.0);
        add_sphere(samples, count - count / 2, 0.8, 0.0, -1.0);
        break;
    case Surface::box: add_box(samples, count); break;
    case Surface::line:
        for (int i = 0; i < count; ++i) samples.add({0.1 * i, 0.2 * i, 0.3}, {0, 0, 1});
        break;
    case Surface::one_place:
        for (int i = 0; i < count; ++i) samples.add({1, 2, 3}, {0, 0, 1});
        break;
    case Surface::count: break;
    }
    return samples;
}

Samples some_samples(Input& input, int most) {
    const auto surface = static_cast<Surface>(input.below(static_cast<std::size_t>(Surface::count)));
    Samples samples = samples_of(surface, 12 + static_cast<int>(input.below(static_cast<std::size_t>(most - 11))));
    if (input.once_in(8)) samples = samples_of(surface, static_cast<int>(input.below(5)));
    const double scale = scale_of(input);
    const double offset = input.once_in(4) ? input.between(-1e4, 1e4) : 0.0;
    for (double& number : samples.points) number = scale * (number + offset);
    if (input.once_in(3)) {
        const double noise = scale * input.unit() * 0.2;
        std::uint64_t random = input.below(256);
        for (double& number : samples.points) {
            random = random * 6364136223846793005U + 1442695040888963407U;
            number += noise * (static_cast<double>(random >> 40U) / static_cast<double>(1U << 23U) - 1.0);
        }
    }
    for (std::size_t turned = input.once_in(4) ? input.below(8) : 0; turned > 0 && !samples.normals.empty(); --turned) {
        const std::size_t at = 3 * input.below(samples.normals.size() / 3);
        for (std::size_t k = 0; k < 3; ++k) samples.normals[at + k] *= -1.0;
    }
    for (std::size_t odd = input.once_in(4) ? 1 + input.below(3) : 0; odd > 0; --odd) {
        make_odd(samples.points, input);
        make_odd(samples.normals, input);
    }
    return samples;
}

} // namespace fuzz
