// SPDX-License-Identifier: MIT
// Points on the surface, from samples: the article's Table 1 against ours, marks per second, evaluation against plain
// sums, and rays against the march.
// --models=DIR: a folder of PLY files with normals (head_4096.ply, ...) instead of generated surfaces.
#include "calls.h"
#include "peak.h"
#include "rays.h"
#include "read_models.h"
#include "samples.h"
#include "timing.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace {

using bench::bumpy;
using bench::read_ply;
using bench::Samples;

Samples axes() {
    Samples samples;
    for (std::size_t c = 0; c < 3; ++c)
        for (const double sign : {1.0, -1.0}) {
            std::array<double, 3> p{};
            p[c] = sign;
            samples.add(p, p);
        }
    return samples;
}

scenes::Model fit(hrbfnpr_context* context, const Samples& samples) {
    return bench::fit(context, samples.points, samples.normals);
}

struct Job {
    std::uint32_t kind;
    std::int32_t levels;
    std::uint32_t guide = HRBFNPR_HATCH_GUIDE_CURVATURE; // for strokes
};

// Returns the number of marks; -1 if cancelled.
std::int64_t generate(hrbfnpr_context* context, const hrbfnpr_model* model, const Samples& seeds, const Job& job,
                      hrbfnpr_operation* operation = nullptr) {
    scenes::Check check;
    bench::Generation desc = bench::one_layer(job.kind, 0);
    desc.distribution = HRBFNPR_DISTRIBUTION_PUBLISHED;
    desc.seed_source = HRBFNPR_SEED_POINTS;
    desc.seed_points = bench::view(seeds.points);
    desc.layer[0].levels = job.levels;
    desc.layer[0].guide = job.guide;
    hrbfnpr_point_set* raw = nullptr;
    const hrbfnpr_status status =
        hrbfnpr_point_set_generate(context, model, desc.get(), operation, &raw, check.error());
    if (status == HRBFNPR_STATUS_CANCELLED) return -1;
    check(status);
    const scenes::PointSet set(raw);
    hrbfnpr_array positions{};
    check(hrbfnpr_point_set_view(raw, 0, HRBFNPR_MARK_ATTRIBUTE_POSITION, &positions, check.error()));
    return positions.count;
}

struct Row {
    const char* name;
    const char* file; // null: generated samples
    std::int64_t samples;
    Job stipples; // levels < 0: none
    Job strokes;
    double published; // total seconds in the article
};

void run_table(hrbfnpr_context* context, const std::string& models) {
    constexpr std::uint32_t stipple = HRBFNPR_LAYER_KIND_STIPPLES;
    constexpr std::uint32_t hatch = HRBFNPR_LAYER_KIND_HATCH;
    constexpr std::uint32_t combing = HRBFNPR_HATCH_GUIDE_COMBING;
    constexpr std::uint32_t curvature = HRBFNPR_HATCH_GUIDE_CURVATURE;
    const std::vector<Row> rows{
        {"sphere", "sphere_6.ply", 6, {stipple, 4}, {hatch, 4, combing}, 8.3},
        {"tori", "tori_256.ply", 256, {stipple, 3}, {hatch, 4, combing}, 217.9},
        {"canyon", "canyon_512.ply", 512, {stipple, 3}, {hatch, 4, combing}, 570.0},
        {"knot", "knot_1024.ply", 1024, {stipple, 3}, {hatch, 3, curvature}, 1100.0},
        {"gargoyle", "gargoyle_2500.ply", 2500, {stipple, 3}, {hatch, -1, combing}, 2036.0},
        {"david", "head_4096.ply", 4096, {stipple, 3}, {hatch, 3, curvature}, 7397.0},
    };
    std::printf("%-10s %8s %9s %9s %12s %9s %9s\n", "model", "samples", "stipples", "marks", "published s", "ours s",
                "ratio");
    for (const Row& row : rows) {
        const Samples samples = row.samples == 6 ? axes()
                                : models.empty() ? bumpy(row.samples, 0.15)
                                                 : read_ply(models + "/" + row.file);
        // The sphere's seeds: 607 500 marks are 2 * 81 for each of 3750 stipples.
        const Samples seeds = row.samples == 6 ? bumpy(3750, 0.0) : samples;
        std::int64_t stipples = 0;
        std::int64_t marks = 0;
        double fitted = 0.0;
        double stippled = 0.0;
        double all = 0.0;
        all = bench::seconds([&] {
            scenes::Model model;
            fitted = bench::seconds([&] { model = fit(context, samples); });
            stippled = bench::seconds([&] {
                if (row.stipples.levels >= 0) stipples = generate(context, model.get(), samples, row.stipples);
            });
            if (row.strokes.levels >= 0) marks = generate(context, model.get(), seeds, row.strokes);
        });
        std::printf("%-10s %8lld %9lld %9lld %12.1f %9.3f %9.0f   (fit %.3f s; stipples %.3f s, %.0f a second; strokes "
                    "%.3f s, %.0f marks a second)\n",
                    row.name, static_cast<long long>(samples.count()), static_cast<long long>(stipples),
                    static_cast<long long>(marks), row.published, all, row.published / all, fitted, stippled,
                    static_cast<double>(stipples) / stippled, all - fitted - stippled,
                    static_cast<double>(marks) / (all - fitted - stippled));
        std::fflush(stdout);
        const std::string name = std::string("table1.") + row.name;
        bench::report((name + ".seconds").c_str(), all);
        bench::report((name + ".ratio_published").c_str(), row.published / all);
    }
}

