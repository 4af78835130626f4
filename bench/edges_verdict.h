// SPDX-License-Identifier: MIT
// Whether a mesh approximates a shape with edges: generated meshes with a known answer, and the library's answer.
#pragma once

#include "calls.h"
#include "edges_shapes.h"
#include "support/screw.h"
#include "timing.h"

#include <cstdio>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace bench::verdict {

using namespace hrbfnpr::test::verdict;
using hrbfnpr::test::Triangles;

using hrbfnpr::test::made;

// The shape that a mesh approximates by construction: a smooth shape, a shape with edges between faces that may be
// round, or a shape with flat faces only.
enum class Right { smooth, edges, flat };

struct Model {
    std::string name;
    Right right;
    Triangles mesh;
};

inline void add_cages(std::vector<Model>& models) {
    struct Cage {
        std::string name;
        Quads mesh;
        int most;
    };
    const std::vector<Cage> cages{{"animal", cage(solid_of(animal()), 15, 2, 0.08, 1), 3},
                                  {"plain animal", cage(solid_of(simple_animal()), 8, 1, 0.05, 2), 3},
                                  {"bust", cage(solid_of(bust()), 14, 2, 0.06, 3), 2},
                                  {"person", cage(solid_of(person()), 14, 2, 0.05, 4), 2},
                                  {"frame", cage(frame(3), 8, 1, 0.03, 5), 2},
                                  {"wide frame", cage(frame(8), 20, 1, 0.03, 6), 2}};
    const std::array<std::string, 4> cuts{"/", "\\", "short", "random"};
    for (std::size_t i = 0; i < cages.size(); ++i)
        for (int level = 0; level <= cages[i].most; ++level) {
            // Coarse cages with limbs of four sides are not smooth shapes before they are subdivided.
            if (level == 0 && i != 0 && i != 2 && i != 3) continue;
            const Quads mesh = subdivided(cages[i].mesh, level);
            for (std::size_t how = 0; how < cuts.size(); ++how) {
                if (level == 3 && how >= 2) continue;
                if (i >= 2 && how == (i + static_cast<std::size_t>(level)) % 2 + 2) continue;
                models.push_back({cages[i].name + " " + std::to_string(level) + " " + cuts[how], Right::smooth,
                                  cut(mesh, static_cast<Cut>(how))});
            }
        }
}

inline void add_blobs(std::vector<Model>& models) {
    for (const std::uint64_t seed : {7U, 10U, 14U})
        for (int level = 1; level <= 2; ++level) {
            const Quads mesh = subdivided(blob(seed), level);
            const std::string name = "blob " + std::to_string(seed) + " " + std::to_string(level);
            models.push_back({name + " /", Right::smooth, cut(mesh, Cut::first)});
            models.push_back({name + " \\", Right::smooth, cut(mesh, Cut::second)});
        }
}

inline void add_grids(std::vector<Model>& models) {
    for (const Cut how : {Cut::first, Cut::second, Cut::random}) {
        const std::string name = how == Cut::first ? " /" : how == Cut::second ? " \\" : " random";
        models.push_back({"sphere 10" + name, Right::smooth, cut(sphere(20, 10), how)});
        models.push_back({"sphere 32" + name, Right::smooth, cut(sphere(64, 32), how)});
        models.push_back({"capsule" + name, Right::smooth, cut(capsule(16, 20), how)});
        models.push_back({"thin torus" + name, Right::smooth, cut(torus(120, 10, 0.1), how)});
        models.push_back({"waves" + name, Right::smooth, cut(waves(60, 4, 0.08), how)});
        models.push_back({"steep waves" + name, Right::smooth, cut(waves(80, 8, 0.07), how)});
        models.push_back({"coarse capsule" + name, Right::smooth, cut(capsule(10, 20), how)});
        models.push_back({"coarse torus" + name, Right::smooth, cut(torus(24, 9, 0.4), how)});
    }
}

