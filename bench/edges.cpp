// SPDX-License-Identifier: MIT
// Shapes with sharp edges: CSG trees against a plain recursion, unions of many fits, models of sheets that are fitted
// to meshes, and which meshes the library finds to have edges.  --only=csg|rows|pieces|verdict; --trees=N;
// --models=DIR: a folder of OBJ and PLY meshes to measure as well; --named=TEXT: only meshes with TEXT in the name;
// --save=DIR: writes the meshes of `verdict` there instead of measuring them.
#include "edges_pieces.h"
#include "edges_rows.h"
#include "edges_trees.h"
#include "edges_verdict.h"

#include <cstdio>
#include <exception>
#include <stdexcept>

int main(int argc, char** argv) {
    try {
        const std::string only = bench::option(argc, argv, "--only=");
        if (!only.empty() && only != "csg" && only != "rows" && only != "pieces" && only != "verdict")
            throw std::runtime_error("--only=" + only + ": there are csg, rows, pieces and verdict");
        const scenes::Context context = bench::make_context(2);
        const auto wants = [&](const char* part) { return only.empty() || only == part; };
        if (wants("csg")) {
            const std::string trees = bench::option(argc, argv, "--trees=");
            bench::csg::measure_csg(context.get(), trees.empty() ? 1000 : std::stoi(trees));
        }
        if (wants("rows")) bench::rows::measure_rows(context.get());
        if (wants("pieces"))
            bench::measure_pieces(context.get(), bench::option(argc, argv, "--models="),
                                  bench::option(argc, argv, "--named="));
        const std::string folder = bench::option(argc, argv, "--save=");
        if (!folder.empty())
            bench::verdict::save_models(folder);
        else if (wants("verdict"))
            bench::verdict::measure_verdict(context.get(), bench::option(argc, argv, "--named="));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench/edges: %s\n", error.what());
        return 1;
    }
    return 0;
}
