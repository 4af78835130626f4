// SPDX-License-Identifier: MIT
#include "base/utf8.h"
#include "io/check.h"
#include "io/decoder.h"
#include "io/encoder.h"
#include "io/files.h"
#include "marks/fields.h"
#include "marks/site.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <string_view>
#include <utility>

namespace hrbfnpr::io {
namespace {

constexpr std::uint32_t tag_set_kind = tag("KIND");
constexpr std::uint32_t tag_set_numbers = tag("NUMB");
constexpr std::uint32_t tag_seeds = tag("SEED");
constexpr std::uint32_t tag_layer = tag("LAYR");
constexpr std::uint32_t tag_name = tag("NAME");
constexpr std::uint32_t tag_layer_counts = tag("LCNT");
constexpr std::uint32_t tag_layer_numbers = tag("LNUM");
constexpr std::uint32_t tag_placement = tag("PLAC");
constexpr std::uint32_t tag_stroke_first = tag("SFST");
constexpr std::uint32_t tag_stroke_order = tag("SORD");
constexpr std::uint32_t tag_tone_normal = tag("TNRM");
constexpr std::uint32_t tag_rank = tag("RANK");
constexpr std::uint32_t tag_position = tag("POSI");
constexpr std::uint32_t tag_normal = tag("NORM");
constexpr std::uint32_t tag_direction = tag("DIRE");
constexpr std::uint32_t tag_curvature = tag("CURV");
constexpr std::uint32_t tag_level = tag("LEVL");
constexpr std::uint32_t tag_stroke = tag("STRK");
constexpr std::uint32_t tag_width = tag("WIDT");
constexpr std::uint32_t tag_field_count = tag("FCNT");
constexpr std::uint32_t tag_field_name = tag("FNAM");
constexpr std::uint32_t tag_field_kind = tag("FKND");
constexpr std::uint32_t tag_field_values = tag("FVAL");
constexpr std::uint32_t tag_field_weights = tag("FWEI");

// The number of counts in a LevelReport.
constexpr std::size_t level_numbers = 6;

constexpr std::int64_t most_level = 255; // the highest level of a mark

using SetNumbers = std::array<double, 12>;
using LevelNumbers = std::array<std::int64_t, level_numbers>;

SetNumbers numbers_of(const marks::PointSet& set) noexcept {
    const auto& [low, high] = set.bounds;
    return {set.origin.x, set.origin.y,      set.origin.z,     low.x, low.y, low.z, high.x, high.y, high.z,
            set.spacing,  set.seconds_seeds, set.seconds_total};
}

void set_numbers(marks::PointSet& set, const SetNumbers& n) noexcept {
    set.origin = {n[0], n[1], n[2]};
    set.bounds = {{n[3], n[4], n[5]}, {n[6], n[7], n[8]}};
    set.spacing = n[9];
    set.seconds_seeds = n[10];
    set.seconds_total = n[11];
}

marks::LevelReport level_of(const std::int64_t* n) noexcept { return {n[0], n[1], n[2], n[3], n[4], n[5]}; }

LevelNumbers numbers_of(const marks::LevelReport& level) noexcept {
    return {level.attempted,          level.placed,        level.dropped_not_converged, level.dropped_strayed,
            level.dropped_degenerate, level.dropped_budget};
}

void encode_layer(Encoder& encoder, const marks::Layer& layer) {
    encoder.section<std::uint32_t>(tag_layer,
                                   std::array{static_cast<std::uint32_t>(layer.kind), layer.progressive ? 1U : 0U});
    const auto* const name = reinterpret_cast<const std::uint8_t*>(layer.name.data());
    encoder.section(tag_name, std::span(name, std::strlen(layer.name.data())));
    encoder.section<std::int64_t>(tag_layer_counts,
                                  std::array{layer.report.full_count, std::int64_t{layer.report.levels}});
    encoder.section<double>(tag_layer_numbers, std::array{layer.report.step, layer.report.seconds});
    base::Array<std::int64_t> placement(layer.rank.memory());
    for (const marks::LevelReport& level : layer.report.level)
        for (const std::int64_t number : numbers_of(level)) placement.push_back(number);
    encoder.section(tag_placement, std::as_const(placement).span());
    encoder.section(tag_rank, layer.rank.span());
    encoder.section(tag_position, layer.position.span());
    encoder.section(tag_normal, layer.normal.span());
    encoder.section(tag_direction, layer.direction.span());
    encoder.section(tag_curvature, layer.curvature.span());
    encoder.section(tag_level, layer.level.span());
    encoder.section(tag_stroke, layer.stroke.span());
    encoder.section(tag_width, layer.width.span());
    encoder.section(tag_stroke_first, layer.stroke_first.span());
    encoder.section(tag_stroke_order, layer.stroke_order.span());
}

void encode_fields(Encoder& encoder, const marks::Layer& layer) {
    encoder.section<std::uint32_t>(tag_field_count, std::array{static_cast<std::uint32_t>(layer.fields.size())});
    for (const marks::MarkField& field : layer.fields) {
        const auto* const name = reinterpret_cast<const std::uint8_t*>(field.name.data());
        encoder.section(tag_field_name, std::span(name, std::strlen(field.name.data())));
        encoder.section<std::uint32_t>(tag_field_kind, std::array{static_cast<std::uint32_t>(field.kind)});
        encoder.section(tag_field_values, field.value.span());
        encoder.section(tag_field_weights, field.weight.span());
    }
}

void encode(Encoder& encoder, const marks::PointSet& set) {
    const std::array<std::uint32_t, 3> kind{static_cast<std::uint32_t>(set.distribution),
                                            static_cast<std::uint32_t>(set.seed_source),
                                            static_cast<std::uint32_t>(set.layers.size())};
    encoder.section<std::uint32_t>(tag_set_kind, kind);
    encoder.section<double>(tag_set_numbers, numbers_of(set));
    encoder.section<std::int64_t>(tag_seeds, numbers_of(set.seeds));
    for (const marks::Layer& layer : set.layers) encode_layer(encoder, layer);
    const bool has_fields = marks::field_count(set) > 0;
    if (has_fields || std::any_of(set.layers.begin(), set.layers.end(),
                                  [](const marks::Layer& layer) { return !layer.tone_normal.empty(); }))
        for (const marks::Layer& layer : set.layers) encoder.section(tag_tone_normal, layer.tone_normal.span());
    if (has_fields)
        for (const marks::Layer& layer : set.layers) encode_fields(encoder, layer);
}

// Reads the kind of the set and returns the number of layers.
std::uint32_t decode_kind(Decoder& decoder, marks::PointSet& set) {
    std::array<std::uint32_t, 3> kind{};
    decoder.section<std::uint32_t>(tag_set_kind, kind);
    if (kind[0] > static_cast<std::uint32_t>(marks::Distribution::published))
        decoder.damaged("its distribution is unknown");
    if (kind[1] > static_cast<std::uint32_t>(marks::SeedSource::points)) decoder.damaged("its seed source is unknown");
    if (kind[2] > marks::most_layers) decoder.damaged("it has %u layers, too many", kind[2]);
    set.distribution = static_cast<marks::Distribution>(kind[0]);
    set.seed_source = static_cast<marks::SeedSource>(kind[1]);
    return kind[2];
}

// Reads the name of a layer or of a field, which is `what` in messages.
marks::LayerName decode_name(Decoder& decoder, std::uint32_t tag_of_name, base::Memory& memory, const char* what) {
    base::Array<std::uint8_t> bytes(memory);
    decoder.section(tag_of_name, bytes);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), static_cast<std::size_t>(bytes.size()));
    marks::LayerName name{};
    if (text.empty() || text.size() >= name.size() || !base::is_utf8(text) || text.find('\0') != text.npos)
        decoder.damaged("the name of a %s is not 1 to 63 bytes of UTF-8", what);
    std::memcpy(name.data(), text.data(), text.size());
    return name;
}

