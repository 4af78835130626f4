// SPDX-License-Identifier: MIT
#include "picture/style.h"

#include "api/lists.h"
#include "api/views.h"
#include "base/assert.h"
#include "frame/scene/style.h"
#include "picture/handles.h"

#include <algorithm>
#include <cstring>

namespace hrbfnpr::picture {
namespace {

// The largest number of elements in a list that the library accepts.
constexpr std::int64_t most_style_elements = 65536;

bool same_style_name(const char* a, const char* b) noexcept {
    return a == b || (a != nullptr && b != nullptr && std::strcmp(a, b) == 0);
}

bool style_is_for(const hrbfnpr_layer_style& style, std::uint32_t kind, const char* name) noexcept {
    return (style.kind == HRBFNPR_LAYER_KIND_ANY || style.kind == kind) &&
           (style.name == nullptr || same_style_name(style.name, name));
}

// Returns a copy of a style with empty lists. The caller fills the lists.
hrbfnpr_style style_without_lists(hrbfnpr_style style) noexcept {
    style.layers = nullptr;
    style.lines = nullptr;
    style.lights = nullptr;
    style.layer_count = style.layer_stride = style.line_count = style.line_stride = 0;
    style.light_count = style.light_stride = 0;
    style.palette = nullptr;
    style.palette_count = 0;
    return style;
}

hrbfnpr_generate_desc marks_without_list(hrbfnpr_generate_desc desc) noexcept {
    desc.layers = nullptr;
    desc.layer_count = desc.layer_stride = 0;
    return desc;
}

template <std::size_t count>
bool same_numbers(const double (&a)[count], const double (&b)[count]) noexcept {
    return std::equal(a, a + count, b);
}

bool same_dab(const hrbfnpr_dab& a, const hrbfnpr_dab& b) noexcept {
    return a.map == b.map && same_numbers(a.position, b.position) && same_numbers(a.normal, b.normal) &&
           a.radius == b.radius && a.strength == b.strength && a.value == b.value &&
           same_numbers(a.direction, b.direction);
}

bool same_seed_points(const hrbfnpr_array& a, const hrbfnpr_array& b) noexcept {
    const base::InView first = api::in_view(a, "seed_points", api::points_type);
    const base::InView second = api::in_view(b, "seed_points", api::points_type);
    if (first.count != second.count) return false;
    for (std::int64_t i = 0; i < first.count; ++i)
        for (std::uint32_t axis = 0; axis < 3; ++axis)
            if (first.get(i, axis) != second.get(i, axis)) return false;
    return true;
}

// Returns whether two densities are the same. Fields are compared by Marks::same_as(), as paint is.
bool same_density(const hrbfnpr_layer_desc& a, const hrbfnpr_layer_desc& b) noexcept {
    return a.density == b.density && a.density_function == b.density_function && a.density_user == b.density_user;
}

bool same_direction(const hrbfnpr_layer_desc& a, const hrbfnpr_layer_desc& b) noexcept {
    return a.direction_function == b.direction_function && a.direction_user == b.direction_user;
}

bool same_layer(const hrbfnpr_layer_desc& a, const hrbfnpr_layer_desc& b) noexcept {
    return a.kind == b.kind && same_style_name(a.name, b.name) && a.budget == b.budget &&
           a.tone_begin == b.tone_begin && a.tone_end == b.tone_end && a.second_tone_begin == b.second_tone_begin &&
           a.second_tone_end == b.second_tone_end && a.flags == b.flags && same_density(a, b) &&
           a.density_strength == b.density_strength && a.separation == b.separation && a.step == b.step &&
           same_direction(a, b) && a.start == b.start && a.start_level == b.start_level && a.levels == b.levels &&
           a.angle == b.angle && a.smoothing == b.smoothing && same_numbers(a.axis, b.axis) &&
           a.axis_weight == b.axis_weight && a.tone_smoothing == b.tone_smoothing && a.guide == b.guide &&
           same_numbers(a.guide_direction, b.guide_direction) && a.guide_weight == b.guide_weight;
}

bool same_base(const hrbfnpr_generate_desc& a, const hrbfnpr_generate_desc& b) noexcept {
    return a.distribution == b.distribution && a.shared_budget == b.shared_budget && a.tone_ranges == b.tone_ranges &&
           a.seed_source == b.seed_source && same_seed_points(a.seed_points, b.seed_points) &&
           a.box_jitter == b.box_jitter && a.box_resolution == b.box_resolution && a.initial_step == b.initial_step &&
           a.projection_tolerance == b.projection_tolerance && a.random_seed == b.random_seed;
}

// The assignment operator needs a move that does not throw.
static_assert(std::is_nothrow_move_constructible_v<Style> && std::is_nothrow_move_constructible_v<Marks>);

} // namespace

hrbfnpr_array KeptTexts::numbers(const double* first, std::size_t count, std::uint32_t components) {
    Vector<double>& kept = numbers_.emplace_back();
    kept.assign(first, first + count * components);
    return {kept.data(), static_cast<std::int64_t>(count), 0, HRBFNPR_SCALAR_FLOAT64, components};
}

Style::Style(Pool& pool)
    : base(defaults<hrbfnpr_style>(hrbfnpr_style_init)), layers(&pool), lines(&pool), lights(&pool), palette(&pool),
      pool_(&pool), kept_(pool) {}

Style::Style(std::uint32_t preset, Pool& pool) : Style(pool) {
    hrbfnpr_style named;
    call([&](hrbfnpr_error* error) { return hrbfnpr_style_init_preset(&named, sizeof named, preset, error); });
    base = style_without_lists(named);
    take_lists(named);
}

Style::Style(const hrbfnpr_style& given, Pool& pool) : Style(pool) {
    const hrbfnpr_style full = api::read_struct(&given, "style");
    base = style_without_lists(full);
    take_lists(full);
}

Style::Style(const Style& other, Pool& pool)
    : base(other.base), layers(other.layers, &pool), lines(other.lines, &pool), lights(other.lights, &pool),
      palette(other.palette, &pool), pool_(&pool), kept_(pool) {
    kept_.hold_all_of(other.kept_);
    for (hrbfnpr_layer_style& layer : layers) keep_texts(layer);
    for (hrbfnpr_line_style& line : lines) {
        if (line.name != nullptr) line.name = kept_.text(line.name);
        if (line.levels.count > 0)
            line.levels = kept_.numbers(static_cast<const double*>(line.levels.data),
                                        static_cast<std::size_t>(line.levels.count));
    }
}

Style& Style::operator=(Style other) noexcept {
    // This object is destroyed and constructed again. An assignment of members would not do: the lists of `other`
    // belong to another pool, and texts must not move.
    std::destroy_at(this);
    return *std::construct_at(this, std::move(other));
}

void Style::keep_texts(hrbfnpr_layer_style& layer) {
    for (const auto text : layer_style_texts)
        if (layer.*text != nullptr) layer.*text = kept_.text(layer.*text);
}

void Style::take_lists(const hrbfnpr_style& given) {
    const api::List<hrbfnpr_layer_style> all_layers(given.layers, given.layer_count, given.layer_stride,
                                                    most_style_elements, "style.layers");
    for (std::int64_t i = 0; i < all_layers.count(); ++i) {
        keep_texts(layers.emplace_back(all_layers[i]));
    }
    if (given.palette_count < 0 || given.palette_count > frame::most_inks)
        fail(Status::invalid_argument, "style.palette_count is %lld; it must be from 0 to %lld",
             static_cast<long long>(given.palette_count), static_cast<long long>(frame::most_inks));
    if (given.palette_count > 0 && given.palette == nullptr) fail(Status::invalid_argument, "style.palette is NULL");
    for (std::int64_t i = 0; i < given.palette_count; ++i) {
        std::array<float, 4>& ink = palette.emplace_back();
        std::copy(given.palette + 4 * i, given.palette + 4 * i + 4, ink.begin());
    }
    const api::List<hrbfnpr_light> all_lights(given.lights, given.light_count, given.light_stride, most_style_elements,
                                              "style.lights");
    for (std::int64_t i = 0; i < all_lights.count(); ++i) lights.push_back(all_lights[i]);
    const api::List<hrbfnpr_line_style> all_lines(given.lines, given.line_count, given.line_stride, most_style_elements,
                                                  "style.lines");
    for (std::int64_t i = 0; i < all_lines.count(); ++i) {
        hrbfnpr_line_style& line = lines.emplace_back(all_lines[i]);
        if (line.name != nullptr) line.name = kept_.text(line.name);
        const base::InView levels = api::in_view(line.levels, "style.lines.levels", {1, 1U << HRBFNPR_SCALAR_FLOAT64});
        Vector<double> packed(pool_);
        for (std::int64_t level = 0; level < levels.count; ++level) packed.push_back(levels.get(level, 0));
        line.levels = packed.empty() ? hrbfnpr_array{} : kept_.numbers(packed.data(), packed.size());
    }
}

hrbfnpr_layer_style& Style::layer(std::uint32_t kind) {
    HRBFNPR_ASSERT(kind <= HRBFNPR_LAYER_KIND_OWN);
    for (auto place = layers.begin(); place != layers.end(); ++place) {
        if (place->name != nullptr) continue;
        if (place->kind == kind) return *place;
        if (place->kind == HRBFNPR_LAYER_KIND_ANY) {
            hrbfnpr_layer_style copy = *place;
            copy.kind = kind;
            return *layers.insert(place, copy);
        }
    }
    hrbfnpr_layer_style& added = layers.emplace_back(defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init));
    added.kind = kind;
    return added;
}

