// SPDX-License-Identifier: MIT
// Adapts the caller's callbacks and memory to the streams of src/io.
#pragma once

#include "api/barrier.h"
#include "base/status.h"
#include "io/stream.h"

#include <hrbfnpr.h>

namespace hrbfnpr::api {

class CallbackWriter final : public io::Writer {
public:
    CallbackWriter(hrbfnpr_write_fn function, void* user) noexcept : write_(function), user_(user) {}
    void write(const void* data, std::uint64_t size) override {
        if (const std::int32_t result = write_(user_, data, size); result != 0)
            fail(Status::io, "write returned %d for %llu bytes; it must return 0 unless it failed",
                 static_cast<int>(result), static_cast<unsigned long long>(size));
    }

private:
    hrbfnpr_write_fn write_;
    void* user_;
};

class CallbackReader final : public io::Reader {
public:
    CallbackReader(hrbfnpr_read_fn function, void* user) noexcept : read_(function), user_(user) {}
    std::uint64_t read(void* data, std::uint64_t size) override {
        const std::int64_t count = read_(user_, data, size);
        if (count < 0 || static_cast<std::uint64_t>(count) > size)
            fail(Status::io,
                 "read returned %lld, but up to %llu bytes were asked for; it must return the number of bytes read",
                 static_cast<long long>(count), static_cast<unsigned long long>(size));
        return static_cast<std::uint64_t>(count);
    }

private:
    hrbfnpr_read_fn read_;
    void* user_;
};

// Runs save(writer) with the caller's memory. Sets *size to the number of bytes needed. Throws BUFFER_TOO_SMALL if the
// memory is smaller.
template <class F>
void save_to_memory(void* destination, std::int64_t capacity, std::int64_t* size, F&& save) {
    require_pointer(size, "size");
    if (capacity < 0)
        fail(Status::invalid_argument, "capacity is %lld; it must be 0 or more", static_cast<long long>(capacity));
    if (capacity > 0) require_pointer(destination, "destination");
    io::MemoryWriter measure({});
    save(measure);
    const auto needed = static_cast<std::int64_t>(measure.needed());
    *size = needed;
    if (needed > capacity)
        fail(Status::buffer_too_small, "capacity is %lld; it must be at least %lld bytes",
             static_cast<long long>(capacity), static_cast<long long>(needed));
    io::MemoryWriter writer({static_cast<std::byte*>(destination), static_cast<std::size_t>(needed)});
    save(writer);
}

[[nodiscard]] inline io::MemoryReader memory_reader(const void* data, std::int64_t size) {
    require_pointer(data, "data");
    if (size < 0) fail(Status::invalid_argument, "size is %lld; it must be 0 or more", static_cast<long long>(size));
    return io::MemoryReader({static_cast<const std::byte*>(data), static_cast<std::size_t>(size)});
}

} // namespace hrbfnpr::api