inline void add_scans(std::vector<Model>& models) {
    for (const double noise : {0.0, 0.003, 0.01}) {
        char text[32];
        std::snprintf(text, sizeof(text), " noise %g", noise);
        models.push_back({std::string("scan 32") + text, Right::smooth, scan(soft_body(), 32, noise)});
        models.push_back({std::string("scan 64") + text, Right::smooth, scan(soft_body(), 64, noise)});
        models.push_back({std::string("head") + text, Right::smooth, head(5, noise * 0.035)});
    }
    models.push_back({"rough head", Right::smooth, head(5, 0.012)});
    models.push_back({"wide folds", Right::smooth, folded(5, 0.25, 0.5, 5.0)});
    models.push_back({"narrow folds", Right::smooth, folded(5, 0.25, 0.25, 7.0)});
    models.push_back({"deep folds", Right::smooth, folded(6, 0.35, 0.3, 9.0)});
    models.push_back({"coarse scan", Right::smooth, scan(soft_body(), 16, 0.0)});
    models.push_back({"coarse head", Right::smooth, head(3, 0.0)});
    models.push_back({"thinned body", Right::smooth, clustered(scan(soft_body(), 64, 0.0), 0.1)});
    models.push_back({"thinned head", Right::smooth, clustered(head(5, 0.0), 0.2)});
    // A terrain of rugged mountains and level lakes, and a figure on level ground.
    Triangles lakes = cut(waves(80, 5, 0.07), Cut::first);
    for (std::size_t i = 2; i < lakes.vertices.size(); i += 3)
        lakes.vertices[i] = std::max(lakes.vertices[i] + 0.02 * random(i, 3), 0.0);
    models.push_back({"lakes", Right::smooth, lakes});
    const Triangles ground = cut(
        grid(40, 40, [](double u, double v) { return glm::dvec3(3.0 * u - 1.5, 3.0 * v - 1.5, -1.2); }), Cut::first);
    models.push_back({"figure on a ground", Right::smooth, ground.with(head(4, 0.012))});
    models.push_back({"coarse body", Right::smooth, clustered(scan(soft_body(), 64, 0.0), 0.16)});
    models.push_back({"coarser head", Right::smooth, clustered(head(5, 0.0), 0.4)});
}

inline void add_flat(std::vector<Model>& models) {
    const auto rock = [](int levels, double off, std::uint64_t seed) {
        return star(levels, [&](const glm::dvec3&, std::size_t v) { return 1.0 + off * random(v, seed); });
    };
    models.push_back({"rock 20", Right::flat, rock(0, 0.3, 1)});
    models.push_back({"rock 80", Right::flat, rock(1, 0.35, 2)});
    models.push_back({"rock 80 finer", Right::flat, finer(rock(1, 0.35, 2), 2)});
    models.push_back({"box", Right::flat, hrbfnpr::test::box(1.0, 1.0, 1.0, 1)});
    models.push_back({"long box", Right::flat, hrbfnpr::test::box(1.0, 0.2, 3.0, 1)});
    models.push_back({"chamfered box", Right::flat, chamfered_cube(0.2)});
    models.push_back({"narrow chamfers", Right::flat, chamfered_cube(0.04)});
    models.push_back({"narrow chamfers finer", Right::flat, finer(chamfered_cube(0.04), 2)});
    const auto ball = [](int x, int y, int z) {
        return (x + 0.5) * (x + 0.5) + (y + 0.5) * (y + 0.5) + (z + 0.5) * (z + 0.5) < 110.0;
    };
    models.push_back({"voxel animal", Right::flat, cut(outside_of(solid_of(animal()), 15), Cut::first)});
    models.push_back({"voxel animal random", Right::flat, cut(outside_of(solid_of(animal()), 15), Cut::random)});
    models.push_back({"voxel person", Right::flat, cut(outside_of(solid_of(person()), 14), Cut::second)});
    models.push_back({"voxel ball", Right::flat, cut(outside_of(ball, 12), Cut::random)});
    models.push_back({"voxel frame", Right::flat, cut(outside_of(frame(5), 12), Cut::first)});
}