hrbfnpr_layer_style Style::style_of(std::uint32_t kind, const char* name) const noexcept {
    for (const hrbfnpr_layer_style& style : layers)
        if (style_is_for(style, kind, name)) return style;
    hrbfnpr_layer_style style = defaults<hrbfnpr_layer_style>(hrbfnpr_layer_style_init);
    style.kind = kind;
    return style;
}

void Style::set_ink(const float (&ink)[4]) {
    std::copy(ink, ink + 4, base.silhouette_ink);
    for (hrbfnpr_line_style& line : lines) std::copy(ink, ink + 4, line.ink);
    static_cast<void>(layer(HRBFNPR_LAYER_KIND_ANY));
    for (hrbfnpr_layer_style& style : layers) std::copy(ink, ink + 4, style.ink);
}

hrbfnpr_style Style::view() const noexcept {
    hrbfnpr_style style = base;
    style.layers = layers.data();
    style.layer_count = static_cast<std::int64_t>(layers.size());
    style.layer_stride = sizeof(hrbfnpr_layer_style);
    style.lines = lines.data();
    style.line_count = static_cast<std::int64_t>(lines.size());
    style.line_stride = sizeof(hrbfnpr_line_style);
    style.lights = lights.data();
    style.light_count = static_cast<std::int64_t>(lights.size());
    style.light_stride = sizeof(hrbfnpr_light);
    style.palette = palette.empty() ? nullptr : palette.front().data();
    style.palette_count = static_cast<std::int64_t>(palette.size());
    return style;
}

