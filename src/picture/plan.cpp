// SPDX-License-Identifier: MIT
#include "picture/plan.h"

#include "base/assert.h"
#include "picture/field_table.h"
#include "picture/lights.h"
#include "picture/paint.h"
#include "picture/tuning_plan.h"
#include "picture/wanted_lines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace hrbfnpr::picture {
namespace {

// ---- Changes by their paths

// The names of the layer kinds, indexed by HRBFNPR_LAYER_KIND_*.
constexpr std::array<const char*, 4> layer_kind_names{"any", "stipples", "hatch", "own"};

const char* layer_kind_name(std::uint32_t kind) noexcept {
    return kind < layer_kind_names.size() ? layer_kind_names[kind] : "layer";
}

std::optional<std::uint32_t> layer_kind_of(std::string_view name) noexcept {
    for (std::uint32_t kind = 0; kind < layer_kind_names.size(); ++kind)
        if (layer_kind_names[kind] == name) return kind;
    return std::nullopt;
}

// The parts of a path: "style.hatch.ink" has the section "style", the group "hatch" and the field "ink".
struct ChangedField {
    std::string_view section, group, field;
};

ChangedField parts_of_path(std::string_view path) noexcept {
    const std::size_t first = path.find('.');
    const std::size_t last = path.rfind('.');
    if (first == std::string_view::npos) return {{}, {}, path};
    const std::string_view group = last > first ? path.substr(first + 1, last - first - 1) : std::string_view();
    return {path.substr(0, first), group, path.substr(last + 1)};
}

// Applies `change` to a record. If it sets a text of the record, `keeper` stores the text.
template <class Struct, class Keeper>
void apply_one_change(const Change& change, Struct& record, Keeper& keeper, Pool& pool) {
    const hrbfnpr_change given{sizeof given, 0, change.path.c_str(), change.value.c_str()};
    const Changes one(&given, 1, 0, pool);
    const Struct before = record;
    one.apply(std::string_view(change.path).substr(0, change.path.rfind('.')), record);
    for (const auto text : texts_of(record))
        if (record.*text != before.*text && record.*text != nullptr) record.*text = keeper.keep(record.*text);
}

// Returns whether the caller, not a file of settings, changed a field.
bool is_changed_by_caller(const Changes& changes, std::string_view path) noexcept {
    const Vector<Change>& all = changes.list();
    HRBFNPR_ASSERT(changes.from_settings() <= all.size());
    return std::any_of(all.begin() + static_cast<std::ptrdiff_t>(changes.from_settings()), all.end(),
                       [&](const Change& change) { return change.path == path; });
}

bool is_published(const Options& options) noexcept {
    return options.changes.number("marks.distribution") == double{HRBFNPR_DISTRIBUTION_PUBLISHED};
}

// Reads kinds of layers that are separated by commas. Throws for a kind that a picture cannot make.
Vector<std::uint32_t> mark_kinds_of(const Call& call, std::string_view names) {
    Vector<std::uint32_t> kinds(&call.pool);
    while (!names.empty()) {
        const std::size_t comma = names.find(',');
        const std::string_view name = names.substr(0, comma);
        names.remove_prefix(comma == std::string_view::npos ? names.size() : comma + 1);
        if (name.empty()) continue;
        const std::optional<std::uint32_t> kind = layer_kind_of(name);
        if (!kind || *kind == HRBFNPR_LAYER_KIND_ANY || *kind == HRBFNPR_LAYER_KIND_OWN)
            call.report.refuse(formatted(call.pool, "{layers} must be stipples, hatch or both, not '%.*s'",
                                         static_cast<int>(std::min<std::size_t>(name.size(), 60)), name.data()));
        kinds.push_back(*kind);
    }
    return kinds;
}

// ---- The style

float scaled_number(float number, double factor) noexcept {
    return static_cast<float>(static_cast<double>(number) * factor);
}

Style chosen_style(const Call& call) {
    const Options& options = call.options;
    if (options.style) return {*options.style, call.pool};
    if (options.takes_style_of_settings) return {options.settings->style, call.pool};
    return {options.desc.preset, call.pool};
}

// Sets a style to draw the marks of the published recursion as dots of one size.
void draw_as_published(Style& style, std::uint32_t preset) noexcept {
    for (hrbfnpr_layer_style& layer : style.layers) {
        if (layer.kind == HRBFNPR_LAYER_KIND_HATCH && layer.shown != 0) {
            layer.shape = HRBFNPR_SHAPE_DOTS;
            layer.radius = plan_tuning.published_dot;
            layer.share = preset == HRBFNPR_PRESET_FULL ? plan_tuning.published_share_of_full : 1.0F;
            // 2: only strokes along the direction d2. 3: strokes along both directions.
            layer.directions = preset == HRBFNPR_PRESET_HATCH ? 2U : 3U;
        }
        if (layer.kind == HRBFNPR_LAYER_KIND_STIPPLES && preset == HRBFNPR_PRESET_FULL)
            layer.radius = layer.share = 1.0F;
    }
}

void scale_by_pen(Style& style, double pen) noexcept {
    for (hrbfnpr_layer_style& layer : style.layers)
        for (float* const length : {&layer.radius, &layer.hatch_spacing, &layer.hatch_pen, &layer.hatch_white,
                                    &layer.hatch_taper, &layer.hatch_shortest, &layer.hatch_overshoot})
            *length = scaled_number(*length, pen);
    style.base.silhouette_radius = scaled_number(style.base.silhouette_radius, pen);
    style.base.halo_width = scaled_number(style.base.halo_width, pen);
}

// Applies "style.layers.F" to all layers. A changed share is multiplied by the share that each layer has in the style.
void change_all_layers(const Call& call, Style& style) {
    const std::optional<double> share = call.options.changes.number("style.layers.share");
    for (hrbfnpr_layer_style& layer : style.layers) {
        if (share) layer.share = scaled_number(layer.share, *share);
        for (const Change& change : call.options.changes.list()) {
            const ChangedField path = parts_of_path(change.path);
            if (path.section == "style" && path.group == "layers" && path.field != "share")
                apply_one_change(change, layer, style, call.pool);
        }
    }
}

// Applies "style.light", which replaces all lights. Fields that it leaves out come from the style's single light.
void set_lights(const Call& call, Style& style) {
    const std::optional<std::string_view> text = call.options.changes.value("style.light");
    if (!text) return;
    style.lights.clear();
    if (!is_list_of_lights(*text)) return; // The direction is a field of the style.
    const hrbfnpr_style& base = style.base;
    auto others = defaults<hrbfnpr_light>(hrbfnpr_light_init);
    others.space = base.light_space;
    others.softness = base.light_softness;
    hrbfnpr_light first = others;
    first.intensity = base.light_intensity;
    first.shadow = base.light_shadow;
    others.intensity = plan_tuning.second_light;
    if (const auto lights = read_lights(*text, first, others, call.pool))
        style.lights.assign(lights->begin(), lights->end());
}

// Applies "style.F". "style.ink" sets the ink of layers, lines and contours. "style.silhouette_ink" is applied after
// it, and sets the ink of contours and lines.
void change_style(const Call& call, Style& style) {
    const Changes& changes = call.options.changes;
    changes.apply("style", style.base);
    set_lights(call, style);
    float contours[4];
    std::copy(style.base.silhouette_ink, style.base.silhouette_ink + 4, contours);
    if (const auto given = changes.colour("style.ink")) {
        float ink[4];
        std::copy(given->begin(), given->end(), ink);
        style.set_ink(ink);
    }
    if (changes.has("style.silhouette_ink")) {
        std::copy(contours, contours + 4, style.base.silhouette_ink);
        for (hrbfnpr_line_style& line : style.lines) std::copy(contours, contours + 4, line.ink);
    }
    if (auto palette = changes.colours("style.palette", call.pool)) style.palette = *std::move(palette);
    if (call.options.has(HRBFNPR_PICTURE_TRANSPARENT)) style.base.paper[3] = 0.0F;
}

// Applies the changes "style.KIND.F" in order. The first change of a kind adds an element for it.
void change_kinds(const Call& call, Style& style) {
    for (const Change& change : call.options.changes.list()) {
        const ChangedField path = parts_of_path(change.path);
        if (path.section != "style") continue;
        if (const std::optional<std::uint32_t> kind = layer_kind_of(path.group))
            apply_one_change(change, style.layer(*kind), style, call.pool);
    }
}

// Returns whether a group of paths, such as "lines" or "ridge", includes a kind of lines.
bool is_for_lines(std::string_view group, std::uint32_t kind) noexcept {
    if (group == "lines") return true;
    const NamedConstant* const named = find_choice(*find_field(Record::line_style, "kind"), group);
    return named != nullptr && static_cast<std::uint32_t>(named->value) == kind && !layer_kind_of(group);
}

// Applies "style.lines.F" and changes for single kinds such as "style.ridge.F". If lines wobble, their width varies,
// too.
void change_lines(const Call& call, Style& style) {
    const Changes& changes = call.options.changes;
    const std::optional<double> wobble = changes.number("style.lines.wobble");
    for (hrbfnpr_line_style& line : style.lines) {
        if (wobble) line.wobble_width = static_cast<float>(std::min(1.0, line_style_tuning.width_of_wobble * *wobble));
        for (const Change& change : changes.list()) {
            const ChangedField path = parts_of_path(change.path);
            if (path.section == "style" && is_for_lines(path.group, line.kind))
                apply_one_change(change, line, style, call.pool);
        }
    }
}

// ---- The layers of marks

struct LayerPlan {
    hrbfnpr_layer_desc desc;
    // True if the number of marks is given or already chosen. If false, the value of the budget is ignored.
    bool has_budget;
};

LayerPlan layer_of_kind(std::uint32_t kind) noexcept {
    LayerPlan layer{defaults<hrbfnpr_layer_desc>(hrbfnpr_layer_desc_init), false};
    layer.desc.kind = kind;
    return layer;
}

bool is_stroke_kind(std::uint32_t kind) noexcept { return kind != HRBFNPR_LAYER_KIND_STIPPLES; }

const char* name_of_layer(const hrbfnpr_layer_desc& layer) noexcept {
    return layer.name != nullptr ? layer.name : layer_kind_name(layer.kind);
}

// Returns whether the published recursion makes strokes for a preset. These strokes form one layer with both
// directions, instead of the layers that the preset has otherwise.
bool has_published_strokes(std::uint32_t preset) noexcept {
    return preset == HRBFNPR_PRESET_HATCH || preset == HRBFNPR_PRESET_CROSS_HATCH || preset == HRBFNPR_PRESET_FULL ||
           preset == HRBFNPR_PRESET_COMBING;
}

Vector<LayerPlan> layers_of_preset(const Call& call) {
    const Options& options = call.options;
    Vector<LayerPlan> layers(&call.pool);
    if (has_published_strokes(options.desc.preset) && is_published(options)) {
        layers.push_back(layer_of_kind(HRBFNPR_LAYER_KIND_STIPPLES));
        layers.push_back(layer_of_kind(HRBFNPR_LAYER_KIND_HATCH));
        if (options.desc.preset == HRBFNPR_PRESET_COMBING) layers.back().desc.guide = HRBFNPR_HATCH_GUIDE_COMBING;
    } else {
        std::int64_t count = 0;
        const hrbfnpr_layer_desc* const first = hrbfnpr_preset_layers(options.desc.preset, &count);
        for (std::int64_t i = 0; i < count; ++i) layers.push_back({first[i], false});
    }
    // The layers of a preset have separate tone ranges, which add strokes from light to dark. If the caller sets
    // marks.tone_ranges, that setting replaces them: ranges of 0 to 0 mean that it decides.
    if (is_changed_by_caller(options.changes, "marks.tone_ranges"))
        for (LayerPlan& layer : layers)
            layer.desc.tone_begin = layer.desc.tone_end = layer.desc.second_tone_begin = layer.desc.second_tone_end = 0;
    return layers;
}

Vector<LayerPlan> layers_of_style(const Call& call) {
    const char* const names = call.options.desc.mark_kinds;
    Vector<LayerPlan> layers(&call.pool);
    if (names != nullptr)
        for (const std::uint32_t kind : mark_kinds_of(call, names)) layers.push_back(layer_of_kind(kind));
    return layers.empty() ? layers_of_preset(call) : std::move(layers);
}

// Returns the layers in a file of settings. Each has a number of marks, possibly by default.
Vector<LayerPlan> layers_of_settings(const Call& call, Marks& marks) {
    Vector<LayerPlan> layers(&call.pool);
    for (const hrbfnpr_layer_desc& desc : call.options.settings->marks.layers) {
        layers.push_back({desc, true});
        if (desc.name != nullptr) layers.back().desc.name = marks.keep(desc.name);
    }
    return layers;
}

// Returns whether a field of "marks.layers" has a meaning for layers of a kind.
bool means_something_to(std::uint32_t kind, std::string_view field) noexcept {
    const bool is_stipples = kind == HRBFNPR_LAYER_KIND_STIPPLES;
    const bool is_hatch = kind == HRBFNPR_LAYER_KIND_HATCH;
    if (field == "density" || field == "density_strength") return is_stipples;
    if (field == "guide" || field == "guide_direction" || field == "guide_weight") return is_hatch;
    if (field == "angle" || field == "smoothing" || field == "axis" || field == "axis_weight") return is_hatch;
    if (field == "separation" || field == "step" || field == "start" || field == "start_level") return is_hatch;
    return true;
}

// Applies "marks.layers.F" to all layers, then "marks.KIND.F" to one kind, then the rotation of all hatching lines.
void change_layers(const Call& call, Vector<LayerPlan>& layers, Marks& marks) {
    for (LayerPlan& layer : layers) {
        const std::uint32_t kind = layer.desc.kind;
        layer.desc.flags = 0;
        for (const std::string_view group : {std::string_view("layers"), std::string_view(layer_kind_name(kind))})
            for (const Change& change : call.options.changes.list()) {
                const ChangedField path = parts_of_path(change.path);
                if (path.section != "marks" || path.group != group || path.field == "kind") continue;
                if (group == "layers" && !means_something_to(kind, path.field)) continue;
                apply_one_change(change, layer.desc, marks, call.pool);
                if (path.field == "budget") layer.has_budget = true;
            }
        if (kind == HRBFNPR_LAYER_KIND_HATCH) layer.desc.angle += call.options.desc.hatch_angle;
    }
}

// Returns whether the number of a layer's marks is given, or follows from its separation.
bool says_itself(const LayerPlan& layer) noexcept {
    return layer.has_budget || (is_stroke_kind(layer.desc.kind) && layer.desc.separation > 0.0);
}

void set_budget(LayerPlan& layer, std::int64_t budget) noexcept {
    layer.desc.budget = budget;
    layer.has_budget = true;
}

// Plans few marks if the style draws only lines. The hidden parts of lines are found without marks.
void thin_unseen(Vector<LayerPlan>& layers, const Style& style) noexcept {
    const bool shows_marks = std::any_of(style.layers.begin(), style.layers.end(),
                                         [](const hrbfnpr_layer_style& layer) { return layer.shown != 0; });
    if (style.lines.empty() || shows_marks) return;
    for (LayerPlan& layer : layers)
        if (!says_itself(layer)) set_budget(layer, plan_tuning.unseen_marks);
}

struct Canvas {
    double area;            // the area of the surface, in squared units of the model
    double pixels_per_unit; // the length of a unit in the picture, in pixels
    double seeds;           // the number of seeds of the published recursion
};

// Converts a number, which may be NaN or too large, to a number of marks.
std::int64_t whole_marks(double wanted) noexcept {
    if (!(wanted >= 1.0)) return 1; // The comparison is false for NaN, too.
    return static_cast<std::int64_t>(std::nearbyint(std::min(wanted, static_cast<double>(plan_tuning.most_marks))));
}

void note_limited(const Call& call, const hrbfnpr_layer_desc& layer, double wanted) {
    const char* const kind = layer_kind_name(layer.kind);
    const auto made = static_cast<double>(plan_tuning.most_marks);
    // The note proposes the wanted number of marks, rounded up to two digits, unless it is above the limit of a layer.
    const double digit = std::pow(10.0, std::floor(std::log10(wanted)) - 1.0);
    const double rounded = std::ceil(wanted / digit) * digit;
    const String advice = rounded <= plan_tuning.largest_budget
                              ? formatted(call.pool, "{marks=%s=%.0f} fills them", kind, rounded)
                              : String("a larger {mark_radius} fills them", &call.pool);
    call.report.note(HRBFNPR_NOTE_MARKS_LIMITED, {wanted, made},
                     formatted(call.pool, "%s: dark tones are too light; %s",
                               short_name(name_of_layer(layer), call.pool).c_str(), advice.c_str()),
                     {.detail = formatted(
                          call.pool,
                          "Full tone needs %.1f million marks, and %.1f million are made. With a larger {mark_radius} "
                          "fewer marks are enough.",
                          wanted / 1e6, made / 1e6)});
}

// Plans a layer with even spacing. If its number of marks is not given, the layer gets as many marks as the darkest
// tone needs. `radius` is the radius of the marks, in pixels.
void fill_evenly(const Call& call, LayerPlan& layer, double radius, const Canvas& canvas) {
    const auto [area, pixels, seeds] = canvas;
    hrbfnpr_layer_desc& desc = layer.desc;
    if (desc.kind == HRBFNPR_LAYER_KIND_HATCH) {
        // The number of lines does not depend on the size of the picture. Each line has a level, and a small picture
        // omits the lines of the finest levels.
        const bool is_said = (layer.has_budget && desc.budget != 0) || desc.separation != 0.0;
        if (!is_said) desc.separation = std::sqrt(area) / plan_tuning.hatch_lines;
        return;
    }
    if (says_itself(layer)) return;
    const double wanted =
        plan_tuning.stipple_coverage * area * (pixels * pixels) / (std::numbers::pi * (radius * radius));
    if (wanted > static_cast<double>(plan_tuning.most_marks)) note_limited(call, desc, wanted);
    set_budget(layer, whole_marks(wanted));
}

// Plans a layer of the published recursion. It gets the largest number of refinement steps with which the darkest tone
// is not too dark.
void fill_as_published(const Call& call, LayerPlan& layer, double radius, const Canvas& canvas) {
    hrbfnpr_layer_desc& desc = layer.desc;
    if (desc.levels >= 0) return;
    const auto [area, pixels, seeds] = canvas;
    const bool is_stipples = desc.kind == HRBFNPR_LAYER_KIND_STIPPLES;
    const double wanted = area * (pixels * pixels) / (std::numbers::pi * (radius * radius));
    const double start = is_stipples ? seeds : 2.0 * seeds;
    const double factor = is_stipples ? 5.0 : 3.0;
    const double steps = std::nearbyint(std::log(std::max(wanted, 1.0) / std::max(start, 1.0)) / std::log(factor));
    if (steps > plan_tuning.most_levels)
        call.report.note(HRBFNPR_NOTE_LEVELS_LIMITED, {steps, static_cast<double>(plan_tuning.most_levels)},
                         formatted(call.pool, "%s: dark tones are too light; {levels=%s=%.0f} fills them",
                                   short_name(name_of_layer(desc), call.pool).c_str(), layer_kind_name(desc.kind),
                                   std::min(steps, plan_tuning.largest_levels)),
                         {.detail = formatted(call.pool, "Full tone needs %.0f refinement steps, and %d are made.",
                                              steps, plan_tuning.most_levels)});
    desc.levels = steps >= 1.0 ? static_cast<std::int32_t>(std::min<double>(steps, plan_tuning.most_levels)) : 1;
}

void fill_layers(const Call& call, Vector<LayerPlan>& layers, const Style& style, const Canvas& canvas) {
    const bool published = is_published(call.options);
    for (LayerPlan& layer : layers) {
        const double radius = static_cast<double>(style.style_of(layer.desc.kind, layer.desc.name).radius);
        if (published)
            fill_as_published(call, layer, radius, canvas);
        else
            fill_evenly(call, layer, radius, canvas);
    }
}

// Divides the range of tones evenly among the layers that the style draws, and among the directions of published
// strokes. A layer that is not drawn gets no range, because its marks only tell where the surface is.
void take_turns(Pool& pool, Vector<LayerPlan>& layers, const Style& style, bool published) {
    struct Turn {
        std::size_t layer;
        bool is_second; // true for the second direction of strokes
    };
    Vector<Turn> turns(&pool);
    for (std::size_t i = 0; i < layers.size(); ++i) {
        const hrbfnpr_layer_desc& desc = layers[i].desc;
        const hrbfnpr_layer_style how = style.style_of(desc.kind, desc.name);
        // Two kinds of layers get no range of tones: a hatch layer, whose style sets the tones at which lines appear,
        // and a layer that is not drawn.
        if ((desc.kind == HRBFNPR_LAYER_KIND_HATCH && !published) || how.shown == 0) continue;
        const bool is_stipples = desc.kind == HRBFNPR_LAYER_KIND_STIPPLES;
        if (is_stipples || (how.directions & 1U) != 0) turns.push_back({i, false});
        if (!is_stipples && (how.directions & 2U) != 0) turns.push_back({i, true});
    }
    const auto count = static_cast<double>(turns.size());
    for (std::size_t turn = 0; turn < turns.size(); ++turn) {
        hrbfnpr_layer_desc& desc = layers[turns[turn].layer].desc;
        const auto begin = static_cast<float>(static_cast<double>(turn) / count);
        const auto end = static_cast<float>(static_cast<double>(turn + 1) / count);
        (turns[turn].is_second ? desc.second_tone_begin : desc.tone_begin) = begin;
        (turns[turn].is_second ? desc.second_tone_end : desc.tone_end) = end;
    }
}

// Removes the limit of the number of marks for the published recursion, and for strokes with a separation, unless a
// budget is given.
void set_open_budget(LayerPlan& layer, std::uint32_t distribution) noexcept {
    if (layer.has_budget) return;
    if (distribution == HRBFNPR_DISTRIBUTION_PUBLISHED || says_itself(layer)) layer.desc.budget = 0;
}

// Applies "marks.F", and sets the seed points and the random seed from the descriptor.
void set_base(const Call& call, Marks& marks) {
    const Options& options = call.options;
    options.changes.apply("marks", marks.base);
    constexpr std::uint64_t usual_seed = 1;
    if (options.desc.random_seed != usual_seed && !is_changed_by_caller(options.changes, "marks.random_seed"))
        marks.base.random_seed = options.desc.random_seed;
    if (options.seed_points.empty()) return;
    marks.set_seed_points(view_of(options.seed_points));
    if (marks.base.seed_source == HRBFNPR_SEED_AUTO) marks.base.seed_source = HRBFNPR_SEED_POINTS;
}

} // namespace

