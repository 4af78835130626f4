// SPDX-License-Identifier: MIT
// Reads settings. Each key of the document must be in the field table of its section. Messages give the path of a
// mistake in the document.
#include "picture/settings.h"

#include "base/assert.h"
#include "picture/field_table.h"
#include "picture/handles.h"
#include "picture/json.h"
#include "picture/report.h"
#include "picture/settings_keys.h"
#include "picture/tuning_settings.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::picture {
namespace {

constexpr std::size_t shown_of_wrong = 60; // The number of bytes of a wrong value that a message shows at most.

// Throws an error that names the key of a wrong value.
[[noreturn]] void refuse_value(std::string_view where, std::string_view wanted, const JsonValue& value, Pool& pool) {
    fail(Status::invalid_argument, "%.*s: %.*s is needed, not %s", static_cast<int>(where.size()), where.data(),
         static_cast<int>(wanted.size()), wanted.data(), value.in_short(shown_of_wrong, pool).c_str());
}

[[noreturn]] void refuse_missing(std::string_view where, std::string_view key) {
    fail(Status::invalid_argument, "%.*s.%.*s: it is missing", static_cast<int>(where.size()), where.data(),
         static_cast<int>(key.size()), key.data());
}

[[noreturn]] void refuse_key(std::string_view path, std::string_view key, std::span<const std::string_view> known,
                             Pool& pool) {
    constexpr std::size_t longest_path = 100;
    std::array<char, Error::message_capacity> begin{};
    const int size = std::snprintf(begin.data(), begin.size(), "%.*s: there is no such field; there are ",
                                   static_cast<int>(std::min(path.size(), longest_path)), path.data());
    const std::size_t room = begin.size() - 1 - static_cast<std::size_t>(size);
    fail(Status::invalid_argument, "%s%s", begin.data(), listed_names(known, key, room, pool).c_str());
}

[[nodiscard]] String path_of(std::string_view where, std::string_view key, Pool& pool) {
    String path(where, &pool);
    if (!where.empty()) path += '.';
    return path += key;
}

[[nodiscard]] String path_of(std::string_view where, std::size_t number, Pool& pool) {
    return formatted(pool, "%.*s[%zu]", static_cast<int>(where.size()), where.data(), number);
}

void check_keys(const JsonValue& value, std::string_view where, std::span<const std::string_view> known, Pool& pool) {
    if (value.kind() != JsonKind::object) refuse_value(where, "an object", value, pool);
    for (const JsonValue part : value)
        if (std::find(known.begin(), known.end(), part.key()) == known.end())
            refuse_key(path_of(where, part.key(), pool), part.key(), known, pool);
}

void check_list(const JsonValue& value, std::string_view where, Pool& pool) {
    if (value.kind() != JsonKind::list) refuse_value(where, "a list of objects", value, pool);
}

[[nodiscard]] double read_number(const JsonValue& value, std::string_view where, Pool& pool) {
    if (!value.is_number()) refuse_value(where, "a number", value, pool);
    return value.number();
}

[[nodiscard]] double read_number(const JsonValue& value, std::string_view where, double low, double high, Pool& pool) {
    if (!value.is_number() || !(value.number() >= low && value.number() <= high))
        refuse_value(where, formatted(pool, "a number from %g to %g", low, high), value, pool);
    return value.number();
}

[[nodiscard]] bool is_list_of_numbers(const JsonValue& value) noexcept {
    if (value.kind() != JsonKind::list) return false;
    for (const JsonValue part : value)
        if (!part.is_number()) return false;
    return true;
}

template <std::size_t count>
void read_numbers(const JsonValue& value, std::string_view where, double (&numbers)[count], Pool& pool) {
    if (!is_list_of_numbers(value) || value.size() != count)
        refuse_value(where, formatted(pool, "a list of %zu numbers", count), value, pool);
    std::size_t i = 0;
    for (const JsonValue part : value) numbers[i++] = part.number();
}

template <std::size_t count>
[[nodiscard]] std::array<double, count> read_numbers(const JsonValue& value, std::string_view where, Pool& pool) {
    double numbers[count];
    read_numbers(value, where, numbers, pool);
    std::array<double, count> result;
    std::copy(numbers, numbers + count, result.begin());
    return result;
}

// A section of the file: the fields of a struct, and keys that are not plain fields.
struct SettingsSection {
    Record record;
    std::array<std::string_view, 4> more; // the names of the keys that are not plain fields; "" if there are fewer
};
constexpr SettingsSection style_section{Record::style, {"layers", "lines", "lights", "palette"}};
constexpr SettingsSection light_section{Record::light, {}};
constexpr SettingsSection layer_style_section{Record::layer_style, {}};
constexpr SettingsSection line_style_section{Record::line_style, {"levels"}};
constexpr SettingsSection marks_section{Record::generate_desc, {"layers", "direction_field"}};
constexpr SettingsSection layer_section{Record::layer_desc, {}};
constexpr SettingsSection fit_section{Record::fit_desc, {}};
constexpr SettingsSection mesh_fit_section{Record::mesh_fit_desc, {}};
constexpr SettingsSection line_set_section{Record::line_set_desc, {"lines"}};
constexpr SettingsSection line_section{Record::line_desc, {"levels"}};

// Returns whether a settings file can store this choice of a field. It cannot store the caller's own points as seeds.
[[nodiscard]] bool is_choice_of_settings(const NamedField& field, std::string_view choice) noexcept {
    return choice != "points" || std::string_view(field.name) != "seed_source";
}

void check_section(const JsonValue& value, std::string_view where, const SettingsSection& section, Pool& pool) {
    Vector<std::string_view> known(&pool);
    for (const NamedField& field : fields_of(section.record))
        if (is_in_settings(field.name)) known.emplace_back(field.name);
    for (const std::string_view more : section.more)
        if (!more.empty()) known.push_back(more);
    check_keys(value, where, known, pool);
}

[[nodiscard]] FieldValue read_choice(const NamedField& field, const JsonValue& value, std::string_view where,
                                     Pool& pool) {
    if (value.kind() == JsonKind::text && is_choice_of_settings(field, value.text()))
        if (find_choice(field, value.text()) != nullptr) return *parse_value(field, value.text());
    String wanted("one of ", &pool);
    const char* between = "";
    for (const NamedConstant& choice : choices_of(field)) {
        if (!is_choice_of_settings(field, choice.name)) continue;
        (wanted += between) += choice.name;
        between = ", ";
    }
    refuse_value(where, wanted, value, pool);
}

[[nodiscard]] FieldValue read_whole(const NamedField& field, const JsonValue& value, std::string_view where,
                                    Pool& pool) {
    const bool is_true_or_false = value.kind() == JsonKind::boolean;
    if (value.kind() != JsonKind::whole && !is_true_or_false) refuse_value(where, "a whole number", value, pool);
    FieldValue found;
    const std::uint64_t magnitude = value.magnitude();
    if (field.meaning == Meaning::yes_no) {
        found.whole = magnitude != 0 ? 1 : 0;
    } else {
        if (!holds(field, value.is_negative(), magnitude)) {
            const bool is_wide = field.scalar == Scalar::int64 || field.scalar == Scalar::uint64;
            const bool is_signed = field.scalar == Scalar::int32 || field.scalar == Scalar::int64;
            refuse_value(where,
                         formatted(pool, "a number that fits a %sint%d_t", is_signed ? "" : "u", is_wide ? 64 : 32),
                         value, pool);
        }
        found.whole = value.is_negative() ? 0U - magnitude : magnitude;
    }
    return found;
}

// Reads the value of a field that does not hold a text.
[[nodiscard]] FieldValue read_value(const NamedField& field, const JsonValue& value, std::string_view where,
                                    Pool& pool) {
    if (field.meaning == Meaning::choice) return read_choice(field, value, where, pool);
    if (field.scalar != Scalar::float32 && field.scalar != Scalar::float64)
        return read_whole(field, value, where, pool);
    FieldValue found;
    if (field.count == 1)
        found.numbers[0] = read_number(value, where, pool);
    else {
        if (!is_list_of_numbers(value) || value.size() != field.count)
            refuse_value(where, formatted(pool, "a list of %d numbers", int{field.count}), value, pool);
        std::size_t i = 0;
        for (const JsonValue part : value) found.numbers[i++] = part.number();
    }
    for (const double number : found.numbers)
        if (!holds(field, number)) refuse_value(where, "a number that fits a float", value, pool);
    return found;
}

// Returns the text for a field, or nullptr if the file has null. `keep` stores the text.
template <class Keeper>
[[nodiscard]] const char* text_in(const JsonValue& value, std::string_view where, Keeper&& keep, Pool& pool) {
    if (value.kind() == JsonKind::null) return nullptr;
    if (value.kind() != JsonKind::text || value.text().find('\0') != std::string_view::npos)
        refuse_value(where, "a text or null", value, pool);
    return keep(value.text());
}

// Sets the fields of a struct that appear in an object of the file.
template <class Keeper>
void read_record(const JsonValue& value, std::string_view where, const SettingsSection& section, void* record,
                 Keeper&& keep, Pool& pool) {
    check_section(value, where, section, pool);
    for (const JsonValue part : value) {
        const NamedField* const field = find_field(section.record, part.key());
        if (field == nullptr) continue;
        const String path = path_of(where, part.key(), pool);
        if (field->meaning == Meaning::text)
            store_text(*field, text_in(part, path, keep, pool), record);
        else
            store_value(*field, read_value(*field, part, path, pool), record);
    }
}

// Adds the fields in an object of the file to a list of changes.
void read_fields(const JsonValue& value, std::string_view where, const SettingsSection& section, FieldTexts& fields,
                 Pool& pool) {
    check_section(value, where, section, pool);
    for (const JsonValue part : value) {
        const NamedField* const field = find_field(section.record, part.key());
        if (field == nullptr) continue;
        String path = path_of(where, part.key(), pool);
        String text = text_of(*field, read_value(*field, part, path, pool), pool);
        fields.emplace_back(std::move(path), std::move(text));
    }
}

// Reads the levels of lines, a list of numbers. `keep` stores the numbers.
template <class Keeper>
[[nodiscard]] hrbfnpr_array levels_in(const JsonValue& lines, std::string_view where, Keeper&& keep, Pool& pool) {
    const std::optional<JsonValue> value = lines.find("levels");
    if (!value) return {};
    if (!is_list_of_numbers(*value)) refuse_value(path_of(where, "levels", pool), "a list of numbers", *value, pool);
    Vector<double> levels(&pool);
    for (const JsonValue level : *value) levels.push_back(level.number());
    return levels.empty() ? hrbfnpr_array{} : keep(levels.data(), levels.size());
}

[[nodiscard]] std::uint32_t read_preset(const std::optional<JsonValue>& value, Pool& pool) {
    if (!value) return HRBFNPR_PRESET_CONTOUR_AND_STIPPLE;
    String known(&pool);
    for (std::uint32_t preset = 0; hrbfnpr_preset_name(preset) != nullptr; ++preset) {
        const char* const name = hrbfnpr_preset_name(preset);
        if (value->kind() == JsonKind::text && value->text() == name) return preset;
        if (!known.empty()) known += ", ";
        known += name;
    }
    fail(Status::invalid_argument, "preset: there is no style %s; there are %s",
         value->in_short(shown_of_wrong, pool).c_str(), known.c_str());
}

[[nodiscard]] std::array<std::int32_t, 2> read_size(const JsonValue& value, Pool& pool) {
    const std::array<double, 2> sides = read_numbers<2>(value, "size", pool);
    const auto is_side = [](double side) {
        return side >= 1.0 && side <= double{largest_settings_side} && side == std::trunc(side);
    };
    if (!is_side(sides[0]) || !is_side(sides[1]))
        refuse_value("size", "a pair of whole numbers from 1 to 32768", value, pool);
    return {static_cast<std::int32_t>(sides[0]), static_cast<std::int32_t>(sides[1])};
}

constexpr std::string_view camera_keys[] = {"eye",         "target",     "up",       "vertical_angle",
                                            "view_height", "near_plane", "far_plane"};

[[nodiscard]] SavedCamera read_matrices(const JsonValue& value, bool has_size, Pool& pool) {
    constexpr std::string_view keys[] = {"view", "projection"};
    check_keys(value, "camera", keys, pool);
    if (!has_size) fail(Status::invalid_argument, "size: it is missing, and the camera's matrices need it");
    SavedCamera camera;
    camera.has_matrices = true;
    camera.view = read_numbers<16>(*value.find("view"), "camera.view", pool);
    const std::optional<JsonValue> projection = value.find("projection");
    if (!projection) refuse_missing("camera", "projection");
    camera.projection = read_numbers<16>(*projection, "camera.projection", pool);
    return camera;
}

[[nodiscard]] SavedCamera read_camera(const JsonValue& value, bool has_size, Pool& pool) {
    if (value.find("view")) return read_matrices(value, has_size, pool);
    check_keys(value, "camera", camera_keys, pool);
    const std::optional<JsonValue> angle = value.find("vertical_angle");
    const bool needs_height = angle && angle->is_number() && angle->number() == 0.0;
    for (const std::string_view key : camera_keys)
        if (!value.find(key) && (key != "view_height" || needs_height)) refuse_missing("camera", key);
    const auto vector = [&](std::string_view key) {
        return read_numbers<3>(*value.find(key), path_of("camera", key, pool), pool);
    };
    const auto number = [&](std::string_view key) {
        return read_number(*value.find(key), path_of("camera", key, pool), pool);
    };
    constexpr double widest = 3.14;
    SavedCamera camera;
    camera.eye = vector("eye");
    camera.target = vector("target");
    camera.up = vector("up");
    camera.vertical_angle = read_number(*angle, "camera.vertical_angle", 0.0, widest, pool);
    camera.near_plane = number("near_plane");
    camera.far_plane = number("far_plane");
    if (needs_height) camera.view_height = number("view_height");
    return camera;
}

void read_style(const JsonValue& value, Style& style, Pool& pool) {
    const auto keep = [&](std::string_view text) { return style.keep(text); };
    read_record(value, "style", style_section, &style.base, keep, pool);
    if (const std::optional<JsonValue> layers = value.find("layers")) {
        check_list(*layers, "style.layers", pool);
        style.layers.clear();
        for (const JsonValue one : *layers) {
            auto layer = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
            read_record(one, path_of("style.layers", style.layers.size(), pool), layer_style_section, &layer, keep,
                        pool);
            style.layers.push_back(layer);
        }
    }
    if (const std::optional<JsonValue> lines = value.find("lines")) {
        check_list(*lines, "style.lines", pool);
        style.lines.clear();
        for (const JsonValue one : *lines) {
            const String where = path_of("style.lines", style.lines.size(), pool);
            auto line = defaults<hrbfnpr_line_style>(hrbfnpr_line_style_init);
            read_record(one, where, line_style_section, &line, keep, pool);
            line.levels = levels_in(
                one, where, [&](const double* first, std::size_t count) { return style.keep_levels(first, count); },
                pool);
            style.lines.push_back(line);
        }
    }
    if (const std::optional<JsonValue> lights = value.find("lights")) {
        check_list(*lights, "style.lights", pool);
        style.lights.clear();
        for (const JsonValue one : *lights) {
            auto light = defaults<hrbfnpr_light>(hrbfnpr_light_init);
            read_record(one, path_of("style.lights", style.lights.size(), pool), light_section, &light, keep, pool);
            style.lights.push_back(light);
        }
    }
    if (const std::optional<JsonValue> palette = value.find("palette")) {
        if (palette->kind() != JsonKind::list) refuse_value("style.palette", "a list of colours", *palette, pool);
        style.palette.clear();
        for (const JsonValue one : *palette) {
            const String where = path_of("style.palette", style.palette.size(), pool);
            const std::array<double, 4> ink = read_numbers<4>(one, where, pool);
            std::array<float, 4>& to = style.palette.emplace_back();
            std::transform(ink.begin(), ink.end(), to.begin(), [](double part) { return static_cast<float>(part); });
        }
    }
}

// Completes a layer after reading. A tone range without an end counts as not given, and negative numbers mean an
// automatic choice.
void complete_layer(hrbfnpr_layer_desc& layer) noexcept {
    if (!(layer.tone_end > 0.0F)) layer.tone_begin = layer.tone_end = 0.0F;
    if (!(layer.second_tone_end > 0.0F)) layer.second_tone_begin = layer.second_tone_end = 0.0F;
    if (layer.tone_smoothing < 0.0) layer.tone_smoothing = -1.0;
}

void read_layers(const JsonValue& value, Marks& marks, Pool& pool) {
    check_list(value, "marks.layers", pool);
    for (const JsonValue one : value) {
        auto layer = defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
        read_record(
            one, path_of("marks.layers", marks.layers.size(), pool), layer_section, &layer,
            [&](std::string_view text) { return marks.keep(text); }, pool);
        complete_layer(layer);
        marks.layers.push_back(layer);
    }
}

void read_lines_once(const JsonValue& value, Settings& settings, Pool& pool) {
    check_list(value, "line_set.lines", pool);
    for (const JsonValue one : value) {
        const String where = path_of("line_set.lines", settings.lines.size(), pool);
        auto line = defaults<hrbfnpr_line_desc>(hrbfnpr_line_desc_init);
        read_record(
            one, where, line_section, &line, [&](std::string_view text) { return settings.texts.text(text); }, pool);
        if (line.name != nullptr && line.name[0] == '\0') line.name = nullptr;
        line.levels = levels_in(
            one, where, [&](const double* first, std::size_t count) { return settings.texts.numbers(first, count); },
            pool);
        settings.lines.push_back(line);
    }
}

// Reads the fit. In a file, regularization is a single field: a number, or "auto".
void read_fit(const JsonValue& value, FieldTexts& fields, Pool& pool) {
    FieldTexts found(&pool);
    read_fields(value, "fit", fit_section, found, pool);
    const auto is = [](const std::pair<String, String>& field, std::string_view path) { return field.first == path; };
    bool is_auto = false;
    for (const auto& field : found)
        if (is(field, "fit.regularization_mode")) is_auto = field.second == "auto";
    for (auto& field : found) {
        if (is(field, "fit.regularization_mode") || (is_auto && is(field, "fit.regularization"))) continue;
        fields.push_back(std::move(field));
    }
    if (is_auto) fields.emplace_back(String("fit.regularization", &pool), String("auto", &pool));
}

constexpr std::string_view dab_keys[] = {"map", "position", "normal", "radius", "strength", "value", "direction"};

[[nodiscard]] hrbfnpr_dab read_dab(const JsonValue& value, std::string_view where, Pool& pool) {
    check_keys(value, where, dab_keys, pool);
    auto dab = defaults<hrbfnpr_dab>(hrbfnpr_dab_init);
    const std::optional<JsonValue> map = value.find("map");
    const bool has_map = map && map->kind() == JsonKind::text;
    const auto* const found =
        has_map ? std::find(std::begin(dab_map_names), std::end(dab_map_names), map->text()) : std::end(dab_map_names);
    if (!map) refuse_missing(where, "map");
    if (found == std::end(dab_map_names))
        refuse_value(path_of(where, "map", pool), "one of tone, density, direction", *map, pool);
    dab.map = static_cast<std::uint32_t>(found - std::begin(dab_map_names));
    const bool has_direction = dab.map == HRBFNPR_DAB_DIRECTION;
    for (const std::string_view key : dab_keys)
        if (key != (has_direction ? "value" : "direction") && !value.find(key)) refuse_missing(where, key);
    read_numbers(*value.find("position"), path_of(where, "position", pool), dab.position, pool);
    read_numbers(*value.find("normal"), path_of(where, "normal", pool), dab.normal, pool);
    if (has_direction) read_numbers(*value.find("direction"), path_of(where, "direction", pool), dab.direction, pool);
    const String radius = path_of(where, "radius", pool);
    dab.radius = read_number(*value.find("radius"), radius, pool);
    if (!(dab.radius > 0.0)) refuse_value(radius, "a number above 0", *value.find("radius"), pool);
    dab.strength = read_number(*value.find("strength"), path_of(where, "strength", pool), 0.0, 1.0, pool);
    if (const std::optional<JsonValue> given = value.find("value"))
        dab.value = read_number(*given, path_of(where, "value", pool), pool);
    return dab;
}

// Reads where the ground is: true, or a height.
void read_ground(const JsonValue& value, Settings& settings, Pool& pool) {
    const bool is_said = value.kind() == JsonKind::boolean;
    if (!is_said && !value.is_number()) refuse_value("ground", "true, false or a number", value, pool);
    settings.has_ground = !is_said || value.magnitude() != 0;
    if (!is_said) settings.ground_height = value.number();
}

// Reads all sections. A missing section counts as an empty object.
void read_sections(const JsonValue& root, Settings& settings, Pool& pool) {
    const std::optional<JsonValue> marks = root.find("marks");
    const std::optional<JsonValue> line_set = root.find("line_set");
    if (marks) read_fields(*marks, "marks", marks_section, settings.fields, pool);
    if (const std::optional<JsonValue> direction = marks ? marks->find("direction_field") : std::nullopt) {
        if (direction->kind() != JsonKind::text) refuse_value("marks.direction_field", "a text", *direction, pool);
        settings.fields.emplace_back(String("marks.direction_field", &pool), String(direction->text(), &pool));
    }
    if (line_set) read_fields(*line_set, "line_set", line_set_section, settings.fields, pool);
    if (const std::optional<JsonValue> camera = root.find("camera"))
        settings.saved_camera = read_camera(*camera, settings.size.has_value(), pool);
    if (const std::optional<JsonValue> style = root.find("style")) read_style(*style, settings.style, pool);
    if (const std::optional<JsonValue> layers = marks ? marks->find("layers") : std::nullopt) {
        settings.has_layers = true;
        read_layers(*layers, settings.marks, pool);
    }
    if (const std::optional<JsonValue> fit = root.find("fit")) read_fit(*fit, settings.fields, pool);
    if (const std::optional<JsonValue> mesh_fit = root.find("mesh_fit"))
        read_fields(*mesh_fit, "mesh_fit", mesh_fit_section, settings.fields, pool);
    if (const std::optional<JsonValue> lines = line_set ? line_set->find("lines") : std::nullopt) {
        settings.has_lines = true;
        read_lines_once(*lines, settings, pool);
    }
    if (const std::optional<JsonValue> paint = root.find("paint")) {
        check_list(*paint, "paint", pool);
        for (const JsonValue one : *paint)
            settings.dabs.push_back(read_dab(one, path_of("paint", settings.dabs.size(), pool), pool));
    }
}

} // namespace

