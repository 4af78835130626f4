// SPDX-License-Identifier: MIT
#include "api/point_set.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/streams.h"
#include "api/views.h"
#include "io/files.h"
#include "marks/fields.h"
#include "marks/point_set.h"

#include <cstring>

using namespace hrbfnpr;

hrbfnpr_point_set::~hrbfnpr_point_set() { api::release_handle(owner_); }

namespace hrbfnpr::api {

template <>
hrbfnpr_point_set_info defaults() noexcept {
    return {};
}

template <>
hrbfnpr_layer_info defaults() noexcept {
    return {};
}

template <>
hrbfnpr_placement_info defaults() noexcept {
    return {};
}

hrbfnpr_point_set* adopt(hrbfnpr_context& context, marks::PointSet&& set) {
    marks::cluster_marks(context.runtime, set);
    return make_handle<hrbfnpr_point_set>(context, std::move(set));
}

namespace {

hrbfnpr_placement_info describe(const marks::LevelReport& level) noexcept {
    hrbfnpr_placement_info info{};
    info.attempted = level.attempted;
    info.placed = level.placed;
    info.dropped_not_converged = level.dropped_not_converged;
    info.dropped_strayed = level.dropped_strayed;
    info.dropped_degenerate = level.dropped_degenerate;
    info.dropped_budget = level.dropped_budget;
    return info;
}

hrbfnpr_layer_info describe(const marks::Layer& layer) noexcept {
    hrbfnpr_layer_info info{};
    static_assert(sizeof info.name == sizeof layer.name);
    info.kind = static_cast<std::uint32_t>(layer.kind);
    std::memcpy(info.name, layer.name.data(), sizeof info.name);
    info.marks = layer.count();
    info.strokes = layer.strokes();
    info.full_count = layer.report.full_count;
    info.levels = layer.report.levels;
    info.step = layer.report.step;
    info.seconds = layer.report.seconds;
    return info;
}

hrbfnpr_point_set_info describe(const hrbfnpr_point_set& handle) noexcept {
    const marks::PointSet& set = handle.set;
    hrbfnpr_point_set_info info{};
    info.distribution = static_cast<std::uint32_t>(set.distribution);
    info.seed_source = static_cast<std::uint32_t>(set.seed_source);
    info.layers = set.layers.size();
    info.marks = set.count();
    for (int axis = 0; axis < 3; ++axis) {
        info.origin[axis] = set.origin[axis];
        info.bounds_min[axis] = set.bounds.min[axis];
        info.bounds_max[axis] = set.bounds.max[axis];
    }
    info.spacing = set.spacing;
    info.seconds_seeds = set.seconds_seeds;
    info.seconds_total = set.seconds_total;
    info.bytes = set.bytes() + std::int64_t{sizeof(hrbfnpr_point_set)};
    if (&handle.owner() != &handle) info.bytes += handle.owner().set.bytes();
    info.field_count = marks::field_count(set);
    return info;
}

hrbfnpr_placement_info placement_of(const marks::Layer& layer, std::int32_t level) {
    if (level < 0 || level > layer.report.levels)
        fail(Status::invalid_argument, "level is %d; it must be from 0 to %d", static_cast<int>(level),
             static_cast<int>(layer.report.levels));
    return describe(level < layer.report.level.size() ? layer.report.level[level] : marks::LevelReport{});
}

hrbfnpr_array view_of(const marks::Layer& layer, std::uint32_t attribute) {
    switch (attribute) {
    case HRBFNPR_MARK_ATTRIBUTE_POSITION: return packed_view(layer.position, HRBFNPR_SCALAR_FLOAT32, 3);
    case HRBFNPR_MARK_ATTRIBUTE_NORMAL: return packed_view(layer.normal, HRBFNPR_SCALAR_FLOAT32, 3);
    case HRBFNPR_MARK_ATTRIBUTE_DIRECTION: return packed_view(layer.direction, HRBFNPR_SCALAR_FLOAT32, 3);
    case HRBFNPR_MARK_ATTRIBUTE_CURVATURE: return packed_view(layer.curvature, HRBFNPR_SCALAR_FLOAT32, 3);
    case HRBFNPR_MARK_ATTRIBUTE_RANK: return packed_view(layer.rank, HRBFNPR_SCALAR_FLOAT32, 1);
    case HRBFNPR_MARK_ATTRIBUTE_LEVEL: return packed_view(layer.level, HRBFNPR_SCALAR_UINT8, 1);
    case HRBFNPR_MARK_ATTRIBUTE_STROKE: return packed_view(layer.stroke, HRBFNPR_SCALAR_UINT32, 2);
    case HRBFNPR_MARK_ATTRIBUTE_WIDTH: return packed_view(layer.width, HRBFNPR_SCALAR_FLOAT32, 1);
    case HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST: return packed_view(layer.stroke_first, HRBFNPR_SCALAR_UINT32, 1);
    case HRBFNPR_MARK_ATTRIBUTE_STROKE_ORDER: return packed_view(layer.stroke_order, HRBFNPR_SCALAR_UINT32, 1);
    case HRBFNPR_MARK_ATTRIBUTE_TONE_NORMAL: return packed_view(layer.tone_normal, HRBFNPR_SCALAR_FLOAT32, 3);
    default:
        fail(Status::invalid_argument, "attribute is %u; it must be one of HRBFNPR_MARK_ATTRIBUTE_* (0 to 10)",
             attribute);
    }
}

// Refuses to save the marks of a still picture: the file could not tell which cameras they are for.
void require_whole(const marks::PointSet& set) {
    if (!set.still.empty())
        fail(Status::invalid_argument,
             "set has only the marks that a still picture needs; make it by hrbfnpr_point_set_generate, or the picture "
             "with HRBFNPR_PICTURE_KEEP_MARKS");
}

hrbfnpr_point_set* read_set(hrbfnpr_context& context, io::Reader& reader) {
    return adopt(context, io::load_point_set(context.runtime.memory, reader));
}

} // namespace

const marks::Layer& layer_of(const marks::PointSet& set, std::int64_t layer) {
    if (layer < 0 || layer >= set.layers.size())
        fail(Status::invalid_argument, "layer is %lld; it must be at least 0 and below the number of layers, %lld",
             static_cast<long long>(layer), static_cast<long long>(set.layers.size()));
    return set.layers[layer];
}

} // namespace hrbfnpr::api

