// SPDX-License-Identifier: MIT
#include "api/barrier.h"

#include <cstddef>
#include <cstring>
#include <new>

namespace {

template <hrbfnpr::Status status>
constexpr bool is_number(hrbfnpr_status number) {
    return static_cast<hrbfnpr_status>(status) == number;
}

static_assert(is_number<hrbfnpr::Status::ok>(HRBFNPR_STATUS_OK));
static_assert(is_number<hrbfnpr::Status::invalid_argument>(HRBFNPR_STATUS_INVALID_ARGUMENT));
static_assert(is_number<hrbfnpr::Status::out_of_memory>(HRBFNPR_STATUS_OUT_OF_MEMORY));
static_assert(is_number<hrbfnpr::Status::buffer_too_small>(HRBFNPR_STATUS_BUFFER_TOO_SMALL));
static_assert(is_number<hrbfnpr::Status::unsupported_struct>(HRBFNPR_STATUS_UNSUPPORTED_STRUCT));
static_assert(is_number<hrbfnpr::Status::singular_system>(HRBFNPR_STATUS_SINGULAR_SYSTEM));
static_assert(is_number<hrbfnpr::Status::not_converged>(HRBFNPR_STATUS_NOT_CONVERGED));
static_assert(is_number<hrbfnpr::Status::cancelled>(HRBFNPR_STATUS_CANCELLED));
static_assert(is_number<hrbfnpr::Status::io>(HRBFNPR_STATUS_IO));
static_assert(is_number<hrbfnpr::Status::corrupt_data>(HRBFNPR_STATUS_CORRUPT_DATA));
static_assert(is_number<hrbfnpr::Status::version_mismatch>(HRBFNPR_STATUS_VERSION_MISMATCH));
static_assert(is_number<hrbfnpr::Status::callback>(HRBFNPR_STATUS_CALLBACK));
static_assert(is_number<hrbfnpr::Status::internal>(HRBFNPR_STATUS_INTERNAL));
static_assert(sizeof(hrbfnpr_error) == 256);
static_assert(sizeof(hrbfnpr_error::message) == hrbfnpr::Error::message_capacity);

// Writes an error to the caller's struct. If the struct is not initialised, it is not changed, because its memory may
// contain anything.
hrbfnpr_status write_error(hrbfnpr_error* error, hrbfnpr::Status status, const char* message) noexcept {
    const auto number = static_cast<hrbfnpr_status>(status);
    if (error != nullptr && error->struct_size >= sizeof(hrbfnpr_error)) {
        error->status = number;
        hrbfnpr::copy_message(error->message, sizeof error->message, message);
    }
    return number;
}

} // namespace

namespace hrbfnpr::api {

hrbfnpr_status report_exception(hrbfnpr_error* error) noexcept {
    try {
        throw;
    } catch (const Error& failure) {
        return write_error(error, failure.status(), failure.what());
    } catch (const std::bad_alloc&) {
        return write_error(error, Status::out_of_memory, "out of memory");
    } catch (const std::exception& failure) {
        return write_error(error, Status::internal, failure.what());
    } catch (...) {
        return write_error(error, Status::internal, "an exception of unknown type");
    }
}

} // namespace hrbfnpr::api

extern "C" {

const char* hrbfnpr_status_name(hrbfnpr_status status) {
    switch (status) {
    case HRBFNPR_STATUS_OK: return "OK";
    case HRBFNPR_STATUS_INVALID_ARGUMENT: return "INVALID_ARGUMENT";
    case HRBFNPR_STATUS_OUT_OF_MEMORY: return "OUT_OF_MEMORY";
    case HRBFNPR_STATUS_BUFFER_TOO_SMALL: return "BUFFER_TOO_SMALL";
    case HRBFNPR_STATUS_UNSUPPORTED_STRUCT: return "UNSUPPORTED_STRUCT";
    case HRBFNPR_STATUS_SINGULAR_SYSTEM: return "SINGULAR_SYSTEM";
    case HRBFNPR_STATUS_NOT_CONVERGED: return "NOT_CONVERGED";
    case HRBFNPR_STATUS_CANCELLED: return "CANCELLED";
    case HRBFNPR_STATUS_IO: return "IO";
    case HRBFNPR_STATUS_CORRUPT_DATA: return "CORRUPT_DATA";
    case HRBFNPR_STATUS_VERSION_MISMATCH: return "VERSION_MISMATCH";
    case HRBFNPR_STATUS_CALLBACK: return "CALLBACK";
    case HRBFNPR_STATUS_INTERNAL: return "INTERNAL";
    default: return "UNKNOWN";
    }
}

hrbfnpr_status hrbfnpr_error_init(hrbfnpr_error* error, uint32_t struct_size) {
    if (error == nullptr) return HRBFNPR_STATUS_INVALID_ARGUMENT;
    if (struct_size < sizeof(hrbfnpr_error)) return HRBFNPR_STATUS_UNSUPPORTED_STRUCT;
    std::memset(error, 0, sizeof *error);
    error->struct_size = struct_size;
    return HRBFNPR_STATUS_OK;
}

} // extern "C"
