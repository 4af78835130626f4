// SPDX-License-Identifier: MIT
// find_target() splits a path into the struct and the field that it names. The value must be one that the field can
// hold. Paths and values are stored as text, and are parsed again when they are applied.
#include "picture/changes.h"

#include "api/lists.h"
#include "base/utf8.h"
#include "frame/scene/style.h"
#include "picture/field_names.h"
#include "picture/field_table.h"
#include "picture/handles.h"
#include "picture/lights.h"
#include "picture/tuning_settings.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace hrbfnpr::picture {
namespace {

// In a path, these names mean all layers, all lines, and the layer of the ground: "style.layers.F" changes the field F
// of every layer.
constexpr std::string_view layers_part = "layers";
constexpr std::string_view lines_part = "lines";
constexpr std::string_view ground_part = "ground";

// Texts that change several fields.
enum class Special : std::uint8_t { none, ink, palette, field, direction_field };

// The struct and the field that a path names.
struct ChangeTarget {
    Record record = Record::style;
    std::string_view field_name; // the last part of the path
    // Null if the record has no field of this name, or if the path has a special meaning.
    const NamedField* field = nullptr;
    Special special = Special::none;
    bool has_section = true;
    std::string_view wrong_kind = {}; // The middle name of the path if it is no kind of layers or lines, else "".
    bool is_of_style = false;         // True if the path begins with "style".
};

// Returns whether a field selects the records that a change applies to. Such a field cannot be changed.
[[nodiscard]] bool is_selector(Record record, std::string_view name) noexcept {
    return name == "kind" &&
           (record == Record::layer_style || record == Record::line_style || record == Record::layer_desc);
}

[[nodiscard]] bool is_layer_kind(std::string_view name, bool of_style) noexcept {
    const NamedField* const kinds = find_field(of_style ? Record::layer_style : Record::layer_desc, "kind");
    return find_choice(*kinds, name) != nullptr;
}

// Returns whether a name is a kind of lines. In a path, a name that is also a kind of layers means the layers.
[[nodiscard]] bool is_line_kind(std::string_view name) noexcept {
    return find_choice(*find_field(Record::line_style, "kind"), name) != nullptr;
}

[[nodiscard]] Special special_of(std::string_view section, std::string_view field) noexcept {
    if (section == "marks") return field == "direction_field" ? Special::direction_field : Special::none;
    return field == "ink"       ? Special::ink
           : field == "palette" ? Special::palette
           : field == "field"   ? Special::field
                                : Special::none;
}

// Finds the struct and field for a path that has only small letters and '_'.
[[nodiscard]] ChangeTarget find_target(std::string_view path) noexcept {
    ChangeTarget target;
    const std::size_t dot = path.find('.');
    const std::string_view section = path.substr(0, dot);
    std::string_view rest = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
    target.is_of_style = section == "style";
    if (section == "style" || section == "marks") {
        target.record = target.is_of_style ? Record::style : Record::generate_desc;
        if (const std::size_t second = rest.find('.'); second != std::string_view::npos) {
            const std::string_view kind = rest.substr(0, second);
            target.record = target.is_of_style ? Record::layer_style : Record::layer_desc;
            rest = rest.substr(second + 1);
            const bool is_of_layers =
                kind == layers_part || kind == ground_part || is_layer_kind(kind, target.is_of_style);
            if (target.is_of_style && !is_of_layers && (kind == lines_part || is_line_kind(kind)))
                target.record = Record::line_style;
            else if (!is_of_layers)
                target.wrong_kind = kind;
        } else
            target.special = special_of(section, rest);
    } else if (section == "fit")
        target.record = Record::fit_desc;
    else if (section == "mesh_fit")
        target.record = Record::mesh_fit_desc;
    else if (section == "line_set")
        target.record = Record::line_set_desc;
    else if (section == "shading")
        target.record = Record::shading_desc;
    else
        target.has_section = false;
    if (dot == std::string_view::npos) target.has_section = false;
    target.field_name = rest;
    if (!is_selector(target.record, rest)) target.field = find_field(target.record, rest);
    return target;
}

[[nodiscard]] bool is_regularization(const ChangeTarget& target) noexcept {
    return target.record == Record::fit_desc && target.field_name == "regularization";
}

// Returns the field that stands for the path "style.ink": its value is parsed and checked like the value of
// silhouette_ink.
[[nodiscard]] const NamedField& ink_field() noexcept { return *find_field(Record::style, "silhouette_ink"); }

[[noreturn]] void refuse_kind(const ChangeTarget& target, const char* name, std::string_view path, Pool& pool) {
    const NamedField* const kinds = find_field(target.is_of_style ? Record::layer_style : Record::layer_desc, "kind");
    String known(&pool);
    for (const NamedConstant& kind : choices_of(*kinds)) (known += kind.name) += ", ";
    ((known += layers_part) += ", ") += ground_part;
    if (target.is_of_style) (known += ", ") += lines_part;
    if (target.is_of_style)
        for (const NamedConstant& kind : choices_of(*find_field(Record::line_style, "kind")))
            if (!is_layer_kind(kind.name, true)) (known += ", ") += kind.name;
    fail(Status::invalid_argument, "%s.field is \"%s\"; there are no layers %.*s; there are %s", name,
         String(path, &pool).c_str(), static_cast<int>(target.wrong_kind.size()), target.wrong_kind.data(),
         known.c_str());
}

[[noreturn]] void refuse_field(const ChangeTarget& target, const char* name, std::string_view path, Pool& pool) {
    Vector<std::string_view> names(&pool);
    for (const NamedField& field : fields_of(target.record))
        if (!is_selector(target.record, field.name)) names.emplace_back(field.name);
    if (target.record == Record::style) names.emplace_back("ink");
    std::array<char, Error::message_capacity> begin{};
    const int size = std::snprintf(begin.data(), begin.size(), "%s.field is \"%.*s\"; %s has no field %.*s: there are ",
                                   name, static_cast<int>(path.size()), path.data(), name_of(target.record),
                                   static_cast<int>(target.field_name.size()), target.field_name.data());
    const auto used = static_cast<std::size_t>(size);
    const std::size_t room = used < begin.size() ? begin.size() - 1 - used : 0;
    fail(Status::invalid_argument, "%s%s", begin.data(), listed_names(names, target.field_name, room, pool).c_str());
}

[[nodiscard]] bool is_light(const ChangeTarget& target) noexcept {
    return target.record == Record::style && target.field_name == "light";
}

[[nodiscard]] bool are_lights(std::string_view value, Pool& pool) {
    const auto any = defaults<hrbfnpr_light>(hrbfnpr_light_init);
    return is_list_of_lights(value) && read_lights(value, any, any, pool).has_value();
}

// Parses colours with commas between them. Returns nullopt for any other text.
[[nodiscard]] std::optional<Vector<std::array<float, 4>>> parse_palette(std::string_view text, Pool& pool) {
    Vector<std::array<float, 4>> inks(&pool);
    while (!text.empty()) {
        const std::size_t comma = text.find(',');
        const std::optional<FieldValue> ink = parse_value(ink_field(), text.substr(0, comma));
        if (text.front() != '#' || !ink || std::ssize(inks) == frame::most_inks) return std::nullopt;
        std::array<float, 4>& to = inks.emplace_back();
        for (std::size_t i = 0; i < to.size(); ++i) to[i] = static_cast<float>(ink->numbers[i]);
        if (comma == text.size() - 1) return std::nullopt;
        text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
    }
    return inks;
}

void check_palette(const char* name, std::string_view value, Pool& pool) {
    if (parse_palette(value, pool)) return;
    fail(Status::invalid_argument, "%s.value of style.palette is \"%.60s\"; it must be 1 to %d colours #rrggbb, %s",
         name, String(value, &pool).c_str(), static_cast<int>(frame::most_inks), "with commas between");
}

// A use of a field, and the path of the change that sets it.
struct NamedUse {
    std::string_view name, path;
};
constexpr NamedUse field_uses[] = {
    NamedUse{"tone", "style.layers.tone_field"},   NamedUse{"density", "style.layers.density_field"},
    NamedUse{"width", "style.layers.width_field"}, NamedUse{"ink", "style.layers.ink_field"},
    NamedUse{"mask", "style.layers.mask_field"},   NamedUse{"direction", "marks.direction_field"}};

// Adds the changes that the uses of fields stand for. `name` is the name of the change in messages.
void add_field_uses(std::string_view uses, const char* name, Pool& pool, Vector<Change>& changes) {
    while (!uses.empty()) {
        const std::size_t comma = std::min(uses.find(','), uses.size());
        const std::string_view one = uses.substr(0, comma);
        uses.remove_prefix(std::min(comma + 1, uses.size()));
        const std::size_t equals = std::min(one.find('='), one.size());
        const auto* const use = std::find_if(std::begin(field_uses), std::end(field_uses), [&](const NamedUse& known) {
            return same_name(known.name, one.substr(0, equals));
        });
        if (equals == one.size() || use == std::end(field_uses))
            fail(Status::invalid_argument,
                 "%s.value of style.field is \"%.60s\"; it must be USE=NAME, with one of tone, density, width, ink, "
                 "mask, "
                 "direction as USE, such as tone=quality",
                 name, String(one, &pool).c_str());
        changes.push_back(Change{String(use->path, &pool), String(one.substr(equals + 1), &pool)});
    }
}

void check_change(const ChangeTarget& target, const char* name, std::string_view path, std::string_view value,
                  Pool& pool) {
    if (!target.has_section)
        fail(Status::invalid_argument,
             "%s.field is \"%.*s\"; it must begin with one of style., fit., mesh_fit., marks., line_set., shading.",
             name, static_cast<int>(path.size()), path.data());
    if (!target.wrong_kind.empty()) refuse_kind(target, name, path, pool);
    if (target.field == nullptr && target.special == Special::none) refuse_field(target, name, path, pool);
    if (target.special == Special::palette) return check_palette(name, value, pool);
    if (target.special == Special::field || target.special == Special::direction_field) return;
    const NamedField& field = target.special == Special::ink ? ink_field() : *target.field;
    if (field.meaning == Meaning::text || parse_value(field, value)) return;
    if (is_regularization(target) && same_name(value, "auto")) return;
    if (is_light(target) && are_lights(value, pool)) return;
    String wanted = wanted_for(field, pool);
    if (is_light(target)) (wanted += "; or ") += wanted_lights;
    if (is_regularization(target)) wanted += " or auto";
    fail(Status::invalid_argument, "%s.value of %.*s is \"%.60s\"; it must be %s", name, static_cast<int>(path.size()),
         path.data(), String(value, &pool).c_str(), wanted.c_str());
}

// Checks a text from the caller, and returns it.
[[nodiscard]] std::string_view change_text(const char* text, const char* name, const char* member, std::size_t most) {
    if (text == nullptr) fail(Status::invalid_argument, "%s.%s is NULL", name, member);
    const std::string_view found(text, strnlen(text, most + 1));
    if (found.size() > most) fail(Status::invalid_argument, "%s.%s is longer than %zu bytes", name, member, most);
    if (!base::is_utf8(found)) fail(Status::invalid_argument, "%s.%s is not UTF-8", name, member);
    return found;
}

// Returns the text that is stored for a value. The name of a choice is stored in one spelling, whatever spelling the
// caller used.
[[nodiscard]] String plain_value(const ChangeTarget& target, std::string_view value, Pool& pool) {
    if (is_regularization(target)) return plain_name(value, pool);
    if (target.field == nullptr || target.field->meaning != Meaning::choice) return String(value, &pool);
    return text_of(*target.field, *parse_value(*target.field, value), pool);
}

void read_changes(const hrbfnpr_change* first, std::int64_t count, std::int64_t stride, Pool& pool,
                  Vector<Change>& changes) {
    const api::List<hrbfnpr_change> list(first, count, stride, settings_tuning.most_changes, "changes");
    changes.reserve(changes.size() + static_cast<std::size_t>(list.count()));
    for (std::int64_t i = 0; i < list.count(); ++i) {
        const hrbfnpr_change change = list[i];
        const api::ElementName name = list.name(i);
        const std::string_view field = change_text(change.field, name.text, "field", settings_tuning.longest_path);
        const std::string_view value = change_text(change.value, name.text, "value", settings_tuning.longest_value);
        String path = plain_name(field, pool);
        const ChangeTarget target = find_target(path);
        check_change(target, name.text, path, value, pool);
        if (target.special == Special::field) {
            add_field_uses(value, name.text, pool, changes);
            continue;
        }
        String kept = plain_value(target, value, pool);
        changes.push_back(Change{std::move(path), std::move(kept)});
    }
}

// Sets the fields of a fit that need special rules. A value of regularization also sets its mode, and the mode AUTO
// sets regularization to 0. The field normal_mode is skipped. Returns false for all other fields.
[[nodiscard]] bool set_fit_field(const NamedField& field, std::string_view value, void* record) noexcept {
    const NamedField& mode = *find_field(Record::fit_desc, "regularization_mode");
    const NamedField& amount = *find_field(Record::fit_desc, "regularization");
    const bool is_auto = value == "auto";
    if (&field == &mode) {
        store_value(mode, *parse_value(mode, value), record);
        if (is_auto) store_value(amount, FieldValue{}, record);
        return true;
    }
    if (&field == &amount) {
        store_value(mode, *parse_value(mode, is_auto ? "auto" : "given"), record);
        store_value(amount, is_auto ? FieldValue{} : *parse_value(amount, value), record);
        return true;
    }
    return same_name(field.name, "normal_mode");
}

void apply_text(std::string_view section, Record kind, const NamedField& field, const String& value, void* record) {
    if (kind == Record::fit_desc && set_fit_field(field, value, record)) return;
    if (field.meaning == Meaning::text) {
        store_text(field, value.empty() ? nullptr : value.c_str(), record);
        return;
    }
    std::optional<FieldValue> found = parse_value(field, value);
    if (!found) return; // The value was already checked when the list was read.
    if (kind == Record::layer_style && section.substr(section.find('.') + 1) == layers_part &&
        same_name(field.name, "share"))
        found->numbers[0] *= load_value(field, record).numbers[0];
    store_value(field, *found, record);
}

template <class T>
constexpr Record record_of = Record::style;
#define HRBFNPR_RECORD_OF(name)                                                                                        \
    template <>                                                                                                        \
    constexpr Record record_of<hrbfnpr_##name> = Record::name;
HRBFNPR_NAMED_STRUCTS(HRBFNPR_RECORD_OF)
#undef HRBFNPR_RECORD_OF

} // namespace

