// SPDX-License-Identifier: MIT
#include "api/shading.h"

#include "api/barrier.h"
#include "api/camera.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/line_set.h"
#include "api/lists.h"
#include "api/operation.h"
#include "api/point_set.h"
#include "api/style.h"
#include "api/views.h"
#include "frame/scene/shadow_lines.h"

using namespace hrbfnpr;

hrbfnpr_occluders::hrbfnpr_occluders(hrbfnpr_context& context, base::Array<const hrbfnpr_line_set*>&& line_sets,
                                     frame::Casters&& made)
    : Child(context), sets(std::move(line_sets)), casters(std::move(made)) {
    for (const hrbfnpr_line_set* const set : sets) set->add_reference();
}

hrbfnpr_occluders::~hrbfnpr_occluders() {
    for (const hrbfnpr_line_set* const set : sets) api::release_handle(set);
}

hrbfnpr_shading::hrbfnpr_shading(hrbfnpr_context& context, const hrbfnpr_point_set& of, frame::Shading&& made)
    : Child(context), set(of), shading(std::move(made)) {
    set.add_reference();
}

hrbfnpr_shading::~hrbfnpr_shading() { api::release_handle(&set); }

namespace hrbfnpr::api {
namespace {

constexpr std::int64_t most_casting_items = 65536;
constexpr double lines_begin = 0.6; // the share of a shading's time after which borders of shadows are found

[[nodiscard]] constexpr auto shading_fields() noexcept {
    using Given = hrbfnpr_shading_desc;
    using To = frame::ShadingSettings;
    return FieldTable{field("sky_rays", &Given::sky_rays, &To::sky_rays, rule::Between{1.0, 4096.0}),
                      field("shadow_rays", &Given::shadow_rays, &To::shadow_rays, rule::Between{1.0, 4096.0}),
                      field("flags", &Given::flags, rule::Flags{HRBFNPR_SHADING_WITH_LINES}),
                      field("occlusion_reach", &Given::occlusion_reach, &To::reach, rule::Between{0.0, 100.0}),
                      field("previous", &Given::previous, rule::Any{}),
                      field("curvature_scale", &Given::curvature_scale, &To::curvature_scale, rule::Between{0.0, 1.0})};
}
static_assert(shading_fields().covers<hrbfnpr_shading_desc>());

hrbfnpr_occluders* create(hrbfnpr_context& context, const List<hrbfnpr_item>& items, hrbfnpr_operation* operation) {
    const OperationUse use(operation);
    base::Array<frame::Caster> casters(context.runtime.memory);
    base::Array<const hrbfnpr_line_set*> sets(context.runtime.memory);
    for (std::int64_t i = 0; i < items.count(); ++i) {
        const hrbfnpr_item item = items[i];
        if (item.line_set == nullptr) continue;
        const curves::LineSet& lines = item.line_set->lines;
        casters.push_back({&lines.mesh(), to_matrix(item.transform), &lines});
        sets.push_back(item.line_set);
    }
    if (casters.empty())
        fail(Status::invalid_argument, "items have no line_set; what casts shadows is the surface of a line set");
    return use.finish_with(make_handle<hrbfnpr_occluders>(
        context, std::move(sets), frame::casters_of({context.runtime, use.progress()}, std::as_const(casters).span())));
}

hrbfnpr_shading* create(hrbfnpr_context& context, const hrbfnpr_occluders& occluders, const hrbfnpr_item& item,
                        const hrbfnpr_camera* camera, const hrbfnpr_shading_desc& desc, hrbfnpr_operation* operation) {
    const OperationUse use(operation);
    const Checks checks("item");
    checks.not_null("point_set", item.point_set != nullptr);
    if (item.pose_count > 0) fail(Status::invalid_argument, "item.poses are given; posed marks cannot be shaded");
    shading_fields().check("shading_desc", desc);
    const bool with_lines = (desc.flags & HRBFNPR_SHADING_WITH_LINES) != 0;
    if (with_lines && item.line_set == nullptr)
        fail(Status::invalid_argument, "item.line_set is NULL; HRBFNPR_SHADING_WITH_LINES needs it, because borders of "
                                       "shadows lie on its surface");
    StyleLists lists(context.runtime.memory);
    const frame::Style style = checked_style(read_optional_struct(item.style, "item.style"), "item.style", lists);
    if (lists.lights.empty()) lists.lights.push_back(style.key_light());
    frame::ShadingSettings settings;
    shading_fields().copy(desc, settings);
    if (desc.previous != nullptr && !desc.previous->set.has_marks_of(*item.point_set))
        fail(Status::invalid_argument, "shading_desc.previous was made for another point set");
    if (desc.previous != nullptr) settings.previous = &desc.previous->shading;
    settings.reach *= occluders.casters.diagonal;
    frame::ShadedItem shaded{&item.point_set->set, to_matrix(item.transform), std::as_const(lists.lights).span(),
                             glm::dmat4(1.0)};
    const bool needs_camera = std::any_of(lists.lights.begin(), lists.lights.end(), [](const frame::LightStyle& light) {
        return light.space == frame::LightSpace::camera && light.shadow > 0.0F;
    });
    if (needs_camera) shaded.view = to_camera(read_struct(camera, "camera")).view;
    if (style.curvature_contrast > 0.0F && desc.curvature_scale > 0.0) {
        if (item.line_set == nullptr)
            fail(Status::invalid_argument,
                 "item.style.curvature_contrast is %g, but item.line_set is NULL; give a line set, on whose mesh "
                 "curvature is measured, or set shading_desc.curvature_scale to 0",
                 static_cast<double>(style.curvature_contrast));
        shaded.mesh = &item.line_set->lines.mesh();
    }
    const base::Work work(context.runtime, use.progress());
    frame::Shading shading =
        frame::find_shading(work.part(0.0, with_lines ? lines_begin : 1.0), occluders.casters, shaded, settings);
    if (with_lines) {
        shaded.lines = &item.line_set->lines;
        shading.lines = frame::find_shadow_lines(work.part(lines_begin, 1.0), occluders.casters, shaded);
    }
    return use.finish_with(make_handle<hrbfnpr_shading>(context, *item.point_set, std::move(shading)));
}

hrbfnpr_array view_of(const hrbfnpr_shading& handle, std::int64_t layer, std::int64_t light) {
    (void)layer_of(handle.set.set, layer);
    if (light < -1 || light >= frame::most_lights)
        fail(Status::invalid_argument, "light is %lld; it must be from -1 to %lld", static_cast<long long>(light),
             static_cast<long long>(frame::most_lights - 1));
    const std::span<const float> shares = handle.shading.of_layer(layer, light);
    if (shares.empty() && light < 0)
        fail(Status::invalid_argument, "light is -1; the shading has no occlusion, because occlusion_reach was 0");
    if (shares.empty())
        fail(Status::invalid_argument, "light is %lld; this light casts no shadow", static_cast<long long>(light));
    return {shares.data(), static_cast<std::int64_t>(shares.size()), sizeof(float), HRBFNPR_SCALAR_FLOAT32, 1};
}

} // namespace

template <>
hrbfnpr_shading_desc defaults() noexcept {
    hrbfnpr_shading_desc desc{};
    shading_fields().set_defaults(frame::ShadingSettings{}, desc);
    desc.occlusion_reach = 0.35;
    desc.curvature_scale = 0.02;
    return desc;
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_occluders_create(hrbfnpr_context* context, const hrbfnpr_item* items, int64_t item_count,
                                        int64_t item_stride, hrbfnpr_operation* operation,
                                        hrbfnpr_occluders** out_occluders, hrbfnpr_error* error) {
    return api::guarded_create(out_occluders, "out_occluders", error, [&] {
        return api::create(api::deref(context, "context"),
                           {items, item_count, item_stride, api::most_casting_items, "items"}, operation);
    });
}

void hrbfnpr_occluders_retain(const hrbfnpr_occluders* occluders) {
    if (occluders != nullptr) occluders->add_reference();
}

void hrbfnpr_occluders_release(const hrbfnpr_occluders* occluders) { api::release_handle(occluders); }

hrbfnpr_status hrbfnpr_shading_desc_init(hrbfnpr_shading_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_shading_create(hrbfnpr_context* context, const hrbfnpr_occluders* occluders,
                                      const hrbfnpr_item* item, const hrbfnpr_camera* camera,
                                      const hrbfnpr_shading_desc* desc, hrbfnpr_operation* operation,
                                      hrbfnpr_shading** out_shading, hrbfnpr_error* error) {
    return api::guarded_create(out_shading, "out_shading", error, [&] {
        return api::create(api::deref(context, "context"), api::deref(occluders, "occluders"),
                           api::read_struct(item, "item"), camera, api::read_optional_struct(desc, "shading_desc"),
                           operation);
    });
}

hrbfnpr_status hrbfnpr_shading_view(const hrbfnpr_shading* shading, int64_t layer, int64_t light,
                                    hrbfnpr_array* out_view, hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const hrbfnpr_shading& handle = api::deref(shading, "shading");
        api::deref(out_view, "out_view") = api::view_of(handle, layer, light);
    });
}

void hrbfnpr_shading_retain(const hrbfnpr_shading* shading) {
    if (shading != nullptr) shading->add_reference();
}

void hrbfnpr_shading_release(const hrbfnpr_shading* shading) { api::release_handle(shading); }

} // extern "C"
