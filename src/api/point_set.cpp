#include "api/point_set.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/streams.h"
#include "io/files.h"
#include "marks/cluster_marks.h"

using namespace hrbfnpr;

namespace hrbfnpr::api {

template <>
hrbfnpr_point_set_info defaults() noexcept {
    return {};
}

hrbfnpr_point_set* adopt(hrbfnpr_context& context, marks::PointSet&& set) {
    marks::cluster_marks(context.runtime, set);
    return make_handle<hrbfnpr_point_set>(context, std::move(set));
}

namespace {

static_assert(marks::most_levels + 1 == sizeof(hrbfnpr_group_info::level) / sizeof(hrbfnpr_level_info));

hrbfnpr_level_info describe(const marks::LevelReport& level) noexcept {
    return {level.attempted,          level.placed,        level.dropped_not_converged, level.dropped_strayed,
            level.dropped_degenerate, level.dropped_budget};
}

hrbfnpr_group_info describe(const marks::MarkGroup& group) noexcept {
    hrbfnpr_group_info info{};
    info.count = group.count();
    info.strokes = group.report.strokes;
    info.full_count = group.report.full_count;
    info.levels = group.report.levels;
    info.step = group.report.step;
    info.seconds = group.report.seconds;
    for (std::size_t i = 0; i < group.report.level.size(); ++i) info.level[i] = describe(group.report.level[i]);
    return info;
}

hrbfnpr_point_set_info describe(const marks::PointSet& set) noexcept {
    hrbfnpr_point_set_info info{};
    info.distribution = static_cast<std::uint32_t>(set.distribution);
    info.seed_source = static_cast<std::uint32_t>(set.seed_source);
    for (int axis = 0; axis < 3; ++axis) {
        info.origin[axis] = set.origin[axis];
        info.bounds_min[axis] = set.bounds.min[axis];
        info.bounds_max[axis] = set.bounds.max[axis];
    }
    info.spacing = set.spacing;
    info.seconds_seeds = set.seconds_seeds;
    info.seconds_total = set.seconds_total;
    info.bytes = set.bytes() + std::int64_t{sizeof(hrbfnpr_point_set)};
    info.seeds = describe(set.seeds);
    for (std::size_t i = 0; i < set.group.size(); ++i) info.group[i] = describe(set.group[i]);
    return info;
}

template <class T>
hrbfnpr_array view(const base::Array<T>& array, std::uint32_t scalar, std::uint32_t components) noexcept {
    return {array.data(), array.size() / components, static_cast<std::int64_t>(sizeof(T)) * components, scalar,
            components};
}

hrbfnpr_array view_of(const marks::PointSet& set, std::uint32_t group, std::uint32_t attribute) {
    if (group >= HRBFNPR_GROUP_COUNT)
        fail(Status::invalid_argument, "group is %u; it must be one of HRBFNPR_GROUP_... (0 to 2)", group);
    const marks::MarkGroup& marks = set.group[group];
    switch (attribute) {
    case HRBFNPR_ATTRIBUTE_POSITION: return view(marks.position, HRBFNPR_SCALAR_FLOAT32, 3);
    case HRBFNPR_ATTRIBUTE_NORMAL: return view(marks.normal, HRBFNPR_SCALAR_FLOAT32, 3);
    case HRBFNPR_ATTRIBUTE_DIRECTION: return view(marks.direction, HRBFNPR_SCALAR_FLOAT32, 3);
    case HRBFNPR_ATTRIBUTE_CURVATURE: return view(marks.curvature, HRBFNPR_SCALAR_FLOAT32, 3);
    case HRBFNPR_ATTRIBUTE_RANK: return view(marks.rank, HRBFNPR_SCALAR_FLOAT32, 1);
    case HRBFNPR_ATTRIBUTE_LEVEL: return view(marks.level, HRBFNPR_SCALAR_UINT8, 1);
    case HRBFNPR_ATTRIBUTE_STROKE: return view(marks.stroke, HRBFNPR_SCALAR_UINT32, 2);
    case HRBFNPR_ATTRIBUTE_WIDTH: return view(marks.width, HRBFNPR_SCALAR_FLOAT32, 1);
    default:
        fail(Status::invalid_argument, "attribute is %u; it must be one of HRBFNPR_ATTRIBUTE_... (0 to 7)", attribute);
    }
}

hrbfnpr_point_set* load(hrbfnpr_context& context, io::Reader& reader) {
    return adopt(context, io::load_point_set(context.runtime.memory, reader));
}

} // namespace
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
        api::write_struct(info, api::describe(handle.set));
    });
}

hrbfnpr_status hrbfnpr_point_set_view(const hrbfnpr_point_set* set, uint32_t group, uint32_t attribute,
                                      hrbfnpr_array* out_view, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(set, "set");
        api::require_pointer(out_view, "out_view");
        *out_view = api::view_of(handle.set, group, attribute);
    });
}

hrbfnpr_status hrbfnpr_point_set_save(const hrbfnpr_point_set* set, hrbfnpr_write_fn write, void* user,
                                      hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(set, "set");
        if (write == nullptr) fail(Status::invalid_argument, "write is NULL");
        api::CallbackWriter writer(write, user);
        io::save_point_set(handle.set, writer);
    });
}

hrbfnpr_status hrbfnpr_point_set_save_memory(const hrbfnpr_point_set* set, void* destination, int64_t capacity,
                                             int64_t* size, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(set, "set");
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
        return api::load(parent, reader);
    });
}

hrbfnpr_status hrbfnpr_point_set_load_memory(hrbfnpr_context* context, const void* data, int64_t size,
                                             hrbfnpr_point_set** out_point_set, hrbfnpr_error* error) {
    return api::guarded_create(out_point_set, "out_point_set", error, [&] {
        auto& parent = api::deref(context, "context");
        io::MemoryReader reader = api::memory_reader(data, size);
        return api::load(parent, reader);
    });
}

} // extern "C"
