// SPDX-License-Identifier: MIT
#include "fields.h"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

namespace viewer {

namespace {

using Json = nlohmann::ordered_json;

struct Choice {
    const char* field;
    std::uint32_t first;
    std::vector<std::string> words;
};

// The words are those of HRBFNPR_... in the header, in lower case.
const std::map<std::string, std::vector<Choice>>& choices() {
    static const std::map<std::string, std::vector<Choice>> all = {
        {"hrbfnpr_style",
         {{"tone", 0, {"none", "light"}},
          {"tone_rule", 0, {"share", "published"}},
          {"tone_curve", 0, {"coverage", "linear"}},
          {"evenness", 0, {"picture", "surface"}},
          {"light_space", 0, {"world", "camera"}},
          {"visibility", 0, {"depth_layers", "published"}},
          {"hidden_lines", 0, {"attenuate", "hide", "show"}}}},
        {"hrbfnpr_layer_style",
         {{"kind", 0, {"any", "stipples", "hatch", "own"}}, {"shape", 0, {"dots", "strokes", "hatch"}}}},
        {"hrbfnpr_line_style",
         {{"kind",
           1,
           {"contour", "suggestive_contour", "ridge", "valley", "apparent_ridge", "parabolic", "isophote", "section",
            "border", "own", "crease"}},
          {"hidden", 0, {"none", "attenuated", "dashed", "shown"}},
          {"cap", 0, {"round", "flat", "pointed"}},
          {"creases", 0, {"all", "convex", "concave"}}}},
        {"hrbfnpr_layer_desc",
         {{"kind", 1, {"stipples", "hatch", "own"}},
          {"density", 0, {"uniform", "curvature"}},
          {"start", 0, {"seeds", "stipples"}},
          {"guide", 0, {"curvature", "combing", "sections", "light", "silhouette"}}}},
        {"hrbfnpr_generate_desc",
         {{"distribution", 0, {"blue_noise", "published"}},
          {"tone_ranges", 0, {"full", "in_turn"}},
          {"seed_source", 0, {"auto", "samples", "box"}}}},
        {"hrbfnpr_fit_desc",
         {{"kernel", 0, {"triharmonic", "gaussian", "wendland_c2"}},
          {"regularization_mode", 0, {"given", "auto"}},
          {"outliers", 0, {"keep", "drop"}},
          {"flipped_normals", 0, {"keep", "drop", "reorient"}},
          {"solver", 0, {"auto", "direct", "iterative"}},
          {"normal_mode", 0, {"given", "none", "unoriented", "mixed", "inward", "auto"}},
          {"trim", 0, {"never", "auto"}}}},
        {"hrbfnpr_line_desc", {{"kind", 3, {"ridge", "valley", "apparent_ridge", "parabolic", "isophote", "section"}}}},
        {"hrbfnpr_mesh_fit_desc", {{"edges", 0, {"auto", "smooth", "sharp"}}}},
    };
    return all;
}

bool is_plain(const std::string& type) {
    static const std::set<std::string> plain = {"float",   "double",   "int32_t",    "uint32_t",
                                                "int64_t", "uint64_t", "const char*"};
    return plain.count(type) != 0;
}

bool is_ours(const std::string& name) { // false for the fields that only describe the struct's layout
    static const std::set<std::string> not_settings = {"struct_size", "flags",        "layer_count",
                                                       "light_count", "light_stride", "layer_stride",
                                                       "line_count",  "line_stride",  "palette_count"};
    return not_settings.count(name) == 0 && name.rfind("reserved", 0) != 0;
}

std::vector<Field> read_layout(const std::string& c_name) {
    const char* const layout = hrbfnpr_layout(c_name.c_str());
    if (layout == nullptr)
        throw Failure("the library has no struct " + c_name + "; use the library that this program was built with");
    std::vector<Field> result;
    const Json description = Json::parse(layout);
    for (const Json& each : description.at("fields")) {
        Field field{each.at("name"), each.at("type"), each.at("offset"), 1, {}, 0};
        if (const std::size_t open = field.type.find('['); open != std::string::npos) {
            field.count = std::stoul(field.type.substr(open + 1));
            field.type.resize(open);
        }
        if (!is_plain(field.type) || !is_ours(field.name)) continue;
        if (const auto found = choices().find(c_name); found != choices().end())
            for (const Choice& choice : found->second)
                if (field.name == choice.field) field.choices = choice.words, field.first_choice = choice.first;
        result.push_back(field);
    }
    return result;
}

template <class T>
T load(const void* values, const Field& field, std::size_t i) {
    T result;
    std::memcpy(&result, static_cast<const char*>(values) + field.offset + i * sizeof(T), sizeof result);
    return result;
}

template <class Number>
std::string shortest(Number number) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, number);
    return std::string(text, end.ptr);
}

std::string element_text(const Field& field, const void* values, std::size_t i) {
    if (field.type == "float") return shortest(load<float>(values, field, i));
    if (field.type == "double") return shortest(load<double>(values, field, i));
    if (field.type == "int32_t") return shortest(load<std::int32_t>(values, field, i));
    if (field.type == "int64_t") return shortest(load<std::int64_t>(values, field, i));
    if (field.type == "uint64_t") return shortest(load<std::uint64_t>(values, field, i));
    const auto number = load<std::uint32_t>(values, field, i);
    const std::size_t place = number - field.first_choice;
    return place < field.choices.size() ? field.choices[place] : shortest(number);
}

// False for words that a settings file may not have: the caller's own marks, and lines that each frame finds anew.
bool is_in_files(const std::string& c_name, const std::string& word) {
    if (c_name == "hrbfnpr_layer_desc") return word != "own";
    return c_name != "hrbfnpr_line_desc" || (word != "apparent_ridge" && word != "isophote");
}

Json section(const std::string& c_name) {
    Json result = Json::object();
    for (Field field : fields_of(c_name)) {
        auto& words = field.choices;
        words.erase(
            std::remove_if(words.begin(), words.end(), [&](const auto& word) { return !is_in_files(c_name, word); }),
            words.end());
        Json kind = field.choices.empty() ? Json(field.type) : Json(field.choices);
        result[field.name] = field.count == 1 ? kind : Json{kind, field.count};
    }
    return result;
}

} // namespace

const std::vector<Field>& fields_of(const std::string& c_name) {
    static std::map<std::string, std::vector<Field>> known;
    static std::mutex looking;
    const std::lock_guard<std::mutex> lock(looking);
    const auto found = known.find(c_name);
    return found != known.end() ? found->second : known.emplace(c_name, read_layout(c_name)).first->second;
}

const Field& field_of(const std::string& c_name, const std::string& name) {
    for (const Field& field : fields_of(c_name))
        if (field.name == name) return field;
    throw Failure("the library's " + c_name + " has no field " + name +
                  "; use the library that this program was built with");
}

std::string text_of(const Field& field, const void* values) {
    if (field.type == "const char*") {
        const char* const text = load<const char*>(values, field, 0);
        return text == nullptr ? "" : text;
    }
    std::string result;
    for (std::size_t i = 0; i < field.count; ++i) result += (i > 0 ? "," : "") + element_text(field, values, i);
    return result;
}

std::string decimals(double number) { return shortest(number); }

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
