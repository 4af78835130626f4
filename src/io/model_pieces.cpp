// SPDX-License-Identifier: MIT
#include "base/bits.h"
#include "io/check.h"
#include "io/model_sections.h"

namespace hrbfnpr::io {
namespace {

constexpr std::uint32_t tag_sheets = tag("SHTS");
constexpr std::uint32_t tag_space = tag("SPAC");
constexpr std::uint32_t tag_nodes = tag("NODE");
constexpr std::uint32_t tag_program_begin = tag("PBEG");
constexpr std::uint32_t tag_program = tag("PROG");
constexpr std::uint32_t tag_plain = tag("PLAI");
constexpr std::uint32_t tag_piece_position = tag("PSPO");
constexpr std::uint32_t tag_piece_normal = tag("PSNR");

constexpr std::uint32_t most_sheets = 1U << 20U;
using Space = std::array<double, 11>;

Space space_of(const implicit::SheetTreeData& data) noexcept {
    const auto& [low, high] = data.bounds;
    const glm::dvec3& corner = data.corner;
    return {low.x, low.y, low.z, high.x, high.y, high.z, data.spacing, corner.x, corner.y, corner.z, data.side};
}

// Returns the numbers in two's complement, because the 32-bit sections of a file are unsigned.
base::Array<std::uint32_t> unsigned_of(const base::Array<std::int32_t>& numbers) {
    base::Array<std::uint32_t> result(numbers.memory());
    for (const std::int32_t number : numbers) result.push_back(base::bit_cast<std::uint32_t>(number));
    return result;
}

void decode_numbers(Decoder& decoder, std::uint32_t tag, base::Array<std::int32_t>& numbers) {
    base::Array<std::uint32_t> stored(numbers.memory());
    decoder.section(tag, stored);
    for (const std::uint32_t number : stored) numbers.push_back(base::bit_cast<std::int32_t>(number));
}

} // namespace

void encode_pieces(Encoder& encoder, const implicit::SheetTreeData& data) {
    const std::array<std::uint32_t, 1> sheets{static_cast<std::uint32_t>(data.sheet.size())};
    encoder.section<std::uint32_t>(tag_sheets, sheets);
    for (const implicit::HrbfData& sheet : data.sheet) encode_hrbf(encoder, sheet);
    encoder.section<double>(tag_space, space_of(data));
    encoder.section<std::uint32_t>(tag_nodes, unsigned_of(data.child).span());
    encoder.section<std::uint32_t>(tag_program_begin, unsigned_of(data.program_begin).span());
    encoder.section<std::uint32_t>(tag_program, unsigned_of(data.program).span());
    encoder.section(tag_plain, data.plain.span());
    encoder.section(tag_piece_position, data.sample_position.span());
    encoder.section(tag_piece_normal, data.sample_normal.span());
}

void decode_pieces(Decoder& decoder, implicit::SheetTreeData& data) {
    std::array<std::uint32_t, 1> sheets{};
    decoder.section<std::uint32_t>(tag_sheets, sheets);
    if (sheets[0] < 1 || sheets[0] > most_sheets) decoder.damaged("it has no sheets, or too many");
    for (std::uint32_t i = 0; i < sheets[0]; ++i)
        decode_hrbf(decoder, decode_kind(decoder), data.sheet.add(data.sheet.memory()));
    Space n{};
    decoder.section<double>(tag_space, n);
    data.bounds = {{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
    data.spacing = n[6];
    data.corner = {n[7], n[8], n[9]};
    data.side = n[10];
    decode_numbers(decoder, tag_nodes, data.child);
    decode_numbers(decoder, tag_program_begin, data.program_begin);
    decode_numbers(decoder, tag_program, data.program);
    decoder.section(tag_plain, data.plain);
    decoder.section(tag_piece_position, data.sample_position);
    decoder.section(tag_piece_normal, data.sample_normal, data.sample_position.size());
}

void check_pieces(const Decoder& decoder, const implicit::SheetTreeData& data) {
    for (const implicit::HrbfData& sheet : data.sheet) check_hrbf(decoder, sheet);
    const Space space = space_of(data);
    check_finite<double>(decoder, "space", space);
    check_bounds(decoder, data.bounds);
    const double half = 0.5 * data.side;
    for (int axis = 0; axis < 3; ++axis) {
        if (data.bounds.min[axis] < -coordinate_limit || data.bounds.max[axis] > coordinate_limit)
            decoder.damaged("its bounds reach beyond 1e100");
        if (!(std::abs(data.corner[axis] + half - data.bounds.centre()[axis]) <= 1e-6 * half))
            decoder.damaged("its cells do not lie around its bounds");
    }
    if (!(half >= 0.5 * implicit::SheetTreeData::reach * data.bounds.diagonal() && data.side <= coordinate_limit &&
          half > 0.0))
        decoder.damaged("its cells do not cover its bounds");
    if (data.spacing < 0.0) decoder.damaged("its sample spacing is negative");
    if (!implicit::is_sound(data)) decoder.damaged("its cells or their programs are invalid");
    check_finite(decoder, "plain", data.plain.span());
    if (data.sample_position.empty() || data.sample_position.size() % 3 != 0)
        decoder.damaged("its number of samples is wrong");
    check_finite(decoder, "sample_position", data.sample_position.span());
    const geometry::Bounds cells{data.corner, data.corner + data.side};
    for (std::int64_t i = 0; i < data.sample_position.size() / 3; ++i)
        check_sample(decoder, cells, data.sample_position.data() + 3 * i, i);
    check_unit(decoder, "sample_normal", data.sample_normal.span());
}

} // namespace hrbfnpr::io
