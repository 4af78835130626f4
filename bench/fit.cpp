// SPDX-License-Identifier: MIT
// Fits of a bumpy closed surface by the iterative solver: seconds, memory and residuals against the number of samples;
// compared with the direct solver, LAPACK if it is installed, and the processor's peak; and the cost of TRIM_AUTO.
// --large: up to a million samples; --trim: only the cost of TRIM_AUTO.
#include "lapack.h"
#include "peak.h"
#include "samples.h"
#include "support/handles.h"
#include "timing.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <exception>
#include <string>
#include <thread>
#include <vector>

namespace {

using bench::Samples;

struct Fit {
    hrbfnpr_model_info info{};
    double peak_mb = 0.0; // peak memory of the fit
};

Fit fit(const Samples& samples, std::uint32_t solver, std::uint32_t trim = HRBFNPR_TRIM_AUTO) {
    scenes::Check check;
    hrbfnpr_context* raw_context = nullptr;
    check(hrbfnpr_context_create(nullptr, &raw_context, check.error()));
    const scenes::Context context(raw_context);
    hrbfnpr_fit_desc desc;
    check(hrbfnpr_fit_desc_init(&desc, sizeof desc));
    const auto count = static_cast<std::int64_t>(samples.points.size() / 3);
    desc.points = {samples.points.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    desc.normals = {samples.normals.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    desc.solver = solver;
    desc.trim = trim;
    hrbfnpr_model* raw_model = nullptr;
    check(hrbfnpr_model_fit(context.get(), &desc, nullptr, &raw_model, check.error()));
    const scenes::Model model(raw_model);
    Fit result;
    check(hrbfnpr_model_info_init(&result.info, sizeof result.info));
    check(hrbfnpr_model_get_info(model.get(), &result.info, check.error()));
    result.peak_mb = static_cast<double>(result.info.peak_bytes) / 1e6;
    return result;
}

// Returns the fastest of a few runs.
Fit best_fit(const Samples& samples, std::uint32_t solver, int runs) {
    Fit best = fit(samples, solver);
    for (int run = 1; run < runs; ++run) {
        const Fit again = fit(samples, solver);
        if (again.info.seconds_total < best.info.seconds_total) best = again;
    }
    return best;
}

// Counts the operations of the pairwise products and of the preconditioner's setup: 37 for a pair; for a sample with k
// neighbours, a Cholesky factorisation of 4 k numbers and 4 columns of its inverse.
double flops_at_least(const hrbfnpr_model_info& info) {
    const double n = static_cast<double>(info.centres);
    constexpr double rows = 4.0 * 16.0;
    return (info.iterations + 1) * 37.0 * n * n + n * (rows * rows * rows / 3.0 + 8.0 * rows * rows);
}

void print_row(std::int64_t count, const Fit& f, double direct) {
    std::printf("%8lld %9.4f s %5d iterations %8.1f MB  residual %.1e  max f %.1e  gradient %.1e",
                static_cast<long long>(count), f.info.seconds_total, static_cast<int>(f.info.iterations), f.peak_mb,
                f.info.solver_residual, f.info.value_residual_max, f.info.gradient_residual_max);
    if (direct > 0.0) std::printf("  %8.1f x faster than DIRECT", direct / f.info.seconds_total);
    std::printf("\n");
    std::fflush(stdout);
}

void report(const std::string& name, double value) { bench::report(name.c_str(), value); }

// Returns the slope of log seconds over log N, by least squares.
double growth_exponent(const std::vector<std::array<double, 2>>& points) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    for (const auto& p : points) {
        x += std::log(p[0]);
        y += std::log(p[1]);
        xx += std::log(p[0]) * std::log(p[0]);
        xy += std::log(p[0]) * std::log(p[1]);
    }
    const double n = static_cast<double>(points.size());
    return (n * xy - x * y) / (n * xx - x * x);
}

// Returns the processor time of a fit.
double cost(const Samples& samples, std::uint32_t trim) {
    const std::clock_t start = std::clock();
    (void)fit(samples, HRBFNPR_SOLVER_AUTO, trim);
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

// Returns the relative extra cost of a fit that looks for the end of a closed surface: medians of alternating runs.
double cost_of_trim(const Samples& samples, int runs) {
    std::vector<double> never, automatic;
    for (int run = 0; run < runs; ++run) {
        never.push_back(cost(samples, HRBFNPR_TRIM_NEVER));
        automatic.push_back(cost(samples, HRBFNPR_TRIM_AUTO));
    }
    return bench::median(automatic) / bench::median(never) - 1.0;
}

void run_trim() {
    std::printf("TRIM_AUTO beside a fit without it, processor time:\n");
    for (const std::int64_t count : {250, 1000, 4096, 20000, 100000}) {
        const Samples samples = bench::bumpy(count, 0.15);
        report("fit." + std::to_string(count) + ".trim", cost_of_trim(samples, count <= 4096 ? 21 : 1));
    }
}

void run(bool large) {
    std::vector<std::int64_t> sizes{256, 1024, 4096, 16384, 65536};
    if (large) sizes.insert(sizes.end(), {262144, 1000000});
    const bench::Lapack lapack;
    const double peak = bench::peak_flops(static_cast<int>(std::thread::hardware_concurrency()));
    std::vector<std::array<double, 2>> growth;
    std::vector<std::pair<std::string, double>> lines;
    double seconds_4096 = 0.0;
    for (const std::int64_t count : sizes) {
        const Samples samples = bench::bumpy(count, 0.15);
        const Fit f = best_fit(samples, HRBFNPR_SOLVER_ITERATIVE, count <= 4096 ? 5 : count <= 16384 ? 3 : 1);
        const double direct = count <= 1024 ? fit(samples, HRBFNPR_SOLVER_DIRECT).info.seconds_total : 0.0;
        print_row(count, f, direct);
        const std::string name = "fit." + std::to_string(count);
        if (count == 4096) seconds_4096 = f.info.seconds_total;
        if (count >= 4096) growth.push_back({static_cast<double>(count), f.info.seconds_total});
        lines.emplace_back(name + ".seconds", f.info.seconds_total);
        lines.emplace_back(name + ".iterations", f.info.iterations);
        lines.emplace_back(name + ".peak_mb", f.peak_mb);
        lines.emplace_back(name + ".residual", f.info.solver_residual);
        if (direct > 0.0) lines.emplace_back(name + ".ratio_direct", direct / f.info.seconds_total);
        if (count == 4096)
            lines.emplace_back(name + ".fraction_of_limit", flops_at_least(f.info) / peak / f.info.seconds_total);
        if (count > 4096) lines.emplace_back(name + ".over_4096", f.info.seconds_total / seconds_4096);
        if (count == 1024 && lapack.found())
            lines.emplace_back(name + ".ratio_dsysv", lapack.indefinite_seconds(4 * 1024 + 4) / f.info.seconds_total);
    }
    if (lapack.found()) {
        std::printf("baselines: %s\n", lapack.name());
        lines.emplace_back("fit.4096.ratio_nullspace_cholesky", lapack.cholesky_seconds(4 * 4096 - 4) / seconds_4096);
        if (large) lines.emplace_back("fit.4096.ratio_dsysv", lapack.indefinite_seconds(4 * 4096 + 4) / seconds_4096);
    } else {
        std::printf("no LAPACK found: its ratios are left out; install libopenblas0\n");
    }
    std::printf("peak: %.0f GF/s\n\n", peak / 1e9);
    for (const auto& [name, value] : lines) report(name, value);
    report("fit.growth_exponent", growth_exponent(growth));
}

} // namespace

int main(int argc, char** argv) {
    try {
        const std::string option = argc > 1 ? argv[1] : "";
        if (option != "--trim") run(option == "--large");
        run_trim();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 1;
    }
}
