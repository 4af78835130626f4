// SPDX-License-Identifier: MIT
// Light. Rows rays_*: millions of rays a second on the triangles of a mesh, as occlusion and shadows cast them. Rows
// light.*: occlusion and soft shadows against closed forms, borders of shadows, leaks through thin walls, seconds of
// shadings, ratios of frames, and pops in an orbit.
// --only=rays,truth,borders,times,frames,pops --models=DIR --named=TEXT: rays also on meshes of a folder, divided until
// they have at least 150 000 faces. --threads=2, --large: also 2 million faces, and a million marks.
#include "calls.h"
#include "light_frames.h"
#include "light_truth.h"
#include "mesh_rays.h"
#include "read_meshes.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

namespace {

void run_rays(int argc, char** argv, int threads, bool large) {
    const std::string models = bench::option(argc, argv, "--models=");
    bench::report_mesh_rays("sphere", bench::bumpy_ball(224), threads);
    if (large) bench::report_mesh_rays("large", bench::bumpy_ball(708), threads);
    if (models.empty()) return;
    for (auto& [name, mesh] : bench::read_meshes(models, bench::option(argc, argv, "--named="))) {
        while (mesh.faces() < 150000) mesh = bench::divided(mesh);
        bench::report_mesh_rays(name, mesh, threads);
    }
}

void run(int argc, char** argv) {
    const std::string given = bench::option(argc, argv, "--threads=");
    const int threads = given.empty() ? 2 : std::stoi(given);
    const bool large = std::find(argv, argv + argc, std::string("--large")) != argv + argc;
    const std::string only = "," + bench::option(argc, argv, "--only=") + ",";
    const auto wanted = [&](const char* name) {
        return only == ",," || only.find("," + std::string(name) + ",") != std::string::npos;
    };
    const scenes::Context context = bench::make_context(threads);
    if (wanted("rays")) run_rays(argc, argv, threads, large);
    if (wanted("truth"))
        for (const bench::TrueScene& scene : bench::true_scenes()) bench::report_truth(scene, threads);
    if (wanted("borders")) {
        bench::report_border(context.get());
        bench::report_leaks(context.get());
    }
    if (wanted("times") || wanted("frames") || wanted("pops")) {
        bench::LitSurface surface(context.get(), 300000, threads);
        if (wanted("times")) surface.report_times();
        if (wanted("frames")) surface.report_frames();
        if (wanted("pops")) surface.report_pops();
    }
    if (wanted("times") && large) bench::LitSurface(context.get(), 1000000, threads).report_times();
}

} // namespace

int main(int argc, char** argv) {
    try {
        run(argc, argv);
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "bench_light: %s\n", problem.what());
        return 1;
    }
    return 0;
}
