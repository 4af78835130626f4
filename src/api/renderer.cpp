#include "api/renderer.h"

#include "api/barrier.h"
#include "api/camera.h"
#include "api/checks.h"
#include "api/descriptor.h"
#include "api/lists.h"
#include "api/model.h"
#include "api/style.h"
#include "api/views.h"

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

constexpr std::int64_t most_items = 1000000;
// Drawings that a renderer keeps to be filled again: one that is shown, one that is being made, and some in between.
constexpr std::int64_t most_kept = 4;

using Items = List<hrbfnpr_item>;

hrbfnpr_item item_at(const Items& items, std::int64_t i) {
    const ElementName name = items.name(i);
    const hrbfnpr_item item = items[i];
    Checks(name.text).zero("reserved", item.reserved);
    Checks(name.text).given("point_set", item.point_set != nullptr);
    return item;
}

// Reads and checks everything before any drawing is touched.
void read_items(hrbfnpr_renderer& renderer, const Items& items) {
    renderer.styles.clear();
    renderer.poses.clear();
    renderer.items.clear();
    for (std::int64_t i = 0; i < items.count(); ++i) {
        const hrbfnpr_item item = item_at(items, i);
        frame::Item to;
        to.set = &item.point_set->set;
        to.model = item.model != nullptr ? &item.model->implicit() : nullptr;
        to.transform = to_matrix(item.transform);
        renderer.styles.push_back(style_of(item, items.name(i).text));
        read_poses(renderer, item, items.name(i).text);
        renderer.items.push_back(to);
    }
}

// A drawing that only the renderer holds, or a new one.
hrbfnpr_drawing* idle_drawing(hrbfnpr_renderer& renderer) {
    for (hrbfnpr_drawing* drawing : renderer.drawings) {
        if (!drawing->has_one_reference()) continue;
        drawing->add_reference();
        return drawing;
    }
    auto* const drawing = make_handle<hrbfnpr_drawing>(renderer.context());
    if (renderer.drawings.size() < most_kept) {
        const Hold<hrbfnpr_drawing> hold(drawing);
        renderer.drawings.push_back(drawing);
        drawing->add_reference();
    }
    return drawing;
}

} // namespace
} // namespace hrbfnpr::api
