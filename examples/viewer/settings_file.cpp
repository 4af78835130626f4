// SPDX-License-Identifier: MIT
// Settings on disk, and what there is to set.
#include "settings.h"

#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

namespace viewer {

namespace {

// An object that holds objects has a line for each of its keys; what holds none is on one line.
void write_json(std::ostream& out, const Json& json, const std::string& indent) {
    bool is_deep = false;
    if (json.is_structured())
        for (const Json& part : json) is_deep = is_deep || part.is_structured();
    if (!is_deep || (json.is_object() && indent.size() > 4)) {
        out << json.dump();
        return;
    }
    const std::string inner = indent + "  ";
    const char* const brackets = json.is_object() ? "{}" : "[]";
    out << brackets[0];
    const char* between = "\n";
    for (auto each = json.begin(); each != json.end(); ++each, between = ",\n") {
        out << between << inner;
        if (json.is_object()) out << Json(each.key()).dump() << ": ";
        write_json(out, each.value(), inner);
    }
    out << "\n" << indent << brackets[1];
}

Json section(const char* c_name) {
    Json result = Json::object();
    for (const Field& field : fields_of(c_name)) {
        Json kind = field.choices.empty() ? Json(field.type) : Json(field.choices);
        result[field.name] = field.count == 1 ? kind : Json{kind, field.count};
    }
    return result;
}

} // namespace

Settings read_settings(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw Failure(path + ": cannot be opened");
    std::stringstream text;
    text << file.rdbuf();
    Json json;
    try {
        json = Json::parse(text.str());
    } catch (const Json::parse_error& error) {
        throw Failure(path + ": this is no JSON: " + error.what());
    }
    try {
        return settings_from_json(json);
    } catch (const Failure& failure) {
        throw Failure(path + ": " + failure.what());
    }
}

void write_settings(const Settings& settings, const std::string& path) {
    const std::string part = path + ".part";
    std::ofstream file(part, std::ios::binary);
    write_json(file, to_json(settings), "");
    file << "\n";
    file.close();
    if (!file || std::rename(part.c_str(), path.c_str()) != 0) {
        std::remove(part.c_str());
        throw Failure(path + ": cannot be written; is there such a folder, and room in it?");
    }
}

std::string settings_text(const Settings& settings) { return to_json(settings).dump(); }

std::string schema_text() {
    const Json schema = {{"style", section("hrbfnpr_style")},
                         {"style.layers", section("hrbfnpr_layer_style")},
                         {"style.lines", section("hrbfnpr_line_style")},
                         {"marks", section("hrbfnpr_generate_desc")},
                         {"marks.layers", section("hrbfnpr_layer_desc")},
                         {"fit", section("hrbfnpr_fit_desc")},
                         {"mesh_fit", section("hrbfnpr_mesh_fit_desc")},
                         {"line_set", section("hrbfnpr_line_set_desc")},
                         {"line_set.lines", section("hrbfnpr_line_desc")}};
    return schema.dump(2);
}

} // namespace viewer