double pen_of(const Call& call, double width, double height) {
    const Options& options = call.options;
    if (options.style) return 1.0;
    if (options.desc.pen > 0.0) return options.desc.pen;
    if (options.takes_style_of_settings && options.settings->pen > 0.0) return options.settings->pen;
    return std::max(plan_tuning.least_pen, std::max(width, height) / plan_tuning.sides_of_pen);
}

Style plan_style(const Call& call, double width, double height, bool has_end) {
    const Options& options = call.options;
    Style style = chosen_style(call);
    if (!options.takes_style_of_settings) {
        if (is_published(options)) draw_as_published(style, options.desc.preset);
        static_cast<void>(style.layer(HRBFNPR_LAYER_KIND_ANY));
    }
    const double pen = pen_of(call, width, height);
    scale_by_pen(style, pen);
    change_all_layers(call, style);
    size_lines(call, style, pen, has_end);
    change_style(call, style);
    change_kinds(call, style);
    change_lines(call, style);
    if (options.has(HRBFNPR_PICTURE_VERIFY)) style.base.verify_lines = 1;
    return style;
}

bool draws_hidden(const Style& style) noexcept {
    return style.base.hidden_lines == HRBFNPR_HIDDEN_LINES_SHOW ||
           std::any_of(style.lines.begin(), style.lines.end(),
                       [](const hrbfnpr_line_style& line) { return line.hidden != HRBFNPR_HIDDEN_PARTS_NONE; });
}

