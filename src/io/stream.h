// SPDX-License-Identifier: MIT
// Streams of bytes for reading and writing.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

namespace hrbfnpr::io {

class Writer {
public:
    Writer() = default;
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;
    virtual ~Writer() = default;
    virtual void write(const void* data, std::uint64_t size) = 0; // throws Error{io}
};

class Reader {
public:
    Reader() = default;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;
    virtual ~Reader() = default;
    // Reads up to `size` bytes and returns their number, or 0 at the end. Throws Error{io}.
    virtual std::uint64_t read(void* data, std::uint64_t size) = 0;
};

// Reads from a block of memory.
class MemoryReader final : public Reader {
public:
    explicit MemoryReader(std::span<const std::byte> bytes) noexcept : rest_(bytes) {}

    std::uint64_t read(void* data, std::uint64_t size) override {
        const std::size_t count = std::min(rest_.size(), static_cast<std::size_t>(size));
        if (count > 0) std::memcpy(data, rest_.data(), count);
        rest_ = rest_.subspan(count);
        return count;
    }
    [[nodiscard]] std::size_t remaining() const noexcept { return rest_.size(); }

private:
    std::span<const std::byte> rest_;
};

// Writes to a block of memory. Data that do not fit are only counted.
class MemoryWriter final : public Writer {
public:
    explicit MemoryWriter(std::span<std::byte> room) noexcept : room_(room) {}

    void write(const void* data, std::uint64_t size) override {
        if (needed_ + size <= room_.size() && size > 0)
            std::memcpy(room_.data() + needed_, data, static_cast<std::size_t>(size));
        needed_ += size;
    }
    [[nodiscard]] std::uint64_t needed() const noexcept { return needed_; }

private:
    std::span<std::byte> room_;
    std::uint64_t needed_ = 0;
};

} // namespace hrbfnpr::io
