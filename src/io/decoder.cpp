// SPDX-License-Identifier: MIT
#include "io/decoder.h"

#include "base/format.h"

#include <cstdarg>

namespace hrbfnpr::io {
namespace {

struct TagText {
    explicit TagText(std::uint32_t tag) noexcept {
        for (unsigned i = 0; i < 4; ++i) {
            const auto letter = static_cast<char>((tag >> (8U * i)) & 0xFFU);
            text[i] = letter >= ' ' && letter <= '~' ? letter : '?';
        }
    }
    char text[5] = {};
};

} // namespace

Decoder::Decoder(Reader& reader, std::uint32_t kind, std::uint32_t oldest, std::uint32_t newest, const char* what)
    : reader_(reader), what_(what) {
    std::array<std::uint8_t, header_size> header{};
    read_exactly(header);
    check_header(header, kind, oldest, newest);
}

void Decoder::damaged(const char* format, ...) const {
    char detail[160];
    std::va_list arguments;
    va_start(arguments, format);
    base::format_text(detail, sizeof detail, format, arguments);
    va_end(arguments);
    fail(Status::corrupt_data, "this %s file is damaged: %s", what_, detail);
}

void Decoder::check_header(std::span<const std::uint8_t, header_size> header, std::uint32_t kind, std::uint32_t oldest,
                           std::uint32_t newest) {
    if (!std::equal(magic.begin(), magic.end(), header.begin()))
        fail(Status::corrupt_data, "this is not a %s file of hrbfnpr: its first bytes are not those of one", what_);
    Crc32 crc;
    crc.add(header.first(header_size - 4));
    if (crc.value() != fetch<std::uint32_t>(&header[36])) damaged("the checksum of its header is wrong");
    if (fetch<std::uint32_t>(&header[8]) != kind)
        fail(Status::corrupt_data, "this is a file of hrbfnpr, but not a %s: its kind is '%s'", what_,
             TagText(fetch<std::uint32_t>(&header[8])).text);
    // Newer versions of the format keep this header, so that a newer file can be distinguished from a damaged one.
    version_ = fetch<std::uint32_t>(&header[12]);
    if (version_ > newest)
        fail(Status::version_mismatch,
             "this %s file has format version %u, but this library reads versions up to %u; use a newer library", what_,
             version_, newest);
    if (version_ == 0) damaged("its format version is 0");
    if (version_ < oldest)
        fail(Status::version_mismatch,
             "this %s file has format version %u, from before the first release, but this library reads versions from "
             "%u on; save it again",
             what_, version_, oldest);
    if (fetch<std::uint32_t>(&header[16]) != byte_order_mark) damaged("its byte order mark is wrong");
    remaining_ = fetch<std::uint64_t>(&header[24]);
}

void Decoder::read_exactly(std::span<std::uint8_t> bytes) {
    std::size_t got = 0;
    while (got < bytes.size()) {
        const std::uint64_t now = reader_.read(bytes.data() + got, bytes.size() - got);
        if (now == 0)
            fail(Status::corrupt_data, "this %s file is truncated: it ends after %llu bytes", what_,
                 static_cast<unsigned long long>(position_ + got));
        got += static_cast<std::size_t>(now);
    }
    position_ += got;
}

void Decoder::read_payload(std::span<std::uint8_t> bytes) {
    read_exactly(bytes);
    crc_.add(bytes);
    remaining_ -= bytes.size();
}

std::int64_t Decoder::begin_section(std::uint32_t tag, ElementType type, std::uint64_t element_size) {
    const TagText name(tag);
    if (remaining_ < section_header_size) damaged("it ends before section '%s'", name.text);
    std::array<std::uint8_t, section_header_size> header{};
    read_payload(header);
    if (const auto found = fetch<std::uint32_t>(header.data()); found != tag)
        damaged("section '%s' is where section '%s' should be", TagText(found).text, name.text);
    if (fetch<std::uint32_t>(&header[4]) != static_cast<std::uint32_t>(type))
        damaged("the elements of section '%s' have the wrong type", name.text);
    const auto count = fetch<std::uint64_t>(&header[8]);
    if (count > remaining_ / element_size) damaged("section '%s' is longer than the rest of the file", name.text);
    constexpr std::uint64_t beyond_any_memory = std::uint64_t{1} << 56U;
    if (count > beyond_any_memory) damaged("section '%s' is too long for memory", name.text);
    return static_cast<std::int64_t>(count);
}

void Decoder::expect_count(std::uint32_t tag, std::int64_t count, std::int64_t expected) const {
    if (count != expected)
        damaged("section '%s' has %lld elements instead of %lld", TagText(tag).text, static_cast<long long>(count),
                static_cast<long long>(expected));
}

void Decoder::finish() {
    if (remaining_ != 0) damaged("%llu bytes follow its last section", static_cast<unsigned long long>(remaining_));
    std::array<std::uint8_t, 4> trailer{};
    read_exactly(trailer);
    if (fetch<std::uint32_t>(trailer.data()) != crc_.value()) damaged("its checksum is wrong");
}

} // namespace hrbfnpr::io
