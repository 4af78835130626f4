// SPDX-License-Identifier: MIT
// Writes settings. Only values that differ from the defaults are written. Their order never changes, so that files stay
// the same.
#include "base/assert.h"
#include "picture/call.h"
#include "picture/field_table.h"
#include "picture/json.h"
#include "picture/settings.h"
#include "picture/settings_keys.h"
#include "picture/tuning_settings.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace hrbfnpr::picture {
namespace {

// The order in which the fields of a style are written, separated by spaces. It differs from the order in the header.
constexpr std::string_view style_order =
    "hidden_lines visibility silhouette_threshold attenuation_front attenuation_back "
    "splat_radius halo_width verify_lines splat_overlap tone_rule tone_curve evenness tone_fade light_space "
    "tone_exponent "
    "fill_light "
    "depth_min depth_max zoom_reference zoom_exponent paper silhouette_ink silhouette_radius silhouette_radius_zoom "
    "light light_intensity light_shadow light_softness ambient_up ambient_sky ambient_ground occlusion "
    "occlusion_exponent occlusion_lights rim_light rim_exponent tone_black tone_white tone_gamma tone_steps "
    "curvature_contrast tone";
constexpr std::string_view layer_order =
    "name density_strength separation step start start_level angle smoothing axis_weight guide "
    "guide_weight axis guide_direction density levels tone_smoothing";
constexpr std::string_view line_order = "kind name lower upper shortest plane";
// The fields of marks that are written first. All other changed fields follow.
constexpr std::string_view marks_order =
    "distribution initial_step seed_source box_resolution box_jitter tone_ranges shared_budget projection_tolerance "
    "random_seed";
constexpr std::string_view fit_order = "kernel kernel_radius polynomial_degree regularization solver refinement_steps "
                                       "outliers flipped_normals tolerance maximum_centres";

// Calls f for each name in a list of names separated by spaces.
template <class F>
void for_names(std::string_view names, F&& f) {
    while (!names.empty()) {
        const std::size_t end = std::min(names.find(' '), names.size());
        f(names.substr(0, end));
        names.remove_prefix(std::min(end + 1, names.size()));
    }
}

[[nodiscard]] bool same_value(const NamedField& field, const void* a, const void* b) noexcept {
    if (field.meaning != Meaning::text) {
        const FieldValue x = load_value(field, a);
        const FieldValue y = load_value(field, b);
        return x.whole == y.whole && x.numbers == y.numbers;
    }
    const char* const x = load_text(field, a);
    const char* const y = load_text(field, b);
    return x == y || (x != nullptr && y != nullptr && std::strcmp(x, y) == 0);
}

// Writes a number. With `short_floats`, it writes the shortest decimals that give the same float.
void write_number(JsonDocument& to, double number, bool short_floats) {
    if (!std::isfinite(number)) fail(Status::invalid_argument, "settings cannot hold %g: only finite numbers", number);
    to.add_number(short_floats ? shortest_decimals(number) : number);
}

// Adds a key and the value of a field.
void write_value(JsonDocument& to, const NamedField& field, const FieldValue& value, bool short_floats) {
    to.key(field.name);
    const auto whole = static_cast<std::uint32_t>(value.whole);
    if (field.meaning == Meaning::choice && !name_of_choice(field, whole).empty())
        return to.add_text(name_of_choice(field, whole));
    if (field.meaning == Meaning::yes_no) return to.add_bool(value.whole != 0);
    if (field.scalar != Scalar::float32 && field.scalar != Scalar::float64) {
        const bool is_negative = value.numbers[0] < 0.0;
        return to.add_whole(is_negative, is_negative ? 0U - value.whole : value.whole);
    }
    if (field.count == 1) return write_number(to, value.numbers[0], short_floats);
    to.begin(JsonKind::list);
    for (std::size_t i = 0; i < field.count; ++i) write_number(to, value.numbers[i], short_floats);
    to.end();
}

void write_field(JsonDocument& to, const NamedField& field, const void* record, bool short_floats) {
    if (field.meaning != Meaning::text) return write_value(to, field, load_value(field, record), short_floats);
    const char* const text = load_text(field, record);
    to.key(field.name).add_text(text != nullptr ? text : "");
}

// Adds a field if its value differs from that in `base`.
void write_changed(JsonDocument& to, const NamedField& field, const void* record, const void* base, bool short_floats) {
    if (!same_value(field, record, base)) write_field(to, field, record, short_floats);
}

void write_list(JsonDocument& to, std::string_view key, std::span<const double> numbers) {
    to.key(key).begin(JsonKind::list);
    for (const double number : numbers) write_number(to, number, false);
    to.end();
}

[[nodiscard]] std::span<const double> levels_of(const hrbfnpr_array& levels) noexcept {
    HRBFNPR_ASSERT(levels.scalar == HRBFNPR_SCALAR_FLOAT64 &&
                   (levels.stride == 0 || levels.stride == std::int64_t{sizeof(double)}));
    return {static_cast<const double*>(levels.data), static_cast<std::size_t>(levels.count)};
}

// Writes a style of layers or of lines, or a light: its kind, and the fields that differ from the defaults.
template <class Struct>
void write_kind_style(JsonDocument& to, Record record, const Struct& style, const Struct& base) {
    to.begin(JsonKind::object);
    write_field(to, *find_field(record, "kind"), &style, true);
    for (const NamedField& field : fields_of(record))
        if (const std::string_view name = field.name; name != "kind" && name != "name")
            write_changed(to, field, &style, &base, true);
    if constexpr (requires { style.name; }) {
        if (style.name != nullptr) to.key("name").add_text(style.name);
    }
    if constexpr (requires { style.levels; }) {
        if (style.levels.count > 0) write_list(to, "levels", levels_of(style.levels));
    }
    to.end();
}

void write_style(JsonDocument& to, const PictureParts& parts, Pool& pool) {
    const Style base(parts.preset, pool);
    hrbfnpr_style style = parts.style.base;
    if (style.tone == HRBFNPR_TONE_CALLBACK) style.tone = HRBFNPR_TONE_LIGHT; // A function cannot be written.
    to.key("style").begin(JsonKind::object);
    for_names(style_order, [&](std::string_view name) {
        write_changed(to, *find_field(Record::style, name), &style, &base.base, true);
    });
    to.key("layers").begin(JsonKind::list);
    const auto base_layer = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
    // The layer of the ground comes first, because a layer takes the first style that is for it.
    if (parts.ground != nullptr) write_kind_style(to, Record::layer_style, *parts.ground, base_layer);
    for (const hrbfnpr_layer_style& layer : parts.style.layers)
        if (!(parts.ground != nullptr && layer.name != nullptr && std::strcmp(layer.name, parts.ground->name) == 0))
            write_kind_style(to, Record::layer_style, layer, base_layer);
    to.end();
    to.key("lines").begin(JsonKind::list);
    for (const hrbfnpr_line_style& line : parts.style.lines)
        write_kind_style(to, Record::line_style, line, defaults<hrbfnpr_line_style>(hrbfnpr_line_style_init));
    to.end();
    if (!parts.style.lights.empty() || !base.lights.empty()) {
        to.key("lights").begin(JsonKind::list);
        for (const hrbfnpr_light& light : parts.style.lights)
            write_kind_style(to, Record::light, light, defaults<hrbfnpr_light>(hrbfnpr_light_init));
        to.end();
    }
    if (!parts.style.palette.empty()) {
        to.key("palette").begin(JsonKind::list);
        for (const std::array<float, 4>& ink : parts.style.palette) {
            to.begin(JsonKind::list);
            for (const float part : ink) write_number(to, static_cast<double>(part), true);
            to.end();
        }
        to.end();
    }
    to.end();
}

void write_layer(JsonDocument& to, const hrbfnpr_layer_desc& layer) {
    auto base = defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init);
    hrbfnpr_layer_desc plain = layer;
    // A density field comes from paint, which is written separately. A function cannot be written.
    if (plain.density == HRBFNPR_DENSITY_CALLBACK || plain.density == HRBFNPR_DENSITY_FIELD)
        plain.density = base.density;
    to.begin(JsonKind::object);
    const auto field = [](std::string_view name) -> const NamedField& { return *find_field(Record::layer_desc, name); };
    write_field(to, field("kind"), &plain, false);
    write_field(to, field("budget"), &plain, false);
    for_names(layer_order, [&](std::string_view name) { write_changed(to, field(name), &plain, &base, false); });
    const auto write_tone = [&](std::string_view begin, std::string_view end, float last) {
        if (!(last > 0.0F)) return;
        write_field(to, field(begin), &plain, true);
        write_field(to, field(end), &plain, true);
    };
    write_tone("tone_begin", "tone_end", plain.tone_end);
    write_tone("second_tone_begin", "second_tone_end", plain.second_tone_end);
    to.end();
}

