#include "api/renderer.h"

#include "api/barrier.h"
#include "api/camera.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/model.h"
#include "api/style.h"

#include <cstdio>
#include <limits>

using namespace hrbfnpr;

static_assert(static_cast<int>(frame::MarkClass::none) == HRBFNPR_CLASS_NONE);
static_assert(static_cast<int>(frame::MarkClass::front) == HRBFNPR_CLASS_FRONT);
static_assert(static_cast<int>(frame::MarkClass::back) == HRBFNPR_CLASS_BACK);
static_assert(static_cast<int>(frame::MarkClass::silhouette) == HRBFNPR_CLASS_SILHOUETTE);

namespace hrbfnpr::api {

template <>
hrbfnpr_item defaults() noexcept {
    hrbfnpr_item item{};
    from_matrix(item.transform, glm::dmat4(1.0));
    return item;
}

template <>
hrbfnpr_frame_info defaults() noexcept {
    return {};
}

namespace {

constexpr std::int64_t most_items = 1000000;

// The caller's items, which may be larger structs than ours.
class Items {
public:
    Items(const hrbfnpr_item* first, std::int64_t count, std::int64_t stride)
        : first_(reinterpret_cast<const std::byte*>(first)), count_(count), stride_(stride) {
        if (count < 0 || count > most_items)
            fail(Status::invalid_argument, "item_count is %lld; it must be from 0 to %lld",
                 static_cast<long long>(count), static_cast<long long>(most_items));
        if (count == 0) return;
        require_pointer(first, "items");
        check_struct_size<hrbfnpr_item>(first->struct_size, "items[0]");
        if (stride_ == 0) stride_ = first->struct_size;
        constexpr std::int64_t largest = std::int64_t{1} << 32;
        if (stride_ < static_cast<std::int64_t>(smallest_struct) || stride_ > largest)
            fail(Status::invalid_argument, "item_stride is %lld; it must be 0 or the bytes from one item to the next",
                 static_cast<long long>(stride));
    }

    [[nodiscard]] std::int64_t count() const noexcept { return count_; }

    [[nodiscard]] hrbfnpr_item item(std::int64_t i) const {
        char name[40];
        std::snprintf(name, sizeof name, "items[%lld]", static_cast<long long>(i));
        const auto* at = reinterpret_cast<const hrbfnpr_item*>(first_ + i * stride_);
        hrbfnpr_item item = read_struct(at, name);
        Checks(name).zero("reserved", item.reserved);
        Checks(name).given("point_set", item.point_set != nullptr);
        return item;
    }

private:
    const std::byte* first_;
    std::int64_t count_;
    std::int64_t stride_;
};

frame::Style style_of(const hrbfnpr_item& item, std::int64_t i) {
    if (item.style == nullptr) return {};
    char name[48];
    std::snprintf(name, sizeof name, "items[%lld].style", static_cast<long long>(i));
    return checked_style(read_struct(item.style, name), name);
}

// Reads and checks everything before the last frame is given up.
void read_items(hrbfnpr_renderer& renderer, const Items& items) {
    renderer.items.clear();
    renderer.coming.clear();
    for (std::int64_t i = 0; i < items.count(); ++i) {
        const hrbfnpr_item item = items.item(i);
        const implicit::Implicit* const model = item.model != nullptr ? &item.model->implicit() : nullptr;
        renderer.items.push_back({&item.point_set->set, model, style_of(item, i), to_matrix(item.transform)});
        renderer.coming.push_back(item.point_set);
    }
}

hrbfnpr_frame_info describe(const hrbfnpr_renderer& renderer) noexcept {
    const frame::FrameInfo& from = renderer.frame.info();
    hrbfnpr_frame_info info{};
    info.marks = from.marks;
    info.outside = from.outside;
    info.front = from.front;
    info.back = from.back;
    info.silhouette = from.silhouette;
    info.shown = from.shown;
    info.dropped_tone = from.dropped_tone;
    info.dropped_depth = from.dropped_depth;
    info.dropped_zoom = from.dropped_zoom;
    info.dropped_hidden = from.dropped_hidden;
    info.painted = from.painted;
    info.culled = from.culled;
    info.nanoseconds_classify = from.nanoseconds_classify;
    info.nanoseconds_visibility = from.nanoseconds_visibility;
    info.nanoseconds_sort = from.nanoseconds_sort;
    info.nanoseconds_draw = renderer.nanoseconds_draw;
    info.scratch_bytes = from.scratch_bytes + renderer.raster.scratch_bytes() + renderer.items.bytes() +
                         renderer.kept.bytes() + renderer.coming.bytes();
    return info;
}

void prepare(hrbfnpr_renderer& renderer, const Items& items, const hrbfnpr_camera* camera) {
    read_items(renderer, items);
    const frame::Camera view = to_camera(read_struct(camera, "camera"));
    // From here on the last frame is gone.  The new sets are held first: they may be the same.
    for (const hrbfnpr_point_set* set : renderer.coming) set->add_reference();
    renderer.let_go();
    std::swap(renderer.kept, renderer.coming);
    renderer.nanoseconds_draw = 0;
    renderer.frame.prepare(renderer.items.span(), view);
}

} // namespace
} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_renderer_create(hrbfnpr_context* context, hrbfnpr_renderer** out_renderer,
                                       hrbfnpr_error* error) {
    return api::guarded_create(out_renderer, "out_renderer", error,
                               [&] { return api::make_handle<hrbfnpr_renderer>(api::deref(context, "context")); });
}

void hrbfnpr_renderer_retain(hrbfnpr_renderer* renderer) {
    if (renderer != nullptr) renderer->add_reference();
}

void hrbfnpr_renderer_release(hrbfnpr_renderer* renderer) { api::release_handle(renderer); }

hrbfnpr_status hrbfnpr_item_init(hrbfnpr_item* item, uint32_t struct_size) {
    return api::init_struct(item, struct_size);
}

hrbfnpr_status hrbfnpr_frame_info_init(hrbfnpr_frame_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_renderer_prepare(hrbfnpr_renderer* renderer, const hrbfnpr_item* items, int64_t item_count,
                                        int64_t item_stride, const hrbfnpr_camera* camera, hrbfnpr_frame_info* info,
                                        hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        auto& handle = api::deref(renderer, "renderer");
        if (info != nullptr) api::check_output_struct(info, "frame_info");
        api::prepare(handle, api::Items(items, item_count, item_stride), camera);
        if (info != nullptr) api::write_struct(info, api::describe(handle));
    });
}

hrbfnpr_status hrbfnpr_renderer_get_info(const hrbfnpr_renderer* renderer, hrbfnpr_frame_info* info,
                                         hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const auto& handle = api::deref(renderer, "renderer");
        api::check_output_struct(info, "frame_info");
        api::write_struct(info, api::describe(handle));
    });
}

} // extern "C"
