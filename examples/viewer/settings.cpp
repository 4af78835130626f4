// SPDX-License-Identifier: MIT
#include "settings.h"

#include <nlohmann/json.hpp>

namespace viewer {

namespace {

constexpr int version = 1;
const char* const magic = "hrbfnpr-settings";

// Fields in pixels, which grow with the pen.
constexpr float hrbfnpr_layer_style::*layer_lengths[] = {
    &hrbfnpr_layer_style::radius,         &hrbfnpr_layer_style::hatch_spacing, &hrbfnpr_layer_style::hatch_pen,
    &hrbfnpr_layer_style::hatch_white,    &hrbfnpr_layer_style::hatch_taper,   &hrbfnpr_layer_style::hatch_shortest,
    &hrbfnpr_layer_style::hatch_overshoot};
constexpr float hrbfnpr_line_style::*line_lengths[] = {&hrbfnpr_line_style::width, &hrbfnpr_line_style::hidden_width,
                                                       &hrbfnpr_line_style::taper, &hrbfnpr_line_style::shortest};

void scale(float& length, double factor) { length = static_cast<float>(length * factor); }

// The elements of a descriptor's list.
template <class Struct>
std::vector<Struct> elements(const Struct* first, std::int64_t count, std::int64_t stride) {
    std::vector<Struct> result;
    const std::int64_t step = stride != 0 ? stride : (count > 0 ? first->struct_size : 0);
    for (std::int64_t i = 0; i < count; ++i)
        result.push_back(*reinterpret_cast<const Struct*>(reinterpret_cast<const char*>(first) + i * step));
    return result;
}

template <class Struct, class Init>
Json list_to_json(const std::vector<Struct>& list, const char* c_name, Init init) {
    const auto base = defaults<Struct>(init);
    Json result = Json::array();
    for (const Struct& each : list) {
        Json one = Json::object();
        one["kind"] = fields_to_json(c_name, &each, nullptr)["kind"];
        one.update(fields_to_json(c_name, &each, &base));
        result.push_back(std::move(one));
    }
    return result;
}

template <class Struct, class Init>
std::vector<Struct> list_from_json(const Json& json, const char* c_name, Init init, const std::string& where,
                                   const std::vector<std::string>& others = {}) {
    if (!json.is_array()) throw Failure(where + ": a list of objects is needed, not " + json.dump().substr(0, 60));
    std::vector<Struct> result;
    for (const Json& each : json) {
        result.push_back(defaults<Struct>(init));
        fields_from_json(c_name, each, &result.back(), where + "[" + std::to_string(result.size() - 1) + "]", others);
    }
    return result;
}

Json array_to_json(const hrbfnpr_array& array) {
    Json result = Json::array();
    for (std::int64_t i = 0; i < array.count; ++i) result.push_back(static_cast<const double*>(array.data)[i]);
    return result;
}

// The levels of lines, which are no plain field.
template <class Struct>
void add_levels(Json& json, const std::vector<Struct>& list) {
    for (std::size_t i = 0; i < list.size(); ++i)
        if (list[i].levels.count > 0) json[i]["levels"] = array_to_json(list[i].levels);
}

template <class Struct>
void read_levels(const Json& json, std::vector<Struct>& list, const std::string& where) {
    for (std::size_t i = 0; i < list.size(); ++i)
        if (json[i].contains("levels"))
            list[i].levels = kept(numbers_of(json[i]["levels"], where + "[" + std::to_string(i) + "].levels"));
}

Json lines_to_json(const std::vector<hrbfnpr_line_style>& lines) {
    Json json = list_to_json(lines, "hrbfnpr_line_style", hrbfnpr_line_style_init);
    add_levels(json, lines);
    return json;
}

Json layers_to_json(const std::vector<hrbfnpr_layer_style>& layers) {
    return list_to_json(layers, "hrbfnpr_layer_style", hrbfnpr_layer_style_init);
}

Json style_to_json(const Settings& settings) {
    const Style base = preset_style(settings.preset);
    Json json = fields_to_json("hrbfnpr_style", &settings.style.fields, &base.fields);
    if (Json layers = layers_to_json(settings.style.layers); layers != layers_to_json(base.layers))
        json["layers"] = std::move(layers);
    if (Json lines = lines_to_json(settings.style.lines); lines != lines_to_json(base.lines))
        json["lines"] = std::move(lines);
    return json;
}

Style style_from_json(const Json& json, std::uint32_t preset) {
    Style style = preset_style(preset);
    fields_from_json("hrbfnpr_style", json, &style.fields, "style", {"layers", "lines"});
    if (json.contains("layers"))
        style.layers = list_from_json<hrbfnpr_layer_style>(json["layers"], "hrbfnpr_layer_style",
                                                           hrbfnpr_layer_style_init, "style.layers");
    if (json.contains("lines")) {
        style.lines = list_from_json<hrbfnpr_line_style>(json["lines"], "hrbfnpr_line_style", hrbfnpr_line_style_init,
                                                         "style.lines", {"levels"});
        read_levels(json["lines"], style.lines, "style.lines");
    }
    return style;
}

Json view_to_json(const View& view) {
    if (view.view) return {{"view", *view.view}, {"projection", *view.projection}};
    Json json = {{"eye", view.eye}, {"target", view.target}, {"up", view.up}, {"vertical_angle", view.vertical_angle}};
    if (view.vertical_angle == 0) json["view_height"] = view.view_height;
    json["near_plane"] = view.near_plane;
    json["far_plane"] = view.far_plane;
    return json;
}

Vec vec_of(const Json& json, const std::string& where) {
    const std::vector<double> numbers = numbers_of(json, where, 3);
    return {numbers[0], numbers[1], numbers[2]};
}

double number_of(const Json& json, const std::string& where) {
    if (!json.is_number()) throw Failure(where + ": a number is needed, not " + json.dump().substr(0, 60));
    return json.get<double>();
}

// Every key of an object must be one of these.
void check_keys(const Json& json, const std::string& where, const std::vector<std::string>& keys) {
    if (!json.is_object()) throw Failure(where + ": an object is needed, not " + json.dump().substr(0, 60));
    for (const auto& [key, value] : json.items()) {
        bool known = false;
        std::string all;
        for (const std::string& each : keys) known = known || each == key, all += (all.empty() ? "" : ", ") + each;
        const std::string path = where == "settings" ? key : where + "." + key;
        if (!known) throw Failure(path + ": there is no such field; there are " + all);
    }
}

const Json& needed(const Json& json, const std::string& where, const char* key) {
    if (!json.contains(key)) throw Failure(where + "." + key + ": it is missing, and needed");
    return json.at(key);
}

View view_from_json(const Json& json, Size size) {
    View view;
    if (json.is_object() && json.contains("view")) {
        check_keys(json, "camera", {"view", "projection"});
        const auto matrix = [&](const char* key) {
            const auto numbers = numbers_of(needed(json, "camera", key), std::string("camera.") + key, 16);
            std::array<double, 16> result;
            std::copy(numbers.begin(), numbers.end(), result.begin());
            return result;
        };
        view.view = matrix("view");
        view.projection = matrix("projection");
        view.given_size = size;
        return view;
    }
    check_keys(json, "camera", {"eye", "target", "up", "vertical_angle", "view_height", "near_plane", "far_plane"});
    const auto number = [&](const char* key) {
        return number_of(needed(json, "camera", key), std::string("camera.") + key);
    };
    view.eye = vec_of(needed(json, "camera", "eye"), "camera.eye");
    view.target = vec_of(needed(json, "camera", "target"), "camera.target");
    view.up = vec_of(needed(json, "camera", "up"), "camera.up");
    view.vertical_angle = number("vertical_angle");
    if (view.vertical_angle == 0) view.view_height = number("view_height");
    view.near_plane = number("near_plane");
    view.far_plane = number("far_plane");
    return view;
}

constexpr const char* map_names[] = {"tone", "density", "direction"};

Json dab_to_json(const Dab& dab) {
    Json json = {{"map", map_names[static_cast<int>(dab.map)]},
                 {"position", dab.position},
                 {"normal", dab.normal},
                 {"radius", dab.radius},
                 {"strength", dab.strength}};
    if (dab.map == Map::direction)
        json["direction"] = dab.direction;
    else
        json["value"] = dab.value;
    return json;
}

Dab dab_from_json(const Json& json, const std::string& where) {
    check_keys(json, where, {"map", "position", "normal", "radius", "strength", "value", "direction"});
    Dab dab;
    const Json& map = needed(json, where, "map");
    int number = 0;
    while (number < 3 && map != map_names[number]) ++number;
    if (number == 3) throw Failure(where + ".map: one of tone, density, direction is needed, not " + map.dump());
    dab.map = static_cast<Map>(number);
    dab.position = vec_of(needed(json, where, "position"), where + ".position");
    dab.normal = vec_of(needed(json, where, "normal"), where + ".normal");
    dab.radius = number_of(needed(json, where, "radius"), where + ".radius");
    dab.strength = number_of(needed(json, where, "strength"), where + ".strength");
    if (!(dab.radius > 0)) throw Failure(where + ".radius: a number above 0 is needed");
    if (!(dab.strength >= 0 && dab.strength <= 1)) throw Failure(where + ".strength: a number from 0 to 1 is needed");
    if (dab.map == Map::direction)
        dab.direction = vec_of(needed(json, where, "direction"), where + ".direction");
    else
        dab.value = number_of(needed(json, where, "value"), where + ".value");
    return dab;
}

Size size_of(const Json& json) {
    const std::vector<double> numbers = numbers_of(json, "size", 2);
    for (const double side : numbers)
        if (!(side >= 1 && side <= 32768 && side == std::floor(side)))
            throw Failure("size: two whole numbers from 1 to 32768 are needed, not " + json.dump());
    return {static_cast<int>(numbers[0]), static_cast<int>(numbers[1])};
}

} // namespace

Settings::Settings()
    : style(preset_style(preset)), marks(defaults<hrbfnpr_generate_desc>(hrbfnpr_generate_desc_init)),
      fit(defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init)),
      mesh_fit(defaults<hrbfnpr_mesh_fit_desc>(hrbfnpr_mesh_fit_desc_init)),
      line_set(defaults<hrbfnpr_line_set_desc>(hrbfnpr_line_set_desc_init)) {
    fit.normal_mode = HRBFNPR_NORMALS_AUTO;
}