// The fields of a section that are given, each once, in the order of writing.
class GivenFields {
public:
    GivenFields(std::string_view section, Record record, Pool& pool)
        : section_(section), record_(record), pool_(&pool), fields_(&pool) {}

    // Sets the text of a field. A field that is already in the list keeps its position.
    void put(std::string_view name, std::string_view text) {
        const auto found = find(name);
        if (found != fields_.end())
            found->second = text;
        else
            fields_.emplace_back(String(name, pool_), String(text, pool_));
    }
    void remove(std::string_view name) {
        const auto found = find(name);
        if (found != fields_.end()) fields_.erase(found);
    }
    [[nodiscard]] bool empty() const noexcept { return fields_.empty(); }
    [[nodiscard]] std::string_view text(std::string_view name) noexcept {
        const auto found = find(name);
        return found != fields_.end() ? std::string_view(found->second) : std::string_view();
    }

    // Adds the changes that come from settings, in their order. Then adds the caller's changes: first those of the
    // fields in `order`, then all others.
    void take(const Changes& changes, std::string_view order) {
        const Vector<Change>& list = changes.list();
        const std::span<const Change> all(list.data(), list.size());
        for (const Change& change : all.first(changes.from_settings())) take(change, {});
        const std::span<const Change> own = all.subspan(changes.from_settings());
        for_names(order, [&](std::string_view name) {
            for (const Change& change : own) take(change, name);
        });
        for (const Change& change : own) take(change, {});
    }