Marks plan_marks(const Call& call, const Style& style, double area, double pixels_per_unit, std::int64_t centres) {
    HRBFNPR_ASSERT(centres >= 0);
    const Options& options = call.options;
    Marks marks(call.pool);
    set_base(call, marks);
    const bool are_given =
        options.takes_style_of_settings && options.settings->has_layers && options.desc.mark_kinds == nullptr;
    Vector<LayerPlan> layers = are_given ? layers_of_settings(call, marks) : layers_of_style(call);
    change_layers(call, layers, marks);
    if (!are_given) {
        // With the flag KEEP_MARKS, the number of marks is not reduced, because another style may draw them.
        // On a ground they hide the shadow evenly.
        const bool is_thin = !options.has(HRBFNPR_PICTURE_KEEP_MARKS) && !options.wants_ground();
        if (!is_published(options) && is_thin) thin_unseen(layers, style);
        fill_layers(call, layers, style,
                    {area, pixels_per_unit, static_cast<double>(std::max<std::int64_t>(centres, 1))});
        if (is_changed_by_caller(options.changes, "marks.tone_ranges") &&
            marks.base.tone_ranges == HRBFNPR_TONE_RANGES_IN_TURN)
            take_turns(call.pool, layers, style, is_published(options));
    }
    marks.layers.reserve(layers.size());
    for (LayerPlan& layer : layers) {
        set_open_budget(layer, marks.base.distribution);
        marks.layers.push_back(layer.desc);
    }
    marks.direction_field = options.changes.value("marks.direction_field").value_or(std::string_view());
    set_paint(call, marks);
    return marks;
}

