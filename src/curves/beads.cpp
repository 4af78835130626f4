// SPDX-License-Identifier: MIT
#include "curves/beads.h"

#include <algorithm>

namespace hrbfnpr::curves {

base::Array<Bead> beads_of(const base::Runtime& runtime, const SurfaceMesh& mesh, const MeshChains& chains) {
    base::Array<Bead> beads(runtime.memory, chains.crossing.size());
    runtime.parallel.for_chunks(chains.chains(), 16, [&](std::int64_t from, std::int64_t to) {
        for (std::int64_t c = from; c < to; ++c) {
            const std::int64_t begin = chains.first[c];
            const std::int64_t count = chains.first[c + 1] - begin;
            const bool closed = chains.closed[c] != 0;
            const auto place = [&](std::int64_t i) {
                const std::int64_t at = closed ? (i + count) % count : std::clamp<std::int64_t>(i, 0, count - 1);
                return chains.crossing[begin + at].place(mesh);
            };
            for (std::int64_t i = 0; i < count; ++i) {
                const Crossing& crossing = chains.crossing[begin + i];
                beads[begin + i] = {place(i),
                                    place(i + 1) - place(i - 1),
                                    {mesh.position[crossing.negative], mesh.position[crossing.positive]}};
            }
        }
    });
    return beads;
}

} // namespace hrbfnpr::curves