Marks::Marks(Pool& pool)
    : base(marks_without_list(defaults<hrbfnpr_generate_desc>(hrbfnpr_generate_desc_init))), layers(&pool),
      direction_field(&pool), dabs(&pool), pool_(&pool), kept_(pool) {}

Marks::Marks(const Marks& other, Pool& pool)
    : base(other.base), layers(other.layers, &pool), direction_field(other.direction_field, &pool),
      dabs(other.dabs, &pool), pool_(&pool), kept_(pool) {
    kept_.hold_all_of(other.kept_);
    for (hrbfnpr_layer_desc& layer : layers)
        if (layer.name != nullptr) layer.name = kept_.text(layer.name);
    set_seed_points(other.base.seed_points);
}

Marks& Marks::operator=(Marks other) noexcept {
    std::destroy_at(this);
    return *std::construct_at(this, std::move(other));
}

void Marks::set_seed_points(const hrbfnpr_array& points) {
    const base::InView view = api::in_view(points, "seed_points", api::points_type);
    Vector<double> packed(pool_);
    packed.reserve(3 * static_cast<std::size_t>(view.count));
    for (std::int64_t i = 0; i < view.count; ++i)
        for (std::uint32_t axis = 0; axis < 3; ++axis) packed.push_back(view.get(i, axis));
    base.seed_points = packed.empty() ? hrbfnpr_array{} : kept_.numbers(packed.data(), packed.size() / 3, 3);
}

hrbfnpr_generate_desc Marks::view() const noexcept {
    hrbfnpr_generate_desc desc = base;
    desc.layers = layers.data();
    desc.layer_count = static_cast<std::int64_t>(layers.size());
    desc.layer_stride = sizeof(hrbfnpr_layer_desc);
    return desc;
}

bool Marks::same_as(const Marks& other) const noexcept {
    return same_base(base, other.base) && direction_field == other.direction_field &&
           std::equal(dabs.begin(), dabs.end(), other.dabs.begin(), other.dabs.end(), same_dab) &&
           std::equal(layers.begin(), layers.end(), other.layers.begin(), other.layers.end(), same_layer);
}

} // namespace hrbfnpr::picture