    void write(JsonDocument& to) const {
        for (const auto& [name, text] : fields_) {
            const NamedField* const field = find_field(record_, name);
            const std::optional<FieldValue> value =
                field != nullptr && field->meaning != Meaning::text ? parse_value(*field, text) : std::nullopt;
            if (value) write_value(to, *field, *value, false);
        }
    }

private:
    using Fields = FieldTexts;
    [[nodiscard]] Fields::iterator find(std::string_view name) noexcept {
        return std::find_if(fields_.begin(), fields_.end(), [&](const auto& field) { return field.first == name; });
    }
    // Adds a change. If `only` is not "", only a change with this name is added.
    void take(const Change& change, std::string_view only) {
        const std::string_view path = change.path;
        if (path.size() <= section_.size() || path.substr(0, section_.size()) != section_ ||
            path[section_.size()] != '.')
            return;
        const std::string_view name = path.substr(section_.size() + 1);
        // Null if the name has several parts, such as "marks.hatch.angle".
        const NamedField* const field = find_field(record_, name);
        if (field == nullptr || !is_in_settings(name) || (!only.empty() && name != only)) return;
        put(name, change.value);
    }

    std::string_view section_;
    Record record_;
    Pool* pool_;
    Fields fields_;
};

[[nodiscard]] String decimals_of(double number, Pool& pool) {
    String text(&pool);
    append_decimals(text, number);
    return text;
}

void write_marks(JsonDocument& to, const Options& options, const Marks& marks, Pool& pool) {
    GivenFields fields("marks", Record::generate_desc, pool);
    fields.take(options.changes, marks_order);
    constexpr std::uint64_t usual_seed = 1;
    if (options.desc.random_seed != usual_seed && !options.changes.is_callers("marks.random_seed")) {
        FieldValue seed;
        seed.whole = options.desc.random_seed;
        fields.put("random_seed", text_of(*find_field(Record::generate_desc, "random_seed"), seed, pool));
    }
    if (fields.text("seed_source") == "points") fields.remove("seed_source");
    to.key("marks").begin(JsonKind::object);
    fields.write(to);
    if (const auto direction = options.changes.value("marks.direction_field"); direction && !direction->empty())
        to.key("direction_field").add_text(*direction);
    to.key("layers").begin(JsonKind::list);
    for (const hrbfnpr_layer_desc& layer : marks.layers) write_layer(to, layer);
    to.end();
    to.end();
}

