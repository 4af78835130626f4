#include "io/check.h"
#include "io/encoder.h"
#include "io/files.h"

#include <algorithm>
#include <limits>

namespace hrbfnpr::io {
namespace {

constexpr std::uint32_t tag_kind = tag("KIND");
constexpr std::uint32_t tag_numbers = tag("NUMB");
constexpr std::uint32_t tag_seeds = tag("SEED");
constexpr std::uint32_t tag_group_counts = tag("GCNT");
constexpr std::uint32_t tag_group_numbers = tag("GNUM");
constexpr std::uint32_t tag_rank = tag("RANK");
constexpr std::uint32_t tag_position = tag("POSI");
constexpr std::uint32_t tag_normal = tag("NORM");
constexpr std::uint32_t tag_direction = tag("DIRE");
constexpr std::uint32_t tag_curvature = tag("CURV");
constexpr std::uint32_t tag_level = tag("LEVL");
constexpr std::uint32_t tag_stroke = tag("STRK");

constexpr std::uint32_t tag_width = tag("WIDT");

constexpr std::size_t level_numbers = 6;
constexpr std::size_t levels = marks::most_levels + 1;
using Numbers = std::array<double, 12>;
using LevelNumbers = std::array<std::int64_t, level_numbers>;
using GroupCounts = std::array<std::int64_t, 3 + levels * level_numbers>;

Numbers numbers_of(const marks::PointSet& set) noexcept {
    const auto& [low, high] = set.bounds;
    return {set.origin.x, set.origin.y,      set.origin.z,     low.x, low.y, low.z, high.x, high.y, high.z,
            set.spacing,  set.seconds_seeds, set.seconds_total};
}

void set_numbers(marks::PointSet& set, const Numbers& n) noexcept {
    set.origin = {n[0], n[1], n[2]};
    set.bounds = {{n[3], n[4], n[5]}, {n[6], n[7], n[8]}};
    set.spacing = n[9];
    set.seconds_seeds = n[10];
    set.seconds_total = n[11];
}

LevelNumbers numbers_of(const marks::LevelReport& level) noexcept {
    return {level.attempted,          level.placed,        level.dropped_not_converged, level.dropped_strayed,
            level.dropped_degenerate, level.dropped_budget};
}

marks::LevelReport level_of(const std::int64_t* n) noexcept { return {n[0], n[1], n[2], n[3], n[4], n[5]}; }

GroupCounts counts_of(const marks::GroupReport& report) noexcept {
    GroupCounts counts{report.strokes, report.full_count, report.levels};
    for (std::size_t level = 0; level < levels; ++level) {
        const LevelNumbers numbers = numbers_of(report.level[level]);
        std::copy(numbers.begin(), numbers.end(), &counts[3 + level * level_numbers]);
    }
    return counts;
}

void encode_group(Encoder& encoder, const marks::MarkGroup& group) {
    encoder.section<std::int64_t>(tag_group_counts, counts_of(group.report));
    encoder.section<double>(tag_group_numbers, std::array{group.report.step, group.report.seconds});
    encoder.section(tag_rank, group.rank.span());
    encoder.section(tag_position, group.position.span());
    encoder.section(tag_normal, group.normal.span());
    encoder.section(tag_direction, group.direction.span());
    encoder.section(tag_curvature, group.curvature.span());
    encoder.section(tag_level, group.level.span());
    encoder.section(tag_stroke, group.stroke.span());
}

// One for each group, at the end, and none where all are empty: as in files from before there were widths.
void encode_widths(Encoder& encoder, const marks::PointSet& set) {
    const auto has_width = [](const marks::MarkGroup& group) { return !group.width.empty(); };
    if (std::none_of(set.group.begin(), set.group.end(), has_width)) return;
    for (const marks::MarkGroup& group : set.group) encoder.section(tag_width, group.width.span());
}

void encode(Encoder& encoder, const marks::PointSet& set) {
    const std::array<std::uint32_t, 3> kind{static_cast<std::uint32_t>(set.distribution),
                                            static_cast<std::uint32_t>(set.seed_source), marks::group_count};
    encoder.section<std::uint32_t>(tag_kind, kind);
    encoder.section<double>(tag_numbers, numbers_of(set));
    encoder.section<std::int64_t>(tag_seeds, numbers_of(set.seeds));
    for (const marks::MarkGroup& group : set.group) encode_group(encoder, group);
    encode_widths(encoder, set);
}

void decode_kind(Decoder& decoder, marks::PointSet& set) {
    std::array<std::uint32_t, 3> kind{};
    decoder.section<std::uint32_t>(tag_kind, kind);
    if (kind[0] > static_cast<std::uint32_t>(marks::Distribution::published))
        decoder.damaged("its distribution is unknown");
    if (kind[1] > static_cast<std::uint32_t>(marks::SeedSource::points)) decoder.damaged("its seed source is unknown");
    if (kind[2] != marks::group_count) decoder.damaged("it has %u groups instead of 3", kind[2]);
    set.distribution = static_cast<marks::Distribution>(kind[0]);
    set.seed_source = static_cast<marks::SeedSource>(kind[1]);
}

marks::GroupReport decode_report(Decoder& decoder) {
    GroupCounts counts{};
    std::array<double, 2> numbers{};
    decoder.section<std::int64_t>(tag_group_counts, counts);
    decoder.section<double>(tag_group_numbers, numbers);
    for (const std::int64_t count : counts)
        if (count < 0) decoder.damaged("a count of a group is negative");
    if (counts[2] > marks::most_levels) decoder.damaged("a group has more than 12 levels");
    check_finite<double>(decoder, "group", numbers);
    if (numbers[0] < 0.0 || numbers[1] < 0.0) decoder.damaged("a step or time of a group is negative");
    marks::GroupReport report;
    report.strokes = counts[0];
    report.full_count = counts[1];
    report.levels = static_cast<std::int32_t>(counts[2]);
    for (std::size_t level = 0; level < levels; ++level)
        report.level[level] = level_of(&counts[3 + level * level_numbers]);
    report.step = numbers[0];
    report.seconds = numbers[1];
    return report;
}

void decode_group(Decoder& decoder, marks::MarkGroup& group) {
    group.report = decode_report(decoder);
    decoder.section(tag_rank, group.rank);
    const std::int64_t count = group.rank.size();
    decoder.section(tag_position, group.position, 3 * count);
    decoder.section(tag_normal, group.normal, 3 * count);
    decoder.section(tag_direction, group.direction, 3 * count);
    decoder.section(tag_curvature, group.curvature);
    if (!group.curvature.empty() && group.curvature.size() != 3 * count)
        decoder.damaged("a group's curvatures are not as many as its marks");
    decoder.section(tag_level, group.level, count);
    decoder.section(tag_stroke, group.stroke, 2 * count);
}

void decode_widths(Decoder& decoder, marks::PointSet& set) {
    if (!decoder.more()) return;
    for (marks::MarkGroup& group : set.group) {
        decoder.section(tag_width, group.width);
        if (!group.width.empty() && group.width.size() != group.count())
            decoder.damaged("a group's widths are not as many as its marks");
    }
}

void check_group(const Decoder& decoder, const marks::MarkGroup& group) {
    check_finite(decoder, "position", group.position.span());
    check_unit(decoder, "normal", group.normal.span());
    check_finite(decoder, "direction", group.direction.span());
    for (std::int64_t i = 0; i < group.count(); ++i)
        if (const glm::vec3 d = marks::vector_at(group.direction, i); !(glm::dot(d, d) < 1.02F))
            decoder.damaged("direction[%lld] is longer than a unit vector", static_cast<long long>(i));
    check_finite(decoder, "curvature", group.curvature.span());
    for (const float rank : group.rank.span())
        if (!(rank >= 0.0F && rank < 1.0F)) decoder.damaged("a rank is outside [0, 1)");
    for (const float width : group.width.span())
        if (!(width > 0.0F && width <= 1.0F)) decoder.damaged("a width is outside (0, 1]");
}

// Positions are floats about the middle of the box of all marks, which lie in it; but for their rounding.
void check_places(const Decoder& decoder, const marks::PointSet& set) {
    constexpr double float_max = std::numeric_limits<float>::max();
    check_bounds(decoder, set.bounds);
    if (!(0.5 * longest_side(set.bounds) <= float_max)) decoder.damaged("its bounds are larger than floats can be");
    for (const marks::MarkGroup& group : set.group)
        for (std::int64_t i = 0; i < group.position.size(); ++i) {
            const auto axis = static_cast<glm::length_t>(i % 3);
            const double position = group.position[i];
            const double place = set.origin[axis] + position;
            const double slack = 2e-7 * std::abs(position) + 1e-15 * std::abs(set.origin[axis]) + 1e-44;
            if (!(place >= set.bounds.min[axis] - slack && place <= set.bounds.max[axis] + slack))
                decoder.damaged("position[%lld] is outside its bounds", static_cast<long long>(i / 3));
        }
}

// A set without marks has no box, and once had no origin and no spacing.
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
    std::int64_t marks = 0;
    for (const marks::MarkGroup& group : set.group) {
        check_group(decoder, group);
        marks += group.count();
    }
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
    write_file(writer, kind_point_set, [&](Encoder& encoder) { encode(encoder, set); });
}

marks::PointSet load_point_set(base::Memory& memory, Reader& reader) {
    Decoder decoder(reader, kind_point_set, "point set");
    marks::PointSet set(memory);
    decode_kind(decoder, set);
    Numbers numbers{};
    decoder.section<double>(tag_numbers, numbers);
    set_numbers(set, numbers);
    LevelNumbers seeds{};
    decoder.section<std::int64_t>(tag_seeds, seeds);
    for (const std::int64_t count : seeds)
        if (count < 0) decoder.damaged("a count of its seeds is negative");
    set.seeds = level_of(seeds.data());
    for (marks::MarkGroup& group : set.group) decode_group(decoder, group);
    decode_widths(decoder, set);
    decoder.finish();
    check_set(decoder, set);
    return set;
}

} // namespace hrbfnpr::io
