// SPDX-License-Identifier: MIT
#include "choices.h"

#include "files.h"

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

namespace viewer {

namespace {

using Json = nlohmann::ordered_json;

void copy_numbers(const Json& from, double* to) {
    for (std::size_t k = 0; k < 3; ++k) to[k] = from.at(k);
}

// The library has checked the file before.
hrbfnpr_dab dab_of(const Json& json) {
    auto dab = defaults<hrbfnpr_dab>(hrbfnpr_dab_init);
    const std::string map = json.at("map");
    dab.map = map == "tone" ? HRBFNPR_DAB_TONE : map == "density" ? HRBFNPR_DAB_DENSITY : HRBFNPR_DAB_DIRECTION;
    copy_numbers(json.at("position"), dab.position);
    copy_numbers(json.at("normal"), dab.normal);
    dab.radius = json.at("radius");
    dab.strength = json.at("strength");
    dab.value = json.value("value", 0.0);
    if (json.contains("direction")) copy_numbers(json.at("direction"), dab.direction);
    return dab;
}

SettingsHandle load(const Context& context, const std::string& text) {
    TextSource source{text, 0};
    return make<hrbfnpr_settings>(hrbfnpr_settings_release, [&](auto** out, auto* error) {
        return hrbfnpr_settings_load(context.get(), read_from_text, &source, out, error);
    });
}

} // namespace

Settings settings_of_text(const Context& context, const std::string& text) {
    Settings settings;
    settings.handle = load(context, text); // throws a Failure if the text is wrong
    Json json = Json::parse(text);
    if (json.contains("size")) settings.size = {json["size"].at(0), json["size"].at(1)};
    if (json.contains("paint"))
        for (const Json& dab : json["paint"]) settings.dabs.push_back(dab_of(dab));
    settings.has_camera = json.contains("camera");
    if (json.erase("paint") > 0) settings.handle = load(context, json.dump());
    settings.text = json.dump();
    return settings;
}

Settings read_settings(const Context& context, const std::string& path) {
    try {
        return settings_of_text(context, read_file(path));
    } catch (const Failure& failure) {
        throw Failure(path + ": " + failure.what());
    }
}

Settings without(const Context& context, const Settings& settings, const char* part) {
    if (!settings.handle) return settings;
    Json json = Json::parse(settings.text);
    if (json.erase(part) == 0) return settings;
    Settings result = settings_of_text(context, json.dump());
    result.dabs = settings.dabs;
    return result;
}

void Choices::change(const std::string& field, const std::string& value) {
    const auto is_same = [&](const auto& change) { return change.first == field; };
    changes.erase(std::remove_if(changes.begin(), changes.end(), is_same), changes.end());
    changes.emplace_back(field, value);
}

void Choices::forget(const std::string& beginning) {
    const auto begins = [&](const auto& change) { return change.first.rfind(beginning, 0) == 0; };
    changes.erase(std::remove_if(changes.begin(), changes.end(), begins), changes.end());
    if (!has_lengths()) drawn = {};
}

Descriptor::Descriptor(const Choices& choices, Size size, const hrbfnpr_camera* camera)
    : desc(defaults<hrbfnpr_picture_desc>(hrbfnpr_picture_desc_init)), choices_(choices) {
    for (const auto& [field, value] : choices_.changes) {
        changes_.push_back(defaults<hrbfnpr_change>(hrbfnpr_change_init));
        changes_.back().field = field.c_str();
        changes_.back().value = value.c_str();
    }
    // The viewer turns the picture and saves its marks.
    desc.flags = HRBFNPR_PICTURE_ALLOW_BLANK | HRBFNPR_PICTURE_KEEP_MARKS;
    desc.settings = choices_.settings.handle.get();
    if (!choices_.style.empty()) desc.style_name = choices_.style.c_str();
    desc.pen = choices_.pen;
    desc.line_width = choices_.line_width;
    desc.hatch_angle = choices_.hatch_angle;
    if (choices_.is_preview) desc.mark_kinds = "stipples";
    if (choices_.lines) desc.lines = choices_.lines->c_str();
    desc.changes = changes_.data();
    desc.change_count = static_cast<std::int64_t>(changes_.size());
    desc.dabs = choices_.dabs.data();
    desc.dab_count = static_cast<std::int64_t>(choices_.dabs.size());
    desc.width = size.width;
    desc.height = size.height;
    if (camera == nullptr) return;
    camera_ = *camera;
    desc.camera = &camera_;
}

std::string preset_name(std::uint32_t preset) {
    const char* const name = hrbfnpr_preset_name(preset);
    return name == nullptr ? "" : name;
}

} // namespace viewer
