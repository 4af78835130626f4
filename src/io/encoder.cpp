// SPDX-License-Identifier: MIT
#include "io/encoder.h"

namespace hrbfnpr::io {

void Encoder::begin_section(std::uint32_t tag, ElementType type, std::uint64_t count) {
    std::uint8_t bytes[section_header_size];
    store(bytes, tag);
    store(bytes + 4, static_cast<std::uint32_t>(type));
    store(bytes + 8, count);
    write_bytes(bytes);
}

void Encoder::write_bytes(std::span<const std::uint8_t> bytes) {
    length_ += bytes.size();
    if (writer_ == nullptr) return;
    crc_.add(bytes);
    writer_->write(bytes.data(), bytes.size());
}

void write_header(Writer& writer, std::uint32_t kind, std::uint32_t version, std::uint64_t payload_length) {
    std::array<std::uint8_t, header_size> bytes{};
    std::copy(magic.begin(), magic.end(), bytes.begin());
    store(&bytes[8], kind);
    store(&bytes[12], version);
    store(&bytes[16], byte_order_mark);
    store(&bytes[20], std::uint32_t{0});
    store(&bytes[24], payload_length);
    store(&bytes[32], std::uint32_t{0});
    Crc32 crc;
    crc.add(std::span(bytes).first(header_size - 4));
    store(&bytes[36], crc.value());
    writer.write(bytes.data(), bytes.size());
}

void write_trailer(Writer& writer, std::uint32_t checksum) {
    std::uint8_t bytes[4];
    store(bytes, checksum);
    writer.write(bytes, sizeof bytes);
}

} // namespace hrbfnpr::io
