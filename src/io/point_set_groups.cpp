// SPDX-License-Identifier: MIT
// Version 1: always the three groups of stipples, principal and combing strokes.
#include "io/check.h"
#include "io/point_set_sections.h"

#include <array>

namespace hrbfnpr::io {
namespace {

constexpr std::uint32_t tag_group_counts = tag("GCNT");
constexpr std::uint32_t tag_group_numbers = tag("GNUM");

constexpr std::size_t levels = marks::most_levels + 1;
using GroupCounts = std::array<std::int64_t, 3 + levels * level_numbers>;

constexpr std::array<marks::Kind, 3> kinds = {marks::Kind::stipples, marks::Kind::principal, marks::Kind::combing};

void decode_group_report(Decoder& decoder, marks::LayerReport& report) {
    GroupCounts counts{};
    std::array<double, 2> numbers{};
    decoder.section<std::int64_t>(tag_group_counts, counts);
    decoder.section<double>(tag_group_numbers, numbers);
    for (const std::int64_t count : counts)
        if (count < 0) decoder.damaged("a count of a group is negative");
    if (counts[2] > marks::most_levels) decoder.damaged("a group has more than 12 levels");
    check_finite<double>(decoder, "group", numbers);
    if (numbers[0] < 0.0 || numbers[1] < 0.0) decoder.damaged("a step or time of a group is negative");
    report.full_count = counts[1]; // counts[0] are the strokes, which the marks tell too
    report.levels = static_cast<std::int32_t>(counts[2]);
    for (std::int32_t level = 0; level <= report.levels; ++level)
        report.of(level) = level_of(&counts[3 + static_cast<std::size_t>(level) * level_numbers]);
    report.step = numbers[0];
    report.seconds = numbers[1];
}

// A mark of no stroke had its number, or its seed's, where a mark of a stroke has twice that.
void double_numbers(marks::Layer& stipples) noexcept {
    constexpr std::uint32_t most = 0x7FFFFFFFU;
    for (std::int64_t i = 0; i < stipples.count(); ++i) {
        std::uint32_t& number = stipples.stroke[2 * i];
        number = 2 * (number <= most ? number : static_cast<std::uint32_t>(i));
    }
}

} // namespace

void decode_groups(Decoder& decoder, marks::PointSet& set) {
    base::List<marks::Layer> groups(set.layers.memory());
    for (const marks::Kind kind : kinds) {
        marks::Layer& group = groups.add(set.layers.memory(), kind);
        group.progressive = set.distribution == marks::Distribution::blue_noise;
        decode_group_report(decoder, group.report);
        decode_marks(decoder, group);
    }
    // Files from before there were widths have none.
    if (decoder.more())
        for (marks::Layer& group : groups) decode_width(decoder, group);
    for (marks::Layer& group : groups) {
        if (group.count() == 0) continue;
        if (group.kind == marks::Kind::stipples)
            double_numbers(group);
        else
            index_strokes(group);
        set.layers.add(std::move(group));
    }
}

} // namespace hrbfnpr::io
