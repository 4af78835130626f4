// SPDX-License-Identifier: MIT
// How even marks are: PUBLISHED, white noise and BLUE_NOISE at every prefix; tones, directions, spacing of lines.
// --bunny=FILE: an OBJ mesh; --head=FILE: a PLY of points with normals for the time of the order (default: a generated
// surface).
#include "analytic.h"
#include "calls.h"
#include "evenness.h"
#include "ramp_drawing.h"
#include "read_models.h"
#include "samples.h"
#include "scenes/shapes.h"
#include "stroke_spacing.h"
#include "timing.h"
#include "tone_ramp.h"

#include <cstdio>
#include <cstring>
#include <exception>
#include <numeric>
#include <string>

namespace {

using bench::attribute;
using bench::custom;
using bench::Evenness;
using bench::fit;
using bench::generate;
using bench::info_of;
using bench::Mark;
using bench::one_layer;
using bench::plane;
using bench::Samples;
using bench::sphere;
using bench::torus;
using bench::tube;
using bench::Vec3;
using bench::operator-;

constexpr double pi = 3.14159265358979323846;

struct Surface {
    const char* name;
    scenes::Model model;
    double area; // 0: use the library's estimate
    bool flat = false;
};

// Returns the marks by falling rank.
std::vector<Mark> ordered(const hrbfnpr_point_set* set) {
    std::int64_t count = 0;
    const float* position = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
    const float* normal = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_NORMAL, count);
    const float* rank = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_RANK, count);
    const hrbfnpr_point_set_info info = info_of(set);
    std::vector<std::size_t> order(static_cast<std::size_t>(count));
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank[a] > rank[b]; });
    std::vector<Mark> marks;
    for (const std::size_t i : order) {
        Mark mark{};
        for (std::size_t c = 0; c < 3; ++c) {
            mark.position[c] = info.origin[c] + double{position[3 * i + c]};
            mark.normal[c] = normal[3 * i + c];
        }
        marks.push_back(mark);
    }
    return marks;
}

struct Worst {
    Evenness evenness{1e9, 1e9, 0.0};
    double power = 0.0; // flat surfaces only

    void take(const Evenness& e, double p) {
        evenness.relative_radius = std::min(evenness.relative_radius, e.relative_radius);
        evenness.mean_nearest = std::min(evenness.mean_nearest, e.mean_nearest);
        evenness.low_frequency = std::max(evenness.low_frequency, e.low_frequency);
        power = std::max(power, p);
    }
};

// Measures the prefixes of each twentieth of the marks.
Worst measure(const char* surface, const char* scheme, const std::vector<Mark>& marks, double area, bool flat,
              const std::vector<Mark>& places) {
    Worst worst;
    for (std::size_t k = 1; k <= 20; ++k) {
        const std::size_t count = marks.size() * k / 20;
        const bench::Window window{flat};
        double density = static_cast<double>(count) / area;
        if (flat) {
            const auto inside = std::count_if(marks.begin(), marks.begin() + static_cast<std::ptrdiff_t>(count),
                                              [&](const Mark& m) { return window.holds(m.position, 0.0); });
            density = static_cast<double>(inside) / 4.0;
        }
        Evenness evenness;
        bench::measure_distances(marks, count, density, window, evenness);
        bench::measure_low_frequencies(marks, count, density, places, window, evenness);
        const double power = flat ? bench::windowed_power(marks, count, density) : 0.0;
        worst.take(evenness, power);
        if (k != 1 && k != 5 && k != 10 && k != 20) continue;
        std::printf("%-8s %-12s %4zu %% %9zu %9.3f %9.3f %9.3f", surface, scheme, 5 * k, count,
                    evenness.relative_radius, evenness.mean_nearest, evenness.low_frequency);
        std::printf(flat ? " %9.3f\n" : "\n", power);
    }
    std::printf("%-8s %-12s  worst           %9.3f %9.3f %9.3f", surface, scheme, worst.evenness.relative_radius,
                worst.evenness.mean_nearest, worst.evenness.low_frequency);
    std::printf(flat ? " %9.3f\n" : "\n", worst.power);
    std::fflush(stdout);
    return worst;
}

constexpr std::int64_t measured_marks = 20000;

struct Sets {
    std::vector<Mark> blue, white, paper;
};

Sets sets_on(hrbfnpr_context* context, const Surface& surface, double& area) {
    Sets sets;
    const scenes::PointSet blue =
        generate(context, surface.model.get(), one_layer(HRBFNPR_LAYER_KIND_STIPPLES, measured_marks));
    sets.blue = ordered(blue.get());
    const double spacing = info_of(blue.get()).spacing;
    if (area <= 0.0) area = spacing * spacing * static_cast<double>(sets.blue.size());
    // A random sixteenth of far denser marks is independent on all relevant scales.
    const scenes::PointSet dense =
        generate(context, surface.model.get(), one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 16 * measured_marks));
    sets.white = ordered(dense.get());
    std::mt19937_64 random(1);
    std::shuffle(sets.white.begin(), sets.white.end(), random);
    sets.white.resize(static_cast<std::size_t>(measured_marks));
    bench::Generation desc = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 0);
    desc.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
    desc.seed_source = HRBFNPR_SEED_BOX;
    desc.box_resolution = 8;
    desc.layer[0].levels = 3;
    desc.layer[0].budget = measured_marks;
    sets.paper = ordered(generate(context, surface.model.get(), desc).get());
    return sets;
}

