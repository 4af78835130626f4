// SPDX-License-Identifier: MIT
// Frames of hatching against frames of stipples and lines with about as many marks, all as dots, on an orbit.
#pragma once

#include "line_calls.h"
#include "painter.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

namespace bench {

// Both times are in milliseconds.
struct HatchFrame {
    double hatching = 0.0, marks = 0.0, ratio = 0.0;
};

class HatchFrames {
public:
    HatchFrames(hrbfnpr_context* context, const hrbfnpr_model* model)
        : stipples_(stippled(context, model)), lines_(hatched(context, model)), orbit_(stipples_.get(), width, height),
          before_(context, stipples_.get(), dotted(), width, height),
          after_(context, lines_.get(), Style(HRBFNPR_PRESET_ETCHING), width, height) {}

    // Draws both in turn, at a new angle each time; the first frames do not count.
    [[nodiscard]] HatchFrame measure(int frames) {
        constexpr int warm = 4;
        std::vector<double> hatching, marks, ratios;
        for (int frame = -warm; frame < frames; ++frame) {
            const hrbfnpr_camera camera = orbit_.at(step * (frame + warm));
            const double old = 1e3 * seconds([&] { before_.draw(camera); });
            const double now = 1e3 * seconds([&] { after_.draw(camera); });
            if (frame < 0) continue;
            marks.push_back(old);
            hatching.push_back(now);
            ratios.push_back(now / old);
        }
        print("dots", before_, stipples_.get());
        print("etching", after_, lines_.get());
        return {median(hatching), median(marks), median(ratios)};
    }

private:
    static constexpr int width = 1280, height = 720;
    static constexpr std::int64_t most_marks = 700'000;
    static constexpr double step = 0.5;    // degrees from one frame to the next
    static constexpr double lines = 300.0; // lines of each layer per square root of the area

    // Draws all marks as dots of the same pen, but the marks of lines only in the dark parts.
    static Style dotted() {
        Style style = full_of_dots();
        for (hrbfnpr_layer_style& layer : style.layer)
            if (layer.kind == HRBFNPR_LAYER_KIND_STIPPLES) layer.radius = layer.share = 1.0F;
        return style;
    }
    static scenes::PointSet stippled(hrbfnpr_context* context, const hrbfnpr_model* model) {
        Generation desc = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, most_marks / 2);
        desc.add(HRBFNPR_LAYER_KIND_HATCH, most_marks / 2);
        return generate(context, model, desc);
    }
    // A few stipples show how large the surface is.
    static scenes::PointSet hatched(hrbfnpr_context* context, const hrbfnpr_model* model) {
        constexpr std::int64_t few = 2000;
        const scenes::PointSet probe = generate(context, model, one_layer(HRBFNPR_LAYER_KIND_STIPPLES, few));
        const double area = few * std::pow(info_of(probe.get()).spacing, 2.0);
        std::int64_t count = 0;
        const hrbfnpr_layer_desc* layers = hrbfnpr_preset_layers(HRBFNPR_PRESET_ETCHING, &count);
        Generation desc;
        for (std::int64_t i = 0; i < count; ++i) {
            desc.layer.push_back(layers[i]);
            const bool hatching = layers[i].kind == HRBFNPR_LAYER_KIND_HATCH;
            desc.layer.back().budget = hatching ? 0 : most_marks / 7;
            if (hatching) desc.layer.back().separation = std::sqrt(area) / lines;
        }
        return generate(context, model, desc);
    }

    // Returns the ink of the picture, in black pixels.
    static double ink(const Painter& painter) {
        double sum = 0.0;
        const std::vector<std::uint8_t>& pixels = painter.pixels();
        for (std::size_t i = 0; i < pixels.size(); i += 4) sum += 255.0 - pixels[i];
        return sum / 255.0;
    }

    static void print(const char* name, Painter& painter, const hrbfnpr_point_set* set) {
        const hrbfnpr_drawing_info info = painter.info();
        std::printf("%-8s %7lld marks, ink of %.0f pixels: gather %.2f, bins and strokes %.2f, depth layers %.2f, "
                    "image %.2f ms\n",
                    name, static_cast<long long>(info.marks), ink(painter),
                    1e-6 * static_cast<double>(info.nanoseconds_classify),
                    1e-6 * static_cast<double>(info.nanoseconds_sort),
                    1e-6 * static_cast<double>(info.nanoseconds_visibility), painter.image_ms());
        for (std::int64_t i = 0; i < info_of(set).layers; ++i)
            std::printf("    layer %lld: kind %u, %lld marks\n", static_cast<long long>(i), layer_info(set, i).kind,
                        static_cast<long long>(layer_info(set, i).marks));
    }

    scenes::PointSet stipples_, lines_;
    Orbit orbit_;
    Painter before_, after_;
};

} // namespace bench
