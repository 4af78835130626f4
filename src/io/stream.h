// Where bytes come from and go to.
#pragma once

#include <cstdint>

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
    // Reads up to `size` bytes; 0 at the end.  Throws Error{io}.
    virtual std::uint64_t read(void* data, std::uint64_t size) = 0;
};

} // namespace hrbfnpr::io
