// SPDX-License-Identifier: MIT
// Makes point sets from the caller's arrays.
#include "marks/assemble.h"

#include "api/barrier.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/layers.h"
#include "api/lists.h"
#include "api/point_set.h"
#include "api/views.h"

#include <cstdio>

using namespace hrbfnpr;

namespace hrbfnpr::api {

template <>
hrbfnpr_layer_arrays defaults() noexcept {
    hrbfnpr_layer_arrays arrays{};
    arrays.kind = HRBFNPR_LAYER_KIND_OWN;
    return arrays;
}

template <>
hrbfnpr_point_set_desc defaults() noexcept {
    hrbfnpr_point_set_desc desc{};
    desc.random_seed = 1;
    return desc;
}

namespace {

marks::LayerArrays checked(const hrbfnpr_layer_arrays& arrays, const char* owner) {
    if (arrays.kind < HRBFNPR_LAYER_KIND_STIPPLES || arrays.kind > HRBFNPR_LAYER_KIND_OWN)
        fail(Status::invalid_argument, "%s.kind is %u; it must be HRBFNPR_LAYER_KIND_STIPPLES, _HATCH or _OWN (1 to 3)",
             owner, arrays.kind);
    const auto view = [&](const hrbfnpr_array& array, const char* field, ArrayType type) {
        char name[128];
        std::snprintf(name, sizeof name, "%s.%s", owner, field);
        return in_view(array, name, type);
    };
    marks::LayerArrays checked;
    checked.kind = static_cast<marks::Kind>(arrays.kind);
    checked.name = checked_name(arrays.name, owner);
    checked.position = view(arrays.position, "position", points_type);
    checked.normal = view(arrays.normal, "normal", points_type);
    checked.stroke_first = view(arrays.stroke_first, "stroke_first", {1, uint32_only});
    checked.stroke_direction = view(arrays.stroke_direction, "stroke_direction", {1, uint8_only});
    checked.direction = view(arrays.direction, "direction", points_type);
    checked.curvature = view(arrays.curvature, "curvature", points_type);
    checked.rank = view(arrays.rank, "rank", number_type);
    checked.level = view(arrays.level, "level", {1, uint8_only});
    checked.width = view(arrays.width, "width", number_type);
    return checked;
}

hrbfnpr_point_set* create(hrbfnpr_context& context, const hrbfnpr_point_set_desc& desc) {
    Checks("point_set_desc").zero("reserved", desc.reserved);
    const List<hrbfnpr_layer_arrays> given(desc.layers, desc.layer_count, desc.layer_stride, marks::most_layers,
                                           "point_set_desc.layers");
    base::Array<marks::LayerArrays> arrays(context.runtime.memory);
    for (std::int64_t i = 0; i < given.count(); ++i) arrays.push_back(checked(given[i], given.name(i).text));
    const marks::PointSet* const base = desc.base != nullptr ? &desc.base->set : nullptr;
    return adopt(context, marks::from_arrays(context.runtime, base, arrays.span(), desc.random_seed));
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_layer_arrays_init(hrbfnpr_layer_arrays* arrays, uint32_t struct_size) {
    return api::init_struct(arrays, struct_size);
}

hrbfnpr_status hrbfnpr_point_set_desc_init(hrbfnpr_point_set_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_point_set_create(hrbfnpr_context* context, const hrbfnpr_point_set_desc* desc,
                                        hrbfnpr_point_set** out_point_set, hrbfnpr_error* error) {
    return api::guarded_create(out_point_set, "out_point_set", error, [&] {
        return api::create(api::deref(context, "context"), api::read_struct(desc, "point_set_desc"));
    });
}

} // extern "C"
