// SPDX-License-Identifier: MIT
#include "picture/mark_fields.h"

#include "api/views.h"
#include "base/assert.h"
#include "picture/field_table.h"
#include "picture/make.h"
#include "picture/palette.h"
#include "picture/report.h"

#include <algorithm>
#include <cmath>

namespace hrbfnpr::picture {
namespace {

// The texts of a layer's style that name fields, and the uses of these fields.
struct LayerUse {
    const char* hrbfnpr_layer_style::*name;
    FieldUse use;
};
constexpr LayerUse layer_uses[] = {LayerUse{&hrbfnpr_layer_style::density_field, FieldUse::number},
                                   LayerUse{&hrbfnpr_layer_style::tone_field, FieldUse::number},
                                   LayerUse{&hrbfnpr_layer_style::width_field, FieldUse::number},
                                   LayerUse{&hrbfnpr_layer_style::ink_field, FieldUse::colour},
                                   LayerUse{&hrbfnpr_layer_style::mask_field, FieldUse::number}};

bool paints_tone(const Options& options) noexcept {
    return std::any_of(options.dabs.begin(), options.dabs.end(),
                       [](const hrbfnpr_dab& dab) { return dab.map == HRBFNPR_DAB_TONE; });
}

// A field of marks.
struct NamedKind {
    const char* name;
    std::uint32_t kind;
};

Vector<NamedKind> fields_of_set(const PointSet& marks, Pool& pool) {
    auto info = defaults<hrbfnpr_point_set_info>(hrbfnpr_point_set_info_init);
    call([&](hrbfnpr_error* error) { return hrbfnpr_point_set_get_info(marks.get(), &info, error); });
    Vector<NamedKind> fields(&pool);
    for (std::int64_t i = 0; i < info.field_count; ++i) {
        NamedKind& field = fields.emplace_back();
        call([&](hrbfnpr_error* error) {
            return hrbfnpr_point_set_get_field(marks.get(), i, &field.name, &field.kind, error);
        });
    }
    return fields;
}

// Returns the name of a field of saved marks that a text means: the text itself, or the luminance of a colour.
const char* key_in_set(const Call& call, const PointSet& marks, std::string_view text, FieldUse use) {
    Pool& pool = call.pool;
    const Vector<NamedKind> fields = fields_of_set(marks, pool);
    const std::uint32_t kind = use == FieldUse::colour ? HRBFNPR_FIELD_KIND_COLOUR : HRBFNPR_FIELD_KIND_SCALAR;
    const auto find = [&](std::string_view name) -> const char* {
        for (const NamedKind& field : fields)
            if (field.kind == kind && name == field.name) return field.name;
        return nullptr;
    };
    if (const char* const same = find(text)) return same;
    if (const char* const luminance = find(String(luminance_prefix, &pool) += text)) return luminance;
    Vector<std::string_view> names(&pool);
    for (const NamedKind& field : fields)
        if (field.kind == kind) names.emplace_back(field.name);
    const String wanted = short_name(text, pool);
    if (names.empty())
        call.report.refuse(formatted(pool, "{field} names %s, but the marks have no %s", wanted.c_str(),
                                     use == FieldUse::colour ? "colours" : "values"));
    constexpr std::size_t room_for_names = 150;
    call.report.refuse(formatted(pool, "{field} names %s, which the marks do not have; they have %s", wanted.c_str(),
                                 listed_names(names, text, room_for_names, pool).c_str()));
}

// Returns a field that says nothing anywhere. Marks get it if their source lacks values that another source has.
Field empty_field(const Call& call, FieldUse use) {
    auto desc = defaults<hrbfnpr_field_desc>(hrbfnpr_field_desc_init);
    desc.kind = use == FieldUse::colour ? HRBFNPR_FIELD_KIND_COLOUR : HRBFNPR_FIELD_KIND_SCALAR;
    desc.source = HRBFNPR_FIELD_SOURCE_DABS;
    return make<Field>([&](hrbfnpr_field** made, hrbfnpr_error* error) {
        return hrbfnpr_field_create(&call.context, &desc, nullptr, made, error);
    });
}

} // namespace

bool uses_fields(const Options& options, const Style& style) noexcept {
    if (paints_tone(options)) return true;
    return std::any_of(style.layers.begin(), style.layers.end(), [](const hrbfnpr_layer_style& layer) {
        return std::any_of(std::begin(layer_uses), std::end(layer_uses),
                           [&](const LayerUse& use) { return layer.*(use.name) != nullptr; });
    });
}

MarkFields::MarkFields(const Call& call, const Style& style, const SourceFields& sources, const PointSet& given)
    : sources_(sources), given_(given), tones_(field_of_dabs(call, HRBFNPR_DAB_TONE)), wanted_(&call.pool),
      painted_(&call.pool), layers_(style.layers, &call.pool), texts_(call.pool) {
    for (hrbfnpr_layer_style& layer : layers_) {
        if (layer.name != nullptr) layer.name = texts_.text(layer.name);
        for (const LayerUse& use : layer_uses) layer.*(use.name) = key_of(call, layer.*(use.name), use.use);
        if (tones_) layer.tone_field = painted_key_of(call, layer, layer.tone_field);
        if (tones_) layer.tone_field_rule = HRBFNPR_FIELD_RULE_REPLACE;
    }
}

// Returns the name that marks have for a field that a style names. It is null if the style names none.
const char* MarkFields::key_of(const Call& call, const char* name, FieldUse use) {
    if (name == nullptr) return nullptr;
    if (given_) return texts_.text(key_in_set(call, given_, name, use));
    WantedField found = sources_.find(call, name, use);
    const char* const key = texts_.text(found.key);
    const auto is_same = [&](const WantedField& other) { return other.key == found.key && other.use == found.use; };
    if (std::none_of(wanted_.begin(), wanted_.end(), is_same)) wanted_.push_back(std::move(found));
    return key;
}

// Returns the name of the painted tones over the field that marks know by the name `below`, which may be null.
const char* MarkFields::painted_key_of(const Call& call, const hrbfnpr_layer_style& layer, const char* below) {
    if (below != nullptr && (given_ || layer.tone_field_rule != HRBFNPR_FIELD_RULE_REPLACE))
        call.report.refuse(formatted(call.pool, "dabs of tone cannot be painted over the tone field %s, because %s",
                                     short_name(below, call.pool).c_str(),
                                     given_ ? "it belongs to saved marks" : "its rule is not REPLACE"));
    std::int64_t number = -1;
    for (std::size_t i = 0; below != nullptr && i < wanted_.size(); ++i)
        if (wanted_[i].key == below && wanted_[i].use == FieldUse::number) number = static_cast<std::int64_t>(i);
    for (const PaintedTone& painted : painted_)
        if (painted.below == number) return painted.key;
    const String key = number < 0 ? String("paint.tone", &call.pool)
                                  : formatted(call.pool, "paint.tone %lld", static_cast<long long>(number + 1));
    painted_.push_back({number, texts_.text(key)});
    return painted_.back().key;
}

PointSet MarkFields::with_fields(const Call& call, const PointSet& marks, std::size_t source,
                                 hrbfnpr_operation* operation) const {
    if (wanted_.empty() && painted_.empty()) return marks;
    Vector<Field> fields(&call.pool);
    Vector<std::shared_ptr<const HeldField>> over(&call.pool);
    Vector<hrbfnpr_mark_field> list(&call.pool);
    const auto add = [&](const char* name, const Field& field) {
        auto& one = list.emplace_back(defaults<hrbfnpr_mark_field>(hrbfnpr_mark_field_init));
        one.name = name;
        one.field = field.get();
    };
    for (const WantedField& wanted : wanted_) {
        Field made = sources_.make_field(call, wanted, source);
        fields.push_back(made ? std::move(made) : empty_field(call, wanted.use));
        add(wanted.key.c_str(), fields.back());
    }
    for (const PaintedTone& painted : painted_) {
        if (painted.below < 0) {
            add(painted.key, tones_);
            continue;
        }
        over.push_back(numbers_over(call, fields[static_cast<std::size_t>(painted.below)], tones_));
        add(painted.key, over.back()->field);
    }
    return make<PointSet>([&](hrbfnpr_point_set** made, hrbfnpr_error* error) {
        return hrbfnpr_point_set_with_fields(&call.context, marks.get(), list.data(),
                                             static_cast<std::int64_t>(list.size()), sizeof(hrbfnpr_mark_field),
                                             operation, made, error);
    });
}

void choose_palette(const Call& call_, const Vector<hrbfnpr_layer_style>& layers, const Vector<PointSet>& marks,
                    Style& style) {
    if (!style.palette.empty()) return;
    Pool& pool = call_.pool;
    Vector<std::array<float, 3>> colours(&pool);
    for (const hrbfnpr_layer_style& layer : layers) {
        if (layer.ink_field == nullptr) continue;
        for (const PointSet& set : marks) add_colours(set, layer.ink_field, colours);
    }
    if (colours.empty()) return;
    style.palette = inks_of(colours, pool);
    String names(&pool);
    for (const std::array<float, 4>& ink : style.palette) {
        if (!names.empty()) names += ',';
        names += '#';
        for (std::size_t i = 0; i < 3; ++i)
            names += formatted(pool, "%02x", static_cast<unsigned>(std::lround(255.0F * ink[i])));
    }
    call_.report.note(HRBFNPR_NOTE_PALETTE_CHOSEN, {static_cast<double>(style.palette.size())},
                      formatted(pool, "inks chosen from the colours: {palette=%s}", names.c_str()));
}

} // namespace hrbfnpr::picture
