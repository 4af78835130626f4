// SPDX-License-Identifier: MIT
// Edges: of models of sheets that are fitted to meshes.
// --models=DIR: a folder of OBJ and PLY meshes that are measured, too; --named=TEXT: only those with it in the name.
#include "edges_pieces.h"

#include <cstdio>
#include <exception>

int main(int argc, char** argv) {
    try {
        const scenes::Context context = bench::make_context(2);
        bench::measure_pieces(context.get(), bench::option(argc, argv, "--models="),
                              bench::option(argc, argv, "--named="));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "bench/edges: %s\n", error.what());
        return 1;
    }
    return 0;
}
