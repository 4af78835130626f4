// What holds for every point set, wherever it comes from.
#include "fuzz.h"

#include <cmath>

namespace fuzz {
namespace {

std::span<const float> floats(const hrbfnpr_point_set* set, std::uint32_t group, std::uint32_t attribute) {
    Call call("point_set_view");
    hrbfnpr_array view;
    call.expect(hrbfnpr_point_set_view(set, group, attribute, &view, call.error()));
    require(view.count >= 0 && (view.count == 0 || view.data != nullptr), "a view of marks has an address");
    return {static_cast<const float*>(view.data), static_cast<std::size_t>(view.count * view.components)};
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
    for (std::uint32_t group = 0; group < HRBFNPR_GROUP_COUNT; ++group) {
        const auto position = floats(set, group, HRBFNPR_ATTRIBUTE_POSITION);
        require(static_cast<std::int64_t>(position.size()) == 3 * info.group[group].count, "a group counts its marks");
        require_finite(position, "positions are finite");
        require_finite(floats(set, group, HRBFNPR_ATTRIBUTE_NORMAL), "normals are finite");
        require_finite(floats(set, group, HRBFNPR_ATTRIBUTE_DIRECTION), "directions are finite");
        require_finite(floats(set, group, HRBFNPR_ATTRIBUTE_CURVATURE), "curvatures are finite");
        for (const float rank : floats(set, group, HRBFNPR_ATTRIBUTE_RANK))
            require(rank >= 0.0F && rank < 1.0F, "ranks are in [0,1)");
        for (const float width : floats(set, group, HRBFNPR_ATTRIBUTE_WIDTH))
            require(width > 0.0F && width <= 1.0F, "widths are in (0,1]");
        marks += info.group[group].count;
    }
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
