// SPDX-License-Identifier: MIT
#include "frame/scene/fields.h"

#include "base/status.h"

#include <algorithm>
#include <array>

namespace hrbfnpr::frame {
namespace {

using ll = long long;

constexpr std::array<const char*, paint::field_kind_count> kind_names{"SCALAR", "COLOUR", "DIRECTION"};

} // namespace

const marks::MarkField* find_field(const marks::PointSet& set, std::int64_t layer, const char* name, const char* member,
                                   marks::FieldKind kind, std::int64_t item) {
    HRBFNPR_ASSERT(layer >= 0 && layer < set.layers.size());
    if (name == nullptr) return nullptr;
    const marks::MarkField* const own = set.layers[layer].field_of(name);
    const bool is_known = own != nullptr || std::any_of(set.layers.begin(), set.layers.end(), [&](const auto& other) {
                              return other.field_of(name) != nullptr;
                          });
    if (!is_known)
        fail(Status::invalid_argument,
             "items[%lld].style: %s of the layer \"%.63s\" is \"%.63s\", which is no field of "
             "items[%lld].point_set; add it by hrbfnpr_point_set_with_fields",
             ll{item}, member, set.layers[layer].name.data(), name, ll{item});
    if (own != nullptr && own->kind != kind)
        fail(
            Status::invalid_argument,
            "items[%lld].style: %s of the layer \"%.63s\" is \"%.63s\", a field of kind %s; it must be a field of kind "
            "%s",
            ll{item}, member, set.layers[layer].name.data(), name, kind_names[static_cast<std::size_t>(own->kind)],
            kind_names[static_cast<std::size_t>(kind)]);
    return own;
}

RunFields fields_of(const marks::PointSet& set, std::int64_t layer, const LayerStyle& style, std::int64_t item) {
    const auto find = [&](const char* name, const char* member) {
        return find_field(set, layer, name, member, marks::FieldKind::scalar, item);
    };
    RunFields fields;
    fields.density = find(style.density_field, "density_field");
    fields.tone = find(style.tone_field, "tone_field");
    fields.width = find(style.width_field, "width_field");
    fields.mask = find(style.mask_field, "mask_field");
    fields.tone_rule = style.tone_field_rule;
    return fields;
}

} // namespace hrbfnpr::frame
