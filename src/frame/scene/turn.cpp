// SPDX-License-Identifier: MIT
#include "frame/scene/turn.h"

#include "marks/clusters.h"

namespace hrbfnpr::frame {

void turn(Scene& scene) {
    std::int64_t marks = 0;
    for (const Run& run : scene.runs) marks += run.turned ? run.count : 0;
    if (marks > 0) scene.turned.reserve(scene.runs.size()); // runs point to what is in it
    scene.turned_normal.resize_for_overwrite(3 * marks);
    float* to = scene.turned_normal.data();
    std::int64_t number = 0;
    for (Run& run : scene.runs) {
        if (!run.turned) continue;
        for (std::int64_t k = 0; k < 3 * run.count; ++k) to[k] = -run.normal[k];
        run.normal = to;
        to += 3 * run.count;
        if (number == scene.turned.size()) scene.turned.add(scene.items.memory());
        marks::MarkClusters& turned = scene.turned[number++];
        marks::turn_clusters(*run.clusters, turned);
        run.clusters = &turned;
        scene.items[run.item].radius = scene.items[run.source].radius; // poses may have moved its marks
    }
}

} // namespace hrbfnpr::frame