// Adds the fields that choose samples. A fit to samples and a fit to a mesh both have them. Changes of these fields
// have priority over the options. `has_tolerance` and `has_limit` tell whether there are changes of the tolerance and
// of the largest number of centres.
void put_choice(const Options& options, bool has_tolerance, bool has_limit, GivenFields& fields, Pool& pool) {
    if (options.desc.tolerance > 0.0 && !has_tolerance)
        fields.put("tolerance", decimals_of(options.desc.tolerance, pool));
    if (options.desc.maximum_centres > 0 && !has_limit)
        fields.put("maximum_centres", formatted(pool, "%lld", static_cast<long long>(options.desc.maximum_centres)));
}

void write_fit(JsonDocument& to, const Options& options, Pool& pool) {
    GivenFields fields("fit", Record::fit_desc, pool);
    fields.take(options.changes, fit_order);
    put_choice(options, options.changes.is_callers("fit.tolerance"), options.changes.is_callers("fit.maximum_centres"),
               fields, pool);
    // Two fields are removed, because options replace them: normal_mode and trim.
    fields.remove("normal_mode");
    fields.remove("trim");
    const bool is_auto = fields.text("regularization") == "auto" || fields.text("regularization_mode") == "auto";
    fields.remove("regularization_mode");
    if (is_auto) {
        fields.remove("regularization");
        fields.put("regularization_mode", "auto");
    }
    if (options.desc.normals != HRBFNPR_NORMALS_AUTO)
        fields.put("normal_mode", name_of_choice(*find_field(Record::fit_desc, "normal_mode"), options.desc.normals));
    if (options.has(HRBFNPR_PICTURE_CLOSE)) fields.put("trim", "never");
    if (fields.empty()) return;
    to.key("fit").begin(JsonKind::object);
    fields.write(to);
    to.end();
}

void write_mesh_fit(JsonDocument& to, const Options& options, Pool& pool) {
    GivenFields fields("mesh_fit", Record::mesh_fit_desc, pool);
    fields.take(options.changes, "");
    put_choice(options, options.changes.is_callers("mesh_fit.tolerance"),
               options.changes.is_callers("mesh_fit.maximum_centres"), fields, pool);
    if (options.desc.edges != HRBFNPR_PICTURE_EDGES_AS_GIVEN) {
        const std::uint32_t edges = options.desc.edges == HRBFNPR_PICTURE_EDGES_SMOOTH  ? HRBFNPR_EDGES_SMOOTH
                                    : options.desc.edges == HRBFNPR_PICTURE_EDGES_SHARP ? HRBFNPR_EDGES_SHARP
                                                                                        : HRBFNPR_EDGES_AUTO;
        fields.put("edges", name_of_choice(*find_field(Record::mesh_fit_desc, "edges"), edges));
        fields.put("crease_angle", decimals_of(options.desc.edge_angle, pool));
    }
    if (fields.empty()) return;
    to.key("mesh_fit").begin(JsonKind::object);
    fields.write(to);
    to.end();
}

void write_line_set(JsonDocument& to, const Options& options, std::span<const hrbfnpr_line_desc> lines, Pool& pool) {
    GivenFields fields("line_set", Record::line_set_desc, pool);
    fields.take(options.changes, "support");
    const auto is_held = [](const hrbfnpr_line_desc& line) { return line.kind != HRBFNPR_LINE_KIND_OWN; };
    const bool has_lines = std::any_of(lines.begin(), lines.end(), is_held);
    if (fields.empty() && !has_lines) return;
    to.key("line_set").begin(JsonKind::object);
    fields.write(to);
    if (has_lines) {
        to.key("lines").begin(JsonKind::list);
        for (const hrbfnpr_line_desc& line : lines) {
            if (!is_held(line)) continue;
            to.begin(JsonKind::object);
            for_names(line_order, [&](std::string_view name) {
                write_field(to, *find_field(Record::line_desc, name), &line, false);
            });
            if (line.levels.count > 0) write_list(to, "levels", levels_of(line.levels));
            to.end();
        }
        to.end();
    }
    to.end();
}