void decode_report(Decoder& decoder, marks::LayerReport& report) {
    std::array<std::int64_t, 2> counts{};
    std::array<double, 2> numbers{};
    base::Array<std::int64_t> placement(report.level.memory());
    decoder.section<std::int64_t>(tag_layer_counts, counts);
    decoder.section<double>(tag_layer_numbers, numbers);
    decoder.section(tag_placement, placement);
    if (counts[0] < 0 || counts[1] < 0 || counts[1] > most_level) decoder.damaged("a count of a layer is out of range");
    if (placement.size() % std::int64_t{level_numbers} != 0 ||
        placement.size() > (most_level + 1) * std::int64_t{level_numbers})
        decoder.damaged("a layer does not have six counts for each of at most 256 levels");
    for (const std::int64_t count : placement)
        if (count < 0) decoder.damaged("a count of a level is negative");
    check_finite<double>(decoder, "layer", numbers);
    if (numbers[0] < 0.0 || numbers[1] < 0.0) decoder.damaged("a step or time of a layer is negative");
    report.full_count = counts[0];
    report.levels = static_cast<std::int32_t>(counts[1]);
    report.step = numbers[0];
    report.seconds = numbers[1];
    for (std::int64_t i = 0; i < placement.size(); i += std::int64_t{level_numbers})
        report.level.push_back(level_of(placement.data() + i));
}

