// SPDX-License-Identifier: MIT
// Seconds of each stage from samples to a picture, for a torus with bumps; and the ratio of the time on one thread to
// the time on all threads.
#include "calls.h"
#include "timing.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <numbers>
#include <string>
#include <vector>

namespace {

constexpr int rings = 40; // samples: rings * around
constexpr int around = 16;
constexpr std::int64_t queries = 50000;
constexpr int width = 1600;
constexpr int height = 1200;
constexpr int runs = 3;

using Vec = std::array<double, 3>;

// A torus about z: centre circle of radius 1, tube 0.4 + 0.03 cos 9 phi cos 5 theta.
Vec torus_at(double phi, double theta) {
    const double tube = 0.4 + 0.03 * std::cos(9.0 * phi) * std::cos(5.0 * theta);
    const double reach = 1.0 + tube * std::cos(theta);
    return {reach * std::cos(phi), reach * std::sin(phi), tube * std::sin(theta)};
}

// Returns the outward normal from central differences, whose error of 1e-10 does not matter here.
Vec normal_at(double phi, double theta) {
    constexpr double h = 1e-5;
    const auto along = [](const Vec& a, const Vec& b) { return Vec{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; };
    const Vec u = along(torus_at(phi + h, theta), torus_at(phi - h, theta));
    const Vec v = along(torus_at(phi, theta + h), torus_at(phi, theta - h));
    const Vec n = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
    const double length = std::hypot(n[0], n[1], n[2]);
    return {n[0] / length, n[1] / length, n[2] / length};
}

struct Samples {
    std::vector<Vec> points;
    std::vector<Vec> normals;
};

Samples bumpy_torus() {
    Samples samples;
    for (int ring = 0; ring < rings; ++ring) {
        for (int k = 0; k < around; ++k) {
            const double phi = 2.0 * std::numbers::pi * ring / rings;
            const double theta = 2.0 * std::numbers::pi * (k + 0.5 * (ring % 2)) / around;
            samples.points.push_back(torus_at(phi, theta));
            samples.normals.push_back(normal_at(phi, theta));
        }
    }
    return samples;
}

hrbfnpr_array view(const std::vector<Vec>& vectors) {
    return {vectors.data(), static_cast<std::int64_t>(vectors.size()), 0, HRBFNPR_SCALAR_FLOAT64, 3};
}

// The four stages in one context; each works on the result of the one before.
class Pipeline {
public:
    Pipeline(int threads, const Samples& samples) : samples_(samples), context_(bench::make_context(threads)) {
        hrbfnpr_renderer* renderer = nullptr;
        check_(hrbfnpr_renderer_create(context_.get(), &renderer, check_.error()));
        renderer_.reset(renderer);
        check_(hrbfnpr_style_init_preset(&style_, sizeof style_, HRBFNPR_PRESET_FULL, check_.error()));
        for (std::int64_t i = 0; i < queries; ++i) {
            const auto t = static_cast<double>(i);
            queries_.push_back(torus_at(t * 0.618, t * 0.755));
        }
    }

    void fit() {
        hrbfnpr_fit_desc desc;
        check_(hrbfnpr_fit_desc_init(&desc, sizeof desc));
        desc.points = view(samples_.points);
        desc.normals = view(samples_.normals);
        hrbfnpr_model* model = nullptr;
        check_(hrbfnpr_model_fit(context_.get(), &desc, nullptr, &model, check_.error()));
        model_.reset(model);
    }

    void evaluate() {
        values_.resize(queries_.size());
        gradients_.resize(queries_.size());
        const hrbfnpr_array points = view(queries_);
        const hrbfnpr_array_out value = {values_.data(), queries, 0, HRBFNPR_SCALAR_FLOAT64, 1};
        const hrbfnpr_array_out gradient = {gradients_.data(), queries, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        check_(hrbfnpr_model_evaluate(model_.get(), &points, &value, &gradient, nullptr, nullptr, check_.error()));
    }

    void generate() {
        hrbfnpr_generate_desc desc;
        check_(hrbfnpr_generate_desc_init(&desc, sizeof desc));
        desc.layers = hrbfnpr_preset_layers(HRBFNPR_PRESET_FULL, &desc.layer_count);
        hrbfnpr_point_set* marks = nullptr;
        check_(hrbfnpr_point_set_generate(context_.get(), model_.get(), &desc, nullptr, &marks, check_.error()));
        marks_.reset(marks);
    }

    void draw() {
        const scenes::Drawing drawing = drawn();
        pixels_.resize(std::size_t{4} * width * height);
        hrbfnpr_image image;
        check_(hrbfnpr_image_init(&image, sizeof image));
        image.format = HRBFNPR_FORMAT_RGBA8;
        image.width = width;
        image.height = height;
        image.pixels = pixels_.data();
        check_(hrbfnpr_drawing_rasterize(drawing.get(), &image, nullptr, check_.error()));
    }

    [[nodiscard]] double marks() {
        hrbfnpr_point_set_info info;
        check_(hrbfnpr_point_set_info_init(&info, sizeof info));
        check_(hrbfnpr_point_set_get_info(marks_.get(), &info, check_.error()));
        return static_cast<double>(info.marks);
    }

    [[nodiscard]] double threads() {
        hrbfnpr_context_info info;
        check_(hrbfnpr_context_info_init(&info, sizeof info));
        check_(hrbfnpr_context_get_info(context_.get(), &info, check_.error()));
        return info.thread_count;
    }

private:
    [[nodiscard]] scenes::Drawing drawn() {
        const double low[3] = {-1.43, -1.43, -0.43};
        const double high[3] = {1.43, 1.43, 0.43};
        const double direction[3] = {0.2, 1.0, -0.8};
        const double up[3] = {0, 0, 1};
        hrbfnpr_camera camera;
        check_(hrbfnpr_camera_init(&camera, sizeof camera));
        check_(hrbfnpr_camera_fit_bounds(&camera, low, high, direction, up, 0.5, width, height, 0.05, check_.error()));
        hrbfnpr_item item;
        check_(hrbfnpr_item_init(&item, sizeof item));
        item.point_set = marks_.get();
        item.style = &style_;
        hrbfnpr_drawing* drawing = nullptr;
        check_(hrbfnpr_renderer_draw(renderer_.get(), &item, 1, 0, &camera, &drawing, check_.error()));
        return scenes::Drawing(drawing);
    }

    const Samples& samples_;
    scenes::Check check_;
    scenes::Context context_;
    scenes::Model model_;
    scenes::PointSet marks_;
    scenes::Renderer renderer_;
    hrbfnpr_style style_{};
    std::vector<Vec> queries_;
    std::vector<double> values_;
    std::vector<Vec> gradients_;
    std::vector<std::uint8_t> pixels_;
};

void measure() {
    const Samples samples = bumpy_torus();
    Pipeline one(1, samples);
    Pipeline all(0, samples);
    struct Stage {
        const char* name;
        void (Pipeline::*run)();
    };
    std::vector<std::pair<std::string, double>> results;
    for (const Stage& stage : {Stage{"fit", &Pipeline::fit}, Stage{"evaluate", &Pipeline::evaluate},
                               Stage{"generate", &Pipeline::generate}, Stage{"draw", &Pipeline::draw}}) {
        const bench::Comparison time = bench::compare(
            runs, [&] { (one.*stage.run)(); }, [&] { (all.*stage.run)(); });
        results.emplace_back(std::string(stage.name) + "_seconds", time.seconds);
        results.emplace_back(std::string(stage.name) + "_one_thread_ratio", time.ratio);
    }
    bench::report("threads", all.threads());
    bench::report("samples", rings * around);
    bench::report("queries", static_cast<double>(queries));
    bench::report("marks", all.marks());
    for (const auto& [name, value] : results) bench::report(name.c_str(), value);
}

} // namespace

int main() {
    try {
        measure();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
