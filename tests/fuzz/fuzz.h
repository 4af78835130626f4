// What the fuzzers share.  Most changes break a checksum, and nothing behind it would ever be
// reached: so both are made right before the file is loaded.
#pragma once

#include "io/crc32.h"
#include "io/format.h"

#include <hrbfnpr.h>

#include <cstdint>
#include <cstdlib>
#include <vector>

namespace fuzz {

inline std::vector<std::uint8_t> signed_file(const std::uint8_t* data, std::size_t size) {
    using namespace hrbfnpr::io;
    std::vector<std::uint8_t> file(data, data + size);
    const auto checksum = [&](std::size_t begin, std::size_t end) {
        Crc32 crc;
        crc.add(std::span(file).subspan(begin, end - begin));
        return crc.value();
    };
    if (size >= header_size) store(&file[header_size - 4], checksum(0, header_size - 4));
    if (size >= header_size + 4) store(&file[size - 4], checksum(header_size, size - 4));
    return file;
}

// A context that refuses more memory than any small file can need.
inline hrbfnpr_context* context() {
    hrbfnpr_context_desc desc;
    hrbfnpr_context_desc_init(&desc, sizeof desc);
    desc.thread_count = 1;
    desc.allocate = [](void*, std::uint64_t bytes, std::uint64_t alignment) -> void* {
        if (bytes > 64U << 20U) std::abort(); // a declared length was believed
        return std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
    };
    desc.deallocate = [](void*, void* memory, std::uint64_t, std::uint64_t) { std::free(memory); };
    hrbfnpr_context* context = nullptr;
    if (hrbfnpr_context_create(&desc, &context, nullptr) != HRBFNPR_STATUS_OK) std::abort();
    return context;
}

// Anything else is a bug.
inline void expect_clean(hrbfnpr_status status) {
    if (status != HRBFNPR_STATUS_OK && status != HRBFNPR_STATUS_CORRUPT_DATA &&
        status != HRBFNPR_STATUS_VERSION_MISMATCH)
        std::abort();
}

} // namespace fuzz