Style preset_style(std::uint32_t preset) {
    Style style;
    checked([&](auto* error) { return hrbfnpr_style_init_preset(&style.fields, sizeof style.fields, preset, error); });
    style.layers = elements(style.fields.layers, style.fields.layer_count, style.fields.layer_stride);
    style.lines = elements(style.fields.lines, style.fields.line_count, style.fields.line_stride);
    return style;
}

Style sized(const Style& style, double pen) {
    Style result = style;
    for (auto& layer : result.layers)
        for (const auto length : layer_lengths) scale(layer.*length, pen);
    for (auto& line : result.lines)
        for (const auto length : line_lengths) scale(line.*length, pen);
    scale(result.fields.silhouette_radius, pen);
    scale(result.fields.halo_width, pen);
    return result;
}

hrbfnpr_style pointed(const Style& style) {
    hrbfnpr_style result = style.fields;
    result.layers = style.layers.data();
    result.layer_count = static_cast<std::int64_t>(style.layers.size());
    result.layer_stride = 0;
    result.lines = style.lines.data();
    result.line_count = static_cast<std::int64_t>(style.lines.size());
    result.line_stride = 0;
    return result;
}

std::vector<hrbfnpr_layer_desc> preset_layers(std::uint32_t preset, std::uint32_t distribution) {
    if (distribution == HRBFNPR_DISTRIBUTION_PUBLISHED) { // which has no lines of hatching, but strokes
        const bool strokes =
            preset == HRBFNPR_PRESET_HATCH || preset == HRBFNPR_PRESET_CROSS_HATCH || preset == HRBFNPR_PRESET_FULL;
        std::vector<hrbfnpr_layer_desc> layers(1, defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init));
        if (strokes || preset == HRBFNPR_PRESET_COMBING) {
            layers.push_back(layers.front());
            layers.back().kind = strokes ? HRBFNPR_LAYER_KIND_PRINCIPAL : HRBFNPR_LAYER_KIND_COMBING;
        }
        return layers;
    }
    std::int64_t count = 0;
    const hrbfnpr_layer_desc* const first = hrbfnpr_preset_layers(preset, &count);
    return elements(first, count, 0);
}