Changes::Changes(const hrbfnpr_change* first, std::int64_t count, std::int64_t stride, Pool& pool) : list_(&pool) {
    read_changes(first, count, stride, pool, list_);
}

Changes::Changes(const Vector<std::pair<String, String>>& of_settings, const hrbfnpr_change* first, std::int64_t count,
                 std::int64_t stride, Pool& pool)
    : list_(&pool), from_settings_(of_settings.size()) {
    list_.reserve(of_settings.size());
    for (const auto& [path, value] : of_settings) list_.push_back(Change{String(path, &pool), String(value, &pool)});
    read_changes(first, count, stride, pool, list_);
}

std::optional<std::string_view> Changes::value(std::string_view path) const noexcept {
    const auto found =
        std::find_if(list_.rbegin(), list_.rend(), [&](const Change& change) { return same_name(change.path, path); });
    if (found == list_.rend()) return std::nullopt;
    return found->value;
}

bool Changes::is_callers(std::string_view path) const noexcept {
    return std::any_of(list_.begin() + static_cast<std::ptrdiff_t>(from_settings_), list_.end(),
                       [&](const Change& change) { return same_name(change.path, path); });
}

std::optional<double> Changes::number(std::string_view path) const noexcept {
    const std::optional<std::string_view> text = value(path);
    const ChangeTarget target = find_target(path);
    const NamedField* const field = target.field;
    if (!text || field == nullptr || field->count != 1 || field->meaning == Meaning::text) return std::nullopt;
    const std::optional<FieldValue> found = parse_value(*field, *text);
    if (!found) return std::nullopt;
    return found->numbers[0];
}

