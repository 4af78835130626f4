// SPDX-License-Identifier: MIT
// Lines of hatching: how evenly they lie, where they end and turn, beside strokes of the same length.
// --models=DIR: points to fit as well; --named=TEXT: only models that have it in their names.  --head=FILE: a PLY of
// points with normals to time frames of, else a generated surface.
#include "calls.h"
#include "hatch_frame.h"
#include "line_models.h"
#include "line_views.h"
#include "stroke_spacing.h"
#include "timing.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using bench::attribute;
using bench::generate;
using bench::one_layer;
using bench::operator-;
using bench::Vec3;

// The arrays of a set's only layer.
struct Strokes {
    explicit Strokes(const hrbfnpr_point_set* set)
        : position(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, count)),
          normal(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count)),
          direction(attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_DIRECTION, count)),
          stroke(attribute<std::uint32_t>(set, 0, HRBFNPR_MARK_ATTRIBUTE_STROKE, count)) {}
    [[nodiscard]] bool goes_on(std::size_t i) const { return i > 0 && stroke[2 * i] == stroke[2 * i - 2]; }
    [[nodiscard]] static Vec3 vec(const float* a, std::size_t i) { return {a[3 * i], a[3 * i + 1], a[3 * i + 2]}; }
    [[nodiscard]] std::size_t size() const { return static_cast<std::size_t>(count); }

    std::int64_t count = 0;
    const float *position, *normal, *direction;
    const std::uint32_t* stroke;
};

struct Found {
    double mean = 0.0, variation = 0.0, alone = 0.0; // of sideways distances, in separations
    double ends = 0.0;                               // in a length of 1000 separations
    double kinks = 0.0;                              // turns by more than 30 degrees within two separations, as ends
    double seconds = 0.0;
};

void measure_lines(const Strokes& strokes, double separation, Found& found) {
    double length = 0.0;
    double ends = 0.0;
    double kinks = 0.0;
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        if (!strokes.goes_on(i)) {
            ends += 2.0;
            continue;
        }
        const Vec3 leg = Strokes::vec(strokes.position, i) - Strokes::vec(strokes.position, i - 1);
        length += std::sqrt(bench::dot(leg, leg));
        double way = 0.0;
        for (std::size_t k = i; k > 0 && strokes.goes_on(k) && way < 2.0 * separation; --k) {
            const Vec3 step = Strokes::vec(strokes.position, k) - Strokes::vec(strokes.position, k - 1);
            way += std::sqrt(bench::dot(step, step));
            // By directions in the tangent plane of the one, so that the surface's own bend does not count.
            const Vec3 n = Strokes::vec(strokes.normal, i);
            Vec3 d = Strokes::vec(strokes.direction, k - 1);
            const double height = bench::dot(d, n);
            for (std::size_t c = 0; c < 3; ++c) d[c] -= height * n[c];
            const double cosine = bench::dot(Strokes::vec(strokes.direction, i), d) / std::sqrt(bench::dot(d, d));
            if (cosine < std::cos(30.0 * 3.14159265358979 / 180.0)) {
                kinks += 1.0;
                break;
            }
        }
    }
    found.ends = 1000.0 * ends * separation / length;
    found.kinks = 1000.0 * kinks * separation / length;
}

Found measure(hrbfnpr_context* context, const hrbfnpr_model* model, std::uint32_t kind, double separation) {
    auto desc = one_layer(kind, 0);
    desc.layer[0].separation = separation;
    Found found;
    const auto begin = std::chrono::steady_clock::now();
    const scenes::PointSet set = generate(context, model, desc);
    found.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    const Strokes strokes(set.get());
    const bench::Spacing spacing = bench::run_spacing(set.get(), {separation, 0.25, 12});
    found.mean = spacing.mean;
    found.variation = spacing.variation;
    found.alone = spacing.alone;
    measure_lines(strokes, separation, found);
    return found;
}

// Of two threads, so that machines can be compared.
void time_frames(const std::string& head) {
    const scenes::Context context = bench::make_context(2);
    const bench::Samples samples = head.empty() ? bench::bumpy(4096) : bench::read_ply(head);
    const scenes::Model model = bench::fit(context.get(), samples.points, samples.normals);
    const bench::HatchFrame frame = bench::HatchFrames(context.get(), model.get()).measure(40);
    bench::report("strokes.frame_ms", frame.hatching);
    bench::report("strokes.full_frame_ms", frame.marks);
    bench::report("strokes.frame_ratio", frame.ratio);
}

void print(const std::string& name, const char* kind, const Found& f) {
    std::printf("%-24s %-8s %8.3f %10.3f %8.2f%% %12.2f %12.2f %8.2f\n", name.c_str(), kind, f.mean, f.variation,
                100.0 * f.alone, f.ends, f.kinks, f.seconds);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    try {
        const std::string models = bench::option(argc, argv, "--models=");
        const std::string named = bench::option(argc, argv, "--named=");
        const scenes::Context context = bench::make_context();
        std::vector<bench::Source> sources = bench::generated_sources();
        if (!models.empty())
            for (bench::Source& source : bench::sources_of(models)) sources.push_back(std::move(source));
        std::printf("%-24s %-8s %8s %10s %9s %12s %12s %8s\n", "model", "lines", "spacing", "variation", "alone",
                    "ends / 1000", "kinks / 1000", "s");
        std::vector<double> variation, ends, before, ends_before, kinks;
        for (const bench::Source& source : sources) {
            if (!named.empty() && source.name.find(named) == std::string::npos) continue;
            const scenes::Model model = bench::fit_centres(context.get(), source.samples(), source.centres);
            const hrbfnpr_model_info info = bench::info_of(model.get());
            double squared = 0.0;
            for (int c = 0; c < 3; ++c) squared += std::pow(info.bounds_max[c] - info.bounds_min[c], 2.0);
            const double separation = 0.006 * std::sqrt(squared);
            const Found hatch = measure(context.get(), model.get(), HRBFNPR_LAYER_KIND_HATCH, separation);
            print(source.name, "hatch", hatch);
            const Found strokes = measure(context.get(), model.get(), HRBFNPR_LAYER_KIND_PRINCIPAL, separation);
            print(source.name, "strokes", strokes);
            variation.push_back(hatch.variation);
            before.push_back(strokes.variation);
            ends.push_back(hatch.ends);
            ends_before.push_back(strokes.ends);
            kinks.push_back(hatch.kinks);
        }
        if (variation.empty()) throw std::runtime_error("no model has that in its name");
        bench::report("strokes.spacing_variation", bench::quantile(variation, 0.5));
        bench::report("strokes.spacing_variation_max", *std::max_element(variation.begin(), variation.end()));
        bench::report("strokes.principal_variation", bench::quantile(before, 0.5));
        bench::report("strokes.ends_per_1000", bench::quantile(ends, 0.5));
        bench::report("strokes.principal_ends_per_1000", bench::quantile(ends_before, 0.5));
        bench::report("strokes.kinks_per_1000", bench::quantile(kinks, 0.5));
        time_frames(bench::option(argc, argv, "--head="));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench_strokes: %s\n", error.what());
        return 1;
    }
    return 0;
}
