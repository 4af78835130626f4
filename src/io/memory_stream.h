// Streams on plain memory.
#pragma once

#include "base/status.h"
#include "io/stream.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

namespace hrbfnpr::io {

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

// Writes what fits and counts everything.
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