void set_preset(Settings& settings, std::uint32_t preset) {
    settings.preset = preset;
    settings.style = preset_style(preset);
    settings.layers.clear();
    settings.lines.clear();
}

std::string preset_name(std::uint32_t preset) {
    const char* const name = hrbfnpr_preset_name(preset);
    return name == nullptr ? "" : name;
}

std::uint32_t preset_of(const std::string& name, const std::string& where) {
    std::string all;
    for (std::uint32_t preset = 0; hrbfnpr_preset_name(preset) != nullptr; ++preset) {
        if (preset_name(preset) == name) return preset;
        all += (all.empty() ? "" : ", ") + preset_name(preset);
    }
    throw Failure(where + ": there is no style \"" + name + "\"; there are " + all);
}

Json to_json(const Settings& settings) {
    const Settings base;
    Json json = {{magic, version}, {"preset", preset_name(settings.preset)}};
    if (settings.size.width > 0) json["size"] = {settings.size.width, settings.size.height};
    if (settings.pen > 0) json["pen"] = settings.pen;
    if (settings.view) json["camera"] = view_to_json(*settings.view);
    const auto add = [&](const char* name, Json part) {
        if (!part.empty()) json[name] = std::move(part);
    };
    add("style", style_to_json(settings));
    Json marks = fields_to_json("hrbfnpr_generate_desc", &settings.marks, &base.marks);
    if (!settings.layers.empty())
        marks["layers"] = list_to_json(settings.layers, "hrbfnpr_layer_desc", hrbfnpr_layer_desc_init);
    add("marks", std::move(marks));
    add("fit", fields_to_json("hrbfnpr_fit_desc", &settings.fit, &base.fit));
    add("mesh_fit", fields_to_json("hrbfnpr_mesh_fit_desc", &settings.mesh_fit, &base.mesh_fit));
    Json lines = fields_to_json("hrbfnpr_line_set_desc", &settings.line_set, &base.line_set);
    if (!settings.lines.empty()) {
        lines["lines"] = list_to_json(settings.lines, "hrbfnpr_line_desc", hrbfnpr_line_desc_init);
        add_levels(lines["lines"], settings.lines);
    }
    add("line_set", std::move(lines));
    Json paint = Json::array();
    for (const Dab& dab : settings.paint) paint.push_back(dab_to_json(dab));
    add("paint", std::move(paint));
    return json;
}

