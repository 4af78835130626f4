// SPDX-License-Identifier: MIT
// Parts that the fuzzers share. Most changes break a checksum, and the code after the check would never be reached, so
// both checksums are corrected before the file is loaded.
#pragma once

#include "io/crc32.h"
#include "io/format.h"
#include "support/allocator.h"

#include <hrbfnpr.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <initializer_list>
#include <span>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace fuzz {

using Bytes = std::vector<std::uint8_t>;

// A violation of the library's contract aborts the fuzzer, so that the input is kept.
inline void require(bool kept, const char* contract) {
    if (kept) return;
    std::fprintf(stderr, "broken contract: %s\n", contract);
    std::abort();
}

inline std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
    hrbfnpr::io::Crc32 crc;
    crc.add(bytes);
    return crc.value();
}

inline Bytes signed_file(const std::uint8_t* data, std::size_t size) {
    using namespace hrbfnpr::io;
    Bytes file;
    file.reserve(size + 1); // gives an empty file an address, too: NULL would be another error
    file.assign(data, data + size);
    const std::span<std::uint8_t> bytes(file);
    if (size >= header_size) store(&file[header_size - 4], checksum(bytes.first(header_size - 4)));
    if (size >= header_size + 4) store(&file[size - 4], checksum(bytes.subspan(header_size, size - header_size - 4)));
    return file;
}

// A number that chooses the trial of a file. It leaves out the last bytes: the checksum of a payload with its own
// checksum at the end is always the same.
inline std::uint32_t choice_of(const Bytes& file) { return checksum(std::span(file).first(file.size() - 4)); }

// A call's outcome. If the contract does not allow the outcome, the message is printed and the fuzzer aborts.
class Call {
public:
    explicit Call(const char* name) : name_(name) { hrbfnpr_error_init(&error_, sizeof error_); }
    [[nodiscard]] hrbfnpr_error* error() { return &error_; }
    // Returns whether the call succeeded.
    bool expect(hrbfnpr_status status, std::initializer_list<hrbfnpr_status> failures = {}) {
        if (status == HRBFNPR_STATUS_OK) {
            require(error_.status == HRBFNPR_STATUS_OK && error_.message[0] == 0, "success leaves the error as it was");
            return true;
        }
        require(error_.status == status, "the error has the status that is returned");
        require(error_.message[0] != 0, "a failure has a message");
        for (const hrbfnpr_status failure : failures)
            if (status == failure) return false;
        std::fprintf(stderr, "%s: %s: %s\n", name_, hrbfnpr_status_name(status), error_.message);
        std::abort();
    }

private:
    const char* name_;
    hrbfnpr_error error_;
};

inline std::int32_t context_threads = 1; // serial, so that a crash is the same each time

// A context that has no more memory than any small file can need.
class Context {
public:
    Context() {
        hrbfnpr_context_desc desc;
        hrbfnpr_context_desc_init(&desc, sizeof desc);
        desc.thread_count = context_threads;
        desc.allocator_user = this;
        desc.allocate = [](void* self, std::uint64_t bytes, std::uint64_t alignment) {
            return static_cast<Context*>(self)->allocate(bytes, alignment);
        };
        desc.deallocate = [](void* self, void* memory, std::uint64_t bytes, std::uint64_t) {
            static_cast<Context*>(self)->bytes_ -= bytes;
            std::free(memory);
        };
        Call call("context_create");
        call.expect(hrbfnpr_context_create(&desc, &handle, call.error()));
    }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    ~Context() {
        hrbfnpr_context_release(handle);
        require(bytes_ == 0, "all memory is given back");
    }

    hrbfnpr_context* handle = nullptr;
    bool loading = false;
    std::atomic<std::int64_t> until_refusal = -1; // number of allocations that still succeed; negative: all succeed

private:
    void* allocate(std::uint64_t bytes, std::uint64_t alignment) {
        if (bytes > 64U << 20U) {
            require(!loading, "a declared length is not believed");
            return nullptr;
        }
        if (bytes_ + bytes > 512U << 20U || is_refused()) return nullptr;
        bytes_ += bytes;
        return hrbfnpr::test::Allocator::aligned(bytes, alignment);
    }

    bool is_refused() {
        std::int64_t left = until_refusal;
        while (left > 0 && !until_refusal.compare_exchange_weak(left, left - 1)) {
        }
        return left == 0;
    }

    std::atomic<std::uint64_t> bytes_ = 0; // bytes in use
};

// Loads a model or a point set. Returns NULL if the file is refused, which must be with one of two errors.
template <class Handle, class Load>
Handle* load(Context& context, const Bytes& file, Load function) {
    Call call("load_memory");
    Handle* handle = nullptr;
    context.loading = true;
    const hrbfnpr_status status =
        function(context.handle, file.data(), static_cast<std::int64_t>(file.size()), &handle, call.error());
    context.loading = false;
    const bool loaded = call.expect(status, {HRBFNPR_STATUS_CORRUPT_DATA, HRBFNPR_STATUS_VERSION_MISMATCH});
    require(loaded == (handle != nullptr), "a handle comes with success only");
    return handle;
}

template <class Handle, class Save>
Bytes save(const Handle* handle, Save function) {
    std::int64_t size = 0;
    Call measure("save_memory");
    measure.expect(function(handle, nullptr, 0, &size, measure.error()), {HRBFNPR_STATUS_BUFFER_TOO_SMALL});
    Bytes file(static_cast<std::size_t>(size));
    Call call("save_memory");
    call.expect(function(handle, file.data(), size, &size, call.error()));
    return file;
}

void require_same_set(Context& context, const hrbfnpr_point_set* set);
void require_sound_marks(const hrbfnpr_point_set* set);
// Draws the set in one of a few ways: `choice` selects a style, a visibility and a shape.
void draw(Context& context, const hrbfnpr_point_set* set, std::uint32_t choice);

} // namespace fuzz
