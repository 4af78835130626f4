// SPDX-License-Identifier: MIT
#include "picture/source_fields.h"

#include "api/fields.h"
#include "api/lists.h"
#include "api/views.h"
#include "base/assert.h"
#include "base/utf8.h"
#include "picture/field_table.h"
#include "picture/make.h"
#include "picture/report.h"
#include "picture/tuning_plan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <iterator>

namespace hrbfnpr::api {

template <>
hrbfnpr_source_field defaults() noexcept {
    return {};
}

} // namespace hrbfnpr::api

namespace hrbfnpr::picture {
namespace {

constexpr std::int64_t most_source_fields = 1000;
constexpr std::size_t longest_field_name = 63;
constexpr unsigned value_types = api::float_types | api::uint8_only;

// ---- Reading

String read_field_name(const char* name, const char* owner, Pool& pool) {
    api::Checks(owner).not_null("name", name != nullptr);
    const std::size_t size = strnlen(name, longest_field_name + 1);
    if (size == 0 || size > longest_field_name || !base::is_utf8({name, size}))
        fail(Status::invalid_argument, "%s.name must be UTF-8 of 1 to %zu bytes", owner, longest_field_name);
    return {name, size, &pool};
}

SourceField read_source_field(const hrbfnpr_source_field& given, std::size_t points, const char* owner, Pool& pool) {
    api::Checks(owner).one_of("kind", given.kind, HRBFNPR_FIELD_KIND_DIRECTION + 1, "HRBFNPR_FIELD_KIND_*");
    SourceField field{read_field_name(given.name, owner, pool), given.kind, Vector<float>(&pool)};
    char name[128];
    std::snprintf(name, sizeof name, "%.110s.values", owner);
    const auto components = static_cast<std::uint32_t>(field.components());
    if (given.values.count > 0 && given.values.components != components)
        fail(Status::invalid_argument, "%s.kind is %u, which needs %u components; values.components is %u", owner,
             given.kind, components, given.values.components);
    const base::InView view = api::in_view(given.values, name, {components, value_types});
    if (view.count != static_cast<std::int64_t>(points))
        fail(Status::invalid_argument, "%s has %lld elements and there are %zu points; give one for each", name,
             static_cast<long long>(view.count), points);
    const bool is_byte_colour = field.kind == HRBFNPR_FIELD_KIND_COLOUR && view.scalar == base::Scalar::uint8;
    const double scale = is_byte_colour ? 1.0 / 255.0 : 1.0;
    field.values.reserve(points * components);
    for (std::int64_t i = 0; i < view.count; ++i)
        for (std::uint32_t k = 0; k < components; ++k)
            field.values.push_back(static_cast<float>(scale * view.get(i, k)));
    return field;
}

// ---- Names

bool is_colour_name(std::string_view name) noexcept {
    return same_name(name, "colour") || same_name(name, "color") || same_name(name, "colours") ||
           same_name(name, "colors");
}

// Parses "LOW..HIGH".
std::optional<std::array<double, 2>> parse_range(std::string_view text) noexcept {
    const std::size_t dots = text.find("..");
    if (dots == std::string_view::npos) return std::nullopt;
    // If there are three dots in a row, the third one belongs to the second number.
    const std::optional<double> low = parse_number(text.substr(0, dots));
    const std::optional<double> high = parse_number(text.substr(dots + 2));
    if (!low || !high || *low == *high) return std::nullopt;
    return std::array{*low, *high};
}

// ---- Values

bool has_place(const glm::dvec3& point) noexcept {
    return std::isfinite(point.x) && std::isfinite(point.y) && std::isfinite(point.z);
}

bool has_value(const SourceField& field, std::size_t point) noexcept {
    const std::size_t components = field.components();
    const float* const first = field.values.data() + point * components;
    return std::all_of(first, first + components, [](float number) { return std::isfinite(number); });
}

// The arrays of a field: only points with values, and triangles of such points.
struct FieldArrays {
    explicit FieldArrays(Pool& pool) : points(&pool), triangles(&pool), values(&pool) {}