Marks share_of(const Marks& marks, double share) {
    HRBFNPR_ASSERT(!(share < 0.0) && !(share > 1.0));
    Marks part(marks);
    for (hrbfnpr_layer_desc& layer : part.layers) {
        if (layer.budget <= 0) continue; // A budget of 0 or less is no limit, and stays as it is.
        const double wanted = std::nearbyint(share * static_cast<double>(layer.budget));
        layer.budget = wanted >= 1.0 ? static_cast<std::int64_t>(wanted) : 1;
    }
    return part;
}

PointSet generate_marks(const Call& call, const Model& model, const Marks& marks, const StillDrawing* still) {
    Stage stage(call.report, HRBFNPR_STAGE_MARKS);
    const hrbfnpr_generate_desc desc = marks.view();
    auto made = make<PointSet>([&](hrbfnpr_point_set** set, hrbfnpr_error* error) {
        if (still == nullptr)
            return hrbfnpr_point_set_generate(&call.context, model.get(), &desc, stage.operation(), set, error);
        return hrbfnpr_point_set_generate_still(&call.context, model.get(), &desc, &still->item, &still->camera,
                                                stage.operation(), set, error);
    });
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    picture::call([&](hrbfnpr_error* error) { return hrbfnpr_point_set_get_info(made.get(), &info, error); });
    String says = formatted(call.pool, "%lld marks:", static_cast<long long>(info.marks));
    for (std::int64_t i = 0; i < info.layers; ++i) {
        auto layer = defaults<hrbfnpr_layer_info>(hrbfnpr_layer_info_init);
        picture::call(
            [&](hrbfnpr_error* error) { return hrbfnpr_point_set_get_layer_info(made.get(), i, &layer, error); });
        says += i == 0 ? " " : ", ";
        says += layer.name;
    }
    stage.says(says);
    return made;
}

std::uint32_t sides_of(const Call& call, const Model& model) {
    if (call.options.desc.sides == HRBFNPR_PICTURE_SIDES_FRONT) return HRBFNPR_SIDES_FRONT;
    if (call.options.desc.sides == HRBFNPR_PICTURE_SIDES_BOTH) return HRBFNPR_SIDES_BOTH;
    if (!model) return HRBFNPR_SIDES_FRONT;
    auto info = defaults<hrbfnpr_trim_info>(hrbfnpr_trim_info_init);
    picture::call([&](hrbfnpr_error* error) { return hrbfnpr_model_get_trim_info(model.get(), &info, error); });
    return info.is_trimmed != 0 ? HRBFNPR_SIDES_BOTH : HRBFNPR_SIDES_FRONT;
}

} // namespace hrbfnpr::picture