void decode_marks(Decoder& decoder, marks::Layer& layer) {
    decoder.section(tag_rank, layer.rank);
    const std::int64_t count = layer.rank.size();
    if (count > marks::most_marks) decoder.damaged("a layer has too many marks");
    decoder.section(tag_position, layer.position, 3 * count);
    decoder.section(tag_normal, layer.normal, 3 * count);
    decoder.section(tag_direction, layer.direction, 3 * count);
    decoder.section(tag_curvature, layer.curvature);
    if (!layer.curvature.empty() && layer.curvature.size() != 3 * count)
        decoder.damaged("a layer does not have one curvature for each mark");
    decoder.section(tag_level, layer.level, count);
    decoder.section(tag_stroke, layer.stroke, 2 * count);
}

void decode_width(Decoder& decoder, marks::Layer& layer) {
    decoder.section(tag_width, layer.width);
    if (!layer.width.empty() && layer.width.size() != layer.count())
        decoder.damaged("a layer does not have one width for each mark");
}

void decode_layer(Decoder& decoder, marks::PointSet& set) {
    std::array<std::uint32_t, 2> kind{};
    decoder.section<std::uint32_t>(tag_layer, kind);
    if (kind[0] == 0 || kind[0] >= marks::kind_count) decoder.damaged("the kind of a layer is unknown");
    if (kind[1] > 1) decoder.damaged("the order of a layer is unknown");
    marks::Layer& layer = set.layers.add(set.layers.memory(), static_cast<marks::Kind>(kind[0]));
    layer.progressive = kind[1] == 1;
    layer.name = decode_name(decoder, tag_name, layer.rank.memory(), "layer");
    decode_report(decoder, layer.report);
    decode_marks(decoder, layer);
    decode_width(decoder, layer);
    decoder.section(tag_stroke_first, layer.stroke_first);
    decoder.section(tag_stroke_order, layer.stroke_order);
}

// Reads the normals for tone if the file has them.
void decode_tone_normals(Decoder& decoder, marks::PointSet& set) {
    if (!decoder.has_more()) return;
    for (marks::Layer& layer : set.layers) {
        decoder.section(tag_tone_normal, layer.tone_normal);
        if (!layer.tone_normal.empty() && layer.tone_normal.size() != layer.normal.size())
            decoder.damaged("a layer does not have one normal for tone for each mark");
    }
}