std::optional<hrbfnpr_camera> Settings::camera(std::int32_t width, std::int32_t height) const {
    HRBFNPR_ASSERT(width >= 1 && height >= 1);
    if (!saved_camera) return std::nullopt;
    const SavedCamera& saved = *saved_camera;
    auto made = defaults<hrbfnpr_camera>(hrbfnpr_camera_init);
    const auto wide = static_cast<double>(width);
    const auto high = static_cast<double>(height);
    if (!saved.has_matrices) {
        call([&](hrbfnpr_error* error) {
            return hrbfnpr_camera_look_at(&made, saved.eye.data(), saved.target.data(), saved.up.data(), error);
        });
        call([&](hrbfnpr_error* error) {
            return saved.vertical_angle > 0.0 ? hrbfnpr_camera_perspective(&made, saved.vertical_angle, wide, high,
                                                                           saved.near_plane, saved.far_plane, error)
                                              : hrbfnpr_camera_orthographic(&made, saved.view_height, wide, high,
                                                                            saved.near_plane, saved.far_plane, error);
        });
        return made;
    }
    HRBFNPR_ASSERT(size.has_value());
    std::copy(saved.view.begin(), saved.view.end(), made.view);
    std::copy(saved.projection.begin(), saved.projection.end(), made.projection);
    made.viewport[2] = wide;
    made.viewport[3] = high;
    const std::array<double, 2> wanted{wide, high};
    const std::array<double, 2> known{static_cast<double>((*size)[0]), static_cast<double>((*size)[1])};
    if (wanted == known) return made;
    // The saved picture is scaled to the largest size that fits into the wanted size.
    const double scale = std::min(wanted[0] / known[0], wanted[1] / known[1]);
    for (std::size_t axis = 0; axis < 2; ++axis)
        for (std::size_t column = 0; column < 4; ++column)
            made.projection[4 * column + axis] *= scale * known[axis] / wanted[axis];
    return made;
}

