// SPDX-License-Identifier: MIT
// Normals of points without normals: how many are right, how far their directions are off, and how long it takes.
//
//   bench_orient [--models=DIR] [--named=TEXT] [--only=clean,noisy,curves,bound,times] [--noise=0.01]
//                [--seed=N] [--large]
//
// Clouds are those of orient_shapes.h and, with --models, the PLY files of a folder, whose normals are only compared
// with.  bound: how right an estimator that knows the surface is on noisy points (orient_bound.h).  The sign of an open
// sheet as a whole is a convention, not a property of the surface: in that case the better sign counts. curves: wires
// and sections far apart, with increasing noise.  --large: also a million points.

#include "orient_bound.h"
#include "orient_shapes.h"
#include "orient_walls.h"
#include "read_models.h"

#include <hrbfnpr.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using bench::NamedCloud;
using bench::Samples;

struct Options {
    std::string models;
    std::string named;
    std::string only = "clean,noisy,curves,bound,times";
    double noise = 0.01; // diagonals
    std::uint64_t seed = 12345;
    bool large = false;
};

Options options_of(int count, char** words) {
    Options options;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const auto value = [&](const char* name) { return word.substr(std::string(name).size()); };
        if (word.rfind("--models=", 0) == 0)
            options.models = value("--models=");
        else if (word.rfind("--named=", 0) == 0)
            options.named = value("--named=");
        else if (word.rfind("--only=", 0) == 0)
            options.only = value("--only=");
        else if (word.rfind("--noise=", 0) == 0)
            options.noise = std::stod(value("--noise="));
        else if (word.rfind("--seed=", 0) == 0)
            options.seed = std::stoull(value("--seed="));
        else if (word == "--large")
            options.large = true;
        else
            throw std::runtime_error("unknown option " + word);
    }
    return options;
}

struct Score {
    double right = 0.0;
    double angle = 0.0; // mean, in degrees
    std::vector<bool> is_right;
    hrbfnpr_orient_info info{};
};