Settings settings_from_json(const Json& json) {
    if (!json.is_object() || !json.contains(magic))
        throw Failure("these are no settings: they begin with {\"hrbfnpr-settings\": 1}");
    if (json[magic] != version) throw Failure("hrbfnpr-settings: version 1 is known here, not " + json[magic].dump());
    check_keys(json, "settings",
               {magic, "preset", "size", "pen", "camera", "style", "marks", "fit", "mesh_fit", "line_set", "paint"});
    const auto part = [&](const char* name) -> const Json* { return json.contains(name) ? &json[name] : nullptr; };
    Settings settings;
    if (const Json* preset = part("preset")) {
        if (!preset->is_string()) throw Failure("preset: the name of a style is needed, not " + preset->dump());
        set_preset(settings, preset_of(preset->get<std::string>(), "preset"));
    }
    if (const Json* size = part("size")) settings.size = size_of(*size);
    if (const Json* pen = part("pen")) settings.pen = number_of(*pen, "pen");
    if (!(settings.pen >= 0 && settings.pen <= 100)) throw Failure("pen: a number from 0 to 100 is needed");
    if (const Json* camera = part("camera")) {
        settings.view = view_from_json(*camera, settings.size);
        try {
            camera_of(*settings.view, {100, 100});
        } catch (const Failure& failure) {
            throw Failure(std::string("camera: ") + failure.what());
        }
    }
    if (const Json* style = part("style")) settings.style = style_from_json(*style, settings.preset);
    if (const Json* marks = part("marks")) {
        fields_from_json("hrbfnpr_generate_desc", *marks, &settings.marks, "marks", {"layers"});
        if (marks->contains("layers"))
            settings.layers = list_from_json<hrbfnpr_layer_desc>((*marks)["layers"], "hrbfnpr_layer_desc",
                                                                 hrbfnpr_layer_desc_init, "marks.layers");
    }
    if (const Json* fit = part("fit")) fields_from_json("hrbfnpr_fit_desc", *fit, &settings.fit, "fit");
    if (const Json* fit = part("mesh_fit"))
        fields_from_json("hrbfnpr_mesh_fit_desc", *fit, &settings.mesh_fit, "mesh_fit");
    if (const Json* lines = part("line_set")) {
        fields_from_json("hrbfnpr_line_set_desc", *lines, &settings.line_set, "line_set", {"lines"});
        if (lines->contains("lines")) {
            settings.lines = list_from_json<hrbfnpr_line_desc>((*lines)["lines"], "hrbfnpr_line_desc",
                                                               hrbfnpr_line_desc_init, "line_set.lines", {"levels"});
            read_levels((*lines)["lines"], settings.lines, "line_set.lines");
        }
    }
    if (const Json* paint = part("paint")) {
        if (!paint->is_array()) throw Failure("paint: a list of objects is needed, not " + paint->dump().substr(0, 60));
        for (const Json& dab : *paint)
            settings.paint.push_back(dab_from_json(dab, "paint[" + std::to_string(settings.paint.size()) + "]"));
    }
    return settings;
}

} // namespace viewer
