// SPDX-License-Identifier: MIT
#include "picture/lights.h"

#include "frame/scene/style.h"
#include "picture/field_table.h"

#include <algorithm>

namespace hrbfnpr::picture {
namespace {

// Returns the text before a separator, and removes both from `text`.
std::string_view next_part(std::string_view& text, char separator) noexcept {
    const std::size_t end = text.find(separator);
    const std::string_view part = text.substr(0, end);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
    return part;
}

bool is_in_range(const hrbfnpr_light& light) noexcept {
    const auto is_between = [](float value, float most) { return value >= 0.0F && value <= most; };
    return is_between(light.intensity, 16.0F) && is_between(light.shadow, 1.0F) && is_between(light.softness, 0.5F);
}

// Sets a field of a light by a text such as "shadow=1".
bool set_field(std::string_view text, hrbfnpr_light& light) noexcept {
    if (text == "place") {
        light.kind = HRBFNPR_LIGHT_KIND_PLACE;
        return true;
    }
    const std::string_view name = next_part(text, '=');
    const NamedField* const field = find_field(Record::light, name);
    if (field == nullptr || field->count != 1 || field->meaning == Meaning::text) return false;
    const std::optional<FieldValue> value = parse_value(*field, text);
    if (value) store_value(*field, *value, &light);
    return value.has_value();
}

// Sets the place of a light by three numbers, or by the name of an axis.
bool set_place(std::string_view text, hrbfnpr_light& light) noexcept {
    const NamedField& field = *find_field(Record::light, "place");
    if (const std::optional<FieldValue> value = parse_value(field, text)) {
        store_value(field, *value, &light);
        return true;
    }
    // A light may be at the origin, although 0,0,0 is no direction.
    for (double& coordinate : light.place) {
        const std::optional<double> number = parse_number(next_part(text, ','));
        if (!number) return false;
        coordinate = *number;
    }
    return text.empty();
}

bool set_light(std::string_view text, hrbfnpr_light& light) noexcept {
    if (!set_place(next_part(text, ':'), light)) return false;
    while (!text.empty())
        if (!set_field(next_part(text, ','), light)) return false;
    const bool has_direction = std::any_of(light.place, light.place + 3, [](double x) { return x != 0.0; });
    return is_in_range(light) && (has_direction || light.kind == HRBFNPR_LIGHT_KIND_PLACE);
}

} // namespace

bool is_list_of_lights(std::string_view text) noexcept { return text.find_first_of(":;") != std::string_view::npos; }

std::optional<Vector<hrbfnpr_light>> read_lights(std::string_view text, const hrbfnpr_light& first,
                                                 const hrbfnpr_light& others, Pool& pool) {
    Vector<hrbfnpr_light> lights(&pool);
    do {
        lights.push_back(lights.empty() ? first : others);
        if (std::ssize(lights) > frame::most_lights || !set_light(next_part(text, ';'), lights.back()))
            return std::nullopt;
    } while (!text.empty());
    return lights;
}

} // namespace hrbfnpr::picture