std::optional<std::array<float, 4>> Changes::colour(std::string_view path) const noexcept {
    const std::optional<std::string_view> text = value(path);
    const std::optional<FieldValue> found = text ? parse_value(ink_field(), *text) : std::nullopt;
    if (!found) return std::nullopt;
    std::array<float, 4> rgba{};
    for (std::size_t i = 0; i < rgba.size(); ++i) rgba[i] = static_cast<float>(found->numbers[i]);
    return rgba;
}

std::optional<Vector<std::array<float, 4>>> Changes::colours(std::string_view path, Pool& pool) const {
    const std::optional<std::string_view> text = value(path);
    return text ? parse_palette(*text, pool) : std::nullopt;
}

template <class T>
void Changes::apply(std::string_view section, T& record) const {
    for (const Change& change : list_) {
        const std::string_view path = change.path;
        if (path.size() <= section.size() || path.substr(0, section.size()) != section || path[section.size()] != '.')
            continue;
        const NamedField* const field = find_field(record_of<T>, path.substr(section.size() + 1));
        if (field != nullptr) apply_text(section, record_of<T>, *field, change.value, &record);
    }
}

#define HRBFNPR_APPLY(name) template void Changes::apply(std::string_view section, hrbfnpr_##name& record) const;
HRBFNPR_NAMED_STRUCTS(HRBFNPR_APPLY)
#undef HRBFNPR_APPLY

} // namespace hrbfnpr::picture