void write_paint(JsonDocument& to, const Vector<hrbfnpr_dab>& dabs) {
    if (dabs.empty()) return;
    to.key("paint").begin(JsonKind::list);
    for (const hrbfnpr_dab& dab : dabs) {
        HRBFNPR_ASSERT(dab.map < std::size(dab_map_names));
        to.begin(JsonKind::object);
        to.key("map").add_text(dab_map_names[dab.map]);
        write_list(to, "position", dab.position);
        write_list(to, "normal", dab.normal);
        write_number(to.key("radius"), dab.radius, false);
        write_number(to.key("strength"), dab.strength, false);
        if (dab.map == HRBFNPR_DAB_DIRECTION)
            write_list(to, "direction", dab.direction);
        else
            write_number(to.key("value"), dab.value, false);
        to.end();
    }
    to.end();
}

// Returns the options that affect the surface and cannot be stored in settings.
[[nodiscard]] String options_not_held(const Options& options, Pool& pool) {
    String text(&pool);
    const auto add = [&](bool is_given, const char* marker) {
        if (!is_given) return;
        if (!text.empty()) text += ", ";
        text += marker;
    };
    add(options.desc.samples > 0, "{samples}");
    add(!std::isnan(options.desc.crease_angle), "{crease}");
    add(options.desc.parts != HRBFNPR_PARTS_AUTO, "{parts}");
    add(options.viewpoint().has_value(), "{viewpoint}");
    add(!std::isnan(options.desc.depth_smoothing), "{depth_smoothing}");
    add(options.has(HRBFNPR_PICTURE_FLIP), "{flip!}");
    add(!options.seed_points.empty(), "{seed_points}");
    return text;
}

} // namespace

WrittenSettings write_settings(const Options& options, const PictureParts& parts, Pool& pool) {
    JsonDocument document(pool);
    document.begin(JsonKind::object);
    document.key(settings_magic).add_whole(false, settings_version);
    document.key("preset").add_text(hrbfnpr_preset_name(parts.preset));
    document.key("size").begin(JsonKind::list);
    const double* const viewport = parts.camera.viewport;
    for (const std::size_t axis : {0U, 1U}) {
        const double side = std::ceil(viewport[axis] + viewport[axis + 2]);
        HRBFNPR_ASSERT(side >= 1.0 && side <= double{largest_settings_side});
        document.add_whole(false, static_cast<std::uint64_t>(side));
    }
    document.end();
    document.key("pen").add_number(1.0); // The style's lengths are in pixels already, so the pen is 1.
    document.key("camera").begin(JsonKind::object);
    write_list(document, "view", parts.camera.view);
    write_list(document, "projection", parts.camera.projection);
    document.end();
    if (options.desc.ground == HRBFNPR_PICTURE_GROUND_LOWEST) document.key("ground").add_bool(true);
    if (options.desc.ground == HRBFNPR_PICTURE_GROUND_HEIGHT)
        write_number(document.key("ground"), options.desc.ground_height, false);
    write_style(document, parts, pool);
    if (parts.marks != nullptr) write_marks(document, options, *parts.marks, pool);
    write_fit(document, options, pool);
    write_mesh_fit(document, options, pool);
    write_line_set(document, options, parts.lines, pool);
    write_paint(document, options.dabs);
    document.end();
    WrittenSettings written{String(&pool), options_not_held(options, pool)};
    document.write(written.json, 0, 0);
    written.json += '\n';
    if (written.json.size() > settings_tuning.most_bytes)
        fail(Status::invalid_argument, "the settings would have %zu bytes, and %zu are the most: paint less",
             written.json.size(), settings_tuning.most_bytes);
    return written;
}

} // namespace hrbfnpr::picture