struct Totals {
    double radius = 1e9, nearest = 1e9, low = 0.0;
};

void run_surface(hrbfnpr_context* context, const Surface& surface, Totals& totals) {
    double area = surface.area;
    const Sets sets = sets_on(context, surface, area);
    std::vector<Mark> places;
    for (std::size_t i = 0; i < sets.white.size(); i += 2) places.push_back(sets.white[i]);
    measure(surface.name, "PUBLISHED", sets.paper, area, surface.flat, places);
    measure(surface.name, "white noise", std::vector<Mark>(sets.white.begin(), sets.white.end()), area, surface.flat,
            {places.rbegin(), places.rend()});
    const Worst worst = measure(surface.name, "BLUE_NOISE", sets.blue, area, surface.flat, places);
    totals.radius = std::min(totals.radius, worst.evenness.relative_radius);
    totals.nearest = std::min(totals.nearest, worst.evenness.mean_nearest);
    totals.low = std::max({totals.low, worst.evenness.low_frequency, worst.power});
}

// ---- Tone ----------------------------------------------------------------------------------

constexpr double darkest = 0.60; // coverage by all marks

std::int32_t ramp_tone(void*, std::int64_t count, const float* positions, const float*, float* tau) {
    for (std::int64_t i = 0; i < count; ++i) {
        const double x = bench::ramp_column(positions[3 * i]);
        tau[i] = static_cast<float>(1.0 - std::clamp(bench::asked(x), 0.0, darkest) / darkest);
    }
    return 0;
}

// Returns the error of the order alone: the tone is the share of marks, each drawn in full.
bench::ToneError error_of(hrbfnpr_context* context, const hrbfnpr_point_set* set) {
    bench::Style style = bench::ramp_style(ramp_tone);
    style.tone_curve = HRBFNPR_TONE_CURVE_LINEAR;
    style.tone_fade = 0.0F;
    return bench::tone_error(bench::drawn_ramp(context, set, style));
}

bench::ToneError run_tone(hrbfnpr_context* context) {
    const scenes::Model model = custom(context, plane, {2.2, 1.2, 0.4});
    const double pixel = 4.0 / bench::ramp_width;
    const std::int64_t budget = bench::ramp_budget(context, model.get(), darkest);
    bench::Generation desc = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, budget);
    const scenes::PointSet blue = generate(context, model.get(), desc);
    const double spacing = info_of(blue.get()).spacing / pixel;
    std::printf("\ntone ramp 0.05 to 0.55, %lld marks of 1.5 px, coverage of all %.3f\n",
                static_cast<long long>(budget), pi * 2.25 / (spacing * spacing));
    const bench::ToneError error = error_of(context, blue.get());
    std::printf("%-12s psnr %.2f dB, bias %+.4f\n", "BLUE_NOISE", error.psnr, error.bias);
    desc.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
    desc.seed_source = HRBFNPR_SEED_BOX;
    desc.layer[0].levels = 5;
    const bench::ToneError paper = error_of(context, generate(context, model.get(), desc).get());
    std::printf("%-12s psnr %.2f dB, bias %+.4f\n", "PUBLISHED", paper.psnr, paper.bias);
    return error;
}

// ---- Lines of hatching -------------------------------------------------------------------------------

struct Directions {
    double mean, most; // degrees; most: of 95 % of the marks
};

// Compares DIRECTION with the nearer of a torus's meridian and parallel.
Directions run_directions(const hrbfnpr_point_set* set) {
    std::int64_t count = 0;
    const float* position = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, count);
    const float* direction = attribute<float>(set, 0, HRBFNPR_MARK_ATTRIBUTE_DIRECTION, count);
    const hrbfnpr_point_set_info info = info_of(set);
    std::vector<double> errors;
    for (std::int64_t i = 0; i < count; ++i) {
        const double x = info.origin[0] + double{position[3 * i]};
        const double y = info.origin[1] + double{position[3 * i + 1]};
        const double ring = std::hypot(x, y);
        const double along = std::abs((-y * double{direction[3 * i]} + x * double{direction[3 * i + 1]}) / ring);
        const double angle = std::acos(std::min(1.0, along)) * 180.0 / pi;
        errors.push_back(std::min(angle, 90.0 - angle));
    }
    std::sort(errors.begin(), errors.end());
    return {std::accumulate(errors.begin(), errors.end(), 0.0) / static_cast<double>(errors.size()),
            errors[errors.size() * 95 / 100]};
}

struct StrokeTotals {
    Directions directions{};
    double variation = 0.0;
};