extern "C" {

void hrbfnpr_point_set_retain(const hrbfnpr_point_set* set) {
    if (set != nullptr) set->add_reference();
}

void hrbfnpr_point_set_release(const hrbfnpr_point_set* set) { api::release_handle(set); }

hrbfnpr_status hrbfnpr_point_set_info_init(hrbfnpr_point_set_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_point_set_get_info(const hrbfnpr_point_set* set, hrbfnpr_point_set_info* info,
                                          hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(set, "set");
        api::check_output_struct(info, "point_set_info");
        api::write_struct(info, api::describe(handle));
    });
}

hrbfnpr_status hrbfnpr_layer_info_init(hrbfnpr_layer_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_point_set_get_layer_info(const hrbfnpr_point_set* set, int64_t layer, hrbfnpr_layer_info* info,
                                                hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(set, "set");
        api::check_output_struct(info, "layer_info");
        api::write_struct(info, api::describe(api::layer_of(handle.set, layer)));
    });
}

hrbfnpr_status hrbfnpr_placement_info_init(hrbfnpr_placement_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_point_set_get_seed_placement(const hrbfnpr_point_set* set, hrbfnpr_placement_info* info,
                                                    hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(set, "set");
        api::check_output_struct(info, "placement_info");
        api::write_struct(info, api::describe(handle.set.seeds));
    });
}

hrbfnpr_status hrbfnpr_point_set_get_placement(const hrbfnpr_point_set* set, int64_t layer, int32_t level,
                                               hrbfnpr_placement_info* info, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(set, "set");
        api::check_output_struct(info, "placement_info");
        api::write_struct(info, api::placement_of(api::layer_of(handle.set, layer), level));
    });
}

hrbfnpr_status hrbfnpr_point_set_view(const hrbfnpr_point_set* set, int64_t layer, uint32_t attribute,
                                      hrbfnpr_array* out_view, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(set, "set");
        api::require_pointer(out_view, "out_view");
        *out_view = api::view_of(api::layer_of(handle.set, layer), attribute);
    });
}

hrbfnpr_status hrbfnpr_point_set_save(const hrbfnpr_point_set* set, hrbfnpr_write_fn write, void* user,
                                      hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(set, "set");
        if (write == nullptr) fail(Status::invalid_argument, "write is NULL");
        api::CallbackWriter writer(write, user);
        api::require_whole(handle.set);
        io::save_point_set(handle.set, writer);
    });
}

hrbfnpr_status hrbfnpr_point_set_save_memory(const hrbfnpr_point_set* set, void* destination, int64_t capacity,
                                             int64_t* size, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(set, "set");
        api::require_whole(handle.set);
        api::save_to_memory(destination, capacity, size,
                            [&](io::Writer& writer) { io::save_point_set(handle.set, writer); });
    });
}

hrbfnpr_status hrbfnpr_point_set_load(hrbfnpr_context* context, hrbfnpr_read_fn read, void* user,
                                      hrbfnpr_point_set** out_point_set, hrbfnpr_error* error) {
    return api::guarded_create(out_point_set, "out_point_set", error, [&] {
        auto& parent = api::deref(context, "context");
        if (read == nullptr) fail(Status::invalid_argument, "read is NULL");
        api::CallbackReader reader(read, user);
        return api::read_set(parent, reader);
    });
}

hrbfnpr_status hrbfnpr_point_set_load_memory(hrbfnpr_context* context, const void* data, int64_t size,
                                             hrbfnpr_point_set** out_point_set, hrbfnpr_error* error) {
    return api::guarded_create(out_point_set, "out_point_set", error, [&] {
        auto& parent = api::deref(context, "context");
        io::MemoryReader reader = api::memory_reader(data, size);
        return api::read_set(parent, reader);
    });
}

} // extern "C"
