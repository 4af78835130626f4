// SPDX-License-Identifier: MIT
// Conditions that every point set must meet, whatever its source.
#include "fuzz.h"

#include <cmath>

namespace fuzz {
namespace {

hrbfnpr_array view_of(const hrbfnpr_point_set* set, std::int64_t layer, std::uint32_t attribute) {
    Call call("point_set_view");
    hrbfnpr_array view;
    call.expect(hrbfnpr_point_set_view(set, layer, attribute, &view, call.error()));
    require(view.count >= 0 && (view.count == 0 || view.data != nullptr), "a view of marks has an address");
    return view;
}

template <class T>
std::span<const T> elements(const hrbfnpr_point_set* set, std::int64_t layer, std::uint32_t attribute) {
    const hrbfnpr_array view = view_of(set, layer, attribute);
    return {static_cast<const T*>(view.data), static_cast<std::size_t>(view.count * view.components)};
}

std::span<const float> floats(const hrbfnpr_point_set* set, std::int64_t layer, std::uint32_t attribute) {
    return elements<float>(set, layer, attribute);
}

// The strokes divide an order of all marks into consecutive parts.
void require_sound_strokes(const hrbfnpr_point_set* set, std::int64_t layer, const hrbfnpr_layer_info& info) {
    const auto first = elements<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE_FIRST);
    const auto order = elements<std::uint32_t>(set, layer, HRBFNPR_MARK_ATTRIBUTE_STROKE_ORDER);
    require(static_cast<std::int64_t>(first.size()) == (first.empty() ? 0 : info.strokes + 1), "strokes are counted");
    require(first.empty() || (first.front() == 0 && first.back() == info.marks), "strokes have all marks");
    for (std::size_t i = 1; i < first.size(); ++i) require(first[i - 1] <= first[i], "strokes follow each other");
    require(order.empty() || static_cast<std::int64_t>(order.size()) == info.marks, "an order has all marks");
    for (const std::uint32_t mark : order) require(mark < info.marks, "an order is one of marks");
}

void require_finite(std::span<const float> numbers, const char* contract) {
    for (const float number : numbers) require(std::isfinite(number), contract);
}

} // namespace

void require_sound_marks(const hrbfnpr_point_set* set) {
    Call call("point_set_get_info");
    hrbfnpr_point_set_info info;
    hrbfnpr_point_set_info_init(&info, sizeof info);
    call.expect(hrbfnpr_point_set_get_info(set, &info, call.error()));
    std::int64_t marks = 0;
    for (std::int64_t layer = 0; layer < info.layers; ++layer) {
        Call ask("point_set_get_layer_info");
        hrbfnpr_layer_info layer_info;
        hrbfnpr_layer_info_init(&layer_info, sizeof layer_info);
        ask.expect(hrbfnpr_point_set_get_layer_info(set, layer, &layer_info, ask.error()));
        require(layer_info.name[63] == 0, "a name ends");
        require_sound_strokes(set, layer, layer_info);
        const auto position = floats(set, layer, HRBFNPR_MARK_ATTRIBUTE_POSITION);
        require(static_cast<std::int64_t>(position.size()) == 3 * layer_info.marks, "a layer counts its marks");
        require_finite(position, "positions are finite");
        require_finite(floats(set, layer, HRBFNPR_MARK_ATTRIBUTE_NORMAL), "normals are finite");
        require_finite(floats(set, layer, HRBFNPR_MARK_ATTRIBUTE_DIRECTION), "directions are finite");
        require_finite(floats(set, layer, HRBFNPR_MARK_ATTRIBUTE_CURVATURE), "curvatures are finite");
        for (const float rank : floats(set, layer, HRBFNPR_MARK_ATTRIBUTE_RANK))
            require(rank >= 0.0F && rank < 1.0F, "ranks are in [0,1)");
        for (const float width : floats(set, layer, HRBFNPR_MARK_ATTRIBUTE_WIDTH))
            require(width > 0.0F && width <= 1.0F, "widths are in (0,1]");
        marks += layer_info.marks;
    }
    require(marks == info.marks, "a set counts its marks");
    require(std::isfinite(info.spacing) && info.spacing >= 0.0, "the spacing is finite");
    for (int axis = 0; axis < 3 && marks > 0; ++axis) {
        require(std::isfinite(info.origin[axis]), "the origin is finite");
        require(std::isfinite(info.bounds_min[axis]) && info.bounds_min[axis] <= info.bounds_max[axis] &&
                    std::isfinite(info.bounds_max[axis]),
                "the bounds of marks are a box");
    }
}

void require_same_set(Context& context, const hrbfnpr_point_set* set) {
    const Bytes first = save(set, hrbfnpr_point_set_save_memory);
    auto* const again = load<hrbfnpr_point_set>(context, first, hrbfnpr_point_set_load_memory);
    require(again != nullptr, "a saved point set loads");
    require(save(again, hrbfnpr_point_set_save_memory) == first, "a loaded point set saves to the same bytes");
    hrbfnpr_point_set_release(again);
}

} // namespace fuzz