    Points points;
    Vector<std::array<std::uint32_t, 3>> triangles;
    Vector<float> values;
};

FieldArrays arrays_of(const SourceValues& source, const SourceField& field, bool is_luminance, Pool& pool) {
    FieldArrays arrays(pool);
    Vector<std::int64_t> number(source.points.size(), -1, &pool); // for each point: its new number, or -1
    const std::size_t components = field.components();
    for (std::size_t i = 0; i < source.points.size(); ++i) {
        if (!has_place(source.points[i]) || !has_value(field, i)) continue;
        number[i] = static_cast<std::int64_t>(arrays.points.size());
        arrays.points.push_back(source.points[i]);
        const float* const value = field.values.data() + i * components;
        if (is_luminance)
            arrays.values.push_back(0.2126F * value[0] + 0.7152F * value[1] + 0.0722F * value[2]);
        else
            arrays.values.insert(arrays.values.end(), value, value + components);
    }
    for (const std::array<std::uint32_t, 3>& triangle : source.triangles) {
        std::array<std::uint32_t, 3> corners{};
        bool is_whole = true;
        for (std::size_t k = 0; k < 3; ++k) {
            is_whole = is_whole && number[triangle[k]] >= 0;
            corners[k] = static_cast<std::uint32_t>(std::max<std::int64_t>(number[triangle[k]], 0));
        }
        if (is_whole) arrays.triangles.push_back(corners);
    }
    return arrays;
}

hrbfnpr_array floats_view(const Vector<float>& values, std::size_t components) noexcept {
    return {values.data(), static_cast<std::int64_t>(values.size() / components), 0, HRBFNPR_SCALAR_FLOAT32,
            static_cast<std::uint32_t>(components)};
}

std::uint32_t kind_of_use(FieldUse use) noexcept {
    return use == FieldUse::number   ? HRBFNPR_FIELD_KIND_SCALAR
           : use == FieldUse::colour ? HRBFNPR_FIELD_KIND_COLOUR
                                     : HRBFNPR_FIELD_KIND_DIRECTION;
}

} // namespace

SourceValues read_source_values(const hrbfnpr_picture_source& given, const Shape& shape, const char* owner,
                                Pool& pool) {
    SourceValues read(pool);
    char name[96];
    std::snprintf(name, sizeof name, "%.80s.fields", owner);
    const api::List<hrbfnpr_source_field> list(given.fields, given.field_count, given.field_stride, most_source_fields,
                                               name);
    if (list.count() == 0) return read;
    for (std::int64_t i = 0; i < list.count(); ++i) {
        SourceField field = read_source_field(list[i], shape.points.size(), list.name(i).text, pool);
        const auto has_name = [&](const SourceField& other) { return other.name == field.name; };
        if (std::any_of(read.fields.begin(), read.fields.end(), has_name))
            fail(Status::invalid_argument, "%s.name is \"%s\", as that of another field", list.name(i).text,
                 field.name.c_str());
        read.fields.push_back(std::move(field));
    }
    read.points = shape.points;
    read.triangles.reserve(shape.triangles.size());
    for (const Triangle& triangle : shape.triangles)
        read.triangles.push_back({static_cast<std::uint32_t>(triangle[0]), static_cast<std::uint32_t>(triangle[1]),
                                  static_cast<std::uint32_t>(triangle[2])});
    return read;
}

FieldSpec field_spec_of(std::string_view text) noexcept {
    FieldSpec spec{text};
    if (text.size() > 1 && text.front() == '-') {
        spec.is_reversed = true;
        spec.name.remove_prefix(1);
    }
    const std::size_t colon = spec.name.rfind(':');
    if (colon == std::string_view::npos || colon == 0) return spec;
    spec.range = parse_range(spec.name.substr(colon + 1));
    if (spec.range) spec.name = spec.name.substr(0, colon);
    return spec;
}

bool SourceFields::empty() const noexcept {
    return std::all_of(sources_.begin(), sources_.end(), [](const SourceValues& one) { return one.fields.empty(); });
}

const SourceField* SourceFields::find_in(std::size_t source, std::string_view name) const noexcept {
    HRBFNPR_ASSERT(source < sources_.size());
    const Vector<SourceField>& fields = sources_[source].fields;
    const auto first = [&](auto&& is_wanted) -> const SourceField* {
        const auto found = std::find_if(fields.begin(), fields.end(), is_wanted);
        return found != fields.end() ? &*found : nullptr;
    };
    if (const SourceField* const same = first([&](const SourceField& one) { return one.name == name; })) return same;
    if (const SourceField* const like = first([&](const SourceField& one) { return same_name(one.name, name); }))
        return like;
    if (!is_colour_name(name)) return nullptr;
    return first([](const SourceField& one) { return one.kind == HRBFNPR_FIELD_KIND_COLOUR; });
}

const SourceField* SourceFields::find_any(std::string_view name) const noexcept {
    for (std::size_t source = 0; source < sources_.size(); ++source)
        if (const SourceField* const found = find_in(source, name)) return found;
    return nullptr;
}

// Returns the least and the greatest number of that name in all sources, without outliers. Both are 0 if they do not
// differ.
std::array<double, 2> SourceFields::range_of(std::string_view name, Pool& pool) const {
    Vector<float> numbers(&pool);
    for (std::size_t source = 0; source < sources_.size(); ++source) {
        const SourceField* const field = find_in(source, name);
        if (field == nullptr || field->kind != HRBFNPR_FIELD_KIND_SCALAR) continue;
        std::copy_if(field->values.begin(), field->values.end(), std::back_inserter(numbers),
                     [](float value) { return std::isfinite(value); });
    }
    if (numbers.empty()) return {};
    const auto outer = static_cast<std::size_t>(range_tuning.outer_share * static_cast<double>(numbers.size()));
    const auto number_at = [&](std::size_t place) {
        const auto at = numbers.begin() + static_cast<std::ptrdiff_t>(place);
        std::nth_element(numbers.begin(), at, numbers.end());
        return static_cast<double>(*at);
    };
    const double low = number_at(outer), high = number_at(numbers.size() - 1 - outer);
    // If most numbers are the same, the others are no outliers.
    const double reach = low < high ? range_tuning.reach * (high - low) : HUGE_VAL;
    std::array<double, 2> range{high, low};
    for (const double number : numbers) {
        if (number < low - reach || number > high + reach) continue;
        range[0] = std::min(range[0], number);
        range[1] = std::max(range[1], number);
    }
    return range[0] < range[1] ? range : std::array{0.0, 0.0};
}

void SourceFields::refuse_name(const Call& call, std::string_view text) const {
    Pool& pool = call.pool;
    const String name = short_name(text, pool);
    if (empty())
        call.report.refuse(
            formatted(pool, "{field} names %s, but the source has no values at its points", name.c_str()));
    Vector<std::string_view> names(&pool);
    for (const SourceValues& source : sources_)
        for (const SourceField& field : source.fields)
            if (std::find(names.begin(), names.end(), field.name) == names.end()) names.emplace_back(field.name);
    constexpr std::size_t room_for_names = 150;
    call.report.refuse(formatted(pool, "{field} names %s, which the source does not have; it has %s", name.c_str(),
                                 listed_names(names, text, room_for_names, pool).c_str()));
}

WantedField SourceFields::find(const Call& call, std::string_view text, FieldUse use) const {
    Pool& pool = call.pool;
    FieldSpec spec{text};
    const SourceField* found = find_any(text); // A name may have a colon.
    if (found == nullptr) {
        spec = field_spec_of(text);
        found = find_any(spec.name);
    }
    if (found == nullptr) refuse_name(call, text);
    const bool is_number = found->kind == HRBFNPR_FIELD_KIND_SCALAR;
    const bool is_luminance = use == FieldUse::number && found->kind == HRBFNPR_FIELD_KIND_COLOUR;
    const String name = short_name(spec.name, pool);
    constexpr const char* kinds[] = {"numbers", "colours", "directions"};
    if (kind_of_use(use) != found->kind && !is_luminance)
        call.report.refuse(formatted(pool, "{field} names %s, which holds %s; this use needs %s", name.c_str(),
                                     kinds[found->kind], kinds[kind_of_use(use)]));
    if (use != FieldUse::number && (spec.range || spec.is_reversed))
        call.report.refuse(formatted(pool, "{field} gives %s a range, but it does not hold numbers", name.c_str()));
    WantedField wanted{found->name, use, is_luminance, {}, String(&pool)};
    wanted.range = spec.range ? *spec.range : is_number ? range_of(found->name, pool) : std::array{0.0, 0.0};
    if (spec.is_reversed) {
        if (wanted.range == std::array{0.0, 0.0} && is_luminance) wanted.range = {0.0, 1.0};
        std::swap(wanted.range[0], wanted.range[1]);
    }
    if (is_luminance) wanted.key += luminance_prefix;
    wanted.key += text;
    if (wanted.key.size() > longest_field_name)
        call.report.refuse(formatted(pool, "{field} names %s, which with its range has more than %zu bytes",
                                     name.c_str(), longest_field_name));
    return wanted;
}

Field SourceFields::make_field(const Call& call, const WantedField& wanted, std::size_t source) const {
    const SourceField* const field = find_in(source, wanted.name);
    if (field == nullptr) return {};
    const std::scoped_lock lock(making_);
    for (const Made& made : made_)
        if (made.source == source && made.key == wanted.key) return made.field;
    const FieldArrays arrays = arrays_of(sources_[source], *field, wanted.is_luminance, call.pool);
    if (arrays.points.empty() || (arrays.triangles.empty() && !sources_[source].triangles.empty())) return {};
    auto desc = defaults<hrbfnpr_field_desc>(hrbfnpr_field_desc_init);
    desc.kind = kind_of_use(wanted.use);
    desc.range[0] = wanted.range[0];
    desc.range[1] = wanted.range[1];
    desc.points = view_of(arrays.points);
    desc.triangles = {arrays.triangles.data(), static_cast<std::int64_t>(arrays.triangles.size()), 0,
                      HRBFNPR_SCALAR_UINT32, 3};
    desc.values = floats_view(arrays.values, wanted.use == FieldUse::number ? 1 : 3);
    Field made = make<Field>([&](hrbfnpr_field** out, hrbfnpr_error* error) {
        return hrbfnpr_field_create(&call.context, &desc, nullptr, out, error);
    });
    made_.push_back({source, String(wanted.key, pool_), made});
    return made;
}

} // namespace hrbfnpr::picture

extern "C" {

hrbfnpr_status hrbfnpr_source_field_init(hrbfnpr_source_field* field, uint32_t struct_size) {
    return hrbfnpr::api::init_struct(field, struct_size);
}

} // extern "C"
