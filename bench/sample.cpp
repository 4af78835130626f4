// SPDX-License-Identifier: MIT
// Meshes: farthest points, and the time and the error of a fit with as many samples as it needs, against one with 1000
// even samples.
// --models=DIR: a folder of OBJ and PLY meshes instead of generated ones; --named=TEXT: only meshes with TEXT in the
// name.
#include "calls.h"
#include "read_meshes.h"
#include "timing.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <ctime>
#include <exception>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace {

using bench::Triangles;
using hrbfnpr::test::made;
using Named = std::pair<std::string, Triangles>;

// A ball with waves that are finer towards one side.
Triangles waves(int levels) {
    Triangles mesh = hrbfnpr::test::icosphere(levels);
    for (std::size_t i = 0; i < mesh.vertices.size(); i += 3) {
        double* const p = mesh.vertices.data() + i;
        const double fine = 4.0 * std::pow(3.0, 0.5 * (p[2] + 1.0));
        const double r = 1.0 + 0.15 / fine * std::sin(2.0 * fine * p[0]) * std::sin(2.0 * fine * p[1]);
        for (int c = 0; c < 3; ++c) p[c] *= r;
    }
    return mesh;
}

std::vector<Named> generated() {
    return {{"torus", hrbfnpr::test::torus(320, 156, 0.4)},
            {"ring", hrbfnpr::test::wound_ring(500, 100)},
            {"waves", waves(6)},
            {"box", hrbfnpr::test::box(1.0, 0.8, 0.6, 90)},
            {"plate", hrbfnpr::test::box(1.0, 1.0, 0.02, 90)},
            {"balls", hrbfnpr::test::icosphere(5).with(hrbfnpr::test::icosphere(5).moved(0.8, 1.1, 0.3, 0.0))}};
}

// Reports the seconds for `count` of `candidates` places on a torus.
void run_farthest(hrbfnpr_context* context, std::int64_t candidates, std::int64_t count) {
    scenes::Check check;
    std::vector<double> points;
    std::uint64_t state = 1;
    const auto random = [&] {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        return 6.283185307179586 * static_cast<double>(state >> 11U) * 0x1p-53;
    };
    for (std::int64_t i = 0; i < candidates; ++i) {
        const double u = random(), v = random();
        const double r = 1.0 + 0.4 * std::cos(v);
        points.insert(points.end(), {r * std::cos(u), r * std::sin(u), 0.4 * std::sin(v)});
    }
    std::vector<std::int64_t> indices(static_cast<std::size_t>(count));
    const hrbfnpr_array from = bench::view(points);
    const hrbfnpr_array_out to{indices.data(), count, 0, HRBFNPR_SCALAR_INT64, 1};
    std::vector<double> times;
    for (int run = 0; run < 3; ++run)
        times.push_back(bench::seconds(
            [&] { check(hrbfnpr_farthest_points(context, &from, &to, nullptr, nullptr, check.error())); }));
    std::printf("%lld farthest of %lld points: %.3f s\n", static_cast<long long>(count),
                static_cast<long long>(candidates), bench::median(times));
    bench::report("sample.farthest_seconds", bench::median(times));
}

