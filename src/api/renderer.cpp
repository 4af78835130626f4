// SPDX-License-Identifier: MIT
#include "api/renderer.h"

#include "api/barrier.h"
#include "api/camera.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/line_set.h"
#include "api/lists.h"
#include "api/model.h"
#include "api/operation.h"
#include "api/shading.h"
#include "api/style.h"
#include "api/views.h"

#include <cstdio>

using namespace hrbfnpr;

namespace hrbfnpr::api {

template <>
hrbfnpr_item defaults() noexcept {
    hrbfnpr_item item{};
    from_matrix(item.transform, glm::dmat4(1.0));
    return item;
}

template <>
hrbfnpr_layer_pose defaults() noexcept {
    return {};
}

namespace {

constexpr std::int64_t most_drawn_items = 1000000;
constexpr std::int64_t most_poses = 65536;
// The number of drawings that a renderer keeps for reuse: one is shown, one is being made, and some are waiting.
constexpr std::int64_t most_kept = 4;

using Items = List<hrbfnpr_item>;

// The elements of a list, handed out from its begin.
template <class T>
class ListParts {
public:
    explicit ListParts(const base::Array<T>& list) noexcept : rest_(list.span()) {}

    [[nodiscard]] std::span<const T> next(std::int64_t count) noexcept {
        const std::span<const T> part = rest_.first(static_cast<std::size_t>(count));
        rest_ = rest_.subspan(part.size());
        return part;
    }

private:
    std::span<const T> rest_;
};

// Reads and checks all items before a drawing is changed.
class ItemReader {
public:
    ItemReader(hrbfnpr_renderer& renderer, const Items& items) noexcept : renderer_(renderer), items_(items) {}

    void operator()() {
        renderer_.items.clear();
        renderer_.styles.clear();
        renderer_.poses.clear();
        for (std::int64_t i = 0; i < items_.count(); ++i) read(items_[i], items_.name(i).text);
        // From here on, the arrays do not move, so spans of them stay valid.
        const StyleLists& lists = renderer_.styles;
        ListParts layers(lists.layers);
        ListParts lines(lists.lines);
        ListParts lights(lists.lights);
        ListParts palette(lists.palette);
        ListParts poses(renderer_.poses);
        for (std::int64_t i = 0; i < items_.count(); ++i) {
            const hrbfnpr_item given = items_[i];
            frame::Item& item = renderer_.items[i];
            const hrbfnpr_style its = given.style == nullptr ? hrbfnpr_style{} : read_struct(given.style, "style");
            item.style.layers = layers.next(its.layer_count);
            item.style.lines = lines.next(its.line_count);
            item.style.lights = lights.next(its.light_count);
            item.style.palette = palette.next(its.palette_count);
            item.poses = poses.next(given.pose_count);
        }
    }

private:
    void read(const hrbfnpr_item& given, const char* name) {
        const Checks checks(name);
        checks.one_of("sides", given.sides, HRBFNPR_SIDES_BOTH + 1, "HRBFNPR_SIDES_*");
        checks.not_null("point_set", given.point_set != nullptr);
        if (given.model != nullptr && given.pose_count > 0)
            fail(Status::invalid_argument,
                 "%s.model is given together with poses; leave one out, because posed marks do not lie on the model",
                 name);
        if (given.line_set != nullptr && given.pose_count > 0)
            fail(Status::invalid_argument,
                 "%s.line_set is given together with poses; leave one out, because a line set does not move with the "
                 "poses",
                 name);
        if (given.shading != nullptr && !given.shading->set.has_marks_of(*given.point_set))
            fail(Status::invalid_argument, "%s.shading was made for another point set", name);
        if (given.shading != nullptr && given.pose_count > 0)
            fail(Status::invalid_argument, "%s.shading is given together with poses; leave one out", name);
        frame::Item item;
        item.shading = given.shading != nullptr ? &given.shading->shading : nullptr;
        item.set = &given.point_set->set;
        item.both_sides = given.sides == HRBFNPR_SIDES_BOTH;
        item.model = given.model != nullptr ? &given.model->implicit() : nullptr;
        const auto first_line = static_cast<std::size_t>(renderer_.styles.lines.size());
        item.lines = given.line_set != nullptr ? &given.line_set->lines : nullptr;
        item.transform = to_matrix(given.transform);
        char part[128];
        std::snprintf(part, sizeof part, "%.60s.style", name);
        if (given.style != nullptr) item.style = checked_style(read_struct(given.style, part), part, renderer_.styles);
        check_curvature(given, renderer_.styles.lines.span().subspan(first_line), part);
        std::snprintf(part, sizeof part, "%.60s.poses", name);
        read_poses(given, part);
        renderer_.items.push_back(item);
    }

    static void check_curvature(const hrbfnpr_item& item, std::span<const frame::LineStyle> lines, const char* style) {
        if (item.line_set == nullptr || item.line_set->lines.has_shape()) return;
        for (const frame::LineStyle& line : lines)
            if (curves::depends_on_view(line.kind) && line.kind != curves::LineKind::contour)
                fail(Status::invalid_argument,
                     "%s has lines that need curvatures; create the item's line set with "
                     "HRBFNPR_LINE_SET_WITH_CURVATURE",
                     style);
    }

