// SPDX-License-Identifier: MIT
// Wrappers of library calls that benchmarks share: contexts, surfaces, marks; and the benchmarks' command line options.
#pragma once

#include "support/generation.h"
#include "vec3.h"

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace bench {

using hrbfnpr::test::Generation;
using hrbfnpr::test::one_layer;

// Returns the rest of the argument that begins with `name`; empty if there is no such argument.
[[nodiscard]] inline std::string option(int argc, char** argv, const char* name) {
    for (int i = 1; i < argc; ++i)
        if (std::strncmp(argv[i], name, std::strlen(name)) == 0) return argv[i] + std::strlen(name);
    return {};
}

[[nodiscard]] inline scenes::Context make_context(std::int32_t threads = 0,
                                                  std::uint32_t instruction_set = HRBFNPR_INSTRUCTION_SET_AUTO) {
    scenes::Check check;
    hrbfnpr_context_desc desc;
    check(hrbfnpr_context_desc_init(&desc, sizeof desc));
    desc.thread_count = threads;
    desc.highest_instruction_set = instruction_set;
    hrbfnpr_context* context = nullptr;
    check(hrbfnpr_context_create(&desc, &context, check.error()));
    return scenes::Context(context);
}

// Makes a custom model in the box from -half to half.
[[nodiscard]] inline scenes::Model custom(hrbfnpr_context* context, hrbfnpr_implicit_fn function, const Vec3& half) {
    scenes::Check check;
    hrbfnpr_custom_desc desc;
    check(hrbfnpr_custom_desc_init(&desc, sizeof desc));
    desc.flags = HRBFNPR_CUSTOM_HAS_GRADIENT | HRBFNPR_CUSTOM_THREAD_SAFE;
    desc.function = function;
    for (std::size_t c = 0; c < 3; ++c) {
        desc.bounds_min[c] = -half[c];
        desc.bounds_max[c] = half[c];
    }
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_create_custom(context, &desc, &model, check.error()));
    return scenes::Model(model);
}

// Views packed x y z as an array.
[[nodiscard]] inline hrbfnpr_array view(const std::vector<double>& numbers) {
    return {numbers.data(), static_cast<std::int64_t>(numbers.size() / 3), 0, HRBFNPR_SCALAR_FLOAT64, 3};
}

[[nodiscard]] inline scenes::Model fit(hrbfnpr_context* context, const std::vector<double>& points,
                                       const std::vector<double>& normals, std::uint32_t trim = HRBFNPR_TRIM_AUTO) {
    scenes::Check check;
    hrbfnpr_fit_desc desc;
    check(hrbfnpr_fit_desc_init(&desc, sizeof desc));
    desc.points = view(points);
    desc.normals = view(normals);
    desc.trim = trim;
    hrbfnpr_model* model = nullptr;
    check(hrbfnpr_model_fit(context, &desc, nullptr, &model, check.error()));
    return scenes::Model(model);
}

// A named style whose layers can be changed.
struct Style : hrbfnpr_style {
    explicit Style(std::uint32_t preset) : hrbfnpr_style{} {
        scenes::Check check;
        check(hrbfnpr_style_init_preset(this, sizeof(hrbfnpr_style), preset, check.error()));
        layer.assign(layers, layers + layer_count);
        layers = nullptr; // get() sets the pointer
    }
    // Returns the style for a call.
    const hrbfnpr_style* get() {
        layers = layer.data();
        layer_count = static_cast<std::int64_t>(layer.size());
        return this;
    }
    // Returns the first layer that applies to marks of this kind, or the defaults.
    [[nodiscard]] hrbfnpr_layer_style of(std::uint32_t kind) const {
        for (const hrbfnpr_layer_style& one : layer)
            if (one.kind == kind || one.kind == HRBFNPR_LAYER_KIND_ANY) return one;
        hrbfnpr_layer_style defaults;
        scenes::Check()(hrbfnpr_layer_style_init(&defaults, sizeof defaults));
        return defaults;
    }
    std::vector<hrbfnpr_layer_style> layer;
};

// The style "full" with its lines replaced by dots of one pen in the dark parts, so that each mark costs as much as a
// stipple.
[[nodiscard]] inline Style full_of_dots() {
    Style style(HRBFNPR_PRESET_FULL);
    for (hrbfnpr_layer_style& layer : style.layer)
        if (layer.kind == HRBFNPR_LAYER_KIND_HATCH) {
            layer.shape = HRBFNPR_SHAPE_DOTS;
            layer.radius = 1.0F;
            layer.share = 0.6F;
        }
    return style;
}

inline scenes::PointSet generate(hrbfnpr_context* context, const hrbfnpr_model* model, Generation desc) {
    scenes::Check check;
    hrbfnpr_point_set* set = nullptr;
    check(hrbfnpr_point_set_generate(context, model, desc.get(), nullptr, &set, check.error()));
    return scenes::PointSet(set);
}

// Returns the values of one attribute; sets `count` to the number of marks that have it.
template <class T>
[[nodiscard]] const T* attribute(const hrbfnpr_point_set* set, std::int64_t layer, std::uint32_t which,
                                 std::int64_t& count) {
    scenes::Check check;
    hrbfnpr_array array{};
    check(hrbfnpr_point_set_view(set, layer, which, &array, check.error()));
    count = array.count;
    return static_cast<const T*>(array.data);
}

[[nodiscard]] inline hrbfnpr_point_set_info info_of(const hrbfnpr_point_set* set) {
    scenes::Check check;
    hrbfnpr_point_set_info info;
    check(hrbfnpr_point_set_info_init(&info, sizeof info));
    check(hrbfnpr_point_set_get_info(set, &info, check.error()));
    return info;
}

[[nodiscard]] inline hrbfnpr_layer_info layer_info(const hrbfnpr_point_set* set, std::int64_t layer) {
    scenes::Check check;
    hrbfnpr_layer_info info;
    check(hrbfnpr_layer_info_init(&info, sizeof info));
    check(hrbfnpr_point_set_get_layer_info(set, layer, &info, check.error()));
    return info;
}

} // namespace bench