scenes::Model evenly(hrbfnpr_context* context, const hrbfnpr_mesh* mesh, std::int64_t count) {
    scenes::Check check;
    std::vector<double> points(static_cast<std::size_t>(3 * count)), normals(points.size());
    const hrbfnpr_array_out to{points.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    const hrbfnpr_array_out along{normals.data(), count, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    check(hrbfnpr_mesh_sample(mesh, nullptr, &to, &along, nullptr, check.error()));
    return bench::fit(context, points, normals, HRBFNPR_TRIM_NEVER);
}

hrbfnpr_comparison compare(const scenes::Model& model, const hrbfnpr_mesh* mesh) {
    scenes::Check check;
    auto result = made(hrbfnpr_comparison_init);
    check(hrbfnpr_model_compare_mesh(model.get(), mesh, nullptr, &result, nullptr, check.error()));
    return result;
}

// Wall-clock time, and processor time of all threads, which does not depend on what else runs.
struct Times {
    double seconds = 0.0;
    double processor = 0.0;
};

template <class Work>
Times timed(Work&& work) {
    const std::clock_t before = std::clock();
    Times times;
    times.seconds = bench::seconds(work);
    times.processor = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
    return times;
}

void print(const char* name, std::int64_t centres, const Times& times, const hrbfnpr_comparison& error) {
    const double percent = 100.0 / error.diagonal;
    std::printf("  %-7s %7lld %8.2f %9.2f   %7.3f %7.3f %7.2f   %7.3f %7.3f %7.2f   %6.2f %6lld %6lld\n", name,
                static_cast<long long>(centres), times.seconds, times.processor, percent * error.surface_p99,
                percent * error.surface_max, 100.0 * error.surface_share, percent * error.mesh_p99,
                percent * error.mesh_max, 100.0 * error.mesh_share, error.normal_mean,
                static_cast<long long>(error.components), static_cast<long long>(error.genus));
}

struct Totals {
    Times times;             // the greatest
    double share = 1.0;      // the least, both ways
    double farthest = 0.0;   // the greatest, % of the diagonal
    double even_share = 1.0; // for 1000 even samples
    double even_farthest = 0.0;
    std::int64_t centres = 0; // the greatest
    int reached = 0;
    int meshes = 0;
};

void run_mesh(hrbfnpr_context* context, const Named& named, Totals& totals) {
    scenes::Check check;
    auto desc = made(hrbfnpr_mesh_desc_init);
    const Triangles& from = named.second;
    desc.vertices = bench::view(from.vertices);
    desc.triangles = {from.triangles.data(), static_cast<std::int64_t>(from.faces()), 0, HRBFNPR_SCALAR_INT32, 3};
    hrbfnpr_mesh* raw = nullptr;
    const Times making = timed([&] { check(hrbfnpr_mesh_create(context, &desc, nullptr, &raw, check.error())); });
    const hrbfnpr::test::Mesh mesh(raw);
    auto info = made(hrbfnpr_mesh_info_init);
    check(hrbfnpr_mesh_get_info(raw, &info, check.error()));
    auto fit = made(hrbfnpr_mesh_fit_info_init);
    hrbfnpr_model* model = nullptr;
    const Times fitting =
        timed([&] { check(hrbfnpr_model_fit_mesh(raw, nullptr, nullptr, &fit, nullptr, &model, check.error())); });
    const scenes::Model fitted(model);
    scenes::Model even;
    const Times evening = timed([&] { even = evenly(context, raw, 1000); });
    std::printf(
        "%s: %lld faces in %lld components (%lld left out), genus %lld, made in %.3f s; %d rounds, %lld centres "
        "off the surface, %s\n",
        named.first.c_str(), static_cast<long long>(info.faces), static_cast<long long>(info.components),
        static_cast<long long>(info.left_out_components), static_cast<long long>(info.genus), making.seconds,
        static_cast<int>(fit.rounds), static_cast<long long>(fit.off_surface_centres),
        fit.reached != 0 ? "reached" : "NOT reached");
    const hrbfnpr_comparison after = compare(fitted, raw);
    const hrbfnpr_comparison before = compare(even, raw);
    print("even", 1000, evening, before);
    print("fitted", fit.centres, fitting, after);
    std::fflush(stdout);
    const auto farthest = [](const hrbfnpr_comparison& error) {
        return 100.0 * std::max(error.surface_max, error.mesh_max) / error.diagonal;
    };
    totals.times.seconds = std::max(totals.times.seconds, making.seconds + fitting.seconds);
    totals.times.processor = std::max(totals.times.processor, making.processor + fitting.processor);
    totals.share = std::min({totals.share, after.surface_share, after.mesh_share});
    totals.farthest = std::max(totals.farthest, farthest(after));
    totals.even_share = std::min({totals.even_share, before.surface_share, before.mesh_share});
    totals.even_farthest = std::max(totals.even_farthest, farthest(before));
    totals.centres = std::max(totals.centres, fit.centres);
    totals.reached += fit.reached != 0 ? 1 : 0;
    ++totals.meshes;
}

} // namespace

int main(int argc, char** argv) {
    try {
        const scenes::Context context = bench::make_context(2);
        run_farthest(context.get(), 1'000'000, 20'000);
        const std::string folder = bench::option(argc, argv, "--models=");
        const std::vector<Named> meshes =
            folder.empty() ? generated() : bench::read_meshes(folder, bench::option(argc, argv, "--named="));
        std::printf(
            "\n%% of the diagonal; share within 0.2 %%                surface to mesh           mesh to surface\n");
        std::printf(
            "          centres  seconds processor       p99     max   share       p99     max   share   normal  "
            "parts  genus\n");
        Totals totals;
        for (const Named& named : meshes) run_mesh(context.get(), named, totals);
        bench::report("sample.meshes", totals.meshes);
        bench::report("sample.reached", totals.reached);
        bench::report("sample.seconds_max", totals.times.seconds);
        bench::report("sample.processor_seconds_max", totals.times.processor);
        bench::report("sample.centres_max", static_cast<double>(totals.centres));
        bench::report("sample.share_min", totals.share);
        bench::report("sample.farthest_percent_max", totals.farthest);
        bench::report("sample.even_share_min", totals.even_share);
        bench::report("sample.even_farthest_percent_max", totals.even_farthest);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench/sample: %s\n", error.what());
        return 1;
    }
    return 0;
}