// Returns random places within about half a spacing of samples.
std::vector<double> places_near(const Samples& samples, std::int64_t count) {
    std::vector<double> places;
    const double spacing = std::sqrt(12.6 / static_cast<double>(samples.count()));
    std::uint64_t state = 1;
    const auto random = [&] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return static_cast<double>(state >> 11U) * 0x1p-53;
    };
    for (std::int64_t k = 0; k < count; ++k) {
        const auto i = static_cast<std::size_t>(random() * static_cast<double>(samples.count()));
        for (std::size_t c = 0; c < 3; ++c) places.push_back(samples.points[3 * i + c] + spacing * (random() - 0.5));
    }
    return places;
}

// Returns the seconds for f and its gradient.
double evaluate(const hrbfnpr_model* model, const std::vector<double>& places, std::int64_t count,
                std::vector<double>& results) {
    scenes::Check check;
    results.resize(places.size() / 3 * 4);
    const hrbfnpr_array points{places.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    const hrbfnpr_array_out value{results.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 1};
    const hrbfnpr_array_out gradient{results.data() + count, count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    return bench::seconds(
        [&] { check(hrbfnpr_model_evaluate(model, &points, &value, &gradient, nullptr, nullptr, check.error())); });
}

double best_of(int runs, const hrbfnpr_model* model, const std::vector<double>& places, std::int64_t count,
               std::vector<double>& results) {
    double best = evaluate(model, places, count, results);
    for (int run = 1; run < runs; ++run) best = std::min(best, evaluate(model, places, count, results));
    return best;
}

// The operations of the direct sums, counted by hand: 44 for a pair, a fused multiply-add being two.
constexpr double flops_of_pair = 44.0;

void run_evaluation(hrbfnpr_context* context) {
    constexpr std::int64_t many = 1000000;
    constexpr std::int64_t some = 50000; // few enough to be summed over all centres
    constexpr std::int64_t few = 500;
    const scenes::Context plain_context = bench::make_context(1, HRBFNPR_INSTRUCTION_SET_BASELINE);
    const double peak = bench::peak_flops(static_cast<int>(std::thread::hardware_concurrency()));
    std::vector<double> results;
    double seconds_4096 = 0.0;
    for (const std::int64_t count : {256, 1024, 4096, 16384, 65536}) {
        const Samples samples = bumpy(count, 0.15);
        const scenes::Model model = fit(context, samples);
        const std::vector<double> places = places_near(samples, many);
        const double direct = best_of(3, model.get(), places, some, results) * many / some;
        const double first = evaluate(model.get(), places, many, results);
        const double prepared = best_of(3, model.get(), places, many, results);
        std::printf("evaluate %6lld centres: 1 M points in %.3f s, %.3f s the first time; over all centres %.3f s\n",
                    static_cast<long long>(count), prepared, first, direct);
        std::fflush(stdout);
        const std::string name = "evaluate." + std::to_string(count);
        bench::report((name + ".seconds").c_str(), prepared);
        bench::report((name + ".ratio_direct_simd").c_str(), direct / prepared);
        if (count > 4096) bench::report((name + ".over_4096").c_str(), prepared / seconds_4096);
        if (count != 4096) continue;
        seconds_4096 = prepared;
        bench::report("evaluate.direct.fraction_of_peak",
                      flops_of_pair * static_cast<double>(count) * many / direct / peak);
        const scenes::Model plain = fit(plain_context.get(), samples);
        const double reference = best_of(2, plain.get(), places, few, results) * many / few;
        bench::report("evaluate.4096.ratio_plain", reference / prepared);
    }
}

// Measures the same number of marks from the same seeds on surfaces with more and more centres.
void run_growth(hrbfnpr_context* context) {
    const Samples seeds = bumpy(4000, 0.15);
    double first = 0.0;
    for (const std::int64_t count : {256, 1024, 4096, 16384, 65536}) {
        const scenes::Model model = fit(context, bumpy(count, 0.15));
        std::int64_t marks = 0;
        const double seconds = bench::seconds([&] {
            marks = generate(context, model.get(), seeds, {HRBFNPR_LAYER_KIND_STIPPLES, 3});
        });
        const double again = bench::seconds([&] {
            marks = generate(context, model.get(), seeds, {HRBFNPR_LAYER_KIND_STIPPLES, 3});
        });
        if (count == 256) first = again;
        std::printf("%lld marks on %lld centres: %.3f s, then %.3f s, %.0f marks a second\n",
                    static_cast<long long>(marks), static_cast<long long>(count), seconds, again,
                    static_cast<double>(marks) / again);
        std::fflush(stdout);
        const std::string name = "marks." + std::to_string(count);
        bench::report((name + ".seconds").c_str(), seconds);
        bench::report((name + ".over_256").c_str(), again / first);
    }
}

// Reports the longest time from a cancellation to the call's return, over generations that are cancelled later and
// later.
void run_cancelling(hrbfnpr_context* context) {
    const Samples samples = bumpy(4096, 0.15);
    const scenes::Model warm = fit(context, samples);
    const double all = bench::seconds([&] {
        generate(context, warm.get(), samples, {HRBFNPR_LAYER_KIND_STIPPLES, 3});
    });
    double worst = 0.0;
    constexpr int cancels = 40;
    for (int k = 0; k < cancels; ++k) {
        const scenes::Model model = fit(context, samples); // nothing is prepared yet
        scenes::Check check;
        hrbfnpr_operation* operation = nullptr;
        check(hrbfnpr_operation_create(context, &operation, check.error()));
        std::chrono::steady_clock::time_point cancelled;
        std::thread canceller([&] {
            std::this_thread::sleep_for(std::chrono::duration<double>(all * (k + 0.5) / cancels));
            cancelled = std::chrono::steady_clock::now();
            hrbfnpr_operation_cancel(operation);
        });
        const bool ended = generate(context, model.get(), samples, {HRBFNPR_LAYER_KIND_STIPPLES, 3}, operation) < 0;
        const auto returned = std::chrono::steady_clock::now();
        canceller.join();
        hrbfnpr_operation_release(operation);
        if (ended) worst = std::max(worst, std::chrono::duration<double>(returned - cancelled).count());
    }
    bench::report("generate.cancel_ms_max", 1e3 * worst);
}

} // namespace

int main(int argc, char** argv) {
    try {
        const std::string models = bench::option(argc, argv, "--models=");
        const scenes::Context context = bench::make_context();
        run_evaluation(context.get());
        bench::run_rays(context.get());
        run_growth(context.get());
        run_cancelling(context.get());
        run_table(context.get(), models);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