Score orient(hrbfnpr_context* context, const Samples& samples) {
    hrbfnpr_orient_desc desc;
    hrbfnpr_orient_desc_init(&desc, sizeof desc);
    desc.mode = HRBFNPR_NORMALS_NONE;
    desc.points = {samples.points.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
    std::vector<double> normals(samples.points.size());
    const hrbfnpr_array_out out{normals.data(), samples.count(), 0, HRBFNPR_SCALAR_FLOAT64, 3};
    Score score;
    hrbfnpr_orient_info_init(&score.info, sizeof score.info);
    hrbfnpr_error error;
    hrbfnpr_error_init(&error, sizeof error);
    if (hrbfnpr_orient(context, &desc, nullptr, &out, &score.info, &error) != HRBFNPR_STATUS_OK)
        throw std::runtime_error(error.message);
    const auto count = static_cast<std::size_t>(samples.count());
    for (std::size_t i = 0; i < count; ++i) {
        double cosine = 0.0;
        for (std::size_t c = 0; c < 3; ++c) cosine += normals[3 * i + c] * samples.normals[3 * i + c];
        score.right += cosine > 0.0 ? 1.0 : 0.0;
        score.is_right.push_back(cosine > 0.0);
        score.angle += std::acos(std::min(1.0, std::abs(cosine))) * 360.0 / bench::tau;
    }
    score.right /= static_cast<double>(count);
    score.angle /= static_cast<double>(count);
    if (score.info.outward_by != HRBFNPR_OUTWARD_INSIDE && score.right < 0.5) {
        score.right = 1.0 - score.right;
        score.is_right.flip();
    }
    return score;
}

std::vector<NamedCloud> clouds_of(const Options& options) {
    std::vector<NamedCloud> clouds = bench::analytic_clouds();
    if (!options.models.empty()) {
        std::vector<std::filesystem::path> files;
        for (const auto& entry : std::filesystem::directory_iterator(options.models))
            if (entry.path().extension() == ".ply") files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        for (const auto& file : files) {
            const bool scan = file.stem().string().find("raw") != std::string::npos; // already noisy
            if (scan) continue;
            try {
                clouds.push_back({file.stem().string(), bench::read_ply(file.string()), false});
            } catch (const std::runtime_error& error) {
                std::printf("left out: %s\n", error.what());
            }
        }
    }
    clouds.erase(std::remove_if(clouds.begin(), clouds.end(),
                                [&](const NamedCloud& cloud) {
                                    return cloud.samples.count() > 60000 ||
                                           cloud.name.find(options.named) == std::string::npos;
                                }),
                 clouds.end());
    return clouds;
}

// The sheets of a wall thinner than this many deviations are one band of noise.
constexpr double deviations = 4.0;

[[nodiscard]] bool is_thin(const NamedCloud& cloud, double noise) {
    return cloud.wall < deviations * noise * bench::diagonal_of(cloud.samples);
}

void measure_bound(hrbfnpr_context* context, const std::vector<NamedCloud>& clouds, double noise, std::uint64_t seed) {
    double right = 1.0;
    double angle = 0.0;
    for (const NamedCloud& cloud : clouds) {
        if (is_thin(cloud, noise)) continue;
        const bench::Bound bound = bench::bound_of(context, cloud.samples, bench::noisy(cloud.samples, noise, seed),
                                                   noise * bench::diagonal_of(cloud.samples));
        std::printf("%-22s bound  right %.4f  angle %5.1f\n", cloud.name.c_str(), bound.right, bound.angle);
        std::fflush(stdout);
        right = std::min(right, bound.right);
        if (cloud.smooth) angle = std::max(angle, bound.angle);
    }
    std::printf("orient.bound.right_min %.4f\n", right);
    std::printf("orient.bound.smooth_angle_max %.2f\n", angle);
}

struct OnThickWalls {
    double share = 0.0; // share of all points
    double right = 1.0; // share of these with a right normal
};

OnThickWalls on_thick_walls(const Samples& clean, const Score& score, double noise) {
    const double least = deviations * noise * bench::diagonal_of(clean);
    const std::vector<double> thickness = bench::wall_thickness(clean, least);
    double places = 0.0;
    double right = 0.0;
    for (std::size_t i = 0; i < thickness.size(); ++i) {
        if (thickness[i] < least) continue;
        places += 1.0;
        right += score.is_right[i] ? 1.0 : 0.0;
    }
    return {places / static_cast<double>(thickness.size()), places > 0.0 ? right / places : 1.0};
}

// Prints a line for each cloud, and the worst values of all.
void measure(hrbfnpr_context* context, const std::vector<NamedCloud>& clouds, double noise, std::uint64_t seed) {
    const char* kind = noise > 0.0 ? "noisy" : "clean";
    double right = 1.0;
    double others = 1.0;
    double thick_right = 1.0;
    double angle = 0.0;
    int failed = 0;
    double sure_of_failed = 0.0;
    int thin = 0;
    for (const NamedCloud& cloud : clouds) {
        if (is_thin(cloud, noise)) {
            ++thin;
            continue;
        }
        const Score score = orient(context, noise > 0.0 ? bench::noisy(cloud.samples, noise, seed) : cloud.samples);
        std::printf("%-22s %s  right %.4f  angle %5.1f  confidence %.2f  %s  %.2f s\n", cloud.name.c_str(), kind,
                    score.right, score.angle, score.info.confidence, score.info.closed != 0 ? "closed" : "open  ",
                    score.info.seconds);
        if (noise > 0.0) {
            const OnThickWalls thick = on_thick_walls(cloud.samples, score, noise);
            std::printf("%-22s on walls of %g deviations and more: %.3f of the places, right %.4f\n", "", deviations,
                        thick.share, thick.right);
            thick_right = std::min(thick_right, thick.right);
        }
        std::fflush(stdout);
        right = std::min(right, score.right);
        if (cloud.name != "heart_1024") others = std::min(others, score.right);
        if (cloud.smooth) angle = std::max(angle, score.angle);
        if (score.right >= 0.97) continue;
        ++failed;
        sure_of_failed = std::max(sure_of_failed, score.info.confidence);
    }
    std::printf("orient.%s.right_min %.4f\n", kind, right);
    std::printf("orient.%s.right_min_but_heart %.4f\n", kind, others);
    std::printf("orient.%s.smooth_angle_max %.2f\n", kind, angle);
    std::printf("orient.%s.below_0.97 %d\n", kind, failed);
    if (failed > 0) std::printf("orient.%s.confidence_below_0.97 %.2f\n", kind, sure_of_failed);
    if (thin > 0) std::printf("orient.%s.walls_below_4_deviations %d\n", kind, thin);
    if (noise > 0.0) std::printf("orient.%s.right_min_on_thick_walls %.4f\n", kind, thick_right);
    if (noise == 0.0) std::printf("orient.right_min %.4f\n", right);
}

// Measures curves far apart, with noise in diagonals; reports the largest noise with which at least 99 % of the signs
// are right for all of them.
void measure_curves(hrbfnpr_context* context, std::uint64_t seed) {
    const std::vector<std::pair<const char*, Samples>> all{
        {"torus, 6 wires", bench::lines_of(bench::torus_patch(1.0, 1.0 / 3.0), 4, 2, 160)},
        {"torus, 8 sections", bench::lines_of(bench::torus_patch(1.0, 1.0 / 3.0), 8, 0, 100)},
        {"sphere, 8 wires", bench::lines_of(bench::sphere_patch(1.0), 4, 4, 120)},
        {"knot, 44 wires", bench::lines_of(bench::knot_patch(), 40, 4, 40)}};
    double most = std::numeric_limits<double>::infinity();
    for (const auto& [name, samples] : all) {
        double right_up_to = 0.0;
        for (const double noise : {0.0, 0.0005, 0.001, 0.002, 0.004, 0.01}) {
            const Score score = orient(context, bench::noisy(samples, noise, seed));
            std::printf("%-22s noise %.4f  right %.4f  angle %5.1f  confidence %.2f  %s  %.2f s\n", name, noise,
                        score.right, score.angle, score.info.confidence, score.info.closed != 0 ? "closed" : "open  ",
                        score.info.seconds);
            std::fflush(stdout);
            if (score.right < 0.99) break;
            right_up_to = noise;
        }
        most = std::min(most, right_up_to);
    }
    std::printf("orient.curves.right_up_to_noise %.4f\n", most);
}

void measure_time(hrbfnpr_context* context, const char* name, std::int64_t count) {
    const Score score = orient(context, bench::sampled(bench::knot_patch(), count));
    std::printf("orient.%s_right %.4f\n", name, score.right);
    std::printf("orient.%s_seconds %.2f\n", name, score.info.seconds);
    std::fflush(stdout);
}

} // namespace

int main(int count, char** words) {
    const Options options = options_of(count, words);
    const auto wants = [&](const char* part) { return options.only.find(part) != std::string::npos; };
    hrbfnpr_context* context = nullptr;
    hrbfnpr_error error;
    hrbfnpr_error_init(&error, sizeof error);
    if (hrbfnpr_context_create(nullptr, &context, &error) != HRBFNPR_STATUS_OK) {
        std::fprintf(stderr, "%s\n", error.message);
        return 1;
    }
    const std::vector<NamedCloud> clouds = clouds_of(options);
    if (wants("clean")) measure(context, clouds, 0.0, 0);
    if (wants("noisy")) measure(context, clouds, options.noise, options.seed);
    if (wants("curves")) measure_curves(context, options.seed);
    if (wants("bound")) measure_bound(context, clouds, options.noise, options.seed);
    if (wants("times")) measure_time(context, "50k", 50000);
    if (wants("times") && options.large) measure_time(context, "1m", 1000000);
    hrbfnpr_context_release(context);
    return 0;
}