inline void add_parts(std::vector<Model>& models) {
    using namespace hrbfnpr::test;
    const auto add = [&](const std::string& name, const Triangles& mesh) {
        models.push_back({name, Right::edges, mesh});
    };
    const std::vector<Ring> lathe{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    for (const int sides : {16, 32, 96}) add("cylinder " + std::to_string(sides), ringed(lathe, sides, 5.0));
    add("cylinder 24 even", ringed(lathe, 24, 0.26));
    add("cone", ringed({{0.0, 0.0}, {1.0, 0.0}, {0.0, 2.0}}, 48, 0.13));
    add("shaft", stepped_shaft(48));
    add("gear", gear(16, 1));
    add("fine gear", gear(16, 3));
    add("drilled cube", drilled_cube(0.5, 48));
    add("socket", socket(48));
    add("nut", ringed({{0.45, 0.1},
                       {0.55, 0.0},
                       {0.85, 0.0},
                       {0.95, 0.08, 6},
                       {0.95, 0.62, 6},
                       {0.85, 0.7},
                       {0.55, 0.7},
                       {0.45, 0.6},
                       {0.45, 0.1}},
                      48, 0.5));
    add("lens", cut(turned(64, 24,
                           [](double v) {
                               const double angle = 0.6 * (v < 0.5 ? 2.0 * v : 2.0 - 2.0 * v);
                               return glm::dvec2(v > 0.0 && v < 1.0 ? std::sin(angle) : 0.0,
                                                 (v < 0.5 ? -1.0 : 1.0) * (std::cos(angle) - std::cos(0.6)));
                           }),
                    Cut::first));
    for (const int segments : {2, 3, 5, 8})
        add("filleted prism " + std::to_string(segments), prism(rounded(rectangle(1.0, 0.7), 0.12, segments), 0.6));
    models.push_back({"chamfered prism", Right::flat, prism(rounded(rectangle(1.0, 0.7), 0.1, 1), 0.6)});
    add("filleted plate", prism(rounded(rectangle(1.0, 0.7), 0.05, 4), 0.05));
    add("star prism",
        prism(
            rounded(
                {{1.0, 0.0}, {0.3, 0.3}, {0.0, 1.0}, {-0.3, 0.3}, {-1.0, 0.0}, {-0.3, -0.3}, {0.0, -1.0}, {0.3, -0.3}},
                0.05, 3),
            0.4, 3));
    add("bracket", bracket(6));
    add("chamfered plate", chamfered_plate(8));
    add("elbow", elbow(32, 24));
    add("crossed cylinders", crossed_cylinders(24));
    add("blade", blade(40, 30));
    add("folded sheet", folded_sheet(8));
    Triangles turbine = ringed(lathe, 48, 0.3);
    for (int k = 0; k < 7; ++k) {
        Triangles one = blade(32, 16);
        const double a = 2.0 * pi * k / 7.0;
        for (std::size_t i = 0; i < one.vertices.size(); i += 3) {
            const double x = one.vertices[i], y = one.vertices[i + 1], z = one.vertices[i + 2] + 0.8;
            one.vertices[i] = z * std::cos(a) - x * 0.4 * std::sin(a);
            one.vertices[i + 1] = z * std::sin(a) + x * 0.4 * std::cos(a);
            one.vertices[i + 2] = 0.5 + y;
        }
        turbine = turbine.with(one);
    }
    add("turbine", turbine);
    const Triangles machine =
        stepped_shaft(48)
            .with(gear(20, 1).moved(2.0, 0.0, 0.0, 3.2))
            .with(prism(rounded(rectangle(1.0, 0.7), 0.15, 4), 0.6).moved(1.5, 4.0, 0.0, 0.0))
            .with(round_box(0.1, 3).moved(1.0, -4.0, 0.0, 0.5))
            .with(elbow(24, 16).moved(1.0, 0.0, -4.0, 0.0))
            .with(sphere(32, 16).vertex.empty() ? Triangles{}
                                                : cut(sphere(32, 16), Cut::first).moved(0.8, 0.0, 4.0, 0.0));
    add("machine", machine);
    add("machine finer", finer(machine, 1, true));
    add("machine as text", as_text(machine));
    add("gear finer", finer(gear(16, 1), 2));
    add("gear uneven", finer(gear(16, 1), 2, true));
    add("bracket finer", finer(bracket(6), 2));
    add("bracket uneven", finer(bracket(6), 3, true));
    add("nut finer", finer(socket(24), 1, true));
    add("prism finer", finer(prism(rounded(rectangle(1.0, 0.7), 0.12, 5), 0.6), 2));
    add("prism uneven", finer(prism(rounded(rectangle(1.0, 0.7), 0.12, 5), 0.6), 3, true));
    add("cylinder finer", finer(ringed(lathe, 32, 5.0), 2));
    add("cylinder as text", as_text(finer(ringed(lathe, 64, 5.0), 1, true)));
    add("screw", screw(5, trapezoidal, 72, 3));
    add("noisy machine", rough(finer(machine, 1), 1e-4));
    add("coarsely written gear", as_text(finer(gear(16, 1), 1), 1e-3));
    add("coarsely written bracket", as_text(bracket(6), 1e-3));
    add("scattered shaft", scattered(stepped_shaft(96), 0.02));
    add("scattered cube", scattered(drilled_cube(0.5, 64), 0.02));
    Triangles houses = box(10.0, 10.0, 0.2, 1);
    for (int k = 0; k < 9; ++k) {
        const double eaves = 1.5 + 0.2 * (k % 4);
        const Outline gable{{{0.0, 0.0}, {2.0, 0.0}, {2.0, eaves}, {1.0, 2.5}, {0.0, eaves}}, {1.0, 0.7}};
        Triangles house = prism(gable, 2.0 + 0.1 * k);
        for (std::size_t i = 0; i < house.vertices.size(); i += 3) {
            std::swap(house.vertices[i + 1], house.vertices[i + 2]);
            house.vertices[i] += 0.5 + 3.2 * (k % 3);
            house.vertices[i + 1] += 0.5 + 3.2 * (k / 3);
            house.vertices[i + 2] += 0.2;
        }
        houses = houses.with(house.turned());
    }
    models.push_back({"houses", Right::flat, houses});
    const Quads figure = subdivided(cage(solid_of(person()), 14, 2, 0.05, 4), 1);
    add("statue on a block", box(14.0, 10.0, 4.0, 1).moved(1.0, -7.0, -5.0, -15.0).with(cut(figure, Cut::first)));
    for (const int chords : {2, 3})
        models.push_back({"round box " + std::to_string(2 * chords), Right::smooth, round_box(0.25, chords)});
}

inline std::vector<Model> models() {
    std::vector<Model> all;
    add_cages(all);
    add_blobs(all);
    add_grids(all);
    add_scans(all);
    add_flat(all);
    add_parts(all);
    return all;
}

// Makes the mesh. If the library finds edges, also fits the coarsest possible model, which has all the sheets.
inline std::int64_t sheets_of(hrbfnpr_context* context, const Triangles& from, hrbfnpr_mesh_info& info) {
    scenes::Check check;
    auto desc = made(hrbfnpr_mesh_desc_init);
    desc.vertices = view(from.vertices);
    desc.triangles = {from.triangles.data(), static_cast<std::int64_t>(from.faces()), 0, HRBFNPR_SCALAR_INT32, 3};
    hrbfnpr_mesh* created = nullptr;
    check(hrbfnpr_mesh_create(context, &desc, nullptr, &created, check.error()));
    const hrbfnpr::test::Mesh mesh(created);
    info = made(hrbfnpr_mesh_info_init);
    check(hrbfnpr_mesh_get_info(mesh.get(), &info, check.error()));
    if (info.creases == 0) return 1;
    auto fit = made(hrbfnpr_mesh_fit_desc_init);
    fit.maximum_centres = 16;
    fit.candidates = 1000;
    double square = 0.0;
    for (std::size_t c = 0; c < 3; ++c)
        square += (info.bounds_max[c] - info.bounds_min[c]) * (info.bounds_max[c] - info.bounds_min[c]);
    fit.tolerance = fit.far = 0.01 * std::sqrt(square); // faces are as coarse as with the default tolerance
    auto told = made(hrbfnpr_mesh_fit_info_init);
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_fit_mesh(mesh.get(), &fit, nullptr, &told, nullptr, &model, check.error()));
    const scenes::Model owner(model);
    return told.sheets;
}