void decode_field(Decoder& decoder, marks::Layer& layer) {
    base::Memory& memory = layer.rank.memory();
    marks::MarkField field(memory);
    field.name = decode_name(decoder, tag_field_name, memory, "field");
    if (layer.field_of(field.name.data()) != nullptr) decoder.damaged("two fields of a layer have the same name");
    std::array<std::uint32_t, 1> kind{};
    decoder.section<std::uint32_t>(tag_field_kind, kind);
    if (kind[0] >= paint::field_kind_count) decoder.damaged("the kind of a field is unknown");
    field.kind = static_cast<marks::FieldKind>(kind[0]);
    decoder.section(tag_field_values, field.value, marks::components_of(field.kind) * layer.count());
    decoder.section(tag_field_weights, field.weight);
    if (!field.weight.empty() && field.weight.size() != layer.count())
        decoder.damaged("a field does not have one weight for each mark");
    check_finite(decoder, "value of a field", std::as_const(field.value).span());
    for (const float weight : field.weight.span())
        if (!(weight >= 0.0F && weight <= 1.0F)) decoder.damaged("a weight of a field is outside [0, 1]");
    layer.fields.add(std::move(field));
}

// Reads the fields if the file has them.
void decode_fields(Decoder& decoder, marks::PointSet& set) {
    if (decoder.version() <= fieldless_version) return;
    for (marks::Layer& layer : set.layers) {
        std::array<std::uint32_t, 1> count{};
        decoder.section<std::uint32_t>(tag_field_count, count);
        if (count[0] > marks::most_fields) decoder.damaged("a layer has %u fields, too many", count[0]);
        for (std::uint32_t i = 0; i < count[0]; ++i) decode_field(decoder, layer);
        for (const marks::MarkField& field : layer.fields)
            if (marks::field_of(set, field.name.data())->kind != field.kind)
                decoder.damaged("a field has different kinds in two layers");
    }
    if (marks::field_count(set) > marks::most_fields) decoder.damaged("it has too many fields");
}

void decode_layers(Decoder& decoder, std::uint32_t count, marks::PointSet& set) {
    for (std::uint32_t layer = 0; layer < count; ++layer) decode_layer(decoder, set);
    decode_tone_normals(decoder, set);
    decode_fields(decoder, set);
}

// Checks that the order contains each mark once, and that strokes are sorted by their numbers, as searches require.
void check_order(const Decoder& decoder, const marks::Layer& layer) {
    const std::int64_t count = layer.count();
    if (layer.stroke_order.size() != count)
        decoder.damaged("a layer's order of strokes does not have one element for each mark");
    base::Array<std::uint8_t> seen(layer.rank.memory(), count);
    for (const std::uint32_t mark : layer.stroke_order) {
        if (mark >= count || seen[mark] != 0)
            decoder.damaged("the order of strokes has a mark twice, or one that does not exist");
        seen[mark] = 1;
    }
    for (std::int64_t s = 1; s < layer.strokes(); ++s)
        if (layer.stroke[2 * layer.mark_of(layer.stroke_first[s])] <=
            layer.stroke[2 * layer.mark_of(layer.stroke_first[s - 1])])
            decoder.damaged("the strokes are not in the order of their numbers");
}

void check_strokes(const Decoder& decoder, const marks::Layer& layer) {
    const base::Array<std::uint32_t>& first = layer.stroke_first;
    if (first.empty()) {
        if (!layer.stroke_order.empty()) decoder.damaged("a layer has an order of strokes, but no strokes");
        return;
    }
    const std::int64_t last = first.size() - 1;
    bool rises = last > 0 && first[0] == 0 && first[last] == layer.count();
    for (std::int64_t s = 0; s < last; ++s) rises = rises && first[s] < first[s + 1];
    if (!rises) decoder.damaged("the starts of a layer's strokes do not increase from 0 to its number of marks");
    if (!layer.stroke_order.empty()) check_order(decoder, layer);
    for (std::int64_t s = 0; s < last; ++s)
        for (std::uint32_t place = first[s]; place < first[s + 1]; ++place)
            if (layer.stroke[2 * layer.mark_of(place)] != layer.stroke[2 * layer.mark_of(first[s])])
                decoder.damaged("the marks of one stroke have different numbers");
}

