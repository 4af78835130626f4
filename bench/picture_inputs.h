// SPDX-License-Identifier: MIT
// The inputs of the benchmark of pictures by name. A mesh or a point cloud is generated before the library is used.
#pragma once

#include "calls.h"
#include "picture_chair.h"
#include "picture_organic.h"
#include "picture_parts.h"
#include "support/csg_nodes.h"

#include <fstream>

namespace bench {

// One thing to draw. It has a mesh or points, or makes a model.
struct PictureInput {
    const char* name;
    PictureMesh (*generate)();
    scenes::Model (*model)(hrbfnpr_context* context);
    const char* script;         // the same solid for the command line
    bool is_height_map = false; // z is known to be up
};

namespace detail {

[[nodiscard]] inline PictureMesh cube() {
    Profiles part;
    const Loop square = {{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}, {0.0, 1.0}};
    part.wall(square, 0.0, square, 1.0);
    for (const bool is_top : {false, true}) part.cap(square, {}, is_top ? 1.0 : 0.0, is_top);
    return part.take();
}

inline constexpr const char* bracket_script =
    "plate = box((6, 4, 0.6), center=(0, 0, 0.3))\n"
    "wall = box((0.6, 3.2, 3.3), center=(-2.3, 0, 1.95))\n"
    "eye = cylinder(1.1, 1, center=(-2.2, 0, 3.6), axis=(1, 0, 0))\n"
    "bore = cylinder(0.6, 3, center=(-2.2, 0, 3.6), axis=(1, 0, 0))\n"
    "left = union(*[cylinder(0.3, 2, center=(0.6 * i - 0.5, -1.2, 0.3)) for i in range(5)])\n"
    "right = union(*[cylinder(0.3, 2, center=(0.6 * i - 0.5, 1.2, 0.3)) for i in range(5)])\n"
    "(plate.blend(wall, 0.6) | eye) - bore - left - right\n";

// Makes the solid of the script.
[[nodiscard]] inline scenes::Model bracket(hrbfnpr_context* context) {
    hrbfnpr::test::CsgNodes solid;
    const auto box = [&](std::int64_t parent, const glm::dvec3& size, const glm::dvec3& at) {
        hrbfnpr_csg_node& node = solid.add(HRBFNPR_CSG_BOX, parent, at.x, at.y, at.z);
        for (int c = 0; c < 3; ++c) node.size[c] = size[c];
    };
    const auto cylinder = [&](std::int64_t parent, double radius, double height, const glm::dvec3& at, bool along_x) {
        hrbfnpr_csg_node& node = solid.add(HRBFNPR_CSG_CYLINDER, parent, at.x, at.y, at.z);
        node.radius = radius;
        node.height = height;
        if (!along_x) return;
        const double turned[9] = {0, 0, -1, 0, 1, 0, 1, 0, 0}; // three columns
        for (int i = 0; i < 9; ++i) node.transform[i / 3 * 4 + i % 3] = turned[i];
    };
    solid.add(HRBFNPR_CSG_DIFFERENCE);
    solid.add(HRBFNPR_CSG_UNION, 0);
    solid.add(HRBFNPR_CSG_UNION, 1).blend = 0.6;
    box(2, {6, 4, 0.6}, {0, 0, 0.3});
    box(2, {0.6, 3.2, 3.3}, {-2.3, 0, 1.95});
    cylinder(1, 1.1, 1, {-2.2, 0, 3.6}, true);
    cylinder(0, 0.6, 3, {-2.2, 0, 3.6}, true);
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 2; ++j) cylinder(0, 0.3, 2, {0.6 * i - 0.5, 2.4 * j - 1.2, 0.3}, false);
    scenes::Check check;
    const hrbfnpr_csg_desc desc = solid.desc();
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_create_csg(context, &desc, &model, check.error()));
    return scenes::Model(model);
}

// A surface with eight knobs and holes between them, with bumps.
inline int tangle(void*, std::int64_t count, const double* points, double* value, double* gradient, double* hessian) {
    if (hessian != nullptr) return 1;
    for (std::int64_t i = 0; i < count; ++i) {
        const double* p = points + 3 * i;
        double sum = 11.8, sines[3], cosines[3];
        for (int c = 0; c < 3; ++c) {
            sum += p[c] * p[c] * (p[c] * p[c] - 5.0);
            sines[c] = std::sin(7.0 * p[c]);
            cosines[c] = std::cos(7.0 * p[c]);
        }
        if (value != nullptr) value[i] = sum + 0.4 * sines[0] * sines[1] * sines[2];
        if (gradient == nullptr) continue;
        for (int c = 0; c < 3; ++c)
            gradient[3 * i + c] =
                p[c] * (4.0 * p[c] * p[c] - 10.0) + 2.8 * cosines[c] * sines[(c + 1) % 3] * sines[(c + 2) % 3];
    }
    return 0;
}

} // namespace detail

[[nodiscard]] inline std::vector<PictureInput> picture_inputs() {
    return {{"organic_5k", [] { return organic(5000); }, nullptr, nullptr},
            {"organic_50k", [] { return organic(50000); }, nullptr, nullptr},
            {"organic_500k", [] { return organic(500000); }, nullptr, nullptr},
            {"cad", cad_part, nullptr, nullptr},
            {"assembly", assembly, nullptr, nullptr},
            {"plate", turntable_plate, nullptr, nullptr},
            {"double", double_sided_chair, nullptr, nullptr},
            {"folded", [] { return folded(36752); }, nullptr, nullptr},
            {"raw_100k", [] { return raw_points(100000); }, nullptr, nullptr},
            {"terrain", [] { return terrain(220); }, nullptr, nullptr, true},
            {"solid", nullptr, detail::bracket, detail::bracket_script},
            {"cube", detail::cube, nullptr, nullptr},
            {"function", nullptr,
             [](hrbfnpr_context* context) {
                 return custom(context, detail::tangle, {2.6, 2.6, 2.6});
             },
             nullptr}};
}

// Writes an input to a folder as a file that the command line draws. A function has no file.
inline void write_input(const PictureInput& input, const std::string& folder) {
    const std::string path = folder + "/" + input.name;
    if (input.generate != nullptr) write_ply(input.generate(), path + ".ply");
    if (input.script != nullptr) std::ofstream(path + ".csg") << input.script;
}

} // namespace bench
