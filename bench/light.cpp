// SPDX-License-Identifier: MIT
// Light: rays on the triangles of a mesh, as occlusion and shadows cast them. Rows rays_* are millions a second.
// --models=DIR --named=TEXT: also meshes of a folder, divided until they have at least 150 000 faces.
// --threads=2, --large: also 2 million faces.
#include "calls.h"
#include "mesh_rays.h"
#include "read_meshes.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <string>

int main(int argc, char** argv) {
    const std::string models = bench::option(argc, argv, "--models=");
    const std::string named = bench::option(argc, argv, "--named=");
    const std::string given = bench::option(argc, argv, "--threads=");
    const int threads = given.empty() ? 2 : std::stoi(given);
    const bool large = std::find(argv, argv + argc, std::string("--large")) != argv + argc;
    try {
        bench::report_mesh_rays("sphere", bench::bumpy_ball(224), threads);
        if (large) bench::report_mesh_rays("large", bench::bumpy_ball(708), threads);
        if (models.empty()) return 0;
        for (auto& [name, mesh] : bench::read_meshes(models, named)) {
            while (mesh.faces() < 150000) mesh = bench::divided(mesh);
            bench::report_mesh_rays(name, mesh, threads);
        }
    } catch (const std::exception& problem) {
        std::fprintf(stderr, "bench_light: %s\n", problem.what());
        return 1;
    }
    return 0;
}