    void read_poses(const hrbfnpr_item& item, const char* name) {
        const List<hrbfnpr_layer_pose> list(item.poses, item.pose_count, item.pose_stride, most_poses, name);
        for (std::int64_t i = 0; i < list.count(); ++i) {
            const hrbfnpr_layer_pose given = list[i];
            const ElementName element = list.name(i);
            Checks(element.text).zero("reserved", given.reserved);
            const marks::PointSet& set = item.point_set->set;
            if (given.layer < 0 || given.layer >= set.layers.size())
                fail(Status::invalid_argument,
                     "%s.layer is %lld; it must be at least 0 and below the number of layers in the point set, %lld",
                     element.text, static_cast<long long>(given.layer), static_cast<long long>(set.layers.size()));
            const std::int64_t marks = set.layers[given.layer].count();
            const auto view = [&](const hrbfnpr_array& array, const char* field) {
                char part[128];
                std::snprintf(part, sizeof part, "%.95s.%s", element.text, field);
                return in_view(array, part, points_type, marks);
            };
            frame::Pose pose{given.layer, view(given.position, "position"), view(given.normal, "normal"),
                             view(given.direction, "direction")};
            if (marks > 0 && (pose.position.empty() || pose.normal.empty()))
                fail(Status::invalid_argument, "%s.position or normal is empty; both are needed", element.text);
            renderer_.poses.push_back(pose);
        }
    }

    hrbfnpr_renderer& renderer_;
    const Items& items_;
};

// Returns an idle drawing, or else a new drawing, with a reference for the caller. A drawing is idle if
// only the renderer holds a reference to it. All idle drawings release their point sets.
hrbfnpr_drawing* idle_drawing(hrbfnpr_renderer& renderer) {
    hrbfnpr_drawing* idle = nullptr;
    for (hrbfnpr_drawing* drawing : renderer.drawings) {
        if (!drawing->has_one_reference()) continue;
        drawing->release_owners();
        idle = drawing;
    }
    if (idle != nullptr) {
        idle->add_reference();
        return idle;
    }
    const bool keep = renderer.drawings.size() < most_kept;
    if (keep) renderer.drawings.reserve(most_kept);
    auto* const drawing = make_handle<hrbfnpr_drawing>(renderer.context());
    if (keep) {
        renderer.drawings.push_back(drawing);
        drawing->add_reference();
    }
    return drawing;
}

void fill(hrbfnpr_renderer& renderer, const Items& items, const frame::Camera& camera, const base::Progress& progress,
          hrbfnpr_drawing& drawing) {
    for (std::int64_t i = 0; i < items.count(); ++i) {
        const hrbfnpr_point_set* const set = items[i].point_set;
        drawing.sets.push_back(set);
        set->add_reference();
    }
    renderer.frame.draw(renderer.items.span(), camera, progress, drawing.drawing);
    drawing.drawing.counts.scratch_bytes += renderer.items.bytes() + renderer.styles.bytes() + renderer.poses.bytes();
}

hrbfnpr_drawing* draw(hrbfnpr_renderer& renderer, const Items& items, const hrbfnpr_camera* camera,
                      hrbfnpr_operation* operation) {
    const OperationUse use(operation);
    ItemReader(renderer, items)();
    const frame::Camera view = to_camera(read_struct(camera, "camera"));
    hrbfnpr_drawing* const drawing = idle_drawing(renderer);
    try {
        fill(renderer, items, view, use.progress(), *drawing);
    } catch (...) {
        drawing->drawing.clear();
        release_handle(drawing);
        throw;
    }
    return drawing;
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

hrbfnpr_status hrbfnpr_layer_pose_init(hrbfnpr_layer_pose* pose, uint32_t struct_size) {
    return api::init_struct(pose, struct_size);
}

hrbfnpr_status hrbfnpr_renderer_draw(hrbfnpr_renderer* renderer, const hrbfnpr_item* items, int64_t item_count,
                                     int64_t item_stride, const hrbfnpr_camera* camera, hrbfnpr_drawing** out_drawing,
                                     hrbfnpr_error* error) {
    return hrbfnpr_renderer_draw_with_operation(renderer, items, item_count, item_stride, camera, nullptr, out_drawing,
                                                error);
}

hrbfnpr_status hrbfnpr_renderer_draw_with_operation(hrbfnpr_renderer* renderer, const hrbfnpr_item* items,
                                                    int64_t item_count, int64_t item_stride,
                                                    const hrbfnpr_camera* camera, hrbfnpr_operation* operation,
                                                    hrbfnpr_drawing** out_drawing, hrbfnpr_error* error) {
    return api::guarded_create(out_drawing, "out_drawing", error, [&] {
        auto& handle = api::deref(renderer, "renderer");
        return api::draw(handle, {items, item_count, item_stride, api::most_drawn_items, "items"}, camera, operation);
    });
}

} // extern "C"