void check_layer(const Decoder& decoder, const marks::Layer& layer) {
    check_finite(decoder, "position", layer.position.span());
    check_unit(decoder, "normal", layer.normal.span());
    check_unit(decoder, "normal for tone", layer.tone_normal.span());
    check_finite(decoder, "direction", layer.direction.span());
    for (std::int64_t i = 0; i < layer.count(); ++i)
        if (const glm::vec3 d = marks::vector_at(layer.direction, i); !(glm::dot(d, d) < 1.02F))
            decoder.damaged("direction[%lld] is longer than a unit vector", static_cast<long long>(i));
    check_finite(decoder, "curvature", layer.curvature.span());
    for (const float rank : layer.rank.span())
        if (!(rank >= 0.0F && rank < 1.0F)) decoder.damaged("a rank is outside [0, 1)");
    for (const float width : layer.width.span())
        if (!(width > 0.0F && width <= 1.0F)) decoder.damaged("a width is outside (0, 1]");
    check_strokes(decoder, layer);
}

// Checks that all marks are inside the bounds up to rounding. Positions are floats relative to the origin.
void check_places(const Decoder& decoder, const marks::PointSet& set) {
    constexpr double float_max = std::numeric_limits<float>::max();
    check_bounds(decoder, set.bounds);
    if (!(0.5 * longest_side(set.bounds) <= float_max)) decoder.damaged("its bounds are too large for floats");
    for (const marks::Layer& layer : set.layers)
        for (std::int64_t i = 0; i < layer.position.size(); ++i) {
            const auto axis = static_cast<glm::length_t>(i % 3);
            const double position = layer.position[i];
            const double place = set.origin[axis] + position;
            const double slack = 2e-7 * std::abs(position) + 1e-15 * std::abs(set.origin[axis]) + 1e-44;
            if (!(place >= set.bounds.min[axis] - slack && place <= set.bounds.max[axis] + slack))
                decoder.damaged("position[%lld] is outside its bounds", static_cast<long long>(i / 3));
        }
}

// Checks a set without marks, which has no bounding box. Sets its origin and spacing to 0, because older files do not
// contain them.
void check_empty(const Decoder& decoder, marks::PointSet& set) {
    for (int axis = 0; axis < 3; ++axis) {
        if (!(std::isinf(set.bounds.min[axis]) && set.bounds.min[axis] > 0.0 && std::isinf(set.bounds.max[axis]) &&
              set.bounds.max[axis] < 0.0))
            decoder.damaged("it has bounds, but no marks");
    }
    set.origin = glm::dvec3(0.0);
    set.spacing = 0.0;
}

void check_set(const Decoder& decoder, marks::PointSet& set) {
    for (const marks::Layer& layer : set.layers) check_layer(decoder, layer);
    const std::int64_t marks = set.count();
    if (marks == 0) check_empty(decoder, set);
    check_finite<double>(
        decoder, "numbers",
        std::array{set.origin.x, set.origin.y, set.origin.z, set.spacing, set.seconds_seeds, set.seconds_total});
    if (set.spacing < 0.0) decoder.damaged("its spacing is negative");
    if (set.seconds_seeds < 0.0 || set.seconds_total < 0.0) decoder.damaged("one of its times is negative");
    if (marks > 0) check_places(decoder, set);
}

} // namespace

void save_point_set(const marks::PointSet& set, Writer& writer) {
    const std::uint32_t version = marks::field_count(set) > 0 ? point_set_version : fieldless_version;
    write_file(writer, kind_point_set, version, [&](Encoder& encoder) { encode(encoder, set); });
}

marks::PointSet load_point_set(base::Memory& memory, Reader& reader) {
    Decoder decoder(reader, kind_point_set, fieldless_version, point_set_version, "point set");
    marks::PointSet set(memory);
    const std::uint32_t layers = decode_kind(decoder, set);
    SetNumbers numbers{};
    decoder.section<double>(tag_set_numbers, numbers);
    set_numbers(set, numbers);
    LevelNumbers seeds{};
    decoder.section<std::int64_t>(tag_seeds, seeds);
    for (const std::int64_t count : seeds)
        if (count < 0) decoder.damaged("a count of its seeds is negative");
    set.seeds = level_of(seeds.data());
    decode_layers(decoder, layers, set);
    decoder.finish();
    check_set(decoder, set);
    return set;
}

} // namespace hrbfnpr::io
