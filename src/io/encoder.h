// SPDX-License-Identifier: MIT
// Writes files in the format of docs/file-format.md. The payload is encoded twice, because the header contains its
// length.
#pragma once

#include "io/crc32.h"
#include "io/format.h"
#include "io/stream.h"

#include <algorithm>
#include <span>
#include <utility>

namespace hrbfnpr::io {

class Encoder {
public:
    // If the writer is null, the encoder only counts bytes.
    explicit Encoder(Writer* writer) noexcept : writer_(writer) {}

    template <class T>
    void section(std::uint32_t tag, std::span<const T> elements) {
        begin_section(tag, element_type<T>(), elements.size());
        if (writer_ == nullptr) {
            length_ += elements.size_bytes();
            return;
        }
        constexpr std::size_t piece = buffer_size / sizeof(T);
        std::uint8_t buffer[buffer_size];
        for (std::size_t begin = 0; begin < elements.size(); begin += piece) {
            const std::size_t count = std::min(piece, elements.size() - begin);
            for (std::size_t i = 0; i < count; ++i) store(buffer + i * sizeof(T), elements[begin + i]);
            write_bytes({buffer, count * sizeof(T)});
        }
    }

    [[nodiscard]] std::uint64_t length() const noexcept { return length_; }
    [[nodiscard]] std::uint32_t checksum() const noexcept { return crc_.value(); }

private:
    static constexpr std::size_t buffer_size = 8192;

    void begin_section(std::uint32_t tag, ElementType type, std::uint64_t count);
    void write_bytes(std::span<const std::uint8_t> bytes);

    Writer* writer_;
    Crc32 crc_;
    std::uint64_t length_ = 0;
};

void write_header(Writer& writer, std::uint32_t kind, std::uint32_t version, std::uint64_t payload_length);
void write_trailer(Writer& writer, std::uint32_t checksum);

// Writes a file. encode(encoder) must write the sections. It is called twice, and must write the same sections both
// times.
template <class F>
void write_file(Writer& writer, std::uint32_t kind, std::uint32_t version, F&& encode) {
    Encoder measure(nullptr);
    encode(measure);
    write_header(writer, kind, version, measure.length());
    Encoder encoder(&writer);
    encode(encoder);
    write_trailer(writer, encoder.checksum());
}

} // namespace hrbfnpr::io
