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

struct Choice {
    const char* field;
    std::uint32_t first;
    std::vector<std::string> words;
};

// As HRBFNPR_... of the header, in lower case.
const std::map<std::string, std::vector<Choice>>& choices() {
    static const std::map<std::string, std::vector<Choice>> all = {
        {"hrbfnpr_style",
         {{"tone", 0, {"none", "light"}},
          {"tone_rule", 0, {"share", "published"}},
          {"tone_curve", 0, {"coverage", "linear"}},
          {"light_space", 0, {"world", "camera"}},
          {"silhouette_law", 0, {"width", "angle"}},
          {"visibility", 0, {"depth_layers", "published"}},
          {"hidden_lines", 0, {"attenuate", "hide", "show"}}}},
        {"hrbfnpr_layer_style",
         {{"kind", 0, {"any", "stipples", "principal", "combing", "field", "own", "hatch"}},
          {"shape", 0, {"dots", "strokes", "hatch"}}}},
        {"hrbfnpr_line_style",
         {{"kind",
           1,
           {"contour", "suggestive_contour", "ridge", "valley", "apparent_ridge", "parabolic", "isophote", "section",
            "border", "own", "crease"}},
          {"hidden", 0, {"none", "attenuated", "dashed", "shown"}},
          {"cap", 0, {"round", "flat", "pointed"}},
          {"creases", 0, {"all", "convex", "concave"}}}},
        {"hrbfnpr_layer_desc",
         {{"kind", 1, {"stipples", "principal", "combing", "field", "own", "hatch"}},
          {"density", 0, {"uniform", "curvature"}},
          {"symmetry", 0, {"line", "cross"}},
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

bool is_ours(const std::string& name) { // not how the struct is passed on
    static const std::set<std::string> not_settings = {"struct_size",  "flags",      "layer_count",
                                                       "layer_stride", "line_count", "line_stride"};
    return not_settings.count(name) == 0 && name.rfind("reserved", 0) != 0;
}

std::vector<Field> read_layout(const std::string& c_name) {
    const char* const layout = hrbfnpr_layout(c_name.c_str());
    if (layout == nullptr) throw Failure("the library has no struct " + c_name);
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

template <class T>
void store(void* values, const Field& field, std::size_t i, T value) {
    std::memcpy(static_cast<char*>(values) + field.offset + i * sizeof(T), &value, sizeof value);
}

Json element_to_json(const Field& field, const void* values, std::size_t i) {
    if (field.type == "float") return shortest(load<float>(values, field, i));
    if (field.type == "double") return load<double>(values, field, i);
    if (field.type == "int32_t") return load<std::int32_t>(values, field, i);
    if (field.type == "int64_t") return load<std::int64_t>(values, field, i);
    if (field.type == "uint64_t") return load<std::uint64_t>(values, field, i);
    if (field.type == "const char*") {
        const char* const text = load<const char*>(values, field, i);
        return text == nullptr ? Json(nullptr) : Json(text);
    }
    const auto number = load<std::uint32_t>(values, field, i);
    const std::size_t place = number - field.first_choice;
    return place < field.choices.size() ? Json(field.choices[place]) : Json(number);
}

Json field_to_json(const Field& field, const void* values) {
    if (field.count == 1) return element_to_json(field, values, 0);
    Json list = Json::array();
    for (std::size_t i = 0; i < field.count; ++i) list.push_back(element_to_json(field, values, i));
    return list;
}

std::string listed(const std::vector<std::string>& words) {
    std::string result;
    for (const std::string& word : words) result += (result.empty() ? "" : ", ") + word;
    return result;
}

[[noreturn]] void refuse(const std::string& where, const std::string& wanted, const Json& json) {
    throw Failure(where + ": " + wanted + " is needed, not " + json.dump().substr(0, 60));
}

std::uint32_t choice_of(const Field& field, const Json& json, const std::string& where) {
    std::string word = json.is_string() ? json.get<std::string>() : "";
    std::replace(word.begin(), word.end(), '-', '_');
    const auto found = std::find(field.choices.begin(), field.choices.end(), word);
    if (found == field.choices.end()) refuse(where, "one of " + listed(field.choices), json);
    return field.first_choice + static_cast<std::uint32_t>(found - field.choices.begin());
}

template <class T>
T whole(const Json& json, const std::string& where) {
    if (json.is_boolean()) return static_cast<T>(json.get<bool>());
    if (!json.is_number_integer()) refuse(where, "a whole number", json);
    const bool negative = !json.is_number_unsigned() && json.get<std::int64_t>() < 0;
    const auto value =
        static_cast<T>(negative ? static_cast<T>(json.get<std::int64_t>()) : static_cast<T>(json.get<std::uint64_t>()));
    if (Json(value) != json) refuse(where, "a number that fits " + std::to_string(8 * sizeof(T)) + " bits", json);
    return value;
}

void element_from_json(const Field& field, const Json& json, void* values, std::size_t i, const std::string& where) {
    if (!field.choices.empty()) return store(values, field, i, choice_of(field, json, where));
    if (field.type == "int32_t") return store(values, field, i, whole<std::int32_t>(json, where));
    if (field.type == "uint32_t") return store(values, field, i, whole<std::uint32_t>(json, where));
    if (field.type == "int64_t") return store(values, field, i, whole<std::int64_t>(json, where));
    if (field.type == "uint64_t") return store(values, field, i, whole<std::uint64_t>(json, where));
    if (field.type == "const char*") {
        if (!json.is_string() && !json.is_null()) refuse(where, "a text or null", json);
        return store(values, field, i, json.is_null() ? nullptr : kept(json.get<std::string>()));
    }
    if (!json.is_number()) refuse(where, "a number", json);
    if (field.type == "float") return store(values, field, i, static_cast<float>(json.get<double>()));
    store(values, field, i, json.get<double>());
}

void field_from_json(const Field& field, const Json& json, void* values, const std::string& where) {
    if (field.count == 1) return element_from_json(field, json, values, 0, where);
    if (!json.is_array() || json.size() != field.count)
        refuse(where, "a list of " + std::to_string(field.count) + " numbers", json);
    for (std::size_t i = 0; i < field.count; ++i) element_from_json(field, json[i], values, i, where);
}

std::mutex keeping;

} // namespace

const std::vector<Field>& fields_of(const std::string& c_name) {
    static std::map<std::string, std::vector<Field>> known;
    static std::mutex looking;
    const std::lock_guard<std::mutex> lock(looking);
    const auto found = known.find(c_name);
    return found != known.end() ? found->second : known.emplace(c_name, read_layout(c_name)).first->second;
}

Json fields_to_json(const std::string& c_name, const void* values, const void* base) {
    Json result = Json::object();
    for (const Field& field : fields_of(c_name)) {
        Json value = field_to_json(field, values);
        if (base == nullptr || value != field_to_json(field, base)) result[field.name] = std::move(value);
    }
    return result;
}

void fields_from_json(const std::string& c_name, const Json& json, void* values, const std::string& where,
                      const std::vector<std::string>& others) {
    if (!json.is_object()) refuse(where, "an object with fields", json);
    const std::vector<Field>& fields = fields_of(c_name);
    for (const auto& each : json.items()) {
        const std::string& key = each.key();
        if (std::find(others.begin(), others.end(), key) != others.end()) continue;
        const auto field = std::find_if(fields.begin(), fields.end(), [&](const Field& f) { return f.name == key; });
        if (field == fields.end()) {
            std::vector<std::string> names;
            for (const Field& each : fields) names.push_back(each.name);
            names.insert(names.end(), others.begin(), others.end());
            throw Failure(where + "." + key + ": there is no such field; there are " + listed(names));
        }
        field_from_json(*field, each.value(), values, where + "." + key);
    }
}

const char* kept(const std::string& text) {
    static std::set<std::string> texts;
    const std::lock_guard<std::mutex> lock(keeping);
    return texts.insert(text).first->c_str();
}

hrbfnpr_array kept(const std::vector<double>& numbers) {
    static std::set<std::vector<double>> lists;
    if (numbers.empty()) return {};
    const std::lock_guard<std::mutex> lock(keeping);
    const std::vector<double>& list = *lists.insert(numbers).first;
    return {list.data(), static_cast<std::int64_t>(list.size()), 0, HRBFNPR_SCALAR_FLOAT64, 1};
}

double shortest(float value) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof text, value);
    double result = value;
    std::from_chars(text, end.ptr, result);
    return result;
}

std::vector<double> numbers_of(const Json& json, const std::string& where, std::size_t count) {
    const std::string wanted = count == 0 ? "a list of numbers" : "a list of " + std::to_string(count) + " numbers";
    if (!json.is_array() || (count != 0 && json.size() != count)) refuse(where, wanted, json);
    std::vector<double> result;
    for (const Json& each : json) {
        if (!each.is_number()) refuse(where, wanted, json);
        result.push_back(each.get<double>());
    }
    return result;
}

} // namespace viewer