std::shared_ptr<const Settings> read_settings(std::string_view json, Pool& pool) {
    if (json.size() > settings_tuning.most_bytes)
        fail(Status::invalid_argument, "settings of %zu bytes are too large: %zu bytes are the most", json.size(),
             settings_tuning.most_bytes);
    const JsonDocument document(json, pool);
    const JsonValue root = document.root();
    const std::optional<JsonValue> version = root.find(settings_magic);
    if (!version)
        fail(Status::invalid_argument, "this is not a settings file: it must begin with {\"hrbfnpr-settings\": 1}");
    if (!version->is_number() || version->number() != static_cast<double>(settings_version))
        fail(Status::invalid_argument, "hrbfnpr-settings: version 1 is needed, not %s",
             version->in_short(shown_of_wrong, pool).c_str());
    constexpr std::string_view keys[] = {settings_magic, "preset", "size",     "pen",      "camera", "style",
                                         "marks",        "fit",    "mesh_fit", "line_set", "paint",  "ground"};
    check_keys(root, "", keys, pool);
    auto settings = std::allocate_shared<Settings>(PoolAllocator<Settings>(&pool), pool);
    settings->preset = read_preset(root.find("preset"), pool);
    settings->style = Style(settings->preset, pool);
    if (const std::optional<JsonValue> size = root.find("size")) settings->size = read_size(*size, pool);
    constexpr double largest_pen = 100.0;
    if (const std::optional<JsonValue> pen = root.find("pen"))
        settings->pen = read_number(*pen, "pen", 0.0, largest_pen, pool);
    if (const std::optional<JsonValue> ground = root.find("ground")) read_ground(*ground, *settings, pool);
    read_sections(root, *settings, pool);
    return settings;
}

} // namespace hrbfnpr::picture
