// SPDX-License-Identifier: MIT
// Reads files in the format of docs/file-format.md. Contents are checked before they are used. Memory is allocated only
// as bytes arrive, so a wrong length in a file cannot exhaust memory.
#pragma once

#include "base/memory.h"
#include "base/status.h"
#include "io/crc32.h"
#include "io/format.h"
#include "io/stream.h"

#include <algorithm>
#include <span>

namespace hrbfnpr::io {

class Decoder {
public:
    // Reads and checks the header. Versions from `oldest` to `newest` are accepted. `what` is the kind of file for
    // messages, such as "model".
    Decoder(Reader& reader, std::uint32_t kind, std::uint32_t oldest, std::uint32_t newest, const char* what);

    // Returns the format version of the file.
    [[nodiscard]] std::uint32_t version() const noexcept { return version_; }

    // Reads a section of exactly elements.size() elements.
    template <class T>
    void section(std::uint32_t tag, std::span<T> elements) {
        const std::int64_t count = begin_section(tag, element_type<T>(), sizeof(T));
        expect_count(tag, count, static_cast<std::int64_t>(elements.size()));
        read_elements(elements);
    }

    // Reads a section of any length.
    template <class T>
    void section(std::uint32_t tag, base::Array<T>& elements) {
        const std::int64_t count = begin_section(tag, element_type<T>(), sizeof(T));
        elements.clear();
        elements.reserve(std::min<std::int64_t>(count, first_elements));
        while (elements.size() < count) {
            const std::int64_t begin = elements.size();
            const std::int64_t room = elements.bytes() / std::int64_t{sizeof(T)};
            elements.resize(std::min(count, begin < room ? room : 2 * room));
            read_elements(elements.span().subspan(static_cast<std::size_t>(begin)));
        }
    }

    // Reads a section of exactly `count` elements.
    template <class T>
    void section(std::uint32_t tag, base::Array<T>& elements, std::int64_t count) {
        section(tag, elements);
        expect_count(tag, elements.size(), count);
    }

    // Returns whether more sections follow. Optional sections are at the end of a file.
    [[nodiscard]] bool has_more() const noexcept { return remaining_ >= section_header_size; }

    // Must be called after the last section. Checks that the payload ends and that its checksum is correct.
    void finish();

    // Throws Error{corrupt_data} with the message "this model file is damaged: " and the formatted text.
    HRBFNPR_PRINTF_LIKE(2, 3) [[noreturn]] void damaged(const char* format, ...) const;

private:
    static constexpr std::int64_t first_elements = 16384;
    static constexpr std::size_t buffer_size = 8192;

    template <class T>
    void read_elements(std::span<T> elements) {
        constexpr std::size_t piece = buffer_size / sizeof(T);
        std::uint8_t buffer[buffer_size];
        for (std::size_t begin = 0; begin < elements.size(); begin += piece) {
            const std::size_t count = std::min(piece, elements.size() - begin);
            read_payload({buffer, count * sizeof(T)});
            for (std::size_t i = 0; i < count; ++i) elements[begin + i] = fetch<T>(buffer + i * sizeof(T));
        }
    }

    std::int64_t begin_section(std::uint32_t tag, ElementType type, std::uint64_t element_size);
    void expect_count(std::uint32_t tag, std::int64_t count, std::int64_t expected) const;
    void check_header(std::span<const std::uint8_t, header_size> header, std::uint32_t kind, std::uint32_t oldest,
                      std::uint32_t newest);
    void read_exactly(std::span<std::uint8_t> bytes);
    void read_payload(std::span<std::uint8_t> bytes);

    Reader& reader_;
    const char* what_;
    Crc32 crc_;
    std::uint32_t version_ = 0;
    std::uint64_t remaining_ = 0; // number of bytes left in the payload
    std::uint64_t position_ = 0;  // number of bytes read from the file
};

} // namespace hrbfnpr::io