StrokeTotals run_strokes(hrbfnpr_context* context, const std::vector<Surface>& surfaces) {
    StrokeTotals totals;
    std::printf("\nlines of 100 000 marks: sideways distance to the next parallel one\n");
    std::printf("%-12s %10s %10s %10s\n", "surface", "mean", "variation", "alone");
    const scenes::Samples samples = scenes::torus(4096);
    const scenes::Model fitted = fit(context, samples.points, samples.normals);
    const auto row = [&](const char* name, const hrbfnpr_model* model) {
        const scenes::PointSet set = generate(context, model, one_layer(HRBFNPR_LAYER_KIND_HATCH, 100000));
        const bench::Spacing s = bench::run_spacing(set.get(), {bench::layer_info(set.get(), 0).step, 0.25, 12});
        std::printf("%-12s %10.3f %10.3f %9.2f%%\n", name, s.mean, s.variation, 100.0 * s.alone);
        totals.variation = std::max(totals.variation, s.variation);
        return run_directions(set.get());
    };
    totals.directions = row("fitted torus", fitted.get());
    for (const Surface& surface : surfaces)
        if (!surface.flat) row(surface.name, surface.model.get());
    std::printf("directions on the fitted torus: mean error %.4f degrees, 95 %% below %.4f\n", totals.directions.mean,
                totals.directions.most);
    return totals;
}

// ---- Time ----------------------------------------------------------------------------------

struct OrderTime {
    double warm, cold;
};

OrderTime run_time(hrbfnpr_context* context, const Samples& samples) {
    constexpr std::int64_t marks = 512000;
    bench::Generation paper = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, 0);
    paper.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
    paper.seed_source = HRBFNPR_SEED_SAMPLES;
    paper.layer[0].levels = 3;
    const bench::Generation blue = one_layer(HRBFNPR_LAYER_KIND_STIPPLES, marks);
    const auto first = [&](const bench::Generation& desc) {
        const scenes::Model model = fit(context, samples.points, samples.normals);
        return bench::seconds([&] { generate(context, model.get(), desc); });
    };
    const double first_paper = first(paper);
    const double first_blue = first(blue);
    const scenes::Model model = fit(context, samples.points, samples.normals);
    const auto run = [&](const bench::Generation& desc) { return [&] { generate(context, model.get(), desc); }; };
    const bench::Comparison c = bench::compare(5, run(blue), run(paper));
    std::printf(
        "\n%lld marks: first call PUBLISHED %.3f s, BLUE_NOISE %.3f s; later PUBLISHED %.3f s, BLUE_NOISE %.3f s\n",
        static_cast<long long>(marks), first_paper, first_blue, c.seconds, c.seconds * c.ratio);
    return {c.ratio, first_blue / first_paper};
}

void run(const std::string& bunny, const std::string& head, bool only_marks) {
    const scenes::Context context = bench::make_context();
    hrbfnpr_context* raw = context.get();
    std::vector<Surface> surfaces;
    surfaces.push_back({"flat", custom(raw, plane, {1.1, 1.1, 0.3}), 0.0, true});
    surfaces.push_back({"sphere", custom(raw, sphere, {1.0, 1.0, 1.0}), 4.0 * pi, false});
    surfaces.push_back({"torus", custom(raw, torus, {1.0 + tube, 1.0 + tube, tube}), 4.0 * pi * pi * tube, false});
    const Samples points = bunny.empty() ? bench::bumpy(2500, 0.15) : bench::read_obj(bunny);
    surfaces.push_back({bunny.empty() ? "bumpy" : "bunny", fit(raw, points.points, points.normals), 0.0, false});
    std::printf("%-8s %-12s %6s %9s %9s %9s %9s %9s\n", "surface", "marks", "prefix", "count", "radius", "nearest",
                "low", "power");
    Totals totals;
    for (const Surface& surface : surfaces) run_surface(raw, surface, totals);
    const bench::ToneError tone = run_tone(raw);
    StrokeTotals strokes;
    OrderTime time{};
    if (!only_marks) {
        strokes = run_strokes(raw, surfaces);
        time = run_time(raw, head.empty() ? bench::bumpy(4096, 0.15) : bench::read_ply(head));
    }
    std::printf("\n");
    bench::report("quality.rho_min", totals.radius);
    bench::report("quality.mean_nn_min", totals.nearest);
    bench::report("quality.low_frequency_max", totals.low);
    bench::report("quality.tone_psnr_db", tone.psnr);
    bench::report("quality.tone_bias", tone.bias);
    if (only_marks) return;
    bench::report("quality.direction_mean_deg", strokes.directions.mean);
    bench::report("quality.direction_95_deg", strokes.directions.most);
    bench::report("quality.stroke_variation_max", strokes.variation);
    bench::report("quality.order_time_ratio_first", time.cold);
    bench::report("quality.order_time_ratio", time.warm);
}

} // namespace

int main(int argc, char** argv) try {
    run(bench::option(argc, argv, "--bunny="), bench::option(argc, argv, "--head="),
        std::any_of(argv + 1, argv + argc, [](const char* a) { return std::strcmp(a, "--marks") == 0; }));
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
}