// Writes all meshes as OBJ files, numbered in order; for scripts/ablate.py.
inline void save_models(const std::string& folder) {
    int number = 0;
    for (const Model& model : models()) {
        char name[16];
        std::snprintf(name, sizeof(name), "/%03d.obj", ++number);
        std::ofstream file(folder + name);
        file.precision(17);
        file << "# " << model.name << '\n';
        const auto& at = model.mesh.vertices;
        for (std::size_t i = 0; i < at.size(); i += 3)
            file << "v " << at[i] << ' ' << at[i + 1] << ' ' << at[i + 2] << '\n';
        const auto& corner = model.mesh.triangles;
        for (std::size_t i = 0; i < corner.size(); i += 3)
            file << "f " << corner[i] + 1 << ' ' << corner[i + 1] + 1 << ' ' << corner[i + 2] + 1 << '\n';
        if (!file.flush()) throw std::runtime_error("cannot write " + folder + name);
    }
}

inline void measure_verdict(hrbfnpr_context* context, const std::string& named) {
    std::printf("%-24s %7s %7s %7s %8s %8s  %s\n", "mesh", "faces", "right", "said", "length", "sheets", "");
    std::int64_t count = 0, right = 0;
    double most = 0.0;
    for (const Model& model : models()) {
        if (model.name.find(named) == std::string::npos) continue;
        hrbfnpr_mesh_info info{};
        const std::int64_t sheets = sheets_of(context, model.mesh, info);
        const bool is_right = (info.creases != 0) == (model.right != Right::smooth);
        ++count;
        right += is_right ? 1 : 0;
        // If all faces are flat, or triangles are few, each face may be a sheet; other meshes should have few sheets.
        if (info.creases != 0 && model.right != Right::flat && info.faces >= 100)
            most = std::max(most, static_cast<double>(sheets) / static_cast<double>(info.faces));
        std::printf("%-24s %7lld %7s %7s %8.3f %8lld  %s\n", model.name.c_str(), static_cast<long long>(info.faces),
                    model.right == Right::smooth  ? "smooth"
                    : model.right == Right::edges ? "edges"
                                                  : "flat",
                    info.creases != 0 ? "edges" : "smooth", info.crease_length, static_cast<long long>(sheets),
                    is_right ? "" : "WRONG");
        std::fflush(stdout);
    }
    report("edges.verdict_models", static_cast<double>(count));
    report("edges.verdict_right", static_cast<double>(right));
    report("edges.verdict_most_sheets_a_triangle", most);
}

} // namespace bench::verdict
